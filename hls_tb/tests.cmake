# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

add_library(stereo_test_support STATIC support/map_compare.cpp support/test_main.cpp support/test_pairs.cpp)
target_compile_definitions(stereo_test_support PUBLIC STEREO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(stereo_test_support PUBLIC stereo_app GTest::gtest PRIVATE stereo_strict_warnings)

add_executable(
  stereo_tests
  packed_test.cpp
  memory_bank_test.cpp
  ring_test.cpp
  transform_test.cpp
  raster_test.cpp
  pair_delay_test.cpp
  row_buffer_test.cpp
  line_buffer_test.cpp
  disparity_shift_test.cpp
  sad_cost_test.cpp
  pixel_cost_test.cpp
  column_cost_test.cpp
  window_sum_test.cpp
  candidate_test.cpp
  winner_tree_test.cpp
  winner_tree_exhaustive_test.cpp
  diagonal_minimum_test.cpp
  disparity_slice_test.cpp
  texture_test.cpp
  refinement_test.cpp
  left_right_check_test.cpp
  median_test.cpp
  stereo_config_test.cpp
  stereo_core_test.cpp
  stereo_core_large_test.cpp
  stereo_core_options_test.cpp
  stereo_core_real_pair_test.cpp
  stereo_core_stream_test.cpp
  support/small_cores.cpp
  support/small_cores_with_options.cpp
  vectors/stimulus_test.cpp
  vectors/vector_files_test.cpp)
list(JOIN STEREO_CONFIGURATIONS " " built_configurations)
target_compile_definitions(stereo_tests PRIVATE "STEREO_CONFIGURATIONS=\"${built_configurations}\"")
target_link_libraries(stereo_tests PRIVATE stereo_configurations stereo_test_support stereo_warnings)
gtest_discover_tests(stereo_tests DISCOVERY_TIMEOUT 120 PROPERTIES LABELS unit TIMEOUT 600)

# All that needs no core: the models, the program's parts, the kept cases of fuzzing. It builds in a fraction of the
# cores' time.
add_executable(
  stereo_model_tests
  app/child_process_test.cpp
  app/depth_test.cpp
  app/images_test.cpp
  app/masks_test.cpp
  app/measures_test.cpp
  app/options_json_test.cpp
  app/pfm_test.cpp
  app/truth_test.cpp
  fuzz/replay_test.cpp
  models/fast_model_test.cpp
  models/matching_test.cpp
  models/opencv_stereo_bm_test.cpp
  models/reference_model_test.cpp
  models/reference_options_test.cpp
  models/scene_test.cpp
  support/map_compare_test.cpp
  vectors/matching_parameters_test.cpp)
target_include_directories(stereo_model_tests SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(stereo_model_tests PRIVATE stereo_fuzz_targets stereo_test_support ${OpenCV_LIBS} stereo_strict_warnings)
gtest_discover_tests(stereo_model_tests DISCOVERY_TIMEOUT 120 PROPERTIES LABELS unit TIMEOUT 600)

# Member by member: what stereo_config.hpp refuses, and its sentence.
function(add_rejected_config name wrong message)
  stereo_add_rejected_source(NAME stereo_config_rejects.${name} SOURCE stereo_config_rejected.cpp DEFINITION
                             STEREO_WRONG=${wrong} MESSAGE "${message}")
endfunction()
add_rejected_config(wide width_px=4097 "the image width must be 8 ... 4096 pixels")
add_rejected_config(very_narrow "width_px=7,config.disparities=4" "the image width must be 8 ... 4096 pixels")
add_rejected_config(low height_px=2 "the image height must be window_px ... 4096 pixels")
add_rejected_config(high height_px=4097 "the image height must be window_px ... 4096 pixels")
add_rejected_config(small_window window_px=1 "the matching window must be 2x2 ... 31x31 pixels")
add_rejected_config(large_window window_px=32 "the matching window must be 2x2 ... 31x31 pixels")
add_rejected_config(many_disparities disparities=257 "the disparity range must be 2 ... 256")
add_rejected_config(narrow width_px=100 "the image must be wider than the disparity range")
add_rejected_config(beyond_the_right min_disparity=220 "the disparity range lies outside the image")
add_rejected_config(beyond_the_left min_disparity=-319 "the disparity range lies outside the image")
add_rejected_config(disparities_in_radius "disparities=2,config.window_px=5"
                    "the disparity range must exceed the window.s radius")
add_rejected_config(one_disparity disparities=1 "the disparity range must be 2 ... 256")
add_rejected_config(three_pixels pixels_per_clock=3 "1, 2 or 4 pixel pairs can enter in a clock")
add_rejected_config(eight_pixels pixels_per_clock=8 "1, 2 or 4 pixel pairs can enter in a clock")
add_rejected_config(broken_rows "height_px=238,config.pixels_per_clock=4"
                    "the image height must be a multiple of the pixels per clock")
add_rejected_config(one_group "height_px=4,config.pixels_per_clock=4"
                    "the image must be higher than the rows that a window waits for")
foreach(side IN ITEMS width_px=1 width_px=4 width_px=11 height_px=1 height_px=6 height_px=9)
  string(REPLACE "_px=" "_" name "${side}")
  add_rejected_config(census_${name} "census_${side}"
                      "the census window must be 3 ... 9 pixels wide and 3 ... 7 high, both odd")
endforeach()
add_rejected_config(no_cap prefilter_cap=0 "the prefilter.s cap must be 1 ... 63")
add_rejected_config(large_cap prefilter_cap=64 "the prefilter.s cap must be 1 ... 63")
add_rejected_config(filtered_census "cost=stereo::Cost::census,config.prefilter=stereo::Prefilter::xsobel"
                    "the census transform takes no prefilter")
add_rejected_config(low_left_right left_right_threshold=-2 "the left/right threshold must be -1 ... disparities - 1")
add_rejected_config(high_left_right left_right_threshold=100 "the left/right threshold must be -1 ... disparities - 1")
add_rejected_config(low_uniqueness uniqueness_percent=-1 "the uniqueness must be 0 ... 100 percent")
add_rejected_config(high_uniqueness uniqueness_percent=101 "the uniqueness must be 0 ... 100 percent")
add_rejected_config(large_unique_costs "uniqueness_percent=1,config.cost=stereo::Cost::ssd,config.window_px=17"
                    "with a uniqueness check window costs must stay below 2.24")
add_rejected_config(texture_of_grey_values texture_threshold=1 "the texture check needs the prefilter")
add_rejected_config(negative_texture texture_threshold=-1
                    "the texture threshold must be 0 ... the largest texture of a window")
add_rejected_config(large_texture "texture_threshold=280,config.prefilter=stereo::Prefilter::xsobel"
                    "the texture threshold must be 0 ... the largest texture of a window")
add_rejected_config(low_for_census "height_px=3,config.cost=stereo::Cost::census,config.census_height_px=7"
                    "the image must be higher than the rows that a transform waits for")
add_rejected_config(low_for_xsobel
                    "height_px=4,config.window_px=2,config.pixels_per_clock=4,config.prefilter=stereo::Prefilter::xsobel"
                    "the image must be higher than the rows that a transform waits for")
add_rejected_config(low_for_median "height_px=2,config.window_px=2,config.pixels_per_clock=2,config.median=true"
                    "the image must be higher than the row that a median waits for")
add_rejected_config(small_slice slice_disparities=1 "a slice must hold at least 2 disparities")
add_rejected_config(no_cost_clock cost_clocks=0 "the cost must take 1, 2 or 3 clocks")
add_rejected_config(many_cost_clocks cost_clocks=4 "the cost must take 1, 2 or 3 clocks")
add_rejected_config(small_group winner_group=1 "the winner group must have 2 ... 16 candidates")
add_rejected_config(large_group winner_group=17 "the winner group must have 2 ... 16 candidates")
# The neighbours of the borders above are accepted.
function(add_accepted_config name right)
  add_test(NAME stereo_config_accepts.${name}
           COMMAND "${CMAKE_CXX_COMPILER}" -std=c++20 -fsyntax-only "-I${PROJECT_SOURCE_DIR}/hls"
                   "-DSTEREO_WRONG=${right}" "${CMAKE_CURRENT_SOURCE_DIR}/stereo_config_rejected.cpp")
  set_tests_properties(stereo_config_accepts.${name} PROPERTIES LABELS unit)
endfunction()
add_accepted_config(nothing_wrong winner_group=4)
add_accepted_config(smallest "width_px=8,config.height_px=2,config.disparities=2,config.window_px=2")
add_accepted_config(largest "width_px=4096,config.height_px=4096,config.disparities=256,config.window_px=31")
add_accepted_config(farthest_right min_disparity=219)
add_accepted_config(farthest_left min_disparity=-318)
add_accepted_config(unique_costs "uniqueness_percent=100,config.cost=stereo::Cost::ssd,config.window_px=16")
add_accepted_config(
  most "prefilter=stereo::Prefilter::xsobel,config.prefilter_cap=63,config.texture_threshold=567,config.left_right_threshold=99"
)

# The rest needs all configurations.
if(STEREO_CONFIGURATIONS)
  return()
endif()
stereo_add_pytest(NAME stereo_hls_cli FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_cli_test.py" LABELS unit)
stereo_add_pytest(NAME stereo_hls_depth FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_depth_test.py" LABELS unit)
stereo_add_pytest(NAME stereo_hls_evaluate FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_evaluate_test.py" LABELS unit)
stereo_add_pytest(NAME stereo_hls_match FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_match_test.py" LABELS unit)
stereo_add_pytest(NAME stereo_hls_video FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_video_test.py" LABELS unit)
stereo_add_pytest(NAME run_pytest FILE "${CMAKE_CURRENT_SOURCE_DIR}/support/run_pytest_test.py" LABELS unit)
