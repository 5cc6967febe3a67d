// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/row_passes.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "winner/winners.hpp"

namespace stereo::block_matching {

/// Keeps the winners of a row, which come a column a clock in its last pass, until the columns of another row bring
/// them out, one for each. 2 clocks. Memory: 2 x the next power of two from W on x the bits of a winner.
template <const auto& C>
struct RowWinners {
   using Rows = TwoRows<C>;
   static constexpr int kClocks = 2;
   static constexpr int kDisparityBits = bits_for(C.disparities - 1);
   static constexpr int kFractionBits = C.subpixel ? 5 : 0;
   static constexpr int kPassedBits = C.has_check() ? 1 : 0;
   static constexpr int kMarginPlace = kDisparityBits + kFractionBits + kPassedBits;
   using Pack = Packed<kMarginPlace + (kHasMargin<C> ? kMarginBits : 0), 1>;
   using Word = typename Pack::Word;
   using Memory = MemoryBank<Word, Rows::kPlaces, 1>;
   static constexpr int kMemories = Memory::kMemories;
   static constexpr uint16_t kNoPlace = Rows::kPlaces - 1;
   static_assert(C.output_width_px() < Rows::kColumns, "the last place of a row must be free");

   Memory memory;
   bool row;  ///< of the two, in which the winners are
   uint16_t column;
   uint16_t write_address;
   Word write_word[1];
   // clock 1
   Word read_word[1];
   PixelTag read_tag;
   uint16_t read_address;
   // clock 2
   Winners<C> winners;
   uint16_t address_out;  ///< their row of the two and their column of the map

   template <class Source, int First>
   HLS_INLINE RowWinners(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("row", row, 1);
      visit("column", column);
      visit("write_address", write_address);
      visit("write_word", write_word);
      visit("read_word", read_word);
      visit("read_tag", read_tag);
      visit("read_address", read_address);
      visit("winners", winners);
      visit("address_out", address_out);
   }

   HLS_INLINE void clock(const Winners<C>& in, const RowPasses<C>& passes) {
      winners = unpacked(read_word[0]);
      winners.tag = read_tag;
      address_out = read_address;
      memory.read(passes.write_address, read_word);
      read_tag = place(passes);
      read_address = passes.write_address;
      memory.write(write_address, write_word);
      keep(in);
   }

  private:
   static HLS_INLINE PixelTag place(const RowPasses<C>& passes) {
      constexpr int kLast = C.output_width_px() - 1;
      const uint16_t column = Rows::column(passes.write_address);
      const bool on_map = column <= kLast;
      PixelTag tag;
      tag.valid = passes.arrived;
      tag.map_column = on_map;
      tag.output_column = on_map & passes.leaving.output;
      tag.first_column = column == 0;
      tag.start_of_frame = (column == 0) & passes.leaving.starts;
      tag.end_of_line = column == kLast;
      return tag;
   }

   HLS_INLINE void keep(const Winners<C>& in) {
      const bool comes = in.tag.valid & in.tag.map_column;
      const bool row_now = row ^ in.tag.first_column;
      const uint16_t column_now = Rows::column(select<uint16_t>(in.tag.first_column, 0, column));
      // A winner is written once: the last one of a row would else be written while it is read.
      write_address = select<uint16_t>(comes, Rows::address(row_now, column_now), kNoPlace);
      write_word[0] = packed(in);
      row = select<bool>(comes, row_now, row);
      column = Rows::column(select<uint16_t>(comes, uint16_t(column_now + 1), column));
   }

   static HLS_INLINE Word packed(const Winners<C>& in) {
      Word word = Word(in.disparity[0]);
      if constexpr (C.subpixel) word = Word(word | Word(in.fraction[0]) << kDisparityBits);
      if constexpr (C.has_check()) word = Word(word | Word(in.passed[0]) << (kDisparityBits + kFractionBits));
      if constexpr (kHasMargin<C>) word = Word(word | Word(in.margin.value[0]) << kMarginPlace);
      return word;
   }
   static HLS_INLINE Winners<C> unpacked(Word word) {
      Winners<C> out;
      out.disparity[0] = uint8_t(word & ((1u << kDisparityBits) - 1));
      if constexpr (C.subpixel) out.fraction[0] = uint8_t(word >> kDisparityBits & 31);
      if constexpr (C.has_check()) out.passed[0] = (word >> (kDisparityBits + kFractionBits) & 1) != 0;
      else out.passed[0] = true;
      if constexpr (kHasMargin<C>) out.margin.value[0] = uint8_t(word >> kMarginPlace & ((1u << kMarginBits) - 1));
      return out;
   }
};

}  // namespace stereo::block_matching
