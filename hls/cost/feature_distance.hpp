// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"

namespace stereo {

/// How C.cost compares two features, in two steps with registers between them.
template <const auto& C, Cost Kind>
struct FeatureDistance;

template <const auto& C>
struct FeatureDistance<C, Cost::sad> {
   using First = int16_t;
   static HLS_INLINE First first(Feature<C> a, Feature<C> b) { return int16_t(a - b); }
   static HLS_INLINE Feature<C> second(First d) { return Feature<C>((d ^ (d >> 15)) + uint8_t(d < 0)); }
};

template <const auto& C>
struct FeatureDistance<C, Cost::ssd> {
   using First = int16_t;
   using Square = uint_of_bits<16 * sizeof(Feature<C>)>;
   static HLS_INLINE First first(Feature<C> a, Feature<C> b) { return int16_t(a - b); }
   /// Of the signed difference: where there are multipliers, nothing stands before them.
   static HLS_INLINE Square second(First d) { return Square(int32_t(d) * d); }
};

/// The bits of the first step are counted in groups of three, one full adder each, in lanes of 2 bits.
template <const auto& C>
struct FeatureDistance<C, Cost::census> {
   static constexpr int kBits = C.feature_bits();
   static constexpr int kGroups = (kBits + 2) / 3;
   struct First {
      uint8_t count[kGroups];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("count", count);
      }
   };
   static HLS_INLINE First first(Feature<C> a, Feature<C> b) {
      const Feature<C> x = Feature<C>(a ^ b);
      First counts;
      HLS_UNROLL
      for (int g = 0; g < kGroups; ++g) {
         uint8_t count = 0;
         HLS_UNROLL
         for (int bit = 3 * g; bit < 3 * g + 3; ++bit)
            if (bit < kBits) count = uint8_t(count + uint8_t(x >> bit & 1));
         counts.count[g] = count;
      }
      return counts;
   }
   static HLS_INLINE uint8_t second(const First& counts) { return sum<0, kGroups>(counts); }

  private:
   /// A balanced tree of additions.
   template <int From, int Number>
   static HLS_INLINE uint8_t sum(const First& counts) {
      if constexpr (Number == 1) return counts.count[From];
      else return uint8_t(sum<From, Number / 2>(counts) + sum<From + Number / 2, Number - Number / 2>(counts));
   }
};

}  // namespace stereo
