# SPDX-License-Identifier: Apache-2.0
# One program for each test file, so that a change of a block costs the compiler that block's test.
add_library(
  stereo_testing STATIC
  testing/map_compare.cpp
  testing/test_main.cpp
  testing/test_pairs.cpp)
target_compile_definitions(stereo_testing PUBLIC STEREO_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                 STEREO_CORE_FOLDER="${PROJECT_BINARY_DIR}/cores")
target_link_libraries(stereo_testing PUBLIC stereo_clocked GTest::gtest stereo_warnings)
# A test runs about once for each time that it is compiled: the compiler's time counts.
target_compile_options(stereo_testing PUBLIC -O0)
target_precompile_headers(stereo_testing PRIVATE <gtest/gtest.h>)
# Whole cores take the compiler long: once for all tests that run them.
add_library(stereo_small_cores STATIC testing/small_cores.cpp testing/small_cores_with_options.cpp)
target_link_libraries(stereo_small_cores PUBLIC stereo_testing)
target_precompile_headers(stereo_small_cores REUSE_FROM stereo_testing)

# Blocks and whole cores.
stereo_add_unit_tests(
  LINK stereo_testing
  FILES
  blocks/support/memory_bank_test.cpp
  blocks/support/minimum_tree_test.cpp
  blocks/support/fan_out_test.cpp
  blocks/support/move_delay_test.cpp
  blocks/support/dense_packed_test.cpp
  blocks/support/packed_test.cpp
  blocks/support/raster_counter_test.cpp
  blocks/support/ring_test.cpp
  blocks/support/row_buffer_test.cpp
  blocks/support/settings_test.cpp
  blocks/frontend/image_size_test.cpp
  blocks/frontend/transform_test.cpp
  blocks/cost/column_cost_test.cpp
  blocks/cost/pixel_cost_test.cpp
  blocks/cost/sign_memory_test.cpp
  blocks/winner/candidate_mask_test.cpp
  blocks/winner/candidate_test.cpp
  blocks/winner/diagonal_minimum_test.cpp
  blocks/winner/left_right_check_test.cpp
  blocks/winner/median_test.cpp
  blocks/winner/refinement_test.cpp
  blocks/winner/sort_three_test.cpp
  blocks/winner/winner_tree_exhaustive_test.cpp
  blocks/block_matching/config_test.cpp
  blocks/block_matching/row_best_test.cpp
  blocks/block_matching/row_check_test.cpp
  blocks/block_matching/row_passes_test.cpp
  blocks/block_matching/row_winners_test.cpp
  blocks/block_matching/texture_test.cpp
  blocks/dynamic_range/coarse_pixels_test.cpp
  blocks/dynamic_range/search_rows_test.cpp
  blocks/dynamic_range/stream_delay_test.cpp
  blocks/dynamic_range/window_targets_test.cpp
  blocks/phase_correlation/config_test.cpp
  blocks/phase_correlation/phase_transform_test.cpp
  blocks/phase_correlation/phase_distance_test.cpp
  blocks/rectification/bilinear_test.cpp
  blocks/rectification/config_test.cpp
  blocks/rectification/quad_memory_test.cpp
  blocks/semi_global/config_test.cpp
  blocks/semi_global/cost_slice_test.cpp
  blocks/semi_global/path_above_test.cpp
  blocks/semi_global/phase_above_test.cpp
  blocks/semi_global/phase_mask_test.cpp
  blocks/semi_global/phase_memory_test.cpp
  blocks/semi_global/phase_other_test.cpp
  blocks/semi_global/phase_pixels_test.cpp
  blocks/semi_global/phase_row_path_test.cpp
  blocks/semi_global/phase_shift_test.cpp
  blocks/semi_global/phase_turn_test.cpp
  blocks/semi_global/phase_window_test.cpp
  blocks/semi_global/phase_winners_test.cpp
  blocks/semi_global/row_order_test.cpp
  blocks/semi_global/row_path_test.cpp
  blocks/trellis/config_test.cpp
  blocks/trellis/forward_test.cpp
  cores/block_matching/core_memories_test.cpp)
# What only the slow set needs: the clocked cores of all configurations, and programs that take long to compile.
add_custom_target(slow_tests)
add_dependencies(slow_tests cores)
stereo_add_unit_tests(SLOW LINK stereo_testing FILES cores/block_matching/core_large_test.cpp)
# Tests of many types.
stereo_add_unit_tests(
  SLOW_TYPES
  LINK stereo_testing
  FILES
  blocks/frontend/line_buffer_test.cpp
  blocks/frontend/pair_delay_test.cpp
  blocks/frontend/raster_test.cpp
  blocks/cost/disparity_shift_test.cpp
  blocks/cost/sad_cost_test.cpp
  blocks/cost/window_sum_test.cpp
  blocks/winner/winner_tree_test.cpp
  blocks/block_matching/disparity_slice_test.cpp
  blocks/rectification/core_test.cpp
  blocks/postprocessing/post_processor_test.cpp)
stereo_add_unit_tests(LINK stereo_small_cores FILES cores/block_matching/core_stream_test.cpp
                      cores/block_matching/core_test.cpp)
stereo_add_unit_tests(LINK stereo_testing stereo_configurations FILES cores/named_cores_test.cpp
                      engines/clocked/register_trace_test.cpp
                      engines/clocked/stimulus_test.cpp engines/clocked/stress_test.cpp engines/rectification/stage_stimulus_test.cpp)
add_dependencies(cores_named_cores_test tested_cores)
stereo_add_unit_tests(LINK stereo_testing stereo_core_check FILES cores/named_streams_test.cpp)
add_dependencies(cores_named_streams_test tested_cores)
stereo_add_unit_tests(LINK stereo_testing stereo_configurations FILES cores/settings_test.cpp)
add_dependencies(cores_settings_test tested_cores)
add_dependencies(engines_clocked_register_trace_test tested_cores)
add_dependencies(engines_clocked_stimulus_test tested_cores)
add_dependencies(engines_clocked_stress_test tested_cores)
# The slow set takes all cores.
foreach(test IN ITEMS cores_named_cores_test cores_named_streams_test cores_settings_test)
  add_test(NAME ${test}_slow COMMAND ${test})
  set_tests_properties(${test}_slow PROPERTIES LABELS "unit;slow" TIMEOUT 3600 ENVIRONMENT STEREO_ALL_CORES=1)
endforeach()

# Definitions, models, the program's parts, the kept cases of fuzzing.
stereo_add_unit_tests(
  LINK stereo_testing stereo_configurations stereo_program stereo_fuzz_targets ${OpenCV_LIBS}
  FILES
  cores/block_matching/core_real_pair_test.cpp
  cosim/vector_files_test.cpp
  definition/block_matching/matching_input_test.cpp
  definition/block_matching/opencv_stereo_bm_test.cpp
  definition/block_matching/reference_model_test.cpp
  definition/block_matching/reference_options_test.cpp
  definition/dynamic_range/reference_model_test.cpp
  definition/dynamic_range/search_windows_test.cpp
  definition/dynamic_range/stress_pairs_test.cpp
  definition/phase_correlation/reference_model_test.cpp
  definition/phase_correlation/stress_pairs_test.cpp
  definition/rectification/reference_model_test.cpp
  definition/postprocessing_test.cpp
  definition/semi_global/reference_model_test.cpp
  definition/trellis/reference_model_test.cpp
  engines/fast/block_matching/fast_model_test.cpp
  engines/fast/dynamic_range/fast_model_test.cpp
  engines/fast/phase_correlation/fast_model_test.cpp
  engines/fast/semi_global/fast_model_test.cpp
  engines/fast/trellis/fast_model_test.cpp
  fuzz/replay_test.cpp
  program/commands/options_json_test.cpp
  program/depth/benchmark_calibration_test.cpp
  program/depth/camera_calibrations_test.cpp
  program/depth/damaged_calibrations_test.cpp
  program/depth/depth_test.cpp
  program/depth/pair_warnings_test.cpp
  program/depth/rectification_test.cpp
  program/depth/rectified_geometry_test.cpp
  program/evaluation/camera_difference_test.cpp
  program/evaluation/masks_test.cpp
  program/evaluation/measures_test.cpp
  program/evaluation/truth_test.cpp
  program/io/child_process_test.cpp
  program/io/images_test.cpp
  program/io/npy_test.cpp
  program/io/pfm_test.cpp
  program/io/plain_yaml_test.cpp
  program/io/png_mark_test.cpp
  program/rectification/map_table_test.cpp
  program/video/frame_names_test.cpp
  scene/scene_test.cpp
  scene/stress_pairs_test.cpp
  testing/map_compare_test.cpp)
# OpenCV's confidence map is in a module of its own.
stereo_add_unit_tests(LINK stereo_testing stereo_configurations stereo_evaluation ${OpenCV_LIBS} opencv_ximgproc
                      FILES program/postprocessing/postprocessing_test.cpp)

# What config.hpp refuses, config_test.cpp has; here that the compiler refuses it too, and shows the sentence.
function(add_rejected_config name wrong message)
  stereo_add_rejected_source(NAME config_rejects.${name} SOURCE blocks/block_matching/config_rejected.cpp DEFINITION
                             STEREO_WRONG=${wrong} MESSAGE "${message}")
endfunction()
add_rejected_config(image width_px=4097 "the image width is 4097 but must be 8 ... 4096")
add_rejected_config(matching prefilter_cap=64 "the prefilter.*s cap is 64 but must be 1 ... 63")
add_rejected_config(structure cost_clocks=4 "the number of clocks of the cost is 4 but must be 1 ... 3")
add_rejected_config(together "disparities=2,config.window_px=5" "the disparity range must exceed the window.*s radius")
add_test(NAME config_accepts.nothing_wrong
         COMMAND "${CMAKE_CXX_COMPILER}" -std=c++20 -fsyntax-only "-I${PROJECT_SOURCE_DIR}/hls" -DSTEREO_WRONG=winner_group=4
                 "${CMAKE_CURRENT_SOURCE_DIR}/blocks/block_matching/config_rejected.cpp")
set_tests_properties(config_accepts.nothing_wrong PROPERTIES LABELS unit)

# The program as its users meet it: a test for each file.
file(GLOB files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/program/commands/*_test.py")
foreach(file IN LISTS files)
  string(REGEX REPLACE "^.*/(.*)_test\\.py$" "\\1" name "${file}")
  stereo_add_pytest(NAME ${name} FILE "${file}" LABELS unit)
endforeach()
stereo_add_pytest(NAME run_pytest FILE "${CMAKE_CURRENT_SOURCE_DIR}/testing/run_pytest_test.py" LABELS unit)
