// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "support/settings.hpp"
#include "winner/candidate.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// Margins of a group in `Stages` stages.
template <int Stages, int Lanes>
struct StagedMargins {
   uint8_t value[Stages][Lanes];
};

/// Uniqueness check, margin and subpixel interpolation, all from the costs that came with the winner, and the result of
/// the texture check. Subpixel: the distances to the costs beside the winner, kDistanceClocks; one bit of the quotient
/// a clock; rounding. Uniqueness and margin stand beside it.
template <const auto& C>
struct Refinement {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kDistanceClocks = 3;
   static constexpr int kQuotientBits = 8;
   static constexpr int kUniquenessClocks = 4;
   static constexpr bool kHasSecond = C.has_uniqueness_check() || kHasMargin<C>;
   static constexpr int kClocks = C.subpixel ? kDistanceClocks + kQuotientBits + 1 : kHasSecond ? kUniquenessClocks : 0;
   static constexpr int kStages = kClocks > 0 ? kClocks : 1;
   using Value = WindowCost<C>;
   static constexpr bool kIsSet = kSetAtRunTime<C> && C.has_uniqueness_check();
   static constexpr bool kHasDistance = requires { C.uniqueness_distance; };

   // [stage][p]
   uint8_t disparity[kStages][kPixels];
   bool passed[kStages][kPixels];
   PixelTag tag[kStages];
   // Uniqueness: 100 * gap > percent * cost, or gap > distance - 1. The losers come in stage 0.
   bool alone[2][kPixels];                              ///< stages 1 and 2: there is no second
   Value gap[kPixels], lowest[kPixels];                 // stage 1: second - cost; cost
   uint32_t scaled_gap[kPixels], scaled_cost[kPixels];  // stage 2
   /// Percent or distance of the winner in stage 1; 0: no check.
   [[no_unique_address]] TakenOver<C, std::conditional_t<kHasDistance, uint16_t, uint8_t>> asked;
   /// [stage - 2]: how far the second is, from stage 2 on
   [[no_unique_address]] std::conditional_t<kHasMargin<C>, StagedMargins<kStages - 2, kPixels>, NoMargins> margins;
   // Subpixel: u and v are what the costs below and above have more than the winner's.
   Value cost[kPixels], below[kPixels], above[kPixels];  // stage 0
   Value u[kPixels], v[kPixels];                         // stage 1
   int32_t difference[kPixels];                          ///< v - u
   // |u - v| * 128 / max(u, v), highest bit first; [0] is stage 2
   Value remainder[kQuotientBits + 1][kPixels], divisor[kQuotientBits + 1][kPixels];
   uint8_t quotient[kQuotientBits + 1][kPixels];
   bool negative[kQuotientBits + 1][kPixels];
   uint8_t fraction[kPixels];  // last stage

   HLS_INLINE Refinement() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("disparity", disparity);
      visit("passed", passed);
      visit("tag", tag);
      visit("alone", alone);
      visit("gap", gap);
      visit("lowest", lowest);
      visit("scaled_gap", scaled_gap);
      visit("scaled_cost", scaled_cost);
      if constexpr (kIsSet && kHasDistance) visit("distance", asked.value, C.uniqueness_distance);
      else if constexpr (kIsSet) visit("percent", asked.value, C.uniqueness_percent);
      if constexpr (kHasMargin<C>) visit("margin", margins.value);
      visit("cost", cost);
      visit("below", below);
      visit("above", above);
      visit("u", u);
      visit("v", v);
      visit("difference", difference);
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
            if constexpr (kCanBeLost<Slice>) winners.passed[p] = winners.passed[p] & has_candidate(last, p);
         }
         winners.tag = last.best_tag;
      } else {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            winners.disparity[p] = disparity[kStages - 1][p];
            winners.passed[p] = passed[kStages - 1][p];
            winners.fraction[p] = fraction[p];
            if constexpr (kHasMargin<C>) winners.margin.value[p] = margins.value[kStages - 3][p];
         }
         winners.tag = tag[kStages - 1];
      }
      return winners;
   }

   template <class Slice, class TextureBlock, class Settings = NoSettings>
   HLS_INLINE void clock(const Slice& last, const TextureBlock& texture, const Settings& settings = Settings()) {
      if constexpr (kClocks > 0) {
         if constexpr (C.subpixel) divide();
         HLS_UNROLL
         for (int stage = kStages - 1; stage > 0; --stage) {
            tag[stage] = tag[stage - 1];
            HLS_UNROLL
            for (int p = 0; p < kPixels; ++p) {
               disparity[stage][p] = disparity[stage - 1][p];
               const bool unique = stage != kUniquenessClocks - 1 || is_unique(p);
               passed[stage][p] = passed[stage - 1][p] && unique;
            }
         }
         if constexpr (kHasMargin<C>) find_margin();
         if constexpr (kHasSecond) take_second(last);
         if constexpr (kIsSet && kHasDistance)
            asked.value = select<uint16_t>(is_first_of_frame(tag[0]), settings.uniqueness_distance, asked.value);
         else if constexpr (kIsSet)
            asked.value = select<uint8_t>(is_first_of_frame(tag[0]), settings.uniqueness_percent, asked.value);
         if constexpr (C.subpixel) find_distances(last);
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            disparity[0][p] = last.best.index[p][0];
            passed[0][p] = has_texture(texture, p);
            if constexpr (kCanBeLost<Slice>) passed[0][p] = passed[0][p] & has_candidate(last, p);
         }
         tag[0] = last.best_tag;
      }
   }

  private:
   /// With full_width: some pixels have no candidate, and every one of them costs kMaskedCost.
   static constexpr bool kHasLost = [] {
      if constexpr (kFullWidth<C>) return C.has_lost_pixels();
      else return false;
   }();

   /// With a border cost: winners may lead to columns that the other map does not have.
   template <class Slice>
   static constexpr bool kHasPartner = requires(const Slice& last) { last.partner.is_inside(); };
   template <class Slice>
   static constexpr bool kCanBeLost = kHasLost || kHasPartner<Slice>;

   template <class Slice>
   static HLS_INLINE bool has_candidate(const Slice& last, int p) {
      bool has = true;
      if constexpr (kHasLost) has = last.best.cost[p][0] != kMaskedCost<C>;
      if constexpr (kHasPartner<Slice>) has = has & last.partner.is_inside();
      return has;
   }

   /// Of the losers in stage 1.
   HLS_INLINE void find_margin() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int stage = kStages - 3; stage > 0; --stage) margins.value[stage][p] = margins.value[stage - 1][p];
         const Value scaled = Value(gap[p] >> C.margin_shift);
         const bool is_far = alone[0][p] | (scaled > C.kLargestMargin);
         margins.value[0][p] = select<uint8_t>(is_far, C.kLargestMargin, uint8_t(scaled & C.kLargestMargin));
      }
   }

   template <class TextureBlock>
   static HLS_INLINE bool has_texture(const TextureBlock& texture, int p) {
      if constexpr (C.has_texture_check()) return texture.passed(p);
      else return true;
   }

   template <class Slice>
   HLS_INLINE void take_second(const Slice& last) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         alone[1][p] = alone[0][p];
         if constexpr (kIsSet && kHasDistance) {
            scaled_gap[p] = uint32_t(gap[p]) + 1u;
            scaled_cost[p] = asked.value;
         } else if constexpr (kIsSet) {
            alone[1][p] = alone[0][p] | (asked.value == 0);
            scaled_gap[p] = uint32_t(gap[p]) * 100u;
            scaled_cost[p] = uint32_t(lowest[p]) * asked.value;
         } else if constexpr (!C.has_uniqueness_check()) {
         } else if constexpr (kHasDistance) {
            scaled_gap[p] = gap[p];
            scaled_cost[p] = uint32_t(C.uniqueness_distance - 1);
         } else {
            scaled_gap[p] = uint32_t(gap[p]) * (100u / kCommonFactor);
            scaled_cost[p] = uint32_t(lowest[p]) * (uint32_t(C.uniqueness_percent) / kCommonFactor);
         }
         const WindowLosers<C> losers = last.best.losers(p, 0);
         alone[0][p] = losers.second == WindowLosers<C>::kNone;
         gap[p] = Value(losers.second - losers.cost) & Value(kMask);
         lowest[p] = losers.cost;
      }
   }

   /// Smaller factors take fewer additions.
   static constexpr uint32_t kCommonFactor = [] {
      int factor = 1;
      if constexpr (!kHasDistance)
         for (int i = 2; i <= 100; ++i)
            if (100 % i == 0 && C.uniqueness_percent % i == 0) factor = i;
      return uint32_t(factor);
   }();

   HLS_INLINE bool is_unique(int p) const {
      return !C.has_uniqueness_check() || alone[1][p] || scaled_gap[p] > scaled_cost[p];
   }

   /// Beyond an end of the range, and where no candidate is, stands the cost on the other side.
   template <class Slice>
   HLS_INLINE void find_distances(const Slice& last) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const bool equal = u[p] == 0 && v[p] == 0;
         const bool falls = difference[p] >= 0;
         remainder[0][p] = Value(select<int32_t>(falls, difference[p], -difference[p])) & Value(kMask);
         divisor[0][p] = Value(select<Value>(falls, v[p], u[p]) | Value(equal));
         negative[0][p] = falls;

         u[p] = Value(below[p] - cost[p]) & Value(kMask);
         v[p] = Value(above[p] - cost[p]) & Value(kMask);
         difference[p] = int32_t(above[p]) - int32_t(below[p]);

         const WindowCandidate<C> best = last.best.get(p, 0);
         bool at_start = best.index == 0, at_end = best.index == C.disparities - 1;
         if constexpr (kFullWidth<C>) {
            at_start = at_start | (best.below == kMaskedCost<C>);
            at_end = (at_end | (best.above == kMaskedCost<C>)) & !at_start;  // with none of them, both are the same
         }
         below[p] = select<Value>(at_start, best.above, best.below);
         above[p] = select<Value>(at_end, best.below, best.above);
         cost[p] = best.cost;
      }
   }

   /// Step s finds bit 8 - s of the quotient, by one subtraction whose highest bit says whether the divisor fits; then
   /// the quotient is rounded.
   HLS_INLINE void divide() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const uint8_t sixteenths = quotient[kQuotientBits][p] >> 4;
         const uint8_t rounded_up = uint8_t((quotient[kQuotientBits][p] + 15) >> 4);
         fraction[p] = select<uint8_t>(negative[kQuotientBits][p], uint8_t(8 - sixteenths), uint8_t(8 + rounded_up));
         HLS_UNROLL
         for (int step = kQuotientBits; step > 0; --step) {
            const uint32_t left = step == 1 ? remainder[0][p] : uint32_t(remainder[step - 1][p]) << 1;
            const uint32_t rest = left + kFits - divisor[step - 1][p];
            const bool fits = (rest & kFits) != 0;
            remainder[step][p] = Value(select<uint32_t>(fits, rest, left) & kMask);
            quotient[step][p] = step == 1 ? uint8_t(fits) : uint8_t(quotient[step - 1][p] << 1 | uint8_t(fits));
            divisor[step][p] = divisor[step - 1][p];
            negative[step][p] = negative[step - 1][p];
         }
      }
   }

   static constexpr uint32_t kMask = (uint32_t(1) << bits_for(C.largest_window_cost() + 1)) - 1;
   /// A bit above those of twice a remainder.
   static constexpr uint32_t kFits = uint32_t(1) << bits_for(2 * int64_t(C.largest_window_cost()) + 1);
};

}  // namespace stereo
