-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration miyajima_640_f5: 640x480, 200 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 200, window_px 7, aggregation recursive, clocks_per_pixel 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config miyajima_640_f5
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_miyajima_640_f5 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 200;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 440;
    latency_clocks : positive := 8;
    flush_groups : positive := 3000;
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
  assert width_px = 640 report "stereo_core_miyajima_640_f5: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_miyajima_640_f5: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 200 report "stereo_core_miyajima_640_f5: disparities is " & integer'image(disparities) & " but this core has 200" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_miyajima_640_f5: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_miyajima_640_f5: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 440 report "stereo_core_miyajima_640_f5: output_width_px is " & integer'image(output_width_px) & " but this core has 440" severity failure;
  assert latency_clocks = 8 report "stereo_core_miyajima_640_f5: latency_clocks is " & integer'image(latency_clocks) & " but this core has 8" severity failure;
  assert flush_groups = 3000 report "stereo_core_miyajima_640_f5: flush_groups is " & integer'image(flush_groups) & " but this core has 3000" severity failure;
  assert gap_groups = 1920 report "stereo_core_miyajima_640_f5: gap_groups is " & integer'image(gap_groups) & " but this core has 1920" severity failure;
end entity;

architecture rtl of stereo_core_miyajima_640_f5 is
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
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 255;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag_valid, delay_tag_row_start, delay_tag_first_group, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_reference_rows_read_words_0 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search_rows_ready_words_1, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag_valid, rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_output_column : boolean;
  signal rows_read_tag_start_of_frame : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_tag_valid, rows_tag_row_start : boolean;
  signal rows_tag_first_group, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_search, rows_reference : natural range 0 to 65535;
  -- passes
  signal passes_row, passes_coming_first_group, passes_coming_output, passes_coming_starts, passes_row_ended : boolean;
  signal passes_ended_last, passes_arrived, passes_shows, passes_showing_first_group, passes_showing_output : boolean;
  signal passes_showing_starts, passes_pass_ends, passes_last_pass, passes_leaving_output : boolean;
  signal passes_leaving_starts, passes_read_tag_valid, passes_read_tag_row_start, passes_read_tag_first_group : boolean;
  signal passes_read_tag_border_column, passes_read_tag_first_cost, passes_read_tag_leaves_window : boolean;
  signal passes_read_tag_map_column, passes_read_tag_end_of_line, passes_tag_valid, passes_tag_row_start : boolean;
  signal passes_tag_first_group, passes_tag_border_column, passes_tag_first_cost, passes_tag_leaves_window : boolean;
  signal passes_tag_map_column : boolean;
  signal passes_write_address, passes_search_address, passes_reference_address : natural range 0 to 2047;
  signal passes_write_search_0, passes_write_reference_0 : natural range 0 to 65535;
  signal passes_pass : natural range 0 to 7;
  signal passes_column : natural range 0 to 511;
  signal passes_search_start : natural range 0 to 1023;
  signal passes_read_search_0, passes_read_reference_0 : unsigned(15 downto 0);
  signal passes_search : natural_255_1d(0 to 1);
  signal passes_reference : natural_255_1d(0 to 1);
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice0shift_reference : natural_255_1d(0 to 1);
  signal slice0shift_search_out : natural_255_1d(0 to 1);
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_map_column : boolean;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice0cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_map_column, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_first_group, slice0cost_pixels_tag_border_column : boolean;
  signal slice0cost_pixels_tag_first_cost, slice0cost_pixels_tag_leaves_window : boolean;
  signal slice0cost_pixels_tag_map_column, slice0cost_ready_tag_valid, slice0cost_ready_tag_first_group : boolean;
  signal slice0cost_ready_tag_border_column, slice0cost_ready_tag_first_cost : boolean;
  signal slice0cost_ready_tag_leaves_window, slice0cost_ready_tag_map_column, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_map_column : boolean;
  signal slice0cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 4095;
  signal slice0cost_write_column : natural range 0 to 4095;
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
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_map_column : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_map_column : boolean;
  signal slice0window_centre_map_column : boolean_1d(0 to 2);
  signal slice0window_centre_first_column : boolean_1d(0 to 2);
  signal slice0window_tag_valid, slice0window_tag_map_column, slice0window_tag_first_column : boolean;
  signal slice0window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice0window_sum_0 : natural_16383_1d(0 to 24);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_first_column : boolean;
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
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_first_column : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_index_0_2 : natural range 0 to 23;
  signal slice0winner3_best_index_0_3 : natural range 0 to 24;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_first_column : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_index_0_1 : natural range 0 to 24;
  signal slice0winner4_tag_valid, slice0winner4_tag_map_column, slice0winner4_tag_first_column : boolean;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag_valid, slice0winner5_tag_map_column, slice0winner5_tag_first_column : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 16383;
  signal slice0_best_index_0_0 : natural range 0 to 39;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_first_column : boolean;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 1, 0 to 14);
  signal slice1shift_reference : natural_255_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 14);
  signal slice1cost_change_0 : integer_minus_255_to_255_1d(0 to 14);
  signal slice1cost_pixels_cost : natural_255_2d(0 to 1, 0 to 14);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 4095;
  signal slice1cost_write_column : natural range 0 to 4095;
  signal slice1cost_read_words : unsigned_22_1d(0 to 6);
  signal slice1cost_read_words_7 : unsigned(10 downto 0);
  signal slice1cost_ready_words : natural_4194303_1d(0 to 6);
  signal slice1cost_write_words : natural_4194303_1d(0 to 6);
  signal slice1cost_ready_words_7 : natural range 0 to 2047;
  signal slice1cost_column_0 : natural_2047_1d(0 to 14);
  signal slice1cost_write_words_7 : natural range 0 to 2047;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving : unsigned_22_1d(0 to 6);
  signal slice1window_leaving_7 : unsigned(10 downto 0);
  signal slice1window_entering_0 : natural_2047_1d(0 to 14);
  signal slice1window_change_0 : integer_minus_2047_to_2047_1d(0 to 14);
  signal slice1window_sum_0 : natural_16383_1d(0 to 14);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 14;
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 14;
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 14;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_index_0_0 : natural range 0 to 14;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner5_best_index_0_0 : natural range 0 to 14;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 39;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_first_column : boolean;
  -- best
  signal best_read_cost_0_0, best_waiting_cost_0_0, best_ready_cost_0_0 : natural range 0 to 16383;
  signal best_compared_cost_0_0, best_best_cost_0_0 : natural range 0 to 16383;
  signal best_read_index_0_0, best_waiting_index_0_0, best_ready_index_0_0 : natural range 0 to 39;
  signal best_read_tag_valid, best_read_tag_map_column, best_read_tag_first_column, best_waiting_tag_valid : boolean;
  signal best_waiting_tag_map_column, best_waiting_tag_first_column, best_ready_tag_valid : boolean;
  signal best_ready_tag_map_column, best_ready_tag_first_column, best_compared_tag_valid : boolean;
  signal best_compared_tag_map_column, best_compared_tag_first_column, best_last_pass, best_here_wins : boolean;
  signal best_best_tag_valid, best_best_tag_map_column, best_best_tag_first_column : boolean;
  signal best_column, best_place_column, best_write_column : natural range 0 to 1023;
  signal best_read_words_0 : unsigned(21 downto 0);
  signal best_ready_words_0, best_compared_words_0 : natural range 0 to 4194303;
  signal best_pass : natural range 0 to 7;
  signal best_base : natural range 0 to 248;
  signal best_compared_index_0_0, best_best_index_0_0 : natural range 0 to 255;
  -- winners
  signal winners_row, winners_read_tag_valid, winners_read_tag_output_column, winners_read_tag_start_of_frame : boolean;
  signal winners_read_tag_end_of_line, winners_winners_tag_valid, winners_winners_tag_output_column : boolean;
  signal winners_winners_tag_start_of_frame, winners_winners_tag_end_of_line : boolean;
  signal winners_column : natural range 0 to 1023;
  signal winners_write_address : natural range 0 to 2047;
  signal winners_write_word_0, winners_winners_disparity_0 : natural range 0 to 255;
  signal winners_read_word_0 : unsigned(7 downto 0);
  signal winners_read_word_0_memory_read_enable : boolean;
  signal winners_read_word_0_memory_read_address, winners_read_word_0_memory_write_address : unsigned(10 downto 0);
  signal winners_read_word_0_memory_write_data : unsigned(7 downto 0);
  signal best_read_words_0_memory_read_enable : boolean;
  signal best_read_words_0_memory_read_address, best_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal best_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_7_memory_read_enable : boolean;
  signal slice1window_leaving_7_memory_read_address, slice1window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_7_memory_write_data : unsigned(10 downto 0);
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
  signal slice1cost_read_words_7_memory_read_enable : boolean;
  signal slice1cost_read_words_7_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_7_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_7_memory_write_data : unsigned(10 downto 0);
  signal slice1cost_read_words_6_memory_read_enable : boolean;
  signal slice1cost_read_words_6_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_6_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_5_memory_read_enable : boolean;
  signal slice1cost_read_words_5_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_5_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_4_memory_read_enable : boolean;
  signal slice1cost_read_words_4_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_4_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(11 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(11 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(11 downto 0);
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
  signal slice0cost_read_words_12_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_12_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice0cost_read_words_11_memory_read_enable : boolean;
  signal slice0cost_read_words_11_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_11_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_10_memory_read_enable : boolean;
  signal slice0cost_read_words_10_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_10_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_9_memory_read_enable : boolean;
  signal slice0cost_read_words_9_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_9_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_8_memory_read_enable : boolean;
  signal slice0cost_read_words_8_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_8_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_7_memory_read_enable : boolean;
  signal slice0cost_read_words_7_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_7_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_6_memory_read_enable : boolean;
  signal slice0cost_read_words_6_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_6_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_5_memory_read_enable : boolean;
  signal slice0cost_read_words_5_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_5_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_4_memory_read_enable : boolean;
  signal slice0cost_read_words_4_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_4_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(11 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(11 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal passes_read_search_0_memory_read_enable : boolean;
  signal passes_read_search_0_memory_read_address, passes_read_search_0_memory_write_address : unsigned(10 downto 0);
  signal passes_read_search_0_memory_write_data : unsigned(15 downto 0);
  signal passes_read_reference_0_memory_read_enable : boolean;
  signal passes_read_reference_0_memory_read_address : unsigned(10 downto 0);
  signal passes_read_reference_0_memory_write_address : unsigned(10 downto 0);
  signal passes_read_reference_0_memory_write_data : unsigned(15 downto 0);
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

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(winners_winners_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(winners_winners_tag_valid and winners_winners_tag_output_column);
  disparity_start_of_frame <= as_bit(winners_winners_tag_start_of_frame and winners_winners_tag_valid and winners_winners_tag_output_column);
  disparity_end_of_line <= as_bit(winners_winners_tag_end_of_line and winners_winners_tag_valid and winners_winners_tag_output_column);

  winners_read_word_0_memory_read_enable <= true;
  winners_read_word_0_memory_read_address <= to_unsigned(passes_write_address, 11);
  winners_read_word_0_memory_write_address <= to_unsigned(winners_write_address, 11);
  winners_read_word_0_memory_write_data <= to_unsigned(winners_write_word_0, 8);
  winners_read_word_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => winners_read_word_0_memory_read_enable,
      read_address => winners_read_word_0_memory_read_address, read_data => winners_read_word_0,
      write_address => winners_read_word_0_memory_write_address, write_data => winners_read_word_0_memory_write_data);

  best_read_words_0_memory_read_enable <= true;
  best_read_words_0_memory_read_address <= to_unsigned(best_column, 10);
  best_read_words_0_memory_write_address <= to_unsigned(best_write_column, 10);
  best_read_words_0_memory_write_data <= to_unsigned(best_best_index_0_0, 8) & to_unsigned(best_best_cost_0_0, 14);
  best_read_words_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 22, address_bits => 10)
    port map (
      clock => clock, read_enable => best_read_words_0_memory_read_enable,
      read_address => best_read_words_0_memory_read_address, read_data => best_read_words_0,
      write_address => best_read_words_0_memory_write_address, write_data => best_read_words_0_memory_write_data);

  slice1window_leaving_7_memory_read_enable <= true;
  slice1window_leaving_7_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_7_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_7_memory_write_data <= to_unsigned(slice1cost_column_0(14), 11);
  slice1window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_7_memory_read_enable,
      read_address => slice1window_leaving_7_memory_read_address, read_data => slice1window_leaving_7,
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

  slice1cost_read_words_7_memory_read_enable <= true;
  slice1cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_7_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_7_memory_write_data <= to_unsigned(slice1cost_write_words_7, 11);
  slice1cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 2415, width => 11, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_7_memory_read_enable,
      read_address => slice1cost_read_words_7_memory_read_address, read_data => slice1cost_read_words_7,
      write_address => slice1cost_read_words_7_memory_write_address, write_data => slice1cost_read_words_7_memory_write_data);

  slice1cost_read_words_6_memory_read_enable <= true;
  slice1cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_6_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_6_memory_write_data <= to_unsigned(slice1cost_write_words(6), 22);
  slice1cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_6_memory_read_enable,
      read_address => slice1cost_read_words_6_memory_read_address, read_data => slice1cost_read_words(6),
      write_address => slice1cost_read_words_6_memory_write_address, write_data => slice1cost_read_words_6_memory_write_data);

  slice1cost_read_words_5_memory_read_enable <= true;
  slice1cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_5_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_5_memory_write_data <= to_unsigned(slice1cost_write_words(5), 22);
  slice1cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_5_memory_read_enable,
      read_address => slice1cost_read_words_5_memory_read_address, read_data => slice1cost_read_words(5),
      write_address => slice1cost_read_words_5_memory_write_address, write_data => slice1cost_read_words_5_memory_write_data);

  slice1cost_read_words_4_memory_read_enable <= true;
  slice1cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_4_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_4_memory_write_data <= to_unsigned(slice1cost_write_words(4), 22);
  slice1cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_4_memory_read_enable,
      read_address => slice1cost_read_words_4_memory_read_address, read_data => slice1cost_read_words(4),
      write_address => slice1cost_read_words_4_memory_write_address, write_data => slice1cost_read_words_4_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words(3), 22);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words(3),
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words(2), 22);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words(2),
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words(1), 22);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words(1),
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 12);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 12);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words(0), 22);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
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
  slice0cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_12_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_12_memory_write_data <= to_unsigned(slice0cost_write_words_12, 11);
  slice0cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 2415, width => 11, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_12_memory_read_enable,
      read_address => slice0cost_read_words_12_memory_read_address, read_data => slice0cost_read_words_12,
      write_address => slice0cost_read_words_12_memory_write_address, write_data => slice0cost_read_words_12_memory_write_data);

  slice0cost_read_words_11_memory_read_enable <= true;
  slice0cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_11_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_11_memory_write_data <= to_unsigned(slice0cost_write_words(11), 22);
  slice0cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_11_memory_read_enable,
      read_address => slice0cost_read_words_11_memory_read_address, read_data => slice0cost_read_words(11),
      write_address => slice0cost_read_words_11_memory_write_address, write_data => slice0cost_read_words_11_memory_write_data);

  slice0cost_read_words_10_memory_read_enable <= true;
  slice0cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_10_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_10_memory_write_data <= to_unsigned(slice0cost_write_words(10), 22);
  slice0cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_10_memory_read_enable,
      read_address => slice0cost_read_words_10_memory_read_address, read_data => slice0cost_read_words(10),
      write_address => slice0cost_read_words_10_memory_write_address, write_data => slice0cost_read_words_10_memory_write_data);

  slice0cost_read_words_9_memory_read_enable <= true;
  slice0cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_9_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_9_memory_write_data <= to_unsigned(slice0cost_write_words(9), 22);
  slice0cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_9_memory_read_enable,
      read_address => slice0cost_read_words_9_memory_read_address, read_data => slice0cost_read_words(9),
      write_address => slice0cost_read_words_9_memory_write_address, write_data => slice0cost_read_words_9_memory_write_data);

  slice0cost_read_words_8_memory_read_enable <= true;
  slice0cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_8_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_8_memory_write_data <= to_unsigned(slice0cost_write_words(8), 22);
  slice0cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_8_memory_read_enable,
      read_address => slice0cost_read_words_8_memory_read_address, read_data => slice0cost_read_words(8),
      write_address => slice0cost_read_words_8_memory_write_address, write_data => slice0cost_read_words_8_memory_write_data);

  slice0cost_read_words_7_memory_read_enable <= true;
  slice0cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_7_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_7_memory_write_data <= to_unsigned(slice0cost_write_words(7), 22);
  slice0cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_7_memory_read_enable,
      read_address => slice0cost_read_words_7_memory_read_address, read_data => slice0cost_read_words(7),
      write_address => slice0cost_read_words_7_memory_write_address, write_data => slice0cost_read_words_7_memory_write_data);

  slice0cost_read_words_6_memory_read_enable <= true;
  slice0cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_6_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_6_memory_write_data <= to_unsigned(slice0cost_write_words(6), 22);
  slice0cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_6_memory_read_enable,
      read_address => slice0cost_read_words_6_memory_read_address, read_data => slice0cost_read_words(6),
      write_address => slice0cost_read_words_6_memory_write_address, write_data => slice0cost_read_words_6_memory_write_data);

  slice0cost_read_words_5_memory_read_enable <= true;
  slice0cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_5_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_5_memory_write_data <= to_unsigned(slice0cost_write_words(5), 22);
  slice0cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_5_memory_read_enable,
      read_address => slice0cost_read_words_5_memory_read_address, read_data => slice0cost_read_words(5),
      write_address => slice0cost_read_words_5_memory_write_address, write_data => slice0cost_read_words_5_memory_write_data);

  slice0cost_read_words_4_memory_read_enable <= true;
  slice0cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_4_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_4_memory_write_data <= to_unsigned(slice0cost_write_words(4), 22);
  slice0cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_4_memory_read_enable,
      read_address => slice0cost_read_words_4_memory_read_address, read_data => slice0cost_read_words(4),
      write_address => slice0cost_read_words_4_memory_write_address, write_data => slice0cost_read_words_4_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words(3), 22);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words(3),
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words(2), 22);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words(2),
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words(1), 22);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words(1),
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 12);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 12);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words(0), 22);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 2415, width => 22, address_bits => 12)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words(0),
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  passes_read_search_0_memory_read_enable <= true;
  passes_read_search_0_memory_read_address <= to_unsigned(passes_search_address, 11);
  passes_read_search_0_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_search_0_memory_write_data <= to_unsigned(passes_write_search_0, 16);
  passes_read_search_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 16, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_search_0_memory_read_enable,
      read_address => passes_read_search_0_memory_read_address, read_data => passes_read_search_0,
      write_address => passes_read_search_0_memory_write_address, write_data => passes_read_search_0_memory_write_data);

  passes_read_reference_0_memory_read_enable <= true;
  passes_read_reference_0_memory_read_address <= to_unsigned(passes_reference_address, 11);
  passes_read_reference_0_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_reference_0_memory_write_data <= to_unsigned(passes_write_reference_0, 16);
  passes_read_reference_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 16, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_reference_0_memory_read_enable,
      read_address => passes_read_reference_0_memory_read_address, read_data => passes_read_reference_0,
      write_address => passes_read_reference_0_memory_write_address, write_data => passes_read_reference_0_memory_write_data);

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

  process (clock)
    variable raster_place_group_is_equal, delay_tag_row_start_is_equal, passes_row_is_equal : boolean;
    variable passes_coming_first_group_all, passes_coming_first_group_any, passes_row_ended_all : boolean;
    variable passes_shows_any, passes_showing_first_group_differs, passes_showing_output_any : boolean;
    variable passes_leaving_output_choice, passes_leaving_output_choice_2, passes_leaving_starts_choice : boolean;
    variable passes_leaving_starts_choice_2, passes_read_tag_border_column_differs : boolean;
    variable passes_read_tag_border_column_choice, passes_read_tag_first_cost_is_equal : boolean;
    variable passes_read_tag_leaves_window_differs : boolean;
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- slice0winner1_best_cost_0_#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- slice0winner2_best_cost_0_#_is_less
    variable slice0winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- slice0winner3_best_cost_0_#_is_less
    variable slice0winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice0winner4_best_cost_0_#_is_less
    variable slice0winner5_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_is_less : boolean_1d(0 to 6);  -- slice1winner1_best_cost_0_#_is_less
    variable slice1winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- slice1winner2_best_cost_0_#_is_less
    variable slice1winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- slice1winner3_best_cost_0_#_is_less
    variable slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less, best_base_any : boolean;
    variable best_base_is_equal, winners_row_differs, winners_column_any : boolean;
    variable rows_search_choice, rows_search_choice_2, rows_reference_choice : natural range 0 to 255;
    variable rows_reference_choice_2 : natural range 0 to 255;
    variable passes_search_start_choice, passes_search_start_choice_2 : natural range 0 to 127;
    variable passes_search_address_choice : natural range 0 to 127;
    variable passes_search_address_value : natural range 0 to 1024;
    variable passes_search_address_choice_2, passes_reference_address_choice : natural range 0 to 1023;
    variable best_write_column_choice, best_write_column_choice_2, winners_column_choice : natural range 0 to 1023;
    variable slice0cost_column_0_choice : natural_2047_1d(0 to 24);  -- slice0cost_column_0_#_choice
    variable slice0cost_column_0_choice_2 : natural_2047_1d(0 to 24);  -- slice0cost_column_0_#_choice_2
    variable slice0window_change_0_choice : natural_2047_1d(0 to 24);  -- slice0window_change_0_#_choice
    variable slice1cost_column_0_choice : natural_2047_1d(0 to 14);  -- slice1cost_column_0_#_choice
    variable slice1cost_column_0_choice_2 : natural_2047_1d(0 to 14);  -- slice1cost_column_0_#_choice_2
    variable slice1window_change_0_choice : natural_2047_1d(0 to 14);  -- slice1window_change_0_#_choice
    variable slice0window_sum_0_choice : natural_16383_1d(0 to 24);  -- slice0window_sum_0_#_choice
    variable slice1window_sum_0_choice : natural_16383_1d(0 to 14);  -- slice1window_sum_0_#_choice
    variable best_base_choice, best_base_choice_2 : natural range 0 to 31;
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
      delay_tag_row_start_is_equal := raster_place_column = 0;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (raster_place_group >= 7) and (raster_place_group < 487);
      delay_row_inside(1) <= raster_place_group < 480;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= delay_tag_row_start_is_equal;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_output_column <= (raster_place_group >= 3) and (raster_place_group < 483) and (raster_place_column <
        639);
      delay_tag_start_of_frame <= (raster_place_group = 3) and delay_tag_row_start_is_equal;
      -- rows
      if rows_ready_inside(0) then
        rows_search_choice := to_integer(rows_search_rows_ready_words_0(7 downto 0));
      else
        rows_search_choice := 0;
      end if;
      if rows_ready_inside(1) then
        rows_search_choice_2 := rows_search_rows_ready_newest_0;
      else
        rows_search_choice_2 := 0;
      end if;
      if rows_ready_inside(0) then
        rows_reference_choice := to_integer(rows_reference_rows_ready_words_0(7 downto 0));
      else
        rows_reference_choice := 0;
      end if;
      if rows_ready_inside(1) then
        rows_reference_choice_2 := rows_reference_rows_ready_newest_0;
      else
        rows_reference_choice_2 := 0;
      end if;
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_ready_column <= rows_read_column;
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_search <= rows_search_choice + (rows_search_choice_2 * 256);
      rows_reference <= rows_reference_choice + (rows_reference_choice_2 * 256);
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
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
      -- passes
      passes_row_is_equal := rows_write_column = 639;
      if passes_row_is_equal then
        passes_row <= rows_tag_valid /= passes_row;
      end if;
      passes_coming_first_group_all := rows_tag_row_start and rows_tag_valid;
      passes_coming_first_group_any := (not rows_tag_row_start) or (not rows_tag_valid);
      passes_row_ended_all := passes_row_is_equal and rows_tag_valid;
      passes_shows_any := (not passes_last_pass) or (not passes_pass_ends);
      passes_showing_first_group_differs := rows_write_column /= 639;
      passes_showing_output_any := passes_showing_first_group_differs or (not rows_tag_valid);
      if passes_shows_any then
        passes_search_start_choice := ((passes_search_start / 8) + 5) mod 128;
      else
        passes_search_start_choice := 5;
      end if;
      if passes_pass_ends then
        passes_search_start_choice_2 := passes_search_start_choice;
      else
        passes_search_start_choice_2 := passes_search_start / 8;
      end if;
      passes_search_address_value := as_number((not passes_row)) * 1024;
      if passes_shows_any then
        passes_search_address_choice := passes_search_start / 8;
      else
        passes_search_address_choice := 0;
      end if;
      if passes_pass_ends then
        passes_search_address_choice_2 := passes_search_address_choice * 8;
      else
        passes_search_address_choice_2 := (passes_search_address + as_number(passes_shows)) mod 1024;
      end if;
      if passes_pass_ends then
        passes_reference_address_choice := 985;
      else
        passes_reference_address_choice := (passes_reference_address + as_number(passes_shows)) mod 1024;
      end if;
      if passes_ended_last then
        passes_leaving_output_choice := passes_leaving_output;
      else
        passes_leaving_output_choice := (not rows_tag_valid) and passes_leaving_output;
      end if;
      if rows_tag_row_start then
        passes_leaving_output_choice_2 := passes_leaving_output_choice;
      else
        passes_leaving_output_choice_2 := passes_leaving_output;
      end if;
      if passes_row_is_equal then
        passes_leaving_starts_choice := rows_tag_valid or passes_leaving_starts;
      else
        passes_leaving_starts_choice := passes_leaving_starts;
      end if;
      if passes_row_is_equal then
        passes_leaving_starts_choice_2 := (not rows_tag_valid) and passes_leaving_starts;
      else
        passes_leaving_starts_choice_2 := passes_leaving_starts;
      end if;
      passes_read_tag_border_column_differs := passes_column /= 39;
      if passes_column = 0 then
        passes_read_tag_border_column_choice := passes_read_tag_border_column_differs;
      else
        passes_read_tag_border_column_choice := (passes_column = 480) and passes_read_tag_border_column_differs;
      end if;
      passes_read_tag_first_cost_is_equal := passes_column = 39;
      passes_read_tag_leaves_window_differs := passes_column /= 0;
      passes_row_ended <= passes_row_ended_all;
      passes_arrived <= rows_tag_valid;
      passes_pass_ends <= passes_column = 481;
      passes_last_pass <= passes_pass = 4;
      passes_search_start <= passes_search_start_choice_2 * 8;
      passes_search_address <= passes_search_address_value + passes_search_address_choice_2;
      passes_reference_address <= passes_search_address_value + passes_reference_address_choice;
      passes_read_tag_valid <= passes_shows;
      passes_read_tag_row_start <= to_integer(((to_unsigned(passes_pass, 9)) or (to_unsigned(passes_column, 9)))) = 0;
      passes_read_tag_first_group <= passes_showing_first_group;
      passes_read_tag_first_cost <= passes_read_tag_first_cost_is_equal;
      passes_read_tag_end_of_line <= passes_column = 478;
      passes_search(0) <= to_integer(passes_read_search_0(7 downto 0));
      passes_search(1) <= to_integer(passes_read_search_0(15 downto 8));
      passes_reference(0) <= to_integer(passes_read_reference_0(7 downto 0));
      passes_reference(1) <= to_integer(passes_read_reference_0(15 downto 8));
      passes_tag_valid <= passes_read_tag_valid;
      passes_tag_row_start <= passes_read_tag_row_start;
      passes_tag_first_group <= passes_read_tag_first_group;
      passes_tag_border_column <= passes_read_tag_border_column;
      passes_tag_first_cost <= passes_read_tag_first_cost;
      passes_tag_leaves_window <= passes_read_tag_leaves_window;
      passes_tag_map_column <= passes_read_tag_map_column;
      if rows_tag_first_group then
        passes_coming_first_group <= passes_coming_first_group or passes_coming_first_group_all;
      else
        passes_coming_first_group <= passes_coming_first_group and passes_coming_first_group_any;
      end if;
      if rows_tag_output_column then
        passes_coming_output <= passes_coming_output or passes_coming_first_group_all;
      else
        passes_coming_output <= passes_coming_output and passes_coming_first_group_any;
      end if;
      if rows_tag_start_of_frame then
        passes_coming_starts <= passes_coming_starts or passes_coming_first_group_all;
      else
        passes_coming_starts <= passes_coming_starts and passes_coming_first_group_any;
      end if;
      if passes_row_ended then
        passes_shows <= (not passes_shows) or (not passes_last_pass) or (not passes_pass_ends);
      else
        passes_shows <= passes_shows and passes_shows_any;
      end if;
      if passes_showing_first_group then
        passes_showing_first_group <= passes_coming_first_group or passes_showing_first_group_differs or (not
          rows_tag_valid);
      else
        passes_showing_first_group <= passes_coming_first_group and passes_row_is_equal and rows_tag_valid;
      end if;
      if passes_coming_output then
        passes_showing_output <= passes_showing_output or passes_row_ended_all;
      else
        passes_showing_output <= passes_showing_output and passes_showing_output_any;
      end if;
      if passes_coming_starts then
        passes_showing_starts <= passes_showing_starts or passes_row_ended_all;
      else
        passes_showing_starts <= passes_showing_starts and passes_showing_output_any;
      end if;
      if passes_pass_ends then
        passes_column <= 0;
      else
        passes_column <= (passes_column + as_number(passes_shows)) mod 512;
      end if;
      if passes_leaving_output_choice_2 then
        passes_leaving_output <= passes_showing_output or passes_showing_first_group_differs or (not rows_tag_valid);
      else
        passes_leaving_output <= passes_showing_output and passes_row_is_equal and rows_tag_valid;
      end if;
      if passes_showing_starts then
        passes_leaving_starts <= passes_leaving_starts_choice;
      else
        passes_leaving_starts <= passes_leaving_starts_choice_2;
      end if;
      if passes_read_tag_border_column then
        passes_read_tag_border_column <= passes_read_tag_border_column_differs;
      else
        passes_read_tag_border_column <= passes_read_tag_border_column_choice;
      end if;
      if passes_read_tag_leaves_window then
        passes_read_tag_leaves_window <= passes_read_tag_leaves_window_differs;
      else
        passes_read_tag_leaves_window <= (passes_column = 46) and passes_read_tag_leaves_window_differs;
      end if;
      if passes_read_tag_map_column then
        passes_read_tag_map_column <= passes_read_tag_first_cost_is_equal or (not passes_read_tag_end_of_line);
      else
        passes_read_tag_map_column <= passes_read_tag_first_cost_is_equal;
      end if;
      if rows_tag_valid then
        passes_ended_last <= passes_row_is_equal;
        passes_write_address <= rows_write_column + (as_number(passes_row) * 1024);
        passes_write_search_0 <= rows_search;
        passes_write_reference_0 <= rows_reference;
      end if;
      if passes_pass_ends then
        if passes_shows_any then
          passes_pass <= (passes_pass + 1) mod 8;
        else
          passes_pass <= 0;
        end if;
      end if;
      -- slice0shift
      if passes_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 23 loop
            slice0shift_search(i, j) <= slice0shift_search(i, j + 1);
          end loop;
          slice0shift_search(i, 24) <= passes_search(i);
        end loop;
      end if;
      slice0shift_reference(0) <= passes_reference(0);
      slice0shift_reference(1) <= passes_reference(1);
      slice0shift_search_out(0) <= slice0shift_search(0, 0);
      slice0shift_search_out(1) <= slice0shift_search(1, 0);
      slice0shift_tag_valid <= passes_tag_valid;
      slice0shift_tag_row_start <= passes_tag_row_start;
      slice0shift_tag_first_group <= passes_tag_first_group;
      slice0shift_tag_border_column <= passes_tag_border_column;
      slice0shift_tag_first_cost <= passes_tag_first_cost;
      slice0shift_tag_leaves_window <= passes_tag_leaves_window;
      slice0shift_tag_map_column <= passes_tag_map_column;
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
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      for i in 0 to 1 loop
        for j in 0 to 24 loop
          slice0cost_pixels_cost(i, j) <= (folded(slice0cost_pixels_first(i, j)) +
            as_number((slice0cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      for i in 0 to 24 loop
        slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 11 loop
        slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i));
      end loop;
      slice0cost_ready_words_12 <= to_integer(slice0cost_read_words_12);
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
      for i in 0 to 24 loop
        slice0cost_column_0(i) <= slice0cost_column_0_choice_2(i);
      end loop;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_border_column <= slice0cost_ready_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_ready_tag_first_cost;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 4096;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 4096;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        for i in 0 to 11 loop
          slice0cost_write_words(i) <= (slice0cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice0cost_column_0_choice_2(2 * i);
        end loop;
        slice0cost_write_words_12 <= slice0cost_column_0_choice_2(24);
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
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      for i in 0 to 24 loop
        slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
      end loop;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_centre_map_column(0) <= slice0window_change_tag_map_column;
      slice0window_centre_first_column(0) <= slice0window_change_tag_first_cost;
      slice0window_tag_valid <= slice0window_change_tag_valid;
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
      if slice0window_tag_valid then
        slice0window_centre_map_column(1) <= slice0window_centre_map_column(0);
        slice0window_centre_map_column(2) <= slice0window_centre_map_column(1);
        slice0window_centre_first_column(1) <= slice0window_centre_first_column(0);
        slice0window_centre_first_column(2) <= slice0window_centre_first_column(1);
        slice0window_tag_map_column <= slice0window_centre_map_column(2);
        slice0window_tag_first_column <= slice0window_centre_first_column(2);
      end if;
      -- slice0winner1
      for i in 0 to 11 loop
        slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
      end loop;
      slice0winner1_best_cost_0(12) <= slice0window_sum_0(24);
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
      slice0winner1_best_index_0_12 <= 24;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_map_column <= slice0window_tag_map_column;
      slice0winner1_tag_first_column <= slice0window_tag_first_column;
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
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_first_column <= slice0winner1_tag_first_column;
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
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_first_column <= slice0winner2_tag_first_column;
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
      slice0winner4_tag_map_column <= slice0winner3_tag_map_column;
      slice0winner4_tag_first_column <= slice0winner3_tag_first_column;
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
      -- slice0winner5
      slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0(1) - slice0winner4_best_cost_0(0)) < 0;
      slice0winner5_tag_valid <= slice0winner4_tag_valid;
      slice0winner5_tag_map_column <= slice0winner4_tag_map_column;
      slice0winner5_tag_first_column <= slice0winner4_tag_first_column;
      if slice0winner5_best_cost_0_0_is_less then
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0(1);
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_1;
      else
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0(0);
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_0;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 15;
      slice0_best_tag_valid <= slice0winner5_tag_valid;
      slice0_best_tag_map_column <= slice0winner5_tag_map_column;
      slice0_best_tag_first_column <= slice0winner5_tag_first_column;
      -- slice1shift
      if slice0shift_tag_valid then
        for i in 0 to 1 loop
          for j in 0 to 13 loop
            slice1shift_search(i, j) <= slice1shift_search(i, j + 1);
          end loop;
          slice1shift_search(i, 14) <= slice0shift_search_out(i);
        end loop;
      end if;
      slice1shift_reference(0) <= slice0shift_reference(0);
      slice1shift_reference(1) <= slice0shift_reference(1);
      -- slice1cost
      for i in 0 to 6 loop
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
        slice1cost_column_0_choice(14) := 0;
      else
        slice1cost_column_0_choice(14) := slice1cost_ready_words_7;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_choice_2(14) := 0;
      else
        slice1cost_column_0_choice_2(14) := (slice1cost_change_0(14) + slice1cost_column_0_choice(14)) mod 2048;
      end if;
      for i in 0 to 14 loop
        slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
      end loop;
      for i in 0 to 14 loop
        slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 14 loop
          slice1cost_pixels_cost(i, j) <= (folded(slice1cost_pixels_first(i, j)) +
            as_number((slice1cost_pixels_first(i, j) < 0))) mod 256;
        end loop;
      end loop;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice1cost_read_column;
      for i in 0 to 14 loop
        slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 6 loop
        slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i));
      end loop;
      slice1cost_ready_words_7 <= to_integer(slice1cost_read_words_7);
      for i in 0 to 14 loop
        slice1cost_column_0(i) <= slice1cost_column_0_choice_2(i);
      end loop;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        for i in 0 to 6 loop
          slice1cost_write_words(i) <= (slice1cost_column_0_choice_2(2 * i + 1) * 2048) +
            slice1cost_column_0_choice_2(2 * i);
        end loop;
        slice1cost_write_words_7 <= slice1cost_column_0_choice_2(14);
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
      for i in 0 to 2 loop
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
      for i in 12 to 13 loop
        if slice0window_change_tag_leaves_window then
          slice1window_change_0_choice(i) := to_integer(slice1window_leaving(6)(11 * i - 122 downto 11 * i - 132));
        else
          slice1window_change_0_choice(i) := 0;
        end if;
      end loop;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_choice(14) := to_integer(slice1window_leaving_7);
      else
        slice1window_change_0_choice(14) := 0;
      end if;
      for i in 0 to 14 loop
        slice1window_entering_0(i) <= slice1cost_column_0(i);
      end loop;
      for i in 0 to 14 loop
        slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
      end loop;
      for i in 0 to 14 loop
        if slice0window_centre_first_column(0) then
          slice1window_sum_0_choice(i) := 0;
        else
          slice1window_sum_0_choice(i) := slice1window_sum_0(i);
        end if;
      end loop;
      if slice0window_tag_valid then
        for i in 0 to 14 loop
          slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
        end loop;
      end if;
      -- slice1winner1
      for i in 0 to 6 loop
        slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
      end loop;
      slice1winner1_best_cost_0(7) <= slice1window_sum_0(14);
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
      slice1winner1_best_index_0_7 <= 14;
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
      -- slice1winner2
      for i in 0 to 3 loop
        slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 *
          i)) < 0;
      end loop;
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
      -- slice1winner3
      slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
      slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
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
      -- slice1winner4
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
      if slice1winner4_best_cost_0_0_is_less then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(1);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0(0);
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
      end if;
      -- slice1winner5
      slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0_0;
      slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_0;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_first_column <= slice0_best_tag_first_column;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner5_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner5_best_index_0_0;
      end if;
      -- best
      best_base_any := (not best_waiting_tag_valid) or (not best_waiting_tag_first_column);
      best_base_is_equal := best_pass = 4;
      if best_base_is_equal then
        best_base_choice := 0;
      else
        best_base_choice := ((best_base / 8) + 5) mod 32;
      end if;
      if best_base_any then
        best_base_choice_2 := best_base / 8;
      else
        best_base_choice_2 := best_base_choice;
      end if;
      if best_compared_tag_first_column then
        best_write_column_choice := 0;
      else
        best_write_column_choice := (best_place_column + 1) mod 1024;
      end if;
      if best_compared_tag_valid then
        best_write_column_choice_2 := best_write_column_choice;
      else
        best_write_column_choice_2 := best_place_column;
      end if;
      best_read_cost_0_0 <= slice1_best_cost_0_0;
      best_read_index_0_0 <= slice1_best_index_0_0;
      best_read_tag_valid <= slice1_best_tag_valid;
      best_read_tag_map_column <= slice1_best_tag_map_column;
      best_read_tag_first_column <= slice1_best_tag_first_column;
      best_waiting_cost_0_0 <= best_read_cost_0_0;
      best_waiting_index_0_0 <= best_read_index_0_0;
      best_waiting_tag_valid <= best_read_tag_valid;
      best_waiting_tag_map_column <= best_read_tag_map_column;
      best_waiting_tag_first_column <= best_read_tag_first_column;
      best_ready_cost_0_0 <= best_waiting_cost_0_0;
      best_ready_index_0_0 <= best_waiting_index_0_0;
      best_ready_tag_valid <= best_waiting_tag_valid;
      best_ready_tag_map_column <= best_waiting_tag_map_column;
      best_ready_tag_first_column <= best_waiting_tag_first_column;
      best_ready_words_0 <= to_integer(best_read_words_0);
      best_base <= best_base_choice_2 * 8;
      best_compared_cost_0_0 <= best_ready_cost_0_0;
      best_compared_index_0_0 <= ((((best_base / 8) + (best_ready_index_0_0 / 8)) mod 32) * 8) + (best_ready_index_0_0
        mod 8);
      best_compared_tag_valid <= best_ready_tag_valid;
      best_compared_tag_map_column <= best_ready_tag_map_column;
      best_compared_tag_first_column <= best_ready_tag_first_column;
      best_compared_words_0 <= best_ready_words_0;
      best_last_pass <= best_base_is_equal;
      best_here_wins <= ((best_ready_cost_0_0 - (best_ready_words_0 mod 16384)) < 0) or (best_pass = 0);
      best_best_tag_valid <= best_compared_tag_valid;
      best_best_tag_map_column <= best_last_pass and best_compared_tag_map_column;
      best_best_tag_first_column <= best_last_pass and best_compared_tag_first_column;
      if best_here_wins then
        best_best_cost_0_0 <= best_compared_cost_0_0;
        best_best_index_0_0 <= best_compared_index_0_0;
      else
        best_best_cost_0_0 <= best_compared_words_0 mod 16384;
        best_best_index_0_0 <= best_compared_words_0 / 16384;
      end if;
      if (not best_compared_tag_map_column) or (not best_compared_tag_valid) then
        best_write_column <= 1023;
      else
        best_write_column <= best_write_column_choice_2;
      end if;
      if slice1_best_tag_valid then
        if slice1_best_tag_first_column then
          best_column <= 0;
        else
          best_column <= (best_column + 1) mod 1024;
        end if;
      end if;
      if not best_base_any then
        if best_base_is_equal then
          best_pass <= 0;
        else
          best_pass <= (best_pass + 1) mod 8;
        end if;
      end if;
      if best_compared_tag_valid then
        best_place_column <= best_write_column_choice;
      end if;
      -- winners
      winners_row_differs := winners_row /= best_best_tag_first_column;
      if best_best_tag_valid then
        if best_best_tag_map_column then
          winners_row <= winners_row_differs;
        else
          winners_row <= winners_row;
        end if;
      end if;
      if best_best_tag_first_column then
        winners_column_choice := 0;
      else
        winners_column_choice := winners_column;
      end if;
      winners_column_any := (not best_best_tag_valid) or (not best_best_tag_map_column);
      if not winners_column_any then
        winners_column <= (winners_column_choice + 1) mod 1024;
      end if;
      winners_write_word_0 <= best_best_index_0_0;
      winners_read_tag_valid <= passes_arrived;
      winners_read_tag_output_column <= ((passes_write_address mod 1024) < 440) and passes_leaving_output;
      winners_read_tag_start_of_frame <= ((passes_write_address mod 1024) = 0) and passes_leaving_starts;
      winners_read_tag_end_of_line <= (passes_write_address mod 1024) = 439;
      winners_winners_disparity_0 <= to_integer(winners_read_word_0);
      winners_winners_tag_valid <= winners_read_tag_valid;
      winners_winners_tag_output_column <= winners_read_tag_output_column;
      winners_winners_tag_start_of_frame <= winners_read_tag_start_of_frame;
      winners_winners_tag_end_of_line <= winners_read_tag_end_of_line;
      if winners_column_any then
        winners_write_address <= 2047;
      else
        winners_write_address <= winners_column_choice + (as_number(winners_row_differs) * 1024);
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 483;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        passes_row <= false;
        passes_coming_output <= false;
        passes_coming_starts <= false;
        passes_row_ended <= false;
        passes_ended_last <= false;
        passes_arrived <= false;
        passes_write_address <= 0;
        passes_shows <= false;
        passes_showing_output <= false;
        passes_showing_starts <= false;
        passes_pass <= 0;
        passes_column <= 0;
        passes_pass_ends <= false;
        passes_last_pass <= false;
        passes_search_start <= 40;
        passes_search_address <= 0;
        passes_reference_address <= 985;
        passes_leaving_output <= false;
        passes_leaving_starts <= false;
        passes_read_tag_valid <= false;
        passes_read_tag_row_start <= false;
        passes_read_tag_first_cost <= false;
        passes_read_tag_map_column <= false;
        passes_read_tag_end_of_line <= false;
        passes_tag_valid <= false;
        passes_tag_row_start <= false;
        passes_tag_first_cost <= false;
        passes_tag_map_column <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_first_cost <= false;
        slice0shift_tag_map_column <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_first_cost <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_first_cost <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_first_cost <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_first_cost <= false;
        slice0cost_tag_map_column <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_first_cost <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_first_cost <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_centre_map_column(0) <= false;
        slice0window_centre_map_column(1) <= false;
        slice0window_centre_map_column(2) <= false;
        slice0window_centre_first_column(0) <= false;
        slice0window_centre_first_column(1) <= false;
        slice0window_centre_first_column(2) <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_first_column <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_first_column <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_first_column <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_first_column <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_map_column <= false;
        slice0winner4_tag_first_column <= false;
        slice0winner5_tag_valid <= false;
        slice0winner5_tag_map_column <= false;
        slice0winner5_tag_first_column <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_first_column <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_first_column <= false;
        best_read_tag_valid <= false;
        best_read_tag_map_column <= false;
        best_read_tag_first_column <= false;
        best_column <= 0;
        best_waiting_tag_valid <= false;
        best_waiting_tag_map_column <= false;
        best_waiting_tag_first_column <= false;
        best_ready_tag_valid <= false;
        best_ready_tag_map_column <= false;
        best_ready_tag_first_column <= false;
        best_pass <= 4;
        best_compared_tag_valid <= false;
        best_compared_tag_map_column <= false;
        best_compared_tag_first_column <= false;
        best_last_pass <= false;
        best_best_tag_valid <= false;
        best_best_tag_map_column <= false;
        best_best_tag_first_column <= false;
        best_place_column <= 0;
        best_write_column <= 0;
        winners_row <= true;
        winners_column <= 0;
        winners_write_address <= 0;
        winners_read_tag_valid <= false;
        winners_read_tag_output_column <= false;
        winners_read_tag_start_of_frame <= false;
        winners_read_tag_end_of_line <= false;
        winners_winners_tag_valid <= false;
        winners_winners_tag_output_column <= false;
        winners_winners_tag_start_of_frame <= false;
        winners_winners_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
