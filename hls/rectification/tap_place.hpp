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
      // Whole pixels, kReach too large as the places are: nothing is negative.
      const uint16_t column = uint16_t(source_x >> C.weight_bits), rows = uint16_t(offset_y >> C.weight_bits);
      HLS_UNROLL
      for (int i = 0; i < 2; ++i) {
         column_shown[i] = sample.leaves && is_inside<C.width_px>(uint16_t(column + i));
         row_shown[i] = is_kept(uint16_t(rows + i)) && is_inside<C.height_px>(uint16_t(sample.row + rows + i));
      }
      // Column -1 is kept in column 0, which will also do where no tap is shown.
      const uint16_t column_after = uint16_t(column - (kReach - 1));
      taps.column = select<uint16_t>(is_inside<C.width_px>(column), column_after, 0);
      const bool any_row = is_kept(rows) || is_kept(uint16_t(rows + 1));
      const uint16_t ago = at_most<kSlots>(select<uint16_t>(any_row, uint16_t(kReach + C.lag_rows() - rows), 0));
      const uint16_t newest = sample.taken.row;
      taps.row =
          at_most<kSlots - 1>(select<uint16_t>(newest < ago, uint16_t(newest + kSlots - ago), uint16_t(newest - ago)));
      weight_x = uint8_t(source_x & ((1 << C.weight_bits) - 1));
      weight_y = uint8_t(offset_y & ((1 << C.weight_bits) - 1));

      source_x = (uint32_t(sample.place.column) << C.weight_bits) + offsets.x.value();
      offset_y = offsets.y.value();
   }

  private:
   static constexpr int kReach = C.reach_px();
   static constexpr int kSlots = C.buffered_rows();

   /// rows: below the pixel that leaves.
   static HLS_INLINE bool is_kept(uint16_t rows) {
      constexpr int kFirst = kReach > C.rows_above ? kReach - C.rows_above : 0;
      return rows >= kFirst && rows <= kReach + C.rows_below;
   }
   template <int Side>
   static HLS_INLINE bool is_inside(uint16_t place) {
      return place >= kReach && place < kReach + Side;
   }
};

}  // namespace stereo::rectification
