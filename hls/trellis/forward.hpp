// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/path_entry.hpp"
#include "trellis/settings.hpp"

namespace stereo::trellis {

/// The decision of a state in a column. A near and a far drop say how far the disparity is to fall.
enum Decision : uint8_t { kStay = 0, kNearDrop = 1, kFarDrop = 2, kOccluded = 3 };

/// The forward pass: E and the decision of the column that came in kMoves moves ago.
///
/// The loop of E takes one move: three comparisons side by side, a multiplexer, an addition. For that, E is also kept
/// with the cost of the next column on top, and with the cost of an occlusion; P only with the next cost. Numbers are
/// modulo 2^path_bits().
template <const Config& C>
struct Forward {
   static constexpr int kCount = C.disparities;
   static constexpr int kBits = C.path_bits();
   static constexpr int kMoves = 3;
   using Value = PathValue<C>;
   using Entry = semi_global::PathEntry<kCostConfig<C>>;
   static constexpr Value kMask = Value((uint64_t(1) << kBits) - 1);
   /// Loses against every cost of a first column.
   static constexpr Value kFar = Value(uint64_t(1) << (kBits - 2));

   [[no_unique_address]] NumberHere<C.run_time_settings, C.drop_cost> drop_cost;
   [[no_unique_address]] NumberHere<C.run_time_settings, C.occlusion_cost> occlusion_cost;
   // move 1
   PathCost<C> next_cost[kCount];
   bool next_first;  ///< its column is the first of its row
   // move 2
   Value pair_cost[kCount];  ///< of this column, of the one before, and of a drop
   // the loop; of column x when move 3 is x
   Value path[kCount];        ///< E(x,d)
   Value stayed[kCount];      ///< E(x,d) + c(x+1,d)
   Value occluding[kCount];   ///< E(x,d) + omega
   Value dropped[kCount];     ///< P(x,d) + c(x+1,d)
   bool far[kCount];          ///< the drop of P(x,d) was a far one
   uint8_t decision[kCount];  ///< of (x,d)

   HLS_INLINE Forward() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.run_time_settings) {
         visit("drop_cost", drop_cost.value, C.drop_cost);
         visit("occlusion_cost", occlusion_cost.value, C.occlusion_cost);
      }
      visit("next_cost", next_cost);
      visit("next_first", next_first);
      visit("pair_cost", pair_cost);
      visit("path", path);
      visit("stayed", stayed);
      visit("occluding", occluding);
      visit("dropped", dropped);
      if constexpr (C.has_far_drop()) visit("far", far);
      visit("decision", decision);
   }

   /// settings: of the frame whose first column comes in, when it does.
   template <class Settings>
   HLS_INLINE void clock(const Entry& entry, const Settings& settings) {
      const auto& moves = entry.moves_costs;
      Value best[kCount];
      bool is_far[kCount];
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         const Value above = path[d + 1 < kCount ? d + 1 : d];
         const Value beyond = path[d + C.far_drop < kCount ? d + C.far_drop : d];
         is_far[d] = C.has_far_drop() && d + C.far_drop < kCount && is_less(beyond, above);
         const Value from = select<Value>(is_far[d], beyond, above);
         const bool drops = is_less(dropped[d], stayed[d]);
         const Value here = select<Value>(drops, dropped[d], stayed[d]);
         const Value gap = occluding[d > 0 ? d - 1 : 0];
         const bool gap_wins = d > 0 && is_less(gap, stayed[d]) && is_less(gap, dropped[d]);
         best[d] = select<Value>(gap_wins, gap, here);
         const uint8_t drop = select<uint8_t>(far[d], kFarDrop, kNearDrop);
         const uint8_t kept = select<uint8_t>(drops, drop, kStay);
         decision[d] = select<uint8_t>(moves.lane(d), select<uint8_t>(gap_wins, kOccluded, kept), decision[d]);
         const Value fallen = Value(from + pair_cost[d]) & kMask;
         dropped[d] = select<Value>(moves.lane(d), select<Value>(next_first, kFar, fallen), dropped[d]);
      }
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) {
         const Value own = select<Value>(next_first, 0, best[d]);
         far[d] = select<bool>(moves.lane(d), is_far[d] && !next_first, far[d]);
         path[d] = select<Value>(moves.lane(d), own, path[d]);
         stayed[d] = select<Value>(moves.lane(d), Value(own + next_cost[d]) & kMask, stayed[d]);
         const Value passed = Value(own + occlusion_cost.get()) & kMask;
         occluding[d] = select<Value>(moves.lane(d), select<Value>(next_first, kFar, passed), occluding[d]);
         pair_cost[d] =
             select<Value>(moves.lane(d), Value(next_cost[d] + entry.cost[d] + drop_cost.get()), pair_cost[d]);
         next_cost[d] = select<PathCost<C>>(moves.lane(d), entry.cost[d], next_cost[d]);
      }
      next_first = select<bool>(entry.tag.valid, entry.tag.first_column, next_first);
      // Of the row before, no cost is added any more: columns of no map lie between the two.
      if constexpr (C.run_time_settings) {
         const bool starts = entry.tag.valid & entry.tag.first_column & entry.tag.start_of_frame;
         drop_cost.take(starts, settings.drop_cost);
         occlusion_cost.take(starts, settings.occlusion_cost);
      }
   }

  private:
   /// a < b of numbers less than half the range apart.
   static HLS_INLINE bool is_less(Value a, Value b) { return (Value(a - b) >> (kBits - 1) & 1) != 0; }
};

}  // namespace stereo::trellis
