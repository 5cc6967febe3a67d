// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "configurations.hpp"
#include "window_sum.hpp"
#include "winner_tree.hpp"

namespace stereo {

/// The memories of a core. They stand beside it, not in it: a memory that is indexed at run time would tie every
/// register of the same object to memory.
template <const StereoConfig& C>
struct StereoMemories {
   typename ReferenceDelay<C>::Memory reference{};
   typename LineBuffer<C>::Memory rows{};
};

/// The block-matching core: one call of `clock` is one clock of the hardware.
///
/// Disparity of (x,y) = the smallest d with the smallest sum over the BxB window around (x,y) of |R(x,y) - L(x+d,y)|,
/// 0 <= d < D; cost columns outside 0 ... W-D and rows outside the image count 0. (Ambrosch et al. 2007, sections 3
/// and 4.)
///
/// Input: W*H pixel pairs a frame in raster order, any number of bubbles between them. Output: (W-D)*H disparities. Row
/// y leaves while row y + r comes in (r = window radius); after the last row of a frame come the first r rows of the
/// next one, or r rows of any valid pairs without start of frame. There is no back-pressure: a pixel pair a clock is
/// always taken.
template <const StereoConfig& C>
struct StereoCore {
   static_assert(CheckedConfig<C>::kValid);
   using ReferenceMemory = typename ReferenceDelay<C>::Memory;
   using RowMemory = typename LineBuffer<C>::Memory;
   using Winner = WinnerTree<C.disparities, C.winner_group>;

   /// Calls of `clock` from the one that takes the last pixel pair of a window to the one that returns its disparity.
   static constexpr int kLatency = 8 + Winner::kLevels;

   Raster<C> raster;
   ReferenceDelay<C> reference;
   LineBuffer<C> rows;
   DisparityShift<C> shift;
   SadCost<C> cost;
   WindowSum<C> window;
   Winner winner;

   inline StereoCore(ReferenceMemory& reference_memory, RowMemory& row_memory)
       : reference(reference_memory), rows(row_memory) {}

   /// What the registers show in this clock. Does not depend on this clock's input.
   inline StereoOutput output() const {
      const PixelTag tag = winner.winner_tag();
      StereoOutput out;
      out.disparity = winner.winner();
      out.valid = tag.valid && tag.output_column;
      out.start_of_frame = out.valid && tag.start_of_frame;
      out.end_of_line = out.valid && tag.end_of_line;
      return out;
   }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   inline StereoOutput clock(StereoInput in) {
      const StereoOutput out = output();
      winner.clock(window.sum, window.tag);
      window.clock(cost);
      cost.clock(shift);
      shift.clock(rows);
      rows.clock(reference);
      reference.clock(raster);
      raster.clock(in);
      return out;
   }
};

}  // namespace stereo
