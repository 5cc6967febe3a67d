// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"

namespace stereo {

/// The census transforms of P rows of one image. 2 clocks behind the columns.
template <const auto& C>
struct Census {
   static constexpr int kClocks = 2;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2 * C.transform_rows();
   static constexpr int kColumns = C.census_width_px;

   Pixel<C> column[kColumns][kRows];  ///< [age][row]; 0 outside the image
   Feature<C> feature[kPixels];

   HLS_INLINE Census() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("feature", feature);
   }

   template <class Inside>
   HLS_INLINE void clock(bool move, const Pixel<C> (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) feature[p] = transform(p, column_inside);
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         HLS_UNROLL
         for (int age = kColumns - 1; age > 0; --age)
            column[age][row] = select<Pixel<C>>(move, column[age - 1][row], column[age][row]);
         column[0][row] = select<Pixel<C>>(move, select<Pixel<C>>(row_inside[row], pixel[row], 0), column[0][row]);
      }
   }

  private:
   template <class Inside>
   HLS_INLINE Feature<C> transform(int p, const Inside& column_inside) const {
      const Pixel<C> centre = column[kColumns / 2][p + C.transform_rows()];
      Feature<C> bits = 0;
      int bit = 0;
      HLS_UNROLL
      for (int age = 0; age < kColumns; ++age) {
         HLS_UNROLL
         for (int row = 0; row < C.census_height_px; ++row) {
            if constexpr (C.census_pattern == CensusPattern::all) {
               if (age == kColumns / 2 && row == C.transform_rows()) continue;
            } else {
               if (!has_census_bit(C.census_pattern, age - kColumns / 2, row - C.transform_rows())) continue;
            }
            const bool larger = column_inside[age] && column[age][p + row] > centre;
            bits |= Feature<C>(Feature<C>(larger) << bit++);
         }
      }
      return bits;
   }
};

}  // namespace stereo
