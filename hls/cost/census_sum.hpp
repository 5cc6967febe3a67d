// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"

namespace stereo {

/// The number of bits in which two census features differ, in three steps with registers between them, for a clock
/// that is short: counts of three bits, sums of four counts, their sum.
template <const auto& C>
struct CensusSum {
   static constexpr int kBits = C.feature_bits();
   static constexpr int kGroups = (kBits + 2) / 3, kParts = (kGroups + 3) / 4;
   template <int N>
   struct Counts {
      uint8_t count[N];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("count", count);
      }
   };
   using First = Counts<kGroups>;
   using Second = Counts<kParts>;

   static HLS_INLINE First first(Feature<C> a, Feature<C> b) {
      const Feature<C> x = Feature<C>(a ^ b);
      First counts;
      HLS_UNROLL
      for (int g = 0; g < kGroups; ++g) {
         // Of a word of 32 bits, the lowering has no single bit 31.
         const uint8_t three = uint8_t(x >> (3 * g));
         uint8_t count = 0;
         HLS_UNROLL
         for (int bit = 0; bit < 3; ++bit)
            if (3 * g + bit < kBits) count = uint8_t(count + (three >> bit & 1));
         counts.count[g] = count;
      }
      return counts;
   }
   static HLS_INLINE Second second(const First& counts) {
      Second parts;
      add_parts<0>(counts, parts);
      return parts;
   }
   static HLS_INLINE uint8_t third(const Second& parts) { return sum<0, kParts>(parts); }

  private:
   template <int Part>
   static HLS_INLINE void add_parts(const First& counts, Second& parts) {
      constexpr int kFirst = 4 * Part, kNumber = kGroups - kFirst < 4 ? kGroups - kFirst : 4;
      parts.count[Part] = sum<kFirst, kNumber>(counts);
      if constexpr (Part + 1 < kParts) add_parts<Part + 1>(counts, parts);
   }
   /// A balanced tree of additions.
   template <int From, int Number, int N>
   static HLS_INLINE uint8_t sum(const Counts<N>& counts) {
      if constexpr (Number == 1) return counts.count[From];
      else return uint8_t(sum<From, Number / 2>(counts) + sum<From + Number / 2, Number - Number / 2>(counts));
   }
};

}  // namespace stereo
