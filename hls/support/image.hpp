// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/options.hpp"
#include "support/sentence.hpp"

namespace stereo {

/// The images that a core takes, and how many of their pixels at once.
struct Image {
   int width_px = 0;          ///< W, 8 ... 4096
   int height_px = 0;         ///< H, up to 4096, a multiple of pixels_per_clock
   int pixels_per_clock = 1;  ///< P pixel pairs of one column in P neighbouring rows enter at once: 1, 2 or 4

   /// Rows travel in groups of P.
   constexpr int row_groups() const { return height_px / pixels_per_clock; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("width_px", self.width_px, 8, 4096, "the image width");
      visit("height_px", self.height_px, 1, 4096, "the image height");
      visit("pixels_per_clock", self.pixels_per_clock, 1, 4, "the number of pixel pairs a clock");
   }

   /// Why no core can take such images; empty when one can.
   constexpr Sentence problem() const {
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      if (pixels_per_clock == 3) return "the number of pixel pairs a clock is 3 but must be 1, 2 or 4";
      if (height_px % pixels_per_clock != 0) return "the image height must be a multiple of the pixel pairs a clock";
      return {};
   }
};

}  // namespace stereo
