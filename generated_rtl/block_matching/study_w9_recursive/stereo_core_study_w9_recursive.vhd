-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration study_w9_recursive: 320x64, 16 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 16, window_px 9, aggregation recursive, slice_disparities 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config study_w9_recursive
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_study_w9_recursive is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 64;
    disparities : positive := 16;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 304;
    latency_clocks : positive := 19;
    flush_groups : positive := 1283;
    gap_groups : positive := 1280
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
  assert width_px = 320 report "stereo_core_study_w9_recursive: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 64 report "stereo_core_study_w9_recursive: height_px is " & integer'image(height_px) & " but this core has 64" severity failure;
  assert disparities = 16 report "stereo_core_study_w9_recursive: disparities is " & integer'image(disparities) & " but this core has 16" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_study_w9_recursive: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_study_w9_recursive: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 304 report "stereo_core_study_w9_recursive: output_width_px is " & integer'image(output_width_px) & " but this core has 304" severity failure;
  assert latency_clocks = 19 report "stereo_core_study_w9_recursive: latency_clocks is " & integer'image(latency_clocks) & " but this core has 19" severity failure;
  assert flush_groups = 1283 report "stereo_core_study_w9_recursive: flush_groups is " & integer'image(flush_groups) & " but this core has 1283" severity failure;
  assert gap_groups = 1280 report "stereo_core_study_w9_recursive: gap_groups is " & integer'image(gap_groups) & " but this core has 1280" severity failure;
end entity;

architecture rtl of stereo_core_study_w9_recursive is
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

  signal in_start_of_frame : boolean;
  signal in_valid : boolean;
  signal in_left_pixel : natural range 0 to 255;
  signal in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 511;
  signal raster_place_group : natural range 0 to 127;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_border_column, delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : unsigned(31 downto 0);
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_2, rows_reference_rows_read_words_2 : unsigned(7 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_2 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_0, rows_search_rows_write_words_2 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_2 : natural range 0 to 255;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_write_words_2, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 255;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_row_start : boolean;
  signal rows_read_tag_first_group, rows_read_tag_border_column, rows_read_tag_first_cost : boolean;
  signal rows_read_tag_leaves_window, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_row_start, rows_ready_tag_first_group, rows_ready_tag_border_column : boolean;
  signal rows_ready_tag_first_cost, rows_ready_tag_leaves_window, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_row_start : boolean;
  signal rows_tag_first_group, rows_tag_border_column, rows_tag_first_cost, rows_tag_leaves_window : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 255;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_1_0 : natural range 0 to 255;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 255;
  signal slice0shift_search_1_4, slice0shift_search_1_5, slice0shift_search_1_6 : natural range 0 to 255;
  signal slice0shift_search_1_7, slice0shift_reference_0, slice0shift_reference_1 : natural range 0 to 255;
  signal slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_2, slice0cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_6, slice0cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_0, slice0cost_pixels_first_1_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_2, slice0cost_pixels_first_1_3 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_4, slice0cost_pixels_first_1_5 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_6, slice0cost_pixels_first_1_7, slice0cost_change_0_0 : integer range -255 to 255;
  signal slice0cost_change_0_1, slice0cost_change_0_2, slice0cost_change_0_3 : integer range -255 to 255;
  signal slice0cost_change_0_4, slice0cost_change_0_5, slice0cost_change_0_6 : integer range -255 to 255;
  signal slice0cost_change_0_7 : integer range -255 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_first_group, slice0cost_pixels_tag_border_column : boolean;
  signal slice0cost_pixels_tag_first_cost, slice0cost_pixels_tag_leaves_window : boolean;
  signal slice0cost_pixels_tag_output_column, slice0cost_pixels_tag_start_of_frame : boolean;
  signal slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid, slice0cost_ready_tag_first_group : boolean;
  signal slice0cost_ready_tag_border_column, slice0cost_ready_tag_first_cost : boolean;
  signal slice0cost_ready_tag_leaves_window, slice0cost_ready_tag_output_column : boolean;
  signal slice0cost_ready_tag_start_of_frame, slice0cost_ready_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_1_0 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_1_5, slice0cost_pixels_cost_1_6 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(23 downto 0);
  signal slice0cost_read_words_3 : unsigned(23 downto 0);
  signal slice0cost_ready_words_0, slice0cost_ready_words_1, slice0cost_ready_words_2 : natural range 0 to 16777215;
  signal slice0cost_ready_words_3, slice0cost_write_words_0, slice0cost_write_words_1 : natural range 0 to 16777215;
  signal slice0cost_write_words_2, slice0cost_write_words_3 : natural range 0 to 16777215;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 4095;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 4095;
  signal slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 4095;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(23 downto 0);
  signal slice0window_leaving_3 : unsigned(23 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 4095;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 4095;
  signal slice0window_entering_0_6, slice0window_entering_0_7 : natural range 0 to 4095;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_1 : boolean;
  signal slice0window_centre_start_of_frame_2, slice0window_centre_start_of_frame_3 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -4095 to 4095;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -4095 to 4095;
  signal slice0window_change_0_6, slice0window_change_0_7 : integer range -4095 to 4095;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 32767;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 32767;
  signal slice0window_sum_0_6, slice0window_sum_0_7 : natural range 0 to 32767;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 32767;
  signal slice0winner1_of_pair_0_3, slice0winner1_of_pair_0_4, slice0winner1_of_pair_0_5 : natural range 0 to 32767;
  signal slice0winner1_of_pair_0_6, slice0winner1_of_pair_0_7, slice0winner1_of_four_0_0 : natural range 0 to 32767;
  signal slice0winner1_of_four_0_1, slice0winner1_of_four_0_2, slice0winner1_of_four_0_3 : natural range 0 to 32767;
  signal slice0winner1_of_four_0_4, slice0winner1_of_four_0_5, slice0winner1_of_four_0_6 : natural range 0 to 32767;
  signal slice0winner1_of_four_0_7, slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 32767;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_tag_valid, slice0winner1_pair_tag_output_column : boolean;
  signal slice0winner1_pair_tag_start_of_frame, slice0winner1_pair_tag_end_of_line : boolean;
  signal slice0winner1_four_tag_valid, slice0winner1_four_tag_output_column : boolean;
  signal slice0winner1_four_tag_start_of_frame, slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 3;
  signal slice0winner1_best_index_0_0 : natural range 0 to 3;
  signal slice0winner1_pair_index_0_2 : natural range 0 to 5;
  signal slice0winner1_pair_index_0_3, slice0winner1_four_index_0_1 : natural range 0 to 7;
  signal slice0winner1_best_index_0_1 : natural range 0 to 7;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0 : natural range 0 to 32767;
  signal slice0winner2_best_index_0_0 : natural range 0 to 7;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 32767;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 255;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_1_0 : natural range 0 to 255;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 255;
  signal slice1shift_search_1_4, slice1shift_search_1_5, slice1shift_search_1_6 : natural range 0 to 255;
  signal slice1shift_search_1_7, slice1shift_reference_0, slice1shift_reference_1 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_2, slice1cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_6, slice1cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_0, slice1cost_pixels_first_1_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_2, slice1cost_pixels_first_1_3 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_4, slice1cost_pixels_first_1_5 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_6, slice1cost_pixels_first_1_7, slice1cost_change_0_0 : integer range -255 to 255;
  signal slice1cost_change_0_1, slice1cost_change_0_2, slice1cost_change_0_3 : integer range -255 to 255;
  signal slice1cost_change_0_4, slice1cost_change_0_5, slice1cost_change_0_6 : integer range -255 to 255;
  signal slice1cost_change_0_7 : integer range -255 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_6, slice1cost_pixels_cost_0_7, slice1cost_pixels_cost_1_0 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_1_5, slice1cost_pixels_cost_1_6 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words_0, slice1cost_read_words_1, slice1cost_read_words_2 : unsigned(23 downto 0);
  signal slice1cost_read_words_3 : unsigned(23 downto 0);
  signal slice1cost_ready_words_0, slice1cost_ready_words_1, slice1cost_ready_words_2 : natural range 0 to 16777215;
  signal slice1cost_ready_words_3, slice1cost_write_words_0, slice1cost_write_words_1 : natural range 0 to 16777215;
  signal slice1cost_write_words_2, slice1cost_write_words_3 : natural range 0 to 16777215;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 4095;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 4095;
  signal slice1cost_column_0_6, slice1cost_column_0_7 : natural range 0 to 4095;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(23 downto 0);
  signal slice1window_leaving_3 : unsigned(23 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 4095;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 4095;
  signal slice1window_entering_0_6, slice1window_entering_0_7 : natural range 0 to 4095;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -4095 to 4095;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -4095 to 4095;
  signal slice1window_change_0_6, slice1window_change_0_7 : integer range -4095 to 4095;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 32767;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 32767;
  signal slice1window_sum_0_6, slice1window_sum_0_7 : natural range 0 to 32767;
  signal slice1window_centre_output_column_0, slice1window_centre_output_column_1 : boolean;
  signal slice1window_centre_output_column_2, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_centre_end_of_line_1, slice1window_centre_end_of_line_2 : boolean;
  -- slice1winner1
  signal slice1winner1_of_pair_0_0, slice1winner1_of_pair_0_1, slice1winner1_of_pair_0_2 : natural range 0 to 32767;
  signal slice1winner1_of_pair_0_3, slice1winner1_of_pair_0_4, slice1winner1_of_pair_0_5 : natural range 0 to 32767;
  signal slice1winner1_of_pair_0_6, slice1winner1_of_pair_0_7, slice1winner1_of_four_0_0 : natural range 0 to 32767;
  signal slice1winner1_of_four_0_1, slice1winner1_of_four_0_2, slice1winner1_of_four_0_3 : natural range 0 to 32767;
  signal slice1winner1_of_four_0_4, slice1winner1_of_four_0_5, slice1winner1_of_four_0_6 : natural range 0 to 32767;
  signal slice1winner1_of_four_0_7, slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 32767;
  signal slice1winner1_pair_index_0_0 : boolean;
  signal slice1winner1_pair_index_0_1, slice1winner1_four_index_0_0 : natural range 0 to 3;
  signal slice1winner1_best_index_0_0 : natural range 0 to 3;
  signal slice1winner1_pair_index_0_2 : natural range 0 to 5;
  signal slice1winner1_pair_index_0_3, slice1winner1_four_index_0_1 : natural range 0 to 7;
  signal slice1winner1_best_index_0_1 : natural range 0 to 7;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0 : natural range 0 to 32767;
  signal slice1winner2_best_index_0_0 : natural range 0 to 7;
  -- slice1
  signal slice1_best_index_0_0 : natural range 0 to 15;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
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
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(23 downto 0);
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
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice1_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice1_best_tag_valid and slice1_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice1_best_tag_start_of_frame and slice1_best_tag_valid and slice1_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice1_best_tag_end_of_line and slice1_best_tag_valid and slice1_best_tag_output_column);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0_7, 12) & to_unsigned(slice1cost_column_0_6, 12);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving_3,
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0_5, 12) & to_unsigned(slice1cost_column_0_4, 12);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_3, 12) & to_unsigned(slice1cost_column_0_2, 12);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_1, 12) & to_unsigned(slice1cost_column_0_0, 12);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words_3, 24);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words_3,
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words_2, 24);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words_2,
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words_1, 24);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words_0, 24);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0_7, 12) & to_unsigned(slice0cost_column_0_6, 12);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving_3,
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0_5, 12) & to_unsigned(slice0cost_column_0_4, 12);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_3, 12) & to_unsigned(slice0cost_column_0_2, 12);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_1, 12) & to_unsigned(slice0cost_column_0_0, 12);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words_3, 24);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words_3,
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words_2, 24);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 24);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 24);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 8);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 8, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= rows_search_rows_write_words_1;
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= rows_search_rows_write_words_0;
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 8);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 8, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= rows_reference_rows_write_words_1;
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= rows_reference_rows_write_words_0;
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 8);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, slice0winner1_of_pair_0_0_is_less : boolean;
    variable slice0winner1_of_pair_0_2_is_less, slice0winner1_of_pair_0_4_is_less : boolean;
    variable slice0winner1_of_pair_0_6_is_less, slice0winner1_of_four_0_0_is_less : boolean;
    variable slice0winner1_of_four_0_4_is_less, slice0winner2_best_cost_0_0_is_less : boolean;
    variable slice1winner1_of_pair_0_0_is_less, slice1winner1_of_pair_0_2_is_less : boolean;
    variable slice1winner1_of_pair_0_4_is_less, slice1winner1_of_pair_0_6_is_less : boolean;
    variable slice1winner1_of_four_0_0_is_less, slice1winner1_of_four_0_4_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less : boolean;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_choice_2 : natural range 0 to 4095;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_choice_2 : natural range 0 to 4095;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 4095;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 4095;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 4095;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 4095;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_0_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_1_choice, slice1cost_column_0_1_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_2_choice, slice1cost_column_0_2_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_3_choice, slice1cost_column_0_3_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_4_choice, slice1cost_column_0_4_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_5_choice, slice1cost_column_0_5_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_6_choice, slice1cost_column_0_6_choice_2 : natural range 0 to 4095;
    variable slice1cost_column_0_7_choice, slice1cost_column_0_7_choice_2 : natural range 0 to 4095;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 4095;
    variable slice1window_change_0_2_choice, slice1window_change_0_3_choice : natural range 0 to 4095;
    variable slice1window_change_0_4_choice, slice1window_change_0_5_choice : natural range 0 to 4095;
    variable slice1window_change_0_6_choice, slice1window_change_0_7_choice : natural range 0 to 4095;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 32767;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 32767;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 32767;
    variable slice0window_sum_0_6_choice, slice0window_sum_0_7_choice : natural range 0 to 32767;
    variable slice1window_sum_0_0_choice, slice1window_sum_0_1_choice : natural range 0 to 32767;
    variable slice1window_sum_0_2_choice, slice1window_sum_0_3_choice : natural range 0 to 32767;
    variable slice1window_sum_0_4_choice, slice1window_sum_0_5_choice : natural range 0 to 32767;
    variable slice1window_sum_0_6_choice, slice1window_sum_0_7_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 319;
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 68) and
          raster_place_group_is_equal and in_valid))) mod 128;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 15 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 16;
        end if;
      end if;
      delay_tag_first_cost_is_equal := raster_place_column = 15;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 9) and (raster_place_group < 73);
      delay_row_inside_1 <= not ((raster_place_group / 64) = 1);
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 15;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_leaves_window <= (((((raster_place_column / 8) + 8189) mod 8192) * 8) + (raster_place_column mod 8)) <
        65516;
      delay_tag_output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
        64) and (raster_place_column >= 15) and (raster_place_column < 319);
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 4);
      delay_tag_end_of_line <= raster_place_column = 318;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= rows_search_rows_read_words_1;
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= rows_reference_rows_read_words_1;
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
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
        rows_reference_0 <= to_integer(rows_reference_rows_ready_words_0(7 downto 0));
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
        rows_search_rows_write_words_0 <= rows_search_rows_ready_words_1(7 downto 0) &
          rows_search_rows_ready_words_0(31 downto 8);
        rows_search_rows_write_words_1 <= to_unsigned(rows_search_rows_ready_words_2, 8) &
          rows_search_rows_ready_words_1(31 downto 8);
        rows_search_rows_write_words_2 <= rows_search_rows_ready_newest_0;
        rows_reference_rows_write_words_0 <= rows_reference_rows_ready_words_1(7 downto 0) &
          rows_reference_rows_ready_words_0(31 downto 8);
        rows_reference_rows_write_words_1 <= to_unsigned(rows_reference_rows_ready_words_2, 8) &
          rows_reference_rows_ready_words_1(31 downto 8);
        rows_reference_rows_write_words_2 <= rows_reference_rows_ready_newest_0;
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
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
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
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0_choice_2 := 0;
      else
        slice0cost_column_0_0_choice_2 := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := slice0cost_ready_words_0 / 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_1_choice_2 := 0;
      else
        slice0cost_column_0_1_choice_2 := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := slice0cost_ready_words_1 mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_2_choice_2 := 0;
      else
        slice0cost_column_0_2_choice_2 := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := slice0cost_ready_words_1 / 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_3_choice_2 := 0;
      else
        slice0cost_column_0_3_choice_2 := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := slice0cost_ready_words_2 mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_4_choice_2 := 0;
      else
        slice0cost_column_0_4_choice_2 := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := slice0cost_ready_words_2 / 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_5_choice_2 := 0;
      else
        slice0cost_column_0_5_choice_2 := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := slice0cost_ready_words_3 mod 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_6_choice_2 := 0;
      else
        slice0cost_column_0_6_choice_2 := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 4096;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := slice0cost_ready_words_3 / 4096;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_7_choice_2 := 0;
      else
        slice0cost_column_0_7_choice_2 := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 4096;
      end if;
      slice0cost_pixels_first_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_pixels_first_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_pixels_first_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_pixels_first_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_pixels_first_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_pixels_first_0_5 <= slice0shift_search_0_5 - slice0shift_reference_0;
      slice0cost_pixels_first_0_6 <= slice0shift_search_0_6 - slice0shift_reference_0;
      slice0cost_pixels_first_0_7 <= slice0shift_search_0_7 - slice0shift_reference_0;
      slice0cost_pixels_first_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_pixels_first_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_pixels_first_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_pixels_first_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_pixels_first_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_pixels_first_1_5 <= slice0shift_search_1_5 - slice0shift_reference_1;
      slice0cost_pixels_first_1_6 <= slice0shift_search_1_6 - slice0shift_reference_1;
      slice0cost_pixels_first_1_7 <= slice0shift_search_1_7 - slice0shift_reference_1;
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
      slice0cost_pixels_cost_0_3 <= (folded(slice0cost_pixels_first_0_3) + as_number((slice0cost_pixels_first_0_3 <
        0))) mod 256;
      slice0cost_pixels_cost_0_4 <= (folded(slice0cost_pixels_first_0_4) + as_number((slice0cost_pixels_first_0_4 <
        0))) mod 256;
      slice0cost_pixels_cost_0_5 <= (folded(slice0cost_pixels_first_0_5) + as_number((slice0cost_pixels_first_0_5 <
        0))) mod 256;
      slice0cost_pixels_cost_0_6 <= (folded(slice0cost_pixels_first_0_6) + as_number((slice0cost_pixels_first_0_6 <
        0))) mod 256;
      slice0cost_pixels_cost_0_7 <= (folded(slice0cost_pixels_first_0_7) + as_number((slice0cost_pixels_first_0_7 <
        0))) mod 256;
      slice0cost_pixels_cost_1_0 <= (folded(slice0cost_pixels_first_1_0) + as_number((slice0cost_pixels_first_1_0 <
        0))) mod 256;
      slice0cost_pixels_cost_1_1 <= (folded(slice0cost_pixels_first_1_1) + as_number((slice0cost_pixels_first_1_1 <
        0))) mod 256;
      slice0cost_pixels_cost_1_2 <= (folded(slice0cost_pixels_first_1_2) + as_number((slice0cost_pixels_first_1_2 <
        0))) mod 256;
      slice0cost_pixels_cost_1_3 <= (folded(slice0cost_pixels_first_1_3) + as_number((slice0cost_pixels_first_1_3 <
        0))) mod 256;
      slice0cost_pixels_cost_1_4 <= (folded(slice0cost_pixels_first_1_4) + as_number((slice0cost_pixels_first_1_4 <
        0))) mod 256;
      slice0cost_pixels_cost_1_5 <= (folded(slice0cost_pixels_first_1_5) + as_number((slice0cost_pixels_first_1_5 <
        0))) mod 256;
      slice0cost_pixels_cost_1_6 <= (folded(slice0cost_pixels_first_1_6) + as_number((slice0cost_pixels_first_1_6 <
        0))) mod 256;
      slice0cost_pixels_cost_1_7 <= (folded(slice0cost_pixels_first_1_7) + as_number((slice0cost_pixels_first_1_7 <
        0))) mod 256;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
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
      slice0cost_ready_words_0 <= to_integer(slice0cost_read_words_0);
      slice0cost_ready_words_1 <= to_integer(slice0cost_read_words_1);
      slice0cost_ready_words_2 <= to_integer(slice0cost_read_words_2);
      slice0cost_ready_words_3 <= to_integer(slice0cost_read_words_3);
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
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
        slice0cost_write_words_0 <= (slice0cost_column_0_1_choice_2 * 4096) + slice0cost_column_0_0_choice_2;
        slice0cost_write_words_1 <= (slice0cost_column_0_3_choice_2 * 4096) + slice0cost_column_0_2_choice_2;
        slice0cost_write_words_2 <= (slice0cost_column_0_5_choice_2 * 4096) + slice0cost_column_0_4_choice_2;
        slice0cost_write_words_3 <= (slice0cost_column_0_7_choice_2 * 4096) + slice0cost_column_0_6_choice_2;
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
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_1(23 downto 12));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_2(11 downto 0));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_2(23 downto 12));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_6_choice := to_integer(slice0window_leaving_3(11 downto 0));
      else
        slice0window_change_0_6_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_7_choice := to_integer(slice0window_leaving_3(23 downto 12));
      else
        slice0window_change_0_7_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_0_3 <= slice0cost_column_0_3;
      slice0window_entering_0_4 <= slice0cost_column_0_4;
      slice0window_entering_0_5 <= slice0cost_column_0_5;
      slice0window_entering_0_6 <= slice0cost_column_0_6;
      slice0window_entering_0_7 <= slice0cost_column_0_7;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
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
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_first_column_0 <= slice0window_change_tag_first_cost;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
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
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 32768;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 32768;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 32768;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 32768;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 32768;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 32768;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 32768;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 32768;
      end if;
      if slice0window_tag_valid then
        slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
        slice0window_centre_start_of_frame_2 <= slice0window_centre_start_of_frame_1;
        slice0window_centre_start_of_frame_3 <= slice0window_centre_start_of_frame_2;
        slice0window_tag_output_column <= slice1window_centre_output_column_2;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_3;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_2;
      end if;
      -- slice0winner1
      slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_of_pair_0_2_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_of_pair_0_4_is_less := (slice0window_sum_0_5 - slice0window_sum_0_4) < 0;
      slice0winner1_of_pair_0_6_is_less := (slice0window_sum_0_7 - slice0window_sum_0_6) < 0;
      slice0winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0_2, 15)) or
        (to_unsigned(slice0winner1_of_pair_0_3, 15)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0_0, 15)) or
        (to_unsigned(slice0winner1_of_pair_0_1, 15))))) < 0;
      slice0winner1_of_four_0_4_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0_6, 15)) or
        (to_unsigned(slice0winner1_of_pair_0_7, 15)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0_4, 15)) or
        (to_unsigned(slice0winner1_of_pair_0_5, 15))))) < 0;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_pair_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_output_column <= slice0winner1_pair_tag_output_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(slice0winner1_of_four_0_2, 15)) or
        (to_unsigned(slice0winner1_of_four_0_3, 15)))) or (to_unsigned(slice0winner1_of_four_0_1, 15)))) or
        (to_unsigned(slice0winner1_of_four_0_0, 15))));
      slice0winner1_best_cost_0_1 <= to_integer(((((((to_unsigned(slice0winner1_of_four_0_6, 15)) or
        (to_unsigned(slice0winner1_of_four_0_7, 15)))) or (to_unsigned(slice0winner1_of_four_0_5, 15)))) or
        (to_unsigned(slice0winner1_of_four_0_4, 15))));
      slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
      slice0winner1_best_index_0_1 <= slice0winner1_four_index_0_1;
      slice0winner1_tag_valid <= slice0winner1_four_tag_valid;
      slice0winner1_tag_output_column <= slice0winner1_four_tag_output_column;
      slice0winner1_tag_start_of_frame <= slice0winner1_four_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0winner1_four_tag_end_of_line;
      if slice0winner1_of_pair_0_0_is_less then
        slice0winner1_of_pair_0_0 <= 0;
        slice0winner1_of_pair_0_1 <= slice0window_sum_0_1;
      else
        slice0winner1_of_pair_0_0 <= slice0window_sum_0_0;
        slice0winner1_of_pair_0_1 <= 0;
      end if;
      if slice0winner1_of_pair_0_2_is_less then
        slice0winner1_of_pair_0_2 <= 0;
        slice0winner1_of_pair_0_3 <= slice0window_sum_0_3;
        slice0winner1_pair_index_0_1 <= 3;
      else
        slice0winner1_of_pair_0_2 <= slice0window_sum_0_2;
        slice0winner1_of_pair_0_3 <= 0;
        slice0winner1_pair_index_0_1 <= 2;
      end if;
      if slice0winner1_of_pair_0_4_is_less then
        slice0winner1_of_pair_0_4 <= 0;
        slice0winner1_of_pair_0_5 <= slice0window_sum_0_5;
        slice0winner1_pair_index_0_2 <= 5;
      else
        slice0winner1_of_pair_0_4 <= slice0window_sum_0_4;
        slice0winner1_of_pair_0_5 <= 0;
        slice0winner1_pair_index_0_2 <= 4;
      end if;
      if slice0winner1_of_pair_0_6_is_less then
        slice0winner1_of_pair_0_6 <= 0;
        slice0winner1_of_pair_0_7 <= slice0window_sum_0_7;
        slice0winner1_pair_index_0_3 <= 7;
      else
        slice0winner1_of_pair_0_6 <= slice0window_sum_0_6;
        slice0winner1_of_pair_0_7 <= 0;
        slice0winner1_pair_index_0_3 <= 6;
      end if;
      if slice0winner1_of_four_0_0_is_less then
        slice0winner1_of_four_0_0 <= 0;
        slice0winner1_of_four_0_1 <= 0;
        slice0winner1_of_four_0_2 <= slice0winner1_of_pair_0_2;
        slice0winner1_of_four_0_3 <= slice0winner1_of_pair_0_3;
        slice0winner1_four_index_0_0 <= slice0winner1_pair_index_0_1;
      else
        slice0winner1_of_four_0_0 <= slice0winner1_of_pair_0_0;
        slice0winner1_of_four_0_1 <= slice0winner1_of_pair_0_1;
        slice0winner1_of_four_0_2 <= 0;
        slice0winner1_of_four_0_3 <= 0;
        slice0winner1_four_index_0_0 <= as_number(slice0winner1_pair_index_0_0);
      end if;
      if slice0winner1_of_four_0_4_is_less then
        slice0winner1_of_four_0_4 <= 0;
        slice0winner1_of_four_0_5 <= 0;
        slice0winner1_of_four_0_6 <= slice0winner1_of_pair_0_6;
        slice0winner1_of_four_0_7 <= slice0winner1_of_pair_0_7;
        slice0winner1_four_index_0_1 <= slice0winner1_pair_index_0_3;
      else
        slice0winner1_of_four_0_4 <= slice0winner1_of_pair_0_4;
        slice0winner1_of_four_0_5 <= slice0winner1_of_pair_0_5;
        slice0winner1_of_four_0_6 <= 0;
        slice0winner1_of_four_0_7 <= 0;
        slice0winner1_four_index_0_1 <= slice0winner1_pair_index_0_2;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_0;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner2_best_index_0_0 + 8;
      slice0_best_tag_valid <= slice0winner2_tag_valid;
      slice0_best_tag_output_column <= slice0winner2_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner2_tag_end_of_line;
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
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      -- slice1cost
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := slice1cost_ready_words_0 mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0_choice_2 := 0;
      else
        slice1cost_column_0_0_choice_2 := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := slice1cost_ready_words_0 / 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_1_choice_2 := 0;
      else
        slice1cost_column_0_1_choice_2 := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := slice1cost_ready_words_1 mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_2_choice_2 := 0;
      else
        slice1cost_column_0_2_choice_2 := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := slice1cost_ready_words_1 / 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_3_choice_2 := 0;
      else
        slice1cost_column_0_3_choice_2 := (slice1cost_change_0_3 + slice1cost_column_0_3_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := slice1cost_ready_words_2 mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_4_choice_2 := 0;
      else
        slice1cost_column_0_4_choice_2 := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := slice1cost_ready_words_2 / 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_5_choice_2 := 0;
      else
        slice1cost_column_0_5_choice_2 := (slice1cost_change_0_5 + slice1cost_column_0_5_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_6_choice := 0;
      else
        slice1cost_column_0_6_choice := slice1cost_ready_words_3 mod 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_6_choice_2 := 0;
      else
        slice1cost_column_0_6_choice_2 := (slice1cost_change_0_6 + slice1cost_column_0_6_choice) mod 4096;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_7_choice := 0;
      else
        slice1cost_column_0_7_choice := slice1cost_ready_words_3 / 4096;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_7_choice_2 := 0;
      else
        slice1cost_column_0_7_choice_2 := (slice1cost_change_0_7 + slice1cost_column_0_7_choice) mod 4096;
      end if;
      slice1cost_pixels_first_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_pixels_first_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_pixels_first_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_pixels_first_0_3 <= slice1shift_search_0_3 - slice1shift_reference_0;
      slice1cost_pixels_first_0_4 <= slice1shift_search_0_4 - slice1shift_reference_0;
      slice1cost_pixels_first_0_5 <= slice1shift_search_0_5 - slice1shift_reference_0;
      slice1cost_pixels_first_0_6 <= slice1shift_search_0_6 - slice1shift_reference_0;
      slice1cost_pixels_first_0_7 <= slice1shift_search_0_7 - slice1shift_reference_0;
      slice1cost_pixels_first_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_pixels_first_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_pixels_first_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_pixels_first_1_3 <= slice1shift_search_1_3 - slice1shift_reference_1;
      slice1cost_pixels_first_1_4 <= slice1shift_search_1_4 - slice1shift_reference_1;
      slice1cost_pixels_first_1_5 <= slice1shift_search_1_5 - slice1shift_reference_1;
      slice1cost_pixels_first_1_6 <= slice1shift_search_1_6 - slice1shift_reference_1;
      slice1cost_pixels_first_1_7 <= slice1shift_search_1_7 - slice1shift_reference_1;
      slice1cost_pixels_cost_0_0 <= (folded(slice1cost_pixels_first_0_0) + as_number((slice1cost_pixels_first_0_0 <
        0))) mod 256;
      slice1cost_pixels_cost_0_1 <= (folded(slice1cost_pixels_first_0_1) + as_number((slice1cost_pixels_first_0_1 <
        0))) mod 256;
      slice1cost_pixels_cost_0_2 <= (folded(slice1cost_pixels_first_0_2) + as_number((slice1cost_pixels_first_0_2 <
        0))) mod 256;
      slice1cost_pixels_cost_0_3 <= (folded(slice1cost_pixels_first_0_3) + as_number((slice1cost_pixels_first_0_3 <
        0))) mod 256;
      slice1cost_pixels_cost_0_4 <= (folded(slice1cost_pixels_first_0_4) + as_number((slice1cost_pixels_first_0_4 <
        0))) mod 256;
      slice1cost_pixels_cost_0_5 <= (folded(slice1cost_pixels_first_0_5) + as_number((slice1cost_pixels_first_0_5 <
        0))) mod 256;
      slice1cost_pixels_cost_0_6 <= (folded(slice1cost_pixels_first_0_6) + as_number((slice1cost_pixels_first_0_6 <
        0))) mod 256;
      slice1cost_pixels_cost_0_7 <= (folded(slice1cost_pixels_first_0_7) + as_number((slice1cost_pixels_first_0_7 <
        0))) mod 256;
      slice1cost_pixels_cost_1_0 <= (folded(slice1cost_pixels_first_1_0) + as_number((slice1cost_pixels_first_1_0 <
        0))) mod 256;
      slice1cost_pixels_cost_1_1 <= (folded(slice1cost_pixels_first_1_1) + as_number((slice1cost_pixels_first_1_1 <
        0))) mod 256;
      slice1cost_pixels_cost_1_2 <= (folded(slice1cost_pixels_first_1_2) + as_number((slice1cost_pixels_first_1_2 <
        0))) mod 256;
      slice1cost_pixels_cost_1_3 <= (folded(slice1cost_pixels_first_1_3) + as_number((slice1cost_pixels_first_1_3 <
        0))) mod 256;
      slice1cost_pixels_cost_1_4 <= (folded(slice1cost_pixels_first_1_4) + as_number((slice1cost_pixels_first_1_4 <
        0))) mod 256;
      slice1cost_pixels_cost_1_5 <= (folded(slice1cost_pixels_first_1_5) + as_number((slice1cost_pixels_first_1_5 <
        0))) mod 256;
      slice1cost_pixels_cost_1_6 <= (folded(slice1cost_pixels_first_1_6) + as_number((slice1cost_pixels_first_1_6 <
        0))) mod 256;
      slice1cost_pixels_cost_1_7 <= (folded(slice1cost_pixels_first_1_7) + as_number((slice1cost_pixels_first_1_7 <
        0))) mod 256;
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
      slice1cost_ready_words_0 <= to_integer(slice1cost_read_words_0);
      slice1cost_ready_words_1 <= to_integer(slice1cost_read_words_1);
      slice1cost_ready_words_2 <= to_integer(slice1cost_read_words_2);
      slice1cost_ready_words_3 <= to_integer(slice1cost_read_words_3);
      slice1cost_column_0_0 <= slice1cost_column_0_0_choice_2;
      slice1cost_column_0_1 <= slice1cost_column_0_1_choice_2;
      slice1cost_column_0_2 <= slice1cost_column_0_2_choice_2;
      slice1cost_column_0_3 <= slice1cost_column_0_3_choice_2;
      slice1cost_column_0_4 <= slice1cost_column_0_4_choice_2;
      slice1cost_column_0_5 <= slice1cost_column_0_5_choice_2;
      slice1cost_column_0_6 <= slice1cost_column_0_6_choice_2;
      slice1cost_column_0_7 <= slice1cost_column_0_7_choice_2;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        slice1cost_write_words_0 <= (slice1cost_column_0_1_choice_2 * 4096) + slice1cost_column_0_0_choice_2;
        slice1cost_write_words_1 <= (slice1cost_column_0_3_choice_2 * 4096) + slice1cost_column_0_2_choice_2;
        slice1cost_write_words_2 <= (slice1cost_column_0_5_choice_2 * 4096) + slice1cost_column_0_4_choice_2;
        slice1cost_write_words_3 <= (slice1cost_column_0_7_choice_2 * 4096) + slice1cost_column_0_6_choice_2;
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
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_1(23 downto 12));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_2(11 downto 0));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_2(23 downto 12));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_6_choice := to_integer(slice1window_leaving_3(11 downto 0));
      else
        slice1window_change_0_6_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_7_choice := to_integer(slice1window_leaving_3(23 downto 12));
      else
        slice1window_change_0_7_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_0_3 <= slice1cost_column_0_3;
      slice1window_entering_0_4 <= slice1cost_column_0_4;
      slice1window_entering_0_5 <= slice1cost_column_0_5;
      slice1window_entering_0_6 <= slice1cost_column_0_6;
      slice1window_entering_0_7 <= slice1cost_column_0_7;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_0_3 <= slice1window_entering_0_3 - slice1window_change_0_3_choice;
      slice1window_change_0_4 <= slice1window_entering_0_4 - slice1window_change_0_4_choice;
      slice1window_change_0_5 <= slice1window_entering_0_5 - slice1window_change_0_5_choice;
      slice1window_change_0_6 <= slice1window_entering_0_6 - slice1window_change_0_6_choice;
      slice1window_change_0_7 <= slice1window_entering_0_7 - slice1window_change_0_7_choice;
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
        slice1window_sum_0_3_choice := 0;
      else
        slice1window_sum_0_3_choice := slice1window_sum_0_3;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_4_choice := 0;
      else
        slice1window_sum_0_4_choice := slice1window_sum_0_4;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_5_choice := 0;
      else
        slice1window_sum_0_5_choice := slice1window_sum_0_5;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_6_choice := 0;
      else
        slice1window_sum_0_6_choice := slice1window_sum_0_6;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_7_choice := 0;
      else
        slice1window_sum_0_7_choice := slice1window_sum_0_7;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 32768;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 32768;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 32768;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 32768;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 32768;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 32768;
        slice1window_sum_0_6 <= (slice1window_sum_0_6_choice + slice1window_change_0_6) mod 32768;
        slice1window_sum_0_7 <= (slice1window_sum_0_7_choice + slice1window_change_0_7) mod 32768;
        slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
        slice1window_centre_output_column_1 <= slice1window_centre_output_column_0;
        slice1window_centre_output_column_2 <= slice1window_centre_output_column_1;
        slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
        slice1window_centre_end_of_line_1 <= slice1window_centre_end_of_line_0;
        slice1window_centre_end_of_line_2 <= slice1window_centre_end_of_line_1;
      end if;
      -- slice1winner1
      slice1winner1_of_pair_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_of_pair_0_2_is_less := (slice1window_sum_0_3 - slice1window_sum_0_2) < 0;
      slice1winner1_of_pair_0_4_is_less := (slice1window_sum_0_5 - slice1window_sum_0_4) < 0;
      slice1winner1_of_pair_0_6_is_less := (slice1window_sum_0_7 - slice1window_sum_0_6) < 0;
      slice1winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice1winner1_of_pair_0_2, 15)) or
        (to_unsigned(slice1winner1_of_pair_0_3, 15)))) - to_integer(((to_unsigned(slice1winner1_of_pair_0_0, 15)) or
        (to_unsigned(slice1winner1_of_pair_0_1, 15))))) < 0;
      slice1winner1_of_four_0_4_is_less := (to_integer(((to_unsigned(slice1winner1_of_pair_0_6, 15)) or
        (to_unsigned(slice1winner1_of_pair_0_7, 15)))) - to_integer(((to_unsigned(slice1winner1_of_pair_0_4, 15)) or
        (to_unsigned(slice1winner1_of_pair_0_5, 15))))) < 0;
      slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_is_less;
      slice1winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(slice1winner1_of_four_0_2, 15)) or
        (to_unsigned(slice1winner1_of_four_0_3, 15)))) or (to_unsigned(slice1winner1_of_four_0_1, 15)))) or
        (to_unsigned(slice1winner1_of_four_0_0, 15))));
      slice1winner1_best_cost_0_1 <= to_integer(((((((to_unsigned(slice1winner1_of_four_0_6, 15)) or
        (to_unsigned(slice1winner1_of_four_0_7, 15)))) or (to_unsigned(slice1winner1_of_four_0_5, 15)))) or
        (to_unsigned(slice1winner1_of_four_0_4, 15))));
      slice1winner1_best_index_0_0 <= slice1winner1_four_index_0_0;
      slice1winner1_best_index_0_1 <= slice1winner1_four_index_0_1;
      if slice1winner1_of_pair_0_0_is_less then
        slice1winner1_of_pair_0_0 <= 0;
        slice1winner1_of_pair_0_1 <= slice1window_sum_0_1;
      else
        slice1winner1_of_pair_0_0 <= slice1window_sum_0_0;
        slice1winner1_of_pair_0_1 <= 0;
      end if;
      if slice1winner1_of_pair_0_2_is_less then
        slice1winner1_of_pair_0_2 <= 0;
        slice1winner1_of_pair_0_3 <= slice1window_sum_0_3;
        slice1winner1_pair_index_0_1 <= 3;
      else
        slice1winner1_of_pair_0_2 <= slice1window_sum_0_2;
        slice1winner1_of_pair_0_3 <= 0;
        slice1winner1_pair_index_0_1 <= 2;
      end if;
      if slice1winner1_of_pair_0_4_is_less then
        slice1winner1_of_pair_0_4 <= 0;
        slice1winner1_of_pair_0_5 <= slice1window_sum_0_5;
        slice1winner1_pair_index_0_2 <= 5;
      else
        slice1winner1_of_pair_0_4 <= slice1window_sum_0_4;
        slice1winner1_of_pair_0_5 <= 0;
        slice1winner1_pair_index_0_2 <= 4;
      end if;
      if slice1winner1_of_pair_0_6_is_less then
        slice1winner1_of_pair_0_6 <= 0;
        slice1winner1_of_pair_0_7 <= slice1window_sum_0_7;
        slice1winner1_pair_index_0_3 <= 7;
      else
        slice1winner1_of_pair_0_6 <= slice1window_sum_0_6;
        slice1winner1_of_pair_0_7 <= 0;
        slice1winner1_pair_index_0_3 <= 6;
      end if;
      if slice1winner1_of_four_0_0_is_less then
        slice1winner1_of_four_0_0 <= 0;
        slice1winner1_of_four_0_1 <= 0;
        slice1winner1_of_four_0_2 <= slice1winner1_of_pair_0_2;
        slice1winner1_of_four_0_3 <= slice1winner1_of_pair_0_3;
        slice1winner1_four_index_0_0 <= slice1winner1_pair_index_0_1;
      else
        slice1winner1_of_four_0_0 <= slice1winner1_of_pair_0_0;
        slice1winner1_of_four_0_1 <= slice1winner1_of_pair_0_1;
        slice1winner1_of_four_0_2 <= 0;
        slice1winner1_of_four_0_3 <= 0;
        slice1winner1_four_index_0_0 <= as_number(slice1winner1_pair_index_0_0);
      end if;
      if slice1winner1_of_four_0_4_is_less then
        slice1winner1_of_four_0_4 <= 0;
        slice1winner1_of_four_0_5 <= 0;
        slice1winner1_of_four_0_6 <= slice1winner1_of_pair_0_6;
        slice1winner1_of_four_0_7 <= slice1winner1_of_pair_0_7;
        slice1winner1_four_index_0_1 <= slice1winner1_pair_index_0_3;
      else
        slice1winner1_of_four_0_4 <= slice1winner1_of_pair_0_4;
        slice1winner1_of_four_0_5 <= slice1winner1_of_pair_0_5;
        slice1winner1_of_four_0_6 <= 0;
        slice1winner1_of_four_0_7 <= 0;
        slice1winner1_four_index_0_1 <= slice1winner1_pair_index_0_2;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_0;
      end if;
      -- slice1
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice0_best_cost_0_0 - slice1winner2_best_cost_0_0) < 0 then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_index_0_0 <= slice1winner2_best_index_0_0;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 68;
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
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_start_of_frame_2 <= false;
        slice0window_centre_start_of_frame_3 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_pair_tag_valid <= false;
        slice0winner1_pair_tag_output_column <= false;
        slice0winner1_pair_tag_start_of_frame <= false;
        slice0winner1_pair_tag_end_of_line <= false;
        slice0winner1_four_tag_valid <= false;
        slice0winner1_four_tag_output_column <= false;
        slice0winner1_four_tag_start_of_frame <= false;
        slice0winner1_four_tag_end_of_line <= false;
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
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_output_column_1 <= false;
        slice1window_centre_output_column_2 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1window_centre_end_of_line_1 <= false;
        slice1window_centre_end_of_line_2 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
