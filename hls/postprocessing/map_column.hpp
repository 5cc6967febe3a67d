// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"
#include "winner/map_group.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// Bits of a disparity of the map, in its steps.
template <const auto& C>
inline constexpr int kMapBits = bits_for(C.steps_per_pixel() * (C.disparities - 1));

/// Bits of what travels beside a disparity: whether it is valid, and what says how sure it is.
template <const auto& C>
inline constexpr int kSureBits = C.has_confidence() ? 8 : 0;

/// Whether the family tells how far the runner-up was; the margin of a confidence is 0 where it does not.
template <const auto& C>
inline constexpr bool kHasRunnerUp = [] {
   if constexpr (requires { C.has_runner_up(); }) return C.has_runner_up();
   else return true;
}();

/// One column of a group of rows of the map, between the stages of the post-processing.
template <const auto& C>
struct MapColumn {
   uint16_t disparity[C.pixels_per_clock];
   bool passed[C.pixels_per_clock];
   uint8_t sure[C.pixels_per_clock];  ///< the margin, from the support filter on the confidence
   bool filled[C.pixels_per_clock];
   PixelTag tag;

   HLS_INLINE MapColumn() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("passed", passed);
      if constexpr (C.has_confidence()) visit("sure", sure);
      if constexpr (C.fill_holes) visit("filled", filled);
      visit("tag", tag);
   }
};

/// Of the winners of a family. W: the configuration of their blocks.
template <const auto& C, const auto& W>
HLS_INLINE MapColumn<C> map_column(const Winners<W>& in) {
   MapColumn<C> out;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      out.disparity[p] = C.subpixel ? uint16_t(16 * in.disparity[p] + in.fraction[p] - 8) : in.disparity[p];
      out.passed[p] = in.passed[p];
      if constexpr (C.has_confidence() && kHasRunnerUp<C>) out.sure[p] = in.margin.value[p];
   }
   out.tag = in.tag;
   return out;
}

/// What the ports show of a column, or what a median makes one of.
template <const auto& C>
HLS_INLINE MapGroup<C> map_group(const MapColumn<C>& in) {
   MapGroup<C> out;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      out.disparity[p] = in.disparity[p];
      out.passed[p] = in.passed[p];
      if constexpr (C.has_confidence()) out.confidence.value[p] = in.sure[p];
      if constexpr (C.fill_holes) out.filled.value[p] = in.filled[p];
   }
   out.valid = in.tag.valid & in.tag.output_column;
   out.start_of_frame = out.valid & in.tag.start_of_frame;
   out.end_of_line = out.valid & in.tag.end_of_line;
   return out;
}

}  // namespace stereo
