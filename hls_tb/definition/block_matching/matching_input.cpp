// SPDX-License-Identifier: Apache-2.0
#include "definition/block_matching/matching_input.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "definition/pixel_range.hpp"

namespace stereo::block_matching {
namespace {

void require(bool condition, const std::string& sentence) {
   if (!condition) throw std::invalid_argument(sentence);
}

template <class Pixel>
void check_pair(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right) {
   require_same_size<std::invalid_argument>("left", left, "right", right);
   require(left.width > 0 && left.height > 0, "the images have no pixels");
}

}  // namespace

int largest_pixel_cost(const Matching& matching) {
   if (matching.cost == Cost::census)
      return census_bits(matching.census_width_px, matching.census_height_px, matching.census_pattern);
   const int largest_difference =
       matching.prefilter == Prefilter::xsobel ? 2 * matching.prefilter_cap : (1 << matching.pixel_bits) - 1;
   return matching.cost == Cost::ssd ? largest_difference * largest_difference : largest_difference;
}

int first_cost_column(const Matching& matching) {
   return matching.full_width ? 0 : std::max(0, -matching.min_disparity);
}

int whole_columns(int width_px, const Matching& matching) {
   const int last = std::min(width_px - 1, width_px - matching.disparities - matching.min_disparity);
   return last - std::max(0, -matching.min_disparity) + 1;
}

int cost_columns(int width_px, const Matching& matching) {
   return matching.full_width ? width_px : whole_columns(width_px, matching);
}

int map_width(int width_px, const Matching& matching) {
   return cost_columns(width_px, matching) - (matching.full_width ? matching.window_px - 1 : 1);
}

SearchedRange searched_range(int x, int width, const Matching& matching) {
   if (!matching.full_width) return {0, matching.disparities - 1};
   const int first = x + matching.min_disparity;  // where disparity 0 leads to
   return {std::max(matching.first_disparity, -first), std::min(matching.last_searched(), width - 1 - first)};
}

int map_first_column(const Matching& matching) {
   if (matching.full_width) return matching.reference == Reference::right ? rows_above(matching) : rows_below(matching);
   return matching.reference == Reference::right ? first_cost_column(matching)
                                                 : std::max(1, matching.disparities + matching.min_disparity);
}

MapGeometry map_geometry(const Matching& matching, int image_width) {
   return {matching.reference,   map_first_column(matching), map_width(image_width, matching),
           matching.disparities, matching.min_disparity,     matching.has_check()};
}

std::string describe(const Matching& matching) {
   return std::to_string(matching.disparities) + " disparities, window " +
          size_text(matching.window_px, matching.window_px);
}

namespace {

template <class Pixel>
void check_input(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching) {
   check_pair(left, right);
   const Sentence problem = matching.problem();
   require(problem.empty(), problem.text);
   const std::string disparities = std::to_string(matching.disparities);
   require(left.width > matching.disparities,
           "the images are " + size_text(left) + " but must be wider than the disparity range " + disparities);
   require(whole_columns(left.width, matching) >= 2,
           "the disparity range " + disparities + " from the smallest disparity " +
               std::to_string(matching.min_disparity) + " on lies outside the images of " + size_text(left));
   require(!matching.full_width || left.width > matching.window_px,
           "the images are " + size_text(left) + " but must be wider than the window for a map of full width");
   const int64_t window_pixels = int64_t(std::min(matching.window_px, cost_columns(left.width, matching))) *
                                 std::min(matching.window_px, left.height);
   require(window_pixels * largest_pixel_cost(matching) <= std::numeric_limits<int>::max(),
           "the window side is " + std::to_string(matching.window_px) +
               " but window costs must stay below 2^31; give a smaller window");
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

}  // namespace stereo::block_matching
