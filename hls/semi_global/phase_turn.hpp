// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/phase_memory.hpp"
#include "semi_global/phases.hpp"
#include "support/memory_bank.hpp"
#include "support/optional_block.hpp"

namespace stereo::semi_global {

/// Turns rows round for the path from the right, a phase a clock: what RowTurn is for all disparities at once. Costs of
/// the row before come out at the stage kPaths, its sums at kPathCosts, and a column's smallest cost a clock before its
/// costs. Memory: map width x (D x (bits of a sum + bits of a cost) + bits of a cost), and one place more of the
/// latter.
///
/// No word that counts is read in the clock in which it is written, so the memories need no bypass. The last column of
/// a row is the first one of it that is read, at any time after it was written: the last costs and sums go on being
/// written until the next ones come, less than F clocks after the next column's are read. A smallest cost is written
/// once.
template <const Config& C>
struct PhaseTurn {
   using At = Stages<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kWords = kWidth * kPhases;
   static constexpr bool kHasSums = C.path_left || C.path_above;
   using Sums = DeepPacked<bits_for(C.largest_forward_sum()), kLanes, kWords>;
   using Costs = DeepPacked<C.cost_bits(), kLanes, kWords>;
   static constexpr int kBankBits = kPhases == 4 ? 16 : 12;  ///< with four phases reads have no clock for a choice
   using SumMemory = Optional<kHasSums, PhaseMemory<typename Sums::Word, kWords, Sums::kWords, kBankBits>>;
   using CostMemory = PhaseMemory<typename Costs::Word, kWords, Costs::kWords, kBankBits>;
   static constexpr uint16_t kNoPlace = kWidth;
   using SmallestMemory = MemoryBank<PathCost<C>, kWidth + 1, 1>;
   static constexpr int kMemories = SumMemory::kMemories + CostMemory::kMemories + SmallestMemory::kMemories;
   using Address = PhaseAddress<kPhases, kWords>;
   /// Of costs; sums follow them two clocks later.
   static constexpr int kReads = At::kPaths - CostMemory::kReadClocks;
   static constexpr int kWrites = At::kPaths + 1;
   static_assert(kWrites - kReads < kPhases, "the last word of a row would be read while it is written");
   static constexpr int kReadsSmallest = At::kPaths - 3;

   SumMemory sum_memory;
   CostMemory cost_memory;
   SmallestMemory smallest_memory;
   uint16_t smallest_address;
   PathCost<C> read_smallest[1], ready_smallest[1];
   Address read_address;
   uint16_t sum_read_address;
   // what is written
   PathCost<C> write_smallest[1];
   uint16_t write_smallest_address;
   Address write_address;
   uint16_t sum_write_address[2];
   bool writes_sums[2];

   template <class Source, int First>
   HLS_INLINE PhaseTurn(Source& memories, MemoryId<First> first)
       : sum_memory(memories, first),
         cost_memory(memories, MemoryId<First + SumMemory::kMemories>()),
         smallest_memory(memories, MemoryId<First + SumMemory::kMemories + CostMemory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasSums) visit("sum_memory", sum_memory);
      visit("cost_memory", cost_memory);
      visit("smallest_address", smallest_address);
      visit("read_smallest", read_smallest);
      visit("ready_smallest", ready_smallest);
      visit("read_address", read_address);
      if constexpr (kHasSums) visit("sum_read_address", sum_read_address);
      visit("write_smallest", write_smallest);
      visit("write_smallest_address", write_smallest_address);
      visit("write_address", write_address);
      if constexpr (kHasSums) visit("sum_write_address", sum_write_address);
      if constexpr (kHasSums) visit("writes_sums", writes_sums);
   }

   HLS_INLINE void costs(PathCost<C> (&out)[kLanes]) const {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) out[l] = PathCost<C>(Costs::lane(cost_memory.ready_words, l));
   }
   HLS_INLINE typename Sums::Lane sum(int lane) const { return Sums::lane(sum_memory.ready_words, lane); }

   /// smallest_cost: of the column whose costs begin in the next clock; sums: of the forward paths, beside K of the
   /// paths.
   template <class Line>
   HLS_INLINE void clock(const Line& line, PathCost<C> smallest_cost, const PathCost<C> (&costs_in)[kLanes],
                         [[maybe_unused]] const ForwardSum<C> (&sums)[kLanes]) {
      turn_smallest(line, smallest_cost);
      if constexpr (kHasSums) turn_sums(sums);
      typename Costs::Word packed[Costs::kWords];
      Costs::pack(costs_in, packed);
      read_address.clock(line.template starts<kReads - 1>(), base(line.template at<kReads - 1>().address));
      cost_memory.clock(read_address.address, write_address.is_here, write_address.address, packed);
      write_address.clock(line.template starts<At::kPaths - 1>(), base(line.template at<At::kPaths - 1>().address));
   }

  private:
   static HLS_INLINE uint16_t base(uint16_t column) { return uint16_t(column * kPhases); }

   template <class Line>
   HLS_INLINE void turn_smallest(const Line& line, PathCost<C> smallest_cost) {
      PathCost<C> stored[1];
      smallest_memory.read(smallest_address, stored);
      smallest_memory.write(write_smallest_address, write_smallest);
      write_smallest[0] = smallest_cost;
      write_smallest_address = select<uint16_t>(line.template starts<At::kPaths - 1>(),
                                                line.template at<At::kPaths - 1>().address, kNoPlace);
      ready_smallest[0] = read_smallest[0];
      read_smallest[0] = stored[0];
      smallest_address = select<uint16_t>(line.template starts<kReadsSmallest - 1>(),
                                          line.template at<kReadsSmallest - 1>().address, smallest_address);
   }

   HLS_INLINE void turn_sums(const ForwardSum<C> (&sums)[kLanes]) {
      typename Sums::Word packed[Sums::kWords];
      Sums::pack(sums, packed);
      sum_memory.clock(sum_read_address, writes_sums[1], sum_write_address[1], packed);
      sum_read_address = read_address.address;
      sum_write_address[1] = sum_write_address[0];
      sum_write_address[0] = write_address.address;
      writes_sums[1] = writes_sums[0];
      writes_sums[0] = write_address.is_here;
   }
};

}  // namespace stereo::semi_global
