// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/window_bases.hpp"
#include "winner/candidate.hpp"
#include "winner/candidates.hpp"

namespace stereo::dynamic_range {

/// The better one of what the two search windows found: that of the low one unless the other has a smaller sum. 1
/// clock.
template <const Config& C, const auto& Window>
struct TrackChoice {
   static constexpr int kClocks = 1;
   using Candidate = WindowCandidate<Window>;
   using Value = typename Candidate::Value;

   Candidates<Candidate, 1, 1> best;  ///< its index counts from `base`
   PixelTag best_tag;
   uint16_t base;

   HLS_INLINE TrackChoice() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("best", best);
      visit("best_tag", best_tag);
      visit("base", base);
   }

   HLS_INLINE void clock(const Candidate& low, const Candidate& high, const PixelTag& tag, uint16_t low_base,
                         uint16_t high_base) {
      const bool takes_high = high.cost < low.cost;
      Candidate taken;
      taken.cost = select<Value>(takes_high, high.cost, low.cost);
      taken.index = select<uint8_t>(takes_high, high.index, low.index);
      if constexpr (Candidate::kHasNeighbours) {
         taken.below = select<Value>(takes_high, high.below, low.below);
         taken.above = select<Value>(takes_high, high.above, low.above);
      }
      best.set(0, 0, taken);
      best_tag = tag;
      base = select<uint16_t>(takes_high, high_base, low_base);
   }
};

}  // namespace stereo::dynamic_range
