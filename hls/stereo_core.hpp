// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "configurations.hpp"
#include "median.hpp"
#include "transform.hpp"

namespace stereo {

/// Stands for a block that a configuration does not have.
struct Absent {
   template <class Source>
   HLS_INLINE explicit Absent(Source&) {}
};
template <bool Present, class Block>
using Optional = std::conditional_t<Present, Block, Absent>;

/// The block-matching core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H/P records a frame, any number of bubbles between them. Output: map width * H/P records. A group of P rows
/// leaves while the groups below it come in; after the last group of a frame come the first groups of the next one, or
/// C.flush_groups() groups of any valid pixels without start of frame. There is no back-pressure: a record a clock is
/// always taken.
template <const StereoConfig& C>
struct StereoCore {
   static_assert(CheckedConfig<C>::kValid);
   using Slices = DisparitySlice<C, C.disparities>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock = std::conditional_t<C.median, Median<C>, MapRegister<C>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel;

   /// Calls of `clock` from the one that takes the last pixels that a disparity depends on, or the group that must
   /// follow them, to the one that returns the disparity.
   static constexpr int kLatency =
       (C.has_transform() ? Transform<C>::kClocks : 0) + 5 + Slices::latency() + Refinement<C>::kClocks +
       (C.has_left_right_check() ? LeftRightCheck<C>::kClocks : 0) + (kHasMapBlock ? MapBlock::kClocks : 0);

   Optional<C.has_transform(), Transform<C>> transform;
   Raster<C> raster;
   PairDelay<C> delay;
   LineBuffer<C> rows;
   Slices slices;
   Optional<C.has_texture_check(), Texture<C>> texture;
   Refinement<C> refinement;
   Optional<C.has_left_right_check(), LeftRightCheck<C>> left_right;
   Optional<kHasMapBlock, MapBlock> map_block;

   /// `memories`: see MemoryBank.
   template <class Source>
   HLS_INLINE explicit StereoCore(Source& memories)
       : transform(memories),
         delay(memories),
         rows(memories),
         slices(memories),
         texture(memories),
         left_right(memories),
         map_block(memories) {}

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const {
      const MapGroup<C> group = map();
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

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE StereoOutput clock(const StereoInput& in) {
      const StereoOutput out = output();
      if constexpr (kHasMapBlock) map_block.clock(checked());
      if constexpr (C.has_left_right_check())
         left_right.clock(refinement.output(slices.last(), texture), slices.last());
      refinement.clock(slices.last(), texture);
      if constexpr (C.has_texture_check()) texture.clock(rows);
      slices.clock(rows.search, rows.reference, rows.tag, NoRival<C>());
      rows.clock(delay);
      delay.clock(raster);
      if constexpr (C.has_transform()) {
         raster.clock(transform.output());
         transform.clock(in);
      } else {
         raster.clock(grey_values(in));
      }
      return out;
   }

  private:
   HLS_INLINE Winners<C> checked() const {
      if constexpr (C.has_left_right_check()) return left_right.checked;
      else return refinement.output(slices.last(), texture);
   }

   HLS_INLINE MapGroup<C> map() const {
      if constexpr (kHasMapBlock) return map_block.out;
      else return map_group<C>(checked());
   }

   static HLS_INLINE FeatureGroup<C> grey_values(const StereoInput& in) {
      FeatureGroup<C> group;
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         group.search[p] = C.reference == Reference::right ? in.left[p] : in.right[p];
         group.reference[p] = C.reference == Reference::right ? in.right[p] : in.left[p];
      }
      group.start_of_frame = in.start_of_frame;
      group.valid = in.valid;
      return group;
   }
};

}  // namespace stereo
