// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "window_sum.hpp"
#include "winner_tree.hpp"

namespace stereo {

/// The slices for the disparities 0 ... Disparities-1, the one with the highest first. Each slice holds the shift,
/// cost, window and winner blocks of up to C.slice_disparities disparities and works one clock behind the slice before
/// it, from which it gets the pixels and the best candidate so far.
template <const StereoConfig& C, int Disparities>
struct DisparitySlice {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   /// A rest of one disparity joins the slice before it: a tree compares at least two.
   static constexpr int kCount = Disparities <= C.slice_disparities + 1 ? Disparities : C.slice_disparities;
   static constexpr int kFirst = Disparities - kCount;  ///< lowest disparity here
   static constexpr bool kIsLast = kFirst == 0;
   using Next = DisparitySlice<C, kFirst>;
   static constexpr int kLevels = winner_levels(C.largest_slice(), C.winner_group);

   /// Clocks from the pixels' arrival at this slice to the best candidate of all slices.
   static constexpr int latency() {
      if constexpr (kIsLast) return 1 + C.cost_clocks + 1 + kLevels + 1;
      else return 1 + Next::latency();
   }

   DisparityShift<C, kCount> shift;
   SadCost<C, kCount> cost;
   WindowSum<C, kCount> window;
   WinnerTree<kPixels, kCount, C.winner_group, kLevels> winner;
   // The best of this slice and those before it.
   uint16_t best_cost[kPixels];
   uint8_t best_disparity[kPixels];
   PixelTag best_tag;
   Next next;

   HLS_INLINE DisparitySlice() {
      fill<uint16_t>(best_cost, 0);
      fill<uint8_t>(best_disparity, 0);
   }

   /// `rival`: the slice before this one, or NoRival.
   template <class Rival>
   HLS_INLINE void clock(const uint8_t (&left)[kTaps], const uint8_t (&right)[kTaps], const PixelTag& tag,
                         const Rival& rival) {
      next.clock(shift.left_out, shift.right, shift.tag, *this);
      const auto& root = winner.root();
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const uint16_t cost_here = root.cost[p][0];
         const uint8_t disparity_here = uint8_t(kFirst + root.index[p][0]);
         // Not larger: the disparities here are smaller than the rival's, and the smaller one wins a tie.
         const bool wins = rival.loses_to(cost_here, p);
         best_cost[p] = select<uint16_t>(wins, cost_here, rival.best_cost[p]);
         best_disparity[p] = select<uint8_t>(wins, disparity_here, rival.best_disparity[p]);
      }
      best_tag = root.tag;
      winner.clock(window.sum, window.tag);
      window.clock(cost);
      cost.clock(shift);
      shift.clock(left, right, tag);
   }

   HLS_INLINE bool loses_to(uint16_t other_cost, int p) const { return other_cost <= best_cost[p]; }

   HLS_INLINE const auto& last() const {
      if constexpr (kIsLast) return *this;
      else return next.last();
   }
};

/// Stands before the first slice.
template <int Pixels>
struct NoRival {
   uint16_t best_cost[Pixels] = {};
   uint8_t best_disparity[Pixels] = {};
   HLS_INLINE bool loses_to(uint16_t, int) const { return true; }
};

/// Below the last slice there are no disparities left.
template <const StereoConfig& C>
struct DisparitySlice<C, 0> {
   template <class Rival>
   HLS_INLINE void clock(const uint8_t (&)[C.tap_rows()], const uint8_t (&)[C.tap_rows()], const PixelTag&,
                         const Rival&) {}
};

}  // namespace stereo
