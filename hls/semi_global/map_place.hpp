// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace stereo::semi_global {

/// What a column's tag says of its place in the map. Without starting values of its own: see StartingValues.
struct MapPlace {
   bool map_column;
   bool output_column;
   bool first_column;
   bool start_of_frame;
   bool end_of_line;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("map_column", map_column);
      visit("output_column", output_column);
      visit("first_column", first_column);
      visit("start_of_frame", start_of_frame);
      visit("end_of_line", end_of_line);
   }
};

}  // namespace stereo::semi_global
