-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_lr_p2: 32x12, 8 disparities, window 3x3, 2 pixel pairs a clock.
-- Options: disparities 8, left_right_threshold 0, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_lr_p2
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_lr_p2 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 2;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 20;
    flush_groups : positive := 39;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(15 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(15 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(1 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 32 report "stereo_core_tiny_lr_p2: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_lr_p2: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny_lr_p2: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 2 report "stereo_core_tiny_lr_p2: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 2" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_lr_p2: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny_lr_p2: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 20 report "stereo_core_tiny_lr_p2: latency_clocks is " & integer'image(latency_clocks) & " but this core has 20" severity failure;
  assert flush_groups = 39 report "stereo_core_tiny_lr_p2: flush_groups is " & integer'image(flush_groups) & " but this core has 39" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_lr_p2: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_lr_p2 is
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
  signal in_left_pixel : natural range 0 to 65535;
  signal in_right_pixel : natural range 0 to 65535;
  -- raster
  signal raster_features_search_0, raster_features_search_1 : natural range 0 to 255;
  signal raster_features_reference : natural range 0 to 65535;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 7;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 7;
  signal delay_ahead_0, delay_ahead_1 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(15 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_3, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_map_column, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_read_newest_1 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_0, rows_search_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_read_newest_1 : natural range 0 to 255;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_ready_newest_1, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_search_3, rows_reference_0, rows_reference_1 : natural range 0 to 255;
  signal rows_reference_2, rows_reference_3 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_3, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_3, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_map_column : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 255;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 255;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 255;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 255;
  signal slice0shift_reference_3, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 255;
  signal slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -255 to 255;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -255 to 255;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -255 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_first_cost, slice0cost_difference_tag_map_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column : boolean;
  signal slice0cost_pair_tag_first_cost, slice0cost_pair_tag_map_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_first_cost, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 511;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_single_3_0, slice0cost_single_3_1, slice0cost_single_3_2 : natural range 0 to 255;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  signal slice0cost_column_1_0, slice0cost_column_1_1, slice0cost_column_1_2 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_1_0_0, slice0window_partial_1_0_1, slice0window_partial_1_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_partial_1_1_0, slice0window_partial_1_1_1, slice0window_partial_1_1_2 : natural range 0 to 1534;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 2301;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 2301;
  signal slice0other_cost_1_0, slice0other_cost_1_1, slice0other_cost_1_2 : natural range 0 to 2301;
  signal slice0other_cost_out_0, slice0other_cost_out_1 : natural range 0 to 2301;
  signal slice0other_winner_0_0, slice0other_winner_0_1, slice0other_winner_0_2 : natural range 0 to 7;
  signal slice0other_winner_1_0, slice0other_winner_1_1, slice0other_winner_out_0 : natural range 0 to 7;
  signal slice0other_winner_out_1 : natural range 0 to 7;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 2301;
  signal slice0winner1_of_pair_1_0, slice0winner1_of_pair_1_1, slice0winner1_of_pair_1_2 : natural range 0 to 2301;
  signal slice0winner1_of_four_0_0, slice0winner1_of_four_0_1, slice0winner1_of_four_0_2 : natural range 0 to 2301;
  signal slice0winner1_of_four_1_0, slice0winner1_of_four_1_1, slice0winner1_of_four_1_2 : natural range 0 to 2301;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_index_1_0, slice0winner1_pair_tag_valid : boolean;
  signal slice0winner1_pair_tag_map_column, slice0winner1_pair_tag_output_column : boolean;
  signal slice0winner1_pair_tag_first_column, slice0winner1_pair_tag_start_of_frame : boolean;
  signal slice0winner1_pair_tag_end_of_line, slice0winner1_four_tag_valid, slice0winner1_four_tag_map_column : boolean;
  signal slice0winner1_four_tag_output_column, slice0winner1_four_tag_first_column : boolean;
  signal slice0winner1_four_tag_start_of_frame, slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_map_column, slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 2;
  signal slice0winner1_four_index_1_0, slice0winner1_best_index_0_0 : natural range 0 to 2;
  signal slice0winner1_best_index_1_0 : natural range 0 to 2;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_1_0 : natural range 0 to 4095;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_cost_1_0 : natural range 0 to 4095;
  signal slice0_best_index_0_0, slice0_best_index_1_0 : natural range 0 to 7;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_output_column : boolean;
  signal slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 255;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 255;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 255;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 255;
  signal slice1shift_reference_3, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 255;
  signal slice1shift_search_out_2, slice1shift_search_out_3 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -255 to 255;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -255 to 255;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -255 to 255;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -255 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2 : boolean;
  signal slice1cost_tag_border_column, slice1cost_tag_first_cost, slice1cost_tag_output_column : boolean;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_single_3_0, slice1cost_single_3_1, slice1cost_single_3_2 : natural range 0 to 255;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 767;
  signal slice1cost_column_1_0, slice1cost_column_1_1, slice1cost_column_1_2 : natural range 0 to 767;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 767;
  signal slice1window_partial_1_0_0, slice1window_partial_1_0_1, slice1window_partial_1_0_2 : natural range 0 to 767;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 1534;
  signal slice1window_partial_1_1_0, slice1window_partial_1_1_1, slice1window_partial_1_1_2 : natural range 0 to 1534;
  signal slice1window_centre_output_column_0, slice1window_centre_first_column_0 : boolean;
  signal slice1window_tag_output_column, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2301;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 2301;
  -- slice1other
  signal slice1other_cost_0_0, slice1other_cost_0_1, slice1other_cost_0_2 : natural range 0 to 2301;
  signal slice1other_cost_1_0, slice1other_cost_1_1, slice1other_cost_1_2 : natural range 0 to 2301;
  signal slice1other_cost_out_0, slice1other_cost_out_1 : natural range 0 to 2301;
  signal slice1other_winner_0_0, slice1other_winner_0_1, slice1other_winner_0_2 : natural range 0 to 7;
  signal slice1other_winner_1_0, slice1other_winner_1_1, slice1other_winner_1_2 : natural range 0 to 7;
  signal slice1other_winner_out_0, slice1other_winner_out_1 : natural range 0 to 7;
  -- slice1winner1
  signal slice1winner1_of_pair_0_0, slice1winner1_of_pair_0_1, slice1winner1_of_pair_0_2 : natural range 0 to 2301;
  signal slice1winner1_of_pair_1_0, slice1winner1_of_pair_1_1, slice1winner1_of_pair_1_2 : natural range 0 to 2301;
  signal slice1winner1_of_four_0_0, slice1winner1_of_four_0_1, slice1winner1_of_four_0_2 : natural range 0 to 2301;
  signal slice1winner1_of_four_1_0, slice1winner1_of_four_1_1, slice1winner1_of_four_1_2 : natural range 0 to 2301;
  signal slice1winner1_pair_index_0_0, slice1winner1_pair_index_1_0 : boolean;
  signal slice1winner1_four_index_0_0, slice1winner1_four_index_1_0 : natural range 0 to 2;
  signal slice1winner1_best_index_0_0, slice1winner1_best_index_1_0 : natural range 0 to 2;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_1_0 : natural range 0 to 4095;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_cost_1_0 : natural range 0 to 4095;
  signal slice1_best_index_0_0, slice1_best_index_1_0 : natural range 0 to 7;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_output_column : boolean;
  signal slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 255;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 255;
  signal slice2shift_search_3_0, slice2shift_search_3_1, slice2shift_reference_0 : natural range 0 to 255;
  signal slice2shift_reference_1, slice2shift_reference_2, slice2shift_reference_3 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -255 to 255;
  signal slice2cost_difference_1_1, slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -255 to 255;
  signal slice2cost_difference_3_0, slice2cost_difference_3_1 : integer range -255 to 255;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 511;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1, slice2cost_tag_first_cost : boolean;
  signal slice2cost_tag_output_column : boolean;
  signal slice2cost_single_0_0, slice2cost_single_0_1, slice2cost_single_3_0 : natural range 0 to 255;
  signal slice2cost_single_3_1 : natural range 0 to 255;
  signal slice2cost_column_0_0, slice2cost_column_0_1, slice2cost_column_1_0 : natural range 0 to 767;
  signal slice2cost_column_1_1 : natural range 0 to 767;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1, slice2window_partial_1_0_0 : natural range 0 to 767;
  signal slice2window_partial_1_0_1 : natural range 0 to 767;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_partial_1_1_0 : natural range 0 to 1534;
  signal slice2window_partial_1_1_1 : natural range 0 to 1534;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_1_0 : natural range 0 to 2301;
  signal slice2window_sum_1_1 : natural range 0 to 2301;
  -- slice2other
  signal slice2other_cost_0_1, slice2other_cost_1_1 : natural range 0 to 2301;
  signal slice2other_winner_0_0, slice2other_winner_0_1, slice2other_winner_1_0 : natural range 0 to 7;
  signal slice2other_winner_1_1, slice2other_winner_out_0, slice2other_winner_out_1 : natural range 0 to 7;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0, slice2winner1_best_cost_1_0 : natural range 0 to 2301;
  signal slice2winner1_best_index_0_0, slice2winner1_best_index_1_0 : boolean;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_1_0 : natural range 0 to 2301;
  signal slice2winner2_best_index_0_0, slice2winner2_best_index_1_0 : boolean;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0, slice2winner3_best_cost_1_0 : natural range 0 to 2301;
  signal slice2winner3_best_index_0_0, slice2winner3_best_index_1_0 : boolean;
  -- slice2
  signal slice2_best_index_0_0, slice2_best_index_1_0 : natural range 0 to 7;
  signal slice2_best_tag_valid, slice2_best_tag_map_column, slice2_best_tag_output_column : boolean;
  signal slice2_best_tag_start_of_frame, slice2_best_tag_end_of_line : boolean;
  -- leftright
  signal leftright_other_1_0, leftright_other_1_1, leftright_other_2_0, leftright_other_2_1 : natural range 0 to 7;
  signal leftright_ring_read_address, leftright_ring_write_address : natural range 0 to 7;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_passed_1 : boolean;
  signal leftright_asking_tag_valid, leftright_asking_tag_output_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_passed_1 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_output_column : boolean;
  signal leftright_answered_tag_start_of_frame, leftright_answered_tag_end_of_line : boolean;
  signal leftright_checked_passed_0, leftright_checked_passed_1, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_output_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0, leftright_address_1 : natural range 0 to 15;
  signal leftright_asking_disparity_0, leftright_asking_disparity_1 : natural range 0 to 15;
  signal leftright_answered_disparity_0, leftright_answered_disparity_1 : natural range 0 to 15;
  signal leftright_checked_disparity_0, leftright_checked_disparity_1 : natural range 0 to 15;
  signal leftright_held_0 : unsigned(21 downto 0);
  signal leftright_found_0, leftright_found_1 : unsigned(2 downto 0);
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
  signal leftright_held_0_memory_write_data : unsigned(21 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(15 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(leftright_checked_disparity_1, 8) & to_unsigned(leftright_checked_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(leftright_checked_passed_1), 1) & to_unsigned(as_number(leftright_checked_passed_0), 1));
  disparity_valid <= as_bit(leftright_checked_tag_valid and leftright_checked_tag_output_column);
  disparity_start_of_frame <= as_bit(leftright_checked_tag_start_of_frame and leftright_checked_tag_valid and leftright_checked_tag_output_column);
  disparity_end_of_line <= as_bit(leftright_checked_tag_end_of_line and leftright_checked_tag_valid and leftright_checked_tag_output_column);

  leftright_found_1_memory_read_enable <= true;
  leftright_found_1_memory_read_address <= to_unsigned(leftright_address_1, 4);
  leftright_found_1_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_1_memory_write_data <= to_unsigned(leftright_other_2_1, 3);
  leftright_found_1_memory : entity work.line_memory
    generic map (depth => 16, width => 3, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_1_memory_read_enable,
      read_address => leftright_found_1_memory_read_address, read_data => leftright_found_1,
      write_address => leftright_found_1_memory_write_address, write_data => leftright_found_1_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 4);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_2_0, 3);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 3, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 3);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 3);
  leftright_held_0_memory_write_data <= to_unsigned(1, 1) & to_unsigned(slice2_best_index_1_0, 8) & to_unsigned(1, 1) & to_unsigned(slice2_best_index_0_0, 8) & to_unsigned(as_number(slice2_best_tag_end_of_line), 1) & to_unsigned(as_number(slice2_best_tag_start_of_frame), 1) & to_unsigned(as_number(slice2_best_tag_output_column), 1) & to_unsigned(as_number(slice2_best_tag_map_column), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference, 16);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 16, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable raster_place_next_frame_choice_3, raster_place_next_frame_choice_4, delay_row_inside_0_value : boolean;
    variable delay_row_inside_0_any, delay_row_inside_1_any, delay_row_inside_1_choice : boolean;
    variable delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less : boolean;
    variable slice0other_cost_0_0_all, slice0other_cost_0_1_all, slice0other_cost_0_1_choice : boolean;
    variable slice0other_cost_1_0_choice, slice0other_cost_1_1_choice, slice0winner1_of_pair_0_0_is_less : boolean;
    variable slice0winner1_of_pair_1_0_is_less, slice0winner1_of_four_0_0_is_less : boolean;
    variable slice0winner1_of_four_1_0_is_less, slice1other_cost_0_0_any, slice1other_cost_0_1_any : boolean;
    variable slice1other_cost_0_1_choice, slice1other_cost_0_2_choice, slice1other_cost_1_0_choice : boolean;
    variable slice1other_cost_1_1_choice, slice1other_cost_1_2_choice, slice1winner1_of_pair_0_0_is_less : boolean;
    variable slice1winner1_of_pair_1_0_is_less, slice1winner1_of_four_0_0_is_less : boolean;
    variable slice1winner1_of_four_1_0_is_less, slice1_best_cost_0_0_is_less, slice1_best_cost_1_0_is_less : boolean;
    variable slice2other_cost_0_1_any, slice2other_cost_0_1_choice, slice2other_cost_1_1_choice : boolean;
    variable slice2other_winner_1_0_choice, slice2winner1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_1_0_is_less, leftright_holds_winners_all : boolean;
    variable leftright_checked_passed_0_choice, leftright_checked_passed_0_choice_2 : boolean;
    variable leftright_checked_passed_0_choice_3, leftright_checked_passed_0_choice_4 : boolean;
    variable leftright_checked_passed_1_choice, leftright_checked_passed_1_choice_2 : boolean;
    variable leftright_checked_passed_1_choice_3, leftright_checked_passed_1_choice_4 : boolean;
    variable raster_place_group_choice : natural range 0 to 3;
    variable raster_place_group_choice_2, raster_place_group_choice_3 : natural range 0 to 7;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_is_equal_2 := raster_place_group = 5;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      if raster_place_next_frame and (raster_place_group = 6) then
        raster_place_group_choice_2 := 1;
      else
        raster_place_group_choice_2 := (raster_place_group + 1) mod 8;
      end if;
      if raster_place_group_is_equal and (raster_place_group /= 7) and in_valid then
        raster_place_group_choice_3 := raster_place_group_choice_2;
      else
        raster_place_group_choice_3 := raster_place_group;
      end if;
      if (raster_place_group / 2) = 3 then
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
        raster_place_next_frame_choice_3 := in_valid;
      else
        raster_place_next_frame_choice_3 := in_valid and (not in_start_of_frame);
      end if;
      if raster_place_next_frame_choice_2 then
        raster_place_next_frame_choice_4 := raster_place_next_frame_choice_3;
      else
        raster_place_next_frame_choice_4 := raster_place_group_is_equal and raster_place_group_is_equal_2 and in_valid
          and in_start_of_frame;
      end if;
      raster_features_search_0 <= in_left_pixel mod 256;
      raster_features_search_1 <= in_left_pixel / 256;
      raster_features_reference <= in_right_pixel;
      raster_features_valid <= in_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_4 or ((not in_valid) and raster_place_next_frame);
      if in_valid and in_start_of_frame then
        raster_place_group <= raster_place_group_choice * 2;
      else
        raster_place_group <= raster_place_group_choice_3;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 7 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 8;
        end if;
      end if;
      delay_row_inside_0_value := ((raster_place_group / 2) mod 2) = 1;
      delay_row_inside_0_any := ((raster_place_group / 4) = 1) or delay_row_inside_0_value;
      delay_row_inside_1_any := (not ((raster_place_group / 4) = 1)) or (not delay_row_inside_0_value);
      if (raster_place_group mod 2) = 1 then
        delay_row_inside_1_choice := delay_row_inside_1_any;
      else
        delay_row_inside_1_choice := delay_row_inside_0_any;
      end if;
      delay_tag_first_cost_is_equal := raster_place_column = 7;
      delay_tag_map_column_is_not_less := raster_place_column >= 7;
      delay_tag_map_column_is_less := raster_place_column < 31;
      delay_ahead_0 <= raster_features_search_0;
      delay_ahead_1 <= raster_features_search_1;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= delay_row_inside_0_any;
      delay_row_inside_1 <= delay_row_inside_1_choice;
      delay_row_inside_3 <= delay_row_inside_1_any;
      delay_tag_valid <= raster_features_valid;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
        delay_row_inside_1_choice;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      if (raster_place_column mod 4) = 3 then
        delay_tag_border_column <= (raster_place_column / 4) = 0;
      else
        delay_tag_border_column <= (raster_place_column / 8) = 0;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_read_newest_1 <= delay_ahead_1;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0(7 downto 0));
      rows_reference_rows_read_newest_1 <= to_integer(delay_delayed_0(15 downto 8));
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_3 <= delay_row_inside_3;
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
      rows_ready_inside_3 <= rows_read_inside_3;
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
        rows_search_0 <= rows_search_rows_ready_words_0 mod 256;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 256;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= (rows_search_rows_ready_words_0 / 256) mod 256;
        rows_search_2 <= rows_search_rows_ready_words_0 / 65536;
        rows_reference_1 <= (rows_reference_rows_ready_words_0 / 256) mod 256;
        rows_reference_2 <= rows_reference_rows_ready_words_0 / 65536;
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
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 65536) + (rows_search_rows_ready_newest_0 *
          256) + (rows_search_rows_ready_newest_1 * 65536);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 65536) +
          (rows_reference_rows_ready_newest_0 * 256) + (rows_reference_rows_ready_newest_1 * 65536);
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
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
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
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_single_0_0 <= (folded(slice0cost_difference_0_0) + as_number((slice0cost_difference_0_0 < 0))) mod 256;
      slice0cost_single_0_1 <= (folded(slice0cost_difference_0_1) + as_number((slice0cost_difference_0_1 < 0))) mod 256;
      slice0cost_single_0_2 <= (folded(slice0cost_difference_0_2) + as_number((slice0cost_difference_0_2 < 0))) mod 256;
      slice0cost_single_3_0 <= (folded(slice0cost_difference_3_0) + as_number((slice0cost_difference_3_0 < 0))) mod 256;
      slice0cost_single_3_1 <= (folded(slice0cost_difference_3_1) + as_number((slice0cost_difference_3_1 < 0))) mod 256;
      slice0cost_single_3_2 <= (folded(slice0cost_difference_3_2) + as_number((slice0cost_difference_3_2 < 0))) mod 256;
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
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
      else
        slice0cost_column_0_0 <= slice0cost_pair_0_0 + as_number(slice0cost_negative_0_0) + slice0cost_single_0_0;
        slice0cost_column_0_1 <= slice0cost_pair_0_1 + as_number(slice0cost_negative_0_1) + slice0cost_single_0_1;
        slice0cost_column_0_2 <= slice0cost_pair_0_2 + as_number(slice0cost_negative_0_2) + slice0cost_single_0_2;
        slice0cost_column_1_0 <= slice0cost_pair_0_0 + as_number(slice0cost_negative_0_0) + slice0cost_single_3_0;
        slice0cost_column_1_1 <= slice0cost_pair_0_1 + as_number(slice0cost_negative_0_1) + slice0cost_single_3_1;
        slice0cost_column_1_2 <= slice0cost_pair_0_2 + as_number(slice0cost_negative_0_2) + slice0cost_single_3_2;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
        slice0window_partial_1_0_0 <= slice0cost_column_1_0;
        slice0window_partial_1_0_1 <= slice0cost_column_1_1;
        slice0window_partial_1_0_2 <= slice0cost_column_1_2;
        slice0window_partial_1_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_0_0;
        slice0window_partial_1_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_0_1;
        slice0window_partial_1_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_0_2;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_first_column_0 <= slice0cost_tag_first_cost;
      end if;
      slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_1_0;
      slice0window_sum_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_1_1;
      slice0window_sum_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      if slice0window_tag_valid then
        slice0window_tag_output_column <= slice1cost_tag_output_column;
        slice0window_tag_first_column <= slice1cost_tag_first_cost;
      end if;
      -- slice0other
      slice0other_cost_0_0_all := slice1window_centre_output_column_0 and (((slice0other_cost_0_1 -
        slice0window_sum_0_0) >= 0) or slice1window_centre_first_column_0);
      slice0other_cost_0_1_all := slice1window_centre_output_column_0 and slice1window_centre_first_column_0;
      if (slice0other_cost_0_2 - slice0window_sum_0_1) >= 0 then
        slice0other_cost_0_1_choice := slice1window_centre_output_column_0;
      else
        slice0other_cost_0_1_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_1_1 - slice0window_sum_1_0) >= 0 then
        slice0other_cost_1_0_choice := slice1window_centre_output_column_0;
      else
        slice0other_cost_1_0_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0other_cost_1_2 - slice0window_sum_1_1) >= 0 then
        slice0other_cost_1_1_choice := slice1window_centre_output_column_0;
      else
        slice0other_cost_1_1_choice := slice0other_cost_0_1_all;
      end if;
      if slice0window_tag_valid then
        if slice0other_cost_0_0_all then
          slice0other_cost_0_0 <= slice0window_sum_0_0;
          slice0other_winner_0_0 <= 5;
        else
          slice0other_cost_0_0 <= slice0other_cost_0_1;
          slice0other_winner_0_0 <= slice0other_winner_0_1;
        end if;
        if slice0other_cost_0_1_choice then
          slice0other_cost_0_1 <= slice0window_sum_0_1;
          slice0other_winner_0_1 <= 6;
        else
          slice0other_cost_0_1 <= slice0other_cost_0_2;
          slice0other_winner_0_1 <= slice0other_winner_0_2;
        end if;
        if slice1window_centre_output_column_0 then
          slice0other_cost_0_2 <= slice0window_sum_0_2;
          slice0other_cost_1_2 <= slice0window_sum_1_2;
          slice0other_winner_0_2 <= 7;
        else
          slice0other_cost_0_2 <= 0;
          slice0other_cost_1_2 <= 0;
          slice0other_winner_0_2 <= 0;
        end if;
        if slice0other_cost_1_0_choice then
          slice0other_cost_1_0 <= slice0window_sum_1_0;
          slice0other_winner_1_0 <= 5;
        else
          slice0other_cost_1_0 <= slice0other_cost_1_1;
          slice0other_winner_1_0 <= slice0other_winner_1_1;
        end if;
        if slice0other_cost_1_1_choice then
          slice0other_cost_1_1 <= slice0window_sum_1_1;
          slice0other_winner_1_1 <= 6;
        else
          slice0other_cost_1_1 <= slice0other_cost_1_2;
          slice0other_winner_1_1 <= slice0other_winner_0_2;
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0_0;
      slice0other_cost_out_1 <= slice0other_cost_1_0;
      slice0other_winner_out_0 <= slice0other_winner_0_0;
      slice0other_winner_out_1 <= slice0other_winner_1_0;
      -- slice0winner1
      slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_of_pair_1_0_is_less := (slice0window_sum_1_1 - slice0window_sum_1_0) < 0;
      slice0winner1_of_four_0_0_is_less := (slice0winner1_of_pair_0_2 -
        to_integer(((to_unsigned(slice0winner1_of_pair_0_0, 12)) or (to_unsigned(slice0winner1_of_pair_0_1, 12))))) < 0;
      slice0winner1_of_four_1_0_is_less := (slice0winner1_of_pair_1_2 -
        to_integer(((to_unsigned(slice0winner1_of_pair_1_0, 12)) or (to_unsigned(slice0winner1_of_pair_1_1, 12))))) < 0;
      slice0winner1_of_pair_0_2 <= slice0window_sum_0_2;
      slice0winner1_of_pair_1_2 <= slice0window_sum_1_2;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
      slice0winner1_pair_index_0_1 <= 2;
      slice0winner1_pair_index_1_0 <= slice0winner1_of_pair_1_0_is_less;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_pair_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_pair_tag_first_column <= slice0window_tag_first_column;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_map_column <= slice0winner1_pair_tag_map_column;
      slice0winner1_four_tag_output_column <= slice1window_tag_output_column;
      slice0winner1_four_tag_first_column <= slice1window_tag_first_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_0_1, 12)) or
        (to_unsigned(slice0winner1_of_four_0_2, 12)))) or (to_unsigned(slice0winner1_of_four_0_0, 12))));
      slice0winner1_best_cost_1_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_1_1, 12)) or
        (to_unsigned(slice0winner1_of_four_1_2, 12)))) or (to_unsigned(slice0winner1_of_four_1_0, 12))));
      slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
      slice0winner1_best_index_1_0 <= slice0winner1_four_index_1_0;
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
      if slice0winner1_of_pair_1_0_is_less then
        slice0winner1_of_pair_1_0 <= 0;
        slice0winner1_of_pair_1_1 <= slice0window_sum_1_1;
      else
        slice0winner1_of_pair_1_0 <= slice0window_sum_1_0;
        slice0winner1_of_pair_1_1 <= 0;
      end if;
      if slice0winner1_of_four_0_0_is_less then
        slice0winner1_of_four_0_0 <= 0;
        slice0winner1_of_four_0_1 <= 0;
        slice0winner1_of_four_0_2 <= slice0winner1_of_pair_0_2;
        slice0winner1_four_index_0_0 <= slice0winner1_pair_index_0_1;
      else
        slice0winner1_of_four_0_0 <= slice0winner1_of_pair_0_0;
        slice0winner1_of_four_0_1 <= slice0winner1_of_pair_0_1;
        slice0winner1_of_four_0_2 <= 0;
        slice0winner1_four_index_0_0 <= as_number(slice0winner1_pair_index_0_0);
      end if;
      if slice0winner1_of_four_1_0_is_less then
        slice0winner1_of_four_1_0 <= 0;
        slice0winner1_of_four_1_1 <= 0;
        slice0winner1_of_four_1_2 <= slice0winner1_of_pair_1_2;
        slice0winner1_four_index_1_0 <= slice0winner1_pair_index_0_1;
      else
        slice0winner1_of_four_1_0 <= slice0winner1_of_pair_1_0;
        slice0winner1_of_four_1_1 <= slice0winner1_of_pair_1_1;
        slice0winner1_of_four_1_2 <= 0;
        slice0winner1_four_index_1_0 <= as_number(slice0winner1_pair_index_1_0);
      end if;
      if slice0winner1_pair_tag_valid then
        slice0winner1_pair_tag_map_column <= slice0window_tag_map_column;
        slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0_best_cost_1_0 <= slice0winner1_best_cost_1_0;
      slice0_best_index_0_0 <= slice0winner1_best_index_0_0 + 5;
      slice0_best_index_1_0 <= slice0winner1_best_index_1_0 + 5;
      slice0_best_tag_valid <= slice0winner1_tag_valid;
      slice0_best_tag_map_column <= slice0winner1_tag_map_column;
      slice0_best_tag_output_column <= slice0winner1_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner1_tag_end_of_line;
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
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      slice1shift_search_out_2 <= slice1shift_search_2_0;
      slice1shift_search_out_3 <= slice1shift_search_3_0;
      -- slice1cost
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
      slice1cost_single_0_0 <= (folded(slice1cost_difference_0_0) + as_number((slice1cost_difference_0_0 < 0))) mod 256;
      slice1cost_single_0_1 <= (folded(slice1cost_difference_0_1) + as_number((slice1cost_difference_0_1 < 0))) mod 256;
      slice1cost_single_0_2 <= (folded(slice1cost_difference_0_2) + as_number((slice1cost_difference_0_2 < 0))) mod 256;
      slice1cost_single_3_0 <= (folded(slice1cost_difference_3_0) + as_number((slice1cost_difference_3_0 < 0))) mod 256;
      slice1cost_single_3_1 <= (folded(slice1cost_difference_3_1) + as_number((slice1cost_difference_3_1 < 0))) mod 256;
      slice1cost_single_3_2 <= (folded(slice1cost_difference_3_2) + as_number((slice1cost_difference_3_2 < 0))) mod 256;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      slice1cost_tag_first_cost <= slice0cost_tag_first_cost;
      slice1cost_tag_output_column <= slice0cost_tag_output_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
      else
        slice1cost_column_0_0 <= slice1cost_pair_0_0 + as_number(slice1cost_negative_0_0) + slice1cost_single_0_0;
        slice1cost_column_0_1 <= slice1cost_pair_0_1 + as_number(slice1cost_negative_0_1) + slice1cost_single_0_1;
        slice1cost_column_0_2 <= slice1cost_pair_0_2 + as_number(slice1cost_negative_0_2) + slice1cost_single_0_2;
        slice1cost_column_1_0 <= slice1cost_pair_0_0 + as_number(slice1cost_negative_0_0) + slice1cost_single_3_0;
        slice1cost_column_1_1 <= slice1cost_pair_0_1 + as_number(slice1cost_negative_0_1) + slice1cost_single_3_1;
        slice1cost_column_1_2 <= slice1cost_pair_0_2 + as_number(slice1cost_negative_0_2) + slice1cost_single_3_2;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_1_0 <= slice1cost_column_0_0 + slice1window_partial_0_0_0;
        slice1window_partial_0_1_1 <= slice1cost_column_0_1 + slice1window_partial_0_0_1;
        slice1window_partial_0_1_2 <= slice1cost_column_0_2 + slice1window_partial_0_0_2;
        slice1window_partial_1_0_0 <= slice1cost_column_1_0;
        slice1window_partial_1_0_1 <= slice1cost_column_1_1;
        slice1window_partial_1_0_2 <= slice1cost_column_1_2;
        slice1window_partial_1_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_0_0;
        slice1window_partial_1_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_0_1;
        slice1window_partial_1_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_0_2;
      end if;
      slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
      slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      slice1window_sum_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_1_0;
      slice1window_sum_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_1_1;
      slice1window_sum_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_1_2;
      if slice0winner1_pair_tag_valid then
        slice1window_tag_output_column <= slice2cost_tag_output_column;
        slice1window_tag_first_column <= slice2cost_tag_first_cost;
      end if;
      -- slice1other
      slice1other_cost_0_0_any := (not slice0winner1_pair_tag_output_column) or ((not
        slice0winner1_pair_tag_first_column) and ((slice1other_cost_0_1 - slice1window_sum_0_0) < 0));
      slice1other_cost_0_1_any := (not slice0winner1_pair_tag_output_column) or (not
        slice0winner1_pair_tag_first_column);
      if (slice1other_cost_0_2 - slice1window_sum_0_1) >= 0 then
        slice1other_cost_0_1_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_1_choice := slice1other_cost_0_1_any;
      end if;
      if (slice0other_cost_out_0 - slice1window_sum_0_2) >= 0 then
        slice1other_cost_0_2_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_0_2_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_1_1 - slice1window_sum_1_0) >= 0 then
        slice1other_cost_1_0_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_1_0_choice := slice1other_cost_0_1_any;
      end if;
      if (slice1other_cost_1_2 - slice1window_sum_1_1) >= 0 then
        slice1other_cost_1_1_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_1_1_choice := slice1other_cost_0_1_any;
      end if;
      if (slice0other_cost_out_1 - slice1window_sum_1_2) >= 0 then
        slice1other_cost_1_2_choice := not slice0winner1_pair_tag_output_column;
      else
        slice1other_cost_1_2_choice := slice1other_cost_0_1_any;
      end if;
      if slice0winner1_pair_tag_valid then
        if slice1other_cost_0_0_any then
          slice1other_cost_0_0 <= slice1other_cost_0_1;
          slice1other_winner_0_0 <= slice1other_winner_0_1;
        else
          slice1other_cost_0_0 <= slice1window_sum_0_0;
          slice1other_winner_0_0 <= 2;
        end if;
        if slice1other_cost_0_1_choice then
          slice1other_cost_0_1 <= slice1other_cost_0_2;
          slice1other_winner_0_1 <= slice1other_winner_0_2;
        else
          slice1other_cost_0_1 <= slice1window_sum_0_1;
          slice1other_winner_0_1 <= 3;
        end if;
        if slice1other_cost_0_2_choice then
          slice1other_cost_0_2 <= slice0other_cost_out_0;
          slice1other_winner_0_2 <= slice0other_winner_out_0;
        else
          slice1other_cost_0_2 <= slice1window_sum_0_2;
          slice1other_winner_0_2 <= 4;
        end if;
        if slice1other_cost_1_0_choice then
          slice1other_cost_1_0 <= slice1other_cost_1_1;
          slice1other_winner_1_0 <= slice1other_winner_1_1;
        else
          slice1other_cost_1_0 <= slice1window_sum_1_0;
          slice1other_winner_1_0 <= 2;
        end if;
        if slice1other_cost_1_1_choice then
          slice1other_cost_1_1 <= slice1other_cost_1_2;
          slice1other_winner_1_1 <= slice1other_winner_1_2;
        else
          slice1other_cost_1_1 <= slice1window_sum_1_1;
          slice1other_winner_1_1 <= 3;
        end if;
        if slice1other_cost_1_2_choice then
          slice1other_cost_1_2 <= slice0other_cost_out_1;
          slice1other_winner_1_2 <= slice0other_winner_out_1;
        else
          slice1other_cost_1_2 <= slice1window_sum_1_2;
          slice1other_winner_1_2 <= 4;
        end if;
      end if;
      slice1other_cost_out_0 <= slice1other_cost_0_0;
      slice1other_cost_out_1 <= slice1other_cost_1_0;
      slice1other_winner_out_0 <= slice1other_winner_0_0;
      slice1other_winner_out_1 <= slice1other_winner_1_0;
      -- slice1winner1
      slice1winner1_of_pair_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_of_pair_1_0_is_less := (slice1window_sum_1_1 - slice1window_sum_1_0) < 0;
      slice1winner1_of_four_0_0_is_less := (slice1winner1_of_pair_0_2 -
        to_integer(((to_unsigned(slice1winner1_of_pair_0_0, 12)) or (to_unsigned(slice1winner1_of_pair_0_1, 12))))) < 0;
      slice1winner1_of_four_1_0_is_less := (slice1winner1_of_pair_1_2 -
        to_integer(((to_unsigned(slice1winner1_of_pair_1_0, 12)) or (to_unsigned(slice1winner1_of_pair_1_1, 12))))) < 0;
      slice1winner1_of_pair_0_2 <= slice1window_sum_0_2;
      slice1winner1_of_pair_1_2 <= slice1window_sum_1_2;
      slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_is_less;
      slice1winner1_pair_index_1_0 <= slice1winner1_of_pair_1_0_is_less;
      slice1winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_0_1, 12)) or
        (to_unsigned(slice1winner1_of_four_0_2, 12)))) or (to_unsigned(slice1winner1_of_four_0_0, 12))));
      slice1winner1_best_cost_1_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_1_1, 12)) or
        (to_unsigned(slice1winner1_of_four_1_2, 12)))) or (to_unsigned(slice1winner1_of_four_1_0, 12))));
      slice1winner1_best_index_0_0 <= slice1winner1_four_index_0_0;
      slice1winner1_best_index_1_0 <= slice1winner1_four_index_1_0;
      if slice1winner1_of_pair_0_0_is_less then
        slice1winner1_of_pair_0_0 <= 0;
        slice1winner1_of_pair_0_1 <= slice1window_sum_0_1;
      else
        slice1winner1_of_pair_0_0 <= slice1window_sum_0_0;
        slice1winner1_of_pair_0_1 <= 0;
      end if;
      if slice1winner1_of_pair_1_0_is_less then
        slice1winner1_of_pair_1_0 <= 0;
        slice1winner1_of_pair_1_1 <= slice1window_sum_1_1;
      else
        slice1winner1_of_pair_1_0 <= slice1window_sum_1_0;
        slice1winner1_of_pair_1_1 <= 0;
      end if;
      if slice1winner1_of_four_0_0_is_less then
        slice1winner1_of_four_0_0 <= 0;
        slice1winner1_of_four_0_1 <= 0;
        slice1winner1_of_four_0_2 <= slice1winner1_of_pair_0_2;
        slice1winner1_four_index_0_0 <= slice0winner1_pair_index_0_1;
      else
        slice1winner1_of_four_0_0 <= slice1winner1_of_pair_0_0;
        slice1winner1_of_four_0_1 <= slice1winner1_of_pair_0_1;
        slice1winner1_of_four_0_2 <= 0;
        slice1winner1_four_index_0_0 <= as_number(slice1winner1_pair_index_0_0);
      end if;
      if slice1winner1_of_four_1_0_is_less then
        slice1winner1_of_four_1_0 <= 0;
        slice1winner1_of_four_1_1 <= 0;
        slice1winner1_of_four_1_2 <= slice1winner1_of_pair_1_2;
        slice1winner1_four_index_1_0 <= slice0winner1_pair_index_0_1;
      else
        slice1winner1_of_four_1_0 <= slice1winner1_of_pair_1_0;
        slice1winner1_of_four_1_1 <= slice1winner1_of_pair_1_1;
        slice1winner1_of_four_1_2 <= 0;
        slice1winner1_four_index_1_0 <= as_number(slice1winner1_pair_index_1_0);
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner1_best_cost_0_0) < 0;
      slice1_best_cost_1_0_is_less := (slice0_best_cost_1_0 - slice1winner1_best_cost_1_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1_best_index_0_0 <= (((slice1winner1_best_index_0_0 / 2) + 1) * 2) + (slice1winner1_best_index_0_0 mod 2);
      end if;
      if slice1_best_cost_1_0_is_less then
        slice1_best_cost_1_0 <= slice0_best_cost_1_0;
        slice1_best_index_1_0 <= slice0_best_index_1_0;
      else
        slice1_best_cost_1_0 <= slice1winner1_best_cost_1_0;
        slice1_best_index_1_0 <= (((slice1winner1_best_index_1_0 / 2) + 1) * 2) + (slice1winner1_best_index_1_0 mod 2);
      end if;
      -- slice2shift
      if slice0cost_difference_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice1shift_search_out_0;
        slice2shift_search_1_0 <= slice2shift_search_1_1;
        slice2shift_search_1_1 <= slice1shift_search_out_1;
        slice2shift_search_2_0 <= slice2shift_search_2_1;
        slice2shift_search_2_1 <= slice1shift_search_out_2;
        slice2shift_search_3_0 <= slice2shift_search_3_1;
        slice2shift_search_3_1 <= slice1shift_search_out_3;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      slice2shift_reference_3 <= slice1shift_reference_3;
      -- slice2cost
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
      slice2cost_single_0_0 <= (folded(slice2cost_difference_0_0) + as_number((slice2cost_difference_0_0 < 0))) mod 256;
      slice2cost_single_0_1 <= (folded(slice2cost_difference_0_1) + as_number((slice2cost_difference_0_1 < 0))) mod 256;
      slice2cost_single_3_0 <= (folded(slice2cost_difference_3_0) + as_number((slice2cost_difference_3_0 < 0))) mod 256;
      slice2cost_single_3_1 <= (folded(slice2cost_difference_3_1) + as_number((slice2cost_difference_3_1 < 0))) mod 256;
      slice2cost_tag_first_cost <= slice1cost_tag_first_cost;
      slice2cost_tag_output_column <= slice1cost_tag_output_column;
      if slice1cost_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
      else
        slice2cost_column_0_0 <= slice2cost_pair_0_0 + as_number(slice2cost_negative_0_0) + slice2cost_single_0_0;
        slice2cost_column_0_1 <= slice2cost_pair_0_1 + as_number(slice2cost_negative_0_1) + slice2cost_single_0_1;
        slice2cost_column_1_0 <= slice2cost_pair_0_0 + as_number(slice2cost_negative_0_0) + slice2cost_single_3_0;
        slice2cost_column_1_1 <= slice2cost_pair_0_1 + as_number(slice2cost_negative_0_1) + slice2cost_single_3_1;
      end if;
      -- slice2window
      if slice0winner1_pair_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
        slice2window_partial_1_0_0 <= slice2cost_column_1_0;
        slice2window_partial_1_0_1 <= slice2cost_column_1_1;
        slice2window_partial_1_1_0 <= slice2cost_column_1_0 + slice2window_partial_1_0_0;
        slice2window_partial_1_1_1 <= slice2cost_column_1_1 + slice2window_partial_1_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      slice2window_sum_1_0 <= slice2cost_column_1_0 + slice2window_partial_1_1_0;
      slice2window_sum_1_1 <= slice2cost_column_1_1 + slice2window_partial_1_1_1;
      -- slice2other
      slice2other_cost_0_1_any := (not slice0winner1_four_tag_output_column) or (not
        slice0winner1_four_tag_first_column);
      if (slice1other_cost_out_0 - slice2window_sum_0_1) >= 0 then
        slice2other_cost_0_1_choice := not slice0winner1_four_tag_output_column;
      else
        slice2other_cost_0_1_choice := slice2other_cost_0_1_any;
      end if;
      if (slice1other_cost_out_1 - slice2window_sum_1_1) >= 0 then
        slice2other_cost_1_1_choice := not slice0winner1_four_tag_output_column;
      else
        slice2other_cost_1_1_choice := slice2other_cost_0_1_any;
      end if;
      if (slice2other_cost_1_1 - slice2window_sum_1_0) >= 0 then
        slice2other_winner_1_0_choice := not slice0winner1_four_tag_output_column;
      else
        slice2other_winner_1_0_choice := slice2other_cost_0_1_any;
      end if;
      if slice0winner1_four_tag_valid then
        if slice2other_cost_0_1_choice then
          slice2other_cost_0_1 <= slice1other_cost_out_0;
          slice2other_winner_0_1 <= slice1other_winner_out_0;
        else
          slice2other_cost_0_1 <= slice2window_sum_0_1;
          slice2other_winner_0_1 <= 1;
        end if;
        if slice2other_cost_1_1_choice then
          slice2other_cost_1_1 <= slice1other_cost_out_1;
          slice2other_winner_1_1 <= slice1other_winner_out_1;
        else
          slice2other_cost_1_1 <= slice2window_sum_1_1;
          slice2other_winner_1_1 <= 1;
        end if;
        if (not slice0winner1_four_tag_output_column) or ((not slice0winner1_four_tag_first_column) and
          ((slice2other_cost_0_1 - slice2window_sum_0_0) < 0)) then
          slice2other_winner_0_0 <= slice2other_winner_0_1;
        else
          slice2other_winner_0_0 <= 0;
        end if;
        if slice2other_winner_1_0_choice then
          slice2other_winner_1_0 <= slice2other_winner_1_1;
        else
          slice2other_winner_1_0 <= 0;
        end if;
      end if;
      slice2other_winner_out_0 <= slice2other_winner_0_0;
      slice2other_winner_out_1 <= slice2other_winner_1_0;
      -- slice2winner1
      slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0_1 - slice2window_sum_0_0) < 0;
      slice2winner1_best_cost_1_0_is_less := (slice2window_sum_1_1 - slice2window_sum_1_0) < 0;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      slice2winner1_best_index_1_0 <= slice2winner1_best_cost_1_0_is_less;
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
      -- slice2winner2
      slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
      slice2winner2_best_cost_1_0 <= slice2winner1_best_cost_1_0;
      slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_0;
      slice2winner2_best_index_1_0 <= slice2winner1_best_index_1_0;
      -- slice2winner3
      slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
      slice2winner3_best_cost_1_0 <= slice2winner2_best_cost_1_0;
      slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
      slice2winner3_best_index_1_0 <= slice2winner2_best_index_1_0;
      -- slice2
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if (slice1_best_cost_0_0 - slice2winner3_best_cost_0_0) < 0 then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_index_0_0 <= as_number(slice2winner3_best_index_0_0);
      end if;
      if (slice1_best_cost_1_0 - slice2winner3_best_cost_1_0) < 0 then
        slice2_best_index_1_0 <= slice1_best_index_1_0;
      else
        slice2_best_index_1_0 <= as_number(slice2winner3_best_index_1_0);
      end if;
      -- leftright
      leftright_holds_winners_all := (not leftright_holds_winners) and (((leftright_ring_read_address / 4) = 1) or
        (((leftright_ring_read_address / 2) mod 2) = 1) or ((leftright_ring_read_address mod 2) = 1));
      if to_integer(leftright_found_0(2 downto 2)) = 1 then
        leftright_checked_passed_0_choice := (leftright_answered_disparity_0 / 4) = 1;
      else
        leftright_checked_passed_0_choice := (leftright_answered_disparity_0 / 4) = 0;
      end if;
      if to_integer(leftright_found_0(0 downto 0)) = 1 then
        leftright_checked_passed_0_choice_2 := (leftright_answered_disparity_0 mod 4) = 3;
      else
        leftright_checked_passed_0_choice_2 := (leftright_answered_disparity_0 mod 4) = 2;
      end if;
      if to_integer(leftright_found_0(0 downto 0)) = 1 then
        leftright_checked_passed_0_choice_3 := (leftright_answered_disparity_0 mod 4) = 1;
      else
        leftright_checked_passed_0_choice_3 := (leftright_answered_disparity_0 mod 4) = 0;
      end if;
      if to_integer(leftright_found_0(1 downto 1)) = 1 then
        leftright_checked_passed_0_choice_4 := leftright_checked_passed_0_choice_2;
      else
        leftright_checked_passed_0_choice_4 := leftright_checked_passed_0_choice_3;
      end if;
      if to_integer(leftright_found_1(2 downto 2)) = 1 then
        leftright_checked_passed_1_choice := (leftright_answered_disparity_1 / 4) = 1;
      else
        leftright_checked_passed_1_choice := (leftright_answered_disparity_1 / 4) = 0;
      end if;
      if to_integer(leftright_found_1(0 downto 0)) = 1 then
        leftright_checked_passed_1_choice_2 := (leftright_answered_disparity_1 mod 4) = 3;
      else
        leftright_checked_passed_1_choice_2 := (leftright_answered_disparity_1 mod 4) = 2;
      end if;
      if to_integer(leftright_found_1(0 downto 0)) = 1 then
        leftright_checked_passed_1_choice_3 := (leftright_answered_disparity_1 mod 4) = 1;
      else
        leftright_checked_passed_1_choice_3 := (leftright_answered_disparity_1 mod 4) = 0;
      end if;
      if to_integer(leftright_found_1(1 downto 1)) = 1 then
        leftright_checked_passed_1_choice_4 := leftright_checked_passed_1_choice_2;
      else
        leftright_checked_passed_1_choice_4 := leftright_checked_passed_1_choice_3;
      end if;
      leftright_other_1_0 <= slice2other_winner_out_0;
      leftright_other_1_1 <= slice2other_winner_out_1;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_2_1 <= leftright_other_1_1;
      leftright_position <= (leftright_position + as_number(slice2_best_tag_valid)) mod 16;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and slice2_best_tag_valid;
      leftright_address_0 <= (leftright_held_position + to_integer(leftright_held_0(21 downto 4)) + 9) mod 16;
      leftright_address_1 <= (leftright_held_position + to_integer(leftright_held_0(21 downto 13)) + 9) mod 16;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(7 downto 4));
      leftright_asking_disparity_1 <= to_integer(leftright_held_0(16 downto 13));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(21 downto 21)) = 1;
      leftright_asking_passed_1 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_output_column <= to_integer(leftright_held_0(1 downto 1)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_disparity_1 <= leftright_asking_disparity_1;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_passed_1 <= leftright_asking_passed_1;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_output_column <= leftright_asking_tag_output_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_disparity_1 <= leftright_answered_disparity_1;
      leftright_checked_passed_0 <= leftright_checked_passed_0_choice and leftright_checked_passed_0_choice_4 and
        leftright_answered_passed_1;
      leftright_checked_passed_1 <= leftright_checked_passed_1_choice and leftright_checked_passed_1_choice_4 and
        leftright_answered_passed_0;
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_output_column <= leftright_answered_tag_output_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_all then
        leftright_holds_winners <= (not slice2_best_tag_valid) and leftright_holds_winners;
      else
        leftright_holds_winners <= slice2_best_tag_valid or leftright_holds_winners;
      end if;
      if slice2_best_tag_valid then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 7 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 8;
        end if;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 7;
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
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_tag_output_column <= false;
        slice1window_tag_output_column <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2cost_tag_output_column <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
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
