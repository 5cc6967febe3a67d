// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo {

/// What a column carries through the pipeline beside its data.
struct PixelTag {
   bool valid = false;           ///< pixel pairs, not a bubble: blocks with history move only then
   bool row_start = false;       ///< column 0 of the image that is ahead
   bool first_group = false;     ///< the first rows of a frame come in
   uint8_t newest_inside = 0;    ///< bit p: tap p of the newest P is a row of the frame whose windows are summed
   bool border_column = false;   ///< no cost column is complete: its costs count 0
   bool first_cost = false;      ///< the first cost column of a row
   bool leaves_window = false;   ///< a cost column of the same row leaves the window that this column enters
   bool map_column = false;      ///< the cost column is the centre of a column of the map
   bool output_column = false;   ///< and the row is one of the map: an output
   bool first_column = false;    ///< column 0 of the map
   bool start_of_frame = false;  ///< column 0 of the first rows
   bool end_of_line = false;     ///< the last column of the map

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("valid", valid);
      visit("row_start", row_start);
      visit("first_group", first_group);
      visit("newest_inside", newest_inside);
      visit("border_column", border_column);
      visit("first_cost", first_cost);
      visit("leaves_window", leaves_window);
      visit("map_column", map_column);
      visit("output_column", output_column);
      visit("first_column", first_column);
      visit("start_of_frame", start_of_frame);
      visit("end_of_line", end_of_line);
   }
};

}  // namespace stereo
