// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Sums the absolute differences of a column of B pixels, for P windows one below the other and `Count` disparities.
/// C.cost_clocks clocks.
///
/// Three steps: differences; sums of neighbouring taps (1,2), (3,4), ...; column sums. Every window holds whole pairs
/// and at most a single tap above and below them, so the windows share the pairs: 3 additions for 2 columns of 3 pixels
/// instead of 4.
///
/// |a - b| is d = a - b where d is not negative and its complement plus 1 where it is. The plus 1 costs nothing where
/// it enters the carry of an addition that is there anyway. A pair has one carry for two taps, so its second tap is
/// subtracted both ways instead.
template <const auto& C, int Count>
struct SadCost {
   static constexpr int kClocks = C.cost_clocks;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kPairs = (kTaps - 1) / 2;

   int16_t difference[kTaps][Count];    ///< search - reference, -255 ... 255
   uint8_t reverse[kPairs + 1][Count];  ///< reference - search of the second tap of a pair, where that is not negative
   PixelTag difference_tag;
   uint16_t pair[kPairs + 1][Count];  ///< |d| + |d| of taps 2j+1 and 2j+2, 0 ... 510
   uint8_t single[kTaps][Count];  ///< |d|, less 1 where the difference is negative; only of the taps that stand alone
   bool negative[kTaps][Count];
   PixelTag pair_tag;
   ColumnCost<C> column[kPixels][Count];  ///< 0 in the border columns
   PixelTag tag;

   HLS_INLINE SadCost() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("difference", difference);
      visit("reverse", reverse);
      visit("difference_tag", difference_tag);
      visit("pair", pair);
      visit("single", single);
      visit("negative", negative);
      visit("pair_tag", pair_tag);
      visit("column", column);
      visit("tag", tag);
   }

   /// Steps in reverse order have registers between them; steps in order share a clock.
   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      if constexpr (C.cost_clocks == 3) {
         add_columns();
         add_pairs();
         subtract(shift);
      } else if constexpr (C.cost_clocks == 2) {
         add_pairs();
         add_columns();
         subtract(shift);
      } else {
         subtract(shift);
         add_pairs();
         add_columns();
      }
   }

  private:
   template <class Shift>
   HLS_INLINE void subtract(const Shift& shift) {
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) difference[t][i] = int16_t(shift.search[t][i] - shift.reference[t]);
         HLS_UNROLL
         for (int j = 0; j < kPairs; ++j)
            reverse[j][i] = uint8_t(shift.reference[2 * j + 2] - shift.search[2 * j + 2][i]);
      }
      difference_tag = shift.tag;
   }

   /// d, or its complement where it is negative: 0 ... 255.
   static HLS_INLINE uint8_t folded(int16_t d) { return uint8_t(d ^ (d >> 15)); }

   HLS_INLINE void add_pairs() {
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         HLS_UNROLL
         for (int j = 0; j < kPairs; ++j) {
            const int16_t first = difference[2 * j + 1][i], second = difference[2 * j + 2][i];
            const uint8_t exact = select<uint8_t>(second < 0, reverse[j][i], uint8_t(second));
            pair[j][i] = uint16_t(folded(first) + exact + uint16_t(first < 0));
         }
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) {
            single[t][i] = folded(difference[t][i]);
            negative[t][i] = difference[t][i] < 0;
         }
      }
      pair_tag = difference_tag;
   }

   /// Window p covers the taps p ... p+B-1. From an even p: tap p, whole pairs, and of an even window a last single
   /// tap; from an odd p: whole pairs, and of an odd window a last single tap.
   HLS_INLINE void add_columns() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const int pairs = p % 2 == 0 ? (C.window_px - 1) / 2 : C.window_px / 2;
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            uint16_t sum = 0;
            HLS_UNROLL
            for (int j = 0; j < pairs; ++j) sum = uint16_t(sum + pair[p / 2 + j][i]);
            if (p % 2 == 0) sum = uint16_t(sum + single[p][i] + uint16_t(negative[p][i]));
            if ((p + C.window_px) % 2 == 0) {
               const int last = p + C.window_px - 1;
               sum = uint16_t(sum + single[last][i] + uint16_t(negative[last][i]));
            }
            column[p][i] = select<ColumnCost<C>>(pair_tag.border_column, 0, ColumnCost<C>(sum));
         }
      }
      tag = pair_tag;
   }
};

}  // namespace stereo
