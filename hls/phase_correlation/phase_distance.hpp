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
      for (int g = 0; g < kGroups; ++g)
         counts.count[g] =
             uint8_t((x >> kGroupBits * g & 1) + (x >> (kGroupBits * g + 1) & 1) + (x >> (kGroupBits * g + 2) & 1));
      return counts;
   }
   static HLS_INLINE uint8_t second(const First& counts) { return sum<0, kGroups>(counts); }

  private:
   /// A balanced tree of additions.
   template <int From, int Number>
   static HLS_INLINE uint8_t sum(const First& counts) {
      constexpr int kScale = From * kGroupBits / phase_correlation::CodeConfig::kBitsOfScale;
      if constexpr (Number == 1) return uint8_t(counts.count[From] * C.weight(kScale));
      else return uint8_t(sum<From, Number / 2>(counts) + sum<From + Number / 2, Number - Number / 2>(counts));
   }
};

}  // namespace stereo
