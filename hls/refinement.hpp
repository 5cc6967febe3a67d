// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "texture.hpp"

namespace stereo {

/// The winners of a group on their way from check to check.
template <const StereoConfig& C>
struct Winners {
   uint8_t disparity[C.pixels_per_clock];
   uint8_t fraction[C.pixels_per_clock];  ///< sixteenths plus 8: 0 ... 16
   bool passed[C.pixels_per_clock];       ///< all checks so far
   PixelTag tag;

   HLS_INLINE Winners() {
      fill<uint8_t>(disparity, 0);
      fill<uint8_t>(fraction, 8);
      fill(passed, true);
   }
};

/// Uniqueness check and subpixel interpolation, both from the costs that came with the winner, and the result of the
/// texture check. One bit of the quotient a clock.
template <const StereoConfig& C>
struct Refinement {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = C.subpixel ? 10 : C.has_uniqueness_check() ? 3 : 0;
   static constexpr int kStages = kClocks > 0 ? kClocks : 1;
   static constexpr int kUniquenessStage = 2;
   static constexpr int kQuotientBits = 8;
   using Value = WindowCost<C>;

   struct Pixel {
      uint8_t disparity = 0;
      bool passed = false;
      // Uniqueness: 100 * (second - cost) > percent * cost.
      Value cost = 0, gap = 0;
      bool alone = false;  ///< there is no second
      uint32_t scaled_gap = 0, scaled_cost = 0;
      // Subpixel: |u - v| * 128 / max(u, v), highest bit first.
      uint32_t remainder = 0;
      Value divisor = 1;
      uint8_t quotient = 0;
      bool negative = false;
      uint8_t fraction = 8;
   };
   Pixel pixel[kStages][kPixels];
   PixelTag tag[kStages];

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
            const Pixel& done = pixel[kStages - 1][p];
            winners.disparity[p] = done.disparity;
            winners.passed[p] = done.passed;
            winners.fraction[p] = done.fraction;
         }
         winners.tag = tag[kStages - 1];
      }
      return winners;
   }

   template <class Slice, class TextureBlock>
   HLS_INLINE void clock(const Slice& last, const TextureBlock& texture) {
      if constexpr (kClocks > 0) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            HLS_UNROLL
            for (int stage = kStages - 1; stage > 0; --stage) pixel[stage][p] = advanced(pixel[stage - 1][p], stage);
            pixel[0][p] = started(last.best.get(p, 0), has_texture(texture, p));
         }
         HLS_UNROLL
         for (int stage = kStages - 1; stage > 0; --stage) tag[stage] = tag[stage - 1];
         tag[0] = last.best_tag;
      }
   }

  private:
   template <class TextureBlock>
   static HLS_INLINE bool has_texture(const TextureBlock& texture, int p) {
      if constexpr (C.has_texture_check()) return texture.passed(p);
      else return true;
   }

   static HLS_INLINE Pixel started(const Candidate<C>& best, bool passed) {
      Pixel pixel;
      pixel.disparity = best.index;
      pixel.passed = passed;
      if constexpr (C.has_uniqueness_check()) {
         pixel.cost = best.cost;
         pixel.gap = Value(best.second - best.cost);
         pixel.alone = best.second == Candidate<C>::kNone;
      }
      if constexpr (C.subpixel) {
         const bool lowest = best.index == 0, highest = best.index == C.disparities - 1;
         const Value below = select<Value>(lowest, best.above, best.below);
         const Value above = select<Value>(highest, best.below, best.above);
         const Value u = Value(below - best.cost), v = Value(above - best.cost);
         pixel.negative = u < v;
         const Value larger = select<Value>(pixel.negative, v, u);
         pixel.remainder = select<Value>(pixel.negative, Value(v - u), Value(u - v));
         pixel.divisor = select<Value>(larger == 0, 1, larger);
      }
      return pixel;
   }

   static HLS_INLINE Pixel advanced(const Pixel& before, int stage) {
      Pixel pixel = before;
      if constexpr (C.has_uniqueness_check()) {
         if (stage == kUniquenessStage - 1) {
            pixel.scaled_gap = uint32_t(before.gap) * 100u;
            pixel.scaled_cost = uint32_t(before.cost) * uint32_t(C.uniqueness_percent);
         }
         if (stage == kUniquenessStage)
            pixel.passed = before.passed && (before.alone || before.scaled_gap > before.scaled_cost);
      }
      if constexpr (C.subpixel) {
         if (stage <= kQuotientBits) {
            const uint32_t remainder = stage == 1 ? before.remainder : before.remainder << 1;
            const bool fits = remainder >= before.divisor;
            pixel.remainder = select<uint32_t>(fits, remainder - before.divisor, remainder) & kMask;
            pixel.quotient = uint8_t(before.quotient << 1 | uint8_t(fits));
         } else {
            pixel.fraction = select<uint8_t>(before.negative, uint8_t(8 - (before.quotient >> 4)),
                                             uint8_t(8 + ((before.quotient + 15) >> 4)));
         }
      }
      return pixel;
   }

   static constexpr uint32_t kMask = (uint32_t(1) << bits_for(C.largest_window_cost())) - 1;
};

}  // namespace stereo
