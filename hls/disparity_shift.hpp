// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "line_buffer.hpp"

namespace stereo {

/// Holds the D left pixels of B rows that the right pixels are compared with. 1 clock. Registers: B*(D+1) x 8 bits.
template <const StereoConfig& C>
struct DisparityShift {
   static constexpr int kRows = C.window_px;
   static constexpr int kDisparities = C.disparities;

   uint8_t left[kRows][kDisparities];  ///< [k][d]: L(x+d) of the row k above the newest
   uint8_t right[kRows];               ///< [k]: R(x)
   PixelTag tag;

   inline DisparityShift() {
      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) fill<uint8_t>(left[k], 0);
      fill<uint8_t>(right, 0);
   }

   inline void clock(const LineBuffer<C>& rows) {
      const bool move = rows.tag.valid;
      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) {
         HLS_UNROLL
         for (int d = 0; d < kDisparities - 1; ++d) left[k][d] = select<uint8_t>(move, left[k][d + 1], left[k][d]);
         left[k][kDisparities - 1] = select<uint8_t>(move, rows.left[k], left[k][kDisparities - 1]);
         right[k] = rows.right[k];
      }
      tag = rows.tag;
   }
};

}  // namespace stereo
