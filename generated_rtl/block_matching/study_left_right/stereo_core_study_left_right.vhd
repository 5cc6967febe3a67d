-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration study_left_right: 320x64, 16 disparities, window 5x5, 1 pixel pair a clock.
-- Options: disparities 16, window_px 5, left_right_threshold 1, slice_disparities 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config study_left_right
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_study_left_right is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 64;
    disparities : positive := 16;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 304;
    latency_clocks : positive := 20;
    flush_groups : positive := 656;
    gap_groups : natural := 0
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
  assert width_px = 320 report "stereo_core_study_left_right: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 64 report "stereo_core_study_left_right: height_px is " & integer'image(height_px) & " but this core has 64" severity failure;
  assert disparities = 16 report "stereo_core_study_left_right: disparities is " & integer'image(disparities) & " but this core has 16" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_study_left_right: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_study_left_right: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 304 report "stereo_core_study_left_right: output_width_px is " & integer'image(output_width_px) & " but this core has 304" severity failure;
  assert latency_clocks = 20 report "stereo_core_study_left_right: latency_clocks is " & integer'image(latency_clocks) & " but this core has 20" severity failure;
  assert flush_groups = 656 report "stereo_core_study_left_right: flush_groups is " & integer'image(flush_groups) & " but this core has 656" severity failure;
  assert gap_groups = 0 report "stereo_core_study_left_right: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_study_left_right is
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
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 511;
  signal raster_place_group : natural range 0 to 127;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_row_inside_3, delay_row_inside_4 : boolean;
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_reference_rows_read_words_0 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_search_3, rows_search_4, rows_reference_0 : natural range 0 to 255;
  signal rows_reference_1, rows_reference_2, rows_reference_3, rows_reference_4 : natural range 0 to 255;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_inside_3, rows_read_inside_4 : boolean;
  signal rows_read_tag_valid, rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2, rows_ready_inside_3 : boolean;
  signal rows_ready_inside_4, rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_first_cost : boolean;
  signal rows_ready_tag_map_column, rows_ready_tag_output_column, rows_ready_tag_start_of_frame : boolean;
  signal rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column, rows_tag_first_cost : boolean;
  signal rows_tag_map_column, rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 255;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_1_0 : natural range 0 to 255;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 255;
  signal slice0shift_search_1_4, slice0shift_search_1_5, slice0shift_search_1_6 : natural range 0 to 255;
  signal slice0shift_search_1_7, slice0shift_search_2_0, slice0shift_search_2_1 : natural range 0 to 255;
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : natural range 0 to 255;
  signal slice0shift_search_2_5, slice0shift_search_2_6, slice0shift_search_2_7 : natural range 0 to 255;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 255;
  signal slice0shift_search_3_3, slice0shift_search_3_4, slice0shift_search_3_5 : natural range 0 to 255;
  signal slice0shift_search_3_6, slice0shift_search_3_7, slice0shift_search_4_0 : natural range 0 to 255;
  signal slice0shift_search_4_1, slice0shift_search_4_2, slice0shift_search_4_3 : natural range 0 to 255;
  signal slice0shift_search_4_4, slice0shift_search_4_5, slice0shift_search_4_6 : natural range 0 to 255;
  signal slice0shift_search_4_7, slice0shift_reference_0, slice0shift_reference_1 : natural range 0 to 255;
  signal slice0shift_reference_2, slice0shift_reference_3, slice0shift_reference_4 : natural range 0 to 255;
  signal slice0shift_search_out_0, slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 255;
  signal slice0shift_search_out_3, slice0shift_search_out_4 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_0_3, slice0cost_difference_0_4, slice0cost_difference_0_5 : integer range -255 to 255;
  signal slice0cost_difference_0_6, slice0cost_difference_0_7, slice0cost_difference_1_0 : integer range -255 to 255;
  signal slice0cost_difference_1_1, slice0cost_difference_1_2, slice0cost_difference_1_3 : integer range -255 to 255;
  signal slice0cost_difference_1_4, slice0cost_difference_1_5, slice0cost_difference_1_6 : integer range -255 to 255;
  signal slice0cost_difference_1_7, slice0cost_difference_2_0, slice0cost_difference_2_1 : integer range -255 to 255;
  signal slice0cost_difference_2_2, slice0cost_difference_2_3, slice0cost_difference_2_4 : integer range -255 to 255;
  signal slice0cost_difference_2_5, slice0cost_difference_2_6, slice0cost_difference_2_7 : integer range -255 to 255;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -255 to 255;
  signal slice0cost_difference_3_3, slice0cost_difference_3_4, slice0cost_difference_3_5 : integer range -255 to 255;
  signal slice0cost_difference_3_6, slice0cost_difference_3_7, slice0cost_difference_4_0 : integer range -255 to 255;
  signal slice0cost_difference_4_1, slice0cost_difference_4_2, slice0cost_difference_4_3 : integer range -255 to 255;
  signal slice0cost_difference_4_4, slice0cost_difference_4_5, slice0cost_difference_4_6 : integer range -255 to 255;
  signal slice0cost_difference_4_7 : integer range -255 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_first_cost, slice0cost_difference_tag_map_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_negative_0_3, slice0cost_negative_0_4, slice0cost_negative_0_5 : boolean;
  signal slice0cost_negative_0_6, slice0cost_negative_0_7, slice0cost_negative_1_0, slice0cost_negative_1_1 : boolean;
  signal slice0cost_negative_1_2, slice0cost_negative_1_3, slice0cost_negative_1_4, slice0cost_negative_1_5 : boolean;
  signal slice0cost_negative_1_6, slice0cost_negative_1_7, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_first_cost, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_start_of_frame : boolean;
  signal slice0cost_pair_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_border_column : boolean;
  signal slice0cost_tag_first_cost, slice0cost_tag_map_column, slice0cost_tag_output_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 511;
  signal slice0cost_pair_0_4, slice0cost_pair_0_5, slice0cost_pair_0_6, slice0cost_pair_0_7 : natural range 0 to 511;
  signal slice0cost_pair_1_0, slice0cost_pair_1_1, slice0cost_pair_1_2, slice0cost_pair_1_3 : natural range 0 to 511;
  signal slice0cost_pair_1_4, slice0cost_pair_1_5, slice0cost_pair_1_6, slice0cost_pair_1_7 : natural range 0 to 511;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_single_0_3, slice0cost_single_0_4, slice0cost_single_0_5 : natural range 0 to 255;
  signal slice0cost_single_0_6, slice0cost_single_0_7 : natural range 0 to 255;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 1279;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 1279;
  signal slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 1279;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 1279;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4, slice0window_partial_0_0_5 : natural range 0 to 1279;
  signal slice0window_partial_0_0_6, slice0window_partial_0_0_7 : natural range 0 to 1279;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 2558;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4, slice0window_partial_0_1_5 : natural range 0 to 2558;
  signal slice0window_partial_0_1_6, slice0window_partial_0_1_7 : natural range 0 to 2558;
  signal slice0window_partial_0_2_0, slice0window_partial_0_2_1, slice0window_partial_0_2_2 : natural range 0 to 3837;
  signal slice0window_partial_0_2_3, slice0window_partial_0_2_4, slice0window_partial_0_2_5 : natural range 0 to 3837;
  signal slice0window_partial_0_2_6, slice0window_partial_0_2_7 : natural range 0 to 3837;
  signal slice0window_partial_0_3_0, slice0window_partial_0_3_1, slice0window_partial_0_3_2 : natural range 0 to 5116;
  signal slice0window_partial_0_3_3, slice0window_partial_0_3_4, slice0window_partial_0_3_5 : natural range 0 to 5116;
  signal slice0window_partial_0_3_6, slice0window_partial_0_3_7 : natural range 0 to 5116;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_output_column_1, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_first_column_1, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 6395;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 6395;
  signal slice0window_sum_0_6, slice0window_sum_0_7 : natural range 0 to 6395;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 6395;
  signal slice0other_cost_0_3, slice0other_cost_0_4, slice0other_cost_0_5 : natural range 0 to 6395;
  signal slice0other_cost_0_6, slice0other_cost_0_7, slice0other_cost_out_0 : natural range 0 to 6395;
  signal slice0other_winner_0_0, slice0other_winner_0_1, slice0other_winner_0_2 : natural range 0 to 15;
  signal slice0other_winner_0_3, slice0other_winner_0_4, slice0other_winner_0_5 : natural range 0 to 15;
  signal slice0other_winner_0_6, slice0other_winner_0_7, slice0other_winner_out_0 : natural range 0 to 15;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 6395;
  signal slice0winner1_of_pair_0_3, slice0winner1_of_pair_0_4, slice0winner1_of_pair_0_5 : natural range 0 to 6395;
  signal slice0winner1_of_pair_0_6, slice0winner1_of_pair_0_7, slice0winner1_of_four_0_0 : natural range 0 to 6395;
  signal slice0winner1_of_four_0_1, slice0winner1_of_four_0_2, slice0winner1_of_four_0_3 : natural range 0 to 6395;
  signal slice0winner1_of_four_0_4, slice0winner1_of_four_0_5, slice0winner1_of_four_0_6 : natural range 0 to 6395;
  signal slice0winner1_of_four_0_7 : natural range 0 to 6395;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_tag_valid, slice0winner1_pair_tag_map_column : boolean;
  signal slice0winner1_pair_tag_output_column, slice0winner1_pair_tag_first_column : boolean;
  signal slice0winner1_pair_tag_start_of_frame, slice0winner1_pair_tag_end_of_line : boolean;
  signal slice0winner1_four_tag_valid, slice0winner1_four_tag_map_column : boolean;
  signal slice0winner1_four_tag_output_column, slice0winner1_four_tag_start_of_frame : boolean;
  signal slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 3;
  signal slice0winner1_best_index_0_0 : natural range 0 to 3;
  signal slice0winner1_pair_index_0_2 : natural range 0 to 5;
  signal slice0winner1_pair_index_0_3, slice0winner1_four_index_0_1 : natural range 0 to 7;
  signal slice0winner1_best_index_0_1 : natural range 0 to 7;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 8191;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0 : natural range 0 to 8191;
  signal slice0winner2_best_index_0_0 : natural range 0 to 7;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 8191;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_output_column : boolean;
  signal slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 255;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_1_0 : natural range 0 to 255;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 255;
  signal slice1shift_search_1_4, slice1shift_search_1_5, slice1shift_search_1_6 : natural range 0 to 255;
  signal slice1shift_search_1_7, slice1shift_search_2_0, slice1shift_search_2_1 : natural range 0 to 255;
  signal slice1shift_search_2_2, slice1shift_search_2_3, slice1shift_search_2_4 : natural range 0 to 255;
  signal slice1shift_search_2_5, slice1shift_search_2_6, slice1shift_search_2_7 : natural range 0 to 255;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 255;
  signal slice1shift_search_3_3, slice1shift_search_3_4, slice1shift_search_3_5 : natural range 0 to 255;
  signal slice1shift_search_3_6, slice1shift_search_3_7, slice1shift_search_4_0 : natural range 0 to 255;
  signal slice1shift_search_4_1, slice1shift_search_4_2, slice1shift_search_4_3 : natural range 0 to 255;
  signal slice1shift_search_4_4, slice1shift_search_4_5, slice1shift_search_4_6 : natural range 0 to 255;
  signal slice1shift_search_4_7, slice1shift_reference_0, slice1shift_reference_1 : natural range 0 to 255;
  signal slice1shift_reference_2, slice1shift_reference_3, slice1shift_reference_4 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -255 to 255;
  signal slice1cost_difference_0_3, slice1cost_difference_0_4, slice1cost_difference_0_5 : integer range -255 to 255;
  signal slice1cost_difference_0_6, slice1cost_difference_0_7, slice1cost_difference_1_0 : integer range -255 to 255;
  signal slice1cost_difference_1_1, slice1cost_difference_1_2, slice1cost_difference_1_3 : integer range -255 to 255;
  signal slice1cost_difference_1_4, slice1cost_difference_1_5, slice1cost_difference_1_6 : integer range -255 to 255;
  signal slice1cost_difference_1_7, slice1cost_difference_2_0, slice1cost_difference_2_1 : integer range -255 to 255;
  signal slice1cost_difference_2_2, slice1cost_difference_2_3, slice1cost_difference_2_4 : integer range -255 to 255;
  signal slice1cost_difference_2_5, slice1cost_difference_2_6, slice1cost_difference_2_7 : integer range -255 to 255;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -255 to 255;
  signal slice1cost_difference_3_3, slice1cost_difference_3_4, slice1cost_difference_3_5 : integer range -255 to 255;
  signal slice1cost_difference_3_6, slice1cost_difference_3_7, slice1cost_difference_4_0 : integer range -255 to 255;
  signal slice1cost_difference_4_1, slice1cost_difference_4_2, slice1cost_difference_4_3 : integer range -255 to 255;
  signal slice1cost_difference_4_4, slice1cost_difference_4_5, slice1cost_difference_4_6 : integer range -255 to 255;
  signal slice1cost_difference_4_7 : integer range -255 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 511;
  signal slice1cost_pair_0_4, slice1cost_pair_0_5, slice1cost_pair_0_6, slice1cost_pair_0_7 : natural range 0 to 511;
  signal slice1cost_pair_1_0, slice1cost_pair_1_1, slice1cost_pair_1_2, slice1cost_pair_1_3 : natural range 0 to 511;
  signal slice1cost_pair_1_4, slice1cost_pair_1_5, slice1cost_pair_1_6, slice1cost_pair_1_7 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2, slice1cost_negative_0_3 : boolean;
  signal slice1cost_negative_0_4, slice1cost_negative_0_5, slice1cost_negative_0_6, slice1cost_negative_0_7 : boolean;
  signal slice1cost_negative_1_0, slice1cost_negative_1_1, slice1cost_negative_1_2, slice1cost_negative_1_3 : boolean;
  signal slice1cost_negative_1_4, slice1cost_negative_1_5, slice1cost_negative_1_6, slice1cost_negative_1_7 : boolean;
  signal slice1cost_tag_first_cost, slice1cost_tag_output_column : boolean;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_single_0_3, slice1cost_single_0_4, slice1cost_single_0_5 : natural range 0 to 255;
  signal slice1cost_single_0_6, slice1cost_single_0_7 : natural range 0 to 255;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 1279;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 1279;
  signal slice1cost_column_0_6, slice1cost_column_0_7 : natural range 0 to 1279;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 1279;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4, slice1window_partial_0_0_5 : natural range 0 to 1279;
  signal slice1window_partial_0_0_6, slice1window_partial_0_0_7 : natural range 0 to 1279;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 2558;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4, slice1window_partial_0_1_5 : natural range 0 to 2558;
  signal slice1window_partial_0_1_6, slice1window_partial_0_1_7 : natural range 0 to 2558;
  signal slice1window_partial_0_2_0, slice1window_partial_0_2_1, slice1window_partial_0_2_2 : natural range 0 to 3837;
  signal slice1window_partial_0_2_3, slice1window_partial_0_2_4, slice1window_partial_0_2_5 : natural range 0 to 3837;
  signal slice1window_partial_0_2_6, slice1window_partial_0_2_7 : natural range 0 to 3837;
  signal slice1window_partial_0_3_0, slice1window_partial_0_3_1, slice1window_partial_0_3_2 : natural range 0 to 5116;
  signal slice1window_partial_0_3_3, slice1window_partial_0_3_4, slice1window_partial_0_3_5 : natural range 0 to 5116;
  signal slice1window_partial_0_3_6, slice1window_partial_0_3_7 : natural range 0 to 5116;
  signal slice1window_centre_map_column_0, slice1window_centre_output_column_0 : boolean;
  signal slice1window_centre_output_column_1, slice1window_centre_first_column_0 : boolean;
  signal slice1window_centre_first_column_1, slice1window_centre_start_of_frame_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 6395;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 6395;
  signal slice1window_sum_0_6, slice1window_sum_0_7 : natural range 0 to 6395;
  -- slice1other
  signal slice1other_cost_0_1, slice1other_cost_0_2, slice1other_cost_0_3 : natural range 0 to 6395;
  signal slice1other_cost_0_4, slice1other_cost_0_5, slice1other_cost_0_6 : natural range 0 to 6395;
  signal slice1other_cost_0_7 : natural range 0 to 6395;
  signal slice1other_winner_0_0, slice1other_winner_0_1, slice1other_winner_0_2 : natural range 0 to 15;
  signal slice1other_winner_0_3, slice1other_winner_0_4, slice1other_winner_0_5 : natural range 0 to 15;
  signal slice1other_winner_0_6, slice1other_winner_0_7, slice1other_winner_out_0 : natural range 0 to 15;
  -- slice1winner1
  signal slice1winner1_of_pair_0_0, slice1winner1_of_pair_0_1, slice1winner1_of_pair_0_2 : natural range 0 to 6395;
  signal slice1winner1_of_pair_0_3, slice1winner1_of_pair_0_4, slice1winner1_of_pair_0_5 : natural range 0 to 6395;
  signal slice1winner1_of_pair_0_6, slice1winner1_of_pair_0_7, slice1winner1_of_four_0_0 : natural range 0 to 6395;
  signal slice1winner1_of_four_0_1, slice1winner1_of_four_0_2, slice1winner1_of_four_0_3 : natural range 0 to 6395;
  signal slice1winner1_of_four_0_4, slice1winner1_of_four_0_5, slice1winner1_of_four_0_6 : natural range 0 to 6395;
  signal slice1winner1_of_four_0_7 : natural range 0 to 6395;
  signal slice1winner1_pair_index_0_0 : boolean;
  signal slice1winner1_pair_index_0_1, slice1winner1_four_index_0_0 : natural range 0 to 3;
  signal slice1winner1_best_index_0_0 : natural range 0 to 3;
  signal slice1winner1_pair_index_0_2 : natural range 0 to 5;
  signal slice1winner1_pair_index_0_3, slice1winner1_four_index_0_1 : natural range 0 to 7;
  signal slice1winner1_best_index_0_1 : natural range 0 to 7;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 8191;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0 : natural range 0 to 8191;
  signal slice1winner2_best_index_0_0 : natural range 0 to 7;
  -- slice1
  signal slice1_best_index_0_0 : natural range 0 to 15;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_output_column : boolean;
  signal slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  -- leftright
  signal leftright_other_1_0, leftright_other_2_0, leftright_other_3_0 : natural range 0 to 15;
  signal leftright_ring_read_address, leftright_ring_write_address : natural range 0 to 15;
  signal leftright_asking_disparity_0, leftright_answered_disparity_0 : natural range 0 to 15;
  signal leftright_checked_disparity_0 : natural range 0 to 15;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_output_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_tag_valid : boolean;
  signal leftright_answered_tag_output_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_output_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 31;
  signal leftright_held_0 : unsigned(12 downto 0);
  signal leftright_found_0 : unsigned(3 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address : unsigned(4 downto 0);
  signal leftright_found_0_memory_write_address : unsigned(4 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(3 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(12 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
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
  disparity <= std_logic_vector(to_unsigned(leftright_checked_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(leftright_checked_passed_0), 1));
  disparity_valid <= as_bit(leftright_checked_tag_valid and leftright_checked_tag_output_column);
  disparity_start_of_frame <= as_bit(leftright_checked_tag_start_of_frame and leftright_checked_tag_valid and leftright_checked_tag_output_column);
  disparity_end_of_line <= as_bit(leftright_checked_tag_end_of_line and leftright_checked_tag_valid and leftright_checked_tag_output_column);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 5);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 5);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_3_0, 4);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 32, width => 4, address_bits => 5)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 4);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 4);
  leftright_held_0_memory_write_data <= to_unsigned(1, 1) & to_unsigned(slice1_best_index_0_0, 8) & to_unsigned(as_number(slice1_best_tag_end_of_line), 1) & to_unsigned(as_number(slice1_best_tag_start_of_frame), 1) & to_unsigned(as_number(slice1_best_tag_output_column), 1) & to_unsigned(as_number(slice1_best_tag_map_column), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 16, width => 13, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

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
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_group_is_equal_3, raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable delay_row_inside_2_is_less, delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, slice0other_cost_0_0_all, slice0other_cost_0_1_all : boolean;
    variable slice0other_cost_0_1_choice, slice0other_cost_0_2_choice, slice0other_cost_0_3_choice : boolean;
    variable slice0other_cost_0_4_choice, slice0other_cost_0_5_choice, slice0other_cost_0_6_choice : boolean;
    variable slice0winner1_of_pair_0_0_is_less, slice0winner1_of_pair_0_2_is_less : boolean;
    variable slice0winner1_of_pair_0_4_is_less, slice0winner1_of_pair_0_6_is_less : boolean;
    variable slice0winner1_of_four_0_0_is_less, slice0winner1_of_four_0_4_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice1other_cost_0_1_any, slice1other_cost_0_1_choice : boolean;
    variable slice1other_cost_0_2_choice, slice1other_cost_0_3_choice, slice1other_cost_0_4_choice : boolean;
    variable slice1other_cost_0_5_choice, slice1other_cost_0_6_choice, slice1other_cost_0_7_choice : boolean;
    variable slice1winner1_of_pair_0_0_is_less, slice1winner1_of_pair_0_2_is_less : boolean;
    variable slice1winner1_of_pair_0_4_is_less, slice1winner1_of_pair_0_6_is_less : boolean;
    variable slice1winner1_of_four_0_0_is_less, slice1winner1_of_four_0_4_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, leftright_holds_winners_all : boolean;
    variable raster_place_group_choice, raster_place_group_choice_2 : natural range 0 to 127;
    variable leftright_checked_passed_0_difference : integer range -14 to 16;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_group = 63;
      raster_place_group_is_equal_2 := raster_place_column = 319;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      raster_place_group_is_equal_3 := raster_place_group = 65;
      if raster_place_group_is_equal_3 and raster_place_next_frame then
        raster_place_group_choice := 2;
      else
        raster_place_group_choice := (raster_place_group + 1) mod 128;
      end if;
      if (raster_place_group /= 66) and raster_place_group_is_equal_2 and in_valid then
        raster_place_group_choice_2 := raster_place_group_choice;
      else
        raster_place_group_choice_2 := raster_place_group;
      end if;
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= as_number(raster_place_group_all) * 64;
      else
        raster_place_group <= raster_place_group_choice_2;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice := (raster_place_column /= 319) and raster_place_next_frame;
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group = 66 then
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      end if;
      if in_valid then
        if raster_place_group_is_equal_2 or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
        if raster_place_next_frame_choice_2 then
          raster_place_next_frame <= raster_place_group_all or (not in_start_of_frame);
        else
          raster_place_next_frame <= raster_place_group_is_equal and raster_place_group_is_equal_2 and
            in_start_of_frame;
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
      delay_row_inside_2_is_less := (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2))
        < 64;
      delay_tag_first_cost_is_equal := raster_place_column = 15;
      delay_tag_map_column_is_not_less := raster_place_column >= 15;
      delay_tag_map_column_is_less := raster_place_column < 319;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) < 64;
      delay_row_inside_1 <= (raster_place_group >= 3) and (raster_place_group < 67);
      delay_row_inside_2 <= delay_row_inside_2_is_less;
      delay_row_inside_3 <= (raster_place_group >= 1) and (raster_place_group < 65);
      delay_row_inside_4 <= not ((raster_place_group / 64) = 1);
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= raster_place_column < 15;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_row_inside_2_is_less and delay_tag_map_column_is_not_less and
        delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 2);
      delay_tag_end_of_line <= raster_place_column = 318;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
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
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_map_column <= rows_ready_tag_map_column;
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
        rows_search_1 <= to_integer(rows_search_rows_ready_words_0(15 downto 8));
        rows_reference_1 <= to_integer(rows_reference_rows_ready_words_0(15 downto 8));
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_inside_2 then
        rows_search_2 <= to_integer(rows_search_rows_ready_words_0(23 downto 16));
        rows_reference_2 <= to_integer(rows_reference_rows_ready_words_0(23 downto 16));
      else
        rows_search_2 <= 0;
        rows_reference_2 <= 0;
      end if;
      if rows_ready_inside_3 then
        rows_search_3 <= to_integer(rows_search_rows_ready_words_0(31 downto 24));
        rows_reference_3 <= to_integer(rows_reference_rows_ready_words_0(31 downto 24));
      else
        rows_search_3 <= 0;
        rows_reference_3 <= 0;
      end if;
      if rows_ready_inside_4 then
        rows_search_4 <= rows_search_rows_ready_newest_0;
        rows_reference_4 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_4 <= 0;
        rows_reference_4 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= to_unsigned(rows_search_rows_ready_newest_0, 8) &
          rows_search_rows_ready_words_0(31 downto 8);
        rows_reference_rows_write_words_0 <= to_unsigned(rows_reference_rows_ready_newest_0, 8) &
          rows_reference_rows_ready_words_0(31 downto 8);
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
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= folded(slice0cost_difference_2_0) + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= folded(slice0cost_difference_2_1) + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= folded(slice0cost_difference_2_2) + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_pair_0_3 <= folded(slice0cost_difference_2_3) + folded(slice0cost_difference_1_3) +
        as_number((slice0cost_difference_1_3 < 0));
      slice0cost_pair_0_4 <= folded(slice0cost_difference_2_4) + folded(slice0cost_difference_1_4) +
        as_number((slice0cost_difference_1_4 < 0));
      slice0cost_pair_0_5 <= folded(slice0cost_difference_2_5) + folded(slice0cost_difference_1_5) +
        as_number((slice0cost_difference_1_5 < 0));
      slice0cost_pair_0_6 <= folded(slice0cost_difference_2_6) + folded(slice0cost_difference_1_6) +
        as_number((slice0cost_difference_1_6 < 0));
      slice0cost_pair_0_7 <= folded(slice0cost_difference_2_7) + folded(slice0cost_difference_1_7) +
        as_number((slice0cost_difference_1_7 < 0));
      slice0cost_pair_1_0 <= folded(slice0cost_difference_4_0) + folded(slice0cost_difference_3_0) +
        as_number((slice0cost_difference_3_0 < 0));
      slice0cost_pair_1_1 <= folded(slice0cost_difference_4_1) + folded(slice0cost_difference_3_1) +
        as_number((slice0cost_difference_3_1 < 0));
      slice0cost_pair_1_2 <= folded(slice0cost_difference_4_2) + folded(slice0cost_difference_3_2) +
        as_number((slice0cost_difference_3_2 < 0));
      slice0cost_pair_1_3 <= folded(slice0cost_difference_4_3) + folded(slice0cost_difference_3_3) +
        as_number((slice0cost_difference_3_3 < 0));
      slice0cost_pair_1_4 <= folded(slice0cost_difference_4_4) + folded(slice0cost_difference_3_4) +
        as_number((slice0cost_difference_3_4 < 0));
      slice0cost_pair_1_5 <= folded(slice0cost_difference_4_5) + folded(slice0cost_difference_3_5) +
        as_number((slice0cost_difference_3_5 < 0));
      slice0cost_pair_1_6 <= folded(slice0cost_difference_4_6) + folded(slice0cost_difference_3_6) +
        as_number((slice0cost_difference_3_6 < 0));
      slice0cost_pair_1_7 <= folded(slice0cost_difference_4_7) + folded(slice0cost_difference_3_7) +
        as_number((slice0cost_difference_3_7 < 0));
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_negative_0_3 <= slice0cost_difference_2_3 < 0;
      slice0cost_negative_0_4 <= slice0cost_difference_2_4 < 0;
      slice0cost_negative_0_5 <= slice0cost_difference_2_5 < 0;
      slice0cost_negative_0_6 <= slice0cost_difference_2_6 < 0;
      slice0cost_negative_0_7 <= slice0cost_difference_2_7 < 0;
      slice0cost_negative_1_0 <= slice0cost_difference_4_0 < 0;
      slice0cost_negative_1_1 <= slice0cost_difference_4_1 < 0;
      slice0cost_negative_1_2 <= slice0cost_difference_4_2 < 0;
      slice0cost_negative_1_3 <= slice0cost_difference_4_3 < 0;
      slice0cost_negative_1_4 <= slice0cost_difference_4_4 < 0;
      slice0cost_negative_1_5 <= slice0cost_difference_4_5 < 0;
      slice0cost_negative_1_6 <= slice0cost_difference_4_6 < 0;
      slice0cost_negative_1_7 <= slice0cost_difference_4_7 < 0;
      slice0cost_single_0_0 <= (folded(slice0cost_difference_0_0) + as_number((slice0cost_difference_0_0 < 0))) mod 256;
      slice0cost_single_0_1 <= (folded(slice0cost_difference_0_1) + as_number((slice0cost_difference_0_1 < 0))) mod 256;
      slice0cost_single_0_2 <= (folded(slice0cost_difference_0_2) + as_number((slice0cost_difference_0_2 < 0))) mod 256;
      slice0cost_single_0_3 <= (folded(slice0cost_difference_0_3) + as_number((slice0cost_difference_0_3 < 0))) mod 256;
      slice0cost_single_0_4 <= (folded(slice0cost_difference_0_4) + as_number((slice0cost_difference_0_4 < 0))) mod 256;
      slice0cost_single_0_5 <= (folded(slice0cost_difference_0_5) + as_number((slice0cost_difference_0_5 < 0))) mod 256;
      slice0cost_single_0_6 <= (folded(slice0cost_difference_0_6) + as_number((slice0cost_difference_0_6 < 0))) mod 256;
      slice0cost_single_0_7 <= (folded(slice0cost_difference_0_7) + as_number((slice0cost_difference_0_7 < 0))) mod 256;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_first_cost <= slice0cost_difference_tag_first_cost;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_pair_tag_first_cost;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      if slice0cost_pair_tag_border_column then
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_0_3 <= 0;
        slice0cost_column_0_4 <= 0;
        slice0cost_column_0_5 <= 0;
        slice0cost_column_0_6 <= 0;
        slice0cost_column_0_7 <= 0;
      else
        slice0cost_column_0_0 <= as_number(slice0cost_negative_0_0) + slice0cost_pair_0_0 + slice0cost_single_0_0 +
          slice0cost_pair_1_0 + as_number(slice0cost_negative_1_0);
        slice0cost_column_0_1 <= as_number(slice0cost_negative_0_1) + slice0cost_pair_0_1 + slice0cost_single_0_1 +
          slice0cost_pair_1_1 + as_number(slice0cost_negative_1_1);
        slice0cost_column_0_2 <= as_number(slice0cost_negative_0_2) + slice0cost_pair_0_2 + slice0cost_single_0_2 +
          slice0cost_pair_1_2 + as_number(slice0cost_negative_1_2);
        slice0cost_column_0_3 <= as_number(slice0cost_negative_0_3) + slice0cost_pair_0_3 + slice0cost_single_0_3 +
          slice0cost_pair_1_3 + as_number(slice0cost_negative_1_3);
        slice0cost_column_0_4 <= as_number(slice0cost_negative_0_4) + slice0cost_pair_0_4 + slice0cost_single_0_4 +
          slice0cost_pair_1_4 + as_number(slice0cost_negative_1_4);
        slice0cost_column_0_5 <= as_number(slice0cost_negative_0_5) + slice0cost_pair_0_5 + slice0cost_single_0_5 +
          slice0cost_pair_1_5 + as_number(slice0cost_negative_1_5);
        slice0cost_column_0_6 <= as_number(slice0cost_negative_0_6) + slice0cost_pair_0_6 + slice0cost_single_0_6 +
          slice0cost_pair_1_6 + as_number(slice0cost_negative_1_6);
        slice0cost_column_0_7 <= as_number(slice0cost_negative_0_7) + slice0cost_pair_0_7 + slice0cost_single_0_7 +
          slice0cost_pair_1_7 + as_number(slice0cost_negative_1_7);
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
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_output_column_1 <= slice0window_centre_output_column_0;
        slice0window_centre_first_column_0 <= slice0cost_tag_first_cost;
        slice0window_centre_first_column_1 <= slice0window_centre_first_column_0;
      end if;
      slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
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
        slice0window_tag_map_column <= slice1window_centre_map_column_0;
        slice0window_tag_start_of_frame <= slice1window_centre_start_of_frame_0;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_0;
      end if;
      -- slice0other
      slice0other_cost_0_0_all := slice0window_tag_output_column and (((slice0other_cost_0_1 - slice0window_sum_0_0) >=
        0) or slice0window_tag_first_column);
      slice0other_cost_0_1_all := slice0window_tag_output_column and slice0window_tag_first_column;
      if (slice0other_cost_0_2 - slice0window_sum_0_1) >= 0 then
        slice0other_cost_0_1_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_1_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_0_3 - slice0window_sum_0_2) >= 0 then
        slice0other_cost_0_2_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_2_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_0_4 - slice0window_sum_0_3) >= 0 then
        slice0other_cost_0_3_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_3_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_0_5 - slice0window_sum_0_4) >= 0 then
        slice0other_cost_0_4_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_4_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_0_6 - slice0window_sum_0_5) >= 0 then
        slice0other_cost_0_5_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_5_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_0_7 - slice0window_sum_0_6) >= 0 then
        slice0other_cost_0_6_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_6_choice := slice0other_cost_0_1_all;
      end if;
      if slice0window_tag_valid then
        if slice0other_cost_0_0_all then
          slice0other_cost_0_0 <= slice0window_sum_0_0;
          slice0other_winner_0_0 <= 8;
        else
          slice0other_cost_0_0 <= slice0other_cost_0_1;
          slice0other_winner_0_0 <= slice0other_winner_0_1;
        end if;
        if slice0other_cost_0_1_choice then
          slice0other_cost_0_1 <= slice0window_sum_0_1;
          slice0other_winner_0_1 <= 9;
        else
          slice0other_cost_0_1 <= slice0other_cost_0_2;
          slice0other_winner_0_1 <= slice0other_winner_0_2;
        end if;
        if slice0other_cost_0_2_choice then
          slice0other_cost_0_2 <= slice0window_sum_0_2;
          slice0other_winner_0_2 <= 10;
        else
          slice0other_cost_0_2 <= slice0other_cost_0_3;
          slice0other_winner_0_2 <= slice0other_winner_0_3;
        end if;
        if slice0other_cost_0_3_choice then
          slice0other_cost_0_3 <= slice0window_sum_0_3;
          slice0other_winner_0_3 <= 11;
        else
          slice0other_cost_0_3 <= slice0other_cost_0_4;
          slice0other_winner_0_3 <= slice0other_winner_0_4;
        end if;
        if slice0other_cost_0_4_choice then
          slice0other_cost_0_4 <= slice0window_sum_0_4;
          slice0other_winner_0_4 <= 12;
        else
          slice0other_cost_0_4 <= slice0other_cost_0_5;
          slice0other_winner_0_4 <= slice0other_winner_0_5;
        end if;
        if slice0other_cost_0_5_choice then
          slice0other_cost_0_5 <= slice0window_sum_0_5;
          slice0other_winner_0_5 <= 13;
        else
          slice0other_cost_0_5 <= slice0other_cost_0_6;
          slice0other_winner_0_5 <= slice0other_winner_0_6;
        end if;
        if slice0other_cost_0_6_choice then
          slice0other_cost_0_6 <= slice0window_sum_0_6;
          slice0other_winner_0_6 <= 14;
        else
          slice0other_cost_0_6 <= slice0other_cost_0_7;
          slice0other_winner_0_6 <= slice0other_winner_0_7;
        end if;
        if slice0window_tag_output_column then
          slice0other_cost_0_7 <= slice0window_sum_0_7;
          slice0other_winner_0_7 <= 15;
        else
          slice0other_cost_0_7 <= 0;
          slice0other_winner_0_7 <= 0;
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0_0;
      slice0other_winner_out_0 <= slice0other_winner_0_0;
      -- slice0winner1
      slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_of_pair_0_2_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_of_pair_0_4_is_less := (slice0window_sum_0_5 - slice0window_sum_0_4) < 0;
      slice0winner1_of_pair_0_6_is_less := (slice0window_sum_0_7 - slice0window_sum_0_6) < 0;
      slice0winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0_2, 13)) or
        (to_unsigned(slice0winner1_of_pair_0_3, 13)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0_0, 13)) or
        (to_unsigned(slice0winner1_of_pair_0_1, 13))))) < 0;
      slice0winner1_of_four_0_4_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0_6, 13)) or
        (to_unsigned(slice0winner1_of_pair_0_7, 13)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0_4, 13)) or
        (to_unsigned(slice0winner1_of_pair_0_5, 13))))) < 0;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_pair_tag_map_column <= slice0window_tag_map_column;
      slice0winner1_pair_tag_output_column <= slice1window_centre_output_column_1;
      slice0winner1_pair_tag_first_column <= slice1window_centre_first_column_1;
      slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_map_column <= slice0winner1_pair_tag_map_column;
      slice0winner1_four_tag_output_column <= slice0winner1_pair_tag_output_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(slice0winner1_of_four_0_2, 13)) or
        (to_unsigned(slice0winner1_of_four_0_3, 13)))) or (to_unsigned(slice0winner1_of_four_0_1, 13)))) or
        (to_unsigned(slice0winner1_of_four_0_0, 13))));
      slice0winner1_best_cost_0_1 <= to_integer(((((((to_unsigned(slice0winner1_of_four_0_6, 13)) or
        (to_unsigned(slice0winner1_of_four_0_7, 13)))) or (to_unsigned(slice0winner1_of_four_0_5, 13)))) or
        (to_unsigned(slice0winner1_of_four_0_4, 13))));
      slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
      slice0winner1_best_index_0_1 <= slice0winner1_four_index_0_1;
      slice0winner1_tag_valid <= slice0winner1_four_tag_valid;
      slice0winner1_tag_map_column <= slice0winner1_four_tag_map_column;
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
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
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
      slice0_best_tag_map_column <= slice0winner2_tag_map_column;
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
      slice1cost_pair_0_0 <= folded(slice1cost_difference_2_0) + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= folded(slice1cost_difference_2_1) + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= folded(slice1cost_difference_2_2) + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_pair_0_3 <= folded(slice1cost_difference_2_3) + folded(slice1cost_difference_1_3) +
        as_number((slice1cost_difference_1_3 < 0));
      slice1cost_pair_0_4 <= folded(slice1cost_difference_2_4) + folded(slice1cost_difference_1_4) +
        as_number((slice1cost_difference_1_4 < 0));
      slice1cost_pair_0_5 <= folded(slice1cost_difference_2_5) + folded(slice1cost_difference_1_5) +
        as_number((slice1cost_difference_1_5 < 0));
      slice1cost_pair_0_6 <= folded(slice1cost_difference_2_6) + folded(slice1cost_difference_1_6) +
        as_number((slice1cost_difference_1_6 < 0));
      slice1cost_pair_0_7 <= folded(slice1cost_difference_2_7) + folded(slice1cost_difference_1_7) +
        as_number((slice1cost_difference_1_7 < 0));
      slice1cost_pair_1_0 <= folded(slice1cost_difference_4_0) + folded(slice1cost_difference_3_0) +
        as_number((slice1cost_difference_3_0 < 0));
      slice1cost_pair_1_1 <= folded(slice1cost_difference_4_1) + folded(slice1cost_difference_3_1) +
        as_number((slice1cost_difference_3_1 < 0));
      slice1cost_pair_1_2 <= folded(slice1cost_difference_4_2) + folded(slice1cost_difference_3_2) +
        as_number((slice1cost_difference_3_2 < 0));
      slice1cost_pair_1_3 <= folded(slice1cost_difference_4_3) + folded(slice1cost_difference_3_3) +
        as_number((slice1cost_difference_3_3 < 0));
      slice1cost_pair_1_4 <= folded(slice1cost_difference_4_4) + folded(slice1cost_difference_3_4) +
        as_number((slice1cost_difference_3_4 < 0));
      slice1cost_pair_1_5 <= folded(slice1cost_difference_4_5) + folded(slice1cost_difference_3_5) +
        as_number((slice1cost_difference_3_5 < 0));
      slice1cost_pair_1_6 <= folded(slice1cost_difference_4_6) + folded(slice1cost_difference_3_6) +
        as_number((slice1cost_difference_3_6 < 0));
      slice1cost_pair_1_7 <= folded(slice1cost_difference_4_7) + folded(slice1cost_difference_3_7) +
        as_number((slice1cost_difference_3_7 < 0));
      slice1cost_negative_0_0 <= slice1cost_difference_2_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_2_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_2_2 < 0;
      slice1cost_negative_0_3 <= slice1cost_difference_2_3 < 0;
      slice1cost_negative_0_4 <= slice1cost_difference_2_4 < 0;
      slice1cost_negative_0_5 <= slice1cost_difference_2_5 < 0;
      slice1cost_negative_0_6 <= slice1cost_difference_2_6 < 0;
      slice1cost_negative_0_7 <= slice1cost_difference_2_7 < 0;
      slice1cost_negative_1_0 <= slice1cost_difference_4_0 < 0;
      slice1cost_negative_1_1 <= slice1cost_difference_4_1 < 0;
      slice1cost_negative_1_2 <= slice1cost_difference_4_2 < 0;
      slice1cost_negative_1_3 <= slice1cost_difference_4_3 < 0;
      slice1cost_negative_1_4 <= slice1cost_difference_4_4 < 0;
      slice1cost_negative_1_5 <= slice1cost_difference_4_5 < 0;
      slice1cost_negative_1_6 <= slice1cost_difference_4_6 < 0;
      slice1cost_negative_1_7 <= slice1cost_difference_4_7 < 0;
      slice1cost_single_0_0 <= (folded(slice1cost_difference_0_0) + as_number((slice1cost_difference_0_0 < 0))) mod 256;
      slice1cost_single_0_1 <= (folded(slice1cost_difference_0_1) + as_number((slice1cost_difference_0_1 < 0))) mod 256;
      slice1cost_single_0_2 <= (folded(slice1cost_difference_0_2) + as_number((slice1cost_difference_0_2 < 0))) mod 256;
      slice1cost_single_0_3 <= (folded(slice1cost_difference_0_3) + as_number((slice1cost_difference_0_3 < 0))) mod 256;
      slice1cost_single_0_4 <= (folded(slice1cost_difference_0_4) + as_number((slice1cost_difference_0_4 < 0))) mod 256;
      slice1cost_single_0_5 <= (folded(slice1cost_difference_0_5) + as_number((slice1cost_difference_0_5 < 0))) mod 256;
      slice1cost_single_0_6 <= (folded(slice1cost_difference_0_6) + as_number((slice1cost_difference_0_6 < 0))) mod 256;
      slice1cost_single_0_7 <= (folded(slice1cost_difference_0_7) + as_number((slice1cost_difference_0_7 < 0))) mod 256;
      slice1cost_tag_first_cost <= slice0cost_tag_first_cost;
      slice1cost_tag_output_column <= slice0cost_tag_output_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_0_3 <= 0;
        slice1cost_column_0_4 <= 0;
        slice1cost_column_0_5 <= 0;
        slice1cost_column_0_6 <= 0;
        slice1cost_column_0_7 <= 0;
      else
        slice1cost_column_0_0 <= as_number(slice1cost_negative_0_0) + slice1cost_pair_0_0 + slice1cost_single_0_0 +
          slice1cost_pair_1_0 + as_number(slice1cost_negative_1_0);
        slice1cost_column_0_1 <= as_number(slice1cost_negative_0_1) + slice1cost_pair_0_1 + slice1cost_single_0_1 +
          slice1cost_pair_1_1 + as_number(slice1cost_negative_1_1);
        slice1cost_column_0_2 <= as_number(slice1cost_negative_0_2) + slice1cost_pair_0_2 + slice1cost_single_0_2 +
          slice1cost_pair_1_2 + as_number(slice1cost_negative_1_2);
        slice1cost_column_0_3 <= as_number(slice1cost_negative_0_3) + slice1cost_pair_0_3 + slice1cost_single_0_3 +
          slice1cost_pair_1_3 + as_number(slice1cost_negative_1_3);
        slice1cost_column_0_4 <= as_number(slice1cost_negative_0_4) + slice1cost_pair_0_4 + slice1cost_single_0_4 +
          slice1cost_pair_1_4 + as_number(slice1cost_negative_1_4);
        slice1cost_column_0_5 <= as_number(slice1cost_negative_0_5) + slice1cost_pair_0_5 + slice1cost_single_0_5 +
          slice1cost_pair_1_5 + as_number(slice1cost_negative_1_5);
        slice1cost_column_0_6 <= as_number(slice1cost_negative_0_6) + slice1cost_pair_0_6 + slice1cost_single_0_6 +
          slice1cost_pair_1_6 + as_number(slice1cost_negative_1_6);
        slice1cost_column_0_7 <= as_number(slice1cost_negative_0_7) + slice1cost_pair_0_7 + slice1cost_single_0_7 +
          slice1cost_pair_1_7 + as_number(slice1cost_negative_1_7);
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
        slice1window_centre_output_column_0 <= slice1cost_tag_output_column;
        slice1window_centre_output_column_1 <= slice1window_centre_output_column_0;
        slice1window_centre_first_column_0 <= slice1cost_tag_first_cost;
        slice1window_centre_first_column_1 <= slice1window_centre_first_column_0;
        slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
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
      slice1other_cost_0_1_any := (not slice0winner1_pair_tag_output_column) or (not
        slice0winner1_pair_tag_first_column);
      if (slice1other_cost_0_2 - slice1window_sum_0_1) >= 0 then
        slice1other_cost_0_1_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_1_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_0_3 - slice1window_sum_0_2) >= 0 then
        slice1other_cost_0_2_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_2_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_0_4 - slice1window_sum_0_3) >= 0 then
        slice1other_cost_0_3_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_3_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_0_5 - slice1window_sum_0_4) >= 0 then
        slice1other_cost_0_4_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_4_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_0_6 - slice1window_sum_0_5) >= 0 then
        slice1other_cost_0_5_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_5_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_0_7 - slice1window_sum_0_6) >= 0 then
        slice1other_cost_0_6_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_6_choice := slice1other_cost_0_1_any;
      end if;
      if (slice0other_cost_out_0 - slice1window_sum_0_7) >= 0 then
        slice1other_cost_0_7_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_7_choice := slice1other_cost_0_1_any;
      end if;
      if slice0winner1_pair_tag_valid then
        if slice1other_cost_0_1_choice then
          slice1other_cost_0_1 <= slice1other_cost_0_2;
          slice1other_winner_0_1 <= slice1other_winner_0_2;
        else
          slice1other_cost_0_1 <= slice1window_sum_0_1;
          slice1other_winner_0_1 <= 1;
        end if;
        if slice1other_cost_0_2_choice then
          slice1other_cost_0_2 <= slice1other_cost_0_3;
          slice1other_winner_0_2 <= slice1other_winner_0_3;
        else
          slice1other_cost_0_2 <= slice1window_sum_0_2;
          slice1other_winner_0_2 <= 2;
        end if;
        if slice1other_cost_0_3_choice then
          slice1other_cost_0_3 <= slice1other_cost_0_4;
          slice1other_winner_0_3 <= slice1other_winner_0_4;
        else
          slice1other_cost_0_3 <= slice1window_sum_0_3;
          slice1other_winner_0_3 <= 3;
        end if;
        if slice1other_cost_0_4_choice then
          slice1other_cost_0_4 <= slice1other_cost_0_5;
          slice1other_winner_0_4 <= slice1other_winner_0_5;
        else
          slice1other_cost_0_4 <= slice1window_sum_0_4;
          slice1other_winner_0_4 <= 4;
        end if;
        if slice1other_cost_0_5_choice then
          slice1other_cost_0_5 <= slice1other_cost_0_6;
          slice1other_winner_0_5 <= slice1other_winner_0_6;
        else
          slice1other_cost_0_5 <= slice1window_sum_0_5;
          slice1other_winner_0_5 <= 5;
        end if;
        if slice1other_cost_0_6_choice then
          slice1other_cost_0_6 <= slice1other_cost_0_7;
          slice1other_winner_0_6 <= slice1other_winner_0_7;
        else
          slice1other_cost_0_6 <= slice1window_sum_0_6;
          slice1other_winner_0_6 <= 6;
        end if;
        if slice1other_cost_0_7_choice then
          slice1other_cost_0_7 <= slice0other_cost_out_0;
          slice1other_winner_0_7 <= slice0other_winner_out_0;
        else
          slice1other_cost_0_7 <= slice1window_sum_0_7;
          slice1other_winner_0_7 <= 7;
        end if;
        if (not slice0winner1_pair_tag_output_column) or ((not slice0winner1_pair_tag_first_column) and
          ((slice1other_cost_0_1 - slice1window_sum_0_0) < 0)) then
          slice1other_winner_0_0 <= slice1other_winner_0_1;
        else
          slice1other_winner_0_0 <= 0;
        end if;
      end if;
      slice1other_winner_out_0 <= slice1other_winner_0_0;
      -- slice1winner1
      slice1winner1_of_pair_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_of_pair_0_2_is_less := (slice1window_sum_0_3 - slice1window_sum_0_2) < 0;
      slice1winner1_of_pair_0_4_is_less := (slice1window_sum_0_5 - slice1window_sum_0_4) < 0;
      slice1winner1_of_pair_0_6_is_less := (slice1window_sum_0_7 - slice1window_sum_0_6) < 0;
      slice1winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice1winner1_of_pair_0_2, 13)) or
        (to_unsigned(slice1winner1_of_pair_0_3, 13)))) - to_integer(((to_unsigned(slice1winner1_of_pair_0_0, 13)) or
        (to_unsigned(slice1winner1_of_pair_0_1, 13))))) < 0;
      slice1winner1_of_four_0_4_is_less := (to_integer(((to_unsigned(slice1winner1_of_pair_0_6, 13)) or
        (to_unsigned(slice1winner1_of_pair_0_7, 13)))) - to_integer(((to_unsigned(slice1winner1_of_pair_0_4, 13)) or
        (to_unsigned(slice1winner1_of_pair_0_5, 13))))) < 0;
      slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_is_less;
      slice1winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(slice1winner1_of_four_0_2, 13)) or
        (to_unsigned(slice1winner1_of_four_0_3, 13)))) or (to_unsigned(slice1winner1_of_four_0_1, 13)))) or
        (to_unsigned(slice1winner1_of_four_0_0, 13))));
      slice1winner1_best_cost_0_1 <= to_integer(((((((to_unsigned(slice1winner1_of_four_0_6, 13)) or
        (to_unsigned(slice1winner1_of_four_0_7, 13)))) or (to_unsigned(slice1winner1_of_four_0_5, 13)))) or
        (to_unsigned(slice1winner1_of_four_0_4, 13))));
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
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice0_best_cost_0_0 - slice1winner2_best_cost_0_0) < 0 then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_index_0_0 <= slice1winner2_best_index_0_0;
      end if;
      -- leftright
      leftright_holds_winners_all := (leftright_ring_read_address /= 0) and (not leftright_holds_winners);
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_other_1_0 <= slice1other_winner_out_0;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_position <= (leftright_position + as_number(slice1_best_tag_valid)) mod 32;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and slice1_best_tag_valid;
      leftright_address_0 <= (to_integer(leftright_held_0(12 downto 4)) + leftright_held_position + 17) mod 32;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(7 downto 4));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_output_column <= to_integer(leftright_held_0(1 downto 1)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_output_column <= leftright_asking_tag_output_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_output_column <= leftright_answered_tag_output_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_all then
        leftright_holds_winners <= leftright_holds_winners and (not slice1_best_tag_valid);
      else
        leftright_holds_winners <= leftright_holds_winners or slice1_best_tag_valid;
      end if;
      if slice1_best_tag_valid then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 15 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 16;
        end if;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 66;
        raster_place_next_frame <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_output_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
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
        slice1cost_tag_output_column <= false;
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_output_column_1 <= false;
        slice1window_centre_start_of_frame_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_valid <= false;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_output_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_output_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_output_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
