// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/ports.hpp"
#include "support/registers.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// One group of the disparity map.
template <const auto& C>
struct MapGroup {
   uint16_t disparity[C.pixels_per_clock];
   bool passed[C.pixels_per_clock];
   bool valid;
   bool start_of_frame;
   bool end_of_line;

   HLS_INLINE MapGroup() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("passed", passed);
      visit("valid", valid);
      visit("start_of_frame", start_of_frame);
      visit("end_of_line", end_of_line);
   }
};

/// The group that winners make without a median.
template <const auto& C>
HLS_INLINE MapGroup<C> map_group(const Winners<C>& in) {
   MapGroup<C> out;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      out.disparity[p] = C.subpixel ? uint16_t(16 * in.disparity[p] + in.fraction[p] - 8) : in.disparity[p];
      out.passed[p] = in.passed[p];
   }
   out.valid = in.tag.valid && in.tag.output_column;
   out.start_of_frame = out.valid && in.tag.start_of_frame;
   out.end_of_line = out.valid && in.tag.end_of_line;
   return out;
}

/// Registers between the subpixel winners and the ports. 1 clock.
template <const auto& C>
struct MapRegister {
   static constexpr int kClocks = 1;
   static constexpr int kLagGroups = 0;
   static constexpr int kMemories = 0;
   MapGroup<C> out;

   template <class Source, int First>
   HLS_INLINE MapRegister(Source&, MemoryId<First>) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("out", out);
   }
   HLS_INLINE void clock(const Winners<C>& in) { out = map_group<C>(in); }
};

/// What the ports show of a group.
template <const auto& C>
HLS_INLINE StereoOutput shown(const MapGroup<C>& group) {
   StereoOutput out;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      out.disparity[p] = group.disparity[p];
      out.pixel_valid[p] = group.passed[p];
   }
   out.valid = group.valid;
   out.start_of_frame = group.start_of_frame;
   out.end_of_line = group.end_of_line;
   return out;
}

}  // namespace stereo
