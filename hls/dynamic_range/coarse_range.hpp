// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo::dynamic_range {

/// The lowest and the highest coarse disparity of an area, in one word. 0: nothing is known.
template <int Bits>
struct CoarseRange {
   static constexpr int kWordBits = 2 * Bits + 1;
   using Word = uint_of_bits<kWordBits>;
   using Value = uint_of_bits<Bits>;

   static HLS_INLINE Word of(Value low, Value high) {
      return Word(1 | Word(low) << 1 | Word(Word(high) << (Bits + 1)));
   }
   static HLS_INLINE bool known(Word range) { return (range & 1) != 0; }
   static HLS_INLINE Value low(Word range) { return Value(range >> 1 & kMask); }
   static HLS_INLINE Value high(Word range) { return Value(range >> (Bits + 1) & kMask); }

   static HLS_INLINE Word joined(Word a, Word b) {
      const bool takes_a_low = known(a) & (!known(b) | (low(a) < low(b)));
      const bool takes_a_high = known(a) & (!known(b) | (high(a) > high(b)));
      const Word both = of(select<Value>(takes_a_low, low(a), low(b)), select<Value>(takes_a_high, high(a), high(b)));
      return select<Word>(known(a) | known(b), both, 0);
   }

  private:
   static constexpr Value kMask = Value((1u << Bits) - 1);
};

}  // namespace stereo::dynamic_range
