-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration study_all: 96x64, 16 disparities, window 5x5, 1 pixel pairs a clock.
-- Options: disparities 16, window_px 5, prefilter xsobel, left_right_threshold 1, uniqueness_percent 15,
--   texture_threshold 60, subpixel true, median true, slice_disparities 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config study_all
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_study_all is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 96;
    height_px : positive := 64;
    disparities : positive := 16;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 80;
    latency_clocks : positive := 42;
    flush_groups : positive := 402;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 96 report "stereo_core_study_all: width_px is " & integer'image(width_px) & " but this core has 96" severity failure;
  assert height_px = 64 report "stereo_core_study_all: height_px is " & integer'image(height_px) & " but this core has 64" severity failure;
  assert disparities = 16 report "stereo_core_study_all: disparities is " & integer'image(disparities) & " but this core has 16" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_study_all: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_study_all: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 80 report "stereo_core_study_all: output_width_px is " & integer'image(output_width_px) & " but this core has 80" severity failure;
  assert latency_clocks = 42 report "stereo_core_study_all: latency_clocks is " & integer'image(latency_clocks) & " but this core has 42" severity failure;
  assert flush_groups = 402 report "stereo_core_study_all: flush_groups is " & integer'image(flush_groups) & " but this core has 402" severity failure;
  assert gap_groups = 0 report "stereo_core_study_all: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_study_all is
  function magnitude(value : integer) return natural is
  begin
    if value < 0 then
      return -value;
    end if;
    return value;
  end function;

  -- the complement of a negative number: its magnitude less 1
  function folded(value : integer) return natural is
  begin
    if value < 0 then
      return -1 - value;
    end if;
    return value;
  end function;

  function positive_part(value : integer) return natural is
  begin
    if value < 0 then
      return 0;
    end if;
    return value;
  end function;

  function as_number(value : boolean) return natural is
  begin
    if value then
      return 1;
    end if;
    return 0;
  end function;

  function as_bit(value : boolean) return std_logic is
  begin
    if value then
      return '1';
    end if;
    return '0';
  end function;

  signal in_valid : boolean;
  signal in_start_of_frame : boolean;
  signal in_right_pixel : natural range 0 to 255;
  signal in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_left_column_0, transform_left_column_1 : natural range 0 to 255;
  signal transform_left_column_2, transform_right_column_0, transform_right_column_1 : natural range 0 to 255;
  signal transform_right_column_2 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_column_inside_0, transform_read_column_inside_2 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_2, transform_ready_column_inside_0, transform_ready_column_inside_2 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_2, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_start_of_frame, transform_columns_valid, transform_filtering_column_inside_0 : boolean;
  signal transform_filtering_column_inside_2, transform_filtering_start_of_frame, transform_filtering_valid : boolean;
  signal transform_filtered_start_of_frame, transform_filtered_valid : boolean;
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 127;
  signal transform_ready_column, transform_write_column : natural range 0 to 127;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 65535;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_column_0_0, transform_left_filter_column_1_0 : natural range 0 to 1020;
  signal transform_left_filter_column_2_0, transform_right_filter_column_0_0 : natural range 0 to 1020;
  signal transform_right_filter_column_1_0, transform_right_filter_column_2_0 : natural range 0 to 1020;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 63;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 63;
  signal raster_features_start_of_frame, raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 127;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 63;
  signal delay_delayed_0 : unsigned(5 downto 0);
  signal delay_column : natural range 0 to 127;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_row_inside_3, delay_row_inside_4 : boolean;
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0 : unsigned(26 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 63;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_3 : natural range 0 to 63;
  signal rows_search_4, rows_reference_4 : natural range 0 to 63;
  signal rows_search_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 134217727;
  signal rows_search_rows_write_words_0 : natural range 0 to 133169151;
  signal rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_reference_rows_ready_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column, rows_search_0, rows_search_1 : natural range 0 to 127;
  signal rows_search_2, rows_reference_0, rows_reference_1, rows_reference_2, rows_reference_3 : natural range 0 to 127;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_inside_3, rows_read_inside_4 : boolean;
  signal rows_read_tag_valid, rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2, rows_ready_inside_3 : boolean;
  signal rows_ready_inside_4, rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_first_cost : boolean;
  signal rows_ready_tag_map_column, rows_ready_tag_output_column, rows_ready_tag_start_of_frame : boolean;
  signal rows_ready_tag_end_of_line, rows_inside_0, rows_inside_1, rows_inside_2, rows_inside_3 : boolean;
  signal rows_inside_4, rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 127;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 127;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_1_0 : natural range 0 to 127;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 127;
  signal slice0shift_search_1_4, slice0shift_search_1_5, slice0shift_search_1_6 : natural range 0 to 127;
  signal slice0shift_search_1_7, slice0shift_search_2_0, slice0shift_search_2_1 : natural range 0 to 127;
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : natural range 0 to 127;
  signal slice0shift_search_2_5, slice0shift_search_2_6, slice0shift_search_2_7 : natural range 0 to 127;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 127;
  signal slice0shift_reference_3, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 127;
  signal slice0shift_search_out_2 : natural range 0 to 127;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 63;
  signal slice0shift_search_3_3, slice0shift_search_3_4, slice0shift_search_3_5 : natural range 0 to 63;
  signal slice0shift_search_3_6, slice0shift_search_3_7, slice0shift_search_4_0 : natural range 0 to 63;
  signal slice0shift_search_4_1, slice0shift_search_4_2, slice0shift_search_4_3 : natural range 0 to 63;
  signal slice0shift_search_4_4, slice0shift_search_4_5, slice0shift_search_4_6 : natural range 0 to 63;
  signal slice0shift_search_4_7, slice0shift_reference_4, slice0shift_search_out_3 : natural range 0 to 63;
  signal slice0shift_search_out_4 : natural range 0 to 63;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -127 to 127;
  signal slice0cost_difference_0_3, slice0cost_difference_0_4, slice0cost_difference_0_5 : integer range -127 to 127;
  signal slice0cost_difference_0_6, slice0cost_difference_0_7, slice0cost_difference_1_0 : integer range -127 to 127;
  signal slice0cost_difference_1_1, slice0cost_difference_1_2, slice0cost_difference_1_3 : integer range -127 to 127;
  signal slice0cost_difference_1_4, slice0cost_difference_1_5, slice0cost_difference_1_6 : integer range -127 to 127;
  signal slice0cost_difference_1_7, slice0cost_difference_2_0, slice0cost_difference_2_1 : integer range -127 to 127;
  signal slice0cost_difference_2_2, slice0cost_difference_2_3, slice0cost_difference_2_4 : integer range -127 to 127;
  signal slice0cost_difference_2_5, slice0cost_difference_2_6, slice0cost_difference_2_7 : integer range -127 to 127;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -127 to 63;
  signal slice0cost_difference_3_3, slice0cost_difference_3_4, slice0cost_difference_3_5 : integer range -127 to 63;
  signal slice0cost_difference_3_6, slice0cost_difference_3_7 : integer range -127 to 63;
  signal slice0cost_difference_4_0, slice0cost_difference_4_1, slice0cost_difference_4_2 : integer range -63 to 63;
  signal slice0cost_difference_4_3, slice0cost_difference_4_4, slice0cost_difference_4_5 : integer range -63 to 63;
  signal slice0cost_difference_4_6, slice0cost_difference_4_7 : integer range -63 to 63;
  signal slice0cost_reverse_0_0, slice0cost_reverse_0_1, slice0cost_reverse_0_2 : natural range 0 to 255;
  signal slice0cost_reverse_0_3, slice0cost_reverse_0_4, slice0cost_reverse_0_5 : natural range 0 to 255;
  signal slice0cost_reverse_0_6, slice0cost_reverse_0_7, slice0cost_reverse_1_0 : natural range 0 to 255;
  signal slice0cost_reverse_1_1, slice0cost_reverse_1_2, slice0cost_reverse_1_3 : natural range 0 to 255;
  signal slice0cost_reverse_1_4, slice0cost_reverse_1_5, slice0cost_reverse_1_6 : natural range 0 to 255;
  signal slice0cost_reverse_1_7 : natural range 0 to 255;
  signal slice0cost_reverse_2_0, slice0cost_reverse_2_1, slice0cost_reverse_2_2, slice0cost_reverse_2_3 : boolean;
  signal slice0cost_reverse_2_4, slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_first_cost, slice0cost_difference_tag_map_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_negative_0_3, slice0cost_negative_0_4, slice0cost_negative_0_5 : boolean;
  signal slice0cost_negative_0_6, slice0cost_negative_0_7, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_first_cost, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_start_of_frame : boolean;
  signal slice0cost_pair_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_border_column : boolean;
  signal slice0cost_tag_first_cost, slice0cost_tag_map_column, slice0cost_tag_output_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 383;
  signal slice0cost_pair_0_4, slice0cost_pair_0_5, slice0cost_pair_0_6, slice0cost_pair_0_7 : natural range 0 to 383;
  signal slice0cost_pair_1_0, slice0cost_pair_1_1, slice0cost_pair_1_2, slice0cost_pair_1_3 : natural range 0 to 382;
  signal slice0cost_pair_1_4, slice0cost_pair_1_5, slice0cost_pair_1_6, slice0cost_pair_1_7 : natural range 0 to 382;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 127;
  signal slice0cost_single_0_3, slice0cost_single_0_4, slice0cost_single_0_5 : natural range 0 to 127;
  signal slice0cost_single_0_6, slice0cost_single_0_7 : natural range 0 to 127;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 893;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 893;
  signal slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 893;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 893;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4, slice0window_partial_0_0_5 : natural range 0 to 893;
  signal slice0window_partial_0_0_6, slice0window_partial_0_0_7 : natural range 0 to 893;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1786;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4, slice0window_partial_0_1_5 : natural range 0 to 1786;
  signal slice0window_partial_0_1_6, slice0window_partial_0_1_7 : natural range 0 to 1786;
  signal slice0window_partial_0_2_0, slice0window_partial_0_2_1, slice0window_partial_0_2_2 : natural range 0 to 2679;
  signal slice0window_partial_0_2_3, slice0window_partial_0_2_4, slice0window_partial_0_2_5 : natural range 0 to 2679;
  signal slice0window_partial_0_2_6, slice0window_partial_0_2_7 : natural range 0 to 2679;
  signal slice0window_partial_0_3_0, slice0window_partial_0_3_1, slice0window_partial_0_3_2 : natural range 0 to 3572;
  signal slice0window_partial_0_3_3, slice0window_partial_0_3_4, slice0window_partial_0_3_5 : natural range 0 to 3572;
  signal slice0window_partial_0_3_6, slice0window_partial_0_3_7 : natural range 0 to 3572;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_output_column_1, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_first_column_1, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_start_of_frame_1, slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_first_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 4465;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 4465;
  signal slice0window_sum_0_6, slice0window_sum_0_7 : natural range 0 to 4465;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 4465;
  signal slice0other_cost_0_3, slice0other_cost_0_4, slice0other_cost_0_5 : natural range 0 to 4465;
  signal slice0other_cost_0_6, slice0other_cost_0_7, slice0other_cost_out_0 : natural range 0 to 4465;
  signal slice0other_winner_0_0, slice0other_winner_0_1, slice0other_winner_0_2 : natural range 0 to 15;
  signal slice0other_winner_0_3, slice0other_winner_0_4, slice0other_winner_0_5 : natural range 0 to 15;
  signal slice0other_winner_0_6, slice0other_winner_0_7, slice0other_winner_out_0 : natural range 0 to 15;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 4465;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 4465;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_first_column, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_2, slice0winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_0, slice0winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_2, slice0winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_0, slice0winner1_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_2, slice0winner1_best_first_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_0, slice0winner1_best_last_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_2, slice0winner1_best_last_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_second_0_0, slice0winner1_best_but_first_0_0 : natural range 0 to 2047;
  signal slice0winner1_best_but_first_0_1, slice0winner1_best_but_first_0_2 : natural range 0 to 2047;
  signal slice0winner1_best_but_last_0_0, slice0winner1_best_but_last_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_but_last_0_2 : natural range 0 to 2047;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 4465;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_first_0_0, slice0winner2_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_last_0_0, slice0winner2_best_second_0_0 : natural range 0 to 2047;
  signal slice0winner2_best_second_0_1, slice0winner2_best_but_first_0_0 : natural range 0 to 2047;
  signal slice0winner2_best_but_first_0_1, slice0winner2_best_but_last_0_0 : natural range 0 to 2047;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0 : natural range 0 to 4465;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_below_0_0, slice0winner3_best_above_0_0 : natural range 0 to 2047;
  signal slice0winner3_best_first_0_0, slice0winner3_best_second_0_0 : natural range 0 to 2047;
  signal slice0winner3_best_but_first_0_0 : natural range 0 to 2047;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_output_column : boolean;
  signal slice0winner3_tag_start_of_frame, slice0winner3_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 4465;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_first_0_0 : natural range 0 to 2047;
  signal slice0_best_second_0_0, slice0_best_but_first_0_0 : natural range 0 to 2047;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_output_column : boolean;
  signal slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 127;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 127;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_1_0 : natural range 0 to 127;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 127;
  signal slice1shift_search_1_4, slice1shift_search_1_5, slice1shift_search_1_6 : natural range 0 to 127;
  signal slice1shift_search_1_7, slice1shift_search_2_0, slice1shift_search_2_1 : natural range 0 to 127;
  signal slice1shift_search_2_2, slice1shift_search_2_3, slice1shift_search_2_4 : natural range 0 to 127;
  signal slice1shift_search_2_5, slice1shift_search_2_6, slice1shift_search_2_7 : natural range 0 to 127;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 127;
  signal slice1shift_reference_3 : natural range 0 to 127;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 63;
  signal slice1shift_search_3_3, slice1shift_search_3_4, slice1shift_search_3_5 : natural range 0 to 63;
  signal slice1shift_search_3_6, slice1shift_search_3_7, slice1shift_search_4_0 : natural range 0 to 63;
  signal slice1shift_search_4_1, slice1shift_search_4_2, slice1shift_search_4_3 : natural range 0 to 63;
  signal slice1shift_search_4_4, slice1shift_search_4_5, slice1shift_search_4_6 : natural range 0 to 63;
  signal slice1shift_search_4_7, slice1shift_reference_4 : natural range 0 to 63;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -127 to 127;
  signal slice1cost_difference_0_3, slice1cost_difference_0_4, slice1cost_difference_0_5 : integer range -127 to 127;
  signal slice1cost_difference_0_6, slice1cost_difference_0_7, slice1cost_difference_1_0 : integer range -127 to 127;
  signal slice1cost_difference_1_1, slice1cost_difference_1_2, slice1cost_difference_1_3 : integer range -127 to 127;
  signal slice1cost_difference_1_4, slice1cost_difference_1_5, slice1cost_difference_1_6 : integer range -127 to 127;
  signal slice1cost_difference_1_7, slice1cost_difference_2_0, slice1cost_difference_2_1 : integer range -127 to 127;
  signal slice1cost_difference_2_2, slice1cost_difference_2_3, slice1cost_difference_2_4 : integer range -127 to 127;
  signal slice1cost_difference_2_5, slice1cost_difference_2_6, slice1cost_difference_2_7 : integer range -127 to 127;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -127 to 63;
  signal slice1cost_difference_3_3, slice1cost_difference_3_4, slice1cost_difference_3_5 : integer range -127 to 63;
  signal slice1cost_difference_3_6, slice1cost_difference_3_7 : integer range -127 to 63;
  signal slice1cost_difference_4_0, slice1cost_difference_4_1, slice1cost_difference_4_2 : integer range -63 to 63;
  signal slice1cost_difference_4_3, slice1cost_difference_4_4, slice1cost_difference_4_5 : integer range -63 to 63;
  signal slice1cost_difference_4_6, slice1cost_difference_4_7 : integer range -63 to 63;
  signal slice1cost_reverse_0_0, slice1cost_reverse_0_1, slice1cost_reverse_0_2 : natural range 0 to 255;
  signal slice1cost_reverse_0_3, slice1cost_reverse_0_4, slice1cost_reverse_0_5 : natural range 0 to 255;
  signal slice1cost_reverse_0_6, slice1cost_reverse_0_7, slice1cost_reverse_1_0 : natural range 0 to 255;
  signal slice1cost_reverse_1_1, slice1cost_reverse_1_2, slice1cost_reverse_1_3 : natural range 0 to 255;
  signal slice1cost_reverse_1_4, slice1cost_reverse_1_5, slice1cost_reverse_1_6 : natural range 0 to 255;
  signal slice1cost_reverse_1_7 : natural range 0 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 383;
  signal slice1cost_pair_0_4, slice1cost_pair_0_5, slice1cost_pair_0_6, slice1cost_pair_0_7 : natural range 0 to 383;
  signal slice1cost_pair_1_0, slice1cost_pair_1_1, slice1cost_pair_1_2, slice1cost_pair_1_3 : natural range 0 to 382;
  signal slice1cost_pair_1_4, slice1cost_pair_1_5, slice1cost_pair_1_6, slice1cost_pair_1_7 : natural range 0 to 382;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 127;
  signal slice1cost_single_0_3, slice1cost_single_0_4, slice1cost_single_0_5 : natural range 0 to 127;
  signal slice1cost_single_0_6, slice1cost_single_0_7 : natural range 0 to 127;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2, slice1cost_negative_0_3 : boolean;
  signal slice1cost_negative_0_4, slice1cost_negative_0_5, slice1cost_negative_0_6, slice1cost_negative_0_7 : boolean;
  signal slice1cost_tag_first_cost, slice1cost_tag_output_column : boolean;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 893;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 893;
  signal slice1cost_column_0_6, slice1cost_column_0_7 : natural range 0 to 893;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 893;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4, slice1window_partial_0_0_5 : natural range 0 to 893;
  signal slice1window_partial_0_0_6, slice1window_partial_0_0_7 : natural range 0 to 893;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 1786;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4, slice1window_partial_0_1_5 : natural range 0 to 1786;
  signal slice1window_partial_0_1_6, slice1window_partial_0_1_7 : natural range 0 to 1786;
  signal slice1window_partial_0_2_0, slice1window_partial_0_2_1, slice1window_partial_0_2_2 : natural range 0 to 2679;
  signal slice1window_partial_0_2_3, slice1window_partial_0_2_4, slice1window_partial_0_2_5 : natural range 0 to 2679;
  signal slice1window_partial_0_2_6, slice1window_partial_0_2_7 : natural range 0 to 2679;
  signal slice1window_partial_0_3_0, slice1window_partial_0_3_1, slice1window_partial_0_3_2 : natural range 0 to 3572;
  signal slice1window_partial_0_3_3, slice1window_partial_0_3_4, slice1window_partial_0_3_5 : natural range 0 to 3572;
  signal slice1window_partial_0_3_6, slice1window_partial_0_3_7 : natural range 0 to 3572;
  signal slice1window_centre_map_column_0, slice1window_centre_output_column_0 : boolean;
  signal slice1window_centre_output_column_1, slice1window_centre_first_column_0 : boolean;
  signal slice1window_centre_first_column_1, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 4465;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 4465;
  signal slice1window_sum_0_6, slice1window_sum_0_7 : natural range 0 to 4465;
  -- slice1other
  signal slice1other_cost_0_1, slice1other_cost_0_2, slice1other_cost_0_3 : natural range 0 to 4465;
  signal slice1other_cost_0_4, slice1other_cost_0_5, slice1other_cost_0_6 : natural range 0 to 4465;
  signal slice1other_cost_0_7 : natural range 0 to 4465;
  signal slice1other_winner_0_0, slice1other_winner_0_1, slice1other_winner_0_2 : natural range 0 to 15;
  signal slice1other_winner_0_3, slice1other_winner_0_4, slice1other_winner_0_5 : natural range 0 to 15;
  signal slice1other_winner_0_6, slice1other_winner_0_7, slice1other_winner_out_0 : natural range 0 to 15;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 4465;
  signal slice1winner1_best_cost_0_2, slice1winner1_best_cost_0_3 : natural range 0 to 4465;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_2, slice1winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_2, slice1winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_0, slice1winner1_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_2, slice1winner1_best_first_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_0, slice1winner1_best_last_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_2, slice1winner1_best_last_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_but_first_0_1, slice1winner1_best_but_first_0_2 : natural range 0 to 2047;
  signal slice1winner1_best_but_first_0_3, slice1winner1_best_but_last_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_but_last_0_2, slice1winner1_best_but_last_0_3 : natural range 0 to 2047;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 4465;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_below_0_0, slice1winner2_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_first_0_1, slice1winner2_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner2_best_last_0_1, slice1winner2_best_second_0_0 : natural range 0 to 2047;
  signal slice1winner2_best_second_0_1, slice1winner2_best_but_first_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_but_last_0_0, slice1winner2_best_but_last_0_1 : natural range 0 to 2047;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0 : natural range 0 to 4465;
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_below_0_0, slice1winner3_best_above_0_0 : natural range 0 to 2047;
  signal slice1winner3_best_last_0_0, slice1winner3_best_second_0_0 : natural range 0 to 2047;
  signal slice1winner3_best_but_last_0_0 : natural range 0 to 2047;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_second_0_0 : natural range 0 to 4465;
  signal slice1_best_index_0_0 : natural range 0 to 15;
  signal slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_output_column : boolean;
  signal slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  -- texture
  signal texture_taps_search_0_0, texture_taps_search_1_0, texture_taps_search_2_0 : natural range 0 to 31;
  signal texture_taps_search_3_0, texture_taps_search_4_0 : natural range 0 to 31;
  signal texture_passes_0_0, texture_passes_1_0, texture_passes_2_0, texture_passes_3_0, texture_passes_4_0 : boolean;
  -- texturecost
  signal texturecost_difference_0_0, texturecost_difference_1_0, texturecost_difference_2_0 : integer range -127 to 31;
  signal texturecost_difference_3_0 : integer range -127 to 31;
  signal texturecost_difference_4_0 : integer range -63 to 31;
  signal texturecost_reverse_0_0, texturecost_reverse_1_0 : natural range 0 to 255;
  signal texturecost_pair_0_0, texturecost_pair_1_0 : natural range 0 to 382;
  signal texturecost_single_0_0 : natural range 0 to 126;
  signal texturecost_negative_0_0 : boolean;
  signal texturecost_column_0_0 : natural range 0 to 891;
  -- texturewindow
  signal texturewindow_partial_0_0_0 : natural range 0 to 891;
  signal texturewindow_partial_0_1_0 : natural range 0 to 1782;
  signal texturewindow_partial_0_2_0 : natural range 0 to 2673;
  signal texturewindow_partial_0_3_0 : natural range 0 to 3564;
  signal texturewindow_sum_0_0 : natural range 0 to 4455;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 15;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 15;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 15;
  signal refinement_disparity_9_0, refinement_quotient_4_0 : natural range 0 to 15;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0 : boolean;
  signal refinement_passed_8_0, refinement_passed_9_0, refinement_tag_0_valid, refinement_tag_0_map_column : boolean;
  signal refinement_tag_0_output_column, refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line : boolean;
  signal refinement_tag_1_valid, refinement_tag_1_map_column, refinement_tag_1_output_column : boolean;
  signal refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line, refinement_tag_2_valid : boolean;
  signal refinement_tag_2_map_column, refinement_tag_2_output_column, refinement_tag_2_start_of_frame : boolean;
  signal refinement_tag_2_end_of_line, refinement_tag_3_valid, refinement_tag_3_map_column : boolean;
  signal refinement_tag_3_output_column, refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line : boolean;
  signal refinement_tag_4_valid, refinement_tag_4_map_column, refinement_tag_4_output_column : boolean;
  signal refinement_tag_4_start_of_frame, refinement_tag_4_end_of_line, refinement_tag_5_valid : boolean;
  signal refinement_tag_5_map_column, refinement_tag_5_output_column, refinement_tag_5_start_of_frame : boolean;
  signal refinement_tag_5_end_of_line, refinement_tag_6_valid, refinement_tag_6_map_column : boolean;
  signal refinement_tag_6_output_column, refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line : boolean;
  signal refinement_tag_7_valid, refinement_tag_7_map_column, refinement_tag_7_output_column : boolean;
  signal refinement_tag_7_start_of_frame, refinement_tag_7_end_of_line, refinement_tag_8_valid : boolean;
  signal refinement_tag_8_map_column, refinement_tag_8_output_column, refinement_tag_8_start_of_frame : boolean;
  signal refinement_tag_8_end_of_line, refinement_tag_9_valid, refinement_tag_9_map_column : boolean;
  signal refinement_tag_9_output_column, refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line : boolean;
  signal refinement_quotient_1_0, refinement_negative_0_0, refinement_negative_1_0, refinement_negative_2_0 : boolean;
  signal refinement_negative_3_0, refinement_negative_4_0, refinement_negative_5_0, refinement_negative_6_0 : boolean;
  signal refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_cost_0 : natural range 0 to 4465;
  signal refinement_gap_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 2047;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 2047;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 2047;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 2047;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 2047;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 2047;
  signal refinement_scaled_gap_0 : natural range 0 to 204700;
  signal refinement_scaled_cost_0 : natural range 0 to 66975;
  signal refinement_quotient_2_0 : natural range 0 to 3;
  signal refinement_quotient_3_0 : natural range 0 to 7;
  signal refinement_quotient_5_0 : natural range 0 to 31;
  signal refinement_quotient_6_0 : natural range 0 to 63;
  signal refinement_quotient_7_0 : natural range 0 to 127;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- leftright
  signal leftright_other_1_0, leftright_other_2_0, leftright_other_3_0, leftright_other_4_0 : natural range 0 to 15;
  signal leftright_other_5_0, leftright_other_6_0, leftright_other_7_0, leftright_other_8_0 : natural range 0 to 15;
  signal leftright_other_9_0, leftright_other_10_0, leftright_other_11_0, leftright_other_12_0 : natural range 0 to 15;
  signal leftright_ring_read_address, leftright_ring_write_address : natural range 0 to 15;
  signal leftright_asking_disparity_0, leftright_answered_disparity_0 : natural range 0 to 15;
  signal leftright_checked_disparity_0 : natural range 0 to 15;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_tag_valid : boolean;
  signal leftright_answered_tag_map_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 31;
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_found_0 : unsigned(3 downto 0);
  -- map
  signal map_counter_column, map_counter_group, map_read_column, map_ready_column : natural range 0 to 127;
  signal map_write_column, map_at_column : natural range 0 to 127;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0, map_column_2 : natural range 0 to 65535;
  signal map_arrives, map_behind, map_line_ended, map_read_arrives, map_read_behind, map_read_top : boolean;
  signal map_read_output, map_ready_arrives, map_ready_behind, map_ready_top, map_ready_output : boolean;
  signal map_at_arrives, map_at_behind, map_at_top, map_at_output, map_passed_0_0, map_passed_1_0 : boolean;
  signal map_complete, map_first, map_last, map_waiting_passed_0, map_waiting_valid : boolean;
  signal map_waiting_start_of_frame, map_waiting_end_of_line, map_out_passed_0, map_out_valid : boolean;
  signal map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_column_1 : natural range 0 to 8191;
  signal map_low_0_0, map_low_1_0, map_low_2_0, map_largest_low_0 : natural range 0 to 4095;
  signal map_middle_0_0, map_middle_1_0, map_middle_2_0, map_high_0_0, map_high_1_0 : natural range 0 to 32767;
  signal map_high_2_0, map_median_middle_0, map_smallest_high_0, map_out_disparity_0 : natural range 0 to 32767;
  -- other
  signal other_0 : natural range 0 to 8190;
  signal other_1, other_2 : boolean;
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(26 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(right_pixel));
  in_left_pixel <= to_integer(unsigned(left_pixel));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 27);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 96, width => 27)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_search_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 96, width => 28)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_reference_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 6);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 16, width => 6)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_ring_read_address, read_data => delay_delayed_0,
      write_address => delay_ring_write_address, write_data => delay_delayed_0_memory_write_data);

  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 16);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 96, width => 16)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_left_rows_read_words_0,
      write_address => transform_write_column, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 16);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 96, width => 16)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_right_rows_read_words_0,
      write_address => transform_write_column, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 80, width => 26)
    port map (
      clock => clock, read_enable => true,
      read_address => map_counter_column, read_data => map_rows_read_words_0,
      write_address => map_at_column, write_data => map_rows_read_words_0_memory_write_data);

  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_12_0, 4);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 32, width => 4)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_address_0, read_data => leftright_found_0,
      write_address => leftright_position, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_write_data <= to_unsigned((refinement_fraction_0 mod 32), 5) & to_unsigned(as_number(refinement_passed_9_0), 1) & to_unsigned(refinement_disparity_9_0, 8) & to_unsigned(as_number(refinement_tag_9_end_of_line), 1) & to_unsigned(as_number(refinement_tag_9_start_of_frame), 1) & to_unsigned(as_number(refinement_tag_9_output_column), 1) & to_unsigned(as_number(refinement_tag_9_map_column), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 16, width => 18)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_ring_read_address, read_data => leftright_held_0,
      write_address => leftright_ring_write_address, write_data => leftright_held_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3, transform_counter_group_choice : boolean;
    variable transform_counter_next_frame_is_equal, transform_read_column_inside_2_choice : boolean;
    variable transform_left_filter_feature_0_all, transform_left_filter_feature_0_is_less : boolean;
    variable transform_right_filter_feature_0_is_less, transform_left_filter_column_0_0_choice_3 : boolean;
    variable transform_right_filter_column_0_0_choice_3, raster_place_group_is_equal : boolean;
    variable raster_place_group_is_equal_2, raster_place_group_all, raster_place_group_any : boolean;
    variable delay_row_inside_2_is_less, delay_tag_first_cost_is_equal, delay_tag_map_column_is_less : boolean;
    variable slice0cost_reverse_2_0_is_equal, slice0cost_reverse_2_0_choice, slice0cost_reverse_2_0_choice_2 : boolean;
    variable slice0cost_reverse_2_0_is_equal_2, slice0cost_reverse_2_0_all, slice0cost_reverse_2_0_choice_3 : boolean;
    variable slice0cost_reverse_2_0_all_2, slice0cost_reverse_2_3_choice, slice0cost_reverse_2_3_choice_2 : boolean;
    variable slice0cost_reverse_2_3_choice_3, slice0cost_reverse_2_4_choice, slice0cost_reverse_2_4_choice_2 : boolean;
    variable slice0other_cost_0_0_all, slice0other_cost_0_0_is_not_less, slice0other_cost_0_0_all_2 : boolean;
    variable slice0other_cost_0_1_is_not_less, slice0other_cost_0_2_is_not_less : boolean;
    variable slice0other_cost_0_3_is_not_less, slice0other_cost_0_4_is_not_less : boolean;
    variable slice0other_cost_0_5_is_not_less, slice0winner1_best_cost_0_0_is_less : boolean;
    variable slice0winner1_best_cost_0_1_is_less, slice0winner1_best_cost_0_2_is_less : boolean;
    variable slice0winner1_best_cost_0_3_is_less, slice0winner2_best_cost_0_0_is_less : boolean;
    variable slice0winner2_best_cost_0_1_is_less, slice0winner2_best_below_0_0_is_equal : boolean;
    variable slice0winner2_best_below_0_1_is_equal, slice0winner3_best_cost_0_0_is_less : boolean;
    variable slice0winner3_best_below_0_0_is_equal, slice0winner3_best_above_0_0_is_equal : boolean;
    variable slice1other_cost_0_1_any, slice1other_cost_0_1_is_not_less, slice1other_cost_0_2_is_not_less : boolean;
    variable slice1other_cost_0_3_is_not_less, slice1other_cost_0_4_is_not_less : boolean;
    variable slice1other_cost_0_5_is_not_less, slice1other_cost_0_6_is_not_less : boolean;
    variable slice1other_cost_0_7_is_not_less, slice1winner1_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_1_is_less, slice1winner1_best_cost_0_2_is_less : boolean;
    variable slice1winner1_best_cost_0_3_is_less, slice1winner2_best_cost_0_0_is_less : boolean;
    variable slice1winner2_best_cost_0_1_is_less, slice1winner2_best_below_0_0_is_equal : boolean;
    variable slice1winner2_best_below_0_1_is_equal, slice1winner3_best_cost_0_0_is_less : boolean;
    variable slice1winner3_best_below_0_0_is_equal, slice1winner3_best_above_0_0_is_equal : boolean;
    variable slice1_best_cost_0_0_is_less, slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal : boolean;
    variable refinement_remainder_0_0_is_less, refinement_remainder_1_0_is_not_less : boolean;
    variable refinement_remainder_2_0_is_not_less, refinement_remainder_3_0_is_not_less : boolean;
    variable refinement_remainder_4_0_is_not_less, refinement_remainder_5_0_is_not_less : boolean;
    variable refinement_remainder_6_0_is_not_less, refinement_remainder_7_0_is_not_less : boolean;
    variable leftright_holds_winners_all, map_line_ended_choice, map_passed_1_0_all, map_passed_1_0_any : boolean;
    variable map_complete_is_equal, map_median_middle_0_is_less, map_out_disparity_0_is_less : boolean;
    variable map_low_0_0_is_less, map_low_1_0_all, map_middle_0_0_is_less : boolean;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 127;
    variable raster_place_group_choice, raster_place_group_choice_2, map_counter_group_choice : natural range 0 to 127;
    variable map_counter_group_choice_2 : natural range 0 to 127;
    variable transform_left_filter_feature_0_difference : integer range -1020 to 1020;
    variable transform_left_filter_feature_0_choice : integer range -1020 to 1020;
    variable transform_right_filter_feature_0_difference : integer range -1020 to 1020;
    variable transform_right_filter_feature_0_choice : integer range -1020 to 1020;
    variable transform_left_filter_feature_0_choice_2, transform_left_filter_feature_0_choice_3 : natural range 0 to 63;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 63;
    variable transform_right_filter_feature_0_choice_3 : natural range 0 to 63;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice_2, slice0cost_pair_0_0_choice : natural range 0 to 255;
    variable slice0cost_pair_0_1_choice, slice0cost_pair_0_2_choice : natural range 0 to 255;
    variable slice0cost_pair_0_3_choice, slice0cost_pair_0_4_choice : natural range 0 to 255;
    variable slice0cost_pair_0_5_choice, slice0cost_pair_0_6_choice : natural range 0 to 255;
    variable slice0cost_pair_0_7_choice, slice0cost_pair_1_0_choice : natural range 0 to 255;
    variable slice0cost_pair_1_1_choice, slice0cost_pair_1_2_choice : natural range 0 to 255;
    variable slice0cost_pair_1_3_choice, slice0cost_pair_1_4_choice : natural range 0 to 255;
    variable slice0cost_pair_1_5_choice, slice0cost_pair_1_6_choice : natural range 0 to 255;
    variable slice0cost_pair_1_7_choice, slice1cost_pair_0_0_choice : natural range 0 to 255;
    variable slice1cost_pair_0_1_choice, slice1cost_pair_0_2_choice : natural range 0 to 255;
    variable slice1cost_pair_0_3_choice, slice1cost_pair_0_4_choice : natural range 0 to 255;
    variable slice1cost_pair_0_5_choice, slice1cost_pair_0_6_choice : natural range 0 to 255;
    variable slice1cost_pair_0_7_choice, slice1cost_pair_1_0_choice : natural range 0 to 255;
    variable slice1cost_pair_1_1_choice, slice1cost_pair_1_2_choice : natural range 0 to 255;
    variable slice1cost_pair_1_3_choice, slice1cost_pair_1_4_choice : natural range 0 to 255;
    variable slice1cost_pair_1_5_choice, slice1cost_pair_1_6_choice : natural range 0 to 255;
    variable slice1cost_pair_1_7_choice, texturecost_pair_0_0_choice : natural range 0 to 255;
    variable texturecost_pair_1_0_choice, refinement_fraction_0_choice : natural range 0 to 255;
    variable slice0other_cost_0_0_choice, slice0other_cost_0_0_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_0_choice_3, slice0other_cost_0_0_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_0_choice_5, slice0other_cost_0_0_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_1_choice, slice0other_cost_0_1_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_1_choice_3, slice0other_cost_0_1_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_1_choice_5, slice0other_cost_0_1_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_2_choice, slice0other_cost_0_2_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_2_choice_3, slice0other_cost_0_2_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_2_choice_5, slice0other_cost_0_2_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_3_choice, slice0other_cost_0_3_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_3_choice_3, slice0other_cost_0_3_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_3_choice_5, slice0other_cost_0_3_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_4_choice, slice0other_cost_0_4_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_4_choice_3, slice0other_cost_0_4_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_4_choice_5, slice0other_cost_0_4_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_5_choice, slice0other_cost_0_5_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_5_choice_3, slice0other_cost_0_5_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_5_choice_5, slice0other_cost_0_5_choice_6 : natural range 0 to 4465;
    variable slice0other_cost_0_6_choice, slice0other_cost_0_6_choice_2 : natural range 0 to 4465;
    variable slice0other_cost_0_6_choice_3, slice0other_cost_0_6_choice_4 : natural range 0 to 4465;
    variable slice0other_cost_0_7_choice, slice0other_cost_0_7_choice_2 : natural range 0 to 4465;
    variable slice0winner2_best_second_0_0_choice, slice0winner2_best_second_0_0_choice_2 : natural range 0 to 4465;
    variable slice0winner2_best_second_0_0_choice_3, slice0winner2_best_second_0_1_choice : natural range 0 to 4465;
    variable slice0winner2_best_second_0_1_choice_2, slice0winner2_best_second_0_1_choice_3 : natural range 0 to 4465;
    variable slice0winner3_best_second_0_0_choice, slice0winner3_best_second_0_0_choice_4 : natural range 0 to 4465;
    variable slice1other_cost_0_1_choice, slice1other_cost_0_1_choice_2 : natural range 0 to 4465;
    variable slice1other_cost_0_1_choice_3, slice1other_cost_0_1_choice_4 : natural range 0 to 4465;
    variable slice1other_cost_0_1_choice_5, slice1other_cost_0_2_choice : natural range 0 to 4465;
    variable slice1other_cost_0_2_choice_2, slice1other_cost_0_2_choice_3 : natural range 0 to 4465;
    variable slice1other_cost_0_2_choice_4, slice1other_cost_0_2_choice_5 : natural range 0 to 4465;
    variable slice1other_cost_0_3_choice, slice1other_cost_0_3_choice_2 : natural range 0 to 4465;
    variable slice1other_cost_0_3_choice_3, slice1other_cost_0_3_choice_4 : natural range 0 to 4465;
    variable slice1other_cost_0_3_choice_5, slice1other_cost_0_4_choice : natural range 0 to 4465;
    variable slice1other_cost_0_4_choice_2, slice1other_cost_0_4_choice_3 : natural range 0 to 4465;
    variable slice1other_cost_0_4_choice_4, slice1other_cost_0_4_choice_5 : natural range 0 to 4465;
    variable slice1other_cost_0_5_choice, slice1other_cost_0_5_choice_2 : natural range 0 to 4465;
    variable slice1other_cost_0_5_choice_3, slice1other_cost_0_5_choice_4 : natural range 0 to 4465;
    variable slice1other_cost_0_5_choice_5, slice1other_cost_0_6_choice : natural range 0 to 4465;
    variable slice1other_cost_0_6_choice_2, slice1other_cost_0_6_choice_3 : natural range 0 to 4465;
    variable slice1other_cost_0_6_choice_4, slice1other_cost_0_6_choice_5 : natural range 0 to 4465;
    variable slice1other_cost_0_7_choice, slice1other_cost_0_7_choice_2 : natural range 0 to 4465;
    variable slice1winner2_best_second_0_0_choice, slice1winner2_best_second_0_0_choice_2 : natural range 0 to 4465;
    variable slice1winner2_best_second_0_0_choice_3, slice1winner2_best_second_0_1_choice : natural range 0 to 4465;
    variable slice1winner2_best_second_0_1_choice_2, slice1winner2_best_second_0_1_choice_3 : natural range 0 to 4465;
    variable slice1winner3_best_second_0_0_choice, slice1winner3_best_second_0_0_choice_4 : natural range 0 to 4465;
    variable slice1_best_second_0_0_choice, slice1_best_second_0_0_choice_2 : natural range 0 to 4465;
    variable slice1_best_second_0_0_choice_3, slice1_best_second_0_0_choice_4 : natural range 0 to 4465;
    variable slice0other_winner_0_0_choice, slice0other_winner_0_0_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_0_choice_3, slice0other_winner_0_0_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_0_choice_5, slice0other_winner_0_0_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_1_choice, slice0other_winner_0_1_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_1_choice_3, slice0other_winner_0_1_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_1_choice_5, slice0other_winner_0_1_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_2_choice, slice0other_winner_0_2_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_2_choice_3, slice0other_winner_0_2_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_2_choice_5, slice0other_winner_0_2_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_3_choice, slice0other_winner_0_3_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_3_choice_3, slice0other_winner_0_3_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_3_choice_5, slice0other_winner_0_3_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_4_choice, slice0other_winner_0_4_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_4_choice_3, slice0other_winner_0_4_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_4_choice_5, slice0other_winner_0_4_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_5_choice, slice0other_winner_0_5_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_5_choice_3, slice0other_winner_0_5_choice_4 : natural range 0 to 15;
    variable slice0other_winner_0_5_choice_5, slice0other_winner_0_5_choice_6 : natural range 0 to 15;
    variable slice0other_winner_0_6_choice, slice0other_winner_0_6_choice_2 : natural range 0 to 15;
    variable slice0other_winner_0_7_choice, slice0other_winner_0_7_choice_2 : natural range 0 to 15;
    variable slice1other_winner_0_0_choice, slice1other_winner_0_0_choice_2 : natural range 0 to 15;
    variable slice1other_winner_0_0_choice_3, slice1other_winner_0_0_choice_4 : natural range 0 to 15;
    variable slice1other_winner_0_0_choice_5, slice1other_winner_0_1_choice : natural range 0 to 15;
    variable slice1other_winner_0_1_choice_2, slice1other_winner_0_1_choice_3 : natural range 0 to 15;
    variable slice1other_winner_0_1_choice_4, slice1other_winner_0_1_choice_5 : natural range 0 to 15;
    variable slice1other_winner_0_2_choice, slice1other_winner_0_2_choice_2 : natural range 0 to 15;
    variable slice1other_winner_0_2_choice_3, slice1other_winner_0_2_choice_4 : natural range 0 to 15;
    variable slice1other_winner_0_2_choice_5, slice1other_winner_0_3_choice : natural range 0 to 15;
    variable slice1other_winner_0_3_choice_2, slice1other_winner_0_3_choice_3 : natural range 0 to 15;
    variable slice1other_winner_0_3_choice_4, slice1other_winner_0_3_choice_5 : natural range 0 to 15;
    variable slice1other_winner_0_4_choice, slice1other_winner_0_4_choice_2 : natural range 0 to 15;
    variable slice1other_winner_0_4_choice_3, slice1other_winner_0_4_choice_4 : natural range 0 to 15;
    variable slice1other_winner_0_4_choice_5, slice1other_winner_0_5_choice : natural range 0 to 15;
    variable slice1other_winner_0_5_choice_2, slice1other_winner_0_5_choice_3 : natural range 0 to 15;
    variable slice1other_winner_0_5_choice_4, slice1other_winner_0_5_choice_5 : natural range 0 to 15;
    variable slice1other_winner_0_6_choice, slice1other_winner_0_6_choice_2 : natural range 0 to 15;
    variable slice1other_winner_0_6_choice_3, slice1other_winner_0_6_choice_4 : natural range 0 to 15;
    variable slice1other_winner_0_6_choice_5, slice1other_winner_0_7_choice : natural range 0 to 15;
    variable slice1other_winner_0_7_choice_2, leftright_address_0_value : natural range 0 to 15;
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice0winner2_best_above_0_0_choice, slice0winner2_best_above_0_1_choice : natural range 0 to 2047;
    variable slice0winner2_best_second_0_0_choice_4, slice0winner2_best_second_0_0_choice_5 : natural range 0 to 2047;
    variable slice0winner2_best_second_0_0_choice_6, slice0winner2_best_second_0_1_choice_4 : natural range 0 to 2047;
    variable slice0winner2_best_second_0_1_choice_5, slice0winner2_best_second_0_1_choice_6 : natural range 0 to 2047;
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice : natural range 0 to 2047;
    variable slice0winner3_best_second_0_0_choice_2, slice0winner3_best_second_0_0_choice_3 : natural range 0 to 2047;
    variable slice0winner3_best_second_0_0_choice_5, slice0winner3_best_second_0_0_choice_6 : natural range 0 to 2047;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice1winner2_best_above_0_0_choice, slice1winner2_best_above_0_1_choice : natural range 0 to 2047;
    variable slice1winner2_best_second_0_0_choice_4, slice1winner2_best_second_0_0_choice_5 : natural range 0 to 2047;
    variable slice1winner2_best_second_0_0_choice_6, slice1winner2_best_second_0_1_choice_4 : natural range 0 to 2047;
    variable slice1winner2_best_second_0_1_choice_5, slice1winner2_best_second_0_1_choice_6 : natural range 0 to 2047;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1winner3_best_second_0_0_choice_2, slice1winner3_best_second_0_0_choice_3 : natural range 0 to 2047;
    variable slice1winner3_best_second_0_0_choice_5, slice1winner3_best_second_0_0_choice_6 : natural range 0 to 2047;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_0_0_choice, refinement_remainder_0_0_value : natural range 0 to 2047;
    variable refinement_remainder_0_0_choice_2, refinement_remainder_0_0_value_2 : natural range 0 to 2047;
    variable refinement_remainder_0_0_choice_3, refinement_remainder_0_0_choice_4 : natural range 0 to 2047;
    variable refinement_remainder_1_0_choice, refinement_remainder_2_0_choice : natural range 0 to 2047;
    variable refinement_remainder_3_0_choice, refinement_remainder_4_0_choice : natural range 0 to 2047;
    variable refinement_remainder_5_0_choice, refinement_remainder_6_0_choice : natural range 0 to 2047;
    variable refinement_remainder_7_0_choice : natural range 0 to 2047;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -14 to 16;
    variable map_largest_low_0_choice, map_low_0_0_choice_2, map_low_0_0_choice_3 : natural range 0 to 4095;
    variable map_low_0_0_choice_4, map_low_0_0_choice_5, map_low_0_0_choice_6 : natural range 0 to 4095;
    variable map_middle_0_0_choice : natural range 0 to 4095;
    variable map_median_middle_0_choice, map_median_middle_0_choice_2 : natural range 0 to 32767;
    variable map_median_middle_0_choice_3, map_smallest_high_0_choice : natural range 0 to 32767;
    variable map_out_disparity_0_choice, map_out_disparity_0_choice_2 : natural range 0 to 32767;
    variable map_out_disparity_0_choice_3, map_low_0_0_choice, map_middle_0_0_choice_2 : natural range 0 to 32767;
    variable map_middle_0_0_choice_3, map_middle_0_0_choice_4, map_high_0_0_choice : natural range 0 to 32767;
    variable map_high_0_0_choice_2 : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 95;
      transform_counter_group_is_equal_2 := transform_counter_group = 63;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      transform_counter_group_is_equal_3 := (transform_counter_group / 2) = 32;
      transform_counter_group_choice := in_valid and (not ((transform_counter_group mod 2) = 1)) when
        transform_counter_group_is_equal_3 else in_valid;
      transform_counter_group_choice_2 := 1 when slice0cost_reverse_2_4 and (transform_counter_group = 64) else
        (transform_counter_group + 1) mod 128;
      transform_counter_group_choice_3 := transform_counter_group_choice_2 when transform_counter_group_is_equal and
        transform_counter_group_choice else transform_counter_group;
      transform_counter_next_frame_is_equal := map_counter_group = 64;
      transform_read_column_inside_2_choice := (transform_counter_column / 32) = 0 when transform_counter_column = 0
        else ((transform_counter_column / 64) = 1) or (((transform_counter_column / 32) mod 2) = 1);
      transform_left_filter_feature_0_all := transform_filtering_column_inside_2 and
        transform_filtering_column_inside_0;
      transform_left_filter_feature_0_difference := transform_left_filter_column_0_0 - transform_left_filter_column_2_0;
      transform_left_filter_feature_0_is_less := transform_left_filter_feature_0_difference < (-31);
      transform_left_filter_feature_0_choice := -31 when transform_left_filter_feature_0_is_less else
        transform_left_filter_feature_0_difference;
      transform_left_filter_feature_0_choice_2 := 33 when transform_left_filter_feature_0_is_less else
        transform_left_filter_feature_0_difference mod 64;
      transform_left_filter_feature_0_choice_3 := transform_left_filter_feature_0_choice_2 when
        transform_left_filter_feature_0_choice < 31 else 31;
      transform_right_filter_feature_0_difference := transform_right_filter_column_0_0 -
        transform_right_filter_column_2_0;
      transform_right_filter_feature_0_is_less := transform_right_filter_feature_0_difference < (-31);
      transform_right_filter_feature_0_choice := -31 when transform_right_filter_feature_0_is_less else
        transform_right_filter_feature_0_difference;
      transform_right_filter_feature_0_choice_2 := 33 when transform_right_filter_feature_0_is_less else
        transform_right_filter_feature_0_difference mod 64;
      transform_right_filter_feature_0_choice_3 := transform_right_filter_feature_0_choice_2 when
        transform_right_filter_feature_0_choice < 31 else 31;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_counter_group <= as_number(transform_counter_group_all) * 64 when in_valid and in_start_of_frame else
        transform_counter_group_choice_3;
      transform_counter_next_frame <= transform_counter_next_frame_is_equal;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 64;
      transform_read_row_inside_2 <= not ((transform_counter_group / 64) = 1);
      transform_read_column_inside_0 <= ((transform_counter_column / 8) /= 0) or (((transform_counter_column / 4) mod
        2) = 1) or (((transform_counter_column / 2) mod 2) = 1) or ((transform_counter_column mod 2) = 1);
      transform_read_column_inside_2 <= transform_read_column_inside_2_choice when ((transform_counter_column / 2) mod
        16) = 0 else transform_counter_column /= 0;
      transform_read_start_of_frame <= (transform_counter_column = 1) and (transform_counter_group = 1);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 256;
      transform_left_column_1 <= transform_left_rows_ready_words_0 / 256;
      transform_left_column_2 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 256;
      transform_right_column_1 <= transform_right_rows_ready_words_0 / 256;
      transform_right_column_2 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_3 + 31) mod 64 when
        transform_left_filter_feature_0_all else 31;
      transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_3 + 31) mod 64 when
        transform_left_filter_feature_0_all else 31;
      transform_filtering_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_valid <= transform_columns_valid;
      transform_filtered_start_of_frame <= transform_filtering_start_of_frame;
      transform_filtered_valid <= transform_filtering_valid;
      if in_valid then
        transform_counter_column <= 0 when transform_counter_group_is_equal or in_start_of_frame else
          (transform_counter_column + 1) mod 128;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_newest_0 * 256) +
          (transform_left_rows_ready_words_0 / 256);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_newest_0 * 256) +
          (transform_right_rows_ready_words_0 / 256);
        transform_write_column <= transform_ready_column;
      end if;
      transform_left_filter_column_0_0_choice := transform_left_column_0 when transform_columns_row_inside_0 else
        transform_left_column_2;
      transform_left_filter_column_0_0_choice_2 := transform_left_column_2 when transform_columns_row_inside_2 else
        transform_left_column_0;
      transform_left_filter_column_0_0_choice_3 := (transform_left_column_2 mod 2) = 1 when
        transform_columns_row_inside_2 else (transform_left_column_0 mod 2) = 1;
      transform_right_filter_column_0_0_choice := transform_right_column_0 when transform_columns_row_inside_0 else
        transform_right_column_2;
      transform_right_filter_column_0_0_choice_2 := transform_right_column_2 when transform_columns_row_inside_2 else
        transform_right_column_0;
      transform_right_filter_column_0_0_choice_3 := (transform_right_column_2 mod 2) = 1 when
        transform_columns_row_inside_2 else (transform_right_column_0 mod 2) = 1;
      if transform_columns_valid then
        transform_left_filter_column_0_0 <= transform_left_filter_column_0_0_choice +
          (((transform_left_filter_column_0_0_choice_2 / 2) + transform_left_column_1) * 2) +
          as_number(transform_left_filter_column_0_0_choice_3);
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_right_filter_column_0_0 <= transform_right_filter_column_0_0_choice +
          (((transform_right_filter_column_0_0_choice_2 / 2) + transform_right_column_1) * 2) +
          as_number(transform_right_filter_column_0_0_choice_3);
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 95;
      raster_place_group_is_equal_2 := raster_place_group = 63;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      raster_place_group_any := ((raster_place_group / 4) /= 16) or (not (((raster_place_group / 2) mod 2) = 1)) or
        ((raster_place_group mod 2) = 1);
      raster_place_group_choice := 2 when slice0cost_reverse_2_3 and (raster_place_group = 65) else (raster_place_group
        + 1) mod 128;
      raster_place_group_choice_2 := raster_place_group_choice when raster_place_group_is_equal and
        raster_place_group_any and transform_filtered_valid else raster_place_group;
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_start_of_frame <= transform_counter_next_frame;
      raster_features_valid <= transform_filtered_valid;
      raster_place_group <= as_number(raster_place_group_all) * 64 when transform_filtered_valid and
        transform_filtered_start_of_frame else raster_place_group_choice_2;
      raster_place_next_frame <= raster_features_start_of_frame;
      if transform_filtered_valid then
        raster_place_column <= 0 when raster_place_group_is_equal or transform_filtered_start_of_frame else
          (raster_place_column + 1) mod 128;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_read_address <= 0 when delay_ring_read_address = 15 else (delay_ring_read_address + 1) mod 16;
        delay_ring_write_address <= delay_ring_read_address;
      end if;
      delay_row_inside_2_is_less := (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2))
        < 64;
      delay_tag_first_cost_is_equal := raster_place_column = 15;
      delay_tag_map_column_is_less := ((raster_place_column + 65521) mod 65536) < 80;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) < 64;
      delay_row_inside_1 <= ((raster_place_group + 65533) mod 65536) < 64;
      delay_row_inside_2 <= delay_row_inside_2_is_less;
      delay_row_inside_3 <= ((raster_place_group + 65535) mod 65536) < 64;
      delay_row_inside_4 <= not ((raster_place_group / 64) = 1);
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= ((raster_place_column mod 16) /= 15) and ((raster_place_column / 16) = 0);
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_row_inside_2_is_less and delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 2);
      delay_tag_end_of_line <= raster_place_column = 94;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_inside_3 <= delay_row_inside_3;
      rows_read_inside_4 <= delay_row_inside_4;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_inside_4 <= rows_read_inside_4;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_first_cost <= rows_read_tag_first_cost;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_search_0 <= rows_search_rows_ready_words_0 mod 128 when rows_ready_inside_0 else 0;
      rows_search_1 <= (rows_search_rows_ready_words_0 / 128) mod 128 when rows_ready_inside_1 else 0;
      rows_search_2 <= (rows_search_rows_ready_words_0 / 16384) mod 128 when rows_ready_inside_2 else 0;
      rows_search_3 <= rows_search_rows_ready_words_0 / 2097152 when rows_ready_inside_3 else 0;
      rows_search_4 <= rows_search_rows_ready_newest_0 when rows_ready_inside_4 else 0;
      rows_reference_0 <= rows_reference_rows_ready_words_0 mod 128 when rows_ready_inside_0 else 0;
      rows_reference_1 <= (rows_reference_rows_ready_words_0 / 128) mod 128 when rows_ready_inside_1 else 0;
      rows_reference_2 <= (rows_reference_rows_ready_words_0 / 16384) mod 128 when rows_ready_inside_2 else 0;
      rows_reference_3 <= rows_reference_rows_ready_words_0 / 2097152 when rows_ready_inside_3 else 0;
      rows_reference_4 <= rows_reference_rows_ready_newest_0 when rows_ready_inside_4 else 0;
      rows_inside_0 <= rows_ready_inside_0;
      rows_inside_1 <= rows_ready_inside_1;
      rows_inside_2 <= rows_ready_inside_2;
      rows_inside_3 <= rows_ready_inside_3;
      rows_inside_4 <= rows_ready_inside_4;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 128) + (rows_search_rows_ready_newest_0 *
          2097152);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 128) +
          (rows_reference_rows_ready_newest_0 * 2097152);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= slice0shift_search_0_3;
        slice0shift_search_0_3 <= slice0shift_search_0_4;
        slice0shift_search_0_4 <= slice0shift_search_0_5;
        slice0shift_search_0_5 <= slice0shift_search_0_6;
        slice0shift_search_0_6 <= slice0shift_search_0_7;
        slice0shift_search_0_7 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= slice0shift_search_1_3;
        slice0shift_search_1_3 <= slice0shift_search_1_4;
        slice0shift_search_1_4 <= slice0shift_search_1_5;
        slice0shift_search_1_5 <= slice0shift_search_1_6;
        slice0shift_search_1_6 <= slice0shift_search_1_7;
        slice0shift_search_1_7 <= rows_search_1;
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= slice0shift_search_2_3;
        slice0shift_search_2_3 <= slice0shift_search_2_4;
        slice0shift_search_2_4 <= slice0shift_search_2_5;
        slice0shift_search_2_5 <= slice0shift_search_2_6;
        slice0shift_search_2_6 <= slice0shift_search_2_7;
        slice0shift_search_2_7 <= rows_search_2;
        slice0shift_search_3_0 <= slice0shift_search_3_1;
        slice0shift_search_3_1 <= slice0shift_search_3_2;
        slice0shift_search_3_2 <= slice0shift_search_3_3;
        slice0shift_search_3_3 <= slice0shift_search_3_4;
        slice0shift_search_3_4 <= slice0shift_search_3_5;
        slice0shift_search_3_5 <= slice0shift_search_3_6;
        slice0shift_search_3_6 <= slice0shift_search_3_7;
        slice0shift_search_3_7 <= rows_search_3;
        slice0shift_search_4_0 <= slice0shift_search_4_1;
        slice0shift_search_4_1 <= slice0shift_search_4_2;
        slice0shift_search_4_2 <= slice0shift_search_4_3;
        slice0shift_search_4_3 <= slice0shift_search_4_4;
        slice0shift_search_4_4 <= slice0shift_search_4_5;
        slice0shift_search_4_5 <= slice0shift_search_4_6;
        slice0shift_search_4_6 <= slice0shift_search_4_7;
        slice0shift_search_4_7 <= rows_search_4;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_reference_4 <= rows_reference_4;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
      slice0shift_search_out_4 <= slice0shift_search_4_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_reverse_2_0_is_equal := map_counter_column = 79;
      slice0cost_reverse_2_0_choice := slice0cost_reverse_2_0 and ((map_counter_group mod 2) = 1) when
        (map_counter_group / 2) = 32 else slice0cost_reverse_2_0;
      slice0cost_reverse_2_0_choice_2 := slice0cost_reverse_2_0_choice when slice0cost_reverse_2_0_is_equal else
        slice0cost_reverse_2_0;
      slice0cost_reverse_2_0_is_equal_2 := map_counter_group = 63;
      slice0cost_reverse_2_0_all := slice0cost_reverse_2_0_is_equal and slice0cost_reverse_2_0_is_equal_2;
      slice0cost_reverse_2_0_choice_3 := slice0cost_reverse_2_0_all or (not leftright_checked_tag_start_of_frame) when
        slice0cost_reverse_2_0_choice_2 else slice0cost_reverse_2_0_is_equal and slice0cost_reverse_2_0_is_equal_2 and
        leftright_checked_tag_start_of_frame;
      slice0cost_reverse_2_0_all_2 := leftright_checked_tag_valid and leftright_checked_tag_map_column;
      slice0cost_reverse_2_3_choice := (raster_place_group /= 65) and slice0cost_reverse_2_3 when
        raster_place_group_is_equal and raster_place_group_any else slice0cost_reverse_2_3;
      slice0cost_reverse_2_3_choice_2 := transform_filtered_valid when raster_place_group_all else
        transform_filtered_valid and (not transform_filtered_start_of_frame);
      slice0cost_reverse_2_3_choice_3 := slice0cost_reverse_2_3_choice_2 when slice0cost_reverse_2_3_choice else
        raster_place_group_is_equal and raster_place_group_is_equal_2 and transform_filtered_valid and
        transform_filtered_start_of_frame;
      slice0cost_pair_0_0_choice := slice0cost_reverse_0_0 when slice0cost_difference_2_0 < 0 else
        positive_part(slice0cost_difference_2_0);
      slice0cost_pair_0_1_choice := slice0cost_reverse_0_1 when slice0cost_difference_2_1 < 0 else
        positive_part(slice0cost_difference_2_1);
      slice0cost_pair_0_2_choice := slice0cost_reverse_0_2 when slice0cost_difference_2_2 < 0 else
        positive_part(slice0cost_difference_2_2);
      slice0cost_pair_0_3_choice := slice0cost_reverse_0_3 when slice0cost_difference_2_3 < 0 else
        positive_part(slice0cost_difference_2_3);
      slice0cost_pair_0_4_choice := slice0cost_reverse_0_4 when slice0cost_difference_2_4 < 0 else
        positive_part(slice0cost_difference_2_4);
      slice0cost_pair_0_5_choice := slice0cost_reverse_0_5 when slice0cost_difference_2_5 < 0 else
        positive_part(slice0cost_difference_2_5);
      slice0cost_pair_0_6_choice := slice0cost_reverse_0_6 when slice0cost_difference_2_6 < 0 else
        positive_part(slice0cost_difference_2_6);
      slice0cost_pair_0_7_choice := slice0cost_reverse_0_7 when slice0cost_difference_2_7 < 0 else
        positive_part(slice0cost_difference_2_7);
      slice0cost_pair_1_0_choice := slice0cost_reverse_1_0 when slice0cost_difference_4_0 < 0 else
        positive_part(slice0cost_difference_4_0);
      slice0cost_pair_1_1_choice := slice0cost_reverse_1_1 when slice0cost_difference_4_1 < 0 else
        positive_part(slice0cost_difference_4_1);
      slice0cost_pair_1_2_choice := slice0cost_reverse_1_2 when slice0cost_difference_4_2 < 0 else
        positive_part(slice0cost_difference_4_2);
      slice0cost_pair_1_3_choice := slice0cost_reverse_1_3 when slice0cost_difference_4_3 < 0 else
        positive_part(slice0cost_difference_4_3);
      slice0cost_pair_1_4_choice := slice0cost_reverse_1_4 when slice0cost_difference_4_4 < 0 else
        positive_part(slice0cost_difference_4_4);
      slice0cost_pair_1_5_choice := slice0cost_reverse_1_5 when slice0cost_difference_4_5 < 0 else
        positive_part(slice0cost_difference_4_5);
      slice0cost_pair_1_6_choice := slice0cost_reverse_1_6 when slice0cost_difference_4_6 < 0 else
        positive_part(slice0cost_difference_4_6);
      slice0cost_pair_1_7_choice := slice0cost_reverse_1_7 when slice0cost_difference_4_7 < 0 else
        positive_part(slice0cost_difference_4_7);
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_difference_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_difference_0_5 <= slice0shift_search_0_5 - slice0shift_reference_0;
      slice0cost_difference_0_6 <= slice0shift_search_0_6 - slice0shift_reference_0;
      slice0cost_difference_0_7 <= slice0shift_search_0_7 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_difference_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_difference_1_5 <= slice0shift_search_1_5 - slice0shift_reference_1;
      slice0cost_difference_1_6 <= slice0shift_search_1_6 - slice0shift_reference_1;
      slice0cost_difference_1_7 <= slice0shift_search_1_7 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_difference_2_3 <= slice0shift_search_2_3 - slice0shift_reference_2;
      slice0cost_difference_2_4 <= slice0shift_search_2_4 - slice0shift_reference_2;
      slice0cost_difference_2_5 <= slice0shift_search_2_5 - slice0shift_reference_2;
      slice0cost_difference_2_6 <= slice0shift_search_2_6 - slice0shift_reference_2;
      slice0cost_difference_2_7 <= slice0shift_search_2_7 - slice0shift_reference_2;
      slice0cost_difference_3_0 <= slice0shift_search_3_0 - slice0shift_reference_3;
      slice0cost_difference_3_1 <= slice0shift_search_3_1 - slice0shift_reference_3;
      slice0cost_difference_3_2 <= slice0shift_search_3_2 - slice0shift_reference_3;
      slice0cost_difference_3_3 <= slice0shift_search_3_3 - slice0shift_reference_3;
      slice0cost_difference_3_4 <= slice0shift_search_3_4 - slice0shift_reference_3;
      slice0cost_difference_3_5 <= slice0shift_search_3_5 - slice0shift_reference_3;
      slice0cost_difference_3_6 <= slice0shift_search_3_6 - slice0shift_reference_3;
      slice0cost_difference_3_7 <= slice0shift_search_3_7 - slice0shift_reference_3;
      slice0cost_difference_4_0 <= slice0shift_search_4_0 - slice0shift_reference_4;
      slice0cost_difference_4_1 <= slice0shift_search_4_1 - slice0shift_reference_4;
      slice0cost_difference_4_2 <= slice0shift_search_4_2 - slice0shift_reference_4;
      slice0cost_difference_4_3 <= slice0shift_search_4_3 - slice0shift_reference_4;
      slice0cost_difference_4_4 <= slice0shift_search_4_4 - slice0shift_reference_4;
      slice0cost_difference_4_5 <= slice0shift_search_4_5 - slice0shift_reference_4;
      slice0cost_difference_4_6 <= slice0shift_search_4_6 - slice0shift_reference_4;
      slice0cost_difference_4_7 <= slice0shift_search_4_7 - slice0shift_reference_4;
      slice0cost_reverse_0_0 <= (slice0shift_reference_2 - slice0shift_search_2_0) mod 256;
      slice0cost_reverse_0_1 <= (slice0shift_reference_2 - slice0shift_search_2_1) mod 256;
      slice0cost_reverse_0_2 <= (slice0shift_reference_2 - slice0shift_search_2_2) mod 256;
      slice0cost_reverse_0_3 <= (slice0shift_reference_2 - slice0shift_search_2_3) mod 256;
      slice0cost_reverse_0_4 <= (slice0shift_reference_2 - slice0shift_search_2_4) mod 256;
      slice0cost_reverse_0_5 <= (slice0shift_reference_2 - slice0shift_search_2_5) mod 256;
      slice0cost_reverse_0_6 <= (slice0shift_reference_2 - slice0shift_search_2_6) mod 256;
      slice0cost_reverse_0_7 <= (slice0shift_reference_2 - slice0shift_search_2_7) mod 256;
      slice0cost_reverse_1_0 <= (slice0shift_reference_4 - slice0shift_search_4_0) mod 256;
      slice0cost_reverse_1_1 <= (slice0shift_reference_4 - slice0shift_search_4_1) mod 256;
      slice0cost_reverse_1_2 <= (slice0shift_reference_4 - slice0shift_search_4_2) mod 256;
      slice0cost_reverse_1_3 <= (slice0shift_reference_4 - slice0shift_search_4_3) mod 256;
      slice0cost_reverse_1_4 <= (slice0shift_reference_4 - slice0shift_search_4_4) mod 256;
      slice0cost_reverse_1_5 <= (slice0shift_reference_4 - slice0shift_search_4_5) mod 256;
      slice0cost_reverse_1_6 <= (slice0shift_reference_4 - slice0shift_search_4_6) mod 256;
      slice0cost_reverse_1_7 <= (slice0shift_reference_4 - slice0shift_search_4_7) mod 256;
      slice0cost_reverse_2_0 <= slice0cost_reverse_2_0 or slice0cost_reverse_2_0_all_2 when
        slice0cost_reverse_2_0_choice_3 else slice0cost_reverse_2_0 and ((not leftright_checked_tag_valid) or (not
        leftright_checked_tag_map_column));
      slice0cost_reverse_2_1 <= slice0cost_reverse_2_2;
      slice0cost_reverse_2_2 <= slice1_best_second_0_0 = 2047;
      slice0cost_reverse_2_3 <= slice0cost_reverse_2_3_choice_3 or ((not transform_filtered_valid) and
        slice0cost_reverse_2_3);
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pair_0_0_choice + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= slice0cost_pair_0_1_choice + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= slice0cost_pair_0_2_choice + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_pair_0_3 <= slice0cost_pair_0_3_choice + folded(slice0cost_difference_1_3) +
        as_number((slice0cost_difference_1_3 < 0));
      slice0cost_pair_0_4 <= slice0cost_pair_0_4_choice + folded(slice0cost_difference_1_4) +
        as_number((slice0cost_difference_1_4 < 0));
      slice0cost_pair_0_5 <= slice0cost_pair_0_5_choice + folded(slice0cost_difference_1_5) +
        as_number((slice0cost_difference_1_5 < 0));
      slice0cost_pair_0_6 <= slice0cost_pair_0_6_choice + folded(slice0cost_difference_1_6) +
        as_number((slice0cost_difference_1_6 < 0));
      slice0cost_pair_0_7 <= slice0cost_pair_0_7_choice + folded(slice0cost_difference_1_7) +
        as_number((slice0cost_difference_1_7 < 0));
      slice0cost_pair_1_0 <= slice0cost_pair_1_0_choice + folded(slice0cost_difference_3_0) +
        as_number((slice0cost_difference_3_0 < 0));
      slice0cost_pair_1_1 <= slice0cost_pair_1_1_choice + folded(slice0cost_difference_3_1) +
        as_number((slice0cost_difference_3_1 < 0));
      slice0cost_pair_1_2 <= slice0cost_pair_1_2_choice + folded(slice0cost_difference_3_2) +
        as_number((slice0cost_difference_3_2 < 0));
      slice0cost_pair_1_3 <= slice0cost_pair_1_3_choice + folded(slice0cost_difference_3_3) +
        as_number((slice0cost_difference_3_3 < 0));
      slice0cost_pair_1_4 <= slice0cost_pair_1_4_choice + folded(slice0cost_difference_3_4) +
        as_number((slice0cost_difference_3_4 < 0));
      slice0cost_pair_1_5 <= slice0cost_pair_1_5_choice + folded(slice0cost_difference_3_5) +
        as_number((slice0cost_difference_3_5 < 0));
      slice0cost_pair_1_6 <= slice0cost_pair_1_6_choice + folded(slice0cost_difference_3_6) +
        as_number((slice0cost_difference_3_6 < 0));
      slice0cost_pair_1_7 <= slice0cost_pair_1_7_choice + folded(slice0cost_difference_3_7) +
        as_number((slice0cost_difference_3_7 < 0));
      slice0cost_single_0_0 <= folded(slice0cost_difference_0_0);
      slice0cost_single_0_1 <= folded(slice0cost_difference_0_1);
      slice0cost_single_0_2 <= folded(slice0cost_difference_0_2);
      slice0cost_single_0_3 <= folded(slice0cost_difference_0_3);
      slice0cost_single_0_4 <= folded(slice0cost_difference_0_4);
      slice0cost_single_0_5 <= folded(slice0cost_difference_0_5);
      slice0cost_single_0_6 <= folded(slice0cost_difference_0_6);
      slice0cost_single_0_7 <= folded(slice0cost_difference_0_7);
      slice0cost_negative_0_0 <= slice0cost_difference_0_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_0_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_0_2 < 0;
      slice0cost_negative_0_3 <= slice0cost_difference_0_3 < 0;
      slice0cost_negative_0_4 <= slice0cost_difference_0_4 < 0;
      slice0cost_negative_0_5 <= slice0cost_difference_0_5 < 0;
      slice0cost_negative_0_6 <= slice0cost_difference_0_6 < 0;
      slice0cost_negative_0_7 <= slice0cost_difference_0_7 < 0;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_first_cost <= slice0cost_difference_tag_first_cost;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_0) +
        slice0cost_pair_1_0 + slice0cost_pair_0_0 + slice0cost_single_0_0;
      slice0cost_column_0_1 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_1) +
        slice0cost_pair_1_1 + slice0cost_pair_0_1 + slice0cost_single_0_1;
      slice0cost_column_0_2 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_2) +
        slice0cost_pair_1_2 + slice0cost_pair_0_2 + slice0cost_single_0_2;
      slice0cost_column_0_3 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_3) +
        slice0cost_pair_1_3 + slice0cost_pair_0_3 + slice0cost_single_0_3;
      slice0cost_column_0_4 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_4) +
        slice0cost_pair_1_4 + slice0cost_pair_0_4 + slice0cost_single_0_4;
      slice0cost_column_0_5 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_5) +
        slice0cost_pair_1_5 + slice0cost_pair_0_5 + slice0cost_single_0_5;
      slice0cost_column_0_6 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_6) +
        slice0cost_pair_1_6 + slice0cost_pair_0_6 + slice0cost_single_0_6;
      slice0cost_column_0_7 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_7) +
        slice0cost_pair_1_7 + slice0cost_pair_0_7 + slice0cost_single_0_7;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_pair_tag_first_cost;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      slice0cost_reverse_2_4_choice := slice0cost_reverse_2_4 and ((transform_counter_group mod 2) = 1) when
        transform_counter_group_is_equal_3 else slice0cost_reverse_2_4;
      slice0cost_reverse_2_4_choice_2 := slice0cost_reverse_2_4_choice when transform_counter_group_is_equal else
        slice0cost_reverse_2_4;
      if in_valid then
        slice0cost_reverse_2_4 <= transform_counter_group_all or (not in_start_of_frame) when
          slice0cost_reverse_2_4_choice_2 else transform_counter_group_is_equal and transform_counter_group_is_equal_2
          and in_start_of_frame;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_0_3 <= slice0cost_column_0_3;
        slice0window_partial_0_0_4 <= slice0cost_column_0_4;
        slice0window_partial_0_0_5 <= slice0cost_column_0_5;
        slice0window_partial_0_0_6 <= slice0cost_column_0_6;
        slice0window_partial_0_0_7 <= slice0cost_column_0_7;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
        slice0window_partial_0_1_3 <= slice0cost_column_0_3 + slice0window_partial_0_0_3;
        slice0window_partial_0_1_4 <= slice0cost_column_0_4 + slice0window_partial_0_0_4;
        slice0window_partial_0_1_5 <= slice0cost_column_0_5 + slice0window_partial_0_0_5;
        slice0window_partial_0_1_6 <= slice0cost_column_0_6 + slice0window_partial_0_0_6;
        slice0window_partial_0_1_7 <= slice0cost_column_0_7 + slice0window_partial_0_0_7;
        slice0window_partial_0_2_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
        slice0window_partial_0_2_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
        slice0window_partial_0_2_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
        slice0window_partial_0_2_3 <= slice0cost_column_0_3 + slice0window_partial_0_1_3;
        slice0window_partial_0_2_4 <= slice0cost_column_0_4 + slice0window_partial_0_1_4;
        slice0window_partial_0_2_5 <= slice0cost_column_0_5 + slice0window_partial_0_1_5;
        slice0window_partial_0_2_6 <= slice0cost_column_0_6 + slice0window_partial_0_1_6;
        slice0window_partial_0_2_7 <= slice0cost_column_0_7 + slice0window_partial_0_1_7;
        slice0window_partial_0_3_0 <= slice0cost_column_0_0 + slice0window_partial_0_2_0;
        slice0window_partial_0_3_1 <= slice0cost_column_0_1 + slice0window_partial_0_2_1;
        slice0window_partial_0_3_2 <= slice0cost_column_0_2 + slice0window_partial_0_2_2;
        slice0window_partial_0_3_3 <= slice0cost_column_0_3 + slice0window_partial_0_2_3;
        slice0window_partial_0_3_4 <= slice0cost_column_0_4 + slice0window_partial_0_2_4;
        slice0window_partial_0_3_5 <= slice0cost_column_0_5 + slice0window_partial_0_2_5;
        slice0window_partial_0_3_6 <= slice0cost_column_0_6 + slice0window_partial_0_2_6;
        slice0window_partial_0_3_7 <= slice0cost_column_0_7 + slice0window_partial_0_2_7;
        slice0window_centre_output_column_1 <= slice1cost_tag_output_column;
        slice0window_centre_first_column_1 <= slice1cost_tag_first_cost;
      end if;
      slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
      slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
      slice0window_centre_first_column_0 <= slice0cost_tag_first_cost;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_3_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_3_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_3_2;
      slice0window_sum_0_3 <= slice0cost_column_0_3 + slice0window_partial_0_3_3;
      slice0window_sum_0_4 <= slice0cost_column_0_4 + slice0window_partial_0_3_4;
      slice0window_sum_0_5 <= slice0cost_column_0_5 + slice0window_partial_0_3_5;
      slice0window_sum_0_6 <= slice0cost_column_0_6 + slice0window_partial_0_3_6;
      slice0window_sum_0_7 <= slice0cost_column_0_7 + slice0window_partial_0_3_7;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column_1;
      slice0window_tag_first_column <= slice0window_centre_first_column_1;
      if slice0window_tag_valid then
        slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
        slice0window_tag_map_column <= slice1window_centre_map_column_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_1;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_0;
      end if;
      -- slice0other
      slice0other_cost_0_0_all := (slice0other_cost_0_7 < slice0window_sum_0_6) and (not slice0window_tag_first_column)
        and slice0window_tag_output_column;
      slice0other_cost_0_0_is_not_less := slice0other_cost_0_1 >= slice0window_sum_0_0;
      slice0other_cost_0_0_choice := slice0window_sum_0_0 when slice0other_cost_0_0_is_not_less else
        slice0other_cost_0_1;
      slice0other_cost_0_0_choice_2 := slice0other_cost_0_0_choice when slice0window_tag_valid else
        slice0other_cost_0_0;
      slice0other_cost_0_0_all_2 := (slice0other_cost_0_7 >= slice0window_sum_0_6) and (not
        slice0window_tag_first_column) and slice0window_tag_output_column;
      slice0other_cost_0_0_choice_3 := slice0window_sum_0_0 when slice0window_tag_valid else slice0other_cost_0_0;
      slice0other_cost_0_0_choice_4 := slice0other_cost_0_1 when slice0window_tag_valid else slice0other_cost_0_0;
      slice0other_cost_0_0_choice_5 := slice0other_cost_0_0_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_0_choice_4;
      slice0other_cost_0_0_choice_6 := slice0other_cost_0_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_0_choice_5;
      slice0other_cost_0_1_is_not_less := slice0other_cost_0_2 >= slice0window_sum_0_1;
      slice0other_cost_0_1_choice := slice0window_sum_0_1 when slice0other_cost_0_1_is_not_less else
        slice0other_cost_0_2;
      slice0other_cost_0_1_choice_2 := slice0other_cost_0_1_choice when slice0window_tag_valid else
        slice0other_cost_0_1;
      slice0other_cost_0_1_choice_3 := slice0window_sum_0_1 when slice0window_tag_valid else slice0other_cost_0_1;
      slice0other_cost_0_1_choice_4 := slice0other_cost_0_2 when slice0window_tag_valid else slice0other_cost_0_1;
      slice0other_cost_0_1_choice_5 := slice0other_cost_0_1_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_1_choice_4;
      slice0other_cost_0_1_choice_6 := slice0other_cost_0_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_1_choice_5;
      slice0other_cost_0_2_is_not_less := slice0other_cost_0_3 >= slice0window_sum_0_2;
      slice0other_cost_0_2_choice := slice0window_sum_0_2 when slice0other_cost_0_2_is_not_less else
        slice0other_cost_0_3;
      slice0other_cost_0_2_choice_2 := slice0other_cost_0_2_choice when slice0window_tag_valid else
        slice0other_cost_0_2;
      slice0other_cost_0_2_choice_3 := slice0window_sum_0_2 when slice0window_tag_valid else slice0other_cost_0_2;
      slice0other_cost_0_2_choice_4 := slice0other_cost_0_3 when slice0window_tag_valid else slice0other_cost_0_2;
      slice0other_cost_0_2_choice_5 := slice0other_cost_0_2_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_2_choice_4;
      slice0other_cost_0_2_choice_6 := slice0other_cost_0_2_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_2_choice_5;
      slice0other_cost_0_3_is_not_less := slice0other_cost_0_4 >= slice0window_sum_0_3;
      slice0other_cost_0_3_choice := slice0window_sum_0_3 when slice0other_cost_0_3_is_not_less else
        slice0other_cost_0_4;
      slice0other_cost_0_3_choice_2 := slice0other_cost_0_3_choice when slice0window_tag_valid else
        slice0other_cost_0_3;
      slice0other_cost_0_3_choice_3 := slice0window_sum_0_3 when slice0window_tag_valid else slice0other_cost_0_3;
      slice0other_cost_0_3_choice_4 := slice0other_cost_0_4 when slice0window_tag_valid else slice0other_cost_0_3;
      slice0other_cost_0_3_choice_5 := slice0other_cost_0_3_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_3_choice_4;
      slice0other_cost_0_3_choice_6 := slice0other_cost_0_3_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_3_choice_5;
      slice0other_cost_0_4_is_not_less := slice0other_cost_0_5 >= slice0window_sum_0_4;
      slice0other_cost_0_4_choice := slice0window_sum_0_4 when slice0other_cost_0_4_is_not_less else
        slice0other_cost_0_5;
      slice0other_cost_0_4_choice_2 := slice0other_cost_0_4_choice when slice0window_tag_valid else
        slice0other_cost_0_4;
      slice0other_cost_0_4_choice_3 := slice0window_sum_0_4 when slice0window_tag_valid else slice0other_cost_0_4;
      slice0other_cost_0_4_choice_4 := slice0other_cost_0_5 when slice0window_tag_valid else slice0other_cost_0_4;
      slice0other_cost_0_4_choice_5 := slice0other_cost_0_4_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_4_choice_4;
      slice0other_cost_0_4_choice_6 := slice0other_cost_0_4_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_4_choice_5;
      slice0other_cost_0_5_is_not_less := slice0other_cost_0_6 >= slice0window_sum_0_5;
      slice0other_cost_0_5_choice := slice0window_sum_0_5 when slice0other_cost_0_5_is_not_less else
        slice0other_cost_0_6;
      slice0other_cost_0_5_choice_2 := slice0other_cost_0_5_choice when slice0window_tag_valid else
        slice0other_cost_0_5;
      slice0other_cost_0_5_choice_3 := slice0window_sum_0_5 when slice0window_tag_valid else slice0other_cost_0_5;
      slice0other_cost_0_5_choice_4 := slice0other_cost_0_6 when slice0window_tag_valid else slice0other_cost_0_5;
      slice0other_cost_0_5_choice_5 := slice0other_cost_0_5_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_5_choice_4;
      slice0other_cost_0_5_choice_6 := slice0other_cost_0_5_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_5_choice_5;
      slice0other_cost_0_6_choice := slice0other_cost_0_7 when slice0window_tag_valid else slice0other_cost_0_6;
      slice0other_cost_0_6_choice_2 := slice0window_sum_0_6 when slice0window_tag_valid else slice0other_cost_0_6;
      slice0other_cost_0_6_choice_3 := slice0other_cost_0_6_choice_2 when slice0window_tag_output_column else
        slice0other_cost_0_6_choice;
      slice0other_cost_0_6_choice_4 := slice0other_cost_0_6_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_6_choice_3;
      slice0other_winner_0_0_choice := 8 when slice0other_cost_0_0_is_not_less else slice0other_winner_0_1;
      slice0other_winner_0_0_choice_2 := slice0other_winner_0_0_choice when slice0window_tag_valid else
        slice0other_winner_0_0;
      slice0other_winner_0_0_choice_3 := 8 when slice0window_tag_valid else slice0other_winner_0_0;
      slice0other_winner_0_0_choice_4 := slice0other_winner_0_1 when slice0window_tag_valid else slice0other_winner_0_0;
      slice0other_winner_0_0_choice_5 := slice0other_winner_0_0_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_0_choice_4;
      slice0other_winner_0_0_choice_6 := slice0other_winner_0_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_0_choice_5;
      slice0other_winner_0_1_choice := 9 when slice0other_cost_0_1_is_not_less else slice0other_winner_0_2;
      slice0other_winner_0_1_choice_2 := slice0other_winner_0_1_choice when slice0window_tag_valid else
        slice0other_winner_0_1;
      slice0other_winner_0_1_choice_3 := 9 when slice0window_tag_valid else slice0other_winner_0_1;
      slice0other_winner_0_1_choice_4 := slice0other_winner_0_2 when slice0window_tag_valid else slice0other_winner_0_1;
      slice0other_winner_0_1_choice_5 := slice0other_winner_0_1_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_1_choice_4;
      slice0other_winner_0_1_choice_6 := slice0other_winner_0_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_1_choice_5;
      slice0other_winner_0_2_choice := 10 when slice0other_cost_0_2_is_not_less else slice0other_winner_0_3;
      slice0other_winner_0_2_choice_2 := slice0other_winner_0_2_choice when slice0window_tag_valid else
        slice0other_winner_0_2;
      slice0other_winner_0_2_choice_3 := 10 when slice0window_tag_valid else slice0other_winner_0_2;
      slice0other_winner_0_2_choice_4 := slice0other_winner_0_3 when slice0window_tag_valid else slice0other_winner_0_2;
      slice0other_winner_0_2_choice_5 := slice0other_winner_0_2_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_2_choice_4;
      slice0other_winner_0_2_choice_6 := slice0other_winner_0_2_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_2_choice_5;
      slice0other_winner_0_3_choice := 11 when slice0other_cost_0_3_is_not_less else slice0other_winner_0_4;
      slice0other_winner_0_3_choice_2 := slice0other_winner_0_3_choice when slice0window_tag_valid else
        slice0other_winner_0_3;
      slice0other_winner_0_3_choice_3 := 11 when slice0window_tag_valid else slice0other_winner_0_3;
      slice0other_winner_0_3_choice_4 := slice0other_winner_0_4 when slice0window_tag_valid else slice0other_winner_0_3;
      slice0other_winner_0_3_choice_5 := slice0other_winner_0_3_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_3_choice_4;
      slice0other_winner_0_3_choice_6 := slice0other_winner_0_3_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_3_choice_5;
      slice0other_winner_0_4_choice := 12 when slice0other_cost_0_4_is_not_less else slice0other_winner_0_5;
      slice0other_winner_0_4_choice_2 := slice0other_winner_0_4_choice when slice0window_tag_valid else
        slice0other_winner_0_4;
      slice0other_winner_0_4_choice_3 := 12 when slice0window_tag_valid else slice0other_winner_0_4;
      slice0other_winner_0_4_choice_4 := slice0other_winner_0_5 when slice0window_tag_valid else slice0other_winner_0_4;
      slice0other_winner_0_4_choice_5 := slice0other_winner_0_4_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_4_choice_4;
      slice0other_winner_0_4_choice_6 := slice0other_winner_0_4_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_4_choice_5;
      slice0other_winner_0_5_choice := 13 when slice0other_cost_0_5_is_not_less else slice0other_winner_0_6;
      slice0other_winner_0_5_choice_2 := slice0other_winner_0_5_choice when slice0window_tag_valid else
        slice0other_winner_0_5;
      slice0other_winner_0_5_choice_3 := 13 when slice0window_tag_valid else slice0other_winner_0_5;
      slice0other_winner_0_5_choice_4 := slice0other_winner_0_6 when slice0window_tag_valid else slice0other_winner_0_5;
      slice0other_winner_0_5_choice_5 := slice0other_winner_0_5_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_5_choice_4;
      slice0other_winner_0_5_choice_6 := slice0other_winner_0_5_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_5_choice_5;
      slice0other_cost_0_0 <= slice0other_cost_0_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_0_choice_6;
      slice0other_cost_0_1 <= slice0other_cost_0_1_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_1_choice_6;
      slice0other_cost_0_2 <= slice0other_cost_0_2_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_2_choice_6;
      slice0other_cost_0_3 <= slice0other_cost_0_3_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_3_choice_6;
      slice0other_cost_0_4 <= slice0other_cost_0_4_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_4_choice_6;
      slice0other_cost_0_5 <= slice0other_cost_0_5_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_5_choice_6;
      slice0other_cost_0_6 <= slice0other_cost_0_6_choice when slice0other_cost_0_0_all else
        slice0other_cost_0_6_choice_4;
      slice0other_winner_0_0 <= slice0other_winner_0_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_0_choice_6;
      slice0other_winner_0_1 <= slice0other_winner_0_1_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_1_choice_6;
      slice0other_winner_0_2 <= slice0other_winner_0_2_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_2_choice_6;
      slice0other_winner_0_3 <= slice0other_winner_0_3_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_3_choice_6;
      slice0other_winner_0_4 <= slice0other_winner_0_4_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_4_choice_6;
      slice0other_winner_0_5 <= slice0other_winner_0_5_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_5_choice_6;
      slice0other_cost_out_0 <= slice0other_cost_0_0;
      slice0other_winner_out_0 <= slice0other_winner_0_0;
      slice0other_cost_0_7_choice := slice0window_sum_0_7 when slice0window_tag_output_column else 0;
      slice0other_cost_0_7_choice_2 := slice0window_sum_0_7 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_7_choice;
      slice0other_winner_0_6_choice := 14 when slice0window_tag_output_column else slice0other_winner_0_7;
      slice0other_winner_0_6_choice_2 := 14 when slice0other_cost_0_0_all_2 else slice0other_winner_0_6_choice;
      slice0other_winner_0_7_choice := 15 when slice0window_tag_output_column else 0;
      slice0other_winner_0_7_choice_2 := 15 when slice0other_cost_0_0_all_2 else slice0other_winner_0_7_choice;
      if slice0window_tag_valid then
        slice0other_cost_0_7 <= slice0window_sum_0_7 when slice0other_cost_0_0_all else slice0other_cost_0_7_choice_2;
        slice0other_winner_0_6 <= slice0other_winner_0_7 when slice0other_cost_0_0_all else
          slice0other_winner_0_6_choice_2;
        slice0other_winner_0_7 <= 15 when slice0other_cost_0_0_all else slice0other_winner_0_7_choice_2;
      end if;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := slice0window_sum_0_1 < slice0window_sum_0_0;
      slice0winner1_best_cost_0_1_is_less := slice0window_sum_0_3 < slice0window_sum_0_2;
      slice0winner1_best_cost_0_2_is_less := slice0window_sum_0_5 < slice0window_sum_0_4;
      slice0winner1_best_cost_0_3_is_less := slice0window_sum_0_7 < slice0window_sum_0_6;
      slice0winner1_best_cost_0_0 <= slice0window_sum_0_1 when slice0winner1_best_cost_0_0_is_less else
        slice0window_sum_0_0;
      slice0winner1_best_cost_0_1 <= slice0window_sum_0_3 when slice0winner1_best_cost_0_1_is_less else
        slice0window_sum_0_2;
      slice0winner1_best_cost_0_2 <= slice0window_sum_0_5 when slice0winner1_best_cost_0_2_is_less else
        slice0window_sum_0_4;
      slice0winner1_best_cost_0_3 <= slice0window_sum_0_7 when slice0winner1_best_cost_0_3_is_less else
        slice0window_sum_0_6;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_index_0_1 <= 3 when slice0winner1_best_cost_0_1_is_less else 2;
      slice0winner1_best_index_0_2 <= 5 when slice0winner1_best_cost_0_2_is_less else 4;
      slice0winner1_best_index_0_3 <= 7 when slice0winner1_best_cost_0_3_is_less else 6;
      slice0winner1_best_below_0_0 <= slice0window_sum_0_0 mod 2048 when slice0winner1_best_cost_0_0_is_less else 0;
      slice0winner1_best_below_0_1 <= slice0window_sum_0_2 mod 2048 when slice0winner1_best_cost_0_1_is_less else 0;
      slice0winner1_best_below_0_2 <= slice0window_sum_0_4 mod 2048 when slice0winner1_best_cost_0_2_is_less else 0;
      slice0winner1_best_below_0_3 <= slice0window_sum_0_6 mod 2048 when slice0winner1_best_cost_0_3_is_less else 0;
      slice0winner1_best_above_0_0 <= 0 when slice0winner1_best_cost_0_0_is_less else slice0window_sum_0_1 mod 2048;
      slice0winner1_best_above_0_1 <= 0 when slice0winner1_best_cost_0_1_is_less else slice0window_sum_0_3 mod 2048;
      slice0winner1_best_above_0_2 <= 0 when slice0winner1_best_cost_0_2_is_less else slice0window_sum_0_5 mod 2048;
      slice0winner1_best_above_0_3 <= 0 when slice0winner1_best_cost_0_3_is_less else slice0window_sum_0_7 mod 2048;
      slice0winner1_best_first_0_0 <= slice0window_sum_0_0 mod 2048 when slice0window_sum_0_0 < 2047 else 2047;
      slice0winner1_best_first_0_1 <= slice0window_sum_0_2 mod 2048 when slice0window_sum_0_2 < 2047 else 2047;
      slice0winner1_best_first_0_2 <= slice0window_sum_0_4 mod 2048 when slice0window_sum_0_4 < 2047 else 2047;
      slice0winner1_best_first_0_3 <= slice0window_sum_0_6 mod 2048;
      slice0winner1_best_last_0_0 <= slice0window_sum_0_1 mod 2048 when slice0window_sum_0_1 < 2047 else 2047;
      slice0winner1_best_last_0_1 <= slice0window_sum_0_3 mod 2048 when slice0window_sum_0_3 < 2047 else 2047;
      slice0winner1_best_last_0_2 <= slice0window_sum_0_5 mod 2048 when slice0window_sum_0_5 < 2047 else 2047;
      slice0winner1_best_last_0_3 <= slice0window_sum_0_7 mod 2048 when slice0window_sum_0_7 < 2047 else 2047;
      slice0winner1_best_second_0_0 <= 2047;
      slice0winner1_best_but_first_0_0 <= slice0window_sum_0_1 mod 2048;
      slice0winner1_best_but_first_0_1 <= slice0window_sum_0_3 mod 2048;
      slice0winner1_best_but_first_0_2 <= slice0window_sum_0_5 mod 2048;
      slice0winner1_best_but_last_0_0 <= slice0window_sum_0_0 mod 2048;
      slice0winner1_best_but_last_0_1 <= slice0window_sum_0_2 mod 2048;
      slice0winner1_best_but_last_0_2 <= slice0window_sum_0_4 mod 2048;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_map_column <= slice0window_tag_map_column;
      slice0winner1_tag_output_column <= slice1window_centre_output_column_1;
      slice0winner1_tag_first_column <= slice1window_centre_first_column_1;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := slice0winner1_best_cost_0_1 < slice0winner1_best_cost_0_0;
      slice0winner2_best_cost_0_1_is_less := slice0winner1_best_cost_0_3 < slice0winner1_best_cost_0_2;
      slice0winner2_best_below_0_0_is_equal := slice0winner1_best_index_0_1 = 2;
      slice0winner2_best_below_0_0_choice := slice0winner1_best_but_first_0_0 when
        slice0winner2_best_below_0_0_is_equal else slice0winner1_best_below_0_1;
      slice0winner2_best_below_0_1_is_equal := slice0winner1_best_index_0_3 = 6;
      slice0winner2_best_below_0_1_choice := slice0winner1_best_but_first_0_2 when
        slice0winner2_best_below_0_1_is_equal else slice0winner1_best_below_0_3;
      slice0winner2_best_above_0_0_choice := slice0winner1_best_but_last_0_1 when slice0winner1_best_index_0_0 else
        slice0winner1_best_above_0_0;
      slice0winner2_best_above_0_1_choice := slice0winner1_best_first_0_3 when other_1 else
        slice0winner1_best_above_0_2;
      if slice0winner2_best_below_0_0_is_equal then
        slice0winner2_best_second_0_0_choice := slice0winner1_best_first_0_0;
      else
        slice0winner2_best_second_0_0_choice := slice0winner1_best_cost_0_0;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_last_0_1;
      else
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_cost_0_1;
      end if;
      slice0winner2_best_second_0_0_choice_3 := slice0winner2_best_second_0_0_choice when
        slice0winner2_best_cost_0_0_is_less else slice0winner2_best_second_0_0_choice_2;
      slice0winner2_best_second_0_0_choice_4 := slice0winner1_best_first_0_0 when slice0winner2_best_below_0_0_is_equal
        else slice0winner1_best_cost_0_0 mod 2048;
      slice0winner2_best_second_0_0_choice_5 := slice0winner1_best_last_0_1 when slice0winner1_best_index_0_0 else
        slice0winner1_best_cost_0_1 mod 2048;
      slice0winner2_best_second_0_0_choice_6 := slice0winner2_best_second_0_0_choice_4 when
        slice0winner2_best_cost_0_0_is_less else slice0winner2_best_second_0_0_choice_5;
      if slice0winner2_best_below_0_1_is_equal then
        slice0winner2_best_second_0_1_choice := slice0winner1_best_first_0_2;
      else
        slice0winner2_best_second_0_1_choice := slice0winner1_best_cost_0_2;
      end if;
      if other_1 then
        slice0winner2_best_second_0_1_choice_2 := slice0winner1_best_last_0_3;
      else
        slice0winner2_best_second_0_1_choice_2 := slice0winner1_best_cost_0_3;
      end if;
      slice0winner2_best_second_0_1_choice_3 := slice0winner2_best_second_0_1_choice when
        slice0winner2_best_cost_0_1_is_less else slice0winner2_best_second_0_1_choice_2;
      slice0winner2_best_second_0_1_choice_4 := slice0winner1_best_first_0_2 when slice0winner2_best_below_0_1_is_equal
        else slice0winner1_best_cost_0_2 mod 2048;
      slice0winner2_best_second_0_1_choice_5 := slice0winner1_best_last_0_3 when other_1 else
        slice0winner1_best_cost_0_3 mod 2048;
      slice0winner2_best_second_0_1_choice_6 := slice0winner2_best_second_0_1_choice_4 when
        slice0winner2_best_cost_0_1_is_less else slice0winner2_best_second_0_1_choice_5;
      slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1 when slice0winner2_best_cost_0_0_is_less else
        slice0winner1_best_cost_0_0;
      slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_3 when slice0winner2_best_cost_0_1_is_less else
        slice0winner1_best_cost_0_2;
      slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1 when slice0winner2_best_cost_0_0_is_less else
        as_number(slice0winner1_best_index_0_0);
      slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3 when slice0winner2_best_cost_0_1_is_less else
        slice0winner1_best_index_0_2;
      slice0winner2_best_below_0_0 <= slice0winner2_best_below_0_0_choice when slice0winner2_best_cost_0_0_is_less else
        slice0winner1_best_below_0_0;
      slice0winner2_best_below_0_1 <= slice0winner2_best_below_0_1_choice when slice0winner2_best_cost_0_1_is_less else
        slice0winner1_best_below_0_2;
      slice0winner2_best_above_0_0 <= slice0winner1_best_above_0_1 when slice0winner2_best_cost_0_0_is_less else
        slice0winner2_best_above_0_0_choice;
      slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_3 when slice0winner2_best_cost_0_1_is_less else
        slice0winner2_best_above_0_1_choice;
      slice0winner2_best_first_0_0 <= slice0winner1_best_but_last_0_0;
      slice0winner2_best_first_0_1 <= slice0winner1_best_but_last_0_2;
      slice0winner2_best_last_0_0 <= slice0winner1_best_but_first_0_1;
      slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_6 when
        slice0winner2_best_second_0_0_choice_3 < slice0winner1_best_second_0_0 else slice0winner1_best_second_0_0;
      slice0winner2_best_second_0_1 <= slice0winner2_best_second_0_1_choice_6 when
        slice0winner2_best_second_0_1_choice_3 < slice0winner1_best_second_0_0 else slice0winner1_best_second_0_0;
      slice0winner2_best_but_first_0_0 <= slice0winner1_best_cost_0_1 mod 2048 when slice0winner1_best_cost_0_1 <
        slice0winner1_best_last_0_0 else slice0winner1_best_last_0_0;
      slice0winner2_best_but_first_0_1 <= slice0winner1_best_cost_0_3 mod 2048 when slice0winner1_best_cost_0_3 <
        slice0winner1_best_last_0_2 else slice0winner1_best_last_0_2;
      slice0winner2_best_but_last_0_0 <= slice0winner1_best_first_0_1 when slice0winner1_best_first_0_1 <
        slice0winner1_best_cost_0_0 else slice0winner1_best_cost_0_0 mod 2048;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := slice0winner2_best_cost_0_1 < slice0winner2_best_cost_0_0;
      slice0winner3_best_below_0_0_is_equal := slice0winner2_best_index_0_1 = 4;
      slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0 when slice0winner3_best_below_0_0_is_equal
        else slice0winner2_best_below_0_1;
      slice0winner3_best_above_0_0_is_equal := slice0winner2_best_index_0_0 = 3;
      slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1 when slice0winner3_best_above_0_0_is_equal
        else slice0winner2_best_above_0_0;
      if slice0winner3_best_below_0_0_is_equal then
        slice0winner3_best_second_0_0_choice := slice0winner2_best_but_last_0_0;
      else
        slice0winner3_best_second_0_0_choice := slice0winner2_best_cost_0_0;
      end if;
      slice0winner3_best_second_0_0_choice_2 := slice0winner2_best_but_last_0_0 when
        slice0winner3_best_below_0_0_is_equal else slice0winner2_best_cost_0_0 mod 2048;
      slice0winner3_best_second_0_0_choice_3 := slice0winner3_best_second_0_0_choice_2 when
        slice0winner3_best_second_0_0_choice < slice0winner2_best_second_0_1 else slice0winner2_best_second_0_1;
      if slice0winner3_best_above_0_0_is_equal then
        slice0winner3_best_second_0_0_choice_4 := slice0winner2_best_but_first_0_1;
      else
        slice0winner3_best_second_0_0_choice_4 := slice0winner2_best_cost_0_1;
      end if;
      slice0winner3_best_second_0_0_choice_5 := slice0winner2_best_but_first_0_1 when
        slice0winner3_best_above_0_0_is_equal else slice0winner2_best_cost_0_1 mod 2048;
      slice0winner3_best_second_0_0_choice_6 := slice0winner3_best_second_0_0_choice_5 when
        slice0winner3_best_second_0_0_choice_4 < slice0winner2_best_second_0_0 else slice0winner2_best_second_0_0;
      slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_1 when slice0winner3_best_cost_0_0_is_less else
        slice0winner2_best_cost_0_0;
      slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1 when slice0winner3_best_cost_0_0_is_less else
        slice0winner2_best_index_0_0;
      slice0winner3_best_below_0_0 <= slice0winner3_best_below_0_0_choice when slice0winner3_best_cost_0_0_is_less else
        slice0winner2_best_below_0_0;
      slice0winner3_best_above_0_0 <= slice0winner2_best_above_0_1 when slice0winner3_best_cost_0_0_is_less else
        slice0winner3_best_above_0_0_choice;
      slice0winner3_best_first_0_0 <= slice0winner2_best_first_0_0;
      slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_3 when slice0winner3_best_cost_0_0_is_less
        else slice0winner3_best_second_0_0_choice_6;
      slice0winner3_best_but_first_0_0 <= slice0winner2_best_cost_0_1 mod 2048 when slice0winner2_best_cost_0_1 <
        slice0winner2_best_but_first_0_0 else slice0winner2_best_but_first_0_0;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner3_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner3_best_index_0_0 + 8;
      slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
      slice0_best_first_0_0 <= slice0winner3_best_first_0_0;
      slice0_best_second_0_0 <= slice0winner3_best_second_0_0;
      slice0_best_but_first_0_0 <= slice0winner3_best_but_first_0_0;
      slice0_best_tag_valid <= slice0winner3_tag_valid;
      slice0_best_tag_map_column <= slice0winner3_tag_map_column;
      slice0_best_tag_output_column <= slice0winner3_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner3_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice1shift_search_0_3;
        slice1shift_search_0_3 <= slice1shift_search_0_4;
        slice1shift_search_0_4 <= slice1shift_search_0_5;
        slice1shift_search_0_5 <= slice1shift_search_0_6;
        slice1shift_search_0_6 <= slice1shift_search_0_7;
        slice1shift_search_0_7 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice1shift_search_1_3;
        slice1shift_search_1_3 <= slice1shift_search_1_4;
        slice1shift_search_1_4 <= slice1shift_search_1_5;
        slice1shift_search_1_5 <= slice1shift_search_1_6;
        slice1shift_search_1_6 <= slice1shift_search_1_7;
        slice1shift_search_1_7 <= slice0shift_search_out_1;
        slice1shift_search_2_0 <= slice1shift_search_2_1;
        slice1shift_search_2_1 <= slice1shift_search_2_2;
        slice1shift_search_2_2 <= slice1shift_search_2_3;
        slice1shift_search_2_3 <= slice1shift_search_2_4;
        slice1shift_search_2_4 <= slice1shift_search_2_5;
        slice1shift_search_2_5 <= slice1shift_search_2_6;
        slice1shift_search_2_6 <= slice1shift_search_2_7;
        slice1shift_search_2_7 <= slice0shift_search_out_2;
        slice1shift_search_3_0 <= slice1shift_search_3_1;
        slice1shift_search_3_1 <= slice1shift_search_3_2;
        slice1shift_search_3_2 <= slice1shift_search_3_3;
        slice1shift_search_3_3 <= slice1shift_search_3_4;
        slice1shift_search_3_4 <= slice1shift_search_3_5;
        slice1shift_search_3_5 <= slice1shift_search_3_6;
        slice1shift_search_3_6 <= slice1shift_search_3_7;
        slice1shift_search_3_7 <= slice0shift_search_out_3;
        slice1shift_search_4_0 <= slice1shift_search_4_1;
        slice1shift_search_4_1 <= slice1shift_search_4_2;
        slice1shift_search_4_2 <= slice1shift_search_4_3;
        slice1shift_search_4_3 <= slice1shift_search_4_4;
        slice1shift_search_4_4 <= slice1shift_search_4_5;
        slice1shift_search_4_5 <= slice1shift_search_4_6;
        slice1shift_search_4_6 <= slice1shift_search_4_7;
        slice1shift_search_4_7 <= slice0shift_search_out_4;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_reference_4 <= slice0shift_reference_4;
      -- slice1cost
      slice1cost_pair_0_0_choice := slice1cost_reverse_0_0 when slice1cost_difference_2_0 < 0 else
        positive_part(slice1cost_difference_2_0);
      slice1cost_pair_0_1_choice := slice1cost_reverse_0_1 when slice1cost_difference_2_1 < 0 else
        positive_part(slice1cost_difference_2_1);
      slice1cost_pair_0_2_choice := slice1cost_reverse_0_2 when slice1cost_difference_2_2 < 0 else
        positive_part(slice1cost_difference_2_2);
      slice1cost_pair_0_3_choice := slice1cost_reverse_0_3 when slice1cost_difference_2_3 < 0 else
        positive_part(slice1cost_difference_2_3);
      slice1cost_pair_0_4_choice := slice1cost_reverse_0_4 when slice1cost_difference_2_4 < 0 else
        positive_part(slice1cost_difference_2_4);
      slice1cost_pair_0_5_choice := slice1cost_reverse_0_5 when slice1cost_difference_2_5 < 0 else
        positive_part(slice1cost_difference_2_5);
      slice1cost_pair_0_6_choice := slice1cost_reverse_0_6 when slice1cost_difference_2_6 < 0 else
        positive_part(slice1cost_difference_2_6);
      slice1cost_pair_0_7_choice := slice1cost_reverse_0_7 when slice1cost_difference_2_7 < 0 else
        positive_part(slice1cost_difference_2_7);
      slice1cost_pair_1_0_choice := slice1cost_reverse_1_0 when slice1cost_difference_4_0 < 0 else
        positive_part(slice1cost_difference_4_0);
      slice1cost_pair_1_1_choice := slice1cost_reverse_1_1 when slice1cost_difference_4_1 < 0 else
        positive_part(slice1cost_difference_4_1);
      slice1cost_pair_1_2_choice := slice1cost_reverse_1_2 when slice1cost_difference_4_2 < 0 else
        positive_part(slice1cost_difference_4_2);
      slice1cost_pair_1_3_choice := slice1cost_reverse_1_3 when slice1cost_difference_4_3 < 0 else
        positive_part(slice1cost_difference_4_3);
      slice1cost_pair_1_4_choice := slice1cost_reverse_1_4 when slice1cost_difference_4_4 < 0 else
        positive_part(slice1cost_difference_4_4);
      slice1cost_pair_1_5_choice := slice1cost_reverse_1_5 when slice1cost_difference_4_5 < 0 else
        positive_part(slice1cost_difference_4_5);
      slice1cost_pair_1_6_choice := slice1cost_reverse_1_6 when slice1cost_difference_4_6 < 0 else
        positive_part(slice1cost_difference_4_6);
      slice1cost_pair_1_7_choice := slice1cost_reverse_1_7 when slice1cost_difference_4_7 < 0 else
        positive_part(slice1cost_difference_4_7);
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_0_3 <= slice1shift_search_0_3 - slice1shift_reference_0;
      slice1cost_difference_0_4 <= slice1shift_search_0_4 - slice1shift_reference_0;
      slice1cost_difference_0_5 <= slice1shift_search_0_5 - slice1shift_reference_0;
      slice1cost_difference_0_6 <= slice1shift_search_0_6 - slice1shift_reference_0;
      slice1cost_difference_0_7 <= slice1shift_search_0_7 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_1_3 <= slice1shift_search_1_3 - slice1shift_reference_1;
      slice1cost_difference_1_4 <= slice1shift_search_1_4 - slice1shift_reference_1;
      slice1cost_difference_1_5 <= slice1shift_search_1_5 - slice1shift_reference_1;
      slice1cost_difference_1_6 <= slice1shift_search_1_6 - slice1shift_reference_1;
      slice1cost_difference_1_7 <= slice1shift_search_1_7 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_difference_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_difference_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_difference_2_3 <= slice1shift_search_2_3 - slice1shift_reference_2;
      slice1cost_difference_2_4 <= slice1shift_search_2_4 - slice1shift_reference_2;
      slice1cost_difference_2_5 <= slice1shift_search_2_5 - slice1shift_reference_2;
      slice1cost_difference_2_6 <= slice1shift_search_2_6 - slice1shift_reference_2;
      slice1cost_difference_2_7 <= slice1shift_search_2_7 - slice1shift_reference_2;
      slice1cost_difference_3_0 <= slice1shift_search_3_0 - slice1shift_reference_3;
      slice1cost_difference_3_1 <= slice1shift_search_3_1 - slice1shift_reference_3;
      slice1cost_difference_3_2 <= slice1shift_search_3_2 - slice1shift_reference_3;
      slice1cost_difference_3_3 <= slice1shift_search_3_3 - slice1shift_reference_3;
      slice1cost_difference_3_4 <= slice1shift_search_3_4 - slice1shift_reference_3;
      slice1cost_difference_3_5 <= slice1shift_search_3_5 - slice1shift_reference_3;
      slice1cost_difference_3_6 <= slice1shift_search_3_6 - slice1shift_reference_3;
      slice1cost_difference_3_7 <= slice1shift_search_3_7 - slice1shift_reference_3;
      slice1cost_difference_4_0 <= slice1shift_search_4_0 - slice1shift_reference_4;
      slice1cost_difference_4_1 <= slice1shift_search_4_1 - slice1shift_reference_4;
      slice1cost_difference_4_2 <= slice1shift_search_4_2 - slice1shift_reference_4;
      slice1cost_difference_4_3 <= slice1shift_search_4_3 - slice1shift_reference_4;
      slice1cost_difference_4_4 <= slice1shift_search_4_4 - slice1shift_reference_4;
      slice1cost_difference_4_5 <= slice1shift_search_4_5 - slice1shift_reference_4;
      slice1cost_difference_4_6 <= slice1shift_search_4_6 - slice1shift_reference_4;
      slice1cost_difference_4_7 <= slice1shift_search_4_7 - slice1shift_reference_4;
      slice1cost_reverse_0_0 <= (slice1shift_reference_2 - slice1shift_search_2_0) mod 256;
      slice1cost_reverse_0_1 <= (slice1shift_reference_2 - slice1shift_search_2_1) mod 256;
      slice1cost_reverse_0_2 <= (slice1shift_reference_2 - slice1shift_search_2_2) mod 256;
      slice1cost_reverse_0_3 <= (slice1shift_reference_2 - slice1shift_search_2_3) mod 256;
      slice1cost_reverse_0_4 <= (slice1shift_reference_2 - slice1shift_search_2_4) mod 256;
      slice1cost_reverse_0_5 <= (slice1shift_reference_2 - slice1shift_search_2_5) mod 256;
      slice1cost_reverse_0_6 <= (slice1shift_reference_2 - slice1shift_search_2_6) mod 256;
      slice1cost_reverse_0_7 <= (slice1shift_reference_2 - slice1shift_search_2_7) mod 256;
      slice1cost_reverse_1_0 <= (slice1shift_reference_4 - slice1shift_search_4_0) mod 256;
      slice1cost_reverse_1_1 <= (slice1shift_reference_4 - slice1shift_search_4_1) mod 256;
      slice1cost_reverse_1_2 <= (slice1shift_reference_4 - slice1shift_search_4_2) mod 256;
      slice1cost_reverse_1_3 <= (slice1shift_reference_4 - slice1shift_search_4_3) mod 256;
      slice1cost_reverse_1_4 <= (slice1shift_reference_4 - slice1shift_search_4_4) mod 256;
      slice1cost_reverse_1_5 <= (slice1shift_reference_4 - slice1shift_search_4_5) mod 256;
      slice1cost_reverse_1_6 <= (slice1shift_reference_4 - slice1shift_search_4_6) mod 256;
      slice1cost_reverse_1_7 <= (slice1shift_reference_4 - slice1shift_search_4_7) mod 256;
      slice1cost_pair_0_0 <= slice1cost_pair_0_0_choice + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= slice1cost_pair_0_1_choice + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= slice1cost_pair_0_2_choice + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_pair_0_3 <= slice1cost_pair_0_3_choice + folded(slice1cost_difference_1_3) +
        as_number((slice1cost_difference_1_3 < 0));
      slice1cost_pair_0_4 <= slice1cost_pair_0_4_choice + folded(slice1cost_difference_1_4) +
        as_number((slice1cost_difference_1_4 < 0));
      slice1cost_pair_0_5 <= slice1cost_pair_0_5_choice + folded(slice1cost_difference_1_5) +
        as_number((slice1cost_difference_1_5 < 0));
      slice1cost_pair_0_6 <= slice1cost_pair_0_6_choice + folded(slice1cost_difference_1_6) +
        as_number((slice1cost_difference_1_6 < 0));
      slice1cost_pair_0_7 <= slice1cost_pair_0_7_choice + folded(slice1cost_difference_1_7) +
        as_number((slice1cost_difference_1_7 < 0));
      slice1cost_pair_1_0 <= slice1cost_pair_1_0_choice + folded(slice1cost_difference_3_0) +
        as_number((slice1cost_difference_3_0 < 0));
      slice1cost_pair_1_1 <= slice1cost_pair_1_1_choice + folded(slice1cost_difference_3_1) +
        as_number((slice1cost_difference_3_1 < 0));
      slice1cost_pair_1_2 <= slice1cost_pair_1_2_choice + folded(slice1cost_difference_3_2) +
        as_number((slice1cost_difference_3_2 < 0));
      slice1cost_pair_1_3 <= slice1cost_pair_1_3_choice + folded(slice1cost_difference_3_3) +
        as_number((slice1cost_difference_3_3 < 0));
      slice1cost_pair_1_4 <= slice1cost_pair_1_4_choice + folded(slice1cost_difference_3_4) +
        as_number((slice1cost_difference_3_4 < 0));
      slice1cost_pair_1_5 <= slice1cost_pair_1_5_choice + folded(slice1cost_difference_3_5) +
        as_number((slice1cost_difference_3_5 < 0));
      slice1cost_pair_1_6 <= slice1cost_pair_1_6_choice + folded(slice1cost_difference_3_6) +
        as_number((slice1cost_difference_3_6 < 0));
      slice1cost_pair_1_7 <= slice1cost_pair_1_7_choice + folded(slice1cost_difference_3_7) +
        as_number((slice1cost_difference_3_7 < 0));
      slice1cost_single_0_0 <= folded(slice1cost_difference_0_0);
      slice1cost_single_0_1 <= folded(slice1cost_difference_0_1);
      slice1cost_single_0_2 <= folded(slice1cost_difference_0_2);
      slice1cost_single_0_3 <= folded(slice1cost_difference_0_3);
      slice1cost_single_0_4 <= folded(slice1cost_difference_0_4);
      slice1cost_single_0_5 <= folded(slice1cost_difference_0_5);
      slice1cost_single_0_6 <= folded(slice1cost_difference_0_6);
      slice1cost_single_0_7 <= folded(slice1cost_difference_0_7);
      slice1cost_negative_0_0 <= slice1cost_difference_0_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_0_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_0_2 < 0;
      slice1cost_negative_0_3 <= slice1cost_difference_0_3 < 0;
      slice1cost_negative_0_4 <= slice1cost_difference_0_4 < 0;
      slice1cost_negative_0_5 <= slice1cost_difference_0_5 < 0;
      slice1cost_negative_0_6 <= slice1cost_difference_0_6 < 0;
      slice1cost_negative_0_7 <= slice1cost_difference_0_7 < 0;
      slice1cost_column_0_0 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_0) +
        slice1cost_pair_1_0 + slice1cost_pair_0_0 + slice1cost_single_0_0;
      slice1cost_column_0_1 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_1) +
        slice1cost_pair_1_1 + slice1cost_pair_0_1 + slice1cost_single_0_1;
      slice1cost_column_0_2 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_2) +
        slice1cost_pair_1_2 + slice1cost_pair_0_2 + slice1cost_single_0_2;
      slice1cost_column_0_3 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_3) +
        slice1cost_pair_1_3 + slice1cost_pair_0_3 + slice1cost_single_0_3;
      slice1cost_column_0_4 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_4) +
        slice1cost_pair_1_4 + slice1cost_pair_0_4 + slice1cost_single_0_4;
      slice1cost_column_0_5 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_5) +
        slice1cost_pair_1_5 + slice1cost_pair_0_5 + slice1cost_single_0_5;
      slice1cost_column_0_6 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_6) +
        slice1cost_pair_1_6 + slice1cost_pair_0_6 + slice1cost_single_0_6;
      slice1cost_column_0_7 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_7) +
        slice1cost_pair_1_7 + slice1cost_pair_0_7 + slice1cost_single_0_7;
      if slice0cost_tag_valid then
        slice1cost_tag_first_cost <= slice0cost_tag_first_cost;
        slice1cost_tag_output_column <= slice0cost_tag_output_column;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_0_3 <= slice1cost_column_0_3;
        slice1window_partial_0_0_4 <= slice1cost_column_0_4;
        slice1window_partial_0_0_5 <= slice1cost_column_0_5;
        slice1window_partial_0_0_6 <= slice1cost_column_0_6;
        slice1window_partial_0_0_7 <= slice1cost_column_0_7;
        slice1window_partial_0_1_0 <= slice1cost_column_0_0 + slice1window_partial_0_0_0;
        slice1window_partial_0_1_1 <= slice1cost_column_0_1 + slice1window_partial_0_0_1;
        slice1window_partial_0_1_2 <= slice1cost_column_0_2 + slice1window_partial_0_0_2;
        slice1window_partial_0_1_3 <= slice1cost_column_0_3 + slice1window_partial_0_0_3;
        slice1window_partial_0_1_4 <= slice1cost_column_0_4 + slice1window_partial_0_0_4;
        slice1window_partial_0_1_5 <= slice1cost_column_0_5 + slice1window_partial_0_0_5;
        slice1window_partial_0_1_6 <= slice1cost_column_0_6 + slice1window_partial_0_0_6;
        slice1window_partial_0_1_7 <= slice1cost_column_0_7 + slice1window_partial_0_0_7;
        slice1window_partial_0_2_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
        slice1window_partial_0_2_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
        slice1window_partial_0_2_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
        slice1window_partial_0_2_3 <= slice1cost_column_0_3 + slice1window_partial_0_1_3;
        slice1window_partial_0_2_4 <= slice1cost_column_0_4 + slice1window_partial_0_1_4;
        slice1window_partial_0_2_5 <= slice1cost_column_0_5 + slice1window_partial_0_1_5;
        slice1window_partial_0_2_6 <= slice1cost_column_0_6 + slice1window_partial_0_1_6;
        slice1window_partial_0_2_7 <= slice1cost_column_0_7 + slice1window_partial_0_1_7;
        slice1window_partial_0_3_0 <= slice1cost_column_0_0 + slice1window_partial_0_2_0;
        slice1window_partial_0_3_1 <= slice1cost_column_0_1 + slice1window_partial_0_2_1;
        slice1window_partial_0_3_2 <= slice1cost_column_0_2 + slice1window_partial_0_2_2;
        slice1window_partial_0_3_3 <= slice1cost_column_0_3 + slice1window_partial_0_2_3;
        slice1window_partial_0_3_4 <= slice1cost_column_0_4 + slice1window_partial_0_2_4;
        slice1window_partial_0_3_5 <= slice1cost_column_0_5 + slice1window_partial_0_2_5;
        slice1window_partial_0_3_6 <= slice1cost_column_0_6 + slice1window_partial_0_2_6;
        slice1window_partial_0_3_7 <= slice1cost_column_0_7 + slice1window_partial_0_2_7;
        slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
        slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
        slice1window_centre_output_column_1 <= slice1window_centre_output_column_0;
        slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
        slice1window_centre_first_column_1 <= slice1window_centre_first_column_0;
        slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      end if;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_3_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_3_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_3_2;
      slice1window_sum_0_3 <= slice1cost_column_0_3 + slice1window_partial_0_3_3;
      slice1window_sum_0_4 <= slice1cost_column_0_4 + slice1window_partial_0_3_4;
      slice1window_sum_0_5 <= slice1cost_column_0_5 + slice1window_partial_0_3_5;
      slice1window_sum_0_6 <= slice1cost_column_0_6 + slice1window_partial_0_3_6;
      slice1window_sum_0_7 <= slice1cost_column_0_7 + slice1window_partial_0_3_7;
      -- slice1other
      slice1other_cost_0_1_any := (not slice0winner1_tag_first_column) or (not slice0winner1_tag_output_column);
      slice1other_cost_0_1_is_not_less := slice1other_cost_0_2 >= slice1window_sum_0_1;
      slice1other_cost_0_1_choice := slice1window_sum_0_1 when slice1other_cost_0_1_is_not_less else
        slice1other_cost_0_2;
      slice1other_cost_0_1_choice_2 := slice1other_cost_0_1_choice when slice0winner1_tag_valid else
        slice1other_cost_0_1;
      slice1other_cost_0_1_choice_3 := slice1other_cost_0_2 when slice0winner1_tag_valid else slice1other_cost_0_1;
      slice1other_cost_0_1_choice_4 := slice1other_cost_0_1_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_1_choice_3;
      slice1other_cost_0_1_choice_5 := slice1window_sum_0_1 when slice0winner1_tag_valid else slice1other_cost_0_1;
      slice1other_cost_0_2_is_not_less := slice1other_cost_0_3 >= slice1window_sum_0_2;
      slice1other_cost_0_2_choice := slice1window_sum_0_2 when slice1other_cost_0_2_is_not_less else
        slice1other_cost_0_3;
      slice1other_cost_0_2_choice_2 := slice1other_cost_0_2_choice when slice0winner1_tag_valid else
        slice1other_cost_0_2;
      slice1other_cost_0_2_choice_3 := slice1other_cost_0_3 when slice0winner1_tag_valid else slice1other_cost_0_2;
      slice1other_cost_0_2_choice_4 := slice1other_cost_0_2_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_2_choice_3;
      slice1other_cost_0_2_choice_5 := slice1window_sum_0_2 when slice0winner1_tag_valid else slice1other_cost_0_2;
      slice1other_cost_0_3_is_not_less := slice1other_cost_0_4 >= slice1window_sum_0_3;
      slice1other_cost_0_3_choice := slice1window_sum_0_3 when slice1other_cost_0_3_is_not_less else
        slice1other_cost_0_4;
      slice1other_cost_0_3_choice_2 := slice1other_cost_0_3_choice when slice0winner1_tag_valid else
        slice1other_cost_0_3;
      slice1other_cost_0_3_choice_3 := slice1other_cost_0_4 when slice0winner1_tag_valid else slice1other_cost_0_3;
      slice1other_cost_0_3_choice_4 := slice1other_cost_0_3_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_3_choice_3;
      slice1other_cost_0_3_choice_5 := slice1window_sum_0_3 when slice0winner1_tag_valid else slice1other_cost_0_3;
      slice1other_cost_0_4_is_not_less := slice1other_cost_0_5 >= slice1window_sum_0_4;
      slice1other_cost_0_4_choice := slice1window_sum_0_4 when slice1other_cost_0_4_is_not_less else
        slice1other_cost_0_5;
      slice1other_cost_0_4_choice_2 := slice1other_cost_0_4_choice when slice0winner1_tag_valid else
        slice1other_cost_0_4;
      slice1other_cost_0_4_choice_3 := slice1other_cost_0_5 when slice0winner1_tag_valid else slice1other_cost_0_4;
      slice1other_cost_0_4_choice_4 := slice1other_cost_0_4_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_4_choice_3;
      slice1other_cost_0_4_choice_5 := slice1window_sum_0_4 when slice0winner1_tag_valid else slice1other_cost_0_4;
      slice1other_cost_0_5_is_not_less := slice1other_cost_0_6 >= slice1window_sum_0_5;
      slice1other_cost_0_5_choice := slice1window_sum_0_5 when slice1other_cost_0_5_is_not_less else
        slice1other_cost_0_6;
      slice1other_cost_0_5_choice_2 := slice1other_cost_0_5_choice when slice0winner1_tag_valid else
        slice1other_cost_0_5;
      slice1other_cost_0_5_choice_3 := slice1other_cost_0_6 when slice0winner1_tag_valid else slice1other_cost_0_5;
      slice1other_cost_0_5_choice_4 := slice1other_cost_0_5_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_5_choice_3;
      slice1other_cost_0_5_choice_5 := slice1window_sum_0_5 when slice0winner1_tag_valid else slice1other_cost_0_5;
      slice1other_cost_0_6_is_not_less := slice1other_cost_0_7 >= slice1window_sum_0_6;
      slice1other_cost_0_6_choice := slice1window_sum_0_6 when slice1other_cost_0_6_is_not_less else
        slice1other_cost_0_7;
      slice1other_cost_0_6_choice_2 := slice1other_cost_0_6_choice when slice0winner1_tag_valid else
        slice1other_cost_0_6;
      slice1other_cost_0_6_choice_3 := slice1other_cost_0_7 when slice0winner1_tag_valid else slice1other_cost_0_6;
      slice1other_cost_0_6_choice_4 := slice1other_cost_0_6_choice_2 when slice0winner1_tag_output_column else
        slice1other_cost_0_6_choice_3;
      slice1other_cost_0_6_choice_5 := slice1window_sum_0_6 when slice0winner1_tag_valid else slice1other_cost_0_6;
      slice1other_winner_0_0_choice := 0 when slice1other_cost_0_1 >= slice1window_sum_0_0 else slice1other_winner_0_1;
      slice1other_winner_0_0_choice_2 := slice1other_winner_0_0_choice when slice0winner1_tag_valid else
        slice1other_winner_0_0;
      slice1other_winner_0_0_choice_3 := slice1other_winner_0_1 when slice0winner1_tag_valid else
        slice1other_winner_0_0;
      slice1other_winner_0_0_choice_4 := slice1other_winner_0_0_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_0_choice_3;
      slice1other_winner_0_0_choice_5 := 0 when slice0winner1_tag_valid else slice1other_winner_0_0;
      slice1other_winner_0_1_choice := 1 when slice1other_cost_0_1_is_not_less else slice1other_winner_0_2;
      slice1other_winner_0_1_choice_2 := slice1other_winner_0_1_choice when slice0winner1_tag_valid else
        slice1other_winner_0_1;
      slice1other_winner_0_1_choice_3 := slice1other_winner_0_2 when slice0winner1_tag_valid else
        slice1other_winner_0_1;
      slice1other_winner_0_1_choice_4 := slice1other_winner_0_1_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_1_choice_3;
      slice1other_winner_0_1_choice_5 := 1 when slice0winner1_tag_valid else slice1other_winner_0_1;
      slice1other_winner_0_2_choice := 2 when slice1other_cost_0_2_is_not_less else slice1other_winner_0_3;
      slice1other_winner_0_2_choice_2 := slice1other_winner_0_2_choice when slice0winner1_tag_valid else
        slice1other_winner_0_2;
      slice1other_winner_0_2_choice_3 := slice1other_winner_0_3 when slice0winner1_tag_valid else
        slice1other_winner_0_2;
      slice1other_winner_0_2_choice_4 := slice1other_winner_0_2_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_2_choice_3;
      slice1other_winner_0_2_choice_5 := 2 when slice0winner1_tag_valid else slice1other_winner_0_2;
      slice1other_winner_0_3_choice := 3 when slice1other_cost_0_3_is_not_less else slice1other_winner_0_4;
      slice1other_winner_0_3_choice_2 := slice1other_winner_0_3_choice when slice0winner1_tag_valid else
        slice1other_winner_0_3;
      slice1other_winner_0_3_choice_3 := slice1other_winner_0_4 when slice0winner1_tag_valid else
        slice1other_winner_0_3;
      slice1other_winner_0_3_choice_4 := slice1other_winner_0_3_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_3_choice_3;
      slice1other_winner_0_3_choice_5 := 3 when slice0winner1_tag_valid else slice1other_winner_0_3;
      slice1other_winner_0_4_choice := 4 when slice1other_cost_0_4_is_not_less else slice1other_winner_0_5;
      slice1other_winner_0_4_choice_2 := slice1other_winner_0_4_choice when slice0winner1_tag_valid else
        slice1other_winner_0_4;
      slice1other_winner_0_4_choice_3 := slice1other_winner_0_5 when slice0winner1_tag_valid else
        slice1other_winner_0_4;
      slice1other_winner_0_4_choice_4 := slice1other_winner_0_4_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_4_choice_3;
      slice1other_winner_0_4_choice_5 := 4 when slice0winner1_tag_valid else slice1other_winner_0_4;
      slice1other_winner_0_5_choice := 5 when slice1other_cost_0_5_is_not_less else slice1other_winner_0_6;
      slice1other_winner_0_5_choice_2 := slice1other_winner_0_5_choice when slice0winner1_tag_valid else
        slice1other_winner_0_5;
      slice1other_winner_0_5_choice_3 := slice1other_winner_0_6 when slice0winner1_tag_valid else
        slice1other_winner_0_5;
      slice1other_winner_0_5_choice_4 := slice1other_winner_0_5_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_5_choice_3;
      slice1other_winner_0_5_choice_5 := 5 when slice0winner1_tag_valid else slice1other_winner_0_5;
      slice1other_winner_0_6_choice := 6 when slice1other_cost_0_6_is_not_less else slice1other_winner_0_7;
      slice1other_winner_0_6_choice_2 := slice1other_winner_0_6_choice when slice0winner1_tag_valid else
        slice1other_winner_0_6;
      slice1other_winner_0_6_choice_3 := slice1other_winner_0_7 when slice0winner1_tag_valid else
        slice1other_winner_0_6;
      slice1other_winner_0_6_choice_4 := slice1other_winner_0_6_choice_2 when slice0winner1_tag_output_column else
        slice1other_winner_0_6_choice_3;
      slice1other_winner_0_6_choice_5 := 6 when slice0winner1_tag_valid else slice1other_winner_0_6;
      slice1other_cost_0_1 <= slice1other_cost_0_1_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_1_choice_5;
      slice1other_cost_0_2 <= slice1other_cost_0_2_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_2_choice_5;
      slice1other_cost_0_3 <= slice1other_cost_0_3_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_3_choice_5;
      slice1other_cost_0_4 <= slice1other_cost_0_4_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_4_choice_5;
      slice1other_cost_0_5 <= slice1other_cost_0_5_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_5_choice_5;
      slice1other_cost_0_6 <= slice1other_cost_0_6_choice_4 when slice1other_cost_0_1_any else
        slice1other_cost_0_6_choice_5;
      slice1other_winner_0_0 <= slice1other_winner_0_0_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_0_choice_5;
      slice1other_winner_0_1 <= slice1other_winner_0_1_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_1_choice_5;
      slice1other_winner_0_2 <= slice1other_winner_0_2_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_2_choice_5;
      slice1other_winner_0_3 <= slice1other_winner_0_3_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_3_choice_5;
      slice1other_winner_0_4 <= slice1other_winner_0_4_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_4_choice_5;
      slice1other_winner_0_5 <= slice1other_winner_0_5_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_5_choice_5;
      slice1other_winner_0_6 <= slice1other_winner_0_6_choice_4 when slice1other_cost_0_1_any else
        slice1other_winner_0_6_choice_5;
      slice1other_winner_out_0 <= slice1other_winner_0_0;
      slice1other_cost_0_7_is_not_less := slice0other_cost_out_0 >= slice1window_sum_0_7;
      slice1other_cost_0_7_choice := slice1window_sum_0_7 when slice1other_cost_0_7_is_not_less else
        slice0other_cost_out_0;
      slice1other_cost_0_7_choice_2 := slice1other_cost_0_7_choice when slice0winner1_tag_output_column else
        slice0other_cost_out_0;
      slice1other_winner_0_7_choice := 7 when slice1other_cost_0_7_is_not_less else slice0other_winner_out_0;
      slice1other_winner_0_7_choice_2 := slice1other_winner_0_7_choice when slice0winner1_tag_output_column else
        slice0other_winner_out_0;
      if slice0winner1_tag_valid then
        slice1other_cost_0_7 <= slice1other_cost_0_7_choice_2 when slice1other_cost_0_1_any else slice1window_sum_0_7;
        slice1other_winner_0_7 <= slice1other_winner_0_7_choice_2 when slice1other_cost_0_1_any else 7;
      end if;
      -- slice1winner1
      slice1winner1_best_cost_0_0_is_less := slice1window_sum_0_1 < slice1window_sum_0_0;
      slice1winner1_best_cost_0_1_is_less := slice1window_sum_0_3 < slice1window_sum_0_2;
      slice1winner1_best_cost_0_2_is_less := slice1window_sum_0_5 < slice1window_sum_0_4;
      slice1winner1_best_cost_0_3_is_less := slice1window_sum_0_7 < slice1window_sum_0_6;
      slice1winner1_best_cost_0_0 <= slice1window_sum_0_1 when slice1winner1_best_cost_0_0_is_less else
        slice1window_sum_0_0;
      slice1winner1_best_cost_0_1 <= slice1window_sum_0_3 when slice1winner1_best_cost_0_1_is_less else
        slice1window_sum_0_2;
      slice1winner1_best_cost_0_2 <= slice1window_sum_0_5 when slice1winner1_best_cost_0_2_is_less else
        slice1window_sum_0_4;
      slice1winner1_best_cost_0_3 <= slice1window_sum_0_7 when slice1winner1_best_cost_0_3_is_less else
        slice1window_sum_0_6;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_index_0_1 <= 3 when slice1winner1_best_cost_0_1_is_less else 2;
      slice1winner1_best_index_0_2 <= 5 when slice1winner1_best_cost_0_2_is_less else 4;
      slice1winner1_best_index_0_3 <= 7 when slice1winner1_best_cost_0_3_is_less else 6;
      slice1winner1_best_below_0_0 <= slice1window_sum_0_0 mod 2048 when slice1winner1_best_cost_0_0_is_less else 0;
      slice1winner1_best_below_0_1 <= slice1window_sum_0_2 mod 2048 when slice1winner1_best_cost_0_1_is_less else 0;
      slice1winner1_best_below_0_2 <= slice1window_sum_0_4 mod 2048 when slice1winner1_best_cost_0_2_is_less else 0;
      slice1winner1_best_below_0_3 <= slice1window_sum_0_6 mod 2048 when slice1winner1_best_cost_0_3_is_less else 0;
      slice1winner1_best_above_0_0 <= 0 when slice1winner1_best_cost_0_0_is_less else slice1window_sum_0_1 mod 2048;
      slice1winner1_best_above_0_1 <= 0 when slice1winner1_best_cost_0_1_is_less else slice1window_sum_0_3 mod 2048;
      slice1winner1_best_above_0_2 <= 0 when slice1winner1_best_cost_0_2_is_less else slice1window_sum_0_5 mod 2048;
      slice1winner1_best_above_0_3 <= 0 when slice1winner1_best_cost_0_3_is_less else slice1window_sum_0_7 mod 2048;
      slice1winner1_best_first_0_0 <= slice1window_sum_0_0 mod 2048 when slice1window_sum_0_0 < 2047 else 2047;
      slice1winner1_best_first_0_1 <= slice1window_sum_0_2 mod 2048 when slice1window_sum_0_2 < 2047 else 2047;
      slice1winner1_best_first_0_2 <= slice1window_sum_0_4 mod 2048;
      slice1winner1_best_first_0_3 <= slice1window_sum_0_6 mod 2048 when slice1window_sum_0_6 < 2047 else 2047;
      slice1winner1_best_last_0_0 <= slice1window_sum_0_1 mod 2048;
      slice1winner1_best_last_0_1 <= slice1window_sum_0_3 mod 2048;
      slice1winner1_best_last_0_2 <= slice1window_sum_0_5 mod 2048 when slice1window_sum_0_5 < 2047 else 2047;
      slice1winner1_best_last_0_3 <= slice1window_sum_0_7 mod 2048;
      slice1winner1_best_but_first_0_1 <= slice1window_sum_0_3 mod 2048 when slice1window_sum_0_3 < 2047 else 2047;
      slice1winner1_best_but_first_0_2 <= slice1window_sum_0_5 mod 2048;
      slice1winner1_best_but_first_0_3 <= slice1window_sum_0_7 mod 2048 when slice1window_sum_0_7 < 2047 else 2047;
      slice1winner1_best_but_last_0_1 <= slice1window_sum_0_2 mod 2048;
      slice1winner1_best_but_last_0_2 <= slice1window_sum_0_4 mod 2048 when slice1window_sum_0_4 < 2047 else 2047;
      slice1winner1_best_but_last_0_3 <= slice1window_sum_0_6 mod 2048;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := slice1winner1_best_cost_0_1 < slice1winner1_best_cost_0_0;
      slice1winner2_best_cost_0_1_is_less := slice1winner1_best_cost_0_3 < slice1winner1_best_cost_0_2;
      slice1winner2_best_below_0_0_is_equal := slice1winner1_best_index_0_1 = 2;
      slice1winner2_best_below_0_0_choice := slice1winner1_best_last_0_0 when slice1winner2_best_below_0_0_is_equal
        else slice1winner1_best_below_0_1;
      slice1winner2_best_below_0_1_is_equal := slice1winner1_best_index_0_3 = 6;
      slice1winner2_best_below_0_1_choice := slice1winner1_best_but_first_0_2 when
        slice1winner2_best_below_0_1_is_equal else slice1winner1_best_below_0_3;
      slice1winner2_best_above_0_0_choice := slice1winner1_best_but_last_0_1 when slice1winner1_best_index_0_0 else
        slice1winner1_best_above_0_0;
      slice1winner2_best_above_0_1_choice := slice1winner1_best_but_last_0_3 when other_2 else
        slice1winner1_best_above_0_2;
      if slice1winner2_best_below_0_0_is_equal then
        slice1winner2_best_second_0_0_choice := slice1winner1_best_first_0_0;
      else
        slice1winner2_best_second_0_0_choice := slice1winner1_best_cost_0_0;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_but_first_0_1;
      else
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_cost_0_1;
      end if;
      slice1winner2_best_second_0_0_choice_3 := slice1winner2_best_second_0_0_choice when
        slice1winner2_best_cost_0_0_is_less else slice1winner2_best_second_0_0_choice_2;
      slice1winner2_best_second_0_0_choice_4 := slice1winner1_best_first_0_0 when slice1winner2_best_below_0_0_is_equal
        else slice1winner1_best_cost_0_0 mod 2048;
      slice1winner2_best_second_0_0_choice_5 := slice1winner1_best_but_first_0_1 when slice1winner1_best_index_0_0 else
        slice1winner1_best_cost_0_1 mod 2048;
      slice1winner2_best_second_0_0_choice_6 := slice1winner2_best_second_0_0_choice_4 when
        slice1winner2_best_cost_0_0_is_less else slice1winner2_best_second_0_0_choice_5;
      if slice1winner2_best_below_0_1_is_equal then
        slice1winner2_best_second_0_1_choice := slice1winner1_best_but_last_0_2;
      else
        slice1winner2_best_second_0_1_choice := slice1winner1_best_cost_0_2;
      end if;
      if other_2 then
        slice1winner2_best_second_0_1_choice_2 := slice1winner1_best_but_first_0_3;
      else
        slice1winner2_best_second_0_1_choice_2 := slice1winner1_best_cost_0_3;
      end if;
      slice1winner2_best_second_0_1_choice_3 := slice1winner2_best_second_0_1_choice when
        slice1winner2_best_cost_0_1_is_less else slice1winner2_best_second_0_1_choice_2;
      slice1winner2_best_second_0_1_choice_4 := slice1winner1_best_but_last_0_2 when
        slice1winner2_best_below_0_1_is_equal else slice1winner1_best_cost_0_2 mod 2048;
      slice1winner2_best_second_0_1_choice_5 := slice1winner1_best_but_first_0_3 when other_2 else
        slice1winner1_best_cost_0_3 mod 2048;
      slice1winner2_best_second_0_1_choice_6 := slice1winner2_best_second_0_1_choice_4 when
        slice1winner2_best_cost_0_1_is_less else slice1winner2_best_second_0_1_choice_5;
      slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1 when slice1winner2_best_cost_0_0_is_less else
        slice1winner1_best_cost_0_0;
      slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_3 when slice1winner2_best_cost_0_1_is_less else
        slice1winner1_best_cost_0_2;
      slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1 when slice1winner2_best_cost_0_0_is_less else
        as_number(slice1winner1_best_index_0_0);
      slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3 when slice1winner2_best_cost_0_1_is_less else
        slice1winner1_best_index_0_2;
      slice1winner2_best_below_0_0 <= slice1winner2_best_below_0_0_choice when slice1winner2_best_cost_0_0_is_less else
        slice1winner1_best_below_0_0;
      slice1winner2_best_below_0_1 <= slice1winner2_best_below_0_1_choice when slice1winner2_best_cost_0_1_is_less else
        slice1winner1_best_below_0_2;
      slice1winner2_best_above_0_0 <= slice1winner1_best_above_0_1 when slice1winner2_best_cost_0_0_is_less else
        slice1winner2_best_above_0_0_choice;
      slice1winner2_best_above_0_1 <= slice1winner1_best_above_0_3 when slice1winner2_best_cost_0_1_is_less else
        slice1winner2_best_above_0_1_choice;
      slice1winner2_best_first_0_1 <= slice1winner1_best_first_0_2;
      slice1winner2_best_last_0_0 <= slice1winner1_best_last_0_1;
      slice1winner2_best_last_0_1 <= slice1winner1_best_last_0_3;
      slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_6 when
        slice1winner2_best_second_0_0_choice_3 < slice0winner1_best_second_0_0 else slice0winner1_best_second_0_0;
      slice1winner2_best_second_0_1 <= slice1winner2_best_second_0_1_choice_6 when
        slice1winner2_best_second_0_1_choice_3 < slice0winner1_best_second_0_0 else slice0winner1_best_second_0_0;
      slice1winner2_best_but_first_0_1 <= slice1winner1_best_cost_0_3 mod 2048 when slice1winner1_best_cost_0_3 <
        slice1winner1_best_last_0_2 else slice1winner1_best_last_0_2;
      slice1winner2_best_but_last_0_0 <= slice1winner1_best_first_0_1 when slice1winner1_best_first_0_1 <
        slice1winner1_best_cost_0_0 else slice1winner1_best_cost_0_0 mod 2048;
      slice1winner2_best_but_last_0_1 <= slice1winner1_best_first_0_3 when slice1winner1_best_first_0_3 <
        slice1winner1_best_cost_0_2 else slice1winner1_best_cost_0_2 mod 2048;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := slice1winner2_best_cost_0_1 < slice1winner2_best_cost_0_0;
      slice1winner3_best_below_0_0_is_equal := slice1winner2_best_index_0_1 = 4;
      slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0 when slice1winner3_best_below_0_0_is_equal
        else slice1winner2_best_below_0_1;
      slice1winner3_best_above_0_0_is_equal := slice1winner2_best_index_0_0 = 3;
      slice1winner3_best_above_0_0_choice := slice1winner2_best_first_0_1 when slice1winner3_best_above_0_0_is_equal
        else slice1winner2_best_above_0_0;
      if slice1winner3_best_below_0_0_is_equal then
        slice1winner3_best_second_0_0_choice := slice1winner2_best_but_last_0_0;
      else
        slice1winner3_best_second_0_0_choice := slice1winner2_best_cost_0_0;
      end if;
      slice1winner3_best_second_0_0_choice_2 := slice1winner2_best_but_last_0_0 when
        slice1winner3_best_below_0_0_is_equal else slice1winner2_best_cost_0_0 mod 2048;
      slice1winner3_best_second_0_0_choice_3 := slice1winner3_best_second_0_0_choice_2 when
        slice1winner3_best_second_0_0_choice < slice1winner2_best_second_0_1 else slice1winner2_best_second_0_1;
      if slice1winner3_best_above_0_0_is_equal then
        slice1winner3_best_second_0_0_choice_4 := slice1winner2_best_but_first_0_1;
      else
        slice1winner3_best_second_0_0_choice_4 := slice1winner2_best_cost_0_1;
      end if;
      slice1winner3_best_second_0_0_choice_5 := slice1winner2_best_but_first_0_1 when
        slice1winner3_best_above_0_0_is_equal else slice1winner2_best_cost_0_1 mod 2048;
      slice1winner3_best_second_0_0_choice_6 := slice1winner3_best_second_0_0_choice_5 when
        slice1winner3_best_second_0_0_choice_4 < slice1winner2_best_second_0_0 else slice1winner2_best_second_0_0;
      slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_1 when slice1winner3_best_cost_0_0_is_less else
        slice1winner2_best_cost_0_0;
      slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1 when slice1winner3_best_cost_0_0_is_less else
        slice1winner2_best_index_0_0;
      slice1winner3_best_below_0_0 <= slice1winner3_best_below_0_0_choice when slice1winner3_best_cost_0_0_is_less else
        slice1winner2_best_below_0_0;
      slice1winner3_best_above_0_0 <= slice1winner2_best_above_0_1 when slice1winner3_best_cost_0_0_is_less else
        slice1winner3_best_above_0_0_choice;
      slice1winner3_best_last_0_0 <= slice1winner2_best_last_0_1;
      slice1winner3_best_second_0_0 <= slice1winner3_best_second_0_0_choice_3 when slice1winner3_best_cost_0_0_is_less
        else slice1winner3_best_second_0_0_choice_6;
      slice1winner3_best_but_last_0_0 <= slice1winner2_best_but_last_0_1 when slice1winner2_best_but_last_0_1 <
        slice1winner2_best_cost_0_0 else slice1winner2_best_cost_0_0 mod 2048;
      -- slice1
      slice1_best_cost_0_0_is_less := slice0_best_cost_0_0 < slice1winner3_best_cost_0_0;
      slice1_best_below_0_0_is_equal := slice0_best_index_0_0 = 8;
      slice1_best_below_0_0_choice := slice1winner3_best_last_0_0 when slice1_best_below_0_0_is_equal else
        slice0_best_below_0_0;
      slice1_best_above_0_0_is_equal := slice1winner3_best_index_0_0 = 7;
      slice1_best_above_0_0_choice := slice0_best_first_0_0 when slice1_best_above_0_0_is_equal else
        slice1winner3_best_above_0_0;
      if slice1_best_below_0_0_is_equal then
        slice1_best_second_0_0_choice := slice1winner3_best_but_last_0_0;
      else
        slice1_best_second_0_0_choice := slice1winner3_best_cost_0_0;
      end if;
      slice1_best_second_0_0_choice_2 := slice1_best_second_0_0_choice when slice1_best_second_0_0_choice <
        slice0_best_second_0_0 else slice0_best_second_0_0;
      if slice1_best_above_0_0_is_equal then
        slice1_best_second_0_0_choice_3 := slice0_best_but_first_0_0;
      else
        slice1_best_second_0_0_choice_3 := slice0_best_cost_0_0;
      end if;
      slice1_best_second_0_0_choice_4 := slice1_best_second_0_0_choice_3 when slice1_best_second_0_0_choice_3 <
        slice1winner3_best_second_0_0 else slice1winner3_best_second_0_0;
      slice1_best_cost_0_0 <= slice0_best_cost_0_0 when slice1_best_cost_0_0_is_less else slice1winner3_best_cost_0_0;
      slice1_best_index_0_0 <= slice0_best_index_0_0 when slice1_best_cost_0_0_is_less else
        slice1winner3_best_index_0_0;
      slice1_best_below_0_0 <= slice1_best_below_0_0_choice when slice1_best_cost_0_0_is_less else
        slice1winner3_best_below_0_0;
      slice1_best_above_0_0 <= slice0_best_above_0_0 when slice1_best_cost_0_0_is_less else
        slice1_best_above_0_0_choice;
      slice1_best_second_0_0 <= slice1_best_second_0_0_choice_2 when slice1_best_cost_0_0_is_less else
        slice1_best_second_0_0_choice_4;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      -- texture
      texture_taps_search_0_0 <= 31 when rows_inside_0 else 0;
      texture_taps_search_1_0 <= 31 when rows_inside_1 else 0;
      texture_taps_search_2_0 <= 31 when rows_inside_2 else 0;
      texture_taps_search_3_0 <= 31 when rows_inside_3 else 0;
      texture_taps_search_4_0 <= 31 when rows_inside_4 else 0;
      texture_passes_0_0 <= 59 < texturewindow_sum_0_0;
      texture_passes_1_0 <= texture_passes_0_0;
      texture_passes_2_0 <= texture_passes_1_0;
      texture_passes_3_0 <= texture_passes_2_0;
      texture_passes_4_0 <= texture_passes_3_0;
      -- texturecost
      texturecost_pair_0_0_choice := texturecost_reverse_0_0 when texturecost_difference_2_0 < 0 else
        positive_part(texturecost_difference_2_0);
      texturecost_pair_1_0_choice := texturecost_reverse_1_0 when texturecost_difference_4_0 < 0 else
        positive_part(texturecost_difference_4_0);
      texturecost_difference_0_0 <= texture_taps_search_0_0 - slice0shift_reference_0;
      texturecost_difference_1_0 <= texture_taps_search_1_0 - slice0shift_reference_1;
      texturecost_difference_2_0 <= texture_taps_search_2_0 - slice0shift_reference_2;
      texturecost_difference_3_0 <= texture_taps_search_3_0 - slice0shift_reference_3;
      texturecost_difference_4_0 <= texture_taps_search_4_0 - slice0shift_reference_4;
      texturecost_reverse_0_0 <= (slice0shift_reference_2 - texture_taps_search_2_0) mod 256;
      texturecost_reverse_1_0 <= (slice0shift_reference_4 - texture_taps_search_4_0) mod 256;
      texturecost_pair_0_0 <= texturecost_pair_0_0_choice + folded(texturecost_difference_1_0) +
        as_number((texturecost_difference_1_0 < 0));
      texturecost_pair_1_0 <= texturecost_pair_1_0_choice + folded(texturecost_difference_3_0) +
        as_number((texturecost_difference_3_0 < 0));
      texturecost_single_0_0 <= folded(texturecost_difference_0_0);
      texturecost_negative_0_0 <= texturecost_difference_0_0 < 0;
      texturecost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else as_number(texturecost_negative_0_0) +
        texturecost_pair_1_0 + texturecost_pair_0_0 + texturecost_single_0_0;
      -- texturewindow
      if slice0cost_tag_valid then
        texturewindow_partial_0_0_0 <= texturecost_column_0_0;
        texturewindow_partial_0_1_0 <= texturecost_column_0_0 + texturewindow_partial_0_0_0;
        texturewindow_partial_0_2_0 <= texturecost_column_0_0 + texturewindow_partial_0_1_0;
        texturewindow_partial_0_3_0 <= texturecost_column_0_0 + texturewindow_partial_0_2_0;
      end if;
      texturewindow_sum_0_0 <= texturecost_column_0_0 + texturewindow_partial_0_3_0;
      -- refinement
      refinement_remainder_0_0_choice := slice1_best_above_0_0 when slice1_best_index_0_0 = 0 else
        slice1_best_below_0_0;
      refinement_remainder_0_0_value := (refinement_remainder_0_0_choice - slice1_best_cost_0_0) mod 2048;
      refinement_remainder_0_0_choice_2 := slice1_best_below_0_0 when slice1_best_index_0_0 = 15 else
        slice1_best_above_0_0;
      refinement_remainder_0_0_value_2 := (refinement_remainder_0_0_choice_2 - slice1_best_cost_0_0) mod 2048;
      refinement_remainder_0_0_is_less := refinement_remainder_0_0_value < refinement_remainder_0_0_value_2;
      refinement_remainder_0_0_choice_3 := refinement_remainder_0_0_value_2 when refinement_remainder_0_0_is_less else
        refinement_remainder_0_0_value;
      refinement_remainder_0_0_choice_4 := refinement_remainder_0_0_value when refinement_remainder_0_0_is_less else
        refinement_remainder_0_0_value_2;
      refinement_remainder_1_0_is_not_less := refinement_remainder_0_0 >= refinement_divisor_0_0;
      refinement_remainder_1_0_choice := refinement_divisor_0_0 when refinement_remainder_1_0_is_not_less else 0;
      refinement_remainder_2_0_is_not_less := (refinement_remainder_1_0 * 2) >= refinement_divisor_1_0;
      refinement_remainder_2_0_choice := refinement_divisor_1_0 when refinement_remainder_2_0_is_not_less else 0;
      refinement_remainder_3_0_is_not_less := (refinement_remainder_2_0 * 2) >= refinement_divisor_2_0;
      refinement_remainder_3_0_choice := refinement_divisor_2_0 when refinement_remainder_3_0_is_not_less else 0;
      refinement_remainder_4_0_is_not_less := (refinement_remainder_3_0 * 2) >= refinement_divisor_3_0;
      refinement_remainder_4_0_choice := refinement_divisor_3_0 when refinement_remainder_4_0_is_not_less else 0;
      refinement_remainder_5_0_is_not_less := (refinement_remainder_4_0 * 2) >= refinement_divisor_4_0;
      refinement_remainder_5_0_choice := refinement_divisor_4_0 when refinement_remainder_5_0_is_not_less else 0;
      refinement_remainder_6_0_is_not_less := (refinement_remainder_5_0 * 2) >= refinement_divisor_5_0;
      refinement_remainder_6_0_choice := refinement_divisor_5_0 when refinement_remainder_6_0_is_not_less else 0;
      refinement_remainder_7_0_is_not_less := (refinement_remainder_6_0 * 2) >= refinement_divisor_6_0;
      refinement_remainder_7_0_choice := refinement_divisor_6_0 when refinement_remainder_7_0_is_not_less else 0;
      refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
      refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_8_0 then
        refinement_fraction_0_choice := refinement_fraction_0_difference mod 256;
      else
        refinement_fraction_0_choice := refinement_fraction_0_value;
      end if;
      if refinement_negative_8_0 then
        refinement_fraction_0_choice_2 := refinement_fraction_0_difference mod 8;
      else
        refinement_fraction_0_choice_2 := refinement_fraction_0_value mod 8;
      end if;
      refinement_disparity_0_0 <= slice1_best_index_0_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_disparity_4_0 <= refinement_disparity_3_0;
      refinement_disparity_5_0 <= refinement_disparity_4_0;
      refinement_disparity_6_0 <= refinement_disparity_5_0;
      refinement_disparity_7_0 <= refinement_disparity_6_0;
      refinement_disparity_8_0 <= refinement_disparity_7_0;
      refinement_disparity_9_0 <= refinement_disparity_8_0;
      refinement_passed_0_0 <= texture_passes_4_0;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0 when slice0cost_reverse_2_1 else refinement_passed_1_0 and
        (refinement_scaled_cost_0 < refinement_scaled_gap_0);
      refinement_passed_3_0 <= refinement_passed_2_0;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_tag_0_valid <= slice1_best_tag_valid;
      refinement_tag_0_map_column <= slice1_best_tag_map_column;
      refinement_tag_0_output_column <= slice1_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice1_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice1_best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_map_column <= refinement_tag_0_map_column;
      refinement_tag_1_output_column <= refinement_tag_0_output_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_map_column <= refinement_tag_1_map_column;
      refinement_tag_2_output_column <= refinement_tag_1_output_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_map_column <= refinement_tag_2_map_column;
      refinement_tag_3_output_column <= refinement_tag_2_output_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_map_column <= refinement_tag_3_map_column;
      refinement_tag_4_output_column <= refinement_tag_3_output_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_map_column <= refinement_tag_4_map_column;
      refinement_tag_5_output_column <= refinement_tag_4_output_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_map_column <= refinement_tag_5_map_column;
      refinement_tag_6_output_column <= refinement_tag_5_output_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_map_column <= refinement_tag_6_map_column;
      refinement_tag_7_output_column <= refinement_tag_6_output_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_map_column <= refinement_tag_7_map_column;
      refinement_tag_8_output_column <= refinement_tag_7_output_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_map_column <= refinement_tag_8_map_column;
      refinement_tag_9_output_column <= refinement_tag_8_output_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_cost_0 <= slice1_best_cost_0_0;
      refinement_gap_0 <= (slice1_best_second_0_0 - slice1_best_cost_0_0) mod 2048;
      refinement_scaled_gap_0 <= (refinement_gap_0 * 25) * 4;
      refinement_scaled_cost_0 <= refinement_cost_0 * 15;
      refinement_remainder_0_0 <= (refinement_remainder_0_0_choice_3 - refinement_remainder_0_0_choice_4) mod 2048;
      refinement_remainder_1_0 <= (refinement_remainder_0_0 - refinement_remainder_1_0_choice) mod 2048;
      refinement_remainder_2_0 <= (((refinement_remainder_1_0 mod 1024) * 2) - refinement_remainder_2_0_choice) mod
        2048;
      refinement_remainder_3_0 <= ((refinement_remainder_2_0 * 2) - refinement_remainder_3_0_choice) mod 2048;
      refinement_remainder_4_0 <= ((refinement_remainder_3_0 * 2) - refinement_remainder_4_0_choice) mod 2048;
      refinement_remainder_5_0 <= ((refinement_remainder_4_0 * 2) - refinement_remainder_5_0_choice) mod 2048;
      refinement_remainder_6_0 <= ((refinement_remainder_5_0 * 2) - refinement_remainder_6_0_choice) mod 2048;
      refinement_remainder_7_0 <= ((refinement_remainder_6_0 * 2) - refinement_remainder_7_0_choice) mod 2048;
      refinement_divisor_0_0 <= 1 when refinement_remainder_0_0_choice_3 = 0 else refinement_remainder_0_0_choice_3;
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_1_0 <= refinement_remainder_1_0_is_not_less;
      refinement_quotient_2_0 <= (as_number(refinement_quotient_1_0) * 2) +
        as_number(refinement_remainder_2_0_is_not_less);
      refinement_quotient_3_0 <= (refinement_quotient_2_0 * 2) + as_number(refinement_remainder_3_0_is_not_less);
      refinement_quotient_4_0 <= (refinement_quotient_3_0 * 2) + as_number(refinement_remainder_4_0_is_not_less);
      refinement_quotient_5_0 <= (refinement_quotient_4_0 * 2) + as_number(refinement_remainder_5_0_is_not_less);
      refinement_quotient_6_0 <= (refinement_quotient_5_0 * 2) + as_number(refinement_remainder_6_0_is_not_less);
      refinement_quotient_7_0 <= (refinement_quotient_6_0 * 2) + as_number(refinement_remainder_7_0_is_not_less);
      refinement_quotient_8_0 <= (refinement_quotient_7_0 * 2) + as_number(((refinement_remainder_7_0 * 2) >=
        refinement_divisor_7_0));
      refinement_negative_0_0 <= refinement_remainder_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      -- leftright
      leftright_holds_winners_all := (leftright_ring_read_address /= 0) and (not leftright_holds_winners);
      leftright_address_0_value := to_integer(leftright_held_0(7 downto 4));
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_other_1_0 <= slice1other_winner_out_0;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_other_4_0 <= leftright_other_3_0;
      leftright_other_5_0 <= leftright_other_4_0;
      leftright_other_6_0 <= leftright_other_5_0;
      leftright_other_7_0 <= leftright_other_6_0;
      leftright_other_8_0 <= leftright_other_7_0;
      leftright_other_9_0 <= leftright_other_8_0;
      leftright_other_10_0 <= leftright_other_9_0;
      leftright_other_11_0 <= leftright_other_10_0;
      leftright_other_12_0 <= leftright_other_11_0;
      leftright_holds_winners <= (not refinement_tag_9_valid) and leftright_holds_winners when
        leftright_holds_winners_all else refinement_tag_9_valid or leftright_holds_winners;
      leftright_position <= (leftright_position + as_number(refinement_tag_9_valid)) mod 32;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and refinement_tag_9_valid;
      leftright_address_0 <= (leftright_address_0_value + leftright_held_position + 17) mod 32;
      leftright_asking_disparity_0 <= leftright_address_0_value;
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= to_integer(leftright_held_0(0 downto 0)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if refinement_tag_9_valid then
        leftright_ring_read_address <= 0 when leftright_ring_read_address = 15 else (leftright_ring_read_address + 1)
          mod 16;
        leftright_ring_write_address <= leftright_ring_read_address;
      end if;
      -- map
      if slice0cost_reverse_2_0_all_2 then
        map_counter_column <= 0 when slice0cost_reverse_2_0_is_equal or leftright_checked_tag_start_of_frame else
          (map_counter_column + 1) mod 128;
      end if;
      map_counter_group_choice := 1 when transform_counter_next_frame_is_equal and slice0cost_reverse_2_0 else
        (map_counter_group + 1) mod 128;
      map_counter_group_choice_2 := map_counter_group_choice when slice0cost_reverse_2_0_is_equal and
        (((map_counter_group / 2) /= 32) or (not ((map_counter_group mod 2) = 1))) and leftright_checked_tag_valid and
        leftright_checked_tag_map_column else map_counter_group;
      map_line_ended_choice := leftright_checked_tag_map_column when leftright_checked_tag_valid else map_line_ended;
      map_passed_1_0_all := (not map_at_arrives) and (not map_at_behind);
      map_passed_1_0_any := map_at_arrives or map_at_behind;
      map_complete_is_equal := map_write_column = 0;
      map_largest_low_0_choice := map_low_0_0 when map_low_1_0 < map_low_0_0 else map_low_1_0;
      map_median_middle_0_is_less := map_middle_1_0 < map_middle_0_0;
      map_median_middle_0_choice := map_middle_0_0 when map_median_middle_0_is_less else map_middle_1_0;
      map_median_middle_0_choice_2 := map_middle_2_0 when map_middle_2_0 < map_median_middle_0_choice else
        map_median_middle_0_choice;
      map_median_middle_0_choice_3 := map_middle_1_0 when map_median_middle_0_is_less else map_middle_0_0;
      map_smallest_high_0_choice := map_high_1_0 when map_high_1_0 < map_high_0_0 else map_high_0_0;
      map_out_disparity_0_is_less := map_median_middle_0 < map_largest_low_0;
      if map_out_disparity_0_is_less then
        map_out_disparity_0_choice := map_largest_low_0;
      else
        map_out_disparity_0_choice := map_median_middle_0;
      end if;
      map_out_disparity_0_choice_2 := map_smallest_high_0 when map_smallest_high_0 < map_out_disparity_0_choice else
        map_out_disparity_0_choice;
      map_out_disparity_0_choice_3 := map_median_middle_0 when map_out_disparity_0_is_less else map_largest_low_0;
      map_counter_group <= as_number(slice0cost_reverse_2_0_all) * 64 when leftright_checked_tag_start_of_frame and
        leftright_checked_tag_valid and leftright_checked_tag_map_column else map_counter_group_choice_2;
      map_newest_0 <= ((((((((leftright_checked_disparity_0 + 4095) mod 2048) * 2) + (leftright_checked_fraction_0 / 8)
        + 1) mod 4096) * 8) + (leftright_checked_fraction_0 mod 8)) * 2) + as_number(leftright_checked_passed_0);
      map_arrives <= slice0cost_reverse_2_0_all_2;
      map_behind <= map_line_ended and leftright_checked_tag_valid;
      map_line_ended <= map_line_ended_choice when leftright_checked_tag_end_of_line else map_line_ended and (not
        leftright_checked_tag_valid);
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_read_column <= map_counter_column;
      map_read_arrives <= map_arrives;
      map_read_behind <= map_behind;
      map_read_top <= map_counter_group = 1;
      map_read_output <= ((map_counter_group + 65535) mod 65536) < 64;
      map_ready_column <= map_read_column;
      map_ready_arrives <= map_read_arrives;
      map_ready_behind <= map_read_behind;
      map_ready_top <= map_read_top;
      map_ready_output <= map_read_output;
      map_write_column <= map_ready_column;
      map_column_1 <= map_rows_ready_words_0 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_ready_arrives;
      map_at_behind <= map_ready_behind;
      map_at_top <= map_ready_top;
      map_at_output <= map_ready_output;
      map_passed_1_0 <= map_passed_0_0 or map_passed_1_0_all when map_passed_1_0 else map_passed_0_0 and
        map_passed_1_0_any;
      map_complete <= map_at_output and map_at_behind when map_complete_is_equal else map_at_output and
        map_passed_1_0_any;
      map_first <= map_at_arrives and map_at_top and (map_write_column = 1);
      map_last <= map_at_behind;
      map_largest_low_0 <= map_largest_low_0_choice when map_low_2_0 < map_largest_low_0_choice else map_low_2_0;
      map_median_middle_0 <= map_median_middle_0_choice_3 when map_median_middle_0_choice_2 <
        map_median_middle_0_choice_3 else map_median_middle_0_choice_2;
      map_smallest_high_0 <= map_high_2_0 when map_high_2_0 < map_smallest_high_0_choice else
        map_smallest_high_0_choice;
      map_waiting_passed_0 <= map_passed_1_0;
      map_waiting_valid <= map_complete;
      map_waiting_start_of_frame <= map_first and map_complete;
      map_waiting_end_of_line <= map_last and map_complete;
      map_out_disparity_0 <= map_out_disparity_0_choice_3 when map_out_disparity_0_choice_2 <
        map_out_disparity_0_choice_3 else map_out_disparity_0_choice_2;
      map_out_passed_0 <= map_waiting_passed_0;
      map_out_valid <= map_waiting_valid;
      map_out_start_of_frame <= map_waiting_start_of_frame;
      map_out_end_of_line <= map_waiting_end_of_line;
      if map_ready_arrives then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= map_ready_column;
      end if;
      if raster_place_next_frame then
        map_low_0_0_choice := map_column_1 / 2;
      else
        map_low_0_0_choice := map_column_2 / 2;
      end if;
      if map_at_top then
        map_low_0_0_choice_2 := map_column_1 / 2;
      else
        map_low_0_0_choice_2 := other_0 / 2;
      end if;
      map_low_0_0_is_less := (map_column_1 / 2) < map_low_0_0_choice_2;
      if map_low_0_0_is_less then
        map_low_0_0_choice_3 := map_column_1 / 2;
      else
        map_low_0_0_choice_3 := map_low_0_0_choice_2;
      end if;
      if raster_place_next_frame then
        map_low_0_0_choice_4 := map_column_1 / 2;
      else
        map_low_0_0_choice_4 := (map_column_2 / 2) mod 4096;
      end if;
      map_low_0_0_choice_5 := map_low_0_0_choice_4 when map_low_0_0_choice < map_low_0_0_choice_3 else
        map_low_0_0_choice_3;
      map_low_0_0_choice_6 := map_low_0_0 when map_at_behind else map_low_0_0_choice_5;
      map_low_1_0_all := map_complete_is_equal and map_at_arrives;
      map_middle_0_0_choice := map_low_0_0_choice_2 when map_low_0_0_is_less else map_column_1 / 2;
      map_middle_0_0_is_less := map_low_0_0_choice < map_middle_0_0_choice;
      map_middle_0_0_choice_2 := map_low_0_0_choice when map_middle_0_0_is_less else map_middle_0_0_choice;
      if map_middle_0_0_choice_2 < map_low_0_0_choice_3 then
        map_middle_0_0_choice_3 := map_low_0_0_choice_3;
      else
        map_middle_0_0_choice_3 := map_middle_0_0_choice_2;
      end if;
      map_middle_0_0_choice_4 := map_middle_0_0 when map_at_behind else map_middle_0_0_choice_3;
      if map_middle_0_0_is_less then
        map_high_0_0_choice := map_middle_0_0_choice;
      else
        map_high_0_0_choice := map_low_0_0_choice;
      end if;
      map_high_0_0_choice_2 := map_high_0_0 when map_at_behind else map_high_0_0_choice;
      if not map_passed_1_0_all then
        map_low_0_0 <= map_low_0_0_choice_6;
        map_low_1_0 <= map_low_0_0_choice_6 when map_low_1_0_all else map_low_0_0;
        map_low_2_0 <= map_low_1_0;
        map_middle_0_0 <= map_middle_0_0_choice_4;
        map_middle_1_0 <= map_middle_0_0_choice_4 when map_low_1_0_all else map_middle_0_0;
        map_middle_2_0 <= map_middle_1_0;
        map_high_0_0 <= map_high_0_0_choice_2;
        map_high_1_0 <= map_high_0_0_choice_2 when map_low_1_0_all else map_high_0_0;
        map_high_2_0 <= map_high_1_0;
      end if;
      if map_at_arrives then
        map_passed_0_0 <= (map_column_1 mod 2) = 1;
      end if;
      -- other
      other_0 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
      other_1 <= slice0winner1_best_cost_0_2_is_less;
      other_2 <= slice1winner1_best_cost_0_2_is_less;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_right_0 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 65;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_ready_words_0 <= 0;
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_write_words_0 <= 0;
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_ready_words_0 <= 0;
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_write_words_0 <= 0;
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_row_inside_2 <= false;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_row_inside_0 <= false;
        transform_ready_row_inside_2 <= false;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_left_column_0 <= 0;
        transform_left_column_1 <= 0;
        transform_left_column_2 <= 0;
        transform_right_column_0 <= 0;
        transform_right_column_1 <= 0;
        transform_right_column_2 <= 0;
        transform_columns_row_inside_0 <= false;
        transform_columns_row_inside_2 <= false;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_left_filter_column_0_0 <= 0;
        transform_left_filter_column_1_0 <= 0;
        transform_left_filter_column_2_0 <= 0;
        transform_left_filter_feature_0 <= 0;
        transform_right_filter_column_0_0 <= 0;
        transform_right_filter_column_1_0 <= 0;
        transform_right_filter_column_2_0 <= 0;
        transform_right_filter_feature_0 <= 0;
        transform_filtering_column_inside_0 <= false;
        transform_filtering_column_inside_2 <= false;
        transform_filtering_start_of_frame <= false;
        transform_filtering_valid <= false;
        transform_filtered_start_of_frame <= false;
        transform_filtered_valid <= false;
        raster_features_search_0 <= 0;
        raster_features_reference_0 <= 0;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 66;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_ahead_0 <= 0;
        delay_column <= 0;
        delay_row_inside_0 <= false;
        delay_row_inside_1 <= false;
        delay_row_inside_2 <= false;
        delay_row_inside_3 <= false;
        delay_row_inside_4 <= false;
        delay_tag_valid <= false;
        delay_tag_border_column <= false;
        delay_tag_map_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        rows_search_rows_ready_words_0 <= 0;
        rows_search_rows_ready_newest_0 <= 0;
        rows_search_rows_write_words_0 <= 0;
        rows_reference_rows_read_newest_0 <= 0;
        rows_reference_rows_ready_words_0 <= 0;
        rows_reference_rows_ready_newest_0 <= 0;
        rows_reference_rows_write_words_0 <= 0;
        rows_read_column <= 0;
        rows_read_inside_0 <= false;
        rows_read_inside_1 <= false;
        rows_read_inside_2 <= false;
        rows_read_inside_3 <= false;
        rows_read_inside_4 <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_border_column <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside_0 <= false;
        rows_ready_inside_1 <= false;
        rows_ready_inside_2 <= false;
        rows_ready_inside_3 <= false;
        rows_ready_inside_4 <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_border_column <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search_0 <= 0;
        rows_search_1 <= 0;
        rows_search_2 <= 0;
        rows_search_3 <= 0;
        rows_search_4 <= 0;
        rows_reference_0 <= 0;
        rows_reference_1 <= 0;
        rows_reference_2 <= 0;
        rows_reference_3 <= 0;
        rows_reference_4 <= 0;
        rows_tag_valid <= false;
        rows_tag_border_column <= false;
        rows_tag_map_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_search_0_0 <= 0;
        slice0shift_search_0_1 <= 0;
        slice0shift_search_0_2 <= 0;
        slice0shift_search_0_3 <= 0;
        slice0shift_search_0_4 <= 0;
        slice0shift_search_0_5 <= 0;
        slice0shift_search_0_6 <= 0;
        slice0shift_search_0_7 <= 0;
        slice0shift_search_1_0 <= 0;
        slice0shift_search_1_1 <= 0;
        slice0shift_search_1_2 <= 0;
        slice0shift_search_1_3 <= 0;
        slice0shift_search_1_4 <= 0;
        slice0shift_search_1_5 <= 0;
        slice0shift_search_1_6 <= 0;
        slice0shift_search_1_7 <= 0;
        slice0shift_search_2_0 <= 0;
        slice0shift_search_2_1 <= 0;
        slice0shift_search_2_2 <= 0;
        slice0shift_search_2_3 <= 0;
        slice0shift_search_2_4 <= 0;
        slice0shift_search_2_5 <= 0;
        slice0shift_search_2_6 <= 0;
        slice0shift_search_2_7 <= 0;
        slice0shift_search_3_0 <= 0;
        slice0shift_search_3_1 <= 0;
        slice0shift_search_3_2 <= 0;
        slice0shift_search_3_3 <= 0;
        slice0shift_search_3_4 <= 0;
        slice0shift_search_3_5 <= 0;
        slice0shift_search_3_6 <= 0;
        slice0shift_search_3_7 <= 0;
        slice0shift_search_4_0 <= 0;
        slice0shift_search_4_1 <= 0;
        slice0shift_search_4_2 <= 0;
        slice0shift_search_4_3 <= 0;
        slice0shift_search_4_4 <= 0;
        slice0shift_search_4_5 <= 0;
        slice0shift_search_4_6 <= 0;
        slice0shift_search_4_7 <= 0;
        slice0shift_reference_0 <= 0;
        slice0shift_reference_1 <= 0;
        slice0shift_reference_2 <= 0;
        slice0shift_reference_3 <= 0;
        slice0shift_reference_4 <= 0;
        slice0shift_search_out_0 <= 0;
        slice0shift_search_out_1 <= 0;
        slice0shift_search_out_2 <= 0;
        slice0shift_search_out_3 <= 0;
        slice0shift_search_out_4 <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_border_column <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_0_0 <= 0;
        slice0cost_difference_0_1 <= 0;
        slice0cost_difference_0_2 <= 0;
        slice0cost_difference_0_3 <= 0;
        slice0cost_difference_0_4 <= 0;
        slice0cost_difference_0_5 <= 0;
        slice0cost_difference_0_6 <= 0;
        slice0cost_difference_0_7 <= 0;
        slice0cost_difference_1_0 <= 0;
        slice0cost_difference_1_1 <= 0;
        slice0cost_difference_1_2 <= 0;
        slice0cost_difference_1_3 <= 0;
        slice0cost_difference_1_4 <= 0;
        slice0cost_difference_1_5 <= 0;
        slice0cost_difference_1_6 <= 0;
        slice0cost_difference_1_7 <= 0;
        slice0cost_difference_2_0 <= 0;
        slice0cost_difference_2_1 <= 0;
        slice0cost_difference_2_2 <= 0;
        slice0cost_difference_2_3 <= 0;
        slice0cost_difference_2_4 <= 0;
        slice0cost_difference_2_5 <= 0;
        slice0cost_difference_2_6 <= 0;
        slice0cost_difference_2_7 <= 0;
        slice0cost_difference_3_0 <= 0;
        slice0cost_difference_3_1 <= 0;
        slice0cost_difference_3_2 <= 0;
        slice0cost_difference_3_3 <= 0;
        slice0cost_difference_3_4 <= 0;
        slice0cost_difference_3_5 <= 0;
        slice0cost_difference_3_6 <= 0;
        slice0cost_difference_3_7 <= 0;
        slice0cost_difference_4_0 <= 0;
        slice0cost_difference_4_1 <= 0;
        slice0cost_difference_4_2 <= 0;
        slice0cost_difference_4_3 <= 0;
        slice0cost_difference_4_4 <= 0;
        slice0cost_difference_4_5 <= 0;
        slice0cost_difference_4_6 <= 0;
        slice0cost_difference_4_7 <= 0;
        slice0cost_reverse_0_0 <= 0;
        slice0cost_reverse_0_1 <= 0;
        slice0cost_reverse_0_2 <= 0;
        slice0cost_reverse_0_3 <= 0;
        slice0cost_reverse_0_4 <= 0;
        slice0cost_reverse_0_5 <= 0;
        slice0cost_reverse_0_6 <= 0;
        slice0cost_reverse_0_7 <= 0;
        slice0cost_reverse_1_0 <= 0;
        slice0cost_reverse_1_1 <= 0;
        slice0cost_reverse_1_2 <= 0;
        slice0cost_reverse_1_3 <= 0;
        slice0cost_reverse_1_4 <= 0;
        slice0cost_reverse_1_5 <= 0;
        slice0cost_reverse_1_6 <= 0;
        slice0cost_reverse_1_7 <= 0;
        slice0cost_reverse_2_0 <= false;
        slice0cost_reverse_2_3 <= false;
        slice0cost_reverse_2_4 <= false;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_border_column <= false;
        slice0cost_difference_tag_map_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_0_0 <= 0;
        slice0cost_pair_0_1 <= 0;
        slice0cost_pair_0_2 <= 0;
        slice0cost_pair_0_3 <= 0;
        slice0cost_pair_0_4 <= 0;
        slice0cost_pair_0_5 <= 0;
        slice0cost_pair_0_6 <= 0;
        slice0cost_pair_0_7 <= 0;
        slice0cost_pair_1_0 <= 0;
        slice0cost_pair_1_1 <= 0;
        slice0cost_pair_1_2 <= 0;
        slice0cost_pair_1_3 <= 0;
        slice0cost_pair_1_4 <= 0;
        slice0cost_pair_1_5 <= 0;
        slice0cost_pair_1_6 <= 0;
        slice0cost_pair_1_7 <= 0;
        slice0cost_single_0_0 <= 0;
        slice0cost_single_0_1 <= 0;
        slice0cost_single_0_2 <= 0;
        slice0cost_single_0_3 <= 0;
        slice0cost_single_0_4 <= 0;
        slice0cost_single_0_5 <= 0;
        slice0cost_single_0_6 <= 0;
        slice0cost_single_0_7 <= 0;
        slice0cost_negative_0_0 <= false;
        slice0cost_negative_0_1 <= false;
        slice0cost_negative_0_2 <= false;
        slice0cost_negative_0_3 <= false;
        slice0cost_negative_0_4 <= false;
        slice0cost_negative_0_5 <= false;
        slice0cost_negative_0_6 <= false;
        slice0cost_negative_0_7 <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_border_column <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_0_3 <= 0;
        slice0cost_column_0_4 <= 0;
        slice0cost_column_0_5 <= 0;
        slice0cost_column_0_6 <= 0;
        slice0cost_column_0_7 <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_border_column <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_partial_0_0_0 <= 0;
        slice0window_partial_0_0_1 <= 0;
        slice0window_partial_0_0_2 <= 0;
        slice0window_partial_0_0_3 <= 0;
        slice0window_partial_0_0_4 <= 0;
        slice0window_partial_0_0_5 <= 0;
        slice0window_partial_0_0_6 <= 0;
        slice0window_partial_0_0_7 <= 0;
        slice0window_partial_0_1_0 <= 0;
        slice0window_partial_0_1_1 <= 0;
        slice0window_partial_0_1_2 <= 0;
        slice0window_partial_0_1_3 <= 0;
        slice0window_partial_0_1_4 <= 0;
        slice0window_partial_0_1_5 <= 0;
        slice0window_partial_0_1_6 <= 0;
        slice0window_partial_0_1_7 <= 0;
        slice0window_partial_0_2_0 <= 0;
        slice0window_partial_0_2_1 <= 0;
        slice0window_partial_0_2_2 <= 0;
        slice0window_partial_0_2_3 <= 0;
        slice0window_partial_0_2_4 <= 0;
        slice0window_partial_0_2_5 <= 0;
        slice0window_partial_0_2_6 <= 0;
        slice0window_partial_0_2_7 <= 0;
        slice0window_partial_0_3_0 <= 0;
        slice0window_partial_0_3_1 <= 0;
        slice0window_partial_0_3_2 <= 0;
        slice0window_partial_0_3_3 <= 0;
        slice0window_partial_0_3_4 <= 0;
        slice0window_partial_0_3_5 <= 0;
        slice0window_partial_0_3_6 <= 0;
        slice0window_partial_0_3_7 <= 0;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_sum_0_0 <= 0;
        slice0window_sum_0_1 <= 0;
        slice0window_sum_0_2 <= 0;
        slice0window_sum_0_3 <= 0;
        slice0window_sum_0_4 <= 0;
        slice0window_sum_0_5 <= 0;
        slice0window_sum_0_6 <= 0;
        slice0window_sum_0_7 <= 0;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_best_cost_0_0 <= 0;
        slice0winner1_best_cost_0_1 <= 0;
        slice0winner1_best_cost_0_2 <= 0;
        slice0winner1_best_cost_0_3 <= 0;
        slice0winner1_best_index_0_0 <= false;
        slice0winner1_best_index_0_1 <= 0;
        slice0winner1_best_index_0_2 <= 0;
        slice0winner1_best_index_0_3 <= 0;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_best_cost_0_0 <= 0;
        slice0winner2_best_cost_0_1 <= 0;
        slice0winner2_best_index_0_0 <= 0;
        slice0winner2_best_index_0_1 <= 0;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_best_cost_0_0 <= 0;
        slice0winner3_best_index_0_0 <= 0;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0_best_cost_0_0 <= 0;
        slice0_best_index_0_0 <= 0;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1shift_search_0_0 <= 0;
        slice1shift_search_0_1 <= 0;
        slice1shift_search_0_2 <= 0;
        slice1shift_search_0_3 <= 0;
        slice1shift_search_0_4 <= 0;
        slice1shift_search_0_5 <= 0;
        slice1shift_search_0_6 <= 0;
        slice1shift_search_0_7 <= 0;
        slice1shift_search_1_0 <= 0;
        slice1shift_search_1_1 <= 0;
        slice1shift_search_1_2 <= 0;
        slice1shift_search_1_3 <= 0;
        slice1shift_search_1_4 <= 0;
        slice1shift_search_1_5 <= 0;
        slice1shift_search_1_6 <= 0;
        slice1shift_search_1_7 <= 0;
        slice1shift_search_2_0 <= 0;
        slice1shift_search_2_1 <= 0;
        slice1shift_search_2_2 <= 0;
        slice1shift_search_2_3 <= 0;
        slice1shift_search_2_4 <= 0;
        slice1shift_search_2_5 <= 0;
        slice1shift_search_2_6 <= 0;
        slice1shift_search_2_7 <= 0;
        slice1shift_search_3_0 <= 0;
        slice1shift_search_3_1 <= 0;
        slice1shift_search_3_2 <= 0;
        slice1shift_search_3_3 <= 0;
        slice1shift_search_3_4 <= 0;
        slice1shift_search_3_5 <= 0;
        slice1shift_search_3_6 <= 0;
        slice1shift_search_3_7 <= 0;
        slice1shift_search_4_0 <= 0;
        slice1shift_search_4_1 <= 0;
        slice1shift_search_4_2 <= 0;
        slice1shift_search_4_3 <= 0;
        slice1shift_search_4_4 <= 0;
        slice1shift_search_4_5 <= 0;
        slice1shift_search_4_6 <= 0;
        slice1shift_search_4_7 <= 0;
        slice1shift_reference_0 <= 0;
        slice1shift_reference_1 <= 0;
        slice1shift_reference_2 <= 0;
        slice1shift_reference_3 <= 0;
        slice1shift_reference_4 <= 0;
        slice1cost_difference_0_0 <= 0;
        slice1cost_difference_0_1 <= 0;
        slice1cost_difference_0_2 <= 0;
        slice1cost_difference_0_3 <= 0;
        slice1cost_difference_0_4 <= 0;
        slice1cost_difference_0_5 <= 0;
        slice1cost_difference_0_6 <= 0;
        slice1cost_difference_0_7 <= 0;
        slice1cost_difference_1_0 <= 0;
        slice1cost_difference_1_1 <= 0;
        slice1cost_difference_1_2 <= 0;
        slice1cost_difference_1_3 <= 0;
        slice1cost_difference_1_4 <= 0;
        slice1cost_difference_1_5 <= 0;
        slice1cost_difference_1_6 <= 0;
        slice1cost_difference_1_7 <= 0;
        slice1cost_difference_2_0 <= 0;
        slice1cost_difference_2_1 <= 0;
        slice1cost_difference_2_2 <= 0;
        slice1cost_difference_2_3 <= 0;
        slice1cost_difference_2_4 <= 0;
        slice1cost_difference_2_5 <= 0;
        slice1cost_difference_2_6 <= 0;
        slice1cost_difference_2_7 <= 0;
        slice1cost_difference_3_0 <= 0;
        slice1cost_difference_3_1 <= 0;
        slice1cost_difference_3_2 <= 0;
        slice1cost_difference_3_3 <= 0;
        slice1cost_difference_3_4 <= 0;
        slice1cost_difference_3_5 <= 0;
        slice1cost_difference_3_6 <= 0;
        slice1cost_difference_3_7 <= 0;
        slice1cost_difference_4_0 <= 0;
        slice1cost_difference_4_1 <= 0;
        slice1cost_difference_4_2 <= 0;
        slice1cost_difference_4_3 <= 0;
        slice1cost_difference_4_4 <= 0;
        slice1cost_difference_4_5 <= 0;
        slice1cost_difference_4_6 <= 0;
        slice1cost_difference_4_7 <= 0;
        slice1cost_reverse_0_0 <= 0;
        slice1cost_reverse_0_1 <= 0;
        slice1cost_reverse_0_2 <= 0;
        slice1cost_reverse_0_3 <= 0;
        slice1cost_reverse_0_4 <= 0;
        slice1cost_reverse_0_5 <= 0;
        slice1cost_reverse_0_6 <= 0;
        slice1cost_reverse_0_7 <= 0;
        slice1cost_reverse_1_0 <= 0;
        slice1cost_reverse_1_1 <= 0;
        slice1cost_reverse_1_2 <= 0;
        slice1cost_reverse_1_3 <= 0;
        slice1cost_reverse_1_4 <= 0;
        slice1cost_reverse_1_5 <= 0;
        slice1cost_reverse_1_6 <= 0;
        slice1cost_reverse_1_7 <= 0;
        slice1cost_pair_0_0 <= 0;
        slice1cost_pair_0_1 <= 0;
        slice1cost_pair_0_2 <= 0;
        slice1cost_pair_0_3 <= 0;
        slice1cost_pair_0_4 <= 0;
        slice1cost_pair_0_5 <= 0;
        slice1cost_pair_0_6 <= 0;
        slice1cost_pair_0_7 <= 0;
        slice1cost_pair_1_0 <= 0;
        slice1cost_pair_1_1 <= 0;
        slice1cost_pair_1_2 <= 0;
        slice1cost_pair_1_3 <= 0;
        slice1cost_pair_1_4 <= 0;
        slice1cost_pair_1_5 <= 0;
        slice1cost_pair_1_6 <= 0;
        slice1cost_pair_1_7 <= 0;
        slice1cost_single_0_0 <= 0;
        slice1cost_single_0_1 <= 0;
        slice1cost_single_0_2 <= 0;
        slice1cost_single_0_3 <= 0;
        slice1cost_single_0_4 <= 0;
        slice1cost_single_0_5 <= 0;
        slice1cost_single_0_6 <= 0;
        slice1cost_single_0_7 <= 0;
        slice1cost_negative_0_0 <= false;
        slice1cost_negative_0_1 <= false;
        slice1cost_negative_0_2 <= false;
        slice1cost_negative_0_3 <= false;
        slice1cost_negative_0_4 <= false;
        slice1cost_negative_0_5 <= false;
        slice1cost_negative_0_6 <= false;
        slice1cost_negative_0_7 <= false;
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_0_3 <= 0;
        slice1cost_column_0_4 <= 0;
        slice1cost_column_0_5 <= 0;
        slice1cost_column_0_6 <= 0;
        slice1cost_column_0_7 <= 0;
        slice1window_partial_0_0_0 <= 0;
        slice1window_partial_0_0_1 <= 0;
        slice1window_partial_0_0_2 <= 0;
        slice1window_partial_0_0_3 <= 0;
        slice1window_partial_0_0_4 <= 0;
        slice1window_partial_0_0_5 <= 0;
        slice1window_partial_0_0_6 <= 0;
        slice1window_partial_0_0_7 <= 0;
        slice1window_partial_0_1_0 <= 0;
        slice1window_partial_0_1_1 <= 0;
        slice1window_partial_0_1_2 <= 0;
        slice1window_partial_0_1_3 <= 0;
        slice1window_partial_0_1_4 <= 0;
        slice1window_partial_0_1_5 <= 0;
        slice1window_partial_0_1_6 <= 0;
        slice1window_partial_0_1_7 <= 0;
        slice1window_partial_0_2_0 <= 0;
        slice1window_partial_0_2_1 <= 0;
        slice1window_partial_0_2_2 <= 0;
        slice1window_partial_0_2_3 <= 0;
        slice1window_partial_0_2_4 <= 0;
        slice1window_partial_0_2_5 <= 0;
        slice1window_partial_0_2_6 <= 0;
        slice1window_partial_0_2_7 <= 0;
        slice1window_partial_0_3_0 <= 0;
        slice1window_partial_0_3_1 <= 0;
        slice1window_partial_0_3_2 <= 0;
        slice1window_partial_0_3_3 <= 0;
        slice1window_partial_0_3_4 <= 0;
        slice1window_partial_0_3_5 <= 0;
        slice1window_partial_0_3_6 <= 0;
        slice1window_partial_0_3_7 <= 0;
        slice1window_centre_map_column_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1window_sum_0_0 <= 0;
        slice1window_sum_0_1 <= 0;
        slice1window_sum_0_2 <= 0;
        slice1window_sum_0_3 <= 0;
        slice1window_sum_0_4 <= 0;
        slice1window_sum_0_5 <= 0;
        slice1window_sum_0_6 <= 0;
        slice1window_sum_0_7 <= 0;
        slice1winner1_best_cost_0_0 <= 0;
        slice1winner1_best_cost_0_1 <= 0;
        slice1winner1_best_cost_0_2 <= 0;
        slice1winner1_best_cost_0_3 <= 0;
        slice1winner1_best_index_0_0 <= false;
        slice1winner1_best_index_0_1 <= 0;
        slice1winner1_best_index_0_2 <= 0;
        slice1winner1_best_index_0_3 <= 0;
        slice1winner2_best_cost_0_0 <= 0;
        slice1winner2_best_cost_0_1 <= 0;
        slice1winner2_best_index_0_0 <= 0;
        slice1winner2_best_index_0_1 <= 0;
        slice1winner3_best_cost_0_0 <= 0;
        slice1winner3_best_index_0_0 <= 0;
        slice1_best_index_0_0 <= 0;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        refinement_disparity_0_0 <= 0;
        refinement_disparity_1_0 <= 0;
        refinement_disparity_2_0 <= 0;
        refinement_disparity_3_0 <= 0;
        refinement_disparity_4_0 <= 0;
        refinement_disparity_5_0 <= 0;
        refinement_disparity_6_0 <= 0;
        refinement_disparity_7_0 <= 0;
        refinement_disparity_8_0 <= 0;
        refinement_disparity_9_0 <= 0;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_position <= 0;
        leftright_held_valid <= false;
        leftright_address_0 <= 0;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 65;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_read_column <= 0;
        map_read_arrives <= false;
        map_read_behind <= false;
        map_read_top <= false;
        map_read_output <= false;
        map_ready_column <= 0;
        map_ready_arrives <= false;
        map_ready_behind <= false;
        map_ready_top <= false;
        map_ready_output <= false;
        map_write_column <= 0;
        map_at_column <= 0;
        map_at_arrives <= false;
        map_at_behind <= false;
        map_at_top <= false;
        map_at_output <= false;
        map_complete <= false;
        map_first <= false;
        map_last <= false;
        map_waiting_valid <= false;
        map_waiting_start_of_frame <= false;
        map_waiting_end_of_line <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
