// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sad_cost.hpp"

namespace stereo {

/// The best of a range of neighbouring disparities, and what the checks after the winner need of the others. Members
/// that the configuration does not need stay 0 and cost nothing.
template <const StereoConfig& C>
struct Candidate {
   using Value = WindowCost<C>;
   static constexpr bool kHasNeighbours = C.subpixel;
   static constexpr bool kHasSecond = C.has_uniqueness_check();
   /// Larger than every window cost, or as large as the type can hold.
   static constexpr Value kNone = Value((uint64_t(1) << bits_for(C.largest_window_cost() + 1)) - 1);

   Value cost = 0;
   uint8_t index = 0;
   Value below = 0, above = 0;         ///< costs beside the winner; without meaning at an end of the whole range
   Value first = 0, last = 0;          ///< costs at the ends of the range
   Value second = 0;                   ///< smallest cost that is not the winner's or beside it
   Value but_first = 0, but_last = 0;  ///< smallest cost of the range without its first, last disparity

   static HLS_INLINE Candidate single(Value cost, uint8_t index) {
      Candidate candidate;
      candidate.cost = candidate.first = candidate.last = cost;
      candidate.index = index;
      candidate.second = candidate.but_first = candidate.but_last = kNone;
      return candidate;
   }

   /// Joins two neighbouring ranges: a.index <= a_last < b_first <= b.index.
   static HLS_INLINE Candidate joined(const Candidate& a, int a_last, const Candidate& b, int b_first) {
      const bool b_wins = C.ties == Ties::smallest ? b.cost < a.cost : b.cost <= a.cost;
      Candidate best;
      best.cost = select<Value>(b_wins, b.cost, a.cost);
      best.index = select<uint8_t>(b_wins, b.index, a.index);
      const bool at_a_end = a.index == a_last, at_b_start = b.index == b_first;
      if constexpr (kHasNeighbours) {
         best.below = select<Value>(b_wins, select<Value>(at_b_start, a.last, b.below), a.below);
         best.above = select<Value>(b_wins, b.above, select<Value>(at_a_end, b.first, a.above));
         best.first = a.first;
         best.last = b.last;
      }
      if constexpr (kHasSecond) {
         const Value beside_a = smaller(a.second, select<Value>(at_a_end, b.but_first, b.cost));
         const Value beside_b = smaller(b.second, select<Value>(at_b_start, a.but_last, a.cost));
         best.second = select<Value>(b_wins, beside_b, beside_a);
         best.but_first = smaller(a.but_first, b.cost);
         best.but_last = smaller(a.cost, b.but_last);
      }
      return best;
   }

  private:
   static HLS_INLINE Value smaller(Value x, Value y) { return select<Value>(y < x, y, x); }
};

/// Candidates of `Pixels` windows side by side, as registers.
template <const StereoConfig& C, int N>
struct Candidates {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kNeighbours = Candidate<C>::kHasNeighbours ? N : 1;
   static constexpr int kSeconds = Candidate<C>::kHasSecond ? N : 1;
   using Value = WindowCost<C>;

   Value cost[kPixels][N];
   uint8_t index[kPixels][N];
   Value below[kPixels][kNeighbours], above[kPixels][kNeighbours];
   Value first[kPixels][kNeighbours], last[kPixels][kNeighbours];
   Value second[kPixels][kSeconds], but_first[kPixels][kSeconds], but_last[kPixels][kSeconds];

   HLS_INLINE Candidates() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         fill<Value>(cost[p], 0);
         fill<uint8_t>(index[p], 0);
         fill<Value>(below[p], 0);
         fill<Value>(above[p], 0);
         fill<Value>(first[p], 0);
         fill<Value>(last[p], 0);
         fill<Value>(second[p], 0);
         fill<Value>(but_first[p], 0);
         fill<Value>(but_last[p], 0);
      }
   }

   HLS_INLINE Candidate<C> get(int p, int i) const {
      Candidate<C> candidate;
      candidate.cost = cost[p][i];
      candidate.index = index[p][i];
      if constexpr (Candidate<C>::kHasNeighbours) {
         candidate.below = below[p][i];
         candidate.above = above[p][i];
         candidate.first = first[p][i];
         candidate.last = last[p][i];
      }
      if constexpr (Candidate<C>::kHasSecond) {
         candidate.second = second[p][i];
         candidate.but_first = but_first[p][i];
         candidate.but_last = but_last[p][i];
      }
      return candidate;
   }

   HLS_INLINE void set(int p, int i, const Candidate<C>& candidate) {
      cost[p][i] = candidate.cost;
      index[p][i] = candidate.index;
      if constexpr (Candidate<C>::kHasNeighbours) {
         below[p][i] = candidate.below;
         above[p][i] = candidate.above;
         first[p][i] = candidate.first;
         last[p][i] = candidate.last;
      }
      if constexpr (Candidate<C>::kHasSecond) {
         second[p][i] = candidate.second;
         but_first[p][i] = candidate.but_first;
         but_last[p][i] = candidate.but_last;
      }
   }
};

}  // namespace stereo
