// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Remembers for a row which pixel of each pair is the larger one: a pair comes as one of the newest P taps and returns
/// P taps higher with the next group of rows. Memory: W x (B-1) x Count bits. Pixels come back as they were, also those
/// of the next frame's first rows, which come while windows of the frame before still leave. Rows outside the frame are
/// 0 in both images when they come back, and any sign is right.
template <const auto& C, int Count>
struct SignMemory {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kKnown = C.tap_rows() - kPixels;
   using Pack = Packed<1, Count>;
   using Word = typename Pack::Word;
   static constexpr int kWords = Pack::kWords, kMemories = kKnown * kWords;
   static_assert(C.width_px >= 8, "a sign is written a few clocks after its place was read");

   MemoryBank<Word, C.width_px, kMemories> memory;
   uint16_t column, next_column, difference_column;  ///< of read_words, of ready_words, of the differences
   Word read_words[kMemories];
   Word ready_words[kMemories];  ///< of the columns that the shift shows
   Word known_words[kMemories];  ///< of the differences
   uint16_t write_column;
   Word write_words[kMemories];

   template <class Source, int First>
   HLS_INLINE SignMemory(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("next_column", next_column);
      visit("difference_column", difference_column);
      visit("read_words", read_words);
      visit("ready_words", ready_words);
      visit("known_words", known_words);
      visit("write_column", write_column);
      visit("write_words", write_words);
   }

   /// Of a tap that was there with the rows before.
   HLS_INLINE bool negative(int t, int i) const { return t < kKnown && tap_lane(ready_words, t < kKnown ? t : 0, i); }

   /// early_column: of the pixels that the shift shows two clocks later. `cost`: SadCost, which is clocked, too.
   template <class Cost, class Shift>
   HLS_INLINE void clock(uint16_t early_column, Cost& cost, const Shift& shift) {
      Word stored[kMemories];
      memory.read(early_column, stored);
      memory.write(write_column, write_words);
      keep(cost);
      cost.clock(shift, *this);
      HLS_UNROLL
      for (int w = 0; w < kMemories; ++w) {
         known_words[w] = ready_words[w];
         ready_words[w] = read_words[w];
         read_words[w] = stored[w];
      }
      difference_column = next_column;
      next_column = column;
      column = early_column;
   }

  private:
   static HLS_INLINE bool tap_lane(const Word (&words)[kMemories], int t, int i) {
      return words[t * kWords + i / Pack::kPerWord] >> (i % Pack::kPerWord) & 1;
   }

   template <class Cost>
   HLS_INLINE void keep(const Cost& cost) {
      HLS_UNROLL
      for (int t = 0; t < kKnown; ++t) {
         const int from = t + kPixels;
         typename Pack::Lane lanes[Count];
         HLS_UNROLL
         for (int i = 0; i < Count; ++i)
            lanes[i] = from < kKnown ? tap_lane(known_words, from < kKnown ? from : 0, i)
                                     : cost.newest_negative[from < kKnown ? 0 : from - kKnown][i];
         Word packed[kWords];
         Pack::pack(lanes, packed);
         HLS_UNROLL
         for (int w = 0; w < kWords; ++w)
            write_words[t * kWords + w] =
                select<Word>(cost.difference_tag.valid, packed[w], write_words[t * kWords + w]);
      }
      write_column = select<uint16_t>(cost.difference_tag.valid, difference_column, write_column);
   }
};

}  // namespace stereo
