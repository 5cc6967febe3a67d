// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/clock_delay.hpp"
#include "rectification/config.hpp"
#include "rectification/quad_memory.hpp"
#include "support/raster_counter.hpp"

namespace stereo::rectification {

/// Counts the pixels that come in, and the rows of a frame that leave lag_rows() later, those of the next frame too.
template <const Config& C>
using LagCounter = RasterCounter<C.width_px, C.height_px, C.lag_rows(), true>;

/// The row of the frame that leaves; only while there is one.
template <const Config& C>
HLS_INLINE uint16_t leaving_row(const LagCounter<C>& place) {
   return at_most<C.height_px - 1>(unsigned(place.group - C.lag_rows()));
}
template <const Config& C>
HLS_INLINE bool row_leaves(const LagCounter<C>& place) {
   return place.group >= C.lag_rows() && place.group != LagCounter<C>::kIdle;
}

/// Where the pixel that leaves stands between the nodes of the table. 1 clock.
template <const Config& C>
struct GridPlace {
   static constexpr int kClocks = 1;
   /// As long as the nodes take to be read.
   using Weight = ClockDelay<uint8_t, kClocks + QuadMemory<uint32_t, 2, 2>::kClocks>;

   QuadPlace node;  ///< the upper left one
   Weight weight_x, weight_y;

   HLS_INLINE GridPlace() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("node", node);
      visit("weight_x", weight_x);
      visit("weight_y", weight_y);
   }

   HLS_INLINE void clock(const LagCounter<C>& place) {
      const uint16_t row = select<uint16_t>(row_leaves<C>(place), leaving_row<C>(place), 0);
      node.column = uint16_t(place.column >> C.grid_bits());
      node.row = uint16_t(row >> C.grid_bits());
      weight_x.clock(uint8_t(place.column & (C.grid_px - 1)));
      weight_y.clock(uint8_t(row & (C.grid_px - 1)));
   }
};

}  // namespace stereo::rectification
