-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration opencv_bm: 450x375, 64 disparities, window 15x15, 1 pixel pair a clock.
-- Options: window_px 15, reference left, prefilter xsobel, ties largest, uniqueness_percent 15,
--   texture_threshold 10, subpixel true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config opencv_bm
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
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

  -- whether the bit of this place is 1
  function is_set(value : natural; place : natural) return boolean is
  begin
    return (value / 2 ** place) mod 2 = 1;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type integer_minus_1023_to_1023_1d is array (natural range <>) of integer range -1023 to 1023;
  type integer_minus_127_to_127_2d is array (natural range <>, natural range <>) of integer range -127 to 127;
  type integer_minus_127_to_31_1d is array (natural range <>) of integer range -127 to 31;
  type integer_minus_128_to_128_1d is array (natural range <>) of integer range -128 to 128;
  type natural_1020_1d is array (natural range <>) of natural range 0 to 1020;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_128_2d is array (natural range <>, natural range <>) of natural range 0 to 128;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_16385_to_65534_1d is array (natural range <>) of natural range 16385 to 65534;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column : natural_255_1d(0 to 2);
  signal transform_right_column : natural_255_1d(0 to 2);
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_column_inside_0, transform_read_column_inside_2 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_2, transform_ready_column_inside_0, transform_ready_column_inside_2 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_2, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_start_of_frame, transform_columns_valid, transform_left_filter_whole : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 2);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 2);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 65535;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_column_0 : natural_1020_1d(0 to 2);  -- transform_left_filter_column_#_0
  signal transform_right_filter_column_0 : natural_1020_1d(0 to 2);  -- transform_right_filter_column_#_0
  signal transform_left_filter_slope_0, transform_right_filter_slope_0 : integer range -1020 to 1020;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 127;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 127;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 127;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag_valid, delay_tag_row_start, delay_tag_first_group, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words : unsigned_28_1d(0 to 2);
  signal rows_reference_rows_read_words : unsigned_28_1d(0 to 2);
  signal rows_search_rows_read_words_3, rows_reference_rows_read_words_3 : unsigned(20 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 127;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 127;
  signal rows_search : natural_127_1d(0 to 1);
  signal rows_reference : natural_127_1d(0 to 1);
  signal rows_search_rows_ready_words : natural_268435455_1d(0 to 2);
  signal rows_search_rows_write_words : natural_268435455_1d(0 to 2);
  signal rows_reference_rows_ready_words : natural_268435455_1d(0 to 2);
  signal rows_reference_rows_write_words : natural_268435455_1d(0 to 2);
  signal rows_search_rows_ready_words_3, rows_search_rows_write_words_3 : natural range 0 to 2097151;
  signal rows_reference_rows_ready_words_3, rows_reference_rows_write_words_3 : natural range 0 to 2097151;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag_valid, rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_border_column : boolean;
  signal rows_read_tag_first_cost, rows_read_tag_leaves_window, rows_read_tag_output_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_leaves_window : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_inside : boolean_1d(0 to 1);
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_border_column : boolean;
  signal rows_tag_first_cost, rows_tag_leaves_window, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice0shift_reference : natural_127_1d(0 to 1);
  signal slice0shift_search_out : natural_127_1d(0 to 1);
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
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
  signal slice0cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words : unsigned_30_1d(0 to 4);
  signal slice0cost_read_words_5 : unsigned(9 downto 0);
  signal slice0cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice0cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice0cost_write_words : natural_1073741823_1d(0 to 4);
  signal slice0cost_ready_words_5 : natural range 0 to 1023;
  signal slice0cost_column_0 : natural_1023_1d(0 to 15);
  signal slice0cost_write_words_5 : natural range 0 to 1023;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_30_1d(0 to 4);
  signal slice0window_leaving_5 : unsigned(9 downto 0);
  signal slice0window_entering_0 : natural_1023_1d(0 to 15);
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_group : boolean;
  signal slice0window_entering_tag_border_column, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_group : boolean;
  signal slice0window_change_tag_border_column, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 1);
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice0window_sum_0 : natural_16383_1d(0 to 15);
  -- slice0winner1
  signal slice0winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice0winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_below_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_above_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_late_cost_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_but_first_0 : natural_16383_1d(1 to 7);
  signal slice0winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_below_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_above_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_16383_1d(1 to 3);
  signal slice0winner2_best_last_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_late_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_second_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_but_first_0 : natural_16383_1d(1 to 3);
  signal slice0winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice0winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice0winner2_best_at_end_0 : boolean_1d(0 to 3);
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_below_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_above_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_last_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_late_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_second_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_but_first_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice0winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice0winner3_best_at_end_0 : boolean_1d(0 to 1);
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
  signal slice1shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice1shift_reference : natural_127_1d(0 to 1);
  signal slice1shift_search_out : natural_127_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice1cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words : unsigned_30_1d(0 to 4);
  signal slice1cost_read_words_5 : unsigned(9 downto 0);
  signal slice1cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice1cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice1cost_write_words : natural_1073741823_1d(0 to 4);
  signal slice1cost_ready_words_5 : natural range 0 to 1023;
  signal slice1cost_column_0 : natural_1023_1d(0 to 15);
  signal slice1cost_write_words_5 : natural range 0 to 1023;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_30_1d(0 to 4);
  signal slice1window_leaving_5 : unsigned(9 downto 0);
  signal slice1window_entering_0 : natural_1023_1d(0 to 15);
  signal slice1window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice1window_change_tag_first_cost, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_centre_output_column_0, slice1window_centre_start_of_frame_1 : boolean;
  signal slice1window_centre_start_of_frame : boolean_1d(3 to 5);
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_16383_1d(0 to 15);
  -- slice1winner1
  signal slice1winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice1winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_below_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_above_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_late_cost_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_but_first_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_below_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_above_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_first_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_last_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_late_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_second_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_but_first_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  signal slice1winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice1winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice1winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_below_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_above_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_first_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_last_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_late_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_second_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_but_first_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  signal slice1winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice1winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice1winner3_best_at_end_0 : boolean_1d(0 to 1);
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
  signal slice2shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice2shift_reference : natural_127_1d(0 to 1);
  signal slice2shift_search_out : natural_127_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice2cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words : unsigned_30_1d(0 to 4);
  signal slice2cost_read_words_5 : unsigned(9 downto 0);
  signal slice2cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice2cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice2cost_write_words : natural_1073741823_1d(0 to 4);
  signal slice2cost_ready_words_5 : natural range 0 to 1023;
  signal slice2cost_column_0 : natural_1023_1d(0 to 15);
  signal slice2cost_write_words_5 : natural range 0 to 1023;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving : unsigned_30_1d(0 to 4);
  signal slice2window_leaving_5 : unsigned(9 downto 0);
  signal slice2window_entering_0 : natural_1023_1d(0 to 15);
  signal slice2window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice2window_change_tag_first_cost, slice2window_change_tag_leaves_window : boolean;
  signal slice2window_centre_output_column_0, slice2window_centre_start_of_frame_1 : boolean;
  signal slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_16383_1d(0 to 15);
  -- slice2winner1
  signal slice2winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice2winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_below_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_above_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_late_cost_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_but_first_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_below_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_above_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_first_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_last_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_late_cost_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_second_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_but_first_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  signal slice2winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice2winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice2winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_below_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_above_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_first_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_last_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_late_cost_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_second_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_but_first_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  signal slice2winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice2winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice2winner3_best_at_end_0 : boolean_1d(0 to 1);
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
  signal slice3shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice3shift_reference : natural_127_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice3cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column : natural range 0 to 511;
  signal slice3cost_write_column : natural range 0 to 511;
  signal slice3cost_read_words : unsigned_30_1d(0 to 4);
  signal slice3cost_read_words_5 : unsigned(9 downto 0);
  signal slice3cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice3cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice3cost_write_words : natural_1073741823_1d(0 to 4);
  signal slice3cost_ready_words_5 : natural range 0 to 1023;
  signal slice3cost_column_0 : natural_1023_1d(0 to 15);
  signal slice3cost_write_words_5 : natural range 0 to 1023;
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 15;
  signal slice3window_leaving : unsigned_30_1d(0 to 4);
  signal slice3window_leaving_5 : unsigned(9 downto 0);
  signal slice3window_entering_0 : natural_1023_1d(0 to 15);
  signal slice3window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice3window_change_tag_first_cost : boolean;
  signal slice3window_centre_output_column : boolean_1d(0 to 5);
  signal slice3window_centre_start_of_frame_1, slice3window_centre_start_of_frame_5 : boolean;
  signal slice3window_centre_end_of_line : boolean_1d(0 to 5);
  signal slice3window_sum_0 : natural_16383_1d(0 to 15);
  -- slice3winner1
  signal slice3winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice3winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_below_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_above_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_late_cost_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_but_first_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_but_last_0 : natural_16383_1d(0 to 6);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0_1 : natural range 0 to 3;
  signal slice3winner1_best_index_0_2 : natural range 0 to 5;
  signal slice3winner1_best_index_0_3 : natural range 0 to 7;
  signal slice3winner1_best_index_0_4 : natural range 0 to 9;
  signal slice3winner1_best_index_0_5 : natural range 0 to 11;
  signal slice3winner1_best_index_0_6 : natural range 0 to 13;
  signal slice3winner1_best_index_0_7 : natural range 0 to 15;
  -- slice3winner2
  signal slice3winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_below_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_above_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_first_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_last_0 : natural_16383_1d(0 to 2);
  signal slice3winner2_best_late_cost_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_second_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_but_first_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_but_last_0 : natural_16383_1d(0 to 2);
  signal slice3winner2_best_index_0_0 : natural range 0 to 3;
  signal slice3winner2_best_index_0_1 : natural range 0 to 7;
  signal slice3winner2_best_index_0_2 : natural range 0 to 11;
  signal slice3winner2_best_index_0_3 : natural range 0 to 15;
  signal slice3winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice3winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice3winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice3winner3
  signal slice3winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_below_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_above_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_first_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_last_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_late_cost_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_second_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_but_first_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_but_last_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_index_0_0 : natural range 0 to 7;
  signal slice3winner3_best_index_0_1 : natural range 0 to 15;
  signal slice3winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice3winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice3winner3_best_at_end_0 : boolean_1d(0 to 1);
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
  signal texture_taps_search_0 : natural_31_1d(0 to 1);  -- texture_taps_search_#_0
  signal texture_passes_0 : boolean_1d(0 to 7);  -- texture_passes_#_0
  -- texturecost
  signal texturecost_pixels_first_0 : integer_minus_127_to_31_1d(0 to 1);  -- texturecost_pixels_first_#_0
  signal texturecost_pixels_cost_0 : natural_127_1d(0 to 1);  -- texturecost_pixels_cost_#_0
  signal texturecost_read_words_0 : unsigned(9 downto 0);
  signal texturecost_change_0_0 : integer range -127 to 127;
  signal texturecost_ready_words_0, texturecost_column_0_0, texturecost_write_words_0 : natural range 0 to 1023;
  -- texturewindow
  signal texturewindow_leaving_0 : unsigned(9 downto 0);
  signal texturewindow_entering_0_0 : natural range 0 to 1023;
  signal texturewindow_change_0_0 : integer range -1023 to 1023;
  signal texturewindow_sum_0_0 : natural range 0 to 16383;
  -- refinement
  signal refinement_disparity_0 : natural_63_1d(0 to 11);  -- refinement_disparity_#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- refinement_passed_#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- refinement_tag_#_valid
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- refinement_tag_#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- refinement_tag_#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- refinement_tag_#_end_of_line
  signal refinement_alone_0 : boolean_1d(0 to 1);  -- refinement_alone_#_0
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- refinement_negative_#_0
  signal refinement_gap_0, refinement_lowest_0, refinement_below_0, refinement_above_0 : natural range 0 to 16383;
  signal refinement_u_0, refinement_v_0 : natural range 0 to 16383;
  signal refinement_remainder_0 : natural_16383_1d(0 to 7);  -- refinement_remainder_#_0
  signal refinement_divisor_0 : natural_16383_1d(0 to 7);  -- refinement_divisor_#_0
  signal refinement_scaled_gap_0 : natural range 0 to 327660;
  signal refinement_scaled_cost_0 : natural range 0 to 49149;
  signal refinement_difference_0 : integer range -16383 to 16383;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other : boolean_1d(0 to 5);
  signal others_from_13 : boolean_1d(13 to 22);  -- other_#
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
  signal slice3window_leaving_5_memory_read_address, slice3window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice3window_leaving_4_memory_read_enable : boolean;
  signal slice3window_leaving_4_memory_read_address, slice3window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_3_memory_read_enable : boolean;
  signal slice3window_leaving_3_memory_read_address, slice3window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_2_memory_read_enable : boolean;
  signal slice3window_leaving_2_memory_read_address, slice3window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_1_memory_read_enable : boolean;
  signal slice3window_leaving_1_memory_read_address, slice3window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice3window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice3window_leaving_0_memory_read_enable : boolean;
  signal slice3window_leaving_0_memory_read_address, slice3window_leaving_0_memory_write_address : unsigned(3 downto 0);
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
  signal slice2window_leaving_5_memory_read_address, slice2window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice2window_leaving_4_memory_read_enable : boolean;
  signal slice2window_leaving_4_memory_read_address, slice2window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address, slice2window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address, slice2window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address, slice2window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address, slice2window_leaving_0_memory_write_address : unsigned(3 downto 0);
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
  signal slice1window_leaving_5_memory_read_address, slice1window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice1window_leaving_4_memory_read_enable : boolean;
  signal slice1window_leaving_4_memory_read_address, slice1window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address, slice1window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address, slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address, slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address, slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
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
  signal slice0window_leaving_5_memory_read_address, slice0window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_5_memory_write_data : unsigned(9 downto 0);
  signal slice0window_leaving_4_memory_read_enable : boolean;
  signal slice0window_leaving_4_memory_read_address, slice0window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_4_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address, slice0window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address, slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address, slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(29 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address, slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
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
  slice3window_leaving_5_memory_write_data <= to_unsigned(slice3cost_column_0(15), 10);
  slice3window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_5_memory_read_enable,
      read_address => slice3window_leaving_5_memory_read_address, read_data => slice3window_leaving_5,
      write_address => slice3window_leaving_5_memory_write_address, write_data => slice3window_leaving_5_memory_write_data);

  slice3window_leaving_4_memory_read_enable <= true;
  slice3window_leaving_4_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_4_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_4_memory_write_data <= to_unsigned(slice3cost_column_0(14), 10) & to_unsigned(slice3cost_column_0(13), 10) & to_unsigned(slice3cost_column_0(12), 10);
  slice3window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_4_memory_read_enable,
      read_address => slice3window_leaving_4_memory_read_address, read_data => slice3window_leaving(4),
      write_address => slice3window_leaving_4_memory_write_address, write_data => slice3window_leaving_4_memory_write_data);

  slice3window_leaving_3_memory_read_enable <= true;
  slice3window_leaving_3_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_3_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_3_memory_write_data <= to_unsigned(slice3cost_column_0(11), 10) & to_unsigned(slice3cost_column_0(10), 10) & to_unsigned(slice3cost_column_0(9), 10);
  slice3window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_3_memory_read_enable,
      read_address => slice3window_leaving_3_memory_read_address, read_data => slice3window_leaving(3),
      write_address => slice3window_leaving_3_memory_write_address, write_data => slice3window_leaving_3_memory_write_data);

  slice3window_leaving_2_memory_read_enable <= true;
  slice3window_leaving_2_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_2_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_2_memory_write_data <= to_unsigned(slice3cost_column_0(8), 10) & to_unsigned(slice3cost_column_0(7), 10) & to_unsigned(slice3cost_column_0(6), 10);
  slice3window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_2_memory_read_enable,
      read_address => slice3window_leaving_2_memory_read_address, read_data => slice3window_leaving(2),
      write_address => slice3window_leaving_2_memory_write_address, write_data => slice3window_leaving_2_memory_write_data);

  slice3window_leaving_1_memory_read_enable <= true;
  slice3window_leaving_1_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_1_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_1_memory_write_data <= to_unsigned(slice3cost_column_0(5), 10) & to_unsigned(slice3cost_column_0(4), 10) & to_unsigned(slice3cost_column_0(3), 10);
  slice3window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_1_memory_read_enable,
      read_address => slice3window_leaving_1_memory_read_address, read_data => slice3window_leaving(1),
      write_address => slice3window_leaving_1_memory_write_address, write_data => slice3window_leaving_1_memory_write_data);

  slice3window_leaving_0_memory_read_enable <= true;
  slice3window_leaving_0_memory_read_address <= to_unsigned(slice3window_ring_read_address, 4);
  slice3window_leaving_0_memory_write_address <= to_unsigned(slice3window_ring_write_address, 4);
  slice3window_leaving_0_memory_write_data <= to_unsigned(slice3cost_column_0(2), 10) & to_unsigned(slice3cost_column_0(1), 10) & to_unsigned(slice3cost_column_0(0), 10);
  slice3window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice3window_leaving_0_memory_read_enable,
      read_address => slice3window_leaving_0_memory_read_address, read_data => slice3window_leaving(0),
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
  slice3cost_read_words_4_memory_write_data <= to_unsigned(slice3cost_write_words(4), 30);
  slice3cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_4_memory_read_enable,
      read_address => slice3cost_read_words_4_memory_read_address, read_data => slice3cost_read_words(4),
      write_address => slice3cost_read_words_4_memory_write_address, write_data => slice3cost_read_words_4_memory_write_data);

  slice3cost_read_words_3_memory_read_enable <= true;
  slice3cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_3_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_3_memory_write_data <= to_unsigned(slice3cost_write_words(3), 30);
  slice3cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_3_memory_read_enable,
      read_address => slice3cost_read_words_3_memory_read_address, read_data => slice3cost_read_words(3),
      write_address => slice3cost_read_words_3_memory_write_address, write_data => slice3cost_read_words_3_memory_write_data);

  slice3cost_read_words_2_memory_read_enable <= true;
  slice3cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_2_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_2_memory_write_data <= to_unsigned(slice3cost_write_words(2), 30);
  slice3cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_2_memory_read_enable,
      read_address => slice3cost_read_words_2_memory_read_address, read_data => slice3cost_read_words(2),
      write_address => slice3cost_read_words_2_memory_write_address, write_data => slice3cost_read_words_2_memory_write_data);

  slice3cost_read_words_1_memory_read_enable <= true;
  slice3cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_1_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_1_memory_write_data <= to_unsigned(slice3cost_write_words(1), 30);
  slice3cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_1_memory_read_enable,
      read_address => slice3cost_read_words_1_memory_read_address, read_data => slice3cost_read_words(1),
      write_address => slice3cost_read_words_1_memory_write_address, write_data => slice3cost_read_words_1_memory_write_data);

  slice3cost_read_words_0_memory_read_enable <= true;
  slice3cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_change_column, 9);
  slice3cost_read_words_0_memory_write_address <= to_unsigned(slice3cost_write_column, 9);
  slice3cost_read_words_0_memory_write_data <= to_unsigned(slice3cost_write_words(0), 30);
  slice3cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_0_memory_read_enable,
      read_address => slice3cost_read_words_0_memory_read_address, read_data => slice3cost_read_words(0),
      write_address => slice3cost_read_words_0_memory_write_address, write_data => slice3cost_read_words_0_memory_write_data);

  slice2window_leaving_5_memory_read_enable <= true;
  slice2window_leaving_5_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_5_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_5_memory_write_data <= to_unsigned(slice2cost_column_0(15), 10);
  slice2window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_5_memory_read_enable,
      read_address => slice2window_leaving_5_memory_read_address, read_data => slice2window_leaving_5,
      write_address => slice2window_leaving_5_memory_write_address, write_data => slice2window_leaving_5_memory_write_data);

  slice2window_leaving_4_memory_read_enable <= true;
  slice2window_leaving_4_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_4_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_4_memory_write_data <= to_unsigned(slice2cost_column_0(14), 10) & to_unsigned(slice2cost_column_0(13), 10) & to_unsigned(slice2cost_column_0(12), 10);
  slice2window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_4_memory_read_enable,
      read_address => slice2window_leaving_4_memory_read_address, read_data => slice2window_leaving(4),
      write_address => slice2window_leaving_4_memory_write_address, write_data => slice2window_leaving_4_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0(11), 10) & to_unsigned(slice2cost_column_0(10), 10) & to_unsigned(slice2cost_column_0(9), 10);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving(3),
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0(8), 10) & to_unsigned(slice2cost_column_0(7), 10) & to_unsigned(slice2cost_column_0(6), 10);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving(2),
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0(5), 10) & to_unsigned(slice2cost_column_0(4), 10) & to_unsigned(slice2cost_column_0(3), 10);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving(1),
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0(2), 10) & to_unsigned(slice2cost_column_0(1), 10) & to_unsigned(slice2cost_column_0(0), 10);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving(0),
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
  slice2cost_read_words_4_memory_write_data <= to_unsigned(slice2cost_write_words(4), 30);
  slice2cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_4_memory_read_enable,
      read_address => slice2cost_read_words_4_memory_read_address, read_data => slice2cost_read_words(4),
      write_address => slice2cost_read_words_4_memory_write_address, write_data => slice2cost_read_words_4_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_3_memory_write_data <= to_unsigned(slice2cost_write_words(3), 30);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words(3),
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_2_memory_write_data <= to_unsigned(slice2cost_write_words(2), 30);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words(2),
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_1_memory_write_data <= to_unsigned(slice2cost_write_words(1), 30);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words(1),
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice3cost_ready_column, 9);
  slice2cost_read_words_0_memory_write_data <= to_unsigned(slice2cost_write_words(0), 30);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words(0),
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_5_memory_read_enable <= true;
  slice1window_leaving_5_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_5_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_5_memory_write_data <= to_unsigned(slice1cost_column_0(15), 10);
  slice1window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_5_memory_read_enable,
      read_address => slice1window_leaving_5_memory_read_address, read_data => slice1window_leaving_5,
      write_address => slice1window_leaving_5_memory_write_address, write_data => slice1window_leaving_5_memory_write_data);

  slice1window_leaving_4_memory_read_enable <= true;
  slice1window_leaving_4_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_4_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_4_memory_write_data <= to_unsigned(slice1cost_column_0(14), 10) & to_unsigned(slice1cost_column_0(13), 10) & to_unsigned(slice1cost_column_0(12), 10);
  slice1window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_4_memory_read_enable,
      read_address => slice1window_leaving_4_memory_read_address, read_data => slice1window_leaving(4),
      write_address => slice1window_leaving_4_memory_write_address, write_data => slice1window_leaving_4_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0(11), 10) & to_unsigned(slice1cost_column_0(10), 10) & to_unsigned(slice1cost_column_0(9), 10);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving(3),
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0(8), 10) & to_unsigned(slice1cost_column_0(7), 10) & to_unsigned(slice1cost_column_0(6), 10);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving(2),
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0(5), 10) & to_unsigned(slice1cost_column_0(4), 10) & to_unsigned(slice1cost_column_0(3), 10);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving(1),
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0(2), 10) & to_unsigned(slice1cost_column_0(1), 10) & to_unsigned(slice1cost_column_0(0), 10);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving(0),
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
  slice1cost_read_words_4_memory_write_data <= to_unsigned(slice1cost_write_words(4), 30);
  slice1cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_4_memory_read_enable,
      read_address => slice1cost_read_words_4_memory_read_address, read_data => slice1cost_read_words(4),
      write_address => slice1cost_read_words_4_memory_write_address, write_data => slice1cost_read_words_4_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words(3), 30);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words(3),
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words(2), 30);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words(2),
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words(1), 30);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words(1),
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words(0), 30);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words(0),
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_5_memory_read_enable <= true;
  slice0window_leaving_5_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_5_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_5_memory_write_data <= to_unsigned(slice0cost_column_0(15), 10);
  slice0window_leaving_5_memory : entity work.line_memory
    generic map (depth => 16, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_5_memory_read_enable,
      read_address => slice0window_leaving_5_memory_read_address, read_data => slice0window_leaving_5,
      write_address => slice0window_leaving_5_memory_write_address, write_data => slice0window_leaving_5_memory_write_data);

  slice0window_leaving_4_memory_read_enable <= true;
  slice0window_leaving_4_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_4_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_4_memory_write_data <= to_unsigned(slice0cost_column_0(14), 10) & to_unsigned(slice0cost_column_0(13), 10) & to_unsigned(slice0cost_column_0(12), 10);
  slice0window_leaving_4_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_4_memory_read_enable,
      read_address => slice0window_leaving_4_memory_read_address, read_data => slice0window_leaving(4),
      write_address => slice0window_leaving_4_memory_write_address, write_data => slice0window_leaving_4_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0(11), 10) & to_unsigned(slice0cost_column_0(10), 10) & to_unsigned(slice0cost_column_0(9), 10);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving(3),
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0(8), 10) & to_unsigned(slice0cost_column_0(7), 10) & to_unsigned(slice0cost_column_0(6), 10);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving(2),
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0(5), 10) & to_unsigned(slice0cost_column_0(4), 10) & to_unsigned(slice0cost_column_0(3), 10);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving(1),
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0(2), 10) & to_unsigned(slice0cost_column_0(1), 10) & to_unsigned(slice0cost_column_0(0), 10);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving(0),
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
  slice0cost_read_words_4_memory_write_data <= to_unsigned(slice0cost_write_words(4), 30);
  slice0cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_4_memory_read_enable,
      read_address => slice0cost_read_words_4_memory_read_address, read_data => slice0cost_read_words(4),
      write_address => slice0cost_read_words_4_memory_write_address, write_data => slice0cost_read_words_4_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words(3), 30);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words(3),
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words(2), 30);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words(2),
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words(1), 30);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words(1),
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words(0), 30);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words(0),
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
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words(2), 28);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words(2),
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words(1), 28);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words(1),
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words(0), 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words(0),
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
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words(2), 28);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words(2),
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words(1), 28);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words(1),
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words(0), 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words(0),
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
    variable transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choices : boolean_1d(2 to 3);  -- transform_counter_next_frame_choice_#
    variable transform_left_filter_column_0_0_choice_3, transform_right_filter_column_0_0_choice_3 : boolean;
    variable raster_place_group_is_equal, slice0winner1_best_index_0_0_is_not_less : boolean;
    variable slice0winner1_best_index_0_is_less : boolean_1d(1 to 7);  -- slice0winner1_best_index_0_#_is_less
    variable slice0winner2_best_index_0_is_not_less : boolean_1d(0 to 3);  -- slice0winner2_best_index_0_#_is_not_less
    variable slice0winner2_best_above_0_3_value : boolean;
    variable slice0winner3_best_index_0_is_not_less : boolean_1d(0 to 1);  -- slice0winner3_best_index_0_#_is_not_less
    variable slice0winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice0winner3_best_below_0_#_is_equal
    variable slice0winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice0winner3_best_above_0_#_is_equal
    variable slice0winner4_best_index_0_0_is_less, slice0winner4_best_below_0_0_is_equal : boolean;
    variable slice0winner4_best_above_0_0_is_equal, slice0winner4_best_place_0_0_is_not_less : boolean;
    variable slice1winner1_best_index_0_0_is_not_less : boolean;
    variable slice1winner1_best_index_0_is_less : boolean_1d(1 to 7);  -- slice1winner1_best_index_0_#_is_less
    variable slice1winner2_best_index_0_is_not_less : boolean_1d(0 to 3);  -- slice1winner2_best_index_0_#_is_not_less
    variable slice1winner2_best_above_0_3_value : boolean;
    variable slice1winner3_best_index_0_is_not_less : boolean_1d(0 to 1);  -- slice1winner3_best_index_0_#_is_not_less
    variable slice1winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice1winner3_best_below_0_#_is_equal
    variable slice1winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice1winner3_best_above_0_#_is_equal
    variable slice1winner4_best_index_0_0_is_less, slice1winner4_best_below_0_0_is_equal : boolean;
    variable slice1winner4_best_above_0_0_is_equal, slice1winner4_best_place_0_0_is_not_less : boolean;
    variable slice1_best_index_0_0_is_less, slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal : boolean;
    variable slice1_best_place_0_0_is_not_less, slice2winner1_best_index_0_0_is_not_less : boolean;
    variable slice2winner1_best_index_0_is_less : boolean_1d(1 to 7);  -- slice2winner1_best_index_0_#_is_less
    variable slice2winner2_best_index_0_is_not_less : boolean_1d(0 to 3);  -- slice2winner2_best_index_0_#_is_not_less
    variable slice2winner2_best_above_0_3_value : boolean;
    variable slice2winner3_best_index_0_is_not_less : boolean_1d(0 to 1);  -- slice2winner3_best_index_0_#_is_not_less
    variable slice2winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice2winner3_best_below_0_#_is_equal
    variable slice2winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice2winner3_best_above_0_#_is_equal
    variable slice2winner4_best_index_0_0_is_less, slice2winner4_best_below_0_0_is_equal : boolean;
    variable slice2winner4_best_above_0_0_is_equal, slice2winner4_best_place_0_0_is_not_less : boolean;
    variable slice2_best_index_0_0_is_less, slice2_best_below_0_0_is_equal, slice2_best_above_0_0_is_equal : boolean;
    variable slice2_best_place_0_0_is_not_less, slice3winner1_best_index_0_0_is_not_less : boolean;
    variable slice3winner1_best_index_0_is_less : boolean_1d(1 to 7);  -- slice3winner1_best_index_0_#_is_less
    variable slice3winner2_best_index_0_is_not_less : boolean_1d(0 to 3);  -- slice3winner2_best_index_0_#_is_not_less
    variable slice3winner2_best_above_0_3_value : boolean;
    variable slice3winner3_best_index_0_is_not_less : boolean_1d(0 to 1);  -- slice3winner3_best_index_0_#_is_not_less
    variable slice3winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice3winner3_best_below_0_#_is_equal
    variable slice3winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice3winner3_best_above_0_#_is_equal
    variable slice3winner4_best_index_0_0_is_less, slice3winner4_best_below_0_0_is_equal : boolean;
    variable slice3winner4_best_above_0_0_is_equal, slice3winner4_best_place_0_0_is_not_less : boolean;
    variable slice3_best_index_0_0_is_less, slice3_best_below_0_0_is_equal, slice3_best_above_0_0_is_equal : boolean;
    variable slice3_best_place_0_0_is_not_less, refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- transform_counter_group_choice_#
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_choice_2 : natural range 0 to 127;
    variable transform_right_filter_feature_0_choice : natural range 0 to 127;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 127;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice_2, refinement_fraction_0_choice : natural range 0 to 255;
    variable slice0cost_column_0_choice : natural_1023_1d(0 to 15);  -- slice0cost_column_0_#_choice
    variable slice0cost_column_0_choice_2 : natural_1023_1d(0 to 15);  -- slice0cost_column_0_#_choice_2
    variable slice0window_change_0_choice : natural_1023_1d(0 to 15);  -- slice0window_change_0_#_choice
    variable slice1cost_column_0_choice : natural_1023_1d(0 to 15);  -- slice1cost_column_0_#_choice
    variable slice1cost_column_0_choice_2 : natural_1023_1d(0 to 15);  -- slice1cost_column_0_#_choice_2
    variable slice1window_change_0_choice : natural_1023_1d(0 to 15);  -- slice1window_change_0_#_choice
    variable slice2cost_column_0_choice : natural_1023_1d(0 to 15);  -- slice2cost_column_0_#_choice
    variable slice2cost_column_0_choice_2 : natural_1023_1d(0 to 15);  -- slice2cost_column_0_#_choice_2
    variable slice2window_change_0_choice : natural_1023_1d(0 to 15);  -- slice2window_change_0_#_choice
    variable slice3cost_column_0_choice : natural_1023_1d(0 to 15);  -- slice3cost_column_0_#_choice
    variable slice3cost_column_0_choice_2 : natural_1023_1d(0 to 15);  -- slice3cost_column_0_#_choice_2
    variable slice3window_change_0_choice : natural_1023_1d(0 to 15);  -- slice3window_change_0_#_choice
    variable texturecost_column_0_0_choice, texturecost_column_0_0_choice_2 : natural range 0 to 1023;
    variable texturewindow_change_0_0_choice : natural range 0 to 1023;
    variable slice0window_sum_0_choice : natural_16383_1d(0 to 15);  -- slice0window_sum_0_#_choice
    variable slice0winner2_best_below_0_choice : natural_16383_1d(0 to 3);  -- slice0winner2_best_below_0_#_choice
    variable slice0winner2_best_above_0_choice : natural_16383_1d(0 to 3);  -- slice0winner2_best_above_0_#_choice
    variable slice0winner2_best_second_0_choice : natural_16383_1d(0 to 3);  -- slice0winner2_best_second_0_#_choice
    variable slice0winner2_best_second_0_choices : natural_16383_2d(0 to 3, 2 to 4);  -- slice0winner2_best_second_0_#_choice_#
    variable slice0winner3_best_below_0_choice : natural_16383_1d(0 to 1);  -- slice0winner3_best_below_0_#_choice
    variable slice0winner3_best_above_0_choice : natural_16383_1d(0 to 1);  -- slice0winner3_best_above_0_#_choice
    variable slice0winner3_best_second_0_choice : natural_16383_1d(0 to 1);  -- slice0winner3_best_second_0_#_choice
    variable slice0winner3_best_second_0_choices : natural_16383_2d(0 to 1, 2 to 4);  -- slice0winner3_best_second_0_#_choice_#
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice0winner4_best_second_0_0_choice : natural range 0 to 16383;
    variable slice0winner4_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice0winner4_best_second_0_0_choice_#
    variable slice1window_sum_0_choice : natural_16383_1d(0 to 15);  -- slice1window_sum_0_#_choice
    variable slice1winner2_best_below_0_choice : natural_16383_1d(0 to 3);  -- slice1winner2_best_below_0_#_choice
    variable slice1winner2_best_above_0_choice : natural_16383_1d(0 to 3);  -- slice1winner2_best_above_0_#_choice
    variable slice1winner2_best_second_0_choice : natural_16383_1d(0 to 3);  -- slice1winner2_best_second_0_#_choice
    variable slice1winner2_best_second_0_choices : natural_16383_2d(0 to 3, 2 to 4);  -- slice1winner2_best_second_0_#_choice_#
    variable slice1winner3_best_below_0_choice : natural_16383_1d(0 to 1);  -- slice1winner3_best_below_0_#_choice
    variable slice1winner3_best_above_0_choice : natural_16383_1d(0 to 1);  -- slice1winner3_best_above_0_#_choice
    variable slice1winner3_best_second_0_choice : natural_16383_1d(0 to 1);  -- slice1winner3_best_second_0_#_choice
    variable slice1winner3_best_second_0_choices : natural_16383_2d(0 to 1, 2 to 4);  -- slice1winner3_best_second_0_#_choice_#
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice1winner4_best_second_0_0_choice : natural range 0 to 16383;
    variable slice1winner4_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice1winner4_best_second_0_0_choice_#
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 16383;
    variable slice1_best_second_0_0_choice : natural range 0 to 16383;
    variable slice1_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice1_best_second_0_0_choice_#
    variable slice2window_sum_0_choice : natural_16383_1d(0 to 15);  -- slice2window_sum_0_#_choice
    variable slice2winner2_best_below_0_choice : natural_16383_1d(0 to 3);  -- slice2winner2_best_below_0_#_choice
    variable slice2winner2_best_above_0_choice : natural_16383_1d(0 to 3);  -- slice2winner2_best_above_0_#_choice
    variable slice2winner2_best_second_0_choice : natural_16383_1d(0 to 3);  -- slice2winner2_best_second_0_#_choice
    variable slice2winner2_best_second_0_choices : natural_16383_2d(0 to 3, 2 to 4);  -- slice2winner2_best_second_0_#_choice_#
    variable slice2winner3_best_below_0_choice : natural_16383_1d(0 to 1);  -- slice2winner3_best_below_0_#_choice
    variable slice2winner3_best_above_0_choice : natural_16383_1d(0 to 1);  -- slice2winner3_best_above_0_#_choice
    variable slice2winner3_best_second_0_choice : natural_16383_1d(0 to 1);  -- slice2winner3_best_second_0_#_choice
    variable slice2winner3_best_second_0_choices : natural_16383_2d(0 to 1, 2 to 4);  -- slice2winner3_best_second_0_#_choice_#
    variable slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice2winner4_best_second_0_0_choice : natural range 0 to 16383;
    variable slice2winner4_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice2winner4_best_second_0_0_choice_#
    variable slice2_best_below_0_0_choice, slice2_best_above_0_0_choice : natural range 0 to 16383;
    variable slice2_best_second_0_0_choice : natural range 0 to 16383;
    variable slice2_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice2_best_second_0_0_choice_#
    variable slice3window_sum_0_choice : natural_16383_1d(0 to 15);  -- slice3window_sum_0_#_choice
    variable slice3winner2_best_below_0_choice : natural_16383_1d(0 to 3);  -- slice3winner2_best_below_0_#_choice
    variable slice3winner2_best_above_0_choice : natural_16383_1d(0 to 3);  -- slice3winner2_best_above_0_#_choice
    variable slice3winner2_best_second_0_choice : natural_16383_1d(0 to 3);  -- slice3winner2_best_second_0_#_choice
    variable slice3winner2_best_second_0_choices : natural_16383_2d(0 to 3, 2 to 4);  -- slice3winner2_best_second_0_#_choice_#
    variable slice3winner3_best_below_0_choice : natural_16383_1d(0 to 1);  -- slice3winner3_best_below_0_#_choice
    variable slice3winner3_best_above_0_choice : natural_16383_1d(0 to 1);  -- slice3winner3_best_above_0_#_choice
    variable slice3winner3_best_second_0_choice : natural_16383_1d(0 to 1);  -- slice3winner3_best_second_0_#_choice
    variable slice3winner3_best_second_0_choices : natural_16383_2d(0 to 1, 2 to 4);  -- slice3winner3_best_second_0_#_choice_#
    variable slice3winner4_best_below_0_0_choice, slice3winner4_best_above_0_0_choice : natural range 0 to 16383;
    variable slice3winner4_best_second_0_0_choice : natural range 0 to 16383;
    variable slice3winner4_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice3winner4_best_second_0_0_choice_#
    variable slice3_best_below_0_0_choice, slice3_best_above_0_0_choice : natural range 0 to 16383;
    variable slice3_best_second_0_0_choice : natural range 0 to 16383;
    variable slice3_best_second_0_0_choices : natural_16383_1d(2 to 4);  -- slice3_best_second_0_0_choice_#
    variable texturewindow_sum_0_0_choice, refinement_divisor_0_0_choice : natural range 0 to 16383;
    variable refinement_remainder_1_0_difference : natural range 16385 to 49151;
    variable refinement_remainder_0_difference : natural_16385_to_65534_1d(2 to 7);  -- refinement_remainder_#_0_difference
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
        transform_counter_group_choices(2) := 1;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and transform_counter_group_is_equal_2 and in_valid then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
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
      transform_left_column(0) <= transform_left_rows_ready_words_0 mod 256;
      transform_left_column(1) <= transform_left_rows_ready_words_0 / 256;
      transform_left_column(2) <= transform_left_rows_ready_newest_0;
      transform_right_column(0) <= transform_right_rows_ready_words_0 mod 256;
      transform_right_column(1) <= transform_right_rows_ready_words_0 / 256;
      transform_right_column(2) <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_slope_0 <= transform_left_filter_column_0(0) - transform_left_filter_column_0(2);
      transform_left_filter_whole <= transform_filtering_0_column_inside_2 and transform_filtering_0_column_inside_0;
      transform_right_filter_slope_0 <= transform_right_filter_column_0(0) - transform_right_filter_column_0(2);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      transform_filtering_start_of_frame(2) <= transform_filtering_start_of_frame(1);
      transform_filtering_valid(2) <= transform_filtering_valid(1);
      if in_start_of_frame and in_valid then
        transform_counter_group <= transform_counter_group_choice;
      else
        transform_counter_group <= transform_counter_group_choices(3);
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
        transform_counter_next_frame_choices(2) := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choices(2) := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choices(3) := transform_counter_group_is_equal_2 or (not in_start_of_frame);
      else
        transform_counter_next_frame_choices(3) := not in_start_of_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal_2 or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_next_frame_choices(2) then
          transform_counter_next_frame <= transform_counter_next_frame_choices(3);
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
        transform_left_filter_column_0_0_choice := transform_left_column(0);
      else
        transform_left_filter_column_0_0_choice := transform_left_column(2);
      end if;
      if transform_columns_row_inside_2 then
        transform_left_filter_column_0_0_choice_2 := transform_left_column(2);
      else
        transform_left_filter_column_0_0_choice_2 := transform_left_column(0);
      end if;
      if transform_columns_row_inside_2 then
        transform_left_filter_column_0_0_choice_3 := is_set(transform_left_column(2), 0);
      else
        transform_left_filter_column_0_0_choice_3 := is_set(transform_left_column(0), 0);
      end if;
      if transform_columns_row_inside_0 then
        transform_right_filter_column_0_0_choice := transform_right_column(0);
      else
        transform_right_filter_column_0_0_choice := transform_right_column(2);
      end if;
      if transform_columns_row_inside_2 then
        transform_right_filter_column_0_0_choice_2 := transform_right_column(2);
      else
        transform_right_filter_column_0_0_choice_2 := transform_right_column(0);
      end if;
      if transform_columns_row_inside_2 then
        transform_right_filter_column_0_0_choice_3 := is_set(transform_right_column(2), 0);
      else
        transform_right_filter_column_0_0_choice_3 := is_set(transform_right_column(0), 0);
      end if;
      if transform_columns_valid then
        transform_left_filter_column_0(0) <= transform_left_filter_column_0_0_choice +
          (((transform_left_filter_column_0_0_choice_2 / 2) + transform_left_column(1)) * 2) +
          as_number(transform_left_filter_column_0_0_choice_3);
        transform_left_filter_column_0(1) <= transform_left_filter_column_0(0);
        transform_left_filter_column_0(2) <= transform_left_filter_column_0(1);
        transform_right_filter_column_0(0) <= transform_right_filter_column_0_0_choice +
          (((transform_right_filter_column_0_0_choice_2 / 2) + transform_right_column(1)) * 2) +
          as_number(transform_right_filter_column_0_0_choice_3);
        transform_right_filter_column_0(1) <= transform_right_filter_column_0(0);
        transform_right_filter_column_0(2) <= transform_right_filter_column_0(1);
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 449;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(2);
      if transform_filtering_start_of_frame(2) and transform_filtering_valid(2) then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 382) and
          raster_place_group_is_equal and transform_filtering_valid(2)))) mod 512;
      end if;
      if transform_filtering_valid(2) then
        if raster_place_group_is_equal or transform_filtering_start_of_frame(2) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (raster_place_group >= 15) and (raster_place_group < 390);
      delay_row_inside(1) <= raster_place_group < 375;
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
      rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
      rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
      rows_search_rows_ready_words(2) <= to_integer(rows_search_rows_read_words(2));
      rows_search_rows_ready_words_3 <= to_integer(rows_search_rows_read_words_3);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words(0) <= to_integer(rows_reference_rows_read_words(0));
      rows_reference_rows_ready_words(1) <= to_integer(rows_reference_rows_read_words(1));
      rows_reference_rows_ready_words(2) <= to_integer(rows_reference_rows_read_words(2));
      rows_reference_rows_ready_words_3 <= to_integer(rows_reference_rows_read_words_3);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
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
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_first_cost <= rows_read_tag_first_cost;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_inside(0) <= rows_ready_inside(0);
      rows_inside(1) <= rows_ready_inside(1);
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside(0) then
        rows_search(0) <= rows_search_rows_ready_words(0) mod 128;
        rows_reference(0) <= rows_reference_rows_ready_words(0) mod 128;
      else
        rows_search(0) <= 0;
        rows_reference(0) <= 0;
      end if;
      if rows_ready_inside(1) then
        rows_search(1) <= rows_search_rows_ready_newest_0;
        rows_reference(1) <= rows_reference_rows_ready_newest_0;
      else
        rows_search(1) <= 0;
        rows_reference(1) <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words(0) <= (rows_search_rows_ready_words(0) / 128) + ((rows_search_rows_ready_words(1)
          mod 128) * 2097152);
        rows_search_rows_write_words(1) <= (rows_search_rows_ready_words(1) / 128) + ((rows_search_rows_ready_words(2)
          mod 128) * 2097152);
        rows_search_rows_write_words(2) <= (rows_search_rows_ready_words(2) / 128) + ((rows_search_rows_ready_words_3
          mod 128) * 2097152);
        rows_search_rows_write_words_3 <= (rows_search_rows_ready_words_3 / 128) + (rows_search_rows_ready_newest_0 *
          16384);
        rows_reference_rows_write_words(0) <= (rows_reference_rows_ready_words(0) / 128) +
          ((rows_reference_rows_ready_words(1) mod 128) * 2097152);
        rows_reference_rows_write_words(1) <= (rows_reference_rows_ready_words(1) / 128) +
          ((rows_reference_rows_ready_words(2) mod 128) * 2097152);
        rows_reference_rows_write_words(2) <= (rows_reference_rows_ready_words(2) / 128) +
          ((rows_reference_rows_ready_words_3 mod 128) * 2097152);
        rows_reference_rows_write_words_3 <= (rows_reference_rows_ready_words_3 / 128) +
          (rows_reference_rows_ready_newest_0 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        for i in 0 to 1 loop
          slice0shift_search(i, 0) <= rows_search(i);
          for j in 1 to 15 loop
            slice0shift_search(i, j) <= slice0shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice0shift_reference(0) <= rows_reference(0);
      slice0shift_reference(1) <= rows_reference(1);
      slice0shift_search_out(0) <= slice0shift_search(0, 15);
      slice0shift_search_out(1) <= slice0shift_search(1, 15);
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
      for i in 0 to 4 loop
        if slice0cost_ready_tag_first_group then
          slice0cost_column_0_choice(3 * i) := 0;
        else
          slice0cost_column_0_choice(3 * i) := slice0cost_ready_words(i) mod 1024;
        end if;
        if slice0cost_ready_tag_border_column then
          slice0cost_column_0_choice_2(3 * i) := 0;
        else
          slice0cost_column_0_choice_2(3 * i) := (slice0cost_change_0(3 * i) + slice0cost_column_0_choice(3 * i)) mod
            1024;
        end if;
        if slice0cost_ready_tag_first_group then
          slice0cost_column_0_choice(3 * i + 1) := 0;
        else
          slice0cost_column_0_choice(3 * i + 1) := (slice0cost_ready_words(i) / 1024) mod 1024;
        end if;
        if slice0cost_ready_tag_border_column then
          slice0cost_column_0_choice_2(3 * i + 1) := 0;
        else
          slice0cost_column_0_choice_2(3 * i + 1) := (slice0cost_change_0(3 * i + 1) + slice0cost_column_0_choice(3 * i
            + 1)) mod 1024;
        end if;
        if slice0cost_ready_tag_first_group then
          slice0cost_column_0_choice(3 * i + 2) := 0;
        else
          slice0cost_column_0_choice(3 * i + 2) := slice0cost_ready_words(i) / 1048576;
        end if;
        if slice0cost_ready_tag_border_column then
          slice0cost_column_0_choice_2(3 * i + 2) := 0;
        else
          slice0cost_column_0_choice_2(3 * i + 2) := (slice0cost_change_0(3 * i + 2) + slice0cost_column_0_choice(3 * i
            + 2)) mod 1024;
        end if;
      end loop;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_choice(15) := 0;
      else
        slice0cost_column_0_choice(15) := slice0cost_ready_words_5;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_choice_2(15) := 0;
      else
        slice0cost_column_0_choice_2(15) := (slice0cost_change_0(15) + slice0cost_column_0_choice(15)) mod 1024;
      end if;
      for i in 0 to 15 loop
        slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
      end loop;
      for i in 0 to 15 loop
        slice0cost_pixels_first(1, i) <= slice0shift_search(1, i) - slice0shift_reference(1);
      end loop;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice0cost_pixels_cost(i, j) <= folded(slice0cost_pixels_first(i, j)) + as_number((slice0cost_pixels_first(i,
            j) < 0));
        end loop;
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 4 loop
        slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i));
      end loop;
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
      for i in 0 to 15 loop
        slice0cost_column_0(i) <= slice0cost_column_0_choice_2(i);
      end loop;
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
        for i in 0 to 4 loop
          slice0cost_write_words(i) <= (slice0cost_column_0_choice_2(3 * i + 1) * 1024) +
            slice0cost_column_0_choice_2(3 * i) + (slice0cost_column_0_choice_2(3 * i + 2) * 1048576);
        end loop;
        slice0cost_write_words_5 <= slice0cost_column_0_choice_2(15);
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
      for i in 0 to 1 loop
        for j in 0 to 2 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(6 * i + j) := to_integer(slice0window_leaving(2 * i)(10 * j + 9 downto 10 *
              j));
          else
            slice0window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
        for j in 3 to 5 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(6 * i + j) := to_integer(slice0window_leaving(2 * i + 1)(10 * j - 21 downto 10
              * j - 30));
          else
            slice0window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 12 to 14 loop
        if slice0window_entering_tag_leaves_window then
          slice0window_change_0_choice(i) := to_integer(slice0window_leaving(4)(10 * i - 111 downto 10 * i - 120));
        else
          slice0window_change_0_choice(i) := 0;
        end if;
      end loop;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_choice(15) := to_integer(slice0window_leaving_5);
      else
        slice0window_change_0_choice(15) := 0;
      end if;
      for i in 0 to 15 loop
        slice0window_entering_0(i) <= slice0cost_column_0(i);
      end loop;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_border_column <= slice0cost_tag_border_column;
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      for i in 0 to 15 loop
        slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
      end loop;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_group <= slice0window_entering_tag_first_group;
      slice0window_change_tag_border_column <= slice0window_entering_tag_border_column;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_start_of_frame(0) <= slice0window_change_tag_start_of_frame;
      slice0window_centre_start_of_frame(1) <= slice0window_centre_start_of_frame(0);
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      for i in 0 to 15 loop
        if slice0window_change_tag_first_cost then
          slice0window_sum_0_choice(i) := 0;
        else
          slice0window_sum_0_choice(i) := slice0window_sum_0(i);
        end if;
      end loop;
      if slice0window_change_tag_valid then
        for i in 0 to 15 loop
          slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice0winner1
      slice0winner1_best_index_0_0_is_not_less := (slice0window_sum_0(0) - slice0window_sum_0(1)) >= 0;
      for i in 1 to 7 loop
        slice0winner1_best_index_0_is_less(i) := (slice0window_sum_0(2 * i) - slice0window_sum_0(2 * i + 1)) < 0;
      end loop;
      for i in 0 to 15 loop
        slice0winner1_held_0(i) <= slice0window_sum_0(i);
      end loop;
      slice0winner1_best_index_0_0 <= slice0winner1_best_index_0_0_is_not_less;
      for i in 0 to 7 loop
        slice0winner1_best_late_cost_0(i) <= slice0winner1_best_cost_0(i);
      end loop;
      for i in 1 to 7 loop
        slice0winner1_best_but_first_0(i) <= slice0winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 7 loop
        slice0winner1_best_but_last_0(i) <= slice0winner1_held_0(2 * i);
      end loop;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      for i in 0 to 7 loop
        if (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0 then
          slice0winner1_best_cost_0(i) <= slice0window_sum_0(2 * i + 1);
        else
          slice0winner1_best_cost_0(i) <= slice0window_sum_0(2 * i);
        end if;
      end loop;
      if slice0winner1_best_index_0_is_less(1) then
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0(1) <= 0;
        slice0winner1_best_above_0(1) <= slice0window_sum_0(3);
      else
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0(1) <= slice0window_sum_0(2);
        slice0winner1_best_above_0(1) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(2) then
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0(2) <= 0;
        slice0winner1_best_above_0(2) <= slice0window_sum_0(5);
      else
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0(2) <= slice0window_sum_0(4);
        slice0winner1_best_above_0(2) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(3) then
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0(3) <= 0;
        slice0winner1_best_above_0(3) <= slice0window_sum_0(7);
      else
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0(3) <= slice0window_sum_0(6);
        slice0winner1_best_above_0(3) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(4) then
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0(4) <= 0;
        slice0winner1_best_above_0(4) <= slice0window_sum_0(9);
      else
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0(4) <= slice0window_sum_0(8);
        slice0winner1_best_above_0(4) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(5) then
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0(5) <= 0;
        slice0winner1_best_above_0(5) <= slice0window_sum_0(11);
      else
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0(5) <= slice0window_sum_0(10);
        slice0winner1_best_above_0(5) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(6) then
        slice0winner1_best_index_0_6 <= 12;
        slice0winner1_best_below_0(6) <= 0;
        slice0winner1_best_above_0(6) <= slice0window_sum_0(13);
      else
        slice0winner1_best_index_0_6 <= 13;
        slice0winner1_best_below_0(6) <= slice0window_sum_0(12);
        slice0winner1_best_above_0(6) <= 0;
      end if;
      if slice0winner1_best_index_0_is_less(7) then
        slice0winner1_best_index_0_7 <= 14;
        slice0winner1_best_below_0(7) <= 0;
        slice0winner1_best_above_0(7) <= slice0window_sum_0(15);
      else
        slice0winner1_best_index_0_7 <= 15;
        slice0winner1_best_below_0(7) <= slice0window_sum_0(14);
        slice0winner1_best_above_0(7) <= 0;
      end if;
      if slice0winner1_best_index_0_0_is_not_less then
        slice0winner1_best_below_0(0) <= slice0window_sum_0(0);
        slice0winner1_best_above_0(0) <= 0;
      else
        slice0winner1_best_below_0(0) <= 0;
        slice0winner1_best_above_0(0) <= slice0window_sum_0(1);
      end if;
      -- slice0winner2
      for i in 0 to 3 loop
        slice0winner2_best_index_0_is_not_less(i) := (slice0winner1_best_cost_0(2 * i) - slice0winner1_best_cost_0(2 *
          i + 1)) >= 0;
      end loop;
      for i in 19 to 22 loop
        if others_from_13(i) then
          slice0winner2_best_below_0_choice(i - 19) := slice0winner1_held_0(4 * i - 75);
        else
          slice0winner2_best_below_0_choice(i - 19) := slice0winner1_best_below_0(2 * i - 37);
        end if;
      end loop;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_choice(0) := slice0winner1_held_0(2);
      else
        slice0winner2_best_above_0_choice(0) := slice0winner1_best_above_0(0);
      end if;
      if is_set(slice0winner1_best_index_0_2, 2) and is_set(slice0winner1_best_index_0_2, 0) then
        slice0winner2_best_above_0_choice(1) := slice0winner1_held_0(6);
      else
        slice0winner2_best_above_0_choice(1) := slice0winner1_best_above_0(2);
      end if;
      if is_set(slice0winner1_best_index_0_4, 3) and is_set(slice0winner1_best_index_0_4, 0) then
        slice0winner2_best_above_0_choice(2) := slice0winner1_held_0(10);
      else
        slice0winner2_best_above_0_choice(2) := slice0winner1_best_above_0(4);
      end if;
      slice0winner2_best_above_0_3_value := is_set(slice0winner1_best_index_0_6, 2);
      if is_set(slice0winner1_best_index_0_6, 3) and slice0winner2_best_above_0_3_value and
        is_set(slice0winner1_best_index_0_6, 0) then
        slice0winner2_best_above_0_choice(3) := slice0winner1_held_0(14);
      else
        slice0winner2_best_above_0_choice(3) := slice0winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice0winner2_best_place_0(i) then
          slice0winner2_best_second_0_choice(i) := 16383;
        else
          slice0winner2_best_second_0_choice(i) := slice0winner1_best_late_cost_0(2 * i + 1);
        end if;
        if slice0winner2_best_at_end_0(i) then
          slice0winner2_best_second_0_choices(i, 2) := slice0winner1_best_but_first_0(2 * i + 1);
        else
          slice0winner2_best_second_0_choices(i, 2) := slice0winner2_best_second_0_choice(i);
        end if;
        if slice0winner2_best_place_0(i) then
          slice0winner2_best_second_0_choices(i, 3) := slice0winner1_best_late_cost_0(2 * i);
        else
          slice0winner2_best_second_0_choices(i, 3) := 16383;
        end if;
        if slice0winner2_best_at_start_0(i) then
          slice0winner2_best_second_0_choices(i, 4) := slice0winner1_best_but_last_0(2 * i);
        else
          slice0winner2_best_second_0_choices(i, 4) := slice0winner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice0winner2_best_first_0(1) <= slice0winner1_held_0(4);
      slice0winner2_best_first_0(2) <= slice0winner1_held_0(8);
      slice0winner2_best_first_0(3) <= slice0winner1_held_0(12);
      slice0winner2_best_last_0(0) <= slice0winner1_held_0(3);
      slice0winner2_best_last_0(1) <= slice0winner1_held_0(7);
      slice0winner2_best_last_0(2) <= slice0winner1_held_0(11);
      slice0winner2_best_last_0(3) <= slice0winner1_held_0(15);
      slice0winner2_best_place_0(0) <= slice0winner2_best_index_0_is_not_less(0);
      slice0winner2_best_place_0(1) <= slice0winner2_best_index_0_is_not_less(1);
      slice0winner2_best_place_0(2) <= slice0winner2_best_index_0_is_not_less(2);
      slice0winner2_best_place_0(3) <= slice0winner2_best_index_0_is_not_less(3);
      for i in 0 to 3 loop
        slice0winner2_best_at_start_0(i) <= others_from_13(i + 19) and slice0winner2_best_index_0_is_not_less(i);
      end loop;
      slice0winner2_best_at_end_0(0) <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0(0) -
        slice0winner1_best_cost_0(1)) < 0);
      slice0winner2_best_at_end_0(1) <= ((slice0winner1_best_cost_0(2) - slice0winner1_best_cost_0(3)) < 0) and
        is_set(slice0winner1_best_index_0_2, 2) and is_set(slice0winner1_best_index_0_2, 0);
      slice0winner2_best_at_end_0(2) <= ((slice0winner1_best_cost_0(4) - slice0winner1_best_cost_0(5)) < 0) and
        is_set(slice0winner1_best_index_0_4, 3) and is_set(slice0winner1_best_index_0_4, 0);
      slice0winner2_best_at_end_0(3) <= ((slice0winner1_best_cost_0(6) - slice0winner1_best_cost_0(7)) < 0) and
        is_set(slice0winner1_best_index_0_6, 3) and slice0winner2_best_above_0_3_value and
        is_set(slice0winner1_best_index_0_6, 0);
      slice0winner2_best_late_cost_0(0) <= slice0winner2_best_cost_0(0);
      slice0winner2_best_late_cost_0(1) <= slice0winner2_best_cost_0(1);
      slice0winner2_best_late_cost_0(2) <= slice0winner2_best_cost_0(2);
      slice0winner2_best_late_cost_0(3) <= slice0winner2_best_cost_0(3);
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      for i in 0 to 3 loop
        if (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i)) < 0 then
          slice0winner2_best_cost_0(i) <= slice0winner1_best_cost_0(2 * i + 1);
        else
          slice0winner2_best_cost_0(i) <= slice0winner1_best_cost_0(2 * i);
        end if;
      end loop;
      if slice0winner2_best_index_0_is_not_less(0) then
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0(0) <= slice0winner2_best_below_0_choice(0);
        slice0winner2_best_above_0(0) <= slice0winner1_best_above_0(1);
      else
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0(0) <= slice0winner1_best_below_0(0);
        slice0winner2_best_above_0(0) <= slice0winner2_best_above_0_choice(0);
      end if;
      if slice0winner2_best_index_0_is_not_less(1) then
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
        slice0winner2_best_below_0(1) <= slice0winner2_best_below_0_choice(1);
        slice0winner2_best_above_0(1) <= slice0winner1_best_above_0(3);
      else
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
        slice0winner2_best_below_0(1) <= slice0winner1_best_below_0(2);
        slice0winner2_best_above_0(1) <= slice0winner2_best_above_0_choice(1);
      end if;
      if slice0winner2_best_index_0_is_not_less(2) then
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
        slice0winner2_best_below_0(2) <= slice0winner2_best_below_0_choice(2);
        slice0winner2_best_above_0(2) <= slice0winner1_best_above_0(5);
      else
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
        slice0winner2_best_below_0(2) <= slice0winner1_best_below_0(4);
        slice0winner2_best_above_0(2) <= slice0winner2_best_above_0_choice(2);
      end if;
      if slice0winner2_best_index_0_is_not_less(3) then
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
        slice0winner2_best_below_0(3) <= slice0winner2_best_below_0_choice(3);
        slice0winner2_best_above_0(3) <= slice0winner1_best_above_0(7);
      else
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_6;
        slice0winner2_best_below_0(3) <= slice0winner1_best_below_0(6);
        slice0winner2_best_above_0(3) <= slice0winner2_best_above_0_choice(3);
      end if;
      for i in 0 to 3 loop
        if (slice0winner2_best_second_0_choices(i, 2) - slice0winner2_best_second_0_choices(i, 4)) < 0 then
          slice0winner2_best_second_0(i) <= slice0winner2_best_second_0_choices(i, 2);
        else
          slice0winner2_best_second_0(i) <= slice0winner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 1 to 3 loop
        if (slice0winner1_best_late_cost_0(2 * i + 1) - slice0winner1_best_but_first_0(2 * i)) < 0 then
          slice0winner2_best_but_first_0(i) <= slice0winner1_best_late_cost_0(2 * i + 1);
        else
          slice0winner2_best_but_first_0(i) <= slice0winner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice0winner1_best_but_last_0(2 * i + 1) - slice0winner1_best_late_cost_0(2 * i)) < 0 then
          slice0winner2_best_but_last_0(i) <= slice0winner1_best_but_last_0(2 * i + 1);
        else
          slice0winner2_best_but_last_0(i) <= slice0winner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      if slice0winner2_tag_valid then
        slice0winner2_tag_output_column <= slice3window_centre_output_column(5);
        slice0winner2_tag_start_of_frame <= slice3window_centre_start_of_frame_5;
        slice0winner2_tag_end_of_line <= slice3window_centre_end_of_line(5);
      end if;
      -- slice0winner3
      slice0winner3_best_index_0_is_not_less(0) := (slice0winner2_best_cost_0(0) - slice0winner2_best_cost_0(1)) >= 0;
      slice0winner3_best_index_0_is_not_less(1) := (slice0winner2_best_cost_0(2) - slice0winner2_best_cost_0(3)) >= 0;
      slice0winner3_best_below_0_is_equal(0) := slice0winner2_best_index_0_1 = 4;
      if slice0winner3_best_below_0_is_equal(0) then
        slice0winner3_best_below_0_choice(0) := slice0winner2_best_last_0(0);
      else
        slice0winner3_best_below_0_choice(0) := slice0winner2_best_below_0(1);
      end if;
      slice0winner3_best_below_0_is_equal(1) := slice0winner2_best_index_0_3 = 12;
      if slice0winner3_best_below_0_is_equal(1) then
        slice0winner3_best_below_0_choice(1) := slice0winner2_best_last_0(2);
      else
        slice0winner3_best_below_0_choice(1) := slice0winner2_best_below_0(3);
      end if;
      slice0winner3_best_above_0_is_equal(0) := slice0winner2_best_index_0_0 = 3;
      if slice0winner3_best_above_0_is_equal(0) then
        slice0winner3_best_above_0_choice(0) := slice0winner2_best_first_0(1);
      else
        slice0winner3_best_above_0_choice(0) := slice0winner2_best_above_0(0);
      end if;
      slice0winner3_best_above_0_is_equal(1) := (slice0winner2_best_index_0_2 mod 4) = 3;
      if is_set(slice0winner2_best_index_0_2, 3) and slice0winner3_best_above_0_is_equal(1) then
        slice0winner3_best_above_0_choice(1) := slice0winner2_best_first_0(3);
      else
        slice0winner3_best_above_0_choice(1) := slice0winner2_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if slice0winner3_best_place_0(i) then
          slice0winner3_best_second_0_choice(i) := slice0winner2_best_second_0(2 * i + 1);
        else
          slice0winner3_best_second_0_choice(i) := slice0winner2_best_late_cost_0(2 * i + 1);
        end if;
        if slice0winner3_best_at_end_0(i) then
          slice0winner3_best_second_0_choices(i, 2) := slice0winner2_best_but_first_0(2 * i + 1);
        else
          slice0winner3_best_second_0_choices(i, 2) := slice0winner3_best_second_0_choice(i);
        end if;
        if slice0winner3_best_place_0(i) then
          slice0winner3_best_second_0_choices(i, 3) := slice0winner2_best_late_cost_0(2 * i);
        else
          slice0winner3_best_second_0_choices(i, 3) := slice0winner2_best_second_0(2 * i);
        end if;
        if slice0winner3_best_at_start_0(i) then
          slice0winner3_best_second_0_choices(i, 4) := slice0winner2_best_but_last_0(2 * i);
        else
          slice0winner3_best_second_0_choices(i, 4) := slice0winner3_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice0winner3_best_first_0_1 <= slice0winner2_best_first_0(2);
      slice0winner3_best_last_0(0) <= slice0winner2_best_last_0(1);
      slice0winner3_best_last_0(1) <= slice0winner2_best_last_0(3);
      slice0winner3_best_place_0(0) <= slice0winner3_best_index_0_is_not_less(0);
      slice0winner3_best_place_0(1) <= slice0winner3_best_index_0_is_not_less(1);
      slice0winner3_best_at_start_0(0) <= slice0winner3_best_index_0_is_not_less(0) and
        slice0winner3_best_below_0_is_equal(0);
      slice0winner3_best_at_start_0(1) <= slice0winner3_best_below_0_is_equal(1) and
        slice0winner3_best_index_0_is_not_less(1);
      slice0winner3_best_at_end_0(0) <= ((slice0winner2_best_cost_0(0) - slice0winner2_best_cost_0(1)) < 0) and
        slice0winner3_best_above_0_is_equal(0);
      slice0winner3_best_at_end_0(1) <= ((slice0winner2_best_cost_0(2) - slice0winner2_best_cost_0(3)) < 0) and
        is_set(slice0winner2_best_index_0_2, 3) and slice0winner3_best_above_0_is_equal(1);
      slice0winner3_best_late_cost_0(0) <= slice0winner3_best_cost_0(0);
      slice0winner3_best_late_cost_0(1) <= slice0winner3_best_cost_0(1);
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      for i in 0 to 1 loop
        if (slice0winner2_best_cost_0(2 * i + 1) - slice0winner2_best_cost_0(2 * i)) < 0 then
          slice0winner3_best_cost_0(i) <= slice0winner2_best_cost_0(2 * i + 1);
        else
          slice0winner3_best_cost_0(i) <= slice0winner2_best_cost_0(2 * i);
        end if;
      end loop;
      if slice0winner3_best_index_0_is_not_less(0) then
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0(0) <= slice0winner3_best_below_0_choice(0);
        slice0winner3_best_above_0(0) <= slice0winner2_best_above_0(1);
      else
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0(0) <= slice0winner2_best_below_0(0);
        slice0winner3_best_above_0(0) <= slice0winner3_best_above_0_choice(0);
      end if;
      if slice0winner3_best_index_0_is_not_less(1) then
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
        slice0winner3_best_below_0(1) <= slice0winner3_best_below_0_choice(1);
        slice0winner3_best_above_0(1) <= slice0winner2_best_above_0(3);
      else
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
        slice0winner3_best_below_0(1) <= slice0winner2_best_below_0(2);
        slice0winner3_best_above_0(1) <= slice0winner3_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (slice0winner3_best_second_0_choices(i, 2) - slice0winner3_best_second_0_choices(i, 4)) < 0 then
          slice0winner3_best_second_0(i) <= slice0winner3_best_second_0_choices(i, 2);
        else
          slice0winner3_best_second_0(i) <= slice0winner3_best_second_0_choices(i, 4);
        end if;
      end loop;
      if (slice0winner2_best_late_cost_0(3) - slice0winner2_best_but_first_0(2)) < 0 then
        slice0winner3_best_but_first_0_1 <= slice0winner2_best_late_cost_0(3);
      else
        slice0winner3_best_but_first_0_1 <= slice0winner2_best_but_first_0(2);
      end if;
      for i in 0 to 1 loop
        if (slice0winner2_best_but_last_0(2 * i + 1) - slice0winner2_best_late_cost_0(2 * i)) < 0 then
          slice0winner3_best_but_last_0(i) <= slice0winner2_best_but_last_0(2 * i + 1);
        else
          slice0winner3_best_but_last_0(i) <= slice0winner2_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice0winner4
      slice0winner4_best_index_0_0_is_less := (slice0winner3_best_cost_0(0) - slice0winner3_best_cost_0(1)) < 0;
      slice0winner4_best_below_0_0_is_equal := slice0winner3_best_index_0_1 = 8;
      if slice0winner4_best_below_0_0_is_equal then
        slice0winner4_best_below_0_0_choice := slice0winner3_best_last_0(0);
      else
        slice0winner4_best_below_0_0_choice := slice0winner3_best_below_0(1);
      end if;
      slice0winner4_best_above_0_0_is_equal := slice0winner3_best_index_0_0 = 7;
      if slice0winner4_best_above_0_0_is_equal then
        slice0winner4_best_above_0_0_choice := slice0winner3_best_first_0_1;
      else
        slice0winner4_best_above_0_0_choice := slice0winner3_best_above_0(0);
      end if;
      slice0winner4_best_place_0_0_is_not_less := (slice0winner3_best_cost_0(0) - slice0winner3_best_cost_0(1)) >= 0;
      if slice0winner4_best_place_0_0 then
        slice0winner4_best_second_0_0_choice := slice0winner3_best_second_0(1);
      else
        slice0winner4_best_second_0_0_choice := slice0winner3_best_late_cost_0(1);
      end if;
      if slice0winner4_best_at_end_0_0 then
        slice0winner4_best_second_0_0_choices(2) := slice0winner3_best_but_first_0_1;
      else
        slice0winner4_best_second_0_0_choices(2) := slice0winner4_best_second_0_0_choice;
      end if;
      if slice0winner4_best_place_0_0 then
        slice0winner4_best_second_0_0_choices(3) := slice0winner3_best_late_cost_0(0);
      else
        slice0winner4_best_second_0_0_choices(3) := slice0winner3_best_second_0(0);
      end if;
      if slice0winner4_best_at_start_0_0 then
        slice0winner4_best_second_0_0_choices(4) := slice0winner3_best_but_last_0(0);
      else
        slice0winner4_best_second_0_0_choices(4) := slice0winner4_best_second_0_0_choices(3);
      end if;
      slice0winner4_best_last_0_0 <= slice0winner3_best_last_0(1);
      slice0winner4_best_place_0_0 <= slice0winner4_best_place_0_0_is_not_less;
      slice0winner4_best_at_start_0_0 <= slice0winner4_best_below_0_0_is_equal and
        slice0winner4_best_place_0_0_is_not_less;
      slice0winner4_best_at_end_0_0 <= slice0winner4_best_index_0_0_is_less and slice0winner4_best_above_0_0_is_equal;
      slice0winner4_best_late_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_output_column <= slice0winner3_tag_output_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0 then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0(1);
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0(0);
      end if;
      if slice0winner4_best_index_0_0_is_less then
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
        slice0winner4_best_below_0_0 <= slice0winner3_best_below_0(0);
        slice0winner4_best_above_0_0 <= slice0winner4_best_above_0_0_choice;
      else
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
        slice0winner4_best_below_0_0 <= slice0winner4_best_below_0_0_choice;
        slice0winner4_best_above_0_0 <= slice0winner3_best_above_0(1);
      end if;
      if (slice0winner4_best_second_0_0_choices(2) - slice0winner4_best_second_0_0_choices(4)) < 0 then
        slice0winner4_best_second_0_0 <= slice0winner4_best_second_0_0_choices(2);
      else
        slice0winner4_best_second_0_0 <= slice0winner4_best_second_0_0_choices(4);
      end if;
      if (slice0winner3_best_but_last_0(1) - slice0winner3_best_late_cost_0(0)) < 0 then
        slice0winner4_best_but_last_0_0 <= slice0winner3_best_but_last_0(1);
      else
        slice0winner4_best_but_last_0_0 <= slice0winner3_best_late_cost_0(0);
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
        for i in 0 to 1 loop
          slice1shift_search(i, 0) <= slice0shift_search_out(i);
          for j in 1 to 15 loop
            slice1shift_search(i, j) <= slice1shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice1shift_reference(0) <= slice0shift_reference(0);
      slice1shift_reference(1) <= slice0shift_reference(1);
      slice1shift_search_out(0) <= slice1shift_search(0, 15);
      slice1shift_search_out(1) <= slice1shift_search(1, 15);
      -- slice1cost
      for i in 0 to 4 loop
        if slice0cost_tag_first_group then
          slice1cost_column_0_choice(3 * i) := 0;
        else
          slice1cost_column_0_choice(3 * i) := slice1cost_ready_words(i) mod 1024;
        end if;
        if slice0cost_tag_border_column then
          slice1cost_column_0_choice_2(3 * i) := 0;
        else
          slice1cost_column_0_choice_2(3 * i) := (slice1cost_change_0(3 * i) + slice1cost_column_0_choice(3 * i)) mod
            1024;
        end if;
        if slice0cost_tag_first_group then
          slice1cost_column_0_choice(3 * i + 1) := 0;
        else
          slice1cost_column_0_choice(3 * i + 1) := (slice1cost_ready_words(i) / 1024) mod 1024;
        end if;
        if slice0cost_tag_border_column then
          slice1cost_column_0_choice_2(3 * i + 1) := 0;
        else
          slice1cost_column_0_choice_2(3 * i + 1) := (slice1cost_change_0(3 * i + 1) + slice1cost_column_0_choice(3 * i
            + 1)) mod 1024;
        end if;
        if slice0cost_tag_first_group then
          slice1cost_column_0_choice(3 * i + 2) := 0;
        else
          slice1cost_column_0_choice(3 * i + 2) := slice1cost_ready_words(i) / 1048576;
        end if;
        if slice0cost_tag_border_column then
          slice1cost_column_0_choice_2(3 * i + 2) := 0;
        else
          slice1cost_column_0_choice_2(3 * i + 2) := (slice1cost_change_0(3 * i + 2) + slice1cost_column_0_choice(3 * i
            + 2)) mod 1024;
        end if;
      end loop;
      if slice0cost_tag_first_group then
        slice1cost_column_0_choice(15) := 0;
      else
        slice1cost_column_0_choice(15) := slice1cost_ready_words_5;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_choice_2(15) := 0;
      else
        slice1cost_column_0_choice_2(15) := (slice1cost_change_0(15) + slice1cost_column_0_choice(15)) mod 1024;
      end if;
      for i in 0 to 15 loop
        slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
      end loop;
      for i in 0 to 15 loop
        slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice1cost_pixels_cost(i, j) <= folded(slice1cost_pixels_first(i, j)) + as_number((slice1cost_pixels_first(i,
            j) < 0));
        end loop;
      end loop;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice1cost_read_column;
      for i in 0 to 15 loop
        slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 4 loop
        slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i));
      end loop;
      slice1cost_ready_words_5 <= to_integer(slice1cost_read_words_5);
      for i in 0 to 15 loop
        slice1cost_column_0(i) <= slice1cost_column_0_choice_2(i);
      end loop;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        for i in 0 to 4 loop
          slice1cost_write_words(i) <= (slice1cost_column_0_choice_2(3 * i + 1) * 1024) +
            slice1cost_column_0_choice_2(3 * i) + (slice1cost_column_0_choice_2(3 * i + 2) * 1048576);
        end loop;
        slice1cost_write_words_5 <= slice1cost_column_0_choice_2(15);
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
      for i in 0 to 1 loop
        for j in 0 to 2 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(6 * i + j) := to_integer(slice1window_leaving(2 * i)(10 * j + 9 downto 10 *
              j));
          else
            slice1window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
        for j in 3 to 5 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(6 * i + j) := to_integer(slice1window_leaving(2 * i + 1)(10 * j - 21 downto 10
              * j - 30));
          else
            slice1window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 12 to 14 loop
        if slice0window_change_tag_leaves_window then
          slice1window_change_0_choice(i) := to_integer(slice1window_leaving(4)(10 * i - 111 downto 10 * i - 120));
        else
          slice1window_change_0_choice(i) := 0;
        end if;
      end loop;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_choice(15) := to_integer(slice1window_leaving_5);
      else
        slice1window_change_0_choice(15) := 0;
      end if;
      for i in 0 to 15 loop
        slice1window_entering_0(i) <= slice1cost_column_0(i);
      end loop;
      for i in 0 to 15 loop
        slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
      end loop;
      slice1window_change_tag_first_cost <= slice0window_change_tag_first_cost;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
      slice1window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame(1);
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      for i in 0 to 15 loop
        if slice1window_change_tag_first_cost then
          slice1window_sum_0_choice(i) := 0;
        else
          slice1window_sum_0_choice(i) := slice1window_sum_0(i);
        end if;
      end loop;
      if slice0window_tag_valid then
        for i in 0 to 15 loop
          slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
        end loop;
      end if;
      if slice0winner2_tag_valid then
        slice1window_centre_start_of_frame(3) <= slice3window_centre_start_of_frame_1;
        slice1window_centre_start_of_frame(4) <= slice1window_centre_start_of_frame(3);
        slice1window_centre_start_of_frame(5) <= slice1window_centre_start_of_frame(4);
      end if;
      -- slice1winner1
      slice1winner1_best_index_0_0_is_not_less := (slice1window_sum_0(0) - slice1window_sum_0(1)) >= 0;
      for i in 1 to 7 loop
        slice1winner1_best_index_0_is_less(i) := (slice1window_sum_0(2 * i) - slice1window_sum_0(2 * i + 1)) < 0;
      end loop;
      for i in 0 to 15 loop
        slice1winner1_held_0(i) <= slice1window_sum_0(i);
      end loop;
      slice1winner1_best_index_0_0 <= slice1winner1_best_index_0_0_is_not_less;
      for i in 0 to 7 loop
        slice1winner1_best_late_cost_0(i) <= slice1winner1_best_cost_0(i);
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_but_first_0(i) <= slice1winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_but_last_0(i) <= slice1winner1_held_0(2 * i);
      end loop;
      for i in 0 to 7 loop
        if (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0 then
          slice1winner1_best_cost_0(i) <= slice1window_sum_0(2 * i + 1);
        else
          slice1winner1_best_cost_0(i) <= slice1window_sum_0(2 * i);
        end if;
      end loop;
      if slice1winner1_best_index_0_is_less(1) then
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0(1) <= 0;
        slice1winner1_best_above_0(1) <= slice1window_sum_0(3);
      else
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0(1) <= slice1window_sum_0(2);
        slice1winner1_best_above_0(1) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(2) then
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0(2) <= 0;
        slice1winner1_best_above_0(2) <= slice1window_sum_0(5);
      else
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0(2) <= slice1window_sum_0(4);
        slice1winner1_best_above_0(2) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(3) then
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0(3) <= 0;
        slice1winner1_best_above_0(3) <= slice1window_sum_0(7);
      else
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0(3) <= slice1window_sum_0(6);
        slice1winner1_best_above_0(3) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(4) then
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0(4) <= 0;
        slice1winner1_best_above_0(4) <= slice1window_sum_0(9);
      else
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0(4) <= slice1window_sum_0(8);
        slice1winner1_best_above_0(4) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(5) then
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0(5) <= 0;
        slice1winner1_best_above_0(5) <= slice1window_sum_0(11);
      else
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0(5) <= slice1window_sum_0(10);
        slice1winner1_best_above_0(5) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(6) then
        slice1winner1_best_index_0_6 <= 12;
        slice1winner1_best_below_0(6) <= 0;
        slice1winner1_best_above_0(6) <= slice1window_sum_0(13);
      else
        slice1winner1_best_index_0_6 <= 13;
        slice1winner1_best_below_0(6) <= slice1window_sum_0(12);
        slice1winner1_best_above_0(6) <= 0;
      end if;
      if slice1winner1_best_index_0_is_less(7) then
        slice1winner1_best_index_0_7 <= 14;
        slice1winner1_best_below_0(7) <= 0;
        slice1winner1_best_above_0(7) <= slice1window_sum_0(15);
      else
        slice1winner1_best_index_0_7 <= 15;
        slice1winner1_best_below_0(7) <= slice1window_sum_0(14);
        slice1winner1_best_above_0(7) <= 0;
      end if;
      if slice1winner1_best_index_0_0_is_not_less then
        slice1winner1_best_below_0(0) <= slice1window_sum_0(0);
        slice1winner1_best_above_0(0) <= 0;
      else
        slice1winner1_best_below_0(0) <= 0;
        slice1winner1_best_above_0(0) <= slice1window_sum_0(1);
      end if;
      -- slice1winner2
      for i in 0 to 3 loop
        slice1winner2_best_index_0_is_not_less(i) := (slice1winner1_best_cost_0(2 * i) - slice1winner1_best_cost_0(2 *
          i + 1)) >= 0;
      end loop;
      for i in 15 to 18 loop
        if others_from_13(i) then
          slice1winner2_best_below_0_choice(i - 15) := slice1winner1_held_0(4 * i - 59);
        else
          slice1winner2_best_below_0_choice(i - 15) := slice1winner1_best_below_0(2 * i - 29);
        end if;
      end loop;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_choice(0) := slice1winner1_held_0(2);
      else
        slice1winner2_best_above_0_choice(0) := slice1winner1_best_above_0(0);
      end if;
      if is_set(slice1winner1_best_index_0_2, 2) and is_set(slice1winner1_best_index_0_2, 0) then
        slice1winner2_best_above_0_choice(1) := slice1winner1_held_0(6);
      else
        slice1winner2_best_above_0_choice(1) := slice1winner1_best_above_0(2);
      end if;
      if is_set(slice1winner1_best_index_0_4, 3) and is_set(slice1winner1_best_index_0_4, 0) then
        slice1winner2_best_above_0_choice(2) := slice1winner1_held_0(10);
      else
        slice1winner2_best_above_0_choice(2) := slice1winner1_best_above_0(4);
      end if;
      slice1winner2_best_above_0_3_value := is_set(slice1winner1_best_index_0_6, 2);
      if is_set(slice1winner1_best_index_0_6, 3) and slice1winner2_best_above_0_3_value and
        is_set(slice1winner1_best_index_0_6, 0) then
        slice1winner2_best_above_0_choice(3) := slice1winner1_held_0(14);
      else
        slice1winner2_best_above_0_choice(3) := slice1winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice1winner2_best_place_0(i) then
          slice1winner2_best_second_0_choice(i) := 16383;
        else
          slice1winner2_best_second_0_choice(i) := slice1winner1_best_late_cost_0(2 * i + 1);
        end if;
        if slice1winner2_best_at_end_0(i) then
          slice1winner2_best_second_0_choices(i, 2) := slice1winner1_best_but_first_0(2 * i + 1);
        else
          slice1winner2_best_second_0_choices(i, 2) := slice1winner2_best_second_0_choice(i);
        end if;
        if slice1winner2_best_place_0(i) then
          slice1winner2_best_second_0_choices(i, 3) := slice1winner1_best_late_cost_0(2 * i);
        else
          slice1winner2_best_second_0_choices(i, 3) := 16383;
        end if;
        if slice1winner2_best_at_start_0(i) then
          slice1winner2_best_second_0_choices(i, 4) := slice1winner1_best_but_last_0(2 * i);
        else
          slice1winner2_best_second_0_choices(i, 4) := slice1winner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice1winner2_best_first_0(0) <= slice1winner1_held_0(0);
      slice1winner2_best_first_0(1) <= slice1winner1_held_0(4);
      slice1winner2_best_first_0(2) <= slice1winner1_held_0(8);
      slice1winner2_best_first_0(3) <= slice1winner1_held_0(12);
      slice1winner2_best_last_0(0) <= slice1winner1_held_0(3);
      slice1winner2_best_last_0(1) <= slice1winner1_held_0(7);
      slice1winner2_best_last_0(2) <= slice1winner1_held_0(11);
      slice1winner2_best_last_0(3) <= slice1winner1_held_0(15);
      slice1winner2_best_place_0(0) <= slice1winner2_best_index_0_is_not_less(0);
      slice1winner2_best_place_0(1) <= slice1winner2_best_index_0_is_not_less(1);
      slice1winner2_best_place_0(2) <= slice1winner2_best_index_0_is_not_less(2);
      slice1winner2_best_place_0(3) <= slice1winner2_best_index_0_is_not_less(3);
      for i in 0 to 3 loop
        slice1winner2_best_at_start_0(i) <= others_from_13(i + 15) and slice1winner2_best_index_0_is_not_less(i);
      end loop;
      slice1winner2_best_at_end_0(0) <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0(0) -
        slice1winner1_best_cost_0(1)) < 0);
      slice1winner2_best_at_end_0(1) <= ((slice1winner1_best_cost_0(2) - slice1winner1_best_cost_0(3)) < 0) and
        is_set(slice1winner1_best_index_0_2, 2) and is_set(slice1winner1_best_index_0_2, 0);
      slice1winner2_best_at_end_0(2) <= ((slice1winner1_best_cost_0(4) - slice1winner1_best_cost_0(5)) < 0) and
        is_set(slice1winner1_best_index_0_4, 3) and is_set(slice1winner1_best_index_0_4, 0);
      slice1winner2_best_at_end_0(3) <= ((slice1winner1_best_cost_0(6) - slice1winner1_best_cost_0(7)) < 0) and
        is_set(slice1winner1_best_index_0_6, 3) and slice1winner2_best_above_0_3_value and
        is_set(slice1winner1_best_index_0_6, 0);
      slice1winner2_best_late_cost_0(0) <= slice1winner2_best_cost_0(0);
      slice1winner2_best_late_cost_0(1) <= slice1winner2_best_cost_0(1);
      slice1winner2_best_late_cost_0(2) <= slice1winner2_best_cost_0(2);
      slice1winner2_best_late_cost_0(3) <= slice1winner2_best_cost_0(3);
      for i in 0 to 3 loop
        if (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i)) < 0 then
          slice1winner2_best_cost_0(i) <= slice1winner1_best_cost_0(2 * i + 1);
        else
          slice1winner2_best_cost_0(i) <= slice1winner1_best_cost_0(2 * i);
        end if;
      end loop;
      if slice1winner2_best_index_0_is_not_less(0) then
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
        slice1winner2_best_below_0(0) <= slice1winner2_best_below_0_choice(0);
        slice1winner2_best_above_0(0) <= slice1winner1_best_above_0(1);
      else
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0(0) <= slice1winner1_best_below_0(0);
        slice1winner2_best_above_0(0) <= slice1winner2_best_above_0_choice(0);
      end if;
      if slice1winner2_best_index_0_is_not_less(1) then
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
        slice1winner2_best_below_0(1) <= slice1winner2_best_below_0_choice(1);
        slice1winner2_best_above_0(1) <= slice1winner1_best_above_0(3);
      else
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
        slice1winner2_best_below_0(1) <= slice1winner1_best_below_0(2);
        slice1winner2_best_above_0(1) <= slice1winner2_best_above_0_choice(1);
      end if;
      if slice1winner2_best_index_0_is_not_less(2) then
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
        slice1winner2_best_below_0(2) <= slice1winner2_best_below_0_choice(2);
        slice1winner2_best_above_0(2) <= slice1winner1_best_above_0(5);
      else
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
        slice1winner2_best_below_0(2) <= slice1winner1_best_below_0(4);
        slice1winner2_best_above_0(2) <= slice1winner2_best_above_0_choice(2);
      end if;
      if slice1winner2_best_index_0_is_not_less(3) then
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
        slice1winner2_best_below_0(3) <= slice1winner2_best_below_0_choice(3);
        slice1winner2_best_above_0(3) <= slice1winner1_best_above_0(7);
      else
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_6;
        slice1winner2_best_below_0(3) <= slice1winner1_best_below_0(6);
        slice1winner2_best_above_0(3) <= slice1winner2_best_above_0_choice(3);
      end if;
      for i in 0 to 3 loop
        if (slice1winner2_best_second_0_choices(i, 2) - slice1winner2_best_second_0_choices(i, 4)) < 0 then
          slice1winner2_best_second_0(i) <= slice1winner2_best_second_0_choices(i, 2);
        else
          slice1winner2_best_second_0(i) <= slice1winner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice1winner1_best_late_cost_0(2 * i + 1) - slice1winner1_best_but_first_0(2 * i)) < 0 then
          slice1winner2_best_but_first_0(i) <= slice1winner1_best_late_cost_0(2 * i + 1);
        else
          slice1winner2_best_but_first_0(i) <= slice1winner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice1winner1_best_but_last_0(2 * i + 1) - slice1winner1_best_late_cost_0(2 * i)) < 0 then
          slice1winner2_best_but_last_0(i) <= slice1winner1_best_but_last_0(2 * i + 1);
        else
          slice1winner2_best_but_last_0(i) <= slice1winner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice1winner3
      slice1winner3_best_index_0_is_not_less(0) := (slice1winner2_best_cost_0(0) - slice1winner2_best_cost_0(1)) >= 0;
      slice1winner3_best_index_0_is_not_less(1) := (slice1winner2_best_cost_0(2) - slice1winner2_best_cost_0(3)) >= 0;
      slice1winner3_best_below_0_is_equal(0) := slice1winner2_best_index_0_1 = 4;
      if slice1winner3_best_below_0_is_equal(0) then
        slice1winner3_best_below_0_choice(0) := slice1winner2_best_last_0(0);
      else
        slice1winner3_best_below_0_choice(0) := slice1winner2_best_below_0(1);
      end if;
      slice1winner3_best_below_0_is_equal(1) := slice1winner2_best_index_0_3 = 12;
      if slice1winner3_best_below_0_is_equal(1) then
        slice1winner3_best_below_0_choice(1) := slice1winner2_best_last_0(2);
      else
        slice1winner3_best_below_0_choice(1) := slice1winner2_best_below_0(3);
      end if;
      slice1winner3_best_above_0_is_equal(0) := slice1winner2_best_index_0_0 = 3;
      if slice1winner3_best_above_0_is_equal(0) then
        slice1winner3_best_above_0_choice(0) := slice1winner2_best_first_0(1);
      else
        slice1winner3_best_above_0_choice(0) := slice1winner2_best_above_0(0);
      end if;
      slice1winner3_best_above_0_is_equal(1) := (slice1winner2_best_index_0_2 mod 4) = 3;
      if is_set(slice1winner2_best_index_0_2, 3) and slice1winner3_best_above_0_is_equal(1) then
        slice1winner3_best_above_0_choice(1) := slice1winner2_best_first_0(3);
      else
        slice1winner3_best_above_0_choice(1) := slice1winner2_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if slice1winner3_best_place_0(i) then
          slice1winner3_best_second_0_choice(i) := slice1winner2_best_second_0(2 * i + 1);
        else
          slice1winner3_best_second_0_choice(i) := slice1winner2_best_late_cost_0(2 * i + 1);
        end if;
        if slice1winner3_best_at_end_0(i) then
          slice1winner3_best_second_0_choices(i, 2) := slice1winner2_best_but_first_0(2 * i + 1);
        else
          slice1winner3_best_second_0_choices(i, 2) := slice1winner3_best_second_0_choice(i);
        end if;
        if slice1winner3_best_place_0(i) then
          slice1winner3_best_second_0_choices(i, 3) := slice1winner2_best_late_cost_0(2 * i);
        else
          slice1winner3_best_second_0_choices(i, 3) := slice1winner2_best_second_0(2 * i);
        end if;
        if slice1winner3_best_at_start_0(i) then
          slice1winner3_best_second_0_choices(i, 4) := slice1winner2_best_but_last_0(2 * i);
        else
          slice1winner3_best_second_0_choices(i, 4) := slice1winner3_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice1winner3_best_first_0(0) <= slice1winner2_best_first_0(0);
      slice1winner3_best_first_0(1) <= slice1winner2_best_first_0(2);
      slice1winner3_best_last_0(0) <= slice1winner2_best_last_0(1);
      slice1winner3_best_last_0(1) <= slice1winner2_best_last_0(3);
      slice1winner3_best_place_0(0) <= slice1winner3_best_index_0_is_not_less(0);
      slice1winner3_best_place_0(1) <= slice1winner3_best_index_0_is_not_less(1);
      slice1winner3_best_at_start_0(0) <= slice1winner3_best_index_0_is_not_less(0) and
        slice1winner3_best_below_0_is_equal(0);
      slice1winner3_best_at_start_0(1) <= slice1winner3_best_below_0_is_equal(1) and
        slice1winner3_best_index_0_is_not_less(1);
      slice1winner3_best_at_end_0(0) <= ((slice1winner2_best_cost_0(0) - slice1winner2_best_cost_0(1)) < 0) and
        slice1winner3_best_above_0_is_equal(0);
      slice1winner3_best_at_end_0(1) <= ((slice1winner2_best_cost_0(2) - slice1winner2_best_cost_0(3)) < 0) and
        is_set(slice1winner2_best_index_0_2, 3) and slice1winner3_best_above_0_is_equal(1);
      slice1winner3_best_late_cost_0(0) <= slice1winner3_best_cost_0(0);
      slice1winner3_best_late_cost_0(1) <= slice1winner3_best_cost_0(1);
      for i in 0 to 1 loop
        if (slice1winner2_best_cost_0(2 * i + 1) - slice1winner2_best_cost_0(2 * i)) < 0 then
          slice1winner3_best_cost_0(i) <= slice1winner2_best_cost_0(2 * i + 1);
        else
          slice1winner3_best_cost_0(i) <= slice1winner2_best_cost_0(2 * i);
        end if;
      end loop;
      if slice1winner3_best_index_0_is_not_less(0) then
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0(0) <= slice1winner3_best_below_0_choice(0);
        slice1winner3_best_above_0(0) <= slice1winner2_best_above_0(1);
      else
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0(0) <= slice1winner2_best_below_0(0);
        slice1winner3_best_above_0(0) <= slice1winner3_best_above_0_choice(0);
      end if;
      if slice1winner3_best_index_0_is_not_less(1) then
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
        slice1winner3_best_below_0(1) <= slice1winner3_best_below_0_choice(1);
        slice1winner3_best_above_0(1) <= slice1winner2_best_above_0(3);
      else
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
        slice1winner3_best_below_0(1) <= slice1winner2_best_below_0(2);
        slice1winner3_best_above_0(1) <= slice1winner3_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (slice1winner3_best_second_0_choices(i, 2) - slice1winner3_best_second_0_choices(i, 4)) < 0 then
          slice1winner3_best_second_0(i) <= slice1winner3_best_second_0_choices(i, 2);
        else
          slice1winner3_best_second_0(i) <= slice1winner3_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (slice1winner2_best_late_cost_0(2 * i + 1) - slice1winner2_best_but_first_0(2 * i)) < 0 then
          slice1winner3_best_but_first_0(i) <= slice1winner2_best_late_cost_0(2 * i + 1);
        else
          slice1winner3_best_but_first_0(i) <= slice1winner2_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (slice1winner2_best_but_last_0(2 * i + 1) - slice1winner2_best_late_cost_0(2 * i)) < 0 then
          slice1winner3_best_but_last_0(i) <= slice1winner2_best_but_last_0(2 * i + 1);
        else
          slice1winner3_best_but_last_0(i) <= slice1winner2_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice1winner4
      slice1winner4_best_index_0_0_is_less := (slice1winner3_best_cost_0(0) - slice1winner3_best_cost_0(1)) < 0;
      slice1winner4_best_below_0_0_is_equal := slice1winner3_best_index_0_1 = 8;
      if slice1winner4_best_below_0_0_is_equal then
        slice1winner4_best_below_0_0_choice := slice1winner3_best_last_0(0);
      else
        slice1winner4_best_below_0_0_choice := slice1winner3_best_below_0(1);
      end if;
      slice1winner4_best_above_0_0_is_equal := slice1winner3_best_index_0_0 = 7;
      if slice1winner4_best_above_0_0_is_equal then
        slice1winner4_best_above_0_0_choice := slice1winner3_best_first_0(1);
      else
        slice1winner4_best_above_0_0_choice := slice1winner3_best_above_0(0);
      end if;
      slice1winner4_best_place_0_0_is_not_less := (slice1winner3_best_cost_0(0) - slice1winner3_best_cost_0(1)) >= 0;
      if slice1winner4_best_place_0_0 then
        slice1winner4_best_second_0_0_choice := slice1winner3_best_second_0(1);
      else
        slice1winner4_best_second_0_0_choice := slice1winner3_best_late_cost_0(1);
      end if;
      if slice1winner4_best_at_end_0_0 then
        slice1winner4_best_second_0_0_choices(2) := slice1winner3_best_but_first_0(1);
      else
        slice1winner4_best_second_0_0_choices(2) := slice1winner4_best_second_0_0_choice;
      end if;
      if slice1winner4_best_place_0_0 then
        slice1winner4_best_second_0_0_choices(3) := slice1winner3_best_late_cost_0(0);
      else
        slice1winner4_best_second_0_0_choices(3) := slice1winner3_best_second_0(0);
      end if;
      if slice1winner4_best_at_start_0_0 then
        slice1winner4_best_second_0_0_choices(4) := slice1winner3_best_but_last_0(0);
      else
        slice1winner4_best_second_0_0_choices(4) := slice1winner4_best_second_0_0_choices(3);
      end if;
      slice1winner4_best_first_0_0 <= slice1winner3_best_first_0(0);
      slice1winner4_best_last_0_0 <= slice1winner3_best_last_0(1);
      slice1winner4_best_place_0_0 <= slice1winner4_best_place_0_0_is_not_less;
      slice1winner4_best_at_start_0_0 <= slice1winner4_best_below_0_0_is_equal and
        slice1winner4_best_place_0_0_is_not_less;
      slice1winner4_best_at_end_0_0 <= slice1winner4_best_index_0_0_is_less and slice1winner4_best_above_0_0_is_equal;
      slice1winner4_best_late_cost_0_0 <= slice1winner4_best_cost_0_0;
      if (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0 then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(1);
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(0);
      end if;
      if slice1winner4_best_index_0_0_is_less then
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1winner4_best_below_0_0 <= slice1winner3_best_below_0(0);
        slice1winner4_best_above_0_0 <= slice1winner4_best_above_0_0_choice;
      else
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
        slice1winner4_best_below_0_0 <= slice1winner4_best_below_0_0_choice;
        slice1winner4_best_above_0_0 <= slice1winner3_best_above_0(1);
      end if;
      if (slice1winner4_best_second_0_0_choices(2) - slice1winner4_best_second_0_0_choices(4)) < 0 then
        slice1winner4_best_second_0_0 <= slice1winner4_best_second_0_0_choices(2);
      else
        slice1winner4_best_second_0_0 <= slice1winner4_best_second_0_0_choices(4);
      end if;
      if (slice1winner3_best_late_cost_0(1) - slice1winner3_best_but_first_0(0)) < 0 then
        slice1winner4_best_but_first_0_0 <= slice1winner3_best_late_cost_0(1);
      else
        slice1winner4_best_but_first_0_0 <= slice1winner3_best_but_first_0(0);
      end if;
      if (slice1winner3_best_but_last_0(1) - slice1winner3_best_late_cost_0(0)) < 0 then
        slice1winner4_best_but_last_0_0 <= slice1winner3_best_but_last_0(1);
      else
        slice1winner4_best_but_last_0_0 <= slice1winner3_best_late_cost_0(0);
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
        slice1_best_second_0_0_choices(2) := slice1winner4_best_but_first_0_0;
      else
        slice1_best_second_0_0_choices(2) := slice1_best_second_0_0_choice;
      end if;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choices(3) := slice0_best_late_cost_0_0;
      else
        slice1_best_second_0_0_choices(3) := slice0_best_second_0_0;
      end if;
      if slice1_best_at_start_0_0 then
        slice1_best_second_0_0_choices(4) := slice0_best_but_last_0_0;
      else
        slice1_best_second_0_0_choices(4) := slice1_best_second_0_0_choices(3);
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
      if (slice1_best_second_0_0_choices(2) - slice1_best_second_0_0_choices(4)) < 0 then
        slice1_best_second_0_0 <= slice1_best_second_0_0_choices(2);
      else
        slice1_best_second_0_0 <= slice1_best_second_0_0_choices(4);
      end if;
      if (slice1winner4_best_but_last_0_0 - slice0_best_late_cost_0_0) < 0 then
        slice1_best_but_last_0_0 <= slice1winner4_best_but_last_0_0;
      else
        slice1_best_but_last_0_0 <= slice0_best_late_cost_0_0;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        for i in 0 to 1 loop
          slice2shift_search(i, 0) <= slice1shift_search_out(i);
          for j in 1 to 15 loop
            slice2shift_search(i, j) <= slice2shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice2shift_reference(0) <= slice1shift_reference(0);
      slice2shift_reference(1) <= slice1shift_reference(1);
      slice2shift_search_out(0) <= slice2shift_search(0, 15);
      slice2shift_search_out(1) <= slice2shift_search(1, 15);
      -- slice2cost
      for i in 0 to 4 loop
        if slice0window_entering_tag_first_group then
          slice2cost_column_0_choice(3 * i) := 0;
        else
          slice2cost_column_0_choice(3 * i) := slice2cost_ready_words(i) mod 1024;
        end if;
        if slice0window_entering_tag_border_column then
          slice2cost_column_0_choice_2(3 * i) := 0;
        else
          slice2cost_column_0_choice_2(3 * i) := (slice2cost_change_0(3 * i) + slice2cost_column_0_choice(3 * i)) mod
            1024;
        end if;
        if slice0window_entering_tag_first_group then
          slice2cost_column_0_choice(3 * i + 1) := 0;
        else
          slice2cost_column_0_choice(3 * i + 1) := (slice2cost_ready_words(i) / 1024) mod 1024;
        end if;
        if slice0window_entering_tag_border_column then
          slice2cost_column_0_choice_2(3 * i + 1) := 0;
        else
          slice2cost_column_0_choice_2(3 * i + 1) := (slice2cost_change_0(3 * i + 1) + slice2cost_column_0_choice(3 * i
            + 1)) mod 1024;
        end if;
        if slice0window_entering_tag_first_group then
          slice2cost_column_0_choice(3 * i + 2) := 0;
        else
          slice2cost_column_0_choice(3 * i + 2) := slice2cost_ready_words(i) / 1048576;
        end if;
        if slice0window_entering_tag_border_column then
          slice2cost_column_0_choice_2(3 * i + 2) := 0;
        else
          slice2cost_column_0_choice_2(3 * i + 2) := (slice2cost_change_0(3 * i + 2) + slice2cost_column_0_choice(3 * i
            + 2)) mod 1024;
        end if;
      end loop;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_choice(15) := 0;
      else
        slice2cost_column_0_choice(15) := slice2cost_ready_words_5;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_choice_2(15) := 0;
      else
        slice2cost_column_0_choice_2(15) := (slice2cost_change_0(15) + slice2cost_column_0_choice(15)) mod 1024;
      end if;
      for i in 0 to 15 loop
        slice2cost_pixels_first(0, i) <= slice2shift_search(0, i) - slice2shift_reference(0);
      end loop;
      for i in 0 to 15 loop
        slice2cost_pixels_first(1, i) <= slice2shift_search(1, i) - slice2shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice2cost_pixels_cost(i, j) <= folded(slice2cost_pixels_first(i, j)) + as_number((slice2cost_pixels_first(i,
            j) < 0));
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 4 loop
        slice2cost_ready_words(i) <= to_integer(slice2cost_read_words(i));
      end loop;
      slice2cost_ready_words_5 <= to_integer(slice2cost_read_words_5);
      slice2cost_ready_column <= slice2cost_change_column;
      for i in 0 to 15 loop
        slice2cost_column_0(i) <= slice2cost_column_0_choice_2(i);
      end loop;
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
        for i in 0 to 4 loop
          slice2cost_write_words(i) <= (slice2cost_column_0_choice_2(3 * i + 1) * 1024) +
            slice2cost_column_0_choice_2(3 * i) + (slice2cost_column_0_choice_2(3 * i + 2) * 1048576);
        end loop;
        slice2cost_write_words_5 <= slice2cost_column_0_choice_2(15);
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
      for i in 0 to 1 loop
        for j in 0 to 2 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(6 * i + j) := to_integer(slice2window_leaving(2 * i)(10 * j + 9 downto 10 *
              j));
          else
            slice2window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
        for j in 3 to 5 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(6 * i + j) := to_integer(slice2window_leaving(2 * i + 1)(10 * j - 21 downto 10
              * j - 30));
          else
            slice2window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 12 to 14 loop
        if slice1window_change_tag_leaves_window then
          slice2window_change_0_choice(i) := to_integer(slice2window_leaving(4)(10 * i - 111 downto 10 * i - 120));
        else
          slice2window_change_0_choice(i) := 0;
        end if;
      end loop;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_choice(15) := to_integer(slice2window_leaving_5);
      else
        slice2window_change_0_choice(15) := 0;
      end if;
      for i in 0 to 15 loop
        slice2window_entering_0(i) <= slice2cost_column_0(i);
      end loop;
      for i in 0 to 15 loop
        slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
      end loop;
      slice2window_change_tag_first_cost <= slice1window_change_tag_first_cost;
      slice2window_change_tag_leaves_window <= slice1window_change_tag_leaves_window;
      slice2window_centre_output_column_0 <= slice1window_centre_output_column_0;
      slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
      for i in 0 to 15 loop
        if slice2window_change_tag_first_cost then
          slice2window_sum_0_choice(i) := 0;
        else
          slice2window_sum_0_choice(i) := slice2window_sum_0(i);
        end if;
      end loop;
      if slice0winner1_tag_valid then
        for i in 0 to 15 loop
          slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 16384;
        end loop;
      end if;
      if slice0winner2_tag_valid then
        slice2window_centre_start_of_frame_1 <= slice1window_centre_start_of_frame_1;
      end if;
      -- slice2winner1
      slice2winner1_best_index_0_0_is_not_less := (slice2window_sum_0(0) - slice2window_sum_0(1)) >= 0;
      for i in 1 to 7 loop
        slice2winner1_best_index_0_is_less(i) := (slice2window_sum_0(2 * i) - slice2window_sum_0(2 * i + 1)) < 0;
      end loop;
      for i in 0 to 15 loop
        slice2winner1_held_0(i) <= slice2window_sum_0(i);
      end loop;
      slice2winner1_best_index_0_0 <= slice2winner1_best_index_0_0_is_not_less;
      for i in 0 to 7 loop
        slice2winner1_best_late_cost_0(i) <= slice2winner1_best_cost_0(i);
      end loop;
      for i in 0 to 7 loop
        slice2winner1_best_but_first_0(i) <= slice2winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 7 loop
        slice2winner1_best_but_last_0(i) <= slice2winner1_held_0(2 * i);
      end loop;
      for i in 0 to 7 loop
        if (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0 then
          slice2winner1_best_cost_0(i) <= slice2window_sum_0(2 * i + 1);
        else
          slice2winner1_best_cost_0(i) <= slice2window_sum_0(2 * i);
        end if;
      end loop;
      if slice2winner1_best_index_0_is_less(1) then
        slice2winner1_best_index_0_1 <= 2;
        slice2winner1_best_below_0(1) <= 0;
        slice2winner1_best_above_0(1) <= slice2window_sum_0(3);
      else
        slice2winner1_best_index_0_1 <= 3;
        slice2winner1_best_below_0(1) <= slice2window_sum_0(2);
        slice2winner1_best_above_0(1) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(2) then
        slice2winner1_best_index_0_2 <= 4;
        slice2winner1_best_below_0(2) <= 0;
        slice2winner1_best_above_0(2) <= slice2window_sum_0(5);
      else
        slice2winner1_best_index_0_2 <= 5;
        slice2winner1_best_below_0(2) <= slice2window_sum_0(4);
        slice2winner1_best_above_0(2) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(3) then
        slice2winner1_best_index_0_3 <= 6;
        slice2winner1_best_below_0(3) <= 0;
        slice2winner1_best_above_0(3) <= slice2window_sum_0(7);
      else
        slice2winner1_best_index_0_3 <= 7;
        slice2winner1_best_below_0(3) <= slice2window_sum_0(6);
        slice2winner1_best_above_0(3) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(4) then
        slice2winner1_best_index_0_4 <= 8;
        slice2winner1_best_below_0(4) <= 0;
        slice2winner1_best_above_0(4) <= slice2window_sum_0(9);
      else
        slice2winner1_best_index_0_4 <= 9;
        slice2winner1_best_below_0(4) <= slice2window_sum_0(8);
        slice2winner1_best_above_0(4) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(5) then
        slice2winner1_best_index_0_5 <= 10;
        slice2winner1_best_below_0(5) <= 0;
        slice2winner1_best_above_0(5) <= slice2window_sum_0(11);
      else
        slice2winner1_best_index_0_5 <= 11;
        slice2winner1_best_below_0(5) <= slice2window_sum_0(10);
        slice2winner1_best_above_0(5) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(6) then
        slice2winner1_best_index_0_6 <= 12;
        slice2winner1_best_below_0(6) <= 0;
        slice2winner1_best_above_0(6) <= slice2window_sum_0(13);
      else
        slice2winner1_best_index_0_6 <= 13;
        slice2winner1_best_below_0(6) <= slice2window_sum_0(12);
        slice2winner1_best_above_0(6) <= 0;
      end if;
      if slice2winner1_best_index_0_is_less(7) then
        slice2winner1_best_index_0_7 <= 14;
        slice2winner1_best_below_0(7) <= 0;
        slice2winner1_best_above_0(7) <= slice2window_sum_0(15);
      else
        slice2winner1_best_index_0_7 <= 15;
        slice2winner1_best_below_0(7) <= slice2window_sum_0(14);
        slice2winner1_best_above_0(7) <= 0;
      end if;
      if slice2winner1_best_index_0_0_is_not_less then
        slice2winner1_best_below_0(0) <= slice2window_sum_0(0);
        slice2winner1_best_above_0(0) <= 0;
      else
        slice2winner1_best_below_0(0) <= 0;
        slice2winner1_best_above_0(0) <= slice2window_sum_0(1);
      end if;
      -- slice2winner2
      for i in 0 to 3 loop
        slice2winner2_best_index_0_is_not_less(i) := (slice2winner1_best_cost_0(2 * i) - slice2winner1_best_cost_0(2 *
          i + 1)) >= 0;
      end loop;
      for i in 4 to 5 loop
        if other(i) then
          slice2winner2_best_below_0_choice(i - 4) := slice2winner1_held_0(4 * i - 15);
        else
          slice2winner2_best_below_0_choice(i - 4) := slice2winner1_best_below_0(2 * i - 7);
        end if;
      end loop;
      for i in 13 to 14 loop
        if others_from_13(i) then
          slice2winner2_best_below_0_choice(i - 11) := slice2winner1_held_0(4 * i - 43);
        else
          slice2winner2_best_below_0_choice(i - 11) := slice2winner1_best_below_0(2 * i - 21);
        end if;
      end loop;
      if slice2winner1_best_index_0_0 then
        slice2winner2_best_above_0_choice(0) := slice2winner1_held_0(2);
      else
        slice2winner2_best_above_0_choice(0) := slice2winner1_best_above_0(0);
      end if;
      if is_set(slice2winner1_best_index_0_2, 2) and is_set(slice2winner1_best_index_0_2, 0) then
        slice2winner2_best_above_0_choice(1) := slice2winner1_held_0(6);
      else
        slice2winner2_best_above_0_choice(1) := slice2winner1_best_above_0(2);
      end if;
      if is_set(slice2winner1_best_index_0_4, 3) and is_set(slice2winner1_best_index_0_4, 0) then
        slice2winner2_best_above_0_choice(2) := slice2winner1_held_0(10);
      else
        slice2winner2_best_above_0_choice(2) := slice2winner1_best_above_0(4);
      end if;
      slice2winner2_best_above_0_3_value := is_set(slice2winner1_best_index_0_6, 2);
      if is_set(slice2winner1_best_index_0_6, 3) and slice2winner2_best_above_0_3_value and
        is_set(slice2winner1_best_index_0_6, 0) then
        slice2winner2_best_above_0_choice(3) := slice2winner1_held_0(14);
      else
        slice2winner2_best_above_0_choice(3) := slice2winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice2winner2_best_place_0(i) then
          slice2winner2_best_second_0_choice(i) := 16383;
        else
          slice2winner2_best_second_0_choice(i) := slice2winner1_best_late_cost_0(2 * i + 1);
        end if;
        if slice2winner2_best_at_end_0(i) then
          slice2winner2_best_second_0_choices(i, 2) := slice2winner1_best_but_first_0(2 * i + 1);
        else
          slice2winner2_best_second_0_choices(i, 2) := slice2winner2_best_second_0_choice(i);
        end if;
        if slice2winner2_best_place_0(i) then
          slice2winner2_best_second_0_choices(i, 3) := slice2winner1_best_late_cost_0(2 * i);
        else
          slice2winner2_best_second_0_choices(i, 3) := 16383;
        end if;
        if slice2winner2_best_at_start_0(i) then
          slice2winner2_best_second_0_choices(i, 4) := slice2winner1_best_but_last_0(2 * i);
        else
          slice2winner2_best_second_0_choices(i, 4) := slice2winner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice2winner2_best_first_0(0) <= slice2winner1_held_0(0);
      slice2winner2_best_first_0(1) <= slice2winner1_held_0(4);
      slice2winner2_best_first_0(2) <= slice2winner1_held_0(8);
      slice2winner2_best_first_0(3) <= slice2winner1_held_0(12);
      slice2winner2_best_last_0(0) <= slice2winner1_held_0(3);
      slice2winner2_best_last_0(1) <= slice2winner1_held_0(7);
      slice2winner2_best_last_0(2) <= slice2winner1_held_0(11);
      slice2winner2_best_last_0(3) <= slice2winner1_held_0(15);
      slice2winner2_best_place_0(0) <= slice2winner2_best_index_0_is_not_less(0);
      slice2winner2_best_place_0(1) <= slice2winner2_best_index_0_is_not_less(1);
      slice2winner2_best_place_0(2) <= slice2winner2_best_index_0_is_not_less(2);
      slice2winner2_best_place_0(3) <= slice2winner2_best_index_0_is_not_less(3);
      slice2winner2_best_at_start_0(0) <= other(4) and slice2winner2_best_index_0_is_not_less(0);
      slice2winner2_best_at_start_0(1) <= other(5) and slice2winner2_best_index_0_is_not_less(1);
      slice2winner2_best_at_start_0(2) <= others_from_13(13) and slice2winner2_best_index_0_is_not_less(2);
      slice2winner2_best_at_start_0(3) <= others_from_13(14) and slice2winner2_best_index_0_is_not_less(3);
      slice2winner2_best_at_end_0(0) <= slice2winner1_best_index_0_0 and ((slice2winner1_best_cost_0(0) -
        slice2winner1_best_cost_0(1)) < 0);
      slice2winner2_best_at_end_0(1) <= ((slice2winner1_best_cost_0(2) - slice2winner1_best_cost_0(3)) < 0) and
        is_set(slice2winner1_best_index_0_2, 2) and is_set(slice2winner1_best_index_0_2, 0);
      slice2winner2_best_at_end_0(2) <= ((slice2winner1_best_cost_0(4) - slice2winner1_best_cost_0(5)) < 0) and
        is_set(slice2winner1_best_index_0_4, 3) and is_set(slice2winner1_best_index_0_4, 0);
      slice2winner2_best_at_end_0(3) <= ((slice2winner1_best_cost_0(6) - slice2winner1_best_cost_0(7)) < 0) and
        is_set(slice2winner1_best_index_0_6, 3) and slice2winner2_best_above_0_3_value and
        is_set(slice2winner1_best_index_0_6, 0);
      slice2winner2_best_late_cost_0(0) <= slice2winner2_best_cost_0(0);
      slice2winner2_best_late_cost_0(1) <= slice2winner2_best_cost_0(1);
      slice2winner2_best_late_cost_0(2) <= slice2winner2_best_cost_0(2);
      slice2winner2_best_late_cost_0(3) <= slice2winner2_best_cost_0(3);
      for i in 0 to 3 loop
        if (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i)) < 0 then
          slice2winner2_best_cost_0(i) <= slice2winner1_best_cost_0(2 * i + 1);
        else
          slice2winner2_best_cost_0(i) <= slice2winner1_best_cost_0(2 * i);
        end if;
      end loop;
      if slice2winner2_best_index_0_is_not_less(0) then
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
        slice2winner2_best_below_0(0) <= slice2winner2_best_below_0_choice(0);
        slice2winner2_best_above_0(0) <= slice2winner1_best_above_0(1);
      else
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
        slice2winner2_best_below_0(0) <= slice2winner1_best_below_0(0);
        slice2winner2_best_above_0(0) <= slice2winner2_best_above_0_choice(0);
      end if;
      if slice2winner2_best_index_0_is_not_less(1) then
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
        slice2winner2_best_below_0(1) <= slice2winner2_best_below_0_choice(1);
        slice2winner2_best_above_0(1) <= slice2winner1_best_above_0(3);
      else
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
        slice2winner2_best_below_0(1) <= slice2winner1_best_below_0(2);
        slice2winner2_best_above_0(1) <= slice2winner2_best_above_0_choice(1);
      end if;
      if slice2winner2_best_index_0_is_not_less(2) then
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
        slice2winner2_best_below_0(2) <= slice2winner2_best_below_0_choice(2);
        slice2winner2_best_above_0(2) <= slice2winner1_best_above_0(5);
      else
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
        slice2winner2_best_below_0(2) <= slice2winner1_best_below_0(4);
        slice2winner2_best_above_0(2) <= slice2winner2_best_above_0_choice(2);
      end if;
      if slice2winner2_best_index_0_is_not_less(3) then
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
        slice2winner2_best_below_0(3) <= slice2winner2_best_below_0_choice(3);
        slice2winner2_best_above_0(3) <= slice2winner1_best_above_0(7);
      else
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_6;
        slice2winner2_best_below_0(3) <= slice2winner1_best_below_0(6);
        slice2winner2_best_above_0(3) <= slice2winner2_best_above_0_choice(3);
      end if;
      for i in 0 to 3 loop
        if (slice2winner2_best_second_0_choices(i, 2) - slice2winner2_best_second_0_choices(i, 4)) < 0 then
          slice2winner2_best_second_0(i) <= slice2winner2_best_second_0_choices(i, 2);
        else
          slice2winner2_best_second_0(i) <= slice2winner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice2winner1_best_late_cost_0(2 * i + 1) - slice2winner1_best_but_first_0(2 * i)) < 0 then
          slice2winner2_best_but_first_0(i) <= slice2winner1_best_late_cost_0(2 * i + 1);
        else
          slice2winner2_best_but_first_0(i) <= slice2winner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice2winner1_best_but_last_0(2 * i + 1) - slice2winner1_best_late_cost_0(2 * i)) < 0 then
          slice2winner2_best_but_last_0(i) <= slice2winner1_best_but_last_0(2 * i + 1);
        else
          slice2winner2_best_but_last_0(i) <= slice2winner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice2winner3
      slice2winner3_best_index_0_is_not_less(0) := (slice2winner2_best_cost_0(0) - slice2winner2_best_cost_0(1)) >= 0;
      slice2winner3_best_index_0_is_not_less(1) := (slice2winner2_best_cost_0(2) - slice2winner2_best_cost_0(3)) >= 0;
      slice2winner3_best_below_0_is_equal(0) := slice2winner2_best_index_0_1 = 4;
      if slice2winner3_best_below_0_is_equal(0) then
        slice2winner3_best_below_0_choice(0) := slice2winner2_best_last_0(0);
      else
        slice2winner3_best_below_0_choice(0) := slice2winner2_best_below_0(1);
      end if;
      slice2winner3_best_below_0_is_equal(1) := slice2winner2_best_index_0_3 = 12;
      if slice2winner3_best_below_0_is_equal(1) then
        slice2winner3_best_below_0_choice(1) := slice2winner2_best_last_0(2);
      else
        slice2winner3_best_below_0_choice(1) := slice2winner2_best_below_0(3);
      end if;
      slice2winner3_best_above_0_is_equal(0) := slice2winner2_best_index_0_0 = 3;
      if slice2winner3_best_above_0_is_equal(0) then
        slice2winner3_best_above_0_choice(0) := slice2winner2_best_first_0(1);
      else
        slice2winner3_best_above_0_choice(0) := slice2winner2_best_above_0(0);
      end if;
      slice2winner3_best_above_0_is_equal(1) := (slice2winner2_best_index_0_2 mod 4) = 3;
      if is_set(slice2winner2_best_index_0_2, 3) and slice2winner3_best_above_0_is_equal(1) then
        slice2winner3_best_above_0_choice(1) := slice2winner2_best_first_0(3);
      else
        slice2winner3_best_above_0_choice(1) := slice2winner2_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if slice2winner3_best_place_0(i) then
          slice2winner3_best_second_0_choice(i) := slice2winner2_best_second_0(2 * i + 1);
        else
          slice2winner3_best_second_0_choice(i) := slice2winner2_best_late_cost_0(2 * i + 1);
        end if;
        if slice2winner3_best_at_end_0(i) then
          slice2winner3_best_second_0_choices(i, 2) := slice2winner2_best_but_first_0(2 * i + 1);
        else
          slice2winner3_best_second_0_choices(i, 2) := slice2winner3_best_second_0_choice(i);
        end if;
        if slice2winner3_best_place_0(i) then
          slice2winner3_best_second_0_choices(i, 3) := slice2winner2_best_late_cost_0(2 * i);
        else
          slice2winner3_best_second_0_choices(i, 3) := slice2winner2_best_second_0(2 * i);
        end if;
        if slice2winner3_best_at_start_0(i) then
          slice2winner3_best_second_0_choices(i, 4) := slice2winner2_best_but_last_0(2 * i);
        else
          slice2winner3_best_second_0_choices(i, 4) := slice2winner3_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice2winner3_best_first_0(0) <= slice2winner2_best_first_0(0);
      slice2winner3_best_first_0(1) <= slice2winner2_best_first_0(2);
      slice2winner3_best_last_0(0) <= slice2winner2_best_last_0(1);
      slice2winner3_best_last_0(1) <= slice2winner2_best_last_0(3);
      slice2winner3_best_place_0(0) <= slice2winner3_best_index_0_is_not_less(0);
      slice2winner3_best_place_0(1) <= slice2winner3_best_index_0_is_not_less(1);
      slice2winner3_best_at_start_0(0) <= slice2winner3_best_index_0_is_not_less(0) and
        slice2winner3_best_below_0_is_equal(0);
      slice2winner3_best_at_start_0(1) <= slice2winner3_best_below_0_is_equal(1) and
        slice2winner3_best_index_0_is_not_less(1);
      slice2winner3_best_at_end_0(0) <= ((slice2winner2_best_cost_0(0) - slice2winner2_best_cost_0(1)) < 0) and
        slice2winner3_best_above_0_is_equal(0);
      slice2winner3_best_at_end_0(1) <= ((slice2winner2_best_cost_0(2) - slice2winner2_best_cost_0(3)) < 0) and
        is_set(slice2winner2_best_index_0_2, 3) and slice2winner3_best_above_0_is_equal(1);
      slice2winner3_best_late_cost_0(0) <= slice2winner3_best_cost_0(0);
      slice2winner3_best_late_cost_0(1) <= slice2winner3_best_cost_0(1);
      for i in 0 to 1 loop
        if (slice2winner2_best_cost_0(2 * i + 1) - slice2winner2_best_cost_0(2 * i)) < 0 then
          slice2winner3_best_cost_0(i) <= slice2winner2_best_cost_0(2 * i + 1);
        else
          slice2winner3_best_cost_0(i) <= slice2winner2_best_cost_0(2 * i);
        end if;
      end loop;
      if slice2winner3_best_index_0_is_not_less(0) then
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
        slice2winner3_best_below_0(0) <= slice2winner3_best_below_0_choice(0);
        slice2winner3_best_above_0(0) <= slice2winner2_best_above_0(1);
      else
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
        slice2winner3_best_below_0(0) <= slice2winner2_best_below_0(0);
        slice2winner3_best_above_0(0) <= slice2winner3_best_above_0_choice(0);
      end if;
      if slice2winner3_best_index_0_is_not_less(1) then
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
        slice2winner3_best_below_0(1) <= slice2winner3_best_below_0_choice(1);
        slice2winner3_best_above_0(1) <= slice2winner2_best_above_0(3);
      else
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_2;
        slice2winner3_best_below_0(1) <= slice2winner2_best_below_0(2);
        slice2winner3_best_above_0(1) <= slice2winner3_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (slice2winner3_best_second_0_choices(i, 2) - slice2winner3_best_second_0_choices(i, 4)) < 0 then
          slice2winner3_best_second_0(i) <= slice2winner3_best_second_0_choices(i, 2);
        else
          slice2winner3_best_second_0(i) <= slice2winner3_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (slice2winner2_best_late_cost_0(2 * i + 1) - slice2winner2_best_but_first_0(2 * i)) < 0 then
          slice2winner3_best_but_first_0(i) <= slice2winner2_best_late_cost_0(2 * i + 1);
        else
          slice2winner3_best_but_first_0(i) <= slice2winner2_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (slice2winner2_best_but_last_0(2 * i + 1) - slice2winner2_best_late_cost_0(2 * i)) < 0 then
          slice2winner3_best_but_last_0(i) <= slice2winner2_best_but_last_0(2 * i + 1);
        else
          slice2winner3_best_but_last_0(i) <= slice2winner2_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice2winner4
      slice2winner4_best_index_0_0_is_less := (slice2winner3_best_cost_0(0) - slice2winner3_best_cost_0(1)) < 0;
      slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0_1 = 8;
      if slice2winner4_best_below_0_0_is_equal then
        slice2winner4_best_below_0_0_choice := slice2winner3_best_last_0(0);
      else
        slice2winner4_best_below_0_0_choice := slice2winner3_best_below_0(1);
      end if;
      slice2winner4_best_above_0_0_is_equal := slice2winner3_best_index_0_0 = 7;
      if slice2winner4_best_above_0_0_is_equal then
        slice2winner4_best_above_0_0_choice := slice2winner3_best_first_0(1);
      else
        slice2winner4_best_above_0_0_choice := slice2winner3_best_above_0(0);
      end if;
      slice2winner4_best_place_0_0_is_not_less := (slice2winner3_best_cost_0(0) - slice2winner3_best_cost_0(1)) >= 0;
      if slice2winner4_best_place_0_0 then
        slice2winner4_best_second_0_0_choice := slice2winner3_best_second_0(1);
      else
        slice2winner4_best_second_0_0_choice := slice2winner3_best_late_cost_0(1);
      end if;
      if slice2winner4_best_at_end_0_0 then
        slice2winner4_best_second_0_0_choices(2) := slice2winner3_best_but_first_0(1);
      else
        slice2winner4_best_second_0_0_choices(2) := slice2winner4_best_second_0_0_choice;
      end if;
      if slice2winner4_best_place_0_0 then
        slice2winner4_best_second_0_0_choices(3) := slice2winner3_best_late_cost_0(0);
      else
        slice2winner4_best_second_0_0_choices(3) := slice2winner3_best_second_0(0);
      end if;
      if slice2winner4_best_at_start_0_0 then
        slice2winner4_best_second_0_0_choices(4) := slice2winner3_best_but_last_0(0);
      else
        slice2winner4_best_second_0_0_choices(4) := slice2winner4_best_second_0_0_choices(3);
      end if;
      slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
      slice2winner4_best_last_0_0 <= slice2winner3_best_last_0(1);
      slice2winner4_best_place_0_0 <= slice2winner4_best_place_0_0_is_not_less;
      slice2winner4_best_at_start_0_0 <= slice2winner4_best_below_0_0_is_equal and
        slice2winner4_best_place_0_0_is_not_less;
      slice2winner4_best_at_end_0_0 <= slice2winner4_best_index_0_0_is_less and slice2winner4_best_above_0_0_is_equal;
      slice2winner4_best_late_cost_0_0 <= slice2winner4_best_cost_0_0;
      if (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0 then
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0(1);
      else
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0(0);
      end if;
      if slice2winner4_best_index_0_0_is_less then
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
        slice2winner4_best_below_0_0 <= slice2winner3_best_below_0(0);
        slice2winner4_best_above_0_0 <= slice2winner4_best_above_0_0_choice;
      else
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
        slice2winner4_best_below_0_0 <= slice2winner4_best_below_0_0_choice;
        slice2winner4_best_above_0_0 <= slice2winner3_best_above_0(1);
      end if;
      if (slice2winner4_best_second_0_0_choices(2) - slice2winner4_best_second_0_0_choices(4)) < 0 then
        slice2winner4_best_second_0_0 <= slice2winner4_best_second_0_0_choices(2);
      else
        slice2winner4_best_second_0_0 <= slice2winner4_best_second_0_0_choices(4);
      end if;
      if (slice2winner3_best_late_cost_0(1) - slice2winner3_best_but_first_0(0)) < 0 then
        slice2winner4_best_but_first_0_0 <= slice2winner3_best_late_cost_0(1);
      else
        slice2winner4_best_but_first_0_0 <= slice2winner3_best_but_first_0(0);
      end if;
      if (slice2winner3_best_but_last_0(1) - slice2winner3_best_late_cost_0(0)) < 0 then
        slice2winner4_best_but_last_0_0 <= slice2winner3_best_but_last_0(1);
      else
        slice2winner4_best_but_last_0_0 <= slice2winner3_best_late_cost_0(0);
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
        slice2_best_second_0_0_choices(2) := slice2winner4_best_but_first_0_0;
      else
        slice2_best_second_0_0_choices(2) := slice2_best_second_0_0_choice;
      end if;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choices(3) := slice1_best_late_cost_0_0;
      else
        slice2_best_second_0_0_choices(3) := slice1_best_second_0_0;
      end if;
      if slice2_best_at_start_0_0 then
        slice2_best_second_0_0_choices(4) := slice1_best_but_last_0_0;
      else
        slice2_best_second_0_0_choices(4) := slice2_best_second_0_0_choices(3);
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
      if (slice2_best_second_0_0_choices(2) - slice2_best_second_0_0_choices(4)) < 0 then
        slice2_best_second_0_0 <= slice2_best_second_0_0_choices(2);
      else
        slice2_best_second_0_0 <= slice2_best_second_0_0_choices(4);
      end if;
      if (slice2winner4_best_but_last_0_0 - slice1_best_late_cost_0_0) < 0 then
        slice2_best_but_last_0_0 <= slice2winner4_best_but_last_0_0;
      else
        slice2_best_but_last_0_0 <= slice1_best_late_cost_0_0;
      end if;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        for i in 0 to 1 loop
          slice3shift_search(i, 0) <= slice2shift_search_out(i);
          for j in 1 to 15 loop
            slice3shift_search(i, j) <= slice3shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice3shift_reference(0) <= slice2shift_reference(0);
      slice3shift_reference(1) <= slice2shift_reference(1);
      -- slice3cost
      for i in 0 to 4 loop
        if slice0window_change_tag_first_group then
          slice3cost_column_0_choice(3 * i) := 0;
        else
          slice3cost_column_0_choice(3 * i) := slice3cost_ready_words(i) mod 1024;
        end if;
        if slice0window_change_tag_border_column then
          slice3cost_column_0_choice_2(3 * i) := 0;
        else
          slice3cost_column_0_choice_2(3 * i) := (slice3cost_change_0(3 * i) + slice3cost_column_0_choice(3 * i)) mod
            1024;
        end if;
        if slice0window_change_tag_first_group then
          slice3cost_column_0_choice(3 * i + 1) := 0;
        else
          slice3cost_column_0_choice(3 * i + 1) := (slice3cost_ready_words(i) / 1024) mod 1024;
        end if;
        if slice0window_change_tag_border_column then
          slice3cost_column_0_choice_2(3 * i + 1) := 0;
        else
          slice3cost_column_0_choice_2(3 * i + 1) := (slice3cost_change_0(3 * i + 1) + slice3cost_column_0_choice(3 * i
            + 1)) mod 1024;
        end if;
        if slice0window_change_tag_first_group then
          slice3cost_column_0_choice(3 * i + 2) := 0;
        else
          slice3cost_column_0_choice(3 * i + 2) := slice3cost_ready_words(i) / 1048576;
        end if;
        if slice0window_change_tag_border_column then
          slice3cost_column_0_choice_2(3 * i + 2) := 0;
        else
          slice3cost_column_0_choice_2(3 * i + 2) := (slice3cost_change_0(3 * i + 2) + slice3cost_column_0_choice(3 * i
            + 2)) mod 1024;
        end if;
      end loop;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_choice(15) := 0;
      else
        slice3cost_column_0_choice(15) := slice3cost_ready_words_5;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_choice_2(15) := 0;
      else
        slice3cost_column_0_choice_2(15) := (slice3cost_change_0(15) + slice3cost_column_0_choice(15)) mod 1024;
      end if;
      for i in 0 to 15 loop
        slice3cost_pixels_first(0, i) <= slice3shift_search(0, i) - slice3shift_reference(0);
      end loop;
      for i in 0 to 15 loop
        slice3cost_pixels_first(1, i) <= slice3shift_search(1, i) - slice3shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice3cost_pixels_cost(i, j) <= folded(slice3cost_pixels_first(i, j)) + as_number((slice3cost_pixels_first(i,
            j) < 0));
        end loop;
      end loop;
      slice3cost_read_column <= slice2cost_read_column;
      slice3cost_change_column <= slice3cost_read_column;
      for i in 0 to 15 loop
        slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 4 loop
        slice3cost_ready_words(i) <= to_integer(slice3cost_read_words(i));
      end loop;
      slice3cost_ready_words_5 <= to_integer(slice3cost_read_words_5);
      for i in 0 to 15 loop
        slice3cost_column_0(i) <= slice3cost_column_0_choice_2(i);
      end loop;
      if slice0window_entering_tag_valid then
        slice3cost_ready_column <= slice3cost_change_column;
      end if;
      if slice0window_change_tag_valid then
        slice3cost_write_column <= slice2cost_write_column;
        for i in 0 to 4 loop
          slice3cost_write_words(i) <= (slice3cost_column_0_choice_2(3 * i + 1) * 1024) +
            slice3cost_column_0_choice_2(3 * i) + (slice3cost_column_0_choice_2(3 * i + 2) * 1048576);
        end loop;
        slice3cost_write_words_5 <= slice3cost_column_0_choice_2(15);
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
      for i in 0 to 1 loop
        for j in 0 to 2 loop
          if slice2window_change_tag_leaves_window then
            slice3window_change_0_choice(6 * i + j) := to_integer(slice3window_leaving(2 * i)(10 * j + 9 downto 10 *
              j));
          else
            slice3window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
        for j in 3 to 5 loop
          if slice2window_change_tag_leaves_window then
            slice3window_change_0_choice(6 * i + j) := to_integer(slice3window_leaving(2 * i + 1)(10 * j - 21 downto 10
              * j - 30));
          else
            slice3window_change_0_choice(6 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 12 to 14 loop
        if slice2window_change_tag_leaves_window then
          slice3window_change_0_choice(i) := to_integer(slice3window_leaving(4)(10 * i - 111 downto 10 * i - 120));
        else
          slice3window_change_0_choice(i) := 0;
        end if;
      end loop;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_choice(15) := to_integer(slice3window_leaving_5);
      else
        slice3window_change_0_choice(15) := 0;
      end if;
      for i in 0 to 15 loop
        slice3window_entering_0(i) <= slice3cost_column_0(i);
      end loop;
      for i in 0 to 15 loop
        slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
      end loop;
      slice3window_change_tag_first_cost <= slice2window_change_tag_first_cost;
      for i in 0 to 15 loop
        if slice3window_change_tag_first_cost then
          slice3window_sum_0_choice(i) := 0;
        else
          slice3window_sum_0_choice(i) := slice3window_sum_0(i);
        end if;
      end loop;
      if slice0winner2_tag_valid then
        for i in 0 to 15 loop
          slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 16384;
        end loop;
        slice3window_centre_output_column(0) <= slice2window_centre_output_column_0;
        for i in 1 to 5 loop
          slice3window_centre_output_column(i) <= slice3window_centre_output_column(i - 1);
        end loop;
        slice3window_centre_start_of_frame_1 <= slice2window_centre_start_of_frame_1;
        slice3window_centre_start_of_frame_5 <= slice1window_centre_start_of_frame(5);
        slice3window_centre_end_of_line(0) <= slice2window_centre_end_of_line_0;
        for i in 1 to 5 loop
          slice3window_centre_end_of_line(i) <= slice3window_centre_end_of_line(i - 1);
        end loop;
      end if;
      -- slice3winner1
      slice3winner1_best_index_0_0_is_not_less := (slice3window_sum_0(0) - slice3window_sum_0(1)) >= 0;
      for i in 1 to 7 loop
        slice3winner1_best_index_0_is_less(i) := (slice3window_sum_0(2 * i) - slice3window_sum_0(2 * i + 1)) < 0;
      end loop;
      for i in 0 to 15 loop
        slice3winner1_held_0(i) <= slice3window_sum_0(i);
      end loop;
      slice3winner1_best_index_0_0 <= slice3winner1_best_index_0_0_is_not_less;
      for i in 0 to 7 loop
        slice3winner1_best_late_cost_0(i) <= slice3winner1_best_cost_0(i);
      end loop;
      for i in 0 to 7 loop
        slice3winner1_best_but_first_0(i) <= slice3winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 6 loop
        slice3winner1_best_but_last_0(i) <= slice3winner1_held_0(2 * i);
      end loop;
      for i in 0 to 7 loop
        if (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0 then
          slice3winner1_best_cost_0(i) <= slice3window_sum_0(2 * i + 1);
        else
          slice3winner1_best_cost_0(i) <= slice3window_sum_0(2 * i);
        end if;
      end loop;
      if slice3winner1_best_index_0_is_less(1) then
        slice3winner1_best_index_0_1 <= 2;
        slice3winner1_best_below_0(1) <= 0;
        slice3winner1_best_above_0(1) <= slice3window_sum_0(3);
      else
        slice3winner1_best_index_0_1 <= 3;
        slice3winner1_best_below_0(1) <= slice3window_sum_0(2);
        slice3winner1_best_above_0(1) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(2) then
        slice3winner1_best_index_0_2 <= 4;
        slice3winner1_best_below_0(2) <= 0;
        slice3winner1_best_above_0(2) <= slice3window_sum_0(5);
      else
        slice3winner1_best_index_0_2 <= 5;
        slice3winner1_best_below_0(2) <= slice3window_sum_0(4);
        slice3winner1_best_above_0(2) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(3) then
        slice3winner1_best_index_0_3 <= 6;
        slice3winner1_best_below_0(3) <= 0;
        slice3winner1_best_above_0(3) <= slice3window_sum_0(7);
      else
        slice3winner1_best_index_0_3 <= 7;
        slice3winner1_best_below_0(3) <= slice3window_sum_0(6);
        slice3winner1_best_above_0(3) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(4) then
        slice3winner1_best_index_0_4 <= 8;
        slice3winner1_best_below_0(4) <= 0;
        slice3winner1_best_above_0(4) <= slice3window_sum_0(9);
      else
        slice3winner1_best_index_0_4 <= 9;
        slice3winner1_best_below_0(4) <= slice3window_sum_0(8);
        slice3winner1_best_above_0(4) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(5) then
        slice3winner1_best_index_0_5 <= 10;
        slice3winner1_best_below_0(5) <= 0;
        slice3winner1_best_above_0(5) <= slice3window_sum_0(11);
      else
        slice3winner1_best_index_0_5 <= 11;
        slice3winner1_best_below_0(5) <= slice3window_sum_0(10);
        slice3winner1_best_above_0(5) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(6) then
        slice3winner1_best_index_0_6 <= 12;
        slice3winner1_best_below_0(6) <= 0;
        slice3winner1_best_above_0(6) <= slice3window_sum_0(13);
      else
        slice3winner1_best_index_0_6 <= 13;
        slice3winner1_best_below_0(6) <= slice3window_sum_0(12);
        slice3winner1_best_above_0(6) <= 0;
      end if;
      if slice3winner1_best_index_0_is_less(7) then
        slice3winner1_best_index_0_7 <= 14;
        slice3winner1_best_below_0(7) <= 0;
        slice3winner1_best_above_0(7) <= slice3window_sum_0(15);
      else
        slice3winner1_best_index_0_7 <= 15;
        slice3winner1_best_below_0(7) <= slice3window_sum_0(14);
        slice3winner1_best_above_0(7) <= 0;
      end if;
      if slice3winner1_best_index_0_0_is_not_less then
        slice3winner1_best_below_0(0) <= slice3window_sum_0(0);
        slice3winner1_best_above_0(0) <= 0;
      else
        slice3winner1_best_below_0(0) <= 0;
        slice3winner1_best_above_0(0) <= slice3window_sum_0(1);
      end if;
      -- slice3winner2
      for i in 0 to 3 loop
        slice3winner2_best_index_0_is_not_less(i) := (slice3winner1_best_cost_0(2 * i) - slice3winner1_best_cost_0(2 *
          i + 1)) >= 0;
      end loop;
      for i in 0 to 3 loop
        if other(i) then
          slice3winner2_best_below_0_choice(i) := slice3winner1_held_0(4 * i + 1);
        else
          slice3winner2_best_below_0_choice(i) := slice3winner1_best_below_0(2 * i + 1);
        end if;
      end loop;
      if slice3winner1_best_index_0_0 then
        slice3winner2_best_above_0_choice(0) := slice3winner1_held_0(2);
      else
        slice3winner2_best_above_0_choice(0) := slice3winner1_best_above_0(0);
      end if;
      if is_set(slice3winner1_best_index_0_2, 2) and is_set(slice3winner1_best_index_0_2, 0) then
        slice3winner2_best_above_0_choice(1) := slice3winner1_held_0(6);
      else
        slice3winner2_best_above_0_choice(1) := slice3winner1_best_above_0(2);
      end if;
      if is_set(slice3winner1_best_index_0_4, 3) and is_set(slice3winner1_best_index_0_4, 0) then
        slice3winner2_best_above_0_choice(2) := slice3winner1_held_0(10);
      else
        slice3winner2_best_above_0_choice(2) := slice3winner1_best_above_0(4);
      end if;
      slice3winner2_best_above_0_3_value := is_set(slice3winner1_best_index_0_6, 2);
      if is_set(slice3winner1_best_index_0_6, 3) and slice3winner2_best_above_0_3_value and
        is_set(slice3winner1_best_index_0_6, 0) then
        slice3winner2_best_above_0_choice(3) := slice3winner1_held_0(14);
      else
        slice3winner2_best_above_0_choice(3) := slice3winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice3winner2_best_place_0(i) then
          slice3winner2_best_second_0_choice(i) := 16383;
        else
          slice3winner2_best_second_0_choice(i) := slice3winner1_best_late_cost_0(2 * i + 1);
        end if;
        if slice3winner2_best_at_end_0(i) then
          slice3winner2_best_second_0_choices(i, 2) := slice3winner1_best_but_first_0(2 * i + 1);
        else
          slice3winner2_best_second_0_choices(i, 2) := slice3winner2_best_second_0_choice(i);
        end if;
        if slice3winner2_best_place_0(i) then
          slice3winner2_best_second_0_choices(i, 3) := slice3winner1_best_late_cost_0(2 * i);
        else
          slice3winner2_best_second_0_choices(i, 3) := 16383;
        end if;
        if slice3winner2_best_at_start_0(i) then
          slice3winner2_best_second_0_choices(i, 4) := slice3winner1_best_but_last_0(2 * i);
        else
          slice3winner2_best_second_0_choices(i, 4) := slice3winner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice3winner2_best_first_0(0) <= slice3winner1_held_0(0);
      slice3winner2_best_first_0(1) <= slice3winner1_held_0(4);
      slice3winner2_best_first_0(2) <= slice3winner1_held_0(8);
      slice3winner2_best_first_0(3) <= slice3winner1_held_0(12);
      slice3winner2_best_last_0(0) <= slice3winner1_held_0(3);
      slice3winner2_best_last_0(1) <= slice3winner1_held_0(7);
      slice3winner2_best_last_0(2) <= slice3winner1_held_0(11);
      slice3winner2_best_place_0(0) <= slice3winner2_best_index_0_is_not_less(0);
      slice3winner2_best_place_0(1) <= slice3winner2_best_index_0_is_not_less(1);
      slice3winner2_best_place_0(2) <= slice3winner2_best_index_0_is_not_less(2);
      slice3winner2_best_place_0(3) <= slice3winner2_best_index_0_is_not_less(3);
      slice3winner2_best_at_start_0(0) <= other(0) and slice3winner2_best_index_0_is_not_less(0);
      slice3winner2_best_at_start_0(1) <= other(1) and slice3winner2_best_index_0_is_not_less(1);
      slice3winner2_best_at_start_0(2) <= other(2) and slice3winner2_best_index_0_is_not_less(2);
      slice3winner2_best_at_start_0(3) <= other(3) and slice3winner2_best_index_0_is_not_less(3);
      slice3winner2_best_at_end_0(0) <= slice3winner1_best_index_0_0 and ((slice3winner1_best_cost_0(0) -
        slice3winner1_best_cost_0(1)) < 0);
      slice3winner2_best_at_end_0(1) <= ((slice3winner1_best_cost_0(2) - slice3winner1_best_cost_0(3)) < 0) and
        is_set(slice3winner1_best_index_0_2, 2) and is_set(slice3winner1_best_index_0_2, 0);
      slice3winner2_best_at_end_0(2) <= ((slice3winner1_best_cost_0(4) - slice3winner1_best_cost_0(5)) < 0) and
        is_set(slice3winner1_best_index_0_4, 3) and is_set(slice3winner1_best_index_0_4, 0);
      slice3winner2_best_at_end_0(3) <= ((slice3winner1_best_cost_0(6) - slice3winner1_best_cost_0(7)) < 0) and
        is_set(slice3winner1_best_index_0_6, 3) and slice3winner2_best_above_0_3_value and
        is_set(slice3winner1_best_index_0_6, 0);
      slice3winner2_best_late_cost_0(0) <= slice3winner2_best_cost_0(0);
      slice3winner2_best_late_cost_0(1) <= slice3winner2_best_cost_0(1);
      slice3winner2_best_late_cost_0(2) <= slice3winner2_best_cost_0(2);
      slice3winner2_best_late_cost_0(3) <= slice3winner2_best_cost_0(3);
      for i in 0 to 3 loop
        if (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 * i)) < 0 then
          slice3winner2_best_cost_0(i) <= slice3winner1_best_cost_0(2 * i + 1);
        else
          slice3winner2_best_cost_0(i) <= slice3winner1_best_cost_0(2 * i);
        end if;
      end loop;
      if slice3winner2_best_index_0_is_not_less(0) then
        slice3winner2_best_index_0_0 <= slice3winner1_best_index_0_1;
        slice3winner2_best_below_0(0) <= slice3winner2_best_below_0_choice(0);
        slice3winner2_best_above_0(0) <= slice3winner1_best_above_0(1);
      else
        slice3winner2_best_index_0_0 <= as_number(slice3winner1_best_index_0_0);
        slice3winner2_best_below_0(0) <= slice3winner1_best_below_0(0);
        slice3winner2_best_above_0(0) <= slice3winner2_best_above_0_choice(0);
      end if;
      if slice3winner2_best_index_0_is_not_less(1) then
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_3;
        slice3winner2_best_below_0(1) <= slice3winner2_best_below_0_choice(1);
        slice3winner2_best_above_0(1) <= slice3winner1_best_above_0(3);
      else
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_2;
        slice3winner2_best_below_0(1) <= slice3winner1_best_below_0(2);
        slice3winner2_best_above_0(1) <= slice3winner2_best_above_0_choice(1);
      end if;
      if slice3winner2_best_index_0_is_not_less(2) then
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_5;
        slice3winner2_best_below_0(2) <= slice3winner2_best_below_0_choice(2);
        slice3winner2_best_above_0(2) <= slice3winner1_best_above_0(5);
      else
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_4;
        slice3winner2_best_below_0(2) <= slice3winner1_best_below_0(4);
        slice3winner2_best_above_0(2) <= slice3winner2_best_above_0_choice(2);
      end if;
      if slice3winner2_best_index_0_is_not_less(3) then
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_7;
        slice3winner2_best_below_0(3) <= slice3winner2_best_below_0_choice(3);
        slice3winner2_best_above_0(3) <= slice3winner1_best_above_0(7);
      else
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_6;
        slice3winner2_best_below_0(3) <= slice3winner1_best_below_0(6);
        slice3winner2_best_above_0(3) <= slice3winner2_best_above_0_choice(3);
      end if;
      for i in 0 to 3 loop
        if (slice3winner2_best_second_0_choices(i, 2) - slice3winner2_best_second_0_choices(i, 4)) < 0 then
          slice3winner2_best_second_0(i) <= slice3winner2_best_second_0_choices(i, 2);
        else
          slice3winner2_best_second_0(i) <= slice3winner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (slice3winner1_best_late_cost_0(2 * i + 1) - slice3winner1_best_but_first_0(2 * i)) < 0 then
          slice3winner2_best_but_first_0(i) <= slice3winner1_best_late_cost_0(2 * i + 1);
        else
          slice3winner2_best_but_first_0(i) <= slice3winner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 2 loop
        if (slice3winner1_best_but_last_0(2 * i + 1) - slice3winner1_best_late_cost_0(2 * i)) < 0 then
          slice3winner2_best_but_last_0(i) <= slice3winner1_best_but_last_0(2 * i + 1);
        else
          slice3winner2_best_but_last_0(i) <= slice3winner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice3winner3
      slice3winner3_best_index_0_is_not_less(0) := (slice3winner2_best_cost_0(0) - slice3winner2_best_cost_0(1)) >= 0;
      slice3winner3_best_index_0_is_not_less(1) := (slice3winner2_best_cost_0(2) - slice3winner2_best_cost_0(3)) >= 0;
      slice3winner3_best_below_0_is_equal(0) := slice3winner2_best_index_0_1 = 4;
      if slice3winner3_best_below_0_is_equal(0) then
        slice3winner3_best_below_0_choice(0) := slice3winner2_best_last_0(0);
      else
        slice3winner3_best_below_0_choice(0) := slice3winner2_best_below_0(1);
      end if;
      slice3winner3_best_below_0_is_equal(1) := slice3winner2_best_index_0_3 = 12;
      if slice3winner3_best_below_0_is_equal(1) then
        slice3winner3_best_below_0_choice(1) := slice3winner2_best_last_0(2);
      else
        slice3winner3_best_below_0_choice(1) := slice3winner2_best_below_0(3);
      end if;
      slice3winner3_best_above_0_is_equal(0) := slice3winner2_best_index_0_0 = 3;
      if slice3winner3_best_above_0_is_equal(0) then
        slice3winner3_best_above_0_choice(0) := slice3winner2_best_first_0(1);
      else
        slice3winner3_best_above_0_choice(0) := slice3winner2_best_above_0(0);
      end if;
      slice3winner3_best_above_0_is_equal(1) := (slice3winner2_best_index_0_2 mod 4) = 3;
      if is_set(slice3winner2_best_index_0_2, 3) and slice3winner3_best_above_0_is_equal(1) then
        slice3winner3_best_above_0_choice(1) := slice3winner2_best_first_0(3);
      else
        slice3winner3_best_above_0_choice(1) := slice3winner2_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if slice3winner3_best_place_0(i) then
          slice3winner3_best_second_0_choice(i) := slice3winner2_best_second_0(2 * i + 1);
        else
          slice3winner3_best_second_0_choice(i) := slice3winner2_best_late_cost_0(2 * i + 1);
        end if;
        if slice3winner3_best_at_end_0(i) then
          slice3winner3_best_second_0_choices(i, 2) := slice3winner2_best_but_first_0(2 * i + 1);
        else
          slice3winner3_best_second_0_choices(i, 2) := slice3winner3_best_second_0_choice(i);
        end if;
        if slice3winner3_best_place_0(i) then
          slice3winner3_best_second_0_choices(i, 3) := slice3winner2_best_late_cost_0(2 * i);
        else
          slice3winner3_best_second_0_choices(i, 3) := slice3winner2_best_second_0(2 * i);
        end if;
        if slice3winner3_best_at_start_0(i) then
          slice3winner3_best_second_0_choices(i, 4) := slice3winner2_best_but_last_0(2 * i);
        else
          slice3winner3_best_second_0_choices(i, 4) := slice3winner3_best_second_0_choices(i, 3);
        end if;
      end loop;
      slice3winner3_best_first_0(0) <= slice3winner2_best_first_0(0);
      slice3winner3_best_first_0(1) <= slice3winner2_best_first_0(2);
      slice3winner3_best_last_0_0 <= slice3winner2_best_last_0(1);
      slice3winner3_best_place_0(0) <= slice3winner3_best_index_0_is_not_less(0);
      slice3winner3_best_place_0(1) <= slice3winner3_best_index_0_is_not_less(1);
      slice3winner3_best_at_start_0(0) <= slice3winner3_best_index_0_is_not_less(0) and
        slice3winner3_best_below_0_is_equal(0);
      slice3winner3_best_at_start_0(1) <= slice3winner3_best_below_0_is_equal(1) and
        slice3winner3_best_index_0_is_not_less(1);
      slice3winner3_best_at_end_0(0) <= ((slice3winner2_best_cost_0(0) - slice3winner2_best_cost_0(1)) < 0) and
        slice3winner3_best_above_0_is_equal(0);
      slice3winner3_best_at_end_0(1) <= ((slice3winner2_best_cost_0(2) - slice3winner2_best_cost_0(3)) < 0) and
        is_set(slice3winner2_best_index_0_2, 3) and slice3winner3_best_above_0_is_equal(1);
      slice3winner3_best_late_cost_0(0) <= slice3winner3_best_cost_0(0);
      slice3winner3_best_late_cost_0(1) <= slice3winner3_best_cost_0(1);
      for i in 0 to 1 loop
        if (slice3winner2_best_cost_0(2 * i + 1) - slice3winner2_best_cost_0(2 * i)) < 0 then
          slice3winner3_best_cost_0(i) <= slice3winner2_best_cost_0(2 * i + 1);
        else
          slice3winner3_best_cost_0(i) <= slice3winner2_best_cost_0(2 * i);
        end if;
      end loop;
      if slice3winner3_best_index_0_is_not_less(0) then
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_1;
        slice3winner3_best_below_0(0) <= slice3winner3_best_below_0_choice(0);
        slice3winner3_best_above_0(0) <= slice3winner2_best_above_0(1);
      else
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_0;
        slice3winner3_best_below_0(0) <= slice3winner2_best_below_0(0);
        slice3winner3_best_above_0(0) <= slice3winner3_best_above_0_choice(0);
      end if;
      if slice3winner3_best_index_0_is_not_less(1) then
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_3;
        slice3winner3_best_below_0(1) <= slice3winner3_best_below_0_choice(1);
        slice3winner3_best_above_0(1) <= slice3winner2_best_above_0(3);
      else
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_2;
        slice3winner3_best_below_0(1) <= slice3winner2_best_below_0(2);
        slice3winner3_best_above_0(1) <= slice3winner3_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (slice3winner3_best_second_0_choices(i, 2) - slice3winner3_best_second_0_choices(i, 4)) < 0 then
          slice3winner3_best_second_0(i) <= slice3winner3_best_second_0_choices(i, 2);
        else
          slice3winner3_best_second_0(i) <= slice3winner3_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (slice3winner2_best_late_cost_0(2 * i + 1) - slice3winner2_best_but_first_0(2 * i)) < 0 then
          slice3winner3_best_but_first_0(i) <= slice3winner2_best_late_cost_0(2 * i + 1);
        else
          slice3winner3_best_but_first_0(i) <= slice3winner2_best_but_first_0(2 * i);
        end if;
      end loop;
      if (slice3winner2_best_but_last_0(1) - slice3winner2_best_late_cost_0(0)) < 0 then
        slice3winner3_best_but_last_0_0 <= slice3winner2_best_but_last_0(1);
      else
        slice3winner3_best_but_last_0_0 <= slice3winner2_best_late_cost_0(0);
      end if;
      -- slice3winner4
      slice3winner4_best_index_0_0_is_less := (slice3winner3_best_cost_0(0) - slice3winner3_best_cost_0(1)) < 0;
      slice3winner4_best_below_0_0_is_equal := slice3winner3_best_index_0_1 = 8;
      if slice3winner4_best_below_0_0_is_equal then
        slice3winner4_best_below_0_0_choice := slice3winner3_best_last_0_0;
      else
        slice3winner4_best_below_0_0_choice := slice3winner3_best_below_0(1);
      end if;
      slice3winner4_best_above_0_0_is_equal := slice3winner3_best_index_0_0 = 7;
      if slice3winner4_best_above_0_0_is_equal then
        slice3winner4_best_above_0_0_choice := slice3winner3_best_first_0(1);
      else
        slice3winner4_best_above_0_0_choice := slice3winner3_best_above_0(0);
      end if;
      slice3winner4_best_place_0_0_is_not_less := (slice3winner3_best_cost_0(0) - slice3winner3_best_cost_0(1)) >= 0;
      if slice3winner4_best_place_0_0 then
        slice3winner4_best_second_0_0_choice := slice3winner3_best_second_0(1);
      else
        slice3winner4_best_second_0_0_choice := slice3winner3_best_late_cost_0(1);
      end if;
      if slice3winner4_best_at_end_0_0 then
        slice3winner4_best_second_0_0_choices(2) := slice3winner3_best_but_first_0(1);
      else
        slice3winner4_best_second_0_0_choices(2) := slice3winner4_best_second_0_0_choice;
      end if;
      if slice3winner4_best_place_0_0 then
        slice3winner4_best_second_0_0_choices(3) := slice3winner3_best_late_cost_0(0);
      else
        slice3winner4_best_second_0_0_choices(3) := slice3winner3_best_second_0(0);
      end if;
      if slice3winner4_best_at_start_0_0 then
        slice3winner4_best_second_0_0_choices(4) := slice3winner3_best_but_last_0_0;
      else
        slice3winner4_best_second_0_0_choices(4) := slice3winner4_best_second_0_0_choices(3);
      end if;
      slice3winner4_best_first_0_0 <= slice3winner3_best_first_0(0);
      slice3winner4_best_place_0_0 <= slice3winner4_best_place_0_0_is_not_less;
      slice3winner4_best_at_start_0_0 <= slice3winner4_best_below_0_0_is_equal and
        slice3winner4_best_place_0_0_is_not_less;
      slice3winner4_best_at_end_0_0 <= slice3winner4_best_index_0_0_is_less and slice3winner4_best_above_0_0_is_equal;
      slice3winner4_best_late_cost_0_0 <= slice3winner4_best_cost_0_0;
      if (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0 then
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0(1);
      else
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0(0);
      end if;
      if slice3winner4_best_index_0_0_is_less then
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_0;
        slice3winner4_best_below_0_0 <= slice3winner3_best_below_0(0);
        slice3winner4_best_above_0_0 <= slice3winner4_best_above_0_0_choice;
      else
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_1;
        slice3winner4_best_below_0_0 <= slice3winner4_best_below_0_0_choice;
        slice3winner4_best_above_0_0 <= slice3winner3_best_above_0(1);
      end if;
      if (slice3winner4_best_second_0_0_choices(2) - slice3winner4_best_second_0_0_choices(4)) < 0 then
        slice3winner4_best_second_0_0 <= slice3winner4_best_second_0_0_choices(2);
      else
        slice3winner4_best_second_0_0 <= slice3winner4_best_second_0_0_choices(4);
      end if;
      if (slice3winner3_best_late_cost_0(1) - slice3winner3_best_but_first_0(0)) < 0 then
        slice3winner4_best_but_first_0_0 <= slice3winner3_best_late_cost_0(1);
      else
        slice3winner4_best_but_first_0_0 <= slice3winner3_best_but_first_0(0);
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
        slice3_best_second_0_0_choices(2) := slice3winner4_best_but_first_0_0;
      else
        slice3_best_second_0_0_choices(2) := slice3_best_second_0_0_choice;
      end if;
      if slice3_best_place_0_0 then
        slice3_best_second_0_0_choices(3) := slice2_best_late_cost_0_0;
      else
        slice3_best_second_0_0_choices(3) := slice2_best_second_0_0;
      end if;
      if slice3_best_at_start_0_0 then
        slice3_best_second_0_0_choices(4) := slice2_best_but_last_0_0;
      else
        slice3_best_second_0_0_choices(4) := slice3_best_second_0_0_choices(3);
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
      if (slice3_best_second_0_0_choices(2) - slice3_best_second_0_0_choices(4)) < 0 then
        slice3_best_second_0_0 <= slice3_best_second_0_0_choices(2);
      else
        slice3_best_second_0_0 <= slice3_best_second_0_0_choices(4);
      end if;
      -- texture
      texture_passes_0(0) <= 9 < texturewindow_sum_0_0;
      for i in 1 to 7 loop
        texture_passes_0(i) <= texture_passes_0(i - 1);
      end loop;
      for i in 0 to 1 loop
        if rows_inside(i) then
          texture_taps_search_0(i) <= 31;
        else
          texture_taps_search_0(i) <= 0;
        end if;
      end loop;
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
      texturecost_pixels_first_0(0) <= texture_taps_search_0(0) - slice0shift_reference(0);
      texturecost_pixels_first_0(1) <= texture_taps_search_0(1) - slice0shift_reference(1);
      texturecost_pixels_cost_0(0) <= folded(texturecost_pixels_first_0(0)) + as_number((texturecost_pixels_first_0(0)
        < 0));
      texturecost_pixels_cost_0(1) <= folded(texturecost_pixels_first_0(1)) + as_number((texturecost_pixels_first_0(1)
        < 0));
      texturecost_change_0_0 <= texturecost_pixels_cost_0(1) - texturecost_pixels_cost_0(0);
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
      refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 32768) - refinement_divisor_0(0);
      for i in 2 to 7 loop
        refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 32768) - refinement_divisor_0(i
          - 1);
      end loop;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
      refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
      refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_0(8) then
        refinement_fraction_0_choice := refinement_fraction_0_difference mod 256;
      else
        refinement_fraction_0_choice := refinement_fraction_0_value;
      end if;
      if refinement_negative_0(8) then
        refinement_fraction_0_choice_2 := refinement_fraction_0_difference mod 8;
      else
        refinement_fraction_0_choice_2 := refinement_fraction_0_value mod 8;
      end if;
      refinement_disparity_0(0) <= slice3_best_index_0_0;
      for i in 1 to 11 loop
        refinement_disparity_0(i) <= refinement_disparity_0(i - 1);
      end loop;
      refinement_passed_0(0) <= texture_passes_0(7);
      refinement_passed_0(1) <= refinement_passed_0(0);
      refinement_passed_0(2) <= refinement_passed_0(1);
      for i in 4 to 11 loop
        refinement_passed_0(i) <= refinement_passed_0(i - 1);
      end loop;
      refinement_tag_valid(0) <= slice3_best_tag_valid;
      refinement_tag_output_column(0) <= slice3_best_tag_output_column;
      refinement_tag_start_of_frame(0) <= slice3_best_tag_start_of_frame;
      refinement_tag_end_of_line(0) <= slice3_best_tag_end_of_line;
      for i in 1 to 11 loop
        refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
        refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
        refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
        refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
      end loop;
      refinement_alone_0(0) <= slice3_best_second_0_0 = 16383;
      refinement_alone_0(1) <= refinement_alone_0(0);
      refinement_gap_0 <= (slice3_best_second_0_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_lowest_0 <= slice3_best_late_cost_0_0;
      refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
      refinement_scaled_cost_0 <= ((refinement_lowest_0 + (refinement_lowest_0 / 2)) * 2) + (refinement_lowest_0 mod 2);
      refinement_u_0 <= (refinement_below_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_v_0 <= (refinement_above_0 - slice3_best_late_cost_0_0) mod 16384;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0(0) <= magnitude(refinement_difference_0);
      refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 14)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 14))));
      for i in 1 to 7 loop
        refinement_divisor_0(i) <= refinement_divisor_0(i - 1);
      end loop;
      refinement_quotient_8_0 <= ((((32768 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 16384) +
        ((other_6 / 2) * 2);
      refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
      for i in 1 to 8 loop
        refinement_negative_0(i) <= refinement_negative_0(i - 1);
      end loop;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      if refinement_alone_0(1) then
        refinement_passed_0(3) <= refinement_passed_0(2);
      else
        refinement_passed_0(3) <= refinement_passed_0(2) and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0);
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
      if is_set(refinement_remainder_1_0_difference, 15) then
        refinement_remainder_0(1) <= refinement_remainder_1_0_difference mod 16384;
      else
        refinement_remainder_0(1) <= refinement_remainder_0(0);
      end if;
      for i in 2 to 7 loop
        if is_set(refinement_remainder_0_difference(i), 15) then
          refinement_remainder_0(i) <= refinement_remainder_0_difference(i) mod 16384;
        else
          refinement_remainder_0(i) <= (refinement_remainder_0(i - 1) mod 8192) * 2;
        end if;
      end loop;
      -- map
      map_out_disparity_0 <= (((((refinement_disparity_0(11) + (refinement_fraction_0 / 16)) * 2) +
        ((refinement_fraction_0 mod 16) / 8) + 8191) mod 8192) * 8) + (refinement_fraction_0 mod 8);
      map_out_passed_0 <= refinement_passed_0(11);
      map_out_valid <= refinement_tag_valid(11) and refinement_tag_output_column(11);
      map_out_start_of_frame <= refinement_tag_start_of_frame(11) and refinement_tag_valid(11) and
        refinement_tag_output_column(11);
      map_out_end_of_line <= refinement_tag_end_of_line(11) and refinement_tag_valid(11) and
        refinement_tag_output_column(11);
      -- other
      other(0) <= slice3winner1_best_index_0_is_less(1);
      other(1) <= slice3winner1_best_index_0_is_less(3);
      other(2) <= slice3winner1_best_index_0_is_less(5);
      other(3) <= slice3winner1_best_index_0_is_less(7);
      other(4) <= slice2winner1_best_index_0_is_less(1);
      other(5) <= slice2winner1_best_index_0_is_less(3);
      other_6 <= ((refinement_remainder_0_difference(7) / 32768) * 2) + ((other_7 / 4) * 4);
      other_7 <= ((refinement_remainder_0_difference(6) / 32768) * 4) + ((other_8 / 8) * 8);
      other_8 <= ((refinement_remainder_0_difference(5) / 32768) * 8) + ((other_9 / 16) * 16);
      other_9 <= ((refinement_remainder_0_difference(4) / 32768) * 16) + ((other_10 / 32) * 32);
      other_10 <= ((refinement_remainder_0_difference(3) / 32768) * 32) + ((other_11 / 64) * 64);
      other_11 <= ((refinement_remainder_0_difference(2) / 32768) * 64) + ((other_12 / 128) * 128);
      other_12 <= (refinement_remainder_1_0_difference / 32768) * 128;
      others_from_13(13) <= slice2winner1_best_index_0_is_less(5);
      others_from_13(14) <= slice2winner1_best_index_0_is_less(7);
      others_from_13(15) <= slice1winner1_best_index_0_is_less(1);
      others_from_13(16) <= slice1winner1_best_index_0_is_less(3);
      others_from_13(17) <= slice1winner1_best_index_0_is_less(5);
      others_from_13(18) <= slice1winner1_best_index_0_is_less(7);
      others_from_13(19) <= slice0winner1_best_index_0_is_less(1);
      others_from_13(20) <= slice0winner1_best_index_0_is_less(3);
      others_from_13(21) <= slice0winner1_best_index_0_is_less(5);
      others_from_13(22) <= slice0winner1_best_index_0_is_less(7);
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
        for i in 0 to 2 loop
          transform_filtering_start_of_frame(i) <= false;
          transform_filtering_valid(i) <= false;
        end loop;
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
        slice0window_centre_start_of_frame(0) <= false;
        slice0window_centre_start_of_frame(1) <= false;
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
        slice1window_centre_start_of_frame(3) <= false;
        slice1window_centre_start_of_frame(4) <= false;
        slice1window_centre_start_of_frame(5) <= false;
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
        for i in 0 to 5 loop
          slice3window_centre_output_column(i) <= false;
        end loop;
        slice3window_centre_start_of_frame_1 <= false;
        slice3window_centre_start_of_frame_5 <= false;
        for i in 0 to 5 loop
          slice3window_centre_end_of_line(i) <= false;
        end loop;
        slice3_best_tag_valid <= false;
        slice3_best_tag_output_column <= false;
        slice3_best_tag_start_of_frame <= false;
        slice3_best_tag_end_of_line <= false;
        for i in 0 to 11 loop
          refinement_tag_valid(i) <= false;
          refinement_tag_output_column(i) <= false;
          refinement_tag_start_of_frame(i) <= false;
          refinement_tag_end_of_line(i) <= false;
        end loop;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
