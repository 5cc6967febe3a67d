// SPDX-License-Identifier: Apache-2.0
// The named configurations of semi-global matching: the only place where their values stand. The hardware top uses the
// objects, scripts ask `stereo_hls configurations --json`.
#pragma once

#include "semi_global/config.hpp"
#include "support/configuration.hpp"

namespace stereo::semi_global::configurations {

// clang-format off
// tiny: small enough for every tool to finish in seconds.
STEREO_ROW(tiny_sgm, tiny, Config(), width_px = 40, height_px = 12, disparities = 12, slice_disparities = 5);

// system: the recommended options.
STEREO_ROW(sgm_450, system, Config(), width_px = 450, height_px = 375, disparities = 64, reference = Reference::left,
           census_width_px = 9, census_pattern = CensusPattern::sparse, cost_shift = 3, cost_cap = 5, p1 = 7, p2 = 60,
           p2_least = 20, above_p1 = 5, above_p2 = 31, median = true, slice_disparities = 16);

// Costs of single pixels: fewer look-up tables for each disparity, for a little more error (docs/quality.md).
STEREO_ROW(sgm_1280, system, sgm_450, width_px = 1280, height_px = 720, window_px = 1,
           census_pattern = CensusPattern::checkerboard, cost_shift = 1);
// The same with the penalties of before: its VHDL takes over an hour to make (docs/semi_global.md).
STEREO_ROW(sgm_640, system, Config(), width_px = 640, height_px = 480, disparities = 128, window_px = 1,
           reference = Reference::left, census_width_px = 9, cost_shift = 2, p1 = 4, p2 = 24, median = true,
           slice_disparities = 16);
// Several clocks a pixel pair, for a small FPGA behind a camera.
STEREO_ROW(sgm_640_64_f4, system, sgm_640, disparities = 64, clocks_per_pixel = 4);
STEREO_ROW(sgm_640_64_f8, system, sgm_640_64_f4, clocks_per_pixel = 8, front_clocks = 2);
STEREO_ROW(sgm_640_f8, system, sgm_640, clocks_per_pixel = 8);
STEREO_ROW(sgm_640_f16, system, sgm_640, clocks_per_pixel = 16, front_clocks = 2);
// A road: rows of KITTI, in full width.
STEREO_ROW(sgm_1242_f8, system, sgm_450, width_px = 1242, disparities = 128, full_width = true, clocks_per_pixel = 8,
           front_clocks = 2);
// For a small FPGA: on a road a P2 that is the same everywhere serves as well.
STEREO_ROW(sgm_640_64_f8_road, system, sgm_450, width_px = 640, height_px = 480, p2_least = -1, full_width = true,
           clocks_per_pixel = 8, front_clocks = 2);
// And checked, in sixteenths.
STEREO_ROW(sgm_640_64_f8_lr, system, sgm_640_64_f8_road, left_right_threshold = 1, subpixel = true);
// For FPGAs with fewer or smaller block RAMs (docs/performance.md has them by device).
STEREO_ROW(sgm_512_64_f16, system, sgm_640_64_f8_road, width_px = 512, height_px = 384, clocks_per_pixel = 16);
STEREO_ROW(sgm_320_64_f16, system, sgm_512_64_f16, width_px = 320, height_px = 240, full_width = false);
STEREO_ROW(sgm_320_32_f16, system, sgm_320_64_f16, disparities = 32);

// option: one option after the other, alone and together, at a size that a test can afford.
STEREO_ROW(tiny_sgm_left, option, tiny_sgm, reference = Reference::left);
STEREO_ROW(tiny_sgm_forward, option, tiny_sgm, path_right = false);
STEREO_ROW(tiny_sgm_rows, option, tiny_sgm, path_above = false, reference = Reference::left);
STEREO_ROW(tiny_sgm_above, option, tiny_sgm, path_left = false, path_right = false);
STEREO_ROW(tiny_sgm_backward, option, tiny_sgm, path_left = false, path_above = false, reference = Reference::left);
STEREO_ROW(tiny_sgm_penalties, option, tiny_sgm, cost_shift = 2, p1 = 19, p2 = 90);
STEREO_ROW(tiny_sgm_sad, option, tiny_sgm, cost = Cost::sad, cost_shift = 6, cost_cap = 15);
STEREO_ROW(tiny_sgm_xsobel, option, tiny_sgm, cost = Cost::sad, prefilter = Prefilter::xsobel, window_px = 2,
           cost_shift = 3, cost_cap = 20);
STEREO_ROW(tiny_sgm_ssd, option, tiny_sgm, cost = Cost::ssd, cost_shift = 12, cost_cap = 31);
STEREO_ROW(tiny_sgm_9x7, option, tiny_sgm, census_width_px = 9, census_height_px = 7, cost_shift = 5);
STEREO_ROW(tiny_sgm_w1, option, tiny_sgm, window_px = 1, census_width_px = 9, cost_shift = 2, p1 = 4, p2 = 24);
STEREO_ROW(tiny_sgm_w1_sad_left, option, tiny_sgm, window_px = 1, cost = Cost::sad, cost_shift = 3, cost_cap = 12,
           reference = Reference::left, cost_clocks = 2);
STEREO_ROW(tiny_sgm_min3, option, tiny_sgm, min_disparity = 3);
STEREO_ROW(tiny_sgm_min_negative, option, tiny_sgm, min_disparity = -4, reference = Reference::left);
STEREO_ROW(tiny_sgm_ties, option, tiny_sgm, ties = Ties::largest, reference = Reference::left);
STEREO_ROW(tiny_sgm_lr, option, tiny_sgm, left_right_threshold = 1);
STEREO_ROW(tiny_sgm_lr_left_ties, option, tiny_sgm, reference = Reference::left, ties = Ties::largest,
           left_right_threshold = 0);
STEREO_ROW(tiny_sgm_lr_forward, option, tiny_sgm_lr, path_right = false);
STEREO_ROW(tiny_sgm_unique, option, tiny_sgm, uniqueness_distance = 4);
STEREO_ROW(tiny_sgm_subpixel, option, tiny_sgm, subpixel = true);
STEREO_ROW(tiny_sgm_median, option, tiny_sgm, median = true);
STEREO_ROW(tiny_sgm_recursive, option, tiny_sgm, window_px = 5, cost_shift = 5, reference = Reference::left,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_sgm_d19, option, tiny_sgm, width_px = 47, disparities = 19, slice_disparities = 6, winner_group = 3);
STEREO_ROW(tiny_sgm_all, option, tiny_sgm, left_right_threshold = 1, uniqueness_distance = 3, subpixel = true,
           median = true);
STEREO_ROW(tiny_sgm_all_left, option, tiny_sgm_all, reference = Reference::left, ties = Ties::largest);
STEREO_ROW(tiny_sgm_full, option, tiny_sgm, full_width = true);
STEREO_ROW(tiny_sgm_full_all, option, tiny_sgm_all, reference = Reference::left, min_disparity = 2, ties = Ties::largest,
           full_width = true);
STEREO_ROW(tiny_sgm_10bit, option, tiny_sgm, pixel_bits = 10);
STEREO_ROW(tiny_sgm_12bit_all, option, tiny_sgm_all, pixel_bits = 12, reference = Reference::left, cost = Cost::sad,
           prefilter = Prefilter::xsobel, prefilter_cap = 500, cost_shift = 7, cost_cap = 63, full_width = true);
STEREO_ROW(tiny_sgm_road, tiny, tiny_sgm, census_width_px = 9, census_pattern = CensusPattern::sparse, cost_shift = 3,
           cost_cap = 5, p1 = 7, p2 = 60, p2_least = 20, above_p1 = 5, above_p2 = 31);
STEREO_ROW(tiny_sgm_relief, option, tiny_sgm, p2_least = 6);
STEREO_ROW(tiny_sgm_relief_lr, option, tiny_sgm_relief, reference = Reference::left, left_right_threshold = 1,
           uniqueness_distance = 3, subpixel = true);
STEREO_ROW(tiny_sgm_relief_rows, option, tiny_sgm_relief, path_left = false, path_above = false, cost = Cost::sad,
           cost_shift = 6, cost_cap = 15);
STEREO_ROW(tiny_sgm_relief_forward, option, tiny_sgm_relief, path_right = false, window_px = 1, cost_shift = 1,
           census_pattern = CensusPattern::even_columns);
STEREO_ROW(tiny_sgm_relief_12bit, option, tiny_sgm_12bit_all, p2_least = 3);
STEREO_ROW(tiny_sgm_above_own, option, tiny_sgm, above_p1 = 3, above_p2 = 40,
           census_pattern = CensusPattern::checkerboard);
STEREO_ROW(tiny_sgm_settings_road, option, tiny_sgm_road, cost_cap = 9, full_width = true, left_right_threshold = 1, height_px = 20,
           run_time_settings = true, run_time_size = true);
STEREO_ROW(tiny_sgm_settings, option, tiny_sgm_all, run_time_settings = true);
STEREO_ROW(tiny_sgm_settings_full, option, tiny_sgm_full_all, p1 = 10, p2 = 40, run_time_settings = true);
STEREO_ROW(tiny_sgm_size, option, tiny_sgm, run_time_size = true);
STEREO_ROW(tiny_sgm_size_all, option, tiny_sgm_all, height_px = 20, run_time_settings = true, run_time_size = true);
STEREO_ROW(tiny_sgm_size_full, option, tiny_sgm_full_all, height_px = 20, run_time_settings = true,
           run_time_size = true);

// A cost beside the border of the other image, and the post-processing.
STEREO_ROW(tiny_sgm_border, option, tiny_sgm_full, border_cost = 3);
STEREO_ROW(tiny_sgm_border_part, option, tiny_sgm_full_all, height_px = 20, p1 = 10, p2 = 40, border_cost = 2,
           run_time_settings = true);
STEREO_ROW(tiny_sgm_confidence, option, tiny_sgm, support_threshold = 5, confidence = true);
STEREO_ROW(tiny_sgm_dense, option, tiny_sgm, reference = Reference::left, full_width = true, border_cost = 3,
           left_right_threshold = 1, subpixel = true, median = true, support_threshold = 5, confidence = true,
           fill_holes = true);
STEREO_ROW(tiny_sgm_dense_forward, option, tiny_sgm, path_right = false, full_width = true, border_cost = 0,
           left_right_threshold = 1, uniqueness_distance = 2, support_threshold = 3, fill_holes = true);
STEREO_ROW(tiny_sgm_dense_size, option, tiny_sgm_dense, height_px = 20, run_time_settings = true, run_time_size = true);

// Several clocks a pixel pair.
STEREO_ROW(tiny_sgm_f4, option, tiny_sgm_w1, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f4_front, option, tiny_sgm_f4, front_clocks = 2);
STEREO_ROW(tiny_sgm_f6_left, option, tiny_sgm_w1, clocks_per_pixel = 6, reference = Reference::left, min_disparity = 2,
           ties = Ties::largest);
STEREO_ROW(tiny_sgm_f5_forward, option, tiny_sgm_w1_sad_left, disparities = 15, clocks_per_pixel = 5,
           path_right = false);
STEREO_ROW(tiny_sgm_f8_all, option, tiny_sgm_w1, disparities = 24, clocks_per_pixel = 8, uniqueness_distance = 3,
           subpixel = true, median = true);
STEREO_ROW(tiny_sgm_f16, option, tiny_sgm_w1, width_px = 300, height_px = 8, disparities = 32, clocks_per_pixel = 16,
           reference = Reference::left);
STEREO_ROW(tiny_sgm_f6_w4_sad, option, tiny_sgm_sad, window_px = 4, clocks_per_pixel = 6, reference = Reference::left);
STEREO_ROW(tiny_sgm_f4_lr_left, option, tiny_sgm_w1, clocks_per_pixel = 4, left_right_threshold = 0,
           reference = Reference::left, ties = Ties::largest);
STEREO_ROW(tiny_sgm_f4_lr_forward, option, tiny_sgm_f4_lr_left, disparities = 16, reference = Reference::right,
           path_right = false, subpixel = true);
STEREO_ROW(tiny_sgm_f4_full_all, option, tiny_sgm_full_all, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f6_border, option, tiny_sgm_border_part, clocks_per_pixel = 6);
STEREO_ROW(tiny_sgm_f4_settings, option, tiny_sgm_settings_full, height_px = 16, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f4_dense, option, tiny_sgm_dense, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f4_road, option, tiny_sgm_road, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f4_relief_lr, option, tiny_sgm_relief_lr, disparities = 8, clocks_per_pixel = 4);
STEREO_ROW(tiny_sgm_f5_relief_forward, option, tiny_sgm_relief_forward, disparities = 20, clocks_per_pixel = 5,
           front_clocks = 2);
STEREO_ROW(tiny_sgm_f6_relief_rows, option, tiny_sgm_relief_rows, clocks_per_pixel = 6);
STEREO_ROW(tiny_sgm_f4_relief_settings, option, tiny_sgm_f4_settings, p2_least = 4);

// sgm_450 as a depth map without holes: of full width, checked, in sixteenths, filtered, with a confidence, filled. The
// penalties are those that are best before a fill (docs/post_processing.md).
STEREO_ROW(sgm_450_dense, system, sgm_450, full_width = true, left_right_threshold = 1, subpixel = true, cost_cap = 6,
           p1 = 9, p2 = 40, p2_least = 15, above_p2 = 20, border_cost = 3, support_threshold = 10, confidence = true,
           margin_weight = 4, support_weight = 2, fill_holes = true);
// For a small FPGA behind two cameras.
STEREO_ROW(sgm_640_64_f8_dense, system, sgm_450_dense, width_px = 640, height_px = 480, clocks_per_pixel = 8,
           front_clocks = 2);
// clang-format on

}  // namespace stereo::semi_global::configurations
