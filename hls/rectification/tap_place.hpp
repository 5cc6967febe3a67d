// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/offsets.hpp"
#include "rectification/sample_place.hpp"

namespace stereo::rectification {

/// Which four pixels of a camera's image make the pixel that leaves, and with which weights. 2 clocks: the place in the
/// camera's image, and where it is kept.
template <const Config& C>
struct TapPlace {
   static constexpr int kClocks = 2;

   // clock 1, in 2^-weight_bits pixels, reach_px() too large
   uint32_t source_x;
   uint32_t offset_y;  ///< from the row of the pixel that leaves
   // clock 2
   QuadPlace taps;                      ///< the upper left one
   uint8_t weight_x, weight_y;          ///< of the right and of the lower ones
   bool column_shown[2], row_shown[2];  ///< the others count 0

   HLS_INLINE TapPlace() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("source_x", source_x);
      visit("offset_y", offset_y);
      visit("taps", taps);
      visit("weight_x", weight_x);
      visit("weight_y", weight_y);
      visit("column_shown", column_shown);
      visit("row_shown", row_shown);
   }

   HLS_INLINE void clock(const Offsets<C>& offsets, const SamplePlace<C>& sample) {
      const int32_t column = int32_t(source_x >> C.weight_bits) - C.reach_px();
      const int32_t rows = int32_t(offset_y >> C.weight_bits) - C.reach_px();
      HLS_UNROLL
      for (int i = 0; i < 2; ++i) {
         column_shown[i] = sample.leaves && column + i >= 0 && column + i < C.width_px;
         row_shown[i] = is_kept(rows + i) && is_inside(sample.row + rows + i);
      }
      // Column -1 is kept in column 0, which will also do where no tap is shown.
      const bool any_column = column >= 0 && column < C.width_px;
      const bool any_row = is_kept(rows) || is_kept(rows + 1);
      const int32_t slot = sample.taken.row - C.lag_rows() + select<int32_t>(any_row, rows, 0);
      taps.column = uint16_t(select<int32_t>(any_column, column + 1, 0));
      taps.row = uint16_t(select<int32_t>(slot < 0, slot + C.buffered_rows(), slot));
      weight_x = uint8_t(source_x & ((1 << C.weight_bits) - 1));
      weight_y = uint8_t(offset_y & ((1 << C.weight_bits) - 1));

      source_x = (uint32_t(sample.place.column) << C.weight_bits) + offsets.x.value;
      offset_y = offsets.y.value;
   }

  private:
   /// rows: below the pixel that leaves.
   static HLS_INLINE bool is_kept(int32_t rows) { return rows >= -C.rows_above && rows <= C.rows_below; }
   static HLS_INLINE bool is_inside(int32_t row) { return row >= 0 && row < C.height_px; }
};

}  // namespace stereo::rectification
