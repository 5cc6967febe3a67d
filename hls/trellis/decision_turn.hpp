// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/path_entry.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "trellis/forward.hpp"

namespace stereo::trellis {

/// Keeps the decisions of a row and gives them back from its last column to its first while the next row comes in.
/// Columns come out a row and kMoves moves later. Memory: map width x 2D bits.
template <const Config& C>
struct DecisionTurn {
   static constexpr int kCount = C.disparities;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kMoves = 1;
   using Entry = semi_global::PathEntry<kCostConfig<C>>;
   using Pack = Packed<2, kCount>;
   using Word = typename Pack::Word;
   using Memory = MemoryBank<Word, kWidth, Pack::kWords>;
   static constexpr int kMemories = Memory::kMemories;
   /// The decision is the register that is written: its place and its validity come as many moves later.
   static constexpr int kWriteMoves = Forward<C>::kMoves;
   static_assert(kWriteMoves + 2 <= kCostConfig<C>.turn_columns(), "the last column must be there before it is read");

   Memory memory;
   Word read_words[Pack::kWords];  // beside the entry's costs
   // move 1
   uint8_t ready_decision[kCount];  ///< one register each: a choice among lanes of a word would become a shift
   bool ready_inside;               ///< a column of the map
   // what is written
   bool comes[kWriteMoves];  ///< [j]: the column of j+1 moves ago is one of the map
   uint16_t place[kWriteMoves];
   Word write_words[Pack::kWords];
   uint16_t write_place;

   template <class Source, int First>
   HLS_INLINE DecisionTurn(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_words", read_words);
      visit("ready_decision", ready_decision);
      visit("ready_inside", ready_inside);
      visit("comes", comes);
      visit("place", place);
      visit("write_words", write_words);
      visit("write_place", write_place);
   }

   HLS_INLINE void clock(const Entry& entry, const Forward<C>& forward) {
      const bool move = entry.tag.valid;
      Word stored[Pack::kWords], words[Pack::kWords];
      memory.read(entry.order.address, stored);
      memory.write(write_place, write_words);
      Pack::pack(forward.decision, words);
      const bool writes = move && comes[kWriteMoves - 1];
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         write_words[w] = select<Word>(writes, words[w], write_words[w]);
      }
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d)
         ready_decision[d] = select<uint8_t>(move, Pack::lane(read_words, d), ready_decision[d]);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) read_words[w] = stored[w];
      write_place = select<uint16_t>(writes, place[kWriteMoves - 1], write_place);
      ready_inside = select<bool>(move, entry.turned.map_column, ready_inside);
      HLS_UNROLL
      for (int j = kWriteMoves - 1; j > 0; --j) {
         comes[j] = select<bool>(move, comes[j - 1], comes[j]);
         place[j] = select<uint16_t>(move, place[j - 1], place[j]);
      }
      comes[0] = select<bool>(move, entry.tag.map_column, comes[0]);
      place[0] = select<uint16_t>(move, entry.place, place[0]);
   }
};

}  // namespace stereo::trellis
