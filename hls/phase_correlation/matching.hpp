// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "support/matching_options.hpp"
#include "support/options.hpp"

namespace stereo::phase_correlation {

/// What local weighted phase correlation computes: docs/algorithm.md defines each option. Models take it with images of
/// any size.
struct Matching {
   int disparities = 64;   ///< disparity range D: 0 <= d < D, 1 ... 256 and below the image width
   int window_px = 9;      ///< side B of the square window of the local weighting, 1 or more, odd or even
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   int pixel_bits = 8;     ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   Reference reference = Reference::right;
   int phase_scales = 2;  ///< S, 1 ... 3: scales whose phases are compared
   Ties ties = Ties::smallest;
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities, below D; -1: no check
   int uniqueness_percent = 0;     ///< 0 ... 100; 0: no check
   bool subpixel = false;          ///< disparities in sixteenths of a pixel
   bool median = false;            ///< median of 3x3 disparities
   bool full_width = false;        ///< a disparity for every pixel whose window lies in the image
   int first_disparity = 0;        ///< with full_width: lowest of the disparities 0 ... D-1 that is searched
   int last_disparity = -1;        ///< and the highest one; -1: D-1

   constexpr bool has_left_right_check() const { return left_right_threshold >= 0; }
   constexpr bool has_uniqueness_check() const { return uniqueness_percent > 0; }
   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const { return block_matching().has_check(); }

   /// Block matching that only differs in what it compares. A census of 5x5 has the largest cost of three scales, 24.
   constexpr block_matching::Matching block_matching() const {
      return {.disparities = disparities,
              .window_px = window_px,
              .min_disparity = min_disparity,
              .pixel_bits = pixel_bits,
              .reference = reference,
              .cost = Cost::census,
              .census_width_px = 5,
              .census_height_px = 5,
              .ties = ties,
              .left_right_threshold = left_right_threshold,
              .uniqueness_percent = uniqueness_percent,
              .subpixel = subpixel,
              .median = median,
              .full_width = full_width,
              .first_disparity = first_disparity,
              .last_disparity = last_disparity};
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, 1, 256, "the disparity range");
      visit("window_px", self.window_px, 1, kUnlimited, "the window side");
      visit("min_disparity", self.min_disparity, -block_matching::kFarthest, block_matching::kFarthest, "the smallest disparity");
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("reference", self.reference);
      visit("phase_scales", self.phase_scales, 1, 3, "the number of phase scales");
      visit("ties", self.ties);
      visit("left_right_threshold", self.left_right_threshold, -1, self.disparities - 1, "the left/right threshold");
      visit("uniqueness_percent", self.uniqueness_percent, 0, 100, "the uniqueness in percent");
      visit("subpixel", self.subpixel);
      visit("median", self.median);
      visit("full_width", self.full_width);
      const int highest = self.full_width ? self.disparities - 1 : 0;
      visit("first_disparity", self.first_disparity, 0, highest, "the first disparity");
      visit("last_disparity", self.last_disparity, -1, self.full_width ? highest : -1, "the last disparity");
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (!full_width && block_matching().names_a_part()) return block_matching::kPartNeedsFullWidth;
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      return block_matching().problem();
   }
};

}  // namespace stereo::phase_correlation
