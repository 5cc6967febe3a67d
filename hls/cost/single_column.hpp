// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/memory_bank.hpp"
#include "support/registers.hpp"

namespace stereo {

/// The window costs of windows of a single pixel: its cost. 1 clock.
template <const auto& C, int Count>
struct SingleColumn {
   static_assert(C.window_px == 1);
   static constexpr int kClocks = 1;
   static constexpr int kMemories = 0;
   static constexpr int kPixels = C.pixels_per_clock;

   WindowCost<C> sum[kPixels][Count];
   PixelTag tag;

   template <class Source, int Number>
   HLS_INLINE SingleColumn(Source&, MemoryId<Number>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("sum", sum);
      visit("tag", tag);
   }

   template <class Column>
   HLS_INLINE void clock(const Column& cost) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) sum[p][i] = cost.column[p][i];
      }
      tag = cost.tag;
   }
};

}  // namespace stereo
