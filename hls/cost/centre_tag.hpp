// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/pixel_tag.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Holds what the tags say of the columns that came after a window's centre, so that a window carries its centre's tag.
template <const auto& C>
struct CentreTag {
   static constexpr int kAfter = C.columns_after();
   static constexpr int kHeld = kAfter > 0 ? kAfter : 1;

   // [j]: of the column j+1 before the newest
   bool map_column[kHeld], output_column[kHeld], first_column[kHeld], start_of_frame[kHeld], end_of_line[kHeld];

   HLS_INLINE CentreTag() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("map_column", map_column);
      visit("output_column", output_column);
      visit("first_column", first_column);
      visit("start_of_frame", start_of_frame);
      visit("end_of_line", end_of_line);
   }

   /// The centre's tag of the window that `newest` completes.
   HLS_INLINE PixelTag clock(const PixelTag& newest) {
      PixelTag centre;
      centre.valid = newest.valid;
      centre.map_column = shifted(map_column, newest.map_column, newest.valid);
      centre.output_column = shifted(output_column, newest.output_column, newest.valid);
      centre.first_column = shifted(first_column, newest.first_column, newest.valid);
      centre.start_of_frame = shifted(start_of_frame, newest.start_of_frame, newest.valid);
      centre.end_of_line = shifted(end_of_line, newest.end_of_line, newest.valid);
      return centre;
   }

  private:
   /// Takes in the newest flag; returns that of the centre.
   static HLS_INLINE bool shifted(bool (&held)[kHeld], bool newest, bool move) {
      const bool centre = kAfter > 0 ? held[kHeld - 1] : newest;
      HLS_UNROLL
      for (int j = kHeld - 1; j > 0; --j) held[j] = select<bool>(move, held[j - 1], held[j]);
      held[0] = select<bool>(move, newest, held[0]);
      return centre;
   }
};

}  // namespace stereo
