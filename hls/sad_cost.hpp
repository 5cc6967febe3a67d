// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "disparity_shift.hpp"

namespace stereo {

/// Sums the absolute differences of a column of B pixels for every disparity. 2 clocks: differences, then their sum.
template <const StereoConfig& C>
struct SadCost {
   static constexpr int kRows = C.window_px;
   static constexpr int kDisparities = C.disparities;

   uint8_t difference[kRows][kDisparities];  ///< |R(x) - L(x+d)| of the row k above the newest, 0 ... 255
   PixelTag tag_before;
   uint16_t column[kDisparities];  ///< column cost, 0 ... 255*B; 0 outside the cost columns 0 ... W-D
   PixelTag tag;

   inline SadCost() {
      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) fill<uint8_t>(difference[k], 0);
      fill<uint16_t>(column, 0);
   }

   /// One wide difference and its sign. `a > b ? a - b : b - a` would come out as an 8-bit comparison in single bits.
   static inline uint8_t absolute_difference(uint8_t a, uint8_t b) {
      const int16_t difference = int16_t(a) - int16_t(b);
      const int16_t sign = difference >> 15;
      return uint8_t((difference ^ sign) - sign);
   }

   inline void clock(const DisparityShift<C>& shift) {
      HLS_UNROLL
      for (int d = 0; d < kDisparities; ++d) {
         uint16_t sum = 0;
         HLS_UNROLL
         for (int k = 0; k < kRows; ++k) sum += difference[k][d];
         column[d] = select<uint16_t>(tag_before.cost_column, sum, 0);
      }
      tag = tag_before;

      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) {
         HLS_UNROLL
         for (int d = 0; d < kDisparities; ++d)
            difference[k][d] = absolute_difference(shift.left[k][d], shift.right[k]);
      }
      tag_before = shift.tag;
   }
};

}  // namespace stereo
