// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "winner/candidate.hpp"
#include "winner/candidate_mask.hpp"
#include "winner/diagonal_minimum.hpp"
#include "winner/gated_tree.hpp"

namespace stereo::semi_global {

/// The winner of the sums, and the other image's: what the checks of the winner ask of the last slice in block
/// matching.
template <const Config& C>
struct PathWinners {
   using Candidate = WindowCandidate<kSumConfig<C>>;
   static constexpr bool kGated = can_be_gated<Candidate>(C.disparities, C.winner_group);
   static constexpr int kLevels = winner_clocks(kGated, C.disparities, C.winner_group);
   static constexpr int kClocks = kLevels + 1;
   using Other = DiagonalMinimum<kSumConfig<C>, (C.has_left_right_check() ? C.disparities : 1)>;
   using Tree = WinnerBlock<kGated, Candidate, PixelTag, 1, C.winner_group, C.disparities, kLevels>;

   using Mask = std::conditional_t<C.full_width, CandidateMask<kSumConfig<C>, C.disparities, 0>, NoMask>;

   [[no_unique_address]] Mask mask;
   Other other;
   Tree winner;
   Candidates<Candidate, 1, 1> best;
   PixelTag best_tag;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.full_width) visit.block("mask", mask);
      if constexpr (C.has_left_right_check()) visit.block("other", other);
      winner.levels(visit);
      visit("best", best);
      visit("best_tag", best_tag);
   }

   template <class Sums>
   HLS_INLINE void clock(const Sums& sums) {
      if constexpr (C.uniqueness_distance > 0) best.set_losers(0, 0, winner.root().best.losers(0, 0));
      best.set(0, 0, winner.root().best.get(0, 0));
      best_tag = winner.root().tag;
      if constexpr (C.full_width) {
         WindowCost<kSumConfig<C>> shown[1][C.disparities];
         mask.hide(sums.sum, shown);
         winner.clock(shown, sums.tag);
         if constexpr (C.has_left_right_check()) other.clock(sums.sum, sums.tag, 0, NoDiagonal<kSumConfig<C>>(), mask);
      } else {
         winner.clock(sums.sum, sums.tag);
         if constexpr (C.has_left_right_check()) other.clock(sums.sum, sums.tag, 0, NoDiagonal<kSumConfig<C>>());
      }
   }

   /// With full_width, when the sums have been clocked: what is a candidate in their new column.
   template <class Settings, class Size>
   HLS_INLINE void follow(const PixelTag& sums_tag, const Settings& settings, const Size& size) {
      if constexpr (C.full_width) mask.clock(sums_tag, NoMask(), settings, size);
   }
};

}  // namespace stereo::semi_global
