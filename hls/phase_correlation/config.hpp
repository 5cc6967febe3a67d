// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "phase_correlation/matching.hpp"
#include "support/image.hpp"

namespace stereo::phase_correlation {

/// How the core is built.
struct Structure : OptionGroups<Summation, SliceSize, WinnerGroup, RunTime> {
   using OptionGroups::OptionGroups;
};

/// The cost of this family, for the blocks that it shares with block matching: one more than the costs that have words.
inline constexpr Cost kPhaseCost = Cost(3);

/// Columns and rows around a pixel that the filters of one scale cover; its step is 2^scale.
struct FilterReach {
   int above, below, before, after;
};

/// What the blocks are templates over: a block matching that compares phase codes.
struct CodeConfig : block_matching::Config {
   int scales = 1;

   /// Signs of the real and imaginary parts of three orientations.
   static constexpr int kBitsOfScale = 6;
   constexpr int feature_bits() const { return kBitsOfScale * scales; }
   /// Where there are several scales, the finest counts twice.
   constexpr int weight(int scale) const { return scale == 0 && scales > 1 ? 2 : 1; }
   constexpr int largest_pixel_cost() const { return kBitsOfScale * (scales > 1 ? scales + 1 : 1); }
   constexpr int largest_column_cost() const { return largest_pixel_cost() * window_px; }
   constexpr int largest_window_cost() const { return largest_column_cost() * window_px; }

   /// The left image as reference is the mirror image: so are the columns.
   constexpr FilterReach reach(int scale) const {
      const int step = 1 << scale, box = 3 * step - 1, taps = 2 * step;
      return reference == Reference::right ? FilterReach{box, taps, box, taps} : FilterReach{box, taps, taps, box};
   }
   constexpr FilterReach largest_reach() const { return reach(scales - 1); }
   constexpr bool has_transform() const { return true; }
   constexpr int transform_groups() const { return largest_reach().below; }
   constexpr int transform_columns() const { return largest_reach().after; }

   /// As for block matching, with the filters' rows and columns in place of a census.
   constexpr bool holds_settings() const {
      const int filters = transform_groups() * width_px + transform_columns();
      const int check = has_left_right_check() ? disparities - 1 : 0;
      return filters + groups_behind_transform() + check + clocks_to_last_check() + support_lag(*this) <
             row_groups() * width_px;
   }

   /// As for block matching: recursive sums need whole rows between two frames, and as many as the filters wait for.
   constexpr int gap_groups() const {
      if (aggregation == Aggregation::direct || delay_groups() == 0) return 0;
      const int rows = delay_groups() < transform_groups() ? transform_groups() : delay_groups();
      return rows * width_px;
   }
};

/// One hardware configuration of the phase-correlation core. The named ones are in configurations.hpp.
struct Config : Image, Matching, Structure {
   constexpr CodeConfig codes() const {
      block_matching::Matching matching = block_matching();
      matching.cost = kPhaseCost;
      return {{Image(*this), matching, shared_options<block_matching::Structure>(*this)}, phase_scales};
   }

   /// As in Matching; ports may leave any disparity out.
   constexpr bool has_check() const { return Matching::has_check() || codes().has_lost_pixels(); }

   constexpr int output_width_px() const { return codes().output_width_px(); }
   constexpr int disparity_bits() const { return codes().disparity_bits(); }
   constexpr int steps_per_pixel() const { return subpixel ? 16 : 1; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      if (const Sentence limit = first_beyond_limits<Structure>(*this); !limit.empty()) return limit;
      // The costs are those of a census of 5x5 at most, the transform's reach is another.
      stereo::block_matching::Config checked = codes();
      checked.cost = Cost::census;
      checked.census_width_px = checked.census_height_px = 3;
      if (const Sentence sentence = checked.problem(); !sentence.empty()) return sentence;
      if (pixels_per_clock != 1) return "the phase-correlation core takes one pixel pair a clock";
      if (height_px <= codes().transform_groups())
         return "the image must be higher than the rows that a filter waits for";
      if (width_px <= codes().transform_columns())
         return "the image must be wider than the columns that a filter waits for";
      if (run_time_settings && !codes().holds_settings())
         return "with run-time settings the image must be higher, for a frame's first disparity to leave before the "
                "next one";
      return {};
   }
};

template <const auto& C>
inline constexpr CodeConfig kCodeConfig = C.codes();

}  // namespace stereo::phase_correlation
