// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matching_options.hpp"

namespace stereo {

/// One hardware configuration of the block-matching core. Every block is a template over a `StereoConfig`; the named
/// ones are in configurations.hpp.
struct StereoConfig {
   int width_px;              ///< image width W, 8 ... 4096
   int height_px;             ///< image height H, window_px ... 4096, a multiple of pixels_per_clock
   int disparities;           ///< disparity range D: 0 <= d < D, 2 ... 256 and below width_px
   int window_px = 3;         ///< side B of the square matching window: 2 ... 31, odd or even
   int pixels_per_clock = 1;  ///< P pixel pairs of one column in P neighbouring rows enter at once: 1, 2 or 4

   // The algorithm: docs/algorithm.md.
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   Reference reference = Reference::right;
   Cost cost = Cost::sad;
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63; filtered pixels are 0 ... 2*cap
   Ties ties = Ties::smallest;
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities; -1: no check
   int uniqueness_percent = 0;     ///< 0 ... 100; 0: no check
   int texture_threshold = 0;      ///< 0: no check
   bool subpixel = false;          ///< disparities in sixteenths of a pixel
   bool median = false;            ///< median of 3x3 disparities

   // Pipelining and structure. None of it changes a result; docs/features.md shows what each costs and gives.
   Aggregation aggregation = Aggregation::direct;
   int slice_disparities = 25;  ///< disparities between two registers of the chain that carries the pixels, at least 2
   int cost_clocks = 3;   ///< of direct SAD sums, 1: all in one clock; 2: differences apart; 3: each addition apart
   int winner_group = 2;  ///< candidates that one clock of the winner-take-all tree compares: 2 ... 16

   constexpr bool has_left_right_check() const { return left_right_threshold >= 0; }
   constexpr bool has_uniqueness_check() const { return uniqueness_percent > 0; }
   constexpr bool has_texture_check() const { return texture_threshold > 0; }

   // The window around (x,y) covers the rows y-rows_above() ... y+rows_below(), and as many columns: with a left
   // reference mirrored.
   constexpr int rows_above() const { return window_px / 2; }
   constexpr int rows_below() const { return (window_px - 1) / 2; }
   /// Columns of a window that come in after its centre's.
   constexpr int columns_after() const { return reference == Reference::right ? rows_below() : rows_above(); }

   // The images meet with an offset: when column t of the image that is ahead comes in, the cost column of the
   // reference's column t - reference_delay() is complete.
   constexpr int reference_delay() const { return at_least_0(reference_offset()); }
   /// Columns by which the other image, the one that is searched, is held back.
   constexpr int search_delay() const { return at_least_0(-reference_offset()); }
   /// The column with which the first cost column of a row is complete.
   constexpr int first_cost_column() const { return larger(reference_delay(), disparities - 1 + search_delay()); }
   constexpr int cost_columns() const { return width_px - first_cost_column(); }
   /// Disparity maps are as wide as there are cost columns, but for the last one (Ambrosch et al., section 4).
   constexpr int output_width_px() const { return cost_columns() - 1; }
   constexpr int output_height_px() const { return height_px; }
   /// Column of the reference image of the map's first column.
   constexpr int output_first_column() const {
      return first_cost_column() - reference_delay() + (reference == Reference::left ? 1 : 0);
   }

   /// Largest cost of one pair of pixels.
   constexpr int largest_pixel_cost() const {
      const int largest_difference = prefilter == Prefilter::xsobel ? 2 * prefilter_cap : 255;
      return cost == Cost::census ? census_width_px * census_height_px - 1
             : cost == Cost::ssd  ? largest_difference * largest_difference
                                  : largest_difference;
   }
   constexpr int largest_column_cost() const { return largest_pixel_cost() * window_px; }
   constexpr int largest_window_cost() const { return largest_column_cost() * window_px; }
   /// Bits of one disparity in the hardware's output word.
   constexpr int disparity_bits() const { return subpixel ? 16 : 8; }
   /// Disparities of the largest slice: a rest of one joins the slice before it, as a tree compares at least two.
   constexpr int largest_slice() const {
      if (disparities <= slice_disparities + 1) return disparities;
      return disparities % slice_disparities == 1 ? slice_disparities + 1 : slice_disparities;
   }

   // Rows travel in groups of P. The windows of a group are complete when the rows below it have come, that is
   // delay_groups later.
   constexpr int row_groups() const { return height_px / pixels_per_clock; }
   constexpr int delay_groups() const { return (rows_below() + pixels_per_clock - 1) / pixels_per_clock; }
   /// Rows from the highest that the windows of one group need. Recursive sums need the row that leaves the windows.
   constexpr int top_row() const { return -rows_above() - (aggregation == Aggregation::recursive ? 1 : 0); }
   /// Rows that line memories must keep; the rows after them have just come in.
   constexpr int stored_rows() const { return delay_groups() * pixels_per_clock - top_row(); }
   /// Rows whose pixels are compared. Direct: all that the windows cover. Recursive: P that leave and P that enter.
   constexpr int tap_rows() const {
      return aggregation == Aggregation::recursive ? 2 * pixels_per_clock : pixels_per_clock + window_px - 1;
   }
   /// Row of tap t, counted from top_row().
   constexpr int tap_row(int t) const {
      return aggregation == Aggregation::recursive && t >= pixels_per_clock ? window_px + t - pixels_per_clock : t;
   }

   /// Bits of what is compared: of a grey value, a filtered pixel or a census transform.
   constexpr int feature_bits() const {
      return cost == Cost::census ? census_width_px * census_height_px - 1 : prefilter == Prefilter::xsobel ? 7 : 8;
   }
   constexpr bool has_transform() const { return cost == Cost::census || prefilter != Prefilter::none; }
   // Rows and columns on each side of a pixel that its transform needs, and groups of rows that it waits for.
   constexpr int transform_rows() const { return cost == Cost::census ? census_height_px / 2 : 1; }
   constexpr int transform_columns() const { return cost == Cost::census ? census_width_px / 2 : 1; }
   constexpr int transform_groups() const { return (transform_rows() + pixels_per_clock - 1) / pixels_per_clock; }

   /// Valid groups of pixels, from the first of a frame on, that bring out its first disparities: the last of them
   /// does.
   constexpr int groups_to_first_output() const {
      const int transform = has_transform() ? transform_groups() * width_px + transform_columns() : 0;
      const int check = has_left_right_check() ? disparities - 1 : 0;
      const int smoothing = median ? width_px + 1 : 0;
      const int first_column = first_cost_column() + (reference == Reference::left ? 1 : 0);
      return transform + delay_groups() * width_px + first_column + columns_after() + check + smoothing + 1;
   }
   /// Valid groups without start of frame that bring out the last disparities of a frame. A window without rows below
   /// its centre can need none.
   constexpr int flush_groups() const {
      const int groups_to_last_output =
          groups_to_first_output() + (row_groups() - 1) * width_px + output_width_px() - 1;
      return at_least_0(groups_to_last_output - row_groups() * width_px);
   }
   /// Whole rows of groups that must stand between two frames. Recursive sums of a frame's last rows and of the next
   /// one's first rows would need the same memory at once.
   constexpr int gap_groups() const { return aggregation == Aggregation::recursive ? delay_groups() * width_px : 0; }

  private:
   static constexpr int at_least_0(int value) { return value < 0 ? 0 : value; }
   static constexpr int larger(int a, int b) { return a < b ? b : a; }
   /// Columns by which the reference must lag behind the searched image, for the newest searched pixel to be the match
   /// at one end of the disparity range.
   constexpr int reference_offset() const {
      return reference == Reference::right ? disparities - 1 + min_disparity : -min_disparity;
   }
};

/// Refuses, with a sentence, what the blocks cannot build. Each block relies on it instead of repeating it.
template <const StereoConfig& C>
struct CheckedConfig {
   static_assert(C.width_px >= 8 && C.width_px <= 4096, "the image width must be 8 ... 4096 pixels");
   static_assert(C.window_px >= 2 && C.window_px <= 31, "the matching window must be 2x2 ... 31x31 pixels");
   static_assert(C.height_px >= C.window_px && C.height_px <= 4096,
                 "the image height must be window_px ... 4096 pixels");
   static_assert(C.disparities >= 2 && C.disparities <= 256, "the disparity range must be 2 ... 256");
   static_assert(C.width_px > C.disparities, "the image must be wider than the disparity range");
   static_assert(C.cost_columns() >= 2, "the disparity range lies outside the image");
   static_assert(C.first_cost_column() >= C.window_px / 2, "the disparity range must exceed the window's radius");
   static_assert(C.pixels_per_clock == 1 || C.pixels_per_clock == 2 || C.pixels_per_clock == 4,
                 "1, 2 or 4 pixel pairs can enter in a clock");
   static_assert(C.height_px % C.pixels_per_clock == 0, "the image height must be a multiple of the pixels per clock");
   static_assert(C.row_groups() > C.delay_groups(), "the image must be higher than the rows that a window waits for");
   static_assert(!C.has_transform() || C.row_groups() > C.transform_groups(),
                 "the image must be higher than the rows that a transform waits for");
   static_assert(!C.median || C.row_groups() > 1, "the image must be higher than the row that a median waits for");
   static_assert(C.census_width_px >= 3 && C.census_width_px <= 9 && C.census_width_px % 2 == 1 &&
                     C.census_height_px >= 3 && C.census_height_px <= 7 && C.census_height_px % 2 == 1,
                 "the census window must be 3 ... 9 pixels wide and 3 ... 7 high, both odd");
   static_assert(C.prefilter_cap >= 1 && C.prefilter_cap <= 63, "the prefilter's cap must be 1 ... 63");
   static_assert(C.cost != Cost::census || C.prefilter == Prefilter::none, "the census transform takes no prefilter");
   static_assert(C.left_right_threshold >= -1 && C.left_right_threshold < C.disparities,
                 "the left/right threshold must be -1 ... disparities - 1");
   static_assert(C.uniqueness_percent >= 0 && C.uniqueness_percent <= 100, "the uniqueness must be 0 ... 100 percent");
   static_assert(!C.has_uniqueness_check() || C.largest_window_cost() < (1 << 24),
                 "with a uniqueness check window costs must stay below 2^24");
   static_assert(!C.has_texture_check() || C.prefilter == Prefilter::xsobel, "the texture check needs the prefilter");
   static_assert(C.texture_threshold >= 0 && C.texture_threshold <= C.prefilter_cap * C.window_px * C.window_px,
                 "the texture threshold must be 0 ... the largest texture of a window");
   static_assert(C.slice_disparities >= 2, "a slice must hold at least 2 disparities");
   static_assert(C.cost_clocks >= 1 && C.cost_clocks <= 3, "the cost must take 1, 2 or 3 clocks");
   static_assert(C.winner_group >= 2 && C.winner_group <= 16, "the winner group must have 2 ... 16 candidates");
   static_assert(C.largest_window_cost() < (1 << 26), "window costs must stay below 2^26");
   static constexpr bool kValid = true;
};

}  // namespace stereo
