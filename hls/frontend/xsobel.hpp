// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"

namespace stereo {

/// The x-Sobel prefilter of P rows of one image. 2 clocks behind the columns.
template <const auto& C>
struct XSobel {
   static constexpr int kClocks = 2;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2;

   uint16_t column[3][kPixels];  ///< [age][p]: weighted sum of three rows, 0 ... 1020
   Feature<C> feature[kPixels];

   HLS_INLINE XSobel() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("feature", feature);
   }

   /// move: `pixel` is a column, not a bubble. row_inside: its rows lie in the image; column_inside: [age], the columns
   /// that have come lie in it.
   template <class Inside>
   HLS_INLINE void clock(bool move, const uint8_t (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const int16_t slope = int16_t(column[0][p] - column[2][p]);
         const int16_t low = select<int16_t>(slope < -C.prefilter_cap, -C.prefilter_cap, slope);
         const int16_t clamped = select<int16_t>(low > C.prefilter_cap, C.prefilter_cap, low);
         const bool whole = column_inside[0] && column_inside[2];
         feature[p] = Feature<C>(select<int16_t>(whole, clamped, 0) + C.prefilter_cap);
         // Outside the image stands the row on the other side.
         const uint8_t above = select<uint8_t>(row_inside[p], pixel[p], pixel[p + 2]);
         const uint8_t below = select<uint8_t>(row_inside[p + 2], pixel[p + 2], pixel[p]);
         column[2][p] = select<uint16_t>(move, column[1][p], column[2][p]);
         column[1][p] = select<uint16_t>(move, column[0][p], column[1][p]);
         column[0][p] = select<uint16_t>(move, uint16_t(above + 2 * pixel[p + 1] + below), column[0][p]);
      }
   }
};

}  // namespace stereo
