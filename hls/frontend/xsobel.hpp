// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"

namespace stereo {

/// The x-Sobel prefilter of P rows of one image. 3 clocks behind the columns: sum of a column, slope, clamp.
template <const auto& C>
struct XSobel {
   static constexpr int kClocks = 3;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2;

   uint16_t column[3][kPixels];  ///< [age][p]: weighted sum of three rows, 0 ... 4 times the largest pixel
   int16_t slope[kPixels];       ///< the difference of two of them
   bool whole;                   ///< both columns of the slope lie in the image
   Feature<C> feature[kPixels];

   HLS_INLINE XSobel() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("slope", slope);
      visit("whole", whole);
      visit("feature", feature);
   }

   /// move: `pixel` is a column, not a bubble. row_inside: its rows lie in the image; column_inside: [age], the columns
   /// that have come lie in it.
   template <class Inside>
   HLS_INLINE void clock(bool move, const Pixel<C> (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         feature[p] = clamped(slope[p]);
         slope[p] = int16_t(column[0][p] - column[2][p]);
         // Outside the image stands the row on the other side.
         const Pixel<C> above = select<Pixel<C>>(row_inside[p], pixel[p], pixel[p + 2]);
         const Pixel<C> below = select<Pixel<C>>(row_inside[p + 2], pixel[p + 2], pixel[p]);
         column[2][p] = select<uint16_t>(move, column[1][p], column[2][p]);
         column[1][p] = select<uint16_t>(move, column[0][p], column[1][p]);
         column[0][p] = select<uint16_t>(move, uint16_t(above + 2 * pixel[p + 1] + below), column[0][p]);
      }
      whole = column_inside[0] && column_inside[2];
   }

  private:
   static constexpr int kMask = (1 << C.feature_bits()) - 1;

   /// Comparisons and the addition stand side by side: one carry chain, then a choice.
   HLS_INLINE Feature<C> clamped(int16_t value) const {
      const bool low = value<-C.prefilter_cap, high = value> C.prefilter_cap;
      const Feature<C> moved = Feature<C>(value + C.prefilter_cap) & kMask;
      const Feature<C> cut = select<Feature<C>>(low, 0, select<Feature<C>>(high, 2 * C.prefilter_cap, moved));
      return select<Feature<C>>(whole, cut, C.prefilter_cap);
   }
};

}  // namespace stereo
