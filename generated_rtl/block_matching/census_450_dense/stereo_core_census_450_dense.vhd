-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_450_dense: 450x375, 48 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 48, window_px 9, reference left, cost census, census_width_px 9, census_pattern
--   even_columns, left_right_threshold 1, subpixel true, median true, full_width true, support_threshold 10,
--   confidence true, margin_shift 3, margin_weight 1, support_weight 6, fill_holes true, aggregation
--   recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_450_dense
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_450_dense is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 48;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 24;
    output_width_px : positive := 442;
    latency_clocks : positive := 73;
    flush_groups : positive := 4558;
    gap_groups : positive := 1800
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(23 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 450 report "stereo_core_census_450_dense: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_census_450_dense: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 48 report "stereo_core_census_450_dense: disparities is " & integer'image(disparities) & " but this core has 48" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_450_dense: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 24 report "stereo_core_census_450_dense: disparity_bits is " & integer'image(disparity_bits) & " but this core has 24" severity failure;
  assert output_width_px = 442 report "stereo_core_census_450_dense: output_width_px is " & integer'image(output_width_px) & " but this core has 442" severity failure;
  assert latency_clocks = 73 report "stereo_core_census_450_dense: latency_clocks is " & integer'image(latency_clocks) & " but this core has 73" severity failure;
  assert flush_groups = 4558 report "stereo_core_census_450_dense: flush_groups is " & integer'image(flush_groups) & " but this core has 4558" severity failure;
  assert gap_groups = 1800 report "stereo_core_census_450_dense: gap_groups is " & integer'image(gap_groups) & " but this core has 1800" severity failure;
end entity;

architecture rtl of stereo_core_census_450_dense is
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
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type integer_minus_24_to_24_1d is array (natural range <>) of integer range -24 to 24;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2047_2d is array (natural range <>, natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4096_1d is array (natural range <>) of natural range 0 to 4096;
  type natural_47_1d is array (natural range <>) of natural range 0 to 47;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_to_127_1d is array (natural range <>) of natural range 63 to 127;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column : natural_255_1d(0 to 4);
  signal transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column : natural_255_2d(0 to 8, 0 to 4);
  signal transform_right_filter_column : natural_255_2d(0 to 8, 0 to 4);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 4);
  signal transform_read_column_inside_0, transform_read_column_inside_2, transform_read_column_inside_4 : boolean;
  signal transform_read_column_inside_6, transform_read_column_inside_8, transform_read_start_of_frame : boolean;
  signal transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 4);
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 4);
  signal transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_column_inside_8 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag_valid, delay_tag_row_start, delay_tag_first_group, delay_tag_leaves_window : boolean;
  signal delay_tag_map_column, delay_tag_output_column, delay_tag_first_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words : unsigned_24_1d(0 to 8);
  signal rows_reference_rows_read_words : unsigned_24_1d(0 to 8);
  signal rows_search_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words : natural_16777215_1d(0 to 8);
  signal rows_search_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_write_words : natural_16777215_1d(0 to 8);
  signal rows_reference_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words : natural_16777215_1d(0 to 8);
  signal rows_reference_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words : natural_16777215_1d(0 to 8);
  signal rows_search : natural_16777215_1d(0 to 1);
  signal rows_reference : natural_16777215_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag_valid, rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_leaves_window : boolean;
  signal rows_read_tag_map_column, rows_read_tag_output_column, rows_read_tag_first_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_leaves_window, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_leaves_window : boolean;
  signal rows_tag_map_column, rows_tag_output_column, rows_tag_first_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice0shift_reference : natural_16777215_1d(0 to 1);
  signal slice0shift_search_out : natural_16777215_1d(0 to 1);
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_leaves_window, slice0shift_tag_map_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_first_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- slice0cost_pixels_first_#_#_count_#
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_map_column, slice0cost_pixels_first_tag_output_column : boolean;
  signal slice0cost_pixels_first_tag_first_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_map_column : boolean;
  signal slice0cost_pixels_tag_output_column, slice0cost_pixels_tag_first_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_row_start, slice0cost_ready_tag_first_group, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_map_column, slice0cost_ready_tag_output_column : boolean;
  signal slice0cost_ready_tag_first_column, slice0cost_ready_tag_start_of_frame : boolean;
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_row_start : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_leaves_window, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_first_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words : unsigned_32_1d(0 to 3);
  signal slice0cost_ready_words : unsigned_32_1d(0 to 3);
  signal slice0cost_write_words : unsigned_32_1d(0 to 3);
  signal slice0cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice0cost_column_0 : natural_255_1d(0 to 15);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_32_1d(0 to 3);
  signal slice0window_entering_0 : natural_255_1d(0 to 15);
  signal slice0window_entering_tag_valid, slice0window_entering_tag_row_start : boolean;
  signal slice0window_entering_tag_first_group, slice0window_entering_tag_leaves_window : boolean;
  signal slice0window_entering_tag_map_column, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_first_column, slice0window_entering_tag_start_of_frame : boolean;
  signal slice0window_entering_tag_end_of_line, slice0window_change_tag_valid : boolean;
  signal slice0window_change_tag_row_start, slice0window_change_tag_leaves_window : boolean;
  signal slice0window_change_tag_map_column, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_first_column, slice0window_change_tag_start_of_frame : boolean;
  signal slice0window_change_tag_end_of_line, slice0window_centre_map_column_0 : boolean;
  signal slice0window_centre_output_column : boolean_1d(0 to 3);
  signal slice0window_centre_first_column : boolean_1d(0 to 3);
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_3 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice0window_sum_0 : natural_2047_1d(0 to 15);
  -- slice0mask
  signal slice0mask_inside : boolean_1d(0 to 15);
  signal slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 511;
  -- slice0other
  signal slice0other_cost_0 : natural_2047_1d(0 to 15);
  signal slice0other_cost_out_0 : natural range 0 to 2047;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0_2 : natural range 0 to 2;
  signal slice0other_winner_0_3 : natural range 0 to 3;
  signal slice0other_winner_0_4 : natural range 0 to 4;
  signal slice0other_winner_0_5 : natural range 0 to 5;
  signal slice0other_winner_0_6 : natural range 0 to 6;
  signal slice0other_winner_0_7 : natural range 0 to 7;
  signal slice0other_winner_0_8 : natural range 0 to 8;
  signal slice0other_winner_0_9 : natural range 0 to 9;
  signal slice0other_winner_0_10 : natural range 0 to 10;
  signal slice0other_winner_0_11 : natural range 0 to 11;
  signal slice0other_winner_0_12 : natural range 0 to 12;
  signal slice0other_winner_0_13 : natural range 0 to 13;
  signal slice0other_winner_0_14 : natural range 0 to 14;
  signal slice0other_winner_0_15, slice0other_winner_out_0 : natural range 0 to 15;
  -- slice0winner1
  signal slice0winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice0winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_late_cost_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_but_first_0 : natural_2047_1d(1 to 7);
  signal slice0winner1_best_but_last_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_index_0_0, slice0winner1_best_place_0_2, slice0winner1_best_place_0_4 : boolean;
  signal slice0winner1_best_place_0_6, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_first_column, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_below_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_above_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_2047_1d(1 to 3);
  signal slice0winner2_best_last_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_late_cost_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_second_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_but_first_0 : natural_2047_1d(1 to 3);
  signal slice0winner2_best_but_last_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice0winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice0winner2_best_at_end_0 : boolean_1d(0 to 3);
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_first_column, slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_late_cost_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_second_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_but_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_but_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice0winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice0winner3_best_at_end_0 : boolean_1d(0 to 1);
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_output_column : boolean;
  signal slice0winner3_tag_start_of_frame, slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_above_0_0, slice0winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_late_cost_0_0, slice0winner4_best_second_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_but_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_place_0_0, slice0winner4_best_at_start_0_0, slice0winner4_best_at_end_0_0 : boolean;
  signal slice0winner4_tag_valid, slice0winner4_tag_map_column, slice0winner4_tag_output_column : boolean;
  signal slice0winner4_tag_start_of_frame, slice0winner4_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0 : natural range 0 to 2047;
  signal slice0_best_late_cost_0_0, slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 2047;
  signal slice0_best_place_0, slice0_best_tag_valid, slice0_best_tag_map_column : boolean;
  signal slice0_best_tag_output_column, slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice1shift_reference : natural_16777215_1d(0 to 1);
  signal slice1shift_search_out : natural_16777215_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- slice1cost_pixels_first_#_#_count_#
  signal slice1cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words : unsigned_32_1d(0 to 3);
  signal slice1cost_ready_words : unsigned_32_1d(0 to 3);
  signal slice1cost_write_words : unsigned_32_1d(0 to 3);
  signal slice1cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice1cost_column_0 : natural_255_1d(0 to 15);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_32_1d(0 to 3);
  signal slice1window_entering_0 : natural_255_1d(0 to 15);
  signal slice1window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice1window_change_tag_row_start, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_change_tag_output_column, slice1window_change_tag_first_column : boolean;
  signal slice1window_centre_map_column_0 : boolean;
  signal slice1window_centre_output_column : boolean_1d(0 to 3);
  signal slice1window_centre_first_column : boolean_1d(0 to 3);
  signal slice1window_centre_start_of_frame_0, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_tag_output_column, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0 : natural_2047_1d(0 to 15);
  -- slice1mask
  signal slice1mask_inside : boolean_1d(0 to 15);
  signal slice1mask_left_out : boolean;
  -- slice1other
  signal slice1other_cost_0 : natural_2047_1d(0 to 15);
  signal slice1other_cost_out_0 : natural range 0 to 2047;
  signal slice1other_winner_0_0 : natural range 0 to 16;
  signal slice1other_winner_0_1 : natural range 0 to 17;
  signal slice1other_winner_0_2 : natural range 0 to 18;
  signal slice1other_winner_0_3 : natural range 0 to 19;
  signal slice1other_winner_0_4 : natural range 0 to 20;
  signal slice1other_winner_0_5 : natural range 0 to 21;
  signal slice1other_winner_0_6 : natural range 0 to 22;
  signal slice1other_winner_0_7 : natural range 0 to 23;
  signal slice1other_winner_0_8 : natural range 0 to 24;
  signal slice1other_winner_0_9 : natural range 0 to 25;
  signal slice1other_winner_0_10 : natural range 0 to 26;
  signal slice1other_winner_0_11 : natural range 0 to 27;
  signal slice1other_winner_0_12 : natural range 0 to 28;
  signal slice1other_winner_0_13 : natural range 0 to 29;
  signal slice1other_winner_0_14 : natural range 0 to 30;
  signal slice1other_winner_0_15, slice1other_winner_out_0 : natural range 0 to 31;
  -- slice1winner1
  signal slice1winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice1winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_late_cost_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_but_first_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_but_last_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_index_0_0, slice1winner1_best_place_0_2, slice1winner1_best_place_0_4 : boolean;
  signal slice1winner1_best_place_0_6 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_below_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_above_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_first_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_last_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_late_cost_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_second_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_but_first_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_but_last_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  signal slice1winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice1winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice1winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_late_cost_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_second_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_but_first_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_but_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  signal slice1winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice1winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice1winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_above_0_0, slice1winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_last_0_0, slice1winner4_best_late_cost_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_second_0_0, slice1winner4_best_but_first_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_but_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_place_0_0, slice1winner4_best_at_start_0_0, slice1winner4_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_last_0_0, slice1_best_late_cost_0_0, slice1_best_second_0_0 : natural range 0 to 2047;
  signal slice1_best_but_last_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0, slice1_best_tag_valid : boolean;
  signal slice1_best_tag_map_column, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice2shift_reference : natural_16777215_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- slice2cost_pixels_first_#_#_count_#
  signal slice2cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words : unsigned_32_1d(0 to 3);
  signal slice2cost_ready_words : unsigned_32_1d(0 to 3);
  signal slice2cost_write_words : unsigned_32_1d(0 to 3);
  signal slice2cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice2cost_column_0 : natural_255_1d(0 to 15);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving : unsigned_32_1d(0 to 3);
  signal slice2window_entering_0 : natural_255_1d(0 to 15);
  signal slice2window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice2window_change_tag_row_start, slice2window_change_tag_output_column : boolean;
  signal slice2window_change_tag_first_column : boolean;
  signal slice2window_centre_map_column : boolean_1d(0 to 2);
  signal slice2window_centre_output_column : boolean_1d(0 to 2);
  signal slice2window_centre_first_column : boolean_1d(0 to 2);
  signal slice2window_centre_start_of_frame_0 : boolean;
  signal slice2window_centre_end_of_line : boolean_1d(0 to 2);
  signal slice2window_sum_0 : natural_2047_1d(0 to 15);
  -- slice2mask
  signal slice2mask_inside : boolean_1d(0 to 15);
  -- slice2other
  signal slice2other_cost_0 : natural_2047_1d(0 to 14);
  signal slice2other_winner_0_0 : natural range 0 to 32;
  signal slice2other_winner_0_1 : natural range 0 to 33;
  signal slice2other_winner_0_2 : natural range 0 to 34;
  signal slice2other_winner_0_3 : natural range 0 to 35;
  signal slice2other_winner_0_4 : natural range 0 to 36;
  signal slice2other_winner_0_5 : natural range 0 to 37;
  signal slice2other_winner_0_6 : natural range 0 to 38;
  signal slice2other_winner_0_7 : natural range 0 to 39;
  signal slice2other_winner_0_8 : natural range 0 to 40;
  signal slice2other_winner_0_9 : natural range 0 to 41;
  signal slice2other_winner_0_10 : natural range 0 to 42;
  signal slice2other_winner_0_11 : natural range 0 to 43;
  signal slice2other_winner_0_12 : natural range 0 to 44;
  signal slice2other_winner_0_13 : natural range 0 to 45;
  signal slice2other_winner_0_14 : natural range 0 to 46;
  signal slice2other_winner_0_15, slice2other_winner_out_0 : natural range 0 to 47;
  -- slice2winner1
  signal slice2winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice2winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_late_cost_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_but_first_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_but_last_0 : natural_2047_1d(0 to 6);
  signal slice2winner1_best_index_0_0, slice2winner1_best_place_0_2, slice2winner1_best_place_0_4 : boolean;
  signal slice2winner1_best_place_0_6 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_below_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_above_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_first_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_last_0 : natural_2047_1d(0 to 2);
  signal slice2winner2_best_late_cost_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_second_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_but_first_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_but_last_0 : natural_2047_1d(0 to 2);
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  signal slice2winner2_best_place_0 : boolean_1d(0 to 3);
  signal slice2winner2_best_at_start_0 : boolean_1d(0 to 3);
  signal slice2winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_late_cost_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_second_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_but_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_but_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  signal slice2winner3_best_place_0 : boolean_1d(0 to 1);
  signal slice2winner3_best_at_start_0 : boolean_1d(0 to 1);
  signal slice2winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_above_0_0, slice2winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_late_cost_0_0, slice2winner4_best_second_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_but_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_place_0_0, slice2winner4_best_at_start_0_0, slice2winner4_best_at_end_0_0 : boolean;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0 : natural range 0 to 2047;
  signal slice2_best_late_cost_0_0, slice2_best_second_0_0 : natural range 0 to 2047;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0, slice2_best_tag_valid : boolean;
  signal slice2_best_tag_map_column, slice2_best_tag_output_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0 : natural_47_1d(0 to 11);  -- refinement_disparity_#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- refinement_tag_#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- refinement_tag_#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- refinement_tag_#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- refinement_tag_#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- refinement_tag_#_end_of_line
  signal refinement_alone_0_0 : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- refinement_negative_#_0
  signal refinement_gap_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 2047;
  signal refinement_v_0 : natural range 0 to 2047;
  signal refinement_remainder_0 : natural_2047_1d(0 to 7);  -- refinement_remainder_#_0
  signal refinement_divisor_0 : natural_2047_1d(0 to 7);  -- refinement_divisor_#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- refinement_margin_#_0
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_0 : natural_47_1d(1 to 15);  -- leftright_other_#_0
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_position : natural range 0 to 63;
  signal leftright_held_position, leftright_address_0, leftright_asking_disparity_0 : natural range 0 to 63;
  signal leftright_asking_margin_0, leftright_answered_disparity_0, leftright_answered_margin_0 : natural range 0 to 63;
  signal leftright_checked_disparity_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_tag_valid : boolean;
  signal leftright_answered_tag_map_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_row_start, leftright_checked_tag_map_column : boolean;
  signal leftright_checked_tag_start_of_frame, leftright_checked_tag_end_of_line : boolean;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1, leftright_found_0 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  -- support
  signal support_counter_column, support_counter_group, support_read_column : natural range 0 to 511;
  signal support_ready_column, support_write_column : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- support_centre_#_0
  signal support_newest_rest_0, support_rest_rows_read_newest_0 : natural range 0 to 1023;
  signal support_rest_rows_ready_newest_0, support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- support_rest_#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- support_centre_rest_#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_moves, support_arrives, support_last, support_read_moves, support_read_arrives : boolean;
  signal support_read_above2, support_read_above1, support_read_below1, support_read_below2 : boolean;
  signal support_read_first, support_read_last, support_ready_moves, support_ready_arrives : boolean;
  signal support_ready_above2, support_ready_above1, support_ready_below1, support_ready_below2 : boolean;
  signal support_ready_first, support_ready_last, support_at_moves, support_at_arrives, support_at_first : boolean;
  signal support_at_last : boolean;
  signal support_row_tag : boolean_1d(0 to 12);
  signal support_moment_map_column : boolean_1d(0 to 6);  -- support_moment_#_map_column
  signal support_moment_start_of_frame : boolean_1d(0 to 6);  -- support_moment_#_start_of_frame
  signal support_moment_last : boolean_1d(0 to 6);  -- support_moment_#_last
  signal support_next_tag, support_moved : boolean;
  signal support_like_0 : boolean_2d(0 to 6, 0 to 4);
  signal support_enough_0 : boolean;
  signal support_centre_moment_map_column : boolean_1d(0 to 3);  -- support_centre_moment_#_map_column
  signal support_centre_moment_start_of_frame : boolean_1d(0 to 3);  -- support_centre_moment_#_start_of_frame
  signal support_centre_moment_last : boolean_1d(0 to 3);  -- support_centre_moment_#_last
  signal support_centre_moved : boolean_1d(0 to 3);
  signal support_out_passed_0, support_out_tag_valid, support_out_tag_row_start, support_out_tag_map_column : boolean;
  signal support_out_tag_start_of_frame, support_out_tag_end_of_line : boolean;
  signal support_rows_read_words_0 : unsigned(27 downto 0);
  signal support_rows_ready_words_0, support_rows_write_words_0 : natural range 0 to 268435455;
  signal support_rest_rows_read_words_0 : unsigned(19 downto 0);
  signal support_rest_rows_ready_words_0, support_rest_rows_write_words_0 : natural range 0 to 1048575;
  signal support_partial_0 : natural_5_1d(0 to 6);
  signal support_count_0 : natural range 0 to 35;
  signal support_sum_0 : natural range 0 to 273;
  signal support_out_sure_0 : natural range 0 to 255;
  -- fill
  signal fill_counter_column, fill_counter_group, fill_read_column, fill_ready_column : natural range 0 to 511;
  signal fill_write_column, fill_at_column : natural range 0 to 511;
  signal fill_asking_at_column : natural_511_1d(0 to 1);  -- fill_asking_at_#_column
  signal fill_known_at_column, fill_beside_0_left_column, fill_beside_0_right_column : natural range 0 to 511;
  signal fill_measured_at_column, fill_measured_beside_0_right_column, fill_width_0 : natural range 0 to 511;
  signal fill_chosen_at_column, fill_write_above_column : natural range 0 to 511;
  signal fill_newest_disparity_0, fill_pixel_0_disparity : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- fill_asking_#_0_disparity
  signal fill_known_0_disparity, fill_beside_0_left, fill_beside_0_right : natural range 0 to 1023;
  signal fill_measured_0_disparity, fill_measured_beside_0_left, fill_measured_beside_0_right : natural range 0 to 1023;
  signal fill_chosen_0_disparity, fill_chosen_beside_0_left, fill_chosen_beside_0_right : natural range 0 to 1023;
  signal fill_newest_passed_0, fill_moves, fill_arrives, fill_last, fill_read_moves, fill_read_arrives : boolean;
  signal fill_read_top, fill_read_last, fill_ready_moves, fill_ready_arrives, fill_ready_top, fill_ready_last : boolean;
  signal fill_ends_open_0, fill_pixel_0_passed, fill_at_moves, fill_at_arrives, fill_at_top, fill_at_last : boolean;
  signal fill_in_hole_0 : boolean;
  signal fill_asking_0_passed : boolean_1d(0 to 1);  -- fill_asking_#_0_passed
  signal fill_asking_at_moves : boolean_1d(0 to 1);  -- fill_asking_at_#_moves
  signal fill_asking_at_arrives : boolean_1d(0 to 1);  -- fill_asking_at_#_arrives
  signal fill_asking_at_top : boolean_1d(0 to 1);  -- fill_asking_at_#_top
  signal fill_asking_at_last : boolean_1d(0 to 1);  -- fill_asking_at_#_last
  signal fill_hole_starts_0 : boolean_1d(0 to 1);  -- fill_hole_starts_#_0
  signal fill_known_0_passed, fill_known_at_moves, fill_known_at_arrives, fill_known_at_top : boolean;
  signal fill_known_at_last, fill_beside_0_has_left, fill_beside_0_has_right, fill_measured_0_passed : boolean;
  signal fill_measured_at_moves, fill_measured_at_arrives, fill_measured_at_top, fill_measured_at_last : boolean;
  signal fill_measured_beside_0_has_left, fill_measured_beside_0_has_right, fill_rises_0 : boolean;
  signal fill_chosen_0_passed, fill_chosen_at_moves, fill_chosen_at_arrives, fill_chosen_at_top : boolean;
  signal fill_chosen_at_last, fill_chosen_beside_0_has_left, fill_chosen_beside_0_has_right : boolean;
  signal fill_takes_left_0, fill_out_passed_0, fill_out_filled_0, fill_out_tag_valid, fill_out_tag_row_start : boolean;
  signal fill_out_tag_map_column, fill_out_tag_start_of_frame, fill_out_tag_end_of_line, fill_has_values : boolean;
  signal fill_had_values : boolean;
  signal fill_newest_sure_0, fill_ends_next_place_0, fill_ends_row_place_0 : natural range 0 to 255;
  signal fill_ends_row_above_place_0, fill_ends_write_place_0, fill_ends_read_place_0 : natural range 0 to 255;
  signal fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- fill_asking_#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0 : natural range 0 to 524287;
  signal fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 1048575;
  signal fill_ends_read_words_0 : unsigned(19 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_counter_group, median_read_column, median_ready_column : natural range 0 to 511;
  signal median_write_column, median_at_column, median_comparing_column, median_sorted_column : natural range 0 to 511;
  signal median_beside_newest_0, median_beside_rows_read_newest_0 : natural range 0 to 511;
  signal median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0 : natural range 0 to 511;
  signal median_beside_rows_write_words_0, median_beside_column_0 : natural range 0 to 511;
  signal median_beside_of_column_0 : natural_511_1d(0 to 1);  -- median_beside_of_column_#_0
  signal median_beside_in_window_0 : natural_511_1d(0 to 1);  -- median_beside_in_window_#_0
  signal median_beside_waiting_0 : natural_511_1d(0 to 2);  -- median_beside_waiting_#_0
  signal median_counter_next_frame, median_arrives, median_behind, median_line_ended, median_read_arrives : boolean;
  signal median_read_behind, median_read_top, median_read_bottom, median_read_output, median_ready_arrives : boolean;
  signal median_ready_behind, median_ready_top, median_ready_output, median_at_arrives, median_at_behind : boolean;
  signal median_at_top, median_at_output, median_of_column_0_b_below_a, median_of_column_0_c_below_a : boolean;
  signal median_of_column_0_c_below_b : boolean;
  signal median_column_passed_0 : boolean_1d(0 to 1);  -- median_column_passed_#_0
  signal median_comparing_arrives, median_comparing_behind, median_comparing_top, median_comparing_output : boolean;
  signal median_sorted_arrives, median_sorted_behind, median_sorted_top, median_sorted_output : boolean;
  signal median_passed_0 : boolean_1d(0 to 1);  -- median_passed_#_0
  signal median_window_complete, median_window_first, median_window_last, median_of_low_0_b_below_a : boolean;
  signal median_of_low_0_c_below_a, median_of_low_0_c_below_b, median_of_middle_0_b_below_a : boolean;
  signal median_of_middle_0_c_below_a, median_of_middle_0_c_below_b, median_of_high_0_b_below_a : boolean;
  signal median_of_high_0_c_below_a, median_of_high_0_c_below_b, median_of_all_0_b_below_a : boolean;
  signal median_of_all_0_c_below_a, median_of_all_0_c_below_b : boolean;
  signal median_waiting_complete : boolean_1d(0 to 2);  -- median_waiting_#_complete
  signal median_waiting_first : boolean_1d(0 to 2);  -- median_waiting_#_first
  signal median_waiting_last : boolean_1d(0 to 2);  -- median_waiting_#_last
  signal median_waiting_passed_0 : boolean_1d(0 to 2);  -- median_waiting_passed_#_0
  signal median_out_passed_0, median_out_filled_0, median_out_valid, median_out_start_of_frame : boolean;
  signal median_out_end_of_line : boolean;
  signal median_newest_0, median_rows_read_newest_0, median_rows_ready_newest_0 : natural range 0 to 65535;
  signal median_column_2 : natural range 0 to 65535;
  signal median_rows_read_words_0 : unsigned(25 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 67108863;
  signal median_rows_write_words_0 : natural range 0 to 536870911;
  signal median_column_1 : natural range 0 to 8191;
  signal median_of_column_0_a, median_of_column_0_b : natural range 0 to 4095;
  signal median_of_column_0_c, median_sorted_low_0, median_sorted_middle_0 : natural range 0 to 32767;
  signal median_sorted_high_0 : natural range 0 to 32767;
  signal median_low_0 : natural_32767_1d(0 to 2);  -- median_low_#_0
  signal median_middle_0 : natural_32767_1d(0 to 2);  -- median_middle_#_0
  signal median_high_0 : natural_32767_1d(0 to 2);  -- median_high_#_0
  signal median_of_low_0_a, median_of_low_0_b, median_of_low_0_c, median_of_middle_0_a : natural range 0 to 32767;
  signal median_of_middle_0_b, median_of_middle_0_c, median_of_high_0_a, median_of_high_0_b : natural range 0 to 32767;
  signal median_of_high_0_c, median_largest_low_0, median_median_middle_0 : natural range 0 to 32767;
  signal median_smallest_high_0, median_of_all_0_a, median_of_all_0_b, median_of_all_0_c : natural range 0 to 32767;
  signal median_out_disparity_0 : natural range 0 to 32767;
  signal median_beside_rows_read_words_0 : unsigned(8 downto 0);
  signal median_out_confidence_0 : natural range 0 to 255;
  -- other
  signal other_0 : boolean;
  signal other_1 : natural range 0 to 8190;
  signal other_2 : natural range 0 to 15;
  signal other_3 : natural range 0 to 63;
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;
  signal other : natural_4096_1d(11 to 22);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal median_beside_rows_read_words_0_memory_read_enable : boolean;
  signal median_beside_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal median_beside_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal median_beside_rows_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_read_enable : boolean;
  signal median_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal fill_above_read_0_memory_read_enable : boolean;
  signal fill_above_read_0_memory_read_address, fill_above_read_0_memory_write_address : unsigned(8 downto 0);
  signal fill_above_read_0_memory_write_data : unsigned(15 downto 0);
  signal fill_ends_read_words_0_memory_read_enable : boolean;
  signal fill_ends_read_words_0_memory_read_address, fill_ends_read_words_0_memory_write_address : unsigned(7 downto 0);
  signal fill_ends_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal fill_rows_read_words_0_memory_read_enable : boolean;
  signal fill_rows_read_words_0_memory_read_address, fill_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal fill_rows_read_words_0_memory_write_data : unsigned(18 downto 0);
  signal support_rows_read_words_0_memory_read_enable : boolean;
  signal support_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal support_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal support_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal support_rest_rows_read_words_0_memory_read_enable : boolean;
  signal support_rest_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal support_rest_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal support_rest_rows_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address, leftright_found_0_memory_write_address : unsigned(5 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(5 downto 0);
  signal leftright_held_1_memory_read_enable : boolean;
  signal leftright_held_1_memory_read_address, leftright_held_1_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_1_memory_write_data : unsigned(5 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address, leftright_held_0_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address, slice2window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address, slice2window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address, slice2window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address, slice2window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_3_memory_read_enable : boolean;
  signal slice2cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_2_memory_read_enable : boolean;
  signal slice2cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address, slice1window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address, slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address, slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address, slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address, slice0window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address, slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address, slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address, slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_8_memory_read_enable : boolean;
  signal rows_search_rows_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_8_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_7_memory_read_enable : boolean;
  signal rows_search_rows_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_7_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_6_memory_read_enable : boolean;
  signal rows_search_rows_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_6_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_5_memory_read_enable : boolean;
  signal rows_search_rows_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_5_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_4_memory_read_enable : boolean;
  signal rows_search_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_3_memory_read_enable : boolean;
  signal rows_search_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_8_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_7_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_6_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_5_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_4_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_3_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(unsigned'(to_unsigned(median_out_confidence_0, 8) & to_unsigned(as_number(median_out_filled_0), 1) & to_unsigned(median_out_disparity_0, 15)));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  median_beside_rows_read_words_0_memory_read_enable <= true;
  median_beside_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 9);
  median_beside_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 9);
  median_beside_rows_read_words_0_memory_write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
  median_beside_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 9, address_bits => 9)
    port map (
      clock => clock, read_enable => median_beside_rows_read_words_0_memory_read_enable,
      read_address => median_beside_rows_read_words_0_memory_read_address, read_data => median_beside_rows_read_words_0,
      write_address => median_beside_rows_read_words_0_memory_write_address, write_data => median_beside_rows_read_words_0_memory_write_data);

  median_rows_read_words_0_memory_read_enable <= true;
  median_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 9);
  median_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 9);
  median_rows_read_words_0_memory_write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
  median_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 26, address_bits => 9)
    port map (
      clock => clock, read_enable => median_rows_read_words_0_memory_read_enable,
      read_address => median_rows_read_words_0_memory_read_address, read_data => median_rows_read_words_0,
      write_address => median_rows_read_words_0_memory_write_address, write_data => median_rows_read_words_0_memory_write_data);

  fill_above_read_0_memory_read_enable <= true;
  fill_above_read_0_memory_read_address <= to_unsigned(fill_known_at_column, 9);
  fill_above_read_0_memory_write_address <= to_unsigned(fill_write_above_column, 9);
  fill_above_read_0_memory_write_data <= to_unsigned(fill_write_above_0, 16);
  fill_above_read_0_memory : entity work.line_memory
    generic map (depth => 442, width => 16, address_bits => 9)
    port map (
      clock => clock, read_enable => fill_above_read_0_memory_read_enable,
      read_address => fill_above_read_0_memory_read_address, read_data => fill_above_read_0,
      write_address => fill_above_read_0_memory_write_address, write_data => fill_above_read_0_memory_write_data);

  fill_ends_read_words_0_memory_read_enable <= true;
  fill_ends_read_words_0_memory_read_address <= to_unsigned(fill_ends_read_place_0, 8);
  fill_ends_read_words_0_memory_write_address <= to_unsigned(fill_ends_write_place_0, 8);
  fill_ends_read_words_0_memory_write_data <= to_unsigned(fill_ends_write_words_0, 20);
  fill_ends_read_words_0_memory : entity work.line_memory
    generic map (depth => 225, width => 20, address_bits => 8)
    port map (
      clock => clock, read_enable => fill_ends_read_words_0_memory_read_enable,
      read_address => fill_ends_read_words_0_memory_read_address, read_data => fill_ends_read_words_0,
      write_address => fill_ends_read_words_0_memory_write_address, write_data => fill_ends_read_words_0_memory_write_data);

  fill_rows_read_words_0_memory_read_enable <= true;
  fill_rows_read_words_0_memory_read_address <= to_unsigned(fill_counter_column, 9);
  fill_rows_read_words_0_memory_write_address <= to_unsigned(fill_at_column, 9);
  fill_rows_read_words_0_memory_write_data <= to_unsigned(fill_rows_write_words_0, 19);
  fill_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 19, address_bits => 9)
    port map (
      clock => clock, read_enable => fill_rows_read_words_0_memory_read_enable,
      read_address => fill_rows_read_words_0_memory_read_address, read_data => fill_rows_read_words_0,
      write_address => fill_rows_read_words_0_memory_write_address, write_data => fill_rows_read_words_0_memory_write_data);

  support_rows_read_words_0_memory_read_enable <= true;
  support_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 9);
  support_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 9);
  support_rows_read_words_0_memory_write_data <= to_unsigned(support_rows_write_words_0, 28);
  support_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => support_rows_read_words_0_memory_read_enable,
      read_address => support_rows_read_words_0_memory_read_address, read_data => support_rows_read_words_0,
      write_address => support_rows_read_words_0_memory_write_address, write_data => support_rows_read_words_0_memory_write_data);

  support_rest_rows_read_words_0_memory_read_enable <= true;
  support_rest_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 9);
  support_rest_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 9);
  support_rest_rows_read_words_0_memory_write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
  support_rest_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 20, address_bits => 9)
    port map (
      clock => clock, read_enable => support_rest_rows_read_words_0_memory_read_enable,
      read_address => support_rest_rows_read_words_0_memory_read_address, read_data => support_rest_rows_read_words_0,
      write_address => support_rest_rows_read_words_0_memory_write_address, write_data => support_rest_rows_read_words_0_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 6);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 6);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_0(15), 6);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 64, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_1_memory_read_enable <= true;
  leftright_held_1_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_1_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_1_memory_write_data <= to_unsigned(refinement_margin_0(9), 6);
  leftright_held_1_memory : entity work.line_memory
    generic map (depth => 48, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_1_memory_read_enable,
      read_address => leftright_held_1_memory_read_address, read_data => leftright_held_1,
      write_address => leftright_held_1_memory_write_address, write_data => leftright_held_1_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_0_memory_write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned((other(11) / 4096), 1) & to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) & to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) & to_unsigned(as_number(refinement_tag_output_column(11)), 1) & to_unsigned(as_number(refinement_tag_map_column(11)), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 48, width => 18, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0(15), 8) & to_unsigned(slice2cost_column_0(14), 8) & to_unsigned(slice2cost_column_0(13), 8) & to_unsigned(slice2cost_column_0(12), 8);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving(3),
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0(11), 8) & to_unsigned(slice2cost_column_0(10), 8) & to_unsigned(slice2cost_column_0(9), 8) & to_unsigned(slice2cost_column_0(8), 8);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving(2),
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0(7), 8) & to_unsigned(slice2cost_column_0(6), 8) & to_unsigned(slice2cost_column_0(5), 8) & to_unsigned(slice2cost_column_0(4), 8);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving(1),
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0(3), 8) & to_unsigned(slice2cost_column_0(2), 8) & to_unsigned(slice2cost_column_0(1), 8) & to_unsigned(slice2cost_column_0(0), 8);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving(0),
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_3_memory_write_data <= slice2cost_write_words(3);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words(3),
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_2_memory_write_data <= slice2cost_write_words(2);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words(2),
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_1_memory_write_data <= slice2cost_write_words(1);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words(1),
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_0_memory_write_data <= slice2cost_write_words(0);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words(0),
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0(15), 8) & to_unsigned(slice1cost_column_0(14), 8) & to_unsigned(slice1cost_column_0(13), 8) & to_unsigned(slice1cost_column_0(12), 8);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving(3),
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0(11), 8) & to_unsigned(slice1cost_column_0(10), 8) & to_unsigned(slice1cost_column_0(9), 8) & to_unsigned(slice1cost_column_0(8), 8);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving(2),
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0(7), 8) & to_unsigned(slice1cost_column_0(6), 8) & to_unsigned(slice1cost_column_0(5), 8) & to_unsigned(slice1cost_column_0(4), 8);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving(1),
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0(3), 8) & to_unsigned(slice1cost_column_0(2), 8) & to_unsigned(slice1cost_column_0(1), 8) & to_unsigned(slice1cost_column_0(0), 8);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving(0),
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_3_memory_write_data <= slice1cost_write_words(3);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words(3),
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_2_memory_write_data <= slice1cost_write_words(2);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words(2),
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_1_memory_write_data <= slice1cost_write_words(1);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words(1),
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_0_memory_write_data <= slice1cost_write_words(0);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words(0),
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0(15), 8) & to_unsigned(slice0cost_column_0(14), 8) & to_unsigned(slice0cost_column_0(13), 8) & to_unsigned(slice0cost_column_0(12), 8);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving(3),
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0(11), 8) & to_unsigned(slice0cost_column_0(10), 8) & to_unsigned(slice0cost_column_0(9), 8) & to_unsigned(slice0cost_column_0(8), 8);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving(2),
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0(7), 8) & to_unsigned(slice0cost_column_0(6), 8) & to_unsigned(slice0cost_column_0(5), 8) & to_unsigned(slice0cost_column_0(4), 8);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving(1),
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0(3), 8) & to_unsigned(slice0cost_column_0(2), 8) & to_unsigned(slice0cost_column_0(1), 8) & to_unsigned(slice0cost_column_0(0), 8);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving(0),
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_3_memory_write_data <= slice0cost_write_words(3);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words(3),
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_2_memory_write_data <= slice0cost_write_words(2);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words(2),
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_1_memory_write_data <= slice0cost_write_words(1);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words(1),
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_0_memory_write_data <= slice0cost_write_words(0);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words(0),
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_8_memory_read_enable <= true;
  rows_search_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_8_memory_write_data <= to_unsigned(rows_search_rows_write_words(8), 24);
  rows_search_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_8_memory_read_enable,
      read_address => rows_search_rows_read_words_8_memory_read_address, read_data => rows_search_rows_read_words(8),
      write_address => rows_search_rows_read_words_8_memory_write_address, write_data => rows_search_rows_read_words_8_memory_write_data);

  rows_search_rows_read_words_7_memory_read_enable <= true;
  rows_search_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_7_memory_write_data <= to_unsigned(rows_search_rows_write_words(7), 24);
  rows_search_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_7_memory_read_enable,
      read_address => rows_search_rows_read_words_7_memory_read_address, read_data => rows_search_rows_read_words(7),
      write_address => rows_search_rows_read_words_7_memory_write_address, write_data => rows_search_rows_read_words_7_memory_write_data);

  rows_search_rows_read_words_6_memory_read_enable <= true;
  rows_search_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_6_memory_write_data <= to_unsigned(rows_search_rows_write_words(6), 24);
  rows_search_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_6_memory_read_enable,
      read_address => rows_search_rows_read_words_6_memory_read_address, read_data => rows_search_rows_read_words(6),
      write_address => rows_search_rows_read_words_6_memory_write_address, write_data => rows_search_rows_read_words_6_memory_write_data);

  rows_search_rows_read_words_5_memory_read_enable <= true;
  rows_search_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_5_memory_write_data <= to_unsigned(rows_search_rows_write_words(5), 24);
  rows_search_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_5_memory_read_enable,
      read_address => rows_search_rows_read_words_5_memory_read_address, read_data => rows_search_rows_read_words(5),
      write_address => rows_search_rows_read_words_5_memory_write_address, write_data => rows_search_rows_read_words_5_memory_write_data);

  rows_search_rows_read_words_4_memory_read_enable <= true;
  rows_search_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_4_memory_write_data <= to_unsigned(rows_search_rows_write_words(4), 24);
  rows_search_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_4_memory_read_enable,
      read_address => rows_search_rows_read_words_4_memory_read_address, read_data => rows_search_rows_read_words(4),
      write_address => rows_search_rows_read_words_4_memory_write_address, write_data => rows_search_rows_read_words_4_memory_write_data);

  rows_search_rows_read_words_3_memory_read_enable <= true;
  rows_search_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_3_memory_write_data <= to_unsigned(rows_search_rows_write_words(3), 24);
  rows_search_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_3_memory_read_enable,
      read_address => rows_search_rows_read_words_3_memory_read_address, read_data => rows_search_rows_read_words(3),
      write_address => rows_search_rows_read_words_3_memory_write_address, write_data => rows_search_rows_read_words_3_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words(2), 24);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words(2),
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words(1), 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words(1),
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words(0), 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words(0),
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_8_memory_read_enable <= true;
  rows_reference_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_8_memory_write_data <= to_unsigned(rows_reference_rows_write_words(8), 24);
  rows_reference_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_8_memory_read_enable,
      read_address => rows_reference_rows_read_words_8_memory_read_address, read_data => rows_reference_rows_read_words(8),
      write_address => rows_reference_rows_read_words_8_memory_write_address, write_data => rows_reference_rows_read_words_8_memory_write_data);

  rows_reference_rows_read_words_7_memory_read_enable <= true;
  rows_reference_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_7_memory_write_data <= to_unsigned(rows_reference_rows_write_words(7), 24);
  rows_reference_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_7_memory_read_enable,
      read_address => rows_reference_rows_read_words_7_memory_read_address, read_data => rows_reference_rows_read_words(7),
      write_address => rows_reference_rows_read_words_7_memory_write_address, write_data => rows_reference_rows_read_words_7_memory_write_data);

  rows_reference_rows_read_words_6_memory_read_enable <= true;
  rows_reference_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_6_memory_write_data <= to_unsigned(rows_reference_rows_write_words(6), 24);
  rows_reference_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_6_memory_read_enable,
      read_address => rows_reference_rows_read_words_6_memory_read_address, read_data => rows_reference_rows_read_words(6),
      write_address => rows_reference_rows_read_words_6_memory_write_address, write_data => rows_reference_rows_read_words_6_memory_write_data);

  rows_reference_rows_read_words_5_memory_read_enable <= true;
  rows_reference_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_5_memory_write_data <= to_unsigned(rows_reference_rows_write_words(5), 24);
  rows_reference_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_5_memory_read_enable,
      read_address => rows_reference_rows_read_words_5_memory_read_address, read_data => rows_reference_rows_read_words(5),
      write_address => rows_reference_rows_read_words_5_memory_write_address, write_data => rows_reference_rows_read_words_5_memory_write_data);

  rows_reference_rows_read_words_4_memory_read_enable <= true;
  rows_reference_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_4_memory_write_data <= to_unsigned(rows_reference_rows_write_words(4), 24);
  rows_reference_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_4_memory_read_enable,
      read_address => rows_reference_rows_read_words_4_memory_read_address, read_data => rows_reference_rows_read_words(4),
      write_address => rows_reference_rows_read_words_4_memory_write_address, write_data => rows_reference_rows_read_words_4_memory_write_data);

  rows_reference_rows_read_words_3_memory_read_enable <= true;
  rows_reference_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_3_memory_write_data <= to_unsigned(rows_reference_rows_write_words(3), 24);
  rows_reference_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_3_memory_read_enable,
      read_address => rows_reference_rows_read_words_3_memory_read_address, read_data => rows_reference_rows_read_words(3),
      write_address => rows_reference_rows_read_words_3_memory_write_address, write_data => rows_reference_rows_read_words_3_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words(2), 24);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words(2),
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words(1), 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words(1),
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words(0), 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words(0),
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_read_column_inside_0_is_less, transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_any, transform_left_filter_feature_0_choice : boolean;
    variable transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 193);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_left_filter_feature_0_value_#
    variable transform_right_filter_feature_0_value, transform_right_filter_feature_0_any : boolean;
    variable transform_right_filter_feature_0_choice, transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 193);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_right_filter_feature_0_value_#
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable raster_place_group_is_equal, delay_tag_map_column_is_less, delay_tag_first_column_is_equal : boolean;
    variable slice0cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice0cost_pixels_first_#_0_count_#_value
    variable slice0cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice0cost_pixels_first_#_0_count_#_value_2
    variable slice0cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice0cost_pixels_first_#_0_count_1_value_3
    variable slice0cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice0cost_pixels_first_#_0_count_#_value_3
    variable slice0mask_inside_choice : boolean_1d(0 to 15);  -- slice0mask_inside_#_choice
    variable slice0other_cost_0_choice : boolean_1d(1 to 15);  -- slice0other_cost_0_#_choice
    variable slice0other_cost_0_15_all : boolean;
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice0winner1_best_cost_0_#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice0winner2_best_cost_0_#_is_less
    variable slice0winner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- slice0winner2_best_below_0_#_is_equal
    variable slice0winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice0winner3_best_cost_0_#_is_less
    variable slice0winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice0winner3_best_below_0_#_is_equal
    variable slice0winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice0winner3_best_above_0_#_is_equal
    variable slice0winner4_best_cost_0_0_is_less, slice0winner4_best_below_0_0_is_equal : boolean;
    variable slice0winner4_best_above_0_0_is_equal : boolean;
    variable slice1cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice1cost_pixels_first_#_0_count_#_value
    variable slice1cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice1cost_pixels_first_#_0_count_#_value_2
    variable slice1cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice1cost_pixels_first_#_0_count_1_value_3
    variable slice1cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice1cost_pixels_first_#_0_count_#_value_3
    variable slice1mask_inside_0_all : boolean;
    variable slice1mask_inside_choice : boolean_1d(0 to 15);  -- slice1mask_inside_#_choice
    variable slice1other_cost_0_choice : boolean_1d(0 to 15);  -- slice1other_cost_0_#_choice
    variable slice1other_cost_0_15_all : boolean;
    variable slice1winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice1winner1_best_cost_0_#_is_less
    variable slice1winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice1winner2_best_cost_0_#_is_less
    variable slice1winner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- slice1winner2_best_below_0_#_is_equal
    variable slice1winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice1winner3_best_cost_0_#_is_less
    variable slice1winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice1winner3_best_below_0_#_is_equal
    variable slice1winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice1winner3_best_above_0_#_is_equal
    variable slice1winner4_best_cost_0_0_is_less, slice1winner4_best_below_0_0_is_equal : boolean;
    variable slice1winner4_best_above_0_0_is_equal, slice1_best_cost_0_0_is_less : boolean;
    variable slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal : boolean;
    variable slice2cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice2cost_pixels_first_#_0_count_#_value
    variable slice2cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice2cost_pixels_first_#_0_count_#_value_2
    variable slice2cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice2cost_pixels_first_#_0_count_1_value_3
    variable slice2cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice2cost_pixels_first_#_0_count_#_value_3
    variable slice2mask_inside_0_all : boolean;
    variable slice2mask_inside_choice : boolean_1d(0 to 15);  -- slice2mask_inside_#_choice
    variable slice2other_cost_0_choice : boolean_1d(0 to 14);  -- slice2other_cost_0_#_choice
    variable slice2other_winner_0_15_choice : boolean;
    variable slice2winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice2winner1_best_cost_0_#_is_less
    variable slice2winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice2winner2_best_cost_0_#_is_less
    variable slice2winner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- slice2winner2_best_below_0_#_is_equal
    variable slice2winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice2winner3_best_cost_0_#_is_less
    variable slice2winner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- slice2winner3_best_below_0_#_is_equal
    variable slice2winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- slice2winner3_best_above_0_#_is_equal
    variable slice2winner4_best_cost_0_0_is_less, slice2winner4_best_below_0_0_is_equal : boolean;
    variable slice2winner4_best_above_0_0_is_equal, slice2_best_cost_0_0_is_less : boolean;
    variable slice2_best_below_0_0_is_equal, slice2_best_above_0_0_is_equal, refinement_below_0_differs : boolean;
    variable refinement_below_0_value, refinement_below_0_value_2, refinement_below_0_choice : boolean;
    variable refinement_above_0_differs, refinement_above_0_choice, refinement_divisor_0_0_is_less : boolean;
    variable leftright_holds_winners_choice, leftright_checked_tag_row_start_differs : boolean;
    variable leftright_checked_tag_row_start_is_equal, leftright_checked_tag_row_start_choice : boolean;
    variable leftright_checked_tag_row_start_choices : boolean_1d(2 to 3);  -- leftright_checked_tag_row_start_choice_#
    variable leftright_checked_tag_row_start_is_equal_2, leftright_checked_tag_row_start_all : boolean;
    variable leftright_checked_tag_row_start_all_2, support_moment_0_start_of_frame_choice : boolean;
    variable support_next_tag_choice, support_next_tag_choice_2 : boolean;
    variable support_like_0_0_choice : boolean_1d(0 to 2);  -- support_like_0_#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 2);  -- support_like_0_#_1_differs
    variable support_like_0_0_choices : boolean_1d(4 to 6);  -- support_like_0_#_0_choice
    variable support_like_0_1_differss : boolean_1d(4 to 6);  -- support_like_0_#_1_differs
    variable support_out_tag_row_start_differs, support_out_tag_row_start_is_equal : boolean;
    variable support_out_tag_row_start_choice : boolean;
    variable support_out_tag_row_start_choices : boolean_1d(2 to 3);  -- support_out_tag_row_start_choice_#
    variable support_out_tag_row_start_is_equal_2, support_out_tag_row_start_all : boolean;
    variable support_out_tag_row_start_all_2, fill_ends_read_place_0_is_equal, fill_ends_read_place_0_choice : boolean;
    variable fill_out_disparity_0_all, fill_out_disparity_0_all_2, fill_out_filled_0_is_equal : boolean;
    variable fill_out_filled_0_choice, fill_out_tag_row_start_differs, fill_out_tag_row_start_is_equal : boolean;
    variable fill_out_tag_row_start_choice : boolean;
    variable fill_out_tag_row_start_choices : boolean_1d(2 to 3);  -- fill_out_tag_row_start_choice_#
    variable fill_out_tag_row_start_is_equal_2, fill_out_tag_row_start_all, fill_out_tag_row_start_all_2 : boolean;
    variable fill_ends_next_place_0_choice, fill_ends_next_place_0_choice_2, fill_ends_row_place_0_all : boolean;
    variable fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice : boolean;
    variable median_window_complete_is_equal, median_window_complete_choice : boolean;
    variable median_low_0_all : boolean_1d(0 to 1);  -- median_low_#_0_all
    variable transform_counter_group_choice, support_counter_group_choice : natural range 0 to 375;
    variable fill_counter_group_choice, median_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- transform_counter_group_choice_#
    variable support_counter_group_choices : natural_511_1d(2 to 3);  -- support_counter_group_choice_#
    variable fill_counter_group_choices : natural_511_1d(2 to 3);  -- fill_counter_group_choice_#
    variable fill_takes_left_0_choice_2 : natural range 0 to 511;
    variable median_counter_group_choices : natural_511_1d(2 to 3);  -- median_counter_group_choice_#
    variable slice0cost_column_0_choice : natural_255_1d(0 to 15);  -- slice0cost_column_0_#_choice
    variable slice0cost_column_0_value : natural_255_1d(0 to 15);  -- slice0cost_column_0_#_value
    variable slice0window_change_0_choice : natural_255_1d(0 to 15);  -- slice0window_change_0_#_choice
    variable slice1cost_column_0_choice : natural_255_1d(0 to 15);  -- slice1cost_column_0_#_choice
    variable slice1cost_column_0_value : natural_255_1d(0 to 15);  -- slice1cost_column_0_#_value
    variable slice1window_change_0_choice : natural_255_1d(0 to 15);  -- slice1window_change_0_#_choice
    variable slice2cost_column_0_choice : natural_255_1d(0 to 15);  -- slice2cost_column_0_#_choice
    variable slice2cost_column_0_value : natural_255_1d(0 to 15);  -- slice2cost_column_0_#_value
    variable slice2window_change_0_choice : natural_255_1d(0 to 15);  -- slice2window_change_0_#_choice
    variable refinement_fraction_0_choice, support_out_sure_0_choice : natural range 0 to 255;
    variable fill_ends_read_place_0_choices : natural_255_1d(2 to 3);  -- fill_ends_read_place_0_choice_#
    variable fill_takes_left_0_choice : natural range 0 to 255;
    variable slice0window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice0window_sum_0_#_choice
    variable slice0winner1_held_0_choice : natural_2047_1d(0 to 15);  -- slice0winner1_held_0_#_choice
    variable slice0winner1_held_0_any : natural_2047_1d(0 to 15);  -- slice0winner1_held_0_#_any
    variable slice0winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice0winner2_best_below_0_#_choice
    variable slice0winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice0winner2_best_above_0_#_choice
    variable slice0winner2_best_second_0_choice : natural_2047_1d(0 to 3);  -- slice0winner2_best_second_0_#_choice
    variable slice0winner2_best_second_0_choices : natural_2047_2d(0 to 3, 2 to 4);  -- slice0winner2_best_second_0_#_choice_#
    variable slice0winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice0winner3_best_below_0_#_choice
    variable slice0winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice0winner3_best_above_0_#_choice
    variable slice0winner3_best_second_0_choice : natural_2047_1d(0 to 1);  -- slice0winner3_best_second_0_#_choice
    variable slice0winner3_best_second_0_choices : natural_2047_2d(0 to 1, 2 to 4);  -- slice0winner3_best_second_0_#_choice_#
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice0winner4_best_second_0_0_choice : natural range 0 to 2047;
    variable slice0winner4_best_second_0_0_choices : natural_2047_1d(2 to 4);  -- slice0winner4_best_second_0_0_choice_#
    variable slice1window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice1window_sum_0_#_choice
    variable slice1winner1_held_0_choice : natural_2047_1d(0 to 15);  -- slice1winner1_held_0_#_choice
    variable slice1winner1_held_0_any : natural_2047_1d(0 to 15);  -- slice1winner1_held_0_#_any
    variable slice1winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice1winner2_best_below_0_#_choice
    variable slice1winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice1winner2_best_above_0_#_choice
    variable slice1winner2_best_second_0_choice : natural_2047_1d(0 to 3);  -- slice1winner2_best_second_0_#_choice
    variable slice1winner2_best_second_0_choices : natural_2047_2d(0 to 3, 2 to 4);  -- slice1winner2_best_second_0_#_choice_#
    variable slice1winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice1winner3_best_below_0_#_choice
    variable slice1winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice1winner3_best_above_0_#_choice
    variable slice1winner3_best_second_0_choice : natural_2047_1d(0 to 1);  -- slice1winner3_best_second_0_#_choice
    variable slice1winner3_best_second_0_choices : natural_2047_2d(0 to 1, 2 to 4);  -- slice1winner3_best_second_0_#_choice_#
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1winner4_best_second_0_0_choice : natural range 0 to 2047;
    variable slice1winner4_best_second_0_0_choices : natural_2047_1d(2 to 4);  -- slice1winner4_best_second_0_0_choice_#
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1_best_second_0_0_choice : natural range 0 to 2047;
    variable slice1_best_second_0_0_choices : natural_2047_1d(2 to 4);  -- slice1_best_second_0_0_choice_#
    variable slice2window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice2window_sum_0_#_choice
    variable slice2winner1_held_0_choice : natural_2047_1d(0 to 15);  -- slice2winner1_held_0_#_choice
    variable slice2winner1_held_0_any : natural_2047_1d(0 to 15);  -- slice2winner1_held_0_#_any
    variable slice2winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice2winner2_best_below_0_#_choice
    variable slice2winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice2winner2_best_above_0_#_choice
    variable slice2winner2_best_second_0_choice : natural_2047_1d(0 to 3);  -- slice2winner2_best_second_0_#_choice
    variable slice2winner2_best_second_0_choices : natural_2047_2d(0 to 3, 2 to 4);  -- slice2winner2_best_second_0_#_choice_#
    variable slice2winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice2winner3_best_below_0_#_choice
    variable slice2winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice2winner3_best_above_0_#_choice
    variable slice2winner3_best_second_0_choice : natural_2047_1d(0 to 1);  -- slice2winner3_best_second_0_#_choice
    variable slice2winner3_best_second_0_choices : natural_2047_2d(0 to 1, 2 to 4);  -- slice2winner3_best_second_0_#_choice_#
    variable slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2winner4_best_second_0_0_choice : natural range 0 to 2047;
    variable slice2winner4_best_second_0_0_choices : natural_2047_1d(2 to 4);  -- slice2winner4_best_second_0_0_choice_#
    variable slice2_best_below_0_0_choice, slice2_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2_best_second_0_0_choice : natural range 0 to 2047;
    variable slice2_best_second_0_0_choices : natural_2047_1d(2 to 4);  -- slice2_best_second_0_0_choice_#
    variable refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- refinement_remainder_#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -62 to 64;
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- support_column_#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- support_like_0_#_#_value
    variable fill_out_disparity_0_choice : natural range 0 to 1023;
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice : natural range 0 to 32767;
    variable median_sorted_low_0_choice, median_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_middle_0_choice, median_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_high_0_choice, median_sorted_high_0_choice_2 : natural range 0 to 32767;
    variable median_largest_low_0_choice, median_largest_low_0_choice_2 : natural range 0 to 32767;
    variable median_median_middle_0_choice : natural range 0 to 32767;
    variable median_median_middle_0_choices : natural_32767_1d(2 to 4);  -- median_median_middle_0_choice_#
    variable median_smallest_high_0_choice, median_smallest_high_0_choice_2 : natural range 0 to 32767;
    variable median_out_disparity_0_choice : natural range 0 to 32767;
    variable median_out_disparity_0_choices : natural_32767_1d(2 to 4);  -- median_out_disparity_0_choice_#
    variable median_low_0_0_choice, median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
    variable fill_write_above_0_choice : natural range 0 to 65535;
    variable median_of_column_0_a_choice : natural range 0 to 4095;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_group = 374;
      transform_counter_group_is_equal_2 := transform_counter_column = 449;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 375;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 377;
      if (transform_counter_group = 376) and transform_counter_next_frame then
        transform_counter_group_choices(2) := 2;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column(4, 2), 1);
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        is_set(transform_left_filter_column(4, 2), 0));
      if is_set(transform_left_filter_column(0, 1), 0) then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_left_filter_column(0, 1), 1) then
        transform_left_filter_feature_0_choices(2) := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choices(2) := is_set(transform_left_filter_column(0, 1), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_values(2) := is_set(transform_left_filter_column(4, 2), 2);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(0, 1), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(0, 1), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 2), i);
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 1), i)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 1), i)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(7) then
        transform_left_filter_feature_0_choices(8) := transform_filtering_0_column_inside_0 and
          is_set(transform_left_filter_column(0, 1), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(8) := transform_filtering_0_column_inside_0 and
          (is_set(transform_left_filter_column(0, 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_left_filter_column(0, 3), 0) then
        transform_left_filter_feature_0_choices(9) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(9) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column(0, 3), 1) then
        transform_left_filter_feature_0_choices(10) := transform_left_filter_feature_0_choices(9);
      else
        transform_left_filter_feature_0_choices(10) := is_set(transform_left_filter_column(0, 3), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(10) then
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column(0, 3), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column(0, 3), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 11 to 14 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 3), i - 8)) or
            transform_left_filter_feature_0_values(i - 8);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 3), i - 8)) and
            transform_left_filter_feature_0_values(i - 8);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(15) then
        transform_left_filter_feature_0_choices(16) := transform_filtering_0_column_inside_0 and
          is_set(transform_left_filter_column(0, 3), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(16) := transform_filtering_0_column_inside_0 and
          (is_set(transform_left_filter_column(0, 3), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_left_filter_column(0, 0), 0) then
        transform_left_filter_feature_0_choices(17) := (transform_left_filter_column(4, 2) mod 4) = 3;
      else
        transform_left_filter_feature_0_choices(17) := transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column(0, 0), 1) then
        transform_left_filter_feature_0_choices(18) := transform_left_filter_feature_0_choices(17);
      else
        transform_left_filter_feature_0_choices(18) := (not is_set(transform_left_filter_column(0, 0), 0)) or
          transform_left_filter_feature_0_value or is_set(transform_left_filter_column(4, 2), 0);
      end if;
      transform_left_filter_feature_0_values(7) := is_set(transform_left_filter_column(0, 0), 2);
      if transform_left_filter_feature_0_choices(18) then
        transform_left_filter_feature_0_choices(19) := transform_left_filter_feature_0_values(7) and (not
          transform_left_filter_feature_0_values(2));
      else
        transform_left_filter_feature_0_choices(19) := transform_left_filter_feature_0_values(7) or (not
          transform_left_filter_feature_0_values(2));
      end if;
      for i in 8 to 11 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
        if transform_left_filter_feature_0_choices(i + 11) then
          transform_left_filter_feature_0_choices(i + 12) := transform_left_filter_feature_0_values(i) or (not
            transform_left_filter_feature_0_values(i - 5));
        else
          transform_left_filter_feature_0_choices(i + 12) := transform_left_filter_feature_0_values(i) and (not
            transform_left_filter_feature_0_values(i - 5));
        end if;
      end loop;
      if is_set(transform_left_filter_column(0, 0), 7) then
        transform_left_filter_feature_0_choices(24) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices(24) := transform_filtering_0_column_inside_0 and (not
          is_set(transform_left_filter_column(4, 2), 7));
      end if;
      if transform_left_filter_feature_0_choices(23) then
        transform_left_filter_feature_0_choices(25) := transform_left_filter_feature_0_choices(24);
      else
        transform_left_filter_feature_0_choices(25) := is_set(transform_left_filter_column(0, 0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column(4, 2), 7));
      end if;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(0, 2 * i + 2), 0) then
          transform_left_filter_feature_0_choices(8 * i + 26) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 26) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(0, 2 * i + 2), 1) then
          transform_left_filter_feature_0_choices(8 * i + 27) := transform_left_filter_feature_0_choices(8 * i + 26);
        else
          transform_left_filter_feature_0_choices(8 * i + 27) := is_set(transform_left_filter_column(0, 2 * i + 2), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 27) then
          transform_left_filter_feature_0_choices(8 * i + 28) := (not is_set(transform_left_filter_column(0, 2 * i +
            2), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 28) := (not is_set(transform_left_filter_column(0, 2 * i +
            2), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 25) then
            transform_left_filter_feature_0_choices(8 * i + j + 26) := (not is_set(transform_left_filter_column(0, 2 *
              i + 2), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 26) := (not is_set(transform_left_filter_column(0, 2 *
              i + 2), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 32) then
          transform_left_filter_feature_0_choices(8 * i + 33) := transform_filtering_0_column_inside_0 and
            is_set(transform_left_filter_column(0, 2 * i + 2), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 33) := transform_filtering_0_column_inside_0 and
            (is_set(transform_left_filter_column(0, 2 * i + 2), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(2, 3 - 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 42) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 42) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(2, 3 - 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 43) := transform_left_filter_feature_0_choices(8 * i + 42);
        else
          transform_left_filter_feature_0_choices(8 * i + 43) := is_set(transform_left_filter_column(2, 3 - 2 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 43) then
          transform_left_filter_feature_0_choices(8 * i + 44) := (not is_set(transform_left_filter_column(2, 3 - 2 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 44) := (not is_set(transform_left_filter_column(2, 3 - 2 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 41) then
            transform_left_filter_feature_0_choices(8 * i + j + 42) := (not is_set(transform_left_filter_column(2, 3 -
              2 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 42) := (not is_set(transform_left_filter_column(2, 3 -
              2 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 48) then
          transform_left_filter_feature_0_choices(8 * i + 49) := transform_filtering_0_column_inside_2 and
            is_set(transform_left_filter_column(2, 3 - 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 49) := transform_filtering_0_column_inside_2 and
            (is_set(transform_left_filter_column(2, 3 - 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_left_filter_column(2, 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 58) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 58) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(2, 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 59) := transform_left_filter_feature_0_choices(8 * i + 58);
        else
          transform_left_filter_feature_0_choices(8 * i + 59) := is_set(transform_left_filter_column(2, 2 * i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 59) then
          transform_left_filter_feature_0_choices(8 * i + 60) := (not is_set(transform_left_filter_column(2, 2 * i),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 60) := (not is_set(transform_left_filter_column(2, 2 * i),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 57) then
            transform_left_filter_feature_0_choices(8 * i + j + 58) := (not is_set(transform_left_filter_column(2, 2 *
              i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 58) := (not is_set(transform_left_filter_column(2, 2 *
              i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 64) then
          transform_left_filter_feature_0_choices(8 * i + 65) := transform_filtering_0_column_inside_2 and
            is_set(transform_left_filter_column(2, 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 65) := transform_filtering_0_column_inside_2 and
            (is_set(transform_left_filter_column(2, 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(4, 3 - 3 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 82) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 82) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(4, 3 - 3 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 83) := transform_left_filter_feature_0_choices(8 * i + 82);
        else
          transform_left_filter_feature_0_choices(8 * i + 83) := is_set(transform_left_filter_column(4, 3 - 3 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 83) then
          transform_left_filter_feature_0_choices(8 * i + 84) := (not is_set(transform_left_filter_column(4, 3 - 3 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 84) := (not is_set(transform_left_filter_column(4, 3 - 3 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 81) then
            transform_left_filter_feature_0_choices(8 * i + j + 82) := (not is_set(transform_left_filter_column(4, 3 -
              3 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 82) := (not is_set(transform_left_filter_column(4, 3 -
              3 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 88) then
          transform_left_filter_feature_0_choices(8 * i + 89) := transform_filtering_0_column_inside_4 and
            is_set(transform_left_filter_column(4, 3 - 3 * i), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 89) := transform_filtering_0_column_inside_4 and
            (is_set(transform_left_filter_column(4, 3 - 3 * i), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(4, 3 * i + 1), 0) then
          transform_left_filter_feature_0_choices(8 * i + 98) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 98) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(4, 3 * i + 1), 1) then
          transform_left_filter_feature_0_choices(8 * i + 99) := transform_left_filter_feature_0_choices(8 * i + 98);
        else
          transform_left_filter_feature_0_choices(8 * i + 99) := is_set(transform_left_filter_column(4, 3 * i + 1), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 99) then
          transform_left_filter_feature_0_choices(8 * i + 100) := (not is_set(transform_left_filter_column(4, 3 * i +
            1), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 100) := (not is_set(transform_left_filter_column(4, 3 * i +
            1), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 97) then
            transform_left_filter_feature_0_choices(8 * i + j + 98) := (not is_set(transform_left_filter_column(4, 3 *
              i + 1), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 98) := (not is_set(transform_left_filter_column(4, 3 *
              i + 1), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 104) then
          transform_left_filter_feature_0_choices(8 * i + 105) := transform_filtering_0_column_inside_4 and
            is_set(transform_left_filter_column(4, 3 * i + 1), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 105) := transform_filtering_0_column_inside_4 and
            (is_set(transform_left_filter_column(4, 3 * i + 1), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(6, 3 - 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 114) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 114) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(6, 3 - 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 115) := transform_left_filter_feature_0_choices(8 * i + 114);
        else
          transform_left_filter_feature_0_choices(8 * i + 115) := is_set(transform_left_filter_column(6, 3 - 2 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 115) then
          transform_left_filter_feature_0_choices(8 * i + 116) := (not is_set(transform_left_filter_column(6, 3 - 2 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 116) := (not is_set(transform_left_filter_column(6, 3 - 2 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 113) then
            transform_left_filter_feature_0_choices(8 * i + j + 114) := (not is_set(transform_left_filter_column(6, 3 -
              2 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 114) := (not is_set(transform_left_filter_column(6, 3 -
              2 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 120) then
          transform_left_filter_feature_0_choices(8 * i + 121) := transform_filtering_0_column_inside_6 and
            is_set(transform_left_filter_column(6, 3 - 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 121) := transform_filtering_0_column_inside_6 and
            (is_set(transform_left_filter_column(6, 3 - 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_left_filter_column(6, 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 130) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 130) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(6, 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 131) := transform_left_filter_feature_0_choices(8 * i + 130);
        else
          transform_left_filter_feature_0_choices(8 * i + 131) := is_set(transform_left_filter_column(6, 2 * i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 131) then
          transform_left_filter_feature_0_choices(8 * i + 132) := (not is_set(transform_left_filter_column(6, 2 * i),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 132) := (not is_set(transform_left_filter_column(6, 2 * i),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 129) then
            transform_left_filter_feature_0_choices(8 * i + j + 130) := (not is_set(transform_left_filter_column(6, 2 *
              i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 130) := (not is_set(transform_left_filter_column(6, 2 *
              i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 136) then
          transform_left_filter_feature_0_choices(8 * i + 137) := transform_filtering_0_column_inside_6 and
            is_set(transform_left_filter_column(6, 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 137) := transform_filtering_0_column_inside_6 and
            (is_set(transform_left_filter_column(6, 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(8, 3 - 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 154) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 154) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(8, 3 - 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 155) := transform_left_filter_feature_0_choices(8 * i + 154);
        else
          transform_left_filter_feature_0_choices(8 * i + 155) := is_set(transform_left_filter_column(8, 3 - 2 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 155) then
          transform_left_filter_feature_0_choices(8 * i + 156) := (not is_set(transform_left_filter_column(8, 3 - 2 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 156) := (not is_set(transform_left_filter_column(8, 3 - 2 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 153) then
            transform_left_filter_feature_0_choices(8 * i + j + 154) := (not is_set(transform_left_filter_column(8, 3 -
              2 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 154) := (not is_set(transform_left_filter_column(8, 3 -
              2 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 160) then
          transform_left_filter_feature_0_choices(8 * i + 161) := transform_filtering_0_column_inside_8 and
            is_set(transform_left_filter_column(8, 3 - 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 161) := transform_filtering_0_column_inside_8 and
            (is_set(transform_left_filter_column(8, 3 - 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_left_filter_column(8, 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 170) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 170) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(8, 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 171) := transform_left_filter_feature_0_choices(8 * i + 170);
        else
          transform_left_filter_feature_0_choices(8 * i + 171) := is_set(transform_left_filter_column(8, 2 * i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 171) then
          transform_left_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_left_filter_column(8, 2 * i),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_left_filter_column(8, 2 * i),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 169) then
            transform_left_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_left_filter_column(8, 2 *
              i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_left_filter_column(8, 2 *
              i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 176) then
          transform_left_filter_feature_0_choices(8 * i + 177) := transform_filtering_0_column_inside_8 and
            is_set(transform_left_filter_column(8, 2 * i), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 177) := transform_filtering_0_column_inside_8 and
            (is_set(transform_left_filter_column(8, 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
        end if;
      end loop;
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column(4, 2), 1);
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        is_set(transform_right_filter_column(4, 2), 0));
      if is_set(transform_right_filter_column(0, 1), 0) then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_right_filter_column(0, 1), 1) then
        transform_right_filter_feature_0_choices(2) := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choices(2) := is_set(transform_right_filter_column(0, 1), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_values(2) := is_set(transform_right_filter_column(4, 2), 2);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(0, 1), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(0, 1), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 2), i);
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(0, 1), i)) or
            transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(0, 1), i)) and
            transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(7) then
        transform_right_filter_feature_0_choices(8) := transform_filtering_0_column_inside_0 and
          is_set(transform_right_filter_column(0, 1), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(8) := transform_filtering_0_column_inside_0 and
          (is_set(transform_right_filter_column(0, 1), 7) or (not is_set(transform_right_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_right_filter_column(0, 3), 0) then
        transform_right_filter_feature_0_choices(9) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(9) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column(0, 3), 1) then
        transform_right_filter_feature_0_choices(10) := transform_right_filter_feature_0_choices(9);
      else
        transform_right_filter_feature_0_choices(10) := is_set(transform_right_filter_column(0, 3), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(10) then
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column(0, 3), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column(0, 3), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 11 to 14 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(0, 3), i - 8))
            or transform_right_filter_feature_0_values(i - 8);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(0, 3), i - 8))
            and transform_right_filter_feature_0_values(i - 8);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(15) then
        transform_right_filter_feature_0_choices(16) := transform_filtering_0_column_inside_0 and
          is_set(transform_right_filter_column(0, 3), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(16) := transform_filtering_0_column_inside_0 and
          (is_set(transform_right_filter_column(0, 3), 7) or (not is_set(transform_right_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_right_filter_column(0, 0), 0) then
        transform_right_filter_feature_0_choices(17) := (transform_right_filter_column(4, 2) mod 4) = 3;
      else
        transform_right_filter_feature_0_choices(17) := transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column(0, 0), 1) then
        transform_right_filter_feature_0_choices(18) := transform_right_filter_feature_0_choices(17);
      else
        transform_right_filter_feature_0_choices(18) := (not is_set(transform_right_filter_column(0, 0), 0)) or
          transform_right_filter_feature_0_value or is_set(transform_right_filter_column(4, 2), 0);
      end if;
      transform_right_filter_feature_0_values(7) := is_set(transform_right_filter_column(0, 0), 2);
      if transform_right_filter_feature_0_choices(18) then
        transform_right_filter_feature_0_choices(19) := transform_right_filter_feature_0_values(7) and (not
          transform_right_filter_feature_0_values(2));
      else
        transform_right_filter_feature_0_choices(19) := transform_right_filter_feature_0_values(7) or (not
          transform_right_filter_feature_0_values(2));
      end if;
      for i in 8 to 11 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
        if transform_right_filter_feature_0_choices(i + 11) then
          transform_right_filter_feature_0_choices(i + 12) := transform_right_filter_feature_0_values(i) or (not
            transform_right_filter_feature_0_values(i - 5));
        else
          transform_right_filter_feature_0_choices(i + 12) := transform_right_filter_feature_0_values(i) and (not
            transform_right_filter_feature_0_values(i - 5));
        end if;
      end loop;
      if is_set(transform_right_filter_column(0, 0), 7) then
        transform_right_filter_feature_0_choices(24) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(24) := transform_filtering_0_column_inside_0 and (not
          is_set(transform_right_filter_column(4, 2), 7));
      end if;
      if transform_right_filter_feature_0_choices(23) then
        transform_right_filter_feature_0_choices(25) := transform_right_filter_feature_0_choices(24);
      else
        transform_right_filter_feature_0_choices(25) := is_set(transform_right_filter_column(0, 0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column(4, 2), 7));
      end if;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(0, 2 * i + 2), 0) then
          transform_right_filter_feature_0_choices(8 * i + 26) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 26) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(0, 2 * i + 2), 1) then
          transform_right_filter_feature_0_choices(8 * i + 27) := transform_right_filter_feature_0_choices(8 * i + 26);
        else
          transform_right_filter_feature_0_choices(8 * i + 27) := is_set(transform_right_filter_column(0, 2 * i + 2),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 27) then
          transform_right_filter_feature_0_choices(8 * i + 28) := (not is_set(transform_right_filter_column(0, 2 * i +
            2), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 28) := (not is_set(transform_right_filter_column(0, 2 * i +
            2), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 25) then
            transform_right_filter_feature_0_choices(8 * i + j + 26) := (not is_set(transform_right_filter_column(0, 2
              * i + 2), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 26) := (not is_set(transform_right_filter_column(0, 2
              * i + 2), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 32) then
          transform_right_filter_feature_0_choices(8 * i + 33) := transform_filtering_0_column_inside_0 and
            is_set(transform_right_filter_column(0, 2 * i + 2), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 33) := transform_filtering_0_column_inside_0 and
            (is_set(transform_right_filter_column(0, 2 * i + 2), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(2, 3 - 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 42) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 42) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(2, 3 - 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 43) := transform_right_filter_feature_0_choices(8 * i + 42);
        else
          transform_right_filter_feature_0_choices(8 * i + 43) := is_set(transform_right_filter_column(2, 3 - 2 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 43) then
          transform_right_filter_feature_0_choices(8 * i + 44) := (not is_set(transform_right_filter_column(2, 3 - 2 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 44) := (not is_set(transform_right_filter_column(2, 3 - 2 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 41) then
            transform_right_filter_feature_0_choices(8 * i + j + 42) := (not is_set(transform_right_filter_column(2, 3
              - 2 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 42) := (not is_set(transform_right_filter_column(2, 3
              - 2 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 48) then
          transform_right_filter_feature_0_choices(8 * i + 49) := transform_filtering_0_column_inside_2 and
            is_set(transform_right_filter_column(2, 3 - 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 49) := transform_filtering_0_column_inside_2 and
            (is_set(transform_right_filter_column(2, 3 - 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_right_filter_column(2, 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 58) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 58) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(2, 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 59) := transform_right_filter_feature_0_choices(8 * i + 58);
        else
          transform_right_filter_feature_0_choices(8 * i + 59) := is_set(transform_right_filter_column(2, 2 * i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 59) then
          transform_right_filter_feature_0_choices(8 * i + 60) := (not is_set(transform_right_filter_column(2, 2 * i),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 60) := (not is_set(transform_right_filter_column(2, 2 * i),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 57) then
            transform_right_filter_feature_0_choices(8 * i + j + 58) := (not is_set(transform_right_filter_column(2, 2
              * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 58) := (not is_set(transform_right_filter_column(2, 2
              * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 64) then
          transform_right_filter_feature_0_choices(8 * i + 65) := transform_filtering_0_column_inside_2 and
            is_set(transform_right_filter_column(2, 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 65) := transform_filtering_0_column_inside_2 and
            (is_set(transform_right_filter_column(2, 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(4, 3 - 3 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 82) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 82) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(4, 3 - 3 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 83) := transform_right_filter_feature_0_choices(8 * i + 82);
        else
          transform_right_filter_feature_0_choices(8 * i + 83) := is_set(transform_right_filter_column(4, 3 - 3 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 83) then
          transform_right_filter_feature_0_choices(8 * i + 84) := (not is_set(transform_right_filter_column(4, 3 - 3 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 84) := (not is_set(transform_right_filter_column(4, 3 - 3 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 81) then
            transform_right_filter_feature_0_choices(8 * i + j + 82) := (not is_set(transform_right_filter_column(4, 3
              - 3 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 82) := (not is_set(transform_right_filter_column(4, 3
              - 3 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 88) then
          transform_right_filter_feature_0_choices(8 * i + 89) := transform_filtering_0_column_inside_4 and
            is_set(transform_right_filter_column(4, 3 - 3 * i), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 89) := transform_filtering_0_column_inside_4 and
            (is_set(transform_right_filter_column(4, 3 - 3 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(4, 3 * i + 1), 0) then
          transform_right_filter_feature_0_choices(8 * i + 98) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 98) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(4, 3 * i + 1), 1) then
          transform_right_filter_feature_0_choices(8 * i + 99) := transform_right_filter_feature_0_choices(8 * i + 98);
        else
          transform_right_filter_feature_0_choices(8 * i + 99) := is_set(transform_right_filter_column(4, 3 * i + 1),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 99) then
          transform_right_filter_feature_0_choices(8 * i + 100) := (not is_set(transform_right_filter_column(4, 3 * i +
            1), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 100) := (not is_set(transform_right_filter_column(4, 3 * i +
            1), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 97) then
            transform_right_filter_feature_0_choices(8 * i + j + 98) := (not is_set(transform_right_filter_column(4, 3
              * i + 1), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 98) := (not is_set(transform_right_filter_column(4, 3
              * i + 1), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 104) then
          transform_right_filter_feature_0_choices(8 * i + 105) := transform_filtering_0_column_inside_4 and
            is_set(transform_right_filter_column(4, 3 * i + 1), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 105) := transform_filtering_0_column_inside_4 and
            (is_set(transform_right_filter_column(4, 3 * i + 1), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(6, 3 - 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 114) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 114) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(6, 3 - 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 115) := transform_right_filter_feature_0_choices(8 * i +
            114);
        else
          transform_right_filter_feature_0_choices(8 * i + 115) := is_set(transform_right_filter_column(6, 3 - 2 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 115) then
          transform_right_filter_feature_0_choices(8 * i + 116) := (not is_set(transform_right_filter_column(6, 3 - 2 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 116) := (not is_set(transform_right_filter_column(6, 3 - 2 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 113) then
            transform_right_filter_feature_0_choices(8 * i + j + 114) := (not is_set(transform_right_filter_column(6, 3
              - 2 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 114) := (not is_set(transform_right_filter_column(6, 3
              - 2 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 120) then
          transform_right_filter_feature_0_choices(8 * i + 121) := transform_filtering_0_column_inside_6 and
            is_set(transform_right_filter_column(6, 3 - 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 121) := transform_filtering_0_column_inside_6 and
            (is_set(transform_right_filter_column(6, 3 - 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_right_filter_column(6, 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 130) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 130) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(6, 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 131) := transform_right_filter_feature_0_choices(8 * i +
            130);
        else
          transform_right_filter_feature_0_choices(8 * i + 131) := is_set(transform_right_filter_column(6, 2 * i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 131) then
          transform_right_filter_feature_0_choices(8 * i + 132) := (not is_set(transform_right_filter_column(6, 2 * i),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 132) := (not is_set(transform_right_filter_column(6, 2 * i),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 129) then
            transform_right_filter_feature_0_choices(8 * i + j + 130) := (not is_set(transform_right_filter_column(6, 2
              * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 130) := (not is_set(transform_right_filter_column(6, 2
              * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 136) then
          transform_right_filter_feature_0_choices(8 * i + 137) := transform_filtering_0_column_inside_6 and
            is_set(transform_right_filter_column(6, 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 137) := transform_filtering_0_column_inside_6 and
            (is_set(transform_right_filter_column(6, 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(8, 3 - 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 154) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 154) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(8, 3 - 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 155) := transform_right_filter_feature_0_choices(8 * i +
            154);
        else
          transform_right_filter_feature_0_choices(8 * i + 155) := is_set(transform_right_filter_column(8, 3 - 2 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 155) then
          transform_right_filter_feature_0_choices(8 * i + 156) := (not is_set(transform_right_filter_column(8, 3 - 2 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 156) := (not is_set(transform_right_filter_column(8, 3 - 2 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 153) then
            transform_right_filter_feature_0_choices(8 * i + j + 154) := (not is_set(transform_right_filter_column(8, 3
              - 2 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 154) := (not is_set(transform_right_filter_column(8, 3
              - 2 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 160) then
          transform_right_filter_feature_0_choices(8 * i + 161) := transform_filtering_0_column_inside_8 and
            is_set(transform_right_filter_column(8, 3 - 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 161) := transform_filtering_0_column_inside_8 and
            (is_set(transform_right_filter_column(8, 3 - 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      for i in 0 to 2 loop
        if is_set(transform_right_filter_column(8, 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 170) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 170) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(8, 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 171) := transform_right_filter_feature_0_choices(8 * i +
            170);
        else
          transform_right_filter_feature_0_choices(8 * i + 171) := is_set(transform_right_filter_column(8, 2 * i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 171) then
          transform_right_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_right_filter_column(8, 2 * i),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_right_filter_column(8, 2 * i),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 169) then
            transform_right_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_right_filter_column(8, 2
              * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_right_filter_column(8, 2
              * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 176) then
          transform_right_filter_feature_0_choices(8 * i + 177) := transform_filtering_0_column_inside_8 and
            is_set(transform_right_filter_column(8, 2 * i), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 177) := transform_filtering_0_column_inside_8 and
            (is_set(transform_right_filter_column(8, 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2),
            7)));
        end if;
      end loop;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside(0) <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 375;
      transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 378);
      transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 375;
      transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 376);
      transform_read_row_inside(4) <= transform_counter_group < 375;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_8 <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      for i in 0 to 4 loop
        transform_ready_row_inside(i) <= transform_read_row_inside(i);
      end loop;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column(0) <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column(1) <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column(2) <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column(3) <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column(4) <= transform_left_rows_ready_newest_0;
      transform_right_column(0) <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column(1) <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column(2) <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column(3) <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column(4) <= transform_right_rows_ready_newest_0;
      for i in 0 to 4 loop
        transform_columns_row_inside(i) <= transform_ready_row_inside(i);
      end loop;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_column_inside_8 <= transform_ready_column_inside_8;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choices(8)) * 2) +
        (as_number(transform_left_filter_feature_0_choices(16)) * 8) +
        as_number(transform_left_filter_feature_0_choices(25)) +
        (as_number(transform_left_filter_feature_0_choices(33)) * 4) +
        (as_number(transform_left_filter_feature_0_choices(41)) * 16) +
        (as_number(transform_left_filter_feature_0_choices(49)) * 256) +
        (as_number(transform_left_filter_feature_0_choices(57)) * 64) +
        (as_number(transform_left_filter_feature_0_choices(65)) * 32) +
        (as_number(transform_left_filter_feature_0_choices(73)) * 128) +
        (as_number(transform_left_filter_feature_0_choices(81)) * 512) +
        (as_number(transform_left_filter_feature_0_choices(89)) * 4096) +
        (as_number(transform_left_filter_feature_0_choices(97)) * 1024) +
        (as_number(transform_left_filter_feature_0_choices(105)) * 2048) +
        (as_number(transform_left_filter_feature_0_choices(113)) * 8192) +
        (as_number(transform_left_filter_feature_0_choices(121)) * 131072) +
        (as_number(transform_left_filter_feature_0_choices(129)) * 32768) +
        (as_number(transform_left_filter_feature_0_choices(137)) * 16384) +
        (as_number(transform_left_filter_feature_0_choices(145)) * 65536) +
        (as_number(transform_left_filter_feature_0_choices(153)) * 262144) +
        (as_number(transform_left_filter_feature_0_choices(161)) * 4194304) +
        (as_number(transform_left_filter_feature_0_choices(169)) * 1048576) +
        (as_number(transform_left_filter_feature_0_choices(177)) * 524288) +
        (as_number(transform_left_filter_feature_0_choices(185)) * 2097152) +
        (as_number(transform_left_filter_feature_0_choices(193)) * 8388608);
      transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choices(8)) * 2) +
        (as_number(transform_right_filter_feature_0_choices(16)) * 8) +
        as_number(transform_right_filter_feature_0_choices(25)) +
        (as_number(transform_right_filter_feature_0_choices(33)) * 4) +
        (as_number(transform_right_filter_feature_0_choices(41)) * 16) +
        (as_number(transform_right_filter_feature_0_choices(49)) * 256) +
        (as_number(transform_right_filter_feature_0_choices(57)) * 64) +
        (as_number(transform_right_filter_feature_0_choices(65)) * 32) +
        (as_number(transform_right_filter_feature_0_choices(73)) * 128) +
        (as_number(transform_right_filter_feature_0_choices(81)) * 512) +
        (as_number(transform_right_filter_feature_0_choices(89)) * 4096) +
        (as_number(transform_right_filter_feature_0_choices(97)) * 1024) +
        (as_number(transform_right_filter_feature_0_choices(105)) * 2048) +
        (as_number(transform_right_filter_feature_0_choices(113)) * 8192) +
        (as_number(transform_right_filter_feature_0_choices(121)) * 131072) +
        (as_number(transform_right_filter_feature_0_choices(129)) * 32768) +
        (as_number(transform_right_filter_feature_0_choices(137)) * 16384) +
        (as_number(transform_right_filter_feature_0_choices(145)) * 65536) +
        (as_number(transform_right_filter_feature_0_choices(153)) * 262144) +
        (as_number(transform_right_filter_feature_0_choices(161)) * 4194304) +
        (as_number(transform_right_filter_feature_0_choices(169)) * 1048576) +
        (as_number(transform_right_filter_feature_0_choices(177)) * 524288) +
        (as_number(transform_right_filter_feature_0_choices(185)) * 2097152) +
        (as_number(transform_right_filter_feature_0_choices(193)) * 8388608);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice;
      else
        transform_counter_group <= transform_counter_group_choices(3);
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 376) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal_2 then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= (not in_start_of_frame) or transform_counter_group_all;
        else
          transform_counter_next_frame <= in_start_of_frame and transform_counter_group_is_equal and
            transform_counter_group_is_equal_2;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
          transform_left_rows_ready_words_0(31 downto 8);
        transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
          transform_right_rows_ready_words_0(31 downto 8);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_valid then
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 4 loop
          if transform_columns_row_inside(i) then
            transform_left_filter_column(0, i) <= transform_left_column(i);
            transform_right_filter_column(0, i) <= transform_right_column(i);
          else
            transform_left_filter_column(0, i) <= 0;
            transform_right_filter_column(0, i) <= 0;
          end if;
        end loop;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 449;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(1);
      if transform_filtering_valid(1) and transform_filtering_start_of_frame(1) then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 379) and
          transform_filtering_valid(1) and raster_place_group_is_equal))) mod 512;
      end if;
      if transform_filtering_valid(1) then
        if raster_place_group_is_equal or transform_filtering_start_of_frame(1) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      delay_tag_map_column_is_less := (((((raster_place_column / 4) + 16383) mod 16384) * 4) + (raster_place_column mod
        4)) < 442;
      delay_tag_first_column_is_equal := raster_place_column = 4;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 384);
      delay_row_inside(1) <= raster_place_group < 375;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_leaves_window <= (raster_place_column >= 9) and (raster_place_column < 450);
      delay_tag_map_column <= delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_less and ((((((raster_place_group / 4) + 16383) mod 16384) *
        4) + (raster_place_group mod 4)) < 375);
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 4);
      delay_tag_end_of_line <= raster_place_column = 445;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      for i in 0 to 8 loop
        rows_search_rows_ready_words(i) <= to_integer(rows_search_rows_read_words(i));
      end loop;
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      for i in 0 to 8 loop
        rows_reference_rows_ready_words(i) <= to_integer(rows_reference_rows_read_words(i));
      end loop;
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside(0) then
        rows_search(0) <= rows_search_rows_ready_words(0);
        rows_reference(0) <= rows_reference_rows_ready_words(0);
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
        for i in 0 to 7 loop
          rows_search_rows_write_words(i) <= rows_search_rows_ready_words(i + 1);
        end loop;
        rows_search_rows_write_words(8) <= rows_search_rows_ready_newest_0;
        for i in 0 to 7 loop
          rows_reference_rows_write_words(i) <= rows_reference_rows_ready_words(i + 1);
        end loop;
        rows_reference_rows_write_words(8) <= rows_reference_rows_ready_newest_0;
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
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      for i in 0 to 1 loop
        slice0cost_pixels_first_0_count_value(i, 0) := is_set(slice0shift_reference(i), 2);
        slice0cost_pixels_first_0_count_value_2(i, 0) := is_set(slice0shift_reference(i), 1);
        slice0cost_pixels_first_0_count_value(i, 1) := is_set(slice0shift_reference(i), 3);
        slice0cost_pixels_first_0_count_value_2(i, 1) := is_set(slice0shift_reference(i), 5);
        slice0cost_pixels_first_0_count_1_value_3(i) := is_set(slice0shift_reference(i), 4);
        slice0cost_pixels_first_0_count_value(i, 2) := is_set(slice0shift_reference(i), 8);
        slice0cost_pixels_first_0_count_value_2(i, 2) := is_set(slice0shift_reference(i), 6);
        for j in 3 to 6 loop
          slice0cost_pixels_first_0_count_value(i, j) := is_set(slice0shift_reference(i), 3 * j);
          slice0cost_pixels_first_0_count_value_2(i, j) := is_set(slice0shift_reference(i), 3 * j + 2);
          slice0cost_pixels_first_0_count_value_3(i, j) := is_set(slice0shift_reference(i), 3 * j + 1);
        end loop;
        slice0cost_pixels_first_0_count_value(i, 7) := is_set(slice0shift_reference(i), 21);
        slice0cost_pixels_first_0_count_value_2(i, 7) := is_set(slice0shift_reference(i), 22);
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 3 loop
          if slice0cost_ready_tag_first_group then
            slice0cost_column_0_choice(4 * i + j) := 0;
          else
            slice0cost_column_0_choice(4 * i + j) := to_integer(slice0cost_ready_words(i)(8 * j + 7 downto 8 * j));
          end if;
          slice0cost_column_0_value(4 * i + j) := (slice0cost_change_0(4 * i + j) + slice0cost_column_0_choice(4 * i +
            j)) mod 256;
        end loop;
      end loop;
      for i in 0 to 1 loop
        slice0cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice0shift_search(i, 0), 0) /=
          is_set(slice0shift_reference(i), 0))) + as_number((slice0cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice0shift_search(i, 0), 2))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice0shift_search(i, 0), 1)));
        slice0cost_pixels_first_count(i, 0, 1) <= as_number((slice0cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice0shift_search(i, 0), 3))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice0shift_search(i, 0), 5))) + as_number((slice0cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice0shift_search(i, 0), 4)));
        slice0cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice0cost_pixels_first_0_count_value(i, 2) /= is_set(slice0shift_search(i, 0), 8))) +
          as_number((slice0cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice0shift_search(i, 0), 6)));
        for j in 3 to 6 loop
          slice0cost_pixels_first_count(i, 0, j) <= as_number((slice0cost_pixels_first_0_count_value(i, j) /=
            is_set(slice0shift_search(i, 0), 3 * j))) + as_number((slice0cost_pixels_first_0_count_value_2(i, j) /=
            is_set(slice0shift_search(i, 0), 3 * j + 2))) + as_number((slice0cost_pixels_first_0_count_value_3(i, j) /=
            is_set(slice0shift_search(i, 0), 3 * j + 1)));
        end loop;
        slice0cost_pixels_first_count(i, 0, 7) <= as_number((slice0cost_pixels_first_0_count_value(i, 7) /=
          is_set(slice0shift_search(i, 0), 21))) + as_number((is_set(slice0shift_reference(i), 23) /=
          is_set(slice0shift_search(i, 0), 23))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 7) /=
          is_set(slice0shift_search(i, 0), 22)));
        for j in 1 to 15 loop
          slice0cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice0shift_search(i, j), 0) /=
            is_set(slice0shift_reference(i), 0))) + as_number((is_set(slice0shift_search(i, j), 2) /=
            slice0cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice0shift_search(i, j), 1) /=
            slice0cost_pixels_first_0_count_value_2(i, 0)));
          slice0cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice0shift_search(i, j), 3) /=
            slice0cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice0shift_search(i, j), 5) /=
            slice0cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice0shift_search(i, j), 4) /=
            slice0cost_pixels_first_0_count_1_value_3(i)));
          slice0cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice0shift_search(i,
            j), 8) /= slice0cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice0shift_search(i, j), 6) /=
            slice0cost_pixels_first_0_count_value_2(i, 2)));
          for k in 3 to 6 loop
            slice0cost_pixels_first_count(i, j, k) <= as_number((is_set(slice0shift_search(i, j), 3 * k) /=
              slice0cost_pixels_first_0_count_value(i, k))) + as_number((is_set(slice0shift_search(i, j), 3 * k + 2) /=
              slice0cost_pixels_first_0_count_value_2(i, k))) + as_number((is_set(slice0shift_search(i, j), 3 * k + 1)
              /= slice0cost_pixels_first_0_count_value_3(i, k)));
          end loop;
          slice0cost_pixels_first_count(i, j, 7) <= as_number((is_set(slice0shift_search(i, j), 21) /=
            slice0cost_pixels_first_0_count_value(i, 7))) + as_number((is_set(slice0shift_search(i, j), 23) /=
            is_set(slice0shift_reference(i), 23))) + as_number((is_set(slice0shift_search(i, j), 22) /=
            slice0cost_pixels_first_0_count_value_2(i, 7)));
        end loop;
      end loop;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 0) + slice0cost_pixels_first_count(i, j,
            2) + slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j, 5) +
            slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 4) +
            slice0cost_pixels_first_count(i, j, 7) + slice0cost_pixels_first_count(i, j, 1);
        end loop;
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
      end loop;
      slice0cost_ready_words(0) <= slice0cost_read_words(0);
      slice0cost_ready_words(1) <= slice0cost_read_words(1);
      slice0cost_ready_words(2) <= slice0cost_read_words(2);
      slice0cost_ready_words(3) <= slice0cost_read_words(3);
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_column_0(i) <= slice0cost_column_0_value(i);
      end loop;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_row_start <= slice0cost_ready_tag_row_start;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_ready_tag_first_column;
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
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice0cost_ready_column <= 0;
        else
          slice0cost_ready_column <= (slice0cost_ready_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        for i in 0 to 3 loop
          slice0cost_write_words(i) <= to_unsigned(slice0cost_column_0_value(4 * i + 3), 8) &
            to_unsigned(slice0cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice0cost_column_0_value(4 * i + 1), 8)
            & to_unsigned(slice0cost_column_0_value(4 * i), 8);
        end loop;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 9 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 16;
        end if;
      end if;
      for i in 0 to 1 loop
        for j in 0 to 3 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(8 * i + j) := to_integer(slice0window_leaving(2 * i)(8 * j + 7 downto 8 * j));
          else
            slice0window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
        for j in 4 to 7 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(8 * i + j) := to_integer(slice0window_leaving(2 * i + 1)(8 * j - 25 downto 8 *
              j - 32));
          else
            slice0window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice0window_entering_0(i) <= slice0cost_column_0(i);
      end loop;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_row_start <= slice0cost_tag_row_start;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_first_column <= slice0cost_tag_first_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      for i in 0 to 15 loop
        slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
      end loop;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_row_start <= slice0window_entering_tag_row_start;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_first_column <= slice0window_entering_tag_first_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_map_column_0 <= slice0window_change_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column(3);
      slice0window_tag_first_column <= slice0window_centre_first_column(3);
      for i in 0 to 15 loop
        if slice0window_change_tag_row_start then
          slice0window_sum_0_choice(i) := 0;
        else
          slice0window_sum_0_choice(i) := slice0window_sum_0(i);
        end if;
      end loop;
      if slice0window_change_tag_valid then
        for i in 0 to 15 loop
          slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 2048;
        end loop;
        slice0window_centre_output_column(0) <= slice0window_change_tag_output_column;
        slice0window_centre_output_column(1) <= slice0window_centre_output_column(0);
        slice0window_centre_output_column(2) <= slice0window_centre_output_column(1);
        slice0window_centre_output_column(3) <= slice0window_centre_output_column(2);
        slice0window_centre_first_column(0) <= slice0window_change_tag_first_column;
        slice0window_centre_first_column(1) <= slice0window_centre_first_column(0);
        slice0window_centre_first_column(2) <= slice0window_centre_first_column(1);
        slice0window_centre_first_column(3) <= slice0window_centre_first_column(2);
      end if;
      if slice0winner1_tag_valid then
        slice0window_centre_start_of_frame_3 <= slice2window_centre_start_of_frame_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_3;
      end if;
      -- slice0mask
      if slice0window_change_tag_valid then
        slice0mask_inside_choice(0) := slice0window_centre_first_column(3);
      else
        slice0mask_inside_choice(0) := slice0mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0window_change_tag_valid then
          slice0mask_inside_choice(i) := slice0mask_inside(i - 1);
        else
          slice0mask_inside_choice(i) := slice0mask_inside(i);
        end if;
      end loop;
      slice0mask_left_out <= slice0mask_inside(15);
      if slice0mask_column < 441 then
        slice0mask_inside(0) <= slice0mask_inside(0) or slice0window_change_tag_valid;
      else
        slice0mask_inside(0) <= slice0mask_inside_choice(0);
      end if;
      if slice0window_centre_first_column(3) then
        for i in 1 to 15 loop
          slice0mask_inside(i) <= slice0mask_inside(i) and (not slice0window_change_tag_valid);
        end loop;
      else
        for i in 1 to 15 loop
          slice0mask_inside(i) <= slice0mask_inside_choice(i);
        end loop;
      end if;
      if slice0window_change_tag_valid then
        if slice0window_centre_first_column(3) then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 512;
        end if;
      end if;
      -- slice0other
      for i in 1 to 14 loop
        if (slice0window_sum_0(i) - slice0other_cost_0(i - 1)) < 0 then
          slice0other_cost_0_choice(i) := slice0window_tag_output_column and slice0mask_inside(i);
        else
          slice0other_cost_0_choice(i) := slice0window_tag_output_column and slice0window_tag_first_column and
            slice0mask_inside(i);
        end if;
      end loop;
      if (slice0window_sum_0(15) - slice0other_cost_0(14)) < 0 then
        slice0other_cost_0_choice(15) := slice0mask_inside(15);
      else
        slice0other_cost_0_choice(15) := slice0window_tag_first_column and slice0mask_inside(15);
      end if;
      slice0other_cost_0_15_all := slice0window_tag_output_column and slice0other_cost_0_choice(15);
      if slice0window_tag_valid then
        slice0other_winner_0_1 <= slice0other_cost_0_choice(1);
        if slice0window_tag_output_column and slice0mask_inside(0) then
          slice0other_cost_0(0) <= slice0window_sum_0(0);
        else
          slice0other_cost_0(0) <= 0;
        end if;
        if slice0other_cost_0_choice(1) then
          slice0other_cost_0(1) <= slice0window_sum_0(1);
        else
          slice0other_cost_0(1) <= slice0other_cost_0(0);
        end if;
        if slice0other_cost_0_choice(2) then
          slice0other_cost_0(2) <= slice0window_sum_0(2);
          slice0other_winner_0_2 <= 2;
        else
          slice0other_cost_0(2) <= slice0other_cost_0(1);
          slice0other_winner_0_2 <= as_number(slice0other_winner_0_1);
        end if;
        if slice0other_cost_0_choice(3) then
          slice0other_cost_0(3) <= slice0window_sum_0(3);
          slice0other_winner_0_3 <= 3;
        else
          slice0other_cost_0(3) <= slice0other_cost_0(2);
          slice0other_winner_0_3 <= slice0other_winner_0_2;
        end if;
        if slice0other_cost_0_choice(4) then
          slice0other_cost_0(4) <= slice0window_sum_0(4);
          slice0other_winner_0_4 <= 4;
        else
          slice0other_cost_0(4) <= slice0other_cost_0(3);
          slice0other_winner_0_4 <= slice0other_winner_0_3;
        end if;
        if slice0other_cost_0_choice(5) then
          slice0other_cost_0(5) <= slice0window_sum_0(5);
          slice0other_winner_0_5 <= 5;
        else
          slice0other_cost_0(5) <= slice0other_cost_0(4);
          slice0other_winner_0_5 <= slice0other_winner_0_4;
        end if;
        if slice0other_cost_0_choice(6) then
          slice0other_cost_0(6) <= slice0window_sum_0(6);
          slice0other_winner_0_6 <= 6;
        else
          slice0other_cost_0(6) <= slice0other_cost_0(5);
          slice0other_winner_0_6 <= slice0other_winner_0_5;
        end if;
        if slice0other_cost_0_choice(7) then
          slice0other_cost_0(7) <= slice0window_sum_0(7);
          slice0other_winner_0_7 <= 7;
        else
          slice0other_cost_0(7) <= slice0other_cost_0(6);
          slice0other_winner_0_7 <= slice0other_winner_0_6;
        end if;
        if slice0other_cost_0_choice(8) then
          slice0other_cost_0(8) <= slice0window_sum_0(8);
          slice0other_winner_0_8 <= 8;
        else
          slice0other_cost_0(8) <= slice0other_cost_0(7);
          slice0other_winner_0_8 <= slice0other_winner_0_7;
        end if;
        if slice0other_cost_0_choice(9) then
          slice0other_cost_0(9) <= slice0window_sum_0(9);
          slice0other_winner_0_9 <= 9;
        else
          slice0other_cost_0(9) <= slice0other_cost_0(8);
          slice0other_winner_0_9 <= slice0other_winner_0_8;
        end if;
        if slice0other_cost_0_choice(10) then
          slice0other_cost_0(10) <= slice0window_sum_0(10);
          slice0other_winner_0_10 <= 10;
        else
          slice0other_cost_0(10) <= slice0other_cost_0(9);
          slice0other_winner_0_10 <= slice0other_winner_0_9;
        end if;
        if slice0other_cost_0_choice(11) then
          slice0other_cost_0(11) <= slice0window_sum_0(11);
          slice0other_winner_0_11 <= 11;
        else
          slice0other_cost_0(11) <= slice0other_cost_0(10);
          slice0other_winner_0_11 <= slice0other_winner_0_10;
        end if;
        if slice0other_cost_0_choice(12) then
          slice0other_cost_0(12) <= slice0window_sum_0(12);
          slice0other_winner_0_12 <= 12;
        else
          slice0other_cost_0(12) <= slice0other_cost_0(11);
          slice0other_winner_0_12 <= slice0other_winner_0_11;
        end if;
        if slice0other_cost_0_choice(13) then
          slice0other_cost_0(13) <= slice0window_sum_0(13);
          slice0other_winner_0_13 <= 13;
        else
          slice0other_cost_0(13) <= slice0other_cost_0(12);
          slice0other_winner_0_13 <= slice0other_winner_0_12;
        end if;
        if slice0other_cost_0_choice(14) then
          slice0other_cost_0(14) <= slice0window_sum_0(14);
          slice0other_winner_0_14 <= 14;
        else
          slice0other_cost_0(14) <= slice0other_cost_0(13);
          slice0other_winner_0_14 <= slice0other_winner_0_13;
        end if;
        if slice0other_cost_0_15_all then
          slice0other_cost_0(15) <= slice0window_sum_0(15);
          slice0other_winner_0_15 <= 15;
        else
          slice0other_cost_0(15) <= slice0other_cost_0(14);
          slice0other_winner_0_15 <= slice0other_winner_0_14;
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0(15);
      slice0other_winner_out_0 <= slice0other_winner_0_15;
      -- slice0winner1
      for i in 0 to 15 loop
        if slice0mask_inside(i) then
          slice0winner1_held_0_choice(i) := 0;
        else
          slice0winner1_held_0_choice(i) := 2047;
        end if;
        slice0winner1_held_0_any(i) := to_integer(((to_unsigned(slice0window_sum_0(i), 11)) or
          (to_unsigned(slice0winner1_held_0_choice(i), 11))));
      end loop;
      for i in 0 to 7 loop
        slice0winner1_best_cost_0_is_less(i) := (slice0winner1_held_0_any(2 * i + 1) - slice0winner1_held_0_any(2 * i))
          < 0;
      end loop;
      for i in 0 to 15 loop
        slice0winner1_held_0(i) <= slice0winner1_held_0_any(i);
      end loop;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
      slice0winner1_best_place_0_2 <= slice0winner1_best_cost_0_is_less(2);
      slice0winner1_best_place_0_4 <= slice0winner1_best_cost_0_is_less(4);
      slice0winner1_best_place_0_6 <= slice0winner1_best_cost_0_is_less(6);
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
      if slice0winner1_best_cost_0_is_less(0) then
        slice0winner1_best_cost_0(0) <= slice0winner1_held_0_any(1);
        slice0winner1_best_below_0(0) <= slice0winner1_held_0_any(0);
        slice0winner1_best_above_0(0) <= 0;
      else
        slice0winner1_best_cost_0(0) <= slice0winner1_held_0_any(0);
        slice0winner1_best_below_0(0) <= 0;
        slice0winner1_best_above_0(0) <= slice0winner1_held_0_any(1);
      end if;
      if slice0winner1_best_cost_0_is_less(1) then
        slice0winner1_best_cost_0(1) <= slice0winner1_held_0_any(3);
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0(1) <= slice0winner1_held_0_any(2);
        slice0winner1_best_above_0(1) <= 0;
      else
        slice0winner1_best_cost_0(1) <= slice0winner1_held_0_any(2);
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0(1) <= 0;
        slice0winner1_best_above_0(1) <= slice0winner1_held_0_any(3);
      end if;
      if slice0winner1_best_cost_0_is_less(2) then
        slice0winner1_best_cost_0(2) <= slice0winner1_held_0_any(5);
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0(2) <= slice0winner1_held_0_any(4);
        slice0winner1_best_above_0(2) <= 0;
      else
        slice0winner1_best_cost_0(2) <= slice0winner1_held_0_any(4);
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0(2) <= 0;
        slice0winner1_best_above_0(2) <= slice0winner1_held_0_any(5);
      end if;
      if slice0winner1_best_cost_0_is_less(3) then
        slice0winner1_best_cost_0(3) <= slice0winner1_held_0_any(7);
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0(3) <= slice0winner1_held_0_any(6);
        slice0winner1_best_above_0(3) <= 0;
      else
        slice0winner1_best_cost_0(3) <= slice0winner1_held_0_any(6);
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0(3) <= 0;
        slice0winner1_best_above_0(3) <= slice0winner1_held_0_any(7);
      end if;
      if slice0winner1_best_cost_0_is_less(4) then
        slice0winner1_best_cost_0(4) <= slice0winner1_held_0_any(9);
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0(4) <= slice0winner1_held_0_any(8);
        slice0winner1_best_above_0(4) <= 0;
      else
        slice0winner1_best_cost_0(4) <= slice0winner1_held_0_any(8);
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0(4) <= 0;
        slice0winner1_best_above_0(4) <= slice0winner1_held_0_any(9);
      end if;
      if slice0winner1_best_cost_0_is_less(5) then
        slice0winner1_best_cost_0(5) <= slice0winner1_held_0_any(11);
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0(5) <= slice0winner1_held_0_any(10);
        slice0winner1_best_above_0(5) <= 0;
      else
        slice0winner1_best_cost_0(5) <= slice0winner1_held_0_any(10);
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0(5) <= 0;
        slice0winner1_best_above_0(5) <= slice0winner1_held_0_any(11);
      end if;
      if slice0winner1_best_cost_0_is_less(6) then
        slice0winner1_best_cost_0(6) <= slice0winner1_held_0_any(13);
        slice0winner1_best_index_0_6 <= 13;
        slice0winner1_best_below_0(6) <= slice0winner1_held_0_any(12);
        slice0winner1_best_above_0(6) <= 0;
      else
        slice0winner1_best_cost_0(6) <= slice0winner1_held_0_any(12);
        slice0winner1_best_index_0_6 <= 12;
        slice0winner1_best_below_0(6) <= 0;
        slice0winner1_best_above_0(6) <= slice0winner1_held_0_any(13);
      end if;
      if slice0winner1_best_cost_0_is_less(7) then
        slice0winner1_best_cost_0(7) <= slice0winner1_held_0_any(15);
        slice0winner1_best_index_0_7 <= 15;
        slice0winner1_best_below_0(7) <= slice0winner1_held_0_any(14);
        slice0winner1_best_above_0(7) <= 0;
      else
        slice0winner1_best_cost_0(7) <= slice0winner1_held_0_any(14);
        slice0winner1_best_index_0_7 <= 14;
        slice0winner1_best_below_0(7) <= 0;
        slice0winner1_best_above_0(7) <= slice0winner1_held_0_any(15);
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice2window_centre_map_column(2);
        slice0winner1_tag_output_column <= slice2window_centre_output_column(2);
        slice0winner1_tag_first_column <= slice2window_centre_first_column(2);
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice2window_centre_end_of_line(2);
      end if;
      -- slice0winner2
      for i in 0 to 3 loop
        slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice0winner2_best_below_0_is_equal(0) := slice0winner1_best_index_0_1 = 2;
      if slice0winner2_best_below_0_is_equal(0) then
        slice0winner2_best_below_0_choice(0) := slice0winner1_held_0(1);
      else
        slice0winner2_best_below_0_choice(0) := slice0winner1_best_below_0(1);
      end if;
      slice0winner2_best_below_0_is_equal(1) := slice0winner1_best_index_0_3 = 6;
      if slice0winner2_best_below_0_is_equal(1) then
        slice0winner2_best_below_0_choice(1) := slice0winner1_held_0(5);
      else
        slice0winner2_best_below_0_choice(1) := slice0winner1_best_below_0(3);
      end if;
      slice0winner2_best_below_0_is_equal(2) := (slice0winner1_best_index_0_5 mod 4) = 2;
      if is_set(slice0winner1_best_index_0_5, 3) and slice0winner2_best_below_0_is_equal(2) then
        slice0winner2_best_below_0_choice(2) := slice0winner1_held_0(9);
      else
        slice0winner2_best_below_0_choice(2) := slice0winner1_best_below_0(5);
      end if;
      slice0winner2_best_below_0_is_equal(3) := slice0winner1_best_index_0_7 = 14;
      if slice0winner2_best_below_0_is_equal(3) then
        slice0winner2_best_below_0_choice(3) := slice0winner1_held_0(13);
      else
        slice0winner2_best_below_0_choice(3) := slice0winner1_best_below_0(7);
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_choice(0) := slice0winner1_held_0(2);
      else
        slice0winner2_best_above_0_choice(0) := slice0winner1_best_above_0(0);
      end if;
      if slice0winner1_best_place_0_2 then
        slice0winner2_best_above_0_choice(1) := slice0winner1_held_0(6);
      else
        slice0winner2_best_above_0_choice(1) := slice0winner1_best_above_0(2);
      end if;
      if slice0winner1_best_place_0_4 then
        slice0winner2_best_above_0_choice(2) := slice0winner1_held_0(10);
      else
        slice0winner2_best_above_0_choice(2) := slice0winner1_best_above_0(4);
      end if;
      if slice0winner1_best_place_0_6 then
        slice0winner2_best_above_0_choice(3) := slice0winner1_held_0(14);
      else
        slice0winner2_best_above_0_choice(3) := slice0winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice0winner2_best_place_0(i) then
          slice0winner2_best_second_0_choice(i) := 2047;
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
          slice0winner2_best_second_0_choices(i, 3) := 2047;
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
      slice0winner2_best_place_0(0) <= slice0winner2_best_cost_0_is_less(0);
      slice0winner2_best_place_0(1) <= slice0winner2_best_cost_0_is_less(1);
      slice0winner2_best_place_0(2) <= slice0winner2_best_cost_0_is_less(2);
      slice0winner2_best_place_0(3) <= slice0winner2_best_cost_0_is_less(3);
      slice0winner2_best_at_start_0(0) <= slice0winner2_best_cost_0_is_less(0) and
        slice0winner2_best_below_0_is_equal(0);
      slice0winner2_best_at_start_0(1) <= slice0winner2_best_cost_0_is_less(1) and
        slice0winner2_best_below_0_is_equal(1);
      slice0winner2_best_at_start_0(2) <= slice0winner2_best_cost_0_is_less(2) and is_set(slice0winner1_best_index_0_5,
        3) and slice0winner2_best_below_0_is_equal(2);
      slice0winner2_best_at_start_0(3) <= slice0winner2_best_below_0_is_equal(3) and
        slice0winner2_best_cost_0_is_less(3);
      slice0winner2_best_at_end_0(0) <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0(1) -
        slice0winner1_best_cost_0(0)) >= 0);
      slice0winner2_best_at_end_0(1) <= slice0winner1_best_place_0_2 and ((slice0winner1_best_cost_0(3) -
        slice0winner1_best_cost_0(2)) >= 0);
      slice0winner2_best_at_end_0(2) <= slice0winner1_best_place_0_4 and ((slice0winner1_best_cost_0(5) -
        slice0winner1_best_cost_0(4)) >= 0);
      slice0winner2_best_at_end_0(3) <= slice0winner1_best_place_0_6 and ((slice0winner1_best_cost_0(7) -
        slice0winner1_best_cost_0(6)) >= 0);
      slice0winner2_best_late_cost_0(0) <= slice0winner2_best_cost_0(0);
      slice0winner2_best_late_cost_0(1) <= slice0winner2_best_cost_0(1);
      slice0winner2_best_late_cost_0(2) <= slice0winner2_best_cost_0(2);
      slice0winner2_best_late_cost_0(3) <= slice0winner2_best_cost_0(3);
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_first_column <= slice0winner1_tag_first_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_is_less(0) then
        slice0winner2_best_cost_0(0) <= slice0winner1_best_cost_0(1);
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0(0) <= slice0winner2_best_below_0_choice(0);
        slice0winner2_best_above_0(0) <= slice0winner1_best_above_0(1);
      else
        slice0winner2_best_cost_0(0) <= slice0winner1_best_cost_0(0);
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0(0) <= slice0winner1_best_below_0(0);
        slice0winner2_best_above_0(0) <= slice0winner2_best_above_0_choice(0);
      end if;
      if slice0winner2_best_cost_0_is_less(1) then
        slice0winner2_best_cost_0(1) <= slice0winner1_best_cost_0(3);
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
        slice0winner2_best_below_0(1) <= slice0winner2_best_below_0_choice(1);
        slice0winner2_best_above_0(1) <= slice0winner1_best_above_0(3);
      else
        slice0winner2_best_cost_0(1) <= slice0winner1_best_cost_0(2);
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
        slice0winner2_best_below_0(1) <= slice0winner1_best_below_0(2);
        slice0winner2_best_above_0(1) <= slice0winner2_best_above_0_choice(1);
      end if;
      if slice0winner2_best_cost_0_is_less(2) then
        slice0winner2_best_cost_0(2) <= slice0winner1_best_cost_0(5);
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
        slice0winner2_best_below_0(2) <= slice0winner2_best_below_0_choice(2);
        slice0winner2_best_above_0(2) <= slice0winner1_best_above_0(5);
      else
        slice0winner2_best_cost_0(2) <= slice0winner1_best_cost_0(4);
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
        slice0winner2_best_below_0(2) <= slice0winner1_best_below_0(4);
        slice0winner2_best_above_0(2) <= slice0winner2_best_above_0_choice(2);
      end if;
      if slice0winner2_best_cost_0_is_less(3) then
        slice0winner2_best_cost_0(3) <= slice0winner1_best_cost_0(7);
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
        slice0winner2_best_below_0(3) <= slice0winner2_best_below_0_choice(3);
        slice0winner2_best_above_0(3) <= slice0winner1_best_above_0(7);
      else
        slice0winner2_best_cost_0(3) <= slice0winner1_best_cost_0(6);
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
      -- slice0winner3
      slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
      slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
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
      slice0winner3_best_place_0(0) <= slice0winner3_best_cost_0_is_less(0);
      slice0winner3_best_place_0(1) <= slice0winner3_best_cost_0_is_less(1);
      slice0winner3_best_at_start_0(0) <= slice0winner3_best_cost_0_is_less(0) and
        slice0winner3_best_below_0_is_equal(0);
      slice0winner3_best_at_start_0(1) <= slice0winner3_best_below_0_is_equal(1) and
        slice0winner3_best_cost_0_is_less(1);
      slice0winner3_best_at_end_0(0) <= ((slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) >= 0) and
        slice0winner3_best_above_0_is_equal(0);
      slice0winner3_best_at_end_0(1) <= ((slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) >= 0) and
        is_set(slice0winner2_best_index_0_2, 3) and slice0winner3_best_above_0_is_equal(1);
      slice0winner3_best_late_cost_0(0) <= slice0winner3_best_cost_0(0);
      slice0winner3_best_late_cost_0(1) <= slice0winner3_best_cost_0(1);
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if slice0winner3_best_cost_0_is_less(0) then
        slice0winner3_best_cost_0(0) <= slice0winner2_best_cost_0(1);
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0(0) <= slice0winner3_best_below_0_choice(0);
        slice0winner3_best_above_0(0) <= slice0winner2_best_above_0(1);
      else
        slice0winner3_best_cost_0(0) <= slice0winner2_best_cost_0(0);
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0(0) <= slice0winner2_best_below_0(0);
        slice0winner3_best_above_0(0) <= slice0winner3_best_above_0_choice(0);
      end if;
      if slice0winner3_best_cost_0_is_less(1) then
        slice0winner3_best_cost_0(1) <= slice0winner2_best_cost_0(3);
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
        slice0winner3_best_below_0(1) <= slice0winner3_best_below_0_choice(1);
        slice0winner3_best_above_0(1) <= slice0winner2_best_above_0(3);
      else
        slice0winner3_best_cost_0(1) <= slice0winner2_best_cost_0(2);
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
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
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
      slice0winner4_best_place_0_0 <= slice0winner4_best_cost_0_0_is_less;
      slice0winner4_best_at_start_0_0 <= slice0winner4_best_below_0_0_is_equal and slice0winner4_best_cost_0_0_is_less;
      slice0winner4_best_at_end_0_0 <= ((slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) >= 0) and
        slice0winner4_best_above_0_0_is_equal;
      slice0winner4_best_late_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_map_column <= slice0winner3_tag_map_column;
      slice0winner4_tag_output_column <= slice0winner3_tag_output_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if slice0winner4_best_cost_0_0_is_less then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0(1);
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
        slice0winner4_best_below_0_0 <= slice0winner4_best_below_0_0_choice;
        slice0winner4_best_above_0_0 <= slice0winner3_best_above_0(1);
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0(0);
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
        slice0winner4_best_below_0_0 <= slice0winner3_best_below_0(0);
        slice0winner4_best_above_0_0 <= slice0winner4_best_above_0_0_choice;
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
      slice0_best_place_0 <= median_read_bottom;
      slice0_best_late_cost_0_0 <= slice0winner4_best_late_cost_0_0;
      slice0_best_second_0_0 <= slice0winner4_best_second_0_0;
      slice0_best_but_last_0_0 <= slice0winner4_best_but_last_0_0;
      slice0_best_tag_valid <= slice0winner4_tag_valid;
      slice0_best_tag_map_column <= slice0winner4_tag_map_column;
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
      for i in 0 to 1 loop
        slice1cost_pixels_first_0_count_value(i, 0) := is_set(slice1shift_reference(i), 2);
        slice1cost_pixels_first_0_count_value_2(i, 0) := is_set(slice1shift_reference(i), 1);
        slice1cost_pixels_first_0_count_value(i, 1) := is_set(slice1shift_reference(i), 3);
        slice1cost_pixels_first_0_count_value_2(i, 1) := is_set(slice1shift_reference(i), 5);
        slice1cost_pixels_first_0_count_1_value_3(i) := is_set(slice1shift_reference(i), 4);
        slice1cost_pixels_first_0_count_value(i, 2) := is_set(slice1shift_reference(i), 8);
        slice1cost_pixels_first_0_count_value_2(i, 2) := is_set(slice1shift_reference(i), 6);
        for j in 3 to 6 loop
          slice1cost_pixels_first_0_count_value(i, j) := is_set(slice1shift_reference(i), 3 * j);
          slice1cost_pixels_first_0_count_value_2(i, j) := is_set(slice1shift_reference(i), 3 * j + 2);
          slice1cost_pixels_first_0_count_value_3(i, j) := is_set(slice1shift_reference(i), 3 * j + 1);
        end loop;
        slice1cost_pixels_first_0_count_value(i, 7) := is_set(slice1shift_reference(i), 21);
        slice1cost_pixels_first_0_count_value_2(i, 7) := is_set(slice1shift_reference(i), 22);
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 3 loop
          if slice0cost_tag_first_group then
            slice1cost_column_0_choice(4 * i + j) := 0;
          else
            slice1cost_column_0_choice(4 * i + j) := to_integer(slice1cost_ready_words(i)(8 * j + 7 downto 8 * j));
          end if;
          slice1cost_column_0_value(4 * i + j) := (slice1cost_change_0(4 * i + j) + slice1cost_column_0_choice(4 * i +
            j)) mod 256;
        end loop;
      end loop;
      for i in 0 to 1 loop
        slice1cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice1shift_search(i, 0), 0) /=
          is_set(slice1shift_reference(i), 0))) + as_number((slice1cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice1shift_search(i, 0), 2))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice1shift_search(i, 0), 1)));
        slice1cost_pixels_first_count(i, 0, 1) <= as_number((slice1cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice1shift_search(i, 0), 3))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice1shift_search(i, 0), 5))) + as_number((slice1cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice1shift_search(i, 0), 4)));
        slice1cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice1cost_pixels_first_0_count_value(i, 2) /= is_set(slice1shift_search(i, 0), 8))) +
          as_number((slice1cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice1shift_search(i, 0), 6)));
        for j in 3 to 6 loop
          slice1cost_pixels_first_count(i, 0, j) <= as_number((slice1cost_pixels_first_0_count_value(i, j) /=
            is_set(slice1shift_search(i, 0), 3 * j))) + as_number((slice1cost_pixels_first_0_count_value_2(i, j) /=
            is_set(slice1shift_search(i, 0), 3 * j + 2))) + as_number((slice1cost_pixels_first_0_count_value_3(i, j) /=
            is_set(slice1shift_search(i, 0), 3 * j + 1)));
        end loop;
        slice1cost_pixels_first_count(i, 0, 7) <= as_number((slice1cost_pixels_first_0_count_value(i, 7) /=
          is_set(slice1shift_search(i, 0), 21))) + as_number((is_set(slice1shift_reference(i), 23) /=
          is_set(slice1shift_search(i, 0), 23))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 7) /=
          is_set(slice1shift_search(i, 0), 22)));
        for j in 1 to 15 loop
          slice1cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice1shift_search(i, j), 0) /=
            is_set(slice1shift_reference(i), 0))) + as_number((is_set(slice1shift_search(i, j), 2) /=
            slice1cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice1shift_search(i, j), 1) /=
            slice1cost_pixels_first_0_count_value_2(i, 0)));
          slice1cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice1shift_search(i, j), 3) /=
            slice1cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice1shift_search(i, j), 5) /=
            slice1cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice1shift_search(i, j), 4) /=
            slice1cost_pixels_first_0_count_1_value_3(i)));
          slice1cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice1shift_search(i,
            j), 8) /= slice1cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice1shift_search(i, j), 6) /=
            slice1cost_pixels_first_0_count_value_2(i, 2)));
          for k in 3 to 6 loop
            slice1cost_pixels_first_count(i, j, k) <= as_number((is_set(slice1shift_search(i, j), 3 * k) /=
              slice1cost_pixels_first_0_count_value(i, k))) + as_number((is_set(slice1shift_search(i, j), 3 * k + 2) /=
              slice1cost_pixels_first_0_count_value_2(i, k))) + as_number((is_set(slice1shift_search(i, j), 3 * k + 1)
              /= slice1cost_pixels_first_0_count_value_3(i, k)));
          end loop;
          slice1cost_pixels_first_count(i, j, 7) <= as_number((is_set(slice1shift_search(i, j), 21) /=
            slice1cost_pixels_first_0_count_value(i, 7))) + as_number((is_set(slice1shift_search(i, j), 23) /=
            is_set(slice1shift_reference(i), 23))) + as_number((is_set(slice1shift_search(i, j), 22) /=
            slice1cost_pixels_first_0_count_value_2(i, 7)));
        end loop;
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 0) + slice1cost_pixels_first_count(i, j,
            2) + slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j, 5) +
            slice1cost_pixels_first_count(i, j, 6) + slice1cost_pixels_first_count(i, j, 4) +
            slice1cost_pixels_first_count(i, j, 7) + slice1cost_pixels_first_count(i, j, 1);
        end loop;
      end loop;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice0cost_change_column;
      for i in 0 to 15 loop
        slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
      end loop;
      slice1cost_ready_words(0) <= slice1cost_read_words(0);
      slice1cost_ready_words(1) <= slice1cost_read_words(1);
      slice1cost_ready_words(2) <= slice1cost_read_words(2);
      slice1cost_ready_words(3) <= slice1cost_read_words(3);
      slice1cost_ready_column <= slice1cost_change_column;
      for i in 0 to 15 loop
        slice1cost_column_0(i) <= slice1cost_column_0_value(i);
      end loop;
      slice1cost_write_column <= slice0cost_write_column;
      if slice0cost_tag_valid then
        for i in 0 to 3 loop
          slice1cost_write_words(i) <= to_unsigned(slice1cost_column_0_value(4 * i + 3), 8) &
            to_unsigned(slice1cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice1cost_column_0_value(4 * i + 1), 8)
            & to_unsigned(slice1cost_column_0_value(4 * i), 8);
        end loop;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 9 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 16;
        end if;
      end if;
      for i in 0 to 1 loop
        for j in 0 to 3 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(8 * i + j) := to_integer(slice1window_leaving(2 * i)(8 * j + 7 downto 8 * j));
          else
            slice1window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
        for j in 4 to 7 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(8 * i + j) := to_integer(slice1window_leaving(2 * i + 1)(8 * j - 25 downto 8 *
              j - 32));
          else
            slice1window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice1window_entering_0(i) <= slice1cost_column_0(i);
      end loop;
      for i in 0 to 15 loop
        slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
      end loop;
      slice1window_change_tag_row_start <= slice0window_change_tag_row_start;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_change_tag_output_column <= slice0window_change_tag_output_column;
      slice1window_change_tag_first_column <= slice0window_change_tag_first_column;
      slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
      slice1window_centre_output_column(0) <= slice1window_change_tag_output_column;
      slice1window_centre_first_column(0) <= slice1window_change_tag_first_column;
      slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      slice1window_tag_output_column <= slice1window_centre_output_column(3);
      slice1window_tag_first_column <= slice1window_centre_first_column(3);
      for i in 0 to 15 loop
        if slice1window_change_tag_row_start then
          slice1window_sum_0_choice(i) := 0;
        else
          slice1window_sum_0_choice(i) := slice1window_sum_0(i);
        end if;
      end loop;
      if slice0window_tag_valid then
        for i in 0 to 15 loop
          slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 2048;
        end loop;
        slice1window_centre_output_column(1) <= slice2window_change_tag_output_column;
        slice1window_centre_output_column(2) <= slice1window_centre_output_column(1);
        slice1window_centre_output_column(3) <= slice1window_centre_output_column(2);
        slice1window_centre_first_column(1) <= slice2window_change_tag_first_column;
        slice1window_centre_first_column(2) <= slice1window_centre_first_column(1);
        slice1window_centre_first_column(3) <= slice1window_centre_first_column(2);
      end if;
      -- slice1mask
      slice1mask_inside_0_all := (not slice0window_tag_valid) and slice1mask_inside(0);
      if slice1window_centre_first_column(3) then
        slice1mask_inside_choice(0) := slice1mask_inside_0_all;
      else
        slice1mask_inside_choice(0) := slice0window_tag_valid or slice1mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0window_tag_valid then
          slice1mask_inside_choice(i) := slice1mask_inside(i - 1);
        else
          slice1mask_inside_choice(i) := slice1mask_inside(i);
        end if;
      end loop;
      slice1mask_left_out <= slice1mask_inside(15);
      if slice0mask_left_out then
        slice1mask_inside(0) <= slice1mask_inside_choice(0);
      else
        slice1mask_inside(0) <= slice1mask_inside_0_all;
      end if;
      if slice1window_centre_first_column(3) then
        for i in 1 to 15 loop
          slice1mask_inside(i) <= (not slice0window_tag_valid) and slice1mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice1mask_inside(i) <= slice1mask_inside_choice(i);
        end loop;
      end if;
      -- slice1other
      if (slice1window_sum_0(0) - slice0other_cost_out_0) < 0 then
        slice1other_cost_0_choice(0) := slice1window_tag_output_column and slice1mask_inside(0);
      else
        slice1other_cost_0_choice(0) := slice1window_tag_output_column and slice1window_tag_first_column and
          slice1mask_inside(0);
      end if;
      for i in 1 to 14 loop
        if (slice1window_sum_0(i) - slice1other_cost_0(i - 1)) < 0 then
          slice1other_cost_0_choice(i) := slice1window_tag_output_column and slice1mask_inside(i);
        else
          slice1other_cost_0_choice(i) := slice1window_tag_output_column and slice1window_tag_first_column and
            slice1mask_inside(i);
        end if;
      end loop;
      if slice1window_tag_first_column then
        slice1other_cost_0_choice(15) := slice1mask_inside(15);
      else
        slice1other_cost_0_choice(15) := ((slice1window_sum_0(15) - slice1other_cost_0(14)) < 0) and
          slice1mask_inside(15);
      end if;
      slice1other_cost_0_15_all := slice1window_tag_output_column and slice1other_cost_0_choice(15);
      if slice0winner1_tag_valid then
        if slice1other_cost_0_choice(0) then
          slice1other_cost_0(0) <= slice1window_sum_0(0);
          slice1other_winner_0_0 <= 16;
        else
          slice1other_cost_0(0) <= slice0other_cost_out_0;
          slice1other_winner_0_0 <= slice0other_winner_out_0;
        end if;
        if slice1other_cost_0_choice(1) then
          slice1other_cost_0(1) <= slice1window_sum_0(1);
          slice1other_winner_0_1 <= 17;
        else
          slice1other_cost_0(1) <= slice1other_cost_0(0);
          slice1other_winner_0_1 <= slice1other_winner_0_0;
        end if;
        if slice1other_cost_0_choice(2) then
          slice1other_cost_0(2) <= slice1window_sum_0(2);
          slice1other_winner_0_2 <= 18;
        else
          slice1other_cost_0(2) <= slice1other_cost_0(1);
          slice1other_winner_0_2 <= slice1other_winner_0_1;
        end if;
        if slice1other_cost_0_choice(3) then
          slice1other_cost_0(3) <= slice1window_sum_0(3);
          slice1other_winner_0_3 <= 19;
        else
          slice1other_cost_0(3) <= slice1other_cost_0(2);
          slice1other_winner_0_3 <= slice1other_winner_0_2;
        end if;
        if slice1other_cost_0_choice(4) then
          slice1other_cost_0(4) <= slice1window_sum_0(4);
          slice1other_winner_0_4 <= 20;
        else
          slice1other_cost_0(4) <= slice1other_cost_0(3);
          slice1other_winner_0_4 <= slice1other_winner_0_3;
        end if;
        if slice1other_cost_0_choice(5) then
          slice1other_cost_0(5) <= slice1window_sum_0(5);
          slice1other_winner_0_5 <= 21;
        else
          slice1other_cost_0(5) <= slice1other_cost_0(4);
          slice1other_winner_0_5 <= slice1other_winner_0_4;
        end if;
        if slice1other_cost_0_choice(6) then
          slice1other_cost_0(6) <= slice1window_sum_0(6);
          slice1other_winner_0_6 <= 22;
        else
          slice1other_cost_0(6) <= slice1other_cost_0(5);
          slice1other_winner_0_6 <= slice1other_winner_0_5;
        end if;
        if slice1other_cost_0_choice(7) then
          slice1other_cost_0(7) <= slice1window_sum_0(7);
          slice1other_winner_0_7 <= 23;
        else
          slice1other_cost_0(7) <= slice1other_cost_0(6);
          slice1other_winner_0_7 <= slice1other_winner_0_6;
        end if;
        if slice1other_cost_0_choice(8) then
          slice1other_cost_0(8) <= slice1window_sum_0(8);
          slice1other_winner_0_8 <= 24;
        else
          slice1other_cost_0(8) <= slice1other_cost_0(7);
          slice1other_winner_0_8 <= slice1other_winner_0_7;
        end if;
        if slice1other_cost_0_choice(9) then
          slice1other_cost_0(9) <= slice1window_sum_0(9);
          slice1other_winner_0_9 <= 25;
        else
          slice1other_cost_0(9) <= slice1other_cost_0(8);
          slice1other_winner_0_9 <= slice1other_winner_0_8;
        end if;
        if slice1other_cost_0_choice(10) then
          slice1other_cost_0(10) <= slice1window_sum_0(10);
          slice1other_winner_0_10 <= 26;
        else
          slice1other_cost_0(10) <= slice1other_cost_0(9);
          slice1other_winner_0_10 <= slice1other_winner_0_9;
        end if;
        if slice1other_cost_0_choice(11) then
          slice1other_cost_0(11) <= slice1window_sum_0(11);
          slice1other_winner_0_11 <= 27;
        else
          slice1other_cost_0(11) <= slice1other_cost_0(10);
          slice1other_winner_0_11 <= slice1other_winner_0_10;
        end if;
        if slice1other_cost_0_choice(12) then
          slice1other_cost_0(12) <= slice1window_sum_0(12);
          slice1other_winner_0_12 <= 28;
        else
          slice1other_cost_0(12) <= slice1other_cost_0(11);
          slice1other_winner_0_12 <= slice1other_winner_0_11;
        end if;
        if slice1other_cost_0_choice(13) then
          slice1other_cost_0(13) <= slice1window_sum_0(13);
          slice1other_winner_0_13 <= 29;
        else
          slice1other_cost_0(13) <= slice1other_cost_0(12);
          slice1other_winner_0_13 <= slice1other_winner_0_12;
        end if;
        if slice1other_cost_0_choice(14) then
          slice1other_cost_0(14) <= slice1window_sum_0(14);
          slice1other_winner_0_14 <= 30;
        else
          slice1other_cost_0(14) <= slice1other_cost_0(13);
          slice1other_winner_0_14 <= slice1other_winner_0_13;
        end if;
        if slice1other_cost_0_15_all then
          slice1other_cost_0(15) <= slice1window_sum_0(15);
          slice1other_winner_0_15 <= 31;
        else
          slice1other_cost_0(15) <= slice1other_cost_0(14);
          slice1other_winner_0_15 <= slice1other_winner_0_14;
        end if;
      end if;
      slice1other_cost_out_0 <= slice1other_cost_0(15);
      slice1other_winner_out_0 <= slice1other_winner_0_15;
      -- slice1winner1
      for i in 0 to 15 loop
        if slice1mask_inside(i) then
          slice1winner1_held_0_choice(i) := 0;
        else
          slice1winner1_held_0_choice(i) := 2047;
        end if;
        slice1winner1_held_0_any(i) := to_integer(((to_unsigned(slice1window_sum_0(i), 11)) or
          (to_unsigned(slice1winner1_held_0_choice(i), 11))));
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_cost_0_is_less(i) := (slice1winner1_held_0_any(2 * i + 1) - slice1winner1_held_0_any(2 * i))
          < 0;
      end loop;
      for i in 0 to 15 loop
        slice1winner1_held_0(i) <= slice1winner1_held_0_any(i);
      end loop;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
      slice1winner1_best_place_0_2 <= slice1winner1_best_cost_0_is_less(2);
      slice1winner1_best_place_0_4 <= slice1winner1_best_cost_0_is_less(4);
      slice1winner1_best_place_0_6 <= slice1winner1_best_cost_0_is_less(6);
      for i in 0 to 7 loop
        slice1winner1_best_late_cost_0(i) <= slice1winner1_best_cost_0(i);
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_but_first_0(i) <= slice1winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_but_last_0(i) <= slice1winner1_held_0(2 * i);
      end loop;
      if slice1winner1_best_cost_0_is_less(0) then
        slice1winner1_best_cost_0(0) <= slice1winner1_held_0_any(1);
        slice1winner1_best_below_0(0) <= slice1winner1_held_0_any(0);
        slice1winner1_best_above_0(0) <= 0;
      else
        slice1winner1_best_cost_0(0) <= slice1winner1_held_0_any(0);
        slice1winner1_best_below_0(0) <= 0;
        slice1winner1_best_above_0(0) <= slice1winner1_held_0_any(1);
      end if;
      if slice1winner1_best_cost_0_is_less(1) then
        slice1winner1_best_cost_0(1) <= slice1winner1_held_0_any(3);
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0(1) <= slice1winner1_held_0_any(2);
        slice1winner1_best_above_0(1) <= 0;
      else
        slice1winner1_best_cost_0(1) <= slice1winner1_held_0_any(2);
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0(1) <= 0;
        slice1winner1_best_above_0(1) <= slice1winner1_held_0_any(3);
      end if;
      if slice1winner1_best_cost_0_is_less(2) then
        slice1winner1_best_cost_0(2) <= slice1winner1_held_0_any(5);
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0(2) <= slice1winner1_held_0_any(4);
        slice1winner1_best_above_0(2) <= 0;
      else
        slice1winner1_best_cost_0(2) <= slice1winner1_held_0_any(4);
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0(2) <= 0;
        slice1winner1_best_above_0(2) <= slice1winner1_held_0_any(5);
      end if;
      if slice1winner1_best_cost_0_is_less(3) then
        slice1winner1_best_cost_0(3) <= slice1winner1_held_0_any(7);
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0(3) <= slice1winner1_held_0_any(6);
        slice1winner1_best_above_0(3) <= 0;
      else
        slice1winner1_best_cost_0(3) <= slice1winner1_held_0_any(6);
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0(3) <= 0;
        slice1winner1_best_above_0(3) <= slice1winner1_held_0_any(7);
      end if;
      if slice1winner1_best_cost_0_is_less(4) then
        slice1winner1_best_cost_0(4) <= slice1winner1_held_0_any(9);
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0(4) <= slice1winner1_held_0_any(8);
        slice1winner1_best_above_0(4) <= 0;
      else
        slice1winner1_best_cost_0(4) <= slice1winner1_held_0_any(8);
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0(4) <= 0;
        slice1winner1_best_above_0(4) <= slice1winner1_held_0_any(9);
      end if;
      if slice1winner1_best_cost_0_is_less(5) then
        slice1winner1_best_cost_0(5) <= slice1winner1_held_0_any(11);
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0(5) <= slice1winner1_held_0_any(10);
        slice1winner1_best_above_0(5) <= 0;
      else
        slice1winner1_best_cost_0(5) <= slice1winner1_held_0_any(10);
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0(5) <= 0;
        slice1winner1_best_above_0(5) <= slice1winner1_held_0_any(11);
      end if;
      if slice1winner1_best_cost_0_is_less(6) then
        slice1winner1_best_cost_0(6) <= slice1winner1_held_0_any(13);
        slice1winner1_best_index_0_6 <= 13;
        slice1winner1_best_below_0(6) <= slice1winner1_held_0_any(12);
        slice1winner1_best_above_0(6) <= 0;
      else
        slice1winner1_best_cost_0(6) <= slice1winner1_held_0_any(12);
        slice1winner1_best_index_0_6 <= 12;
        slice1winner1_best_below_0(6) <= 0;
        slice1winner1_best_above_0(6) <= slice1winner1_held_0_any(13);
      end if;
      if slice1winner1_best_cost_0_is_less(7) then
        slice1winner1_best_cost_0(7) <= slice1winner1_held_0_any(15);
        slice1winner1_best_index_0_7 <= 15;
        slice1winner1_best_below_0(7) <= slice1winner1_held_0_any(14);
        slice1winner1_best_above_0(7) <= 0;
      else
        slice1winner1_best_cost_0(7) <= slice1winner1_held_0_any(14);
        slice1winner1_best_index_0_7 <= 14;
        slice1winner1_best_below_0(7) <= 0;
        slice1winner1_best_above_0(7) <= slice1winner1_held_0_any(15);
      end if;
      -- slice1winner2
      for i in 0 to 3 loop
        slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice1winner2_best_below_0_is_equal(0) := slice1winner1_best_index_0_1 = 2;
      if slice1winner2_best_below_0_is_equal(0) then
        slice1winner2_best_below_0_choice(0) := slice1winner1_held_0(1);
      else
        slice1winner2_best_below_0_choice(0) := slice1winner1_best_below_0(1);
      end if;
      slice1winner2_best_below_0_is_equal(1) := slice1winner1_best_index_0_3 = 6;
      if slice1winner2_best_below_0_is_equal(1) then
        slice1winner2_best_below_0_choice(1) := slice1winner1_held_0(5);
      else
        slice1winner2_best_below_0_choice(1) := slice1winner1_best_below_0(3);
      end if;
      slice1winner2_best_below_0_is_equal(2) := (slice1winner1_best_index_0_5 mod 4) = 2;
      if is_set(slice1winner1_best_index_0_5, 3) and slice1winner2_best_below_0_is_equal(2) then
        slice1winner2_best_below_0_choice(2) := slice1winner1_held_0(9);
      else
        slice1winner2_best_below_0_choice(2) := slice1winner1_best_below_0(5);
      end if;
      slice1winner2_best_below_0_is_equal(3) := slice1winner1_best_index_0_7 = 14;
      if slice1winner2_best_below_0_is_equal(3) then
        slice1winner2_best_below_0_choice(3) := slice1winner1_held_0(13);
      else
        slice1winner2_best_below_0_choice(3) := slice1winner1_best_below_0(7);
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_choice(0) := slice1winner1_held_0(2);
      else
        slice1winner2_best_above_0_choice(0) := slice1winner1_best_above_0(0);
      end if;
      if slice1winner1_best_place_0_2 then
        slice1winner2_best_above_0_choice(1) := slice1winner1_held_0(6);
      else
        slice1winner2_best_above_0_choice(1) := slice1winner1_best_above_0(2);
      end if;
      if slice1winner1_best_place_0_4 then
        slice1winner2_best_above_0_choice(2) := slice1winner1_held_0(10);
      else
        slice1winner2_best_above_0_choice(2) := slice1winner1_best_above_0(4);
      end if;
      if slice1winner1_best_place_0_6 then
        slice1winner2_best_above_0_choice(3) := slice1winner1_held_0(14);
      else
        slice1winner2_best_above_0_choice(3) := slice1winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice1winner2_best_place_0(i) then
          slice1winner2_best_second_0_choice(i) := 2047;
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
          slice1winner2_best_second_0_choices(i, 3) := 2047;
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
      slice1winner2_best_place_0(0) <= slice1winner2_best_cost_0_is_less(0);
      slice1winner2_best_place_0(1) <= slice1winner2_best_cost_0_is_less(1);
      slice1winner2_best_place_0(2) <= slice1winner2_best_cost_0_is_less(2);
      slice1winner2_best_place_0(3) <= slice1winner2_best_cost_0_is_less(3);
      slice1winner2_best_at_start_0(0) <= slice1winner2_best_cost_0_is_less(0) and
        slice1winner2_best_below_0_is_equal(0);
      slice1winner2_best_at_start_0(1) <= slice1winner2_best_cost_0_is_less(1) and
        slice1winner2_best_below_0_is_equal(1);
      slice1winner2_best_at_start_0(2) <= slice1winner2_best_cost_0_is_less(2) and is_set(slice1winner1_best_index_0_5,
        3) and slice1winner2_best_below_0_is_equal(2);
      slice1winner2_best_at_start_0(3) <= slice1winner2_best_below_0_is_equal(3) and
        slice1winner2_best_cost_0_is_less(3);
      slice1winner2_best_at_end_0(0) <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0(1) -
        slice1winner1_best_cost_0(0)) >= 0);
      slice1winner2_best_at_end_0(1) <= slice1winner1_best_place_0_2 and ((slice1winner1_best_cost_0(3) -
        slice1winner1_best_cost_0(2)) >= 0);
      slice1winner2_best_at_end_0(2) <= slice1winner1_best_place_0_4 and ((slice1winner1_best_cost_0(5) -
        slice1winner1_best_cost_0(4)) >= 0);
      slice1winner2_best_at_end_0(3) <= slice1winner1_best_place_0_6 and ((slice1winner1_best_cost_0(7) -
        slice1winner1_best_cost_0(6)) >= 0);
      slice1winner2_best_late_cost_0(0) <= slice1winner2_best_cost_0(0);
      slice1winner2_best_late_cost_0(1) <= slice1winner2_best_cost_0(1);
      slice1winner2_best_late_cost_0(2) <= slice1winner2_best_cost_0(2);
      slice1winner2_best_late_cost_0(3) <= slice1winner2_best_cost_0(3);
      if slice1winner2_best_cost_0_is_less(0) then
        slice1winner2_best_cost_0(0) <= slice1winner1_best_cost_0(1);
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
        slice1winner2_best_below_0(0) <= slice1winner2_best_below_0_choice(0);
        slice1winner2_best_above_0(0) <= slice1winner1_best_above_0(1);
      else
        slice1winner2_best_cost_0(0) <= slice1winner1_best_cost_0(0);
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0(0) <= slice1winner1_best_below_0(0);
        slice1winner2_best_above_0(0) <= slice1winner2_best_above_0_choice(0);
      end if;
      if slice1winner2_best_cost_0_is_less(1) then
        slice1winner2_best_cost_0(1) <= slice1winner1_best_cost_0(3);
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
        slice1winner2_best_below_0(1) <= slice1winner2_best_below_0_choice(1);
        slice1winner2_best_above_0(1) <= slice1winner1_best_above_0(3);
      else
        slice1winner2_best_cost_0(1) <= slice1winner1_best_cost_0(2);
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
        slice1winner2_best_below_0(1) <= slice1winner1_best_below_0(2);
        slice1winner2_best_above_0(1) <= slice1winner2_best_above_0_choice(1);
      end if;
      if slice1winner2_best_cost_0_is_less(2) then
        slice1winner2_best_cost_0(2) <= slice1winner1_best_cost_0(5);
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
        slice1winner2_best_below_0(2) <= slice1winner2_best_below_0_choice(2);
        slice1winner2_best_above_0(2) <= slice1winner1_best_above_0(5);
      else
        slice1winner2_best_cost_0(2) <= slice1winner1_best_cost_0(4);
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
        slice1winner2_best_below_0(2) <= slice1winner1_best_below_0(4);
        slice1winner2_best_above_0(2) <= slice1winner2_best_above_0_choice(2);
      end if;
      if slice1winner2_best_cost_0_is_less(3) then
        slice1winner2_best_cost_0(3) <= slice1winner1_best_cost_0(7);
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
        slice1winner2_best_below_0(3) <= slice1winner2_best_below_0_choice(3);
        slice1winner2_best_above_0(3) <= slice1winner1_best_above_0(7);
      else
        slice1winner2_best_cost_0(3) <= slice1winner1_best_cost_0(6);
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
      slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
      slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
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
      slice1winner3_best_place_0(0) <= slice1winner3_best_cost_0_is_less(0);
      slice1winner3_best_place_0(1) <= slice1winner3_best_cost_0_is_less(1);
      slice1winner3_best_at_start_0(0) <= slice1winner3_best_cost_0_is_less(0) and
        slice1winner3_best_below_0_is_equal(0);
      slice1winner3_best_at_start_0(1) <= slice1winner3_best_below_0_is_equal(1) and
        slice1winner3_best_cost_0_is_less(1);
      slice1winner3_best_at_end_0(0) <= ((slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) >= 0) and
        slice1winner3_best_above_0_is_equal(0);
      slice1winner3_best_at_end_0(1) <= ((slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) >= 0) and
        is_set(slice1winner2_best_index_0_2, 3) and slice1winner3_best_above_0_is_equal(1);
      slice1winner3_best_late_cost_0(0) <= slice1winner3_best_cost_0(0);
      slice1winner3_best_late_cost_0(1) <= slice1winner3_best_cost_0(1);
      if slice1winner3_best_cost_0_is_less(0) then
        slice1winner3_best_cost_0(0) <= slice1winner2_best_cost_0(1);
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0(0) <= slice1winner3_best_below_0_choice(0);
        slice1winner3_best_above_0(0) <= slice1winner2_best_above_0(1);
      else
        slice1winner3_best_cost_0(0) <= slice1winner2_best_cost_0(0);
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0(0) <= slice1winner2_best_below_0(0);
        slice1winner3_best_above_0(0) <= slice1winner3_best_above_0_choice(0);
      end if;
      if slice1winner3_best_cost_0_is_less(1) then
        slice1winner3_best_cost_0(1) <= slice1winner2_best_cost_0(3);
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
        slice1winner3_best_below_0(1) <= slice1winner3_best_below_0_choice(1);
        slice1winner3_best_above_0(1) <= slice1winner2_best_above_0(3);
      else
        slice1winner3_best_cost_0(1) <= slice1winner2_best_cost_0(2);
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
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
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
      slice1winner4_best_place_0_0 <= slice1winner4_best_cost_0_0_is_less;
      slice1winner4_best_at_start_0_0 <= slice1winner4_best_below_0_0_is_equal and slice1winner4_best_cost_0_0_is_less;
      slice1winner4_best_at_end_0_0 <= ((slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) >= 0) and
        slice1winner4_best_above_0_0_is_equal;
      slice1winner4_best_late_cost_0_0 <= slice1winner4_best_cost_0_0;
      if slice1winner4_best_cost_0_0_is_less then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(1);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
        slice1winner4_best_below_0_0 <= slice1winner4_best_below_0_0_choice;
        slice1winner4_best_above_0_0 <= slice1winner3_best_above_0(1);
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(0);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1winner4_best_below_0_0 <= slice1winner3_best_below_0(0);
        slice1winner4_best_above_0_0 <= slice1winner4_best_above_0_0_choice;
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
      slice1_best_cost_0_0_is_less := (slice1winner4_best_cost_0_0 - slice0winner4_best_late_cost_0_0) < 0;
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
      slice1_best_place_0_0 <= slice1_best_cost_0_0_is_less;
      slice1_best_at_start_0_0 <= slice1_best_below_0_0_is_equal and slice1_best_cost_0_0_is_less;
      slice1_best_at_end_0_0 <= slice1_best_above_0_0_is_equal and ((slice1winner4_best_cost_0_0 -
        slice0winner4_best_late_cost_0_0) >= 0);
      slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice1winner4_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner4_best_index_0_0 + 16;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner4_best_above_0_0;
      else
        slice1_best_cost_0_0 <= slice0winner4_best_late_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
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
      -- slice2cost
      for i in 0 to 1 loop
        slice2cost_pixels_first_0_count_value(i, 0) := is_set(slice2shift_reference(i), 2);
        slice2cost_pixels_first_0_count_value_2(i, 0) := is_set(slice2shift_reference(i), 1);
        slice2cost_pixels_first_0_count_value(i, 1) := is_set(slice2shift_reference(i), 3);
        slice2cost_pixels_first_0_count_value_2(i, 1) := is_set(slice2shift_reference(i), 5);
        slice2cost_pixels_first_0_count_1_value_3(i) := is_set(slice2shift_reference(i), 4);
        slice2cost_pixels_first_0_count_value(i, 2) := is_set(slice2shift_reference(i), 8);
        slice2cost_pixels_first_0_count_value_2(i, 2) := is_set(slice2shift_reference(i), 6);
        for j in 3 to 6 loop
          slice2cost_pixels_first_0_count_value(i, j) := is_set(slice2shift_reference(i), 3 * j);
          slice2cost_pixels_first_0_count_value_2(i, j) := is_set(slice2shift_reference(i), 3 * j + 2);
          slice2cost_pixels_first_0_count_value_3(i, j) := is_set(slice2shift_reference(i), 3 * j + 1);
        end loop;
        slice2cost_pixels_first_0_count_value(i, 7) := is_set(slice2shift_reference(i), 21);
        slice2cost_pixels_first_0_count_value_2(i, 7) := is_set(slice2shift_reference(i), 22);
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 3 loop
          if slice0window_entering_tag_first_group then
            slice2cost_column_0_choice(4 * i + j) := 0;
          else
            slice2cost_column_0_choice(4 * i + j) := to_integer(slice2cost_ready_words(i)(8 * j + 7 downto 8 * j));
          end if;
          slice2cost_column_0_value(4 * i + j) := (slice2cost_change_0(4 * i + j) + slice2cost_column_0_choice(4 * i +
            j)) mod 256;
        end loop;
      end loop;
      for i in 0 to 1 loop
        slice2cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice2shift_search(i, 0), 0) /=
          is_set(slice2shift_reference(i), 0))) + as_number((slice2cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice2shift_search(i, 0), 2))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice2shift_search(i, 0), 1)));
        slice2cost_pixels_first_count(i, 0, 1) <= as_number((slice2cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice2shift_search(i, 0), 3))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice2shift_search(i, 0), 5))) + as_number((slice2cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice2shift_search(i, 0), 4)));
        slice2cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice2cost_pixels_first_0_count_value(i, 2) /= is_set(slice2shift_search(i, 0), 8))) +
          as_number((slice2cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice2shift_search(i, 0), 6)));
        for j in 3 to 6 loop
          slice2cost_pixels_first_count(i, 0, j) <= as_number((slice2cost_pixels_first_0_count_value(i, j) /=
            is_set(slice2shift_search(i, 0), 3 * j))) + as_number((slice2cost_pixels_first_0_count_value_2(i, j) /=
            is_set(slice2shift_search(i, 0), 3 * j + 2))) + as_number((slice2cost_pixels_first_0_count_value_3(i, j) /=
            is_set(slice2shift_search(i, 0), 3 * j + 1)));
        end loop;
        slice2cost_pixels_first_count(i, 0, 7) <= as_number((slice2cost_pixels_first_0_count_value(i, 7) /=
          is_set(slice2shift_search(i, 0), 21))) + as_number((is_set(slice2shift_reference(i), 23) /=
          is_set(slice2shift_search(i, 0), 23))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 7) /=
          is_set(slice2shift_search(i, 0), 22)));
        for j in 1 to 15 loop
          slice2cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice2shift_search(i, j), 0) /=
            is_set(slice2shift_reference(i), 0))) + as_number((is_set(slice2shift_search(i, j), 2) /=
            slice2cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice2shift_search(i, j), 1) /=
            slice2cost_pixels_first_0_count_value_2(i, 0)));
          slice2cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice2shift_search(i, j), 3) /=
            slice2cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice2shift_search(i, j), 5) /=
            slice2cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice2shift_search(i, j), 4) /=
            slice2cost_pixels_first_0_count_1_value_3(i)));
          slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice2shift_search(i,
            j), 8) /= slice2cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice2shift_search(i, j), 6) /=
            slice2cost_pixels_first_0_count_value_2(i, 2)));
          for k in 3 to 6 loop
            slice2cost_pixels_first_count(i, j, k) <= as_number((is_set(slice2shift_search(i, j), 3 * k) /=
              slice2cost_pixels_first_0_count_value(i, k))) + as_number((is_set(slice2shift_search(i, j), 3 * k + 2) /=
              slice2cost_pixels_first_0_count_value_2(i, k))) + as_number((is_set(slice2shift_search(i, j), 3 * k + 1)
              /= slice2cost_pixels_first_0_count_value_3(i, k)));
          end loop;
          slice2cost_pixels_first_count(i, j, 7) <= as_number((is_set(slice2shift_search(i, j), 21) /=
            slice2cost_pixels_first_0_count_value(i, 7))) + as_number((is_set(slice2shift_search(i, j), 23) /=
            is_set(slice2shift_reference(i), 23))) + as_number((is_set(slice2shift_search(i, j), 22) /=
            slice2cost_pixels_first_0_count_value_2(i, 7)));
        end loop;
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 0) + slice2cost_pixels_first_count(i, j,
            2) + slice2cost_pixels_first_count(i, j, 3) + slice2cost_pixels_first_count(i, j, 5) +
            slice2cost_pixels_first_count(i, j, 6) + slice2cost_pixels_first_count(i, j, 4) +
            slice2cost_pixels_first_count(i, j, 7) + slice2cost_pixels_first_count(i, j, 1);
        end loop;
      end loop;
      slice2cost_read_column <= slice1cost_read_column;
      for i in 0 to 15 loop
        slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
      end loop;
      slice2cost_ready_words(0) <= slice2cost_read_words(0);
      slice2cost_ready_words(1) <= slice2cost_read_words(1);
      slice2cost_ready_words(2) <= slice2cost_read_words(2);
      slice2cost_ready_words(3) <= slice2cost_read_words(3);
      for i in 0 to 15 loop
        slice2cost_column_0(i) <= slice2cost_column_0_value(i);
      end loop;
      if slice0cost_ready_tag_valid then
        slice2cost_change_column <= slice2cost_read_column;
      end if;
      if slice0cost_tag_valid then
        slice2cost_ready_column <= slice1cost_ready_column;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_column <= slice1cost_write_column;
        for i in 0 to 3 loop
          slice2cost_write_words(i) <= to_unsigned(slice2cost_column_0_value(4 * i + 3), 8) &
            to_unsigned(slice2cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice2cost_column_0_value(4 * i + 1), 8)
            & to_unsigned(slice2cost_column_0_value(4 * i), 8);
        end loop;
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 9 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 16;
        end if;
      end if;
      for i in 0 to 1 loop
        for j in 0 to 3 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(8 * i + j) := to_integer(slice2window_leaving(2 * i)(8 * j + 7 downto 8 * j));
          else
            slice2window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
        for j in 4 to 7 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(8 * i + j) := to_integer(slice2window_leaving(2 * i + 1)(8 * j - 25 downto 8 *
              j - 32));
          else
            slice2window_change_0_choice(8 * i + j) := 0;
          end if;
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice2window_entering_0(i) <= slice2cost_column_0(i);
      end loop;
      for i in 0 to 15 loop
        slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
      end loop;
      slice2window_change_tag_row_start <= slice1window_change_tag_row_start;
      if slice0window_tag_valid then
        slice2window_change_tag_output_column <= slice1window_change_tag_output_column;
        slice2window_change_tag_first_column <= slice1window_change_tag_first_column;
      end if;
      for i in 0 to 15 loop
        if slice2window_change_tag_row_start then
          slice2window_sum_0_choice(i) := 0;
        else
          slice2window_sum_0_choice(i) := slice2window_sum_0(i);
        end if;
      end loop;
      if slice0winner1_tag_valid then
        for i in 0 to 15 loop
          slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 2048;
        end loop;
        slice2window_centre_map_column(0) <= slice1window_centre_map_column_0;
        slice2window_centre_map_column(1) <= slice2window_centre_map_column(0);
        slice2window_centre_map_column(2) <= slice2window_centre_map_column(1);
        slice2window_centre_output_column(0) <= slice1window_centre_output_column(0);
        slice2window_centre_output_column(1) <= slice2window_centre_output_column(0);
        slice2window_centre_output_column(2) <= slice2window_centre_output_column(1);
        slice2window_centre_first_column(0) <= slice1window_centre_first_column(0);
        slice2window_centre_first_column(1) <= slice2window_centre_first_column(0);
        slice2window_centre_first_column(2) <= slice2window_centre_first_column(1);
        slice2window_centre_start_of_frame_0 <= slice1window_centre_start_of_frame_0;
        slice2window_centre_end_of_line(0) <= slice1window_centre_end_of_line_0;
        slice2window_centre_end_of_line(1) <= slice2window_centre_end_of_line(0);
        slice2window_centre_end_of_line(2) <= slice2window_centre_end_of_line(1);
      end if;
      -- slice2mask
      slice2mask_inside_0_all := (not slice0winner1_tag_valid) and slice2mask_inside(0);
      if slice0winner1_tag_first_column then
        slice2mask_inside_choice(0) := slice2mask_inside_0_all;
      else
        slice2mask_inside_choice(0) := slice0winner1_tag_valid or slice2mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0winner1_tag_valid then
          slice2mask_inside_choice(i) := slice2mask_inside(i - 1);
        else
          slice2mask_inside_choice(i) := slice2mask_inside(i);
        end if;
      end loop;
      if slice1mask_left_out then
        slice2mask_inside(0) <= slice2mask_inside_choice(0);
      else
        slice2mask_inside(0) <= slice2mask_inside_0_all;
      end if;
      if slice0winner1_tag_first_column then
        for i in 1 to 15 loop
          slice2mask_inside(i) <= (not slice0winner1_tag_valid) and slice2mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice2mask_inside(i) <= slice2mask_inside_choice(i);
        end loop;
      end if;
      -- slice2other
      if (slice2window_sum_0(0) - slice1other_cost_out_0) < 0 then
        slice2other_cost_0_choice(0) := slice0winner2_tag_output_column and slice2mask_inside(0);
      else
        slice2other_cost_0_choice(0) := slice0winner2_tag_output_column and slice0winner2_tag_first_column and
          slice2mask_inside(0);
      end if;
      for i in 1 to 14 loop
        if (slice2window_sum_0(i) - slice2other_cost_0(i - 1)) < 0 then
          slice2other_cost_0_choice(i) := slice0winner2_tag_output_column and slice2mask_inside(i);
        else
          slice2other_cost_0_choice(i) := slice0winner2_tag_output_column and slice0winner2_tag_first_column and
            slice2mask_inside(i);
        end if;
      end loop;
      if slice0winner2_tag_first_column then
        slice2other_winner_0_15_choice := slice2mask_inside(15);
      else
        slice2other_winner_0_15_choice := ((slice2window_sum_0(15) - slice2other_cost_0(14)) < 0) and
          slice2mask_inside(15);
      end if;
      if slice0winner2_tag_valid then
        if slice2other_cost_0_choice(0) then
          slice2other_cost_0(0) <= slice2window_sum_0(0);
          slice2other_winner_0_0 <= 32;
        else
          slice2other_cost_0(0) <= slice1other_cost_out_0;
          slice2other_winner_0_0 <= slice1other_winner_out_0;
        end if;
        if slice2other_cost_0_choice(1) then
          slice2other_cost_0(1) <= slice2window_sum_0(1);
          slice2other_winner_0_1 <= 33;
        else
          slice2other_cost_0(1) <= slice2other_cost_0(0);
          slice2other_winner_0_1 <= slice2other_winner_0_0;
        end if;
        if slice2other_cost_0_choice(2) then
          slice2other_cost_0(2) <= slice2window_sum_0(2);
          slice2other_winner_0_2 <= 34;
        else
          slice2other_cost_0(2) <= slice2other_cost_0(1);
          slice2other_winner_0_2 <= slice2other_winner_0_1;
        end if;
        if slice2other_cost_0_choice(3) then
          slice2other_cost_0(3) <= slice2window_sum_0(3);
          slice2other_winner_0_3 <= 35;
        else
          slice2other_cost_0(3) <= slice2other_cost_0(2);
          slice2other_winner_0_3 <= slice2other_winner_0_2;
        end if;
        if slice2other_cost_0_choice(4) then
          slice2other_cost_0(4) <= slice2window_sum_0(4);
          slice2other_winner_0_4 <= 36;
        else
          slice2other_cost_0(4) <= slice2other_cost_0(3);
          slice2other_winner_0_4 <= slice2other_winner_0_3;
        end if;
        if slice2other_cost_0_choice(5) then
          slice2other_cost_0(5) <= slice2window_sum_0(5);
          slice2other_winner_0_5 <= 37;
        else
          slice2other_cost_0(5) <= slice2other_cost_0(4);
          slice2other_winner_0_5 <= slice2other_winner_0_4;
        end if;
        if slice2other_cost_0_choice(6) then
          slice2other_cost_0(6) <= slice2window_sum_0(6);
          slice2other_winner_0_6 <= 38;
        else
          slice2other_cost_0(6) <= slice2other_cost_0(5);
          slice2other_winner_0_6 <= slice2other_winner_0_5;
        end if;
        if slice2other_cost_0_choice(7) then
          slice2other_cost_0(7) <= slice2window_sum_0(7);
          slice2other_winner_0_7 <= 39;
        else
          slice2other_cost_0(7) <= slice2other_cost_0(6);
          slice2other_winner_0_7 <= slice2other_winner_0_6;
        end if;
        if slice2other_cost_0_choice(8) then
          slice2other_cost_0(8) <= slice2window_sum_0(8);
          slice2other_winner_0_8 <= 40;
        else
          slice2other_cost_0(8) <= slice2other_cost_0(7);
          slice2other_winner_0_8 <= slice2other_winner_0_7;
        end if;
        if slice2other_cost_0_choice(9) then
          slice2other_cost_0(9) <= slice2window_sum_0(9);
          slice2other_winner_0_9 <= 41;
        else
          slice2other_cost_0(9) <= slice2other_cost_0(8);
          slice2other_winner_0_9 <= slice2other_winner_0_8;
        end if;
        if slice2other_cost_0_choice(10) then
          slice2other_cost_0(10) <= slice2window_sum_0(10);
          slice2other_winner_0_10 <= 42;
        else
          slice2other_cost_0(10) <= slice2other_cost_0(9);
          slice2other_winner_0_10 <= slice2other_winner_0_9;
        end if;
        if slice2other_cost_0_choice(11) then
          slice2other_cost_0(11) <= slice2window_sum_0(11);
          slice2other_winner_0_11 <= 43;
        else
          slice2other_cost_0(11) <= slice2other_cost_0(10);
          slice2other_winner_0_11 <= slice2other_winner_0_10;
        end if;
        if slice2other_cost_0_choice(12) then
          slice2other_cost_0(12) <= slice2window_sum_0(12);
          slice2other_winner_0_12 <= 44;
        else
          slice2other_cost_0(12) <= slice2other_cost_0(11);
          slice2other_winner_0_12 <= slice2other_winner_0_11;
        end if;
        if slice2other_cost_0_choice(13) then
          slice2other_cost_0(13) <= slice2window_sum_0(13);
          slice2other_winner_0_13 <= 45;
        else
          slice2other_cost_0(13) <= slice2other_cost_0(12);
          slice2other_winner_0_13 <= slice2other_winner_0_12;
        end if;
        if slice2other_cost_0_choice(14) then
          slice2other_cost_0(14) <= slice2window_sum_0(14);
          slice2other_winner_0_14 <= 46;
        else
          slice2other_cost_0(14) <= slice2other_cost_0(13);
          slice2other_winner_0_14 <= slice2other_winner_0_13;
        end if;
        if slice0winner2_tag_output_column and slice2other_winner_0_15_choice then
          slice2other_winner_0_15 <= 47;
        else
          slice2other_winner_0_15 <= slice2other_winner_0_14;
        end if;
      end if;
      slice2other_winner_out_0 <= slice2other_winner_0_15;
      -- slice2winner1
      for i in 0 to 15 loop
        if slice2mask_inside(i) then
          slice2winner1_held_0_choice(i) := 0;
        else
          slice2winner1_held_0_choice(i) := 2047;
        end if;
        slice2winner1_held_0_any(i) := to_integer(((to_unsigned(slice2window_sum_0(i), 11)) or
          (to_unsigned(slice2winner1_held_0_choice(i), 11))));
      end loop;
      for i in 0 to 7 loop
        slice2winner1_best_cost_0_is_less(i) := (slice2winner1_held_0_any(2 * i + 1) - slice2winner1_held_0_any(2 * i))
          < 0;
      end loop;
      for i in 0 to 15 loop
        slice2winner1_held_0(i) <= slice2winner1_held_0_any(i);
      end loop;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
      slice2winner1_best_place_0_2 <= slice2winner1_best_cost_0_is_less(2);
      slice2winner1_best_place_0_4 <= slice2winner1_best_cost_0_is_less(4);
      slice2winner1_best_place_0_6 <= slice2winner1_best_cost_0_is_less(6);
      for i in 0 to 7 loop
        slice2winner1_best_late_cost_0(i) <= slice2winner1_best_cost_0(i);
      end loop;
      for i in 0 to 7 loop
        slice2winner1_best_but_first_0(i) <= slice2winner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 6 loop
        slice2winner1_best_but_last_0(i) <= slice2winner1_held_0(2 * i);
      end loop;
      if slice2winner1_best_cost_0_is_less(0) then
        slice2winner1_best_cost_0(0) <= slice2winner1_held_0_any(1);
        slice2winner1_best_below_0(0) <= slice2winner1_held_0_any(0);
        slice2winner1_best_above_0(0) <= 0;
      else
        slice2winner1_best_cost_0(0) <= slice2winner1_held_0_any(0);
        slice2winner1_best_below_0(0) <= 0;
        slice2winner1_best_above_0(0) <= slice2winner1_held_0_any(1);
      end if;
      if slice2winner1_best_cost_0_is_less(1) then
        slice2winner1_best_cost_0(1) <= slice2winner1_held_0_any(3);
        slice2winner1_best_index_0_1 <= 3;
        slice2winner1_best_below_0(1) <= slice2winner1_held_0_any(2);
        slice2winner1_best_above_0(1) <= 0;
      else
        slice2winner1_best_cost_0(1) <= slice2winner1_held_0_any(2);
        slice2winner1_best_index_0_1 <= 2;
        slice2winner1_best_below_0(1) <= 0;
        slice2winner1_best_above_0(1) <= slice2winner1_held_0_any(3);
      end if;
      if slice2winner1_best_cost_0_is_less(2) then
        slice2winner1_best_cost_0(2) <= slice2winner1_held_0_any(5);
        slice2winner1_best_index_0_2 <= 5;
        slice2winner1_best_below_0(2) <= slice2winner1_held_0_any(4);
        slice2winner1_best_above_0(2) <= 0;
      else
        slice2winner1_best_cost_0(2) <= slice2winner1_held_0_any(4);
        slice2winner1_best_index_0_2 <= 4;
        slice2winner1_best_below_0(2) <= 0;
        slice2winner1_best_above_0(2) <= slice2winner1_held_0_any(5);
      end if;
      if slice2winner1_best_cost_0_is_less(3) then
        slice2winner1_best_cost_0(3) <= slice2winner1_held_0_any(7);
        slice2winner1_best_index_0_3 <= 7;
        slice2winner1_best_below_0(3) <= slice2winner1_held_0_any(6);
        slice2winner1_best_above_0(3) <= 0;
      else
        slice2winner1_best_cost_0(3) <= slice2winner1_held_0_any(6);
        slice2winner1_best_index_0_3 <= 6;
        slice2winner1_best_below_0(3) <= 0;
        slice2winner1_best_above_0(3) <= slice2winner1_held_0_any(7);
      end if;
      if slice2winner1_best_cost_0_is_less(4) then
        slice2winner1_best_cost_0(4) <= slice2winner1_held_0_any(9);
        slice2winner1_best_index_0_4 <= 9;
        slice2winner1_best_below_0(4) <= slice2winner1_held_0_any(8);
        slice2winner1_best_above_0(4) <= 0;
      else
        slice2winner1_best_cost_0(4) <= slice2winner1_held_0_any(8);
        slice2winner1_best_index_0_4 <= 8;
        slice2winner1_best_below_0(4) <= 0;
        slice2winner1_best_above_0(4) <= slice2winner1_held_0_any(9);
      end if;
      if slice2winner1_best_cost_0_is_less(5) then
        slice2winner1_best_cost_0(5) <= slice2winner1_held_0_any(11);
        slice2winner1_best_index_0_5 <= 11;
        slice2winner1_best_below_0(5) <= slice2winner1_held_0_any(10);
        slice2winner1_best_above_0(5) <= 0;
      else
        slice2winner1_best_cost_0(5) <= slice2winner1_held_0_any(10);
        slice2winner1_best_index_0_5 <= 10;
        slice2winner1_best_below_0(5) <= 0;
        slice2winner1_best_above_0(5) <= slice2winner1_held_0_any(11);
      end if;
      if slice2winner1_best_cost_0_is_less(6) then
        slice2winner1_best_cost_0(6) <= slice2winner1_held_0_any(13);
        slice2winner1_best_index_0_6 <= 13;
        slice2winner1_best_below_0(6) <= slice2winner1_held_0_any(12);
        slice2winner1_best_above_0(6) <= 0;
      else
        slice2winner1_best_cost_0(6) <= slice2winner1_held_0_any(12);
        slice2winner1_best_index_0_6 <= 12;
        slice2winner1_best_below_0(6) <= 0;
        slice2winner1_best_above_0(6) <= slice2winner1_held_0_any(13);
      end if;
      if slice2winner1_best_cost_0_is_less(7) then
        slice2winner1_best_cost_0(7) <= slice2winner1_held_0_any(15);
        slice2winner1_best_index_0_7 <= 15;
        slice2winner1_best_below_0(7) <= slice2winner1_held_0_any(14);
        slice2winner1_best_above_0(7) <= 0;
      else
        slice2winner1_best_cost_0(7) <= slice2winner1_held_0_any(14);
        slice2winner1_best_index_0_7 <= 14;
        slice2winner1_best_below_0(7) <= 0;
        slice2winner1_best_above_0(7) <= slice2winner1_held_0_any(15);
      end if;
      -- slice2winner2
      for i in 0 to 3 loop
        slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice2winner2_best_below_0_is_equal(0) := slice2winner1_best_index_0_1 = 2;
      if slice2winner2_best_below_0_is_equal(0) then
        slice2winner2_best_below_0_choice(0) := slice2winner1_held_0(1);
      else
        slice2winner2_best_below_0_choice(0) := slice2winner1_best_below_0(1);
      end if;
      slice2winner2_best_below_0_is_equal(1) := slice2winner1_best_index_0_3 = 6;
      if slice2winner2_best_below_0_is_equal(1) then
        slice2winner2_best_below_0_choice(1) := slice2winner1_held_0(5);
      else
        slice2winner2_best_below_0_choice(1) := slice2winner1_best_below_0(3);
      end if;
      slice2winner2_best_below_0_is_equal(2) := (slice2winner1_best_index_0_5 mod 4) = 2;
      if is_set(slice2winner1_best_index_0_5, 3) and slice2winner2_best_below_0_is_equal(2) then
        slice2winner2_best_below_0_choice(2) := slice2winner1_held_0(9);
      else
        slice2winner2_best_below_0_choice(2) := slice2winner1_best_below_0(5);
      end if;
      slice2winner2_best_below_0_is_equal(3) := slice2winner1_best_index_0_7 = 14;
      if slice2winner2_best_below_0_is_equal(3) then
        slice2winner2_best_below_0_choice(3) := slice2winner1_held_0(13);
      else
        slice2winner2_best_below_0_choice(3) := slice2winner1_best_below_0(7);
      end if;
      if slice2winner1_best_index_0_0 then
        slice2winner2_best_above_0_choice(0) := slice2winner1_held_0(2);
      else
        slice2winner2_best_above_0_choice(0) := slice2winner1_best_above_0(0);
      end if;
      if slice2winner1_best_place_0_2 then
        slice2winner2_best_above_0_choice(1) := slice2winner1_held_0(6);
      else
        slice2winner2_best_above_0_choice(1) := slice2winner1_best_above_0(2);
      end if;
      if slice2winner1_best_place_0_4 then
        slice2winner2_best_above_0_choice(2) := slice2winner1_held_0(10);
      else
        slice2winner2_best_above_0_choice(2) := slice2winner1_best_above_0(4);
      end if;
      if slice2winner1_best_place_0_6 then
        slice2winner2_best_above_0_choice(3) := slice2winner1_held_0(14);
      else
        slice2winner2_best_above_0_choice(3) := slice2winner1_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if slice2winner2_best_place_0(i) then
          slice2winner2_best_second_0_choice(i) := 2047;
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
          slice2winner2_best_second_0_choices(i, 3) := 2047;
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
      slice2winner2_best_place_0(0) <= slice2winner2_best_cost_0_is_less(0);
      slice2winner2_best_place_0(1) <= slice2winner2_best_cost_0_is_less(1);
      slice2winner2_best_place_0(2) <= slice2winner2_best_cost_0_is_less(2);
      slice2winner2_best_place_0(3) <= slice2winner2_best_cost_0_is_less(3);
      slice2winner2_best_at_start_0(0) <= slice2winner2_best_cost_0_is_less(0) and
        slice2winner2_best_below_0_is_equal(0);
      slice2winner2_best_at_start_0(1) <= slice2winner2_best_cost_0_is_less(1) and
        slice2winner2_best_below_0_is_equal(1);
      slice2winner2_best_at_start_0(2) <= slice2winner2_best_cost_0_is_less(2) and is_set(slice2winner1_best_index_0_5,
        3) and slice2winner2_best_below_0_is_equal(2);
      slice2winner2_best_at_start_0(3) <= slice2winner2_best_below_0_is_equal(3) and
        slice2winner2_best_cost_0_is_less(3);
      slice2winner2_best_at_end_0(0) <= slice2winner1_best_index_0_0 and ((slice2winner1_best_cost_0(1) -
        slice2winner1_best_cost_0(0)) >= 0);
      slice2winner2_best_at_end_0(1) <= slice2winner1_best_place_0_2 and ((slice2winner1_best_cost_0(3) -
        slice2winner1_best_cost_0(2)) >= 0);
      slice2winner2_best_at_end_0(2) <= slice2winner1_best_place_0_4 and ((slice2winner1_best_cost_0(5) -
        slice2winner1_best_cost_0(4)) >= 0);
      slice2winner2_best_at_end_0(3) <= slice2winner1_best_place_0_6 and ((slice2winner1_best_cost_0(7) -
        slice2winner1_best_cost_0(6)) >= 0);
      slice2winner2_best_late_cost_0(0) <= slice2winner2_best_cost_0(0);
      slice2winner2_best_late_cost_0(1) <= slice2winner2_best_cost_0(1);
      slice2winner2_best_late_cost_0(2) <= slice2winner2_best_cost_0(2);
      slice2winner2_best_late_cost_0(3) <= slice2winner2_best_cost_0(3);
      if slice2winner2_best_cost_0_is_less(0) then
        slice2winner2_best_cost_0(0) <= slice2winner1_best_cost_0(1);
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
        slice2winner2_best_below_0(0) <= slice2winner2_best_below_0_choice(0);
        slice2winner2_best_above_0(0) <= slice2winner1_best_above_0(1);
      else
        slice2winner2_best_cost_0(0) <= slice2winner1_best_cost_0(0);
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
        slice2winner2_best_below_0(0) <= slice2winner1_best_below_0(0);
        slice2winner2_best_above_0(0) <= slice2winner2_best_above_0_choice(0);
      end if;
      if slice2winner2_best_cost_0_is_less(1) then
        slice2winner2_best_cost_0(1) <= slice2winner1_best_cost_0(3);
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
        slice2winner2_best_below_0(1) <= slice2winner2_best_below_0_choice(1);
        slice2winner2_best_above_0(1) <= slice2winner1_best_above_0(3);
      else
        slice2winner2_best_cost_0(1) <= slice2winner1_best_cost_0(2);
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
        slice2winner2_best_below_0(1) <= slice2winner1_best_below_0(2);
        slice2winner2_best_above_0(1) <= slice2winner2_best_above_0_choice(1);
      end if;
      if slice2winner2_best_cost_0_is_less(2) then
        slice2winner2_best_cost_0(2) <= slice2winner1_best_cost_0(5);
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
        slice2winner2_best_below_0(2) <= slice2winner2_best_below_0_choice(2);
        slice2winner2_best_above_0(2) <= slice2winner1_best_above_0(5);
      else
        slice2winner2_best_cost_0(2) <= slice2winner1_best_cost_0(4);
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
        slice2winner2_best_below_0(2) <= slice2winner1_best_below_0(4);
        slice2winner2_best_above_0(2) <= slice2winner2_best_above_0_choice(2);
      end if;
      if slice2winner2_best_cost_0_is_less(3) then
        slice2winner2_best_cost_0(3) <= slice2winner1_best_cost_0(7);
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
        slice2winner2_best_below_0(3) <= slice2winner2_best_below_0_choice(3);
        slice2winner2_best_above_0(3) <= slice2winner1_best_above_0(7);
      else
        slice2winner2_best_cost_0(3) <= slice2winner1_best_cost_0(6);
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
      for i in 0 to 2 loop
        if (slice2winner1_best_but_last_0(2 * i + 1) - slice2winner1_best_late_cost_0(2 * i)) < 0 then
          slice2winner2_best_but_last_0(i) <= slice2winner1_best_but_last_0(2 * i + 1);
        else
          slice2winner2_best_but_last_0(i) <= slice2winner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- slice2winner3
      slice2winner3_best_cost_0_is_less(0) := (slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) < 0;
      slice2winner3_best_cost_0_is_less(1) := (slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) < 0;
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
      slice2winner3_best_last_0_0 <= slice2winner2_best_last_0(1);
      slice2winner3_best_place_0(0) <= slice2winner3_best_cost_0_is_less(0);
      slice2winner3_best_place_0(1) <= slice2winner3_best_cost_0_is_less(1);
      slice2winner3_best_at_start_0(0) <= slice2winner3_best_cost_0_is_less(0) and
        slice2winner3_best_below_0_is_equal(0);
      slice2winner3_best_at_start_0(1) <= slice2winner3_best_below_0_is_equal(1) and
        slice2winner3_best_cost_0_is_less(1);
      slice2winner3_best_at_end_0(0) <= ((slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) >= 0) and
        slice2winner3_best_above_0_is_equal(0);
      slice2winner3_best_at_end_0(1) <= ((slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) >= 0) and
        is_set(slice2winner2_best_index_0_2, 3) and slice2winner3_best_above_0_is_equal(1);
      slice2winner3_best_late_cost_0(0) <= slice2winner3_best_cost_0(0);
      slice2winner3_best_late_cost_0(1) <= slice2winner3_best_cost_0(1);
      if slice2winner3_best_cost_0_is_less(0) then
        slice2winner3_best_cost_0(0) <= slice2winner2_best_cost_0(1);
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
        slice2winner3_best_below_0(0) <= slice2winner3_best_below_0_choice(0);
        slice2winner3_best_above_0(0) <= slice2winner2_best_above_0(1);
      else
        slice2winner3_best_cost_0(0) <= slice2winner2_best_cost_0(0);
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
        slice2winner3_best_below_0(0) <= slice2winner2_best_below_0(0);
        slice2winner3_best_above_0(0) <= slice2winner3_best_above_0_choice(0);
      end if;
      if slice2winner3_best_cost_0_is_less(1) then
        slice2winner3_best_cost_0(1) <= slice2winner2_best_cost_0(3);
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
        slice2winner3_best_below_0(1) <= slice2winner3_best_below_0_choice(1);
        slice2winner3_best_above_0(1) <= slice2winner2_best_above_0(3);
      else
        slice2winner3_best_cost_0(1) <= slice2winner2_best_cost_0(2);
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
      if (slice2winner2_best_but_last_0(1) - slice2winner2_best_late_cost_0(0)) < 0 then
        slice2winner3_best_but_last_0_0 <= slice2winner2_best_but_last_0(1);
      else
        slice2winner3_best_but_last_0_0 <= slice2winner2_best_late_cost_0(0);
      end if;
      -- slice2winner4
      slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
      slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0_1 = 8;
      if slice2winner4_best_below_0_0_is_equal then
        slice2winner4_best_below_0_0_choice := slice2winner3_best_last_0_0;
      else
        slice2winner4_best_below_0_0_choice := slice2winner3_best_below_0(1);
      end if;
      slice2winner4_best_above_0_0_is_equal := slice2winner3_best_index_0_0 = 7;
      if slice2winner4_best_above_0_0_is_equal then
        slice2winner4_best_above_0_0_choice := slice2winner3_best_first_0(1);
      else
        slice2winner4_best_above_0_0_choice := slice2winner3_best_above_0(0);
      end if;
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
        slice2winner4_best_second_0_0_choices(4) := slice2winner3_best_but_last_0_0;
      else
        slice2winner4_best_second_0_0_choices(4) := slice2winner4_best_second_0_0_choices(3);
      end if;
      slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
      slice2winner4_best_place_0_0 <= slice2winner4_best_cost_0_0_is_less;
      slice2winner4_best_at_start_0_0 <= slice2winner4_best_below_0_0_is_equal and slice2winner4_best_cost_0_0_is_less;
      slice2winner4_best_at_end_0_0 <= ((slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) >= 0) and
        slice2winner4_best_above_0_0_is_equal;
      slice2winner4_best_late_cost_0_0 <= slice2winner4_best_cost_0_0;
      if slice2winner4_best_cost_0_0_is_less then
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0(1);
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
        slice2winner4_best_below_0_0 <= slice2winner4_best_below_0_0_choice;
        slice2winner4_best_above_0_0 <= slice2winner3_best_above_0(1);
      else
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0(0);
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
        slice2winner4_best_below_0_0 <= slice2winner3_best_below_0(0);
        slice2winner4_best_above_0_0 <= slice2winner4_best_above_0_0_choice;
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
      -- slice2
      slice2_best_cost_0_0_is_less := (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0;
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
      slice2_best_place_0_0 <= slice2_best_cost_0_0_is_less;
      slice2_best_at_start_0_0 <= slice2_best_below_0_0_is_equal and slice2_best_cost_0_0_is_less;
      slice2_best_at_end_0_0 <= ((slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) >= 0) and
        slice2_best_above_0_0_is_equal;
      slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_cost_0_0_is_less then
        slice2_best_cost_0_0 <= slice2winner4_best_cost_0_0;
        slice2_best_index_0_0 <= slice2winner4_best_index_0_0 + 32;
        slice2_best_below_0_0 <= slice2_best_below_0_0_choice;
        slice2_best_above_0_0 <= slice2winner4_best_above_0_0;
      else
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
        slice2_best_index_0_0 <= slice1_best_index_0_0;
        slice2_best_below_0_0 <= slice1_best_below_0_0;
        slice2_best_above_0_0 <= slice2_best_above_0_0_choice;
      end if;
      if (slice2_best_second_0_0_choices(2) - slice2_best_second_0_0_choices(4)) < 0 then
        slice2_best_second_0_0 <= slice2_best_second_0_0_choices(2);
      else
        slice2_best_second_0_0 <= slice2_best_second_0_0_choices(4);
      end if;
      -- refinement
      refinement_below_0_differs := slice2_best_below_0_0 /= 2047;
      refinement_below_0_value := is_set(slice2_best_index_0_0, 4);
      refinement_below_0_value_2 := is_set(slice2_best_index_0_0, 3);
      if (not is_set(slice2_best_index_0_0, 5)) and ((slice2_best_index_0_0 mod 8) = 0) then
        refinement_below_0_choice := refinement_below_0_differs and (refinement_below_0_value or
          refinement_below_0_value_2);
      else
        refinement_below_0_choice := refinement_below_0_differs;
      end if;
      refinement_above_0_differs := slice2_best_above_0_0 /= 2047;
      if is_set(slice2_best_index_0_0, 5) and ((slice2_best_index_0_0 mod 8) = 7) then
        refinement_above_0_choice := refinement_above_0_differs and (refinement_below_0_value or (not
          refinement_below_0_value_2));
      else
        refinement_above_0_choice := refinement_above_0_differs;
      end if;
      refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 4096) - refinement_divisor_0(0);
      for i in 2 to 7 loop
        refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 4096) - refinement_divisor_0(i -
          1);
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
      refinement_disparity_0(0) <= slice2_best_index_0_0;
      for i in 1 to 11 loop
        refinement_disparity_0(i) <= refinement_disparity_0(i - 1);
      end loop;
      refinement_tag_valid(0) <= slice2_best_tag_valid;
      refinement_tag_map_column(0) <= slice2_best_tag_map_column;
      refinement_tag_output_column(0) <= slice2_best_tag_output_column;
      refinement_tag_start_of_frame(0) <= slice2_best_tag_start_of_frame;
      refinement_tag_end_of_line(0) <= slice2_best_tag_end_of_line;
      for i in 1 to 11 loop
        refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
        refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
        refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
        refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
        refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
      end loop;
      refinement_alone_0_0 <= slice2_best_second_0_0 = 2047;
      refinement_gap_0 <= (slice2_best_second_0_0 - slice2_best_late_cost_0_0) mod 2048;
      for i in 1 to 9 loop
        refinement_margin_0(i) <= refinement_margin_0(i - 1);
      end loop;
      refinement_u_0 <= (refinement_below_0 - slice2_best_late_cost_0_0) mod 2048;
      refinement_v_0 <= (refinement_above_0 - slice2_best_late_cost_0_0) mod 2048;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0(0) <= magnitude(refinement_difference_0);
      refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
      for i in 1 to 7 loop
        refinement_divisor_0(i) <= refinement_divisor_0(i - 1);
      end loop;
      refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
        ((other_4 / 2) * 2);
      refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
      for i in 1 to 8 loop
        refinement_negative_0(i) <= refinement_negative_0(i - 1);
      end loop;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
      if (not refinement_alone_0_0) and (511 >= refinement_gap_0) then
        refinement_margin_0(0) <= (refinement_gap_0 / 8) mod 64;
      else
        refinement_margin_0(0) <= 63;
      end if;
      if refinement_below_0_choice then
        refinement_below_0 <= slice2_best_below_0_0;
      else
        refinement_below_0 <= slice2_best_above_0_0;
      end if;
      if (not refinement_above_0_choice) and (slice2_best_index_0_0 /= 0) and refinement_below_0_differs then
        refinement_above_0 <= slice2_best_below_0_0;
      else
        refinement_above_0 <= slice2_best_above_0_0;
      end if;
      if is_set(refinement_remainder_1_0_difference, 12) then
        refinement_remainder_0(1) <= refinement_remainder_1_0_difference mod 2048;
      else
        refinement_remainder_0(1) <= refinement_remainder_0(0);
      end if;
      for i in 2 to 7 loop
        if is_set(refinement_remainder_0_difference(i), 12) then
          refinement_remainder_0(i) <= refinement_remainder_0_difference(i) mod 2048;
        else
          refinement_remainder_0(i) <= (refinement_remainder_0(i - 1) mod 1024) * 2;
        end if;
      end loop;
      -- leftright
      if (not is_set(leftright_ring_read_address, 5)) and ((leftright_ring_read_address mod 8) = 0) then
        leftright_holds_winners_choice := (not leftright_holds_winners) and (is_set(leftright_ring_read_address, 4) or
          is_set(leftright_ring_read_address, 3));
      else
        leftright_holds_winners_choice := not leftright_holds_winners;
      end if;
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_checked_tag_row_start_differs := support_counter_group /= 377;
      leftright_checked_tag_row_start_is_equal := support_counter_column = 441;
      if leftright_checked_tag_row_start_is_equal then
        leftright_checked_tag_row_start_choice := (support_counter_group /= 376) and leftright_checked_tag_row_start;
      else
        leftright_checked_tag_row_start_choice := leftright_checked_tag_row_start;
      end if;
      if leftright_checked_tag_row_start_differs then
        leftright_checked_tag_row_start_choices(2) := leftright_checked_tag_row_start_choice;
      else
        leftright_checked_tag_row_start_choices(2) := leftright_checked_tag_row_start;
      end if;
      leftright_checked_tag_row_start_is_equal_2 := support_counter_group = 374;
      leftright_checked_tag_row_start_all := leftright_checked_tag_row_start_is_equal_2 and
        leftright_checked_tag_row_start_is_equal;
      if leftright_checked_tag_row_start_choices(2) then
        leftright_checked_tag_row_start_choices(3) := (not leftright_checked_tag_start_of_frame) or
          leftright_checked_tag_row_start_all;
      else
        leftright_checked_tag_row_start_choices(3) := leftright_checked_tag_start_of_frame and
          leftright_checked_tag_row_start_is_equal_2 and leftright_checked_tag_row_start_is_equal;
      end if;
      leftright_checked_tag_row_start_all_2 := leftright_checked_tag_map_column and leftright_checked_tag_valid;
      leftright_other_0(1) <= slice2other_winner_out_0;
      for i in 2 to 15 loop
        leftright_other_0(i) <= leftright_other_0(i - 1);
      end loop;
      leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 64;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
      leftright_address_0 <= (leftright_held_position - to_integer(leftright_held_0(17 downto 4))) mod 64;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(9 downto 4));
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= leftright_held_0(12) = '1';
      leftright_asking_margin_0 <= to_integer(leftright_held_1);
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= leftright_held_0(0) = '1';
      leftright_asking_tag_start_of_frame <= leftright_held_0(2) = '1';
      leftright_asking_tag_end_of_line <= leftright_held_0(3) = '1';
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_margin_0 <= leftright_asking_margin_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_margin_0 <= leftright_answered_margin_0;
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_choice then
        leftright_holds_winners <= (not refinement_tag_valid(11)) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_valid(11) or leftright_holds_winners;
      end if;
      if leftright_checked_tag_row_start_choices(3) then
        leftright_checked_tag_row_start <= leftright_checked_tag_row_start or leftright_checked_tag_row_start_all_2;
      else
        leftright_checked_tag_row_start <= leftright_checked_tag_row_start and ((not leftright_checked_tag_map_column)
          or (not leftright_checked_tag_valid));
      end if;
      if refinement_tag_valid(11) then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 47 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 64;
        end if;
      end if;
      -- support
      if leftright_checked_tag_row_start_all_2 then
        if leftright_checked_tag_start_of_frame or leftright_checked_tag_row_start_is_equal then
          support_counter_column <= 0;
        else
          support_counter_column <= (support_counter_column + 1) mod 512;
        end if;
      end if;
      if leftright_checked_tag_row_start_all then
        support_counter_group_choice := 375;
      else
        support_counter_group_choice := 0;
      end if;
      if (support_counter_group = 376) and leftright_checked_tag_row_start then
        support_counter_group_choices(2) := 2;
      else
        support_counter_group_choices(2) := (support_counter_group + 1) mod 512;
      end if;
      if leftright_checked_tag_row_start_differs and leftright_checked_tag_row_start_is_equal and
        leftright_checked_tag_map_column and leftright_checked_tag_valid then
        support_counter_group_choices(3) := support_counter_group_choices(2);
      else
        support_counter_group_choices(3) := support_counter_group;
      end if;
      if support_ready_arrives and support_ready_above2 then
        support_column_choice(0) := 127;
      else
        support_column_choice(0) := 63;
      end if;
      if support_ready_above1 and support_ready_arrives then
        support_column_choice(1) := 127;
      else
        support_column_choice(1) := 63;
      end if;
      if support_ready_arrives then
        support_column_choice(2) := 127;
      else
        support_column_choice(2) := 63;
      end if;
      if support_ready_below2 and support_ready_arrives then
        support_column_choice(3) := 127;
      else
        support_column_choice(3) := 63;
      end if;
      if support_ready_below1 and support_ready_arrives then
        support_column_choice(4) := 127;
      else
        support_column_choice(4) := 63;
      end if;
      if support_at_moves then
        support_moment_0_start_of_frame_choice := support_at_arrives;
      else
        support_moment_0_start_of_frame_choice := support_moment_start_of_frame(0);
      end if;
      if support_row_tag(0) then
        support_next_tag_choice := (not support_at_moves) and support_next_tag;
      else
        support_next_tag_choice := support_at_moves or support_next_tag;
      end if;
      if support_at_moves then
        support_next_tag_choice_2 := support_row_tag(0);
      else
        support_next_tag_choice_2 := support_next_tag;
      end if;
      support_like_0_0_0_difference := 1 - (support_cells(6, 2) mod 64);
      support_like_0_value(0, 0) := ((support_cells(0, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      if support_row_tag(6) then
        support_like_0_0_choice(0) := support_next_tag and is_set(support_cells(0, 0), 6);
      else
        support_like_0_0_choice(0) := (not support_next_tag) and is_set(support_cells(0, 0), 6);
      end if;
      support_like_0_value(0, 1) := ((support_cells(0, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_1_differs(0) := support_row_tag(6) /= (not support_next_tag);
      for i in 0 to 1 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := ((support_cells(2 * i, j) mod 64) + support_like_0_0_0_difference) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := ((support_cells(2 * i + 2, 0) mod 64) + support_like_0_0_0_difference) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := ((support_cells(2 * i + 2, 1) mod 64) + support_like_0_0_0_difference) mod
          128;
        support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(2, i) := ((support_cells(4, i) mod 64) + support_like_0_0_0_difference) mod 128;
      end loop;
      support_like_0_value(3, 0) := ((support_cells(6, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_value(3, 1) := ((support_cells(6, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      for i in 3 to 5 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := (support_like_0_0_0_difference + (support_cells(2 * i, j) mod 64)) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 0) mod 64)) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 1) mod 64)) mod
          128;
        support_like_0_1_differss(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(6, i) := (support_like_0_0_0_difference + (support_cells(12, i) mod 64)) mod 128;
      end loop;
      if support_sum_0 < 255 then
        support_out_sure_0_choice := support_sum_0 mod 256;
      else
        support_out_sure_0_choice := 255;
      end if;
      support_out_tag_row_start_differs := fill_counter_group /= 376;
      support_out_tag_row_start_is_equal := fill_counter_column = 441;
      if support_out_tag_row_start_is_equal then
        support_out_tag_row_start_choice := (fill_counter_group /= 375) and support_out_tag_row_start;
      else
        support_out_tag_row_start_choice := support_out_tag_row_start;
      end if;
      if support_out_tag_row_start_differs then
        support_out_tag_row_start_choices(2) := support_out_tag_row_start_choice;
      else
        support_out_tag_row_start_choices(2) := support_out_tag_row_start;
      end if;
      support_out_tag_row_start_is_equal_2 := fill_counter_group = 374;
      support_out_tag_row_start_all := support_out_tag_row_start_is_equal_2 and support_out_tag_row_start_is_equal;
      if support_out_tag_row_start_choices(2) then
        support_out_tag_row_start_choices(3) := (not support_out_tag_start_of_frame) or support_out_tag_row_start_all;
      else
        support_out_tag_row_start_choices(3) := support_out_tag_start_of_frame and support_out_tag_row_start_is_equal_2
          and support_out_tag_row_start_is_equal;
      end if;
      support_out_tag_row_start_all_2 := support_out_tag_map_column and support_out_tag_valid;
      support_newest_0 <= (((((((leftright_checked_disparity_0 + 4095) mod 64) * 2) + (leftright_checked_fraction_0 /
        8) + 2) mod 128) * 8) / 16) + (as_number(leftright_checked_passed_0) * 64);
      support_newest_rest_0 <= ((((leftright_checked_fraction_0 / 8) + 2) mod 2) * 8) + (leftright_checked_fraction_0
        mod 8) + (leftright_checked_margin_0 * 16);
      support_moves <= leftright_checked_tag_valid;
      support_arrives <= leftright_checked_tag_row_start_all_2;
      support_last <= leftright_checked_tag_end_of_line and leftright_checked_tag_map_column and
        leftright_checked_tag_valid;
      support_rows_read_newest_0 <= support_newest_0;
      support_rows_ready_words_0 <= to_integer(support_rows_read_words_0);
      support_rows_ready_newest_0 <= support_rows_read_newest_0;
      support_rest_rows_read_newest_0 <= support_newest_rest_0;
      support_rest_rows_ready_words_0 <= to_integer(support_rest_rows_read_words_0);
      support_rest_rows_ready_newest_0 <= support_rest_rows_read_newest_0;
      support_read_column <= support_counter_column;
      support_read_moves <= support_moves;
      support_read_arrives <= support_arrives;
      support_read_above2 <= 3 < support_counter_group;
      support_read_above1 <= 2 < support_counter_group;
      support_read_below1 <= support_counter_group < 375;
      support_read_below2 <= support_counter_group < 376;
      support_read_first <= (support_counter_column = 0) and (support_counter_group = 2);
      support_read_last <= support_last;
      support_ready_column <= support_read_column;
      support_ready_moves <= support_read_moves;
      support_ready_arrives <= support_read_arrives;
      support_ready_above2 <= support_read_above2;
      support_ready_above1 <= support_read_above1;
      support_ready_below1 <= support_read_below1;
      support_ready_below2 <= support_read_below2;
      support_ready_first <= support_read_first;
      support_ready_last <= support_read_last;
      support_column(0) <= to_integer(((to_unsigned(support_column_choice(0), 7)) and
        (to_unsigned((support_rows_ready_words_0 mod 128), 7))));
      support_column(1) <= to_integer(((to_unsigned(support_column_choice(1), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 128) mod 128), 7))));
      support_column(2) <= to_integer(((to_unsigned(support_column_choice(2), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 16384) mod 128), 7))));
      support_column(3) <= to_integer(((to_unsigned(support_column_choice(3), 7)) and
        (to_unsigned((support_rows_ready_words_0 / 2097152), 7))));
      support_column(4) <= to_integer(((to_unsigned(support_rows_ready_newest_0, 7)) and
        (to_unsigned(support_column_choice(4), 7))));
      support_column_rest_0 <= support_rest_rows_ready_words_0 mod 1024;
      support_at_moves <= support_ready_moves;
      support_at_arrives <= support_ready_arrives;
      support_at_first <= support_ready_first;
      support_at_last <= support_ready_last;
      support_moved <= support_at_moves;
      for i in 0 to 2 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_cells(2 * i, 0) +
          support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choice(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_cells(2 * i, j) +
            support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differs(i);
        end loop;
      end loop;
      support_like_0(3, 0) <= ((not is_set(support_like_0_value(3, 0), 1)) or (not (((support_cells(6, 0) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 0) / 4) = 0) and
        is_set(support_cells(6, 0), 6);
      support_like_0(3, 1) <= ((not is_set(support_like_0_value(3, 1), 1)) or (not (((support_cells(6, 1) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 1) / 4) = 0) and
        is_set(support_cells(6, 1), 6);
      for i in 2 to 4 loop
        support_like_0(3, i) <= ((not is_set(support_like_0_value(3, i), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(6, i)) mod 2) = 1))) and ((support_like_0_value(3, i) / 4) = 0) and is_set(support_cells(6, i),
          6);
      end loop;
      for i in 4 to 6 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(2 * i, 0)) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choices(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_like_0_0_0_difference
            + support_cells(2 * i, j)) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differss(i);
        end loop;
      end loop;
      for i in 0 to 6 loop
        support_partial_0(i) <= as_number(support_like_0(i, 3)) + as_number(support_like_0(i, 0)) +
          as_number(support_like_0(i, 1)) + as_number(support_like_0(i, 4)) + as_number(support_like_0(i, 2));
      end loop;
      support_count_0 <= support_partial_0(6) + support_partial_0(4) + support_partial_0(3) + support_partial_0(1) +
        support_partial_0(5) + support_partial_0(0) + support_partial_0(2);
      support_sum_0 <= (((support_centre_rest_0(2) / 32) + ((support_count_0 + (support_count_0 / 2)) * 2) +
        (support_count_0 mod 2)) * 2) + ((support_centre_rest_0(2) / 16) mod 2);
      support_centre_0(0) <= support_cells(6, 2);
      support_centre_0(1) <= support_centre_0(0);
      support_centre_0(2) <= support_centre_0(1);
      support_centre_rest_0(0) <= support_rest_0(6);
      support_centre_rest_0(1) <= support_centre_rest_0(0);
      support_centre_rest_0(2) <= support_centre_rest_0(1);
      support_centre_moment_map_column(0) <= support_moment_map_column(6);
      support_centre_moment_start_of_frame(0) <= support_moment_start_of_frame(6);
      support_centre_moment_last(0) <= support_moment_last(6);
      for i in 1 to 3 loop
        support_centre_moment_map_column(i) <= support_centre_moment_map_column(i - 1);
        support_centre_moment_start_of_frame(i) <= support_centre_moment_start_of_frame(i - 1);
        support_centre_moment_last(i) <= support_centre_moment_last(i - 1);
      end loop;
      support_centre_moved(0) <= support_moved;
      support_centre_moved(1) <= support_centre_moved(0);
      support_centre_moved(2) <= support_centre_moved(1);
      support_centre_moved(3) <= support_centre_moved(2);
      support_out_disparity_0 <= ((((other_3 * 2) + (other_2 / 8) + 127) mod 128) * 8) + (other_2 mod 8);
      support_out_passed_0 <= support_enough_0;
      support_out_tag_valid <= support_centre_moved(3);
      support_out_tag_map_column <= support_centre_moment_map_column(3);
      support_out_tag_start_of_frame <= support_centre_moment_start_of_frame(3);
      support_out_tag_end_of_line <= support_centre_moment_last(3);
      if leftright_checked_tag_start_of_frame and leftright_checked_tag_map_column and leftright_checked_tag_valid then
        support_counter_group <= support_counter_group_choice;
      else
        support_counter_group <= support_counter_group_choices(3);
      end if;
      if support_row_tag(0) then
        support_row_tag(0) <= (not support_at_arrives) or support_moment_map_column(0) or (not support_at_moves);
      else
        support_row_tag(0) <= support_at_arrives and (not support_moment_map_column(0)) and support_at_moves;
      end if;
      if support_at_first then
        support_moment_start_of_frame(0) <= support_moment_0_start_of_frame_choice;
      else
        support_moment_start_of_frame(0) <= support_moment_start_of_frame(0) and (not support_at_moves);
      end if;
      if support_at_arrives and (not support_moment_map_column(0)) then
        support_next_tag <= support_next_tag_choice;
      else
        support_next_tag <= support_next_tag_choice_2;
      end if;
      if (not is_set(support_count_0, 4)) and ((not is_set(support_count_0, 3)) or (((support_count_0 / 2) mod 4) = 0))
        then
        support_enough_0 <= is_set(support_centre_0(2), 6) and is_set(support_count_0, 5);
      else
        support_enough_0 <= is_set(support_centre_0(2), 6);
      end if;
      if support_enough_0 then
        support_out_sure_0 <= support_out_sure_0_choice;
      else
        support_out_sure_0 <= 0;
      end if;
      if support_out_tag_row_start_choices(3) then
        support_out_tag_row_start <= support_out_tag_row_start or support_out_tag_row_start_all_2;
      else
        support_out_tag_row_start <= support_out_tag_row_start and ((not support_out_tag_map_column) or (not
          support_out_tag_valid));
      end if;
      if support_ready_arrives then
        support_rows_write_words_0 <= (support_rows_ready_words_0 / 128) + (support_rows_ready_newest_0 * 2097152);
        support_rest_rows_write_words_0 <= (support_rest_rows_ready_words_0 / 1024) + (support_rest_rows_ready_newest_0
          * 1024);
        support_write_column <= support_ready_column;
      end if;
      if support_at_moves then
        for i in 0 to 4 loop
          support_cells(0, i) <= support_column(i);
        end loop;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= support_cells(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 2, j) <= support_cells(2 * i + 1, j);
          end loop;
        end loop;
        support_row_tag(1) <= support_next_tag;
        for i in 2 to 12 loop
          support_row_tag(i) <= support_row_tag(i - 1);
        end loop;
        support_rest_0(0) <= support_column_rest_0;
        for i in 1 to 6 loop
          support_rest_0(i) <= support_rest_0(i - 1);
        end loop;
        support_moment_map_column(0) <= support_at_arrives;
        support_moment_last(0) <= support_at_last;
        for i in 1 to 6 loop
          support_moment_map_column(i) <= support_moment_map_column(i - 1);
          support_moment_start_of_frame(i) <= support_moment_start_of_frame(i - 1);
          support_moment_last(i) <= support_moment_last(i - 1);
        end loop;
      end if;
      -- fill
      if support_out_tag_row_start_all_2 then
        if support_out_tag_start_of_frame or support_out_tag_row_start_is_equal then
          fill_counter_column <= 0;
        else
          fill_counter_column <= (fill_counter_column + 1) mod 512;
        end if;
      end if;
      if support_out_tag_row_start_all then
        fill_counter_group_choice := 375;
      else
        fill_counter_group_choice := 0;
      end if;
      if (fill_counter_group = 375) and support_out_tag_row_start then
        fill_counter_group_choices(2) := 1;
      else
        fill_counter_group_choices(2) := (fill_counter_group + 1) mod 512;
      end if;
      if support_out_tag_row_start_differs and support_out_tag_row_start_is_equal and support_out_tag_map_column and
        support_out_tag_valid then
        fill_counter_group_choices(3) := fill_counter_group_choices(2);
      else
        fill_counter_group_choices(3) := fill_counter_group;
      end if;
      fill_ends_read_place_0_is_equal := fill_ready_column = 0;
      if other_0 then
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed);
      else
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed) and (not fill_in_hole_0);
      end if;
      if fill_ends_read_place_0 = 224 then
        fill_ends_read_place_0_choices(2) := 0;
      else
        fill_ends_read_place_0_choices(2) := (fill_ends_read_place_0 + 1) mod 256;
      end if;
      if fill_ends_read_place_0_choice then
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0_choices(2);
      else
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0;
      end if;
      if (fill_step_0 - fill_width_0) < 0 then
        fill_takes_left_0_choice := ((fill_width_0 - fill_step_0) mod 512) / 2;
      else
        fill_takes_left_0_choice := 0;
      end if;
      if fill_rises_0 then
        fill_takes_left_0_choice_2 := fill_takes_left_0_choice * 2;
      else
        fill_takes_left_0_choice_2 := fill_width_0;
      end if;
      fill_out_disparity_0_all := (not fill_chosen_0_passed) and ((not fill_chosen_at_top) or
        fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left);
      fill_out_disparity_0_all_2 := (not fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left);
      if fill_takes_left_0 then
        fill_out_disparity_0_choice := fill_chosen_beside_0_left;
      else
        fill_out_disparity_0_choice := fill_chosen_beside_0_right;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_out_disparity_0_choice_2 := fill_above_0 mod 32768;
      else
        fill_out_disparity_0_choice_2 := fill_out_disparity_0_choice;
      end if;
      fill_out_filled_0_is_equal := fill_chosen_at_column = 0;
      if fill_out_filled_0_is_equal and fill_chosen_at_arrives then
        fill_out_filled_0_choice := fill_has_values and (not fill_chosen_at_top);
      else
        fill_out_filled_0_choice := fill_had_values;
      end if;
      fill_out_tag_row_start_differs := median_counter_group /= 376;
      fill_out_tag_row_start_is_equal := median_counter_column = 441;
      if fill_out_tag_row_start_is_equal then
        fill_out_tag_row_start_choice := (median_counter_group /= 375) and fill_out_tag_row_start;
      else
        fill_out_tag_row_start_choice := fill_out_tag_row_start;
      end if;
      if fill_out_tag_row_start_differs then
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start_choice;
      else
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start;
      end if;
      fill_out_tag_row_start_is_equal_2 := median_counter_group = 374;
      fill_out_tag_row_start_all := fill_out_tag_row_start_is_equal_2 and fill_out_tag_row_start_is_equal;
      if fill_out_tag_row_start_choices(2) then
        fill_out_tag_row_start_choices(3) := (not fill_out_tag_start_of_frame) or fill_out_tag_row_start_all;
      else
        fill_out_tag_row_start_choices(3) := fill_out_tag_start_of_frame and fill_out_tag_row_start_is_equal_2 and
          fill_out_tag_row_start_is_equal;
      end if;
      fill_out_tag_row_start_all_2 := fill_out_tag_map_column and fill_out_tag_valid;
      fill_newest_disparity_0 <= support_out_disparity_0;
      fill_newest_passed_0 <= support_out_passed_0;
      fill_newest_sure_0 <= support_out_sure_0;
      fill_moves <= support_out_tag_valid;
      fill_arrives <= support_out_tag_row_start_all_2;
      fill_last <= support_out_tag_end_of_line and support_out_tag_map_column and support_out_tag_valid;
      fill_rows_read_newest_0 <= (fill_newest_sure_0 * 2048) + (fill_newest_disparity_0 * 2) +
        as_number(fill_newest_passed_0);
      fill_rows_ready_words_0 <= to_integer(fill_rows_read_words_0);
      fill_rows_ready_newest_0 <= fill_rows_read_newest_0;
      fill_read_column <= fill_counter_column;
      fill_read_moves <= fill_moves;
      fill_read_arrives <= fill_arrives;
      fill_read_top <= fill_counter_group = 1;
      fill_read_last <= fill_last;
      fill_ready_column <= fill_read_column;
      fill_ready_moves <= fill_read_moves;
      fill_ready_arrives <= fill_read_arrives;
      fill_ready_top <= fill_read_top;
      fill_ready_last <= fill_read_last;
      fill_write_column <= fill_ready_column;
      fill_ends_write_words_0 <= (fill_counter_column * 1024) + fill_newest_disparity_0 +
        (as_number(fill_newest_passed_0) * 524288);
      fill_ends_write_place_0 <= fill_ends_next_place_0;
      fill_ends_ready_words_0 <= to_integer(fill_ends_read_words_0);
      fill_pixel_0_disparity <= (fill_rows_ready_words_0 mod 2048) / 2;
      fill_pixel_0_passed <= is_set(fill_rows_ready_words_0, 0);
      fill_pixel_0_sure <= fill_rows_ready_words_0 / 2048;
      fill_at_moves <= fill_ready_moves;
      fill_at_arrives <= fill_ready_arrives;
      fill_at_top <= fill_ready_top;
      fill_at_last <= fill_ready_last;
      fill_asking_0_disparity(0) <= fill_pixel_0_disparity;
      fill_asking_0_passed(0) <= fill_pixel_0_passed;
      fill_asking_0_sure(0) <= fill_pixel_0_sure;
      fill_asking_0_disparity(1) <= fill_asking_0_disparity(0);
      fill_asking_0_passed(1) <= fill_asking_0_passed(0);
      fill_asking_0_sure(1) <= fill_asking_0_sure(0);
      fill_asking_at_column(0) <= fill_write_column;
      fill_asking_at_moves(0) <= fill_at_moves;
      fill_asking_at_arrives(0) <= fill_at_arrives;
      fill_asking_at_top(0) <= fill_at_top;
      fill_asking_at_last(0) <= fill_at_last;
      fill_asking_at_column(1) <= fill_asking_at_column(0);
      fill_asking_at_moves(1) <= fill_asking_at_moves(0);
      fill_asking_at_arrives(1) <= fill_asking_at_arrives(0);
      fill_asking_at_top(1) <= fill_asking_at_top(0);
      fill_asking_at_last(1) <= fill_asking_at_last(0);
      fill_hole_starts_0(0) <= fill_ends_read_place_0_choice;
      fill_hole_starts_0(1) <= fill_hole_starts_0(0);
      fill_known_0_disparity <= fill_asking_0_disparity(1);
      fill_known_0_passed <= fill_asking_0_passed(1);
      fill_known_0_sure <= fill_asking_0_sure(1);
      fill_known_at_column <= fill_asking_at_column(1);
      fill_known_at_moves <= fill_asking_at_moves(1);
      fill_known_at_arrives <= fill_asking_at_arrives(1);
      fill_known_at_top <= fill_asking_at_top(1);
      fill_known_at_last <= fill_asking_at_last(1);
      fill_measured_0_disparity <= fill_known_0_disparity;
      fill_measured_0_passed <= fill_known_0_passed;
      fill_measured_0_sure <= fill_known_0_sure;
      fill_measured_at_column <= fill_known_at_column;
      fill_measured_at_moves <= fill_known_at_moves;
      fill_measured_at_arrives <= fill_known_at_arrives;
      fill_measured_at_top <= fill_known_at_top;
      fill_measured_at_last <= fill_known_at_last;
      fill_measured_beside_0_left <= fill_beside_0_left;
      fill_measured_beside_0_right <= fill_beside_0_right;
      fill_measured_beside_0_has_left <= fill_beside_0_has_left;
      fill_measured_beside_0_has_right <= fill_beside_0_has_right;
      fill_measured_beside_0_right_column <= fill_beside_0_right_column;
      fill_width_0 <= (fill_beside_0_right_column + (65535 - fill_beside_0_left_column)) mod 512;
      fill_step_0 <= ((fill_beside_0_right - fill_beside_0_left) mod 2048) / 16;
      fill_rises_0 <= (fill_beside_0_right - fill_beside_0_left) >= 0;
      fill_chosen_0_disparity <= fill_measured_0_disparity;
      fill_chosen_0_passed <= fill_measured_0_passed;
      fill_chosen_0_sure <= fill_measured_0_sure;
      fill_chosen_at_column <= fill_measured_at_column;
      fill_chosen_at_moves <= fill_measured_at_moves;
      fill_chosen_at_arrives <= fill_measured_at_arrives;
      fill_chosen_at_top <= fill_measured_at_top;
      fill_chosen_at_last <= fill_measured_at_last;
      fill_chosen_beside_0_left <= fill_measured_beside_0_left;
      fill_chosen_beside_0_right <= fill_measured_beside_0_right;
      fill_chosen_beside_0_has_left <= fill_measured_beside_0_has_left;
      fill_chosen_beside_0_has_right <= fill_measured_beside_0_has_right;
      fill_takes_left_0 <= fill_measured_beside_0_has_left and ((((fill_measured_at_column +
        (fill_takes_left_0_choice_2 / 2)) - fill_measured_beside_0_right_column) < 0) or (not
        fill_measured_beside_0_has_right));
      fill_above_0 <= to_integer(fill_above_read_0);
      fill_out_passed_0 <= fill_chosen_0_passed;
      fill_out_sure_0 <= fill_chosen_0_sure;
      fill_out_tag_valid <= fill_chosen_at_moves;
      fill_out_tag_map_column <= fill_chosen_at_arrives;
      fill_out_tag_start_of_frame <= fill_out_filled_0_is_equal and fill_chosen_at_arrives and fill_chosen_at_top;
      fill_out_tag_end_of_line <= fill_chosen_at_last;
      if support_out_tag_start_of_frame and support_out_tag_map_column and support_out_tag_valid then
        fill_counter_group <= fill_counter_group_choice;
      else
        fill_counter_group <= fill_counter_group_choices(3);
      end if;
      if fill_newest_passed_0 then
        fill_ends_open_0 <= fill_ends_open_0 and (not fill_arrives);
      else
        fill_ends_open_0 <= fill_ends_open_0 or fill_arrives;
      end if;
      if fill_ends_read_place_0_is_equal and fill_ready_arrives then
        fill_ends_read_place_0 <= fill_ends_row_above_place_0;
      else
        fill_ends_read_place_0 <= fill_ends_read_place_0_choices(3);
      end if;
      if fill_beside_0_has_left then
        fill_beside_0_has_left <= (fill_asking_at_column(1) /= 0) or fill_asking_0_passed(1) or (not
          fill_asking_at_arrives(1));
      else
        fill_beside_0_has_left <= fill_asking_0_passed(1) and fill_asking_at_arrives(1);
      end if;
      if fill_out_disparity_0_all then
        fill_out_disparity_0 <= fill_out_disparity_0_choice_2;
      else
        fill_out_disparity_0 <= fill_chosen_0_disparity;
      end if;
      if fill_out_filled_0_choice then
        fill_out_filled_0 <= not fill_chosen_0_passed;
      else
        fill_out_filled_0 <= (not fill_chosen_0_passed) and (fill_chosen_beside_0_has_right or
          fill_chosen_beside_0_has_left);
      end if;
      if fill_out_tag_row_start_choices(3) then
        fill_out_tag_row_start <= fill_out_tag_row_start or fill_out_tag_row_start_all_2;
      else
        fill_out_tag_row_start <= fill_out_tag_row_start and ((not fill_out_tag_map_column) or (not
          fill_out_tag_valid));
      end if;
      if (not fill_out_filled_0_choice) and (not fill_chosen_0_passed) and (not fill_chosen_beside_0_has_right) and
        (not fill_chosen_beside_0_has_left) then
        fill_has_values <= fill_has_values and (not fill_chosen_at_arrives);
      else
        fill_has_values <= fill_has_values or fill_chosen_at_arrives;
      end if;
      if fill_ready_arrives then
        fill_rows_write_words_0 <= fill_rows_ready_newest_0;
        fill_at_column <= fill_ready_column;
      end if;
      if fill_last then
        fill_ends_next_place_0_choice := fill_arrives;
      else
        fill_ends_next_place_0_choice := fill_newest_passed_0 and fill_arrives;
      end if;
      if fill_ends_open_0 and ((not fill_arrives) or (fill_counter_column /= 0)) then
        fill_ends_next_place_0_choice_2 := fill_ends_next_place_0_choice;
      else
        fill_ends_next_place_0_choice_2 := fill_last and (not fill_newest_passed_0) and fill_arrives;
      end if;
      if fill_ends_next_place_0_choice_2 then
        if fill_ends_next_place_0 = 224 then
          fill_ends_next_place_0 <= 0;
        else
          fill_ends_next_place_0 <= (fill_ends_next_place_0 + 1) mod 256;
        end if;
      end if;
      fill_ends_row_place_0_all := fill_arrives and (fill_counter_column = 0);
      if fill_ends_row_place_0_all then
        fill_ends_row_place_0 <= fill_ends_next_place_0;
        fill_ends_row_above_place_0 <= fill_ends_row_place_0;
      end if;
      if fill_at_arrives then
        fill_in_hole_0 <= not fill_pixel_0_passed;
      end if;
      fill_beside_0_left_any := (not fill_asking_0_passed(1)) or (not fill_asking_at_arrives(1));
      if not fill_beside_0_left_any then
        fill_beside_0_left <= fill_asking_0_disparity(1);
        fill_beside_0_left_column <= fill_asking_at_column(1);
      end if;
      if fill_hole_starts_0(1) then
        fill_beside_0_right <= fill_ends_ready_words_0 mod 1024;
        fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 19);
        fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 512;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_write_above_0_choice := fill_above_0;
      else
        fill_write_above_0_choice := fill_out_disparity_0_choice;
      end if;
      if fill_chosen_at_arrives then
        fill_had_values <= fill_out_filled_0_choice;
        fill_write_above_column <= fill_chosen_at_column;
        if fill_out_disparity_0_all then
          fill_write_above_0 <= fill_write_above_0_choice;
        else
          fill_write_above_0 <= fill_chosen_0_disparity;
        end if;
      end if;
      -- median
      if fill_out_tag_row_start_all_2 then
        if fill_out_tag_start_of_frame or fill_out_tag_row_start_is_equal then
          median_counter_column <= 0;
        else
          median_counter_column <= (median_counter_column + 1) mod 512;
        end if;
      end if;
      if fill_out_tag_row_start_all then
        median_counter_group_choice := 375;
      else
        median_counter_group_choice := 0;
      end if;
      median_counter_group_is_equal := median_counter_group = 375;
      if median_counter_group_is_equal and fill_out_tag_row_start then
        median_counter_group_choices(2) := 1;
      else
        median_counter_group_choices(2) := (median_counter_group + 1) mod 512;
      end if;
      if fill_out_tag_row_start_differs and fill_out_tag_row_start_is_equal and fill_out_tag_map_column and
        fill_out_tag_valid then
        median_counter_group_choices(3) := median_counter_group_choices(2);
      else
        median_counter_group_choices(3) := median_counter_group;
      end if;
      if fill_out_tag_valid then
        median_line_ended_choice := fill_out_tag_map_column;
      else
        median_line_ended_choice := median_line_ended;
      end if;
      if median_at_top then
        median_of_column_0_a_choice := median_column_1 / 2;
      else
        median_of_column_0_a_choice := other_1 / 2;
      end if;
      if median_counter_next_frame then
        median_of_column_0_c_choice := median_column_1 / 2;
      else
        median_of_column_0_c_choice := median_column_2 / 2;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_low_0_choice := median_of_column_0_c;
      else
        median_sorted_low_0_choice := median_of_column_0_b;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_low_0_choice_2 := median_of_column_0_c;
      else
        median_sorted_low_0_choice_2 := median_of_column_0_a;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_middle_0_choice := median_of_column_0_b;
      else
        median_sorted_middle_0_choice := median_sorted_low_0_choice_2;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_middle_0_choice_2 := median_of_column_0_a;
      else
        median_sorted_middle_0_choice_2 := median_sorted_low_0_choice;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_high_0_choice := median_of_column_0_a;
      else
        median_sorted_high_0_choice := median_of_column_0_c;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_high_0_choice_2 := median_of_column_0_b;
      else
        median_sorted_high_0_choice_2 := median_of_column_0_c;
      end if;
      median_window_complete_is_equal := median_sorted_column = 0;
      if median_window_complete_is_equal then
        median_window_complete_choice := median_sorted_behind;
      else
        median_window_complete_choice := median_sorted_arrives or median_sorted_behind;
      end if;
      if median_of_low_0_c_below_a then
        median_largest_low_0_choice := median_of_low_0_a;
      else
        median_largest_low_0_choice := median_of_low_0_c;
      end if;
      if median_of_low_0_c_below_b then
        median_largest_low_0_choice_2 := median_of_low_0_b;
      else
        median_largest_low_0_choice_2 := median_of_low_0_c;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choice := median_of_middle_0_c;
      else
        median_median_middle_0_choice := median_of_middle_0_a;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(2) := median_of_middle_0_b;
      else
        median_median_middle_0_choices(2) := median_median_middle_0_choice;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(3) := median_of_middle_0_c;
      else
        median_median_middle_0_choices(3) := median_of_middle_0_b;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choices(4) := median_of_middle_0_a;
      else
        median_median_middle_0_choices(4) := median_median_middle_0_choices(3);
      end if;
      if median_of_high_0_c_below_b then
        median_smallest_high_0_choice := median_of_high_0_c;
      else
        median_smallest_high_0_choice := median_of_high_0_b;
      end if;
      if median_of_high_0_c_below_a then
        median_smallest_high_0_choice_2 := median_of_high_0_c;
      else
        median_smallest_high_0_choice_2 := median_of_high_0_a;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choice := median_of_all_0_c;
      else
        median_out_disparity_0_choice := median_of_all_0_a;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(2) := median_of_all_0_b;
      else
        median_out_disparity_0_choices(2) := median_out_disparity_0_choice;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(3) := median_of_all_0_c;
      else
        median_out_disparity_0_choices(3) := median_of_all_0_b;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choices(4) := median_of_all_0_a;
      else
        median_out_disparity_0_choices(4) := median_out_disparity_0_choices(3);
      end if;
      median_counter_next_frame <= slice0_best_place_0;
      median_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
      median_arrives <= fill_out_tag_row_start_all_2;
      median_behind <= median_line_ended and fill_out_tag_valid;
      median_rows_read_newest_0 <= median_newest_0;
      median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
      median_rows_ready_newest_0 <= median_rows_read_newest_0;
      median_read_column <= median_counter_column;
      median_read_arrives <= median_arrives;
      median_read_behind <= median_behind;
      median_read_top <= median_counter_group = 1;
      median_read_bottom <= median_counter_group_is_equal;
      median_read_output <= (median_counter_group >= 1) and (median_counter_group < 376);
      median_ready_column <= median_read_column;
      median_ready_arrives <= median_read_arrives;
      median_ready_behind <= median_read_behind;
      median_ready_top <= median_read_top;
      median_ready_output <= median_read_output;
      median_write_column <= median_ready_column;
      median_column_1 <= median_rows_ready_words_0 / 8192;
      median_column_2 <= median_rows_ready_newest_0;
      median_at_arrives <= median_ready_arrives;
      median_at_behind <= median_ready_behind;
      median_at_top <= median_ready_top;
      median_at_output <= median_ready_output;
      median_of_column_0_a <= median_of_column_0_a_choice;
      median_of_column_0_b <= median_column_1 / 2;
      median_of_column_0_c <= median_of_column_0_c_choice;
      median_of_column_0_b_below_a <= ((median_column_1 / 2) - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_a <= (median_of_column_0_c_choice - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_b <= (median_of_column_0_c_choice - (median_column_1 / 2)) < 0;
      median_column_passed_0(0) <= is_set(median_column_1, 0);
      median_column_passed_0(1) <= median_column_passed_0(0);
      median_comparing_column <= median_write_column;
      median_comparing_arrives <= median_at_arrives;
      median_comparing_behind <= median_at_behind;
      median_comparing_top <= median_at_top;
      median_comparing_output <= median_at_output;
      median_sorted_column <= median_comparing_column;
      median_sorted_arrives <= median_comparing_arrives;
      median_sorted_behind <= median_comparing_behind;
      median_sorted_top <= median_comparing_top;
      median_sorted_output <= median_comparing_output;
      median_window_complete <= median_sorted_output and median_window_complete_choice;
      median_window_first <= median_sorted_top and (median_sorted_column = 1) and median_sorted_arrives;
      median_window_last <= median_sorted_behind;
      median_of_low_0_a <= median_low_0(0);
      median_of_low_0_b <= median_low_0(1);
      median_of_low_0_c <= median_low_0(2);
      median_of_low_0_b_below_a <= (median_low_0(1) - median_low_0(0)) < 0;
      median_of_low_0_c_below_a <= (median_low_0(2) - median_low_0(0)) < 0;
      median_of_low_0_c_below_b <= (median_low_0(2) - median_low_0(1)) < 0;
      median_of_middle_0_a <= median_middle_0(0);
      median_of_middle_0_b <= median_middle_0(1);
      median_of_middle_0_c <= median_middle_0(2);
      median_of_middle_0_b_below_a <= (median_middle_0(1) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_a <= (median_middle_0(2) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_b <= (median_middle_0(2) - median_middle_0(1)) < 0;
      median_of_high_0_a <= median_high_0(0);
      median_of_high_0_b <= median_high_0(1);
      median_of_high_0_c <= median_high_0(2);
      median_of_high_0_b_below_a <= (median_high_0(1) - median_high_0(0)) < 0;
      median_of_high_0_c_below_a <= (median_high_0(2) - median_high_0(0)) < 0;
      median_of_high_0_c_below_b <= (median_high_0(2) - median_high_0(1)) < 0;
      median_of_all_0_a <= median_largest_low_0;
      median_of_all_0_b <= median_median_middle_0;
      median_of_all_0_c <= median_smallest_high_0;
      median_of_all_0_b_below_a <= (median_median_middle_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_a <= (median_smallest_high_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_b <= (median_smallest_high_0 - median_median_middle_0) < 0;
      median_waiting_complete(0) <= median_window_complete;
      median_waiting_first(0) <= median_window_first;
      median_waiting_last(0) <= median_window_last;
      median_waiting_complete(1) <= median_waiting_complete(0);
      median_waiting_first(1) <= median_waiting_first(0);
      median_waiting_last(1) <= median_waiting_last(0);
      median_waiting_complete(2) <= median_waiting_complete(1);
      median_waiting_first(2) <= median_waiting_first(1);
      median_waiting_last(2) <= median_waiting_last(1);
      median_waiting_passed_0(0) <= median_passed_0(1);
      median_waiting_passed_0(1) <= median_waiting_passed_0(0);
      median_waiting_passed_0(2) <= median_waiting_passed_0(1);
      median_beside_newest_0 <= (fill_out_sure_0 * 2) + as_number(fill_out_filled_0);
      median_beside_rows_read_newest_0 <= median_beside_newest_0;
      median_beside_rows_ready_words_0 <= to_integer(median_beside_rows_read_words_0);
      median_beside_rows_ready_newest_0 <= median_beside_rows_read_newest_0;
      median_beside_column_0 <= median_beside_rows_ready_words_0;
      median_beside_of_column_0(0) <= median_beside_column_0;
      median_beside_of_column_0(1) <= median_beside_of_column_0(0);
      median_beside_waiting_0(0) <= median_beside_in_window_0(1);
      median_beside_waiting_0(1) <= median_beside_waiting_0(0);
      median_beside_waiting_0(2) <= median_beside_waiting_0(1);
      median_out_passed_0 <= median_waiting_passed_0(2);
      median_out_confidence_0 <= median_beside_waiting_0(2) / 2;
      median_out_filled_0 <= is_set(median_beside_waiting_0(2), 0);
      median_out_valid <= median_waiting_complete(2);
      median_out_start_of_frame <= median_waiting_first(2) and median_waiting_complete(2);
      median_out_end_of_line <= median_waiting_last(2) and median_waiting_complete(2);
      if fill_out_tag_start_of_frame and fill_out_tag_map_column and fill_out_tag_valid then
        median_counter_group <= median_counter_group_choice;
      else
        median_counter_group <= median_counter_group_choices(3);
      end if;
      if fill_out_tag_end_of_line then
        median_line_ended <= median_line_ended_choice;
      else
        median_line_ended <= median_line_ended and (not fill_out_tag_valid);
      end if;
      if median_of_column_0_b_below_a then
        median_sorted_low_0 <= median_sorted_low_0_choice;
        median_sorted_middle_0 <= median_sorted_middle_0_choice;
        median_sorted_high_0 <= median_sorted_high_0_choice;
      else
        median_sorted_low_0 <= median_sorted_low_0_choice_2;
        median_sorted_middle_0 <= median_sorted_middle_0_choice_2;
        median_sorted_high_0 <= median_sorted_high_0_choice_2;
      end if;
      if median_passed_0(0) then
        median_passed_0(1) <= median_passed_0(1) or median_sorted_arrives or median_sorted_behind;
      else
        median_passed_0(1) <= median_passed_0(1) and (not median_sorted_arrives) and (not median_sorted_behind);
      end if;
      if median_of_low_0_b_below_a then
        median_largest_low_0 <= median_largest_low_0_choice;
      else
        median_largest_low_0 <= median_largest_low_0_choice_2;
      end if;
      if median_of_middle_0_b_below_a then
        median_median_middle_0 <= median_median_middle_0_choices(2);
      else
        median_median_middle_0 <= median_median_middle_0_choices(4);
      end if;
      if median_of_high_0_b_below_a then
        median_smallest_high_0 <= median_smallest_high_0_choice;
      else
        median_smallest_high_0 <= median_smallest_high_0_choice_2;
      end if;
      if median_of_all_0_b_below_a then
        median_out_disparity_0 <= median_out_disparity_0_choices(2);
      else
        median_out_disparity_0 <= median_out_disparity_0_choices(4);
      end if;
      if median_ready_arrives then
        median_rows_write_words_0 <= (median_rows_ready_words_0 / 8192) + (median_rows_ready_newest_0 * 8192);
        median_at_column <= median_ready_column;
        median_beside_rows_write_words_0 <= median_beside_rows_ready_newest_0;
      end if;
      if median_sorted_behind then
        median_low_0_0_choice := median_low_0(0);
      else
        median_low_0_0_choice := median_sorted_low_0;
      end if;
      median_low_0_all(1) := median_window_complete_is_equal and median_sorted_arrives;
      if median_sorted_behind then
        median_middle_0_0_choice := median_middle_0(0);
      else
        median_middle_0_0_choice := median_sorted_middle_0;
      end if;
      if median_sorted_behind then
        median_high_0_0_choice := median_high_0(0);
      else
        median_high_0_0_choice := median_sorted_high_0;
      end if;
      median_low_0_all(0) := (not median_sorted_arrives) and (not median_sorted_behind);
      if not median_low_0_all(0) then
        median_low_0(0) <= median_low_0_0_choice;
        median_low_0(2) <= median_low_0(1);
        median_middle_0(0) <= median_middle_0_0_choice;
        median_middle_0(2) <= median_middle_0(1);
        median_high_0(0) <= median_high_0_0_choice;
        median_high_0(2) <= median_high_0(1);
        median_beside_in_window_0(1) <= median_beside_in_window_0(0);
        if median_low_0_all(1) then
          median_low_0(1) <= median_low_0_0_choice;
          median_middle_0(1) <= median_middle_0_0_choice;
          median_high_0(1) <= median_high_0_0_choice;
        else
          median_low_0(1) <= median_low_0(0);
          median_middle_0(1) <= median_middle_0(0);
          median_high_0(1) <= median_high_0(0);
        end if;
      end if;
      if median_sorted_arrives then
        median_passed_0(0) <= median_column_passed_0(1);
        median_beside_in_window_0(0) <= median_beside_of_column_0(1);
      end if;
      -- other
      other_0 <= fill_ends_read_place_0_is_equal;
      other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
      other_2 <= support_centre_rest_0(2) mod 16;
      other_3 <= support_centre_0(2) mod 64;
      other_4 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_5 / 4) * 4);
      other_5 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_6 / 8) * 8);
      other_6 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_7 / 16) * 16);
      other_7 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_8 / 32) * 32);
      other_8 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_9 / 64) * 64);
      other_9 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_10 / 128) * 128);
      other_10 <= (refinement_remainder_1_0_difference / 4096) * 128;
      for i in 11 to 21 loop
        other(i) <= other(i + 1);
      end loop;
      other(22) <= 4096;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_right_0 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 377;
        transform_counter_next_frame <= false;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_write_words_0 <= to_unsigned(0, 32);
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_write_words_0 <= to_unsigned(0, 32);
        transform_read_column <= 0;
        for i in 0 to 4 loop
          transform_read_row_inside(i) <= false;
        end loop;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_column_inside_4 <= false;
        transform_read_column_inside_6 <= false;
        transform_read_column_inside_8 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        for i in 0 to 4 loop
          transform_ready_row_inside(i) <= false;
        end loop;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_column_inside_4 <= false;
        transform_ready_column_inside_6 <= false;
        transform_ready_column_inside_8 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        for i in 0 to 4 loop
          transform_left_column(i) <= 0;
        end loop;
        for i in 0 to 4 loop
          transform_right_column(i) <= 0;
        end loop;
        for i in 0 to 4 loop
          transform_columns_row_inside(i) <= false;
        end loop;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_column_inside_4 <= false;
        transform_columns_column_inside_6 <= false;
        transform_columns_column_inside_8 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i, j) <= 0;
          end loop;
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          transform_left_filter_column(8, i) <= 0;
        end loop;
        transform_left_filter_feature_0 <= 0;
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i, j) <= 0;
          end loop;
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          transform_right_filter_column(8, i) <= 0;
        end loop;
        transform_right_filter_feature_0 <= 0;
        transform_filtering_0_column_inside_0 <= false;
        transform_filtering_0_column_inside_2 <= false;
        transform_filtering_0_column_inside_4 <= false;
        transform_filtering_0_column_inside_6 <= false;
        transform_filtering_0_column_inside_8 <= false;
        transform_filtering_start_of_frame(0) <= false;
        transform_filtering_valid(0) <= false;
        transform_filtering_start_of_frame(1) <= false;
        transform_filtering_valid(1) <= false;
        raster_features_search_0 <= 0;
        raster_features_reference_0 <= 0;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 379;
        delay_ahead_0 <= 0;
        delay_delayed_0 <= 0;
        delay_column <= 0;
        delay_row_inside(0) <= false;
        delay_row_inside(1) <= false;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_first_group <= false;
        delay_tag_leaves_window <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        for i in 0 to 8 loop
          rows_search_rows_ready_words(i) <= 0;
        end loop;
        rows_search_rows_ready_newest_0 <= 0;
        for i in 0 to 8 loop
          rows_search_rows_write_words(i) <= 0;
        end loop;
        rows_reference_rows_read_newest_0 <= 0;
        for i in 0 to 8 loop
          rows_reference_rows_ready_words(i) <= 0;
        end loop;
        rows_reference_rows_ready_newest_0 <= 0;
        for i in 0 to 8 loop
          rows_reference_rows_write_words(i) <= 0;
        end loop;
        rows_read_column <= 0;
        rows_read_inside(0) <= false;
        rows_read_inside(1) <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_first_group <= false;
        rows_read_tag_leaves_window <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside(0) <= false;
        rows_ready_inside(1) <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_first_group <= false;
        rows_ready_tag_leaves_window <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search(0) <= 0;
        rows_search(1) <= 0;
        rows_reference(0) <= 0;
        rows_reference(1) <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_first_group <= false;
        rows_tag_leaves_window <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_first_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0shift_search(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice0shift_search(1, i) <= 0;
        end loop;
        slice0shift_reference(0) <= 0;
        slice0shift_reference(1) <= 0;
        slice0shift_search_out(0) <= 0;
        slice0shift_search_out(1) <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_first_group <= false;
        slice0shift_tag_leaves_window <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_first_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        for i in 0 to 1 loop
          for j in 0 to 7 loop
            for k in 0 to 7 loop
              slice0cost_pixels_first_count(i, 2 * j, k) <= 0;
            end loop;
            for k in 0 to 7 loop
              slice0cost_pixels_first_count(i, 2 * j + 1, k) <= 0;
            end loop;
          end loop;
        end loop;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_first_group <= false;
        slice0cost_pixels_first_tag_leaves_window <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_first_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0cost_pixels_cost(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice0cost_pixels_cost(1, i) <= 0;
        end loop;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_row_start <= false;
        slice0cost_pixels_tag_first_group <= false;
        slice0cost_pixels_tag_leaves_window <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_first_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        for i in 0 to 15 loop
          slice0cost_change_0(i) <= 0;
        end loop;
        slice0cost_ready_words(0) <= to_unsigned(0, 32);
        slice0cost_ready_words(1) <= to_unsigned(0, 32);
        slice0cost_ready_words(2) <= to_unsigned(0, 32);
        slice0cost_ready_words(3) <= to_unsigned(0, 32);
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_row_start <= false;
        slice0cost_ready_tag_first_group <= false;
        slice0cost_ready_tag_leaves_window <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_ready_tag_output_column <= false;
        slice0cost_ready_tag_first_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0cost_column_0(i) <= 0;
        end loop;
        slice0cost_write_column <= 0;
        slice0cost_write_words(0) <= to_unsigned(0, 32);
        slice0cost_write_words(1) <= to_unsigned(0, 32);
        slice0cost_write_words(2) <= to_unsigned(0, 32);
        slice0cost_write_words(3) <= to_unsigned(0, 32);
        slice0cost_tag_valid <= false;
        slice0cost_tag_row_start <= false;
        slice0cost_tag_first_group <= false;
        slice0cost_tag_leaves_window <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_first_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        for i in 0 to 15 loop
          slice0window_entering_0(i) <= 0;
        end loop;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_row_start <= false;
        slice0window_entering_tag_first_group <= false;
        slice0window_entering_tag_leaves_window <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_entering_tag_output_column <= false;
        slice0window_entering_tag_first_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0window_change_0(i) <= 0;
        end loop;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_row_start <= false;
        slice0window_change_tag_leaves_window <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_change_tag_output_column <= false;
        slice0window_change_tag_first_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0window_sum_0(i) <= 0;
        end loop;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_output_column(0) <= false;
        slice0window_centre_output_column(1) <= false;
        slice0window_centre_output_column(2) <= false;
        slice0window_centre_output_column(3) <= false;
        slice0window_centre_first_column(0) <= false;
        slice0window_centre_first_column(1) <= false;
        slice0window_centre_first_column(2) <= false;
        slice0window_centre_first_column(3) <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_3 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_first_column <= false;
        slice0window_tag_start_of_frame <= false;
        for i in 0 to 15 loop
          slice0mask_inside(i) <= false;
        end loop;
        slice0mask_left_out <= false;
        slice0mask_column <= 0;
        for i in 0 to 15 loop
          slice0other_cost_0(i) <= 0;
        end loop;
        slice0other_winner_0_1 <= false;
        slice0other_winner_0_2 <= 0;
        slice0other_winner_0_3 <= 0;
        slice0other_winner_0_4 <= 0;
        slice0other_winner_0_5 <= 0;
        slice0other_winner_0_6 <= 0;
        slice0other_winner_0_7 <= 0;
        slice0other_winner_0_8 <= 0;
        slice0other_winner_0_9 <= 0;
        slice0other_winner_0_10 <= 0;
        slice0other_winner_0_11 <= 0;
        slice0other_winner_0_12 <= 0;
        slice0other_winner_0_13 <= 0;
        slice0other_winner_0_14 <= 0;
        slice0other_winner_0_15 <= 0;
        slice0other_cost_out_0 <= 0;
        slice0other_winner_out_0 <= 0;
        for i in 0 to 15 loop
          slice0winner1_held_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice0winner1_best_cost_0(i) <= 0;
        end loop;
        slice0winner1_best_index_0_0 <= false;
        slice0winner1_best_index_0_1 <= 0;
        slice0winner1_best_index_0_2 <= 0;
        slice0winner1_best_index_0_3 <= 0;
        slice0winner1_best_index_0_4 <= 0;
        slice0winner1_best_index_0_5 <= 0;
        slice0winner1_best_index_0_6 <= 0;
        slice0winner1_best_index_0_7 <= 0;
        for i in 0 to 7 loop
          slice0winner1_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice0winner1_best_above_0(i) <= 0;
        end loop;
        slice0winner1_best_place_0_2 <= false;
        slice0winner1_best_place_0_4 <= false;
        slice0winner1_best_place_0_6 <= false;
        for i in 0 to 7 loop
          slice0winner1_best_late_cost_0(i) <= 0;
        end loop;
        for i in 1 to 7 loop
          slice0winner1_best_but_first_0(i) <= 2047;
        end loop;
        for i in 0 to 7 loop
          slice0winner1_best_but_last_0(i) <= 2047;
        end loop;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_output_column <= false;
        slice0winner1_tag_first_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_best_cost_0(0) <= 0;
        slice0winner2_best_cost_0(1) <= 0;
        slice0winner2_best_cost_0(2) <= 0;
        slice0winner2_best_cost_0(3) <= 0;
        slice0winner2_best_index_0_0 <= 0;
        slice0winner2_best_index_0_1 <= 0;
        slice0winner2_best_index_0_2 <= 0;
        slice0winner2_best_index_0_3 <= 0;
        slice0winner2_best_below_0(0) <= 0;
        slice0winner2_best_below_0(1) <= 0;
        slice0winner2_best_below_0(2) <= 0;
        slice0winner2_best_below_0(3) <= 0;
        slice0winner2_best_above_0(0) <= 0;
        slice0winner2_best_above_0(1) <= 0;
        slice0winner2_best_above_0(2) <= 0;
        slice0winner2_best_above_0(3) <= 0;
        slice0winner2_best_first_0(1) <= 0;
        slice0winner2_best_first_0(2) <= 0;
        slice0winner2_best_first_0(3) <= 0;
        slice0winner2_best_last_0(0) <= 0;
        slice0winner2_best_last_0(1) <= 0;
        slice0winner2_best_last_0(2) <= 0;
        slice0winner2_best_last_0(3) <= 0;
        slice0winner2_best_place_0(0) <= false;
        slice0winner2_best_place_0(1) <= false;
        slice0winner2_best_place_0(2) <= false;
        slice0winner2_best_place_0(3) <= false;
        slice0winner2_best_at_start_0(0) <= false;
        slice0winner2_best_at_start_0(1) <= false;
        slice0winner2_best_at_start_0(2) <= false;
        slice0winner2_best_at_start_0(3) <= false;
        slice0winner2_best_at_end_0(0) <= false;
        slice0winner2_best_at_end_0(1) <= false;
        slice0winner2_best_at_end_0(2) <= false;
        slice0winner2_best_at_end_0(3) <= false;
        slice0winner2_best_late_cost_0(0) <= 0;
        slice0winner2_best_late_cost_0(1) <= 0;
        slice0winner2_best_late_cost_0(2) <= 0;
        slice0winner2_best_late_cost_0(3) <= 0;
        slice0winner2_best_second_0(0) <= 2047;
        slice0winner2_best_second_0(1) <= 2047;
        slice0winner2_best_second_0(2) <= 2047;
        slice0winner2_best_second_0(3) <= 2047;
        slice0winner2_best_but_first_0(1) <= 2047;
        slice0winner2_best_but_first_0(2) <= 2047;
        slice0winner2_best_but_first_0(3) <= 2047;
        slice0winner2_best_but_last_0(0) <= 2047;
        slice0winner2_best_but_last_0(1) <= 2047;
        slice0winner2_best_but_last_0(2) <= 2047;
        slice0winner2_best_but_last_0(3) <= 2047;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_first_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_best_cost_0(0) <= 0;
        slice0winner3_best_cost_0(1) <= 0;
        slice0winner3_best_index_0_0 <= 0;
        slice0winner3_best_index_0_1 <= 0;
        slice0winner3_best_below_0(0) <= 0;
        slice0winner3_best_below_0(1) <= 0;
        slice0winner3_best_above_0(0) <= 0;
        slice0winner3_best_above_0(1) <= 0;
        slice0winner3_best_first_0_1 <= 0;
        slice0winner3_best_last_0(0) <= 0;
        slice0winner3_best_last_0(1) <= 0;
        slice0winner3_best_place_0(0) <= false;
        slice0winner3_best_place_0(1) <= false;
        slice0winner3_best_at_start_0(0) <= false;
        slice0winner3_best_at_start_0(1) <= false;
        slice0winner3_best_at_end_0(0) <= false;
        slice0winner3_best_at_end_0(1) <= false;
        slice0winner3_best_late_cost_0(0) <= 0;
        slice0winner3_best_late_cost_0(1) <= 0;
        slice0winner3_best_second_0(0) <= 2047;
        slice0winner3_best_second_0(1) <= 2047;
        slice0winner3_best_but_first_0_1 <= 2047;
        slice0winner3_best_but_last_0(0) <= 2047;
        slice0winner3_best_but_last_0(1) <= 2047;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0winner4_best_cost_0_0 <= 0;
        slice0winner4_best_index_0_0 <= 0;
        slice0winner4_best_below_0_0 <= 0;
        slice0winner4_best_above_0_0 <= 0;
        slice0winner4_best_last_0_0 <= 0;
        slice0winner4_best_place_0_0 <= false;
        slice0winner4_best_at_start_0_0 <= false;
        slice0winner4_best_at_end_0_0 <= false;
        slice0winner4_best_late_cost_0_0 <= 0;
        slice0winner4_best_second_0_0 <= 2047;
        slice0winner4_best_but_last_0_0 <= 2047;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_map_column <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner4_tag_end_of_line <= false;
        slice0_best_index_0_0 <= 0;
        slice0_best_below_0_0 <= 0;
        slice0_best_above_0_0 <= 0;
        slice0_best_last_0_0 <= 0;
        slice0_best_late_cost_0_0 <= 0;
        slice0_best_second_0_0 <= 2047;
        slice0_best_but_last_0_0 <= 2047;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice1shift_search(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1shift_search(1, i) <= 0;
        end loop;
        slice1shift_reference(0) <= 0;
        slice1shift_reference(1) <= 0;
        slice1shift_search_out(0) <= 0;
        slice1shift_search_out(1) <= 0;
        for i in 0 to 1 loop
          for j in 0 to 7 loop
            for k in 0 to 7 loop
              slice1cost_pixels_first_count(i, 2 * j, k) <= 0;
            end loop;
            for k in 0 to 7 loop
              slice1cost_pixels_first_count(i, 2 * j + 1, k) <= 0;
            end loop;
          end loop;
        end loop;
        for i in 0 to 15 loop
          slice1cost_pixels_cost(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1cost_pixels_cost(1, i) <= 0;
        end loop;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        for i in 0 to 15 loop
          slice1cost_change_0(i) <= 0;
        end loop;
        slice1cost_ready_words(0) <= to_unsigned(0, 32);
        slice1cost_ready_words(1) <= to_unsigned(0, 32);
        slice1cost_ready_words(2) <= to_unsigned(0, 32);
        slice1cost_ready_words(3) <= to_unsigned(0, 32);
        slice1cost_ready_column <= 0;
        for i in 0 to 15 loop
          slice1cost_column_0(i) <= 0;
        end loop;
        slice1cost_write_column <= 0;
        slice1cost_write_words(0) <= to_unsigned(0, 32);
        slice1cost_write_words(1) <= to_unsigned(0, 32);
        slice1cost_write_words(2) <= to_unsigned(0, 32);
        slice1cost_write_words(3) <= to_unsigned(0, 32);
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        for i in 0 to 15 loop
          slice1window_entering_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1window_change_0(i) <= 0;
        end loop;
        slice1window_change_tag_row_start <= false;
        slice1window_change_tag_leaves_window <= false;
        slice1window_change_tag_output_column <= false;
        slice1window_change_tag_first_column <= false;
        for i in 0 to 15 loop
          slice1window_sum_0(i) <= 0;
        end loop;
        slice1window_centre_map_column_0 <= false;
        slice1window_centre_output_column(0) <= false;
        slice1window_centre_output_column(1) <= false;
        slice1window_centre_output_column(2) <= false;
        slice1window_centre_output_column(3) <= false;
        slice1window_centre_first_column(0) <= false;
        slice1window_centre_first_column(1) <= false;
        slice1window_centre_first_column(2) <= false;
        slice1window_centre_first_column(3) <= false;
        slice1window_centre_start_of_frame_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1window_tag_output_column <= false;
        slice1window_tag_first_column <= false;
        for i in 0 to 15 loop
          slice1mask_inside(i) <= false;
        end loop;
        slice1mask_left_out <= false;
        for i in 0 to 15 loop
          slice1other_cost_0(i) <= 0;
        end loop;
        slice1other_winner_0_0 <= 0;
        slice1other_winner_0_1 <= 0;
        slice1other_winner_0_2 <= 0;
        slice1other_winner_0_3 <= 0;
        slice1other_winner_0_4 <= 0;
        slice1other_winner_0_5 <= 0;
        slice1other_winner_0_6 <= 0;
        slice1other_winner_0_7 <= 0;
        slice1other_winner_0_8 <= 0;
        slice1other_winner_0_9 <= 0;
        slice1other_winner_0_10 <= 0;
        slice1other_winner_0_11 <= 0;
        slice1other_winner_0_12 <= 0;
        slice1other_winner_0_13 <= 0;
        slice1other_winner_0_14 <= 0;
        slice1other_winner_0_15 <= 0;
        slice1other_cost_out_0 <= 0;
        slice1other_winner_out_0 <= 0;
        for i in 0 to 15 loop
          slice1winner1_held_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice1winner1_best_cost_0(i) <= 0;
        end loop;
        slice1winner1_best_index_0_0 <= false;
        slice1winner1_best_index_0_1 <= 0;
        slice1winner1_best_index_0_2 <= 0;
        slice1winner1_best_index_0_3 <= 0;
        slice1winner1_best_index_0_4 <= 0;
        slice1winner1_best_index_0_5 <= 0;
        slice1winner1_best_index_0_6 <= 0;
        slice1winner1_best_index_0_7 <= 0;
        for i in 0 to 7 loop
          slice1winner1_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice1winner1_best_above_0(i) <= 0;
        end loop;
        slice1winner1_best_place_0_2 <= false;
        slice1winner1_best_place_0_4 <= false;
        slice1winner1_best_place_0_6 <= false;
        for i in 0 to 7 loop
          slice1winner1_best_late_cost_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice1winner1_best_but_first_0(i) <= 2047;
        end loop;
        for i in 0 to 7 loop
          slice1winner1_best_but_last_0(i) <= 2047;
        end loop;
        slice1winner2_best_cost_0(0) <= 0;
        slice1winner2_best_cost_0(1) <= 0;
        slice1winner2_best_cost_0(2) <= 0;
        slice1winner2_best_cost_0(3) <= 0;
        slice1winner2_best_index_0_0 <= 0;
        slice1winner2_best_index_0_1 <= 0;
        slice1winner2_best_index_0_2 <= 0;
        slice1winner2_best_index_0_3 <= 0;
        slice1winner2_best_below_0(0) <= 0;
        slice1winner2_best_below_0(1) <= 0;
        slice1winner2_best_below_0(2) <= 0;
        slice1winner2_best_below_0(3) <= 0;
        slice1winner2_best_above_0(0) <= 0;
        slice1winner2_best_above_0(1) <= 0;
        slice1winner2_best_above_0(2) <= 0;
        slice1winner2_best_above_0(3) <= 0;
        slice1winner2_best_first_0(0) <= 0;
        slice1winner2_best_first_0(1) <= 0;
        slice1winner2_best_first_0(2) <= 0;
        slice1winner2_best_first_0(3) <= 0;
        slice1winner2_best_last_0(0) <= 0;
        slice1winner2_best_last_0(1) <= 0;
        slice1winner2_best_last_0(2) <= 0;
        slice1winner2_best_last_0(3) <= 0;
        slice1winner2_best_place_0(0) <= false;
        slice1winner2_best_place_0(1) <= false;
        slice1winner2_best_place_0(2) <= false;
        slice1winner2_best_place_0(3) <= false;
        slice1winner2_best_at_start_0(0) <= false;
        slice1winner2_best_at_start_0(1) <= false;
        slice1winner2_best_at_start_0(2) <= false;
        slice1winner2_best_at_start_0(3) <= false;
        slice1winner2_best_at_end_0(0) <= false;
        slice1winner2_best_at_end_0(1) <= false;
        slice1winner2_best_at_end_0(2) <= false;
        slice1winner2_best_at_end_0(3) <= false;
        slice1winner2_best_late_cost_0(0) <= 0;
        slice1winner2_best_late_cost_0(1) <= 0;
        slice1winner2_best_late_cost_0(2) <= 0;
        slice1winner2_best_late_cost_0(3) <= 0;
        slice1winner2_best_second_0(0) <= 2047;
        slice1winner2_best_second_0(1) <= 2047;
        slice1winner2_best_second_0(2) <= 2047;
        slice1winner2_best_second_0(3) <= 2047;
        slice1winner2_best_but_first_0(0) <= 2047;
        slice1winner2_best_but_first_0(1) <= 2047;
        slice1winner2_best_but_first_0(2) <= 2047;
        slice1winner2_best_but_first_0(3) <= 2047;
        slice1winner2_best_but_last_0(0) <= 2047;
        slice1winner2_best_but_last_0(1) <= 2047;
        slice1winner2_best_but_last_0(2) <= 2047;
        slice1winner2_best_but_last_0(3) <= 2047;
        slice1winner3_best_cost_0(0) <= 0;
        slice1winner3_best_cost_0(1) <= 0;
        slice1winner3_best_index_0_0 <= 0;
        slice1winner3_best_index_0_1 <= 0;
        slice1winner3_best_below_0(0) <= 0;
        slice1winner3_best_below_0(1) <= 0;
        slice1winner3_best_above_0(0) <= 0;
        slice1winner3_best_above_0(1) <= 0;
        slice1winner3_best_first_0(0) <= 0;
        slice1winner3_best_first_0(1) <= 0;
        slice1winner3_best_last_0(0) <= 0;
        slice1winner3_best_last_0(1) <= 0;
        slice1winner3_best_place_0(0) <= false;
        slice1winner3_best_place_0(1) <= false;
        slice1winner3_best_at_start_0(0) <= false;
        slice1winner3_best_at_start_0(1) <= false;
        slice1winner3_best_at_end_0(0) <= false;
        slice1winner3_best_at_end_0(1) <= false;
        slice1winner3_best_late_cost_0(0) <= 0;
        slice1winner3_best_late_cost_0(1) <= 0;
        slice1winner3_best_second_0(0) <= 2047;
        slice1winner3_best_second_0(1) <= 2047;
        slice1winner3_best_but_first_0(0) <= 2047;
        slice1winner3_best_but_first_0(1) <= 2047;
        slice1winner3_best_but_last_0(0) <= 2047;
        slice1winner3_best_but_last_0(1) <= 2047;
        slice1winner4_best_cost_0_0 <= 0;
        slice1winner4_best_index_0_0 <= 0;
        slice1winner4_best_below_0_0 <= 0;
        slice1winner4_best_above_0_0 <= 0;
        slice1winner4_best_first_0_0 <= 0;
        slice1winner4_best_last_0_0 <= 0;
        slice1winner4_best_place_0_0 <= false;
        slice1winner4_best_at_start_0_0 <= false;
        slice1winner4_best_at_end_0_0 <= false;
        slice1winner4_best_late_cost_0_0 <= 0;
        slice1winner4_best_second_0_0 <= 2047;
        slice1winner4_best_but_first_0_0 <= 2047;
        slice1winner4_best_but_last_0_0 <= 2047;
        slice1_best_cost_0_0 <= 0;
        slice1_best_index_0_0 <= 0;
        slice1_best_below_0_0 <= 0;
        slice1_best_above_0_0 <= 0;
        slice1_best_last_0_0 <= 0;
        slice1_best_place_0_0 <= false;
        slice1_best_at_start_0_0 <= false;
        slice1_best_at_end_0_0 <= false;
        slice1_best_late_cost_0_0 <= 0;
        slice1_best_second_0_0 <= 2047;
        slice1_best_but_last_0_0 <= 2047;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice2shift_search(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2shift_search(1, i) <= 0;
        end loop;
        slice2shift_reference(0) <= 0;
        slice2shift_reference(1) <= 0;
        for i in 0 to 1 loop
          for j in 0 to 7 loop
            for k in 0 to 7 loop
              slice2cost_pixels_first_count(i, 2 * j, k) <= 0;
            end loop;
            for k in 0 to 7 loop
              slice2cost_pixels_first_count(i, 2 * j + 1, k) <= 0;
            end loop;
          end loop;
        end loop;
        for i in 0 to 15 loop
          slice2cost_pixels_cost(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2cost_pixels_cost(1, i) <= 0;
        end loop;
        slice2cost_read_column <= 0;
        slice2cost_change_column <= 0;
        for i in 0 to 15 loop
          slice2cost_change_0(i) <= 0;
        end loop;
        slice2cost_ready_words(0) <= to_unsigned(0, 32);
        slice2cost_ready_words(1) <= to_unsigned(0, 32);
        slice2cost_ready_words(2) <= to_unsigned(0, 32);
        slice2cost_ready_words(3) <= to_unsigned(0, 32);
        slice2cost_ready_column <= 0;
        for i in 0 to 15 loop
          slice2cost_column_0(i) <= 0;
        end loop;
        slice2cost_write_column <= 0;
        slice2cost_write_words(0) <= to_unsigned(0, 32);
        slice2cost_write_words(1) <= to_unsigned(0, 32);
        slice2cost_write_words(2) <= to_unsigned(0, 32);
        slice2cost_write_words(3) <= to_unsigned(0, 32);
        slice2window_ring_read_address <= 1;
        slice2window_ring_write_address <= 0;
        for i in 0 to 15 loop
          slice2window_entering_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2window_change_0(i) <= 0;
        end loop;
        slice2window_change_tag_row_start <= false;
        slice2window_change_tag_output_column <= false;
        slice2window_change_tag_first_column <= false;
        for i in 0 to 15 loop
          slice2window_sum_0(i) <= 0;
        end loop;
        slice2window_centre_map_column(0) <= false;
        slice2window_centre_map_column(1) <= false;
        slice2window_centre_map_column(2) <= false;
        slice2window_centre_output_column(0) <= false;
        slice2window_centre_output_column(1) <= false;
        slice2window_centre_output_column(2) <= false;
        slice2window_centre_first_column(0) <= false;
        slice2window_centre_first_column(1) <= false;
        slice2window_centre_first_column(2) <= false;
        slice2window_centre_start_of_frame_0 <= false;
        slice2window_centre_end_of_line(0) <= false;
        slice2window_centre_end_of_line(1) <= false;
        slice2window_centre_end_of_line(2) <= false;
        for i in 0 to 15 loop
          slice2mask_inside(i) <= false;
        end loop;
        for i in 0 to 14 loop
          slice2other_cost_0(i) <= 0;
        end loop;
        slice2other_winner_0_0 <= 0;
        slice2other_winner_0_1 <= 0;
        slice2other_winner_0_2 <= 0;
        slice2other_winner_0_3 <= 0;
        slice2other_winner_0_4 <= 0;
        slice2other_winner_0_5 <= 0;
        slice2other_winner_0_6 <= 0;
        slice2other_winner_0_7 <= 0;
        slice2other_winner_0_8 <= 0;
        slice2other_winner_0_9 <= 0;
        slice2other_winner_0_10 <= 0;
        slice2other_winner_0_11 <= 0;
        slice2other_winner_0_12 <= 0;
        slice2other_winner_0_13 <= 0;
        slice2other_winner_0_14 <= 0;
        slice2other_winner_0_15 <= 0;
        slice2other_winner_out_0 <= 0;
        for i in 0 to 15 loop
          slice2winner1_held_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice2winner1_best_cost_0(i) <= 0;
        end loop;
        slice2winner1_best_index_0_0 <= false;
        slice2winner1_best_index_0_1 <= 0;
        slice2winner1_best_index_0_2 <= 0;
        slice2winner1_best_index_0_3 <= 0;
        slice2winner1_best_index_0_4 <= 0;
        slice2winner1_best_index_0_5 <= 0;
        slice2winner1_best_index_0_6 <= 0;
        slice2winner1_best_index_0_7 <= 0;
        for i in 0 to 7 loop
          slice2winner1_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice2winner1_best_above_0(i) <= 0;
        end loop;
        slice2winner1_best_place_0_2 <= false;
        slice2winner1_best_place_0_4 <= false;
        slice2winner1_best_place_0_6 <= false;
        for i in 0 to 7 loop
          slice2winner1_best_late_cost_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          slice2winner1_best_but_first_0(i) <= 2047;
        end loop;
        for i in 0 to 6 loop
          slice2winner1_best_but_last_0(i) <= 2047;
        end loop;
        slice2winner2_best_cost_0(0) <= 0;
        slice2winner2_best_cost_0(1) <= 0;
        slice2winner2_best_cost_0(2) <= 0;
        slice2winner2_best_cost_0(3) <= 0;
        slice2winner2_best_index_0_0 <= 0;
        slice2winner2_best_index_0_1 <= 0;
        slice2winner2_best_index_0_2 <= 0;
        slice2winner2_best_index_0_3 <= 0;
        slice2winner2_best_below_0(0) <= 0;
        slice2winner2_best_below_0(1) <= 0;
        slice2winner2_best_below_0(2) <= 0;
        slice2winner2_best_below_0(3) <= 0;
        slice2winner2_best_above_0(0) <= 0;
        slice2winner2_best_above_0(1) <= 0;
        slice2winner2_best_above_0(2) <= 0;
        slice2winner2_best_above_0(3) <= 0;
        slice2winner2_best_first_0(0) <= 0;
        slice2winner2_best_first_0(1) <= 0;
        slice2winner2_best_first_0(2) <= 0;
        slice2winner2_best_first_0(3) <= 0;
        slice2winner2_best_last_0(0) <= 0;
        slice2winner2_best_last_0(1) <= 0;
        slice2winner2_best_last_0(2) <= 0;
        slice2winner2_best_place_0(0) <= false;
        slice2winner2_best_place_0(1) <= false;
        slice2winner2_best_place_0(2) <= false;
        slice2winner2_best_place_0(3) <= false;
        slice2winner2_best_at_start_0(0) <= false;
        slice2winner2_best_at_start_0(1) <= false;
        slice2winner2_best_at_start_0(2) <= false;
        slice2winner2_best_at_start_0(3) <= false;
        slice2winner2_best_at_end_0(0) <= false;
        slice2winner2_best_at_end_0(1) <= false;
        slice2winner2_best_at_end_0(2) <= false;
        slice2winner2_best_at_end_0(3) <= false;
        slice2winner2_best_late_cost_0(0) <= 0;
        slice2winner2_best_late_cost_0(1) <= 0;
        slice2winner2_best_late_cost_0(2) <= 0;
        slice2winner2_best_late_cost_0(3) <= 0;
        slice2winner2_best_second_0(0) <= 2047;
        slice2winner2_best_second_0(1) <= 2047;
        slice2winner2_best_second_0(2) <= 2047;
        slice2winner2_best_second_0(3) <= 2047;
        slice2winner2_best_but_first_0(0) <= 2047;
        slice2winner2_best_but_first_0(1) <= 2047;
        slice2winner2_best_but_first_0(2) <= 2047;
        slice2winner2_best_but_first_0(3) <= 2047;
        slice2winner2_best_but_last_0(0) <= 2047;
        slice2winner2_best_but_last_0(1) <= 2047;
        slice2winner2_best_but_last_0(2) <= 2047;
        slice2winner3_best_cost_0(0) <= 0;
        slice2winner3_best_cost_0(1) <= 0;
        slice2winner3_best_index_0_0 <= 0;
        slice2winner3_best_index_0_1 <= 0;
        slice2winner3_best_below_0(0) <= 0;
        slice2winner3_best_below_0(1) <= 0;
        slice2winner3_best_above_0(0) <= 0;
        slice2winner3_best_above_0(1) <= 0;
        slice2winner3_best_first_0(0) <= 0;
        slice2winner3_best_first_0(1) <= 0;
        slice2winner3_best_last_0_0 <= 0;
        slice2winner3_best_place_0(0) <= false;
        slice2winner3_best_place_0(1) <= false;
        slice2winner3_best_at_start_0(0) <= false;
        slice2winner3_best_at_start_0(1) <= false;
        slice2winner3_best_at_end_0(0) <= false;
        slice2winner3_best_at_end_0(1) <= false;
        slice2winner3_best_late_cost_0(0) <= 0;
        slice2winner3_best_late_cost_0(1) <= 0;
        slice2winner3_best_second_0(0) <= 2047;
        slice2winner3_best_second_0(1) <= 2047;
        slice2winner3_best_but_first_0(0) <= 2047;
        slice2winner3_best_but_first_0(1) <= 2047;
        slice2winner3_best_but_last_0_0 <= 2047;
        slice2winner4_best_cost_0_0 <= 0;
        slice2winner4_best_index_0_0 <= 0;
        slice2winner4_best_below_0_0 <= 0;
        slice2winner4_best_above_0_0 <= 0;
        slice2winner4_best_first_0_0 <= 0;
        slice2winner4_best_place_0_0 <= false;
        slice2winner4_best_at_start_0_0 <= false;
        slice2winner4_best_at_end_0_0 <= false;
        slice2winner4_best_late_cost_0_0 <= 0;
        slice2winner4_best_second_0_0 <= 2047;
        slice2winner4_best_but_first_0_0 <= 2047;
        slice2_best_cost_0_0 <= 0;
        slice2_best_index_0_0 <= 0;
        slice2_best_below_0_0 <= 0;
        slice2_best_above_0_0 <= 0;
        slice2_best_place_0_0 <= false;
        slice2_best_at_start_0_0 <= false;
        slice2_best_at_end_0_0 <= false;
        slice2_best_late_cost_0_0 <= 0;
        slice2_best_second_0_0 <= 2047;
        slice2_best_tag_valid <= false;
        slice2_best_tag_map_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        for i in 0 to 11 loop
          refinement_disparity_0(i) <= 0;
        end loop;
        for i in 0 to 11 loop
          refinement_tag_valid(i) <= false;
          refinement_tag_map_column(i) <= false;
          refinement_tag_start_of_frame(i) <= false;
          refinement_tag_end_of_line(i) <= false;
        end loop;
        refinement_alone_0_0 <= false;
        refinement_gap_0 <= 0;
        for i in 0 to 9 loop
          refinement_margin_0(i) <= 0;
        end loop;
        refinement_below_0 <= 0;
        refinement_above_0 <= 0;
        refinement_u_0 <= 0;
        refinement_v_0 <= 0;
        refinement_difference_0 <= 0;
        for i in 0 to 7 loop
          refinement_remainder_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          refinement_divisor_0(i) <= 1;
        end loop;
        refinement_quotient_8_0 <= 0;
        for i in 0 to 8 loop
          refinement_negative_0(i) <= false;
        end loop;
        refinement_fraction_0 <= 8;
        for i in 1 to 15 loop
          leftright_other_0(i) <= 0;
        end loop;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_position <= 0;
        leftright_held_valid <= false;
        leftright_address_0 <= 0;
        leftright_asking_disparity_0 <= 0;
        leftright_asking_fraction_0 <= 8;
        leftright_asking_passed_0 <= true;
        leftright_asking_margin_0 <= 0;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_disparity_0 <= 0;
        leftright_answered_fraction_0 <= 8;
        leftright_answered_passed_0 <= true;
        leftright_answered_margin_0 <= 0;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_disparity_0 <= 0;
        leftright_checked_fraction_0 <= 8;
        leftright_checked_passed_0 <= true;
        leftright_checked_margin_0 <= 0;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_row_start <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
        support_counter_column <= 0;
        support_counter_group <= 377;
        support_newest_0 <= 0;
        support_newest_rest_0 <= 0;
        support_moves <= false;
        support_arrives <= false;
        support_last <= false;
        support_rows_read_newest_0 <= 0;
        support_rows_ready_words_0 <= 0;
        support_rows_ready_newest_0 <= 0;
        support_rows_write_words_0 <= 0;
        support_rest_rows_read_newest_0 <= 0;
        support_rest_rows_ready_words_0 <= 0;
        support_rest_rows_ready_newest_0 <= 0;
        support_rest_rows_write_words_0 <= 0;
        support_read_column <= 0;
        support_read_moves <= false;
        support_read_arrives <= false;
        support_read_above2 <= false;
        support_read_above1 <= false;
        support_read_below1 <= false;
        support_read_below2 <= false;
        support_read_first <= false;
        support_read_last <= false;
        support_ready_column <= 0;
        support_ready_moves <= false;
        support_ready_arrives <= false;
        support_ready_above2 <= false;
        support_ready_above1 <= false;
        support_ready_below1 <= false;
        support_ready_below2 <= false;
        support_ready_first <= false;
        support_ready_last <= false;
        support_write_column <= 0;
        for i in 0 to 4 loop
          support_column(i) <= 0;
        end loop;
        support_column_rest_0 <= 0;
        support_at_moves <= false;
        support_at_arrives <= false;
        support_at_first <= false;
        support_at_last <= false;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i, j) <= 0;
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_cells(12, i) <= 0;
        end loop;
        for i in 0 to 12 loop
          support_row_tag(i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_rest_0(i) <= 0;
        end loop;
        for i in 0 to 6 loop
          support_moment_map_column(i) <= false;
          support_moment_start_of_frame(i) <= false;
          support_moment_last(i) <= false;
        end loop;
        support_next_tag <= false;
        support_moved <= false;
        for i in 0 to 2 loop
          for j in 0 to 4 loop
            support_like_0(2 * i, j) <= false;
          end loop;
          for j in 0 to 4 loop
            support_like_0(2 * i + 1, j) <= false;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_like_0(6, i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_partial_0(i) <= 0;
        end loop;
        support_count_0 <= 0;
        support_enough_0 <= false;
        support_sum_0 <= 0;
        support_centre_0(0) <= 0;
        support_centre_0(1) <= 0;
        support_centre_0(2) <= 0;
        support_centre_rest_0(0) <= 0;
        support_centre_rest_0(1) <= 0;
        support_centre_rest_0(2) <= 0;
        for i in 0 to 3 loop
          support_centre_moment_map_column(i) <= false;
          support_centre_moment_start_of_frame(i) <= false;
          support_centre_moment_last(i) <= false;
        end loop;
        support_centre_moved(0) <= false;
        support_centre_moved(1) <= false;
        support_centre_moved(2) <= false;
        support_centre_moved(3) <= false;
        support_out_disparity_0 <= 0;
        support_out_passed_0 <= false;
        support_out_sure_0 <= 0;
        support_out_tag_valid <= false;
        support_out_tag_row_start <= false;
        support_out_tag_map_column <= false;
        support_out_tag_start_of_frame <= false;
        support_out_tag_end_of_line <= false;
        fill_counter_column <= 0;
        fill_counter_group <= 376;
        fill_newest_disparity_0 <= 0;
        fill_newest_passed_0 <= false;
        fill_newest_sure_0 <= 0;
        fill_moves <= false;
        fill_arrives <= false;
        fill_last <= false;
        fill_rows_read_newest_0 <= 0;
        fill_rows_ready_words_0 <= 0;
        fill_rows_ready_newest_0 <= 0;
        fill_rows_write_words_0 <= 0;
        fill_read_column <= 0;
        fill_read_moves <= false;
        fill_read_arrives <= false;
        fill_read_top <= false;
        fill_read_last <= false;
        fill_ready_column <= 0;
        fill_ready_moves <= false;
        fill_ready_arrives <= false;
        fill_ready_top <= false;
        fill_ready_last <= false;
        fill_write_column <= 0;
        fill_ends_open_0 <= false;
        fill_pixel_0_passed <= false;
        fill_at_column <= 0;
        fill_at_moves <= false;
        fill_at_arrives <= false;
        fill_at_top <= false;
        fill_at_last <= false;
        fill_in_hole_0 <= false;
        fill_asking_0_passed(0) <= false;
        fill_asking_0_passed(1) <= false;
        for i in 0 to 1 loop
          fill_asking_at_column(i) <= 0;
          fill_asking_at_moves(i) <= false;
          fill_asking_at_arrives(i) <= false;
          fill_asking_at_top(i) <= false;
          fill_asking_at_last(i) <= false;
        end loop;
        fill_hole_starts_0(0) <= false;
        fill_hole_starts_0(1) <= false;
        fill_known_at_column <= 0;
        fill_known_at_moves <= false;
        fill_known_at_arrives <= false;
        fill_known_at_top <= false;
        fill_known_at_last <= false;
        fill_measured_at_column <= 0;
        fill_measured_at_moves <= false;
        fill_measured_at_arrives <= false;
        fill_measured_at_top <= false;
        fill_measured_at_last <= false;
        fill_chosen_at_column <= 0;
        fill_chosen_at_moves <= false;
        fill_chosen_at_arrives <= false;
        fill_chosen_at_top <= false;
        fill_chosen_at_last <= false;
        fill_out_tag_valid <= false;
        fill_out_tag_row_start <= false;
        fill_out_tag_map_column <= false;
        fill_out_tag_start_of_frame <= false;
        fill_out_tag_end_of_line <= false;
        median_counter_column <= 0;
        median_counter_group <= 376;
        median_arrives <= false;
        median_behind <= false;
        median_line_ended <= false;
        median_read_column <= 0;
        median_read_arrives <= false;
        median_read_behind <= false;
        median_read_top <= false;
        median_read_output <= false;
        median_ready_column <= 0;
        median_ready_arrives <= false;
        median_ready_behind <= false;
        median_ready_top <= false;
        median_ready_output <= false;
        median_write_column <= 0;
        median_at_arrives <= false;
        median_at_behind <= false;
        median_at_top <= false;
        median_at_output <= false;
        median_comparing_column <= 0;
        median_comparing_arrives <= false;
        median_comparing_behind <= false;
        median_comparing_top <= false;
        median_comparing_output <= false;
        median_sorted_column <= 0;
        median_sorted_arrives <= false;
        median_sorted_behind <= false;
        median_sorted_top <= false;
        median_sorted_output <= false;
        median_window_complete <= false;
        median_window_first <= false;
        median_window_last <= false;
        for i in 0 to 2 loop
          median_waiting_complete(i) <= false;
          median_waiting_first(i) <= false;
          median_waiting_last(i) <= false;
        end loop;
        median_out_valid <= false;
        median_out_start_of_frame <= false;
        median_out_end_of_line <= false;
        other_0 <= true;
        other_2 <= 0;
        other_3 <= 0;
        other_4 <= 0;
        other_5 <= 0;
        other_6 <= 0;
        other_7 <= 0;
        other_8 <= 0;
        other_9 <= 0;
        other_10 <= 0;
        for i in 11 to 22 loop
          other(i) <= 0;
        end loop;
      end if;
    end if;
  end process;
end architecture;
