# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

add_executable(
  stereo_tests
  raster_test.cpp
  reference_delay_test.cpp
  line_buffer_test.cpp
  disparity_shift_test.cpp
  sad_cost_test.cpp
  window_sum_test.cpp
  winner_tree_test.cpp
  winner_tree_exhaustive_test.cpp
  disparity_slice_test.cpp
  stereo_config_test.cpp
  stereo_core_test.cpp
  stereo_core_stream_test.cpp
  models/fast_model_test.cpp
  models/reference_model_test.cpp
  models/scene_test.cpp
  support/map_compare.cpp
  support/map_compare_test.cpp
  support/test_main.cpp
  support/test_pairs.cpp
  vectors/stimulus_test.cpp
  vectors/vector_files_test.cpp)
target_compile_definitions(stereo_tests PRIVATE STEREO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(stereo_tests PRIVATE stereo_configurations stereo_images GTest::gtest stereo_warnings)
gtest_discover_tests(stereo_tests DISCOVERY_TIMEOUT 120 PROPERTIES LABELS unit TIMEOUT 600)

# Member by member: what stereo_config.hpp refuses, and its sentence.
function(add_rejected_config name wrong message)
  stereo_add_rejected_source(NAME stereo_config_rejects.${name} SOURCE stereo_config_rejected.cpp DEFINITION
                             STEREO_WRONG=${wrong} MESSAGE "${message}")
endfunction()
add_rejected_config(wide width_px=4097 "the image width must be 8 ... 4096 pixels")
add_rejected_config(very_narrow "width_px=7,config.disparities=4" "the image width must be 8 ... 4096 pixels")
add_rejected_config(low height_px=2 "the image height must be window_px ... 4096 pixels")
add_rejected_config(high height_px=4097 "the image height must be window_px ... 4096 pixels")
add_rejected_config(even_window window_px=4 "the matching window must be 3x3 or 5x5 pixels")
add_rejected_config(many_disparities disparities=257 "the disparity range must be 2 ... 256")
add_rejected_config(narrow width_px=100 "the image must be wider than the disparity range")
add_rejected_config(disparities_in_radius "disparities=2,config.window_px=5"
                    "the disparity range must exceed the window.s radius")
add_rejected_config(one_disparity disparities=1 "the disparity range must be 2 ... 256")
add_rejected_config(three_pixels pixels_per_clock=3 "1, 2 or 4 pixel pairs can enter in a clock")
add_rejected_config(eight_pixels pixels_per_clock=8 "1, 2 or 4 pixel pairs can enter in a clock")
add_rejected_config(broken_rows "height_px=238,config.pixels_per_clock=4"
                    "the image height must be a multiple of the pixels per clock")
add_rejected_config(one_group "height_px=4,config.pixels_per_clock=4"
                    "the image must be higher than the rows that a window waits for")
add_rejected_config(small_slice slice_disparities=1 "a slice must hold at least 2 disparities")
add_rejected_config(no_cost_clock cost_clocks=0 "the cost must take 1, 2 or 3 clocks")
add_rejected_config(many_cost_clocks cost_clocks=4 "the cost must take 1, 2 or 3 clocks")
add_rejected_config(small_group winner_group=1 "the winner group must have 2 ... 16 candidates")
add_rejected_config(large_group winner_group=17 "the winner group must have 2 ... 16 candidates")
add_test(NAME stereo_config_rejects.nothing_right
         COMMAND "${CMAKE_CXX_COMPILER}" -std=c++20 -fsyntax-only "-I${PROJECT_SOURCE_DIR}/hls"
                 -DSTEREO_WRONG=winner_group=4 "${CMAKE_CURRENT_SOURCE_DIR}/stereo_config_rejected.cpp")
set_tests_properties(stereo_config_rejects.nothing_right PROPERTIES LABELS unit)

stereo_add_pytest(NAME stereo_hls_cli FILE "${CMAKE_CURRENT_SOURCE_DIR}/app/stereo_hls_cli_test.py" LABELS unit)
stereo_add_pytest(NAME run_pytest FILE "${CMAKE_CURRENT_SOURCE_DIR}/support/run_pytest_test.py" LABELS unit)
