// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/linear.hpp"

namespace stereo::rectification {

/// Bilinear interpolation between four numbers of `Bits` bits without sign, with weights of 2^-WeightBits; the exact
/// sum is divided by 2^Shift and rounded to the nearest, halves up. 6 clocks: along both columns, then between them.
template <int Bits, int WeightBits, int Shift>
struct Bilinear {
   static constexpr int kValueBits = Bits + 2 * WeightBits - Shift + 1;  ///< the rounding may carry
   static_assert(kValueBits > 0 && Bits + 2 * WeightBits < 31);
   using Column = Linear<WeightBits, 0, Bits + WeightBits>;
   using Row = Linear<WeightBits, Shift, kValueBits>;
   static constexpr int kClocks = Column::kClocks + Row::kClocks;

   Column left, right;
   ClockDelay<uint8_t, Column::kClocks> weight_x;
   Row row;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("left", left);
      visit("right", right);
      visit("weight_x", weight_x);
      visit("row", row);
   }

   /// Of the taps kClocks clocks ago.
   HLS_INLINE uint32_t value() const { return row.value; }

   /// taps: [row][column]; x, y: weights of the right column and of the lower row, below 2^WeightBits.
   HLS_INLINE void clock(const int32_t (&taps)[2][2], uint8_t x, uint8_t y) {
      row.clock(int32_t(left.value), int32_t(right.value), weight_x.oldest());
      weight_x.clock(x);
      left.clock(taps[0][0], taps[1][0], y);
      right.clock(taps[0][1], taps[1][1], y);
   }
};

}  // namespace stereo::rectification
