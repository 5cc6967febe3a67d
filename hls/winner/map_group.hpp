// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/ports.hpp"
#include "support/registers.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// Numbers and bits beside the disparities of a group, where the post-processing gives them.
template <class Value, int Lanes>
struct BesideDisparities {
   Value value[Lanes];
};
template <class Value>
struct NothingBeside {};
template <const auto& C>
using MapConfidence =
    std::conditional_t<kHasMargin<C>, BesideDisparities<uint8_t, C.pixels_per_clock>, NothingBeside<uint8_t>>;
template <const auto& C>
inline constexpr bool kFillsHoles = [] {
   if constexpr (requires { C.fill_holes; }) return C.fill_holes;
   else return false;
}();
template <const auto& C>
using MapFilled = std::conditional_t<kFillsHoles<C>, BesideDisparities<bool, C.pixels_per_clock>, NothingBeside<bool>>;

/// One group of the disparity map.
template <const auto& C>
struct MapGroup {
   uint16_t disparity[C.pixels_per_clock];
   bool passed[C.pixels_per_clock];
   [[no_unique_address]] MapConfidence<C> confidence;
   [[no_unique_address]] MapFilled<C> filled;
   bool valid;
   bool start_of_frame;
   bool end_of_line;

   HLS_INLINE MapGroup() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("passed", passed);
      if constexpr (kHasMargin<C>) visit("confidence", confidence.value);
      if constexpr (kFillsHoles<C>) visit("filled", filled.value);
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
using ShownOutput = std::conditional_t<kHasMargin<C> || kFillsHoles<C>, PostOutput, StereoOutput>;
template <const auto& C>
HLS_INLINE ShownOutput<C> shown(const MapGroup<C>& group) {
   ShownOutput<C> out;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      out.disparity[p] = group.disparity[p];
      out.pixel_valid[p] = group.passed[p];
      if constexpr (kHasMargin<C>) out.confidence[p] = group.confidence.value[p];
      if constexpr (kFillsHoles<C>) out.filled[p] = group.filled.value[p];
   }
   out.valid = group.valid;
   out.start_of_frame = group.start_of_frame;
   out.end_of_line = group.end_of_line;
   return out;
}

/// What the word of an output has for row `p` (LaneLayout), in its lowest bits.
template <const auto& C, class Word, class Output>
HLS_INLINE Word output_lane(const Output& out, int p) {
   Word lane = Word(out.disparity[p]);
   if constexpr (kFillsHoles<C>) lane |= Word(Word(out.filled[p]) << 15);
   if constexpr (kHasMargin<C>) lane |= Word(Word(out.confidence[p]) << (C.disparity_bits() - 8));
   return lane;
}

}  // namespace stereo
