// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hls_support.hpp"
#include "stream.hpp"

namespace stereo {

/// Levels that reduce `candidates` to one, in groups of `group`: ceil(log_group candidates).
constexpr int winner_levels(int candidates, int group) {
   return candidates <= 1 ? 0 : 1 + winner_levels((candidates + group - 1) / group, group);
}

/// Winner-take-all tree: the smallest of N costs and the smallest index that has it, for `Pixels` windows. One clock a
/// level; each level reduces groups of `Group` candidates to one. Levels that a small tree does not need only delay, so
/// that trees of different sizes keep step.
template <int Pixels, int N, int Group, int Levels>
struct WinnerTree {
   static_assert(Group >= 2, "a level compares at least two candidates");
   static_assert(Levels >= winner_levels(N, Group), "the tree needs more levels");
   static constexpr int kWinners = (N + Group - 1) / Group;

   uint16_t cost[Pixels][kWinners];
   uint8_t index[Pixels][kWinners];
   PixelTag tag;
   WinnerTree<Pixels, kWinners, Group, Levels - 1> next;

   HLS_INLINE WinnerTree() {
      HLS_UNROLL
      for (int p = 0; p < Pixels; ++p) {
         fill<uint16_t>(cost[p], 0);
         fill<uint8_t>(index[p], 0);
      }
   }

   /// First level: the candidates' indices are their places.
   HLS_INLINE void clock(const uint16_t (&candidate)[Pixels][N], PixelTag in) {
      uint8_t place[Pixels][N];
      HLS_UNROLL
      for (int p = 0; p < Pixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < N; ++i) place[p][i] = uint8_t(i);
      }
      clock(candidate, place, in);
   }

   HLS_INLINE void clock(const uint16_t (&candidate)[Pixels][N], const uint8_t (&place)[Pixels][N], PixelTag in) {
      next.clock(cost, index, tag);
      HLS_UNROLL
      for (int p = 0; p < Pixels; ++p) {
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            uint16_t best = candidate[p][group * Group];
            uint8_t winner = place[p][group * Group];
            HLS_UNROLL
            for (int i = group * Group + 1; i < (group + 1) * Group && i < N; ++i) {
               const bool smaller = candidate[p][i] < best;  // strictly: the smaller index wins a tie
               best = select<uint16_t>(smaller, candidate[p][i], best);
               winner = select<uint8_t>(smaller, place[p][i], winner);
            }
            cost[p][group] = best;
            index[p][group] = winner;
         }
      }
      tag = in;
   }

   /// The last level.
   HLS_INLINE const auto& root() const {
      if constexpr (Levels == 1) return *this;
      else return next.root();
   }
};

/// Below the last level there is nothing left to compare.
template <int Pixels, int N, int Group>
struct WinnerTree<Pixels, N, Group, 0> {
   static_assert(N == 1, "one winner is left");
   HLS_INLINE void clock(const uint16_t (&)[Pixels][1], const uint8_t (&)[Pixels][1], PixelTag) {}
};

}  // namespace stereo
