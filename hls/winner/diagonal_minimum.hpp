// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/matching_options.hpp"
#include "support/registers.hpp"
#include "winner/candidate_mask.hpp"

namespace stereo {

/// The other image's winners, from the same window costs: S(x,d) is a cost of the other image's pixel X = x + d (x - d
/// with a left reference), so each column's costs meet the best so far one disparity further. For P windows and `Count`
/// disparities. 1 clock. Registers: P x (Count + 1) x (window cost + 8) bits.
///
/// Blocks are chained as the shifts are: the next one takes `cost_out` and `winner_out` one clock later.
template <const auto& C, int Count>
struct DiagonalMinimum {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr bool kFalls = C.reference == Reference::right;
   static constexpr int kNewest = kFalls ? Count - 1 : 0;  ///< where a pixel of the other image enters
   static constexpr int kOldest = Count - 1 - kNewest;     ///< and where it leaves
   using Value = WindowCost<C>;

   Value cost[kPixels][Count];  ///< [p][i]: the best so far of the pixel that meets disparity first + i
   uint8_t winner[kPixels][Count];
   Value cost_out[kPixels];  ///< of the pixel that has just left
   uint8_t winner_out[kPixels];

   HLS_INLINE DiagonalMinimum() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("cost", cost);
      visit("winner", winner);
      visit("cost_out", cost_out);
      visit("winner_out", winner_out);
   }

   /// first: the lowest disparity here; before: the block before this one, or NoDiagonal; mask: with full_width, of the
   /// sums.
   template <class Before, class Mask = NoMask>
   HLS_INLINE void clock(const Value (&sum)[kPixels][Count], const PixelTag& tag, int first, const Before& before,
                         const Mask& mask = Mask()) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Value entering_cost = before.cost_out[p];
         const uint8_t entering_winner = before.winner_out[p];
         cost_out[p] = cost[p][kOldest];
         winner_out[p] = winner[p][kOldest];
         HLS_UNROLL
         for (int step = 0; step < Count; ++step) {
            const int i = kFalls ? step : Count - 1 - step;
            const int from = i == kNewest ? i : kFalls ? i + 1 : i - 1;
            Value old_cost = i == kNewest ? entering_cost : cost[p][from];
            const uint8_t old_winner = i == kNewest ? entering_winner : winner[p][from];
            // `&` and `|`: of `&&` the front end makes a branch for each disparity, and all the others wait for its
            // answer.
            const bool has_rival = !tag.first_column & !(i == kNewest && Before::kIsNone);
            bool wins = tag.output_column & (!has_rival | beats(sum[p][i], old_cost));
            if constexpr (kFullWidth<C>) wins = wins & mask.has_candidate(i);
            if constexpr (kLeavesOut) old_cost = select<Value>(has_rival, old_cost, kMaskedCost<C>);
            cost[p][i] = select<Value>(tag.valid, select<Value>(wins, sum[p][i], old_cost), cost[p][i]);
            winner[p][i] =
                select<uint8_t>(tag.valid, select<uint8_t>(wins, uint8_t(first + i), old_winner), winner[p][i]);
         }
      }
   }

   static constexpr bool kIsNone = false;

  private:
   /// The first disparity that a pixel of the other image meets may be one that is not searched.
   static constexpr bool kLeavesOut = [] {
      if constexpr (kFullWidth<C>) return kSetAtRunTime<C> || !C.searches_all();
      else return false;
   }();

   /// The older costs are those of larger disparities with a right, of smaller ones with a left reference.
   static HLS_INLINE bool beats(Value now, Value old) {
      return kFalls == (C.ties == Ties::smallest) ? now <= old : now < old;
   }
};

/// Stands before the first block.
template <const auto& C>
struct NoDiagonal {
   static constexpr bool kIsNone = true;
   WindowCost<C> cost_out[C.pixels_per_clock] = {};
   uint8_t winner_out[C.pixels_per_clock] = {};
};

}  // namespace stereo
