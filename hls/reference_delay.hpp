// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "raster.hpp"

namespace stereo {

/// Delays the reference (right) image by D-1 pixels, so that R(x) meets L(x) ... L(x+D-1), and derives from the
/// position what the later blocks must know. 1 clock. Memory: D x 8*P bits.
template <const StereoConfig& C>
struct ReferenceDelay {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   /// One word a column: bits 8p+7 ... 8p hold row p of the group.
   using Memory = uint_of_bits<8 * kPixels>[C.disparities];

   /// A ring. Reads the oldest word while the newest is written one place behind it: both addresses are registers, and
   /// a bubble rewrites a place that the next pixels overwrite, so that the memory needs no enable.
   Memory& memory;
   uint16_t read_address = 1;
   uint16_t write_address = 0;

   uint8_t left[kPixels];
   uint_of_bits<8 * kPixels> right = 0;  ///< D-1 columns older than `left`
   uint16_t column = 0;                  ///< of `left`
   bool row_inside[kTaps];               ///< [t]: row t of those the windows cover is a row of their frame
   PixelTag tag;

   HLS_INLINE explicit ReferenceDelay(Memory& m) : memory(m) {
      fill<uint8_t>(left, 0);
      fill(row_inside, false);
   }

   HLS_INLINE void clock(const Raster<C>& raster) {
      right = memory[read_address];
      memory[write_address] = raster.right;
      write_address = select<uint16_t>(raster.valid, read_address, write_address);
      const uint16_t read_after = select<uint16_t>(read_address == C.disparities - 1, 0, read_address + 1);
      read_address = at_most<C.disparities - 1>(select<uint16_t>(raster.valid, read_after, read_address));

      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) left[p] = raster.left[p];
      column = raster.column;
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) row_inside[t] = raster.group >= first_group(t) && raster.group <= last_group(t);

      const bool output_group = raster.group >= C.delay_groups() && raster.group < Raster<C>::kIdle;
      tag.valid = raster.valid;
      tag.border_column = raster.column < C.disparities - 1;
      tag.output_column = output_group && !tag.border_column && raster.column != C.width_px - 1;
      tag.start_of_frame = raster.group == C.delay_groups() && raster.column == C.disparities - 1;
      tag.end_of_line = raster.column == C.width_px - 2;
   }

   /// First and last group of a frame in which tap t shows an image row: row (group - delay)*P - r + t is 0 ... H-1.
   static constexpr int first_group(int t) { return (C.stored_rows() - t + kPixels - 1) / kPixels; }
   static constexpr int last_group(int t) { return (C.height_px - 1 + C.stored_rows() - t) / kPixels; }
};

}  // namespace stereo
