// SPDX-License-Identifier: Apache-2.0
// The named configurations of phase correlation: the only place where their values stand. The hardware top uses the
// objects, scripts ask `stereo_hls configurations --json`.
#pragma once

#include "phase_correlation/config.hpp"
#include "support/configuration.hpp"

namespace stereo::phase_correlation::configurations {

// clang-format off
// tiny: small enough for every tool to finish in seconds.
STEREO_ROW(tiny_phase, tiny, Config(), width_px = 40, height_px = 18, disparities = 12, window_px = 5, subpixel = true,
           slice_disparities = 6);

// system: the size of PARTS, 320x240 with 24 disparities.
STEREO_ROW(parts_320, system, Config(), width_px = 320, height_px = 240, disparities = 24, subpixel = true,
           aggregation = Aggregation::recursive, slice_disparities = 12);

// option: one option after the other, at a size that a test can afford.
STEREO_ROW(tiny_phase_one_scale, option, tiny_phase, phase_scales = 1);
STEREO_ROW(tiny_phase_three_scales, option, tiny_phase, height_px = 26, disparities = 6, phase_scales = 3);
STEREO_ROW(tiny_phase_left, option, tiny_phase, reference = Reference::left);
STEREO_ROW(tiny_phase_recursive, option, tiny_phase, window_px = 7, aggregation = Aggregation::recursive);
STEREO_ROW(tiny_phase_checks, option, tiny_phase, window_px = 4, min_disparity = 2, reference = Reference::left,
           left_right_threshold = 1, uniqueness_percent = 10, median = true);
STEREO_ROW(tiny_phase_10bit, option, tiny_phase, pixel_bits = 10);
STEREO_ROW(tiny_phase_12bit, option, tiny_phase_three_scales, pixel_bits = 12);
STEREO_ROW(tiny_phase_full, option, tiny_phase, full_width = true);
STEREO_ROW(tiny_phase_dense, option, tiny_phase_checks, full_width = true, subpixel = true, support_threshold = 5,
           confidence = true, margin_shift = 1, fill_holes = true);
STEREO_ROW(tiny_phase_settings, option, tiny_phase_checks, run_time_settings = true);
STEREO_ROW(tiny_phase_size, option, tiny_phase, height_px = 24, run_time_size = true);
STEREO_ROW(tiny_phase_size_all, option, tiny_phase_checks, height_px = 26, full_width = true, run_time_settings = true,
           run_time_size = true, aggregation = Aggregation::recursive);
STEREO_ROW(tiny_phase_dense_settings, option, tiny_phase_dense, height_px = 26, run_time_settings = true);
// clang-format on

}  // namespace stereo::phase_correlation::configurations
