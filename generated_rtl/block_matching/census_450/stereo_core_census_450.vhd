-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_450: 450x375, 48 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 48, window_px 9, reference left, cost census, census_width_px 9, census_pattern
--   even_columns, subpixel true, median true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_450
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_450 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 48;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 402;
    latency_clocks : positive := 49;
    flush_groups : positive := 3159;
    gap_groups : positive := 1800
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
  assert width_px = 450 report "stereo_core_census_450: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_census_450: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 48 report "stereo_core_census_450: disparities is " & integer'image(disparities) & " but this core has 48" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_450: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_census_450: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 402 report "stereo_core_census_450: output_width_px is " & integer'image(output_width_px) & " but this core has 402" severity failure;
  assert latency_clocks = 49 report "stereo_core_census_450: latency_clocks is " & integer'image(latency_clocks) & " but this core has 49" severity failure;
  assert flush_groups = 3159 report "stereo_core_census_450: flush_groups is " & integer'image(flush_groups) & " but this core has 3159" severity failure;
  assert gap_groups = 1800 report "stereo_core_census_450: gap_groups is " & integer'image(gap_groups) & " but this core has 1800" severity failure;
end entity;

architecture rtl of stereo_core_census_450 is
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
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_47_1d is array (natural range <>) of natural range 0 to 47;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
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
  signal transform_filtering_row_inside_4 : boolean_1d(0 to 1);  -- transform_filtering_#_row_inside_4
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_column_inside_4 : boolean_1d(0 to 1);  -- transform_filtering_#_column_inside_4
  signal transform_filtering_0_column_inside_6, transform_filtering_0_column_inside_8 : boolean;
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
  signal delay_tag_valid, delay_tag_row_start, delay_tag_first_group, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_leaves_window, delay_tag_map_column, delay_tag_start_of_frame : boolean;
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
  signal rows_read_tag_valid, rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_border_column : boolean;
  signal rows_read_tag_first_cost, rows_read_tag_leaves_window, rows_read_tag_map_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_leaves_window : boolean;
  signal rows_ready_tag_map_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid : boolean;
  signal rows_tag_row_start, rows_tag_first_group, rows_tag_border_column, rows_tag_first_cost : boolean;
  signal rows_tag_leaves_window, rows_tag_map_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice0shift_reference : natural_16777215_1d(0 to 1);
  signal slice0shift_search_out : natural_16777215_1d(0 to 1);
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- slice0cost_pixels_first_#_#_count_#
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_map_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_map_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_first_group, slice0cost_ready_tag_border_column : boolean;
  signal slice0cost_ready_tag_first_cost, slice0cost_ready_tag_leaves_window, slice0cost_ready_tag_map_column : boolean;
  signal slice0cost_ready_tag_start_of_frame, slice0cost_ready_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_map_column, slice0cost_tag_start_of_frame : boolean;
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
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_group : boolean;
  signal slice0window_entering_tag_border_column, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_map_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_map_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_map_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice0window_sum_0 : natural_2047_1d(0 to 15);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_first_0 : natural_2047_1d(1 to 7);
  signal slice0winner1_best_last_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
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
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_above_0_0, slice0winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_tag_valid, slice0winner4_tag_map_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0 : natural range 0 to 2047;
  signal slice0_best_last_0_0 : natural range 0 to 2047;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
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
  signal slice1window_change_tag_first_cost, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_centre_map_column_0, slice1window_centre_start_of_frame_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_2047_1d(0 to 15);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_first_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_last_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
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
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_above_0_0, slice1winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_last_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_start_of_frame : boolean;
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
  signal slice2window_change_tag_first_cost : boolean;
  signal slice2window_centre_map_column : boolean_1d(0 to 2);
  signal slice2window_centre_start_of_frame : boolean_1d(0 to 2);
  signal slice2window_centre_end_of_line : boolean_1d(0 to 2);
  signal slice2window_sum_0 : natural_2047_1d(0 to 15);
  -- slice2winner1
  signal slice2winner1_best_cost_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_below_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_first_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_last_0 : natural_2047_1d(0 to 6);
  signal slice2winner1_best_index_0_0 : boolean;
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
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_below_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_above_0_0, slice2winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0 : natural range 0 to 2047;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_tag_valid, slice2_best_tag_map_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0 : natural_47_1d(0 to 11);  -- refinement_disparity_#_0
  signal refinement_passed_0 : boolean_1d(0 to 3);  -- refinement_passed_#_0
  signal refinement_passed_0s : boolean_1d(5 to 8);  -- refinement_passed_#_0
  signal refinement_passed_11_0 : boolean;
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- refinement_tag_#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- refinement_tag_#_map_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- refinement_tag_#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- refinement_tag_#_end_of_line
  signal refinement_tag_11_row_start : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- refinement_negative_#_0
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 2047;
  signal refinement_v_0 : natural range 0 to 2047;
  signal refinement_remainder_0 : natural_2047_1d(0 to 7);  -- refinement_remainder_#_0
  signal refinement_divisor_0 : natural_2047_1d(0 to 7);  -- refinement_divisor_#_0
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_counter_column, map_counter_group, map_write_column, map_at_column : natural range 0 to 511;
  signal map_comparing_column, map_sorted_column : natural range 0 to 511;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b : boolean;
  signal map_column_passed_0 : boolean_1d(0 to 1);  -- map_column_passed_#_0
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output : boolean;
  signal map_sorted_arrives, map_sorted_behind, map_sorted_top, map_sorted_output : boolean;
  signal map_passed_0 : boolean_1d(0 to 1);  -- map_passed_#_0
  signal map_window_complete, map_window_first, map_window_last, map_of_low_0_b_below_a : boolean;
  signal map_of_low_0_c_below_a, map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a : boolean;
  signal map_of_middle_0_c_below_b, map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b : boolean;
  signal map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_waiting_complete : boolean_1d(0 to 2);  -- map_waiting_#_complete
  signal map_waiting_first : boolean_1d(0 to 2);  -- map_waiting_#_first
  signal map_waiting_last : boolean_1d(0 to 2);  -- map_waiting_#_last
  signal map_waiting_passed_0 : boolean_1d(0 to 2);  -- map_waiting_passed_#_0
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0, map_column_2 : natural range 0 to 65535;
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_column_1 : natural range 0 to 8191;
  signal map_of_column_0_a, map_of_column_0_b : natural range 0 to 4095;
  signal map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 32767;
  signal map_low_0 : natural_32767_1d(0 to 2);  -- map_low_#_0
  signal map_middle_0 : natural_32767_1d(0 to 2);  -- map_middle_#_0
  signal map_high_0 : natural_32767_1d(0 to 2);  -- map_high_#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a : natural range 0 to 32767;
  signal map_of_middle_0_b, map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b : natural range 0 to 32767;
  signal map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0 : natural range 0 to 32767;
  signal map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 32767;
  -- other
  signal other : boolean_1d(0 to 8);
  signal other_9, other_11 : unsigned(48 downto 0);
  signal other_10 : natural range 0 to 8190;
  signal other_12 : natural range 0 to 254;
  signal other_13 : natural range 0 to 252;
  signal other_14 : natural range 0 to 248;
  signal other_15 : natural range 0 to 240;
  signal other_16 : natural range 0 to 224;
  signal other_17 : natural range 0 to 192;
  signal other_18 : natural range 0 to 128;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address, map_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
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
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

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

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 9);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 9);
  map_rows_read_words_0_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 402, width => 26, address_bits => 9)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

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
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_3_memory_write_data <= slice2cost_write_words(3);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words(3),
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_2_memory_write_data <= slice2cost_write_words(2);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words(2),
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_1_memory_write_data <= slice2cost_write_words(1);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words(1),
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
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
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_3_memory_write_data <= slice1cost_write_words(3);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words(3),
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= slice1cost_write_words(2);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words(2),
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= slice1cost_write_words(1);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words(1),
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
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
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_3_memory_write_data <= slice0cost_write_words(3);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words(3),
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= slice0cost_write_words(2);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words(2),
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= slice0cost_write_words(1);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words(1),
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
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
    variable raster_place_group_is_equal : boolean;
    variable slice0cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice0cost_pixels_first_#_0_count_#_value
    variable slice0cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice0cost_pixels_first_#_0_count_#_value_2
    variable slice0cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice0cost_pixels_first_#_0_count_1_value_3
    variable slice0cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice0cost_pixels_first_#_0_count_#_value_3
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice0winner1_best_cost_0_#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice0winner2_best_cost_0_#_is_less
    variable slice0winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice0winner3_best_cost_0_#_is_less
    variable slice0winner4_best_cost_0_0_is_less : boolean;
    variable slice1cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice1cost_pixels_first_#_0_count_#_value
    variable slice1cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice1cost_pixels_first_#_0_count_#_value_2
    variable slice1cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice1cost_pixels_first_#_0_count_1_value_3
    variable slice1cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice1cost_pixels_first_#_0_count_#_value_3
    variable slice1winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice1winner1_best_cost_0_#_is_less
    variable slice1winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice1winner2_best_cost_0_#_is_less
    variable slice1winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice1winner3_best_cost_0_#_is_less
    variable slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less : boolean;
    variable slice2cost_pixels_first_0_count_value : boolean_2d(0 to 1, 0 to 7);  -- slice2cost_pixels_first_#_0_count_#_value
    variable slice2cost_pixels_first_0_count_value_2 : boolean_2d(0 to 1, 0 to 7);  -- slice2cost_pixels_first_#_0_count_#_value_2
    variable slice2cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 1);  -- slice2cost_pixels_first_#_0_count_1_value_3
    variable slice2cost_pixels_first_0_count_value_3 : boolean_2d(0 to 1, 3 to 6);  -- slice2cost_pixels_first_#_0_count_#_value_3
    variable slice2winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- slice2winner1_best_cost_0_#_is_less
    variable slice2winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice2winner2_best_cost_0_#_is_less
    variable slice2winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice2winner3_best_cost_0_#_is_less
    variable slice2winner4_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less : boolean;
    variable refinement_tag_11_row_start_differs, refinement_tag_11_row_start_is_equal : boolean;
    variable refinement_tag_11_row_start_choice : boolean;
    variable refinement_tag_11_row_start_choices : boolean_1d(2 to 3);  -- refinement_tag_11_row_start_choice_#
    variable refinement_tag_11_row_start_is_equal_2, refinement_tag_11_row_start_all : boolean;
    variable refinement_tag_11_row_start_all_2, refinement_divisor_0_0_is_less, map_counter_group_is_equal : boolean;
    variable map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal : boolean;
    variable map_window_complete_choice : boolean;
    variable map_low_0_all : boolean_1d(0 to 1);  -- map_low_#_0_all
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- transform_counter_group_choice_#
    variable map_counter_group_choices : natural_511_1d(2 to 3);  -- map_counter_group_choice_#
    variable slice0cost_column_0_choice : natural_255_1d(0 to 15);  -- slice0cost_column_0_#_choice
    variable slice0cost_column_0_choice_2 : natural_255_1d(0 to 15);  -- slice0cost_column_0_#_choice_2
    variable slice0window_change_0_choice : natural_255_1d(0 to 15);  -- slice0window_change_0_#_choice
    variable slice1cost_column_0_choice : natural_255_1d(0 to 15);  -- slice1cost_column_0_#_choice
    variable slice1cost_column_0_choice_2 : natural_255_1d(0 to 15);  -- slice1cost_column_0_#_choice_2
    variable slice1window_change_0_choice : natural_255_1d(0 to 15);  -- slice1window_change_0_#_choice
    variable slice2cost_column_0_choice : natural_255_1d(0 to 15);  -- slice2cost_column_0_#_choice
    variable slice2cost_column_0_choice_2 : natural_255_1d(0 to 15);  -- slice2cost_column_0_#_choice_2
    variable slice2window_change_0_choice : natural_255_1d(0 to 15);  -- slice2window_change_0_#_choice
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable slice0window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice0window_sum_0_#_choice
    variable slice0winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice0winner2_best_below_0_#_choice
    variable slice0winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice0winner2_best_above_0_#_choice
    variable slice0winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice0winner3_best_below_0_#_choice
    variable slice0winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice0winner3_best_above_0_#_choice
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice1window_sum_0_#_choice
    variable slice1winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice1winner2_best_below_0_#_choice
    variable slice1winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice1winner2_best_above_0_#_choice
    variable slice1winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice1winner3_best_below_0_#_choice
    variable slice1winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice1winner3_best_above_0_#_choice
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2window_sum_0_choice : natural_2047_1d(0 to 15);  -- slice2window_sum_0_#_choice
    variable slice2winner2_best_below_0_choice : natural_2047_1d(0 to 3);  -- slice2winner2_best_below_0_#_choice
    variable slice2winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- slice2winner2_best_above_0_#_choice
    variable slice2winner3_best_below_0_choice : natural_2047_1d(0 to 1);  -- slice2winner3_best_below_0_#_choice
    variable slice2winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- slice2winner3_best_above_0_#_choice
    variable slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2_best_below_0_0_choice, slice2_best_above_0_0_choice : natural range 0 to 2047;
    variable refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- refinement_remainder_#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable map_of_column_0_a_choice : natural range 0 to 4095;
    variable map_of_column_0_c_choice, map_sorted_low_0_choice, map_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_middle_0_choice, map_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_high_0_choice, map_sorted_high_0_choice_2, map_largest_low_0_choice : natural range 0 to 32767;
    variable map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 32767;
    variable map_median_middle_0_choices : natural_32767_1d(2 to 4);  -- map_median_middle_0_choice_#
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 32767;
    variable map_out_disparity_0_choice : natural range 0 to 32767;
    variable map_out_disparity_0_choices : natural_32767_1d(2 to 4);  -- map_out_disparity_0_choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 32767;
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
          transform_left_filter_feature_0_choices(8 * i + 89) := transform_filtering_column_inside_4(0) and
            is_set(transform_left_filter_column(4, 3 - 3 * i), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 89) := transform_filtering_column_inside_4(0) and
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
          transform_left_filter_feature_0_choices(8 * i + 105) := transform_filtering_column_inside_4(0) and
            is_set(transform_left_filter_column(4, 3 * i + 1), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(8 * i + 105) := transform_filtering_column_inside_4(0) and
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
          transform_right_filter_feature_0_choices(8 * i + 89) := transform_filtering_column_inside_4(0) and
            is_set(transform_right_filter_column(4, 3 - 3 * i), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 89) := transform_filtering_column_inside_4(0) and
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
          transform_right_filter_feature_0_choices(8 * i + 105) := transform_filtering_column_inside_4(0) and
            is_set(transform_right_filter_column(4, 3 * i + 1), 7) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(8 * i + 105) := transform_filtering_column_inside_4(0) and
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
      transform_filtering_row_inside_4(0) <= refinement_passed_0s(8);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_column_inside_4(0) <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_row_inside_4(1) <= transform_filtering_row_inside_4(0);
      transform_filtering_column_inside_4(1) <= refinement_passed_0(3);
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
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 384);
      delay_row_inside(1) <= raster_place_group < 375;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 47;
      delay_tag_first_cost <= raster_place_column = 47;
      delay_tag_leaves_window <= (((((raster_place_column / 8) + 8185) mod 8192) * 8) + (raster_place_column mod 8)) <
        65484;
      delay_tag_map_column <= (((((raster_place_column / 16) + 4093) mod 4096) * 16) + (raster_place_column mod 16)) <
        402;
      delay_tag_start_of_frame <= (raster_place_group = 4) and (raster_place_column = 48);
      delay_tag_end_of_line <= raster_place_group_is_equal;
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
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_map_column <= delay_tag_map_column;
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
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_map_column <= rows_ready_tag_map_column;
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
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_map_column <= rows_tag_map_column;
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
          if slice0cost_ready_tag_border_column then
            slice0cost_column_0_choice_2(4 * i + j) := 0;
          else
            slice0cost_column_0_choice_2(4 * i + j) := (slice0cost_change_0(4 * i + j) + slice0cost_column_0_choice(4 *
              i + j)) mod 256;
          end if;
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
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
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
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
      end loop;
      slice0cost_ready_words(0) <= slice0cost_read_words(0);
      slice0cost_ready_words(1) <= slice0cost_read_words(1);
      slice0cost_ready_words(2) <= slice0cost_read_words(2);
      slice0cost_ready_words(3) <= slice0cost_read_words(3);
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
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
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
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
        for i in 0 to 3 loop
          slice0cost_write_words(i) <= to_unsigned(slice0cost_column_0_choice_2(4 * i + 3), 8) &
            to_unsigned(slice0cost_column_0_choice_2(4 * i + 2), 8) & to_unsigned(slice0cost_column_0_choice_2(4 * i +
            1), 8) & to_unsigned(slice0cost_column_0_choice_2(4 * i), 8);
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
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_border_column <= slice0cost_tag_border_column;
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      for i in 0 to 15 loop
        slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
      end loop;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_map_column_0 <= slice0window_change_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
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
          slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 2048;
        end loop;
      end if;
      -- slice0winner1
      for i in 0 to 7 loop
        slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
      end loop;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
      for i in 1 to 7 loop
        slice0winner1_best_first_0(i) <= slice0window_sum_0(2 * i);
      end loop;
      for i in 0 to 7 loop
        slice0winner1_best_last_0(i) <= slice0window_sum_0(2 * i + 1);
      end loop;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_best_cost_0_is_less(0) then
        slice0winner1_best_cost_0(0) <= slice0window_sum_0(1);
        slice0winner1_best_below_0(0) <= slice0window_sum_0(0);
        slice0winner1_best_above_0(0) <= 0;
      else
        slice0winner1_best_cost_0(0) <= slice0window_sum_0(0);
        slice0winner1_best_below_0(0) <= 0;
        slice0winner1_best_above_0(0) <= slice0window_sum_0(1);
      end if;
      if slice0winner1_best_cost_0_is_less(1) then
        slice0winner1_best_cost_0(1) <= slice0window_sum_0(3);
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0(1) <= slice0window_sum_0(2);
        slice0winner1_best_above_0(1) <= 0;
      else
        slice0winner1_best_cost_0(1) <= slice0window_sum_0(2);
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0(1) <= 0;
        slice0winner1_best_above_0(1) <= slice0window_sum_0(3);
      end if;
      if slice0winner1_best_cost_0_is_less(2) then
        slice0winner1_best_cost_0(2) <= slice0window_sum_0(5);
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0(2) <= slice0window_sum_0(4);
        slice0winner1_best_above_0(2) <= 0;
      else
        slice0winner1_best_cost_0(2) <= slice0window_sum_0(4);
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0(2) <= 0;
        slice0winner1_best_above_0(2) <= slice0window_sum_0(5);
      end if;
      if slice0winner1_best_cost_0_is_less(3) then
        slice0winner1_best_cost_0(3) <= slice0window_sum_0(7);
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0(3) <= slice0window_sum_0(6);
        slice0winner1_best_above_0(3) <= 0;
      else
        slice0winner1_best_cost_0(3) <= slice0window_sum_0(6);
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0(3) <= 0;
        slice0winner1_best_above_0(3) <= slice0window_sum_0(7);
      end if;
      if slice0winner1_best_cost_0_is_less(4) then
        slice0winner1_best_cost_0(4) <= slice0window_sum_0(9);
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0(4) <= slice0window_sum_0(8);
        slice0winner1_best_above_0(4) <= 0;
      else
        slice0winner1_best_cost_0(4) <= slice0window_sum_0(8);
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0(4) <= 0;
        slice0winner1_best_above_0(4) <= slice0window_sum_0(9);
      end if;
      if slice0winner1_best_cost_0_is_less(5) then
        slice0winner1_best_cost_0(5) <= slice0window_sum_0(11);
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0(5) <= slice0window_sum_0(10);
        slice0winner1_best_above_0(5) <= 0;
      else
        slice0winner1_best_cost_0(5) <= slice0window_sum_0(10);
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0(5) <= 0;
        slice0winner1_best_above_0(5) <= slice0window_sum_0(11);
      end if;
      if slice0winner1_best_cost_0_is_less(6) then
        slice0winner1_best_cost_0(6) <= slice0window_sum_0(13);
        slice0winner1_best_index_0_6 <= 13;
        slice0winner1_best_below_0(6) <= slice0window_sum_0(12);
        slice0winner1_best_above_0(6) <= 0;
      else
        slice0winner1_best_cost_0(6) <= slice0window_sum_0(12);
        slice0winner1_best_index_0_6 <= 12;
        slice0winner1_best_below_0(6) <= 0;
        slice0winner1_best_above_0(6) <= slice0window_sum_0(13);
      end if;
      if slice0winner1_best_cost_0_is_less(7) then
        slice0winner1_best_cost_0(7) <= slice0window_sum_0(15);
        slice0winner1_best_index_0_7 <= 15;
        slice0winner1_best_below_0(7) <= slice0window_sum_0(14);
        slice0winner1_best_above_0(7) <= 0;
      else
        slice0winner1_best_cost_0(7) <= slice0window_sum_0(14);
        slice0winner1_best_index_0_7 <= 14;
        slice0winner1_best_below_0(7) <= 0;
        slice0winner1_best_above_0(7) <= slice0window_sum_0(15);
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice2window_centre_map_column(2);
        slice0winner1_tag_start_of_frame <= slice2window_centre_start_of_frame(2);
        slice0winner1_tag_end_of_line <= slice2window_centre_end_of_line(2);
      end if;
      -- slice0winner2
      for i in 0 to 3 loop
        slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      if slice0winner1_best_index_0_1 = 2 then
        slice0winner2_best_below_0_choice(0) := slice0winner1_best_last_0(0);
      else
        slice0winner2_best_below_0_choice(0) := slice0winner1_best_below_0(1);
      end if;
      if slice0winner1_best_index_0_3 = 6 then
        slice0winner2_best_below_0_choice(1) := slice0winner1_best_last_0(2);
      else
        slice0winner2_best_below_0_choice(1) := slice0winner1_best_below_0(3);
      end if;
      if is_set(slice0winner1_best_index_0_5, 3) and ((slice0winner1_best_index_0_5 mod 4) = 2) then
        slice0winner2_best_below_0_choice(2) := slice0winner1_best_last_0(4);
      else
        slice0winner2_best_below_0_choice(2) := slice0winner1_best_below_0(5);
      end if;
      if slice0winner1_best_index_0_7 = 14 then
        slice0winner2_best_below_0_choice(3) := slice0winner1_best_last_0(6);
      else
        slice0winner2_best_below_0_choice(3) := slice0winner1_best_below_0(7);
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_choice(0) := slice0winner1_best_first_0(1);
      else
        slice0winner2_best_above_0_choice(0) := slice0winner1_best_above_0(0);
      end if;
      for i in 6 to 8 loop
        if other(i) then
          slice0winner2_best_above_0_choice(i - 5) := slice0winner1_best_first_0(2 * i - 9);
        else
          slice0winner2_best_above_0_choice(i - 5) := slice0winner1_best_above_0(2 * i - 10);
        end if;
      end loop;
      slice0winner2_best_first_0(1) <= slice0winner1_best_first_0(2);
      slice0winner2_best_first_0(2) <= slice0winner1_best_first_0(4);
      slice0winner2_best_first_0(3) <= slice0winner1_best_first_0(6);
      slice0winner2_best_last_0(0) <= slice0winner1_best_last_0(1);
      slice0winner2_best_last_0(1) <= slice0winner1_best_last_0(3);
      slice0winner2_best_last_0(2) <= slice0winner1_best_last_0(5);
      slice0winner2_best_last_0(3) <= slice0winner1_best_last_0(7);
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
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
      -- slice0winner3
      slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
      slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
      if slice0winner2_best_index_0_1 = 4 then
        slice0winner3_best_below_0_choice(0) := slice0winner2_best_last_0(0);
      else
        slice0winner3_best_below_0_choice(0) := slice0winner2_best_below_0(1);
      end if;
      if slice0winner2_best_index_0_3 = 12 then
        slice0winner3_best_below_0_choice(1) := slice0winner2_best_last_0(2);
      else
        slice0winner3_best_below_0_choice(1) := slice0winner2_best_below_0(3);
      end if;
      if slice0winner2_best_index_0_0 = 3 then
        slice0winner3_best_above_0_choice(0) := slice0winner2_best_first_0(1);
      else
        slice0winner3_best_above_0_choice(0) := slice0winner2_best_above_0(0);
      end if;
      if is_set(slice0winner2_best_index_0_2, 3) and ((slice0winner2_best_index_0_2 mod 4) = 3) then
        slice0winner3_best_above_0_choice(1) := slice0winner2_best_first_0(3);
      else
        slice0winner3_best_above_0_choice(1) := slice0winner2_best_above_0(2);
      end if;
      slice0winner3_best_first_0_1 <= slice0winner2_best_first_0(2);
      slice0winner3_best_last_0(0) <= slice0winner2_best_last_0(1);
      slice0winner3_best_last_0(1) <= slice0winner2_best_last_0(3);
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
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
      -- slice0winner4
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
      if slice0winner3_best_index_0_1 = 8 then
        slice0winner4_best_below_0_0_choice := slice0winner3_best_last_0(0);
      else
        slice0winner4_best_below_0_0_choice := slice0winner3_best_below_0(1);
      end if;
      if slice0winner3_best_index_0_0 = 7 then
        slice0winner4_best_above_0_0_choice := slice0winner3_best_first_0_1;
      else
        slice0winner4_best_above_0_0_choice := slice0winner3_best_above_0(0);
      end if;
      slice0winner4_best_last_0_0 <= slice0winner3_best_last_0(1);
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_map_column <= slice0winner3_tag_map_column;
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
      -- slice0
      slice0_best_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner4_best_index_0_0;
      slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
      slice0_best_last_0_0 <= slice0winner4_best_last_0_0;
      slice0_best_tag_valid <= slice0winner4_tag_valid;
      slice0_best_tag_map_column <= slice0winner4_tag_map_column;
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
          if slice0cost_tag_border_column then
            slice1cost_column_0_choice_2(4 * i + j) := 0;
          else
            slice1cost_column_0_choice_2(4 * i + j) := (slice1cost_change_0(4 * i + j) + slice1cost_column_0_choice(4 *
              i + j)) mod 256;
          end if;
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
      slice1cost_change_column <= slice1cost_read_column;
      for i in 0 to 15 loop
        slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
      end loop;
      slice1cost_ready_words(0) <= slice1cost_read_words(0);
      slice1cost_ready_words(1) <= slice1cost_read_words(1);
      slice1cost_ready_words(2) <= slice1cost_read_words(2);
      slice1cost_ready_words(3) <= slice1cost_read_words(3);
      for i in 0 to 15 loop
        slice1cost_column_0(i) <= slice1cost_column_0_choice_2(i);
      end loop;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        for i in 0 to 3 loop
          slice1cost_write_words(i) <= to_unsigned(slice1cost_column_0_choice_2(4 * i + 3), 8) &
            to_unsigned(slice1cost_column_0_choice_2(4 * i + 2), 8) & to_unsigned(slice1cost_column_0_choice_2(4 * i +
            1), 8) & to_unsigned(slice1cost_column_0_choice_2(4 * i), 8);
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
      slice1window_change_tag_first_cost <= slice0window_change_tag_first_cost;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
      slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
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
          slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 2048;
        end loop;
      end if;
      -- slice1winner1
      for i in 0 to 7 loop
        slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
      end loop;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
      for i in 0 to 7 loop
        slice1winner1_best_first_0(i) <= slice1window_sum_0(2 * i);
      end loop;
      for i in 0 to 7 loop
        slice1winner1_best_last_0(i) <= slice1window_sum_0(2 * i + 1);
      end loop;
      if slice1winner1_best_cost_0_is_less(0) then
        slice1winner1_best_cost_0(0) <= slice1window_sum_0(1);
        slice1winner1_best_below_0(0) <= slice1window_sum_0(0);
        slice1winner1_best_above_0(0) <= 0;
      else
        slice1winner1_best_cost_0(0) <= slice1window_sum_0(0);
        slice1winner1_best_below_0(0) <= 0;
        slice1winner1_best_above_0(0) <= slice1window_sum_0(1);
      end if;
      if slice1winner1_best_cost_0_is_less(1) then
        slice1winner1_best_cost_0(1) <= slice1window_sum_0(3);
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0(1) <= slice1window_sum_0(2);
        slice1winner1_best_above_0(1) <= 0;
      else
        slice1winner1_best_cost_0(1) <= slice1window_sum_0(2);
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0(1) <= 0;
        slice1winner1_best_above_0(1) <= slice1window_sum_0(3);
      end if;
      if slice1winner1_best_cost_0_is_less(2) then
        slice1winner1_best_cost_0(2) <= slice1window_sum_0(5);
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0(2) <= slice1window_sum_0(4);
        slice1winner1_best_above_0(2) <= 0;
      else
        slice1winner1_best_cost_0(2) <= slice1window_sum_0(4);
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0(2) <= 0;
        slice1winner1_best_above_0(2) <= slice1window_sum_0(5);
      end if;
      if slice1winner1_best_cost_0_is_less(3) then
        slice1winner1_best_cost_0(3) <= slice1window_sum_0(7);
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0(3) <= slice1window_sum_0(6);
        slice1winner1_best_above_0(3) <= 0;
      else
        slice1winner1_best_cost_0(3) <= slice1window_sum_0(6);
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0(3) <= 0;
        slice1winner1_best_above_0(3) <= slice1window_sum_0(7);
      end if;
      if slice1winner1_best_cost_0_is_less(4) then
        slice1winner1_best_cost_0(4) <= slice1window_sum_0(9);
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0(4) <= slice1window_sum_0(8);
        slice1winner1_best_above_0(4) <= 0;
      else
        slice1winner1_best_cost_0(4) <= slice1window_sum_0(8);
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0(4) <= 0;
        slice1winner1_best_above_0(4) <= slice1window_sum_0(9);
      end if;
      if slice1winner1_best_cost_0_is_less(5) then
        slice1winner1_best_cost_0(5) <= slice1window_sum_0(11);
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0(5) <= slice1window_sum_0(10);
        slice1winner1_best_above_0(5) <= 0;
      else
        slice1winner1_best_cost_0(5) <= slice1window_sum_0(10);
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0(5) <= 0;
        slice1winner1_best_above_0(5) <= slice1window_sum_0(11);
      end if;
      if slice1winner1_best_cost_0_is_less(6) then
        slice1winner1_best_cost_0(6) <= slice1window_sum_0(13);
        slice1winner1_best_index_0_6 <= 13;
        slice1winner1_best_below_0(6) <= slice1window_sum_0(12);
        slice1winner1_best_above_0(6) <= 0;
      else
        slice1winner1_best_cost_0(6) <= slice1window_sum_0(12);
        slice1winner1_best_index_0_6 <= 12;
        slice1winner1_best_below_0(6) <= 0;
        slice1winner1_best_above_0(6) <= slice1window_sum_0(13);
      end if;
      if slice1winner1_best_cost_0_is_less(7) then
        slice1winner1_best_cost_0(7) <= slice1window_sum_0(15);
        slice1winner1_best_index_0_7 <= 15;
        slice1winner1_best_below_0(7) <= slice1window_sum_0(14);
        slice1winner1_best_above_0(7) <= 0;
      else
        slice1winner1_best_cost_0(7) <= slice1window_sum_0(14);
        slice1winner1_best_index_0_7 <= 14;
        slice1winner1_best_below_0(7) <= 0;
        slice1winner1_best_above_0(7) <= slice1window_sum_0(15);
      end if;
      -- slice1winner2
      for i in 0 to 3 loop
        slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      if slice1winner1_best_index_0_1 = 2 then
        slice1winner2_best_below_0_choice(0) := slice1winner1_best_last_0(0);
      else
        slice1winner2_best_below_0_choice(0) := slice1winner1_best_below_0(1);
      end if;
      if slice1winner1_best_index_0_3 = 6 then
        slice1winner2_best_below_0_choice(1) := slice1winner1_best_last_0(2);
      else
        slice1winner2_best_below_0_choice(1) := slice1winner1_best_below_0(3);
      end if;
      if is_set(slice1winner1_best_index_0_5, 3) and ((slice1winner1_best_index_0_5 mod 4) = 2) then
        slice1winner2_best_below_0_choice(2) := slice1winner1_best_last_0(4);
      else
        slice1winner2_best_below_0_choice(2) := slice1winner1_best_below_0(5);
      end if;
      if slice1winner1_best_index_0_7 = 14 then
        slice1winner2_best_below_0_choice(3) := slice1winner1_best_last_0(6);
      else
        slice1winner2_best_below_0_choice(3) := slice1winner1_best_below_0(7);
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_choice(0) := slice1winner1_best_first_0(1);
      else
        slice1winner2_best_above_0_choice(0) := slice1winner1_best_above_0(0);
      end if;
      for i in 3 to 5 loop
        if other(i) then
          slice1winner2_best_above_0_choice(i - 2) := slice1winner1_best_first_0(2 * i - 3);
        else
          slice1winner2_best_above_0_choice(i - 2) := slice1winner1_best_above_0(2 * i - 4);
        end if;
      end loop;
      slice1winner2_best_first_0(0) <= slice1winner1_best_first_0(0);
      slice1winner2_best_first_0(1) <= slice1winner1_best_first_0(2);
      slice1winner2_best_first_0(2) <= slice1winner1_best_first_0(4);
      slice1winner2_best_first_0(3) <= slice1winner1_best_first_0(6);
      slice1winner2_best_last_0(0) <= slice1winner1_best_last_0(1);
      slice1winner2_best_last_0(1) <= slice1winner1_best_last_0(3);
      slice1winner2_best_last_0(2) <= slice1winner1_best_last_0(5);
      slice1winner2_best_last_0(3) <= slice1winner1_best_last_0(7);
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
      -- slice1winner3
      slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
      slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
      if slice1winner2_best_index_0_1 = 4 then
        slice1winner3_best_below_0_choice(0) := slice1winner2_best_last_0(0);
      else
        slice1winner3_best_below_0_choice(0) := slice1winner2_best_below_0(1);
      end if;
      if slice1winner2_best_index_0_3 = 12 then
        slice1winner3_best_below_0_choice(1) := slice1winner2_best_last_0(2);
      else
        slice1winner3_best_below_0_choice(1) := slice1winner2_best_below_0(3);
      end if;
      if slice1winner2_best_index_0_0 = 3 then
        slice1winner3_best_above_0_choice(0) := slice1winner2_best_first_0(1);
      else
        slice1winner3_best_above_0_choice(0) := slice1winner2_best_above_0(0);
      end if;
      if is_set(slice1winner2_best_index_0_2, 3) and ((slice1winner2_best_index_0_2 mod 4) = 3) then
        slice1winner3_best_above_0_choice(1) := slice1winner2_best_first_0(3);
      else
        slice1winner3_best_above_0_choice(1) := slice1winner2_best_above_0(2);
      end if;
      slice1winner3_best_first_0(0) <= slice1winner2_best_first_0(0);
      slice1winner3_best_first_0(1) <= slice1winner2_best_first_0(2);
      slice1winner3_best_last_0(0) <= slice1winner2_best_last_0(1);
      slice1winner3_best_last_0(1) <= slice1winner2_best_last_0(3);
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
      -- slice1winner4
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
      if slice1winner3_best_index_0_1 = 8 then
        slice1winner4_best_below_0_0_choice := slice1winner3_best_last_0(0);
      else
        slice1winner4_best_below_0_0_choice := slice1winner3_best_below_0(1);
      end if;
      if slice1winner3_best_index_0_0 = 7 then
        slice1winner4_best_above_0_0_choice := slice1winner3_best_first_0(1);
      else
        slice1winner4_best_above_0_0_choice := slice1winner3_best_above_0(0);
      end if;
      slice1winner4_best_first_0_0 <= slice1winner3_best_first_0(0);
      slice1winner4_best_last_0_0 <= slice1winner3_best_last_0(1);
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
      -- slice1
      slice1_best_cost_0_0_is_less := (slice1winner4_best_cost_0_0 - slice0_best_cost_0_0) < 0;
      if slice1winner4_best_index_0_0 = 0 then
        slice1_best_below_0_0_choice := slice0_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice1winner4_best_below_0_0;
      end if;
      if slice0_best_index_0_0 = 15 then
        slice1_best_above_0_0_choice := slice1winner4_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice0_best_above_0_0;
      end if;
      slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice1winner4_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner4_best_index_0_0 + 16;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner4_best_above_0_0;
      else
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
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
          if slice0window_entering_tag_border_column then
            slice2cost_column_0_choice_2(4 * i + j) := 0;
          else
            slice2cost_column_0_choice_2(4 * i + j) := (slice2cost_change_0(4 * i + j) + slice2cost_column_0_choice(4 *
              i + j)) mod 256;
          end if;
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
      slice2cost_change_column <= slice2cost_read_column;
      for i in 0 to 15 loop
        slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
      end loop;
      slice2cost_ready_words(0) <= slice2cost_read_words(0);
      slice2cost_ready_words(1) <= slice2cost_read_words(1);
      slice2cost_ready_words(2) <= slice2cost_read_words(2);
      slice2cost_ready_words(3) <= slice2cost_read_words(3);
      slice2cost_ready_column <= slice2cost_change_column;
      for i in 0 to 15 loop
        slice2cost_column_0(i) <= slice2cost_column_0_choice_2(i);
      end loop;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice2cost_read_column <= 0;
        else
          slice2cost_read_column <= (slice2cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_column <= slice2cost_ready_column;
        for i in 0 to 3 loop
          slice2cost_write_words(i) <= to_unsigned(slice2cost_column_0_choice_2(4 * i + 3), 8) &
            to_unsigned(slice2cost_column_0_choice_2(4 * i + 2), 8) & to_unsigned(slice2cost_column_0_choice_2(4 * i +
            1), 8) & to_unsigned(slice2cost_column_0_choice_2(4 * i), 8);
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
      slice2window_change_tag_first_cost <= slice1window_change_tag_first_cost;
      for i in 0 to 15 loop
        if slice2window_change_tag_first_cost then
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
        slice2window_centre_start_of_frame(0) <= slice1window_centre_start_of_frame_0;
        slice2window_centre_start_of_frame(1) <= slice2window_centre_start_of_frame(0);
        slice2window_centre_start_of_frame(2) <= slice2window_centre_start_of_frame(1);
        slice2window_centre_end_of_line(0) <= slice1window_centre_end_of_line_0;
        slice2window_centre_end_of_line(1) <= slice2window_centre_end_of_line(0);
        slice2window_centre_end_of_line(2) <= slice2window_centre_end_of_line(1);
      end if;
      -- slice2winner1
      for i in 0 to 7 loop
        slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
      end loop;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
      for i in 0 to 7 loop
        slice2winner1_best_first_0(i) <= slice2window_sum_0(2 * i);
      end loop;
      for i in 0 to 6 loop
        slice2winner1_best_last_0(i) <= slice2window_sum_0(2 * i + 1);
      end loop;
      if slice2winner1_best_cost_0_is_less(0) then
        slice2winner1_best_cost_0(0) <= slice2window_sum_0(1);
        slice2winner1_best_below_0(0) <= slice2window_sum_0(0);
        slice2winner1_best_above_0(0) <= 0;
      else
        slice2winner1_best_cost_0(0) <= slice2window_sum_0(0);
        slice2winner1_best_below_0(0) <= 0;
        slice2winner1_best_above_0(0) <= slice2window_sum_0(1);
      end if;
      if slice2winner1_best_cost_0_is_less(1) then
        slice2winner1_best_cost_0(1) <= slice2window_sum_0(3);
        slice2winner1_best_index_0_1 <= 3;
        slice2winner1_best_below_0(1) <= slice2window_sum_0(2);
        slice2winner1_best_above_0(1) <= 0;
      else
        slice2winner1_best_cost_0(1) <= slice2window_sum_0(2);
        slice2winner1_best_index_0_1 <= 2;
        slice2winner1_best_below_0(1) <= 0;
        slice2winner1_best_above_0(1) <= slice2window_sum_0(3);
      end if;
      if slice2winner1_best_cost_0_is_less(2) then
        slice2winner1_best_cost_0(2) <= slice2window_sum_0(5);
        slice2winner1_best_index_0_2 <= 5;
        slice2winner1_best_below_0(2) <= slice2window_sum_0(4);
        slice2winner1_best_above_0(2) <= 0;
      else
        slice2winner1_best_cost_0(2) <= slice2window_sum_0(4);
        slice2winner1_best_index_0_2 <= 4;
        slice2winner1_best_below_0(2) <= 0;
        slice2winner1_best_above_0(2) <= slice2window_sum_0(5);
      end if;
      if slice2winner1_best_cost_0_is_less(3) then
        slice2winner1_best_cost_0(3) <= slice2window_sum_0(7);
        slice2winner1_best_index_0_3 <= 7;
        slice2winner1_best_below_0(3) <= slice2window_sum_0(6);
        slice2winner1_best_above_0(3) <= 0;
      else
        slice2winner1_best_cost_0(3) <= slice2window_sum_0(6);
        slice2winner1_best_index_0_3 <= 6;
        slice2winner1_best_below_0(3) <= 0;
        slice2winner1_best_above_0(3) <= slice2window_sum_0(7);
      end if;
      if slice2winner1_best_cost_0_is_less(4) then
        slice2winner1_best_cost_0(4) <= slice2window_sum_0(9);
        slice2winner1_best_index_0_4 <= 9;
        slice2winner1_best_below_0(4) <= slice2window_sum_0(8);
        slice2winner1_best_above_0(4) <= 0;
      else
        slice2winner1_best_cost_0(4) <= slice2window_sum_0(8);
        slice2winner1_best_index_0_4 <= 8;
        slice2winner1_best_below_0(4) <= 0;
        slice2winner1_best_above_0(4) <= slice2window_sum_0(9);
      end if;
      if slice2winner1_best_cost_0_is_less(5) then
        slice2winner1_best_cost_0(5) <= slice2window_sum_0(11);
        slice2winner1_best_index_0_5 <= 11;
        slice2winner1_best_below_0(5) <= slice2window_sum_0(10);
        slice2winner1_best_above_0(5) <= 0;
      else
        slice2winner1_best_cost_0(5) <= slice2window_sum_0(10);
        slice2winner1_best_index_0_5 <= 10;
        slice2winner1_best_below_0(5) <= 0;
        slice2winner1_best_above_0(5) <= slice2window_sum_0(11);
      end if;
      if slice2winner1_best_cost_0_is_less(6) then
        slice2winner1_best_cost_0(6) <= slice2window_sum_0(13);
        slice2winner1_best_index_0_6 <= 13;
        slice2winner1_best_below_0(6) <= slice2window_sum_0(12);
        slice2winner1_best_above_0(6) <= 0;
      else
        slice2winner1_best_cost_0(6) <= slice2window_sum_0(12);
        slice2winner1_best_index_0_6 <= 12;
        slice2winner1_best_below_0(6) <= 0;
        slice2winner1_best_above_0(6) <= slice2window_sum_0(13);
      end if;
      if slice2winner1_best_cost_0_is_less(7) then
        slice2winner1_best_cost_0(7) <= slice2window_sum_0(15);
        slice2winner1_best_index_0_7 <= 15;
        slice2winner1_best_below_0(7) <= slice2window_sum_0(14);
        slice2winner1_best_above_0(7) <= 0;
      else
        slice2winner1_best_cost_0(7) <= slice2window_sum_0(14);
        slice2winner1_best_index_0_7 <= 14;
        slice2winner1_best_below_0(7) <= 0;
        slice2winner1_best_above_0(7) <= slice2window_sum_0(15);
      end if;
      -- slice2winner2
      for i in 0 to 3 loop
        slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      if slice2winner1_best_index_0_1 = 2 then
        slice2winner2_best_below_0_choice(0) := slice2winner1_best_last_0(0);
      else
        slice2winner2_best_below_0_choice(0) := slice2winner1_best_below_0(1);
      end if;
      if slice2winner1_best_index_0_3 = 6 then
        slice2winner2_best_below_0_choice(1) := slice2winner1_best_last_0(2);
      else
        slice2winner2_best_below_0_choice(1) := slice2winner1_best_below_0(3);
      end if;
      if is_set(slice2winner1_best_index_0_5, 3) and ((slice2winner1_best_index_0_5 mod 4) = 2) then
        slice2winner2_best_below_0_choice(2) := slice2winner1_best_last_0(4);
      else
        slice2winner2_best_below_0_choice(2) := slice2winner1_best_below_0(5);
      end if;
      if slice2winner1_best_index_0_7 = 14 then
        slice2winner2_best_below_0_choice(3) := slice2winner1_best_last_0(6);
      else
        slice2winner2_best_below_0_choice(3) := slice2winner1_best_below_0(7);
      end if;
      if slice2winner1_best_index_0_0 then
        slice2winner2_best_above_0_choice(0) := slice2winner1_best_first_0(1);
      else
        slice2winner2_best_above_0_choice(0) := slice2winner1_best_above_0(0);
      end if;
      for i in 0 to 2 loop
        if other(i) then
          slice2winner2_best_above_0_choice(i + 1) := slice2winner1_best_first_0(2 * i + 3);
        else
          slice2winner2_best_above_0_choice(i + 1) := slice2winner1_best_above_0(2 * i + 2);
        end if;
      end loop;
      slice2winner2_best_first_0(0) <= slice2winner1_best_first_0(0);
      slice2winner2_best_first_0(1) <= slice2winner1_best_first_0(2);
      slice2winner2_best_first_0(2) <= slice2winner1_best_first_0(4);
      slice2winner2_best_first_0(3) <= slice2winner1_best_first_0(6);
      slice2winner2_best_last_0(0) <= slice2winner1_best_last_0(1);
      slice2winner2_best_last_0(1) <= slice2winner1_best_last_0(3);
      slice2winner2_best_last_0(2) <= slice2winner1_best_last_0(5);
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
      -- slice2winner3
      slice2winner3_best_cost_0_is_less(0) := (slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) < 0;
      slice2winner3_best_cost_0_is_less(1) := (slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) < 0;
      if slice2winner2_best_index_0_1 = 4 then
        slice2winner3_best_below_0_choice(0) := slice2winner2_best_last_0(0);
      else
        slice2winner3_best_below_0_choice(0) := slice2winner2_best_below_0(1);
      end if;
      if slice2winner2_best_index_0_3 = 12 then
        slice2winner3_best_below_0_choice(1) := slice2winner2_best_last_0(2);
      else
        slice2winner3_best_below_0_choice(1) := slice2winner2_best_below_0(3);
      end if;
      if slice2winner2_best_index_0_0 = 3 then
        slice2winner3_best_above_0_choice(0) := slice2winner2_best_first_0(1);
      else
        slice2winner3_best_above_0_choice(0) := slice2winner2_best_above_0(0);
      end if;
      if is_set(slice2winner2_best_index_0_2, 3) and ((slice2winner2_best_index_0_2 mod 4) = 3) then
        slice2winner3_best_above_0_choice(1) := slice2winner2_best_first_0(3);
      else
        slice2winner3_best_above_0_choice(1) := slice2winner2_best_above_0(2);
      end if;
      slice2winner3_best_first_0(0) <= slice2winner2_best_first_0(0);
      slice2winner3_best_first_0(1) <= slice2winner2_best_first_0(2);
      slice2winner3_best_last_0_0 <= slice2winner2_best_last_0(1);
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
      -- slice2winner4
      slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
      if slice2winner3_best_index_0_1 = 8 then
        slice2winner4_best_below_0_0_choice := slice2winner3_best_last_0_0;
      else
        slice2winner4_best_below_0_0_choice := slice2winner3_best_below_0(1);
      end if;
      if slice2winner3_best_index_0_0 = 7 then
        slice2winner4_best_above_0_0_choice := slice2winner3_best_first_0(1);
      else
        slice2winner4_best_above_0_0_choice := slice2winner3_best_above_0(0);
      end if;
      slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
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
      -- slice2
      slice2_best_cost_0_0_is_less := (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0;
      if slice2winner4_best_index_0_0 = 0 then
        slice2_best_below_0_0_choice := slice1_best_last_0_0;
      else
        slice2_best_below_0_0_choice := slice2winner4_best_below_0_0;
      end if;
      if slice1_best_index_0_0 = 31 then
        slice2_best_above_0_0_choice := slice2winner4_best_first_0_0;
      else
        slice2_best_above_0_0_choice := slice1_best_above_0_0;
      end if;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
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
      -- refinement
      refinement_tag_11_row_start_differs := map_counter_group /= 376;
      refinement_tag_11_row_start_is_equal := map_counter_column = 401;
      if refinement_tag_11_row_start_is_equal then
        refinement_tag_11_row_start_choice := refinement_tag_11_row_start and (map_counter_group /= 375);
      else
        refinement_tag_11_row_start_choice := refinement_tag_11_row_start;
      end if;
      if refinement_tag_11_row_start_differs then
        refinement_tag_11_row_start_choices(2) := refinement_tag_11_row_start_choice;
      else
        refinement_tag_11_row_start_choices(2) := refinement_tag_11_row_start;
      end if;
      refinement_tag_11_row_start_is_equal_2 := map_counter_group = 374;
      refinement_tag_11_row_start_all := refinement_tag_11_row_start_is_equal_2 and
        refinement_tag_11_row_start_is_equal;
      if refinement_tag_11_row_start_choices(2) then
        refinement_tag_11_row_start_choices(3) := (not refinement_tag_start_of_frame(11)) or
          refinement_tag_11_row_start_all;
      else
        refinement_tag_11_row_start_choices(3) := refinement_tag_start_of_frame(11) and
          refinement_tag_11_row_start_is_equal_2 and refinement_tag_11_row_start_is_equal;
      end if;
      refinement_tag_11_row_start_all_2 := refinement_tag_valid(11) and refinement_tag_map_column(11);
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
      refinement_passed_0(0) <= true;
      refinement_passed_0(1) <= refinement_passed_0(0);
      refinement_passed_0(2) <= refinement_passed_0(1);
      refinement_passed_0(3) <= refinement_passed_0(2);
      refinement_passed_0s(5) <= transform_filtering_column_inside_4(1);
      refinement_passed_0s(6) <= refinement_passed_0s(5);
      refinement_passed_0s(7) <= refinement_passed_0s(6);
      refinement_passed_0s(8) <= refinement_passed_0s(7);
      refinement_passed_11_0 <= transform_filtering_row_inside_4(1);
      refinement_tag_valid(0) <= slice2_best_tag_valid;
      refinement_tag_map_column(0) <= slice2_best_tag_map_column;
      refinement_tag_start_of_frame(0) <= slice2_best_tag_start_of_frame;
      refinement_tag_end_of_line(0) <= slice2_best_tag_end_of_line;
      for i in 1 to 11 loop
        refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
        refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
        refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
        refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
      end loop;
      refinement_cost_0 <= slice2_best_cost_0_0;
      refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
      refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0(0) <= magnitude(refinement_difference_0);
      refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
      for i in 1 to 7 loop
        refinement_divisor_0(i) <= refinement_divisor_0(i - 1);
      end loop;
      refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
        ((other_12 / 2) * 2);
      refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
      for i in 1 to 8 loop
        refinement_negative_0(i) <= refinement_negative_0(i - 1);
      end loop;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      if refinement_tag_11_row_start_choices(3) then
        refinement_tag_11_row_start <= refinement_tag_11_row_start or refinement_tag_11_row_start_all_2;
      else
        refinement_tag_11_row_start <= refinement_tag_11_row_start and ((not refinement_tag_valid(11)) or (not
          refinement_tag_map_column(11)));
      end if;
      if slice2_best_index_0_0 = 0 then
        refinement_below_0 <= slice2_best_above_0_0;
      else
        refinement_below_0 <= slice2_best_below_0_0;
      end if;
      if slice2_best_index_0_0 = 47 then
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
      -- map
      if refinement_tag_11_row_start_all_2 then
        if refinement_tag_start_of_frame(11) or refinement_tag_11_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 512;
        end if;
      end if;
      if refinement_tag_11_row_start_all then
        map_counter_group_choice := 375;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 375;
      if refinement_tag_11_row_start and map_counter_group_is_equal then
        map_counter_group_choices(2) := 1;
      else
        map_counter_group_choices(2) := (map_counter_group + 1) mod 512;
      end if;
      if refinement_tag_11_row_start_differs and refinement_tag_11_row_start_is_equal and refinement_tag_valid(11) and
        refinement_tag_map_column(11) then
        map_counter_group_choices(3) := map_counter_group_choices(2);
      else
        map_counter_group_choices(3) := map_counter_group;
      end if;
      if refinement_tag_valid(11) then
        map_line_ended_choice := refinement_tag_map_column(11);
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := other_9(16) = '1';
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_10 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c_choice := map_column_1 / 2;
      else
        map_of_column_0_c_choice := map_column_2 / 2;
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
      map_window_complete_is_equal := map_sorted_column = 0;
      if map_window_complete_is_equal then
        map_window_complete_choice := map_sorted_behind;
      else
        map_window_complete_choice := map_sorted_arrives or map_sorted_behind;
      end if;
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
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice := map_of_middle_0_c;
      else
        map_median_middle_0_choice := map_of_middle_0_a;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choices(2) := map_of_middle_0_b;
      else
        map_median_middle_0_choices(2) := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choices(3) := map_of_middle_0_c;
      else
        map_median_middle_0_choices(3) := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choices(4) := map_of_middle_0_a;
      else
        map_median_middle_0_choices(4) := map_median_middle_0_choices(3);
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
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice := map_of_all_0_c;
      else
        map_out_disparity_0_choice := map_of_all_0_a;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(2) := map_of_all_0_b;
      else
        map_out_disparity_0_choices(2) := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(3) := map_of_all_0_c;
      else
        map_out_disparity_0_choices(3) := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choices(4) := map_of_all_0_a;
      else
        map_out_disparity_0_choices(4) := map_out_disparity_0_choices(3);
      end if;
      map_counter_next_frame <= other_9(40) = '1';
      map_newest_0 <= (((((((refinement_disparity_0(11) + (refinement_fraction_0 / 16)) * 2) + ((refinement_fraction_0
        mod 16) / 8) + 8191) mod 4096) * 8) + (refinement_fraction_0 mod 8)) * 2) + as_number(refinement_passed_11_0);
      map_arrives <= refinement_tag_11_row_start_all_2;
      map_behind <= map_line_ended and refinement_tag_valid(11);
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_9(8 downto 0));
      map_column_1 <= map_rows_ready_words_0 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= other_9(24) = '1';
      map_at_top <= other_9(32) = '1';
      map_at_output <= other_9(48) = '1';
      map_of_column_0_a <= map_of_column_0_a_choice;
      map_of_column_0_b <= map_column_1 / 2;
      map_of_column_0_c <= map_of_column_0_c_choice;
      map_of_column_0_b_below_a <= ((map_column_1 / 2) - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_a <= (map_of_column_0_c_choice - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_b <= (map_of_column_0_c_choice - (map_column_1 / 2)) < 0;
      map_column_passed_0(0) <= is_set(map_column_1, 0);
      map_column_passed_0(1) <= map_column_passed_0(0);
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
      map_window_complete <= map_sorted_output and map_window_complete_choice;
      map_window_first <= map_sorted_top and (map_sorted_column = 1) and map_sorted_arrives;
      map_window_last <= map_sorted_behind;
      map_of_low_0_a <= map_low_0(0);
      map_of_low_0_b <= map_low_0(1);
      map_of_low_0_c <= map_low_0(2);
      map_of_low_0_b_below_a <= (map_low_0(1) - map_low_0(0)) < 0;
      map_of_low_0_c_below_a <= (map_low_0(2) - map_low_0(0)) < 0;
      map_of_low_0_c_below_b <= (map_low_0(2) - map_low_0(1)) < 0;
      map_of_middle_0_a <= map_middle_0(0);
      map_of_middle_0_b <= map_middle_0(1);
      map_of_middle_0_c <= map_middle_0(2);
      map_of_middle_0_b_below_a <= (map_middle_0(1) - map_middle_0(0)) < 0;
      map_of_middle_0_c_below_a <= (map_middle_0(2) - map_middle_0(0)) < 0;
      map_of_middle_0_c_below_b <= (map_middle_0(2) - map_middle_0(1)) < 0;
      map_of_high_0_a <= map_high_0(0);
      map_of_high_0_b <= map_high_0(1);
      map_of_high_0_c <= map_high_0(2);
      map_of_high_0_b_below_a <= (map_high_0(1) - map_high_0(0)) < 0;
      map_of_high_0_c_below_a <= (map_high_0(2) - map_high_0(0)) < 0;
      map_of_high_0_c_below_b <= (map_high_0(2) - map_high_0(1)) < 0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_of_all_0_b_below_a <= (map_median_middle_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_a <= (map_smallest_high_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_b <= (map_smallest_high_0 - map_median_middle_0) < 0;
      map_waiting_complete(0) <= map_window_complete;
      map_waiting_first(0) <= map_window_first;
      map_waiting_last(0) <= map_window_last;
      map_waiting_complete(1) <= map_waiting_complete(0);
      map_waiting_first(1) <= map_waiting_first(0);
      map_waiting_last(1) <= map_waiting_last(0);
      map_waiting_complete(2) <= map_waiting_complete(1);
      map_waiting_first(2) <= map_waiting_first(1);
      map_waiting_last(2) <= map_waiting_last(1);
      map_waiting_passed_0(0) <= map_passed_0(1);
      map_waiting_passed_0(1) <= map_waiting_passed_0(0);
      map_waiting_passed_0(2) <= map_waiting_passed_0(1);
      map_out_passed_0 <= map_waiting_passed_0(2);
      map_out_valid <= map_waiting_complete(2);
      map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
      map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
      if refinement_tag_start_of_frame(11) and refinement_tag_valid(11) and refinement_tag_map_column(11) then
        map_counter_group <= map_counter_group_choice;
      else
        map_counter_group <= map_counter_group_choices(3);
      end if;
      if refinement_tag_end_of_line(11) then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not refinement_tag_valid(11));
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
      if map_passed_0(0) then
        map_passed_0(1) <= map_passed_0(1) or map_sorted_arrives or map_sorted_behind;
      else
        map_passed_0(1) <= map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind);
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choices(2);
      else
        map_median_middle_0 <= map_median_middle_0_choices(4);
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choices(2);
      else
        map_out_disparity_0 <= map_out_disparity_0_choices(4);
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= to_integer(other_9(8 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0(0);
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_0_all(1) := map_window_complete_is_equal and map_sorted_arrives;
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0(0);
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0(0);
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      map_low_0_all(0) := (not map_sorted_arrives) and (not map_sorted_behind);
      if not map_low_0_all(0) then
        map_low_0(0) <= map_low_0_0_choice;
        map_low_0(2) <= map_low_0(1);
        map_middle_0(0) <= map_middle_0_0_choice;
        map_middle_0(2) <= map_middle_0(1);
        map_high_0(0) <= map_high_0_0_choice;
        map_high_0(2) <= map_high_0(1);
        if map_low_0_all(1) then
          map_low_0(1) <= map_low_0_0_choice;
          map_middle_0(1) <= map_middle_0_0_choice;
          map_high_0(1) <= map_high_0_0_choice;
        else
          map_low_0(1) <= map_low_0(0);
          map_middle_0(1) <= map_middle_0(0);
          map_high_0(1) <= map_high_0(0);
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0(0) <= map_column_passed_0(1);
      end if;
      -- other
      other(0) <= slice2winner1_best_cost_0_is_less(2);
      other(1) <= slice2winner1_best_cost_0_is_less(4);
      other(2) <= slice2winner1_best_cost_0_is_less(6);
      other(3) <= slice1winner1_best_cost_0_is_less(2);
      other(4) <= slice1winner1_best_cost_0_is_less(4);
      other(5) <= slice1winner1_best_cost_0_is_less(6);
      other(6) <= slice0winner1_best_cost_0_is_less(2);
      other(7) <= slice0winner1_best_cost_0_is_less(4);
      other(8) <= slice0winner1_best_cost_0_is_less(6);
      other_9 <= other_11;
      other_10 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
      other_11 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 376))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_12 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_13 / 4) * 4);
      other_13 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_14 / 8) * 8);
      other_14 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_15 / 16) * 16);
      other_15 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_16 / 32) * 32);
      other_16 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_17 / 64) * 64);
      other_17 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_18 / 128) * 128);
      other_18 <= (refinement_remainder_1_0_difference / 4096) * 128;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 377;
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
        transform_filtering_start_of_frame(0) <= false;
        transform_filtering_valid(0) <= false;
        transform_filtering_start_of_frame(1) <= false;
        transform_filtering_valid(1) <= false;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 379;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_map_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_map_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_row_start <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_map_column <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner4_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1window_centre_map_column_0 <= false;
        slice1window_centre_start_of_frame_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2cost_read_column <= 0;
        slice2cost_change_column <= 0;
        slice2cost_ready_column <= 0;
        slice2cost_write_column <= 0;
        slice2window_ring_read_address <= 1;
        slice2window_ring_write_address <= 0;
        slice2window_centre_map_column(0) <= false;
        slice2window_centre_map_column(1) <= false;
        slice2window_centre_map_column(2) <= false;
        slice2window_centre_start_of_frame(0) <= false;
        slice2window_centre_start_of_frame(1) <= false;
        slice2window_centre_start_of_frame(2) <= false;
        slice2window_centre_end_of_line(0) <= false;
        slice2window_centre_end_of_line(1) <= false;
        slice2window_centre_end_of_line(2) <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_map_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        for i in 0 to 10 loop
          refinement_tag_valid(i) <= false;
          refinement_tag_map_column(i) <= false;
          refinement_tag_start_of_frame(i) <= false;
          refinement_tag_end_of_line(i) <= false;
        end loop;
        refinement_tag_valid(11) <= false;
        refinement_tag_11_row_start <= false;
        refinement_tag_map_column(11) <= false;
        refinement_tag_start_of_frame(11) <= false;
        refinement_tag_end_of_line(11) <= false;
        map_counter_column <= 0;
        map_counter_group <= 376;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
        map_at_column <= 0;
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
        for i in 0 to 2 loop
          map_waiting_complete(i) <= false;
          map_waiting_first(i) <= false;
          map_waiting_last(i) <= false;
        end loop;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_9 <= to_unsigned(0, 49);
        other_11 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
