// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/grid_place.hpp"
#include "rectification/pixel_pair.hpp"

namespace stereo::rectification {

/// Where the pixel that comes in is kept, and which one leaves. 3 clocks: a count, the place of the pixel that leaves,
/// and one beside the last of TapPlace.
template <const Config& C>
struct SamplePlace {
   static constexpr int kClocks = 3;
   static constexpr int kSlots = C.buffered_rows();

   LagCounter<C> place;  // clock 1
   uint16_t slot;        ///< of the row that comes in, of those that are kept; goes on from frame to frame
   PixelPair<C> pixels;

   // clock 2
   uint16_t row;         ///< of the pixel that leaves
   bool leaves, starts;  ///< a pixel of a frame leaves; it is the first one
   QuadPlace taken;      ///< where the pixels that came in are kept
   PixelPair<C> taken_pixels;

   // clock 3
   QuadPlace kept;
   PixelPair<C> kept_pixels;
   bool kept_starts;

   HLS_INLINE SamplePlace() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("place", place);
      visit("slot", slot);
      visit("pixels", pixels);
      visit("row", row);
      visit("leaves", leaves);
      visit("starts", starts);
      visit("taken", taken);
      visit("taken_pixels", taken_pixels);
      visit("kept", kept);
      visit("kept_pixels", kept_pixels);
      visit("kept_starts", kept_starts);
   }

   HLS_INLINE void clock(const PixelPair<C>& in) {
      kept = taken;
      kept_pixels = taken_pixels;
      kept_starts = starts;

      row = leaving_row<C>(place);
      leaves = row_leaves<C>(place);
      starts = place.group == C.lag_rows() && place.column == 0;
      taken.column = uint16_t(place.column + 1);  // column 0 stands for the one left of the image
      taken.row = slot;
      taken_pixels = pixels;

      const uint16_t slot_after = select<uint16_t>(slot == kSlots - 1, 0, slot + 1);
      const bool row_ends = in.valid && place.column == C.width_px - 1;
      slot = at_most<kSlots - 1>(select<uint16_t>(row_ends, slot_after, slot));
      place.clock(in.valid, in.start_of_frame);
      pixels = in;
   }
};

}  // namespace stereo::rectification
