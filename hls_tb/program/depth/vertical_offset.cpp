// SPDX-License-Identifier: Apache-2.0
#include "program/depth/vertical_offset.hpp"

#include <algorithm>
#include <iomanip>
#include <opencv2/features2d.hpp>
#include <sstream>

#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

constexpr int kSmallestSide = 96;       ///< pixels; ORB needs a border of 31 around each feature
constexpr int kFeatures = 1000;         ///< looked for in each image
constexpr int kFewest = 25;             ///< matches that can say something
constexpr int kFinestScales = 3;        ///< each coarser by 1.2
constexpr float kLargestRatio = 0.8F;   ///< of the best to the second best distance (Lowe)
constexpr float kLargestDistance = 64;  ///< of the 256 bits of a descriptor

struct Features {
   std::vector<cv::KeyPoint> points;
   cv::Mat descriptors;
};

Features features_of(const GrayImage& image) {
   GrayImage copy = image;
   Features found;
   cv::ORB::create(kFeatures)->detectAndCompute(as_mat(copy), cv::noArray(), found.points, found.descriptors);
   return found;
}

/// How many rows apart each pair of features is.
std::vector<double> row_differences(const Features& left, const Features& right) {
   std::vector<std::vector<cv::DMatch>> candidates;
   cv::BFMatcher(cv::NORM_HAMMING).knnMatch(left.descriptors, right.descriptors, candidates, 2);
   std::vector<double> differences;
   for (const std::vector<cv::DMatch>& best : candidates) {
      if (best.size() < 2 || best[0].distance > kLargestDistance || best[0].distance > kLargestRatio * best[1].distance)
         continue;
      const cv::KeyPoint &a = left.points[std::size_t(best[0].queryIdx)],
                         &b = right.points[std::size_t(best[0].trainIdx)];
      if (a.octave < kFinestScales && b.octave < kFinestScales)
         differences.push_back(std::abs(double(a.pt.y) - double(b.pt.y)));
   }
   return differences;
}

}  // namespace

std::optional<VerticalOffset> vertical_offset(const ImagePair& pair) {
   if (std::min(pair.left.width, pair.left.height) < kSmallestSide) return std::nullopt;
   const Features left = features_of(pair.left), right = features_of(pair.right);
   if (left.points.size() < 2 || right.points.size() < 2) return std::nullopt;
   std::vector<double> differences = row_differences(left, right);
   if (int(differences.size()) < kFewest) return std::nullopt;
   const auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
   std::nth_element(differences.begin(), middle, differences.end());
   return VerticalOffset{*middle, int(differences.size())};
}

std::string rectification_warning(const ImagePair& pair) {
   const std::optional<VerticalOffset> offset = vertical_offset(pair);
   if (!offset || offset->median_px <= kLargestVerticalOffset) return "";
   std::ostringstream text;
   text << "warning: the images do not look rectified: " << offset->features << " matching features lie " << std::fixed
        << std::setprecision(1) << offset->median_px
        << " rows apart (median), and block matching only looks along a row\n";
   return text.str();
}

}  // namespace stereo::app
