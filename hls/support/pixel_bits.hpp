// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"
#include "support/ports.hpp"

namespace stereo {

/// Bits of a grey value; families without the option take 8.
template <const auto& C>
inline constexpr int kPixelBits = [] {
   if constexpr (requires { C.pixel_bits; }) return C.pixel_bits;
   else return 8;
}();

template <const auto& C>
using Pixel = uint_of_bits<kPixelBits<C>>;

/// What such a core takes in a clock.
template <const auto& C>
using CoreInput = PixelPairs<Pixel<C>>;

/// One pixel of a port word.
template <const auto& C, class Word>
HLS_INLINE Pixel<C> pixel_of(Word word, int lane) {
   return Pixel<C>(word >> (kPixelBits<C> * lane)) & Pixel<C>((1u << kPixelBits<C>)-1);
}

}  // namespace stereo
