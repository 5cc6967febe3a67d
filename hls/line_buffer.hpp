// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "reference_delay.hpp"

namespace stereo {

/// Turns the pixel stream into columns of B pixels of both images. 2 clocks. Memory: W x 16*(B-1) bits.
///
/// Clock 1 reads the stored column, clock 2 writes it back one row older. Address and data of both accesses come
/// straight from registers, so a synthesiser can fold the memory into block RAM or LUT RAM.
template <const StereoConfig& C>
struct LineBuffer {
   static constexpr int kRows = C.window_px;
   using Word = std::conditional_t<(kRows <= 3), uint32_t, uint64_t>;
   static_assert(16 * (kRows - 1) <= 8 * sizeof(Word), "one memory word holds B-1 pixel pairs");
   /// One word a column: bits 16k+7 ... 16k left and 16k+15 ... 16k+8 right pixel of the row k+1 above the current one.
   using Memory = Word[C.width_px];

   Memory& memory;
   // Clock 1. A bubble holds all of it, and clock 2 then writes the same word to the same place again.
   Word word = 0;
   uint8_t newest_left = 0, newest_right = 0;
   uint16_t write_column = 0;
   bool inside_before[kRows];
   PixelTag tag_before;
   // Clock 2. Pixels of rows outside the frame are 0 in both images, so that their absolute differences are 0.
   uint8_t left[kRows], right[kRows];  ///< [k]: k rows above the newest
   PixelTag tag;

   inline explicit LineBuffer(Memory& m) : memory(m) {
      fill(inside_before, false);
      fill<uint8_t>(left, 0);
      fill<uint8_t>(right, 0);
   }

   inline void clock(const ReferenceDelay<C>& in) {
      const Word stored = memory[in.column];
      const Word older = (word << 16) | Word(newest_right) << 8 | newest_left;
      memory[write_column] = older;
      left[0] = select<uint8_t>(inside_before[0], newest_left, 0);
      right[0] = select<uint8_t>(inside_before[0], newest_right, 0);
      HLS_UNROLL
      for (int k = 1; k < kRows; ++k) {
         left[k] = select<uint8_t>(inside_before[k], word >> (16 * (k - 1)), 0);
         right[k] = select<uint8_t>(inside_before[k], word >> (16 * (k - 1) + 8), 0);
      }
      tag = tag_before;

      const bool valid = in.tag.valid;
      word = select<Word>(valid, stored, word);
      newest_left = select<uint8_t>(valid, in.left, newest_left);
      newest_right = select<uint8_t>(valid, in.right, newest_right);
      write_column = select<uint16_t>(valid, in.column, write_column);
      HLS_UNROLL
      for (int k = 0; k < kRows; ++k) inside_before[k] = in.row_inside[k];
      tag_before = in.tag;
   }
};

}  // namespace stereo
