// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/clock_delay.hpp"

namespace stereo::rectification {

/// Linear interpolation between two numbers that are not negative: first * (2^WeightBits - weight) + second * weight,
/// divided by 2^Shift and rounded to the nearest, halves up. 3 clocks: the difference, its share, the sum; the product
/// has a clock for itself.
template <int WeightBits, int Shift, int ValueBits>
struct Linear {
   static constexpr int kClocks = 3;
   static constexpr int kHalf = Shift == 0 ? 0 : (1 << Shift) / 2;

   int32_t from, difference;  // clock 1
   uint8_t part;
   int32_t base, share;  // clock 2
   uint32_t value;       // clock 3

   HLS_INLINE Linear() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("from", from);
      visit("difference", difference);
      visit("part", part);
      visit("base", base);
      visit("share", share);
      visit("value", value);
   }

   HLS_INLINE void clock(int32_t first, int32_t second, uint8_t weight) {
      // Never negative, which the tool cannot see in a sum of differences.
      value = uint32_t(base + share) >> Shift & ((1U << ValueBits) - 1);
      base = (from << WeightBits) + kHalf;
      share = difference * part;
      from = first;
      difference = second - first;
      part = weight;
   }
};

}  // namespace stereo::rectification
