// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trellis/config.hpp"
#include "winner/winners.hpp"

namespace stereo::trellis {

/// Gives occluded pixels the disparity of the nearest one to their left that is not, 0 where there is none. 1 clock.
template <const Config& C>
struct OcclusionFill {
   static constexpr int kClocks = 1;
   using Pixels = Winners<semi_global::kSumConfig<kCostConfig<C>>>;

   Pixels out;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("out", out);
   }

   HLS_INLINE void clock(const Pixels& in) {
      const bool comes = in.tag.valid && in.tag.map_column;
      const uint8_t left = select<uint8_t>(in.tag.first_column, 0, out.disparity[0]);
      const uint8_t here = select<uint8_t>(in.passed[0], in.disparity[0], left);
      out.disparity[0] = select<uint8_t>(comes, here, out.disparity[0]);
      out.passed[0] = in.passed[0] || !C.mark_occluded;
      out.tag = in.tag;
   }
};

}  // namespace stereo::trellis
