// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/phase_memory.hpp"
#include "semi_global/phases.hpp"
#include "semi_global/settings.hpp"
#include "support/move_delay.hpp"

namespace stereo::semi_global {

/// The path from above, a phase a clock: what PathAbove is for all disparities at once. K is there at the stage
/// kPathCosts. Memory: map width x D x bits of P2, and kPaths x lanes x bits of a sum, LUT RAM.
template <const Config& C>
struct PhaseAbove {
   using At = Stages<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr int kStateBits = bits_for(C.p2_above());
   static constexpr int kTotalBits = bits_for(C.largest_path_above());
   static constexpr int kWords = C.output_width_px() * kPhases;
   using Pack = DeepPacked<kStateBits, kLanes, kWords>;
   using State = typename Pack::Lane;
   using Word = typename Pack::Word;
   using Value = AbovePathValue<C>;
   static constexpr Value kMask = Value((uint64_t(1) << kTotalBits) - 1);
   using Passed = uint_of_bits<bits_for(C.largest_path_above() + C.p1_above())>;
   using Memory = PhaseMemory<Word, kWords, Pack::kWords>;
   using Address = PhaseAddress<kPhases, kWords>;
   using Tree = MinimumTree<Value, kLanes>;
   using Delay = MoveDelay<kTotalBits, kLanes, At::kPaths>;
   static constexpr int kMemories = Memory::kMemories + Delay::kMemories;
   static constexpr int kReads = -Memory::kReadClocks;  ///< the address of what the row above passes on is there
   static constexpr int kWrites = At::kPathCosts + 3;   ///< and that of what the row below gets

   Memory memory;
   Address read_address;
   bool ready_top;  // beside the costs
   [[no_unique_address]] SecondPenaltyAbove<C> top_p2;
   // a clock behind them
   Value total[kLanes];
   Tree tree;
   Delay delay;
   Value smallest_total, smallest;  ///< of the phases so far; of the column
   // kPathCosts
   Value cost[kLanes];  ///< K
   // 1 clock behind it
   Value held[kLanes];
   Value lower_neighbour;  ///< K of the last lane of the phase before
   PhaseCount<kPhases> count;
   // 2, 3
   Value beside[kLanes], own[kLanes];
   [[no_unique_address]] FirstPenaltyAbove<C> p1;
   [[no_unique_address]] SecondPenaltyAbove<C> p2;
   Passed step[kLanes];
   State stay[kLanes];
   Address write_address;

   template <class Source, int First>
   HLS_INLINE PhaseAbove(Source& memories, MemoryId<First> first)
       : memory(memories, first), delay(memories, MemoryId<First + Memory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("memory", memory);
      visit("read_address", read_address);
      visit("ready_top", ready_top);
      if constexpr (C.run_time_settings) visit("top_p2", top_p2.value, C.p2_above());
      visit("total", total);
      visit("tree", tree);
      visit("delay", delay);
      visit("smallest_total", smallest_total);
      visit("smallest", smallest);
      visit("cost", cost);
      visit("held", held);
      visit("lower_neighbour", lower_neighbour);
      visit("count", count);
      visit("beside", beside);
      visit("own", own);
      if constexpr (C.run_time_settings) {
         visit("p1", p1.value, C.p1_above());
         visit("p2", p2.value, C.p2_above());
      }
      visit("step", step);
      visit("stay", stay);
      visit("write_address", write_address);
   }

   template <class Line>
   HLS_INLINE void clock(const Line& line, const PathCost<C> (&costs)[kLanes]) {
      Word passed_on[Pack::kWords];
      pass_on(line, passed_on);
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) cost[l] = Value(delay.lane(l) - smallest) & kMask;
      smallest = select<Value>(line.template is_there<At::kPaths>(), smallest_total, smallest);
      smallest_total =
          smallest_so_far<kTotalBits>(line.template is_there<1 + At::kLevels>(), tree.root(), smallest_total);
      tree.clock(total, AlwaysMoves());
      delay.clock(total, AlwaysMoves());
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const State from_above = select<State>(ready_top, top_p2.get(), Pack::lane(memory.ready_words, l));
         total[l] = Value(from_above + costs[l]);
      }
      ready_top = select<bool>(line.template starts<-1>() & line.template at<-1>().first_column,
                               line.template at<-1>().top, ready_top);
      read_address.go_on(line.template starts<kReads - 1>(), line.template at<kReads - 1>().first_column);
      memory.clock(read_address.address, write_address.is_here, write_address.address, passed_on);
      write_address.go_on(line.template starts<kWrites - 1>(), line.template at<kWrites - 1>().first_column);
   }

   /// Behind clock().
   template <class Line, class Settings>
   HLS_INLINE void take(const Line& line, const Settings& settings) {
      uint16_t p1_now = 0, p2_now = 0;
      if constexpr (C.has_penalties_above()) {
         p1_now = settings.above_p1;
         p2_now = settings.above_p2;
      } else {
         p1_now = settings.p1;
         p2_now = settings.p2;
      }
      const bool enters = starts_frame<-1>(line), leaves = starts_frame<At::kPathCosts + 1>(line);
      top_p2.take(enters, p2_now);
      p1.take(leaves, p1_now);
      p2.take(leaves, p2_now);
   }

  private:
   template <int Stage, class Line>
   static HLS_INLINE bool starts_frame(const Line& line) {
      const auto& place = line.template at<Stage>();
      return line.template starts<Stage>() & place.first_column & place.top;
   }

   /// Neighbours, penalty, minimum.
   template <class Line>
   HLS_INLINE void pass_on(const Line& line, Word (&passed_on)[Pack::kWords]) {
      State lanes[kLanes];
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) lanes[l] = State(select<Passed>(step[l] < stay[l], step[l], stay[l]));
      Pack::pack(lanes, passed_on);
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         step[l] = Passed(beside[l] + p1.get());
         stay[l] = State(select<Value>(own[l] > p2.get(), p2.get(), own[l]));
         beside[l] = smaller_of<Value>(lower(l), upper(l));
         own[l] = held[l];
      }
      lower_neighbour = held[kLanes - 1];
      count.clock(line.template starts<At::kPathCosts>());
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) held[l] = cost[l];
   }
   /// K beside lane l; at an end of the disparity range that on the other side.
   HLS_INLINE Value lower(int l) const {
      if (l > 0) return held[l > 0 ? l - 1 : 0];
      return select<Value>(count.is_first(), held[1], lower_neighbour);
   }
   HLS_INLINE Value upper(int l) const {
      if (l < kLanes - 1) return held[l < kLanes - 1 ? l + 1 : 0];
      return select<Value>(count.is_last(), held[kLanes - 2], cost[0]);
   }
};

}  // namespace stereo::semi_global
