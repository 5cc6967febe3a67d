// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/feature_distance.hpp"
#include "phase_correlation/config.hpp"

namespace stereo {

/// The number of bits in which two phase codes differ, those of the finest scale counted twice where there are more.
/// Both steps are those of the census: groups of three bits, one full adder each, then their weighted sum.
template <const auto& C>
struct FeatureDistance<C, phase_correlation::kPhaseCost> {
   static constexpr int kGroupBits = 3;
   static constexpr int kGroups = C.feature_bits() / kGroupBits;
   static constexpr int kLaneBits = 2;
   /// A count in each lane. One word: the front end joins a record of a few bytes anyway, with gaps.
   using First = uint_of_bits<kGroups * kLaneBits>;

   static HLS_INLINE First first(Feature<C> a, Feature<C> b) {
      const Feature<C> x = Feature<C>(a ^ b);
      First counts = 0;
      HLS_UNROLL
      for (int g = 0; g < kGroups; ++g) {
         const int bit = g * kGroupBits;
         const First count = First((x >> bit & 1) + (x >> (bit + 1) & 1) + (x >> (bit + 2) & 1));
         counts |= First(count << g * kLaneBits);
      }
      return counts;
   }
   static HLS_INLINE uint8_t second(First counts) { return sum<0, kGroups>(counts); }

  private:
   /// A balanced tree of additions.
   template <int From, int Number>
   static HLS_INLINE uint8_t sum(First counts) {
      constexpr int kScale = From * kGroupBits / phase_correlation::CodeConfig::kBitsOfScale;
      if constexpr (Number == 1) return uint8_t((counts >> From * kLaneBits & 3) * C.weight(kScale));
      else return uint8_t(sum<From, Number / 2>(counts) + sum<From + Number / 2, Number - Number / 2>(counts));
   }
};

}  // namespace stereo
