// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "candidate.hpp"

namespace stereo {

/// Levels that reduce `candidates` to one, in groups of `group`: ceil(log_group candidates).
constexpr int winner_levels(int candidates, int group) {
   return candidates <= 1 ? 0 : 1 + winner_levels((candidates + group - 1) / group, group);
}

/// Winner-take-all tree over N candidates, each the best of `Span` neighbouring disparities. One clock a
/// level; each level reduces groups of C.winner_group candidates to one. Levels that a small tree does not need only
/// delay, so that trees of different sizes keep step.
template <const StereoConfig& C, int N, int Levels, int Span = 1>
struct WinnerTree {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kGroup = C.winner_group;
   static_assert(Levels >= winner_levels(N, kGroup), "the tree needs more levels");
   static constexpr int kWinners = (N + kGroup - 1) / kGroup;

   Candidates<C, kWinners> best;
   PixelTag tag;
   WinnerTree<C, kWinners, Levels - 1, Span * kGroup> next;

   /// First level: the candidates are single costs, their indices are their places.
   HLS_INLINE void clock(const WindowCost<C> (&cost)[kPixels][N], PixelTag in) {
      next.clock(best, tag);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
            Candidate<C> winner = Candidate<C>::single(cost[p][start], uint8_t(start));
            HLS_UNROLL
            for (int i = start + 1; i < start + kGroup && i < N; ++i)
               winner = Candidate<C>::joined(winner, i - 1, Candidate<C>::single(cost[p][i], uint8_t(i)), i);
            best.set(p, group, winner);
         }
      }
      tag = in;
   }

   HLS_INLINE void clock(const Candidates<C, N>& candidates, PixelTag in) {
      next.clock(best, tag);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
            Candidate<C> winner = candidates.get(p, start);
            HLS_UNROLL
            for (int i = start + 1; i < start + kGroup && i < N; ++i)
               winner = Candidate<C>::joined(winner, i * Span - 1, candidates.get(p, i), i * Span);
            best.set(p, group, winner);
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
template <const StereoConfig& C, int N, int Span>
struct WinnerTree<C, N, 0, Span> {
   static_assert(N == 1, "one winner is left");
   HLS_INLINE void clock(const Candidates<C, 1>&, PixelTag) {}
};

}  // namespace stereo
