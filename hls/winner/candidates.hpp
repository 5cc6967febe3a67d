// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"
#include "winner/candidate.hpp"

namespace stereo {

/// `N` candidates of each of `kPixels` windows side by side, as registers. Their losers come a clock after them.
template <class Candidate, int kPixels, int N>
struct Candidates {
   static constexpr int kNeighbours = Candidate::kHasNeighbours ? N : 1;
   static constexpr int kSeconds = Candidate::kHasSecond ? N : 1;
   using Value = typename Candidate::Value;
   using Others = typename Candidate::Others;

   Value cost[kPixels][N];
   uint8_t index[kPixels][N];
   Value below[kPixels][kNeighbours], above[kPixels][kNeighbours];
   Value first[kPixels][kNeighbours], last[kPixels][kNeighbours];
   uint8_t place[kPixels][kSeconds];  ///< the choice that made the candidate
   bool at_start[kPixels][kSeconds], at_end[kPixels][kSeconds];
   // of the candidate before
   Value late_cost[kPixels][kSeconds], second[kPixels][kSeconds];
   Value but_first[kPixels][kSeconds], but_last[kPixels][kSeconds];

   HLS_INLINE Candidates() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("cost", cost);
      visit("index", index);
      visit("below", below);
      visit("above", above);
      visit("first", first);
      visit("last", last);
      visit("place", place);
      visit("at_start", at_start);
      visit("at_end", at_end);
      visit("late_cost", late_cost);
      visit("second", second, Others::kNone);
      visit("but_first", but_first, Others::kNone);
      visit("but_last", but_last, Others::kNone);
   }

   HLS_INLINE Candidate get(int p, int i) const {
      Candidate candidate;
      candidate.cost = cost[p][i];
      candidate.index = index[p][i];
      if constexpr (Candidate::kHasNeighbours) {
         candidate.below = below[p][i];
         candidate.above = above[p][i];
         candidate.first = first[p][i];
         candidate.last = last[p][i];
      }
      return candidate;
   }
   /// What is left of the candidate that get() showed a clock ago.
   HLS_INLINE Others losers(int p, int i) const {
      Others losers;
      losers.cost = late_cost[p][i];
      losers.second = second[p][i];
      losers.but_first = but_first[p][i];
      losers.but_last = but_last[p][i];
      return losers;
   }
   HLS_INLINE Choice choice(int p, int i) const { return Choice::of(place[p][i], at_start[p][i], at_end[p][i]); }

   HLS_INLINE void set(int p, int i, const Candidate& candidate, const Choice& choice = Choice()) {
      cost[p][i] = candidate.cost;
      index[p][i] = candidate.index;
      if constexpr (Candidate::kHasNeighbours) {
         below[p][i] = candidate.below;
         above[p][i] = candidate.above;
         first[p][i] = candidate.first;
         last[p][i] = candidate.last;
      }
      if constexpr (Candidate::kHasSecond) {
         place[p][i] = choice.place;
         at_start[p][i] = choice.at_start;
         at_end[p][i] = choice.at_end;
      }
   }
   /// Before set(): those of the candidate that is still there.
   HLS_INLINE void set_losers(int p, int i, const Others& losers) {
      late_cost[p][i] = cost[p][i];
      second[p][i] = losers.second;
      but_first[p][i] = losers.but_first;
      but_last[p][i] = losers.but_last;
   }

   /// The same of two neighbouring ranges.
   HLS_INLINE void join(int p, int i, const Candidate& a, int a_last, const Candidate& b, int b_first) {
      set(p, i, Candidate::joined(a, a_last, b, b_first),
          Choice::chosen(Candidate::wins(b.cost, a.cost), Choice::of(0, false, a.index == a_last),
                         Choice::of(1, b.index == b_first, false)));
   }
   HLS_INLINE void join_losers(int p, int i, const Others& a, const Others& b) {
      const Choice winner = choice(p, i);
      set_losers(p, i, Others::joined(a.template left_by<0, 2>(winner), b.template left_by<1, 2>(winner)));
   }
};

}  // namespace stereo
