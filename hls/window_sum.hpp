// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sad_cost.hpp"

namespace stereo {

/// Aggregates the last B column costs into window costs, for P windows and `Count` disparities. 1 clock; a window is
/// complete when the column r to the right of its centre has come in.
///
/// Partial sums move on with the columns, so that each clock adds once: sum of 1, of 2, ... of B-1 columns, and the
/// output is the sum of B. Registers: P x Count x (B-1) partial sums and P x Count window costs.
template <const StereoConfig& C, int Count>
struct WindowSum {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kPartials = C.window_px - 1;
   static constexpr int kRadius = C.radius_px();

   uint16_t partial[kPixels][kPartials][Count];  ///< [p][j]: the last j+1 column costs
   PixelTag centre[kRadius];                     ///< [j]: tag of the column j+1 before the newest
   uint16_t sum[kPixels][Count];                 ///< S(x,y,d), 0 ... 255*B*B
   PixelTag tag;                                 ///< of the window's centre

   HLS_INLINE WindowSum() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int j = 0; j < kPartials; ++j) fill<uint16_t>(partial[p][j], 0);
         fill<uint16_t>(sum[p], 0);
      }
   }

   HLS_INLINE void clock(const SadCost<C, Count>& cost) {
      const bool move = cost.tag.valid;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            const uint16_t newest = cost.column[p][i];
            sum[p][i] = uint16_t(partial[p][kPartials - 1][i] + newest);
            HLS_UNROLL
            for (int j = kPartials - 1; j > 0; --j) {
               const uint16_t next = uint16_t(partial[p][j - 1][i] + newest);
               partial[p][j][i] = select<uint16_t>(move, next, partial[p][j][i]);
            }
            partial[p][0][i] = select<uint16_t>(move, newest, partial[p][0][i]);
         }
      }
      tag = centre[kRadius - 1];
      tag.valid = move;
      HLS_UNROLL
      for (int j = kRadius - 1; j > 0; --j) centre[j] = hold(move, centre[j - 1], centre[j]);
      centre[0] = hold(move, cost.tag, centre[0]);
   }

  private:
   static HLS_INLINE PixelTag hold(bool move, PixelTag next, PixelTag now) {
      PixelTag tag;
      tag.output_column = select<bool>(move, next.output_column, now.output_column);
      tag.start_of_frame = select<bool>(move, next.start_of_frame, now.start_of_frame);
      tag.end_of_line = select<bool>(move, next.end_of_line, now.end_of_line);
      return tag;
   }
};

}  // namespace stereo
