// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "winner/candidate.hpp"
#include "winner/candidate_mask.hpp"
#include "winner/diagonal_minimum.hpp"
#include "winner/gated_tree.hpp"

namespace stereo::semi_global {

/// Where the winner of a column leads to.
template <const Config& C>
struct WinnerPartner {
   static constexpr const auto& kSums = kSumConfig<C>;
   static constexpr bool kFalls = kSums.reference == Reference::right;
   static constexpr int kWidth = C.output_width_px();

   uint16_t column;  ///< of the winner
   int16_t at;       ///< column of the other image's map
   [[no_unique_address]] typename OfWidth<kSumConfig<C>, kWidth>::Type width;

   HLS_INLINE WinnerPartner() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("at", at);
      if constexpr (C.run_time_size) visit("width", width);
   }

   HLS_INLINE bool is_inside() const { return (at >= 0) & (at < width.get()); }

   HLS_INLINE void clock(uint8_t winner, const PixelTag& tag) {
      const uint16_t here = select<uint16_t>(tag.first_column, 0, uint16_t(column + 1));
      const int shift = C.min_disparity + int(winner);
      at = int16_t(kFalls ? int(here) + shift : int(here) - shift);
      column = at_most<C.width_px - 1>(select<uint16_t>(tag.valid, here, column));
   }
   template <class Size>
   HLS_INLINE void resize(const Size& size) {
      width.clock(size);
   }
};
struct NoPartner {};

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

   /// Without a border cost the mask says what the candidates are; with one, which of the other image's pixels have
   /// some, and what is searched at all.
   static constexpr bool kHides =
       C.full_width && (!C.has_border_cost() || C.run_time_settings || !kSumConfig<C>.searches_all());
   static constexpr bool kHasMask = kHides || (C.full_width && C.has_left_right_check());
   using Mask = std::conditional_t<kHasMask, CandidateMask<kSumConfig<C>, C.disparities, 0>, NoMask>;
   using Partner = std::conditional_t<C.has_border_cost(), WinnerPartner<C>, NoPartner>;

   [[no_unique_address]] Mask mask;
   Other other;
   Tree winner;
   Candidates<Candidate, 1, 1> best;
   PixelTag best_tag;
   [[no_unique_address]] Partner partner;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasMask) visit.block("mask", mask);
      if constexpr (C.has_left_right_check()) visit.block("other", other);
      winner.levels(visit);
      visit("best", best);
      visit("best_tag", best_tag);
      if constexpr (C.has_border_cost()) visit("partner", partner);
   }

   template <class Sums>
   HLS_INLINE void clock(const Sums& sums) {
      if constexpr (Candidate::kHasSecond) best.set_losers(0, 0, winner.root().best.losers(0, 0));
      best.set(0, 0, winner.root().best.get(0, 0));
      best_tag = winner.root().tag;
      if constexpr (C.has_border_cost()) partner.clock(winner.root().best.get(0, 0).index, winner.root().tag);
      if constexpr (kHasMask) {
         WindowCost<kSumConfig<C>> shown[1][C.disparities];
         if constexpr (!C.has_border_cost()) {
            mask.hide(sums.sum, shown);
            winner.clock(shown, sums.tag);
         } else if constexpr (kHides) {
            mask.hide_unsearched(sums.sum, shown);
            winner.clock(shown, sums.tag);
         } else {
            winner.clock(sums.sum, sums.tag);
         }
         if constexpr (C.has_left_right_check()) other.clock(sums.sum, sums.tag, 0, NoDiagonal<kSumConfig<C>>(), mask);
      } else {
         winner.clock(sums.sum, sums.tag);
         if constexpr (C.has_left_right_check()) other.clock(sums.sum, sums.tag, 0, NoDiagonal<kSumConfig<C>>());
      }
   }

   /// With full_width, when the sums have been clocked: what is a candidate in their new column.
   template <class Settings, class Size>
   HLS_INLINE void follow(const PixelTag& sums_tag, const Settings& settings, const Size& size) {
      if constexpr (kHasMask) mask.clock(sums_tag, NoMask(), settings, size);
      if constexpr (C.has_border_cost()) partner.resize(size);
   }
};

}  // namespace stereo::semi_global
