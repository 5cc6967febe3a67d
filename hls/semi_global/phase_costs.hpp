// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/column_cost.hpp"
#include "semi_global/phase_mask.hpp"
#include "semi_global/phase_pixels.hpp"
#include "semi_global/phase_shift.hpp"
#include "semi_global/phase_window.hpp"
#include "semi_global/seen_cost.hpp"
#include "support/optional_block.hpp"
#include "winner/candidate_mask.hpp"

namespace stereo::semi_global {

/// The costs that the paths see, of a phase a clock.
template <const Config& C>
struct PhaseCosts {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static constexpr int kLanes = Stages<C>::kLanes;
   static constexpr int kTaps = kWindows.tap_rows();
   using Shift = PhaseShift<C>;
   static constexpr bool kIsSingle = kWindows.window_px == 1;
   using Column = Optional<!kIsSingle, ColumnBlock<kWindowConfig<C>, kLanes>>;
   using Window = typename std::conditional_t<kIsSingle, std::type_identity<PhasePixels<C>>,
                                              std::type_identity<PhaseWindow<C>>>::type;
   using Mask = std::conditional_t<C.full_width, PhaseMask<C, false, Stages<C>::kWindows>, NoMask>;
   static constexpr int kMemories = Shift::kMemories + Column::kMemories + Window::kMemories;
   /// From a pair's arrival to the costs of its first phase.
   static constexpr int kClocks = Shift::kClocks + Column::kClocks + Window::kClocks + 1;

   Shift shift;
   Column column;
   Window window;
   [[no_unique_address]] Mask mask;
   PathCost<C> cost[kLanes];

   template <class Source, int First>
   HLS_INLINE PhaseCosts(Source& memories, MemoryId<First> first)
       : shift(memories, first),
         column(memories, MemoryId<First + Shift::kMemories>()),
         window(memories, MemoryId<First + Shift::kMemories + Column::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("shift", shift);
      if constexpr (!kIsSingle) visit.block("column", column);
      visit.block("window", window);
      if constexpr (C.full_width) visit.block("mask", mask);
      visit("cost", cost);
   }

   template <class Line, class Settings, class Size>
   HLS_INLINE void clock(const Feature<kWindowConfig<C>> (&search)[kTaps],
                         const Feature<kWindowConfig<C>> (&reference)[kTaps], const PixelTag& tag, const Line& line,
                         [[maybe_unused]] const Settings& settings, [[maybe_unused]] const Size& size) {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) cost[l] = shown(seen_cost<C>(window.sum[0][l]), l);
      if constexpr (C.full_width) mask.clock(line, settings, size);
      if constexpr (kIsSingle) {
         window.clock(shift);
      } else {
         window.clock(column, line);
         column.clock(shift);
      }
      shift.clock(search, reference, tag);
   }

  private:
   /// As in CostSlice.
   HLS_INLINE PathCost<C> shown(PathCost<C> seen, [[maybe_unused]] int lane) const {
      constexpr PathCost<C> kLargest = C.largest_cost();
      if constexpr (C.has_border_cost()) {
         constexpr PathCost<C> kBorder = C.border_cost < int(kLargest) ? PathCost<C>(C.border_cost) : kLargest;
         const PathCost<C> inside = select<PathCost<C>>(mask.inside[lane], seen, kBorder);
         return select<PathCost<C>>(mask.is_searched(lane), inside, kLargest);
      } else if constexpr (C.full_width) {
         return select<PathCost<C>>(mask.has_candidate(lane), seen, kLargest);
      } else {
         return seen;
      }
   }
};

}  // namespace stereo::semi_global
