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

// clang-format off
/// Systems that the paper compares itself with (its table 2), one pixel pair a clock. Niitsuma and Maruyama:
/// 640x480 and 320x240, 7x7.
inline constexpr StereoConfig niitsuma_640{
    .width_px = 640, .height_px = 480, .disparities = 27, .window_px = 7, .aggregation = Aggregation::recursive,
    .slice_disparities = 14};
inline constexpr StereoConfig niitsuma_320{
    .width_px = 320, .height_px = 240, .disparities = 121, .window_px = 7, .aggregation = Aggregation::recursive};
/// Lee et al.: 16x16.
inline constexpr StereoConfig lee_320{
    .width_px = 320, .height_px = 240, .disparities = 64, .window_px = 16, .aggregation = Aggregation::recursive,
    .slice_disparities = 16};
/// Miyajima and Maruyama: 7x7.
inline constexpr StereoConfig miyajima_640{
    .width_px = 640, .height_px = 480, .disparities = 200, .window_px = 7, .aggregation = Aggregation::recursive};
/// Yi et al.: SAD, the window is not stated; 9x9 here.
inline constexpr StereoConfig yi_270{
    .width_px = 270, .height_px = 270, .disparities = 34, .window_px = 9, .aggregation = Aggregation::recursive,
    .slice_disparities = 17};
/// Han et al.: SAD, the window is not stated; 9x9 here.
inline constexpr StereoConfig han_640{
    .width_px = 640, .height_px = 480, .disparities = 128, .window_px = 9, .aggregation = Aggregation::recursive};
/// DeepSea (Woodfill et al.): census; its windows are 7x7 here.
inline constexpr StereoConfig deepsea_512{
    .width_px = 512, .height_px = 480, .disparities = 52, .window_px = 7, .cost = Cost::census,
    .census_width_px = 7, .census_height_px = 7, .aggregation = Aggregation::recursive, .slice_disparities = 13};
/// OpenCV's StereoBM with block 15 and 64 disparities, at the size of the Middlebury pair Teddy.
inline constexpr StereoConfig opencv_bm{
    .width_px = 450, .height_px = 375, .disparities = 64, .window_px = 15, .reference = Reference::left,
    .prefilter = Prefilter::xsobel, .ties = Ties::largest, .uniqueness_percent = 15, .texture_threshold = 10,
    .subpixel = true, .aggregation = Aggregation::recursive, .slice_disparities = 16};
/// The best trade-off that docs/quality.md found at the size of the Middlebury pair Teddy.
inline constexpr StereoConfig census_450{
    .width_px = 450, .height_px = 375, .disparities = 48, .window_px = 9, .reference = Reference::left,
    .cost = Cost::census, .census_width_px = 9, .census_height_px = 3, .subpixel = true, .median = true,
    .aggregation = Aggregation::recursive, .slice_disparities = 16};

/// What one option costs: each beside `study`, which has none (docs/features.md).
inline constexpr StereoConfig study{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 8};
inline constexpr StereoConfig study_p2{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .pixels_per_clock = 2,
    .slice_disparities = 8};
inline constexpr StereoConfig study_p4{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .pixels_per_clock = 4,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w3{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 3, .slice_disparities = 8};
inline constexpr StereoConfig study_w7{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 7, .slice_disparities = 8};
inline constexpr StereoConfig study_w9{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 9, .slice_disparities = 8};
inline constexpr StereoConfig study_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w3_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 3, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w7_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 7, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w9_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 9, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w15_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 15, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_w21_recursive{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 21, .aggregation = Aggregation::recursive,
    .slice_disparities = 8};
inline constexpr StereoConfig study_left{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .reference = Reference::left,
    .slice_disparities = 8};
inline constexpr StereoConfig study_min8{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .min_disparity = 8, .slice_disparities = 8};
inline constexpr StereoConfig study_ssd{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .cost = Cost::ssd, .slice_disparities = 8};
inline constexpr StereoConfig study_census{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .cost = Cost::census, .slice_disparities = 8};
inline constexpr StereoConfig study_left_right{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .left_right_threshold = 1,
    .slice_disparities = 8};
inline constexpr StereoConfig study_uniqueness{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .uniqueness_percent = 15,
    .slice_disparities = 8};
inline constexpr StereoConfig study_xsobel{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .prefilter = Prefilter::xsobel,
    .slice_disparities = 8};
inline constexpr StereoConfig study_texture{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .prefilter = Prefilter::xsobel,
    .texture_threshold = 60, .slice_disparities = 8};
inline constexpr StereoConfig study_subpixel{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .subpixel = true, .slice_disparities = 8};
inline constexpr StereoConfig study_median{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .median = true, .slice_disparities = 8};
inline constexpr StereoConfig study_all{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .prefilter = Prefilter::xsobel,
    .left_right_threshold = 1, .uniqueness_percent = 15, .texture_threshold = 60, .subpixel = true,
    .median = true, .slice_disparities = 8};
inline constexpr StereoConfig study_cost2{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 8,
    .cost_clocks = 2};
inline constexpr StereoConfig study_cost1{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 8,
    .cost_clocks = 1};
inline constexpr StereoConfig study_group4{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 8,
    .winner_group = 4};
inline constexpr StereoConfig study_slice4{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 4};
inline constexpr StereoConfig study_slice16{
    .width_px = 96, .height_px = 64, .disparities = 16, .window_px = 5, .slice_disparities = 16};
// clang-format on

// One option after the other, alone and together, at a size that a test can afford.
// clang-format off
inline constexpr StereoConfig tiny_w2{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 2, .slice_disparities = 3};
inline constexpr StereoConfig tiny_w4{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 4, .slice_disparities = 3};
inline constexpr StereoConfig tiny_w5{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 5, .slice_disparities = 3, .cost_clocks = 2};
inline constexpr StereoConfig tiny_w6_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 6, .pixels_per_clock = 2,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_w7{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 7, .slice_disparities = 3, .winner_group = 3};
inline constexpr StereoConfig tiny_w5_p4{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 5, .pixels_per_clock = 4,
    .slice_disparities = 3, .cost_clocks = 1};
inline constexpr StereoConfig tiny_w3_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .aggregation = Aggregation::recursive,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_w8_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 8, .aggregation = Aggregation::recursive,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_w9_recursive_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 9, .pixels_per_clock = 2,
    .aggregation = Aggregation::recursive, .slice_disparities = 3};
inline constexpr StereoConfig tiny_w10_recursive_p4{
    .width_px = 32, .height_px = 12, .disparities = 9, .window_px = 10, .pixels_per_clock = 4,
    .aggregation = Aggregation::recursive, .slice_disparities = 3};
inline constexpr StereoConfig tiny_w21_recursive{
    .width_px = 32, .height_px = 24, .disparities = 12, .window_px = 21, .aggregation = Aggregation::recursive,
    .slice_disparities = 6};
inline constexpr StereoConfig tiny_wide_range{
    .width_px = 32, .height_px = 12, .disparities = 29, .slice_disparities = 10};
inline constexpr StereoConfig tiny_wide_range_p2{
    .width_px = 32, .height_px = 12, .disparities = 28, .pixels_per_clock = 2, .slice_disparities = 25};
inline constexpr StereoConfig tiny_min3{
    .width_px = 32, .height_px = 12, .disparities = 8, .min_disparity = 3, .slice_disparities = 3};
inline constexpr StereoConfig tiny_min_negative{
    .width_px = 32, .height_px = 12, .disparities = 8, .min_disparity = -3, .slice_disparities = 3};
inline constexpr StereoConfig tiny_min_below_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .min_disparity = -11,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_left{
    .width_px = 32, .height_px = 12, .disparities = 8, .reference = Reference::left, .slice_disparities = 3};
inline constexpr StereoConfig tiny_left_w4_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 4, .pixels_per_clock = 2,
    .reference = Reference::left, .slice_disparities = 3};
inline constexpr StereoConfig tiny_left_min5{
    .width_px = 32, .height_px = 12, .disparities = 8, .min_disparity = 5, .reference = Reference::left,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_left_min_negative{
    .width_px = 32, .height_px = 12, .disparities = 8, .min_disparity = -2, .reference = Reference::left,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_ties{
    .width_px = 32, .height_px = 12, .disparities = 8, .ties = Ties::largest, .slice_disparities = 3};
inline constexpr StereoConfig tiny_left_ties{
    .width_px = 32, .height_px = 12, .disparities = 8, .reference = Reference::left, .ties = Ties::largest,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_ssd{
    .width_px = 32, .height_px = 12, .disparities = 8, .cost = Cost::ssd, .slice_disparities = 3};
inline constexpr StereoConfig tiny_ssd_w5_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 5, .pixels_per_clock = 2, .cost = Cost::ssd,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_census{
    .width_px = 32, .height_px = 12, .disparities = 8, .cost = Cost::census, .slice_disparities = 3};
inline constexpr StereoConfig tiny_census_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .cost = Cost::census,
    .census_width_px = 7, .census_height_px = 3, .slice_disparities = 3};
inline constexpr StereoConfig tiny_census_9x7{
    .width_px = 32, .height_px = 12, .disparities = 5, .cost = Cost::census, .census_width_px = 9,
    .census_height_px = 7, .slice_disparities = 25};
inline constexpr StereoConfig tiny_census_left_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 6, .reference = Reference::left,
    .cost = Cost::census, .aggregation = Aggregation::recursive, .slice_disparities = 3};
inline constexpr StereoConfig tiny_lr{
    .width_px = 32, .height_px = 12, .disparities = 8, .left_right_threshold = 1, .slice_disparities = 3};
inline constexpr StereoConfig tiny_lr_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .left_right_threshold = 0,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_lr_left{
    .width_px = 32, .height_px = 12, .disparities = 8, .reference = Reference::left, .left_right_threshold = 2,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_lr_left_ties{
    .width_px = 32, .height_px = 12, .disparities = 8, .reference = Reference::left, .ties = Ties::largest,
    .left_right_threshold = 0, .slice_disparities = 3};
inline constexpr StereoConfig tiny_lr_min3_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 7, .min_disparity = 3,
    .left_right_threshold = 1, .aggregation = Aggregation::recursive, .slice_disparities = 3};
inline constexpr StereoConfig tiny_unique{
    .width_px = 32, .height_px = 12, .disparities = 8, .uniqueness_percent = 15, .slice_disparities = 3};
inline constexpr StereoConfig tiny_unique_left_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .reference = Reference::left,
    .uniqueness_percent = 40, .slice_disparities = 3, .winner_group = 3};
inline constexpr StereoConfig tiny_xsobel{
    .width_px = 32, .height_px = 12, .disparities = 8, .prefilter = Prefilter::xsobel, .slice_disparities = 3};
inline constexpr StereoConfig tiny_xsobel_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .prefilter = Prefilter::xsobel,
    .prefilter_cap = 63, .slice_disparities = 3};
inline constexpr StereoConfig tiny_texture{
    .width_px = 32, .height_px = 12, .disparities = 8, .prefilter = Prefilter::xsobel, .texture_threshold = 40,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_texture_p4{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 4, .prefilter = Prefilter::xsobel,
    .texture_threshold = 60, .slice_disparities = 3};
inline constexpr StereoConfig tiny_texture_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 7, .prefilter = Prefilter::xsobel,
    .texture_threshold = 300, .aggregation = Aggregation::recursive, .slice_disparities = 3};
inline constexpr StereoConfig tiny_subpixel{
    .width_px = 32, .height_px = 12, .disparities = 8, .subpixel = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_subpixel_left_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .reference = Reference::left,
    .subpixel = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_median{
    .width_px = 32, .height_px = 12, .disparities = 8, .median = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_median_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .median = true,
    .slice_disparities = 3};
inline constexpr StereoConfig tiny_median_left_subpixel{
    .width_px = 32, .height_px = 12, .disparities = 8, .reference = Reference::left, .subpixel = true,
    .median = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_all{
    .width_px = 32, .height_px = 12, .disparities = 8, .prefilter = Prefilter::xsobel, .left_right_threshold = 1,
    .uniqueness_percent = 10, .texture_threshold = 30, .subpixel = true, .median = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_all_left_p2{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 2, .reference = Reference::left,
    .prefilter = Prefilter::xsobel, .ties = Ties::largest, .left_right_threshold = 1, .uniqueness_percent = 10,
    .texture_threshold = 30, .subpixel = true, .median = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_all_p4{
    .width_px = 32, .height_px = 12, .disparities = 8, .pixels_per_clock = 4, .prefilter = Prefilter::xsobel,
    .left_right_threshold = 1, .uniqueness_percent = 10, .texture_threshold = 30, .subpixel = true,
    .median = true, .slice_disparities = 3};
inline constexpr StereoConfig tiny_all_recursive{
    .width_px = 32, .height_px = 12, .disparities = 8, .window_px = 7, .min_disparity = 1,
    .prefilter = Prefilter::xsobel, .left_right_threshold = 1, .uniqueness_percent = 10, .texture_threshold = 100,
    .subpixel = true, .median = true, .aggregation = Aggregation::recursive, .slice_disparities = 3};

}  // namespace stereo::configurations

// Each calls the macro CALL(name) for some of the named configurations: as many as one translation unit should hold.
#define STEREO_PAPER_CONFIGURATIONS(CALL) \
   CALL(ambrosch2007) CALL(ambrosch2007_p2) CALL(ambrosch2007_p4)
#define STEREO_TINY_CONFIGURATIONS(CALL) \
   CALL(tiny) CALL(tiny_p2) CALL(tiny_p4)
#define STEREO_OPTION_CONFIGURATIONS_A(CALL) \
   CALL(tiny_w2) CALL(tiny_w4) CALL(tiny_w5) CALL(tiny_w6_p2) CALL(tiny_w7) CALL(tiny_w5_p4) \
   CALL(tiny_w3_recursive) CALL(tiny_w8_recursive) CALL(tiny_w9_recursive_p2) CALL(tiny_w10_recursive_p4) \
   CALL(tiny_w21_recursive) CALL(tiny_wide_range) CALL(tiny_wide_range_p2)
#define STEREO_OPTION_CONFIGURATIONS_B(CALL) \
   CALL(tiny_min3) CALL(tiny_min_negative) CALL(tiny_min_below_p2) CALL(tiny_left) CALL(tiny_left_w4_p2) \
   CALL(tiny_left_min5) CALL(tiny_left_min_negative) CALL(tiny_ties) CALL(tiny_left_ties) CALL(tiny_ssd) \
   CALL(tiny_ssd_w5_p2) CALL(tiny_census) CALL(tiny_census_p2)
#define STEREO_OPTION_CONFIGURATIONS_C(CALL) \
   CALL(tiny_census_9x7) CALL(tiny_census_left_recursive) CALL(tiny_lr) CALL(tiny_lr_p2) CALL(tiny_lr_left) \
   CALL(tiny_lr_left_ties) CALL(tiny_lr_min3_recursive) CALL(tiny_unique) CALL(tiny_unique_left_p2) \
   CALL(tiny_xsobel) CALL(tiny_xsobel_p2) CALL(tiny_texture) CALL(tiny_texture_p4)
#define STEREO_OPTION_CONFIGURATIONS_D(CALL) \
   CALL(tiny_texture_recursive) CALL(tiny_subpixel) CALL(tiny_subpixel_left_p2) CALL(tiny_median) \
   CALL(tiny_median_p2) CALL(tiny_median_left_subpixel) CALL(tiny_all) CALL(tiny_all_left_p2) CALL(tiny_all_p4) \
   CALL(tiny_all_recursive)
#define STEREO_SYSTEM_CONFIGURATIONS(CALL) \
   CALL(niitsuma_640) CALL(niitsuma_320) CALL(lee_320) CALL(miyajima_640) CALL(yi_270) CALL(han_640) \
   CALL(deepsea_512) CALL(opencv_bm) CALL(census_450)
#define STEREO_STUDY_CONFIGURATIONS_A(CALL) \
   CALL(study) CALL(study_p2) CALL(study_p4) CALL(study_w3) CALL(study_w7) CALL(study_w9) CALL(study_recursive) \
   CALL(study_w3_recursive) CALL(study_w7_recursive) CALL(study_w9_recursive) CALL(study_w15_recursive) \
   CALL(study_w21_recursive) CALL(study_left) CALL(study_min8)
#define STEREO_STUDY_CONFIGURATIONS_B(CALL) \
   CALL(study_ssd) CALL(study_census) CALL(study_left_right) CALL(study_uniqueness) CALL(study_xsobel) \
   CALL(study_texture) CALL(study_subpixel) CALL(study_median) CALL(study_all) CALL(study_cost2) \
   CALL(study_cost1) CALL(study_group4) CALL(study_slice4) CALL(study_slice16)

/// Calls the macro CALL(name) for each named configuration.
#define STEREO_FOR_EACH_CONFIGURATION(CALL) \
   STEREO_PAPER_CONFIGURATIONS(CALL) STEREO_TINY_CONFIGURATIONS(CALL) STEREO_SYSTEM_CONFIGURATIONS(CALL) \
   STEREO_STUDY_CONFIGURATIONS_A(CALL) STEREO_STUDY_CONFIGURATIONS_B(CALL) \
   STEREO_OPTION_CONFIGURATIONS_A(CALL) \
   STEREO_OPTION_CONFIGURATIONS_B(CALL) STEREO_OPTION_CONFIGURATIONS_C(CALL) \
   STEREO_OPTION_CONFIGURATIONS_D(CALL)
// clang-format on
