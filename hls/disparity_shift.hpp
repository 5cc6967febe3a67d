// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "line_buffer.hpp"

namespace stereo {

/// Holds the left pixels that the right pixels of one column are compared with, for `Count` neighbouring disparities.
/// 1 clock. Registers: taps x (Count + 2) x 8 bits.
///
/// Shifts are chained: the next one, for the disparities below these, takes `left_out`, `right` and `tag` one clock
/// later. So no pixel has to reach more than `Count` subtractors in one clock.
template <const StereoConfig& C, int Count>
struct DisparityShift {
   static constexpr int kTaps = C.tap_rows();

   uint8_t left[kTaps][Count];  ///< [t][i]: L(x + first + i) of tap t, first = the lowest disparity here
   uint8_t right[kTaps];        ///< [t]: R(x)
   uint8_t left_out[kTaps];     ///< [t]: the left pixel that has just left
   PixelTag tag;

   HLS_INLINE DisparityShift() {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) fill<uint8_t>(left[t], 0);
      fill<uint8_t>(right, 0);
      fill<uint8_t>(left_out, 0);
   }

   HLS_INLINE void clock(const uint8_t (&left_in)[kTaps], const uint8_t (&right_in)[kTaps], const PixelTag& tag_in) {
      const bool move = tag_in.valid;
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         left_out[t] = left[t][0];
         HLS_UNROLL
         for (int i = 0; i < Count - 1; ++i) left[t][i] = select<uint8_t>(move, left[t][i + 1], left[t][i]);
         left[t][Count - 1] = select<uint8_t>(move, left_in[t], left[t][Count - 1]);
         right[t] = right_in[t];
      }
      tag = tag_in;
   }
};

}  // namespace stereo
