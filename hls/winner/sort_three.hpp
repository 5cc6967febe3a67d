// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// Three numbers with the comparisons of each two of them, as registers: one clock compares, the next one chooses by
/// three bits. Comparing and exchanging in the same clock takes more than twice as long.
template <class Value>
struct SortThree {
   Value a, b, c;
   bool b_below_a, c_below_a, c_below_b;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("a", a);
      visit("b", b);
      visit("c", c);
      visit("b_below_a", b_below_a);
      visit("c_below_a", c_below_a);
      visit("c_below_b", c_below_b);
   }

   HLS_INLINE void compare(Value x, Value y, Value z) {
      a = x;
      b = y;
      c = z;
      b_below_a = y < x;
      c_below_a = z < x;
      c_below_b = z < y;
   }

   HLS_INLINE Value smallest() const {
      return select<Value>(b_below_a, select<Value>(c_below_b, c, b), select<Value>(c_below_a, c, a));
   }
   HLS_INLINE Value largest() const {
      return select<Value>(b_below_a, select<Value>(c_below_a, a, c), select<Value>(c_below_b, b, c));
   }
   HLS_INLINE Value median() const {
      const Value if_b_below_a = select<Value>(c_below_b, b, select<Value>(c_below_a, c, a));
      const Value if_not = select<Value>(c_below_a, a, select<Value>(c_below_b, c, b));
      return select<Value>(b_below_a, if_b_below_a, if_not);
   }
};

}  // namespace stereo
