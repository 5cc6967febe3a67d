// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// Copies of a register, each for `Span` of `Count` readers, so that it does not have to reach all of them in one
/// clock. Every tool joins registers that are always the same; these start with different numbers, and no tool can know
/// that nobody reads them before the first write.
template <class Value, int Count, int Span = 16>
struct FanOut {
   static constexpr int kCopies = (Count + Span - 1) / Span;

   Value copy[kCopies];

   HLS_INLINE FanOut() {
      HLS_UNROLL
      for (int i = 0; i < kCopies; ++i) copy[i] = Value(i & kMostDifferent);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("copy", copy);
   }

   /// For reader number `index`.
   HLS_INLINE Value get(int index) const { return copy[index / Span]; }

   HLS_INLINE void move(bool moves, Value value) {
      HLS_UNROLL
      for (int i = 0; i < kCopies; ++i) copy[i] = select<Value>(moves, value, copy[i]);
   }

  private:
   static constexpr int kMostDifferent = sizeof(Value) > 1 ? 1023 : 255;
};

}  // namespace stereo
