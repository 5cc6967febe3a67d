// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "winner/candidates.hpp"

namespace stereo {

/// Levels that reduce `candidates` to one, in groups of `group`: ceil(log_group candidates).
constexpr int winner_levels(int candidates, int group) {
   return candidates <= 1 ? 0 : 1 + winner_levels((candidates + group - 1) / group, group);
}

/// Winner-take-all tree over N candidates of each of `kPixels` windows, each the best of `Span` neighbouring
/// disparities. One clock a level; each level reduces groups of `kGroup` candidates to one. Levels that a small tree
/// does not need only delay, so that trees of different sizes keep step. `Tag` travels beside the candidates.
template <class Candidate, class Tag, int kPixels, int kGroup, int N, int Levels, int Span = 1>
struct WinnerTree {
   static constexpr int kClocks = Levels;
   static_assert(Levels >= winner_levels(N, kGroup), "the tree needs more levels");
   static constexpr int kWinners = (N + kGroup - 1) / kGroup;
   static constexpr bool kHasSecond = Candidate::kHasSecond;
   using Value = typename Candidate::Value;
   using Others = typename Candidate::Others;

   Value held[kPixels][kHasSecond && Span == 1 ? N : 1];  ///< first level: the costs of the clock before
   Candidates<Candidate, kPixels, kWinners> best;
   Tag tag;
   WinnerTree<Candidate, Tag, kPixels, kGroup, kWinners, Levels - 1, Span * kGroup> next;

   HLS_INLINE WinnerTree() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasSecond && Span == 1) visit("held", held);
      visit("best", best);
      visit("tag", tag);
   }
   /// The registers of all levels.
   template <int Level = 1, class Visitor>
   HLS_INLINE void levels(Visitor& visit) {
      visit.block("winner", *this, Level);
      next.template levels<Level + 1>(visit);
   }

   /// First level: the candidates are single costs, their indices are their places.
   HLS_INLINE void clock(const Value (&cost)[kPixels][N], const Tag& in) {
      next.clock(best, tag);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
            if constexpr (kHasSecond) {
               Others losers;
               HLS_UNROLL
               for (int i = start; i < start + kGroup && i < N; ++i)
                  losers.add_single(held[p][i], i - start, start + kGroup < N ? kGroup : N - start,
                                    best.place[p][group]);
               best.set_losers(p, group, losers);
            }
            Candidate winner = Candidate::single(cost[p][start], uint8_t(start));
            Choice choice;
            HLS_UNROLL
            for (int i = start + 1; i < start + kGroup && i < N; ++i) {
               const Candidate rival = Candidate::single(cost[p][i], uint8_t(i));
               choice = Choice::chosen(Candidate::wins(rival.cost, winner.cost), choice,
                                       Choice::of(uint8_t(i - start), false, false));
               winner = Candidate::joined(winner, i - 1, rival, i);
            }
            best.set(p, group, winner, choice);
         }
         if constexpr (kHasSecond) {
            HLS_UNROLL
            for (int i = 0; i < N; ++i) held[p][i] = cost[p][i];
         }
      }
      tag = in;
   }

   HLS_INLINE void clock(const Candidates<Candidate, kPixels, N>& candidates, const Tag& in) {
      next.clock(best, tag);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
            if constexpr (kHasSecond) {
               const Choice choice = best.choice(p, group);
               const int count = start + kGroup < N ? kGroup : N - start;
               Others losers = candidates.losers(p, start).left_by(choice, 0, count);
               HLS_UNROLL
               for (int i = start + 1; i < start + kGroup && i < N; ++i)
                  losers = Others::joined(losers, candidates.losers(p, i).left_by(choice, i - start, count));
               best.set_losers(p, group, losers);
            }
            Candidate winner = candidates.get(p, start);
            Choice choice = place_of(winner, start, start);
            HLS_UNROLL
            for (int i = start + 1; i < start + kGroup && i < N; ++i) {
               const Candidate rival = candidates.get(p, i);
               choice = Choice::chosen(Candidate::wins(rival.cost, winner.cost), choice, place_of(rival, i, start));
               winner = Candidate::joined(winner, i * Span - 1, rival, i * Span);
            }
            best.set(p, group, winner, choice);
         }
      }
      tag = in;
   }

   /// The last level.
   HLS_INLINE const auto& root() const {
      if constexpr (Levels == 1) return *this;
      else return next.root();
   }

  private:
   /// Candidate `i` as the winner of its group.
   static HLS_INLINE Choice place_of(const Candidate& candidate, int i, int start) {
      return Choice::of(uint8_t(i - start), i > start && candidate.index == i * Span,
                        i + 1 < start + kGroup && i + 1 < N && candidate.index == (i + 1) * Span - 1);
   }
};

/// Below the last level there is nothing left to compare.
template <class Candidate, class Tag, int kPixels, int kGroup, int N, int Span>
struct WinnerTree<Candidate, Tag, kPixels, kGroup, N, 0, Span> {
   static_assert(N == 1, "one winner is left");

   template <int Level, class Visitor>
   HLS_INLINE void levels(Visitor&) {}
   HLS_INLINE void clock(const Candidates<Candidate, kPixels, 1>&, const Tag&) {}
};

}  // namespace stereo
