// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// Whether registers move, in copies, each for `Span` of `Lanes` lanes: the tool takes time in the square of a signal's
/// readers. Bit 0 of a copy is the answer. The other bits only keep the copies apart: the compiler would join registers
/// that start and continue alike. First: the number of the first copy; no two of a design are the same. In the VHDL
/// they are one register again.
template <int Lanes, int First, int Span = 16>
struct MoveFan {
   static constexpr int kCopies = (Lanes + Span - 1) / Span;
   static constexpr int kEnd = First + kCopies;

   uint16_t copy[kCopies];

   HLS_INLINE MoveFan() {
      HLS_UNROLL
      for (int i = 0; i < kCopies; ++i) copy[i] = uint16_t(2 * (First + i));
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("copy", copy);
   }

   HLS_INLINE bool lane(int index) const { return (copy[index / Span] & 1) != 0; }

   HLS_INLINE void clock(bool moves) {
      HLS_UNROLL
      for (int i = 0; i < kCopies; ++i) copy[i] = moves;
   }
};

/// The same for few readers.
struct OneMove {
   bool moves;

   HLS_INLINE bool lane(int) const { return moves; }
};

}  // namespace stereo
