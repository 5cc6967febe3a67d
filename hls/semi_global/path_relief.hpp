// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "support/registers.hpp"

namespace stereo::semi_global {

/// What a row path knows of the reliefs on its way, where P2 falls (docs/algorithm.md, S2). With r(i) the relief
/// between the columns i-1 and i, r = 0 at i = 0, the path holds K(i) + r(i+1), so that a fresh start is 0 in every
/// column, and the loop of K and A is that of a P2 that never falls.
template <const Config& C>
struct PathRelief {
   static constexpr int kBias = C.row_path_bias();
   static constexpr int kLookBack = C.look_back_columns();
   /// Where it is taken off the sum again, it goes as far as K: the path's moves 1 to 4.
   static constexpr int kHeld = C.takes_relief_off() ? 4 : 1;
   using Value = Relief<C>;
   static_assert(kLookBack >= 7 && kLookBack <= 12, "two fours cover what is older, and two pairs the least of it");
   static constexpr int kFours = kLookBack > 8 ? kLookBack - 7 : 1;

   Value next[kHeld];          ///< [j]: r(i+1) of the column i of move j+1
   Value past[kLookBack - 1];  ///< [j]: r(i-1-j), i the column that comes in
   // The largest r of the columns that the definition looks back over, in steps of a move.
   Value pairs[2];       ///< [j]: of the columns i-1-j and i-2-j
   Value fours[kFours];  ///< [j]: of i-1-j ... i-4-j
   Value older;          ///< of i-1 ... i-kLookBack+3
   Value recent;         ///< of i ... i-kLookBack+2
   Value largest;        ///< of i ... i-kLookBack+1
   Value beyond;         ///< less r(i-kLookBack+1)
   // What the path's room becomes, with the bias. It is known a move before, so that the path adds only once.
   uint16_t reach_of_best;  ///< the room less r(i-kLookBack+1)
   uint16_t leaves;         ///< what makes of the room the reach_of_best of column i+1
   uint16_t room_of_best;  ///< what makes of the best path's cost the room of column i+1, where that path's start rises
   uint16_t reach_again;   ///< the same for its reach_of_best

   HLS_INLINE PathRelief() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("next", next);
      visit("past", past);
      visit("pairs", pairs);
      visit("fours", fours);
      visit("older", older);
      visit("recent", recent);
      visit("largest", largest);
      visit("beyond", beyond);
      visit("reach_of_best", reach_of_best);
      visit("leaves", leaves);
      visit("room_of_best", room_of_best);
      visit("reach_again", reach_again);
   }

   /// r(i) of the column that comes in.
   HLS_INLINE Value here(bool first) const { return select<Value>(first, 0, next[0]); }
   /// r(i-kLookBack+1)
   HLS_INLINE Value looked_back() const { return past[kLookBack - 2]; }
   /// r(i+1) of the column whose K is there.
   HLS_INLINE Value shown() const { return next[kHeld - 1]; }

   /// next_in: r(i+1). reach_after: reach_of_best of column i+1. leaves_next: the q that the sum of column i+2 has no
   /// more.
   HLS_INLINE void clock(bool move, bool first, Value next_in, uint32_t reach_after, uint32_t leaves_next) {
      const Value now = here(first), most = larger_of(next_in, recent);
      reach_of_best =
          select<uint16_t>(move, select<uint16_t>(first, 0, uint16_t(reach_after) & kReachMask), reach_of_best);
      const uint32_t leaves_then = select<uint32_t>(first, 0, leaves_next) + kBias;
      const uint32_t room_then = leaves_then + past[kLookBack - 3];
      leaves = select<uint16_t>(move, uint16_t(leaves_then - past[kLookBack - 4]) & kReachMask, leaves);
      room_of_best = select<uint16_t>(move, uint16_t(room_then) & kReachMask, room_of_best);
      reach_again = select<uint16_t>(move, uint16_t(room_then + kBias - past[kLookBack - 4]) & kReachMask, reach_again);
      beyond = select<Value>(move, Value(most - past[kLookBack - 3]) & kMask, beyond);
      largest = select<Value>(move, most, largest);
      recent = select<Value>(move, larger_of(larger_of(next_in, now), older), recent);
      older = select<Value>(move, larger_of(now, largest_before()), older);
      HLS_UNROLL
      for (int j = kFours - 1; j > 0; --j) fours[j] = select<Value>(move, fours[j - 1], fours[j]);
      const Value pair = larger_of(now, past[0]);
      fours[0] = select<Value>(move, larger_of(pair, pairs[1]), fours[0]);
      pairs[1] = select<Value>(move, pairs[0], pairs[1]);
      pairs[0] = select<Value>(move, pair, pairs[0]);
      HLS_UNROLL
      for (int j = kLookBack - 2; j > 0; --j) past[j] = select<Value>(move, past[j - 1], past[j]);
      past[0] = select<Value>(move, now, past[0]);
      HLS_UNROLL
      for (int j = kHeld - 1; j > 0; --j) next[j] = select<Value>(move, next[j - 1], next[j]);
      next[0] = select<Value>(move, next_in, next[0]);
   }

  private:
   static constexpr Value kMask = Value((1 << C.relief_bits()) - 1);
   /// Below 4 times the bias, as P2 is at most the bias.
   static constexpr uint16_t kReachMask = uint16_t(4 * kBias - 1);

   static HLS_INLINE Value larger_of(Value a, Value b) { return select<Value>(a < b, b, a); }

   /// Of the columns i-1 ... i-kLookBack+4, whose fours or pairs may overlap.
   HLS_INLINE Value largest_before() const {
      if constexpr (kLookBack == 7) return larger_of(pairs[0], pairs[1]);
      else return larger_of(fours[0], fours[kFours - 1]);
   }
};

}  // namespace stereo::semi_global
