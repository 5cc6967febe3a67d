// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"
#include "frontend/image_size.hpp"
#include "support/raster_counter.hpp"
#include "support/structure_groups.hpp"

namespace stereo {

/// Gives each group its place in the frame. 1 clock.
template <const auto& C>
struct Raster {
   static constexpr int kClocks = 1;

   FeatureGroup<C> features;
   FrontCounter<kFrontClocks<C>, C.width_px, C.row_groups(), C.delay_groups(), C.aggregation == Aggregation::direct>
       place;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("features", features);
      visit("place", place);
   }

   template <class Size = FixedSize<C>>
   HLS_INLINE void clock(const FeatureGroup<C>& in, const Size& size = Size()) {
      place.clock(in.valid, in.start_of_frame, size.windows);
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         features.search[p] = in.search[p];
         features.reference[p] = in.reference[p];
      }
      features.valid = in.valid;
   }
};

}  // namespace stereo
