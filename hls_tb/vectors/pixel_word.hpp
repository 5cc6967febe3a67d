// SPDX-License-Identifier: Apache-2.0
// The pixels of a record as one number, as the hardware's ports carry them: bits 8p+7 ... 8p are lane p.
#pragma once

#include <cstdint>
#include <span>

#include "stream.hpp"

namespace stereo {

inline uint32_t pixel_word(std::span<const uint8_t, kMostPixels> lanes, int pixels_per_clock) {
   uint32_t word = 0;
   for (int p = 0; p < pixels_per_clock; ++p) word |= uint32_t(lanes[std::size_t(p)]) << (8 * p);
   return word;
}

inline void set_lanes(std::span<uint8_t, kMostPixels> lanes, uint32_t word) {
   for (int p = 0; p < kMostPixels; ++p) lanes[std::size_t(p)] = uint8_t(word >> (8 * p));
}

}  // namespace stereo
