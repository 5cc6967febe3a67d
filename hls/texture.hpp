// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "disparity_slice.hpp"

namespace stereo {

/// The configuration whose cost against a pixel of prefilter_cap is the texture.
template <const StereoConfig& C>
constexpr StereoConfig with_sad() {
   StereoConfig config = C;
   config.cost = Cost::sad;
   return config;
}
template <const StereoConfig& C>
inline constexpr StereoConfig texture_config = with_sad<C>();

/// Tells of each window whether the reference image has texture in it: the sum of |f - cap| reaches the threshold.
/// Keeps step with the slices. The sum is that of a cost block whose searched pixels all are `cap`.
template <const StereoConfig& C>
struct Texture {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   using Column = ColumnBlock<texture_config<C>, 1>;
   using Window = WindowBlock<texture_config<C>, 1>;
   static constexpr int kWait = DisparitySlice<C, C.disparities>::latency() - 1 - Column::kClocks - Window::kClocks;

   struct Taps {
      Feature<C> search[kTaps][1], reference[kTaps];
      PixelTag tag;
   } taps;
   Column cost;
   Window window;
   bool passes[kWait][kPixels];  ///< [age][p]

   template <class Source>
   HLS_INLINE explicit Texture(Source& memories)
       : cost(memories, MemoryId<memory_numbers::kTexture + memory_numbers::kColumns>()),
         window(memories, MemoryId<memory_numbers::kTexture + memory_numbers::kLastColumns>()) {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) taps.search[t][0] = taps.reference[t] = 0;
      HLS_UNROLL
      for (int age = 0; age < kWait; ++age) fill(passes[age], false);
   }

   HLS_INLINE bool passed(int p) const { return passes[kWait - 1][p]; }

   HLS_INLINE void clock(const LineBuffer<C>& rows) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int age = kWait - 1; age > 0; --age) passes[age][p] = passes[age - 1][p];
         passes[0][p] = window.sum[p][0] >= C.texture_threshold;
      }
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

}  // namespace stereo
