// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/feature_distance.hpp"
#include "frontend/pixel_tag.hpp"

namespace stereo {

/// Costs of the single pixels of all taps, for `Count` disparities. 2 clocks.
template <const auto& C, int Count>
struct PixelCost {
   static constexpr int kClocks = 2;
   static constexpr int kTaps = C.tap_rows();
   using Distance = FeatureDistance<C, C.cost>;
   using Value = uint_of_bits<bits_for(C.largest_pixel_cost())>;

   typename Distance::First first[kTaps][Count];
   PixelTag first_tag;
   Value cost[kTaps][Count];
   PixelTag tag;

   HLS_INLINE PixelCost() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("first", first);
      visit("first_tag", first_tag);
      visit("cost", cost);
      visit("tag", tag);
   }

   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            cost[t][i] = Value(Distance::second(first[t][i]));
            first[t][i] = Distance::first(shift.search[t][i], shift.reference[t]);
         }
      }
      tag = first_tag;
      first_tag = shift.tag;
   }
};

}  // namespace stereo
