// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/phase_above.hpp"
#include "semi_global/phase_costs.hpp"
#include "semi_global/phase_row_path.hpp"
#include "semi_global/phase_turn.hpp"
#include "support/move_delay.hpp"
#include "support/optional_block.hpp"

namespace stereo::semi_global {

/// All paths and their sum, a phase a clock: what PathEntry, ForwardPaths and PathSums are for all disparities at once.
/// Memory: kPaths x lanes x bits of a cost, LUT RAM, and those of the paths and of the turn.
template <const Config& C>
struct PhasePaths {
   using At = Stages<C>;
   static constexpr int kLanes = At::kLanes;
   static constexpr bool kHasRows = C.path_left || C.path_right;
   using Tree = MinimumTree<PathCost<C>, kLanes>;
   using CostDelay = Optional<kHasRows, MoveDelay<C.cost_bits(), kLanes, At::kPaths>>;
   using Left = Optional<C.path_left, PhaseRowPath<C>>;
   using Above = Optional<C.path_above, PhaseAbove<C>>;
   using Turn = Optional<C.path_right, PhaseTurn<C>>;
   using Right = Optional<C.path_right, PhaseRowPath<C, true>>;
   static constexpr int kMemories =
       CostDelay::kMemories + Left::kMemories + Above::kMemories + Turn::kMemories + Right::kMemories;
   static constexpr int kClocks = At::kSums;
   static constexpr int kLagGroups = C.path_right ? C.width_px : 0;
   using Sum = WindowCost<kSumConfig<C>>;

   Tree tree;
   PathCost<C> smallest_cost;  ///< of the phases so far
   CostDelay cost_delay;
   Left left;
   Above above;
   ForwardSum<C> forward[kLanes];  ///< without a path from the right
   Turn turn;
   Right right;
   Sum sum[kLanes];

   template <class Source, int First>
   HLS_INLINE PhasePaths(Source& memories, MemoryId<First>)
       : cost_delay(memories, MemoryId<First>()),
         left(memories, MemoryId<First + CostDelay::kMemories>()),
         above(memories, MemoryId<First + CostDelay::kMemories + Left::kMemories>()),
         turn(memories, MemoryId<First + CostDelay::kMemories + Left::kMemories + Above::kMemories>()),
         right(memories,
               MemoryId<First + CostDelay::kMemories + Left::kMemories + Above::kMemories + Turn::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasRows) {
         visit("tree", tree);
         visit("smallest_cost", smallest_cost);
         visit("cost_delay", cost_delay);
      }
      if constexpr (C.path_left) visit.block("left", left);
      if constexpr (C.path_above) visit.block("above", above);
      if constexpr (!C.path_right) visit("forward", forward);
      if constexpr (C.path_right) {
         visit.block("turn", turn);
         visit.block("right", right);
         visit("sum", sum);
      }
   }

   /// Of all paths, at the stage kSums.
   HLS_INLINE Sum shown(int lane) const {
      if constexpr (C.path_right) return sum[lane];
      else return forward[lane];
   }

   template <class Line, class Settings, class Reliefs>
   HLS_INLINE void clock(const PhaseCosts<C>& costs, const Line& line, [[maybe_unused]] const Settings& settings,
                         const Reliefs& relief) {
      if constexpr (C.path_right) {
         add_right();
         PathCost<C> late_costs[kLanes], turned_costs[kLanes];
         ForwardSum<C> sums[kLanes];
         delayed(late_costs);
         add_forward(sums);
         turn.costs(turned_costs);
         right.clock(line, turn.ready_smallest[0], turned_costs, relief);
         if constexpr (C.run_time_settings) right.take(line, settings);
         turn.clock(line, smallest_cost, late_costs, sums);
      } else {
         add_forward(forward);
      }
      if constexpr (C.path_above) above.clock(line, costs.cost);
      if constexpr (C.path_above && C.run_time_settings) above.take(line, settings);
      if constexpr (C.path_left) {
         PathCost<C> late_costs[kLanes];
         delayed(late_costs);
         left.clock(line, smallest_cost, late_costs, relief);
         if constexpr (C.run_time_settings) left.take(line, settings);
      }
      if constexpr (kHasRows) {
         smallest_cost =
             smallest_so_far<C.cost_bits()>(line.template is_there<At::kLevels>(), tree.root(), smallest_cost);
         tree.clock(costs.cost, AlwaysMoves());
         cost_delay.clock(costs.cost, AlwaysMoves());
      }
   }

  private:
   HLS_INLINE void delayed(PathCost<C> (&out)[kLanes]) const {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) out[l] = cost_delay.lane(l);
   }

   HLS_INLINE void add_forward(ForwardSum<C> (&sums)[kLanes]) const {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         ForwardSum<C> total = 0;
         if constexpr (C.path_left) total = ForwardSum<C>(total + left.cost[l]);
         if constexpr (C.path_above) total = ForwardSum<C>(total + above.cost[l]);
         sums[l] = total & kForwardMask;
      }
   }

   HLS_INLINE void add_right() {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         Sum total = right.cost[l];
         if constexpr (PhaseTurn<C>::kHasSums) total = Sum(total + turn.sum(l));
         sum[l] = total & kMask;
      }
   }

   static constexpr ForwardSum<C> kForwardMask = ForwardSum<C>((uint64_t(1) << bits_for(C.largest_forward_sum())) - 1);
   /// No less than 8 bits: of narrower comparisons the tool makes chains of look-up tables, which are slower than carry
   /// chains.
   static constexpr int kSumBits = bits_for(C.largest_sum()) > 8 ? bits_for(C.largest_sum()) : 8;
   static constexpr Sum kMask = Sum((uint64_t(1) << kSumBits) - 1);
};

}  // namespace stereo::semi_global
