-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration miyajima_640: 640x480, 200 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 200, window_px 7, aggregation recursive.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config miyajima_640
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_miyajima_640 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 200;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 440;
    latency_clocks : positive := 26;
    flush_groups : positive := 1922;
    gap_groups : positive := 1920
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(7 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 640 report "stereo_core_miyajima_640: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_miyajima_640: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 200 report "stereo_core_miyajima_640: disparities is " & integer'image(disparities) & " but this core has 200" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_miyajima_640: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_miyajima_640: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 440 report "stereo_core_miyajima_640: output_width_px is " & integer'image(output_width_px) & " but this core has 440" severity failure;
  assert latency_clocks = 26 report "stereo_core_miyajima_640: latency_clocks is " & integer'image(latency_clocks) & " but this core has 26" severity failure;
  assert flush_groups = 1922 report "stereo_core_miyajima_640: flush_groups is " & integer'image(flush_groups) & " but this core has 1922" severity failure;
  assert gap_groups = 1920 report "stereo_core_miyajima_640: gap_groups is " & integer'image(gap_groups) & " but this core has 1920" severity failure;
end entity;

architecture rtl of stereo_core_miyajima_640 is
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

  type boolean_1d is array (natural range <>) of boolean;
  type integer_minus_2047_to_2047_1d is array (natural range <>) of integer range -2047 to 2047;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_4194303_1d is array (natural range <>) of natural range 0 to 4194303;
  type unsigned_22_1d is array (natural range <>) of unsigned(21 downto 0);
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address, delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag_valid, delay_tag_row_start, delay_tag_first_group, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_reference_rows_read_words_0 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search : natural_255_1d(0 to 1);
  signal rows_reference : natural_255_1d(0 to 1);
  signal rows_search_rows_ready_words_1, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag_valid, rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_border_column : boolean;
  signal rows_read_tag_first_cost, rows_read_tag_leaves_window, rows_read_tag_output_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_leaves_window : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_border_column : boolean;
  signal rows_tag_first_cost, rows_tag_leaves_window, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice0shift_reference : natural_255_1d(0 to 1);
  signal slice0shift_search_out : natural_255_1d(0 to 1);
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice0cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
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
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_row_start : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 1023;
  signal slice0cost_write_column : natural range 0 to 1023;
  signal slice0cost_read_words : unsigned_22_1d(0 to 11);
  signal slice0cost_read_words_12 : unsigned(10 downto 0);
  signal slice0cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice0cost_write_words : natural_4194303_1d(0 to 11);
  signal slice0cost_ready_words_12 : natural range 0 to 2047;
  signal slice0cost_column_0 : natural_2047_1d(0 to 24);
  signal slice0cost_write_words_12 : natural range 0 to 2047;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving : unsigned_22_1d(0 to 11);
  signal slice0window_leaving_12 : unsigned(10 downto 0);
  signal slice0window_entering_0 : natural_2047_1d(0 to 24);
  signal slice0window_entering_tag_valid, slice0window_entering_tag_row_start : boolean;
  signal slice0window_entering_tag_first_group, slice0window_entering_tag_border_column : boolean;
  signal slice0window_entering_tag_first_cost, slice0window_entering_tag_leaves_window : boolean;
  signal slice0window_entering_tag_output_column, slice0window_entering_tag_start_of_frame : boolean;
  signal slice0window_entering_tag_end_of_line, slice0window_change_tag_valid : boolean;
  signal slice0window_change_tag_row_start, slice0window_change_tag_first_group : boolean;
  signal slice0window_change_tag_border_column, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column : boolean_1d(0 to 1);
  signal slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 2);
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_start_of_frame : boolean;
  signal slice0window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice0window_sum_0 : natural_16383_1d(0 to 24);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  signal slice0winner1_best_index_0_8 : natural range 0 to 17;
  signal slice0winner1_best_index_0_9 : natural range 0 to 19;
  signal slice0winner1_best_index_0_10 : natural range 0 to 21;
  signal slice0winner1_best_index_0_11 : natural range 0 to 23;
  signal slice0winner1_best_index_0_12 : natural range 0 to 24;
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_best_index_0_4 : natural range 0 to 19;
  signal slice0winner2_best_index_0_5 : natural range 0 to 23;
  signal slice0winner2_best_index_0_6 : natural range 0 to 24;
  signal slice0winner2_tag_valid, slice0winner2_tag_start_of_frame : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_index_0_2 : natural range 0 to 23;
  signal slice0winner3_best_index_0_3 : natural range 0 to 24;
  signal slice0winner3_tag_valid, slice0winner3_tag_start_of_frame : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_index_0_1 : natural range 0 to 24;
  signal slice0winner4_tag_valid, slice0winner4_tag_start_of_frame : boolean;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag_valid, slice0winner5_tag_start_of_frame : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 16383;
  signal slice0_best_index_0_0 : natural range 0 to 199;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice1shift_reference : natural_255_1d(0 to 1);
  signal slice1shift_search_out : natural_255_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice1cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice1cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 1023;
  signal slice1cost_write_column : natural range 0 to 1023;
  signal slice1cost_read_words : unsigned_22_1d(0 to 11);
  signal slice1cost_read_words_12 : unsigned(10 downto 0);
  signal slice1cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice1cost_write_words : natural_4194303_1d(0 to 11);
  signal slice1cost_ready_words_12 : natural range 0 to 2047;
  signal slice1cost_column_0 : natural_2047_1d(0 to 24);
  signal slice1cost_write_words_12 : natural range 0 to 2047;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving : unsigned_22_1d(0 to 11);
  signal slice1window_leaving_12 : unsigned(10 downto 0);
  signal slice1window_entering_0 : natural_2047_1d(0 to 24);
  signal slice1window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice1window_change_tag_row_start, slice1window_change_tag_first_group : boolean;
  signal slice1window_change_tag_border_column, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_centre_output_column_1, slice1window_centre_first_column_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_16383_1d(0 to 24);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  signal slice1winner1_best_index_0_8 : natural range 0 to 17;
  signal slice1winner1_best_index_0_9 : natural range 0 to 19;
  signal slice1winner1_best_index_0_10 : natural range 0 to 21;
  signal slice1winner1_best_index_0_11 : natural range 0 to 23;
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  signal slice1winner2_best_index_0_4 : natural range 0 to 19;
  signal slice1winner2_best_index_0_5 : natural range 0 to 23;
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  signal slice1winner3_best_index_0_2 : natural range 0 to 23;
  -- slice1winner4
  signal slice1winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_index_0_1 : natural range 0 to 24;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner5_best_index_0_0 : natural range 0 to 24;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 199;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice2shift_reference : natural_255_1d(0 to 1);
  signal slice2shift_search_out : natural_255_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice2cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice2cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 1023;
  signal slice2cost_write_column : natural range 0 to 1023;
  signal slice2cost_read_words : unsigned_22_1d(0 to 11);
  signal slice2cost_read_words_12 : unsigned(10 downto 0);
  signal slice2cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice2cost_write_words : natural_4194303_1d(0 to 11);
  signal slice2cost_ready_words_12 : natural range 0 to 2047;
  signal slice2cost_column_0 : natural_2047_1d(0 to 24);
  signal slice2cost_write_words_12 : natural range 0 to 2047;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 7;
  signal slice2window_leaving : unsigned_22_1d(0 to 11);
  signal slice2window_leaving_12 : unsigned(10 downto 0);
  signal slice2window_entering_0 : natural_2047_1d(0 to 24);
  signal slice2window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice2window_change_tag_first_group, slice2window_change_tag_border_column : boolean;
  signal slice2window_change_tag_leaves_window, slice2window_centre_output_column_1 : boolean;
  signal slice2window_centre_first_column_0, slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_16383_1d(0 to 24);
  -- slice2winner1
  signal slice2winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  signal slice2winner1_best_index_0_8 : natural range 0 to 17;
  signal slice2winner1_best_index_0_9 : natural range 0 to 19;
  signal slice2winner1_best_index_0_10 : natural range 0 to 21;
  signal slice2winner1_best_index_0_11 : natural range 0 to 23;
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  signal slice2winner2_best_index_0_4 : natural range 0 to 19;
  signal slice2winner2_best_index_0_5 : natural range 0 to 23;
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  signal slice2winner3_best_index_0_2 : natural range 0 to 23;
  -- slice2winner4
  signal slice2winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_index_0_1 : natural range 0 to 24;
  -- slice2winner5
  signal slice2winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice2winner5_best_index_0_0 : natural range 0 to 24;
  -- slice2
  signal slice2_best_cost_0_0 : natural range 0 to 16383;
  signal slice2_best_index_0_0 : natural range 0 to 199;
  signal slice2_best_tag_valid, slice2_best_tag_output_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- slice3shift
  signal slice3shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice3shift_reference : natural_255_1d(0 to 1);
  signal slice3shift_search_out : natural_255_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice3cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice3cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column : natural range 0 to 1023;
  signal slice3cost_write_column : natural range 0 to 1023;
  signal slice3cost_read_words : unsigned_22_1d(0 to 11);
  signal slice3cost_read_words_12 : unsigned(10 downto 0);
  signal slice3cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice3cost_write_words : natural_4194303_1d(0 to 11);
  signal slice3cost_ready_words_12 : natural range 0 to 2047;
  signal slice3cost_column_0 : natural_2047_1d(0 to 24);
  signal slice3cost_write_words_12 : natural range 0 to 2047;
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 7;
  signal slice3window_leaving : unsigned_22_1d(0 to 11);
  signal slice3window_leaving_12 : unsigned(10 downto 0);
  signal slice3window_entering_0 : natural_2047_1d(0 to 24);
  signal slice3window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice3window_change_tag_first_group, slice3window_change_tag_border_column : boolean;
  signal slice3window_change_tag_leaves_window, slice3window_centre_output_column_1 : boolean;
  signal slice3window_centre_first_column_0, slice3window_centre_end_of_line_0 : boolean;
  signal slice3window_sum_0 : natural_16383_1d(0 to 24);
  -- slice3winner1
  signal slice3winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0_1 : natural range 0 to 3;
  signal slice3winner1_best_index_0_2 : natural range 0 to 5;
  signal slice3winner1_best_index_0_3 : natural range 0 to 7;
  signal slice3winner1_best_index_0_4 : natural range 0 to 9;
  signal slice3winner1_best_index_0_5 : natural range 0 to 11;
  signal slice3winner1_best_index_0_6 : natural range 0 to 13;
  signal slice3winner1_best_index_0_7 : natural range 0 to 15;
  signal slice3winner1_best_index_0_8 : natural range 0 to 17;
  signal slice3winner1_best_index_0_9 : natural range 0 to 19;
  signal slice3winner1_best_index_0_10 : natural range 0 to 21;
  signal slice3winner1_best_index_0_11 : natural range 0 to 23;
  -- slice3winner2
  signal slice3winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice3winner2_best_index_0_0 : natural range 0 to 3;
  signal slice3winner2_best_index_0_1 : natural range 0 to 7;
  signal slice3winner2_best_index_0_2 : natural range 0 to 11;
  signal slice3winner2_best_index_0_3 : natural range 0 to 15;
  signal slice3winner2_best_index_0_4 : natural range 0 to 19;
  signal slice3winner2_best_index_0_5 : natural range 0 to 23;
  -- slice3winner3
  signal slice3winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice3winner3_best_index_0_0 : natural range 0 to 7;
  signal slice3winner3_best_index_0_1 : natural range 0 to 15;
  signal slice3winner3_best_index_0_2 : natural range 0 to 23;
  -- slice3winner4
  signal slice3winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice3winner4_best_index_0_0 : natural range 0 to 15;
  signal slice3winner4_best_index_0_1 : natural range 0 to 24;
  -- slice3winner5
  signal slice3winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice3winner5_best_index_0_0 : natural range 0 to 24;
  -- slice3
  signal slice3_best_cost_0_0 : natural range 0 to 16383;
  signal slice3_best_index_0_0 : natural range 0 to 199;
  signal slice3_best_tag_valid, slice3_best_tag_output_column, slice3_best_tag_start_of_frame : boolean;
  signal slice3_best_tag_end_of_line : boolean;
  -- slice4shift
  signal slice4shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice4shift_reference : natural_255_1d(0 to 1);
  signal slice4shift_search_out : natural_255_1d(0 to 1);
  -- slice4cost
  signal slice4cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice4cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice4cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice4cost_read_column, slice4cost_change_column, slice4cost_ready_column : natural range 0 to 1023;
  signal slice4cost_write_column : natural range 0 to 1023;
  signal slice4cost_read_words : unsigned_22_1d(0 to 11);
  signal slice4cost_read_words_12 : unsigned(10 downto 0);
  signal slice4cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice4cost_write_words : natural_4194303_1d(0 to 11);
  signal slice4cost_ready_words_12 : natural range 0 to 2047;
  signal slice4cost_column_0 : natural_2047_1d(0 to 24);
  signal slice4cost_write_words_12 : natural range 0 to 2047;
  -- slice4window
  signal slice4window_ring_read_address, slice4window_ring_write_address : natural range 0 to 7;
  signal slice4window_leaving : unsigned_22_1d(0 to 11);
  signal slice4window_leaving_12 : unsigned(10 downto 0);
  signal slice4window_entering_0 : natural_2047_1d(0 to 24);
  signal slice4window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice4window_change_tag_first_group, slice4window_change_tag_border_column : boolean;
  signal slice4window_change_tag_leaves_window, slice4window_centre_output_column_1 : boolean;
  signal slice4window_centre_first_column_0, slice4window_centre_end_of_line_0 : boolean;
  signal slice4window_sum_0 : natural_16383_1d(0 to 24);
  -- slice4winner1
  signal slice4winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice4winner1_best_index_0_0 : boolean;
  signal slice4winner1_best_index_0_1 : natural range 0 to 3;
  signal slice4winner1_best_index_0_2 : natural range 0 to 5;
  signal slice4winner1_best_index_0_3 : natural range 0 to 7;
  signal slice4winner1_best_index_0_4 : natural range 0 to 9;
  signal slice4winner1_best_index_0_5 : natural range 0 to 11;
  signal slice4winner1_best_index_0_6 : natural range 0 to 13;
  signal slice4winner1_best_index_0_7 : natural range 0 to 15;
  signal slice4winner1_best_index_0_8 : natural range 0 to 17;
  signal slice4winner1_best_index_0_9 : natural range 0 to 19;
  signal slice4winner1_best_index_0_10 : natural range 0 to 21;
  signal slice4winner1_best_index_0_11 : natural range 0 to 23;
  -- slice4winner2
  signal slice4winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice4winner2_best_index_0_0 : natural range 0 to 3;
  signal slice4winner2_best_index_0_1 : natural range 0 to 7;
  signal slice4winner2_best_index_0_2 : natural range 0 to 11;
  signal slice4winner2_best_index_0_3 : natural range 0 to 15;
  signal slice4winner2_best_index_0_4 : natural range 0 to 19;
  signal slice4winner2_best_index_0_5 : natural range 0 to 23;
  -- slice4winner3
  signal slice4winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice4winner3_best_index_0_0 : natural range 0 to 7;
  signal slice4winner3_best_index_0_1 : natural range 0 to 15;
  signal slice4winner3_best_index_0_2 : natural range 0 to 23;
  -- slice4winner4
  signal slice4winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice4winner4_best_index_0_0 : natural range 0 to 15;
  signal slice4winner4_best_index_0_1 : natural range 0 to 24;
  -- slice4winner5
  signal slice4winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice4winner5_best_index_0_0 : natural range 0 to 24;
  -- slice4
  signal slice4_best_cost_0_0 : natural range 0 to 16383;
  signal slice4_best_index_0_0 : natural range 0 to 199;
  signal slice4_best_tag_valid, slice4_best_tag_output_column, slice4_best_tag_start_of_frame : boolean;
  signal slice4_best_tag_end_of_line : boolean;
  -- slice5shift
  signal slice5shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice5shift_reference : natural_255_1d(0 to 1);
  signal slice5shift_search_out : natural_255_1d(0 to 1);
  -- slice5cost
  signal slice5cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice5cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice5cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice5cost_read_column, slice5cost_change_column, slice5cost_ready_column : natural range 0 to 1023;
  signal slice5cost_write_column : natural range 0 to 1023;
  signal slice5cost_read_words : unsigned_22_1d(0 to 11);
  signal slice5cost_read_words_12 : unsigned(10 downto 0);
  signal slice5cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice5cost_write_words : natural_4194303_1d(0 to 11);
  signal slice5cost_ready_words_12 : natural range 0 to 2047;
  signal slice5cost_column_0 : natural_2047_1d(0 to 24);
  signal slice5cost_write_words_12 : natural range 0 to 2047;
  -- slice5window
  signal slice5window_ring_read_address, slice5window_ring_write_address : natural range 0 to 7;
  signal slice5window_leaving : unsigned_22_1d(0 to 11);
  signal slice5window_leaving_12 : unsigned(10 downto 0);
  signal slice5window_entering_0 : natural_2047_1d(0 to 24);
  signal slice5window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice5window_change_tag_leaves_window, slice5window_centre_output_column_1 : boolean;
  signal slice5window_centre_first_column_0, slice5window_centre_end_of_line_0 : boolean;
  signal slice5window_sum_0 : natural_16383_1d(0 to 24);
  -- slice5winner1
  signal slice5winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice5winner1_best_index_0_0 : boolean;
  signal slice5winner1_best_index_0_1 : natural range 0 to 3;
  signal slice5winner1_best_index_0_2 : natural range 0 to 5;
  signal slice5winner1_best_index_0_3 : natural range 0 to 7;
  signal slice5winner1_best_index_0_4 : natural range 0 to 9;
  signal slice5winner1_best_index_0_5 : natural range 0 to 11;
  signal slice5winner1_best_index_0_6 : natural range 0 to 13;
  signal slice5winner1_best_index_0_7 : natural range 0 to 15;
  signal slice5winner1_best_index_0_8 : natural range 0 to 17;
  signal slice5winner1_best_index_0_9 : natural range 0 to 19;
  signal slice5winner1_best_index_0_10 : natural range 0 to 21;
  signal slice5winner1_best_index_0_11 : natural range 0 to 23;
  -- slice5winner2
  signal slice5winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice5winner2_best_index_0_0 : natural range 0 to 3;
  signal slice5winner2_best_index_0_1 : natural range 0 to 7;
  signal slice5winner2_best_index_0_2 : natural range 0 to 11;
  signal slice5winner2_best_index_0_3 : natural range 0 to 15;
  signal slice5winner2_best_index_0_4 : natural range 0 to 19;
  signal slice5winner2_best_index_0_5 : natural range 0 to 23;
  -- slice5winner3
  signal slice5winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice5winner3_best_index_0_0 : natural range 0 to 7;
  signal slice5winner3_best_index_0_1 : natural range 0 to 15;
  signal slice5winner3_best_index_0_2 : natural range 0 to 23;
  -- slice5winner4
  signal slice5winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice5winner4_best_index_0_0 : natural range 0 to 15;
  signal slice5winner4_best_index_0_1 : natural range 0 to 24;
  -- slice5winner5
  signal slice5winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice5winner5_best_index_0_0 : natural range 0 to 24;
  -- slice5
  signal slice5_best_cost_0_0 : natural range 0 to 16383;
  signal slice5_best_index_0_0 : natural range 0 to 199;
  signal slice5_best_tag_valid, slice5_best_tag_output_column, slice5_best_tag_start_of_frame : boolean;
  signal slice5_best_tag_end_of_line : boolean;
  -- slice6shift
  signal slice6shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice6shift_reference : natural_255_1d(0 to 1);
  signal slice6shift_search_out : natural_255_1d(0 to 1);
  -- slice6cost
  signal slice6cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice6cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice6cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice6cost_read_column, slice6cost_change_column, slice6cost_ready_column : natural range 0 to 1023;
  signal slice6cost_write_column : natural range 0 to 1023;
  signal slice6cost_read_words : unsigned_22_1d(0 to 11);
  signal slice6cost_read_words_12 : unsigned(10 downto 0);
  signal slice6cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice6cost_write_words : natural_4194303_1d(0 to 11);
  signal slice6cost_ready_words_12 : natural range 0 to 2047;
  signal slice6cost_column_0 : natural_2047_1d(0 to 24);
  signal slice6cost_write_words_12 : natural range 0 to 2047;
  -- slice6window
  signal slice6window_ring_read_address, slice6window_ring_write_address : natural range 0 to 7;
  signal slice6window_leaving : unsigned_22_1d(0 to 11);
  signal slice6window_leaving_12 : unsigned(10 downto 0);
  signal slice6window_entering_0 : natural_2047_1d(0 to 24);
  signal slice6window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice6window_change_tag_leaves_window, slice6window_centre_output_column_1 : boolean;
  signal slice6window_centre_first_column_0, slice6window_centre_end_of_line_0 : boolean;
  signal slice6window_sum_0 : natural_16383_1d(0 to 24);
  -- slice6winner1
  signal slice6winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice6winner1_best_index_0_0 : boolean;
  signal slice6winner1_best_index_0_1 : natural range 0 to 3;
  signal slice6winner1_best_index_0_2 : natural range 0 to 5;
  signal slice6winner1_best_index_0_3 : natural range 0 to 7;
  signal slice6winner1_best_index_0_4 : natural range 0 to 9;
  signal slice6winner1_best_index_0_5 : natural range 0 to 11;
  signal slice6winner1_best_index_0_6 : natural range 0 to 13;
  signal slice6winner1_best_index_0_7 : natural range 0 to 15;
  signal slice6winner1_best_index_0_8 : natural range 0 to 17;
  signal slice6winner1_best_index_0_9 : natural range 0 to 19;
  signal slice6winner1_best_index_0_10 : natural range 0 to 21;
  signal slice6winner1_best_index_0_11 : natural range 0 to 23;
  -- slice6winner2
  signal slice6winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice6winner2_best_index_0_0 : natural range 0 to 3;
  signal slice6winner2_best_index_0_1 : natural range 0 to 7;
  signal slice6winner2_best_index_0_2 : natural range 0 to 11;
  signal slice6winner2_best_index_0_3 : natural range 0 to 15;
  signal slice6winner2_best_index_0_4 : natural range 0 to 19;
  signal slice6winner2_best_index_0_5 : natural range 0 to 23;
  -- slice6winner3
  signal slice6winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice6winner3_best_index_0_0 : natural range 0 to 7;
  signal slice6winner3_best_index_0_1 : natural range 0 to 15;
  signal slice6winner3_best_index_0_2 : natural range 0 to 23;
  -- slice6winner4
  signal slice6winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice6winner4_best_index_0_0 : natural range 0 to 15;
  signal slice6winner4_best_index_0_1 : natural range 0 to 24;
  -- slice6winner5
  signal slice6winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice6winner5_best_index_0_0 : natural range 0 to 24;
  -- slice6
  signal slice6_best_cost_0_0 : natural range 0 to 16383;
  signal slice6_best_index_0_0 : natural range 0 to 199;
  signal slice6_best_tag_valid, slice6_best_tag_output_column, slice6_best_tag_start_of_frame : boolean;
  signal slice6_best_tag_end_of_line : boolean;
  -- slice7shift
  signal slice7shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice7shift_reference : natural_255_1d(0 to 1);
  -- slice7cost
  signal slice7cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice7cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice7cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice7cost_read_column, slice7cost_change_column, slice7cost_ready_column : natural range 0 to 1023;
  signal slice7cost_write_column : natural range 0 to 1023;
  signal slice7cost_read_words : unsigned_22_1d(0 to 11);
  signal slice7cost_read_words_12 : unsigned(10 downto 0);
  signal slice7cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice7cost_write_words : natural_4194303_1d(0 to 11);
  signal slice7cost_ready_words_12 : natural range 0 to 2047;
  signal slice7cost_column_0 : natural_2047_1d(0 to 24);
  signal slice7cost_write_words_12 : natural range 0 to 2047;
  -- slice7window
  signal slice7window_ring_read_address, slice7window_ring_write_address : natural range 0 to 7;
  signal slice7window_leaving : unsigned_22_1d(0 to 11);
  signal slice7window_leaving_12 : unsigned(10 downto 0);
  signal slice7window_entering_0 : natural_2047_1d(0 to 24);
  signal slice7window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice7window_sum_0 : natural_16383_1d(0 to 24);
  signal slice7window_centre_output_column_1 : boolean;
  signal slice7window_centre_end_of_line : boolean_1d(0 to 1);
  -- slice7winner1
  signal slice7winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice7winner1_best_index_0_0 : boolean;
  signal slice7winner1_best_index_0_1 : natural range 0 to 3;
  signal slice7winner1_best_index_0_2 : natural range 0 to 5;
  signal slice7winner1_best_index_0_3 : natural range 0 to 7;
  signal slice7winner1_best_index_0_4 : natural range 0 to 9;
  signal slice7winner1_best_index_0_5 : natural range 0 to 11;
  signal slice7winner1_best_index_0_6 : natural range 0 to 13;
  signal slice7winner1_best_index_0_7 : natural range 0 to 15;
  signal slice7winner1_best_index_0_8 : natural range 0 to 17;
  signal slice7winner1_best_index_0_9 : natural range 0 to 19;
  signal slice7winner1_best_index_0_10 : natural range 0 to 21;
  signal slice7winner1_best_index_0_11 : natural range 0 to 23;
  -- slice7winner2
  signal slice7winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice7winner2_best_index_0_0 : natural range 0 to 3;
  signal slice7winner2_best_index_0_1 : natural range 0 to 7;
  signal slice7winner2_best_index_0_2 : natural range 0 to 11;
  signal slice7winner2_best_index_0_3 : natural range 0 to 15;
  signal slice7winner2_best_index_0_4 : natural range 0 to 19;
  signal slice7winner2_best_index_0_5 : natural range 0 to 23;
  -- slice7winner3
  signal slice7winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice7winner3_best_index_0_0 : natural range 0 to 7;
  signal slice7winner3_best_index_0_1 : natural range 0 to 15;
  signal slice7winner3_best_index_0_2 : natural range 0 to 23;
  -- slice7winner4
  signal slice7winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice7winner4_best_index_0_0 : natural range 0 to 15;
  signal slice7winner4_best_index_0_1 : natural range 0 to 24;
  -- slice7winner5
  signal slice7winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice7winner5_best_index_0_0 : natural range 0 to 24;
  -- slice7
  signal slice7_best_index_0_0 : natural range 0 to 199;
  signal slice7_best_tag_valid, slice7_best_tag_output_column, slice7_best_tag_start_of_frame : boolean;
  signal slice7_best_tag_end_of_line, slice7window_leaving_12_memory_read_enable : boolean;
  signal slice7window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice7window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice7window_leaving_11_memory_read_enable : boolean;
  signal slice7window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice7window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_10_memory_read_enable : boolean;
  signal slice7window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice7window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_9_memory_read_enable : boolean;
  signal slice7window_leaving_9_memory_read_address, slice7window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_8_memory_read_enable : boolean;
  signal slice7window_leaving_8_memory_read_address, slice7window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_7_memory_read_enable : boolean;
  signal slice7window_leaving_7_memory_read_address, slice7window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_6_memory_read_enable : boolean;
  signal slice7window_leaving_6_memory_read_address, slice7window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_5_memory_read_enable : boolean;
  signal slice7window_leaving_5_memory_read_address, slice7window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_4_memory_read_enable : boolean;
  signal slice7window_leaving_4_memory_read_address, slice7window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_3_memory_read_enable : boolean;
  signal slice7window_leaving_3_memory_read_address, slice7window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_2_memory_read_enable : boolean;
  signal slice7window_leaving_2_memory_read_address, slice7window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_1_memory_read_enable : boolean;
  signal slice7window_leaving_1_memory_read_address, slice7window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice7window_leaving_0_memory_read_enable : boolean;
  signal slice7window_leaving_0_memory_read_address, slice7window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice7window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_12_memory_read_enable : boolean;
  signal slice7cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice7cost_read_words_11_memory_read_enable : boolean;
  signal slice7cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_10_memory_read_enable : boolean;
  signal slice7cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_9_memory_read_enable : boolean;
  signal slice7cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_8_memory_read_enable : boolean;
  signal slice7cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_7_memory_read_enable : boolean;
  signal slice7cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_6_memory_read_enable : boolean;
  signal slice7cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_5_memory_read_enable : boolean;
  signal slice7cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_4_memory_read_enable : boolean;
  signal slice7cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_3_memory_read_enable : boolean;
  signal slice7cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_2_memory_read_enable : boolean;
  signal slice7cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_1_memory_read_enable : boolean;
  signal slice7cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice7cost_read_words_0_memory_read_enable : boolean;
  signal slice7cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice7cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice7cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_12_memory_read_enable : boolean;
  signal slice6window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice6window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice6window_leaving_11_memory_read_enable : boolean;
  signal slice6window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice6window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_10_memory_read_enable : boolean;
  signal slice6window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice6window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_9_memory_read_enable : boolean;
  signal slice6window_leaving_9_memory_read_address, slice6window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_8_memory_read_enable : boolean;
  signal slice6window_leaving_8_memory_read_address, slice6window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_7_memory_read_enable : boolean;
  signal slice6window_leaving_7_memory_read_address, slice6window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_6_memory_read_enable : boolean;
  signal slice6window_leaving_6_memory_read_address, slice6window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_5_memory_read_enable : boolean;
  signal slice6window_leaving_5_memory_read_address, slice6window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_4_memory_read_enable : boolean;
  signal slice6window_leaving_4_memory_read_address, slice6window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_3_memory_read_enable : boolean;
  signal slice6window_leaving_3_memory_read_address, slice6window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_2_memory_read_enable : boolean;
  signal slice6window_leaving_2_memory_read_address, slice6window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_1_memory_read_enable : boolean;
  signal slice6window_leaving_1_memory_read_address, slice6window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice6window_leaving_0_memory_read_enable : boolean;
  signal slice6window_leaving_0_memory_read_address, slice6window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice6window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_12_memory_read_enable : boolean;
  signal slice6cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice6cost_read_words_11_memory_read_enable : boolean;
  signal slice6cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_10_memory_read_enable : boolean;
  signal slice6cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_9_memory_read_enable : boolean;
  signal slice6cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_8_memory_read_enable : boolean;
  signal slice6cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_7_memory_read_enable : boolean;
  signal slice6cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_6_memory_read_enable : boolean;
  signal slice6cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_5_memory_read_enable : boolean;
  signal slice6cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_4_memory_read_enable : boolean;
  signal slice6cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_3_memory_read_enable : boolean;
  signal slice6cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_2_memory_read_enable : boolean;
  signal slice6cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_1_memory_read_enable : boolean;
  signal slice6cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice6cost_read_words_0_memory_read_enable : boolean;
  signal slice6cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice6cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice6cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_12_memory_read_enable : boolean;
  signal slice5window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice5window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice5window_leaving_11_memory_read_enable : boolean;
  signal slice5window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice5window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_10_memory_read_enable : boolean;
  signal slice5window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice5window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_9_memory_read_enable : boolean;
  signal slice5window_leaving_9_memory_read_address, slice5window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_8_memory_read_enable : boolean;
  signal slice5window_leaving_8_memory_read_address, slice5window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_7_memory_read_enable : boolean;
  signal slice5window_leaving_7_memory_read_address, slice5window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_6_memory_read_enable : boolean;
  signal slice5window_leaving_6_memory_read_address, slice5window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_5_memory_read_enable : boolean;
  signal slice5window_leaving_5_memory_read_address, slice5window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_4_memory_read_enable : boolean;
  signal slice5window_leaving_4_memory_read_address, slice5window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_3_memory_read_enable : boolean;
  signal slice5window_leaving_3_memory_read_address, slice5window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_2_memory_read_enable : boolean;
  signal slice5window_leaving_2_memory_read_address, slice5window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_1_memory_read_enable : boolean;
  signal slice5window_leaving_1_memory_read_address, slice5window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice5window_leaving_0_memory_read_enable : boolean;
  signal slice5window_leaving_0_memory_read_address, slice5window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice5window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_12_memory_read_enable : boolean;
  signal slice5cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice5cost_read_words_11_memory_read_enable : boolean;
  signal slice5cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_10_memory_read_enable : boolean;
  signal slice5cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_9_memory_read_enable : boolean;
  signal slice5cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_8_memory_read_enable : boolean;
  signal slice5cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_7_memory_read_enable : boolean;
  signal slice5cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_6_memory_read_enable : boolean;
  signal slice5cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_5_memory_read_enable : boolean;
  signal slice5cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_4_memory_read_enable : boolean;
  signal slice5cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_3_memory_read_enable : boolean;
  signal slice5cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_2_memory_read_enable : boolean;
  signal slice5cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_1_memory_read_enable : boolean;
  signal slice5cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice5cost_read_words_0_memory_read_enable : boolean;
  signal slice5cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice5cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice5cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_12_memory_read_enable : boolean;
  signal slice4window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice4window_leaving_11_memory_read_enable : boolean;
  signal slice4window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_10_memory_read_enable : boolean;
  signal slice4window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_9_memory_read_enable : boolean;
  signal slice4window_leaving_9_memory_read_address, slice4window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_8_memory_read_enable : boolean;
  signal slice4window_leaving_8_memory_read_address, slice4window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_7_memory_read_enable : boolean;
  signal slice4window_leaving_7_memory_read_address, slice4window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_6_memory_read_enable : boolean;
  signal slice4window_leaving_6_memory_read_address, slice4window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_5_memory_read_enable : boolean;
  signal slice4window_leaving_5_memory_read_address, slice4window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_4_memory_read_enable : boolean;
  signal slice4window_leaving_4_memory_read_address, slice4window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_3_memory_read_enable : boolean;
  signal slice4window_leaving_3_memory_read_address, slice4window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_2_memory_read_enable : boolean;
  signal slice4window_leaving_2_memory_read_address, slice4window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_1_memory_read_enable : boolean;
  signal slice4window_leaving_1_memory_read_address, slice4window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_0_memory_read_enable : boolean;
  signal slice4window_leaving_0_memory_read_address, slice4window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_12_memory_read_enable : boolean;
  signal slice4cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice4cost_read_words_11_memory_read_enable : boolean;
  signal slice4cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_10_memory_read_enable : boolean;
  signal slice4cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_9_memory_read_enable : boolean;
  signal slice4cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_8_memory_read_enable : boolean;
  signal slice4cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_7_memory_read_enable : boolean;
  signal slice4cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_6_memory_read_enable : boolean;
  signal slice4cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_5_memory_read_enable : boolean;
  signal slice4cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_4_memory_read_enable : boolean;
  signal slice4cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_3_memory_read_enable : boolean;
  signal slice4cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_2_memory_read_enable : boolean;
  signal slice4cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_1_memory_read_enable : boolean;
  signal slice4cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_0_memory_read_enable : boolean;
  signal slice4cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice4cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice4cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_12_memory_read_enable : boolean;
  signal slice3window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice3window_leaving_11_memory_read_enable : boolean;
  signal slice3window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_10_memory_read_enable : boolean;
  signal slice3window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_9_memory_read_enable : boolean;
  signal slice3window_leaving_9_memory_read_address, slice3window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_8_memory_read_enable : boolean;
  signal slice3window_leaving_8_memory_read_address, slice3window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_7_memory_read_enable : boolean;
  signal slice3window_leaving_7_memory_read_address, slice3window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_6_memory_read_enable : boolean;
  signal slice3window_leaving_6_memory_read_address, slice3window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_5_memory_read_enable : boolean;
  signal slice3window_leaving_5_memory_read_address, slice3window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_4_memory_read_enable : boolean;
  signal slice3window_leaving_4_memory_read_address, slice3window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_3_memory_read_enable : boolean;
  signal slice3window_leaving_3_memory_read_address, slice3window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_2_memory_read_enable : boolean;
  signal slice3window_leaving_2_memory_read_address, slice3window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_1_memory_read_enable : boolean;
  signal slice3window_leaving_1_memory_read_address, slice3window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_0_memory_read_enable : boolean;
  signal slice3window_leaving_0_memory_read_address, slice3window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_12_memory_read_enable : boolean;
  signal slice3cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice3cost_read_words_11_memory_read_enable : boolean;
  signal slice3cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_10_memory_read_enable : boolean;
  signal slice3cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_9_memory_read_enable : boolean;
  signal slice3cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_8_memory_read_enable : boolean;
  signal slice3cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_7_memory_read_enable : boolean;
  signal slice3cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_6_memory_read_enable : boolean;
  signal slice3cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_5_memory_read_enable : boolean;
  signal slice3cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_4_memory_read_enable : boolean;
  signal slice3cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_3_memory_read_enable : boolean;
  signal slice3cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_2_memory_read_enable : boolean;
  signal slice3cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_1_memory_read_enable : boolean;
  signal slice3cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_0_memory_read_enable : boolean;
  signal slice3cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice3cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice3cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_12_memory_read_enable : boolean;
  signal slice2window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice2window_leaving_11_memory_read_enable : boolean;
  signal slice2window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_10_memory_read_enable : boolean;
  signal slice2window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_9_memory_read_enable : boolean;
  signal slice2window_leaving_9_memory_read_address, slice2window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_8_memory_read_enable : boolean;
  signal slice2window_leaving_8_memory_read_address, slice2window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_7_memory_read_enable : boolean;
  signal slice2window_leaving_7_memory_read_address, slice2window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_6_memory_read_enable : boolean;
  signal slice2window_leaving_6_memory_read_address, slice2window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_5_memory_read_enable : boolean;
  signal slice2window_leaving_5_memory_read_address, slice2window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_4_memory_read_enable : boolean;
  signal slice2window_leaving_4_memory_read_address, slice2window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address, slice2window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address, slice2window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address, slice2window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address, slice2window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_12_memory_read_enable : boolean;
  signal slice2cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice2cost_read_words_11_memory_read_enable : boolean;
  signal slice2cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_10_memory_read_enable : boolean;
  signal slice2cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_9_memory_read_enable : boolean;
  signal slice2cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_8_memory_read_enable : boolean;
  signal slice2cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_7_memory_read_enable : boolean;
  signal slice2cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_6_memory_read_enable : boolean;
  signal slice2cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_5_memory_read_enable : boolean;
  signal slice2cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_4_memory_read_enable : boolean;
  signal slice2cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_3_memory_read_enable : boolean;
  signal slice2cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_2_memory_read_enable : boolean;
  signal slice2cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_12_memory_read_enable : boolean;
  signal slice1window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice1window_leaving_11_memory_read_enable : boolean;
  signal slice1window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_10_memory_read_enable : boolean;
  signal slice1window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_9_memory_read_enable : boolean;
  signal slice1window_leaving_9_memory_read_address, slice1window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_8_memory_read_enable : boolean;
  signal slice1window_leaving_8_memory_read_address, slice1window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_7_memory_read_enable : boolean;
  signal slice1window_leaving_7_memory_read_address, slice1window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_6_memory_read_enable : boolean;
  signal slice1window_leaving_6_memory_read_address, slice1window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_5_memory_read_enable : boolean;
  signal slice1window_leaving_5_memory_read_address, slice1window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_4_memory_read_enable : boolean;
  signal slice1window_leaving_4_memory_read_address, slice1window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address, slice1window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address, slice1window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address, slice1window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address, slice1window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_12_memory_read_enable : boolean;
  signal slice1cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice1cost_read_words_11_memory_read_enable : boolean;
  signal slice1cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_10_memory_read_enable : boolean;
  signal slice1cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_9_memory_read_enable : boolean;
  signal slice1cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_8_memory_read_enable : boolean;
  signal slice1cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_7_memory_read_enable : boolean;
  signal slice1cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_6_memory_read_enable : boolean;
  signal slice1cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_5_memory_read_enable : boolean;
  signal slice1cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_4_memory_read_enable : boolean;
  signal slice1cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_12_memory_read_enable : boolean;
  signal slice0window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice0window_leaving_11_memory_read_enable : boolean;
  signal slice0window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_10_memory_read_enable : boolean;
  signal slice0window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_9_memory_read_enable : boolean;
  signal slice0window_leaving_9_memory_read_address, slice0window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_8_memory_read_enable : boolean;
  signal slice0window_leaving_8_memory_read_address, slice0window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_7_memory_read_enable : boolean;
  signal slice0window_leaving_7_memory_read_address, slice0window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_6_memory_read_enable : boolean;
  signal slice0window_leaving_6_memory_read_address, slice0window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_5_memory_read_enable : boolean;
  signal slice0window_leaving_5_memory_read_address, slice0window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_4_memory_read_enable : boolean;
  signal slice0window_leaving_4_memory_read_address, slice0window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address, slice0window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address, slice0window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address, slice0window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address, slice0window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_12_memory_read_enable : boolean;
  signal slice0cost_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice0cost_read_words_11_memory_read_enable : boolean;
  signal slice0cost_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_10_memory_read_enable : boolean;
  signal slice0cost_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_9_memory_read_enable : boolean;
  signal slice0cost_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_8_memory_read_enable : boolean;
  signal slice0cost_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_7_memory_read_enable : boolean;
  signal slice0cost_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_6_memory_read_enable : boolean;
  signal slice0cost_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_5_memory_read_enable : boolean;
  signal slice0cost_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_4_memory_read_enable : boolean;
  signal slice0cost_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address, delay_delayed_0_memory_write_address : unsigned(7 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice7_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice7_best_tag_valid and slice7_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice7_best_tag_start_of_frame and slice7_best_tag_valid and slice7_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice7_best_tag_end_of_line and slice7_best_tag_valid and slice7_best_tag_output_column);

  slice7window_leaving_12_memory_read_enable <= true;
  slice7window_leaving_12_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_12_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_12_memory_write_data <= to_unsigned(slice7cost_column_0(24), 11);
  slice7window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_12_memory_read_enable,
      read_address => slice7window_leaving_12_memory_read_address, read_data => slice7window_leaving_12,
      write_address => slice7window_leaving_12_memory_write_address, write_data => slice7window_leaving_12_memory_write_data);

  slice7window_leaving_11_memory_read_enable <= true;
  slice7window_leaving_11_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_11_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_11_memory_write_data <= to_unsigned(slice7cost_column_0(23), 11) & to_unsigned(slice7cost_column_0(22), 11);
  slice7window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_11_memory_read_enable,
      read_address => slice7window_leaving_11_memory_read_address, read_data => slice7window_leaving(11),
      write_address => slice7window_leaving_11_memory_write_address, write_data => slice7window_leaving_11_memory_write_data);

  slice7window_leaving_10_memory_read_enable <= true;
  slice7window_leaving_10_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_10_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_10_memory_write_data <= to_unsigned(slice7cost_column_0(21), 11) & to_unsigned(slice7cost_column_0(20), 11);
  slice7window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_10_memory_read_enable,
      read_address => slice7window_leaving_10_memory_read_address, read_data => slice7window_leaving(10),
      write_address => slice7window_leaving_10_memory_write_address, write_data => slice7window_leaving_10_memory_write_data);

  slice7window_leaving_9_memory_read_enable <= true;
  slice7window_leaving_9_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_9_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_9_memory_write_data <= to_unsigned(slice7cost_column_0(19), 11) & to_unsigned(slice7cost_column_0(18), 11);
  slice7window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_9_memory_read_enable,
      read_address => slice7window_leaving_9_memory_read_address, read_data => slice7window_leaving(9),
      write_address => slice7window_leaving_9_memory_write_address, write_data => slice7window_leaving_9_memory_write_data);

  slice7window_leaving_8_memory_read_enable <= true;
  slice7window_leaving_8_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_8_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_8_memory_write_data <= to_unsigned(slice7cost_column_0(17), 11) & to_unsigned(slice7cost_column_0(16), 11);
  slice7window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_8_memory_read_enable,
      read_address => slice7window_leaving_8_memory_read_address, read_data => slice7window_leaving(8),
      write_address => slice7window_leaving_8_memory_write_address, write_data => slice7window_leaving_8_memory_write_data);

  slice7window_leaving_7_memory_read_enable <= true;
  slice7window_leaving_7_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_7_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_7_memory_write_data <= to_unsigned(slice7cost_column_0(15), 11) & to_unsigned(slice7cost_column_0(14), 11);
  slice7window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_7_memory_read_enable,
      read_address => slice7window_leaving_7_memory_read_address, read_data => slice7window_leaving(7),
      write_address => slice7window_leaving_7_memory_write_address, write_data => slice7window_leaving_7_memory_write_data);

  slice7window_leaving_6_memory_read_enable <= true;
  slice7window_leaving_6_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_6_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_6_memory_write_data <= to_unsigned(slice7cost_column_0(13), 11) & to_unsigned(slice7cost_column_0(12), 11);
  slice7window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_6_memory_read_enable,
      read_address => slice7window_leaving_6_memory_read_address, read_data => slice7window_leaving(6),
      write_address => slice7window_leaving_6_memory_write_address, write_data => slice7window_leaving_6_memory_write_data);

  slice7window_leaving_5_memory_read_enable <= true;
  slice7window_leaving_5_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_5_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_5_memory_write_data <= to_unsigned(slice7cost_column_0(11), 11) & to_unsigned(slice7cost_column_0(10), 11);
  slice7window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_5_memory_read_enable,
      read_address => slice7window_leaving_5_memory_read_address, read_data => slice7window_leaving(5),
      write_address => slice7window_leaving_5_memory_write_address, write_data => slice7window_leaving_5_memory_write_data);

  slice7window_leaving_4_memory_read_enable <= true;
  slice7window_leaving_4_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_4_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_4_memory_write_data <= to_unsigned(slice7cost_column_0(9), 11) & to_unsigned(slice7cost_column_0(8), 11);
  slice7window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_4_memory_read_enable,
      read_address => slice7window_leaving_4_memory_read_address, read_data => slice7window_leaving(4),
      write_address => slice7window_leaving_4_memory_write_address, write_data => slice7window_leaving_4_memory_write_data);

  slice7window_leaving_3_memory_read_enable <= true;
  slice7window_leaving_3_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_3_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_3_memory_write_data <= to_unsigned(slice7cost_column_0(7), 11) & to_unsigned(slice7cost_column_0(6), 11);
  slice7window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_3_memory_read_enable,
      read_address => slice7window_leaving_3_memory_read_address, read_data => slice7window_leaving(3),
      write_address => slice7window_leaving_3_memory_write_address, write_data => slice7window_leaving_3_memory_write_data);

  slice7window_leaving_2_memory_read_enable <= true;
  slice7window_leaving_2_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_2_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_2_memory_write_data <= to_unsigned(slice7cost_column_0(5), 11) & to_unsigned(slice7cost_column_0(4), 11);
  slice7window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_2_memory_read_enable,
      read_address => slice7window_leaving_2_memory_read_address, read_data => slice7window_leaving(2),
      write_address => slice7window_leaving_2_memory_write_address, write_data => slice7window_leaving_2_memory_write_data);

  slice7window_leaving_1_memory_read_enable <= true;
  slice7window_leaving_1_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_1_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_1_memory_write_data <= to_unsigned(slice7cost_column_0(3), 11) & to_unsigned(slice7cost_column_0(2), 11);
  slice7window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_1_memory_read_enable,
      read_address => slice7window_leaving_1_memory_read_address, read_data => slice7window_leaving(1),
      write_address => slice7window_leaving_1_memory_write_address, write_data => slice7window_leaving_1_memory_write_data);

  slice7window_leaving_0_memory_read_enable <= true;
  slice7window_leaving_0_memory_read_address <= to_unsigned(slice7window_ring_read_address, 3);
  slice7window_leaving_0_memory_write_address <= to_unsigned(slice7window_ring_write_address, 3);
  slice7window_leaving_0_memory_write_data <= to_unsigned(slice7cost_column_0(1), 11) & to_unsigned(slice7cost_column_0(0), 11);
  slice7window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice7window_leaving_0_memory_read_enable,
      read_address => slice7window_leaving_0_memory_read_address, read_data => slice7window_leaving(0),
      write_address => slice7window_leaving_0_memory_write_address, write_data => slice7window_leaving_0_memory_write_data);

  slice7cost_read_words_12_memory_read_enable <= true;
  slice7cost_read_words_12_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_12_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_12_memory_write_data <= to_unsigned(slice7cost_write_words_12, 11);
  slice7cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_12_memory_read_enable,
      read_address => slice7cost_read_words_12_memory_read_address, read_data => slice7cost_read_words_12,
      write_address => slice7cost_read_words_12_memory_write_address, write_data => slice7cost_read_words_12_memory_write_data);

  slice7cost_read_words_11_memory_read_enable <= true;
  slice7cost_read_words_11_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_11_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_11_memory_write_data <= to_unsigned(slice7cost_write_words(11), 22);
  slice7cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_11_memory_read_enable,
      read_address => slice7cost_read_words_11_memory_read_address, read_data => slice7cost_read_words(11),
      write_address => slice7cost_read_words_11_memory_write_address, write_data => slice7cost_read_words_11_memory_write_data);

  slice7cost_read_words_10_memory_read_enable <= true;
  slice7cost_read_words_10_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_10_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_10_memory_write_data <= to_unsigned(slice7cost_write_words(10), 22);
  slice7cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_10_memory_read_enable,
      read_address => slice7cost_read_words_10_memory_read_address, read_data => slice7cost_read_words(10),
      write_address => slice7cost_read_words_10_memory_write_address, write_data => slice7cost_read_words_10_memory_write_data);

  slice7cost_read_words_9_memory_read_enable <= true;
  slice7cost_read_words_9_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_9_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_9_memory_write_data <= to_unsigned(slice7cost_write_words(9), 22);
  slice7cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_9_memory_read_enable,
      read_address => slice7cost_read_words_9_memory_read_address, read_data => slice7cost_read_words(9),
      write_address => slice7cost_read_words_9_memory_write_address, write_data => slice7cost_read_words_9_memory_write_data);

  slice7cost_read_words_8_memory_read_enable <= true;
  slice7cost_read_words_8_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_8_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_8_memory_write_data <= to_unsigned(slice7cost_write_words(8), 22);
  slice7cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_8_memory_read_enable,
      read_address => slice7cost_read_words_8_memory_read_address, read_data => slice7cost_read_words(8),
      write_address => slice7cost_read_words_8_memory_write_address, write_data => slice7cost_read_words_8_memory_write_data);

  slice7cost_read_words_7_memory_read_enable <= true;
  slice7cost_read_words_7_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_7_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_7_memory_write_data <= to_unsigned(slice7cost_write_words(7), 22);
  slice7cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_7_memory_read_enable,
      read_address => slice7cost_read_words_7_memory_read_address, read_data => slice7cost_read_words(7),
      write_address => slice7cost_read_words_7_memory_write_address, write_data => slice7cost_read_words_7_memory_write_data);

  slice7cost_read_words_6_memory_read_enable <= true;
  slice7cost_read_words_6_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_6_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_6_memory_write_data <= to_unsigned(slice7cost_write_words(6), 22);
  slice7cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_6_memory_read_enable,
      read_address => slice7cost_read_words_6_memory_read_address, read_data => slice7cost_read_words(6),
      write_address => slice7cost_read_words_6_memory_write_address, write_data => slice7cost_read_words_6_memory_write_data);

  slice7cost_read_words_5_memory_read_enable <= true;
  slice7cost_read_words_5_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_5_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_5_memory_write_data <= to_unsigned(slice7cost_write_words(5), 22);
  slice7cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_5_memory_read_enable,
      read_address => slice7cost_read_words_5_memory_read_address, read_data => slice7cost_read_words(5),
      write_address => slice7cost_read_words_5_memory_write_address, write_data => slice7cost_read_words_5_memory_write_data);

  slice7cost_read_words_4_memory_read_enable <= true;
  slice7cost_read_words_4_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_4_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_4_memory_write_data <= to_unsigned(slice7cost_write_words(4), 22);
  slice7cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_4_memory_read_enable,
      read_address => slice7cost_read_words_4_memory_read_address, read_data => slice7cost_read_words(4),
      write_address => slice7cost_read_words_4_memory_write_address, write_data => slice7cost_read_words_4_memory_write_data);

  slice7cost_read_words_3_memory_read_enable <= true;
  slice7cost_read_words_3_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_3_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_3_memory_write_data <= to_unsigned(slice7cost_write_words(3), 22);
  slice7cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_3_memory_read_enable,
      read_address => slice7cost_read_words_3_memory_read_address, read_data => slice7cost_read_words(3),
      write_address => slice7cost_read_words_3_memory_write_address, write_data => slice7cost_read_words_3_memory_write_data);

  slice7cost_read_words_2_memory_read_enable <= true;
  slice7cost_read_words_2_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_2_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_2_memory_write_data <= to_unsigned(slice7cost_write_words(2), 22);
  slice7cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_2_memory_read_enable,
      read_address => slice7cost_read_words_2_memory_read_address, read_data => slice7cost_read_words(2),
      write_address => slice7cost_read_words_2_memory_write_address, write_data => slice7cost_read_words_2_memory_write_data);

  slice7cost_read_words_1_memory_read_enable <= true;
  slice7cost_read_words_1_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_1_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_1_memory_write_data <= to_unsigned(slice7cost_write_words(1), 22);
  slice7cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_1_memory_read_enable,
      read_address => slice7cost_read_words_1_memory_read_address, read_data => slice7cost_read_words(1),
      write_address => slice7cost_read_words_1_memory_write_address, write_data => slice7cost_read_words_1_memory_write_data);

  slice7cost_read_words_0_memory_read_enable <= true;
  slice7cost_read_words_0_memory_read_address <= to_unsigned(slice6cost_change_column, 10);
  slice7cost_read_words_0_memory_write_address <= to_unsigned(slice7cost_write_column, 10);
  slice7cost_read_words_0_memory_write_data <= to_unsigned(slice7cost_write_words(0), 22);
  slice7cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice7cost_read_words_0_memory_read_enable,
      read_address => slice7cost_read_words_0_memory_read_address, read_data => slice7cost_read_words(0),
      write_address => slice7cost_read_words_0_memory_write_address, write_data => slice7cost_read_words_0_memory_write_data);

  slice6window_leaving_12_memory_read_enable <= true;
  slice6window_leaving_12_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_12_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_12_memory_write_data <= to_unsigned(slice6cost_column_0(24), 11);
  slice6window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_12_memory_read_enable,
      read_address => slice6window_leaving_12_memory_read_address, read_data => slice6window_leaving_12,
      write_address => slice6window_leaving_12_memory_write_address, write_data => slice6window_leaving_12_memory_write_data);

  slice6window_leaving_11_memory_read_enable <= true;
  slice6window_leaving_11_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_11_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_11_memory_write_data <= to_unsigned(slice6cost_column_0(23), 11) & to_unsigned(slice6cost_column_0(22), 11);
  slice6window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_11_memory_read_enable,
      read_address => slice6window_leaving_11_memory_read_address, read_data => slice6window_leaving(11),
      write_address => slice6window_leaving_11_memory_write_address, write_data => slice6window_leaving_11_memory_write_data);

  slice6window_leaving_10_memory_read_enable <= true;
  slice6window_leaving_10_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_10_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_10_memory_write_data <= to_unsigned(slice6cost_column_0(21), 11) & to_unsigned(slice6cost_column_0(20), 11);
  slice6window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_10_memory_read_enable,
      read_address => slice6window_leaving_10_memory_read_address, read_data => slice6window_leaving(10),
      write_address => slice6window_leaving_10_memory_write_address, write_data => slice6window_leaving_10_memory_write_data);

  slice6window_leaving_9_memory_read_enable <= true;
  slice6window_leaving_9_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_9_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_9_memory_write_data <= to_unsigned(slice6cost_column_0(19), 11) & to_unsigned(slice6cost_column_0(18), 11);
  slice6window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_9_memory_read_enable,
      read_address => slice6window_leaving_9_memory_read_address, read_data => slice6window_leaving(9),
      write_address => slice6window_leaving_9_memory_write_address, write_data => slice6window_leaving_9_memory_write_data);

  slice6window_leaving_8_memory_read_enable <= true;
  slice6window_leaving_8_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_8_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_8_memory_write_data <= to_unsigned(slice6cost_column_0(17), 11) & to_unsigned(slice6cost_column_0(16), 11);
  slice6window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_8_memory_read_enable,
      read_address => slice6window_leaving_8_memory_read_address, read_data => slice6window_leaving(8),
      write_address => slice6window_leaving_8_memory_write_address, write_data => slice6window_leaving_8_memory_write_data);

  slice6window_leaving_7_memory_read_enable <= true;
  slice6window_leaving_7_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_7_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_7_memory_write_data <= to_unsigned(slice6cost_column_0(15), 11) & to_unsigned(slice6cost_column_0(14), 11);
  slice6window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_7_memory_read_enable,
      read_address => slice6window_leaving_7_memory_read_address, read_data => slice6window_leaving(7),
      write_address => slice6window_leaving_7_memory_write_address, write_data => slice6window_leaving_7_memory_write_data);

  slice6window_leaving_6_memory_read_enable <= true;
  slice6window_leaving_6_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_6_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_6_memory_write_data <= to_unsigned(slice6cost_column_0(13), 11) & to_unsigned(slice6cost_column_0(12), 11);
  slice6window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_6_memory_read_enable,
      read_address => slice6window_leaving_6_memory_read_address, read_data => slice6window_leaving(6),
      write_address => slice6window_leaving_6_memory_write_address, write_data => slice6window_leaving_6_memory_write_data);

  slice6window_leaving_5_memory_read_enable <= true;
  slice6window_leaving_5_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_5_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_5_memory_write_data <= to_unsigned(slice6cost_column_0(11), 11) & to_unsigned(slice6cost_column_0(10), 11);
  slice6window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_5_memory_read_enable,
      read_address => slice6window_leaving_5_memory_read_address, read_data => slice6window_leaving(5),
      write_address => slice6window_leaving_5_memory_write_address, write_data => slice6window_leaving_5_memory_write_data);

  slice6window_leaving_4_memory_read_enable <= true;
  slice6window_leaving_4_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_4_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_4_memory_write_data <= to_unsigned(slice6cost_column_0(9), 11) & to_unsigned(slice6cost_column_0(8), 11);
  slice6window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_4_memory_read_enable,
      read_address => slice6window_leaving_4_memory_read_address, read_data => slice6window_leaving(4),
      write_address => slice6window_leaving_4_memory_write_address, write_data => slice6window_leaving_4_memory_write_data);

  slice6window_leaving_3_memory_read_enable <= true;
  slice6window_leaving_3_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_3_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_3_memory_write_data <= to_unsigned(slice6cost_column_0(7), 11) & to_unsigned(slice6cost_column_0(6), 11);
  slice6window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_3_memory_read_enable,
      read_address => slice6window_leaving_3_memory_read_address, read_data => slice6window_leaving(3),
      write_address => slice6window_leaving_3_memory_write_address, write_data => slice6window_leaving_3_memory_write_data);

  slice6window_leaving_2_memory_read_enable <= true;
  slice6window_leaving_2_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_2_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_2_memory_write_data <= to_unsigned(slice6cost_column_0(5), 11) & to_unsigned(slice6cost_column_0(4), 11);
  slice6window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_2_memory_read_enable,
      read_address => slice6window_leaving_2_memory_read_address, read_data => slice6window_leaving(2),
      write_address => slice6window_leaving_2_memory_write_address, write_data => slice6window_leaving_2_memory_write_data);

  slice6window_leaving_1_memory_read_enable <= true;
  slice6window_leaving_1_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_1_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_1_memory_write_data <= to_unsigned(slice6cost_column_0(3), 11) & to_unsigned(slice6cost_column_0(2), 11);
  slice6window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_1_memory_read_enable,
      read_address => slice6window_leaving_1_memory_read_address, read_data => slice6window_leaving(1),
      write_address => slice6window_leaving_1_memory_write_address, write_data => slice6window_leaving_1_memory_write_data);

  slice6window_leaving_0_memory_read_enable <= true;
  slice6window_leaving_0_memory_read_address <= to_unsigned(slice6window_ring_read_address, 3);
  slice6window_leaving_0_memory_write_address <= to_unsigned(slice6window_ring_write_address, 3);
  slice6window_leaving_0_memory_write_data <= to_unsigned(slice6cost_column_0(1), 11) & to_unsigned(slice6cost_column_0(0), 11);
  slice6window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice6window_leaving_0_memory_read_enable,
      read_address => slice6window_leaving_0_memory_read_address, read_data => slice6window_leaving(0),
      write_address => slice6window_leaving_0_memory_write_address, write_data => slice6window_leaving_0_memory_write_data);

  slice6cost_read_words_12_memory_read_enable <= true;
  slice6cost_read_words_12_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_12_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_12_memory_write_data <= to_unsigned(slice6cost_write_words_12, 11);
  slice6cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_12_memory_read_enable,
      read_address => slice6cost_read_words_12_memory_read_address, read_data => slice6cost_read_words_12,
      write_address => slice6cost_read_words_12_memory_write_address, write_data => slice6cost_read_words_12_memory_write_data);

  slice6cost_read_words_11_memory_read_enable <= true;
  slice6cost_read_words_11_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_11_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_11_memory_write_data <= to_unsigned(slice6cost_write_words(11), 22);
  slice6cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_11_memory_read_enable,
      read_address => slice6cost_read_words_11_memory_read_address, read_data => slice6cost_read_words(11),
      write_address => slice6cost_read_words_11_memory_write_address, write_data => slice6cost_read_words_11_memory_write_data);

  slice6cost_read_words_10_memory_read_enable <= true;
  slice6cost_read_words_10_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_10_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_10_memory_write_data <= to_unsigned(slice6cost_write_words(10), 22);
  slice6cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_10_memory_read_enable,
      read_address => slice6cost_read_words_10_memory_read_address, read_data => slice6cost_read_words(10),
      write_address => slice6cost_read_words_10_memory_write_address, write_data => slice6cost_read_words_10_memory_write_data);

  slice6cost_read_words_9_memory_read_enable <= true;
  slice6cost_read_words_9_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_9_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_9_memory_write_data <= to_unsigned(slice6cost_write_words(9), 22);
  slice6cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_9_memory_read_enable,
      read_address => slice6cost_read_words_9_memory_read_address, read_data => slice6cost_read_words(9),
      write_address => slice6cost_read_words_9_memory_write_address, write_data => slice6cost_read_words_9_memory_write_data);

  slice6cost_read_words_8_memory_read_enable <= true;
  slice6cost_read_words_8_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_8_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_8_memory_write_data <= to_unsigned(slice6cost_write_words(8), 22);
  slice6cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_8_memory_read_enable,
      read_address => slice6cost_read_words_8_memory_read_address, read_data => slice6cost_read_words(8),
      write_address => slice6cost_read_words_8_memory_write_address, write_data => slice6cost_read_words_8_memory_write_data);

  slice6cost_read_words_7_memory_read_enable <= true;
  slice6cost_read_words_7_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_7_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_7_memory_write_data <= to_unsigned(slice6cost_write_words(7), 22);
  slice6cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_7_memory_read_enable,
      read_address => slice6cost_read_words_7_memory_read_address, read_data => slice6cost_read_words(7),
      write_address => slice6cost_read_words_7_memory_write_address, write_data => slice6cost_read_words_7_memory_write_data);

  slice6cost_read_words_6_memory_read_enable <= true;
  slice6cost_read_words_6_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_6_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_6_memory_write_data <= to_unsigned(slice6cost_write_words(6), 22);
  slice6cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_6_memory_read_enable,
      read_address => slice6cost_read_words_6_memory_read_address, read_data => slice6cost_read_words(6),
      write_address => slice6cost_read_words_6_memory_write_address, write_data => slice6cost_read_words_6_memory_write_data);

  slice6cost_read_words_5_memory_read_enable <= true;
  slice6cost_read_words_5_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_5_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_5_memory_write_data <= to_unsigned(slice6cost_write_words(5), 22);
  slice6cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_5_memory_read_enable,
      read_address => slice6cost_read_words_5_memory_read_address, read_data => slice6cost_read_words(5),
      write_address => slice6cost_read_words_5_memory_write_address, write_data => slice6cost_read_words_5_memory_write_data);

  slice6cost_read_words_4_memory_read_enable <= true;
  slice6cost_read_words_4_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_4_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_4_memory_write_data <= to_unsigned(slice6cost_write_words(4), 22);
  slice6cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_4_memory_read_enable,
      read_address => slice6cost_read_words_4_memory_read_address, read_data => slice6cost_read_words(4),
      write_address => slice6cost_read_words_4_memory_write_address, write_data => slice6cost_read_words_4_memory_write_data);

  slice6cost_read_words_3_memory_read_enable <= true;
  slice6cost_read_words_3_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_3_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_3_memory_write_data <= to_unsigned(slice6cost_write_words(3), 22);
  slice6cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_3_memory_read_enable,
      read_address => slice6cost_read_words_3_memory_read_address, read_data => slice6cost_read_words(3),
      write_address => slice6cost_read_words_3_memory_write_address, write_data => slice6cost_read_words_3_memory_write_data);

  slice6cost_read_words_2_memory_read_enable <= true;
  slice6cost_read_words_2_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_2_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_2_memory_write_data <= to_unsigned(slice6cost_write_words(2), 22);
  slice6cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_2_memory_read_enable,
      read_address => slice6cost_read_words_2_memory_read_address, read_data => slice6cost_read_words(2),
      write_address => slice6cost_read_words_2_memory_write_address, write_data => slice6cost_read_words_2_memory_write_data);

  slice6cost_read_words_1_memory_read_enable <= true;
  slice6cost_read_words_1_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_1_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_1_memory_write_data <= to_unsigned(slice6cost_write_words(1), 22);
  slice6cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_1_memory_read_enable,
      read_address => slice6cost_read_words_1_memory_read_address, read_data => slice6cost_read_words(1),
      write_address => slice6cost_read_words_1_memory_write_address, write_data => slice6cost_read_words_1_memory_write_data);

  slice6cost_read_words_0_memory_read_enable <= true;
  slice6cost_read_words_0_memory_read_address <= to_unsigned(slice6cost_read_column, 10);
  slice6cost_read_words_0_memory_write_address <= to_unsigned(slice7cost_ready_column, 10);
  slice6cost_read_words_0_memory_write_data <= to_unsigned(slice6cost_write_words(0), 22);
  slice6cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice6cost_read_words_0_memory_read_enable,
      read_address => slice6cost_read_words_0_memory_read_address, read_data => slice6cost_read_words(0),
      write_address => slice6cost_read_words_0_memory_write_address, write_data => slice6cost_read_words_0_memory_write_data);

  slice5window_leaving_12_memory_read_enable <= true;
  slice5window_leaving_12_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_12_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_12_memory_write_data <= to_unsigned(slice5cost_column_0(24), 11);
  slice5window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_12_memory_read_enable,
      read_address => slice5window_leaving_12_memory_read_address, read_data => slice5window_leaving_12,
      write_address => slice5window_leaving_12_memory_write_address, write_data => slice5window_leaving_12_memory_write_data);

  slice5window_leaving_11_memory_read_enable <= true;
  slice5window_leaving_11_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_11_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_11_memory_write_data <= to_unsigned(slice5cost_column_0(23), 11) & to_unsigned(slice5cost_column_0(22), 11);
  slice5window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_11_memory_read_enable,
      read_address => slice5window_leaving_11_memory_read_address, read_data => slice5window_leaving(11),
      write_address => slice5window_leaving_11_memory_write_address, write_data => slice5window_leaving_11_memory_write_data);

  slice5window_leaving_10_memory_read_enable <= true;
  slice5window_leaving_10_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_10_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_10_memory_write_data <= to_unsigned(slice5cost_column_0(21), 11) & to_unsigned(slice5cost_column_0(20), 11);
  slice5window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_10_memory_read_enable,
      read_address => slice5window_leaving_10_memory_read_address, read_data => slice5window_leaving(10),
      write_address => slice5window_leaving_10_memory_write_address, write_data => slice5window_leaving_10_memory_write_data);

  slice5window_leaving_9_memory_read_enable <= true;
  slice5window_leaving_9_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_9_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_9_memory_write_data <= to_unsigned(slice5cost_column_0(19), 11) & to_unsigned(slice5cost_column_0(18), 11);
  slice5window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_9_memory_read_enable,
      read_address => slice5window_leaving_9_memory_read_address, read_data => slice5window_leaving(9),
      write_address => slice5window_leaving_9_memory_write_address, write_data => slice5window_leaving_9_memory_write_data);

  slice5window_leaving_8_memory_read_enable <= true;
  slice5window_leaving_8_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_8_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_8_memory_write_data <= to_unsigned(slice5cost_column_0(17), 11) & to_unsigned(slice5cost_column_0(16), 11);
  slice5window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_8_memory_read_enable,
      read_address => slice5window_leaving_8_memory_read_address, read_data => slice5window_leaving(8),
      write_address => slice5window_leaving_8_memory_write_address, write_data => slice5window_leaving_8_memory_write_data);

  slice5window_leaving_7_memory_read_enable <= true;
  slice5window_leaving_7_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_7_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_7_memory_write_data <= to_unsigned(slice5cost_column_0(15), 11) & to_unsigned(slice5cost_column_0(14), 11);
  slice5window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_7_memory_read_enable,
      read_address => slice5window_leaving_7_memory_read_address, read_data => slice5window_leaving(7),
      write_address => slice5window_leaving_7_memory_write_address, write_data => slice5window_leaving_7_memory_write_data);

  slice5window_leaving_6_memory_read_enable <= true;
  slice5window_leaving_6_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_6_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_6_memory_write_data <= to_unsigned(slice5cost_column_0(13), 11) & to_unsigned(slice5cost_column_0(12), 11);
  slice5window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_6_memory_read_enable,
      read_address => slice5window_leaving_6_memory_read_address, read_data => slice5window_leaving(6),
      write_address => slice5window_leaving_6_memory_write_address, write_data => slice5window_leaving_6_memory_write_data);

  slice5window_leaving_5_memory_read_enable <= true;
  slice5window_leaving_5_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_5_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_5_memory_write_data <= to_unsigned(slice5cost_column_0(11), 11) & to_unsigned(slice5cost_column_0(10), 11);
  slice5window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_5_memory_read_enable,
      read_address => slice5window_leaving_5_memory_read_address, read_data => slice5window_leaving(5),
      write_address => slice5window_leaving_5_memory_write_address, write_data => slice5window_leaving_5_memory_write_data);

  slice5window_leaving_4_memory_read_enable <= true;
  slice5window_leaving_4_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_4_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_4_memory_write_data <= to_unsigned(slice5cost_column_0(9), 11) & to_unsigned(slice5cost_column_0(8), 11);
  slice5window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_4_memory_read_enable,
      read_address => slice5window_leaving_4_memory_read_address, read_data => slice5window_leaving(4),
      write_address => slice5window_leaving_4_memory_write_address, write_data => slice5window_leaving_4_memory_write_data);

  slice5window_leaving_3_memory_read_enable <= true;
  slice5window_leaving_3_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_3_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_3_memory_write_data <= to_unsigned(slice5cost_column_0(7), 11) & to_unsigned(slice5cost_column_0(6), 11);
  slice5window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_3_memory_read_enable,
      read_address => slice5window_leaving_3_memory_read_address, read_data => slice5window_leaving(3),
      write_address => slice5window_leaving_3_memory_write_address, write_data => slice5window_leaving_3_memory_write_data);

  slice5window_leaving_2_memory_read_enable <= true;
  slice5window_leaving_2_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_2_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_2_memory_write_data <= to_unsigned(slice5cost_column_0(5), 11) & to_unsigned(slice5cost_column_0(4), 11);
  slice5window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_2_memory_read_enable,
      read_address => slice5window_leaving_2_memory_read_address, read_data => slice5window_leaving(2),
      write_address => slice5window_leaving_2_memory_write_address, write_data => slice5window_leaving_2_memory_write_data);

  slice5window_leaving_1_memory_read_enable <= true;
  slice5window_leaving_1_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_1_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_1_memory_write_data <= to_unsigned(slice5cost_column_0(3), 11) & to_unsigned(slice5cost_column_0(2), 11);
  slice5window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_1_memory_read_enable,
      read_address => slice5window_leaving_1_memory_read_address, read_data => slice5window_leaving(1),
      write_address => slice5window_leaving_1_memory_write_address, write_data => slice5window_leaving_1_memory_write_data);

  slice5window_leaving_0_memory_read_enable <= true;
  slice5window_leaving_0_memory_read_address <= to_unsigned(slice5window_ring_read_address, 3);
  slice5window_leaving_0_memory_write_address <= to_unsigned(slice5window_ring_write_address, 3);
  slice5window_leaving_0_memory_write_data <= to_unsigned(slice5cost_column_0(1), 11) & to_unsigned(slice5cost_column_0(0), 11);
  slice5window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice5window_leaving_0_memory_read_enable,
      read_address => slice5window_leaving_0_memory_read_address, read_data => slice5window_leaving(0),
      write_address => slice5window_leaving_0_memory_write_address, write_data => slice5window_leaving_0_memory_write_data);

  slice5cost_read_words_12_memory_read_enable <= true;
  slice5cost_read_words_12_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_12_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_12_memory_write_data <= to_unsigned(slice5cost_write_words_12, 11);
  slice5cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_12_memory_read_enable,
      read_address => slice5cost_read_words_12_memory_read_address, read_data => slice5cost_read_words_12,
      write_address => slice5cost_read_words_12_memory_write_address, write_data => slice5cost_read_words_12_memory_write_data);

  slice5cost_read_words_11_memory_read_enable <= true;
  slice5cost_read_words_11_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_11_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_11_memory_write_data <= to_unsigned(slice5cost_write_words(11), 22);
  slice5cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_11_memory_read_enable,
      read_address => slice5cost_read_words_11_memory_read_address, read_data => slice5cost_read_words(11),
      write_address => slice5cost_read_words_11_memory_write_address, write_data => slice5cost_read_words_11_memory_write_data);

  slice5cost_read_words_10_memory_read_enable <= true;
  slice5cost_read_words_10_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_10_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_10_memory_write_data <= to_unsigned(slice5cost_write_words(10), 22);
  slice5cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_10_memory_read_enable,
      read_address => slice5cost_read_words_10_memory_read_address, read_data => slice5cost_read_words(10),
      write_address => slice5cost_read_words_10_memory_write_address, write_data => slice5cost_read_words_10_memory_write_data);

  slice5cost_read_words_9_memory_read_enable <= true;
  slice5cost_read_words_9_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_9_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_9_memory_write_data <= to_unsigned(slice5cost_write_words(9), 22);
  slice5cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_9_memory_read_enable,
      read_address => slice5cost_read_words_9_memory_read_address, read_data => slice5cost_read_words(9),
      write_address => slice5cost_read_words_9_memory_write_address, write_data => slice5cost_read_words_9_memory_write_data);

  slice5cost_read_words_8_memory_read_enable <= true;
  slice5cost_read_words_8_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_8_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_8_memory_write_data <= to_unsigned(slice5cost_write_words(8), 22);
  slice5cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_8_memory_read_enable,
      read_address => slice5cost_read_words_8_memory_read_address, read_data => slice5cost_read_words(8),
      write_address => slice5cost_read_words_8_memory_write_address, write_data => slice5cost_read_words_8_memory_write_data);

  slice5cost_read_words_7_memory_read_enable <= true;
  slice5cost_read_words_7_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_7_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_7_memory_write_data <= to_unsigned(slice5cost_write_words(7), 22);
  slice5cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_7_memory_read_enable,
      read_address => slice5cost_read_words_7_memory_read_address, read_data => slice5cost_read_words(7),
      write_address => slice5cost_read_words_7_memory_write_address, write_data => slice5cost_read_words_7_memory_write_data);

  slice5cost_read_words_6_memory_read_enable <= true;
  slice5cost_read_words_6_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_6_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_6_memory_write_data <= to_unsigned(slice5cost_write_words(6), 22);
  slice5cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_6_memory_read_enable,
      read_address => slice5cost_read_words_6_memory_read_address, read_data => slice5cost_read_words(6),
      write_address => slice5cost_read_words_6_memory_write_address, write_data => slice5cost_read_words_6_memory_write_data);

  slice5cost_read_words_5_memory_read_enable <= true;
  slice5cost_read_words_5_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_5_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_5_memory_write_data <= to_unsigned(slice5cost_write_words(5), 22);
  slice5cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_5_memory_read_enable,
      read_address => slice5cost_read_words_5_memory_read_address, read_data => slice5cost_read_words(5),
      write_address => slice5cost_read_words_5_memory_write_address, write_data => slice5cost_read_words_5_memory_write_data);

  slice5cost_read_words_4_memory_read_enable <= true;
  slice5cost_read_words_4_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_4_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_4_memory_write_data <= to_unsigned(slice5cost_write_words(4), 22);
  slice5cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_4_memory_read_enable,
      read_address => slice5cost_read_words_4_memory_read_address, read_data => slice5cost_read_words(4),
      write_address => slice5cost_read_words_4_memory_write_address, write_data => slice5cost_read_words_4_memory_write_data);

  slice5cost_read_words_3_memory_read_enable <= true;
  slice5cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_3_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_3_memory_write_data <= to_unsigned(slice5cost_write_words(3), 22);
  slice5cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_3_memory_read_enable,
      read_address => slice5cost_read_words_3_memory_read_address, read_data => slice5cost_read_words(3),
      write_address => slice5cost_read_words_3_memory_write_address, write_data => slice5cost_read_words_3_memory_write_data);

  slice5cost_read_words_2_memory_read_enable <= true;
  slice5cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_2_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_2_memory_write_data <= to_unsigned(slice5cost_write_words(2), 22);
  slice5cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_2_memory_read_enable,
      read_address => slice5cost_read_words_2_memory_read_address, read_data => slice5cost_read_words(2),
      write_address => slice5cost_read_words_2_memory_write_address, write_data => slice5cost_read_words_2_memory_write_data);

  slice5cost_read_words_1_memory_read_enable <= true;
  slice5cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_1_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_1_memory_write_data <= to_unsigned(slice5cost_write_words(1), 22);
  slice5cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_1_memory_read_enable,
      read_address => slice5cost_read_words_1_memory_read_address, read_data => slice5cost_read_words(1),
      write_address => slice5cost_read_words_1_memory_write_address, write_data => slice5cost_read_words_1_memory_write_data);

  slice5cost_read_words_0_memory_read_enable <= true;
  slice5cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_write_column, 10);
  slice5cost_read_words_0_memory_write_address <= to_unsigned(slice5cost_write_column, 10);
  slice5cost_read_words_0_memory_write_data <= to_unsigned(slice5cost_write_words(0), 22);
  slice5cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice5cost_read_words_0_memory_read_enable,
      read_address => slice5cost_read_words_0_memory_read_address, read_data => slice5cost_read_words(0),
      write_address => slice5cost_read_words_0_memory_write_address, write_data => slice5cost_read_words_0_memory_write_data);

  slice4window_leaving_12_memory_read_enable <= true;
  slice4window_leaving_12_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_12_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_12_memory_write_data <= to_unsigned(slice4cost_column_0(24), 11);
  slice4window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_12_memory_read_enable,
      read_address => slice4window_leaving_12_memory_read_address, read_data => slice4window_leaving_12,
      write_address => slice4window_leaving_12_memory_write_address, write_data => slice4window_leaving_12_memory_write_data);

  slice4window_leaving_11_memory_read_enable <= true;
  slice4window_leaving_11_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_11_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_11_memory_write_data <= to_unsigned(slice4cost_column_0(23), 11) & to_unsigned(slice4cost_column_0(22), 11);
  slice4window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_11_memory_read_enable,
      read_address => slice4window_leaving_11_memory_read_address, read_data => slice4window_leaving(11),
      write_address => slice4window_leaving_11_memory_write_address, write_data => slice4window_leaving_11_memory_write_data);

  slice4window_leaving_10_memory_read_enable <= true;
  slice4window_leaving_10_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_10_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_10_memory_write_data <= to_unsigned(slice4cost_column_0(21), 11) & to_unsigned(slice4cost_column_0(20), 11);
  slice4window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_10_memory_read_enable,
      read_address => slice4window_leaving_10_memory_read_address, read_data => slice4window_leaving(10),
      write_address => slice4window_leaving_10_memory_write_address, write_data => slice4window_leaving_10_memory_write_data);

  slice4window_leaving_9_memory_read_enable <= true;
  slice4window_leaving_9_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_9_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_9_memory_write_data <= to_unsigned(slice4cost_column_0(19), 11) & to_unsigned(slice4cost_column_0(18), 11);
  slice4window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_9_memory_read_enable,
      read_address => slice4window_leaving_9_memory_read_address, read_data => slice4window_leaving(9),
      write_address => slice4window_leaving_9_memory_write_address, write_data => slice4window_leaving_9_memory_write_data);

  slice4window_leaving_8_memory_read_enable <= true;
  slice4window_leaving_8_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_8_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_8_memory_write_data <= to_unsigned(slice4cost_column_0(17), 11) & to_unsigned(slice4cost_column_0(16), 11);
  slice4window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_8_memory_read_enable,
      read_address => slice4window_leaving_8_memory_read_address, read_data => slice4window_leaving(8),
      write_address => slice4window_leaving_8_memory_write_address, write_data => slice4window_leaving_8_memory_write_data);

  slice4window_leaving_7_memory_read_enable <= true;
  slice4window_leaving_7_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_7_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_7_memory_write_data <= to_unsigned(slice4cost_column_0(15), 11) & to_unsigned(slice4cost_column_0(14), 11);
  slice4window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_7_memory_read_enable,
      read_address => slice4window_leaving_7_memory_read_address, read_data => slice4window_leaving(7),
      write_address => slice4window_leaving_7_memory_write_address, write_data => slice4window_leaving_7_memory_write_data);

  slice4window_leaving_6_memory_read_enable <= true;
  slice4window_leaving_6_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_6_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_6_memory_write_data <= to_unsigned(slice4cost_column_0(13), 11) & to_unsigned(slice4cost_column_0(12), 11);
  slice4window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_6_memory_read_enable,
      read_address => slice4window_leaving_6_memory_read_address, read_data => slice4window_leaving(6),
      write_address => slice4window_leaving_6_memory_write_address, write_data => slice4window_leaving_6_memory_write_data);

  slice4window_leaving_5_memory_read_enable <= true;
  slice4window_leaving_5_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_5_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_5_memory_write_data <= to_unsigned(slice4cost_column_0(11), 11) & to_unsigned(slice4cost_column_0(10), 11);
  slice4window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_5_memory_read_enable,
      read_address => slice4window_leaving_5_memory_read_address, read_data => slice4window_leaving(5),
      write_address => slice4window_leaving_5_memory_write_address, write_data => slice4window_leaving_5_memory_write_data);

  slice4window_leaving_4_memory_read_enable <= true;
  slice4window_leaving_4_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_4_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_4_memory_write_data <= to_unsigned(slice4cost_column_0(9), 11) & to_unsigned(slice4cost_column_0(8), 11);
  slice4window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_4_memory_read_enable,
      read_address => slice4window_leaving_4_memory_read_address, read_data => slice4window_leaving(4),
      write_address => slice4window_leaving_4_memory_write_address, write_data => slice4window_leaving_4_memory_write_data);

  slice4window_leaving_3_memory_read_enable <= true;
  slice4window_leaving_3_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_3_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_3_memory_write_data <= to_unsigned(slice4cost_column_0(7), 11) & to_unsigned(slice4cost_column_0(6), 11);
  slice4window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_3_memory_read_enable,
      read_address => slice4window_leaving_3_memory_read_address, read_data => slice4window_leaving(3),
      write_address => slice4window_leaving_3_memory_write_address, write_data => slice4window_leaving_3_memory_write_data);

  slice4window_leaving_2_memory_read_enable <= true;
  slice4window_leaving_2_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_2_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_2_memory_write_data <= to_unsigned(slice4cost_column_0(5), 11) & to_unsigned(slice4cost_column_0(4), 11);
  slice4window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_2_memory_read_enable,
      read_address => slice4window_leaving_2_memory_read_address, read_data => slice4window_leaving(2),
      write_address => slice4window_leaving_2_memory_write_address, write_data => slice4window_leaving_2_memory_write_data);

  slice4window_leaving_1_memory_read_enable <= true;
  slice4window_leaving_1_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_1_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_1_memory_write_data <= to_unsigned(slice4cost_column_0(3), 11) & to_unsigned(slice4cost_column_0(2), 11);
  slice4window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_1_memory_read_enable,
      read_address => slice4window_leaving_1_memory_read_address, read_data => slice4window_leaving(1),
      write_address => slice4window_leaving_1_memory_write_address, write_data => slice4window_leaving_1_memory_write_data);

  slice4window_leaving_0_memory_read_enable <= true;
  slice4window_leaving_0_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_0_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_0_memory_write_data <= to_unsigned(slice4cost_column_0(1), 11) & to_unsigned(slice4cost_column_0(0), 11);
  slice4window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_0_memory_read_enable,
      read_address => slice4window_leaving_0_memory_read_address, read_data => slice4window_leaving(0),
      write_address => slice4window_leaving_0_memory_write_address, write_data => slice4window_leaving_0_memory_write_data);

  slice4cost_read_words_12_memory_read_enable <= true;
  slice4cost_read_words_12_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_12_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_12_memory_write_data <= to_unsigned(slice4cost_write_words_12, 11);
  slice4cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_12_memory_read_enable,
      read_address => slice4cost_read_words_12_memory_read_address, read_data => slice4cost_read_words_12,
      write_address => slice4cost_read_words_12_memory_write_address, write_data => slice4cost_read_words_12_memory_write_data);

  slice4cost_read_words_11_memory_read_enable <= true;
  slice4cost_read_words_11_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_11_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_11_memory_write_data <= to_unsigned(slice4cost_write_words(11), 22);
  slice4cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_11_memory_read_enable,
      read_address => slice4cost_read_words_11_memory_read_address, read_data => slice4cost_read_words(11),
      write_address => slice4cost_read_words_11_memory_write_address, write_data => slice4cost_read_words_11_memory_write_data);

  slice4cost_read_words_10_memory_read_enable <= true;
  slice4cost_read_words_10_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_10_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_10_memory_write_data <= to_unsigned(slice4cost_write_words(10), 22);
  slice4cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_10_memory_read_enable,
      read_address => slice4cost_read_words_10_memory_read_address, read_data => slice4cost_read_words(10),
      write_address => slice4cost_read_words_10_memory_write_address, write_data => slice4cost_read_words_10_memory_write_data);

  slice4cost_read_words_9_memory_read_enable <= true;
  slice4cost_read_words_9_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_9_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_9_memory_write_data <= to_unsigned(slice4cost_write_words(9), 22);
  slice4cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_9_memory_read_enable,
      read_address => slice4cost_read_words_9_memory_read_address, read_data => slice4cost_read_words(9),
      write_address => slice4cost_read_words_9_memory_write_address, write_data => slice4cost_read_words_9_memory_write_data);

  slice4cost_read_words_8_memory_read_enable <= true;
  slice4cost_read_words_8_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_8_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_8_memory_write_data <= to_unsigned(slice4cost_write_words(8), 22);
  slice4cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_8_memory_read_enable,
      read_address => slice4cost_read_words_8_memory_read_address, read_data => slice4cost_read_words(8),
      write_address => slice4cost_read_words_8_memory_write_address, write_data => slice4cost_read_words_8_memory_write_data);

  slice4cost_read_words_7_memory_read_enable <= true;
  slice4cost_read_words_7_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_7_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_7_memory_write_data <= to_unsigned(slice4cost_write_words(7), 22);
  slice4cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_7_memory_read_enable,
      read_address => slice4cost_read_words_7_memory_read_address, read_data => slice4cost_read_words(7),
      write_address => slice4cost_read_words_7_memory_write_address, write_data => slice4cost_read_words_7_memory_write_data);

  slice4cost_read_words_6_memory_read_enable <= true;
  slice4cost_read_words_6_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_6_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_6_memory_write_data <= to_unsigned(slice4cost_write_words(6), 22);
  slice4cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_6_memory_read_enable,
      read_address => slice4cost_read_words_6_memory_read_address, read_data => slice4cost_read_words(6),
      write_address => slice4cost_read_words_6_memory_write_address, write_data => slice4cost_read_words_6_memory_write_data);

  slice4cost_read_words_5_memory_read_enable <= true;
  slice4cost_read_words_5_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_5_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_5_memory_write_data <= to_unsigned(slice4cost_write_words(5), 22);
  slice4cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_5_memory_read_enable,
      read_address => slice4cost_read_words_5_memory_read_address, read_data => slice4cost_read_words(5),
      write_address => slice4cost_read_words_5_memory_write_address, write_data => slice4cost_read_words_5_memory_write_data);

  slice4cost_read_words_4_memory_read_enable <= true;
  slice4cost_read_words_4_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_4_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_4_memory_write_data <= to_unsigned(slice4cost_write_words(4), 22);
  slice4cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_4_memory_read_enable,
      read_address => slice4cost_read_words_4_memory_read_address, read_data => slice4cost_read_words(4),
      write_address => slice4cost_read_words_4_memory_write_address, write_data => slice4cost_read_words_4_memory_write_data);

  slice4cost_read_words_3_memory_read_enable <= true;
  slice4cost_read_words_3_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_3_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_3_memory_write_data <= to_unsigned(slice4cost_write_words(3), 22);
  slice4cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_3_memory_read_enable,
      read_address => slice4cost_read_words_3_memory_read_address, read_data => slice4cost_read_words(3),
      write_address => slice4cost_read_words_3_memory_write_address, write_data => slice4cost_read_words_3_memory_write_data);

  slice4cost_read_words_2_memory_read_enable <= true;
  slice4cost_read_words_2_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_2_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_2_memory_write_data <= to_unsigned(slice4cost_write_words(2), 22);
  slice4cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_2_memory_read_enable,
      read_address => slice4cost_read_words_2_memory_read_address, read_data => slice4cost_read_words(2),
      write_address => slice4cost_read_words_2_memory_write_address, write_data => slice4cost_read_words_2_memory_write_data);

  slice4cost_read_words_1_memory_read_enable <= true;
  slice4cost_read_words_1_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_1_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_1_memory_write_data <= to_unsigned(slice4cost_write_words(1), 22);
  slice4cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_1_memory_read_enable,
      read_address => slice4cost_read_words_1_memory_read_address, read_data => slice4cost_read_words(1),
      write_address => slice4cost_read_words_1_memory_write_address, write_data => slice4cost_read_words_1_memory_write_data);

  slice4cost_read_words_0_memory_read_enable <= true;
  slice4cost_read_words_0_memory_read_address <= to_unsigned(slice1cost_write_column, 10);
  slice4cost_read_words_0_memory_write_address <= to_unsigned(slice5cost_ready_column, 10);
  slice4cost_read_words_0_memory_write_data <= to_unsigned(slice4cost_write_words(0), 22);
  slice4cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice4cost_read_words_0_memory_read_enable,
      read_address => slice4cost_read_words_0_memory_read_address, read_data => slice4cost_read_words(0),
      write_address => slice4cost_read_words_0_memory_write_address, write_data => slice4cost_read_words_0_memory_write_data);

  slice3window_leaving_12_memory_read_enable <= true;
  slice3window_leaving_12_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_12_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_12_memory_write_data <= to_unsigned(slice3cost_column_0(24), 11);
  slice3window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_12_memory_read_enable,
      read_address => slice3window_leaving_12_memory_read_address, read_data => slice3window_leaving_12,
      write_address => slice3window_leaving_12_memory_write_address, write_data => slice3window_leaving_12_memory_write_data);

  slice3window_leaving_11_memory_read_enable <= true;
  slice3window_leaving_11_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_11_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_11_memory_write_data <= to_unsigned(slice3cost_column_0(23), 11) & to_unsigned(slice3cost_column_0(22), 11);
  slice3window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_11_memory_read_enable,
      read_address => slice3window_leaving_11_memory_read_address, read_data => slice3window_leaving(11),
      write_address => slice3window_leaving_11_memory_write_address, write_data => slice3window_leaving_11_memory_write_data);

  slice3window_leaving_10_memory_read_enable <= true;
  slice3window_leaving_10_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_10_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_10_memory_write_data <= to_unsigned(slice3cost_column_0(21), 11) & to_unsigned(slice3cost_column_0(20), 11);
  slice3window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_10_memory_read_enable,
      read_address => slice3window_leaving_10_memory_read_address, read_data => slice3window_leaving(10),
      write_address => slice3window_leaving_10_memory_write_address, write_data => slice3window_leaving_10_memory_write_data);

  slice3window_leaving_9_memory_read_enable <= true;
  slice3window_leaving_9_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_9_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_9_memory_write_data <= to_unsigned(slice3cost_column_0(19), 11) & to_unsigned(slice3cost_column_0(18), 11);
  slice3window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_9_memory_read_enable,
      read_address => slice3window_leaving_9_memory_read_address, read_data => slice3window_leaving(9),
      write_address => slice3window_leaving_9_memory_write_address, write_data => slice3window_leaving_9_memory_write_data);

  slice3window_leaving_8_memory_read_enable <= true;
  slice3window_leaving_8_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_8_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_8_memory_write_data <= to_unsigned(slice3cost_column_0(17), 11) & to_unsigned(slice3cost_column_0(16), 11);
  slice3window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_8_memory_read_enable,
      read_address => slice3window_leaving_8_memory_read_address, read_data => slice3window_leaving(8),
      write_address => slice3window_leaving_8_memory_write_address, write_data => slice3window_leaving_8_memory_write_data);

  slice3window_leaving_7_memory_read_enable <= true;
  slice3window_leaving_7_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_7_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_7_memory_write_data <= to_unsigned(slice3cost_column_0(15), 11) & to_unsigned(slice3cost_column_0(14), 11);
  slice3window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_7_memory_read_enable,
      read_address => slice3window_leaving_7_memory_read_address, read_data => slice3window_leaving(7),
      write_address => slice3window_leaving_7_memory_write_address, write_data => slice3window_leaving_7_memory_write_data);

  slice3window_leaving_6_memory_read_enable <= true;
  slice3window_leaving_6_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_6_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_6_memory_write_data <= to_unsigned(slice3cost_column_0(13), 11) & to_unsigned(slice3cost_column_0(12), 11);
  slice3window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_6_memory_read_enable,
      read_address => slice3window_leaving_6_memory_read_address, read_data => slice3window_leaving(6),
      write_address => slice3window_leaving_6_memory_write_address, write_data => slice3window_leaving_6_memory_write_data);

  slice3window_leaving_5_memory_read_enable <= true;
  slice3window_leaving_5_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_5_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_5_memory_write_data <= to_unsigned(slice3cost_column_0(11), 11) & to_unsigned(slice3cost_column_0(10), 11);
  slice3window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_5_memory_read_enable,
      read_address => slice3window_leaving_5_memory_read_address, read_data => slice3window_leaving(5),
      write_address => slice3window_leaving_5_memory_write_address, write_data => slice3window_leaving_5_memory_write_data);

  slice3window_leaving_4_memory_read_enable <= true;
  slice3window_leaving_4_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_4_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_4_memory_write_data <= to_unsigned(slice3cost_column_0(9), 11) & to_unsigned(slice3cost_column_0(8), 11);
  slice3window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_4_memory_read_enable,
      read_address => slice3window_leaving_4_memory_read_address, read_data => slice3window_leaving(4),
      write_address => slice3window_leaving_4_memory_write_address, write_data => slice3window_leaving_4_memory_write_data);

  slice3window_leaving_3_memory_read_enable <= true;
  slice3window_leaving_3_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_3_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_3_memory_write_data <= to_unsigned(slice3cost_column_0(7), 11) & to_unsigned(slice3cost_column_0(6), 11);
  slice3window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_3_memory_read_enable,
      read_address => slice3window_leaving_3_memory_read_address, read_data => slice3window_leaving(3),
      write_address => slice3window_leaving_3_memory_write_address, write_data => slice3window_leaving_3_memory_write_data);

  slice3window_leaving_2_memory_read_enable <= true;
  slice3window_leaving_2_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_2_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_2_memory_write_data <= to_unsigned(slice3cost_column_0(5), 11) & to_unsigned(slice3cost_column_0(4), 11);
  slice3window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_2_memory_read_enable,
      read_address => slice3window_leaving_2_memory_read_address, read_data => slice3window_leaving(2),
      write_address => slice3window_leaving_2_memory_write_address, write_data => slice3window_leaving_2_memory_write_data);

  slice3window_leaving_1_memory_read_enable <= true;
  slice3window_leaving_1_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_1_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_1_memory_write_data <= to_unsigned(slice3cost_column_0(3), 11) & to_unsigned(slice3cost_column_0(2), 11);
  slice3window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_1_memory_read_enable,
      read_address => slice3window_leaving_1_memory_read_address, read_data => slice3window_leaving(1),
      write_address => slice3window_leaving_1_memory_write_address, write_data => slice3window_leaving_1_memory_write_data);

  slice3window_leaving_0_memory_read_enable <= true;
  slice3window_leaving_0_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_0_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_0_memory_write_data <= to_unsigned(slice3cost_column_0(1), 11) & to_unsigned(slice3cost_column_0(0), 11);
  slice3window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_0_memory_read_enable,
      read_address => slice3window_leaving_0_memory_read_address, read_data => slice3window_leaving(0),
      write_address => slice3window_leaving_0_memory_write_address, write_data => slice3window_leaving_0_memory_write_data);

  slice3cost_read_words_12_memory_read_enable <= true;
  slice3cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_12_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_12_memory_write_data <= to_unsigned(slice3cost_write_words_12, 11);
  slice3cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_12_memory_read_enable,
      read_address => slice3cost_read_words_12_memory_read_address, read_data => slice3cost_read_words_12,
      write_address => slice3cost_read_words_12_memory_write_address, write_data => slice3cost_read_words_12_memory_write_data);

  slice3cost_read_words_11_memory_read_enable <= true;
  slice3cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_11_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_11_memory_write_data <= to_unsigned(slice3cost_write_words(11), 22);
  slice3cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_11_memory_read_enable,
      read_address => slice3cost_read_words_11_memory_read_address, read_data => slice3cost_read_words(11),
      write_address => slice3cost_read_words_11_memory_write_address, write_data => slice3cost_read_words_11_memory_write_data);

  slice3cost_read_words_10_memory_read_enable <= true;
  slice3cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_10_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_10_memory_write_data <= to_unsigned(slice3cost_write_words(10), 22);
  slice3cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_10_memory_read_enable,
      read_address => slice3cost_read_words_10_memory_read_address, read_data => slice3cost_read_words(10),
      write_address => slice3cost_read_words_10_memory_write_address, write_data => slice3cost_read_words_10_memory_write_data);

  slice3cost_read_words_9_memory_read_enable <= true;
  slice3cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_9_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_9_memory_write_data <= to_unsigned(slice3cost_write_words(9), 22);
  slice3cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_9_memory_read_enable,
      read_address => slice3cost_read_words_9_memory_read_address, read_data => slice3cost_read_words(9),
      write_address => slice3cost_read_words_9_memory_write_address, write_data => slice3cost_read_words_9_memory_write_data);

  slice3cost_read_words_8_memory_read_enable <= true;
  slice3cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_8_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_8_memory_write_data <= to_unsigned(slice3cost_write_words(8), 22);
  slice3cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_8_memory_read_enable,
      read_address => slice3cost_read_words_8_memory_read_address, read_data => slice3cost_read_words(8),
      write_address => slice3cost_read_words_8_memory_write_address, write_data => slice3cost_read_words_8_memory_write_data);

  slice3cost_read_words_7_memory_read_enable <= true;
  slice3cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_7_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_7_memory_write_data <= to_unsigned(slice3cost_write_words(7), 22);
  slice3cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_7_memory_read_enable,
      read_address => slice3cost_read_words_7_memory_read_address, read_data => slice3cost_read_words(7),
      write_address => slice3cost_read_words_7_memory_write_address, write_data => slice3cost_read_words_7_memory_write_data);

  slice3cost_read_words_6_memory_read_enable <= true;
  slice3cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_6_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_6_memory_write_data <= to_unsigned(slice3cost_write_words(6), 22);
  slice3cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_6_memory_read_enable,
      read_address => slice3cost_read_words_6_memory_read_address, read_data => slice3cost_read_words(6),
      write_address => slice3cost_read_words_6_memory_write_address, write_data => slice3cost_read_words_6_memory_write_data);

  slice3cost_read_words_5_memory_read_enable <= true;
  slice3cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_5_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_5_memory_write_data <= to_unsigned(slice3cost_write_words(5), 22);
  slice3cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_5_memory_read_enable,
      read_address => slice3cost_read_words_5_memory_read_address, read_data => slice3cost_read_words(5),
      write_address => slice3cost_read_words_5_memory_write_address, write_data => slice3cost_read_words_5_memory_write_data);

  slice3cost_read_words_4_memory_read_enable <= true;
  slice3cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_4_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_4_memory_write_data <= to_unsigned(slice3cost_write_words(4), 22);
  slice3cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_4_memory_read_enable,
      read_address => slice3cost_read_words_4_memory_read_address, read_data => slice3cost_read_words(4),
      write_address => slice3cost_read_words_4_memory_write_address, write_data => slice3cost_read_words_4_memory_write_data);

  slice3cost_read_words_3_memory_read_enable <= true;
  slice3cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_3_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_3_memory_write_data <= to_unsigned(slice3cost_write_words(3), 22);
  slice3cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_3_memory_read_enable,
      read_address => slice3cost_read_words_3_memory_read_address, read_data => slice3cost_read_words(3),
      write_address => slice3cost_read_words_3_memory_write_address, write_data => slice3cost_read_words_3_memory_write_data);

  slice3cost_read_words_2_memory_read_enable <= true;
  slice3cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_2_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_2_memory_write_data <= to_unsigned(slice3cost_write_words(2), 22);
  slice3cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_2_memory_read_enable,
      read_address => slice3cost_read_words_2_memory_read_address, read_data => slice3cost_read_words(2),
      write_address => slice3cost_read_words_2_memory_write_address, write_data => slice3cost_read_words_2_memory_write_data);

  slice3cost_read_words_1_memory_read_enable <= true;
  slice3cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_1_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_1_memory_write_data <= to_unsigned(slice3cost_write_words(1), 22);
  slice3cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_1_memory_read_enable,
      read_address => slice3cost_read_words_1_memory_read_address, read_data => slice3cost_read_words(1),
      write_address => slice3cost_read_words_1_memory_write_address, write_data => slice3cost_read_words_1_memory_write_data);

  slice3cost_read_words_0_memory_read_enable <= true;
  slice3cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_write_column, 10);
  slice3cost_read_words_0_memory_write_address <= to_unsigned(slice5cost_change_column, 10);
  slice3cost_read_words_0_memory_write_data <= to_unsigned(slice3cost_write_words(0), 22);
  slice3cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice3cost_read_words_0_memory_read_enable,
      read_address => slice3cost_read_words_0_memory_read_address, read_data => slice3cost_read_words(0),
      write_address => slice3cost_read_words_0_memory_write_address, write_data => slice3cost_read_words_0_memory_write_data);

  slice2window_leaving_12_memory_read_enable <= true;
  slice2window_leaving_12_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_12_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_12_memory_write_data <= to_unsigned(slice2cost_column_0(24), 11);
  slice2window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_12_memory_read_enable,
      read_address => slice2window_leaving_12_memory_read_address, read_data => slice2window_leaving_12,
      write_address => slice2window_leaving_12_memory_write_address, write_data => slice2window_leaving_12_memory_write_data);

  slice2window_leaving_11_memory_read_enable <= true;
  slice2window_leaving_11_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_11_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_11_memory_write_data <= to_unsigned(slice2cost_column_0(23), 11) & to_unsigned(slice2cost_column_0(22), 11);
  slice2window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_11_memory_read_enable,
      read_address => slice2window_leaving_11_memory_read_address, read_data => slice2window_leaving(11),
      write_address => slice2window_leaving_11_memory_write_address, write_data => slice2window_leaving_11_memory_write_data);

  slice2window_leaving_10_memory_read_enable <= true;
  slice2window_leaving_10_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_10_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_10_memory_write_data <= to_unsigned(slice2cost_column_0(21), 11) & to_unsigned(slice2cost_column_0(20), 11);
  slice2window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_10_memory_read_enable,
      read_address => slice2window_leaving_10_memory_read_address, read_data => slice2window_leaving(10),
      write_address => slice2window_leaving_10_memory_write_address, write_data => slice2window_leaving_10_memory_write_data);

  slice2window_leaving_9_memory_read_enable <= true;
  slice2window_leaving_9_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_9_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_9_memory_write_data <= to_unsigned(slice2cost_column_0(19), 11) & to_unsigned(slice2cost_column_0(18), 11);
  slice2window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_9_memory_read_enable,
      read_address => slice2window_leaving_9_memory_read_address, read_data => slice2window_leaving(9),
      write_address => slice2window_leaving_9_memory_write_address, write_data => slice2window_leaving_9_memory_write_data);

  slice2window_leaving_8_memory_read_enable <= true;
  slice2window_leaving_8_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_8_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_8_memory_write_data <= to_unsigned(slice2cost_column_0(17), 11) & to_unsigned(slice2cost_column_0(16), 11);
  slice2window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_8_memory_read_enable,
      read_address => slice2window_leaving_8_memory_read_address, read_data => slice2window_leaving(8),
      write_address => slice2window_leaving_8_memory_write_address, write_data => slice2window_leaving_8_memory_write_data);

  slice2window_leaving_7_memory_read_enable <= true;
  slice2window_leaving_7_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_7_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_7_memory_write_data <= to_unsigned(slice2cost_column_0(15), 11) & to_unsigned(slice2cost_column_0(14), 11);
  slice2window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_7_memory_read_enable,
      read_address => slice2window_leaving_7_memory_read_address, read_data => slice2window_leaving(7),
      write_address => slice2window_leaving_7_memory_write_address, write_data => slice2window_leaving_7_memory_write_data);

  slice2window_leaving_6_memory_read_enable <= true;
  slice2window_leaving_6_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_6_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_6_memory_write_data <= to_unsigned(slice2cost_column_0(13), 11) & to_unsigned(slice2cost_column_0(12), 11);
  slice2window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_6_memory_read_enable,
      read_address => slice2window_leaving_6_memory_read_address, read_data => slice2window_leaving(6),
      write_address => slice2window_leaving_6_memory_write_address, write_data => slice2window_leaving_6_memory_write_data);

  slice2window_leaving_5_memory_read_enable <= true;
  slice2window_leaving_5_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_5_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_5_memory_write_data <= to_unsigned(slice2cost_column_0(11), 11) & to_unsigned(slice2cost_column_0(10), 11);
  slice2window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_5_memory_read_enable,
      read_address => slice2window_leaving_5_memory_read_address, read_data => slice2window_leaving(5),
      write_address => slice2window_leaving_5_memory_write_address, write_data => slice2window_leaving_5_memory_write_data);

  slice2window_leaving_4_memory_read_enable <= true;
  slice2window_leaving_4_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_4_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_4_memory_write_data <= to_unsigned(slice2cost_column_0(9), 11) & to_unsigned(slice2cost_column_0(8), 11);
  slice2window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_4_memory_read_enable,
      read_address => slice2window_leaving_4_memory_read_address, read_data => slice2window_leaving(4),
      write_address => slice2window_leaving_4_memory_write_address, write_data => slice2window_leaving_4_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0(7), 11) & to_unsigned(slice2cost_column_0(6), 11);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving(3),
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0(5), 11) & to_unsigned(slice2cost_column_0(4), 11);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving(2),
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0(3), 11) & to_unsigned(slice2cost_column_0(2), 11);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving(1),
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0(1), 11) & to_unsigned(slice2cost_column_0(0), 11);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving(0),
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_12_memory_read_enable <= true;
  slice2cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_12_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_12_memory_write_data <= to_unsigned(slice2cost_write_words_12, 11);
  slice2cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_12_memory_read_enable,
      read_address => slice2cost_read_words_12_memory_read_address, read_data => slice2cost_read_words_12,
      write_address => slice2cost_read_words_12_memory_write_address, write_data => slice2cost_read_words_12_memory_write_data);

  slice2cost_read_words_11_memory_read_enable <= true;
  slice2cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_11_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_11_memory_write_data <= to_unsigned(slice2cost_write_words(11), 22);
  slice2cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_11_memory_read_enable,
      read_address => slice2cost_read_words_11_memory_read_address, read_data => slice2cost_read_words(11),
      write_address => slice2cost_read_words_11_memory_write_address, write_data => slice2cost_read_words_11_memory_write_data);

  slice2cost_read_words_10_memory_read_enable <= true;
  slice2cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_10_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_10_memory_write_data <= to_unsigned(slice2cost_write_words(10), 22);
  slice2cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_10_memory_read_enable,
      read_address => slice2cost_read_words_10_memory_read_address, read_data => slice2cost_read_words(10),
      write_address => slice2cost_read_words_10_memory_write_address, write_data => slice2cost_read_words_10_memory_write_data);

  slice2cost_read_words_9_memory_read_enable <= true;
  slice2cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_9_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_9_memory_write_data <= to_unsigned(slice2cost_write_words(9), 22);
  slice2cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_9_memory_read_enable,
      read_address => slice2cost_read_words_9_memory_read_address, read_data => slice2cost_read_words(9),
      write_address => slice2cost_read_words_9_memory_write_address, write_data => slice2cost_read_words_9_memory_write_data);

  slice2cost_read_words_8_memory_read_enable <= true;
  slice2cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_8_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_8_memory_write_data <= to_unsigned(slice2cost_write_words(8), 22);
  slice2cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_8_memory_read_enable,
      read_address => slice2cost_read_words_8_memory_read_address, read_data => slice2cost_read_words(8),
      write_address => slice2cost_read_words_8_memory_write_address, write_data => slice2cost_read_words_8_memory_write_data);

  slice2cost_read_words_7_memory_read_enable <= true;
  slice2cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_7_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_7_memory_write_data <= to_unsigned(slice2cost_write_words(7), 22);
  slice2cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_7_memory_read_enable,
      read_address => slice2cost_read_words_7_memory_read_address, read_data => slice2cost_read_words(7),
      write_address => slice2cost_read_words_7_memory_write_address, write_data => slice2cost_read_words_7_memory_write_data);

  slice2cost_read_words_6_memory_read_enable <= true;
  slice2cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_6_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_6_memory_write_data <= to_unsigned(slice2cost_write_words(6), 22);
  slice2cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_6_memory_read_enable,
      read_address => slice2cost_read_words_6_memory_read_address, read_data => slice2cost_read_words(6),
      write_address => slice2cost_read_words_6_memory_write_address, write_data => slice2cost_read_words_6_memory_write_data);

  slice2cost_read_words_5_memory_read_enable <= true;
  slice2cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_5_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_5_memory_write_data <= to_unsigned(slice2cost_write_words(5), 22);
  slice2cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_5_memory_read_enable,
      read_address => slice2cost_read_words_5_memory_read_address, read_data => slice2cost_read_words(5),
      write_address => slice2cost_read_words_5_memory_write_address, write_data => slice2cost_read_words_5_memory_write_data);

  slice2cost_read_words_4_memory_read_enable <= true;
  slice2cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_4_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_4_memory_write_data <= to_unsigned(slice2cost_write_words(4), 22);
  slice2cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_4_memory_read_enable,
      read_address => slice2cost_read_words_4_memory_read_address, read_data => slice2cost_read_words(4),
      write_address => slice2cost_read_words_4_memory_write_address, write_data => slice2cost_read_words_4_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_3_memory_write_data <= to_unsigned(slice2cost_write_words(3), 22);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words(3),
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_2_memory_write_data <= to_unsigned(slice2cost_write_words(2), 22);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words(2),
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_1_memory_write_data <= to_unsigned(slice2cost_write_words(1), 22);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words(1),
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_ready_column, 10);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice5cost_read_column, 10);
  slice2cost_read_words_0_memory_write_data <= to_unsigned(slice2cost_write_words(0), 22);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words(0),
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_12_memory_read_enable <= true;
  slice1window_leaving_12_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_12_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_12_memory_write_data <= to_unsigned(slice1cost_column_0(24), 11);
  slice1window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_12_memory_read_enable,
      read_address => slice1window_leaving_12_memory_read_address, read_data => slice1window_leaving_12,
      write_address => slice1window_leaving_12_memory_write_address, write_data => slice1window_leaving_12_memory_write_data);

  slice1window_leaving_11_memory_read_enable <= true;
  slice1window_leaving_11_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_11_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_11_memory_write_data <= to_unsigned(slice1cost_column_0(23), 11) & to_unsigned(slice1cost_column_0(22), 11);
  slice1window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_11_memory_read_enable,
      read_address => slice1window_leaving_11_memory_read_address, read_data => slice1window_leaving(11),
      write_address => slice1window_leaving_11_memory_write_address, write_data => slice1window_leaving_11_memory_write_data);

  slice1window_leaving_10_memory_read_enable <= true;
  slice1window_leaving_10_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_10_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_10_memory_write_data <= to_unsigned(slice1cost_column_0(21), 11) & to_unsigned(slice1cost_column_0(20), 11);
  slice1window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_10_memory_read_enable,
      read_address => slice1window_leaving_10_memory_read_address, read_data => slice1window_leaving(10),
      write_address => slice1window_leaving_10_memory_write_address, write_data => slice1window_leaving_10_memory_write_data);

  slice1window_leaving_9_memory_read_enable <= true;
  slice1window_leaving_9_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_9_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_9_memory_write_data <= to_unsigned(slice1cost_column_0(19), 11) & to_unsigned(slice1cost_column_0(18), 11);
  slice1window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_9_memory_read_enable,
      read_address => slice1window_leaving_9_memory_read_address, read_data => slice1window_leaving(9),
      write_address => slice1window_leaving_9_memory_write_address, write_data => slice1window_leaving_9_memory_write_data);

  slice1window_leaving_8_memory_read_enable <= true;
  slice1window_leaving_8_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_8_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_8_memory_write_data <= to_unsigned(slice1cost_column_0(17), 11) & to_unsigned(slice1cost_column_0(16), 11);
  slice1window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_8_memory_read_enable,
      read_address => slice1window_leaving_8_memory_read_address, read_data => slice1window_leaving(8),
      write_address => slice1window_leaving_8_memory_write_address, write_data => slice1window_leaving_8_memory_write_data);

  slice1window_leaving_7_memory_read_enable <= true;
  slice1window_leaving_7_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_7_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_7_memory_write_data <= to_unsigned(slice1cost_column_0(15), 11) & to_unsigned(slice1cost_column_0(14), 11);
  slice1window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_7_memory_read_enable,
      read_address => slice1window_leaving_7_memory_read_address, read_data => slice1window_leaving(7),
      write_address => slice1window_leaving_7_memory_write_address, write_data => slice1window_leaving_7_memory_write_data);

  slice1window_leaving_6_memory_read_enable <= true;
  slice1window_leaving_6_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_6_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_6_memory_write_data <= to_unsigned(slice1cost_column_0(13), 11) & to_unsigned(slice1cost_column_0(12), 11);
  slice1window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_6_memory_read_enable,
      read_address => slice1window_leaving_6_memory_read_address, read_data => slice1window_leaving(6),
      write_address => slice1window_leaving_6_memory_write_address, write_data => slice1window_leaving_6_memory_write_data);

  slice1window_leaving_5_memory_read_enable <= true;
  slice1window_leaving_5_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_5_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_5_memory_write_data <= to_unsigned(slice1cost_column_0(11), 11) & to_unsigned(slice1cost_column_0(10), 11);
  slice1window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_5_memory_read_enable,
      read_address => slice1window_leaving_5_memory_read_address, read_data => slice1window_leaving(5),
      write_address => slice1window_leaving_5_memory_write_address, write_data => slice1window_leaving_5_memory_write_data);

  slice1window_leaving_4_memory_read_enable <= true;
  slice1window_leaving_4_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_4_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_4_memory_write_data <= to_unsigned(slice1cost_column_0(9), 11) & to_unsigned(slice1cost_column_0(8), 11);
  slice1window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_4_memory_read_enable,
      read_address => slice1window_leaving_4_memory_read_address, read_data => slice1window_leaving(4),
      write_address => slice1window_leaving_4_memory_write_address, write_data => slice1window_leaving_4_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0(7), 11) & to_unsigned(slice1cost_column_0(6), 11);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving(3),
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0(5), 11) & to_unsigned(slice1cost_column_0(4), 11);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving(2),
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0(3), 11) & to_unsigned(slice1cost_column_0(2), 11);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving(1),
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0(1), 11) & to_unsigned(slice1cost_column_0(0), 11);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving(0),
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_12_memory_read_enable <= true;
  slice1cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_12_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_12_memory_write_data <= to_unsigned(slice1cost_write_words_12, 11);
  slice1cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_12_memory_read_enable,
      read_address => slice1cost_read_words_12_memory_read_address, read_data => slice1cost_read_words_12,
      write_address => slice1cost_read_words_12_memory_write_address, write_data => slice1cost_read_words_12_memory_write_data);

  slice1cost_read_words_11_memory_read_enable <= true;
  slice1cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_11_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_11_memory_write_data <= to_unsigned(slice1cost_write_words(11), 22);
  slice1cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_11_memory_read_enable,
      read_address => slice1cost_read_words_11_memory_read_address, read_data => slice1cost_read_words(11),
      write_address => slice1cost_read_words_11_memory_write_address, write_data => slice1cost_read_words_11_memory_write_data);

  slice1cost_read_words_10_memory_read_enable <= true;
  slice1cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_10_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_10_memory_write_data <= to_unsigned(slice1cost_write_words(10), 22);
  slice1cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_10_memory_read_enable,
      read_address => slice1cost_read_words_10_memory_read_address, read_data => slice1cost_read_words(10),
      write_address => slice1cost_read_words_10_memory_write_address, write_data => slice1cost_read_words_10_memory_write_data);

  slice1cost_read_words_9_memory_read_enable <= true;
  slice1cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_9_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_9_memory_write_data <= to_unsigned(slice1cost_write_words(9), 22);
  slice1cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_9_memory_read_enable,
      read_address => slice1cost_read_words_9_memory_read_address, read_data => slice1cost_read_words(9),
      write_address => slice1cost_read_words_9_memory_write_address, write_data => slice1cost_read_words_9_memory_write_data);

  slice1cost_read_words_8_memory_read_enable <= true;
  slice1cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_8_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_8_memory_write_data <= to_unsigned(slice1cost_write_words(8), 22);
  slice1cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_8_memory_read_enable,
      read_address => slice1cost_read_words_8_memory_read_address, read_data => slice1cost_read_words(8),
      write_address => slice1cost_read_words_8_memory_write_address, write_data => slice1cost_read_words_8_memory_write_data);

  slice1cost_read_words_7_memory_read_enable <= true;
  slice1cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_7_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_7_memory_write_data <= to_unsigned(slice1cost_write_words(7), 22);
  slice1cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_7_memory_read_enable,
      read_address => slice1cost_read_words_7_memory_read_address, read_data => slice1cost_read_words(7),
      write_address => slice1cost_read_words_7_memory_write_address, write_data => slice1cost_read_words_7_memory_write_data);

  slice1cost_read_words_6_memory_read_enable <= true;
  slice1cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_6_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_6_memory_write_data <= to_unsigned(slice1cost_write_words(6), 22);
  slice1cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_6_memory_read_enable,
      read_address => slice1cost_read_words_6_memory_read_address, read_data => slice1cost_read_words(6),
      write_address => slice1cost_read_words_6_memory_write_address, write_data => slice1cost_read_words_6_memory_write_data);

  slice1cost_read_words_5_memory_read_enable <= true;
  slice1cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_5_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_5_memory_write_data <= to_unsigned(slice1cost_write_words(5), 22);
  slice1cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_5_memory_read_enable,
      read_address => slice1cost_read_words_5_memory_read_address, read_data => slice1cost_read_words(5),
      write_address => slice1cost_read_words_5_memory_write_address, write_data => slice1cost_read_words_5_memory_write_data);

  slice1cost_read_words_4_memory_read_enable <= true;
  slice1cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_4_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_4_memory_write_data <= to_unsigned(slice1cost_write_words(4), 22);
  slice1cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_4_memory_read_enable,
      read_address => slice1cost_read_words_4_memory_read_address, read_data => slice1cost_read_words(4),
      write_address => slice1cost_read_words_4_memory_write_address, write_data => slice1cost_read_words_4_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words(3), 22);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words(3),
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words(2), 22);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words(2),
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words(1), 22);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words(1),
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 10);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice4cost_read_column, 10);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words(0), 22);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words(0),
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_12_memory_read_enable <= true;
  slice0window_leaving_12_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_12_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_12_memory_write_data <= to_unsigned(slice0cost_column_0(24), 11);
  slice0window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_12_memory_read_enable,
      read_address => slice0window_leaving_12_memory_read_address, read_data => slice0window_leaving_12,
      write_address => slice0window_leaving_12_memory_write_address, write_data => slice0window_leaving_12_memory_write_data);

  slice0window_leaving_11_memory_read_enable <= true;
  slice0window_leaving_11_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_11_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_11_memory_write_data <= to_unsigned(slice0cost_column_0(23), 11) & to_unsigned(slice0cost_column_0(22), 11);
  slice0window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_11_memory_read_enable,
      read_address => slice0window_leaving_11_memory_read_address, read_data => slice0window_leaving(11),
      write_address => slice0window_leaving_11_memory_write_address, write_data => slice0window_leaving_11_memory_write_data);

  slice0window_leaving_10_memory_read_enable <= true;
  slice0window_leaving_10_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_10_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_10_memory_write_data <= to_unsigned(slice0cost_column_0(21), 11) & to_unsigned(slice0cost_column_0(20), 11);
  slice0window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_10_memory_read_enable,
      read_address => slice0window_leaving_10_memory_read_address, read_data => slice0window_leaving(10),
      write_address => slice0window_leaving_10_memory_write_address, write_data => slice0window_leaving_10_memory_write_data);

  slice0window_leaving_9_memory_read_enable <= true;
  slice0window_leaving_9_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_9_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_9_memory_write_data <= to_unsigned(slice0cost_column_0(19), 11) & to_unsigned(slice0cost_column_0(18), 11);
  slice0window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_9_memory_read_enable,
      read_address => slice0window_leaving_9_memory_read_address, read_data => slice0window_leaving(9),
      write_address => slice0window_leaving_9_memory_write_address, write_data => slice0window_leaving_9_memory_write_data);

  slice0window_leaving_8_memory_read_enable <= true;
  slice0window_leaving_8_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_8_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_8_memory_write_data <= to_unsigned(slice0cost_column_0(17), 11) & to_unsigned(slice0cost_column_0(16), 11);
  slice0window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_8_memory_read_enable,
      read_address => slice0window_leaving_8_memory_read_address, read_data => slice0window_leaving(8),
      write_address => slice0window_leaving_8_memory_write_address, write_data => slice0window_leaving_8_memory_write_data);

  slice0window_leaving_7_memory_read_enable <= true;
  slice0window_leaving_7_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_7_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_7_memory_write_data <= to_unsigned(slice0cost_column_0(15), 11) & to_unsigned(slice0cost_column_0(14), 11);
  slice0window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_7_memory_read_enable,
      read_address => slice0window_leaving_7_memory_read_address, read_data => slice0window_leaving(7),
      write_address => slice0window_leaving_7_memory_write_address, write_data => slice0window_leaving_7_memory_write_data);

  slice0window_leaving_6_memory_read_enable <= true;
  slice0window_leaving_6_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_6_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_6_memory_write_data <= to_unsigned(slice0cost_column_0(13), 11) & to_unsigned(slice0cost_column_0(12), 11);
  slice0window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_6_memory_read_enable,
      read_address => slice0window_leaving_6_memory_read_address, read_data => slice0window_leaving(6),
      write_address => slice0window_leaving_6_memory_write_address, write_data => slice0window_leaving_6_memory_write_data);

  slice0window_leaving_5_memory_read_enable <= true;
  slice0window_leaving_5_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_5_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_5_memory_write_data <= to_unsigned(slice0cost_column_0(11), 11) & to_unsigned(slice0cost_column_0(10), 11);
  slice0window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_5_memory_read_enable,
      read_address => slice0window_leaving_5_memory_read_address, read_data => slice0window_leaving(5),
      write_address => slice0window_leaving_5_memory_write_address, write_data => slice0window_leaving_5_memory_write_data);

  slice0window_leaving_4_memory_read_enable <= true;
  slice0window_leaving_4_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_4_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_4_memory_write_data <= to_unsigned(slice0cost_column_0(9), 11) & to_unsigned(slice0cost_column_0(8), 11);
  slice0window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_4_memory_read_enable,
      read_address => slice0window_leaving_4_memory_read_address, read_data => slice0window_leaving(4),
      write_address => slice0window_leaving_4_memory_write_address, write_data => slice0window_leaving_4_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0(7), 11) & to_unsigned(slice0cost_column_0(6), 11);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving(3),
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0(5), 11) & to_unsigned(slice0cost_column_0(4), 11);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving(2),
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0(3), 11) & to_unsigned(slice0cost_column_0(2), 11);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving(1),
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0(1), 11) & to_unsigned(slice0cost_column_0(0), 11);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving(0),
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_12_memory_read_enable <= true;
  slice0cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_12_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_12_memory_write_data <= to_unsigned(slice0cost_write_words_12, 11);
  slice0cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 640, width => 11, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_12_memory_read_enable,
      read_address => slice0cost_read_words_12_memory_read_address, read_data => slice0cost_read_words_12,
      write_address => slice0cost_read_words_12_memory_write_address, write_data => slice0cost_read_words_12_memory_write_data);

  slice0cost_read_words_11_memory_read_enable <= true;
  slice0cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_11_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_11_memory_write_data <= to_unsigned(slice0cost_write_words(11), 22);
  slice0cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_11_memory_read_enable,
      read_address => slice0cost_read_words_11_memory_read_address, read_data => slice0cost_read_words(11),
      write_address => slice0cost_read_words_11_memory_write_address, write_data => slice0cost_read_words_11_memory_write_data);

  slice0cost_read_words_10_memory_read_enable <= true;
  slice0cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_10_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_10_memory_write_data <= to_unsigned(slice0cost_write_words(10), 22);
  slice0cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_10_memory_read_enable,
      read_address => slice0cost_read_words_10_memory_read_address, read_data => slice0cost_read_words(10),
      write_address => slice0cost_read_words_10_memory_write_address, write_data => slice0cost_read_words_10_memory_write_data);

  slice0cost_read_words_9_memory_read_enable <= true;
  slice0cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_9_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_9_memory_write_data <= to_unsigned(slice0cost_write_words(9), 22);
  slice0cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_9_memory_read_enable,
      read_address => slice0cost_read_words_9_memory_read_address, read_data => slice0cost_read_words(9),
      write_address => slice0cost_read_words_9_memory_write_address, write_data => slice0cost_read_words_9_memory_write_data);

  slice0cost_read_words_8_memory_read_enable <= true;
  slice0cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_8_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_8_memory_write_data <= to_unsigned(slice0cost_write_words(8), 22);
  slice0cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_8_memory_read_enable,
      read_address => slice0cost_read_words_8_memory_read_address, read_data => slice0cost_read_words(8),
      write_address => slice0cost_read_words_8_memory_write_address, write_data => slice0cost_read_words_8_memory_write_data);

  slice0cost_read_words_7_memory_read_enable <= true;
  slice0cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_7_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_7_memory_write_data <= to_unsigned(slice0cost_write_words(7), 22);
  slice0cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_7_memory_read_enable,
      read_address => slice0cost_read_words_7_memory_read_address, read_data => slice0cost_read_words(7),
      write_address => slice0cost_read_words_7_memory_write_address, write_data => slice0cost_read_words_7_memory_write_data);

  slice0cost_read_words_6_memory_read_enable <= true;
  slice0cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_6_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_6_memory_write_data <= to_unsigned(slice0cost_write_words(6), 22);
  slice0cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_6_memory_read_enable,
      read_address => slice0cost_read_words_6_memory_read_address, read_data => slice0cost_read_words(6),
      write_address => slice0cost_read_words_6_memory_write_address, write_data => slice0cost_read_words_6_memory_write_data);

  slice0cost_read_words_5_memory_read_enable <= true;
  slice0cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_5_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_5_memory_write_data <= to_unsigned(slice0cost_write_words(5), 22);
  slice0cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_5_memory_read_enable,
      read_address => slice0cost_read_words_5_memory_read_address, read_data => slice0cost_read_words(5),
      write_address => slice0cost_read_words_5_memory_write_address, write_data => slice0cost_read_words_5_memory_write_data);

  slice0cost_read_words_4_memory_read_enable <= true;
  slice0cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_4_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_4_memory_write_data <= to_unsigned(slice0cost_write_words(4), 22);
  slice0cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_4_memory_read_enable,
      read_address => slice0cost_read_words_4_memory_read_address, read_data => slice0cost_read_words(4),
      write_address => slice0cost_read_words_4_memory_write_address, write_data => slice0cost_read_words_4_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words(3), 22);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words(3),
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words(2), 22);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words(2),
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words(1), 22);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words(1),
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 10);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice3cost_read_column, 10);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words(0), 22);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words(0),
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 24, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_0_memory_write_data <= rows_search_rows_write_words_0;
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 24, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_0_memory_write_data <= rows_reference_rows_write_words_0;
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 8);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 8);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 8);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 200, width => 8, address_bits => 8)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal : boolean;
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice0winner1_best_cost_0_#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice0winner2_best_cost_0_#_is_less
    variable slice0winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice0winner3_best_cost_0_#_is_less
    variable slice0winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice0winner4_best_cost_0_#_is_less
    variable slice0winner5_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice1winner1_best_cost_0_#_is_less
    variable slice1winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice1winner2_best_cost_0_#_is_less
    variable slice1winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice1winner3_best_cost_0_#_is_less
    variable slice1winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice1winner4_best_cost_0_#_is_less
    variable slice1winner5_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice2winner1_best_cost_0_#_is_less
    variable slice2winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice2winner2_best_cost_0_#_is_less
    variable slice2winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice2winner3_best_cost_0_#_is_less
    variable slice2winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice2winner4_best_cost_0_#_is_less
    variable slice2winner5_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less : boolean;
    variable slice3winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice3winner1_best_cost_0_#_is_less
    variable slice3winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice3winner2_best_cost_0_#_is_less
    variable slice3winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice3winner3_best_cost_0_#_is_less
    variable slice3winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice3winner4_best_cost_0_#_is_less
    variable slice3winner5_best_cost_0_0_is_less, slice3_best_cost_0_0_is_less : boolean;
    variable slice4winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice4winner1_best_cost_0_#_is_less
    variable slice4winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice4winner2_best_cost_0_#_is_less
    variable slice4winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice4winner3_best_cost_0_#_is_less
    variable slice4winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice4winner4_best_cost_0_#_is_less
    variable slice4winner5_best_cost_0_0_is_less, slice4_best_cost_0_0_is_less : boolean;
    variable slice5winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice5winner1_best_cost_0_#_is_less
    variable slice5winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice5winner2_best_cost_0_#_is_less
    variable slice5winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice5winner3_best_cost_0_#_is_less
    variable slice5winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice5winner4_best_cost_0_#_is_less
    variable slice5winner5_best_cost_0_0_is_less, slice5_best_cost_0_0_is_less : boolean;
    variable slice6winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice6winner1_best_cost_0_#_is_less
    variable slice6winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice6winner2_best_cost_0_#_is_less
    variable slice6winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice6winner3_best_cost_0_#_is_less
    variable slice6winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice6winner4_best_cost_0_#_is_less
    variable slice6winner5_best_cost_0_0_is_less, slice6_best_cost_0_0_is_less : boolean;
    variable slice7winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice7winner1_best_cost_0_#_is_less
    variable slice7winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice7winner2_best_cost_0_#_is_less
    variable slice7winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice7winner3_best_cost_0_#_is_less
    variable slice7winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice7winner4_best_cost_0_#_is_less
    variable slice7winner5_best_cost_0_0_is_less : boolean;
    variable slice0cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice0cost_column_0_#_choice
    variable slice0cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice0cost_column_0_#_choice_2
    variable slice0window_change_0_choice : natural_2047_1d(0 to 24);  -- slice0window_change_0_#_choice
    variable slice1cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice1cost_column_0_#_choice
    variable slice1cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice1cost_column_0_#_choice_2
    variable slice1window_change_0_choice : natural_2047_1d(0 to 24);  -- slice1window_change_0_#_choice
    variable slice2cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice2cost_column_0_#_choice
    variable slice2cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice2cost_column_0_#_choice_2
    variable slice2window_change_0_choice : natural_2047_1d(0 to 24);  -- slice2window_change_0_#_choice
    variable slice3cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice3cost_column_0_#_choice
    variable slice3cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice3cost_column_0_#_choice_2
    variable slice3window_change_0_choice : natural_2047_1d(0 to 24);  -- slice3window_change_0_#_choice
    variable slice4cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice4cost_column_0_#_choice
    variable slice4cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice4cost_column_0_#_choice_2
    variable slice4window_change_0_choice : natural_2047_1d(0 to 24);  -- slice4window_change_0_#_choice
    variable slice5cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice5cost_column_0_#_choice
    variable slice5cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice5cost_column_0_#_choice_2
    variable slice5window_change_0_choice : natural_2047_1d(0 to 24);  -- slice5window_change_0_#_choice
    variable slice6cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice6cost_column_0_#_choice
    variable slice6cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice6cost_column_0_#_choice_2
    variable slice6window_change_0_choice : natural_2047_1d(0 to 24);  -- slice6window_change_0_#_choice
    variable slice7cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice7cost_column_0_#_choice
    variable slice7cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice7cost_column_0_#_choice_2
    variable slice7window_change_0_choice : natural_2047_1d(0 to 24);  -- slice7window_change_0_#_choice
    variable slice0window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice0window_sum_0_#_choice
    variable slice1window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice1window_sum_0_#_choice
    variable slice2window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice2window_sum_0_#_choice
    variable slice3window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice3window_sum_0_#_choice
    variable slice4window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice4window_sum_0_#_choice
    variable slice5window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice5window_sum_0_#_choice
    variable slice6window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice6window_sum_0_#_choice
    variable slice7window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice7window_sum_0_#_choice
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 639;
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 483) and
          raster_place_group_is_equal and in_valid))) mod 512;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 1024;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 199 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 256;
        end if;
      end if;
      delay_tag_first_cost_is_equal := raster_place_column = 199;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (raster_place_group >= 7) and (raster_place_group < 487);
      delay_row_inside(1) <= raster_place_group < 480;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 199;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_leaves_window <= (((((raster_place_column / 2) + 32665) mod 32768) * 2) + (raster_place_column mod 2))
        < 65333;
      delay_tag_output_column <= (raster_place_group >= 3) and (raster_place_group < 483) and (raster_place_column >=
        199) and (raster_place_column < 639);
      delay_tag_start_of_frame <= (raster_place_group = 3) and delay_tag_first_cost_is_equal;
      delay_tag_end_of_line <= raster_place_column = 638;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
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
        rows_search(0) <= to_integer(rows_search_rows_ready_words_0(7 downto 0));
        rows_reference(0) <= to_integer(rows_reference_rows_ready_words_0(7 downto 0));
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
        rows_search_rows_write_words_0 <= to_unsigned((rows_search_rows_ready_words_1 mod 256), 8) &
          rows_search_rows_ready_words_0(31 downto 8);
        rows_search_rows_write_words_1 <= (rows_search_rows_ready_newest_0 * 65536) + ((rows_search_rows_ready_words_1
          / 65536) * 256) + ((rows_search_rows_ready_words_1 mod 65536) / 256);
        rows_reference_rows_write_words_0 <= to_unsigned((rows_reference_rows_ready_words_1 mod 256), 8) &
          rows_reference_rows_ready_words_0(31 downto 8);
        rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_newest_0 * 65536) +
          ((rows_reference_rows_ready_words_1 / 65536) * 256) + ((rows_reference_rows_ready_words_1 mod 65536) / 256);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice0shift_search(i, j) <= slice0shift_search(i, j + 1);
          end loop;
          slice0shift_search(i, 24) <= rows_search(i);
        end loop;
      end if;
      slice0shift_reference(0) <= rows_reference(0);
      slice0shift_reference(1) <= rows_reference(1);
      slice0shift_search_out(0) <= slice0shift_search(0, 0);
      slice0shift_search_out(1) <= slice0shift_search(1, 0);
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
      for i in 0 to 11 loop
        if slice0cost_ready_tag_first_group then
          slice0cost_column_0_choice(2 * i) := 0;
        else
          slice0cost_column_0_choice(2 * i) := slice0cost_ready_words(i) mod 2048;
        end if;
        if slice0cost_ready_tag_border_column then
          slice0cost_column_0_choice_2(2 * i) := 0;
        else
          slice0cost_column_0_choice_2(2 * i) := (slice0cost_change_0(2 * i) + slice0cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice0cost_ready_tag_first_group then
          slice0cost_column_0_choice(2 * i + 1) := 0;
        else
          slice0cost_column_0_choice(2 * i + 1) := slice0cost_ready_words(i) / 2048;
        end if;
        if slice0cost_ready_tag_border_column then
          slice0cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice0cost_column_0_choice_2(2 * i + 1) := (slice0cost_change_0(2 * i + 1) + slice0cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_choice(24) := 0;
      else
        slice0cost_column_0_choice(24) := slice0cost_ready_words_12;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_choice_2(24) := 0;
      else
        slice0cost_column_0_choice_2(24) := (slice0cost_change_0(24) + slice0cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
      end loop;
      for i in 0 to 24 loop
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
        for j in 0 to 24 loop
          slice0cost_pixels_cost(i, j) <= (folded(slice0cost_pixels_first(i, j)) +
            as_number((slice0cost_pixels_first(i, j) < 0))) mod 256;
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
      for i in 0 to 24 loop
        slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i));
      end loop;
      slice0cost_ready_words_12 <= to_integer(slice0cost_read_words_12);
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      for i in 0 to 24 loop
        slice0cost_column_0(i) <= slice0cost_column_0_choice_2(i);
      end loop;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_row_start <= slice0cost_ready_tag_row_start;
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
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 1024;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 1024;
        end if;
      end if;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice0cost_ready_column <= 0;
        else
          slice0cost_ready_column <= (slice0cost_ready_column + 1) mod 1024;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        for i in 0 to 11 loop
          slice0cost_write_words(i) <= (slice0cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice0cost_column_0_choice_2(2 * i);
        end loop;
        slice0cost_write_words_12 <= slice0cost_column_0_choice_2(24);
        if slice0cost_ready_tag_row_start then
          slice0cost_write_column <= 0;
        else
          slice0cost_write_column <= (slice0cost_write_column + 1) mod 1024;
        end if;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 7 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(4 * i + j) := to_integer(slice0window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice0window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice0window_entering_tag_leaves_window then
            slice0window_change_0_choice(4 * i + j) := to_integer(slice0window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice0window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_choice(24) := to_integer(slice0window_leaving_12);
      else
        slice0window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice0window_entering_0(i) <= slice0cost_column_0(i);
      end loop;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_row_start <= slice0cost_tag_row_start;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_border_column <= slice0cost_tag_border_column;
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      for i in 0 to 24 loop
        slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
      end loop;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_row_start <= slice0window_entering_tag_row_start;
      slice0window_change_tag_first_group <= slice0window_entering_tag_first_group;
      slice0window_change_tag_border_column <= slice0window_entering_tag_border_column;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column(0) <= slice0window_change_tag_output_column;
      slice0window_centre_output_column(1) <= slice0window_centre_output_column(0);
      slice0window_centre_first_column_0 <= slice0window_change_tag_first_cost;
      slice0window_centre_start_of_frame(0) <= slice0window_change_tag_start_of_frame;
      slice0window_centre_start_of_frame(1) <= slice0window_centre_start_of_frame(0);
      slice0window_centre_start_of_frame(2) <= slice0window_centre_start_of_frame(1);
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame(2);
      for i in 0 to 24 loop
        if slice0window_change_tag_first_cost then
          slice0window_sum_0_choice(i) := 0;
        else
          slice0window_sum_0_choice(i) := slice0window_sum_0(i);
        end if;
      end loop;
      if slice0window_change_tag_valid then
        for i in 0 to 24 loop
          slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice0winner1
      for i in 0 to 11 loop
        slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
      end loop;
      slice0winner1_best_cost_0(12) <= slice0window_sum_0(24);
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
      slice0winner1_best_index_0_12 <= 24;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      if slice0winner1_best_cost_0_is_less(0) then
        slice0winner1_best_cost_0(0) <= slice0window_sum_0(1);
      else
        slice0winner1_best_cost_0(0) <= slice0window_sum_0(0);
      end if;
      if slice0winner1_best_cost_0_is_less(1) then
        slice0winner1_best_cost_0(1) <= slice0window_sum_0(3);
        slice0winner1_best_index_0_1 <= 3;
      else
        slice0winner1_best_cost_0(1) <= slice0window_sum_0(2);
        slice0winner1_best_index_0_1 <= 2;
      end if;
      if slice0winner1_best_cost_0_is_less(2) then
        slice0winner1_best_cost_0(2) <= slice0window_sum_0(5);
        slice0winner1_best_index_0_2 <= 5;
      else
        slice0winner1_best_cost_0(2) <= slice0window_sum_0(4);
        slice0winner1_best_index_0_2 <= 4;
      end if;
      if slice0winner1_best_cost_0_is_less(3) then
        slice0winner1_best_cost_0(3) <= slice0window_sum_0(7);
        slice0winner1_best_index_0_3 <= 7;
      else
        slice0winner1_best_cost_0(3) <= slice0window_sum_0(6);
        slice0winner1_best_index_0_3 <= 6;
      end if;
      if slice0winner1_best_cost_0_is_less(4) then
        slice0winner1_best_cost_0(4) <= slice0window_sum_0(9);
        slice0winner1_best_index_0_4 <= 9;
      else
        slice0winner1_best_cost_0(4) <= slice0window_sum_0(8);
        slice0winner1_best_index_0_4 <= 8;
      end if;
      if slice0winner1_best_cost_0_is_less(5) then
        slice0winner1_best_cost_0(5) <= slice0window_sum_0(11);
        slice0winner1_best_index_0_5 <= 11;
      else
        slice0winner1_best_cost_0(5) <= slice0window_sum_0(10);
        slice0winner1_best_index_0_5 <= 10;
      end if;
      if slice0winner1_best_cost_0_is_less(6) then
        slice0winner1_best_cost_0(6) <= slice0window_sum_0(13);
        slice0winner1_best_index_0_6 <= 13;
      else
        slice0winner1_best_cost_0(6) <= slice0window_sum_0(12);
        slice0winner1_best_index_0_6 <= 12;
      end if;
      if slice0winner1_best_cost_0_is_less(7) then
        slice0winner1_best_cost_0(7) <= slice0window_sum_0(15);
        slice0winner1_best_index_0_7 <= 15;
      else
        slice0winner1_best_cost_0(7) <= slice0window_sum_0(14);
        slice0winner1_best_index_0_7 <= 14;
      end if;
      if slice0winner1_best_cost_0_is_less(8) then
        slice0winner1_best_cost_0(8) <= slice0window_sum_0(17);
        slice0winner1_best_index_0_8 <= 17;
      else
        slice0winner1_best_cost_0(8) <= slice0window_sum_0(16);
        slice0winner1_best_index_0_8 <= 16;
      end if;
      if slice0winner1_best_cost_0_is_less(9) then
        slice0winner1_best_cost_0(9) <= slice0window_sum_0(19);
        slice0winner1_best_index_0_9 <= 19;
      else
        slice0winner1_best_cost_0(9) <= slice0window_sum_0(18);
        slice0winner1_best_index_0_9 <= 18;
      end if;
      if slice0winner1_best_cost_0_is_less(10) then
        slice0winner1_best_cost_0(10) <= slice0window_sum_0(21);
        slice0winner1_best_index_0_10 <= 21;
      else
        slice0winner1_best_cost_0(10) <= slice0window_sum_0(20);
        slice0winner1_best_index_0_10 <= 20;
      end if;
      if slice0winner1_best_cost_0_is_less(11) then
        slice0winner1_best_cost_0(11) <= slice0window_sum_0(23);
        slice0winner1_best_index_0_11 <= 23;
      else
        slice0winner1_best_cost_0(11) <= slice0window_sum_0(22);
        slice0winner1_best_index_0_11 <= 22;
      end if;
      -- slice0winner2
      for i in 0 to 5 loop
        slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice0winner2_best_cost_0(6) <= slice0winner1_best_cost_0(12);
      slice0winner2_best_index_0_6 <= slice0winner1_best_index_0_12;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      if slice0winner2_best_cost_0_is_less(0) then
        slice0winner2_best_cost_0(0) <= slice0winner1_best_cost_0(1);
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_0(0) <= slice0winner1_best_cost_0(0);
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
      end if;
      if slice0winner2_best_cost_0_is_less(1) then
        slice0winner2_best_cost_0(1) <= slice0winner1_best_cost_0(3);
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
      else
        slice0winner2_best_cost_0(1) <= slice0winner1_best_cost_0(2);
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
      end if;
      if slice0winner2_best_cost_0_is_less(2) then
        slice0winner2_best_cost_0(2) <= slice0winner1_best_cost_0(5);
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
      else
        slice0winner2_best_cost_0(2) <= slice0winner1_best_cost_0(4);
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
      end if;
      if slice0winner2_best_cost_0_is_less(3) then
        slice0winner2_best_cost_0(3) <= slice0winner1_best_cost_0(7);
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
      else
        slice0winner2_best_cost_0(3) <= slice0winner1_best_cost_0(6);
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_6;
      end if;
      if slice0winner2_best_cost_0_is_less(4) then
        slice0winner2_best_cost_0(4) <= slice0winner1_best_cost_0(9);
        slice0winner2_best_index_0_4 <= slice0winner1_best_index_0_9;
      else
        slice0winner2_best_cost_0(4) <= slice0winner1_best_cost_0(8);
        slice0winner2_best_index_0_4 <= slice0winner1_best_index_0_8;
      end if;
      if slice0winner2_best_cost_0_is_less(5) then
        slice0winner2_best_cost_0(5) <= slice0winner1_best_cost_0(11);
        slice0winner2_best_index_0_5 <= slice0winner1_best_index_0_11;
      else
        slice0winner2_best_cost_0(5) <= slice0winner1_best_cost_0(10);
        slice0winner2_best_index_0_5 <= slice0winner1_best_index_0_10;
      end if;
      -- slice0winner3
      for i in 0 to 2 loop
        slice0winner3_best_cost_0_is_less(i) := (slice0winner2_best_cost_0(2 * i + 1) - slice0winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice0winner3_best_cost_0(3) <= slice0winner2_best_cost_0(6);
      slice0winner3_best_index_0_3 <= slice0winner2_best_index_0_6;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      if slice0winner3_best_cost_0_is_less(0) then
        slice0winner3_best_cost_0(0) <= slice0winner2_best_cost_0(1);
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
      else
        slice0winner3_best_cost_0(0) <= slice0winner2_best_cost_0(0);
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
      end if;
      if slice0winner3_best_cost_0_is_less(1) then
        slice0winner3_best_cost_0(1) <= slice0winner2_best_cost_0(3);
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
      else
        slice0winner3_best_cost_0(1) <= slice0winner2_best_cost_0(2);
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
      end if;
      if slice0winner3_best_cost_0_is_less(2) then
        slice0winner3_best_cost_0(2) <= slice0winner2_best_cost_0(5);
        slice0winner3_best_index_0_2 <= slice0winner2_best_index_0_5;
      else
        slice0winner3_best_cost_0(2) <= slice0winner2_best_cost_0(4);
        slice0winner3_best_index_0_2 <= slice0winner2_best_index_0_4;
      end if;
      -- slice0winner4
      slice0winner4_best_cost_0_is_less(0) := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
      slice0winner4_best_cost_0_is_less(1) := (slice0winner3_best_cost_0(3) - slice0winner3_best_cost_0(2)) < 0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      if slice0winner4_best_cost_0_is_less(0) then
        slice0winner4_best_cost_0(0) <= slice0winner3_best_cost_0(1);
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
      else
        slice0winner4_best_cost_0(0) <= slice0winner3_best_cost_0(0);
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
      end if;
      if slice0winner4_best_cost_0_is_less(1) then
        slice0winner4_best_cost_0(1) <= slice0winner3_best_cost_0(3);
        slice0winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice0winner4_best_cost_0(1) <= slice0winner3_best_cost_0(2);
        slice0winner4_best_index_0_1 <= slice0winner3_best_index_0_2;
      end if;
      if slice0_best_tag_valid then
        slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      end if;
      -- slice0winner5
      slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0(1) - slice0winner4_best_cost_0(0)) < 0;
      slice0winner5_tag_valid <= slice0winner4_tag_valid;
      if slice0winner5_best_cost_0_0_is_less then
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0(1);
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_1;
      else
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0(0);
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_0;
      end if;
      if slice0_best_tag_valid then
        slice0winner5_tag_start_of_frame <= slice0winner4_tag_start_of_frame;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 175;
      slice0_best_tag_valid <= slice0winner5_tag_valid;
      if slice0_best_tag_valid then
        slice0_best_tag_output_column <= slice7window_centre_output_column_1;
        slice0_best_tag_start_of_frame <= slice0winner5_tag_start_of_frame;
        slice0_best_tag_end_of_line <= slice7window_centre_end_of_line(1);
      end if;
      -- slice1shift
      if slice0shift_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice1shift_search(i, j) <= slice1shift_search(i, j + 1);
          end loop;
          slice1shift_search(i, 24) <= slice0shift_search_out(i);
        end loop;
      end if;
      slice1shift_reference(0) <= slice0shift_reference(0);
      slice1shift_reference(1) <= slice0shift_reference(1);
      slice1shift_search_out(0) <= slice1shift_search(0, 0);
      slice1shift_search_out(1) <= slice1shift_search(1, 0);
      -- slice1cost
      for i in 0 to 11 loop
        if slice0cost_tag_first_group then
          slice1cost_column_0_choice(2 * i) := 0;
        else
          slice1cost_column_0_choice(2 * i) := slice1cost_ready_words(i) mod 2048;
        end if;
        if slice0cost_tag_border_column then
          slice1cost_column_0_choice_2(2 * i) := 0;
        else
          slice1cost_column_0_choice_2(2 * i) := (slice1cost_change_0(2 * i) + slice1cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice0cost_tag_first_group then
          slice1cost_column_0_choice(2 * i + 1) := 0;
        else
          slice1cost_column_0_choice(2 * i + 1) := slice1cost_ready_words(i) / 2048;
        end if;
        if slice0cost_tag_border_column then
          slice1cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice1cost_column_0_choice_2(2 * i + 1) := (slice1cost_change_0(2 * i + 1) + slice1cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice0cost_tag_first_group then
        slice1cost_column_0_choice(24) := 0;
      else
        slice1cost_column_0_choice(24) := slice1cost_ready_words_12;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_choice_2(24) := 0;
      else
        slice1cost_column_0_choice_2(24) := (slice1cost_change_0(24) + slice1cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice1cost_pixels_cost(i, j) <= (folded(slice1cost_pixels_first(i, j)) +
            as_number((slice1cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice0cost_change_column;
      for i in 0 to 24 loop
        slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i));
      end loop;
      slice1cost_ready_words_12 <= to_integer(slice1cost_read_words_12);
      slice1cost_ready_column <= slice0cost_ready_column;
      for i in 0 to 24 loop
        slice1cost_column_0(i) <= slice1cost_column_0_choice_2(i);
      end loop;
      if slice0cost_tag_valid then
        for i in 0 to 11 loop
          slice1cost_write_words(i) <= (slice1cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice1cost_column_0_choice_2(2 * i);
        end loop;
        slice1cost_write_words_12 <= slice1cost_column_0_choice_2(24);
        if slice0cost_tag_row_start then
          slice1cost_write_column <= 0;
        else
          slice1cost_write_column <= (slice1cost_write_column + 1) mod 1024;
        end if;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 7 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(4 * i + j) := to_integer(slice1window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice1window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice0window_change_tag_leaves_window then
            slice1window_change_0_choice(4 * i + j) := to_integer(slice1window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice1window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_choice(24) := to_integer(slice1window_leaving_12);
      else
        slice1window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice1window_entering_0(i) <= slice1cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
      end loop;
      slice1window_change_tag_row_start <= slice0window_change_tag_row_start;
      slice1window_change_tag_first_group <= slice0window_change_tag_first_group;
      slice1window_change_tag_border_column <= slice0window_change_tag_border_column;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_output_column_1 <= slice0window_centre_output_column(1);
      slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice0window_centre_first_column_0 then
          slice1window_sum_0_choice(i) := 0;
        else
          slice1window_sum_0_choice(i) := slice1window_sum_0(i);
        end if;
      end loop;
      if slice0window_tag_valid then
        for i in 0 to 24 loop
          slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice1winner1
      for i in 0 to 11 loop
        slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
      end loop;
      slice1winner1_best_cost_0(12) <= slice1window_sum_0(24);
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
      if slice1winner1_best_cost_0_is_less(0) then
        slice1winner1_best_cost_0(0) <= slice1window_sum_0(1);
      else
        slice1winner1_best_cost_0(0) <= slice1window_sum_0(0);
      end if;
      if slice1winner1_best_cost_0_is_less(1) then
        slice1winner1_best_cost_0(1) <= slice1window_sum_0(3);
        slice1winner1_best_index_0_1 <= 3;
      else
        slice1winner1_best_cost_0(1) <= slice1window_sum_0(2);
        slice1winner1_best_index_0_1 <= 2;
      end if;
      if slice1winner1_best_cost_0_is_less(2) then
        slice1winner1_best_cost_0(2) <= slice1window_sum_0(5);
        slice1winner1_best_index_0_2 <= 5;
      else
        slice1winner1_best_cost_0(2) <= slice1window_sum_0(4);
        slice1winner1_best_index_0_2 <= 4;
      end if;
      if slice1winner1_best_cost_0_is_less(3) then
        slice1winner1_best_cost_0(3) <= slice1window_sum_0(7);
        slice1winner1_best_index_0_3 <= 7;
      else
        slice1winner1_best_cost_0(3) <= slice1window_sum_0(6);
        slice1winner1_best_index_0_3 <= 6;
      end if;
      if slice1winner1_best_cost_0_is_less(4) then
        slice1winner1_best_cost_0(4) <= slice1window_sum_0(9);
        slice1winner1_best_index_0_4 <= 9;
      else
        slice1winner1_best_cost_0(4) <= slice1window_sum_0(8);
        slice1winner1_best_index_0_4 <= 8;
      end if;
      if slice1winner1_best_cost_0_is_less(5) then
        slice1winner1_best_cost_0(5) <= slice1window_sum_0(11);
        slice1winner1_best_index_0_5 <= 11;
      else
        slice1winner1_best_cost_0(5) <= slice1window_sum_0(10);
        slice1winner1_best_index_0_5 <= 10;
      end if;
      if slice1winner1_best_cost_0_is_less(6) then
        slice1winner1_best_cost_0(6) <= slice1window_sum_0(13);
        slice1winner1_best_index_0_6 <= 13;
      else
        slice1winner1_best_cost_0(6) <= slice1window_sum_0(12);
        slice1winner1_best_index_0_6 <= 12;
      end if;
      if slice1winner1_best_cost_0_is_less(7) then
        slice1winner1_best_cost_0(7) <= slice1window_sum_0(15);
        slice1winner1_best_index_0_7 <= 15;
      else
        slice1winner1_best_cost_0(7) <= slice1window_sum_0(14);
        slice1winner1_best_index_0_7 <= 14;
      end if;
      if slice1winner1_best_cost_0_is_less(8) then
        slice1winner1_best_cost_0(8) <= slice1window_sum_0(17);
        slice1winner1_best_index_0_8 <= 17;
      else
        slice1winner1_best_cost_0(8) <= slice1window_sum_0(16);
        slice1winner1_best_index_0_8 <= 16;
      end if;
      if slice1winner1_best_cost_0_is_less(9) then
        slice1winner1_best_cost_0(9) <= slice1window_sum_0(19);
        slice1winner1_best_index_0_9 <= 19;
      else
        slice1winner1_best_cost_0(9) <= slice1window_sum_0(18);
        slice1winner1_best_index_0_9 <= 18;
      end if;
      if slice1winner1_best_cost_0_is_less(10) then
        slice1winner1_best_cost_0(10) <= slice1window_sum_0(21);
        slice1winner1_best_index_0_10 <= 21;
      else
        slice1winner1_best_cost_0(10) <= slice1window_sum_0(20);
        slice1winner1_best_index_0_10 <= 20;
      end if;
      if slice1winner1_best_cost_0_is_less(11) then
        slice1winner1_best_cost_0(11) <= slice1window_sum_0(23);
        slice1winner1_best_index_0_11 <= 23;
      else
        slice1winner1_best_cost_0(11) <= slice1window_sum_0(22);
        slice1winner1_best_index_0_11 <= 22;
      end if;
      -- slice1winner2
      for i in 0 to 5 loop
        slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice1winner2_best_cost_0(6) <= slice1winner1_best_cost_0(12);
      if slice1winner2_best_cost_0_is_less(0) then
        slice1winner2_best_cost_0(0) <= slice1winner1_best_cost_0(1);
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0(0) <= slice1winner1_best_cost_0(0);
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
      end if;
      if slice1winner2_best_cost_0_is_less(1) then
        slice1winner2_best_cost_0(1) <= slice1winner1_best_cost_0(3);
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
      else
        slice1winner2_best_cost_0(1) <= slice1winner1_best_cost_0(2);
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
      end if;
      if slice1winner2_best_cost_0_is_less(2) then
        slice1winner2_best_cost_0(2) <= slice1winner1_best_cost_0(5);
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
      else
        slice1winner2_best_cost_0(2) <= slice1winner1_best_cost_0(4);
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
      end if;
      if slice1winner2_best_cost_0_is_less(3) then
        slice1winner2_best_cost_0(3) <= slice1winner1_best_cost_0(7);
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
      else
        slice1winner2_best_cost_0(3) <= slice1winner1_best_cost_0(6);
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_6;
      end if;
      if slice1winner2_best_cost_0_is_less(4) then
        slice1winner2_best_cost_0(4) <= slice1winner1_best_cost_0(9);
        slice1winner2_best_index_0_4 <= slice1winner1_best_index_0_9;
      else
        slice1winner2_best_cost_0(4) <= slice1winner1_best_cost_0(8);
        slice1winner2_best_index_0_4 <= slice1winner1_best_index_0_8;
      end if;
      if slice1winner2_best_cost_0_is_less(5) then
        slice1winner2_best_cost_0(5) <= slice1winner1_best_cost_0(11);
        slice1winner2_best_index_0_5 <= slice1winner1_best_index_0_11;
      else
        slice1winner2_best_cost_0(5) <= slice1winner1_best_cost_0(10);
        slice1winner2_best_index_0_5 <= slice1winner1_best_index_0_10;
      end if;
      -- slice1winner3
      for i in 0 to 2 loop
        slice1winner3_best_cost_0_is_less(i) := (slice1winner2_best_cost_0(2 * i + 1) - slice1winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice1winner3_best_cost_0(3) <= slice1winner2_best_cost_0(6);
      if slice1winner3_best_cost_0_is_less(0) then
        slice1winner3_best_cost_0(0) <= slice1winner2_best_cost_0(1);
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
      else
        slice1winner3_best_cost_0(0) <= slice1winner2_best_cost_0(0);
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
      end if;
      if slice1winner3_best_cost_0_is_less(1) then
        slice1winner3_best_cost_0(1) <= slice1winner2_best_cost_0(3);
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
      else
        slice1winner3_best_cost_0(1) <= slice1winner2_best_cost_0(2);
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
      end if;
      if slice1winner3_best_cost_0_is_less(2) then
        slice1winner3_best_cost_0(2) <= slice1winner2_best_cost_0(5);
        slice1winner3_best_index_0_2 <= slice1winner2_best_index_0_5;
      else
        slice1winner3_best_cost_0(2) <= slice1winner2_best_cost_0(4);
        slice1winner3_best_index_0_2 <= slice1winner2_best_index_0_4;
      end if;
      -- slice1winner4
      slice1winner4_best_cost_0_is_less(0) := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
      slice1winner4_best_cost_0_is_less(1) := (slice1winner3_best_cost_0(3) - slice1winner3_best_cost_0(2)) < 0;
      if slice1winner4_best_cost_0_is_less(0) then
        slice1winner4_best_cost_0(0) <= slice1winner3_best_cost_0(1);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
      else
        slice1winner4_best_cost_0(0) <= slice1winner3_best_cost_0(0);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
      end if;
      if slice1winner4_best_cost_0_is_less(1) then
        slice1winner4_best_cost_0(1) <= slice1winner3_best_cost_0(3);
        slice1winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice1winner4_best_cost_0(1) <= slice1winner3_best_cost_0(2);
        slice1winner4_best_index_0_1 <= slice1winner3_best_index_0_2;
      end if;
      -- slice1winner5
      slice1winner5_best_cost_0_0_is_less := (slice1winner4_best_cost_0(1) - slice1winner4_best_cost_0(0)) < 0;
      if slice1winner5_best_cost_0_0_is_less then
        slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0(1);
        slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_1;
      else
        slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0(0);
        slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_0;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner5_best_cost_0_0;
        slice1_best_index_0_0 <= (((slice1winner5_best_index_0_0 / 2) + 75) * 2) + (slice1winner5_best_index_0_0 mod 2);
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice2shift_search(i, j) <= slice2shift_search(i, j + 1);
          end loop;
          slice2shift_search(i, 24) <= slice1shift_search_out(i);
        end loop;
      end if;
      slice2shift_reference(0) <= slice1shift_reference(0);
      slice2shift_reference(1) <= slice1shift_reference(1);
      slice2shift_search_out(0) <= slice2shift_search(0, 0);
      slice2shift_search_out(1) <= slice2shift_search(1, 0);
      -- slice2cost
      for i in 0 to 11 loop
        if slice0window_entering_tag_first_group then
          slice2cost_column_0_choice(2 * i) := 0;
        else
          slice2cost_column_0_choice(2 * i) := slice2cost_ready_words(i) mod 2048;
        end if;
        if slice0window_entering_tag_border_column then
          slice2cost_column_0_choice_2(2 * i) := 0;
        else
          slice2cost_column_0_choice_2(2 * i) := (slice2cost_change_0(2 * i) + slice2cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice0window_entering_tag_first_group then
          slice2cost_column_0_choice(2 * i + 1) := 0;
        else
          slice2cost_column_0_choice(2 * i + 1) := slice2cost_ready_words(i) / 2048;
        end if;
        if slice0window_entering_tag_border_column then
          slice2cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice2cost_column_0_choice_2(2 * i + 1) := (slice2cost_change_0(2 * i + 1) + slice2cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_choice(24) := 0;
      else
        slice2cost_column_0_choice(24) := slice2cost_ready_words_12;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_choice_2(24) := 0;
      else
        slice2cost_column_0_choice_2(24) := (slice2cost_change_0(24) + slice2cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice2cost_pixels_first(0, i) <= slice2shift_search(0, i) - slice2shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice2cost_pixels_first(1, i) <= slice2shift_search(1, i) - slice2shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice2cost_pixels_cost(i, j) <= (folded(slice2cost_pixels_first(i, j)) +
            as_number((slice2cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice2cost_read_column <= slice1cost_read_column;
      slice2cost_change_column <= slice1cost_change_column;
      for i in 0 to 24 loop
        slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice2cost_ready_words(i) <= to_integer(slice2cost_read_words(i));
      end loop;
      slice2cost_ready_words_12 <= to_integer(slice2cost_read_words_12);
      slice2cost_ready_column <= slice0cost_write_column;
      for i in 0 to 24 loop
        slice2cost_column_0(i) <= slice2cost_column_0_choice_2(i);
      end loop;
      if slice0window_entering_tag_valid then
        for i in 0 to 11 loop
          slice2cost_write_words(i) <= (slice2cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice2cost_column_0_choice_2(2 * i);
        end loop;
        slice2cost_write_words_12 <= slice2cost_column_0_choice_2(24);
        if slice0window_entering_tag_row_start then
          slice2cost_write_column <= 0;
        else
          slice2cost_write_column <= (slice2cost_write_column + 1) mod 1024;
        end if;
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 7 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(4 * i + j) := to_integer(slice2window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice2window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice1window_change_tag_leaves_window then
            slice2window_change_0_choice(4 * i + j) := to_integer(slice2window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice2window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_choice(24) := to_integer(slice2window_leaving_12);
      else
        slice2window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice2window_entering_0(i) <= slice2cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
      end loop;
      slice2window_change_tag_first_group <= slice1window_change_tag_first_group;
      slice2window_change_tag_border_column <= slice1window_change_tag_border_column;
      slice2window_change_tag_leaves_window <= slice1window_change_tag_leaves_window;
      slice2window_centre_output_column_1 <= slice1window_centre_output_column_1;
      slice2window_centre_first_column_0 <= slice1window_centre_first_column_0;
      slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice1window_centre_first_column_0 then
          slice2window_sum_0_choice(i) := 0;
        else
          slice2window_sum_0_choice(i) := slice2window_sum_0(i);
        end if;
      end loop;
      if slice0winner1_tag_valid then
        for i in 0 to 24 loop
          slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice2winner1
      for i in 0 to 11 loop
        slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
      end loop;
      slice2winner1_best_cost_0(12) <= slice2window_sum_0(24);
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
      if slice2winner1_best_cost_0_is_less(0) then
        slice2winner1_best_cost_0(0) <= slice2window_sum_0(1);
      else
        slice2winner1_best_cost_0(0) <= slice2window_sum_0(0);
      end if;
      if slice2winner1_best_cost_0_is_less(1) then
        slice2winner1_best_cost_0(1) <= slice2window_sum_0(3);
        slice2winner1_best_index_0_1 <= 3;
      else
        slice2winner1_best_cost_0(1) <= slice2window_sum_0(2);
        slice2winner1_best_index_0_1 <= 2;
      end if;
      if slice2winner1_best_cost_0_is_less(2) then
        slice2winner1_best_cost_0(2) <= slice2window_sum_0(5);
        slice2winner1_best_index_0_2 <= 5;
      else
        slice2winner1_best_cost_0(2) <= slice2window_sum_0(4);
        slice2winner1_best_index_0_2 <= 4;
      end if;
      if slice2winner1_best_cost_0_is_less(3) then
        slice2winner1_best_cost_0(3) <= slice2window_sum_0(7);
        slice2winner1_best_index_0_3 <= 7;
      else
        slice2winner1_best_cost_0(3) <= slice2window_sum_0(6);
        slice2winner1_best_index_0_3 <= 6;
      end if;
      if slice2winner1_best_cost_0_is_less(4) then
        slice2winner1_best_cost_0(4) <= slice2window_sum_0(9);
        slice2winner1_best_index_0_4 <= 9;
      else
        slice2winner1_best_cost_0(4) <= slice2window_sum_0(8);
        slice2winner1_best_index_0_4 <= 8;
      end if;
      if slice2winner1_best_cost_0_is_less(5) then
        slice2winner1_best_cost_0(5) <= slice2window_sum_0(11);
        slice2winner1_best_index_0_5 <= 11;
      else
        slice2winner1_best_cost_0(5) <= slice2window_sum_0(10);
        slice2winner1_best_index_0_5 <= 10;
      end if;
      if slice2winner1_best_cost_0_is_less(6) then
        slice2winner1_best_cost_0(6) <= slice2window_sum_0(13);
        slice2winner1_best_index_0_6 <= 13;
      else
        slice2winner1_best_cost_0(6) <= slice2window_sum_0(12);
        slice2winner1_best_index_0_6 <= 12;
      end if;
      if slice2winner1_best_cost_0_is_less(7) then
        slice2winner1_best_cost_0(7) <= slice2window_sum_0(15);
        slice2winner1_best_index_0_7 <= 15;
      else
        slice2winner1_best_cost_0(7) <= slice2window_sum_0(14);
        slice2winner1_best_index_0_7 <= 14;
      end if;
      if slice2winner1_best_cost_0_is_less(8) then
        slice2winner1_best_cost_0(8) <= slice2window_sum_0(17);
        slice2winner1_best_index_0_8 <= 17;
      else
        slice2winner1_best_cost_0(8) <= slice2window_sum_0(16);
        slice2winner1_best_index_0_8 <= 16;
      end if;
      if slice2winner1_best_cost_0_is_less(9) then
        slice2winner1_best_cost_0(9) <= slice2window_sum_0(19);
        slice2winner1_best_index_0_9 <= 19;
      else
        slice2winner1_best_cost_0(9) <= slice2window_sum_0(18);
        slice2winner1_best_index_0_9 <= 18;
      end if;
      if slice2winner1_best_cost_0_is_less(10) then
        slice2winner1_best_cost_0(10) <= slice2window_sum_0(21);
        slice2winner1_best_index_0_10 <= 21;
      else
        slice2winner1_best_cost_0(10) <= slice2window_sum_0(20);
        slice2winner1_best_index_0_10 <= 20;
      end if;
      if slice2winner1_best_cost_0_is_less(11) then
        slice2winner1_best_cost_0(11) <= slice2window_sum_0(23);
        slice2winner1_best_index_0_11 <= 23;
      else
        slice2winner1_best_cost_0(11) <= slice2window_sum_0(22);
        slice2winner1_best_index_0_11 <= 22;
      end if;
      -- slice2winner2
      for i in 0 to 5 loop
        slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice2winner2_best_cost_0(6) <= slice2winner1_best_cost_0(12);
      if slice2winner2_best_cost_0_is_less(0) then
        slice2winner2_best_cost_0(0) <= slice2winner1_best_cost_0(1);
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
      else
        slice2winner2_best_cost_0(0) <= slice2winner1_best_cost_0(0);
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
      end if;
      if slice2winner2_best_cost_0_is_less(1) then
        slice2winner2_best_cost_0(1) <= slice2winner1_best_cost_0(3);
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
      else
        slice2winner2_best_cost_0(1) <= slice2winner1_best_cost_0(2);
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
      end if;
      if slice2winner2_best_cost_0_is_less(2) then
        slice2winner2_best_cost_0(2) <= slice2winner1_best_cost_0(5);
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
      else
        slice2winner2_best_cost_0(2) <= slice2winner1_best_cost_0(4);
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
      end if;
      if slice2winner2_best_cost_0_is_less(3) then
        slice2winner2_best_cost_0(3) <= slice2winner1_best_cost_0(7);
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
      else
        slice2winner2_best_cost_0(3) <= slice2winner1_best_cost_0(6);
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_6;
      end if;
      if slice2winner2_best_cost_0_is_less(4) then
        slice2winner2_best_cost_0(4) <= slice2winner1_best_cost_0(9);
        slice2winner2_best_index_0_4 <= slice2winner1_best_index_0_9;
      else
        slice2winner2_best_cost_0(4) <= slice2winner1_best_cost_0(8);
        slice2winner2_best_index_0_4 <= slice2winner1_best_index_0_8;
      end if;
      if slice2winner2_best_cost_0_is_less(5) then
        slice2winner2_best_cost_0(5) <= slice2winner1_best_cost_0(11);
        slice2winner2_best_index_0_5 <= slice2winner1_best_index_0_11;
      else
        slice2winner2_best_cost_0(5) <= slice2winner1_best_cost_0(10);
        slice2winner2_best_index_0_5 <= slice2winner1_best_index_0_10;
      end if;
      -- slice2winner3
      for i in 0 to 2 loop
        slice2winner3_best_cost_0_is_less(i) := (slice2winner2_best_cost_0(2 * i + 1) - slice2winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice2winner3_best_cost_0(3) <= slice2winner2_best_cost_0(6);
      if slice2winner3_best_cost_0_is_less(0) then
        slice2winner3_best_cost_0(0) <= slice2winner2_best_cost_0(1);
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
      else
        slice2winner3_best_cost_0(0) <= slice2winner2_best_cost_0(0);
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
      end if;
      if slice2winner3_best_cost_0_is_less(1) then
        slice2winner3_best_cost_0(1) <= slice2winner2_best_cost_0(3);
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
      else
        slice2winner3_best_cost_0(1) <= slice2winner2_best_cost_0(2);
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_2;
      end if;
      if slice2winner3_best_cost_0_is_less(2) then
        slice2winner3_best_cost_0(2) <= slice2winner2_best_cost_0(5);
        slice2winner3_best_index_0_2 <= slice2winner2_best_index_0_5;
      else
        slice2winner3_best_cost_0(2) <= slice2winner2_best_cost_0(4);
        slice2winner3_best_index_0_2 <= slice2winner2_best_index_0_4;
      end if;
      -- slice2winner4
      slice2winner4_best_cost_0_is_less(0) := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
      slice2winner4_best_cost_0_is_less(1) := (slice2winner3_best_cost_0(3) - slice2winner3_best_cost_0(2)) < 0;
      if slice2winner4_best_cost_0_is_less(0) then
        slice2winner4_best_cost_0(0) <= slice2winner3_best_cost_0(1);
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
      else
        slice2winner4_best_cost_0(0) <= slice2winner3_best_cost_0(0);
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
      end if;
      if slice2winner4_best_cost_0_is_less(1) then
        slice2winner4_best_cost_0(1) <= slice2winner3_best_cost_0(3);
        slice2winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice2winner4_best_cost_0(1) <= slice2winner3_best_cost_0(2);
        slice2winner4_best_index_0_1 <= slice2winner3_best_index_0_2;
      end if;
      -- slice2winner5
      slice2winner5_best_cost_0_0_is_less := (slice2winner4_best_cost_0(1) - slice2winner4_best_cost_0(0)) < 0;
      if slice2winner5_best_cost_0_0_is_less then
        slice2winner5_best_cost_0_0 <= slice2winner4_best_cost_0(1);
        slice2winner5_best_index_0_0 <= slice2winner4_best_index_0_1;
      else
        slice2winner5_best_cost_0_0 <= slice2winner4_best_cost_0(0);
        slice2winner5_best_index_0_0 <= slice2winner4_best_index_0_0;
      end if;
      -- slice2
      slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner5_best_cost_0_0) < 0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_cost_0_0_is_less then
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_cost_0_0 <= slice2winner5_best_cost_0_0;
        slice2_best_index_0_0 <= slice2winner5_best_index_0_0 + 125;
      end if;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice3shift_search(i, j) <= slice3shift_search(i, j + 1);
          end loop;
          slice3shift_search(i, 24) <= slice2shift_search_out(i);
        end loop;
      end if;
      slice3shift_reference(0) <= slice2shift_reference(0);
      slice3shift_reference(1) <= slice2shift_reference(1);
      slice3shift_search_out(0) <= slice3shift_search(0, 0);
      slice3shift_search_out(1) <= slice3shift_search(1, 0);
      -- slice3cost
      for i in 0 to 11 loop
        if slice0window_change_tag_first_group then
          slice3cost_column_0_choice(2 * i) := 0;
        else
          slice3cost_column_0_choice(2 * i) := slice3cost_ready_words(i) mod 2048;
        end if;
        if slice0window_change_tag_border_column then
          slice3cost_column_0_choice_2(2 * i) := 0;
        else
          slice3cost_column_0_choice_2(2 * i) := (slice3cost_change_0(2 * i) + slice3cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice0window_change_tag_first_group then
          slice3cost_column_0_choice(2 * i + 1) := 0;
        else
          slice3cost_column_0_choice(2 * i + 1) := slice3cost_ready_words(i) / 2048;
        end if;
        if slice0window_change_tag_border_column then
          slice3cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice3cost_column_0_choice_2(2 * i + 1) := (slice3cost_change_0(2 * i + 1) + slice3cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_choice(24) := 0;
      else
        slice3cost_column_0_choice(24) := slice3cost_ready_words_12;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_choice_2(24) := 0;
      else
        slice3cost_column_0_choice_2(24) := (slice3cost_change_0(24) + slice3cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice3cost_pixels_first(0, i) <= slice3shift_search(0, i) - slice3shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice3cost_pixels_first(1, i) <= slice3shift_search(1, i) - slice3shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice3cost_pixels_cost(i, j) <= (folded(slice3cost_pixels_first(i, j)) +
            as_number((slice3cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice3cost_change_column <= slice1cost_ready_column;
      for i in 0 to 24 loop
        slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice3cost_ready_words(i) <= to_integer(slice3cost_read_words(i));
      end loop;
      slice3cost_ready_words_12 <= to_integer(slice3cost_read_words_12);
      slice3cost_ready_column <= slice1cost_write_column;
      for i in 0 to 24 loop
        slice3cost_column_0(i) <= slice3cost_column_0_choice_2(i);
      end loop;
      slice3cost_write_column <= slice2cost_write_column;
      if slice0cost_ready_tag_valid then
        slice3cost_read_column <= slice2cost_read_column;
      end if;
      if slice0window_change_tag_valid then
        for i in 0 to 11 loop
          slice3cost_write_words(i) <= (slice3cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice3cost_column_0_choice_2(2 * i);
        end loop;
        slice3cost_write_words_12 <= slice3cost_column_0_choice_2(24);
      end if;
      -- slice3window
      if slice0window_tag_valid then
        slice3window_ring_write_address <= slice3window_ring_read_address;
        if slice3window_ring_read_address = 7 then
          slice3window_ring_read_address <= 0;
        else
          slice3window_ring_read_address <= (slice3window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice2window_change_tag_leaves_window then
            slice3window_change_0_choice(4 * i + j) := to_integer(slice3window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice3window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice2window_change_tag_leaves_window then
            slice3window_change_0_choice(4 * i + j) := to_integer(slice3window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice3window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_choice(24) := to_integer(slice3window_leaving_12);
      else
        slice3window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice3window_entering_0(i) <= slice3cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
      end loop;
      slice3window_change_tag_first_group <= slice2window_change_tag_first_group;
      slice3window_change_tag_border_column <= slice2window_change_tag_border_column;
      slice3window_change_tag_leaves_window <= slice2window_change_tag_leaves_window;
      slice3window_centre_output_column_1 <= slice2window_centre_output_column_1;
      slice3window_centre_first_column_0 <= slice2window_centre_first_column_0;
      slice3window_centre_end_of_line_0 <= slice2window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice2window_centre_first_column_0 then
          slice3window_sum_0_choice(i) := 0;
        else
          slice3window_sum_0_choice(i) := slice3window_sum_0(i);
        end if;
      end loop;
      if slice0winner2_tag_valid then
        for i in 0 to 24 loop
          slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice3winner1
      for i in 0 to 11 loop
        slice3winner1_best_cost_0_is_less(i) := (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0;
      end loop;
      slice3winner1_best_cost_0(12) <= slice3window_sum_0(24);
      slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_is_less(0);
      if slice3winner1_best_cost_0_is_less(0) then
        slice3winner1_best_cost_0(0) <= slice3window_sum_0(1);
      else
        slice3winner1_best_cost_0(0) <= slice3window_sum_0(0);
      end if;
      if slice3winner1_best_cost_0_is_less(1) then
        slice3winner1_best_cost_0(1) <= slice3window_sum_0(3);
        slice3winner1_best_index_0_1 <= 3;
      else
        slice3winner1_best_cost_0(1) <= slice3window_sum_0(2);
        slice3winner1_best_index_0_1 <= 2;
      end if;
      if slice3winner1_best_cost_0_is_less(2) then
        slice3winner1_best_cost_0(2) <= slice3window_sum_0(5);
        slice3winner1_best_index_0_2 <= 5;
      else
        slice3winner1_best_cost_0(2) <= slice3window_sum_0(4);
        slice3winner1_best_index_0_2 <= 4;
      end if;
      if slice3winner1_best_cost_0_is_less(3) then
        slice3winner1_best_cost_0(3) <= slice3window_sum_0(7);
        slice3winner1_best_index_0_3 <= 7;
      else
        slice3winner1_best_cost_0(3) <= slice3window_sum_0(6);
        slice3winner1_best_index_0_3 <= 6;
      end if;
      if slice3winner1_best_cost_0_is_less(4) then
        slice3winner1_best_cost_0(4) <= slice3window_sum_0(9);
        slice3winner1_best_index_0_4 <= 9;
      else
        slice3winner1_best_cost_0(4) <= slice3window_sum_0(8);
        slice3winner1_best_index_0_4 <= 8;
      end if;
      if slice3winner1_best_cost_0_is_less(5) then
        slice3winner1_best_cost_0(5) <= slice3window_sum_0(11);
        slice3winner1_best_index_0_5 <= 11;
      else
        slice3winner1_best_cost_0(5) <= slice3window_sum_0(10);
        slice3winner1_best_index_0_5 <= 10;
      end if;
      if slice3winner1_best_cost_0_is_less(6) then
        slice3winner1_best_cost_0(6) <= slice3window_sum_0(13);
        slice3winner1_best_index_0_6 <= 13;
      else
        slice3winner1_best_cost_0(6) <= slice3window_sum_0(12);
        slice3winner1_best_index_0_6 <= 12;
      end if;
      if slice3winner1_best_cost_0_is_less(7) then
        slice3winner1_best_cost_0(7) <= slice3window_sum_0(15);
        slice3winner1_best_index_0_7 <= 15;
      else
        slice3winner1_best_cost_0(7) <= slice3window_sum_0(14);
        slice3winner1_best_index_0_7 <= 14;
      end if;
      if slice3winner1_best_cost_0_is_less(8) then
        slice3winner1_best_cost_0(8) <= slice3window_sum_0(17);
        slice3winner1_best_index_0_8 <= 17;
      else
        slice3winner1_best_cost_0(8) <= slice3window_sum_0(16);
        slice3winner1_best_index_0_8 <= 16;
      end if;
      if slice3winner1_best_cost_0_is_less(9) then
        slice3winner1_best_cost_0(9) <= slice3window_sum_0(19);
        slice3winner1_best_index_0_9 <= 19;
      else
        slice3winner1_best_cost_0(9) <= slice3window_sum_0(18);
        slice3winner1_best_index_0_9 <= 18;
      end if;
      if slice3winner1_best_cost_0_is_less(10) then
        slice3winner1_best_cost_0(10) <= slice3window_sum_0(21);
        slice3winner1_best_index_0_10 <= 21;
      else
        slice3winner1_best_cost_0(10) <= slice3window_sum_0(20);
        slice3winner1_best_index_0_10 <= 20;
      end if;
      if slice3winner1_best_cost_0_is_less(11) then
        slice3winner1_best_cost_0(11) <= slice3window_sum_0(23);
        slice3winner1_best_index_0_11 <= 23;
      else
        slice3winner1_best_cost_0(11) <= slice3window_sum_0(22);
        slice3winner1_best_index_0_11 <= 22;
      end if;
      -- slice3winner2
      for i in 0 to 5 loop
        slice3winner2_best_cost_0_is_less(i) := (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice3winner2_best_cost_0(6) <= slice3winner1_best_cost_0(12);
      if slice3winner2_best_cost_0_is_less(0) then
        slice3winner2_best_cost_0(0) <= slice3winner1_best_cost_0(1);
        slice3winner2_best_index_0_0 <= slice3winner1_best_index_0_1;
      else
        slice3winner2_best_cost_0(0) <= slice3winner1_best_cost_0(0);
        slice3winner2_best_index_0_0 <= as_number(slice3winner1_best_index_0_0);
      end if;
      if slice3winner2_best_cost_0_is_less(1) then
        slice3winner2_best_cost_0(1) <= slice3winner1_best_cost_0(3);
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_3;
      else
        slice3winner2_best_cost_0(1) <= slice3winner1_best_cost_0(2);
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_2;
      end if;
      if slice3winner2_best_cost_0_is_less(2) then
        slice3winner2_best_cost_0(2) <= slice3winner1_best_cost_0(5);
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_5;
      else
        slice3winner2_best_cost_0(2) <= slice3winner1_best_cost_0(4);
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_4;
      end if;
      if slice3winner2_best_cost_0_is_less(3) then
        slice3winner2_best_cost_0(3) <= slice3winner1_best_cost_0(7);
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_7;
      else
        slice3winner2_best_cost_0(3) <= slice3winner1_best_cost_0(6);
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_6;
      end if;
      if slice3winner2_best_cost_0_is_less(4) then
        slice3winner2_best_cost_0(4) <= slice3winner1_best_cost_0(9);
        slice3winner2_best_index_0_4 <= slice3winner1_best_index_0_9;
      else
        slice3winner2_best_cost_0(4) <= slice3winner1_best_cost_0(8);
        slice3winner2_best_index_0_4 <= slice3winner1_best_index_0_8;
      end if;
      if slice3winner2_best_cost_0_is_less(5) then
        slice3winner2_best_cost_0(5) <= slice3winner1_best_cost_0(11);
        slice3winner2_best_index_0_5 <= slice3winner1_best_index_0_11;
      else
        slice3winner2_best_cost_0(5) <= slice3winner1_best_cost_0(10);
        slice3winner2_best_index_0_5 <= slice3winner1_best_index_0_10;
      end if;
      -- slice3winner3
      for i in 0 to 2 loop
        slice3winner3_best_cost_0_is_less(i) := (slice3winner2_best_cost_0(2 * i + 1) - slice3winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice3winner3_best_cost_0(3) <= slice3winner2_best_cost_0(6);
      if slice3winner3_best_cost_0_is_less(0) then
        slice3winner3_best_cost_0(0) <= slice3winner2_best_cost_0(1);
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_1;
      else
        slice3winner3_best_cost_0(0) <= slice3winner2_best_cost_0(0);
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_0;
      end if;
      if slice3winner3_best_cost_0_is_less(1) then
        slice3winner3_best_cost_0(1) <= slice3winner2_best_cost_0(3);
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_3;
      else
        slice3winner3_best_cost_0(1) <= slice3winner2_best_cost_0(2);
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_2;
      end if;
      if slice3winner3_best_cost_0_is_less(2) then
        slice3winner3_best_cost_0(2) <= slice3winner2_best_cost_0(5);
        slice3winner3_best_index_0_2 <= slice3winner2_best_index_0_5;
      else
        slice3winner3_best_cost_0(2) <= slice3winner2_best_cost_0(4);
        slice3winner3_best_index_0_2 <= slice3winner2_best_index_0_4;
      end if;
      -- slice3winner4
      slice3winner4_best_cost_0_is_less(0) := (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0;
      slice3winner4_best_cost_0_is_less(1) := (slice3winner3_best_cost_0(3) - slice3winner3_best_cost_0(2)) < 0;
      if slice3winner4_best_cost_0_is_less(0) then
        slice3winner4_best_cost_0(0) <= slice3winner3_best_cost_0(1);
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_1;
      else
        slice3winner4_best_cost_0(0) <= slice3winner3_best_cost_0(0);
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_0;
      end if;
      if slice3winner4_best_cost_0_is_less(1) then
        slice3winner4_best_cost_0(1) <= slice3winner3_best_cost_0(3);
        slice3winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice3winner4_best_cost_0(1) <= slice3winner3_best_cost_0(2);
        slice3winner4_best_index_0_1 <= slice3winner3_best_index_0_2;
      end if;
      -- slice3winner5
      slice3winner5_best_cost_0_0_is_less := (slice3winner4_best_cost_0(1) - slice3winner4_best_cost_0(0)) < 0;
      if slice3winner5_best_cost_0_0_is_less then
        slice3winner5_best_cost_0_0 <= slice3winner4_best_cost_0(1);
        slice3winner5_best_index_0_0 <= slice3winner4_best_index_0_1;
      else
        slice3winner5_best_cost_0_0 <= slice3winner4_best_cost_0(0);
        slice3winner5_best_index_0_0 <= slice3winner4_best_index_0_0;
      end if;
      -- slice3
      slice3_best_cost_0_0_is_less := (slice2_best_cost_0_0 - slice3winner5_best_cost_0_0) < 0;
      slice3_best_tag_valid <= slice2_best_tag_valid;
      slice3_best_tag_output_column <= slice2_best_tag_output_column;
      slice3_best_tag_start_of_frame <= slice2_best_tag_start_of_frame;
      slice3_best_tag_end_of_line <= slice2_best_tag_end_of_line;
      if slice3_best_cost_0_0_is_less then
        slice3_best_cost_0_0 <= slice2_best_cost_0_0;
        slice3_best_index_0_0 <= slice2_best_index_0_0;
      else
        slice3_best_cost_0_0 <= slice3winner5_best_cost_0_0;
        slice3_best_index_0_0 <= (((slice3winner5_best_index_0_0 / 4) + 25) * 4) + (slice3winner5_best_index_0_0 mod 4);
      end if;
      -- slice4shift
      if slice0cost_ready_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice4shift_search(i, j) <= slice4shift_search(i, j + 1);
          end loop;
          slice4shift_search(i, 24) <= slice3shift_search_out(i);
        end loop;
      end if;
      slice4shift_reference(0) <= slice3shift_reference(0);
      slice4shift_reference(1) <= slice3shift_reference(1);
      slice4shift_search_out(0) <= slice4shift_search(0, 0);
      slice4shift_search_out(1) <= slice4shift_search(1, 0);
      -- slice4cost
      for i in 0 to 11 loop
        if slice1window_change_tag_first_group then
          slice4cost_column_0_choice(2 * i) := 0;
        else
          slice4cost_column_0_choice(2 * i) := slice4cost_ready_words(i) mod 2048;
        end if;
        if slice1window_change_tag_border_column then
          slice4cost_column_0_choice_2(2 * i) := 0;
        else
          slice4cost_column_0_choice_2(2 * i) := (slice4cost_change_0(2 * i) + slice4cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice1window_change_tag_first_group then
          slice4cost_column_0_choice(2 * i + 1) := 0;
        else
          slice4cost_column_0_choice(2 * i + 1) := slice4cost_ready_words(i) / 2048;
        end if;
        if slice1window_change_tag_border_column then
          slice4cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice4cost_column_0_choice_2(2 * i + 1) := (slice4cost_change_0(2 * i + 1) + slice4cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_choice(24) := 0;
      else
        slice4cost_column_0_choice(24) := slice4cost_ready_words_12;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_choice_2(24) := 0;
      else
        slice4cost_column_0_choice_2(24) := (slice4cost_change_0(24) + slice4cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice4cost_pixels_first(0, i) <= slice4shift_search(0, i) - slice4shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice4cost_pixels_first(1, i) <= slice4shift_search(1, i) - slice4shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice4cost_pixels_cost(i, j) <= (folded(slice4cost_pixels_first(i, j)) +
            as_number((slice4cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice4cost_change_column <= slice2cost_ready_column;
      for i in 0 to 24 loop
        slice4cost_change_0(i) <= slice4cost_pixels_cost(1, i) - slice4cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice4cost_ready_words(i) <= to_integer(slice4cost_read_words(i));
      end loop;
      slice4cost_ready_words_12 <= to_integer(slice4cost_read_words_12);
      slice4cost_ready_column <= slice3cost_ready_column;
      for i in 0 to 24 loop
        slice4cost_column_0(i) <= slice4cost_column_0_choice_2(i);
      end loop;
      slice4cost_write_column <= slice3cost_write_column;
      if slice0cost_tag_valid then
        slice4cost_read_column <= slice2cost_change_column;
      end if;
      if slice0window_tag_valid then
        for i in 0 to 11 loop
          slice4cost_write_words(i) <= (slice4cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice4cost_column_0_choice_2(2 * i);
        end loop;
        slice4cost_write_words_12 <= slice4cost_column_0_choice_2(24);
      end if;
      -- slice4window
      if slice0winner1_tag_valid then
        slice4window_ring_write_address <= slice4window_ring_read_address;
        if slice4window_ring_read_address = 7 then
          slice4window_ring_read_address <= 0;
        else
          slice4window_ring_read_address <= (slice4window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice3window_change_tag_leaves_window then
            slice4window_change_0_choice(4 * i + j) := to_integer(slice4window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice4window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice3window_change_tag_leaves_window then
            slice4window_change_0_choice(4 * i + j) := to_integer(slice4window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice4window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_choice(24) := to_integer(slice4window_leaving_12);
      else
        slice4window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice4window_entering_0(i) <= slice4cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice4window_change_0(i) <= slice4window_entering_0(i) - slice4window_change_0_choice(i);
      end loop;
      slice4window_change_tag_first_group <= slice3window_change_tag_first_group;
      slice4window_change_tag_border_column <= slice3window_change_tag_border_column;
      slice4window_change_tag_leaves_window <= slice3window_change_tag_leaves_window;
      slice4window_centre_output_column_1 <= slice3window_centre_output_column_1;
      slice4window_centre_first_column_0 <= slice3window_centre_first_column_0;
      slice4window_centre_end_of_line_0 <= slice3window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice3window_centre_first_column_0 then
          slice4window_sum_0_choice(i) := 0;
        else
          slice4window_sum_0_choice(i) := slice4window_sum_0(i);
        end if;
      end loop;
      if slice0winner3_tag_valid then
        for i in 0 to 24 loop
          slice4window_sum_0(i) <= (slice4window_sum_0_choice(i) + slice4window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice4winner1
      for i in 0 to 11 loop
        slice4winner1_best_cost_0_is_less(i) := (slice4window_sum_0(2 * i + 1) - slice4window_sum_0(2 * i)) < 0;
      end loop;
      slice4winner1_best_cost_0(12) <= slice4window_sum_0(24);
      slice4winner1_best_index_0_0 <= slice4winner1_best_cost_0_is_less(0);
      if slice4winner1_best_cost_0_is_less(0) then
        slice4winner1_best_cost_0(0) <= slice4window_sum_0(1);
      else
        slice4winner1_best_cost_0(0) <= slice4window_sum_0(0);
      end if;
      if slice4winner1_best_cost_0_is_less(1) then
        slice4winner1_best_cost_0(1) <= slice4window_sum_0(3);
        slice4winner1_best_index_0_1 <= 3;
      else
        slice4winner1_best_cost_0(1) <= slice4window_sum_0(2);
        slice4winner1_best_index_0_1 <= 2;
      end if;
      if slice4winner1_best_cost_0_is_less(2) then
        slice4winner1_best_cost_0(2) <= slice4window_sum_0(5);
        slice4winner1_best_index_0_2 <= 5;
      else
        slice4winner1_best_cost_0(2) <= slice4window_sum_0(4);
        slice4winner1_best_index_0_2 <= 4;
      end if;
      if slice4winner1_best_cost_0_is_less(3) then
        slice4winner1_best_cost_0(3) <= slice4window_sum_0(7);
        slice4winner1_best_index_0_3 <= 7;
      else
        slice4winner1_best_cost_0(3) <= slice4window_sum_0(6);
        slice4winner1_best_index_0_3 <= 6;
      end if;
      if slice4winner1_best_cost_0_is_less(4) then
        slice4winner1_best_cost_0(4) <= slice4window_sum_0(9);
        slice4winner1_best_index_0_4 <= 9;
      else
        slice4winner1_best_cost_0(4) <= slice4window_sum_0(8);
        slice4winner1_best_index_0_4 <= 8;
      end if;
      if slice4winner1_best_cost_0_is_less(5) then
        slice4winner1_best_cost_0(5) <= slice4window_sum_0(11);
        slice4winner1_best_index_0_5 <= 11;
      else
        slice4winner1_best_cost_0(5) <= slice4window_sum_0(10);
        slice4winner1_best_index_0_5 <= 10;
      end if;
      if slice4winner1_best_cost_0_is_less(6) then
        slice4winner1_best_cost_0(6) <= slice4window_sum_0(13);
        slice4winner1_best_index_0_6 <= 13;
      else
        slice4winner1_best_cost_0(6) <= slice4window_sum_0(12);
        slice4winner1_best_index_0_6 <= 12;
      end if;
      if slice4winner1_best_cost_0_is_less(7) then
        slice4winner1_best_cost_0(7) <= slice4window_sum_0(15);
        slice4winner1_best_index_0_7 <= 15;
      else
        slice4winner1_best_cost_0(7) <= slice4window_sum_0(14);
        slice4winner1_best_index_0_7 <= 14;
      end if;
      if slice4winner1_best_cost_0_is_less(8) then
        slice4winner1_best_cost_0(8) <= slice4window_sum_0(17);
        slice4winner1_best_index_0_8 <= 17;
      else
        slice4winner1_best_cost_0(8) <= slice4window_sum_0(16);
        slice4winner1_best_index_0_8 <= 16;
      end if;
      if slice4winner1_best_cost_0_is_less(9) then
        slice4winner1_best_cost_0(9) <= slice4window_sum_0(19);
        slice4winner1_best_index_0_9 <= 19;
      else
        slice4winner1_best_cost_0(9) <= slice4window_sum_0(18);
        slice4winner1_best_index_0_9 <= 18;
      end if;
      if slice4winner1_best_cost_0_is_less(10) then
        slice4winner1_best_cost_0(10) <= slice4window_sum_0(21);
        slice4winner1_best_index_0_10 <= 21;
      else
        slice4winner1_best_cost_0(10) <= slice4window_sum_0(20);
        slice4winner1_best_index_0_10 <= 20;
      end if;
      if slice4winner1_best_cost_0_is_less(11) then
        slice4winner1_best_cost_0(11) <= slice4window_sum_0(23);
        slice4winner1_best_index_0_11 <= 23;
      else
        slice4winner1_best_cost_0(11) <= slice4window_sum_0(22);
        slice4winner1_best_index_0_11 <= 22;
      end if;
      -- slice4winner2
      for i in 0 to 5 loop
        slice4winner2_best_cost_0_is_less(i) := (slice4winner1_best_cost_0(2 * i + 1) - slice4winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice4winner2_best_cost_0(6) <= slice4winner1_best_cost_0(12);
      if slice4winner2_best_cost_0_is_less(0) then
        slice4winner2_best_cost_0(0) <= slice4winner1_best_cost_0(1);
        slice4winner2_best_index_0_0 <= slice4winner1_best_index_0_1;
      else
        slice4winner2_best_cost_0(0) <= slice4winner1_best_cost_0(0);
        slice4winner2_best_index_0_0 <= as_number(slice4winner1_best_index_0_0);
      end if;
      if slice4winner2_best_cost_0_is_less(1) then
        slice4winner2_best_cost_0(1) <= slice4winner1_best_cost_0(3);
        slice4winner2_best_index_0_1 <= slice4winner1_best_index_0_3;
      else
        slice4winner2_best_cost_0(1) <= slice4winner1_best_cost_0(2);
        slice4winner2_best_index_0_1 <= slice4winner1_best_index_0_2;
      end if;
      if slice4winner2_best_cost_0_is_less(2) then
        slice4winner2_best_cost_0(2) <= slice4winner1_best_cost_0(5);
        slice4winner2_best_index_0_2 <= slice4winner1_best_index_0_5;
      else
        slice4winner2_best_cost_0(2) <= slice4winner1_best_cost_0(4);
        slice4winner2_best_index_0_2 <= slice4winner1_best_index_0_4;
      end if;
      if slice4winner2_best_cost_0_is_less(3) then
        slice4winner2_best_cost_0(3) <= slice4winner1_best_cost_0(7);
        slice4winner2_best_index_0_3 <= slice4winner1_best_index_0_7;
      else
        slice4winner2_best_cost_0(3) <= slice4winner1_best_cost_0(6);
        slice4winner2_best_index_0_3 <= slice4winner1_best_index_0_6;
      end if;
      if slice4winner2_best_cost_0_is_less(4) then
        slice4winner2_best_cost_0(4) <= slice4winner1_best_cost_0(9);
        slice4winner2_best_index_0_4 <= slice4winner1_best_index_0_9;
      else
        slice4winner2_best_cost_0(4) <= slice4winner1_best_cost_0(8);
        slice4winner2_best_index_0_4 <= slice4winner1_best_index_0_8;
      end if;
      if slice4winner2_best_cost_0_is_less(5) then
        slice4winner2_best_cost_0(5) <= slice4winner1_best_cost_0(11);
        slice4winner2_best_index_0_5 <= slice4winner1_best_index_0_11;
      else
        slice4winner2_best_cost_0(5) <= slice4winner1_best_cost_0(10);
        slice4winner2_best_index_0_5 <= slice4winner1_best_index_0_10;
      end if;
      -- slice4winner3
      for i in 0 to 2 loop
        slice4winner3_best_cost_0_is_less(i) := (slice4winner2_best_cost_0(2 * i + 1) - slice4winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice4winner3_best_cost_0(3) <= slice4winner2_best_cost_0(6);
      if slice4winner3_best_cost_0_is_less(0) then
        slice4winner3_best_cost_0(0) <= slice4winner2_best_cost_0(1);
        slice4winner3_best_index_0_0 <= slice4winner2_best_index_0_1;
      else
        slice4winner3_best_cost_0(0) <= slice4winner2_best_cost_0(0);
        slice4winner3_best_index_0_0 <= slice4winner2_best_index_0_0;
      end if;
      if slice4winner3_best_cost_0_is_less(1) then
        slice4winner3_best_cost_0(1) <= slice4winner2_best_cost_0(3);
        slice4winner3_best_index_0_1 <= slice4winner2_best_index_0_3;
      else
        slice4winner3_best_cost_0(1) <= slice4winner2_best_cost_0(2);
        slice4winner3_best_index_0_1 <= slice4winner2_best_index_0_2;
      end if;
      if slice4winner3_best_cost_0_is_less(2) then
        slice4winner3_best_cost_0(2) <= slice4winner2_best_cost_0(5);
        slice4winner3_best_index_0_2 <= slice4winner2_best_index_0_5;
      else
        slice4winner3_best_cost_0(2) <= slice4winner2_best_cost_0(4);
        slice4winner3_best_index_0_2 <= slice4winner2_best_index_0_4;
      end if;
      -- slice4winner4
      slice4winner4_best_cost_0_is_less(0) := (slice4winner3_best_cost_0(1) - slice4winner3_best_cost_0(0)) < 0;
      slice4winner4_best_cost_0_is_less(1) := (slice4winner3_best_cost_0(3) - slice4winner3_best_cost_0(2)) < 0;
      if slice4winner4_best_cost_0_is_less(0) then
        slice4winner4_best_cost_0(0) <= slice4winner3_best_cost_0(1);
        slice4winner4_best_index_0_0 <= slice4winner3_best_index_0_1;
      else
        slice4winner4_best_cost_0(0) <= slice4winner3_best_cost_0(0);
        slice4winner4_best_index_0_0 <= slice4winner3_best_index_0_0;
      end if;
      if slice4winner4_best_cost_0_is_less(1) then
        slice4winner4_best_cost_0(1) <= slice4winner3_best_cost_0(3);
        slice4winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice4winner4_best_cost_0(1) <= slice4winner3_best_cost_0(2);
        slice4winner4_best_index_0_1 <= slice4winner3_best_index_0_2;
      end if;
      -- slice4winner5
      slice4winner5_best_cost_0_0_is_less := (slice4winner4_best_cost_0(1) - slice4winner4_best_cost_0(0)) < 0;
      if slice4winner5_best_cost_0_0_is_less then
        slice4winner5_best_cost_0_0 <= slice4winner4_best_cost_0(1);
        slice4winner5_best_index_0_0 <= slice4winner4_best_index_0_1;
      else
        slice4winner5_best_cost_0_0 <= slice4winner4_best_cost_0(0);
        slice4winner5_best_index_0_0 <= slice4winner4_best_index_0_0;
      end if;
      -- slice4
      slice4_best_cost_0_0_is_less := (slice3_best_cost_0_0 - slice4winner5_best_cost_0_0) < 0;
      slice4_best_tag_valid <= slice3_best_tag_valid;
      slice4_best_tag_output_column <= slice3_best_tag_output_column;
      slice4_best_tag_start_of_frame <= slice3_best_tag_start_of_frame;
      slice4_best_tag_end_of_line <= slice3_best_tag_end_of_line;
      if slice4_best_cost_0_0_is_less then
        slice4_best_cost_0_0 <= slice3_best_cost_0_0;
        slice4_best_index_0_0 <= slice3_best_index_0_0;
      else
        slice4_best_cost_0_0 <= slice4winner5_best_cost_0_0;
        slice4_best_index_0_0 <= slice4winner5_best_index_0_0 + 75;
      end if;
      -- slice5shift
      if slice0cost_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice5shift_search(i, j) <= slice5shift_search(i, j + 1);
          end loop;
          slice5shift_search(i, 24) <= slice4shift_search_out(i);
        end loop;
      end if;
      slice5shift_reference(0) <= slice4shift_reference(0);
      slice5shift_reference(1) <= slice4shift_reference(1);
      slice5shift_search_out(0) <= slice5shift_search(0, 0);
      slice5shift_search_out(1) <= slice5shift_search(1, 0);
      -- slice5cost
      for i in 0 to 11 loop
        if slice2window_change_tag_first_group then
          slice5cost_column_0_choice(2 * i) := 0;
        else
          slice5cost_column_0_choice(2 * i) := slice5cost_ready_words(i) mod 2048;
        end if;
        if slice2window_change_tag_border_column then
          slice5cost_column_0_choice_2(2 * i) := 0;
        else
          slice5cost_column_0_choice_2(2 * i) := (slice5cost_change_0(2 * i) + slice5cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice2window_change_tag_first_group then
          slice5cost_column_0_choice(2 * i + 1) := 0;
        else
          slice5cost_column_0_choice(2 * i + 1) := slice5cost_ready_words(i) / 2048;
        end if;
        if slice2window_change_tag_border_column then
          slice5cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice5cost_column_0_choice_2(2 * i + 1) := (slice5cost_change_0(2 * i + 1) + slice5cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice2window_change_tag_first_group then
        slice5cost_column_0_choice(24) := 0;
      else
        slice5cost_column_0_choice(24) := slice5cost_ready_words_12;
      end if;
      if slice2window_change_tag_border_column then
        slice5cost_column_0_choice_2(24) := 0;
      else
        slice5cost_column_0_choice_2(24) := (slice5cost_change_0(24) + slice5cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice5cost_pixels_first(0, i) <= slice5shift_search(0, i) - slice5shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice5cost_pixels_first(1, i) <= slice5shift_search(1, i) - slice5shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice5cost_pixels_cost(i, j) <= (folded(slice5cost_pixels_first(i, j)) +
            as_number((slice5cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      for i in 0 to 24 loop
        slice5cost_change_0(i) <= slice5cost_pixels_cost(1, i) - slice5cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice5cost_ready_words(i) <= to_integer(slice5cost_read_words(i));
      end loop;
      slice5cost_ready_words_12 <= to_integer(slice5cost_read_words_12);
      for i in 0 to 24 loop
        slice5cost_column_0(i) <= slice5cost_column_0_choice_2(i);
      end loop;
      if slice0window_entering_tag_valid then
        slice5cost_read_column <= slice3cost_change_column;
      end if;
      if slice0window_change_tag_valid then
        slice5cost_change_column <= slice4cost_change_column;
      end if;
      if slice0window_tag_valid then
        slice5cost_ready_column <= slice4cost_ready_column;
      end if;
      if slice0winner1_tag_valid then
        slice5cost_write_column <= slice4cost_write_column;
        for i in 0 to 11 loop
          slice5cost_write_words(i) <= (slice5cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice5cost_column_0_choice_2(2 * i);
        end loop;
        slice5cost_write_words_12 <= slice5cost_column_0_choice_2(24);
      end if;
      -- slice5window
      if slice0winner2_tag_valid then
        slice5window_ring_write_address <= slice5window_ring_read_address;
        if slice5window_ring_read_address = 7 then
          slice5window_ring_read_address <= 0;
        else
          slice5window_ring_read_address <= (slice5window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice4window_change_tag_leaves_window then
            slice5window_change_0_choice(4 * i + j) := to_integer(slice5window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice5window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice4window_change_tag_leaves_window then
            slice5window_change_0_choice(4 * i + j) := to_integer(slice5window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice5window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice4window_change_tag_leaves_window then
        slice5window_change_0_choice(24) := to_integer(slice5window_leaving_12);
      else
        slice5window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice5window_entering_0(i) <= slice5cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice5window_change_0(i) <= slice5window_entering_0(i) - slice5window_change_0_choice(i);
      end loop;
      slice5window_change_tag_leaves_window <= slice4window_change_tag_leaves_window;
      slice5window_centre_output_column_1 <= slice4window_centre_output_column_1;
      slice5window_centre_first_column_0 <= slice4window_centre_first_column_0;
      slice5window_centre_end_of_line_0 <= slice4window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice4window_centre_first_column_0 then
          slice5window_sum_0_choice(i) := 0;
        else
          slice5window_sum_0_choice(i) := slice5window_sum_0(i);
        end if;
      end loop;
      if slice0winner4_tag_valid then
        for i in 0 to 24 loop
          slice5window_sum_0(i) <= (slice5window_sum_0_choice(i) + slice5window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice5winner1
      for i in 0 to 11 loop
        slice5winner1_best_cost_0_is_less(i) := (slice5window_sum_0(2 * i + 1) - slice5window_sum_0(2 * i)) < 0;
      end loop;
      slice5winner1_best_cost_0(12) <= slice5window_sum_0(24);
      slice5winner1_best_index_0_0 <= slice5winner1_best_cost_0_is_less(0);
      if slice5winner1_best_cost_0_is_less(0) then
        slice5winner1_best_cost_0(0) <= slice5window_sum_0(1);
      else
        slice5winner1_best_cost_0(0) <= slice5window_sum_0(0);
      end if;
      if slice5winner1_best_cost_0_is_less(1) then
        slice5winner1_best_cost_0(1) <= slice5window_sum_0(3);
        slice5winner1_best_index_0_1 <= 3;
      else
        slice5winner1_best_cost_0(1) <= slice5window_sum_0(2);
        slice5winner1_best_index_0_1 <= 2;
      end if;
      if slice5winner1_best_cost_0_is_less(2) then
        slice5winner1_best_cost_0(2) <= slice5window_sum_0(5);
        slice5winner1_best_index_0_2 <= 5;
      else
        slice5winner1_best_cost_0(2) <= slice5window_sum_0(4);
        slice5winner1_best_index_0_2 <= 4;
      end if;
      if slice5winner1_best_cost_0_is_less(3) then
        slice5winner1_best_cost_0(3) <= slice5window_sum_0(7);
        slice5winner1_best_index_0_3 <= 7;
      else
        slice5winner1_best_cost_0(3) <= slice5window_sum_0(6);
        slice5winner1_best_index_0_3 <= 6;
      end if;
      if slice5winner1_best_cost_0_is_less(4) then
        slice5winner1_best_cost_0(4) <= slice5window_sum_0(9);
        slice5winner1_best_index_0_4 <= 9;
      else
        slice5winner1_best_cost_0(4) <= slice5window_sum_0(8);
        slice5winner1_best_index_0_4 <= 8;
      end if;
      if slice5winner1_best_cost_0_is_less(5) then
        slice5winner1_best_cost_0(5) <= slice5window_sum_0(11);
        slice5winner1_best_index_0_5 <= 11;
      else
        slice5winner1_best_cost_0(5) <= slice5window_sum_0(10);
        slice5winner1_best_index_0_5 <= 10;
      end if;
      if slice5winner1_best_cost_0_is_less(6) then
        slice5winner1_best_cost_0(6) <= slice5window_sum_0(13);
        slice5winner1_best_index_0_6 <= 13;
      else
        slice5winner1_best_cost_0(6) <= slice5window_sum_0(12);
        slice5winner1_best_index_0_6 <= 12;
      end if;
      if slice5winner1_best_cost_0_is_less(7) then
        slice5winner1_best_cost_0(7) <= slice5window_sum_0(15);
        slice5winner1_best_index_0_7 <= 15;
      else
        slice5winner1_best_cost_0(7) <= slice5window_sum_0(14);
        slice5winner1_best_index_0_7 <= 14;
      end if;
      if slice5winner1_best_cost_0_is_less(8) then
        slice5winner1_best_cost_0(8) <= slice5window_sum_0(17);
        slice5winner1_best_index_0_8 <= 17;
      else
        slice5winner1_best_cost_0(8) <= slice5window_sum_0(16);
        slice5winner1_best_index_0_8 <= 16;
      end if;
      if slice5winner1_best_cost_0_is_less(9) then
        slice5winner1_best_cost_0(9) <= slice5window_sum_0(19);
        slice5winner1_best_index_0_9 <= 19;
      else
        slice5winner1_best_cost_0(9) <= slice5window_sum_0(18);
        slice5winner1_best_index_0_9 <= 18;
      end if;
      if slice5winner1_best_cost_0_is_less(10) then
        slice5winner1_best_cost_0(10) <= slice5window_sum_0(21);
        slice5winner1_best_index_0_10 <= 21;
      else
        slice5winner1_best_cost_0(10) <= slice5window_sum_0(20);
        slice5winner1_best_index_0_10 <= 20;
      end if;
      if slice5winner1_best_cost_0_is_less(11) then
        slice5winner1_best_cost_0(11) <= slice5window_sum_0(23);
        slice5winner1_best_index_0_11 <= 23;
      else
        slice5winner1_best_cost_0(11) <= slice5window_sum_0(22);
        slice5winner1_best_index_0_11 <= 22;
      end if;
      -- slice5winner2
      for i in 0 to 5 loop
        slice5winner2_best_cost_0_is_less(i) := (slice5winner1_best_cost_0(2 * i + 1) - slice5winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice5winner2_best_cost_0(6) <= slice5winner1_best_cost_0(12);
      if slice5winner2_best_cost_0_is_less(0) then
        slice5winner2_best_cost_0(0) <= slice5winner1_best_cost_0(1);
        slice5winner2_best_index_0_0 <= slice5winner1_best_index_0_1;
      else
        slice5winner2_best_cost_0(0) <= slice5winner1_best_cost_0(0);
        slice5winner2_best_index_0_0 <= as_number(slice5winner1_best_index_0_0);
      end if;
      if slice5winner2_best_cost_0_is_less(1) then
        slice5winner2_best_cost_0(1) <= slice5winner1_best_cost_0(3);
        slice5winner2_best_index_0_1 <= slice5winner1_best_index_0_3;
      else
        slice5winner2_best_cost_0(1) <= slice5winner1_best_cost_0(2);
        slice5winner2_best_index_0_1 <= slice5winner1_best_index_0_2;
      end if;
      if slice5winner2_best_cost_0_is_less(2) then
        slice5winner2_best_cost_0(2) <= slice5winner1_best_cost_0(5);
        slice5winner2_best_index_0_2 <= slice5winner1_best_index_0_5;
      else
        slice5winner2_best_cost_0(2) <= slice5winner1_best_cost_0(4);
        slice5winner2_best_index_0_2 <= slice5winner1_best_index_0_4;
      end if;
      if slice5winner2_best_cost_0_is_less(3) then
        slice5winner2_best_cost_0(3) <= slice5winner1_best_cost_0(7);
        slice5winner2_best_index_0_3 <= slice5winner1_best_index_0_7;
      else
        slice5winner2_best_cost_0(3) <= slice5winner1_best_cost_0(6);
        slice5winner2_best_index_0_3 <= slice5winner1_best_index_0_6;
      end if;
      if slice5winner2_best_cost_0_is_less(4) then
        slice5winner2_best_cost_0(4) <= slice5winner1_best_cost_0(9);
        slice5winner2_best_index_0_4 <= slice5winner1_best_index_0_9;
      else
        slice5winner2_best_cost_0(4) <= slice5winner1_best_cost_0(8);
        slice5winner2_best_index_0_4 <= slice5winner1_best_index_0_8;
      end if;
      if slice5winner2_best_cost_0_is_less(5) then
        slice5winner2_best_cost_0(5) <= slice5winner1_best_cost_0(11);
        slice5winner2_best_index_0_5 <= slice5winner1_best_index_0_11;
      else
        slice5winner2_best_cost_0(5) <= slice5winner1_best_cost_0(10);
        slice5winner2_best_index_0_5 <= slice5winner1_best_index_0_10;
      end if;
      -- slice5winner3
      for i in 0 to 2 loop
        slice5winner3_best_cost_0_is_less(i) := (slice5winner2_best_cost_0(2 * i + 1) - slice5winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice5winner3_best_cost_0(3) <= slice5winner2_best_cost_0(6);
      if slice5winner3_best_cost_0_is_less(0) then
        slice5winner3_best_cost_0(0) <= slice5winner2_best_cost_0(1);
        slice5winner3_best_index_0_0 <= slice5winner2_best_index_0_1;
      else
        slice5winner3_best_cost_0(0) <= slice5winner2_best_cost_0(0);
        slice5winner3_best_index_0_0 <= slice5winner2_best_index_0_0;
      end if;
      if slice5winner3_best_cost_0_is_less(1) then
        slice5winner3_best_cost_0(1) <= slice5winner2_best_cost_0(3);
        slice5winner3_best_index_0_1 <= slice5winner2_best_index_0_3;
      else
        slice5winner3_best_cost_0(1) <= slice5winner2_best_cost_0(2);
        slice5winner3_best_index_0_1 <= slice5winner2_best_index_0_2;
      end if;
      if slice5winner3_best_cost_0_is_less(2) then
        slice5winner3_best_cost_0(2) <= slice5winner2_best_cost_0(5);
        slice5winner3_best_index_0_2 <= slice5winner2_best_index_0_5;
      else
        slice5winner3_best_cost_0(2) <= slice5winner2_best_cost_0(4);
        slice5winner3_best_index_0_2 <= slice5winner2_best_index_0_4;
      end if;
      -- slice5winner4
      slice5winner4_best_cost_0_is_less(0) := (slice5winner3_best_cost_0(1) - slice5winner3_best_cost_0(0)) < 0;
      slice5winner4_best_cost_0_is_less(1) := (slice5winner3_best_cost_0(3) - slice5winner3_best_cost_0(2)) < 0;
      if slice5winner4_best_cost_0_is_less(0) then
        slice5winner4_best_cost_0(0) <= slice5winner3_best_cost_0(1);
        slice5winner4_best_index_0_0 <= slice5winner3_best_index_0_1;
      else
        slice5winner4_best_cost_0(0) <= slice5winner3_best_cost_0(0);
        slice5winner4_best_index_0_0 <= slice5winner3_best_index_0_0;
      end if;
      if slice5winner4_best_cost_0_is_less(1) then
        slice5winner4_best_cost_0(1) <= slice5winner3_best_cost_0(3);
        slice5winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice5winner4_best_cost_0(1) <= slice5winner3_best_cost_0(2);
        slice5winner4_best_index_0_1 <= slice5winner3_best_index_0_2;
      end if;
      -- slice5winner5
      slice5winner5_best_cost_0_0_is_less := (slice5winner4_best_cost_0(1) - slice5winner4_best_cost_0(0)) < 0;
      if slice5winner5_best_cost_0_0_is_less then
        slice5winner5_best_cost_0_0 <= slice5winner4_best_cost_0(1);
        slice5winner5_best_index_0_0 <= slice5winner4_best_index_0_1;
      else
        slice5winner5_best_cost_0_0 <= slice5winner4_best_cost_0(0);
        slice5winner5_best_index_0_0 <= slice5winner4_best_index_0_0;
      end if;
      -- slice5
      slice5_best_cost_0_0_is_less := (slice4_best_cost_0_0 - slice5winner5_best_cost_0_0) < 0;
      slice5_best_tag_valid <= slice4_best_tag_valid;
      slice5_best_tag_output_column <= slice4_best_tag_output_column;
      slice5_best_tag_start_of_frame <= slice4_best_tag_start_of_frame;
      slice5_best_tag_end_of_line <= slice4_best_tag_end_of_line;
      if slice5_best_cost_0_0_is_less then
        slice5_best_cost_0_0 <= slice4_best_cost_0_0;
        slice5_best_index_0_0 <= slice4_best_index_0_0;
      else
        slice5_best_cost_0_0 <= slice5winner5_best_cost_0_0;
        slice5_best_index_0_0 <= (((slice5winner5_best_index_0_0 / 2) + 25) * 2) + (slice5winner5_best_index_0_0 mod 2);
      end if;
      -- slice6shift
      if slice0window_entering_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice6shift_search(i, j) <= slice6shift_search(i, j + 1);
          end loop;
          slice6shift_search(i, 24) <= slice5shift_search_out(i);
        end loop;
      end if;
      slice6shift_reference(0) <= slice5shift_reference(0);
      slice6shift_reference(1) <= slice5shift_reference(1);
      slice6shift_search_out(0) <= slice6shift_search(0, 0);
      slice6shift_search_out(1) <= slice6shift_search(1, 0);
      -- slice6cost
      for i in 0 to 11 loop
        if slice3window_change_tag_first_group then
          slice6cost_column_0_choice(2 * i) := 0;
        else
          slice6cost_column_0_choice(2 * i) := slice6cost_ready_words(i) mod 2048;
        end if;
        if slice3window_change_tag_border_column then
          slice6cost_column_0_choice_2(2 * i) := 0;
        else
          slice6cost_column_0_choice_2(2 * i) := (slice6cost_change_0(2 * i) + slice6cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice3window_change_tag_first_group then
          slice6cost_column_0_choice(2 * i + 1) := 0;
        else
          slice6cost_column_0_choice(2 * i + 1) := slice6cost_ready_words(i) / 2048;
        end if;
        if slice3window_change_tag_border_column then
          slice6cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice6cost_column_0_choice_2(2 * i + 1) := (slice6cost_change_0(2 * i + 1) + slice6cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice3window_change_tag_first_group then
        slice6cost_column_0_choice(24) := 0;
      else
        slice6cost_column_0_choice(24) := slice6cost_ready_words_12;
      end if;
      if slice3window_change_tag_border_column then
        slice6cost_column_0_choice_2(24) := 0;
      else
        slice6cost_column_0_choice_2(24) := (slice6cost_change_0(24) + slice6cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice6cost_pixels_first(0, i) <= slice6shift_search(0, i) - slice6shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice6cost_pixels_first(1, i) <= slice6shift_search(1, i) - slice6shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice6cost_pixels_cost(i, j) <= (folded(slice6cost_pixels_first(i, j)) +
            as_number((slice6cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      for i in 0 to 24 loop
        slice6cost_change_0(i) <= slice6cost_pixels_cost(1, i) - slice6cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice6cost_ready_words(i) <= to_integer(slice6cost_read_words(i));
      end loop;
      slice6cost_ready_words_12 <= to_integer(slice6cost_read_words_12);
      slice6cost_ready_column <= slice6cost_change_column;
      for i in 0 to 24 loop
        slice6cost_column_0(i) <= slice6cost_column_0_choice_2(i);
      end loop;
      slice6cost_write_column <= slice6cost_ready_column;
      if slice0window_change_tag_valid then
        if slice0window_change_tag_row_start then
          slice6cost_read_column <= 0;
        else
          slice6cost_read_column <= (slice6cost_read_column + 1) mod 1024;
        end if;
      end if;
      if slice0window_tag_valid then
        if slice1window_change_tag_row_start then
          slice6cost_change_column <= 0;
        else
          slice6cost_change_column <= (slice6cost_change_column + 1) mod 1024;
        end if;
      end if;
      if slice0winner2_tag_valid then
        for i in 0 to 11 loop
          slice6cost_write_words(i) <= (slice6cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice6cost_column_0_choice_2(2 * i);
        end loop;
        slice6cost_write_words_12 <= slice6cost_column_0_choice_2(24);
      end if;
      -- slice6window
      if slice0winner3_tag_valid then
        slice6window_ring_write_address <= slice6window_ring_read_address;
        if slice6window_ring_read_address = 7 then
          slice6window_ring_read_address <= 0;
        else
          slice6window_ring_read_address <= (slice6window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice5window_change_tag_leaves_window then
            slice6window_change_0_choice(4 * i + j) := to_integer(slice6window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice6window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice5window_change_tag_leaves_window then
            slice6window_change_0_choice(4 * i + j) := to_integer(slice6window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice6window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice5window_change_tag_leaves_window then
        slice6window_change_0_choice(24) := to_integer(slice6window_leaving_12);
      else
        slice6window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice6window_entering_0(i) <= slice6cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice6window_change_0(i) <= slice6window_entering_0(i) - slice6window_change_0_choice(i);
      end loop;
      slice6window_change_tag_leaves_window <= slice5window_change_tag_leaves_window;
      slice6window_centre_first_column_0 <= slice5window_centre_first_column_0;
      slice6window_centre_end_of_line_0 <= slice5window_centre_end_of_line_0;
      for i in 0 to 24 loop
        if slice5window_centre_first_column_0 then
          slice6window_sum_0_choice(i) := 0;
        else
          slice6window_sum_0_choice(i) := slice6window_sum_0(i);
        end if;
      end loop;
      if slice0winner5_tag_valid then
        for i in 0 to 24 loop
          slice6window_sum_0(i) <= (slice6window_sum_0_choice(i) + slice6window_change_0(i)) mod 16384;
        end loop;
      end if;
      if slice0_best_tag_valid then
        slice6window_centre_output_column_1 <= slice5window_centre_output_column_1;
      end if;
      -- slice6winner1
      for i in 0 to 11 loop
        slice6winner1_best_cost_0_is_less(i) := (slice6window_sum_0(2 * i + 1) - slice6window_sum_0(2 * i)) < 0;
      end loop;
      slice6winner1_best_cost_0(12) <= slice6window_sum_0(24);
      slice6winner1_best_index_0_0 <= slice6winner1_best_cost_0_is_less(0);
      if slice6winner1_best_cost_0_is_less(0) then
        slice6winner1_best_cost_0(0) <= slice6window_sum_0(1);
      else
        slice6winner1_best_cost_0(0) <= slice6window_sum_0(0);
      end if;
      if slice6winner1_best_cost_0_is_less(1) then
        slice6winner1_best_cost_0(1) <= slice6window_sum_0(3);
        slice6winner1_best_index_0_1 <= 3;
      else
        slice6winner1_best_cost_0(1) <= slice6window_sum_0(2);
        slice6winner1_best_index_0_1 <= 2;
      end if;
      if slice6winner1_best_cost_0_is_less(2) then
        slice6winner1_best_cost_0(2) <= slice6window_sum_0(5);
        slice6winner1_best_index_0_2 <= 5;
      else
        slice6winner1_best_cost_0(2) <= slice6window_sum_0(4);
        slice6winner1_best_index_0_2 <= 4;
      end if;
      if slice6winner1_best_cost_0_is_less(3) then
        slice6winner1_best_cost_0(3) <= slice6window_sum_0(7);
        slice6winner1_best_index_0_3 <= 7;
      else
        slice6winner1_best_cost_0(3) <= slice6window_sum_0(6);
        slice6winner1_best_index_0_3 <= 6;
      end if;
      if slice6winner1_best_cost_0_is_less(4) then
        slice6winner1_best_cost_0(4) <= slice6window_sum_0(9);
        slice6winner1_best_index_0_4 <= 9;
      else
        slice6winner1_best_cost_0(4) <= slice6window_sum_0(8);
        slice6winner1_best_index_0_4 <= 8;
      end if;
      if slice6winner1_best_cost_0_is_less(5) then
        slice6winner1_best_cost_0(5) <= slice6window_sum_0(11);
        slice6winner1_best_index_0_5 <= 11;
      else
        slice6winner1_best_cost_0(5) <= slice6window_sum_0(10);
        slice6winner1_best_index_0_5 <= 10;
      end if;
      if slice6winner1_best_cost_0_is_less(6) then
        slice6winner1_best_cost_0(6) <= slice6window_sum_0(13);
        slice6winner1_best_index_0_6 <= 13;
      else
        slice6winner1_best_cost_0(6) <= slice6window_sum_0(12);
        slice6winner1_best_index_0_6 <= 12;
      end if;
      if slice6winner1_best_cost_0_is_less(7) then
        slice6winner1_best_cost_0(7) <= slice6window_sum_0(15);
        slice6winner1_best_index_0_7 <= 15;
      else
        slice6winner1_best_cost_0(7) <= slice6window_sum_0(14);
        slice6winner1_best_index_0_7 <= 14;
      end if;
      if slice6winner1_best_cost_0_is_less(8) then
        slice6winner1_best_cost_0(8) <= slice6window_sum_0(17);
        slice6winner1_best_index_0_8 <= 17;
      else
        slice6winner1_best_cost_0(8) <= slice6window_sum_0(16);
        slice6winner1_best_index_0_8 <= 16;
      end if;
      if slice6winner1_best_cost_0_is_less(9) then
        slice6winner1_best_cost_0(9) <= slice6window_sum_0(19);
        slice6winner1_best_index_0_9 <= 19;
      else
        slice6winner1_best_cost_0(9) <= slice6window_sum_0(18);
        slice6winner1_best_index_0_9 <= 18;
      end if;
      if slice6winner1_best_cost_0_is_less(10) then
        slice6winner1_best_cost_0(10) <= slice6window_sum_0(21);
        slice6winner1_best_index_0_10 <= 21;
      else
        slice6winner1_best_cost_0(10) <= slice6window_sum_0(20);
        slice6winner1_best_index_0_10 <= 20;
      end if;
      if slice6winner1_best_cost_0_is_less(11) then
        slice6winner1_best_cost_0(11) <= slice6window_sum_0(23);
        slice6winner1_best_index_0_11 <= 23;
      else
        slice6winner1_best_cost_0(11) <= slice6window_sum_0(22);
        slice6winner1_best_index_0_11 <= 22;
      end if;
      -- slice6winner2
      for i in 0 to 5 loop
        slice6winner2_best_cost_0_is_less(i) := (slice6winner1_best_cost_0(2 * i + 1) - slice6winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice6winner2_best_cost_0(6) <= slice6winner1_best_cost_0(12);
      if slice6winner2_best_cost_0_is_less(0) then
        slice6winner2_best_cost_0(0) <= slice6winner1_best_cost_0(1);
        slice6winner2_best_index_0_0 <= slice6winner1_best_index_0_1;
      else
        slice6winner2_best_cost_0(0) <= slice6winner1_best_cost_0(0);
        slice6winner2_best_index_0_0 <= as_number(slice6winner1_best_index_0_0);
      end if;
      if slice6winner2_best_cost_0_is_less(1) then
        slice6winner2_best_cost_0(1) <= slice6winner1_best_cost_0(3);
        slice6winner2_best_index_0_1 <= slice6winner1_best_index_0_3;
      else
        slice6winner2_best_cost_0(1) <= slice6winner1_best_cost_0(2);
        slice6winner2_best_index_0_1 <= slice6winner1_best_index_0_2;
      end if;
      if slice6winner2_best_cost_0_is_less(2) then
        slice6winner2_best_cost_0(2) <= slice6winner1_best_cost_0(5);
        slice6winner2_best_index_0_2 <= slice6winner1_best_index_0_5;
      else
        slice6winner2_best_cost_0(2) <= slice6winner1_best_cost_0(4);
        slice6winner2_best_index_0_2 <= slice6winner1_best_index_0_4;
      end if;
      if slice6winner2_best_cost_0_is_less(3) then
        slice6winner2_best_cost_0(3) <= slice6winner1_best_cost_0(7);
        slice6winner2_best_index_0_3 <= slice6winner1_best_index_0_7;
      else
        slice6winner2_best_cost_0(3) <= slice6winner1_best_cost_0(6);
        slice6winner2_best_index_0_3 <= slice6winner1_best_index_0_6;
      end if;
      if slice6winner2_best_cost_0_is_less(4) then
        slice6winner2_best_cost_0(4) <= slice6winner1_best_cost_0(9);
        slice6winner2_best_index_0_4 <= slice6winner1_best_index_0_9;
      else
        slice6winner2_best_cost_0(4) <= slice6winner1_best_cost_0(8);
        slice6winner2_best_index_0_4 <= slice6winner1_best_index_0_8;
      end if;
      if slice6winner2_best_cost_0_is_less(5) then
        slice6winner2_best_cost_0(5) <= slice6winner1_best_cost_0(11);
        slice6winner2_best_index_0_5 <= slice6winner1_best_index_0_11;
      else
        slice6winner2_best_cost_0(5) <= slice6winner1_best_cost_0(10);
        slice6winner2_best_index_0_5 <= slice6winner1_best_index_0_10;
      end if;
      -- slice6winner3
      for i in 0 to 2 loop
        slice6winner3_best_cost_0_is_less(i) := (slice6winner2_best_cost_0(2 * i + 1) - slice6winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice6winner3_best_cost_0(3) <= slice6winner2_best_cost_0(6);
      if slice6winner3_best_cost_0_is_less(0) then
        slice6winner3_best_cost_0(0) <= slice6winner2_best_cost_0(1);
        slice6winner3_best_index_0_0 <= slice6winner2_best_index_0_1;
      else
        slice6winner3_best_cost_0(0) <= slice6winner2_best_cost_0(0);
        slice6winner3_best_index_0_0 <= slice6winner2_best_index_0_0;
      end if;
      if slice6winner3_best_cost_0_is_less(1) then
        slice6winner3_best_cost_0(1) <= slice6winner2_best_cost_0(3);
        slice6winner3_best_index_0_1 <= slice6winner2_best_index_0_3;
      else
        slice6winner3_best_cost_0(1) <= slice6winner2_best_cost_0(2);
        slice6winner3_best_index_0_1 <= slice6winner2_best_index_0_2;
      end if;
      if slice6winner3_best_cost_0_is_less(2) then
        slice6winner3_best_cost_0(2) <= slice6winner2_best_cost_0(5);
        slice6winner3_best_index_0_2 <= slice6winner2_best_index_0_5;
      else
        slice6winner3_best_cost_0(2) <= slice6winner2_best_cost_0(4);
        slice6winner3_best_index_0_2 <= slice6winner2_best_index_0_4;
      end if;
      -- slice6winner4
      slice6winner4_best_cost_0_is_less(0) := (slice6winner3_best_cost_0(1) - slice6winner3_best_cost_0(0)) < 0;
      slice6winner4_best_cost_0_is_less(1) := (slice6winner3_best_cost_0(3) - slice6winner3_best_cost_0(2)) < 0;
      if slice6winner4_best_cost_0_is_less(0) then
        slice6winner4_best_cost_0(0) <= slice6winner3_best_cost_0(1);
        slice6winner4_best_index_0_0 <= slice6winner3_best_index_0_1;
      else
        slice6winner4_best_cost_0(0) <= slice6winner3_best_cost_0(0);
        slice6winner4_best_index_0_0 <= slice6winner3_best_index_0_0;
      end if;
      if slice6winner4_best_cost_0_is_less(1) then
        slice6winner4_best_cost_0(1) <= slice6winner3_best_cost_0(3);
        slice6winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice6winner4_best_cost_0(1) <= slice6winner3_best_cost_0(2);
        slice6winner4_best_index_0_1 <= slice6winner3_best_index_0_2;
      end if;
      -- slice6winner5
      slice6winner5_best_cost_0_0_is_less := (slice6winner4_best_cost_0(1) - slice6winner4_best_cost_0(0)) < 0;
      if slice6winner5_best_cost_0_0_is_less then
        slice6winner5_best_cost_0_0 <= slice6winner4_best_cost_0(1);
        slice6winner5_best_index_0_0 <= slice6winner4_best_index_0_1;
      else
        slice6winner5_best_cost_0_0 <= slice6winner4_best_cost_0(0);
        slice6winner5_best_index_0_0 <= slice6winner4_best_index_0_0;
      end if;
      -- slice6
      slice6_best_cost_0_0_is_less := (slice5_best_cost_0_0 - slice6winner5_best_cost_0_0) < 0;
      slice6_best_tag_valid <= slice5_best_tag_valid;
      slice6_best_tag_output_column <= slice5_best_tag_output_column;
      slice6_best_tag_start_of_frame <= slice5_best_tag_start_of_frame;
      slice6_best_tag_end_of_line <= slice5_best_tag_end_of_line;
      if slice6_best_cost_0_0_is_less then
        slice6_best_cost_0_0 <= slice5_best_cost_0_0;
        slice6_best_index_0_0 <= slice5_best_index_0_0;
      else
        slice6_best_cost_0_0 <= slice6winner5_best_cost_0_0;
        slice6_best_index_0_0 <= slice6winner5_best_index_0_0 + 25;
      end if;
      -- slice7shift
      if slice0window_change_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice7shift_search(i, j) <= slice7shift_search(i, j + 1);
          end loop;
          slice7shift_search(i, 24) <= slice6shift_search_out(i);
        end loop;
      end if;
      slice7shift_reference(0) <= slice6shift_reference(0);
      slice7shift_reference(1) <= slice6shift_reference(1);
      -- slice7cost
      for i in 0 to 11 loop
        if slice4window_change_tag_first_group then
          slice7cost_column_0_choice(2 * i) := 0;
        else
          slice7cost_column_0_choice(2 * i) := slice7cost_ready_words(i) mod 2048;
        end if;
        if slice4window_change_tag_border_column then
          slice7cost_column_0_choice_2(2 * i) := 0;
        else
          slice7cost_column_0_choice_2(2 * i) := (slice7cost_change_0(2 * i) + slice7cost_column_0_choice(2 * i)) mod
            2048;
        end if;
        if slice4window_change_tag_first_group then
          slice7cost_column_0_choice(2 * i + 1) := 0;
        else
          slice7cost_column_0_choice(2 * i + 1) := slice7cost_ready_words(i) / 2048;
        end if;
        if slice4window_change_tag_border_column then
          slice7cost_column_0_choice_2(2 * i + 1) := 0;
        else
          slice7cost_column_0_choice_2(2 * i + 1) := (slice7cost_change_0(2 * i + 1) + slice7cost_column_0_choice(2 * i
            + 1)) mod 2048;
        end if;
      end loop;
      if slice4window_change_tag_first_group then
        slice7cost_column_0_choice(24) := 0;
      else
        slice7cost_column_0_choice(24) := slice7cost_ready_words_12;
      end if;
      if slice4window_change_tag_border_column then
        slice7cost_column_0_choice_2(24) := 0;
      else
        slice7cost_column_0_choice_2(24) := (slice7cost_change_0(24) + slice7cost_column_0_choice(24)) mod 2048;
      end if;
      for i in 0 to 24 loop
        slice7cost_pixels_first(0, i) <= slice7shift_search(0, i) - slice7shift_reference(0);
      end loop;
      for i in 0 to 24 loop
        slice7cost_pixels_first(1, i) <= slice7shift_search(1, i) - slice7shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice7cost_pixels_cost(i, j) <= (folded(slice7cost_pixels_first(i, j)) +
            as_number((slice7cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice7cost_read_column <= slice6cost_read_column;
      slice7cost_change_column <= slice7cost_read_column;
      for i in 0 to 24 loop
        slice7cost_change_0(i) <= slice7cost_pixels_cost(1, i) - slice7cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice7cost_ready_words(i) <= to_integer(slice7cost_read_words(i));
      end loop;
      slice7cost_ready_words_12 <= to_integer(slice7cost_read_words_12);
      for i in 0 to 24 loop
        slice7cost_column_0(i) <= slice7cost_column_0_choice_2(i);
      end loop;
      if slice0winner2_tag_valid then
        slice7cost_ready_column <= slice7cost_change_column;
      end if;
      if slice0winner3_tag_valid then
        slice7cost_write_column <= slice6cost_write_column;
        for i in 0 to 11 loop
          slice7cost_write_words(i) <= (slice7cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice7cost_column_0_choice_2(2 * i);
        end loop;
        slice7cost_write_words_12 <= slice7cost_column_0_choice_2(24);
      end if;
      -- slice7window
      if slice0winner4_tag_valid then
        slice7window_ring_write_address <= slice7window_ring_read_address;
        if slice7window_ring_read_address = 7 then
          slice7window_ring_read_address <= 0;
        else
          slice7window_ring_read_address <= (slice7window_ring_read_address + 1) mod 8;
        end if;
      end if;
      for i in 0 to 5 loop
        for j in 0 to 1 loop
          if slice6window_change_tag_leaves_window then
            slice7window_change_0_choice(4 * i + j) := to_integer(slice7window_leaving(2 * i)(11 * j + 10 downto 11 *
              j));
          else
            slice7window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
        for j in 2 to 3 loop
          if slice6window_change_tag_leaves_window then
            slice7window_change_0_choice(4 * i + j) := to_integer(slice7window_leaving(2 * i + 1)(11 * j - 12 downto 11
              * j - 22));
          else
            slice7window_change_0_choice(4 * i + j) := 0;
          end if;
        end loop;
      end loop;
      if slice6window_change_tag_leaves_window then
        slice7window_change_0_choice(24) := to_integer(slice7window_leaving_12);
      else
        slice7window_change_0_choice(24) := 0;
      end if;
      for i in 0 to 24 loop
        slice7window_entering_0(i) <= slice7cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        slice7window_change_0(i) <= slice7window_entering_0(i) - slice7window_change_0_choice(i);
      end loop;
      for i in 0 to 24 loop
        if slice6window_centre_first_column_0 then
          slice7window_sum_0_choice(i) := 0;
        else
          slice7window_sum_0_choice(i) := slice7window_sum_0(i);
        end if;
      end loop;
      if slice0_best_tag_valid then
        for i in 0 to 24 loop
          slice7window_sum_0(i) <= (slice7window_sum_0_choice(i) + slice7window_change_0(i)) mod 16384;
        end loop;
        slice7window_centre_output_column_1 <= slice6window_centre_output_column_1;
        slice7window_centre_end_of_line(0) <= slice6window_centre_end_of_line_0;
        slice7window_centre_end_of_line(1) <= slice7window_centre_end_of_line(0);
      end if;
      -- slice7winner1
      for i in 0 to 11 loop
        slice7winner1_best_cost_0_is_less(i) := (slice7window_sum_0(2 * i + 1) - slice7window_sum_0(2 * i)) < 0;
      end loop;
      slice7winner1_best_cost_0(12) <= slice7window_sum_0(24);
      slice7winner1_best_index_0_0 <= slice7winner1_best_cost_0_is_less(0);
      if slice7winner1_best_cost_0_is_less(0) then
        slice7winner1_best_cost_0(0) <= slice7window_sum_0(1);
      else
        slice7winner1_best_cost_0(0) <= slice7window_sum_0(0);
      end if;
      if slice7winner1_best_cost_0_is_less(1) then
        slice7winner1_best_cost_0(1) <= slice7window_sum_0(3);
        slice7winner1_best_index_0_1 <= 3;
      else
        slice7winner1_best_cost_0(1) <= slice7window_sum_0(2);
        slice7winner1_best_index_0_1 <= 2;
      end if;
      if slice7winner1_best_cost_0_is_less(2) then
        slice7winner1_best_cost_0(2) <= slice7window_sum_0(5);
        slice7winner1_best_index_0_2 <= 5;
      else
        slice7winner1_best_cost_0(2) <= slice7window_sum_0(4);
        slice7winner1_best_index_0_2 <= 4;
      end if;
      if slice7winner1_best_cost_0_is_less(3) then
        slice7winner1_best_cost_0(3) <= slice7window_sum_0(7);
        slice7winner1_best_index_0_3 <= 7;
      else
        slice7winner1_best_cost_0(3) <= slice7window_sum_0(6);
        slice7winner1_best_index_0_3 <= 6;
      end if;
      if slice7winner1_best_cost_0_is_less(4) then
        slice7winner1_best_cost_0(4) <= slice7window_sum_0(9);
        slice7winner1_best_index_0_4 <= 9;
      else
        slice7winner1_best_cost_0(4) <= slice7window_sum_0(8);
        slice7winner1_best_index_0_4 <= 8;
      end if;
      if slice7winner1_best_cost_0_is_less(5) then
        slice7winner1_best_cost_0(5) <= slice7window_sum_0(11);
        slice7winner1_best_index_0_5 <= 11;
      else
        slice7winner1_best_cost_0(5) <= slice7window_sum_0(10);
        slice7winner1_best_index_0_5 <= 10;
      end if;
      if slice7winner1_best_cost_0_is_less(6) then
        slice7winner1_best_cost_0(6) <= slice7window_sum_0(13);
        slice7winner1_best_index_0_6 <= 13;
      else
        slice7winner1_best_cost_0(6) <= slice7window_sum_0(12);
        slice7winner1_best_index_0_6 <= 12;
      end if;
      if slice7winner1_best_cost_0_is_less(7) then
        slice7winner1_best_cost_0(7) <= slice7window_sum_0(15);
        slice7winner1_best_index_0_7 <= 15;
      else
        slice7winner1_best_cost_0(7) <= slice7window_sum_0(14);
        slice7winner1_best_index_0_7 <= 14;
      end if;
      if slice7winner1_best_cost_0_is_less(8) then
        slice7winner1_best_cost_0(8) <= slice7window_sum_0(17);
        slice7winner1_best_index_0_8 <= 17;
      else
        slice7winner1_best_cost_0(8) <= slice7window_sum_0(16);
        slice7winner1_best_index_0_8 <= 16;
      end if;
      if slice7winner1_best_cost_0_is_less(9) then
        slice7winner1_best_cost_0(9) <= slice7window_sum_0(19);
        slice7winner1_best_index_0_9 <= 19;
      else
        slice7winner1_best_cost_0(9) <= slice7window_sum_0(18);
        slice7winner1_best_index_0_9 <= 18;
      end if;
      if slice7winner1_best_cost_0_is_less(10) then
        slice7winner1_best_cost_0(10) <= slice7window_sum_0(21);
        slice7winner1_best_index_0_10 <= 21;
      else
        slice7winner1_best_cost_0(10) <= slice7window_sum_0(20);
        slice7winner1_best_index_0_10 <= 20;
      end if;
      if slice7winner1_best_cost_0_is_less(11) then
        slice7winner1_best_cost_0(11) <= slice7window_sum_0(23);
        slice7winner1_best_index_0_11 <= 23;
      else
        slice7winner1_best_cost_0(11) <= slice7window_sum_0(22);
        slice7winner1_best_index_0_11 <= 22;
      end if;
      -- slice7winner2
      for i in 0 to 5 loop
        slice7winner2_best_cost_0_is_less(i) := (slice7winner1_best_cost_0(2 * i + 1) - slice7winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice7winner2_best_cost_0(6) <= slice7winner1_best_cost_0(12);
      if slice7winner2_best_cost_0_is_less(0) then
        slice7winner2_best_cost_0(0) <= slice7winner1_best_cost_0(1);
        slice7winner2_best_index_0_0 <= slice7winner1_best_index_0_1;
      else
        slice7winner2_best_cost_0(0) <= slice7winner1_best_cost_0(0);
        slice7winner2_best_index_0_0 <= as_number(slice7winner1_best_index_0_0);
      end if;
      if slice7winner2_best_cost_0_is_less(1) then
        slice7winner2_best_cost_0(1) <= slice7winner1_best_cost_0(3);
        slice7winner2_best_index_0_1 <= slice7winner1_best_index_0_3;
      else
        slice7winner2_best_cost_0(1) <= slice7winner1_best_cost_0(2);
        slice7winner2_best_index_0_1 <= slice7winner1_best_index_0_2;
      end if;
      if slice7winner2_best_cost_0_is_less(2) then
        slice7winner2_best_cost_0(2) <= slice7winner1_best_cost_0(5);
        slice7winner2_best_index_0_2 <= slice7winner1_best_index_0_5;
      else
        slice7winner2_best_cost_0(2) <= slice7winner1_best_cost_0(4);
        slice7winner2_best_index_0_2 <= slice7winner1_best_index_0_4;
      end if;
      if slice7winner2_best_cost_0_is_less(3) then
        slice7winner2_best_cost_0(3) <= slice7winner1_best_cost_0(7);
        slice7winner2_best_index_0_3 <= slice7winner1_best_index_0_7;
      else
        slice7winner2_best_cost_0(3) <= slice7winner1_best_cost_0(6);
        slice7winner2_best_index_0_3 <= slice7winner1_best_index_0_6;
      end if;
      if slice7winner2_best_cost_0_is_less(4) then
        slice7winner2_best_cost_0(4) <= slice7winner1_best_cost_0(9);
        slice7winner2_best_index_0_4 <= slice7winner1_best_index_0_9;
      else
        slice7winner2_best_cost_0(4) <= slice7winner1_best_cost_0(8);
        slice7winner2_best_index_0_4 <= slice7winner1_best_index_0_8;
      end if;
      if slice7winner2_best_cost_0_is_less(5) then
        slice7winner2_best_cost_0(5) <= slice7winner1_best_cost_0(11);
        slice7winner2_best_index_0_5 <= slice7winner1_best_index_0_11;
      else
        slice7winner2_best_cost_0(5) <= slice7winner1_best_cost_0(10);
        slice7winner2_best_index_0_5 <= slice7winner1_best_index_0_10;
      end if;
      -- slice7winner3
      for i in 0 to 2 loop
        slice7winner3_best_cost_0_is_less(i) := (slice7winner2_best_cost_0(2 * i + 1) - slice7winner2_best_cost_0(2 *
          i)) < 0;
      end loop;
      slice7winner3_best_cost_0(3) <= slice7winner2_best_cost_0(6);
      if slice7winner3_best_cost_0_is_less(0) then
        slice7winner3_best_cost_0(0) <= slice7winner2_best_cost_0(1);
        slice7winner3_best_index_0_0 <= slice7winner2_best_index_0_1;
      else
        slice7winner3_best_cost_0(0) <= slice7winner2_best_cost_0(0);
        slice7winner3_best_index_0_0 <= slice7winner2_best_index_0_0;
      end if;
      if slice7winner3_best_cost_0_is_less(1) then
        slice7winner3_best_cost_0(1) <= slice7winner2_best_cost_0(3);
        slice7winner3_best_index_0_1 <= slice7winner2_best_index_0_3;
      else
        slice7winner3_best_cost_0(1) <= slice7winner2_best_cost_0(2);
        slice7winner3_best_index_0_1 <= slice7winner2_best_index_0_2;
      end if;
      if slice7winner3_best_cost_0_is_less(2) then
        slice7winner3_best_cost_0(2) <= slice7winner2_best_cost_0(5);
        slice7winner3_best_index_0_2 <= slice7winner2_best_index_0_5;
      else
        slice7winner3_best_cost_0(2) <= slice7winner2_best_cost_0(4);
        slice7winner3_best_index_0_2 <= slice7winner2_best_index_0_4;
      end if;
      -- slice7winner4
      slice7winner4_best_cost_0_is_less(0) := (slice7winner3_best_cost_0(1) - slice7winner3_best_cost_0(0)) < 0;
      slice7winner4_best_cost_0_is_less(1) := (slice7winner3_best_cost_0(3) - slice7winner3_best_cost_0(2)) < 0;
      if slice7winner4_best_cost_0_is_less(0) then
        slice7winner4_best_cost_0(0) <= slice7winner3_best_cost_0(1);
        slice7winner4_best_index_0_0 <= slice7winner3_best_index_0_1;
      else
        slice7winner4_best_cost_0(0) <= slice7winner3_best_cost_0(0);
        slice7winner4_best_index_0_0 <= slice7winner3_best_index_0_0;
      end if;
      if slice7winner4_best_cost_0_is_less(1) then
        slice7winner4_best_cost_0(1) <= slice7winner3_best_cost_0(3);
        slice7winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice7winner4_best_cost_0(1) <= slice7winner3_best_cost_0(2);
        slice7winner4_best_index_0_1 <= slice7winner3_best_index_0_2;
      end if;
      -- slice7winner5
      slice7winner5_best_cost_0_0_is_less := (slice7winner4_best_cost_0(1) - slice7winner4_best_cost_0(0)) < 0;
      if slice7winner5_best_cost_0_0_is_less then
        slice7winner5_best_cost_0_0 <= slice7winner4_best_cost_0(1);
        slice7winner5_best_index_0_0 <= slice7winner4_best_index_0_1;
      else
        slice7winner5_best_cost_0_0 <= slice7winner4_best_cost_0(0);
        slice7winner5_best_index_0_0 <= slice7winner4_best_index_0_0;
      end if;
      -- slice7
      slice7_best_tag_valid <= slice6_best_tag_valid;
      slice7_best_tag_output_column <= slice6_best_tag_output_column;
      slice7_best_tag_start_of_frame <= slice6_best_tag_start_of_frame;
      slice7_best_tag_end_of_line <= slice6_best_tag_end_of_line;
      if (slice6_best_cost_0_0 - slice7winner5_best_cost_0_0) < 0 then
        slice7_best_index_0_0 <= slice6_best_index_0_0;
      else
        slice7_best_index_0_0 <= slice7winner5_best_index_0_0;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 483;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
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
        slice0cost_tag_row_start <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_row_start <= false;
        slice0window_entering_tag_output_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_row_start <= false;
        slice0window_change_tag_output_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_output_column(0) <= false;
        slice0window_centre_output_column(1) <= false;
        slice0window_centre_start_of_frame(0) <= false;
        slice0window_centre_start_of_frame(1) <= false;
        slice0window_centre_start_of_frame(2) <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_start_of_frame <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner5_tag_valid <= false;
        slice0winner5_tag_start_of_frame <= false;
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
        slice1window_change_tag_row_start <= false;
        slice1window_centre_output_column_1 <= false;
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
        slice2window_centre_output_column_1 <= false;
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
        slice3window_centre_output_column_1 <= false;
        slice3window_centre_end_of_line_0 <= false;
        slice3_best_tag_valid <= false;
        slice3_best_tag_output_column <= false;
        slice3_best_tag_start_of_frame <= false;
        slice3_best_tag_end_of_line <= false;
        slice4cost_read_column <= 0;
        slice4cost_change_column <= 0;
        slice4cost_ready_column <= 0;
        slice4cost_write_column <= 0;
        slice4window_ring_read_address <= 1;
        slice4window_ring_write_address <= 0;
        slice4window_centre_output_column_1 <= false;
        slice4window_centre_end_of_line_0 <= false;
        slice4_best_tag_valid <= false;
        slice4_best_tag_output_column <= false;
        slice4_best_tag_start_of_frame <= false;
        slice4_best_tag_end_of_line <= false;
        slice5cost_read_column <= 0;
        slice5cost_change_column <= 0;
        slice5cost_ready_column <= 0;
        slice5cost_write_column <= 0;
        slice5window_ring_read_address <= 1;
        slice5window_ring_write_address <= 0;
        slice5window_centre_output_column_1 <= false;
        slice5window_centre_end_of_line_0 <= false;
        slice5_best_tag_valid <= false;
        slice5_best_tag_output_column <= false;
        slice5_best_tag_start_of_frame <= false;
        slice5_best_tag_end_of_line <= false;
        slice6cost_read_column <= 0;
        slice6cost_change_column <= 0;
        slice6cost_ready_column <= 0;
        slice6cost_write_column <= 0;
        slice6window_ring_read_address <= 1;
        slice6window_ring_write_address <= 0;
        slice6window_centre_output_column_1 <= false;
        slice6window_centre_end_of_line_0 <= false;
        slice6_best_tag_valid <= false;
        slice6_best_tag_output_column <= false;
        slice6_best_tag_start_of_frame <= false;
        slice6_best_tag_end_of_line <= false;
        slice7cost_read_column <= 0;
        slice7cost_change_column <= 0;
        slice7cost_ready_column <= 0;
        slice7cost_write_column <= 0;
        slice7window_ring_read_address <= 1;
        slice7window_ring_write_address <= 0;
        slice7window_centre_output_column_1 <= false;
        slice7window_centre_end_of_line(0) <= false;
        slice7window_centre_end_of_line(1) <= false;
        slice7_best_tag_valid <= false;
        slice7_best_tag_output_column <= false;
        slice7_best_tag_start_of_frame <= false;
        slice7_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
