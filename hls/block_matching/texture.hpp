// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/column_cost.hpp"
#include "cost/window_sum.hpp"
#include "frontend/line_buffer.hpp"
#include "support/settings.hpp"

namespace stereo::block_matching {

/// The configuration whose cost against a pixel of prefilter_cap is the texture.
template <const auto& C>
inline constexpr auto kTextureConfig = [] {
   auto config = C;
   config.cost = Cost::sad;
   config.sign_memory = false;  // its pixels do not come back
   return config;
}();

/// Tells of each window whether the reference image has texture in it: the sum of |f - cap| reaches the threshold.
/// Keeps step with the winners, which come `Clocks` clocks after the rows. The sum is that of a cost block whose
/// searched pixels all are `cap`.
template <const auto& C, int Clocks>
struct Texture {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   using Column = ColumnBlock<kTextureConfig<C>, 1>;
   using Window = WindowBlock<kTextureConfig<C>, 1>;
   static constexpr int kWait = Clocks - 1 - Column::kClocks - Window::kClocks;
   static constexpr int kMemories = Column::kMemories + Window::kMemories;

   struct Taps {
      Feature<C> search[kTaps][1], reference[kTaps];
      PixelTag tag;

      HLS_INLINE Taps() { start(*this); }

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("search", search);
         visit("reference", reference);
         visit("tag", tag);
      }
   } taps;
   Column cost;
   Window window;
   bool passes[kWait][kPixels];  ///< [age][p]
   [[no_unique_address]] TakenOver<C, uint16_t> least;

   template <class Source, int First>
   HLS_INLINE Texture(Source& memories, MemoryId<First> first)
       : cost(memories, first), window(memories, MemoryId<First + Column::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("taps", taps);
      visit.block("cost", cost);
      visit.block("window", window);
      visit("passes", passes);
      if constexpr (kSetAtRunTime<C>) visit("least", least.value, C.texture_threshold);
   }

   HLS_INLINE bool passed(int p) const { return passes[kWait - 1][p]; }

   /// rows: the LineBuffer, or what stands between it and the slices.
   template <class Rows, class Settings>
   HLS_INLINE void clock(const Rows& rows, const Settings& settings) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int age = kWait - 1; age > 0; --age) passes[age][p] = passes[age - 1][p];
         if constexpr (kSetAtRunTime<C>) passes[0][p] = window.sum[p][0] >= least.value;
         else passes[0][p] = window.sum[p][0] >= C.texture_threshold;
      }
      // The column comes in of which the window is the next sum: none of the frame before is still to come.
      if constexpr (kSetAtRunTime<C>)
         least.value =
             select<uint16_t>(is_first_of_frame(window.newest(cost)), settings.texture_threshold, least.value);
      window.clock(cost);
      cost.clock(taps);
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         taps.search[t][0] = select<Feature<C>>(rows.inside[t], C.prefilter_cap, 0);
         taps.reference[t] = rows.reference[t];
      }
      taps.tag = rows.tag;
   }
};

}  // namespace stereo::block_matching
