// SPDX-License-Identifier: Apache-2.0
// The named configurations of block matching: the only place where their values stand. The hardware top uses the
// objects, scripts ask `stereo_hls configurations --json`.
#pragma once

#include "block_matching/config.hpp"
#include "support/configuration.hpp"

namespace stereo::block_matching::configurations {

// clang-format off
// paper: "Hardware implementation of an SAD based stereo vision algorithm" (Ambrosch et al., 2007), section 4: 320x240,
// 100 disparities, 3x3 window; then with 2 (the paper's 32-bit input port) and 4 pixel pairs a clock.
STEREO_ROW(ambrosch2007, paper, Config(), width_px = 320, height_px = 240, disparities = 100, sign_memory = true);
STEREO_ROW(ambrosch2007_p2, paper, ambrosch2007, pixels_per_clock = 2);
STEREO_ROW(ambrosch2007_p4, paper, ambrosch2007, pixels_per_clock = 4);
// The same map with several clocks a pixel pair: the first one gives the paper's frames a second.
STEREO_ROW(ambrosch2007_f5, system, ambrosch2007, sign_memory = false, clocks_per_pixel = 5);
STEREO_ROW(ambrosch2007_f10, system, ambrosch2007_f5, clocks_per_pixel = 10);
STEREO_ROW(ambrosch2007_f20, system, ambrosch2007_f5, clocks_per_pixel = 20);

// tiny: small enough for every tool to finish in seconds.
STEREO_ROW(tiny, tiny, Config(), width_px = 32, height_px = 12, disparities = 8, slice_disparities = 3);
STEREO_ROW(tiny_p2, tiny, tiny, pixels_per_clock = 2);
STEREO_ROW(tiny_p4, tiny, tiny, pixels_per_clock = 4);

// system: those that the paper compares itself with, one pixel pair a clock, and some of today.
// Niitsuma and Maruyama.
STEREO_ROW(niitsuma_640, system, Config(), width_px = 640, height_px = 480, disparities = 27, window_px = 7,
           aggregation = Aggregation::recursive, slice_disparities = 14);
STEREO_ROW(niitsuma_320, system, Config(), width_px = 320, height_px = 240, disparities = 121, window_px = 7,
           aggregation = Aggregation::recursive);
// Lee et al.
STEREO_ROW(lee_320, system, Config(), width_px = 320, height_px = 240, disparities = 64, window_px = 16,
           aggregation = Aggregation::recursive, slice_disparities = 16);
// Miyajima and Maruyama.
STEREO_ROW(miyajima_640, system, Config(), width_px = 640, height_px = 480, disparities = 200, window_px = 7,
           aggregation = Aggregation::recursive);
STEREO_ROW(miyajima_640_f5, system, miyajima_640, clocks_per_pixel = 5);
// Yi et al.: the window is not stated; 9x9 here.
STEREO_ROW(yi_270, system, Config(), width_px = 270, height_px = 270, disparities = 34, window_px = 9,
           aggregation = Aggregation::recursive, slice_disparities = 17);
// Han et al.: the window is not stated; 9x9 here.
STEREO_ROW(han_640, system, Config(), width_px = 640, height_px = 480, disparities = 128, window_px = 9,
           aggregation = Aggregation::recursive);
// DeepSea (Woodfill et al.): the windows of its census are 7x7 here.
STEREO_ROW(deepsea_512, system, Config(), width_px = 512, height_px = 480, disparities = 52, window_px = 7,
           cost = Cost::census, census_width_px = 7, census_height_px = 7, aggregation = Aggregation::recursive,
           slice_disparities = 13);
// OpenCV's StereoBM with block 15 and 64 disparities, at the size of the Middlebury pair Teddy.
STEREO_ROW(opencv_bm, system, Config(), width_px = 450, height_px = 375, disparities = 64, window_px = 15,
           reference = Reference::left, prefilter = Prefilter::xsobel, ties = Ties::largest, uniqueness_percent = 15,
           texture_threshold = 10, subpixel = true, aggregation = Aggregation::recursive, slice_disparities = 16);
// The best trade-off that docs/quality.md found at that size.
STEREO_ROW(census_450, system, Config(), width_px = 450, height_px = 375, disparities = 48, window_px = 9,
           reference = Reference::left, cost = Cost::census, census_width_px = 9,
           census_pattern = CensusPattern::even_columns, subpixel = true, median = true,
           aggregation = Aggregation::recursive, slice_disparities = 16);

STEREO_ROW(census_450_full, system, census_450, full_width = true);
// The same as a depth map without holes: checked, filtered, with a confidence, filled.
STEREO_ROW(census_450_dense, system, census_450_full, left_right_threshold = 1, support_threshold = 10, confidence = true,
           margin_shift = 3, margin_weight = 1, support_weight = 6, fill_holes = true);
// For two cameras of 640x480 (examples/camera_system): the same with each check that says how far to trust a disparity.
STEREO_ROW(vga_64, system, census_450, width_px = 640, height_px = 480, disparities = 64, census_height_px = 3,
           census_pattern = CensusPattern::all, left_right_threshold = 1, uniqueness_percent = 5);
// Several clocks a pixel pair, for a small FPGA.
STEREO_ROW(census_640_f8, system, vga_64, clocks_per_pixel = 8);

// study: what one option costs; each beside `study`, which has none (docs/features.md).
STEREO_ROW(study, study, Config(), width_px = 320, height_px = 64, disparities = 16, window_px = 5,
           slice_disparities = 8);
STEREO_ROW(study_p2, study, study, pixels_per_clock = 2);
STEREO_ROW(study_p4, study, study, pixels_per_clock = 4);
STEREO_ROW(study_w3, study, study, window_px = 3);
STEREO_ROW(study_w7, study, study, window_px = 7);
STEREO_ROW(study_w9, study, study, window_px = 9);
STEREO_ROW(study_recursive, study, study, aggregation = Aggregation::recursive);
STEREO_ROW(study_w3_recursive, study, study, window_px = 3, aggregation = Aggregation::recursive);
STEREO_ROW(study_w7_recursive, study, study, window_px = 7, aggregation = Aggregation::recursive);
STEREO_ROW(study_w9_recursive, study, study, window_px = 9, aggregation = Aggregation::recursive);
STEREO_ROW(study_w15_recursive, study, study, window_px = 15, aggregation = Aggregation::recursive);
STEREO_ROW(study_w21_recursive, study, study, window_px = 21, aggregation = Aggregation::recursive);
STEREO_ROW(study_left, study, study, reference = Reference::left);
STEREO_ROW(study_min8, study, study, min_disparity = 8);
STEREO_ROW(study_ssd, study, study, cost = Cost::ssd);
STEREO_ROW(study_census, study, study, cost = Cost::census);
STEREO_ROW(study_left_right, study, study, left_right_threshold = 1);
STEREO_ROW(study_uniqueness, study, study, uniqueness_percent = 15);
STEREO_ROW(study_xsobel, study, study, prefilter = Prefilter::xsobel);
STEREO_ROW(study_texture, study, study, prefilter = Prefilter::xsobel, texture_threshold = 60);
STEREO_ROW(study_subpixel, study, study, subpixel = true);
STEREO_ROW(study_median, study, study, median = true);
STEREO_ROW(study_all, study, study, prefilter = Prefilter::xsobel, left_right_threshold = 1, uniqueness_percent = 15,
           texture_threshold = 60, subpixel = true, median = true);
STEREO_ROW(study_cost2, study, study, cost_clocks = 2);
STEREO_ROW(study_cost1, study, study, cost_clocks = 1);
STEREO_ROW(study_group4, study, study, winner_group = 4);
STEREO_ROW(study_slice4, study, study, slice_disparities = 4);
STEREO_ROW(study_slice16, study, study, slice_disparities = 16);
STEREO_ROW(study_10bit, study, study, pixel_bits = 10);
STEREO_ROW(study_12bit, study, study, pixel_bits = 12);

// option: one option after the other, alone and together, at a size that a test can afford.
STEREO_ROW(tiny_signs, option, tiny, sign_memory = true);
STEREO_ROW(tiny_signs_w4_p2, option, tiny, window_px = 4, pixels_per_clock = 2, reference = Reference::left,
           sign_memory = true);
STEREO_ROW(tiny_signs_w5, option, tiny, window_px = 5, sign_memory = true);
STEREO_ROW(tiny_signs_p4, option, tiny, pixels_per_clock = 4, sign_memory = true);
STEREO_ROW(tiny_w2, option, tiny, window_px = 2);
STEREO_ROW(tiny_w4, option, tiny, window_px = 4);
STEREO_ROW(tiny_w5, option, tiny, window_px = 5, cost_clocks = 2);
STEREO_ROW(tiny_w6_p2, option, tiny, window_px = 6, pixels_per_clock = 2);
STEREO_ROW(tiny_w7, option, tiny, window_px = 7, winner_group = 3);
STEREO_ROW(tiny_w5_p4, option, tiny, window_px = 5, pixels_per_clock = 4, cost_clocks = 1);
STEREO_ROW(tiny_w3_recursive, option, tiny, aggregation = Aggregation::recursive);
STEREO_ROW(tiny_w8_recursive, option, tiny, window_px = 8, aggregation = Aggregation::recursive);
STEREO_ROW(tiny_w9_recursive_p2, option, tiny, window_px = 9, pixels_per_clock = 2,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_w10_recursive_p4, option, tiny, disparities = 9, window_px = 10, pixels_per_clock = 4,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_w21_recursive, option, tiny, height_px = 24, disparities = 12, window_px = 21,
           aggregation = Aggregation::recursive, slice_disparities = 6);
STEREO_ROW(tiny_wide_range, option, tiny, disparities = 29, slice_disparities = 10);
STEREO_ROW(tiny_wide_range_p2, option, tiny, disparities = 28, pixels_per_clock = 2, slice_disparities = 25);
STEREO_ROW(tiny_min3, option, tiny, min_disparity = 3);
STEREO_ROW(tiny_min_negative, option, tiny, min_disparity = -3);
STEREO_ROW(tiny_min_below_p2, option, tiny, pixels_per_clock = 2, min_disparity = -11);
STEREO_ROW(tiny_left, option, tiny, reference = Reference::left);
STEREO_ROW(tiny_left_w4_p2, option, tiny, window_px = 4, pixels_per_clock = 2, reference = Reference::left);
STEREO_ROW(tiny_left_min5, option, tiny, min_disparity = 5, reference = Reference::left);
STEREO_ROW(tiny_left_min_negative, option, tiny, min_disparity = -2, reference = Reference::left);
STEREO_ROW(tiny_ties, option, tiny, ties = Ties::largest);
STEREO_ROW(tiny_left_ties, option, tiny, reference = Reference::left, ties = Ties::largest);
STEREO_ROW(tiny_ssd, option, tiny, cost = Cost::ssd);
STEREO_ROW(tiny_ssd_w5_p2, option, tiny, window_px = 5, pixels_per_clock = 2, cost = Cost::ssd);
STEREO_ROW(tiny_census, option, tiny, cost = Cost::census);
STEREO_ROW(tiny_census_p2, option, tiny, pixels_per_clock = 2, cost = Cost::census, census_width_px = 7,
           census_height_px = 3);
STEREO_ROW(tiny_census_9x7, option, tiny, disparities = 5, cost = Cost::census, census_width_px = 9,
           census_height_px = 7, slice_disparities = 25);
STEREO_ROW(tiny_census_left_recursive, option, tiny, window_px = 6, reference = Reference::left, cost = Cost::census,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_lr, option, tiny, left_right_threshold = 1);
STEREO_ROW(tiny_lr_p2, option, tiny, pixels_per_clock = 2, left_right_threshold = 0);
STEREO_ROW(tiny_lr_left, option, tiny, reference = Reference::left, left_right_threshold = 2);
STEREO_ROW(tiny_lr_left_ties, option, tiny, reference = Reference::left, ties = Ties::largest,
           left_right_threshold = 0);
STEREO_ROW(tiny_lr_min3_recursive, option, tiny, window_px = 7, min_disparity = 3, left_right_threshold = 1,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_unique, option, tiny, uniqueness_percent = 15);
STEREO_ROW(tiny_unique_left_p2, option, tiny, pixels_per_clock = 2, reference = Reference::left,
           uniqueness_percent = 40, winner_group = 3);
STEREO_ROW(tiny_xsobel, option, tiny, prefilter = Prefilter::xsobel);
STEREO_ROW(tiny_xsobel_p2, option, tiny, pixels_per_clock = 2, prefilter = Prefilter::xsobel, prefilter_cap = 63);
STEREO_ROW(tiny_texture, option, tiny, prefilter = Prefilter::xsobel, texture_threshold = 40);
STEREO_ROW(tiny_texture_p4, option, tiny, pixels_per_clock = 4, prefilter = Prefilter::xsobel,
           texture_threshold = 60);
STEREO_ROW(tiny_texture_recursive, option, tiny, window_px = 7, prefilter = Prefilter::xsobel,
           texture_threshold = 300, aggregation = Aggregation::recursive);
STEREO_ROW(tiny_subpixel, option, tiny, subpixel = true);
STEREO_ROW(tiny_subpixel_left_p2, option, tiny, pixels_per_clock = 2, reference = Reference::left, subpixel = true);
STEREO_ROW(tiny_median, option, tiny, median = true);
STEREO_ROW(tiny_median_p2, option, tiny, pixels_per_clock = 2, median = true);
STEREO_ROW(tiny_median_left_subpixel, option, tiny, reference = Reference::left, subpixel = true, median = true);
STEREO_ROW(tiny_all, option, tiny, prefilter = Prefilter::xsobel, left_right_threshold = 1, uniqueness_percent = 10,
           texture_threshold = 30, subpixel = true, median = true);
STEREO_ROW(tiny_all_left_p2, option, tiny, pixels_per_clock = 2, reference = Reference::left,
           prefilter = Prefilter::xsobel, ties = Ties::largest, left_right_threshold = 1, uniqueness_percent = 10,
           texture_threshold = 30, subpixel = true, median = true);
STEREO_ROW(tiny_all_p4, option, tiny, pixels_per_clock = 4, prefilter = Prefilter::xsobel, left_right_threshold = 1,
           uniqueness_percent = 10, texture_threshold = 30, subpixel = true, median = true);
STEREO_ROW(tiny_all_recursive, option, tiny, window_px = 7, min_disparity = 1, prefilter = Prefilter::xsobel,
           left_right_threshold = 1, uniqueness_percent = 10, texture_threshold = 100, subpixel = true, median = true,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_full, option, tiny, full_width = true);
STEREO_ROW(tiny_full_p2, option, tiny, pixels_per_clock = 2, window_px = 4, reference = Reference::left,
           min_disparity = 2, left_right_threshold = 1, full_width = true);
STEREO_ROW(tiny_full_all, option, tiny_all, min_disparity = -3, full_width = true);
STEREO_ROW(tiny_10bit, option, tiny, pixel_bits = 10);
STEREO_ROW(tiny_12bit_all, option, tiny, pixel_bits = 12, window_px = 5, reference = Reference::left,
           prefilter = Prefilter::xsobel, prefilter_cap = 500, ties = Ties::largest, left_right_threshold = 1,
           uniqueness_percent = 10, texture_threshold = 2000, subpixel = true, median = true,
           aggregation = Aggregation::recursive);
STEREO_ROW(tiny_settings, option, tiny_unique, left_right_threshold = 2, run_time_settings = true);
STEREO_ROW(tiny_settings_all, option, tiny_all, run_time_settings = true);
STEREO_ROW(tiny_settings_full, option, tiny_full_all, run_time_settings = true);
STEREO_ROW(tiny_settings_left_p2, option, tiny_all_left_p2, height_px = 16, run_time_settings = true);
STEREO_ROW(tiny_settings_recursive, option, tiny_all_recursive, run_time_settings = true);
STEREO_ROW(tiny_size, option, tiny, run_time_size = true);
STEREO_ROW(tiny_size_all, option, tiny_all, width_px = 40, height_px = 16, run_time_settings = true,
           run_time_size = true);
STEREO_ROW(tiny_size_census_p2, option, tiny_census_p2, height_px = 20, median = true, run_time_size = true);
STEREO_ROW(tiny_size_recursive, option, tiny_all_recursive, width_px = 40, height_px = 24, run_time_settings = true,
           run_time_size = true);
STEREO_ROW(tiny_size_full, option, tiny_full, run_time_size = true);
STEREO_ROW(tiny_size_full_all, option, tiny_full_all, width_px = 40, height_px = 16, reference = Reference::left,
           run_time_settings = true, run_time_size = true);
// The stages of the post-processing, alone and together.
STEREO_ROW(tiny_support, option, tiny, left_right_threshold = 1, support_threshold = 6);
STEREO_ROW(tiny_confidence, option, tiny, reference = Reference::left, support_threshold = 4, confidence = true,
           margin_shift = 2, subpixel = true);
STEREO_ROW(tiny_fill, option, tiny, left_right_threshold = 0, fill_holes = true);
STEREO_ROW(tiny_dense, option, tiny, reference = Reference::left, full_width = true, subpixel = true, median = true,
           left_right_threshold = 1, uniqueness_percent = 5, support_threshold = 5, confidence = true, margin_shift = 3,
           margin_weight = 1, support_weight = 6, fill_holes = true);
STEREO_ROW(tiny_dense_p2, option, tiny_p2, left_right_threshold = 1, subpixel = true, median = true,
           support_threshold = 4, confidence = true, margin_shift = 4, fill_holes = true);
STEREO_ROW(tiny_dense_p4, option, tiny_p4, reference = Reference::left, left_right_threshold = 1, support_threshold = 4,
           subpixel = true, fill_holes = true);
STEREO_ROW(tiny_confidence_p4, option, tiny_p4, left_right_threshold = 1, support_threshold = 4, confidence = true,
           margin_shift = 4, median = true);
STEREO_ROW(tiny_dense_size, option, tiny_dense, height_px = 20, run_time_settings = true, run_time_size = true);
// Several clocks a pixel pair.
STEREO_ROW(tiny_f2, option, tiny, width_px = 48, clocks_per_pixel = 2);
STEREO_ROW(tiny_f2_lr, option, tiny_f2, left_right_threshold = 1);
STEREO_ROW(tiny_f3_census, option, tiny_census, width_px = 60, disparities = 9, ties = Ties::largest,
           left_right_threshold = 0, clocks_per_pixel = 3);
STEREO_ROW(tiny_f3_front, option, tiny_f3_census, front_clocks = 2);
STEREO_ROW(tiny_f4_left, option, tiny, width_px = 48, window_px = 7, min_disparity = -2, reference = Reference::left,
           uniqueness_percent = 10, subpixel = true, aggregation = Aggregation::recursive, clocks_per_pixel = 4);
STEREO_ROW(tiny_f4_all, option, tiny_all, width_px = 60, disparities = 12, pixel_bits = 10, clocks_per_pixel = 4);
STEREO_ROW(tiny_f4_dense, option, tiny_f4_all, left_right_threshold = 1, support_threshold = 4, confidence = true, margin_shift = 2,
           fill_holes = true);
STEREO_ROW(tiny_f4_settings, option, tiny_all_recursive, width_px = 60, height_px = 16, disparities = 12,
           reference = Reference::left, run_time_settings = true, clocks_per_pixel = 4);
// clang-format on

}  // namespace stereo::block_matching::configurations
