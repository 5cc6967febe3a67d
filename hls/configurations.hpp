// SPDX-License-Identifier: Apache-2.0
// The table of named configurations: the only place where their values stand. C++ uses the objects, scripts ask
// `stereo_hls configurations --json`.
#pragma once

#include "stereo_config.hpp"

namespace stereo::configurations {

/// "Hardware implementation of an SAD based stereo vision algorithm" (Ambrosch et al., 2007), section 4: 320x240, 100
/// disparities, 3x3 window.
inline constexpr StereoConfig ambrosch2007{.width_px = 320, .height_px = 240, .disparities = 100};

/// The same with 2 pixel pairs a clock: the paper's 32-bit input port.
inline constexpr StereoConfig ambrosch2007_p2{
    .width_px = 320, .height_px = 240, .disparities = 100, .pixels_per_clock = 2};

/// The same with 4 pixel pairs a clock.
inline constexpr StereoConfig ambrosch2007_p4{
    .width_px = 320, .height_px = 240, .disparities = 100, .pixels_per_clock = 4};

/// Small enough for every tool to finish in seconds.
inline constexpr StereoConfig tiny{.width_px = 32, .height_px = 12, .disparities = 8, .slice_disparities = 3};

/// The same with 2 and 4 pixel pairs a clock.
inline constexpr StereoConfig tiny_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .slice_disparities = 3};
inline constexpr StereoConfig tiny_p4{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 4, .slice_disparities = 3};

}  // namespace stereo::configurations

/// Calls the macro CALL(name) for each named configuration.
#define STEREO_FOR_EACH_CONFIGURATION(CALL) \
   CALL(ambrosch2007) CALL(ambrosch2007_p2) CALL(ambrosch2007_p4) CALL(tiny) CALL(tiny_p2) CALL(tiny_p4)
