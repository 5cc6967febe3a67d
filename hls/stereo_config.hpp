// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace stereo {

/// One hardware configuration of the block-matching core. Every block is a template over a `StereoConfig`; the named
/// ones are in configurations.hpp.
struct StereoConfig {
   int width_px;          ///< image width W, 2 ... 4096
   int height_px;         ///< image height H, window_px ... 4096
   int disparities;       ///< disparity range D: 0 <= d < D, 2 ... 256 and below width_px
   int window_px = 3;     ///< side B of the square matching window: 3 or 5
   int winner_group = 4;  ///< candidates that one clock of the winner-take-all tree compares: 2 ... 16

   /// Rows and columns on each side of the window's centre.
   constexpr int radius_px() const { return window_px / 2; }
   /// Disparity maps are W-D wide: the last D columns have no complete disparity range (Ambrosch et al., section 4).
   constexpr int output_width_px() const { return width_px - disparities; }
   constexpr int output_height_px() const { return height_px; }
   /// Largest sum of absolute differences that a window can hold.
   constexpr int largest_sad() const { return 255 * window_px * window_px; }
};

/// Refuses, with a sentence, what the blocks cannot build. Each block relies on it instead of repeating it.
template <const StereoConfig& C>
struct CheckedConfig {
   static_assert(C.width_px >= 2 && C.width_px <= 4096, "the image width must be 2 ... 4096 pixels");
   static_assert(C.window_px == 3 || C.window_px == 5, "the matching window must be 3x3 or 5x5 pixels");
   static_assert(C.height_px >= C.window_px && C.height_px <= 4096,
                 "the image height must be window_px ... 4096 pixels");
   static_assert(C.disparities >= 2 && C.disparities <= 256, "the disparity range must be 2 ... 256");
   static_assert(C.width_px > C.disparities, "the image must be wider than the disparity range");
   static_assert(C.disparities > C.radius_px(), "the disparity range must exceed the window's radius");
   static_assert(C.winner_group >= 2 && C.winner_group <= 16, "the winner group must have 2 ... 16 candidates");
   static_assert(C.largest_sad() <= UINT16_MAX, "window sums must fit 16 bits");
   static constexpr bool kValid = true;
};

}  // namespace stereo
