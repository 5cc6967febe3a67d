// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/path_above.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/row_path.hpp"
#include "support/minimum_tree.hpp"
#include "support/move_delay.hpp"
#include "support/optional_block.hpp"

namespace stereo::semi_global {

/// Where the first column of a frame is, for paths that take over its settings.
template <int Moves>
struct FrameStarts {
   bool moved[Moves];  ///< [j]: it is the column of j+1 moves ago

   HLS_INLINE FrameStarts() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("moved", moved);
   }
};

/// The reliefs of the columns on their way to the paths.
template <const Config& C, int Moves>
struct ReliefMoves {
   Relief<C> moved[Moves];  ///< [j]: of the column of j+1 moves ago

   HLS_INLINE ReliefMoves() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("moved", moved);
   }

   HLS_INLINE void clock(bool move, Relief<C> entered) {
      HLS_UNROLL
      for (int j = Moves - 1; j > 0; --j) moved[j] = select<Relief<C>>(move, moved[j - 1], moved[j]);
      moved[0] = select<Relief<C>>(move, entered, moved[0]);
   }
};

/// The paths that go with the stream, from the left and from above, and their sum, kMoves moves behind the costs.
/// Beside it come the costs and the smallest of them, for the path from the right. Memory: (levels + 1) x D x bits of a
/// cost, LUT RAM, and that of the path from above.
template <const Config& C>
struct ForwardPaths {
   static constexpr int kCount = C.disparities;
   using Tree = MinimumTree<PathCost<C>, kCount>;
   static constexpr int kLevels = Tree::kLevels;
   static constexpr bool kHasSmallest = C.path_left || C.path_right;
   using Left = RowPath<C>;
   using Above = Optional<C.path_above, PathAbove<C>>;
   using CostDelay = Optional<kHasSmallest, MoveDelay<C.cost_bits(), kCount, kLevels + 1>>;
   static constexpr int kPathMoves = kLevels + Left::kMoves;
   static_assert(!C.path_above || PathAbove<C>::kMoves == kPathMoves, "the paths must meet");
   static constexpr int kMoves = kPathMoves + 1;
   static constexpr int kMemories = CostDelay::kMemories + Above::kMemories;
   /// From the costs that enter the row path to the sum.
   static constexpr int kCostMoves = kMoves - (kLevels + 1);

   Tree smallest;
   CostDelay cost_delay;
   Left left;
   Above above;
   ForwardSum<C> sum[kCount];
   // Beside them. [age]: of the column that entered age+1 moves ago, or of the one whose costs left the delay age+1
   // moves ago, or of the one whose smallest cost left its tree then.
   bool first[kMoves];
   [[no_unique_address]] std::conditional_t<C.run_time_settings, FrameStarts<kPathMoves>, NoSettings> starts;
   [[no_unique_address]] std::conditional_t<C.has_relief(), ReliefMoves<C, (C.path_right ? kMoves : kLevels - 1)>,
                                            NoSettings>
       reliefs;
   PathCost<C> cost[kCostMoves][kCount];
   PathCost<C> smallest_cost[kMoves - kLevels];

   template <class Source, int First>
   HLS_INLINE ForwardPaths(Source& memories, MemoryId<First> number)
       : cost_delay(memories, number), above(memories, MemoryId<First + CostDelay::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasSmallest) visit("smallest", smallest);
      if constexpr (kHasSmallest) visit("cost_delay", cost_delay);
      if constexpr (C.path_left) visit("left", left);
      if constexpr (C.path_above) visit("above", above);
      visit("sum", sum);
      visit("first", first);
      if constexpr (C.run_time_settings) visit("starts", starts);
      if constexpr (C.has_relief()) visit("reliefs", reliefs);
      visit("cost", cost);
      visit("smallest_cost", smallest_cost);
   }

   /// relief: where P2 falls, that of the entry's column.
   template <class Settings>
   HLS_INLINE void clock(const PathEntry<C>& entry, const Settings& settings, Relief<C> relief = 0) {
      const bool move = entry.tag.valid;
      add(entry.moves_costs);
      if constexpr (C.has_relief()) {
         if constexpr (C.path_left)
            left.clock(entry.moves_left, smallest.root(), first[kLevels - 1], cost[0], reliefs.moved[kLevels - 2]);
         reliefs.clock(move, relief);
      } else if constexpr (C.path_left) {
         left.clock(entry.moves_left, smallest.root(), first[kLevels - 1], cost[0]);
      }
      if constexpr (C.path_above) above.clock(entry);
      if constexpr (C.run_time_settings) take(entry.tag, settings);
      if constexpr (kHasSmallest) keep_costs(entry);
      HLS_UNROLL
      for (int age = kMoves - 1; age > 0; --age) first[age] = select<bool>(move, first[age - 1], first[age]);
      first[0] = select<bool>(move, entry.tag.first_column, first[0]);
   }

  private:
   template <class Settings>
   HLS_INLINE void take(const PixelTag& tag, const Settings& settings) {
      const bool move = tag.valid;
      if constexpr (C.path_left) left.take(move & starts.moved[kLevels - 2], settings);
      if constexpr (C.path_above)
         above.take(move & tag.start_of_frame, move & starts.moved[PathAbove<C>::kMoves - 1], settings);
      HLS_UNROLL
      for (int j = kPathMoves - 1; j > 0; --j)
         starts.moved[j] = select<bool>(move, starts.moved[j - 1], starts.moved[j]);
      starts.moved[0] = select<bool>(move, tag.start_of_frame, starts.moved[0]);
   }

   template <class Move>
   HLS_INLINE void add(const Move& moves) {
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         ForwardSum<C> total = 0;
         if constexpr (C.path_left) total = ForwardSum<C>(total + left.cost[d]);
         if constexpr (C.path_left && C.takes_relief_off()) total = ForwardSum<C>(total - left.relief.shown());
         if constexpr (C.path_above) total = ForwardSum<C>(total + above.cost[d]);
         sum[d] = select<ForwardSum<C>>(moves.lane(d), total & kMask, sum[d]);
      }
   }

   HLS_INLINE void keep_costs(const PathEntry<C>& entry) {
      const bool move = entry.tag.valid;
      const auto& moves = entry.moves_costs;
      HLS_UNROLL
      for (int age = kMoves - kLevels - 1; age > 0; --age)
         smallest_cost[age] = select<PathCost<C>>(move, smallest_cost[age - 1], smallest_cost[age]);
      smallest_cost[0] = select<PathCost<C>>(move, smallest.root(), smallest_cost[0]);
      smallest.clock(entry.cost, moves);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         HLS_UNROLL
         for (int age = kCostMoves - 1; age > 0; --age)
            cost[age][d] = select<PathCost<C>>(moves.lane(d), cost[age - 1][d], cost[age][d]);
         cost[0][d] = select<PathCost<C>>(moves.lane(d), cost_delay.lane(d), cost[0][d]);
      }
      cost_delay.clock(entry.cost, moves);
   }

   static constexpr ForwardSum<C> kMask = ForwardSum<C>((uint64_t(1) << bits_for(C.largest_forward_sum())) - 1);
};

}  // namespace stereo::semi_global
