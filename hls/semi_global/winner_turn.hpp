// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/row_order.hpp"
#include "support/memory_bank.hpp"
#include "winner/winners.hpp"

namespace stereo::semi_global {

/// Turns the rows of winners back: they come from a row's last column to its first, and leave a row later in raster
/// order. 3 clocks. Memory: map width x (9 bits, with subpixel 14, with a margin 6 more). A folded core has one place
/// more and writes each word once: it would else read a row's last one in the clock in which it is written.
template <const Config& C>
struct WinnerTurn {
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kClocks = 3;
   static constexpr int kLagGroups = C.width_px;
   static constexpr int kFractionBits = C.subpixel ? 5 : 0;
   using Word = uint_of_bits<9 + kFractionBits + (kHasMargin<C> ? kMarginBits : 0)>;
   static constexpr bool kWritesOnce = C.is_folded();
   using Memory = MemoryBank<Word, kWidth + kWritesOnce, 1>;
   static constexpr int kMemories = Memory::kMemories;

   Memory memory;
   // clock 1
   RowOrder<kWidth, typename OfWidth<C, kWidth - 1>::Type> order;
   Word newest;
   bool comes;
   // clock 2; the newest goes to the place that has just been read
   Word read_words[1];
   PixelTag read_tag;
   Word write_words[1];
   uint16_t write_place;
   // clock 3
   Word ready;
   PixelTag ready_tag;

   template <class Source, int First>
   HLS_INLINE WinnerTurn(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("order", order);
      visit("newest", newest);
      visit("comes", comes);
      visit("read_words", read_words);
      visit("read_tag", read_tag);
      visit("write_words", write_words);
      visit("write_place", write_place);
      visit("ready", ready);
      visit("ready_tag", ready_tag);
   }

   HLS_INLINE Winners<kSumConfig<C>> output() const {
      Winners<kSumConfig<C>> out;
      out.disparity[0] = uint8_t(ready);
      out.passed[0] = (ready >> 8 & 1) != 0;
      if constexpr (C.subpixel) out.fraction[0] = uint8_t(ready >> 9 & 31);
      if constexpr (kHasMargin<C>)
         out.margin.value[0] = uint8_t(ready >> (9 + kFractionBits)) & ((1 << kMarginBits) - 1);
      out.tag = ready_tag;
      return out;
   }

   template <class Size = FixedSize<kWindowConfig<C>>>
   HLS_INLINE void clock(const Winners<kSumConfig<C>>& in, const Size& size = Size()) {
      ready = read_words[0];
      ready_tag = read_tag;
      Word stored[1];
      memory.read(order.address, stored);
      memory.write(write_place, write_words);
      read_words[0] = stored[0];
      read_tag = order.turned;
      write_words[0] = select<Word>(comes, newest, write_words[0]);
      write_place = select<uint16_t>(comes, order.address, kWritesOnce ? uint16_t(kWidth) : write_place);
      newest = Word(Word(in.disparity[0]) | Word(in.passed[0]) << 8);
      if constexpr (C.subpixel) newest |= Word(Word(in.fraction[0]) << 9);
      if constexpr (kHasMargin<C>) newest |= Word(Word(in.margin.value[0]) << (9 + kFractionBits));
      comes = in.tag.valid && in.tag.map_column;
      order.clock(in.tag, size);
   }
};

}  // namespace stereo::semi_global
