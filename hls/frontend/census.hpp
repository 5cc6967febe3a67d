// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "frontend/features.hpp"
#include "support/structure_groups.hpp"

namespace stereo {

/// The census transforms of P rows of one image. 2 clocks behind the columns; with two front clocks 3.
template <const auto& C>
struct Census {
   static constexpr int kClocks = 1 + kFrontClocks<C>;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2 * C.transform_rows();
   static constexpr int kColumns = C.census_width_px;

   /// With two front clocks the first one compares the lower halves of the pixels. The columns stand still meanwhile,
   /// and so does what says which of them are inside.
   static constexpr bool kComparesHalves = kFrontClocks<C> > 1;
   struct Halves {
      bool is_larger[kPixels][kColumns][C.census_height_px];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("is_larger", is_larger);
      }
   };
   struct NoHalves {};

   Pixel<C> column[kColumns][kRows];  ///< [age][row]; 0 outside the image
   [[no_unique_address]] std::conditional_t<kComparesHalves, Halves, NoHalves> low;
   Feature<C> feature[kPixels];

   HLS_INLINE Census() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      if constexpr (kComparesHalves) visit("low", low);
      visit("feature", feature);
   }

   template <class Inside>
   HLS_INLINE void clock(bool move, const Pixel<C> (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         feature[p] = transform(p, column_inside);
         if constexpr (kComparesHalves) compare_low(p);
      }
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
            const bool larger = column_inside[age] && is_larger(p, age, row);
            bits |= Feature<C>(Feature<C>(larger) << bit++);
         }
      }
      return bits;
   }

   /// Than the centre. Of two halves the lower one's result stands in place of its bits.
   HLS_INLINE bool is_larger(int p, int age, int row) const {
      const Pixel<C> pixel = column[age][p + row], centre = column[kColumns / 2][p + C.transform_rows()];
      if constexpr (kComparesHalves) {
         const auto low_bit = Pixel<C>(low.is_larger[p][age][row]);
         return Pixel<C>(pixel >> kLowBits << 1 | low_bit) > Pixel<C>(centre >> kLowBits << 1);
      } else {
         return pixel > centre;
      }
   }

   static constexpr int kLowBits = kPixelBits<C> / 2;
   static constexpr unsigned kLowMask = (1U << kLowBits) - 1;
   HLS_INLINE void compare_low(int p) {
      const auto centre = Pixel<C>(column[kColumns / 2][p + C.transform_rows()] & kLowMask);
      HLS_UNROLL
      for (int age = 0; age < kColumns; ++age) {
         HLS_UNROLL
         for (int row = 0; row < C.census_height_px; ++row)
            low.is_larger[p][age][row] = Pixel<C>(column[age][p + row] & kLowMask) > centre;
      }
   }
};

}  // namespace stereo
