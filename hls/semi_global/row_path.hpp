// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/path_relief.hpp"
#include "semi_global/settings.hpp"
#include "support/fan_out.hpp"
#include "support/minimum_tree.hpp"

namespace stereo::semi_global {

/// A path along a row: K of the column whose smallest cost came kMoves moves ago.
///
/// The loop of K and A takes one move: a comparison, a multiplexer and an addition. What the definition takes from the
/// best path look_back_columns() ago has all moves between: the tree of minima, q, g, the changes. All numbers are
/// unsigned: K and A have a bias of half their range, so that their highest bit says that they are not below 0.
template <const Config& C>
struct RowPath {
   static constexpr int kCount = C.disparities;
   static constexpr int kBits = C.row_path_bits();
   static constexpr int kBias = C.row_path_bias();
   static constexpr int kLookBack = C.look_back_columns();
   static constexpr int kMoves = 4;
   using Value = RowPathValue<C>;
   static constexpr Value kMask = Value((1 << kBits) - 1);
   using Start = uint_of_bits<bits_for(C.p2)>;
   /// The smallest cost; with reliefs also what they change in this column.
   using Smallest = std::conditional_t<C.has_relief(), Value, PathCost<C>>;

   /// The smaller of K(d-1) and K(d+1) is needed anyway: every other pair of them, and what is left at the end, covers
   /// all disparities.
   static constexpr int kPairs = (kCount + 1) / 2;
   using Tree = MinimumTree<Value, kPairs>;
   // pairs 1, tree, then moves 1 to 4 below
   static_assert(1 + Tree::kLevels + kMoves == kLookBack, "the pipeline decides how far the definition looks back");

   Value pair[kPairs];
   Tree tree;
   // move 1
   [[no_unique_address]] FirstPenalty<C> p1;  ///< of the column that comes in
   [[no_unique_address]] SecondPenalty<C> p2;
   Start start_cost[kLookBack - 1];  ///< [j]: q of this column and of those before
   Start room;                       ///< P2 less the q of the last kLookBack-1 columns, for the next column
   Smallest smallest;
   Value smallest_less;  ///< less P1
   bool first[3];        ///< [j]: the column of move j+1 is the first of its row
   [[no_unique_address]] std::conditional_t<C.has_relief(), PathRelief<C>, NoSettings> relief;
   // move 2
   FanOut<Value, kCount> g, g_less;
   // move 3
   Value stay_change[kCount], step_change[kCount];  ///< c - g, c - g + P1
   // move 4
   Value cost[kCount], arrived[kCount];  ///< K and A

   HLS_INLINE RowPath() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("pair", pair);
      visit("tree", tree);
      if constexpr (C.run_time_settings) {
         visit("p1", p1.value, C.p1);
         visit("p2", p2.value, C.p2);
      }
      visit("start_cost", start_cost);
      visit("room", room);
      visit("smallest", smallest);
      visit("smallest_less", smallest_less);
      visit("first", first);
      if constexpr (C.has_relief()) visit("relief", relief);
      visit("g", g);
      visit("g_less", g_less);
      visit("stay_change", stay_change);
      visit("step_change", step_change);
      visit("cost", cost);
      visit("arrived", arrived);
   }

   /// smallest_in, first_in: of a column, whose costs are costs_in two moves later. next_relief: of the column behind
   /// it.
   template <class Move>
   HLS_INLINE void clock(const Move& moves, PathCost<C> smallest_in, bool first_in,
                         const PathCost<C> (&costs_in)[kCount], Relief<C> next_relief = 0) {
      const bool move = moves.lane(0);
      const Value lowest = tree.root();
      tree.clock(pair, moves);
      scan(moves);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         const Value c = costs_in[d];
         stay_change[d] = select<Value>(moves.lane(d), Value(c - g.get(d)) & kMask, stay_change[d]);
         step_change[d] = select<Value>(moves.lane(d), Value(c - g_less.get(d)) & kMask, step_change[d]);
      }
      g.move(moves, Value(smallest + start_cost[0]) & kMask);
      g_less.move(moves, Value(smallest_less + start_cost[0]) & kMask);
      if constexpr (C.has_relief()) {
         const Value change = Value(relief.here(first_in) - next_relief);
         smallest = select<Value>(move, Value(smallest_in + change) & kMask, smallest);
         smallest_less = select<Value>(move, Value(Value(smallest_in - p1.get()) + change) & kMask, smallest_less);
         find_start(move, lowest, first_in, next_relief);
      } else {
         find_start(move, lowest, first_in);
         smallest = select<PathCost<C>>(move, smallest_in, smallest);
         smallest_less = select<Value>(move, Value(smallest_in - p1.get()) & kMask, smallest_less);
      }
      HLS_UNROLL
      for (int j = 2; j > 0; --j) first[j] = select<bool>(move, first[j - 1], first[j]);
      first[0] = select<bool>(move, first_in, first[0]);
   }

   /// Behind clock(). frame_follows: the next column that comes in is the first of a frame.
   template <class Settings>
   HLS_INLINE void take(bool frame_follows, const Settings& settings) {
      if constexpr (C.run_time_settings) {
         p1.take(frame_follows, settings.p1);
         p2.take(frame_follows, settings.p2);
      }
   }

  private:
   /// K and A of the next column, and the pairs of this one.
   template <class Move>
   HLS_INLINE void scan(const Move& moves) {
      Value step[kCount], next_cost[kCount], next_arrived[kCount];
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         step[d] = smaller_of<Value>(cost[d > 0 ? d - 1 : 1], cost[d < kCount - 1 ? d + 1 : kCount - 2]);
         const Value best = smaller_of<Value>(cost[d], arrived[d]);
         const bool fresh = first[2] || best >= kBias;
         const Value stay = select<Value>(fresh, kBias, best);
         next_cost[d] = Value(stay + stay_change[d]) & kMask;
         next_arrived[d] = Value(select<Value>(first[2], kBias, step[d]) + step_change[d]) & kMask;
      }
      HLS_UNROLL
      for (int i = 0; i < kPairs; ++i) {
         // Four disparities from 4j on: step[4j+1] and step[4j+2] cover them.
         const int at = 4 * (i / 2) + 1 + i % 2;
         const int left = kCount - 4 * (i / 2);  // from 4j on
         const Value lowest = left == 1                 ? cost[kCount - 1]
                              : left == 2               ? smaller_of<Value>(cost[kCount - 2], cost[kCount - 1])
                              : left == 3 && i % 2 == 1 ? cost[kCount - 2]
                                                        : step[at < kCount ? at : 0];
         pair[i] = select<Value>(moves.lane(2 * i), lowest, pair[i]);
      }
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         cost[d] = select<Value>(moves.lane(d), next_cost[d], cost[d]);
         arrived[d] = select<Value>(moves.lane(d), next_arrived[d], arrived[d]);
      }
   }

   /// The same where P2 falls: a column's fresh start may rise until it is P2 above the best path of then, and above
   /// the cheapest fresh start since then. Each way has its own sums, made beside the comparisons that choose among
   /// them.
   HLS_INLINE void find_start(bool move, Value lowest, bool first_in, Relief<C> next_relief) {
      const bool lost = lowest >= kBias;  // the best path is no better than the fresh start was
      const uint32_t below = uint32_t(lowest & (kBias - 1));
      const bool by_start = lost | (relief.beyond + below >= uint32_t(kBias));
      const bool start_rises = room >= relief.largest;
      const uint32_t reached = relief.reach_of_best + below;  // with twice the bias
      const bool best_rises = reached >= 2u * kBias;
      const Start q_start = select<Start>(start_rises, Start(room - relief.largest) & kStartMask, 0);
      const Start q_best = select<Start>(best_rises, Start(reached - 2 * kBias) & kStartMask, 0);
      const Start q = select<Start>(first_in, p2.get(), select<Start>(by_start, q_start, q_best));
      // What is left of P2 behind this column: the room, and how far the best path may rise before the start does.
      const uint32_t leaves = start_cost[kLookBack - 2];
      const Start room_after = Start(chosen(by_start, start_rises, relief.largest + leaves, best_rises,
                                            relief.room_of_best - below, room + leaves) &
                                     kStartMask);
      const uint32_t reach_after = chosen(by_start, start_rises, relief.largest + relief.leaves, best_rises,
                                          relief.reach_again - below, room + relief.leaves);
      relief.clock(move, first_in, next_relief, reach_after, start_cost[kLookBack - 3]);
      room = select<Start>(move, select<Start>(first_in, 0, room_after), room);
      HLS_UNROLL
      for (int j = kLookBack - 2; j > 0; --j)
         start_cost[j] = select<Start>(move, select<Start>(first_in, 0, start_cost[j - 1]), start_cost[j]);
      start_cost[0] = select<Start>(move, q, start_cost[0]);
   }

   /// What follows from the fresh start where it rises or not, else from the best path.
   static HLS_INLINE uint32_t chosen(bool by_start, bool start_rises, uint32_t risen_start, bool best_rises,
                                     uint32_t risen_best, uint32_t neither) {
      return select<uint32_t>(by_start, select<uint32_t>(start_rises, risen_start, neither),
                              select<uint32_t>(best_rises, risen_best, neither));
   }

   /// q. Until the tree shows a column of this row, `room` is 0, and so is q.
   HLS_INLINE void find_start(bool move, Value lowest, bool first_in) {
      const bool lost = lowest >= kBias;  // the best path is no better than a fresh start
      const uint32_t below = uint32_t(lowest & (kBias - 1));
      const uint32_t reached = uint32_t(room) + below;  // room - (kBias - below), biased
      const bool short_of = reached >= uint32_t(kBias);
      const Start missing = Start(select<uint32_t>(short_of, reached - kBias, 0));
      const Start wanted = select<Start>(lost, room, missing);
      const Start rest = select<Start>(short_of, Start(kBias - below), room);  // room - q
      const Start q = select<Start>(first_in, p2.get(), wanted);
      const Start room_left = select<Start>(lost, 0, rest);
      const Start room_after = Start((room_left + start_cost[kLookBack - 2]) & kStartMask);
      room = select<Start>(move, select<Start>(first_in, 0, room_after), room);
      HLS_UNROLL
      for (int j = kLookBack - 2; j > 0; --j)
         start_cost[j] = select<Start>(move, select<Start>(first_in, 0, start_cost[j - 1]), start_cost[j]);
      start_cost[0] = select<Start>(move, q, start_cost[0]);
   }
   static constexpr Start kStartMask = Start((uint64_t(1) << bits_for(C.p2)) - 1);
};

}  // namespace stereo::semi_global
