// SPDX-License-Identifier: Apache-2.0
// The named configurations of the trellis: the only place where their values stand. The hardware top uses the objects,
// scripts ask `stereo_hls configurations --json`.
#pragma once

#include "support/configuration.hpp"
#include "trellis/config.hpp"

namespace stereo::trellis::configurations {

// clang-format off
// tiny: small enough for every tool to finish in seconds.
STEREO_ROW(tiny_trellis, tiny, Config(), width_px = 40, height_px = 12, disparities = 12, slice_disparities = 5);

// system: Kim et al., 1300x640; their disparities are not stated.
STEREO_ROW(trellis_1300, system, Config(), width_px = 1300, height_px = 640, disparities = 64, median = true,
           slice_disparities = 16);

// option: one option after the other, at a size that a test can afford.
STEREO_ROW(tiny_trellis_unmarked, option, tiny_trellis, mark_occluded = false);
STEREO_ROW(tiny_trellis_median, option, tiny_trellis, median = true);
STEREO_ROW(tiny_trellis_near, option, tiny_trellis, far_drop = 12);
STEREO_ROW(tiny_trellis_costs, option, tiny_trellis, drop_cost = 0, occlusion_cost = 2, far_drop = 2);
STEREO_ROW(tiny_trellis_w1, option, tiny_trellis, window_px = 1, census_width_px = 9, cost_shift = 2);
STEREO_ROW(tiny_trellis_sad, option, tiny_trellis, cost = Cost::sad, cost_shift = 6, cost_cap = 15);
STEREO_ROW(tiny_trellis_12bit, option, tiny_trellis_sad, pixel_bits = 12, cost_shift = 10);
STEREO_ROW(tiny_trellis_min3, option, tiny_trellis, min_disparity = 3);
STEREO_ROW(tiny_trellis_d19, option, tiny_trellis, width_px = 47, disparities = 19, slice_disparities = 6,
           winner_group = 3);
STEREO_ROW(tiny_trellis_dense, option, tiny_trellis, median = true, support_threshold = 4, confidence = true,
           support_weight = 7, fill_holes = true);
// Settings and sizes from ports.
STEREO_ROW(tiny_trellis_settings, option, tiny_trellis, run_time_settings = true);
STEREO_ROW(tiny_trellis_size, option, tiny_trellis_median, height_px = 16, drop_cost = 6, occlusion_cost = 12,
           run_time_settings = true, run_time_size = true);
STEREO_ROW(tiny_trellis_dense_size, option, tiny_trellis_dense, height_px = 16, run_time_settings = true,
           run_time_size = true);
// clang-format on

}  // namespace stereo::trellis::configurations
