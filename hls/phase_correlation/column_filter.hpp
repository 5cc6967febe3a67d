// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phase_correlation/config.hpp"
#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo::phase_correlation {

/// Number of separable filters along a column: low pass L, even E and odd O.
inline constexpr int kFilters = 3;

/// The filters of one scale along a column: boxes of `kStep` rows, then L, E and O of five of them, kStep apart.
/// kClocks clocks, as many for every scale: where a box is smaller, registers are empty.
///
/// No number is below 0, since E and O are kept with a bias. The filters along the rows cancel it. The bias comes with
/// the first difference: the front end keeps a register that is only subtracted negated, and the tool then loses its
/// sign.
template <const auto& C, int Scale>
struct ColumnFilter {
   static constexpr int kStep = 1 << Scale;
   static constexpr int kBoxClocks = C.scales - 1;
   static constexpr int kClocks = kBoxClocks + 2;
   static constexpr int kRows = C.largest_reach().above + 1 + C.largest_reach().below;
   static constexpr int kCentre = C.largest_reach().above;
   static constexpr int kTaps = 5;
   static constexpr int kParts = kStep > 1 ? kStep / 2 : 1;
   static constexpr int kEvenBias = 2 * C.largest_pixel() * kStep, kOddBias = 3 * C.largest_pixel() * kStep;
   static constexpr int kBits = bits_for(2 * kOddBias);
   /// 16 bits are enough for any pixel. A difference in a word of 32 bits would be more than the lowering has numbers
   /// for, and the front end drops a mask on what is only added and cut.
   using Part = uint_of_bits<bits_for(kOddBias)>;
   using Value = uint_of_bits<kBits>;

   Part box[kBoxClocks > 0 ? kBoxClocks : 1][kTaps][kParts];  ///< [clock][tap]: parts that are still apart
   Part centre, near;                                         ///< box 0, boxes -1 and 1
   Part outer;                                                ///< kEvenBias less boxes -2 and 2
   Part upper;                                                ///< kOddBias less boxes -2 and -1, the nearer one twice
   Part lower;                                                ///< boxes 2 and 1, the nearer one twice
   Value response[kFilters];                                  ///< L, E + kEvenBias, O + kOddBias

   HLS_INLINE ColumnFilter() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("box", box);
      visit("centre", centre);
      visit("near", near);
      visit("outer", outer);
      visit("upper", upper);
      visit("lower", lower);
      visit("response", response);
   }

   HLS_INLINE void clock(const Pixel<C> (&column)[kRows]) {
      constexpr Value kMask = Value((1u << kBits) - 1);
      response[0] = Value(near + 2 * centre) & kMask;
      response[1] = Value(2 * centre + outer) & kMask;
      response[2] = Value(lower + upper) & kMask;
      Part tap[kTaps];
      HLS_UNROLL
      for (int n = 0; n < kTaps; ++n) {
         if constexpr (kBoxClocks > 0) tap[n] = box[kBoxClocks - 1][n][0];
         else tap[n] = column[kCentre + (n - 2) * kStep];
      }
      centre = tap[2];
      near = Part(tap[1] + tap[3]);
      outer = Part(kEvenBias - tap[0] - tap[4]);
      upper = Part(kOddBias - tap[0] - 2 * tap[1]);
      lower = Part(tap[4] + 2 * tap[3]);
      if constexpr (kBoxClocks > 0) add_boxes<kBoxClocks - 1>(column);
   }

  private:
   // Clocks J, J-1, ... of the boxes. Recursion instead of a loop: what a clock adds depends on its number, and the
   // front end does not unroll a loop of which it has led each turn its own way.
   template <int J>
   HLS_INLINE void add_boxes(const Pixel<C> (&column)[kRows]) {
      constexpr int kPairs = (kStep >> J) / 2;
      HLS_UNROLL
      for (int n = 0; n < kTaps; ++n) {
         if constexpr (kPairs == 0) {
            box[J][n][0] = part<J>(column, n, 0);
         } else {
            HLS_UNROLL
            for (int i = 0; i < kPairs; ++i)
               box[J][n][i] = Part(part<J>(column, n, 2 * i) + part<J>(column, n, 2 * i + 1));
         }
      }
      if constexpr (J > 0) add_boxes<J - 1>(column);
   }

   /// Part `i`, counted upward from the last row, of the box of tap `n`: as the clock before J left it.
   template <int J>
   HLS_INLINE Part part(const Pixel<C> (&column)[kRows], int n, int i) const {
      if constexpr (J > 0) return box[J - 1][n][i];
      else return column[kCentre + (n - 2) * kStep - i];
   }
};

}  // namespace stereo::phase_correlation
