// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo::rectification {

/// Shows what came in `Clocks` clocks before.
template <class Value, int Clocks>
struct ClockDelay {
   static constexpr int kClocks = Clocks;

   Value held[Clocks];  ///< [0] newest

   HLS_INLINE ClockDelay() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("held", held);
   }

   HLS_INLINE const Value& oldest() const { return held[Clocks - 1]; }

   HLS_INLINE void clock(const Value& newest) {
      HLS_UNROLL
      for (int i = Clocks - 1; i > 0; --i) held[i] = held[i - 1];
      held[0] = newest;
   }
};

}  // namespace stereo::rectification
