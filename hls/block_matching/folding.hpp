// SPDX-License-Identifier: Apache-2.0
// A core with several clocks a pixel pair is made of two that are not folded: rows come in as in a core without
// disparities, and are matched in passes as by a core of few disparities.
#pragma once

#include "block_matching/config.hpp"
#include "support/hls_support.hpp"

namespace stereo::block_matching {

/// What brings the rows in: the images meet without an offset.
template <const auto& C>
inline constexpr auto kFront = [] {
   auto front = C;
   front.disparities = 1;
   front.min_disparity = 0;
   return front;
}();

/// What matches them. A row of it is all passes over a row of the image, one behind the other.
template <const auto& C>
inline constexpr auto kLanes = [] {
   auto lanes = C;
   lanes.disparities = C.pass_disparities();
   lanes.width_px = C.passes_columns();
   return lanes;
}();

/// What a row of the image is in its frame.
struct RowPlace {
   bool first_group;  ///< the frame's first row has just come in
   bool output;       ///< the windows around it make a row of the map
   bool starts;       ///< and the first one

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("first_group", first_group);
      visit("output", output);
      visit("starts", starts);
   }
};

/// Two rows in a memory, each with a power of two of places.
template <const auto& C>
struct TwoRows {
   static constexpr int kColumnBits = bits_for(C.width_px - 1);
   static constexpr int kColumns = 1 << kColumnBits;
   static constexpr int kPlaces = 2 * kColumns;

   static HLS_INLINE constexpr uint16_t column(unsigned place) { return wrapped<kColumns>(place); }
   static HLS_INLINE uint16_t address(bool row, unsigned place) {
      return uint16_t(uint16_t(uint16_t(row) << kColumnBits) | column(place));
   }
};

}  // namespace stereo::block_matching
