// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/column_cost.hpp"
#include "cost/disparity_shift.hpp"
#include "cost/window_sum.hpp"
#include "winner/candidate.hpp"
#include "winner/candidate_mask.hpp"
#include "winner/diagonal_minimum.hpp"
#include "winner/gated_tree.hpp"

namespace stereo::block_matching {

/// Most window costs a clock that a slice compares in a GatedTree. In larger slices registers of so many resets are
/// placed far apart; docs/logic.md has what both trees take from 12 costs on. Fewer were not compared.
inline constexpr int kMostGated = 8;

/// The slices for the last `Disparities` disparities that the searched pixels meet. Each slice holds the shift, cost,
/// window and winner blocks of up to C.slice_disparities disparities and works one clock behind the slice before it,
/// from which it gets the pixels and the best candidate so far. The first slice has the highest disparities where the
/// reference is the right image, the lowest where it is the left one.
template <const auto& C, int Disparities = C.disparities, int Number = 0>
struct DisparitySlice {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr bool kFalls = C.reference == Reference::right;
   static constexpr int kCount = C.first_slice(Disparities);
   static constexpr int kRest = Disparities - kCount;
   static constexpr int kFirst = kFalls ? kRest : C.disparities - Disparities;  ///< lowest disparity here
   static constexpr bool kIsLast = kRest == 0;
   static constexpr bool kIsNone = false;
   static constexpr bool kHasSecond = WindowCandidate<C>::kHasSecond;
   using Next = DisparitySlice<C, kRest, Number + 1>;
   using Shift = DisparityShift<C, kCount>;
   using Column = ColumnBlock<C, kCount>;
   using Window = WindowBlock<C, kCount>;
   static constexpr bool kGated =
       C.largest_slice() * kPixels <= kMostGated && can_be_gated<WindowCandidate<C>>(C.largest_slice(), C.winner_group);
   static constexpr int kLevels = winner_clocks(kGated, C.largest_slice(), C.winner_group);
   using Winner = WinnerBlock<kGated, WindowCandidate<C>, PixelTag, kPixels, C.winner_group, kCount, kLevels>;
   using Mask = std::conditional_t<kFullWidth<C>, CandidateMask<C, kCount, kFirst>, NoMask>;
   static constexpr int kMemories = Column::kMemories + Window::kMemories + Next::kMemories;
   /// From the rows' arrival at this slice to the best candidate of all slices (its losers come a clock later): a clock
   /// for each slice behind this one, the blocks of the last slice, and the comparison with the slice before it.
   static constexpr int kClocks = [] {
      if constexpr (kIsLast) return Shift::kClocks + Column::kClocks + Window::kClocks + Winner::kClocks + 1;
      else return 1 + Next::kClocks;
   }();

   Shift shift;
   Column cost;
   Window window;
   [[no_unique_address]] Mask mask;
   DiagonalMinimum<C, (C.has_left_right_check() ? kCount : 1)> other;
   Winner winner;
   Candidates<WindowCandidate<C>, kPixels, 1> best;  ///< of this slice and those before it; its index is the disparity
   PixelTag best_tag;
   Next next;

   template <class Source, int First>
   HLS_INLINE DisparitySlice(Source& memories, MemoryId<First> first)
       : cost(memories, first),
         window(memories, MemoryId<First + Column::kMemories>()),
         next(memories, MemoryId<First + Column::kMemories + Window::kMemories>()) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("shift", shift);
      visit.block("cost", cost);
      visit.block("window", window);
      if constexpr (kFullWidth<C>) visit.block("mask", mask);
      if constexpr (C.has_left_right_check()) visit.block("other", other);
      winner.levels(visit);
      visit("best", best);
      visit("best_tag", best_tag);
   }
   /// This slice and those behind it.
   template <class Visitor>
   HLS_INLINE void groups(Visitor& visit) {
      visit.block("slice", *this, Number);
      next.groups(visit);
   }

   /// `rival`: the slice before this one, or NoRival. early_column: of the rows that come two clocks later; only signs
   /// are remembered by it.
   template <class Rival, class Settings = NoSettings, class Size = FixedSize<C>>
   HLS_INLINE void clock(const Feature<C> (&search)[kTaps], const Feature<C> (&reference)[kTaps], const PixelTag& tag,
                         const Rival& rival, const Settings& settings = Settings(), const Size& size = Size(),
                         uint16_t early_column = 0) {
      if constexpr (C.remembers_signs())
         next.clock(shift.search_out, shift.reference, shift.tag, *this, settings, size, cost.signs.column);
      else next.clock(shift.search_out, shift.reference, shift.tag, *this, settings, size);
      const auto& root = winner.root();
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         WindowCandidate<C> here = root.best.get(p, 0);
         here.index = uint8_t(kFirst + here.index);
         if constexpr (Rival::kIsNone) {
            if constexpr (kHasSecond) best.set_losers(p, 0, root.best.losers(p, 0));
            best.set(p, 0, here);
         } else if constexpr (kFalls) {
            if constexpr (kHasSecond) best.join_losers(p, 0, root.best.losers(p, 0), rival.best.losers(p, 0));
            best.join(p, 0, here, kFirst + kCount - 1, rival.best.get(p, 0), kFirst + kCount);
         } else {
            if constexpr (kHasSecond) best.join_losers(p, 0, rival.best.losers(p, 0), root.best.losers(p, 0));
            best.join(p, 0, rival.best.get(p, 0), kFirst - 1, here, kFirst);
         }
      }
      best_tag = root.tag;
      if constexpr (kFullWidth<C>) {
         WindowCost<C> shown[kPixels][kCount];
         mask.hide(window.sum, shown);
         winner.clock(shown, window.tag);
         if constexpr (C.has_left_right_check()) other.clock(window.sum, window.tag, kFirst, rival.other, mask);
      } else {
         winner.clock(window.sum, window.tag);
         if constexpr (C.has_left_right_check()) other.clock(window.sum, window.tag, kFirst, rival.other);
      }
      window.clock(cost);
      if constexpr (kFullWidth<C>) mask.clock(window.tag, rival.mask, settings, size);
      if constexpr (C.remembers_signs()) cost.clock(shift, early_column);
      else cost.clock(shift);
      shift.clock(search, reference, tag);
   }

   HLS_INLINE const auto& last() const {
      if constexpr (kIsLast) return *this;
      else return next.last();
   }
};

/// Stands before the first slice.
template <const auto& C>
struct NoRival {
   static constexpr bool kIsNone = true;
   NoDiagonal<C> other;
   [[no_unique_address]] NoMask mask;
};

/// Behind the last slice there are no disparities left.
template <const auto& C, int Number>
struct DisparitySlice<C, 0, Number> {
   static constexpr int kMemories = 0;

   template <class Source, int First>
   HLS_INLINE DisparitySlice(Source&, MemoryId<First>) {}

   template <class Visitor>
   HLS_INLINE void groups(Visitor&) {}
   template <class Rival, class Settings = NoSettings, class Size = FixedSize<C>>
   HLS_INLINE void clock(const Feature<C> (&)[C.tap_rows()], const Feature<C> (&)[C.tap_rows()], const PixelTag&,
                         const Rival&, const Settings& = Settings(), const Size& = Size(), uint16_t = 0) {}
};

}  // namespace stereo::block_matching
