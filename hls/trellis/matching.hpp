// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/matching.hpp"
#include "support/options.hpp"

namespace stereo::trellis {

/// What the trellis computes: docs/algorithm.md defines each option. The reference is the left image. Models take it
/// with images of any size.
struct Matching {
   // The costs, those of semi-global matching.
   int disparities = 64;   ///< disparity range D: 0 <= d < D, 2 ... 256 and below the image width
   int window_px = 3;      ///< side B of the square matching window, 1 or more, odd or even
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   int pixel_bits = 8;     ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   Cost cost = Cost::census;
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63 * 2^(pixel_bits - 8); filtered pixels are 0 ... 2*cap
   int cost_shift = 4;      ///< window costs are divided by 2^cost_shift, 0 ... 16
   int cost_cap = 4095;     ///< the largest cost that a state sees, 1 ... 4095
   // The trellis.
   int drop_cost = 4;          ///< gamma: of a disparity that falls, 0 ... 255
   int occlusion_cost = 7;     ///< omega: of a pixel that has no partner, 1 ... 255
   int far_drop = 6;           ///< s: disparities that a far drop falls by, 2 ... 255; from D on there is none
   bool mark_occluded = true;  ///< occluded pixels are not valid
   bool median = false;        ///< median of 3x3 disparities

   constexpr bool has_check() const { return mark_occluded; }

   /// Semi-global matching whose costs are the ones here.
   constexpr semi_global::Matching path_costs() const {
      return {.disparities = disparities,
              .window_px = window_px,
              .min_disparity = min_disparity,
              .pixel_bits = pixel_bits,
              .reference = Reference::left,
              .cost = cost,
              .census_width_px = census_width_px,
              .census_height_px = census_height_px,
              .prefilter = prefilter,
              .prefilter_cap = prefilter_cap,
              .cost_shift = cost_shift,
              .cost_cap = cost_cap,
              .median = median};
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, 2, 256, "the disparity range");
      visit("window_px", self.window_px, 1, kUnlimited, "the window side");
      visit("min_disparity", self.min_disparity, -block_matching::kFarthest, block_matching::kFarthest, "the smallest disparity");
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("cost", self.cost);
      visit("census_width_px", self.census_width_px, 3, 9, "the census window's width");
      visit("census_height_px", self.census_height_px, 3, 7, "the census window's height");
      visit("prefilter", self.prefilter);
      visit("prefilter_cap", self.prefilter_cap, 1, self.path_costs().window_costs().largest_cap(),
            "the prefilter's cap");
      visit("cost_shift", self.cost_shift, 0, 16, "the cost shift");
      visit("cost_cap", self.cost_cap, 1, 4095, "the cost cap");
      visit("drop_cost", self.drop_cost, 0, 255, "the cost of a drop");
      visit("occlusion_cost", self.occlusion_cost, 1, 255, "the cost of an occluded pixel");
      visit("far_drop", self.far_drop, 2, 255, "the far drop");
      visit("mark_occluded", self.mark_occluded);
      visit("median", self.median);
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      return path_costs().problem();
   }
};

}  // namespace stereo::trellis
