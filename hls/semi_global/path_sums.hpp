// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "semi_global/config.hpp"
#include "semi_global/forward_paths.hpp"
#include "semi_global/map_place.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/row_path.hpp"
#include "semi_global/row_turn.hpp"
#include "support/move_delay.hpp"
#include "support/optional_block.hpp"

namespace stereo::semi_global {

/// The tags of the columns beside kMoves moves of a path; behind them clocks count again, and a column is valid for
/// one.
template <int Moves>
struct TagMoves {
   MapPlace held[Moves];  ///< [j]: of j+1 moves ago
   bool moved;

   HLS_INLINE TagMoves() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("held", held);
      visit("moved", moved);
   }

   HLS_INLINE void clock(bool move, const PixelTag& in) {
      HLS_UNROLL
      for (int j = Moves - 1; j > 0; --j) take(held[j], held[j - 1], move);
      take(held[0], in, move);
      moved = move;
   }
   HLS_INLINE PixelTag out() const {
      const MapPlace& place = held[Moves - 1];
      PixelTag tag;
      tag.valid = moved;
      tag.map_column = place.map_column;
      tag.output_column = place.output_column;
      tag.first_column = place.first_column;
      tag.start_of_frame = place.start_of_frame;
      tag.end_of_line = place.end_of_line;
      return tag;
   }

  private:
   template <class Place>
   static HLS_INLINE void take(MapPlace& to, const Place& from, bool move) {
      to.map_column = select<bool>(move, from.map_column, to.map_column);
      to.output_column = select<bool>(move, from.output_column, to.output_column);
      to.first_column = select<bool>(move, from.first_column, to.first_column);
      to.start_of_frame = select<bool>(move, from.start_of_frame, to.start_of_frame);
      to.end_of_line = select<bool>(move, from.end_of_line, to.end_of_line);
   }
};

/// The sums of all paths where none comes from the right: those of the forward paths.
template <const Config& C>
struct ForwardSums {
   static constexpr int kMemories = 0;
   static constexpr int kClocks = 2;
   static constexpr int kLagGroups = ForwardPaths<C>::kMoves - 1;
   using Value = WindowCost<kSumConfig<C>>;

   Value sum[1][C.disparities];
   PixelTag tag;
   TagMoves<ForwardPaths<C>::kMoves> tags;

   template <class Source, int First>
   HLS_INLINE ForwardSums(Source&, MemoryId<First>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("sum", sum);
      visit("tag", tag);
      visit("tags", tags);
   }

   template <class Settings>
   HLS_INLINE void clock(const PathEntry<C>& entry, const ForwardPaths<C>& forward, const Settings&) {
      HLS_UNROLL
      for (int d = 0; d < C.disparities; ++d) sum[0][d] = forward.sum[d];
      tag = tags.out();
      tags.clock(entry.tag.valid, entry.tag);
   }
};

/// The sums of all paths where one comes from the right: rows come out of it a row later, from their last column to
/// their first. Memory: that of RowTurn, and 5 x D x bits of a sum, LUT RAM.
template <const Config& C>
struct TurnedSums {
   static constexpr int kCount = C.disparities;
   using Turn = RowTurn<C>;
   using Right = RowPath<C>;
   static constexpr bool kHasSums = Turn::kHasSums;
   /// Moves from the words that have been read to K of the path.
   static constexpr int kMoves = Turn::kMoves + Right::kMoves;
   using SumDelay = Optional<kHasSums, MoveDelay<bits_for(C.largest_forward_sum()), kCount, Right::kMoves>>;
   static constexpr int kMemories = Turn::kMemories + SumDelay::kMemories;
   static constexpr int kClocks = 2;
   static constexpr int kLagGroups = C.width_px + kMoves - 1;
   using Value = WindowCost<kSumConfig<C>>;

   Turn turn;
   PathCost<C> cost[2][kCount];  ///< [age]: beside the path's first moves
   Right right;
   SumDelay sum_delay;
   Value sum[1][kCount];
   PixelTag tag;
   TagMoves<kMoves> tags;

   template <class Source, int First>
   HLS_INLINE TurnedSums(Source& memories, MemoryId<First> first)
       : turn(memories, first), sum_delay(memories, MemoryId<First + Turn::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("turn", turn);
      visit("cost", cost);
      visit("right", right);
      if constexpr (kHasSums) visit("sum_delay", sum_delay);
      visit("sum", sum);
      visit("tag", tag);
      visit("tags", tags);
   }

   template <class Settings>
   HLS_INLINE void clock(const PathEntry<C>& entry, const ForwardPaths<C>& forward, const Settings& settings) {
      const bool move = entry.tag.valid;
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         Value total = right.cost[d];
         if constexpr (C.takes_relief_off()) total = Value(total - right.relief.shown());
         if constexpr (kHasSums) total = Value(total + sum_delay.lane(d));
         sum[0][d] = total & kMask;
      }
      tag = tags.out();
      bool frame_follows = entry.turned.start_of_frame;
      if constexpr (Turn::kWaits > 0) frame_follows = tags.held[Turn::kWaits - 1].start_of_frame;
      tags.clock(move, entry.turned);
      const auto& moves = entry.moves_right;
      if constexpr (C.has_relief()) right.clock(moves, turn.smallest_cost(), turn.ready_first, cost[1], turn.relief());
      else right.clock(moves, turn.ready_smallest[0], turn.ready_first, cost[1]);
      if constexpr (C.run_time_settings) right.take(move & frame_follows, settings);
      if constexpr (kHasSums) {
         typename SumDelay::Lane lanes[kCount];
         HLS_UNROLL
         for (int d = 0; d < kCount; ++d) lanes[d] = Turn::Sums::lane(turn.ready_sums, d);
         sum_delay.clock(lanes, moves);
      }
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         cost[1][d] = select<PathCost<C>>(moves.lane(d), cost[0][d], cost[1][d]);
         cost[0][d] = select<PathCost<C>>(moves.lane(d), Turn::Costs::lane(turn.ready_costs, d), cost[0][d]);
      }
      turn.clock(entry, forward);
   }

  private:
   static constexpr Value kMask = Value((uint64_t(1) << bits_for(C.largest_sum())) - 1);
};

template <const Config& C>
using PathSums = std::conditional_t<C.path_right, TurnedSums<C>, ForwardSums<C>>;

}  // namespace stereo::semi_global
