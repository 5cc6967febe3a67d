// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "frontend/pixel_tag.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Whether winners carry how far the runner-up was: a confidence is made of it.
template <const auto& C>
inline constexpr bool kHasMargin = [] {
   if constexpr (requires { C.has_confidence(); }) return C.has_confidence();
   else return false;
}();
inline constexpr int kMarginBits = 6;

/// A number for each of `Lanes` pixels, where there is one.
template <int Lanes>
struct Margins {
   uint8_t value[Lanes];
};
struct NoMargins {};
template <const auto& C>
using WinnerMargins = std::conditional_t<kHasMargin<C>, Margins<C.pixels_per_clock>, NoMargins>;

/// The winners of a group on their way from check to check.
template <const auto& C>
struct Winners {
   uint8_t disparity[C.pixels_per_clock];
   uint8_t fraction[C.pixels_per_clock];  ///< sixteenths plus 8: 0 ... 16
   bool passed[C.pixels_per_clock];       ///< all checks so far
   [[no_unique_address]] WinnerMargins<C> margin;
   PixelTag tag;

   HLS_INLINE Winners() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("fraction", fraction, 8);
      visit("passed", passed, true);
      if constexpr (kHasMargin<C>) visit("margin", margin.value);
      visit("tag", tag);
   }
};

}  // namespace stereo
