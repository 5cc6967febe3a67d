// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sad_cost.hpp"

namespace stereo {

/// Aggregates the last B column costs of every disparity into window costs. 1 clock; the window is complete when the
/// column r to the right of its centre has come in.
template <const StereoConfig& C>
struct WindowSum {
   static constexpr int kColumns = C.window_px - 1;
   static constexpr int kRadius = C.radius_px();
   static constexpr int kDisparities = C.disparities;

   uint16_t history[kColumns][kDisparities];  ///< [j]: column cost j+1 columns before the newest
   PixelTag centre[kRadius];                  ///< [j]: tag of that column
   uint16_t sum[kDisparities];                ///< S(x,y,d), 0 ... 255*B*B
   PixelTag tag;                              ///< of the window's centre

   inline WindowSum() {
      HLS_UNROLL
      for (int j = 0; j < kColumns; ++j) fill<uint16_t>(history[j], 0);
      fill<uint16_t>(sum, 0);
   }

   inline void clock(const SadCost<C>& cost) {
      const bool move = cost.tag.valid;
      HLS_UNROLL
      for (int d = 0; d < kDisparities; ++d) {
         uint16_t total = cost.column[d];
         HLS_UNROLL
         for (int j = 0; j < kColumns; ++j) total += history[j][d];
         sum[d] = total;
         HLS_UNROLL
         for (int j = kColumns - 1; j > 0; --j)
            history[j][d] = select<uint16_t>(move, history[j - 1][d], history[j][d]);
         history[0][d] = select<uint16_t>(move, cost.column[d], history[0][d]);
      }
      tag = centre[kRadius - 1];
      tag.valid = move;
      HLS_UNROLL
      for (int j = kRadius - 1; j > 0; --j) centre[j] = hold(move, centre[j - 1], centre[j]);
      centre[0] = hold(move, cost.tag, centre[0]);
   }

  private:
   static inline PixelTag hold(bool move, PixelTag next, PixelTag now) {
      PixelTag tag;
      tag.output_column = select<bool>(move, next.output_column, now.output_column);
      tag.start_of_frame = select<bool>(move, next.start_of_frame, now.start_of_frame);
      tag.end_of_line = select<bool>(move, next.end_of_line, now.end_of_line);
      return tag;
   }
};

}  // namespace stereo
