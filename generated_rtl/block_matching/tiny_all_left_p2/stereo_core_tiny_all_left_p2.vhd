-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_all_left_p2: 32x12, 8 disparities, window 3x3, 2 pixel pairs a clock.
-- Options: disparities 8, reference left, prefilter xsobel, ties largest, left_right_threshold 1,
--   uniqueness_percent 10, texture_threshold 30, subpixel true, median true, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_all_left_p2
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_all_left_p2 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 2;
    disparity_bits : positive := 16;
    output_width_px : positive := 24;
    latency_clocks : positive := 49;
    flush_groups : positive := 106;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(15 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(15 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(31 downto 0);
    pixel_valid : out std_logic_vector(1 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 32 report "stereo_core_tiny_all_left_p2: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_all_left_p2: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny_all_left_p2: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 2 report "stereo_core_tiny_all_left_p2: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 2" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_all_left_p2: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny_all_left_p2: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 49 report "stereo_core_tiny_all_left_p2: latency_clocks is " & integer'image(latency_clocks) & " but this core has 49" severity failure;
  assert flush_groups = 106 report "stereo_core_tiny_all_left_p2: flush_groups is " & integer'image(flush_groups) & " but this core has 106" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_all_left_p2: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_all_left_p2 is
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

  -- as a fold and a carry: a negation and a choice would take twice the logic
  function magnitude(value : integer) return natural is
  begin
    return folded(value) + as_number(value < 0);
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
  signal in_right_pixel : natural range 0 to 65535;
  signal in_left_pixel : natural range 0 to 65535;
  -- transform
  signal transform_left_0, transform_left_1, transform_right_0, transform_right_1 : natural range 0 to 255;
  signal transform_left_rows_read_newest_0, transform_left_rows_read_newest_1 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_left_rows_ready_newest_1 : natural range 0 to 255;
  signal transform_right_rows_read_newest_0, transform_right_rows_read_newest_1 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_right_rows_ready_newest_1 : natural range 0 to 255;
  signal transform_left_column_0, transform_left_column_1, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_3, transform_right_column_0, transform_right_column_1 : natural range 0 to 255;
  signal transform_right_column_2, transform_right_column_3, transform_left_filter_feature_1 : natural range 0 to 255;
  signal transform_right_filter_feature_1 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_3, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_1, transform_read_column_inside_2, transform_read_start_of_frame : boolean;
  signal transform_read_valid, transform_ready_row_inside_0, transform_ready_row_inside_1 : boolean;
  signal transform_ready_row_inside_3, transform_ready_column_inside_0, transform_ready_column_inside_2 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_1, transform_columns_row_inside_3, transform_columns_column_inside_0 : boolean;
  signal transform_columns_column_inside_2, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_left_filter_whole, transform_filtering_0_column_inside_0 : boolean;
  signal transform_filtering_0_column_inside_2, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_filtering_2_start_of_frame, transform_filtering_2_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 31;
  signal transform_write_column : natural range 0 to 31;
  signal transform_counter_group : natural range 0 to 7;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(23 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_left_filter_column_0_0, transform_left_filter_column_0_1 : natural range 0 to 1020;
  signal transform_left_filter_column_1_0, transform_left_filter_column_1_1 : natural range 0 to 1020;
  signal transform_left_filter_column_2_0, transform_left_filter_column_2_1 : natural range 0 to 1020;
  signal transform_right_filter_column_0_0, transform_right_filter_column_0_1 : natural range 0 to 1020;
  signal transform_right_filter_column_1_0, transform_right_filter_column_1_1 : natural range 0 to 1020;
  signal transform_right_filter_column_2_0, transform_right_filter_column_2_1 : natural range 0 to 1020;
  signal transform_left_filter_slope_0, transform_left_filter_slope_1 : integer range -1020 to 1020;
  signal transform_right_filter_slope_0, transform_right_filter_slope_1 : integer range -1020 to 1020;
  signal transform_left_filter_feature_0 : natural range 0 to 127;
  signal transform_right_filter_feature_0 : natural range 0 to 65535;
  -- raster
  signal raster_features_search_0 : natural range 0 to 32767;
  signal raster_features_search_1, raster_features_reference_1 : natural range 0 to 255;
  signal raster_features_reference_0 : natural range 0 to 127;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 7;
  -- delay
  signal delay_ahead_0 : natural range 0 to 127;
  signal delay_ahead_1 : natural range 0 to 255;
  signal delay_delayed_0 : natural range 0 to 32767;
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_3, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_map_column, delay_tag_output_column, delay_tag_first_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(20 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 127;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 127;
  signal rows_search_1, rows_search_2, rows_search_3, rows_reference_0, rows_reference_1 : natural range 0 to 127;
  signal rows_reference_2, rows_reference_3 : natural range 0 to 127;
  signal rows_search_rows_read_newest_1, rows_search_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_1, rows_reference_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_reference_rows_ready_words_0 : natural range 0 to 2097151;
  signal rows_search_rows_write_words_0, rows_reference_rows_write_words_0 : natural range 0 to 4194303;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_3, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_map_column, rows_read_tag_output_column : boolean;
  signal rows_read_tag_first_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_3, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_inside_0, rows_inside_1, rows_inside_3, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_map_column, rows_tag_output_column, rows_tag_first_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 127;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 127;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 127;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 127;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 127;
  signal slice0shift_reference_3, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 127;
  signal slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 127;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_map_column : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_first_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -127 to 127;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -127 to 127;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -127 to 127;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -127 to 127;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_map_column, slice0cost_difference_tag_output_column : boolean;
  signal slice0cost_difference_tag_first_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column : boolean;
  signal slice0cost_pair_tag_map_column, slice0cost_pair_tag_output_column, slice0cost_pair_tag_first_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_map_column, slice0cost_tag_output_column : boolean;
  signal slice0cost_tag_first_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_single_0_0 : natural range 0 to 255;
  signal slice0cost_single_0_1, slice0cost_single_0_2, slice0cost_single_3_0 : natural range 0 to 255;
  signal slice0cost_single_3_1, slice0cost_single_3_2, slice0cost_column_0_0 : natural range 0 to 255;
  signal slice0cost_column_0_1, slice0cost_column_0_2, slice0cost_column_1_0 : natural range 0 to 255;
  signal slice0cost_column_1_1, slice0cost_column_1_2 : natural range 0 to 255;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 255;
  signal slice0window_partial_1_0_0, slice0window_partial_1_0_1, slice0window_partial_1_0_2 : natural range 0 to 255;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 510;
  signal slice0window_partial_1_1_0, slice0window_partial_1_1_1, slice0window_partial_1_1_2 : natural range 0 to 510;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 765;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 765;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 765;
  signal slice0other_cost_1_0, slice0other_cost_1_1, slice0other_cost_1_2 : natural range 0 to 765;
  signal slice0other_cost_out_0, slice0other_cost_out_1 : natural range 0 to 765;
  signal slice0other_winner_0_1, slice0other_winner_1_1 : boolean;
  signal slice0other_winner_0_2, slice0other_winner_1_2, slice0other_winner_out_0 : natural range 0 to 2;
  signal slice0other_winner_out_1 : natural range 0 to 2;
  -- slice0winner1
  signal slice0winner1_held_0_0, slice0winner1_held_0_1, slice0winner1_held_0_2 : natural range 0 to 765;
  signal slice0winner1_held_1_0, slice0winner1_held_1_1, slice0winner1_held_1_2 : natural range 0 to 765;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_1_0 : natural range 0 to 765;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_1_0 : natural range 0 to 765;
  signal slice0winner1_best_above_0_0, slice0winner1_best_above_1_0 : natural range 0 to 765;
  signal slice0winner1_best_late_cost_0_0, slice0winner1_best_late_cost_0_1 : natural range 0 to 765;
  signal slice0winner1_best_late_cost_1_0, slice0winner1_best_late_cost_1_1 : natural range 0 to 765;
  signal slice0winner1_best_index_0_0, slice0winner1_best_index_1_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_map_column, slice0winner1_tag_output_column, slice0winner1_tag_first_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 2;
  signal slice0winner1_best_but_last_0_0, slice0winner1_best_but_last_1_0 : natural range 0 to 1023;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_1_0 : natural range 0 to 765;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_1_0 : natural range 0 to 765;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_1_0 : natural range 0 to 765;
  signal slice0winner2_best_late_cost_0_0, slice0winner2_best_late_cost_1_0 : natural range 0 to 765;
  signal slice0winner2_best_index_0_0, slice0winner2_best_index_1_0 : natural range 0 to 2;
  signal slice0winner2_best_place_0_0, slice0winner2_best_place_1_0, slice0winner2_best_at_start_0_0 : boolean;
  signal slice0winner2_best_at_start_1_0, slice0winner2_best_at_end_0_0, slice0winner2_best_at_end_1_0 : boolean;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_first_column, slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  signal slice0winner2_best_second_0_0, slice0winner2_best_second_1_0 : natural range 0 to 1023;
  signal slice0winner2_best_but_last_0_0, slice0winner2_best_but_last_1_0 : natural range 0 to 1023;
  -- slice0
  signal slice0_best_index_0_0, slice0_best_index_1_0 : natural range 0 to 2;
  signal slice0_best_below_0_0, slice0_best_below_1_0, slice0_best_above_0_0 : natural range 0 to 765;
  signal slice0_best_above_1_0, slice0_best_last_0_0, slice0_best_last_1_0 : natural range 0 to 765;
  signal slice0_best_late_cost_0_0, slice0_best_late_cost_1_0 : natural range 0 to 765;
  signal slice0_best_second_0_0, slice0_best_second_1_0, slice0_best_but_last_0_0 : natural range 0 to 1023;
  signal slice0_best_but_last_1_0 : natural range 0 to 1023;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_output_column : boolean;
  signal slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 127;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 127;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 127;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 127;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 127;
  signal slice1shift_reference_3, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 127;
  signal slice1shift_search_out_2, slice1shift_search_out_3 : natural range 0 to 127;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -127 to 127;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -127 to 127;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -127 to 127;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -127 to 127;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_single_0_0 : natural range 0 to 255;
  signal slice1cost_single_0_1, slice1cost_single_0_2, slice1cost_single_3_0 : natural range 0 to 255;
  signal slice1cost_single_3_1, slice1cost_single_3_2, slice1cost_column_0_0 : natural range 0 to 255;
  signal slice1cost_column_0_1, slice1cost_column_0_2, slice1cost_column_1_0 : natural range 0 to 255;
  signal slice1cost_column_1_1, slice1cost_column_1_2 : natural range 0 to 255;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2 : boolean;
  signal slice1cost_tag_border_column, slice1cost_tag_output_column, slice1cost_tag_first_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 255;
  signal slice1window_partial_1_0_0, slice1window_partial_1_0_1, slice1window_partial_1_0_2 : natural range 0 to 255;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 510;
  signal slice1window_partial_1_1_0, slice1window_partial_1_1_1, slice1window_partial_1_1_2 : natural range 0 to 510;
  signal slice1window_centre_output_column_0, slice1window_centre_first_column_0 : boolean;
  signal slice1window_tag_output_column, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 765;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 765;
  -- slice1other
  signal slice1other_cost_0_0, slice1other_cost_0_1, slice1other_cost_0_2 : natural range 0 to 765;
  signal slice1other_cost_1_0, slice1other_cost_1_1, slice1other_cost_1_2 : natural range 0 to 765;
  signal slice1other_cost_out_0, slice1other_cost_out_1 : natural range 0 to 765;
  signal slice1other_winner_0_0, slice1other_winner_1_0 : natural range 0 to 3;
  signal slice1other_winner_0_1, slice1other_winner_1_1 : natural range 0 to 4;
  signal slice1other_winner_0_2, slice1other_winner_1_2, slice1other_winner_out_0 : natural range 0 to 5;
  signal slice1other_winner_out_1 : natural range 0 to 5;
  -- slice1winner1
  signal slice1winner1_held_0_0, slice1winner1_held_0_1, slice1winner1_held_0_2 : natural range 0 to 765;
  signal slice1winner1_held_1_0, slice1winner1_held_1_1, slice1winner1_held_1_2 : natural range 0 to 765;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_1_0 : natural range 0 to 765;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_1_0 : natural range 0 to 765;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_1_0 : natural range 0 to 765;
  signal slice1winner1_best_late_cost_0_0, slice1winner1_best_late_cost_0_1 : natural range 0 to 765;
  signal slice1winner1_best_late_cost_1_0, slice1winner1_best_late_cost_1_1 : natural range 0 to 765;
  signal slice1winner1_best_index_0_0, slice1winner1_best_index_1_0 : boolean;
  signal slice1winner1_best_but_first_0_0, slice1winner1_best_but_first_1_0 : natural range 0 to 1023;
  signal slice1winner1_best_but_last_0_0, slice1winner1_best_but_last_1_0 : natural range 0 to 1023;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_1_0 : natural range 0 to 765;
  signal slice1winner2_best_below_0_0, slice1winner2_best_below_1_0 : natural range 0 to 765;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_1_0 : natural range 0 to 765;
  signal slice1winner2_best_first_0_0, slice1winner2_best_first_1_0 : natural range 0 to 765;
  signal slice1winner2_best_late_cost_0_0, slice1winner2_best_late_cost_1_0 : natural range 0 to 765;
  signal slice1winner2_best_index_0_0, slice1winner2_best_index_1_0 : natural range 0 to 2;
  signal slice1winner2_best_place_0_0, slice1winner2_best_place_1_0, slice1winner2_best_at_start_0_0 : boolean;
  signal slice1winner2_best_at_start_1_0, slice1winner2_best_at_end_0_0, slice1winner2_best_at_end_1_0 : boolean;
  signal slice1winner2_best_second_0_0, slice1winner2_best_second_1_0 : natural range 0 to 1023;
  signal slice1winner2_best_but_first_0_0, slice1winner2_best_but_first_1_0 : natural range 0 to 1023;
  signal slice1winner2_best_but_last_0_0, slice1winner2_best_but_last_1_0 : natural range 0 to 1023;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_cost_1_0, slice1_best_below_0_0 : natural range 0 to 765;
  signal slice1_best_below_1_0, slice1_best_above_0_0, slice1_best_above_1_0 : natural range 0 to 765;
  signal slice1_best_last_0_0, slice1_best_last_1_0, slice1_best_late_cost_0_0 : natural range 0 to 765;
  signal slice1_best_late_cost_1_0 : natural range 0 to 765;
  signal slice1_best_index_0_0, slice1_best_index_1_0 : natural range 0 to 5;
  signal slice1_best_place_0_0, slice1_best_place_1_0, slice1_best_at_start_0_0, slice1_best_at_start_1_0 : boolean;
  signal slice1_best_at_end_0_0, slice1_best_at_end_1_0, slice1_best_tag_valid, slice1_best_tag_map_column : boolean;
  signal slice1_best_tag_output_column, slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  signal slice1_best_second_0_0, slice1_best_second_1_0, slice1_best_but_last_0_0 : natural range 0 to 1023;
  signal slice1_best_but_last_1_0 : natural range 0 to 1023;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 127;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 127;
  signal slice2shift_search_3_0, slice2shift_search_3_1, slice2shift_reference_0 : natural range 0 to 127;
  signal slice2shift_reference_1, slice2shift_reference_2, slice2shift_reference_3 : natural range 0 to 127;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -127 to 127;
  signal slice2cost_difference_1_1, slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -127 to 127;
  signal slice2cost_difference_3_0, slice2cost_difference_3_1 : integer range -127 to 127;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1, slice2cost_single_0_0 : natural range 0 to 255;
  signal slice2cost_single_0_1, slice2cost_single_3_0, slice2cost_single_3_1 : natural range 0 to 255;
  signal slice2cost_column_0_0, slice2cost_column_0_1, slice2cost_column_1_0 : natural range 0 to 255;
  signal slice2cost_column_1_1 : natural range 0 to 255;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1, slice2cost_tag_output_column : boolean;
  signal slice2cost_tag_first_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1, slice2window_partial_1_0_0 : natural range 0 to 255;
  signal slice2window_partial_1_0_1 : natural range 0 to 255;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_partial_1_1_0 : natural range 0 to 510;
  signal slice2window_partial_1_1_1 : natural range 0 to 510;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_1_0 : natural range 0 to 765;
  signal slice2window_sum_1_1 : natural range 0 to 765;
  -- slice2other
  signal slice2other_cost_0_0, slice2other_cost_1_0 : natural range 0 to 765;
  signal slice2other_winner_0_0, slice2other_winner_1_0 : natural range 0 to 6;
  signal slice2other_winner_0_1, slice2other_winner_1_1, slice2other_winner_out_0 : natural range 0 to 7;
  signal slice2other_winner_out_1 : natural range 0 to 7;
  -- slice2winner1
  signal slice2winner1_held_0_0, slice2winner1_held_0_1, slice2winner1_held_1_0 : natural range 0 to 765;
  signal slice2winner1_held_1_1, slice2winner1_best_cost_0_0, slice2winner1_best_cost_1_0 : natural range 0 to 765;
  signal slice2winner1_best_below_0_0, slice2winner1_best_below_1_0 : natural range 0 to 765;
  signal slice2winner1_best_above_0_0, slice2winner1_best_above_1_0 : natural range 0 to 765;
  signal slice2winner1_best_late_cost_0_0, slice2winner1_best_late_cost_1_0 : natural range 0 to 765;
  signal slice2winner1_best_index_0_0, slice2winner1_best_index_1_0 : boolean;
  signal slice2winner1_best_but_first_0_0, slice2winner1_best_but_first_1_0 : natural range 0 to 1023;
  -- slice2winner2
  signal slice2winner2_best_index_0_0, slice2winner2_best_index_1_0 : boolean;
  signal slice2winner2_best_below_0_0, slice2winner2_best_below_1_0 : natural range 0 to 765;
  signal slice2winner2_best_above_0_0, slice2winner2_best_above_1_0 : natural range 0 to 765;
  signal slice2winner2_best_first_0_0, slice2winner2_best_first_1_0 : natural range 0 to 765;
  signal slice2winner2_best_late_cost_0_0, slice2winner2_best_late_cost_1_0 : natural range 0 to 765;
  signal slice2winner2_best_but_first_0_0, slice2winner2_best_but_first_1_0 : natural range 0 to 1023;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_cost_1_0, slice2_best_below_0_0 : natural range 0 to 765;
  signal slice2_best_below_1_0, slice2_best_above_0_0, slice2_best_above_1_0 : natural range 0 to 765;
  signal slice2_best_late_cost_0_0, slice2_best_late_cost_1_0 : natural range 0 to 765;
  signal slice2_best_index_0_0, slice2_best_index_1_0 : natural range 0 to 7;
  signal slice2_best_place_0_0, slice2_best_place_1_0, slice2_best_at_start_0_0, slice2_best_at_start_1_0 : boolean;
  signal slice2_best_at_end_0_0, slice2_best_at_end_1_0, slice2_best_tag_valid, slice2_best_tag_map_column : boolean;
  signal slice2_best_tag_output_column, slice2_best_tag_start_of_frame, slice2_best_tag_end_of_line : boolean;
  signal slice2_best_second_0_0, slice2_best_second_1_0 : natural range 0 to 1023;
  -- texture
  signal texture_taps_search_0_0, texture_taps_search_1_0, texture_taps_search_3_0 : natural range 0 to 31;
  signal texture_passes_0_0, texture_passes_0_1, texture_passes_1_0, texture_passes_1_1, texture_passes_2_0 : boolean;
  signal texture_passes_2_1, texture_passes_3_0, texture_passes_3_1, texture_passes_4_0, texture_passes_4_1 : boolean;
  -- texturecost
  signal texturecost_difference_0_0, texturecost_difference_1_0, texturecost_difference_2_0 : integer range -127 to 31;
  signal texturecost_difference_3_0 : integer range -127 to 31;
  signal texturecost_pair_0_0 : natural range 0 to 253;
  signal texturecost_negative_0_0 : boolean;
  signal texturecost_single_0_0, texturecost_single_3_0, texturecost_column_0_0 : natural range 0 to 255;
  signal texturecost_column_1_0 : natural range 0 to 255;
  -- texturewindow
  signal texturewindow_partial_0_0_0, texturewindow_partial_1_0_0 : natural range 0 to 255;
  signal texturewindow_partial_0_1_0, texturewindow_partial_1_1_0 : natural range 0 to 510;
  signal texturewindow_sum_0_0, texturewindow_sum_1_0 : natural range 0 to 765;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_0_1, refinement_disparity_1_0 : natural range 0 to 7;
  signal refinement_disparity_1_1, refinement_disparity_2_0, refinement_disparity_2_1 : natural range 0 to 7;
  signal refinement_disparity_3_0, refinement_disparity_3_1, refinement_disparity_4_0 : natural range 0 to 7;
  signal refinement_disparity_4_1, refinement_disparity_5_0, refinement_disparity_5_1 : natural range 0 to 7;
  signal refinement_disparity_6_0, refinement_disparity_6_1, refinement_disparity_7_0 : natural range 0 to 7;
  signal refinement_disparity_7_1, refinement_disparity_8_0, refinement_disparity_8_1 : natural range 0 to 7;
  signal refinement_disparity_9_0, refinement_disparity_9_1, refinement_disparity_10_0 : natural range 0 to 7;
  signal refinement_disparity_10_1, refinement_disparity_11_0, refinement_disparity_11_1 : natural range 0 to 7;
  signal refinement_passed_0_0, refinement_passed_0_1, refinement_passed_1_0, refinement_passed_1_1 : boolean;
  signal refinement_passed_2_0, refinement_passed_2_1, refinement_passed_3_0, refinement_passed_3_1 : boolean;
  signal refinement_passed_4_0, refinement_passed_4_1, refinement_passed_5_0, refinement_passed_5_1 : boolean;
  signal refinement_passed_6_0, refinement_passed_6_1, refinement_passed_7_0, refinement_passed_7_1 : boolean;
  signal refinement_passed_8_0, refinement_passed_8_1, refinement_passed_9_0, refinement_passed_9_1 : boolean;
  signal refinement_passed_10_0, refinement_passed_10_1, refinement_passed_11_0, refinement_passed_11_1 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_map_column, refinement_tag_0_output_column : boolean;
  signal refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line, refinement_tag_1_valid : boolean;
  signal refinement_tag_1_map_column, refinement_tag_1_output_column, refinement_tag_1_start_of_frame : boolean;
  signal refinement_tag_1_end_of_line, refinement_tag_2_valid, refinement_tag_2_map_column : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_map_column, refinement_tag_3_output_column : boolean;
  signal refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line, refinement_tag_4_valid : boolean;
  signal refinement_tag_4_map_column, refinement_tag_4_output_column, refinement_tag_4_start_of_frame : boolean;
  signal refinement_tag_4_end_of_line, refinement_tag_5_valid, refinement_tag_5_map_column : boolean;
  signal refinement_tag_5_output_column, refinement_tag_5_start_of_frame, refinement_tag_5_end_of_line : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_map_column, refinement_tag_6_output_column : boolean;
  signal refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line, refinement_tag_7_valid : boolean;
  signal refinement_tag_7_map_column, refinement_tag_7_output_column, refinement_tag_7_start_of_frame : boolean;
  signal refinement_tag_7_end_of_line, refinement_tag_8_valid, refinement_tag_8_map_column : boolean;
  signal refinement_tag_8_output_column, refinement_tag_8_start_of_frame, refinement_tag_8_end_of_line : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_map_column, refinement_tag_9_output_column : boolean;
  signal refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line, refinement_tag_10_valid : boolean;
  signal refinement_tag_10_map_column, refinement_tag_10_output_column, refinement_tag_10_start_of_frame : boolean;
  signal refinement_tag_10_end_of_line, refinement_tag_11_valid, refinement_tag_11_map_column : boolean;
  signal refinement_tag_11_output_column, refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line : boolean;
  signal refinement_alone_0_0, refinement_alone_0_1, refinement_alone_1_0, refinement_alone_1_1 : boolean;
  signal refinement_negative_0_0, refinement_negative_0_1, refinement_negative_1_0, refinement_negative_1_1 : boolean;
  signal refinement_negative_2_0, refinement_negative_2_1, refinement_negative_3_0, refinement_negative_3_1 : boolean;
  signal refinement_negative_4_0, refinement_negative_4_1, refinement_negative_5_0, refinement_negative_5_1 : boolean;
  signal refinement_negative_6_0, refinement_negative_6_1, refinement_negative_7_0, refinement_negative_7_1 : boolean;
  signal refinement_negative_8_0, refinement_negative_8_1 : boolean;
  signal refinement_gap_0, refinement_gap_1, refinement_u_0, refinement_u_1, refinement_v_0 : natural range 0 to 1023;
  signal refinement_v_1, refinement_remainder_1_0, refinement_remainder_1_1 : natural range 0 to 1023;
  signal refinement_remainder_2_0, refinement_remainder_2_1, refinement_remainder_3_0 : natural range 0 to 1023;
  signal refinement_remainder_3_1, refinement_remainder_4_0, refinement_remainder_4_1 : natural range 0 to 1023;
  signal refinement_remainder_5_0, refinement_remainder_5_1, refinement_remainder_6_0 : natural range 0 to 1023;
  signal refinement_remainder_6_1, refinement_remainder_7_0, refinement_remainder_7_1 : natural range 0 to 1023;
  signal refinement_divisor_0_0, refinement_divisor_0_1, refinement_divisor_1_0 : natural range 0 to 1023;
  signal refinement_divisor_1_1, refinement_divisor_2_0, refinement_divisor_2_1 : natural range 0 to 1023;
  signal refinement_divisor_3_0, refinement_divisor_3_1, refinement_divisor_4_0 : natural range 0 to 1023;
  signal refinement_divisor_4_1, refinement_divisor_5_0, refinement_divisor_5_1 : natural range 0 to 1023;
  signal refinement_divisor_6_0, refinement_divisor_6_1, refinement_divisor_7_0 : natural range 0 to 1023;
  signal refinement_divisor_7_1 : natural range 0 to 1023;
  signal refinement_lowest_0, refinement_lowest_1, refinement_scaled_cost_0 : natural range 0 to 765;
  signal refinement_scaled_cost_1, refinement_below_0, refinement_below_1, refinement_above_0 : natural range 0 to 765;
  signal refinement_above_1, refinement_remainder_0_0, refinement_remainder_0_1 : natural range 0 to 765;
  signal refinement_scaled_gap_0, refinement_scaled_gap_1 : natural range 0 to 10230;
  signal refinement_difference_0, refinement_difference_1 : integer range -765 to 765;
  signal refinement_quotient_8_0, refinement_quotient_8_1, refinement_fraction_0 : natural range 0 to 255;
  signal refinement_fraction_1 : natural range 0 to 31;
  -- leftright
  signal leftright_other_1_0, leftright_other_1_1, leftright_other_2_0, leftright_other_2_1 : natural range 0 to 7;
  signal leftright_other_3_0, leftright_other_3_1, leftright_other_4_0, leftright_other_4_1 : natural range 0 to 7;
  signal leftright_other_5_0, leftright_other_5_1, leftright_other_6_0, leftright_other_6_1 : natural range 0 to 7;
  signal leftright_other_7_0, leftright_other_7_1, leftright_other_8_0, leftright_other_8_1 : natural range 0 to 7;
  signal leftright_other_9_0, leftright_other_9_1, leftright_other_10_0, leftright_other_10_1 : natural range 0 to 7;
  signal leftright_other_11_0, leftright_other_11_1, leftright_other_12_0, leftright_other_12_1 : natural range 0 to 7;
  signal leftright_other_13_0, leftright_other_13_1, leftright_ring_read_address : natural range 0 to 7;
  signal leftright_ring_write_address, leftright_asking_disparity_0 : natural range 0 to 7;
  signal leftright_asking_disparity_1, leftright_answered_disparity_0 : natural range 0 to 7;
  signal leftright_answered_disparity_1, leftright_checked_disparity_0 : natural range 0 to 7;
  signal leftright_checked_disparity_1 : natural range 0 to 7;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_passed_1 : boolean;
  signal leftright_asking_tag_valid, leftright_asking_tag_map_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_passed_1 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_map_column : boolean;
  signal leftright_answered_tag_start_of_frame, leftright_answered_tag_end_of_line : boolean;
  signal leftright_checked_passed_0, leftright_checked_passed_1, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0, leftright_address_1 : natural range 0 to 15;
  signal leftright_held_0 : unsigned(31 downto 0);
  signal leftright_asking_fraction_0, leftright_asking_fraction_1 : natural range 0 to 31;
  signal leftright_answered_fraction_0, leftright_answered_fraction_1 : natural range 0 to 31;
  signal leftright_checked_fraction_0, leftright_checked_fraction_1 : natural range 0 to 31;
  signal leftright_found_0, leftright_found_1 : unsigned(2 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 31;
  signal map_sorted_column : natural range 0 to 31;
  signal map_counter_group : natural range 0 to 7;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_bottom, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b, map_of_column_1_c_below_a, map_of_column_1_c_below_b : boolean;
  signal map_column_passed_0_0, map_column_passed_0_1, map_column_passed_1_0, map_column_passed_1_1 : boolean;
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output : boolean;
  signal map_sorted_arrives, map_sorted_behind, map_sorted_top, map_sorted_output, map_passed_0_0 : boolean;
  signal map_passed_0_1, map_passed_1_0, map_passed_1_1, map_window_complete, map_window_first : boolean;
  signal map_window_last, map_of_low_0_b_below_a, map_of_low_0_c_below_a, map_of_low_0_c_below_b : boolean;
  signal map_of_low_1_b_below_a, map_of_low_1_c_below_a, map_of_low_1_c_below_b, map_of_middle_0_b_below_a : boolean;
  signal map_of_middle_0_c_below_a, map_of_middle_0_c_below_b, map_of_middle_1_b_below_a : boolean;
  signal map_of_middle_1_c_below_a, map_of_middle_1_c_below_b, map_of_high_0_b_below_a : boolean;
  signal map_of_high_0_c_below_a, map_of_high_0_c_below_b, map_of_high_1_b_below_a, map_of_high_1_c_below_a : boolean;
  signal map_of_high_1_c_below_b, map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_of_all_1_b_below_a, map_of_all_1_c_below_a, map_of_all_1_c_below_b, map_waiting_0_complete : boolean;
  signal map_waiting_0_first, map_waiting_0_last, map_waiting_1_complete, map_waiting_1_first : boolean;
  signal map_waiting_1_last, map_waiting_2_complete, map_waiting_2_first, map_waiting_2_last : boolean;
  signal map_waiting_passed_0_0, map_waiting_passed_0_1, map_waiting_passed_1_0, map_waiting_passed_1_1 : boolean;
  signal map_waiting_passed_2_0, map_waiting_passed_2_1, map_out_passed_0, map_out_passed_1, map_out_valid : boolean;
  signal map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_newest_1, map_rows_read_newest_0, map_rows_read_newest_1 : natural range 0 to 65535;
  signal map_rows_ready_newest_0, map_rows_ready_newest_1, map_rows_write_words_1 : natural range 0 to 65535;
  signal map_column_3 : natural range 0 to 65535;
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_read_words_1 : unsigned(12 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
  signal map_rows_ready_words_1, map_column_1, map_column_2 : natural range 0 to 8191;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0 : natural range 0 to 4095;
  signal map_sorted_middle_0, map_sorted_high_0, map_low_0_0, map_low_1_0, map_low_2_0 : natural range 0 to 4095;
  signal map_middle_0_0, map_middle_1_0, map_middle_2_0, map_high_0_0, map_high_1_0 : natural range 0 to 4095;
  signal map_high_2_0, map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a : natural range 0 to 4095;
  signal map_of_middle_0_b, map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b : natural range 0 to 4095;
  signal map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0 : natural range 0 to 4095;
  signal map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 4095;
  signal map_of_column_1_c, map_sorted_low_1, map_sorted_middle_1, map_sorted_high_1 : natural range 0 to 32767;
  signal map_low_0_1, map_low_1_1, map_low_2_1, map_middle_0_1, map_middle_1_1 : natural range 0 to 32767;
  signal map_middle_2_1, map_high_0_1, map_high_1_1, map_high_2_1, map_of_low_1_a : natural range 0 to 32767;
  signal map_of_low_1_b, map_of_low_1_c, map_of_middle_1_a, map_of_middle_1_b : natural range 0 to 32767;
  signal map_of_middle_1_c, map_of_high_1_a, map_of_high_1_b, map_of_high_1_c : natural range 0 to 32767;
  signal map_largest_low_1, map_median_middle_1, map_smallest_high_1, map_of_all_1_a : natural range 0 to 32767;
  signal map_of_all_1_b, map_of_all_1_c, map_out_disparity_1 : natural range 0 to 32767;
  -- other
  signal other_0, other_2 : unsigned(48 downto 0);
  signal other_1 : natural range 0 to 8190;
  signal other_3, other_4 : natural range 0 to 254;
  signal other_5, other_6 : natural range 0 to 252;
  signal other_7, other_8 : natural range 0 to 248;
  signal other_9, other_10 : natural range 0 to 240;
  signal other_11, other_12 : natural range 0 to 224;
  signal other_13, other_14 : natural range 0 to 192;
  signal other_15, other_16 : natural range 0 to 128;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal map_rows_read_words_1_memory_read_enable : boolean;
  signal map_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal map_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal map_rows_read_words_1_memory_write_data : unsigned(12 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal map_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal leftright_found_1_memory_read_enable : boolean;
  signal leftright_found_1_memory_read_address : unsigned(3 downto 0);
  signal leftright_found_1_memory_write_address : unsigned(3 downto 0);
  signal leftright_found_1_memory_write_data : unsigned(2 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(2 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address : unsigned(2 downto 0);
  signal leftright_held_0_memory_write_address : unsigned(2 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(20 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(20 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_1, 16) & to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_1), 1) & to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 24);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 24);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_1_memory_read_enable <= true;
  map_rows_read_words_1_memory_read_address <= to_unsigned(map_counter_column, 5);
  map_rows_read_words_1_memory_write_address <= to_unsigned(map_at_column, 5);
  map_rows_read_words_1_memory_write_data <= to_unsigned((map_rows_write_words_1 mod 8192), 13);
  map_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 13, address_bits => 5)
    port map (
      clock => clock, read_enable => map_rows_read_words_1_memory_read_enable,
      read_address => map_rows_read_words_1_memory_read_address, read_data => map_rows_read_words_1,
      write_address => map_rows_read_words_1_memory_write_address, write_data => map_rows_read_words_1_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 5);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 5);
  map_rows_read_words_0_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 26, address_bits => 5)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  leftright_found_1_memory_read_enable <= true;
  leftright_found_1_memory_read_address <= to_unsigned(leftright_address_1, 4);
  leftright_found_1_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_1_memory_write_data <= to_unsigned(leftright_other_13_1, 3);
  leftright_found_1_memory : entity work.line_memory
    generic map (depth => 16, width => 3, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_1_memory_read_enable,
      read_address => leftright_found_1_memory_read_address, read_data => leftright_found_1,
      write_address => leftright_found_1_memory_write_address, write_data => leftright_found_1_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 4);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_13_0, 3);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 3, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 3);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 3);
  leftright_held_0_memory_write_data <= ((to_unsigned(refinement_fraction_1, 5) & to_unsigned(as_number(refinement_tag_11_end_of_line), 24) & to_unsigned(as_number(refinement_tag_11_start_of_frame), 1) & to_unsigned(as_number(refinement_tag_11_output_column), 1) & to_unsigned(as_number(refinement_tag_11_map_column), 1)) or (to_unsigned(as_number(refinement_passed_11_1), 6) & to_unsigned(to_integer(((((to_unsigned(refinement_disparity_11_1, 3) & to_unsigned(0, 18)) or (to_unsigned(refinement_fraction_0, 8) & to_unsigned(0, 13)))) or (to_unsigned(as_number(refinement_passed_11_0), 9) & to_unsigned(refinement_disparity_11_0, 8) & to_unsigned(0, 4)))), 26)));
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned((rows_search_rows_write_words_0 mod 2097152), 21);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 21, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned((rows_reference_rows_write_words_0 mod 2097152), 21);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 21, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_counter_group_choice_2, transform_read_row_inside_0_value : boolean;
    variable transform_read_row_inside_0_any, transform_read_row_inside_1_any : boolean;
    variable transform_read_column_inside_0_differs, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choice_2, transform_left_filter_column_0_0_choice_3 : boolean;
    variable transform_left_filter_column_0_1_choice_3, transform_right_filter_column_0_0_choice_3 : boolean;
    variable transform_right_filter_column_0_1_choice_3, raster_place_group_is_equal : boolean;
    variable raster_place_group_is_equal_2, raster_place_group_all, raster_place_group_is_equal_3 : boolean;
    variable raster_place_group_choice_2, raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable raster_place_next_frame_choice_3, raster_place_next_frame_choice_4, delay_row_inside_0_value : boolean;
    variable delay_row_inside_0_any, delay_row_inside_1_any, delay_row_inside_1_choice : boolean;
    variable delay_tag_map_column_is_less, delay_tag_first_column_is_equal, slice0cost_single_0_0_is_less : boolean;
    variable slice0cost_single_0_1_is_less, slice0cost_single_0_2_is_less, slice0cost_single_3_0_is_less : boolean;
    variable slice0cost_single_3_1_is_less, slice0cost_single_3_2_is_less, slice0other_cost_0_1_all : boolean;
    variable slice0other_cost_0_1_choice, slice0other_cost_0_2_all, slice0other_cost_1_1_choice : boolean;
    variable slice0other_cost_1_2_choice, slice0winner1_best_index_0_0_is_not_less : boolean;
    variable slice0winner1_best_index_1_0_is_not_less, slice0winner2_best_index_0_0_is_less : boolean;
    variable slice0winner2_best_index_1_0_is_less, slice0winner2_best_place_0_0_is_not_less : boolean;
    variable slice0winner2_best_place_1_0_is_not_less, slice1cost_single_0_0_is_less : boolean;
    variable slice1cost_single_0_1_is_less, slice1cost_single_0_2_is_less, slice1cost_single_3_0_is_less : boolean;
    variable slice1cost_single_3_1_is_less, slice1cost_single_3_2_is_less, slice1other_cost_0_0_any : boolean;
    variable slice1other_cost_0_0_choice, slice1other_cost_0_1_choice, slice1other_cost_0_2_any : boolean;
    variable slice1other_cost_1_0_choice, slice1other_cost_1_1_choice, slice1other_cost_1_2_choice : boolean;
    variable slice1winner1_best_index_0_0_is_not_less, slice1winner1_best_index_1_0_is_not_less : boolean;
    variable slice1winner2_best_index_0_0_is_less, slice1winner2_best_index_1_0_is_less : boolean;
    variable slice1winner2_best_place_0_0_is_not_less, slice1winner2_best_place_1_0_is_not_less : boolean;
    variable slice1_best_index_0_0_is_less, slice1_best_index_1_0_is_less, slice1_best_below_0_0_is_equal : boolean;
    variable slice1_best_below_1_0_is_equal, slice1_best_above_0_0_is_equal, slice1_best_above_1_0_is_equal : boolean;
    variable slice1_best_place_0_0_is_not_less, slice1_best_place_1_0_is_not_less : boolean;
    variable slice2cost_single_0_0_is_less, slice2cost_single_0_1_is_less, slice2cost_single_3_0_is_less : boolean;
    variable slice2cost_single_3_1_is_less, slice2other_cost_0_0_any, slice2other_cost_0_0_choice : boolean;
    variable slice2other_cost_1_0_choice, slice2other_winner_1_1_choice, slice2winner1_best_below_0_0_is_less : boolean;
    variable slice2winner1_best_below_1_0_is_less, slice2_best_index_0_0_is_less : boolean;
    variable slice2_best_index_1_0_is_less, slice2_best_above_0_0_is_equal, slice2_best_above_1_0_is_equal : boolean;
    variable slice2_best_place_0_0_is_not_less, slice2_best_place_1_0_is_not_less : boolean;
    variable texturecost_single_0_0_is_less, texturecost_single_3_0_is_less, refinement_divisor_0_0_is_less : boolean;
    variable refinement_divisor_0_1_is_less, leftright_holds_winners_all, map_counter_column_is_equal : boolean;
    variable map_counter_column_all, map_counter_group_is_equal, map_counter_group_all, map_counter_group_any : boolean;
    variable map_counter_group_is_equal_2, map_counter_next_frame_choice, map_counter_next_frame_choice_2 : boolean;
    variable map_line_ended_choice, map_at_arrives_value, map_passed_1_0_all, map_passed_1_0_any : boolean;
    variable map_window_complete_all : boolean;
    variable transform_counter_group_choice, raster_place_group_choice, map_counter_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 7;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 7;
    variable refinement_fraction_0_choice_2, refinement_fraction_1_choice_2 : natural range 0 to 7;
    variable leftright_address_0_value, leftright_address_1_value, map_counter_group_choice_2 : natural range 0 to 7;
    variable map_counter_group_choice_3 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_choice_2 : natural range 0 to 127;
    variable transform_left_filter_feature_1_choice, transform_left_filter_feature_1_choice_2 : natural range 0 to 255;
    variable transform_right_filter_feature_1_choice : natural range 0 to 255;
    variable transform_right_filter_feature_1_choice_2 : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_left_filter_column_0_1_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_1_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_1_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_1_choice_2, slice0cost_single_0_0_choice : natural range 0 to 255;
    variable slice0cost_single_0_1_choice, slice0cost_single_0_2_choice : natural range 0 to 255;
    variable slice0cost_single_3_0_choice, slice0cost_single_3_1_choice : natural range 0 to 255;
    variable slice0cost_single_3_2_choice, slice1cost_single_0_0_choice : natural range 0 to 255;
    variable slice1cost_single_0_1_choice, slice1cost_single_0_2_choice : natural range 0 to 255;
    variable slice1cost_single_3_0_choice, slice1cost_single_3_1_choice : natural range 0 to 255;
    variable slice1cost_single_3_2_choice, slice2cost_single_0_0_choice : natural range 0 to 255;
    variable slice2cost_single_0_1_choice, slice2cost_single_3_0_choice : natural range 0 to 255;
    variable slice2cost_single_3_1_choice, texturecost_single_0_0_choice : natural range 0 to 255;
    variable texturecost_single_3_0_choice, refinement_fraction_0_choice : natural range 0 to 255;
    variable transform_right_filter_feature_0_choice : natural range 0 to 65535;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 65535;
    variable slice0winner2_best_above_0_0_choice, slice0winner2_best_above_1_0_choice : natural range 0 to 765;
    variable slice1winner2_best_above_0_0_choice, slice1winner2_best_above_1_0_choice : natural range 0 to 765;
    variable slice1_best_below_0_0_choice, slice1_best_below_1_0_choice : natural range 0 to 765;
    variable slice1_best_above_0_0_choice, slice1_best_above_1_0_choice : natural range 0 to 765;
    variable slice2_best_below_0_0_choice, slice2_best_below_1_0_choice : natural range 0 to 765;
    variable slice2_best_above_0_0_choice, slice2_best_above_1_0_choice : natural range 0 to 765;
    variable slice0winner2_best_second_0_0_choice, slice0winner2_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice0winner2_best_second_0_0_choice_3, slice0winner2_best_second_1_0_choice : natural range 0 to 1023;
    variable slice0winner2_best_second_1_0_choice_2, slice0winner2_best_second_1_0_choice_3 : natural range 0 to 1023;
    variable slice1winner2_best_second_0_0_choice, slice1winner2_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice1winner2_best_second_0_0_choice_3, slice1winner2_best_second_1_0_choice : natural range 0 to 1023;
    variable slice1winner2_best_second_1_0_choice_2, slice1winner2_best_second_1_0_choice_3 : natural range 0 to 1023;
    variable slice1_best_second_0_0_choice, slice1_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice1_best_second_0_0_choice_3, slice1_best_second_0_0_choice_4 : natural range 0 to 1023;
    variable slice1_best_second_1_0_choice, slice1_best_second_1_0_choice_2 : natural range 0 to 1023;
    variable slice1_best_second_1_0_choice_3, slice1_best_second_1_0_choice_4 : natural range 0 to 1023;
    variable slice2_best_second_0_0_choice, slice2_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice2_best_second_0_0_choice_3, slice2_best_second_0_0_choice_4 : natural range 0 to 1023;
    variable slice2_best_second_1_0_choice, slice2_best_second_1_0_choice_2 : natural range 0 to 1023;
    variable slice2_best_second_1_0_choice_3, slice2_best_second_1_0_choice_4 : natural range 0 to 1023;
    variable refinement_divisor_0_0_choice, refinement_divisor_0_1_choice : natural range 0 to 1023;
    variable refinement_remainder_1_0_difference, refinement_remainder_1_1_difference : natural range 1025 to 2813;
    variable refinement_remainder_2_0_difference, refinement_remainder_2_1_difference : natural range 1025 to 4094;
    variable refinement_remainder_3_0_difference, refinement_remainder_3_1_difference : natural range 1025 to 4094;
    variable refinement_remainder_4_0_difference, refinement_remainder_4_1_difference : natural range 1025 to 4094;
    variable refinement_remainder_5_0_difference, refinement_remainder_5_1_difference : natural range 1025 to 4094;
    variable refinement_remainder_6_0_difference, refinement_remainder_6_1_difference : natural range 1025 to 4094;
    variable refinement_remainder_7_0_difference, refinement_remainder_7_1_difference : natural range 1025 to 4094;
    variable refinement_fraction_0_difference, refinement_fraction_1_difference : integer range -15 to 0;
    variable refinement_fraction_0_value, refinement_fraction_1_value : natural range 0 to 16;
    variable refinement_fraction_1_choice : natural range 0 to 31;
    variable leftright_checked_passed_0_difference, leftright_checked_passed_1_difference : integer range -6 to 8;
    variable map_of_column_0_a_choice, map_sorted_low_0_choice, map_sorted_low_0_choice_2 : natural range 0 to 4095;
    variable map_sorted_middle_0_choice, map_sorted_middle_0_choice_2 : natural range 0 to 4095;
    variable map_sorted_high_0_choice, map_sorted_high_0_choice_2, map_largest_low_0_choice : natural range 0 to 4095;
    variable map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 4095;
    variable map_median_middle_0_choice_2, map_median_middle_0_choice_3 : natural range 0 to 4095;
    variable map_median_middle_0_choice_4, map_smallest_high_0_choice : natural range 0 to 4095;
    variable map_smallest_high_0_choice_2, map_out_disparity_0_choice : natural range 0 to 4095;
    variable map_out_disparity_0_choice_2, map_out_disparity_0_choice_3 : natural range 0 to 4095;
    variable map_out_disparity_0_choice_4, map_low_0_0_choice, map_middle_0_0_choice : natural range 0 to 4095;
    variable map_high_0_0_choice : natural range 0 to 4095;
    variable map_of_column_1_c_choice, map_sorted_low_1_choice, map_sorted_low_1_choice_2 : natural range 0 to 32767;
    variable map_sorted_middle_1_choice, map_sorted_middle_1_choice_2 : natural range 0 to 32767;
    variable map_sorted_high_1_choice, map_sorted_high_1_choice_2, map_largest_low_1_choice : natural range 0 to 32767;
    variable map_largest_low_1_choice_2, map_median_middle_1_choice : natural range 0 to 32767;
    variable map_median_middle_1_choice_2, map_median_middle_1_choice_3 : natural range 0 to 32767;
    variable map_median_middle_1_choice_4, map_smallest_high_1_choice : natural range 0 to 32767;
    variable map_smallest_high_1_choice_2, map_out_disparity_1_choice : natural range 0 to 32767;
    variable map_out_disparity_1_choice_2, map_out_disparity_1_choice_3 : natural range 0 to 32767;
    variable map_out_disparity_1_choice_4, map_low_0_1_choice, map_middle_0_1_choice : natural range 0 to 32767;
    variable map_high_0_1_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 31;
      transform_counter_group_is_equal_2 := transform_counter_group = 5;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 3;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_is_equal_3 := (transform_counter_group / 2) = 3;
      if transform_counter_group_is_equal_3 then
        transform_counter_group_choice_2 := in_valid and (not ((transform_counter_group mod 2) = 1));
      else
        transform_counter_group_choice_2 := in_valid;
      end if;
      if transform_counter_next_frame and (transform_counter_group = 6) then
        transform_counter_group_choice_3 := 1;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 8;
      end if;
      if transform_counter_group_is_equal and transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      transform_read_row_inside_0_value := ((transform_counter_group / 2) mod 2) = 1;
      transform_read_row_inside_0_any := ((transform_counter_group / 4) = 1) or transform_read_row_inside_0_value;
      transform_read_row_inside_1_any := (not ((transform_counter_group / 4) = 1)) or (not
        transform_read_row_inside_0_value);
      transform_read_column_inside_0_differs := (transform_counter_column / 2) /= 0;
      if 31 < transform_left_filter_slope_0 then
        transform_left_filter_feature_0_choice := 62;
      else
        transform_left_filter_feature_0_choice := (transform_left_filter_slope_0 + 31) mod 128;
      end if;
      if transform_left_filter_slope_0 < (-31) then
        transform_left_filter_feature_0_choice_2 := 0;
      else
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      end if;
      if 31 < transform_left_filter_slope_1 then
        transform_left_filter_feature_1_choice := 62;
      else
        transform_left_filter_feature_1_choice := (transform_left_filter_slope_1 + 31) mod 256;
      end if;
      if transform_left_filter_slope_1 < (-31) then
        transform_left_filter_feature_1_choice_2 := 0;
      else
        transform_left_filter_feature_1_choice_2 := transform_left_filter_feature_1_choice;
      end if;
      if 31 < transform_right_filter_slope_0 then
        transform_right_filter_feature_0_choice := 62;
      else
        transform_right_filter_feature_0_choice := (transform_right_filter_slope_0 + 31) mod 65536;
      end if;
      if transform_right_filter_slope_0 < (-31) then
        transform_right_filter_feature_0_choice_2 := 0;
      else
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      end if;
      if 31 < transform_right_filter_slope_1 then
        transform_right_filter_feature_1_choice := 62;
      else
        transform_right_filter_feature_1_choice := (transform_right_filter_slope_1 + 31) mod 256;
      end if;
      if transform_right_filter_slope_1 < (-31) then
        transform_right_filter_feature_1_choice_2 := 0;
      else
        transform_right_filter_feature_1_choice_2 := transform_right_filter_feature_1_choice;
      end if;
      transform_left_0 <= in_left_pixel mod 256;
      transform_left_1 <= in_left_pixel / 256;
      transform_right_0 <= in_right_pixel mod 256;
      transform_right_1 <= in_right_pixel / 256;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_read_newest_1 <= transform_left_1;
      transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_left_rows_ready_newest_1 <= transform_left_rows_read_newest_1;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_read_newest_1 <= transform_right_1;
      transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_right_rows_ready_newest_1 <= transform_right_rows_read_newest_1;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= transform_read_row_inside_0_any;
      transform_read_row_inside_3 <= transform_read_row_inside_1_any;
      transform_read_column_inside_0 <= transform_read_column_inside_0_differs or ((transform_counter_column mod 2) =
        1);
      transform_read_column_inside_1 <= true;
      transform_read_column_inside_2 <= transform_read_column_inside_0_differs or (not ((transform_counter_column mod
        2) = 1));
      transform_read_start_of_frame <= (transform_counter_column = 1) and (transform_counter_group = 1);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_3 <= transform_read_row_inside_3;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 256;
      transform_left_column_1 <= (transform_left_rows_ready_words_0 / 256) mod 256;
      transform_left_column_2 <= transform_left_rows_ready_words_0 / 65536;
      transform_left_column_3 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 256;
      transform_right_column_1 <= (transform_right_rows_ready_words_0 / 256) mod 256;
      transform_right_column_2 <= transform_right_rows_ready_words_0 / 65536;
      transform_right_column_3 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_3 <= transform_ready_row_inside_3;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_slope_0 <= transform_left_filter_column_0_0 - transform_left_filter_column_2_0;
      transform_left_filter_slope_1 <= transform_left_filter_column_0_1 - transform_left_filter_column_2_1;
      transform_left_filter_whole <= transform_filtering_0_column_inside_2 and transform_filtering_0_column_inside_0;
      transform_right_filter_slope_0 <= transform_right_filter_column_0_0 - transform_right_filter_column_2_0;
      transform_right_filter_slope_1 <= transform_right_filter_column_0_1 - transform_right_filter_column_2_1;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      transform_filtering_2_start_of_frame <= transform_filtering_1_start_of_frame;
      transform_filtering_2_valid <= transform_filtering_1_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 2;
      else
        transform_counter_group <= transform_counter_group_choice_4;
      end if;
      if (transform_counter_group mod 2) = 1 then
        transform_read_row_inside_1 <= transform_read_row_inside_1_any;
      else
        transform_read_row_inside_1 <= transform_read_row_inside_0_any;
      end if;
      if transform_left_filter_whole then
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_2;
        transform_left_filter_feature_1 <= transform_left_filter_feature_1_choice_2;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_2;
        transform_right_filter_feature_1 <= transform_right_filter_feature_1_choice_2;
      else
        transform_left_filter_feature_0 <= 31;
        transform_left_filter_feature_1 <= 31;
        transform_right_filter_feature_0 <= 31;
        transform_right_filter_feature_1 <= 31;
      end if;
      if transform_counter_group_is_equal_3 then
        transform_counter_next_frame_choice := transform_counter_next_frame and ((transform_counter_group mod 2) = 1);
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 32;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= transform_counter_group_all or (not in_start_of_frame);
        else
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_words_0 / 65536) +
          (transform_left_rows_ready_newest_0 * 256) + (transform_left_rows_ready_newest_1 * 65536);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_words_0 / 65536) +
          (transform_right_rows_ready_newest_0 * 256) + (transform_right_rows_ready_newest_1 * 65536);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_row_inside_0 then
        transform_left_filter_column_0_0_choice := transform_left_column_0;
      else
        transform_left_filter_column_0_0_choice := transform_left_column_2;
      end if;
      if transform_columns_row_inside_1 then
        transform_left_filter_column_0_0_choice_2 := transform_left_column_2;
      else
        transform_left_filter_column_0_0_choice_2 := transform_left_column_0;
      end if;
      if transform_columns_row_inside_1 then
        transform_left_filter_column_0_0_choice_3 := (transform_left_column_2 mod 2) = 1;
      else
        transform_left_filter_column_0_0_choice_3 := (transform_left_column_0 mod 2) = 1;
      end if;
      if transform_columns_row_inside_1 then
        transform_left_filter_column_0_1_choice := transform_left_column_1;
      else
        transform_left_filter_column_0_1_choice := transform_left_column_3;
      end if;
      if transform_columns_row_inside_3 then
        transform_left_filter_column_0_1_choice_2 := transform_left_column_3;
      else
        transform_left_filter_column_0_1_choice_2 := transform_left_column_1;
      end if;
      if transform_columns_row_inside_3 then
        transform_left_filter_column_0_1_choice_3 := (transform_left_column_3 mod 2) = 1;
      else
        transform_left_filter_column_0_1_choice_3 := (transform_left_column_1 mod 2) = 1;
      end if;
      if transform_columns_row_inside_0 then
        transform_right_filter_column_0_0_choice := transform_right_column_0;
      else
        transform_right_filter_column_0_0_choice := transform_right_column_2;
      end if;
      if transform_columns_row_inside_1 then
        transform_right_filter_column_0_0_choice_2 := transform_right_column_2;
      else
        transform_right_filter_column_0_0_choice_2 := transform_right_column_0;
      end if;
      if transform_columns_row_inside_1 then
        transform_right_filter_column_0_0_choice_3 := (transform_right_column_2 mod 2) = 1;
      else
        transform_right_filter_column_0_0_choice_3 := (transform_right_column_0 mod 2) = 1;
      end if;
      if transform_columns_row_inside_1 then
        transform_right_filter_column_0_1_choice := transform_right_column_1;
      else
        transform_right_filter_column_0_1_choice := transform_right_column_3;
      end if;
      if transform_columns_row_inside_3 then
        transform_right_filter_column_0_1_choice_2 := transform_right_column_3;
      else
        transform_right_filter_column_0_1_choice_2 := transform_right_column_1;
      end if;
      if transform_columns_row_inside_3 then
        transform_right_filter_column_0_1_choice_3 := (transform_right_column_3 mod 2) = 1;
      else
        transform_right_filter_column_0_1_choice_3 := (transform_right_column_1 mod 2) = 1;
      end if;
      if transform_columns_valid then
        transform_left_filter_column_0_0 <= transform_left_filter_column_0_0_choice +
          (((transform_left_filter_column_0_0_choice_2 / 2) + transform_left_column_1) * 2) +
          as_number(transform_left_filter_column_0_0_choice_3);
        transform_left_filter_column_0_1 <= transform_left_filter_column_0_1_choice +
          (((transform_left_filter_column_0_1_choice_2 / 2) + transform_left_column_2) * 2) +
          as_number(transform_left_filter_column_0_1_choice_3);
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_right_filter_column_0_0 <= transform_right_filter_column_0_0_choice +
          (((transform_right_filter_column_0_0_choice_2 / 2) + transform_right_column_1) * 2) +
          as_number(transform_right_filter_column_0_0_choice_3);
        transform_right_filter_column_0_1 <= transform_right_filter_column_0_1_choice +
          (((transform_right_filter_column_0_1_choice_2 / 2) + transform_right_column_2) * 2) +
          as_number(transform_right_filter_column_0_1_choice_3);
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_is_equal_2 := raster_place_group = 5;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := (raster_place_group / 2) = 3;
      if raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := transform_filtering_2_valid and (not ((raster_place_group mod 2) = 1));
      else
        raster_place_group_choice_2 := transform_filtering_2_valid;
      end if;
      if raster_place_next_frame and (raster_place_group = 6) then
        raster_place_group_choice_3 := 1;
      else
        raster_place_group_choice_3 := (raster_place_group + 1) mod 8;
      end if;
      if raster_place_group_is_equal and raster_place_group_choice_2 then
        raster_place_group_choice_4 := raster_place_group_choice_3;
      else
        raster_place_group_choice_4 := raster_place_group;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if raster_place_group_all then
        raster_place_next_frame_choice_3 := transform_filtering_2_valid;
      else
        raster_place_next_frame_choice_3 := transform_filtering_2_valid and (not transform_filtering_2_start_of_frame);
      end if;
      if raster_place_next_frame_choice_2 then
        raster_place_next_frame_choice_4 := raster_place_next_frame_choice_3;
      else
        raster_place_next_frame_choice_4 := raster_place_group_is_equal and raster_place_group_is_equal_2 and
          transform_filtering_2_valid and transform_filtering_2_start_of_frame;
      end if;
      raster_features_search_0 <= transform_right_filter_feature_0 mod 32768;
      raster_features_search_1 <= transform_right_filter_feature_1;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_reference_1 <= transform_left_filter_feature_1;
      raster_features_valid <= transform_filtering_2_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_4 or ((not transform_filtering_2_valid) and
        raster_place_next_frame);
      if transform_filtering_2_valid and transform_filtering_2_start_of_frame then
        raster_place_group <= raster_place_group_choice * 2;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if transform_filtering_2_valid then
        if raster_place_group_is_equal or transform_filtering_2_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
      end if;
      -- delay
      delay_row_inside_0_value := ((raster_place_group / 2) mod 2) = 1;
      delay_row_inside_0_any := ((raster_place_group / 4) = 1) or delay_row_inside_0_value;
      delay_row_inside_1_any := (not ((raster_place_group / 4) = 1)) or (not delay_row_inside_0_value);
      if (raster_place_group mod 2) = 1 then
        delay_row_inside_1_choice := delay_row_inside_1_any;
      else
        delay_row_inside_1_choice := delay_row_inside_0_any;
      end if;
      delay_tag_map_column_is_less := (((((raster_place_column / 8) + 8191) mod 8192) * 8) + (raster_place_column mod
        8)) < 24;
      delay_tag_first_column_is_equal := raster_place_column = 8;
      delay_ahead_0 <= raster_features_reference_0;
      delay_ahead_1 <= raster_features_reference_1;
      delay_delayed_0 <= to_integer(((to_unsigned(raster_features_search_1, 8) & to_unsigned(0, 7)) or
        (to_unsigned(raster_features_search_0, 15))));
      delay_column <= raster_place_column;
      delay_row_inside_0 <= delay_row_inside_0_any;
      delay_row_inside_1 <= delay_row_inside_1_choice;
      delay_row_inside_3 <= delay_row_inside_1_any;
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_less and delay_row_inside_1_choice;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_group_is_equal;
      if (raster_place_column mod 4) = 3 then
        delay_tag_border_column <= (raster_place_column / 4) = 0;
      else
        delay_tag_border_column <= (raster_place_column / 8) = 0;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0 mod 128;
      rows_search_rows_read_newest_1 <= delay_delayed_0 / 128;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_read_newest_1 <= delay_ahead_1;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_3 <= delay_row_inside_3;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_inside_0 <= rows_ready_inside_0;
      rows_inside_1 <= rows_ready_inside_1;
      rows_inside_3 <= rows_ready_inside_3;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0 mod 128;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 128;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= (rows_search_rows_ready_words_0 / 128) mod 128;
        rows_search_2 <= rows_search_rows_ready_words_0 / 16384;
        rows_reference_1 <= (rows_reference_rows_ready_words_0 / 128) mod 128;
        rows_reference_2 <= rows_reference_rows_ready_words_0 / 16384;
      else
        rows_search_1 <= 0;
        rows_search_2 <= 0;
        rows_reference_1 <= 0;
        rows_reference_2 <= 0;
      end if;
      if rows_ready_inside_3 then
        rows_search_3 <= rows_search_rows_ready_newest_0;
        rows_reference_3 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_3 <= 0;
        rows_reference_3 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 16384) + (rows_search_rows_ready_newest_0 *
          128) + (rows_search_rows_ready_newest_1 * 16384);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 16384) +
          (rows_reference_rows_ready_newest_0 * 128) + (rows_reference_rows_ready_newest_1 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= rows_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_1_0 <= rows_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_2_0 <= rows_search_2;
        slice0shift_search_2_1 <= slice0shift_search_2_0;
        slice0shift_search_2_2 <= slice0shift_search_2_1;
        slice0shift_search_3_0 <= rows_search_3;
        slice0shift_search_3_1 <= slice0shift_search_3_0;
        slice0shift_search_3_2 <= slice0shift_search_3_1;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_search_out_0 <= slice0shift_search_0_2;
      slice0shift_search_out_1 <= slice0shift_search_1_2;
      slice0shift_search_out_2 <= slice0shift_search_2_2;
      slice0shift_search_out_3 <= slice0shift_search_3_2;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_single_0_0_is_less := slice0cost_difference_0_0 < 0;
      if slice0cost_single_0_0_is_less then
        slice0cost_single_0_0_choice := (65535 - slice0cost_difference_0_0) mod 256;
      else
        slice0cost_single_0_0_choice := positive_part(slice0cost_difference_0_0);
      end if;
      slice0cost_single_0_1_is_less := slice0cost_difference_0_1 < 0;
      if slice0cost_single_0_1_is_less then
        slice0cost_single_0_1_choice := (65535 - slice0cost_difference_0_1) mod 256;
      else
        slice0cost_single_0_1_choice := positive_part(slice0cost_difference_0_1);
      end if;
      slice0cost_single_0_2_is_less := slice0cost_difference_0_2 < 0;
      if slice0cost_single_0_2_is_less then
        slice0cost_single_0_2_choice := (65535 - slice0cost_difference_0_2) mod 256;
      else
        slice0cost_single_0_2_choice := positive_part(slice0cost_difference_0_2);
      end if;
      slice0cost_single_3_0_is_less := slice0cost_difference_3_0 < 0;
      if slice0cost_single_3_0_is_less then
        slice0cost_single_3_0_choice := (65535 - slice0cost_difference_3_0) mod 256;
      else
        slice0cost_single_3_0_choice := positive_part(slice0cost_difference_3_0);
      end if;
      slice0cost_single_3_1_is_less := slice0cost_difference_3_1 < 0;
      if slice0cost_single_3_1_is_less then
        slice0cost_single_3_1_choice := (65535 - slice0cost_difference_3_1) mod 256;
      else
        slice0cost_single_3_1_choice := positive_part(slice0cost_difference_3_1);
      end if;
      slice0cost_single_3_2_is_less := slice0cost_difference_3_2 < 0;
      if slice0cost_single_3_2_is_less then
        slice0cost_single_3_2_choice := (65535 - slice0cost_difference_3_2) mod 256;
      else
        slice0cost_single_3_2_choice := positive_part(slice0cost_difference_3_2);
      end if;
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_difference_3_0 <= slice0shift_search_3_0 - slice0shift_reference_3;
      slice0cost_difference_3_1 <= slice0shift_search_3_1 - slice0shift_reference_3;
      slice0cost_difference_3_2 <= slice0shift_search_3_2 - slice0shift_reference_3;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= folded(slice0cost_difference_2_0) + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= folded(slice0cost_difference_2_1) + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= folded(slice0cost_difference_2_2) + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_single_0_0 <= (slice0cost_single_0_0_choice + as_number(slice0cost_single_0_0_is_less)) mod 256;
      slice0cost_single_0_1 <= (slice0cost_single_0_1_choice + as_number(slice0cost_single_0_1_is_less)) mod 256;
      slice0cost_single_0_2 <= (slice0cost_single_0_2_choice + as_number(slice0cost_single_0_2_is_less)) mod 256;
      slice0cost_single_3_0 <= (slice0cost_single_3_0_choice + as_number(slice0cost_single_3_0_is_less)) mod 256;
      slice0cost_single_3_1 <= (slice0cost_single_3_1_choice + as_number(slice0cost_single_3_1_is_less)) mod 256;
      slice0cost_single_3_2 <= (slice0cost_single_3_2_choice + as_number(slice0cost_single_3_2_is_less)) mod 256;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_first_column <= slice0cost_difference_tag_first_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_pair_tag_first_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      if slice0cost_pair_tag_border_column then
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
      else
        slice0cost_column_0_0 <= (as_number(slice0cost_negative_0_0) + slice0cost_pair_0_0 + slice0cost_single_0_0) mod
          256;
        slice0cost_column_0_1 <= (as_number(slice0cost_negative_0_1) + slice0cost_pair_0_1 + slice0cost_single_0_1) mod
          256;
        slice0cost_column_0_2 <= (as_number(slice0cost_negative_0_2) + slice0cost_pair_0_2 + slice0cost_single_0_2) mod
          256;
        slice0cost_column_1_0 <= (as_number(slice0cost_negative_0_0) + slice0cost_pair_0_0 + slice0cost_single_3_0) mod
          256;
        slice0cost_column_1_1 <= (as_number(slice0cost_negative_0_1) + slice0cost_pair_0_1 + slice0cost_single_3_1) mod
          256;
        slice0cost_column_1_2 <= (as_number(slice0cost_negative_0_2) + slice0cost_pair_0_2 + slice0cost_single_3_2) mod
          256;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_1_0 <= slice0window_partial_0_0_0 + slice0cost_column_0_0;
        slice0window_partial_0_1_1 <= slice0window_partial_0_0_1 + slice0cost_column_0_1;
        slice0window_partial_0_1_2 <= slice0window_partial_0_0_2 + slice0cost_column_0_2;
        slice0window_partial_1_0_0 <= slice0cost_column_1_0;
        slice0window_partial_1_0_1 <= slice0cost_column_1_1;
        slice0window_partial_1_0_2 <= slice0cost_column_1_2;
        slice0window_partial_1_1_0 <= slice0window_partial_1_0_0 + slice0cost_column_1_0;
        slice0window_partial_1_1_1 <= slice0window_partial_1_0_1 + slice0cost_column_1_1;
        slice0window_partial_1_1_2 <= slice0window_partial_1_0_2 + slice0cost_column_1_2;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_first_column_0 <= slice0cost_tag_first_column;
      end if;
      slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0window_partial_0_1_0 + slice0cost_column_0_0;
      slice0window_sum_0_1 <= slice0window_partial_0_1_1 + slice0cost_column_0_1;
      slice0window_sum_0_2 <= slice0window_partial_0_1_2 + slice0cost_column_0_2;
      slice0window_sum_1_0 <= slice0window_partial_1_1_0 + slice0cost_column_1_0;
      slice0window_sum_1_1 <= slice0window_partial_1_1_1 + slice0cost_column_1_1;
      slice0window_sum_1_2 <= slice0window_partial_1_1_2 + slice0cost_column_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_first_column <= slice0window_centre_first_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0other
      slice0other_cost_0_1_all := slice0window_tag_output_column and slice0window_tag_first_column;
      if (slice0other_cost_0_0 - slice0window_sum_0_1) >= 0 then
        slice0other_cost_0_1_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_1_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_2_all := slice0window_tag_output_column and (((slice0other_cost_0_1 - slice0window_sum_0_2) >=
        0) or slice0window_tag_first_column);
      if (slice0other_cost_1_0 - slice0window_sum_1_1) >= 0 then
        slice0other_cost_1_1_choice := slice0window_tag_output_column;
      else
        slice0other_cost_1_1_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_1_1 - slice0window_sum_1_2) >= 0 then
        slice0other_cost_1_2_choice := slice0window_tag_output_column;
      else
        slice0other_cost_1_2_choice := slice0other_cost_0_1_all;
      end if;
      if slice0window_tag_valid then
        slice0other_winner_0_1 <= slice0other_cost_0_1_choice;
        slice0other_winner_1_1 <= slice0other_cost_1_1_choice;
        if slice0window_tag_output_column then
          slice0other_cost_0_0 <= slice0window_sum_0_0;
          slice0other_cost_1_0 <= slice0window_sum_1_0;
        else
          slice0other_cost_0_0 <= 0;
          slice0other_cost_1_0 <= 0;
        end if;
        if slice0other_cost_0_1_choice then
          slice0other_cost_0_1 <= slice0window_sum_0_1;
        else
          slice0other_cost_0_1 <= slice0other_cost_0_0;
        end if;
        if slice0other_cost_0_2_all then
          slice0other_cost_0_2 <= slice0window_sum_0_2;
          slice0other_winner_0_2 <= 2;
        else
          slice0other_cost_0_2 <= slice0other_cost_0_1;
          slice0other_winner_0_2 <= as_number(slice0other_winner_0_1);
        end if;
        if slice0other_cost_1_1_choice then
          slice0other_cost_1_1 <= slice0window_sum_1_1;
        else
          slice0other_cost_1_1 <= slice0other_cost_1_0;
        end if;
        if slice0other_cost_1_2_choice then
          slice0other_cost_1_2 <= slice0window_sum_1_2;
          slice0other_winner_1_2 <= 2;
        else
          slice0other_cost_1_2 <= slice0other_cost_1_1;
          slice0other_winner_1_2 <= as_number(slice0other_winner_1_1);
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0_2;
      slice0other_cost_out_1 <= slice0other_cost_1_2;
      slice0other_winner_out_0 <= slice0other_winner_0_2;
      slice0other_winner_out_1 <= slice0other_winner_1_2;
      -- slice0winner1
      slice0winner1_best_index_0_0_is_not_less := (slice0window_sum_0_0 - slice0window_sum_0_1) >= 0;
      slice0winner1_best_index_1_0_is_not_less := (slice0window_sum_1_0 - slice0window_sum_1_1) >= 0;
      slice0winner1_held_0_0 <= slice0window_sum_0_0;
      slice0winner1_held_0_1 <= slice0window_sum_0_1;
      slice0winner1_held_0_2 <= slice0window_sum_0_2;
      slice0winner1_held_1_0 <= slice0window_sum_1_0;
      slice0winner1_held_1_1 <= slice0window_sum_1_1;
      slice0winner1_held_1_2 <= slice0window_sum_1_2;
      slice0winner1_best_index_0_0 <= slice0winner1_best_index_0_0_is_not_less;
      slice0winner1_best_index_0_1 <= 2;
      slice0winner1_best_index_1_0 <= slice0winner1_best_index_1_0_is_not_less;
      slice0winner1_best_late_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0winner1_best_late_cost_0_1 <= slice0winner1_held_0_2;
      slice0winner1_best_late_cost_1_0 <= slice0winner1_best_cost_1_0;
      slice0winner1_best_late_cost_1_1 <= slice0winner1_held_1_2;
      slice0winner1_best_but_last_0_0 <= slice0winner1_held_0_0;
      slice0winner1_best_but_last_1_0 <= slice0winner1_held_1_0;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_output_column <= slice1window_centre_output_column_0;
      slice0winner1_tag_first_column <= slice1window_centre_first_column_0;
      if (slice0window_sum_0_1 - slice0window_sum_0_0) < 0 then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
      end if;
      if (slice0window_sum_1_1 - slice0window_sum_1_0) < 0 then
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_1;
      else
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_0;
      end if;
      if slice0winner1_best_index_0_0_is_not_less then
        slice0winner1_best_below_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0window_sum_0_1;
      end if;
      if slice0winner1_best_index_1_0_is_not_less then
        slice0winner1_best_below_1_0 <= slice0window_sum_1_0;
        slice0winner1_best_above_1_0 <= 0;
      else
        slice0winner1_best_below_1_0 <= 0;
        slice0winner1_best_above_1_0 <= slice0window_sum_1_1;
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice0window_tag_map_column;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0winner2
      slice0winner2_best_index_0_0_is_less := (slice0winner1_best_cost_0_0 - slice0winner1_held_0_2) < 0;
      slice0winner2_best_index_1_0_is_less := (slice0winner1_best_cost_1_0 - slice0winner1_held_1_2) < 0;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_held_0_2;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if slice0winner1_best_index_1_0 then
        slice0winner2_best_above_1_0_choice := slice0winner1_held_1_2;
      else
        slice0winner2_best_above_1_0_choice := slice0winner1_best_above_1_0;
      end if;
      slice0winner2_best_place_0_0_is_not_less := (slice0winner1_best_cost_0_0 - slice0winner1_held_0_2) >= 0;
      slice0winner2_best_place_1_0_is_not_less := (slice0winner1_best_cost_1_0 - slice0winner1_held_1_2) >= 0;
      if (not slice0winner2_best_at_end_0_0) and (not slice0winner2_best_place_0_0) then
        slice0winner2_best_second_0_0_choice := slice0winner1_best_late_cost_0_1;
      else
        slice0winner2_best_second_0_0_choice := 1023;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_late_cost_0_0;
      else
        slice0winner2_best_second_0_0_choice_2 := 1023;
      end if;
      if slice0winner2_best_at_start_0_0 then
        slice0winner2_best_second_0_0_choice_3 := slice0winner1_best_but_last_0_0;
      else
        slice0winner2_best_second_0_0_choice_3 := slice0winner2_best_second_0_0_choice_2;
      end if;
      if (not slice0winner2_best_at_end_1_0) and (not slice0winner2_best_place_1_0) then
        slice0winner2_best_second_1_0_choice := slice0winner1_best_late_cost_1_1;
      else
        slice0winner2_best_second_1_0_choice := 1023;
      end if;
      if slice0winner2_best_place_1_0 then
        slice0winner2_best_second_1_0_choice_2 := slice0winner1_best_late_cost_1_0;
      else
        slice0winner2_best_second_1_0_choice_2 := 1023;
      end if;
      if slice0winner2_best_at_start_1_0 then
        slice0winner2_best_second_1_0_choice_3 := slice0winner1_best_but_last_1_0;
      else
        slice0winner2_best_second_1_0_choice_3 := slice0winner2_best_second_1_0_choice_2;
      end if;
      slice0winner2_best_place_0_0 <= slice0winner2_best_place_0_0_is_not_less;
      slice0winner2_best_place_1_0 <= slice0winner2_best_place_1_0_is_not_less;
      slice0winner2_best_at_start_0_0 <= slice0winner2_best_place_0_0_is_not_less and transform_read_column_inside_1;
      slice0winner2_best_at_start_1_0 <= slice0winner2_best_place_1_0_is_not_less and transform_read_column_inside_1;
      slice0winner2_best_at_end_0_0 <= slice0winner1_best_index_0_0 and slice0winner2_best_index_0_0_is_less;
      slice0winner2_best_at_end_1_0 <= slice0winner1_best_index_1_0 and slice0winner2_best_index_1_0_is_less;
      slice0winner2_best_late_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0winner2_best_late_cost_1_0 <= slice0winner2_best_cost_1_0;
      slice0winner2_best_but_last_0_0 <= slice0winner1_best_late_cost_0_0;
      slice0winner2_best_but_last_1_0 <= slice0winner1_best_late_cost_1_0;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_output_column <= slice1window_tag_output_column;
      slice0winner2_tag_first_column <= slice1window_tag_first_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if (slice0winner1_held_0_2 - slice0winner1_best_cost_0_0) < 0 then
        slice0winner2_best_cost_0_0 <= slice0winner1_held_0_2;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
      end if;
      if (slice0winner1_held_1_2 - slice0winner1_best_cost_1_0) < 0 then
        slice0winner2_best_cost_1_0 <= slice0winner1_held_1_2;
      else
        slice0winner2_best_cost_1_0 <= slice0winner1_best_cost_1_0;
      end if;
      if slice0winner2_best_index_0_0_is_less then
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0_0 <= slice0winner1_best_below_0_0;
        slice0winner2_best_above_0_0 <= slice0winner2_best_above_0_0_choice;
      else
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0_0 <= slice0winner1_held_0_1;
        slice0winner2_best_above_0_0 <= 0;
      end if;
      if slice0winner2_best_index_1_0_is_less then
        slice0winner2_best_index_1_0 <= as_number(slice0winner1_best_index_1_0);
        slice0winner2_best_below_1_0 <= slice0winner1_best_below_1_0;
        slice0winner2_best_above_1_0 <= slice0winner2_best_above_1_0_choice;
      else
        slice0winner2_best_index_1_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_1_0 <= slice0winner1_held_1_1;
        slice0winner2_best_above_1_0 <= 0;
      end if;
      if (slice0winner2_best_second_0_0_choice - slice0winner2_best_second_0_0_choice_3) < 0 then
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice;
      else
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_3;
      end if;
      if (slice0winner2_best_second_1_0_choice - slice0winner2_best_second_1_0_choice_3) < 0 then
        slice0winner2_best_second_1_0 <= slice0winner2_best_second_1_0_choice;
      else
        slice0winner2_best_second_1_0 <= slice0winner2_best_second_1_0_choice_3;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner2_best_index_0_0;
      slice0_best_index_1_0 <= slice0winner2_best_index_1_0;
      slice0_best_below_0_0 <= slice0winner2_best_below_0_0;
      slice0_best_below_1_0 <= slice0winner2_best_below_1_0;
      slice0_best_above_0_0 <= slice0winner2_best_above_0_0;
      slice0_best_above_1_0 <= slice0winner2_best_above_1_0;
      slice0_best_last_0_0 <= slice0winner1_best_late_cost_0_1;
      slice0_best_last_1_0 <= slice0winner1_best_late_cost_1_1;
      slice0_best_late_cost_0_0 <= slice0winner2_best_late_cost_0_0;
      slice0_best_late_cost_1_0 <= slice0winner2_best_late_cost_1_0;
      slice0_best_second_0_0 <= slice0winner2_best_second_0_0;
      slice0_best_second_1_0 <= slice0winner2_best_second_1_0;
      slice0_best_but_last_0_0 <= slice0winner2_best_but_last_0_0;
      slice0_best_but_last_1_0 <= slice0winner2_best_but_last_1_0;
      slice0_best_tag_valid <= slice0winner2_tag_valid;
      slice0_best_tag_map_column <= slice0winner2_tag_map_column;
      slice0_best_tag_output_column <= slice0winner2_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner2_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice0shift_search_out_0;
        slice1shift_search_0_1 <= slice1shift_search_0_0;
        slice1shift_search_0_2 <= slice1shift_search_0_1;
        slice1shift_search_1_0 <= slice0shift_search_out_1;
        slice1shift_search_1_1 <= slice1shift_search_1_0;
        slice1shift_search_1_2 <= slice1shift_search_1_1;
        slice1shift_search_2_0 <= slice0shift_search_out_2;
        slice1shift_search_2_1 <= slice1shift_search_2_0;
        slice1shift_search_2_2 <= slice1shift_search_2_1;
        slice1shift_search_3_0 <= slice0shift_search_out_3;
        slice1shift_search_3_1 <= slice1shift_search_3_0;
        slice1shift_search_3_2 <= slice1shift_search_3_1;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_search_out_0 <= slice1shift_search_0_2;
      slice1shift_search_out_1 <= slice1shift_search_1_2;
      slice1shift_search_out_2 <= slice1shift_search_2_2;
      slice1shift_search_out_3 <= slice1shift_search_3_2;
      -- slice1cost
      slice1cost_single_0_0_is_less := slice1cost_difference_0_0 < 0;
      if slice1cost_single_0_0_is_less then
        slice1cost_single_0_0_choice := (65535 - slice1cost_difference_0_0) mod 256;
      else
        slice1cost_single_0_0_choice := positive_part(slice1cost_difference_0_0);
      end if;
      slice1cost_single_0_1_is_less := slice1cost_difference_0_1 < 0;
      if slice1cost_single_0_1_is_less then
        slice1cost_single_0_1_choice := (65535 - slice1cost_difference_0_1) mod 256;
      else
        slice1cost_single_0_1_choice := positive_part(slice1cost_difference_0_1);
      end if;
      slice1cost_single_0_2_is_less := slice1cost_difference_0_2 < 0;
      if slice1cost_single_0_2_is_less then
        slice1cost_single_0_2_choice := (65535 - slice1cost_difference_0_2) mod 256;
      else
        slice1cost_single_0_2_choice := positive_part(slice1cost_difference_0_2);
      end if;
      slice1cost_single_3_0_is_less := slice1cost_difference_3_0 < 0;
      if slice1cost_single_3_0_is_less then
        slice1cost_single_3_0_choice := (65535 - slice1cost_difference_3_0) mod 256;
      else
        slice1cost_single_3_0_choice := positive_part(slice1cost_difference_3_0);
      end if;
      slice1cost_single_3_1_is_less := slice1cost_difference_3_1 < 0;
      if slice1cost_single_3_1_is_less then
        slice1cost_single_3_1_choice := (65535 - slice1cost_difference_3_1) mod 256;
      else
        slice1cost_single_3_1_choice := positive_part(slice1cost_difference_3_1);
      end if;
      slice1cost_single_3_2_is_less := slice1cost_difference_3_2 < 0;
      if slice1cost_single_3_2_is_less then
        slice1cost_single_3_2_choice := (65535 - slice1cost_difference_3_2) mod 256;
      else
        slice1cost_single_3_2_choice := positive_part(slice1cost_difference_3_2);
      end if;
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_difference_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_difference_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_difference_3_0 <= slice1shift_search_3_0 - slice1shift_reference_3;
      slice1cost_difference_3_1 <= slice1shift_search_3_1 - slice1shift_reference_3;
      slice1cost_difference_3_2 <= slice1shift_search_3_2 - slice1shift_reference_3;
      slice1cost_pair_0_0 <= folded(slice1cost_difference_2_0) + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= folded(slice1cost_difference_2_1) + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= folded(slice1cost_difference_2_2) + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_negative_0_0 <= slice1cost_difference_2_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_2_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_2_2 < 0;
      slice1cost_single_0_0 <= (slice1cost_single_0_0_choice + as_number(slice1cost_single_0_0_is_less)) mod 256;
      slice1cost_single_0_1 <= (slice1cost_single_0_1_choice + as_number(slice1cost_single_0_1_is_less)) mod 256;
      slice1cost_single_0_2 <= (slice1cost_single_0_2_choice + as_number(slice1cost_single_0_2_is_less)) mod 256;
      slice1cost_single_3_0 <= (slice1cost_single_3_0_choice + as_number(slice1cost_single_3_0_is_less)) mod 256;
      slice1cost_single_3_1 <= (slice1cost_single_3_1_choice + as_number(slice1cost_single_3_1_is_less)) mod 256;
      slice1cost_single_3_2 <= (slice1cost_single_3_2_choice + as_number(slice1cost_single_3_2_is_less)) mod 256;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      slice1cost_tag_output_column <= slice0cost_tag_output_column;
      slice1cost_tag_first_column <= slice0cost_tag_first_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
      else
        slice1cost_column_0_0 <= (as_number(slice1cost_negative_0_0) + slice1cost_pair_0_0 + slice1cost_single_0_0) mod
          256;
        slice1cost_column_0_1 <= (as_number(slice1cost_negative_0_1) + slice1cost_pair_0_1 + slice1cost_single_0_1) mod
          256;
        slice1cost_column_0_2 <= (as_number(slice1cost_negative_0_2) + slice1cost_pair_0_2 + slice1cost_single_0_2) mod
          256;
        slice1cost_column_1_0 <= (as_number(slice1cost_negative_0_0) + slice1cost_pair_0_0 + slice1cost_single_3_0) mod
          256;
        slice1cost_column_1_1 <= (as_number(slice1cost_negative_0_1) + slice1cost_pair_0_1 + slice1cost_single_3_1) mod
          256;
        slice1cost_column_1_2 <= (as_number(slice1cost_negative_0_2) + slice1cost_pair_0_2 + slice1cost_single_3_2) mod
          256;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_1_0 <= slice1window_partial_0_0_0 + slice1cost_column_0_0;
        slice1window_partial_0_1_1 <= slice1window_partial_0_0_1 + slice1cost_column_0_1;
        slice1window_partial_0_1_2 <= slice1window_partial_0_0_2 + slice1cost_column_0_2;
        slice1window_partial_1_0_0 <= slice1cost_column_1_0;
        slice1window_partial_1_0_1 <= slice1cost_column_1_1;
        slice1window_partial_1_0_2 <= slice1cost_column_1_2;
        slice1window_partial_1_1_0 <= slice1window_partial_1_0_0 + slice1cost_column_1_0;
        slice1window_partial_1_1_1 <= slice1window_partial_1_0_1 + slice1cost_column_1_1;
        slice1window_partial_1_1_2 <= slice1window_partial_1_0_2 + slice1cost_column_1_2;
        slice1window_centre_output_column_0 <= slice1cost_tag_output_column;
        slice1window_centre_first_column_0 <= slice1cost_tag_first_column;
      end if;
      slice1window_sum_0_0 <= slice1window_partial_0_1_0 + slice1cost_column_0_0;
      slice1window_sum_0_1 <= slice1window_partial_0_1_1 + slice1cost_column_0_1;
      slice1window_sum_0_2 <= slice1window_partial_0_1_2 + slice1cost_column_0_2;
      slice1window_sum_1_0 <= slice1window_partial_1_1_0 + slice1cost_column_1_0;
      slice1window_sum_1_1 <= slice1window_partial_1_1_1 + slice1cost_column_1_1;
      slice1window_sum_1_2 <= slice1window_partial_1_1_2 + slice1cost_column_1_2;
      if slice0winner1_tag_valid then
        slice1window_tag_output_column <= slice2cost_tag_output_column;
        slice1window_tag_first_column <= slice2cost_tag_first_column;
      end if;
      -- slice1other
      slice1other_cost_0_0_any := (not slice0winner1_tag_output_column) or (not slice0winner1_tag_first_column);
      if (slice0other_cost_out_0 - slice1window_sum_0_0) >= 0 then
        slice1other_cost_0_0_choice := not slice0winner1_tag_output_column;
      else
        slice1other_cost_0_0_choice := slice1other_cost_0_0_any;
      end if;
      if (slice1other_cost_0_0 - slice1window_sum_0_1) >= 0 then
        slice1other_cost_0_1_choice := not slice0winner1_tag_output_column;
      else
        slice1other_cost_0_1_choice := slice1other_cost_0_0_any;
      end if;
      slice1other_cost_0_2_any := (not slice0winner1_tag_output_column) or ((not slice0winner1_tag_first_column) and
        ((slice1other_cost_0_1 - slice1window_sum_0_2) < 0));
      if (slice0other_cost_out_1 - slice1window_sum_1_0) >= 0 then
        slice1other_cost_1_0_choice := not slice0winner1_tag_output_column;
      else
        slice1other_cost_1_0_choice := slice1other_cost_0_0_any;
      end if;
      if (slice1other_cost_1_0 - slice1window_sum_1_1) >= 0 then
        slice1other_cost_1_1_choice := not slice0winner1_tag_output_column;
      else
        slice1other_cost_1_1_choice := slice1other_cost_0_0_any;
      end if;
      if (slice1other_cost_1_1 - slice1window_sum_1_2) >= 0 then
        slice1other_cost_1_2_choice := not slice0winner1_tag_output_column;
      else
        slice1other_cost_1_2_choice := slice1other_cost_0_0_any;
      end if;
      if slice0winner1_tag_valid then
        if slice1other_cost_0_0_choice then
          slice1other_cost_0_0 <= slice0other_cost_out_0;
          slice1other_winner_0_0 <= slice0other_winner_out_0;
        else
          slice1other_cost_0_0 <= slice1window_sum_0_0;
          slice1other_winner_0_0 <= 3;
        end if;
        if slice1other_cost_0_1_choice then
          slice1other_cost_0_1 <= slice1other_cost_0_0;
          slice1other_winner_0_1 <= slice1other_winner_0_0;
        else
          slice1other_cost_0_1 <= slice1window_sum_0_1;
          slice1other_winner_0_1 <= 4;
        end if;
        if slice1other_cost_0_2_any then
          slice1other_cost_0_2 <= slice1other_cost_0_1;
          slice1other_winner_0_2 <= slice1other_winner_0_1;
        else
          slice1other_cost_0_2 <= slice1window_sum_0_2;
          slice1other_winner_0_2 <= 5;
        end if;
        if slice1other_cost_1_0_choice then
          slice1other_cost_1_0 <= slice0other_cost_out_1;
          slice1other_winner_1_0 <= slice0other_winner_out_1;
        else
          slice1other_cost_1_0 <= slice1window_sum_1_0;
          slice1other_winner_1_0 <= 3;
        end if;
        if slice1other_cost_1_1_choice then
          slice1other_cost_1_1 <= slice1other_cost_1_0;
          slice1other_winner_1_1 <= slice1other_winner_1_0;
        else
          slice1other_cost_1_1 <= slice1window_sum_1_1;
          slice1other_winner_1_1 <= 4;
        end if;
        if slice1other_cost_1_2_choice then
          slice1other_cost_1_2 <= slice1other_cost_1_1;
          slice1other_winner_1_2 <= slice1other_winner_1_1;
        else
          slice1other_cost_1_2 <= slice1window_sum_1_2;
          slice1other_winner_1_2 <= 5;
        end if;
      end if;
      slice1other_cost_out_0 <= slice1other_cost_0_2;
      slice1other_cost_out_1 <= slice1other_cost_1_2;
      slice1other_winner_out_0 <= slice1other_winner_0_2;
      slice1other_winner_out_1 <= slice1other_winner_1_2;
      -- slice1winner1
      slice1winner1_best_index_0_0_is_not_less := (slice1window_sum_0_0 - slice1window_sum_0_1) >= 0;
      slice1winner1_best_index_1_0_is_not_less := (slice1window_sum_1_0 - slice1window_sum_1_1) >= 0;
      slice1winner1_held_0_0 <= slice1window_sum_0_0;
      slice1winner1_held_0_1 <= slice1window_sum_0_1;
      slice1winner1_held_0_2 <= slice1window_sum_0_2;
      slice1winner1_held_1_0 <= slice1window_sum_1_0;
      slice1winner1_held_1_1 <= slice1window_sum_1_1;
      slice1winner1_held_1_2 <= slice1window_sum_1_2;
      slice1winner1_best_index_0_0 <= slice1winner1_best_index_0_0_is_not_less;
      slice1winner1_best_index_1_0 <= slice1winner1_best_index_1_0_is_not_less;
      slice1winner1_best_late_cost_0_0 <= slice1winner1_best_cost_0_0;
      slice1winner1_best_late_cost_0_1 <= slice1winner1_held_0_2;
      slice1winner1_best_late_cost_1_0 <= slice1winner1_best_cost_1_0;
      slice1winner1_best_late_cost_1_1 <= slice1winner1_held_1_2;
      slice1winner1_best_but_first_0_0 <= slice1winner1_held_0_1;
      slice1winner1_best_but_first_1_0 <= slice1winner1_held_1_1;
      slice1winner1_best_but_last_0_0 <= slice1winner1_held_0_0;
      slice1winner1_best_but_last_1_0 <= slice1winner1_held_1_0;
      if (slice1window_sum_0_1 - slice1window_sum_0_0) < 0 then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      if (slice1window_sum_1_1 - slice1window_sum_1_0) < 0 then
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_1;
      else
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_0;
      end if;
      if slice1winner1_best_index_0_0_is_not_less then
        slice1winner1_best_below_0_0 <= slice1window_sum_0_0;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1window_sum_0_1;
      end if;
      if slice1winner1_best_index_1_0_is_not_less then
        slice1winner1_best_below_1_0 <= slice1window_sum_1_0;
        slice1winner1_best_above_1_0 <= 0;
      else
        slice1winner1_best_below_1_0 <= 0;
        slice1winner1_best_above_1_0 <= slice1window_sum_1_1;
      end if;
      -- slice1winner2
      slice1winner2_best_index_0_0_is_less := (slice1winner1_best_cost_0_0 - slice1winner1_held_0_2) < 0;
      slice1winner2_best_index_1_0_is_less := (slice1winner1_best_cost_1_0 - slice1winner1_held_1_2) < 0;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_held_0_2;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      if slice1winner1_best_index_1_0 then
        slice1winner2_best_above_1_0_choice := slice1winner1_held_1_2;
      else
        slice1winner2_best_above_1_0_choice := slice1winner1_best_above_1_0;
      end if;
      slice1winner2_best_place_0_0_is_not_less := (slice1winner1_best_cost_0_0 - slice1winner1_held_0_2) >= 0;
      slice1winner2_best_place_1_0_is_not_less := (slice1winner1_best_cost_1_0 - slice1winner1_held_1_2) >= 0;
      if (not slice1winner2_best_at_end_0_0) and (not slice1winner2_best_place_0_0) then
        slice1winner2_best_second_0_0_choice := slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_second_0_0_choice := 1023;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_late_cost_0_0;
      else
        slice1winner2_best_second_0_0_choice_2 := 1023;
      end if;
      if slice1winner2_best_at_start_0_0 then
        slice1winner2_best_second_0_0_choice_3 := slice1winner1_best_but_last_0_0;
      else
        slice1winner2_best_second_0_0_choice_3 := slice1winner2_best_second_0_0_choice_2;
      end if;
      if (not slice1winner2_best_at_end_1_0) and (not slice1winner2_best_place_1_0) then
        slice1winner2_best_second_1_0_choice := slice1winner1_best_late_cost_1_1;
      else
        slice1winner2_best_second_1_0_choice := 1023;
      end if;
      if slice1winner2_best_place_1_0 then
        slice1winner2_best_second_1_0_choice_2 := slice1winner1_best_late_cost_1_0;
      else
        slice1winner2_best_second_1_0_choice_2 := 1023;
      end if;
      if slice1winner2_best_at_start_1_0 then
        slice1winner2_best_second_1_0_choice_3 := slice1winner1_best_but_last_1_0;
      else
        slice1winner2_best_second_1_0_choice_3 := slice1winner2_best_second_1_0_choice_2;
      end if;
      slice1winner2_best_first_0_0 <= slice1winner1_held_0_0;
      slice1winner2_best_first_1_0 <= slice1winner1_held_1_0;
      slice1winner2_best_place_0_0 <= slice1winner2_best_place_0_0_is_not_less;
      slice1winner2_best_place_1_0 <= slice1winner2_best_place_1_0_is_not_less;
      slice1winner2_best_at_start_0_0 <= transform_read_column_inside_1 and slice1winner2_best_place_0_0_is_not_less;
      slice1winner2_best_at_start_1_0 <= slice1winner2_best_place_1_0_is_not_less and transform_read_column_inside_1;
      slice1winner2_best_at_end_0_0 <= slice1winner1_best_index_0_0 and slice1winner2_best_index_0_0_is_less;
      slice1winner2_best_at_end_1_0 <= slice1winner1_best_index_1_0 and slice1winner2_best_index_1_0_is_less;
      slice1winner2_best_late_cost_0_0 <= slice1winner2_best_cost_0_0;
      slice1winner2_best_late_cost_1_0 <= slice1winner2_best_cost_1_0;
      slice1winner2_best_but_last_0_0 <= slice1winner1_best_late_cost_0_0;
      slice1winner2_best_but_last_1_0 <= slice1winner1_best_late_cost_1_0;
      if (slice1winner1_held_0_2 - slice1winner1_best_cost_0_0) < 0 then
        slice1winner2_best_cost_0_0 <= slice1winner1_held_0_2;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
      end if;
      if (slice1winner1_held_1_2 - slice1winner1_best_cost_1_0) < 0 then
        slice1winner2_best_cost_1_0 <= slice1winner1_held_1_2;
      else
        slice1winner2_best_cost_1_0 <= slice1winner1_best_cost_1_0;
      end if;
      if slice1winner2_best_index_0_0_is_less then
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0_0 <= slice1winner1_best_below_0_0;
        slice1winner2_best_above_0_0 <= slice1winner2_best_above_0_0_choice;
      else
        slice1winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice1winner2_best_below_0_0 <= slice1winner1_held_0_1;
        slice1winner2_best_above_0_0 <= 0;
      end if;
      if slice1winner2_best_index_1_0_is_less then
        slice1winner2_best_index_1_0 <= as_number(slice1winner1_best_index_1_0);
        slice1winner2_best_below_1_0 <= slice1winner1_best_below_1_0;
        slice1winner2_best_above_1_0 <= slice1winner2_best_above_1_0_choice;
      else
        slice1winner2_best_index_1_0 <= slice0winner1_best_index_0_1;
        slice1winner2_best_below_1_0 <= slice1winner1_held_1_1;
        slice1winner2_best_above_1_0 <= 0;
      end if;
      if (slice1winner2_best_second_0_0_choice - slice1winner2_best_second_0_0_choice_3) < 0 then
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice;
      else
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_3;
      end if;
      if (slice1winner2_best_second_1_0_choice - slice1winner2_best_second_1_0_choice_3) < 0 then
        slice1winner2_best_second_1_0 <= slice1winner2_best_second_1_0_choice;
      else
        slice1winner2_best_second_1_0 <= slice1winner2_best_second_1_0_choice_3;
      end if;
      if (slice1winner1_best_late_cost_0_1 - slice1winner1_best_but_first_0_0) < 0 then
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_but_first_0_0;
      end if;
      if (slice1winner1_best_late_cost_1_1 - slice1winner1_best_but_first_1_0) < 0 then
        slice1winner2_best_but_first_1_0 <= slice1winner1_best_late_cost_1_1;
      else
        slice1winner2_best_but_first_1_0 <= slice1winner1_best_but_first_1_0;
      end if;
      -- slice1
      slice1_best_index_0_0_is_less := (slice0winner2_best_late_cost_0_0 - slice1winner2_best_cost_0_0) < 0;
      slice1_best_index_1_0_is_less := (slice0winner2_best_late_cost_1_0 - slice1winner2_best_cost_1_0) < 0;
      slice1_best_below_0_0_is_equal := slice1winner2_best_index_0_0 = 0;
      if slice1_best_below_0_0_is_equal then
        slice1_best_below_0_0_choice := slice0_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice1winner2_best_below_0_0;
      end if;
      slice1_best_below_1_0_is_equal := slice1winner2_best_index_1_0 = 0;
      if slice1_best_below_1_0_is_equal then
        slice1_best_below_1_0_choice := slice0_best_last_1_0;
      else
        slice1_best_below_1_0_choice := slice1winner2_best_below_1_0;
      end if;
      slice1_best_above_0_0_is_equal := slice0_best_index_0_0 = 2;
      if slice1_best_above_0_0_is_equal then
        slice1_best_above_0_0_choice := slice1winner2_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice0_best_above_0_0;
      end if;
      slice1_best_above_1_0_is_equal := slice0_best_index_1_0 = 2;
      if slice1_best_above_1_0_is_equal then
        slice1_best_above_1_0_choice := slice1winner2_best_first_1_0;
      else
        slice1_best_above_1_0_choice := slice0_best_above_1_0;
      end if;
      slice1_best_place_0_0_is_not_less := (slice0winner2_best_late_cost_0_0 - slice1winner2_best_cost_0_0) >= 0;
      slice1_best_place_1_0_is_not_less := (slice0winner2_best_late_cost_1_0 - slice1winner2_best_cost_1_0) >= 0;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice := slice1winner2_best_second_0_0;
      else
        slice1_best_second_0_0_choice := slice1winner2_best_late_cost_0_0;
      end if;
      if slice1_best_at_end_0_0 then
        slice1_best_second_0_0_choice_2 := slice1winner2_best_but_first_0_0;
      else
        slice1_best_second_0_0_choice_2 := slice1_best_second_0_0_choice;
      end if;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice_3 := slice0_best_late_cost_0_0;
      else
        slice1_best_second_0_0_choice_3 := slice0_best_second_0_0;
      end if;
      if slice1_best_at_start_0_0 then
        slice1_best_second_0_0_choice_4 := slice0_best_but_last_0_0;
      else
        slice1_best_second_0_0_choice_4 := slice1_best_second_0_0_choice_3;
      end if;
      if slice1_best_place_1_0 then
        slice1_best_second_1_0_choice := slice1winner2_best_second_1_0;
      else
        slice1_best_second_1_0_choice := slice1winner2_best_late_cost_1_0;
      end if;
      if slice1_best_at_end_1_0 then
        slice1_best_second_1_0_choice_2 := slice1winner2_best_but_first_1_0;
      else
        slice1_best_second_1_0_choice_2 := slice1_best_second_1_0_choice;
      end if;
      if slice1_best_place_1_0 then
        slice1_best_second_1_0_choice_3 := slice0_best_late_cost_1_0;
      else
        slice1_best_second_1_0_choice_3 := slice0_best_second_1_0;
      end if;
      if slice1_best_at_start_1_0 then
        slice1_best_second_1_0_choice_4 := slice0_best_but_last_1_0;
      else
        slice1_best_second_1_0_choice_4 := slice1_best_second_1_0_choice_3;
      end if;
      slice1_best_last_0_0 <= slice1winner1_best_late_cost_0_1;
      slice1_best_last_1_0 <= slice1winner1_best_late_cost_1_1;
      slice1_best_place_0_0 <= slice1_best_place_0_0_is_not_less;
      slice1_best_place_1_0 <= slice1_best_place_1_0_is_not_less;
      slice1_best_at_start_0_0 <= slice1_best_place_0_0_is_not_less and slice1_best_below_0_0_is_equal;
      slice1_best_at_start_1_0 <= slice1_best_place_1_0_is_not_less and slice1_best_below_1_0_is_equal;
      slice1_best_at_end_0_0 <= slice1_best_index_0_0_is_less and slice1_best_above_0_0_is_equal;
      slice1_best_at_end_1_0 <= slice1_best_index_1_0_is_less and slice1_best_above_1_0_is_equal;
      slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
      slice1_best_late_cost_1_0 <= slice1_best_cost_1_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice1winner2_best_cost_0_0 - slice0winner2_best_late_cost_0_0) < 0 then
        slice1_best_cost_0_0 <= slice1winner2_best_cost_0_0;
      else
        slice1_best_cost_0_0 <= slice0winner2_best_late_cost_0_0;
      end if;
      if (slice1winner2_best_cost_1_0 - slice0winner2_best_late_cost_1_0) < 0 then
        slice1_best_cost_1_0 <= slice1winner2_best_cost_1_0;
      else
        slice1_best_cost_1_0 <= slice0winner2_best_late_cost_1_0;
      end if;
      if slice1_best_index_0_0_is_less then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      else
        slice1_best_index_0_0 <= slice1winner2_best_index_0_0 + 3;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner2_best_above_0_0;
      end if;
      if slice1_best_index_1_0_is_less then
        slice1_best_index_1_0 <= slice0_best_index_1_0;
        slice1_best_below_1_0 <= slice0_best_below_1_0;
        slice1_best_above_1_0 <= slice1_best_above_1_0_choice;
      else
        slice1_best_index_1_0 <= slice1winner2_best_index_1_0 + 3;
        slice1_best_below_1_0 <= slice1_best_below_1_0_choice;
        slice1_best_above_1_0 <= slice1winner2_best_above_1_0;
      end if;
      if (slice1_best_second_0_0_choice_2 - slice1_best_second_0_0_choice_4) < 0 then
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_2;
      else
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_4;
      end if;
      if (slice1_best_second_1_0_choice_2 - slice1_best_second_1_0_choice_4) < 0 then
        slice1_best_second_1_0 <= slice1_best_second_1_0_choice_2;
      else
        slice1_best_second_1_0 <= slice1_best_second_1_0_choice_4;
      end if;
      if (slice1winner2_best_but_last_0_0 - slice0_best_late_cost_0_0) < 0 then
        slice1_best_but_last_0_0 <= slice1winner2_best_but_last_0_0;
      else
        slice1_best_but_last_0_0 <= slice0_best_late_cost_0_0;
      end if;
      if (slice1winner2_best_but_last_1_0 - slice0_best_late_cost_1_0) < 0 then
        slice1_best_but_last_1_0 <= slice1winner2_best_but_last_1_0;
      else
        slice1_best_but_last_1_0 <= slice0_best_late_cost_1_0;
      end if;
      -- slice2shift
      if slice0cost_difference_tag_valid then
        slice2shift_search_0_0 <= slice1shift_search_out_0;
        slice2shift_search_0_1 <= slice2shift_search_0_0;
        slice2shift_search_1_0 <= slice1shift_search_out_1;
        slice2shift_search_1_1 <= slice2shift_search_1_0;
        slice2shift_search_2_0 <= slice1shift_search_out_2;
        slice2shift_search_2_1 <= slice2shift_search_2_0;
        slice2shift_search_3_0 <= slice1shift_search_out_3;
        slice2shift_search_3_1 <= slice2shift_search_3_0;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      slice2shift_reference_3 <= slice1shift_reference_3;
      -- slice2cost
      slice2cost_single_0_0_is_less := slice2cost_difference_0_0 < 0;
      if slice2cost_single_0_0_is_less then
        slice2cost_single_0_0_choice := (65535 - slice2cost_difference_0_0) mod 256;
      else
        slice2cost_single_0_0_choice := positive_part(slice2cost_difference_0_0);
      end if;
      slice2cost_single_0_1_is_less := slice2cost_difference_0_1 < 0;
      if slice2cost_single_0_1_is_less then
        slice2cost_single_0_1_choice := (65535 - slice2cost_difference_0_1) mod 256;
      else
        slice2cost_single_0_1_choice := positive_part(slice2cost_difference_0_1);
      end if;
      slice2cost_single_3_0_is_less := slice2cost_difference_3_0 < 0;
      if slice2cost_single_3_0_is_less then
        slice2cost_single_3_0_choice := (65535 - slice2cost_difference_3_0) mod 256;
      else
        slice2cost_single_3_0_choice := positive_part(slice2cost_difference_3_0);
      end if;
      slice2cost_single_3_1_is_less := slice2cost_difference_3_1 < 0;
      if slice2cost_single_3_1_is_less then
        slice2cost_single_3_1_choice := (65535 - slice2cost_difference_3_1) mod 256;
      else
        slice2cost_single_3_1_choice := positive_part(slice2cost_difference_3_1);
      end if;
      slice2cost_difference_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_difference_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_difference_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_difference_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_difference_2_0 <= slice2shift_search_2_0 - slice2shift_reference_2;
      slice2cost_difference_2_1 <= slice2shift_search_2_1 - slice2shift_reference_2;
      slice2cost_difference_3_0 <= slice2shift_search_3_0 - slice2shift_reference_3;
      slice2cost_difference_3_1 <= slice2shift_search_3_1 - slice2shift_reference_3;
      slice2cost_pair_0_0 <= as_number((slice2cost_difference_1_0 < 0)) + folded(slice2cost_difference_1_0) +
        folded(slice2cost_difference_2_0);
      slice2cost_pair_0_1 <= as_number((slice2cost_difference_1_1 < 0)) + folded(slice2cost_difference_1_1) +
        folded(slice2cost_difference_2_1);
      slice2cost_negative_0_0 <= slice2cost_difference_2_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_2_1 < 0;
      slice2cost_single_0_0 <= (slice2cost_single_0_0_choice + as_number(slice2cost_single_0_0_is_less)) mod 256;
      slice2cost_single_0_1 <= (slice2cost_single_0_1_choice + as_number(slice2cost_single_0_1_is_less)) mod 256;
      slice2cost_single_3_0 <= (slice2cost_single_3_0_choice + as_number(slice2cost_single_3_0_is_less)) mod 256;
      slice2cost_single_3_1 <= (slice2cost_single_3_1_choice + as_number(slice2cost_single_3_1_is_less)) mod 256;
      slice2cost_tag_output_column <= slice1cost_tag_output_column;
      slice2cost_tag_first_column <= slice1cost_tag_first_column;
      if slice1cost_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
      else
        slice2cost_column_0_0 <= (as_number(slice2cost_negative_0_0) + slice2cost_pair_0_0 + slice2cost_single_0_0) mod
          256;
        slice2cost_column_0_1 <= (as_number(slice2cost_negative_0_1) + slice2cost_pair_0_1 + slice2cost_single_0_1) mod
          256;
        slice2cost_column_1_0 <= (as_number(slice2cost_negative_0_0) + slice2cost_pair_0_0 + slice2cost_single_3_0) mod
          256;
        slice2cost_column_1_1 <= (as_number(slice2cost_negative_0_1) + slice2cost_pair_0_1 + slice2cost_single_3_1) mod
          256;
      end if;
      -- slice2window
      if slice0winner1_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2window_partial_0_0_0 + slice2cost_column_0_0;
        slice2window_partial_0_1_1 <= slice2window_partial_0_0_1 + slice2cost_column_0_1;
        slice2window_partial_1_0_0 <= slice2cost_column_1_0;
        slice2window_partial_1_0_1 <= slice2cost_column_1_1;
        slice2window_partial_1_1_0 <= slice2window_partial_1_0_0 + slice2cost_column_1_0;
        slice2window_partial_1_1_1 <= slice2window_partial_1_0_1 + slice2cost_column_1_1;
      end if;
      slice2window_sum_0_0 <= slice2window_partial_0_1_0 + slice2cost_column_0_0;
      slice2window_sum_0_1 <= slice2window_partial_0_1_1 + slice2cost_column_0_1;
      slice2window_sum_1_0 <= slice2window_partial_1_1_0 + slice2cost_column_1_0;
      slice2window_sum_1_1 <= slice2window_partial_1_1_1 + slice2cost_column_1_1;
      -- slice2other
      slice2other_cost_0_0_any := (not slice0winner2_tag_output_column) or (not slice0winner2_tag_first_column);
      if (slice1other_cost_out_0 - slice2window_sum_0_0) >= 0 then
        slice2other_cost_0_0_choice := not slice0winner2_tag_output_column;
      else
        slice2other_cost_0_0_choice := slice2other_cost_0_0_any;
      end if;
      if (slice1other_cost_out_1 - slice2window_sum_1_0) >= 0 then
        slice2other_cost_1_0_choice := not slice0winner2_tag_output_column;
      else
        slice2other_cost_1_0_choice := slice2other_cost_0_0_any;
      end if;
      if (slice2other_cost_1_0 - slice2window_sum_1_1) >= 0 then
        slice2other_winner_1_1_choice := not slice0winner2_tag_output_column;
      else
        slice2other_winner_1_1_choice := slice2other_cost_0_0_any;
      end if;
      if slice0winner2_tag_valid then
        if slice2other_cost_0_0_choice then
          slice2other_cost_0_0 <= slice1other_cost_out_0;
          slice2other_winner_0_0 <= slice1other_winner_out_0;
        else
          slice2other_cost_0_0 <= slice2window_sum_0_0;
          slice2other_winner_0_0 <= 6;
        end if;
        if slice2other_cost_1_0_choice then
          slice2other_cost_1_0 <= slice1other_cost_out_1;
          slice2other_winner_1_0 <= slice1other_winner_out_1;
        else
          slice2other_cost_1_0 <= slice2window_sum_1_0;
          slice2other_winner_1_0 <= 6;
        end if;
        if (not slice0winner2_tag_output_column) or ((not slice0winner2_tag_first_column) and ((slice2other_cost_0_0 -
          slice2window_sum_0_1) < 0)) then
          slice2other_winner_0_1 <= slice2other_winner_0_0;
        else
          slice2other_winner_0_1 <= 7;
        end if;
        if slice2other_winner_1_1_choice then
          slice2other_winner_1_1 <= slice2other_winner_1_0;
        else
          slice2other_winner_1_1 <= 7;
        end if;
      end if;
      slice2other_winner_out_0 <= slice2other_winner_0_1;
      slice2other_winner_out_1 <= slice2other_winner_1_1;
      -- slice2winner1
      slice2winner1_best_below_0_0_is_less := (slice2window_sum_0_0 - slice2window_sum_0_1) < 0;
      slice2winner1_best_below_1_0_is_less := (slice2window_sum_1_0 - slice2window_sum_1_1) < 0;
      slice2winner1_held_0_0 <= slice2window_sum_0_0;
      slice2winner1_held_0_1 <= slice2window_sum_0_1;
      slice2winner1_held_1_0 <= slice2window_sum_1_0;
      slice2winner1_held_1_1 <= slice2window_sum_1_1;
      slice2winner1_best_index_0_0 <= (slice2window_sum_0_0 - slice2window_sum_0_1) >= 0;
      slice2winner1_best_index_1_0 <= (slice2window_sum_1_0 - slice2window_sum_1_1) >= 0;
      slice2winner1_best_late_cost_0_0 <= slice2winner1_best_cost_0_0;
      slice2winner1_best_late_cost_1_0 <= slice2winner1_best_cost_1_0;
      slice2winner1_best_but_first_0_0 <= slice2winner1_held_0_1;
      slice2winner1_best_but_first_1_0 <= slice2winner1_held_1_1;
      if (slice2window_sum_0_1 - slice2window_sum_0_0) < 0 then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      if (slice2window_sum_1_1 - slice2window_sum_1_0) < 0 then
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_1;
      else
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_0;
      end if;
      if slice2winner1_best_below_0_0_is_less then
        slice2winner1_best_below_0_0 <= 0;
        slice2winner1_best_above_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_below_0_0 <= slice2window_sum_0_0;
        slice2winner1_best_above_0_0 <= 0;
      end if;
      if slice2winner1_best_below_1_0_is_less then
        slice2winner1_best_below_1_0 <= 0;
        slice2winner1_best_above_1_0 <= slice2window_sum_1_1;
      else
        slice2winner1_best_below_1_0 <= slice2window_sum_1_0;
        slice2winner1_best_above_1_0 <= 0;
      end if;
      -- slice2winner2
      slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_0;
      slice2winner2_best_index_1_0 <= slice2winner1_best_index_1_0;
      slice2winner2_best_below_0_0 <= slice2winner1_best_below_0_0;
      slice2winner2_best_below_1_0 <= slice2winner1_best_below_1_0;
      slice2winner2_best_above_0_0 <= slice2winner1_best_above_0_0;
      slice2winner2_best_above_1_0 <= slice2winner1_best_above_1_0;
      slice2winner2_best_first_0_0 <= slice2winner1_held_0_0;
      slice2winner2_best_first_1_0 <= slice2winner1_held_1_0;
      slice2winner2_best_late_cost_0_0 <= slice2winner1_best_late_cost_0_0;
      slice2winner2_best_late_cost_1_0 <= slice2winner1_best_late_cost_1_0;
      slice2winner2_best_but_first_0_0 <= slice2winner1_best_but_first_0_0;
      slice2winner2_best_but_first_1_0 <= slice2winner1_best_but_first_1_0;
      -- slice2
      slice2_best_index_0_0_is_less := (slice1_best_cost_0_0 - slice2winner1_best_late_cost_0_0) < 0;
      slice2_best_index_1_0_is_less := (slice1_best_cost_1_0 - slice2winner1_best_late_cost_1_0) < 0;
      if slice2winner2_best_index_0_0 then
        slice2_best_below_0_0_choice := slice2winner2_best_below_0_0;
      else
        slice2_best_below_0_0_choice := slice1_best_last_0_0;
      end if;
      if slice2winner2_best_index_1_0 then
        slice2_best_below_1_0_choice := slice2winner2_best_below_1_0;
      else
        slice2_best_below_1_0_choice := slice1_best_last_1_0;
      end if;
      slice2_best_above_0_0_is_equal := slice1_best_index_0_0 = 5;
      if slice2_best_above_0_0_is_equal then
        slice2_best_above_0_0_choice := slice2winner2_best_first_0_0;
      else
        slice2_best_above_0_0_choice := slice1_best_above_0_0;
      end if;
      slice2_best_above_1_0_is_equal := slice1_best_index_1_0 = 5;
      if slice2_best_above_1_0_is_equal then
        slice2_best_above_1_0_choice := slice2winner2_best_first_1_0;
      else
        slice2_best_above_1_0_choice := slice1_best_above_1_0;
      end if;
      slice2_best_place_0_0_is_not_less := (slice1_best_cost_0_0 - slice2winner1_best_late_cost_0_0) >= 0;
      slice2_best_place_1_0_is_not_less := (slice1_best_cost_1_0 - slice2winner1_best_late_cost_1_0) >= 0;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choice := 1023;
      else
        slice2_best_second_0_0_choice := slice2winner2_best_late_cost_0_0;
      end if;
      if slice2_best_at_end_0_0 then
        slice2_best_second_0_0_choice_2 := slice2winner2_best_but_first_0_0;
      else
        slice2_best_second_0_0_choice_2 := slice2_best_second_0_0_choice;
      end if;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choice_3 := slice1_best_late_cost_0_0;
      else
        slice2_best_second_0_0_choice_3 := slice1_best_second_0_0;
      end if;
      if slice2_best_at_start_0_0 then
        slice2_best_second_0_0_choice_4 := slice1_best_but_last_0_0;
      else
        slice2_best_second_0_0_choice_4 := slice2_best_second_0_0_choice_3;
      end if;
      if slice2_best_place_1_0 then
        slice2_best_second_1_0_choice := 1023;
      else
        slice2_best_second_1_0_choice := slice2winner2_best_late_cost_1_0;
      end if;
      if slice2_best_at_end_1_0 then
        slice2_best_second_1_0_choice_2 := slice2winner2_best_but_first_1_0;
      else
        slice2_best_second_1_0_choice_2 := slice2_best_second_1_0_choice;
      end if;
      if slice2_best_place_1_0 then
        slice2_best_second_1_0_choice_3 := slice1_best_late_cost_1_0;
      else
        slice2_best_second_1_0_choice_3 := slice1_best_second_1_0;
      end if;
      if slice2_best_at_start_1_0 then
        slice2_best_second_1_0_choice_4 := slice1_best_but_last_1_0;
      else
        slice2_best_second_1_0_choice_4 := slice2_best_second_1_0_choice_3;
      end if;
      slice2_best_place_0_0 <= slice2_best_place_0_0_is_not_less;
      slice2_best_place_1_0 <= slice2_best_place_1_0_is_not_less;
      slice2_best_at_start_0_0 <= slice2_best_place_0_0_is_not_less and (not slice2winner2_best_index_0_0);
      slice2_best_at_start_1_0 <= slice2_best_place_1_0_is_not_less and (not slice2winner2_best_index_1_0);
      slice2_best_at_end_0_0 <= slice2_best_index_0_0_is_less and slice2_best_above_0_0_is_equal;
      slice2_best_at_end_1_0 <= slice2_best_index_1_0_is_less and slice2_best_above_1_0_is_equal;
      slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
      slice2_best_late_cost_1_0 <= slice2_best_cost_1_0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if (slice2winner1_best_late_cost_0_0 - slice1_best_cost_0_0) < 0 then
        slice2_best_cost_0_0 <= slice2winner1_best_late_cost_0_0;
      else
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
      end if;
      if (slice2winner1_best_late_cost_1_0 - slice1_best_cost_1_0) < 0 then
        slice2_best_cost_1_0 <= slice2winner1_best_late_cost_1_0;
      else
        slice2_best_cost_1_0 <= slice1_best_cost_1_0;
      end if;
      if slice2_best_index_0_0_is_less then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
        slice2_best_below_0_0 <= slice1_best_below_0_0;
        slice2_best_above_0_0 <= slice2_best_above_0_0_choice;
      else
        slice2_best_index_0_0 <= as_number(slice2winner2_best_index_0_0) + 6;
        slice2_best_below_0_0 <= slice2_best_below_0_0_choice;
        slice2_best_above_0_0 <= slice2winner2_best_above_0_0;
      end if;
      if slice2_best_index_1_0_is_less then
        slice2_best_index_1_0 <= slice1_best_index_1_0;
        slice2_best_below_1_0 <= slice1_best_below_1_0;
        slice2_best_above_1_0 <= slice2_best_above_1_0_choice;
      else
        slice2_best_index_1_0 <= as_number(slice2winner2_best_index_1_0) + 6;
        slice2_best_below_1_0 <= slice2_best_below_1_0_choice;
        slice2_best_above_1_0 <= slice2winner2_best_above_1_0;
      end if;
      if (slice2_best_second_0_0_choice_2 - slice2_best_second_0_0_choice_4) < 0 then
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_2;
      else
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_4;
      end if;
      if (slice2_best_second_1_0_choice_2 - slice2_best_second_1_0_choice_4) < 0 then
        slice2_best_second_1_0 <= slice2_best_second_1_0_choice_2;
      else
        slice2_best_second_1_0 <= slice2_best_second_1_0_choice_4;
      end if;
      -- texture
      texture_passes_0_0 <= 29 < texturewindow_sum_0_0;
      texture_passes_0_1 <= 29 < texturewindow_sum_1_0;
      texture_passes_1_0 <= texture_passes_0_0;
      texture_passes_1_1 <= texture_passes_0_1;
      texture_passes_2_0 <= texture_passes_1_0;
      texture_passes_2_1 <= texture_passes_1_1;
      texture_passes_3_0 <= texture_passes_2_0;
      texture_passes_3_1 <= texture_passes_2_1;
      texture_passes_4_0 <= texture_passes_3_0;
      texture_passes_4_1 <= texture_passes_3_1;
      if rows_inside_0 then
        texture_taps_search_0_0 <= 31;
      else
        texture_taps_search_0_0 <= 0;
      end if;
      if rows_inside_1 then
        texture_taps_search_1_0 <= 31;
      else
        texture_taps_search_1_0 <= 0;
      end if;
      if rows_inside_3 then
        texture_taps_search_3_0 <= 31;
      else
        texture_taps_search_3_0 <= 0;
      end if;
      -- texturecost
      texturecost_single_0_0_is_less := texturecost_difference_0_0 < 0;
      if texturecost_single_0_0_is_less then
        texturecost_single_0_0_choice := (65535 - texturecost_difference_0_0) mod 256;
      else
        texturecost_single_0_0_choice := positive_part(texturecost_difference_0_0);
      end if;
      texturecost_single_3_0_is_less := texturecost_difference_3_0 < 0;
      if texturecost_single_3_0_is_less then
        texturecost_single_3_0_choice := (65535 - texturecost_difference_3_0) mod 256;
      else
        texturecost_single_3_0_choice := positive_part(texturecost_difference_3_0);
      end if;
      texturecost_difference_0_0 <= texture_taps_search_0_0 - slice0shift_reference_0;
      texturecost_difference_1_0 <= texture_taps_search_1_0 - slice0shift_reference_1;
      texturecost_difference_2_0 <= texture_taps_search_1_0 - slice0shift_reference_2;
      texturecost_difference_3_0 <= texture_taps_search_3_0 - slice0shift_reference_3;
      texturecost_pair_0_0 <= as_number((texturecost_difference_1_0 < 0)) + folded(texturecost_difference_1_0) +
        folded(texturecost_difference_2_0);
      texturecost_negative_0_0 <= texturecost_difference_2_0 < 0;
      texturecost_single_0_0 <= (texturecost_single_0_0_choice + as_number(texturecost_single_0_0_is_less)) mod 256;
      texturecost_single_3_0 <= (texturecost_single_3_0_choice + as_number(texturecost_single_3_0_is_less)) mod 256;
      if slice0cost_pair_tag_border_column then
        texturecost_column_0_0 <= 0;
        texturecost_column_1_0 <= 0;
      else
        texturecost_column_0_0 <= (as_number(texturecost_negative_0_0) + texturecost_pair_0_0 + texturecost_single_0_0)
          mod 256;
        texturecost_column_1_0 <= (as_number(texturecost_negative_0_0) + texturecost_pair_0_0 + texturecost_single_3_0)
          mod 256;
      end if;
      -- texturewindow
      if slice0cost_tag_valid then
        texturewindow_partial_0_0_0 <= texturecost_column_0_0;
        texturewindow_partial_0_1_0 <= texturewindow_partial_0_0_0 + texturecost_column_0_0;
        texturewindow_partial_1_0_0 <= texturecost_column_1_0;
        texturewindow_partial_1_1_0 <= texturewindow_partial_1_0_0 + texturecost_column_1_0;
      end if;
      texturewindow_sum_0_0 <= texturewindow_partial_0_1_0 + texturecost_column_0_0;
      texturewindow_sum_1_0 <= texturewindow_partial_1_1_0 + texturecost_column_1_0;
      -- refinement
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 2048) - refinement_divisor_0_0;
      refinement_remainder_1_1_difference := (refinement_remainder_0_1 + 2048) - refinement_divisor_0_1;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 2048) - refinement_divisor_1_0;
      refinement_remainder_2_1_difference := ((refinement_remainder_1_1 * 2) + 2048) - refinement_divisor_1_1;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 2048) - refinement_divisor_2_0;
      refinement_remainder_3_1_difference := ((refinement_remainder_2_1 * 2) + 2048) - refinement_divisor_2_1;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 2048) - refinement_divisor_3_0;
      refinement_remainder_4_1_difference := ((refinement_remainder_3_1 * 2) + 2048) - refinement_divisor_3_1;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 2048) - refinement_divisor_4_0;
      refinement_remainder_5_1_difference := ((refinement_remainder_4_1 * 2) + 2048) - refinement_divisor_4_1;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 2048) - refinement_divisor_5_0;
      refinement_remainder_6_1_difference := ((refinement_remainder_5_1 * 2) + 2048) - refinement_divisor_5_1;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 2048) - refinement_divisor_6_0;
      refinement_remainder_7_1_difference := ((refinement_remainder_6_1 * 2) + 2048) - refinement_divisor_6_1;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
      refinement_divisor_0_1_is_less := (-1) < refinement_difference_1;
      if refinement_divisor_0_1_is_less then
        refinement_divisor_0_1_choice := refinement_v_1;
      else
        refinement_divisor_0_1_choice := refinement_u_1;
      end if;
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
      refinement_fraction_1_difference := 0 - (refinement_quotient_8_1 / 16);
      refinement_fraction_1_value := (refinement_quotient_8_1 + 15) / 16;
      if refinement_negative_8_1 then
        refinement_fraction_1_choice := refinement_fraction_1_difference mod 32;
      else
        refinement_fraction_1_choice := refinement_fraction_1_value;
      end if;
      if refinement_negative_8_1 then
        refinement_fraction_1_choice_2 := refinement_fraction_1_difference mod 8;
      else
        refinement_fraction_1_choice_2 := refinement_fraction_1_value mod 8;
      end if;
      refinement_disparity_0_0 <= slice2_best_index_0_0;
      refinement_disparity_0_1 <= slice2_best_index_1_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_1_1 <= refinement_disparity_0_1;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_2_1 <= refinement_disparity_1_1;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_disparity_3_1 <= refinement_disparity_2_1;
      refinement_disparity_4_0 <= refinement_disparity_3_0;
      refinement_disparity_4_1 <= refinement_disparity_3_1;
      refinement_disparity_5_0 <= refinement_disparity_4_0;
      refinement_disparity_5_1 <= refinement_disparity_4_1;
      refinement_disparity_6_0 <= refinement_disparity_5_0;
      refinement_disparity_6_1 <= refinement_disparity_5_1;
      refinement_disparity_7_0 <= refinement_disparity_6_0;
      refinement_disparity_7_1 <= refinement_disparity_6_1;
      refinement_disparity_8_0 <= refinement_disparity_7_0;
      refinement_disparity_8_1 <= refinement_disparity_7_1;
      refinement_disparity_9_0 <= refinement_disparity_8_0;
      refinement_disparity_9_1 <= refinement_disparity_8_1;
      refinement_disparity_10_0 <= refinement_disparity_9_0;
      refinement_disparity_10_1 <= refinement_disparity_9_1;
      refinement_disparity_11_0 <= refinement_disparity_10_0;
      refinement_disparity_11_1 <= refinement_disparity_10_1;
      refinement_passed_0_0 <= texture_passes_4_0;
      refinement_passed_0_1 <= texture_passes_4_1;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_1_1 <= refinement_passed_0_1;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_passed_2_1 <= refinement_passed_1_1;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_4_1 <= refinement_passed_3_1;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_5_1 <= refinement_passed_4_1;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_6_1 <= refinement_passed_5_1;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_7_1 <= refinement_passed_6_1;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_8_1 <= refinement_passed_7_1;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_9_1 <= refinement_passed_8_1;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_10_1 <= refinement_passed_9_1;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_passed_11_1 <= refinement_passed_10_1;
      refinement_tag_0_valid <= slice2_best_tag_valid;
      refinement_tag_0_map_column <= slice2_best_tag_map_column;
      refinement_tag_0_output_column <= slice2_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice2_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice2_best_tag_end_of_line;
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
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_map_column <= refinement_tag_9_map_column;
      refinement_tag_10_output_column <= refinement_tag_9_output_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_map_column <= refinement_tag_10_map_column;
      refinement_tag_11_output_column <= refinement_tag_10_output_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_alone_0_0 <= slice2_best_second_1_0 = 1023;
      refinement_alone_0_1 <= slice2_best_second_0_0 = 1023;
      refinement_alone_1_0 <= refinement_alone_0_0;
      refinement_alone_1_1 <= refinement_alone_0_1;
      refinement_gap_0 <= (slice2_best_second_0_0 - slice2_best_late_cost_0_0) mod 1024;
      refinement_gap_1 <= (slice2_best_second_1_0 - slice2_best_late_cost_1_0) mod 1024;
      refinement_lowest_0 <= slice2_best_late_cost_0_0;
      refinement_lowest_1 <= slice2_best_late_cost_1_0;
      refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 2;
      refinement_scaled_gap_1 <= (((refinement_gap_1 + (refinement_gap_1 / 4)) * 4) + (refinement_gap_1 mod 4)) * 2;
      refinement_scaled_cost_0 <= refinement_lowest_0;
      refinement_scaled_cost_1 <= refinement_lowest_1;
      refinement_u_0 <= (refinement_below_0 - slice2_best_late_cost_0_0) mod 1024;
      refinement_u_1 <= (refinement_below_1 - slice2_best_late_cost_1_0) mod 1024;
      refinement_v_0 <= (refinement_above_0 - slice2_best_late_cost_0_0) mod 1024;
      refinement_v_1 <= (refinement_above_1 - slice2_best_late_cost_1_0) mod 1024;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_difference_1 <= refinement_above_1 - refinement_below_1;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_remainder_0_1 <= magnitude(refinement_difference_1);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 10)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 10))));
      refinement_divisor_0_1 <= to_integer(((to_unsigned(refinement_divisor_0_1_choice, 10)) or
        (to_unsigned(as_number(((refinement_u_1 = 0) and (refinement_v_1 = 0))), 10))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_1_1 <= refinement_divisor_0_1;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_2_1 <= refinement_divisor_1_1;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_3_1 <= refinement_divisor_2_1;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_4_1 <= refinement_divisor_3_1;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_5_1 <= refinement_divisor_4_1;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_6_1 <= refinement_divisor_5_1;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_divisor_7_1 <= refinement_divisor_6_1;
      refinement_quotient_8_0 <= (((((2048 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) * 2) / 2048) +
        ((other_4 / 2) * 2);
      refinement_quotient_8_1 <= (((((2048 - refinement_divisor_7_1) / 2) + refinement_remainder_7_1) * 2) / 2048) +
        ((other_3 / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_0_1 <= refinement_divisor_0_1_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_1_1 <= refinement_negative_0_1;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_2_1 <= refinement_negative_1_1;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_3_1 <= refinement_negative_2_1;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_4_1 <= refinement_negative_3_1;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_5_1 <= refinement_negative_4_1;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_6_1 <= refinement_negative_5_1;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_7_1 <= refinement_negative_6_1;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_negative_8_1 <= refinement_negative_7_1;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      refinement_fraction_1 <= ((((refinement_fraction_1_choice / 8) + 1) mod 4) * 8) + refinement_fraction_1_choice_2;
      if refinement_alone_1_1 then
        refinement_passed_3_0 <= refinement_passed_2_0;
      else
        refinement_passed_3_0 <= refinement_passed_2_0 and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0);
      end if;
      if refinement_alone_1_0 then
        refinement_passed_3_1 <= refinement_passed_2_1;
      else
        refinement_passed_3_1 <= refinement_passed_2_1 and ((refinement_scaled_cost_1 - refinement_scaled_gap_1) < 0);
      end if;
      if slice2_best_index_0_0 = 0 then
        refinement_below_0 <= slice2_best_above_0_0;
      else
        refinement_below_0 <= slice2_best_below_0_0;
      end if;
      if slice2_best_index_1_0 = 0 then
        refinement_below_1 <= slice2_best_above_1_0;
      else
        refinement_below_1 <= slice2_best_below_1_0;
      end if;
      if slice2_best_index_0_0 = 7 then
        refinement_above_0 <= slice2_best_below_0_0;
      else
        refinement_above_0 <= slice2_best_above_0_0;
      end if;
      if slice2_best_index_1_0 = 7 then
        refinement_above_1 <= slice2_best_below_1_0;
      else
        refinement_above_1 <= slice2_best_above_1_0;
      end if;
      if (refinement_remainder_1_0_difference / 2048) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 1024;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_1_1_difference / 2048) = 1 then
        refinement_remainder_1_1 <= refinement_remainder_1_1_difference mod 1024;
      else
        refinement_remainder_1_1 <= refinement_remainder_0_1;
      end if;
      if (refinement_remainder_2_0_difference / 2048) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 1024;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 512) * 2;
      end if;
      if (refinement_remainder_2_1_difference / 2048) = 1 then
        refinement_remainder_2_1 <= refinement_remainder_2_1_difference mod 1024;
      else
        refinement_remainder_2_1 <= (refinement_remainder_1_1 mod 512) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 2048) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 1024;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 512) * 2;
      end if;
      if (refinement_remainder_3_1_difference / 2048) = 1 then
        refinement_remainder_3_1 <= refinement_remainder_3_1_difference mod 1024;
      else
        refinement_remainder_3_1 <= (refinement_remainder_2_1 mod 512) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 2048) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 1024;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 512) * 2;
      end if;
      if (refinement_remainder_4_1_difference / 2048) = 1 then
        refinement_remainder_4_1 <= refinement_remainder_4_1_difference mod 1024;
      else
        refinement_remainder_4_1 <= (refinement_remainder_3_1 mod 512) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 2048) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 1024;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 512) * 2;
      end if;
      if (refinement_remainder_5_1_difference / 2048) = 1 then
        refinement_remainder_5_1 <= refinement_remainder_5_1_difference mod 1024;
      else
        refinement_remainder_5_1 <= (refinement_remainder_4_1 mod 512) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 2048) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 1024;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 512) * 2;
      end if;
      if (refinement_remainder_6_1_difference / 2048) = 1 then
        refinement_remainder_6_1 <= refinement_remainder_6_1_difference mod 1024;
      else
        refinement_remainder_6_1 <= (refinement_remainder_5_1 mod 512) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 2048) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 1024;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 512) * 2;
      end if;
      if (refinement_remainder_7_1_difference / 2048) = 1 then
        refinement_remainder_7_1 <= refinement_remainder_7_1_difference mod 1024;
      else
        refinement_remainder_7_1 <= (refinement_remainder_6_1 mod 512) * 2;
      end if;
      -- leftright
      leftright_holds_winners_all := (not leftright_holds_winners) and (((leftright_ring_read_address / 4) = 1) or
        (((leftright_ring_read_address / 2) mod 2) = 1) or ((leftright_ring_read_address mod 2) = 1));
      leftright_address_0_value := to_integer(leftright_held_0(6 downto 4));
      leftright_address_1_value := to_integer(leftright_held_0(20 downto 18));
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_checked_passed_1_difference := (leftright_answered_disparity_1 + 1) - to_integer(leftright_found_1);
      leftright_other_1_0 <= slice2other_winner_out_0;
      leftright_other_1_1 <= slice2other_winner_out_1;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_2_1 <= leftright_other_1_1;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_other_3_1 <= leftright_other_2_1;
      leftright_other_4_0 <= leftright_other_3_0;
      leftright_other_4_1 <= leftright_other_3_1;
      leftright_other_5_0 <= leftright_other_4_0;
      leftright_other_5_1 <= leftright_other_4_1;
      leftright_other_6_0 <= leftright_other_5_0;
      leftright_other_6_1 <= leftright_other_5_1;
      leftright_other_7_0 <= leftright_other_6_0;
      leftright_other_7_1 <= leftright_other_6_1;
      leftright_other_8_0 <= leftright_other_7_0;
      leftright_other_8_1 <= leftright_other_7_1;
      leftright_other_9_0 <= leftright_other_8_0;
      leftright_other_9_1 <= leftright_other_8_1;
      leftright_other_10_0 <= leftright_other_9_0;
      leftright_other_10_1 <= leftright_other_9_1;
      leftright_other_11_0 <= leftright_other_10_0;
      leftright_other_11_1 <= leftright_other_10_1;
      leftright_other_12_0 <= leftright_other_11_0;
      leftright_other_12_1 <= leftright_other_11_1;
      leftright_other_13_0 <= leftright_other_12_0;
      leftright_other_13_1 <= leftright_other_12_1;
      leftright_position <= (leftright_position + as_number(refinement_tag_11_valid)) mod 16;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and refinement_tag_11_valid;
      leftright_address_0 <= (leftright_held_position - leftright_address_0_value) mod 16;
      leftright_address_1 <= (leftright_held_position - leftright_address_1_value) mod 16;
      leftright_asking_disparity_0 <= leftright_address_0_value;
      leftright_asking_disparity_1 <= leftright_address_1_value;
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_fraction_1 <= to_integer(leftright_held_0(31 downto 27));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_passed_1 <= to_integer(leftright_held_0(26 downto 26)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= to_integer(leftright_held_0(0 downto 0)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_disparity_1 <= leftright_asking_disparity_1;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_fraction_1 <= leftright_asking_fraction_1;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_passed_1 <= leftright_asking_passed_1;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_disparity_1 <= leftright_answered_disparity_1;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_fraction_1 <= leftright_answered_fraction_1;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_passed_1 <= leftright_answered_passed_1 and (leftright_checked_passed_1_difference >= 0) and
        (leftright_checked_passed_1_difference < 3);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_all then
        leftright_holds_winners <= (not refinement_tag_11_valid) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_11_valid or leftright_holds_winners;
      end if;
      if refinement_tag_11_valid then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 7 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 8;
        end if;
      end if;
      -- map
      map_counter_column_is_equal := map_counter_column = 23;
      map_counter_column_all := leftright_checked_tag_valid and leftright_checked_tag_map_column;
      if map_counter_column_all then
        if map_counter_column_is_equal or leftright_checked_tag_start_of_frame then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 32;
        end if;
      end if;
      map_counter_group_is_equal := map_counter_group = 5;
      map_counter_group_all := map_counter_column_is_equal and map_counter_group_is_equal;
      if map_counter_group_all then
        map_counter_group_choice := 3;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_any := (not ((map_counter_group / 4) = 1)) or (not (((map_counter_group / 2) mod 2) = 1)) or
        (not ((map_counter_group mod 2) = 1));
      map_counter_group_is_equal_2 := map_counter_group = 6;
      if map_counter_next_frame and map_counter_group_is_equal_2 then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 8;
      end if;
      if map_counter_column_is_equal and map_counter_group_any and leftright_checked_tag_valid and
        leftright_checked_tag_map_column then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if map_counter_column_is_equal and map_counter_group_any then
        map_counter_next_frame_choice := (map_counter_group /= 6) and map_counter_next_frame;
      else
        map_counter_next_frame_choice := map_counter_next_frame;
      end if;
      if map_counter_next_frame_choice then
        map_counter_next_frame_choice_2 := map_counter_group_all or (not leftright_checked_tag_start_of_frame);
      else
        map_counter_next_frame_choice_2 := map_counter_column_is_equal and map_counter_group_is_equal and
          leftright_checked_tag_start_of_frame;
      end if;
      if leftright_checked_tag_valid then
        map_line_ended_choice := leftright_checked_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_0(16 downto 16)) = 1;
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_1 / 2;
      end if;
      if map_at_bottom then
        map_of_column_1_c_choice := map_column_2 / 2;
      else
        map_of_column_1_c_choice := map_column_3 / 2;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_low_0_choice := map_of_column_0_c;
      else
        map_sorted_low_0_choice := map_of_column_0_b;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_low_0_choice_2 := map_of_column_0_c;
      else
        map_sorted_low_0_choice_2 := map_of_column_0_a;
      end if;
      if map_of_column_1_c_below_b then
        map_sorted_low_1_choice := map_of_column_1_c;
      else
        map_sorted_low_1_choice := map_of_column_0_c;
      end if;
      if map_of_column_1_c_below_a then
        map_sorted_low_1_choice_2 := map_of_column_1_c;
      else
        map_sorted_low_1_choice_2 := map_of_column_0_b;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_middle_0_choice := map_of_column_0_b;
      else
        map_sorted_middle_0_choice := map_sorted_low_0_choice_2;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_middle_0_choice_2 := map_of_column_0_a;
      else
        map_sorted_middle_0_choice_2 := map_sorted_low_0_choice;
      end if;
      if map_of_column_1_c_below_b then
        map_sorted_middle_1_choice := map_of_column_0_c;
      else
        map_sorted_middle_1_choice := map_sorted_low_1_choice_2;
      end if;
      if map_of_column_1_c_below_a then
        map_sorted_middle_1_choice_2 := map_of_column_0_b;
      else
        map_sorted_middle_1_choice_2 := map_sorted_low_1_choice;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_high_0_choice := map_of_column_0_a;
      else
        map_sorted_high_0_choice := map_of_column_0_c;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_high_0_choice_2 := map_of_column_0_b;
      else
        map_sorted_high_0_choice_2 := map_of_column_0_c;
      end if;
      if map_of_column_1_c_below_a then
        map_sorted_high_1_choice := map_of_column_0_b;
      else
        map_sorted_high_1_choice := map_of_column_1_c;
      end if;
      if map_of_column_1_c_below_b then
        map_sorted_high_1_choice_2 := map_of_column_0_c;
      else
        map_sorted_high_1_choice_2 := map_of_column_1_c;
      end if;
      map_passed_1_0_all := (not map_sorted_arrives) and (not map_sorted_behind);
      map_passed_1_0_any := map_sorted_arrives or map_sorted_behind;
      map_window_complete_all := map_sorted_arrives and (map_sorted_column = 0);
      if map_of_low_0_c_below_a then
        map_largest_low_0_choice := map_of_low_0_a;
      else
        map_largest_low_0_choice := map_of_low_0_c;
      end if;
      if map_of_low_0_c_below_b then
        map_largest_low_0_choice_2 := map_of_low_0_b;
      else
        map_largest_low_0_choice_2 := map_of_low_0_c;
      end if;
      if map_of_low_1_c_below_a then
        map_largest_low_1_choice := map_of_low_1_a;
      else
        map_largest_low_1_choice := map_of_low_1_c;
      end if;
      if map_of_low_1_c_below_b then
        map_largest_low_1_choice_2 := map_of_low_1_b;
      else
        map_largest_low_1_choice_2 := map_of_low_1_c;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice := map_of_middle_0_c;
      else
        map_median_middle_0_choice := map_of_middle_0_a;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choice_2 := map_of_middle_0_b;
      else
        map_median_middle_0_choice_2 := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choice_3 := map_of_middle_0_c;
      else
        map_median_middle_0_choice_3 := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice_4 := map_of_middle_0_a;
      else
        map_median_middle_0_choice_4 := map_median_middle_0_choice_3;
      end if;
      if map_of_middle_1_c_below_a then
        map_median_middle_1_choice := map_of_middle_1_c;
      else
        map_median_middle_1_choice := map_of_middle_1_a;
      end if;
      if map_of_middle_1_c_below_b then
        map_median_middle_1_choice_2 := map_of_middle_1_b;
      else
        map_median_middle_1_choice_2 := map_median_middle_1_choice;
      end if;
      if map_of_middle_1_c_below_b then
        map_median_middle_1_choice_3 := map_of_middle_1_c;
      else
        map_median_middle_1_choice_3 := map_of_middle_1_b;
      end if;
      if map_of_middle_1_c_below_a then
        map_median_middle_1_choice_4 := map_of_middle_1_a;
      else
        map_median_middle_1_choice_4 := map_median_middle_1_choice_3;
      end if;
      if map_of_high_0_c_below_b then
        map_smallest_high_0_choice := map_of_high_0_c;
      else
        map_smallest_high_0_choice := map_of_high_0_b;
      end if;
      if map_of_high_0_c_below_a then
        map_smallest_high_0_choice_2 := map_of_high_0_c;
      else
        map_smallest_high_0_choice_2 := map_of_high_0_a;
      end if;
      if map_of_high_1_c_below_b then
        map_smallest_high_1_choice := map_of_high_1_c;
      else
        map_smallest_high_1_choice := map_of_high_1_b;
      end if;
      if map_of_high_1_c_below_a then
        map_smallest_high_1_choice_2 := map_of_high_1_c;
      else
        map_smallest_high_1_choice_2 := map_of_high_1_a;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice := map_of_all_0_c;
      else
        map_out_disparity_0_choice := map_of_all_0_a;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choice_2 := map_of_all_0_b;
      else
        map_out_disparity_0_choice_2 := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choice_3 := map_of_all_0_c;
      else
        map_out_disparity_0_choice_3 := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice_4 := map_of_all_0_a;
      else
        map_out_disparity_0_choice_4 := map_out_disparity_0_choice_3;
      end if;
      if map_of_all_1_c_below_a then
        map_out_disparity_1_choice := map_of_all_1_c;
      else
        map_out_disparity_1_choice := map_of_all_1_a;
      end if;
      if map_of_all_1_c_below_b then
        map_out_disparity_1_choice_2 := map_of_all_1_b;
      else
        map_out_disparity_1_choice_2 := map_out_disparity_1_choice;
      end if;
      if map_of_all_1_c_below_b then
        map_out_disparity_1_choice_3 := map_of_all_1_c;
      else
        map_out_disparity_1_choice_3 := map_of_all_1_b;
      end if;
      if map_of_all_1_c_below_a then
        map_out_disparity_1_choice_4 := map_of_all_1_a;
      else
        map_out_disparity_1_choice_4 := map_out_disparity_1_choice_3;
      end if;
      map_newest_0 <= ((((((((leftright_checked_disparity_0 + 2047) mod 2048) * 2) + (leftright_checked_fraction_0 / 8)
        + 1) mod 4096) * 8) + (leftright_checked_fraction_0 mod 8)) * 2) + as_number(leftright_checked_passed_0);
      map_newest_1 <= ((((((((leftright_checked_disparity_1 + 2047) mod 2048) * 2) + (leftright_checked_fraction_1 / 8)
        + 1) mod 4096) * 8) + (leftright_checked_fraction_1 mod 8)) * 2) + as_number(leftright_checked_passed_1);
      map_arrives <= map_counter_column_all;
      map_behind <= map_line_ended and leftright_checked_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_read_newest_1 <= map_newest_1;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_words_1 <= to_integer(map_rows_read_words_1);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_rows_ready_newest_1 <= map_rows_read_newest_1;
      map_write_column <= to_integer(other_0(4 downto 0));
      map_column_1 <= map_rows_ready_words_0 / 8192;
      map_column_2 <= map_rows_ready_words_1;
      map_column_3 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_0(24 downto 24)) = 1;
      map_at_top <= to_integer(other_0(32 downto 32)) = 1;
      map_at_bottom <= to_integer(other_0(40 downto 40)) = 1;
      map_at_output <= to_integer(other_0(48 downto 48)) = 1;
      map_of_column_0_a <= map_of_column_0_a_choice;
      map_of_column_0_b <= map_column_1 / 2;
      map_of_column_0_c <= map_column_2 / 2;
      map_of_column_0_b_below_a <= ((map_column_1 / 2) - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_a <= ((map_column_2 / 2) - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_b <= ((map_column_2 / 2) - (map_column_1 / 2)) < 0;
      map_of_column_1_c <= map_of_column_1_c_choice;
      map_of_column_1_c_below_a <= (map_of_column_1_c_choice - (map_column_1 / 2)) < 0;
      map_of_column_1_c_below_b <= (map_of_column_1_c_choice - (map_column_2 / 2)) < 0;
      map_column_passed_0_0 <= (map_column_1 mod 2) = 1;
      map_column_passed_0_1 <= (map_column_2 mod 2) = 1;
      map_column_passed_1_0 <= map_column_passed_0_0;
      map_column_passed_1_1 <= map_column_passed_0_1;
      map_comparing_column <= map_write_column;
      map_comparing_arrives <= map_at_arrives;
      map_comparing_behind <= map_at_behind;
      map_comparing_top <= map_at_top;
      map_comparing_output <= map_at_output;
      map_sorted_column <= map_comparing_column;
      map_sorted_arrives <= map_comparing_arrives;
      map_sorted_behind <= map_comparing_behind;
      map_sorted_top <= map_comparing_top;
      map_sorted_output <= map_comparing_output;
      map_window_first <= map_sorted_top and map_sorted_arrives and (map_sorted_column = 1);
      map_window_last <= map_sorted_behind;
      map_of_low_0_a <= map_low_0_0;
      map_of_low_0_b <= map_low_1_0;
      map_of_low_0_c <= map_low_2_0;
      map_of_low_0_b_below_a <= (map_low_1_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_a <= (map_low_2_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_b <= (map_low_2_0 - map_low_1_0) < 0;
      map_of_low_1_a <= map_low_0_1;
      map_of_low_1_b <= map_low_1_1;
      map_of_low_1_c <= map_low_2_1;
      map_of_low_1_b_below_a <= (map_low_1_1 - map_low_0_1) < 0;
      map_of_low_1_c_below_a <= (map_low_2_1 - map_low_0_1) < 0;
      map_of_low_1_c_below_b <= (map_low_2_1 - map_low_1_1) < 0;
      map_of_middle_0_a <= map_middle_0_0;
      map_of_middle_0_b <= map_middle_1_0;
      map_of_middle_0_c <= map_middle_2_0;
      map_of_middle_0_b_below_a <= (map_middle_1_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_a <= (map_middle_2_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_b <= (map_middle_2_0 - map_middle_1_0) < 0;
      map_of_middle_1_a <= map_middle_0_1;
      map_of_middle_1_b <= map_middle_1_1;
      map_of_middle_1_c <= map_middle_2_1;
      map_of_middle_1_b_below_a <= (map_middle_1_1 - map_middle_0_1) < 0;
      map_of_middle_1_c_below_a <= (map_middle_2_1 - map_middle_0_1) < 0;
      map_of_middle_1_c_below_b <= (map_middle_2_1 - map_middle_1_1) < 0;
      map_of_high_0_a <= map_high_0_0;
      map_of_high_0_b <= map_high_1_0;
      map_of_high_0_c <= map_high_2_0;
      map_of_high_0_b_below_a <= (map_high_1_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_a <= (map_high_2_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_b <= (map_high_2_0 - map_high_1_0) < 0;
      map_of_high_1_a <= map_high_0_1;
      map_of_high_1_b <= map_high_1_1;
      map_of_high_1_c <= map_high_2_1;
      map_of_high_1_b_below_a <= (map_high_1_1 - map_high_0_1) < 0;
      map_of_high_1_c_below_a <= (map_high_2_1 - map_high_0_1) < 0;
      map_of_high_1_c_below_b <= (map_high_2_1 - map_high_1_1) < 0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_of_all_0_b_below_a <= (map_median_middle_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_a <= (map_smallest_high_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_b <= (map_smallest_high_0 - map_median_middle_0) < 0;
      map_of_all_1_a <= map_largest_low_1;
      map_of_all_1_b <= map_median_middle_1;
      map_of_all_1_c <= map_smallest_high_1;
      map_of_all_1_b_below_a <= (map_median_middle_1 - map_largest_low_1) < 0;
      map_of_all_1_c_below_a <= (map_smallest_high_1 - map_largest_low_1) < 0;
      map_of_all_1_c_below_b <= (map_smallest_high_1 - map_median_middle_1) < 0;
      map_waiting_0_complete <= map_window_complete;
      map_waiting_0_first <= map_window_first;
      map_waiting_0_last <= map_window_last;
      map_waiting_1_complete <= map_waiting_0_complete;
      map_waiting_1_first <= map_waiting_0_first;
      map_waiting_1_last <= map_waiting_0_last;
      map_waiting_2_complete <= map_waiting_1_complete;
      map_waiting_2_first <= map_waiting_1_first;
      map_waiting_2_last <= map_waiting_1_last;
      map_waiting_passed_0_0 <= map_passed_1_0;
      map_waiting_passed_0_1 <= map_passed_1_1;
      map_waiting_passed_1_0 <= map_waiting_passed_0_0;
      map_waiting_passed_1_1 <= map_waiting_passed_0_1;
      map_waiting_passed_2_0 <= map_waiting_passed_1_0;
      map_waiting_passed_2_1 <= map_waiting_passed_1_1;
      map_out_passed_0 <= map_waiting_passed_2_0;
      map_out_passed_1 <= map_waiting_passed_2_1;
      map_out_valid <= map_waiting_2_complete;
      map_out_start_of_frame <= map_waiting_2_first and map_waiting_2_complete;
      map_out_end_of_line <= map_waiting_2_last and map_waiting_2_complete;
      if leftright_checked_tag_start_of_frame and leftright_checked_tag_valid and leftright_checked_tag_map_column then
        map_counter_group <= map_counter_group_choice * 2;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if map_counter_next_frame_choice_2 then
        map_counter_next_frame <= map_counter_next_frame or map_counter_column_all;
      else
        map_counter_next_frame <= map_counter_next_frame and ((not leftright_checked_tag_valid) or (not
          leftright_checked_tag_map_column));
      end if;
      if leftright_checked_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not leftright_checked_tag_valid);
      end if;
      if map_of_column_0_b_below_a then
        map_sorted_low_0 <= map_sorted_low_0_choice;
        map_sorted_middle_0 <= map_sorted_middle_0_choice;
        map_sorted_high_0 <= map_sorted_high_0_choice;
      else
        map_sorted_low_0 <= map_sorted_low_0_choice_2;
        map_sorted_middle_0 <= map_sorted_middle_0_choice_2;
        map_sorted_high_0 <= map_sorted_high_0_choice_2;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_low_1 <= map_sorted_low_1_choice;
        map_sorted_middle_1 <= map_sorted_middle_1_choice;
        map_sorted_high_1 <= map_sorted_high_1_choice;
      else
        map_sorted_low_1 <= map_sorted_low_1_choice_2;
        map_sorted_middle_1 <= map_sorted_middle_1_choice_2;
        map_sorted_high_1 <= map_sorted_high_1_choice_2;
      end if;
      if map_passed_1_0 then
        map_passed_1_0 <= map_passed_0_0 or map_passed_1_0_all;
      else
        map_passed_1_0 <= map_passed_0_0 and map_passed_1_0_any;
      end if;
      if map_passed_1_1 then
        map_passed_1_1 <= map_passed_0_1 or map_passed_1_0_all;
      else
        map_passed_1_1 <= map_passed_0_1 and map_passed_1_0_any;
      end if;
      if map_window_complete_all then
        map_window_complete <= map_sorted_output and map_sorted_behind;
      else
        map_window_complete <= map_sorted_output and map_passed_1_0_any;
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_low_1_b_below_a then
        map_largest_low_1 <= map_largest_low_1_choice;
      else
        map_largest_low_1 <= map_largest_low_1_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choice_2;
      else
        map_median_middle_0 <= map_median_middle_0_choice_4;
      end if;
      if map_of_middle_1_b_below_a then
        map_median_middle_1 <= map_median_middle_1_choice_2;
      else
        map_median_middle_1 <= map_median_middle_1_choice_4;
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_high_1_b_below_a then
        map_smallest_high_1 <= map_smallest_high_1_choice;
      else
        map_smallest_high_1 <= map_smallest_high_1_choice_2;
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choice_2;
      else
        map_out_disparity_0 <= map_out_disparity_0_choice_4;
      end if;
      if map_of_all_1_b_below_a then
        map_out_disparity_1 <= map_out_disparity_1_choice_2;
      else
        map_out_disparity_1 <= map_out_disparity_1_choice_4;
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= map_rows_ready_words_1 + (map_rows_ready_newest_0 * 8192);
        map_rows_write_words_1 <= map_rows_ready_newest_1;
        map_at_column <= to_integer(other_0(4 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0_0;
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      if map_sorted_behind then
        map_low_0_1_choice := map_low_0_1;
      else
        map_low_0_1_choice := map_sorted_low_1;
      end if;
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0_0;
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_middle_0_1_choice := map_middle_0_1;
      else
        map_middle_0_1_choice := map_sorted_middle_1;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0_0;
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      if map_sorted_behind then
        map_high_0_1_choice := map_high_0_1;
      else
        map_high_0_1_choice := map_sorted_high_1;
      end if;
      if map_passed_1_0_any then
        map_low_0_0 <= map_low_0_0_choice;
        map_low_0_1 <= map_low_0_1_choice;
        map_low_2_0 <= map_low_1_0;
        map_low_2_1 <= map_low_1_1;
        map_middle_0_0 <= map_middle_0_0_choice;
        map_middle_0_1 <= map_middle_0_1_choice;
        map_middle_2_0 <= map_middle_1_0;
        map_middle_2_1 <= map_middle_1_1;
        map_high_0_0 <= map_high_0_0_choice;
        map_high_0_1 <= map_high_0_1_choice;
        map_high_2_0 <= map_high_1_0;
        map_high_2_1 <= map_high_1_1;
        if map_window_complete_all then
          map_low_1_0 <= map_low_0_0_choice;
          map_low_1_1 <= map_low_0_1_choice;
          map_middle_1_0 <= map_middle_0_0_choice;
          map_middle_1_1 <= map_middle_0_1_choice;
          map_high_1_0 <= map_high_0_0_choice;
          map_high_1_1 <= map_high_0_1_choice;
        else
          map_low_1_0 <= map_low_0_0;
          map_low_1_1 <= map_low_0_1;
          map_middle_1_0 <= map_middle_0_0;
          map_middle_1_1 <= map_middle_0_1;
          map_high_1_0 <= map_high_0_0;
          map_high_1_1 <= map_high_0_1;
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0_0 <= map_column_passed_1_0;
        map_passed_0_1 <= map_column_passed_1_1;
      end if;
      -- other
      other_0 <= other_2;
      other_1 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
      other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 7))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal_2), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_3 <= ((refinement_remainder_7_1_difference / 2048) * 2) + ((other_5 / 4) * 4);
      other_4 <= ((refinement_remainder_7_0_difference / 2048) * 2) + ((other_6 / 4) * 4);
      other_5 <= ((refinement_remainder_6_1_difference / 2048) * 4) + ((other_7 / 8) * 8);
      other_6 <= ((refinement_remainder_6_0_difference / 2048) * 4) + ((other_8 / 8) * 8);
      other_7 <= ((refinement_remainder_5_1_difference / 2048) * 8) + ((other_9 / 16) * 16);
      other_8 <= ((refinement_remainder_5_0_difference / 2048) * 8) + ((other_10 / 16) * 16);
      other_9 <= ((refinement_remainder_4_1_difference / 2048) * 16) + ((other_11 / 32) * 32);
      other_10 <= ((refinement_remainder_4_0_difference / 2048) * 16) + ((other_12 / 32) * 32);
      other_11 <= ((refinement_remainder_3_1_difference / 2048) * 32) + ((other_13 / 64) * 64);
      other_12 <= ((refinement_remainder_3_0_difference / 2048) * 32) + ((other_14 / 64) * 64);
      other_13 <= ((refinement_remainder_2_1_difference / 2048) * 64) + ((other_15 / 128) * 128);
      other_14 <= ((refinement_remainder_2_0_difference / 2048) * 64) + ((other_16 / 128) * 128);
      other_15 <= (refinement_remainder_1_1_difference / 2048) * 128;
      other_16 <= (refinement_remainder_1_0_difference / 2048) * 128;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_left_1 <= 0;
        transform_right_0 <= 0;
        transform_right_1 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 7;
        transform_counter_next_frame <= false;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_read_newest_1 <= 0;
        transform_left_rows_ready_words_0 <= 0;
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_ready_newest_1 <= 0;
        transform_left_rows_write_words_0 <= 0;
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_read_newest_1 <= 0;
        transform_right_rows_ready_words_0 <= 0;
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_ready_newest_1 <= 0;
        transform_right_rows_write_words_0 <= 0;
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_row_inside_1 <= false;
        transform_read_row_inside_3 <= false;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_1 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_row_inside_0 <= false;
        transform_ready_row_inside_1 <= false;
        transform_ready_row_inside_3 <= false;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_left_column_0 <= 0;
        transform_left_column_1 <= 0;
        transform_left_column_2 <= 0;
        transform_left_column_3 <= 0;
        transform_right_column_0 <= 0;
        transform_right_column_1 <= 0;
        transform_right_column_2 <= 0;
        transform_right_column_3 <= 0;
        transform_columns_row_inside_0 <= false;
        transform_columns_row_inside_1 <= false;
        transform_columns_row_inside_3 <= false;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_left_filter_column_0_0 <= 0;
        transform_left_filter_column_0_1 <= 0;
        transform_left_filter_column_1_0 <= 0;
        transform_left_filter_column_1_1 <= 0;
        transform_left_filter_column_2_0 <= 0;
        transform_left_filter_column_2_1 <= 0;
        transform_left_filter_slope_0 <= 0;
        transform_left_filter_slope_1 <= 0;
        transform_left_filter_whole <= false;
        transform_left_filter_feature_0 <= 0;
        transform_left_filter_feature_1 <= 0;
        transform_right_filter_column_0_0 <= 0;
        transform_right_filter_column_0_1 <= 0;
        transform_right_filter_column_1_0 <= 0;
        transform_right_filter_column_1_1 <= 0;
        transform_right_filter_column_2_0 <= 0;
        transform_right_filter_column_2_1 <= 0;
        transform_right_filter_slope_0 <= 0;
        transform_right_filter_slope_1 <= 0;
        transform_right_filter_feature_0 <= 0;
        transform_right_filter_feature_1 <= 0;
        transform_filtering_0_column_inside_0 <= false;
        transform_filtering_0_column_inside_2 <= false;
        transform_filtering_0_start_of_frame <= false;
        transform_filtering_0_valid <= false;
        transform_filtering_1_start_of_frame <= false;
        transform_filtering_1_valid <= false;
        transform_filtering_2_start_of_frame <= false;
        transform_filtering_2_valid <= false;
        raster_features_search_0 <= 0;
        raster_features_search_1 <= 0;
        raster_features_reference_0 <= 0;
        raster_features_reference_1 <= 0;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 7;
        raster_place_next_frame <= false;
        delay_ahead_0 <= 0;
        delay_ahead_1 <= 0;
        delay_delayed_0 <= 0;
        delay_column <= 0;
        delay_row_inside_0 <= false;
        delay_row_inside_1 <= false;
        delay_row_inside_3 <= false;
        delay_tag_valid <= false;
        delay_tag_border_column <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        rows_search_rows_read_newest_1 <= 0;
        rows_search_rows_ready_words_0 <= 0;
        rows_search_rows_ready_newest_0 <= 0;
        rows_search_rows_ready_newest_1 <= 0;
        rows_search_rows_write_words_0 <= 0;
        rows_reference_rows_read_newest_0 <= 0;
        rows_reference_rows_read_newest_1 <= 0;
        rows_reference_rows_ready_words_0 <= 0;
        rows_reference_rows_ready_newest_0 <= 0;
        rows_reference_rows_ready_newest_1 <= 0;
        rows_reference_rows_write_words_0 <= 0;
        rows_read_column <= 0;
        rows_read_inside_0 <= false;
        rows_read_inside_1 <= false;
        rows_read_inside_3 <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_border_column <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside_0 <= false;
        rows_ready_inside_1 <= false;
        rows_ready_inside_3 <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_border_column <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search_0 <= 0;
        rows_search_1 <= 0;
        rows_search_2 <= 0;
        rows_search_3 <= 0;
        rows_reference_0 <= 0;
        rows_reference_1 <= 0;
        rows_reference_2 <= 0;
        rows_reference_3 <= 0;
        rows_inside_0 <= false;
        rows_inside_1 <= false;
        rows_inside_3 <= false;
        rows_tag_valid <= false;
        rows_tag_border_column <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_search_0_0 <= 0;
        slice0shift_search_0_1 <= 0;
        slice0shift_search_0_2 <= 0;
        slice0shift_search_1_0 <= 0;
        slice0shift_search_1_1 <= 0;
        slice0shift_search_1_2 <= 0;
        slice0shift_search_2_0 <= 0;
        slice0shift_search_2_1 <= 0;
        slice0shift_search_2_2 <= 0;
        slice0shift_search_3_0 <= 0;
        slice0shift_search_3_1 <= 0;
        slice0shift_search_3_2 <= 0;
        slice0shift_reference_0 <= 0;
        slice0shift_reference_1 <= 0;
        slice0shift_reference_2 <= 0;
        slice0shift_reference_3 <= 0;
        slice0shift_search_out_0 <= 0;
        slice0shift_search_out_1 <= 0;
        slice0shift_search_out_2 <= 0;
        slice0shift_search_out_3 <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_border_column <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_0_0 <= 0;
        slice0cost_difference_0_1 <= 0;
        slice0cost_difference_0_2 <= 0;
        slice0cost_difference_1_0 <= 0;
        slice0cost_difference_1_1 <= 0;
        slice0cost_difference_1_2 <= 0;
        slice0cost_difference_2_0 <= 0;
        slice0cost_difference_2_1 <= 0;
        slice0cost_difference_2_2 <= 0;
        slice0cost_difference_3_0 <= 0;
        slice0cost_difference_3_1 <= 0;
        slice0cost_difference_3_2 <= 0;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_border_column <= false;
        slice0cost_difference_tag_map_column <= false;
        slice0cost_difference_tag_output_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_0_0 <= 0;
        slice0cost_pair_0_1 <= 0;
        slice0cost_pair_0_2 <= 0;
        slice0cost_negative_0_0 <= false;
        slice0cost_negative_0_1 <= false;
        slice0cost_negative_0_2 <= false;
        slice0cost_single_0_0 <= 0;
        slice0cost_single_0_1 <= 0;
        slice0cost_single_0_2 <= 0;
        slice0cost_single_3_0 <= 0;
        slice0cost_single_3_1 <= 0;
        slice0cost_single_3_2 <= 0;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_border_column <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_border_column <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_partial_0_0_0 <= 0;
        slice0window_partial_0_0_1 <= 0;
        slice0window_partial_0_0_2 <= 0;
        slice0window_partial_0_1_0 <= 0;
        slice0window_partial_0_1_1 <= 0;
        slice0window_partial_0_1_2 <= 0;
        slice0window_partial_1_0_0 <= 0;
        slice0window_partial_1_0_1 <= 0;
        slice0window_partial_1_0_2 <= 0;
        slice0window_partial_1_1_0 <= 0;
        slice0window_partial_1_1_1 <= 0;
        slice0window_partial_1_1_2 <= 0;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_sum_0_0 <= 0;
        slice0window_sum_0_1 <= 0;
        slice0window_sum_0_2 <= 0;
        slice0window_sum_1_0 <= 0;
        slice0window_sum_1_1 <= 0;
        slice0window_sum_1_2 <= 0;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_held_0_0 <= 0;
        slice0winner1_held_0_1 <= 0;
        slice0winner1_held_0_2 <= 0;
        slice0winner1_held_1_0 <= 0;
        slice0winner1_held_1_1 <= 0;
        slice0winner1_held_1_2 <= 0;
        slice0winner1_best_cost_0_0 <= 0;
        slice0winner1_best_cost_1_0 <= 0;
        slice0winner1_best_index_0_0 <= false;
        slice0winner1_best_index_0_1 <= 0;
        slice0winner1_best_index_1_0 <= false;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_below_1_0 <= 0;
        slice0winner1_best_above_0_0 <= 0;
        slice0winner1_best_above_1_0 <= 0;
        slice0winner1_best_late_cost_0_0 <= 0;
        slice0winner1_best_late_cost_0_1 <= 0;
        slice0winner1_best_late_cost_1_0 <= 0;
        slice0winner1_best_late_cost_1_1 <= 0;
        slice0winner1_best_but_last_0_0 <= 1023;
        slice0winner1_best_but_last_1_0 <= 1023;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_best_cost_0_0 <= 0;
        slice0winner2_best_cost_1_0 <= 0;
        slice0winner2_best_index_0_0 <= 0;
        slice0winner2_best_index_1_0 <= 0;
        slice0winner2_best_below_0_0 <= 0;
        slice0winner2_best_below_1_0 <= 0;
        slice0winner2_best_above_0_0 <= 0;
        slice0winner2_best_above_1_0 <= 0;
        slice0winner2_best_place_0_0 <= false;
        slice0winner2_best_place_1_0 <= false;
        slice0winner2_best_at_start_0_0 <= false;
        slice0winner2_best_at_start_1_0 <= false;
        slice0winner2_best_at_end_0_0 <= false;
        slice0winner2_best_at_end_1_0 <= false;
        slice0winner2_best_late_cost_0_0 <= 0;
        slice0winner2_best_late_cost_1_0 <= 0;
        slice0winner2_best_second_0_0 <= 1023;
        slice0winner2_best_second_1_0 <= 1023;
        slice0winner2_best_but_last_0_0 <= 1023;
        slice0winner2_best_but_last_1_0 <= 1023;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0_best_index_0_0 <= 0;
        slice0_best_index_1_0 <= 0;
        slice0_best_below_0_0 <= 0;
        slice0_best_below_1_0 <= 0;
        slice0_best_above_0_0 <= 0;
        slice0_best_above_1_0 <= 0;
        slice0_best_last_0_0 <= 0;
        slice0_best_last_1_0 <= 0;
        slice0_best_late_cost_0_0 <= 0;
        slice0_best_late_cost_1_0 <= 0;
        slice0_best_second_0_0 <= 1023;
        slice0_best_second_1_0 <= 1023;
        slice0_best_but_last_0_0 <= 1023;
        slice0_best_but_last_1_0 <= 1023;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1shift_search_0_0 <= 0;
        slice1shift_search_0_1 <= 0;
        slice1shift_search_0_2 <= 0;
        slice1shift_search_1_0 <= 0;
        slice1shift_search_1_1 <= 0;
        slice1shift_search_1_2 <= 0;
        slice1shift_search_2_0 <= 0;
        slice1shift_search_2_1 <= 0;
        slice1shift_search_2_2 <= 0;
        slice1shift_search_3_0 <= 0;
        slice1shift_search_3_1 <= 0;
        slice1shift_search_3_2 <= 0;
        slice1shift_reference_0 <= 0;
        slice1shift_reference_1 <= 0;
        slice1shift_reference_2 <= 0;
        slice1shift_reference_3 <= 0;
        slice1shift_search_out_0 <= 0;
        slice1shift_search_out_1 <= 0;
        slice1shift_search_out_2 <= 0;
        slice1shift_search_out_3 <= 0;
        slice1cost_difference_0_0 <= 0;
        slice1cost_difference_0_1 <= 0;
        slice1cost_difference_0_2 <= 0;
        slice1cost_difference_1_0 <= 0;
        slice1cost_difference_1_1 <= 0;
        slice1cost_difference_1_2 <= 0;
        slice1cost_difference_2_0 <= 0;
        slice1cost_difference_2_1 <= 0;
        slice1cost_difference_2_2 <= 0;
        slice1cost_difference_3_0 <= 0;
        slice1cost_difference_3_1 <= 0;
        slice1cost_difference_3_2 <= 0;
        slice1cost_pair_0_0 <= 0;
        slice1cost_pair_0_1 <= 0;
        slice1cost_pair_0_2 <= 0;
        slice1cost_negative_0_0 <= false;
        slice1cost_negative_0_1 <= false;
        slice1cost_negative_0_2 <= false;
        slice1cost_single_0_0 <= 0;
        slice1cost_single_0_1 <= 0;
        slice1cost_single_0_2 <= 0;
        slice1cost_single_3_0 <= 0;
        slice1cost_single_3_1 <= 0;
        slice1cost_single_3_2 <= 0;
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
        slice1cost_tag_border_column <= false;
        slice1cost_tag_output_column <= false;
        slice1window_partial_0_0_0 <= 0;
        slice1window_partial_0_0_1 <= 0;
        slice1window_partial_0_0_2 <= 0;
        slice1window_partial_0_1_0 <= 0;
        slice1window_partial_0_1_1 <= 0;
        slice1window_partial_0_1_2 <= 0;
        slice1window_partial_1_0_0 <= 0;
        slice1window_partial_1_0_1 <= 0;
        slice1window_partial_1_0_2 <= 0;
        slice1window_partial_1_1_0 <= 0;
        slice1window_partial_1_1_1 <= 0;
        slice1window_partial_1_1_2 <= 0;
        slice1window_sum_0_0 <= 0;
        slice1window_sum_0_1 <= 0;
        slice1window_sum_0_2 <= 0;
        slice1window_sum_1_0 <= 0;
        slice1window_sum_1_1 <= 0;
        slice1window_sum_1_2 <= 0;
        slice1window_tag_output_column <= false;
        slice1winner1_held_0_0 <= 0;
        slice1winner1_held_0_1 <= 0;
        slice1winner1_held_0_2 <= 0;
        slice1winner1_held_1_0 <= 0;
        slice1winner1_held_1_1 <= 0;
        slice1winner1_held_1_2 <= 0;
        slice1winner1_best_cost_0_0 <= 0;
        slice1winner1_best_cost_1_0 <= 0;
        slice1winner1_best_index_0_0 <= false;
        slice1winner1_best_index_1_0 <= false;
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_below_1_0 <= 0;
        slice1winner1_best_above_0_0 <= 0;
        slice1winner1_best_above_1_0 <= 0;
        slice1winner1_best_late_cost_0_0 <= 0;
        slice1winner1_best_late_cost_0_1 <= 0;
        slice1winner1_best_late_cost_1_0 <= 0;
        slice1winner1_best_late_cost_1_1 <= 0;
        slice1winner1_best_but_first_0_0 <= 1023;
        slice1winner1_best_but_first_1_0 <= 1023;
        slice1winner1_best_but_last_0_0 <= 1023;
        slice1winner1_best_but_last_1_0 <= 1023;
        slice1winner2_best_cost_0_0 <= 0;
        slice1winner2_best_cost_1_0 <= 0;
        slice1winner2_best_index_0_0 <= 0;
        slice1winner2_best_index_1_0 <= 0;
        slice1winner2_best_below_0_0 <= 0;
        slice1winner2_best_below_1_0 <= 0;
        slice1winner2_best_above_0_0 <= 0;
        slice1winner2_best_above_1_0 <= 0;
        slice1winner2_best_first_0_0 <= 0;
        slice1winner2_best_first_1_0 <= 0;
        slice1winner2_best_place_0_0 <= false;
        slice1winner2_best_place_1_0 <= false;
        slice1winner2_best_at_start_0_0 <= false;
        slice1winner2_best_at_start_1_0 <= false;
        slice1winner2_best_at_end_0_0 <= false;
        slice1winner2_best_at_end_1_0 <= false;
        slice1winner2_best_late_cost_0_0 <= 0;
        slice1winner2_best_late_cost_1_0 <= 0;
        slice1winner2_best_second_0_0 <= 1023;
        slice1winner2_best_second_1_0 <= 1023;
        slice1winner2_best_but_first_0_0 <= 1023;
        slice1winner2_best_but_first_1_0 <= 1023;
        slice1winner2_best_but_last_0_0 <= 1023;
        slice1winner2_best_but_last_1_0 <= 1023;
        slice1_best_cost_0_0 <= 0;
        slice1_best_cost_1_0 <= 0;
        slice1_best_index_0_0 <= 0;
        slice1_best_index_1_0 <= 0;
        slice1_best_below_0_0 <= 0;
        slice1_best_below_1_0 <= 0;
        slice1_best_above_0_0 <= 0;
        slice1_best_above_1_0 <= 0;
        slice1_best_last_0_0 <= 0;
        slice1_best_last_1_0 <= 0;
        slice1_best_place_0_0 <= false;
        slice1_best_place_1_0 <= false;
        slice1_best_at_start_0_0 <= false;
        slice1_best_at_start_1_0 <= false;
        slice1_best_at_end_0_0 <= false;
        slice1_best_at_end_1_0 <= false;
        slice1_best_late_cost_0_0 <= 0;
        slice1_best_late_cost_1_0 <= 0;
        slice1_best_second_0_0 <= 1023;
        slice1_best_second_1_0 <= 1023;
        slice1_best_but_last_0_0 <= 1023;
        slice1_best_but_last_1_0 <= 1023;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2shift_search_0_0 <= 0;
        slice2shift_search_0_1 <= 0;
        slice2shift_search_1_0 <= 0;
        slice2shift_search_1_1 <= 0;
        slice2shift_search_2_0 <= 0;
        slice2shift_search_2_1 <= 0;
        slice2shift_search_3_0 <= 0;
        slice2shift_search_3_1 <= 0;
        slice2shift_reference_0 <= 0;
        slice2shift_reference_1 <= 0;
        slice2shift_reference_2 <= 0;
        slice2shift_reference_3 <= 0;
        slice2cost_difference_0_0 <= 0;
        slice2cost_difference_0_1 <= 0;
        slice2cost_difference_1_0 <= 0;
        slice2cost_difference_1_1 <= 0;
        slice2cost_difference_2_0 <= 0;
        slice2cost_difference_2_1 <= 0;
        slice2cost_difference_3_0 <= 0;
        slice2cost_difference_3_1 <= 0;
        slice2cost_pair_0_0 <= 0;
        slice2cost_pair_0_1 <= 0;
        slice2cost_negative_0_0 <= false;
        slice2cost_negative_0_1 <= false;
        slice2cost_single_0_0 <= 0;
        slice2cost_single_0_1 <= 0;
        slice2cost_single_3_0 <= 0;
        slice2cost_single_3_1 <= 0;
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
        slice2cost_tag_output_column <= false;
        slice2window_partial_0_0_0 <= 0;
        slice2window_partial_0_0_1 <= 0;
        slice2window_partial_0_1_0 <= 0;
        slice2window_partial_0_1_1 <= 0;
        slice2window_partial_1_0_0 <= 0;
        slice2window_partial_1_0_1 <= 0;
        slice2window_partial_1_1_0 <= 0;
        slice2window_partial_1_1_1 <= 0;
        slice2window_sum_0_0 <= 0;
        slice2window_sum_0_1 <= 0;
        slice2window_sum_1_0 <= 0;
        slice2window_sum_1_1 <= 0;
        slice2winner1_held_0_0 <= 0;
        slice2winner1_held_0_1 <= 0;
        slice2winner1_held_1_0 <= 0;
        slice2winner1_held_1_1 <= 0;
        slice2winner1_best_cost_0_0 <= 0;
        slice2winner1_best_cost_1_0 <= 0;
        slice2winner1_best_index_0_0 <= false;
        slice2winner1_best_index_1_0 <= false;
        slice2winner1_best_below_0_0 <= 0;
        slice2winner1_best_below_1_0 <= 0;
        slice2winner1_best_above_0_0 <= 0;
        slice2winner1_best_above_1_0 <= 0;
        slice2winner1_best_late_cost_0_0 <= 0;
        slice2winner1_best_late_cost_1_0 <= 0;
        slice2winner1_best_but_first_0_0 <= 1023;
        slice2winner1_best_but_first_1_0 <= 1023;
        slice2winner2_best_index_0_0 <= false;
        slice2winner2_best_index_1_0 <= false;
        slice2winner2_best_below_0_0 <= 0;
        slice2winner2_best_below_1_0 <= 0;
        slice2winner2_best_above_0_0 <= 0;
        slice2winner2_best_above_1_0 <= 0;
        slice2winner2_best_first_0_0 <= 0;
        slice2winner2_best_first_1_0 <= 0;
        slice2winner2_best_late_cost_0_0 <= 0;
        slice2winner2_best_late_cost_1_0 <= 0;
        slice2winner2_best_but_first_0_0 <= 1023;
        slice2winner2_best_but_first_1_0 <= 1023;
        slice2_best_cost_0_0 <= 0;
        slice2_best_cost_1_0 <= 0;
        slice2_best_index_0_0 <= 0;
        slice2_best_index_1_0 <= 0;
        slice2_best_below_0_0 <= 0;
        slice2_best_below_1_0 <= 0;
        slice2_best_above_0_0 <= 0;
        slice2_best_above_1_0 <= 0;
        slice2_best_place_0_0 <= false;
        slice2_best_place_1_0 <= false;
        slice2_best_at_start_0_0 <= false;
        slice2_best_at_start_1_0 <= false;
        slice2_best_at_end_0_0 <= false;
        slice2_best_at_end_1_0 <= false;
        slice2_best_late_cost_0_0 <= 0;
        slice2_best_late_cost_1_0 <= 0;
        slice2_best_second_0_0 <= 1023;
        slice2_best_second_1_0 <= 1023;
        slice2_best_tag_valid <= false;
        slice2_best_tag_map_column <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        texture_taps_search_0_0 <= 0;
        texture_taps_search_1_0 <= 0;
        texture_taps_search_3_0 <= 0;
        texturecost_difference_0_0 <= 0;
        texturecost_difference_1_0 <= 0;
        texturecost_difference_2_0 <= 0;
        texturecost_difference_3_0 <= 0;
        texturecost_pair_0_0 <= 0;
        texturecost_negative_0_0 <= false;
        texturecost_single_0_0 <= 0;
        texturecost_single_3_0 <= 0;
        texturecost_column_0_0 <= 0;
        texturecost_column_1_0 <= 0;
        texturewindow_partial_0_0_0 <= 0;
        texturewindow_partial_0_1_0 <= 0;
        texturewindow_partial_1_0_0 <= 0;
        texturewindow_partial_1_1_0 <= 0;
        texturewindow_sum_0_0 <= 0;
        texturewindow_sum_1_0 <= 0;
        texture_passes_0_0 <= false;
        texture_passes_0_1 <= false;
        texture_passes_1_0 <= false;
        texture_passes_1_1 <= false;
        texture_passes_2_0 <= false;
        texture_passes_2_1 <= false;
        texture_passes_3_0 <= false;
        texture_passes_3_1 <= false;
        texture_passes_4_0 <= false;
        texture_passes_4_1 <= false;
        refinement_disparity_0_0 <= 0;
        refinement_disparity_0_1 <= 0;
        refinement_disparity_1_0 <= 0;
        refinement_disparity_1_1 <= 0;
        refinement_disparity_2_0 <= 0;
        refinement_disparity_2_1 <= 0;
        refinement_disparity_3_0 <= 0;
        refinement_disparity_3_1 <= 0;
        refinement_disparity_4_0 <= 0;
        refinement_disparity_4_1 <= 0;
        refinement_disparity_5_0 <= 0;
        refinement_disparity_5_1 <= 0;
        refinement_disparity_6_0 <= 0;
        refinement_disparity_6_1 <= 0;
        refinement_disparity_7_0 <= 0;
        refinement_disparity_7_1 <= 0;
        refinement_disparity_8_0 <= 0;
        refinement_disparity_8_1 <= 0;
        refinement_disparity_9_0 <= 0;
        refinement_disparity_9_1 <= 0;
        refinement_disparity_10_0 <= 0;
        refinement_disparity_10_1 <= 0;
        refinement_disparity_11_0 <= 0;
        refinement_disparity_11_1 <= 0;
        refinement_passed_0_0 <= false;
        refinement_passed_0_1 <= false;
        refinement_passed_1_0 <= false;
        refinement_passed_1_1 <= false;
        refinement_passed_2_0 <= false;
        refinement_passed_2_1 <= false;
        refinement_passed_3_0 <= false;
        refinement_passed_3_1 <= false;
        refinement_passed_4_0 <= false;
        refinement_passed_4_1 <= false;
        refinement_passed_5_0 <= false;
        refinement_passed_5_1 <= false;
        refinement_passed_6_0 <= false;
        refinement_passed_6_1 <= false;
        refinement_passed_7_0 <= false;
        refinement_passed_7_1 <= false;
        refinement_passed_8_0 <= false;
        refinement_passed_8_1 <= false;
        refinement_passed_9_0 <= false;
        refinement_passed_9_1 <= false;
        refinement_passed_10_0 <= false;
        refinement_passed_10_1 <= false;
        refinement_passed_11_0 <= false;
        refinement_passed_11_1 <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_output_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_output_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_output_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_output_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_output_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_output_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_output_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_output_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_output_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_output_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_map_column <= false;
        refinement_tag_10_output_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_map_column <= false;
        refinement_tag_11_output_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        refinement_alone_0_0 <= false;
        refinement_alone_0_1 <= false;
        refinement_alone_1_0 <= false;
        refinement_alone_1_1 <= false;
        refinement_gap_0 <= 0;
        refinement_gap_1 <= 0;
        refinement_lowest_0 <= 0;
        refinement_lowest_1 <= 0;
        refinement_scaled_gap_0 <= 0;
        refinement_scaled_gap_1 <= 0;
        refinement_scaled_cost_0 <= 0;
        refinement_scaled_cost_1 <= 0;
        refinement_below_0 <= 0;
        refinement_below_1 <= 0;
        refinement_above_0 <= 0;
        refinement_above_1 <= 0;
        refinement_u_0 <= 0;
        refinement_u_1 <= 0;
        refinement_v_0 <= 0;
        refinement_v_1 <= 0;
        refinement_difference_0 <= 0;
        refinement_difference_1 <= 0;
        refinement_remainder_0_0 <= 0;
        refinement_remainder_0_1 <= 0;
        refinement_remainder_1_0 <= 0;
        refinement_remainder_1_1 <= 0;
        refinement_remainder_2_0 <= 0;
        refinement_remainder_2_1 <= 0;
        refinement_remainder_3_0 <= 0;
        refinement_remainder_3_1 <= 0;
        refinement_remainder_4_0 <= 0;
        refinement_remainder_4_1 <= 0;
        refinement_remainder_5_0 <= 0;
        refinement_remainder_5_1 <= 0;
        refinement_remainder_6_0 <= 0;
        refinement_remainder_6_1 <= 0;
        refinement_remainder_7_0 <= 0;
        refinement_remainder_7_1 <= 0;
        refinement_divisor_0_0 <= 1;
        refinement_divisor_0_1 <= 1;
        refinement_divisor_1_0 <= 1;
        refinement_divisor_1_1 <= 1;
        refinement_divisor_2_0 <= 1;
        refinement_divisor_2_1 <= 1;
        refinement_divisor_3_0 <= 1;
        refinement_divisor_3_1 <= 1;
        refinement_divisor_4_0 <= 1;
        refinement_divisor_4_1 <= 1;
        refinement_divisor_5_0 <= 1;
        refinement_divisor_5_1 <= 1;
        refinement_divisor_6_0 <= 1;
        refinement_divisor_6_1 <= 1;
        refinement_divisor_7_0 <= 1;
        refinement_divisor_7_1 <= 1;
        refinement_quotient_8_0 <= 0;
        refinement_quotient_8_1 <= 0;
        refinement_negative_0_0 <= false;
        refinement_negative_0_1 <= false;
        refinement_negative_1_0 <= false;
        refinement_negative_1_1 <= false;
        refinement_negative_2_0 <= false;
        refinement_negative_2_1 <= false;
        refinement_negative_3_0 <= false;
        refinement_negative_3_1 <= false;
        refinement_negative_4_0 <= false;
        refinement_negative_4_1 <= false;
        refinement_negative_5_0 <= false;
        refinement_negative_5_1 <= false;
        refinement_negative_6_0 <= false;
        refinement_negative_6_1 <= false;
        refinement_negative_7_0 <= false;
        refinement_negative_7_1 <= false;
        refinement_negative_8_0 <= false;
        refinement_negative_8_1 <= false;
        refinement_fraction_0 <= 8;
        refinement_fraction_1 <= 8;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_valid <= false;
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
        map_counter_group <= 7;
        map_counter_next_frame <= false;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
        map_at_arrives <= false;
        map_at_behind <= false;
        map_at_top <= false;
        map_at_output <= false;
        map_comparing_column <= 0;
        map_comparing_arrives <= false;
        map_comparing_behind <= false;
        map_comparing_top <= false;
        map_comparing_output <= false;
        map_sorted_column <= 0;
        map_sorted_arrives <= false;
        map_sorted_behind <= false;
        map_sorted_top <= false;
        map_sorted_output <= false;
        map_window_complete <= false;
        map_window_first <= false;
        map_window_last <= false;
        map_waiting_0_complete <= false;
        map_waiting_0_first <= false;
        map_waiting_0_last <= false;
        map_waiting_1_complete <= false;
        map_waiting_1_first <= false;
        map_waiting_1_last <= false;
        map_waiting_2_complete <= false;
        map_waiting_2_first <= false;
        map_waiting_2_last <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_0 <= to_unsigned(0, 49);
        other_2 <= to_unsigned(0, 49);
        other_3 <= 0;
        other_4 <= 0;
        other_5 <= 0;
        other_6 <= 0;
        other_7 <= 0;
        other_8 <= 0;
        other_9 <= 0;
        other_10 <= 0;
        other_11 <= 0;
        other_12 <= 0;
        other_13 <= 0;
        other_14 <= 0;
        other_15 <= 0;
        other_16 <= 0;
      end if;
    end if;
  end process;
end architecture;
