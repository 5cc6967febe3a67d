// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "winner/candidate.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// Uniqueness check and subpixel interpolation, both from the costs that came with the winner, and the result of the
/// texture check. One bit of the quotient a clock.
template <const auto& C>
struct Refinement {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = C.subpixel ? 10 : C.has_uniqueness_check() ? 3 : 0;
   static constexpr int kStages = kClocks > 0 ? kClocks : 1;
   static constexpr int kUniquenessStage = 2;
   static constexpr int kQuotientBits = 8;
   using Value = WindowCost<C>;

   // [stage][p]
   uint8_t disparity[kStages][kPixels];
   bool passed[kStages][kPixels];
   PixelTag tag[kStages];
   // Uniqueness: 100 * (second - cost) > percent * cost, or second - cost >= distance.
   Value cost[kPixels], gap[kPixels];                   // stage 0
   bool alone[kUniquenessStage][kPixels];               ///< there is no second
   uint32_t scaled_gap[kPixels], scaled_cost[kPixels];  // stage 1
   // Subpixel: |u - v| * 128 / max(u, v), highest bit first.
   Value remainder[kStages][kPixels], divisor[kStages][kPixels];
   uint8_t quotient[kStages][kPixels];
   bool negative[kStages][kPixels];
   uint8_t fraction[kPixels];  // last stage

   HLS_INLINE Refinement() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("passed", passed);
      visit("tag", tag);
      visit("cost", cost);
      visit("gap", gap);
      visit("alone", alone);
      visit("scaled_gap", scaled_gap);
      visit("scaled_cost", scaled_cost);
      visit("remainder", remainder);
      visit("divisor", divisor, 1);
      visit("quotient", quotient);
      visit("negative", negative);
      visit("fraction", fraction, 8);
   }

   /// `texture`: the block, or what stands for it.
   template <class Slice, class TextureBlock>
   HLS_INLINE Winners<C> output(const Slice& last, const TextureBlock& texture) const {
      Winners<C> winners;
      if constexpr (kClocks == 0) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            winners.disparity[p] = last.best.index[p][0];
            winners.passed[p] = has_texture(texture, p);
         }
         winners.tag = last.best_tag;
      } else {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            winners.disparity[p] = disparity[kStages - 1][p];
            winners.passed[p] = passed[kStages - 1][p];
            winners.fraction[p] = fraction[p];
         }
         winners.tag = tag[kStages - 1];
      }
      return winners;
   }

   template <class Slice, class TextureBlock>
   HLS_INLINE void clock(const Slice& last, const TextureBlock& texture) {
      if constexpr (kClocks > 0) {
         if constexpr (C.subpixel) divide();
         HLS_UNROLL
         for (int stage = kStages - 1; stage > 0; --stage) {
            tag[stage] = tag[stage - 1];
            HLS_UNROLL
            for (int p = 0; p < kPixels; ++p) {
               disparity[stage][p] = disparity[stage - 1][p];
               const bool unique = stage != kUniquenessStage || is_unique(p);
               passed[stage][p] = passed[stage - 1][p] && unique;
            }
         }
         if constexpr (C.has_uniqueness_check()) {
            scale();
            take_second(last);
         }
         if constexpr (C.subpixel) take_neighbours(last);
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            disparity[0][p] = last.best.index[p][0];
            passed[0][p] = has_texture(texture, p);
         }
         tag[0] = last.best_tag;
      }
   }

  private:
   template <class TextureBlock>
   static HLS_INLINE bool has_texture(const TextureBlock& texture, int p) {
      if constexpr (C.has_texture_check()) return texture.passed(p);
      else return true;
   }

   template <class Slice>
   HLS_INLINE void take_second(const Slice& last) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const WindowCandidate<C> best = last.best.get(p, 0);
         cost[p] = best.cost;
         gap[p] = Value(best.second - best.cost) & Value(kMask);
         alone[0][p] = best.second == WindowCandidate<C>::kNone;
      }
   }

   HLS_INLINE void scale() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         alone[1][p] = alone[0][p];
         if constexpr (requires { C.uniqueness_distance; }) {
            scaled_gap[p] = gap[p];
            scaled_cost[p] = uint32_t(C.uniqueness_distance - 1);
         } else {
            scaled_gap[p] = uint32_t(gap[p]) * 100u;
            scaled_cost[p] = uint32_t(cost[p]) * uint32_t(C.uniqueness_percent);
         }
      }
   }

   HLS_INLINE bool is_unique(int p) const {
      return !C.has_uniqueness_check() || alone[1][p] || scaled_gap[p] > scaled_cost[p];
   }

   template <class Slice>
   HLS_INLINE void take_neighbours(const Slice& last) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const WindowCandidate<C> best = last.best.get(p, 0);
         const bool lowest = best.index == 0, highest = best.index == C.disparities - 1;
         const Value below = select<Value>(lowest, best.above, best.below);
         const Value above = select<Value>(highest, best.below, best.above);
         const Value u = Value(below - best.cost) & Value(kMask), v = Value(above - best.cost) & Value(kMask);
         const bool falls = u < v;
         const Value larger = select<Value>(falls, v, u), smaller = select<Value>(falls, u, v);
         remainder[0][p] = Value(larger - smaller) & Value(kMask);
         divisor[0][p] = select<Value>(larger == 0, 1, larger);
         negative[0][p] = falls;
      }
   }

   /// Stage s finds bit 8 - s of the quotient; the last stage rounds it.
   HLS_INLINE void divide() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const uint8_t sixteenths = quotient[kQuotientBits][p] >> 4;
         const uint8_t rounded_up = uint8_t((quotient[kQuotientBits][p] + 15) >> 4);
         fraction[p] = select<uint8_t>(negative[kQuotientBits][p], uint8_t(8 - sixteenths), uint8_t(8 + rounded_up));
         HLS_UNROLL
         for (int stage = kQuotientBits; stage > 0; --stage) {
            const uint32_t left = stage == 1 ? remainder[0][p] : uint32_t(remainder[stage - 1][p]) << 1;
            const bool fits = left >= divisor[stage - 1][p];
            remainder[stage][p] = Value(select<uint32_t>(fits, left - divisor[stage - 1][p], left) & kMask);
            quotient[stage][p] = stage == 1 ? uint8_t(fits) : uint8_t(quotient[stage - 1][p] << 1 | uint8_t(fits));
            divisor[stage][p] = divisor[stage - 1][p];
            negative[stage][p] = negative[stage - 1][p];
         }
      }
   }

   static constexpr uint32_t kMask = (uint32_t(1) << bits_for(C.largest_window_cost() + 1)) - 1;
};

}  // namespace stereo
