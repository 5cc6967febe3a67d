// SPDX-License-Identifier: Apache-2.0
// What follows from the options of block matching and the size of the images, by definition (docs/algorithm.md). The
// hardware derives its own numbers (hls/block_matching/config.hpp).
#pragma once

#include <stdexcept>
#include <string>

#include "block_matching/matching.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::block_matching {

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these options. Images that pass
/// have 2 cost columns or more, and window costs below 2^31.
void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching);
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching);

// The window around (x,y) covers the rows y-rows_above() ... y+rows_below(), and as many columns.
constexpr int rows_above(const Matching& matching) { return matching.window_px / 2; }
constexpr int rows_below(const Matching& matching) { return (matching.window_px - 1) / 2; }

/// Largest cost of one pair of pixels.
int largest_pixel_cost(const Matching& matching);
/// The first cost column, for the right image as reference; with a left reference, of the mirrored pair.
int first_cost_column(const Matching& matching);
/// How many columns there are at which the whole range of disparities fits; below 1 when there are none.
int whole_columns(int width_px, const Matching& matching);
/// How many cost columns images of this width have; below 1 when there are none.
int cost_columns(int width_px, const Matching& matching);
/// Width of the disparity map: that of the cost columns but for one, or with full_width of the windows in the image.
int map_width(int width_px, const Matching& matching);
/// The disparities first ... last that are searched in a column of a map of this width; none where last < first. For
/// the right image as reference.
struct SearchedRange {
   int first, last;
};
SearchedRange searched_range(int x, int width, const Matching& matching);
/// Column of the reference image at which the map's column 0 stands.
int map_first_column(const Matching& matching);
MapGeometry map_geometry(const Matching& matching, int image_width);

/// Such as "100 disparities, window 3x3".
std::string describe(const Matching& matching);

}  // namespace stereo::block_matching
