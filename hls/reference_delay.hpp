// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "raster.hpp"

namespace stereo {

/// Delays the reference (right) image by D-1 pixels, so that R(x) meets L(x) ... L(x+D-1), and derives from the
/// position what the later blocks must know. 1 clock. Memory: D x 8 bits.
template <const StereoConfig& C>
struct ReferenceDelay {
   using Memory = uint8_t[C.disparities];
   static constexpr int kRows = C.window_px;

   /// A ring. Reads the oldest pixel while the newest is written one place behind it: both addresses are registers, and
   /// a bubble rewrites a place that the next pixel overwrites, so that the memory needs no enable.
   Memory& memory;
   uint16_t read_address = 1;
   uint16_t write_address = 0;

   uint8_t left = 0;
   uint8_t right = 0;       ///< D-1 pixels older than `left`
   uint16_t column = 0;     ///< of `left`
   bool row_inside[kRows];  ///< [k]: the row k above this one is a row of the frame the windows see
   PixelTag tag;

   inline explicit ReferenceDelay(Memory& m) : memory(m) { fill(row_inside, false); }

   inline void clock(const Raster<C>& raster) {
      const bool valid = raster.valid;
      right = memory[read_address];
      memory[write_address] = raster.right;
      write_address = select<uint16_t>(valid, read_address, write_address);
      const uint16_t read_after = select<uint16_t>(read_address == C.disparities - 1, 0, read_address + 1);
      read_address = at_most<C.disparities - 1>(select<uint16_t>(valid, read_after, read_address));

      left = raster.left;
      column = raster.column;
      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) row_inside[k] = raster.row >= k && raster.row < C.height_px + k;

      const bool output_row = raster.row >= C.radius_px() && raster.row < Raster<C>::kIdleRow;
      tag.valid = valid;
      tag.cost_column = raster.column >= C.disparities - 1;
      tag.output_column = output_row && tag.cost_column && raster.column != C.width_px - 1;
      tag.start_of_frame = raster.row == C.radius_px() && raster.column == C.disparities - 1;
      tag.end_of_line = raster.column == C.width_px - 2;
   }
};

}  // namespace stereo
