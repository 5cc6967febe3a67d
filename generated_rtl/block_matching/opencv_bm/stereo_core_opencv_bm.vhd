-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration opencv_bm: 450x375, 64 disparities, window 15x15, 1 pixel pair a clock.
-- Options: window_px 15, reference left, prefilter xsobel, ties largest, uniqueness_percent 15,
--   texture_threshold 10, subpixel true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config opencv_bm
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_opencv_bm is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 386;
    latency_clocks : positive := 41;
    flush_groups : positive := 3608;
    gap_groups : positive := 3150
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
  assert width_px = 450 report "stereo_core_opencv_bm: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_opencv_bm: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 64 report "stereo_core_opencv_bm: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_opencv_bm: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_opencv_bm: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 386 report "stereo_core_opencv_bm: output_width_px is " & integer'image(output_width_px) & " but this core has 386" severity failure;
  assert latency_clocks = 41 report "stereo_core_opencv_bm: latency_clocks is " & integer'image(latency_clocks) & " but this core has 41" severity failure;
  assert flush_groups = 3608 report "stereo_core_opencv_bm: flush_groups is " & integer'image(flush_groups) & " but this core has 3608" severity failure;
  assert gap_groups = 3150 report "stereo_core_opencv_bm: gap_groups is " & integer'image(gap_groups) & " but this core has 3150" severity failure;
end entity;

architecture rtl of stereo_core_opencv_bm is
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
  signal transform_columns_start_of_frame, transform_columns_valid, transform_left_filter_whole : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_start_of_frame, transform_filtering_0_valid : boolean;
  signal transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_filtering_2_start_of_frame, transform_filtering_2_valid : boolean;
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 65535;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_column_0_0, transform_left_filter_column_1_0 : natural range 0 to 1020;
  signal transform_left_filter_column_2_0, transform_right_filter_column_0_0 : natural range 0 to 1020;
  signal transform_right_filter_column_1_0, transform_right_filter_column_2_0 : natural range 0 to 1020;
  signal transform_left_filter_slope_0, transform_right_filter_slope_0 : integer range -1020 to 1020;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 127;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 127;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 127;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_border_column, delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(27 downto 0);
  signal rows_search_rows_read_words_2, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_1, rows_reference_rows_read_words_2 : unsigned(27 downto 0);
  signal rows_search_rows_read_words_3, rows_reference_rows_read_words_3 : unsigned(20 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 127;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 127;
  signal rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 127;
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : natural range 0 to 268435455;
  signal rows_search_rows_ready_words_2, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_search_rows_write_words_1, rows_search_rows_write_words_2 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_2, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_write_words_1, rows_reference_rows_write_words_2 : natural range 0 to 268435455;
  signal rows_search_rows_ready_words_3, rows_search_rows_write_words_3 : natural range 0 to 2097151;
  signal rows_reference_rows_ready_words_3, rows_reference_rows_write_words_3 : natural range 0 to 2097151;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_row_start : boolean;
  signal rows_read_tag_first_group, rows_read_tag_border_column, rows_read_tag_first_cost : boolean;
  signal rows_read_tag_leaves_window, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_row_start, rows_ready_tag_first_group, rows_ready_tag_border_column : boolean;
  signal rows_ready_tag_first_cost, rows_ready_tag_leaves_window, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_inside_0, rows_inside_1 : boolean;
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_border_column : boolean;
  signal rows_tag_first_cost, rows_tag_leaves_window, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 127;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 127;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_0_8 : natural range 0 to 127;
  signal slice0shift_search_0_9, slice0shift_search_0_10, slice0shift_search_0_11 : natural range 0 to 127;
  signal slice0shift_search_0_12, slice0shift_search_0_13, slice0shift_search_0_14 : natural range 0 to 127;
  signal slice0shift_search_0_15, slice0shift_search_1_0, slice0shift_search_1_1 : natural range 0 to 127;
  signal slice0shift_search_1_2, slice0shift_search_1_3, slice0shift_search_1_4 : natural range 0 to 127;
  signal slice0shift_search_1_5, slice0shift_search_1_6, slice0shift_search_1_7 : natural range 0 to 127;
  signal slice0shift_search_1_8, slice0shift_search_1_9, slice0shift_search_1_10 : natural range 0 to 127;
  signal slice0shift_search_1_11, slice0shift_search_1_12, slice0shift_search_1_13 : natural range 0 to 127;
  signal slice0shift_search_1_14, slice0shift_search_1_15, slice0shift_reference_0 : natural range 0 to 127;
  signal slice0shift_reference_1, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 127;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_2, slice0cost_pixels_first_0_3 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_6, slice0cost_pixels_first_0_7 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_8, slice0cost_pixels_first_0_9 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_10, slice0cost_pixels_first_0_11 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_12, slice0cost_pixels_first_0_13 : integer range -127 to 127;
  signal slice0cost_pixels_first_0_14, slice0cost_pixels_first_0_15 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_0, slice0cost_pixels_first_1_1 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_2, slice0cost_pixels_first_1_3 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_4, slice0cost_pixels_first_1_5 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_6, slice0cost_pixels_first_1_7 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_8, slice0cost_pixels_first_1_9 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_10, slice0cost_pixels_first_1_11 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_12, slice0cost_pixels_first_1_13 : integer range -127 to 127;
  signal slice0cost_pixels_first_1_14, slice0cost_pixels_first_1_15 : integer range -127 to 127;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_row_start, slice0cost_ready_tag_first_group, slice0cost_ready_tag_border_column : boolean;
  signal slice0cost_ready_tag_first_cost, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_output_column, slice0cost_ready_tag_start_of_frame : boolean;
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_first_group : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_first_cost, slice0cost_tag_leaves_window : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 128;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 128;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_0_8 : natural range 0 to 128;
  signal slice0cost_pixels_cost_0_9, slice0cost_pixels_cost_0_10, slice0cost_pixels_cost_0_11 : natural range 0 to 128;
  signal slice0cost_pixels_cost_0_12, slice0cost_pixels_cost_0_13, slice0cost_pixels_cost_0_14 : natural range 0 to 128;
  signal slice0cost_pixels_cost_0_15, slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1 : natural range 0 to 128;
  signal slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4 : natural range 0 to 128;
  signal slice0cost_pixels_cost_1_5, slice0cost_pixels_cost_1_6, slice0cost_pixels_cost_1_7 : natural range 0 to 128;
  signal slice0cost_pixels_cost_1_8, slice0cost_pixels_cost_1_9, slice0cost_pixels_cost_1_10 : natural range 0 to 128;
  signal slice0cost_pixels_cost_1_11, slice0cost_pixels_cost_1_12, slice0cost_pixels_cost_1_13 : natural range 0 to 128;
  signal slice0cost_pixels_cost_1_14, slice0cost_pixels_cost_1_15 : natural range 0 to 128;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(29 downto 0);
  signal slice0cost_read_words_3, slice0cost_read_words_4 : unsigned(29 downto 0);
  signal slice0cost_read_words_5 : unsigned(9 downto 0);
  signal slice0cost_change_0_0, slice0cost_change_0_1, slice0cost_change_0_2 : integer range -128 to 128;
  signal slice0cost_change_0_3, slice0cost_change_0_4, slice0cost_change_0_5 : integer range -128 to 128;
  signal slice0cost_change_0_6, slice0cost_change_0_7, slice0cost_change_0_8 : integer range -128 to 128;
  signal slice0cost_change_0_9, slice0cost_change_0_10, slice0cost_change_0_11 : integer range -128 to 128;
  signal slice0cost_change_0_12, slice0cost_change_0_13, slice0cost_change_0_14 : integer range -128 to 128;
  signal slice0cost_change_0_15 : integer range -128 to 128;
  signal slice0cost_ready_words_0, slice0cost_ready_words_1, slice0cost_ready_words_2 : natural range 0 to 1073741823;
  signal slice0cost_ready_words_3, slice0cost_ready_words_4, slice0cost_write_words_0 : natural range 0 to 1073741823;
  signal slice0cost_write_words_1, slice0cost_write_words_2, slice0cost_write_words_3 : natural range 0 to 1073741823;
  signal slice0cost_write_words_4 : natural range 0 to 1073741823;
  signal slice0cost_ready_words_5, slice0cost_column_0_0, slice0cost_column_0_1 : natural range 0 to 1023;
  signal slice0cost_column_0_2, slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 1023;
  signal slice0cost_column_0_5, slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 1023;
  signal slice0cost_column_0_8, slice0cost_column_0_9, slice0cost_column_0_10 : natural range 0 to 1023;
  signal slice0cost_column_0_11, slice0cost_column_0_12, slice0cost_column_0_13 : natural range 0 to 1023;
  signal slice0cost_column_0_14, slice0cost_column_0_15, slice0cost_write_words_5 : natural range 0 to 1023;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(29 downto 0);
  signal slice0window_leaving_3, slice0window_leaving_4 : unsigned(29 downto 0);
  signal slice0window_leaving_5 : unsigned(9 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 1023;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 1023;
  signal slice0window_entering_0_6, slice0window_entering_0_7, slice0window_entering_0_8 : natural range 0 to 1023;
  signal slice0window_entering_0_9, slice0window_entering_0_10, slice0window_entering_0_11 : natural range 0 to 1023;
  signal slice0window_entering_0_12, slice0window_entering_0_13, slice0window_entering_0_14 : natural range 0 to 1023;
  signal slice0window_entering_0_15 : natural range 0 to 1023;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_group : boolean;
  signal slice0window_entering_tag_border_column, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_group : boolean;
  signal slice0window_change_tag_border_column, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_start_of_frame_1, slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -1023 to 1023;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -1023 to 1023;
  signal slice0window_change_0_6, slice0window_change_0_7, slice0window_change_0_8 : integer range -1023 to 1023;
  signal slice0window_change_0_9, slice0window_change_0_10, slice0window_change_0_11 : integer range -1023 to 1023;
  signal slice0window_change_0_12, slice0window_change_0_13, slice0window_change_0_14 : integer range -1023 to 1023;
  signal slice0window_change_0_15 : integer range -1023 to 1023;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 16383;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 16383;
  signal slice0window_sum_0_6, slice0window_sum_0_7, slice0window_sum_0_8 : natural range 0 to 16383;
  signal slice0window_sum_0_9, slice0window_sum_0_10, slice0window_sum_0_11 : natural range 0 to 16383;
  signal slice0window_sum_0_12, slice0window_sum_0_13, slice0window_sum_0_14 : natural range 0 to 16383;
  signal slice0window_sum_0_15 : natural range 0 to 16383;
  -- slice0winner1
  signal slice0winner1_held_0_0, slice0winner1_held_0_1, slice0winner1_held_0_2 : natural range 0 to 16383;
  signal slice0winner1_held_0_3, slice0winner1_held_0_4, slice0winner1_held_0_5 : natural range 0 to 16383;
  signal slice0winner1_held_0_6, slice0winner1_held_0_7, slice0winner1_held_0_8 : natural range 0 to 16383;
  signal slice0winner1_held_0_9, slice0winner1_held_0_10, slice0winner1_held_0_11 : natural range 0 to 16383;
  signal slice0winner1_held_0_12, slice0winner1_held_0_13, slice0winner1_held_0_14 : natural range 0 to 16383;
  signal slice0winner1_held_0_15, slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_4, slice0winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_6, slice0winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 16383;
  signal slice0winner1_best_below_0_2, slice0winner1_best_below_0_3 : natural range 0 to 16383;
  signal slice0winner1_best_below_0_4, slice0winner1_best_below_0_5 : natural range 0 to 16383;
  signal slice0winner1_best_below_0_6, slice0winner1_best_below_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_above_0_0, slice0winner1_best_above_0_1 : natural range 0 to 16383;
  signal slice0winner1_best_above_0_2, slice0winner1_best_above_0_3 : natural range 0 to 16383;
  signal slice0winner1_best_above_0_4, slice0winner1_best_above_0_5 : natural range 0 to 16383;
  signal slice0winner1_best_above_0_6, slice0winner1_best_above_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_late_cost_0_0, slice0winner1_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice0winner1_best_late_cost_0_2, slice0winner1_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice0winner1_best_late_cost_0_4, slice0winner1_best_late_cost_0_5 : natural range 0 to 16383;
  signal slice0winner1_best_late_cost_0_6, slice0winner1_best_late_cost_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_but_first_0_1, slice0winner1_best_but_first_0_2 : natural range 0 to 16383;
  signal slice0winner1_best_but_first_0_3, slice0winner1_best_but_first_0_4 : natural range 0 to 16383;
  signal slice0winner1_best_but_first_0_5, slice0winner1_best_but_first_0_6 : natural range 0 to 16383;
  signal slice0winner1_best_but_first_0_7, slice0winner1_best_but_last_0_0 : natural range 0 to 16383;
  signal slice0winner1_best_but_last_0_1, slice0winner1_best_but_last_0_2 : natural range 0 to 16383;
  signal slice0winner1_best_but_last_0_3, slice0winner1_best_but_last_0_4 : natural range 0 to 16383;
  signal slice0winner1_best_but_last_0_5, slice0winner1_best_but_last_0_6 : natural range 0 to 16383;
  signal slice0winner1_best_but_last_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_cost_0_2, slice0winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_below_0_2, slice0winner2_best_below_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_above_0_2, slice0winner2_best_above_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_first_0_1, slice0winner2_best_first_0_2 : natural range 0 to 16383;
  signal slice0winner2_best_first_0_3, slice0winner2_best_last_0_0 : natural range 0 to 16383;
  signal slice0winner2_best_last_0_1, slice0winner2_best_last_0_2 : natural range 0 to 16383;
  signal slice0winner2_best_last_0_3, slice0winner2_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice0winner2_best_late_cost_0_1, slice0winner2_best_late_cost_0_2 : natural range 0 to 16383;
  signal slice0winner2_best_late_cost_0_3, slice0winner2_best_second_0_0 : natural range 0 to 16383;
  signal slice0winner2_best_second_0_1, slice0winner2_best_second_0_2 : natural range 0 to 16383;
  signal slice0winner2_best_second_0_3, slice0winner2_best_but_first_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_but_first_0_2, slice0winner2_best_but_first_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_but_last_0_0, slice0winner2_best_but_last_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_but_last_0_2, slice0winner2_best_but_last_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_best_place_0_0, slice0winner2_best_place_0_1, slice0winner2_best_place_0_2 : boolean;
  signal slice0winner2_best_place_0_3, slice0winner2_best_at_start_0_0, slice0winner2_best_at_start_0_1 : boolean;
  signal slice0winner2_best_at_start_0_2, slice0winner2_best_at_start_0_3, slice0winner2_best_at_end_0_0 : boolean;
  signal slice0winner2_best_at_end_0_1, slice0winner2_best_at_end_0_2, slice0winner2_best_at_end_0_3 : boolean;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_below_0_0, slice0winner3_best_below_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_above_0_0, slice0winner3_best_above_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_first_0_1, slice0winner3_best_last_0_0 : natural range 0 to 16383;
  signal slice0winner3_best_last_0_1, slice0winner3_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice0winner3_best_late_cost_0_1, slice0winner3_best_second_0_0 : natural range 0 to 16383;
  signal slice0winner3_best_second_0_1, slice0winner3_best_but_first_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_but_last_0_0, slice0winner3_best_but_last_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_place_0_0, slice0winner3_best_place_0_1, slice0winner3_best_at_start_0_0 : boolean;
  signal slice0winner3_best_at_start_0_1, slice0winner3_best_at_end_0_0, slice0winner3_best_at_end_0_1 : boolean;
  signal slice0winner3_tag_valid, slice0winner3_tag_output_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0 : natural range 0 to 16383;
  signal slice0winner4_best_above_0_0, slice0winner4_best_last_0_0 : natural range 0 to 16383;
  signal slice0winner4_best_late_cost_0_0, slice0winner4_best_second_0_0 : natural range 0 to 16383;
  signal slice0winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_place_0_0, slice0winner4_best_at_start_0_0, slice0winner4_best_at_end_0_0 : boolean;
  signal slice0winner4_tag_valid, slice0winner4_tag_output_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0 : natural range 0 to 16383;
  signal slice0_best_late_cost_0_0, slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 16383;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 127;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 127;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_0_8 : natural range 0 to 127;
  signal slice1shift_search_0_9, slice1shift_search_0_10, slice1shift_search_0_11 : natural range 0 to 127;
  signal slice1shift_search_0_12, slice1shift_search_0_13, slice1shift_search_0_14 : natural range 0 to 127;
  signal slice1shift_search_0_15, slice1shift_search_1_0, slice1shift_search_1_1 : natural range 0 to 127;
  signal slice1shift_search_1_2, slice1shift_search_1_3, slice1shift_search_1_4 : natural range 0 to 127;
  signal slice1shift_search_1_5, slice1shift_search_1_6, slice1shift_search_1_7 : natural range 0 to 127;
  signal slice1shift_search_1_8, slice1shift_search_1_9, slice1shift_search_1_10 : natural range 0 to 127;
  signal slice1shift_search_1_11, slice1shift_search_1_12, slice1shift_search_1_13 : natural range 0 to 127;
  signal slice1shift_search_1_14, slice1shift_search_1_15, slice1shift_reference_0 : natural range 0 to 127;
  signal slice1shift_reference_1, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 127;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_2, slice1cost_pixels_first_0_3 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_6, slice1cost_pixels_first_0_7 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_8, slice1cost_pixels_first_0_9 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_10, slice1cost_pixels_first_0_11 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_12, slice1cost_pixels_first_0_13 : integer range -127 to 127;
  signal slice1cost_pixels_first_0_14, slice1cost_pixels_first_0_15 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_0, slice1cost_pixels_first_1_1 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_2, slice1cost_pixels_first_1_3 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_4, slice1cost_pixels_first_1_5 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_6, slice1cost_pixels_first_1_7 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_8, slice1cost_pixels_first_1_9 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_10, slice1cost_pixels_first_1_11 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_12, slice1cost_pixels_first_1_13 : integer range -127 to 127;
  signal slice1cost_pixels_first_1_14, slice1cost_pixels_first_1_15 : integer range -127 to 127;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 128;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 128;
  signal slice1cost_pixels_cost_0_6, slice1cost_pixels_cost_0_7, slice1cost_pixels_cost_0_8 : natural range 0 to 128;
  signal slice1cost_pixels_cost_0_9, slice1cost_pixels_cost_0_10, slice1cost_pixels_cost_0_11 : natural range 0 to 128;
  signal slice1cost_pixels_cost_0_12, slice1cost_pixels_cost_0_13, slice1cost_pixels_cost_0_14 : natural range 0 to 128;
  signal slice1cost_pixels_cost_0_15, slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1 : natural range 0 to 128;
  signal slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4 : natural range 0 to 128;
  signal slice1cost_pixels_cost_1_5, slice1cost_pixels_cost_1_6, slice1cost_pixels_cost_1_7 : natural range 0 to 128;
  signal slice1cost_pixels_cost_1_8, slice1cost_pixels_cost_1_9, slice1cost_pixels_cost_1_10 : natural range 0 to 128;
  signal slice1cost_pixels_cost_1_11, slice1cost_pixels_cost_1_12, slice1cost_pixels_cost_1_13 : natural range 0 to 128;
  signal slice1cost_pixels_cost_1_14, slice1cost_pixels_cost_1_15 : natural range 0 to 128;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words_0, slice1cost_read_words_1, slice1cost_read_words_2 : unsigned(29 downto 0);
  signal slice1cost_read_words_3, slice1cost_read_words_4 : unsigned(29 downto 0);
  signal slice1cost_read_words_5 : unsigned(9 downto 0);
  signal slice1cost_change_0_0, slice1cost_change_0_1, slice1cost_change_0_2 : integer range -128 to 128;
  signal slice1cost_change_0_3, slice1cost_change_0_4, slice1cost_change_0_5 : integer range -128 to 128;
  signal slice1cost_change_0_6, slice1cost_change_0_7, slice1cost_change_0_8 : integer range -128 to 128;
  signal slice1cost_change_0_9, slice1cost_change_0_10, slice1cost_change_0_11 : integer range -128 to 128;
  signal slice1cost_change_0_12, slice1cost_change_0_13, slice1cost_change_0_14 : integer range -128 to 128;
  signal slice1cost_change_0_15 : integer range -128 to 128;
  signal slice1cost_ready_words_0, slice1cost_ready_words_1, slice1cost_ready_words_2 : natural range 0 to 1073741823;
  signal slice1cost_ready_words_3, slice1cost_ready_words_4, slice1cost_write_words_0 : natural range 0 to 1073741823;
  signal slice1cost_write_words_1, slice1cost_write_words_2, slice1cost_write_words_3 : natural range 0 to 1073741823;
  signal slice1cost_write_words_4 : natural range 0 to 1073741823;
  signal slice1cost_ready_words_5, slice1cost_column_0_0, slice1cost_column_0_1 : natural range 0 to 1023;
  signal slice1cost_column_0_2, slice1cost_column_0_3, slice1cost_column_0_4 : natural range 0 to 1023;
  signal slice1cost_column_0_5, slice1cost_column_0_6, slice1cost_column_0_7 : natural range 0 to 1023;
  signal slice1cost_column_0_8, slice1cost_column_0_9, slice1cost_column_0_10 : natural range 0 to 1023;
  signal slice1cost_column_0_11, slice1cost_column_0_12, slice1cost_column_0_13 : natural range 0 to 1023;
  signal slice1cost_column_0_14, slice1cost_column_0_15, slice1cost_write_words_5 : natural range 0 to 1023;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(29 downto 0);
  signal slice1window_leaving_3, slice1window_leaving_4 : unsigned(29 downto 0);
  signal slice1window_leaving_5 : unsigned(9 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 1023;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 1023;
  signal slice1window_entering_0_6, slice1window_entering_0_7, slice1window_entering_0_8 : natural range 0 to 1023;
  signal slice1window_entering_0_9, slice1window_entering_0_10, slice1window_entering_0_11 : natural range 0 to 1023;
  signal slice1window_entering_0_12, slice1window_entering_0_13, slice1window_entering_0_14 : natural range 0 to 1023;
  signal slice1window_entering_0_15 : natural range 0 to 1023;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -1023 to 1023;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -1023 to 1023;
  signal slice1window_change_0_6, slice1window_change_0_7, slice1window_change_0_8 : integer range -1023 to 1023;
  signal slice1window_change_0_9, slice1window_change_0_10, slice1window_change_0_11 : integer range -1023 to 1023;
  signal slice1window_change_0_12, slice1window_change_0_13, slice1window_change_0_14 : integer range -1023 to 1023;
  signal slice1window_change_0_15 : integer range -1023 to 1023;
  signal slice1window_change_tag_first_cost, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_centre_output_column_0, slice1window_centre_start_of_frame_1 : boolean;
  signal slice1window_centre_start_of_frame_3, slice1window_centre_start_of_frame_4 : boolean;
  signal slice1window_centre_start_of_frame_5, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 16383;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 16383;
  signal slice1window_sum_0_6, slice1window_sum_0_7, slice1window_sum_0_8 : natural range 0 to 16383;
  signal slice1window_sum_0_9, slice1window_sum_0_10, slice1window_sum_0_11 : natural range 0 to 16383;
  signal slice1window_sum_0_12, slice1window_sum_0_13, slice1window_sum_0_14 : natural range 0 to 16383;
  signal slice1window_sum_0_15 : natural range 0 to 16383;
  -- slice1winner1
  signal slice1winner1_held_0_0, slice1winner1_held_0_1, slice1winner1_held_0_2 : natural range 0 to 16383;
  signal slice1winner1_held_0_3, slice1winner1_held_0_4, slice1winner1_held_0_5 : natural range 0 to 16383;
  signal slice1winner1_held_0_6, slice1winner1_held_0_7, slice1winner1_held_0_8 : natural range 0 to 16383;
  signal slice1winner1_held_0_9, slice1winner1_held_0_10, slice1winner1_held_0_11 : natural range 0 to 16383;
  signal slice1winner1_held_0_12, slice1winner1_held_0_13, slice1winner1_held_0_14 : natural range 0 to 16383;
  signal slice1winner1_held_0_15, slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_2, slice1winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_4, slice1winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_6, slice1winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_below_0_2, slice1winner1_best_below_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_below_0_4, slice1winner1_best_below_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_below_0_6, slice1winner1_best_below_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_above_0_2, slice1winner1_best_above_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_above_0_4, slice1winner1_best_above_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_above_0_6, slice1winner1_best_above_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_late_cost_0_0, slice1winner1_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_late_cost_0_2, slice1winner1_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_late_cost_0_4, slice1winner1_best_late_cost_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_late_cost_0_6, slice1winner1_best_late_cost_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_but_first_0_0, slice1winner1_best_but_first_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_but_first_0_2, slice1winner1_best_but_first_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_but_first_0_4, slice1winner1_best_but_first_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_but_first_0_6, slice1winner1_best_but_first_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_but_last_0_0, slice1winner1_best_but_last_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_but_last_0_2, slice1winner1_best_but_last_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_but_last_0_4, slice1winner1_best_but_last_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_but_last_0_6, slice1winner1_best_but_last_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_cost_0_2, slice1winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_below_0_0, slice1winner2_best_below_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_below_0_2, slice1winner2_best_below_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_above_0_2, slice1winner2_best_above_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_first_0_0, slice1winner2_best_first_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_first_0_2, slice1winner2_best_first_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_last_0_0, slice1winner2_best_last_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_last_0_2, slice1winner2_best_last_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_late_cost_0_0, slice1winner2_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_late_cost_0_2, slice1winner2_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_second_0_0, slice1winner2_best_second_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_second_0_2, slice1winner2_best_second_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_but_first_0_0, slice1winner2_best_but_first_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_but_first_0_2, slice1winner2_best_but_first_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_but_last_0_0, slice1winner2_best_but_last_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_but_last_0_2, slice1winner2_best_but_last_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  signal slice1winner2_best_place_0_0, slice1winner2_best_place_0_1, slice1winner2_best_place_0_2 : boolean;
  signal slice1winner2_best_place_0_3, slice1winner2_best_at_start_0_0, slice1winner2_best_at_start_0_1 : boolean;
  signal slice1winner2_best_at_start_0_2, slice1winner2_best_at_start_0_3, slice1winner2_best_at_end_0_0 : boolean;
  signal slice1winner2_best_at_end_0_1, slice1winner2_best_at_end_0_2, slice1winner2_best_at_end_0_3 : boolean;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_below_0_0, slice1winner3_best_below_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_above_0_0, slice1winner3_best_above_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_first_0_0, slice1winner3_best_first_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_last_0_0, slice1winner3_best_last_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_late_cost_0_0, slice1winner3_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_second_0_0, slice1winner3_best_second_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_but_first_0_0, slice1winner3_best_but_first_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_but_last_0_0, slice1winner3_best_but_last_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  signal slice1winner3_best_place_0_0, slice1winner3_best_place_0_1, slice1winner3_best_at_start_0_0 : boolean;
  signal slice1winner3_best_at_start_0_1, slice1winner3_best_at_end_0_0, slice1winner3_best_at_end_0_1 : boolean;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_above_0_0, slice1winner4_best_first_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_last_0_0, slice1winner4_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_second_0_0, slice1winner4_best_but_first_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_place_0_0, slice1winner4_best_at_start_0_0, slice1winner4_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 16383;
  signal slice1_best_last_0_0, slice1_best_late_cost_0_0, slice1_best_second_0_0 : natural range 0 to 16383;
  signal slice1_best_but_last_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0, slice1_best_tag_valid : boolean;
  signal slice1_best_tag_output_column, slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_0_2 : natural range 0 to 127;
  signal slice2shift_search_0_3, slice2shift_search_0_4, slice2shift_search_0_5 : natural range 0 to 127;
  signal slice2shift_search_0_6, slice2shift_search_0_7, slice2shift_search_0_8 : natural range 0 to 127;
  signal slice2shift_search_0_9, slice2shift_search_0_10, slice2shift_search_0_11 : natural range 0 to 127;
  signal slice2shift_search_0_12, slice2shift_search_0_13, slice2shift_search_0_14 : natural range 0 to 127;
  signal slice2shift_search_0_15, slice2shift_search_1_0, slice2shift_search_1_1 : natural range 0 to 127;
  signal slice2shift_search_1_2, slice2shift_search_1_3, slice2shift_search_1_4 : natural range 0 to 127;
  signal slice2shift_search_1_5, slice2shift_search_1_6, slice2shift_search_1_7 : natural range 0 to 127;
  signal slice2shift_search_1_8, slice2shift_search_1_9, slice2shift_search_1_10 : natural range 0 to 127;
  signal slice2shift_search_1_11, slice2shift_search_1_12, slice2shift_search_1_13 : natural range 0 to 127;
  signal slice2shift_search_1_14, slice2shift_search_1_15, slice2shift_reference_0 : natural range 0 to 127;
  signal slice2shift_reference_1, slice2shift_search_out_0, slice2shift_search_out_1 : natural range 0 to 127;
  -- slice2cost
  signal slice2cost_pixels_first_0_0, slice2cost_pixels_first_0_1 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_2, slice2cost_pixels_first_0_3 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_4, slice2cost_pixels_first_0_5 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_6, slice2cost_pixels_first_0_7 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_8, slice2cost_pixels_first_0_9 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_10, slice2cost_pixels_first_0_11 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_12, slice2cost_pixels_first_0_13 : integer range -127 to 127;
  signal slice2cost_pixels_first_0_14, slice2cost_pixels_first_0_15 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_0, slice2cost_pixels_first_1_1 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_2, slice2cost_pixels_first_1_3 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_4, slice2cost_pixels_first_1_5 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_6, slice2cost_pixels_first_1_7 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_8, slice2cost_pixels_first_1_9 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_10, slice2cost_pixels_first_1_11 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_12, slice2cost_pixels_first_1_13 : integer range -127 to 127;
  signal slice2cost_pixels_first_1_14, slice2cost_pixels_first_1_15 : integer range -127 to 127;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_0_2 : natural range 0 to 128;
  signal slice2cost_pixels_cost_0_3, slice2cost_pixels_cost_0_4, slice2cost_pixels_cost_0_5 : natural range 0 to 128;
  signal slice2cost_pixels_cost_0_6, slice2cost_pixels_cost_0_7, slice2cost_pixels_cost_0_8 : natural range 0 to 128;
  signal slice2cost_pixels_cost_0_9, slice2cost_pixels_cost_0_10, slice2cost_pixels_cost_0_11 : natural range 0 to 128;
  signal slice2cost_pixels_cost_0_12, slice2cost_pixels_cost_0_13, slice2cost_pixels_cost_0_14 : natural range 0 to 128;
  signal slice2cost_pixels_cost_0_15, slice2cost_pixels_cost_1_0, slice2cost_pixels_cost_1_1 : natural range 0 to 128;
  signal slice2cost_pixels_cost_1_2, slice2cost_pixels_cost_1_3, slice2cost_pixels_cost_1_4 : natural range 0 to 128;
  signal slice2cost_pixels_cost_1_5, slice2cost_pixels_cost_1_6, slice2cost_pixels_cost_1_7 : natural range 0 to 128;
  signal slice2cost_pixels_cost_1_8, slice2cost_pixels_cost_1_9, slice2cost_pixels_cost_1_10 : natural range 0 to 128;
  signal slice2cost_pixels_cost_1_11, slice2cost_pixels_cost_1_12, slice2cost_pixels_cost_1_13 : natural range 0 to 128;
  signal slice2cost_pixels_cost_1_14, slice2cost_pixels_cost_1_15 : natural range 0 to 128;
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words_0, slice2cost_read_words_1, slice2cost_read_words_2 : unsigned(29 downto 0);
  signal slice2cost_read_words_3, slice2cost_read_words_4 : unsigned(29 downto 0);
  signal slice2cost_read_words_5 : unsigned(9 downto 0);
  signal slice2cost_change_0_0, slice2cost_change_0_1, slice2cost_change_0_2 : integer range -128 to 128;
  signal slice2cost_change_0_3, slice2cost_change_0_4, slice2cost_change_0_5 : integer range -128 to 128;
  signal slice2cost_change_0_6, slice2cost_change_0_7, slice2cost_change_0_8 : integer range -128 to 128;
  signal slice2cost_change_0_9, slice2cost_change_0_10, slice2cost_change_0_11 : integer range -128 to 128;
  signal slice2cost_change_0_12, slice2cost_change_0_13, slice2cost_change_0_14 : integer range -128 to 128;
  signal slice2cost_change_0_15 : integer range -128 to 128;
  signal slice2cost_ready_words_0, slice2cost_ready_words_1, slice2cost_ready_words_2 : natural range 0 to 1073741823;
  signal slice2cost_ready_words_3, slice2cost_ready_words_4, slice2cost_write_words_0 : natural range 0 to 1073741823;
  signal slice2cost_write_words_1, slice2cost_write_words_2, slice2cost_write_words_3 : natural range 0 to 1073741823;
  signal slice2cost_write_words_4 : natural range 0 to 1073741823;
  signal slice2cost_ready_words_5, slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 1023;
  signal slice2cost_column_0_2, slice2cost_column_0_3, slice2cost_column_0_4 : natural range 0 to 1023;
  signal slice2cost_column_0_5, slice2cost_column_0_6, slice2cost_column_0_7 : natural range 0 to 1023;
  signal slice2cost_column_0_8, slice2cost_column_0_9, slice2cost_column_0_10 : natural range 0 to 1023;
  signal slice2cost_column_0_11, slice2cost_column_0_12, slice2cost_column_0_13 : natural range 0 to 1023;
  signal slice2cost_column_0_14, slice2cost_column_0_15, slice2cost_write_words_5 : natural range 0 to 1023;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving_0, slice2window_leaving_1, slice2window_leaving_2 : unsigned(29 downto 0);
  signal slice2window_leaving_3, slice2window_leaving_4 : unsigned(29 downto 0);
  signal slice2window_leaving_5 : unsigned(9 downto 0);
  signal slice2window_entering_0_0, slice2window_entering_0_1, slice2window_entering_0_2 : natural range 0 to 1023;
  signal slice2window_entering_0_3, slice2window_entering_0_4, slice2window_entering_0_5 : natural range 0 to 1023;
  signal slice2window_entering_0_6, slice2window_entering_0_7, slice2window_entering_0_8 : natural range 0 to 1023;
  signal slice2window_entering_0_9, slice2window_entering_0_10, slice2window_entering_0_11 : natural range 0 to 1023;
  signal slice2window_entering_0_12, slice2window_entering_0_13, slice2window_entering_0_14 : natural range 0 to 1023;
  signal slice2window_entering_0_15 : natural range 0 to 1023;
  signal slice2window_change_0_0, slice2window_change_0_1, slice2window_change_0_2 : integer range -1023 to 1023;
  signal slice2window_change_0_3, slice2window_change_0_4, slice2window_change_0_5 : integer range -1023 to 1023;
  signal slice2window_change_0_6, slice2window_change_0_7, slice2window_change_0_8 : integer range -1023 to 1023;
  signal slice2window_change_0_9, slice2window_change_0_10, slice2window_change_0_11 : integer range -1023 to 1023;
  signal slice2window_change_0_12, slice2window_change_0_13, slice2window_change_0_14 : integer range -1023 to 1023;
  signal slice2window_change_0_15 : integer range -1023 to 1023;
  signal slice2window_change_tag_first_cost, slice2window_change_tag_leaves_window : boolean;
  signal slice2window_centre_output_column_0, slice2window_centre_start_of_frame_1 : boolean;
  signal slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_0_2 : natural range 0 to 16383;
  signal slice2window_sum_0_3, slice2window_sum_0_4, slice2window_sum_0_5 : natural range 0 to 16383;
  signal slice2window_sum_0_6, slice2window_sum_0_7, slice2window_sum_0_8 : natural range 0 to 16383;
  signal slice2window_sum_0_9, slice2window_sum_0_10, slice2window_sum_0_11 : natural range 0 to 16383;
  signal slice2window_sum_0_12, slice2window_sum_0_13, slice2window_sum_0_14 : natural range 0 to 16383;
  signal slice2window_sum_0_15 : natural range 0 to 16383;
  -- slice2winner1
  signal slice2winner1_held_0_0, slice2winner1_held_0_1, slice2winner1_held_0_2 : natural range 0 to 16383;
  signal slice2winner1_held_0_3, slice2winner1_held_0_4, slice2winner1_held_0_5 : natural range 0 to 16383;
  signal slice2winner1_held_0_6, slice2winner1_held_0_7, slice2winner1_held_0_8 : natural range 0 to 16383;
  signal slice2winner1_held_0_9, slice2winner1_held_0_10, slice2winner1_held_0_11 : natural range 0 to 16383;
  signal slice2winner1_held_0_12, slice2winner1_held_0_13, slice2winner1_held_0_14 : natural range 0 to 16383;
  signal slice2winner1_held_0_15, slice2winner1_best_cost_0_0, slice2winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_2, slice2winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_4, slice2winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_6, slice2winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_below_0_0, slice2winner1_best_below_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_below_0_2, slice2winner1_best_below_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_below_0_4, slice2winner1_best_below_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_below_0_6, slice2winner1_best_below_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_above_0_0, slice2winner1_best_above_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_above_0_2, slice2winner1_best_above_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_above_0_4, slice2winner1_best_above_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_above_0_6, slice2winner1_best_above_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_late_cost_0_0, slice2winner1_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_late_cost_0_2, slice2winner1_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_late_cost_0_4, slice2winner1_best_late_cost_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_late_cost_0_6, slice2winner1_best_late_cost_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_but_first_0_0, slice2winner1_best_but_first_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_but_first_0_2, slice2winner1_best_but_first_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_but_first_0_4, slice2winner1_best_but_first_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_but_first_0_6, slice2winner1_best_but_first_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_but_last_0_0, slice2winner1_best_but_last_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_but_last_0_2, slice2winner1_best_but_last_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_but_last_0_4, slice2winner1_best_but_last_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_but_last_0_6, slice2winner1_best_but_last_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_cost_0_2, slice2winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_below_0_0, slice2winner2_best_below_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_below_0_2, slice2winner2_best_below_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_above_0_0, slice2winner2_best_above_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_above_0_2, slice2winner2_best_above_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_first_0_0, slice2winner2_best_first_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_first_0_2, slice2winner2_best_first_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_last_0_0, slice2winner2_best_last_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_last_0_2, slice2winner2_best_last_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_late_cost_0_0, slice2winner2_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_late_cost_0_2, slice2winner2_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_second_0_0, slice2winner2_best_second_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_second_0_2, slice2winner2_best_second_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_but_first_0_0, slice2winner2_best_but_first_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_but_first_0_2, slice2winner2_best_but_first_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_but_last_0_0, slice2winner2_best_but_last_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_but_last_0_2, slice2winner2_best_but_last_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  signal slice2winner2_best_place_0_0, slice2winner2_best_place_0_1, slice2winner2_best_place_0_2 : boolean;
  signal slice2winner2_best_place_0_3, slice2winner2_best_at_start_0_0, slice2winner2_best_at_start_0_1 : boolean;
  signal slice2winner2_best_at_start_0_2, slice2winner2_best_at_start_0_3, slice2winner2_best_at_end_0_0 : boolean;
  signal slice2winner2_best_at_end_0_1, slice2winner2_best_at_end_0_2, slice2winner2_best_at_end_0_3 : boolean;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0, slice2winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_below_0_0, slice2winner3_best_below_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_above_0_0, slice2winner3_best_above_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_first_0_0, slice2winner3_best_first_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_last_0_0, slice2winner3_best_last_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_late_cost_0_0, slice2winner3_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_second_0_0, slice2winner3_best_second_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_but_first_0_0, slice2winner3_best_but_first_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_but_last_0_0, slice2winner3_best_but_last_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  signal slice2winner3_best_place_0_0, slice2winner3_best_place_0_1, slice2winner3_best_at_start_0_0 : boolean;
  signal slice2winner3_best_at_start_0_1, slice2winner3_best_at_end_0_0, slice2winner3_best_at_end_0_1 : boolean;
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_above_0_0, slice2winner4_best_first_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_last_0_0, slice2winner4_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_second_0_0, slice2winner4_best_but_first_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_place_0_0, slice2winner4_best_at_start_0_0, slice2winner4_best_at_end_0_0 : boolean;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0 : natural range 0 to 16383;
  signal slice2_best_last_0_0, slice2_best_late_cost_0_0, slice2_best_second_0_0 : natural range 0 to 16383;
  signal slice2_best_but_last_0_0 : natural range 0 to 16383;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0, slice2_best_tag_valid : boolean;
  signal slice2_best_tag_output_column, slice2_best_tag_start_of_frame, slice2_best_tag_end_of_line : boolean;
  -- slice3shift
  signal slice3shift_search_0_0, slice3shift_search_0_1, slice3shift_search_0_2 : natural range 0 to 127;
  signal slice3shift_search_0_3, slice3shift_search_0_4, slice3shift_search_0_5 : natural range 0 to 127;
  signal slice3shift_search_0_6, slice3shift_search_0_7, slice3shift_search_0_8 : natural range 0 to 127;
  signal slice3shift_search_0_9, slice3shift_search_0_10, slice3shift_search_0_11 : natural range 0 to 127;
  signal slice3shift_search_0_12, slice3shift_search_0_13, slice3shift_search_0_14 : natural range 0 to 127;
  signal slice3shift_search_0_15, slice3shift_search_1_0, slice3shift_search_1_1 : natural range 0 to 127;
  signal slice3shift_search_1_2, slice3shift_search_1_3, slice3shift_search_1_4 : natural range 0 to 127;
  signal slice3shift_search_1_5, slice3shift_search_1_6, slice3shift_search_1_7 : natural range 0 to 127;
  signal slice3shift_search_1_8, slice3shift_search_1_9, slice3shift_search_1_10 : natural range 0 to 127;
  signal slice3shift_search_1_11, slice3shift_search_1_12, slice3shift_search_1_13 : natural range 0 to 127;
  signal slice3shift_search_1_14, slice3shift_search_1_15, slice3shift_reference_0 : natural range 0 to 127;
  signal slice3shift_reference_1 : natural range 0 to 127;
  -- slice3cost
  signal slice3cost_pixels_first_0_0, slice3cost_pixels_first_0_1 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_2, slice3cost_pixels_first_0_3 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_4, slice3cost_pixels_first_0_5 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_6, slice3cost_pixels_first_0_7 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_8, slice3cost_pixels_first_0_9 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_10, slice3cost_pixels_first_0_11 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_12, slice3cost_pixels_first_0_13 : integer range -127 to 127;
  signal slice3cost_pixels_first_0_14, slice3cost_pixels_first_0_15 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_0, slice3cost_pixels_first_1_1 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_2, slice3cost_pixels_first_1_3 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_4, slice3cost_pixels_first_1_5 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_6, slice3cost_pixels_first_1_7 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_8, slice3cost_pixels_first_1_9 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_10, slice3cost_pixels_first_1_11 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_12, slice3cost_pixels_first_1_13 : integer range -127 to 127;
  signal slice3cost_pixels_first_1_14, slice3cost_pixels_first_1_15 : integer range -127 to 127;
  signal slice3cost_pixels_cost_0_0, slice3cost_pixels_cost_0_1, slice3cost_pixels_cost_0_2 : natural range 0 to 128;
  signal slice3cost_pixels_cost_0_3, slice3cost_pixels_cost_0_4, slice3cost_pixels_cost_0_5 : natural range 0 to 128;
  signal slice3cost_pixels_cost_0_6, slice3cost_pixels_cost_0_7, slice3cost_pixels_cost_0_8 : natural range 0 to 128;
  signal slice3cost_pixels_cost_0_9, slice3cost_pixels_cost_0_10, slice3cost_pixels_cost_0_11 : natural range 0 to 128;
  signal slice3cost_pixels_cost_0_12, slice3cost_pixels_cost_0_13, slice3cost_pixels_cost_0_14 : natural range 0 to 128;
  signal slice3cost_pixels_cost_0_15, slice3cost_pixels_cost_1_0, slice3cost_pixels_cost_1_1 : natural range 0 to 128;
  signal slice3cost_pixels_cost_1_2, slice3cost_pixels_cost_1_3, slice3cost_pixels_cost_1_4 : natural range 0 to 128;
  signal slice3cost_pixels_cost_1_5, slice3cost_pixels_cost_1_6, slice3cost_pixels_cost_1_7 : natural range 0 to 128;
  signal slice3cost_pixels_cost_1_8, slice3cost_pixels_cost_1_9, slice3cost_pixels_cost_1_10 : natural range 0 to 128;
  signal slice3cost_pixels_cost_1_11, slice3cost_pixels_cost_1_12, slice3cost_pixels_cost_1_13 : natural range 0 to 128;
  signal slice3cost_pixels_cost_1_14, slice3cost_pixels_cost_1_15 : natural range 0 to 128;
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column : natural range 0 to 511;
  signal slice3cost_write_column : natural range 0 to 511;
  signal slice3cost_read_words_0, slice3cost_read_words_1, slice3cost_read_words_2 : unsigned(29 downto 0);
  signal slice3cost_read_words_3, slice3cost_read_words_4 : unsigned(29 downto 0);
  signal slice3cost_read_words_5 : unsigned(9 downto 0);
  signal slice3cost_change_0_0, slice3cost_change_0_1, slice3cost_change_0_2 : integer range -128 to 128;
  signal slice3cost_change_0_3, slice3cost_change_0_4, slice3cost_change_0_5 : integer range -128 to 128;
  signal slice3cost_change_0_6, slice3cost_change_0_7, slice3cost_change_0_8 : integer range -128 to 128;
  signal slice3cost_change_0_9, slice3cost_change_0_10, slice3cost_change_0_11 : integer range -128 to 128;
  signal slice3cost_change_0_12, slice3cost_change_0_13, slice3cost_change_0_14 : integer range -128 to 128;
  signal slice3cost_change_0_15 : integer range -128 to 128;
  signal slice3cost_ready_words_0, slice3cost_ready_words_1, slice3cost_ready_words_2 : natural range 0 to 1073741823;
  signal slice3cost_ready_words_3, slice3cost_ready_words_4, slice3cost_write_words_0 : natural range 0 to 1073741823;
  signal slice3cost_write_words_1, slice3cost_write_words_2, slice3cost_write_words_3 : natural range 0 to 1073741823;
  signal slice3cost_write_words_4 : natural range 0 to 1073741823;
  signal slice3cost_ready_words_5, slice3cost_column_0_0, slice3cost_column_0_1 : natural range 0 to 1023;
  signal slice3cost_column_0_2, slice3cost_column_0_3, slice3cost_column_0_4 : natural range 0 to 1023;
  signal slice3cost_column_0_5, slice3cost_column_0_6, slice3cost_column_0_7 : natural range 0 to 1023;
  signal slice3cost_column_0_8, slice3cost_column_0_9, slice3cost_column_0_10 : natural range 0 to 1023;
  signal slice3cost_column_0_11, slice3cost_column_0_12, slice3cost_column_0_13 : natural range 0 to 1023;
  signal slice3cost_column_0_14, slice3cost_column_0_15, slice3cost_write_words_5 : natural range 0 to 1023;
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 15;
  signal slice3window_leaving_0, slice3window_leaving_1, slice3window_leaving_2 : unsigned(29 downto 0);
  signal slice3window_leaving_3, slice3window_leaving_4 : unsigned(29 downto 0);
  signal slice3window_leaving_5 : unsigned(9 downto 0);
  signal slice3window_entering_0_0, slice3window_entering_0_1, slice3window_entering_0_2 : natural range 0 to 1023;
  signal slice3window_entering_0_3, slice3window_entering_0_4, slice3window_entering_0_5 : natural range 0 to 1023;
  signal slice3window_entering_0_6, slice3window_entering_0_7, slice3window_entering_0_8 : natural range 0 to 1023;
  signal slice3window_entering_0_9, slice3window_entering_0_10, slice3window_entering_0_11 : natural range 0 to 1023;
  signal slice3window_entering_0_12, slice3window_entering_0_13, slice3window_entering_0_14 : natural range 0 to 1023;
  signal slice3window_entering_0_15 : natural range 0 to 1023;
  signal slice3window_change_0_0, slice3window_change_0_1, slice3window_change_0_2 : integer range -1023 to 1023;
  signal slice3window_change_0_3, slice3window_change_0_4, slice3window_change_0_5 : integer range -1023 to 1023;
  signal slice3window_change_0_6, slice3window_change_0_7, slice3window_change_0_8 : integer range -1023 to 1023;
  signal slice3window_change_0_9, slice3window_change_0_10, slice3window_change_0_11 : integer range -1023 to 1023;
  signal slice3window_change_0_12, slice3window_change_0_13, slice3window_change_0_14 : integer range -1023 to 1023;
  signal slice3window_change_0_15 : integer range -1023 to 1023;
  signal slice3window_change_tag_first_cost, slice3window_centre_output_column_0 : boolean;
  signal slice3window_centre_output_column_1, slice3window_centre_output_column_2 : boolean;
  signal slice3window_centre_output_column_3, slice3window_centre_output_column_4 : boolean;
  signal slice3window_centre_output_column_5, slice3window_centre_start_of_frame_1 : boolean;
  signal slice3window_centre_start_of_frame_5, slice3window_centre_end_of_line_0 : boolean;
  signal slice3window_centre_end_of_line_1, slice3window_centre_end_of_line_2 : boolean;
  signal slice3window_centre_end_of_line_3, slice3window_centre_end_of_line_4 : boolean;
  signal slice3window_centre_end_of_line_5 : boolean;
  signal slice3window_sum_0_0, slice3window_sum_0_1, slice3window_sum_0_2 : natural range 0 to 16383;
  signal slice3window_sum_0_3, slice3window_sum_0_4, slice3window_sum_0_5 : natural range 0 to 16383;
  signal slice3window_sum_0_6, slice3window_sum_0_7, slice3window_sum_0_8 : natural range 0 to 16383;
  signal slice3window_sum_0_9, slice3window_sum_0_10, slice3window_sum_0_11 : natural range 0 to 16383;
  signal slice3window_sum_0_12, slice3window_sum_0_13, slice3window_sum_0_14 : natural range 0 to 16383;
  signal slice3window_sum_0_15 : natural range 0 to 16383;
  -- slice3winner1
  signal slice3winner1_held_0_0, slice3winner1_held_0_1, slice3winner1_held_0_2 : natural range 0 to 16383;
  signal slice3winner1_held_0_3, slice3winner1_held_0_4, slice3winner1_held_0_5 : natural range 0 to 16383;
  signal slice3winner1_held_0_6, slice3winner1_held_0_7, slice3winner1_held_0_8 : natural range 0 to 16383;
  signal slice3winner1_held_0_9, slice3winner1_held_0_10, slice3winner1_held_0_11 : natural range 0 to 16383;
  signal slice3winner1_held_0_12, slice3winner1_held_0_13, slice3winner1_held_0_14 : natural range 0 to 16383;
  signal slice3winner1_held_0_15, slice3winner1_best_cost_0_0, slice3winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_2, slice3winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_4, slice3winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_6, slice3winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_below_0_0, slice3winner1_best_below_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_below_0_2, slice3winner1_best_below_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_below_0_4, slice3winner1_best_below_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_below_0_6, slice3winner1_best_below_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_above_0_0, slice3winner1_best_above_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_above_0_2, slice3winner1_best_above_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_above_0_4, slice3winner1_best_above_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_above_0_6, slice3winner1_best_above_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_late_cost_0_0, slice3winner1_best_late_cost_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_late_cost_0_2, slice3winner1_best_late_cost_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_late_cost_0_4, slice3winner1_best_late_cost_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_late_cost_0_6, slice3winner1_best_late_cost_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_but_first_0_0, slice3winner1_best_but_first_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_but_first_0_2, slice3winner1_best_but_first_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_but_first_0_4, slice3winner1_best_but_first_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_but_first_0_6, slice3winner1_best_but_first_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_but_last_0_0, slice3winner1_best_but_last_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_but_last_0_2, slice3winner1_best_but_last_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_but_last_0_4, slice3winner1_best_but_last_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_but_last_0_6 : natural range 0 to 16383;
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0_1 : natural range 0 to 3;
  signal slice3winner1_best_index_0_2 : natural range 0 to 5;
  signal slice3winner1_best_index_0_3 : natural range 0 to 7;
  signal slice3winner1_best_index_0_4 : natural range 0 to 9;
  signal slice3winner1_best_index_0_5 : natural range 0 to 11;
  signal slice3winner1_best_index_0_6 : natural range 0 to 13;
  signal slice3winner1_best_index_0_7 : natural range 0 to 15;
  -- slice3winner2
  signal slice3winner2_best_cost_0_0, slice3winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_cost_0_2, slice3winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice3winner2_best_below_0_0, slice3winner2_best_below_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_below_0_2, slice3winner2_best_below_0_3 : natural range 0 to 16383;
  signal slice3winner2_best_above_0_0, slice3winner2_best_above_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_above_0_2, slice3winner2_best_above_0_3 : natural range 0 to 16383;
  signal slice3winner2_best_first_0_0, slice3winner2_best_first_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_first_0_2, slice3winner2_best_first_0_3 : natural range 0 to 16383;
  signal slice3winner2_best_last_0_0, slice3winner2_best_last_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_last_0_2, slice3winner2_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice3winner2_best_late_cost_0_1, slice3winner2_best_late_cost_0_2 : natural range 0 to 16383;
  signal slice3winner2_best_late_cost_0_3, slice3winner2_best_second_0_0 : natural range 0 to 16383;
  signal slice3winner2_best_second_0_1, slice3winner2_best_second_0_2 : natural range 0 to 16383;
  signal slice3winner2_best_second_0_3, slice3winner2_best_but_first_0_0 : natural range 0 to 16383;
  signal slice3winner2_best_but_first_0_1, slice3winner2_best_but_first_0_2 : natural range 0 to 16383;
  signal slice3winner2_best_but_first_0_3, slice3winner2_best_but_last_0_0 : natural range 0 to 16383;
  signal slice3winner2_best_but_last_0_1, slice3winner2_best_but_last_0_2 : natural range 0 to 16383;
  signal slice3winner2_best_index_0_0 : natural range 0 to 3;
  signal slice3winner2_best_index_0_1 : natural range 0 to 7;
  signal slice3winner2_best_index_0_2 : natural range 0 to 11;
  signal slice3winner2_best_index_0_3 : natural range 0 to 15;
  signal slice3winner2_best_place_0_0, slice3winner2_best_place_0_1, slice3winner2_best_place_0_2 : boolean;
  signal slice3winner2_best_place_0_3, slice3winner2_best_at_start_0_0, slice3winner2_best_at_start_0_1 : boolean;
  signal slice3winner2_best_at_start_0_2, slice3winner2_best_at_start_0_3, slice3winner2_best_at_end_0_0 : boolean;
  signal slice3winner2_best_at_end_0_1, slice3winner2_best_at_end_0_2, slice3winner2_best_at_end_0_3 : boolean;
  -- slice3winner3
  signal slice3winner3_best_cost_0_0, slice3winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner3_best_below_0_0, slice3winner3_best_below_0_1 : natural range 0 to 16383;
  signal slice3winner3_best_above_0_0, slice3winner3_best_above_0_1 : natural range 0 to 16383;
  signal slice3winner3_best_first_0_0, slice3winner3_best_first_0_1 : natural range 0 to 16383;
  signal slice3winner3_best_last_0_0, slice3winner3_best_late_cost_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_late_cost_0_1, slice3winner3_best_second_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_second_0_1, slice3winner3_best_but_first_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_but_first_0_1, slice3winner3_best_but_last_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_index_0_0 : natural range 0 to 7;
  signal slice3winner3_best_index_0_1 : natural range 0 to 15;
  signal slice3winner3_best_place_0_0, slice3winner3_best_place_0_1, slice3winner3_best_at_start_0_0 : boolean;
  signal slice3winner3_best_at_start_0_1, slice3winner3_best_at_end_0_0, slice3winner3_best_at_end_0_1 : boolean;
  -- slice3winner4
  signal slice3winner4_best_cost_0_0, slice3winner4_best_below_0_0 : natural range 0 to 16383;
  signal slice3winner4_best_above_0_0, slice3winner4_best_first_0_0 : natural range 0 to 16383;
  signal slice3winner4_best_late_cost_0_0, slice3winner4_best_second_0_0 : natural range 0 to 16383;
  signal slice3winner4_best_but_first_0_0 : natural range 0 to 16383;
  signal slice3winner4_best_index_0_0 : natural range 0 to 15;
  signal slice3winner4_best_place_0_0, slice3winner4_best_at_start_0_0, slice3winner4_best_at_end_0_0 : boolean;
  -- slice3
  signal slice3_best_cost_0_0, slice3_best_below_0_0, slice3_best_above_0_0 : natural range 0 to 16383;
  signal slice3_best_late_cost_0_0, slice3_best_second_0_0 : natural range 0 to 16383;
  signal slice3_best_index_0_0 : natural range 0 to 63;
  signal slice3_best_place_0_0, slice3_best_at_start_0_0, slice3_best_at_end_0_0, slice3_best_tag_valid : boolean;
  signal slice3_best_tag_output_column, slice3_best_tag_start_of_frame, slice3_best_tag_end_of_line : boolean;
  -- texture
  signal texture_taps_search_0_0, texture_taps_search_1_0 : natural range 0 to 31;
  signal texture_passes_0_0, texture_passes_1_0, texture_passes_2_0, texture_passes_3_0, texture_passes_4_0 : boolean;
  signal texture_passes_5_0, texture_passes_6_0, texture_passes_7_0 : boolean;
  -- texturecost
  signal texturecost_pixels_first_0_0, texturecost_pixels_first_1_0 : integer range -127 to 31;
  signal texturecost_pixels_cost_0_0, texturecost_pixels_cost_1_0 : natural range 0 to 127;
  signal texturecost_read_words_0 : unsigned(9 downto 0);
  signal texturecost_change_0_0 : integer range -127 to 127;
  signal texturecost_ready_words_0, texturecost_column_0_0, texturecost_write_words_0 : natural range 0 to 1023;
  -- texturewindow
  signal texturewindow_leaving_0 : unsigned(9 downto 0);
  signal texturewindow_entering_0_0 : natural range 0 to 1023;
  signal texturewindow_change_0_0 : integer range -1023 to 1023;
  signal texturewindow_sum_0_0 : natural range 0 to 16383;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 63;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 63;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 63;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 63;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0 : boolean;
  signal refinement_passed_8_0, refinement_passed_9_0, refinement_passed_10_0, refinement_passed_11_0 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_output_column, refinement_tag_0_start_of_frame : boolean;
  signal refinement_tag_0_end_of_line, refinement_tag_1_valid, refinement_tag_1_output_column : boolean;
  signal refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line, refinement_tag_2_valid : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_output_column, refinement_tag_3_start_of_frame : boolean;
  signal refinement_tag_3_end_of_line, refinement_tag_4_valid, refinement_tag_4_output_column : boolean;
  signal refinement_tag_4_start_of_frame, refinement_tag_4_end_of_line, refinement_tag_5_valid : boolean;
  signal refinement_tag_5_output_column, refinement_tag_5_start_of_frame, refinement_tag_5_end_of_line : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_output_column, refinement_tag_6_start_of_frame : boolean;
  signal refinement_tag_6_end_of_line, refinement_tag_7_valid, refinement_tag_7_output_column : boolean;
  signal refinement_tag_7_start_of_frame, refinement_tag_7_end_of_line, refinement_tag_8_valid : boolean;
  signal refinement_tag_8_output_column, refinement_tag_8_start_of_frame, refinement_tag_8_end_of_line : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_output_column, refinement_tag_9_start_of_frame : boolean;
  signal refinement_tag_9_end_of_line, refinement_tag_10_valid, refinement_tag_10_output_column : boolean;
  signal refinement_tag_10_start_of_frame, refinement_tag_10_end_of_line, refinement_tag_11_valid : boolean;
  signal refinement_tag_11_output_column, refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line : boolean;
  signal refinement_alone_0_0, refinement_alone_1_0, refinement_negative_0_0, refinement_negative_1_0 : boolean;
  signal refinement_negative_2_0, refinement_negative_3_0, refinement_negative_4_0, refinement_negative_5_0 : boolean;
  signal refinement_negative_6_0, refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_gap_0, refinement_lowest_0, refinement_below_0, refinement_above_0 : natural range 0 to 16383;
  signal refinement_u_0, refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 16383;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 16383;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 16383;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 16383;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 16383;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 16383;
  signal refinement_scaled_gap_0 : natural range 0 to 327660;
  signal refinement_scaled_cost_0 : natural range 0 to 49149;
  signal refinement_difference_0 : integer range -16383 to 16383;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0, other_1, other_2, other_3, other_4, other_5, other_13, other_14, other_15, other_16 : boolean;
  signal other_17, other_18, other_19, other_20, other_21, other_22 : boolean;
  signal other_6 : natural range 0 to 254;
  signal other_7 : natural range 0 to 252;
  signal other_8 : natural range 0 to 248;
  signal other_9 : natural range 0 to 240;
  signal other_10 : natural range 0 to 224;
  signal other_11 : natural range 0 to 192;
  signal other_12 : natural range 0 to 128;
  signal texturewindow_leaving_0_memory_read_enable : boolean;
  signal texturewindow_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal texturewindow_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal texturewindow_leaving_0_memory_write_data : unsigned(9 downto 0);
  signal texturecost_read_words_0_memory_read_enable : boolean;
  signal texturecost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal texturecost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal texturecost_read_words_0_memory_write_data : unsigned(9 downto 0);
  signal slice3window_leaving_5_memory_read_enable : boolean;
  signal slice3window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice3window_leaving_4_memory_read_enable : boolean;
  signal slice3window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_3_memory_read_enable : boolean;
  signal slice3window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_2_memory_read_enable : boolean;
  signal slice3window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_1_memory_read_enable : boolean;
  signal slice3window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_0_memory_read_enable : boolean;
  signal slice3window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice3window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_0_memory_write_data : unsigned(29 downto 0);
  signal slice3cost_read_words_5_memory_read_enable : boolean;
  signal slice3cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_5_memory_write_data : unsigned(9 downto 0);
  signal slice3cost_read_words_4_memory_read_enable : boolean;
  signal slice3cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_4_memory_write_data : unsigned(29 downto 0);
  signal slice3cost_read_words_3_memory_read_enable : boolean;
  signal slice3cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_3_memory_write_data : unsigned(29 downto 0);
  signal slice3cost_read_words_2_memory_read_enable : boolean;
  signal slice3cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal slice3cost_read_words_1_memory_read_enable : boolean;
  signal slice3cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal slice3cost_read_words_0_memory_read_enable : boolean;
  signal slice3cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_5_memory_read_enable : boolean;
  signal slice2window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice2window_leaving_4_memory_read_enable : boolean;
  signal slice2window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(29 downto 0);
  signal slice2cost_read_words_5_memory_read_enable : boolean;
  signal slice2cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_5_memory_write_data : unsigned(9 downto 0);
  signal slice2cost_read_words_4_memory_read_enable : boolean;
  signal slice2cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_4_memory_write_data : unsigned(29 downto 0);
  signal slice2cost_read_words_3_memory_read_enable : boolean;
  signal slice2cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_data : unsigned(29 downto 0);
  signal slice2cost_read_words_2_memory_read_enable : boolean;
  signal slice2cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_5_memory_read_enable : boolean;
  signal slice1window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice1window_leaving_4_memory_read_enable : boolean;
  signal slice1window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(29 downto 0);
  signal slice1cost_read_words_5_memory_read_enable : boolean;
  signal slice1cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_5_memory_write_data : unsigned(9 downto 0);
  signal slice1cost_read_words_4_memory_read_enable : boolean;
  signal slice1cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_4_memory_write_data : unsigned(29 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(29 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_5_memory_read_enable : boolean;
  signal slice0window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice0window_leaving_4_memory_read_enable : boolean;
  signal slice0window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(29 downto 0);
  signal slice0cost_read_words_5_memory_read_enable : boolean;
  signal slice0cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_5_memory_write_data : unsigned(9 downto 0);
  signal slice0cost_read_words_4_memory_read_enable : boolean;
  signal slice0cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_4_memory_write_data : unsigned(29 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(29 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal rows_search_rows_read_words_3_memory_read_enable : boolean;
  signal rows_search_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_data : unsigned(20 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_3_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_data : unsigned(20 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(15 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  texturewindow_leaving_0_memory_read_enable <= true;
  texturewindow_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  texturewindow_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  texturewindow_leaving_0_memory_write_data <= to_unsigned(texturecost_column_0_0, 10);
  texturewindow_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => texturewindow_leaving_0_memory_read_enable,
      read_address => texturewindow_leaving_0_memory_read_address, read_data => texturewindow_leaving_0,
      write_address => texturewindow_leaving_0_memory_write_address, write_data => texturewindow_leaving_0_memory_write_data);

  texturecost_read_words_0_memory_read_enable <= true;
  texturecost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  texturecost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  texturecost_read_words_0_memory_write_data <= to_unsigned(texturecost_write_words_0, 10);
  texturecost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 10, address_bits => 9)
    port map (
      clock => clock, read_enable => texturecost_read_words_0_memory_read_enable,
      read_address => texturecost_read_words_0_memory_read_address, read_data => texturecost_read_words_0,
      write_address => texturecost_read_words_0_memory_write_address, write_data => texturecost_read_words_0_memory_write_data);

  slice3window_leaving_5_memory_read_enable <= true;
  slice3window_leaving_5_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_5_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_5_memory_write_data <= to_unsigned(slice3cost_column_0_15, 10);
  slice3window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_5_memory_read_enable,
      read_address => slice3window_leaving_5_memory_read_address, read_data => slice3window_leaving_5,
      write_address => slice3window_leaving_5_memory_write_address, write_data => slice3window_leaving_5_memory_write_data);

  slice3window_leaving_4_memory_read_enable <= true;
  slice3window_leaving_4_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_4_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_4_memory_write_data <= to_unsigned(slice3cost_column_0_14, 10) & to_unsigned(slice3cost_column_0_13, 10) & to_unsigned(slice3cost_column_0_12, 10);
  slice3window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_4_memory_read_enable,
      read_address => slice3window_leaving_4_memory_read_address, read_data => slice3window_leaving_4,
      write_address => slice3window_leaving_4_memory_write_address, write_data => slice3window_leaving_4_memory_write_data);

  slice3window_leaving_3_memory_read_enable <= true;
  slice3window_leaving_3_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_3_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_3_memory_write_data <= to_unsigned(slice3cost_column_0_11, 10) & to_unsigned(slice3cost_column_0_10, 10) & to_unsigned(slice3cost_column_0_9, 10);
  slice3window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_3_memory_read_enable,
      read_address => slice3window_leaving_3_memory_read_address, read_data => slice3window_leaving_3,
      write_address => slice3window_leaving_3_memory_write_address, write_data => slice3window_leaving_3_memory_write_data);

  slice3window_leaving_2_memory_read_enable <= true;
  slice3window_leaving_2_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_2_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_2_memory_write_data <= to_unsigned(slice3cost_column_0_8, 10) & to_unsigned(slice3cost_column_0_7, 10) & to_unsigned(slice3cost_column_0_6, 10);
  slice3window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_2_memory_read_enable,
      read_address => slice3window_leaving_2_memory_read_address, read_data => slice3window_leaving_2,
      write_address => slice3window_leaving_2_memory_write_address, write_data => slice3window_leaving_2_memory_write_data);

  slice3window_leaving_1_memory_read_enable <= true;
  slice3window_leaving_1_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_1_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_1_memory_write_data <= to_unsigned(slice3cost_column_0_5, 10) & to_unsigned(slice3cost_column_0_4, 10) & to_unsigned(slice3cost_column_0_3, 10);
  slice3window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_1_memory_read_enable,
      read_address => slice3window_leaving_1_memory_read_address, read_data => slice3window_leaving_1,
      write_address => slice3window_leaving_1_memory_write_address, write_data => slice3window_leaving_1_memory_write_data);

  slice3window_leaving_0_memory_read_enable <= true;
  slice3window_leaving_0_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_0_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_0_memory_write_data <= to_unsigned(slice3cost_column_0_2, 10) & to_unsigned(slice3cost_column_0_1, 10) & to_unsigned(slice3cost_column_0_0, 10);
  slice3window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_0_memory_read_enable,
      read_address => slice3window_leaving_0_memory_read_address, read_data => slice3window_leaving_0,
      write_address => slice3window_leaving_0_memory_write_address, write_data => slice3window_leaving_0_memory_write_data);

  slice3cost_read_words_5_memory_read_enable <= true;
  slice3cost_read_words_5_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_5_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_5_memory_write_data <= to_unsigned(slice3cost_write_words_5, 10);
  slice3cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 10, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_5_memory_read_enable,
      read_address => slice3cost_read_words_5_memory_read_address, read_data => slice3cost_read_words_5,
      write_address => slice3cost_read_words_5_memory_write_address, write_data => slice3cost_read_words_5_memory_write_data);

  slice3cost_read_words_4_memory_read_enable <= true;
  slice3cost_read_words_4_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_4_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_4_memory_write_data <= to_unsigned(slice3cost_write_words_4, 30);
  slice3cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_4_memory_read_enable,
      read_address => slice3cost_read_words_4_memory_read_address, read_data => slice3cost_read_words_4,
      write_address => slice3cost_read_words_4_memory_write_address, write_data => slice3cost_read_words_4_memory_write_data);

  slice3cost_read_words_3_memory_read_enable <= true;
  slice3cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_3_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_3_memory_write_data <= to_unsigned(slice3cost_write_words_3, 30);
  slice3cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_3_memory_read_enable,
      read_address => slice3cost_read_words_3_memory_read_address, read_data => slice3cost_read_words_3,
      write_address => slice3cost_read_words_3_memory_write_address, write_data => slice3cost_read_words_3_memory_write_data);

  slice3cost_read_words_2_memory_read_enable <= true;
  slice3cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_2_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_2_memory_write_data <= to_unsigned(slice3cost_write_words_2, 30);
  slice3cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_2_memory_read_enable,
      read_address => slice3cost_read_words_2_memory_read_address, read_data => slice3cost_read_words_2,
      write_address => slice3cost_read_words_2_memory_write_address, write_data => slice3cost_read_words_2_memory_write_data);

  slice3cost_read_words_1_memory_read_enable <= true;
  slice3cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_1_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_1_memory_write_data <= to_unsigned(slice3cost_write_words_1, 30);
  slice3cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_1_memory_read_enable,
      read_address => slice3cost_read_words_1_memory_read_address, read_data => slice3cost_read_words_1,
      write_address => slice3cost_read_words_1_memory_write_address, write_data => slice3cost_read_words_1_memory_write_data);

  slice3cost_read_words_0_memory_read_enable <= true;
  slice3cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_0_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_0_memory_write_data <= to_unsigned(slice3cost_write_words_0, 30);
  slice3cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_0_memory_read_enable,
      read_address => slice3cost_read_words_0_memory_read_address, read_data => slice3cost_read_words_0,
      write_address => slice3cost_read_words_0_memory_write_address, write_data => slice3cost_read_words_0_memory_write_data);

  slice2window_leaving_5_memory_read_enable <= true;
  slice2window_leaving_5_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_5_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_5_memory_write_data <= to_unsigned(slice2cost_column_0_15, 10);
  slice2window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_5_memory_read_enable,
      read_address => slice2window_leaving_5_memory_read_address, read_data => slice2window_leaving_5,
      write_address => slice2window_leaving_5_memory_write_address, write_data => slice2window_leaving_5_memory_write_data);

  slice2window_leaving_4_memory_read_enable <= true;
  slice2window_leaving_4_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_4_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_4_memory_write_data <= to_unsigned(slice2cost_column_0_14, 10) & to_unsigned(slice2cost_column_0_13, 10) & to_unsigned(slice2cost_column_0_12, 10);
  slice2window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_4_memory_read_enable,
      read_address => slice2window_leaving_4_memory_read_address, read_data => slice2window_leaving_4,
      write_address => slice2window_leaving_4_memory_write_address, write_data => slice2window_leaving_4_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0_11, 10) & to_unsigned(slice2cost_column_0_10, 10) & to_unsigned(slice2cost_column_0_9, 10);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving_3,
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0_8, 10) & to_unsigned(slice2cost_column_0_7, 10) & to_unsigned(slice2cost_column_0_6, 10);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving_2,
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0_5, 10) & to_unsigned(slice2cost_column_0_4, 10) & to_unsigned(slice2cost_column_0_3, 10);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving_1,
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0_2, 10) & to_unsigned(slice2cost_column_0_1, 10) & to_unsigned(slice2cost_column_0_0, 10);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving_0,
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_5_memory_read_enable <= true;
  slice2cost_read_words_5_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_5_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_5_memory_write_data <= to_unsigned(slice2cost_write_words_5, 10);
  slice2cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 10, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_5_memory_read_enable,
      read_address => slice2cost_read_words_5_memory_read_address, read_data => slice2cost_read_words_5,
      write_address => slice2cost_read_words_5_memory_write_address, write_data => slice2cost_read_words_5_memory_write_data);

  slice2cost_read_words_4_memory_read_enable <= true;
  slice2cost_read_words_4_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_4_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_4_memory_write_data <= to_unsigned(slice2cost_write_words_4, 30);
  slice2cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_4_memory_read_enable,
      read_address => slice2cost_read_words_4_memory_read_address, read_data => slice2cost_read_words_4,
      write_address => slice2cost_read_words_4_memory_write_address, write_data => slice2cost_read_words_4_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_3_memory_write_data <= to_unsigned(slice2cost_write_words_3, 30);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words_3,
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_2_memory_write_data <= to_unsigned(slice2cost_write_words_2, 30);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words_2,
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_1_memory_write_data <= to_unsigned(slice2cost_write_words_1, 30);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words_1,
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_0_memory_write_data <= to_unsigned(slice2cost_write_words_0, 30);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words_0,
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_5_memory_read_enable <= true;
  slice1window_leaving_5_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_5_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_5_memory_write_data <= to_unsigned(slice1cost_column_0_15, 10);
  slice1window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_5_memory_read_enable,
      read_address => slice1window_leaving_5_memory_read_address, read_data => slice1window_leaving_5,
      write_address => slice1window_leaving_5_memory_write_address, write_data => slice1window_leaving_5_memory_write_data);

  slice1window_leaving_4_memory_read_enable <= true;
  slice1window_leaving_4_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_4_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_4_memory_write_data <= to_unsigned(slice1cost_column_0_14, 10) & to_unsigned(slice1cost_column_0_13, 10) & to_unsigned(slice1cost_column_0_12, 10);
  slice1window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_4_memory_read_enable,
      read_address => slice1window_leaving_4_memory_read_address, read_data => slice1window_leaving_4,
      write_address => slice1window_leaving_4_memory_write_address, write_data => slice1window_leaving_4_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0_11, 10) & to_unsigned(slice1cost_column_0_10, 10) & to_unsigned(slice1cost_column_0_9, 10);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving_3,
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0_8, 10) & to_unsigned(slice1cost_column_0_7, 10) & to_unsigned(slice1cost_column_0_6, 10);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_5, 10) & to_unsigned(slice1cost_column_0_4, 10) & to_unsigned(slice1cost_column_0_3, 10);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_2, 10) & to_unsigned(slice1cost_column_0_1, 10) & to_unsigned(slice1cost_column_0_0, 10);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_5_memory_read_enable <= true;
  slice1cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_5_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_5_memory_write_data <= to_unsigned(slice1cost_write_words_5, 10);
  slice1cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 10, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_5_memory_read_enable,
      read_address => slice1cost_read_words_5_memory_read_address, read_data => slice1cost_read_words_5,
      write_address => slice1cost_read_words_5_memory_write_address, write_data => slice1cost_read_words_5_memory_write_data);

  slice1cost_read_words_4_memory_read_enable <= true;
  slice1cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_4_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_4_memory_write_data <= to_unsigned(slice1cost_write_words_4, 30);
  slice1cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_4_memory_read_enable,
      read_address => slice1cost_read_words_4_memory_read_address, read_data => slice1cost_read_words_4,
      write_address => slice1cost_read_words_4_memory_write_address, write_data => slice1cost_read_words_4_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words_3, 30);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words_3,
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words_2, 30);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words_2,
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words_1, 30);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words_0, 30);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_5_memory_read_enable <= true;
  slice0window_leaving_5_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_5_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_5_memory_write_data <= to_unsigned(slice0cost_column_0_15, 10);
  slice0window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_5_memory_read_enable,
      read_address => slice0window_leaving_5_memory_read_address, read_data => slice0window_leaving_5,
      write_address => slice0window_leaving_5_memory_write_address, write_data => slice0window_leaving_5_memory_write_data);

  slice0window_leaving_4_memory_read_enable <= true;
  slice0window_leaving_4_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_4_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_4_memory_write_data <= to_unsigned(slice0cost_column_0_14, 10) & to_unsigned(slice0cost_column_0_13, 10) & to_unsigned(slice0cost_column_0_12, 10);
  slice0window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_4_memory_read_enable,
      read_address => slice0window_leaving_4_memory_read_address, read_data => slice0window_leaving_4,
      write_address => slice0window_leaving_4_memory_write_address, write_data => slice0window_leaving_4_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0_11, 10) & to_unsigned(slice0cost_column_0_10, 10) & to_unsigned(slice0cost_column_0_9, 10);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving_3,
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0_8, 10) & to_unsigned(slice0cost_column_0_7, 10) & to_unsigned(slice0cost_column_0_6, 10);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_5, 10) & to_unsigned(slice0cost_column_0_4, 10) & to_unsigned(slice0cost_column_0_3, 10);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_2, 10) & to_unsigned(slice0cost_column_0_1, 10) & to_unsigned(slice0cost_column_0_0, 10);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_5_memory_read_enable <= true;
  slice0cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_5_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_5_memory_write_data <= to_unsigned(slice0cost_write_words_5, 10);
  slice0cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 10, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_5_memory_read_enable,
      read_address => slice0cost_read_words_5_memory_read_address, read_data => slice0cost_read_words_5,
      write_address => slice0cost_read_words_5_memory_write_address, write_data => slice0cost_read_words_5_memory_write_data);

  slice0cost_read_words_4_memory_read_enable <= true;
  slice0cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_4_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_4_memory_write_data <= to_unsigned(slice0cost_write_words_4, 30);
  slice0cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_4_memory_read_enable,
      read_address => slice0cost_read_words_4_memory_read_address, read_data => slice0cost_read_words_4,
      write_address => slice0cost_read_words_4_memory_write_address, write_data => slice0cost_read_words_4_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words_3, 30);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words_3,
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words_2, 30);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 30);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 30);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_3_memory_read_enable <= true;
  rows_search_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_3_memory_write_data <= to_unsigned(rows_search_rows_write_words_3, 21);
  rows_search_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 21, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_3_memory_read_enable,
      read_address => rows_search_rows_read_words_3_memory_read_address, read_data => rows_search_rows_read_words_3,
      write_address => rows_search_rows_read_words_3_memory_write_address, write_data => rows_search_rows_read_words_3_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 28);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 28);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_3_memory_read_enable <= true;
  rows_reference_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_3_memory_write_data <= to_unsigned(rows_reference_rows_write_words_3, 21);
  rows_reference_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 21, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_3_memory_read_enable,
      read_address => rows_reference_rows_read_words_3_memory_read_address, read_data => rows_reference_rows_read_words_3,
      write_address => rows_reference_rows_read_words_3_memory_write_address, write_data => rows_reference_rows_read_words_3_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 28);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 28);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 16);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 16, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 16);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 16, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_differs, transform_read_column_inside_0_differs : boolean;
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable transform_counter_next_frame_choice_3, transform_left_filter_column_0_0_choice_3 : boolean;
    variable transform_right_filter_column_0_0_choice_3, raster_place_group_is_equal : boolean;
    variable slice0winner1_best_index_0_0_is_not_less, slice0winner1_best_index_0_1_is_less : boolean;
    variable slice0winner1_best_index_0_2_is_less, slice0winner1_best_index_0_3_is_less : boolean;
    variable slice0winner1_best_index_0_4_is_less, slice0winner1_best_index_0_5_is_less : boolean;
    variable slice0winner1_best_index_0_6_is_less, slice0winner1_best_index_0_7_is_less : boolean;
    variable slice0winner2_best_index_0_0_is_not_less, slice0winner2_best_index_0_1_is_not_less : boolean;
    variable slice0winner2_best_index_0_2_is_not_less, slice0winner2_best_index_0_3_is_not_less : boolean;
    variable slice0winner2_best_above_0_3_value, slice0winner3_best_index_0_0_is_not_less : boolean;
    variable slice0winner3_best_index_0_1_is_not_less, slice0winner3_best_below_0_0_is_equal : boolean;
    variable slice0winner3_best_below_0_1_is_equal, slice0winner3_best_above_0_0_is_equal : boolean;
    variable slice0winner3_best_above_0_1_is_equal, slice0winner4_best_index_0_0_is_less : boolean;
    variable slice0winner4_best_below_0_0_is_equal, slice0winner4_best_above_0_0_is_equal : boolean;
    variable slice0winner4_best_place_0_0_is_not_less, slice1winner1_best_index_0_0_is_not_less : boolean;
    variable slice1winner1_best_index_0_1_is_less, slice1winner1_best_index_0_2_is_less : boolean;
    variable slice1winner1_best_index_0_3_is_less, slice1winner1_best_index_0_4_is_less : boolean;
    variable slice1winner1_best_index_0_5_is_less, slice1winner1_best_index_0_6_is_less : boolean;
    variable slice1winner1_best_index_0_7_is_less, slice1winner2_best_index_0_0_is_not_less : boolean;
    variable slice1winner2_best_index_0_1_is_not_less, slice1winner2_best_index_0_2_is_not_less : boolean;
    variable slice1winner2_best_index_0_3_is_not_less, slice1winner2_best_above_0_3_value : boolean;
    variable slice1winner3_best_index_0_0_is_not_less, slice1winner3_best_index_0_1_is_not_less : boolean;
    variable slice1winner3_best_below_0_0_is_equal, slice1winner3_best_below_0_1_is_equal : boolean;
    variable slice1winner3_best_above_0_0_is_equal, slice1winner3_best_above_0_1_is_equal : boolean;
    variable slice1winner4_best_index_0_0_is_less, slice1winner4_best_below_0_0_is_equal : boolean;
    variable slice1winner4_best_above_0_0_is_equal, slice1winner4_best_place_0_0_is_not_less : boolean;
    variable slice1_best_index_0_0_is_less, slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal : boolean;
    variable slice1_best_place_0_0_is_not_less, slice2winner1_best_index_0_0_is_not_less : boolean;
    variable slice2winner1_best_index_0_1_is_less, slice2winner1_best_index_0_2_is_less : boolean;
    variable slice2winner1_best_index_0_3_is_less, slice2winner1_best_index_0_4_is_less : boolean;
    variable slice2winner1_best_index_0_5_is_less, slice2winner1_best_index_0_6_is_less : boolean;
    variable slice2winner1_best_index_0_7_is_less, slice2winner2_best_index_0_0_is_not_less : boolean;
    variable slice2winner2_best_index_0_1_is_not_less, slice2winner2_best_index_0_2_is_not_less : boolean;
    variable slice2winner2_best_index_0_3_is_not_less, slice2winner2_best_above_0_3_value : boolean;
    variable slice2winner3_best_index_0_0_is_not_less, slice2winner3_best_index_0_1_is_not_less : boolean;
    variable slice2winner3_best_below_0_0_is_equal, slice2winner3_best_below_0_1_is_equal : boolean;
    variable slice2winner3_best_above_0_0_is_equal, slice2winner3_best_above_0_1_is_equal : boolean;
    variable slice2winner4_best_index_0_0_is_less, slice2winner4_best_below_0_0_is_equal : boolean;
    variable slice2winner4_best_above_0_0_is_equal, slice2winner4_best_place_0_0_is_not_less : boolean;
    variable slice2_best_index_0_0_is_less, slice2_best_below_0_0_is_equal, slice2_best_above_0_0_is_equal : boolean;
    variable slice2_best_place_0_0_is_not_less, slice3winner1_best_index_0_0_is_not_less : boolean;
    variable slice3winner1_best_index_0_1_is_less, slice3winner1_best_index_0_2_is_less : boolean;
    variable slice3winner1_best_index_0_3_is_less, slice3winner1_best_index_0_4_is_less : boolean;
    variable slice3winner1_best_index_0_5_is_less, slice3winner1_best_index_0_6_is_less : boolean;
    variable slice3winner1_best_index_0_7_is_less, slice3winner2_best_index_0_0_is_not_less : boolean;
    variable slice3winner2_best_index_0_1_is_not_less, slice3winner2_best_index_0_2_is_not_less : boolean;
    variable slice3winner2_best_index_0_3_is_not_less, slice3winner2_best_above_0_3_value : boolean;
    variable slice3winner3_best_index_0_0_is_not_less, slice3winner3_best_index_0_1_is_not_less : boolean;
    variable slice3winner3_best_below_0_0_is_equal, slice3winner3_best_below_0_1_is_equal : boolean;
    variable slice3winner3_best_above_0_0_is_equal, slice3winner3_best_above_0_1_is_equal : boolean;
    variable slice3winner4_best_index_0_0_is_less, slice3winner4_best_below_0_0_is_equal : boolean;
    variable slice3winner4_best_above_0_0_is_equal, slice3winner4_best_place_0_0_is_not_less : boolean;
    variable slice3_best_index_0_0_is_less, slice3_best_below_0_0_is_equal, slice3_best_above_0_0_is_equal : boolean;
    variable slice3_best_place_0_0_is_not_less, refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_choice_2 : natural range 0 to 127;
    variable transform_right_filter_feature_0_choice : natural range 0 to 127;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 127;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice_2, refinement_fraction_0_choice : natural range 0 to 255;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_8_choice, slice0cost_column_0_8_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_9_choice, slice0cost_column_0_9_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_10_choice, slice0cost_column_0_10_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_11_choice, slice0cost_column_0_11_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_12_choice, slice0cost_column_0_12_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_13_choice, slice0cost_column_0_13_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_14_choice, slice0cost_column_0_14_choice_2 : natural range 0 to 1023;
    variable slice0cost_column_0_15_choice, slice0cost_column_0_15_choice_2 : natural range 0 to 1023;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 1023;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 1023;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 1023;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 1023;
    variable slice0window_change_0_8_choice, slice0window_change_0_9_choice : natural range 0 to 1023;
    variable slice0window_change_0_10_choice, slice0window_change_0_11_choice : natural range 0 to 1023;
    variable slice0window_change_0_12_choice, slice0window_change_0_13_choice : natural range 0 to 1023;
    variable slice0window_change_0_14_choice, slice0window_change_0_15_choice : natural range 0 to 1023;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_0_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_1_choice, slice1cost_column_0_1_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_2_choice, slice1cost_column_0_2_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_3_choice, slice1cost_column_0_3_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_4_choice, slice1cost_column_0_4_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_5_choice, slice1cost_column_0_5_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_6_choice, slice1cost_column_0_6_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_7_choice, slice1cost_column_0_7_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_8_choice, slice1cost_column_0_8_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_9_choice, slice1cost_column_0_9_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_10_choice, slice1cost_column_0_10_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_11_choice, slice1cost_column_0_11_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_12_choice, slice1cost_column_0_12_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_13_choice, slice1cost_column_0_13_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_14_choice, slice1cost_column_0_14_choice_2 : natural range 0 to 1023;
    variable slice1cost_column_0_15_choice, slice1cost_column_0_15_choice_2 : natural range 0 to 1023;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 1023;
    variable slice1window_change_0_2_choice, slice1window_change_0_3_choice : natural range 0 to 1023;
    variable slice1window_change_0_4_choice, slice1window_change_0_5_choice : natural range 0 to 1023;
    variable slice1window_change_0_6_choice, slice1window_change_0_7_choice : natural range 0 to 1023;
    variable slice1window_change_0_8_choice, slice1window_change_0_9_choice : natural range 0 to 1023;
    variable slice1window_change_0_10_choice, slice1window_change_0_11_choice : natural range 0 to 1023;
    variable slice1window_change_0_12_choice, slice1window_change_0_13_choice : natural range 0 to 1023;
    variable slice1window_change_0_14_choice, slice1window_change_0_15_choice : natural range 0 to 1023;
    variable slice2cost_column_0_0_choice, slice2cost_column_0_0_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_1_choice, slice2cost_column_0_1_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_2_choice, slice2cost_column_0_2_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_3_choice, slice2cost_column_0_3_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_4_choice, slice2cost_column_0_4_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_5_choice, slice2cost_column_0_5_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_6_choice, slice2cost_column_0_6_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_7_choice, slice2cost_column_0_7_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_8_choice, slice2cost_column_0_8_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_9_choice, slice2cost_column_0_9_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_10_choice, slice2cost_column_0_10_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_11_choice, slice2cost_column_0_11_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_12_choice, slice2cost_column_0_12_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_13_choice, slice2cost_column_0_13_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_14_choice, slice2cost_column_0_14_choice_2 : natural range 0 to 1023;
    variable slice2cost_column_0_15_choice, slice2cost_column_0_15_choice_2 : natural range 0 to 1023;
    variable slice2window_change_0_0_choice, slice2window_change_0_1_choice : natural range 0 to 1023;
    variable slice2window_change_0_2_choice, slice2window_change_0_3_choice : natural range 0 to 1023;
    variable slice2window_change_0_4_choice, slice2window_change_0_5_choice : natural range 0 to 1023;
    variable slice2window_change_0_6_choice, slice2window_change_0_7_choice : natural range 0 to 1023;
    variable slice2window_change_0_8_choice, slice2window_change_0_9_choice : natural range 0 to 1023;
    variable slice2window_change_0_10_choice, slice2window_change_0_11_choice : natural range 0 to 1023;
    variable slice2window_change_0_12_choice, slice2window_change_0_13_choice : natural range 0 to 1023;
    variable slice2window_change_0_14_choice, slice2window_change_0_15_choice : natural range 0 to 1023;
    variable slice3cost_column_0_0_choice, slice3cost_column_0_0_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_1_choice, slice3cost_column_0_1_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_2_choice, slice3cost_column_0_2_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_3_choice, slice3cost_column_0_3_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_4_choice, slice3cost_column_0_4_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_5_choice, slice3cost_column_0_5_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_6_choice, slice3cost_column_0_6_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_7_choice, slice3cost_column_0_7_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_8_choice, slice3cost_column_0_8_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_9_choice, slice3cost_column_0_9_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_10_choice, slice3cost_column_0_10_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_11_choice, slice3cost_column_0_11_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_12_choice, slice3cost_column_0_12_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_13_choice, slice3cost_column_0_13_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_14_choice, slice3cost_column_0_14_choice_2 : natural range 0 to 1023;
    variable slice3cost_column_0_15_choice, slice3cost_column_0_15_choice_2 : natural range 0 to 1023;
    variable slice3window_change_0_0_choice, slice3window_change_0_1_choice : natural range 0 to 1023;
    variable slice3window_change_0_2_choice, slice3window_change_0_3_choice : natural range 0 to 1023;
    variable slice3window_change_0_4_choice, slice3window_change_0_5_choice : natural range 0 to 1023;
    variable slice3window_change_0_6_choice, slice3window_change_0_7_choice : natural range 0 to 1023;
    variable slice3window_change_0_8_choice, slice3window_change_0_9_choice : natural range 0 to 1023;
    variable slice3window_change_0_10_choice, slice3window_change_0_11_choice : natural range 0 to 1023;
    variable slice3window_change_0_12_choice, slice3window_change_0_13_choice : natural range 0 to 1023;
    variable slice3window_change_0_14_choice, slice3window_change_0_15_choice : natural range 0 to 1023;
    variable texturecost_column_0_0_choice, texturecost_column_0_0_choice_2 : natural range 0 to 1023;
    variable texturewindow_change_0_0_choice : natural range 0 to 1023;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 16383;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 16383;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 16383;
    variable slice0window_sum_0_6_choice, slice0window_sum_0_7_choice : natural range 0 to 16383;
    variable slice0window_sum_0_8_choice, slice0window_sum_0_9_choice : natural range 0 to 16383;
    variable slice0window_sum_0_10_choice, slice0window_sum_0_11_choice : natural range 0 to 16383;
    variable slice0window_sum_0_12_choice, slice0window_sum_0_13_choice : natural range 0 to 16383;
    variable slice0window_sum_0_14_choice, slice0window_sum_0_15_choice : natural range 0 to 16383;
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_below_0_1_choice : natural range 0 to 16383;
    variable slice0winner2_best_below_0_2_choice, slice0winner2_best_below_0_3_choice : natural range 0 to 16383;
    variable slice0winner2_best_above_0_0_choice, slice0winner2_best_above_0_1_choice : natural range 0 to 16383;
    variable slice0winner2_best_above_0_2_choice, slice0winner2_best_above_0_3_choice : natural range 0 to 16383;
    variable slice0winner2_best_second_0_0_choice, slice0winner2_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_0_choice_3, slice0winner2_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_1_choice, slice0winner2_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_1_choice_3, slice0winner2_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_2_choice, slice0winner2_best_second_0_2_choice_2 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_2_choice_3, slice0winner2_best_second_0_2_choice_4 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_3_choice, slice0winner2_best_second_0_3_choice_2 : natural range 0 to 16383;
    variable slice0winner2_best_second_0_3_choice_3, slice0winner2_best_second_0_3_choice_4 : natural range 0 to 16383;
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_below_0_1_choice : natural range 0 to 16383;
    variable slice0winner3_best_above_0_0_choice, slice0winner3_best_above_0_1_choice : natural range 0 to 16383;
    variable slice0winner3_best_second_0_0_choice, slice0winner3_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice0winner3_best_second_0_0_choice_3, slice0winner3_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice0winner3_best_second_0_1_choice, slice0winner3_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice0winner3_best_second_0_1_choice_3, slice0winner3_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice0winner4_best_second_0_0_choice, slice0winner4_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice0winner4_best_second_0_0_choice_3, slice0winner4_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice1window_sum_0_0_choice, slice1window_sum_0_1_choice : natural range 0 to 16383;
    variable slice1window_sum_0_2_choice, slice1window_sum_0_3_choice : natural range 0 to 16383;
    variable slice1window_sum_0_4_choice, slice1window_sum_0_5_choice : natural range 0 to 16383;
    variable slice1window_sum_0_6_choice, slice1window_sum_0_7_choice : natural range 0 to 16383;
    variable slice1window_sum_0_8_choice, slice1window_sum_0_9_choice : natural range 0 to 16383;
    variable slice1window_sum_0_10_choice, slice1window_sum_0_11_choice : natural range 0 to 16383;
    variable slice1window_sum_0_12_choice, slice1window_sum_0_13_choice : natural range 0 to 16383;
    variable slice1window_sum_0_14_choice, slice1window_sum_0_15_choice : natural range 0 to 16383;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_below_0_1_choice : natural range 0 to 16383;
    variable slice1winner2_best_below_0_2_choice, slice1winner2_best_below_0_3_choice : natural range 0 to 16383;
    variable slice1winner2_best_above_0_0_choice, slice1winner2_best_above_0_1_choice : natural range 0 to 16383;
    variable slice1winner2_best_above_0_2_choice, slice1winner2_best_above_0_3_choice : natural range 0 to 16383;
    variable slice1winner2_best_second_0_0_choice, slice1winner2_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_0_choice_3, slice1winner2_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_1_choice, slice1winner2_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_1_choice_3, slice1winner2_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_2_choice, slice1winner2_best_second_0_2_choice_2 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_2_choice_3, slice1winner2_best_second_0_2_choice_4 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_3_choice, slice1winner2_best_second_0_3_choice_2 : natural range 0 to 16383;
    variable slice1winner2_best_second_0_3_choice_3, slice1winner2_best_second_0_3_choice_4 : natural range 0 to 16383;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_below_0_1_choice : natural range 0 to 16383;
    variable slice1winner3_best_above_0_0_choice, slice1winner3_best_above_0_1_choice : natural range 0 to 16383;
    variable slice1winner3_best_second_0_0_choice, slice1winner3_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice1winner3_best_second_0_0_choice_3, slice1winner3_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice1winner3_best_second_0_1_choice, slice1winner3_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice1winner3_best_second_0_1_choice_3, slice1winner3_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice1winner4_best_second_0_0_choice, slice1winner4_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice1winner4_best_second_0_0_choice_3, slice1winner4_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 16383;
    variable slice1_best_second_0_0_choice, slice1_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice1_best_second_0_0_choice_3, slice1_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice2window_sum_0_0_choice, slice2window_sum_0_1_choice : natural range 0 to 16383;
    variable slice2window_sum_0_2_choice, slice2window_sum_0_3_choice : natural range 0 to 16383;
    variable slice2window_sum_0_4_choice, slice2window_sum_0_5_choice : natural range 0 to 16383;
    variable slice2window_sum_0_6_choice, slice2window_sum_0_7_choice : natural range 0 to 16383;
    variable slice2window_sum_0_8_choice, slice2window_sum_0_9_choice : natural range 0 to 16383;
    variable slice2window_sum_0_10_choice, slice2window_sum_0_11_choice : natural range 0 to 16383;
    variable slice2window_sum_0_12_choice, slice2window_sum_0_13_choice : natural range 0 to 16383;
    variable slice2window_sum_0_14_choice, slice2window_sum_0_15_choice : natural range 0 to 16383;
    variable slice2winner2_best_below_0_0_choice, slice2winner2_best_below_0_1_choice : natural range 0 to 16383;
    variable slice2winner2_best_below_0_2_choice, slice2winner2_best_below_0_3_choice : natural range 0 to 16383;
    variable slice2winner2_best_above_0_0_choice, slice2winner2_best_above_0_1_choice : natural range 0 to 16383;
    variable slice2winner2_best_above_0_2_choice, slice2winner2_best_above_0_3_choice : natural range 0 to 16383;
    variable slice2winner2_best_second_0_0_choice, slice2winner2_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_0_choice_3, slice2winner2_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_1_choice, slice2winner2_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_1_choice_3, slice2winner2_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_2_choice, slice2winner2_best_second_0_2_choice_2 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_2_choice_3, slice2winner2_best_second_0_2_choice_4 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_3_choice, slice2winner2_best_second_0_3_choice_2 : natural range 0 to 16383;
    variable slice2winner2_best_second_0_3_choice_3, slice2winner2_best_second_0_3_choice_4 : natural range 0 to 16383;
    variable slice2winner3_best_below_0_0_choice, slice2winner3_best_below_0_1_choice : natural range 0 to 16383;
    variable slice2winner3_best_above_0_0_choice, slice2winner3_best_above_0_1_choice : natural range 0 to 16383;
    variable slice2winner3_best_second_0_0_choice, slice2winner3_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice2winner3_best_second_0_0_choice_3, slice2winner3_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice2winner3_best_second_0_1_choice, slice2winner3_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice2winner3_best_second_0_1_choice_3, slice2winner3_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice2winner4_best_second_0_0_choice, slice2winner4_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice2winner4_best_second_0_0_choice_3, slice2winner4_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice2_best_below_0_0_choice, slice2_best_above_0_0_choice : natural range 0 to 16383;
    variable slice2_best_second_0_0_choice, slice2_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice2_best_second_0_0_choice_3, slice2_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice3window_sum_0_0_choice, slice3window_sum_0_1_choice : natural range 0 to 16383;
    variable slice3window_sum_0_2_choice, slice3window_sum_0_3_choice : natural range 0 to 16383;
    variable slice3window_sum_0_4_choice, slice3window_sum_0_5_choice : natural range 0 to 16383;
    variable slice3window_sum_0_6_choice, slice3window_sum_0_7_choice : natural range 0 to 16383;
    variable slice3window_sum_0_8_choice, slice3window_sum_0_9_choice : natural range 0 to 16383;
    variable slice3window_sum_0_10_choice, slice3window_sum_0_11_choice : natural range 0 to 16383;
    variable slice3window_sum_0_12_choice, slice3window_sum_0_13_choice : natural range 0 to 16383;
    variable slice3window_sum_0_14_choice, slice3window_sum_0_15_choice : natural range 0 to 16383;
    variable slice3winner2_best_below_0_0_choice, slice3winner2_best_below_0_1_choice : natural range 0 to 16383;
    variable slice3winner2_best_below_0_2_choice, slice3winner2_best_below_0_3_choice : natural range 0 to 16383;
    variable slice3winner2_best_above_0_0_choice, slice3winner2_best_above_0_1_choice : natural range 0 to 16383;
    variable slice3winner2_best_above_0_2_choice, slice3winner2_best_above_0_3_choice : natural range 0 to 16383;
    variable slice3winner2_best_second_0_0_choice, slice3winner2_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_0_choice_3, slice3winner2_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_1_choice, slice3winner2_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_1_choice_3, slice3winner2_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_2_choice, slice3winner2_best_second_0_2_choice_2 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_2_choice_3, slice3winner2_best_second_0_2_choice_4 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_3_choice, slice3winner2_best_second_0_3_choice_2 : natural range 0 to 16383;
    variable slice3winner2_best_second_0_3_choice_3, slice3winner2_best_second_0_3_choice_4 : natural range 0 to 16383;
    variable slice3winner3_best_below_0_0_choice, slice3winner3_best_below_0_1_choice : natural range 0 to 16383;
    variable slice3winner3_best_above_0_0_choice, slice3winner3_best_above_0_1_choice : natural range 0 to 16383;
    variable slice3winner3_best_second_0_0_choice, slice3winner3_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice3winner3_best_second_0_0_choice_3, slice3winner3_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice3winner3_best_second_0_1_choice, slice3winner3_best_second_0_1_choice_2 : natural range 0 to 16383;
    variable slice3winner3_best_second_0_1_choice_3, slice3winner3_best_second_0_1_choice_4 : natural range 0 to 16383;
    variable slice3winner4_best_below_0_0_choice, slice3winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice3winner4_best_second_0_0_choice, slice3winner4_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice3winner4_best_second_0_0_choice_3, slice3winner4_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable slice3_best_below_0_0_choice, slice3_best_above_0_0_choice : natural range 0 to 16383;
    variable slice3_best_second_0_0_choice, slice3_best_second_0_0_choice_2 : natural range 0 to 16383;
    variable slice3_best_second_0_0_choice_3, slice3_best_second_0_0_choice_4 : natural range 0 to 16383;
    variable texturewindow_sum_0_0_choice, refinement_divisor_0_0_choice : natural range 0 to 16383;
    variable refinement_remainder_1_0_difference : natural range 16385 to 49151;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 16385 to 65534;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 16385 to 65534;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 16385 to 65534;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_group = 374;
      transform_counter_group_is_equal_2 := transform_counter_column = 449;
      if transform_counter_group_is_equal and transform_counter_group_is_equal_2 then
        transform_counter_group_choice := 375;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 376;
      if (transform_counter_group = 375) and transform_counter_next_frame then
        transform_counter_group_choice_2 := 1;
      else
        transform_counter_group_choice_2 := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and transform_counter_group_is_equal_2 and in_valid then
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      else
        transform_counter_group_choice_3 := transform_counter_group;
      end if;
      transform_read_column_inside_0_differs := transform_counter_column /= 0;
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
      if 31 < transform_right_filter_slope_0 then
        transform_right_filter_feature_0_choice := 62;
      else
        transform_right_filter_feature_0_choice := (transform_right_filter_slope_0 + 31) mod 128;
      end if;
      if transform_right_filter_slope_0 < (-31) then
        transform_right_filter_feature_0_choice_2 := 0;
      else
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 375;
      transform_read_row_inside_2 <= transform_counter_group < 375;
      transform_read_column_inside_0 <= transform_read_column_inside_0_differs;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_differs;
      transform_read_start_of_frame <= (transform_counter_group = 1) and (transform_counter_column = 1);
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
      transform_left_filter_slope_0 <= transform_left_filter_column_0_0 - transform_left_filter_column_2_0;
      transform_left_filter_whole <= transform_filtering_0_column_inside_2 and transform_filtering_0_column_inside_0;
      transform_right_filter_slope_0 <= transform_right_filter_column_0_0 - transform_right_filter_column_2_0;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      transform_filtering_2_start_of_frame <= transform_filtering_1_start_of_frame;
      transform_filtering_2_valid <= transform_filtering_1_valid;
      if in_start_of_frame and in_valid then
        transform_counter_group <= transform_counter_group_choice;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if transform_left_filter_whole then
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_2;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_2;
      else
        transform_left_filter_feature_0 <= 31;
        transform_right_filter_feature_0 <= 31;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 375) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choice_3 := transform_counter_group_is_equal_2 or (not in_start_of_frame);
      else
        transform_counter_next_frame_choice_3 := not in_start_of_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal_2 or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= transform_counter_next_frame_choice_3;
        else
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_newest_0 * 256) +
          (transform_left_rows_ready_words_0 / 256);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_newest_0 * 256) +
          (transform_right_rows_ready_words_0 / 256);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_row_inside_0 then
        transform_left_filter_column_0_0_choice := transform_left_column_0;
      else
        transform_left_filter_column_0_0_choice := transform_left_column_2;
      end if;
      if transform_columns_row_inside_2 then
        transform_left_filter_column_0_0_choice_2 := transform_left_column_2;
      else
        transform_left_filter_column_0_0_choice_2 := transform_left_column_0;
      end if;
      if transform_columns_row_inside_2 then
        transform_left_filter_column_0_0_choice_3 := (transform_left_column_2 mod 2) = 1;
      else
        transform_left_filter_column_0_0_choice_3 := (transform_left_column_0 mod 2) = 1;
      end if;
      if transform_columns_row_inside_0 then
        transform_right_filter_column_0_0_choice := transform_right_column_0;
      else
        transform_right_filter_column_0_0_choice := transform_right_column_2;
      end if;
      if transform_columns_row_inside_2 then
        transform_right_filter_column_0_0_choice_2 := transform_right_column_2;
      else
        transform_right_filter_column_0_0_choice_2 := transform_right_column_0;
      end if;
      if transform_columns_row_inside_2 then
        transform_right_filter_column_0_0_choice_3 := (transform_right_column_2 mod 2) = 1;
      else
        transform_right_filter_column_0_0_choice_3 := (transform_right_column_0 mod 2) = 1;
      end if;
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
      raster_place_group_is_equal := raster_place_column = 449;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_2_valid;
      if transform_filtering_2_start_of_frame and transform_filtering_2_valid then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 382) and
          raster_place_group_is_equal and transform_filtering_2_valid))) mod 512;
      end if;
      if transform_filtering_2_valid then
        if raster_place_group_is_equal or transform_filtering_2_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 15) and (raster_place_group < 390);
      delay_row_inside_1 <= raster_place_group < 375;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 63;
      delay_tag_first_cost <= raster_place_column = 63;
      delay_tag_leaves_window <= (((((raster_place_column / 2) + 32729) mod 32768) * 2) + (raster_place_column mod 2))
        < 65465;
      delay_tag_output_column <= (raster_place_group >= 7) and (raster_place_group < 382) and ((((((raster_place_column
        / 64) + 1023) mod 1024) * 64) + (raster_place_column mod 64)) < 386);
      delay_tag_start_of_frame <= (raster_place_group = 7) and (raster_place_column = 64);
      delay_tag_end_of_line <= raster_place_group_is_equal;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_words_3 <= to_integer(rows_search_rows_read_words_3);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
      rows_reference_rows_ready_words_3 <= to_integer(rows_reference_rows_read_words_3);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_first_cost <= rows_read_tag_first_cost;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_inside_0 <= rows_ready_inside_0;
      rows_inside_1 <= rows_ready_inside_1;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_output_column <= rows_ready_tag_output_column;
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
        rows_search_1 <= rows_search_rows_ready_newest_0;
        rows_reference_1 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 128) + ((rows_search_rows_ready_words_1 mod
          128) * 2097152);
        rows_search_rows_write_words_1 <= (rows_search_rows_ready_words_1 / 128) + ((rows_search_rows_ready_words_2 mod
          128) * 2097152);
        rows_search_rows_write_words_2 <= (rows_search_rows_ready_words_2 / 128) + ((rows_search_rows_ready_words_3 mod
          128) * 2097152);
        rows_search_rows_write_words_3 <= (rows_search_rows_ready_words_3 / 128) + (rows_search_rows_ready_newest_0 *
          16384);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 128) +
          ((rows_reference_rows_ready_words_1 mod 128) * 2097152);
        rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_words_1 / 128) +
          ((rows_reference_rows_ready_words_2 mod 128) * 2097152);
        rows_reference_rows_write_words_2 <= (rows_reference_rows_ready_words_2 / 128) +
          ((rows_reference_rows_ready_words_3 mod 128) * 2097152);
        rows_reference_rows_write_words_3 <= (rows_reference_rows_ready_words_3 / 128) +
          (rows_reference_rows_ready_newest_0 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= rows_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_0_3 <= slice0shift_search_0_2;
        slice0shift_search_0_4 <= slice0shift_search_0_3;
        slice0shift_search_0_5 <= slice0shift_search_0_4;
        slice0shift_search_0_6 <= slice0shift_search_0_5;
        slice0shift_search_0_7 <= slice0shift_search_0_6;
        slice0shift_search_0_8 <= slice0shift_search_0_7;
        slice0shift_search_0_9 <= slice0shift_search_0_8;
        slice0shift_search_0_10 <= slice0shift_search_0_9;
        slice0shift_search_0_11 <= slice0shift_search_0_10;
        slice0shift_search_0_12 <= slice0shift_search_0_11;
        slice0shift_search_0_13 <= slice0shift_search_0_12;
        slice0shift_search_0_14 <= slice0shift_search_0_13;
        slice0shift_search_0_15 <= slice0shift_search_0_14;
        slice0shift_search_1_0 <= rows_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_1_3 <= slice0shift_search_1_2;
        slice0shift_search_1_4 <= slice0shift_search_1_3;
        slice0shift_search_1_5 <= slice0shift_search_1_4;
        slice0shift_search_1_6 <= slice0shift_search_1_5;
        slice0shift_search_1_7 <= slice0shift_search_1_6;
        slice0shift_search_1_8 <= slice0shift_search_1_7;
        slice0shift_search_1_9 <= slice0shift_search_1_8;
        slice0shift_search_1_10 <= slice0shift_search_1_9;
        slice0shift_search_1_11 <= slice0shift_search_1_10;
        slice0shift_search_1_12 <= slice0shift_search_1_11;
        slice0shift_search_1_13 <= slice0shift_search_1_12;
        slice0shift_search_1_14 <= slice0shift_search_1_13;
        slice0shift_search_1_15 <= slice0shift_search_1_14;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_search_out_0 <= slice0shift_search_0_15;
      slice0shift_search_out_1 <= slice0shift_search_1_15;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_row_start <= rows_tag_row_start;
      slice0shift_tag_first_group <= rows_tag_first_group;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0_choice_2 := 0;
      else
        slice0cost_column_0_0_choice_2 := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := (slice0cost_ready_words_0 / 1024) mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_1_choice_2 := 0;
      else
        slice0cost_column_0_1_choice_2 := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := slice0cost_ready_words_0 / 1048576;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_2_choice_2 := 0;
      else
        slice0cost_column_0_2_choice_2 := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := slice0cost_ready_words_1 mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_3_choice_2 := 0;
      else
        slice0cost_column_0_3_choice_2 := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := (slice0cost_ready_words_1 / 1024) mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_4_choice_2 := 0;
      else
        slice0cost_column_0_4_choice_2 := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := slice0cost_ready_words_1 / 1048576;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_5_choice_2 := 0;
      else
        slice0cost_column_0_5_choice_2 := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := slice0cost_ready_words_2 mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_6_choice_2 := 0;
      else
        slice0cost_column_0_6_choice_2 := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := (slice0cost_ready_words_2 / 1024) mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_7_choice_2 := 0;
      else
        slice0cost_column_0_7_choice_2 := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_8_choice := 0;
      else
        slice0cost_column_0_8_choice := slice0cost_ready_words_2 / 1048576;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_8_choice_2 := 0;
      else
        slice0cost_column_0_8_choice_2 := (slice0cost_change_0_8 + slice0cost_column_0_8_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_9_choice := 0;
      else
        slice0cost_column_0_9_choice := slice0cost_ready_words_3 mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_9_choice_2 := 0;
      else
        slice0cost_column_0_9_choice_2 := (slice0cost_change_0_9 + slice0cost_column_0_9_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_10_choice := 0;
      else
        slice0cost_column_0_10_choice := (slice0cost_ready_words_3 / 1024) mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_10_choice_2 := 0;
      else
        slice0cost_column_0_10_choice_2 := (slice0cost_change_0_10 + slice0cost_column_0_10_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_11_choice := 0;
      else
        slice0cost_column_0_11_choice := slice0cost_ready_words_3 / 1048576;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_11_choice_2 := 0;
      else
        slice0cost_column_0_11_choice_2 := (slice0cost_change_0_11 + slice0cost_column_0_11_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_12_choice := 0;
      else
        slice0cost_column_0_12_choice := slice0cost_ready_words_4 mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_12_choice_2 := 0;
      else
        slice0cost_column_0_12_choice_2 := (slice0cost_change_0_12 + slice0cost_column_0_12_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_13_choice := 0;
      else
        slice0cost_column_0_13_choice := (slice0cost_ready_words_4 / 1024) mod 1024;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_13_choice_2 := 0;
      else
        slice0cost_column_0_13_choice_2 := (slice0cost_change_0_13 + slice0cost_column_0_13_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_14_choice := 0;
      else
        slice0cost_column_0_14_choice := slice0cost_ready_words_4 / 1048576;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_14_choice_2 := 0;
      else
        slice0cost_column_0_14_choice_2 := (slice0cost_change_0_14 + slice0cost_column_0_14_choice) mod 1024;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_15_choice := 0;
      else
        slice0cost_column_0_15_choice := slice0cost_ready_words_5;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_15_choice_2 := 0;
      else
        slice0cost_column_0_15_choice_2 := (slice0cost_change_0_15 + slice0cost_column_0_15_choice) mod 1024;
      end if;
      slice0cost_pixels_first_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_pixels_first_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_pixels_first_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_pixels_first_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_pixels_first_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_pixels_first_0_5 <= slice0shift_search_0_5 - slice0shift_reference_0;
      slice0cost_pixels_first_0_6 <= slice0shift_search_0_6 - slice0shift_reference_0;
      slice0cost_pixels_first_0_7 <= slice0shift_search_0_7 - slice0shift_reference_0;
      slice0cost_pixels_first_0_8 <= slice0shift_search_0_8 - slice0shift_reference_0;
      slice0cost_pixels_first_0_9 <= slice0shift_search_0_9 - slice0shift_reference_0;
      slice0cost_pixels_first_0_10 <= slice0shift_search_0_10 - slice0shift_reference_0;
      slice0cost_pixels_first_0_11 <= slice0shift_search_0_11 - slice0shift_reference_0;
      slice0cost_pixels_first_0_12 <= slice0shift_search_0_12 - slice0shift_reference_0;
      slice0cost_pixels_first_0_13 <= slice0shift_search_0_13 - slice0shift_reference_0;
      slice0cost_pixels_first_0_14 <= slice0shift_search_0_14 - slice0shift_reference_0;
      slice0cost_pixels_first_0_15 <= slice0shift_search_0_15 - slice0shift_reference_0;
      slice0cost_pixels_first_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_pixels_first_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_pixels_first_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_pixels_first_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_pixels_first_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_pixels_first_1_5 <= slice0shift_search_1_5 - slice0shift_reference_1;
      slice0cost_pixels_first_1_6 <= slice0shift_search_1_6 - slice0shift_reference_1;
      slice0cost_pixels_first_1_7 <= slice0shift_search_1_7 - slice0shift_reference_1;
      slice0cost_pixels_first_1_8 <= slice0shift_search_1_8 - slice0shift_reference_1;
      slice0cost_pixels_first_1_9 <= slice0shift_search_1_9 - slice0shift_reference_1;
      slice0cost_pixels_first_1_10 <= slice0shift_search_1_10 - slice0shift_reference_1;
      slice0cost_pixels_first_1_11 <= slice0shift_search_1_11 - slice0shift_reference_1;
      slice0cost_pixels_first_1_12 <= slice0shift_search_1_12 - slice0shift_reference_1;
      slice0cost_pixels_first_1_13 <= slice0shift_search_1_13 - slice0shift_reference_1;
      slice0cost_pixels_first_1_14 <= slice0shift_search_1_14 - slice0shift_reference_1;
      slice0cost_pixels_first_1_15 <= slice0shift_search_1_15 - slice0shift_reference_1;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= folded(slice0cost_pixels_first_0_0) + as_number((slice0cost_pixels_first_0_0 < 0));
      slice0cost_pixels_cost_0_1 <= folded(slice0cost_pixels_first_0_1) + as_number((slice0cost_pixels_first_0_1 < 0));
      slice0cost_pixels_cost_0_2 <= folded(slice0cost_pixels_first_0_2) + as_number((slice0cost_pixels_first_0_2 < 0));
      slice0cost_pixels_cost_0_3 <= folded(slice0cost_pixels_first_0_3) + as_number((slice0cost_pixels_first_0_3 < 0));
      slice0cost_pixels_cost_0_4 <= folded(slice0cost_pixels_first_0_4) + as_number((slice0cost_pixels_first_0_4 < 0));
      slice0cost_pixels_cost_0_5 <= folded(slice0cost_pixels_first_0_5) + as_number((slice0cost_pixels_first_0_5 < 0));
      slice0cost_pixels_cost_0_6 <= folded(slice0cost_pixels_first_0_6) + as_number((slice0cost_pixels_first_0_6 < 0));
      slice0cost_pixels_cost_0_7 <= folded(slice0cost_pixels_first_0_7) + as_number((slice0cost_pixels_first_0_7 < 0));
      slice0cost_pixels_cost_0_8 <= folded(slice0cost_pixels_first_0_8) + as_number((slice0cost_pixels_first_0_8 < 0));
      slice0cost_pixels_cost_0_9 <= folded(slice0cost_pixels_first_0_9) + as_number((slice0cost_pixels_first_0_9 < 0));
      slice0cost_pixels_cost_0_10 <= folded(slice0cost_pixels_first_0_10) + as_number((slice0cost_pixels_first_0_10 <
        0));
      slice0cost_pixels_cost_0_11 <= folded(slice0cost_pixels_first_0_11) + as_number((slice0cost_pixels_first_0_11 <
        0));
      slice0cost_pixels_cost_0_12 <= folded(slice0cost_pixels_first_0_12) + as_number((slice0cost_pixels_first_0_12 <
        0));
      slice0cost_pixels_cost_0_13 <= folded(slice0cost_pixels_first_0_13) + as_number((slice0cost_pixels_first_0_13 <
        0));
      slice0cost_pixels_cost_0_14 <= folded(slice0cost_pixels_first_0_14) + as_number((slice0cost_pixels_first_0_14 <
        0));
      slice0cost_pixels_cost_0_15 <= folded(slice0cost_pixels_first_0_15) + as_number((slice0cost_pixels_first_0_15 <
        0));
      slice0cost_pixels_cost_1_0 <= folded(slice0cost_pixels_first_1_0) + as_number((slice0cost_pixels_first_1_0 < 0));
      slice0cost_pixels_cost_1_1 <= folded(slice0cost_pixels_first_1_1) + as_number((slice0cost_pixels_first_1_1 < 0));
      slice0cost_pixels_cost_1_2 <= folded(slice0cost_pixels_first_1_2) + as_number((slice0cost_pixels_first_1_2 < 0));
      slice0cost_pixels_cost_1_3 <= folded(slice0cost_pixels_first_1_3) + as_number((slice0cost_pixels_first_1_3 < 0));
      slice0cost_pixels_cost_1_4 <= folded(slice0cost_pixels_first_1_4) + as_number((slice0cost_pixels_first_1_4 < 0));
      slice0cost_pixels_cost_1_5 <= folded(slice0cost_pixels_first_1_5) + as_number((slice0cost_pixels_first_1_5 < 0));
      slice0cost_pixels_cost_1_6 <= folded(slice0cost_pixels_first_1_6) + as_number((slice0cost_pixels_first_1_6 < 0));
      slice0cost_pixels_cost_1_7 <= folded(slice0cost_pixels_first_1_7) + as_number((slice0cost_pixels_first_1_7 < 0));
      slice0cost_pixels_cost_1_8 <= folded(slice0cost_pixels_first_1_8) + as_number((slice0cost_pixels_first_1_8 < 0));
      slice0cost_pixels_cost_1_9 <= folded(slice0cost_pixels_first_1_9) + as_number((slice0cost_pixels_first_1_9 < 0));
      slice0cost_pixels_cost_1_10 <= folded(slice0cost_pixels_first_1_10) + as_number((slice0cost_pixels_first_1_10 <
        0));
      slice0cost_pixels_cost_1_11 <= folded(slice0cost_pixels_first_1_11) + as_number((slice0cost_pixels_first_1_11 <
        0));
      slice0cost_pixels_cost_1_12 <= folded(slice0cost_pixels_first_1_12) + as_number((slice0cost_pixels_first_1_12 <
        0));
      slice0cost_pixels_cost_1_13 <= folded(slice0cost_pixels_first_1_13) + as_number((slice0cost_pixels_first_1_13 <
        0));
      slice0cost_pixels_cost_1_14 <= folded(slice0cost_pixels_first_1_14) + as_number((slice0cost_pixels_first_1_14 <
        0));
      slice0cost_pixels_cost_1_15 <= folded(slice0cost_pixels_first_1_15) + as_number((slice0cost_pixels_first_1_15 <
        0));
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_change_0_0 <= slice0cost_pixels_cost_1_0 - slice0cost_pixels_cost_0_0;
      slice0cost_change_0_1 <= slice0cost_pixels_cost_1_1 - slice0cost_pixels_cost_0_1;
      slice0cost_change_0_2 <= slice0cost_pixels_cost_1_2 - slice0cost_pixels_cost_0_2;
      slice0cost_change_0_3 <= slice0cost_pixels_cost_1_3 - slice0cost_pixels_cost_0_3;
      slice0cost_change_0_4 <= slice0cost_pixels_cost_1_4 - slice0cost_pixels_cost_0_4;
      slice0cost_change_0_5 <= slice0cost_pixels_cost_1_5 - slice0cost_pixels_cost_0_5;
      slice0cost_change_0_6 <= slice0cost_pixels_cost_1_6 - slice0cost_pixels_cost_0_6;
      slice0cost_change_0_7 <= slice0cost_pixels_cost_1_7 - slice0cost_pixels_cost_0_7;
      slice0cost_change_0_8 <= slice0cost_pixels_cost_1_8 - slice0cost_pixels_cost_0_8;
      slice0cost_change_0_9 <= slice0cost_pixels_cost_1_9 - slice0cost_pixels_cost_0_9;
      slice0cost_change_0_10 <= slice0cost_pixels_cost_1_10 - slice0cost_pixels_cost_0_10;
      slice0cost_change_0_11 <= slice0cost_pixels_cost_1_11 - slice0cost_pixels_cost_0_11;
      slice0cost_change_0_12 <= slice0cost_pixels_cost_1_12 - slice0cost_pixels_cost_0_12;
      slice0cost_change_0_13 <= slice0cost_pixels_cost_1_13 - slice0cost_pixels_cost_0_13;
      slice0cost_change_0_14 <= slice0cost_pixels_cost_1_14 - slice0cost_pixels_cost_0_14;
      slice0cost_change_0_15 <= slice0cost_pixels_cost_1_15 - slice0cost_pixels_cost_0_15;
      slice0cost_ready_words_0 <= to_integer(slice0cost_read_words_0);
      slice0cost_ready_words_1 <= to_integer(slice0cost_read_words_1);
      slice0cost_ready_words_2 <= to_integer(slice0cost_read_words_2);
      slice0cost_ready_words_3 <= to_integer(slice0cost_read_words_3);
      slice0cost_ready_words_4 <= to_integer(slice0cost_read_words_4);
      slice0cost_ready_words_5 <= to_integer(slice0cost_read_words_5);
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_column_0_0_choice_2;
      slice0cost_column_0_1 <= slice0cost_column_0_1_choice_2;
      slice0cost_column_0_2 <= slice0cost_column_0_2_choice_2;
      slice0cost_column_0_3 <= slice0cost_column_0_3_choice_2;
      slice0cost_column_0_4 <= slice0cost_column_0_4_choice_2;
      slice0cost_column_0_5 <= slice0cost_column_0_5_choice_2;
      slice0cost_column_0_6 <= slice0cost_column_0_6_choice_2;
      slice0cost_column_0_7 <= slice0cost_column_0_7_choice_2;
      slice0cost_column_0_8 <= slice0cost_column_0_8_choice_2;
      slice0cost_column_0_9 <= slice0cost_column_0_9_choice_2;
      slice0cost_column_0_10 <= slice0cost_column_0_10_choice_2;
      slice0cost_column_0_11 <= slice0cost_column_0_11_choice_2;
      slice0cost_column_0_12 <= slice0cost_column_0_12_choice_2;
      slice0cost_column_0_13 <= slice0cost_column_0_13_choice_2;
      slice0cost_column_0_14 <= slice0cost_column_0_14_choice_2;
      slice0cost_column_0_15 <= slice0cost_column_0_15_choice_2;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_border_column <= slice0cost_ready_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_ready_tag_first_cost;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_ready_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_ready_tag_end_of_line;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        slice0cost_write_words_0 <= (slice0cost_column_0_1_choice_2 * 1024) + slice0cost_column_0_0_choice_2 +
          (slice0cost_column_0_2_choice_2 * 1048576);
        slice0cost_write_words_1 <= (slice0cost_column_0_4_choice_2 * 1024) + slice0cost_column_0_3_choice_2 +
          (slice0cost_column_0_5_choice_2 * 1048576);
        slice0cost_write_words_2 <= (slice0cost_column_0_7_choice_2 * 1024) + slice0cost_column_0_6_choice_2 +
          (slice0cost_column_0_8_choice_2 * 1048576);
        slice0cost_write_words_3 <= (slice0cost_column_0_10_choice_2 * 1024) + slice0cost_column_0_9_choice_2 +
          (slice0cost_column_0_11_choice_2 * 1048576);
        slice0cost_write_words_4 <= (slice0cost_column_0_13_choice_2 * 1024) + slice0cost_column_0_12_choice_2 +
          (slice0cost_column_0_14_choice_2 * 1048576);
        slice0cost_write_words_5 <= slice0cost_column_0_15_choice_2;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 15 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(9 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(19 downto 10));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_0(29 downto 20));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_1(9 downto 0));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_1(19 downto 10));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_1(29 downto 20));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_6_choice := to_integer(slice0window_leaving_2(9 downto 0));
      else
        slice0window_change_0_6_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_7_choice := to_integer(slice0window_leaving_2(19 downto 10));
      else
        slice0window_change_0_7_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_8_choice := to_integer(slice0window_leaving_2(29 downto 20));
      else
        slice0window_change_0_8_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_9_choice := to_integer(slice0window_leaving_3(9 downto 0));
      else
        slice0window_change_0_9_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_10_choice := to_integer(slice0window_leaving_3(19 downto 10));
      else
        slice0window_change_0_10_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_11_choice := to_integer(slice0window_leaving_3(29 downto 20));
      else
        slice0window_change_0_11_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_12_choice := to_integer(slice0window_leaving_4(9 downto 0));
      else
        slice0window_change_0_12_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_13_choice := to_integer(slice0window_leaving_4(19 downto 10));
      else
        slice0window_change_0_13_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_14_choice := to_integer(slice0window_leaving_4(29 downto 20));
      else
        slice0window_change_0_14_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_15_choice := to_integer(slice0window_leaving_5);
      else
        slice0window_change_0_15_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_0_3 <= slice0cost_column_0_3;
      slice0window_entering_0_4 <= slice0cost_column_0_4;
      slice0window_entering_0_5 <= slice0cost_column_0_5;
      slice0window_entering_0_6 <= slice0cost_column_0_6;
      slice0window_entering_0_7 <= slice0cost_column_0_7;
      slice0window_entering_0_8 <= slice0cost_column_0_8;
      slice0window_entering_0_9 <= slice0cost_column_0_9;
      slice0window_entering_0_10 <= slice0cost_column_0_10;
      slice0window_entering_0_11 <= slice0cost_column_0_11;
      slice0window_entering_0_12 <= slice0cost_column_0_12;
      slice0window_entering_0_13 <= slice0cost_column_0_13;
      slice0window_entering_0_14 <= slice0cost_column_0_14;
      slice0window_entering_0_15 <= slice0cost_column_0_15;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_border_column <= slice0cost_tag_border_column;
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_change_0_0 <= slice0window_entering_0_0 - slice0window_change_0_0_choice;
      slice0window_change_0_1 <= slice0window_entering_0_1 - slice0window_change_0_1_choice;
      slice0window_change_0_2 <= slice0window_entering_0_2 - slice0window_change_0_2_choice;
      slice0window_change_0_3 <= slice0window_entering_0_3 - slice0window_change_0_3_choice;
      slice0window_change_0_4 <= slice0window_entering_0_4 - slice0window_change_0_4_choice;
      slice0window_change_0_5 <= slice0window_entering_0_5 - slice0window_change_0_5_choice;
      slice0window_change_0_6 <= slice0window_entering_0_6 - slice0window_change_0_6_choice;
      slice0window_change_0_7 <= slice0window_entering_0_7 - slice0window_change_0_7_choice;
      slice0window_change_0_8 <= slice0window_entering_0_8 - slice0window_change_0_8_choice;
      slice0window_change_0_9 <= slice0window_entering_0_9 - slice0window_change_0_9_choice;
      slice0window_change_0_10 <= slice0window_entering_0_10 - slice0window_change_0_10_choice;
      slice0window_change_0_11 <= slice0window_entering_0_11 - slice0window_change_0_11_choice;
      slice0window_change_0_12 <= slice0window_entering_0_12 - slice0window_change_0_12_choice;
      slice0window_change_0_13 <= slice0window_entering_0_13 - slice0window_change_0_13_choice;
      slice0window_change_0_14 <= slice0window_entering_0_14 - slice0window_change_0_14_choice;
      slice0window_change_0_15 <= slice0window_entering_0_15 - slice0window_change_0_15_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_group <= slice0window_entering_tag_first_group;
      slice0window_change_tag_border_column <= slice0window_entering_tag_border_column;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_0_choice := 0;
      else
        slice0window_sum_0_0_choice := slice0window_sum_0_0;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_1_choice := 0;
      else
        slice0window_sum_0_1_choice := slice0window_sum_0_1;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_2_choice := 0;
      else
        slice0window_sum_0_2_choice := slice0window_sum_0_2;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_3_choice := 0;
      else
        slice0window_sum_0_3_choice := slice0window_sum_0_3;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_4_choice := 0;
      else
        slice0window_sum_0_4_choice := slice0window_sum_0_4;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_5_choice := 0;
      else
        slice0window_sum_0_5_choice := slice0window_sum_0_5;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_6_choice := 0;
      else
        slice0window_sum_0_6_choice := slice0window_sum_0_6;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_7_choice := 0;
      else
        slice0window_sum_0_7_choice := slice0window_sum_0_7;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_8_choice := 0;
      else
        slice0window_sum_0_8_choice := slice0window_sum_0_8;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_9_choice := 0;
      else
        slice0window_sum_0_9_choice := slice0window_sum_0_9;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_10_choice := 0;
      else
        slice0window_sum_0_10_choice := slice0window_sum_0_10;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_11_choice := 0;
      else
        slice0window_sum_0_11_choice := slice0window_sum_0_11;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_12_choice := 0;
      else
        slice0window_sum_0_12_choice := slice0window_sum_0_12;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_13_choice := 0;
      else
        slice0window_sum_0_13_choice := slice0window_sum_0_13;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_14_choice := 0;
      else
        slice0window_sum_0_14_choice := slice0window_sum_0_14;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_15_choice := 0;
      else
        slice0window_sum_0_15_choice := slice0window_sum_0_15;
      end if;
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 16384;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 16384;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 16384;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 16384;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 16384;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 16384;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 16384;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 16384;
        slice0window_sum_0_8 <= (slice0window_sum_0_8_choice + slice0window_change_0_8) mod 16384;
        slice0window_sum_0_9 <= (slice0window_sum_0_9_choice + slice0window_change_0_9) mod 16384;
        slice0window_sum_0_10 <= (slice0window_sum_0_10_choice + slice0window_change_0_10) mod 16384;
        slice0window_sum_0_11 <= (slice0window_sum_0_11_choice + slice0window_change_0_11) mod 16384;
        slice0window_sum_0_12 <= (slice0window_sum_0_12_choice + slice0window_change_0_12) mod 16384;
        slice0window_sum_0_13 <= (slice0window_sum_0_13_choice + slice0window_change_0_13) mod 16384;
        slice0window_sum_0_14 <= (slice0window_sum_0_14_choice + slice0window_change_0_14) mod 16384;
        slice0window_sum_0_15 <= (slice0window_sum_0_15_choice + slice0window_change_0_15) mod 16384;
      end if;
      -- slice0winner1
      slice0winner1_best_index_0_0_is_not_less := (slice0window_sum_0_0 - slice0window_sum_0_1) >= 0;
      slice0winner1_best_index_0_1_is_less := (slice0window_sum_0_2 - slice0window_sum_0_3) < 0;
      slice0winner1_best_index_0_2_is_less := (slice0window_sum_0_4 - slice0window_sum_0_5) < 0;
      slice0winner1_best_index_0_3_is_less := (slice0window_sum_0_6 - slice0window_sum_0_7) < 0;
      slice0winner1_best_index_0_4_is_less := (slice0window_sum_0_8 - slice0window_sum_0_9) < 0;
      slice0winner1_best_index_0_5_is_less := (slice0window_sum_0_10 - slice0window_sum_0_11) < 0;
      slice0winner1_best_index_0_6_is_less := (slice0window_sum_0_12 - slice0window_sum_0_13) < 0;
      slice0winner1_best_index_0_7_is_less := (slice0window_sum_0_14 - slice0window_sum_0_15) < 0;
      slice0winner1_held_0_0 <= slice0window_sum_0_0;
      slice0winner1_held_0_1 <= slice0window_sum_0_1;
      slice0winner1_held_0_2 <= slice0window_sum_0_2;
      slice0winner1_held_0_3 <= slice0window_sum_0_3;
      slice0winner1_held_0_4 <= slice0window_sum_0_4;
      slice0winner1_held_0_5 <= slice0window_sum_0_5;
      slice0winner1_held_0_6 <= slice0window_sum_0_6;
      slice0winner1_held_0_7 <= slice0window_sum_0_7;
      slice0winner1_held_0_8 <= slice0window_sum_0_8;
      slice0winner1_held_0_9 <= slice0window_sum_0_9;
      slice0winner1_held_0_10 <= slice0window_sum_0_10;
      slice0winner1_held_0_11 <= slice0window_sum_0_11;
      slice0winner1_held_0_12 <= slice0window_sum_0_12;
      slice0winner1_held_0_13 <= slice0window_sum_0_13;
      slice0winner1_held_0_14 <= slice0window_sum_0_14;
      slice0winner1_held_0_15 <= slice0window_sum_0_15;
      slice0winner1_best_index_0_0 <= slice0winner1_best_index_0_0_is_not_less;
      slice0winner1_best_late_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0winner1_best_late_cost_0_1 <= slice0winner1_best_cost_0_1;
      slice0winner1_best_late_cost_0_2 <= slice0winner1_best_cost_0_2;
      slice0winner1_best_late_cost_0_3 <= slice0winner1_best_cost_0_3;
      slice0winner1_best_late_cost_0_4 <= slice0winner1_best_cost_0_4;
      slice0winner1_best_late_cost_0_5 <= slice0winner1_best_cost_0_5;
      slice0winner1_best_late_cost_0_6 <= slice0winner1_best_cost_0_6;
      slice0winner1_best_late_cost_0_7 <= slice0winner1_best_cost_0_7;
      slice0winner1_best_but_first_0_1 <= slice0winner1_held_0_3;
      slice0winner1_best_but_first_0_2 <= slice0winner1_held_0_5;
      slice0winner1_best_but_first_0_3 <= slice0winner1_held_0_7;
      slice0winner1_best_but_first_0_4 <= slice0winner1_held_0_9;
      slice0winner1_best_but_first_0_5 <= slice0winner1_held_0_11;
      slice0winner1_best_but_first_0_6 <= slice0winner1_held_0_13;
      slice0winner1_best_but_first_0_7 <= slice0winner1_held_0_15;
      slice0winner1_best_but_last_0_0 <= slice0winner1_held_0_0;
      slice0winner1_best_but_last_0_1 <= slice0winner1_held_0_2;
      slice0winner1_best_but_last_0_2 <= slice0winner1_held_0_4;
      slice0winner1_best_but_last_0_3 <= slice0winner1_held_0_6;
      slice0winner1_best_but_last_0_4 <= slice0winner1_held_0_8;
      slice0winner1_best_but_last_0_5 <= slice0winner1_held_0_10;
      slice0winner1_best_but_last_0_6 <= slice0winner1_held_0_12;
      slice0winner1_best_but_last_0_7 <= slice0winner1_held_0_14;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if (slice0window_sum_0_1 - slice0window_sum_0_0) < 0 then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
      end if;
      if (slice0window_sum_0_3 - slice0window_sum_0_2) < 0 then
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_3;
      else
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_2;
      end if;
      if (slice0window_sum_0_5 - slice0window_sum_0_4) < 0 then
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_5;
      else
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_4;
      end if;
      if (slice0window_sum_0_7 - slice0window_sum_0_6) < 0 then
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_7;
      else
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_6;
      end if;
      if (slice0window_sum_0_9 - slice0window_sum_0_8) < 0 then
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_9;
      else
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_8;
      end if;
      if (slice0window_sum_0_11 - slice0window_sum_0_10) < 0 then
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_11;
      else
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_10;
      end if;
      if (slice0window_sum_0_13 - slice0window_sum_0_12) < 0 then
        slice0winner1_best_cost_0_6 <= slice0window_sum_0_13;
      else
        slice0winner1_best_cost_0_6 <= slice0window_sum_0_12;
      end if;
      if (slice0window_sum_0_15 - slice0window_sum_0_14) < 0 then
        slice0winner1_best_cost_0_7 <= slice0window_sum_0_15;
      else
        slice0winner1_best_cost_0_7 <= slice0window_sum_0_14;
      end if;
      if slice0winner1_best_index_0_1_is_less then
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0window_sum_0_3;
      else
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_above_0_1 <= 0;
      end if;
      if slice0winner1_best_index_0_2_is_less then
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0window_sum_0_5;
      else
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_above_0_2 <= 0;
      end if;
      if slice0winner1_best_index_0_3_is_less then
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0_3 <= 0;
        slice0winner1_best_above_0_3 <= slice0window_sum_0_7;
      else
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_above_0_3 <= 0;
      end if;
      if slice0winner1_best_index_0_4_is_less then
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0_4 <= 0;
        slice0winner1_best_above_0_4 <= slice0window_sum_0_9;
      else
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0_4 <= slice0window_sum_0_8;
        slice0winner1_best_above_0_4 <= 0;
      end if;
      if slice0winner1_best_index_0_5_is_less then
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0_5 <= 0;
        slice0winner1_best_above_0_5 <= slice0window_sum_0_11;
      else
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0_5 <= slice0window_sum_0_10;
        slice0winner1_best_above_0_5 <= 0;
      end if;
      if slice0winner1_best_index_0_6_is_less then
        slice0winner1_best_index_0_6 <= 12;
        slice0winner1_best_below_0_6 <= 0;
        slice0winner1_best_above_0_6 <= slice0window_sum_0_13;
      else
        slice0winner1_best_index_0_6 <= 13;
        slice0winner1_best_below_0_6 <= slice0window_sum_0_12;
        slice0winner1_best_above_0_6 <= 0;
      end if;
      if slice0winner1_best_index_0_7_is_less then
        slice0winner1_best_index_0_7 <= 14;
        slice0winner1_best_below_0_7 <= 0;
        slice0winner1_best_above_0_7 <= slice0window_sum_0_15;
      else
        slice0winner1_best_index_0_7 <= 15;
        slice0winner1_best_below_0_7 <= slice0window_sum_0_14;
        slice0winner1_best_above_0_7 <= 0;
      end if;
      if slice0winner1_best_index_0_0_is_not_less then
        slice0winner1_best_below_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0window_sum_0_1;
      end if;
      -- slice0winner2
      slice0winner2_best_index_0_0_is_not_less := (slice0winner1_best_cost_0_0 - slice0winner1_best_cost_0_1) >= 0;
      slice0winner2_best_index_0_1_is_not_less := (slice0winner1_best_cost_0_2 - slice0winner1_best_cost_0_3) >= 0;
      slice0winner2_best_index_0_2_is_not_less := (slice0winner1_best_cost_0_4 - slice0winner1_best_cost_0_5) >= 0;
      slice0winner2_best_index_0_3_is_not_less := (slice0winner1_best_cost_0_6 - slice0winner1_best_cost_0_7) >= 0;
      if other_19 then
        slice0winner2_best_below_0_0_choice := slice0winner1_held_0_1;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      if other_20 then
        slice0winner2_best_below_0_1_choice := slice0winner1_held_0_5;
      else
        slice0winner2_best_below_0_1_choice := slice0winner1_best_below_0_3;
      end if;
      if other_21 then
        slice0winner2_best_below_0_2_choice := slice0winner1_held_0_9;
      else
        slice0winner2_best_below_0_2_choice := slice0winner1_best_below_0_5;
      end if;
      if other_22 then
        slice0winner2_best_below_0_3_choice := slice0winner1_held_0_13;
      else
        slice0winner2_best_below_0_3_choice := slice0winner1_best_below_0_7;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_held_0_2;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if ((slice0winner1_best_index_0_2 / 4) = 1) and ((slice0winner1_best_index_0_2 mod 2) = 1) then
        slice0winner2_best_above_0_1_choice := slice0winner1_held_0_6;
      else
        slice0winner2_best_above_0_1_choice := slice0winner1_best_above_0_2;
      end if;
      if ((slice0winner1_best_index_0_4 / 8) = 1) and ((slice0winner1_best_index_0_4 mod 2) = 1) then
        slice0winner2_best_above_0_2_choice := slice0winner1_held_0_10;
      else
        slice0winner2_best_above_0_2_choice := slice0winner1_best_above_0_4;
      end if;
      slice0winner2_best_above_0_3_value := ((slice0winner1_best_index_0_6 / 4) mod 2) = 1;
      if ((slice0winner1_best_index_0_6 / 8) = 1) and slice0winner2_best_above_0_3_value and
        ((slice0winner1_best_index_0_6 mod 2) = 1) then
        slice0winner2_best_above_0_3_choice := slice0winner1_held_0_14;
      else
        slice0winner2_best_above_0_3_choice := slice0winner1_best_above_0_6;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice := 16383;
      else
        slice0winner2_best_second_0_0_choice := slice0winner1_best_late_cost_0_1;
      end if;
      if slice0winner2_best_at_end_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_but_first_0_1;
      else
        slice0winner2_best_second_0_0_choice_2 := slice0winner2_best_second_0_0_choice;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice_3 := slice0winner1_best_late_cost_0_0;
      else
        slice0winner2_best_second_0_0_choice_3 := 16383;
      end if;
      if slice0winner2_best_at_start_0_0 then
        slice0winner2_best_second_0_0_choice_4 := slice0winner1_best_but_last_0_0;
      else
        slice0winner2_best_second_0_0_choice_4 := slice0winner2_best_second_0_0_choice_3;
      end if;
      if slice0winner2_best_place_0_1 then
        slice0winner2_best_second_0_1_choice := 16383;
      else
        slice0winner2_best_second_0_1_choice := slice0winner1_best_late_cost_0_3;
      end if;
      if slice0winner2_best_at_end_0_1 then
        slice0winner2_best_second_0_1_choice_2 := slice0winner1_best_but_first_0_3;
      else
        slice0winner2_best_second_0_1_choice_2 := slice0winner2_best_second_0_1_choice;
      end if;
      if slice0winner2_best_place_0_1 then
        slice0winner2_best_second_0_1_choice_3 := slice0winner1_best_late_cost_0_2;
      else
        slice0winner2_best_second_0_1_choice_3 := 16383;
      end if;
      if slice0winner2_best_at_start_0_1 then
        slice0winner2_best_second_0_1_choice_4 := slice0winner1_best_but_last_0_2;
      else
        slice0winner2_best_second_0_1_choice_4 := slice0winner2_best_second_0_1_choice_3;
      end if;
      if slice0winner2_best_place_0_2 then
        slice0winner2_best_second_0_2_choice := 16383;
      else
        slice0winner2_best_second_0_2_choice := slice0winner1_best_late_cost_0_5;
      end if;
      if slice0winner2_best_at_end_0_2 then
        slice0winner2_best_second_0_2_choice_2 := slice0winner1_best_but_first_0_5;
      else
        slice0winner2_best_second_0_2_choice_2 := slice0winner2_best_second_0_2_choice;
      end if;
      if slice0winner2_best_place_0_2 then
        slice0winner2_best_second_0_2_choice_3 := slice0winner1_best_late_cost_0_4;
      else
        slice0winner2_best_second_0_2_choice_3 := 16383;
      end if;
      if slice0winner2_best_at_start_0_2 then
        slice0winner2_best_second_0_2_choice_4 := slice0winner1_best_but_last_0_4;
      else
        slice0winner2_best_second_0_2_choice_4 := slice0winner2_best_second_0_2_choice_3;
      end if;
      if slice0winner2_best_place_0_3 then
        slice0winner2_best_second_0_3_choice := 16383;
      else
        slice0winner2_best_second_0_3_choice := slice0winner1_best_late_cost_0_7;
      end if;
      if slice0winner2_best_at_end_0_3 then
        slice0winner2_best_second_0_3_choice_2 := slice0winner1_best_but_first_0_7;
      else
        slice0winner2_best_second_0_3_choice_2 := slice0winner2_best_second_0_3_choice;
      end if;
      if slice0winner2_best_place_0_3 then
        slice0winner2_best_second_0_3_choice_3 := slice0winner1_best_late_cost_0_6;
      else
        slice0winner2_best_second_0_3_choice_3 := 16383;
      end if;
      if slice0winner2_best_at_start_0_3 then
        slice0winner2_best_second_0_3_choice_4 := slice0winner1_best_but_last_0_6;
      else
        slice0winner2_best_second_0_3_choice_4 := slice0winner2_best_second_0_3_choice_3;
      end if;
      slice0winner2_best_first_0_1 <= slice0winner1_held_0_4;
      slice0winner2_best_first_0_2 <= slice0winner1_held_0_8;
      slice0winner2_best_first_0_3 <= slice0winner1_held_0_12;
      slice0winner2_best_last_0_0 <= slice0winner1_held_0_3;
      slice0winner2_best_last_0_1 <= slice0winner1_held_0_7;
      slice0winner2_best_last_0_2 <= slice0winner1_held_0_11;
      slice0winner2_best_last_0_3 <= slice0winner1_held_0_15;
      slice0winner2_best_place_0_0 <= slice0winner2_best_index_0_0_is_not_less;
      slice0winner2_best_place_0_1 <= slice0winner2_best_index_0_1_is_not_less;
      slice0winner2_best_place_0_2 <= slice0winner2_best_index_0_2_is_not_less;
      slice0winner2_best_place_0_3 <= slice0winner2_best_index_0_3_is_not_less;
      slice0winner2_best_at_start_0_0 <= other_19 and slice0winner2_best_index_0_0_is_not_less;
      slice0winner2_best_at_start_0_1 <= other_20 and slice0winner2_best_index_0_1_is_not_less;
      slice0winner2_best_at_start_0_2 <= other_21 and slice0winner2_best_index_0_2_is_not_less;
      slice0winner2_best_at_start_0_3 <= other_22 and slice0winner2_best_index_0_3_is_not_less;
      slice0winner2_best_at_end_0_0 <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0_0 -
        slice0winner1_best_cost_0_1) < 0);
      slice0winner2_best_at_end_0_1 <= ((slice0winner1_best_cost_0_2 - slice0winner1_best_cost_0_3) < 0) and
        ((slice0winner1_best_index_0_2 / 4) = 1) and ((slice0winner1_best_index_0_2 mod 2) = 1);
      slice0winner2_best_at_end_0_2 <= ((slice0winner1_best_cost_0_4 - slice0winner1_best_cost_0_5) < 0) and
        ((slice0winner1_best_index_0_4 / 8) = 1) and ((slice0winner1_best_index_0_4 mod 2) = 1);
      slice0winner2_best_at_end_0_3 <= ((slice0winner1_best_cost_0_6 - slice0winner1_best_cost_0_7) < 0) and
        ((slice0winner1_best_index_0_6 / 8) = 1) and slice0winner2_best_above_0_3_value and
        ((slice0winner1_best_index_0_6 mod 2) = 1);
      slice0winner2_best_late_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0winner2_best_late_cost_0_1 <= slice0winner2_best_cost_0_1;
      slice0winner2_best_late_cost_0_2 <= slice0winner2_best_cost_0_2;
      slice0winner2_best_late_cost_0_3 <= slice0winner2_best_cost_0_3;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      if (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0 then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
      end if;
      if (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0 then
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_3;
      else
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_2;
      end if;
      if (slice0winner1_best_cost_0_5 - slice0winner1_best_cost_0_4) < 0 then
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_5;
      else
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_4;
      end if;
      if (slice0winner1_best_cost_0_7 - slice0winner1_best_cost_0_6) < 0 then
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_7;
      else
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_6;
      end if;
      if slice0winner2_best_index_0_0_is_not_less then
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0_0 <= slice0winner2_best_below_0_0_choice;
        slice0winner2_best_above_0_0 <= slice0winner1_best_above_0_1;
      else
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0_0 <= slice0winner1_best_below_0_0;
        slice0winner2_best_above_0_0 <= slice0winner2_best_above_0_0_choice;
      end if;
      if slice0winner2_best_index_0_1_is_not_less then
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
        slice0winner2_best_below_0_1 <= slice0winner2_best_below_0_1_choice;
        slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_3;
      else
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
        slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;
        slice0winner2_best_above_0_1 <= slice0winner2_best_above_0_1_choice;
      end if;
      if slice0winner2_best_index_0_2_is_not_less then
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
        slice0winner2_best_below_0_2 <= slice0winner2_best_below_0_2_choice;
        slice0winner2_best_above_0_2 <= slice0winner1_best_above_0_5;
      else
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
        slice0winner2_best_below_0_2 <= slice0winner1_best_below_0_4;
        slice0winner2_best_above_0_2 <= slice0winner2_best_above_0_2_choice;
      end if;
      if slice0winner2_best_index_0_3_is_not_less then
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
        slice0winner2_best_below_0_3 <= slice0winner2_best_below_0_3_choice;
        slice0winner2_best_above_0_3 <= slice0winner1_best_above_0_7;
      else
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_6;
        slice0winner2_best_below_0_3 <= slice0winner1_best_below_0_6;
        slice0winner2_best_above_0_3 <= slice0winner2_best_above_0_3_choice;
      end if;
      if (slice0winner2_best_second_0_0_choice_2 - slice0winner2_best_second_0_0_choice_4) < 0 then
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_2;
      else
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_4;
      end if;
      if (slice0winner2_best_second_0_1_choice_2 - slice0winner2_best_second_0_1_choice_4) < 0 then
        slice0winner2_best_second_0_1 <= slice0winner2_best_second_0_1_choice_2;
      else
        slice0winner2_best_second_0_1 <= slice0winner2_best_second_0_1_choice_4;
      end if;
      if (slice0winner2_best_second_0_2_choice_2 - slice0winner2_best_second_0_2_choice_4) < 0 then
        slice0winner2_best_second_0_2 <= slice0winner2_best_second_0_2_choice_2;
      else
        slice0winner2_best_second_0_2 <= slice0winner2_best_second_0_2_choice_4;
      end if;
      if (slice0winner2_best_second_0_3_choice_2 - slice0winner2_best_second_0_3_choice_4) < 0 then
        slice0winner2_best_second_0_3 <= slice0winner2_best_second_0_3_choice_2;
      else
        slice0winner2_best_second_0_3 <= slice0winner2_best_second_0_3_choice_4;
      end if;
      if (slice0winner1_best_late_cost_0_3 - slice0winner1_best_but_first_0_2) < 0 then
        slice0winner2_best_but_first_0_1 <= slice0winner1_best_late_cost_0_3;
      else
        slice0winner2_best_but_first_0_1 <= slice0winner1_best_but_first_0_2;
      end if;
      if (slice0winner1_best_late_cost_0_5 - slice0winner1_best_but_first_0_4) < 0 then
        slice0winner2_best_but_first_0_2 <= slice0winner1_best_late_cost_0_5;
      else
        slice0winner2_best_but_first_0_2 <= slice0winner1_best_but_first_0_4;
      end if;
      if (slice0winner1_best_late_cost_0_7 - slice0winner1_best_but_first_0_6) < 0 then
        slice0winner2_best_but_first_0_3 <= slice0winner1_best_late_cost_0_7;
      else
        slice0winner2_best_but_first_0_3 <= slice0winner1_best_but_first_0_6;
      end if;
      if (slice0winner1_best_but_last_0_1 - slice0winner1_best_late_cost_0_0) < 0 then
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_but_last_0_1;
      else
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_late_cost_0_0;
      end if;
      if (slice0winner1_best_but_last_0_3 - slice0winner1_best_late_cost_0_2) < 0 then
        slice0winner2_best_but_last_0_1 <= slice0winner1_best_but_last_0_3;
      else
        slice0winner2_best_but_last_0_1 <= slice0winner1_best_late_cost_0_2;
      end if;
      if (slice0winner1_best_but_last_0_5 - slice0winner1_best_late_cost_0_4) < 0 then
        slice0winner2_best_but_last_0_2 <= slice0winner1_best_but_last_0_5;
      else
        slice0winner2_best_but_last_0_2 <= slice0winner1_best_late_cost_0_4;
      end if;
      if (slice0winner1_best_but_last_0_7 - slice0winner1_best_late_cost_0_6) < 0 then
        slice0winner2_best_but_last_0_3 <= slice0winner1_best_but_last_0_7;
      else
        slice0winner2_best_but_last_0_3 <= slice0winner1_best_late_cost_0_6;
      end if;
      if slice0winner2_tag_valid then
        slice0winner2_tag_output_column <= slice3window_centre_output_column_5;
        slice0winner2_tag_start_of_frame <= slice3window_centre_start_of_frame_5;
        slice0winner2_tag_end_of_line <= slice3window_centre_end_of_line_5;
      end if;
      -- slice0winner3
      slice0winner3_best_index_0_0_is_not_less := (slice0winner2_best_cost_0_0 - slice0winner2_best_cost_0_1) >= 0;
      slice0winner3_best_index_0_1_is_not_less := (slice0winner2_best_cost_0_2 - slice0winner2_best_cost_0_3) >= 0;
      slice0winner3_best_below_0_0_is_equal := slice0winner2_best_index_0_1 = 4;
      if slice0winner3_best_below_0_0_is_equal then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      slice0winner3_best_below_0_1_is_equal := slice0winner2_best_index_0_3 = 12;
      if slice0winner3_best_below_0_1_is_equal then
        slice0winner3_best_below_0_1_choice := slice0winner2_best_last_0_2;
      else
        slice0winner3_best_below_0_1_choice := slice0winner2_best_below_0_3;
      end if;
      slice0winner3_best_above_0_0_is_equal := slice0winner2_best_index_0_0 = 3;
      if slice0winner3_best_above_0_0_is_equal then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      slice0winner3_best_above_0_1_is_equal := (slice0winner2_best_index_0_2 mod 4) = 3;
      if ((slice0winner2_best_index_0_2 / 8) = 1) and slice0winner3_best_above_0_1_is_equal then
        slice0winner3_best_above_0_1_choice := slice0winner2_best_first_0_3;
      else
        slice0winner3_best_above_0_1_choice := slice0winner2_best_above_0_2;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice := slice0winner2_best_second_0_1;
      else
        slice0winner3_best_second_0_0_choice := slice0winner2_best_late_cost_0_1;
      end if;
      if slice0winner3_best_at_end_0_0 then
        slice0winner3_best_second_0_0_choice_2 := slice0winner2_best_but_first_0_1;
      else
        slice0winner3_best_second_0_0_choice_2 := slice0winner3_best_second_0_0_choice;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_late_cost_0_0;
      else
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_second_0_0;
      end if;
      if slice0winner3_best_at_start_0_0 then
        slice0winner3_best_second_0_0_choice_4 := slice0winner2_best_but_last_0_0;
      else
        slice0winner3_best_second_0_0_choice_4 := slice0winner3_best_second_0_0_choice_3;
      end if;
      if slice0winner3_best_place_0_1 then
        slice0winner3_best_second_0_1_choice := slice0winner2_best_second_0_3;
      else
        slice0winner3_best_second_0_1_choice := slice0winner2_best_late_cost_0_3;
      end if;
      if slice0winner3_best_at_end_0_1 then
        slice0winner3_best_second_0_1_choice_2 := slice0winner2_best_but_first_0_3;
      else
        slice0winner3_best_second_0_1_choice_2 := slice0winner3_best_second_0_1_choice;
      end if;
      if slice0winner3_best_place_0_1 then
        slice0winner3_best_second_0_1_choice_3 := slice0winner2_best_late_cost_0_2;
      else
        slice0winner3_best_second_0_1_choice_3 := slice0winner2_best_second_0_2;
      end if;
      if slice0winner3_best_at_start_0_1 then
        slice0winner3_best_second_0_1_choice_4 := slice0winner2_best_but_last_0_2;
      else
        slice0winner3_best_second_0_1_choice_4 := slice0winner3_best_second_0_1_choice_3;
      end if;
      slice0winner3_best_first_0_1 <= slice0winner2_best_first_0_2;
      slice0winner3_best_last_0_0 <= slice0winner2_best_last_0_1;
      slice0winner3_best_last_0_1 <= slice0winner2_best_last_0_3;
      slice0winner3_best_place_0_0 <= slice0winner3_best_index_0_0_is_not_less;
      slice0winner3_best_place_0_1 <= slice0winner3_best_index_0_1_is_not_less;
      slice0winner3_best_at_start_0_0 <= slice0winner3_best_index_0_0_is_not_less and
        slice0winner3_best_below_0_0_is_equal;
      slice0winner3_best_at_start_0_1 <= slice0winner3_best_below_0_1_is_equal and
        slice0winner3_best_index_0_1_is_not_less;
      slice0winner3_best_at_end_0_0 <= ((slice0winner2_best_cost_0_0 - slice0winner2_best_cost_0_1) < 0) and
        slice0winner3_best_above_0_0_is_equal;
      slice0winner3_best_at_end_0_1 <= ((slice0winner2_best_cost_0_2 - slice0winner2_best_cost_0_3) < 0) and
        ((slice0winner2_best_index_0_2 / 8) = 1) and slice0winner3_best_above_0_1_is_equal;
      slice0winner3_best_late_cost_0_0 <= slice0winner3_best_cost_0_0;
      slice0winner3_best_late_cost_0_1 <= slice0winner3_best_cost_0_1;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0 then
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_1;
      else
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_0;
      end if;
      if (slice0winner2_best_cost_0_3 - slice0winner2_best_cost_0_2) < 0 then
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_3;
      else
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_2;
      end if;
      if slice0winner3_best_index_0_0_is_not_less then
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0_0 <= slice0winner3_best_below_0_0_choice;
        slice0winner3_best_above_0_0 <= slice0winner2_best_above_0_1;
      else
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0_0 <= slice0winner2_best_below_0_0;
        slice0winner3_best_above_0_0 <= slice0winner3_best_above_0_0_choice;
      end if;
      if slice0winner3_best_index_0_1_is_not_less then
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
        slice0winner3_best_below_0_1 <= slice0winner3_best_below_0_1_choice;
        slice0winner3_best_above_0_1 <= slice0winner2_best_above_0_3;
      else
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
        slice0winner3_best_below_0_1 <= slice0winner2_best_below_0_2;
        slice0winner3_best_above_0_1 <= slice0winner3_best_above_0_1_choice;
      end if;
      if (slice0winner3_best_second_0_0_choice_2 - slice0winner3_best_second_0_0_choice_4) < 0 then
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_2;
      else
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_4;
      end if;
      if (slice0winner3_best_second_0_1_choice_2 - slice0winner3_best_second_0_1_choice_4) < 0 then
        slice0winner3_best_second_0_1 <= slice0winner3_best_second_0_1_choice_2;
      else
        slice0winner3_best_second_0_1 <= slice0winner3_best_second_0_1_choice_4;
      end if;
      if (slice0winner2_best_late_cost_0_3 - slice0winner2_best_but_first_0_2) < 0 then
        slice0winner3_best_but_first_0_1 <= slice0winner2_best_late_cost_0_3;
      else
        slice0winner3_best_but_first_0_1 <= slice0winner2_best_but_first_0_2;
      end if;
      if (slice0winner2_best_but_last_0_1 - slice0winner2_best_late_cost_0_0) < 0 then
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_but_last_0_1;
      else
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_late_cost_0_0;
      end if;
      if (slice0winner2_best_but_last_0_3 - slice0winner2_best_late_cost_0_2) < 0 then
        slice0winner3_best_but_last_0_1 <= slice0winner2_best_but_last_0_3;
      else
        slice0winner3_best_but_last_0_1 <= slice0winner2_best_late_cost_0_2;
      end if;
      -- slice0winner4
      slice0winner4_best_index_0_0_is_less := (slice0winner3_best_cost_0_0 - slice0winner3_best_cost_0_1) < 0;
      slice0winner4_best_below_0_0_is_equal := slice0winner3_best_index_0_1 = 8;
      if slice0winner4_best_below_0_0_is_equal then
        slice0winner4_best_below_0_0_choice := slice0winner3_best_last_0_0;
      else
        slice0winner4_best_below_0_0_choice := slice0winner3_best_below_0_1;
      end if;
      slice0winner4_best_above_0_0_is_equal := slice0winner3_best_index_0_0 = 7;
      if slice0winner4_best_above_0_0_is_equal then
        slice0winner4_best_above_0_0_choice := slice0winner3_best_first_0_1;
      else
        slice0winner4_best_above_0_0_choice := slice0winner3_best_above_0_0;
      end if;
      slice0winner4_best_place_0_0_is_not_less := (slice0winner3_best_cost_0_0 - slice0winner3_best_cost_0_1) >= 0;
      if slice0winner4_best_place_0_0 then
        slice0winner4_best_second_0_0_choice := slice0winner3_best_second_0_1;
      else
        slice0winner4_best_second_0_0_choice := slice0winner3_best_late_cost_0_1;
      end if;
      if slice0winner4_best_at_end_0_0 then
        slice0winner4_best_second_0_0_choice_2 := slice0winner3_best_but_first_0_1;
      else
        slice0winner4_best_second_0_0_choice_2 := slice0winner4_best_second_0_0_choice;
      end if;
      if slice0winner4_best_place_0_0 then
        slice0winner4_best_second_0_0_choice_3 := slice0winner3_best_late_cost_0_0;
      else
        slice0winner4_best_second_0_0_choice_3 := slice0winner3_best_second_0_0;
      end if;
      if slice0winner4_best_at_start_0_0 then
        slice0winner4_best_second_0_0_choice_4 := slice0winner3_best_but_last_0_0;
      else
        slice0winner4_best_second_0_0_choice_4 := slice0winner4_best_second_0_0_choice_3;
      end if;
      slice0winner4_best_last_0_0 <= slice0winner3_best_last_0_1;
      slice0winner4_best_place_0_0 <= slice0winner4_best_place_0_0_is_not_less;
      slice0winner4_best_at_start_0_0 <= slice0winner4_best_below_0_0_is_equal and
        slice0winner4_best_place_0_0_is_not_less;
      slice0winner4_best_at_end_0_0 <= slice0winner4_best_index_0_0_is_less and slice0winner4_best_above_0_0_is_equal;
      slice0winner4_best_late_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_output_column <= slice0winner3_tag_output_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if (slice0winner3_best_cost_0_1 - slice0winner3_best_cost_0_0) < 0 then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_1;
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_0;
      end if;
      if slice0winner4_best_index_0_0_is_less then
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
        slice0winner4_best_below_0_0 <= slice0winner3_best_below_0_0;
        slice0winner4_best_above_0_0 <= slice0winner4_best_above_0_0_choice;
      else
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
        slice0winner4_best_below_0_0 <= slice0winner4_best_below_0_0_choice;
        slice0winner4_best_above_0_0 <= slice0winner3_best_above_0_1;
      end if;
      if (slice0winner4_best_second_0_0_choice_2 - slice0winner4_best_second_0_0_choice_4) < 0 then
        slice0winner4_best_second_0_0 <= slice0winner4_best_second_0_0_choice_2;
      else
        slice0winner4_best_second_0_0 <= slice0winner4_best_second_0_0_choice_4;
      end if;
      if (slice0winner3_best_but_last_0_1 - slice0winner3_best_late_cost_0_0) < 0 then
        slice0winner4_best_but_last_0_0 <= slice0winner3_best_but_last_0_1;
      else
        slice0winner4_best_but_last_0_0 <= slice0winner3_best_late_cost_0_0;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner4_best_index_0_0;
      slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
      slice0_best_last_0_0 <= slice0winner4_best_last_0_0;
      slice0_best_late_cost_0_0 <= slice0winner4_best_late_cost_0_0;
      slice0_best_second_0_0 <= slice0winner4_best_second_0_0;
      slice0_best_but_last_0_0 <= slice0winner4_best_but_last_0_0;
      slice0_best_tag_valid <= slice0winner4_tag_valid;
      slice0_best_tag_output_column <= slice0winner4_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner4_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner4_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice0shift_search_out_0;
        slice1shift_search_0_1 <= slice1shift_search_0_0;
        slice1shift_search_0_2 <= slice1shift_search_0_1;
        slice1shift_search_0_3 <= slice1shift_search_0_2;
        slice1shift_search_0_4 <= slice1shift_search_0_3;
        slice1shift_search_0_5 <= slice1shift_search_0_4;
        slice1shift_search_0_6 <= slice1shift_search_0_5;
        slice1shift_search_0_7 <= slice1shift_search_0_6;
        slice1shift_search_0_8 <= slice1shift_search_0_7;
        slice1shift_search_0_9 <= slice1shift_search_0_8;
        slice1shift_search_0_10 <= slice1shift_search_0_9;
        slice1shift_search_0_11 <= slice1shift_search_0_10;
        slice1shift_search_0_12 <= slice1shift_search_0_11;
        slice1shift_search_0_13 <= slice1shift_search_0_12;
        slice1shift_search_0_14 <= slice1shift_search_0_13;
        slice1shift_search_0_15 <= slice1shift_search_0_14;
        slice1shift_search_1_0 <= slice0shift_search_out_1;
        slice1shift_search_1_1 <= slice1shift_search_1_0;
        slice1shift_search_1_2 <= slice1shift_search_1_1;
        slice1shift_search_1_3 <= slice1shift_search_1_2;
        slice1shift_search_1_4 <= slice1shift_search_1_3;
        slice1shift_search_1_5 <= slice1shift_search_1_4;
        slice1shift_search_1_6 <= slice1shift_search_1_5;
        slice1shift_search_1_7 <= slice1shift_search_1_6;
        slice1shift_search_1_8 <= slice1shift_search_1_7;
        slice1shift_search_1_9 <= slice1shift_search_1_8;
        slice1shift_search_1_10 <= slice1shift_search_1_9;
        slice1shift_search_1_11 <= slice1shift_search_1_10;
        slice1shift_search_1_12 <= slice1shift_search_1_11;
        slice1shift_search_1_13 <= slice1shift_search_1_12;
        slice1shift_search_1_14 <= slice1shift_search_1_13;
        slice1shift_search_1_15 <= slice1shift_search_1_14;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_search_out_0 <= slice1shift_search_0_15;
      slice1shift_search_out_1 <= slice1shift_search_1_15;
      -- slice1cost
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := slice1cost_ready_words_0 mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0_choice_2 := 0;
      else
        slice1cost_column_0_0_choice_2 := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := (slice1cost_ready_words_0 / 1024) mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_1_choice_2 := 0;
      else
        slice1cost_column_0_1_choice_2 := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := slice1cost_ready_words_0 / 1048576;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_2_choice_2 := 0;
      else
        slice1cost_column_0_2_choice_2 := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := slice1cost_ready_words_1 mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_3_choice_2 := 0;
      else
        slice1cost_column_0_3_choice_2 := (slice1cost_change_0_3 + slice1cost_column_0_3_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := (slice1cost_ready_words_1 / 1024) mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_4_choice_2 := 0;
      else
        slice1cost_column_0_4_choice_2 := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := slice1cost_ready_words_1 / 1048576;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_5_choice_2 := 0;
      else
        slice1cost_column_0_5_choice_2 := (slice1cost_change_0_5 + slice1cost_column_0_5_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_6_choice := 0;
      else
        slice1cost_column_0_6_choice := slice1cost_ready_words_2 mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_6_choice_2 := 0;
      else
        slice1cost_column_0_6_choice_2 := (slice1cost_change_0_6 + slice1cost_column_0_6_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_7_choice := 0;
      else
        slice1cost_column_0_7_choice := (slice1cost_ready_words_2 / 1024) mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_7_choice_2 := 0;
      else
        slice1cost_column_0_7_choice_2 := (slice1cost_change_0_7 + slice1cost_column_0_7_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_8_choice := 0;
      else
        slice1cost_column_0_8_choice := slice1cost_ready_words_2 / 1048576;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_8_choice_2 := 0;
      else
        slice1cost_column_0_8_choice_2 := (slice1cost_change_0_8 + slice1cost_column_0_8_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_9_choice := 0;
      else
        slice1cost_column_0_9_choice := slice1cost_ready_words_3 mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_9_choice_2 := 0;
      else
        slice1cost_column_0_9_choice_2 := (slice1cost_change_0_9 + slice1cost_column_0_9_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_10_choice := 0;
      else
        slice1cost_column_0_10_choice := (slice1cost_ready_words_3 / 1024) mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_10_choice_2 := 0;
      else
        slice1cost_column_0_10_choice_2 := (slice1cost_change_0_10 + slice1cost_column_0_10_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_11_choice := 0;
      else
        slice1cost_column_0_11_choice := slice1cost_ready_words_3 / 1048576;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_11_choice_2 := 0;
      else
        slice1cost_column_0_11_choice_2 := (slice1cost_change_0_11 + slice1cost_column_0_11_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_12_choice := 0;
      else
        slice1cost_column_0_12_choice := slice1cost_ready_words_4 mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_12_choice_2 := 0;
      else
        slice1cost_column_0_12_choice_2 := (slice1cost_change_0_12 + slice1cost_column_0_12_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_13_choice := 0;
      else
        slice1cost_column_0_13_choice := (slice1cost_ready_words_4 / 1024) mod 1024;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_13_choice_2 := 0;
      else
        slice1cost_column_0_13_choice_2 := (slice1cost_change_0_13 + slice1cost_column_0_13_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_14_choice := 0;
      else
        slice1cost_column_0_14_choice := slice1cost_ready_words_4 / 1048576;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_14_choice_2 := 0;
      else
        slice1cost_column_0_14_choice_2 := (slice1cost_change_0_14 + slice1cost_column_0_14_choice) mod 1024;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_15_choice := 0;
      else
        slice1cost_column_0_15_choice := slice1cost_ready_words_5;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_15_choice_2 := 0;
      else
        slice1cost_column_0_15_choice_2 := (slice1cost_change_0_15 + slice1cost_column_0_15_choice) mod 1024;
      end if;
      slice1cost_pixels_first_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_pixels_first_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_pixels_first_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_pixels_first_0_3 <= slice1shift_search_0_3 - slice1shift_reference_0;
      slice1cost_pixels_first_0_4 <= slice1shift_search_0_4 - slice1shift_reference_0;
      slice1cost_pixels_first_0_5 <= slice1shift_search_0_5 - slice1shift_reference_0;
      slice1cost_pixels_first_0_6 <= slice1shift_search_0_6 - slice1shift_reference_0;
      slice1cost_pixels_first_0_7 <= slice1shift_search_0_7 - slice1shift_reference_0;
      slice1cost_pixels_first_0_8 <= slice1shift_search_0_8 - slice1shift_reference_0;
      slice1cost_pixels_first_0_9 <= slice1shift_search_0_9 - slice1shift_reference_0;
      slice1cost_pixels_first_0_10 <= slice1shift_search_0_10 - slice1shift_reference_0;
      slice1cost_pixels_first_0_11 <= slice1shift_search_0_11 - slice1shift_reference_0;
      slice1cost_pixels_first_0_12 <= slice1shift_search_0_12 - slice1shift_reference_0;
      slice1cost_pixels_first_0_13 <= slice1shift_search_0_13 - slice1shift_reference_0;
      slice1cost_pixels_first_0_14 <= slice1shift_search_0_14 - slice1shift_reference_0;
      slice1cost_pixels_first_0_15 <= slice1shift_search_0_15 - slice1shift_reference_0;
      slice1cost_pixels_first_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_pixels_first_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_pixels_first_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_pixels_first_1_3 <= slice1shift_search_1_3 - slice1shift_reference_1;
      slice1cost_pixels_first_1_4 <= slice1shift_search_1_4 - slice1shift_reference_1;
      slice1cost_pixels_first_1_5 <= slice1shift_search_1_5 - slice1shift_reference_1;
      slice1cost_pixels_first_1_6 <= slice1shift_search_1_6 - slice1shift_reference_1;
      slice1cost_pixels_first_1_7 <= slice1shift_search_1_7 - slice1shift_reference_1;
      slice1cost_pixels_first_1_8 <= slice1shift_search_1_8 - slice1shift_reference_1;
      slice1cost_pixels_first_1_9 <= slice1shift_search_1_9 - slice1shift_reference_1;
      slice1cost_pixels_first_1_10 <= slice1shift_search_1_10 - slice1shift_reference_1;
      slice1cost_pixels_first_1_11 <= slice1shift_search_1_11 - slice1shift_reference_1;
      slice1cost_pixels_first_1_12 <= slice1shift_search_1_12 - slice1shift_reference_1;
      slice1cost_pixels_first_1_13 <= slice1shift_search_1_13 - slice1shift_reference_1;
      slice1cost_pixels_first_1_14 <= slice1shift_search_1_14 - slice1shift_reference_1;
      slice1cost_pixels_first_1_15 <= slice1shift_search_1_15 - slice1shift_reference_1;
      slice1cost_pixels_cost_0_0 <= folded(slice1cost_pixels_first_0_0) + as_number((slice1cost_pixels_first_0_0 < 0));
      slice1cost_pixels_cost_0_1 <= folded(slice1cost_pixels_first_0_1) + as_number((slice1cost_pixels_first_0_1 < 0));
      slice1cost_pixels_cost_0_2 <= folded(slice1cost_pixels_first_0_2) + as_number((slice1cost_pixels_first_0_2 < 0));
      slice1cost_pixels_cost_0_3 <= folded(slice1cost_pixels_first_0_3) + as_number((slice1cost_pixels_first_0_3 < 0));
      slice1cost_pixels_cost_0_4 <= folded(slice1cost_pixels_first_0_4) + as_number((slice1cost_pixels_first_0_4 < 0));
      slice1cost_pixels_cost_0_5 <= folded(slice1cost_pixels_first_0_5) + as_number((slice1cost_pixels_first_0_5 < 0));
      slice1cost_pixels_cost_0_6 <= folded(slice1cost_pixels_first_0_6) + as_number((slice1cost_pixels_first_0_6 < 0));
      slice1cost_pixels_cost_0_7 <= folded(slice1cost_pixels_first_0_7) + as_number((slice1cost_pixels_first_0_7 < 0));
      slice1cost_pixels_cost_0_8 <= folded(slice1cost_pixels_first_0_8) + as_number((slice1cost_pixels_first_0_8 < 0));
      slice1cost_pixels_cost_0_9 <= folded(slice1cost_pixels_first_0_9) + as_number((slice1cost_pixels_first_0_9 < 0));
      slice1cost_pixels_cost_0_10 <= folded(slice1cost_pixels_first_0_10) + as_number((slice1cost_pixels_first_0_10 <
        0));
      slice1cost_pixels_cost_0_11 <= folded(slice1cost_pixels_first_0_11) + as_number((slice1cost_pixels_first_0_11 <
        0));
      slice1cost_pixels_cost_0_12 <= folded(slice1cost_pixels_first_0_12) + as_number((slice1cost_pixels_first_0_12 <
        0));
      slice1cost_pixels_cost_0_13 <= folded(slice1cost_pixels_first_0_13) + as_number((slice1cost_pixels_first_0_13 <
        0));
      slice1cost_pixels_cost_0_14 <= folded(slice1cost_pixels_first_0_14) + as_number((slice1cost_pixels_first_0_14 <
        0));
      slice1cost_pixels_cost_0_15 <= folded(slice1cost_pixels_first_0_15) + as_number((slice1cost_pixels_first_0_15 <
        0));
      slice1cost_pixels_cost_1_0 <= folded(slice1cost_pixels_first_1_0) + as_number((slice1cost_pixels_first_1_0 < 0));
      slice1cost_pixels_cost_1_1 <= folded(slice1cost_pixels_first_1_1) + as_number((slice1cost_pixels_first_1_1 < 0));
      slice1cost_pixels_cost_1_2 <= folded(slice1cost_pixels_first_1_2) + as_number((slice1cost_pixels_first_1_2 < 0));
      slice1cost_pixels_cost_1_3 <= folded(slice1cost_pixels_first_1_3) + as_number((slice1cost_pixels_first_1_3 < 0));
      slice1cost_pixels_cost_1_4 <= folded(slice1cost_pixels_first_1_4) + as_number((slice1cost_pixels_first_1_4 < 0));
      slice1cost_pixels_cost_1_5 <= folded(slice1cost_pixels_first_1_5) + as_number((slice1cost_pixels_first_1_5 < 0));
      slice1cost_pixels_cost_1_6 <= folded(slice1cost_pixels_first_1_6) + as_number((slice1cost_pixels_first_1_6 < 0));
      slice1cost_pixels_cost_1_7 <= folded(slice1cost_pixels_first_1_7) + as_number((slice1cost_pixels_first_1_7 < 0));
      slice1cost_pixels_cost_1_8 <= folded(slice1cost_pixels_first_1_8) + as_number((slice1cost_pixels_first_1_8 < 0));
      slice1cost_pixels_cost_1_9 <= folded(slice1cost_pixels_first_1_9) + as_number((slice1cost_pixels_first_1_9 < 0));
      slice1cost_pixels_cost_1_10 <= folded(slice1cost_pixels_first_1_10) + as_number((slice1cost_pixels_first_1_10 <
        0));
      slice1cost_pixels_cost_1_11 <= folded(slice1cost_pixels_first_1_11) + as_number((slice1cost_pixels_first_1_11 <
        0));
      slice1cost_pixels_cost_1_12 <= folded(slice1cost_pixels_first_1_12) + as_number((slice1cost_pixels_first_1_12 <
        0));
      slice1cost_pixels_cost_1_13 <= folded(slice1cost_pixels_first_1_13) + as_number((slice1cost_pixels_first_1_13 <
        0));
      slice1cost_pixels_cost_1_14 <= folded(slice1cost_pixels_first_1_14) + as_number((slice1cost_pixels_first_1_14 <
        0));
      slice1cost_pixels_cost_1_15 <= folded(slice1cost_pixels_first_1_15) + as_number((slice1cost_pixels_first_1_15 <
        0));
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice1cost_read_column;
      slice1cost_change_0_0 <= slice1cost_pixels_cost_1_0 - slice1cost_pixels_cost_0_0;
      slice1cost_change_0_1 <= slice1cost_pixels_cost_1_1 - slice1cost_pixels_cost_0_1;
      slice1cost_change_0_2 <= slice1cost_pixels_cost_1_2 - slice1cost_pixels_cost_0_2;
      slice1cost_change_0_3 <= slice1cost_pixels_cost_1_3 - slice1cost_pixels_cost_0_3;
      slice1cost_change_0_4 <= slice1cost_pixels_cost_1_4 - slice1cost_pixels_cost_0_4;
      slice1cost_change_0_5 <= slice1cost_pixels_cost_1_5 - slice1cost_pixels_cost_0_5;
      slice1cost_change_0_6 <= slice1cost_pixels_cost_1_6 - slice1cost_pixels_cost_0_6;
      slice1cost_change_0_7 <= slice1cost_pixels_cost_1_7 - slice1cost_pixels_cost_0_7;
      slice1cost_change_0_8 <= slice1cost_pixels_cost_1_8 - slice1cost_pixels_cost_0_8;
      slice1cost_change_0_9 <= slice1cost_pixels_cost_1_9 - slice1cost_pixels_cost_0_9;
      slice1cost_change_0_10 <= slice1cost_pixels_cost_1_10 - slice1cost_pixels_cost_0_10;
      slice1cost_change_0_11 <= slice1cost_pixels_cost_1_11 - slice1cost_pixels_cost_0_11;
      slice1cost_change_0_12 <= slice1cost_pixels_cost_1_12 - slice1cost_pixels_cost_0_12;
      slice1cost_change_0_13 <= slice1cost_pixels_cost_1_13 - slice1cost_pixels_cost_0_13;
      slice1cost_change_0_14 <= slice1cost_pixels_cost_1_14 - slice1cost_pixels_cost_0_14;
      slice1cost_change_0_15 <= slice1cost_pixels_cost_1_15 - slice1cost_pixels_cost_0_15;
      slice1cost_ready_words_0 <= to_integer(slice1cost_read_words_0);
      slice1cost_ready_words_1 <= to_integer(slice1cost_read_words_1);
      slice1cost_ready_words_2 <= to_integer(slice1cost_read_words_2);
      slice1cost_ready_words_3 <= to_integer(slice1cost_read_words_3);
      slice1cost_ready_words_4 <= to_integer(slice1cost_read_words_4);
      slice1cost_ready_words_5 <= to_integer(slice1cost_read_words_5);
      slice1cost_column_0_0 <= slice1cost_column_0_0_choice_2;
      slice1cost_column_0_1 <= slice1cost_column_0_1_choice_2;
      slice1cost_column_0_2 <= slice1cost_column_0_2_choice_2;
      slice1cost_column_0_3 <= slice1cost_column_0_3_choice_2;
      slice1cost_column_0_4 <= slice1cost_column_0_4_choice_2;
      slice1cost_column_0_5 <= slice1cost_column_0_5_choice_2;
      slice1cost_column_0_6 <= slice1cost_column_0_6_choice_2;
      slice1cost_column_0_7 <= slice1cost_column_0_7_choice_2;
      slice1cost_column_0_8 <= slice1cost_column_0_8_choice_2;
      slice1cost_column_0_9 <= slice1cost_column_0_9_choice_2;
      slice1cost_column_0_10 <= slice1cost_column_0_10_choice_2;
      slice1cost_column_0_11 <= slice1cost_column_0_11_choice_2;
      slice1cost_column_0_12 <= slice1cost_column_0_12_choice_2;
      slice1cost_column_0_13 <= slice1cost_column_0_13_choice_2;
      slice1cost_column_0_14 <= slice1cost_column_0_14_choice_2;
      slice1cost_column_0_15 <= slice1cost_column_0_15_choice_2;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        slice1cost_write_words_0 <= (slice1cost_column_0_1_choice_2 * 1024) + slice1cost_column_0_0_choice_2 +
          (slice1cost_column_0_2_choice_2 * 1048576);
        slice1cost_write_words_1 <= (slice1cost_column_0_4_choice_2 * 1024) + slice1cost_column_0_3_choice_2 +
          (slice1cost_column_0_5_choice_2 * 1048576);
        slice1cost_write_words_2 <= (slice1cost_column_0_7_choice_2 * 1024) + slice1cost_column_0_6_choice_2 +
          (slice1cost_column_0_8_choice_2 * 1048576);
        slice1cost_write_words_3 <= (slice1cost_column_0_10_choice_2 * 1024) + slice1cost_column_0_9_choice_2 +
          (slice1cost_column_0_11_choice_2 * 1048576);
        slice1cost_write_words_4 <= (slice1cost_column_0_13_choice_2 * 1024) + slice1cost_column_0_12_choice_2 +
          (slice1cost_column_0_14_choice_2 * 1048576);
        slice1cost_write_words_5 <= slice1cost_column_0_15_choice_2;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 15 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(9 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(19 downto 10));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_0(29 downto 20));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_1(9 downto 0));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_1(19 downto 10));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_1(29 downto 20));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_6_choice := to_integer(slice1window_leaving_2(9 downto 0));
      else
        slice1window_change_0_6_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_7_choice := to_integer(slice1window_leaving_2(19 downto 10));
      else
        slice1window_change_0_7_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_8_choice := to_integer(slice1window_leaving_2(29 downto 20));
      else
        slice1window_change_0_8_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_9_choice := to_integer(slice1window_leaving_3(9 downto 0));
      else
        slice1window_change_0_9_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_10_choice := to_integer(slice1window_leaving_3(19 downto 10));
      else
        slice1window_change_0_10_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_11_choice := to_integer(slice1window_leaving_3(29 downto 20));
      else
        slice1window_change_0_11_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_12_choice := to_integer(slice1window_leaving_4(9 downto 0));
      else
        slice1window_change_0_12_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_13_choice := to_integer(slice1window_leaving_4(19 downto 10));
      else
        slice1window_change_0_13_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_14_choice := to_integer(slice1window_leaving_4(29 downto 20));
      else
        slice1window_change_0_14_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_15_choice := to_integer(slice1window_leaving_5);
      else
        slice1window_change_0_15_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_0_3 <= slice1cost_column_0_3;
      slice1window_entering_0_4 <= slice1cost_column_0_4;
      slice1window_entering_0_5 <= slice1cost_column_0_5;
      slice1window_entering_0_6 <= slice1cost_column_0_6;
      slice1window_entering_0_7 <= slice1cost_column_0_7;
      slice1window_entering_0_8 <= slice1cost_column_0_8;
      slice1window_entering_0_9 <= slice1cost_column_0_9;
      slice1window_entering_0_10 <= slice1cost_column_0_10;
      slice1window_entering_0_11 <= slice1cost_column_0_11;
      slice1window_entering_0_12 <= slice1cost_column_0_12;
      slice1window_entering_0_13 <= slice1cost_column_0_13;
      slice1window_entering_0_14 <= slice1cost_column_0_14;
      slice1window_entering_0_15 <= slice1cost_column_0_15;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_0_3 <= slice1window_entering_0_3 - slice1window_change_0_3_choice;
      slice1window_change_0_4 <= slice1window_entering_0_4 - slice1window_change_0_4_choice;
      slice1window_change_0_5 <= slice1window_entering_0_5 - slice1window_change_0_5_choice;
      slice1window_change_0_6 <= slice1window_entering_0_6 - slice1window_change_0_6_choice;
      slice1window_change_0_7 <= slice1window_entering_0_7 - slice1window_change_0_7_choice;
      slice1window_change_0_8 <= slice1window_entering_0_8 - slice1window_change_0_8_choice;
      slice1window_change_0_9 <= slice1window_entering_0_9 - slice1window_change_0_9_choice;
      slice1window_change_0_10 <= slice1window_entering_0_10 - slice1window_change_0_10_choice;
      slice1window_change_0_11 <= slice1window_entering_0_11 - slice1window_change_0_11_choice;
      slice1window_change_0_12 <= slice1window_entering_0_12 - slice1window_change_0_12_choice;
      slice1window_change_0_13 <= slice1window_entering_0_13 - slice1window_change_0_13_choice;
      slice1window_change_0_14 <= slice1window_entering_0_14 - slice1window_change_0_14_choice;
      slice1window_change_0_15 <= slice1window_entering_0_15 - slice1window_change_0_15_choice;
      slice1window_change_tag_first_cost <= slice0window_change_tag_first_cost;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
      slice1window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_1;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_0_choice := 0;
      else
        slice1window_sum_0_0_choice := slice1window_sum_0_0;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_1_choice := 0;
      else
        slice1window_sum_0_1_choice := slice1window_sum_0_1;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_2_choice := 0;
      else
        slice1window_sum_0_2_choice := slice1window_sum_0_2;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_3_choice := 0;
      else
        slice1window_sum_0_3_choice := slice1window_sum_0_3;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_4_choice := 0;
      else
        slice1window_sum_0_4_choice := slice1window_sum_0_4;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_5_choice := 0;
      else
        slice1window_sum_0_5_choice := slice1window_sum_0_5;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_6_choice := 0;
      else
        slice1window_sum_0_6_choice := slice1window_sum_0_6;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_7_choice := 0;
      else
        slice1window_sum_0_7_choice := slice1window_sum_0_7;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_8_choice := 0;
      else
        slice1window_sum_0_8_choice := slice1window_sum_0_8;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_9_choice := 0;
      else
        slice1window_sum_0_9_choice := slice1window_sum_0_9;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_10_choice := 0;
      else
        slice1window_sum_0_10_choice := slice1window_sum_0_10;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_11_choice := 0;
      else
        slice1window_sum_0_11_choice := slice1window_sum_0_11;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_12_choice := 0;
      else
        slice1window_sum_0_12_choice := slice1window_sum_0_12;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_13_choice := 0;
      else
        slice1window_sum_0_13_choice := slice1window_sum_0_13;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_14_choice := 0;
      else
        slice1window_sum_0_14_choice := slice1window_sum_0_14;
      end if;
      if slice1window_change_tag_first_cost then
        slice1window_sum_0_15_choice := 0;
      else
        slice1window_sum_0_15_choice := slice1window_sum_0_15;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 16384;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 16384;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 16384;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 16384;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 16384;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 16384;
        slice1window_sum_0_6 <= (slice1window_sum_0_6_choice + slice1window_change_0_6) mod 16384;
        slice1window_sum_0_7 <= (slice1window_sum_0_7_choice + slice1window_change_0_7) mod 16384;
        slice1window_sum_0_8 <= (slice1window_sum_0_8_choice + slice1window_change_0_8) mod 16384;
        slice1window_sum_0_9 <= (slice1window_sum_0_9_choice + slice1window_change_0_9) mod 16384;
        slice1window_sum_0_10 <= (slice1window_sum_0_10_choice + slice1window_change_0_10) mod 16384;
        slice1window_sum_0_11 <= (slice1window_sum_0_11_choice + slice1window_change_0_11) mod 16384;
        slice1window_sum_0_12 <= (slice1window_sum_0_12_choice + slice1window_change_0_12) mod 16384;
        slice1window_sum_0_13 <= (slice1window_sum_0_13_choice + slice1window_change_0_13) mod 16384;
        slice1window_sum_0_14 <= (slice1window_sum_0_14_choice + slice1window_change_0_14) mod 16384;
        slice1window_sum_0_15 <= (slice1window_sum_0_15_choice + slice1window_change_0_15) mod 16384;
      end if;
      if slice0winner2_tag_valid then
        slice1window_centre_start_of_frame_3 <= slice3window_centre_start_of_frame_1;
        slice1window_centre_start_of_frame_4 <= slice1window_centre_start_of_frame_3;
        slice1window_centre_start_of_frame_5 <= slice1window_centre_start_of_frame_4;
      end if;
      -- slice1winner1
      slice1winner1_best_index_0_0_is_not_less := (slice1window_sum_0_0 - slice1window_sum_0_1) >= 0;
      slice1winner1_best_index_0_1_is_less := (slice1window_sum_0_2 - slice1window_sum_0_3) < 0;
      slice1winner1_best_index_0_2_is_less := (slice1window_sum_0_4 - slice1window_sum_0_5) < 0;
      slice1winner1_best_index_0_3_is_less := (slice1window_sum_0_6 - slice1window_sum_0_7) < 0;
      slice1winner1_best_index_0_4_is_less := (slice1window_sum_0_8 - slice1window_sum_0_9) < 0;
      slice1winner1_best_index_0_5_is_less := (slice1window_sum_0_10 - slice1window_sum_0_11) < 0;
      slice1winner1_best_index_0_6_is_less := (slice1window_sum_0_12 - slice1window_sum_0_13) < 0;
      slice1winner1_best_index_0_7_is_less := (slice1window_sum_0_14 - slice1window_sum_0_15) < 0;
      slice1winner1_held_0_0 <= slice1window_sum_0_0;
      slice1winner1_held_0_1 <= slice1window_sum_0_1;
      slice1winner1_held_0_2 <= slice1window_sum_0_2;
      slice1winner1_held_0_3 <= slice1window_sum_0_3;
      slice1winner1_held_0_4 <= slice1window_sum_0_4;
      slice1winner1_held_0_5 <= slice1window_sum_0_5;
      slice1winner1_held_0_6 <= slice1window_sum_0_6;
      slice1winner1_held_0_7 <= slice1window_sum_0_7;
      slice1winner1_held_0_8 <= slice1window_sum_0_8;
      slice1winner1_held_0_9 <= slice1window_sum_0_9;
      slice1winner1_held_0_10 <= slice1window_sum_0_10;
      slice1winner1_held_0_11 <= slice1window_sum_0_11;
      slice1winner1_held_0_12 <= slice1window_sum_0_12;
      slice1winner1_held_0_13 <= slice1window_sum_0_13;
      slice1winner1_held_0_14 <= slice1window_sum_0_14;
      slice1winner1_held_0_15 <= slice1window_sum_0_15;
      slice1winner1_best_index_0_0 <= slice1winner1_best_index_0_0_is_not_less;
      slice1winner1_best_late_cost_0_0 <= slice1winner1_best_cost_0_0;
      slice1winner1_best_late_cost_0_1 <= slice1winner1_best_cost_0_1;
      slice1winner1_best_late_cost_0_2 <= slice1winner1_best_cost_0_2;
      slice1winner1_best_late_cost_0_3 <= slice1winner1_best_cost_0_3;
      slice1winner1_best_late_cost_0_4 <= slice1winner1_best_cost_0_4;
      slice1winner1_best_late_cost_0_5 <= slice1winner1_best_cost_0_5;
      slice1winner1_best_late_cost_0_6 <= slice1winner1_best_cost_0_6;
      slice1winner1_best_late_cost_0_7 <= slice1winner1_best_cost_0_7;
      slice1winner1_best_but_first_0_0 <= slice1winner1_held_0_1;
      slice1winner1_best_but_first_0_1 <= slice1winner1_held_0_3;
      slice1winner1_best_but_first_0_2 <= slice1winner1_held_0_5;
      slice1winner1_best_but_first_0_3 <= slice1winner1_held_0_7;
      slice1winner1_best_but_first_0_4 <= slice1winner1_held_0_9;
      slice1winner1_best_but_first_0_5 <= slice1winner1_held_0_11;
      slice1winner1_best_but_first_0_6 <= slice1winner1_held_0_13;
      slice1winner1_best_but_first_0_7 <= slice1winner1_held_0_15;
      slice1winner1_best_but_last_0_0 <= slice1winner1_held_0_0;
      slice1winner1_best_but_last_0_1 <= slice1winner1_held_0_2;
      slice1winner1_best_but_last_0_2 <= slice1winner1_held_0_4;
      slice1winner1_best_but_last_0_3 <= slice1winner1_held_0_6;
      slice1winner1_best_but_last_0_4 <= slice1winner1_held_0_8;
      slice1winner1_best_but_last_0_5 <= slice1winner1_held_0_10;
      slice1winner1_best_but_last_0_6 <= slice1winner1_held_0_12;
      slice1winner1_best_but_last_0_7 <= slice1winner1_held_0_14;
      if (slice1window_sum_0_1 - slice1window_sum_0_0) < 0 then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      if (slice1window_sum_0_3 - slice1window_sum_0_2) < 0 then
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_3;
      else
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_2;
      end if;
      if (slice1window_sum_0_5 - slice1window_sum_0_4) < 0 then
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_5;
      else
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_4;
      end if;
      if (slice1window_sum_0_7 - slice1window_sum_0_6) < 0 then
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_7;
      else
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_6;
      end if;
      if (slice1window_sum_0_9 - slice1window_sum_0_8) < 0 then
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_9;
      else
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_8;
      end if;
      if (slice1window_sum_0_11 - slice1window_sum_0_10) < 0 then
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_11;
      else
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_10;
      end if;
      if (slice1window_sum_0_13 - slice1window_sum_0_12) < 0 then
        slice1winner1_best_cost_0_6 <= slice1window_sum_0_13;
      else
        slice1winner1_best_cost_0_6 <= slice1window_sum_0_12;
      end if;
      if (slice1window_sum_0_15 - slice1window_sum_0_14) < 0 then
        slice1winner1_best_cost_0_7 <= slice1window_sum_0_15;
      else
        slice1winner1_best_cost_0_7 <= slice1window_sum_0_14;
      end if;
      if slice1winner1_best_index_0_1_is_less then
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0_1 <= 0;
        slice1winner1_best_above_0_1 <= slice1window_sum_0_3;
      else
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0_1 <= slice1window_sum_0_2;
        slice1winner1_best_above_0_1 <= 0;
      end if;
      if slice1winner1_best_index_0_2_is_less then
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0_2 <= 0;
        slice1winner1_best_above_0_2 <= slice1window_sum_0_5;
      else
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0_2 <= slice1window_sum_0_4;
        slice1winner1_best_above_0_2 <= 0;
      end if;
      if slice1winner1_best_index_0_3_is_less then
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0_3 <= 0;
        slice1winner1_best_above_0_3 <= slice1window_sum_0_7;
      else
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0_3 <= slice1window_sum_0_6;
        slice1winner1_best_above_0_3 <= 0;
      end if;
      if slice1winner1_best_index_0_4_is_less then
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0_4 <= 0;
        slice1winner1_best_above_0_4 <= slice1window_sum_0_9;
      else
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0_4 <= slice1window_sum_0_8;
        slice1winner1_best_above_0_4 <= 0;
      end if;
      if slice1winner1_best_index_0_5_is_less then
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0_5 <= 0;
        slice1winner1_best_above_0_5 <= slice1window_sum_0_11;
      else
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0_5 <= slice1window_sum_0_10;
        slice1winner1_best_above_0_5 <= 0;
      end if;
      if slice1winner1_best_index_0_6_is_less then
        slice1winner1_best_index_0_6 <= 12;
        slice1winner1_best_below_0_6 <= 0;
        slice1winner1_best_above_0_6 <= slice1window_sum_0_13;
      else
        slice1winner1_best_index_0_6 <= 13;
        slice1winner1_best_below_0_6 <= slice1window_sum_0_12;
        slice1winner1_best_above_0_6 <= 0;
      end if;
      if slice1winner1_best_index_0_7_is_less then
        slice1winner1_best_index_0_7 <= 14;
        slice1winner1_best_below_0_7 <= 0;
        slice1winner1_best_above_0_7 <= slice1window_sum_0_15;
      else
        slice1winner1_best_index_0_7 <= 15;
        slice1winner1_best_below_0_7 <= slice1window_sum_0_14;
        slice1winner1_best_above_0_7 <= 0;
      end if;
      if slice1winner1_best_index_0_0_is_not_less then
        slice1winner1_best_below_0_0 <= slice1window_sum_0_0;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1window_sum_0_1;
      end if;
      -- slice1winner2
      slice1winner2_best_index_0_0_is_not_less := (slice1winner1_best_cost_0_0 - slice1winner1_best_cost_0_1) >= 0;
      slice1winner2_best_index_0_1_is_not_less := (slice1winner1_best_cost_0_2 - slice1winner1_best_cost_0_3) >= 0;
      slice1winner2_best_index_0_2_is_not_less := (slice1winner1_best_cost_0_4 - slice1winner1_best_cost_0_5) >= 0;
      slice1winner2_best_index_0_3_is_not_less := (slice1winner1_best_cost_0_6 - slice1winner1_best_cost_0_7) >= 0;
      if other_15 then
        slice1winner2_best_below_0_0_choice := slice1winner1_held_0_1;
      else
        slice1winner2_best_below_0_0_choice := slice1winner1_best_below_0_1;
      end if;
      if other_16 then
        slice1winner2_best_below_0_1_choice := slice1winner1_held_0_5;
      else
        slice1winner2_best_below_0_1_choice := slice1winner1_best_below_0_3;
      end if;
      if other_17 then
        slice1winner2_best_below_0_2_choice := slice1winner1_held_0_9;
      else
        slice1winner2_best_below_0_2_choice := slice1winner1_best_below_0_5;
      end if;
      if other_18 then
        slice1winner2_best_below_0_3_choice := slice1winner1_held_0_13;
      else
        slice1winner2_best_below_0_3_choice := slice1winner1_best_below_0_7;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_held_0_2;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      if ((slice1winner1_best_index_0_2 / 4) = 1) and ((slice1winner1_best_index_0_2 mod 2) = 1) then
        slice1winner2_best_above_0_1_choice := slice1winner1_held_0_6;
      else
        slice1winner2_best_above_0_1_choice := slice1winner1_best_above_0_2;
      end if;
      if ((slice1winner1_best_index_0_4 / 8) = 1) and ((slice1winner1_best_index_0_4 mod 2) = 1) then
        slice1winner2_best_above_0_2_choice := slice1winner1_held_0_10;
      else
        slice1winner2_best_above_0_2_choice := slice1winner1_best_above_0_4;
      end if;
      slice1winner2_best_above_0_3_value := ((slice1winner1_best_index_0_6 / 4) mod 2) = 1;
      if ((slice1winner1_best_index_0_6 / 8) = 1) and slice1winner2_best_above_0_3_value and
        ((slice1winner1_best_index_0_6 mod 2) = 1) then
        slice1winner2_best_above_0_3_choice := slice1winner1_held_0_14;
      else
        slice1winner2_best_above_0_3_choice := slice1winner1_best_above_0_6;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice := 16383;
      else
        slice1winner2_best_second_0_0_choice := slice1winner1_best_late_cost_0_1;
      end if;
      if slice1winner2_best_at_end_0_0 then
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_but_first_0_1;
      else
        slice1winner2_best_second_0_0_choice_2 := slice1winner2_best_second_0_0_choice;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice_3 := slice1winner1_best_late_cost_0_0;
      else
        slice1winner2_best_second_0_0_choice_3 := 16383;
      end if;
      if slice1winner2_best_at_start_0_0 then
        slice1winner2_best_second_0_0_choice_4 := slice1winner1_best_but_last_0_0;
      else
        slice1winner2_best_second_0_0_choice_4 := slice1winner2_best_second_0_0_choice_3;
      end if;
      if slice1winner2_best_place_0_1 then
        slice1winner2_best_second_0_1_choice := 16383;
      else
        slice1winner2_best_second_0_1_choice := slice1winner1_best_late_cost_0_3;
      end if;
      if slice1winner2_best_at_end_0_1 then
        slice1winner2_best_second_0_1_choice_2 := slice1winner1_best_but_first_0_3;
      else
        slice1winner2_best_second_0_1_choice_2 := slice1winner2_best_second_0_1_choice;
      end if;
      if slice1winner2_best_place_0_1 then
        slice1winner2_best_second_0_1_choice_3 := slice1winner1_best_late_cost_0_2;
      else
        slice1winner2_best_second_0_1_choice_3 := 16383;
      end if;
      if slice1winner2_best_at_start_0_1 then
        slice1winner2_best_second_0_1_choice_4 := slice1winner1_best_but_last_0_2;
      else
        slice1winner2_best_second_0_1_choice_4 := slice1winner2_best_second_0_1_choice_3;
      end if;
      if slice1winner2_best_place_0_2 then
        slice1winner2_best_second_0_2_choice := 16383;
      else
        slice1winner2_best_second_0_2_choice := slice1winner1_best_late_cost_0_5;
      end if;
      if slice1winner2_best_at_end_0_2 then
        slice1winner2_best_second_0_2_choice_2 := slice1winner1_best_but_first_0_5;
      else
        slice1winner2_best_second_0_2_choice_2 := slice1winner2_best_second_0_2_choice;
      end if;
      if slice1winner2_best_place_0_2 then
        slice1winner2_best_second_0_2_choice_3 := slice1winner1_best_late_cost_0_4;
      else
        slice1winner2_best_second_0_2_choice_3 := 16383;
      end if;
      if slice1winner2_best_at_start_0_2 then
        slice1winner2_best_second_0_2_choice_4 := slice1winner1_best_but_last_0_4;
      else
        slice1winner2_best_second_0_2_choice_4 := slice1winner2_best_second_0_2_choice_3;
      end if;
      if slice1winner2_best_place_0_3 then
        slice1winner2_best_second_0_3_choice := 16383;
      else
        slice1winner2_best_second_0_3_choice := slice1winner1_best_late_cost_0_7;
      end if;
      if slice1winner2_best_at_end_0_3 then
        slice1winner2_best_second_0_3_choice_2 := slice1winner1_best_but_first_0_7;
      else
        slice1winner2_best_second_0_3_choice_2 := slice1winner2_best_second_0_3_choice;
      end if;
      if slice1winner2_best_place_0_3 then
        slice1winner2_best_second_0_3_choice_3 := slice1winner1_best_late_cost_0_6;
      else
        slice1winner2_best_second_0_3_choice_3 := 16383;
      end if;
      if slice1winner2_best_at_start_0_3 then
        slice1winner2_best_second_0_3_choice_4 := slice1winner1_best_but_last_0_6;
      else
        slice1winner2_best_second_0_3_choice_4 := slice1winner2_best_second_0_3_choice_3;
      end if;
      slice1winner2_best_first_0_0 <= slice1winner1_held_0_0;
      slice1winner2_best_first_0_1 <= slice1winner1_held_0_4;
      slice1winner2_best_first_0_2 <= slice1winner1_held_0_8;
      slice1winner2_best_first_0_3 <= slice1winner1_held_0_12;
      slice1winner2_best_last_0_0 <= slice1winner1_held_0_3;
      slice1winner2_best_last_0_1 <= slice1winner1_held_0_7;
      slice1winner2_best_last_0_2 <= slice1winner1_held_0_11;
      slice1winner2_best_last_0_3 <= slice1winner1_held_0_15;
      slice1winner2_best_place_0_0 <= slice1winner2_best_index_0_0_is_not_less;
      slice1winner2_best_place_0_1 <= slice1winner2_best_index_0_1_is_not_less;
      slice1winner2_best_place_0_2 <= slice1winner2_best_index_0_2_is_not_less;
      slice1winner2_best_place_0_3 <= slice1winner2_best_index_0_3_is_not_less;
      slice1winner2_best_at_start_0_0 <= other_15 and slice1winner2_best_index_0_0_is_not_less;
      slice1winner2_best_at_start_0_1 <= other_16 and slice1winner2_best_index_0_1_is_not_less;
      slice1winner2_best_at_start_0_2 <= other_17 and slice1winner2_best_index_0_2_is_not_less;
      slice1winner2_best_at_start_0_3 <= other_18 and slice1winner2_best_index_0_3_is_not_less;
      slice1winner2_best_at_end_0_0 <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0_0 -
        slice1winner1_best_cost_0_1) < 0);
      slice1winner2_best_at_end_0_1 <= ((slice1winner1_best_cost_0_2 - slice1winner1_best_cost_0_3) < 0) and
        ((slice1winner1_best_index_0_2 / 4) = 1) and ((slice1winner1_best_index_0_2 mod 2) = 1);
      slice1winner2_best_at_end_0_2 <= ((slice1winner1_best_cost_0_4 - slice1winner1_best_cost_0_5) < 0) and
        ((slice1winner1_best_index_0_4 / 8) = 1) and ((slice1winner1_best_index_0_4 mod 2) = 1);
      slice1winner2_best_at_end_0_3 <= ((slice1winner1_best_cost_0_6 - slice1winner1_best_cost_0_7) < 0) and
        ((slice1winner1_best_index_0_6 / 8) = 1) and slice1winner2_best_above_0_3_value and
        ((slice1winner1_best_index_0_6 mod 2) = 1);
      slice1winner2_best_late_cost_0_0 <= slice1winner2_best_cost_0_0;
      slice1winner2_best_late_cost_0_1 <= slice1winner2_best_cost_0_1;
      slice1winner2_best_late_cost_0_2 <= slice1winner2_best_cost_0_2;
      slice1winner2_best_late_cost_0_3 <= slice1winner2_best_cost_0_3;
      if (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0 then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
      end if;
      if (slice1winner1_best_cost_0_3 - slice1winner1_best_cost_0_2) < 0 then
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_3;
      else
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_2;
      end if;
      if (slice1winner1_best_cost_0_5 - slice1winner1_best_cost_0_4) < 0 then
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_5;
      else
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_4;
      end if;
      if (slice1winner1_best_cost_0_7 - slice1winner1_best_cost_0_6) < 0 then
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_7;
      else
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_6;
      end if;
      if slice1winner2_best_index_0_0_is_not_less then
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
        slice1winner2_best_below_0_0 <= slice1winner2_best_below_0_0_choice;
        slice1winner2_best_above_0_0 <= slice1winner1_best_above_0_1;
      else
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0_0 <= slice1winner1_best_below_0_0;
        slice1winner2_best_above_0_0 <= slice1winner2_best_above_0_0_choice;
      end if;
      if slice1winner2_best_index_0_1_is_not_less then
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
        slice1winner2_best_below_0_1 <= slice1winner2_best_below_0_1_choice;
        slice1winner2_best_above_0_1 <= slice1winner1_best_above_0_3;
      else
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
        slice1winner2_best_below_0_1 <= slice1winner1_best_below_0_2;
        slice1winner2_best_above_0_1 <= slice1winner2_best_above_0_1_choice;
      end if;
      if slice1winner2_best_index_0_2_is_not_less then
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
        slice1winner2_best_below_0_2 <= slice1winner2_best_below_0_2_choice;
        slice1winner2_best_above_0_2 <= slice1winner1_best_above_0_5;
      else
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
        slice1winner2_best_below_0_2 <= slice1winner1_best_below_0_4;
        slice1winner2_best_above_0_2 <= slice1winner2_best_above_0_2_choice;
      end if;
      if slice1winner2_best_index_0_3_is_not_less then
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
        slice1winner2_best_below_0_3 <= slice1winner2_best_below_0_3_choice;
        slice1winner2_best_above_0_3 <= slice1winner1_best_above_0_7;
      else
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_6;
        slice1winner2_best_below_0_3 <= slice1winner1_best_below_0_6;
        slice1winner2_best_above_0_3 <= slice1winner2_best_above_0_3_choice;
      end if;
      if (slice1winner2_best_second_0_0_choice_2 - slice1winner2_best_second_0_0_choice_4) < 0 then
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_2;
      else
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_4;
      end if;
      if (slice1winner2_best_second_0_1_choice_2 - slice1winner2_best_second_0_1_choice_4) < 0 then
        slice1winner2_best_second_0_1 <= slice1winner2_best_second_0_1_choice_2;
      else
        slice1winner2_best_second_0_1 <= slice1winner2_best_second_0_1_choice_4;
      end if;
      if (slice1winner2_best_second_0_2_choice_2 - slice1winner2_best_second_0_2_choice_4) < 0 then
        slice1winner2_best_second_0_2 <= slice1winner2_best_second_0_2_choice_2;
      else
        slice1winner2_best_second_0_2 <= slice1winner2_best_second_0_2_choice_4;
      end if;
      if (slice1winner2_best_second_0_3_choice_2 - slice1winner2_best_second_0_3_choice_4) < 0 then
        slice1winner2_best_second_0_3 <= slice1winner2_best_second_0_3_choice_2;
      else
        slice1winner2_best_second_0_3 <= slice1winner2_best_second_0_3_choice_4;
      end if;
      if (slice1winner1_best_late_cost_0_1 - slice1winner1_best_but_first_0_0) < 0 then
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_but_first_0_0;
      end if;
      if (slice1winner1_best_late_cost_0_3 - slice1winner1_best_but_first_0_2) < 0 then
        slice1winner2_best_but_first_0_1 <= slice1winner1_best_late_cost_0_3;
      else
        slice1winner2_best_but_first_0_1 <= slice1winner1_best_but_first_0_2;
      end if;
      if (slice1winner1_best_late_cost_0_5 - slice1winner1_best_but_first_0_4) < 0 then
        slice1winner2_best_but_first_0_2 <= slice1winner1_best_late_cost_0_5;
      else
        slice1winner2_best_but_first_0_2 <= slice1winner1_best_but_first_0_4;
      end if;
      if (slice1winner1_best_late_cost_0_7 - slice1winner1_best_but_first_0_6) < 0 then
        slice1winner2_best_but_first_0_3 <= slice1winner1_best_late_cost_0_7;
      else
        slice1winner2_best_but_first_0_3 <= slice1winner1_best_but_first_0_6;
      end if;
      if (slice1winner1_best_but_last_0_1 - slice1winner1_best_late_cost_0_0) < 0 then
        slice1winner2_best_but_last_0_0 <= slice1winner1_best_but_last_0_1;
      else
        slice1winner2_best_but_last_0_0 <= slice1winner1_best_late_cost_0_0;
      end if;
      if (slice1winner1_best_but_last_0_3 - slice1winner1_best_late_cost_0_2) < 0 then
        slice1winner2_best_but_last_0_1 <= slice1winner1_best_but_last_0_3;
      else
        slice1winner2_best_but_last_0_1 <= slice1winner1_best_late_cost_0_2;
      end if;
      if (slice1winner1_best_but_last_0_5 - slice1winner1_best_late_cost_0_4) < 0 then
        slice1winner2_best_but_last_0_2 <= slice1winner1_best_but_last_0_5;
      else
        slice1winner2_best_but_last_0_2 <= slice1winner1_best_late_cost_0_4;
      end if;
      if (slice1winner1_best_but_last_0_7 - slice1winner1_best_late_cost_0_6) < 0 then
        slice1winner2_best_but_last_0_3 <= slice1winner1_best_but_last_0_7;
      else
        slice1winner2_best_but_last_0_3 <= slice1winner1_best_late_cost_0_6;
      end if;
      -- slice1winner3
      slice1winner3_best_index_0_0_is_not_less := (slice1winner2_best_cost_0_0 - slice1winner2_best_cost_0_1) >= 0;
      slice1winner3_best_index_0_1_is_not_less := (slice1winner2_best_cost_0_2 - slice1winner2_best_cost_0_3) >= 0;
      slice1winner3_best_below_0_0_is_equal := slice1winner2_best_index_0_1 = 4;
      if slice1winner3_best_below_0_0_is_equal then
        slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0;
      else
        slice1winner3_best_below_0_0_choice := slice1winner2_best_below_0_1;
      end if;
      slice1winner3_best_below_0_1_is_equal := slice1winner2_best_index_0_3 = 12;
      if slice1winner3_best_below_0_1_is_equal then
        slice1winner3_best_below_0_1_choice := slice1winner2_best_last_0_2;
      else
        slice1winner3_best_below_0_1_choice := slice1winner2_best_below_0_3;
      end if;
      slice1winner3_best_above_0_0_is_equal := slice1winner2_best_index_0_0 = 3;
      if slice1winner3_best_above_0_0_is_equal then
        slice1winner3_best_above_0_0_choice := slice1winner2_best_first_0_1;
      else
        slice1winner3_best_above_0_0_choice := slice1winner2_best_above_0_0;
      end if;
      slice1winner3_best_above_0_1_is_equal := (slice1winner2_best_index_0_2 mod 4) = 3;
      if ((slice1winner2_best_index_0_2 / 8) = 1) and slice1winner3_best_above_0_1_is_equal then
        slice1winner3_best_above_0_1_choice := slice1winner2_best_first_0_3;
      else
        slice1winner3_best_above_0_1_choice := slice1winner2_best_above_0_2;
      end if;
      if slice1winner3_best_place_0_0 then
        slice1winner3_best_second_0_0_choice := slice1winner2_best_second_0_1;
      else
        slice1winner3_best_second_0_0_choice := slice1winner2_best_late_cost_0_1;
      end if;
      if slice1winner3_best_at_end_0_0 then
        slice1winner3_best_second_0_0_choice_2 := slice1winner2_best_but_first_0_1;
      else
        slice1winner3_best_second_0_0_choice_2 := slice1winner3_best_second_0_0_choice;
      end if;
      if slice1winner3_best_place_0_0 then
        slice1winner3_best_second_0_0_choice_3 := slice1winner2_best_late_cost_0_0;
      else
        slice1winner3_best_second_0_0_choice_3 := slice1winner2_best_second_0_0;
      end if;
      if slice1winner3_best_at_start_0_0 then
        slice1winner3_best_second_0_0_choice_4 := slice1winner2_best_but_last_0_0;
      else
        slice1winner3_best_second_0_0_choice_4 := slice1winner3_best_second_0_0_choice_3;
      end if;
      if slice1winner3_best_place_0_1 then
        slice1winner3_best_second_0_1_choice := slice1winner2_best_second_0_3;
      else
        slice1winner3_best_second_0_1_choice := slice1winner2_best_late_cost_0_3;
      end if;
      if slice1winner3_best_at_end_0_1 then
        slice1winner3_best_second_0_1_choice_2 := slice1winner2_best_but_first_0_3;
      else
        slice1winner3_best_second_0_1_choice_2 := slice1winner3_best_second_0_1_choice;
      end if;
      if slice1winner3_best_place_0_1 then
        slice1winner3_best_second_0_1_choice_3 := slice1winner2_best_late_cost_0_2;
      else
        slice1winner3_best_second_0_1_choice_3 := slice1winner2_best_second_0_2;
      end if;
      if slice1winner3_best_at_start_0_1 then
        slice1winner3_best_second_0_1_choice_4 := slice1winner2_best_but_last_0_2;
      else
        slice1winner3_best_second_0_1_choice_4 := slice1winner3_best_second_0_1_choice_3;
      end if;
      slice1winner3_best_first_0_0 <= slice1winner2_best_first_0_0;
      slice1winner3_best_first_0_1 <= slice1winner2_best_first_0_2;
      slice1winner3_best_last_0_0 <= slice1winner2_best_last_0_1;
      slice1winner3_best_last_0_1 <= slice1winner2_best_last_0_3;
      slice1winner3_best_place_0_0 <= slice1winner3_best_index_0_0_is_not_less;
      slice1winner3_best_place_0_1 <= slice1winner3_best_index_0_1_is_not_less;
      slice1winner3_best_at_start_0_0 <= slice1winner3_best_index_0_0_is_not_less and
        slice1winner3_best_below_0_0_is_equal;
      slice1winner3_best_at_start_0_1 <= slice1winner3_best_below_0_1_is_equal and
        slice1winner3_best_index_0_1_is_not_less;
      slice1winner3_best_at_end_0_0 <= ((slice1winner2_best_cost_0_0 - slice1winner2_best_cost_0_1) < 0) and
        slice1winner3_best_above_0_0_is_equal;
      slice1winner3_best_at_end_0_1 <= ((slice1winner2_best_cost_0_2 - slice1winner2_best_cost_0_3) < 0) and
        ((slice1winner2_best_index_0_2 / 8) = 1) and slice1winner3_best_above_0_1_is_equal;
      slice1winner3_best_late_cost_0_0 <= slice1winner3_best_cost_0_0;
      slice1winner3_best_late_cost_0_1 <= slice1winner3_best_cost_0_1;
      if (slice1winner2_best_cost_0_1 - slice1winner2_best_cost_0_0) < 0 then
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_1;
      else
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
      end if;
      if (slice1winner2_best_cost_0_3 - slice1winner2_best_cost_0_2) < 0 then
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_3;
      else
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_2;
      end if;
      if slice1winner3_best_index_0_0_is_not_less then
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0_0 <= slice1winner3_best_below_0_0_choice;
        slice1winner3_best_above_0_0 <= slice1winner2_best_above_0_1;
      else
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0_0 <= slice1winner2_best_below_0_0;
        slice1winner3_best_above_0_0 <= slice1winner3_best_above_0_0_choice;
      end if;
      if slice1winner3_best_index_0_1_is_not_less then
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
        slice1winner3_best_below_0_1 <= slice1winner3_best_below_0_1_choice;
        slice1winner3_best_above_0_1 <= slice1winner2_best_above_0_3;
      else
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
        slice1winner3_best_below_0_1 <= slice1winner2_best_below_0_2;
        slice1winner3_best_above_0_1 <= slice1winner3_best_above_0_1_choice;
      end if;
      if (slice1winner3_best_second_0_0_choice_2 - slice1winner3_best_second_0_0_choice_4) < 0 then
        slice1winner3_best_second_0_0 <= slice1winner3_best_second_0_0_choice_2;
      else
        slice1winner3_best_second_0_0 <= slice1winner3_best_second_0_0_choice_4;
      end if;
      if (slice1winner3_best_second_0_1_choice_2 - slice1winner3_best_second_0_1_choice_4) < 0 then
        slice1winner3_best_second_0_1 <= slice1winner3_best_second_0_1_choice_2;
      else
        slice1winner3_best_second_0_1 <= slice1winner3_best_second_0_1_choice_4;
      end if;
      if (slice1winner2_best_late_cost_0_1 - slice1winner2_best_but_first_0_0) < 0 then
        slice1winner3_best_but_first_0_0 <= slice1winner2_best_late_cost_0_1;
      else
        slice1winner3_best_but_first_0_0 <= slice1winner2_best_but_first_0_0;
      end if;
      if (slice1winner2_best_late_cost_0_3 - slice1winner2_best_but_first_0_2) < 0 then
        slice1winner3_best_but_first_0_1 <= slice1winner2_best_late_cost_0_3;
      else
        slice1winner3_best_but_first_0_1 <= slice1winner2_best_but_first_0_2;
      end if;
      if (slice1winner2_best_but_last_0_1 - slice1winner2_best_late_cost_0_0) < 0 then
        slice1winner3_best_but_last_0_0 <= slice1winner2_best_but_last_0_1;
      else
        slice1winner3_best_but_last_0_0 <= slice1winner2_best_late_cost_0_0;
      end if;
      if (slice1winner2_best_but_last_0_3 - slice1winner2_best_late_cost_0_2) < 0 then
        slice1winner3_best_but_last_0_1 <= slice1winner2_best_but_last_0_3;
      else
        slice1winner3_best_but_last_0_1 <= slice1winner2_best_late_cost_0_2;
      end if;
      -- slice1winner4
      slice1winner4_best_index_0_0_is_less := (slice1winner3_best_cost_0_0 - slice1winner3_best_cost_0_1) < 0;
      slice1winner4_best_below_0_0_is_equal := slice1winner3_best_index_0_1 = 8;
      if slice1winner4_best_below_0_0_is_equal then
        slice1winner4_best_below_0_0_choice := slice1winner3_best_last_0_0;
      else
        slice1winner4_best_below_0_0_choice := slice1winner3_best_below_0_1;
      end if;
      slice1winner4_best_above_0_0_is_equal := slice1winner3_best_index_0_0 = 7;
      if slice1winner4_best_above_0_0_is_equal then
        slice1winner4_best_above_0_0_choice := slice1winner3_best_first_0_1;
      else
        slice1winner4_best_above_0_0_choice := slice1winner3_best_above_0_0;
      end if;
      slice1winner4_best_place_0_0_is_not_less := (slice1winner3_best_cost_0_0 - slice1winner3_best_cost_0_1) >= 0;
      if slice1winner4_best_place_0_0 then
        slice1winner4_best_second_0_0_choice := slice1winner3_best_second_0_1;
      else
        slice1winner4_best_second_0_0_choice := slice1winner3_best_late_cost_0_1;
      end if;
      if slice1winner4_best_at_end_0_0 then
        slice1winner4_best_second_0_0_choice_2 := slice1winner3_best_but_first_0_1;
      else
        slice1winner4_best_second_0_0_choice_2 := slice1winner4_best_second_0_0_choice;
      end if;
      if slice1winner4_best_place_0_0 then
        slice1winner4_best_second_0_0_choice_3 := slice1winner3_best_late_cost_0_0;
      else
        slice1winner4_best_second_0_0_choice_3 := slice1winner3_best_second_0_0;
      end if;
      if slice1winner4_best_at_start_0_0 then
        slice1winner4_best_second_0_0_choice_4 := slice1winner3_best_but_last_0_0;
      else
        slice1winner4_best_second_0_0_choice_4 := slice1winner4_best_second_0_0_choice_3;
      end if;
      slice1winner4_best_first_0_0 <= slice1winner3_best_first_0_0;
      slice1winner4_best_last_0_0 <= slice1winner3_best_last_0_1;
      slice1winner4_best_place_0_0 <= slice1winner4_best_place_0_0_is_not_less;
      slice1winner4_best_at_start_0_0 <= slice1winner4_best_below_0_0_is_equal and
        slice1winner4_best_place_0_0_is_not_less;
      slice1winner4_best_at_end_0_0 <= slice1winner4_best_index_0_0_is_less and slice1winner4_best_above_0_0_is_equal;
      slice1winner4_best_late_cost_0_0 <= slice1winner4_best_cost_0_0;
      if (slice1winner3_best_cost_0_1 - slice1winner3_best_cost_0_0) < 0 then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_1;
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_0;
      end if;
      if slice1winner4_best_index_0_0_is_less then
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1winner4_best_below_0_0 <= slice1winner3_best_below_0_0;
        slice1winner4_best_above_0_0 <= slice1winner4_best_above_0_0_choice;
      else
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
        slice1winner4_best_below_0_0 <= slice1winner4_best_below_0_0_choice;
        slice1winner4_best_above_0_0 <= slice1winner3_best_above_0_1;
      end if;
      if (slice1winner4_best_second_0_0_choice_2 - slice1winner4_best_second_0_0_choice_4) < 0 then
        slice1winner4_best_second_0_0 <= slice1winner4_best_second_0_0_choice_2;
      else
        slice1winner4_best_second_0_0 <= slice1winner4_best_second_0_0_choice_4;
      end if;
      if (slice1winner3_best_late_cost_0_1 - slice1winner3_best_but_first_0_0) < 0 then
        slice1winner4_best_but_first_0_0 <= slice1winner3_best_late_cost_0_1;
      else
        slice1winner4_best_but_first_0_0 <= slice1winner3_best_but_first_0_0;
      end if;
      if (slice1winner3_best_but_last_0_1 - slice1winner3_best_late_cost_0_0) < 0 then
        slice1winner4_best_but_last_0_0 <= slice1winner3_best_but_last_0_1;
      else
        slice1winner4_best_but_last_0_0 <= slice1winner3_best_late_cost_0_0;
      end if;
      -- slice1
      slice1_best_index_0_0_is_less := (slice0winner4_best_late_cost_0_0 - slice1winner4_best_cost_0_0) < 0;
      slice1_best_below_0_0_is_equal := slice1winner4_best_index_0_0 = 0;
      if slice1_best_below_0_0_is_equal then
        slice1_best_below_0_0_choice := slice0_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice1winner4_best_below_0_0;
      end if;
      slice1_best_above_0_0_is_equal := slice0_best_index_0_0 = 15;
      if slice1_best_above_0_0_is_equal then
        slice1_best_above_0_0_choice := slice1winner4_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice0_best_above_0_0;
      end if;
      slice1_best_place_0_0_is_not_less := (slice0winner4_best_late_cost_0_0 - slice1winner4_best_cost_0_0) >= 0;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice := slice1winner4_best_second_0_0;
      else
        slice1_best_second_0_0_choice := slice1winner4_best_late_cost_0_0;
      end if;
      if slice1_best_at_end_0_0 then
        slice1_best_second_0_0_choice_2 := slice1winner4_best_but_first_0_0;
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
      slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
      slice1_best_place_0_0 <= slice1_best_place_0_0_is_not_less;
      slice1_best_at_start_0_0 <= slice1_best_below_0_0_is_equal and slice1_best_place_0_0_is_not_less;
      slice1_best_at_end_0_0 <= slice1_best_above_0_0_is_equal and slice1_best_index_0_0_is_less;
      slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice1winner4_best_cost_0_0 - slice0winner4_best_late_cost_0_0) < 0 then
        slice1_best_cost_0_0 <= slice1winner4_best_cost_0_0;
      else
        slice1_best_cost_0_0 <= slice0winner4_best_late_cost_0_0;
      end if;
      if slice1_best_index_0_0_is_less then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      else
        slice1_best_index_0_0 <= slice1winner4_best_index_0_0 + 16;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner4_best_above_0_0;
      end if;
      if (slice1_best_second_0_0_choice_2 - slice1_best_second_0_0_choice_4) < 0 then
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_2;
      else
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_4;
      end if;
      if (slice1winner4_best_but_last_0_0 - slice0_best_late_cost_0_0) < 0 then
        slice1_best_but_last_0_0 <= slice1winner4_best_but_last_0_0;
      else
        slice1_best_but_last_0_0 <= slice0_best_late_cost_0_0;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice1shift_search_out_0;
        slice2shift_search_0_1 <= slice2shift_search_0_0;
        slice2shift_search_0_2 <= slice2shift_search_0_1;
        slice2shift_search_0_3 <= slice2shift_search_0_2;
        slice2shift_search_0_4 <= slice2shift_search_0_3;
        slice2shift_search_0_5 <= slice2shift_search_0_4;
        slice2shift_search_0_6 <= slice2shift_search_0_5;
        slice2shift_search_0_7 <= slice2shift_search_0_6;
        slice2shift_search_0_8 <= slice2shift_search_0_7;
        slice2shift_search_0_9 <= slice2shift_search_0_8;
        slice2shift_search_0_10 <= slice2shift_search_0_9;
        slice2shift_search_0_11 <= slice2shift_search_0_10;
        slice2shift_search_0_12 <= slice2shift_search_0_11;
        slice2shift_search_0_13 <= slice2shift_search_0_12;
        slice2shift_search_0_14 <= slice2shift_search_0_13;
        slice2shift_search_0_15 <= slice2shift_search_0_14;
        slice2shift_search_1_0 <= slice1shift_search_out_1;
        slice2shift_search_1_1 <= slice2shift_search_1_0;
        slice2shift_search_1_2 <= slice2shift_search_1_1;
        slice2shift_search_1_3 <= slice2shift_search_1_2;
        slice2shift_search_1_4 <= slice2shift_search_1_3;
        slice2shift_search_1_5 <= slice2shift_search_1_4;
        slice2shift_search_1_6 <= slice2shift_search_1_5;
        slice2shift_search_1_7 <= slice2shift_search_1_6;
        slice2shift_search_1_8 <= slice2shift_search_1_7;
        slice2shift_search_1_9 <= slice2shift_search_1_8;
        slice2shift_search_1_10 <= slice2shift_search_1_9;
        slice2shift_search_1_11 <= slice2shift_search_1_10;
        slice2shift_search_1_12 <= slice2shift_search_1_11;
        slice2shift_search_1_13 <= slice2shift_search_1_12;
        slice2shift_search_1_14 <= slice2shift_search_1_13;
        slice2shift_search_1_15 <= slice2shift_search_1_14;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_search_out_0 <= slice2shift_search_0_15;
      slice2shift_search_out_1 <= slice2shift_search_1_15;
      -- slice2cost
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_0_choice := 0;
      else
        slice2cost_column_0_0_choice := slice2cost_ready_words_0 mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_0_choice_2 := 0;
      else
        slice2cost_column_0_0_choice_2 := (slice2cost_change_0_0 + slice2cost_column_0_0_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_1_choice := 0;
      else
        slice2cost_column_0_1_choice := (slice2cost_ready_words_0 / 1024) mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_1_choice_2 := 0;
      else
        slice2cost_column_0_1_choice_2 := (slice2cost_change_0_1 + slice2cost_column_0_1_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_2_choice := 0;
      else
        slice2cost_column_0_2_choice := slice2cost_ready_words_0 / 1048576;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_2_choice_2 := 0;
      else
        slice2cost_column_0_2_choice_2 := (slice2cost_change_0_2 + slice2cost_column_0_2_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_3_choice := 0;
      else
        slice2cost_column_0_3_choice := slice2cost_ready_words_1 mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_3_choice_2 := 0;
      else
        slice2cost_column_0_3_choice_2 := (slice2cost_change_0_3 + slice2cost_column_0_3_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_4_choice := 0;
      else
        slice2cost_column_0_4_choice := (slice2cost_ready_words_1 / 1024) mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_4_choice_2 := 0;
      else
        slice2cost_column_0_4_choice_2 := (slice2cost_change_0_4 + slice2cost_column_0_4_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_5_choice := 0;
      else
        slice2cost_column_0_5_choice := slice2cost_ready_words_1 / 1048576;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_5_choice_2 := 0;
      else
        slice2cost_column_0_5_choice_2 := (slice2cost_change_0_5 + slice2cost_column_0_5_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_6_choice := 0;
      else
        slice2cost_column_0_6_choice := slice2cost_ready_words_2 mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_6_choice_2 := 0;
      else
        slice2cost_column_0_6_choice_2 := (slice2cost_change_0_6 + slice2cost_column_0_6_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_7_choice := 0;
      else
        slice2cost_column_0_7_choice := (slice2cost_ready_words_2 / 1024) mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_7_choice_2 := 0;
      else
        slice2cost_column_0_7_choice_2 := (slice2cost_change_0_7 + slice2cost_column_0_7_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_8_choice := 0;
      else
        slice2cost_column_0_8_choice := slice2cost_ready_words_2 / 1048576;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_8_choice_2 := 0;
      else
        slice2cost_column_0_8_choice_2 := (slice2cost_change_0_8 + slice2cost_column_0_8_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_9_choice := 0;
      else
        slice2cost_column_0_9_choice := slice2cost_ready_words_3 mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_9_choice_2 := 0;
      else
        slice2cost_column_0_9_choice_2 := (slice2cost_change_0_9 + slice2cost_column_0_9_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_10_choice := 0;
      else
        slice2cost_column_0_10_choice := (slice2cost_ready_words_3 / 1024) mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_10_choice_2 := 0;
      else
        slice2cost_column_0_10_choice_2 := (slice2cost_change_0_10 + slice2cost_column_0_10_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_11_choice := 0;
      else
        slice2cost_column_0_11_choice := slice2cost_ready_words_3 / 1048576;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_11_choice_2 := 0;
      else
        slice2cost_column_0_11_choice_2 := (slice2cost_change_0_11 + slice2cost_column_0_11_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_12_choice := 0;
      else
        slice2cost_column_0_12_choice := slice2cost_ready_words_4 mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_12_choice_2 := 0;
      else
        slice2cost_column_0_12_choice_2 := (slice2cost_change_0_12 + slice2cost_column_0_12_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_13_choice := 0;
      else
        slice2cost_column_0_13_choice := (slice2cost_ready_words_4 / 1024) mod 1024;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_13_choice_2 := 0;
      else
        slice2cost_column_0_13_choice_2 := (slice2cost_change_0_13 + slice2cost_column_0_13_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_14_choice := 0;
      else
        slice2cost_column_0_14_choice := slice2cost_ready_words_4 / 1048576;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_14_choice_2 := 0;
      else
        slice2cost_column_0_14_choice_2 := (slice2cost_change_0_14 + slice2cost_column_0_14_choice) mod 1024;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_15_choice := 0;
      else
        slice2cost_column_0_15_choice := slice2cost_ready_words_5;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_15_choice_2 := 0;
      else
        slice2cost_column_0_15_choice_2 := (slice2cost_change_0_15 + slice2cost_column_0_15_choice) mod 1024;
      end if;
      slice2cost_pixels_first_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_pixels_first_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_pixels_first_0_2 <= slice2shift_search_0_2 - slice2shift_reference_0;
      slice2cost_pixels_first_0_3 <= slice2shift_search_0_3 - slice2shift_reference_0;
      slice2cost_pixels_first_0_4 <= slice2shift_search_0_4 - slice2shift_reference_0;
      slice2cost_pixels_first_0_5 <= slice2shift_search_0_5 - slice2shift_reference_0;
      slice2cost_pixels_first_0_6 <= slice2shift_search_0_6 - slice2shift_reference_0;
      slice2cost_pixels_first_0_7 <= slice2shift_search_0_7 - slice2shift_reference_0;
      slice2cost_pixels_first_0_8 <= slice2shift_search_0_8 - slice2shift_reference_0;
      slice2cost_pixels_first_0_9 <= slice2shift_search_0_9 - slice2shift_reference_0;
      slice2cost_pixels_first_0_10 <= slice2shift_search_0_10 - slice2shift_reference_0;
      slice2cost_pixels_first_0_11 <= slice2shift_search_0_11 - slice2shift_reference_0;
      slice2cost_pixels_first_0_12 <= slice2shift_search_0_12 - slice2shift_reference_0;
      slice2cost_pixels_first_0_13 <= slice2shift_search_0_13 - slice2shift_reference_0;
      slice2cost_pixels_first_0_14 <= slice2shift_search_0_14 - slice2shift_reference_0;
      slice2cost_pixels_first_0_15 <= slice2shift_search_0_15 - slice2shift_reference_0;
      slice2cost_pixels_first_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_pixels_first_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_pixels_first_1_2 <= slice2shift_search_1_2 - slice2shift_reference_1;
      slice2cost_pixels_first_1_3 <= slice2shift_search_1_3 - slice2shift_reference_1;
      slice2cost_pixels_first_1_4 <= slice2shift_search_1_4 - slice2shift_reference_1;
      slice2cost_pixels_first_1_5 <= slice2shift_search_1_5 - slice2shift_reference_1;
      slice2cost_pixels_first_1_6 <= slice2shift_search_1_6 - slice2shift_reference_1;
      slice2cost_pixels_first_1_7 <= slice2shift_search_1_7 - slice2shift_reference_1;
      slice2cost_pixels_first_1_8 <= slice2shift_search_1_8 - slice2shift_reference_1;
      slice2cost_pixels_first_1_9 <= slice2shift_search_1_9 - slice2shift_reference_1;
      slice2cost_pixels_first_1_10 <= slice2shift_search_1_10 - slice2shift_reference_1;
      slice2cost_pixels_first_1_11 <= slice2shift_search_1_11 - slice2shift_reference_1;
      slice2cost_pixels_first_1_12 <= slice2shift_search_1_12 - slice2shift_reference_1;
      slice2cost_pixels_first_1_13 <= slice2shift_search_1_13 - slice2shift_reference_1;
      slice2cost_pixels_first_1_14 <= slice2shift_search_1_14 - slice2shift_reference_1;
      slice2cost_pixels_first_1_15 <= slice2shift_search_1_15 - slice2shift_reference_1;
      slice2cost_pixels_cost_0_0 <= folded(slice2cost_pixels_first_0_0) + as_number((slice2cost_pixels_first_0_0 < 0));
      slice2cost_pixels_cost_0_1 <= folded(slice2cost_pixels_first_0_1) + as_number((slice2cost_pixels_first_0_1 < 0));
      slice2cost_pixels_cost_0_2 <= folded(slice2cost_pixels_first_0_2) + as_number((slice2cost_pixels_first_0_2 < 0));
      slice2cost_pixels_cost_0_3 <= folded(slice2cost_pixels_first_0_3) + as_number((slice2cost_pixels_first_0_3 < 0));
      slice2cost_pixels_cost_0_4 <= folded(slice2cost_pixels_first_0_4) + as_number((slice2cost_pixels_first_0_4 < 0));
      slice2cost_pixels_cost_0_5 <= folded(slice2cost_pixels_first_0_5) + as_number((slice2cost_pixels_first_0_5 < 0));
      slice2cost_pixels_cost_0_6 <= folded(slice2cost_pixels_first_0_6) + as_number((slice2cost_pixels_first_0_6 < 0));
      slice2cost_pixels_cost_0_7 <= folded(slice2cost_pixels_first_0_7) + as_number((slice2cost_pixels_first_0_7 < 0));
      slice2cost_pixels_cost_0_8 <= folded(slice2cost_pixels_first_0_8) + as_number((slice2cost_pixels_first_0_8 < 0));
      slice2cost_pixels_cost_0_9 <= folded(slice2cost_pixels_first_0_9) + as_number((slice2cost_pixels_first_0_9 < 0));
      slice2cost_pixels_cost_0_10 <= folded(slice2cost_pixels_first_0_10) + as_number((slice2cost_pixels_first_0_10 <
        0));
      slice2cost_pixels_cost_0_11 <= folded(slice2cost_pixels_first_0_11) + as_number((slice2cost_pixels_first_0_11 <
        0));
      slice2cost_pixels_cost_0_12 <= folded(slice2cost_pixels_first_0_12) + as_number((slice2cost_pixels_first_0_12 <
        0));
      slice2cost_pixels_cost_0_13 <= folded(slice2cost_pixels_first_0_13) + as_number((slice2cost_pixels_first_0_13 <
        0));
      slice2cost_pixels_cost_0_14 <= folded(slice2cost_pixels_first_0_14) + as_number((slice2cost_pixels_first_0_14 <
        0));
      slice2cost_pixels_cost_0_15 <= folded(slice2cost_pixels_first_0_15) + as_number((slice2cost_pixels_first_0_15 <
        0));
      slice2cost_pixels_cost_1_0 <= folded(slice2cost_pixels_first_1_0) + as_number((slice2cost_pixels_first_1_0 < 0));
      slice2cost_pixels_cost_1_1 <= folded(slice2cost_pixels_first_1_1) + as_number((slice2cost_pixels_first_1_1 < 0));
      slice2cost_pixels_cost_1_2 <= folded(slice2cost_pixels_first_1_2) + as_number((slice2cost_pixels_first_1_2 < 0));
      slice2cost_pixels_cost_1_3 <= folded(slice2cost_pixels_first_1_3) + as_number((slice2cost_pixels_first_1_3 < 0));
      slice2cost_pixels_cost_1_4 <= folded(slice2cost_pixels_first_1_4) + as_number((slice2cost_pixels_first_1_4 < 0));
      slice2cost_pixels_cost_1_5 <= folded(slice2cost_pixels_first_1_5) + as_number((slice2cost_pixels_first_1_5 < 0));
      slice2cost_pixels_cost_1_6 <= folded(slice2cost_pixels_first_1_6) + as_number((slice2cost_pixels_first_1_6 < 0));
      slice2cost_pixels_cost_1_7 <= folded(slice2cost_pixels_first_1_7) + as_number((slice2cost_pixels_first_1_7 < 0));
      slice2cost_pixels_cost_1_8 <= folded(slice2cost_pixels_first_1_8) + as_number((slice2cost_pixels_first_1_8 < 0));
      slice2cost_pixels_cost_1_9 <= folded(slice2cost_pixels_first_1_9) + as_number((slice2cost_pixels_first_1_9 < 0));
      slice2cost_pixels_cost_1_10 <= folded(slice2cost_pixels_first_1_10) + as_number((slice2cost_pixels_first_1_10 <
        0));
      slice2cost_pixels_cost_1_11 <= folded(slice2cost_pixels_first_1_11) + as_number((slice2cost_pixels_first_1_11 <
        0));
      slice2cost_pixels_cost_1_12 <= folded(slice2cost_pixels_first_1_12) + as_number((slice2cost_pixels_first_1_12 <
        0));
      slice2cost_pixels_cost_1_13 <= folded(slice2cost_pixels_first_1_13) + as_number((slice2cost_pixels_first_1_13 <
        0));
      slice2cost_pixels_cost_1_14 <= folded(slice2cost_pixels_first_1_14) + as_number((slice2cost_pixels_first_1_14 <
        0));
      slice2cost_pixels_cost_1_15 <= folded(slice2cost_pixels_first_1_15) + as_number((slice2cost_pixels_first_1_15 <
        0));
      slice2cost_change_0_0 <= slice2cost_pixels_cost_1_0 - slice2cost_pixels_cost_0_0;
      slice2cost_change_0_1 <= slice2cost_pixels_cost_1_1 - slice2cost_pixels_cost_0_1;
      slice2cost_change_0_2 <= slice2cost_pixels_cost_1_2 - slice2cost_pixels_cost_0_2;
      slice2cost_change_0_3 <= slice2cost_pixels_cost_1_3 - slice2cost_pixels_cost_0_3;
      slice2cost_change_0_4 <= slice2cost_pixels_cost_1_4 - slice2cost_pixels_cost_0_4;
      slice2cost_change_0_5 <= slice2cost_pixels_cost_1_5 - slice2cost_pixels_cost_0_5;
      slice2cost_change_0_6 <= slice2cost_pixels_cost_1_6 - slice2cost_pixels_cost_0_6;
      slice2cost_change_0_7 <= slice2cost_pixels_cost_1_7 - slice2cost_pixels_cost_0_7;
      slice2cost_change_0_8 <= slice2cost_pixels_cost_1_8 - slice2cost_pixels_cost_0_8;
      slice2cost_change_0_9 <= slice2cost_pixels_cost_1_9 - slice2cost_pixels_cost_0_9;
      slice2cost_change_0_10 <= slice2cost_pixels_cost_1_10 - slice2cost_pixels_cost_0_10;
      slice2cost_change_0_11 <= slice2cost_pixels_cost_1_11 - slice2cost_pixels_cost_0_11;
      slice2cost_change_0_12 <= slice2cost_pixels_cost_1_12 - slice2cost_pixels_cost_0_12;
      slice2cost_change_0_13 <= slice2cost_pixels_cost_1_13 - slice2cost_pixels_cost_0_13;
      slice2cost_change_0_14 <= slice2cost_pixels_cost_1_14 - slice2cost_pixels_cost_0_14;
      slice2cost_change_0_15 <= slice2cost_pixels_cost_1_15 - slice2cost_pixels_cost_0_15;
      slice2cost_ready_words_0 <= to_integer(slice2cost_read_words_0);
      slice2cost_ready_words_1 <= to_integer(slice2cost_read_words_1);
      slice2cost_ready_words_2 <= to_integer(slice2cost_read_words_2);
      slice2cost_ready_words_3 <= to_integer(slice2cost_read_words_3);
      slice2cost_ready_words_4 <= to_integer(slice2cost_read_words_4);
      slice2cost_ready_words_5 <= to_integer(slice2cost_read_words_5);
      slice2cost_ready_column <= slice2cost_change_column;
      slice2cost_column_0_0 <= slice2cost_column_0_0_choice_2;
      slice2cost_column_0_1 <= slice2cost_column_0_1_choice_2;
      slice2cost_column_0_2 <= slice2cost_column_0_2_choice_2;
      slice2cost_column_0_3 <= slice2cost_column_0_3_choice_2;
      slice2cost_column_0_4 <= slice2cost_column_0_4_choice_2;
      slice2cost_column_0_5 <= slice2cost_column_0_5_choice_2;
      slice2cost_column_0_6 <= slice2cost_column_0_6_choice_2;
      slice2cost_column_0_7 <= slice2cost_column_0_7_choice_2;
      slice2cost_column_0_8 <= slice2cost_column_0_8_choice_2;
      slice2cost_column_0_9 <= slice2cost_column_0_9_choice_2;
      slice2cost_column_0_10 <= slice2cost_column_0_10_choice_2;
      slice2cost_column_0_11 <= slice2cost_column_0_11_choice_2;
      slice2cost_column_0_12 <= slice2cost_column_0_12_choice_2;
      slice2cost_column_0_13 <= slice2cost_column_0_13_choice_2;
      slice2cost_column_0_14 <= slice2cost_column_0_14_choice_2;
      slice2cost_column_0_15 <= slice2cost_column_0_15_choice_2;
      slice2cost_write_column <= slice2cost_ready_column;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice2cost_read_column <= 0;
        else
          slice2cost_read_column <= (slice2cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        if slice0cost_ready_tag_row_start then
          slice2cost_change_column <= 0;
        else
          slice2cost_change_column <= (slice2cost_change_column + 1) mod 512;
        end if;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_words_0 <= (slice2cost_column_0_1_choice_2 * 1024) + slice2cost_column_0_0_choice_2 +
          (slice2cost_column_0_2_choice_2 * 1048576);
        slice2cost_write_words_1 <= (slice2cost_column_0_4_choice_2 * 1024) + slice2cost_column_0_3_choice_2 +
          (slice2cost_column_0_5_choice_2 * 1048576);
        slice2cost_write_words_2 <= (slice2cost_column_0_7_choice_2 * 1024) + slice2cost_column_0_6_choice_2 +
          (slice2cost_column_0_8_choice_2 * 1048576);
        slice2cost_write_words_3 <= (slice2cost_column_0_10_choice_2 * 1024) + slice2cost_column_0_9_choice_2 +
          (slice2cost_column_0_11_choice_2 * 1048576);
        slice2cost_write_words_4 <= (slice2cost_column_0_13_choice_2 * 1024) + slice2cost_column_0_12_choice_2 +
          (slice2cost_column_0_14_choice_2 * 1048576);
        slice2cost_write_words_5 <= slice2cost_column_0_15_choice_2;
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 15 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_0_choice := to_integer(slice2window_leaving_0(9 downto 0));
      else
        slice2window_change_0_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_1_choice := to_integer(slice2window_leaving_0(19 downto 10));
      else
        slice2window_change_0_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_2_choice := to_integer(slice2window_leaving_0(29 downto 20));
      else
        slice2window_change_0_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_3_choice := to_integer(slice2window_leaving_1(9 downto 0));
      else
        slice2window_change_0_3_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_4_choice := to_integer(slice2window_leaving_1(19 downto 10));
      else
        slice2window_change_0_4_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_5_choice := to_integer(slice2window_leaving_1(29 downto 20));
      else
        slice2window_change_0_5_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_6_choice := to_integer(slice2window_leaving_2(9 downto 0));
      else
        slice2window_change_0_6_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_7_choice := to_integer(slice2window_leaving_2(19 downto 10));
      else
        slice2window_change_0_7_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_8_choice := to_integer(slice2window_leaving_2(29 downto 20));
      else
        slice2window_change_0_8_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_9_choice := to_integer(slice2window_leaving_3(9 downto 0));
      else
        slice2window_change_0_9_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_10_choice := to_integer(slice2window_leaving_3(19 downto 10));
      else
        slice2window_change_0_10_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_11_choice := to_integer(slice2window_leaving_3(29 downto 20));
      else
        slice2window_change_0_11_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_12_choice := to_integer(slice2window_leaving_4(9 downto 0));
      else
        slice2window_change_0_12_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_13_choice := to_integer(slice2window_leaving_4(19 downto 10));
      else
        slice2window_change_0_13_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_14_choice := to_integer(slice2window_leaving_4(29 downto 20));
      else
        slice2window_change_0_14_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_15_choice := to_integer(slice2window_leaving_5);
      else
        slice2window_change_0_15_choice := 0;
      end if;
      slice2window_entering_0_0 <= slice2cost_column_0_0;
      slice2window_entering_0_1 <= slice2cost_column_0_1;
      slice2window_entering_0_2 <= slice2cost_column_0_2;
      slice2window_entering_0_3 <= slice2cost_column_0_3;
      slice2window_entering_0_4 <= slice2cost_column_0_4;
      slice2window_entering_0_5 <= slice2cost_column_0_5;
      slice2window_entering_0_6 <= slice2cost_column_0_6;
      slice2window_entering_0_7 <= slice2cost_column_0_7;
      slice2window_entering_0_8 <= slice2cost_column_0_8;
      slice2window_entering_0_9 <= slice2cost_column_0_9;
      slice2window_entering_0_10 <= slice2cost_column_0_10;
      slice2window_entering_0_11 <= slice2cost_column_0_11;
      slice2window_entering_0_12 <= slice2cost_column_0_12;
      slice2window_entering_0_13 <= slice2cost_column_0_13;
      slice2window_entering_0_14 <= slice2cost_column_0_14;
      slice2window_entering_0_15 <= slice2cost_column_0_15;
      slice2window_change_0_0 <= slice2window_entering_0_0 - slice2window_change_0_0_choice;
      slice2window_change_0_1 <= slice2window_entering_0_1 - slice2window_change_0_1_choice;
      slice2window_change_0_2 <= slice2window_entering_0_2 - slice2window_change_0_2_choice;
      slice2window_change_0_3 <= slice2window_entering_0_3 - slice2window_change_0_3_choice;
      slice2window_change_0_4 <= slice2window_entering_0_4 - slice2window_change_0_4_choice;
      slice2window_change_0_5 <= slice2window_entering_0_5 - slice2window_change_0_5_choice;
      slice2window_change_0_6 <= slice2window_entering_0_6 - slice2window_change_0_6_choice;
      slice2window_change_0_7 <= slice2window_entering_0_7 - slice2window_change_0_7_choice;
      slice2window_change_0_8 <= slice2window_entering_0_8 - slice2window_change_0_8_choice;
      slice2window_change_0_9 <= slice2window_entering_0_9 - slice2window_change_0_9_choice;
      slice2window_change_0_10 <= slice2window_entering_0_10 - slice2window_change_0_10_choice;
      slice2window_change_0_11 <= slice2window_entering_0_11 - slice2window_change_0_11_choice;
      slice2window_change_0_12 <= slice2window_entering_0_12 - slice2window_change_0_12_choice;
      slice2window_change_0_13 <= slice2window_entering_0_13 - slice2window_change_0_13_choice;
      slice2window_change_0_14 <= slice2window_entering_0_14 - slice2window_change_0_14_choice;
      slice2window_change_0_15 <= slice2window_entering_0_15 - slice2window_change_0_15_choice;
      slice2window_change_tag_first_cost <= slice1window_change_tag_first_cost;
      slice2window_change_tag_leaves_window <= slice1window_change_tag_leaves_window;
      slice2window_centre_output_column_0 <= slice1window_centre_output_column_0;
      slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_0_choice := 0;
      else
        slice2window_sum_0_0_choice := slice2window_sum_0_0;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_1_choice := 0;
      else
        slice2window_sum_0_1_choice := slice2window_sum_0_1;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_2_choice := 0;
      else
        slice2window_sum_0_2_choice := slice2window_sum_0_2;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_3_choice := 0;
      else
        slice2window_sum_0_3_choice := slice2window_sum_0_3;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_4_choice := 0;
      else
        slice2window_sum_0_4_choice := slice2window_sum_0_4;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_5_choice := 0;
      else
        slice2window_sum_0_5_choice := slice2window_sum_0_5;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_6_choice := 0;
      else
        slice2window_sum_0_6_choice := slice2window_sum_0_6;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_7_choice := 0;
      else
        slice2window_sum_0_7_choice := slice2window_sum_0_7;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_8_choice := 0;
      else
        slice2window_sum_0_8_choice := slice2window_sum_0_8;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_9_choice := 0;
      else
        slice2window_sum_0_9_choice := slice2window_sum_0_9;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_10_choice := 0;
      else
        slice2window_sum_0_10_choice := slice2window_sum_0_10;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_11_choice := 0;
      else
        slice2window_sum_0_11_choice := slice2window_sum_0_11;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_12_choice := 0;
      else
        slice2window_sum_0_12_choice := slice2window_sum_0_12;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_13_choice := 0;
      else
        slice2window_sum_0_13_choice := slice2window_sum_0_13;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_14_choice := 0;
      else
        slice2window_sum_0_14_choice := slice2window_sum_0_14;
      end if;
      if slice2window_change_tag_first_cost then
        slice2window_sum_0_15_choice := 0;
      else
        slice2window_sum_0_15_choice := slice2window_sum_0_15;
      end if;
      if slice0winner1_tag_valid then
        slice2window_sum_0_0 <= (slice2window_sum_0_0_choice + slice2window_change_0_0) mod 16384;
        slice2window_sum_0_1 <= (slice2window_sum_0_1_choice + slice2window_change_0_1) mod 16384;
        slice2window_sum_0_2 <= (slice2window_sum_0_2_choice + slice2window_change_0_2) mod 16384;
        slice2window_sum_0_3 <= (slice2window_sum_0_3_choice + slice2window_change_0_3) mod 16384;
        slice2window_sum_0_4 <= (slice2window_sum_0_4_choice + slice2window_change_0_4) mod 16384;
        slice2window_sum_0_5 <= (slice2window_sum_0_5_choice + slice2window_change_0_5) mod 16384;
        slice2window_sum_0_6 <= (slice2window_sum_0_6_choice + slice2window_change_0_6) mod 16384;
        slice2window_sum_0_7 <= (slice2window_sum_0_7_choice + slice2window_change_0_7) mod 16384;
        slice2window_sum_0_8 <= (slice2window_sum_0_8_choice + slice2window_change_0_8) mod 16384;
        slice2window_sum_0_9 <= (slice2window_sum_0_9_choice + slice2window_change_0_9) mod 16384;
        slice2window_sum_0_10 <= (slice2window_sum_0_10_choice + slice2window_change_0_10) mod 16384;
        slice2window_sum_0_11 <= (slice2window_sum_0_11_choice + slice2window_change_0_11) mod 16384;
        slice2window_sum_0_12 <= (slice2window_sum_0_12_choice + slice2window_change_0_12) mod 16384;
        slice2window_sum_0_13 <= (slice2window_sum_0_13_choice + slice2window_change_0_13) mod 16384;
        slice2window_sum_0_14 <= (slice2window_sum_0_14_choice + slice2window_change_0_14) mod 16384;
        slice2window_sum_0_15 <= (slice2window_sum_0_15_choice + slice2window_change_0_15) mod 16384;
      end if;
      if slice0winner2_tag_valid then
        slice2window_centre_start_of_frame_1 <= slice1window_centre_start_of_frame_1;
      end if;
      -- slice2winner1
      slice2winner1_best_index_0_0_is_not_less := (slice2window_sum_0_0 - slice2window_sum_0_1) >= 0;
      slice2winner1_best_index_0_1_is_less := (slice2window_sum_0_2 - slice2window_sum_0_3) < 0;
      slice2winner1_best_index_0_2_is_less := (slice2window_sum_0_4 - slice2window_sum_0_5) < 0;
      slice2winner1_best_index_0_3_is_less := (slice2window_sum_0_6 - slice2window_sum_0_7) < 0;
      slice2winner1_best_index_0_4_is_less := (slice2window_sum_0_8 - slice2window_sum_0_9) < 0;
      slice2winner1_best_index_0_5_is_less := (slice2window_sum_0_10 - slice2window_sum_0_11) < 0;
      slice2winner1_best_index_0_6_is_less := (slice2window_sum_0_12 - slice2window_sum_0_13) < 0;
      slice2winner1_best_index_0_7_is_less := (slice2window_sum_0_14 - slice2window_sum_0_15) < 0;
      slice2winner1_held_0_0 <= slice2window_sum_0_0;
      slice2winner1_held_0_1 <= slice2window_sum_0_1;
      slice2winner1_held_0_2 <= slice2window_sum_0_2;
      slice2winner1_held_0_3 <= slice2window_sum_0_3;
      slice2winner1_held_0_4 <= slice2window_sum_0_4;
      slice2winner1_held_0_5 <= slice2window_sum_0_5;
      slice2winner1_held_0_6 <= slice2window_sum_0_6;
      slice2winner1_held_0_7 <= slice2window_sum_0_7;
      slice2winner1_held_0_8 <= slice2window_sum_0_8;
      slice2winner1_held_0_9 <= slice2window_sum_0_9;
      slice2winner1_held_0_10 <= slice2window_sum_0_10;
      slice2winner1_held_0_11 <= slice2window_sum_0_11;
      slice2winner1_held_0_12 <= slice2window_sum_0_12;
      slice2winner1_held_0_13 <= slice2window_sum_0_13;
      slice2winner1_held_0_14 <= slice2window_sum_0_14;
      slice2winner1_held_0_15 <= slice2window_sum_0_15;
      slice2winner1_best_index_0_0 <= slice2winner1_best_index_0_0_is_not_less;
      slice2winner1_best_late_cost_0_0 <= slice2winner1_best_cost_0_0;
      slice2winner1_best_late_cost_0_1 <= slice2winner1_best_cost_0_1;
      slice2winner1_best_late_cost_0_2 <= slice2winner1_best_cost_0_2;
      slice2winner1_best_late_cost_0_3 <= slice2winner1_best_cost_0_3;
      slice2winner1_best_late_cost_0_4 <= slice2winner1_best_cost_0_4;
      slice2winner1_best_late_cost_0_5 <= slice2winner1_best_cost_0_5;
      slice2winner1_best_late_cost_0_6 <= slice2winner1_best_cost_0_6;
      slice2winner1_best_late_cost_0_7 <= slice2winner1_best_cost_0_7;
      slice2winner1_best_but_first_0_0 <= slice2winner1_held_0_1;
      slice2winner1_best_but_first_0_1 <= slice2winner1_held_0_3;
      slice2winner1_best_but_first_0_2 <= slice2winner1_held_0_5;
      slice2winner1_best_but_first_0_3 <= slice2winner1_held_0_7;
      slice2winner1_best_but_first_0_4 <= slice2winner1_held_0_9;
      slice2winner1_best_but_first_0_5 <= slice2winner1_held_0_11;
      slice2winner1_best_but_first_0_6 <= slice2winner1_held_0_13;
      slice2winner1_best_but_first_0_7 <= slice2winner1_held_0_15;
      slice2winner1_best_but_last_0_0 <= slice2winner1_held_0_0;
      slice2winner1_best_but_last_0_1 <= slice2winner1_held_0_2;
      slice2winner1_best_but_last_0_2 <= slice2winner1_held_0_4;
      slice2winner1_best_but_last_0_3 <= slice2winner1_held_0_6;
      slice2winner1_best_but_last_0_4 <= slice2winner1_held_0_8;
      slice2winner1_best_but_last_0_5 <= slice2winner1_held_0_10;
      slice2winner1_best_but_last_0_6 <= slice2winner1_held_0_12;
      slice2winner1_best_but_last_0_7 <= slice2winner1_held_0_14;
      if (slice2window_sum_0_1 - slice2window_sum_0_0) < 0 then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      if (slice2window_sum_0_3 - slice2window_sum_0_2) < 0 then
        slice2winner1_best_cost_0_1 <= slice2window_sum_0_3;
      else
        slice2winner1_best_cost_0_1 <= slice2window_sum_0_2;
      end if;
      if (slice2window_sum_0_5 - slice2window_sum_0_4) < 0 then
        slice2winner1_best_cost_0_2 <= slice2window_sum_0_5;
      else
        slice2winner1_best_cost_0_2 <= slice2window_sum_0_4;
      end if;
      if (slice2window_sum_0_7 - slice2window_sum_0_6) < 0 then
        slice2winner1_best_cost_0_3 <= slice2window_sum_0_7;
      else
        slice2winner1_best_cost_0_3 <= slice2window_sum_0_6;
      end if;
      if (slice2window_sum_0_9 - slice2window_sum_0_8) < 0 then
        slice2winner1_best_cost_0_4 <= slice2window_sum_0_9;
      else
        slice2winner1_best_cost_0_4 <= slice2window_sum_0_8;
      end if;
      if (slice2window_sum_0_11 - slice2window_sum_0_10) < 0 then
        slice2winner1_best_cost_0_5 <= slice2window_sum_0_11;
      else
        slice2winner1_best_cost_0_5 <= slice2window_sum_0_10;
      end if;
      if (slice2window_sum_0_13 - slice2window_sum_0_12) < 0 then
        slice2winner1_best_cost_0_6 <= slice2window_sum_0_13;
      else
        slice2winner1_best_cost_0_6 <= slice2window_sum_0_12;
      end if;
      if (slice2window_sum_0_15 - slice2window_sum_0_14) < 0 then
        slice2winner1_best_cost_0_7 <= slice2window_sum_0_15;
      else
        slice2winner1_best_cost_0_7 <= slice2window_sum_0_14;
      end if;
      if slice2winner1_best_index_0_1_is_less then
        slice2winner1_best_index_0_1 <= 2;
        slice2winner1_best_below_0_1 <= 0;
        slice2winner1_best_above_0_1 <= slice2window_sum_0_3;
      else
        slice2winner1_best_index_0_1 <= 3;
        slice2winner1_best_below_0_1 <= slice2window_sum_0_2;
        slice2winner1_best_above_0_1 <= 0;
      end if;
      if slice2winner1_best_index_0_2_is_less then
        slice2winner1_best_index_0_2 <= 4;
        slice2winner1_best_below_0_2 <= 0;
        slice2winner1_best_above_0_2 <= slice2window_sum_0_5;
      else
        slice2winner1_best_index_0_2 <= 5;
        slice2winner1_best_below_0_2 <= slice2window_sum_0_4;
        slice2winner1_best_above_0_2 <= 0;
      end if;
      if slice2winner1_best_index_0_3_is_less then
        slice2winner1_best_index_0_3 <= 6;
        slice2winner1_best_below_0_3 <= 0;
        slice2winner1_best_above_0_3 <= slice2window_sum_0_7;
      else
        slice2winner1_best_index_0_3 <= 7;
        slice2winner1_best_below_0_3 <= slice2window_sum_0_6;
        slice2winner1_best_above_0_3 <= 0;
      end if;
      if slice2winner1_best_index_0_4_is_less then
        slice2winner1_best_index_0_4 <= 8;
        slice2winner1_best_below_0_4 <= 0;
        slice2winner1_best_above_0_4 <= slice2window_sum_0_9;
      else
        slice2winner1_best_index_0_4 <= 9;
        slice2winner1_best_below_0_4 <= slice2window_sum_0_8;
        slice2winner1_best_above_0_4 <= 0;
      end if;
      if slice2winner1_best_index_0_5_is_less then
        slice2winner1_best_index_0_5 <= 10;
        slice2winner1_best_below_0_5 <= 0;
        slice2winner1_best_above_0_5 <= slice2window_sum_0_11;
      else
        slice2winner1_best_index_0_5 <= 11;
        slice2winner1_best_below_0_5 <= slice2window_sum_0_10;
        slice2winner1_best_above_0_5 <= 0;
      end if;
      if slice2winner1_best_index_0_6_is_less then
        slice2winner1_best_index_0_6 <= 12;
        slice2winner1_best_below_0_6 <= 0;
        slice2winner1_best_above_0_6 <= slice2window_sum_0_13;
      else
        slice2winner1_best_index_0_6 <= 13;
        slice2winner1_best_below_0_6 <= slice2window_sum_0_12;
        slice2winner1_best_above_0_6 <= 0;
      end if;
      if slice2winner1_best_index_0_7_is_less then
        slice2winner1_best_index_0_7 <= 14;
        slice2winner1_best_below_0_7 <= 0;
        slice2winner1_best_above_0_7 <= slice2window_sum_0_15;
      else
        slice2winner1_best_index_0_7 <= 15;
        slice2winner1_best_below_0_7 <= slice2window_sum_0_14;
        slice2winner1_best_above_0_7 <= 0;
      end if;
      if slice2winner1_best_index_0_0_is_not_less then
        slice2winner1_best_below_0_0 <= slice2window_sum_0_0;
        slice2winner1_best_above_0_0 <= 0;
      else
        slice2winner1_best_below_0_0 <= 0;
        slice2winner1_best_above_0_0 <= slice2window_sum_0_1;
      end if;
      -- slice2winner2
      slice2winner2_best_index_0_0_is_not_less := (slice2winner1_best_cost_0_0 - slice2winner1_best_cost_0_1) >= 0;
      slice2winner2_best_index_0_1_is_not_less := (slice2winner1_best_cost_0_2 - slice2winner1_best_cost_0_3) >= 0;
      slice2winner2_best_index_0_2_is_not_less := (slice2winner1_best_cost_0_4 - slice2winner1_best_cost_0_5) >= 0;
      slice2winner2_best_index_0_3_is_not_less := (slice2winner1_best_cost_0_6 - slice2winner1_best_cost_0_7) >= 0;
      if other_4 then
        slice2winner2_best_below_0_0_choice := slice2winner1_held_0_1;
      else
        slice2winner2_best_below_0_0_choice := slice2winner1_best_below_0_1;
      end if;
      if other_5 then
        slice2winner2_best_below_0_1_choice := slice2winner1_held_0_5;
      else
        slice2winner2_best_below_0_1_choice := slice2winner1_best_below_0_3;
      end if;
      if other_13 then
        slice2winner2_best_below_0_2_choice := slice2winner1_held_0_9;
      else
        slice2winner2_best_below_0_2_choice := slice2winner1_best_below_0_5;
      end if;
      if other_14 then
        slice2winner2_best_below_0_3_choice := slice2winner1_held_0_13;
      else
        slice2winner2_best_below_0_3_choice := slice2winner1_best_below_0_7;
      end if;
      if slice2winner1_best_index_0_0 then
        slice2winner2_best_above_0_0_choice := slice2winner1_held_0_2;
      else
        slice2winner2_best_above_0_0_choice := slice2winner1_best_above_0_0;
      end if;
      if ((slice2winner1_best_index_0_2 / 4) = 1) and ((slice2winner1_best_index_0_2 mod 2) = 1) then
        slice2winner2_best_above_0_1_choice := slice2winner1_held_0_6;
      else
        slice2winner2_best_above_0_1_choice := slice2winner1_best_above_0_2;
      end if;
      if ((slice2winner1_best_index_0_4 / 8) = 1) and ((slice2winner1_best_index_0_4 mod 2) = 1) then
        slice2winner2_best_above_0_2_choice := slice2winner1_held_0_10;
      else
        slice2winner2_best_above_0_2_choice := slice2winner1_best_above_0_4;
      end if;
      slice2winner2_best_above_0_3_value := ((slice2winner1_best_index_0_6 / 4) mod 2) = 1;
      if ((slice2winner1_best_index_0_6 / 8) = 1) and slice2winner2_best_above_0_3_value and
        ((slice2winner1_best_index_0_6 mod 2) = 1) then
        slice2winner2_best_above_0_3_choice := slice2winner1_held_0_14;
      else
        slice2winner2_best_above_0_3_choice := slice2winner1_best_above_0_6;
      end if;
      if slice2winner2_best_place_0_0 then
        slice2winner2_best_second_0_0_choice := 16383;
      else
        slice2winner2_best_second_0_0_choice := slice2winner1_best_late_cost_0_1;
      end if;
      if slice2winner2_best_at_end_0_0 then
        slice2winner2_best_second_0_0_choice_2 := slice2winner1_best_but_first_0_1;
      else
        slice2winner2_best_second_0_0_choice_2 := slice2winner2_best_second_0_0_choice;
      end if;
      if slice2winner2_best_place_0_0 then
        slice2winner2_best_second_0_0_choice_3 := slice2winner1_best_late_cost_0_0;
      else
        slice2winner2_best_second_0_0_choice_3 := 16383;
      end if;
      if slice2winner2_best_at_start_0_0 then
        slice2winner2_best_second_0_0_choice_4 := slice2winner1_best_but_last_0_0;
      else
        slice2winner2_best_second_0_0_choice_4 := slice2winner2_best_second_0_0_choice_3;
      end if;
      if slice2winner2_best_place_0_1 then
        slice2winner2_best_second_0_1_choice := 16383;
      else
        slice2winner2_best_second_0_1_choice := slice2winner1_best_late_cost_0_3;
      end if;
      if slice2winner2_best_at_end_0_1 then
        slice2winner2_best_second_0_1_choice_2 := slice2winner1_best_but_first_0_3;
      else
        slice2winner2_best_second_0_1_choice_2 := slice2winner2_best_second_0_1_choice;
      end if;
      if slice2winner2_best_place_0_1 then
        slice2winner2_best_second_0_1_choice_3 := slice2winner1_best_late_cost_0_2;
      else
        slice2winner2_best_second_0_1_choice_3 := 16383;
      end if;
      if slice2winner2_best_at_start_0_1 then
        slice2winner2_best_second_0_1_choice_4 := slice2winner1_best_but_last_0_2;
      else
        slice2winner2_best_second_0_1_choice_4 := slice2winner2_best_second_0_1_choice_3;
      end if;
      if slice2winner2_best_place_0_2 then
        slice2winner2_best_second_0_2_choice := 16383;
      else
        slice2winner2_best_second_0_2_choice := slice2winner1_best_late_cost_0_5;
      end if;
      if slice2winner2_best_at_end_0_2 then
        slice2winner2_best_second_0_2_choice_2 := slice2winner1_best_but_first_0_5;
      else
        slice2winner2_best_second_0_2_choice_2 := slice2winner2_best_second_0_2_choice;
      end if;
      if slice2winner2_best_place_0_2 then
        slice2winner2_best_second_0_2_choice_3 := slice2winner1_best_late_cost_0_4;
      else
        slice2winner2_best_second_0_2_choice_3 := 16383;
      end if;
      if slice2winner2_best_at_start_0_2 then
        slice2winner2_best_second_0_2_choice_4 := slice2winner1_best_but_last_0_4;
      else
        slice2winner2_best_second_0_2_choice_4 := slice2winner2_best_second_0_2_choice_3;
      end if;
      if slice2winner2_best_place_0_3 then
        slice2winner2_best_second_0_3_choice := 16383;
      else
        slice2winner2_best_second_0_3_choice := slice2winner1_best_late_cost_0_7;
      end if;
      if slice2winner2_best_at_end_0_3 then
        slice2winner2_best_second_0_3_choice_2 := slice2winner1_best_but_first_0_7;
      else
        slice2winner2_best_second_0_3_choice_2 := slice2winner2_best_second_0_3_choice;
      end if;
      if slice2winner2_best_place_0_3 then
        slice2winner2_best_second_0_3_choice_3 := slice2winner1_best_late_cost_0_6;
      else
        slice2winner2_best_second_0_3_choice_3 := 16383;
      end if;
      if slice2winner2_best_at_start_0_3 then
        slice2winner2_best_second_0_3_choice_4 := slice2winner1_best_but_last_0_6;
      else
        slice2winner2_best_second_0_3_choice_4 := slice2winner2_best_second_0_3_choice_3;
      end if;
      slice2winner2_best_first_0_0 <= slice2winner1_held_0_0;
      slice2winner2_best_first_0_1 <= slice2winner1_held_0_4;
      slice2winner2_best_first_0_2 <= slice2winner1_held_0_8;
      slice2winner2_best_first_0_3 <= slice2winner1_held_0_12;
      slice2winner2_best_last_0_0 <= slice2winner1_held_0_3;
      slice2winner2_best_last_0_1 <= slice2winner1_held_0_7;
      slice2winner2_best_last_0_2 <= slice2winner1_held_0_11;
      slice2winner2_best_last_0_3 <= slice2winner1_held_0_15;
      slice2winner2_best_place_0_0 <= slice2winner2_best_index_0_0_is_not_less;
      slice2winner2_best_place_0_1 <= slice2winner2_best_index_0_1_is_not_less;
      slice2winner2_best_place_0_2 <= slice2winner2_best_index_0_2_is_not_less;
      slice2winner2_best_place_0_3 <= slice2winner2_best_index_0_3_is_not_less;
      slice2winner2_best_at_start_0_0 <= other_4 and slice2winner2_best_index_0_0_is_not_less;
      slice2winner2_best_at_start_0_1 <= other_5 and slice2winner2_best_index_0_1_is_not_less;
      slice2winner2_best_at_start_0_2 <= other_13 and slice2winner2_best_index_0_2_is_not_less;
      slice2winner2_best_at_start_0_3 <= other_14 and slice2winner2_best_index_0_3_is_not_less;
      slice2winner2_best_at_end_0_0 <= slice2winner1_best_index_0_0 and ((slice2winner1_best_cost_0_0 -
        slice2winner1_best_cost_0_1) < 0);
      slice2winner2_best_at_end_0_1 <= ((slice2winner1_best_cost_0_2 - slice2winner1_best_cost_0_3) < 0) and
        ((slice2winner1_best_index_0_2 / 4) = 1) and ((slice2winner1_best_index_0_2 mod 2) = 1);
      slice2winner2_best_at_end_0_2 <= ((slice2winner1_best_cost_0_4 - slice2winner1_best_cost_0_5) < 0) and
        ((slice2winner1_best_index_0_4 / 8) = 1) and ((slice2winner1_best_index_0_4 mod 2) = 1);
      slice2winner2_best_at_end_0_3 <= ((slice2winner1_best_cost_0_6 - slice2winner1_best_cost_0_7) < 0) and
        ((slice2winner1_best_index_0_6 / 8) = 1) and slice2winner2_best_above_0_3_value and
        ((slice2winner1_best_index_0_6 mod 2) = 1);
      slice2winner2_best_late_cost_0_0 <= slice2winner2_best_cost_0_0;
      slice2winner2_best_late_cost_0_1 <= slice2winner2_best_cost_0_1;
      slice2winner2_best_late_cost_0_2 <= slice2winner2_best_cost_0_2;
      slice2winner2_best_late_cost_0_3 <= slice2winner2_best_cost_0_3;
      if (slice2winner1_best_cost_0_1 - slice2winner1_best_cost_0_0) < 0 then
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_1;
      else
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
      end if;
      if (slice2winner1_best_cost_0_3 - slice2winner1_best_cost_0_2) < 0 then
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_3;
      else
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_2;
      end if;
      if (slice2winner1_best_cost_0_5 - slice2winner1_best_cost_0_4) < 0 then
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_5;
      else
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_4;
      end if;
      if (slice2winner1_best_cost_0_7 - slice2winner1_best_cost_0_6) < 0 then
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_7;
      else
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_6;
      end if;
      if slice2winner2_best_index_0_0_is_not_less then
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
        slice2winner2_best_below_0_0 <= slice2winner2_best_below_0_0_choice;
        slice2winner2_best_above_0_0 <= slice2winner1_best_above_0_1;
      else
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
        slice2winner2_best_below_0_0 <= slice2winner1_best_below_0_0;
        slice2winner2_best_above_0_0 <= slice2winner2_best_above_0_0_choice;
      end if;
      if slice2winner2_best_index_0_1_is_not_less then
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
        slice2winner2_best_below_0_1 <= slice2winner2_best_below_0_1_choice;
        slice2winner2_best_above_0_1 <= slice2winner1_best_above_0_3;
      else
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
        slice2winner2_best_below_0_1 <= slice2winner1_best_below_0_2;
        slice2winner2_best_above_0_1 <= slice2winner2_best_above_0_1_choice;
      end if;
      if slice2winner2_best_index_0_2_is_not_less then
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
        slice2winner2_best_below_0_2 <= slice2winner2_best_below_0_2_choice;
        slice2winner2_best_above_0_2 <= slice2winner1_best_above_0_5;
      else
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
        slice2winner2_best_below_0_2 <= slice2winner1_best_below_0_4;
        slice2winner2_best_above_0_2 <= slice2winner2_best_above_0_2_choice;
      end if;
      if slice2winner2_best_index_0_3_is_not_less then
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
        slice2winner2_best_below_0_3 <= slice2winner2_best_below_0_3_choice;
        slice2winner2_best_above_0_3 <= slice2winner1_best_above_0_7;
      else
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_6;
        slice2winner2_best_below_0_3 <= slice2winner1_best_below_0_6;
        slice2winner2_best_above_0_3 <= slice2winner2_best_above_0_3_choice;
      end if;
      if (slice2winner2_best_second_0_0_choice_2 - slice2winner2_best_second_0_0_choice_4) < 0 then
        slice2winner2_best_second_0_0 <= slice2winner2_best_second_0_0_choice_2;
      else
        slice2winner2_best_second_0_0 <= slice2winner2_best_second_0_0_choice_4;
      end if;
      if (slice2winner2_best_second_0_1_choice_2 - slice2winner2_best_second_0_1_choice_4) < 0 then
        slice2winner2_best_second_0_1 <= slice2winner2_best_second_0_1_choice_2;
      else
        slice2winner2_best_second_0_1 <= slice2winner2_best_second_0_1_choice_4;
      end if;
      if (slice2winner2_best_second_0_2_choice_2 - slice2winner2_best_second_0_2_choice_4) < 0 then
        slice2winner2_best_second_0_2 <= slice2winner2_best_second_0_2_choice_2;
      else
        slice2winner2_best_second_0_2 <= slice2winner2_best_second_0_2_choice_4;
      end if;
      if (slice2winner2_best_second_0_3_choice_2 - slice2winner2_best_second_0_3_choice_4) < 0 then
        slice2winner2_best_second_0_3 <= slice2winner2_best_second_0_3_choice_2;
      else
        slice2winner2_best_second_0_3 <= slice2winner2_best_second_0_3_choice_4;
      end if;
      if (slice2winner1_best_late_cost_0_1 - slice2winner1_best_but_first_0_0) < 0 then
        slice2winner2_best_but_first_0_0 <= slice2winner1_best_late_cost_0_1;
      else
        slice2winner2_best_but_first_0_0 <= slice2winner1_best_but_first_0_0;
      end if;
      if (slice2winner1_best_late_cost_0_3 - slice2winner1_best_but_first_0_2) < 0 then
        slice2winner2_best_but_first_0_1 <= slice2winner1_best_late_cost_0_3;
      else
        slice2winner2_best_but_first_0_1 <= slice2winner1_best_but_first_0_2;
      end if;
      if (slice2winner1_best_late_cost_0_5 - slice2winner1_best_but_first_0_4) < 0 then
        slice2winner2_best_but_first_0_2 <= slice2winner1_best_late_cost_0_5;
      else
        slice2winner2_best_but_first_0_2 <= slice2winner1_best_but_first_0_4;
      end if;
      if (slice2winner1_best_late_cost_0_7 - slice2winner1_best_but_first_0_6) < 0 then
        slice2winner2_best_but_first_0_3 <= slice2winner1_best_late_cost_0_7;
      else
        slice2winner2_best_but_first_0_3 <= slice2winner1_best_but_first_0_6;
      end if;
      if (slice2winner1_best_but_last_0_1 - slice2winner1_best_late_cost_0_0) < 0 then
        slice2winner2_best_but_last_0_0 <= slice2winner1_best_but_last_0_1;
      else
        slice2winner2_best_but_last_0_0 <= slice2winner1_best_late_cost_0_0;
      end if;
      if (slice2winner1_best_but_last_0_3 - slice2winner1_best_late_cost_0_2) < 0 then
        slice2winner2_best_but_last_0_1 <= slice2winner1_best_but_last_0_3;
      else
        slice2winner2_best_but_last_0_1 <= slice2winner1_best_late_cost_0_2;
      end if;
      if (slice2winner1_best_but_last_0_5 - slice2winner1_best_late_cost_0_4) < 0 then
        slice2winner2_best_but_last_0_2 <= slice2winner1_best_but_last_0_5;
      else
        slice2winner2_best_but_last_0_2 <= slice2winner1_best_late_cost_0_4;
      end if;
      if (slice2winner1_best_but_last_0_7 - slice2winner1_best_late_cost_0_6) < 0 then
        slice2winner2_best_but_last_0_3 <= slice2winner1_best_but_last_0_7;
      else
        slice2winner2_best_but_last_0_3 <= slice2winner1_best_late_cost_0_6;
      end if;
      -- slice2winner3
      slice2winner3_best_index_0_0_is_not_less := (slice2winner2_best_cost_0_0 - slice2winner2_best_cost_0_1) >= 0;
      slice2winner3_best_index_0_1_is_not_less := (slice2winner2_best_cost_0_2 - slice2winner2_best_cost_0_3) >= 0;
      slice2winner3_best_below_0_0_is_equal := slice2winner2_best_index_0_1 = 4;
      if slice2winner3_best_below_0_0_is_equal then
        slice2winner3_best_below_0_0_choice := slice2winner2_best_last_0_0;
      else
        slice2winner3_best_below_0_0_choice := slice2winner2_best_below_0_1;
      end if;
      slice2winner3_best_below_0_1_is_equal := slice2winner2_best_index_0_3 = 12;
      if slice2winner3_best_below_0_1_is_equal then
        slice2winner3_best_below_0_1_choice := slice2winner2_best_last_0_2;
      else
        slice2winner3_best_below_0_1_choice := slice2winner2_best_below_0_3;
      end if;
      slice2winner3_best_above_0_0_is_equal := slice2winner2_best_index_0_0 = 3;
      if slice2winner3_best_above_0_0_is_equal then
        slice2winner3_best_above_0_0_choice := slice2winner2_best_first_0_1;
      else
        slice2winner3_best_above_0_0_choice := slice2winner2_best_above_0_0;
      end if;
      slice2winner3_best_above_0_1_is_equal := (slice2winner2_best_index_0_2 mod 4) = 3;
      if ((slice2winner2_best_index_0_2 / 8) = 1) and slice2winner3_best_above_0_1_is_equal then
        slice2winner3_best_above_0_1_choice := slice2winner2_best_first_0_3;
      else
        slice2winner3_best_above_0_1_choice := slice2winner2_best_above_0_2;
      end if;
      if slice2winner3_best_place_0_0 then
        slice2winner3_best_second_0_0_choice := slice2winner2_best_second_0_1;
      else
        slice2winner3_best_second_0_0_choice := slice2winner2_best_late_cost_0_1;
      end if;
      if slice2winner3_best_at_end_0_0 then
        slice2winner3_best_second_0_0_choice_2 := slice2winner2_best_but_first_0_1;
      else
        slice2winner3_best_second_0_0_choice_2 := slice2winner3_best_second_0_0_choice;
      end if;
      if slice2winner3_best_place_0_0 then
        slice2winner3_best_second_0_0_choice_3 := slice2winner2_best_late_cost_0_0;
      else
        slice2winner3_best_second_0_0_choice_3 := slice2winner2_best_second_0_0;
      end if;
      if slice2winner3_best_at_start_0_0 then
        slice2winner3_best_second_0_0_choice_4 := slice2winner2_best_but_last_0_0;
      else
        slice2winner3_best_second_0_0_choice_4 := slice2winner3_best_second_0_0_choice_3;
      end if;
      if slice2winner3_best_place_0_1 then
        slice2winner3_best_second_0_1_choice := slice2winner2_best_second_0_3;
      else
        slice2winner3_best_second_0_1_choice := slice2winner2_best_late_cost_0_3;
      end if;
      if slice2winner3_best_at_end_0_1 then
        slice2winner3_best_second_0_1_choice_2 := slice2winner2_best_but_first_0_3;
      else
        slice2winner3_best_second_0_1_choice_2 := slice2winner3_best_second_0_1_choice;
      end if;
      if slice2winner3_best_place_0_1 then
        slice2winner3_best_second_0_1_choice_3 := slice2winner2_best_late_cost_0_2;
      else
        slice2winner3_best_second_0_1_choice_3 := slice2winner2_best_second_0_2;
      end if;
      if slice2winner3_best_at_start_0_1 then
        slice2winner3_best_second_0_1_choice_4 := slice2winner2_best_but_last_0_2;
      else
        slice2winner3_best_second_0_1_choice_4 := slice2winner3_best_second_0_1_choice_3;
      end if;
      slice2winner3_best_first_0_0 <= slice2winner2_best_first_0_0;
      slice2winner3_best_first_0_1 <= slice2winner2_best_first_0_2;
      slice2winner3_best_last_0_0 <= slice2winner2_best_last_0_1;
      slice2winner3_best_last_0_1 <= slice2winner2_best_last_0_3;
      slice2winner3_best_place_0_0 <= slice2winner3_best_index_0_0_is_not_less;
      slice2winner3_best_place_0_1 <= slice2winner3_best_index_0_1_is_not_less;
      slice2winner3_best_at_start_0_0 <= slice2winner3_best_index_0_0_is_not_less and
        slice2winner3_best_below_0_0_is_equal;
      slice2winner3_best_at_start_0_1 <= slice2winner3_best_below_0_1_is_equal and
        slice2winner3_best_index_0_1_is_not_less;
      slice2winner3_best_at_end_0_0 <= ((slice2winner2_best_cost_0_0 - slice2winner2_best_cost_0_1) < 0) and
        slice2winner3_best_above_0_0_is_equal;
      slice2winner3_best_at_end_0_1 <= ((slice2winner2_best_cost_0_2 - slice2winner2_best_cost_0_3) < 0) and
        ((slice2winner2_best_index_0_2 / 8) = 1) and slice2winner3_best_above_0_1_is_equal;
      slice2winner3_best_late_cost_0_0 <= slice2winner3_best_cost_0_0;
      slice2winner3_best_late_cost_0_1 <= slice2winner3_best_cost_0_1;
      if (slice2winner2_best_cost_0_1 - slice2winner2_best_cost_0_0) < 0 then
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_1;
      else
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
      end if;
      if (slice2winner2_best_cost_0_3 - slice2winner2_best_cost_0_2) < 0 then
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_3;
      else
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_2;
      end if;
      if slice2winner3_best_index_0_0_is_not_less then
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
        slice2winner3_best_below_0_0 <= slice2winner3_best_below_0_0_choice;
        slice2winner3_best_above_0_0 <= slice2winner2_best_above_0_1;
      else
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
        slice2winner3_best_below_0_0 <= slice2winner2_best_below_0_0;
        slice2winner3_best_above_0_0 <= slice2winner3_best_above_0_0_choice;
      end if;
      if slice2winner3_best_index_0_1_is_not_less then
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
        slice2winner3_best_below_0_1 <= slice2winner3_best_below_0_1_choice;
        slice2winner3_best_above_0_1 <= slice2winner2_best_above_0_3;
      else
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_2;
        slice2winner3_best_below_0_1 <= slice2winner2_best_below_0_2;
        slice2winner3_best_above_0_1 <= slice2winner3_best_above_0_1_choice;
      end if;
      if (slice2winner3_best_second_0_0_choice_2 - slice2winner3_best_second_0_0_choice_4) < 0 then
        slice2winner3_best_second_0_0 <= slice2winner3_best_second_0_0_choice_2;
      else
        slice2winner3_best_second_0_0 <= slice2winner3_best_second_0_0_choice_4;
      end if;
      if (slice2winner3_best_second_0_1_choice_2 - slice2winner3_best_second_0_1_choice_4) < 0 then
        slice2winner3_best_second_0_1 <= slice2winner3_best_second_0_1_choice_2;
      else
        slice2winner3_best_second_0_1 <= slice2winner3_best_second_0_1_choice_4;
      end if;
      if (slice2winner2_best_late_cost_0_1 - slice2winner2_best_but_first_0_0) < 0 then
        slice2winner3_best_but_first_0_0 <= slice2winner2_best_late_cost_0_1;
      else
        slice2winner3_best_but_first_0_0 <= slice2winner2_best_but_first_0_0;
      end if;
      if (slice2winner2_best_late_cost_0_3 - slice2winner2_best_but_first_0_2) < 0 then
        slice2winner3_best_but_first_0_1 <= slice2winner2_best_late_cost_0_3;
      else
        slice2winner3_best_but_first_0_1 <= slice2winner2_best_but_first_0_2;
      end if;
      if (slice2winner2_best_but_last_0_1 - slice2winner2_best_late_cost_0_0) < 0 then
        slice2winner3_best_but_last_0_0 <= slice2winner2_best_but_last_0_1;
      else
        slice2winner3_best_but_last_0_0 <= slice2winner2_best_late_cost_0_0;
      end if;
      if (slice2winner2_best_but_last_0_3 - slice2winner2_best_late_cost_0_2) < 0 then
        slice2winner3_best_but_last_0_1 <= slice2winner2_best_but_last_0_3;
      else
        slice2winner3_best_but_last_0_1 <= slice2winner2_best_late_cost_0_2;
      end if;
      -- slice2winner4
      slice2winner4_best_index_0_0_is_less := (slice2winner3_best_cost_0_0 - slice2winner3_best_cost_0_1) < 0;
      slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0_1 = 8;
      if slice2winner4_best_below_0_0_is_equal then
        slice2winner4_best_below_0_0_choice := slice2winner3_best_last_0_0;
      else
        slice2winner4_best_below_0_0_choice := slice2winner3_best_below_0_1;
      end if;
      slice2winner4_best_above_0_0_is_equal := slice2winner3_best_index_0_0 = 7;
      if slice2winner4_best_above_0_0_is_equal then
        slice2winner4_best_above_0_0_choice := slice2winner3_best_first_0_1;
      else
        slice2winner4_best_above_0_0_choice := slice2winner3_best_above_0_0;
      end if;
      slice2winner4_best_place_0_0_is_not_less := (slice2winner3_best_cost_0_0 - slice2winner3_best_cost_0_1) >= 0;
      if slice2winner4_best_place_0_0 then
        slice2winner4_best_second_0_0_choice := slice2winner3_best_second_0_1;
      else
        slice2winner4_best_second_0_0_choice := slice2winner3_best_late_cost_0_1;
      end if;
      if slice2winner4_best_at_end_0_0 then
        slice2winner4_best_second_0_0_choice_2 := slice2winner3_best_but_first_0_1;
      else
        slice2winner4_best_second_0_0_choice_2 := slice2winner4_best_second_0_0_choice;
      end if;
      if slice2winner4_best_place_0_0 then
        slice2winner4_best_second_0_0_choice_3 := slice2winner3_best_late_cost_0_0;
      else
        slice2winner4_best_second_0_0_choice_3 := slice2winner3_best_second_0_0;
      end if;
      if slice2winner4_best_at_start_0_0 then
        slice2winner4_best_second_0_0_choice_4 := slice2winner3_best_but_last_0_0;
      else
        slice2winner4_best_second_0_0_choice_4 := slice2winner4_best_second_0_0_choice_3;
      end if;
      slice2winner4_best_first_0_0 <= slice2winner3_best_first_0_0;
      slice2winner4_best_last_0_0 <= slice2winner3_best_last_0_1;
      slice2winner4_best_place_0_0 <= slice2winner4_best_place_0_0_is_not_less;
      slice2winner4_best_at_start_0_0 <= slice2winner4_best_below_0_0_is_equal and
        slice2winner4_best_place_0_0_is_not_less;
      slice2winner4_best_at_end_0_0 <= slice2winner4_best_index_0_0_is_less and slice2winner4_best_above_0_0_is_equal;
      slice2winner4_best_late_cost_0_0 <= slice2winner4_best_cost_0_0;
      if (slice2winner3_best_cost_0_1 - slice2winner3_best_cost_0_0) < 0 then
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_1;
      else
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_0;
      end if;
      if slice2winner4_best_index_0_0_is_less then
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
        slice2winner4_best_below_0_0 <= slice2winner3_best_below_0_0;
        slice2winner4_best_above_0_0 <= slice2winner4_best_above_0_0_choice;
      else
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
        slice2winner4_best_below_0_0 <= slice2winner4_best_below_0_0_choice;
        slice2winner4_best_above_0_0 <= slice2winner3_best_above_0_1;
      end if;
      if (slice2winner4_best_second_0_0_choice_2 - slice2winner4_best_second_0_0_choice_4) < 0 then
        slice2winner4_best_second_0_0 <= slice2winner4_best_second_0_0_choice_2;
      else
        slice2winner4_best_second_0_0 <= slice2winner4_best_second_0_0_choice_4;
      end if;
      if (slice2winner3_best_late_cost_0_1 - slice2winner3_best_but_first_0_0) < 0 then
        slice2winner4_best_but_first_0_0 <= slice2winner3_best_late_cost_0_1;
      else
        slice2winner4_best_but_first_0_0 <= slice2winner3_best_but_first_0_0;
      end if;
      if (slice2winner3_best_but_last_0_1 - slice2winner3_best_late_cost_0_0) < 0 then
        slice2winner4_best_but_last_0_0 <= slice2winner3_best_but_last_0_1;
      else
        slice2winner4_best_but_last_0_0 <= slice2winner3_best_late_cost_0_0;
      end if;
      -- slice2
      slice2_best_index_0_0_is_less := (slice1_best_cost_0_0 - slice2winner4_best_cost_0_0) < 0;
      slice2_best_below_0_0_is_equal := slice2winner4_best_index_0_0 = 0;
      if slice2_best_below_0_0_is_equal then
        slice2_best_below_0_0_choice := slice1_best_last_0_0;
      else
        slice2_best_below_0_0_choice := slice2winner4_best_below_0_0;
      end if;
      slice2_best_above_0_0_is_equal := slice1_best_index_0_0 = 31;
      if slice2_best_above_0_0_is_equal then
        slice2_best_above_0_0_choice := slice2winner4_best_first_0_0;
      else
        slice2_best_above_0_0_choice := slice1_best_above_0_0;
      end if;
      slice2_best_place_0_0_is_not_less := (slice1_best_cost_0_0 - slice2winner4_best_cost_0_0) >= 0;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choice := slice2winner4_best_second_0_0;
      else
        slice2_best_second_0_0_choice := slice2winner4_best_late_cost_0_0;
      end if;
      if slice2_best_at_end_0_0 then
        slice2_best_second_0_0_choice_2 := slice2winner4_best_but_first_0_0;
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
      slice2_best_last_0_0 <= slice2winner4_best_last_0_0;
      slice2_best_place_0_0 <= slice2_best_place_0_0_is_not_less;
      slice2_best_at_start_0_0 <= slice2_best_below_0_0_is_equal and slice2_best_place_0_0_is_not_less;
      slice2_best_at_end_0_0 <= slice2_best_index_0_0_is_less and slice2_best_above_0_0_is_equal;
      slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0 then
        slice2_best_cost_0_0 <= slice2winner4_best_cost_0_0;
      else
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
      end if;
      if slice2_best_index_0_0_is_less then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
        slice2_best_below_0_0 <= slice1_best_below_0_0;
        slice2_best_above_0_0 <= slice2_best_above_0_0_choice;
      else
        slice2_best_index_0_0 <= slice2winner4_best_index_0_0 + 32;
        slice2_best_below_0_0 <= slice2_best_below_0_0_choice;
        slice2_best_above_0_0 <= slice2winner4_best_above_0_0;
      end if;
      if (slice2_best_second_0_0_choice_2 - slice2_best_second_0_0_choice_4) < 0 then
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_2;
      else
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_4;
      end if;
      if (slice2winner4_best_but_last_0_0 - slice1_best_late_cost_0_0) < 0 then
        slice2_best_but_last_0_0 <= slice2winner4_best_but_last_0_0;
      else
        slice2_best_but_last_0_0 <= slice1_best_late_cost_0_0;
      end if;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        slice3shift_search_0_0 <= slice2shift_search_out_0;
        slice3shift_search_0_1 <= slice3shift_search_0_0;
        slice3shift_search_0_2 <= slice3shift_search_0_1;
        slice3shift_search_0_3 <= slice3shift_search_0_2;
        slice3shift_search_0_4 <= slice3shift_search_0_3;
        slice3shift_search_0_5 <= slice3shift_search_0_4;
        slice3shift_search_0_6 <= slice3shift_search_0_5;
        slice3shift_search_0_7 <= slice3shift_search_0_6;
        slice3shift_search_0_8 <= slice3shift_search_0_7;
        slice3shift_search_0_9 <= slice3shift_search_0_8;
        slice3shift_search_0_10 <= slice3shift_search_0_9;
        slice3shift_search_0_11 <= slice3shift_search_0_10;
        slice3shift_search_0_12 <= slice3shift_search_0_11;
        slice3shift_search_0_13 <= slice3shift_search_0_12;
        slice3shift_search_0_14 <= slice3shift_search_0_13;
        slice3shift_search_0_15 <= slice3shift_search_0_14;
        slice3shift_search_1_0 <= slice2shift_search_out_1;
        slice3shift_search_1_1 <= slice3shift_search_1_0;
        slice3shift_search_1_2 <= slice3shift_search_1_1;
        slice3shift_search_1_3 <= slice3shift_search_1_2;
        slice3shift_search_1_4 <= slice3shift_search_1_3;
        slice3shift_search_1_5 <= slice3shift_search_1_4;
        slice3shift_search_1_6 <= slice3shift_search_1_5;
        slice3shift_search_1_7 <= slice3shift_search_1_6;
        slice3shift_search_1_8 <= slice3shift_search_1_7;
        slice3shift_search_1_9 <= slice3shift_search_1_8;
        slice3shift_search_1_10 <= slice3shift_search_1_9;
        slice3shift_search_1_11 <= slice3shift_search_1_10;
        slice3shift_search_1_12 <= slice3shift_search_1_11;
        slice3shift_search_1_13 <= slice3shift_search_1_12;
        slice3shift_search_1_14 <= slice3shift_search_1_13;
        slice3shift_search_1_15 <= slice3shift_search_1_14;
      end if;
      slice3shift_reference_0 <= slice2shift_reference_0;
      slice3shift_reference_1 <= slice2shift_reference_1;
      -- slice3cost
      if slice0window_change_tag_first_group then
        slice3cost_column_0_0_choice := 0;
      else
        slice3cost_column_0_0_choice := slice3cost_ready_words_0 mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_0_choice_2 := 0;
      else
        slice3cost_column_0_0_choice_2 := (slice3cost_change_0_0 + slice3cost_column_0_0_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_1_choice := 0;
      else
        slice3cost_column_0_1_choice := (slice3cost_ready_words_0 / 1024) mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_1_choice_2 := 0;
      else
        slice3cost_column_0_1_choice_2 := (slice3cost_change_0_1 + slice3cost_column_0_1_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_2_choice := 0;
      else
        slice3cost_column_0_2_choice := slice3cost_ready_words_0 / 1048576;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_2_choice_2 := 0;
      else
        slice3cost_column_0_2_choice_2 := (slice3cost_change_0_2 + slice3cost_column_0_2_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_3_choice := 0;
      else
        slice3cost_column_0_3_choice := slice3cost_ready_words_1 mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_3_choice_2 := 0;
      else
        slice3cost_column_0_3_choice_2 := (slice3cost_change_0_3 + slice3cost_column_0_3_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_4_choice := 0;
      else
        slice3cost_column_0_4_choice := (slice3cost_ready_words_1 / 1024) mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_4_choice_2 := 0;
      else
        slice3cost_column_0_4_choice_2 := (slice3cost_change_0_4 + slice3cost_column_0_4_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_5_choice := 0;
      else
        slice3cost_column_0_5_choice := slice3cost_ready_words_1 / 1048576;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_5_choice_2 := 0;
      else
        slice3cost_column_0_5_choice_2 := (slice3cost_change_0_5 + slice3cost_column_0_5_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_6_choice := 0;
      else
        slice3cost_column_0_6_choice := slice3cost_ready_words_2 mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_6_choice_2 := 0;
      else
        slice3cost_column_0_6_choice_2 := (slice3cost_change_0_6 + slice3cost_column_0_6_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_7_choice := 0;
      else
        slice3cost_column_0_7_choice := (slice3cost_ready_words_2 / 1024) mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_7_choice_2 := 0;
      else
        slice3cost_column_0_7_choice_2 := (slice3cost_change_0_7 + slice3cost_column_0_7_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_8_choice := 0;
      else
        slice3cost_column_0_8_choice := slice3cost_ready_words_2 / 1048576;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_8_choice_2 := 0;
      else
        slice3cost_column_0_8_choice_2 := (slice3cost_change_0_8 + slice3cost_column_0_8_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_9_choice := 0;
      else
        slice3cost_column_0_9_choice := slice3cost_ready_words_3 mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_9_choice_2 := 0;
      else
        slice3cost_column_0_9_choice_2 := (slice3cost_change_0_9 + slice3cost_column_0_9_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_10_choice := 0;
      else
        slice3cost_column_0_10_choice := (slice3cost_ready_words_3 / 1024) mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_10_choice_2 := 0;
      else
        slice3cost_column_0_10_choice_2 := (slice3cost_change_0_10 + slice3cost_column_0_10_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_11_choice := 0;
      else
        slice3cost_column_0_11_choice := slice3cost_ready_words_3 / 1048576;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_11_choice_2 := 0;
      else
        slice3cost_column_0_11_choice_2 := (slice3cost_change_0_11 + slice3cost_column_0_11_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_12_choice := 0;
      else
        slice3cost_column_0_12_choice := slice3cost_ready_words_4 mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_12_choice_2 := 0;
      else
        slice3cost_column_0_12_choice_2 := (slice3cost_change_0_12 + slice3cost_column_0_12_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_13_choice := 0;
      else
        slice3cost_column_0_13_choice := (slice3cost_ready_words_4 / 1024) mod 1024;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_13_choice_2 := 0;
      else
        slice3cost_column_0_13_choice_2 := (slice3cost_change_0_13 + slice3cost_column_0_13_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_14_choice := 0;
      else
        slice3cost_column_0_14_choice := slice3cost_ready_words_4 / 1048576;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_14_choice_2 := 0;
      else
        slice3cost_column_0_14_choice_2 := (slice3cost_change_0_14 + slice3cost_column_0_14_choice) mod 1024;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_15_choice := 0;
      else
        slice3cost_column_0_15_choice := slice3cost_ready_words_5;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_15_choice_2 := 0;
      else
        slice3cost_column_0_15_choice_2 := (slice3cost_change_0_15 + slice3cost_column_0_15_choice) mod 1024;
      end if;
      slice3cost_pixels_first_0_0 <= slice3shift_search_0_0 - slice3shift_reference_0;
      slice3cost_pixels_first_0_1 <= slice3shift_search_0_1 - slice3shift_reference_0;
      slice3cost_pixels_first_0_2 <= slice3shift_search_0_2 - slice3shift_reference_0;
      slice3cost_pixels_first_0_3 <= slice3shift_search_0_3 - slice3shift_reference_0;
      slice3cost_pixels_first_0_4 <= slice3shift_search_0_4 - slice3shift_reference_0;
      slice3cost_pixels_first_0_5 <= slice3shift_search_0_5 - slice3shift_reference_0;
      slice3cost_pixels_first_0_6 <= slice3shift_search_0_6 - slice3shift_reference_0;
      slice3cost_pixels_first_0_7 <= slice3shift_search_0_7 - slice3shift_reference_0;
      slice3cost_pixels_first_0_8 <= slice3shift_search_0_8 - slice3shift_reference_0;
      slice3cost_pixels_first_0_9 <= slice3shift_search_0_9 - slice3shift_reference_0;
      slice3cost_pixels_first_0_10 <= slice3shift_search_0_10 - slice3shift_reference_0;
      slice3cost_pixels_first_0_11 <= slice3shift_search_0_11 - slice3shift_reference_0;
      slice3cost_pixels_first_0_12 <= slice3shift_search_0_12 - slice3shift_reference_0;
      slice3cost_pixels_first_0_13 <= slice3shift_search_0_13 - slice3shift_reference_0;
      slice3cost_pixels_first_0_14 <= slice3shift_search_0_14 - slice3shift_reference_0;
      slice3cost_pixels_first_0_15 <= slice3shift_search_0_15 - slice3shift_reference_0;
      slice3cost_pixels_first_1_0 <= slice3shift_search_1_0 - slice3shift_reference_1;
      slice3cost_pixels_first_1_1 <= slice3shift_search_1_1 - slice3shift_reference_1;
      slice3cost_pixels_first_1_2 <= slice3shift_search_1_2 - slice3shift_reference_1;
      slice3cost_pixels_first_1_3 <= slice3shift_search_1_3 - slice3shift_reference_1;
      slice3cost_pixels_first_1_4 <= slice3shift_search_1_4 - slice3shift_reference_1;
      slice3cost_pixels_first_1_5 <= slice3shift_search_1_5 - slice3shift_reference_1;
      slice3cost_pixels_first_1_6 <= slice3shift_search_1_6 - slice3shift_reference_1;
      slice3cost_pixels_first_1_7 <= slice3shift_search_1_7 - slice3shift_reference_1;
      slice3cost_pixels_first_1_8 <= slice3shift_search_1_8 - slice3shift_reference_1;
      slice3cost_pixels_first_1_9 <= slice3shift_search_1_9 - slice3shift_reference_1;
      slice3cost_pixels_first_1_10 <= slice3shift_search_1_10 - slice3shift_reference_1;
      slice3cost_pixels_first_1_11 <= slice3shift_search_1_11 - slice3shift_reference_1;
      slice3cost_pixels_first_1_12 <= slice3shift_search_1_12 - slice3shift_reference_1;
      slice3cost_pixels_first_1_13 <= slice3shift_search_1_13 - slice3shift_reference_1;
      slice3cost_pixels_first_1_14 <= slice3shift_search_1_14 - slice3shift_reference_1;
      slice3cost_pixels_first_1_15 <= slice3shift_search_1_15 - slice3shift_reference_1;
      slice3cost_pixels_cost_0_0 <= folded(slice3cost_pixels_first_0_0) + as_number((slice3cost_pixels_first_0_0 < 0));
      slice3cost_pixels_cost_0_1 <= folded(slice3cost_pixels_first_0_1) + as_number((slice3cost_pixels_first_0_1 < 0));
      slice3cost_pixels_cost_0_2 <= folded(slice3cost_pixels_first_0_2) + as_number((slice3cost_pixels_first_0_2 < 0));
      slice3cost_pixels_cost_0_3 <= folded(slice3cost_pixels_first_0_3) + as_number((slice3cost_pixels_first_0_3 < 0));
      slice3cost_pixels_cost_0_4 <= folded(slice3cost_pixels_first_0_4) + as_number((slice3cost_pixels_first_0_4 < 0));
      slice3cost_pixels_cost_0_5 <= folded(slice3cost_pixels_first_0_5) + as_number((slice3cost_pixels_first_0_5 < 0));
      slice3cost_pixels_cost_0_6 <= folded(slice3cost_pixels_first_0_6) + as_number((slice3cost_pixels_first_0_6 < 0));
      slice3cost_pixels_cost_0_7 <= folded(slice3cost_pixels_first_0_7) + as_number((slice3cost_pixels_first_0_7 < 0));
      slice3cost_pixels_cost_0_8 <= folded(slice3cost_pixels_first_0_8) + as_number((slice3cost_pixels_first_0_8 < 0));
      slice3cost_pixels_cost_0_9 <= folded(slice3cost_pixels_first_0_9) + as_number((slice3cost_pixels_first_0_9 < 0));
      slice3cost_pixels_cost_0_10 <= folded(slice3cost_pixels_first_0_10) + as_number((slice3cost_pixels_first_0_10 <
        0));
      slice3cost_pixels_cost_0_11 <= folded(slice3cost_pixels_first_0_11) + as_number((slice3cost_pixels_first_0_11 <
        0));
      slice3cost_pixels_cost_0_12 <= folded(slice3cost_pixels_first_0_12) + as_number((slice3cost_pixels_first_0_12 <
        0));
      slice3cost_pixels_cost_0_13 <= folded(slice3cost_pixels_first_0_13) + as_number((slice3cost_pixels_first_0_13 <
        0));
      slice3cost_pixels_cost_0_14 <= folded(slice3cost_pixels_first_0_14) + as_number((slice3cost_pixels_first_0_14 <
        0));
      slice3cost_pixels_cost_0_15 <= folded(slice3cost_pixels_first_0_15) + as_number((slice3cost_pixels_first_0_15 <
        0));
      slice3cost_pixels_cost_1_0 <= folded(slice3cost_pixels_first_1_0) + as_number((slice3cost_pixels_first_1_0 < 0));
      slice3cost_pixels_cost_1_1 <= folded(slice3cost_pixels_first_1_1) + as_number((slice3cost_pixels_first_1_1 < 0));
      slice3cost_pixels_cost_1_2 <= folded(slice3cost_pixels_first_1_2) + as_number((slice3cost_pixels_first_1_2 < 0));
      slice3cost_pixels_cost_1_3 <= folded(slice3cost_pixels_first_1_3) + as_number((slice3cost_pixels_first_1_3 < 0));
      slice3cost_pixels_cost_1_4 <= folded(slice3cost_pixels_first_1_4) + as_number((slice3cost_pixels_first_1_4 < 0));
      slice3cost_pixels_cost_1_5 <= folded(slice3cost_pixels_first_1_5) + as_number((slice3cost_pixels_first_1_5 < 0));
      slice3cost_pixels_cost_1_6 <= folded(slice3cost_pixels_first_1_6) + as_number((slice3cost_pixels_first_1_6 < 0));
      slice3cost_pixels_cost_1_7 <= folded(slice3cost_pixels_first_1_7) + as_number((slice3cost_pixels_first_1_7 < 0));
      slice3cost_pixels_cost_1_8 <= folded(slice3cost_pixels_first_1_8) + as_number((slice3cost_pixels_first_1_8 < 0));
      slice3cost_pixels_cost_1_9 <= folded(slice3cost_pixels_first_1_9) + as_number((slice3cost_pixels_first_1_9 < 0));
      slice3cost_pixels_cost_1_10 <= folded(slice3cost_pixels_first_1_10) + as_number((slice3cost_pixels_first_1_10 <
        0));
      slice3cost_pixels_cost_1_11 <= folded(slice3cost_pixels_first_1_11) + as_number((slice3cost_pixels_first_1_11 <
        0));
      slice3cost_pixels_cost_1_12 <= folded(slice3cost_pixels_first_1_12) + as_number((slice3cost_pixels_first_1_12 <
        0));
      slice3cost_pixels_cost_1_13 <= folded(slice3cost_pixels_first_1_13) + as_number((slice3cost_pixels_first_1_13 <
        0));
      slice3cost_pixels_cost_1_14 <= folded(slice3cost_pixels_first_1_14) + as_number((slice3cost_pixels_first_1_14 <
        0));
      slice3cost_pixels_cost_1_15 <= folded(slice3cost_pixels_first_1_15) + as_number((slice3cost_pixels_first_1_15 <
        0));
      slice3cost_read_column <= slice2cost_read_column;
      slice3cost_change_column <= slice3cost_read_column;
      slice3cost_change_0_0 <= slice3cost_pixels_cost_1_0 - slice3cost_pixels_cost_0_0;
      slice3cost_change_0_1 <= slice3cost_pixels_cost_1_1 - slice3cost_pixels_cost_0_1;
      slice3cost_change_0_2 <= slice3cost_pixels_cost_1_2 - slice3cost_pixels_cost_0_2;
      slice3cost_change_0_3 <= slice3cost_pixels_cost_1_3 - slice3cost_pixels_cost_0_3;
      slice3cost_change_0_4 <= slice3cost_pixels_cost_1_4 - slice3cost_pixels_cost_0_4;
      slice3cost_change_0_5 <= slice3cost_pixels_cost_1_5 - slice3cost_pixels_cost_0_5;
      slice3cost_change_0_6 <= slice3cost_pixels_cost_1_6 - slice3cost_pixels_cost_0_6;
      slice3cost_change_0_7 <= slice3cost_pixels_cost_1_7 - slice3cost_pixels_cost_0_7;
      slice3cost_change_0_8 <= slice3cost_pixels_cost_1_8 - slice3cost_pixels_cost_0_8;
      slice3cost_change_0_9 <= slice3cost_pixels_cost_1_9 - slice3cost_pixels_cost_0_9;
      slice3cost_change_0_10 <= slice3cost_pixels_cost_1_10 - slice3cost_pixels_cost_0_10;
      slice3cost_change_0_11 <= slice3cost_pixels_cost_1_11 - slice3cost_pixels_cost_0_11;
      slice3cost_change_0_12 <= slice3cost_pixels_cost_1_12 - slice3cost_pixels_cost_0_12;
      slice3cost_change_0_13 <= slice3cost_pixels_cost_1_13 - slice3cost_pixels_cost_0_13;
      slice3cost_change_0_14 <= slice3cost_pixels_cost_1_14 - slice3cost_pixels_cost_0_14;
      slice3cost_change_0_15 <= slice3cost_pixels_cost_1_15 - slice3cost_pixels_cost_0_15;
      slice3cost_ready_words_0 <= to_integer(slice3cost_read_words_0);
      slice3cost_ready_words_1 <= to_integer(slice3cost_read_words_1);
      slice3cost_ready_words_2 <= to_integer(slice3cost_read_words_2);
      slice3cost_ready_words_3 <= to_integer(slice3cost_read_words_3);
      slice3cost_ready_words_4 <= to_integer(slice3cost_read_words_4);
      slice3cost_ready_words_5 <= to_integer(slice3cost_read_words_5);
      slice3cost_column_0_0 <= slice3cost_column_0_0_choice_2;
      slice3cost_column_0_1 <= slice3cost_column_0_1_choice_2;
      slice3cost_column_0_2 <= slice3cost_column_0_2_choice_2;
      slice3cost_column_0_3 <= slice3cost_column_0_3_choice_2;
      slice3cost_column_0_4 <= slice3cost_column_0_4_choice_2;
      slice3cost_column_0_5 <= slice3cost_column_0_5_choice_2;
      slice3cost_column_0_6 <= slice3cost_column_0_6_choice_2;
      slice3cost_column_0_7 <= slice3cost_column_0_7_choice_2;
      slice3cost_column_0_8 <= slice3cost_column_0_8_choice_2;
      slice3cost_column_0_9 <= slice3cost_column_0_9_choice_2;
      slice3cost_column_0_10 <= slice3cost_column_0_10_choice_2;
      slice3cost_column_0_11 <= slice3cost_column_0_11_choice_2;
      slice3cost_column_0_12 <= slice3cost_column_0_12_choice_2;
      slice3cost_column_0_13 <= slice3cost_column_0_13_choice_2;
      slice3cost_column_0_14 <= slice3cost_column_0_14_choice_2;
      slice3cost_column_0_15 <= slice3cost_column_0_15_choice_2;
      if slice0window_entering_tag_valid then
        slice3cost_ready_column <= slice3cost_change_column;
      end if;
      if slice0window_change_tag_valid then
        slice3cost_write_column <= slice2cost_write_column;
        slice3cost_write_words_0 <= (slice3cost_column_0_1_choice_2 * 1024) + slice3cost_column_0_0_choice_2 +
          (slice3cost_column_0_2_choice_2 * 1048576);
        slice3cost_write_words_1 <= (slice3cost_column_0_4_choice_2 * 1024) + slice3cost_column_0_3_choice_2 +
          (slice3cost_column_0_5_choice_2 * 1048576);
        slice3cost_write_words_2 <= (slice3cost_column_0_7_choice_2 * 1024) + slice3cost_column_0_6_choice_2 +
          (slice3cost_column_0_8_choice_2 * 1048576);
        slice3cost_write_words_3 <= (slice3cost_column_0_10_choice_2 * 1024) + slice3cost_column_0_9_choice_2 +
          (slice3cost_column_0_11_choice_2 * 1048576);
        slice3cost_write_words_4 <= (slice3cost_column_0_13_choice_2 * 1024) + slice3cost_column_0_12_choice_2 +
          (slice3cost_column_0_14_choice_2 * 1048576);
        slice3cost_write_words_5 <= slice3cost_column_0_15_choice_2;
      end if;
      -- slice3window
      if slice0window_tag_valid then
        slice3window_ring_write_address <= slice3window_ring_read_address;
        if slice3window_ring_read_address = 15 then
          slice3window_ring_read_address <= 0;
        else
          slice3window_ring_read_address <= (slice3window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_0_choice := to_integer(slice3window_leaving_0(9 downto 0));
      else
        slice3window_change_0_0_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_1_choice := to_integer(slice3window_leaving_0(19 downto 10));
      else
        slice3window_change_0_1_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_2_choice := to_integer(slice3window_leaving_0(29 downto 20));
      else
        slice3window_change_0_2_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_3_choice := to_integer(slice3window_leaving_1(9 downto 0));
      else
        slice3window_change_0_3_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_4_choice := to_integer(slice3window_leaving_1(19 downto 10));
      else
        slice3window_change_0_4_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_5_choice := to_integer(slice3window_leaving_1(29 downto 20));
      else
        slice3window_change_0_5_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_6_choice := to_integer(slice3window_leaving_2(9 downto 0));
      else
        slice3window_change_0_6_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_7_choice := to_integer(slice3window_leaving_2(19 downto 10));
      else
        slice3window_change_0_7_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_8_choice := to_integer(slice3window_leaving_2(29 downto 20));
      else
        slice3window_change_0_8_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_9_choice := to_integer(slice3window_leaving_3(9 downto 0));
      else
        slice3window_change_0_9_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_10_choice := to_integer(slice3window_leaving_3(19 downto 10));
      else
        slice3window_change_0_10_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_11_choice := to_integer(slice3window_leaving_3(29 downto 20));
      else
        slice3window_change_0_11_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_12_choice := to_integer(slice3window_leaving_4(9 downto 0));
      else
        slice3window_change_0_12_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_13_choice := to_integer(slice3window_leaving_4(19 downto 10));
      else
        slice3window_change_0_13_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_14_choice := to_integer(slice3window_leaving_4(29 downto 20));
      else
        slice3window_change_0_14_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_15_choice := to_integer(slice3window_leaving_5);
      else
        slice3window_change_0_15_choice := 0;
      end if;
      slice3window_entering_0_0 <= slice3cost_column_0_0;
      slice3window_entering_0_1 <= slice3cost_column_0_1;
      slice3window_entering_0_2 <= slice3cost_column_0_2;
      slice3window_entering_0_3 <= slice3cost_column_0_3;
      slice3window_entering_0_4 <= slice3cost_column_0_4;
      slice3window_entering_0_5 <= slice3cost_column_0_5;
      slice3window_entering_0_6 <= slice3cost_column_0_6;
      slice3window_entering_0_7 <= slice3cost_column_0_7;
      slice3window_entering_0_8 <= slice3cost_column_0_8;
      slice3window_entering_0_9 <= slice3cost_column_0_9;
      slice3window_entering_0_10 <= slice3cost_column_0_10;
      slice3window_entering_0_11 <= slice3cost_column_0_11;
      slice3window_entering_0_12 <= slice3cost_column_0_12;
      slice3window_entering_0_13 <= slice3cost_column_0_13;
      slice3window_entering_0_14 <= slice3cost_column_0_14;
      slice3window_entering_0_15 <= slice3cost_column_0_15;
      slice3window_change_0_0 <= slice3window_entering_0_0 - slice3window_change_0_0_choice;
      slice3window_change_0_1 <= slice3window_entering_0_1 - slice3window_change_0_1_choice;
      slice3window_change_0_2 <= slice3window_entering_0_2 - slice3window_change_0_2_choice;
      slice3window_change_0_3 <= slice3window_entering_0_3 - slice3window_change_0_3_choice;
      slice3window_change_0_4 <= slice3window_entering_0_4 - slice3window_change_0_4_choice;
      slice3window_change_0_5 <= slice3window_entering_0_5 - slice3window_change_0_5_choice;
      slice3window_change_0_6 <= slice3window_entering_0_6 - slice3window_change_0_6_choice;
      slice3window_change_0_7 <= slice3window_entering_0_7 - slice3window_change_0_7_choice;
      slice3window_change_0_8 <= slice3window_entering_0_8 - slice3window_change_0_8_choice;
      slice3window_change_0_9 <= slice3window_entering_0_9 - slice3window_change_0_9_choice;
      slice3window_change_0_10 <= slice3window_entering_0_10 - slice3window_change_0_10_choice;
      slice3window_change_0_11 <= slice3window_entering_0_11 - slice3window_change_0_11_choice;
      slice3window_change_0_12 <= slice3window_entering_0_12 - slice3window_change_0_12_choice;
      slice3window_change_0_13 <= slice3window_entering_0_13 - slice3window_change_0_13_choice;
      slice3window_change_0_14 <= slice3window_entering_0_14 - slice3window_change_0_14_choice;
      slice3window_change_0_15 <= slice3window_entering_0_15 - slice3window_change_0_15_choice;
      slice3window_change_tag_first_cost <= slice2window_change_tag_first_cost;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_0_choice := 0;
      else
        slice3window_sum_0_0_choice := slice3window_sum_0_0;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_1_choice := 0;
      else
        slice3window_sum_0_1_choice := slice3window_sum_0_1;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_2_choice := 0;
      else
        slice3window_sum_0_2_choice := slice3window_sum_0_2;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_3_choice := 0;
      else
        slice3window_sum_0_3_choice := slice3window_sum_0_3;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_4_choice := 0;
      else
        slice3window_sum_0_4_choice := slice3window_sum_0_4;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_5_choice := 0;
      else
        slice3window_sum_0_5_choice := slice3window_sum_0_5;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_6_choice := 0;
      else
        slice3window_sum_0_6_choice := slice3window_sum_0_6;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_7_choice := 0;
      else
        slice3window_sum_0_7_choice := slice3window_sum_0_7;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_8_choice := 0;
      else
        slice3window_sum_0_8_choice := slice3window_sum_0_8;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_9_choice := 0;
      else
        slice3window_sum_0_9_choice := slice3window_sum_0_9;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_10_choice := 0;
      else
        slice3window_sum_0_10_choice := slice3window_sum_0_10;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_11_choice := 0;
      else
        slice3window_sum_0_11_choice := slice3window_sum_0_11;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_12_choice := 0;
      else
        slice3window_sum_0_12_choice := slice3window_sum_0_12;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_13_choice := 0;
      else
        slice3window_sum_0_13_choice := slice3window_sum_0_13;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_14_choice := 0;
      else
        slice3window_sum_0_14_choice := slice3window_sum_0_14;
      end if;
      if slice3window_change_tag_first_cost then
        slice3window_sum_0_15_choice := 0;
      else
        slice3window_sum_0_15_choice := slice3window_sum_0_15;
      end if;
      if slice0winner2_tag_valid then
        slice3window_sum_0_0 <= (slice3window_sum_0_0_choice + slice3window_change_0_0) mod 16384;
        slice3window_sum_0_1 <= (slice3window_sum_0_1_choice + slice3window_change_0_1) mod 16384;
        slice3window_sum_0_2 <= (slice3window_sum_0_2_choice + slice3window_change_0_2) mod 16384;
        slice3window_sum_0_3 <= (slice3window_sum_0_3_choice + slice3window_change_0_3) mod 16384;
        slice3window_sum_0_4 <= (slice3window_sum_0_4_choice + slice3window_change_0_4) mod 16384;
        slice3window_sum_0_5 <= (slice3window_sum_0_5_choice + slice3window_change_0_5) mod 16384;
        slice3window_sum_0_6 <= (slice3window_sum_0_6_choice + slice3window_change_0_6) mod 16384;
        slice3window_sum_0_7 <= (slice3window_sum_0_7_choice + slice3window_change_0_7) mod 16384;
        slice3window_sum_0_8 <= (slice3window_sum_0_8_choice + slice3window_change_0_8) mod 16384;
        slice3window_sum_0_9 <= (slice3window_sum_0_9_choice + slice3window_change_0_9) mod 16384;
        slice3window_sum_0_10 <= (slice3window_sum_0_10_choice + slice3window_change_0_10) mod 16384;
        slice3window_sum_0_11 <= (slice3window_sum_0_11_choice + slice3window_change_0_11) mod 16384;
        slice3window_sum_0_12 <= (slice3window_sum_0_12_choice + slice3window_change_0_12) mod 16384;
        slice3window_sum_0_13 <= (slice3window_sum_0_13_choice + slice3window_change_0_13) mod 16384;
        slice3window_sum_0_14 <= (slice3window_sum_0_14_choice + slice3window_change_0_14) mod 16384;
        slice3window_sum_0_15 <= (slice3window_sum_0_15_choice + slice3window_change_0_15) mod 16384;
        slice3window_centre_output_column_0 <= slice2window_centre_output_column_0;
        slice3window_centre_output_column_1 <= slice3window_centre_output_column_0;
        slice3window_centre_output_column_2 <= slice3window_centre_output_column_1;
        slice3window_centre_output_column_3 <= slice3window_centre_output_column_2;
        slice3window_centre_output_column_4 <= slice3window_centre_output_column_3;
        slice3window_centre_output_column_5 <= slice3window_centre_output_column_4;
        slice3window_centre_start_of_frame_1 <= slice2window_centre_start_of_frame_1;
        slice3window_centre_start_of_frame_5 <= slice1window_centre_start_of_frame_5;
        slice3window_centre_end_of_line_0 <= slice2window_centre_end_of_line_0;
        slice3window_centre_end_of_line_1 <= slice3window_centre_end_of_line_0;
        slice3window_centre_end_of_line_2 <= slice3window_centre_end_of_line_1;
        slice3window_centre_end_of_line_3 <= slice3window_centre_end_of_line_2;
        slice3window_centre_end_of_line_4 <= slice3window_centre_end_of_line_3;
        slice3window_centre_end_of_line_5 <= slice3window_centre_end_of_line_4;
      end if;
      -- slice3winner1
      slice3winner1_best_index_0_0_is_not_less := (slice3window_sum_0_0 - slice3window_sum_0_1) >= 0;
      slice3winner1_best_index_0_1_is_less := (slice3window_sum_0_2 - slice3window_sum_0_3) < 0;
      slice3winner1_best_index_0_2_is_less := (slice3window_sum_0_4 - slice3window_sum_0_5) < 0;
      slice3winner1_best_index_0_3_is_less := (slice3window_sum_0_6 - slice3window_sum_0_7) < 0;
      slice3winner1_best_index_0_4_is_less := (slice3window_sum_0_8 - slice3window_sum_0_9) < 0;
      slice3winner1_best_index_0_5_is_less := (slice3window_sum_0_10 - slice3window_sum_0_11) < 0;
      slice3winner1_best_index_0_6_is_less := (slice3window_sum_0_12 - slice3window_sum_0_13) < 0;
      slice3winner1_best_index_0_7_is_less := (slice3window_sum_0_14 - slice3window_sum_0_15) < 0;
      slice3winner1_held_0_0 <= slice3window_sum_0_0;
      slice3winner1_held_0_1 <= slice3window_sum_0_1;
      slice3winner1_held_0_2 <= slice3window_sum_0_2;
      slice3winner1_held_0_3 <= slice3window_sum_0_3;
      slice3winner1_held_0_4 <= slice3window_sum_0_4;
      slice3winner1_held_0_5 <= slice3window_sum_0_5;
      slice3winner1_held_0_6 <= slice3window_sum_0_6;
      slice3winner1_held_0_7 <= slice3window_sum_0_7;
      slice3winner1_held_0_8 <= slice3window_sum_0_8;
      slice3winner1_held_0_9 <= slice3window_sum_0_9;
      slice3winner1_held_0_10 <= slice3window_sum_0_10;
      slice3winner1_held_0_11 <= slice3window_sum_0_11;
      slice3winner1_held_0_12 <= slice3window_sum_0_12;
      slice3winner1_held_0_13 <= slice3window_sum_0_13;
      slice3winner1_held_0_14 <= slice3window_sum_0_14;
      slice3winner1_held_0_15 <= slice3window_sum_0_15;
      slice3winner1_best_index_0_0 <= slice3winner1_best_index_0_0_is_not_less;
      slice3winner1_best_late_cost_0_0 <= slice3winner1_best_cost_0_0;
      slice3winner1_best_late_cost_0_1 <= slice3winner1_best_cost_0_1;
      slice3winner1_best_late_cost_0_2 <= slice3winner1_best_cost_0_2;
      slice3winner1_best_late_cost_0_3 <= slice3winner1_best_cost_0_3;
      slice3winner1_best_late_cost_0_4 <= slice3winner1_best_cost_0_4;
      slice3winner1_best_late_cost_0_5 <= slice3winner1_best_cost_0_5;
      slice3winner1_best_late_cost_0_6 <= slice3winner1_best_cost_0_6;
      slice3winner1_best_late_cost_0_7 <= slice3winner1_best_cost_0_7;
      slice3winner1_best_but_first_0_0 <= slice3winner1_held_0_1;
      slice3winner1_best_but_first_0_1 <= slice3winner1_held_0_3;
      slice3winner1_best_but_first_0_2 <= slice3winner1_held_0_5;
      slice3winner1_best_but_first_0_3 <= slice3winner1_held_0_7;
      slice3winner1_best_but_first_0_4 <= slice3winner1_held_0_9;
      slice3winner1_best_but_first_0_5 <= slice3winner1_held_0_11;
      slice3winner1_best_but_first_0_6 <= slice3winner1_held_0_13;
      slice3winner1_best_but_first_0_7 <= slice3winner1_held_0_15;
      slice3winner1_best_but_last_0_0 <= slice3winner1_held_0_0;
      slice3winner1_best_but_last_0_1 <= slice3winner1_held_0_2;
      slice3winner1_best_but_last_0_2 <= slice3winner1_held_0_4;
      slice3winner1_best_but_last_0_3 <= slice3winner1_held_0_6;
      slice3winner1_best_but_last_0_4 <= slice3winner1_held_0_8;
      slice3winner1_best_but_last_0_5 <= slice3winner1_held_0_10;
      slice3winner1_best_but_last_0_6 <= slice3winner1_held_0_12;
      if (slice3window_sum_0_1 - slice3window_sum_0_0) < 0 then
        slice3winner1_best_cost_0_0 <= slice3window_sum_0_1;
      else
        slice3winner1_best_cost_0_0 <= slice3window_sum_0_0;
      end if;
      if (slice3window_sum_0_3 - slice3window_sum_0_2) < 0 then
        slice3winner1_best_cost_0_1 <= slice3window_sum_0_3;
      else
        slice3winner1_best_cost_0_1 <= slice3window_sum_0_2;
      end if;
      if (slice3window_sum_0_5 - slice3window_sum_0_4) < 0 then
        slice3winner1_best_cost_0_2 <= slice3window_sum_0_5;
      else
        slice3winner1_best_cost_0_2 <= slice3window_sum_0_4;
      end if;
      if (slice3window_sum_0_7 - slice3window_sum_0_6) < 0 then
        slice3winner1_best_cost_0_3 <= slice3window_sum_0_7;
      else
        slice3winner1_best_cost_0_3 <= slice3window_sum_0_6;
      end if;
      if (slice3window_sum_0_9 - slice3window_sum_0_8) < 0 then
        slice3winner1_best_cost_0_4 <= slice3window_sum_0_9;
      else
        slice3winner1_best_cost_0_4 <= slice3window_sum_0_8;
      end if;
      if (slice3window_sum_0_11 - slice3window_sum_0_10) < 0 then
        slice3winner1_best_cost_0_5 <= slice3window_sum_0_11;
      else
        slice3winner1_best_cost_0_5 <= slice3window_sum_0_10;
      end if;
      if (slice3window_sum_0_13 - slice3window_sum_0_12) < 0 then
        slice3winner1_best_cost_0_6 <= slice3window_sum_0_13;
      else
        slice3winner1_best_cost_0_6 <= slice3window_sum_0_12;
      end if;
      if (slice3window_sum_0_15 - slice3window_sum_0_14) < 0 then
        slice3winner1_best_cost_0_7 <= slice3window_sum_0_15;
      else
        slice3winner1_best_cost_0_7 <= slice3window_sum_0_14;
      end if;
      if slice3winner1_best_index_0_1_is_less then
        slice3winner1_best_index_0_1 <= 2;
        slice3winner1_best_below_0_1 <= 0;
        slice3winner1_best_above_0_1 <= slice3window_sum_0_3;
      else
        slice3winner1_best_index_0_1 <= 3;
        slice3winner1_best_below_0_1 <= slice3window_sum_0_2;
        slice3winner1_best_above_0_1 <= 0;
      end if;
      if slice3winner1_best_index_0_2_is_less then
        slice3winner1_best_index_0_2 <= 4;
        slice3winner1_best_below_0_2 <= 0;
        slice3winner1_best_above_0_2 <= slice3window_sum_0_5;
      else
        slice3winner1_best_index_0_2 <= 5;
        slice3winner1_best_below_0_2 <= slice3window_sum_0_4;
        slice3winner1_best_above_0_2 <= 0;
      end if;
      if slice3winner1_best_index_0_3_is_less then
        slice3winner1_best_index_0_3 <= 6;
        slice3winner1_best_below_0_3 <= 0;
        slice3winner1_best_above_0_3 <= slice3window_sum_0_7;
      else
        slice3winner1_best_index_0_3 <= 7;
        slice3winner1_best_below_0_3 <= slice3window_sum_0_6;
        slice3winner1_best_above_0_3 <= 0;
      end if;
      if slice3winner1_best_index_0_4_is_less then
        slice3winner1_best_index_0_4 <= 8;
        slice3winner1_best_below_0_4 <= 0;
        slice3winner1_best_above_0_4 <= slice3window_sum_0_9;
      else
        slice3winner1_best_index_0_4 <= 9;
        slice3winner1_best_below_0_4 <= slice3window_sum_0_8;
        slice3winner1_best_above_0_4 <= 0;
      end if;
      if slice3winner1_best_index_0_5_is_less then
        slice3winner1_best_index_0_5 <= 10;
        slice3winner1_best_below_0_5 <= 0;
        slice3winner1_best_above_0_5 <= slice3window_sum_0_11;
      else
        slice3winner1_best_index_0_5 <= 11;
        slice3winner1_best_below_0_5 <= slice3window_sum_0_10;
        slice3winner1_best_above_0_5 <= 0;
      end if;
      if slice3winner1_best_index_0_6_is_less then
        slice3winner1_best_index_0_6 <= 12;
        slice3winner1_best_below_0_6 <= 0;
        slice3winner1_best_above_0_6 <= slice3window_sum_0_13;
      else
        slice3winner1_best_index_0_6 <= 13;
        slice3winner1_best_below_0_6 <= slice3window_sum_0_12;
        slice3winner1_best_above_0_6 <= 0;
      end if;
      if slice3winner1_best_index_0_7_is_less then
        slice3winner1_best_index_0_7 <= 14;
        slice3winner1_best_below_0_7 <= 0;
        slice3winner1_best_above_0_7 <= slice3window_sum_0_15;
      else
        slice3winner1_best_index_0_7 <= 15;
        slice3winner1_best_below_0_7 <= slice3window_sum_0_14;
        slice3winner1_best_above_0_7 <= 0;
      end if;
      if slice3winner1_best_index_0_0_is_not_less then
        slice3winner1_best_below_0_0 <= slice3window_sum_0_0;
        slice3winner1_best_above_0_0 <= 0;
      else
        slice3winner1_best_below_0_0 <= 0;
        slice3winner1_best_above_0_0 <= slice3window_sum_0_1;
      end if;
      -- slice3winner2
      slice3winner2_best_index_0_0_is_not_less := (slice3winner1_best_cost_0_0 - slice3winner1_best_cost_0_1) >= 0;
      slice3winner2_best_index_0_1_is_not_less := (slice3winner1_best_cost_0_2 - slice3winner1_best_cost_0_3) >= 0;
      slice3winner2_best_index_0_2_is_not_less := (slice3winner1_best_cost_0_4 - slice3winner1_best_cost_0_5) >= 0;
      slice3winner2_best_index_0_3_is_not_less := (slice3winner1_best_cost_0_6 - slice3winner1_best_cost_0_7) >= 0;
      if other_0 then
        slice3winner2_best_below_0_0_choice := slice3winner1_held_0_1;
      else
        slice3winner2_best_below_0_0_choice := slice3winner1_best_below_0_1;
      end if;
      if other_1 then
        slice3winner2_best_below_0_1_choice := slice3winner1_held_0_5;
      else
        slice3winner2_best_below_0_1_choice := slice3winner1_best_below_0_3;
      end if;
      if other_2 then
        slice3winner2_best_below_0_2_choice := slice3winner1_held_0_9;
      else
        slice3winner2_best_below_0_2_choice := slice3winner1_best_below_0_5;
      end if;
      if other_3 then
        slice3winner2_best_below_0_3_choice := slice3winner1_held_0_13;
      else
        slice3winner2_best_below_0_3_choice := slice3winner1_best_below_0_7;
      end if;
      if slice3winner1_best_index_0_0 then
        slice3winner2_best_above_0_0_choice := slice3winner1_held_0_2;
      else
        slice3winner2_best_above_0_0_choice := slice3winner1_best_above_0_0;
      end if;
      if ((slice3winner1_best_index_0_2 / 4) = 1) and ((slice3winner1_best_index_0_2 mod 2) = 1) then
        slice3winner2_best_above_0_1_choice := slice3winner1_held_0_6;
      else
        slice3winner2_best_above_0_1_choice := slice3winner1_best_above_0_2;
      end if;
      if ((slice3winner1_best_index_0_4 / 8) = 1) and ((slice3winner1_best_index_0_4 mod 2) = 1) then
        slice3winner2_best_above_0_2_choice := slice3winner1_held_0_10;
      else
        slice3winner2_best_above_0_2_choice := slice3winner1_best_above_0_4;
      end if;
      slice3winner2_best_above_0_3_value := ((slice3winner1_best_index_0_6 / 4) mod 2) = 1;
      if ((slice3winner1_best_index_0_6 / 8) = 1) and slice3winner2_best_above_0_3_value and
        ((slice3winner1_best_index_0_6 mod 2) = 1) then
        slice3winner2_best_above_0_3_choice := slice3winner1_held_0_14;
      else
        slice3winner2_best_above_0_3_choice := slice3winner1_best_above_0_6;
      end if;
      if slice3winner2_best_place_0_0 then
        slice3winner2_best_second_0_0_choice := 16383;
      else
        slice3winner2_best_second_0_0_choice := slice3winner1_best_late_cost_0_1;
      end if;
      if slice3winner2_best_at_end_0_0 then
        slice3winner2_best_second_0_0_choice_2 := slice3winner1_best_but_first_0_1;
      else
        slice3winner2_best_second_0_0_choice_2 := slice3winner2_best_second_0_0_choice;
      end if;
      if slice3winner2_best_place_0_0 then
        slice3winner2_best_second_0_0_choice_3 := slice3winner1_best_late_cost_0_0;
      else
        slice3winner2_best_second_0_0_choice_3 := 16383;
      end if;
      if slice3winner2_best_at_start_0_0 then
        slice3winner2_best_second_0_0_choice_4 := slice3winner1_best_but_last_0_0;
      else
        slice3winner2_best_second_0_0_choice_4 := slice3winner2_best_second_0_0_choice_3;
      end if;
      if slice3winner2_best_place_0_1 then
        slice3winner2_best_second_0_1_choice := 16383;
      else
        slice3winner2_best_second_0_1_choice := slice3winner1_best_late_cost_0_3;
      end if;
      if slice3winner2_best_at_end_0_1 then
        slice3winner2_best_second_0_1_choice_2 := slice3winner1_best_but_first_0_3;
      else
        slice3winner2_best_second_0_1_choice_2 := slice3winner2_best_second_0_1_choice;
      end if;
      if slice3winner2_best_place_0_1 then
        slice3winner2_best_second_0_1_choice_3 := slice3winner1_best_late_cost_0_2;
      else
        slice3winner2_best_second_0_1_choice_3 := 16383;
      end if;
      if slice3winner2_best_at_start_0_1 then
        slice3winner2_best_second_0_1_choice_4 := slice3winner1_best_but_last_0_2;
      else
        slice3winner2_best_second_0_1_choice_4 := slice3winner2_best_second_0_1_choice_3;
      end if;
      if slice3winner2_best_place_0_2 then
        slice3winner2_best_second_0_2_choice := 16383;
      else
        slice3winner2_best_second_0_2_choice := slice3winner1_best_late_cost_0_5;
      end if;
      if slice3winner2_best_at_end_0_2 then
        slice3winner2_best_second_0_2_choice_2 := slice3winner1_best_but_first_0_5;
      else
        slice3winner2_best_second_0_2_choice_2 := slice3winner2_best_second_0_2_choice;
      end if;
      if slice3winner2_best_place_0_2 then
        slice3winner2_best_second_0_2_choice_3 := slice3winner1_best_late_cost_0_4;
      else
        slice3winner2_best_second_0_2_choice_3 := 16383;
      end if;
      if slice3winner2_best_at_start_0_2 then
        slice3winner2_best_second_0_2_choice_4 := slice3winner1_best_but_last_0_4;
      else
        slice3winner2_best_second_0_2_choice_4 := slice3winner2_best_second_0_2_choice_3;
      end if;
      if slice3winner2_best_place_0_3 then
        slice3winner2_best_second_0_3_choice := 16383;
      else
        slice3winner2_best_second_0_3_choice := slice3winner1_best_late_cost_0_7;
      end if;
      if slice3winner2_best_at_end_0_3 then
        slice3winner2_best_second_0_3_choice_2 := slice3winner1_best_but_first_0_7;
      else
        slice3winner2_best_second_0_3_choice_2 := slice3winner2_best_second_0_3_choice;
      end if;
      if slice3winner2_best_place_0_3 then
        slice3winner2_best_second_0_3_choice_3 := slice3winner1_best_late_cost_0_6;
      else
        slice3winner2_best_second_0_3_choice_3 := 16383;
      end if;
      if slice3winner2_best_at_start_0_3 then
        slice3winner2_best_second_0_3_choice_4 := slice3winner1_best_but_last_0_6;
      else
        slice3winner2_best_second_0_3_choice_4 := slice3winner2_best_second_0_3_choice_3;
      end if;
      slice3winner2_best_first_0_0 <= slice3winner1_held_0_0;
      slice3winner2_best_first_0_1 <= slice3winner1_held_0_4;
      slice3winner2_best_first_0_2 <= slice3winner1_held_0_8;
      slice3winner2_best_first_0_3 <= slice3winner1_held_0_12;
      slice3winner2_best_last_0_0 <= slice3winner1_held_0_3;
      slice3winner2_best_last_0_1 <= slice3winner1_held_0_7;
      slice3winner2_best_last_0_2 <= slice3winner1_held_0_11;
      slice3winner2_best_place_0_0 <= slice3winner2_best_index_0_0_is_not_less;
      slice3winner2_best_place_0_1 <= slice3winner2_best_index_0_1_is_not_less;
      slice3winner2_best_place_0_2 <= slice3winner2_best_index_0_2_is_not_less;
      slice3winner2_best_place_0_3 <= slice3winner2_best_index_0_3_is_not_less;
      slice3winner2_best_at_start_0_0 <= other_0 and slice3winner2_best_index_0_0_is_not_less;
      slice3winner2_best_at_start_0_1 <= other_1 and slice3winner2_best_index_0_1_is_not_less;
      slice3winner2_best_at_start_0_2 <= other_2 and slice3winner2_best_index_0_2_is_not_less;
      slice3winner2_best_at_start_0_3 <= other_3 and slice3winner2_best_index_0_3_is_not_less;
      slice3winner2_best_at_end_0_0 <= slice3winner1_best_index_0_0 and ((slice3winner1_best_cost_0_0 -
        slice3winner1_best_cost_0_1) < 0);
      slice3winner2_best_at_end_0_1 <= ((slice3winner1_best_cost_0_2 - slice3winner1_best_cost_0_3) < 0) and
        ((slice3winner1_best_index_0_2 / 4) = 1) and ((slice3winner1_best_index_0_2 mod 2) = 1);
      slice3winner2_best_at_end_0_2 <= ((slice3winner1_best_cost_0_4 - slice3winner1_best_cost_0_5) < 0) and
        ((slice3winner1_best_index_0_4 / 8) = 1) and ((slice3winner1_best_index_0_4 mod 2) = 1);
      slice3winner2_best_at_end_0_3 <= ((slice3winner1_best_cost_0_6 - slice3winner1_best_cost_0_7) < 0) and
        ((slice3winner1_best_index_0_6 / 8) = 1) and slice3winner2_best_above_0_3_value and
        ((slice3winner1_best_index_0_6 mod 2) = 1);
      slice3winner2_best_late_cost_0_0 <= slice3winner2_best_cost_0_0;
      slice3winner2_best_late_cost_0_1 <= slice3winner2_best_cost_0_1;
      slice3winner2_best_late_cost_0_2 <= slice3winner2_best_cost_0_2;
      slice3winner2_best_late_cost_0_3 <= slice3winner2_best_cost_0_3;
      if (slice3winner1_best_cost_0_1 - slice3winner1_best_cost_0_0) < 0 then
        slice3winner2_best_cost_0_0 <= slice3winner1_best_cost_0_1;
      else
        slice3winner2_best_cost_0_0 <= slice3winner1_best_cost_0_0;
      end if;
      if (slice3winner1_best_cost_0_3 - slice3winner1_best_cost_0_2) < 0 then
        slice3winner2_best_cost_0_1 <= slice3winner1_best_cost_0_3;
      else
        slice3winner2_best_cost_0_1 <= slice3winner1_best_cost_0_2;
      end if;
      if (slice3winner1_best_cost_0_5 - slice3winner1_best_cost_0_4) < 0 then
        slice3winner2_best_cost_0_2 <= slice3winner1_best_cost_0_5;
      else
        slice3winner2_best_cost_0_2 <= slice3winner1_best_cost_0_4;
      end if;
      if (slice3winner1_best_cost_0_7 - slice3winner1_best_cost_0_6) < 0 then
        slice3winner2_best_cost_0_3 <= slice3winner1_best_cost_0_7;
      else
        slice3winner2_best_cost_0_3 <= slice3winner1_best_cost_0_6;
      end if;
      if slice3winner2_best_index_0_0_is_not_less then
        slice3winner2_best_index_0_0 <= slice3winner1_best_index_0_1;
        slice3winner2_best_below_0_0 <= slice3winner2_best_below_0_0_choice;
        slice3winner2_best_above_0_0 <= slice3winner1_best_above_0_1;
      else
        slice3winner2_best_index_0_0 <= as_number(slice3winner1_best_index_0_0);
        slice3winner2_best_below_0_0 <= slice3winner1_best_below_0_0;
        slice3winner2_best_above_0_0 <= slice3winner2_best_above_0_0_choice;
      end if;
      if slice3winner2_best_index_0_1_is_not_less then
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_3;
        slice3winner2_best_below_0_1 <= slice3winner2_best_below_0_1_choice;
        slice3winner2_best_above_0_1 <= slice3winner1_best_above_0_3;
      else
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_2;
        slice3winner2_best_below_0_1 <= slice3winner1_best_below_0_2;
        slice3winner2_best_above_0_1 <= slice3winner2_best_above_0_1_choice;
      end if;
      if slice3winner2_best_index_0_2_is_not_less then
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_5;
        slice3winner2_best_below_0_2 <= slice3winner2_best_below_0_2_choice;
        slice3winner2_best_above_0_2 <= slice3winner1_best_above_0_5;
      else
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_4;
        slice3winner2_best_below_0_2 <= slice3winner1_best_below_0_4;
        slice3winner2_best_above_0_2 <= slice3winner2_best_above_0_2_choice;
      end if;
      if slice3winner2_best_index_0_3_is_not_less then
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_7;
        slice3winner2_best_below_0_3 <= slice3winner2_best_below_0_3_choice;
        slice3winner2_best_above_0_3 <= slice3winner1_best_above_0_7;
      else
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_6;
        slice3winner2_best_below_0_3 <= slice3winner1_best_below_0_6;
        slice3winner2_best_above_0_3 <= slice3winner2_best_above_0_3_choice;
      end if;
      if (slice3winner2_best_second_0_0_choice_2 - slice3winner2_best_second_0_0_choice_4) < 0 then
        slice3winner2_best_second_0_0 <= slice3winner2_best_second_0_0_choice_2;
      else
        slice3winner2_best_second_0_0 <= slice3winner2_best_second_0_0_choice_4;
      end if;
      if (slice3winner2_best_second_0_1_choice_2 - slice3winner2_best_second_0_1_choice_4) < 0 then
        slice3winner2_best_second_0_1 <= slice3winner2_best_second_0_1_choice_2;
      else
        slice3winner2_best_second_0_1 <= slice3winner2_best_second_0_1_choice_4;
      end if;
      if (slice3winner2_best_second_0_2_choice_2 - slice3winner2_best_second_0_2_choice_4) < 0 then
        slice3winner2_best_second_0_2 <= slice3winner2_best_second_0_2_choice_2;
      else
        slice3winner2_best_second_0_2 <= slice3winner2_best_second_0_2_choice_4;
      end if;
      if (slice3winner2_best_second_0_3_choice_2 - slice3winner2_best_second_0_3_choice_4) < 0 then
        slice3winner2_best_second_0_3 <= slice3winner2_best_second_0_3_choice_2;
      else
        slice3winner2_best_second_0_3 <= slice3winner2_best_second_0_3_choice_4;
      end if;
      if (slice3winner1_best_late_cost_0_1 - slice3winner1_best_but_first_0_0) < 0 then
        slice3winner2_best_but_first_0_0 <= slice3winner1_best_late_cost_0_1;
      else
        slice3winner2_best_but_first_0_0 <= slice3winner1_best_but_first_0_0;
      end if;
      if (slice3winner1_best_late_cost_0_3 - slice3winner1_best_but_first_0_2) < 0 then
        slice3winner2_best_but_first_0_1 <= slice3winner1_best_late_cost_0_3;
      else
        slice3winner2_best_but_first_0_1 <= slice3winner1_best_but_first_0_2;
      end if;
      if (slice3winner1_best_late_cost_0_5 - slice3winner1_best_but_first_0_4) < 0 then
        slice3winner2_best_but_first_0_2 <= slice3winner1_best_late_cost_0_5;
      else
        slice3winner2_best_but_first_0_2 <= slice3winner1_best_but_first_0_4;
      end if;
      if (slice3winner1_best_late_cost_0_7 - slice3winner1_best_but_first_0_6) < 0 then
        slice3winner2_best_but_first_0_3 <= slice3winner1_best_late_cost_0_7;
      else
        slice3winner2_best_but_first_0_3 <= slice3winner1_best_but_first_0_6;
      end if;
      if (slice3winner1_best_but_last_0_1 - slice3winner1_best_late_cost_0_0) < 0 then
        slice3winner2_best_but_last_0_0 <= slice3winner1_best_but_last_0_1;
      else
        slice3winner2_best_but_last_0_0 <= slice3winner1_best_late_cost_0_0;
      end if;
      if (slice3winner1_best_but_last_0_3 - slice3winner1_best_late_cost_0_2) < 0 then
        slice3winner2_best_but_last_0_1 <= slice3winner1_best_but_last_0_3;
      else
        slice3winner2_best_but_last_0_1 <= slice3winner1_best_late_cost_0_2;
      end if;
      if (slice3winner1_best_but_last_0_5 - slice3winner1_best_late_cost_0_4) < 0 then
        slice3winner2_best_but_last_0_2 <= slice3winner1_best_but_last_0_5;
      else
        slice3winner2_best_but_last_0_2 <= slice3winner1_best_late_cost_0_4;
      end if;
      -- slice3winner3
      slice3winner3_best_index_0_0_is_not_less := (slice3winner2_best_cost_0_0 - slice3winner2_best_cost_0_1) >= 0;
      slice3winner3_best_index_0_1_is_not_less := (slice3winner2_best_cost_0_2 - slice3winner2_best_cost_0_3) >= 0;
      slice3winner3_best_below_0_0_is_equal := slice3winner2_best_index_0_1 = 4;
      if slice3winner3_best_below_0_0_is_equal then
        slice3winner3_best_below_0_0_choice := slice3winner2_best_last_0_0;
      else
        slice3winner3_best_below_0_0_choice := slice3winner2_best_below_0_1;
      end if;
      slice3winner3_best_below_0_1_is_equal := slice3winner2_best_index_0_3 = 12;
      if slice3winner3_best_below_0_1_is_equal then
        slice3winner3_best_below_0_1_choice := slice3winner2_best_last_0_2;
      else
        slice3winner3_best_below_0_1_choice := slice3winner2_best_below_0_3;
      end if;
      slice3winner3_best_above_0_0_is_equal := slice3winner2_best_index_0_0 = 3;
      if slice3winner3_best_above_0_0_is_equal then
        slice3winner3_best_above_0_0_choice := slice3winner2_best_first_0_1;
      else
        slice3winner3_best_above_0_0_choice := slice3winner2_best_above_0_0;
      end if;
      slice3winner3_best_above_0_1_is_equal := (slice3winner2_best_index_0_2 mod 4) = 3;
      if ((slice3winner2_best_index_0_2 / 8) = 1) and slice3winner3_best_above_0_1_is_equal then
        slice3winner3_best_above_0_1_choice := slice3winner2_best_first_0_3;
      else
        slice3winner3_best_above_0_1_choice := slice3winner2_best_above_0_2;
      end if;
      if slice3winner3_best_place_0_0 then
        slice3winner3_best_second_0_0_choice := slice3winner2_best_second_0_1;
      else
        slice3winner3_best_second_0_0_choice := slice3winner2_best_late_cost_0_1;
      end if;
      if slice3winner3_best_at_end_0_0 then
        slice3winner3_best_second_0_0_choice_2 := slice3winner2_best_but_first_0_1;
      else
        slice3winner3_best_second_0_0_choice_2 := slice3winner3_best_second_0_0_choice;
      end if;
      if slice3winner3_best_place_0_0 then
        slice3winner3_best_second_0_0_choice_3 := slice3winner2_best_late_cost_0_0;
      else
        slice3winner3_best_second_0_0_choice_3 := slice3winner2_best_second_0_0;
      end if;
      if slice3winner3_best_at_start_0_0 then
        slice3winner3_best_second_0_0_choice_4 := slice3winner2_best_but_last_0_0;
      else
        slice3winner3_best_second_0_0_choice_4 := slice3winner3_best_second_0_0_choice_3;
      end if;
      if slice3winner3_best_place_0_1 then
        slice3winner3_best_second_0_1_choice := slice3winner2_best_second_0_3;
      else
        slice3winner3_best_second_0_1_choice := slice3winner2_best_late_cost_0_3;
      end if;
      if slice3winner3_best_at_end_0_1 then
        slice3winner3_best_second_0_1_choice_2 := slice3winner2_best_but_first_0_3;
      else
        slice3winner3_best_second_0_1_choice_2 := slice3winner3_best_second_0_1_choice;
      end if;
      if slice3winner3_best_place_0_1 then
        slice3winner3_best_second_0_1_choice_3 := slice3winner2_best_late_cost_0_2;
      else
        slice3winner3_best_second_0_1_choice_3 := slice3winner2_best_second_0_2;
      end if;
      if slice3winner3_best_at_start_0_1 then
        slice3winner3_best_second_0_1_choice_4 := slice3winner2_best_but_last_0_2;
      else
        slice3winner3_best_second_0_1_choice_4 := slice3winner3_best_second_0_1_choice_3;
      end if;
      slice3winner3_best_first_0_0 <= slice3winner2_best_first_0_0;
      slice3winner3_best_first_0_1 <= slice3winner2_best_first_0_2;
      slice3winner3_best_last_0_0 <= slice3winner2_best_last_0_1;
      slice3winner3_best_place_0_0 <= slice3winner3_best_index_0_0_is_not_less;
      slice3winner3_best_place_0_1 <= slice3winner3_best_index_0_1_is_not_less;
      slice3winner3_best_at_start_0_0 <= slice3winner3_best_index_0_0_is_not_less and
        slice3winner3_best_below_0_0_is_equal;
      slice3winner3_best_at_start_0_1 <= slice3winner3_best_below_0_1_is_equal and
        slice3winner3_best_index_0_1_is_not_less;
      slice3winner3_best_at_end_0_0 <= ((slice3winner2_best_cost_0_0 - slice3winner2_best_cost_0_1) < 0) and
        slice3winner3_best_above_0_0_is_equal;
      slice3winner3_best_at_end_0_1 <= ((slice3winner2_best_cost_0_2 - slice3winner2_best_cost_0_3) < 0) and
        ((slice3winner2_best_index_0_2 / 8) = 1) and slice3winner3_best_above_0_1_is_equal;
      slice3winner3_best_late_cost_0_0 <= slice3winner3_best_cost_0_0;
      slice3winner3_best_late_cost_0_1 <= slice3winner3_best_cost_0_1;
      if (slice3winner2_best_cost_0_1 - slice3winner2_best_cost_0_0) < 0 then
        slice3winner3_best_cost_0_0 <= slice3winner2_best_cost_0_1;
      else
        slice3winner3_best_cost_0_0 <= slice3winner2_best_cost_0_0;
      end if;
      if (slice3winner2_best_cost_0_3 - slice3winner2_best_cost_0_2) < 0 then
        slice3winner3_best_cost_0_1 <= slice3winner2_best_cost_0_3;
      else
        slice3winner3_best_cost_0_1 <= slice3winner2_best_cost_0_2;
      end if;
      if slice3winner3_best_index_0_0_is_not_less then
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_1;
        slice3winner3_best_below_0_0 <= slice3winner3_best_below_0_0_choice;
        slice3winner3_best_above_0_0 <= slice3winner2_best_above_0_1;
      else
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_0;
        slice3winner3_best_below_0_0 <= slice3winner2_best_below_0_0;
        slice3winner3_best_above_0_0 <= slice3winner3_best_above_0_0_choice;
      end if;
      if slice3winner3_best_index_0_1_is_not_less then
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_3;
        slice3winner3_best_below_0_1 <= slice3winner3_best_below_0_1_choice;
        slice3winner3_best_above_0_1 <= slice3winner2_best_above_0_3;
      else
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_2;
        slice3winner3_best_below_0_1 <= slice3winner2_best_below_0_2;
        slice3winner3_best_above_0_1 <= slice3winner3_best_above_0_1_choice;
      end if;
      if (slice3winner3_best_second_0_0_choice_2 - slice3winner3_best_second_0_0_choice_4) < 0 then
        slice3winner3_best_second_0_0 <= slice3winner3_best_second_0_0_choice_2;
      else
        slice3winner3_best_second_0_0 <= slice3winner3_best_second_0_0_choice_4;
      end if;
      if (slice3winner3_best_second_0_1_choice_2 - slice3winner3_best_second_0_1_choice_4) < 0 then
        slice3winner3_best_second_0_1 <= slice3winner3_best_second_0_1_choice_2;
      else
        slice3winner3_best_second_0_1 <= slice3winner3_best_second_0_1_choice_4;
      end if;
      if (slice3winner2_best_late_cost_0_1 - slice3winner2_best_but_first_0_0) < 0 then
        slice3winner3_best_but_first_0_0 <= slice3winner2_best_late_cost_0_1;
      else
        slice3winner3_best_but_first_0_0 <= slice3winner2_best_but_first_0_0;
      end if;
      if (slice3winner2_best_late_cost_0_3 - slice3winner2_best_but_first_0_2) < 0 then
        slice3winner3_best_but_first_0_1 <= slice3winner2_best_late_cost_0_3;
      else
        slice3winner3_best_but_first_0_1 <= slice3winner2_best_but_first_0_2;
      end if;
      if (slice3winner2_best_but_last_0_1 - slice3winner2_best_late_cost_0_0) < 0 then
        slice3winner3_best_but_last_0_0 <= slice3winner2_best_but_last_0_1;
      else
        slice3winner3_best_but_last_0_0 <= slice3winner2_best_late_cost_0_0;
      end if;
      -- slice3winner4
      slice3winner4_best_index_0_0_is_less := (slice3winner3_best_cost_0_0 - slice3winner3_best_cost_0_1) < 0;
      slice3winner4_best_below_0_0_is_equal := slice3winner3_best_index_0_1 = 8;
      if slice3winner4_best_below_0_0_is_equal then
        slice3winner4_best_below_0_0_choice := slice3winner3_best_last_0_0;
      else
        slice3winner4_best_below_0_0_choice := slice3winner3_best_below_0_1;
      end if;
      slice3winner4_best_above_0_0_is_equal := slice3winner3_best_index_0_0 = 7;
      if slice3winner4_best_above_0_0_is_equal then
        slice3winner4_best_above_0_0_choice := slice3winner3_best_first_0_1;
      else
        slice3winner4_best_above_0_0_choice := slice3winner3_best_above_0_0;
      end if;
      slice3winner4_best_place_0_0_is_not_less := (slice3winner3_best_cost_0_0 - slice3winner3_best_cost_0_1) >= 0;
      if slice3winner4_best_place_0_0 then
        slice3winner4_best_second_0_0_choice := slice3winner3_best_second_0_1;
      else
        slice3winner4_best_second_0_0_choice := slice3winner3_best_late_cost_0_1;
      end if;
      if slice3winner4_best_at_end_0_0 then
        slice3winner4_best_second_0_0_choice_2 := slice3winner3_best_but_first_0_1;
      else
        slice3winner4_best_second_0_0_choice_2 := slice3winner4_best_second_0_0_choice;
      end if;
      if slice3winner4_best_place_0_0 then
        slice3winner4_best_second_0_0_choice_3 := slice3winner3_best_late_cost_0_0;
      else
        slice3winner4_best_second_0_0_choice_3 := slice3winner3_best_second_0_0;
      end if;
      if slice3winner4_best_at_start_0_0 then
        slice3winner4_best_second_0_0_choice_4 := slice3winner3_best_but_last_0_0;
      else
        slice3winner4_best_second_0_0_choice_4 := slice3winner4_best_second_0_0_choice_3;
      end if;
      slice3winner4_best_first_0_0 <= slice3winner3_best_first_0_0;
      slice3winner4_best_place_0_0 <= slice3winner4_best_place_0_0_is_not_less;
      slice3winner4_best_at_start_0_0 <= slice3winner4_best_below_0_0_is_equal and
        slice3winner4_best_place_0_0_is_not_less;
      slice3winner4_best_at_end_0_0 <= slice3winner4_best_index_0_0_is_less and slice3winner4_best_above_0_0_is_equal;
      slice3winner4_best_late_cost_0_0 <= slice3winner4_best_cost_0_0;
      if (slice3winner3_best_cost_0_1 - slice3winner3_best_cost_0_0) < 0 then
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0_1;
      else
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0_0;
      end if;
      if slice3winner4_best_index_0_0_is_less then
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_0;
        slice3winner4_best_below_0_0 <= slice3winner3_best_below_0_0;
        slice3winner4_best_above_0_0 <= slice3winner4_best_above_0_0_choice;
      else
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_1;
        slice3winner4_best_below_0_0 <= slice3winner4_best_below_0_0_choice;
        slice3winner4_best_above_0_0 <= slice3winner3_best_above_0_1;
      end if;
      if (slice3winner4_best_second_0_0_choice_2 - slice3winner4_best_second_0_0_choice_4) < 0 then
        slice3winner4_best_second_0_0 <= slice3winner4_best_second_0_0_choice_2;
      else
        slice3winner4_best_second_0_0 <= slice3winner4_best_second_0_0_choice_4;
      end if;
      if (slice3winner3_best_late_cost_0_1 - slice3winner3_best_but_first_0_0) < 0 then
        slice3winner4_best_but_first_0_0 <= slice3winner3_best_late_cost_0_1;
      else
        slice3winner4_best_but_first_0_0 <= slice3winner3_best_but_first_0_0;
      end if;
      -- slice3
      slice3_best_index_0_0_is_less := (slice2_best_cost_0_0 - slice3winner4_best_cost_0_0) < 0;
      slice3_best_below_0_0_is_equal := slice3winner4_best_index_0_0 = 0;
      if slice3_best_below_0_0_is_equal then
        slice3_best_below_0_0_choice := slice2_best_last_0_0;
      else
        slice3_best_below_0_0_choice := slice3winner4_best_below_0_0;
      end if;
      slice3_best_above_0_0_is_equal := slice2_best_index_0_0 = 47;
      if slice3_best_above_0_0_is_equal then
        slice3_best_above_0_0_choice := slice3winner4_best_first_0_0;
      else
        slice3_best_above_0_0_choice := slice2_best_above_0_0;
      end if;
      slice3_best_place_0_0_is_not_less := (slice2_best_cost_0_0 - slice3winner4_best_cost_0_0) >= 0;
      if slice3_best_place_0_0 then
        slice3_best_second_0_0_choice := slice3winner4_best_second_0_0;
      else
        slice3_best_second_0_0_choice := slice3winner4_best_late_cost_0_0;
      end if;
      if slice3_best_at_end_0_0 then
        slice3_best_second_0_0_choice_2 := slice3winner4_best_but_first_0_0;
      else
        slice3_best_second_0_0_choice_2 := slice3_best_second_0_0_choice;
      end if;
      if slice3_best_place_0_0 then
        slice3_best_second_0_0_choice_3 := slice2_best_late_cost_0_0;
      else
        slice3_best_second_0_0_choice_3 := slice2_best_second_0_0;
      end if;
      if slice3_best_at_start_0_0 then
        slice3_best_second_0_0_choice_4 := slice2_best_but_last_0_0;
      else
        slice3_best_second_0_0_choice_4 := slice3_best_second_0_0_choice_3;
      end if;
      slice3_best_place_0_0 <= slice3_best_place_0_0_is_not_less;
      slice3_best_at_start_0_0 <= slice3_best_below_0_0_is_equal and slice3_best_place_0_0_is_not_less;
      slice3_best_at_end_0_0 <= slice3_best_index_0_0_is_less and slice3_best_above_0_0_is_equal;
      slice3_best_late_cost_0_0 <= slice3_best_cost_0_0;
      slice3_best_tag_valid <= slice2_best_tag_valid;
      slice3_best_tag_output_column <= slice2_best_tag_output_column;
      slice3_best_tag_start_of_frame <= slice2_best_tag_start_of_frame;
      slice3_best_tag_end_of_line <= slice2_best_tag_end_of_line;
      if (slice3winner4_best_cost_0_0 - slice2_best_cost_0_0) < 0 then
        slice3_best_cost_0_0 <= slice3winner4_best_cost_0_0;
      else
        slice3_best_cost_0_0 <= slice2_best_cost_0_0;
      end if;
      if slice3_best_index_0_0_is_less then
        slice3_best_index_0_0 <= slice2_best_index_0_0;
        slice3_best_below_0_0 <= slice2_best_below_0_0;
        slice3_best_above_0_0 <= slice3_best_above_0_0_choice;
      else
        slice3_best_index_0_0 <= slice3winner4_best_index_0_0 + 48;
        slice3_best_below_0_0 <= slice3_best_below_0_0_choice;
        slice3_best_above_0_0 <= slice3winner4_best_above_0_0;
      end if;
      if (slice3_best_second_0_0_choice_2 - slice3_best_second_0_0_choice_4) < 0 then
        slice3_best_second_0_0 <= slice3_best_second_0_0_choice_2;
      else
        slice3_best_second_0_0 <= slice3_best_second_0_0_choice_4;
      end if;
      -- texture
      texture_passes_0_0 <= 9 < texturewindow_sum_0_0;
      texture_passes_1_0 <= texture_passes_0_0;
      texture_passes_2_0 <= texture_passes_1_0;
      texture_passes_3_0 <= texture_passes_2_0;
      texture_passes_4_0 <= texture_passes_3_0;
      texture_passes_5_0 <= texture_passes_4_0;
      texture_passes_6_0 <= texture_passes_5_0;
      texture_passes_7_0 <= texture_passes_6_0;
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
      -- texturecost
      if slice0cost_ready_tag_first_group then
        texturecost_column_0_0_choice := 0;
      else
        texturecost_column_0_0_choice := texturecost_ready_words_0;
      end if;
      if slice0cost_ready_tag_border_column then
        texturecost_column_0_0_choice_2 := 0;
      else
        texturecost_column_0_0_choice_2 := (texturecost_column_0_0_choice + texturecost_change_0_0) mod 1024;
      end if;
      texturecost_pixels_first_0_0 <= texture_taps_search_0_0 - slice0shift_reference_0;
      texturecost_pixels_first_1_0 <= texture_taps_search_1_0 - slice0shift_reference_1;
      texturecost_pixels_cost_0_0 <= folded(texturecost_pixels_first_0_0) + as_number((texturecost_pixels_first_0_0 <
        0));
      texturecost_pixels_cost_1_0 <= folded(texturecost_pixels_first_1_0) + as_number((texturecost_pixels_first_1_0 <
        0));
      texturecost_change_0_0 <= texturecost_pixels_cost_1_0 - texturecost_pixels_cost_0_0;
      texturecost_ready_words_0 <= to_integer(texturecost_read_words_0);
      texturecost_column_0_0 <= texturecost_column_0_0_choice_2;
      if slice0cost_ready_tag_valid then
        texturecost_write_words_0 <= texturecost_column_0_0_choice_2;
      end if;
      -- texturewindow
      if slice0window_entering_tag_leaves_window then
        texturewindow_change_0_0_choice := to_integer(texturewindow_leaving_0);
      else
        texturewindow_change_0_0_choice := 0;
      end if;
      texturewindow_entering_0_0 <= texturecost_column_0_0;
      texturewindow_change_0_0 <= texturewindow_entering_0_0 - texturewindow_change_0_0_choice;
      if slice0window_change_tag_first_cost then
        texturewindow_sum_0_0_choice := 0;
      else
        texturewindow_sum_0_0_choice := texturewindow_sum_0_0;
      end if;
      if slice0window_change_tag_valid then
        texturewindow_sum_0_0 <= (texturewindow_sum_0_0_choice + texturewindow_change_0_0) mod 16384;
      end if;
      -- refinement
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 32768) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 32768) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 32768) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 32768) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 32768) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 32768) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 32768) - refinement_divisor_6_0;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
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
      refinement_disparity_0_0 <= slice3_best_index_0_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_disparity_4_0 <= refinement_disparity_3_0;
      refinement_disparity_5_0 <= refinement_disparity_4_0;
      refinement_disparity_6_0 <= refinement_disparity_5_0;
      refinement_disparity_7_0 <= refinement_disparity_6_0;
      refinement_disparity_8_0 <= refinement_disparity_7_0;
      refinement_disparity_9_0 <= refinement_disparity_8_0;
      refinement_disparity_10_0 <= refinement_disparity_9_0;
      refinement_disparity_11_0 <= refinement_disparity_10_0;
      refinement_passed_0_0 <= texture_passes_7_0;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_tag_0_valid <= slice3_best_tag_valid;
      refinement_tag_0_output_column <= slice3_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice3_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice3_best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_output_column <= refinement_tag_0_output_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_output_column <= refinement_tag_1_output_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_output_column <= refinement_tag_2_output_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_output_column <= refinement_tag_3_output_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_output_column <= refinement_tag_4_output_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_output_column <= refinement_tag_5_output_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_output_column <= refinement_tag_6_output_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_output_column <= refinement_tag_7_output_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_output_column <= refinement_tag_8_output_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_output_column <= refinement_tag_9_output_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_output_column <= refinement_tag_10_output_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_alone_0_0 <= slice3_best_second_0_0 = 16383;
      refinement_alone_1_0 <= refinement_alone_0_0;
      refinement_gap_0 <= (slice3_best_second_0_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_lowest_0 <= slice3_best_late_cost_0_0;
      refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
      refinement_scaled_cost_0 <= ((refinement_lowest_0 + (refinement_lowest_0 / 2)) * 2) + (refinement_lowest_0 mod 2);
      refinement_u_0 <= (refinement_below_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_v_0 <= (refinement_above_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 14)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 14))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((32768 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 16384) +
        ((other_6 / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      if refinement_alone_1_0 then
        refinement_passed_3_0 <= refinement_passed_2_0;
      else
        refinement_passed_3_0 <= refinement_passed_2_0 and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0);
      end if;
      if slice3_best_index_0_0 = 0 then
        refinement_below_0 <= slice3_best_above_0_0;
      else
        refinement_below_0 <= slice3_best_below_0_0;
      end if;
      if slice3_best_index_0_0 = 63 then
        refinement_above_0 <= slice3_best_below_0_0;
      else
        refinement_above_0 <= slice3_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 32768) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 16384;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 32768) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 16384;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 8192) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 32768) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 16384;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 8192) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 32768) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 16384;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 8192) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 32768) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 16384;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 8192) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 32768) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 16384;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 8192) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 32768) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 16384;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 8192) * 2;
      end if;
      -- map
      map_out_disparity_0 <= (((((refinement_disparity_11_0 + (refinement_fraction_0 / 16)) * 2) +
        ((refinement_fraction_0 mod 16) / 8) + 8191) mod 8192) * 8) + (refinement_fraction_0 mod 8);
      map_out_passed_0 <= refinement_passed_11_0;
      map_out_valid <= refinement_tag_11_valid and refinement_tag_11_output_column;
      map_out_start_of_frame <= refinement_tag_11_start_of_frame and refinement_tag_11_valid and
        refinement_tag_11_output_column;
      map_out_end_of_line <= refinement_tag_11_end_of_line and refinement_tag_11_valid and
        refinement_tag_11_output_column;
      -- other
      other_0 <= slice3winner1_best_index_0_1_is_less;
      other_1 <= slice3winner1_best_index_0_3_is_less;
      other_2 <= slice3winner1_best_index_0_5_is_less;
      other_3 <= slice3winner1_best_index_0_7_is_less;
      other_4 <= slice2winner1_best_index_0_1_is_less;
      other_5 <= slice2winner1_best_index_0_3_is_less;
      other_6 <= ((refinement_remainder_7_0_difference / 32768) * 2) + ((other_7 / 4) * 4);
      other_7 <= ((refinement_remainder_6_0_difference / 32768) * 4) + ((other_8 / 8) * 8);
      other_8 <= ((refinement_remainder_5_0_difference / 32768) * 8) + ((other_9 / 16) * 16);
      other_9 <= ((refinement_remainder_4_0_difference / 32768) * 16) + ((other_10 / 32) * 32);
      other_10 <= ((refinement_remainder_3_0_difference / 32768) * 32) + ((other_11 / 64) * 64);
      other_11 <= ((refinement_remainder_2_0_difference / 32768) * 64) + ((other_12 / 128) * 128);
      other_12 <= (refinement_remainder_1_0_difference / 32768) * 128;
      other_13 <= slice2winner1_best_index_0_5_is_less;
      other_14 <= slice2winner1_best_index_0_7_is_less;
      other_15 <= slice1winner1_best_index_0_1_is_less;
      other_16 <= slice1winner1_best_index_0_3_is_less;
      other_17 <= slice1winner1_best_index_0_5_is_less;
      other_18 <= slice1winner1_best_index_0_7_is_less;
      other_19 <= slice0winner1_best_index_0_1_is_less;
      other_20 <= slice0winner1_best_index_0_3_is_less;
      other_21 <= slice0winner1_best_index_0_5_is_less;
      other_22 <= slice0winner1_best_index_0_7_is_less;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 376;
        transform_counter_next_frame <= false;
        transform_read_column <= 0;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_filtering_0_start_of_frame <= false;
        transform_filtering_0_valid <= false;
        transform_filtering_1_start_of_frame <= false;
        transform_filtering_1_valid <= false;
        transform_filtering_2_start_of_frame <= false;
        transform_filtering_2_valid <= false;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 382;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_row_start <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_row_start <= false;
        slice0cost_ready_tag_output_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_output_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_output_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0winner1_tag_valid <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_output_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_output_column <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner4_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_start_of_frame_1 <= false;
        slice1window_centre_start_of_frame_3 <= false;
        slice1window_centre_start_of_frame_4 <= false;
        slice1window_centre_start_of_frame_5 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2cost_read_column <= 0;
        slice2cost_change_column <= 0;
        slice2cost_ready_column <= 0;
        slice2cost_write_column <= 0;
        slice2window_ring_read_address <= 1;
        slice2window_ring_write_address <= 0;
        slice2window_centre_output_column_0 <= false;
        slice2window_centre_start_of_frame_1 <= false;
        slice2window_centre_end_of_line_0 <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        slice3cost_read_column <= 0;
        slice3cost_change_column <= 0;
        slice3cost_ready_column <= 0;
        slice3cost_write_column <= 0;
        slice3window_ring_read_address <= 1;
        slice3window_ring_write_address <= 0;
        slice3window_centre_output_column_0 <= false;
        slice3window_centre_output_column_1 <= false;
        slice3window_centre_output_column_2 <= false;
        slice3window_centre_output_column_3 <= false;
        slice3window_centre_output_column_4 <= false;
        slice3window_centre_output_column_5 <= false;
        slice3window_centre_start_of_frame_1 <= false;
        slice3window_centre_start_of_frame_5 <= false;
        slice3window_centre_end_of_line_0 <= false;
        slice3window_centre_end_of_line_1 <= false;
        slice3window_centre_end_of_line_2 <= false;
        slice3window_centre_end_of_line_3 <= false;
        slice3window_centre_end_of_line_4 <= false;
        slice3window_centre_end_of_line_5 <= false;
        slice3_best_tag_valid <= false;
        slice3_best_tag_output_column <= false;
        slice3_best_tag_start_of_frame <= false;
        slice3_best_tag_end_of_line <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_output_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_output_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_output_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_output_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_output_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_output_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_output_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_output_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_output_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_output_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_output_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_output_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
