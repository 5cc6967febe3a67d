// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo::rectification {

/// Bilinear interpolation between four numbers of `Bits` bits without sign, with weights of 2^-WeightBits; the exact
/// sum is divided by 2^Shift and rounded to the nearest, halves up. 4 clocks: differences of rows, both columns, their
/// difference, the sum.
template <int Bits, int WeightBits, int Shift>
struct Bilinear {
   static constexpr int kClocks = 4;
   static constexpr int kUnit = 1 << WeightBits;
   static constexpr int kHalf = Shift == 0 ? 0 : (1 << Shift) / 2;
   static constexpr int kValueBits = Bits + 2 * WeightBits - Shift + 1;  ///< the rounding may carry
   static_assert(kValueBits > 0 && Bits + 2 * WeightBits < 31);

   int32_t upper[2], fall[2];  // clock 1, left and right column
   uint8_t weight_y;
   uint8_t weight_x[3];
   int32_t column[2];    // clock 2
   int32_t first, rise;  // clock 3
   uint32_t value;       // clock 4

   HLS_INLINE Bilinear() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("upper", upper);
      visit("fall", fall);
      visit("weight_y", weight_y);
      visit("weight_x", weight_x);
      visit("column", column);
      visit("first", first);
      visit("rise", rise);
      visit("value", value);
   }

   /// taps: [row][column]; x, y: weights of the right column and of the lower row, below 2^WeightBits.
   HLS_INLINE void clock(const int32_t (&taps)[2][2], uint8_t x, uint8_t y) {
      value = uint32_t(first + rise * weight_x[2]) >> Shift & ((1U << kValueBits) - 1);
      first = column[0] * kUnit + kHalf;
      rise = column[1] - column[0];
      HLS_UNROLL
      for (int c = 0; c < 2; ++c) {
         // Never negative, which the tool cannot see in a sum of differences.
         column[c] = (upper[c] * kUnit + fall[c] * weight_y) & ((1 << (Bits + WeightBits)) - 1);
         upper[c] = taps[0][c];
         fall[c] = taps[1][c] - taps[0][c];
      }
      weight_x[2] = weight_x[1];
      weight_x[1] = weight_x[0];
      weight_x[0] = x;
      weight_y = y;
   }
};

}  // namespace stereo::rectification
