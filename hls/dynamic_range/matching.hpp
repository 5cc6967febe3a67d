// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "phase_correlation/matching.hpp"
#include "support/options.hpp"

namespace stereo::dynamic_range {

/// The codes of which two pixels are compared: their cost is the number of bits in which these differ.
enum class Codes : uint8_t { phase, census };

/// What matching in a search window that follows the scene computes: docs/algorithm.md defines each option. The
/// reference is the right image. Models take it with images of any size from 8 rows on.
struct Matching {
   int disparities = 128;  ///< total range T: 0 <= disparity < T, 32 ... 256, a multiple of 4, below the image width
   int window_disparities = 16;  ///< D, of each of the two search windows, 16 ... 64, a multiple of 8, at most T - 8
   int window_px = 9;            ///< side B of the square matching window, 3 ... 31, odd
   int pixel_bits = 8;           ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   Codes codes = Codes::phase;
   int phase_scales = 2;      ///< S, 1 ... 3: scales whose phases are compared
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   bool subpixel = false;     ///< disparities in sixteenths of a pixel

   constexpr bool has_check() const { return false; }

   /// Pixels of the images to one of those in which the whole range is searched, along each axis.
   static constexpr int kCoarse = 4;
   /// Side of the blocks for which it is known where surfaces are.
   static constexpr int kBlock = 8;
   /// Side of the matching window in the coarse images.
   static constexpr int kCoarseWindow = 7;
   /// Disparities by which a search window reaches beyond the surfaces that it follows.
   static constexpr int kMargin = 6;
   /// Disparities by which the first disparity of a window may rise and fall from a column to the next one.
   static constexpr int kRise = 3, kFall = 1;

   constexpr int coarse_disparities() const { return disparities / kCoarse; }
   /// The largest first disparity of a search window.
   constexpr int last_base() const { return disparities - window_disparities; }

   /// The search of the whole range in the coarse images: phase codes ...
   constexpr phase_correlation::Matching coarse_phase() const {
      return {.disparities = coarse_disparities(),
              .window_px = kCoarseWindow,
              .pixel_bits = pixel_bits,
              .phase_scales = 1,
              .left_right_threshold = 1};
   }
   /// ... or census transforms.
   constexpr block_matching::Matching coarse_census() const {
      return {.disparities = coarse_disparities(),
              .window_px = kCoarseWindow,
              .pixel_bits = pixel_bits,
              .cost = Cost::census,
              .census_width_px = census_width_px,
              .census_height_px = census_height_px,
              .left_right_threshold = 1};
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, 32, 256, "the disparity range");
      visit("window_disparities", self.window_disparities, 16, 64, "the number of disparities of a search window");
      visit("window_px", self.window_px, 3, 31, "the window side");
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("codes", self.codes);
      visit("phase_scales", self.phase_scales, 1, 3, "the number of phase scales");
      visit("census_width_px", self.census_width_px, 3, 9, "the census window's width");
      visit("census_height_px", self.census_height_px, 3, 7, "the census window's height");
      visit("subpixel", self.subpixel);
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      if (disparities % kCoarse != 0) return "the disparity range must be a multiple of 4";
      if (window_disparities % kBlock != 0)
         return "the number of disparities of a search window must be a multiple of 8";
      if (window_disparities + kBlock > disparities)
         return "the disparity range must exceed a search window by 8 disparities or more";
      if (window_px % 2 == 0) return "the window side must be odd";
      if (const Sentence phase = coarse_phase().problem(); !phase.empty()) return phase;
      return coarse_census().problem();
   }
};

}  // namespace stereo::dynamic_range

namespace stereo {

template <>
struct Words<dynamic_range::Codes> {
   static constexpr const char* kName = "Codes";
   static constexpr const char* kWords[] = {"phase", "census"};
};

}  // namespace stereo
