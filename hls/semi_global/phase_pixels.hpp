// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/census_sum.hpp"
#include "cost/costs.hpp"
#include "cost/feature_distance.hpp"
#include "semi_global/phases.hpp"
#include "support/memory_bank.hpp"

namespace stereo::semi_global {

/// The costs of windows of a single pixel, of a phase a clock. 2 clocks, of census features 3.
template <const Config& C>
struct PhasePixels {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static_assert(kWindows.window_px == 1);
   static constexpr int kLanes = Stages<C>::kLanes;
   static constexpr bool kIsCensus = kWindows.cost == Cost::census;
   static constexpr int kClocks = kIsCensus ? 3 : 2;
   static constexpr int kMemories = 0;
   using Census = CensusSum<kWindowConfig<C>>;
   using Distance = std::conditional_t<kIsCensus, Census,
                                       FeatureDistance<kWindowConfig<C>, (kIsCensus ? Cost::sad : kWindows.cost)>>;

   typename Distance::First first[kLanes];
   typename Census::Second second[kLanes];
   WindowCost<kWindowConfig<C>> sum[1][kLanes];

   template <class Source, int Number>
   HLS_INLINE PhasePixels(Source&, MemoryId<Number>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("first", first);
      if constexpr (kIsCensus) visit("second", second);
      visit("sum", sum);
   }

   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         if constexpr (kIsCensus) {
            sum[0][l] = WindowCost<kWindowConfig<C>>(Census::third(second[l]));
            second[l] = Census::second(first[l]);
         } else {
            sum[0][l] = WindowCost<kWindowConfig<C>>(Distance::second(first[l]));
         }
         first[l] = Distance::first(shift.search[0][l], shift.reference[0]);
      }
   }
};

}  // namespace stereo::semi_global
