// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/matching_input.hpp"

#include <stdexcept>

#include "definition/pixel_range.hpp"

namespace stereo::dynamic_range {

namespace {

void require(bool condition, const std::string& sentence) {
   if (!condition) throw std::invalid_argument(sentence);
}

template <class Image>
void check_input(const Image& left, const Image& right, const Matching& matching) {
   const Sentence problem = matching.problem();
   require(problem.empty(), problem.text);
   require(left.width == right.width && left.height == right.height, "left and right image differ in size");
   require(left.height >= Matching::kBlock,
           "the image height is " + std::to_string(left.height) + " but must be at least 8");
   require(left.width > matching.disparities, "the image width is " + std::to_string(left.width) +
                                                  " but must exceed the disparity range " +
                                                  std::to_string(matching.disparities));
}

void check_range(const std::string& name, const DeepImage& image, int bits) {
   const std::string problem = beyond_range(image, bits);
   require(problem.empty(), "the " + name + " image " + problem);
}

}  // namespace

void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   check_input(left, right, matching);
}
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   check_input(left, right, matching);
   check_range("left", left, matching.pixel_bits);
   check_range("right", right, matching.pixel_bits);
}

MapGeometry map_geometry(const Matching& matching, int image_width) {
   return {.reference = Reference::right,
           .first_column = 0,
           .width = image_width - matching.window_disparities,
           .disparities = matching.disparities,
           .min_disparity = 0,
           .has_check = matching.has_check()};
}

std::string describe(const Matching& matching) {
   const std::string side = std::to_string(matching.window_px);
   return std::to_string(matching.disparities) + " disparities by two windows of " +
          std::to_string(matching.window_disparities) + ", window " + side + "x" + side +
          (matching.codes == Codes::census ? ", census " + std::to_string(matching.census_width_px) + "x" +
                                                 std::to_string(matching.census_height_px)
                                           : ", phase of " + std::to_string(matching.phase_scales) +
                                                 (matching.phase_scales == 1 ? " scale" : " scales"));
}

}  // namespace stereo::dynamic_range
