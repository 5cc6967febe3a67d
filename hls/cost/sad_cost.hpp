// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "frontend/features.hpp"
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
/// |a - b| is d = a - b where d is not negative and its complement plus 1 where it is. The complement costs nothing in
/// front of an addition, and the plus 1 nothing where it enters the carry of one. A pair has one carry for two taps, so
/// the other tap's waits for the column sum. Where no carry is left for a tap that stands alone, it gets its plus 1 by
/// itself, which takes no more than the complement would.
///
/// With C.remembers_signs() it is known from the row before which of two pixels is larger, for all but the newest rows:
/// those are subtracted the right way round at once and need neither complement nor carry. The newest rows then count 0
/// here, not earlier, when they are outside the frame: their signs are those of the next one.
template <const auto& C, int Count>
struct SadCost {
   static constexpr int kClocks = C.cost_clocks;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kPairs = (kTaps - 1) / 2;
   static constexpr int kKnown = C.remembers_signs() ? kTaps - kPixels : 0;  ///< taps whose signs are known

   int16_t difference[kTaps][Count];      ///< search - reference; its magnitude where the sign is known
   bool newest_negative[kPixels][Count];  ///< of the newest taps, inside the frame or not
   PixelTag difference_tag;
   uint16_t pair[kPairs + 1][Count];  ///< |d| + |d| of taps 2j+1 and 2j+2, less 1 where `negative`
   bool negative[kPairs + 1][Count];
   Feature<C> single[kTaps][Count];  ///< |d|, less 1 where `single_negative`; only of the taps that stand alone
   bool single_negative[kTaps][Count];
   PixelTag pair_tag;
   ColumnCost<C> column[kPixels][Count];  ///< 0 in the border columns
   PixelTag tag;

   HLS_INLINE SadCost() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("difference", difference);
      if constexpr (C.remembers_signs()) visit("newest_negative", newest_negative);
      visit("difference_tag", difference_tag);
      visit("pair", pair);
      visit("negative", negative);
      visit("single", single);
      visit("single_negative", single_negative);
      visit("pair_tag", pair_tag);
      visit("column", column);
      visit("tag", tag);
   }

   /// Steps in reverse order have registers between them; steps in order share a clock.
   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      clock(shift, NoSigns());
   }

   /// signs.negative(t, i): whether a known tap's difference is negative.
   template <class Shift, class Signs>
   HLS_INLINE void clock(const Shift& shift, const Signs& signs) {
      if constexpr (C.cost_clocks == 3) {
         add_columns();
         add_pairs();
         subtract(shift, signs);
      } else if constexpr (C.cost_clocks == 2) {
         add_pairs();
         add_columns();
         subtract(shift, signs);
      } else {
         subtract(shift, signs);
         add_pairs();
         add_columns();
      }
   }

  private:
   using Sum = uint_of_bits<(sizeof(ColumnCost<C>) > 2 ? 32 : 16)>;

   struct NoSigns {
      static HLS_INLINE bool negative(int, int) { return false; }
   };

   // Window p covers the taps p ... p+B-1. From an even p: tap p, whole pairs, and of an even window a last single tap;
   // from an odd p: whole pairs, and of an odd window a last single tap.
   static constexpr int pairs_of(int p) { return p % 2 == 0 ? (C.window_px - 1) / 2 : C.window_px / 2; }
   static constexpr bool starts_single(int p) { return p % 2 == 0; }
   static constexpr bool ends_single(int p) { return (p + C.window_px) % 2 == 0; }
   /// Whether both taps of a pair need a carry.
   static constexpr bool defers(int pair) { return 2 * pair + 1 >= kKnown; }

   /// Carries of window p's additions that no pair needs.
   static constexpr int spare_carries(int p) {
      int spare = pairs_of(p) + int(starts_single(p)) + int(ends_single(p)) - 1;
      for (int j = p / 2; j < p / 2 + pairs_of(p); ++j) spare -= int(defers(j));
      return spare;
   }
   /// Whether a single tap gets its plus 1 in a column sum. An even tap starts window t, an odd one ends another.
   static constexpr bool is_folded(int t) {
      if (t < kKnown) return false;
      if (t % 2 == 0) return t < kPixels && spare_carries(t) > 0;
      const int p = t - C.window_px + 1;
      if (p < 0 || p >= kPixels || !ends_single(p)) return false;
      return spare_carries(p) > (starts_single(p) && p >= kKnown ? 1 : 0);
   }

   template <class Shift, class Signs>
   HLS_INLINE void subtract(const Shift& shift, const Signs& signs) {
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) {
            const bool turned = t < kKnown && signs.negative(t, i);
            const Feature<C> search = shift.search[t][i], reference = shift.reference[t];
            const int16_t d =
                int16_t(select<Feature<C>>(turned, reference, search) - select<Feature<C>>(turned, search, reference));
            difference[t][i] = t < kKnown ? int16_t(Feature<C>(d)) : d;
            if constexpr (C.remembers_signs())
               if (t >= kKnown) {
                  difference[t][i] = select<int16_t>((shift.tag.newest_inside >> (t - kKnown) & 1) != 0, d, 0);
                  newest_negative[t - kKnown][i] = d < 0;
               }
         }
      }
      difference_tag = shift.tag;
   }

   /// d, or its complement where it is negative.
   static HLS_INLINE Feature<C> folded(int16_t d) { return Feature<C>(d ^ (d >> 15)); }

   HLS_INLINE bool is_negative(int t, int i) const { return t >= kKnown && difference[t][i] < 0; }
   HLS_INLINE Feature<C> without_carry(int t, int i) const {
      return t < kKnown ? Feature<C>(difference[t][i]) : folded(difference[t][i]);
   }

   HLS_INLINE void add_pairs() {
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         HLS_UNROLL
         for (int j = 0; j < kPairs; ++j) {
            const int first = 2 * j + 1, second = 2 * j + 2;
            const bool carry = defers(j) ? is_negative(first, i) : is_negative(second, i);
            pair[j][i] = uint16_t(without_carry(first, i) + without_carry(second, i) + uint16_t(carry));
            negative[j][i] = defers(j) && is_negative(second, i);
         }
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) {
            const bool plus = is_negative(t, i);
            single[t][i] = Feature<C>(without_carry(t, i) + uint8_t(plus && !is_folded(t)));
            single_negative[t][i] = plus && is_folded(t);
         }
      }
      pair_tag = difference_tag;
   }

   HLS_INLINE void add_columns() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            Sum sum = 0;
            HLS_UNROLL
            for (int j = p / 2; j < p / 2 + pairs_of(p); ++j) sum = Sum(sum + pair[j][i] + uint16_t(negative[j][i]));
            if (starts_single(p)) sum = Sum(sum + single[p][i] + uint16_t(single_negative[p][i]));
            if (ends_single(p)) {
               const int last = p + C.window_px - 1;
               sum = Sum(sum + single[last][i] + uint16_t(single_negative[last][i]));
            }
            column[p][i] = select<ColumnCost<C>>(pair_tag.border_column, 0, ColumnCost<C>(sum));
         }
      }
      tag = pair_tag;
   }
};

}  // namespace stereo
