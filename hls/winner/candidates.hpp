// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// `N` candidates of each of `kPixels` windows side by side, as registers.
template <class Candidate, int kPixels, int N>
struct Candidates {
   static constexpr int kNeighbours = Candidate::kHasNeighbours ? N : 1;
   static constexpr int kSeconds = Candidate::kHasSecond ? N : 1;
   using Value = typename Candidate::Value;

   Value cost[kPixels][N];
   uint8_t index[kPixels][N];
   Value below[kPixels][kNeighbours], above[kPixels][kNeighbours];
   Value first[kPixels][kNeighbours], last[kPixels][kNeighbours];
   Value second[kPixels][kSeconds], but_first[kPixels][kSeconds], but_last[kPixels][kSeconds];

   HLS_INLINE Candidates() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("cost", cost);
      visit("index", index);
      visit("below", below);
      visit("above", above);
      visit("first", first);
      visit("last", last);
      visit("second", second);
      visit("but_first", but_first);
      visit("but_last", but_last);
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
      if constexpr (Candidate::kHasSecond) {
         candidate.second = second[p][i];
         candidate.but_first = but_first[p][i];
         candidate.but_last = but_last[p][i];
      }
      return candidate;
   }

   HLS_INLINE void set(int p, int i, const Candidate& candidate) {
      cost[p][i] = candidate.cost;
      index[p][i] = candidate.index;
      if constexpr (Candidate::kHasNeighbours) {
         below[p][i] = candidate.below;
         above[p][i] = candidate.above;
         first[p][i] = candidate.first;
         last[p][i] = candidate.last;
      }
      if constexpr (Candidate::kHasSecond) {
         second[p][i] = candidate.second;
         but_first[p][i] = candidate.but_first;
         but_last[p][i] = candidate.but_last;
      }
   }
};

}  // namespace stereo
