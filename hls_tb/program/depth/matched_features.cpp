// SPDX-License-Identifier: Apache-2.0
#include "program/depth/matched_features.hpp"

#include <algorithm>
#include <opencv2/features2d.hpp>

#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

constexpr int kSmallestSide = 96;       ///< pixels; ORB needs a border of 31 around each feature
constexpr int kFeatures = 1000;         ///< looked for in each image
constexpr std::size_t kFewest = 25;     ///< matches that can say something
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

}  // namespace

std::vector<FeatureOffset> matched_features(const ImagePair& pair) {
   if (std::min(pair.left.width, pair.left.height) < kSmallestSide) return {};
   const Features left = features_of(pair.left), right = features_of(pair.right);
   if (left.points.size() < 2 || right.points.size() < 2) return {};
   std::vector<std::vector<cv::DMatch>> candidates;
   cv::BFMatcher(cv::NORM_HAMMING).knnMatch(left.descriptors, right.descriptors, candidates, 2);
   std::vector<FeatureOffset> offsets;
   for (const std::vector<cv::DMatch>& best : candidates) {
      if (best.size() < 2 || best[0].distance > kLargestDistance || best[0].distance > kLargestRatio * best[1].distance)
         continue;
      const cv::KeyPoint &a = left.points[std::size_t(best[0].queryIdx)],
                         &b = right.points[std::size_t(best[0].trainIdx)];
      if (a.octave < kFinestScales && b.octave < kFinestScales)
         offsets.push_back({double(a.pt.x) - double(b.pt.x), double(a.pt.y) - double(b.pt.y)});
   }
   if (offsets.size() < kFewest) offsets.clear();
   return offsets;
}

}  // namespace stereo::app
