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
         if constexpr (kHasSecond) leave_costs<0>(p);
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
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
         if constexpr (kHasSecond) leave_candidates<0>(candidates, p);
         HLS_UNROLL
         for (int group = 0; group < kWinners; ++group) {
            const int start = group * kGroup;
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
   // The losers of groups Group, Group+1, ... of the clock before. Recursion instead of loops: what happens to a cost
   // depends on its place, and the front end does not unroll a loop of which it has led each place its own way.
   static constexpr int count_of(int group) { return (group + 1) * kGroup < N ? kGroup : N - group * kGroup; }

   template <int Group>
   HLS_INLINE void leave_costs(int p) {
      Others losers;
      add_costs<Group, 0>(losers, p);
      best.set_losers(p, Group, losers);
      if constexpr (Group + 1 < kWinners) leave_costs<Group + 1>(p);
   }
   template <int Group, int Place>
   HLS_INLINE void add_costs(Others& losers, int p) const {
      losers.template add_single<Place, count_of(Group)>(held[p][Group * kGroup + Place], best.place[p][Group]);
      if constexpr (Place + 1 < count_of(Group)) add_costs<Group, Place + 1>(losers, p);
   }

   template <int Group>
   HLS_INLINE void leave_candidates(const Candidates<Candidate, kPixels, N>& candidates, int p) {
      best.set_losers(p, Group, left<Group, 0>(candidates, p));
      if constexpr (Group + 1 < kWinners) leave_candidates<Group + 1>(candidates, p);
   }
   /// From `Place` of the group on.
   template <int Group, int Place>
   HLS_INLINE Others left(const Candidates<Candidate, kPixels, N>& candidates, int p) const {
      const Others here =
          candidates.losers(p, Group * kGroup + Place).template left_by<Place, count_of(Group)>(best.choice(p, Group));
      if constexpr (Place + 1 == count_of(Group)) return here;
      else return Others::joined(here, left<Group, Place + 1>(candidates, p));
   }

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
