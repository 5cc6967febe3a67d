// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "configurations.hpp"
#include "disparity_slice.hpp"

namespace stereo {

/// The memories of a core. They stand beside it, not in it: a memory that is indexed at run time would tie every
/// register of the same object to memory.
template <const StereoConfig& C>
struct StereoMemories {
   typename ReferenceDelay<C>::Memory reference{};
   typename LineBuffer<C>::Memory left_rows{};
   typename LineBuffer<C>::Memory right_rows{};
};

/// The block-matching core: one call of `clock` is one clock of the hardware.
///
/// Disparity of (x,y) = the smallest d with the smallest sum over the BxB window around (x,y) of |R(x,y) - L(x+d,y)|,
/// 0 <= d < D; cost columns outside 0 ... W-D and rows outside the image count 0. (Ambrosch et al. 2007, sections 3
/// and 4.)
///
/// Input: W*H/P records a frame, any number of bubbles between them. Output: (W-D)*H/P records. A group of P rows
/// leaves while the groups below it come in, delay_groups later; after the last group of a frame come the first groups
/// of the next one, or as many groups of any valid pixels without start of frame. There is no back-pressure: a record a
/// clock is always taken.
template <const StereoConfig& C>
struct StereoCore {
   static_assert(CheckedConfig<C>::kValid);
   using ReferenceMemory = typename ReferenceDelay<C>::Memory;
   using RowMemory = typename LineBuffer<C>::Memory;
   using Slices = DisparitySlice<C, C.disparities>;

   /// Calls of `clock` from the one that takes the last pixels of a window to the one that returns its disparity.
   static constexpr int kLatency = 5 + Slices::latency();

   Raster<C> raster;
   ReferenceDelay<C> reference;
   LineBuffer<C> rows;
   Slices slices;

   HLS_INLINE StereoCore(ReferenceMemory& reference_memory, RowMemory& left_memory, RowMemory& right_memory)
       : reference(reference_memory), rows(left_memory, right_memory) {}

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const {
      const auto& last = slices.last();
      const PixelTag tag = last.best_tag;
      StereoOutput out;
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         out.disparity[p] = last.best_disparity[p];
         out.pixel_valid[p] = true;
      }
      out.valid = tag.valid && tag.output_column;
      out.start_of_frame = out.valid && tag.start_of_frame;
      out.end_of_line = out.valid && tag.end_of_line;
      return out;
   }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE StereoOutput clock(const StereoInput& in) {
      const StereoOutput out = output();
      slices.clock(rows.left, rows.right, rows.tag, NoRival<C.pixels_per_clock>());
      rows.clock(reference);
      reference.clock(raster);
      raster.clock(in);
      return out;
   }
};

}  // namespace stereo
