// SPDX-License-Identifier: Apache-2.0
// The named configurations with a dynamic range: the only place where their values stand. The hardware top uses the
// objects, scripts ask `stereo_hls configurations --json`.
#pragma once

#include "dynamic_range/config.hpp"
#include "support/configuration.hpp"

namespace stereo::dynamic_range::configurations {

// clang-format off
// Small enough for every tool to finish in seconds.
STEREO_ROW(tiny_dynamic, option, Config(), width_px = 64, height_px = 32, disparities = 32, window_disparities = 16,
           window_px = 5);

// The size of Masrani and MacLean, 640x480.
STEREO_ROW(masrani_640, system, Config(), width_px = 640, height_px = 480, disparities = 128, subpixel = true);

// One option after the other, at a size that a test can afford.
STEREO_ROW(tiny_dynamic_subpixel, option, tiny_dynamic, subpixel = true, window_px = 7);
STEREO_ROW(tiny_dynamic_census, option, tiny_dynamic, codes = Codes::census);
STEREO_ROW(tiny_dynamic_12bit, option, tiny_dynamic, pixel_bits = 12);
STEREO_ROW(tiny_dynamic_10bit, option, tiny_dynamic, pixel_bits = 10, codes = Codes::census);
STEREO_ROW(tiny_dynamic_dense, option, tiny_dynamic, subpixel = true, median = true, support_threshold = 6,
           confidence = true, support_weight = 7, fill_holes = true);
// planned: their VHDL is not made yet.
STEREO_ROW(tiny_dynamic_three_scales, planned, tiny_dynamic, phase_scales = 3, height_px = 40);
STEREO_ROW(tiny_dynamic_wide, planned, tiny_dynamic, width_px = 96, disparities = 64, window_disparities = 24,
           window_px = 3);
// clang-format on

}  // namespace stereo::dynamic_range::configurations
