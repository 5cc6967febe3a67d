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
   static constexpr int kMasked = kClocks - 2;  ///< clocks behind the columns from which on `column_inside` counts
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2 * C.transform_rows();
   static constexpr int kColumns = C.census_width_px;

   /// With two front clocks the first one compares, the second one chooses what counts.
   static constexpr bool kComparesFirst = kFrontClocks<C> > 1;
   struct Larger {
      bool than_centre[kPixels][kColumns][C.census_height_px];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("than_centre", than_centre);
      }
   };
   struct NoLarger {};

   Pixel<C> column[kColumns][kRows];  ///< [age][row]; 0 outside the image
   [[no_unique_address]] std::conditional_t<kComparesFirst, Larger, NoLarger> larger;
   Feature<C> feature[kPixels];

   HLS_INLINE Census() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      if constexpr (kComparesFirst) visit("larger", larger);
      visit("feature", feature);
   }

   template <class Inside>
   HLS_INLINE void clock(bool move, const Pixel<C> (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         feature[p] = transform(p, column_inside);
         if constexpr (kComparesFirst) compare(p);
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
            const bool is_set = column_inside[age] && has_larger(p, age, row);
            bits |= Feature<C>(Feature<C>(is_set) << bit++);
         }
      }
      return bits;
   }

   HLS_INLINE bool has_larger(int p, int age, int row) const {
      if constexpr (kComparesFirst) return larger.than_centre[p][age][row];
      else return is_larger(p, age, row);
   }

   HLS_INLINE void compare(int p) {
      HLS_UNROLL
      for (int age = 0; age < kColumns; ++age) {
         HLS_UNROLL
         for (int row = 0; row < C.census_height_px; ++row) larger.than_centre[p][age][row] = is_larger(p, age, row);
      }
   }

   HLS_INLINE bool is_larger(int p, int age, int row) const {
      return column[age][p + row] > column[kColumns / 2][p + C.transform_rows()];
   }
};

}  // namespace stereo
