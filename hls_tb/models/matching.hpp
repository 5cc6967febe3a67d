// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matching_options.hpp"
#include "models/disparity_map.hpp"
#include "models/gray_image.hpp"

namespace stereo {

/// What a block matcher must know beside the images: docs/algorithm.md defines each option. Names and defaults are
/// those of StereoConfig; images and windows may have any size.
struct MatchingParameters {
   int disparities;        ///< disparity range D: 0 <= d < D, 1 ... 256 and below the image width
   int window_px = 3;      ///< side B of the square window, 1 or more, odd or even
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   Reference reference = Reference::right;
   Cost cost = Cost::sad;
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63; filtered pixels are 0 ... 2*cap
   Ties ties = Ties::smallest;
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities, below D; -1: no check
   int uniqueness_percent = 0;     ///< 0 ... 100; 0: no check
   int texture_threshold = 0;      ///< 0 ... prefilter_cap * window_px^2; 0: no check
   bool subpixel = false;          ///< disparities in sixteenths of a pixel
   bool median = false;            ///< median of 3x3 disparities

   bool has_left_right_check() const { return left_right_threshold >= 0; }
   bool has_uniqueness_check() const { return uniqueness_percent > 0; }
   bool has_texture_check() const { return texture_threshold > 0; }
   /// Any of them: without one every pixel is valid.
   bool has_check() const { return has_left_right_check() || has_uniqueness_check() || has_texture_check(); }

   // The window around (x,y) covers the rows y-rows_above() ... y+rows_below(), and as many columns.
   int rows_above() const { return window_px / 2; }
   int rows_below() const { return (window_px - 1) / 2; }

   /// Largest cost of one pair of pixels.
   int largest_pixel_cost() const;
};

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these parameters. Images that
/// pass have 2 cost columns or more, and window costs below 2^31.
void check_matching_input(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters);

/// The first cost column, for the right image as reference; with a left reference, of the mirrored pair.
int first_cost_column(const MatchingParameters& parameters);
/// How many cost columns images of this width have; below 1 when there are none.
int cost_columns(int width_px, const MatchingParameters& parameters);
/// Width of the disparity map: that of the cost columns but for one.
int map_width(int width_px, const MatchingParameters& parameters);
/// Column of the reference image at which the map's column 0 stands.
int map_first_column(const MatchingParameters& parameters);

}  // namespace stereo
