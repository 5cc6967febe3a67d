// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/settings.hpp"
#include "support/fan_out.hpp"
#include "support/memory_bank.hpp"
#include "support/minimum_tree.hpp"
#include "support/move_delay.hpp"
#include "support/move_fan.hpp"

namespace stereo::semi_global {

/// The path from above: K of the column that came in kMoves moves ago. Memory: map width x D x bits of P2, which hold
/// what the row above passes on, and (levels + 1) x D x bits of a sum, LUT RAM.
template <const Config& C>
struct PathAbove {
   static constexpr int kCount = C.disparities;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kStateBits = bits_for(C.p2_above());
   static constexpr int kTotalBits = bits_for(C.largest_path_above());
   using Pack = Packed<kStateBits, kCount>;
   using State = typename Pack::Lane;
   using Word = typename Pack::Word;
   using Value = AbovePathValue<C>;
   using Passed = uint_of_bits<bits_for(C.largest_path_above() + C.p1_above())>;
   using Tree = MinimumTree<Value, kCount>;
   using Delay = MoveDelay<kTotalBits, kCount, Tree::kLevels + 1>;
   using Memory = MemoryBank<Word, kWidth, Pack::kWords>;
   static constexpr int kMoves = 4 + Tree::kLevels;
   static constexpr int kMemories = Memory::kMemories + Delay::kMemories;

   Memory memory;
   Word read_words[Pack::kWords];  // beside the entry's costs
   // move 1
   Word ready_words[Pack::kWords];
   PathCost<C> ready_cost[kCount];
   bool ready_top;
   [[no_unique_address]] SecondPenaltyAbove<C> top_p2;  ///< of the column here
   // move 2
   Value total[kCount];
   // then the tree, and the totals beside it
   Tree tree;
   Delay delay;
   FanOut<Value, kCount> smallest;
   // move kMoves
   Value cost[kCount];  ///< K
   // then what the row below gets
   Value beside[kCount], own[kCount];              ///< the smaller of the neighbours' K; K
   [[no_unique_address]] FirstPenaltyAbove<C> p1;  ///< of the column there
   [[no_unique_address]] SecondPenaltyAbove<C> p2;
   Passed step[kCount];
   State stay[kCount];
   bool comes[kMoves + 2];  ///< [j]: the column of j+1 moves ago is one of the map
   uint16_t column[kMoves + 2];
   MoveFan<kCount, 0> writes;  ///< this clock is a move of a column of the map: what is written changes
   Word write_words[Pack::kWords];
   uint16_t write_column;

   template <class Source, int First>
   HLS_INLINE PathAbove(Source& memories, MemoryId<First> first)
       : memory(memories, first), delay(memories, MemoryId<First + Memory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_words", read_words);
      visit("ready_words", ready_words);
      visit("ready_cost", ready_cost);
      visit("ready_top", ready_top);
      if constexpr (C.run_time_settings) visit("top_p2", top_p2.value, C.p2_above());
      visit("total", total);
      visit("tree", tree);
      visit("delay", delay);
      visit("smallest", smallest);
      visit("cost", cost);
      visit("beside", beside);
      visit("own", own);
      if constexpr (C.run_time_settings) {
         visit("p1", p1.value, C.p1_above());
         visit("p2", p2.value, C.p2_above());
      }
      visit("step", step);
      visit("stay", stay);
      visit("comes", comes);
      visit("column", column);
      visit("writes", writes);
      visit("write_words", write_words);
      visit("write_column", write_column);
   }

   HLS_INLINE void clock(const PathEntry<C>& entry) {
      const bool move = entry.tag.valid;
      const auto& moves = entry.moves_above;
      Word stored[Pack::kWords];
      memory.read(entry.next_column, stored);
      memory.write(write_column, write_words);
      pass_on(moves);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d)
         cost[d] = select<Value>(moves.lane(d), Value(delay.lane(d) - smallest.get(d)) & kMask, cost[d]);
      smallest.move(moves, tree.root());
      tree.clock(total, moves);
      delay.clock(total, moves);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         const State from_above = select<State>(ready_top, top_p2.get(), Pack::lane(ready_words, d));
         total[d] = select<Value>(moves.lane(d), Value(from_above + ready_cost[d]), total[d]);
         ready_cost[d] = select<PathCost<C>>(moves.lane(d), entry.cost[d], ready_cost[d]);
      }
      ready_top = select<bool>(move, entry.top, ready_top);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         ready_words[w] = select<Word>(moves.lane(w * Pack::kPerWord), read_words[w], ready_words[w]);
         read_words[w] = stored[w];
      }
      writes.clock(entry.next_tag.valid && select<bool>(move, comes[kMoves], comes[kMoves + 1]));
      HLS_UNROLL
      for (int j = kMoves + 1; j > 0; --j) comes[j] = select<bool>(move, comes[j - 1], comes[j]);
      comes[0] = select<bool>(move, entry.tag.map_column, comes[0]);
      HLS_UNROLL
      for (int j = kMoves + 1; j > 0; --j) column[j] = select<uint16_t>(move, column[j - 1], column[j]);
      column[0] = select<uint16_t>(move, entry.column, column[0]);
   }

   /// Behind clock(), in a move. enters: the column that has just entered is the first of a frame; leaves: that whose K
   /// was there until now.
   template <class Settings>
   HLS_INLINE void take(bool enters, bool leaves, const Settings& settings) {
      if constexpr (C.run_time_settings) {
         if constexpr (C.has_penalties_above()) {
            take(enters, leaves, settings.above_p1, settings.above_p2);
         } else {
            take(enters, leaves, settings.p1, settings.p2);
         }
      }
   }

  private:
   HLS_INLINE void take(bool enters, bool leaves, uint16_t p1_now, uint16_t p2_now) {
      top_p2.take(enters, p2_now);
      p1.take(leaves, p1_now);
      p2.take(leaves, p2_now);
   }

   static constexpr Value kMask = Value((uint64_t(1) << kTotalBits) - 1);

   /// Three moves: neighbours, penalty, minimum.
   template <class Move>
   HLS_INLINE void pass_on(const Move& moves) {
      State lanes[kCount];
      Word packed[Pack::kWords];
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) lanes[d] = State(select<Passed>(step[d] < stay[d], step[d], stay[d]));
      Pack::pack(lanes, packed);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w)
         write_words[w] = select<Word>(writes.lane(w * Pack::kPerWord), packed[w], write_words[w]);
      write_column = select<uint16_t>(writes.lane(0), column[kMoves + 1], write_column);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         step[d] = select<Passed>(moves.lane(d), Passed(beside[d] + p1.get()), step[d]);
         stay[d] = select<State>(moves.lane(d), State(select<Value>(own[d] > p2.get(), p2.get(), own[d])), stay[d]);
         const Value smaller = smaller_of<Value>(cost[d > 0 ? d - 1 : 1], cost[d < kCount - 1 ? d + 1 : kCount - 2]);
         beside[d] = select<Value>(moves.lane(d), smaller, beside[d]);
         own[d] = select<Value>(moves.lane(d), cost[d], own[d]);
      }
   }
};

}  // namespace stereo::semi_global
