// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "postprocessing/map_column.hpp"
#include "support/memory_bank.hpp"

namespace stereo {

/// Where the holes of a row end, and what stands there: written while the row comes in, read a row later at the first
/// pixel of each hole. A hole ends before a valid pixel or at the end of its row. Memory for each row of a group: half
/// the map's width and 4 words of a disparity, a column and a bit.
///
/// Where a row's words begin is kept for the row that comes in and for the one before, so that a row that breaks off
/// leaves nothing behind.
template <const auto& C>
struct HoleEnds {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kPlaces = kWidth / 2 + 4;
   static constexpr int kColumnBits = bits_for(kWidth - 1);
   using Word = uint_of_bits<kMapBits<C> + kColumnBits + 1>;
   using Memory = MemoryBank<Word, kPlaces, kPixels>;
   static constexpr int kMemories = Memory::kMemories;

   Memory memory;
   bool open[kPixels];                 ///< the last pixel of the row that comes in is in a hole
   uint16_t next_place[kPixels];       ///< of a word
   uint16_t row_place[kPixels];        ///< of the first word of the row that comes in
   uint16_t row_above_place[kPixels];  ///< of the one before
   Word write_words[kPixels];
   uint16_t write_place[kPixels];
   uint16_t read_place[kPixels];
   Word read_words[kPixels], ready_words[kPixels];

   template <class Source, int First>
   HLS_INLINE HoleEnds(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("open", open);
      visit("next_place", next_place);
      visit("row_place", row_place);
      visit("row_above_place", row_above_place);
      visit("write_words", write_words);
      visit("write_place", write_place);
      visit("read_place", read_place);
      visit("read_words", read_words);
      visit("ready_words", ready_words);
   }

   // Of a word that is ready.
   static HLS_INLINE uint16_t disparity(Word word) { return uint16_t(word & kDisparityMask); }
   static HLS_INLINE uint16_t column(Word word) { return uint16_t(uint16_t(word >> kMapBits<C>) & kColumnMask); }
   static HLS_INLINE bool exists(Word word) { return (word >> (kMapBits<C> + kColumnBits) & 1) != 0; }

   /// The words at the read places of the clock before the last one are ready. reads_next: the word at the read place
   /// is that of a hole; row_follows: the next column that is asked for is the first one of the row before.
   HLS_INLINE void clock(const bool (&reads_next)[kPixels], bool row_follows) {
      Word stored[kPixels];
      memory.read_each(read_place, stored);
      memory.write_each(write_place, write_words);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         ready_words[p] = read_words[p];
         read_words[p] = stored[p];
         const uint16_t behind = select<uint16_t>(reads_next[p], after(read_place[p]), read_place[p]);
         read_place[p] = at_most<kPlaces - 1>(select<uint16_t>(row_follows, row_above_place[p], behind));
      }
   }

   /// A column of the row that comes in.
   HLS_INLINE void add(bool arrives, uint16_t column, bool is_last, const uint16_t (&disparity)[kPixels],
                       const bool (&passed)[kPixels]) {
      const bool is_first = arrives & (column == 0);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const bool was_open = open[p] & !is_first;
         const bool ends = arrives & ((passed[p] & was_open) | (!passed[p] & is_last));
         const Word word = Word(Word(disparity[p] & kDisparityMask) | Word(Word(column & kColumnMask) << kMapBits<C>) |
                                Word(Word(passed[p]) << (kMapBits<C> + kColumnBits)));
         // Without an end a free place is written: the words of holes are never read while they are written.
         write_words[p] = word;
         write_place[p] = at_most<kPlaces - 1>(next_place[p]);
         row_above_place[p] = at_most<kPlaces - 1>(select<uint16_t>(is_first, row_place[p], row_above_place[p]));
         row_place[p] = at_most<kPlaces - 1>(select<uint16_t>(is_first, next_place[p], row_place[p]));
         next_place[p] = at_most<kPlaces - 1>(select<uint16_t>(ends, after(next_place[p]), next_place[p]));
         open[p] = select<bool>(arrives, !passed[p], open[p]);
      }
   }

  private:
   static constexpr uint16_t kDisparityMask = uint16_t((1u << kMapBits<C>)-1);
   static constexpr uint16_t kColumnMask = uint16_t((1u << kColumnBits) - 1);

   static HLS_INLINE uint16_t after(uint16_t place) {
      return select<uint16_t>(place == kPlaces - 1, 0, uint16_t(place + 1));
   }
};

}  // namespace stereo
