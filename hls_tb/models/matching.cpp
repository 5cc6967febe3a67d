// SPDX-License-Identifier: Apache-2.0
#include "models/matching.hpp"

#include <stdexcept>
#include <string>

namespace stereo {
namespace {

void require(bool condition, const std::string& sentence) {
   if (!condition) throw std::invalid_argument(sentence);
}

std::string size_text(const GrayImage& image) {
   return std::to_string(image.width) + "x" + std::to_string(image.height);
}

}  // namespace

void check_matching_input(const GrayImage& left, const GrayImage& right, MatchingParameters parameters) {
   const std::string disparities = std::to_string(parameters.disparities);
   const std::string window = std::to_string(parameters.window_px);
   require(left.same_size(right), "the images differ in size: left is " + size_text(left) + ", right is " +
                                      size_text(right) + "; give a rectified pair of one size");
   require(left.width > 0 && left.height > 0, "the images have no pixels");
   require(parameters.disparities >= 1 && parameters.disparities <= 256,
           "the disparity range is " + disparities + " but must be 1 ... 256");
   require(parameters.window_px >= 1 && parameters.window_px % 2 == 1,
           "the window side is " + window + " but must be odd and positive");
   require(left.width > parameters.disparities,
           "the images are " + size_text(left) + " but must be wider than the disparity range " + disparities);
}

}  // namespace stereo
