// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace stereo {

/// One hardware configuration of the block-matching core. Every block is a template over a `StereoConfig`; the named
/// ones are in configurations.hpp.
struct StereoConfig {
   int width_px;              ///< image width W, 8 ... 4096
   int height_px;             ///< image height H, window_px ... 4096, a multiple of pixels_per_clock
   int disparities;           ///< disparity range D: 0 <= d < D, 2 ... 256 and below width_px
   int window_px = 3;         ///< side B of the square matching window: 3 or 5
   int pixels_per_clock = 1;  ///< P pixel pairs of one column in P neighbouring rows enter at once: 1, 2 or 4

   // Pipelining. None of it changes a result; docs/performance.md shows what each costs and gives.
   int slice_disparities = 25;  ///< disparities between two registers of the chain that carries the pixels, at least 2
   int cost_clocks = 3;   ///< 1: differences and column sums in one clock; 2: differences apart; 3: each addition apart
   int winner_group = 2;  ///< candidates that one clock of the winner-take-all tree compares: 2 ... 16

   /// Rows and columns on each side of the window's centre.
   constexpr int radius_px() const { return window_px / 2; }
   /// Disparity maps are W-D wide: the last D columns have no complete disparity range (Ambrosch et al., section 4).
   constexpr int output_width_px() const { return width_px - disparities; }
   constexpr int output_height_px() const { return height_px; }
   /// Largest sum of absolute differences that a window can hold.
   constexpr int largest_sad() const { return 255 * window_px * window_px; }
   /// Disparities of the largest slice: a rest of one joins the slice before it, as a tree compares at least two.
   constexpr int largest_slice() const {
      if (disparities <= slice_disparities + 1) return disparities;
      return disparities % slice_disparities == 1 ? slice_disparities + 1 : slice_disparities;
   }

   // Rows travel in groups of P. The windows of a group are complete when the r rows below it have come, that is
   // delay_groups later.
   constexpr int row_groups() const { return height_px / pixels_per_clock; }
   constexpr int delay_groups() const { return (radius_px() + pixels_per_clock - 1) / pixels_per_clock; }
   /// Rows that the windows of one group cover.
   constexpr int tap_rows() const { return pixels_per_clock + 2 * radius_px(); }
   /// Those of them that line memories must keep; the others have just come in.
   constexpr int stored_rows() const { return delay_groups() * pixels_per_clock + radius_px(); }
};

/// Refuses, with a sentence, what the blocks cannot build. Each block relies on it instead of repeating it.
template <const StereoConfig& C>
struct CheckedConfig {
   static_assert(C.width_px >= 8 && C.width_px <= 4096, "the image width must be 8 ... 4096 pixels");
   static_assert(C.window_px == 3 || C.window_px == 5, "the matching window must be 3x3 or 5x5 pixels");
   static_assert(C.height_px >= C.window_px && C.height_px <= 4096,
                 "the image height must be window_px ... 4096 pixels");
   static_assert(C.disparities >= 2 && C.disparities <= 256, "the disparity range must be 2 ... 256");
   static_assert(C.width_px > C.disparities, "the image must be wider than the disparity range");
   static_assert(C.disparities > C.radius_px(), "the disparity range must exceed the window's radius");
   static_assert(C.pixels_per_clock == 1 || C.pixels_per_clock == 2 || C.pixels_per_clock == 4,
                 "1, 2 or 4 pixel pairs can enter in a clock");
   static_assert(C.height_px % C.pixels_per_clock == 0, "the image height must be a multiple of the pixels per clock");
   static_assert(C.slice_disparities >= 2, "a slice must hold at least 2 disparities");
   static_assert(C.cost_clocks >= 1 && C.cost_clocks <= 3, "the cost must take 1, 2 or 3 clocks");
   static_assert(C.winner_group >= 2 && C.winner_group <= 16, "the winner group must have 2 ... 16 candidates");
   static_assert(C.largest_sad() <= UINT16_MAX, "window sums must fit 16 bits");
   static constexpr bool kValid = true;
};

}  // namespace stereo
