// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "postprocessing/limits.hpp"
#include "support/image.hpp"
#include "support/structure_groups.hpp"

namespace stereo::block_matching {

struct CostSteps {
   int cost_clocks = 3;       ///< of direct SAD sums, 1: all in one clock; 2: differences apart; 3: each addition apart
   bool sign_memory = false;  ///< of direct SAD sums in 3 clocks: remember which pixel of a pair is the larger one

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("cost_clocks", self.cost_clocks, 1, 3, "the number of clocks of the cost");
      visit("sign_memory", self.sign_memory);
   }
};

/// How the core is built; docs/features.md shows what each option costs and gives.
struct Structure : OptionGroups<Summation, SliceSize, CostSteps, WinnerGroup, Folding, RunTime> {
   using OptionGroups::OptionGroups;
};

/// One hardware configuration of the block-matching core. Every block is a template over one; the named ones are in
/// configurations.hpp.
struct Config : Image, Matching, Structure {
   // The window around (x,y) covers the rows y-rows_above() ... y+rows_below(), and as many columns: with a left
   // reference mirrored.
   constexpr int rows_above() const { return window_px / 2; }
   constexpr int rows_below() const { return (window_px - 1) / 2; }
   /// Columns of a window that come in before and after its centre's.
   constexpr int columns_before() const { return window_px - 1 - columns_after(); }
   constexpr int columns_after() const { return reference == Reference::right ? rows_below() : rows_above(); }

   // The images meet with an offset: when column t of the image that is ahead comes in, the cost column of the
   // reference's column t - reference_delay() is complete.
   constexpr int reference_delay() const { return at_least_0(reference_offset()); }
   /// Columns by which the other image, the one that is searched, is held back.
   constexpr int search_delay() const { return at_least_0(-reference_offset()); }
   /// The column with which the first column of a row at which all disparities fit is complete.
   constexpr int first_whole_column() const { return larger(reference_delay(), disparities - 1 + search_delay()); }
   /// The column with which the first cost column of a row is complete. With full_width every column of the reference
   /// is one; the last reference_delay() of a row come with the first columns of the next one.
   constexpr int first_cost_column() const { return full_width ? reference_delay() : first_whole_column(); }
   constexpr int cost_columns() const { return full_width ? width_px : width_px - first_cost_column(); }
   /// The column with which the first window centre of a row that belongs to the map is there: the map leaves out the
   /// last cost column of the right, the first one of the left reference. With full_width it has the windows that lie
   /// in the image.
   constexpr int first_map_column() const {
      return first_cost_column() + (full_width ? columns_before() : reference == Reference::left ? 1 : 0);
   }
   /// Disparity maps are as wide as there are cost columns, but for the last one (Ambrosch et al., section 4).
   constexpr int output_width_px() const { return cost_columns() - (full_width ? window_px - 1 : 1); }
   constexpr int output_height_px() const { return height_px; }
   /// Column of the reference image of the map's first column.
   constexpr int output_first_column() const { return first_map_column() - reference_delay(); }

   /// Largest cost of one pair of pixels.
   constexpr int largest_pixel_cost() const {
      const int largest_difference = prefilter == Prefilter::xsobel ? 2 * prefilter_cap : largest_pixel();
      return cost == Cost::census ? census_bits(census_width_px, census_height_px, census_pattern)
             : cost == Cost::ssd  ? largest_difference * largest_difference
                                  : largest_difference;
   }
   constexpr int largest_column_cost() const { return largest_pixel_cost() * window_px; }
   constexpr int largest_window_cost() const { return largest_column_cost() * window_px; }
   /// Bits of one row in the hardware's output word (LaneLayout).
   constexpr int disparity_bits() const { return (subpixel || fill_holes ? 16 : 8) + (confidence ? 8 : 0); }
   constexpr int steps_per_pixel() const { return subpixel ? 16 : 1; }
   /// Disparities of the first slice of so many: a rest of one joins the slice before it, as a tree compares at least
   /// two.
   constexpr int first_slice(int count) const { return count <= slice_disparities + 1 ? count : slice_disparities; }
   /// Disparities of the largest slice.
   constexpr int largest_slice() const {
      if (disparities <= slice_disparities + 1) return disparities;
      return disparities % slice_disparities == 1 ? slice_disparities + 1 : slice_disparities;
   }

   // Rows travel in groups of P. The windows of a group are complete when the rows below it have come, that is
   // delay_groups later.
   constexpr int delay_groups() const { return (rows_below() + pixels_per_clock - 1) / pixels_per_clock; }
   /// Rows from the highest that the windows of one group need. Recursive sums need the row that leaves the windows.
   constexpr int top_row() const { return -rows_above() - (aggregation == Aggregation::recursive ? 1 : 0); }
   /// Rows that line memories must keep; the rows after them have just come in.
   constexpr int stored_rows() const { return delay_groups() * pixels_per_clock - top_row(); }
   /// Rows whose pixels are compared. Direct: all that the windows cover. Recursive: P that leave and P that enter.
   constexpr int tap_rows() const {
      return aggregation == Aggregation::recursive ? 2 * pixels_per_clock : pixels_per_clock + window_px - 1;
   }
   /// Groups that must stand between two frames. Recursive sums of a frame's last rows and of the next one's first rows
   /// would need the same memory at once, so whole rows of groups stand between them; and as the next frame then does
   /// not follow at once, as many as the transform needs to give the last rows.
   constexpr int gap_groups() const {
      const int window_rows = delay_groups() * width_px, transform = transform_groups() * width_px;
      if (aggregation == Aggregation::direct || window_rows == 0) return 0;
      return has_transform() && transform > window_rows ? transform : window_rows;
   }
   /// Row of tap t, counted from top_row().
   constexpr int tap_row(int t) const {
      return aggregation == Aggregation::recursive && t >= pixels_per_clock ? window_px + t - pixels_per_clock : t;
   }

   /// Bits of what is compared: of a grey value, a filtered pixel or a census transform.
   constexpr int feature_bits() const {
      return cost == Cost::census             ? census_bits(census_width_px, census_height_px, census_pattern)
             : prefilter == Prefilter::xsobel ? pixel_bits - 1
                                              : pixel_bits;
   }
   constexpr bool remembers_signs() const {
      return sign_memory && cost == Cost::sad && aggregation == Aggregation::direct;
   }
   constexpr bool has_transform() const { return cost == Cost::census || prefilter != Prefilter::none; }
   // Rows and columns on each side of a pixel that its transform needs, and groups of rows that it waits for.
   constexpr int transform_rows() const { return cost == Cost::census ? census_height_px / 2 : 1; }
   constexpr int transform_columns() const { return cost == Cost::census ? census_width_px / 2 : 1; }
   constexpr int transform_groups() const { return (transform_rows() + pixels_per_clock - 1) / pixels_per_clock; }

   // With several clocks a pixel a row of the image is matched in as many passes (folding.hpp).
   constexpr bool is_folded() const { return clocks_per_pixel > 1; }
   constexpr int pass_disparities() const { return disparities / clocks_per_pixel; }
   /// Columns of a pass before its first cost column, which bring in the searched pixels, and behind its last one,
   /// which complete the windows. As many as a window has stand between two passes.
   constexpr int columns_before_pass() const { return larger(pass_disparities() - 1, columns_before()); }
   constexpr int pass_columns() const { return columns_before_pass() + cost_columns() + columns_after(); }
   /// With a left/right check the last pass goes on until the other image's pixels have left the lanes.
   constexpr int columns_behind_last_pass() const { return has_left_right_check() ? pass_disparities() - 1 : 0; }
   constexpr int passes_columns() const { return clocks_per_pixel * pass_columns() + columns_behind_last_pass(); }
   /// Rows by which a folded core is behind one that is not: one that is matched, and one that leaves.
   constexpr int folded_rows() const { return is_folded() ? 2 : 0; }
   /// Columns of a pass from one that asks a memory of the passes before to the first one that finds its result there.
   static constexpr int kColumnsToBest = 5, kColumnsToOther = 4;
   /// Clocks that are enough from a pass's column to its disparity.
   constexpr int clocks_to_pass_result() const { return 40 + disparities / slice_disparities; }

   /// As in Matching; ports may leave any disparity out.
   constexpr bool has_lost_pixels() const { return Matching::has_lost_pixels() || (run_time_settings && full_width); }
   constexpr bool has_check() const { return Matching::has_check() || has_lost_pixels(); }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (const Sentence sentence = Image::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      if (const Sentence limit = first_beyond_limits<Structure>(*this); !limit.empty()) return limit;
      if (window_px < 2 || window_px > 31) return "the matching window must be 2x2 ... 31x31 pixels";
      if (height_px < window_px) return "the image height must be window_px ... 4096 pixels";
      if (disparities < 2) return "the disparity range must be 2 ... 256";
      if (width_px <= disparities) return "the image must be wider than the disparity range";
      if (min_disparity < -width_px || min_disparity > width_px || width_px - first_whole_column() < 2)
         return "the disparity range lies outside the image";
      if (full_width && width_px <= window_px)
         return "with a map of full width the image must be wider than the window";
      if (!full_width && first_cost_column() < window_px / 2)
         return "the disparity range must exceed the window's radius";
      if (row_groups() <= delay_groups()) return "the image must be higher than the rows that a window waits for";
      if (sign_memory && (aggregation != Aggregation::direct || cost != Cost::sad || cost_clocks != 3 || width_px < 8 ||
                          texture_threshold > 0))
         return "a sign memory needs direct SAD sums in 3 clocks, images of at least 8 columns, and no texture check";
      if (has_transform() && row_groups() <= transform_groups())
         return "the image must be higher than the rows that a transform waits for";
      if (median && row_groups() <= 1) return "the image must be higher than the row that a median waits for";
      if (const Sentence sentence = post_processing_problem(*this); !sentence.empty()) return sentence;
      if (run_time_settings && !has_check()) return "run-time settings need a check or a map of full width";
      if (run_time_settings && !holds_settings())
         return "with run-time settings the image must be higher, for a frame's first disparity to leave before the "
                "next one";
      if (run_time_settings && has_texture_check() && int64_t(prefilter_cap) * window_px * window_px >= 1 << 16)
         return "with run-time settings prefilter_cap * window_px^2 must stay below 2^16";
      if (run_time_size && (!has_whole_windows() || row_groups() < 2))
         return "with a run-time size all disparities must fit at as many columns as the window has, and the image "
                "must have two groups of rows";
      if (run_time_size && median && output_width_px() < 2)
         return "with a run-time size and a median the map must have two columns";
      if (const Sentence sentence = folding_problem(); !sentence.empty()) return sentence;
      if (int64_t(largest_column_cost()) * window_px >= 1 << 26) return "window costs must stay below 2^26";
      if (has_uniqueness_check() && largest_window_cost() >= 1 << 24)
         return "with a uniqueness check window costs must stay below 2^24";
      if (has_confidence() && largest_window_cost() >= 1 << 24)
         return "with a confidence window costs must stay below 2^24";
      return {};
   }

   /// Groups from the start of a frame to the last one of the windows around its first pixels.
   constexpr int groups_to_first_window() const {
      const int transform = has_transform() ? transform_groups() * width_px + transform_columns() : 0;
      return transform + groups_behind_transform();
   }
   constexpr int groups_behind_transform() const {
      if (is_folded()) return (delay_groups() + folded_rows()) * width_px;
      return delay_groups() * width_px + first_map_column() + columns_after();
   }
   /// Clocks that are enough from the last group that a disparity depends on to the last check.
   constexpr int clocks_to_last_check() const { return 64 + disparities; }

  private:
   constexpr Sentence folding_problem() const {
      if (const Sentence sentence = front_problem(); !sentence.empty()) return sentence;
      if (!is_folded()) return {};
      if (disparities % clocks_per_pixel != 0) return "the clocks a pixel pair must divide the disparity range";
      if (pass_disparities() < 2)
         return "with several clocks a pixel pair two disparities or more must be left for each";
      if (pixels_per_clock > 1) return "with several clocks a pixel pair only one comes at once";
      if (sign_memory) return "with several clocks a pixel pair there is no sign memory";
      if (full_width) return "with several clocks a pixel pair there is no map of full width";
      if (run_time_size) return "with several clocks a pixel pair there is no run-time size";
      if (!passes_fit())
         return "with so many clocks a pixel pair the image must be wider for its passes to fit in a row";
      return {};
   }
   /// Whether a row's passes end before the next row is there, and the last pass is ahead of the row that leaves.
   constexpr bool passes_fit() const {
      const int other_lag = !has_left_right_check()         ? 0
                            : reference == Reference::right ? pass_disparities() - 1
                                                            : disparities - 1;
      const int to_first_result = (clocks_per_pixel - 1) * pass_columns() + columns_before_pass() + columns_after() +
                                  other_lag + clocks_to_pass_result();
      const int row_clocks = width_px * clocks_per_pixel;
      return passes_columns() <= row_clocks - 2 && to_first_result <= row_clocks && passes_are_apart();
   }
   /// Whether what a pass finds is in memory before the next pass asks for it: the best candidate of the same column
   /// (RowBest), and the best of the other image's pixel, which with a right reference is shown as many columns sooner
   /// as a pass has disparities (RowCheck).
   constexpr bool passes_are_apart() const {
      const bool shows_sooner = has_left_right_check() && reference == Reference::right;
      return pass_columns() >= kColumnsToBest &&
             (!shows_sooner || pass_columns() - pass_disparities() >= kColumnsToOther);
   }
   /// Whether the first disparity of a frame is checked before the next frame can start.
   constexpr bool holds_settings() const {
      const int check = has_left_right_check() ? disparities - 1 : 0;
      return groups_to_first_window() + check + clocks_to_last_check() + support_lag(*this) < row_groups() * width_px;
   }
   /// Whether all disparities fit at as many columns as a window has. In narrower images a column would leave the
   /// windows of a row after the row's end, and with full_width a row's first pixel would lack candidates on both
   /// sides.
   constexpr bool has_whole_windows() const { return width_px - first_whole_column() >= window_px; }
   static constexpr int at_least_0(int value) { return value < 0 ? 0 : value; }
   static constexpr int larger(int a, int b) { return a < b ? b : a; }
   /// Columns by which the reference must lag behind the searched image, for the newest searched pixel to be the match
   /// at one end of the disparity range.
   constexpr int reference_offset() const {
      return reference == Reference::right ? disparities - 1 + min_disparity : -min_disparity;
   }
};

}  // namespace stereo::block_matching
