// SPDX-License-Identifier: Apache-2.0
// The lanes of a record as one number, as the hardware's ports carry them: with lanes of 8 bits, bits 8p+7 ... 8p are
// lane p.
#pragma once

#include <cstdint>
#include <span>

#include "support/ports.hpp"

namespace stereo {

template <class Lane>
uint64_t lane_word(std::span<const Lane, kMostPixels> lanes, int lanes_in_use, int lane_bits) {
   uint64_t word = 0;
   for (int p = 0; p < lanes_in_use; ++p) word |= uint64_t(lanes[std::size_t(p)]) << (lane_bits * p);
   return word;
}

}  // namespace stereo
