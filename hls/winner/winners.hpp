// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/pixel_tag.hpp"
#include "support/registers.hpp"

namespace stereo {

/// The winners of a group on their way from check to check.
template <const auto& C>
struct Winners {
   uint8_t disparity[C.pixels_per_clock];
   uint8_t fraction[C.pixels_per_clock];  ///< sixteenths plus 8: 0 ... 16
   bool passed[C.pixels_per_clock];       ///< all checks so far
   PixelTag tag;

   HLS_INLINE Winners() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("fraction", fraction, 8);
      visit("passed", passed, true);
      visit("tag", tag);
   }
};

}  // namespace stereo
