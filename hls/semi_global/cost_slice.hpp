// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/column_cost.hpp"
#include "cost/disparity_shift.hpp"
#include "cost/single_column.hpp"
#include "cost/window_sum.hpp"
#include "semi_global/config.hpp"
#include "semi_global/seen_cost.hpp"
#include "winner/candidate_mask.hpp"

namespace stereo::semi_global {

/// The block that makes window costs of column costs.
template <const auto& W, int Count, bool IsSingle>
struct CostWindow {
   using Block = WindowBlock<W, Count>;
};
template <const auto& W, int Count>
struct CostWindow<W, Count, true> {
   using Block = SingleColumn<W, Count>;
};

/// Behind the last slice there are no disparities left.
template <const Config& C>
struct NoCostSlice {
   static constexpr int kMemories = 0;
   static constexpr int kSlices = 0;

   template <class Source, int First>
   HLS_INLINE NoCostSlice(Source&, MemoryId<First>) {}

   template <class Visitor>
   HLS_INLINE void groups(Visitor&) {}
   template <class... Ignored>
   HLS_INLINE void clock(const Ignored&...) {}
   HLS_INLINE void put(PathCost<C> (&)[C.disparities]) const {}
};

/// The costs that the paths see, for the last `Disparities` disparities that the searched pixels meet. Slices work one
/// clock behind each other, as those of block matching do (block_matching/disparity_slice.hpp); here each holds its
/// costs back until those of the last one are there, since a path needs all of a column at once.
template <const Config& C, int Disparities = C.disparities, int Number = 0>
struct CostSlice {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static constexpr int kTaps = kWindows.tap_rows();
   static constexpr int kCount = kWindows.first_slice(Disparities);
   static constexpr int kRest = Disparities - kCount;
   static constexpr int kFirst =
       kWindows.reference == Reference::right ? kRest : C.disparities - Disparities;  ///< lowest disparity here
   using Next = std::conditional_t<kRest == 0, NoCostSlice<C>, CostSlice<C, kRest, Number + 1>>;
   using Shift = DisparityShift<kWindowConfig<C>, kCount>;
   using Column = ColumnBlock<kWindowConfig<C>, kCount>;
   using Window = typename CostWindow<kWindowConfig<C>, kCount, kWindows.window_px == 1>::Block;
   using Mask = std::conditional_t<C.full_width, CandidateMask<kWindowConfig<C>, kCount, kFirst>, NoMask>;
   using Value = PathCost<C>;
   static constexpr Value kLargest = C.largest_cost();
   static constexpr int kSlices = 1 + Next::kSlices;
   static constexpr int kMemories = Column::kMemories + Window::kMemories + Next::kMemories;
   /// From the rows' arrival to the costs of all slices.
   static constexpr int kClocks = Shift::kClocks + Column::kClocks + Window::kClocks + kSlices;

   Shift shift;
   Column cost;
   Window window;
   [[no_unique_address]] Mask mask;
   Value held[kSlices][kCount];  ///< [age][i]
   PixelTag tag[kSlices];        ///< [age]
   Next next;

   template <class Source, int First>
   HLS_INLINE CostSlice(Source& memories, MemoryId<First> first)
       : cost(memories, first),
         window(memories, MemoryId<First + Column::kMemories>()),
         next(memories, MemoryId<First + Column::kMemories + Window::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("shift", shift);
      visit.block("cost", cost);
      visit.block("window", window);
      if constexpr (C.full_width) visit.block("mask", mask);
      visit("held", held);
      visit("tag", tag);
   }
   /// This slice and those behind it.
   template <class Visitor>
   HLS_INLINE void groups(Visitor& visit) {
      visit.block("slice", *this, Number);
      next.groups(visit);
   }

   /// Puts the costs of this slice and of those behind it in their places.
   HLS_INLINE void put(Value (&costs)[C.disparities]) const {
      HLS_UNROLL
      for (int i = 0; i < kCount; ++i) costs[kFirst + i] = held[kSlices - 1][i];
      next.put(costs);
   }
   /// Of the costs that put() shows.
   HLS_INLINE const PixelTag& shown_tag() const { return tag[kSlices - 1]; }

   /// mask_before: of the slice before this one.
   template <class Settings = NoSettings, class Size = FixedSize<kWindowConfig<C>>, class MaskBefore = NoMask>
   HLS_INLINE void clock(const Feature<kWindowConfig<C>> (&search)[kTaps],
                         const Feature<kWindowConfig<C>> (&reference)[kTaps], const PixelTag& tag_in,
                         const Settings& settings = Settings(), const Size& size = Size(),
                         const MaskBefore& mask_before = MaskBefore()) {
      next.clock(shift.search_out, shift.reference, shift.tag, settings, size, mask);
      HLS_UNROLL
      for (int age = kSlices - 1; age > 0; --age) {
         HLS_UNROLL
         for (int i = 0; i < kCount; ++i) held[age][i] = held[age - 1][i];
         tag[age] = tag[age - 1];
      }
      HLS_UNROLL
      for (int i = 0; i < kCount; ++i) {
         Value seen = seen_cost<C>(window.sum[0][i]);
         if constexpr (kHasBorderCost) seen = beside_border(seen, i);
         else if constexpr (C.full_width) seen = select<Value>(mask.has_candidate(i), seen, kLargest);
         held[0][i] = seen;
      }
      tag[0] = window.tag;
      window.clock(cost);
      if constexpr (C.full_width) mask.clock(window.tag, mask_before, settings, size);
      cost.clock(shift);
      shift.clock(search, reference, tag_in);
   }

  private:
   static constexpr bool kHasBorderCost = [] {
      if constexpr (requires { C.has_border_cost(); }) return C.has_border_cost();
      else return false;
   }();

   /// What is searched and leads out of the other image has the border cost.
   HLS_INLINE Value beside_border(Value seen, int i) const {
      constexpr Value kBorder = C.border_cost < int(kLargest) ? Value(C.border_cost) : kLargest;
      const Value inside = select<Value>(mask.inside[i], seen, kBorder);
      return select<Value>(mask.is_searched(i), inside, kLargest);
   }
};

}  // namespace stereo::semi_global
