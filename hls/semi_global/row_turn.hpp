// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/forward_paths.hpp"
#include "semi_global/path_entry.hpp"
#include "support/memory_bank.hpp"
#include "support/move_fan.hpp"
#include "support/packed.hpp"

namespace stereo::semi_global {

/// A column of the row before that waits, with full_width.
template <int Moves>
struct WaitingColumn {
   uint16_t read_place;
   bool first[Moves];  ///< [j]: the column of j+1 moves ago is the first of its row

   HLS_INLINE WaitingColumn() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_place", read_place);
      visit("first", first);
   }
};
struct NoWaitingColumn {};

/// Turns rows round for the path from the right: while a row comes in, the row before comes out from its last column to
/// its first, with the sums of the forward paths, the costs and the smallest cost. Columns come out a row and kMoves
/// moves later. Memory: map width x (D x (bits of a sum + bits of a cost) + bits of a cost).
template <const Config& C>
struct RowTurn {
   static constexpr int kCount = C.disparities;
   static constexpr int kWidth = C.output_width_px();
   using Forward = ForwardPaths<C>;
   /// Moves that a column of the row before waits for. With full_width only window_px - 1 columns stand between two
   /// rows: a row's last column, the first to come out, has not been written when the next row comes in.
   static constexpr int kWaits = C.full_width ? Forward::kMoves : 0;
   static constexpr int kMoves = 1 + kWaits;
   static constexpr bool kHasSums = C.path_left || C.path_above;
   using Sums = Packed<bits_for(C.largest_forward_sum()), kCount>;
   using Costs = Packed<C.cost_bits(), kCount>;
   using SumMemory = MemoryBank<typename Sums::Word, kWidth, (kHasSums ? Sums::kWords : 0)>;
   using CostMemory = MemoryBank<typename Costs::Word, kWidth, Costs::kWords>;
   /// The smallest cost, and above it the column's relief, where P2 falls.
   using Smallest = uint_of_bits<C.cost_bits() + (C.has_relief() ? C.relief_bits() : 0)>;
   static constexpr int kCostBits = C.cost_bits();
   static constexpr Smallest kSmallestMask = Smallest((1 << kCostBits) - 1);
   using SmallestMemory = MemoryBank<Smallest, kWidth, 1>;
   static constexpr int kMemories = SumMemory::kMemories + CostMemory::kMemories + 1;
   /// The forward paths' sum is the register that is written: its place and its validity come as many moves later.
   static constexpr int kWriteMoves = Forward::kMoves;
   static_assert(kWriteMoves + 2 <= C.turn_columns(), "the last column must be there before it is read");
   static_assert(!C.full_width || C.window_px > 2, "and its word two clocks before the next row's first is written");

   SumMemory sum_memory;
   CostMemory cost_memory;
   SmallestMemory smallest_memory;
   // beside the entry's costs
   typename Sums::Word read_sums[Sums::kWords];
   typename Costs::Word read_costs[Costs::kWords];
   Smallest read_smallest[1];
   // move 1
   typename Sums::Word ready_sums[Sums::kWords];
   typename Costs::Word ready_costs[Costs::kWords];
   Smallest ready_smallest[1];
   bool ready_first;
   // what is written
   bool comes[kWriteMoves];  ///< [j]: the column of j+1 moves ago is one of the map
   uint16_t place[kWriteMoves];
   MoveFan<kCount, 0> writes;  ///< this clock is a move of a column of the map: what is written changes
   typename Sums::Word write_sums[Sums::kWords];
   typename Costs::Word write_costs[Costs::kWords];
   Smallest write_smallest[1];
   uint16_t write_place;
   [[no_unique_address]] std::conditional_t<C.full_width, WaitingColumn<kWaits>, NoWaitingColumn> waiting;

   template <class Source, int First>
   HLS_INLINE RowTurn(Source& memories, MemoryId<First> first)
       : sum_memory(memories, first),
         cost_memory(memories, MemoryId<First + SumMemory::kMemories>()),
         smallest_memory(memories, MemoryId<First + SumMemory::kMemories + CostMemory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasSums) visit("read_sums", read_sums);
      visit("read_costs", read_costs);
      visit("read_smallest", read_smallest);
      if constexpr (kHasSums) visit("ready_sums", ready_sums);
      visit("ready_costs", ready_costs);
      visit("ready_smallest", ready_smallest);
      visit("ready_first", ready_first);
      visit("comes", comes);
      visit("place", place);
      visit("writes", writes);
      if constexpr (kHasSums) visit("write_sums", write_sums);
      visit("write_costs", write_costs);
      visit("write_smallest", write_smallest);
      visit("write_place", write_place);
      if constexpr (C.full_width) visit("waiting", waiting);
   }

   /// Of the column that the path from the right takes.
   HLS_INLINE PathCost<C> smallest_cost() const {
      return C.has_relief() ? PathCost<C>(ready_smallest[0] & (kSmallestMask)) : PathCost<C>(ready_smallest[0]);
   }
   HLS_INLINE Relief<C> relief() const { return Relief<C>(ready_smallest[0] >> kCostBits); }

   HLS_INLINE void clock(const PathEntry<C>& entry, const Forward& forward) {
      const bool move = entry.tag.valid;
      const auto& moves = entry.moves_turn;
      typename Sums::Word sums[Sums::kWords];
      typename Costs::Word costs[Costs::kWords];
      Smallest smallest[1];
      if constexpr (C.full_width) {
         read_all(waiting.read_place, sums, costs, smallest);
         find_read_place(entry);
      } else {
         read_all(entry.order.address, sums, costs, smallest);
      }
      if constexpr (kHasSums) sum_memory.write(write_place, write_sums);
      cost_memory.write(write_place, write_costs);
      smallest_memory.write(write_place, write_smallest);
      keep(forward);

      if constexpr (kHasSums) {
         HLS_UNROLL
         for (int w = 0; w < Sums::kWords; ++w) {
            ready_sums[w] = select<typename Sums::Word>(moves.lane(w * Sums::kPerWord), read_sums[w], ready_sums[w]);
            read_sums[w] = sums[w];
         }
      }
      HLS_UNROLL
      for (int w = 0; w < Costs::kWords; ++w) {
         ready_costs[w] = select<typename Costs::Word>(moves.lane(w * Costs::kPerWord), read_costs[w], ready_costs[w]);
         read_costs[w] = costs[w];
      }
      ready_smallest[0] = select<Smallest>(move, read_smallest[0], ready_smallest[0]);
      read_smallest[0] = smallest[0];
      if constexpr (C.full_width) {
         ready_first = select<bool>(move, waiting.first[kWaits - 1], ready_first);
         HLS_UNROLL
         for (int j = kWaits - 1; j > 0; --j)
            waiting.first[j] = select<bool>(move, waiting.first[j - 1], waiting.first[j]);
         waiting.first[0] = select<bool>(move, entry.turned.first_column, waiting.first[0]);
      } else {
         ready_first = select<bool>(move, entry.turned.first_column, ready_first);
      }

      writes.clock(entry.next_tag.valid && select<bool>(move, comes[kWriteMoves - 2], comes[kWriteMoves - 1]));
      HLS_UNROLL
      for (int j = kWriteMoves - 1; j > 0; --j) {
         comes[j] = select<bool>(move, comes[j - 1], comes[j]);
         place[j] = select<uint16_t>(move, place[j - 1], place[j]);
      }
      comes[0] = select<bool>(move, entry.tag.map_column, comes[0]);
      place[0] = select<uint16_t>(move, entry.place, place[0]);
   }

  private:
   HLS_INLINE void read_all(uint16_t address, typename Sums::Word (&sums)[Sums::kWords],
                            typename Costs::Word (&costs)[Costs::kWords], Smallest (&smallest)[1]) {
      if constexpr (kHasSums) sum_memory.read(address, sums);
      cost_memory.read(address, costs);
      smallest_memory.read(address, smallest);
   }

   /// What place[kWaits - 1] shows two clocks from now on: words are read in the clock before the move that takes them,
   /// at the address of a register. So each is read before that move's clock ends, when its successor is written.
   HLS_INLINE void find_read_place(const PathEntry<C>& entry) {
      const bool now = entry.tag.valid, next = entry.next_tag.valid;
      const uint16_t if_one = place[kWaits - 2];
      const uint16_t if_next = select<uint16_t>(now, place[kWaits - 3], if_one);
      const uint16_t if_not = select<uint16_t>(now, if_one, place[kWaits - 1]);
      waiting.read_place = select<uint16_t>(next, if_next, if_not);
   }

   HLS_INLINE void keep(const Forward& forward) {
      if constexpr (kHasSums) {
         typename Sums::Lane lanes[kCount];
         HLS_UNROLL
         for (int d = 0; d < kCount; ++d) lanes[d] = forward.sum[d];
         typename Sums::Word words[Sums::kWords];
         Sums::pack(lanes, words);
         HLS_UNROLL
         for (int w = 0; w < Sums::kWords; ++w)
            write_sums[w] = select<typename Sums::Word>(writes.lane(w * Sums::kPerWord), words[w], write_sums[w]);
      }
      typename Costs::Word words[Costs::kWords];
      Costs::pack(forward.cost[Forward::kCostMoves - 1], words);
      HLS_UNROLL
      for (int w = 0; w < Costs::kWords; ++w)
         write_costs[w] = select<typename Costs::Word>(writes.lane(w * Costs::kPerWord), words[w], write_costs[w]);
      Smallest smallest = forward.smallest_cost[kWriteMoves - Forward::kLevels - 1];
      if constexpr (C.has_relief())
         smallest = Smallest(smallest | Smallest(Smallest(forward.reliefs.moved[kWriteMoves - 1]) << kCostBits));
      write_smallest[0] = select<Smallest>(writes.lane(0), smallest, write_smallest[0]);
      write_place = select<uint16_t>(writes.lane(0), place[kWriteMoves - 1], write_place);
   }
};

}  // namespace stereo::semi_global
