-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_w10_recursive_p4: 32x12, 9 disparities, window 10x10, 4 pixel pairs a clock.
-- Options: disparities 9, window_px 10, aggregation recursive, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_w10_recursive_p4
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_w10_recursive_p4 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 9;
    pixels_per_clock : positive := 4;
    disparity_bits : positive := 8;
    output_width_px : positive := 23;
    latency_clocks : positive := 18;
    flush_groups : positive := 35;
    gap_groups : positive := 32
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(31 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(31 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(31 downto 0);
    pixel_valid : out std_logic_vector(3 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 32 report "stereo_core_tiny_w10_recursive_p4: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_w10_recursive_p4: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 9 report "stereo_core_tiny_w10_recursive_p4: disparities is " & integer'image(disparities) & " but this core has 9" severity failure;
  assert pixels_per_clock = 4 report "stereo_core_tiny_w10_recursive_p4: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 4" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_w10_recursive_p4: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 23 report "stereo_core_tiny_w10_recursive_p4: output_width_px is " & integer'image(output_width_px) & " but this core has 23" severity failure;
  assert latency_clocks = 18 report "stereo_core_tiny_w10_recursive_p4: latency_clocks is " & integer'image(latency_clocks) & " but this core has 18" severity failure;
  assert flush_groups = 35 report "stereo_core_tiny_w10_recursive_p4: flush_groups is " & integer'image(flush_groups) & " but this core has 35" severity failure;
  assert gap_groups = 32 report "stereo_core_tiny_w10_recursive_p4: gap_groups is " & integer'image(gap_groups) & " but this core has 32" severity failure;
end entity;

architecture rtl of stereo_core_tiny_w10_recursive_p4 is
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
  signal in_left_pixel : unsigned(31 downto 0);
  signal in_right_pixel : unsigned(31 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_search_1, raster_features_search_2 : natural range 0 to 255;
  signal raster_features_search_3 : natural range 0 to 255;
  signal raster_features_reference : unsigned(31 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 7;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0, delay_ahead_1, delay_ahead_2, delay_ahead_3 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(31 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_2, delay_row_inside_4, delay_tag_valid, delay_tag_row_start : boolean;
  signal delay_tag_first_group, delay_tag_border_column, delay_tag_first_cost, delay_tag_leaves_window : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_2, rows_reference_rows_read_words_2 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_read_newest_1 : natural range 0 to 255;
  signal rows_search_rows_read_newest_2, rows_search_rows_read_newest_3 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_0, rows_search_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_3, rows_reference_rows_read_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_1, rows_reference_rows_read_newest_2 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_3, rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_ready_newest_1, rows_reference_rows_ready_newest_3, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_search_3, rows_search_4, rows_search_5 : natural range 0 to 255;
  signal rows_search_6, rows_search_7, rows_reference_0, rows_reference_1, rows_reference_2 : natural range 0 to 255;
  signal rows_reference_3, rows_reference_4, rows_reference_5, rows_reference_6 : natural range 0 to 255;
  signal rows_reference_7 : natural range 0 to 255;
  signal rows_search_rows_ready_words_2, rows_search_rows_write_words_2 : natural range 0 to 65535;
  signal rows_reference_rows_ready_words_2, rows_reference_rows_write_words_2 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_2, rows_read_inside_4, rows_read_tag_valid : boolean;
  signal rows_read_tag_row_start, rows_read_tag_first_group, rows_read_tag_border_column : boolean;
  signal rows_read_tag_first_cost, rows_read_tag_leaves_window, rows_read_tag_output_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_2 : boolean;
  signal rows_ready_inside_4, rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_leaves_window : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_border_column : boolean;
  signal rows_tag_first_cost, rows_tag_leaves_window, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 255;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 255;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 255;
  signal slice0shift_search_4_0, slice0shift_search_4_1, slice0shift_search_4_2 : natural range 0 to 255;
  signal slice0shift_search_5_0, slice0shift_search_5_1, slice0shift_search_5_2 : natural range 0 to 255;
  signal slice0shift_search_6_0, slice0shift_search_6_1, slice0shift_search_6_2 : natural range 0 to 255;
  signal slice0shift_search_7_0, slice0shift_search_7_1, slice0shift_search_7_2 : natural range 0 to 255;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 255;
  signal slice0shift_reference_3, slice0shift_reference_4, slice0shift_reference_5 : natural range 0 to 255;
  signal slice0shift_reference_6, slice0shift_reference_7, slice0shift_search_out_0 : natural range 0 to 255;
  signal slice0shift_search_out_1, slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 255;
  signal slice0shift_search_out_4, slice0shift_search_out_5, slice0shift_search_out_6 : natural range 0 to 255;
  signal slice0shift_search_out_7 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_2, slice0cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_1, slice0cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice0cost_pixels_first_2_0, slice0cost_pixels_first_2_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_2_2, slice0cost_pixels_first_3_0 : integer range -255 to 255;
  signal slice0cost_pixels_first_3_1, slice0cost_pixels_first_3_2 : integer range -255 to 255;
  signal slice0cost_pixels_first_4_0, slice0cost_pixels_first_4_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_4_2, slice0cost_pixels_first_5_0 : integer range -255 to 255;
  signal slice0cost_pixels_first_5_1, slice0cost_pixels_first_5_2 : integer range -255 to 255;
  signal slice0cost_pixels_first_6_0, slice0cost_pixels_first_6_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_6_2, slice0cost_pixels_first_7_0 : integer range -255 to 255;
  signal slice0cost_pixels_first_7_1, slice0cost_pixels_first_7_2, slice0cost_change_0_0 : integer range -255 to 255;
  signal slice0cost_change_0_1, slice0cost_change_0_2 : integer range -255 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_first_group, slice0cost_ready_tag_border_column : boolean;
  signal slice0cost_ready_tag_first_cost, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_output_column, slice0cost_ready_tag_start_of_frame : boolean;
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_first_group : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_first_cost, slice0cost_tag_leaves_window : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1, slice0cost_pixels_cost_2_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_3_0, slice0cost_pixels_cost_3_1, slice0cost_pixels_cost_3_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_4_0, slice0cost_pixels_cost_4_1, slice0cost_pixels_cost_4_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_5_0, slice0cost_pixels_cost_5_1, slice0cost_pixels_cost_5_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_6_0, slice0cost_pixels_cost_6_1, slice0cost_pixels_cost_6_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_7_0, slice0cost_pixels_cost_7_1, slice0cost_pixels_cost_7_2 : natural range 0 to 255;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 31;
  signal slice0cost_write_column : natural range 0 to 31;
  signal slice0cost_read_words_0 : unsigned(23 downto 0);
  signal slice0cost_read_words_1 : unsigned(11 downto 0);
  signal slice0cost_change_1_0, slice0cost_change_1_1, slice0cost_change_1_2 : integer range -2048 to 2047;
  signal slice0cost_change_2_0, slice0cost_change_2_1, slice0cost_change_2_2 : integer range -2048 to 2047;
  signal slice0cost_change_3_0, slice0cost_change_3_1, slice0cost_change_3_2 : integer range -2048 to 2047;
  signal slice0cost_ready_words_0, slice0cost_write_words_0 : natural range 0 to 16777215;
  signal slice0cost_ready_words_1, slice0cost_column_0_0, slice0cost_column_0_1 : natural range 0 to 4095;
  signal slice0cost_column_0_2, slice0cost_column_1_0, slice0cost_column_1_1 : natural range 0 to 4095;
  signal slice0cost_column_1_2, slice0cost_column_2_0, slice0cost_column_2_1 : natural range 0 to 4095;
  signal slice0cost_column_2_2, slice0cost_column_3_0, slice0cost_column_3_1 : natural range 0 to 4095;
  signal slice0cost_column_3_2, slice0cost_write_words_1 : natural range 0 to 4095;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(23 downto 0);
  signal slice0window_leaving_3, slice0window_leaving_4, slice0window_leaving_5 : unsigned(23 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 4095;
  signal slice0window_entering_1_0, slice0window_entering_1_1, slice0window_entering_1_2 : natural range 0 to 4095;
  signal slice0window_entering_2_0, slice0window_entering_2_1, slice0window_entering_2_2 : natural range 0 to 4095;
  signal slice0window_entering_3_0, slice0window_entering_3_1, slice0window_entering_3_2 : natural range 0 to 4095;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_group : boolean;
  signal slice0window_entering_tag_border_column, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_output_column_1 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_start_of_frame_1, slice0window_centre_start_of_frame_2 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_centre_end_of_line_1, slice0window_tag_valid : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -4095 to 4095;
  signal slice0window_change_1_0, slice0window_change_1_1, slice0window_change_1_2 : integer range -4095 to 4095;
  signal slice0window_change_2_0, slice0window_change_2_1, slice0window_change_2_2 : integer range -4095 to 4095;
  signal slice0window_change_3_0, slice0window_change_3_1, slice0window_change_3_2 : integer range -4095 to 4095;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 32767;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 32767;
  signal slice0window_sum_2_0, slice0window_sum_2_1, slice0window_sum_2_2 : natural range 0 to 32767;
  signal slice0window_sum_3_0, slice0window_sum_3_1, slice0window_sum_3_2 : natural range 0 to 32767;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 32767;
  signal slice0winner1_best_cost_1_0, slice0winner1_best_cost_1_1 : natural range 0 to 32767;
  signal slice0winner1_best_cost_2_0, slice0winner1_best_cost_2_1 : natural range 0 to 32767;
  signal slice0winner1_best_cost_3_0, slice0winner1_best_cost_3_1 : natural range 0 to 32767;
  signal slice0winner1_best_index_0_0, slice0winner1_best_index_1_0, slice0winner1_best_index_2_0 : boolean;
  signal slice0winner1_best_index_3_0, slice0winner1_tag_valid, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 2;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_1_0 : natural range 0 to 32767;
  signal slice0winner2_best_cost_2_0, slice0winner2_best_cost_3_0 : natural range 0 to 32767;
  signal slice0winner2_best_index_0_0, slice0winner2_best_index_1_0 : natural range 0 to 2;
  signal slice0winner2_best_index_2_0, slice0winner2_best_index_3_0 : natural range 0 to 2;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_cost_1_0, slice0_best_cost_2_0 : natural range 0 to 32767;
  signal slice0_best_cost_3_0 : natural range 0 to 32767;
  signal slice0_best_index_0_0, slice0_best_index_1_0, slice0_best_index_2_0 : natural range 0 to 9;
  signal slice0_best_index_3_0 : natural range 0 to 9;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 255;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 255;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 255;
  signal slice1shift_search_4_0, slice1shift_search_4_1, slice1shift_search_4_2 : natural range 0 to 255;
  signal slice1shift_search_5_0, slice1shift_search_5_1, slice1shift_search_5_2 : natural range 0 to 255;
  signal slice1shift_search_6_0, slice1shift_search_6_1, slice1shift_search_6_2 : natural range 0 to 255;
  signal slice1shift_search_7_0, slice1shift_search_7_1, slice1shift_search_7_2 : natural range 0 to 255;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 255;
  signal slice1shift_reference_3, slice1shift_reference_4, slice1shift_reference_5 : natural range 0 to 255;
  signal slice1shift_reference_6, slice1shift_reference_7, slice1shift_search_out_0 : natural range 0 to 255;
  signal slice1shift_search_out_1, slice1shift_search_out_2, slice1shift_search_out_3 : natural range 0 to 255;
  signal slice1shift_search_out_4, slice1shift_search_out_5, slice1shift_search_out_6 : natural range 0 to 255;
  signal slice1shift_search_out_7 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_2, slice1cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_1, slice1cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice1cost_pixels_first_2_0, slice1cost_pixels_first_2_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_2_2, slice1cost_pixels_first_3_0 : integer range -255 to 255;
  signal slice1cost_pixels_first_3_1, slice1cost_pixels_first_3_2 : integer range -255 to 255;
  signal slice1cost_pixels_first_4_0, slice1cost_pixels_first_4_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_4_2, slice1cost_pixels_first_5_0 : integer range -255 to 255;
  signal slice1cost_pixels_first_5_1, slice1cost_pixels_first_5_2 : integer range -255 to 255;
  signal slice1cost_pixels_first_6_0, slice1cost_pixels_first_6_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_6_2, slice1cost_pixels_first_7_0 : integer range -255 to 255;
  signal slice1cost_pixels_first_7_1, slice1cost_pixels_first_7_2, slice1cost_change_0_0 : integer range -255 to 255;
  signal slice1cost_change_0_1, slice1cost_change_0_2 : integer range -255 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_2_0, slice1cost_pixels_cost_2_1, slice1cost_pixels_cost_2_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_3_0, slice1cost_pixels_cost_3_1, slice1cost_pixels_cost_3_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_4_0, slice1cost_pixels_cost_4_1, slice1cost_pixels_cost_4_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_5_0, slice1cost_pixels_cost_5_1, slice1cost_pixels_cost_5_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_6_0, slice1cost_pixels_cost_6_1, slice1cost_pixels_cost_6_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_7_0, slice1cost_pixels_cost_7_1, slice1cost_pixels_cost_7_2 : natural range 0 to 255;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 31;
  signal slice1cost_write_column : natural range 0 to 31;
  signal slice1cost_read_words_0 : unsigned(23 downto 0);
  signal slice1cost_read_words_1 : unsigned(11 downto 0);
  signal slice1cost_change_1_0, slice1cost_change_1_1, slice1cost_change_1_2 : integer range -2048 to 2047;
  signal slice1cost_change_2_0, slice1cost_change_2_1, slice1cost_change_2_2 : integer range -2048 to 2047;
  signal slice1cost_change_3_0, slice1cost_change_3_1, slice1cost_change_3_2 : integer range -2048 to 2047;
  signal slice1cost_ready_words_0, slice1cost_write_words_0 : natural range 0 to 16777215;
  signal slice1cost_ready_words_1, slice1cost_column_0_0, slice1cost_column_0_1 : natural range 0 to 4095;
  signal slice1cost_column_0_2, slice1cost_column_1_0, slice1cost_column_1_1 : natural range 0 to 4095;
  signal slice1cost_column_1_2, slice1cost_column_2_0, slice1cost_column_2_1 : natural range 0 to 4095;
  signal slice1cost_column_2_2, slice1cost_column_3_0, slice1cost_column_3_1 : natural range 0 to 4095;
  signal slice1cost_column_3_2, slice1cost_write_words_1 : natural range 0 to 4095;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(23 downto 0);
  signal slice1window_leaving_3, slice1window_leaving_4, slice1window_leaving_5 : unsigned(23 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 4095;
  signal slice1window_entering_1_0, slice1window_entering_1_1, slice1window_entering_1_2 : natural range 0 to 4095;
  signal slice1window_entering_2_0, slice1window_entering_2_1, slice1window_entering_2_2 : natural range 0 to 4095;
  signal slice1window_entering_3_0, slice1window_entering_3_1, slice1window_entering_3_2 : natural range 0 to 4095;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -4095 to 4095;
  signal slice1window_change_1_0, slice1window_change_1_1, slice1window_change_1_2 : integer range -4095 to 4095;
  signal slice1window_change_2_0, slice1window_change_2_1, slice1window_change_2_2 : integer range -4095 to 4095;
  signal slice1window_change_3_0, slice1window_change_3_1, slice1window_change_3_2 : integer range -4095 to 4095;
  signal slice1window_change_tag_leaves_window, slice1window_centre_output_column_1 : boolean;
  signal slice1window_centre_first_column_0, slice1window_centre_start_of_frame_2 : boolean;
  signal slice1window_centre_end_of_line_1 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 32767;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 32767;
  signal slice1window_sum_2_0, slice1window_sum_2_1, slice1window_sum_2_2 : natural range 0 to 32767;
  signal slice1window_sum_3_0, slice1window_sum_3_1, slice1window_sum_3_2 : natural range 0 to 32767;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 32767;
  signal slice1winner1_best_cost_1_0, slice1winner1_best_cost_1_1 : natural range 0 to 32767;
  signal slice1winner1_best_cost_2_0, slice1winner1_best_cost_2_1 : natural range 0 to 32767;
  signal slice1winner1_best_cost_3_0, slice1winner1_best_cost_3_1 : natural range 0 to 32767;
  signal slice1winner1_best_index_0_0, slice1winner1_best_index_1_0, slice1winner1_best_index_2_0 : boolean;
  signal slice1winner1_best_index_3_0 : boolean;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_1_0 : natural range 0 to 32767;
  signal slice1winner2_best_cost_2_0, slice1winner2_best_cost_3_0 : natural range 0 to 32767;
  signal slice1winner2_best_index_0_0, slice1winner2_best_index_1_0 : natural range 0 to 2;
  signal slice1winner2_best_index_2_0, slice1winner2_best_index_3_0 : natural range 0 to 2;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_cost_1_0, slice1_best_cost_2_0 : natural range 0 to 32767;
  signal slice1_best_cost_3_0 : natural range 0 to 32767;
  signal slice1_best_index_0_0, slice1_best_index_1_0, slice1_best_index_2_0 : natural range 0 to 9;
  signal slice1_best_index_3_0 : natural range 0 to 9;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_0_2 : natural range 0 to 255;
  signal slice2shift_search_1_0, slice2shift_search_1_1, slice2shift_search_1_2 : natural range 0 to 255;
  signal slice2shift_search_2_0, slice2shift_search_2_1, slice2shift_search_2_2 : natural range 0 to 255;
  signal slice2shift_search_3_0, slice2shift_search_3_1, slice2shift_search_3_2 : natural range 0 to 255;
  signal slice2shift_search_4_0, slice2shift_search_4_1, slice2shift_search_4_2 : natural range 0 to 255;
  signal slice2shift_search_5_0, slice2shift_search_5_1, slice2shift_search_5_2 : natural range 0 to 255;
  signal slice2shift_search_6_0, slice2shift_search_6_1, slice2shift_search_6_2 : natural range 0 to 255;
  signal slice2shift_search_7_0, slice2shift_search_7_1, slice2shift_search_7_2 : natural range 0 to 255;
  signal slice2shift_reference_0, slice2shift_reference_1, slice2shift_reference_2 : natural range 0 to 255;
  signal slice2shift_reference_3, slice2shift_reference_4, slice2shift_reference_5 : natural range 0 to 255;
  signal slice2shift_reference_6, slice2shift_reference_7 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_pixels_first_0_0, slice2cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_2, slice2cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_1, slice2cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice2cost_pixels_first_2_0, slice2cost_pixels_first_2_1 : integer range -255 to 255;
  signal slice2cost_pixels_first_2_2, slice2cost_pixels_first_3_0 : integer range -255 to 255;
  signal slice2cost_pixels_first_3_1, slice2cost_pixels_first_3_2 : integer range -255 to 255;
  signal slice2cost_pixels_first_4_0, slice2cost_pixels_first_4_1 : integer range -255 to 255;
  signal slice2cost_pixels_first_4_2, slice2cost_pixels_first_5_0 : integer range -255 to 255;
  signal slice2cost_pixels_first_5_1, slice2cost_pixels_first_5_2 : integer range -255 to 255;
  signal slice2cost_pixels_first_6_0, slice2cost_pixels_first_6_1 : integer range -255 to 255;
  signal slice2cost_pixels_first_6_2, slice2cost_pixels_first_7_0 : integer range -255 to 255;
  signal slice2cost_pixels_first_7_1, slice2cost_pixels_first_7_2, slice2cost_change_0_0 : integer range -255 to 255;
  signal slice2cost_change_0_1, slice2cost_change_0_2 : integer range -255 to 255;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_0, slice2cost_pixels_cost_1_1, slice2cost_pixels_cost_1_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_2_0, slice2cost_pixels_cost_2_1, slice2cost_pixels_cost_2_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_3_0, slice2cost_pixels_cost_3_1, slice2cost_pixels_cost_3_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_4_0, slice2cost_pixels_cost_4_1, slice2cost_pixels_cost_4_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_5_0, slice2cost_pixels_cost_5_1, slice2cost_pixels_cost_5_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_6_0, slice2cost_pixels_cost_6_1, slice2cost_pixels_cost_6_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_7_0, slice2cost_pixels_cost_7_1, slice2cost_pixels_cost_7_2 : natural range 0 to 255;
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 31;
  signal slice2cost_write_column : natural range 0 to 31;
  signal slice2cost_read_words_0 : unsigned(23 downto 0);
  signal slice2cost_read_words_1 : unsigned(11 downto 0);
  signal slice2cost_change_1_0, slice2cost_change_1_1, slice2cost_change_1_2 : integer range -2048 to 2047;
  signal slice2cost_change_2_0, slice2cost_change_2_1, slice2cost_change_2_2 : integer range -2048 to 2047;
  signal slice2cost_change_3_0, slice2cost_change_3_1, slice2cost_change_3_2 : integer range -2048 to 2047;
  signal slice2cost_ready_words_0, slice2cost_write_words_0 : natural range 0 to 16777215;
  signal slice2cost_ready_words_1, slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 4095;
  signal slice2cost_column_0_2, slice2cost_column_1_0, slice2cost_column_1_1 : natural range 0 to 4095;
  signal slice2cost_column_1_2, slice2cost_column_2_0, slice2cost_column_2_1 : natural range 0 to 4095;
  signal slice2cost_column_2_2, slice2cost_column_3_0, slice2cost_column_3_1 : natural range 0 to 4095;
  signal slice2cost_column_3_2, slice2cost_write_words_1 : natural range 0 to 4095;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving_0, slice2window_leaving_1, slice2window_leaving_2 : unsigned(23 downto 0);
  signal slice2window_leaving_3, slice2window_leaving_4, slice2window_leaving_5 : unsigned(23 downto 0);
  signal slice2window_entering_0_0, slice2window_entering_0_1, slice2window_entering_0_2 : natural range 0 to 4095;
  signal slice2window_entering_1_0, slice2window_entering_1_1, slice2window_entering_1_2 : natural range 0 to 4095;
  signal slice2window_entering_2_0, slice2window_entering_2_1, slice2window_entering_2_2 : natural range 0 to 4095;
  signal slice2window_entering_3_0, slice2window_entering_3_1, slice2window_entering_3_2 : natural range 0 to 4095;
  signal slice2window_change_0_0, slice2window_change_0_1, slice2window_change_0_2 : integer range -4095 to 4095;
  signal slice2window_change_1_0, slice2window_change_1_1, slice2window_change_1_2 : integer range -4095 to 4095;
  signal slice2window_change_2_0, slice2window_change_2_1, slice2window_change_2_2 : integer range -4095 to 4095;
  signal slice2window_change_3_0, slice2window_change_3_1, slice2window_change_3_2 : integer range -4095 to 4095;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_0_2 : natural range 0 to 32767;
  signal slice2window_sum_1_0, slice2window_sum_1_1, slice2window_sum_1_2 : natural range 0 to 32767;
  signal slice2window_sum_2_0, slice2window_sum_2_1, slice2window_sum_2_2 : natural range 0 to 32767;
  signal slice2window_sum_3_0, slice2window_sum_3_1, slice2window_sum_3_2 : natural range 0 to 32767;
  signal slice2window_centre_output_column_1, slice2window_centre_output_column_2 : boolean;
  signal slice2window_centre_start_of_frame_2, slice2window_centre_end_of_line_1 : boolean;
  signal slice2window_centre_end_of_line_2 : boolean;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0, slice2winner1_best_cost_0_1 : natural range 0 to 32767;
  signal slice2winner1_best_cost_1_0, slice2winner1_best_cost_1_1 : natural range 0 to 32767;
  signal slice2winner1_best_cost_2_0, slice2winner1_best_cost_2_1 : natural range 0 to 32767;
  signal slice2winner1_best_cost_3_0, slice2winner1_best_cost_3_1 : natural range 0 to 32767;
  signal slice2winner1_best_index_0_0, slice2winner1_best_index_1_0, slice2winner1_best_index_2_0 : boolean;
  signal slice2winner1_best_index_3_0 : boolean;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_1_0 : natural range 0 to 32767;
  signal slice2winner2_best_cost_2_0, slice2winner2_best_cost_3_0 : natural range 0 to 32767;
  signal slice2winner2_best_index_0_0, slice2winner2_best_index_1_0 : natural range 0 to 2;
  signal slice2winner2_best_index_2_0, slice2winner2_best_index_3_0 : natural range 0 to 2;
  -- slice2
  signal slice2_best_index_0_0, slice2_best_index_1_0, slice2_best_index_2_0 : natural range 0 to 9;
  signal slice2_best_index_3_0 : natural range 0 to 9;
  signal slice2_best_tag_valid, slice2_best_tag_output_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- other
  signal other_0, other_1 : natural range 0 to 65535;
  signal slice2window_leaving_5_memory_read_enable : boolean;
  signal slice2window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_5_memory_write_data : unsigned(23 downto 0);
  signal slice2window_leaving_4_memory_read_enable : boolean;
  signal slice2window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_4_memory_write_data : unsigned(23 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(23 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(23 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(23 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(23 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(11 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_5_memory_read_enable : boolean;
  signal slice1window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_5_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_4_memory_read_enable : boolean;
  signal slice1window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_4_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(23 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(23 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(11 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_5_memory_read_enable : boolean;
  signal slice0window_leaving_5_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_5_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_5_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_4_memory_read_enable : boolean;
  signal slice0window_leaving_4_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_4_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_4_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(23 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(11 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(15 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(15 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(31 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_left_pixel <= unsigned(left_pixel);
  in_right_pixel <= unsigned(right_pixel);
  disparity <= std_logic_vector(to_unsigned(slice2_best_index_3_0, 8) & to_unsigned(slice2_best_index_2_0, 8) & to_unsigned(slice2_best_index_1_0, 8) & to_unsigned(slice2_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(15, 4));
  disparity_valid <= as_bit(slice2_best_tag_valid and slice2_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice2_best_tag_start_of_frame and slice2_best_tag_valid and slice2_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice2_best_tag_end_of_line and slice2_best_tag_valid and slice2_best_tag_output_column);

  slice2window_leaving_5_memory_read_enable <= true;
  slice2window_leaving_5_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_5_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_5_memory_write_data <= to_unsigned(slice2cost_column_3_2, 12) & to_unsigned(slice2cost_column_3_1, 12);
  slice2window_leaving_5_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_5_memory_read_enable,
      read_address => slice2window_leaving_5_memory_read_address, read_data => slice2window_leaving_5,
      write_address => slice2window_leaving_5_memory_write_address, write_data => slice2window_leaving_5_memory_write_data);

  slice2window_leaving_4_memory_read_enable <= true;
  slice2window_leaving_4_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_4_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_4_memory_write_data <= to_unsigned(slice2cost_column_3_0, 12) & to_unsigned(slice2cost_column_2_2, 12);
  slice2window_leaving_4_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_4_memory_read_enable,
      read_address => slice2window_leaving_4_memory_read_address, read_data => slice2window_leaving_4,
      write_address => slice2window_leaving_4_memory_write_address, write_data => slice2window_leaving_4_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_2_1, 12) & to_unsigned(slice2cost_column_2_0, 12);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving_3,
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_1_2, 12) & to_unsigned(slice2cost_column_1_1, 12);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving_2,
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_1_0, 12) & to_unsigned(slice2cost_column_0_2, 12);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving_1,
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0_1, 12) & to_unsigned(slice2cost_column_0_0, 12);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving_0,
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_ready_column, 5);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_write_column, 5);
  slice2cost_read_words_1_memory_write_data <= to_unsigned(slice2cost_write_words_1, 12);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 12, address_bits => 5)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words_1,
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_ready_column, 5);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_write_column, 5);
  slice2cost_read_words_0_memory_write_data <= to_unsigned(slice2cost_write_words_0, 24);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words_0,
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_5_memory_read_enable <= true;
  slice1window_leaving_5_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_5_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_5_memory_write_data <= to_unsigned(slice1cost_column_3_2, 12) & to_unsigned(slice1cost_column_3_1, 12);
  slice1window_leaving_5_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_5_memory_read_enable,
      read_address => slice1window_leaving_5_memory_read_address, read_data => slice1window_leaving_5,
      write_address => slice1window_leaving_5_memory_write_address, write_data => slice1window_leaving_5_memory_write_data);

  slice1window_leaving_4_memory_read_enable <= true;
  slice1window_leaving_4_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_4_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_4_memory_write_data <= to_unsigned(slice1cost_column_3_0, 12) & to_unsigned(slice1cost_column_2_2, 12);
  slice1window_leaving_4_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_4_memory_read_enable,
      read_address => slice1window_leaving_4_memory_read_address, read_data => slice1window_leaving_4,
      write_address => slice1window_leaving_4_memory_write_address, write_data => slice1window_leaving_4_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_2_1, 12) & to_unsigned(slice1cost_column_2_0, 12);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving_3,
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_1_2, 12) & to_unsigned(slice1cost_column_1_1, 12);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_1_0, 12) & to_unsigned(slice1cost_column_0_2, 12);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_1, 12) & to_unsigned(slice1cost_column_0_0, 12);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 5);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_ready_column, 5);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words_1, 12);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 12, address_bits => 5)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 5);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_ready_column, 5);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words_0, 24);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_5_memory_read_enable <= true;
  slice0window_leaving_5_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_5_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_5_memory_write_data <= to_unsigned(slice0cost_column_3_2, 12) & to_unsigned(slice0cost_column_3_1, 12);
  slice0window_leaving_5_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_5_memory_read_enable,
      read_address => slice0window_leaving_5_memory_read_address, read_data => slice0window_leaving_5,
      write_address => slice0window_leaving_5_memory_write_address, write_data => slice0window_leaving_5_memory_write_data);

  slice0window_leaving_4_memory_read_enable <= true;
  slice0window_leaving_4_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_4_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_4_memory_write_data <= to_unsigned(slice0cost_column_3_0, 12) & to_unsigned(slice0cost_column_2_2, 12);
  slice0window_leaving_4_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_4_memory_read_enable,
      read_address => slice0window_leaving_4_memory_read_address, read_data => slice0window_leaving_4,
      write_address => slice0window_leaving_4_memory_write_address, write_data => slice0window_leaving_4_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_2_1, 12) & to_unsigned(slice0cost_column_2_0, 12);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving_3,
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_1_2, 12) & to_unsigned(slice0cost_column_1_1, 12);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_1_0, 12) & to_unsigned(slice0cost_column_0_2, 12);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_1, 12) & to_unsigned(slice0cost_column_0_0, 12);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 11, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 5);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_change_column, 5);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 12);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 12, address_bits => 5)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 5);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_change_column, 5);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 24);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 16);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_1_memory_write_data <= rows_search_rows_write_words_1;
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= rows_search_rows_write_words_0;
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 16);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_1_memory_write_data <= rows_reference_rows_write_words_1;
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= rows_reference_rows_write_words_0;
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= raster_features_reference;
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 9, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_column_choice, delay_row_inside_0_value, delay_tag_first_cost_is_equal : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_1_0_is_less : boolean;
    variable slice0winner1_best_cost_2_0_is_less, slice0winner1_best_cost_3_0_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_cost_1_0_is_less : boolean;
    variable slice0winner2_best_cost_2_0_is_less, slice0winner2_best_cost_3_0_is_less : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner1_best_cost_1_0_is_less : boolean;
    variable slice1winner1_best_cost_2_0_is_less, slice1winner1_best_cost_3_0_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner2_best_cost_1_0_is_less : boolean;
    variable slice1winner2_best_cost_2_0_is_less, slice1winner2_best_cost_3_0_is_less : boolean;
    variable slice1_best_cost_0_0_is_less, slice1_best_cost_1_0_is_less, slice1_best_cost_2_0_is_less : boolean;
    variable slice1_best_cost_3_0_is_less, slice2winner1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_1_0_is_less, slice2winner1_best_cost_2_0_is_less : boolean;
    variable slice2winner1_best_cost_3_0_is_less, slice2winner2_best_cost_0_0_is_less : boolean;
    variable slice2winner2_best_cost_1_0_is_less, slice2winner2_best_cost_2_0_is_less : boolean;
    variable slice2winner2_best_cost_3_0_is_less : boolean;
    variable slice0cost_change_0_0_difference, slice0cost_change_0_1_difference : integer range -255 to 255;
    variable slice0cost_change_0_2_difference, slice1cost_change_0_0_difference : integer range -255 to 255;
    variable slice1cost_change_0_1_difference, slice1cost_change_0_2_difference : integer range -255 to 255;
    variable slice2cost_change_0_0_difference, slice2cost_change_0_1_difference : integer range -255 to 255;
    variable slice2cost_change_0_2_difference : integer range -255 to 255;
    variable slice0cost_change_1_0_difference, slice0cost_change_1_1_difference : integer range -255 to 4350;
    variable slice0cost_change_1_2_difference, slice0cost_change_2_0_difference : integer range -255 to 4350;
    variable slice0cost_change_2_1_difference, slice0cost_change_2_2_difference : integer range -255 to 4350;
    variable slice1cost_change_1_0_difference, slice1cost_change_1_1_difference : integer range -255 to 4350;
    variable slice1cost_change_1_2_difference, slice1cost_change_2_0_difference : integer range -255 to 4350;
    variable slice1cost_change_2_1_difference, slice1cost_change_2_2_difference : integer range -255 to 4350;
    variable slice2cost_change_1_0_difference, slice2cost_change_1_1_difference : integer range -255 to 4350;
    variable slice2cost_change_1_2_difference, slice2cost_change_2_0_difference : integer range -255 to 4350;
    variable slice2cost_change_2_1_difference, slice2cost_change_2_2_difference : integer range -255 to 4350;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_1_choice : natural range 0 to 4095;
    variable slice0cost_column_0_2_choice, slice0cost_column_3_0_choice : natural range 0 to 4095;
    variable slice0cost_column_3_1_choice, slice0cost_column_3_2_choice : natural range 0 to 4095;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 4095;
    variable slice0window_change_0_2_choice, slice0window_change_1_0_choice : natural range 0 to 4095;
    variable slice0window_change_1_1_choice, slice0window_change_1_2_choice : natural range 0 to 4095;
    variable slice0window_change_2_0_choice, slice0window_change_2_1_choice : natural range 0 to 4095;
    variable slice0window_change_2_2_choice, slice0window_change_3_0_choice : natural range 0 to 4095;
    variable slice0window_change_3_1_choice, slice0window_change_3_2_choice : natural range 0 to 4095;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_1_choice : natural range 0 to 4095;
    variable slice1cost_column_0_2_choice, slice1cost_column_3_0_choice : natural range 0 to 4095;
    variable slice1cost_column_3_1_choice, slice1cost_column_3_2_choice : natural range 0 to 4095;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 4095;
    variable slice1window_change_0_2_choice, slice1window_change_1_0_choice : natural range 0 to 4095;
    variable slice1window_change_1_1_choice, slice1window_change_1_2_choice : natural range 0 to 4095;
    variable slice1window_change_2_0_choice, slice1window_change_2_1_choice : natural range 0 to 4095;
    variable slice1window_change_2_2_choice, slice1window_change_3_0_choice : natural range 0 to 4095;
    variable slice1window_change_3_1_choice, slice1window_change_3_2_choice : natural range 0 to 4095;
    variable slice2cost_column_0_0_choice, slice2cost_column_0_1_choice : natural range 0 to 4095;
    variable slice2cost_column_0_2_choice, slice2cost_column_3_0_choice : natural range 0 to 4095;
    variable slice2cost_column_3_1_choice, slice2cost_column_3_2_choice : natural range 0 to 4095;
    variable slice2window_change_0_0_choice, slice2window_change_0_1_choice : natural range 0 to 4095;
    variable slice2window_change_0_2_choice, slice2window_change_1_0_choice : natural range 0 to 4095;
    variable slice2window_change_1_1_choice, slice2window_change_1_2_choice : natural range 0 to 4095;
    variable slice2window_change_2_0_choice, slice2window_change_2_1_choice : natural range 0 to 4095;
    variable slice2window_change_2_2_choice, slice2window_change_3_0_choice : natural range 0 to 4095;
    variable slice2window_change_3_1_choice, slice2window_change_3_2_choice : natural range 0 to 4095;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 32767;
    variable slice0window_sum_0_2_choice, slice0window_sum_1_0_choice : natural range 0 to 32767;
    variable slice0window_sum_1_1_choice, slice0window_sum_1_2_choice : natural range 0 to 32767;
    variable slice0window_sum_2_0_choice, slice0window_sum_2_1_choice : natural range 0 to 32767;
    variable slice0window_sum_2_2_choice, slice0window_sum_3_0_choice : natural range 0 to 32767;
    variable slice0window_sum_3_1_choice, slice0window_sum_3_2_choice : natural range 0 to 32767;
    variable slice1window_sum_0_0_choice, slice1window_sum_0_1_choice : natural range 0 to 32767;
    variable slice1window_sum_0_2_choice, slice1window_sum_1_0_choice : natural range 0 to 32767;
    variable slice1window_sum_1_1_choice, slice1window_sum_1_2_choice : natural range 0 to 32767;
    variable slice1window_sum_2_0_choice, slice1window_sum_2_1_choice : natural range 0 to 32767;
    variable slice1window_sum_2_2_choice, slice1window_sum_3_0_choice : natural range 0 to 32767;
    variable slice1window_sum_3_1_choice, slice1window_sum_3_2_choice : natural range 0 to 32767;
    variable slice2window_sum_0_0_choice, slice2window_sum_0_1_choice : natural range 0 to 32767;
    variable slice2window_sum_0_2_choice, slice2window_sum_1_0_choice : natural range 0 to 32767;
    variable slice2window_sum_1_1_choice, slice2window_sum_1_2_choice : natural range 0 to 32767;
    variable slice2window_sum_2_0_choice, slice2window_sum_2_1_choice : natural range 0 to 32767;
    variable slice2window_sum_2_2_choice, slice2window_sum_3_0_choice : natural range 0 to 32767;
    variable slice2window_sum_3_1_choice, slice2window_sum_3_2_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- raster
      raster_features_search_0 <= to_integer(in_left_pixel(7 downto 0));
      raster_features_search_1 <= to_integer(in_left_pixel(15 downto 8));
      raster_features_search_2 <= to_integer(in_left_pixel(23 downto 16));
      raster_features_search_3 <= to_integer(in_left_pixel(31 downto 24));
      raster_features_reference <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 4) and in_valid and
          (raster_place_column = 31)))) mod 8;
      end if;
      if (raster_place_column / 2) = 15 then
        raster_place_column_choice := in_start_of_frame or ((raster_place_column mod 2) = 1);
      else
        raster_place_column_choice := in_start_of_frame;
      end if;
      if in_valid then
        if raster_place_column_choice then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 8 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 16;
        end if;
      end if;
      delay_row_inside_0_value := ((raster_place_group / 2) mod 2) = 1;
      delay_tag_first_cost_is_equal := raster_place_column = 8;
      delay_ahead_0 <= raster_features_search_0;
      delay_ahead_1 <= raster_features_search_1;
      delay_ahead_2 <= raster_features_search_2;
      delay_ahead_3 <= raster_features_search_3;
      delay_column <= raster_place_column;
      delay_row_inside_4 <= (not ((raster_place_group / 4) = 1)) and ((not delay_row_inside_0_value) or (not
        ((raster_place_group mod 2) = 1)));
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= (raster_place_column / 8) = 0;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_leaves_window <= (((((raster_place_column / 2) + 32759) mod 32768) * 2) + (raster_place_column mod 2))
        < 65522;
      delay_tag_output_column <= ((((((raster_place_column / 8) + 8191) mod 8192) * 8) + (raster_place_column mod 8)) <
        23) and (not ((raster_place_group / 4) = 1)) and (delay_row_inside_0_value or ((raster_place_group mod 2) = 1));
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      if (raster_place_group / 4) = 1 then
        delay_row_inside_0 <= not delay_row_inside_0_value;
        delay_row_inside_2 <= (raster_place_group mod 4) = 0;
      else
        delay_row_inside_0 <= (raster_place_group mod 4) = 3;
        delay_row_inside_2 <= delay_row_inside_0_value;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_read_newest_1 <= delay_ahead_1;
      rows_search_rows_read_newest_2 <= delay_ahead_2;
      rows_search_rows_read_newest_3 <= delay_ahead_3;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= rows_search_rows_read_words_1;
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_search_rows_ready_newest_3 <= rows_search_rows_read_newest_3;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0(7 downto 0));
      rows_reference_rows_read_newest_1 <= to_integer(delay_delayed_0(15 downto 8));
      rows_reference_rows_read_newest_2 <= to_integer(delay_delayed_0(23 downto 16));
      rows_reference_rows_read_newest_3 <= to_integer(delay_delayed_0(31 downto 24));
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= rows_reference_rows_read_words_1;
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_reference_rows_ready_newest_3 <= rows_reference_rows_read_newest_3;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_inside_4 <= delay_row_inside_4;
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
      rows_ready_inside_2 <= rows_read_inside_2;
      rows_ready_inside_4 <= rows_read_inside_4;
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
      if rows_ready_inside_0 then
        rows_search_0 <= to_integer(rows_search_rows_ready_words_0(7 downto 0));
        rows_search_1 <= to_integer(rows_search_rows_ready_words_0(15 downto 8));
        rows_reference_0 <= to_integer(rows_reference_rows_ready_words_0(7 downto 0));
        rows_reference_1 <= to_integer(rows_reference_rows_ready_words_0(15 downto 8));
      else
        rows_search_0 <= 0;
        rows_search_1 <= 0;
        rows_reference_0 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_inside_2 then
        rows_search_2 <= to_integer(rows_search_rows_ready_words_0(23 downto 16));
        rows_search_3 <= to_integer(rows_search_rows_ready_words_0(31 downto 24));
        rows_reference_2 <= to_integer(rows_reference_rows_ready_words_0(23 downto 16));
        rows_reference_3 <= to_integer(rows_reference_rows_ready_words_0(31 downto 24));
      else
        rows_search_2 <= 0;
        rows_search_3 <= 0;
        rows_reference_2 <= 0;
        rows_reference_3 <= 0;
      end if;
      if rows_ready_inside_4 then
        rows_search_4 <= rows_search_rows_ready_newest_0;
        rows_search_5 <= rows_search_rows_ready_newest_1;
        rows_search_6 <= other_1 mod 256;
        rows_search_7 <= rows_search_rows_ready_newest_3;
        rows_reference_4 <= rows_reference_rows_ready_newest_0;
        rows_reference_5 <= rows_reference_rows_ready_newest_1;
        rows_reference_6 <= other_0 mod 256;
        rows_reference_7 <= rows_reference_rows_ready_newest_3;
      else
        rows_search_4 <= 0;
        rows_search_5 <= 0;
        rows_search_6 <= 0;
        rows_search_7 <= 0;
        rows_reference_4 <= 0;
        rows_reference_5 <= 0;
        rows_reference_6 <= 0;
        rows_reference_7 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= rows_search_rows_ready_words_1;
        rows_search_rows_write_words_1 <= to_unsigned(rows_search_rows_ready_newest_1, 8) &
          to_unsigned(rows_search_rows_ready_newest_0, 8) & to_unsigned(rows_search_rows_ready_words_2, 16);
        rows_search_rows_write_words_2 <= other_1;
        rows_reference_rows_write_words_0 <= rows_reference_rows_ready_words_1;
        rows_reference_rows_write_words_1 <= to_unsigned(rows_reference_rows_ready_newest_1, 8) &
          to_unsigned(rows_reference_rows_ready_newest_0, 8) & to_unsigned(rows_reference_rows_ready_words_2, 16);
        rows_reference_rows_write_words_2 <= other_0;
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= rows_search_1;
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= rows_search_2;
        slice0shift_search_3_0 <= slice0shift_search_3_1;
        slice0shift_search_3_1 <= slice0shift_search_3_2;
        slice0shift_search_3_2 <= rows_search_3;
        slice0shift_search_4_0 <= slice0shift_search_4_1;
        slice0shift_search_4_1 <= slice0shift_search_4_2;
        slice0shift_search_4_2 <= rows_search_4;
        slice0shift_search_5_0 <= slice0shift_search_5_1;
        slice0shift_search_5_1 <= slice0shift_search_5_2;
        slice0shift_search_5_2 <= rows_search_5;
        slice0shift_search_6_0 <= slice0shift_search_6_1;
        slice0shift_search_6_1 <= slice0shift_search_6_2;
        slice0shift_search_6_2 <= rows_search_6;
        slice0shift_search_7_0 <= slice0shift_search_7_1;
        slice0shift_search_7_1 <= slice0shift_search_7_2;
        slice0shift_search_7_2 <= rows_search_7;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_reference_4 <= rows_reference_4;
      slice0shift_reference_5 <= rows_reference_5;
      slice0shift_reference_6 <= rows_reference_6;
      slice0shift_reference_7 <= rows_reference_7;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
      slice0shift_search_out_4 <= slice0shift_search_4_0;
      slice0shift_search_out_5 <= slice0shift_search_5_0;
      slice0shift_search_out_6 <= slice0shift_search_6_0;
      slice0shift_search_out_7 <= slice0shift_search_7_0;
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
      slice0cost_change_0_0_difference := slice0cost_pixels_cost_4_0 - slice0cost_pixels_cost_0_0;
      slice0cost_change_0_1_difference := slice0cost_pixels_cost_4_1 - slice0cost_pixels_cost_0_1;
      slice0cost_change_0_2_difference := slice0cost_pixels_cost_4_2 - slice0cost_pixels_cost_0_2;
      slice0cost_change_1_0_difference := ((slice0cost_change_0_0_difference mod 4096) + slice0cost_pixels_cost_5_0) -
        slice0cost_pixels_cost_1_0;
      slice0cost_change_1_1_difference := ((slice0cost_change_0_1_difference mod 4096) + slice0cost_pixels_cost_5_1) -
        slice0cost_pixels_cost_1_1;
      slice0cost_change_1_2_difference := ((slice0cost_change_0_2_difference mod 4096) + slice0cost_pixels_cost_5_2) -
        slice0cost_pixels_cost_1_2;
      slice0cost_change_2_0_difference := ((slice0cost_change_1_0_difference mod 4096) + slice0cost_pixels_cost_6_0) -
        slice0cost_pixels_cost_2_0;
      slice0cost_change_2_1_difference := ((slice0cost_change_1_1_difference mod 4096) + slice0cost_pixels_cost_6_1) -
        slice0cost_pixels_cost_2_1;
      slice0cost_change_2_2_difference := ((slice0cost_change_1_2_difference mod 4096) + slice0cost_pixels_cost_6_2) -
        slice0cost_pixels_cost_2_2;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := slice0cost_ready_words_0 / 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := slice0cost_ready_words_1;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_3_0_choice := 0;
      else
        slice0cost_column_3_0_choice := (slice0cost_column_0_0_choice + slice0cost_change_3_0) mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_3_1_choice := 0;
      else
        slice0cost_column_3_1_choice := (slice0cost_column_0_1_choice + slice0cost_change_3_1) mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_3_2_choice := 0;
      else
        slice0cost_column_3_2_choice := (slice0cost_column_0_2_choice + slice0cost_change_3_2) mod 4096;
      end if;
      slice0cost_pixels_first_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_pixels_first_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_pixels_first_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_pixels_first_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_pixels_first_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_pixels_first_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_pixels_first_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_pixels_first_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_pixels_first_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_pixels_first_3_0 <= slice0shift_search_3_0 - slice0shift_reference_3;
      slice0cost_pixels_first_3_1 <= slice0shift_search_3_1 - slice0shift_reference_3;
      slice0cost_pixels_first_3_2 <= slice0shift_search_3_2 - slice0shift_reference_3;
      slice0cost_pixels_first_4_0 <= slice0shift_search_4_0 - slice0shift_reference_4;
      slice0cost_pixels_first_4_1 <= slice0shift_search_4_1 - slice0shift_reference_4;
      slice0cost_pixels_first_4_2 <= slice0shift_search_4_2 - slice0shift_reference_4;
      slice0cost_pixels_first_5_0 <= slice0shift_search_5_0 - slice0shift_reference_5;
      slice0cost_pixels_first_5_1 <= slice0shift_search_5_1 - slice0shift_reference_5;
      slice0cost_pixels_first_5_2 <= slice0shift_search_5_2 - slice0shift_reference_5;
      slice0cost_pixels_first_6_0 <= slice0shift_search_6_0 - slice0shift_reference_6;
      slice0cost_pixels_first_6_1 <= slice0shift_search_6_1 - slice0shift_reference_6;
      slice0cost_pixels_first_6_2 <= slice0shift_search_6_2 - slice0shift_reference_6;
      slice0cost_pixels_first_7_0 <= slice0shift_search_7_0 - slice0shift_reference_7;
      slice0cost_pixels_first_7_1 <= slice0shift_search_7_1 - slice0shift_reference_7;
      slice0cost_pixels_first_7_2 <= slice0shift_search_7_2 - slice0shift_reference_7;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= (folded(slice0cost_pixels_first_0_0) + as_number((slice0cost_pixels_first_0_0 <
        0))) mod 256;
      slice0cost_pixels_cost_0_1 <= (folded(slice0cost_pixels_first_0_1) + as_number((slice0cost_pixels_first_0_1 <
        0))) mod 256;
      slice0cost_pixels_cost_0_2 <= (folded(slice0cost_pixels_first_0_2) + as_number((slice0cost_pixels_first_0_2 <
        0))) mod 256;
      slice0cost_pixels_cost_1_0 <= (folded(slice0cost_pixels_first_1_0) + as_number((slice0cost_pixels_first_1_0 <
        0))) mod 256;
      slice0cost_pixels_cost_1_1 <= (folded(slice0cost_pixels_first_1_1) + as_number((slice0cost_pixels_first_1_1 <
        0))) mod 256;
      slice0cost_pixels_cost_1_2 <= (folded(slice0cost_pixels_first_1_2) + as_number((slice0cost_pixels_first_1_2 <
        0))) mod 256;
      slice0cost_pixels_cost_2_0 <= (folded(slice0cost_pixels_first_2_0) + as_number((slice0cost_pixels_first_2_0 <
        0))) mod 256;
      slice0cost_pixels_cost_2_1 <= (folded(slice0cost_pixels_first_2_1) + as_number((slice0cost_pixels_first_2_1 <
        0))) mod 256;
      slice0cost_pixels_cost_2_2 <= (folded(slice0cost_pixels_first_2_2) + as_number((slice0cost_pixels_first_2_2 <
        0))) mod 256;
      slice0cost_pixels_cost_3_0 <= (folded(slice0cost_pixels_first_3_0) + as_number((slice0cost_pixels_first_3_0 <
        0))) mod 256;
      slice0cost_pixels_cost_3_1 <= (folded(slice0cost_pixels_first_3_1) + as_number((slice0cost_pixels_first_3_1 <
        0))) mod 256;
      slice0cost_pixels_cost_3_2 <= (folded(slice0cost_pixels_first_3_2) + as_number((slice0cost_pixels_first_3_2 <
        0))) mod 256;
      slice0cost_pixels_cost_4_0 <= (folded(slice0cost_pixels_first_4_0) + as_number((slice0cost_pixels_first_4_0 <
        0))) mod 256;
      slice0cost_pixels_cost_4_1 <= (folded(slice0cost_pixels_first_4_1) + as_number((slice0cost_pixels_first_4_1 <
        0))) mod 256;
      slice0cost_pixels_cost_4_2 <= (folded(slice0cost_pixels_first_4_2) + as_number((slice0cost_pixels_first_4_2 <
        0))) mod 256;
      slice0cost_pixels_cost_5_0 <= (folded(slice0cost_pixels_first_5_0) + as_number((slice0cost_pixels_first_5_0 <
        0))) mod 256;
      slice0cost_pixels_cost_5_1 <= (folded(slice0cost_pixels_first_5_1) + as_number((slice0cost_pixels_first_5_1 <
        0))) mod 256;
      slice0cost_pixels_cost_5_2 <= (folded(slice0cost_pixels_first_5_2) + as_number((slice0cost_pixels_first_5_2 <
        0))) mod 256;
      slice0cost_pixels_cost_6_0 <= (folded(slice0cost_pixels_first_6_0) + as_number((slice0cost_pixels_first_6_0 <
        0))) mod 256;
      slice0cost_pixels_cost_6_1 <= (folded(slice0cost_pixels_first_6_1) + as_number((slice0cost_pixels_first_6_1 <
        0))) mod 256;
      slice0cost_pixels_cost_6_2 <= (folded(slice0cost_pixels_first_6_2) + as_number((slice0cost_pixels_first_6_2 <
        0))) mod 256;
      slice0cost_pixels_cost_7_0 <= (folded(slice0cost_pixels_first_7_0) + as_number((slice0cost_pixels_first_7_0 <
        0))) mod 256;
      slice0cost_pixels_cost_7_1 <= (folded(slice0cost_pixels_first_7_1) + as_number((slice0cost_pixels_first_7_1 <
        0))) mod 256;
      slice0cost_pixels_cost_7_2 <= (folded(slice0cost_pixels_first_7_2) + as_number((slice0cost_pixels_first_7_2 <
        0))) mod 256;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_change_0_0 <= slice0cost_change_0_0_difference;
      slice0cost_change_0_1 <= slice0cost_change_0_1_difference;
      slice0cost_change_0_2 <= slice0cost_change_0_2_difference;
      slice0cost_change_1_0 <= ((slice0cost_change_1_0_difference + 2048) mod 4096) - 2048;
      slice0cost_change_1_1 <= ((slice0cost_change_1_1_difference + 2048) mod 4096) - 2048;
      slice0cost_change_1_2 <= ((slice0cost_change_1_2_difference + 2048) mod 4096) - 2048;
      slice0cost_change_2_0 <= ((slice0cost_change_2_0_difference + 2048) mod 4096) - 2048;
      slice0cost_change_2_1 <= ((slice0cost_change_2_1_difference + 2048) mod 4096) - 2048;
      slice0cost_change_2_2 <= ((slice0cost_change_2_2_difference + 2048) mod 4096) - 2048;
      slice0cost_change_3_0 <= ((((slice0cost_pixels_cost_7_0 - slice0cost_pixels_cost_3_0) +
        slice0cost_change_2_0_difference) + 2048) mod 4096) - 2048;
      slice0cost_change_3_1 <= ((((slice0cost_pixels_cost_7_1 - slice0cost_pixels_cost_3_1) +
        slice0cost_change_2_1_difference) + 2048) mod 4096) - 2048;
      slice0cost_change_3_2 <= ((((slice0cost_pixels_cost_7_2 - slice0cost_pixels_cost_3_2) +
        slice0cost_change_2_2_difference) + 2048) mod 4096) - 2048;
      slice0cost_ready_words_0 <= to_integer(slice0cost_read_words_0);
      slice0cost_ready_words_1 <= to_integer(slice0cost_read_words_1);
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_3_0 <= slice0cost_column_3_0_choice;
      slice0cost_column_3_1 <= slice0cost_column_3_1_choice;
      slice0cost_column_3_2 <= slice0cost_column_3_2_choice;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_border_column <= slice0cost_ready_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_ready_tag_first_cost;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_ready_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_ready_tag_end_of_line;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
        slice0cost_column_2_0 <= 0;
        slice0cost_column_2_1 <= 0;
        slice0cost_column_2_2 <= 0;
      else
        slice0cost_column_0_0 <= (slice0cost_column_0_0_choice + slice0cost_change_0_0) mod 4096;
        slice0cost_column_0_1 <= (slice0cost_column_0_1_choice + slice0cost_change_0_1) mod 4096;
        slice0cost_column_0_2 <= (slice0cost_column_0_2_choice + slice0cost_change_0_2) mod 4096;
        slice0cost_column_1_0 <= (slice0cost_column_0_0_choice + slice0cost_change_1_0) mod 4096;
        slice0cost_column_1_1 <= (slice0cost_column_0_1_choice + slice0cost_change_1_1) mod 4096;
        slice0cost_column_1_2 <= (slice0cost_column_0_2_choice + slice0cost_change_1_2) mod 4096;
        slice0cost_column_2_0 <= (slice0cost_column_0_0_choice + slice0cost_change_2_0) mod 4096;
        slice0cost_column_2_1 <= (slice0cost_column_0_1_choice + slice0cost_change_2_1) mod 4096;
        slice0cost_column_2_2 <= (slice0cost_column_0_2_choice + slice0cost_change_2_2) mod 4096;
      end if;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 32;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 32;
        end if;
      end if;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice0cost_ready_column <= 0;
        else
          slice0cost_ready_column <= (slice0cost_ready_column + 1) mod 32;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        slice0cost_write_words_0 <= (slice0cost_column_3_1_choice * 4096) + slice0cost_column_3_0_choice;
        slice0cost_write_words_1 <= slice0cost_column_3_2_choice;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 10 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(11 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(23 downto 12));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_1(11 downto 0));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_1_0_choice := to_integer(slice0window_leaving_1(23 downto 12));
      else
        slice0window_change_1_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_1_1_choice := to_integer(slice0window_leaving_2(11 downto 0));
      else
        slice0window_change_1_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_1_2_choice := to_integer(slice0window_leaving_2(23 downto 12));
      else
        slice0window_change_1_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_2_0_choice := to_integer(slice0window_leaving_3(11 downto 0));
      else
        slice0window_change_2_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_2_1_choice := to_integer(slice0window_leaving_3(23 downto 12));
      else
        slice0window_change_2_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_2_2_choice := to_integer(slice0window_leaving_4(11 downto 0));
      else
        slice0window_change_2_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_3_0_choice := to_integer(slice0window_leaving_4(23 downto 12));
      else
        slice0window_change_3_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_3_1_choice := to_integer(slice0window_leaving_5(11 downto 0));
      else
        slice0window_change_3_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_3_2_choice := to_integer(slice0window_leaving_5(23 downto 12));
      else
        slice0window_change_3_2_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_1_0 <= slice0cost_column_1_0;
      slice0window_entering_1_1 <= slice0cost_column_1_1;
      slice0window_entering_1_2 <= slice0cost_column_1_2;
      slice0window_entering_2_0 <= slice0cost_column_2_0;
      slice0window_entering_2_1 <= slice0cost_column_2_1;
      slice0window_entering_2_2 <= slice0cost_column_2_2;
      slice0window_entering_3_0 <= slice0cost_column_3_0;
      slice0window_entering_3_1 <= slice0cost_column_3_1;
      slice0window_entering_3_2 <= slice0cost_column_3_2;
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
      slice0window_change_1_0 <= slice0window_entering_1_0 - slice0window_change_1_0_choice;
      slice0window_change_1_1 <= slice0window_entering_1_1 - slice0window_change_1_1_choice;
      slice0window_change_1_2 <= slice0window_entering_1_2 - slice0window_change_1_2_choice;
      slice0window_change_2_0 <= slice0window_entering_2_0 - slice0window_change_2_0_choice;
      slice0window_change_2_1 <= slice0window_entering_2_1 - slice0window_change_2_1_choice;
      slice0window_change_2_2 <= slice0window_entering_2_2 - slice0window_change_2_2_choice;
      slice0window_change_3_0 <= slice0window_entering_3_0 - slice0window_change_3_0_choice;
      slice0window_change_3_1 <= slice0window_entering_3_1 - slice0window_change_3_1_choice;
      slice0window_change_3_2 <= slice0window_entering_3_2 - slice0window_change_3_2_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_output_column_1 <= slice0window_centre_output_column_0;
      slice0window_centre_first_column_0 <= slice0window_change_tag_first_cost;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_centre_end_of_line_1 <= slice0window_centre_end_of_line_0;
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
        slice0window_sum_1_0_choice := 0;
      else
        slice0window_sum_1_0_choice := slice0window_sum_1_0;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_1_1_choice := 0;
      else
        slice0window_sum_1_1_choice := slice0window_sum_1_1;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_1_2_choice := 0;
      else
        slice0window_sum_1_2_choice := slice0window_sum_1_2;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_2_0_choice := 0;
      else
        slice0window_sum_2_0_choice := slice0window_sum_2_0;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_2_1_choice := 0;
      else
        slice0window_sum_2_1_choice := slice0window_sum_2_1;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_2_2_choice := 0;
      else
        slice0window_sum_2_2_choice := slice0window_sum_2_2;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_3_0_choice := 0;
      else
        slice0window_sum_3_0_choice := slice0window_sum_3_0;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_3_1_choice := 0;
      else
        slice0window_sum_3_1_choice := slice0window_sum_3_1;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_3_2_choice := 0;
      else
        slice0window_sum_3_2_choice := slice0window_sum_3_2;
      end if;
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 32768;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 32768;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 32768;
        slice0window_sum_1_0 <= (slice0window_sum_1_0_choice + slice0window_change_1_0) mod 32768;
        slice0window_sum_1_1 <= (slice0window_sum_1_1_choice + slice0window_change_1_1) mod 32768;
        slice0window_sum_1_2 <= (slice0window_sum_1_2_choice + slice0window_change_1_2) mod 32768;
        slice0window_sum_2_0 <= (slice0window_sum_2_0_choice + slice0window_change_2_0) mod 32768;
        slice0window_sum_2_1 <= (slice0window_sum_2_1_choice + slice0window_change_2_1) mod 32768;
        slice0window_sum_2_2 <= (slice0window_sum_2_2_choice + slice0window_change_2_2) mod 32768;
        slice0window_sum_3_0 <= (slice0window_sum_3_0_choice + slice0window_change_3_0) mod 32768;
        slice0window_sum_3_1 <= (slice0window_sum_3_1_choice + slice0window_change_3_1) mod 32768;
        slice0window_sum_3_2 <= (slice0window_sum_3_2_choice + slice0window_change_3_2) mod 32768;
      end if;
      if slice0winner1_tag_valid then
        slice0window_centre_start_of_frame_2 <= slice0window_centre_start_of_frame_1;
      end if;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_best_cost_1_0_is_less := (slice0window_sum_1_1 - slice0window_sum_1_0) < 0;
      slice0winner1_best_cost_2_0_is_less := (slice0window_sum_2_1 - slice0window_sum_2_0) < 0;
      slice0winner1_best_cost_3_0_is_less := (slice0window_sum_3_1 - slice0window_sum_3_0) < 0;
      slice0winner1_best_cost_0_1 <= slice0window_sum_0_2;
      slice0winner1_best_cost_1_1 <= slice0window_sum_1_2;
      slice0winner1_best_cost_2_1 <= slice0window_sum_2_2;
      slice0winner1_best_cost_3_1 <= slice0window_sum_3_2;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_index_0_1 <= 2;
      slice0winner1_best_index_1_0 <= slice0winner1_best_cost_1_0_is_less;
      slice0winner1_best_index_2_0 <= slice0winner1_best_cost_2_0_is_less;
      slice0winner1_best_index_3_0 <= slice0winner1_best_cost_3_0_is_less;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
      end if;
      if slice0winner1_best_cost_1_0_is_less then
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_1;
      else
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_0;
      end if;
      if slice0winner1_best_cost_2_0_is_less then
        slice0winner1_best_cost_2_0 <= slice0window_sum_2_1;
      else
        slice0winner1_best_cost_2_0 <= slice0window_sum_2_0;
      end if;
      if slice0winner1_best_cost_3_0_is_less then
        slice0winner1_best_cost_3_0 <= slice0window_sum_3_1;
      else
        slice0winner1_best_cost_3_0 <= slice0window_sum_3_0;
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_output_column <= slice2window_centre_output_column_2;
        slice0winner1_tag_start_of_frame <= slice2window_centre_start_of_frame_2;
        slice0winner1_tag_end_of_line <= slice2window_centre_end_of_line_2;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_1_0_is_less := (slice0winner1_best_cost_1_1 - slice0winner1_best_cost_1_0) < 0;
      slice0winner2_best_cost_2_0_is_less := (slice0winner1_best_cost_2_1 - slice0winner1_best_cost_2_0) < 0;
      slice0winner2_best_cost_3_0_is_less := (slice0winner1_best_cost_3_1 - slice0winner1_best_cost_3_0) < 0;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
      end if;
      if slice0winner2_best_cost_1_0_is_less then
        slice0winner2_best_cost_1_0 <= slice0winner1_best_cost_1_1;
        slice0winner2_best_index_1_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_1_0 <= slice0winner1_best_cost_1_0;
        slice0winner2_best_index_1_0 <= as_number(slice0winner1_best_index_1_0);
      end if;
      if slice0winner2_best_cost_2_0_is_less then
        slice0winner2_best_cost_2_0 <= slice0winner1_best_cost_2_1;
        slice0winner2_best_index_2_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_2_0 <= slice0winner1_best_cost_2_0;
        slice0winner2_best_index_2_0 <= as_number(slice0winner1_best_index_2_0);
      end if;
      if slice0winner2_best_cost_3_0_is_less then
        slice0winner2_best_cost_3_0 <= slice0winner1_best_cost_3_1;
        slice0winner2_best_index_3_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_3_0 <= slice0winner1_best_cost_3_0;
        slice0winner2_best_index_3_0 <= as_number(slice0winner1_best_index_3_0);
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0_best_cost_1_0 <= slice0winner2_best_cost_1_0;
      slice0_best_cost_2_0 <= slice0winner2_best_cost_2_0;
      slice0_best_cost_3_0 <= slice0winner2_best_cost_3_0;
      slice0_best_index_0_0 <= (((slice0winner2_best_index_0_0 / 2) + 3) * 2) + (slice0winner2_best_index_0_0 mod 2);
      slice0_best_index_1_0 <= (((slice0winner2_best_index_1_0 / 2) + 3) * 2) + (slice0winner2_best_index_1_0 mod 2);
      slice0_best_index_2_0 <= (((slice0winner2_best_index_2_0 / 2) + 3) * 2) + (slice0winner2_best_index_2_0 mod 2);
      slice0_best_index_3_0 <= (((slice0winner2_best_index_3_0 / 2) + 3) * 2) + (slice0winner2_best_index_3_0 mod 2);
      slice0_best_tag_valid <= slice0winner2_tag_valid;
      slice0_best_tag_output_column <= slice0winner2_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner2_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice0shift_search_out_1;
        slice1shift_search_2_0 <= slice1shift_search_2_1;
        slice1shift_search_2_1 <= slice1shift_search_2_2;
        slice1shift_search_2_2 <= slice0shift_search_out_2;
        slice1shift_search_3_0 <= slice1shift_search_3_1;
        slice1shift_search_3_1 <= slice1shift_search_3_2;
        slice1shift_search_3_2 <= slice0shift_search_out_3;
        slice1shift_search_4_0 <= slice1shift_search_4_1;
        slice1shift_search_4_1 <= slice1shift_search_4_2;
        slice1shift_search_4_2 <= slice0shift_search_out_4;
        slice1shift_search_5_0 <= slice1shift_search_5_1;
        slice1shift_search_5_1 <= slice1shift_search_5_2;
        slice1shift_search_5_2 <= slice0shift_search_out_5;
        slice1shift_search_6_0 <= slice1shift_search_6_1;
        slice1shift_search_6_1 <= slice1shift_search_6_2;
        slice1shift_search_6_2 <= slice0shift_search_out_6;
        slice1shift_search_7_0 <= slice1shift_search_7_1;
        slice1shift_search_7_1 <= slice1shift_search_7_2;
        slice1shift_search_7_2 <= slice0shift_search_out_7;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_reference_4 <= slice0shift_reference_4;
      slice1shift_reference_5 <= slice0shift_reference_5;
      slice1shift_reference_6 <= slice0shift_reference_6;
      slice1shift_reference_7 <= slice0shift_reference_7;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      slice1shift_search_out_2 <= slice1shift_search_2_0;
      slice1shift_search_out_3 <= slice1shift_search_3_0;
      slice1shift_search_out_4 <= slice1shift_search_4_0;
      slice1shift_search_out_5 <= slice1shift_search_5_0;
      slice1shift_search_out_6 <= slice1shift_search_6_0;
      slice1shift_search_out_7 <= slice1shift_search_7_0;
      -- slice1cost
      slice1cost_change_0_0_difference := slice1cost_pixels_cost_4_0 - slice1cost_pixels_cost_0_0;
      slice1cost_change_0_1_difference := slice1cost_pixels_cost_4_1 - slice1cost_pixels_cost_0_1;
      slice1cost_change_0_2_difference := slice1cost_pixels_cost_4_2 - slice1cost_pixels_cost_0_2;
      slice1cost_change_1_0_difference := ((slice1cost_change_0_0_difference mod 4096) + slice1cost_pixels_cost_5_0) -
        slice1cost_pixels_cost_1_0;
      slice1cost_change_1_1_difference := ((slice1cost_change_0_1_difference mod 4096) + slice1cost_pixels_cost_5_1) -
        slice1cost_pixels_cost_1_1;
      slice1cost_change_1_2_difference := ((slice1cost_change_0_2_difference mod 4096) + slice1cost_pixels_cost_5_2) -
        slice1cost_pixels_cost_1_2;
      slice1cost_change_2_0_difference := ((slice1cost_change_1_0_difference mod 4096) + slice1cost_pixels_cost_6_0) -
        slice1cost_pixels_cost_2_0;
      slice1cost_change_2_1_difference := ((slice1cost_change_1_1_difference mod 4096) + slice1cost_pixels_cost_6_1) -
        slice1cost_pixels_cost_2_1;
      slice1cost_change_2_2_difference := ((slice1cost_change_1_2_difference mod 4096) + slice1cost_pixels_cost_6_2) -
        slice1cost_pixels_cost_2_2;
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := slice1cost_ready_words_0 mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := slice1cost_ready_words_0 / 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := slice1cost_ready_words_1;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_3_0_choice := 0;
      else
        slice1cost_column_3_0_choice := (slice1cost_column_0_0_choice + slice1cost_change_3_0) mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_3_1_choice := 0;
      else
        slice1cost_column_3_1_choice := (slice1cost_column_0_1_choice + slice1cost_change_3_1) mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_3_2_choice := 0;
      else
        slice1cost_column_3_2_choice := (slice1cost_column_0_2_choice + slice1cost_change_3_2) mod 4096;
      end if;
      slice1cost_pixels_first_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_pixels_first_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_pixels_first_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_pixels_first_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_pixels_first_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_pixels_first_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_pixels_first_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_pixels_first_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_pixels_first_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_pixels_first_3_0 <= slice1shift_search_3_0 - slice1shift_reference_3;
      slice1cost_pixels_first_3_1 <= slice1shift_search_3_1 - slice1shift_reference_3;
      slice1cost_pixels_first_3_2 <= slice1shift_search_3_2 - slice1shift_reference_3;
      slice1cost_pixels_first_4_0 <= slice1shift_search_4_0 - slice1shift_reference_4;
      slice1cost_pixels_first_4_1 <= slice1shift_search_4_1 - slice1shift_reference_4;
      slice1cost_pixels_first_4_2 <= slice1shift_search_4_2 - slice1shift_reference_4;
      slice1cost_pixels_first_5_0 <= slice1shift_search_5_0 - slice1shift_reference_5;
      slice1cost_pixels_first_5_1 <= slice1shift_search_5_1 - slice1shift_reference_5;
      slice1cost_pixels_first_5_2 <= slice1shift_search_5_2 - slice1shift_reference_5;
      slice1cost_pixels_first_6_0 <= slice1shift_search_6_0 - slice1shift_reference_6;
      slice1cost_pixels_first_6_1 <= slice1shift_search_6_1 - slice1shift_reference_6;
      slice1cost_pixels_first_6_2 <= slice1shift_search_6_2 - slice1shift_reference_6;
      slice1cost_pixels_first_7_0 <= slice1shift_search_7_0 - slice1shift_reference_7;
      slice1cost_pixels_first_7_1 <= slice1shift_search_7_1 - slice1shift_reference_7;
      slice1cost_pixels_first_7_2 <= slice1shift_search_7_2 - slice1shift_reference_7;
      slice1cost_pixels_cost_0_0 <= (folded(slice1cost_pixels_first_0_0) + as_number((slice1cost_pixels_first_0_0 <
        0))) mod 256;
      slice1cost_pixels_cost_0_1 <= (folded(slice1cost_pixels_first_0_1) + as_number((slice1cost_pixels_first_0_1 <
        0))) mod 256;
      slice1cost_pixels_cost_0_2 <= (folded(slice1cost_pixels_first_0_2) + as_number((slice1cost_pixels_first_0_2 <
        0))) mod 256;
      slice1cost_pixels_cost_1_0 <= (folded(slice1cost_pixels_first_1_0) + as_number((slice1cost_pixels_first_1_0 <
        0))) mod 256;
      slice1cost_pixels_cost_1_1 <= (folded(slice1cost_pixels_first_1_1) + as_number((slice1cost_pixels_first_1_1 <
        0))) mod 256;
      slice1cost_pixels_cost_1_2 <= (folded(slice1cost_pixels_first_1_2) + as_number((slice1cost_pixels_first_1_2 <
        0))) mod 256;
      slice1cost_pixels_cost_2_0 <= (folded(slice1cost_pixels_first_2_0) + as_number((slice1cost_pixels_first_2_0 <
        0))) mod 256;
      slice1cost_pixels_cost_2_1 <= (folded(slice1cost_pixels_first_2_1) + as_number((slice1cost_pixels_first_2_1 <
        0))) mod 256;
      slice1cost_pixels_cost_2_2 <= (folded(slice1cost_pixels_first_2_2) + as_number((slice1cost_pixels_first_2_2 <
        0))) mod 256;
      slice1cost_pixels_cost_3_0 <= (folded(slice1cost_pixels_first_3_0) + as_number((slice1cost_pixels_first_3_0 <
        0))) mod 256;
      slice1cost_pixels_cost_3_1 <= (folded(slice1cost_pixels_first_3_1) + as_number((slice1cost_pixels_first_3_1 <
        0))) mod 256;
      slice1cost_pixels_cost_3_2 <= (folded(slice1cost_pixels_first_3_2) + as_number((slice1cost_pixels_first_3_2 <
        0))) mod 256;
      slice1cost_pixels_cost_4_0 <= (folded(slice1cost_pixels_first_4_0) + as_number((slice1cost_pixels_first_4_0 <
        0))) mod 256;
      slice1cost_pixels_cost_4_1 <= (folded(slice1cost_pixels_first_4_1) + as_number((slice1cost_pixels_first_4_1 <
        0))) mod 256;
      slice1cost_pixels_cost_4_2 <= (folded(slice1cost_pixels_first_4_2) + as_number((slice1cost_pixels_first_4_2 <
        0))) mod 256;
      slice1cost_pixels_cost_5_0 <= (folded(slice1cost_pixels_first_5_0) + as_number((slice1cost_pixels_first_5_0 <
        0))) mod 256;
      slice1cost_pixels_cost_5_1 <= (folded(slice1cost_pixels_first_5_1) + as_number((slice1cost_pixels_first_5_1 <
        0))) mod 256;
      slice1cost_pixels_cost_5_2 <= (folded(slice1cost_pixels_first_5_2) + as_number((slice1cost_pixels_first_5_2 <
        0))) mod 256;
      slice1cost_pixels_cost_6_0 <= (folded(slice1cost_pixels_first_6_0) + as_number((slice1cost_pixels_first_6_0 <
        0))) mod 256;
      slice1cost_pixels_cost_6_1 <= (folded(slice1cost_pixels_first_6_1) + as_number((slice1cost_pixels_first_6_1 <
        0))) mod 256;
      slice1cost_pixels_cost_6_2 <= (folded(slice1cost_pixels_first_6_2) + as_number((slice1cost_pixels_first_6_2 <
        0))) mod 256;
      slice1cost_pixels_cost_7_0 <= (folded(slice1cost_pixels_first_7_0) + as_number((slice1cost_pixels_first_7_0 <
        0))) mod 256;
      slice1cost_pixels_cost_7_1 <= (folded(slice1cost_pixels_first_7_1) + as_number((slice1cost_pixels_first_7_1 <
        0))) mod 256;
      slice1cost_pixels_cost_7_2 <= (folded(slice1cost_pixels_first_7_2) + as_number((slice1cost_pixels_first_7_2 <
        0))) mod 256;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice0cost_change_column;
      slice1cost_change_0_0 <= slice1cost_change_0_0_difference;
      slice1cost_change_0_1 <= slice1cost_change_0_1_difference;
      slice1cost_change_0_2 <= slice1cost_change_0_2_difference;
      slice1cost_change_1_0 <= ((slice1cost_change_1_0_difference + 2048) mod 4096) - 2048;
      slice1cost_change_1_1 <= ((slice1cost_change_1_1_difference + 2048) mod 4096) - 2048;
      slice1cost_change_1_2 <= ((slice1cost_change_1_2_difference + 2048) mod 4096) - 2048;
      slice1cost_change_2_0 <= ((slice1cost_change_2_0_difference + 2048) mod 4096) - 2048;
      slice1cost_change_2_1 <= ((slice1cost_change_2_1_difference + 2048) mod 4096) - 2048;
      slice1cost_change_2_2 <= ((slice1cost_change_2_2_difference + 2048) mod 4096) - 2048;
      slice1cost_change_3_0 <= ((((slice1cost_pixels_cost_7_0 - slice1cost_pixels_cost_3_0) +
        slice1cost_change_2_0_difference) + 2048) mod 4096) - 2048;
      slice1cost_change_3_1 <= ((((slice1cost_pixels_cost_7_1 - slice1cost_pixels_cost_3_1) +
        slice1cost_change_2_1_difference) + 2048) mod 4096) - 2048;
      slice1cost_change_3_2 <= ((((slice1cost_pixels_cost_7_2 - slice1cost_pixels_cost_3_2) +
        slice1cost_change_2_2_difference) + 2048) mod 4096) - 2048;
      slice1cost_ready_words_0 <= to_integer(slice1cost_read_words_0);
      slice1cost_ready_words_1 <= to_integer(slice1cost_read_words_1);
      slice1cost_ready_column <= slice1cost_change_column;
      slice1cost_column_3_0 <= slice1cost_column_3_0_choice;
      slice1cost_column_3_1 <= slice1cost_column_3_1_choice;
      slice1cost_column_3_2 <= slice1cost_column_3_2_choice;
      slice1cost_write_column <= slice0cost_write_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
        slice1cost_column_2_0 <= 0;
        slice1cost_column_2_1 <= 0;
        slice1cost_column_2_2 <= 0;
      else
        slice1cost_column_0_0 <= (slice1cost_column_0_0_choice + slice1cost_change_0_0) mod 4096;
        slice1cost_column_0_1 <= (slice1cost_column_0_1_choice + slice1cost_change_0_1) mod 4096;
        slice1cost_column_0_2 <= (slice1cost_column_0_2_choice + slice1cost_change_0_2) mod 4096;
        slice1cost_column_1_0 <= (slice1cost_column_0_0_choice + slice1cost_change_1_0) mod 4096;
        slice1cost_column_1_1 <= (slice1cost_column_0_1_choice + slice1cost_change_1_1) mod 4096;
        slice1cost_column_1_2 <= (slice1cost_column_0_2_choice + slice1cost_change_1_2) mod 4096;
        slice1cost_column_2_0 <= (slice1cost_column_0_0_choice + slice1cost_change_2_0) mod 4096;
        slice1cost_column_2_1 <= (slice1cost_column_0_1_choice + slice1cost_change_2_1) mod 4096;
        slice1cost_column_2_2 <= (slice1cost_column_0_2_choice + slice1cost_change_2_2) mod 4096;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_words_0 <= (slice1cost_column_3_1_choice * 4096) + slice1cost_column_3_0_choice;
        slice1cost_write_words_1 <= slice1cost_column_3_2_choice;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 10 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(11 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(23 downto 12));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_1(11 downto 0));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_1_0_choice := to_integer(slice1window_leaving_1(23 downto 12));
      else
        slice1window_change_1_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_1_1_choice := to_integer(slice1window_leaving_2(11 downto 0));
      else
        slice1window_change_1_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_1_2_choice := to_integer(slice1window_leaving_2(23 downto 12));
      else
        slice1window_change_1_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_2_0_choice := to_integer(slice1window_leaving_3(11 downto 0));
      else
        slice1window_change_2_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_2_1_choice := to_integer(slice1window_leaving_3(23 downto 12));
      else
        slice1window_change_2_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_2_2_choice := to_integer(slice1window_leaving_4(11 downto 0));
      else
        slice1window_change_2_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_3_0_choice := to_integer(slice1window_leaving_4(23 downto 12));
      else
        slice1window_change_3_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_3_1_choice := to_integer(slice1window_leaving_5(11 downto 0));
      else
        slice1window_change_3_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_3_2_choice := to_integer(slice1window_leaving_5(23 downto 12));
      else
        slice1window_change_3_2_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_1_0 <= slice1cost_column_1_0;
      slice1window_entering_1_1 <= slice1cost_column_1_1;
      slice1window_entering_1_2 <= slice1cost_column_1_2;
      slice1window_entering_2_0 <= slice1cost_column_2_0;
      slice1window_entering_2_1 <= slice1cost_column_2_1;
      slice1window_entering_2_2 <= slice1cost_column_2_2;
      slice1window_entering_3_0 <= slice1cost_column_3_0;
      slice1window_entering_3_1 <= slice1cost_column_3_1;
      slice1window_entering_3_2 <= slice1cost_column_3_2;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_1_0 <= slice1window_entering_1_0 - slice1window_change_1_0_choice;
      slice1window_change_1_1 <= slice1window_entering_1_1 - slice1window_change_1_1_choice;
      slice1window_change_1_2 <= slice1window_entering_1_2 - slice1window_change_1_2_choice;
      slice1window_change_2_0 <= slice1window_entering_2_0 - slice1window_change_2_0_choice;
      slice1window_change_2_1 <= slice1window_entering_2_1 - slice1window_change_2_1_choice;
      slice1window_change_2_2 <= slice1window_entering_2_2 - slice1window_change_2_2_choice;
      slice1window_change_3_0 <= slice1window_entering_3_0 - slice1window_change_3_0_choice;
      slice1window_change_3_1 <= slice1window_entering_3_1 - slice1window_change_3_1_choice;
      slice1window_change_3_2 <= slice1window_entering_3_2 - slice1window_change_3_2_choice;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_0_choice := 0;
      else
        slice1window_sum_0_0_choice := slice1window_sum_0_0;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_1_choice := 0;
      else
        slice1window_sum_0_1_choice := slice1window_sum_0_1;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_2_choice := 0;
      else
        slice1window_sum_0_2_choice := slice1window_sum_0_2;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_1_0_choice := 0;
      else
        slice1window_sum_1_0_choice := slice1window_sum_1_0;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_1_1_choice := 0;
      else
        slice1window_sum_1_1_choice := slice1window_sum_1_1;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_1_2_choice := 0;
      else
        slice1window_sum_1_2_choice := slice1window_sum_1_2;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_2_0_choice := 0;
      else
        slice1window_sum_2_0_choice := slice1window_sum_2_0;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_2_1_choice := 0;
      else
        slice1window_sum_2_1_choice := slice1window_sum_2_1;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_2_2_choice := 0;
      else
        slice1window_sum_2_2_choice := slice1window_sum_2_2;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_3_0_choice := 0;
      else
        slice1window_sum_3_0_choice := slice1window_sum_3_0;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_3_1_choice := 0;
      else
        slice1window_sum_3_1_choice := slice1window_sum_3_1;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_3_2_choice := 0;
      else
        slice1window_sum_3_2_choice := slice1window_sum_3_2;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 32768;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 32768;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 32768;
        slice1window_sum_1_0 <= (slice1window_sum_1_0_choice + slice1window_change_1_0) mod 32768;
        slice1window_sum_1_1 <= (slice1window_sum_1_1_choice + slice1window_change_1_1) mod 32768;
        slice1window_sum_1_2 <= (slice1window_sum_1_2_choice + slice1window_change_1_2) mod 32768;
        slice1window_sum_2_0 <= (slice1window_sum_2_0_choice + slice1window_change_2_0) mod 32768;
        slice1window_sum_2_1 <= (slice1window_sum_2_1_choice + slice1window_change_2_1) mod 32768;
        slice1window_sum_2_2 <= (slice1window_sum_2_2_choice + slice1window_change_2_2) mod 32768;
        slice1window_sum_3_0 <= (slice1window_sum_3_0_choice + slice1window_change_3_0) mod 32768;
        slice1window_sum_3_1 <= (slice1window_sum_3_1_choice + slice1window_change_3_1) mod 32768;
        slice1window_sum_3_2 <= (slice1window_sum_3_2_choice + slice1window_change_3_2) mod 32768;
      end if;
      if slice0winner1_tag_valid then
        slice1window_centre_output_column_1 <= slice0window_centre_output_column_1;
        slice1window_centre_start_of_frame_2 <= slice0window_centre_start_of_frame_2;
        slice1window_centre_end_of_line_1 <= slice0window_centre_end_of_line_1;
      end if;
      -- slice1winner1
      slice1winner1_best_cost_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_best_cost_1_0_is_less := (slice1window_sum_1_1 - slice1window_sum_1_0) < 0;
      slice1winner1_best_cost_2_0_is_less := (slice1window_sum_2_1 - slice1window_sum_2_0) < 0;
      slice1winner1_best_cost_3_0_is_less := (slice1window_sum_3_1 - slice1window_sum_3_0) < 0;
      slice1winner1_best_cost_0_1 <= slice1window_sum_0_2;
      slice1winner1_best_cost_1_1 <= slice1window_sum_1_2;
      slice1winner1_best_cost_2_1 <= slice1window_sum_2_2;
      slice1winner1_best_cost_3_1 <= slice1window_sum_3_2;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_index_1_0 <= slice1winner1_best_cost_1_0_is_less;
      slice1winner1_best_index_2_0 <= slice1winner1_best_cost_2_0_is_less;
      slice1winner1_best_index_3_0 <= slice1winner1_best_cost_3_0_is_less;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      if slice1winner1_best_cost_1_0_is_less then
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_1;
      else
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_0;
      end if;
      if slice1winner1_best_cost_2_0_is_less then
        slice1winner1_best_cost_2_0 <= slice1window_sum_2_1;
      else
        slice1winner1_best_cost_2_0 <= slice1window_sum_2_0;
      end if;
      if slice1winner1_best_cost_3_0_is_less then
        slice1winner1_best_cost_3_0 <= slice1window_sum_3_1;
      else
        slice1winner1_best_cost_3_0 <= slice1window_sum_3_0;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_cost_1_0_is_less := (slice1winner1_best_cost_1_1 - slice1winner1_best_cost_1_0) < 0;
      slice1winner2_best_cost_2_0_is_less := (slice1winner1_best_cost_2_1 - slice1winner1_best_cost_2_0) < 0;
      slice1winner2_best_cost_3_0_is_less := (slice1winner1_best_cost_3_1 - slice1winner1_best_cost_3_0) < 0;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
      end if;
      if slice1winner2_best_cost_1_0_is_less then
        slice1winner2_best_cost_1_0 <= slice1winner1_best_cost_1_1;
        slice1winner2_best_index_1_0 <= slice0winner1_best_index_0_1;
      else
        slice1winner2_best_cost_1_0 <= slice1winner1_best_cost_1_0;
        slice1winner2_best_index_1_0 <= as_number(slice1winner1_best_index_1_0);
      end if;
      if slice1winner2_best_cost_2_0_is_less then
        slice1winner2_best_cost_2_0 <= slice1winner1_best_cost_2_1;
        slice1winner2_best_index_2_0 <= slice0winner1_best_index_0_1;
      else
        slice1winner2_best_cost_2_0 <= slice1winner1_best_cost_2_0;
        slice1winner2_best_index_2_0 <= as_number(slice1winner1_best_index_2_0);
      end if;
      if slice1winner2_best_cost_3_0_is_less then
        slice1winner2_best_cost_3_0 <= slice1winner1_best_cost_3_1;
        slice1winner2_best_index_3_0 <= slice0winner1_best_index_0_1;
      else
        slice1winner2_best_cost_3_0 <= slice1winner1_best_cost_3_0;
        slice1winner2_best_index_3_0 <= as_number(slice1winner1_best_index_3_0);
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner2_best_cost_0_0) < 0;
      slice1_best_cost_1_0_is_less := (slice0_best_cost_1_0 - slice1winner2_best_cost_1_0) < 0;
      slice1_best_cost_2_0_is_less := (slice0_best_cost_2_0 - slice1winner2_best_cost_2_0) < 0;
      slice1_best_cost_3_0_is_less := (slice0_best_cost_3_0 - slice1winner2_best_cost_3_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner2_best_index_0_0 + 3;
      end if;
      if slice1_best_cost_1_0_is_less then
        slice1_best_cost_1_0 <= slice0_best_cost_1_0;
        slice1_best_index_1_0 <= slice0_best_index_1_0;
      else
        slice1_best_cost_1_0 <= slice1winner2_best_cost_1_0;
        slice1_best_index_1_0 <= slice1winner2_best_index_1_0 + 3;
      end if;
      if slice1_best_cost_2_0_is_less then
        slice1_best_cost_2_0 <= slice0_best_cost_2_0;
        slice1_best_index_2_0 <= slice0_best_index_2_0;
      else
        slice1_best_cost_2_0 <= slice1winner2_best_cost_2_0;
        slice1_best_index_2_0 <= slice1winner2_best_index_2_0 + 3;
      end if;
      if slice1_best_cost_3_0_is_less then
        slice1_best_cost_3_0 <= slice0_best_cost_3_0;
        slice1_best_index_3_0 <= slice0_best_index_3_0;
      else
        slice1_best_cost_3_0 <= slice1winner2_best_cost_3_0;
        slice1_best_index_3_0 <= slice1winner2_best_index_3_0 + 3;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice2shift_search_0_2;
        slice2shift_search_0_2 <= slice1shift_search_out_0;
        slice2shift_search_1_0 <= slice2shift_search_1_1;
        slice2shift_search_1_1 <= slice2shift_search_1_2;
        slice2shift_search_1_2 <= slice1shift_search_out_1;
        slice2shift_search_2_0 <= slice2shift_search_2_1;
        slice2shift_search_2_1 <= slice2shift_search_2_2;
        slice2shift_search_2_2 <= slice1shift_search_out_2;
        slice2shift_search_3_0 <= slice2shift_search_3_1;
        slice2shift_search_3_1 <= slice2shift_search_3_2;
        slice2shift_search_3_2 <= slice1shift_search_out_3;
        slice2shift_search_4_0 <= slice2shift_search_4_1;
        slice2shift_search_4_1 <= slice2shift_search_4_2;
        slice2shift_search_4_2 <= slice1shift_search_out_4;
        slice2shift_search_5_0 <= slice2shift_search_5_1;
        slice2shift_search_5_1 <= slice2shift_search_5_2;
        slice2shift_search_5_2 <= slice1shift_search_out_5;
        slice2shift_search_6_0 <= slice2shift_search_6_1;
        slice2shift_search_6_1 <= slice2shift_search_6_2;
        slice2shift_search_6_2 <= slice1shift_search_out_6;
        slice2shift_search_7_0 <= slice2shift_search_7_1;
        slice2shift_search_7_1 <= slice2shift_search_7_2;
        slice2shift_search_7_2 <= slice1shift_search_out_7;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      slice2shift_reference_3 <= slice1shift_reference_3;
      slice2shift_reference_4 <= slice1shift_reference_4;
      slice2shift_reference_5 <= slice1shift_reference_5;
      slice2shift_reference_6 <= slice1shift_reference_6;
      slice2shift_reference_7 <= slice1shift_reference_7;
      -- slice2cost
      slice2cost_change_0_0_difference := slice2cost_pixels_cost_4_0 - slice2cost_pixels_cost_0_0;
      slice2cost_change_0_1_difference := slice2cost_pixels_cost_4_1 - slice2cost_pixels_cost_0_1;
      slice2cost_change_0_2_difference := slice2cost_pixels_cost_4_2 - slice2cost_pixels_cost_0_2;
      slice2cost_change_1_0_difference := ((slice2cost_change_0_0_difference mod 4096) + slice2cost_pixels_cost_5_0) -
        slice2cost_pixels_cost_1_0;
      slice2cost_change_1_1_difference := ((slice2cost_change_0_1_difference mod 4096) + slice2cost_pixels_cost_5_1) -
        slice2cost_pixels_cost_1_1;
      slice2cost_change_1_2_difference := ((slice2cost_change_0_2_difference mod 4096) + slice2cost_pixels_cost_5_2) -
        slice2cost_pixels_cost_1_2;
      slice2cost_change_2_0_difference := ((slice2cost_change_1_0_difference mod 4096) + slice2cost_pixels_cost_6_0) -
        slice2cost_pixels_cost_2_0;
      slice2cost_change_2_1_difference := ((slice2cost_change_1_1_difference mod 4096) + slice2cost_pixels_cost_6_1) -
        slice2cost_pixels_cost_2_1;
      slice2cost_change_2_2_difference := ((slice2cost_change_1_2_difference mod 4096) + slice2cost_pixels_cost_6_2) -
        slice2cost_pixels_cost_2_2;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_0_choice := 0;
      else
        slice2cost_column_0_0_choice := slice2cost_ready_words_0 mod 4096;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_1_choice := 0;
      else
        slice2cost_column_0_1_choice := slice2cost_ready_words_0 / 4096;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_2_choice := 0;
      else
        slice2cost_column_0_2_choice := slice2cost_ready_words_1;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_3_0_choice := 0;
      else
        slice2cost_column_3_0_choice := (slice2cost_column_0_0_choice + slice2cost_change_3_0) mod 4096;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_3_1_choice := 0;
      else
        slice2cost_column_3_1_choice := (slice2cost_column_0_1_choice + slice2cost_change_3_1) mod 4096;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_3_2_choice := 0;
      else
        slice2cost_column_3_2_choice := (slice2cost_column_0_2_choice + slice2cost_change_3_2) mod 4096;
      end if;
      slice2cost_pixels_first_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_pixels_first_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_pixels_first_0_2 <= slice2shift_search_0_2 - slice2shift_reference_0;
      slice2cost_pixels_first_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_pixels_first_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_pixels_first_1_2 <= slice2shift_search_1_2 - slice2shift_reference_1;
      slice2cost_pixels_first_2_0 <= slice2shift_search_2_0 - slice2shift_reference_2;
      slice2cost_pixels_first_2_1 <= slice2shift_search_2_1 - slice2shift_reference_2;
      slice2cost_pixels_first_2_2 <= slice2shift_search_2_2 - slice2shift_reference_2;
      slice2cost_pixels_first_3_0 <= slice2shift_search_3_0 - slice2shift_reference_3;
      slice2cost_pixels_first_3_1 <= slice2shift_search_3_1 - slice2shift_reference_3;
      slice2cost_pixels_first_3_2 <= slice2shift_search_3_2 - slice2shift_reference_3;
      slice2cost_pixels_first_4_0 <= slice2shift_search_4_0 - slice2shift_reference_4;
      slice2cost_pixels_first_4_1 <= slice2shift_search_4_1 - slice2shift_reference_4;
      slice2cost_pixels_first_4_2 <= slice2shift_search_4_2 - slice2shift_reference_4;
      slice2cost_pixels_first_5_0 <= slice2shift_search_5_0 - slice2shift_reference_5;
      slice2cost_pixels_first_5_1 <= slice2shift_search_5_1 - slice2shift_reference_5;
      slice2cost_pixels_first_5_2 <= slice2shift_search_5_2 - slice2shift_reference_5;
      slice2cost_pixels_first_6_0 <= slice2shift_search_6_0 - slice2shift_reference_6;
      slice2cost_pixels_first_6_1 <= slice2shift_search_6_1 - slice2shift_reference_6;
      slice2cost_pixels_first_6_2 <= slice2shift_search_6_2 - slice2shift_reference_6;
      slice2cost_pixels_first_7_0 <= slice2shift_search_7_0 - slice2shift_reference_7;
      slice2cost_pixels_first_7_1 <= slice2shift_search_7_1 - slice2shift_reference_7;
      slice2cost_pixels_first_7_2 <= slice2shift_search_7_2 - slice2shift_reference_7;
      slice2cost_pixels_cost_0_0 <= (folded(slice2cost_pixels_first_0_0) + as_number((slice2cost_pixels_first_0_0 <
        0))) mod 256;
      slice2cost_pixels_cost_0_1 <= (folded(slice2cost_pixels_first_0_1) + as_number((slice2cost_pixels_first_0_1 <
        0))) mod 256;
      slice2cost_pixels_cost_0_2 <= (folded(slice2cost_pixels_first_0_2) + as_number((slice2cost_pixels_first_0_2 <
        0))) mod 256;
      slice2cost_pixels_cost_1_0 <= (folded(slice2cost_pixels_first_1_0) + as_number((slice2cost_pixels_first_1_0 <
        0))) mod 256;
      slice2cost_pixels_cost_1_1 <= (folded(slice2cost_pixels_first_1_1) + as_number((slice2cost_pixels_first_1_1 <
        0))) mod 256;
      slice2cost_pixels_cost_1_2 <= (folded(slice2cost_pixels_first_1_2) + as_number((slice2cost_pixels_first_1_2 <
        0))) mod 256;
      slice2cost_pixels_cost_2_0 <= (folded(slice2cost_pixels_first_2_0) + as_number((slice2cost_pixels_first_2_0 <
        0))) mod 256;
      slice2cost_pixels_cost_2_1 <= (folded(slice2cost_pixels_first_2_1) + as_number((slice2cost_pixels_first_2_1 <
        0))) mod 256;
      slice2cost_pixels_cost_2_2 <= (folded(slice2cost_pixels_first_2_2) + as_number((slice2cost_pixels_first_2_2 <
        0))) mod 256;
      slice2cost_pixels_cost_3_0 <= (folded(slice2cost_pixels_first_3_0) + as_number((slice2cost_pixels_first_3_0 <
        0))) mod 256;
      slice2cost_pixels_cost_3_1 <= (folded(slice2cost_pixels_first_3_1) + as_number((slice2cost_pixels_first_3_1 <
        0))) mod 256;
      slice2cost_pixels_cost_3_2 <= (folded(slice2cost_pixels_first_3_2) + as_number((slice2cost_pixels_first_3_2 <
        0))) mod 256;
      slice2cost_pixels_cost_4_0 <= (folded(slice2cost_pixels_first_4_0) + as_number((slice2cost_pixels_first_4_0 <
        0))) mod 256;
      slice2cost_pixels_cost_4_1 <= (folded(slice2cost_pixels_first_4_1) + as_number((slice2cost_pixels_first_4_1 <
        0))) mod 256;
      slice2cost_pixels_cost_4_2 <= (folded(slice2cost_pixels_first_4_2) + as_number((slice2cost_pixels_first_4_2 <
        0))) mod 256;
      slice2cost_pixels_cost_5_0 <= (folded(slice2cost_pixels_first_5_0) + as_number((slice2cost_pixels_first_5_0 <
        0))) mod 256;
      slice2cost_pixels_cost_5_1 <= (folded(slice2cost_pixels_first_5_1) + as_number((slice2cost_pixels_first_5_1 <
        0))) mod 256;
      slice2cost_pixels_cost_5_2 <= (folded(slice2cost_pixels_first_5_2) + as_number((slice2cost_pixels_first_5_2 <
        0))) mod 256;
      slice2cost_pixels_cost_6_0 <= (folded(slice2cost_pixels_first_6_0) + as_number((slice2cost_pixels_first_6_0 <
        0))) mod 256;
      slice2cost_pixels_cost_6_1 <= (folded(slice2cost_pixels_first_6_1) + as_number((slice2cost_pixels_first_6_1 <
        0))) mod 256;
      slice2cost_pixels_cost_6_2 <= (folded(slice2cost_pixels_first_6_2) + as_number((slice2cost_pixels_first_6_2 <
        0))) mod 256;
      slice2cost_pixels_cost_7_0 <= (folded(slice2cost_pixels_first_7_0) + as_number((slice2cost_pixels_first_7_0 <
        0))) mod 256;
      slice2cost_pixels_cost_7_1 <= (folded(slice2cost_pixels_first_7_1) + as_number((slice2cost_pixels_first_7_1 <
        0))) mod 256;
      slice2cost_pixels_cost_7_2 <= (folded(slice2cost_pixels_first_7_2) + as_number((slice2cost_pixels_first_7_2 <
        0))) mod 256;
      slice2cost_read_column <= slice1cost_read_column;
      slice2cost_change_0_0 <= slice2cost_change_0_0_difference;
      slice2cost_change_0_1 <= slice2cost_change_0_1_difference;
      slice2cost_change_0_2 <= slice2cost_change_0_2_difference;
      slice2cost_change_1_0 <= ((slice2cost_change_1_0_difference + 2048) mod 4096) - 2048;
      slice2cost_change_1_1 <= ((slice2cost_change_1_1_difference + 2048) mod 4096) - 2048;
      slice2cost_change_1_2 <= ((slice2cost_change_1_2_difference + 2048) mod 4096) - 2048;
      slice2cost_change_2_0 <= ((slice2cost_change_2_0_difference + 2048) mod 4096) - 2048;
      slice2cost_change_2_1 <= ((slice2cost_change_2_1_difference + 2048) mod 4096) - 2048;
      slice2cost_change_2_2 <= ((slice2cost_change_2_2_difference + 2048) mod 4096) - 2048;
      slice2cost_change_3_0 <= ((((slice2cost_pixels_cost_7_0 - slice2cost_pixels_cost_3_0) +
        slice2cost_change_2_0_difference) + 2048) mod 4096) - 2048;
      slice2cost_change_3_1 <= ((((slice2cost_pixels_cost_7_1 - slice2cost_pixels_cost_3_1) +
        slice2cost_change_2_1_difference) + 2048) mod 4096) - 2048;
      slice2cost_change_3_2 <= ((((slice2cost_pixels_cost_7_2 - slice2cost_pixels_cost_3_2) +
        slice2cost_change_2_2_difference) + 2048) mod 4096) - 2048;
      slice2cost_ready_words_0 <= to_integer(slice2cost_read_words_0);
      slice2cost_ready_words_1 <= to_integer(slice2cost_read_words_1);
      slice2cost_column_3_0 <= slice2cost_column_3_0_choice;
      slice2cost_column_3_1 <= slice2cost_column_3_1_choice;
      slice2cost_column_3_2 <= slice2cost_column_3_2_choice;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_0_2 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
        slice2cost_column_1_2 <= 0;
        slice2cost_column_2_0 <= 0;
        slice2cost_column_2_1 <= 0;
        slice2cost_column_2_2 <= 0;
      else
        slice2cost_column_0_0 <= (slice2cost_column_0_0_choice + slice2cost_change_0_0) mod 4096;
        slice2cost_column_0_1 <= (slice2cost_column_0_1_choice + slice2cost_change_0_1) mod 4096;
        slice2cost_column_0_2 <= (slice2cost_column_0_2_choice + slice2cost_change_0_2) mod 4096;
        slice2cost_column_1_0 <= (slice2cost_column_0_0_choice + slice2cost_change_1_0) mod 4096;
        slice2cost_column_1_1 <= (slice2cost_column_0_1_choice + slice2cost_change_1_1) mod 4096;
        slice2cost_column_1_2 <= (slice2cost_column_0_2_choice + slice2cost_change_1_2) mod 4096;
        slice2cost_column_2_0 <= (slice2cost_column_0_0_choice + slice2cost_change_2_0) mod 4096;
        slice2cost_column_2_1 <= (slice2cost_column_0_1_choice + slice2cost_change_2_1) mod 4096;
        slice2cost_column_2_2 <= (slice2cost_column_0_2_choice + slice2cost_change_2_2) mod 4096;
      end if;
      if slice0cost_ready_tag_valid then
        slice2cost_change_column <= slice2cost_read_column;
      end if;
      if slice0cost_tag_valid then
        slice2cost_ready_column <= slice1cost_ready_column;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_column <= slice1cost_write_column;
        slice2cost_write_words_0 <= (slice2cost_column_3_1_choice * 4096) + slice2cost_column_3_0_choice;
        slice2cost_write_words_1 <= slice2cost_column_3_2_choice;
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 10 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_0_choice := to_integer(slice2window_leaving_0(11 downto 0));
      else
        slice2window_change_0_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_1_choice := to_integer(slice2window_leaving_0(23 downto 12));
      else
        slice2window_change_0_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_2_choice := to_integer(slice2window_leaving_1(11 downto 0));
      else
        slice2window_change_0_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_1_0_choice := to_integer(slice2window_leaving_1(23 downto 12));
      else
        slice2window_change_1_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_1_1_choice := to_integer(slice2window_leaving_2(11 downto 0));
      else
        slice2window_change_1_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_1_2_choice := to_integer(slice2window_leaving_2(23 downto 12));
      else
        slice2window_change_1_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_2_0_choice := to_integer(slice2window_leaving_3(11 downto 0));
      else
        slice2window_change_2_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_2_1_choice := to_integer(slice2window_leaving_3(23 downto 12));
      else
        slice2window_change_2_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_2_2_choice := to_integer(slice2window_leaving_4(11 downto 0));
      else
        slice2window_change_2_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_3_0_choice := to_integer(slice2window_leaving_4(23 downto 12));
      else
        slice2window_change_3_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_3_1_choice := to_integer(slice2window_leaving_5(11 downto 0));
      else
        slice2window_change_3_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_3_2_choice := to_integer(slice2window_leaving_5(23 downto 12));
      else
        slice2window_change_3_2_choice := 0;
      end if;
      slice2window_entering_0_0 <= slice2cost_column_0_0;
      slice2window_entering_0_1 <= slice2cost_column_0_1;
      slice2window_entering_0_2 <= slice2cost_column_0_2;
      slice2window_entering_1_0 <= slice2cost_column_1_0;
      slice2window_entering_1_1 <= slice2cost_column_1_1;
      slice2window_entering_1_2 <= slice2cost_column_1_2;
      slice2window_entering_2_0 <= slice2cost_column_2_0;
      slice2window_entering_2_1 <= slice2cost_column_2_1;
      slice2window_entering_2_2 <= slice2cost_column_2_2;
      slice2window_entering_3_0 <= slice2cost_column_3_0;
      slice2window_entering_3_1 <= slice2cost_column_3_1;
      slice2window_entering_3_2 <= slice2cost_column_3_2;
      slice2window_change_0_0 <= slice2window_entering_0_0 - slice2window_change_0_0_choice;
      slice2window_change_0_1 <= slice2window_entering_0_1 - slice2window_change_0_1_choice;
      slice2window_change_0_2 <= slice2window_entering_0_2 - slice2window_change_0_2_choice;
      slice2window_change_1_0 <= slice2window_entering_1_0 - slice2window_change_1_0_choice;
      slice2window_change_1_1 <= slice2window_entering_1_1 - slice2window_change_1_1_choice;
      slice2window_change_1_2 <= slice2window_entering_1_2 - slice2window_change_1_2_choice;
      slice2window_change_2_0 <= slice2window_entering_2_0 - slice2window_change_2_0_choice;
      slice2window_change_2_1 <= slice2window_entering_2_1 - slice2window_change_2_1_choice;
      slice2window_change_2_2 <= slice2window_entering_2_2 - slice2window_change_2_2_choice;
      slice2window_change_3_0 <= slice2window_entering_3_0 - slice2window_change_3_0_choice;
      slice2window_change_3_1 <= slice2window_entering_3_1 - slice2window_change_3_1_choice;
      slice2window_change_3_2 <= slice2window_entering_3_2 - slice2window_change_3_2_choice;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_0_choice := 0;
      else
        slice2window_sum_0_0_choice := slice2window_sum_0_0;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_1_choice := 0;
      else
        slice2window_sum_0_1_choice := slice2window_sum_0_1;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_2_choice := 0;
      else
        slice2window_sum_0_2_choice := slice2window_sum_0_2;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_1_0_choice := 0;
      else
        slice2window_sum_1_0_choice := slice2window_sum_1_0;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_1_1_choice := 0;
      else
        slice2window_sum_1_1_choice := slice2window_sum_1_1;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_1_2_choice := 0;
      else
        slice2window_sum_1_2_choice := slice2window_sum_1_2;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_2_0_choice := 0;
      else
        slice2window_sum_2_0_choice := slice2window_sum_2_0;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_2_1_choice := 0;
      else
        slice2window_sum_2_1_choice := slice2window_sum_2_1;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_2_2_choice := 0;
      else
        slice2window_sum_2_2_choice := slice2window_sum_2_2;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_3_0_choice := 0;
      else
        slice2window_sum_3_0_choice := slice2window_sum_3_0;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_3_1_choice := 0;
      else
        slice2window_sum_3_1_choice := slice2window_sum_3_1;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_3_2_choice := 0;
      else
        slice2window_sum_3_2_choice := slice2window_sum_3_2;
      end if;
      if slice0winner1_tag_valid then
        slice2window_sum_0_0 <= (slice2window_sum_0_0_choice + slice2window_change_0_0) mod 32768;
        slice2window_sum_0_1 <= (slice2window_sum_0_1_choice + slice2window_change_0_1) mod 32768;
        slice2window_sum_0_2 <= (slice2window_sum_0_2_choice + slice2window_change_0_2) mod 32768;
        slice2window_sum_1_0 <= (slice2window_sum_1_0_choice + slice2window_change_1_0) mod 32768;
        slice2window_sum_1_1 <= (slice2window_sum_1_1_choice + slice2window_change_1_1) mod 32768;
        slice2window_sum_1_2 <= (slice2window_sum_1_2_choice + slice2window_change_1_2) mod 32768;
        slice2window_sum_2_0 <= (slice2window_sum_2_0_choice + slice2window_change_2_0) mod 32768;
        slice2window_sum_2_1 <= (slice2window_sum_2_1_choice + slice2window_change_2_1) mod 32768;
        slice2window_sum_2_2 <= (slice2window_sum_2_2_choice + slice2window_change_2_2) mod 32768;
        slice2window_sum_3_0 <= (slice2window_sum_3_0_choice + slice2window_change_3_0) mod 32768;
        slice2window_sum_3_1 <= (slice2window_sum_3_1_choice + slice2window_change_3_1) mod 32768;
        slice2window_sum_3_2 <= (slice2window_sum_3_2_choice + slice2window_change_3_2) mod 32768;
        slice2window_centre_output_column_1 <= slice1window_centre_output_column_1;
        slice2window_centre_output_column_2 <= slice2window_centre_output_column_1;
        slice2window_centre_start_of_frame_2 <= slice1window_centre_start_of_frame_2;
        slice2window_centre_end_of_line_1 <= slice1window_centre_end_of_line_1;
        slice2window_centre_end_of_line_2 <= slice2window_centre_end_of_line_1;
      end if;
      -- slice2winner1
      slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0_1 - slice2window_sum_0_0) < 0;
      slice2winner1_best_cost_1_0_is_less := (slice2window_sum_1_1 - slice2window_sum_1_0) < 0;
      slice2winner1_best_cost_2_0_is_less := (slice2window_sum_2_1 - slice2window_sum_2_0) < 0;
      slice2winner1_best_cost_3_0_is_less := (slice2window_sum_3_1 - slice2window_sum_3_0) < 0;
      slice2winner1_best_cost_0_1 <= slice2window_sum_0_2;
      slice2winner1_best_cost_1_1 <= slice2window_sum_1_2;
      slice2winner1_best_cost_2_1 <= slice2window_sum_2_2;
      slice2winner1_best_cost_3_1 <= slice2window_sum_3_2;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      slice2winner1_best_index_1_0 <= slice2winner1_best_cost_1_0_is_less;
      slice2winner1_best_index_2_0 <= slice2winner1_best_cost_2_0_is_less;
      slice2winner1_best_index_3_0 <= slice2winner1_best_cost_3_0_is_less;
      if slice2winner1_best_cost_0_0_is_less then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      if slice2winner1_best_cost_1_0_is_less then
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_1;
      else
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_0;
      end if;
      if slice2winner1_best_cost_2_0_is_less then
        slice2winner1_best_cost_2_0 <= slice2window_sum_2_1;
      else
        slice2winner1_best_cost_2_0 <= slice2window_sum_2_0;
      end if;
      if slice2winner1_best_cost_3_0_is_less then
        slice2winner1_best_cost_3_0 <= slice2window_sum_3_1;
      else
        slice2winner1_best_cost_3_0 <= slice2window_sum_3_0;
      end if;
      -- slice2winner2
      slice2winner2_best_cost_0_0_is_less := (slice2winner1_best_cost_0_1 - slice2winner1_best_cost_0_0) < 0;
      slice2winner2_best_cost_1_0_is_less := (slice2winner1_best_cost_1_1 - slice2winner1_best_cost_1_0) < 0;
      slice2winner2_best_cost_2_0_is_less := (slice2winner1_best_cost_2_1 - slice2winner1_best_cost_2_0) < 0;
      slice2winner2_best_cost_3_0_is_less := (slice2winner1_best_cost_3_1 - slice2winner1_best_cost_3_0) < 0;
      if slice2winner2_best_cost_0_0_is_less then
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_1;
        slice2winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
      end if;
      if slice2winner2_best_cost_1_0_is_less then
        slice2winner2_best_cost_1_0 <= slice2winner1_best_cost_1_1;
        slice2winner2_best_index_1_0 <= slice0winner1_best_index_0_1;
      else
        slice2winner2_best_cost_1_0 <= slice2winner1_best_cost_1_0;
        slice2winner2_best_index_1_0 <= as_number(slice2winner1_best_index_1_0);
      end if;
      if slice2winner2_best_cost_2_0_is_less then
        slice2winner2_best_cost_2_0 <= slice2winner1_best_cost_2_1;
        slice2winner2_best_index_2_0 <= slice0winner1_best_index_0_1;
      else
        slice2winner2_best_cost_2_0 <= slice2winner1_best_cost_2_0;
        slice2winner2_best_index_2_0 <= as_number(slice2winner1_best_index_2_0);
      end if;
      if slice2winner2_best_cost_3_0_is_less then
        slice2winner2_best_cost_3_0 <= slice2winner1_best_cost_3_1;
        slice2winner2_best_index_3_0 <= slice0winner1_best_index_0_1;
      else
        slice2winner2_best_cost_3_0 <= slice2winner1_best_cost_3_0;
        slice2winner2_best_index_3_0 <= as_number(slice2winner1_best_index_3_0);
      end if;
      -- slice2
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if (slice1_best_cost_0_0 - slice2winner2_best_cost_0_0) < 0 then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_index_0_0 <= slice2winner2_best_index_0_0;
      end if;
      if (slice1_best_cost_1_0 - slice2winner2_best_cost_1_0) < 0 then
        slice2_best_index_1_0 <= slice1_best_index_1_0;
      else
        slice2_best_index_1_0 <= slice2winner2_best_index_1_0;
      end if;
      if (slice1_best_cost_2_0 - slice2winner2_best_cost_2_0) < 0 then
        slice2_best_index_2_0 <= slice1_best_index_2_0;
      else
        slice2_best_index_2_0 <= slice2winner2_best_index_2_0;
      end if;
      if (slice1_best_cost_3_0 - slice2winner2_best_cost_3_0) < 0 then
        slice2_best_index_3_0 <= slice1_best_index_3_0;
      else
        slice2_best_index_3_0 <= slice2winner2_best_index_3_0;
      end if;
      -- other
      other_0 <= rows_reference_rows_read_newest_2 + (rows_reference_rows_read_newest_3 * 256);
      other_1 <= (rows_search_rows_read_newest_3 * 256) + rows_search_rows_read_newest_2;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 4;
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
        slice0window_centre_output_column_1 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_start_of_frame_2 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_centre_end_of_line_1 <= false;
        slice0window_tag_valid <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_output_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
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
        slice1window_centre_output_column_1 <= false;
        slice1window_centre_start_of_frame_2 <= false;
        slice1window_centre_end_of_line_1 <= false;
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
        slice2window_centre_output_column_2 <= false;
        slice2window_centre_start_of_frame_2 <= false;
        slice2window_centre_end_of_line_1 <= false;
        slice2window_centre_end_of_line_2 <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
