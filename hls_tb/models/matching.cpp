// SPDX-License-Identifier: Apache-2.0
#include "models/matching.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace stereo {
namespace {

constexpr int kFarthest = 1 << 24;  ///< beyond any image, and far from where sums of columns would overflow

void require(bool condition, const std::string& sentence) {
   if (!condition) throw std::invalid_argument(sentence);
}

void require_range(const std::string& what, int value, int64_t low, int64_t high) {
   require(value >= low && value <= high, what + " is " + std::to_string(value) + " but must be " +
                                              std::to_string(low) + " ... " + std::to_string(high));
}

void check_pair(const GrayImage& left, const GrayImage& right) {
   require_same_size<std::invalid_argument>("left", left, "right", right);
   require(left.width > 0 && left.height > 0, "the images have no pixels");
}

void check_options(const MatchingParameters& p) {
   require_range("the disparity range", p.disparities, 1, 256);
   require(p.window_px >= 1, "the window side is " + std::to_string(p.window_px) + " but must be positive");
   require_range("the census window's width", p.census_width_px, 3, 9);
   require_range("the census window's height", p.census_height_px, 3, 7);
   require(p.census_width_px % 2 == 1 && p.census_height_px % 2 == 1,
           "the census window is " + size_text(p.census_width_px, p.census_height_px) + " but both sides must be odd");
   require_range("the prefilter's cap", p.prefilter_cap, 1, 63);
   require(p.cost != Cost::census || p.prefilter == Prefilter::none, "the census transform takes no prefilter");
   require_range("the left/right threshold", p.left_right_threshold, -1, p.disparities - 1);
   require_range("the uniqueness in percent", p.uniqueness_percent, 0, 100);
   require(!p.has_texture_check() || p.prefilter == Prefilter::xsobel, "the texture check needs the prefilter");
   const int64_t side = std::min(p.window_px, kFarthest);
   if (p.prefilter == Prefilter::xsobel)
      require_range("the texture threshold", p.texture_threshold, 0, p.prefilter_cap * side * side);
   require_range("the texture threshold", p.texture_threshold, 0, std::numeric_limits<int>::max());
}

}  // namespace

int MatchingParameters::largest_pixel_cost() const {
   if (cost == Cost::census) return census_width_px * census_height_px - 1;
   const int largest_difference = prefilter == Prefilter::xsobel ? 2 * prefilter_cap : 255;
   return cost == Cost::ssd ? largest_difference * largest_difference : largest_difference;
}

int first_cost_column(const MatchingParameters& parameters) { return std::max(0, -parameters.min_disparity); }

int cost_columns(int width_px, const MatchingParameters& parameters) {
   const int last = std::min(width_px - 1, width_px - parameters.disparities - parameters.min_disparity);
   return last - first_cost_column(parameters) + 1;
}

int map_width(int width_px, const MatchingParameters& parameters) { return cost_columns(width_px, parameters) - 1; }

int map_first_column(const MatchingParameters& parameters) {
   return parameters.reference == Reference::right ? first_cost_column(parameters)
                                                   : std::max(1, parameters.disparities + parameters.min_disparity);
}

void check_matching_input(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters) {
   check_pair(left, right);
   check_options(parameters);
   const std::string disparities = std::to_string(parameters.disparities);
   require(left.width > parameters.disparities,
           "the images are " + size_text(left) + " but must be wider than the disparity range " + disparities);
   const bool near = std::abs(int64_t(parameters.min_disparity)) <= kFarthest;
   require(near && cost_columns(left.width, parameters) >= 2,
           "the disparity range " + disparities + " from the smallest disparity " +
               std::to_string(parameters.min_disparity) + " on lies outside the images of " + size_text(left));
   const int64_t window_pixels = int64_t(std::min(parameters.window_px, cost_columns(left.width, parameters))) *
                                 std::min(parameters.window_px, left.height);
   require(window_pixels * parameters.largest_pixel_cost() <= std::numeric_limits<int>::max(),
           "the window side is " + std::to_string(parameters.window_px) +
               " but window costs must stay below 2^31; give a smaller window");
}

}  // namespace stereo
