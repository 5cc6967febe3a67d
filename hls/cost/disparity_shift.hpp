// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"

namespace stereo {

/// Holds the searched pixels that the reference pixels of one column are compared with, for `Count` neighbouring
/// disparities. 1 clock. Registers: taps x (Count + 2) x feature bits.
///
/// Shifts are chained: the next one takes `search_out`, `reference` and `tag` one clock later. So no pixel has to reach
/// more than `Count` costs in one clock. The newest pixel stands at the highest disparity where the reference is the
/// right image, at the lowest where it is the left one.
template <const auto& C, int Count>
struct DisparityShift {
   static constexpr int kClocks = 1;
   static constexpr int kTaps = C.tap_rows();
   static constexpr bool kFalls = C.reference == Reference::right;  ///< pixels move to lower disparities
   static constexpr int kNewest = kFalls ? Count - 1 : 0;
   static constexpr int kOldest = Count - 1 - kNewest;

   Feature<C> search[kTaps][Count];  ///< [t][i]: of tap t for the lowest disparity here plus i
   Feature<C> reference[kTaps];      ///< [t]
   Feature<C> search_out[kTaps];     ///< [t]: the searched pixel that has just left
   PixelTag tag;

   HLS_INLINE DisparityShift() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("search", search);
      visit("reference", reference);
      visit("search_out", search_out);
      visit("tag", tag);
   }

   HLS_INLINE void clock(const Feature<C> (&search_in)[kTaps], const Feature<C> (&reference_in)[kTaps],
                         const PixelTag& tag_in) {
      const bool move = tag_in.valid;
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         search_out[t] = search[t][kOldest];
         HLS_UNROLL
         for (int step = 0; step < Count - 1; ++step) {
            const int to = kFalls ? step : Count - 1 - step, from = kFalls ? to + 1 : to - 1;
            search[t][to] = select<Feature<C>>(move, search[t][from], search[t][to]);
         }
         search[t][kNewest] = select<Feature<C>>(move, search_in[t], search[t][kNewest]);
         reference[t] = reference_in[t];
      }
      tag = tag_in;
   }
};

}  // namespace stereo
