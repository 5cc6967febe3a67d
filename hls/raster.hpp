// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hls_support.hpp"
#include "stereo_config.hpp"
#include "stream.hpp"

namespace stereo {

/// Counts columns and rows of the incoming stream. 1 clock.
///
/// The window around output row y needs image row y + r (r = window radius), so the last r output rows of a frame leave
/// while r further rows come in. Those are either rows of anything without start of frame ("flush rows"), or simply the
/// first rows of the next frame. In the second case a frame costs W*H clocks and not one more. `row` counts the rows
/// that the windows see: 0 ... H-1 are image rows, H ... H+r-1 the rows after them, whoever sends them, and H+r is
/// idle.
template <const StereoConfig& C>
struct Raster {
   static constexpr int kRadius = C.radius_px();
   static constexpr int kIdleRow = C.height_px + kRadius;

   // Single members instead of a StereoInput: a copied record of four bytes would become one 32-bit register.
   uint8_t left = 0;
   uint8_t right = 0;
   bool valid = false;
   uint16_t column = 0;      ///< 0 ... W-1
   uint16_t row = kIdleRow;  ///< 0 ... H+r
   bool next_frame = false;  ///< rows H ... H+r-1 are the first rows of the next frame

   inline void clock(StereoInput in) {
      const bool last_column = column == C.width_px - 1;
      const uint16_t column_after = select<uint16_t>(last_column, 0, column + 1);
      const bool row_ends = last_column && row != kIdleRow;
      const bool frame_joins = next_frame && row == kIdleRow - 1;
      const uint16_t row_below = select<uint16_t>(frame_joins, kRadius, row + 1);
      const uint16_t row_after = select<uint16_t>(row_ends, row_below, row);
      const bool next_frame_after = next_frame && !(row_ends && frame_joins);

      const bool starts = in.valid && in.start_of_frame;
      const bool back_to_back = row_ends && row == C.height_px - 1;
      const uint16_t first_row = select<uint16_t>(back_to_back, C.height_px, 0);
      column = at_most<C.width_px - 1>(select<uint16_t>(starts, 0, select<uint16_t>(in.valid, column_after, column)));
      row = at_most<kIdleRow>(select<uint16_t>(starts, first_row, select<uint16_t>(in.valid, row_after, row)));
      next_frame = select<bool>(starts, back_to_back, select<bool>(in.valid, next_frame_after, next_frame));
      left = in.left;
      right = in.right;
      valid = in.valid;
   }
};

}  // namespace stereo
