// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"
#include "support/registers.hpp"

namespace stereo {

template <class Value>
HLS_INLINE Value smaller_of(Value a, Value b) {
   return select<Value>(b < a, b, a);
}

/// The smallest of N numbers, one comparison a move: it stands in root() kLevels moves later.
template <class Value, int N>
struct MinimumTree {
   static_assert(N >= 2);
   static constexpr int kWinners = (N + 1) / 2;
   using Next = MinimumTree<Value, kWinners>;
   static constexpr int kLevels = 1 + Next::kLevels;

   Value smallest[kWinners];
   Next next;

   HLS_INLINE MinimumTree() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("smallest", smallest);
      visit("next", next);
   }

   HLS_INLINE void clock(const Value (&values)[N], bool move) {
      next.clock(smallest, move);
      HLS_UNROLL
      for (int i = 0; i < kWinners; ++i) {
         const Value winner =
             2 * i + 1 < N ? smaller_of<Value>(values[2 * i], values[2 * i + 1 < N ? 2 * i + 1 : 0]) : values[2 * i];
         smallest[i] = select<Value>(move, winner, smallest[i]);
      }
   }

   HLS_INLINE Value root() const {
      if constexpr (kWinners == 1) return smallest[0];
      else return next.root();
   }
};

template <class Value>
struct MinimumTree<Value, 1> {
   static constexpr int kLevels = 0;

   template <class Visitor>
   HLS_INLINE void registers(Visitor&) {}
   HLS_INLINE void clock(const Value (&)[1], bool) {}
};

}  // namespace stereo
