// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/path_sums.hpp"
#include "trellis/decision_turn.hpp"
#include "trellis/last_state.hpp"
#include "winner/winners.hpp"

namespace stereo::trellis {

/// Follows the decisions of a row from its last column to its first, one column a move. While a column stands in the
/// registers, the decisions of the next one are chosen for each state that it can lead to.
template <const Config& C>
struct Traceback {
   static constexpr int kCount = C.disparities;
   using Entry = semi_global::PathEntry<kCostConfig<C>>;
   using Turn = DecisionTurn<C>;
   /// From the words that have been read to the column's state.
   static constexpr int kMoves = Turn::kMoves + 1;
   static constexpr int kClocks = 2;
   static constexpr int kLagGroups = C.width_px + kMoves - 1;
   using Out = Winners<semi_global::kSumConfig<kCostConfig<C>>>;

   // Of the column whose tag has moved kMoves moves.
   uint8_t state;
   uint8_t decision;  ///< of this column and state
   uint8_t falling;   ///< the drop that the column before decided on, or kStay
   semi_global::TagMoves<kMoves> tags;
   Out out;  ///< disparity, and whether the pixel has a partner

   HLS_INLINE Traceback() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("state", state);
      visit("decision", decision);
      visit("falling", falling);
      visit("tags", tags);
      visit("out", out);
   }

   HLS_INLINE void clock(const Entry& entry, const Turn& turn, const LastState<C>& last) {
      const bool move = entry.tag.valid;
      out.disparity[0] = state;
      out.passed[0] = !(falling == kStay && decision == kOccluded);
      out.tag = tags.out();
      tags.clock(move, entry.turned);
      step(move, turn, last);
   }

  private:
   HLS_INLINE void step(bool move, const Turn& turn, const LastState<C>& last) {
      const bool near = falling == kNearDrop, far = falling == kFarDrop;
      const bool sinks = falling == kStay && decision == kOccluded;
      const bool waits = falling == kStay && (decision == kNearDrop || decision == kFarDrop);
      const uint8_t up = uint8_t(state + 1), up_far = uint8_t(state + C.far_drop), down = uint8_t(state - 1);
      // All four at once, then one of them.
      const uint8_t at_up = chosen(turn, up), at_up_far = chosen(turn, up_far), at_down = chosen(turn, down);
      const uint8_t at_same = chosen(turn, state);
      const uint8_t next = select<uint8_t>(near, up, select<uint8_t>(far, up_far, select<uint8_t>(sinks, down, state)));
      const uint8_t next_decision =
          select<uint8_t>(near, at_up, select<uint8_t>(far, at_up_far, select<uint8_t>(sinks, at_down, at_same)));
      // Between rows: where the next one ends.
      const bool inside = turn.ready_inside;
      falling = select<uint8_t>(move, select<uint8_t>(inside && waits, decision, kStay), falling);
      state = select<uint8_t>(move, select<uint8_t>(inside, next, last.state), state);
      decision = select<uint8_t>(move, select<uint8_t>(inside, next_decision, kStay), decision);
   }

   /// The decision of state `index`.
   static HLS_INLINE uint8_t chosen(const Turn& turn, uint8_t index) { return half<0, kCount>(turn, index); }

   /// Of states First ... First+Count-1, by the bits of the index from the highest down.
   template <int First, int Count>
   static HLS_INLINE uint8_t half(const Turn& turn, uint8_t index) {
      if constexpr (Count == 1) return turn.ready_decision[First];
      else {
         constexpr int kLow = power_of_two_below(Count);
         const bool upper = (index & kLow) != 0;
         return select<uint8_t>(upper, half<First + kLow, Count - kLow>(turn, index), half<First, kLow>(turn, index));
      }
   }
   /// The largest power of two below `count`.
   static constexpr int power_of_two_below(int count) {
      int power = 1;
      while (2 * power < count) power *= 2;
      return power;
   }
};

}  // namespace stereo::trellis
