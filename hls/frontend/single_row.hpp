// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/pair_delay.hpp"

namespace stereo {

/// Stands for the line buffer where windows have a single pixel: the row that comes in is all that they need. 1 clock.
template <const auto& C>
struct SingleRow {
   static_assert(C.window_px == 1 && C.pixels_per_clock == 1);
   static constexpr int kClocks = 1;
   static constexpr int kLagGroups = 0;
   static constexpr int kMemories = 0;

   Feature<C> search[1], reference[1];
   PixelTag tag;

   template <class Source, int First>
   HLS_INLINE SingleRow(Source&, MemoryId<First>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("search", search);
      visit("reference", reference);
      visit("tag", tag);
   }

   HLS_INLINE void clock(const PairDelay<C>& in) {
      search[0] = in.search(0);
      reference[0] = in.reference(0);
      tag = in.tag;
   }
};

}  // namespace stereo
