-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm_12bit_all: 40x12, 12 disparities, window 3x3, P1 5, P2 22, 1 pixel pair a clock.
-- Options: disparities 12, pixel_bits 12, reference left, cost sad, prefilter xsobel, prefilter_cap 500,
--   cost_shift 7, cost_cap 63, left_right_threshold 1, uniqueness_distance 3, subpixel true, median true,
--   full_width true, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm_12bit_all
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm_12bit_all is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 38;
    latency_clocks : positive := 59;
    flush_groups : positive := 226;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(11 downto 0);  -- 12 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(11 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 40 report "stereo_core_tiny_sgm_12bit_all: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm_12bit_all: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm_12bit_all: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm_12bit_all: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_sgm_12bit_all: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 38 report "stereo_core_tiny_sgm_12bit_all: output_width_px is " & integer'image(output_width_px) & " but this core has 38" severity failure;
  assert latency_clocks = 59 report "stereo_core_tiny_sgm_12bit_all: latency_clocks is " & integer'image(latency_clocks) & " but this core has 59" severity failure;
  assert flush_groups = 226 report "stereo_core_tiny_sgm_12bit_all: flush_groups is " & integer'image(flush_groups) & " but this core has 226" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm_12bit_all: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm_12bit_all is
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
  signal in_right_pixel : natural range 0 to 4095;
  signal in_left_pixel : natural range 0 to 4095;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 4095;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 4095;
  signal transform_right_rows_ready_newest_0, transform_left_column_0 : natural range 0 to 4095;
  signal transform_left_column_1, transform_left_column_2, transform_right_column_0 : natural range 0 to 4095;
  signal transform_right_column_1, transform_right_column_2 : natural range 0 to 4095;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_column_inside_0, transform_read_column_inside_1 : boolean;
  signal transform_read_column_inside_2, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_column_inside_0 : boolean;
  signal transform_ready_column_inside_1, transform_ready_column_inside_2, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_2 : boolean;
  signal transform_columns_column_inside_0, transform_columns_column_inside_1 : boolean;
  signal transform_columns_column_inside_2, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_left_filter_whole, transform_filtering_0_column_inside_0 : boolean;
  signal transform_filtering_0_column_inside_2, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_filtering_2_start_of_frame, transform_filtering_2_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(23 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_left_filter_column_0_0, transform_left_filter_column_1_0 : natural range 0 to 16381;
  signal transform_left_filter_column_2_0, transform_right_filter_column_0_0 : natural range 0 to 16381;
  signal transform_right_filter_column_1_0, transform_right_filter_column_2_0 : natural range 0 to 16381;
  signal transform_left_filter_slope_0, transform_right_filter_slope_0 : integer range -16381 to 16381;
  signal transform_left_filter_feature_0 : natural range 0 to 65535;
  signal transform_right_filter_feature_0 : natural range 0 to 2047;
  -- raster
  signal raster_features_search_0 : natural range 0 to 2047;
  signal raster_features_reference_0 : natural range 0 to 65535;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ahead_0 : natural range 0 to 65535;
  signal delay_delayed_0 : natural range 0 to 2047;
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_tag_valid, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_first_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(21 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_search_0 : natural range 0 to 2047;
  signal rows_search_1, rows_search_2, rows_reference_0, rows_reference_1 : natural range 0 to 2047;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 4194303;
  signal rows_reference_rows_ready_words_0 : natural range 0 to 4194303;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 65535;
  signal rows_reference_2 : natural range 0 to 65535;
  signal rows_reference_rows_write_words_0 : natural range 0 to 134217727;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_tag_valid : boolean;
  signal rows_read_tag_map_column, rows_read_tag_output_column, rows_read_tag_first_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1 : boolean;
  signal rows_ready_inside_2, rows_ready_tag_valid, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_map_column, rows_tag_output_column, rows_tag_first_column : boolean;
  signal rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 2047;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_1_0 : natural range 0 to 2047;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 2047;
  signal slice0shift_search_1_4, slice0shift_search_2_0, slice0shift_search_2_1 : natural range 0 to 2047;
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : natural range 0 to 2047;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_search_out_0 : natural range 0 to 2047;
  signal slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 2047;
  signal slice0shift_reference_2 : natural range 0 to 65535;
  signal slice0shift_tag_valid, slice0shift_tag_map_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_first_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -2047 to 2047;
  signal slice0cost_difference_0_3, slice0cost_difference_0_4, slice0cost_difference_1_0 : integer range -2047 to 2047;
  signal slice0cost_difference_1_1, slice0cost_difference_1_2, slice0cost_difference_1_3 : integer range -2047 to 2047;
  signal slice0cost_difference_1_4 : integer range -2047 to 2047;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1 : integer range -32768 to 32767;
  signal slice0cost_difference_2_2, slice0cost_difference_2_3 : integer range -32768 to 32767;
  signal slice0cost_difference_2_4 : integer range -32768 to 32767;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_map_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_first_column : boolean;
  signal slice0cost_difference_tag_start_of_frame, slice0cost_difference_tag_end_of_line : boolean;
  signal slice0cost_negative_0_0, slice0cost_negative_0_1, slice0cost_negative_0_2, slice0cost_negative_0_3 : boolean;
  signal slice0cost_negative_0_4, slice0cost_pair_tag_valid, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_first_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_map_column, slice0cost_tag_output_column, slice0cost_tag_first_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 34815;
  signal slice0cost_pair_0_4 : natural range 0 to 34815;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 2048;
  signal slice0cost_single_0_3, slice0cost_single_0_4 : natural range 0 to 2048;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 36864;
  signal slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 36864;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 36864;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4 : natural range 0 to 36864;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 65535;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4, slice0window_sum_0_0 : natural range 0 to 65535;
  signal slice0window_sum_0_1, slice0window_sum_0_2, slice0window_sum_0_3 : natural range 0 to 65535;
  signal slice0window_sum_0_4 : natural range 0 to 65535;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  -- slice0mask
  signal slice0mask_inside_0, slice0mask_inside_1, slice0mask_inside_2, slice0mask_inside_3 : boolean;
  signal slice0mask_inside_4, slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 63;
  -- slice0
  signal slice0_held_0_0, slice0_held_0_1, slice0_held_0_2, slice0_held_0_3, slice0_held_0_4 : natural range 0 to 255;
  signal slice0_held_1_0, slice0_held_1_1, slice0_held_1_2, slice0_held_1_3, slice0_held_1_4 : natural range 0 to 255;
  signal slice0_held_2_0, slice0_held_2_1, slice0_held_2_2, slice0_held_2_3, slice0_held_2_4 : natural range 0 to 255;
  signal slice0_tag_0_valid, slice0_tag_0_map_column, slice0_tag_0_output_column, slice0_tag_0_first_column : boolean;
  signal slice0_tag_0_start_of_frame, slice0_tag_0_end_of_line, slice0_tag_1_valid, slice0_tag_1_map_column : boolean;
  signal slice0_tag_1_output_column, slice0_tag_1_first_column, slice0_tag_1_start_of_frame : boolean;
  signal slice0_tag_1_end_of_line, slice0_tag_2_valid, slice0_tag_2_map_column, slice0_tag_2_output_column : boolean;
  signal slice0_tag_2_first_column, slice0_tag_2_start_of_frame, slice0_tag_2_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 2047;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_1_0 : natural range 0 to 2047;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 2047;
  signal slice1shift_search_1_4, slice1shift_search_2_0, slice1shift_search_2_1 : natural range 0 to 2047;
  signal slice1shift_search_2_2, slice1shift_search_2_3, slice1shift_search_2_4 : natural range 0 to 2047;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_search_out_0 : natural range 0 to 2047;
  signal slice1shift_search_out_1, slice1shift_search_out_2 : natural range 0 to 2047;
  signal slice1shift_reference_2 : natural range 0 to 65535;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -2047 to 2047;
  signal slice1cost_difference_0_3, slice1cost_difference_0_4, slice1cost_difference_1_0 : integer range -2047 to 2047;
  signal slice1cost_difference_1_1, slice1cost_difference_1_2, slice1cost_difference_1_3 : integer range -2047 to 2047;
  signal slice1cost_difference_1_4 : integer range -2047 to 2047;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1 : integer range -32768 to 32767;
  signal slice1cost_difference_2_2, slice1cost_difference_2_3 : integer range -32768 to 32767;
  signal slice1cost_difference_2_4 : integer range -32768 to 32767;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 34815;
  signal slice1cost_pair_0_4 : natural range 0 to 34815;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2, slice1cost_negative_0_3 : boolean;
  signal slice1cost_negative_0_4, slice1cost_tag_first_column : boolean;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 2048;
  signal slice1cost_single_0_3, slice1cost_single_0_4 : natural range 0 to 2048;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 36864;
  signal slice1cost_column_0_3, slice1cost_column_0_4 : natural range 0 to 36864;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 36864;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4 : natural range 0 to 36864;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 65535;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4, slice1window_sum_0_0 : natural range 0 to 65535;
  signal slice1window_sum_0_1, slice1window_sum_0_2, slice1window_sum_0_3 : natural range 0 to 65535;
  signal slice1window_sum_0_4 : natural range 0 to 65535;
  signal slice1window_centre_first_column_0, slice1window_tag_first_column : boolean;
  -- slice1mask
  signal slice1mask_inside_0, slice1mask_inside_1, slice1mask_inside_2, slice1mask_inside_3 : boolean;
  signal slice1mask_inside_4, slice1mask_left_out : boolean;
  -- slice1
  signal slice1_held_0_0, slice1_held_0_1, slice1_held_0_2, slice1_held_0_3, slice1_held_0_4 : natural range 0 to 255;
  signal slice1_held_1_0, slice1_held_1_1, slice1_held_1_2, slice1_held_1_3, slice1_held_1_4 : natural range 0 to 255;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 2047;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 2047;
  signal slice2shift_reference_0, slice2shift_reference_1 : natural range 0 to 2047;
  signal slice2shift_reference_2 : natural range 0 to 65535;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -2047 to 2047;
  signal slice2cost_difference_1_1 : integer range -2047 to 2047;
  signal slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -32768 to 32767;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 34815;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1, slice2cost_tag_first_column : boolean;
  signal slice2cost_single_0_0, slice2cost_single_0_1 : natural range 0 to 2048;
  signal slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 36864;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1 : natural range 0 to 36864;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_sum_0_0 : natural range 0 to 65535;
  signal slice2window_sum_0_1 : natural range 0 to 65535;
  -- slice2mask
  signal slice2mask_inside_0, slice2mask_inside_1 : boolean;
  -- slice2
  signal slice2_held_0_0, slice2_held_0_1 : natural range 0 to 255;
  -- entry
  signal entry_next_cost_0, entry_next_cost_1, entry_next_cost_2, entry_next_cost_3 : natural range 0 to 255;
  signal entry_next_cost_4, entry_next_cost_5, entry_next_cost_6, entry_next_cost_7 : natural range 0 to 255;
  signal entry_next_cost_8, entry_next_cost_9, entry_next_cost_10, entry_next_cost_11 : natural range 0 to 255;
  signal entry_cost_0, entry_cost_1, entry_cost_2, entry_cost_3, entry_cost_4, entry_cost_5 : natural range 0 to 255;
  signal entry_cost_6, entry_cost_7, entry_cost_8, entry_cost_9, entry_cost_10, entry_cost_11 : natural range 0 to 255;
  signal entry_next_tag_valid, entry_next_tag_map_column, entry_next_tag_first_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_map_column, entry_tag_first_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 63;
  -- forward
  signal forward_smallest_smallest_0, forward_smallest_smallest_1, forward_smallest_smallest_2 : natural range 0 to 255;
  signal forward_smallest_smallest_3, forward_smallest_smallest_4, forward_smallest_smallest_5 : natural range 0 to 255;
  signal forward_smallest_next_smallest_0, forward_smallest_next_smallest_1 : natural range 0 to 255;
  signal forward_smallest_next_smallest_2, forward_smallest_next_next_smallest_0 : natural range 0 to 255;
  signal forward_smallest_next_next_smallest_1, forward_smallest_next_next_next_smallest_0 : natural range 0 to 255;
  signal forward_left_start_cost_0, forward_left_start_cost_1, forward_left_start_cost_2 : natural range 0 to 255;
  signal forward_left_start_cost_3, forward_left_start_cost_4, forward_left_start_cost_5 : natural range 0 to 255;
  signal forward_left_start_cost_6, forward_left_smallest, forward_above_ready_cost_0 : natural range 0 to 255;
  signal forward_above_ready_cost_1, forward_above_ready_cost_2, forward_above_ready_cost_3 : natural range 0 to 255;
  signal forward_above_ready_cost_4, forward_above_ready_cost_5, forward_above_ready_cost_6 : natural range 0 to 255;
  signal forward_above_ready_cost_7, forward_above_ready_cost_8, forward_above_ready_cost_9 : natural range 0 to 255;
  signal forward_above_ready_cost_10, forward_above_ready_cost_11, forward_above_total_0 : natural range 0 to 255;
  signal forward_above_total_1, forward_above_total_2, forward_above_total_3 : natural range 0 to 255;
  signal forward_above_total_4, forward_above_total_5, forward_above_total_6 : natural range 0 to 255;
  signal forward_above_total_7, forward_above_total_8, forward_above_total_9 : natural range 0 to 255;
  signal forward_above_total_10, forward_above_total_11, forward_above_tree_smallest_0 : natural range 0 to 255;
  signal forward_above_tree_smallest_1, forward_above_tree_smallest_2 : natural range 0 to 255;
  signal forward_above_tree_smallest_3, forward_above_tree_smallest_4 : natural range 0 to 255;
  signal forward_above_tree_smallest_5, forward_above_tree_next_smallest_0 : natural range 0 to 255;
  signal forward_above_tree_next_smallest_1, forward_above_tree_next_smallest_2 : natural range 0 to 255;
  signal forward_above_tree_next_next_smallest_0, forward_above_tree_next_next_smallest_1 : natural range 0 to 255;
  signal forward_above_tree_next_next_next_smallest_0, forward_above_smallest_copy_0 : natural range 0 to 255;
  signal forward_smallest_cost_0, forward_smallest_cost_1, forward_smallest_cost_2 : natural range 0 to 255;
  signal forward_smallest_cost_3, forward_smallest_cost_4 : natural range 0 to 255;
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_delay_held_0, forward_cost_delay_held_1, forward_above_read_words_0 : unsigned(31 downto 0);
  signal forward_above_read_words_1, forward_above_ready_words_0, forward_above_ready_words_1 : unsigned(31 downto 0);
  signal forward_above_write_words_0, forward_above_write_words_1 : unsigned(31 downto 0);
  signal forward_cost_delay_held_2 : unsigned(13 downto 0);
  signal forward_left_pair_0, forward_left_pair_1, forward_left_pair_2, forward_left_pair_3 : natural range 0 to 511;
  signal forward_left_pair_4, forward_left_pair_5, forward_left_tree_smallest_0 : natural range 0 to 511;
  signal forward_left_tree_smallest_1, forward_left_tree_smallest_2 : natural range 0 to 511;
  signal forward_left_tree_next_smallest_0, forward_left_tree_next_smallest_1 : natural range 0 to 511;
  signal forward_left_tree_next_next_smallest_0, forward_left_smallest_less : natural range 0 to 511;
  signal forward_left_g_less_copy_0, forward_left_stay_change_0, forward_left_stay_change_1 : natural range 0 to 511;
  signal forward_left_stay_change_2, forward_left_stay_change_3, forward_left_stay_change_4 : natural range 0 to 511;
  signal forward_left_stay_change_5, forward_left_stay_change_6, forward_left_stay_change_7 : natural range 0 to 511;
  signal forward_left_stay_change_8, forward_left_stay_change_9, forward_left_stay_change_10 : natural range 0 to 511;
  signal forward_left_stay_change_11, forward_left_step_change_0, forward_left_step_change_1 : natural range 0 to 511;
  signal forward_left_step_change_2, forward_left_step_change_3, forward_left_step_change_4 : natural range 0 to 511;
  signal forward_left_step_change_5, forward_left_step_change_6, forward_left_step_change_7 : natural range 0 to 511;
  signal forward_left_step_change_8, forward_left_step_change_9, forward_left_step_change_10 : natural range 0 to 511;
  signal forward_left_step_change_11, forward_left_cost_0, forward_left_cost_1 : natural range 0 to 511;
  signal forward_left_cost_2, forward_left_cost_3, forward_left_cost_4, forward_left_cost_5 : natural range 0 to 511;
  signal forward_left_cost_6, forward_left_cost_7, forward_left_cost_8, forward_left_cost_9 : natural range 0 to 511;
  signal forward_left_cost_10, forward_left_cost_11, forward_left_arrived_0 : natural range 0 to 511;
  signal forward_left_arrived_1, forward_left_arrived_2, forward_left_arrived_3 : natural range 0 to 511;
  signal forward_left_arrived_4, forward_left_arrived_5, forward_left_arrived_6 : natural range 0 to 511;
  signal forward_left_arrived_7, forward_left_arrived_8, forward_left_arrived_9 : natural range 0 to 511;
  signal forward_left_arrived_10, forward_left_arrived_11, forward_sum_0, forward_sum_1 : natural range 0 to 511;
  signal forward_sum_2, forward_sum_3, forward_sum_4, forward_sum_5, forward_sum_6 : natural range 0 to 511;
  signal forward_sum_7, forward_sum_8, forward_sum_9, forward_sum_10, forward_sum_11 : natural range 0 to 511;
  signal forward_left_room, forward_above_stay_0, forward_above_stay_1, forward_above_stay_2 : natural range 0 to 31;
  signal forward_above_stay_3, forward_above_stay_4, forward_above_stay_5, forward_above_stay_6 : natural range 0 to 31;
  signal forward_above_stay_7, forward_above_stay_8, forward_above_stay_9 : natural range 0 to 31;
  signal forward_above_stay_10, forward_above_stay_11 : natural range 0 to 31;
  signal forward_left_first_0, forward_left_first_1, forward_left_first_2, forward_above_ready_top : boolean;
  signal forward_above_comes_0, forward_above_comes_1, forward_above_comes_2, forward_above_comes_3 : boolean;
  signal forward_above_comes_4, forward_above_comes_5, forward_above_comes_6, forward_above_comes_7 : boolean;
  signal forward_above_comes_8, forward_above_comes_9, forward_above_writes_copy_0, forward_first_0 : boolean;
  signal forward_first_1, forward_first_2, forward_first_3, forward_first_4, forward_first_5, forward_first_6 : boolean;
  signal forward_first_7, forward_first_8 : boolean;
  signal forward_left_g_copy_0 : natural range 0 to 510;
  signal forward_above_delay_held_0, forward_above_delay_held_1, forward_above_delay_held_2 : unsigned(28 downto 0);
  signal forward_above_cost_0, forward_above_cost_1, forward_above_cost_2 : natural range 0 to 127;
  signal forward_above_cost_3, forward_above_cost_4, forward_above_cost_5 : natural range 0 to 127;
  signal forward_above_cost_6, forward_above_cost_7, forward_above_cost_8 : natural range 0 to 127;
  signal forward_above_cost_9, forward_above_cost_10, forward_above_cost_11 : natural range 0 to 127;
  signal forward_above_beside_0, forward_above_beside_1, forward_above_beside_2 : natural range 0 to 127;
  signal forward_above_beside_3, forward_above_beside_4, forward_above_beside_5 : natural range 0 to 127;
  signal forward_above_beside_6, forward_above_beside_7, forward_above_beside_8 : natural range 0 to 127;
  signal forward_above_beside_9, forward_above_beside_10, forward_above_beside_11 : natural range 0 to 127;
  signal forward_above_own_0, forward_above_own_2, forward_above_own_3, forward_above_own_4 : natural range 0 to 127;
  signal forward_above_own_5, forward_above_own_6, forward_above_own_7, forward_above_own_8 : natural range 0 to 127;
  signal forward_above_own_9, forward_above_own_11 : natural range 0 to 127;
  signal forward_above_step_0, forward_above_step_1, forward_above_step_2 : natural range 0 to 132;
  signal forward_above_step_3, forward_above_step_4, forward_above_step_5 : natural range 0 to 132;
  signal forward_above_step_6, forward_above_step_7, forward_above_step_8 : natural range 0 to 132;
  signal forward_above_step_9, forward_above_step_10, forward_above_step_11 : natural range 0 to 132;
  signal forward_above_column_0, forward_above_column_1, forward_above_column_2 : natural range 0 to 63;
  signal forward_above_column_3, forward_above_column_4, forward_above_column_5 : natural range 0 to 63;
  signal forward_above_column_6, forward_above_column_7, forward_above_column_8 : natural range 0 to 63;
  signal forward_above_column_9, forward_above_write_column, forward_cost_0_0, forward_cost_0_1 : natural range 0 to 63;
  signal forward_cost_0_2, forward_cost_0_3, forward_cost_0_4, forward_cost_0_5 : natural range 0 to 63;
  signal forward_cost_0_6, forward_cost_0_7, forward_cost_0_8, forward_cost_0_9 : natural range 0 to 63;
  signal forward_cost_0_10, forward_cost_0_11, forward_cost_1_0, forward_cost_1_1 : natural range 0 to 63;
  signal forward_cost_1_2, forward_cost_1_3, forward_cost_1_4, forward_cost_1_5 : natural range 0 to 63;
  signal forward_cost_1_6, forward_cost_1_7, forward_cost_1_8, forward_cost_1_9 : natural range 0 to 63;
  signal forward_cost_1_10, forward_cost_1_11, forward_cost_2_0, forward_cost_2_1 : natural range 0 to 63;
  signal forward_cost_2_2, forward_cost_2_3, forward_cost_2_4, forward_cost_2_5 : natural range 0 to 63;
  signal forward_cost_2_6, forward_cost_2_7, forward_cost_2_8, forward_cost_2_9 : natural range 0 to 63;
  signal forward_cost_2_10, forward_cost_2_11, forward_cost_3_0, forward_cost_3_1 : natural range 0 to 63;
  signal forward_cost_3_2, forward_cost_3_3, forward_cost_3_4, forward_cost_3_5 : natural range 0 to 63;
  signal forward_cost_3_6, forward_cost_3_7, forward_cost_3_8, forward_cost_3_9 : natural range 0 to 63;
  signal forward_cost_3_10, forward_cost_3_11 : natural range 0 to 63;
  -- sums
  signal sums_turn_read_sums_0, sums_turn_read_sums_1, sums_turn_read_sums_2 : unsigned(26 downto 0);
  signal sums_turn_read_sums_3, sums_sum_delay_held_0, sums_sum_delay_held_1 : unsigned(26 downto 0);
  signal sums_sum_delay_held_2, sums_sum_delay_held_3 : unsigned(26 downto 0);
  signal sums_turn_read_costs_0, sums_turn_read_costs_1 : unsigned(29 downto 0);
  signal sums_turn_read_costs_2 : unsigned(11 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(7 downto 0);
  signal sums_turn_ready_sums_0, sums_turn_ready_sums_1, sums_turn_ready_sums_2 : natural range 0 to 134217727;
  signal sums_turn_ready_sums_3, sums_turn_write_sums_0, sums_turn_write_sums_1 : natural range 0 to 134217727;
  signal sums_turn_write_sums_2, sums_turn_write_sums_3 : natural range 0 to 134217727;
  signal sums_turn_ready_costs_0, sums_turn_ready_costs_1, sums_turn_write_costs_0 : natural range 0 to 1073741823;
  signal sums_turn_write_costs_1 : natural range 0 to 1073741823;
  signal sums_turn_ready_costs_2, sums_turn_write_costs_2 : natural range 0 to 4095;
  signal sums_turn_ready_smallest_0, sums_turn_write_smallest_0, sums_right_start_cost_0 : natural range 0 to 255;
  signal sums_right_start_cost_1, sums_right_start_cost_2, sums_right_start_cost_3 : natural range 0 to 255;
  signal sums_right_start_cost_4, sums_right_start_cost_5, sums_right_start_cost_6 : natural range 0 to 255;
  signal sums_right_smallest : natural range 0 to 255;
  signal sums_turn_ready_first, sums_turn_writes_copy_0, sums_turn_waiting_first_0, sums_turn_waiting_first_1 : boolean;
  signal sums_turn_waiting_first_2, sums_turn_waiting_first_3, sums_right_first_0, sums_right_first_1 : boolean;
  signal sums_right_first_2, sums_tag_valid, sums_tag_map_column, sums_tag_output_column : boolean;
  signal sums_tag_first_column, sums_tag_start_of_frame, sums_tag_end_of_line, sums_tags_held_0_output_column : boolean;
  signal sums_tags_held_0_start_of_frame, sums_tags_held_0_end_of_line, sums_tags_held_1_output_column : boolean;
  signal sums_tags_held_1_start_of_frame, sums_tags_held_1_end_of_line, sums_tags_held_2_output_column : boolean;
  signal sums_tags_held_2_start_of_frame, sums_tags_held_2_end_of_line, sums_tags_held_3_output_column : boolean;
  signal sums_tags_held_3_start_of_frame, sums_tags_held_3_end_of_line, sums_tags_held_4_output_column : boolean;
  signal sums_tags_held_4_start_of_frame, sums_tags_held_4_end_of_line, sums_tags_held_5_output_column : boolean;
  signal sums_tags_held_5_start_of_frame, sums_tags_held_5_end_of_line, sums_tags_held_6_output_column : boolean;
  signal sums_tags_held_6_start_of_frame, sums_tags_held_6_end_of_line, sums_tags_held_7_output_column : boolean;
  signal sums_tags_held_7_start_of_frame, sums_tags_held_7_end_of_line, sums_tags_held_8_output_column : boolean;
  signal sums_tags_held_8_start_of_frame, sums_tags_held_8_end_of_line, sums_tags_held_9_output_column : boolean;
  signal sums_tags_held_9_start_of_frame, sums_tags_held_9_end_of_line, sums_tags_held_10_map_column : boolean;
  signal sums_tags_held_10_output_column, sums_tags_held_10_first_column, sums_tags_held_10_start_of_frame : boolean;
  signal sums_tags_held_10_end_of_line, sums_tags_held_11_map_column, sums_tags_held_11_output_column : boolean;
  signal sums_tags_held_11_first_column, sums_tags_held_11_start_of_frame, sums_tags_held_11_end_of_line : boolean;
  signal sums_tags_held_12_map_column, sums_tags_held_12_output_column, sums_tags_held_12_first_column : boolean;
  signal sums_tags_held_12_start_of_frame, sums_tags_held_12_end_of_line, sums_tags_held_13_map_column : boolean;
  signal sums_tags_held_13_output_column, sums_tags_held_13_first_column, sums_tags_held_13_start_of_frame : boolean;
  signal sums_tags_held_13_end_of_line, sums_tags_moved : boolean;
  signal sums_turn_place_0, sums_turn_place_1, sums_turn_place_2, sums_turn_place_3 : natural range 0 to 63;
  signal sums_turn_place_4, sums_turn_place_5, sums_turn_place_6, sums_turn_place_7 : natural range 0 to 63;
  signal sums_turn_place_8, sums_turn_write_place, sums_turn_waiting_read_place, sums_cost_0_0 : natural range 0 to 63;
  signal sums_cost_0_1, sums_cost_0_2, sums_cost_0_3, sums_cost_0_4, sums_cost_0_5 : natural range 0 to 63;
  signal sums_cost_0_6, sums_cost_0_7, sums_cost_0_8, sums_cost_0_9, sums_cost_0_10 : natural range 0 to 63;
  signal sums_cost_0_11, sums_cost_1_0, sums_cost_1_1, sums_cost_1_2, sums_cost_1_3 : natural range 0 to 63;
  signal sums_cost_1_4, sums_cost_1_5, sums_cost_1_6, sums_cost_1_7, sums_cost_1_8 : natural range 0 to 63;
  signal sums_cost_1_9, sums_cost_1_10, sums_cost_1_11 : natural range 0 to 63;
  signal sums_right_pair_0, sums_right_pair_1, sums_right_pair_2, sums_right_pair_3 : natural range 0 to 511;
  signal sums_right_pair_4, sums_right_pair_5, sums_right_tree_smallest_0 : natural range 0 to 511;
  signal sums_right_tree_smallest_1, sums_right_tree_smallest_2 : natural range 0 to 511;
  signal sums_right_tree_next_smallest_0, sums_right_tree_next_smallest_1 : natural range 0 to 511;
  signal sums_right_tree_next_next_smallest_0, sums_right_smallest_less : natural range 0 to 511;
  signal sums_right_g_less_copy_0, sums_right_stay_change_0, sums_right_stay_change_1 : natural range 0 to 511;
  signal sums_right_stay_change_2, sums_right_stay_change_3, sums_right_stay_change_4 : natural range 0 to 511;
  signal sums_right_stay_change_5, sums_right_stay_change_6, sums_right_stay_change_7 : natural range 0 to 511;
  signal sums_right_stay_change_8, sums_right_stay_change_9, sums_right_stay_change_10 : natural range 0 to 511;
  signal sums_right_stay_change_11, sums_right_step_change_0, sums_right_step_change_1 : natural range 0 to 511;
  signal sums_right_step_change_2, sums_right_step_change_3, sums_right_step_change_4 : natural range 0 to 511;
  signal sums_right_step_change_5, sums_right_step_change_6, sums_right_step_change_7 : natural range 0 to 511;
  signal sums_right_step_change_8, sums_right_step_change_9, sums_right_step_change_10 : natural range 0 to 511;
  signal sums_right_step_change_11, sums_right_cost_0, sums_right_cost_1, sums_right_cost_2 : natural range 0 to 511;
  signal sums_right_cost_3, sums_right_cost_4, sums_right_cost_5, sums_right_cost_6 : natural range 0 to 511;
  signal sums_right_cost_7, sums_right_cost_8, sums_right_cost_9, sums_right_cost_10 : natural range 0 to 511;
  signal sums_right_cost_11, sums_right_arrived_0, sums_right_arrived_1, sums_right_arrived_2 : natural range 0 to 511;
  signal sums_right_arrived_3, sums_right_arrived_4, sums_right_arrived_5 : natural range 0 to 511;
  signal sums_right_arrived_6, sums_right_arrived_7, sums_right_arrived_8 : natural range 0 to 511;
  signal sums_right_arrived_9, sums_right_arrived_10, sums_right_arrived_11 : natural range 0 to 511;
  signal sums_right_room : natural range 0 to 31;
  signal sums_right_g_copy_0 : natural range 0 to 510;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  signal sums_sum_0_0, sums_sum_0_1, sums_sum_0_2, sums_sum_0_3, sums_sum_0_4, sums_sum_0_5 : natural range 0 to 1022;
  signal sums_sum_0_6, sums_sum_0_7, sums_sum_0_8, sums_sum_0_9, sums_sum_0_10, sums_sum_0_11 : natural range 0 to 1022;
  -- winnersmask
  signal winnersmask_inside_0, winnersmask_inside_1, winnersmask_inside_2, winnersmask_inside_3 : boolean;
  signal winnersmask_inside_4, winnersmask_inside_5, winnersmask_inside_6, winnersmask_inside_7 : boolean;
  signal winnersmask_inside_8, winnersmask_inside_9, winnersmask_inside_10, winnersmask_inside_11 : boolean;
  signal winnersmask_column : natural range 0 to 63;
  -- winnersother
  signal winnersother_cost_0_1, winnersother_cost_0_2, winnersother_cost_0_3 : natural range 0 to 1022;
  signal winnersother_cost_0_4, winnersother_cost_0_5, winnersother_cost_0_6 : natural range 0 to 1022;
  signal winnersother_cost_0_7, winnersother_cost_0_8, winnersother_cost_0_9 : natural range 0 to 1022;
  signal winnersother_cost_0_10, winnersother_cost_0_11 : natural range 0 to 1022;
  signal winnersother_winner_0_0, winnersother_winner_0_1, winnersother_winner_0_2 : natural range 0 to 11;
  signal winnersother_winner_0_3, winnersother_winner_0_4, winnersother_winner_0_5 : natural range 0 to 11;
  signal winnersother_winner_0_6, winnersother_winner_0_7, winnersother_winner_0_8 : natural range 0 to 11;
  signal winnersother_winner_0_9, winnersother_winner_0_10, winnersother_winner_0_11 : natural range 0 to 11;
  signal winnersother_winner_out_0 : natural range 0 to 11;
  -- winnerswinner1
  signal winnerswinner1_held_0_0, winnerswinner1_held_0_1, winnerswinner1_held_0_2 : natural range 0 to 1023;
  signal winnerswinner1_held_0_3, winnerswinner1_held_0_4, winnerswinner1_held_0_5 : natural range 0 to 1023;
  signal winnerswinner1_held_0_6, winnerswinner1_held_0_7, winnerswinner1_held_0_8 : natural range 0 to 1023;
  signal winnerswinner1_held_0_9, winnerswinner1_held_0_10, winnerswinner1_held_0_11 : natural range 0 to 1023;
  signal winnerswinner1_best_cost_0_0, winnerswinner1_best_cost_0_1 : natural range 0 to 1023;
  signal winnerswinner1_best_cost_0_2, winnerswinner1_best_cost_0_3 : natural range 0 to 1023;
  signal winnerswinner1_best_cost_0_4, winnerswinner1_best_cost_0_5 : natural range 0 to 1023;
  signal winnerswinner1_best_below_0_0, winnerswinner1_best_below_0_1 : natural range 0 to 1023;
  signal winnerswinner1_best_below_0_2, winnerswinner1_best_below_0_3 : natural range 0 to 1023;
  signal winnerswinner1_best_below_0_4, winnerswinner1_best_below_0_5 : natural range 0 to 1023;
  signal winnerswinner1_best_above_0_0, winnerswinner1_best_above_0_1 : natural range 0 to 1023;
  signal winnerswinner1_best_above_0_2, winnerswinner1_best_above_0_3 : natural range 0 to 1023;
  signal winnerswinner1_best_above_0_4, winnerswinner1_best_above_0_5 : natural range 0 to 1023;
  signal winnerswinner1_best_late_cost_0_0, winnerswinner1_best_late_cost_0_1 : natural range 0 to 1023;
  signal winnerswinner1_best_late_cost_0_2, winnerswinner1_best_late_cost_0_3 : natural range 0 to 1023;
  signal winnerswinner1_best_late_cost_0_4, winnerswinner1_best_late_cost_0_5 : natural range 0 to 1023;
  signal winnerswinner1_best_but_first_0_1, winnerswinner1_best_but_first_0_2 : natural range 0 to 1023;
  signal winnerswinner1_best_but_first_0_3, winnerswinner1_best_but_first_0_4 : natural range 0 to 1023;
  signal winnerswinner1_best_but_first_0_5, winnerswinner1_best_but_last_0_0 : natural range 0 to 1023;
  signal winnerswinner1_best_but_last_0_1, winnerswinner1_best_but_last_0_2 : natural range 0 to 1023;
  signal winnerswinner1_best_but_last_0_3, winnerswinner1_best_but_last_0_4 : natural range 0 to 1023;
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_place_0_2, winnerswinner1_best_place_0_4 : boolean;
  signal winnerswinner1_tag_valid, winnerswinner1_tag_map_column, winnerswinner1_tag_output_column : boolean;
  signal winnerswinner1_tag_start_of_frame, winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 11;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0_0, winnerswinner2_best_cost_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_cost_0_2, winnerswinner2_best_below_0_0 : natural range 0 to 1023;
  signal winnerswinner2_best_below_0_1, winnerswinner2_best_below_0_2 : natural range 0 to 1023;
  signal winnerswinner2_best_above_0_0, winnerswinner2_best_above_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_above_0_2, winnerswinner2_best_first_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_first_0_2, winnerswinner2_best_last_0_0 : natural range 0 to 1023;
  signal winnerswinner2_best_last_0_1, winnerswinner2_best_late_cost_0_0 : natural range 0 to 1023;
  signal winnerswinner2_best_late_cost_0_1, winnerswinner2_best_late_cost_0_2 : natural range 0 to 1023;
  signal winnerswinner2_best_second_0_0, winnerswinner2_best_second_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_second_0_2, winnerswinner2_best_but_first_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_but_first_0_2, winnerswinner2_best_but_last_0_0 : natural range 0 to 1023;
  signal winnerswinner2_best_but_last_0_1 : natural range 0 to 1023;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner2_best_place_0_0, winnerswinner2_best_place_0_1, winnerswinner2_best_place_0_2 : boolean;
  signal winnerswinner2_best_at_start_0_0, winnerswinner2_best_at_start_0_1, winnerswinner2_best_at_start_0_2 : boolean;
  signal winnerswinner2_best_at_end_0_0, winnerswinner2_best_at_end_0_1, winnerswinner2_best_at_end_0_2 : boolean;
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0_0, winnerswinner3_best_below_0_0 : natural range 0 to 1023;
  signal winnerswinner3_best_below_0_1, winnerswinner3_best_above_0_0 : natural range 0 to 1023;
  signal winnerswinner3_best_above_0_1, winnerswinner3_best_first_0_1 : natural range 0 to 1023;
  signal winnerswinner3_best_last_0_0, winnerswinner3_best_late_cost_0_0 : natural range 0 to 1023;
  signal winnerswinner3_best_late_cost_0_1, winnerswinner3_best_second_0_0 : natural range 0 to 1023;
  signal winnerswinner3_best_second_0_1, winnerswinner3_best_but_first_0_1 : natural range 0 to 1023;
  signal winnerswinner3_best_but_last_0_0 : natural range 0 to 1023;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_index_0_1 : natural range 0 to 11;
  signal winnerswinner3_best_place_0_0, winnerswinner3_best_at_start_0_0, winnerswinner3_best_at_end_0_0 : boolean;
  signal winnerswinner3_tag_valid, winnerswinner3_tag_map_column, winnerswinner3_tag_output_column : boolean;
  signal winnerswinner3_tag_start_of_frame, winnerswinner3_tag_end_of_line : boolean;
  -- winnerswinner4
  signal winnerswinner4_best_cost_0_0, winnerswinner4_best_below_0_0 : natural range 0 to 1023;
  signal winnerswinner4_best_above_0_0, winnerswinner4_best_late_cost_0_0 : natural range 0 to 1023;
  signal winnerswinner4_best_second_0_0 : natural range 0 to 1023;
  signal winnerswinner4_best_index_0_0 : natural range 0 to 11;
  signal winnerswinner4_best_place_0_0, winnerswinner4_best_at_start_0_0, winnerswinner4_best_at_end_0_0 : boolean;
  signal winnerswinner4_tag_valid, winnerswinner4_tag_map_column, winnerswinner4_tag_output_column : boolean;
  signal winnerswinner4_tag_start_of_frame, winnerswinner4_tag_end_of_line : boolean;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 11;
  signal winners_best_below_0_0, winners_best_above_0_0, winners_best_late_cost_0_0 : natural range 0 to 1023;
  signal winners_best_second_0_0 : natural range 0 to 1023;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 11;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 11;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 11;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 11;
  signal refinement_passed_3_0, refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0 : boolean;
  signal refinement_passed_7_0, refinement_passed_8_0, refinement_passed_9_0, refinement_passed_10_0 : boolean;
  signal refinement_passed_11_0, refinement_tag_0_valid, refinement_tag_0_map_column : boolean;
  signal refinement_tag_0_output_column, refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line : boolean;
  signal refinement_tag_1_valid, refinement_tag_1_map_column, refinement_tag_1_output_column : boolean;
  signal refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line, refinement_tag_2_valid : boolean;
  signal refinement_tag_2_map_column, refinement_tag_2_output_column, refinement_tag_2_start_of_frame : boolean;
  signal refinement_tag_2_end_of_line, refinement_tag_3_valid, refinement_tag_3_map_column : boolean;
  signal refinement_tag_3_output_column, refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line : boolean;
  signal refinement_tag_4_valid, refinement_tag_4_map_column, refinement_tag_4_output_column : boolean;
  signal refinement_tag_4_start_of_frame, refinement_tag_4_end_of_line, refinement_tag_5_valid : boolean;
  signal refinement_tag_5_map_column, refinement_tag_5_output_column, refinement_tag_5_start_of_frame : boolean;
  signal refinement_tag_5_end_of_line, refinement_tag_6_valid, refinement_tag_6_map_column : boolean;
  signal refinement_tag_6_output_column, refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line : boolean;
  signal refinement_tag_7_valid, refinement_tag_7_map_column, refinement_tag_7_output_column : boolean;
  signal refinement_tag_7_start_of_frame, refinement_tag_7_end_of_line, refinement_tag_8_valid : boolean;
  signal refinement_tag_8_map_column, refinement_tag_8_output_column, refinement_tag_8_start_of_frame : boolean;
  signal refinement_tag_8_end_of_line, refinement_tag_9_valid, refinement_tag_9_map_column : boolean;
  signal refinement_tag_9_output_column, refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line : boolean;
  signal refinement_tag_10_valid, refinement_tag_10_map_column, refinement_tag_10_output_column : boolean;
  signal refinement_tag_10_start_of_frame, refinement_tag_10_end_of_line, refinement_tag_11_valid : boolean;
  signal refinement_tag_11_map_column, refinement_tag_11_output_column, refinement_tag_11_start_of_frame : boolean;
  signal refinement_tag_11_end_of_line, refinement_alone_0_0, refinement_alone_1_0, refinement_negative_0_0 : boolean;
  signal refinement_negative_1_0, refinement_negative_2_0, refinement_negative_3_0, refinement_negative_4_0 : boolean;
  signal refinement_negative_5_0, refinement_negative_6_0, refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_gap_0, refinement_scaled_gap_0, refinement_below_0, refinement_above_0 : natural range 0 to 1023;
  signal refinement_u_0, refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 1023;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 1023;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 1023;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 1023;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 1023;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 1023;
  signal refinement_scaled_cost_0 : natural range 0 to 2;
  signal refinement_difference_0 : integer range -1023 to 1023;
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_1_0, leftright_other_2_0, leftright_other_3_0, leftright_other_4_0 : natural range 0 to 11;
  signal leftright_other_5_0, leftright_other_6_0, leftright_other_7_0, leftright_other_8_0 : natural range 0 to 11;
  signal leftright_other_9_0, leftright_other_10_0, leftright_other_11_0, leftright_other_12_0 : natural range 0 to 11;
  signal leftright_other_13_0, leftright_other_14_0, leftright_other_15_0 : natural range 0 to 11;
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_position : natural range 0 to 15;
  signal leftright_held_position, leftright_address_0, leftright_asking_disparity_0 : natural range 0 to 15;
  signal leftright_answered_disparity_0, leftright_checked_disparity_0 : natural range 0 to 15;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_output_column : boolean;
  signal leftright_asking_tag_start_of_frame, leftright_asking_tag_end_of_line, leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_map_column : boolean;
  signal leftright_answered_tag_output_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_output_column : boolean;
  signal leftright_checked_tag_start_of_frame, leftright_checked_tag_end_of_line : boolean;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_found_0 : unsigned(3 downto 0);
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 63;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0 : natural range 0 to 16143;
  signal turn_read_words_0 : unsigned(13 downto 0);
  signal turn_ready : natural range 0 to 16383;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 63;
  signal map_sorted_column : natural range 0 to 63;
  signal map_counter_group : natural range 0 to 15;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b, map_column_passed_0_0, map_column_passed_1_0, map_comparing_arrives : boolean;
  signal map_comparing_behind, map_comparing_top, map_comparing_output, map_sorted_arrives, map_sorted_behind : boolean;
  signal map_sorted_top, map_sorted_output, map_passed_0_0, map_passed_1_0, map_window_complete : boolean;
  signal map_window_first, map_window_last, map_of_low_0_b_below_a, map_of_low_0_c_below_a : boolean;
  signal map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a : boolean;
  signal map_of_middle_0_c_below_b, map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b : boolean;
  signal map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b, map_waiting_0_complete : boolean;
  signal map_waiting_0_first, map_waiting_0_last, map_waiting_1_complete, map_waiting_1_first : boolean;
  signal map_waiting_1_last, map_waiting_2_complete, map_waiting_2_first, map_waiting_2_last : boolean;
  signal map_waiting_passed_0_0, map_waiting_passed_1_0, map_waiting_passed_2_0, map_out_passed_0 : boolean;
  signal map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0, map_column_2 : natural range 0 to 65535;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_column_1 : natural range 0 to 8191;
  signal map_of_column_0_a, map_of_column_0_b : natural range 0 to 4095;
  signal map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 32767;
  signal map_low_0_0, map_low_1_0, map_low_2_0, map_middle_0_0, map_middle_1_0 : natural range 0 to 32767;
  signal map_middle_2_0, map_high_0_0, map_high_1_0, map_high_2_0, map_of_low_0_a : natural range 0 to 32767;
  signal map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 32767;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 32767;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 32767;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 32767;
  -- other
  signal other_0 : natural range 0 to 8190;
  signal other_1, other_2 : unsigned(48 downto 0);
  signal other_3 : natural range 0 to 67108863;
  signal other_4 : unsigned(25 downto 0);
  signal other_5 : natural range 0 to 254;
  signal other_6 : natural range 0 to 252;
  signal other_7 : natural range 0 to 248;
  signal other_8 : natural range 0 to 240;
  signal other_9 : natural range 0 to 224;
  signal other_10 : natural range 0 to 192;
  signal other_11 : natural range 0 to 128;
  signal other_4_memory_read_enable : boolean;
  signal other_4_memory_read_address : unsigned(5 downto 0);
  signal other_4_memory_write_address : unsigned(5 downto 0);
  signal other_4_memory_write_data : unsigned(25 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal turn_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(13 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(3 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);
  signal sums_sum_delay_held_3_memory_read_enable : boolean;
  signal sums_sum_delay_held_3_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_3_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_3_memory_write_data : unsigned(26 downto 0);
  signal sums_sum_delay_held_2_memory_read_enable : boolean;
  signal sums_sum_delay_held_2_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_data : unsigned(26 downto 0);
  signal sums_sum_delay_held_1_memory_read_enable : boolean;
  signal sums_sum_delay_held_1_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_data : unsigned(26 downto 0);
  signal sums_sum_delay_held_0_memory_read_enable : boolean;
  signal sums_sum_delay_held_0_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_data : unsigned(26 downto 0);
  signal sums_turn_read_sums_3_memory_read_enable : boolean;
  signal sums_turn_read_sums_3_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_3_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_3_memory_write_data : unsigned(26 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_2_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(26 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_1_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(26 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_0_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(26 downto 0);
  signal sums_turn_read_costs_2_memory_read_enable : boolean;
  signal sums_turn_read_costs_2_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_2_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_2_memory_write_data : unsigned(11 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_1_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_0_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(5 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(5 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(7 downto 0);
  signal forward_above_read_words_1_memory_read_enable : boolean;
  signal forward_above_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal forward_above_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal forward_above_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_0_memory_read_enable : boolean;
  signal forward_above_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal forward_above_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal forward_above_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal forward_above_delay_held_2_memory_read_enable : boolean;
  signal forward_above_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_data : unsigned(28 downto 0);
  signal forward_above_delay_held_1_memory_read_enable : boolean;
  signal forward_above_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_data : unsigned(28 downto 0);
  signal forward_above_delay_held_0_memory_read_enable : boolean;
  signal forward_above_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_data : unsigned(28 downto 0);
  signal forward_cost_delay_held_2_memory_read_enable : boolean;
  signal forward_cost_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_data : unsigned(13 downto 0);
  signal forward_cost_delay_held_1_memory_read_enable : boolean;
  signal forward_cost_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_0_memory_read_enable : boolean;
  signal forward_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(23 downto 0);

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

  other_4_memory_read_enable <= true;
  other_4_memory_read_address <= to_unsigned(map_counter_column, 6);
  other_4_memory_write_address <= to_unsigned(map_at_column, 6);
  other_4_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  other_4_memory : entity work.line_memory
    generic map (depth => 38, width => 26, address_bits => 6)
    port map (
      clock => clock, read_enable => other_4_memory_read_enable,
      read_address => other_4_memory_read_address, read_data => other_4,
      write_address => other_4_memory_write_address, write_data => other_4_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 6);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 6);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 14);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 38, width => 14, address_bits => 6)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 4);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_15_0, 4);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 4, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 4);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 4);
  leftright_held_0_memory_write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned(as_number(refinement_passed_11_0), 1) & to_unsigned(refinement_disparity_11_0, 8) & to_unsigned(as_number(refinement_tag_11_end_of_line), 1) & to_unsigned(as_number(refinement_tag_11_start_of_frame), 1) & to_unsigned(as_number(refinement_tag_11_output_column), 1) & to_unsigned(as_number(refinement_tag_11_map_column), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 12, width => 18, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  sums_sum_delay_held_3_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_3_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_3_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_3_memory_write_data <= to_unsigned(sums_turn_ready_sums_3, 27);
  sums_sum_delay_held_3_memory : entity work.line_memory
    generic map (depth => 4, width => 27, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_3_memory_read_enable,
      read_address => sums_sum_delay_held_3_memory_read_address, read_data => sums_sum_delay_held_3,
      write_address => sums_sum_delay_held_3_memory_write_address, write_data => sums_sum_delay_held_3_memory_write_data);

  sums_sum_delay_held_2_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_2_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_2_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_2_memory_write_data <= to_unsigned(sums_turn_ready_sums_2, 27);
  sums_sum_delay_held_2_memory : entity work.line_memory
    generic map (depth => 4, width => 27, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_2_memory_read_enable,
      read_address => sums_sum_delay_held_2_memory_read_address, read_data => sums_sum_delay_held_2,
      write_address => sums_sum_delay_held_2_memory_write_address, write_data => sums_sum_delay_held_2_memory_write_data);

  sums_sum_delay_held_1_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_1_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_1_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_1_memory_write_data <= to_unsigned(sums_turn_ready_sums_1, 27);
  sums_sum_delay_held_1_memory : entity work.line_memory
    generic map (depth => 4, width => 27, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_1_memory_read_enable,
      read_address => sums_sum_delay_held_1_memory_read_address, read_data => sums_sum_delay_held_1,
      write_address => sums_sum_delay_held_1_memory_write_address, write_data => sums_sum_delay_held_1_memory_write_data);

  sums_sum_delay_held_0_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_0_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_0_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_0_memory_write_data <= to_unsigned(sums_turn_ready_sums_0, 27);
  sums_sum_delay_held_0_memory : entity work.line_memory
    generic map (depth => 4, width => 27, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_0_memory_read_enable,
      read_address => sums_sum_delay_held_0_memory_read_address, read_data => sums_sum_delay_held_0,
      write_address => sums_sum_delay_held_0_memory_write_address, write_data => sums_sum_delay_held_0_memory_write_data);

  sums_turn_read_sums_3_memory_read_enable <= true;
  sums_turn_read_sums_3_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_sums_3_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_sums_3_memory_write_data <= to_unsigned(sums_turn_write_sums_3, 27);
  sums_turn_read_sums_3_memory : entity work.line_memory
    generic map (depth => 38, width => 27, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_3_memory_read_enable,
      read_address => sums_turn_read_sums_3_memory_read_address, read_data => sums_turn_read_sums_3,
      write_address => sums_turn_read_sums_3_memory_write_address, write_data => sums_turn_read_sums_3_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_sums_2_memory_write_data <= to_unsigned(sums_turn_write_sums_2, 27);
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 38, width => 27, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums_2,
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_sums_1_memory_write_data <= to_unsigned(sums_turn_write_sums_1, 27);
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 38, width => 27, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums_1,
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_sums_0_memory_write_data <= to_unsigned(sums_turn_write_sums_0, 27);
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 38, width => 27, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums_0,
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_2_memory_read_enable <= true;
  sums_turn_read_costs_2_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_costs_2_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_costs_2_memory_write_data <= to_unsigned(sums_turn_write_costs_2, 12);
  sums_turn_read_costs_2_memory : entity work.line_memory
    generic map (depth => 38, width => 12, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_2_memory_read_enable,
      read_address => sums_turn_read_costs_2_memory_read_address, read_data => sums_turn_read_costs_2,
      write_address => sums_turn_read_costs_2_memory_write_address, write_data => sums_turn_read_costs_2_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_costs_1_memory_write_data <= to_unsigned(sums_turn_write_costs_1, 30);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 38, width => 30, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs_1,
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_costs_0_memory_write_data <= to_unsigned(sums_turn_write_costs_0, 30);
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 38, width => 30, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs_0,
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 6);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 6);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 8);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 38, width => 8, address_bits => 6)
    port map (
      clock => clock, read_enable => sums_turn_read_smallest_0_memory_read_enable,
      read_address => sums_turn_read_smallest_0_memory_read_address, read_data => sums_turn_read_smallest_0,
      write_address => sums_turn_read_smallest_0_memory_write_address, write_data => sums_turn_read_smallest_0_memory_write_data);

  forward_above_read_words_1_memory_read_enable <= true;
  forward_above_read_words_1_memory_read_address <= to_unsigned(entry_next_column, 6);
  forward_above_read_words_1_memory_write_address <= to_unsigned(forward_above_write_column, 6);
  forward_above_read_words_1_memory_write_data <= forward_above_write_words_1;
  forward_above_read_words_1_memory : entity work.line_memory
    generic map (depth => 38, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => forward_above_read_words_1_memory_read_enable,
      read_address => forward_above_read_words_1_memory_read_address, read_data => forward_above_read_words_1,
      write_address => forward_above_read_words_1_memory_write_address, write_data => forward_above_read_words_1_memory_write_data);

  forward_above_read_words_0_memory_read_enable <= true;
  forward_above_read_words_0_memory_read_address <= to_unsigned(entry_next_column, 6);
  forward_above_read_words_0_memory_write_address <= to_unsigned(forward_above_write_column, 6);
  forward_above_read_words_0_memory_write_data <= forward_above_write_words_0;
  forward_above_read_words_0_memory : entity work.line_memory
    generic map (depth => 38, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => forward_above_read_words_0_memory_read_enable,
      read_address => forward_above_read_words_0_memory_read_address, read_data => forward_above_read_words_0,
      write_address => forward_above_read_words_0_memory_write_address, write_data => forward_above_read_words_0_memory_write_data);

  forward_above_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_2_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_above_delay_held_2_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_above_delay_held_2_memory_write_data <= ((to_unsigned(forward_above_total_11, 8) & to_unsigned(to_integer(((to_unsigned(forward_above_total_9, 8) & to_unsigned(0, 7)) or (to_unsigned(forward_above_total_8, 15)))), 21)) or (to_unsigned(forward_above_total_10, 15) & to_unsigned(0, 14)));
  forward_above_delay_held_2_memory : entity work.line_memory
    generic map (depth => 5, width => 29, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_2_memory_read_enable,
      read_address => forward_above_delay_held_2_memory_read_address, read_data => forward_above_delay_held_2,
      write_address => forward_above_delay_held_2_memory_write_address, write_data => forward_above_delay_held_2_memory_write_data);

  forward_above_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_1_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_above_delay_held_1_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_above_delay_held_1_memory_write_data <= ((to_unsigned(forward_above_total_7, 8) & to_unsigned(to_integer(((to_unsigned(forward_above_total_5, 8) & to_unsigned(0, 7)) or (to_unsigned(forward_above_total_4, 15)))), 21)) or (to_unsigned(forward_above_total_6, 15) & to_unsigned(0, 14)));
  forward_above_delay_held_1_memory : entity work.line_memory
    generic map (depth => 5, width => 29, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_1_memory_read_enable,
      read_address => forward_above_delay_held_1_memory_read_address, read_data => forward_above_delay_held_1,
      write_address => forward_above_delay_held_1_memory_write_address, write_data => forward_above_delay_held_1_memory_write_data);

  forward_above_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_above_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_above_delay_held_0_memory_write_data <= ((to_unsigned(forward_above_total_3, 8) & to_unsigned(to_integer(((to_unsigned(forward_above_total_1, 8) & to_unsigned(0, 7)) or (to_unsigned(forward_above_total_0, 15)))), 21)) or (to_unsigned(forward_above_total_2, 15) & to_unsigned(0, 14)));
  forward_above_delay_held_0_memory : entity work.line_memory
    generic map (depth => 5, width => 29, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_0_memory_read_enable,
      read_address => forward_above_delay_held_0_memory_read_address, read_data => forward_above_delay_held_0,
      write_address => forward_above_delay_held_0_memory_write_address, write_data => forward_above_delay_held_0_memory_write_data);

  forward_cost_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_2_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_cost_delay_held_2_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_cost_delay_held_2_memory_write_data <= ((to_unsigned(entry_cost_11, 8) & to_unsigned(0, 6)) or (to_unsigned(entry_cost_10, 14)));
  forward_cost_delay_held_2_memory : entity work.line_memory
    generic map (depth => 5, width => 14, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_2_memory_read_enable,
      read_address => forward_cost_delay_held_2_memory_read_address, read_data => forward_cost_delay_held_2,
      write_address => forward_cost_delay_held_2_memory_write_address, write_data => forward_cost_delay_held_2_memory_write_data);

  forward_cost_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_1_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_cost_delay_held_1_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_cost_delay_held_1_memory_write_data <= ((((((((to_unsigned(entry_cost_8, 14) & to_unsigned(0, 18)) or (to_unsigned(entry_cost_9, 8) & to_unsigned(0, 24)))) or (to_unsigned(entry_cost_7, 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost_5, 32)))) or (to_unsigned(entry_cost_6, 26) & to_unsigned(0, 6)));
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 5, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held_1,
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= ((((((((to_unsigned(entry_cost_3, 14) & to_unsigned(0, 18)) or (to_unsigned(entry_cost_4, 8) & to_unsigned(0, 24)))) or (to_unsigned(entry_cost_2, 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost_0, 32)))) or (to_unsigned(entry_cost_1, 26) & to_unsigned(0, 6)));
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 5, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held_0,
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 22);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 22, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned((rows_reference_rows_write_words_0 mod 4194304), 22);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 22, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 24);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 24);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_counter_group_choice_2, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choice_2, raster_place_group_is_equal : boolean;
    variable raster_place_group_is_equal_2, raster_place_group_all, raster_place_group_is_equal_3 : boolean;
    variable raster_place_group_choice_2, raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable raster_place_next_frame_choice_3, raster_place_next_frame_choice_4 : boolean;
    variable delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, delay_tag_first_column_is_equal, slice0mask_inside_0_choice : boolean;
    variable slice0mask_inside_1_choice, slice0mask_inside_2_choice, slice0mask_inside_3_choice : boolean;
    variable slice0mask_inside_4_choice, slice1mask_inside_0_all, slice1mask_inside_0_choice : boolean;
    variable slice1mask_inside_1_choice, slice1mask_inside_2_choice, slice1mask_inside_3_choice : boolean;
    variable slice1mask_inside_4_choice, slice2mask_inside_0_all, slice2mask_inside_0_choice : boolean;
    variable slice2mask_inside_1_choice, entry_order_falls_any, entry_order_falls_all : boolean;
    variable entry_order_complete_all, entry_order_complete_any, entry_order_turned_output_column_choice : boolean;
    variable forward_left_start_cost_0_is_less, forward_left_start_cost_0_is_less_2 : boolean;
    variable forward_above_writes_copy_0_choice, sums_right_start_cost_0_is_less : boolean;
    variable sums_right_start_cost_0_is_less_2, sums_turn_writes_copy_0_choice, winnersmask_inside_11_choice : boolean;
    variable winnersother_cost_0_1_choice, winnersother_cost_0_2_choice, winnersother_cost_0_3_choice : boolean;
    variable winnersother_cost_0_4_choice, winnersother_cost_0_5_choice, winnersother_cost_0_6_choice : boolean;
    variable winnersother_cost_0_7_choice, winnersother_cost_0_8_choice, winnersother_cost_0_9_choice : boolean;
    variable winnersother_cost_0_10_choice, winnersother_cost_0_11_all, winnersother_winner_0_0_choice : boolean;
    variable winnerswinner1_best_cost_0_0_is_less, winnerswinner1_best_cost_0_1_is_less : boolean;
    variable winnerswinner1_best_cost_0_2_is_less, winnerswinner1_best_cost_0_3_is_less : boolean;
    variable winnerswinner1_best_cost_0_4_is_less, winnerswinner1_best_cost_0_5_is_less : boolean;
    variable winnerswinner2_best_cost_0_0_is_less, winnerswinner2_best_cost_0_1_is_less : boolean;
    variable winnerswinner2_best_cost_0_2_is_less, winnerswinner2_best_below_0_0_is_equal : boolean;
    variable winnerswinner2_best_below_0_1_is_equal, winnerswinner2_best_below_0_2_is_equal : boolean;
    variable winnerswinner3_best_cost_0_0_is_less, winnerswinner3_best_below_0_0_is_equal : boolean;
    variable winnerswinner3_best_above_0_0_is_equal, winnerswinner4_best_cost_0_0_is_less : boolean;
    variable winnerswinner4_best_below_0_0_is_equal, winnerswinner4_best_above_0_0_is_equal : boolean;
    variable refinement_below_0_differs, refinement_below_0_differs_2, refinement_below_0_all : boolean;
    variable refinement_above_0_choice, refinement_divisor_0_0_is_less, leftright_holds_winners_all : boolean;
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_is_equal, turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choice_2, turn_ready_tag_row_start_is_equal_2 : boolean;
    variable turn_ready_tag_row_start_all, turn_ready_tag_row_start_choice_3, turn_ready_tag_row_start_all_2 : boolean;
    variable map_counter_group_is_equal, map_line_ended_choice, map_at_arrives_value : boolean;
    variable map_window_complete_choice, map_window_complete_choice_2, map_low_1_0_all, map_low_0_0_all : boolean;
    variable transform_counter_group_choice, raster_place_group_choice, map_counter_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 15;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable map_counter_group_choice_2, map_counter_group_choice_3 : natural range 0 to 15;
    variable transform_left_filter_feature_0_choice : natural range 0 to 65535;
    variable transform_left_filter_feature_0_choice_2 : natural range 0 to 65535;
    variable transform_right_filter_feature_0_choice : natural range 0 to 2047;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 2047;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 4095;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 4095;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 4095;
    variable transform_right_filter_column_0_0_choice_2, map_of_column_0_a_choice : natural range 0 to 4095;
    variable transform_left_filter_column_0_0_sum, transform_right_filter_column_0_0_sum : natural range 0 to 8190;
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 63;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 37;
    variable forward_left_pair_0_choice, forward_left_pair_1_choice : natural range 0 to 511;
    variable forward_left_pair_2_choice, forward_left_pair_3_choice : natural range 0 to 511;
    variable forward_left_pair_4_choice, forward_left_pair_5_choice : natural range 0 to 511;
    variable forward_left_cost_0_choice, forward_left_cost_0_choice_2 : natural range 0 to 511;
    variable forward_left_cost_1_choice, forward_left_cost_1_choice_2 : natural range 0 to 511;
    variable forward_left_cost_2_choice, forward_left_cost_2_choice_2 : natural range 0 to 511;
    variable forward_left_cost_3_choice, forward_left_cost_3_choice_2 : natural range 0 to 511;
    variable forward_left_cost_4_choice, forward_left_cost_4_choice_2 : natural range 0 to 511;
    variable forward_left_cost_5_choice, forward_left_cost_5_choice_2 : natural range 0 to 511;
    variable forward_left_cost_6_choice, forward_left_cost_6_choice_2 : natural range 0 to 511;
    variable forward_left_cost_7_choice, forward_left_cost_7_choice_2 : natural range 0 to 511;
    variable forward_left_cost_8_choice, forward_left_cost_8_choice_2 : natural range 0 to 511;
    variable forward_left_cost_9_choice, forward_left_cost_9_choice_2 : natural range 0 to 511;
    variable forward_left_cost_10_choice, forward_left_cost_10_choice_2 : natural range 0 to 511;
    variable forward_left_cost_11_choice, forward_left_cost_11_choice_2 : natural range 0 to 511;
    variable forward_left_arrived_0_choice, forward_left_arrived_1_choice : natural range 0 to 511;
    variable forward_left_arrived_2_choice, forward_left_arrived_3_choice : natural range 0 to 511;
    variable forward_left_arrived_3_choice_2, forward_left_arrived_4_choice : natural range 0 to 511;
    variable forward_left_arrived_4_choice_2, forward_left_arrived_5_choice : natural range 0 to 511;
    variable forward_left_arrived_6_choice, forward_left_arrived_7_choice : natural range 0 to 511;
    variable forward_left_arrived_7_choice_2, forward_left_arrived_8_choice : natural range 0 to 511;
    variable forward_left_arrived_8_choice_2, forward_left_arrived_9_choice : natural range 0 to 511;
    variable forward_left_arrived_10_choice, forward_left_arrived_11_choice : natural range 0 to 511;
    variable sums_right_pair_0_choice, sums_right_pair_1_choice, sums_right_pair_2_choice : natural range 0 to 511;
    variable sums_right_pair_3_choice, sums_right_pair_4_choice, sums_right_pair_5_choice : natural range 0 to 511;
    variable sums_right_cost_0_choice, sums_right_cost_0_choice_2, sums_right_cost_1_choice : natural range 0 to 511;
    variable sums_right_cost_1_choice_2, sums_right_cost_2_choice, sums_right_cost_2_choice_2 : natural range 0 to 511;
    variable sums_right_cost_3_choice, sums_right_cost_3_choice_2, sums_right_cost_4_choice : natural range 0 to 511;
    variable sums_right_cost_4_choice_2, sums_right_cost_5_choice, sums_right_cost_5_choice_2 : natural range 0 to 511;
    variable sums_right_cost_6_choice, sums_right_cost_6_choice_2, sums_right_cost_7_choice : natural range 0 to 511;
    variable sums_right_cost_7_choice_2, sums_right_cost_8_choice, sums_right_cost_8_choice_2 : natural range 0 to 511;
    variable sums_right_cost_9_choice, sums_right_cost_9_choice_2, sums_right_cost_10_choice : natural range 0 to 511;
    variable sums_right_cost_10_choice_2, sums_right_cost_11_choice : natural range 0 to 511;
    variable sums_right_cost_11_choice_2, sums_right_arrived_0_choice : natural range 0 to 511;
    variable sums_right_arrived_1_choice, sums_right_arrived_2_choice : natural range 0 to 511;
    variable sums_right_arrived_3_choice, sums_right_arrived_3_choice_2 : natural range 0 to 511;
    variable sums_right_arrived_4_choice, sums_right_arrived_4_choice_2 : natural range 0 to 511;
    variable sums_right_arrived_5_choice, sums_right_arrived_6_choice : natural range 0 to 511;
    variable sums_right_arrived_7_choice, sums_right_arrived_7_choice_2 : natural range 0 to 511;
    variable sums_right_arrived_8_choice, sums_right_arrived_8_choice_2 : natural range 0 to 511;
    variable sums_right_arrived_9_choice, sums_right_arrived_10_choice : natural range 0 to 511;
    variable sums_right_arrived_11_choice : natural range 0 to 511;
    variable forward_left_start_cost_0_choice, forward_left_start_cost_0_choice_2 : natural range 0 to 255;
    variable sums_right_start_cost_0_choice, sums_right_start_cost_0_choice_2 : natural range 0 to 255;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable forward_left_room_choice, forward_left_room_choice_2, forward_above_total_0_choice : natural range 0 to 31;
    variable forward_above_total_1_choice, forward_above_total_2_choice : natural range 0 to 31;
    variable forward_above_total_3_choice, forward_above_total_4_choice : natural range 0 to 31;
    variable forward_above_total_5_choice, forward_above_total_6_choice : natural range 0 to 31;
    variable forward_above_total_7_choice, forward_above_total_8_choice : natural range 0 to 31;
    variable forward_above_total_9_choice, forward_above_total_10_choice : natural range 0 to 31;
    variable forward_above_total_11_choice, sums_right_room_choice, sums_right_room_choice_2 : natural range 0 to 31;
    variable forward_above_write_words_0_choice, forward_above_write_words_0_choice_3 : natural range 0 to 132;
    variable forward_above_write_words_0_choice_4, forward_above_write_words_0_choice_5 : natural range 0 to 132;
    variable forward_above_write_words_0_choice_6, forward_above_write_words_1_choice : natural range 0 to 132;
    variable forward_above_write_words_1_choice_3, forward_above_write_words_1_choice_4 : natural range 0 to 132;
    variable forward_above_write_words_1_choice_5, forward_above_write_words_1_choice_6 : natural range 0 to 132;
    variable forward_above_write_words_0_choice_2, forward_above_write_words_1_choice_2 : natural range 0 to 127;
    variable sums_turn_waiting_read_place_choice, sums_turn_waiting_read_place_choice_2 : natural range 0 to 63;
    variable winnerswinner1_held_0_0_choice, winnerswinner1_held_0_1_choice : natural range 0 to 1023;
    variable winnerswinner1_held_0_2_choice, winnerswinner1_held_0_3_choice : natural range 0 to 1023;
    variable winnerswinner1_held_0_4_choice, winnerswinner1_held_0_5_choice : natural range 0 to 1023;
    variable winnerswinner1_held_0_6_choice, winnerswinner1_held_0_7_choice : natural range 0 to 1023;
    variable winnerswinner1_held_0_8_choice, winnerswinner1_held_0_9_choice : natural range 0 to 1023;
    variable winnerswinner1_held_0_10_choice, winnerswinner1_held_0_11_choice : natural range 0 to 1023;
    variable winnerswinner2_best_below_0_0_choice, winnerswinner2_best_below_0_1_choice : natural range 0 to 1023;
    variable winnerswinner2_best_below_0_2_choice, winnerswinner2_best_above_0_0_choice : natural range 0 to 1023;
    variable winnerswinner2_best_above_0_1_choice, winnerswinner2_best_above_0_2_choice : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_0_choice, winnerswinner2_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_0_choice_3, winnerswinner2_best_second_0_0_choice_4 : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_1_choice, winnerswinner2_best_second_0_1_choice_2 : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_1_choice_3, winnerswinner2_best_second_0_1_choice_4 : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_2_choice, winnerswinner2_best_second_0_2_choice_2 : natural range 0 to 1023;
    variable winnerswinner2_best_second_0_2_choice_3, winnerswinner2_best_second_0_2_choice_4 : natural range 0 to 1023;
    variable winnerswinner3_best_below_0_0_choice, winnerswinner3_best_above_0_0_choice : natural range 0 to 1023;
    variable winnerswinner3_best_second_0_0_choice, winnerswinner3_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable winnerswinner3_best_second_0_0_choice_3, winnerswinner3_best_second_0_0_choice_4 : natural range 0 to 1023;
    variable winnerswinner4_best_below_0_0_choice, winnerswinner4_best_above_0_0_choice : natural range 0 to 1023;
    variable winnerswinner4_best_second_0_0_choice, winnerswinner4_best_second_0_0_choice_2 : natural range 0 to 1023;
    variable winnerswinner4_best_second_0_0_choice_3, winnerswinner4_best_second_0_0_choice_4 : natural range 0 to 1023;
    variable refinement_divisor_0_0_choice : natural range 0 to 1023;
    variable refinement_remainder_1_0_difference : natural range 1025 to 3071;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 1025 to 4094;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 1025 to 4094;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 1025 to 4094;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -14 to 16;
    variable map_of_column_0_c_choice, map_sorted_low_0_choice, map_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_middle_0_choice, map_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_high_0_choice, map_sorted_high_0_choice_2, map_largest_low_0_choice : natural range 0 to 32767;
    variable map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 32767;
    variable map_median_middle_0_choice_2, map_median_middle_0_choice_3 : natural range 0 to 32767;
    variable map_median_middle_0_choice_4, map_smallest_high_0_choice : natural range 0 to 32767;
    variable map_smallest_high_0_choice_2, map_out_disparity_0_choice : natural range 0 to 32767;
    variable map_out_disparity_0_choice_2, map_out_disparity_0_choice_3 : natural range 0 to 32767;
    variable map_out_disparity_0_choice_4, map_low_0_0_choice, map_middle_0_0_choice : natural range 0 to 32767;
    variable map_high_0_0_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 39;
      transform_counter_group_is_equal_2 := transform_counter_group = 11;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 3;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_is_equal_3 := (transform_counter_group / 2) = 6;
      if transform_counter_group_is_equal_3 then
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid and (not
          ((transform_counter_group mod 2) = 1));
      else
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid;
      end if;
      if transform_counter_next_frame and (transform_counter_group = 12) then
        transform_counter_group_choice_3 := 1;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 16;
      end if;
      if transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      if 500 < transform_left_filter_slope_0 then
        transform_left_filter_feature_0_choice := 1000;
      else
        transform_left_filter_feature_0_choice := (((((transform_left_filter_slope_0 mod 65536) / 4) + 125) mod 16384)
          * 4) + (transform_left_filter_slope_0 mod 4);
      end if;
      if transform_left_filter_slope_0 < (-500) then
        transform_left_filter_feature_0_choice_2 := 0;
      else
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      end if;
      if 500 < transform_right_filter_slope_0 then
        transform_right_filter_feature_0_choice := 1000;
      else
        transform_right_filter_feature_0_choice := (((((transform_right_filter_slope_0 mod 65536) / 4) + 125) mod 512)
          * 4) + (transform_right_filter_slope_0 mod 4);
      end if;
      if transform_right_filter_slope_0 < (-500) then
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
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_2 <= (not ((transform_counter_group / 8) = 1)) or (not (((transform_counter_group / 4)
        mod 2) = 1));
      transform_read_column_inside_0 <= ((transform_counter_column / 4) /= 0) or (((transform_counter_column / 2) mod
        2) = 1) or ((transform_counter_column mod 2) = 1);
      transform_read_column_inside_1 <= true;
      transform_read_start_of_frame <= (transform_counter_column = 1) and (transform_counter_group = 1);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_1 <= transform_read_column_inside_1;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 4096;
      transform_left_column_1 <= transform_left_rows_ready_words_0 / 4096;
      transform_left_column_2 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 4096;
      transform_right_column_1 <= transform_right_rows_ready_words_0 / 4096;
      transform_right_column_2 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_1 <= transform_ready_column_inside_1;
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
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 4;
      else
        transform_counter_group <= transform_counter_group_choice_4;
      end if;
      if ((transform_counter_column / 2) mod 16) = 0 then
        transform_read_column_inside_2 <= (transform_counter_column = 0) /= ((transform_counter_column / 32) = 1);
      else
        transform_read_column_inside_2 <= transform_counter_column /= 0;
      end if;
      if transform_left_filter_whole then
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_2;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_2;
      else
        transform_left_filter_feature_0 <= 500;
        transform_right_filter_feature_0 <= 500;
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choice := transform_counter_next_frame and ((transform_counter_group mod 2) = 1);
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal_3 then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= transform_counter_group_all or (not in_start_of_frame);
        else
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_words_0 / 4096) +
          (transform_left_rows_ready_newest_0 * 4096);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_words_0 / 4096) +
          (transform_right_rows_ready_newest_0 * 4096);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_row_inside_2 then
        transform_left_filter_column_0_0_choice := transform_left_column_2;
      else
        transform_left_filter_column_0_0_choice := transform_left_column_0;
      end if;
      if transform_columns_row_inside_0 then
        transform_left_filter_column_0_0_choice_2 := transform_left_column_0;
      else
        transform_left_filter_column_0_0_choice_2 := transform_left_column_2;
      end if;
      transform_left_filter_column_0_0_sum := transform_left_filter_column_0_0_choice +
        transform_left_filter_column_0_0_choice_2;
      if transform_columns_row_inside_2 then
        transform_right_filter_column_0_0_choice := transform_right_column_2;
      else
        transform_right_filter_column_0_0_choice := transform_right_column_0;
      end if;
      if transform_columns_row_inside_0 then
        transform_right_filter_column_0_0_choice_2 := transform_right_column_0;
      else
        transform_right_filter_column_0_0_choice_2 := transform_right_column_2;
      end if;
      transform_right_filter_column_0_0_sum := transform_right_filter_column_0_0_choice +
        transform_right_filter_column_0_0_choice_2;
      if transform_columns_valid then
        transform_left_filter_column_0_0 <= ((transform_left_column_1 + (transform_left_filter_column_0_0_sum / 2)) *
          2) + (transform_left_filter_column_0_0_sum mod 2);
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_right_filter_column_0_0 <= ((transform_right_column_1 + (transform_right_filter_column_0_0_sum / 2))
          * 2) + (transform_right_filter_column_0_0_sum mod 2);
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 39;
      raster_place_group_is_equal_2 := raster_place_group = 11;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := (raster_place_group / 2) = 6;
      if raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := raster_place_group_is_equal and transform_filtering_2_valid and (not
          ((raster_place_group mod 2) = 1));
      else
        raster_place_group_choice_2 := raster_place_group_is_equal and transform_filtering_2_valid;
      end if;
      if raster_place_next_frame and (raster_place_group = 12) then
        raster_place_group_choice_3 := 1;
      else
        raster_place_group_choice_3 := (raster_place_group + 1) mod 16;
      end if;
      if raster_place_group_choice_2 then
        raster_place_group_choice_4 := raster_place_group_choice_3;
      else
        raster_place_group_choice_4 := raster_place_group;
      end if;
      if raster_place_group_is_equal then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if raster_place_group_all then
        raster_place_next_frame_choice_3 := transform_filtering_2_valid;
      else
        raster_place_next_frame_choice_3 := transform_filtering_2_valid and (not transform_filtering_2_start_of_frame);
      end if;
      if raster_place_next_frame_choice_2 then
        raster_place_next_frame_choice_4 := raster_place_next_frame_choice_3;
      else
        raster_place_next_frame_choice_4 := raster_place_group_is_equal and raster_place_group_is_equal_2 and
          transform_filtering_2_valid and transform_filtering_2_start_of_frame;
      end if;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_2_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_4 or ((not transform_filtering_2_valid) and
        raster_place_next_frame);
      if transform_filtering_2_valid and transform_filtering_2_start_of_frame then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if transform_filtering_2_valid then
        if raster_place_group_is_equal or transform_filtering_2_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
      end if;
      -- delay
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 13;
      delay_tag_map_column_is_not_less := raster_place_column >= 1;
      delay_tag_map_column_is_less := raster_place_column < 39;
      delay_tag_first_column_is_equal := raster_place_column = 1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside_1 <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside_2 <= (not ((raster_place_group / 8) = 1)) or (not (((raster_place_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
        delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= (raster_place_group = 1) and delay_tag_first_column_is_equal;
      delay_tag_end_of_line <= raster_place_column = 38;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0 mod 2048;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 2048;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_0 / 2048;
        rows_reference_1 <= rows_reference_rows_ready_words_0 / 2048;
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_inside_2 then
        rows_search_2 <= rows_search_rows_ready_newest_0;
        rows_reference_2 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_2 <= 0;
        rows_reference_2 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 2048) + (rows_search_rows_ready_newest_0 *
          2048);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 2048) +
          (rows_reference_rows_ready_newest_0 * 2048);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= rows_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_0_3 <= slice0shift_search_0_2;
        slice0shift_search_0_4 <= slice0shift_search_0_3;
        slice0shift_search_1_0 <= rows_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_1_3 <= slice0shift_search_1_2;
        slice0shift_search_1_4 <= slice0shift_search_1_3;
        slice0shift_search_2_0 <= rows_search_2;
        slice0shift_search_2_1 <= slice0shift_search_2_0;
        slice0shift_search_2_2 <= slice0shift_search_2_1;
        slice0shift_search_2_3 <= slice0shift_search_2_2;
        slice0shift_search_2_4 <= slice0shift_search_2_3;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_search_out_0 <= slice0shift_search_0_4;
      slice0shift_search_out_1 <= slice0shift_search_1_4;
      slice0shift_search_out_2 <= slice0shift_search_2_4;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_difference_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_difference_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= (((slice0shift_search_2_0 - slice0shift_reference_2) + 32768) mod 65536) - 32768;
      slice0cost_difference_2_1 <= (((slice0shift_search_2_1 - slice0shift_reference_2) + 32768) mod 65536) - 32768;
      slice0cost_difference_2_2 <= (((slice0shift_search_2_2 - slice0shift_reference_2) + 32768) mod 65536) - 32768;
      slice0cost_difference_2_3 <= (((slice0shift_search_2_3 - slice0shift_reference_2) + 32768) mod 65536) - 32768;
      slice0cost_difference_2_4 <= (((slice0shift_search_2_4 - slice0shift_reference_2) + 32768) mod 65536) - 32768;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_first_column <= slice0shift_tag_first_column;
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
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_negative_0_3 <= slice0cost_difference_2_3 < 0;
      slice0cost_negative_0_4 <= slice0cost_difference_2_4 < 0;
      slice0cost_single_0_0 <= folded(slice0cost_difference_0_0) + as_number((slice0cost_difference_0_0 < 0));
      slice0cost_single_0_1 <= folded(slice0cost_difference_0_1) + as_number((slice0cost_difference_0_1 < 0));
      slice0cost_single_0_2 <= folded(slice0cost_difference_0_2) + as_number((slice0cost_difference_0_2 < 0));
      slice0cost_single_0_3 <= folded(slice0cost_difference_0_3) + as_number((slice0cost_difference_0_3 < 0));
      slice0cost_single_0_4 <= folded(slice0cost_difference_0_4) + as_number((slice0cost_difference_0_4 < 0));
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_first_column <= slice0cost_difference_tag_first_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_single_0_0 + slice0cost_pair_0_0 + as_number(slice0cost_negative_0_0);
      slice0cost_column_0_1 <= slice0cost_single_0_1 + slice0cost_pair_0_1 + as_number(slice0cost_negative_0_1);
      slice0cost_column_0_2 <= slice0cost_single_0_2 + slice0cost_pair_0_2 + as_number(slice0cost_negative_0_2);
      slice0cost_column_0_3 <= slice0cost_single_0_3 + slice0cost_pair_0_3 + as_number(slice0cost_negative_0_3);
      slice0cost_column_0_4 <= slice0cost_single_0_4 + slice0cost_pair_0_4 + as_number(slice0cost_negative_0_4);
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_pair_tag_first_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_0_3 <= slice0cost_column_0_3;
        slice0window_partial_0_0_4 <= slice0cost_column_0_4;
        slice0window_partial_0_1_0 <= (slice0cost_column_0_0 + slice0window_partial_0_0_0) mod 65536;
        slice0window_partial_0_1_1 <= (slice0cost_column_0_1 + slice0window_partial_0_0_1) mod 65536;
        slice0window_partial_0_1_2 <= (slice0cost_column_0_2 + slice0window_partial_0_0_2) mod 65536;
        slice0window_partial_0_1_3 <= (slice0cost_column_0_3 + slice0window_partial_0_0_3) mod 65536;
        slice0window_partial_0_1_4 <= (slice0cost_column_0_4 + slice0window_partial_0_0_4) mod 65536;
        slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
        slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      end if;
      slice0window_centre_first_column_0 <= slice0cost_tag_first_column;
      slice0window_sum_0_0 <= (slice0cost_column_0_0 + slice0window_partial_0_1_0) mod 65536;
      slice0window_sum_0_1 <= (slice0cost_column_0_1 + slice0window_partial_0_1_1) mod 65536;
      slice0window_sum_0_2 <= (slice0cost_column_0_2 + slice0window_partial_0_1_2) mod 65536;
      slice0window_sum_0_3 <= (slice0cost_column_0_3 + slice0window_partial_0_1_3) mod 65536;
      slice0window_sum_0_4 <= (slice0cost_column_0_4 + slice0window_partial_0_1_4) mod 65536;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      if slice0window_tag_valid then
        slice0window_tag_first_column <= slice0window_centre_first_column_0;
      end if;
      -- slice0mask
      if (not (((slice0mask_column / 8) mod 2) = 1)) and ((not (((slice0mask_column / 4) mod 2) = 1)) or
        ((slice0mask_column mod 4) = 0)) then
        slice0mask_inside_0_choice := (not slice1cost_tag_first_column) and ((slice0mask_column / 16) = 3);
      else
        slice0mask_inside_0_choice := ((slice0mask_column / 32) = 1) and (not slice1cost_tag_first_column);
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_1_choice := slice0mask_inside_0;
      else
        slice0mask_inside_1_choice := slice0mask_inside_1;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_2_choice := slice0mask_inside_1;
      else
        slice0mask_inside_2_choice := slice0mask_inside_2;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_3_choice := slice0mask_inside_2;
      else
        slice0mask_inside_3_choice := slice0mask_inside_3;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_4_choice := slice0mask_inside_3;
      else
        slice0mask_inside_4_choice := slice0mask_inside_4;
      end if;
      slice0mask_left_out <= slice0mask_inside_4;
      if slice0mask_inside_0_choice then
        slice0mask_inside_0 <= (not slice0cost_tag_valid) and slice0mask_inside_0;
      else
        slice0mask_inside_0 <= slice0cost_tag_valid or slice0mask_inside_0;
      end if;
      if slice1cost_tag_first_column then
        slice0mask_inside_1 <= (not slice0cost_tag_valid) and slice0mask_inside_1;
        slice0mask_inside_2 <= (not slice0cost_tag_valid) and slice0mask_inside_2;
        slice0mask_inside_3 <= (not slice0cost_tag_valid) and slice0mask_inside_3;
        slice0mask_inside_4 <= (not slice0cost_tag_valid) and slice0mask_inside_4;
      else
        slice0mask_inside_1 <= slice0mask_inside_1_choice;
        slice0mask_inside_2 <= slice0mask_inside_2_choice;
        slice0mask_inside_3 <= slice0mask_inside_3_choice;
        slice0mask_inside_4 <= slice0mask_inside_4_choice;
      end if;
      if slice0cost_tag_valid then
        if slice1cost_tag_first_column then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 64;
        end if;
      end if;
      -- slice0
      slice0_held_1_0 <= slice0_held_0_0;
      slice0_held_1_1 <= slice0_held_0_1;
      slice0_held_1_2 <= slice0_held_0_2;
      slice0_held_1_3 <= slice0_held_0_3;
      slice0_held_1_4 <= slice0_held_0_4;
      slice0_held_2_0 <= slice0_held_1_0;
      slice0_held_2_1 <= slice0_held_1_1;
      slice0_held_2_2 <= slice0_held_1_2;
      slice0_held_2_3 <= slice0_held_1_3;
      slice0_held_2_4 <= slice0_held_1_4;
      slice0_tag_0_valid <= slice0window_tag_valid;
      slice0_tag_0_map_column <= slice0window_tag_map_column;
      slice0_tag_0_output_column <= slice0window_tag_output_column;
      slice0_tag_0_start_of_frame <= slice0window_tag_start_of_frame;
      slice0_tag_0_end_of_line <= slice0window_tag_end_of_line;
      slice0_tag_1_valid <= slice0_tag_0_valid;
      slice0_tag_1_map_column <= slice0_tag_0_map_column;
      slice0_tag_1_output_column <= slice0_tag_0_output_column;
      slice0_tag_1_first_column <= slice1window_tag_first_column;
      slice0_tag_1_start_of_frame <= slice0_tag_0_start_of_frame;
      slice0_tag_1_end_of_line <= slice0_tag_0_end_of_line;
      slice0_tag_2_valid <= slice0_tag_1_valid;
      slice0_tag_2_map_column <= slice0_tag_1_map_column;
      slice0_tag_2_output_column <= slice0_tag_1_output_column;
      slice0_tag_2_first_column <= slice0_tag_1_first_column;
      slice0_tag_2_start_of_frame <= slice0_tag_1_start_of_frame;
      slice0_tag_2_end_of_line <= slice0_tag_1_end_of_line;
      if (8191 < slice0window_sum_0_0) or (not slice0mask_inside_0) then
        slice0_held_0_0 <= 63;
      else
        slice0_held_0_0 <= (slice0window_sum_0_0 / 128) mod 256;
      end if;
      if (8191 < slice0window_sum_0_1) or (not slice0mask_inside_1) then
        slice0_held_0_1 <= 63;
      else
        slice0_held_0_1 <= (slice0window_sum_0_1 / 128) mod 256;
      end if;
      if (8191 < slice0window_sum_0_2) or (not slice0mask_inside_2) then
        slice0_held_0_2 <= 63;
      else
        slice0_held_0_2 <= (slice0window_sum_0_2 / 128) mod 256;
      end if;
      if (8191 < slice0window_sum_0_3) or (not slice0mask_inside_3) then
        slice0_held_0_3 <= 63;
      else
        slice0_held_0_3 <= (slice0window_sum_0_3 / 128) mod 256;
      end if;
      if (8191 < slice0window_sum_0_4) or (not slice0mask_inside_4) then
        slice0_held_0_4 <= 63;
      else
        slice0_held_0_4 <= (slice0window_sum_0_4 / 128) mod 256;
      end if;
      if slice0_tag_0_valid then
        slice0_tag_0_first_column <= slice1window_centre_first_column_0;
      end if;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice0shift_search_out_0;
        slice1shift_search_0_1 <= slice1shift_search_0_0;
        slice1shift_search_0_2 <= slice1shift_search_0_1;
        slice1shift_search_0_3 <= slice1shift_search_0_2;
        slice1shift_search_0_4 <= slice1shift_search_0_3;
        slice1shift_search_1_0 <= slice0shift_search_out_1;
        slice1shift_search_1_1 <= slice1shift_search_1_0;
        slice1shift_search_1_2 <= slice1shift_search_1_1;
        slice1shift_search_1_3 <= slice1shift_search_1_2;
        slice1shift_search_1_4 <= slice1shift_search_1_3;
        slice1shift_search_2_0 <= slice0shift_search_out_2;
        slice1shift_search_2_1 <= slice1shift_search_2_0;
        slice1shift_search_2_2 <= slice1shift_search_2_1;
        slice1shift_search_2_3 <= slice1shift_search_2_2;
        slice1shift_search_2_4 <= slice1shift_search_2_3;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_search_out_0 <= slice1shift_search_0_4;
      slice1shift_search_out_1 <= slice1shift_search_1_4;
      slice1shift_search_out_2 <= slice1shift_search_2_4;
      -- slice1cost
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_0_3 <= slice1shift_search_0_3 - slice1shift_reference_0;
      slice1cost_difference_0_4 <= slice1shift_search_0_4 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_1_3 <= slice1shift_search_1_3 - slice1shift_reference_1;
      slice1cost_difference_1_4 <= slice1shift_search_1_4 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= (((slice1shift_search_2_0 - slice1shift_reference_2) + 32768) mod 65536) - 32768;
      slice1cost_difference_2_1 <= (((slice1shift_search_2_1 - slice1shift_reference_2) + 32768) mod 65536) - 32768;
      slice1cost_difference_2_2 <= (((slice1shift_search_2_2 - slice1shift_reference_2) + 32768) mod 65536) - 32768;
      slice1cost_difference_2_3 <= (((slice1shift_search_2_3 - slice1shift_reference_2) + 32768) mod 65536) - 32768;
      slice1cost_difference_2_4 <= (((slice1shift_search_2_4 - slice1shift_reference_2) + 32768) mod 65536) - 32768;
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
      slice1cost_negative_0_0 <= slice1cost_difference_2_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_2_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_2_2 < 0;
      slice1cost_negative_0_3 <= slice1cost_difference_2_3 < 0;
      slice1cost_negative_0_4 <= slice1cost_difference_2_4 < 0;
      slice1cost_single_0_0 <= folded(slice1cost_difference_0_0) + as_number((slice1cost_difference_0_0 < 0));
      slice1cost_single_0_1 <= folded(slice1cost_difference_0_1) + as_number((slice1cost_difference_0_1 < 0));
      slice1cost_single_0_2 <= folded(slice1cost_difference_0_2) + as_number((slice1cost_difference_0_2 < 0));
      slice1cost_single_0_3 <= folded(slice1cost_difference_0_3) + as_number((slice1cost_difference_0_3 < 0));
      slice1cost_single_0_4 <= folded(slice1cost_difference_0_4) + as_number((slice1cost_difference_0_4 < 0));
      slice1cost_column_0_0 <= slice1cost_single_0_0 + slice1cost_pair_0_0 + as_number(slice1cost_negative_0_0);
      slice1cost_column_0_1 <= slice1cost_single_0_1 + slice1cost_pair_0_1 + as_number(slice1cost_negative_0_1);
      slice1cost_column_0_2 <= slice1cost_single_0_2 + slice1cost_pair_0_2 + as_number(slice1cost_negative_0_2);
      slice1cost_column_0_3 <= slice1cost_single_0_3 + slice1cost_pair_0_3 + as_number(slice1cost_negative_0_3);
      slice1cost_column_0_4 <= slice1cost_single_0_4 + slice1cost_pair_0_4 + as_number(slice1cost_negative_0_4);
      if slice0cost_tag_valid then
        slice1cost_tag_first_column <= slice0cost_tag_first_column;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_0_3 <= slice1cost_column_0_3;
        slice1window_partial_0_0_4 <= slice1cost_column_0_4;
        slice1window_partial_0_1_0 <= (slice1cost_column_0_0 + slice1window_partial_0_0_0) mod 65536;
        slice1window_partial_0_1_1 <= (slice1cost_column_0_1 + slice1window_partial_0_0_1) mod 65536;
        slice1window_partial_0_1_2 <= (slice1cost_column_0_2 + slice1window_partial_0_0_2) mod 65536;
        slice1window_partial_0_1_3 <= (slice1cost_column_0_3 + slice1window_partial_0_0_3) mod 65536;
        slice1window_partial_0_1_4 <= (slice1cost_column_0_4 + slice1window_partial_0_0_4) mod 65536;
      end if;
      slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
      slice1window_sum_0_0 <= (slice1cost_column_0_0 + slice1window_partial_0_1_0) mod 65536;
      slice1window_sum_0_1 <= (slice1cost_column_0_1 + slice1window_partial_0_1_1) mod 65536;
      slice1window_sum_0_2 <= (slice1cost_column_0_2 + slice1window_partial_0_1_2) mod 65536;
      slice1window_sum_0_3 <= (slice1cost_column_0_3 + slice1window_partial_0_1_3) mod 65536;
      slice1window_sum_0_4 <= (slice1cost_column_0_4 + slice1window_partial_0_1_4) mod 65536;
      slice1window_tag_first_column <= slice2cost_tag_first_column;
      -- slice1mask
      slice1mask_inside_0_all := (not slice0window_tag_valid) and slice1mask_inside_0;
      if slice0window_tag_first_column then
        slice1mask_inside_0_choice := slice1mask_inside_0_all;
      else
        slice1mask_inside_0_choice := slice0window_tag_valid or slice1mask_inside_0;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_1_choice := slice1mask_inside_0;
      else
        slice1mask_inside_1_choice := slice1mask_inside_1;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_2_choice := slice1mask_inside_1;
      else
        slice1mask_inside_2_choice := slice1mask_inside_2;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_3_choice := slice1mask_inside_2;
      else
        slice1mask_inside_3_choice := slice1mask_inside_3;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_4_choice := slice1mask_inside_3;
      else
        slice1mask_inside_4_choice := slice1mask_inside_4;
      end if;
      slice1mask_left_out <= slice1mask_inside_4;
      if slice0mask_left_out then
        slice1mask_inside_0 <= slice1mask_inside_0_choice;
      else
        slice1mask_inside_0 <= slice1mask_inside_0_all;
      end if;
      if slice0window_tag_first_column then
        slice1mask_inside_1 <= (not slice0window_tag_valid) and slice1mask_inside_1;
        slice1mask_inside_2 <= (not slice0window_tag_valid) and slice1mask_inside_2;
        slice1mask_inside_3 <= (not slice0window_tag_valid) and slice1mask_inside_3;
        slice1mask_inside_4 <= (not slice0window_tag_valid) and slice1mask_inside_4;
      else
        slice1mask_inside_1 <= slice1mask_inside_1_choice;
        slice1mask_inside_2 <= slice1mask_inside_2_choice;
        slice1mask_inside_3 <= slice1mask_inside_3_choice;
        slice1mask_inside_4 <= slice1mask_inside_4_choice;
      end if;
      -- slice1
      slice1_held_1_0 <= slice1_held_0_0;
      slice1_held_1_1 <= slice1_held_0_1;
      slice1_held_1_2 <= slice1_held_0_2;
      slice1_held_1_3 <= slice1_held_0_3;
      slice1_held_1_4 <= slice1_held_0_4;
      if (8191 < slice1window_sum_0_0) or (not slice1mask_inside_0) then
        slice1_held_0_0 <= 63;
      else
        slice1_held_0_0 <= (slice1window_sum_0_0 / 128) mod 256;
      end if;
      if (8191 < slice1window_sum_0_1) or (not slice1mask_inside_1) then
        slice1_held_0_1 <= 63;
      else
        slice1_held_0_1 <= (slice1window_sum_0_1 / 128) mod 256;
      end if;
      if (8191 < slice1window_sum_0_2) or (not slice1mask_inside_2) then
        slice1_held_0_2 <= 63;
      else
        slice1_held_0_2 <= (slice1window_sum_0_2 / 128) mod 256;
      end if;
      if (8191 < slice1window_sum_0_3) or (not slice1mask_inside_3) then
        slice1_held_0_3 <= 63;
      else
        slice1_held_0_3 <= (slice1window_sum_0_3 / 128) mod 256;
      end if;
      if (8191 < slice1window_sum_0_4) or (not slice1mask_inside_4) then
        slice1_held_0_4 <= 63;
      else
        slice1_held_0_4 <= (slice1window_sum_0_4 / 128) mod 256;
      end if;
      -- slice2shift
      if slice0cost_difference_tag_valid then
        slice2shift_search_0_0 <= slice1shift_search_out_0;
        slice2shift_search_0_1 <= slice2shift_search_0_0;
        slice2shift_search_1_0 <= slice1shift_search_out_1;
        slice2shift_search_1_1 <= slice2shift_search_1_0;
        slice2shift_search_2_0 <= slice1shift_search_out_2;
        slice2shift_search_2_1 <= slice2shift_search_2_0;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      -- slice2cost
      slice2cost_difference_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_difference_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_difference_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_difference_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_difference_2_0 <= (((slice2shift_search_2_0 - slice2shift_reference_2) + 32768) mod 65536) - 32768;
      slice2cost_difference_2_1 <= (((slice2shift_search_2_1 - slice2shift_reference_2) + 32768) mod 65536) - 32768;
      slice2cost_pair_0_0 <= folded(slice2cost_difference_2_0) + folded(slice2cost_difference_1_0) +
        as_number((slice2cost_difference_1_0 < 0));
      slice2cost_pair_0_1 <= folded(slice2cost_difference_2_1) + folded(slice2cost_difference_1_1) +
        as_number((slice2cost_difference_1_1 < 0));
      slice2cost_negative_0_0 <= slice2cost_difference_2_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_2_1 < 0;
      slice2cost_single_0_0 <= folded(slice2cost_difference_0_0) + as_number((slice2cost_difference_0_0 < 0));
      slice2cost_single_0_1 <= folded(slice2cost_difference_0_1) + as_number((slice2cost_difference_0_1 < 0));
      slice2cost_column_0_0 <= slice2cost_single_0_0 + slice2cost_pair_0_0 + as_number(slice2cost_negative_0_0);
      slice2cost_column_0_1 <= slice2cost_single_0_1 + slice2cost_pair_0_1 + as_number(slice2cost_negative_0_1);
      slice2cost_tag_first_column <= slice1cost_tag_first_column;
      -- slice2window
      if slice0_tag_0_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= (slice2cost_column_0_0 + slice2window_partial_0_0_0) mod 65536;
        slice2window_partial_0_1_1 <= (slice2cost_column_0_1 + slice2window_partial_0_0_1) mod 65536;
      end if;
      slice2window_sum_0_0 <= (slice2cost_column_0_0 + slice2window_partial_0_1_0) mod 65536;
      slice2window_sum_0_1 <= (slice2cost_column_0_1 + slice2window_partial_0_1_1) mod 65536;
      -- slice2mask
      slice2mask_inside_0_all := (not slice0_tag_0_valid) and slice2mask_inside_0;
      if slice0_tag_0_first_column then
        slice2mask_inside_0_choice := slice2mask_inside_0_all;
      else
        slice2mask_inside_0_choice := slice0_tag_0_valid or slice2mask_inside_0;
      end if;
      if slice0_tag_0_valid then
        slice2mask_inside_1_choice := slice2mask_inside_0;
      else
        slice2mask_inside_1_choice := slice2mask_inside_1;
      end if;
      if slice1mask_left_out then
        slice2mask_inside_0 <= slice2mask_inside_0_choice;
      else
        slice2mask_inside_0 <= slice2mask_inside_0_all;
      end if;
      if slice0_tag_0_first_column then
        slice2mask_inside_1 <= (not slice0_tag_0_valid) and slice2mask_inside_1;
      else
        slice2mask_inside_1 <= slice2mask_inside_1_choice;
      end if;
      -- slice2
      if (8191 < slice2window_sum_0_0) or (not slice2mask_inside_0) then
        slice2_held_0_0 <= 63;
      else
        slice2_held_0_0 <= (slice2window_sum_0_0 / 128) mod 256;
      end if;
      if (8191 < slice2window_sum_0_1) or (not slice2mask_inside_1) then
        slice2_held_0_1 <= 63;
      else
        slice2_held_0_1 <= (slice2window_sum_0_1 / 128) mod 256;
      end if;
      -- entry
      entry_order_falls_any := entry_order_inside or (not slice0_tag_2_map_column) or (not slice0_tag_2_valid);
      entry_order_falls_all := (not entry_order_inside) and slice0_tag_2_map_column and slice0_tag_2_valid;
      entry_order_complete_all := slice0_tag_2_map_column and slice0_tag_2_valid;
      entry_order_complete_any := (not slice0_tag_2_map_column) or (not slice0_tag_2_valid);
      if entry_order_falls_all then
        entry_order_turned_output_column_choice := entry_order_output and entry_order_complete;
      else
        entry_order_turned_output_column_choice := entry_order_held_output;
      end if;
      entry_next_cost_0 <= slice0_held_2_0;
      entry_next_cost_1 <= slice0_held_2_1;
      entry_next_cost_2 <= slice0_held_2_2;
      entry_next_cost_3 <= slice0_held_2_3;
      entry_next_cost_4 <= slice0_held_2_4;
      entry_next_cost_5 <= slice1_held_1_0;
      entry_next_cost_6 <= slice1_held_1_1;
      entry_next_cost_7 <= slice1_held_1_2;
      entry_next_cost_8 <= slice1_held_1_3;
      entry_next_cost_9 <= slice1_held_1_4;
      entry_next_cost_10 <= slice2_held_0_0;
      entry_next_cost_11 <= slice2_held_0_1;
      entry_next_tag_valid <= slice0_tag_2_valid;
      entry_next_tag_map_column <= slice0_tag_2_map_column;
      entry_next_tag_first_column <= slice0_tag_2_first_column;
      entry_next_tag_end_of_line <= slice0_tag_2_end_of_line;
      entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_2_map_column;
      entry_order_turned_first_column <= entry_order_falls_all;
      entry_order_turned_start_of_frame <= (not entry_order_inside) and slice0_tag_2_map_column and slice0_tag_2_valid
        and entry_order_first and entry_order_output and entry_order_complete;
      entry_cost_0 <= entry_next_cost_0;
      entry_cost_1 <= entry_next_cost_1;
      entry_cost_2 <= entry_next_cost_2;
      entry_cost_3 <= entry_next_cost_3;
      entry_cost_4 <= entry_next_cost_4;
      entry_cost_5 <= entry_next_cost_5;
      entry_cost_6 <= entry_next_cost_6;
      entry_cost_7 <= entry_next_cost_7;
      entry_cost_8 <= entry_next_cost_8;
      entry_cost_9 <= entry_next_cost_9;
      entry_cost_10 <= entry_next_cost_10;
      entry_cost_11 <= entry_next_cost_11;
      entry_tag_valid <= entry_next_tag_valid;
      entry_tag_map_column <= entry_next_tag_map_column;
      entry_tag_first_column <= entry_next_tag_first_column;
      entry_tag_end_of_line <= entry_next_tag_end_of_line;
      entry_column <= entry_next_column;
      entry_top <= entry_next_top;
      entry_place <= entry_order_address;
      entry_turned_output_column <= entry_order_turned_output_column;
      entry_turned_first_column <= entry_order_turned_first_column;
      entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
      if entry_order_falls then
        entry_order_falls <= entry_order_falls_any;
      else
        entry_order_falls <= entry_order_falls_all;
      end if;
      if slice0_tag_2_end_of_line then
        entry_order_complete <= entry_order_complete or entry_order_complete_all;
      else
        entry_order_complete <= entry_order_complete and entry_order_complete_any;
      end if;
      if entry_order_complete_all then
        if slice0_tag_2_first_column then
          entry_next_column <= 0;
          entry_next_top <= slice0_tag_2_start_of_frame;
        else
          entry_next_column <= (entry_next_column + 1) mod 64;
          entry_next_top <= entry_next_top;
        end if;
      end if;
      if entry_order_falls then
        entry_order_address_choice := 63;
      else
        entry_order_address_choice := 1;
      end if;
      if entry_order_falls then
        entry_order_address_choice_2 := 0;
      else
        entry_order_address_choice_2 := 37;
      end if;
      if not entry_order_complete_any then
        if entry_order_falls_any then
          entry_order_address <= (entry_order_address_choice + entry_order_address) mod 64;
        else
          entry_order_address <= entry_order_address_choice_2;
        end if;
      end if;
      if slice0_tag_2_valid then
        entry_order_inside <= slice0_tag_2_map_column;
      end if;
      if entry_order_falls_all then
        entry_order_output <= slice0_tag_2_output_column;
        entry_order_first <= slice0_tag_2_start_of_frame;
        entry_order_held_output <= entry_order_output and entry_order_complete;
      end if;
      -- forward
      if (forward_left_cost_2 - forward_left_cost_0) < 0 then
        forward_left_pair_0_choice := forward_left_cost_2;
      else
        forward_left_pair_0_choice := forward_left_cost_0;
      end if;
      if (forward_left_cost_3 - forward_left_cost_1) < 0 then
        forward_left_pair_1_choice := forward_left_cost_3;
      else
        forward_left_pair_1_choice := forward_left_cost_1;
      end if;
      if (forward_left_cost_6 - forward_left_cost_4) < 0 then
        forward_left_pair_2_choice := forward_left_cost_6;
      else
        forward_left_pair_2_choice := forward_left_cost_4;
      end if;
      if (forward_left_cost_7 - forward_left_cost_5) < 0 then
        forward_left_pair_3_choice := forward_left_cost_7;
      else
        forward_left_pair_3_choice := forward_left_cost_5;
      end if;
      if (forward_left_cost_10 - forward_left_cost_8) < 0 then
        forward_left_pair_4_choice := forward_left_cost_10;
      else
        forward_left_pair_4_choice := forward_left_cost_8;
      end if;
      if (forward_left_cost_11 - forward_left_cost_9) < 0 then
        forward_left_pair_5_choice := forward_left_cost_11;
      else
        forward_left_pair_5_choice := forward_left_cost_9;
      end if;
      forward_left_start_cost_0_is_less := 255 < forward_left_tree_next_next_smallest_0;
      forward_left_start_cost_0_is_less_2 := 255 < ((forward_left_tree_next_next_smallest_0 mod 256) +
        forward_left_room);
      if forward_left_start_cost_0_is_less_2 then
        forward_left_start_cost_0_choice := (forward_left_tree_next_next_smallest_0 + forward_left_room) mod 256;
      else
        forward_left_start_cost_0_choice := 0;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_start_cost_0_choice_2 := forward_left_room;
      else
        forward_left_start_cost_0_choice_2 := forward_left_start_cost_0_choice;
      end if;
      if forward_left_start_cost_0_is_less_2 then
        forward_left_room_choice := (0 - forward_left_tree_next_next_smallest_0) mod 32;
      else
        forward_left_room_choice := forward_left_room;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_room_choice_2 := 0;
      else
        forward_left_room_choice_2 := forward_left_room_choice;
      end if;
      if (forward_left_arrived_0 - forward_left_cost_0) < 0 then
        forward_left_cost_0_choice := forward_left_arrived_0;
      else
        forward_left_cost_0_choice := forward_left_cost_0;
      end if;
      if (255 < forward_left_cost_0_choice) or forward_left_first_2 then
        forward_left_cost_0_choice_2 := 256;
      else
        forward_left_cost_0_choice_2 := forward_left_cost_0_choice;
      end if;
      if (forward_left_arrived_1 - forward_left_cost_1) < 0 then
        forward_left_cost_1_choice := forward_left_arrived_1;
      else
        forward_left_cost_1_choice := forward_left_cost_1;
      end if;
      if (255 < forward_left_cost_1_choice) or forward_left_first_2 then
        forward_left_cost_1_choice_2 := 256;
      else
        forward_left_cost_1_choice_2 := forward_left_cost_1_choice;
      end if;
      if (forward_left_arrived_2 - forward_left_cost_2) < 0 then
        forward_left_cost_2_choice := forward_left_arrived_2;
      else
        forward_left_cost_2_choice := forward_left_cost_2;
      end if;
      if (255 < forward_left_cost_2_choice) or forward_left_first_2 then
        forward_left_cost_2_choice_2 := 256;
      else
        forward_left_cost_2_choice_2 := forward_left_cost_2_choice;
      end if;
      if (forward_left_arrived_3 - forward_left_cost_3) < 0 then
        forward_left_cost_3_choice := forward_left_arrived_3;
      else
        forward_left_cost_3_choice := forward_left_cost_3;
      end if;
      if (255 < forward_left_cost_3_choice) or forward_left_first_2 then
        forward_left_cost_3_choice_2 := 256;
      else
        forward_left_cost_3_choice_2 := forward_left_cost_3_choice;
      end if;
      if (forward_left_arrived_4 - forward_left_cost_4) < 0 then
        forward_left_cost_4_choice := forward_left_arrived_4;
      else
        forward_left_cost_4_choice := forward_left_cost_4;
      end if;
      if (255 < forward_left_cost_4_choice) or forward_left_first_2 then
        forward_left_cost_4_choice_2 := 256;
      else
        forward_left_cost_4_choice_2 := forward_left_cost_4_choice;
      end if;
      if (forward_left_arrived_5 - forward_left_cost_5) < 0 then
        forward_left_cost_5_choice := forward_left_arrived_5;
      else
        forward_left_cost_5_choice := forward_left_cost_5;
      end if;
      if (255 < forward_left_cost_5_choice) or forward_left_first_2 then
        forward_left_cost_5_choice_2 := 256;
      else
        forward_left_cost_5_choice_2 := forward_left_cost_5_choice;
      end if;
      if (forward_left_arrived_6 - forward_left_cost_6) < 0 then
        forward_left_cost_6_choice := forward_left_arrived_6;
      else
        forward_left_cost_6_choice := forward_left_cost_6;
      end if;
      if (255 < forward_left_cost_6_choice) or forward_left_first_2 then
        forward_left_cost_6_choice_2 := 256;
      else
        forward_left_cost_6_choice_2 := forward_left_cost_6_choice;
      end if;
      if (forward_left_arrived_7 - forward_left_cost_7) < 0 then
        forward_left_cost_7_choice := forward_left_arrived_7;
      else
        forward_left_cost_7_choice := forward_left_cost_7;
      end if;
      if (255 < forward_left_cost_7_choice) or forward_left_first_2 then
        forward_left_cost_7_choice_2 := 256;
      else
        forward_left_cost_7_choice_2 := forward_left_cost_7_choice;
      end if;
      if (forward_left_arrived_8 - forward_left_cost_8) < 0 then
        forward_left_cost_8_choice := forward_left_arrived_8;
      else
        forward_left_cost_8_choice := forward_left_cost_8;
      end if;
      if (255 < forward_left_cost_8_choice) or forward_left_first_2 then
        forward_left_cost_8_choice_2 := 256;
      else
        forward_left_cost_8_choice_2 := forward_left_cost_8_choice;
      end if;
      if (forward_left_arrived_9 - forward_left_cost_9) < 0 then
        forward_left_cost_9_choice := forward_left_arrived_9;
      else
        forward_left_cost_9_choice := forward_left_cost_9;
      end if;
      if (255 < forward_left_cost_9_choice) or forward_left_first_2 then
        forward_left_cost_9_choice_2 := 256;
      else
        forward_left_cost_9_choice_2 := forward_left_cost_9_choice;
      end if;
      if (forward_left_arrived_10 - forward_left_cost_10) < 0 then
        forward_left_cost_10_choice := forward_left_arrived_10;
      else
        forward_left_cost_10_choice := forward_left_cost_10;
      end if;
      if (255 < forward_left_cost_10_choice) or forward_left_first_2 then
        forward_left_cost_10_choice_2 := 256;
      else
        forward_left_cost_10_choice_2 := forward_left_cost_10_choice;
      end if;
      if (forward_left_arrived_11 - forward_left_cost_11) < 0 then
        forward_left_cost_11_choice := forward_left_arrived_11;
      else
        forward_left_cost_11_choice := forward_left_cost_11;
      end if;
      if (255 < forward_left_cost_11_choice) or forward_left_first_2 then
        forward_left_cost_11_choice_2 := 256;
      else
        forward_left_cost_11_choice_2 := forward_left_cost_11_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_0_choice := 256;
      else
        forward_left_arrived_0_choice := forward_left_cost_1;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_1_choice := 256;
      else
        forward_left_arrived_1_choice := forward_left_pair_0_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_2_choice := 256;
      else
        forward_left_arrived_2_choice := forward_left_pair_1_choice;
      end if;
      if (forward_left_cost_4 - forward_left_cost_2) < 0 then
        forward_left_arrived_3_choice := forward_left_cost_4;
      else
        forward_left_arrived_3_choice := forward_left_cost_2;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_3_choice_2 := 256;
      else
        forward_left_arrived_3_choice_2 := forward_left_arrived_3_choice;
      end if;
      if (forward_left_cost_5 - forward_left_cost_3) < 0 then
        forward_left_arrived_4_choice := forward_left_cost_5;
      else
        forward_left_arrived_4_choice := forward_left_cost_3;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_4_choice_2 := 256;
      else
        forward_left_arrived_4_choice_2 := forward_left_arrived_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_5_choice := 256;
      else
        forward_left_arrived_5_choice := forward_left_pair_2_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_6_choice := 256;
      else
        forward_left_arrived_6_choice := forward_left_pair_3_choice;
      end if;
      if (forward_left_cost_8 - forward_left_cost_6) < 0 then
        forward_left_arrived_7_choice := forward_left_cost_8;
      else
        forward_left_arrived_7_choice := forward_left_cost_6;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_7_choice_2 := 256;
      else
        forward_left_arrived_7_choice_2 := forward_left_arrived_7_choice;
      end if;
      if (forward_left_cost_9 - forward_left_cost_7) < 0 then
        forward_left_arrived_8_choice := forward_left_cost_9;
      else
        forward_left_arrived_8_choice := forward_left_cost_7;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_8_choice_2 := 256;
      else
        forward_left_arrived_8_choice_2 := forward_left_arrived_8_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_9_choice := 256;
      else
        forward_left_arrived_9_choice := forward_left_pair_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_10_choice := 256;
      else
        forward_left_arrived_10_choice := forward_left_pair_5_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_11_choice := 256;
      else
        forward_left_arrived_11_choice := forward_left_cost_10;
      end if;
      if forward_above_ready_top then
        forward_above_total_0_choice := 22;
      else
        forward_above_total_0_choice := to_integer(forward_above_ready_words_0(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_1_choice := 22;
      else
        forward_above_total_1_choice := to_integer(forward_above_ready_words_0(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_2_choice := 22;
      else
        forward_above_total_2_choice := to_integer(forward_above_ready_words_0(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_3_choice := 22;
      else
        forward_above_total_3_choice := to_integer(forward_above_ready_words_0(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_4_choice := 22;
      else
        forward_above_total_4_choice := to_integer(forward_above_ready_words_0(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_5_choice := 22;
      else
        forward_above_total_5_choice := to_integer(forward_above_ready_words_0(29 downto 25));
      end if;
      if forward_above_ready_top then
        forward_above_total_6_choice := 22;
      else
        forward_above_total_6_choice := to_integer(forward_above_ready_words_1(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_7_choice := 22;
      else
        forward_above_total_7_choice := to_integer(forward_above_ready_words_1(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_8_choice := 22;
      else
        forward_above_total_8_choice := to_integer(forward_above_ready_words_1(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_9_choice := 22;
      else
        forward_above_total_9_choice := to_integer(forward_above_ready_words_1(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_10_choice := 22;
      else
        forward_above_total_10_choice := to_integer(forward_above_ready_words_1(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_11_choice := 22;
      else
        forward_above_total_11_choice := to_integer(forward_above_ready_words_1(29 downto 25));
      end if;
      if entry_tag_valid then
        forward_smallest_next_next_smallest_1 <= forward_smallest_next_smallest_2;
        forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
        forward_left_pair_0 <= forward_left_pair_0_choice;
        forward_left_pair_1 <= forward_left_pair_1_choice;
        forward_left_pair_2 <= forward_left_pair_2_choice;
        forward_left_pair_3 <= forward_left_pair_3_choice;
        forward_left_pair_4 <= forward_left_pair_4_choice;
        forward_left_pair_5 <= forward_left_pair_5_choice;
        forward_left_tree_next_smallest_1 <= forward_left_tree_smallest_2;
        forward_left_smallest <= forward_smallest_next_next_next_smallest_0;
        forward_left_smallest_less <= (forward_smallest_next_next_next_smallest_0 + 507) mod 512;
        forward_left_first_0 <= sums_turn_waiting_first_3;
        forward_left_first_1 <= forward_left_first_0;
        forward_left_first_2 <= forward_left_first_1;
        forward_left_g_copy_0 <= forward_left_start_cost_0 + forward_left_smallest;
        forward_left_g_less_copy_0 <= (forward_left_smallest_less + forward_left_start_cost_0) mod 512;
        forward_left_stay_change_0 <= (forward_cost_0_0 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_1 <= (forward_cost_0_1 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_2 <= (forward_cost_0_2 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_3 <= (forward_cost_0_3 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_4 <= (forward_cost_0_4 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_5 <= (forward_cost_0_5 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_6 <= (forward_cost_0_6 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_7 <= (forward_cost_0_7 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_8 <= (forward_cost_0_8 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_9 <= (forward_cost_0_9 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_10 <= (forward_cost_0_10 - forward_left_g_copy_0) mod 512;
        forward_left_stay_change_11 <= (forward_cost_0_11 - forward_left_g_copy_0) mod 512;
        forward_left_step_change_0 <= (forward_cost_0_0 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_1 <= (forward_cost_0_1 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_2 <= (forward_cost_0_2 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_3 <= (forward_cost_0_3 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_4 <= (forward_cost_0_4 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_5 <= (forward_cost_0_5 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_6 <= (forward_cost_0_6 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_7 <= (forward_cost_0_7 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_8 <= (forward_cost_0_8 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_9 <= (forward_cost_0_9 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_10 <= (forward_cost_0_10 - forward_left_g_less_copy_0) mod 512;
        forward_left_step_change_11 <= (forward_cost_0_11 - forward_left_g_less_copy_0) mod 512;
        forward_left_cost_0 <= (forward_left_cost_0_choice_2 + forward_left_stay_change_0) mod 512;
        forward_left_cost_1 <= (forward_left_cost_1_choice_2 + forward_left_stay_change_1) mod 512;
        forward_left_cost_2 <= (forward_left_cost_2_choice_2 + forward_left_stay_change_2) mod 512;
        forward_left_cost_3 <= (forward_left_cost_3_choice_2 + forward_left_stay_change_3) mod 512;
        forward_left_cost_4 <= (forward_left_cost_4_choice_2 + forward_left_stay_change_4) mod 512;
        forward_left_cost_5 <= (forward_left_cost_5_choice_2 + forward_left_stay_change_5) mod 512;
        forward_left_cost_6 <= (forward_left_cost_6_choice_2 + forward_left_stay_change_6) mod 512;
        forward_left_cost_7 <= (forward_left_cost_7_choice_2 + forward_left_stay_change_7) mod 512;
        forward_left_cost_8 <= (forward_left_cost_8_choice_2 + forward_left_stay_change_8) mod 512;
        forward_left_cost_9 <= (forward_left_cost_9_choice_2 + forward_left_stay_change_9) mod 512;
        forward_left_cost_10 <= (forward_left_cost_10_choice_2 + forward_left_stay_change_10) mod 512;
        forward_left_cost_11 <= (forward_left_cost_11_choice_2 + forward_left_stay_change_11) mod 512;
        forward_left_arrived_0 <= (forward_left_arrived_0_choice + forward_left_step_change_0) mod 512;
        forward_left_arrived_1 <= (forward_left_arrived_1_choice + forward_left_step_change_1) mod 512;
        forward_left_arrived_2 <= (forward_left_arrived_2_choice + forward_left_step_change_2) mod 512;
        forward_left_arrived_3 <= (forward_left_arrived_3_choice_2 + forward_left_step_change_3) mod 512;
        forward_left_arrived_4 <= (forward_left_arrived_4_choice_2 + forward_left_step_change_4) mod 512;
        forward_left_arrived_5 <= (forward_left_arrived_5_choice + forward_left_step_change_5) mod 512;
        forward_left_arrived_6 <= (forward_left_arrived_6_choice + forward_left_step_change_6) mod 512;
        forward_left_arrived_7 <= (forward_left_arrived_7_choice_2 + forward_left_step_change_7) mod 512;
        forward_left_arrived_8 <= (forward_left_arrived_8_choice_2 + forward_left_step_change_8) mod 512;
        forward_left_arrived_9 <= (forward_left_arrived_9_choice + forward_left_step_change_9) mod 512;
        forward_left_arrived_10 <= (forward_left_arrived_10_choice + forward_left_step_change_10) mod 512;
        forward_left_arrived_11 <= (forward_left_arrived_11_choice + forward_left_step_change_11) mod 512;
        forward_above_ready_words_0 <= forward_above_read_words_0;
        forward_above_ready_words_1 <= forward_above_read_words_1;
        forward_above_ready_cost_0 <= entry_cost_0;
        forward_above_ready_cost_1 <= entry_cost_1;
        forward_above_ready_cost_2 <= entry_cost_2;
        forward_above_ready_cost_3 <= entry_cost_3;
        forward_above_ready_cost_4 <= entry_cost_4;
        forward_above_ready_cost_5 <= entry_cost_5;
        forward_above_ready_cost_6 <= entry_cost_6;
        forward_above_ready_cost_7 <= entry_cost_7;
        forward_above_ready_cost_8 <= entry_cost_8;
        forward_above_ready_cost_9 <= entry_cost_9;
        forward_above_ready_cost_10 <= entry_cost_10;
        forward_above_ready_cost_11 <= entry_cost_11;
        forward_above_ready_top <= entry_top;
        forward_above_total_0 <= (forward_above_total_0_choice + forward_above_ready_cost_0) mod 256;
        forward_above_total_1 <= (forward_above_total_1_choice + forward_above_ready_cost_1) mod 256;
        forward_above_total_2 <= (forward_above_total_2_choice + forward_above_ready_cost_2) mod 256;
        forward_above_total_3 <= (forward_above_total_3_choice + forward_above_ready_cost_3) mod 256;
        forward_above_total_4 <= (forward_above_total_4_choice + forward_above_ready_cost_4) mod 256;
        forward_above_total_5 <= (forward_above_total_5_choice + forward_above_ready_cost_5) mod 256;
        forward_above_total_6 <= (forward_above_total_6_choice + forward_above_ready_cost_6) mod 256;
        forward_above_total_7 <= (forward_above_total_7_choice + forward_above_ready_cost_7) mod 256;
        forward_above_total_8 <= (forward_above_total_8_choice + forward_above_ready_cost_8) mod 256;
        forward_above_total_9 <= (forward_above_total_9_choice + forward_above_ready_cost_9) mod 256;
        forward_above_total_10 <= (forward_above_total_10_choice + forward_above_ready_cost_10) mod 256;
        forward_above_total_11 <= (forward_above_total_11_choice + forward_above_ready_cost_11) mod 256;
        forward_above_tree_next_next_smallest_1 <= forward_above_tree_next_smallest_2;
        forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
        forward_above_smallest_copy_0 <= forward_above_tree_next_next_next_smallest_0;
        forward_above_cost_0 <= (to_integer(forward_above_delay_held_0) - forward_above_smallest_copy_0) mod 128;
        forward_above_cost_1 <= (to_integer(forward_above_delay_held_0(28 downto 7)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_2 <= (to_integer(forward_above_delay_held_0(28 downto 14)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_3 <= (to_integer(forward_above_delay_held_0(28 downto 21)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_4 <= (to_integer(forward_above_delay_held_1) - forward_above_smallest_copy_0) mod 128;
        forward_above_cost_5 <= (to_integer(forward_above_delay_held_1(28 downto 7)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_6 <= (to_integer(forward_above_delay_held_1(28 downto 14)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_7 <= (to_integer(forward_above_delay_held_1(28 downto 21)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_8 <= (to_integer(forward_above_delay_held_2) - forward_above_smallest_copy_0) mod 128;
        forward_above_cost_9 <= (to_integer(forward_above_delay_held_2(28 downto 7)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_10 <= (to_integer(forward_above_delay_held_2(28 downto 14)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_cost_11 <= (to_integer(forward_above_delay_held_2(28 downto 21)) - forward_above_smallest_copy_0)
          mod 128;
        forward_above_beside_0 <= forward_above_cost_1;
        forward_above_beside_11 <= forward_above_cost_10;
        forward_above_own_0 <= forward_above_cost_0;
        forward_above_own_2 <= forward_above_cost_2;
        forward_above_own_3 <= forward_above_cost_3;
        forward_above_own_4 <= forward_above_cost_4;
        forward_above_own_5 <= forward_above_cost_5;
        forward_above_own_6 <= forward_above_cost_6;
        forward_above_own_7 <= forward_above_cost_7;
        forward_above_own_8 <= forward_above_cost_8;
        forward_above_own_9 <= forward_above_cost_9;
        forward_above_own_11 <= forward_above_cost_11;
        forward_above_step_0 <= forward_above_beside_0 + 5;
        forward_above_step_1 <= forward_above_beside_1 + 5;
        forward_above_step_2 <= forward_above_beside_2 + 5;
        forward_above_step_3 <= forward_above_beside_3 + 5;
        forward_above_step_4 <= forward_above_beside_4 + 5;
        forward_above_step_5 <= forward_above_beside_5 + 5;
        forward_above_step_6 <= forward_above_beside_6 + 5;
        forward_above_step_7 <= forward_above_beside_7 + 5;
        forward_above_step_8 <= forward_above_beside_8 + 5;
        forward_above_step_9 <= forward_above_beside_9 + 5;
        forward_above_step_10 <= forward_above_beside_10 + 5;
        forward_above_step_11 <= forward_above_beside_11 + 5;
        forward_above_comes_0 <= entry_tag_map_column;
        forward_above_comes_1 <= forward_above_comes_0;
        forward_above_comes_2 <= forward_above_comes_1;
        forward_above_comes_3 <= forward_above_comes_2;
        forward_above_comes_4 <= forward_above_comes_3;
        forward_above_comes_5 <= forward_above_comes_4;
        forward_above_comes_6 <= forward_above_comes_5;
        forward_above_comes_7 <= forward_above_comes_6;
        forward_above_comes_8 <= forward_above_comes_7;
        forward_above_comes_9 <= forward_above_comes_8;
        forward_above_column_0 <= entry_column;
        forward_above_column_1 <= forward_above_column_0;
        forward_above_column_2 <= forward_above_column_1;
        forward_above_column_3 <= forward_above_column_2;
        forward_above_column_4 <= forward_above_column_3;
        forward_above_column_5 <= forward_above_column_4;
        forward_above_column_6 <= forward_above_column_5;
        forward_above_column_7 <= forward_above_column_6;
        forward_above_column_8 <= forward_above_column_7;
        forward_above_column_9 <= forward_above_column_8;
        forward_sum_0 <= (forward_left_cost_0 + forward_above_cost_0) mod 512;
        forward_sum_1 <= (forward_left_cost_1 + forward_above_cost_1) mod 512;
        forward_sum_2 <= (forward_left_cost_2 + forward_above_cost_2) mod 512;
        forward_sum_3 <= (forward_left_cost_3 + forward_above_cost_3) mod 512;
        forward_sum_4 <= (forward_left_cost_4 + forward_above_cost_4) mod 512;
        forward_sum_5 <= (forward_left_cost_5 + forward_above_cost_5) mod 512;
        forward_sum_6 <= (forward_left_cost_6 + forward_above_cost_6) mod 512;
        forward_sum_7 <= (forward_left_cost_7 + forward_above_cost_7) mod 512;
        forward_sum_8 <= (forward_left_cost_8 + forward_above_cost_8) mod 512;
        forward_sum_9 <= (forward_left_cost_9 + forward_above_cost_9) mod 512;
        forward_sum_10 <= (forward_left_cost_10 + forward_above_cost_10) mod 512;
        forward_sum_11 <= (forward_left_cost_11 + forward_above_cost_11) mod 512;
        forward_first_0 <= entry_turned_first_column;
        forward_first_1 <= forward_first_0;
        forward_first_2 <= forward_first_1;
        forward_first_3 <= forward_first_2;
        forward_first_4 <= forward_first_3;
        forward_first_5 <= forward_first_4;
        forward_first_6 <= forward_first_5;
        forward_first_7 <= forward_first_6;
        forward_first_8 <= forward_first_7;
        forward_cost_0_0 <= to_integer(forward_cost_delay_held_0(5 downto 0));
        forward_cost_0_1 <= to_integer(forward_cost_delay_held_0(11 downto 6));
        forward_cost_0_2 <= to_integer(forward_cost_delay_held_0(17 downto 12));
        forward_cost_0_3 <= to_integer(forward_cost_delay_held_0(23 downto 18));
        forward_cost_0_4 <= to_integer(forward_cost_delay_held_0(29 downto 24));
        forward_cost_0_5 <= to_integer(forward_cost_delay_held_1(5 downto 0));
        forward_cost_0_6 <= to_integer(forward_cost_delay_held_1(11 downto 6));
        forward_cost_0_7 <= to_integer(forward_cost_delay_held_1(17 downto 12));
        forward_cost_0_8 <= to_integer(forward_cost_delay_held_1(23 downto 18));
        forward_cost_0_9 <= to_integer(forward_cost_delay_held_1(29 downto 24));
        forward_cost_0_10 <= to_integer(forward_cost_delay_held_2(5 downto 0));
        forward_cost_0_11 <= to_integer(forward_cost_delay_held_2(11 downto 6));
        forward_cost_1_0 <= forward_cost_0_0;
        forward_cost_1_1 <= forward_cost_0_1;
        forward_cost_1_2 <= forward_cost_0_2;
        forward_cost_1_3 <= forward_cost_0_3;
        forward_cost_1_4 <= forward_cost_0_4;
        forward_cost_1_5 <= forward_cost_0_5;
        forward_cost_1_6 <= forward_cost_0_6;
        forward_cost_1_7 <= forward_cost_0_7;
        forward_cost_1_8 <= forward_cost_0_8;
        forward_cost_1_9 <= forward_cost_0_9;
        forward_cost_1_10 <= forward_cost_0_10;
        forward_cost_1_11 <= forward_cost_0_11;
        forward_cost_2_0 <= forward_cost_1_0;
        forward_cost_2_1 <= forward_cost_1_1;
        forward_cost_2_2 <= forward_cost_1_2;
        forward_cost_2_3 <= forward_cost_1_3;
        forward_cost_2_4 <= forward_cost_1_4;
        forward_cost_2_5 <= forward_cost_1_5;
        forward_cost_2_6 <= forward_cost_1_6;
        forward_cost_2_7 <= forward_cost_1_7;
        forward_cost_2_8 <= forward_cost_1_8;
        forward_cost_2_9 <= forward_cost_1_9;
        forward_cost_2_10 <= forward_cost_1_10;
        forward_cost_2_11 <= forward_cost_1_11;
        forward_cost_3_0 <= forward_cost_2_0;
        forward_cost_3_1 <= forward_cost_2_1;
        forward_cost_3_2 <= forward_cost_2_2;
        forward_cost_3_3 <= forward_cost_2_3;
        forward_cost_3_4 <= forward_cost_2_4;
        forward_cost_3_5 <= forward_cost_2_5;
        forward_cost_3_6 <= forward_cost_2_6;
        forward_cost_3_7 <= forward_cost_2_7;
        forward_cost_3_8 <= forward_cost_2_8;
        forward_cost_3_9 <= forward_cost_2_9;
        forward_cost_3_10 <= forward_cost_2_10;
        forward_cost_3_11 <= forward_cost_2_11;
        forward_smallest_cost_0 <= forward_smallest_next_next_next_smallest_0;
        forward_smallest_cost_1 <= forward_smallest_cost_0;
        forward_smallest_cost_2 <= forward_smallest_cost_1;
        forward_smallest_cost_3 <= forward_smallest_cost_2;
        forward_smallest_cost_4 <= forward_smallest_cost_3;
        if (entry_cost_1 - entry_cost_0) < 0 then
          forward_smallest_smallest_0 <= entry_cost_1;
        else
          forward_smallest_smallest_0 <= entry_cost_0;
        end if;
        if (entry_cost_3 - entry_cost_2) < 0 then
          forward_smallest_smallest_1 <= entry_cost_3;
        else
          forward_smallest_smallest_1 <= entry_cost_2;
        end if;
        if (entry_cost_5 - entry_cost_4) < 0 then
          forward_smallest_smallest_2 <= entry_cost_5;
        else
          forward_smallest_smallest_2 <= entry_cost_4;
        end if;
        if (entry_cost_7 - entry_cost_6) < 0 then
          forward_smallest_smallest_3 <= entry_cost_7;
        else
          forward_smallest_smallest_3 <= entry_cost_6;
        end if;
        if (entry_cost_9 - entry_cost_8) < 0 then
          forward_smallest_smallest_4 <= entry_cost_9;
        else
          forward_smallest_smallest_4 <= entry_cost_8;
        end if;
        if (entry_cost_11 - entry_cost_10) < 0 then
          forward_smallest_smallest_5 <= entry_cost_11;
        else
          forward_smallest_smallest_5 <= entry_cost_10;
        end if;
        if (forward_smallest_smallest_1 - forward_smallest_smallest_0) < 0 then
          forward_smallest_next_smallest_0 <= forward_smallest_smallest_1;
        else
          forward_smallest_next_smallest_0 <= forward_smallest_smallest_0;
        end if;
        if (forward_smallest_smallest_3 - forward_smallest_smallest_2) < 0 then
          forward_smallest_next_smallest_1 <= forward_smallest_smallest_3;
        else
          forward_smallest_next_smallest_1 <= forward_smallest_smallest_2;
        end if;
        if (forward_smallest_smallest_5 - forward_smallest_smallest_4) < 0 then
          forward_smallest_next_smallest_2 <= forward_smallest_smallest_5;
        else
          forward_smallest_next_smallest_2 <= forward_smallest_smallest_4;
        end if;
        if (forward_smallest_next_smallest_1 - forward_smallest_next_smallest_0) < 0 then
          forward_smallest_next_next_smallest_0 <= forward_smallest_next_smallest_1;
        else
          forward_smallest_next_next_smallest_0 <= forward_smallest_next_smallest_0;
        end if;
        if (forward_smallest_next_next_smallest_1 - forward_smallest_next_next_smallest_0) < 0 then
          forward_smallest_next_next_next_smallest_0 <= forward_smallest_next_next_smallest_1;
        else
          forward_smallest_next_next_next_smallest_0 <= forward_smallest_next_next_smallest_0;
        end if;
        if forward_cost_delay_ring_read_address = 4 then
          forward_cost_delay_ring_read_address <= 0;
        else
          forward_cost_delay_ring_read_address <= (forward_cost_delay_ring_read_address + 1) mod 8;
        end if;
        if (forward_left_pair_1 - forward_left_pair_0) < 0 then
          forward_left_tree_smallest_0 <= forward_left_pair_1;
        else
          forward_left_tree_smallest_0 <= forward_left_pair_0;
        end if;
        if (forward_left_pair_3 - forward_left_pair_2) < 0 then
          forward_left_tree_smallest_1 <= forward_left_pair_3;
        else
          forward_left_tree_smallest_1 <= forward_left_pair_2;
        end if;
        if (forward_left_pair_5 - forward_left_pair_4) < 0 then
          forward_left_tree_smallest_2 <= forward_left_pair_5;
        else
          forward_left_tree_smallest_2 <= forward_left_pair_4;
        end if;
        if (forward_left_tree_smallest_1 - forward_left_tree_smallest_0) < 0 then
          forward_left_tree_next_smallest_0 <= forward_left_tree_smallest_1;
        else
          forward_left_tree_next_smallest_0 <= forward_left_tree_smallest_0;
        end if;
        if (forward_left_tree_next_smallest_1 - forward_left_tree_next_smallest_0) < 0 then
          forward_left_tree_next_next_smallest_0 <= forward_left_tree_next_smallest_1;
        else
          forward_left_tree_next_next_smallest_0 <= forward_left_tree_next_smallest_0;
        end if;
        if sums_turn_waiting_first_3 then
          forward_left_start_cost_0 <= 22;
          forward_left_start_cost_1 <= 0;
          forward_left_start_cost_2 <= 0;
          forward_left_start_cost_3 <= 0;
          forward_left_start_cost_4 <= 0;
          forward_left_start_cost_5 <= 0;
          forward_left_start_cost_6 <= 0;
          forward_left_room <= 0;
        else
          forward_left_start_cost_0 <= forward_left_start_cost_0_choice_2;
          forward_left_start_cost_1 <= forward_left_start_cost_0;
          forward_left_start_cost_2 <= forward_left_start_cost_1;
          forward_left_start_cost_3 <= forward_left_start_cost_2;
          forward_left_start_cost_4 <= forward_left_start_cost_3;
          forward_left_start_cost_5 <= forward_left_start_cost_4;
          forward_left_start_cost_6 <= forward_left_start_cost_5;
          forward_left_room <= (forward_left_room_choice_2 + forward_left_start_cost_6) mod 32;
        end if;
        if (forward_above_total_1 - forward_above_total_0) < 0 then
          forward_above_tree_smallest_0 <= forward_above_total_1;
        else
          forward_above_tree_smallest_0 <= forward_above_total_0;
        end if;
        if (forward_above_total_3 - forward_above_total_2) < 0 then
          forward_above_tree_smallest_1 <= forward_above_total_3;
        else
          forward_above_tree_smallest_1 <= forward_above_total_2;
        end if;
        if (forward_above_total_5 - forward_above_total_4) < 0 then
          forward_above_tree_smallest_2 <= forward_above_total_5;
        else
          forward_above_tree_smallest_2 <= forward_above_total_4;
        end if;
        if (forward_above_total_7 - forward_above_total_6) < 0 then
          forward_above_tree_smallest_3 <= forward_above_total_7;
        else
          forward_above_tree_smallest_3 <= forward_above_total_6;
        end if;
        if (forward_above_total_9 - forward_above_total_8) < 0 then
          forward_above_tree_smallest_4 <= forward_above_total_9;
        else
          forward_above_tree_smallest_4 <= forward_above_total_8;
        end if;
        if (forward_above_total_11 - forward_above_total_10) < 0 then
          forward_above_tree_smallest_5 <= forward_above_total_11;
        else
          forward_above_tree_smallest_5 <= forward_above_total_10;
        end if;
        if (forward_above_tree_smallest_1 - forward_above_tree_smallest_0) < 0 then
          forward_above_tree_next_smallest_0 <= forward_above_tree_smallest_1;
        else
          forward_above_tree_next_smallest_0 <= forward_above_tree_smallest_0;
        end if;
        if (forward_above_tree_smallest_3 - forward_above_tree_smallest_2) < 0 then
          forward_above_tree_next_smallest_1 <= forward_above_tree_smallest_3;
        else
          forward_above_tree_next_smallest_1 <= forward_above_tree_smallest_2;
        end if;
        if (forward_above_tree_smallest_5 - forward_above_tree_smallest_4) < 0 then
          forward_above_tree_next_smallest_2 <= forward_above_tree_smallest_5;
        else
          forward_above_tree_next_smallest_2 <= forward_above_tree_smallest_4;
        end if;
        if (forward_above_tree_next_smallest_1 - forward_above_tree_next_smallest_0) < 0 then
          forward_above_tree_next_next_smallest_0 <= forward_above_tree_next_smallest_1;
        else
          forward_above_tree_next_next_smallest_0 <= forward_above_tree_next_smallest_0;
        end if;
        if (forward_above_tree_next_next_smallest_1 - forward_above_tree_next_next_smallest_0) < 0 then
          forward_above_tree_next_next_next_smallest_0 <= forward_above_tree_next_next_smallest_1;
        else
          forward_above_tree_next_next_next_smallest_0 <= forward_above_tree_next_next_smallest_0;
        end if;
        if forward_above_delay_ring_read_address = 4 then
          forward_above_delay_ring_read_address <= 0;
        else
          forward_above_delay_ring_read_address <= (forward_above_delay_ring_read_address + 1) mod 8;
        end if;
        if (forward_above_cost_2 - forward_above_cost_0) < 0 then
          forward_above_beside_1 <= forward_above_cost_2;
        else
          forward_above_beside_1 <= forward_above_cost_0;
        end if;
        if (forward_above_cost_3 - forward_above_cost_1) < 0 then
          forward_above_beside_2 <= forward_above_cost_3;
        else
          forward_above_beside_2 <= forward_above_cost_1;
        end if;
        if (forward_above_cost_4 - forward_above_cost_2) < 0 then
          forward_above_beside_3 <= forward_above_cost_4;
        else
          forward_above_beside_3 <= forward_above_cost_2;
        end if;
        if (forward_above_cost_5 - forward_above_cost_3) < 0 then
          forward_above_beside_4 <= forward_above_cost_5;
        else
          forward_above_beside_4 <= forward_above_cost_3;
        end if;
        if (forward_above_cost_6 - forward_above_cost_4) < 0 then
          forward_above_beside_5 <= forward_above_cost_6;
        else
          forward_above_beside_5 <= forward_above_cost_4;
        end if;
        if (forward_above_cost_7 - forward_above_cost_5) < 0 then
          forward_above_beside_6 <= forward_above_cost_7;
        else
          forward_above_beside_6 <= forward_above_cost_5;
        end if;
        if (forward_above_cost_8 - forward_above_cost_6) < 0 then
          forward_above_beside_7 <= forward_above_cost_8;
        else
          forward_above_beside_7 <= forward_above_cost_6;
        end if;
        if (forward_above_cost_9 - forward_above_cost_7) < 0 then
          forward_above_beside_8 <= forward_above_cost_9;
        else
          forward_above_beside_8 <= forward_above_cost_7;
        end if;
        if (forward_above_cost_10 - forward_above_cost_8) < 0 then
          forward_above_beside_9 <= forward_above_cost_10;
        else
          forward_above_beside_9 <= forward_above_cost_8;
        end if;
        if (forward_above_cost_11 - forward_above_cost_9) < 0 then
          forward_above_beside_10 <= forward_above_cost_11;
        else
          forward_above_beside_10 <= forward_above_cost_9;
        end if;
        if forward_above_own_0 < 22 then
          forward_above_stay_0 <= forward_above_own_0 mod 32;
        else
          forward_above_stay_0 <= 22;
        end if;
        if forward_above_beside_0 < 22 then
          forward_above_stay_1 <= forward_above_beside_0 mod 32;
        else
          forward_above_stay_1 <= 22;
        end if;
        if forward_above_own_2 < 22 then
          forward_above_stay_2 <= forward_above_own_2 mod 32;
        else
          forward_above_stay_2 <= 22;
        end if;
        if forward_above_own_3 < 22 then
          forward_above_stay_3 <= forward_above_own_3 mod 32;
        else
          forward_above_stay_3 <= 22;
        end if;
        if forward_above_own_4 < 22 then
          forward_above_stay_4 <= forward_above_own_4 mod 32;
        else
          forward_above_stay_4 <= 22;
        end if;
        if forward_above_own_5 < 22 then
          forward_above_stay_5 <= forward_above_own_5 mod 32;
        else
          forward_above_stay_5 <= 22;
        end if;
        if forward_above_own_6 < 22 then
          forward_above_stay_6 <= forward_above_own_6 mod 32;
        else
          forward_above_stay_6 <= 22;
        end if;
        if forward_above_own_7 < 22 then
          forward_above_stay_7 <= forward_above_own_7 mod 32;
        else
          forward_above_stay_7 <= 22;
        end if;
        if forward_above_own_8 < 22 then
          forward_above_stay_8 <= forward_above_own_8 mod 32;
        else
          forward_above_stay_8 <= 22;
        end if;
        if forward_above_own_9 < 22 then
          forward_above_stay_9 <= forward_above_own_9 mod 32;
        else
          forward_above_stay_9 <= 22;
        end if;
        if forward_above_beside_11 < 22 then
          forward_above_stay_10 <= forward_above_beside_11 mod 32;
        else
          forward_above_stay_10 <= 22;
        end if;
        if forward_above_own_11 < 22 then
          forward_above_stay_11 <= forward_above_own_11 mod 32;
        else
          forward_above_stay_11 <= 22;
        end if;
      end if;
      if entry_tag_valid then
        forward_above_writes_copy_0_choice := forward_above_comes_8;
      else
        forward_above_writes_copy_0_choice := forward_above_comes_9;
      end if;
      forward_above_writes_copy_0 <= entry_next_tag_valid and forward_above_writes_copy_0_choice;
      if (forward_above_step_4 - forward_above_stay_4) < 0 then
        forward_above_write_words_0_choice := forward_above_step_4;
      else
        forward_above_write_words_0_choice := forward_above_stay_4;
      end if;
      if (forward_above_step_5 - forward_above_stay_5) < 0 then
        forward_above_write_words_0_choice_2 := forward_above_step_5 mod 128;
      else
        forward_above_write_words_0_choice_2 := forward_above_stay_5;
      end if;
      if (forward_above_step_3 - forward_above_stay_3) < 0 then
        forward_above_write_words_0_choice_3 := forward_above_step_3;
      else
        forward_above_write_words_0_choice_3 := forward_above_stay_3;
      end if;
      if (forward_above_step_2 - forward_above_stay_2) < 0 then
        forward_above_write_words_0_choice_4 := forward_above_step_2;
      else
        forward_above_write_words_0_choice_4 := forward_above_stay_2;
      end if;
      if (forward_above_step_0 - forward_above_stay_0) < 0 then
        forward_above_write_words_0_choice_5 := forward_above_step_0;
      else
        forward_above_write_words_0_choice_5 := forward_above_stay_0;
      end if;
      if (forward_above_step_1 - forward_above_stay_1) < 0 then
        forward_above_write_words_0_choice_6 := forward_above_step_1;
      else
        forward_above_write_words_0_choice_6 := forward_above_stay_1;
      end if;
      if (forward_above_step_10 - forward_above_stay_10) < 0 then
        forward_above_write_words_1_choice := forward_above_step_10;
      else
        forward_above_write_words_1_choice := forward_above_stay_10;
      end if;
      if (forward_above_step_11 - forward_above_stay_11) < 0 then
        forward_above_write_words_1_choice_2 := forward_above_step_11 mod 128;
      else
        forward_above_write_words_1_choice_2 := forward_above_stay_11;
      end if;
      if (forward_above_step_9 - forward_above_stay_9) < 0 then
        forward_above_write_words_1_choice_3 := forward_above_step_9;
      else
        forward_above_write_words_1_choice_3 := forward_above_stay_9;
      end if;
      if (forward_above_step_8 - forward_above_stay_8) < 0 then
        forward_above_write_words_1_choice_4 := forward_above_step_8;
      else
        forward_above_write_words_1_choice_4 := forward_above_stay_8;
      end if;
      if (forward_above_step_6 - forward_above_stay_6) < 0 then
        forward_above_write_words_1_choice_5 := forward_above_step_6;
      else
        forward_above_write_words_1_choice_5 := forward_above_stay_6;
      end if;
      if (forward_above_step_7 - forward_above_stay_7) < 0 then
        forward_above_write_words_1_choice_6 := forward_above_step_7;
      else
        forward_above_write_words_1_choice_6 := forward_above_stay_7;
      end if;
      if forward_above_writes_copy_0 then
        forward_above_write_words_0 <= ((((((((((to_unsigned(forward_above_write_words_0_choice, 12) & to_unsigned(0,
          20)) or (to_unsigned(forward_above_write_words_0_choice_2, 7) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_0_choice_3, 17) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_0_choice_4, 22) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_0_choice_5, 32)))) or
          (to_unsigned(forward_above_write_words_0_choice_6, 27) & to_unsigned(0, 5)));
        forward_above_write_words_1 <= ((((((((((to_unsigned(forward_above_write_words_1_choice, 12) & to_unsigned(0,
          20)) or (to_unsigned(forward_above_write_words_1_choice_2, 7) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_1_choice_3, 17) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_1_choice_4, 22) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_1_choice_5, 32)))) or
          (to_unsigned(forward_above_write_words_1_choice_6, 27) & to_unsigned(0, 5)));
        forward_above_write_column <= forward_above_column_9;
      end if;
      -- sums
      if (sums_right_cost_2 - sums_right_cost_0) < 0 then
        sums_right_pair_0_choice := sums_right_cost_2;
      else
        sums_right_pair_0_choice := sums_right_cost_0;
      end if;
      if (sums_right_cost_3 - sums_right_cost_1) < 0 then
        sums_right_pair_1_choice := sums_right_cost_3;
      else
        sums_right_pair_1_choice := sums_right_cost_1;
      end if;
      if (sums_right_cost_6 - sums_right_cost_4) < 0 then
        sums_right_pair_2_choice := sums_right_cost_6;
      else
        sums_right_pair_2_choice := sums_right_cost_4;
      end if;
      if (sums_right_cost_7 - sums_right_cost_5) < 0 then
        sums_right_pair_3_choice := sums_right_cost_7;
      else
        sums_right_pair_3_choice := sums_right_cost_5;
      end if;
      if (sums_right_cost_10 - sums_right_cost_8) < 0 then
        sums_right_pair_4_choice := sums_right_cost_10;
      else
        sums_right_pair_4_choice := sums_right_cost_8;
      end if;
      if (sums_right_cost_11 - sums_right_cost_9) < 0 then
        sums_right_pair_5_choice := sums_right_cost_11;
      else
        sums_right_pair_5_choice := sums_right_cost_9;
      end if;
      sums_right_start_cost_0_is_less := 255 < sums_right_tree_next_next_smallest_0;
      sums_right_start_cost_0_is_less_2 := 255 < ((sums_right_tree_next_next_smallest_0 mod 256) + sums_right_room);
      if sums_right_start_cost_0_is_less_2 then
        sums_right_start_cost_0_choice := (sums_right_tree_next_next_smallest_0 + sums_right_room) mod 256;
      else
        sums_right_start_cost_0_choice := 0;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_start_cost_0_choice_2 := sums_right_room;
      else
        sums_right_start_cost_0_choice_2 := sums_right_start_cost_0_choice;
      end if;
      if sums_right_start_cost_0_is_less_2 then
        sums_right_room_choice := (0 - sums_right_tree_next_next_smallest_0) mod 32;
      else
        sums_right_room_choice := sums_right_room;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_room_choice_2 := 0;
      else
        sums_right_room_choice_2 := sums_right_room_choice;
      end if;
      if (sums_right_arrived_0 - sums_right_cost_0) < 0 then
        sums_right_cost_0_choice := sums_right_arrived_0;
      else
        sums_right_cost_0_choice := sums_right_cost_0;
      end if;
      if (255 < sums_right_cost_0_choice) or sums_tags_held_12_first_column then
        sums_right_cost_0_choice_2 := 256;
      else
        sums_right_cost_0_choice_2 := sums_right_cost_0_choice;
      end if;
      if (sums_right_arrived_1 - sums_right_cost_1) < 0 then
        sums_right_cost_1_choice := sums_right_arrived_1;
      else
        sums_right_cost_1_choice := sums_right_cost_1;
      end if;
      if (255 < sums_right_cost_1_choice) or sums_tags_held_12_first_column then
        sums_right_cost_1_choice_2 := 256;
      else
        sums_right_cost_1_choice_2 := sums_right_cost_1_choice;
      end if;
      if (sums_right_arrived_2 - sums_right_cost_2) < 0 then
        sums_right_cost_2_choice := sums_right_arrived_2;
      else
        sums_right_cost_2_choice := sums_right_cost_2;
      end if;
      if (255 < sums_right_cost_2_choice) or sums_tags_held_12_first_column then
        sums_right_cost_2_choice_2 := 256;
      else
        sums_right_cost_2_choice_2 := sums_right_cost_2_choice;
      end if;
      if (sums_right_arrived_3 - sums_right_cost_3) < 0 then
        sums_right_cost_3_choice := sums_right_arrived_3;
      else
        sums_right_cost_3_choice := sums_right_cost_3;
      end if;
      if (255 < sums_right_cost_3_choice) or sums_tags_held_12_first_column then
        sums_right_cost_3_choice_2 := 256;
      else
        sums_right_cost_3_choice_2 := sums_right_cost_3_choice;
      end if;
      if (sums_right_arrived_4 - sums_right_cost_4) < 0 then
        sums_right_cost_4_choice := sums_right_arrived_4;
      else
        sums_right_cost_4_choice := sums_right_cost_4;
      end if;
      if (255 < sums_right_cost_4_choice) or sums_tags_held_12_first_column then
        sums_right_cost_4_choice_2 := 256;
      else
        sums_right_cost_4_choice_2 := sums_right_cost_4_choice;
      end if;
      if (sums_right_arrived_5 - sums_right_cost_5) < 0 then
        sums_right_cost_5_choice := sums_right_arrived_5;
      else
        sums_right_cost_5_choice := sums_right_cost_5;
      end if;
      if (255 < sums_right_cost_5_choice) or sums_tags_held_12_first_column then
        sums_right_cost_5_choice_2 := 256;
      else
        sums_right_cost_5_choice_2 := sums_right_cost_5_choice;
      end if;
      if (sums_right_arrived_6 - sums_right_cost_6) < 0 then
        sums_right_cost_6_choice := sums_right_arrived_6;
      else
        sums_right_cost_6_choice := sums_right_cost_6;
      end if;
      if (255 < sums_right_cost_6_choice) or sums_tags_held_12_first_column then
        sums_right_cost_6_choice_2 := 256;
      else
        sums_right_cost_6_choice_2 := sums_right_cost_6_choice;
      end if;
      if (sums_right_arrived_7 - sums_right_cost_7) < 0 then
        sums_right_cost_7_choice := sums_right_arrived_7;
      else
        sums_right_cost_7_choice := sums_right_cost_7;
      end if;
      if (255 < sums_right_cost_7_choice) or sums_tags_held_12_first_column then
        sums_right_cost_7_choice_2 := 256;
      else
        sums_right_cost_7_choice_2 := sums_right_cost_7_choice;
      end if;
      if (sums_right_arrived_8 - sums_right_cost_8) < 0 then
        sums_right_cost_8_choice := sums_right_arrived_8;
      else
        sums_right_cost_8_choice := sums_right_cost_8;
      end if;
      if (255 < sums_right_cost_8_choice) or sums_tags_held_12_first_column then
        sums_right_cost_8_choice_2 := 256;
      else
        sums_right_cost_8_choice_2 := sums_right_cost_8_choice;
      end if;
      if (sums_right_arrived_9 - sums_right_cost_9) < 0 then
        sums_right_cost_9_choice := sums_right_arrived_9;
      else
        sums_right_cost_9_choice := sums_right_cost_9;
      end if;
      if (255 < sums_right_cost_9_choice) or sums_tags_held_12_first_column then
        sums_right_cost_9_choice_2 := 256;
      else
        sums_right_cost_9_choice_2 := sums_right_cost_9_choice;
      end if;
      if (sums_right_arrived_10 - sums_right_cost_10) < 0 then
        sums_right_cost_10_choice := sums_right_arrived_10;
      else
        sums_right_cost_10_choice := sums_right_cost_10;
      end if;
      if (255 < sums_right_cost_10_choice) or sums_tags_held_12_first_column then
        sums_right_cost_10_choice_2 := 256;
      else
        sums_right_cost_10_choice_2 := sums_right_cost_10_choice;
      end if;
      if (sums_right_arrived_11 - sums_right_cost_11) < 0 then
        sums_right_cost_11_choice := sums_right_arrived_11;
      else
        sums_right_cost_11_choice := sums_right_cost_11;
      end if;
      if (255 < sums_right_cost_11_choice) or sums_tags_held_12_first_column then
        sums_right_cost_11_choice_2 := 256;
      else
        sums_right_cost_11_choice_2 := sums_right_cost_11_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_0_choice := 256;
      else
        sums_right_arrived_0_choice := sums_right_cost_1;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_1_choice := 256;
      else
        sums_right_arrived_1_choice := sums_right_pair_0_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_2_choice := 256;
      else
        sums_right_arrived_2_choice := sums_right_pair_1_choice;
      end if;
      if (sums_right_cost_4 - sums_right_cost_2) < 0 then
        sums_right_arrived_3_choice := sums_right_cost_4;
      else
        sums_right_arrived_3_choice := sums_right_cost_2;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_3_choice_2 := 256;
      else
        sums_right_arrived_3_choice_2 := sums_right_arrived_3_choice;
      end if;
      if (sums_right_cost_5 - sums_right_cost_3) < 0 then
        sums_right_arrived_4_choice := sums_right_cost_5;
      else
        sums_right_arrived_4_choice := sums_right_cost_3;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_4_choice_2 := 256;
      else
        sums_right_arrived_4_choice_2 := sums_right_arrived_4_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_5_choice := 256;
      else
        sums_right_arrived_5_choice := sums_right_pair_2_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_6_choice := 256;
      else
        sums_right_arrived_6_choice := sums_right_pair_3_choice;
      end if;
      if (sums_right_cost_8 - sums_right_cost_6) < 0 then
        sums_right_arrived_7_choice := sums_right_cost_8;
      else
        sums_right_arrived_7_choice := sums_right_cost_6;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_7_choice_2 := 256;
      else
        sums_right_arrived_7_choice_2 := sums_right_arrived_7_choice;
      end if;
      if (sums_right_cost_9 - sums_right_cost_7) < 0 then
        sums_right_arrived_8_choice := sums_right_cost_9;
      else
        sums_right_arrived_8_choice := sums_right_cost_7;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_8_choice_2 := 256;
      else
        sums_right_arrived_8_choice_2 := sums_right_arrived_8_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_9_choice := 256;
      else
        sums_right_arrived_9_choice := sums_right_pair_4_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_10_choice := 256;
      else
        sums_right_arrived_10_choice := sums_right_pair_5_choice;
      end if;
      if sums_tags_held_12_first_column then
        sums_right_arrived_11_choice := 256;
      else
        sums_right_arrived_11_choice := sums_right_cost_10;
      end if;
      if entry_tag_valid then
        sums_turn_ready_sums_0 <= to_integer(sums_turn_read_sums_0);
        sums_turn_ready_sums_1 <= to_integer(sums_turn_read_sums_1);
        sums_turn_ready_sums_2 <= to_integer(sums_turn_read_sums_2);
        sums_turn_ready_sums_3 <= to_integer(sums_turn_read_sums_3);
        sums_turn_ready_costs_0 <= to_integer(sums_turn_read_costs_0);
        sums_turn_ready_costs_1 <= to_integer(sums_turn_read_costs_1);
        sums_turn_ready_costs_2 <= to_integer(sums_turn_read_costs_2);
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= forward_first_8;
        sums_turn_place_0 <= entry_place;
        sums_turn_place_1 <= sums_turn_place_0;
        sums_turn_place_2 <= sums_turn_place_1;
        sums_turn_place_3 <= sums_turn_place_2;
        sums_turn_place_4 <= sums_turn_place_3;
        sums_turn_place_5 <= sums_turn_place_4;
        sums_turn_place_6 <= sums_turn_place_5;
        sums_turn_place_7 <= sums_turn_place_6;
        sums_turn_place_8 <= sums_turn_place_7;
        sums_turn_waiting_first_0 <= entry_tag_first_column;
        sums_turn_waiting_first_1 <= sums_turn_waiting_first_0;
        sums_turn_waiting_first_2 <= sums_turn_waiting_first_1;
        sums_turn_waiting_first_3 <= sums_turn_waiting_first_2;
        sums_cost_0_0 <= sums_turn_ready_costs_0 mod 64;
        sums_cost_0_1 <= (sums_turn_ready_costs_0 / 64) mod 64;
        sums_cost_0_2 <= (sums_turn_ready_costs_0 / 4096) mod 64;
        sums_cost_0_3 <= (sums_turn_ready_costs_0 / 262144) mod 64;
        sums_cost_0_4 <= sums_turn_ready_costs_0 / 16777216;
        sums_cost_0_5 <= sums_turn_ready_costs_1 mod 64;
        sums_cost_0_6 <= (sums_turn_ready_costs_1 / 64) mod 64;
        sums_cost_0_7 <= (sums_turn_ready_costs_1 / 4096) mod 64;
        sums_cost_0_8 <= (sums_turn_ready_costs_1 / 262144) mod 64;
        sums_cost_0_9 <= sums_turn_ready_costs_1 / 16777216;
        sums_cost_0_10 <= sums_turn_ready_costs_2 mod 64;
        sums_cost_0_11 <= sums_turn_ready_costs_2 / 64;
        sums_cost_1_0 <= sums_cost_0_0;
        sums_cost_1_1 <= sums_cost_0_1;
        sums_cost_1_2 <= sums_cost_0_2;
        sums_cost_1_3 <= sums_cost_0_3;
        sums_cost_1_4 <= sums_cost_0_4;
        sums_cost_1_5 <= sums_cost_0_5;
        sums_cost_1_6 <= sums_cost_0_6;
        sums_cost_1_7 <= sums_cost_0_7;
        sums_cost_1_8 <= sums_cost_0_8;
        sums_cost_1_9 <= sums_cost_0_9;
        sums_cost_1_10 <= sums_cost_0_10;
        sums_cost_1_11 <= sums_cost_0_11;
        sums_right_pair_0 <= sums_right_pair_0_choice;
        sums_right_pair_1 <= sums_right_pair_1_choice;
        sums_right_pair_2 <= sums_right_pair_2_choice;
        sums_right_pair_3 <= sums_right_pair_3_choice;
        sums_right_pair_4 <= sums_right_pair_4_choice;
        sums_right_pair_5 <= sums_right_pair_5_choice;
        sums_right_tree_next_smallest_1 <= sums_right_tree_smallest_2;
        sums_right_smallest <= sums_turn_ready_smallest_0;
        sums_right_smallest_less <= (sums_turn_ready_smallest_0 + 507) mod 512;
        sums_right_first_0 <= sums_turn_ready_first;
        sums_right_first_1 <= sums_right_first_0;
        sums_right_first_2 <= sums_right_first_1;
        sums_right_g_copy_0 <= sums_right_start_cost_0 + sums_right_smallest;
        sums_right_g_less_copy_0 <= (sums_right_smallest_less + sums_right_start_cost_0) mod 512;
        sums_right_stay_change_0 <= (sums_cost_1_0 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_1 <= (sums_cost_1_1 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_2 <= (sums_cost_1_2 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_3 <= (sums_cost_1_3 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_4 <= (sums_cost_1_4 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_5 <= (sums_cost_1_5 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_6 <= (sums_cost_1_6 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_7 <= (sums_cost_1_7 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_8 <= (sums_cost_1_8 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_9 <= (sums_cost_1_9 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_10 <= (sums_cost_1_10 - sums_right_g_copy_0) mod 512;
        sums_right_stay_change_11 <= (sums_cost_1_11 - sums_right_g_copy_0) mod 512;
        sums_right_step_change_0 <= (sums_cost_1_0 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_1 <= (sums_cost_1_1 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_2 <= (sums_cost_1_2 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_3 <= (sums_cost_1_3 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_4 <= (sums_cost_1_4 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_5 <= (sums_cost_1_5 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_6 <= (sums_cost_1_6 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_7 <= (sums_cost_1_7 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_8 <= (sums_cost_1_8 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_9 <= (sums_cost_1_9 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_10 <= (sums_cost_1_10 - sums_right_g_less_copy_0) mod 512;
        sums_right_step_change_11 <= (sums_cost_1_11 - sums_right_g_less_copy_0) mod 512;
        sums_right_cost_0 <= (sums_right_cost_0_choice_2 + sums_right_stay_change_0) mod 512;
        sums_right_cost_1 <= (sums_right_cost_1_choice_2 + sums_right_stay_change_1) mod 512;
        sums_right_cost_2 <= (sums_right_cost_2_choice_2 + sums_right_stay_change_2) mod 512;
        sums_right_cost_3 <= (sums_right_cost_3_choice_2 + sums_right_stay_change_3) mod 512;
        sums_right_cost_4 <= (sums_right_cost_4_choice_2 + sums_right_stay_change_4) mod 512;
        sums_right_cost_5 <= (sums_right_cost_5_choice_2 + sums_right_stay_change_5) mod 512;
        sums_right_cost_6 <= (sums_right_cost_6_choice_2 + sums_right_stay_change_6) mod 512;
        sums_right_cost_7 <= (sums_right_cost_7_choice_2 + sums_right_stay_change_7) mod 512;
        sums_right_cost_8 <= (sums_right_cost_8_choice_2 + sums_right_stay_change_8) mod 512;
        sums_right_cost_9 <= (sums_right_cost_9_choice_2 + sums_right_stay_change_9) mod 512;
        sums_right_cost_10 <= (sums_right_cost_10_choice_2 + sums_right_stay_change_10) mod 512;
        sums_right_cost_11 <= (sums_right_cost_11_choice_2 + sums_right_stay_change_11) mod 512;
        sums_right_arrived_0 <= (sums_right_arrived_0_choice + sums_right_step_change_0) mod 512;
        sums_right_arrived_1 <= (sums_right_arrived_1_choice + sums_right_step_change_1) mod 512;
        sums_right_arrived_2 <= (sums_right_arrived_2_choice + sums_right_step_change_2) mod 512;
        sums_right_arrived_3 <= (sums_right_arrived_3_choice_2 + sums_right_step_change_3) mod 512;
        sums_right_arrived_4 <= (sums_right_arrived_4_choice_2 + sums_right_step_change_4) mod 512;
        sums_right_arrived_5 <= (sums_right_arrived_5_choice + sums_right_step_change_5) mod 512;
        sums_right_arrived_6 <= (sums_right_arrived_6_choice + sums_right_step_change_6) mod 512;
        sums_right_arrived_7 <= (sums_right_arrived_7_choice_2 + sums_right_step_change_7) mod 512;
        sums_right_arrived_8 <= (sums_right_arrived_8_choice_2 + sums_right_step_change_8) mod 512;
        sums_right_arrived_9 <= (sums_right_arrived_9_choice + sums_right_step_change_9) mod 512;
        sums_right_arrived_10 <= (sums_right_arrived_10_choice + sums_right_step_change_10) mod 512;
        sums_right_arrived_11 <= (sums_right_arrived_11_choice + sums_right_step_change_11) mod 512;
        sums_sum_delay_ring_write_address <= sums_sum_delay_ring_read_address;
        sums_tags_held_0_output_column <= entry_turned_output_column;
        sums_tags_held_0_start_of_frame <= entry_turned_start_of_frame;
        sums_tags_held_0_end_of_line <= entry_tag_end_of_line;
        sums_tags_held_1_output_column <= sums_tags_held_0_output_column;
        sums_tags_held_1_start_of_frame <= sums_tags_held_0_start_of_frame;
        sums_tags_held_1_end_of_line <= sums_tags_held_0_end_of_line;
        sums_tags_held_2_output_column <= sums_tags_held_1_output_column;
        sums_tags_held_2_start_of_frame <= sums_tags_held_1_start_of_frame;
        sums_tags_held_2_end_of_line <= sums_tags_held_1_end_of_line;
        sums_tags_held_3_output_column <= sums_tags_held_2_output_column;
        sums_tags_held_3_start_of_frame <= sums_tags_held_2_start_of_frame;
        sums_tags_held_3_end_of_line <= sums_tags_held_2_end_of_line;
        sums_tags_held_4_output_column <= sums_tags_held_3_output_column;
        sums_tags_held_4_start_of_frame <= sums_tags_held_3_start_of_frame;
        sums_tags_held_4_end_of_line <= sums_tags_held_3_end_of_line;
        sums_tags_held_5_output_column <= sums_tags_held_4_output_column;
        sums_tags_held_5_start_of_frame <= sums_tags_held_4_start_of_frame;
        sums_tags_held_5_end_of_line <= sums_tags_held_4_end_of_line;
        sums_tags_held_6_output_column <= sums_tags_held_5_output_column;
        sums_tags_held_6_start_of_frame <= sums_tags_held_5_start_of_frame;
        sums_tags_held_6_end_of_line <= sums_tags_held_5_end_of_line;
        sums_tags_held_7_output_column <= sums_tags_held_6_output_column;
        sums_tags_held_7_start_of_frame <= sums_tags_held_6_start_of_frame;
        sums_tags_held_7_end_of_line <= sums_tags_held_6_end_of_line;
        sums_tags_held_8_output_column <= sums_tags_held_7_output_column;
        sums_tags_held_8_start_of_frame <= sums_tags_held_7_start_of_frame;
        sums_tags_held_8_end_of_line <= sums_tags_held_7_end_of_line;
        sums_tags_held_9_output_column <= sums_tags_held_8_output_column;
        sums_tags_held_9_start_of_frame <= sums_tags_held_8_start_of_frame;
        sums_tags_held_9_end_of_line <= sums_tags_held_8_end_of_line;
        sums_tags_held_10_map_column <= forward_above_comes_9;
        sums_tags_held_10_output_column <= sums_tags_held_9_output_column;
        sums_tags_held_10_first_column <= sums_turn_ready_first;
        sums_tags_held_10_start_of_frame <= sums_tags_held_9_start_of_frame;
        sums_tags_held_10_end_of_line <= sums_tags_held_9_end_of_line;
        sums_tags_held_11_map_column <= sums_tags_held_10_map_column;
        sums_tags_held_11_output_column <= sums_tags_held_10_output_column;
        sums_tags_held_11_first_column <= sums_tags_held_10_first_column;
        sums_tags_held_11_start_of_frame <= sums_tags_held_10_start_of_frame;
        sums_tags_held_11_end_of_line <= sums_tags_held_10_end_of_line;
        sums_tags_held_12_map_column <= sums_tags_held_11_map_column;
        sums_tags_held_12_output_column <= sums_tags_held_11_output_column;
        sums_tags_held_12_first_column <= sums_tags_held_11_first_column;
        sums_tags_held_12_start_of_frame <= sums_tags_held_11_start_of_frame;
        sums_tags_held_12_end_of_line <= sums_tags_held_11_end_of_line;
        sums_tags_held_13_map_column <= sums_tags_held_12_map_column;
        sums_tags_held_13_output_column <= sums_tags_held_12_output_column;
        sums_tags_held_13_first_column <= sums_right_first_2;
        sums_tags_held_13_start_of_frame <= sums_tags_held_12_start_of_frame;
        sums_tags_held_13_end_of_line <= sums_tags_held_12_end_of_line;
        if (sums_right_pair_1 - sums_right_pair_0) < 0 then
          sums_right_tree_smallest_0 <= sums_right_pair_1;
        else
          sums_right_tree_smallest_0 <= sums_right_pair_0;
        end if;
        if (sums_right_pair_3 - sums_right_pair_2) < 0 then
          sums_right_tree_smallest_1 <= sums_right_pair_3;
        else
          sums_right_tree_smallest_1 <= sums_right_pair_2;
        end if;
        if (sums_right_pair_5 - sums_right_pair_4) < 0 then
          sums_right_tree_smallest_2 <= sums_right_pair_5;
        else
          sums_right_tree_smallest_2 <= sums_right_pair_4;
        end if;
        if (sums_right_tree_smallest_1 - sums_right_tree_smallest_0) < 0 then
          sums_right_tree_next_smallest_0 <= sums_right_tree_smallest_1;
        else
          sums_right_tree_next_smallest_0 <= sums_right_tree_smallest_0;
        end if;
        if (sums_right_tree_next_smallest_1 - sums_right_tree_next_smallest_0) < 0 then
          sums_right_tree_next_next_smallest_0 <= sums_right_tree_next_smallest_1;
        else
          sums_right_tree_next_next_smallest_0 <= sums_right_tree_next_smallest_0;
        end if;
        if sums_turn_ready_first then
          sums_right_start_cost_0 <= 22;
          sums_right_start_cost_1 <= 0;
          sums_right_start_cost_2 <= 0;
          sums_right_start_cost_3 <= 0;
          sums_right_start_cost_4 <= 0;
          sums_right_start_cost_5 <= 0;
          sums_right_start_cost_6 <= 0;
          sums_right_room <= 0;
        else
          sums_right_start_cost_0 <= sums_right_start_cost_0_choice_2;
          sums_right_start_cost_1 <= sums_right_start_cost_0;
          sums_right_start_cost_2 <= sums_right_start_cost_1;
          sums_right_start_cost_3 <= sums_right_start_cost_2;
          sums_right_start_cost_4 <= sums_right_start_cost_3;
          sums_right_start_cost_5 <= sums_right_start_cost_4;
          sums_right_start_cost_6 <= sums_right_start_cost_5;
          sums_right_room <= (sums_right_room_choice_2 + sums_right_start_cost_6) mod 32;
        end if;
        if sums_sum_delay_ring_read_address = 3 then
          sums_sum_delay_ring_read_address <= 0;
        else
          sums_sum_delay_ring_read_address <= (sums_sum_delay_ring_read_address + 1) mod 4;
        end if;
      end if;
      if entry_tag_valid then
        sums_turn_writes_copy_0_choice := forward_above_comes_7;
      else
        sums_turn_writes_copy_0_choice := forward_above_comes_8;
      end if;
      if entry_tag_valid then
        sums_turn_waiting_read_place_choice := sums_turn_place_6;
      else
        sums_turn_waiting_read_place_choice := sums_turn_place_7;
      end if;
      if entry_tag_valid then
        sums_turn_waiting_read_place_choice_2 := sums_turn_place_7;
      else
        sums_turn_waiting_read_place_choice_2 := sums_turn_place_8;
      end if;
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      sums_sum_0_0 <= sums_right_cost_0 + to_integer(sums_sum_delay_held_0(8 downto 0));
      sums_sum_0_1 <= sums_right_cost_1 + to_integer(sums_sum_delay_held_0(17 downto 9));
      sums_sum_0_2 <= sums_right_cost_2 + to_integer(sums_sum_delay_held_0(26 downto 18));
      sums_sum_0_3 <= sums_right_cost_3 + to_integer(sums_sum_delay_held_1(8 downto 0));
      sums_sum_0_4 <= sums_right_cost_4 + to_integer(sums_sum_delay_held_1(17 downto 9));
      sums_sum_0_5 <= sums_right_cost_5 + to_integer(sums_sum_delay_held_1(26 downto 18));
      sums_sum_0_6 <= sums_right_cost_6 + to_integer(sums_sum_delay_held_2(8 downto 0));
      sums_sum_0_7 <= sums_right_cost_7 + to_integer(sums_sum_delay_held_2(17 downto 9));
      sums_sum_0_8 <= sums_right_cost_8 + to_integer(sums_sum_delay_held_2(26 downto 18));
      sums_sum_0_9 <= sums_right_cost_9 + to_integer(sums_sum_delay_held_3(8 downto 0));
      sums_sum_0_10 <= sums_right_cost_10 + to_integer(sums_sum_delay_held_3(17 downto 9));
      sums_sum_0_11 <= sums_right_cost_11 + to_integer(sums_sum_delay_held_3(26 downto 18));
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= sums_tags_held_13_map_column;
      sums_tag_output_column <= sums_tags_held_13_output_column;
      sums_tag_first_column <= sums_tags_held_13_first_column;
      sums_tag_start_of_frame <= sums_tags_held_13_start_of_frame;
      sums_tag_end_of_line <= sums_tags_held_13_end_of_line;
      sums_tags_moved <= entry_tag_valid;
      if entry_next_tag_valid then
        sums_turn_waiting_read_place <= sums_turn_waiting_read_place_choice;
      else
        sums_turn_waiting_read_place <= sums_turn_waiting_read_place_choice_2;
      end if;
      if sums_turn_writes_copy_0 then
        sums_turn_write_sums_0 <= (forward_sum_2 * 262144) + forward_sum_0 + (forward_sum_1 * 512);
        sums_turn_write_sums_1 <= (forward_sum_5 * 262144) + forward_sum_3 + (forward_sum_4 * 512);
        sums_turn_write_sums_2 <= (forward_sum_8 * 262144) + forward_sum_6 + (forward_sum_7 * 512);
        sums_turn_write_sums_3 <= (forward_sum_11 * 262144) + forward_sum_9 + (forward_sum_10 * 512);
        sums_turn_write_costs_0 <= (forward_cost_3_3 * 262144) + (forward_cost_3_4 * 16777216) + (forward_cost_3_2 *
          4096) + forward_cost_3_0 + (forward_cost_3_1 * 64);
        sums_turn_write_costs_1 <= (forward_cost_3_8 * 262144) + (forward_cost_3_9 * 16777216) + (forward_cost_3_7 *
          4096) + forward_cost_3_5 + (forward_cost_3_6 * 64);
        sums_turn_write_costs_2 <= (forward_cost_3_11 * 64) + forward_cost_3_10;
        sums_turn_write_smallest_0 <= forward_smallest_cost_4;
        sums_turn_write_place <= sums_turn_place_8;
      end if;
      -- winnersmask
      if sums_tags_moved then
        winnersmask_inside_0 <= sums_tags_held_13_first_column or winnersmask_inside_1;
        winnersmask_inside_1 <= sums_tags_held_13_first_column or winnersmask_inside_2;
        winnersmask_inside_2 <= sums_tags_held_13_first_column or winnersmask_inside_3;
        winnersmask_inside_3 <= sums_tags_held_13_first_column or winnersmask_inside_4;
        winnersmask_inside_4 <= sums_tags_held_13_first_column or winnersmask_inside_5;
        winnersmask_inside_5 <= sums_tags_held_13_first_column or winnersmask_inside_6;
        winnersmask_inside_6 <= sums_tags_held_13_first_column or winnersmask_inside_7;
        winnersmask_inside_7 <= sums_tags_held_13_first_column or winnersmask_inside_8;
        winnersmask_inside_8 <= sums_tags_held_13_first_column or winnersmask_inside_9;
        winnersmask_inside_9 <= sums_tags_held_13_first_column or winnersmask_inside_10;
        winnersmask_inside_10 <= sums_tags_held_13_first_column or winnersmask_inside_11;
        if sums_tags_held_13_first_column then
          winnersmask_column <= 0;
        else
          winnersmask_column <= (winnersmask_column + 1) mod 64;
        end if;
      end if;
      if ((((winnersmask_column / 4) mod 2) = 1) or (((winnersmask_column / 2) mod 2) = 1)) and (((winnersmask_column /
        8) mod 4) = 3) then
        winnersmask_inside_11_choice := sums_tags_moved and (not sums_tags_held_13_first_column);
      else
        winnersmask_inside_11_choice := ((winnersmask_column / 32) = 1) and sums_tags_moved and (not
          sums_tags_held_13_first_column);
      end if;
      winnersmask_inside_11 <= (not winnersmask_inside_11_choice) and (sums_tags_moved or winnersmask_inside_11);
      -- winnersother
      if (winnersother_cost_0_2 - sums_sum_0_1) >= 0 then
        winnersother_cost_0_1_choice := sums_tag_output_column and winnersmask_inside_1;
      else
        winnersother_cost_0_1_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_1;
      end if;
      if (winnersother_cost_0_3 - sums_sum_0_2) >= 0 then
        winnersother_cost_0_2_choice := sums_tag_output_column and winnersmask_inside_2;
      else
        winnersother_cost_0_2_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_2;
      end if;
      if (winnersother_cost_0_4 - sums_sum_0_3) >= 0 then
        winnersother_cost_0_3_choice := sums_tag_output_column and winnersmask_inside_3;
      else
        winnersother_cost_0_3_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_3;
      end if;
      if (winnersother_cost_0_5 - sums_sum_0_4) >= 0 then
        winnersother_cost_0_4_choice := sums_tag_output_column and winnersmask_inside_4;
      else
        winnersother_cost_0_4_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_4;
      end if;
      if (winnersother_cost_0_6 - sums_sum_0_5) >= 0 then
        winnersother_cost_0_5_choice := sums_tag_output_column and winnersmask_inside_5;
      else
        winnersother_cost_0_5_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_5;
      end if;
      if (winnersother_cost_0_7 - sums_sum_0_6) >= 0 then
        winnersother_cost_0_6_choice := sums_tag_output_column and winnersmask_inside_6;
      else
        winnersother_cost_0_6_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_6;
      end if;
      if (winnersother_cost_0_8 - sums_sum_0_7) >= 0 then
        winnersother_cost_0_7_choice := sums_tag_output_column and winnersmask_inside_7;
      else
        winnersother_cost_0_7_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_7;
      end if;
      if (winnersother_cost_0_9 - sums_sum_0_8) >= 0 then
        winnersother_cost_0_8_choice := sums_tag_output_column and winnersmask_inside_8;
      else
        winnersother_cost_0_8_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_8;
      end if;
      if (winnersother_cost_0_10 - sums_sum_0_9) >= 0 then
        winnersother_cost_0_9_choice := sums_tag_output_column and winnersmask_inside_9;
      else
        winnersother_cost_0_9_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_9;
      end if;
      if (winnersother_cost_0_11 - sums_sum_0_10) >= 0 then
        winnersother_cost_0_10_choice := sums_tag_output_column and winnersmask_inside_10;
      else
        winnersother_cost_0_10_choice := sums_tag_first_column and sums_tag_output_column and winnersmask_inside_10;
      end if;
      winnersother_cost_0_11_all := sums_tag_output_column and winnersmask_inside_11;
      if sums_tag_first_column then
        winnersother_winner_0_0_choice := sums_tag_output_column and winnersmask_inside_0;
      else
        winnersother_winner_0_0_choice := sums_tag_output_column and ((winnersother_cost_0_1 - sums_sum_0_0) >= 0) and
          winnersmask_inside_0;
      end if;
      if sums_tag_valid then
        if winnersother_cost_0_1_choice then
          winnersother_cost_0_1 <= sums_sum_0_1;
          winnersother_winner_0_1 <= 1;
        else
          winnersother_cost_0_1 <= winnersother_cost_0_2;
          winnersother_winner_0_1 <= winnersother_winner_0_2;
        end if;
        if winnersother_cost_0_2_choice then
          winnersother_cost_0_2 <= sums_sum_0_2;
          winnersother_winner_0_2 <= 2;
        else
          winnersother_cost_0_2 <= winnersother_cost_0_3;
          winnersother_winner_0_2 <= winnersother_winner_0_3;
        end if;
        if winnersother_cost_0_3_choice then
          winnersother_cost_0_3 <= sums_sum_0_3;
          winnersother_winner_0_3 <= 3;
        else
          winnersother_cost_0_3 <= winnersother_cost_0_4;
          winnersother_winner_0_3 <= winnersother_winner_0_4;
        end if;
        if winnersother_cost_0_4_choice then
          winnersother_cost_0_4 <= sums_sum_0_4;
          winnersother_winner_0_4 <= 4;
        else
          winnersother_cost_0_4 <= winnersother_cost_0_5;
          winnersother_winner_0_4 <= winnersother_winner_0_5;
        end if;
        if winnersother_cost_0_5_choice then
          winnersother_cost_0_5 <= sums_sum_0_5;
          winnersother_winner_0_5 <= 5;
        else
          winnersother_cost_0_5 <= winnersother_cost_0_6;
          winnersother_winner_0_5 <= winnersother_winner_0_6;
        end if;
        if winnersother_cost_0_6_choice then
          winnersother_cost_0_6 <= sums_sum_0_6;
          winnersother_winner_0_6 <= 6;
        else
          winnersother_cost_0_6 <= winnersother_cost_0_7;
          winnersother_winner_0_6 <= winnersother_winner_0_7;
        end if;
        if winnersother_cost_0_7_choice then
          winnersother_cost_0_7 <= sums_sum_0_7;
          winnersother_winner_0_7 <= 7;
        else
          winnersother_cost_0_7 <= winnersother_cost_0_8;
          winnersother_winner_0_7 <= winnersother_winner_0_8;
        end if;
        if winnersother_cost_0_8_choice then
          winnersother_cost_0_8 <= sums_sum_0_8;
          winnersother_winner_0_8 <= 8;
        else
          winnersother_cost_0_8 <= winnersother_cost_0_9;
          winnersother_winner_0_8 <= winnersother_winner_0_9;
        end if;
        if winnersother_cost_0_9_choice then
          winnersother_cost_0_9 <= sums_sum_0_9;
          winnersother_winner_0_9 <= 9;
        else
          winnersother_cost_0_9 <= winnersother_cost_0_10;
          winnersother_winner_0_9 <= winnersother_winner_0_10;
        end if;
        if winnersother_cost_0_10_choice then
          winnersother_cost_0_10 <= sums_sum_0_10;
          winnersother_winner_0_10 <= 10;
        else
          winnersother_cost_0_10 <= winnersother_cost_0_11;
          winnersother_winner_0_10 <= winnersother_winner_0_11;
        end if;
        if winnersother_cost_0_11_all then
          winnersother_cost_0_11 <= sums_sum_0_11;
          winnersother_winner_0_11 <= 11;
        else
          winnersother_cost_0_11 <= 0;
          winnersother_winner_0_11 <= 0;
        end if;
        if winnersother_winner_0_0_choice then
          winnersother_winner_0_0 <= 0;
        else
          winnersother_winner_0_0 <= winnersother_winner_0_1;
        end if;
      end if;
      winnersother_winner_out_0 <= winnersother_winner_0_0;
      -- winnerswinner1
      if winnersmask_inside_0 then
        winnerswinner1_held_0_0_choice := sums_sum_0_0;
      else
        winnerswinner1_held_0_0_choice := 1023;
      end if;
      if winnersmask_inside_1 then
        winnerswinner1_held_0_1_choice := sums_sum_0_1;
      else
        winnerswinner1_held_0_1_choice := 1023;
      end if;
      if winnersmask_inside_2 then
        winnerswinner1_held_0_2_choice := sums_sum_0_2;
      else
        winnerswinner1_held_0_2_choice := 1023;
      end if;
      if winnersmask_inside_3 then
        winnerswinner1_held_0_3_choice := sums_sum_0_3;
      else
        winnerswinner1_held_0_3_choice := 1023;
      end if;
      if winnersmask_inside_4 then
        winnerswinner1_held_0_4_choice := sums_sum_0_4;
      else
        winnerswinner1_held_0_4_choice := 1023;
      end if;
      if winnersmask_inside_5 then
        winnerswinner1_held_0_5_choice := sums_sum_0_5;
      else
        winnerswinner1_held_0_5_choice := 1023;
      end if;
      if winnersmask_inside_6 then
        winnerswinner1_held_0_6_choice := sums_sum_0_6;
      else
        winnerswinner1_held_0_6_choice := 1023;
      end if;
      if winnersmask_inside_7 then
        winnerswinner1_held_0_7_choice := sums_sum_0_7;
      else
        winnerswinner1_held_0_7_choice := 1023;
      end if;
      if winnersmask_inside_8 then
        winnerswinner1_held_0_8_choice := sums_sum_0_8;
      else
        winnerswinner1_held_0_8_choice := 1023;
      end if;
      if winnersmask_inside_9 then
        winnerswinner1_held_0_9_choice := sums_sum_0_9;
      else
        winnerswinner1_held_0_9_choice := 1023;
      end if;
      if winnersmask_inside_10 then
        winnerswinner1_held_0_10_choice := sums_sum_0_10;
      else
        winnerswinner1_held_0_10_choice := 1023;
      end if;
      if winnersmask_inside_11 then
        winnerswinner1_held_0_11_choice := sums_sum_0_11;
      else
        winnerswinner1_held_0_11_choice := 1023;
      end if;
      winnerswinner1_best_cost_0_0_is_less := (winnerswinner1_held_0_1_choice - winnerswinner1_held_0_0_choice) < 0;
      winnerswinner1_best_cost_0_1_is_less := (winnerswinner1_held_0_3_choice - winnerswinner1_held_0_2_choice) < 0;
      winnerswinner1_best_cost_0_2_is_less := (winnerswinner1_held_0_5_choice - winnerswinner1_held_0_4_choice) < 0;
      winnerswinner1_best_cost_0_3_is_less := (winnerswinner1_held_0_7_choice - winnerswinner1_held_0_6_choice) < 0;
      winnerswinner1_best_cost_0_4_is_less := (winnerswinner1_held_0_9_choice - winnerswinner1_held_0_8_choice) < 0;
      winnerswinner1_best_cost_0_5_is_less := (winnerswinner1_held_0_11_choice - winnerswinner1_held_0_10_choice) < 0;
      winnerswinner1_held_0_0 <= winnerswinner1_held_0_0_choice;
      winnerswinner1_held_0_1 <= winnerswinner1_held_0_1_choice;
      winnerswinner1_held_0_2 <= winnerswinner1_held_0_2_choice;
      winnerswinner1_held_0_3 <= winnerswinner1_held_0_3_choice;
      winnerswinner1_held_0_4 <= winnerswinner1_held_0_4_choice;
      winnerswinner1_held_0_5 <= winnerswinner1_held_0_5_choice;
      winnerswinner1_held_0_6 <= winnerswinner1_held_0_6_choice;
      winnerswinner1_held_0_7 <= winnerswinner1_held_0_7_choice;
      winnerswinner1_held_0_8 <= winnerswinner1_held_0_8_choice;
      winnerswinner1_held_0_9 <= winnerswinner1_held_0_9_choice;
      winnerswinner1_held_0_10 <= winnerswinner1_held_0_10_choice;
      winnerswinner1_held_0_11 <= winnerswinner1_held_0_11_choice;
      winnerswinner1_best_index_0_0 <= winnerswinner1_best_cost_0_0_is_less;
      winnerswinner1_best_place_0_2 <= winnerswinner1_best_cost_0_2_is_less;
      winnerswinner1_best_place_0_4 <= winnerswinner1_best_cost_0_4_is_less;
      winnerswinner1_best_late_cost_0_0 <= winnerswinner1_best_cost_0_0;
      winnerswinner1_best_late_cost_0_1 <= winnerswinner1_best_cost_0_1;
      winnerswinner1_best_late_cost_0_2 <= winnerswinner1_best_cost_0_2;
      winnerswinner1_best_late_cost_0_3 <= winnerswinner1_best_cost_0_3;
      winnerswinner1_best_late_cost_0_4 <= winnerswinner1_best_cost_0_4;
      winnerswinner1_best_late_cost_0_5 <= winnerswinner1_best_cost_0_5;
      winnerswinner1_best_but_first_0_1 <= winnerswinner1_held_0_3;
      winnerswinner1_best_but_first_0_2 <= winnerswinner1_held_0_5;
      winnerswinner1_best_but_first_0_3 <= winnerswinner1_held_0_7;
      winnerswinner1_best_but_first_0_4 <= winnerswinner1_held_0_9;
      winnerswinner1_best_but_first_0_5 <= winnerswinner1_held_0_11;
      winnerswinner1_best_but_last_0_0 <= winnerswinner1_held_0_0;
      winnerswinner1_best_but_last_0_1 <= winnerswinner1_held_0_2;
      winnerswinner1_best_but_last_0_2 <= winnerswinner1_held_0_4;
      winnerswinner1_best_but_last_0_3 <= winnerswinner1_held_0_6;
      winnerswinner1_best_but_last_0_4 <= winnerswinner1_held_0_8;
      winnerswinner1_tag_valid <= sums_tag_valid;
      winnerswinner1_tag_map_column <= sums_tag_map_column;
      winnerswinner1_tag_output_column <= sums_tag_output_column;
      winnerswinner1_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= sums_tag_end_of_line;
      if winnerswinner1_best_cost_0_0_is_less then
        winnerswinner1_best_cost_0_0 <= winnerswinner1_held_0_1_choice;
        winnerswinner1_best_below_0_0 <= winnerswinner1_held_0_0_choice;
        winnerswinner1_best_above_0_0 <= 0;
      else
        winnerswinner1_best_cost_0_0 <= winnerswinner1_held_0_0_choice;
        winnerswinner1_best_below_0_0 <= 0;
        winnerswinner1_best_above_0_0 <= winnerswinner1_held_0_1_choice;
      end if;
      if winnerswinner1_best_cost_0_1_is_less then
        winnerswinner1_best_cost_0_1 <= winnerswinner1_held_0_3_choice;
        winnerswinner1_best_index_0_1 <= 3;
        winnerswinner1_best_below_0_1 <= winnerswinner1_held_0_2_choice;
        winnerswinner1_best_above_0_1 <= 0;
      else
        winnerswinner1_best_cost_0_1 <= winnerswinner1_held_0_2_choice;
        winnerswinner1_best_index_0_1 <= 2;
        winnerswinner1_best_below_0_1 <= 0;
        winnerswinner1_best_above_0_1 <= winnerswinner1_held_0_3_choice;
      end if;
      if winnerswinner1_best_cost_0_2_is_less then
        winnerswinner1_best_cost_0_2 <= winnerswinner1_held_0_5_choice;
        winnerswinner1_best_index_0_2 <= 5;
        winnerswinner1_best_below_0_2 <= winnerswinner1_held_0_4_choice;
        winnerswinner1_best_above_0_2 <= 0;
      else
        winnerswinner1_best_cost_0_2 <= winnerswinner1_held_0_4_choice;
        winnerswinner1_best_index_0_2 <= 4;
        winnerswinner1_best_below_0_2 <= 0;
        winnerswinner1_best_above_0_2 <= winnerswinner1_held_0_5_choice;
      end if;
      if winnerswinner1_best_cost_0_3_is_less then
        winnerswinner1_best_cost_0_3 <= winnerswinner1_held_0_7_choice;
        winnerswinner1_best_index_0_3 <= 7;
        winnerswinner1_best_below_0_3 <= winnerswinner1_held_0_6_choice;
        winnerswinner1_best_above_0_3 <= 0;
      else
        winnerswinner1_best_cost_0_3 <= winnerswinner1_held_0_6_choice;
        winnerswinner1_best_index_0_3 <= 6;
        winnerswinner1_best_below_0_3 <= 0;
        winnerswinner1_best_above_0_3 <= winnerswinner1_held_0_7_choice;
      end if;
      if winnerswinner1_best_cost_0_4_is_less then
        winnerswinner1_best_cost_0_4 <= winnerswinner1_held_0_9_choice;
        winnerswinner1_best_index_0_4 <= 9;
        winnerswinner1_best_below_0_4 <= winnerswinner1_held_0_8_choice;
        winnerswinner1_best_above_0_4 <= 0;
      else
        winnerswinner1_best_cost_0_4 <= winnerswinner1_held_0_8_choice;
        winnerswinner1_best_index_0_4 <= 8;
        winnerswinner1_best_below_0_4 <= 0;
        winnerswinner1_best_above_0_4 <= winnerswinner1_held_0_9_choice;
      end if;
      if winnerswinner1_best_cost_0_5_is_less then
        winnerswinner1_best_cost_0_5 <= winnerswinner1_held_0_11_choice;
        winnerswinner1_best_index_0_5 <= 11;
        winnerswinner1_best_below_0_5 <= winnerswinner1_held_0_10_choice;
        winnerswinner1_best_above_0_5 <= 0;
      else
        winnerswinner1_best_cost_0_5 <= winnerswinner1_held_0_10_choice;
        winnerswinner1_best_index_0_5 <= 10;
        winnerswinner1_best_below_0_5 <= 0;
        winnerswinner1_best_above_0_5 <= winnerswinner1_held_0_11_choice;
      end if;
      -- winnerswinner2
      winnerswinner2_best_cost_0_0_is_less := (winnerswinner1_best_cost_0_1 - winnerswinner1_best_cost_0_0) < 0;
      winnerswinner2_best_cost_0_1_is_less := (winnerswinner1_best_cost_0_3 - winnerswinner1_best_cost_0_2) < 0;
      winnerswinner2_best_cost_0_2_is_less := (winnerswinner1_best_cost_0_5 - winnerswinner1_best_cost_0_4) < 0;
      winnerswinner2_best_below_0_0_is_equal := winnerswinner1_best_index_0_1 = 2;
      if winnerswinner2_best_below_0_0_is_equal then
        winnerswinner2_best_below_0_0_choice := winnerswinner1_held_0_1;
      else
        winnerswinner2_best_below_0_0_choice := winnerswinner1_best_below_0_1;
      end if;
      winnerswinner2_best_below_0_1_is_equal := winnerswinner1_best_index_0_3 = 6;
      if winnerswinner2_best_below_0_1_is_equal then
        winnerswinner2_best_below_0_1_choice := winnerswinner1_held_0_5;
      else
        winnerswinner2_best_below_0_1_choice := winnerswinner1_best_below_0_3;
      end if;
      winnerswinner2_best_below_0_2_is_equal := (winnerswinner1_best_index_0_5 mod 4) = 2;
      if ((winnerswinner1_best_index_0_5 / 8) = 1) and winnerswinner2_best_below_0_2_is_equal then
        winnerswinner2_best_below_0_2_choice := winnerswinner1_held_0_9;
      else
        winnerswinner2_best_below_0_2_choice := winnerswinner1_best_below_0_5;
      end if;
      if winnerswinner1_best_index_0_0 then
        winnerswinner2_best_above_0_0_choice := winnerswinner1_held_0_2;
      else
        winnerswinner2_best_above_0_0_choice := winnerswinner1_best_above_0_0;
      end if;
      if winnerswinner1_best_place_0_2 then
        winnerswinner2_best_above_0_1_choice := winnerswinner1_held_0_6;
      else
        winnerswinner2_best_above_0_1_choice := winnerswinner1_best_above_0_2;
      end if;
      if winnerswinner1_best_place_0_4 then
        winnerswinner2_best_above_0_2_choice := winnerswinner1_held_0_10;
      else
        winnerswinner2_best_above_0_2_choice := winnerswinner1_best_above_0_4;
      end if;
      if winnerswinner2_best_place_0_0 then
        winnerswinner2_best_second_0_0_choice := 1023;
      else
        winnerswinner2_best_second_0_0_choice := winnerswinner1_best_late_cost_0_1;
      end if;
      if winnerswinner2_best_at_end_0_0 then
        winnerswinner2_best_second_0_0_choice_2 := winnerswinner1_best_but_first_0_1;
      else
        winnerswinner2_best_second_0_0_choice_2 := winnerswinner2_best_second_0_0_choice;
      end if;
      if winnerswinner2_best_place_0_0 then
        winnerswinner2_best_second_0_0_choice_3 := winnerswinner1_best_late_cost_0_0;
      else
        winnerswinner2_best_second_0_0_choice_3 := 1023;
      end if;
      if winnerswinner2_best_at_start_0_0 then
        winnerswinner2_best_second_0_0_choice_4 := winnerswinner1_best_but_last_0_0;
      else
        winnerswinner2_best_second_0_0_choice_4 := winnerswinner2_best_second_0_0_choice_3;
      end if;
      if winnerswinner2_best_place_0_1 then
        winnerswinner2_best_second_0_1_choice := 1023;
      else
        winnerswinner2_best_second_0_1_choice := winnerswinner1_best_late_cost_0_3;
      end if;
      if winnerswinner2_best_at_end_0_1 then
        winnerswinner2_best_second_0_1_choice_2 := winnerswinner1_best_but_first_0_3;
      else
        winnerswinner2_best_second_0_1_choice_2 := winnerswinner2_best_second_0_1_choice;
      end if;
      if winnerswinner2_best_place_0_1 then
        winnerswinner2_best_second_0_1_choice_3 := winnerswinner1_best_late_cost_0_2;
      else
        winnerswinner2_best_second_0_1_choice_3 := 1023;
      end if;
      if winnerswinner2_best_at_start_0_1 then
        winnerswinner2_best_second_0_1_choice_4 := winnerswinner1_best_but_last_0_2;
      else
        winnerswinner2_best_second_0_1_choice_4 := winnerswinner2_best_second_0_1_choice_3;
      end if;
      if winnerswinner2_best_place_0_2 then
        winnerswinner2_best_second_0_2_choice := 1023;
      else
        winnerswinner2_best_second_0_2_choice := winnerswinner1_best_late_cost_0_5;
      end if;
      if winnerswinner2_best_at_end_0_2 then
        winnerswinner2_best_second_0_2_choice_2 := winnerswinner1_best_but_first_0_5;
      else
        winnerswinner2_best_second_0_2_choice_2 := winnerswinner2_best_second_0_2_choice;
      end if;
      if winnerswinner2_best_place_0_2 then
        winnerswinner2_best_second_0_2_choice_3 := winnerswinner1_best_late_cost_0_4;
      else
        winnerswinner2_best_second_0_2_choice_3 := 1023;
      end if;
      if winnerswinner2_best_at_start_0_2 then
        winnerswinner2_best_second_0_2_choice_4 := winnerswinner1_best_but_last_0_4;
      else
        winnerswinner2_best_second_0_2_choice_4 := winnerswinner2_best_second_0_2_choice_3;
      end if;
      winnerswinner2_best_first_0_1 <= winnerswinner1_held_0_4;
      winnerswinner2_best_first_0_2 <= winnerswinner1_held_0_8;
      winnerswinner2_best_last_0_0 <= winnerswinner1_held_0_3;
      winnerswinner2_best_last_0_1 <= winnerswinner1_held_0_7;
      winnerswinner2_best_place_0_0 <= winnerswinner2_best_cost_0_0_is_less;
      winnerswinner2_best_place_0_1 <= winnerswinner2_best_cost_0_1_is_less;
      winnerswinner2_best_place_0_2 <= winnerswinner2_best_cost_0_2_is_less;
      winnerswinner2_best_at_start_0_0 <= winnerswinner2_best_cost_0_0_is_less and
        winnerswinner2_best_below_0_0_is_equal;
      winnerswinner2_best_at_start_0_1 <= winnerswinner2_best_cost_0_1_is_less and
        winnerswinner2_best_below_0_1_is_equal;
      winnerswinner2_best_at_start_0_2 <= winnerswinner2_best_cost_0_2_is_less and ((winnerswinner1_best_index_0_5 / 8)
        = 1) and winnerswinner2_best_below_0_2_is_equal;
      winnerswinner2_best_at_end_0_0 <= winnerswinner1_best_index_0_0 and ((winnerswinner1_best_cost_0_1 -
        winnerswinner1_best_cost_0_0) >= 0);
      winnerswinner2_best_at_end_0_1 <= winnerswinner1_best_place_0_2 and ((winnerswinner1_best_cost_0_3 -
        winnerswinner1_best_cost_0_2) >= 0);
      winnerswinner2_best_at_end_0_2 <= winnerswinner1_best_place_0_4 and ((winnerswinner1_best_cost_0_5 -
        winnerswinner1_best_cost_0_4) >= 0);
      winnerswinner2_best_late_cost_0_0 <= winnerswinner2_best_cost_0_0;
      winnerswinner2_best_late_cost_0_1 <= winnerswinner2_best_cost_0_1;
      winnerswinner2_best_late_cost_0_2 <= winnerswinner2_best_cost_0_2;
      winnerswinner2_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner1_tag_end_of_line;
      if winnerswinner2_best_cost_0_0_is_less then
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0_1;
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
        winnerswinner2_best_below_0_0 <= winnerswinner2_best_below_0_0_choice;
        winnerswinner2_best_above_0_0 <= winnerswinner1_best_above_0_1;
      else
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0_0;
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
        winnerswinner2_best_below_0_0 <= winnerswinner1_best_below_0_0;
        winnerswinner2_best_above_0_0 <= winnerswinner2_best_above_0_0_choice;
      end if;
      if winnerswinner2_best_cost_0_1_is_less then
        winnerswinner2_best_cost_0_1 <= winnerswinner1_best_cost_0_3;
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
        winnerswinner2_best_below_0_1 <= winnerswinner2_best_below_0_1_choice;
        winnerswinner2_best_above_0_1 <= winnerswinner1_best_above_0_3;
      else
        winnerswinner2_best_cost_0_1 <= winnerswinner1_best_cost_0_2;
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
        winnerswinner2_best_below_0_1 <= winnerswinner1_best_below_0_2;
        winnerswinner2_best_above_0_1 <= winnerswinner2_best_above_0_1_choice;
      end if;
      if winnerswinner2_best_cost_0_2_is_less then
        winnerswinner2_best_cost_0_2 <= winnerswinner1_best_cost_0_5;
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_5;
        winnerswinner2_best_below_0_2 <= winnerswinner2_best_below_0_2_choice;
        winnerswinner2_best_above_0_2 <= winnerswinner1_best_above_0_5;
      else
        winnerswinner2_best_cost_0_2 <= winnerswinner1_best_cost_0_4;
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_4;
        winnerswinner2_best_below_0_2 <= winnerswinner1_best_below_0_4;
        winnerswinner2_best_above_0_2 <= winnerswinner2_best_above_0_2_choice;
      end if;
      if (winnerswinner2_best_second_0_0_choice_2 - winnerswinner2_best_second_0_0_choice_4) < 0 then
        winnerswinner2_best_second_0_0 <= winnerswinner2_best_second_0_0_choice_2;
      else
        winnerswinner2_best_second_0_0 <= winnerswinner2_best_second_0_0_choice_4;
      end if;
      if (winnerswinner2_best_second_0_1_choice_2 - winnerswinner2_best_second_0_1_choice_4) < 0 then
        winnerswinner2_best_second_0_1 <= winnerswinner2_best_second_0_1_choice_2;
      else
        winnerswinner2_best_second_0_1 <= winnerswinner2_best_second_0_1_choice_4;
      end if;
      if (winnerswinner2_best_second_0_2_choice_2 - winnerswinner2_best_second_0_2_choice_4) < 0 then
        winnerswinner2_best_second_0_2 <= winnerswinner2_best_second_0_2_choice_2;
      else
        winnerswinner2_best_second_0_2 <= winnerswinner2_best_second_0_2_choice_4;
      end if;
      if (winnerswinner1_best_late_cost_0_3 - winnerswinner1_best_but_first_0_2) < 0 then
        winnerswinner2_best_but_first_0_1 <= winnerswinner1_best_late_cost_0_3;
      else
        winnerswinner2_best_but_first_0_1 <= winnerswinner1_best_but_first_0_2;
      end if;
      if (winnerswinner1_best_late_cost_0_5 - winnerswinner1_best_but_first_0_4) < 0 then
        winnerswinner2_best_but_first_0_2 <= winnerswinner1_best_late_cost_0_5;
      else
        winnerswinner2_best_but_first_0_2 <= winnerswinner1_best_but_first_0_4;
      end if;
      if (winnerswinner1_best_but_last_0_1 - winnerswinner1_best_late_cost_0_0) < 0 then
        winnerswinner2_best_but_last_0_0 <= winnerswinner1_best_but_last_0_1;
      else
        winnerswinner2_best_but_last_0_0 <= winnerswinner1_best_late_cost_0_0;
      end if;
      if (winnerswinner1_best_but_last_0_3 - winnerswinner1_best_late_cost_0_2) < 0 then
        winnerswinner2_best_but_last_0_1 <= winnerswinner1_best_but_last_0_3;
      else
        winnerswinner2_best_but_last_0_1 <= winnerswinner1_best_late_cost_0_2;
      end if;
      -- winnerswinner3
      winnerswinner3_best_cost_0_0_is_less := (winnerswinner2_best_cost_0_1 - winnerswinner2_best_cost_0_0) < 0;
      winnerswinner3_best_below_0_0_is_equal := winnerswinner2_best_index_0_1 = 4;
      if winnerswinner3_best_below_0_0_is_equal then
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_last_0_0;
      else
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_below_0_1;
      end if;
      winnerswinner3_best_above_0_0_is_equal := winnerswinner2_best_index_0_0 = 3;
      if winnerswinner3_best_above_0_0_is_equal then
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_first_0_1;
      else
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_above_0_0;
      end if;
      if winnerswinner3_best_place_0_0 then
        winnerswinner3_best_second_0_0_choice := winnerswinner2_best_second_0_1;
      else
        winnerswinner3_best_second_0_0_choice := winnerswinner2_best_late_cost_0_1;
      end if;
      if winnerswinner3_best_at_end_0_0 then
        winnerswinner3_best_second_0_0_choice_2 := winnerswinner2_best_but_first_0_1;
      else
        winnerswinner3_best_second_0_0_choice_2 := winnerswinner3_best_second_0_0_choice;
      end if;
      if winnerswinner3_best_place_0_0 then
        winnerswinner3_best_second_0_0_choice_3 := winnerswinner2_best_late_cost_0_0;
      else
        winnerswinner3_best_second_0_0_choice_3 := winnerswinner2_best_second_0_0;
      end if;
      if winnerswinner3_best_at_start_0_0 then
        winnerswinner3_best_second_0_0_choice_4 := winnerswinner2_best_but_last_0_0;
      else
        winnerswinner3_best_second_0_0_choice_4 := winnerswinner3_best_second_0_0_choice_3;
      end if;
      winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_2;
      winnerswinner3_best_below_0_1 <= winnerswinner2_best_below_0_2;
      winnerswinner3_best_above_0_1 <= winnerswinner2_best_above_0_2;
      winnerswinner3_best_first_0_1 <= winnerswinner2_best_first_0_2;
      winnerswinner3_best_last_0_0 <= winnerswinner2_best_last_0_1;
      winnerswinner3_best_place_0_0 <= winnerswinner3_best_cost_0_0_is_less;
      winnerswinner3_best_at_start_0_0 <= winnerswinner3_best_cost_0_0_is_less and
        winnerswinner3_best_below_0_0_is_equal;
      winnerswinner3_best_at_end_0_0 <= ((winnerswinner2_best_cost_0_1 - winnerswinner2_best_cost_0_0) >= 0) and
        winnerswinner3_best_above_0_0_is_equal;
      winnerswinner3_best_late_cost_0_0 <= winnerswinner3_best_cost_0_0;
      winnerswinner3_best_late_cost_0_1 <= winnerswinner2_best_late_cost_0_2;
      winnerswinner3_best_second_0_1 <= winnerswinner2_best_second_0_2;
      winnerswinner3_best_but_first_0_1 <= winnerswinner2_best_but_first_0_2;
      winnerswinner3_tag_valid <= winnerswinner2_tag_valid;
      winnerswinner3_tag_map_column <= winnerswinner2_tag_map_column;
      winnerswinner3_tag_output_column <= winnerswinner2_tag_output_column;
      winnerswinner3_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winnerswinner3_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      if winnerswinner3_best_cost_0_0_is_less then
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_1;
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
        winnerswinner3_best_below_0_0 <= winnerswinner3_best_below_0_0_choice;
        winnerswinner3_best_above_0_0 <= winnerswinner2_best_above_0_1;
      else
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_0;
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
        winnerswinner3_best_below_0_0 <= winnerswinner2_best_below_0_0;
        winnerswinner3_best_above_0_0 <= winnerswinner3_best_above_0_0_choice;
      end if;
      if (winnerswinner3_best_second_0_0_choice_2 - winnerswinner3_best_second_0_0_choice_4) < 0 then
        winnerswinner3_best_second_0_0 <= winnerswinner3_best_second_0_0_choice_2;
      else
        winnerswinner3_best_second_0_0 <= winnerswinner3_best_second_0_0_choice_4;
      end if;
      if (winnerswinner2_best_but_last_0_1 - winnerswinner2_best_late_cost_0_0) < 0 then
        winnerswinner3_best_but_last_0_0 <= winnerswinner2_best_but_last_0_1;
      else
        winnerswinner3_best_but_last_0_0 <= winnerswinner2_best_late_cost_0_0;
      end if;
      -- winnerswinner4
      winnerswinner4_best_cost_0_0_is_less := (winnerswinner2_best_late_cost_0_2 - winnerswinner3_best_cost_0_0) < 0;
      winnerswinner4_best_below_0_0_is_equal := (winnerswinner3_best_index_0_1 mod 4) = 0;
      if ((winnerswinner3_best_index_0_1 / 8) = 1) and winnerswinner4_best_below_0_0_is_equal then
        winnerswinner4_best_below_0_0_choice := winnerswinner3_best_last_0_0;
      else
        winnerswinner4_best_below_0_0_choice := winnerswinner3_best_below_0_1;
      end if;
      winnerswinner4_best_above_0_0_is_equal := winnerswinner3_best_index_0_0 = 7;
      if winnerswinner4_best_above_0_0_is_equal then
        winnerswinner4_best_above_0_0_choice := winnerswinner3_best_first_0_1;
      else
        winnerswinner4_best_above_0_0_choice := winnerswinner3_best_above_0_0;
      end if;
      if winnerswinner4_best_place_0_0 then
        winnerswinner4_best_second_0_0_choice := winnerswinner3_best_second_0_1;
      else
        winnerswinner4_best_second_0_0_choice := winnerswinner3_best_late_cost_0_1;
      end if;
      if winnerswinner4_best_at_end_0_0 then
        winnerswinner4_best_second_0_0_choice_2 := winnerswinner3_best_but_first_0_1;
      else
        winnerswinner4_best_second_0_0_choice_2 := winnerswinner4_best_second_0_0_choice;
      end if;
      if winnerswinner4_best_place_0_0 then
        winnerswinner4_best_second_0_0_choice_3 := winnerswinner3_best_late_cost_0_0;
      else
        winnerswinner4_best_second_0_0_choice_3 := winnerswinner3_best_second_0_0;
      end if;
      if winnerswinner4_best_at_start_0_0 then
        winnerswinner4_best_second_0_0_choice_4 := winnerswinner3_best_but_last_0_0;
      else
        winnerswinner4_best_second_0_0_choice_4 := winnerswinner4_best_second_0_0_choice_3;
      end if;
      winnerswinner4_best_place_0_0 <= winnerswinner4_best_cost_0_0_is_less;
      winnerswinner4_best_at_start_0_0 <= winnerswinner4_best_cost_0_0_is_less and ((winnerswinner3_best_index_0_1 / 8)
        = 1) and winnerswinner4_best_below_0_0_is_equal;
      winnerswinner4_best_at_end_0_0 <= ((winnerswinner2_best_late_cost_0_2 - winnerswinner3_best_cost_0_0) >= 0) and
        winnerswinner4_best_above_0_0_is_equal;
      winnerswinner4_best_late_cost_0_0 <= winnerswinner4_best_cost_0_0;
      winnerswinner4_tag_valid <= winnerswinner3_tag_valid;
      winnerswinner4_tag_map_column <= winnerswinner3_tag_map_column;
      winnerswinner4_tag_output_column <= winnerswinner3_tag_output_column;
      winnerswinner4_tag_start_of_frame <= winnerswinner3_tag_start_of_frame;
      winnerswinner4_tag_end_of_line <= winnerswinner3_tag_end_of_line;
      if winnerswinner4_best_cost_0_0_is_less then
        winnerswinner4_best_cost_0_0 <= winnerswinner2_best_late_cost_0_2;
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_1;
        winnerswinner4_best_below_0_0 <= winnerswinner4_best_below_0_0_choice;
        winnerswinner4_best_above_0_0 <= winnerswinner3_best_above_0_1;
      else
        winnerswinner4_best_cost_0_0 <= winnerswinner3_best_cost_0_0;
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_0;
        winnerswinner4_best_below_0_0 <= winnerswinner3_best_below_0_0;
        winnerswinner4_best_above_0_0 <= winnerswinner4_best_above_0_0_choice;
      end if;
      if (winnerswinner4_best_second_0_0_choice_2 - winnerswinner4_best_second_0_0_choice_4) < 0 then
        winnerswinner4_best_second_0_0 <= winnerswinner4_best_second_0_0_choice_2;
      else
        winnerswinner4_best_second_0_0 <= winnerswinner4_best_second_0_0_choice_4;
      end if;
      -- winners
      winners_best_index_0_0 <= winnerswinner4_best_index_0_0;
      winners_best_below_0_0 <= winnerswinner4_best_below_0_0;
      winners_best_above_0_0 <= winnerswinner4_best_above_0_0;
      winners_best_late_cost_0_0 <= winnerswinner4_best_late_cost_0_0;
      winners_best_second_0_0 <= winnerswinner4_best_second_0_0;
      winners_best_tag_valid <= winnerswinner4_tag_valid;
      winners_best_tag_map_column <= winnerswinner4_tag_map_column;
      winners_best_tag_output_column <= winnerswinner4_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner4_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner4_tag_end_of_line;
      -- refinement
      refinement_below_0_differs := winners_best_index_0_0 /= 0;
      refinement_below_0_differs_2 := winners_best_below_0_0 /= 1023;
      refinement_below_0_all := refinement_below_0_differs and refinement_below_0_differs_2;
      if winners_best_index_0_0 = 11 then
        refinement_above_0_choice := refinement_below_0_all;
      else
        refinement_above_0_choice := refinement_below_0_differs and (winners_best_above_0_0 = 1023) and
          refinement_below_0_differs_2;
      end if;
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 2048) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 2048) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 2048) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 2048) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 2048) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 2048) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 2048) - refinement_divisor_6_0;
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
      refinement_disparity_0_0 <= winners_best_index_0_0;
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
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_tag_0_valid <= winners_best_tag_valid;
      refinement_tag_0_map_column <= winners_best_tag_map_column;
      refinement_tag_0_output_column <= winners_best_tag_output_column;
      refinement_tag_0_start_of_frame <= winners_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= winners_best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_map_column <= refinement_tag_0_map_column;
      refinement_tag_1_output_column <= refinement_tag_0_output_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_map_column <= refinement_tag_1_map_column;
      refinement_tag_2_output_column <= refinement_tag_1_output_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_map_column <= refinement_tag_2_map_column;
      refinement_tag_3_output_column <= refinement_tag_2_output_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_map_column <= refinement_tag_3_map_column;
      refinement_tag_4_output_column <= refinement_tag_3_output_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_map_column <= refinement_tag_4_map_column;
      refinement_tag_5_output_column <= refinement_tag_4_output_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_map_column <= refinement_tag_5_map_column;
      refinement_tag_6_output_column <= refinement_tag_5_output_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_map_column <= refinement_tag_6_map_column;
      refinement_tag_7_output_column <= refinement_tag_6_output_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_map_column <= refinement_tag_7_map_column;
      refinement_tag_8_output_column <= refinement_tag_7_output_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_map_column <= refinement_tag_8_map_column;
      refinement_tag_9_output_column <= refinement_tag_8_output_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_map_column <= refinement_tag_9_map_column;
      refinement_tag_10_output_column <= refinement_tag_9_output_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_map_column <= refinement_tag_10_map_column;
      refinement_tag_11_output_column <= refinement_tag_10_output_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_alone_0_0 <= winners_best_second_0_0 = 1023;
      refinement_alone_1_0 <= refinement_alone_0_0;
      refinement_gap_0 <= (winners_best_second_0_0 - winners_best_late_cost_0_0) mod 1024;
      refinement_scaled_gap_0 <= refinement_gap_0;
      refinement_scaled_cost_0 <= 2;
      refinement_u_0 <= (refinement_below_0 - winners_best_late_cost_0_0) mod 1024;
      refinement_v_0 <= (refinement_above_0 - winners_best_late_cost_0_0) mod 1024;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 10)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 10))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= (((((2048 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) * 2) / 2048) +
        ((other_5 / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
      if refinement_alone_1_0 then
        refinement_passed_3_0 <= transform_columns_column_inside_1;
      else
        refinement_passed_3_0 <= transform_columns_column_inside_1 and ((refinement_scaled_cost_0 -
          refinement_scaled_gap_0) < 0);
      end if;
      if refinement_below_0_all then
        refinement_below_0 <= winners_best_below_0_0;
      else
        refinement_below_0 <= winners_best_above_0_0;
      end if;
      if refinement_above_0_choice then
        refinement_above_0 <= winners_best_below_0_0;
      else
        refinement_above_0 <= winners_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 2048) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 1024;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 2048) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 1024;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 512) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 2048) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 1024;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 512) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 2048) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 1024;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 512) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 2048) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 1024;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 512) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 2048) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 1024;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 512) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 2048) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 1024;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 512) * 2;
      end if;
      -- leftright
      leftright_holds_winners_all := (leftright_ring_read_address /= 0) and (not leftright_holds_winners);
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_other_1_0 <= winnersother_winner_out_0;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_other_4_0 <= leftright_other_3_0;
      leftright_other_5_0 <= leftright_other_4_0;
      leftright_other_6_0 <= leftright_other_5_0;
      leftright_other_7_0 <= leftright_other_6_0;
      leftright_other_8_0 <= leftright_other_7_0;
      leftright_other_9_0 <= leftright_other_8_0;
      leftright_other_10_0 <= leftright_other_9_0;
      leftright_other_11_0 <= leftright_other_10_0;
      leftright_other_12_0 <= leftright_other_11_0;
      leftright_other_13_0 <= leftright_other_12_0;
      leftright_other_14_0 <= leftright_other_13_0;
      leftright_other_15_0 <= leftright_other_14_0;
      leftright_position <= (leftright_position + as_number(refinement_tag_11_valid)) mod 16;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and refinement_tag_11_valid;
      leftright_address_0 <= (to_integer(leftright_held_0(17 downto 4)) + leftright_held_position + 5) mod 16;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(7 downto 4));
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= to_integer(leftright_held_0(0 downto 0)) = 1;
      leftright_asking_tag_output_column <= to_integer(leftright_held_0(1 downto 1)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_output_column <= leftright_asking_tag_output_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_output_column <= leftright_answered_tag_output_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_all then
        leftright_holds_winners <= (not refinement_tag_11_valid) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_11_valid or leftright_holds_winners;
      end if;
      if refinement_tag_11_valid then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 11 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 16;
        end if;
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not leftright_checked_tag_map_column) or (not
        leftright_checked_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 63;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 37;
      end if;
      turn_order_address_any_2 := (not leftright_checked_tag_map_column) or (not leftright_checked_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 64;
        else
          turn_order_address <= turn_order_address_choice_2;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid;
      turn_order_complete_all := leftright_checked_tag_map_column and leftright_checked_tag_valid;
      turn_ready_tag_row_start_is_equal := map_counter_column = 37;
      if (map_counter_group / 2) = 6 then
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start and ((map_counter_group mod 2) = 1);
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice_2 := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choice_2 := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := map_counter_group = 11;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal and turn_ready_tag_row_start_is_equal_2;
      if turn_ready_tag_row_start_choice_2 then
        turn_ready_tag_row_start_choice_3 := turn_ready_tag_row_start_all or (not turn_ready_tag_start_of_frame);
      else
        turn_ready_tag_row_start_choice_3 := turn_ready_tag_row_start_is_equal and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_start_of_frame;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_valid and turn_ready_tag_map_column;
      turn_order_turned_valid <= leftright_checked_tag_valid;
      turn_order_turned_map_column <= leftright_checked_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= leftright_checked_tag_end_of_line;
      turn_newest <= (leftright_checked_fraction_0 * 512) + leftright_checked_disparity_0 +
        (as_number(leftright_checked_passed_0) * 256);
      turn_comes <= turn_order_complete_all;
      turn_read_tag_valid <= turn_order_turned_valid;
      turn_read_tag_map_column <= turn_order_turned_map_column;
      turn_read_tag_start_of_frame <= turn_order_turned_start_of_frame;
      turn_read_tag_end_of_line <= turn_order_turned_end_of_line;
      turn_ready <= to_integer(turn_read_words_0);
      turn_ready_tag_valid <= turn_read_tag_valid;
      turn_ready_tag_map_column <= turn_read_tag_map_column;
      turn_ready_tag_start_of_frame <= turn_read_tag_start_of_frame;
      turn_ready_tag_end_of_line <= turn_read_tag_end_of_line;
      if turn_order_falls then
        turn_order_falls <= turn_order_address_any;
      else
        turn_order_falls <= turn_order_falls_all;
      end if;
      if leftright_checked_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_ready_tag_row_start_choice_3 then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_valid) or (not
          turn_ready_tag_map_column));
      end if;
      if leftright_checked_tag_valid then
        turn_order_inside <= leftright_checked_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= leftright_checked_tag_output_column;
        turn_order_first <= leftright_checked_tag_start_of_frame;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- map
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_row_start_is_equal or turn_ready_tag_start_of_frame then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 64;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        map_counter_group_choice := 3;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 12;
      if map_counter_group_is_equal and turn_ready_tag_row_start then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 16;
      end if;
      if turn_ready_tag_row_start_is_equal and (((map_counter_group / 2) /= 6) or (not ((map_counter_group mod 2) =
        1))) and turn_ready_tag_valid and turn_ready_tag_map_column then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if turn_ready_tag_valid then
        map_line_ended_choice := turn_ready_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_1(16 downto 16)) = 1;
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_0 / 2;
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
      if ((map_sorted_column / 2) mod 2) = 1 then
        map_window_complete_choice := map_sorted_arrives;
      else
        map_window_complete_choice := ((map_sorted_column mod 2) = 1) and map_sorted_arrives;
      end if;
      if (map_sorted_column / 4) = 0 then
        map_window_complete_choice_2 := map_window_complete_choice;
      else
        map_window_complete_choice_2 := map_sorted_arrives;
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
        map_median_middle_0_choice_2 := map_of_middle_0_b;
      else
        map_median_middle_0_choice_2 := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choice_3 := map_of_middle_0_c;
      else
        map_median_middle_0_choice_3 := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice_4 := map_of_middle_0_a;
      else
        map_median_middle_0_choice_4 := map_median_middle_0_choice_3;
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
        map_out_disparity_0_choice_2 := map_of_all_0_b;
      else
        map_out_disparity_0_choice_2 := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choice_3 := map_of_all_0_c;
      else
        map_out_disparity_0_choice_3 := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice_4 := map_of_all_0_a;
      else
        map_out_disparity_0_choice_4 := map_out_disparity_0_choice_3;
      end if;
      map_counter_next_frame <= to_integer(other_1(40 downto 40)) = 1;
      map_newest_0 <= ((((((((turn_ready mod 256) + (turn_ready / 8192)) * 2) + (((turn_ready / 512) mod 16) / 8) +
        8191) mod 4096) * 8) + ((turn_ready / 512) mod 8)) * 2) + ((turn_ready / 256) mod 2);
      map_arrives <= turn_ready_tag_row_start_all_2;
      map_behind <= map_line_ended and turn_ready_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_1(5 downto 0));
      map_column_1 <= other_3 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_1(24 downto 24)) = 1;
      map_at_top <= to_integer(other_1(32 downto 32)) = 1;
      map_at_output <= to_integer(other_1(48 downto 48)) = 1;
      map_of_column_0_a <= map_of_column_0_a_choice;
      map_of_column_0_b <= map_column_1 / 2;
      map_of_column_0_c <= map_of_column_0_c_choice;
      map_of_column_0_b_below_a <= ((map_column_1 / 2) - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_a <= (map_of_column_0_c_choice - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_b <= (map_of_column_0_c_choice - (map_column_1 / 2)) < 0;
      map_column_passed_0_0 <= (map_column_1 mod 2) = 1;
      map_column_passed_1_0 <= map_column_passed_0_0;
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
      map_window_first <= map_sorted_top and map_sorted_arrives and (map_sorted_column = 1);
      map_window_last <= map_sorted_behind;
      map_of_low_0_a <= map_low_0_0;
      map_of_low_0_b <= map_low_1_0;
      map_of_low_0_c <= map_low_2_0;
      map_of_low_0_b_below_a <= (map_low_1_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_a <= (map_low_2_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_b <= (map_low_2_0 - map_low_1_0) < 0;
      map_of_middle_0_a <= map_middle_0_0;
      map_of_middle_0_b <= map_middle_1_0;
      map_of_middle_0_c <= map_middle_2_0;
      map_of_middle_0_b_below_a <= (map_middle_1_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_a <= (map_middle_2_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_b <= (map_middle_2_0 - map_middle_1_0) < 0;
      map_of_high_0_a <= map_high_0_0;
      map_of_high_0_b <= map_high_1_0;
      map_of_high_0_c <= map_high_2_0;
      map_of_high_0_b_below_a <= (map_high_1_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_a <= (map_high_2_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_b <= (map_high_2_0 - map_high_1_0) < 0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_of_all_0_b_below_a <= (map_median_middle_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_a <= (map_smallest_high_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_b <= (map_smallest_high_0 - map_median_middle_0) < 0;
      map_waiting_0_complete <= map_window_complete;
      map_waiting_0_first <= map_window_first;
      map_waiting_0_last <= map_window_last;
      map_waiting_1_complete <= map_waiting_0_complete;
      map_waiting_1_first <= map_waiting_0_first;
      map_waiting_1_last <= map_waiting_0_last;
      map_waiting_2_complete <= map_waiting_1_complete;
      map_waiting_2_first <= map_waiting_1_first;
      map_waiting_2_last <= map_waiting_1_last;
      map_waiting_passed_0_0 <= map_passed_1_0;
      map_waiting_passed_1_0 <= map_waiting_passed_0_0;
      map_waiting_passed_2_0 <= map_waiting_passed_1_0;
      map_out_passed_0 <= map_waiting_passed_2_0;
      map_out_valid <= map_waiting_2_complete;
      map_out_start_of_frame <= map_waiting_2_first and map_waiting_2_complete;
      map_out_end_of_line <= map_waiting_2_last and map_waiting_2_complete;
      if turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_map_column then
        map_counter_group <= map_counter_group_choice * 4;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if turn_ready_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not turn_ready_tag_valid);
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
      if map_passed_0_0 then
        map_passed_1_0 <= map_passed_1_0 or map_sorted_arrives or map_sorted_behind;
      else
        map_passed_1_0 <= map_passed_1_0 and (not map_sorted_arrives) and (not map_sorted_behind);
      end if;
      if map_window_complete_choice_2 then
        map_window_complete <= map_sorted_output;
      else
        map_window_complete <= map_sorted_output and map_sorted_behind;
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choice_2;
      else
        map_median_middle_0 <= map_median_middle_0_choice_4;
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choice_2;
      else
        map_out_disparity_0 <= map_out_disparity_0_choice_4;
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (other_3 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= to_integer(other_1(5 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0_0;
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_1_0_all := map_sorted_arrives and (map_sorted_column = 0);
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0_0;
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0_0;
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      map_low_0_0_all := (not map_sorted_arrives) and (not map_sorted_behind);
      if not map_low_0_0_all then
        map_low_0_0 <= map_low_0_0_choice;
        map_low_2_0 <= map_low_1_0;
        map_middle_0_0 <= map_middle_0_0_choice;
        map_middle_2_0 <= map_middle_1_0;
        map_high_0_0 <= map_high_0_0_choice;
        map_high_2_0 <= map_high_1_0;
        if map_low_1_0_all then
          map_low_1_0 <= map_low_0_0_choice;
          map_middle_1_0 <= map_middle_0_0_choice;
          map_high_1_0 <= map_high_0_0_choice;
        else
          map_low_1_0 <= map_low_0_0;
          map_middle_1_0 <= map_middle_0_0;
          map_high_1_0 <= map_high_0_0;
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0_0 <= map_column_passed_1_0;
      end if;
      -- other
      other_0 <= ((other_3 mod 8192) / 2) * 2;
      other_1 <= other_2;
      other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 13))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_3 <= to_integer(other_4);
      other_5 <= ((refinement_remainder_7_0_difference / 2048) * 2) + ((other_6 / 4) * 4);
      other_6 <= ((refinement_remainder_6_0_difference / 2048) * 4) + ((other_7 / 8) * 8);
      other_7 <= ((refinement_remainder_5_0_difference / 2048) * 8) + ((other_8 / 16) * 16);
      other_8 <= ((refinement_remainder_4_0_difference / 2048) * 16) + ((other_9 / 32) * 32);
      other_9 <= ((refinement_remainder_3_0_difference / 2048) * 32) + ((other_10 / 64) * 64);
      other_10 <= ((refinement_remainder_2_0_difference / 2048) * 64) + ((other_11 / 128) * 128);
      other_11 <= (refinement_remainder_1_0_difference / 2048) * 128;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 13;
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
        raster_place_group <= 13;
        raster_place_next_frame <= false;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_first_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_first_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_map_column <= false;
        slice0cost_difference_tag_output_column <= false;
        slice0cost_difference_tag_first_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_first_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_first_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0_tag_0_valid <= false;
        slice0_tag_0_map_column <= false;
        slice0_tag_0_output_column <= false;
        slice0_tag_0_start_of_frame <= false;
        slice0_tag_0_end_of_line <= false;
        slice0_tag_1_valid <= false;
        slice0_tag_1_map_column <= false;
        slice0_tag_1_output_column <= false;
        slice0_tag_1_first_column <= false;
        slice0_tag_1_start_of_frame <= false;
        slice0_tag_1_end_of_line <= false;
        slice0_tag_2_valid <= false;
        slice0_tag_2_map_column <= false;
        slice0_tag_2_output_column <= false;
        slice0_tag_2_first_column <= false;
        slice0_tag_2_start_of_frame <= false;
        slice0_tag_2_end_of_line <= false;
        slice1cost_tag_first_column <= false;
        slice1window_tag_first_column <= false;
        slice2cost_tag_first_column <= false;
        entry_next_tag_valid <= false;
        entry_next_tag_map_column <= false;
        entry_next_tag_end_of_line <= false;
        entry_next_column <= 0;
        entry_order_address <= 0;
        entry_order_falls <= false;
        entry_order_inside <= false;
        entry_order_complete <= false;
        entry_order_output <= false;
        entry_order_first <= false;
        entry_order_held_output <= false;
        entry_order_turned_output_column <= false;
        entry_order_turned_start_of_frame <= false;
        entry_tag_valid <= false;
        entry_tag_map_column <= false;
        entry_tag_end_of_line <= false;
        entry_column <= 0;
        entry_place <= 0;
        entry_turned_output_column <= false;
        entry_turned_start_of_frame <= false;
        forward_cost_delay_ring_read_address <= 1;
        forward_cost_delay_ring_write_address <= 0;
        forward_above_delay_ring_read_address <= 1;
        forward_above_delay_ring_write_address <= 0;
        forward_above_comes_0 <= false;
        forward_above_comes_1 <= false;
        forward_above_comes_2 <= false;
        forward_above_comes_3 <= false;
        forward_above_comes_4 <= false;
        forward_above_comes_5 <= false;
        forward_above_comes_6 <= false;
        forward_above_comes_7 <= false;
        forward_above_comes_8 <= false;
        forward_above_comes_9 <= false;
        forward_above_column_0 <= 0;
        forward_above_column_1 <= 0;
        forward_above_column_2 <= 0;
        forward_above_column_3 <= 0;
        forward_above_column_4 <= 0;
        forward_above_column_5 <= 0;
        forward_above_column_6 <= 0;
        forward_above_column_7 <= 0;
        forward_above_column_8 <= 0;
        forward_above_column_9 <= 0;
        forward_above_writes_copy_0 <= false;
        forward_above_write_column <= 0;
        sums_turn_place_0 <= 0;
        sums_turn_place_1 <= 0;
        sums_turn_place_2 <= 0;
        sums_turn_place_3 <= 0;
        sums_turn_place_4 <= 0;
        sums_turn_place_5 <= 0;
        sums_turn_place_6 <= 0;
        sums_turn_place_7 <= 0;
        sums_turn_place_8 <= 0;
        sums_turn_writes_copy_0 <= false;
        sums_turn_write_place <= 0;
        sums_turn_waiting_read_place <= 0;
        sums_sum_delay_ring_read_address <= 1;
        sums_sum_delay_ring_write_address <= 0;
        sums_tag_valid <= false;
        sums_tag_map_column <= false;
        sums_tag_output_column <= false;
        sums_tag_start_of_frame <= false;
        sums_tag_end_of_line <= false;
        sums_tags_held_0_output_column <= false;
        sums_tags_held_0_start_of_frame <= false;
        sums_tags_held_0_end_of_line <= false;
        sums_tags_held_1_output_column <= false;
        sums_tags_held_1_start_of_frame <= false;
        sums_tags_held_1_end_of_line <= false;
        sums_tags_held_2_output_column <= false;
        sums_tags_held_2_start_of_frame <= false;
        sums_tags_held_2_end_of_line <= false;
        sums_tags_held_3_output_column <= false;
        sums_tags_held_3_start_of_frame <= false;
        sums_tags_held_3_end_of_line <= false;
        sums_tags_held_4_output_column <= false;
        sums_tags_held_4_start_of_frame <= false;
        sums_tags_held_4_end_of_line <= false;
        sums_tags_held_5_output_column <= false;
        sums_tags_held_5_start_of_frame <= false;
        sums_tags_held_5_end_of_line <= false;
        sums_tags_held_6_output_column <= false;
        sums_tags_held_6_start_of_frame <= false;
        sums_tags_held_6_end_of_line <= false;
        sums_tags_held_7_output_column <= false;
        sums_tags_held_7_start_of_frame <= false;
        sums_tags_held_7_end_of_line <= false;
        sums_tags_held_8_output_column <= false;
        sums_tags_held_8_start_of_frame <= false;
        sums_tags_held_8_end_of_line <= false;
        sums_tags_held_9_output_column <= false;
        sums_tags_held_9_start_of_frame <= false;
        sums_tags_held_9_end_of_line <= false;
        sums_tags_held_10_map_column <= false;
        sums_tags_held_10_output_column <= false;
        sums_tags_held_10_start_of_frame <= false;
        sums_tags_held_10_end_of_line <= false;
        sums_tags_held_11_map_column <= false;
        sums_tags_held_11_output_column <= false;
        sums_tags_held_11_start_of_frame <= false;
        sums_tags_held_11_end_of_line <= false;
        sums_tags_held_12_map_column <= false;
        sums_tags_held_12_output_column <= false;
        sums_tags_held_12_start_of_frame <= false;
        sums_tags_held_12_end_of_line <= false;
        sums_tags_held_13_map_column <= false;
        sums_tags_held_13_output_column <= false;
        sums_tags_held_13_start_of_frame <= false;
        sums_tags_held_13_end_of_line <= false;
        sums_tags_moved <= false;
        winnerswinner1_tag_valid <= false;
        winnerswinner1_tag_map_column <= false;
        winnerswinner1_tag_output_column <= false;
        winnerswinner1_tag_start_of_frame <= false;
        winnerswinner1_tag_end_of_line <= false;
        winnerswinner2_tag_valid <= false;
        winnerswinner2_tag_map_column <= false;
        winnerswinner2_tag_output_column <= false;
        winnerswinner2_tag_start_of_frame <= false;
        winnerswinner2_tag_end_of_line <= false;
        winnerswinner3_tag_valid <= false;
        winnerswinner3_tag_map_column <= false;
        winnerswinner3_tag_output_column <= false;
        winnerswinner3_tag_start_of_frame <= false;
        winnerswinner3_tag_end_of_line <= false;
        winnerswinner4_tag_valid <= false;
        winnerswinner4_tag_map_column <= false;
        winnerswinner4_tag_output_column <= false;
        winnerswinner4_tag_start_of_frame <= false;
        winnerswinner4_tag_end_of_line <= false;
        winners_best_tag_valid <= false;
        winners_best_tag_map_column <= false;
        winners_best_tag_output_column <= false;
        winners_best_tag_start_of_frame <= false;
        winners_best_tag_end_of_line <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_output_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_output_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_output_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_output_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_output_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_output_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_output_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_output_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_output_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_output_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_map_column <= false;
        refinement_tag_10_output_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_map_column <= false;
        refinement_tag_11_output_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_valid <= false;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_output_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_output_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_output_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
        turn_order_inside <= false;
        turn_order_complete <= false;
        turn_order_output <= false;
        turn_order_first <= false;
        turn_order_turned_valid <= false;
        turn_order_turned_map_column <= false;
        turn_order_turned_start_of_frame <= false;
        turn_order_turned_end_of_line <= false;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_ready_tag_valid <= false;
        turn_ready_tag_row_start <= false;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 13;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
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
        map_waiting_0_complete <= false;
        map_waiting_0_first <= false;
        map_waiting_0_last <= false;
        map_waiting_1_complete <= false;
        map_waiting_1_first <= false;
        map_waiting_1_last <= false;
        map_waiting_2_complete <= false;
        map_waiting_2_first <= false;
        map_waiting_2_last <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_1 <= to_unsigned(0, 49);
        other_2 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
