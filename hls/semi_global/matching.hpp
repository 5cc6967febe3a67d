// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "support/matching_options.hpp"
#include "support/options.hpp"

namespace stereo::semi_global {

inline constexpr int kLargestUniqueness = 4095;

/// What semi-global matching computes: docs/algorithm.md defines each option. Models take it with images of any size.
struct Matching {
   // The window costs, those of block matching.
   int disparities = 64;   ///< disparity range D: 0 <= d < D, 2 ... 256 and below the image width
   int window_px = 3;      ///< side B of the square matching window, 1 or more, odd or even
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   int pixel_bits = 8;     ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   Reference reference = Reference::right;
   Cost cost = Cost::census;
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63 * 2^(pixel_bits - 8); filtered pixels are 0 ... 2*cap
   // The costs of the paths.
   int cost_shift = 4;   ///< window costs are divided by 2^cost_shift, 0 ... 16
   int cost_cap = 4095;  ///< the largest cost that a path sees, 1 ... 4095
   // The paths.
   bool path_left = true;   ///< along the row, from its left end
   bool path_right = true;  ///< along the row, from its right end
   bool path_above = true;  ///< down the column
   int p1 = 5;              ///< penalty of a step by one disparity, 0 ... 4095
   int p2 = 22;             ///< penalty of any other step, 0 ... 4095
   // The winner and its checks.
   Ties ties = Ties::smallest;
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities, below D; -1: no check
   int uniqueness_distance = 0;    ///< least distance of the runner-up's sum, 0 ... 4095; 0: no check
   bool subpixel = false;          ///< disparities in sixteenths of a pixel
   bool median = false;            ///< median of 3x3 disparities
   bool full_width = false;        ///< a disparity for every pixel whose window lies in the image
   int first_disparity = 0;        ///< with full_width: lowest of the disparities 0 ... D-1 that is searched
   int last_disparity = -1;        ///< and the highest one; -1: D-1

   constexpr bool has_left_right_check() const { return left_right_threshold >= 0; }
   constexpr bool has_uniqueness_check() const { return uniqueness_distance > 0; }
   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const {
      return has_left_right_check() || has_uniqueness_check() || window_costs().has_lost_pixels();
   }

   /// Columns by which the fresh start of a row path looks back: what the core's pipeline needs. It is part of the
   /// definition, since the sums depend on it.
   constexpr int look_back_columns() const {
      int levels = 0;
      while (1 << levels < disparities) ++levels;
      return levels + 4;
   }

   /// Block matching whose window costs are the ones here.
   constexpr block_matching::Matching window_costs() const {
      return {.disparities = disparities,
              .window_px = window_px,
              .min_disparity = min_disparity,
              .pixel_bits = pixel_bits,
              .reference = reference,
              .cost = cost,
              .census_width_px = census_width_px,
              .census_height_px = census_height_px,
              .prefilter = prefilter,
              .prefilter_cap = prefilter_cap,
              .ties = ties,
              .left_right_threshold = left_right_threshold,
              .subpixel = subpixel,
              .median = median,
              .full_width = full_width,
              .first_disparity = first_disparity,
              .last_disparity = last_disparity};
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, 2, 256, "the disparity range");
      visit("window_px", self.window_px, 1, kUnlimited, "the window side");
      visit("min_disparity", self.min_disparity, -block_matching::kFarthest, block_matching::kFarthest, "the smallest disparity");
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("reference", self.reference);
      visit("cost", self.cost);
      visit("census_width_px", self.census_width_px, 3, 9, "the census window's width");
      visit("census_height_px", self.census_height_px, 3, 7, "the census window's height");
      visit("prefilter", self.prefilter);
      visit("prefilter_cap", self.prefilter_cap, 1, self.window_costs().largest_cap(), "the prefilter's cap");
      visit("cost_shift", self.cost_shift, 0, 16, "the cost shift");
      visit("cost_cap", self.cost_cap, 1, 4095, "the cost cap");
      visit("path_left", self.path_left);
      visit("path_right", self.path_right);
      visit("path_above", self.path_above);
      visit("p1", self.p1, 0, 4095, "the penalty P1");
      visit("p2", self.p2, 0, 4095, "the penalty P2");
      visit("ties", self.ties);
      visit("left_right_threshold", self.left_right_threshold, -1, self.disparities - 1, "the left/right threshold");
      visit("uniqueness_distance", self.uniqueness_distance, 0, kLargestUniqueness, "the uniqueness distance");
      visit("subpixel", self.subpixel);
      visit("median", self.median);
      visit("full_width", self.full_width);
      const int highest = self.full_width ? self.disparities - 1 : 0;
      visit("first_disparity", self.first_disparity, 0, highest, "the first disparity");
      visit("last_disparity", self.last_disparity, -1, self.full_width ? highest : -1, "the last disparity");
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (!full_width && window_costs().names_a_part()) return block_matching::kPartNeedsFullWidth;
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      if (const Sentence costs = window_costs().problem(); !costs.empty()) return costs;
      if (!path_left && !path_right && !path_above) return "at least one path must be on";
      if (full_width && window_px < 3) return "a semi-global map of full width needs a window of 3x3 pixels or more";
      return {};
   }
};

}  // namespace stereo::semi_global
