// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "semi_global/config.hpp"

namespace stereo::semi_global {

/// The cost that paths see of a window's.
template <const Config& C>
HLS_INLINE PathCost<C> seen_cost(WindowCost<kWindowConfig<C>> sum) {
   using Sum = WindowCost<kWindowConfig<C>>;
   constexpr bool kHasCap = (kWindowConfig<C>.largest_window_cost() >> C.cost_shift) > C.cost_cap;
   const Sum shifted = Sum(sum >> C.cost_shift);
   if constexpr (kHasCap) return PathCost<C>(select<Sum>(shifted > C.cost_cap, C.cost_cap, shifted));
   else return PathCost<C>(shifted);
}

}  // namespace stereo::semi_global
