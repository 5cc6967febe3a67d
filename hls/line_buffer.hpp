// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference_delay.hpp"

namespace stereo {

/// Turns the stream into columns of all rows that the windows cover, of both images. 3 clocks. Memory: two times
/// W x 8*stored_rows bits.
///
/// Clock 1 reads the stored column, clock 2 only waits, since block RAM is slow to show its data, clock 3 masks the
/// rows and prepares the write. Addresses and data of all accesses come straight from registers, so a synthesiser can
/// fold the memories into block RAM or LUT RAM. Between bubbles the last write is repeated.
template <const StereoConfig& C>
struct LineBuffer {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kStored = C.stored_rows();
   static_assert(kStored <= 8, "one memory word holds the stored rows of a column");
   /// One word a column: bits 8i+7 ... 8i hold the i-th oldest stored row.
   using Word = uint_of_bits<8 * kStored>;
   using Memory = Word[C.width_px];

   Memory& left_memory;
   Memory& right_memory;

   struct Column {
      Word left_word = 0, right_word = 0;
      uint8_t left[kPixels], right[kPixels];  ///< of the newest group
      uint16_t column = 0;
      bool inside[kTaps];
      PixelTag tag;

      HLS_INLINE Column() {
         fill<uint8_t>(left, 0);
         fill<uint8_t>(right, 0);
         fill(inside, false);
      }
   };
   Column read;   // clock 1
   Column ready;  // clock 2
   // clock 3
   uint8_t left[kTaps], right[kTaps];  ///< [t]: top row first; 0 in both images where the row is outside the frame, so
                                       ///< that their absolute difference is 0
   PixelTag tag;
   Word write_left = 0, write_right = 0;
   uint16_t write_column = 0;

   HLS_INLINE LineBuffer(Memory& l, Memory& r) : left_memory(l), right_memory(r) {
      fill<uint8_t>(left, 0);
      fill<uint8_t>(right, 0);
   }

   HLS_INLINE void clock(const ReferenceDelay<C>& in) {
      const Word left_word = left_memory[in.column];
      const Word right_word = right_memory[in.column];
      left_memory[write_column] = write_left;
      right_memory[write_column] = write_right;

      const bool valid = ready.tag.valid;
      write_left = select<Word>(valid, aged(ready.left_word, ready.left), write_left);
      write_right = select<Word>(valid, aged(ready.right_word, ready.right), write_right);
      write_column = select<uint16_t>(valid, ready.column, write_column);
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         left[t] = select<uint8_t>(ready.inside[t], tap(t, ready.left_word, ready.left), 0);
         right[t] = select<uint8_t>(ready.inside[t], tap(t, ready.right_word, ready.right), 0);
      }
      tag = ready.tag;

      advance(ready, read);

      read.left_word = left_word;
      read.right_word = right_word;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         read.left[p] = in.left[p];
         read.right[p] = uint8_t(in.right >> (8 * p));
      }
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) read.inside[t] = in.row_inside[t];
      read.column = in.column;
      read.tag = in.tag;
   }

  private:
   /// The word with the newest group in it and the oldest out of it.
   static HLS_INLINE Word aged(Word word, const uint8_t (&newest)[kPixels]) {
      Word result = word >> (8 * kPixels);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) result |= Word(newest[p]) << (8 * (kStored - kPixels + p));
      return result;
   }

   static HLS_INLINE uint8_t tap(int t, Word word, const uint8_t (&newest)[kPixels]) {
      return t < kStored ? uint8_t(word >> (8 * (t < kStored ? t : 0))) : newest[t < kStored ? 0 : t - kStored];
   }

   static HLS_INLINE void advance(Column& to, const Column& from) {
      to.left_word = from.left_word;
      to.right_word = from.right_word;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         to.left[p] = from.left[p];
         to.right[p] = from.right[p];
      }
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) to.inside[t] = from.inside[t];
      to.column = from.column;
      to.tag = from.tag;
   }
};

}  // namespace stereo
