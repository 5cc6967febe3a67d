// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/masks.hpp"

#include <limits>
#include <opencv2/imgproc.hpp>

#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

/// The truth, with `unknown` where there is none.
cv::Mat_<float> filled(const DisparityImage& truth, float unknown) {
   cv::Mat_<float> mat(truth.height, truth.width);
   for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x) mat(y, x) = has_disparity(truth.at(x, y)) ? truth.at(x, y) : unknown;
   return mat;
}

cv::Mat square(int side) { return cv::Mat::ones(side, side, CV_8U); }

GrayImage known_inside(const DisparityImage& truth, int border) {
   GrayImage mask(truth.width, truth.height);
   for (int y = border; y < truth.height - border; ++y)
      for (int x = border; x < truth.width - border; ++x) mask.at(x, y) = has_disparity(truth.at(x, y)) ? 255 : 0;
   return mask;
}

GrayImage both(GrayImage mask, const GrayImage& other) {
   for (std::size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] &= other.pixels[i];
   return mask;
}

}  // namespace

GrayImage non_occluded_mask(const DisparityImage& truth, const DisparityImage& other, Reference side) {
   const int toward_the_match = side == Reference::left ? -1 : 1;
   GrayImage mask(truth.width, truth.height);
   for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x) {
         const float disparity = truth.at(x, y);
         if (!has_disparity(disparity)) continue;
         const int match = x + toward_the_match * int(std::nearbyint(disparity));
         if (match < 0 || match >= other.width) continue;
         const float there = other.at(match, y);
         if (has_disparity(there) && there <= disparity + kOcclusionThreshold) mask.at(x, y) = 255;
      }
   return mask;
}

GrayImage searchable_mask(const GrayImage& visible, DisparityRange range, Reference side) {
   GrayImage mask = visible;
   const int toward_the_match = side == Reference::left ? -1 : 1;
   const auto inside = [&](int x, int disparity) {
      const int match = x + toward_the_match * disparity;
      return match >= 0 && match < mask.width;
   };
   for (int x = 0; x < mask.width; ++x)
      if (!inside(x, range.first) || !inside(x, range.first + range.count))
         for (int y = 0; y < mask.height; ++y) mask.at(x, y) = 0;
   return mask;
}

GrayImage discontinuity_mask(const DisparityImage& truth) {
   constexpr float kLowest = std::numeric_limits<float>::lowest(), kLargest = std::numeric_limits<float>::max();
   cv::Mat largest, smallest;
   cv::dilate(filled(truth, kLowest), largest, square(3));
   cv::erode(filled(truth, kLargest), smallest, square(3));
   cv::Mat mask(truth.height, truth.width, CV_8U, cv::Scalar(0));
   for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x) {
         const float here = truth.at(x, y);
         if (!has_disparity(here)) continue;
         const bool step =
             largest.at<float>(y, x) - here > kDiscontinuityGap || here - smallest.at<float>(y, x) > kDiscontinuityGap;
         mask.at<uint8_t>(y, x) = step ? 255 : 0;
      }
   cv::dilate(mask, mask, square(kDiscontinuityWidth));
   return from_mat(mask);
}

GrayImage textureless_mask(const GrayImage& image) {
   GrayImage copy = image;
   cv::Mat gradient, mean;
   cv::Sobel(as_mat(copy), gradient, CV_32F, 1, 0, 3);
   gradient /= 8;
   cv::boxFilter(gradient.mul(gradient), mean, CV_32F, {kTexturelessWidth, kTexturelessWidth});
   return from_mat(mean < kTexturelessThreshold);
}

std::vector<NamedMask> evaluation_masks(const GrayImage& image, const DisparityImage& truth,
                                        const DisparityImage* other, Reference side, int border_px) {
   const GrayImage all = known_inside(truth, border_px);
   const auto [all_name, visible_name, searchable_name, discontinuity_name, textureless_name] = kMaskNames;
   if (other == nullptr) return {{all_name, all}};
   const GrayImage visible = both(non_occluded_mask(truth, *other, side), all);
   return {{all_name, all},
           {visible_name, visible},
           {discontinuity_name, both(discontinuity_mask(truth), visible)},
           {textureless_name, both(textureless_mask(image), visible)}};
}

}  // namespace stereo::app
