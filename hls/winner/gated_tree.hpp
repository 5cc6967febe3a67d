// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "winner/candidate.hpp"
#include "winner/winner_tree.hpp"

namespace stereo {

/// Clocks that reduce `candidates` to one in rounds of four, the last two as in WinnerTree.
constexpr int gated_clocks(int candidates) {
   return candidates <= 2 ? winner_levels(candidates, 2) : 3 + gated_clocks((candidates + 3) / 4);
}

/// The same result as WinnerTree in pairs, with a third of its multiplexers: a comparison clears the cost of the loser
/// instead of choosing the winner's. Clearing is what flip-flops do by themselves, and as at most one of four costs is
/// left after two comparisons, one look-up table of four inputs gives a bit of the winner: one for four candidates
/// instead of three. The second comparison takes each pair as `x or y`, which its carry chain does by the way.
///
/// Only for candidates that carry nothing but a cost and an index. Three clocks for each round of four: pairs, fours,
/// joined.
template <class Candidate, class Tag, int kPixels, int N, int Clocks, int Span = 1>
struct GatedTree {
   static_assert(!Candidate::kHasNeighbours && !Candidate::kHasSecond);
   static_assert(N > 2 && Clocks >= gated_clocks(N), "the tree needs more clocks");
   static constexpr int kClocks = Clocks;
   static constexpr int kPairs = (N + 1) / 2, kFours = (N + 3) / 4;
   using Value = typename Candidate::Value;
   using Next = typename std::conditional_t<
       (kFours > 2), std::type_identity<GatedTree<Candidate, Tag, kPixels, kFours, Clocks - 3, Span * 4>>,
       std::type_identity<WinnerTree<Candidate, Tag, kPixels, 2, kFours, Clocks - 3, Span * 4>>>::type;

   // clock 1: losers of pairs are 0
   Value of_pair[kPixels][N];
   uint8_t pair_index[kPixels][kPairs];
   Tag pair_tag;
   // clock 2: losers of fours are 0
   Value of_four[kPixels][N];
   uint8_t four_index[kPixels][kFours];
   Tag four_tag;
   // clock 3
   Candidates<Candidate, kPixels, kFours> best;
   Tag tag;
   Next next;

   HLS_INLINE GatedTree() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("of_pair", of_pair);
      visit("pair_index", pair_index);
      visit("pair_tag", pair_tag);
      visit("of_four", of_four);
      visit("four_index", four_index);
      visit("four_tag", four_tag);
      visit("best", best);
      visit("tag", tag);
   }
   /// The registers of all rounds.
   template <int Round = 1, class Visitor>
   HLS_INLINE void levels(Visitor& visit) {
      visit.block("winner", *this, Round);
      next.template levels<Round + 1>(visit);
   }

   /// First round: the candidates are single costs, their indices are their places.
   HLS_INLINE void clock(const Value (&cost)[kPixels][N], const Tag& in) {
      finish();
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < N; i += 2) {
            Candidate left = Candidate::single(cost[p][i], uint8_t(i)), right = left;
            if (i + 1 < N) right = Candidate::single(cost[p][i + 1 < N ? i + 1 : i], uint8_t(i + 1));
            compare_pair(p, i, left, right);
         }
      }
      pair_tag = in;
   }

   HLS_INLINE void clock(const Candidates<Candidate, kPixels, N>& candidates, const Tag& in) {
      finish();
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < N; i += 2)
            compare_pair(p, i, candidates.get(p, i), candidates.get(p, i + 1 < N ? i + 1 : i));
      }
      pair_tag = in;
   }

   /// What holds the last winner.
   HLS_INLINE const auto& root() const {
      if constexpr (Clocks == 3) return *this;
      else return next.root();
   }

  private:
   /// Candidates i and i+1; an odd last one stands alone.
   HLS_INLINE void compare_pair(int p, int i, const Candidate& left, const Candidate& right) {
      const bool right_wins = i + 1 < N && Candidate::wins(right.cost, left.cost);
      of_pair[p][i] = select<Value>(right_wins, 0, left.cost);
      if (i + 1 < N) of_pair[p][i + 1 < N ? i + 1 : i] = select<Value>(right_wins, right.cost, 0);
      pair_index[p][i / 2] = select<uint8_t>(right_wins, right.index, left.index);
   }

   /// Clocks 3 and 2.
   HLS_INLINE void finish() {
      next.clock(best, tag);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int four = 0; four < kFours; ++four) {
            Candidate winner;
            HLS_UNROLL
            for (int i = 4 * four; i < 4 * four + 4 && i < N; ++i) winner.cost = Value(winner.cost | of_four[p][i]);
            winner.index = four_index[p][four];
            best.set(p, four, winner);
            compare_four(p, four);
         }
      }
      tag = four_tag;
      four_tag = pair_tag;
   }

   HLS_INLINE void compare_four(int p, int four) {
      const int first = 4 * four, left_pair = 2 * four, right_pair = left_pair + 1 < kPairs ? left_pair + 1 : left_pair;
      const bool right_wins =
          left_pair + 1 < kPairs && Candidate::wins(pair_cost(p, right_pair), pair_cost(p, left_pair));
      HLS_UNROLL
      for (int i = first; i < first + 4 && i < N; ++i)
         of_four[p][i] =
             i < first + 2 ? select<Value>(right_wins, 0, of_pair[p][i]) : select<Value>(right_wins, of_pair[p][i], 0);
      four_index[p][four] = select<uint8_t>(right_wins, pair_index[p][right_pair], pair_index[p][left_pair]);
   }

   HLS_INLINE Value pair_cost(int p, int pair) const {
      return Value(of_pair[p][2 * pair] | (2 * pair + 1 < N ? of_pair[p][2 * pair + 1 < N ? 2 * pair + 1 : 0] : 0));
   }
};

/// Whether a GatedTree can take what a WinnerTree takes. Each of its comparisons resets registers of its own, and a
/// place-and-route tool puts only registers of one reset into a tile: where such registers are many, they end up far
/// apart, and a WinnerTree is larger but faster.
template <class Candidate>
constexpr bool can_be_gated(int candidates, int group) {
   return candidates > 2 && group == 2 && !Candidate::kHasNeighbours && !Candidate::kHasSecond;
}

/// Clocks of the tree that WinnerBlock names, for up to `candidates` candidates.
constexpr int winner_clocks(bool gated, int candidates, int group) {
   return gated ? gated_clocks(candidates) : winner_levels(candidates, group);
}

/// The tree for N candidates that takes `Clocks` clocks, as many as winner_clocks says or more. Gated: of all trees
/// that keep step.
template <bool Gated, class Candidate, class Tag, int kPixels, int kGroup, int N, int Clocks>
using WinnerBlock =
    typename std::conditional_t<(Gated && N > 2), std::type_identity<GatedTree<Candidate, Tag, kPixels, N, Clocks>>,
                                std::type_identity<WinnerTree<Candidate, Tag, kPixels, kGroup, N, Clocks>>>::type;

}  // namespace stereo
