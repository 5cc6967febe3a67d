-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, dynamic range, configuration tiny_dynamic_12bit: 64x32, 32 disparities by two windows of 16, window 5x5, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 32, window_px 5, pixel_bits 12.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_dynamic_12bit
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_dynamic_12bit is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 64;
    height_px : positive := 32;
    disparities : positive := 32;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 48;
    latency_clocks : positive := 41;
    flush_groups : positive := 3024;
    gap_groups : positive := 1536
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(11 downto 0);  -- 12 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(11 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(7 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 64 report "stereo_core_tiny_dynamic_12bit: width_px is " & integer'image(width_px) & " but this core has 64" severity failure;
  assert height_px = 32 report "stereo_core_tiny_dynamic_12bit: height_px is " & integer'image(height_px) & " but this core has 32" severity failure;
  assert disparities = 32 report "stereo_core_tiny_dynamic_12bit: disparities is " & integer'image(disparities) & " but this core has 32" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_dynamic_12bit: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_dynamic_12bit: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 48 report "stereo_core_tiny_dynamic_12bit: output_width_px is " & integer'image(output_width_px) & " but this core has 48" severity failure;
  assert latency_clocks = 41 report "stereo_core_tiny_dynamic_12bit: latency_clocks is " & integer'image(latency_clocks) & " but this core has 41" severity failure;
  assert flush_groups = 3024 report "stereo_core_tiny_dynamic_12bit: flush_groups is " & integer'image(flush_groups) & " but this core has 3024" severity failure;
  assert gap_groups = 1536 report "stereo_core_tiny_dynamic_12bit: gap_groups is " & integer'image(gap_groups) & " but this core has 1536" severity failure;
end entity;

architecture rtl of stereo_core_tiny_dynamic_12bit is
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
  -- coarse
  signal coarse_pixels_left, coarse_pixels_right : natural range 0 to 4095;
  signal coarse_pixels_valid, coarse_pixels_first_row, coarse_pixels_sum_ends, coarse_pixels_sum_is_first : boolean;
  signal coarse_pixels_sum_is_last, coarse_pixels_sum_starts, coarse_pixels_read_ends : boolean;
  signal coarse_pixels_read_is_first, coarse_pixels_read_is_last, coarse_pixels_read_starts : boolean;
  signal coarse_pixels_total_ends, coarse_pixels_total_is_last, coarse_pixels_total_starts : boolean;
  signal coarse_pixels_out_start, coarse_pixels_out_valid : boolean;
  signal coarse_pixels_column, coarse_pixels_sum_column, coarse_pixels_read_column : natural range 0 to 15;
  signal coarse_pixels_total_column : natural range 0 to 15;
  signal coarse_pixels_part : natural range 0 to 255;
  signal coarse_pixels_row : natural range 0 to 3;
  signal coarse_pixels_left_sum, coarse_pixels_right_sum, coarse_pixels_left_read : natural range 0 to 65535;
  signal coarse_pixels_right_read, coarse_pixels_repetition : natural range 0 to 65535;
  signal coarse_pixels_read_word_0, coarse_pixels_total : unsigned(31 downto 0);
  signal coarse_pixels_out_left, coarse_pixels_out_right : natural range 0 to 4096;
  -- coarsetransform
  signal coarsetransform_left_0, coarsetransform_right_0 : natural range 0 to 4096;
  signal coarsetransform_left_rows_read_newest_0, coarsetransform_left_rows_ready_newest_0 : natural range 0 to 4096;
  signal coarsetransform_right_rows_read_newest_0, coarsetransform_right_rows_ready_newest_0 : natural range 0 to 4096;
  signal coarsetransform_left_column_4, coarsetransform_right_column_4 : natural range 0 to 4096;
  signal coarsetransform_valid, coarsetransform_counter_next_frame, coarsetransform_from_first_0 : boolean;
  signal coarsetransform_up_to_last_0, coarsetransform_columns_inside_0 : boolean;
  signal coarsetransform_columns_start_of_frame, coarsetransform_columns_valid : boolean;
  signal coarsetransform_filtering_0_inside_0, coarsetransform_filtering_0_start_of_frame : boolean;
  signal coarsetransform_filtering_0_valid, coarsetransform_filtering_1_inside_0 : boolean;
  signal coarsetransform_filtering_1_start_of_frame, coarsetransform_filtering_1_valid : boolean;
  signal coarsetransform_filtering_2_inside_0, coarsetransform_filtering_2_start_of_frame : boolean;
  signal coarsetransform_filtering_2_valid, coarsetransform_filtering_3_inside_0 : boolean;
  signal coarsetransform_filtering_3_start_of_frame, coarsetransform_filtering_3_valid : boolean;
  signal coarsetransform_filtering_4_inside_0, coarsetransform_filtering_4_start_of_frame : boolean;
  signal coarsetransform_filtering_4_valid, coarsetransform_filtering_5_start_of_frame : boolean;
  signal coarsetransform_filtering_5_valid : boolean;
  signal coarsetransform_counter_column, coarsetransform_read_column : natural range 0 to 31;
  signal coarsetransform_ready_column, coarsetransform_write_column : natural range 0 to 31;
  signal coarsetransform_counter_group : natural range 0 to 15;
  signal coarsetransform_left_rows_read_words_0, coarsetransform_left_rows_read_words_1 : unsigned(23 downto 0);
  signal coarsetransform_right_rows_read_words_0, coarsetransform_right_rows_read_words_1 : unsigned(23 downto 0);
  signal coarsetransform_left_rows_ready_words_0, coarsetransform_left_rows_ready_words_1 : natural range 0 to 16777215;
  signal coarsetransform_left_rows_write_words_0 : natural range 0 to 16777215;
  signal coarsetransform_right_rows_ready_words_0 : natural range 0 to 16777215;
  signal coarsetransform_right_rows_ready_words_1 : natural range 0 to 16777215;
  signal coarsetransform_right_rows_write_words_0 : natural range 0 to 16777215;
  signal coarsetransform_left_rows_write_words_1 : natural range 0 to 16781311;
  signal coarsetransform_right_rows_write_words_1 : natural range 0 to 16781311;
  signal coarsetransform_centre_group : natural range 0 to 16;
  signal coarsetransform_left_column_0, coarsetransform_left_column_1 : natural range 0 to 4095;
  signal coarsetransform_left_column_2, coarsetransform_left_column_3 : natural range 0 to 4095;
  signal coarsetransform_right_column_0, coarsetransform_right_column_1 : natural range 0 to 4095;
  signal coarsetransform_right_column_2, coarsetransform_right_column_3 : natural range 0 to 4095;
  signal coarsetransform_left_code_column_centre, coarsetransform_right_code_column_centre : natural range 0 to 4095;
  signal coarsetransform_left_code_column_near, coarsetransform_right_code_column_near : natural range 0 to 8190;
  signal coarsetransform_left_code_column_outer, coarsetransform_left_code_column_response_1 : natural range 0 to 32767;
  signal coarsetransform_left_code_row_column_1_0, coarsetransform_left_code_row_column_1_1 : natural range 0 to 32767;
  signal coarsetransform_left_code_row_column_1_2, coarsetransform_left_code_row_column_1_3 : natural range 0 to 32767;
  signal coarsetransform_left_code_row_centre_1, coarsetransform_right_code_column_outer : natural range 0 to 32767;
  signal coarsetransform_right_code_column_response_1 : natural range 0 to 32767;
  signal coarsetransform_right_code_row_column_1_0 : natural range 0 to 32767;
  signal coarsetransform_right_code_row_column_1_1 : natural range 0 to 32767;
  signal coarsetransform_right_code_row_column_1_2 : natural range 0 to 32767;
  signal coarsetransform_right_code_row_column_1_3, coarsetransform_right_code_row_centre_1 : natural range 0 to 32767;
  signal coarsetransform_left_code_column_upper, coarsetransform_right_code_column_upper : natural range 0 to 12285;
  signal coarsetransform_left_code_column_lower, coarsetransform_right_code_column_lower : natural range 0 to 12287;
  signal coarsetransform_left_code_column_response_0 : natural range 0 to 16381;
  signal coarsetransform_left_code_row_column_0_0, coarsetransform_left_code_row_column_0_1 : natural range 0 to 16381;
  signal coarsetransform_left_code_row_column_0_2, coarsetransform_left_code_row_column_0_3 : natural range 0 to 16381;
  signal coarsetransform_left_code_row_centre_0 : natural range 0 to 16381;
  signal coarsetransform_right_code_column_response_0 : natural range 0 to 16381;
  signal coarsetransform_right_code_row_column_0_0 : natural range 0 to 16381;
  signal coarsetransform_right_code_row_column_0_1 : natural range 0 to 16381;
  signal coarsetransform_right_code_row_column_0_2 : natural range 0 to 16381;
  signal coarsetransform_right_code_row_column_0_3, coarsetransform_right_code_row_centre_0 : natural range 0 to 16381;
  signal coarsetransform_left_code_column_response_2 : natural range 0 to 24572;
  signal coarsetransform_left_code_row_column_2_0, coarsetransform_left_code_row_column_2_1 : natural range 0 to 24572;
  signal coarsetransform_left_code_row_column_2_2, coarsetransform_left_code_row_column_2_3 : natural range 0 to 24572;
  signal coarsetransform_left_code_row_centre_2 : natural range 0 to 24572;
  signal coarsetransform_right_code_column_response_2 : natural range 0 to 24572;
  signal coarsetransform_right_code_row_column_2_0 : natural range 0 to 24572;
  signal coarsetransform_right_code_row_column_2_1 : natural range 0 to 24572;
  signal coarsetransform_right_code_row_column_2_2 : natural range 0 to 24572;
  signal coarsetransform_right_code_row_column_2_3, coarsetransform_right_code_row_centre_2 : natural range 0 to 24572;
  signal coarsetransform_left_code_row_outer_1, coarsetransform_right_code_row_outer_1 : natural range 0 to 65534;
  signal coarsetransform_left_code_row_outer_2, coarsetransform_right_code_row_outer_2 : natural range 0 to 49144;
  signal coarsetransform_left_code_row_before_0, coarsetransform_left_code_row_after_0 : natural range 0 to 49143;
  signal coarsetransform_right_code_row_before_0, coarsetransform_right_code_row_after_0 : natural range 0 to 49143;
  signal coarsetransform_left_code_row_before_1, coarsetransform_left_code_row_after_1 : natural range 0 to 98301;
  signal coarsetransform_right_code_row_before_1, coarsetransform_right_code_row_after_1 : natural range 0 to 98301;
  signal coarsetransform_left_code_row_before_2, coarsetransform_left_code_row_after_2 : natural range 0 to 73717;
  signal coarsetransform_right_code_row_before_2, coarsetransform_right_code_row_after_2 : natural range 0 to 73717;
  signal coarsetransform_left_code_row_even_1, coarsetransform_left_code_row_even_2 : natural range 0 to 262143;
  signal coarsetransform_left_code_row_odd_1, coarsetransform_left_code_row_odd_2 : natural range 0 to 262143;
  signal coarsetransform_right_code_row_even_1, coarsetransform_right_code_row_even_2 : natural range 0 to 262143;
  signal coarsetransform_right_code_row_odd_1, coarsetransform_right_code_row_odd_2 : natural range 0 to 262143;
  signal coarsetransform_left_code_row_signs, coarsetransform_left_code_bits : natural range 0 to 63;
  signal coarsetransform_right_code_row_signs, coarsetransform_right_code_bits : natural range 0 to 63;
  -- coarseraster
  signal coarseraster_features_search_0, coarseraster_features_reference_0 : natural range 0 to 63;
  signal coarseraster_features_valid, coarseraster_place_next_frame : boolean;
  signal coarseraster_place_column : natural range 0 to 31;
  signal coarseraster_place_group : natural range 0 to 15;
  -- coarsedelay
  signal coarsedelay_ring_read_address, coarsedelay_ring_write_address : natural range 0 to 7;
  signal coarsedelay_ahead_0 : natural range 0 to 63;
  signal coarsedelay_delayed_0 : unsigned(5 downto 0);
  signal coarsedelay_column : natural range 0 to 31;
  signal coarsedelay_row_inside_0, coarsedelay_row_inside_1, coarsedelay_row_inside_2 : boolean;
  signal coarsedelay_row_inside_3, coarsedelay_row_inside_4, coarsedelay_row_inside_5 : boolean;
  signal coarsedelay_row_inside_6, coarsedelay_tag_valid, coarsedelay_tag_border_column : boolean;
  signal coarsedelay_tag_first_cost, coarsedelay_tag_map_column, coarsedelay_tag_output_column : boolean;
  signal coarsedelay_tag_start_of_frame, coarsedelay_tag_end_of_line : boolean;
  -- coarserows
  signal coarserows_search_rows_read_words_0, coarserows_reference_rows_read_words_0 : unsigned(29 downto 0);
  signal coarserows_search_rows_read_words_1, coarserows_reference_rows_read_words_1 : unsigned(5 downto 0);
  signal coarserows_search_rows_read_newest_0, coarserows_search_rows_ready_words_1 : natural range 0 to 63;
  signal coarserows_search_rows_ready_newest_0, coarserows_search_rows_write_words_1 : natural range 0 to 63;
  signal coarserows_reference_rows_read_newest_0, coarserows_reference_rows_ready_words_1 : natural range 0 to 63;
  signal coarserows_reference_rows_ready_newest_0, coarserows_reference_rows_write_words_1 : natural range 0 to 63;
  signal coarserows_search_0, coarserows_search_1, coarserows_search_2, coarserows_search_3 : natural range 0 to 63;
  signal coarserows_search_4, coarserows_search_5, coarserows_search_6, coarserows_reference_0 : natural range 0 to 63;
  signal coarserows_reference_1, coarserows_reference_2, coarserows_reference_3 : natural range 0 to 63;
  signal coarserows_reference_4, coarserows_reference_5, coarserows_reference_6 : natural range 0 to 63;
  signal coarserows_search_rows_ready_words_0, coarserows_search_rows_write_words_0 : natural range 0 to 1073741823;
  signal coarserows_reference_rows_ready_words_0 : natural range 0 to 1073741823;
  signal coarserows_reference_rows_write_words_0 : natural range 0 to 1073741823;
  signal coarserows_read_column, coarserows_ready_column, coarserows_write_column : natural range 0 to 31;
  signal coarserows_read_inside_0, coarserows_read_inside_1, coarserows_read_inside_2 : boolean;
  signal coarserows_read_inside_3, coarserows_read_inside_4, coarserows_read_inside_5 : boolean;
  signal coarserows_read_inside_6, coarserows_read_tag_valid, coarserows_read_tag_border_column : boolean;
  signal coarserows_read_tag_first_cost, coarserows_read_tag_map_column, coarserows_read_tag_output_column : boolean;
  signal coarserows_read_tag_start_of_frame, coarserows_read_tag_end_of_line, coarserows_ready_inside_0 : boolean;
  signal coarserows_ready_inside_1, coarserows_ready_inside_2, coarserows_ready_inside_3 : boolean;
  signal coarserows_ready_inside_4, coarserows_ready_inside_5, coarserows_ready_inside_6 : boolean;
  signal coarserows_ready_tag_valid, coarserows_ready_tag_border_column, coarserows_ready_tag_first_cost : boolean;
  signal coarserows_ready_tag_map_column, coarserows_ready_tag_output_column : boolean;
  signal coarserows_ready_tag_start_of_frame, coarserows_ready_tag_end_of_line, coarserows_tag_valid : boolean;
  signal coarserows_tag_border_column, coarserows_tag_first_cost, coarserows_tag_map_column : boolean;
  signal coarserows_tag_output_column, coarserows_tag_start_of_frame, coarserows_tag_end_of_line : boolean;
  -- coarseslice0shift
  signal coarseslice0shift_search_0_0, coarseslice0shift_search_0_1 : natural range 0 to 63;
  signal coarseslice0shift_search_0_2, coarseslice0shift_search_0_3 : natural range 0 to 63;
  signal coarseslice0shift_search_0_4, coarseslice0shift_search_0_5 : natural range 0 to 63;
  signal coarseslice0shift_search_0_6, coarseslice0shift_search_0_7 : natural range 0 to 63;
  signal coarseslice0shift_search_1_0, coarseslice0shift_search_1_1 : natural range 0 to 63;
  signal coarseslice0shift_search_1_2, coarseslice0shift_search_1_3 : natural range 0 to 63;
  signal coarseslice0shift_search_1_4, coarseslice0shift_search_1_5 : natural range 0 to 63;
  signal coarseslice0shift_search_1_6, coarseslice0shift_search_1_7 : natural range 0 to 63;
  signal coarseslice0shift_search_2_0, coarseslice0shift_search_2_1 : natural range 0 to 63;
  signal coarseslice0shift_search_2_2, coarseslice0shift_search_2_3 : natural range 0 to 63;
  signal coarseslice0shift_search_2_4, coarseslice0shift_search_2_5 : natural range 0 to 63;
  signal coarseslice0shift_search_2_6, coarseslice0shift_search_2_7 : natural range 0 to 63;
  signal coarseslice0shift_search_3_0, coarseslice0shift_search_3_1 : natural range 0 to 63;
  signal coarseslice0shift_search_3_2, coarseslice0shift_search_3_3 : natural range 0 to 63;
  signal coarseslice0shift_search_3_4, coarseslice0shift_search_3_5 : natural range 0 to 63;
  signal coarseslice0shift_search_3_6, coarseslice0shift_search_3_7 : natural range 0 to 63;
  signal coarseslice0shift_search_4_0, coarseslice0shift_search_4_1 : natural range 0 to 63;
  signal coarseslice0shift_search_4_2, coarseslice0shift_search_4_3 : natural range 0 to 63;
  signal coarseslice0shift_search_4_4, coarseslice0shift_search_4_5 : natural range 0 to 63;
  signal coarseslice0shift_search_4_6, coarseslice0shift_search_4_7 : natural range 0 to 63;
  signal coarseslice0shift_search_5_0, coarseslice0shift_search_5_1 : natural range 0 to 63;
  signal coarseslice0shift_search_5_2, coarseslice0shift_search_5_3 : natural range 0 to 63;
  signal coarseslice0shift_search_5_4, coarseslice0shift_search_5_5 : natural range 0 to 63;
  signal coarseslice0shift_search_5_6, coarseslice0shift_search_5_7 : natural range 0 to 63;
  signal coarseslice0shift_search_6_0, coarseslice0shift_search_6_1 : natural range 0 to 63;
  signal coarseslice0shift_search_6_2, coarseslice0shift_search_6_3 : natural range 0 to 63;
  signal coarseslice0shift_search_6_4, coarseslice0shift_search_6_5 : natural range 0 to 63;
  signal coarseslice0shift_search_6_6, coarseslice0shift_search_6_7 : natural range 0 to 63;
  signal coarseslice0shift_reference_0, coarseslice0shift_reference_1 : natural range 0 to 63;
  signal coarseslice0shift_reference_2, coarseslice0shift_reference_3 : natural range 0 to 63;
  signal coarseslice0shift_reference_4, coarseslice0shift_reference_5 : natural range 0 to 63;
  signal coarseslice0shift_reference_6 : natural range 0 to 63;
  signal coarseslice0shift_tag_valid, coarseslice0shift_tag_border_column, coarseslice0shift_tag_first_cost : boolean;
  signal coarseslice0shift_tag_map_column, coarseslice0shift_tag_output_column : boolean;
  signal coarseslice0shift_tag_start_of_frame, coarseslice0shift_tag_end_of_line : boolean;
  -- coarseslice0cost
  signal coarseslice0cost_pixels_first_0_0, coarseslice0cost_pixels_first_0_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_0_2, coarseslice0cost_pixels_first_0_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_0_4, coarseslice0cost_pixels_first_0_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_0_6, coarseslice0cost_pixels_first_0_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_1_0, coarseslice0cost_pixels_first_1_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_1_2, coarseslice0cost_pixels_first_1_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_1_4, coarseslice0cost_pixels_first_1_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_1_6, coarseslice0cost_pixels_first_1_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_2_0, coarseslice0cost_pixels_first_2_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_2_2, coarseslice0cost_pixels_first_2_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_2_4, coarseslice0cost_pixels_first_2_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_2_6, coarseslice0cost_pixels_first_2_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_3_0, coarseslice0cost_pixels_first_3_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_3_2, coarseslice0cost_pixels_first_3_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_3_4, coarseslice0cost_pixels_first_3_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_3_6, coarseslice0cost_pixels_first_3_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_4_0, coarseslice0cost_pixels_first_4_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_4_2, coarseslice0cost_pixels_first_4_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_4_4, coarseslice0cost_pixels_first_4_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_4_6, coarseslice0cost_pixels_first_4_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_5_0, coarseslice0cost_pixels_first_5_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_5_2, coarseslice0cost_pixels_first_5_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_5_4, coarseslice0cost_pixels_first_5_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_5_6, coarseslice0cost_pixels_first_5_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_6_0, coarseslice0cost_pixels_first_6_1 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_6_2, coarseslice0cost_pixels_first_6_3 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_6_4, coarseslice0cost_pixels_first_6_5 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_6_6, coarseslice0cost_pixels_first_6_7 : natural range 0 to 15;
  signal coarseslice0cost_pixels_first_tag_valid, coarseslice0cost_pixels_first_tag_border_column : boolean;
  signal coarseslice0cost_pixels_first_tag_first_cost, coarseslice0cost_pixels_first_tag_map_column : boolean;
  signal coarseslice0cost_pixels_first_tag_output_column, coarseslice0cost_pixels_first_tag_start_of_frame : boolean;
  signal coarseslice0cost_pixels_first_tag_end_of_line, coarseslice0cost_pixels_tag_valid : boolean;
  signal coarseslice0cost_pixels_tag_border_column, coarseslice0cost_pixels_tag_first_cost : boolean;
  signal coarseslice0cost_pixels_tag_map_column, coarseslice0cost_pixels_tag_output_column : boolean;
  signal coarseslice0cost_pixels_tag_start_of_frame, coarseslice0cost_pixels_tag_end_of_line : boolean;
  signal coarseslice0cost_pair_tag_valid, coarseslice0cost_pair_tag_border_column : boolean;
  signal coarseslice0cost_pair_tag_first_cost, coarseslice0cost_pair_tag_map_column : boolean;
  signal coarseslice0cost_pair_tag_output_column, coarseslice0cost_pair_tag_start_of_frame : boolean;
  signal coarseslice0cost_pair_tag_end_of_line, coarseslice0cost_tag_valid, coarseslice0cost_tag_first_cost : boolean;
  signal coarseslice0cost_tag_map_column, coarseslice0cost_tag_output_column : boolean;
  signal coarseslice0cost_tag_start_of_frame, coarseslice0cost_tag_end_of_line : boolean;
  signal coarseslice0cost_pixels_cost_0_0, coarseslice0cost_pixels_cost_0_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_0_2, coarseslice0cost_pixels_cost_0_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_0_4, coarseslice0cost_pixels_cost_0_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_0_6, coarseslice0cost_pixels_cost_0_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_1_0, coarseslice0cost_pixels_cost_1_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_1_2, coarseslice0cost_pixels_cost_1_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_1_4, coarseslice0cost_pixels_cost_1_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_1_6, coarseslice0cost_pixels_cost_1_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_2_0, coarseslice0cost_pixels_cost_2_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_2_2, coarseslice0cost_pixels_cost_2_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_2_4, coarseslice0cost_pixels_cost_2_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_2_6, coarseslice0cost_pixels_cost_2_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_3_0, coarseslice0cost_pixels_cost_3_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_3_2, coarseslice0cost_pixels_cost_3_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_3_4, coarseslice0cost_pixels_cost_3_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_3_6, coarseslice0cost_pixels_cost_3_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_4_0, coarseslice0cost_pixels_cost_4_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_4_2, coarseslice0cost_pixels_cost_4_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_4_4, coarseslice0cost_pixels_cost_4_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_4_6, coarseslice0cost_pixels_cost_4_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_5_0, coarseslice0cost_pixels_cost_5_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_5_2, coarseslice0cost_pixels_cost_5_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_5_4, coarseslice0cost_pixels_cost_5_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_5_6, coarseslice0cost_pixels_cost_5_7 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_6_0, coarseslice0cost_pixels_cost_6_1 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_6_2, coarseslice0cost_pixels_cost_6_3 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_6_4, coarseslice0cost_pixels_cost_6_5 : natural range 0 to 6;
  signal coarseslice0cost_pixels_cost_6_6, coarseslice0cost_pixels_cost_6_7 : natural range 0 to 6;
  signal coarseslice0cost_single_0_0, coarseslice0cost_single_0_1, coarseslice0cost_single_0_2 : natural range 0 to 6;
  signal coarseslice0cost_single_0_3, coarseslice0cost_single_0_4, coarseslice0cost_single_0_5 : natural range 0 to 6;
  signal coarseslice0cost_single_0_6, coarseslice0cost_single_0_7 : natural range 0 to 6;
  signal coarseslice0cost_pair_0_0, coarseslice0cost_pair_0_1, coarseslice0cost_pair_0_2 : natural range 0 to 12;
  signal coarseslice0cost_pair_0_3, coarseslice0cost_pair_0_4, coarseslice0cost_pair_0_5 : natural range 0 to 12;
  signal coarseslice0cost_pair_0_6, coarseslice0cost_pair_0_7, coarseslice0cost_pair_1_0 : natural range 0 to 12;
  signal coarseslice0cost_pair_1_1, coarseslice0cost_pair_1_2, coarseslice0cost_pair_1_3 : natural range 0 to 12;
  signal coarseslice0cost_pair_1_4, coarseslice0cost_pair_1_5, coarseslice0cost_pair_1_6 : natural range 0 to 12;
  signal coarseslice0cost_pair_1_7, coarseslice0cost_pair_2_0, coarseslice0cost_pair_2_1 : natural range 0 to 12;
  signal coarseslice0cost_pair_2_2, coarseslice0cost_pair_2_3, coarseslice0cost_pair_2_4 : natural range 0 to 12;
  signal coarseslice0cost_pair_2_5, coarseslice0cost_pair_2_6, coarseslice0cost_pair_2_7 : natural range 0 to 12;
  signal coarseslice0cost_column_0_0, coarseslice0cost_column_0_1, coarseslice0cost_column_0_2 : natural range 0 to 42;
  signal coarseslice0cost_column_0_3, coarseslice0cost_column_0_4, coarseslice0cost_column_0_5 : natural range 0 to 42;
  signal coarseslice0cost_column_0_6, coarseslice0cost_column_0_7 : natural range 0 to 42;
  -- coarseslice0window
  signal coarseslice0window_partial_0_0_0, coarseslice0window_partial_0_0_1 : natural range 0 to 42;
  signal coarseslice0window_partial_0_0_2, coarseslice0window_partial_0_0_3 : natural range 0 to 42;
  signal coarseslice0window_partial_0_0_4, coarseslice0window_partial_0_0_5 : natural range 0 to 42;
  signal coarseslice0window_partial_0_0_6, coarseslice0window_partial_0_0_7 : natural range 0 to 42;
  signal coarseslice0window_partial_0_1_0, coarseslice0window_partial_0_1_1 : natural range 0 to 84;
  signal coarseslice0window_partial_0_1_2, coarseslice0window_partial_0_1_3 : natural range 0 to 84;
  signal coarseslice0window_partial_0_1_4, coarseslice0window_partial_0_1_5 : natural range 0 to 84;
  signal coarseslice0window_partial_0_1_6, coarseslice0window_partial_0_1_7 : natural range 0 to 84;
  signal coarseslice0window_partial_0_2_0, coarseslice0window_partial_0_2_1 : natural range 0 to 126;
  signal coarseslice0window_partial_0_2_2, coarseslice0window_partial_0_2_3 : natural range 0 to 126;
  signal coarseslice0window_partial_0_2_4, coarseslice0window_partial_0_2_5 : natural range 0 to 126;
  signal coarseslice0window_partial_0_2_6, coarseslice0window_partial_0_2_7 : natural range 0 to 126;
  signal coarseslice0window_partial_0_3_0, coarseslice0window_partial_0_3_1 : natural range 0 to 168;
  signal coarseslice0window_partial_0_3_2, coarseslice0window_partial_0_3_3 : natural range 0 to 168;
  signal coarseslice0window_partial_0_3_4, coarseslice0window_partial_0_3_5 : natural range 0 to 168;
  signal coarseslice0window_partial_0_3_6, coarseslice0window_partial_0_3_7 : natural range 0 to 168;
  signal coarseslice0window_partial_0_4_0, coarseslice0window_partial_0_4_1 : natural range 0 to 210;
  signal coarseslice0window_partial_0_4_2, coarseslice0window_partial_0_4_3 : natural range 0 to 210;
  signal coarseslice0window_partial_0_4_4, coarseslice0window_partial_0_4_5 : natural range 0 to 210;
  signal coarseslice0window_partial_0_4_6, coarseslice0window_partial_0_4_7 : natural range 0 to 210;
  signal coarseslice0window_partial_0_5_0, coarseslice0window_partial_0_5_1 : natural range 0 to 252;
  signal coarseslice0window_partial_0_5_2, coarseslice0window_partial_0_5_3 : natural range 0 to 252;
  signal coarseslice0window_partial_0_5_4, coarseslice0window_partial_0_5_5 : natural range 0 to 252;
  signal coarseslice0window_partial_0_5_6, coarseslice0window_partial_0_5_7 : natural range 0 to 252;
  signal coarseslice0window_centre_map_column_0, coarseslice0window_centre_map_column_1 : boolean;
  signal coarseslice0window_centre_map_column_2, coarseslice0window_centre_output_column_0 : boolean;
  signal coarseslice0window_centre_output_column_1, coarseslice0window_centre_output_column_2 : boolean;
  signal coarseslice0window_centre_first_column_0, coarseslice0window_centre_first_column_1 : boolean;
  signal coarseslice0window_centre_first_column_2, coarseslice0window_centre_start_of_frame_0 : boolean;
  signal coarseslice0window_centre_start_of_frame_1, coarseslice0window_centre_start_of_frame_2 : boolean;
  signal coarseslice0window_centre_end_of_line_0, coarseslice0window_centre_end_of_line_1 : boolean;
  signal coarseslice0window_centre_end_of_line_2, coarseslice0window_tag_valid : boolean;
  signal coarseslice0window_tag_map_column, coarseslice0window_tag_output_column : boolean;
  signal coarseslice0window_tag_first_column, coarseslice0window_tag_start_of_frame : boolean;
  signal coarseslice0window_tag_end_of_line : boolean;
  signal coarseslice0window_sum_0_0, coarseslice0window_sum_0_1, coarseslice0window_sum_0_2 : natural range 0 to 294;
  signal coarseslice0window_sum_0_3, coarseslice0window_sum_0_4, coarseslice0window_sum_0_5 : natural range 0 to 294;
  signal coarseslice0window_sum_0_6, coarseslice0window_sum_0_7 : natural range 0 to 294;
  -- coarseslice0other
  signal coarseslice0other_cost_0_1, coarseslice0other_cost_0_2, coarseslice0other_cost_0_3 : natural range 0 to 294;
  signal coarseslice0other_cost_0_4, coarseslice0other_cost_0_5, coarseslice0other_cost_0_6 : natural range 0 to 294;
  signal coarseslice0other_cost_0_7 : natural range 0 to 294;
  signal coarseslice0other_winner_0_0, coarseslice0other_winner_0_1 : natural range 0 to 7;
  signal coarseslice0other_winner_0_2, coarseslice0other_winner_0_3 : natural range 0 to 7;
  signal coarseslice0other_winner_0_4, coarseslice0other_winner_0_5 : natural range 0 to 7;
  signal coarseslice0other_winner_0_6, coarseslice0other_winner_0_7 : natural range 0 to 7;
  signal coarseslice0other_winner_out_0 : natural range 0 to 7;
  -- coarseslice0winner1
  signal coarseslice0winner1_of_pair_0_0, coarseslice0winner1_of_pair_0_1 : natural range 0 to 294;
  signal coarseslice0winner1_of_pair_0_2, coarseslice0winner1_of_pair_0_3 : natural range 0 to 294;
  signal coarseslice0winner1_of_pair_0_4, coarseslice0winner1_of_pair_0_5 : natural range 0 to 294;
  signal coarseslice0winner1_of_pair_0_6, coarseslice0winner1_of_pair_0_7 : natural range 0 to 294;
  signal coarseslice0winner1_of_four_0_0, coarseslice0winner1_of_four_0_1 : natural range 0 to 294;
  signal coarseslice0winner1_of_four_0_2, coarseslice0winner1_of_four_0_3 : natural range 0 to 294;
  signal coarseslice0winner1_of_four_0_4, coarseslice0winner1_of_four_0_5 : natural range 0 to 294;
  signal coarseslice0winner1_of_four_0_6, coarseslice0winner1_of_four_0_7 : natural range 0 to 294;
  signal coarseslice0winner1_pair_index_0_0, coarseslice0winner1_pair_tag_valid : boolean;
  signal coarseslice0winner1_pair_tag_map_column, coarseslice0winner1_pair_tag_output_column : boolean;
  signal coarseslice0winner1_pair_tag_start_of_frame, coarseslice0winner1_pair_tag_end_of_line : boolean;
  signal coarseslice0winner1_four_tag_valid, coarseslice0winner1_four_tag_map_column : boolean;
  signal coarseslice0winner1_four_tag_output_column, coarseslice0winner1_four_tag_start_of_frame : boolean;
  signal coarseslice0winner1_four_tag_end_of_line, coarseslice0winner1_tag_valid : boolean;
  signal coarseslice0winner1_tag_map_column, coarseslice0winner1_tag_output_column : boolean;
  signal coarseslice0winner1_tag_start_of_frame, coarseslice0winner1_tag_end_of_line : boolean;
  signal coarseslice0winner1_pair_index_0_1, coarseslice0winner1_four_index_0_0 : natural range 0 to 3;
  signal coarseslice0winner1_best_index_0_0 : natural range 0 to 3;
  signal coarseslice0winner1_pair_index_0_2 : natural range 0 to 5;
  signal coarseslice0winner1_pair_index_0_3, coarseslice0winner1_four_index_0_1 : natural range 0 to 7;
  signal coarseslice0winner1_best_index_0_1 : natural range 0 to 7;
  signal coarseslice0winner1_best_cost_0_0, coarseslice0winner1_best_cost_0_1 : natural range 0 to 511;
  -- coarseslice0winner2
  signal coarseslice0winner2_best_index_0_0 : natural range 0 to 7;
  signal coarseslice0winner2_tag_valid, coarseslice0winner2_tag_map_column : boolean;
  signal coarseslice0winner2_tag_output_column, coarseslice0winner2_tag_start_of_frame : boolean;
  signal coarseslice0winner2_tag_end_of_line : boolean;
  -- coarseslice0
  signal coarseslice0_best_index_0_0 : natural range 0 to 7;
  signal coarseslice0_best_tag_valid, coarseslice0_best_tag_map_column, coarseslice0_best_tag_output_column : boolean;
  signal coarseslice0_best_tag_start_of_frame, coarseslice0_best_tag_end_of_line : boolean;
  -- coarseleftright
  signal coarseleftright_other_1_0, coarseleftright_other_2_0, coarseleftright_other_3_0 : natural range 0 to 7;
  signal coarseleftright_ring_read_address, coarseleftright_ring_write_address : natural range 0 to 7;
  signal coarseleftright_asking_disparity_0, coarseleftright_answered_disparity_0 : natural range 0 to 7;
  signal coarseleftright_checked_disparity_0 : natural range 0 to 7;
  signal coarseleftright_holds_winners, coarseleftright_held_valid, coarseleftright_asking_passed_0 : boolean;
  signal coarseleftright_asking_tag_valid, coarseleftright_asking_tag_output_column : boolean;
  signal coarseleftright_asking_tag_start_of_frame, coarseleftright_answered_passed_0 : boolean;
  signal coarseleftright_answered_tag_valid, coarseleftright_answered_tag_output_column : boolean;
  signal coarseleftright_answered_tag_start_of_frame, coarseleftright_checked_passed_0 : boolean;
  signal coarseleftright_checked_tag_valid, coarseleftright_checked_tag_output_column : boolean;
  signal coarseleftright_checked_tag_start_of_frame : boolean;
  signal coarseleftright_position, coarseleftright_held_position, coarseleftright_address_0 : natural range 0 to 15;
  signal coarseleftright_held_0 : unsigned(12 downto 0);
  signal coarseleftright_found_0 : unsigned(2 downto 0);
  -- ranges
  signal ranges_column, ranges_in_column, ranges_read_column, ranges_ready_column : natural range 0 to 31;
  signal ranges_pixels_written, ranges_centre_column, ranges_counted_column : natural range 0 to 31;
  signal ranges_row, ranges_pixel_0, ranges_in_row, ranges_pixels_read_newest_0 : natural range 0 to 15;
  signal ranges_pixels_ready_newest_0, ranges_read_row, ranges_ready_row, ranges_left : natural range 0 to 15;
  signal ranges_above, ranges_middle, ranges_below, ranges_next_above, ranges_right : natural range 0 to 15;
  signal ranges_next_below, ranges_paired_column, ranges_pair_read_column : natural range 0 to 15;
  signal ranges_pair_ready_column, ranges_pairs_written : natural range 0 to 15;
  signal ranges_in_valid, ranges_read_valid, ranges_ready_valid, ranges_centre_valid, ranges_counts : boolean;
  signal ranges_counted_valid, ranges_paired_valid, ranges_pair_read_valid, ranges_pair_ready_valid : boolean;
  signal ranges_valid : boolean;
  signal ranges_pixels_read_words_0 : unsigned(7 downto 0);
  signal ranges_pixels_ready_words_0, ranges_pixels_write_words_0 : natural range 0 to 255;
  signal ranges_centre_row, ranges_counted_row, ranges_paired_row, ranges_pair_read_row : natural range 0 to 65535;
  signal ranges_pair_ready_row, ranges_block_column : natural range 0 to 65535;
  signal ranges_disparity : natural range 0 to 7;
  signal ranges_first_of_pair, ranges_pair_0, ranges_pairs_read_newest_0 : natural range 0 to 127;
  signal ranges_pairs_ready_words_0, ranges_pairs_ready_newest_0, ranges_pairs_write_words_0 : natural range 0 to 127;
  signal ranges_range : natural range 0 to 127;
  signal ranges_pairs_read_words_0 : unsigned(6 downto 0);
  signal ranges_block_row : natural range 0 to 32767;
  -- targets
  signal targets_newest_0, targets_rows_read_newest_0, targets_rows_ready_newest_0 : natural range 0 to 127;
  signal targets_column_range, targets_behind, targets_here, targets_around : natural range 0 to 127;
  signal targets_read_column, targets_walk_place, targets_walk_band, targets_read_place : natural range 0 to 7;
  signal targets_ready_place, targets_write_column, targets_read_walk_band : natural range 0 to 7;
  signal targets_ready_walk_band, targets_column_walk_band, targets_around_walk_band : natural range 0 to 7;
  signal targets_wish_walk_band : natural range 0 to 7;
  signal targets_comes, targets_last_row, targets_again, targets_walk_has_above, targets_walk_has_below : boolean;
  signal targets_walk_valid, targets_read_comes, targets_ready_comes, targets_read_walk_has_above : boolean;
  signal targets_read_walk_has_below, targets_read_walk_valid, targets_ready_walk_has_above : boolean;
  signal targets_ready_walk_has_below, targets_ready_walk_valid, targets_column_walk_valid : boolean;
  signal targets_around_walk_valid, targets_known, targets_wish_walk_valid : boolean;
  signal targets_pause, targets_walked, targets_next_band, targets_walk_column : natural range 0 to 65535;
  signal targets_read_walk_column, targets_ready_walk_column, targets_column_walk_column : natural range 0 to 65535;
  signal targets_around_walk_column, targets_wish_walk_column, targets_low : natural range 0 to 65535;
  signal targets_rows_read_words_0 : unsigned(20 downto 0);
  signal targets_rows_ready_words_0, targets_rows_write_words_0 : natural range 0 to 2097151;
  signal targets_low_wish, targets_high_wish, targets_high : natural range 0 to 30;
  signal targets_place : natural range 0 to 63;
  -- hold
  signal hold_back_ring_read_address, hold_back_ring_write_address : natural range 0 to 4095;
  signal hold_back_holds_groups, hold_back_held_is_new : boolean;
  signal hold_back_held_0 : unsigned(24 downto 0);
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 4095;
  signal transform_left_rows_ready_words_4, transform_left_rows_ready_newest_0 : natural range 0 to 4095;
  signal transform_left_rows_write_words_4, transform_right_rows_read_newest_0 : natural range 0 to 4095;
  signal transform_right_rows_ready_words_4, transform_right_rows_ready_newest_0 : natural range 0 to 4095;
  signal transform_right_rows_write_words_4, transform_left_column_0, transform_left_column_1 : natural range 0 to 4095;
  signal transform_left_column_2, transform_left_column_3, transform_left_column_4 : natural range 0 to 4095;
  signal transform_left_column_5, transform_left_column_6, transform_left_column_7 : natural range 0 to 4095;
  signal transform_left_column_8, transform_left_column_9, transform_right_column_0 : natural range 0 to 4095;
  signal transform_right_column_1, transform_right_column_2, transform_right_column_3 : natural range 0 to 4095;
  signal transform_right_column_4, transform_right_column_5, transform_right_column_6 : natural range 0 to 4095;
  signal transform_right_column_7, transform_right_column_8, transform_right_column_9 : natural range 0 to 4095;
  signal transform_left_code_column_box_0_0_0, transform_left_code_column_box_0_1_0 : natural range 0 to 4095;
  signal transform_left_code_column_box_0_2_0, transform_left_code_column_box_0_3_0 : natural range 0 to 4095;
  signal transform_left_code_column_box_0_4_0, transform_left_code_column_centre : natural range 0 to 4095;
  signal transform_right_code_column_box_0_0_0, transform_right_code_column_box_0_1_0 : natural range 0 to 4095;
  signal transform_right_code_column_box_0_2_0, transform_right_code_column_box_0_3_0 : natural range 0 to 4095;
  signal transform_right_code_column_box_0_4_0, transform_right_code_column_centre : natural range 0 to 4095;
  signal transform_valid, transform_counter_next_frame, transform_from_first_0, transform_from_first_1 : boolean;
  signal transform_up_to_last_0, transform_up_to_last_1, transform_columns_inside_0 : boolean;
  signal transform_columns_inside_1, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_inside_0, transform_filtering_0_inside_1, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_inside_0, transform_filtering_1_inside_1 : boolean;
  signal transform_filtering_1_start_of_frame, transform_filtering_1_valid, transform_filtering_2_inside_0 : boolean;
  signal transform_filtering_2_inside_1, transform_filtering_2_start_of_frame, transform_filtering_2_valid : boolean;
  signal transform_filtering_3_inside_0, transform_filtering_3_inside_1, transform_filtering_3_start_of_frame : boolean;
  signal transform_filtering_3_valid, transform_filtering_4_inside_0, transform_filtering_4_inside_1 : boolean;
  signal transform_filtering_4_start_of_frame, transform_filtering_4_valid, transform_filtering_5_inside_0 : boolean;
  signal transform_filtering_5_inside_1, transform_filtering_5_start_of_frame, transform_filtering_5_valid : boolean;
  signal transform_filtering_6_inside_0, transform_filtering_6_inside_1, transform_filtering_6_start_of_frame : boolean;
  signal transform_filtering_6_valid, transform_filtering_7_start_of_frame, transform_filtering_7_valid : boolean;
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 63;
  signal transform_ready_column, transform_write_column, transform_centre_column : natural range 0 to 63;
  signal transform_left_code_row_signs, transform_left_code_earlier_0 : natural range 0 to 63;
  signal transform_left_code_earlier_1, transform_left_code_bits : natural range 0 to 63;
  signal transform_left_code_next_row_signs, transform_left_code_next_bits : natural range 0 to 63;
  signal transform_right_code_row_signs, transform_right_code_earlier_0 : natural range 0 to 63;
  signal transform_right_code_earlier_1, transform_right_code_bits : natural range 0 to 63;
  signal transform_right_code_next_row_signs, transform_right_code_next_bits : natural range 0 to 63;
  signal transform_left_rows_read_words_0, transform_left_rows_read_words_1 : unsigned(23 downto 0);
  signal transform_left_rows_read_words_2, transform_left_rows_read_words_3 : unsigned(23 downto 0);
  signal transform_right_rows_read_words_0, transform_right_rows_read_words_1 : unsigned(23 downto 0);
  signal transform_right_rows_read_words_2, transform_right_rows_read_words_3 : unsigned(23 downto 0);
  signal transform_left_rows_read_words_4, transform_right_rows_read_words_4 : unsigned(11 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_ready_words_1 : natural range 0 to 16777215;
  signal transform_left_rows_ready_words_2, transform_left_rows_ready_words_3 : natural range 0 to 16777215;
  signal transform_left_rows_write_words_0, transform_left_rows_write_words_1 : natural range 0 to 16777215;
  signal transform_left_rows_write_words_2, transform_left_rows_write_words_3 : natural range 0 to 16777215;
  signal transform_right_rows_ready_words_0, transform_right_rows_ready_words_1 : natural range 0 to 16777215;
  signal transform_right_rows_ready_words_2, transform_right_rows_ready_words_3 : natural range 0 to 16777215;
  signal transform_right_rows_write_words_0, transform_right_rows_write_words_1 : natural range 0 to 16777215;
  signal transform_right_rows_write_words_2, transform_right_rows_write_words_3 : natural range 0 to 16777215;
  signal transform_centre_group : natural range 0 to 64;
  signal transform_left_code_column_near, transform_left_code_column_outer : natural range 0 to 8190;
  signal transform_left_code_next_column_box_0_0_0, transform_left_code_next_column_box_0_1_0 : natural range 0 to 8190;
  signal transform_left_code_next_column_box_0_2_0, transform_left_code_next_column_box_0_3_0 : natural range 0 to 8190;
  signal transform_left_code_next_column_box_0_4_0, transform_left_code_next_column_centre : natural range 0 to 8190;
  signal transform_right_code_column_near, transform_right_code_column_outer : natural range 0 to 8190;
  signal transform_right_code_next_column_box_0_0_0 : natural range 0 to 8190;
  signal transform_right_code_next_column_box_0_1_0 : natural range 0 to 8190;
  signal transform_right_code_next_column_box_0_2_0 : natural range 0 to 8190;
  signal transform_right_code_next_column_box_0_3_0 : natural range 0 to 8190;
  signal transform_right_code_next_column_box_0_4_0, transform_right_code_next_column_centre : natural range 0 to 8190;
  signal transform_left_code_column_upper, transform_left_code_column_lower : natural range 0 to 12285;
  signal transform_right_code_column_upper, transform_right_code_column_lower : natural range 0 to 12285;
  signal transform_left_code_column_response_0, transform_left_code_column_response_1 : natural range 0 to 16381;
  signal transform_left_code_row_box_0_0, transform_left_code_row_box_0_1 : natural range 0 to 16381;
  signal transform_left_code_row_column_0_0, transform_left_code_row_column_0_1 : natural range 0 to 16381;
  signal transform_left_code_row_column_0_2, transform_left_code_row_column_0_3 : natural range 0 to 16381;
  signal transform_left_code_row_column_1_0, transform_left_code_row_column_1_1 : natural range 0 to 16381;
  signal transform_left_code_row_column_1_2, transform_left_code_row_column_1_3 : natural range 0 to 16381;
  signal transform_left_code_row_centre_0, transform_left_code_row_centre_1 : natural range 0 to 16381;
  signal transform_right_code_column_response_0, transform_right_code_column_response_1 : natural range 0 to 16381;
  signal transform_right_code_row_box_0_0, transform_right_code_row_box_0_1 : natural range 0 to 16381;
  signal transform_right_code_row_column_0_0, transform_right_code_row_column_0_1 : natural range 0 to 16381;
  signal transform_right_code_row_column_0_2, transform_right_code_row_column_0_3 : natural range 0 to 16381;
  signal transform_right_code_row_column_1_0, transform_right_code_row_column_1_1 : natural range 0 to 16381;
  signal transform_right_code_row_column_1_2, transform_right_code_row_column_1_3 : natural range 0 to 16381;
  signal transform_right_code_row_centre_0, transform_right_code_row_centre_1 : natural range 0 to 16381;
  signal transform_left_code_column_response_2, transform_left_code_row_box_0_2 : natural range 0 to 24570;
  signal transform_left_code_row_column_2_0, transform_left_code_row_column_2_1 : natural range 0 to 24570;
  signal transform_left_code_row_column_2_2, transform_left_code_row_column_2_3 : natural range 0 to 24570;
  signal transform_left_code_row_centre_2, transform_right_code_column_response_2 : natural range 0 to 24570;
  signal transform_right_code_row_box_0_2, transform_right_code_row_column_2_0 : natural range 0 to 24570;
  signal transform_right_code_row_column_2_1, transform_right_code_row_column_2_2 : natural range 0 to 24570;
  signal transform_right_code_row_column_2_3, transform_right_code_row_centre_2 : natural range 0 to 24570;
  signal transform_left_code_row_outer_1, transform_right_code_row_outer_1 : natural range 0 to 32762;
  signal transform_left_code_row_outer_2, transform_right_code_row_outer_2 : natural range 0 to 49140;
  signal transform_left_code_row_before_0, transform_left_code_row_before_1 : natural range 0 to 49143;
  signal transform_left_code_row_after_0, transform_left_code_row_after_1 : natural range 0 to 49143;
  signal transform_right_code_row_before_0, transform_right_code_row_before_1 : natural range 0 to 49143;
  signal transform_right_code_row_after_0, transform_right_code_row_after_1 : natural range 0 to 49143;
  signal transform_left_code_row_before_2, transform_left_code_row_after_2 : natural range 0 to 73711;
  signal transform_right_code_row_before_2, transform_right_code_row_after_2 : natural range 0 to 73711;
  signal transform_left_code_row_even_1, transform_left_code_row_even_2 : natural range 0 to 262143;
  signal transform_left_code_row_odd_1, transform_left_code_row_odd_2 : natural range 0 to 262143;
  signal transform_right_code_row_even_1, transform_right_code_row_even_2 : natural range 0 to 262143;
  signal transform_right_code_row_odd_1, transform_right_code_row_odd_2 : natural range 0 to 262143;
  signal transform_left_code_next_column_near, transform_left_code_next_column_outer : natural range 0 to 16380;
  signal transform_right_code_next_column_near, transform_right_code_next_column_outer : natural range 0 to 16380;
  signal transform_left_code_next_column_upper, transform_left_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_earlier_0_2_0, transform_right_code_next_column_upper : natural range 0 to 65535;
  signal transform_right_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_earlier_0_2_0 : natural range 0 to 65535;
  signal transform_left_code_next_column_lower, transform_right_code_next_column_lower : natural range 0 to 24571;
  signal transform_left_code_next_column_response_0 : natural range 0 to 32761;
  signal transform_left_code_next_column_response_1 : natural range 0 to 32761;
  signal transform_left_code_next_row_earlier_0_0_0 : natural range 0 to 32761;
  signal transform_left_code_next_row_earlier_0_1_0 : natural range 0 to 32761;
  signal transform_right_code_next_column_response_0 : natural range 0 to 32761;
  signal transform_right_code_next_column_response_1 : natural range 0 to 32761;
  signal transform_right_code_next_row_earlier_0_0_0 : natural range 0 to 32761;
  signal transform_right_code_next_row_earlier_0_1_0 : natural range 0 to 32761;
  signal transform_left_code_next_row_box_0_0, transform_left_code_next_row_box_0_1 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_0_0, transform_left_code_next_row_column_0_1 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_0_2, transform_left_code_next_row_column_0_3 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_0_4, transform_left_code_next_row_column_0_5 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_0_6, transform_left_code_next_row_column_0_7 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_1_0, transform_left_code_next_row_column_1_1 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_1_2, transform_left_code_next_row_column_1_3 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_1_4, transform_left_code_next_row_column_1_5 : natural range 0 to 65522;
  signal transform_left_code_next_row_column_1_6, transform_left_code_next_row_column_1_7 : natural range 0 to 65522;
  signal transform_left_code_next_row_centre_0, transform_left_code_next_row_centre_1 : natural range 0 to 65522;
  signal transform_right_code_next_row_box_0_0, transform_right_code_next_row_box_0_1 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_0_0, transform_right_code_next_row_column_0_1 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_0_2, transform_right_code_next_row_column_0_3 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_0_4, transform_right_code_next_row_column_0_5 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_0_6, transform_right_code_next_row_column_0_7 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_1_0, transform_right_code_next_row_column_1_1 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_1_2, transform_right_code_next_row_column_1_3 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_1_4, transform_right_code_next_row_column_1_5 : natural range 0 to 65522;
  signal transform_right_code_next_row_column_1_6, transform_right_code_next_row_column_1_7 : natural range 0 to 65522;
  signal transform_right_code_next_row_centre_0, transform_right_code_next_row_centre_1 : natural range 0 to 65522;
  signal transform_left_code_next_row_box_0_2, transform_left_code_next_row_column_2_0 : natural range 0 to 131070;
  signal transform_left_code_next_row_column_2_1, transform_left_code_next_row_column_2_2 : natural range 0 to 131070;
  signal transform_left_code_next_row_column_2_3, transform_left_code_next_row_column_2_4 : natural range 0 to 131070;
  signal transform_left_code_next_row_column_2_5, transform_left_code_next_row_column_2_6 : natural range 0 to 131070;
  signal transform_left_code_next_row_column_2_7, transform_left_code_next_row_centre_2 : natural range 0 to 131070;
  signal transform_right_code_next_row_box_0_2, transform_right_code_next_row_column_2_0 : natural range 0 to 131070;
  signal transform_right_code_next_row_column_2_1, transform_right_code_next_row_column_2_2 : natural range 0 to 131070;
  signal transform_right_code_next_row_column_2_3, transform_right_code_next_row_column_2_4 : natural range 0 to 131070;
  signal transform_right_code_next_row_column_2_5, transform_right_code_next_row_column_2_6 : natural range 0 to 131070;
  signal transform_right_code_next_row_column_2_7, transform_right_code_next_row_centre_2 : natural range 0 to 131070;
  signal transform_left_code_next_row_outer_1, transform_right_code_next_row_outer_1 : natural range 0 to 131044;
  signal transform_left_code_next_row_outer_2, transform_right_code_next_row_outer_2 : natural range 0 to 262140;
  signal transform_left_code_next_row_before_0, transform_left_code_next_row_before_1 : natural range 0 to 196567;
  signal transform_left_code_next_row_after_0, transform_left_code_next_row_after_1 : natural range 0 to 196567;
  signal transform_right_code_next_row_before_0, transform_right_code_next_row_before_1 : natural range 0 to 196567;
  signal transform_right_code_next_row_after_0, transform_right_code_next_row_after_1 : natural range 0 to 196567;
  signal transform_left_code_next_row_before_2, transform_left_code_next_row_after_2 : natural range 0 to 393211;
  signal transform_right_code_next_row_before_2, transform_right_code_next_row_after_2 : natural range 0 to 393211;
  signal transform_left_code_next_row_even_1, transform_left_code_next_row_even_2 : natural range 0 to 1048575;
  signal transform_left_code_next_row_odd_1, transform_left_code_next_row_odd_2 : natural range 0 to 1048575;
  signal transform_right_code_next_row_even_1, transform_right_code_next_row_even_2 : natural range 0 to 1048575;
  signal transform_right_code_next_row_odd_1, transform_right_code_next_row_odd_2 : natural range 0 to 1048575;
  -- ahead
  signal ahead_ring_read_address, ahead_ring_write_address : natural range 0 to 31;
  signal ahead_holds_groups, ahead_held_is_new, ahead_held_valid : boolean;
  signal ahead_held_0 : unsigned(12 downto 0);
  -- raster
  signal raster_features_reference_0 : natural range 0 to 4095;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 63;
  -- bases
  signal bases_address_0, bases_address_1, bases_address_2, bases_asked_column : natural range 0 to 63;
  signal bases_asked_limit, bases_read_column, bases_read_limit, bases_ready_column : natural range 0 to 63;
  signal bases_ready_limit, bases_wanted_column, bases_stands_column : natural range 0 to 63;
  signal bases_asked_head, bases_asked_frame_starts, bases_asked_valid, bases_read_head : boolean;
  signal bases_read_frame_starts, bases_read_valid, bases_ready_head, bases_ready_frame_starts : boolean;
  signal bases_ready_valid, bases_wanted_head, bases_wanted_frame_starts, bases_wanted_valid, bases_rises_0_0 : boolean;
  signal bases_rises_0_1, bases_rises_1_0, bases_rises_1_1, bases_falls_0_0, bases_falls_0_1, bases_falls_1_0 : boolean;
  signal bases_falls_1_1, bases_stands_frame_starts, bases_stands_valid : boolean;
  signal bases_read_targets_0, bases_read_targets_1, bases_read_targets_2 : unsigned(15 downto 0);
  signal bases_ready_targets_0, bases_ready_targets_1, bases_ready_targets_2, bases_base_0_0 : natural range 0 to 65535;
  signal bases_base_0_1, bases_base_0_2, bases_base_1_0, bases_base_1_1, bases_base_1_2 : natural range 0 to 65535;
  signal bases_from_0_2 : natural range 0 to 65535;
  signal bases_goal_0_0, bases_goal_0_1, bases_goal_0_2 : natural range 0 to 254;
  signal bases_goal_1_0, bases_goal_1_1, bases_goal_1_2 : natural range 0 to 255;
  signal bases_from_0_0, bases_from_0_1, bases_from_1_0, bases_from_1_1 : natural range 0 to 511;
  -- rows
  signal rows_last_1, rows_last_2, rows_last_3, rows_write_codes_0, rows_write_codes_1 : natural range 0 to 4095;
  signal rows_write_codes_2, rows_write_codes_3, rows_ready_codes_0, rows_ready_codes_1 : natural range 0 to 4095;
  signal rows_ready_codes_2, rows_ready_codes_3, rows_ready_codes_4, rows_ready_codes_5 : natural range 0 to 4095;
  signal rows_ready_codes_6, rows_ready_codes_7, rows_ready_codes_8, rows_ready_codes_9 : natural range 0 to 4095;
  signal rows_ready_codes_10, rows_ready_codes_11, rows_ready_codes_12, rows_ready_codes_13 : natural range 0 to 4095;
  signal rows_ready_codes_14, rows_ready_codes_15, rows_codes_0_0_0, rows_codes_0_0_1 : natural range 0 to 4095;
  signal rows_codes_0_0_2, rows_codes_0_0_3, rows_codes_0_1_0, rows_codes_0_1_1 : natural range 0 to 4095;
  signal rows_codes_0_1_2, rows_codes_0_1_3, rows_codes_1_0_0, rows_codes_1_0_1 : natural range 0 to 4095;
  signal rows_codes_1_0_2, rows_codes_1_0_3, rows_codes_1_1_0, rows_codes_1_1_1 : natural range 0 to 4095;
  signal rows_codes_1_1_2, rows_codes_1_1_3 : natural range 0 to 4095;
  signal rows_newest_column, rows_newest_row, rows_enter_row, rows_leave_row : natural range 0 to 65535;
  signal rows_write_word, rows_address_0, rows_address_1, rows_address_2, rows_address_3 : natural range 0 to 127;
  signal rows_address_4, rows_address_5, rows_address_6, rows_address_7, rows_address_8 : natural range 0 to 127;
  signal rows_address_9, rows_address_10, rows_address_11, rows_address_12, rows_address_13 : natural range 0 to 127;
  signal rows_address_14, rows_address_15 : natural range 0 to 127;
  signal rows_position_0_0, rows_position_0_1, rows_position_1_0, rows_position_1_1 : natural range 0 to 511;
  signal rows_wanted_first_bank_0_0, rows_wanted_first_bank_0_1, rows_wanted_first_bank_1_0 : natural range 0 to 3;
  signal rows_wanted_first_bank_1_1, rows_asked_first_bank_0_0, rows_asked_first_bank_0_1 : natural range 0 to 3;
  signal rows_asked_first_bank_1_0, rows_asked_first_bank_1_1, rows_read_first_bank_0_0 : natural range 0 to 3;
  signal rows_read_first_bank_0_1, rows_read_first_bank_1_0, rows_read_first_bank_1_1 : natural range 0 to 3;
  signal rows_ready_first_bank_0_0, rows_ready_first_bank_0_1, rows_ready_first_bank_1_0 : natural range 0 to 3;
  signal rows_ready_first_bank_1_1 : natural range 0 to 3;
  signal rows_wanted_one_0_0, rows_wanted_one_0_1, rows_wanted_one_1_0, rows_wanted_one_1_1 : boolean;
  signal rows_wanted_four_0_0, rows_wanted_four_0_1, rows_wanted_four_1_0, rows_wanted_four_1_1 : boolean;
  signal rows_asked_one_0_0, rows_asked_one_0_1, rows_asked_one_1_0, rows_asked_one_1_1, rows_asked_four_0_0 : boolean;
  signal rows_asked_four_0_1, rows_asked_four_1_0, rows_asked_four_1_1, rows_read_one_0_0, rows_read_one_0_1 : boolean;
  signal rows_read_one_1_0, rows_read_one_1_1, rows_read_four_0_0, rows_read_four_0_1, rows_read_four_1_0 : boolean;
  signal rows_read_four_1_1, rows_ready_one_0_0, rows_ready_one_0_1, rows_ready_one_1_0, rows_ready_one_1_1 : boolean;
  signal rows_ready_four_0_0, rows_ready_four_0_1, rows_ready_four_1_0, rows_ready_four_1_1 : boolean;
  signal rows_step_one_0_0, rows_step_one_0_1, rows_step_one_1_0, rows_step_one_1_1, rows_step_four_0_0 : boolean;
  signal rows_step_four_0_1, rows_step_four_1_0, rows_step_four_1_1 : boolean;
  signal rows_read_codes_0, rows_read_codes_1, rows_read_codes_2, rows_read_codes_3 : unsigned(11 downto 0);
  signal rows_read_codes_4, rows_read_codes_5, rows_read_codes_6, rows_read_codes_7 : unsigned(11 downto 0);
  signal rows_read_codes_8, rows_read_codes_9, rows_read_codes_10, rows_read_codes_11 : unsigned(11 downto 0);
  signal rows_read_codes_12, rows_read_codes_13, rows_read_codes_14, rows_read_codes_15 : unsigned(11 downto 0);
  -- pairs
  signal pairs_ring_read_address, pairs_ring_write_address : natural range 0 to 15;
  signal pairs_delayed_0 : unsigned(11 downto 0);
  signal pairs_row_inside_0, pairs_row_inside_1, pairs_tag_row_start, pairs_tag_first_group : boolean;
  signal pairs_tag_border_column, pairs_tag_first_cost, pairs_tag_leaves_window, pairs_tag_output_column : boolean;
  signal pairs_tag_start_of_frame, pairs_tag_end_of_line : boolean;
  -- compared
  signal compared_rows_read_words_0, compared_rows_read_words_1 : unsigned(23 downto 0);
  signal compared_rows_read_words_2 : unsigned(11 downto 0);
  signal compared_rows_read_newest_0, compared_rows_ready_words_2 : natural range 0 to 4095;
  signal compared_rows_ready_newest_0, compared_rows_write_words_2 : natural range 0 to 4095;
  signal compared_held_0_reference_0, compared_held_0_reference_1 : natural range 0 to 4095;
  signal compared_held_1_reference_0, compared_held_1_reference_1 : natural range 0 to 4095;
  signal compared_held_2_reference_0, compared_held_2_reference_1 : natural range 0 to 4095;
  signal compared_held_3_reference_0, compared_held_3_reference_1 : natural range 0 to 4095;
  signal compared_held_4_reference_0, compared_held_4_reference_1 : natural range 0 to 4095;
  signal compared_held_5_reference_0, compared_held_5_reference_1 : natural range 0 to 4095;
  signal compared_held_6_reference_0, compared_held_6_reference_1 : natural range 0 to 4095;
  signal compared_held_7_reference_0, compared_held_7_reference_1 : natural range 0 to 4095;
  signal compared_rows_ready_words_0, compared_rows_ready_words_1 : natural range 0 to 16777215;
  signal compared_rows_write_words_0, compared_rows_write_words_1 : natural range 0 to 16777215;
  signal compared_read_inside_0, compared_read_inside_1, compared_read_tag_row_start : boolean;
  signal compared_read_tag_first_group, compared_read_tag_border_column, compared_read_tag_first_cost : boolean;
  signal compared_read_tag_leaves_window, compared_read_tag_output_column, compared_read_tag_start_of_frame : boolean;
  signal compared_read_tag_end_of_line, compared_ready_inside_0, compared_ready_inside_1 : boolean;
  signal compared_ready_tag_row_start, compared_ready_tag_first_group, compared_ready_tag_border_column : boolean;
  signal compared_ready_tag_first_cost, compared_ready_tag_leaves_window, compared_ready_tag_output_column : boolean;
  signal compared_ready_tag_start_of_frame, compared_ready_tag_end_of_line, compared_held_0_inside_0 : boolean;
  signal compared_held_0_inside_1, compared_held_1_inside_0, compared_held_1_inside_1 : boolean;
  signal compared_held_2_inside_0, compared_held_2_inside_1, compared_held_3_inside_0 : boolean;
  signal compared_held_3_inside_1, compared_held_4_inside_0, compared_held_4_inside_1 : boolean;
  signal compared_held_5_inside_0, compared_held_5_inside_1, compared_held_6_inside_0 : boolean;
  signal compared_held_6_inside_1, compared_held_7_inside_0, compared_held_7_inside_1 : boolean;
  signal compared_tags_0_row_start, compared_tags_0_first_group, compared_tags_0_border_column : boolean;
  signal compared_tags_0_first_cost, compared_tags_0_leaves_window, compared_tags_0_output_column : boolean;
  signal compared_tags_0_start_of_frame, compared_tags_0_end_of_line, compared_tags_1_row_start : boolean;
  signal compared_tags_1_first_group, compared_tags_1_border_column, compared_tags_1_first_cost : boolean;
  signal compared_tags_1_leaves_window, compared_tags_1_output_column, compared_tags_1_start_of_frame : boolean;
  signal compared_tags_1_end_of_line, compared_tags_2_valid, compared_tags_2_row_start : boolean;
  signal compared_tags_2_first_group, compared_tags_2_border_column, compared_tags_2_first_cost : boolean;
  signal compared_tags_2_leaves_window, compared_tags_2_output_column, compared_tags_2_start_of_frame : boolean;
  signal compared_tags_2_end_of_line, compared_tags_3_valid, compared_tags_3_row_start : boolean;
  signal compared_tags_3_first_group, compared_tags_3_border_column, compared_tags_3_first_cost : boolean;
  signal compared_tags_3_leaves_window, compared_tags_3_output_column, compared_tags_3_start_of_frame : boolean;
  signal compared_tags_3_end_of_line, compared_tags_4_valid, compared_tags_4_row_start : boolean;
  signal compared_tags_4_first_group, compared_tags_4_border_column, compared_tags_4_first_cost : boolean;
  signal compared_tags_4_leaves_window, compared_tags_4_output_column, compared_tags_4_start_of_frame : boolean;
  signal compared_tags_4_end_of_line, compared_tags_5_valid, compared_tags_5_row_start : boolean;
  signal compared_tags_5_first_group, compared_tags_5_border_column, compared_tags_5_first_cost : boolean;
  signal compared_tags_5_leaves_window, compared_tags_5_output_column, compared_tags_5_start_of_frame : boolean;
  signal compared_tags_5_end_of_line, compared_tags_6_valid, compared_tags_6_row_start : boolean;
  signal compared_tags_6_first_group, compared_tags_6_border_column, compared_tags_6_first_cost : boolean;
  signal compared_tags_6_leaves_window, compared_tags_6_output_column, compared_tags_6_start_of_frame : boolean;
  signal compared_tags_6_end_of_line, compared_tags_7_valid, compared_tags_7_row_start : boolean;
  signal compared_tags_7_first_group, compared_tags_7_border_column, compared_tags_7_first_cost : boolean;
  signal compared_tags_7_leaves_window, compared_tags_7_output_column, compared_tags_7_start_of_frame : boolean;
  signal compared_tags_7_end_of_line : boolean;
  signal compared_write_column : natural range 0 to 63;
  -- lowchain
  signal lowchain_lane_0_0, lowchain_lane_0_1, lowchain_lane_0_2, lowchain_lane_0_3 : natural range 0 to 4095;
  signal lowchain_lane_0_4, lowchain_lane_0_5, lowchain_lane_0_6, lowchain_lane_0_7 : natural range 0 to 4095;
  signal lowchain_lane_0_8, lowchain_lane_0_9, lowchain_lane_0_10, lowchain_lane_0_11 : natural range 0 to 4095;
  signal lowchain_lane_0_12, lowchain_lane_0_13, lowchain_lane_0_14, lowchain_lane_0_15 : natural range 0 to 4095;
  signal lowchain_lane_1_0, lowchain_lane_1_1, lowchain_lane_1_2, lowchain_lane_1_3 : natural range 0 to 4095;
  signal lowchain_lane_1_4, lowchain_lane_1_5, lowchain_lane_1_6, lowchain_lane_1_7 : natural range 0 to 4095;
  signal lowchain_lane_1_8, lowchain_lane_1_9, lowchain_lane_1_10, lowchain_lane_1_11 : natural range 0 to 4095;
  signal lowchain_lane_1_12, lowchain_lane_1_13, lowchain_lane_1_14, lowchain_lane_1_15 : natural range 0 to 4095;
  -- lowcost
  signal lowcost_pixels_first_0_0, lowcost_pixels_first_0_1, lowcost_pixels_first_0_2 : natural range 0 to 255;
  signal lowcost_pixels_first_0_3, lowcost_pixels_first_0_4, lowcost_pixels_first_0_5 : natural range 0 to 255;
  signal lowcost_pixels_first_0_6, lowcost_pixels_first_0_7, lowcost_pixels_first_0_8 : natural range 0 to 255;
  signal lowcost_pixels_first_0_9, lowcost_pixels_first_0_10, lowcost_pixels_first_0_11 : natural range 0 to 255;
  signal lowcost_pixels_first_0_12, lowcost_pixels_first_0_13, lowcost_pixels_first_0_14 : natural range 0 to 255;
  signal lowcost_pixels_first_0_15, lowcost_pixels_first_1_0, lowcost_pixels_first_1_1 : natural range 0 to 255;
  signal lowcost_pixels_first_1_2, lowcost_pixels_first_1_3, lowcost_pixels_first_1_4 : natural range 0 to 255;
  signal lowcost_pixels_first_1_5, lowcost_pixels_first_1_6, lowcost_pixels_first_1_7 : natural range 0 to 255;
  signal lowcost_pixels_first_1_8, lowcost_pixels_first_1_9, lowcost_pixels_first_1_10 : natural range 0 to 255;
  signal lowcost_pixels_first_1_11, lowcost_pixels_first_1_12, lowcost_pixels_first_1_13 : natural range 0 to 255;
  signal lowcost_pixels_first_1_14, lowcost_pixels_first_1_15 : natural range 0 to 255;
  signal lowcost_pixels_first_tag_valid, lowcost_pixels_first_tag_first_group : boolean;
  signal lowcost_pixels_first_tag_border_column, lowcost_pixels_first_tag_first_cost : boolean;
  signal lowcost_pixels_first_tag_leaves_window, lowcost_pixels_first_tag_output_column : boolean;
  signal lowcost_pixels_first_tag_start_of_frame, lowcost_pixels_first_tag_end_of_line : boolean;
  signal lowcost_pixels_tag_valid, lowcost_pixels_tag_first_group, lowcost_pixels_tag_border_column : boolean;
  signal lowcost_pixels_tag_first_cost, lowcost_pixels_tag_leaves_window, lowcost_pixels_tag_output_column : boolean;
  signal lowcost_pixels_tag_start_of_frame, lowcost_pixels_tag_end_of_line, lowcost_ready_tag_valid : boolean;
  signal lowcost_ready_tag_first_group, lowcost_ready_tag_border_column, lowcost_ready_tag_first_cost : boolean;
  signal lowcost_ready_tag_leaves_window, lowcost_ready_tag_output_column, lowcost_ready_tag_start_of_frame : boolean;
  signal lowcost_ready_tag_end_of_line, lowcost_tag_valid, lowcost_tag_first_cost, lowcost_tag_leaves_window : boolean;
  signal lowcost_tag_output_column, lowcost_tag_start_of_frame, lowcost_tag_end_of_line : boolean;
  signal lowcost_pixels_cost_0_0, lowcost_pixels_cost_0_1, lowcost_pixels_cost_0_2 : natural range 0 to 19;
  signal lowcost_pixels_cost_0_3, lowcost_pixels_cost_0_4, lowcost_pixels_cost_0_5 : natural range 0 to 19;
  signal lowcost_pixels_cost_0_6, lowcost_pixels_cost_0_7, lowcost_pixels_cost_0_8 : natural range 0 to 19;
  signal lowcost_pixels_cost_0_9, lowcost_pixels_cost_0_10, lowcost_pixels_cost_0_11 : natural range 0 to 19;
  signal lowcost_pixels_cost_0_12, lowcost_pixels_cost_0_13, lowcost_pixels_cost_0_14 : natural range 0 to 19;
  signal lowcost_pixels_cost_0_15, lowcost_pixels_cost_1_0, lowcost_pixels_cost_1_1 : natural range 0 to 19;
  signal lowcost_pixels_cost_1_2, lowcost_pixels_cost_1_3, lowcost_pixels_cost_1_4 : natural range 0 to 19;
  signal lowcost_pixels_cost_1_5, lowcost_pixels_cost_1_6, lowcost_pixels_cost_1_7 : natural range 0 to 19;
  signal lowcost_pixels_cost_1_8, lowcost_pixels_cost_1_9, lowcost_pixels_cost_1_10 : natural range 0 to 19;
  signal lowcost_pixels_cost_1_11, lowcost_pixels_cost_1_12, lowcost_pixels_cost_1_13 : natural range 0 to 19;
  signal lowcost_pixels_cost_1_14, lowcost_pixels_cost_1_15 : natural range 0 to 19;
  signal lowcost_read_column, lowcost_change_column, lowcost_ready_column, lowcost_write_column : natural range 0 to 63;
  signal lowcost_read_words_0, lowcost_read_words_1, lowcost_read_words_2, lowcost_read_words_3 : unsigned(27 downto 0);
  signal lowcost_change_0_0, lowcost_change_0_1, lowcost_change_0_2, lowcost_change_0_3 : integer range -19 to 19;
  signal lowcost_change_0_4, lowcost_change_0_5, lowcost_change_0_6, lowcost_change_0_7 : integer range -19 to 19;
  signal lowcost_change_0_8, lowcost_change_0_9, lowcost_change_0_10, lowcost_change_0_11 : integer range -19 to 19;
  signal lowcost_change_0_12, lowcost_change_0_13, lowcost_change_0_14, lowcost_change_0_15 : integer range -19 to 19;
  signal lowcost_ready_words_0, lowcost_ready_words_1, lowcost_ready_words_2 : natural range 0 to 268435455;
  signal lowcost_ready_words_3, lowcost_write_words_0, lowcost_write_words_1 : natural range 0 to 268435455;
  signal lowcost_write_words_2, lowcost_write_words_3 : natural range 0 to 268435455;
  signal lowcost_column_0_0, lowcost_column_0_1, lowcost_column_0_2, lowcost_column_0_3 : natural range 0 to 127;
  signal lowcost_column_0_4, lowcost_column_0_5, lowcost_column_0_6, lowcost_column_0_7 : natural range 0 to 127;
  signal lowcost_column_0_8, lowcost_column_0_9, lowcost_column_0_10, lowcost_column_0_11 : natural range 0 to 127;
  signal lowcost_column_0_12, lowcost_column_0_13, lowcost_column_0_14, lowcost_column_0_15 : natural range 0 to 127;
  -- lowwindow
  signal lowwindow_ring_read_address, lowwindow_ring_write_address : natural range 0 to 7;
  signal lowwindow_leaving_0, lowwindow_leaving_1, lowwindow_leaving_2, lowwindow_leaving_3 : unsigned(27 downto 0);
  signal lowwindow_entering_0_0, lowwindow_entering_0_1, lowwindow_entering_0_2 : natural range 0 to 127;
  signal lowwindow_entering_0_3, lowwindow_entering_0_4, lowwindow_entering_0_5 : natural range 0 to 127;
  signal lowwindow_entering_0_6, lowwindow_entering_0_7, lowwindow_entering_0_8 : natural range 0 to 127;
  signal lowwindow_entering_0_9, lowwindow_entering_0_10, lowwindow_entering_0_11 : natural range 0 to 127;
  signal lowwindow_entering_0_12, lowwindow_entering_0_13, lowwindow_entering_0_14 : natural range 0 to 127;
  signal lowwindow_entering_0_15 : natural range 0 to 127;
  signal lowwindow_entering_tag_valid, lowwindow_entering_tag_first_cost : boolean;
  signal lowwindow_entering_tag_leaves_window, lowwindow_entering_tag_output_column : boolean;
  signal lowwindow_entering_tag_start_of_frame, lowwindow_entering_tag_end_of_line : boolean;
  signal lowwindow_change_tag_valid, lowwindow_change_tag_first_cost, lowwindow_change_tag_output_column : boolean;
  signal lowwindow_change_tag_start_of_frame, lowwindow_change_tag_end_of_line : boolean;
  signal lowwindow_centre_output_column_0, lowwindow_centre_output_column_1 : boolean;
  signal lowwindow_centre_start_of_frame_0, lowwindow_centre_start_of_frame_1, lowwindow_centre_end_of_line_0 : boolean;
  signal lowwindow_centre_end_of_line_1, lowwindow_tag_valid, lowwindow_tag_output_column : boolean;
  signal lowwindow_tag_start_of_frame, lowwindow_tag_end_of_line : boolean;
  signal lowwindow_change_0_0, lowwindow_change_0_1, lowwindow_change_0_2 : integer range -127 to 127;
  signal lowwindow_change_0_3, lowwindow_change_0_4, lowwindow_change_0_5 : integer range -127 to 127;
  signal lowwindow_change_0_6, lowwindow_change_0_7, lowwindow_change_0_8 : integer range -127 to 127;
  signal lowwindow_change_0_9, lowwindow_change_0_10, lowwindow_change_0_11 : integer range -127 to 127;
  signal lowwindow_change_0_12, lowwindow_change_0_13, lowwindow_change_0_14 : integer range -127 to 127;
  signal lowwindow_change_0_15 : integer range -127 to 127;
  signal lowwindow_sum_0_0, lowwindow_sum_0_1, lowwindow_sum_0_2, lowwindow_sum_0_3 : natural range 0 to 511;
  signal lowwindow_sum_0_4, lowwindow_sum_0_5, lowwindow_sum_0_6, lowwindow_sum_0_7 : natural range 0 to 511;
  signal lowwindow_sum_0_8, lowwindow_sum_0_9, lowwindow_sum_0_10, lowwindow_sum_0_11 : natural range 0 to 511;
  signal lowwindow_sum_0_12, lowwindow_sum_0_13, lowwindow_sum_0_14, lowwindow_sum_0_15 : natural range 0 to 511;
  -- lowwinner1
  signal lowwinner1_of_pair_0_0, lowwinner1_of_pair_0_1, lowwinner1_of_pair_0_2 : natural range 0 to 511;
  signal lowwinner1_of_pair_0_3, lowwinner1_of_pair_0_4, lowwinner1_of_pair_0_5 : natural range 0 to 511;
  signal lowwinner1_of_pair_0_6, lowwinner1_of_pair_0_7, lowwinner1_of_pair_0_8 : natural range 0 to 511;
  signal lowwinner1_of_pair_0_9, lowwinner1_of_pair_0_10, lowwinner1_of_pair_0_11 : natural range 0 to 511;
  signal lowwinner1_of_pair_0_12, lowwinner1_of_pair_0_13, lowwinner1_of_pair_0_14 : natural range 0 to 511;
  signal lowwinner1_of_pair_0_15, lowwinner1_of_four_0_0, lowwinner1_of_four_0_1 : natural range 0 to 511;
  signal lowwinner1_of_four_0_2, lowwinner1_of_four_0_3, lowwinner1_of_four_0_4 : natural range 0 to 511;
  signal lowwinner1_of_four_0_5, lowwinner1_of_four_0_6, lowwinner1_of_four_0_7 : natural range 0 to 511;
  signal lowwinner1_of_four_0_8, lowwinner1_of_four_0_9, lowwinner1_of_four_0_10 : natural range 0 to 511;
  signal lowwinner1_of_four_0_11, lowwinner1_of_four_0_12, lowwinner1_of_four_0_13 : natural range 0 to 511;
  signal lowwinner1_of_four_0_14, lowwinner1_of_four_0_15, lowwinner1_best_cost_0_0 : natural range 0 to 511;
  signal lowwinner1_best_cost_0_1, lowwinner1_best_cost_0_2, lowwinner1_best_cost_0_3 : natural range 0 to 511;
  signal lowwinner1_pair_index_0_0, lowwinner1_pair_tag_valid, lowwinner1_pair_tag_output_column : boolean;
  signal lowwinner1_pair_tag_start_of_frame, lowwinner1_pair_tag_end_of_line, lowwinner1_four_tag_valid : boolean;
  signal lowwinner1_four_tag_output_column, lowwinner1_four_tag_start_of_frame : boolean;
  signal lowwinner1_four_tag_end_of_line, lowwinner1_tag_valid, lowwinner1_tag_output_column : boolean;
  signal lowwinner1_tag_start_of_frame, lowwinner1_tag_end_of_line : boolean;
  signal lowwinner1_pair_index_0_1, lowwinner1_four_index_0_0, lowwinner1_best_index_0_0 : natural range 0 to 3;
  signal lowwinner1_pair_index_0_2 : natural range 0 to 5;
  signal lowwinner1_pair_index_0_3, lowwinner1_four_index_0_1, lowwinner1_best_index_0_1 : natural range 0 to 7;
  signal lowwinner1_pair_index_0_4 : natural range 0 to 9;
  signal lowwinner1_pair_index_0_5, lowwinner1_four_index_0_2, lowwinner1_best_index_0_2 : natural range 0 to 11;
  signal lowwinner1_pair_index_0_6 : natural range 0 to 13;
  signal lowwinner1_pair_index_0_7, lowwinner1_four_index_0_3, lowwinner1_best_index_0_3 : natural range 0 to 15;
  -- lowwinner2
  signal lowwinner2_of_pair_0_0, lowwinner2_of_pair_0_1, lowwinner2_of_pair_0_2 : natural range 0 to 511;
  signal lowwinner2_of_pair_0_3, lowwinner2_of_four_0_0, lowwinner2_of_four_0_1 : natural range 0 to 511;
  signal lowwinner2_of_four_0_2, lowwinner2_of_four_0_3, lowwinner2_best_cost_0_0 : natural range 0 to 511;
  signal lowwinner2_pair_index_0_0 : natural range 0 to 7;
  signal lowwinner2_pair_index_0_1, lowwinner2_four_index_0_0, lowwinner2_best_index_0_0 : natural range 0 to 15;
  signal lowwinner2_pair_tag_valid, lowwinner2_pair_tag_output_column, lowwinner2_pair_tag_start_of_frame : boolean;
  signal lowwinner2_pair_tag_end_of_line, lowwinner2_four_tag_valid, lowwinner2_four_tag_output_column : boolean;
  signal lowwinner2_four_tag_start_of_frame, lowwinner2_four_tag_end_of_line, lowwinner2_tag_valid : boolean;
  signal lowwinner2_tag_output_column, lowwinner2_tag_start_of_frame, lowwinner2_tag_end_of_line : boolean;
  -- highchain
  signal highchain_lane_0_0, highchain_lane_0_1, highchain_lane_0_2, highchain_lane_0_3 : natural range 0 to 4095;
  signal highchain_lane_0_4, highchain_lane_0_5, highchain_lane_0_6, highchain_lane_0_7 : natural range 0 to 4095;
  signal highchain_lane_0_8, highchain_lane_0_9, highchain_lane_0_10, highchain_lane_0_11 : natural range 0 to 4095;
  signal highchain_lane_0_12, highchain_lane_0_13, highchain_lane_0_14, highchain_lane_0_15 : natural range 0 to 4095;
  signal highchain_lane_1_0, highchain_lane_1_1, highchain_lane_1_2, highchain_lane_1_3 : natural range 0 to 4095;
  signal highchain_lane_1_4, highchain_lane_1_5, highchain_lane_1_6, highchain_lane_1_7 : natural range 0 to 4095;
  signal highchain_lane_1_8, highchain_lane_1_9, highchain_lane_1_10, highchain_lane_1_11 : natural range 0 to 4095;
  signal highchain_lane_1_12, highchain_lane_1_13, highchain_lane_1_14, highchain_lane_1_15 : natural range 0 to 4095;
  -- highcost
  signal highcost_pixels_first_0_0, highcost_pixels_first_0_1, highcost_pixels_first_0_2 : natural range 0 to 255;
  signal highcost_pixels_first_0_3, highcost_pixels_first_0_4, highcost_pixels_first_0_5 : natural range 0 to 255;
  signal highcost_pixels_first_0_6, highcost_pixels_first_0_7, highcost_pixels_first_0_8 : natural range 0 to 255;
  signal highcost_pixels_first_0_9, highcost_pixels_first_0_10, highcost_pixels_first_0_11 : natural range 0 to 255;
  signal highcost_pixels_first_0_12, highcost_pixels_first_0_13, highcost_pixels_first_0_14 : natural range 0 to 255;
  signal highcost_pixels_first_0_15, highcost_pixels_first_1_0, highcost_pixels_first_1_1 : natural range 0 to 255;
  signal highcost_pixels_first_1_2, highcost_pixels_first_1_3, highcost_pixels_first_1_4 : natural range 0 to 255;
  signal highcost_pixels_first_1_5, highcost_pixels_first_1_6, highcost_pixels_first_1_7 : natural range 0 to 255;
  signal highcost_pixels_first_1_8, highcost_pixels_first_1_9, highcost_pixels_first_1_10 : natural range 0 to 255;
  signal highcost_pixels_first_1_11, highcost_pixels_first_1_12, highcost_pixels_first_1_13 : natural range 0 to 255;
  signal highcost_pixels_first_1_14, highcost_pixels_first_1_15 : natural range 0 to 255;
  signal highcost_pixels_cost_0_0, highcost_pixels_cost_0_1, highcost_pixels_cost_0_2 : natural range 0 to 19;
  signal highcost_pixels_cost_0_3, highcost_pixels_cost_0_4, highcost_pixels_cost_0_5 : natural range 0 to 19;
  signal highcost_pixels_cost_0_6, highcost_pixels_cost_0_7, highcost_pixels_cost_0_8 : natural range 0 to 19;
  signal highcost_pixels_cost_0_9, highcost_pixels_cost_0_10, highcost_pixels_cost_0_11 : natural range 0 to 19;
  signal highcost_pixels_cost_0_12, highcost_pixels_cost_0_13, highcost_pixels_cost_0_14 : natural range 0 to 19;
  signal highcost_pixels_cost_0_15, highcost_pixels_cost_1_0, highcost_pixels_cost_1_1 : natural range 0 to 19;
  signal highcost_pixels_cost_1_2, highcost_pixels_cost_1_3, highcost_pixels_cost_1_4 : natural range 0 to 19;
  signal highcost_pixels_cost_1_5, highcost_pixels_cost_1_6, highcost_pixels_cost_1_7 : natural range 0 to 19;
  signal highcost_pixels_cost_1_8, highcost_pixels_cost_1_9, highcost_pixels_cost_1_10 : natural range 0 to 19;
  signal highcost_pixels_cost_1_11, highcost_pixels_cost_1_12, highcost_pixels_cost_1_13 : natural range 0 to 19;
  signal highcost_pixels_cost_1_14, highcost_pixels_cost_1_15 : natural range 0 to 19;
  signal highcost_read_words_0, highcost_read_words_1, highcost_read_words_2 : unsigned(27 downto 0);
  signal highcost_read_words_3 : unsigned(27 downto 0);
  signal highcost_change_0_0, highcost_change_0_1, highcost_change_0_2, highcost_change_0_3 : integer range -19 to 19;
  signal highcost_change_0_4, highcost_change_0_5, highcost_change_0_6, highcost_change_0_7 : integer range -19 to 19;
  signal highcost_change_0_8, highcost_change_0_9, highcost_change_0_10, highcost_change_0_11 : integer range -19 to 19;
  signal highcost_change_0_12, highcost_change_0_13, highcost_change_0_14 : integer range -19 to 19;
  signal highcost_change_0_15 : integer range -19 to 19;
  signal highcost_ready_words_0, highcost_ready_words_1, highcost_ready_words_2 : natural range 0 to 268435455;
  signal highcost_ready_words_3, highcost_write_words_0, highcost_write_words_1 : natural range 0 to 268435455;
  signal highcost_write_words_2, highcost_write_words_3 : natural range 0 to 268435455;
  signal highcost_column_0_0, highcost_column_0_1, highcost_column_0_2, highcost_column_0_3 : natural range 0 to 127;
  signal highcost_column_0_4, highcost_column_0_5, highcost_column_0_6, highcost_column_0_7 : natural range 0 to 127;
  signal highcost_column_0_8, highcost_column_0_9, highcost_column_0_10, highcost_column_0_11 : natural range 0 to 127;
  signal highcost_column_0_12, highcost_column_0_13, highcost_column_0_14 : natural range 0 to 127;
  signal highcost_column_0_15 : natural range 0 to 127;
  -- highwindow
  signal highwindow_leaving_0, highwindow_leaving_1, highwindow_leaving_2, highwindow_leaving_3 : unsigned(27 downto 0);
  signal highwindow_entering_0_0, highwindow_entering_0_1, highwindow_entering_0_2 : natural range 0 to 127;
  signal highwindow_entering_0_3, highwindow_entering_0_4, highwindow_entering_0_5 : natural range 0 to 127;
  signal highwindow_entering_0_6, highwindow_entering_0_7, highwindow_entering_0_8 : natural range 0 to 127;
  signal highwindow_entering_0_9, highwindow_entering_0_10, highwindow_entering_0_11 : natural range 0 to 127;
  signal highwindow_entering_0_12, highwindow_entering_0_13, highwindow_entering_0_14 : natural range 0 to 127;
  signal highwindow_entering_0_15 : natural range 0 to 127;
  signal highwindow_change_0_0, highwindow_change_0_1, highwindow_change_0_2 : integer range -127 to 127;
  signal highwindow_change_0_3, highwindow_change_0_4, highwindow_change_0_5 : integer range -127 to 127;
  signal highwindow_change_0_6, highwindow_change_0_7, highwindow_change_0_8 : integer range -127 to 127;
  signal highwindow_change_0_9, highwindow_change_0_10, highwindow_change_0_11 : integer range -127 to 127;
  signal highwindow_change_0_12, highwindow_change_0_13, highwindow_change_0_14 : integer range -127 to 127;
  signal highwindow_change_0_15 : integer range -127 to 127;
  signal highwindow_sum_0_0, highwindow_sum_0_1, highwindow_sum_0_2, highwindow_sum_0_3 : natural range 0 to 511;
  signal highwindow_sum_0_4, highwindow_sum_0_5, highwindow_sum_0_6, highwindow_sum_0_7 : natural range 0 to 511;
  signal highwindow_sum_0_8, highwindow_sum_0_9, highwindow_sum_0_10, highwindow_sum_0_11 : natural range 0 to 511;
  signal highwindow_sum_0_12, highwindow_sum_0_13, highwindow_sum_0_14, highwindow_sum_0_15 : natural range 0 to 511;
  -- highwinner1
  signal highwinner1_of_pair_0_0, highwinner1_of_pair_0_1, highwinner1_of_pair_0_2 : natural range 0 to 511;
  signal highwinner1_of_pair_0_3, highwinner1_of_pair_0_4, highwinner1_of_pair_0_5 : natural range 0 to 511;
  signal highwinner1_of_pair_0_6, highwinner1_of_pair_0_7, highwinner1_of_pair_0_8 : natural range 0 to 511;
  signal highwinner1_of_pair_0_9, highwinner1_of_pair_0_10, highwinner1_of_pair_0_11 : natural range 0 to 511;
  signal highwinner1_of_pair_0_12, highwinner1_of_pair_0_13, highwinner1_of_pair_0_14 : natural range 0 to 511;
  signal highwinner1_of_pair_0_15, highwinner1_of_four_0_0, highwinner1_of_four_0_1 : natural range 0 to 511;
  signal highwinner1_of_four_0_2, highwinner1_of_four_0_3, highwinner1_of_four_0_4 : natural range 0 to 511;
  signal highwinner1_of_four_0_5, highwinner1_of_four_0_6, highwinner1_of_four_0_7 : natural range 0 to 511;
  signal highwinner1_of_four_0_8, highwinner1_of_four_0_9, highwinner1_of_four_0_10 : natural range 0 to 511;
  signal highwinner1_of_four_0_11, highwinner1_of_four_0_12, highwinner1_of_four_0_13 : natural range 0 to 511;
  signal highwinner1_of_four_0_14, highwinner1_of_four_0_15, highwinner1_best_cost_0_0 : natural range 0 to 511;
  signal highwinner1_best_cost_0_1, highwinner1_best_cost_0_2, highwinner1_best_cost_0_3 : natural range 0 to 511;
  signal highwinner1_pair_index_0_0 : boolean;
  signal highwinner1_pair_index_0_1, highwinner1_four_index_0_0, highwinner1_best_index_0_0 : natural range 0 to 3;
  signal highwinner1_pair_index_0_2 : natural range 0 to 5;
  signal highwinner1_pair_index_0_3, highwinner1_four_index_0_1, highwinner1_best_index_0_1 : natural range 0 to 7;
  signal highwinner1_pair_index_0_4 : natural range 0 to 9;
  signal highwinner1_pair_index_0_5, highwinner1_four_index_0_2, highwinner1_best_index_0_2 : natural range 0 to 11;
  signal highwinner1_pair_index_0_6 : natural range 0 to 13;
  signal highwinner1_pair_index_0_7, highwinner1_four_index_0_3, highwinner1_best_index_0_3 : natural range 0 to 15;
  -- highwinner2
  signal highwinner2_of_pair_0_0, highwinner2_of_pair_0_1, highwinner2_of_pair_0_2 : natural range 0 to 511;
  signal highwinner2_of_pair_0_3, highwinner2_of_four_0_0, highwinner2_of_four_0_1 : natural range 0 to 511;
  signal highwinner2_of_four_0_2, highwinner2_of_four_0_3, highwinner2_best_cost_0_0 : natural range 0 to 511;
  signal highwinner2_pair_index_0_0 : natural range 0 to 7;
  signal highwinner2_pair_index_0_1, highwinner2_four_index_0_0, highwinner2_best_index_0_0 : natural range 0 to 15;
  -- centre
  signal centre_held_0_1, centre_held_1_0, centre_held_1_1 : natural range 0 to 65535;
  signal centre_line_0_0, centre_line_0_1, centre_line_0_2, centre_line_0_3, centre_line_0_4 : natural range 0 to 255;
  signal centre_line_0_5, centre_line_0_6, centre_line_0_7, centre_line_0_8, centre_line_0_9 : natural range 0 to 255;
  signal centre_line_0_10, centre_line_0_11, centre_line_0_12, centre_line_0_13 : natural range 0 to 255;
  signal centre_line_0_14, centre_line_0_15, centre_line_0_16, centre_line_0_17 : natural range 0 to 255;
  signal centre_line_0_18, centre_line_1_0, centre_line_1_1, centre_line_1_2, centre_line_1_3 : natural range 0 to 255;
  signal centre_line_1_4, centre_line_1_5, centre_line_1_6, centre_line_1_7, centre_line_1_8 : natural range 0 to 255;
  signal centre_line_1_9, centre_line_1_10, centre_line_1_11, centre_line_1_12 : natural range 0 to 255;
  signal centre_line_1_13, centre_line_1_14, centre_line_1_15, centre_line_1_16 : natural range 0 to 255;
  signal centre_line_1_17, centre_line_1_18 : natural range 0 to 255;
  -- choice
  signal choice_best_index_0_0 : natural range 0 to 15;
  signal choice_best_tag_valid, choice_best_tag_output_column, choice_best_tag_start_of_frame : boolean;
  signal choice_best_tag_end_of_line : boolean;
  signal choice_base : natural range 0 to 255;
  -- map
  signal map_disparity_0 : natural range 0 to 255;
  signal map_passed_0, map_valid, map_start_of_frame, map_end_of_line : boolean;
  -- other
  signal other_0, other_1, other_6, other_7 : natural range 0 to 524288;
  signal other_2, other_8 : natural range 0 to 131044;
  signal other_3, other_4, other_9, other_10, other_14, other_15, other_17, other_18 : natural range 0 to 131072;
  signal other_5, other_11, other_16, other_19 : natural range 0 to 32762;
  signal other_12, other_13, other_21, other_22 : natural range 0 to 257;
  signal other_20 : natural range 0 to 30;
  signal lowwindow_leaving_3_memory_read_enable : boolean;
  signal lowwindow_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal lowwindow_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal lowwindow_leaving_3_memory_write_data : unsigned(27 downto 0);
  signal lowwindow_leaving_2_memory_read_enable : boolean;
  signal lowwindow_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal lowwindow_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal lowwindow_leaving_2_memory_write_data : unsigned(27 downto 0);
  signal lowwindow_leaving_1_memory_read_enable : boolean;
  signal lowwindow_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal lowwindow_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal lowwindow_leaving_1_memory_write_data : unsigned(27 downto 0);
  signal lowwindow_leaving_0_memory_read_enable : boolean;
  signal lowwindow_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal lowwindow_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal lowwindow_leaving_0_memory_write_data : unsigned(27 downto 0);
  signal lowcost_read_words_3_memory_read_enable : boolean;
  signal lowcost_read_words_3_memory_read_address : unsigned(5 downto 0);
  signal lowcost_read_words_3_memory_write_address : unsigned(5 downto 0);
  signal lowcost_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal lowcost_read_words_2_memory_read_enable : boolean;
  signal lowcost_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal lowcost_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal lowcost_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal lowcost_read_words_1_memory_read_enable : boolean;
  signal lowcost_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal lowcost_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal lowcost_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal lowcost_read_words_0_memory_read_enable : boolean;
  signal lowcost_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal lowcost_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal lowcost_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal highwindow_leaving_3_memory_read_enable : boolean;
  signal highwindow_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal highwindow_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal highwindow_leaving_3_memory_write_data : unsigned(27 downto 0);
  signal highwindow_leaving_2_memory_read_enable : boolean;
  signal highwindow_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal highwindow_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal highwindow_leaving_2_memory_write_data : unsigned(27 downto 0);
  signal highwindow_leaving_1_memory_read_enable : boolean;
  signal highwindow_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal highwindow_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal highwindow_leaving_1_memory_write_data : unsigned(27 downto 0);
  signal highwindow_leaving_0_memory_read_enable : boolean;
  signal highwindow_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal highwindow_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal highwindow_leaving_0_memory_write_data : unsigned(27 downto 0);
  signal highcost_read_words_3_memory_read_enable : boolean;
  signal highcost_read_words_3_memory_read_address : unsigned(5 downto 0);
  signal highcost_read_words_3_memory_write_address : unsigned(5 downto 0);
  signal highcost_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal highcost_read_words_2_memory_read_enable : boolean;
  signal highcost_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal highcost_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal highcost_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal highcost_read_words_1_memory_read_enable : boolean;
  signal highcost_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal highcost_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal highcost_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal highcost_read_words_0_memory_read_enable : boolean;
  signal highcost_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal highcost_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal highcost_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal compared_rows_read_words_2_memory_read_enable : boolean;
  signal compared_rows_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal compared_rows_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal compared_rows_read_words_2_memory_write_data : unsigned(11 downto 0);
  signal compared_rows_read_words_1_memory_read_enable : boolean;
  signal compared_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal compared_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal compared_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal compared_rows_read_words_0_memory_read_enable : boolean;
  signal compared_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal compared_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal compared_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal pairs_delayed_0_memory_read_enable : boolean;
  signal pairs_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal pairs_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal pairs_delayed_0_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_15_memory_read_enable : boolean;
  signal rows_read_codes_15_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_15_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_15_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_14_memory_read_enable : boolean;
  signal rows_read_codes_14_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_14_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_14_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_13_memory_read_enable : boolean;
  signal rows_read_codes_13_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_13_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_13_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_12_memory_read_enable : boolean;
  signal rows_read_codes_12_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_12_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_12_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_11_memory_read_enable : boolean;
  signal rows_read_codes_11_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_11_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_11_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_10_memory_read_enable : boolean;
  signal rows_read_codes_10_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_10_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_10_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_9_memory_read_enable : boolean;
  signal rows_read_codes_9_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_9_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_9_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_8_memory_read_enable : boolean;
  signal rows_read_codes_8_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_8_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_8_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_7_memory_read_enable : boolean;
  signal rows_read_codes_7_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_7_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_7_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_6_memory_read_enable : boolean;
  signal rows_read_codes_6_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_6_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_6_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_5_memory_read_enable : boolean;
  signal rows_read_codes_5_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_5_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_5_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_4_memory_read_enable : boolean;
  signal rows_read_codes_4_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_4_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_4_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_3_memory_read_enable : boolean;
  signal rows_read_codes_3_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_3_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_3_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_2_memory_read_enable : boolean;
  signal rows_read_codes_2_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_2_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_2_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_1_memory_read_enable : boolean;
  signal rows_read_codes_1_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_1_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_1_memory_write_data : unsigned(11 downto 0);
  signal rows_read_codes_0_memory_read_enable : boolean;
  signal rows_read_codes_0_memory_read_address : unsigned(6 downto 0);
  signal rows_read_codes_0_memory_write_address : unsigned(6 downto 0);
  signal rows_read_codes_0_memory_write_data : unsigned(11 downto 0);
  signal bases_read_targets_2_memory_read_enable : boolean;
  signal bases_read_targets_2_memory_read_address : unsigned(5 downto 0);
  signal bases_read_targets_2_memory_write_address : unsigned(5 downto 0);
  signal bases_read_targets_2_memory_write_data : unsigned(15 downto 0);
  signal bases_read_targets_1_memory_read_enable : boolean;
  signal bases_read_targets_1_memory_read_address : unsigned(5 downto 0);
  signal bases_read_targets_1_memory_write_address : unsigned(5 downto 0);
  signal bases_read_targets_1_memory_write_data : unsigned(15 downto 0);
  signal bases_read_targets_0_memory_read_enable : boolean;
  signal bases_read_targets_0_memory_read_address : unsigned(5 downto 0);
  signal bases_read_targets_0_memory_write_address : unsigned(5 downto 0);
  signal bases_read_targets_0_memory_write_data : unsigned(15 downto 0);
  signal ahead_held_0_memory_read_enable : boolean;
  signal ahead_held_0_memory_read_address : unsigned(4 downto 0);
  signal ahead_held_0_memory_write_address : unsigned(4 downto 0);
  signal ahead_held_0_memory_write_data : unsigned(12 downto 0);
  signal transform_left_rows_read_words_4_memory_read_enable : boolean;
  signal transform_left_rows_read_words_4_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_4_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_4_memory_write_data : unsigned(11 downto 0);
  signal transform_left_rows_read_words_3_memory_read_enable : boolean;
  signal transform_left_rows_read_words_3_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_3_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal transform_left_rows_read_words_2_memory_read_enable : boolean;
  signal transform_left_rows_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal transform_left_rows_read_words_1_memory_read_enable : boolean;
  signal transform_left_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_4_memory_read_enable : boolean;
  signal transform_right_rows_read_words_4_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_4_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_4_memory_write_data : unsigned(11 downto 0);
  signal transform_right_rows_read_words_3_memory_read_enable : boolean;
  signal transform_right_rows_read_words_3_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_3_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_2_memory_read_enable : boolean;
  signal transform_right_rows_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_1_memory_read_enable : boolean;
  signal transform_right_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal hold_back_held_0_memory_read_enable : boolean;
  signal hold_back_held_0_memory_read_address : unsigned(11 downto 0);
  signal hold_back_held_0_memory_write_address : unsigned(11 downto 0);
  signal hold_back_held_0_memory_write_data : unsigned(24 downto 0);
  signal targets_rows_read_words_0_memory_read_enable : boolean;
  signal targets_rows_read_words_0_memory_read_address : unsigned(2 downto 0);
  signal targets_rows_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal targets_rows_read_words_0_memory_write_data : unsigned(20 downto 0);
  signal ranges_pairs_read_words_0_memory_read_enable : boolean;
  signal ranges_pairs_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal ranges_pairs_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal ranges_pairs_read_words_0_memory_write_data : unsigned(6 downto 0);
  signal ranges_pixels_read_words_0_memory_read_enable : boolean;
  signal ranges_pixels_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal ranges_pixels_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal ranges_pixels_read_words_0_memory_write_data : unsigned(7 downto 0);
  signal coarseleftright_found_0_memory_read_enable : boolean;
  signal coarseleftright_found_0_memory_read_address : unsigned(3 downto 0);
  signal coarseleftright_found_0_memory_write_address : unsigned(3 downto 0);
  signal coarseleftright_found_0_memory_write_data : unsigned(2 downto 0);
  signal coarseleftright_held_0_memory_read_enable : boolean;
  signal coarseleftright_held_0_memory_read_address : unsigned(2 downto 0);
  signal coarseleftright_held_0_memory_write_address : unsigned(2 downto 0);
  signal coarseleftright_held_0_memory_write_data : unsigned(12 downto 0);
  signal coarserows_search_rows_read_words_1_memory_read_enable : boolean;
  signal coarserows_search_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal coarserows_search_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal coarserows_search_rows_read_words_1_memory_write_data : unsigned(5 downto 0);
  signal coarserows_search_rows_read_words_0_memory_read_enable : boolean;
  signal coarserows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal coarserows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal coarserows_search_rows_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal coarserows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal coarserows_reference_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal coarserows_reference_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal coarserows_reference_rows_read_words_1_memory_write_data : unsigned(5 downto 0);
  signal coarserows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal coarserows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal coarserows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal coarserows_reference_rows_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal coarsedelay_delayed_0_memory_read_enable : boolean;
  signal coarsedelay_delayed_0_memory_read_address : unsigned(2 downto 0);
  signal coarsedelay_delayed_0_memory_write_address : unsigned(2 downto 0);
  signal coarsedelay_delayed_0_memory_write_data : unsigned(5 downto 0);
  signal coarsetransform_left_rows_read_words_1_memory_read_enable : boolean;
  signal coarsetransform_left_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal coarsetransform_left_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal coarsetransform_left_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal coarsetransform_left_rows_read_words_0_memory_read_enable : boolean;
  signal coarsetransform_left_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal coarsetransform_left_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal coarsetransform_left_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal coarsetransform_right_rows_read_words_1_memory_read_enable : boolean;
  signal coarsetransform_right_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal coarsetransform_right_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal coarsetransform_right_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal coarsetransform_right_rows_read_words_0_memory_read_enable : boolean;
  signal coarsetransform_right_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal coarsetransform_right_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal coarsetransform_right_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal coarse_pixels_read_word_0_memory_read_enable : boolean;
  signal coarse_pixels_read_word_0_memory_read_address : unsigned(3 downto 0);
  signal coarse_pixels_read_word_0_memory_write_address : unsigned(3 downto 0);
  signal coarse_pixels_read_word_0_memory_write_data : unsigned(31 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_passed_0), 1));
  disparity_valid <= as_bit(map_valid);
  disparity_start_of_frame <= as_bit(map_start_of_frame);
  disparity_end_of_line <= as_bit(map_end_of_line);

  lowwindow_leaving_3_memory_read_enable <= true;
  lowwindow_leaving_3_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  lowwindow_leaving_3_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  lowwindow_leaving_3_memory_write_data <= to_unsigned(lowcost_column_0_15, 7) & to_unsigned(lowcost_column_0_14, 7) & to_unsigned(lowcost_column_0_13, 7) & to_unsigned(lowcost_column_0_12, 7);
  lowwindow_leaving_3_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => lowwindow_leaving_3_memory_read_enable,
      read_address => lowwindow_leaving_3_memory_read_address, read_data => lowwindow_leaving_3,
      write_address => lowwindow_leaving_3_memory_write_address, write_data => lowwindow_leaving_3_memory_write_data);

  lowwindow_leaving_2_memory_read_enable <= true;
  lowwindow_leaving_2_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  lowwindow_leaving_2_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  lowwindow_leaving_2_memory_write_data <= to_unsigned(lowcost_column_0_11, 7) & to_unsigned(lowcost_column_0_10, 7) & to_unsigned(lowcost_column_0_9, 7) & to_unsigned(lowcost_column_0_8, 7);
  lowwindow_leaving_2_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => lowwindow_leaving_2_memory_read_enable,
      read_address => lowwindow_leaving_2_memory_read_address, read_data => lowwindow_leaving_2,
      write_address => lowwindow_leaving_2_memory_write_address, write_data => lowwindow_leaving_2_memory_write_data);

  lowwindow_leaving_1_memory_read_enable <= true;
  lowwindow_leaving_1_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  lowwindow_leaving_1_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  lowwindow_leaving_1_memory_write_data <= to_unsigned(lowcost_column_0_7, 7) & to_unsigned(lowcost_column_0_6, 7) & to_unsigned(lowcost_column_0_5, 7) & to_unsigned(lowcost_column_0_4, 7);
  lowwindow_leaving_1_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => lowwindow_leaving_1_memory_read_enable,
      read_address => lowwindow_leaving_1_memory_read_address, read_data => lowwindow_leaving_1,
      write_address => lowwindow_leaving_1_memory_write_address, write_data => lowwindow_leaving_1_memory_write_data);

  lowwindow_leaving_0_memory_read_enable <= true;
  lowwindow_leaving_0_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  lowwindow_leaving_0_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  lowwindow_leaving_0_memory_write_data <= to_unsigned(lowcost_column_0_3, 7) & to_unsigned(lowcost_column_0_2, 7) & to_unsigned(lowcost_column_0_1, 7) & to_unsigned(lowcost_column_0_0, 7);
  lowwindow_leaving_0_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => lowwindow_leaving_0_memory_read_enable,
      read_address => lowwindow_leaving_0_memory_read_address, read_data => lowwindow_leaving_0,
      write_address => lowwindow_leaving_0_memory_write_address, write_data => lowwindow_leaving_0_memory_write_data);

  lowcost_read_words_3_memory_read_enable <= true;
  lowcost_read_words_3_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  lowcost_read_words_3_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  lowcost_read_words_3_memory_write_data <= to_unsigned(lowcost_write_words_3, 28);
  lowcost_read_words_3_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => lowcost_read_words_3_memory_read_enable,
      read_address => lowcost_read_words_3_memory_read_address, read_data => lowcost_read_words_3,
      write_address => lowcost_read_words_3_memory_write_address, write_data => lowcost_read_words_3_memory_write_data);

  lowcost_read_words_2_memory_read_enable <= true;
  lowcost_read_words_2_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  lowcost_read_words_2_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  lowcost_read_words_2_memory_write_data <= to_unsigned(lowcost_write_words_2, 28);
  lowcost_read_words_2_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => lowcost_read_words_2_memory_read_enable,
      read_address => lowcost_read_words_2_memory_read_address, read_data => lowcost_read_words_2,
      write_address => lowcost_read_words_2_memory_write_address, write_data => lowcost_read_words_2_memory_write_data);

  lowcost_read_words_1_memory_read_enable <= true;
  lowcost_read_words_1_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  lowcost_read_words_1_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  lowcost_read_words_1_memory_write_data <= to_unsigned(lowcost_write_words_1, 28);
  lowcost_read_words_1_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => lowcost_read_words_1_memory_read_enable,
      read_address => lowcost_read_words_1_memory_read_address, read_data => lowcost_read_words_1,
      write_address => lowcost_read_words_1_memory_write_address, write_data => lowcost_read_words_1_memory_write_data);

  lowcost_read_words_0_memory_read_enable <= true;
  lowcost_read_words_0_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  lowcost_read_words_0_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  lowcost_read_words_0_memory_write_data <= to_unsigned(lowcost_write_words_0, 28);
  lowcost_read_words_0_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => lowcost_read_words_0_memory_read_enable,
      read_address => lowcost_read_words_0_memory_read_address, read_data => lowcost_read_words_0,
      write_address => lowcost_read_words_0_memory_write_address, write_data => lowcost_read_words_0_memory_write_data);

  highwindow_leaving_3_memory_read_enable <= true;
  highwindow_leaving_3_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  highwindow_leaving_3_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  highwindow_leaving_3_memory_write_data <= to_unsigned(highcost_column_0_15, 7) & to_unsigned(highcost_column_0_14, 7) & to_unsigned(highcost_column_0_13, 7) & to_unsigned(highcost_column_0_12, 7);
  highwindow_leaving_3_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => highwindow_leaving_3_memory_read_enable,
      read_address => highwindow_leaving_3_memory_read_address, read_data => highwindow_leaving_3,
      write_address => highwindow_leaving_3_memory_write_address, write_data => highwindow_leaving_3_memory_write_data);

  highwindow_leaving_2_memory_read_enable <= true;
  highwindow_leaving_2_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  highwindow_leaving_2_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  highwindow_leaving_2_memory_write_data <= to_unsigned(highcost_column_0_11, 7) & to_unsigned(highcost_column_0_10, 7) & to_unsigned(highcost_column_0_9, 7) & to_unsigned(highcost_column_0_8, 7);
  highwindow_leaving_2_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => highwindow_leaving_2_memory_read_enable,
      read_address => highwindow_leaving_2_memory_read_address, read_data => highwindow_leaving_2,
      write_address => highwindow_leaving_2_memory_write_address, write_data => highwindow_leaving_2_memory_write_data);

  highwindow_leaving_1_memory_read_enable <= true;
  highwindow_leaving_1_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  highwindow_leaving_1_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  highwindow_leaving_1_memory_write_data <= to_unsigned(highcost_column_0_7, 7) & to_unsigned(highcost_column_0_6, 7) & to_unsigned(highcost_column_0_5, 7) & to_unsigned(highcost_column_0_4, 7);
  highwindow_leaving_1_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => highwindow_leaving_1_memory_read_enable,
      read_address => highwindow_leaving_1_memory_read_address, read_data => highwindow_leaving_1,
      write_address => highwindow_leaving_1_memory_write_address, write_data => highwindow_leaving_1_memory_write_data);

  highwindow_leaving_0_memory_read_enable <= true;
  highwindow_leaving_0_memory_read_address <= to_unsigned(lowwindow_ring_read_address, 3);
  highwindow_leaving_0_memory_write_address <= to_unsigned(lowwindow_ring_write_address, 3);
  highwindow_leaving_0_memory_write_data <= to_unsigned(highcost_column_0_3, 7) & to_unsigned(highcost_column_0_2, 7) & to_unsigned(highcost_column_0_1, 7) & to_unsigned(highcost_column_0_0, 7);
  highwindow_leaving_0_memory : entity work.line_memory
    generic map (depth => 6, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => highwindow_leaving_0_memory_read_enable,
      read_address => highwindow_leaving_0_memory_read_address, read_data => highwindow_leaving_0,
      write_address => highwindow_leaving_0_memory_write_address, write_data => highwindow_leaving_0_memory_write_data);

  highcost_read_words_3_memory_read_enable <= true;
  highcost_read_words_3_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  highcost_read_words_3_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  highcost_read_words_3_memory_write_data <= to_unsigned(highcost_write_words_3, 28);
  highcost_read_words_3_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => highcost_read_words_3_memory_read_enable,
      read_address => highcost_read_words_3_memory_read_address, read_data => highcost_read_words_3,
      write_address => highcost_read_words_3_memory_write_address, write_data => highcost_read_words_3_memory_write_data);

  highcost_read_words_2_memory_read_enable <= true;
  highcost_read_words_2_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  highcost_read_words_2_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  highcost_read_words_2_memory_write_data <= to_unsigned(highcost_write_words_2, 28);
  highcost_read_words_2_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => highcost_read_words_2_memory_read_enable,
      read_address => highcost_read_words_2_memory_read_address, read_data => highcost_read_words_2,
      write_address => highcost_read_words_2_memory_write_address, write_data => highcost_read_words_2_memory_write_data);

  highcost_read_words_1_memory_read_enable <= true;
  highcost_read_words_1_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  highcost_read_words_1_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  highcost_read_words_1_memory_write_data <= to_unsigned(highcost_write_words_1, 28);
  highcost_read_words_1_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => highcost_read_words_1_memory_read_enable,
      read_address => highcost_read_words_1_memory_read_address, read_data => highcost_read_words_1,
      write_address => highcost_read_words_1_memory_write_address, write_data => highcost_read_words_1_memory_write_data);

  highcost_read_words_0_memory_read_enable <= true;
  highcost_read_words_0_memory_read_address <= to_unsigned(lowcost_read_column, 6);
  highcost_read_words_0_memory_write_address <= to_unsigned(lowcost_write_column, 6);
  highcost_read_words_0_memory_write_data <= to_unsigned(highcost_write_words_0, 28);
  highcost_read_words_0_memory : entity work.line_memory
    generic map (depth => 64, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => highcost_read_words_0_memory_read_enable,
      read_address => highcost_read_words_0_memory_read_address, read_data => highcost_read_words_0,
      write_address => highcost_read_words_0_memory_write_address, write_data => highcost_read_words_0_memory_write_data);

  compared_rows_read_words_2_memory_read_enable <= true;
  compared_rows_read_words_2_memory_read_address <= to_unsigned(bases_asked_column, 6);
  compared_rows_read_words_2_memory_write_address <= to_unsigned(bases_wanted_column, 6);
  compared_rows_read_words_2_memory_write_data <= to_unsigned(compared_rows_write_words_2, 12);
  compared_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 64, width => 12, address_bits => 6)
    port map (
      clock => clock, read_enable => compared_rows_read_words_2_memory_read_enable,
      read_address => compared_rows_read_words_2_memory_read_address, read_data => compared_rows_read_words_2,
      write_address => compared_rows_read_words_2_memory_write_address, write_data => compared_rows_read_words_2_memory_write_data);

  compared_rows_read_words_1_memory_read_enable <= true;
  compared_rows_read_words_1_memory_read_address <= to_unsigned(bases_asked_column, 6);
  compared_rows_read_words_1_memory_write_address <= to_unsigned(bases_wanted_column, 6);
  compared_rows_read_words_1_memory_write_data <= to_unsigned(compared_rows_write_words_1, 24);
  compared_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => compared_rows_read_words_1_memory_read_enable,
      read_address => compared_rows_read_words_1_memory_read_address, read_data => compared_rows_read_words_1,
      write_address => compared_rows_read_words_1_memory_write_address, write_data => compared_rows_read_words_1_memory_write_data);

  compared_rows_read_words_0_memory_read_enable <= true;
  compared_rows_read_words_0_memory_read_address <= to_unsigned(bases_asked_column, 6);
  compared_rows_read_words_0_memory_write_address <= to_unsigned(bases_wanted_column, 6);
  compared_rows_read_words_0_memory_write_data <= to_unsigned(compared_rows_write_words_0, 24);
  compared_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => compared_rows_read_words_0_memory_read_enable,
      read_address => compared_rows_read_words_0_memory_read_address, read_data => compared_rows_read_words_0,
      write_address => compared_rows_read_words_0_memory_write_address, write_data => compared_rows_read_words_0_memory_write_data);

  pairs_delayed_0_memory_read_enable <= true;
  pairs_delayed_0_memory_read_address <= to_unsigned(pairs_ring_read_address, 4);
  pairs_delayed_0_memory_write_address <= to_unsigned(pairs_ring_write_address, 4);
  pairs_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 12);
  pairs_delayed_0_memory : entity work.line_memory
    generic map (depth => 16, width => 12, address_bits => 4)
    port map (
      clock => clock, read_enable => pairs_delayed_0_memory_read_enable,
      read_address => pairs_delayed_0_memory_read_address, read_data => pairs_delayed_0,
      write_address => pairs_delayed_0_memory_write_address, write_data => pairs_delayed_0_memory_write_data);

  rows_read_codes_15_memory_read_enable <= true;
  rows_read_codes_15_memory_read_address <= to_unsigned(rows_address_15, 7);
  rows_read_codes_15_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_15_memory_write_data <= to_unsigned(rows_write_codes_3, 12);
  rows_read_codes_15_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_15_memory_read_enable,
      read_address => rows_read_codes_15_memory_read_address, read_data => rows_read_codes_15,
      write_address => rows_read_codes_15_memory_write_address, write_data => rows_read_codes_15_memory_write_data);

  rows_read_codes_14_memory_read_enable <= true;
  rows_read_codes_14_memory_read_address <= to_unsigned(rows_address_14, 7);
  rows_read_codes_14_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_14_memory_write_data <= to_unsigned(rows_write_codes_2, 12);
  rows_read_codes_14_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_14_memory_read_enable,
      read_address => rows_read_codes_14_memory_read_address, read_data => rows_read_codes_14,
      write_address => rows_read_codes_14_memory_write_address, write_data => rows_read_codes_14_memory_write_data);

  rows_read_codes_13_memory_read_enable <= true;
  rows_read_codes_13_memory_read_address <= to_unsigned(rows_address_13, 7);
  rows_read_codes_13_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_13_memory_write_data <= to_unsigned(rows_write_codes_1, 12);
  rows_read_codes_13_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_13_memory_read_enable,
      read_address => rows_read_codes_13_memory_read_address, read_data => rows_read_codes_13,
      write_address => rows_read_codes_13_memory_write_address, write_data => rows_read_codes_13_memory_write_data);

  rows_read_codes_12_memory_read_enable <= true;
  rows_read_codes_12_memory_read_address <= to_unsigned(rows_address_12, 7);
  rows_read_codes_12_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_12_memory_write_data <= to_unsigned(rows_write_codes_0, 12);
  rows_read_codes_12_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_12_memory_read_enable,
      read_address => rows_read_codes_12_memory_read_address, read_data => rows_read_codes_12,
      write_address => rows_read_codes_12_memory_write_address, write_data => rows_read_codes_12_memory_write_data);

  rows_read_codes_11_memory_read_enable <= true;
  rows_read_codes_11_memory_read_address <= to_unsigned(rows_address_11, 7);
  rows_read_codes_11_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_11_memory_write_data <= to_unsigned(rows_write_codes_3, 12);
  rows_read_codes_11_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_11_memory_read_enable,
      read_address => rows_read_codes_11_memory_read_address, read_data => rows_read_codes_11,
      write_address => rows_read_codes_11_memory_write_address, write_data => rows_read_codes_11_memory_write_data);

  rows_read_codes_10_memory_read_enable <= true;
  rows_read_codes_10_memory_read_address <= to_unsigned(rows_address_10, 7);
  rows_read_codes_10_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_10_memory_write_data <= to_unsigned(rows_write_codes_2, 12);
  rows_read_codes_10_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_10_memory_read_enable,
      read_address => rows_read_codes_10_memory_read_address, read_data => rows_read_codes_10,
      write_address => rows_read_codes_10_memory_write_address, write_data => rows_read_codes_10_memory_write_data);

  rows_read_codes_9_memory_read_enable <= true;
  rows_read_codes_9_memory_read_address <= to_unsigned(rows_address_9, 7);
  rows_read_codes_9_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_9_memory_write_data <= to_unsigned(rows_write_codes_1, 12);
  rows_read_codes_9_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_9_memory_read_enable,
      read_address => rows_read_codes_9_memory_read_address, read_data => rows_read_codes_9,
      write_address => rows_read_codes_9_memory_write_address, write_data => rows_read_codes_9_memory_write_data);

  rows_read_codes_8_memory_read_enable <= true;
  rows_read_codes_8_memory_read_address <= to_unsigned(rows_address_8, 7);
  rows_read_codes_8_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_8_memory_write_data <= to_unsigned(rows_write_codes_0, 12);
  rows_read_codes_8_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_8_memory_read_enable,
      read_address => rows_read_codes_8_memory_read_address, read_data => rows_read_codes_8,
      write_address => rows_read_codes_8_memory_write_address, write_data => rows_read_codes_8_memory_write_data);

  rows_read_codes_7_memory_read_enable <= true;
  rows_read_codes_7_memory_read_address <= to_unsigned(rows_address_7, 7);
  rows_read_codes_7_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_7_memory_write_data <= to_unsigned(rows_write_codes_3, 12);
  rows_read_codes_7_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_7_memory_read_enable,
      read_address => rows_read_codes_7_memory_read_address, read_data => rows_read_codes_7,
      write_address => rows_read_codes_7_memory_write_address, write_data => rows_read_codes_7_memory_write_data);

  rows_read_codes_6_memory_read_enable <= true;
  rows_read_codes_6_memory_read_address <= to_unsigned(rows_address_6, 7);
  rows_read_codes_6_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_6_memory_write_data <= to_unsigned(rows_write_codes_2, 12);
  rows_read_codes_6_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_6_memory_read_enable,
      read_address => rows_read_codes_6_memory_read_address, read_data => rows_read_codes_6,
      write_address => rows_read_codes_6_memory_write_address, write_data => rows_read_codes_6_memory_write_data);

  rows_read_codes_5_memory_read_enable <= true;
  rows_read_codes_5_memory_read_address <= to_unsigned(rows_address_5, 7);
  rows_read_codes_5_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_5_memory_write_data <= to_unsigned(rows_write_codes_1, 12);
  rows_read_codes_5_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_5_memory_read_enable,
      read_address => rows_read_codes_5_memory_read_address, read_data => rows_read_codes_5,
      write_address => rows_read_codes_5_memory_write_address, write_data => rows_read_codes_5_memory_write_data);

  rows_read_codes_4_memory_read_enable <= true;
  rows_read_codes_4_memory_read_address <= to_unsigned(rows_address_4, 7);
  rows_read_codes_4_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_4_memory_write_data <= to_unsigned(rows_write_codes_0, 12);
  rows_read_codes_4_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_4_memory_read_enable,
      read_address => rows_read_codes_4_memory_read_address, read_data => rows_read_codes_4,
      write_address => rows_read_codes_4_memory_write_address, write_data => rows_read_codes_4_memory_write_data);

  rows_read_codes_3_memory_read_enable <= true;
  rows_read_codes_3_memory_read_address <= to_unsigned(rows_address_3, 7);
  rows_read_codes_3_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_3_memory_write_data <= to_unsigned(rows_write_codes_3, 12);
  rows_read_codes_3_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_3_memory_read_enable,
      read_address => rows_read_codes_3_memory_read_address, read_data => rows_read_codes_3,
      write_address => rows_read_codes_3_memory_write_address, write_data => rows_read_codes_3_memory_write_data);

  rows_read_codes_2_memory_read_enable <= true;
  rows_read_codes_2_memory_read_address <= to_unsigned(rows_address_2, 7);
  rows_read_codes_2_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_2_memory_write_data <= to_unsigned(rows_write_codes_2, 12);
  rows_read_codes_2_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_2_memory_read_enable,
      read_address => rows_read_codes_2_memory_read_address, read_data => rows_read_codes_2,
      write_address => rows_read_codes_2_memory_write_address, write_data => rows_read_codes_2_memory_write_data);

  rows_read_codes_1_memory_read_enable <= true;
  rows_read_codes_1_memory_read_address <= to_unsigned(rows_address_1, 7);
  rows_read_codes_1_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_1_memory_write_data <= to_unsigned(rows_write_codes_1, 12);
  rows_read_codes_1_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_1_memory_read_enable,
      read_address => rows_read_codes_1_memory_read_address, read_data => rows_read_codes_1,
      write_address => rows_read_codes_1_memory_write_address, write_data => rows_read_codes_1_memory_write_data);

  rows_read_codes_0_memory_read_enable <= true;
  rows_read_codes_0_memory_read_address <= to_unsigned(rows_address_0, 7);
  rows_read_codes_0_memory_write_address <= to_unsigned(rows_write_word, 7);
  rows_read_codes_0_memory_write_data <= to_unsigned(rows_write_codes_0, 12);
  rows_read_codes_0_memory : entity work.line_memory
    generic map (depth => 113, width => 12, address_bits => 7)
    port map (
      clock => clock, read_enable => rows_read_codes_0_memory_read_enable,
      read_address => rows_read_codes_0_memory_read_address, read_data => rows_read_codes_0,
      write_address => rows_read_codes_0_memory_write_address, write_data => rows_read_codes_0_memory_write_data);

  bases_read_targets_2_memory_read_enable <= true;
  bases_read_targets_2_memory_read_address <= to_unsigned(bases_address_2, 6);
  bases_read_targets_2_memory_write_address <= to_unsigned(targets_place, 6);
  bases_read_targets_2_memory_write_data <= ((to_unsigned(targets_high, 8) & to_unsigned(0, 8)) or (to_unsigned(targets_low, 16)));
  bases_read_targets_2_memory : entity work.line_memory
    generic map (depth => 64, width => 16, address_bits => 6)
    port map (
      clock => clock, read_enable => bases_read_targets_2_memory_read_enable,
      read_address => bases_read_targets_2_memory_read_address, read_data => bases_read_targets_2,
      write_address => bases_read_targets_2_memory_write_address, write_data => bases_read_targets_2_memory_write_data);

  bases_read_targets_1_memory_read_enable <= true;
  bases_read_targets_1_memory_read_address <= to_unsigned(bases_address_1, 6);
  bases_read_targets_1_memory_write_address <= to_unsigned(targets_place, 6);
  bases_read_targets_1_memory_write_data <= ((to_unsigned(targets_high, 8) & to_unsigned(0, 8)) or (to_unsigned(targets_low, 16)));
  bases_read_targets_1_memory : entity work.line_memory
    generic map (depth => 64, width => 16, address_bits => 6)
    port map (
      clock => clock, read_enable => bases_read_targets_1_memory_read_enable,
      read_address => bases_read_targets_1_memory_read_address, read_data => bases_read_targets_1,
      write_address => bases_read_targets_1_memory_write_address, write_data => bases_read_targets_1_memory_write_data);

  bases_read_targets_0_memory_read_enable <= true;
  bases_read_targets_0_memory_read_address <= to_unsigned(bases_address_0, 6);
  bases_read_targets_0_memory_write_address <= to_unsigned(targets_place, 6);
  bases_read_targets_0_memory_write_data <= ((to_unsigned(targets_high, 8) & to_unsigned(0, 8)) or (to_unsigned(targets_low, 16)));
  bases_read_targets_0_memory : entity work.line_memory
    generic map (depth => 64, width => 16, address_bits => 6)
    port map (
      clock => clock, read_enable => bases_read_targets_0_memory_read_enable,
      read_address => bases_read_targets_0_memory_read_address, read_data => bases_read_targets_0,
      write_address => bases_read_targets_0_memory_write_address, write_data => bases_read_targets_0_memory_write_data);

  ahead_held_0_memory_read_enable <= true;
  ahead_held_0_memory_read_address <= to_unsigned(ahead_ring_read_address, 5);
  ahead_held_0_memory_write_address <= to_unsigned(ahead_ring_write_address, 5);
  ahead_held_0_memory_write_data <= to_unsigned(transform_right_code_next_bits, 6) & to_unsigned(transform_right_code_bits, 6) & to_unsigned(as_number(transform_filtering_7_start_of_frame), 1);
  ahead_held_0_memory : entity work.line_memory
    generic map (depth => 21, width => 13, address_bits => 5)
    port map (
      clock => clock, read_enable => ahead_held_0_memory_read_enable,
      read_address => ahead_held_0_memory_read_address, read_data => ahead_held_0,
      write_address => ahead_held_0_memory_write_address, write_data => ahead_held_0_memory_write_data);

  transform_left_rows_read_words_4_memory_read_enable <= true;
  transform_left_rows_read_words_4_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_4_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_4_memory_write_data <= to_unsigned(transform_left_rows_write_words_4, 12);
  transform_left_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 64, width => 12, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_4_memory_read_enable,
      read_address => transform_left_rows_read_words_4_memory_read_address, read_data => transform_left_rows_read_words_4,
      write_address => transform_left_rows_read_words_4_memory_write_address, write_data => transform_left_rows_read_words_4_memory_write_data);

  transform_left_rows_read_words_3_memory_read_enable <= true;
  transform_left_rows_read_words_3_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_3_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_3_memory_write_data <= to_unsigned(transform_left_rows_write_words_3, 24);
  transform_left_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_3_memory_read_enable,
      read_address => transform_left_rows_read_words_3_memory_read_address, read_data => transform_left_rows_read_words_3,
      write_address => transform_left_rows_read_words_3_memory_write_address, write_data => transform_left_rows_read_words_3_memory_write_data);

  transform_left_rows_read_words_2_memory_read_enable <= true;
  transform_left_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_2_memory_write_data <= to_unsigned(transform_left_rows_write_words_2, 24);
  transform_left_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_2_memory_read_enable,
      read_address => transform_left_rows_read_words_2_memory_read_address, read_data => transform_left_rows_read_words_2,
      write_address => transform_left_rows_read_words_2_memory_write_address, write_data => transform_left_rows_read_words_2_memory_write_data);

  transform_left_rows_read_words_1_memory_read_enable <= true;
  transform_left_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_1_memory_write_data <= to_unsigned(transform_left_rows_write_words_1, 24);
  transform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_1_memory_read_enable,
      read_address => transform_left_rows_read_words_1_memory_read_address, read_data => transform_left_rows_read_words_1,
      write_address => transform_left_rows_read_words_1_memory_write_address, write_data => transform_left_rows_read_words_1_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 24);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_4_memory_read_enable <= true;
  transform_right_rows_read_words_4_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_4_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_4_memory_write_data <= to_unsigned(transform_right_rows_write_words_4, 12);
  transform_right_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 64, width => 12, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_4_memory_read_enable,
      read_address => transform_right_rows_read_words_4_memory_read_address, read_data => transform_right_rows_read_words_4,
      write_address => transform_right_rows_read_words_4_memory_write_address, write_data => transform_right_rows_read_words_4_memory_write_data);

  transform_right_rows_read_words_3_memory_read_enable <= true;
  transform_right_rows_read_words_3_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_3_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_3_memory_write_data <= to_unsigned(transform_right_rows_write_words_3, 24);
  transform_right_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_3_memory_read_enable,
      read_address => transform_right_rows_read_words_3_memory_read_address, read_data => transform_right_rows_read_words_3,
      write_address => transform_right_rows_read_words_3_memory_write_address, write_data => transform_right_rows_read_words_3_memory_write_data);

  transform_right_rows_read_words_2_memory_read_enable <= true;
  transform_right_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_2_memory_write_data <= to_unsigned(transform_right_rows_write_words_2, 24);
  transform_right_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_2_memory_read_enable,
      read_address => transform_right_rows_read_words_2_memory_read_address, read_data => transform_right_rows_read_words_2,
      write_address => transform_right_rows_read_words_2_memory_write_address, write_data => transform_right_rows_read_words_2_memory_write_data);

  transform_right_rows_read_words_1_memory_read_enable <= true;
  transform_right_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_1_memory_write_data <= to_unsigned(transform_right_rows_write_words_1, 24);
  transform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_1_memory_read_enable,
      read_address => transform_right_rows_read_words_1_memory_read_address, read_data => transform_right_rows_read_words_1,
      write_address => transform_right_rows_read_words_1_memory_write_address, write_data => transform_right_rows_read_words_1_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 24);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 64, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  hold_back_held_0_memory_read_enable <= true;
  hold_back_held_0_memory_read_address <= to_unsigned(hold_back_ring_read_address, 12);
  hold_back_held_0_memory_write_address <= to_unsigned(hold_back_ring_write_address, 12);
  hold_back_held_0_memory_write_data <= to_unsigned(in_right_pixel, 12) & to_unsigned(in_left_pixel, 12) & to_unsigned(as_number(in_start_of_frame), 1);
  hold_back_held_0_memory : entity work.line_memory
    generic map (depth => 2616, width => 25, address_bits => 12)
    port map (
      clock => clock, read_enable => hold_back_held_0_memory_read_enable,
      read_address => hold_back_held_0_memory_read_address, read_data => hold_back_held_0,
      write_address => hold_back_held_0_memory_write_address, write_data => hold_back_held_0_memory_write_data);

  targets_rows_read_words_0_memory_read_enable <= true;
  targets_rows_read_words_0_memory_read_address <= to_unsigned(targets_read_column, 3);
  targets_rows_read_words_0_memory_write_address <= to_unsigned(targets_write_column, 3);
  targets_rows_read_words_0_memory_write_data <= to_unsigned(targets_rows_write_words_0, 21);
  targets_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 21, address_bits => 3)
    port map (
      clock => clock, read_enable => targets_rows_read_words_0_memory_read_enable,
      read_address => targets_rows_read_words_0_memory_read_address, read_data => targets_rows_read_words_0,
      write_address => targets_rows_read_words_0_memory_write_address, write_data => targets_rows_read_words_0_memory_write_data);

  ranges_pairs_read_words_0_memory_read_enable <= true;
  ranges_pairs_read_words_0_memory_read_address <= to_unsigned(ranges_paired_column, 4);
  ranges_pairs_read_words_0_memory_write_address <= to_unsigned(ranges_pairs_written, 4);
  ranges_pairs_read_words_0_memory_write_data <= to_unsigned(ranges_pairs_write_words_0, 7);
  ranges_pairs_read_words_0_memory : entity work.line_memory
    generic map (depth => 9, width => 7, address_bits => 4)
    port map (
      clock => clock, read_enable => ranges_pairs_read_words_0_memory_read_enable,
      read_address => ranges_pairs_read_words_0_memory_read_address, read_data => ranges_pairs_read_words_0,
      write_address => ranges_pairs_read_words_0_memory_write_address, write_data => ranges_pairs_read_words_0_memory_write_data);

  ranges_pixels_read_words_0_memory_read_enable <= true;
  ranges_pixels_read_words_0_memory_read_address <= to_unsigned(ranges_in_column, 5);
  ranges_pixels_read_words_0_memory_write_address <= to_unsigned(ranges_pixels_written, 5);
  ranges_pixels_read_words_0_memory_write_data <= to_unsigned(ranges_pixels_write_words_0, 8);
  ranges_pixels_read_words_0_memory : entity work.line_memory
    generic map (depth => 17, width => 8, address_bits => 5)
    port map (
      clock => clock, read_enable => ranges_pixels_read_words_0_memory_read_enable,
      read_address => ranges_pixels_read_words_0_memory_read_address, read_data => ranges_pixels_read_words_0,
      write_address => ranges_pixels_read_words_0_memory_write_address, write_data => ranges_pixels_read_words_0_memory_write_data);

  coarseleftright_found_0_memory_read_enable <= true;
  coarseleftright_found_0_memory_read_address <= to_unsigned(coarseleftright_address_0, 4);
  coarseleftright_found_0_memory_write_address <= to_unsigned(coarseleftright_position, 4);
  coarseleftright_found_0_memory_write_data <= to_unsigned(coarseleftright_other_3_0, 3);
  coarseleftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 3, address_bits => 4)
    port map (
      clock => clock, read_enable => coarseleftright_found_0_memory_read_enable,
      read_address => coarseleftright_found_0_memory_read_address, read_data => coarseleftright_found_0,
      write_address => coarseleftright_found_0_memory_write_address, write_data => coarseleftright_found_0_memory_write_data);

  coarseleftright_held_0_memory_read_enable <= true;
  coarseleftright_held_0_memory_read_address <= to_unsigned(coarseleftright_ring_read_address, 3);
  coarseleftright_held_0_memory_write_address <= to_unsigned(coarseleftright_ring_write_address, 3);
  coarseleftright_held_0_memory_write_data <= to_unsigned(1, 1) & to_unsigned(coarseslice0_best_index_0_0, 8) & to_unsigned(as_number(coarseslice0_best_tag_end_of_line), 1) & to_unsigned(as_number(coarseslice0_best_tag_start_of_frame), 1) & to_unsigned(as_number(coarseslice0_best_tag_output_column), 1) & to_unsigned(as_number(coarseslice0_best_tag_map_column), 1);
  coarseleftright_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 13, address_bits => 3)
    port map (
      clock => clock, read_enable => coarseleftright_held_0_memory_read_enable,
      read_address => coarseleftright_held_0_memory_read_address, read_data => coarseleftright_held_0,
      write_address => coarseleftright_held_0_memory_write_address, write_data => coarseleftright_held_0_memory_write_data);

  coarserows_search_rows_read_words_1_memory_read_enable <= true;
  coarserows_search_rows_read_words_1_memory_read_address <= to_unsigned(coarsedelay_column, 5);
  coarserows_search_rows_read_words_1_memory_write_address <= to_unsigned(coarserows_write_column, 5);
  coarserows_search_rows_read_words_1_memory_write_data <= to_unsigned(coarserows_search_rows_write_words_1, 6);
  coarserows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 6, address_bits => 5)
    port map (
      clock => clock, read_enable => coarserows_search_rows_read_words_1_memory_read_enable,
      read_address => coarserows_search_rows_read_words_1_memory_read_address, read_data => coarserows_search_rows_read_words_1,
      write_address => coarserows_search_rows_read_words_1_memory_write_address, write_data => coarserows_search_rows_read_words_1_memory_write_data);

  coarserows_search_rows_read_words_0_memory_read_enable <= true;
  coarserows_search_rows_read_words_0_memory_read_address <= to_unsigned(coarsedelay_column, 5);
  coarserows_search_rows_read_words_0_memory_write_address <= to_unsigned(coarserows_write_column, 5);
  coarserows_search_rows_read_words_0_memory_write_data <= to_unsigned(coarserows_search_rows_write_words_0, 30);
  coarserows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 30, address_bits => 5)
    port map (
      clock => clock, read_enable => coarserows_search_rows_read_words_0_memory_read_enable,
      read_address => coarserows_search_rows_read_words_0_memory_read_address, read_data => coarserows_search_rows_read_words_0,
      write_address => coarserows_search_rows_read_words_0_memory_write_address, write_data => coarserows_search_rows_read_words_0_memory_write_data);

  coarserows_reference_rows_read_words_1_memory_read_enable <= true;
  coarserows_reference_rows_read_words_1_memory_read_address <= to_unsigned(coarsedelay_column, 5);
  coarserows_reference_rows_read_words_1_memory_write_address <= to_unsigned(coarserows_write_column, 5);
  coarserows_reference_rows_read_words_1_memory_write_data <= to_unsigned(coarserows_reference_rows_write_words_1, 6);
  coarserows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 6, address_bits => 5)
    port map (
      clock => clock, read_enable => coarserows_reference_rows_read_words_1_memory_read_enable,
      read_address => coarserows_reference_rows_read_words_1_memory_read_address, read_data => coarserows_reference_rows_read_words_1,
      write_address => coarserows_reference_rows_read_words_1_memory_write_address, write_data => coarserows_reference_rows_read_words_1_memory_write_data);

  coarserows_reference_rows_read_words_0_memory_read_enable <= true;
  coarserows_reference_rows_read_words_0_memory_read_address <= to_unsigned(coarsedelay_column, 5);
  coarserows_reference_rows_read_words_0_memory_write_address <= to_unsigned(coarserows_write_column, 5);
  coarserows_reference_rows_read_words_0_memory_write_data <= to_unsigned(coarserows_reference_rows_write_words_0, 30);
  coarserows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 30, address_bits => 5)
    port map (
      clock => clock, read_enable => coarserows_reference_rows_read_words_0_memory_read_enable,
      read_address => coarserows_reference_rows_read_words_0_memory_read_address, read_data => coarserows_reference_rows_read_words_0,
      write_address => coarserows_reference_rows_read_words_0_memory_write_address, write_data => coarserows_reference_rows_read_words_0_memory_write_data);

  coarsedelay_delayed_0_memory_read_enable <= true;
  coarsedelay_delayed_0_memory_read_address <= to_unsigned(coarsedelay_ring_read_address, 3);
  coarsedelay_delayed_0_memory_write_address <= to_unsigned(coarsedelay_ring_write_address, 3);
  coarsedelay_delayed_0_memory_write_data <= to_unsigned(coarseraster_features_reference_0, 6);
  coarsedelay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 6, address_bits => 3)
    port map (
      clock => clock, read_enable => coarsedelay_delayed_0_memory_read_enable,
      read_address => coarsedelay_delayed_0_memory_read_address, read_data => coarsedelay_delayed_0,
      write_address => coarsedelay_delayed_0_memory_write_address, write_data => coarsedelay_delayed_0_memory_write_data);

  coarsetransform_left_rows_read_words_1_memory_read_enable <= true;
  coarsetransform_left_rows_read_words_1_memory_read_address <= to_unsigned(coarsetransform_counter_column, 5);
  coarsetransform_left_rows_read_words_1_memory_write_address <= to_unsigned(coarsetransform_write_column, 5);
  coarsetransform_left_rows_read_words_1_memory_write_data <= to_unsigned((coarsetransform_left_rows_write_words_1 mod 16777216), 24);
  coarsetransform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => coarsetransform_left_rows_read_words_1_memory_read_enable,
      read_address => coarsetransform_left_rows_read_words_1_memory_read_address, read_data => coarsetransform_left_rows_read_words_1,
      write_address => coarsetransform_left_rows_read_words_1_memory_write_address, write_data => coarsetransform_left_rows_read_words_1_memory_write_data);

  coarsetransform_left_rows_read_words_0_memory_read_enable <= true;
  coarsetransform_left_rows_read_words_0_memory_read_address <= to_unsigned(coarsetransform_counter_column, 5);
  coarsetransform_left_rows_read_words_0_memory_write_address <= to_unsigned(coarsetransform_write_column, 5);
  coarsetransform_left_rows_read_words_0_memory_write_data <= to_unsigned(coarsetransform_left_rows_write_words_0, 24);
  coarsetransform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => coarsetransform_left_rows_read_words_0_memory_read_enable,
      read_address => coarsetransform_left_rows_read_words_0_memory_read_address, read_data => coarsetransform_left_rows_read_words_0,
      write_address => coarsetransform_left_rows_read_words_0_memory_write_address, write_data => coarsetransform_left_rows_read_words_0_memory_write_data);

  coarsetransform_right_rows_read_words_1_memory_read_enable <= true;
  coarsetransform_right_rows_read_words_1_memory_read_address <= to_unsigned(coarsetransform_counter_column, 5);
  coarsetransform_right_rows_read_words_1_memory_write_address <= to_unsigned(coarsetransform_write_column, 5);
  coarsetransform_right_rows_read_words_1_memory_write_data <= to_unsigned((coarsetransform_right_rows_write_words_1 mod 16777216), 24);
  coarsetransform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => coarsetransform_right_rows_read_words_1_memory_read_enable,
      read_address => coarsetransform_right_rows_read_words_1_memory_read_address, read_data => coarsetransform_right_rows_read_words_1,
      write_address => coarsetransform_right_rows_read_words_1_memory_write_address, write_data => coarsetransform_right_rows_read_words_1_memory_write_data);

  coarsetransform_right_rows_read_words_0_memory_read_enable <= true;
  coarsetransform_right_rows_read_words_0_memory_read_address <= to_unsigned(coarsetransform_counter_column, 5);
  coarsetransform_right_rows_read_words_0_memory_write_address <= to_unsigned(coarsetransform_write_column, 5);
  coarsetransform_right_rows_read_words_0_memory_write_data <= to_unsigned(coarsetransform_right_rows_write_words_0, 24);
  coarsetransform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => coarsetransform_right_rows_read_words_0_memory_read_enable,
      read_address => coarsetransform_right_rows_read_words_0_memory_read_address, read_data => coarsetransform_right_rows_read_words_0,
      write_address => coarsetransform_right_rows_read_words_0_memory_write_address, write_data => coarsetransform_right_rows_read_words_0_memory_write_data);

  coarse_pixels_read_word_0_memory_read_enable <= true;
  coarse_pixels_read_word_0_memory_read_address <= to_unsigned(coarse_pixels_sum_column, 4);
  coarse_pixels_read_word_0_memory_write_address <= to_unsigned(coarse_pixels_total_column, 4);
  coarse_pixels_read_word_0_memory_write_data <= coarse_pixels_total;
  coarse_pixels_read_word_0_memory : entity work.line_memory
    generic map (depth => 16, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => coarse_pixels_read_word_0_memory_read_enable,
      read_address => coarse_pixels_read_word_0_memory_read_address, read_data => coarse_pixels_read_word_0,
      write_address => coarse_pixels_read_word_0_memory_write_address, write_data => coarse_pixels_read_word_0_memory_write_data);

  process (clock)
    variable coarse_pixels_column_any, coarse_pixels_column_is_equal, coarse_pixels_column_is_equal_2 : boolean;
    variable coarse_pixels_column_all, coarse_pixels_first_row_is_equal, coarse_pixels_first_row_choice : boolean;
    variable coarse_pixels_repetition_differs, coarse_pixels_out_valid_all, coarse_pixels_left_sum_is_equal : boolean;
    variable coarsetransform_counter_group_is_equal, coarsetransform_counter_group_is_equal_2 : boolean;
    variable coarsetransform_counter_group_all, coarsetransform_counter_group_any : boolean;
    variable coarsetransform_counter_next_frame_choice, coarsetransform_counter_next_frame_choice_2 : boolean;
    variable coarsetransform_counter_next_frame_choice_3, coarsetransform_centre_group_any : boolean;
    variable coarsetransform_from_first_0_value, coarsetransform_from_first_0_differs : boolean;
    variable coarsetransform_from_first_0_value_2, coarseraster_place_group_all : boolean;
    variable coarseraster_place_group_is_equal, coarseraster_place_group_is_equal_2 : boolean;
    variable coarseraster_place_group_is_equal_3, coarseraster_place_group_choice : boolean;
    variable coarseraster_place_next_frame_choice, coarseraster_place_next_frame_choice_2 : boolean;
    variable coarseraster_place_next_frame_choice_3, coarseraster_place_next_frame_choice_4 : boolean;
    variable coarsedelay_row_inside_3_is_not_less, coarsedelay_row_inside_3_is_less : boolean;
    variable coarsedelay_tag_first_cost_is_equal, coarsedelay_tag_map_column_is_not_less : boolean;
    variable coarsedelay_tag_map_column_is_less, coarseslice0cost_pixels_first_0_0_value : boolean;
    variable coarseslice0cost_pixels_first_0_0_value_2, coarseslice0cost_pixels_first_0_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_0_0_value_4, coarseslice0cost_pixels_first_1_0_value : boolean;
    variable coarseslice0cost_pixels_first_1_0_value_2, coarseslice0cost_pixels_first_1_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_1_0_value_4, coarseslice0cost_pixels_first_2_0_value : boolean;
    variable coarseslice0cost_pixels_first_2_0_value_2, coarseslice0cost_pixels_first_2_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_2_0_value_4, coarseslice0cost_pixels_first_3_0_value : boolean;
    variable coarseslice0cost_pixels_first_3_0_value_2, coarseslice0cost_pixels_first_3_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_3_0_value_4, coarseslice0cost_pixels_first_4_0_value : boolean;
    variable coarseslice0cost_pixels_first_4_0_value_2, coarseslice0cost_pixels_first_4_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_4_0_value_4, coarseslice0cost_pixels_first_5_0_value : boolean;
    variable coarseslice0cost_pixels_first_5_0_value_2, coarseslice0cost_pixels_first_5_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_5_0_value_4, coarseslice0cost_pixels_first_6_0_value : boolean;
    variable coarseslice0cost_pixels_first_6_0_value_2, coarseslice0cost_pixels_first_6_0_value_3 : boolean;
    variable coarseslice0cost_pixels_first_6_0_value_4, coarseslice0other_cost_0_1_all : boolean;
    variable coarseslice0other_cost_0_1_choice, coarseslice0other_cost_0_2_choice : boolean;
    variable coarseslice0other_cost_0_3_choice, coarseslice0other_cost_0_4_choice : boolean;
    variable coarseslice0other_cost_0_5_choice, coarseslice0other_cost_0_6_choice : boolean;
    variable coarseslice0winner1_of_pair_0_0_is_less, coarseslice0winner1_of_pair_0_2_is_less : boolean;
    variable coarseslice0winner1_of_pair_0_4_is_less, coarseslice0winner1_of_pair_0_6_is_less : boolean;
    variable coarseslice0winner1_of_four_0_0_is_less, coarseslice0winner1_of_four_0_4_is_less : boolean;
    variable coarseleftright_holds_winners_all, ranges_column_choice, ranges_column_choice_2 : boolean;
    variable ranges_column_all, ranges_column_all_2, ranges_column_any, ranges_column_choice_3 : boolean;
    variable ranges_column_choice_4, ranges_column_is_equal, ranges_column_any_2, ranges_column_any_3 : boolean;
    variable ranges_row_all, ranges_row_choice_2, ranges_row_choice_3, ranges_pixel_0_choice : boolean;
    variable ranges_centre_valid_differs, ranges_pair_0_value, ranges_pair_0_choice, ranges_pair_0_choice_2 : boolean;
    variable ranges_pair_0_value_2, ranges_pair_0_choice_3, ranges_pair_0_choice_4, ranges_pair_0_choice_7 : boolean;
    variable ranges_pair_0_choice_8, ranges_pair_0_choice_9, ranges_range_value, ranges_range_choice : boolean;
    variable ranges_range_choice_2, ranges_range_value_2, ranges_range_value_3, ranges_range_choice_3 : boolean;
    variable ranges_range_choice_4, ranges_range_value_4, ranges_range_choice_6, ranges_range_choice_7 : boolean;
    variable ranges_range_choice_8, ranges_range_choice_9, ranges_next_above_value, ranges_next_above_value_2 : boolean;
    variable targets_pause_all, targets_pause_is_equal, targets_walked_is_equal, targets_walked_all : boolean;
    variable targets_walked_any, targets_walked_all_2, targets_walked_all_3, targets_again_choice : boolean;
    variable targets_again_choice_2, targets_column_range_value, targets_column_range_all : boolean;
    variable targets_column_range_choice, targets_column_range_choice_2, targets_column_range_value_2 : boolean;
    variable targets_column_range_choice_3, targets_column_range_any, targets_column_range_all_2 : boolean;
    variable targets_column_range_value_3, targets_column_range_value_4, targets_column_range_choice_4 : boolean;
    variable targets_column_range_choice_5, targets_column_range_choice_6, targets_column_range_value_5 : boolean;
    variable targets_column_range_value_6, targets_column_range_choice_7, targets_column_range_choice_8 : boolean;
    variable targets_column_range_choice_9, targets_column_range_choice_10, targets_column_range_value_7 : boolean;
    variable targets_column_range_value_8, targets_column_range_choice_11, targets_column_range_choice_12 : boolean;
    variable targets_column_range_choice_13, targets_column_range_choice_14, targets_column_range_choice_15 : boolean;
    variable targets_column_range_choice_16, targets_column_range_all_3, targets_column_range_choice_17 : boolean;
    variable targets_column_range_choice_18, targets_column_range_choice_19, targets_column_range_choice_20 : boolean;
    variable targets_column_range_choice_21, targets_column_range_all_4, targets_column_range_choice_22 : boolean;
    variable targets_column_range_value_12, targets_column_range_value_13, targets_column_range_choice_30 : boolean;
    variable targets_column_range_choice_31, targets_column_range_choice_32, targets_column_range_value_14 : boolean;
    variable targets_column_range_value_15, targets_column_range_choice_33, targets_column_range_choice_34 : boolean;
    variable targets_column_range_choice_35, targets_column_range_choice_36, targets_column_range_value_16 : boolean;
    variable targets_column_range_choice_37, targets_column_range_choice_38, targets_column_range_choice_39 : boolean;
    variable targets_column_range_choice_40, targets_column_range_choice_41, targets_column_range_all_5 : boolean;
    variable targets_column_range_choice_42, targets_column_range_choice_43, targets_column_range_choice_44 : boolean;
    variable targets_column_range_choice_45, targets_column_range_choice_46, targets_column_range_choice_47 : boolean;
    variable targets_around_is_equal, targets_around_choice, targets_around_value, targets_around_value_2 : boolean;
    variable targets_around_differs, targets_around_value_3, targets_around_value_4, targets_around_choice_2 : boolean;
    variable targets_around_value_5, targets_around_value_6, targets_around_choice_3, targets_around_all : boolean;
    variable targets_around_all_2, targets_around_choice_4, targets_around_choice_5, targets_around_choice_6 : boolean;
    variable targets_around_value_7, targets_around_choice_7, targets_around_choice_8, targets_around_value_8 : boolean;
    variable targets_around_choice_9, targets_around_choice_10, targets_around_choice_11 : boolean;
    variable targets_around_choice_12, targets_around_choice_13, targets_around_value_9 : boolean;
    variable targets_around_value_10, targets_around_value_11, targets_around_value_12 : boolean;
    variable targets_around_choice_19, targets_around_choice_20, targets_around_choice_21 : boolean;
    variable targets_around_choice_22, targets_around_choice_23, targets_around_all_3 : boolean;
    variable targets_around_value_13, targets_around_choice_24, targets_around_choice_25 : boolean;
    variable targets_around_choice_26, targets_around_all_4, targets_around_choice_27 : boolean;
    variable targets_around_choice_28, targets_low_all, targets_low_differs, hold_back_holds_groups_any : boolean;
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3, transform_from_first_1_choice : boolean;
    variable transform_up_to_last_0_all, transform_up_to_last_0_is_equal, transform_up_to_last_0_choice : boolean;
    variable transform_up_to_last_1_choice, transform_counter_next_frame_choice, ahead_holds_groups_is_equal : boolean;
    variable raster_place_group_is_equal, bases_address_0_is_equal, bases_asked_frame_starts_is_equal : boolean;
    variable bases_asked_frame_starts_is_equal_2, bases_rises_0_0_all, bases_rises_0_1_all : boolean;
    variable bases_rises_1_0_all, bases_rises_1_1_all, bases_falls_0_0_all, bases_falls_0_1_all : boolean;
    variable bases_falls_1_0_all, bases_falls_1_1_all, rows_newest_column_any, rows_newest_column_is_equal : boolean;
    variable rows_newest_row_is_equal, rows_enter_row_all, rows_write_codes_0_all : boolean;
    variable pairs_tag_first_cost_is_equal, lowchain_lane_0_0_all, lowchain_lane_1_0_choice : boolean;
    variable lowcost_pixels_first_0_0_value, lowcost_pixels_first_0_0_value_2 : boolean;
    variable lowcost_pixels_first_0_0_choice, lowcost_pixels_first_0_0_value_3 : boolean;
    variable lowcost_pixels_first_0_0_value_4, lowcost_pixels_first_0_0_choice_2 : boolean;
    variable lowcost_pixels_first_0_0_value_5, lowcost_pixels_first_0_0_value_6 : boolean;
    variable lowcost_pixels_first_0_0_choice_3, lowcost_pixels_first_0_0_choice_4 : boolean;
    variable lowcost_pixels_first_0_0_value_7, lowcost_pixels_first_0_0_value_8 : boolean;
    variable lowcost_pixels_first_0_0_choice_5, lowcost_pixels_first_0_0_value_9 : boolean;
    variable lowcost_pixels_first_0_0_value_10, lowcost_pixels_first_0_0_choice_6 : boolean;
    variable lowcost_pixels_first_0_0_value_11, lowcost_pixels_first_0_0_value_12 : boolean;
    variable lowcost_pixels_first_0_0_choice_7, lowcost_pixels_first_0_0_value_13 : boolean;
    variable lowcost_pixels_first_0_0_value_14, lowcost_pixels_first_0_0_choice_8 : boolean;
    variable lowcost_pixels_first_0_0_value_15, lowcost_pixels_first_0_0_value_16 : boolean;
    variable lowcost_pixels_first_0_0_choice_9, lowcost_pixels_first_0_0_value_17 : boolean;
    variable lowcost_pixels_first_0_0_value_18, lowcost_pixels_first_0_0_choice_10 : boolean;
    variable lowcost_pixels_first_0_0_choice_11, lowcost_pixels_first_0_0_value_19 : boolean;
    variable lowcost_pixels_first_0_0_value_20, lowcost_pixels_first_0_0_choice_12 : boolean;
    variable lowcost_pixels_first_0_1_differs, lowcost_pixels_first_0_1_choice : boolean;
    variable lowcost_pixels_first_0_1_differs_2, lowcost_pixels_first_0_1_choice_2 : boolean;
    variable lowcost_pixels_first_0_1_differs_3, lowcost_pixels_first_0_1_choice_3 : boolean;
    variable lowcost_pixels_first_0_1_differs_4, lowcost_pixels_first_0_1_choice_4 : boolean;
    variable lowcost_pixels_first_0_1_differs_5, lowcost_pixels_first_0_1_choice_5 : boolean;
    variable lowcost_pixels_first_0_1_differs_6, lowcost_pixels_first_0_1_choice_6 : boolean;
    variable lowcost_pixels_first_0_1_differs_7, lowcost_pixels_first_0_1_choice_7 : boolean;
    variable lowcost_pixels_first_0_1_differs_8, lowcost_pixels_first_0_1_choice_8 : boolean;
    variable lowcost_pixels_first_0_1_differs_9, lowcost_pixels_first_0_1_choice_9 : boolean;
    variable lowcost_pixels_first_0_1_differs_10, lowcost_pixels_first_0_1_choice_10 : boolean;
    variable lowcost_pixels_first_0_1_differs_11, lowcost_pixels_first_0_1_choice_11 : boolean;
    variable lowcost_pixels_first_0_1_differs_12, lowcost_pixels_first_0_1_choice_12 : boolean;
    variable lowcost_pixels_first_0_2_choice, lowcost_pixels_first_0_2_choice_2 : boolean;
    variable lowcost_pixels_first_0_2_choice_3, lowcost_pixels_first_0_2_choice_4 : boolean;
    variable lowcost_pixels_first_0_2_choice_5, lowcost_pixels_first_0_2_choice_6 : boolean;
    variable lowcost_pixels_first_0_2_choice_7, lowcost_pixels_first_0_2_choice_8 : boolean;
    variable lowcost_pixels_first_0_2_choice_9, lowcost_pixels_first_0_2_choice_10 : boolean;
    variable lowcost_pixels_first_0_2_choice_11, lowcost_pixels_first_0_2_choice_12 : boolean;
    variable lowcost_pixels_first_0_3_choice, lowcost_pixels_first_0_3_choice_2 : boolean;
    variable lowcost_pixels_first_0_3_choice_3, lowcost_pixels_first_0_3_choice_4 : boolean;
    variable lowcost_pixels_first_0_3_choice_5, lowcost_pixels_first_0_3_choice_6 : boolean;
    variable lowcost_pixels_first_0_3_choice_7, lowcost_pixels_first_0_3_choice_8 : boolean;
    variable lowcost_pixels_first_0_3_choice_9, lowcost_pixels_first_0_3_choice_10 : boolean;
    variable lowcost_pixels_first_0_3_choice_11, lowcost_pixels_first_0_3_choice_12 : boolean;
    variable lowcost_pixels_first_0_4_choice, lowcost_pixels_first_0_4_choice_2 : boolean;
    variable lowcost_pixels_first_0_4_choice_3, lowcost_pixels_first_0_4_choice_4 : boolean;
    variable lowcost_pixels_first_0_4_choice_5, lowcost_pixels_first_0_4_choice_6 : boolean;
    variable lowcost_pixels_first_0_4_choice_7, lowcost_pixels_first_0_4_choice_8 : boolean;
    variable lowcost_pixels_first_0_4_choice_9, lowcost_pixels_first_0_4_choice_10 : boolean;
    variable lowcost_pixels_first_0_4_choice_11, lowcost_pixels_first_0_4_choice_12 : boolean;
    variable lowcost_pixels_first_0_5_choice, lowcost_pixels_first_0_5_choice_2 : boolean;
    variable lowcost_pixels_first_0_5_choice_3, lowcost_pixels_first_0_5_choice_4 : boolean;
    variable lowcost_pixels_first_0_5_choice_5, lowcost_pixels_first_0_5_choice_6 : boolean;
    variable lowcost_pixels_first_0_5_choice_7, lowcost_pixels_first_0_5_choice_8 : boolean;
    variable lowcost_pixels_first_0_5_choice_9, lowcost_pixels_first_0_5_choice_10 : boolean;
    variable lowcost_pixels_first_0_5_choice_11, lowcost_pixels_first_0_5_choice_12 : boolean;
    variable lowcost_pixels_first_0_6_choice, lowcost_pixels_first_0_6_choice_2 : boolean;
    variable lowcost_pixels_first_0_6_choice_3, lowcost_pixels_first_0_6_choice_4 : boolean;
    variable lowcost_pixels_first_0_6_choice_5, lowcost_pixels_first_0_6_choice_6 : boolean;
    variable lowcost_pixels_first_0_6_choice_7, lowcost_pixels_first_0_6_choice_8 : boolean;
    variable lowcost_pixels_first_0_6_choice_9, lowcost_pixels_first_0_6_choice_10 : boolean;
    variable lowcost_pixels_first_0_6_choice_11, lowcost_pixels_first_0_6_choice_12 : boolean;
    variable lowcost_pixels_first_0_7_choice, lowcost_pixels_first_0_7_choice_2 : boolean;
    variable lowcost_pixels_first_0_7_choice_3, lowcost_pixels_first_0_7_choice_4 : boolean;
    variable lowcost_pixels_first_0_7_choice_5, lowcost_pixels_first_0_7_choice_6 : boolean;
    variable lowcost_pixels_first_0_7_choice_7, lowcost_pixels_first_0_7_choice_8 : boolean;
    variable lowcost_pixels_first_0_7_choice_9, lowcost_pixels_first_0_7_choice_10 : boolean;
    variable lowcost_pixels_first_0_7_choice_11, lowcost_pixels_first_0_7_choice_12 : boolean;
    variable lowcost_pixels_first_0_8_choice, lowcost_pixels_first_0_8_choice_2 : boolean;
    variable lowcost_pixels_first_0_8_choice_3, lowcost_pixels_first_0_8_choice_4 : boolean;
    variable lowcost_pixels_first_0_8_choice_5, lowcost_pixels_first_0_8_choice_6 : boolean;
    variable lowcost_pixels_first_0_8_choice_7, lowcost_pixels_first_0_8_choice_8 : boolean;
    variable lowcost_pixels_first_0_8_choice_9, lowcost_pixels_first_0_8_choice_10 : boolean;
    variable lowcost_pixels_first_0_8_choice_11, lowcost_pixels_first_0_8_choice_12 : boolean;
    variable lowcost_pixels_first_0_9_choice, lowcost_pixels_first_0_9_choice_2 : boolean;
    variable lowcost_pixels_first_0_9_choice_3, lowcost_pixels_first_0_9_choice_4 : boolean;
    variable lowcost_pixels_first_0_9_choice_5, lowcost_pixels_first_0_9_choice_6 : boolean;
    variable lowcost_pixels_first_0_9_choice_7, lowcost_pixels_first_0_9_choice_8 : boolean;
    variable lowcost_pixels_first_0_9_choice_9, lowcost_pixels_first_0_9_choice_10 : boolean;
    variable lowcost_pixels_first_0_9_choice_11, lowcost_pixels_first_0_9_choice_12 : boolean;
    variable lowcost_pixels_first_0_10_choice, lowcost_pixels_first_0_10_choice_2 : boolean;
    variable lowcost_pixels_first_0_10_choice_3, lowcost_pixels_first_0_10_choice_4 : boolean;
    variable lowcost_pixels_first_0_10_choice_5, lowcost_pixels_first_0_10_choice_6 : boolean;
    variable lowcost_pixels_first_0_10_choice_7, lowcost_pixels_first_0_10_choice_8 : boolean;
    variable lowcost_pixels_first_0_10_choice_9, lowcost_pixels_first_0_10_choice_10 : boolean;
    variable lowcost_pixels_first_0_10_choice_11, lowcost_pixels_first_0_10_choice_12 : boolean;
    variable lowcost_pixels_first_0_11_choice, lowcost_pixels_first_0_11_choice_2 : boolean;
    variable lowcost_pixels_first_0_11_choice_3, lowcost_pixels_first_0_11_choice_4 : boolean;
    variable lowcost_pixels_first_0_11_choice_5, lowcost_pixels_first_0_11_choice_6 : boolean;
    variable lowcost_pixels_first_0_11_choice_7, lowcost_pixels_first_0_11_choice_8 : boolean;
    variable lowcost_pixels_first_0_11_choice_9, lowcost_pixels_first_0_11_choice_10 : boolean;
    variable lowcost_pixels_first_0_11_choice_11, lowcost_pixels_first_0_11_choice_12 : boolean;
    variable lowcost_pixels_first_0_12_choice, lowcost_pixels_first_0_12_choice_2 : boolean;
    variable lowcost_pixels_first_0_12_choice_3, lowcost_pixels_first_0_12_choice_4 : boolean;
    variable lowcost_pixels_first_0_12_choice_5, lowcost_pixels_first_0_12_choice_6 : boolean;
    variable lowcost_pixels_first_0_12_choice_7, lowcost_pixels_first_0_12_choice_8 : boolean;
    variable lowcost_pixels_first_0_12_choice_9, lowcost_pixels_first_0_12_choice_10 : boolean;
    variable lowcost_pixels_first_0_12_choice_11, lowcost_pixels_first_0_12_choice_12 : boolean;
    variable lowcost_pixels_first_0_13_choice, lowcost_pixels_first_0_13_choice_2 : boolean;
    variable lowcost_pixels_first_0_13_choice_3, lowcost_pixels_first_0_13_choice_4 : boolean;
    variable lowcost_pixels_first_0_13_choice_5, lowcost_pixels_first_0_13_choice_6 : boolean;
    variable lowcost_pixels_first_0_13_choice_7, lowcost_pixels_first_0_13_choice_8 : boolean;
    variable lowcost_pixels_first_0_13_choice_9, lowcost_pixels_first_0_13_choice_10 : boolean;
    variable lowcost_pixels_first_0_13_choice_11, lowcost_pixels_first_0_13_choice_12 : boolean;
    variable lowcost_pixels_first_0_14_choice, lowcost_pixels_first_0_14_choice_2 : boolean;
    variable lowcost_pixels_first_0_14_choice_3, lowcost_pixels_first_0_14_choice_4 : boolean;
    variable lowcost_pixels_first_0_14_choice_5, lowcost_pixels_first_0_14_choice_6 : boolean;
    variable lowcost_pixels_first_0_14_choice_7, lowcost_pixels_first_0_14_choice_8 : boolean;
    variable lowcost_pixels_first_0_14_choice_9, lowcost_pixels_first_0_14_choice_10 : boolean;
    variable lowcost_pixels_first_0_14_choice_11, lowcost_pixels_first_0_14_choice_12 : boolean;
    variable lowcost_pixels_first_0_15_choice, lowcost_pixels_first_0_15_choice_2 : boolean;
    variable lowcost_pixels_first_0_15_choice_3, lowcost_pixels_first_0_15_choice_4 : boolean;
    variable lowcost_pixels_first_0_15_choice_5, lowcost_pixels_first_0_15_choice_6 : boolean;
    variable lowcost_pixels_first_0_15_choice_7, lowcost_pixels_first_0_15_choice_8 : boolean;
    variable lowcost_pixels_first_0_15_choice_9, lowcost_pixels_first_0_15_choice_10 : boolean;
    variable lowcost_pixels_first_0_15_choice_11, lowcost_pixels_first_0_15_choice_12 : boolean;
    variable lowcost_pixels_first_1_0_value, lowcost_pixels_first_1_0_value_2 : boolean;
    variable lowcost_pixels_first_1_0_choice, lowcost_pixels_first_1_0_value_3 : boolean;
    variable lowcost_pixels_first_1_0_value_4, lowcost_pixels_first_1_0_choice_2 : boolean;
    variable lowcost_pixels_first_1_0_value_5, lowcost_pixels_first_1_0_value_6 : boolean;
    variable lowcost_pixels_first_1_0_choice_3, lowcost_pixels_first_1_0_choice_4 : boolean;
    variable lowcost_pixels_first_1_0_value_7, lowcost_pixels_first_1_0_value_8 : boolean;
    variable lowcost_pixels_first_1_0_choice_5, lowcost_pixels_first_1_0_value_9 : boolean;
    variable lowcost_pixels_first_1_0_value_10, lowcost_pixels_first_1_0_choice_6 : boolean;
    variable lowcost_pixels_first_1_0_value_11, lowcost_pixels_first_1_0_value_12 : boolean;
    variable lowcost_pixels_first_1_0_choice_7, lowcost_pixels_first_1_0_value_13 : boolean;
    variable lowcost_pixels_first_1_0_value_14, lowcost_pixels_first_1_0_choice_8 : boolean;
    variable lowcost_pixels_first_1_0_value_15, lowcost_pixels_first_1_0_value_16 : boolean;
    variable lowcost_pixels_first_1_0_choice_9, lowcost_pixels_first_1_0_value_17 : boolean;
    variable lowcost_pixels_first_1_0_value_18, lowcost_pixels_first_1_0_choice_10 : boolean;
    variable lowcost_pixels_first_1_0_choice_11, lowcost_pixels_first_1_0_value_19 : boolean;
    variable lowcost_pixels_first_1_0_value_20, lowcost_pixels_first_1_0_choice_12 : boolean;
    variable lowcost_pixels_first_1_1_differs, lowcost_pixels_first_1_1_choice : boolean;
    variable lowcost_pixels_first_1_1_differs_2, lowcost_pixels_first_1_1_choice_2 : boolean;
    variable lowcost_pixels_first_1_1_differs_3, lowcost_pixels_first_1_1_choice_3 : boolean;
    variable lowcost_pixels_first_1_1_differs_4, lowcost_pixels_first_1_1_choice_4 : boolean;
    variable lowcost_pixels_first_1_1_differs_5, lowcost_pixels_first_1_1_choice_5 : boolean;
    variable lowcost_pixels_first_1_1_differs_6, lowcost_pixels_first_1_1_choice_6 : boolean;
    variable lowcost_pixels_first_1_1_differs_7, lowcost_pixels_first_1_1_choice_7 : boolean;
    variable lowcost_pixels_first_1_1_differs_8, lowcost_pixels_first_1_1_choice_8 : boolean;
    variable lowcost_pixels_first_1_1_differs_9, lowcost_pixels_first_1_1_choice_9 : boolean;
    variable lowcost_pixels_first_1_1_differs_10, lowcost_pixels_first_1_1_choice_10 : boolean;
    variable lowcost_pixels_first_1_1_differs_11, lowcost_pixels_first_1_1_choice_11 : boolean;
    variable lowcost_pixels_first_1_1_differs_12, lowcost_pixels_first_1_1_choice_12 : boolean;
    variable lowcost_pixels_first_1_2_choice, lowcost_pixels_first_1_2_choice_2 : boolean;
    variable lowcost_pixels_first_1_2_choice_3, lowcost_pixels_first_1_2_choice_4 : boolean;
    variable lowcost_pixels_first_1_2_choice_5, lowcost_pixels_first_1_2_choice_6 : boolean;
    variable lowcost_pixels_first_1_2_choice_7, lowcost_pixels_first_1_2_choice_8 : boolean;
    variable lowcost_pixels_first_1_2_choice_9, lowcost_pixels_first_1_2_choice_10 : boolean;
    variable lowcost_pixels_first_1_2_choice_11, lowcost_pixels_first_1_2_choice_12 : boolean;
    variable lowcost_pixels_first_1_3_choice, lowcost_pixels_first_1_3_choice_2 : boolean;
    variable lowcost_pixels_first_1_3_choice_3, lowcost_pixels_first_1_3_choice_4 : boolean;
    variable lowcost_pixels_first_1_3_choice_5, lowcost_pixels_first_1_3_choice_6 : boolean;
    variable lowcost_pixels_first_1_3_choice_7, lowcost_pixels_first_1_3_choice_8 : boolean;
    variable lowcost_pixels_first_1_3_choice_9, lowcost_pixels_first_1_3_choice_10 : boolean;
    variable lowcost_pixels_first_1_3_choice_11, lowcost_pixels_first_1_3_choice_12 : boolean;
    variable lowcost_pixels_first_1_4_choice, lowcost_pixels_first_1_4_choice_2 : boolean;
    variable lowcost_pixels_first_1_4_choice_3, lowcost_pixels_first_1_4_choice_4 : boolean;
    variable lowcost_pixels_first_1_4_choice_5, lowcost_pixels_first_1_4_choice_6 : boolean;
    variable lowcost_pixels_first_1_4_choice_7, lowcost_pixels_first_1_4_choice_8 : boolean;
    variable lowcost_pixels_first_1_4_choice_9, lowcost_pixels_first_1_4_choice_10 : boolean;
    variable lowcost_pixels_first_1_4_choice_11, lowcost_pixels_first_1_4_choice_12 : boolean;
    variable lowcost_pixels_first_1_5_choice, lowcost_pixels_first_1_5_choice_2 : boolean;
    variable lowcost_pixels_first_1_5_choice_3, lowcost_pixels_first_1_5_choice_4 : boolean;
    variable lowcost_pixels_first_1_5_choice_5, lowcost_pixels_first_1_5_choice_6 : boolean;
    variable lowcost_pixels_first_1_5_choice_7, lowcost_pixels_first_1_5_choice_8 : boolean;
    variable lowcost_pixels_first_1_5_choice_9, lowcost_pixels_first_1_5_choice_10 : boolean;
    variable lowcost_pixels_first_1_5_choice_11, lowcost_pixels_first_1_5_choice_12 : boolean;
    variable lowcost_pixels_first_1_6_choice, lowcost_pixels_first_1_6_choice_2 : boolean;
    variable lowcost_pixels_first_1_6_choice_3, lowcost_pixels_first_1_6_choice_4 : boolean;
    variable lowcost_pixels_first_1_6_choice_5, lowcost_pixels_first_1_6_choice_6 : boolean;
    variable lowcost_pixels_first_1_6_choice_7, lowcost_pixels_first_1_6_choice_8 : boolean;
    variable lowcost_pixels_first_1_6_choice_9, lowcost_pixels_first_1_6_choice_10 : boolean;
    variable lowcost_pixels_first_1_6_choice_11, lowcost_pixels_first_1_6_choice_12 : boolean;
    variable lowcost_pixels_first_1_7_choice, lowcost_pixels_first_1_7_choice_2 : boolean;
    variable lowcost_pixels_first_1_7_choice_3, lowcost_pixels_first_1_7_choice_4 : boolean;
    variable lowcost_pixels_first_1_7_choice_5, lowcost_pixels_first_1_7_choice_6 : boolean;
    variable lowcost_pixels_first_1_7_choice_7, lowcost_pixels_first_1_7_choice_8 : boolean;
    variable lowcost_pixels_first_1_7_choice_9, lowcost_pixels_first_1_7_choice_10 : boolean;
    variable lowcost_pixels_first_1_7_choice_11, lowcost_pixels_first_1_7_choice_12 : boolean;
    variable lowcost_pixels_first_1_8_choice, lowcost_pixels_first_1_8_choice_2 : boolean;
    variable lowcost_pixels_first_1_8_choice_3, lowcost_pixels_first_1_8_choice_4 : boolean;
    variable lowcost_pixels_first_1_8_choice_5, lowcost_pixels_first_1_8_choice_6 : boolean;
    variable lowcost_pixels_first_1_8_choice_7, lowcost_pixels_first_1_8_choice_8 : boolean;
    variable lowcost_pixels_first_1_8_choice_9, lowcost_pixels_first_1_8_choice_10 : boolean;
    variable lowcost_pixels_first_1_8_choice_11, lowcost_pixels_first_1_8_choice_12 : boolean;
    variable lowcost_pixels_first_1_9_choice, lowcost_pixels_first_1_9_choice_2 : boolean;
    variable lowcost_pixels_first_1_9_choice_3, lowcost_pixels_first_1_9_choice_4 : boolean;
    variable lowcost_pixels_first_1_9_choice_5, lowcost_pixels_first_1_9_choice_6 : boolean;
    variable lowcost_pixels_first_1_9_choice_7, lowcost_pixels_first_1_9_choice_8 : boolean;
    variable lowcost_pixels_first_1_9_choice_9, lowcost_pixels_first_1_9_choice_10 : boolean;
    variable lowcost_pixels_first_1_9_choice_11, lowcost_pixels_first_1_9_choice_12 : boolean;
    variable lowcost_pixels_first_1_10_choice, lowcost_pixels_first_1_10_choice_2 : boolean;
    variable lowcost_pixels_first_1_10_choice_3, lowcost_pixels_first_1_10_choice_4 : boolean;
    variable lowcost_pixels_first_1_10_choice_5, lowcost_pixels_first_1_10_choice_6 : boolean;
    variable lowcost_pixels_first_1_10_choice_7, lowcost_pixels_first_1_10_choice_8 : boolean;
    variable lowcost_pixels_first_1_10_choice_9, lowcost_pixels_first_1_10_choice_10 : boolean;
    variable lowcost_pixels_first_1_10_choice_11, lowcost_pixels_first_1_10_choice_12 : boolean;
    variable lowcost_pixels_first_1_11_choice, lowcost_pixels_first_1_11_choice_2 : boolean;
    variable lowcost_pixels_first_1_11_choice_3, lowcost_pixels_first_1_11_choice_4 : boolean;
    variable lowcost_pixels_first_1_11_choice_5, lowcost_pixels_first_1_11_choice_6 : boolean;
    variable lowcost_pixels_first_1_11_choice_7, lowcost_pixels_first_1_11_choice_8 : boolean;
    variable lowcost_pixels_first_1_11_choice_9, lowcost_pixels_first_1_11_choice_10 : boolean;
    variable lowcost_pixels_first_1_11_choice_11, lowcost_pixels_first_1_11_choice_12 : boolean;
    variable lowcost_pixels_first_1_12_choice, lowcost_pixels_first_1_12_choice_2 : boolean;
    variable lowcost_pixels_first_1_12_choice_3, lowcost_pixels_first_1_12_choice_4 : boolean;
    variable lowcost_pixels_first_1_12_choice_5, lowcost_pixels_first_1_12_choice_6 : boolean;
    variable lowcost_pixels_first_1_12_choice_7, lowcost_pixels_first_1_12_choice_8 : boolean;
    variable lowcost_pixels_first_1_12_choice_9, lowcost_pixels_first_1_12_choice_10 : boolean;
    variable lowcost_pixels_first_1_12_choice_11, lowcost_pixels_first_1_12_choice_12 : boolean;
    variable lowcost_pixels_first_1_13_choice, lowcost_pixels_first_1_13_choice_2 : boolean;
    variable lowcost_pixels_first_1_13_choice_3, lowcost_pixels_first_1_13_choice_4 : boolean;
    variable lowcost_pixels_first_1_13_choice_5, lowcost_pixels_first_1_13_choice_6 : boolean;
    variable lowcost_pixels_first_1_13_choice_7, lowcost_pixels_first_1_13_choice_8 : boolean;
    variable lowcost_pixels_first_1_13_choice_9, lowcost_pixels_first_1_13_choice_10 : boolean;
    variable lowcost_pixels_first_1_13_choice_11, lowcost_pixels_first_1_13_choice_12 : boolean;
    variable lowcost_pixels_first_1_14_choice, lowcost_pixels_first_1_14_choice_2 : boolean;
    variable lowcost_pixels_first_1_14_choice_3, lowcost_pixels_first_1_14_choice_4 : boolean;
    variable lowcost_pixels_first_1_14_choice_5, lowcost_pixels_first_1_14_choice_6 : boolean;
    variable lowcost_pixels_first_1_14_choice_7, lowcost_pixels_first_1_14_choice_8 : boolean;
    variable lowcost_pixels_first_1_14_choice_9, lowcost_pixels_first_1_14_choice_10 : boolean;
    variable lowcost_pixels_first_1_14_choice_11, lowcost_pixels_first_1_14_choice_12 : boolean;
    variable lowcost_pixels_first_1_15_choice, lowcost_pixels_first_1_15_choice_2 : boolean;
    variable lowcost_pixels_first_1_15_choice_3, lowcost_pixels_first_1_15_choice_4 : boolean;
    variable lowcost_pixels_first_1_15_choice_5, lowcost_pixels_first_1_15_choice_6 : boolean;
    variable lowcost_pixels_first_1_15_choice_7, lowcost_pixels_first_1_15_choice_8 : boolean;
    variable lowcost_pixels_first_1_15_choice_9, lowcost_pixels_first_1_15_choice_10 : boolean;
    variable lowcost_pixels_first_1_15_choice_11, lowcost_pixels_first_1_15_choice_12 : boolean;
    variable lowwinner1_of_pair_0_0_is_less, lowwinner1_of_pair_0_2_is_less, lowwinner1_of_pair_0_4_is_less : boolean;
    variable lowwinner1_of_pair_0_6_is_less, lowwinner1_of_pair_0_8_is_less, lowwinner1_of_pair_0_10_is_less : boolean;
    variable lowwinner1_of_pair_0_12_is_less, lowwinner1_of_pair_0_14_is_less, lowwinner1_of_four_0_0_is_less : boolean;
    variable lowwinner1_of_four_0_4_is_less, lowwinner1_of_four_0_8_is_less, lowwinner1_of_four_0_12_is_less : boolean;
    variable lowwinner2_of_pair_0_0_is_less, lowwinner2_of_pair_0_2_is_less, lowwinner2_of_four_0_0_is_less : boolean;
    variable highchain_lane_0_0_choice, highchain_lane_1_0_choice, highcost_pixels_first_0_0_choice : boolean;
    variable highcost_pixels_first_0_0_choice_2, highcost_pixels_first_0_0_choice_3 : boolean;
    variable highcost_pixels_first_0_0_choice_4, highcost_pixels_first_0_0_choice_5 : boolean;
    variable highcost_pixels_first_0_0_choice_6, highcost_pixels_first_0_0_choice_7 : boolean;
    variable highcost_pixels_first_0_0_choice_8, highcost_pixels_first_0_0_choice_9 : boolean;
    variable highcost_pixels_first_0_0_choice_10, highcost_pixels_first_0_0_choice_11 : boolean;
    variable highcost_pixels_first_0_0_choice_12, highcost_pixels_first_0_1_choice : boolean;
    variable highcost_pixels_first_0_1_choice_2, highcost_pixels_first_0_1_choice_3 : boolean;
    variable highcost_pixels_first_0_1_choice_4, highcost_pixels_first_0_1_choice_5 : boolean;
    variable highcost_pixels_first_0_1_choice_6, highcost_pixels_first_0_1_choice_7 : boolean;
    variable highcost_pixels_first_0_1_choice_8, highcost_pixels_first_0_1_choice_9 : boolean;
    variable highcost_pixels_first_0_1_choice_10, highcost_pixels_first_0_1_choice_11 : boolean;
    variable highcost_pixels_first_0_1_choice_12, highcost_pixels_first_0_2_choice : boolean;
    variable highcost_pixels_first_0_2_choice_2, highcost_pixels_first_0_2_choice_3 : boolean;
    variable highcost_pixels_first_0_2_choice_4, highcost_pixels_first_0_2_choice_5 : boolean;
    variable highcost_pixels_first_0_2_choice_6, highcost_pixels_first_0_2_choice_7 : boolean;
    variable highcost_pixels_first_0_2_choice_8, highcost_pixels_first_0_2_choice_9 : boolean;
    variable highcost_pixels_first_0_2_choice_10, highcost_pixels_first_0_2_choice_11 : boolean;
    variable highcost_pixels_first_0_2_choice_12, highcost_pixels_first_0_3_choice : boolean;
    variable highcost_pixels_first_0_3_choice_2, highcost_pixels_first_0_3_choice_3 : boolean;
    variable highcost_pixels_first_0_3_choice_4, highcost_pixels_first_0_3_choice_5 : boolean;
    variable highcost_pixels_first_0_3_choice_6, highcost_pixels_first_0_3_choice_7 : boolean;
    variable highcost_pixels_first_0_3_choice_8, highcost_pixels_first_0_3_choice_9 : boolean;
    variable highcost_pixels_first_0_3_choice_10, highcost_pixels_first_0_3_choice_11 : boolean;
    variable highcost_pixels_first_0_3_choice_12, highcost_pixels_first_0_4_choice : boolean;
    variable highcost_pixels_first_0_4_choice_2, highcost_pixels_first_0_4_choice_3 : boolean;
    variable highcost_pixels_first_0_4_choice_4, highcost_pixels_first_0_4_choice_5 : boolean;
    variable highcost_pixels_first_0_4_choice_6, highcost_pixels_first_0_4_choice_7 : boolean;
    variable highcost_pixels_first_0_4_choice_8, highcost_pixels_first_0_4_choice_9 : boolean;
    variable highcost_pixels_first_0_4_choice_10, highcost_pixels_first_0_4_choice_11 : boolean;
    variable highcost_pixels_first_0_4_choice_12, highcost_pixels_first_0_5_choice : boolean;
    variable highcost_pixels_first_0_5_choice_2, highcost_pixels_first_0_5_choice_3 : boolean;
    variable highcost_pixels_first_0_5_choice_4, highcost_pixels_first_0_5_choice_5 : boolean;
    variable highcost_pixels_first_0_5_choice_6, highcost_pixels_first_0_5_choice_7 : boolean;
    variable highcost_pixels_first_0_5_choice_8, highcost_pixels_first_0_5_choice_9 : boolean;
    variable highcost_pixels_first_0_5_choice_10, highcost_pixels_first_0_5_choice_11 : boolean;
    variable highcost_pixels_first_0_5_choice_12, highcost_pixels_first_0_6_choice : boolean;
    variable highcost_pixels_first_0_6_choice_2, highcost_pixels_first_0_6_choice_3 : boolean;
    variable highcost_pixels_first_0_6_choice_4, highcost_pixels_first_0_6_choice_5 : boolean;
    variable highcost_pixels_first_0_6_choice_6, highcost_pixels_first_0_6_choice_7 : boolean;
    variable highcost_pixels_first_0_6_choice_8, highcost_pixels_first_0_6_choice_9 : boolean;
    variable highcost_pixels_first_0_6_choice_10, highcost_pixels_first_0_6_choice_11 : boolean;
    variable highcost_pixels_first_0_6_choice_12, highcost_pixels_first_0_7_choice : boolean;
    variable highcost_pixels_first_0_7_choice_2, highcost_pixels_first_0_7_choice_3 : boolean;
    variable highcost_pixels_first_0_7_choice_4, highcost_pixels_first_0_7_choice_5 : boolean;
    variable highcost_pixels_first_0_7_choice_6, highcost_pixels_first_0_7_choice_7 : boolean;
    variable highcost_pixels_first_0_7_choice_8, highcost_pixels_first_0_7_choice_9 : boolean;
    variable highcost_pixels_first_0_7_choice_10, highcost_pixels_first_0_7_choice_11 : boolean;
    variable highcost_pixels_first_0_7_choice_12, highcost_pixels_first_0_8_choice : boolean;
    variable highcost_pixels_first_0_8_choice_2, highcost_pixels_first_0_8_choice_3 : boolean;
    variable highcost_pixels_first_0_8_choice_4, highcost_pixels_first_0_8_choice_5 : boolean;
    variable highcost_pixels_first_0_8_choice_6, highcost_pixels_first_0_8_choice_7 : boolean;
    variable highcost_pixels_first_0_8_choice_8, highcost_pixels_first_0_8_choice_9 : boolean;
    variable highcost_pixels_first_0_8_choice_10, highcost_pixels_first_0_8_choice_11 : boolean;
    variable highcost_pixels_first_0_8_choice_12, highcost_pixels_first_0_9_choice : boolean;
    variable highcost_pixels_first_0_9_choice_2, highcost_pixels_first_0_9_choice_3 : boolean;
    variable highcost_pixels_first_0_9_choice_4, highcost_pixels_first_0_9_choice_5 : boolean;
    variable highcost_pixels_first_0_9_choice_6, highcost_pixels_first_0_9_choice_7 : boolean;
    variable highcost_pixels_first_0_9_choice_8, highcost_pixels_first_0_9_choice_9 : boolean;
    variable highcost_pixels_first_0_9_choice_10, highcost_pixels_first_0_9_choice_11 : boolean;
    variable highcost_pixels_first_0_9_choice_12, highcost_pixels_first_0_10_choice : boolean;
    variable highcost_pixels_first_0_10_choice_2, highcost_pixels_first_0_10_choice_3 : boolean;
    variable highcost_pixels_first_0_10_choice_4, highcost_pixels_first_0_10_choice_5 : boolean;
    variable highcost_pixels_first_0_10_choice_6, highcost_pixels_first_0_10_choice_7 : boolean;
    variable highcost_pixels_first_0_10_choice_8, highcost_pixels_first_0_10_choice_9 : boolean;
    variable highcost_pixels_first_0_10_choice_10, highcost_pixels_first_0_10_choice_11 : boolean;
    variable highcost_pixels_first_0_10_choice_12, highcost_pixels_first_0_11_choice : boolean;
    variable highcost_pixels_first_0_11_choice_2, highcost_pixels_first_0_11_choice_3 : boolean;
    variable highcost_pixels_first_0_11_choice_4, highcost_pixels_first_0_11_choice_5 : boolean;
    variable highcost_pixels_first_0_11_choice_6, highcost_pixels_first_0_11_choice_7 : boolean;
    variable highcost_pixels_first_0_11_choice_8, highcost_pixels_first_0_11_choice_9 : boolean;
    variable highcost_pixels_first_0_11_choice_10, highcost_pixels_first_0_11_choice_11 : boolean;
    variable highcost_pixels_first_0_11_choice_12, highcost_pixels_first_0_12_choice : boolean;
    variable highcost_pixels_first_0_12_choice_2, highcost_pixels_first_0_12_choice_3 : boolean;
    variable highcost_pixels_first_0_12_choice_4, highcost_pixels_first_0_12_choice_5 : boolean;
    variable highcost_pixels_first_0_12_choice_6, highcost_pixels_first_0_12_choice_7 : boolean;
    variable highcost_pixels_first_0_12_choice_8, highcost_pixels_first_0_12_choice_9 : boolean;
    variable highcost_pixels_first_0_12_choice_10, highcost_pixels_first_0_12_choice_11 : boolean;
    variable highcost_pixels_first_0_12_choice_12, highcost_pixels_first_0_13_choice : boolean;
    variable highcost_pixels_first_0_13_choice_2, highcost_pixels_first_0_13_choice_3 : boolean;
    variable highcost_pixels_first_0_13_choice_4, highcost_pixels_first_0_13_choice_5 : boolean;
    variable highcost_pixels_first_0_13_choice_6, highcost_pixels_first_0_13_choice_7 : boolean;
    variable highcost_pixels_first_0_13_choice_8, highcost_pixels_first_0_13_choice_9 : boolean;
    variable highcost_pixels_first_0_13_choice_10, highcost_pixels_first_0_13_choice_11 : boolean;
    variable highcost_pixels_first_0_13_choice_12, highcost_pixels_first_0_14_choice : boolean;
    variable highcost_pixels_first_0_14_choice_2, highcost_pixels_first_0_14_choice_3 : boolean;
    variable highcost_pixels_first_0_14_choice_4, highcost_pixels_first_0_14_choice_5 : boolean;
    variable highcost_pixels_first_0_14_choice_6, highcost_pixels_first_0_14_choice_7 : boolean;
    variable highcost_pixels_first_0_14_choice_8, highcost_pixels_first_0_14_choice_9 : boolean;
    variable highcost_pixels_first_0_14_choice_10, highcost_pixels_first_0_14_choice_11 : boolean;
    variable highcost_pixels_first_0_14_choice_12, highcost_pixels_first_0_15_choice : boolean;
    variable highcost_pixels_first_0_15_choice_2, highcost_pixels_first_0_15_choice_3 : boolean;
    variable highcost_pixels_first_0_15_choice_4, highcost_pixels_first_0_15_choice_5 : boolean;
    variable highcost_pixels_first_0_15_choice_6, highcost_pixels_first_0_15_choice_7 : boolean;
    variable highcost_pixels_first_0_15_choice_8, highcost_pixels_first_0_15_choice_9 : boolean;
    variable highcost_pixels_first_0_15_choice_10, highcost_pixels_first_0_15_choice_11 : boolean;
    variable highcost_pixels_first_0_15_choice_12, highcost_pixels_first_1_0_choice : boolean;
    variable highcost_pixels_first_1_0_choice_2, highcost_pixels_first_1_0_choice_3 : boolean;
    variable highcost_pixels_first_1_0_choice_4, highcost_pixels_first_1_0_choice_5 : boolean;
    variable highcost_pixels_first_1_0_choice_6, highcost_pixels_first_1_0_choice_7 : boolean;
    variable highcost_pixels_first_1_0_choice_8, highcost_pixels_first_1_0_choice_9 : boolean;
    variable highcost_pixels_first_1_0_choice_10, highcost_pixels_first_1_0_choice_11 : boolean;
    variable highcost_pixels_first_1_0_choice_12, highcost_pixels_first_1_1_choice : boolean;
    variable highcost_pixels_first_1_1_choice_2, highcost_pixels_first_1_1_choice_3 : boolean;
    variable highcost_pixels_first_1_1_choice_4, highcost_pixels_first_1_1_choice_5 : boolean;
    variable highcost_pixels_first_1_1_choice_6, highcost_pixels_first_1_1_choice_7 : boolean;
    variable highcost_pixels_first_1_1_choice_8, highcost_pixels_first_1_1_choice_9 : boolean;
    variable highcost_pixels_first_1_1_choice_10, highcost_pixels_first_1_1_choice_11 : boolean;
    variable highcost_pixels_first_1_1_choice_12, highcost_pixels_first_1_2_choice : boolean;
    variable highcost_pixels_first_1_2_choice_2, highcost_pixels_first_1_2_choice_3 : boolean;
    variable highcost_pixels_first_1_2_choice_4, highcost_pixels_first_1_2_choice_5 : boolean;
    variable highcost_pixels_first_1_2_choice_6, highcost_pixels_first_1_2_choice_7 : boolean;
    variable highcost_pixels_first_1_2_choice_8, highcost_pixels_first_1_2_choice_9 : boolean;
    variable highcost_pixels_first_1_2_choice_10, highcost_pixels_first_1_2_choice_11 : boolean;
    variable highcost_pixels_first_1_2_choice_12, highcost_pixels_first_1_3_choice : boolean;
    variable highcost_pixels_first_1_3_choice_2, highcost_pixels_first_1_3_choice_3 : boolean;
    variable highcost_pixels_first_1_3_choice_4, highcost_pixels_first_1_3_choice_5 : boolean;
    variable highcost_pixels_first_1_3_choice_6, highcost_pixels_first_1_3_choice_7 : boolean;
    variable highcost_pixels_first_1_3_choice_8, highcost_pixels_first_1_3_choice_9 : boolean;
    variable highcost_pixels_first_1_3_choice_10, highcost_pixels_first_1_3_choice_11 : boolean;
    variable highcost_pixels_first_1_3_choice_12, highcost_pixels_first_1_4_choice : boolean;
    variable highcost_pixels_first_1_4_choice_2, highcost_pixels_first_1_4_choice_3 : boolean;
    variable highcost_pixels_first_1_4_choice_4, highcost_pixels_first_1_4_choice_5 : boolean;
    variable highcost_pixels_first_1_4_choice_6, highcost_pixels_first_1_4_choice_7 : boolean;
    variable highcost_pixels_first_1_4_choice_8, highcost_pixels_first_1_4_choice_9 : boolean;
    variable highcost_pixels_first_1_4_choice_10, highcost_pixels_first_1_4_choice_11 : boolean;
    variable highcost_pixels_first_1_4_choice_12, highcost_pixels_first_1_5_choice : boolean;
    variable highcost_pixels_first_1_5_choice_2, highcost_pixels_first_1_5_choice_3 : boolean;
    variable highcost_pixels_first_1_5_choice_4, highcost_pixels_first_1_5_choice_5 : boolean;
    variable highcost_pixels_first_1_5_choice_6, highcost_pixels_first_1_5_choice_7 : boolean;
    variable highcost_pixels_first_1_5_choice_8, highcost_pixels_first_1_5_choice_9 : boolean;
    variable highcost_pixels_first_1_5_choice_10, highcost_pixels_first_1_5_choice_11 : boolean;
    variable highcost_pixels_first_1_5_choice_12, highcost_pixels_first_1_6_choice : boolean;
    variable highcost_pixels_first_1_6_choice_2, highcost_pixels_first_1_6_choice_3 : boolean;
    variable highcost_pixels_first_1_6_choice_4, highcost_pixels_first_1_6_choice_5 : boolean;
    variable highcost_pixels_first_1_6_choice_6, highcost_pixels_first_1_6_choice_7 : boolean;
    variable highcost_pixels_first_1_6_choice_8, highcost_pixels_first_1_6_choice_9 : boolean;
    variable highcost_pixels_first_1_6_choice_10, highcost_pixels_first_1_6_choice_11 : boolean;
    variable highcost_pixels_first_1_6_choice_12, highcost_pixels_first_1_7_choice : boolean;
    variable highcost_pixels_first_1_7_choice_2, highcost_pixels_first_1_7_choice_3 : boolean;
    variable highcost_pixels_first_1_7_choice_4, highcost_pixels_first_1_7_choice_5 : boolean;
    variable highcost_pixels_first_1_7_choice_6, highcost_pixels_first_1_7_choice_7 : boolean;
    variable highcost_pixels_first_1_7_choice_8, highcost_pixels_first_1_7_choice_9 : boolean;
    variable highcost_pixels_first_1_7_choice_10, highcost_pixels_first_1_7_choice_11 : boolean;
    variable highcost_pixels_first_1_7_choice_12, highcost_pixels_first_1_8_choice : boolean;
    variable highcost_pixels_first_1_8_choice_2, highcost_pixels_first_1_8_choice_3 : boolean;
    variable highcost_pixels_first_1_8_choice_4, highcost_pixels_first_1_8_choice_5 : boolean;
    variable highcost_pixels_first_1_8_choice_6, highcost_pixels_first_1_8_choice_7 : boolean;
    variable highcost_pixels_first_1_8_choice_8, highcost_pixels_first_1_8_choice_9 : boolean;
    variable highcost_pixels_first_1_8_choice_10, highcost_pixels_first_1_8_choice_11 : boolean;
    variable highcost_pixels_first_1_8_choice_12, highcost_pixels_first_1_9_choice : boolean;
    variable highcost_pixels_first_1_9_choice_2, highcost_pixels_first_1_9_choice_3 : boolean;
    variable highcost_pixels_first_1_9_choice_4, highcost_pixels_first_1_9_choice_5 : boolean;
    variable highcost_pixels_first_1_9_choice_6, highcost_pixels_first_1_9_choice_7 : boolean;
    variable highcost_pixels_first_1_9_choice_8, highcost_pixels_first_1_9_choice_9 : boolean;
    variable highcost_pixels_first_1_9_choice_10, highcost_pixels_first_1_9_choice_11 : boolean;
    variable highcost_pixels_first_1_9_choice_12, highcost_pixels_first_1_10_choice : boolean;
    variable highcost_pixels_first_1_10_choice_2, highcost_pixels_first_1_10_choice_3 : boolean;
    variable highcost_pixels_first_1_10_choice_4, highcost_pixels_first_1_10_choice_5 : boolean;
    variable highcost_pixels_first_1_10_choice_6, highcost_pixels_first_1_10_choice_7 : boolean;
    variable highcost_pixels_first_1_10_choice_8, highcost_pixels_first_1_10_choice_9 : boolean;
    variable highcost_pixels_first_1_10_choice_10, highcost_pixels_first_1_10_choice_11 : boolean;
    variable highcost_pixels_first_1_10_choice_12, highcost_pixels_first_1_11_choice : boolean;
    variable highcost_pixels_first_1_11_choice_2, highcost_pixels_first_1_11_choice_3 : boolean;
    variable highcost_pixels_first_1_11_choice_4, highcost_pixels_first_1_11_choice_5 : boolean;
    variable highcost_pixels_first_1_11_choice_6, highcost_pixels_first_1_11_choice_7 : boolean;
    variable highcost_pixels_first_1_11_choice_8, highcost_pixels_first_1_11_choice_9 : boolean;
    variable highcost_pixels_first_1_11_choice_10, highcost_pixels_first_1_11_choice_11 : boolean;
    variable highcost_pixels_first_1_11_choice_12, highcost_pixels_first_1_12_choice : boolean;
    variable highcost_pixels_first_1_12_choice_2, highcost_pixels_first_1_12_choice_3 : boolean;
    variable highcost_pixels_first_1_12_choice_4, highcost_pixels_first_1_12_choice_5 : boolean;
    variable highcost_pixels_first_1_12_choice_6, highcost_pixels_first_1_12_choice_7 : boolean;
    variable highcost_pixels_first_1_12_choice_8, highcost_pixels_first_1_12_choice_9 : boolean;
    variable highcost_pixels_first_1_12_choice_10, highcost_pixels_first_1_12_choice_11 : boolean;
    variable highcost_pixels_first_1_12_choice_12, highcost_pixels_first_1_13_choice : boolean;
    variable highcost_pixels_first_1_13_choice_2, highcost_pixels_first_1_13_choice_3 : boolean;
    variable highcost_pixels_first_1_13_choice_4, highcost_pixels_first_1_13_choice_5 : boolean;
    variable highcost_pixels_first_1_13_choice_6, highcost_pixels_first_1_13_choice_7 : boolean;
    variable highcost_pixels_first_1_13_choice_8, highcost_pixels_first_1_13_choice_9 : boolean;
    variable highcost_pixels_first_1_13_choice_10, highcost_pixels_first_1_13_choice_11 : boolean;
    variable highcost_pixels_first_1_13_choice_12, highcost_pixels_first_1_14_choice : boolean;
    variable highcost_pixels_first_1_14_choice_2, highcost_pixels_first_1_14_choice_3 : boolean;
    variable highcost_pixels_first_1_14_choice_4, highcost_pixels_first_1_14_choice_5 : boolean;
    variable highcost_pixels_first_1_14_choice_6, highcost_pixels_first_1_14_choice_7 : boolean;
    variable highcost_pixels_first_1_14_choice_8, highcost_pixels_first_1_14_choice_9 : boolean;
    variable highcost_pixels_first_1_14_choice_10, highcost_pixels_first_1_14_choice_11 : boolean;
    variable highcost_pixels_first_1_14_choice_12, highcost_pixels_first_1_15_choice : boolean;
    variable highcost_pixels_first_1_15_choice_2, highcost_pixels_first_1_15_choice_3 : boolean;
    variable highcost_pixels_first_1_15_choice_4, highcost_pixels_first_1_15_choice_5 : boolean;
    variable highcost_pixels_first_1_15_choice_6, highcost_pixels_first_1_15_choice_7 : boolean;
    variable highcost_pixels_first_1_15_choice_8, highcost_pixels_first_1_15_choice_9 : boolean;
    variable highcost_pixels_first_1_15_choice_10, highcost_pixels_first_1_15_choice_11 : boolean;
    variable highcost_pixels_first_1_15_choice_12, highwinner1_of_pair_0_0_is_less : boolean;
    variable highwinner1_of_pair_0_2_is_less, highwinner1_of_pair_0_4_is_less : boolean;
    variable highwinner1_of_pair_0_6_is_less, highwinner1_of_pair_0_8_is_less : boolean;
    variable highwinner1_of_pair_0_10_is_less, highwinner1_of_pair_0_12_is_less : boolean;
    variable highwinner1_of_pair_0_14_is_less, highwinner1_of_four_0_0_is_less : boolean;
    variable highwinner1_of_four_0_4_is_less, highwinner1_of_four_0_8_is_less : boolean;
    variable highwinner1_of_four_0_12_is_less, highwinner2_of_pair_0_0_is_less : boolean;
    variable highwinner2_of_pair_0_2_is_less, highwinner2_of_four_0_0_is_less, choice_best_index_0_0_is_less : boolean;
    variable coarse_pixels_column_choice, coarse_pixels_column_choice_2 : natural range 0 to 15;
    variable coarsetransform_counter_group_choice, coarsetransform_counter_group_choice_2 : natural range 0 to 15;
    variable coarseraster_place_group_choice_2, coarseraster_place_group_choice_3 : natural range 0 to 15;
    variable ranges_row_choice, targets_high_choice, targets_high_choice_2 : natural range 0 to 15;
    variable targets_high_choice_3, transform_from_first_0_value, rows_address_0_value_2 : natural range 0 to 15;
    variable rows_address_4_value_2, rows_address_8_value_2, rows_address_12_value_2 : natural range 0 to 15;
    variable coarse_pixels_part_choice, coarse_pixels_part_choice_2 : natural range 0 to 255;
    variable coarse_pixels_row_choice, coarse_pixels_row_choice_2, targets_low_choice_2 : natural range 0 to 3;
    variable coarse_pixels_repetition_choice, coarse_pixels_left_sum_choice : natural range 0 to 65535;
    variable coarse_pixels_right_sum_choice, coarse_pixels_total_choice_2 : natural range 0 to 65535;
    variable targets_pause_choice, bases_base_0_0_choice, bases_base_0_0_choice_2 : natural range 0 to 65535;
    variable bases_base_0_1_choice, bases_base_0_1_choice_2, bases_base_0_2_choice : natural range 0 to 65535;
    variable bases_base_0_2_choice_2, bases_base_1_0_choice, bases_base_1_0_choice_2 : natural range 0 to 65535;
    variable bases_base_1_1_choice, bases_base_1_1_choice_2, bases_base_1_2_choice : natural range 0 to 65535;
    variable bases_base_1_2_choice_2, rows_newest_column_choice, rows_newest_column_choice_2 : natural range 0 to 65535;
    variable coarse_pixels_total_choice : unsigned(31 downto 0);
    variable coarseleftright_address_0_value, ranges_pair_0_choice_6, ranges_pair_0_choice_10 : natural range 0 to 7;
    variable ranges_range_choice_5, ranges_range_choice_10, targets_walk_place_choice : natural range 0 to 7;
    variable targets_column_range_choice_23, targets_column_range_choice_24 : natural range 0 to 7;
    variable targets_column_range_value_11, targets_column_range_choice_25 : natural range 0 to 7;
    variable targets_column_range_choice_26, targets_column_range_choice_27 : natural range 0 to 7;
    variable targets_column_range_choice_28, targets_column_range_choice_29 : natural range 0 to 7;
    variable targets_column_range_choice_51, targets_column_range_choice_54 : natural range 0 to 7;
    variable targets_around_choice_16, targets_around_choice_17, targets_around_choice_18 : natural range 0 to 7;
    variable targets_around_choice_29, targets_around_choice_31, bases_address_0_choice_2 : natural range 0 to 7;
    variable rows_write_word_choice, rows_write_word_choice_2, rows_write_word_choice_3 : natural range 0 to 7;
    variable coarseleftright_checked_passed_0_sum, ranges_counts_difference : integer range -6 to 8;
    variable ranges_counts_difference_2, ranges_counts_difference_3, ranges_counts_difference_4 : integer range -6 to 8;
    variable ranges_column_choice_5, ranges_column_choice_6 : natural range 0 to 31;
    variable ranges_counts_sum : natural range 1 to 8;
    variable ranges_counts_sum_2 : natural range 0 to 4;
    variable ranges_pair_0_choice_5, targets_column_range_choice_55, targets_around_choice_14 : natural range 0 to 127;
    variable targets_around_choice_15, lowcost_column_0_0_choice, lowcost_column_0_0_choice_2 : natural range 0 to 127;
    variable lowcost_column_0_1_choice, lowcost_column_0_1_choice_2, lowcost_column_0_2_choice : natural range 0 to 127;
    variable lowcost_column_0_2_choice_2, lowcost_column_0_3_choice : natural range 0 to 127;
    variable lowcost_column_0_3_choice_2, lowcost_column_0_4_choice : natural range 0 to 127;
    variable lowcost_column_0_4_choice_2, lowcost_column_0_5_choice : natural range 0 to 127;
    variable lowcost_column_0_5_choice_2, lowcost_column_0_6_choice : natural range 0 to 127;
    variable lowcost_column_0_6_choice_2, lowcost_column_0_7_choice : natural range 0 to 127;
    variable lowcost_column_0_7_choice_2, lowcost_column_0_8_choice : natural range 0 to 127;
    variable lowcost_column_0_8_choice_2, lowcost_column_0_9_choice : natural range 0 to 127;
    variable lowcost_column_0_9_choice_2, lowcost_column_0_10_choice : natural range 0 to 127;
    variable lowcost_column_0_10_choice_2, lowcost_column_0_11_choice : natural range 0 to 127;
    variable lowcost_column_0_11_choice_2, lowcost_column_0_12_choice : natural range 0 to 127;
    variable lowcost_column_0_12_choice_2, lowcost_column_0_13_choice : natural range 0 to 127;
    variable lowcost_column_0_13_choice_2, lowcost_column_0_14_choice : natural range 0 to 127;
    variable lowcost_column_0_14_choice_2, lowcost_column_0_15_choice : natural range 0 to 127;
    variable lowcost_column_0_15_choice_2, lowwindow_change_0_0_choice : natural range 0 to 127;
    variable lowwindow_change_0_1_choice, lowwindow_change_0_2_choice : natural range 0 to 127;
    variable lowwindow_change_0_3_choice, lowwindow_change_0_4_choice : natural range 0 to 127;
    variable lowwindow_change_0_5_choice, lowwindow_change_0_6_choice : natural range 0 to 127;
    variable lowwindow_change_0_7_choice, lowwindow_change_0_8_choice : natural range 0 to 127;
    variable lowwindow_change_0_9_choice, lowwindow_change_0_10_choice : natural range 0 to 127;
    variable lowwindow_change_0_11_choice, lowwindow_change_0_12_choice : natural range 0 to 127;
    variable lowwindow_change_0_13_choice, lowwindow_change_0_14_choice : natural range 0 to 127;
    variable lowwindow_change_0_15_choice, highcost_column_0_0_choice : natural range 0 to 127;
    variable highcost_column_0_0_choice_2, highcost_column_0_1_choice : natural range 0 to 127;
    variable highcost_column_0_1_choice_2, highcost_column_0_2_choice : natural range 0 to 127;
    variable highcost_column_0_2_choice_2, highcost_column_0_3_choice : natural range 0 to 127;
    variable highcost_column_0_3_choice_2, highcost_column_0_4_choice : natural range 0 to 127;
    variable highcost_column_0_4_choice_2, highcost_column_0_5_choice : natural range 0 to 127;
    variable highcost_column_0_5_choice_2, highcost_column_0_6_choice : natural range 0 to 127;
    variable highcost_column_0_6_choice_2, highcost_column_0_7_choice : natural range 0 to 127;
    variable highcost_column_0_7_choice_2, highcost_column_0_8_choice : natural range 0 to 127;
    variable highcost_column_0_8_choice_2, highcost_column_0_9_choice : natural range 0 to 127;
    variable highcost_column_0_9_choice_2, highcost_column_0_10_choice : natural range 0 to 127;
    variable highcost_column_0_10_choice_2, highcost_column_0_11_choice : natural range 0 to 127;
    variable highcost_column_0_11_choice_2, highcost_column_0_12_choice : natural range 0 to 127;
    variable highcost_column_0_12_choice_2, highcost_column_0_13_choice : natural range 0 to 127;
    variable highcost_column_0_13_choice_2, highcost_column_0_14_choice : natural range 0 to 127;
    variable highcost_column_0_14_choice_2, highcost_column_0_15_choice : natural range 0 to 127;
    variable highcost_column_0_15_choice_2, highwindow_change_0_0_choice : natural range 0 to 127;
    variable highwindow_change_0_1_choice, highwindow_change_0_2_choice : natural range 0 to 127;
    variable highwindow_change_0_3_choice, highwindow_change_0_4_choice : natural range 0 to 127;
    variable highwindow_change_0_5_choice, highwindow_change_0_6_choice : natural range 0 to 127;
    variable highwindow_change_0_7_choice, highwindow_change_0_8_choice : natural range 0 to 127;
    variable highwindow_change_0_9_choice, highwindow_change_0_10_choice : natural range 0 to 127;
    variable highwindow_change_0_11_choice, highwindow_change_0_12_choice : natural range 0 to 127;
    variable highwindow_change_0_13_choice, highwindow_change_0_14_choice : natural range 0 to 127;
    variable highwindow_change_0_15_choice : natural range 0 to 127;
    variable targets_column_range_value_9, targets_column_range_value_10 : natural range 0 to 63;
    variable targets_column_range_choice_48, targets_column_range_choice_49 : natural range 0 to 63;
    variable targets_column_range_choice_50, targets_column_range_choice_52 : natural range 0 to 63;
    variable targets_column_range_choice_53, targets_around_choice_30 : natural range 0 to 63;
    variable transform_counter_group_choice, transform_counter_group_choice_2 : natural range 0 to 63;
    variable bases_address_0_value, bases_address_0_choice : natural range 0 to 63;
    variable targets_low_wish_value, targets_low_wish_choice, targets_low_wish_choice_2 : natural range 0 to 28;
    variable targets_high_wish_value, targets_high_wish_choice, targets_high_wish_choice_2 : natural range 0 to 28;
    variable targets_low_choice, targets_low_sum, targets_low_choice_3, targets_low_choice_4 : natural range 0 to 32767;
    variable targets_low_choice_5 : natural range 0 to 32767;
    variable bases_goal_0_0_value, bases_goal_0_1_value, bases_goal_0_2_value : natural range 0 to 254;
    variable bases_rises_0_0_sum, bases_rises_0_1_sum, bases_rises_1_0_sum : natural range 3 to 65538;
    variable bases_rises_1_1_sum, bases_base_0_2_sum, bases_base_1_2_sum : natural range 3 to 65538;
    variable rows_last_3_sum, rows_newest_row_choice, rows_newest_row_choice_2 : natural range 0 to 4095;
    variable rows_newest_row_choice_3, rows_newest_row_choice_4, rows_enter_row_choice : natural range 0 to 4095;
    variable rows_enter_row_choice_2, rows_enter_row_choice_3, rows_leave_row_choice : natural range 0 to 4095;
    variable rows_leave_row_choice_2, rows_leave_row_choice_3, rows_codes_0_0_0_choice : natural range 0 to 4095;
    variable rows_codes_0_0_0_choice_2, rows_codes_0_0_1_choice, rows_codes_0_0_2_choice : natural range 0 to 4095;
    variable rows_codes_0_1_0_choice, rows_codes_0_1_0_choice_2, rows_codes_0_1_1_choice : natural range 0 to 4095;
    variable rows_codes_0_1_2_choice, rows_codes_1_0_0_choice, rows_codes_1_0_0_choice_2 : natural range 0 to 4095;
    variable rows_codes_1_0_1_choice, rows_codes_1_0_2_choice, rows_codes_1_1_0_choice : natural range 0 to 4095;
    variable rows_codes_1_1_0_choice_2, rows_codes_1_1_1_choice, rows_codes_1_1_2_choice : natural range 0 to 4095;
    variable rows_newest_column_sum : natural range 1 to 65536;
    variable rows_newest_row_sum : natural range 1 to 4096;
    variable rows_position_0_0_sum, rows_position_0_1_sum, rows_position_1_0_sum : natural range 0 to 574;
    variable rows_position_1_1_sum : natural range 0 to 574;
    variable rows_address_0_value, rows_address_4_value, rows_address_8_value : natural range 0 to 112;
    variable rows_address_12_value : natural range 0 to 112;
    variable lowwindow_sum_0_0_choice, lowwindow_sum_0_1_choice, lowwindow_sum_0_2_choice : natural range 0 to 511;
    variable lowwindow_sum_0_3_choice, lowwindow_sum_0_4_choice, lowwindow_sum_0_5_choice : natural range 0 to 511;
    variable lowwindow_sum_0_6_choice, lowwindow_sum_0_7_choice, lowwindow_sum_0_8_choice : natural range 0 to 511;
    variable lowwindow_sum_0_9_choice, lowwindow_sum_0_10_choice, lowwindow_sum_0_11_choice : natural range 0 to 511;
    variable lowwindow_sum_0_12_choice, lowwindow_sum_0_13_choice, lowwindow_sum_0_14_choice : natural range 0 to 511;
    variable lowwindow_sum_0_15_choice, highwindow_sum_0_0_choice, highwindow_sum_0_1_choice : natural range 0 to 511;
    variable highwindow_sum_0_2_choice, highwindow_sum_0_3_choice, highwindow_sum_0_4_choice : natural range 0 to 511;
    variable highwindow_sum_0_5_choice, highwindow_sum_0_6_choice, highwindow_sum_0_7_choice : natural range 0 to 511;
    variable highwindow_sum_0_8_choice, highwindow_sum_0_9_choice, highwindow_sum_0_10_choice : natural range 0 to 511;
    variable highwindow_sum_0_11_choice, highwindow_sum_0_12_choice : natural range 0 to 511;
    variable highwindow_sum_0_13_choice, highwindow_sum_0_14_choice : natural range 0 to 511;
    variable highwindow_sum_0_15_choice : natural range 0 to 511;
    variable other_20_choice : natural range 11 to 15;
  begin
    if rising_edge(clock) then
      -- coarse
      coarse_pixels_column_any := (not in_start_of_frame) or (not in_valid);
      coarse_pixels_column_is_equal := coarse_pixels_column = 15;
      coarse_pixels_column_is_equal_2 := coarse_pixels_part = 3;
      coarse_pixels_column_all := coarse_pixels_column_is_equal and coarse_pixels_column_is_equal_2;
      if coarse_pixels_column_all then
        coarse_pixels_column_choice := 0;
      else
        coarse_pixels_column_choice := (coarse_pixels_column + as_number(coarse_pixels_column_is_equal_2)) mod 16;
      end if;
      if in_valid then
        coarse_pixels_column_choice_2 := coarse_pixels_column_choice;
      else
        coarse_pixels_column_choice_2 := coarse_pixels_column;
      end if;
      if coarse_pixels_column_is_equal_2 then
        coarse_pixels_part_choice := 0;
      else
        coarse_pixels_part_choice := (coarse_pixels_part + 1) mod 256;
      end if;
      if in_valid then
        coarse_pixels_part_choice_2 := coarse_pixels_part_choice;
      else
        coarse_pixels_part_choice_2 := coarse_pixels_part;
      end if;
      if coarse_pixels_column_all then
        coarse_pixels_row_choice := (coarse_pixels_row + 1) mod 4;
      else
        coarse_pixels_row_choice := coarse_pixels_row;
      end if;
      if in_valid then
        coarse_pixels_row_choice_2 := coarse_pixels_row_choice;
      else
        coarse_pixels_row_choice_2 := coarse_pixels_row;
      end if;
      coarse_pixels_first_row_is_equal := coarse_pixels_row = 3;
      if in_valid then
        coarse_pixels_first_row_choice := in_start_of_frame;
      else
        coarse_pixels_first_row_choice := coarse_pixels_first_row;
      end if;
      coarse_pixels_repetition_differs := coarse_pixels_repetition /= 8;
      if coarse_pixels_repetition_differs then
        coarse_pixels_repetition_choice := (coarse_pixels_repetition + 1) mod 65536;
      else
        coarse_pixels_repetition_choice := 8;
      end if;
      coarse_pixels_out_valid_all := coarse_pixels_total_is_last and coarse_pixels_total_ends;
      coarse_pixels_left <= in_left_pixel;
      coarse_pixels_right <= in_right_pixel;
      coarse_pixels_valid <= in_valid;
      coarse_pixels_sum_ends <= coarse_pixels_column_is_equal_2 and coarse_pixels_valid;
      coarse_pixels_sum_is_first <= coarse_pixels_row = 0;
      coarse_pixels_sum_is_last <= coarse_pixels_first_row_is_equal;
      coarse_pixels_sum_starts <= coarse_pixels_first_row;
      coarse_pixels_sum_column <= coarse_pixels_column;
      coarse_pixels_left_read <= coarse_pixels_left_sum;
      coarse_pixels_right_read <= coarse_pixels_right_sum;
      coarse_pixels_read_column <= coarse_pixels_sum_column;
      coarse_pixels_read_ends <= coarse_pixels_sum_ends;
      coarse_pixels_read_is_first <= coarse_pixels_sum_is_first;
      coarse_pixels_read_is_last <= coarse_pixels_sum_is_last;
      coarse_pixels_read_starts <= coarse_pixels_sum_starts;
      coarse_pixels_total_ends <= coarse_pixels_read_ends;
      coarse_pixels_total_is_last <= coarse_pixels_read_is_last;
      coarse_pixels_total_starts <= coarse_pixels_read_starts;
      coarse_pixels_out_start <= (coarse_pixels_total_column = 0) and coarse_pixels_total_starts and
        coarse_pixels_total_is_last and coarse_pixels_total_ends;
      coarse_pixels_out_valid <= coarse_pixels_repetition_differs or coarse_pixels_out_valid_all;
      if coarse_pixels_column_any then
        coarse_pixels_column <= coarse_pixels_column_choice_2;
        coarse_pixels_part <= coarse_pixels_part_choice_2;
        coarse_pixels_row <= coarse_pixels_row_choice_2;
      else
        coarse_pixels_column <= 0;
        coarse_pixels_part <= 0;
        coarse_pixels_row <= 0;
      end if;
      if coarse_pixels_column_is_equal and coarse_pixels_column_is_equal_2 and coarse_pixels_first_row and
        coarse_pixels_first_row_is_equal then
        coarse_pixels_first_row <= coarse_pixels_first_row_choice;
      else
        coarse_pixels_first_row <= coarse_pixels_first_row or (in_start_of_frame and in_valid);
      end if;
      if (coarse_pixels_total_column = 15) and coarse_pixels_total_is_last and coarse_pixels_total_ends then
        coarse_pixels_repetition <= 0;
      else
        coarse_pixels_repetition <= coarse_pixels_repetition_choice;
      end if;
      coarse_pixels_left_sum_is_equal := coarse_pixels_part = 0;
      if coarse_pixels_left_sum_is_equal then
        coarse_pixels_left_sum_choice := 0;
      else
        coarse_pixels_left_sum_choice := coarse_pixels_left_sum;
      end if;
      if coarse_pixels_left_sum_is_equal then
        coarse_pixels_right_sum_choice := 0;
      else
        coarse_pixels_right_sum_choice := coarse_pixels_right_sum;
      end if;
      if coarse_pixels_valid then
        coarse_pixels_left_sum <= (coarse_pixels_left + coarse_pixels_left_sum_choice) mod 65536;
        coarse_pixels_right_sum <= (coarse_pixels_right + coarse_pixels_right_sum_choice) mod 65536;
      end if;
      if coarse_pixels_read_is_first then
        coarse_pixels_total_choice := to_unsigned(0, 32);
      else
        coarse_pixels_total_choice := coarse_pixels_read_word_0;
      end if;
      if coarse_pixels_read_is_first then
        coarse_pixels_total_choice_2 := 0;
      else
        coarse_pixels_total_choice_2 := to_integer(coarse_pixels_read_word_0(15 downto 0));
      end if;
      if coarse_pixels_read_ends then
        coarse_pixels_total <= to_unsigned(((coarse_pixels_right_read + to_integer(coarse_pixels_total_choice(31 downto
          16))) mod 65536), 16) & to_unsigned(((coarse_pixels_left_read + coarse_pixels_total_choice_2) mod 65536), 16);
        coarse_pixels_total_column <= coarse_pixels_read_column;
      end if;
      if coarse_pixels_out_valid_all then
        coarse_pixels_out_left <= ((to_integer(coarse_pixels_total(15 downto 3)) + 1) * 8) / 16;
        coarse_pixels_out_right <= ((to_integer(coarse_pixels_total(31 downto 19)) + 1) * 8) / 16;
      end if;
      -- coarsetransform
      coarsetransform_counter_group_is_equal := coarsetransform_counter_column = 23;
      coarsetransform_counter_group_is_equal_2 := coarsetransform_counter_group = 7;
      coarsetransform_counter_group_all := coarsetransform_counter_group_is_equal and
        coarsetransform_counter_group_is_equal_2;
      coarsetransform_counter_group_any := ((coarsetransform_counter_group / 4) /= 2) or (not
        (((coarsetransform_counter_group / 2) mod 2) = 1)) or ((coarsetransform_counter_group mod 2) = 1);
      if (coarsetransform_counter_group = 9) and coarsetransform_counter_next_frame then
        coarsetransform_counter_group_choice := 2;
      else
        coarsetransform_counter_group_choice := (coarsetransform_counter_group + 1) mod 16;
      end if;
      if coarsetransform_counter_group_is_equal and coarsetransform_counter_group_any and coarse_pixels_out_valid then
        coarsetransform_counter_group_choice_2 := coarsetransform_counter_group_choice;
      else
        coarsetransform_counter_group_choice_2 := coarsetransform_counter_group;
      end if;
      if coarsetransform_counter_group_is_equal and coarsetransform_counter_group_any then
        coarsetransform_counter_next_frame_choice := (coarsetransform_counter_group /= 9) and
          coarsetransform_counter_next_frame;
      else
        coarsetransform_counter_next_frame_choice := coarsetransform_counter_next_frame;
      end if;
      if coarsetransform_counter_group_all then
        coarsetransform_counter_next_frame_choice_2 := coarse_pixels_out_valid;
      else
        coarsetransform_counter_next_frame_choice_2 := coarse_pixels_out_valid and (not coarse_pixels_out_start);
      end if;
      if coarsetransform_counter_next_frame_choice then
        coarsetransform_counter_next_frame_choice_3 := coarsetransform_counter_next_frame_choice_2;
      else
        coarsetransform_counter_next_frame_choice_3 := coarsetransform_counter_group_is_equal and
          coarsetransform_counter_group_is_equal_2 and coarse_pixels_out_valid and coarse_pixels_out_start;
      end if;
      coarsetransform_centre_group_any := ((coarsetransform_counter_column / 16) = 1) or
        (((coarsetransform_counter_column / 8) mod 2) = 1) or (((coarsetransform_counter_column / 4) mod 2) = 1) or
        (((coarsetransform_counter_column / 2) mod 2) = 1);
      coarsetransform_from_first_0_value := ((coarsetransform_centre_group / 4) mod 2) = 1;
      coarsetransform_from_first_0_differs := (other_20 / 2) /= 0;
      coarsetransform_from_first_0_value_2 := ((coarsetransform_centre_group / 8) mod 2) = 1;
      coarsetransform_left_0 <= coarse_pixels_out_left;
      coarsetransform_right_0 <= coarse_pixels_out_right;
      coarsetransform_valid <= coarse_pixels_out_valid;
      coarsetransform_counter_next_frame <= coarsetransform_counter_next_frame_choice_3 or ((not
        coarse_pixels_out_valid) and coarsetransform_counter_next_frame);
      coarsetransform_left_rows_read_newest_0 <= coarsetransform_left_0;
      coarsetransform_left_rows_ready_words_0 <= to_integer(coarsetransform_left_rows_read_words_0);
      coarsetransform_left_rows_ready_words_1 <= to_integer(coarsetransform_left_rows_read_words_1);
      coarsetransform_left_rows_ready_newest_0 <= coarsetransform_left_rows_read_newest_0;
      coarsetransform_right_rows_read_newest_0 <= coarsetransform_right_0;
      coarsetransform_right_rows_ready_words_0 <= to_integer(coarsetransform_right_rows_read_words_0);
      coarsetransform_right_rows_ready_words_1 <= to_integer(coarsetransform_right_rows_read_words_1);
      coarsetransform_right_rows_ready_newest_0 <= coarsetransform_right_rows_read_newest_0;
      coarsetransform_read_column <= coarsetransform_counter_column;
      coarsetransform_ready_column <= coarsetransform_read_column;
      coarsetransform_centre_group <= coarsetransform_counter_group + as_number(coarsetransform_centre_group_any);
      coarsetransform_up_to_last_0 <= (not (((other_20 / 16) = 1) and ((((other_20 / 8) mod 2) = 1) or (((other_20 / 2)
        mod 4) = 3)))) and (not (coarsetransform_from_first_0_value_2 and (coarsetransform_from_first_0_value or
        (((coarsetransform_centre_group / 2) mod 2) = 1) or ((coarsetransform_centre_group mod 2) = 1)))) and (not
        ((coarsetransform_centre_group / 16) = 1));
      coarsetransform_left_column_0 <= coarsetransform_left_rows_ready_words_0 mod 4096;
      coarsetransform_left_column_1 <= coarsetransform_left_rows_ready_words_0 / 4096;
      coarsetransform_left_column_2 <= coarsetransform_left_rows_ready_words_1 mod 4096;
      coarsetransform_left_column_3 <= coarsetransform_left_rows_ready_words_1 / 4096;
      coarsetransform_left_column_4 <= coarsetransform_left_rows_ready_newest_0;
      coarsetransform_right_column_0 <= coarsetransform_right_rows_ready_words_0 mod 4096;
      coarsetransform_right_column_1 <= coarsetransform_right_rows_ready_words_0 / 4096;
      coarsetransform_right_column_2 <= coarsetransform_right_rows_ready_words_1 mod 4096;
      coarsetransform_right_column_3 <= coarsetransform_right_rows_ready_words_1 / 4096;
      coarsetransform_right_column_4 <= coarsetransform_right_rows_ready_newest_0;
      coarsetransform_columns_inside_0 <= coarsetransform_up_to_last_0 and coarsetransform_from_first_0;
      coarsetransform_columns_start_of_frame <= (other_21 mod 2) = 1;
      coarsetransform_columns_valid <= (other_21 / 256) = 1;
      coarsetransform_left_code_column_centre <= coarsetransform_left_column_2;
      coarsetransform_left_code_column_near <= coarsetransform_left_column_1 + coarsetransform_left_column_3;
      coarsetransform_left_code_column_outer <= ((8190 - coarsetransform_left_column_4) -
        coarsetransform_left_column_0) mod 32768;
      coarsetransform_left_code_column_upper <= 12285 - (((coarsetransform_left_column_1 +
        (coarsetransform_left_column_0 / 2)) * 2) + (coarsetransform_left_column_0 mod 2));
      coarsetransform_left_code_column_lower <= ((coarsetransform_left_column_3 + (coarsetransform_left_column_4 / 2))
        * 2) + (coarsetransform_left_column_4 mod 2);
      coarsetransform_left_code_column_response_0 <= ((coarsetransform_left_code_column_centre +
        (coarsetransform_left_code_column_near / 2)) * 2) + (coarsetransform_left_code_column_near mod 2);
      coarsetransform_left_code_column_response_1 <= (((coarsetransform_left_code_column_centre +
        (coarsetransform_left_code_column_outer / 2)) mod 16384) * 2) + (coarsetransform_left_code_column_outer mod 2);
      coarsetransform_left_code_column_response_2 <= coarsetransform_left_code_column_upper +
        coarsetransform_left_code_column_lower;
      coarsetransform_left_code_row_centre_0 <= coarsetransform_left_code_row_column_0_1;
      coarsetransform_left_code_row_centre_1 <= coarsetransform_left_code_row_column_1_1;
      coarsetransform_left_code_row_centre_2 <= coarsetransform_left_code_row_column_2_1;
      coarsetransform_left_code_row_outer_1 <= coarsetransform_left_code_row_column_1_3 +
        coarsetransform_left_code_column_response_1;
      coarsetransform_left_code_row_outer_2 <= coarsetransform_left_code_row_column_2_3 +
        coarsetransform_left_code_column_response_2;
      coarsetransform_left_code_row_before_0 <= ((coarsetransform_left_code_row_column_0_2 +
        (coarsetransform_left_code_row_column_0_3 / 2)) * 2) + (coarsetransform_left_code_row_column_0_3 mod 2);
      coarsetransform_left_code_row_before_1 <= ((coarsetransform_left_code_row_column_1_2 +
        (coarsetransform_left_code_row_column_1_3 / 2)) * 2) + (coarsetransform_left_code_row_column_1_3 mod 2);
      coarsetransform_left_code_row_before_2 <= ((coarsetransform_left_code_row_column_2_2 +
        (coarsetransform_left_code_row_column_2_3 / 2)) * 2) + (coarsetransform_left_code_row_column_2_3 mod 2);
      coarsetransform_left_code_row_after_0 <= ((coarsetransform_left_code_row_column_0_0 +
        (coarsetransform_left_code_column_response_0 / 2)) * 2) + (coarsetransform_left_code_column_response_0 mod 2);
      coarsetransform_left_code_row_after_1 <= ((coarsetransform_left_code_row_column_1_0 +
        (coarsetransform_left_code_column_response_1 / 2)) * 2) + (coarsetransform_left_code_column_response_1 mod 2);
      coarsetransform_left_code_row_after_2 <= ((coarsetransform_left_code_row_column_2_0 +
        (coarsetransform_left_code_column_response_2 / 2)) * 2) + (coarsetransform_left_code_column_response_2 mod 2);
      coarsetransform_left_code_row_even_1 <= ((((coarsetransform_left_code_row_outer_1 / 2) -
        coarsetransform_left_code_row_centre_1) mod 131072) * 2) + (coarsetransform_left_code_row_outer_1 mod 2);
      coarsetransform_left_code_row_even_2 <= ((((coarsetransform_left_code_row_outer_2 / 2) -
        coarsetransform_left_code_row_centre_2) mod 131072) * 2) + (coarsetransform_left_code_row_outer_2 mod 2);
      coarsetransform_left_code_row_odd_1 <= (coarsetransform_left_code_row_before_1 -
        coarsetransform_left_code_row_after_1) mod 262144;
      coarsetransform_left_code_row_odd_2 <= (coarsetransform_left_code_row_before_2 -
        coarsetransform_left_code_row_after_2) mod 262144;
      coarsetransform_left_code_row_signs <= ((other_17 / 131072) * 2) + (other_18 / 131072) +
        ((((coarsetransform_left_code_row_even_2 + coarsetransform_left_code_row_odd_1) mod 262144) / 131072) * 8) +
        ((((coarsetransform_left_code_row_odd_1 - coarsetransform_left_code_row_even_2) mod 262144) / 131072) * 32) +
        ((((coarsetransform_left_code_row_even_1 - coarsetransform_left_code_row_odd_2) mod 262144) / 131072) * 4) +
        ((((coarsetransform_left_code_row_even_1 + coarsetransform_left_code_row_odd_2) mod 262144) / 131072) * 16);
      coarsetransform_right_code_column_centre <= coarsetransform_right_column_2;
      coarsetransform_right_code_column_near <= coarsetransform_right_column_1 + coarsetransform_right_column_3;
      coarsetransform_right_code_column_outer <= ((8190 - coarsetransform_right_column_4) -
        coarsetransform_right_column_0) mod 32768;
      coarsetransform_right_code_column_upper <= 12285 - (((coarsetransform_right_column_1 +
        (coarsetransform_right_column_0 / 2)) * 2) + (coarsetransform_right_column_0 mod 2));
      coarsetransform_right_code_column_lower <= ((coarsetransform_right_column_3 + (coarsetransform_right_column_4 /
        2)) * 2) + (coarsetransform_right_column_4 mod 2);
      coarsetransform_right_code_column_response_0 <= ((coarsetransform_right_code_column_centre +
        (coarsetransform_right_code_column_near / 2)) * 2) + (coarsetransform_right_code_column_near mod 2);
      coarsetransform_right_code_column_response_1 <= (((coarsetransform_right_code_column_centre +
        (coarsetransform_right_code_column_outer / 2)) mod 16384) * 2) + (coarsetransform_right_code_column_outer mod
        2);
      coarsetransform_right_code_column_response_2 <= coarsetransform_right_code_column_upper +
        coarsetransform_right_code_column_lower;
      coarsetransform_right_code_row_centre_0 <= coarsetransform_right_code_row_column_0_1;
      coarsetransform_right_code_row_centre_1 <= coarsetransform_right_code_row_column_1_1;
      coarsetransform_right_code_row_centre_2 <= coarsetransform_right_code_row_column_2_1;
      coarsetransform_right_code_row_outer_1 <= coarsetransform_right_code_row_column_1_3 +
        coarsetransform_right_code_column_response_1;
      coarsetransform_right_code_row_outer_2 <= coarsetransform_right_code_row_column_2_3 +
        coarsetransform_right_code_column_response_2;
      coarsetransform_right_code_row_before_0 <= ((coarsetransform_right_code_row_column_0_2 +
        (coarsetransform_right_code_row_column_0_3 / 2)) * 2) + (coarsetransform_right_code_row_column_0_3 mod 2);
      coarsetransform_right_code_row_before_1 <= ((coarsetransform_right_code_row_column_1_2 +
        (coarsetransform_right_code_row_column_1_3 / 2)) * 2) + (coarsetransform_right_code_row_column_1_3 mod 2);
      coarsetransform_right_code_row_before_2 <= ((coarsetransform_right_code_row_column_2_2 +
        (coarsetransform_right_code_row_column_2_3 / 2)) * 2) + (coarsetransform_right_code_row_column_2_3 mod 2);
      coarsetransform_right_code_row_after_0 <= ((coarsetransform_right_code_row_column_0_0 +
        (coarsetransform_right_code_column_response_0 / 2)) * 2) + (coarsetransform_right_code_column_response_0 mod 2);
      coarsetransform_right_code_row_after_1 <= ((coarsetransform_right_code_row_column_1_0 +
        (coarsetransform_right_code_column_response_1 / 2)) * 2) + (coarsetransform_right_code_column_response_1 mod 2);
      coarsetransform_right_code_row_after_2 <= ((coarsetransform_right_code_row_column_2_0 +
        (coarsetransform_right_code_column_response_2 / 2)) * 2) + (coarsetransform_right_code_column_response_2 mod 2);
      coarsetransform_right_code_row_even_1 <= ((((coarsetransform_right_code_row_outer_1 / 2) -
        coarsetransform_right_code_row_centre_1) mod 131072) * 2) + (coarsetransform_right_code_row_outer_1 mod 2);
      coarsetransform_right_code_row_even_2 <= ((((coarsetransform_right_code_row_outer_2 / 2) -
        coarsetransform_right_code_row_centre_2) mod 131072) * 2) + (coarsetransform_right_code_row_outer_2 mod 2);
      coarsetransform_right_code_row_odd_1 <= (coarsetransform_right_code_row_before_1 -
        coarsetransform_right_code_row_after_1) mod 262144;
      coarsetransform_right_code_row_odd_2 <= (coarsetransform_right_code_row_before_2 -
        coarsetransform_right_code_row_after_2) mod 262144;
      coarsetransform_right_code_row_signs <= ((other_14 / 131072) * 2) + (other_15 / 131072) +
        ((((coarsetransform_right_code_row_even_2 + coarsetransform_right_code_row_odd_1) mod 262144) / 131072) * 8) +
        ((((coarsetransform_right_code_row_odd_1 - coarsetransform_right_code_row_even_2) mod 262144) / 131072) * 32) +
        ((((coarsetransform_right_code_row_even_1 - coarsetransform_right_code_row_odd_2) mod 262144) / 131072) * 4) +
        ((((coarsetransform_right_code_row_even_1 + coarsetransform_right_code_row_odd_2) mod 262144) / 131072) * 16);
      coarsetransform_filtering_0_inside_0 <= coarsetransform_columns_inside_0;
      coarsetransform_filtering_0_start_of_frame <= coarsetransform_columns_start_of_frame;
      coarsetransform_filtering_0_valid <= coarsetransform_columns_valid;
      coarsetransform_filtering_1_inside_0 <= coarsetransform_filtering_0_inside_0;
      coarsetransform_filtering_1_start_of_frame <= coarsetransform_filtering_0_start_of_frame;
      coarsetransform_filtering_1_valid <= coarsetransform_filtering_0_valid;
      coarsetransform_filtering_2_inside_0 <= coarsetransform_filtering_1_inside_0;
      coarsetransform_filtering_2_start_of_frame <= coarsetransform_filtering_1_start_of_frame;
      coarsetransform_filtering_2_valid <= coarsetransform_filtering_1_valid;
      coarsetransform_filtering_3_inside_0 <= coarsetransform_filtering_2_inside_0;
      coarsetransform_filtering_3_start_of_frame <= coarsetransform_filtering_2_start_of_frame;
      coarsetransform_filtering_3_valid <= coarsetransform_filtering_2_valid;
      coarsetransform_filtering_4_inside_0 <= coarsetransform_filtering_3_inside_0;
      coarsetransform_filtering_4_start_of_frame <= coarsetransform_filtering_3_start_of_frame;
      coarsetransform_filtering_4_valid <= coarsetransform_filtering_3_valid;
      coarsetransform_filtering_5_start_of_frame <= coarsetransform_filtering_4_start_of_frame;
      coarsetransform_filtering_5_valid <= coarsetransform_filtering_4_valid;
      if coarse_pixels_out_valid and coarse_pixels_out_start then
        coarsetransform_counter_group <= as_number(coarsetransform_counter_group_all) * 8;
      else
        coarsetransform_counter_group <= coarsetransform_counter_group_choice_2;
      end if;
      if (not ((coarsetransform_centre_group / 16) = 1)) and ((not coarsetransform_from_first_0_value) or
        ((coarsetransform_centre_group mod 4) = 0)) then
        coarsetransform_from_first_0 <= coarsetransform_from_first_0_differs and coarsetransform_from_first_0_value_2;
      else
        coarsetransform_from_first_0 <= coarsetransform_from_first_0_differs;
      end if;
      if coarsetransform_filtering_4_inside_0 then
        coarsetransform_left_code_bits <= coarsetransform_left_code_row_signs;
        coarsetransform_right_code_bits <= coarsetransform_right_code_row_signs;
      else
        coarsetransform_left_code_bits <= 0;
        coarsetransform_right_code_bits <= 0;
      end if;
      if coarse_pixels_out_valid then
        if coarsetransform_counter_group_is_equal or coarse_pixels_out_start then
          coarsetransform_counter_column <= 0;
        else
          coarsetransform_counter_column <= (coarsetransform_counter_column + 1) mod 32;
        end if;
      end if;
      if (other_21 / 256) = 1 then
        coarsetransform_left_rows_write_words_0 <= (coarsetransform_left_rows_ready_words_0 / 4096) +
          ((coarsetransform_left_rows_ready_words_1 mod 4096) * 4096);
        coarsetransform_left_rows_write_words_1 <= (coarsetransform_left_rows_ready_words_1 / 4096) +
          (coarsetransform_left_rows_ready_newest_0 * 4096);
        coarsetransform_right_rows_write_words_0 <= (coarsetransform_right_rows_ready_words_0 / 4096) +
          ((coarsetransform_right_rows_ready_words_1 mod 4096) * 4096);
        coarsetransform_right_rows_write_words_1 <= (coarsetransform_right_rows_ready_words_1 / 4096) +
          (coarsetransform_right_rows_ready_newest_0 * 4096);
        coarsetransform_write_column <= coarsetransform_ready_column;
      end if;
      if coarsetransform_filtering_1_valid then
        coarsetransform_left_code_row_column_0_0 <= coarsetransform_left_code_column_response_0;
        coarsetransform_left_code_row_column_0_1 <= coarsetransform_left_code_row_column_0_0;
        coarsetransform_left_code_row_column_0_2 <= coarsetransform_left_code_row_column_0_1;
        coarsetransform_left_code_row_column_0_3 <= coarsetransform_left_code_row_column_0_2;
        coarsetransform_left_code_row_column_1_0 <= coarsetransform_left_code_column_response_1;
        coarsetransform_left_code_row_column_1_1 <= coarsetransform_left_code_row_column_1_0;
        coarsetransform_left_code_row_column_1_2 <= coarsetransform_left_code_row_column_1_1;
        coarsetransform_left_code_row_column_1_3 <= coarsetransform_left_code_row_column_1_2;
        coarsetransform_left_code_row_column_2_0 <= coarsetransform_left_code_column_response_2;
        coarsetransform_left_code_row_column_2_1 <= coarsetransform_left_code_row_column_2_0;
        coarsetransform_left_code_row_column_2_2 <= coarsetransform_left_code_row_column_2_1;
        coarsetransform_left_code_row_column_2_3 <= coarsetransform_left_code_row_column_2_2;
        coarsetransform_right_code_row_column_0_0 <= coarsetransform_right_code_column_response_0;
        coarsetransform_right_code_row_column_0_1 <= coarsetransform_right_code_row_column_0_0;
        coarsetransform_right_code_row_column_0_2 <= coarsetransform_right_code_row_column_0_1;
        coarsetransform_right_code_row_column_0_3 <= coarsetransform_right_code_row_column_0_2;
        coarsetransform_right_code_row_column_1_0 <= coarsetransform_right_code_column_response_1;
        coarsetransform_right_code_row_column_1_1 <= coarsetransform_right_code_row_column_1_0;
        coarsetransform_right_code_row_column_1_2 <= coarsetransform_right_code_row_column_1_1;
        coarsetransform_right_code_row_column_1_3 <= coarsetransform_right_code_row_column_1_2;
        coarsetransform_right_code_row_column_2_0 <= coarsetransform_right_code_column_response_2;
        coarsetransform_right_code_row_column_2_1 <= coarsetransform_right_code_row_column_2_0;
        coarsetransform_right_code_row_column_2_2 <= coarsetransform_right_code_row_column_2_1;
        coarsetransform_right_code_row_column_2_3 <= coarsetransform_right_code_row_column_2_2;
      end if;
      -- coarseraster
      coarseraster_place_group_all := coarsetransform_filtering_5_valid and coarsetransform_filtering_5_start_of_frame;
      coarseraster_place_group_is_equal := coarseraster_place_column = 23;
      coarseraster_place_group_is_equal_2 := coarseraster_place_group = 7;
      coarseraster_place_group_is_equal_3 := (coarseraster_place_group / 2) = 5;
      if coarseraster_place_group_is_equal_3 then
        coarseraster_place_group_choice := coarsetransform_filtering_5_valid and (not ((coarseraster_place_group mod 2)
          = 1));
      else
        coarseraster_place_group_choice := coarsetransform_filtering_5_valid;
      end if;
      if coarseraster_place_next_frame and (coarseraster_place_group = 10) then
        coarseraster_place_group_choice_2 := 3;
      else
        coarseraster_place_group_choice_2 := (coarseraster_place_group + 1) mod 16;
      end if;
      if coarseraster_place_group_is_equal and coarseraster_place_group_choice then
        coarseraster_place_group_choice_3 := coarseraster_place_group_choice_2;
      else
        coarseraster_place_group_choice_3 := coarseraster_place_group;
      end if;
      if coarseraster_place_group_is_equal_3 then
        coarseraster_place_next_frame_choice := coarseraster_place_next_frame and ((coarseraster_place_group mod 2) =
          1);
      else
        coarseraster_place_next_frame_choice := coarseraster_place_next_frame;
      end if;
      if coarseraster_place_group_is_equal then
        coarseraster_place_next_frame_choice_2 := coarseraster_place_next_frame_choice;
      else
        coarseraster_place_next_frame_choice_2 := coarseraster_place_next_frame;
      end if;
      if coarseraster_place_next_frame_choice_2 then
        coarseraster_place_next_frame_choice_3 := coarsetransform_filtering_5_valid;
      else
        coarseraster_place_next_frame_choice_3 := coarseraster_place_group_all;
      end if;
      if coarseraster_place_group_is_equal_2 and coarseraster_place_group_is_equal then
        coarseraster_place_next_frame_choice_4 := coarseraster_place_next_frame_choice_3;
      else
        coarseraster_place_next_frame_choice_4 := coarseraster_place_next_frame_choice_2 and
          coarsetransform_filtering_5_valid and (not coarsetransform_filtering_5_start_of_frame);
      end if;
      coarseraster_features_search_0 <= coarsetransform_left_code_bits;
      coarseraster_features_reference_0 <= coarsetransform_right_code_bits;
      coarseraster_features_valid <= coarsetransform_filtering_5_valid;
      coarseraster_place_next_frame <= coarseraster_place_next_frame_choice_4 or ((not
        coarsetransform_filtering_5_valid) and coarseraster_place_next_frame);
      if coarseraster_place_group_all then
        coarseraster_place_group <= as_number((coarseraster_place_group_is_equal and
          coarseraster_place_group_is_equal_2)) * 8;
      else
        coarseraster_place_group <= coarseraster_place_group_choice_3;
      end if;
      if coarsetransform_filtering_5_valid then
        if coarseraster_place_group_is_equal or coarsetransform_filtering_5_start_of_frame then
          coarseraster_place_column <= 0;
        else
          coarseraster_place_column <= (coarseraster_place_column + 1) mod 32;
        end if;
      end if;
      -- coarsedelay
      if coarseraster_features_valid then
        coarsedelay_ring_write_address <= coarsedelay_ring_read_address;
        if coarsedelay_ring_read_address = 7 then
          coarsedelay_ring_read_address <= 0;
        else
          coarsedelay_ring_read_address <= (coarsedelay_ring_read_address + 1) mod 8;
        end if;
      end if;
      coarsedelay_row_inside_3_is_not_less := coarseraster_place_group >= 3;
      coarsedelay_row_inside_3_is_less := coarseraster_place_group < 11;
      coarsedelay_tag_first_cost_is_equal := coarseraster_place_column = 7;
      coarsedelay_tag_map_column_is_not_less := coarseraster_place_column >= 7;
      coarsedelay_tag_map_column_is_less := coarseraster_place_column < 23;
      coarsedelay_ahead_0 <= coarseraster_features_search_0;
      coarsedelay_column <= coarseraster_place_column;
      coarsedelay_row_inside_0 <= (((((coarseraster_place_group / 2) + 32765) mod 32768) * 2) +
        (coarseraster_place_group mod 2)) < 8;
      coarsedelay_row_inside_1 <= (coarseraster_place_group >= 5) and (coarseraster_place_group < 13);
      coarsedelay_row_inside_2 <= (((((coarseraster_place_group / 4) + 16383) mod 16384) * 4) +
        (coarseraster_place_group mod 4)) < 8;
      coarsedelay_row_inside_3 <= coarsedelay_row_inside_3_is_not_less and coarsedelay_row_inside_3_is_less;
      coarsedelay_row_inside_4 <= (((((coarseraster_place_group / 2) + 32767) mod 32768) * 2) +
        (coarseraster_place_group mod 2)) < 8;
      coarsedelay_row_inside_5 <= (coarseraster_place_group >= 1) and (coarseraster_place_group < 9);
      coarsedelay_row_inside_6 <= not ((coarseraster_place_group / 8) = 1);
      coarsedelay_tag_valid <= coarseraster_features_valid;
      coarsedelay_tag_first_cost <= coarsedelay_tag_first_cost_is_equal;
      coarsedelay_tag_map_column <= coarsedelay_tag_map_column_is_not_less and coarsedelay_tag_map_column_is_less;
      coarsedelay_tag_output_column <= coarsedelay_row_inside_3_is_not_less and coarsedelay_row_inside_3_is_less and
        coarsedelay_tag_map_column_is_not_less and coarsedelay_tag_map_column_is_less;
      coarsedelay_tag_start_of_frame <= coarsedelay_tag_first_cost_is_equal and (coarseraster_place_group = 3);
      coarsedelay_tag_end_of_line <= coarseraster_place_column = 22;
      if (coarseraster_place_column mod 4) = 3 then
        coarsedelay_tag_border_column <= (coarseraster_place_column / 4) = 0;
      else
        coarsedelay_tag_border_column <= (coarseraster_place_column / 8) = 0;
      end if;
      -- coarserows
      coarserows_search_rows_read_newest_0 <= coarsedelay_ahead_0;
      coarserows_search_rows_ready_words_0 <= to_integer(coarserows_search_rows_read_words_0);
      coarserows_search_rows_ready_words_1 <= to_integer(coarserows_search_rows_read_words_1);
      coarserows_search_rows_ready_newest_0 <= coarserows_search_rows_read_newest_0;
      coarserows_reference_rows_read_newest_0 <= to_integer(coarsedelay_delayed_0);
      coarserows_reference_rows_ready_words_0 <= to_integer(coarserows_reference_rows_read_words_0);
      coarserows_reference_rows_ready_words_1 <= to_integer(coarserows_reference_rows_read_words_1);
      coarserows_reference_rows_ready_newest_0 <= coarserows_reference_rows_read_newest_0;
      coarserows_read_column <= coarsedelay_column;
      coarserows_read_inside_0 <= coarsedelay_row_inside_0;
      coarserows_read_inside_1 <= coarsedelay_row_inside_1;
      coarserows_read_inside_2 <= coarsedelay_row_inside_2;
      coarserows_read_inside_3 <= coarsedelay_row_inside_3;
      coarserows_read_inside_4 <= coarsedelay_row_inside_4;
      coarserows_read_inside_5 <= coarsedelay_row_inside_5;
      coarserows_read_inside_6 <= coarsedelay_row_inside_6;
      coarserows_read_tag_valid <= coarsedelay_tag_valid;
      coarserows_read_tag_border_column <= coarsedelay_tag_border_column;
      coarserows_read_tag_first_cost <= coarsedelay_tag_first_cost;
      coarserows_read_tag_map_column <= coarsedelay_tag_map_column;
      coarserows_read_tag_output_column <= coarsedelay_tag_output_column;
      coarserows_read_tag_start_of_frame <= coarsedelay_tag_start_of_frame;
      coarserows_read_tag_end_of_line <= coarsedelay_tag_end_of_line;
      coarserows_ready_column <= coarserows_read_column;
      coarserows_ready_inside_0 <= coarserows_read_inside_0;
      coarserows_ready_inside_1 <= coarserows_read_inside_1;
      coarserows_ready_inside_2 <= coarserows_read_inside_2;
      coarserows_ready_inside_3 <= coarserows_read_inside_3;
      coarserows_ready_inside_4 <= coarserows_read_inside_4;
      coarserows_ready_inside_5 <= coarserows_read_inside_5;
      coarserows_ready_inside_6 <= coarserows_read_inside_6;
      coarserows_ready_tag_valid <= coarserows_read_tag_valid;
      coarserows_ready_tag_border_column <= coarserows_read_tag_border_column;
      coarserows_ready_tag_first_cost <= coarserows_read_tag_first_cost;
      coarserows_ready_tag_map_column <= coarserows_read_tag_map_column;
      coarserows_ready_tag_output_column <= coarserows_read_tag_output_column;
      coarserows_ready_tag_start_of_frame <= coarserows_read_tag_start_of_frame;
      coarserows_ready_tag_end_of_line <= coarserows_read_tag_end_of_line;
      coarserows_tag_valid <= coarserows_ready_tag_valid;
      coarserows_tag_border_column <= coarserows_ready_tag_border_column;
      coarserows_tag_first_cost <= coarserows_ready_tag_first_cost;
      coarserows_tag_map_column <= coarserows_ready_tag_map_column;
      coarserows_tag_output_column <= coarserows_ready_tag_output_column;
      coarserows_tag_start_of_frame <= coarserows_ready_tag_start_of_frame;
      coarserows_tag_end_of_line <= coarserows_ready_tag_end_of_line;
      if coarserows_ready_inside_0 then
        coarserows_search_0 <= coarserows_search_rows_ready_words_0 mod 64;
        coarserows_reference_0 <= coarserows_reference_rows_ready_words_0 mod 64;
      else
        coarserows_search_0 <= 0;
        coarserows_reference_0 <= 0;
      end if;
      if coarserows_ready_inside_1 then
        coarserows_search_1 <= (coarserows_search_rows_ready_words_0 / 64) mod 64;
        coarserows_reference_1 <= (coarserows_reference_rows_ready_words_0 / 64) mod 64;
      else
        coarserows_search_1 <= 0;
        coarserows_reference_1 <= 0;
      end if;
      if coarserows_ready_inside_2 then
        coarserows_search_2 <= (coarserows_search_rows_ready_words_0 / 4096) mod 64;
        coarserows_reference_2 <= (coarserows_reference_rows_ready_words_0 / 4096) mod 64;
      else
        coarserows_search_2 <= 0;
        coarserows_reference_2 <= 0;
      end if;
      if coarserows_ready_inside_3 then
        coarserows_search_3 <= (coarserows_search_rows_ready_words_0 / 262144) mod 64;
        coarserows_reference_3 <= (coarserows_reference_rows_ready_words_0 / 262144) mod 64;
      else
        coarserows_search_3 <= 0;
        coarserows_reference_3 <= 0;
      end if;
      if coarserows_ready_inside_4 then
        coarserows_search_4 <= coarserows_search_rows_ready_words_0 / 16777216;
        coarserows_reference_4 <= coarserows_reference_rows_ready_words_0 / 16777216;
      else
        coarserows_search_4 <= 0;
        coarserows_reference_4 <= 0;
      end if;
      if coarserows_ready_inside_5 then
        coarserows_search_5 <= coarserows_search_rows_ready_words_1;
        coarserows_reference_5 <= coarserows_reference_rows_ready_words_1;
      else
        coarserows_search_5 <= 0;
        coarserows_reference_5 <= 0;
      end if;
      if coarserows_ready_inside_6 then
        coarserows_search_6 <= coarserows_search_rows_ready_newest_0;
        coarserows_reference_6 <= coarserows_reference_rows_ready_newest_0;
      else
        coarserows_search_6 <= 0;
        coarserows_reference_6 <= 0;
      end if;
      if coarserows_ready_tag_valid then
        coarserows_search_rows_write_words_0 <= (coarserows_search_rows_ready_words_0 / 64) +
          (coarserows_search_rows_ready_words_1 * 16777216);
        coarserows_search_rows_write_words_1 <= coarserows_search_rows_ready_newest_0;
        coarserows_reference_rows_write_words_0 <= (coarserows_reference_rows_ready_words_0 / 64) +
          (coarserows_reference_rows_ready_words_1 * 16777216);
        coarserows_reference_rows_write_words_1 <= coarserows_reference_rows_ready_newest_0;
        coarserows_write_column <= coarserows_ready_column;
      end if;
      -- coarseslice0shift
      if coarserows_tag_valid then
        coarseslice0shift_search_0_0 <= coarseslice0shift_search_0_1;
        coarseslice0shift_search_0_1 <= coarseslice0shift_search_0_2;
        coarseslice0shift_search_0_2 <= coarseslice0shift_search_0_3;
        coarseslice0shift_search_0_3 <= coarseslice0shift_search_0_4;
        coarseslice0shift_search_0_4 <= coarseslice0shift_search_0_5;
        coarseslice0shift_search_0_5 <= coarseslice0shift_search_0_6;
        coarseslice0shift_search_0_6 <= coarseslice0shift_search_0_7;
        coarseslice0shift_search_0_7 <= coarserows_search_0;
        coarseslice0shift_search_1_0 <= coarseslice0shift_search_1_1;
        coarseslice0shift_search_1_1 <= coarseslice0shift_search_1_2;
        coarseslice0shift_search_1_2 <= coarseslice0shift_search_1_3;
        coarseslice0shift_search_1_3 <= coarseslice0shift_search_1_4;
        coarseslice0shift_search_1_4 <= coarseslice0shift_search_1_5;
        coarseslice0shift_search_1_5 <= coarseslice0shift_search_1_6;
        coarseslice0shift_search_1_6 <= coarseslice0shift_search_1_7;
        coarseslice0shift_search_1_7 <= coarserows_search_1;
        coarseslice0shift_search_2_0 <= coarseslice0shift_search_2_1;
        coarseslice0shift_search_2_1 <= coarseslice0shift_search_2_2;
        coarseslice0shift_search_2_2 <= coarseslice0shift_search_2_3;
        coarseslice0shift_search_2_3 <= coarseslice0shift_search_2_4;
        coarseslice0shift_search_2_4 <= coarseslice0shift_search_2_5;
        coarseslice0shift_search_2_5 <= coarseslice0shift_search_2_6;
        coarseslice0shift_search_2_6 <= coarseslice0shift_search_2_7;
        coarseslice0shift_search_2_7 <= coarserows_search_2;
        coarseslice0shift_search_3_0 <= coarseslice0shift_search_3_1;
        coarseslice0shift_search_3_1 <= coarseslice0shift_search_3_2;
        coarseslice0shift_search_3_2 <= coarseslice0shift_search_3_3;
        coarseslice0shift_search_3_3 <= coarseslice0shift_search_3_4;
        coarseslice0shift_search_3_4 <= coarseslice0shift_search_3_5;
        coarseslice0shift_search_3_5 <= coarseslice0shift_search_3_6;
        coarseslice0shift_search_3_6 <= coarseslice0shift_search_3_7;
        coarseslice0shift_search_3_7 <= coarserows_search_3;
        coarseslice0shift_search_4_0 <= coarseslice0shift_search_4_1;
        coarseslice0shift_search_4_1 <= coarseslice0shift_search_4_2;
        coarseslice0shift_search_4_2 <= coarseslice0shift_search_4_3;
        coarseslice0shift_search_4_3 <= coarseslice0shift_search_4_4;
        coarseslice0shift_search_4_4 <= coarseslice0shift_search_4_5;
        coarseslice0shift_search_4_5 <= coarseslice0shift_search_4_6;
        coarseslice0shift_search_4_6 <= coarseslice0shift_search_4_7;
        coarseslice0shift_search_4_7 <= coarserows_search_4;
        coarseslice0shift_search_5_0 <= coarseslice0shift_search_5_1;
        coarseslice0shift_search_5_1 <= coarseslice0shift_search_5_2;
        coarseslice0shift_search_5_2 <= coarseslice0shift_search_5_3;
        coarseslice0shift_search_5_3 <= coarseslice0shift_search_5_4;
        coarseslice0shift_search_5_4 <= coarseslice0shift_search_5_5;
        coarseslice0shift_search_5_5 <= coarseslice0shift_search_5_6;
        coarseslice0shift_search_5_6 <= coarseslice0shift_search_5_7;
        coarseslice0shift_search_5_7 <= coarserows_search_5;
        coarseslice0shift_search_6_0 <= coarseslice0shift_search_6_1;
        coarseslice0shift_search_6_1 <= coarseslice0shift_search_6_2;
        coarseslice0shift_search_6_2 <= coarseslice0shift_search_6_3;
        coarseslice0shift_search_6_3 <= coarseslice0shift_search_6_4;
        coarseslice0shift_search_6_4 <= coarseslice0shift_search_6_5;
        coarseslice0shift_search_6_5 <= coarseslice0shift_search_6_6;
        coarseslice0shift_search_6_6 <= coarseslice0shift_search_6_7;
        coarseslice0shift_search_6_7 <= coarserows_search_6;
      end if;
      coarseslice0shift_reference_0 <= coarserows_reference_0;
      coarseslice0shift_reference_1 <= coarserows_reference_1;
      coarseslice0shift_reference_2 <= coarserows_reference_2;
      coarseslice0shift_reference_3 <= coarserows_reference_3;
      coarseslice0shift_reference_4 <= coarserows_reference_4;
      coarseslice0shift_reference_5 <= coarserows_reference_5;
      coarseslice0shift_reference_6 <= coarserows_reference_6;
      coarseslice0shift_tag_valid <= coarserows_tag_valid;
      coarseslice0shift_tag_border_column <= coarserows_tag_border_column;
      coarseslice0shift_tag_first_cost <= coarserows_tag_first_cost;
      coarseslice0shift_tag_map_column <= coarserows_tag_map_column;
      coarseslice0shift_tag_output_column <= coarserows_tag_output_column;
      coarseslice0shift_tag_start_of_frame <= coarserows_tag_start_of_frame;
      coarseslice0shift_tag_end_of_line <= coarserows_tag_end_of_line;
      -- coarseslice0cost
      coarseslice0cost_pixels_first_0_0_value := ((coarseslice0shift_reference_0 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_0_0_value_2 := ((coarseslice0shift_reference_0 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_0_0_value_3 := ((coarseslice0shift_reference_0 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_0_0_value_4 := ((coarseslice0shift_reference_0 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_1_0_value := ((coarseslice0shift_reference_1 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_1_0_value_2 := ((coarseslice0shift_reference_1 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_1_0_value_3 := ((coarseslice0shift_reference_1 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_1_0_value_4 := ((coarseslice0shift_reference_1 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_2_0_value := ((coarseslice0shift_reference_2 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_2_0_value_2 := ((coarseslice0shift_reference_2 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_2_0_value_3 := ((coarseslice0shift_reference_2 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_2_0_value_4 := ((coarseslice0shift_reference_2 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_3_0_value := ((coarseslice0shift_reference_3 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_3_0_value_2 := ((coarseslice0shift_reference_3 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_3_0_value_3 := ((coarseslice0shift_reference_3 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_3_0_value_4 := ((coarseslice0shift_reference_3 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_4_0_value := ((coarseslice0shift_reference_4 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_4_0_value_2 := ((coarseslice0shift_reference_4 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_4_0_value_3 := ((coarseslice0shift_reference_4 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_4_0_value_4 := ((coarseslice0shift_reference_4 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_5_0_value := ((coarseslice0shift_reference_5 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_5_0_value_2 := ((coarseslice0shift_reference_5 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_5_0_value_3 := ((coarseslice0shift_reference_5 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_5_0_value_4 := ((coarseslice0shift_reference_5 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_6_0_value := ((coarseslice0shift_reference_6 / 8) mod 2) = 1;
      coarseslice0cost_pixels_first_6_0_value_2 := ((coarseslice0shift_reference_6 / 16) mod 2) = 1;
      coarseslice0cost_pixels_first_6_0_value_3 := ((coarseslice0shift_reference_6 / 4) mod 2) = 1;
      coarseslice0cost_pixels_first_6_0_value_4 := ((coarseslice0shift_reference_6 / 2) mod 2) = 1;
      coarseslice0cost_pixels_first_0_0 <= ((as_number((coarseslice0cost_pixels_first_0_0_value /=
        (((coarseslice0shift_search_0_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_0 / 32) = 1) /=
        ((coarseslice0shift_search_0_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_0_0_value_2 /=
        (((coarseslice0shift_search_0_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_0 mod 2) =
        1) /= ((coarseslice0shift_search_0_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_0_0_value_3 /=
        (((coarseslice0shift_search_0_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_0_0_value_4 /=
        (((coarseslice0shift_search_0_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_0_1 <= ((as_number(((((coarseslice0shift_search_0_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_1 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_2 <= ((as_number(((((coarseslice0shift_search_0_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_2 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_3 <= ((as_number(((((coarseslice0shift_search_0_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_3 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_4 <= ((as_number(((((coarseslice0shift_search_0_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_4 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_5 <= ((as_number(((((coarseslice0shift_search_0_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_5 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_6 <= ((as_number(((((coarseslice0shift_search_0_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_6 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_0_7 <= ((as_number(((((coarseslice0shift_search_0_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value)) + as_number((((coarseslice0shift_search_0_7 / 32) = 1) /=
        ((coarseslice0shift_reference_0 / 32) = 1))) + as_number(((((coarseslice0shift_search_0_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_2))) * 4) + as_number((((coarseslice0shift_search_0_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_0 mod 2) = 1))) + as_number(((((coarseslice0shift_search_0_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_3)) + as_number(((((coarseslice0shift_search_0_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_0_0_value_4));
      coarseslice0cost_pixels_first_1_0 <= ((as_number((coarseslice0cost_pixels_first_1_0_value /=
        (((coarseslice0shift_search_1_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_1 / 32) = 1) /=
        ((coarseslice0shift_search_1_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_1_0_value_2 /=
        (((coarseslice0shift_search_1_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_1 mod 2) =
        1) /= ((coarseslice0shift_search_1_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_1_0_value_3 /=
        (((coarseslice0shift_search_1_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_1_0_value_4 /=
        (((coarseslice0shift_search_1_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_1_1 <= ((as_number(((((coarseslice0shift_search_1_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_1 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_2 <= ((as_number(((((coarseslice0shift_search_1_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_2 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_3 <= ((as_number(((((coarseslice0shift_search_1_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_3 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_4 <= ((as_number(((((coarseslice0shift_search_1_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_4 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_5 <= ((as_number(((((coarseslice0shift_search_1_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_5 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_6 <= ((as_number(((((coarseslice0shift_search_1_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_6 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_1_7 <= ((as_number(((((coarseslice0shift_search_1_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value)) + as_number((((coarseslice0shift_search_1_7 / 32) = 1) /=
        ((coarseslice0shift_reference_1 / 32) = 1))) + as_number(((((coarseslice0shift_search_1_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_2))) * 4) + as_number((((coarseslice0shift_search_1_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_1 mod 2) = 1))) + as_number(((((coarseslice0shift_search_1_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_3)) + as_number(((((coarseslice0shift_search_1_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_1_0_value_4));
      coarseslice0cost_pixels_first_2_0 <= ((as_number((coarseslice0cost_pixels_first_2_0_value /=
        (((coarseslice0shift_search_2_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_2 / 32) = 1) /=
        ((coarseslice0shift_search_2_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_2_0_value_2 /=
        (((coarseslice0shift_search_2_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_2 mod 2) =
        1) /= ((coarseslice0shift_search_2_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_2_0_value_3 /=
        (((coarseslice0shift_search_2_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_2_0_value_4 /=
        (((coarseslice0shift_search_2_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_2_1 <= ((as_number(((((coarseslice0shift_search_2_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_1 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_2 <= ((as_number(((((coarseslice0shift_search_2_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_2 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_3 <= ((as_number(((((coarseslice0shift_search_2_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_3 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_4 <= ((as_number(((((coarseslice0shift_search_2_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_4 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_5 <= ((as_number(((((coarseslice0shift_search_2_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_5 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_6 <= ((as_number(((((coarseslice0shift_search_2_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_6 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_2_7 <= ((as_number(((((coarseslice0shift_search_2_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value)) + as_number((((coarseslice0shift_search_2_7 / 32) = 1) /=
        ((coarseslice0shift_reference_2 / 32) = 1))) + as_number(((((coarseslice0shift_search_2_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_2))) * 4) + as_number((((coarseslice0shift_search_2_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_2 mod 2) = 1))) + as_number(((((coarseslice0shift_search_2_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_3)) + as_number(((((coarseslice0shift_search_2_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_2_0_value_4));
      coarseslice0cost_pixels_first_3_0 <= ((as_number((coarseslice0cost_pixels_first_3_0_value /=
        (((coarseslice0shift_search_3_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_3 / 32) = 1) /=
        ((coarseslice0shift_search_3_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_3_0_value_2 /=
        (((coarseslice0shift_search_3_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_3 mod 2) =
        1) /= ((coarseslice0shift_search_3_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_3_0_value_3 /=
        (((coarseslice0shift_search_3_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_3_0_value_4 /=
        (((coarseslice0shift_search_3_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_3_1 <= ((as_number(((((coarseslice0shift_search_3_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_1 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_2 <= ((as_number(((((coarseslice0shift_search_3_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_2 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_3 <= ((as_number(((((coarseslice0shift_search_3_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_3 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_4 <= ((as_number(((((coarseslice0shift_search_3_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_4 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_5 <= ((as_number(((((coarseslice0shift_search_3_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_5 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_6 <= ((as_number(((((coarseslice0shift_search_3_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_6 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_3_7 <= ((as_number(((((coarseslice0shift_search_3_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value)) + as_number((((coarseslice0shift_search_3_7 / 32) = 1) /=
        ((coarseslice0shift_reference_3 / 32) = 1))) + as_number(((((coarseslice0shift_search_3_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_2))) * 4) + as_number((((coarseslice0shift_search_3_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_3 mod 2) = 1))) + as_number(((((coarseslice0shift_search_3_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_3)) + as_number(((((coarseslice0shift_search_3_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_3_0_value_4));
      coarseslice0cost_pixels_first_4_0 <= ((as_number((coarseslice0cost_pixels_first_4_0_value /=
        (((coarseslice0shift_search_4_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_4 / 32) = 1) /=
        ((coarseslice0shift_search_4_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_4_0_value_2 /=
        (((coarseslice0shift_search_4_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_4 mod 2) =
        1) /= ((coarseslice0shift_search_4_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_4_0_value_3 /=
        (((coarseslice0shift_search_4_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_4_0_value_4 /=
        (((coarseslice0shift_search_4_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_4_1 <= ((as_number(((((coarseslice0shift_search_4_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_1 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_2 <= ((as_number(((((coarseslice0shift_search_4_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_2 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_3 <= ((as_number(((((coarseslice0shift_search_4_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_3 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_4 <= ((as_number(((((coarseslice0shift_search_4_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_4 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_5 <= ((as_number(((((coarseslice0shift_search_4_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_5 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_6 <= ((as_number(((((coarseslice0shift_search_4_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_6 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_4_7 <= ((as_number(((((coarseslice0shift_search_4_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value)) + as_number((((coarseslice0shift_search_4_7 / 32) = 1) /=
        ((coarseslice0shift_reference_4 / 32) = 1))) + as_number(((((coarseslice0shift_search_4_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_2))) * 4) + as_number((((coarseslice0shift_search_4_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_4 mod 2) = 1))) + as_number(((((coarseslice0shift_search_4_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_3)) + as_number(((((coarseslice0shift_search_4_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_4_0_value_4));
      coarseslice0cost_pixels_first_5_0 <= ((as_number((coarseslice0cost_pixels_first_5_0_value /=
        (((coarseslice0shift_search_5_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_5 / 32) = 1) /=
        ((coarseslice0shift_search_5_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_5_0_value_2 /=
        (((coarseslice0shift_search_5_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_5 mod 2) =
        1) /= ((coarseslice0shift_search_5_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_5_0_value_3 /=
        (((coarseslice0shift_search_5_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_5_0_value_4 /=
        (((coarseslice0shift_search_5_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_5_1 <= ((as_number(((((coarseslice0shift_search_5_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_1 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_2 <= ((as_number(((((coarseslice0shift_search_5_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_2 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_3 <= ((as_number(((((coarseslice0shift_search_5_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_3 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_4 <= ((as_number(((((coarseslice0shift_search_5_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_4 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_5 <= ((as_number(((((coarseslice0shift_search_5_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_5 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_6 <= ((as_number(((((coarseslice0shift_search_5_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_6 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_5_7 <= ((as_number(((((coarseslice0shift_search_5_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value)) + as_number((((coarseslice0shift_search_5_7 / 32) = 1) /=
        ((coarseslice0shift_reference_5 / 32) = 1))) + as_number(((((coarseslice0shift_search_5_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_2))) * 4) + as_number((((coarseslice0shift_search_5_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_5 mod 2) = 1))) + as_number(((((coarseslice0shift_search_5_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_3)) + as_number(((((coarseslice0shift_search_5_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_5_0_value_4));
      coarseslice0cost_pixels_first_6_0 <= ((as_number((coarseslice0cost_pixels_first_6_0_value /=
        (((coarseslice0shift_search_6_0 / 8) mod 2) = 1))) + as_number((((coarseslice0shift_reference_6 / 32) = 1) /=
        ((coarseslice0shift_search_6_0 / 32) = 1))) + as_number((coarseslice0cost_pixels_first_6_0_value_2 /=
        (((coarseslice0shift_search_6_0 / 16) mod 2) = 1)))) * 4) + as_number((((coarseslice0shift_reference_6 mod 2) =
        1) /= ((coarseslice0shift_search_6_0 mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_6_0_value_3 /=
        (((coarseslice0shift_search_6_0 / 4) mod 2) = 1))) + as_number((coarseslice0cost_pixels_first_6_0_value_4 /=
        (((coarseslice0shift_search_6_0 / 2) mod 2) = 1)));
      coarseslice0cost_pixels_first_6_1 <= ((as_number(((((coarseslice0shift_search_6_1 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_1 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_1 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_1 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_1 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_1 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_2 <= ((as_number(((((coarseslice0shift_search_6_2 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_2 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_2 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_2 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_2 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_2 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_3 <= ((as_number(((((coarseslice0shift_search_6_3 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_3 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_3 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_3 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_3 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_3 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_4 <= ((as_number(((((coarseslice0shift_search_6_4 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_4 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_4 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_4 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_4 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_4 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_5 <= ((as_number(((((coarseslice0shift_search_6_5 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_5 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_5 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_5 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_5 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_5 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_6 <= ((as_number(((((coarseslice0shift_search_6_6 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_6 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_6 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_6 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_6 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_6 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_6_7 <= ((as_number(((((coarseslice0shift_search_6_7 / 8) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value)) + as_number((((coarseslice0shift_search_6_7 / 32) = 1) /=
        ((coarseslice0shift_reference_6 / 32) = 1))) + as_number(((((coarseslice0shift_search_6_7 / 16) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_2))) * 4) + as_number((((coarseslice0shift_search_6_7 mod 2) = 1) /=
        ((coarseslice0shift_reference_6 mod 2) = 1))) + as_number(((((coarseslice0shift_search_6_7 / 4) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_3)) + as_number(((((coarseslice0shift_search_6_7 / 2) mod 2) = 1) /=
        coarseslice0cost_pixels_first_6_0_value_4));
      coarseslice0cost_pixels_first_tag_valid <= coarseslice0shift_tag_valid;
      coarseslice0cost_pixels_first_tag_border_column <= coarseslice0shift_tag_border_column;
      coarseslice0cost_pixels_first_tag_first_cost <= coarseslice0shift_tag_first_cost;
      coarseslice0cost_pixels_first_tag_map_column <= coarseslice0shift_tag_map_column;
      coarseslice0cost_pixels_first_tag_output_column <= coarseslice0shift_tag_output_column;
      coarseslice0cost_pixels_first_tag_start_of_frame <= coarseslice0shift_tag_start_of_frame;
      coarseslice0cost_pixels_first_tag_end_of_line <= coarseslice0shift_tag_end_of_line;
      coarseslice0cost_pixels_cost_0_0 <= (coarseslice0cost_pixels_first_0_0 / 4) + (coarseslice0cost_pixels_first_0_0
        mod 4);
      coarseslice0cost_pixels_cost_0_1 <= (coarseslice0cost_pixels_first_0_1 / 4) + (coarseslice0cost_pixels_first_0_1
        mod 4);
      coarseslice0cost_pixels_cost_0_2 <= (coarseslice0cost_pixels_first_0_2 / 4) + (coarseslice0cost_pixels_first_0_2
        mod 4);
      coarseslice0cost_pixels_cost_0_3 <= (coarseslice0cost_pixels_first_0_3 / 4) + (coarseslice0cost_pixels_first_0_3
        mod 4);
      coarseslice0cost_pixels_cost_0_4 <= (coarseslice0cost_pixels_first_0_4 / 4) + (coarseslice0cost_pixels_first_0_4
        mod 4);
      coarseslice0cost_pixels_cost_0_5 <= (coarseslice0cost_pixels_first_0_5 / 4) + (coarseslice0cost_pixels_first_0_5
        mod 4);
      coarseslice0cost_pixels_cost_0_6 <= (coarseslice0cost_pixels_first_0_6 / 4) + (coarseslice0cost_pixels_first_0_6
        mod 4);
      coarseslice0cost_pixels_cost_0_7 <= (coarseslice0cost_pixels_first_0_7 / 4) + (coarseslice0cost_pixels_first_0_7
        mod 4);
      coarseslice0cost_pixels_cost_1_0 <= (coarseslice0cost_pixels_first_1_0 / 4) + (coarseslice0cost_pixels_first_1_0
        mod 4);
      coarseslice0cost_pixels_cost_1_1 <= (coarseslice0cost_pixels_first_1_1 / 4) + (coarseslice0cost_pixels_first_1_1
        mod 4);
      coarseslice0cost_pixels_cost_1_2 <= (coarseslice0cost_pixels_first_1_2 / 4) + (coarseslice0cost_pixels_first_1_2
        mod 4);
      coarseslice0cost_pixels_cost_1_3 <= (coarseslice0cost_pixels_first_1_3 / 4) + (coarseslice0cost_pixels_first_1_3
        mod 4);
      coarseslice0cost_pixels_cost_1_4 <= (coarseslice0cost_pixels_first_1_4 / 4) + (coarseslice0cost_pixels_first_1_4
        mod 4);
      coarseslice0cost_pixels_cost_1_5 <= (coarseslice0cost_pixels_first_1_5 / 4) + (coarseslice0cost_pixels_first_1_5
        mod 4);
      coarseslice0cost_pixels_cost_1_6 <= (coarseslice0cost_pixels_first_1_6 / 4) + (coarseslice0cost_pixels_first_1_6
        mod 4);
      coarseslice0cost_pixels_cost_1_7 <= (coarseslice0cost_pixels_first_1_7 / 4) + (coarseslice0cost_pixels_first_1_7
        mod 4);
      coarseslice0cost_pixels_cost_2_0 <= (coarseslice0cost_pixels_first_2_0 / 4) + (coarseslice0cost_pixels_first_2_0
        mod 4);
      coarseslice0cost_pixels_cost_2_1 <= (coarseslice0cost_pixels_first_2_1 / 4) + (coarseslice0cost_pixels_first_2_1
        mod 4);
      coarseslice0cost_pixels_cost_2_2 <= (coarseslice0cost_pixels_first_2_2 / 4) + (coarseslice0cost_pixels_first_2_2
        mod 4);
      coarseslice0cost_pixels_cost_2_3 <= (coarseslice0cost_pixels_first_2_3 / 4) + (coarseslice0cost_pixels_first_2_3
        mod 4);
      coarseslice0cost_pixels_cost_2_4 <= (coarseslice0cost_pixels_first_2_4 / 4) + (coarseslice0cost_pixels_first_2_4
        mod 4);
      coarseslice0cost_pixels_cost_2_5 <= (coarseslice0cost_pixels_first_2_5 / 4) + (coarseslice0cost_pixels_first_2_5
        mod 4);
      coarseslice0cost_pixels_cost_2_6 <= (coarseslice0cost_pixels_first_2_6 / 4) + (coarseslice0cost_pixels_first_2_6
        mod 4);
      coarseslice0cost_pixels_cost_2_7 <= (coarseslice0cost_pixels_first_2_7 / 4) + (coarseslice0cost_pixels_first_2_7
        mod 4);
      coarseslice0cost_pixels_cost_3_0 <= (coarseslice0cost_pixels_first_3_0 / 4) + (coarseslice0cost_pixels_first_3_0
        mod 4);
      coarseslice0cost_pixels_cost_3_1 <= (coarseslice0cost_pixels_first_3_1 / 4) + (coarseslice0cost_pixels_first_3_1
        mod 4);
      coarseslice0cost_pixels_cost_3_2 <= (coarseslice0cost_pixels_first_3_2 / 4) + (coarseslice0cost_pixels_first_3_2
        mod 4);
      coarseslice0cost_pixels_cost_3_3 <= (coarseslice0cost_pixels_first_3_3 / 4) + (coarseslice0cost_pixels_first_3_3
        mod 4);
      coarseslice0cost_pixels_cost_3_4 <= (coarseslice0cost_pixels_first_3_4 / 4) + (coarseslice0cost_pixels_first_3_4
        mod 4);
      coarseslice0cost_pixels_cost_3_5 <= (coarseslice0cost_pixels_first_3_5 / 4) + (coarseslice0cost_pixels_first_3_5
        mod 4);
      coarseslice0cost_pixels_cost_3_6 <= (coarseslice0cost_pixels_first_3_6 / 4) + (coarseslice0cost_pixels_first_3_6
        mod 4);
      coarseslice0cost_pixels_cost_3_7 <= (coarseslice0cost_pixels_first_3_7 / 4) + (coarseslice0cost_pixels_first_3_7
        mod 4);
      coarseslice0cost_pixels_cost_4_0 <= (coarseslice0cost_pixels_first_4_0 / 4) + (coarseslice0cost_pixels_first_4_0
        mod 4);
      coarseslice0cost_pixels_cost_4_1 <= (coarseslice0cost_pixels_first_4_1 / 4) + (coarseslice0cost_pixels_first_4_1
        mod 4);
      coarseslice0cost_pixels_cost_4_2 <= (coarseslice0cost_pixels_first_4_2 / 4) + (coarseslice0cost_pixels_first_4_2
        mod 4);
      coarseslice0cost_pixels_cost_4_3 <= (coarseslice0cost_pixels_first_4_3 / 4) + (coarseslice0cost_pixels_first_4_3
        mod 4);
      coarseslice0cost_pixels_cost_4_4 <= (coarseslice0cost_pixels_first_4_4 / 4) + (coarseslice0cost_pixels_first_4_4
        mod 4);
      coarseslice0cost_pixels_cost_4_5 <= (coarseslice0cost_pixels_first_4_5 / 4) + (coarseslice0cost_pixels_first_4_5
        mod 4);
      coarseslice0cost_pixels_cost_4_6 <= (coarseslice0cost_pixels_first_4_6 / 4) + (coarseslice0cost_pixels_first_4_6
        mod 4);
      coarseslice0cost_pixels_cost_4_7 <= (coarseslice0cost_pixels_first_4_7 / 4) + (coarseslice0cost_pixels_first_4_7
        mod 4);
      coarseslice0cost_pixels_cost_5_0 <= (coarseslice0cost_pixels_first_5_0 / 4) + (coarseslice0cost_pixels_first_5_0
        mod 4);
      coarseslice0cost_pixels_cost_5_1 <= (coarseslice0cost_pixels_first_5_1 / 4) + (coarseslice0cost_pixels_first_5_1
        mod 4);
      coarseslice0cost_pixels_cost_5_2 <= (coarseslice0cost_pixels_first_5_2 / 4) + (coarseslice0cost_pixels_first_5_2
        mod 4);
      coarseslice0cost_pixels_cost_5_3 <= (coarseslice0cost_pixels_first_5_3 / 4) + (coarseslice0cost_pixels_first_5_3
        mod 4);
      coarseslice0cost_pixels_cost_5_4 <= (coarseslice0cost_pixels_first_5_4 / 4) + (coarseslice0cost_pixels_first_5_4
        mod 4);
      coarseslice0cost_pixels_cost_5_5 <= (coarseslice0cost_pixels_first_5_5 / 4) + (coarseslice0cost_pixels_first_5_5
        mod 4);
      coarseslice0cost_pixels_cost_5_6 <= (coarseslice0cost_pixels_first_5_6 / 4) + (coarseslice0cost_pixels_first_5_6
        mod 4);
      coarseslice0cost_pixels_cost_5_7 <= (coarseslice0cost_pixels_first_5_7 / 4) + (coarseslice0cost_pixels_first_5_7
        mod 4);
      coarseslice0cost_pixels_cost_6_0 <= (coarseslice0cost_pixels_first_6_0 / 4) + (coarseslice0cost_pixels_first_6_0
        mod 4);
      coarseslice0cost_pixels_cost_6_1 <= (coarseslice0cost_pixels_first_6_1 / 4) + (coarseslice0cost_pixels_first_6_1
        mod 4);
      coarseslice0cost_pixels_cost_6_2 <= (coarseslice0cost_pixels_first_6_2 / 4) + (coarseslice0cost_pixels_first_6_2
        mod 4);
      coarseslice0cost_pixels_cost_6_3 <= (coarseslice0cost_pixels_first_6_3 / 4) + (coarseslice0cost_pixels_first_6_3
        mod 4);
      coarseslice0cost_pixels_cost_6_4 <= (coarseslice0cost_pixels_first_6_4 / 4) + (coarseslice0cost_pixels_first_6_4
        mod 4);
      coarseslice0cost_pixels_cost_6_5 <= (coarseslice0cost_pixels_first_6_5 / 4) + (coarseslice0cost_pixels_first_6_5
        mod 4);
      coarseslice0cost_pixels_cost_6_6 <= (coarseslice0cost_pixels_first_6_6 / 4) + (coarseslice0cost_pixels_first_6_6
        mod 4);
      coarseslice0cost_pixels_cost_6_7 <= (coarseslice0cost_pixels_first_6_7 / 4) + (coarseslice0cost_pixels_first_6_7
        mod 4);
      coarseslice0cost_pixels_tag_valid <= coarseslice0cost_pixels_first_tag_valid;
      coarseslice0cost_pixels_tag_border_column <= coarseslice0cost_pixels_first_tag_border_column;
      coarseslice0cost_pixels_tag_first_cost <= coarseslice0cost_pixels_first_tag_first_cost;
      coarseslice0cost_pixels_tag_map_column <= coarseslice0cost_pixels_first_tag_map_column;
      coarseslice0cost_pixels_tag_output_column <= coarseslice0cost_pixels_first_tag_output_column;
      coarseslice0cost_pixels_tag_start_of_frame <= coarseslice0cost_pixels_first_tag_start_of_frame;
      coarseslice0cost_pixels_tag_end_of_line <= coarseslice0cost_pixels_first_tag_end_of_line;
      coarseslice0cost_pair_0_0 <= coarseslice0cost_pixels_cost_1_0 + coarseslice0cost_pixels_cost_2_0;
      coarseslice0cost_pair_0_1 <= coarseslice0cost_pixels_cost_1_1 + coarseslice0cost_pixels_cost_2_1;
      coarseslice0cost_pair_0_2 <= coarseslice0cost_pixels_cost_1_2 + coarseslice0cost_pixels_cost_2_2;
      coarseslice0cost_pair_0_3 <= coarseslice0cost_pixels_cost_1_3 + coarseslice0cost_pixels_cost_2_3;
      coarseslice0cost_pair_0_4 <= coarseslice0cost_pixels_cost_1_4 + coarseslice0cost_pixels_cost_2_4;
      coarseslice0cost_pair_0_5 <= coarseslice0cost_pixels_cost_1_5 + coarseslice0cost_pixels_cost_2_5;
      coarseslice0cost_pair_0_6 <= coarseslice0cost_pixels_cost_1_6 + coarseslice0cost_pixels_cost_2_6;
      coarseslice0cost_pair_0_7 <= coarseslice0cost_pixels_cost_1_7 + coarseslice0cost_pixels_cost_2_7;
      coarseslice0cost_pair_1_0 <= coarseslice0cost_pixels_cost_3_0 + coarseslice0cost_pixels_cost_4_0;
      coarseslice0cost_pair_1_1 <= coarseslice0cost_pixels_cost_3_1 + coarseslice0cost_pixels_cost_4_1;
      coarseslice0cost_pair_1_2 <= coarseslice0cost_pixels_cost_3_2 + coarseslice0cost_pixels_cost_4_2;
      coarseslice0cost_pair_1_3 <= coarseslice0cost_pixels_cost_3_3 + coarseslice0cost_pixels_cost_4_3;
      coarseslice0cost_pair_1_4 <= coarseslice0cost_pixels_cost_3_4 + coarseslice0cost_pixels_cost_4_4;
      coarseslice0cost_pair_1_5 <= coarseslice0cost_pixels_cost_3_5 + coarseslice0cost_pixels_cost_4_5;
      coarseslice0cost_pair_1_6 <= coarseslice0cost_pixels_cost_3_6 + coarseslice0cost_pixels_cost_4_6;
      coarseslice0cost_pair_1_7 <= coarseslice0cost_pixels_cost_3_7 + coarseslice0cost_pixels_cost_4_7;
      coarseslice0cost_pair_2_0 <= coarseslice0cost_pixels_cost_5_0 + coarseslice0cost_pixels_cost_6_0;
      coarseslice0cost_pair_2_1 <= coarseslice0cost_pixels_cost_5_1 + coarseslice0cost_pixels_cost_6_1;
      coarseslice0cost_pair_2_2 <= coarseslice0cost_pixels_cost_5_2 + coarseslice0cost_pixels_cost_6_2;
      coarseslice0cost_pair_2_3 <= coarseslice0cost_pixels_cost_5_3 + coarseslice0cost_pixels_cost_6_3;
      coarseslice0cost_pair_2_4 <= coarseslice0cost_pixels_cost_5_4 + coarseslice0cost_pixels_cost_6_4;
      coarseslice0cost_pair_2_5 <= coarseslice0cost_pixels_cost_5_5 + coarseslice0cost_pixels_cost_6_5;
      coarseslice0cost_pair_2_6 <= coarseslice0cost_pixels_cost_5_6 + coarseslice0cost_pixels_cost_6_6;
      coarseslice0cost_pair_2_7 <= coarseslice0cost_pixels_cost_5_7 + coarseslice0cost_pixels_cost_6_7;
      coarseslice0cost_single_0_0 <= coarseslice0cost_pixels_cost_0_0;
      coarseslice0cost_single_0_1 <= coarseslice0cost_pixels_cost_0_1;
      coarseslice0cost_single_0_2 <= coarseslice0cost_pixels_cost_0_2;
      coarseslice0cost_single_0_3 <= coarseslice0cost_pixels_cost_0_3;
      coarseslice0cost_single_0_4 <= coarseslice0cost_pixels_cost_0_4;
      coarseslice0cost_single_0_5 <= coarseslice0cost_pixels_cost_0_5;
      coarseslice0cost_single_0_6 <= coarseslice0cost_pixels_cost_0_6;
      coarseslice0cost_single_0_7 <= coarseslice0cost_pixels_cost_0_7;
      coarseslice0cost_pair_tag_valid <= coarseslice0cost_pixels_tag_valid;
      coarseslice0cost_pair_tag_border_column <= coarseslice0cost_pixels_tag_border_column;
      coarseslice0cost_pair_tag_first_cost <= coarseslice0cost_pixels_tag_first_cost;
      coarseslice0cost_pair_tag_map_column <= coarseslice0cost_pixels_tag_map_column;
      coarseslice0cost_pair_tag_output_column <= coarseslice0cost_pixels_tag_output_column;
      coarseslice0cost_pair_tag_start_of_frame <= coarseslice0cost_pixels_tag_start_of_frame;
      coarseslice0cost_pair_tag_end_of_line <= coarseslice0cost_pixels_tag_end_of_line;
      coarseslice0cost_tag_valid <= coarseslice0cost_pair_tag_valid;
      coarseslice0cost_tag_first_cost <= coarseslice0cost_pair_tag_first_cost;
      coarseslice0cost_tag_map_column <= coarseslice0cost_pair_tag_map_column;
      coarseslice0cost_tag_output_column <= coarseslice0cost_pair_tag_output_column;
      coarseslice0cost_tag_start_of_frame <= coarseslice0cost_pair_tag_start_of_frame;
      coarseslice0cost_tag_end_of_line <= coarseslice0cost_pair_tag_end_of_line;
      if coarseslice0cost_pair_tag_border_column then
        coarseslice0cost_column_0_0 <= 0;
        coarseslice0cost_column_0_1 <= 0;
        coarseslice0cost_column_0_2 <= 0;
        coarseslice0cost_column_0_3 <= 0;
        coarseslice0cost_column_0_4 <= 0;
        coarseslice0cost_column_0_5 <= 0;
        coarseslice0cost_column_0_6 <= 0;
        coarseslice0cost_column_0_7 <= 0;
      else
        coarseslice0cost_column_0_0 <= coarseslice0cost_pair_1_0 + coarseslice0cost_pair_2_0 +
          coarseslice0cost_pair_0_0 + coarseslice0cost_single_0_0;
        coarseslice0cost_column_0_1 <= coarseslice0cost_pair_1_1 + coarseslice0cost_pair_2_1 +
          coarseslice0cost_pair_0_1 + coarseslice0cost_single_0_1;
        coarseslice0cost_column_0_2 <= coarseslice0cost_pair_1_2 + coarseslice0cost_pair_2_2 +
          coarseslice0cost_pair_0_2 + coarseslice0cost_single_0_2;
        coarseslice0cost_column_0_3 <= coarseslice0cost_pair_1_3 + coarseslice0cost_pair_2_3 +
          coarseslice0cost_pair_0_3 + coarseslice0cost_single_0_3;
        coarseslice0cost_column_0_4 <= coarseslice0cost_pair_1_4 + coarseslice0cost_pair_2_4 +
          coarseslice0cost_pair_0_4 + coarseslice0cost_single_0_4;
        coarseslice0cost_column_0_5 <= coarseslice0cost_pair_1_5 + coarseslice0cost_pair_2_5 +
          coarseslice0cost_pair_0_5 + coarseslice0cost_single_0_5;
        coarseslice0cost_column_0_6 <= coarseslice0cost_pair_1_6 + coarseslice0cost_pair_2_6 +
          coarseslice0cost_pair_0_6 + coarseslice0cost_single_0_6;
        coarseslice0cost_column_0_7 <= coarseslice0cost_pair_1_7 + coarseslice0cost_pair_2_7 +
          coarseslice0cost_pair_0_7 + coarseslice0cost_single_0_7;
      end if;
      -- coarseslice0window
      if coarseslice0cost_tag_valid then
        coarseslice0window_partial_0_0_0 <= coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_0_1 <= coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_0_2 <= coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_0_3 <= coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_0_4 <= coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_0_5 <= coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_0_6 <= coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_0_7 <= coarseslice0cost_column_0_7;
        coarseslice0window_partial_0_1_0 <= coarseslice0window_partial_0_0_0 + coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_1_1 <= coarseslice0window_partial_0_0_1 + coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_1_2 <= coarseslice0window_partial_0_0_2 + coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_1_3 <= coarseslice0window_partial_0_0_3 + coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_1_4 <= coarseslice0window_partial_0_0_4 + coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_1_5 <= coarseslice0window_partial_0_0_5 + coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_1_6 <= coarseslice0window_partial_0_0_6 + coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_1_7 <= coarseslice0window_partial_0_0_7 + coarseslice0cost_column_0_7;
        coarseslice0window_partial_0_2_0 <= coarseslice0window_partial_0_1_0 + coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_2_1 <= coarseslice0window_partial_0_1_1 + coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_2_2 <= coarseslice0window_partial_0_1_2 + coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_2_3 <= coarseslice0window_partial_0_1_3 + coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_2_4 <= coarseslice0window_partial_0_1_4 + coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_2_5 <= coarseslice0window_partial_0_1_5 + coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_2_6 <= coarseslice0window_partial_0_1_6 + coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_2_7 <= coarseslice0window_partial_0_1_7 + coarseslice0cost_column_0_7;
        coarseslice0window_partial_0_3_0 <= coarseslice0window_partial_0_2_0 + coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_3_1 <= coarseslice0window_partial_0_2_1 + coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_3_2 <= coarseslice0window_partial_0_2_2 + coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_3_3 <= coarseslice0window_partial_0_2_3 + coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_3_4 <= coarseslice0window_partial_0_2_4 + coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_3_5 <= coarseslice0window_partial_0_2_5 + coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_3_6 <= coarseslice0window_partial_0_2_6 + coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_3_7 <= coarseslice0window_partial_0_2_7 + coarseslice0cost_column_0_7;
        coarseslice0window_partial_0_4_0 <= coarseslice0window_partial_0_3_0 + coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_4_1 <= coarseslice0window_partial_0_3_1 + coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_4_2 <= coarseslice0window_partial_0_3_2 + coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_4_3 <= coarseslice0window_partial_0_3_3 + coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_4_4 <= coarseslice0window_partial_0_3_4 + coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_4_5 <= coarseslice0window_partial_0_3_5 + coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_4_6 <= coarseslice0window_partial_0_3_6 + coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_4_7 <= coarseslice0window_partial_0_3_7 + coarseslice0cost_column_0_7;
        coarseslice0window_partial_0_5_0 <= coarseslice0window_partial_0_4_0 + coarseslice0cost_column_0_0;
        coarseslice0window_partial_0_5_1 <= coarseslice0window_partial_0_4_1 + coarseslice0cost_column_0_1;
        coarseslice0window_partial_0_5_2 <= coarseslice0window_partial_0_4_2 + coarseslice0cost_column_0_2;
        coarseslice0window_partial_0_5_3 <= coarseslice0window_partial_0_4_3 + coarseslice0cost_column_0_3;
        coarseslice0window_partial_0_5_4 <= coarseslice0window_partial_0_4_4 + coarseslice0cost_column_0_4;
        coarseslice0window_partial_0_5_5 <= coarseslice0window_partial_0_4_5 + coarseslice0cost_column_0_5;
        coarseslice0window_partial_0_5_6 <= coarseslice0window_partial_0_4_6 + coarseslice0cost_column_0_6;
        coarseslice0window_partial_0_5_7 <= coarseslice0window_partial_0_4_7 + coarseslice0cost_column_0_7;
        coarseslice0window_centre_map_column_0 <= coarseslice0cost_tag_map_column;
        coarseslice0window_centre_map_column_1 <= coarseslice0window_centre_map_column_0;
        coarseslice0window_centre_map_column_2 <= coarseslice0window_centre_map_column_1;
        coarseslice0window_centre_output_column_0 <= coarseslice0cost_tag_output_column;
        coarseslice0window_centre_output_column_1 <= coarseslice0window_centre_output_column_0;
        coarseslice0window_centre_output_column_2 <= coarseslice0window_centre_output_column_1;
        coarseslice0window_centre_first_column_0 <= coarseslice0cost_tag_first_cost;
        coarseslice0window_centre_first_column_1 <= coarseslice0window_centre_first_column_0;
        coarseslice0window_centre_first_column_2 <= coarseslice0window_centre_first_column_1;
        coarseslice0window_centre_start_of_frame_0 <= coarseslice0cost_tag_start_of_frame;
        coarseslice0window_centre_start_of_frame_1 <= coarseslice0window_centre_start_of_frame_0;
        coarseslice0window_centre_start_of_frame_2 <= coarseslice0window_centre_start_of_frame_1;
        coarseslice0window_centre_end_of_line_0 <= coarseslice0cost_tag_end_of_line;
        coarseslice0window_centre_end_of_line_1 <= coarseslice0window_centre_end_of_line_0;
        coarseslice0window_centre_end_of_line_2 <= coarseslice0window_centre_end_of_line_1;
      end if;
      coarseslice0window_sum_0_0 <= coarseslice0window_partial_0_5_0 + coarseslice0cost_column_0_0;
      coarseslice0window_sum_0_1 <= coarseslice0window_partial_0_5_1 + coarseslice0cost_column_0_1;
      coarseslice0window_sum_0_2 <= coarseslice0window_partial_0_5_2 + coarseslice0cost_column_0_2;
      coarseslice0window_sum_0_3 <= coarseslice0window_partial_0_5_3 + coarseslice0cost_column_0_3;
      coarseslice0window_sum_0_4 <= coarseslice0window_partial_0_5_4 + coarseslice0cost_column_0_4;
      coarseslice0window_sum_0_5 <= coarseslice0window_partial_0_5_5 + coarseslice0cost_column_0_5;
      coarseslice0window_sum_0_6 <= coarseslice0window_partial_0_5_6 + coarseslice0cost_column_0_6;
      coarseslice0window_sum_0_7 <= coarseslice0window_partial_0_5_7 + coarseslice0cost_column_0_7;
      coarseslice0window_tag_valid <= coarseslice0cost_tag_valid;
      coarseslice0window_tag_map_column <= coarseslice0window_centre_map_column_2;
      coarseslice0window_tag_output_column <= coarseslice0window_centre_output_column_2;
      coarseslice0window_tag_first_column <= coarseslice0window_centre_first_column_2;
      coarseslice0window_tag_start_of_frame <= coarseslice0window_centre_start_of_frame_2;
      coarseslice0window_tag_end_of_line <= coarseslice0window_centre_end_of_line_2;
      -- coarseslice0other
      coarseslice0other_cost_0_1_all := coarseslice0window_tag_output_column and coarseslice0window_tag_first_column;
      if (coarseslice0other_cost_0_2 - coarseslice0window_sum_0_1) >= 0 then
        coarseslice0other_cost_0_1_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_1_choice := coarseslice0other_cost_0_1_all;
      end if;
      if (coarseslice0other_cost_0_3 - coarseslice0window_sum_0_2) >= 0 then
        coarseslice0other_cost_0_2_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_2_choice := coarseslice0other_cost_0_1_all;
      end if;
      if (coarseslice0other_cost_0_4 - coarseslice0window_sum_0_3) >= 0 then
        coarseslice0other_cost_0_3_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_3_choice := coarseslice0other_cost_0_1_all;
      end if;
      if (coarseslice0other_cost_0_5 - coarseslice0window_sum_0_4) >= 0 then
        coarseslice0other_cost_0_4_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_4_choice := coarseslice0other_cost_0_1_all;
      end if;
      if (coarseslice0other_cost_0_6 - coarseslice0window_sum_0_5) >= 0 then
        coarseslice0other_cost_0_5_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_5_choice := coarseslice0other_cost_0_1_all;
      end if;
      if (coarseslice0other_cost_0_7 - coarseslice0window_sum_0_6) >= 0 then
        coarseslice0other_cost_0_6_choice := coarseslice0window_tag_output_column;
      else
        coarseslice0other_cost_0_6_choice := coarseslice0other_cost_0_1_all;
      end if;
      if coarseslice0window_tag_valid then
        if coarseslice0other_cost_0_1_choice then
          coarseslice0other_cost_0_1 <= coarseslice0window_sum_0_1;
          coarseslice0other_winner_0_1 <= 1;
        else
          coarseslice0other_cost_0_1 <= coarseslice0other_cost_0_2;
          coarseslice0other_winner_0_1 <= coarseslice0other_winner_0_2;
        end if;
        if coarseslice0other_cost_0_2_choice then
          coarseslice0other_cost_0_2 <= coarseslice0window_sum_0_2;
          coarseslice0other_winner_0_2 <= 2;
        else
          coarseslice0other_cost_0_2 <= coarseslice0other_cost_0_3;
          coarseslice0other_winner_0_2 <= coarseslice0other_winner_0_3;
        end if;
        if coarseslice0other_cost_0_3_choice then
          coarseslice0other_cost_0_3 <= coarseslice0window_sum_0_3;
          coarseslice0other_winner_0_3 <= 3;
        else
          coarseslice0other_cost_0_3 <= coarseslice0other_cost_0_4;
          coarseslice0other_winner_0_3 <= coarseslice0other_winner_0_4;
        end if;
        if coarseslice0other_cost_0_4_choice then
          coarseslice0other_cost_0_4 <= coarseslice0window_sum_0_4;
          coarseslice0other_winner_0_4 <= 4;
        else
          coarseslice0other_cost_0_4 <= coarseslice0other_cost_0_5;
          coarseslice0other_winner_0_4 <= coarseslice0other_winner_0_5;
        end if;
        if coarseslice0other_cost_0_5_choice then
          coarseslice0other_cost_0_5 <= coarseslice0window_sum_0_5;
          coarseslice0other_winner_0_5 <= 5;
        else
          coarseslice0other_cost_0_5 <= coarseslice0other_cost_0_6;
          coarseslice0other_winner_0_5 <= coarseslice0other_winner_0_6;
        end if;
        if coarseslice0other_cost_0_6_choice then
          coarseslice0other_cost_0_6 <= coarseslice0window_sum_0_6;
          coarseslice0other_winner_0_6 <= 6;
        else
          coarseslice0other_cost_0_6 <= coarseslice0other_cost_0_7;
          coarseslice0other_winner_0_6 <= coarseslice0other_winner_0_7;
        end if;
        if coarseslice0window_tag_output_column then
          coarseslice0other_cost_0_7 <= coarseslice0window_sum_0_7;
          coarseslice0other_winner_0_7 <= 7;
        else
          coarseslice0other_cost_0_7 <= 0;
          coarseslice0other_winner_0_7 <= 0;
        end if;
        if coarseslice0window_tag_output_column and (((coarseslice0other_cost_0_1 - coarseslice0window_sum_0_0) >= 0)
          or coarseslice0window_tag_first_column) then
          coarseslice0other_winner_0_0 <= 0;
        else
          coarseslice0other_winner_0_0 <= coarseslice0other_winner_0_1;
        end if;
      end if;
      coarseslice0other_winner_out_0 <= coarseslice0other_winner_0_0;
      -- coarseslice0winner1
      coarseslice0winner1_of_pair_0_0_is_less := (coarseslice0window_sum_0_1 - coarseslice0window_sum_0_0) < 0;
      coarseslice0winner1_of_pair_0_2_is_less := (coarseslice0window_sum_0_3 - coarseslice0window_sum_0_2) < 0;
      coarseslice0winner1_of_pair_0_4_is_less := (coarseslice0window_sum_0_5 - coarseslice0window_sum_0_4) < 0;
      coarseslice0winner1_of_pair_0_6_is_less := (coarseslice0window_sum_0_7 - coarseslice0window_sum_0_6) < 0;
      coarseslice0winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(coarseslice0winner1_of_pair_0_2, 9)) or
        (to_unsigned(coarseslice0winner1_of_pair_0_3, 9)))) - to_integer(((to_unsigned(coarseslice0winner1_of_pair_0_0,
        9)) or (to_unsigned(coarseslice0winner1_of_pair_0_1, 9))))) < 0;
      coarseslice0winner1_of_four_0_4_is_less := (to_integer(((to_unsigned(coarseslice0winner1_of_pair_0_6, 9)) or
        (to_unsigned(coarseslice0winner1_of_pair_0_7, 9)))) - to_integer(((to_unsigned(coarseslice0winner1_of_pair_0_4,
        9)) or (to_unsigned(coarseslice0winner1_of_pair_0_5, 9))))) < 0;
      coarseslice0winner1_pair_index_0_0 <= coarseslice0winner1_of_pair_0_0_is_less;
      coarseslice0winner1_pair_tag_valid <= coarseslice0window_tag_valid;
      coarseslice0winner1_pair_tag_map_column <= coarseslice0window_tag_map_column;
      coarseslice0winner1_pair_tag_output_column <= coarseslice0window_tag_output_column;
      coarseslice0winner1_pair_tag_start_of_frame <= coarseslice0window_tag_start_of_frame;
      coarseslice0winner1_pair_tag_end_of_line <= coarseslice0window_tag_end_of_line;
      coarseslice0winner1_four_tag_valid <= coarseslice0winner1_pair_tag_valid;
      coarseslice0winner1_four_tag_map_column <= coarseslice0winner1_pair_tag_map_column;
      coarseslice0winner1_four_tag_output_column <= coarseslice0winner1_pair_tag_output_column;
      coarseslice0winner1_four_tag_start_of_frame <= coarseslice0winner1_pair_tag_start_of_frame;
      coarseslice0winner1_four_tag_end_of_line <= coarseslice0winner1_pair_tag_end_of_line;
      coarseslice0winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(coarseslice0winner1_of_four_0_2, 9)) or
        (to_unsigned(coarseslice0winner1_of_four_0_3, 9)))) or (to_unsigned(coarseslice0winner1_of_four_0_1, 9)))) or
        (to_unsigned(coarseslice0winner1_of_four_0_0, 9))));
      coarseslice0winner1_best_cost_0_1 <= to_integer(((((((to_unsigned(coarseslice0winner1_of_four_0_6, 9)) or
        (to_unsigned(coarseslice0winner1_of_four_0_7, 9)))) or (to_unsigned(coarseslice0winner1_of_four_0_5, 9)))) or
        (to_unsigned(coarseslice0winner1_of_four_0_4, 9))));
      coarseslice0winner1_best_index_0_0 <= coarseslice0winner1_four_index_0_0;
      coarseslice0winner1_best_index_0_1 <= coarseslice0winner1_four_index_0_1;
      coarseslice0winner1_tag_valid <= coarseslice0winner1_four_tag_valid;
      coarseslice0winner1_tag_map_column <= coarseslice0winner1_four_tag_map_column;
      coarseslice0winner1_tag_output_column <= coarseslice0winner1_four_tag_output_column;
      coarseslice0winner1_tag_start_of_frame <= coarseslice0winner1_four_tag_start_of_frame;
      coarseslice0winner1_tag_end_of_line <= coarseslice0winner1_four_tag_end_of_line;
      if coarseslice0winner1_of_pair_0_0_is_less then
        coarseslice0winner1_of_pair_0_0 <= 0;
        coarseslice0winner1_of_pair_0_1 <= coarseslice0window_sum_0_1;
      else
        coarseslice0winner1_of_pair_0_0 <= coarseslice0window_sum_0_0;
        coarseslice0winner1_of_pair_0_1 <= 0;
      end if;
      if coarseslice0winner1_of_pair_0_2_is_less then
        coarseslice0winner1_of_pair_0_2 <= 0;
        coarseslice0winner1_of_pair_0_3 <= coarseslice0window_sum_0_3;
        coarseslice0winner1_pair_index_0_1 <= 3;
      else
        coarseslice0winner1_of_pair_0_2 <= coarseslice0window_sum_0_2;
        coarseslice0winner1_of_pair_0_3 <= 0;
        coarseslice0winner1_pair_index_0_1 <= 2;
      end if;
      if coarseslice0winner1_of_pair_0_4_is_less then
        coarseslice0winner1_of_pair_0_4 <= 0;
        coarseslice0winner1_of_pair_0_5 <= coarseslice0window_sum_0_5;
        coarseslice0winner1_pair_index_0_2 <= 5;
      else
        coarseslice0winner1_of_pair_0_4 <= coarseslice0window_sum_0_4;
        coarseslice0winner1_of_pair_0_5 <= 0;
        coarseslice0winner1_pair_index_0_2 <= 4;
      end if;
      if coarseslice0winner1_of_pair_0_6_is_less then
        coarseslice0winner1_of_pair_0_6 <= 0;
        coarseslice0winner1_of_pair_0_7 <= coarseslice0window_sum_0_7;
        coarseslice0winner1_pair_index_0_3 <= 7;
      else
        coarseslice0winner1_of_pair_0_6 <= coarseslice0window_sum_0_6;
        coarseslice0winner1_of_pair_0_7 <= 0;
        coarseslice0winner1_pair_index_0_3 <= 6;
      end if;
      if coarseslice0winner1_of_four_0_0_is_less then
        coarseslice0winner1_of_four_0_0 <= 0;
        coarseslice0winner1_of_four_0_1 <= 0;
        coarseslice0winner1_of_four_0_2 <= coarseslice0winner1_of_pair_0_2;
        coarseslice0winner1_of_four_0_3 <= coarseslice0winner1_of_pair_0_3;
        coarseslice0winner1_four_index_0_0 <= coarseslice0winner1_pair_index_0_1;
      else
        coarseslice0winner1_of_four_0_0 <= coarseslice0winner1_of_pair_0_0;
        coarseslice0winner1_of_four_0_1 <= coarseslice0winner1_of_pair_0_1;
        coarseslice0winner1_of_four_0_2 <= 0;
        coarseslice0winner1_of_four_0_3 <= 0;
        coarseslice0winner1_four_index_0_0 <= as_number(coarseslice0winner1_pair_index_0_0);
      end if;
      if coarseslice0winner1_of_four_0_4_is_less then
        coarseslice0winner1_of_four_0_4 <= 0;
        coarseslice0winner1_of_four_0_5 <= 0;
        coarseslice0winner1_of_four_0_6 <= coarseslice0winner1_of_pair_0_6;
        coarseslice0winner1_of_four_0_7 <= coarseslice0winner1_of_pair_0_7;
        coarseslice0winner1_four_index_0_1 <= coarseslice0winner1_pair_index_0_3;
      else
        coarseslice0winner1_of_four_0_4 <= coarseslice0winner1_of_pair_0_4;
        coarseslice0winner1_of_four_0_5 <= coarseslice0winner1_of_pair_0_5;
        coarseslice0winner1_of_four_0_6 <= 0;
        coarseslice0winner1_of_four_0_7 <= 0;
        coarseslice0winner1_four_index_0_1 <= coarseslice0winner1_pair_index_0_2;
      end if;
      -- coarseslice0winner2
      coarseslice0winner2_tag_valid <= coarseslice0winner1_tag_valid;
      coarseslice0winner2_tag_map_column <= coarseslice0winner1_tag_map_column;
      coarseslice0winner2_tag_output_column <= coarseslice0winner1_tag_output_column;
      coarseslice0winner2_tag_start_of_frame <= coarseslice0winner1_tag_start_of_frame;
      coarseslice0winner2_tag_end_of_line <= coarseslice0winner1_tag_end_of_line;
      if (coarseslice0winner1_best_cost_0_1 - coarseslice0winner1_best_cost_0_0) < 0 then
        coarseslice0winner2_best_index_0_0 <= coarseslice0winner1_best_index_0_1;
      else
        coarseslice0winner2_best_index_0_0 <= coarseslice0winner1_best_index_0_0;
      end if;
      -- coarseslice0
      coarseslice0_best_index_0_0 <= coarseslice0winner2_best_index_0_0;
      coarseslice0_best_tag_valid <= coarseslice0winner2_tag_valid;
      coarseslice0_best_tag_map_column <= coarseslice0winner2_tag_map_column;
      coarseslice0_best_tag_output_column <= coarseslice0winner2_tag_output_column;
      coarseslice0_best_tag_start_of_frame <= coarseslice0winner2_tag_start_of_frame;
      coarseslice0_best_tag_end_of_line <= coarseslice0winner2_tag_end_of_line;
      -- coarseleftright
      coarseleftright_holds_winners_all := (not coarseleftright_holds_winners) and (((coarseleftright_ring_read_address
        / 4) = 1) or (((coarseleftright_ring_read_address / 2) mod 2) = 1) or ((coarseleftright_ring_read_address mod
        2) = 1));
      coarseleftright_address_0_value := to_integer(coarseleftright_held_0(6 downto 4));
      coarseleftright_checked_passed_0_sum := (1 - to_integer(coarseleftright_found_0)) +
        coarseleftright_answered_disparity_0;
      coarseleftright_other_1_0 <= coarseslice0other_winner_out_0;
      coarseleftright_other_2_0 <= coarseleftright_other_1_0;
      coarseleftright_other_3_0 <= coarseleftright_other_2_0;
      coarseleftright_position <= (coarseleftright_position + as_number(coarseslice0_best_tag_valid)) mod 16;
      coarseleftright_held_position <= coarseleftright_position;
      coarseleftright_held_valid <= (not coarseleftright_holds_winners_all) and coarseslice0_best_tag_valid;
      coarseleftright_address_0 <= (coarseleftright_address_0_value + coarseleftright_held_position + 9) mod 16;
      coarseleftright_asking_disparity_0 <= coarseleftright_address_0_value;
      coarseleftright_asking_passed_0 <= to_integer(coarseleftright_held_0(12 downto 12)) = 1;
      coarseleftright_asking_tag_valid <= coarseleftright_held_valid;
      coarseleftright_asking_tag_output_column <= to_integer(coarseleftright_held_0(1 downto 1)) = 1;
      coarseleftright_asking_tag_start_of_frame <= to_integer(coarseleftright_held_0(2 downto 2)) = 1;
      coarseleftright_answered_disparity_0 <= coarseleftright_asking_disparity_0;
      coarseleftright_answered_passed_0 <= coarseleftright_asking_passed_0;
      coarseleftright_answered_tag_valid <= coarseleftright_asking_tag_valid;
      coarseleftright_answered_tag_output_column <= coarseleftright_asking_tag_output_column;
      coarseleftright_answered_tag_start_of_frame <= coarseleftright_asking_tag_start_of_frame;
      coarseleftright_checked_disparity_0 <= coarseleftright_answered_disparity_0;
      coarseleftright_checked_passed_0 <= coarseleftright_answered_passed_0 and (coarseleftright_checked_passed_0_sum
        >= 0) and (coarseleftright_checked_passed_0_sum < 3);
      coarseleftright_checked_tag_valid <= coarseleftright_answered_tag_valid;
      coarseleftright_checked_tag_output_column <= coarseleftright_answered_tag_output_column;
      coarseleftright_checked_tag_start_of_frame <= coarseleftright_answered_tag_start_of_frame;
      if coarseleftright_holds_winners_all then
        coarseleftright_holds_winners <= (not coarseslice0_best_tag_valid) and coarseleftright_holds_winners;
      else
        coarseleftright_holds_winners <= coarseslice0_best_tag_valid or coarseleftright_holds_winners;
      end if;
      if coarseslice0_best_tag_valid then
        coarseleftright_ring_write_address <= coarseleftright_ring_read_address;
        if coarseleftright_ring_read_address = 7 then
          coarseleftright_ring_read_address <= 0;
        else
          coarseleftright_ring_read_address <= (coarseleftright_ring_read_address + 1) mod 8;
        end if;
      end if;
      -- ranges
      if (ranges_row / 2) = 4 then
        ranges_column_choice := ((ranges_row mod 2) = 1) and ((ranges_column mod 2) = 1);
      else
        ranges_column_choice := (ranges_column mod 2) = 1;
      end if;
      if (ranges_column / 2) = 8 then
        ranges_column_choice_2 := ranges_column_choice;
      else
        ranges_column_choice_2 := ((ranges_row / 2) /= 4) or ((ranges_row mod 2) = 1);
      end if;
      ranges_column_all := coarseleftright_checked_tag_valid and coarseleftright_checked_tag_output_column;
      ranges_column_all_2 := coarseleftright_checked_tag_start_of_frame and coarseleftright_checked_tag_valid and
        coarseleftright_checked_tag_output_column;
      ranges_column_any := (ranges_row /= 9) or ranges_column_all_2;
      if ranges_column_all then
        ranges_column_choice_3 := ranges_column_any;
      else
        ranges_column_choice_3 := ranges_column_all_2;
      end if;
      if ranges_column_choice_2 then
        ranges_column_choice_4 := ranges_column_choice_3;
      else
        ranges_column_choice_4 := ranges_column_any;
      end if;
      ranges_column_is_equal := (ranges_column / 4) = 4;
      ranges_column_any_2 := ranges_column_all_2 or ((ranges_column mod 4) = 0);
      ranges_column_any_3 := (not coarseleftright_checked_tag_start_of_frame) or (not
        coarseleftright_checked_tag_valid) or (not coarseleftright_checked_tag_output_column);
      if ranges_column_any_3 then
        ranges_column_choice_5 := ranges_column;
      else
        ranges_column_choice_5 := 0;
      end if;
      if (not ranges_column_all_2) and ranges_column_is_equal and ranges_column_any_2 then
        ranges_column_choice_6 := 0;
      else
        ranges_column_choice_6 := (ranges_column_choice_5 + 1) mod 32;
      end if;
      if ranges_column_any_3 then
        ranges_row_choice := ranges_row;
      else
        ranges_row_choice := 0;
      end if;
      ranges_row_all := (ranges_row = 9) and (not ranges_column_all_2);
      if ranges_column_all then
        ranges_row_choice_2 := ranges_row_all;
      else
        ranges_row_choice_2 := not ranges_column_all_2;
      end if;
      if ranges_column_choice_2 then
        ranges_row_choice_3 := ranges_row_choice_2;
      else
        ranges_row_choice_3 := ranges_row_all;
      end if;
      if ranges_column_choice_2 then
        ranges_pixel_0_choice := coarseleftright_checked_tag_valid and coarseleftright_checked_tag_output_column and
          coarseleftright_checked_passed_0;
      else
        ranges_pixel_0_choice := coarseleftright_checked_tag_valid and coarseleftright_checked_tag_output_column and
          coarseleftright_checked_tag_start_of_frame and coarseleftright_checked_passed_0;
      end if;
      ranges_centre_valid_differs := ranges_ready_row /= 0;
      ranges_counts_sum := (ranges_middle mod 8) + 1;
      ranges_counts_difference := ranges_counts_sum - (ranges_above mod 8);
      ranges_counts_difference_2 := ranges_counts_sum - (ranges_right mod 8);
      ranges_counts_difference_3 := ranges_counts_sum - (ranges_below mod 8);
      ranges_counts_difference_4 := ranges_counts_sum - (ranges_left mod 8);
      ranges_counts_sum_2 := as_number(((ranges_counts_difference >= 0) and (ranges_counts_difference < 3) and
        ((ranges_above / 8) = 1))) + as_number(((ranges_counts_difference_2 >= 0) and (ranges_counts_difference_2 < 3)
        and ((ranges_right / 8) = 1))) + as_number(((ranges_counts_difference_3 >= 0) and (ranges_counts_difference_3 <
        3) and ((ranges_below / 8) = 1))) + as_number(((ranges_counts_difference_4 >= 0) and
        (ranges_counts_difference_4 < 3) and ((ranges_left / 8) = 1)));
      ranges_pair_0_value := ((ranges_disparity / 2) mod 2) = 1;
      if ranges_pair_0_value then
        ranges_pair_0_choice := (not (((ranges_first_of_pair / 4) mod 2) = 1)) or ranges_counts;
      else
        ranges_pair_0_choice := not (((ranges_first_of_pair / 4) mod 2) = 1);
      end if;
      if ((ranges_disparity mod 2) = 1) and (not (((ranges_first_of_pair / 2) mod 2) = 1)) and ranges_counts then
        ranges_pair_0_choice_2 := ranges_pair_0_choice;
      else
        ranges_pair_0_choice_2 := ranges_pair_0_value and (not (((ranges_first_of_pair / 4) mod 2) = 1)) and
          ranges_counts;
      end if;
      ranges_pair_0_value_2 := ((ranges_first_of_pair / 8) mod 2) = 1;
      if (ranges_disparity / 4) = 1 then
        ranges_pair_0_choice_3 := ranges_pair_0_value_2 and ranges_counts;
      else
        ranges_pair_0_choice_3 := ranges_counts;
      end if;
      if ranges_pair_0_choice_2 then
        ranges_pair_0_choice_4 := (not ((ranges_disparity / 4) = 1)) and ranges_pair_0_value_2 and ranges_counts;
      else
        ranges_pair_0_choice_4 := ranges_pair_0_choice_3;
      end if;
      if ranges_counts then
        ranges_pair_0_choice_5 := (((ranges_disparity * 8) + ranges_disparity) * 2) + 1;
      else
        ranges_pair_0_choice_5 := 0;
      end if;
      if (not ranges_pair_0_choice_4) and ((ranges_first_of_pair mod 2) = 1) then
        ranges_pair_0_choice_6 := (ranges_first_of_pair / 2) mod 8;
      else
        ranges_pair_0_choice_6 := (ranges_pair_0_choice_5 / 2) mod 8;
      end if;
      if (((ranges_first_of_pair / 16) mod 2) = 1) and ((not ((ranges_disparity mod 2) = 1)) or (not ranges_counts))
        then
        ranges_pair_0_choice_7 := (not (((ranges_first_of_pair / 32) mod 2) = 1)) and ranges_pair_0_value and
          ranges_counts;
      else
        ranges_pair_0_choice_7 := (not (((ranges_first_of_pair / 32) mod 2) = 1)) or (ranges_pair_0_value and
          ranges_counts);
      end if;
      if (ranges_first_of_pair / 64) = 1 then
        ranges_pair_0_choice_8 := ((ranges_disparity / 4) = 1) and ranges_counts;
      else
        ranges_pair_0_choice_8 := ranges_counts;
      end if;
      if ranges_pair_0_choice_7 then
        ranges_pair_0_choice_9 := ranges_pair_0_choice_8;
      else
        ranges_pair_0_choice_9 := (not ((ranges_first_of_pair / 64) = 1)) and ((ranges_disparity / 4) = 1) and
          ranges_counts;
      end if;
      if (not ranges_pair_0_choice_9) and ((ranges_first_of_pair mod 2) = 1) then
        ranges_pair_0_choice_10 := ranges_first_of_pair / 16;
      else
        ranges_pair_0_choice_10 := ranges_pair_0_choice_5 / 16;
      end if;
      ranges_range_value := ((ranges_pairs_ready_newest_0 / 2) mod 2) = 1;
      if ranges_range_value then
        ranges_range_choice := (not (((ranges_pairs_ready_words_0 / 4) mod 2) = 1)) or (not
          (((ranges_pairs_ready_words_0 / 2) mod 2) = 1));
      else
        ranges_range_choice := not (((ranges_pairs_ready_words_0 / 4) mod 2) = 1);
      end if;
      if ((ranges_pairs_ready_newest_0 / 4) mod 2) = 1 then
        ranges_range_choice_2 := ranges_range_choice;
      else
        ranges_range_choice_2 := ranges_range_value and (((ranges_pairs_ready_words_0 / 2) mod 4) = 0);
      end if;
      ranges_range_value_2 := ((ranges_pairs_ready_newest_0 / 8) mod 2) = 1;
      ranges_range_value_3 := ((ranges_pairs_ready_words_0 / 8) mod 2) = 1;
      if ranges_range_value_2 then
        ranges_range_choice_3 := ranges_range_value_3 and ((ranges_pairs_ready_newest_0 mod 2) = 1);
      else
        ranges_range_choice_3 := (ranges_pairs_ready_newest_0 mod 2) = 1;
      end if;
      if ranges_range_choice_2 then
        ranges_range_choice_4 := (not ranges_range_value_2) and ranges_range_value_3 and ((ranges_pairs_ready_newest_0
          mod 2) = 1);
      else
        ranges_range_choice_4 := ranges_range_choice_3;
      end if;
      if (not ranges_range_choice_4) and ((ranges_pairs_ready_words_0 mod 2) = 1) then
        ranges_range_choice_5 := (ranges_pairs_ready_words_0 / 2) mod 8;
      else
        ranges_range_choice_5 := (ranges_pairs_ready_newest_0 / 2) mod 8;
      end if;
      ranges_range_value_4 := ((ranges_pairs_ready_newest_0 / 16) mod 2) = 1;
      if ranges_range_value_4 then
        ranges_range_choice_6 := not (((ranges_pairs_ready_words_0 / 32) mod 2) = 1);
      else
        ranges_range_choice_6 := ((ranges_pairs_ready_words_0 / 16) mod 4) = 0;
      end if;
      if ((ranges_pairs_ready_newest_0 / 32) mod 2) = 1 then
        ranges_range_choice_7 := ranges_range_value_4 or (not (((ranges_pairs_ready_words_0 / 32) mod 2) = 1)) or (not
          (((ranges_pairs_ready_words_0 / 16) mod 2) = 1));
      else
        ranges_range_choice_7 := ranges_range_choice_6;
      end if;
      if (ranges_pairs_ready_newest_0 / 64) = 1 then
        ranges_range_choice_8 := (ranges_pairs_ready_newest_0 mod 2) = 1;
      else
        ranges_range_choice_8 := (not ((ranges_pairs_ready_words_0 / 64) = 1)) and ((ranges_pairs_ready_newest_0 mod 2)
          = 1);
      end if;
      if ranges_range_choice_7 then
        ranges_range_choice_9 := ranges_range_choice_8;
      else
        ranges_range_choice_9 := ((ranges_pairs_ready_newest_0 / 64) = 1) and (not ((ranges_pairs_ready_words_0 / 64) =
          1)) and ((ranges_pairs_ready_newest_0 mod 2) = 1);
      end if;
      if (not ranges_range_choice_9) and ((ranges_pairs_ready_words_0 mod 2) = 1) then
        ranges_range_choice_10 := ranges_pairs_ready_words_0 / 16;
      else
        ranges_range_choice_10 := ranges_pairs_ready_newest_0 / 16;
      end if;
      ranges_row <= (ranges_row_choice + as_number(((not ranges_row_choice_3) and (not ranges_column_all_2) and
        ranges_column_is_equal and ranges_column_any_2))) mod 16;
      ranges_pixel_0 <= (as_number(ranges_pixel_0_choice) * 8) + coarseleftright_checked_disparity_0;
      ranges_in_column <= ranges_column_choice_5;
      ranges_in_row <= ranges_row_choice;
      ranges_in_valid <= ranges_column_choice_4;
      ranges_pixels_read_newest_0 <= ranges_pixel_0;
      ranges_pixels_ready_words_0 <= to_integer(ranges_pixels_read_words_0);
      ranges_pixels_ready_newest_0 <= ranges_pixels_read_newest_0;
      ranges_read_column <= ranges_in_column;
      ranges_read_row <= ranges_in_row;
      ranges_read_valid <= ranges_in_valid;
      ranges_ready_column <= ranges_read_column;
      ranges_ready_row <= ranges_read_row;
      ranges_ready_valid <= ranges_read_valid;
      ranges_centre_column <= ranges_ready_column;
      ranges_centre_row <= (ranges_ready_row + 65535) mod 65536;
      ranges_disparity <= ranges_middle mod 8;
      ranges_counted_column <= ranges_centre_column;
      ranges_counted_row <= ranges_centre_row;
      ranges_counted_valid <= ranges_centre_valid;
      ranges_paired_column <= ranges_counted_column / 2;
      ranges_paired_row <= ranges_counted_row;
      ranges_paired_valid <= ranges_counted_valid and (not ((ranges_counted_column mod 2) = 1));
      ranges_pairs_read_newest_0 <= ranges_pair_0;
      ranges_pairs_ready_words_0 <= to_integer(ranges_pairs_read_words_0);
      ranges_pairs_ready_newest_0 <= ranges_pairs_read_newest_0;
      ranges_pair_read_column <= ranges_paired_column;
      ranges_pair_read_row <= ranges_paired_row;
      ranges_pair_read_valid <= ranges_paired_valid;
      ranges_pair_ready_column <= ranges_pair_read_column;
      ranges_pair_ready_row <= ranges_pair_read_row;
      ranges_pair_ready_valid <= ranges_pair_read_valid;
      ranges_block_column <= (ranges_pair_ready_column + 65535) mod 65536;
      ranges_block_row <= ranges_pair_ready_row / 2;
      ranges_valid <= ranges_pair_ready_valid and ((ranges_pair_ready_row mod 2) = 1);
      if ranges_column_choice_4 then
        ranges_column <= ranges_column_choice_6;
      else
        ranges_column <= ranges_column_choice_5;
      end if;
      if (ranges_ready_column / 2) = 0 then
        ranges_centre_valid <= ranges_centre_valid_differs and ranges_ready_valid and ((ranges_ready_column mod 2) = 1);
      else
        ranges_centre_valid <= ranges_centre_valid_differs and ranges_ready_valid;
      end if;
      if (ranges_counts_sum_2 / 4) = 1 then
        ranges_counts <= (ranges_middle / 8) = 1;
      else
        ranges_counts <= (((ranges_counts_sum_2 / 2) mod 2) = 1) and ((ranges_middle / 8) = 1);
      end if;
      if (not ((ranges_first_of_pair mod 2) = 1)) and (not ranges_counts) then
        ranges_pair_0 <= 0;
      else
        ranges_pair_0 <= (ranges_pair_0_choice_6 * 2) + (ranges_pair_0_choice_10 * 16) + 1;
      end if;
      if (not ((ranges_pairs_ready_words_0 mod 2) = 1)) and (not ((ranges_pairs_ready_newest_0 mod 2) = 1)) then
        ranges_range <= 0;
      else
        ranges_range <= (ranges_range_choice_5 * 2) + (ranges_range_choice_10 * 16) + 1;
      end if;
      ranges_next_above_value := ((ranges_ready_row / 4) mod 2) = 1;
      ranges_next_above_value_2 := ((ranges_ready_row / 2) mod 2) = 1;
      if ranges_ready_valid then
        ranges_pixels_write_words_0 <= (ranges_pixels_ready_newest_0 * 16) + (ranges_pixels_ready_words_0 / 16);
        ranges_pixels_written <= ranges_ready_column;
        ranges_left <= ranges_middle;
        ranges_above <= ranges_next_above;
        ranges_middle <= ranges_right;
        ranges_below <= ranges_next_below;
        ranges_next_below <= ranges_pixels_ready_newest_0;
        if ((ranges_ready_row / 8) = 1) or ranges_next_above_value or ranges_next_above_value_2 then
          ranges_next_above <= ranges_pixels_ready_words_0 mod 16;
        else
          ranges_next_above <= 0;
        end if;
        if ((ranges_ready_row mod 2) = 1) or ((ranges_ready_row / 8) = 1) or ranges_next_above_value or
          ranges_next_above_value_2 then
          ranges_right <= ranges_pixels_ready_words_0 / 16;
        else
          ranges_right <= 0;
        end if;
      end if;
      if ranges_counted_valid then
        ranges_first_of_pair <= ranges_pair_0_choice_5;
      end if;
      if ranges_pair_ready_valid then
        ranges_pairs_write_words_0 <= ranges_pairs_ready_newest_0;
        ranges_pairs_written <= ranges_pair_ready_column;
      end if;
      -- targets
      targets_pause_all := (ranges_block_row /= 0) and (ranges_block_column = 7) and ranges_valid;
      targets_pause_is_equal := targets_pause = 6;
      if targets_pause_is_equal then
        targets_pause_choice := 6;
      else
        targets_pause_choice := (targets_pause + 1) mod 65536;
      end if;
      targets_walked_is_equal := targets_walked = 8;
      targets_walked_all := targets_last_row and targets_walked_is_equal and (not targets_again) and
        targets_pause_is_equal;
      targets_walked_any := (ranges_block_row = 0) or (ranges_block_column /= 7) or (not ranges_valid);
      targets_walked_all_2 := (not targets_walked_all) and targets_walked_any;
      targets_walked_all_3 := targets_pause_is_equal and (targets_walked /= 9);
      if targets_walked_all_3 then
        targets_walk_place_choice := (targets_walk_place + 7) mod 8;
      else
        targets_walk_place_choice := targets_walk_place;
      end if;
      if targets_walked_is_equal then
        targets_again_choice := (not targets_again) and (targets_pause /= 6);
      else
        targets_again_choice := not targets_again;
      end if;
      if targets_last_row then
        targets_again_choice_2 := targets_again_choice;
      else
        targets_again_choice_2 := not targets_again;
      end if;
      targets_column_range_value := ((targets_rows_ready_words_0 / 128) mod 2) = 1;
      targets_column_range_all := targets_ready_walk_has_above and targets_ready_walk_has_below;
      if targets_column_range_value then
        targets_column_range_choice := targets_ready_walk_has_above;
      else
        targets_column_range_choice := targets_column_range_all;
      end if;
      if (targets_rows_ready_words_0 mod 2) = 1 then
        targets_column_range_choice_2 := targets_column_range_choice;
      else
        targets_column_range_choice_2 := targets_column_range_value and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      targets_column_range_value_2 := ((targets_rows_ready_words_0 / 16384) mod 2) = 1;
      if targets_column_range_value_2 then
        targets_column_range_choice_3 := (not targets_column_range_value) and targets_ready_walk_has_below;
      else
        targets_column_range_choice_3 := (not targets_column_range_value) or (not targets_ready_walk_has_below);
      end if;
      targets_column_range_any := (not targets_column_range_value_2) or (not targets_ready_walk_has_below);
      targets_column_range_all_2 := (not targets_column_range_choice_2) and targets_column_range_choice_3;
      targets_column_range_value_3 := ((targets_rows_ready_words_0 / 512) mod 2) = 1;
      targets_column_range_value_4 := ((targets_rows_ready_words_0 / 65536) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_4 := targets_column_range_value_3;
      else
        targets_column_range_choice_4 := targets_column_range_value_4;
      end if;
      if targets_column_range_value_3 then
        targets_column_range_choice_5 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_5 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 4) mod 2) = 1 then
        targets_column_range_choice_6 := targets_column_range_choice_5;
      else
        targets_column_range_choice_6 := targets_column_range_value_3 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      targets_column_range_value_5 := ((targets_rows_ready_words_0 / 256) mod 2) = 1;
      targets_column_range_value_6 := ((targets_rows_ready_words_0 / 32768) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_7 := targets_column_range_value_5;
      else
        targets_column_range_choice_7 := targets_column_range_value_6;
      end if;
      if targets_column_range_value_5 then
        targets_column_range_choice_8 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_8 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 2) mod 2) = 1 then
        targets_column_range_choice_9 := targets_column_range_choice_8;
      else
        targets_column_range_choice_9 := targets_column_range_value_5 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      if targets_column_range_choice_4 then
        targets_column_range_choice_10 := (not targets_column_range_choice_6) or (targets_column_range_choice_7 and
          (not targets_column_range_choice_9));
      else
        targets_column_range_choice_10 := (not targets_column_range_choice_6) and targets_column_range_choice_7 and
          (not targets_column_range_choice_9);
      end if;
      targets_column_range_value_7 := ((targets_rows_ready_words_0 / 1024) mod 2) = 1;
      targets_column_range_value_8 := ((targets_rows_ready_words_0 / 131072) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_11 := targets_column_range_value_7;
      else
        targets_column_range_choice_11 := targets_column_range_value_8;
      end if;
      if targets_column_range_value_7 then
        targets_column_range_choice_12 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_12 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 8) mod 2) = 1 then
        targets_column_range_choice_13 := targets_column_range_choice_12;
      else
        targets_column_range_choice_13 := targets_column_range_value_7 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      if targets_ready_walk_has_below then
        targets_column_range_choice_14 := targets_column_range_value;
      else
        targets_column_range_choice_14 := targets_column_range_value_2;
      end if;
      if targets_column_range_choice_11 then
        targets_column_range_choice_15 := targets_column_range_choice_13 and targets_column_range_choice_14;
      else
        targets_column_range_choice_15 := targets_column_range_choice_14;
      end if;
      if targets_column_range_choice_10 then
        targets_column_range_choice_16 := (not targets_column_range_choice_11) and targets_column_range_choice_13 and
          targets_column_range_choice_14;
      else
        targets_column_range_choice_16 := targets_column_range_choice_15;
      end if;
      targets_column_range_all_3 := (not targets_column_range_choice_16) and targets_column_range_choice_2;
      if targets_column_range_all_3 then
        targets_column_range_choice_17 := targets_column_range_choice_6;
      else
        targets_column_range_choice_17 := targets_column_range_choice_4;
      end if;
      if targets_column_range_all_3 then
        targets_column_range_choice_18 := targets_column_range_choice_9;
      else
        targets_column_range_choice_18 := targets_column_range_choice_7;
      end if;
      if (not targets_column_range_all_2) and targets_column_range_choice_17 then
        targets_column_range_choice_19 := (not ((not targets_column_range_all_2) and targets_column_range_choice_18))
          and targets_ready_walk_has_below and (((targets_rows_ready_words_0 / 32768) mod 4) = 3);
      else
        targets_column_range_choice_19 := ((not ((not targets_column_range_all_2) and targets_column_range_choice_18))
          and targets_column_range_value_6 and targets_ready_walk_has_below) or (targets_column_range_value_4 and
          targets_ready_walk_has_below);
      end if;
      if targets_column_range_all_3 then
        targets_column_range_choice_20 := targets_column_range_choice_13;
      else
        targets_column_range_choice_20 := targets_column_range_choice_11;
      end if;
      if targets_column_range_choice_19 then
        targets_column_range_choice_21 := (not ((not targets_column_range_all_2) and targets_column_range_choice_20))
          or (targets_column_range_value_8 and targets_ready_walk_has_below);
      else
        targets_column_range_choice_21 := (not ((not targets_column_range_all_2) and targets_column_range_choice_20))
          and targets_column_range_value_8 and targets_ready_walk_has_below;
      end if;
      targets_column_range_all_4 := (not targets_column_range_all_2) and targets_column_range_any;
      if targets_column_range_choice_21 then
        targets_column_range_choice_22 := not targets_column_range_all_2;
      else
        targets_column_range_choice_22 := targets_column_range_all_4;
      end if;
      targets_column_range_value_9 := (targets_rows_ready_words_0 mod 128) / 2;
      targets_column_range_value_10 := ((targets_rows_ready_words_0 / 128) mod 128) / 2;
      if targets_ready_walk_has_below then
        targets_column_range_choice_23 := targets_column_range_value_9 mod 8;
      else
        targets_column_range_choice_23 := targets_column_range_value_10 mod 8;
      end if;
      if targets_ready_walk_has_above then
        targets_column_range_choice_24 := targets_column_range_choice_23;
      else
        targets_column_range_choice_24 := 0;
      end if;
      targets_column_range_value_11 := (targets_rows_ready_words_0 / 32768) mod 8;
      if targets_ready_walk_has_below then
        targets_column_range_choice_25 := targets_column_range_value_10 mod 8;
      else
        targets_column_range_choice_25 := targets_column_range_value_11;
      end if;
      if targets_column_range_all_3 then
        targets_column_range_choice_26 := targets_column_range_choice_24;
      else
        targets_column_range_choice_26 := targets_column_range_choice_25;
      end if;
      if targets_column_range_all_2 then
        targets_column_range_choice_27 := 0;
      else
        targets_column_range_choice_27 := targets_column_range_choice_26;
      end if;
      if targets_ready_walk_has_below then
        targets_column_range_choice_28 := targets_column_range_value_11;
      else
        targets_column_range_choice_28 := 0;
      end if;
      if targets_column_range_choice_22 then
        targets_column_range_choice_29 := targets_column_range_choice_27;
      else
        targets_column_range_choice_29 := targets_column_range_choice_28;
      end if;
      targets_column_range_value_12 := ((targets_rows_ready_words_0 / 4096) mod 2) = 1;
      targets_column_range_value_13 := ((targets_rows_ready_words_0 / 524288) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_30 := targets_column_range_value_12;
      else
        targets_column_range_choice_30 := targets_column_range_value_13;
      end if;
      if targets_column_range_value_12 then
        targets_column_range_choice_31 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_31 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 32) mod 2) = 1 then
        targets_column_range_choice_32 := targets_column_range_choice_31;
      else
        targets_column_range_choice_32 := targets_column_range_value_12 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      targets_column_range_value_14 := ((targets_rows_ready_words_0 / 2048) mod 2) = 1;
      targets_column_range_value_15 := ((targets_rows_ready_words_0 / 262144) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_33 := targets_column_range_value_14;
      else
        targets_column_range_choice_33 := targets_column_range_value_15;
      end if;
      if targets_column_range_value_14 then
        targets_column_range_choice_34 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_34 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 16) mod 2) = 1 then
        targets_column_range_choice_35 := targets_column_range_choice_34;
      else
        targets_column_range_choice_35 := targets_column_range_value_14 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      if targets_column_range_choice_30 then
        targets_column_range_choice_36 := (not targets_column_range_choice_32) or targets_column_range_choice_33 or
          (not targets_column_range_choice_35);
      else
        targets_column_range_choice_36 := (not targets_column_range_choice_32) and (targets_column_range_choice_33 or
          (not targets_column_range_choice_35));
      end if;
      targets_column_range_value_16 := ((targets_rows_ready_words_0 / 8192) mod 2) = 1;
      if targets_ready_walk_has_below then
        targets_column_range_choice_37 := targets_column_range_value_16;
      else
        targets_column_range_choice_37 := (targets_rows_ready_words_0 / 1048576) = 1;
      end if;
      if targets_column_range_value_16 then
        targets_column_range_choice_38 := targets_ready_walk_has_above;
      else
        targets_column_range_choice_38 := targets_column_range_all;
      end if;
      if ((targets_rows_ready_words_0 / 64) mod 2) = 1 then
        targets_column_range_choice_39 := targets_column_range_choice_38;
      else
        targets_column_range_choice_39 := targets_column_range_value_16 and targets_ready_walk_has_above and (not
          targets_ready_walk_has_below);
      end if;
      if targets_column_range_choice_37 then
        targets_column_range_choice_40 := targets_column_range_choice_14;
      else
        targets_column_range_choice_40 := (not targets_column_range_choice_39) and targets_column_range_choice_14;
      end if;
      if targets_column_range_choice_36 then
        targets_column_range_choice_41 := targets_column_range_choice_40;
      else
        targets_column_range_choice_41 := targets_column_range_choice_37 and (not targets_column_range_choice_39) and
          targets_column_range_choice_14;
      end if;
      targets_column_range_all_5 := (not targets_column_range_choice_41) and targets_column_range_choice_2;
      if targets_column_range_all_5 then
        targets_column_range_choice_42 := targets_column_range_choice_32;
      else
        targets_column_range_choice_42 := targets_column_range_choice_30;
      end if;
      if targets_column_range_all_5 then
        targets_column_range_choice_43 := targets_column_range_choice_35;
      else
        targets_column_range_choice_43 := targets_column_range_choice_33;
      end if;
      if (not targets_column_range_all_2) and targets_column_range_choice_42 then
        targets_column_range_choice_44 := (not ((not targets_column_range_all_2) and targets_column_range_choice_43 and
          ((not targets_column_range_value_15) or (not targets_ready_walk_has_below)))) and
          targets_column_range_value_13 and targets_ready_walk_has_below;
      else
        targets_column_range_choice_44 := (not ((not targets_column_range_all_2) and targets_column_range_choice_43 and
          ((not targets_column_range_value_15) or (not targets_ready_walk_has_below)))) or
          (targets_column_range_value_13 and targets_ready_walk_has_below);
      end if;
      if targets_column_range_all_5 then
        targets_column_range_choice_45 := targets_column_range_choice_39;
      else
        targets_column_range_choice_45 := targets_column_range_choice_37;
      end if;
      if targets_column_range_choice_44 then
        targets_column_range_choice_46 := (not ((not targets_column_range_all_2) and targets_column_range_choice_45))
          or (((targets_rows_ready_words_0 / 1048576) = 1) and targets_ready_walk_has_below);
      else
        targets_column_range_choice_46 := (not ((not targets_column_range_all_2) and targets_column_range_choice_45))
          and ((targets_rows_ready_words_0 / 1048576) = 1) and targets_ready_walk_has_below;
      end if;
      if targets_column_range_choice_46 then
        targets_column_range_choice_47 := targets_column_range_all_4;
      else
        targets_column_range_choice_47 := not targets_column_range_all_2;
      end if;
      if targets_ready_walk_has_below then
        targets_column_range_choice_48 := targets_column_range_value_9;
      else
        targets_column_range_choice_48 := targets_column_range_value_10;
      end if;
      if targets_ready_walk_has_above then
        targets_column_range_choice_49 := targets_column_range_choice_48;
      else
        targets_column_range_choice_49 := 0;
      end if;
      if targets_ready_walk_has_below then
        targets_column_range_choice_50 := targets_column_range_value_10;
      else
        targets_column_range_choice_50 := targets_rows_ready_words_0 / 32768;
      end if;
      if targets_column_range_all_5 then
        targets_column_range_choice_51 := (targets_column_range_choice_49 * 2) / 16;
      else
        targets_column_range_choice_51 := (targets_column_range_choice_50 * 2) / 16;
      end if;
      if targets_column_range_all_2 then
        targets_column_range_choice_52 := 0;
      else
        targets_column_range_choice_52 := targets_column_range_choice_26 + (targets_column_range_choice_51 * 8);
      end if;
      if targets_ready_walk_has_below then
        targets_column_range_choice_53 := targets_rows_ready_words_0 / 32768;
      else
        targets_column_range_choice_53 := 0;
      end if;
      if targets_column_range_choice_47 then
        targets_column_range_choice_54 := (targets_column_range_choice_52 * 2) / 16;
      else
        targets_column_range_choice_54 := (targets_column_range_choice_53 * 2) / 16;
      end if;
      if (not targets_column_range_choice_2) and targets_column_range_choice_3 and targets_column_range_any then
        targets_column_range_choice_55 := 0;
      else
        targets_column_range_choice_55 := (targets_column_range_choice_29 * 2) + (targets_column_range_choice_54 * 16)
          + 1;
      end if;
      targets_around_is_equal := targets_column_walk_column = 7;
      if (targets_here mod 2) = 1 then
        targets_around_choice := targets_around_is_equal;
      else
        targets_around_choice := (not ((targets_behind mod 2) = 1)) or targets_around_is_equal;
      end if;
      targets_around_value := ((targets_here / 2) mod 2) = 1;
      targets_around_value_2 := ((targets_behind / 2) mod 2) = 1;
      targets_around_differs := targets_column_walk_column /= 7;
      targets_around_value_3 := ((targets_here / 4) mod 2) = 1;
      targets_around_value_4 := ((targets_behind / 4) mod 2) = 1;
      if targets_around_value and (not targets_around_value_2) and targets_around_differs then
        targets_around_choice_2 := targets_around_value_3 or (not targets_around_value_4) or targets_around_is_equal;
      else
        targets_around_choice_2 := targets_around_value_3 and (not targets_around_value_4) and targets_around_differs;
      end if;
      targets_around_value_5 := ((targets_here / 8) mod 2) = 1;
      targets_around_value_6 := ((targets_behind / 8) mod 2) = 1;
      if targets_around_choice_2 then
        targets_around_choice_3 := targets_around_value_5 or (not targets_around_value_6) or targets_around_is_equal;
      else
        targets_around_choice_3 := targets_around_value_5 and (not targets_around_value_6) and targets_around_differs;
      end if;
      targets_around_all := ((targets_behind mod 2) = 1) and targets_around_differs;
      targets_around_all_2 := (not ((targets_here mod 2) = 1)) and ((targets_behind mod 2) = 1) and
        targets_around_differs;
      if targets_around_choice_3 then
        targets_around_choice_4 := targets_around_all;
      else
        targets_around_choice_4 := targets_around_all_2;
      end if;
      if targets_around_choice_4 then
        targets_around_choice_5 := targets_around_value_2 and targets_around_differs;
      else
        targets_around_choice_5 := targets_around_value and targets_around_differs;
      end if;
      if (targets_here mod 2) = 1 then
        targets_around_choice_6 := targets_around_differs;
      else
        targets_around_choice_6 := targets_around_all;
      end if;
      targets_around_value_7 := ((targets_column_range / 2) mod 2) = 1;
      if targets_around_choice_5 then
        targets_around_choice_7 := (not targets_around_choice_6) and targets_around_value_7;
      else
        targets_around_choice_7 := targets_around_value_7;
      end if;
      if targets_around_choice_4 then
        targets_around_choice_8 := targets_around_value_4 and targets_around_differs;
      else
        targets_around_choice_8 := targets_around_value_3 and targets_around_differs;
      end if;
      targets_around_value_8 := ((targets_column_range / 4) mod 2) = 1;
      if targets_around_choice_8 then
        targets_around_choice_9 := (not targets_around_choice_6) and targets_around_value_8;
      else
        targets_around_choice_9 := targets_around_value_8;
      end if;
      if targets_around_choice_7 then
        targets_around_choice_10 := (not targets_around_choice_8) or (not targets_around_choice_6) or
          targets_around_value_8;
      else
        targets_around_choice_10 := targets_around_choice_9;
      end if;
      if targets_around_choice_4 then
        targets_around_choice_11 := targets_around_value_6;
      else
        targets_around_choice_11 := targets_around_value_5;
      end if;
      if targets_around_choice_11 and targets_around_choice_6 then
        targets_around_choice_12 := (targets_column_range mod 2) = 1;
      else
        targets_around_choice_12 := (not (((targets_column_range / 8) mod 2) = 1)) and ((targets_column_range mod 2) =
          1);
      end if;
      if targets_around_choice_10 then
        targets_around_choice_13 := targets_around_choice_11 and targets_around_choice_6 and (not
          (((targets_column_range / 8) mod 2) = 1)) and ((targets_column_range mod 2) = 1);
      else
        targets_around_choice_13 := targets_around_choice_12;
      end if;
      if targets_around_is_equal then
        targets_around_choice_14 := 0;
      else
        targets_around_choice_14 := targets_behind;
      end if;
      if targets_around_is_equal then
        targets_around_choice_15 := 0;
      else
        targets_around_choice_15 := targets_here;
      end if;
      if targets_around_choice_4 then
        targets_around_choice_16 := (targets_around_choice_14 / 2) mod 8;
      else
        targets_around_choice_16 := (targets_around_choice_15 / 2) mod 8;
      end if;
      if targets_around_choice then
        targets_around_choice_17 := 0;
      else
        targets_around_choice_17 := targets_around_choice_16;
      end if;
      if (not targets_around_choice_13) and targets_around_choice_6 then
        targets_around_choice_18 := targets_around_choice_17;
      else
        targets_around_choice_18 := (targets_column_range / 2) mod 8;
      end if;
      targets_around_value_9 := ((targets_here / 16) mod 2) = 1;
      targets_around_value_10 := ((targets_behind / 16) mod 2) = 1;
      targets_around_value_11 := ((targets_here / 32) mod 2) = 1;
      targets_around_value_12 := ((targets_behind / 32) mod 2) = 1;
      if (not targets_around_value_9) and targets_around_value_10 and targets_around_differs then
        targets_around_choice_19 := targets_around_value_11 and (not targets_around_value_12) and
          targets_around_differs;
      else
        targets_around_choice_19 := targets_around_value_11 or (not targets_around_value_12) or targets_around_is_equal;
      end if;
      if targets_around_choice_19 then
        targets_around_choice_20 := ((targets_here / 64) = 1) or (not ((targets_behind / 64) = 1)) or
          targets_around_is_equal;
      else
        targets_around_choice_20 := ((targets_here / 64) = 1) and (not ((targets_behind / 64) = 1)) and
          targets_around_differs;
      end if;
      if targets_around_choice_20 then
        targets_around_choice_21 := targets_around_all_2;
      else
        targets_around_choice_21 := targets_around_all;
      end if;
      if targets_around_choice_21 then
        targets_around_choice_22 := targets_around_value_12 and targets_around_differs;
      else
        targets_around_choice_22 := targets_around_value_11 and targets_around_differs;
      end if;
      if targets_around_choice_21 then
        targets_around_choice_23 := targets_around_value_10 and targets_around_differs;
      else
        targets_around_choice_23 := targets_around_value_9 and targets_around_differs;
      end if;
      targets_around_all_3 := targets_around_choice_23 and targets_around_choice_6 and (not (((targets_column_range /
        16) mod 2) = 1));
      targets_around_value_13 := ((targets_column_range / 32) mod 2) = 1;
      if targets_around_all_3 then
        targets_around_choice_24 := (not targets_around_choice_6) and targets_around_value_13;
      else
        targets_around_choice_24 := (not targets_around_choice_6) or targets_around_value_13;
      end if;
      if targets_around_choice_22 then
        targets_around_choice_25 := targets_around_choice_24;
      else
        targets_around_choice_25 := (not targets_around_all_3) or targets_around_value_13;
      end if;
      if targets_around_choice_21 then
        targets_around_choice_26 := (targets_behind / 64) = 1;
      else
        targets_around_choice_26 := (targets_here / 64) = 1;
      end if;
      targets_around_all_4 := targets_around_choice_26 and targets_around_choice_6;
      if targets_around_all_4 then
        targets_around_choice_27 := ((targets_column_range / 64) = 1) and ((targets_column_range mod 2) = 1);
      else
        targets_around_choice_27 := (targets_column_range mod 2) = 1;
      end if;
      if targets_around_choice_25 then
        targets_around_choice_28 := targets_around_choice_27;
      else
        targets_around_choice_28 := (not targets_around_all_4) and ((targets_column_range / 64) = 1) and
          ((targets_column_range mod 2) = 1);
      end if;
      if targets_around_choice_21 then
        targets_around_choice_29 := targets_around_choice_14 / 16;
      else
        targets_around_choice_29 := targets_around_choice_15 / 16;
      end if;
      if targets_around_choice then
        targets_around_choice_30 := 0;
      else
        targets_around_choice_30 := targets_around_choice_16 + (targets_around_choice_29 * 8);
      end if;
      if (not targets_around_choice_28) and targets_around_choice_6 then
        targets_around_choice_31 := (targets_around_choice_30 * 2) / 16;
      else
        targets_around_choice_31 := targets_column_range / 16;
      end if;
      targets_low_wish_value := (((targets_around mod 16) * 2) / 4) * 4;
      if targets_low_wish_value < 22 then
        targets_low_wish_choice := targets_low_wish_value;
      else
        targets_low_wish_choice := 22;
      end if;
      if targets_low_wish_choice < 6 then
        targets_low_wish_choice_2 := 6;
      else
        targets_low_wish_choice_2 := targets_low_wish_choice;
      end if;
      targets_high_wish_value := (targets_around / 16) * 4;
      if targets_high_wish_value < 22 then
        targets_high_wish_choice := targets_high_wish_value;
      else
        targets_high_wish_choice := 22;
      end if;
      if targets_high_wish_choice < 6 then
        targets_high_wish_choice_2 := 6;
      else
        targets_high_wish_choice_2 := targets_high_wish_choice;
      end if;
      targets_low_all := targets_wish_walk_valid and (targets_wish_walk_column /= 7);
      targets_low_differs := targets_wish_walk_column /= 6;
      if targets_low_differs then
        targets_low_choice := targets_low / 2;
      else
        targets_low_choice := 0;
      end if;
      if targets_low_differs then
        targets_low_choice_2 := (targets_low / 2) mod 4;
      else
        targets_low_choice_2 := 0;
      end if;
      targets_low_sum := (((((targets_low_choice * 2) / 8) + 1) mod 8192) * 4) + targets_low_choice_2;
      if ((targets_low_sum - (targets_low_wish / 2)) < 0) and targets_low_differs then
        targets_low_choice_3 := targets_low_sum;
      else
        targets_low_choice_3 := targets_low_wish / 2;
      end if;
      if targets_known then
        targets_low_choice_4 := targets_low_choice_3;
      else
        targets_low_choice_4 := targets_low_choice;
      end if;
      if targets_low_all then
        targets_low_choice_5 := targets_low_choice_4;
      else
        targets_low_choice_5 := targets_low / 2;
      end if;
      if targets_low_differs then
        targets_high_choice := targets_high / 2;
      else
        targets_high_choice := 8;
      end if;
      if targets_known then
        targets_high_choice_2 := targets_high_wish / 2;
      else
        targets_high_choice_2 := targets_high_choice;
      end if;
      if targets_low_all then
        targets_high_choice_3 := targets_high_choice_2;
      else
        targets_high_choice_3 := targets_high / 2;
      end if;
      targets_newest_0 <= ranges_range;
      targets_comes <= ranges_valid;
      targets_again <= (not targets_again_choice_2) and targets_walked_any;
      targets_walk_column <= (7 - targets_walked) mod 65536;
      targets_walk_band <= targets_next_band mod 8;
      targets_walk_has_above <= targets_next_band /= 0;
      targets_walk_has_below <= not targets_again;
      targets_walk_valid <= targets_walked_all_3;
      targets_rows_read_newest_0 <= targets_newest_0;
      targets_rows_ready_words_0 <= to_integer(targets_rows_read_words_0);
      targets_rows_ready_newest_0 <= targets_rows_read_newest_0;
      targets_read_comes <= targets_comes;
      targets_ready_comes <= targets_read_comes;
      targets_read_place <= targets_read_column;
      targets_ready_place <= targets_read_place;
      targets_read_walk_column <= targets_walk_column;
      targets_read_walk_band <= targets_walk_band;
      targets_read_walk_has_above <= targets_walk_has_above;
      targets_read_walk_has_below <= targets_walk_has_below;
      targets_read_walk_valid <= targets_walk_valid;
      targets_ready_walk_column <= targets_read_walk_column;
      targets_ready_walk_band <= targets_read_walk_band;
      targets_ready_walk_has_above <= targets_read_walk_has_above;
      targets_ready_walk_has_below <= targets_read_walk_has_below;
      targets_ready_walk_valid <= targets_read_walk_valid;
      targets_column_walk_column <= targets_ready_walk_column;
      targets_column_walk_band <= targets_ready_walk_band;
      targets_column_walk_valid <= targets_ready_walk_valid;
      targets_around_walk_column <= targets_column_walk_column;
      targets_around_walk_band <= targets_column_walk_band;
      targets_around_walk_valid <= targets_column_walk_valid;
      targets_low_wish <= (((targets_low_wish_choice_2 / 2) + 32765) mod 16) * 2;
      targets_high_wish <= (((targets_high_wish_choice_2 / 2) + 32765) mod 16) * 2;
      targets_known <= (targets_around mod 2) = 1;
      targets_wish_walk_column <= targets_around_walk_column;
      targets_wish_walk_band <= targets_around_walk_band;
      targets_wish_walk_valid <= targets_around_walk_valid;
      targets_low <= targets_low_choice_5 * 2;
      targets_high <= targets_high_choice_3 * 2;
      if ranges_valid then
        targets_read_column <= ranges_block_column mod 8;
      else
        targets_read_column <= targets_walk_place;
      end if;
      if targets_pause_all then
        targets_pause <= 0;
        targets_next_band <= (ranges_block_row + 65535) mod 65536;
      else
        targets_pause <= targets_pause_choice;
        targets_next_band <= (targets_next_band + as_number(targets_walked_all)) mod 65536;
      end if;
      if targets_walked_all_2 then
        targets_walked <= (targets_walked + as_number(targets_walked_all_3)) mod 65536;
        targets_walk_place <= targets_walk_place_choice;
      else
        targets_walked <= 0;
        targets_walk_place <= 7;
      end if;
      if targets_ready_walk_column < 8 then
        targets_column_range <= targets_column_range_choice_55;
      else
        targets_column_range <= 0;
      end if;
      if (not ((targets_column_range mod 2) = 1)) and targets_around_choice then
        targets_around <= 0;
      else
        targets_around <= (targets_around_choice_18 * 2) + (targets_around_choice_31 * 16) + 1;
      end if;
      if targets_pause_all then
        targets_last_row <= ranges_block_row = 3;
      end if;
      if targets_ready_comes then
        targets_rows_write_words_0 <= (targets_rows_ready_words_0 / 128) + (targets_rows_ready_newest_0 * 16384);
        targets_write_column <= targets_ready_place;
      end if;
      if targets_column_walk_valid then
        targets_behind <= targets_around_choice_15;
        targets_here <= targets_column_range;
      end if;
      if targets_low_all then
        targets_place <= to_integer(((to_unsigned(targets_wish_walk_band, 3) & to_unsigned(0, 3)) or
          (to_unsigned(((targets_wish_walk_column + 1) mod 64), 6))));
      end if;
      -- hold
      hold_back_holds_groups_any := hold_back_holds_groups or (hold_back_ring_read_address = 0);
      if in_valid then
        hold_back_ring_write_address <= hold_back_ring_read_address;
        hold_back_holds_groups <= hold_back_holds_groups_any;
        if hold_back_ring_read_address = 2615 then
          hold_back_ring_read_address <= 0;
        else
          hold_back_ring_read_address <= (hold_back_ring_read_address + 1) mod 4096;
        end if;
      end if;
      hold_back_held_is_new <= hold_back_holds_groups_any;
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 63;
      transform_counter_group_is_equal_2 := transform_counter_group = 31;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      transform_counter_group_is_equal_3 := transform_counter_group = 35;
      if transform_counter_next_frame and transform_counter_group_is_equal_3 then
        transform_counter_group_choice := 4;
      else
        transform_counter_group_choice := (transform_counter_group + 1) mod 64;
      end if;
      if (transform_counter_group /= 36) and transform_counter_group_is_equal and coarse_pixels_valid then
        transform_counter_group_choice_2 := transform_counter_group_choice;
      else
        transform_counter_group_choice_2 := transform_counter_group;
      end if;
      transform_from_first_0_value := (transform_centre_column / 2) mod 16;
      if (transform_centre_column mod 2) = 1 then
        transform_from_first_1_choice := ((transform_centre_column / 4) mod 4) = 0;
      else
        transform_from_first_1_choice := (not (((transform_centre_column / 8) mod 2) = 1)) and ((not
          (((transform_centre_column / 4) mod 2) = 1)) or (not (((transform_centre_column / 2) mod 2) = 1)));
      end if;
      transform_up_to_last_0_all := (not ((transform_centre_group / 64) = 1)) and ((not (((transform_centre_group / 32)
        mod 2) = 1)) or (not (((transform_centre_group / 16) mod 2) = 1)));
      transform_up_to_last_0_is_equal := (transform_centre_group / 32) = 0;
      if ((not (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
        (((transform_centre_group / 4) mod 4) = 0) then
        transform_up_to_last_0_choice := transform_up_to_last_0_all;
      else
        transform_up_to_last_0_choice := transform_up_to_last_0_is_equal;
      end if;
      if (transform_centre_group mod 16) = 0 then
        transform_up_to_last_1_choice := transform_up_to_last_0_all;
      else
        transform_up_to_last_1_choice := transform_up_to_last_0_is_equal;
      end if;
      transform_left_0 <= to_integer(hold_back_held_0(12 downto 0)) / 2;
      transform_right_0 <= to_integer(hold_back_held_0(24 downto 13));
      transform_valid <= coarse_pixels_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
      transform_left_rows_ready_words_1 <= to_integer(transform_left_rows_read_words_1);
      transform_left_rows_ready_words_2 <= to_integer(transform_left_rows_read_words_2);
      transform_left_rows_ready_words_3 <= to_integer(transform_left_rows_read_words_3);
      transform_left_rows_ready_words_4 <= to_integer(transform_left_rows_read_words_4);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
      transform_right_rows_ready_words_1 <= to_integer(transform_right_rows_read_words_1);
      transform_right_rows_ready_words_2 <= to_integer(transform_right_rows_read_words_2);
      transform_right_rows_ready_words_3 <= to_integer(transform_right_rows_read_words_3);
      transform_right_rows_ready_words_4 <= to_integer(transform_right_rows_read_words_4);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_ready_column <= transform_read_column;
      transform_centre_column <= ((((transform_counter_column / 4) + 15) mod 16) * 4) + (transform_counter_column mod
        4);
      transform_centre_group <= transform_counter_group + as_number((((transform_counter_column / 32) = 1) or
        (((transform_counter_column / 16) mod 2) = 1) or (((transform_counter_column / 8) mod 2) = 1) or
        (((transform_counter_column / 4) mod 2) = 1)));
      transform_up_to_last_1 <= ((transform_centre_column / 4) /= 15) and transform_up_to_last_1_choice;
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 4096;
      transform_left_column_1 <= transform_left_rows_ready_words_0 / 4096;
      transform_left_column_2 <= transform_left_rows_ready_words_1 mod 4096;
      transform_left_column_3 <= transform_left_rows_ready_words_1 / 4096;
      transform_left_column_4 <= transform_left_rows_ready_words_2 mod 4096;
      transform_left_column_5 <= transform_left_rows_ready_words_2 / 4096;
      transform_left_column_6 <= transform_left_rows_ready_words_3 mod 4096;
      transform_left_column_7 <= transform_left_rows_ready_words_3 / 4096;
      transform_left_column_8 <= transform_left_rows_ready_words_4;
      transform_left_column_9 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 4096;
      transform_right_column_1 <= transform_right_rows_ready_words_0 / 4096;
      transform_right_column_2 <= transform_right_rows_ready_words_1 mod 4096;
      transform_right_column_3 <= transform_right_rows_ready_words_1 / 4096;
      transform_right_column_4 <= transform_right_rows_ready_words_2 mod 4096;
      transform_right_column_5 <= transform_right_rows_ready_words_2 / 4096;
      transform_right_column_6 <= transform_right_rows_ready_words_3 mod 4096;
      transform_right_column_7 <= transform_right_rows_ready_words_3 / 4096;
      transform_right_column_8 <= transform_right_rows_ready_words_4;
      transform_right_column_9 <= transform_right_rows_ready_newest_0;
      transform_columns_inside_0 <= transform_up_to_last_0 and transform_from_first_0;
      transform_columns_inside_1 <= transform_up_to_last_1 and transform_from_first_1;
      transform_columns_start_of_frame <= (other_12 mod 2) = 1;
      transform_columns_valid <= (other_12 / 256) = 1;
      transform_left_code_column_box_0_0_0 <= transform_left_column_3;
      transform_left_code_column_box_0_1_0 <= transform_left_column_4;
      transform_left_code_column_box_0_2_0 <= transform_left_column_5;
      transform_left_code_column_box_0_3_0 <= transform_left_column_6;
      transform_left_code_column_box_0_4_0 <= transform_left_column_7;
      transform_left_code_column_centre <= transform_left_code_column_box_0_2_0;
      transform_left_code_column_near <= transform_left_code_column_box_0_1_0 + transform_left_code_column_box_0_3_0;
      transform_left_code_column_outer <= (8190 - transform_left_code_column_box_0_4_0) -
        transform_left_code_column_box_0_0_0;
      transform_left_code_column_upper <= 12285 - (((transform_left_code_column_box_0_1_0 +
        (transform_left_code_column_box_0_0_0 / 2)) * 2) + (transform_left_code_column_box_0_0_0 mod 2));
      transform_left_code_column_lower <= ((transform_left_code_column_box_0_3_0 +
        (transform_left_code_column_box_0_4_0 / 2)) * 2) + (transform_left_code_column_box_0_4_0 mod 2);
      transform_left_code_column_response_0 <= ((transform_left_code_column_centre + (transform_left_code_column_near /
        2)) * 2) + (transform_left_code_column_near mod 2);
      transform_left_code_column_response_1 <= ((transform_left_code_column_centre + (transform_left_code_column_outer
        / 2)) * 2) + (transform_left_code_column_outer mod 2);
      transform_left_code_column_response_2 <= transform_left_code_column_upper + transform_left_code_column_lower;
      transform_left_code_row_box_0_0 <= transform_left_code_column_response_0;
      transform_left_code_row_box_0_1 <= transform_left_code_column_response_1;
      transform_left_code_row_box_0_2 <= transform_left_code_column_response_2;
      transform_left_code_row_centre_0 <= transform_left_code_row_column_0_1;
      transform_left_code_row_centre_1 <= transform_left_code_row_column_1_1;
      transform_left_code_row_centre_2 <= transform_left_code_row_column_2_1;
      transform_left_code_row_outer_1 <= transform_left_code_row_box_0_1 + transform_left_code_row_column_1_3;
      transform_left_code_row_outer_2 <= transform_left_code_row_box_0_2 + transform_left_code_row_column_2_3;
      transform_left_code_row_before_0 <= ((transform_left_code_row_column_0_2 + (transform_left_code_row_column_0_3 /
        2)) * 2) + (transform_left_code_row_column_0_3 mod 2);
      transform_left_code_row_before_1 <= ((transform_left_code_row_column_1_2 + (transform_left_code_row_column_1_3 /
        2)) * 2) + (transform_left_code_row_column_1_3 mod 2);
      transform_left_code_row_before_2 <= ((transform_left_code_row_column_2_2 + (transform_left_code_row_column_2_3 /
        2)) * 2) + (transform_left_code_row_column_2_3 mod 2);
      transform_left_code_row_after_0 <= (((transform_left_code_row_box_0_0 / 2) + transform_left_code_row_column_0_0)
        * 2) + (transform_left_code_row_box_0_0 mod 2);
      transform_left_code_row_after_1 <= (((transform_left_code_row_box_0_1 / 2) + transform_left_code_row_column_1_0)
        * 2) + (transform_left_code_row_box_0_1 mod 2);
      transform_left_code_row_after_2 <= (((transform_left_code_row_box_0_2 / 2) + transform_left_code_row_column_2_0)
        * 2) + (transform_left_code_row_box_0_2 mod 2);
      transform_left_code_row_even_1 <= ((((transform_left_code_row_outer_1 / 2) - transform_left_code_row_centre_1)
        mod 131072) * 2) + (transform_left_code_row_outer_1 mod 2);
      transform_left_code_row_even_2 <= ((((transform_left_code_row_outer_2 / 2) - transform_left_code_row_centre_2)
        mod 131072) * 2) + (transform_left_code_row_outer_2 mod 2);
      transform_left_code_row_odd_1 <= (transform_left_code_row_before_1 - transform_left_code_row_after_1) mod 262144;
      transform_left_code_row_odd_2 <= (transform_left_code_row_before_2 - transform_left_code_row_after_2) mod 262144;
      transform_left_code_row_signs <= ((other_9 / 131072) * 2) + (other_10 / 131072) +
        ((((transform_left_code_row_even_2 + transform_left_code_row_odd_1) mod 262144) / 131072) * 8) +
        ((((transform_left_code_row_odd_1 - transform_left_code_row_even_2) mod 262144) / 131072) * 32) +
        ((((transform_left_code_row_even_1 - transform_left_code_row_odd_2) mod 262144) / 131072) * 4) +
        ((((transform_left_code_row_even_1 + transform_left_code_row_odd_2) mod 262144) / 131072) * 16);
      transform_left_code_next_column_box_0_0_0 <= transform_left_column_0 + transform_left_column_1;
      transform_left_code_next_column_box_0_1_0 <= transform_left_column_2 + transform_left_column_3;
      transform_left_code_next_column_box_0_2_0 <= transform_left_column_4 + transform_left_column_5;
      transform_left_code_next_column_box_0_3_0 <= transform_left_column_6 + transform_left_column_7;
      transform_left_code_next_column_box_0_4_0 <= transform_left_column_8 + transform_left_column_9;
      transform_left_code_next_column_centre <= transform_left_code_next_column_box_0_2_0;
      transform_left_code_next_column_near <= transform_left_code_next_column_box_0_1_0 +
        transform_left_code_next_column_box_0_3_0;
      transform_left_code_next_column_outer <= (16380 - transform_left_code_next_column_box_0_4_0) -
        transform_left_code_next_column_box_0_0_0;
      transform_left_code_next_column_upper <= (24570 - (((transform_left_code_next_column_box_0_1_0 +
        (transform_left_code_next_column_box_0_0_0 / 2)) * 2) + (transform_left_code_next_column_box_0_0_0 mod 2))) mod
        65536;
      transform_left_code_next_column_lower <= ((transform_left_code_next_column_box_0_3_0 +
        (transform_left_code_next_column_box_0_4_0 / 2)) * 2) + (transform_left_code_next_column_box_0_4_0 mod 2);
      transform_left_code_next_column_response_0 <= ((transform_left_code_next_column_centre +
        (transform_left_code_next_column_near / 2)) * 2) + (transform_left_code_next_column_near mod 2);
      transform_left_code_next_column_response_1 <= ((transform_left_code_next_column_centre +
        (transform_left_code_next_column_outer / 2)) * 2) + (transform_left_code_next_column_outer mod 2);
      transform_left_code_next_column_response_2 <= (transform_left_code_next_column_upper +
        transform_left_code_next_column_lower) mod 65536;
      transform_left_code_next_row_box_0_0 <= transform_left_code_next_row_earlier_0_0_0 +
        transform_left_code_next_column_response_0;
      transform_left_code_next_row_box_0_1 <= transform_left_code_next_row_earlier_0_1_0 +
        transform_left_code_next_column_response_1;
      transform_left_code_next_row_box_0_2 <= transform_left_code_next_row_earlier_0_2_0 +
        transform_left_code_next_column_response_2;
      transform_left_code_next_row_centre_0 <= transform_left_code_next_row_column_0_3;
      transform_left_code_next_row_centre_1 <= transform_left_code_next_row_column_1_3;
      transform_left_code_next_row_centre_2 <= transform_left_code_next_row_column_2_3;
      transform_left_code_next_row_outer_1 <= transform_left_code_next_row_box_0_1 +
        transform_left_code_next_row_column_1_7;
      transform_left_code_next_row_outer_2 <= transform_left_code_next_row_box_0_2 +
        transform_left_code_next_row_column_2_7;
      transform_left_code_next_row_before_0 <= ((transform_left_code_next_row_column_0_5 +
        (transform_left_code_next_row_column_0_7 / 2)) * 2) + (transform_left_code_next_row_column_0_7 mod 2);
      transform_left_code_next_row_before_1 <= ((transform_left_code_next_row_column_1_5 +
        (transform_left_code_next_row_column_1_7 / 2)) * 2) + (transform_left_code_next_row_column_1_7 mod 2);
      transform_left_code_next_row_before_2 <= ((transform_left_code_next_row_column_2_5 +
        (transform_left_code_next_row_column_2_7 / 2)) * 2) + (transform_left_code_next_row_column_2_7 mod 2);
      transform_left_code_next_row_after_0 <= (((transform_left_code_next_row_box_0_0 / 2) +
        transform_left_code_next_row_column_0_1) * 2) + (transform_left_code_next_row_box_0_0 mod 2);
      transform_left_code_next_row_after_1 <= (((transform_left_code_next_row_box_0_1 / 2) +
        transform_left_code_next_row_column_1_1) * 2) + (transform_left_code_next_row_box_0_1 mod 2);
      transform_left_code_next_row_after_2 <= (((transform_left_code_next_row_box_0_2 / 2) +
        transform_left_code_next_row_column_2_1) * 2) + (transform_left_code_next_row_box_0_2 mod 2);
      transform_left_code_next_row_even_1 <= ((((transform_left_code_next_row_outer_1 / 2) -
        transform_left_code_next_row_centre_1) mod 524288) * 2) + (transform_left_code_next_row_outer_1 mod 2);
      transform_left_code_next_row_even_2 <= ((((transform_left_code_next_row_outer_2 / 2) -
        transform_left_code_next_row_centre_2) mod 524288) * 2) + (transform_left_code_next_row_outer_2 mod 2);
      transform_left_code_next_row_odd_1 <= (transform_left_code_next_row_before_1 -
        transform_left_code_next_row_after_1) mod 1048576;
      transform_left_code_next_row_odd_2 <= (transform_left_code_next_row_before_2 -
        transform_left_code_next_row_after_2) mod 1048576;
      transform_left_code_next_row_signs <= ((other_6 / 524288) * 2) + (other_7 / 524288) +
        ((((transform_left_code_next_row_even_2 + transform_left_code_next_row_odd_1) mod 1048576) / 524288) * 8) +
        ((((transform_left_code_next_row_odd_1 - transform_left_code_next_row_even_2) mod 1048576) / 524288) * 32) +
        ((((transform_left_code_next_row_even_1 - transform_left_code_next_row_odd_2) mod 1048576) / 524288) * 4) +
        ((((transform_left_code_next_row_even_1 + transform_left_code_next_row_odd_2) mod 1048576) / 524288) * 16);
      transform_right_code_column_box_0_0_0 <= transform_right_column_3;
      transform_right_code_column_box_0_1_0 <= transform_right_column_4;
      transform_right_code_column_box_0_2_0 <= transform_right_column_5;
      transform_right_code_column_box_0_3_0 <= transform_right_column_6;
      transform_right_code_column_box_0_4_0 <= transform_right_column_7;
      transform_right_code_column_centre <= transform_right_code_column_box_0_2_0;
      transform_right_code_column_near <= transform_right_code_column_box_0_1_0 + transform_right_code_column_box_0_3_0;
      transform_right_code_column_outer <= (8190 - transform_right_code_column_box_0_4_0) -
        transform_right_code_column_box_0_0_0;
      transform_right_code_column_upper <= 12285 - (((transform_right_code_column_box_0_1_0 +
        (transform_right_code_column_box_0_0_0 / 2)) * 2) + (transform_right_code_column_box_0_0_0 mod 2));
      transform_right_code_column_lower <= ((transform_right_code_column_box_0_3_0 +
        (transform_right_code_column_box_0_4_0 / 2)) * 2) + (transform_right_code_column_box_0_4_0 mod 2);
      transform_right_code_column_response_0 <= ((transform_right_code_column_centre +
        (transform_right_code_column_near / 2)) * 2) + (transform_right_code_column_near mod 2);
      transform_right_code_column_response_1 <= ((transform_right_code_column_centre +
        (transform_right_code_column_outer / 2)) * 2) + (transform_right_code_column_outer mod 2);
      transform_right_code_column_response_2 <= transform_right_code_column_upper + transform_right_code_column_lower;
      transform_right_code_row_box_0_0 <= transform_right_code_column_response_0;
      transform_right_code_row_box_0_1 <= transform_right_code_column_response_1;
      transform_right_code_row_box_0_2 <= transform_right_code_column_response_2;
      transform_right_code_row_centre_0 <= transform_right_code_row_column_0_1;
      transform_right_code_row_centre_1 <= transform_right_code_row_column_1_1;
      transform_right_code_row_centre_2 <= transform_right_code_row_column_2_1;
      transform_right_code_row_outer_1 <= transform_right_code_row_box_0_1 + transform_right_code_row_column_1_3;
      transform_right_code_row_outer_2 <= transform_right_code_row_box_0_2 + transform_right_code_row_column_2_3;
      transform_right_code_row_before_0 <= ((transform_right_code_row_column_0_2 + (transform_right_code_row_column_0_3
        / 2)) * 2) + (transform_right_code_row_column_0_3 mod 2);
      transform_right_code_row_before_1 <= ((transform_right_code_row_column_1_2 + (transform_right_code_row_column_1_3
        / 2)) * 2) + (transform_right_code_row_column_1_3 mod 2);
      transform_right_code_row_before_2 <= ((transform_right_code_row_column_2_2 + (transform_right_code_row_column_2_3
        / 2)) * 2) + (transform_right_code_row_column_2_3 mod 2);
      transform_right_code_row_after_0 <= (((transform_right_code_row_box_0_0 / 2) +
        transform_right_code_row_column_0_0) * 2) + (transform_right_code_row_box_0_0 mod 2);
      transform_right_code_row_after_1 <= (((transform_right_code_row_box_0_1 / 2) +
        transform_right_code_row_column_1_0) * 2) + (transform_right_code_row_box_0_1 mod 2);
      transform_right_code_row_after_2 <= (((transform_right_code_row_box_0_2 / 2) +
        transform_right_code_row_column_2_0) * 2) + (transform_right_code_row_box_0_2 mod 2);
      transform_right_code_row_even_1 <= ((((transform_right_code_row_outer_1 / 2) - transform_right_code_row_centre_1)
        mod 131072) * 2) + (transform_right_code_row_outer_1 mod 2);
      transform_right_code_row_even_2 <= ((((transform_right_code_row_outer_2 / 2) - transform_right_code_row_centre_2)
        mod 131072) * 2) + (transform_right_code_row_outer_2 mod 2);
      transform_right_code_row_odd_1 <= (transform_right_code_row_before_1 - transform_right_code_row_after_1) mod
        262144;
      transform_right_code_row_odd_2 <= (transform_right_code_row_before_2 - transform_right_code_row_after_2) mod
        262144;
      transform_right_code_row_signs <= ((other_3 / 131072) * 2) + (other_4 / 131072) +
        ((((transform_right_code_row_even_2 + transform_right_code_row_odd_1) mod 262144) / 131072) * 8) +
        ((((transform_right_code_row_odd_1 - transform_right_code_row_even_2) mod 262144) / 131072) * 32) +
        ((((transform_right_code_row_even_1 - transform_right_code_row_odd_2) mod 262144) / 131072) * 4) +
        ((((transform_right_code_row_even_1 + transform_right_code_row_odd_2) mod 262144) / 131072) * 16);
      transform_right_code_next_column_box_0_0_0 <= transform_right_column_0 + transform_right_column_1;
      transform_right_code_next_column_box_0_1_0 <= transform_right_column_2 + transform_right_column_3;
      transform_right_code_next_column_box_0_2_0 <= transform_right_column_4 + transform_right_column_5;
      transform_right_code_next_column_box_0_3_0 <= transform_right_column_6 + transform_right_column_7;
      transform_right_code_next_column_box_0_4_0 <= transform_right_column_8 + transform_right_column_9;
      transform_right_code_next_column_centre <= transform_right_code_next_column_box_0_2_0;
      transform_right_code_next_column_near <= transform_right_code_next_column_box_0_1_0 +
        transform_right_code_next_column_box_0_3_0;
      transform_right_code_next_column_outer <= (16380 - transform_right_code_next_column_box_0_4_0) -
        transform_right_code_next_column_box_0_0_0;
      transform_right_code_next_column_upper <= (24570 - (((transform_right_code_next_column_box_0_1_0 +
        (transform_right_code_next_column_box_0_0_0 / 2)) * 2) + (transform_right_code_next_column_box_0_0_0 mod 2)))
        mod 65536;
      transform_right_code_next_column_lower <= ((transform_right_code_next_column_box_0_3_0 +
        (transform_right_code_next_column_box_0_4_0 / 2)) * 2) + (transform_right_code_next_column_box_0_4_0 mod 2);
      transform_right_code_next_column_response_0 <= ((transform_right_code_next_column_centre +
        (transform_right_code_next_column_near / 2)) * 2) + (transform_right_code_next_column_near mod 2);
      transform_right_code_next_column_response_1 <= ((transform_right_code_next_column_centre +
        (transform_right_code_next_column_outer / 2)) * 2) + (transform_right_code_next_column_outer mod 2);
      transform_right_code_next_column_response_2 <= (transform_right_code_next_column_upper +
        transform_right_code_next_column_lower) mod 65536;
      transform_right_code_next_row_box_0_0 <= transform_right_code_next_row_earlier_0_0_0 +
        transform_right_code_next_column_response_0;
      transform_right_code_next_row_box_0_1 <= transform_right_code_next_row_earlier_0_1_0 +
        transform_right_code_next_column_response_1;
      transform_right_code_next_row_box_0_2 <= transform_right_code_next_row_earlier_0_2_0 +
        transform_right_code_next_column_response_2;
      transform_right_code_next_row_centre_0 <= transform_right_code_next_row_column_0_3;
      transform_right_code_next_row_centre_1 <= transform_right_code_next_row_column_1_3;
      transform_right_code_next_row_centre_2 <= transform_right_code_next_row_column_2_3;
      transform_right_code_next_row_outer_1 <= transform_right_code_next_row_box_0_1 +
        transform_right_code_next_row_column_1_7;
      transform_right_code_next_row_outer_2 <= transform_right_code_next_row_box_0_2 +
        transform_right_code_next_row_column_2_7;
      transform_right_code_next_row_before_0 <= ((transform_right_code_next_row_column_0_5 +
        (transform_right_code_next_row_column_0_7 / 2)) * 2) + (transform_right_code_next_row_column_0_7 mod 2);
      transform_right_code_next_row_before_1 <= ((transform_right_code_next_row_column_1_5 +
        (transform_right_code_next_row_column_1_7 / 2)) * 2) + (transform_right_code_next_row_column_1_7 mod 2);
      transform_right_code_next_row_before_2 <= ((transform_right_code_next_row_column_2_5 +
        (transform_right_code_next_row_column_2_7 / 2)) * 2) + (transform_right_code_next_row_column_2_7 mod 2);
      transform_right_code_next_row_after_0 <= (((transform_right_code_next_row_box_0_0 / 2) +
        transform_right_code_next_row_column_0_1) * 2) + (transform_right_code_next_row_box_0_0 mod 2);
      transform_right_code_next_row_after_1 <= (((transform_right_code_next_row_box_0_1 / 2) +
        transform_right_code_next_row_column_1_1) * 2) + (transform_right_code_next_row_box_0_1 mod 2);
      transform_right_code_next_row_after_2 <= (((transform_right_code_next_row_box_0_2 / 2) +
        transform_right_code_next_row_column_2_1) * 2) + (transform_right_code_next_row_box_0_2 mod 2);
      transform_right_code_next_row_even_1 <= ((((transform_right_code_next_row_outer_1 / 2) -
        transform_right_code_next_row_centre_1) mod 524288) * 2) + (transform_right_code_next_row_outer_1 mod 2);
      transform_right_code_next_row_even_2 <= ((((transform_right_code_next_row_outer_2 / 2) -
        transform_right_code_next_row_centre_2) mod 524288) * 2) + (transform_right_code_next_row_outer_2 mod 2);
      transform_right_code_next_row_odd_1 <= (transform_right_code_next_row_before_1 -
        transform_right_code_next_row_after_1) mod 1048576;
      transform_right_code_next_row_odd_2 <= (transform_right_code_next_row_before_2 -
        transform_right_code_next_row_after_2) mod 1048576;
      transform_right_code_next_row_signs <= ((other_0 / 524288) * 2) + (other_1 / 524288) +
        ((((transform_right_code_next_row_even_2 + transform_right_code_next_row_odd_1) mod 1048576) / 524288) * 8) +
        ((((transform_right_code_next_row_odd_1 - transform_right_code_next_row_even_2) mod 1048576) / 524288) * 32) +
        ((((transform_right_code_next_row_even_1 - transform_right_code_next_row_odd_2) mod 1048576) / 524288) * 4) +
        ((((transform_right_code_next_row_even_1 + transform_right_code_next_row_odd_2) mod 1048576) / 524288) * 16);
      transform_filtering_0_inside_0 <= transform_columns_inside_0;
      transform_filtering_0_inside_1 <= transform_columns_inside_1;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_inside_0 <= transform_filtering_0_inside_0;
      transform_filtering_1_inside_1 <= transform_filtering_0_inside_1;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      transform_filtering_2_inside_0 <= transform_filtering_1_inside_0;
      transform_filtering_2_inside_1 <= transform_filtering_1_inside_1;
      transform_filtering_2_start_of_frame <= transform_filtering_1_start_of_frame;
      transform_filtering_2_valid <= transform_filtering_1_valid;
      transform_filtering_3_inside_0 <= transform_filtering_2_inside_0;
      transform_filtering_3_inside_1 <= transform_filtering_2_inside_1;
      transform_filtering_3_start_of_frame <= transform_filtering_2_start_of_frame;
      transform_filtering_3_valid <= transform_filtering_2_valid;
      transform_filtering_4_inside_0 <= transform_filtering_3_inside_0;
      transform_filtering_4_inside_1 <= transform_filtering_3_inside_1;
      transform_filtering_4_start_of_frame <= transform_filtering_3_start_of_frame;
      transform_filtering_4_valid <= transform_filtering_3_valid;
      transform_filtering_5_inside_0 <= transform_filtering_4_inside_0;
      transform_filtering_5_inside_1 <= transform_filtering_4_inside_1;
      transform_filtering_5_start_of_frame <= transform_filtering_4_start_of_frame;
      transform_filtering_5_valid <= transform_filtering_4_valid;
      transform_filtering_6_inside_0 <= transform_filtering_5_inside_0;
      transform_filtering_6_inside_1 <= transform_filtering_5_inside_1;
      transform_filtering_6_start_of_frame <= transform_filtering_5_start_of_frame;
      transform_filtering_6_valid <= transform_filtering_5_valid;
      transform_filtering_7_start_of_frame <= transform_filtering_6_start_of_frame;
      transform_filtering_7_valid <= transform_filtering_6_valid;
      if coarse_pixels_valid and hold_back_held_is_new and (to_integer(hold_back_held_0(0 downto 0)) = 1) then
        transform_counter_group <= as_number(transform_counter_group_all) * 32;
      else
        transform_counter_group <= transform_counter_group_choice_2;
      end if;
      if transform_from_first_0_value = 0 then
        transform_from_first_0 <= (not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0))) and ((transform_centre_column / 32) = 1);
      else
        transform_from_first_0 <= not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0));
      end if;
      if transform_from_first_1_choice then
        transform_from_first_1 <= (not (((not (((transform_centre_group / 8) mod 2) = 1)) or (((transform_centre_group
          / 2) mod 4) = 0)) and ((transform_centre_group / 16) = 0))) and (((transform_centre_column / 32) = 1) or
          (((transform_centre_column / 16) mod 2) = 1));
      else
        transform_from_first_1 <= not (((not (((transform_centre_group / 8) mod 2) = 1)) or (((transform_centre_group /
          2) mod 4) = 0)) and ((transform_centre_group / 16) = 0));
      end if;
      if transform_from_first_0_value = 15 then
        transform_up_to_last_0 <= transform_up_to_last_0_choice and (not ((transform_centre_column / 32) = 1));
      else
        transform_up_to_last_0 <= transform_up_to_last_0_choice;
      end if;
      if transform_filtering_6_inside_0 then
        transform_left_code_bits <= transform_left_code_earlier_1;
        transform_right_code_bits <= transform_right_code_earlier_1;
      else
        transform_left_code_bits <= 0;
        transform_right_code_bits <= 0;
      end if;
      if transform_filtering_6_inside_1 then
        transform_left_code_next_bits <= transform_left_code_next_row_signs;
        transform_right_code_next_bits <= transform_right_code_next_row_signs;
      else
        transform_left_code_next_bits <= 0;
        transform_right_code_next_bits <= 0;
      end if;
      if transform_counter_group_is_equal and transform_counter_group_is_equal_3 then
        transform_counter_next_frame_choice := (transform_counter_group = 36) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if coarse_pixels_valid then
        if transform_counter_group_is_equal or (hold_back_held_is_new and (to_integer(hold_back_held_0(0 downto 0)) =
          1)) then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
        end if;
        if transform_counter_next_frame_choice then
          transform_counter_next_frame <= transform_counter_group_all or (not hold_back_held_is_new) or (not
            (to_integer(hold_back_held_0(0 downto 0)) = 1));
        else
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            hold_back_held_is_new and (to_integer(hold_back_held_0(0 downto 0)) = 1);
        end if;
      end if;
      if (other_12 / 256) = 1 then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_words_0 / 4096) +
          ((transform_left_rows_ready_words_1 mod 4096) * 4096);
        transform_left_rows_write_words_1 <= (transform_left_rows_ready_words_1 / 4096) +
          ((transform_left_rows_ready_words_2 mod 4096) * 4096);
        transform_left_rows_write_words_2 <= (transform_left_rows_ready_words_2 / 4096) +
          ((transform_left_rows_ready_words_3 mod 4096) * 4096);
        transform_left_rows_write_words_3 <= (transform_left_rows_ready_words_3 / 4096) +
          (transform_left_rows_ready_words_4 * 4096);
        transform_left_rows_write_words_4 <= transform_left_rows_ready_newest_0;
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_words_0 / 4096) +
          ((transform_right_rows_ready_words_1 mod 4096) * 4096);
        transform_right_rows_write_words_1 <= (transform_right_rows_ready_words_1 / 4096) +
          ((transform_right_rows_ready_words_2 mod 4096) * 4096);
        transform_right_rows_write_words_2 <= (transform_right_rows_ready_words_2 / 4096) +
          ((transform_right_rows_ready_words_3 mod 4096) * 4096);
        transform_right_rows_write_words_3 <= (transform_right_rows_ready_words_3 / 4096) +
          (transform_right_rows_ready_words_4 * 4096);
        transform_right_rows_write_words_4 <= transform_right_rows_ready_newest_0;
        transform_write_column <= transform_ready_column;
      end if;
      if transform_filtering_3_valid then
        transform_left_code_row_column_0_0 <= transform_left_code_row_box_0_0;
        transform_left_code_row_column_0_1 <= transform_left_code_row_column_0_0;
        transform_left_code_row_column_0_2 <= transform_left_code_row_column_0_1;
        transform_left_code_row_column_0_3 <= transform_left_code_row_column_0_2;
        transform_left_code_row_column_1_0 <= transform_left_code_row_box_0_1;
        transform_left_code_row_column_1_1 <= transform_left_code_row_column_1_0;
        transform_left_code_row_column_1_2 <= transform_left_code_row_column_1_1;
        transform_left_code_row_column_1_3 <= transform_left_code_row_column_1_2;
        transform_left_code_row_column_2_0 <= transform_left_code_row_box_0_2;
        transform_left_code_row_column_2_1 <= transform_left_code_row_column_2_0;
        transform_left_code_row_column_2_2 <= transform_left_code_row_column_2_1;
        transform_left_code_row_column_2_3 <= transform_left_code_row_column_2_2;
        transform_left_code_next_row_column_0_0 <= transform_left_code_next_row_box_0_0;
        transform_left_code_next_row_column_0_1 <= transform_left_code_next_row_column_0_0;
        transform_left_code_next_row_column_0_2 <= transform_left_code_next_row_column_0_1;
        transform_left_code_next_row_column_0_3 <= transform_left_code_next_row_column_0_2;
        transform_left_code_next_row_column_0_4 <= transform_left_code_next_row_column_0_3;
        transform_left_code_next_row_column_0_5 <= transform_left_code_next_row_column_0_4;
        transform_left_code_next_row_column_0_6 <= transform_left_code_next_row_column_0_5;
        transform_left_code_next_row_column_0_7 <= transform_left_code_next_row_column_0_6;
        transform_left_code_next_row_column_1_0 <= transform_left_code_next_row_box_0_1;
        transform_left_code_next_row_column_1_1 <= transform_left_code_next_row_column_1_0;
        transform_left_code_next_row_column_1_2 <= transform_left_code_next_row_column_1_1;
        transform_left_code_next_row_column_1_3 <= transform_left_code_next_row_column_1_2;
        transform_left_code_next_row_column_1_4 <= transform_left_code_next_row_column_1_3;
        transform_left_code_next_row_column_1_5 <= transform_left_code_next_row_column_1_4;
        transform_left_code_next_row_column_1_6 <= transform_left_code_next_row_column_1_5;
        transform_left_code_next_row_column_1_7 <= transform_left_code_next_row_column_1_6;
        transform_left_code_next_row_column_2_0 <= transform_left_code_next_row_box_0_2;
        transform_left_code_next_row_column_2_1 <= transform_left_code_next_row_column_2_0;
        transform_left_code_next_row_column_2_2 <= transform_left_code_next_row_column_2_1;
        transform_left_code_next_row_column_2_3 <= transform_left_code_next_row_column_2_2;
        transform_left_code_next_row_column_2_4 <= transform_left_code_next_row_column_2_3;
        transform_left_code_next_row_column_2_5 <= transform_left_code_next_row_column_2_4;
        transform_left_code_next_row_column_2_6 <= transform_left_code_next_row_column_2_5;
        transform_left_code_next_row_column_2_7 <= transform_left_code_next_row_column_2_6;
        transform_right_code_row_column_0_0 <= transform_right_code_row_box_0_0;
        transform_right_code_row_column_0_1 <= transform_right_code_row_column_0_0;
        transform_right_code_row_column_0_2 <= transform_right_code_row_column_0_1;
        transform_right_code_row_column_0_3 <= transform_right_code_row_column_0_2;
        transform_right_code_row_column_1_0 <= transform_right_code_row_box_0_1;
        transform_right_code_row_column_1_1 <= transform_right_code_row_column_1_0;
        transform_right_code_row_column_1_2 <= transform_right_code_row_column_1_1;
        transform_right_code_row_column_1_3 <= transform_right_code_row_column_1_2;
        transform_right_code_row_column_2_0 <= transform_right_code_row_box_0_2;
        transform_right_code_row_column_2_1 <= transform_right_code_row_column_2_0;
        transform_right_code_row_column_2_2 <= transform_right_code_row_column_2_1;
        transform_right_code_row_column_2_3 <= transform_right_code_row_column_2_2;
        transform_right_code_next_row_column_0_0 <= transform_right_code_next_row_box_0_0;
        transform_right_code_next_row_column_0_1 <= transform_right_code_next_row_column_0_0;
        transform_right_code_next_row_column_0_2 <= transform_right_code_next_row_column_0_1;
        transform_right_code_next_row_column_0_3 <= transform_right_code_next_row_column_0_2;
        transform_right_code_next_row_column_0_4 <= transform_right_code_next_row_column_0_3;
        transform_right_code_next_row_column_0_5 <= transform_right_code_next_row_column_0_4;
        transform_right_code_next_row_column_0_6 <= transform_right_code_next_row_column_0_5;
        transform_right_code_next_row_column_0_7 <= transform_right_code_next_row_column_0_6;
        transform_right_code_next_row_column_1_0 <= transform_right_code_next_row_box_0_1;
        transform_right_code_next_row_column_1_1 <= transform_right_code_next_row_column_1_0;
        transform_right_code_next_row_column_1_2 <= transform_right_code_next_row_column_1_1;
        transform_right_code_next_row_column_1_3 <= transform_right_code_next_row_column_1_2;
        transform_right_code_next_row_column_1_4 <= transform_right_code_next_row_column_1_3;
        transform_right_code_next_row_column_1_5 <= transform_right_code_next_row_column_1_4;
        transform_right_code_next_row_column_1_6 <= transform_right_code_next_row_column_1_5;
        transform_right_code_next_row_column_1_7 <= transform_right_code_next_row_column_1_6;
        transform_right_code_next_row_column_2_0 <= transform_right_code_next_row_box_0_2;
        transform_right_code_next_row_column_2_1 <= transform_right_code_next_row_column_2_0;
        transform_right_code_next_row_column_2_2 <= transform_right_code_next_row_column_2_1;
        transform_right_code_next_row_column_2_3 <= transform_right_code_next_row_column_2_2;
        transform_right_code_next_row_column_2_4 <= transform_right_code_next_row_column_2_3;
        transform_right_code_next_row_column_2_5 <= transform_right_code_next_row_column_2_4;
        transform_right_code_next_row_column_2_6 <= transform_right_code_next_row_column_2_5;
        transform_right_code_next_row_column_2_7 <= transform_right_code_next_row_column_2_6;
      end if;
      if transform_filtering_6_valid then
        transform_left_code_earlier_0 <= transform_left_code_row_signs;
        transform_left_code_earlier_1 <= transform_left_code_earlier_0;
        transform_right_code_earlier_0 <= transform_right_code_row_signs;
        transform_right_code_earlier_1 <= transform_right_code_earlier_0;
      end if;
      if transform_filtering_2_valid then
        transform_left_code_next_row_earlier_0_0_0 <= transform_left_code_next_column_response_0;
        transform_left_code_next_row_earlier_0_1_0 <= transform_left_code_next_column_response_1;
        transform_left_code_next_row_earlier_0_2_0 <= transform_left_code_next_column_response_2;
        transform_right_code_next_row_earlier_0_0_0 <= transform_right_code_next_column_response_0;
        transform_right_code_next_row_earlier_0_1_0 <= transform_right_code_next_column_response_1;
        transform_right_code_next_row_earlier_0_2_0 <= transform_right_code_next_column_response_2;
      end if;
      -- ahead
      if transform_filtering_7_valid then
        ahead_ring_write_address <= ahead_ring_read_address;
        if ahead_ring_read_address = 20 then
          ahead_ring_read_address <= 0;
        else
          ahead_ring_read_address <= (ahead_ring_read_address + 1) mod 32;
        end if;
      end if;
      ahead_holds_groups_is_equal := ahead_ring_read_address = 0;
      ahead_holds_groups <= ahead_holds_groups_is_equal or ahead_held_is_new;
      ahead_held_valid <= transform_filtering_7_valid;
      if ahead_holds_groups_is_equal then
        ahead_held_is_new <= ahead_held_is_new or transform_filtering_7_valid;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 63;
      raster_features_reference_0 <= to_integer(ahead_held_0(12 downto 1));
      raster_features_valid <= ahead_held_valid;
      if ahead_held_valid and ahead_holds_groups and (to_integer(ahead_held_0(0 downto 0)) = 1) then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 34) and
          raster_place_group_is_equal and ahead_held_valid))) mod 64;
      end if;
      if ahead_held_valid then
        if raster_place_group_is_equal or (ahead_holds_groups and (to_integer(ahead_held_0(0 downto 0)) = 1)) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
      end if;
      -- bases
      bases_address_0_is_equal := (raster_place_column / 16) = 0;
      bases_address_0_value := ((raster_place_column + 497) mod 512) / 8;
      if bases_address_0_is_equal then
        bases_address_0_choice := 0;
      else
        bases_address_0_choice := bases_address_0_value;
      end if;
      if bases_address_0_is_equal then
        bases_address_0_choice_2 := 0;
      else
        bases_address_0_choice_2 := bases_address_0_value mod 8;
      end if;
      bases_asked_frame_starts_is_equal := raster_place_group = 0;
      bases_asked_frame_starts_is_equal_2 := raster_place_column = 0;
      bases_goal_0_0_value := ((bases_ready_targets_0 / 2) mod 128) * 2;
      bases_goal_0_1_value := ((bases_ready_targets_1 / 2) mod 128) * 2;
      bases_goal_0_2_value := ((bases_ready_targets_2 / 2) mod 128) * 2;
      bases_rises_0_0_sum := bases_base_0_0 + 3;
      bases_rises_0_0_all := ((bases_goal_0_0 - bases_rises_0_0_sum) >= 0) and (not bases_wanted_head);
      bases_rises_0_1_sum := bases_base_0_1 + 3;
      bases_rises_0_1_all := ((bases_goal_0_1 - bases_rises_0_1_sum) >= 0) and (not bases_wanted_head);
      bases_rises_1_0_sum := bases_base_1_0 + 3;
      bases_rises_1_0_all := ((bases_goal_1_0 - bases_rises_1_0_sum) >= 0) and (not bases_wanted_head);
      bases_rises_1_1_sum := bases_base_1_1 + 3;
      bases_rises_1_1_all := ((bases_goal_1_1 - bases_rises_1_1_sum) >= 0) and (not bases_wanted_head);
      bases_falls_0_0_all := ((bases_goal_0_0 - bases_base_0_0) < 0) and (not bases_wanted_head);
      bases_falls_0_1_all := ((bases_goal_0_1 - bases_base_0_1) < 0) and (not bases_wanted_head);
      bases_falls_1_0_all := ((bases_goal_1_0 - bases_base_1_0) < 0) and (not bases_wanted_head);
      bases_falls_1_1_all := ((bases_goal_1_1 - bases_base_1_1) < 0) and (not bases_wanted_head);
      bases_address_0 <= ((((bases_address_0_choice / 8) + (raster_place_group / 8)) mod 8) * 8) +
        bases_address_0_choice_2;
      bases_address_1 <= ((((bases_address_0_choice / 8) + (((raster_place_group + 59) mod 64) / 8)) mod 8) * 8) +
        bases_address_0_choice_2;
      bases_address_2 <= ((((bases_address_0_choice / 8) + (((((raster_place_group / 2) + 31) mod 32) * 2) / 8)) mod 8)
        * 8) + bases_address_0_choice_2;
      bases_asked_column <= raster_place_column;
      bases_asked_head <= bases_address_0_is_equal;
      bases_asked_frame_starts <= bases_asked_frame_starts_is_equal and bases_asked_frame_starts_is_equal_2;
      bases_asked_valid <= raster_features_valid;
      bases_read_column <= bases_asked_column;
      bases_read_limit <= bases_asked_limit;
      bases_read_head <= bases_asked_head;
      bases_read_frame_starts <= bases_asked_frame_starts;
      bases_read_valid <= bases_asked_valid;
      bases_ready_targets_0 <= to_integer(bases_read_targets_0);
      bases_ready_targets_1 <= to_integer(bases_read_targets_1);
      bases_ready_targets_2 <= to_integer(bases_read_targets_2);
      bases_ready_column <= bases_read_column;
      bases_ready_limit <= bases_read_limit;
      bases_ready_head <= bases_read_head;
      bases_ready_frame_starts <= bases_read_frame_starts;
      bases_ready_valid <= bases_read_valid;
      bases_wanted_head <= bases_ready_head;
      bases_wanted_frame_starts <= bases_ready_frame_starts;
      bases_wanted_valid <= bases_ready_valid;
      bases_rises_0_0 <= bases_rises_0_0_all;
      bases_rises_0_1 <= bases_rises_0_1_all;
      bases_rises_1_0 <= bases_rises_1_0_all;
      bases_rises_1_1 <= bases_rises_1_1_all;
      bases_falls_0_0 <= bases_falls_0_0_all;
      bases_falls_0_1 <= bases_falls_0_1_all;
      bases_falls_1_0 <= bases_falls_1_0_all;
      bases_falls_1_1 <= bases_falls_1_1_all;
      bases_stands_column <= compared_write_column;
      bases_stands_frame_starts <= bases_wanted_frame_starts;
      bases_stands_valid <= bases_wanted_valid;
      if bases_address_0_is_equal then
        bases_asked_limit <= 48;
      else
        bases_asked_limit <= 63 - raster_place_column;
      end if;
      if (bases_goal_0_0_value - bases_ready_limit) < 0 then
        bases_goal_0_0 <= bases_goal_0_0_value;
      else
        bases_goal_0_0 <= bases_ready_limit;
      end if;
      if (bases_goal_0_1_value - bases_ready_limit) < 0 then
        bases_goal_0_1 <= bases_goal_0_1_value;
      else
        bases_goal_0_1 <= bases_ready_limit;
      end if;
      if (bases_goal_0_2_value - bases_ready_limit) < 0 then
        bases_goal_0_2 <= bases_goal_0_2_value;
      else
        bases_goal_0_2 <= bases_ready_limit;
      end if;
      if ((bases_ready_targets_0 / 256) - bases_ready_limit) < 0 then
        bases_goal_1_0 <= bases_ready_targets_0 / 256;
      else
        bases_goal_1_0 <= bases_ready_limit;
      end if;
      if ((bases_ready_targets_1 / 256) - bases_ready_limit) < 0 then
        bases_goal_1_1 <= bases_ready_targets_1 / 256;
      else
        bases_goal_1_1 <= bases_ready_limit;
      end if;
      if ((bases_ready_targets_2 / 256) - bases_ready_limit) < 0 then
        bases_goal_1_2 <= bases_ready_targets_2 / 256;
      else
        bases_goal_1_2 <= bases_ready_limit;
      end if;
      if bases_wanted_head then
        bases_from_0_0 <= bases_goal_0_0;
        bases_from_0_1 <= bases_goal_0_1;
        bases_from_1_0 <= bases_goal_1_0;
        bases_from_1_1 <= bases_goal_1_1;
      else
        bases_from_0_0 <= bases_base_0_0 mod 512;
        bases_from_0_1 <= bases_base_0_1 mod 512;
        bases_from_1_0 <= bases_base_1_0 mod 512;
        bases_from_1_1 <= bases_base_1_1 mod 512;
      end if;
      if bases_ready_valid then
        bases_wanted_column <= bases_ready_column;
      end if;
      if ((((as_number(bases_falls_0_0_all) * 32768) + 32768) mod 65536) - 32768) < 0 then
        bases_base_0_0_choice := 65535;
      else
        bases_base_0_0_choice := 0;
      end if;
      if bases_rises_0_0_all then
        bases_base_0_0_choice_2 := bases_rises_0_0_sum mod 65536;
      else
        bases_base_0_0_choice_2 := (bases_base_0_0 + bases_base_0_0_choice) mod 65536;
      end if;
      if ((((as_number(bases_falls_0_1_all) * 32768) + 32768) mod 65536) - 32768) < 0 then
        bases_base_0_1_choice := 65535;
      else
        bases_base_0_1_choice := 0;
      end if;
      if bases_rises_0_1_all then
        bases_base_0_1_choice_2 := bases_rises_0_1_sum mod 65536;
      else
        bases_base_0_1_choice_2 := (bases_base_0_1 + bases_base_0_1_choice) mod 65536;
      end if;
      bases_base_0_2_sum := bases_base_0_2 + 3;
      if ((((as_number((((bases_goal_0_2 - bases_base_0_2) < 0) and (not bases_wanted_head))) * 32768) + 32768) mod
        65536) - 32768) < 0 then
        bases_base_0_2_choice := 65535;
      else
        bases_base_0_2_choice := 0;
      end if;
      if ((bases_goal_0_2 - bases_base_0_2_sum) >= 0) and (not bases_wanted_head) then
        bases_base_0_2_choice_2 := bases_base_0_2_sum mod 65536;
      else
        bases_base_0_2_choice_2 := (bases_base_0_2 + bases_base_0_2_choice) mod 65536;
      end if;
      if ((((as_number(bases_falls_1_0_all) * 32768) + 32768) mod 65536) - 32768) < 0 then
        bases_base_1_0_choice := 65535;
      else
        bases_base_1_0_choice := 0;
      end if;
      if bases_rises_1_0_all then
        bases_base_1_0_choice_2 := bases_rises_1_0_sum mod 65536;
      else
        bases_base_1_0_choice_2 := (bases_base_1_0 + bases_base_1_0_choice) mod 65536;
      end if;
      if ((((as_number(bases_falls_1_1_all) * 32768) + 32768) mod 65536) - 32768) < 0 then
        bases_base_1_1_choice := 65535;
      else
        bases_base_1_1_choice := 0;
      end if;
      if bases_rises_1_1_all then
        bases_base_1_1_choice_2 := bases_rises_1_1_sum mod 65536;
      else
        bases_base_1_1_choice_2 := (bases_base_1_1 + bases_base_1_1_choice) mod 65536;
      end if;
      bases_base_1_2_sum := bases_base_1_2 + 3;
      if ((((as_number((((bases_goal_1_2 - bases_base_1_2) < 0) and (not bases_wanted_head))) * 32768) + 32768) mod
        65536) - 32768) < 0 then
        bases_base_1_2_choice := 65535;
      else
        bases_base_1_2_choice := 0;
      end if;
      if ((bases_goal_1_2 - bases_base_1_2_sum) >= 0) and (not bases_wanted_head) then
        bases_base_1_2_choice_2 := bases_base_1_2_sum mod 65536;
      else
        bases_base_1_2_choice_2 := (bases_base_1_2 + bases_base_1_2_choice) mod 65536;
      end if;
      if bases_wanted_valid then
        if bases_wanted_head then
          bases_base_0_0 <= bases_goal_0_0;
          bases_base_0_1 <= bases_goal_0_1;
          bases_base_0_2 <= bases_goal_0_2;
          bases_base_1_0 <= bases_goal_1_0;
          bases_base_1_1 <= bases_goal_1_1;
          bases_base_1_2 <= bases_goal_1_2;
        else
          bases_base_0_0 <= bases_base_0_0_choice_2;
          bases_base_0_1 <= bases_base_0_1_choice_2;
          bases_base_0_2 <= bases_base_0_2_choice_2;
          bases_base_1_0 <= bases_base_1_0_choice_2;
          bases_base_1_1 <= bases_base_1_1_choice_2;
          bases_base_1_2 <= bases_base_1_2_choice_2;
        end if;
      end if;
      if bases_stands_valid then
        bases_from_0_2 <= bases_base_0_2;
      end if;
      -- rows
      rows_last_3_sum := (transform_left_code_next_bits * 64) + transform_left_code_bits;
      rows_newest_column_any := (not transform_filtering_7_valid) or (not transform_filtering_7_start_of_frame);
      rows_newest_column_is_equal := rows_newest_column = 63;
      rows_newest_column_sum := rows_newest_column + 1;
      if rows_newest_column_is_equal then
        rows_newest_column_choice := 0;
      else
        rows_newest_column_choice := rows_newest_column_sum mod 65536;
      end if;
      if rows_newest_column_any then
        rows_newest_column_choice_2 := rows_newest_column_choice;
      else
        rows_newest_column_choice_2 := 0;
      end if;
      if transform_filtering_7_valid then
        rows_last_1 <= rows_last_2;
        rows_last_2 <= rows_last_3;
        rows_last_3 <= rows_last_3_sum;
        rows_newest_column <= rows_newest_column_choice_2;
      end if;
      rows_newest_row_is_equal := (rows_newest_row / 16) = 6;
      rows_newest_row_sum := (rows_newest_row / 16) + 1;
      if rows_newest_row_is_equal then
        rows_newest_row_choice := 0;
      else
        rows_newest_row_choice := rows_newest_row_sum mod 4096;
      end if;
      if rows_newest_column_is_equal then
        rows_newest_row_choice_2 := rows_newest_row_choice;
      else
        rows_newest_row_choice_2 := rows_newest_row / 16;
      end if;
      if rows_newest_column_any then
        rows_newest_row_choice_3 := rows_newest_row_choice_2;
      else
        rows_newest_row_choice_3 := 0;
      end if;
      if transform_filtering_7_valid then
        rows_newest_row_choice_4 := rows_newest_row_choice_3;
      else
        rows_newest_row_choice_4 := rows_newest_row / 16;
      end if;
      rows_enter_row_all := bases_stands_valid and (bases_stands_column = 0);
      if (rows_enter_row / 16) = 6 then
        rows_enter_row_choice := 0;
      else
        rows_enter_row_choice := ((rows_enter_row / 16) + 1) mod 4096;
      end if;
      if bases_stands_frame_starts then
        rows_enter_row_choice_2 := 0;
      else
        rows_enter_row_choice_2 := rows_enter_row_choice;
      end if;
      if rows_enter_row_all then
        rows_enter_row_choice_3 := rows_enter_row_choice_2;
      else
        rows_enter_row_choice_3 := rows_enter_row / 16;
      end if;
      if (rows_leave_row / 16) = 6 then
        rows_leave_row_choice := 0;
      else
        rows_leave_row_choice := ((rows_leave_row / 16) + 1) mod 4096;
      end if;
      if bases_stands_frame_starts then
        rows_leave_row_choice_2 := 2;
      else
        rows_leave_row_choice_2 := rows_leave_row_choice;
      end if;
      if rows_enter_row_all then
        rows_leave_row_choice_3 := rows_leave_row_choice_2;
      else
        rows_leave_row_choice_3 := rows_leave_row / 16;
      end if;
      rows_position_0_0_sum := bases_from_0_0 + bases_stands_column;
      rows_position_0_1_sum := bases_from_0_1 + bases_stands_column;
      rows_position_1_0_sum := bases_from_1_0 + bases_stands_column;
      rows_position_1_1_sum := bases_from_1_1 + bases_stands_column;
      rows_address_0_value := (((rows_enter_row / 16) + (rows_position_0_0 / 64)) mod 8) * 16;
      rows_address_0_value_2 := (rows_position_0_0 / 4) mod 16;
      rows_address_4_value := (((rows_leave_row / 16) + (rows_position_0_1 / 64)) mod 8) * 16;
      rows_address_4_value_2 := (rows_position_0_1 / 4) mod 16;
      rows_address_8_value := (((rows_enter_row / 16) + (rows_position_1_0 / 64)) mod 8) * 16;
      rows_address_8_value_2 := (rows_position_1_0 / 4) mod 16;
      rows_address_12_value := (((rows_leave_row / 16) + (rows_position_1_1 / 64)) mod 8) * 16;
      rows_address_12_value_2 := (rows_position_1_1 / 4) mod 16;
      if (rows_ready_first_bank_0_0 / 2) = 1 then
        rows_codes_0_0_0_choice := rows_ready_codes_3;
      else
        rows_codes_0_0_0_choice := rows_ready_codes_1;
      end if;
      if (rows_ready_first_bank_0_0 / 2) = 1 then
        rows_codes_0_0_0_choice_2 := rows_ready_codes_2;
      else
        rows_codes_0_0_0_choice_2 := rows_ready_codes_0;
      end if;
      if (rows_ready_first_bank_0_0 / 2) = 1 then
        rows_codes_0_0_1_choice := rows_ready_codes_0;
      else
        rows_codes_0_0_1_choice := rows_ready_codes_2;
      end if;
      if (rows_ready_first_bank_0_0 / 2) = 1 then
        rows_codes_0_0_2_choice := rows_ready_codes_1;
      else
        rows_codes_0_0_2_choice := rows_ready_codes_3;
      end if;
      if (rows_ready_first_bank_0_1 / 2) = 1 then
        rows_codes_0_1_0_choice := rows_ready_codes_7;
      else
        rows_codes_0_1_0_choice := rows_ready_codes_5;
      end if;
      if (rows_ready_first_bank_0_1 / 2) = 1 then
        rows_codes_0_1_0_choice_2 := rows_ready_codes_6;
      else
        rows_codes_0_1_0_choice_2 := rows_ready_codes_4;
      end if;
      if (rows_ready_first_bank_0_1 / 2) = 1 then
        rows_codes_0_1_1_choice := rows_ready_codes_4;
      else
        rows_codes_0_1_1_choice := rows_ready_codes_6;
      end if;
      if (rows_ready_first_bank_0_1 / 2) = 1 then
        rows_codes_0_1_2_choice := rows_ready_codes_5;
      else
        rows_codes_0_1_2_choice := rows_ready_codes_7;
      end if;
      if (rows_ready_first_bank_1_0 / 2) = 1 then
        rows_codes_1_0_0_choice := rows_ready_codes_11;
      else
        rows_codes_1_0_0_choice := rows_ready_codes_9;
      end if;
      if (rows_ready_first_bank_1_0 / 2) = 1 then
        rows_codes_1_0_0_choice_2 := rows_ready_codes_10;
      else
        rows_codes_1_0_0_choice_2 := rows_ready_codes_8;
      end if;
      if (rows_ready_first_bank_1_0 / 2) = 1 then
        rows_codes_1_0_1_choice := rows_ready_codes_8;
      else
        rows_codes_1_0_1_choice := rows_ready_codes_10;
      end if;
      if (rows_ready_first_bank_1_0 / 2) = 1 then
        rows_codes_1_0_2_choice := rows_ready_codes_9;
      else
        rows_codes_1_0_2_choice := rows_ready_codes_11;
      end if;
      if (rows_ready_first_bank_1_1 / 2) = 1 then
        rows_codes_1_1_0_choice := rows_ready_codes_15;
      else
        rows_codes_1_1_0_choice := rows_ready_codes_13;
      end if;
      if (rows_ready_first_bank_1_1 / 2) = 1 then
        rows_codes_1_1_0_choice_2 := rows_ready_codes_14;
      else
        rows_codes_1_1_0_choice_2 := rows_ready_codes_12;
      end if;
      if (rows_ready_first_bank_1_1 / 2) = 1 then
        rows_codes_1_1_1_choice := rows_ready_codes_12;
      else
        rows_codes_1_1_1_choice := rows_ready_codes_14;
      end if;
      if (rows_ready_first_bank_1_1 / 2) = 1 then
        rows_codes_1_1_2_choice := rows_ready_codes_13;
      else
        rows_codes_1_1_2_choice := rows_ready_codes_15;
      end if;
      rows_newest_row <= rows_newest_row_choice_4 * 16;
      rows_enter_row <= rows_enter_row_choice_3 * 16;
      rows_leave_row <= rows_leave_row_choice_3 * 16;
      rows_position_0_0 <= rows_position_0_0_sum mod 512;
      rows_position_0_1 <= rows_position_0_1_sum mod 512;
      rows_position_1_0 <= rows_position_1_0_sum mod 512;
      rows_position_1_1 <= rows_position_1_1_sum mod 512;
      rows_wanted_first_bank_0_0 <= rows_position_0_0_sum mod 4;
      rows_wanted_first_bank_0_1 <= rows_position_0_1_sum mod 4;
      rows_wanted_first_bank_1_0 <= rows_position_1_0_sum mod 4;
      rows_wanted_first_bank_1_1 <= rows_position_1_1_sum mod 4;
      rows_wanted_one_0_0 <= (not bases_falls_0_0) and (not bases_rises_0_0);
      rows_wanted_one_0_1 <= (not bases_falls_0_1) and (not bases_rises_0_1);
      rows_wanted_one_1_0 <= (not bases_falls_1_0) and (not bases_rises_1_0);
      rows_wanted_one_1_1 <= (not bases_falls_1_1) and (not bases_rises_1_1);
      rows_wanted_four_0_0 <= bases_rises_0_0;
      rows_wanted_four_0_1 <= bases_rises_0_1;
      rows_wanted_four_1_0 <= bases_rises_1_0;
      rows_wanted_four_1_1 <= bases_rises_1_1;
      rows_address_0 <= (rows_address_0_value + rows_address_0_value_2 + as_number((((rows_wanted_first_bank_0_0 / 2) =
        1) or ((rows_wanted_first_bank_0_0 mod 2) = 1)))) mod 128;
      rows_address_1 <= (rows_address_0_value + rows_address_0_value_2 + (rows_wanted_first_bank_0_0 / 2)) mod 128;
      rows_address_2 <= (rows_address_0_value + rows_address_0_value_2 + as_number((rows_wanted_first_bank_0_0 = 3)))
        mod 128;
      rows_address_3 <= rows_address_0_value + rows_address_0_value_2;
      rows_address_4 <= (rows_address_4_value + rows_address_4_value_2 + as_number((((rows_wanted_first_bank_0_1 / 2) =
        1) or ((rows_wanted_first_bank_0_1 mod 2) = 1)))) mod 128;
      rows_address_5 <= (rows_address_4_value + rows_address_4_value_2 + (rows_wanted_first_bank_0_1 / 2)) mod 128;
      rows_address_6 <= (rows_address_4_value + rows_address_4_value_2 + as_number((rows_wanted_first_bank_0_1 = 3)))
        mod 128;
      rows_address_7 <= rows_address_4_value + rows_address_4_value_2;
      rows_address_8 <= (rows_address_8_value + rows_address_8_value_2 + as_number((((rows_wanted_first_bank_1_0 / 2) =
        1) or ((rows_wanted_first_bank_1_0 mod 2) = 1)))) mod 128;
      rows_address_9 <= (rows_address_8_value + rows_address_8_value_2 + (rows_wanted_first_bank_1_0 / 2)) mod 128;
      rows_address_10 <= (rows_address_8_value + rows_address_8_value_2 + as_number((rows_wanted_first_bank_1_0 = 3)))
        mod 128;
      rows_address_11 <= rows_address_8_value + rows_address_8_value_2;
      rows_address_12 <= (rows_address_12_value + rows_address_12_value_2 + as_number((((rows_wanted_first_bank_1_1 /
        2) = 1) or ((rows_wanted_first_bank_1_1 mod 2) = 1)))) mod 128;
      rows_address_13 <= (rows_address_12_value + rows_address_12_value_2 + (rows_wanted_first_bank_1_1 / 2)) mod 128;
      rows_address_14 <= (rows_address_12_value + rows_address_12_value_2 + as_number((rows_wanted_first_bank_1_1 =
        3))) mod 128;
      rows_address_15 <= rows_address_12_value + rows_address_12_value_2;
      rows_asked_first_bank_0_0 <= rows_wanted_first_bank_0_0;
      rows_asked_first_bank_0_1 <= rows_wanted_first_bank_0_1;
      rows_asked_first_bank_1_0 <= rows_wanted_first_bank_1_0;
      rows_asked_first_bank_1_1 <= rows_wanted_first_bank_1_1;
      rows_asked_one_0_0 <= rows_wanted_one_0_0;
      rows_asked_one_0_1 <= rows_wanted_one_0_1;
      rows_asked_one_1_0 <= rows_wanted_one_1_0;
      rows_asked_one_1_1 <= rows_wanted_one_1_1;
      rows_asked_four_0_0 <= rows_wanted_four_0_0;
      rows_asked_four_0_1 <= rows_wanted_four_0_1;
      rows_asked_four_1_0 <= rows_wanted_four_1_0;
      rows_asked_four_1_1 <= rows_wanted_four_1_1;
      rows_read_first_bank_0_0 <= rows_asked_first_bank_0_0;
      rows_read_first_bank_0_1 <= rows_asked_first_bank_0_1;
      rows_read_first_bank_1_0 <= rows_asked_first_bank_1_0;
      rows_read_first_bank_1_1 <= rows_asked_first_bank_1_1;
      rows_read_one_0_0 <= rows_asked_one_0_0;
      rows_read_one_0_1 <= rows_asked_one_0_1;
      rows_read_one_1_0 <= rows_asked_one_1_0;
      rows_read_one_1_1 <= rows_asked_one_1_1;
      rows_read_four_0_0 <= rows_asked_four_0_0;
      rows_read_four_0_1 <= rows_asked_four_0_1;
      rows_read_four_1_0 <= rows_asked_four_1_0;
      rows_read_four_1_1 <= rows_asked_four_1_1;
      rows_ready_codes_0 <= to_integer(rows_read_codes_0);
      rows_ready_codes_1 <= to_integer(rows_read_codes_1);
      rows_ready_codes_2 <= to_integer(rows_read_codes_2);
      rows_ready_codes_3 <= to_integer(rows_read_codes_3);
      rows_ready_codes_4 <= to_integer(rows_read_codes_4);
      rows_ready_codes_5 <= to_integer(rows_read_codes_5);
      rows_ready_codes_6 <= to_integer(rows_read_codes_6);
      rows_ready_codes_7 <= to_integer(rows_read_codes_7);
      rows_ready_codes_8 <= to_integer(rows_read_codes_8);
      rows_ready_codes_9 <= to_integer(rows_read_codes_9);
      rows_ready_codes_10 <= to_integer(rows_read_codes_10);
      rows_ready_codes_11 <= to_integer(rows_read_codes_11);
      rows_ready_codes_12 <= to_integer(rows_read_codes_12);
      rows_ready_codes_13 <= to_integer(rows_read_codes_13);
      rows_ready_codes_14 <= to_integer(rows_read_codes_14);
      rows_ready_codes_15 <= to_integer(rows_read_codes_15);
      rows_ready_first_bank_0_0 <= rows_read_first_bank_0_0;
      rows_ready_first_bank_0_1 <= rows_read_first_bank_0_1;
      rows_ready_first_bank_1_0 <= rows_read_first_bank_1_0;
      rows_ready_first_bank_1_1 <= rows_read_first_bank_1_1;
      rows_ready_one_0_0 <= rows_read_one_0_0;
      rows_ready_one_0_1 <= rows_read_one_0_1;
      rows_ready_one_1_0 <= rows_read_one_1_0;
      rows_ready_one_1_1 <= rows_read_one_1_1;
      rows_ready_four_0_0 <= rows_read_four_0_0;
      rows_ready_four_0_1 <= rows_read_four_0_1;
      rows_ready_four_1_0 <= rows_read_four_1_0;
      rows_ready_four_1_1 <= rows_read_four_1_1;
      rows_step_one_0_0 <= rows_ready_one_0_0;
      rows_step_one_0_1 <= rows_ready_one_0_1;
      rows_step_one_1_0 <= rows_ready_one_1_0;
      rows_step_one_1_1 <= rows_ready_one_1_1;
      rows_step_four_0_0 <= rows_ready_four_0_0;
      rows_step_four_0_1 <= rows_ready_four_0_1;
      rows_step_four_1_0 <= rows_ready_four_1_0;
      rows_step_four_1_1 <= rows_ready_four_1_1;
      if (rows_ready_first_bank_0_0 mod 2) = 1 then
        rows_codes_0_0_0 <= rows_codes_0_0_0_choice;
        rows_codes_0_0_1 <= rows_codes_0_0_1_choice;
        rows_codes_0_0_2 <= rows_codes_0_0_2_choice;
        rows_codes_0_0_3 <= rows_codes_0_0_0_choice_2;
      else
        rows_codes_0_0_0 <= rows_codes_0_0_0_choice_2;
        rows_codes_0_0_1 <= rows_codes_0_0_0_choice;
        rows_codes_0_0_2 <= rows_codes_0_0_1_choice;
        rows_codes_0_0_3 <= rows_codes_0_0_2_choice;
      end if;
      if (rows_ready_first_bank_0_1 mod 2) = 1 then
        rows_codes_0_1_0 <= rows_codes_0_1_0_choice;
        rows_codes_0_1_1 <= rows_codes_0_1_1_choice;
        rows_codes_0_1_2 <= rows_codes_0_1_2_choice;
        rows_codes_0_1_3 <= rows_codes_0_1_0_choice_2;
      else
        rows_codes_0_1_0 <= rows_codes_0_1_0_choice_2;
        rows_codes_0_1_1 <= rows_codes_0_1_0_choice;
        rows_codes_0_1_2 <= rows_codes_0_1_1_choice;
        rows_codes_0_1_3 <= rows_codes_0_1_2_choice;
      end if;
      if (rows_ready_first_bank_1_0 mod 2) = 1 then
        rows_codes_1_0_0 <= rows_codes_1_0_0_choice;
        rows_codes_1_0_1 <= rows_codes_1_0_1_choice;
        rows_codes_1_0_2 <= rows_codes_1_0_2_choice;
        rows_codes_1_0_3 <= rows_codes_1_0_0_choice_2;
      else
        rows_codes_1_0_0 <= rows_codes_1_0_0_choice_2;
        rows_codes_1_0_1 <= rows_codes_1_0_0_choice;
        rows_codes_1_0_2 <= rows_codes_1_0_1_choice;
        rows_codes_1_0_3 <= rows_codes_1_0_2_choice;
      end if;
      if (rows_ready_first_bank_1_1 mod 2) = 1 then
        rows_codes_1_1_0 <= rows_codes_1_1_0_choice;
        rows_codes_1_1_1 <= rows_codes_1_1_1_choice;
        rows_codes_1_1_2 <= rows_codes_1_1_2_choice;
        rows_codes_1_1_3 <= rows_codes_1_1_0_choice_2;
      else
        rows_codes_1_1_0 <= rows_codes_1_1_0_choice_2;
        rows_codes_1_1_1 <= rows_codes_1_1_0_choice;
        rows_codes_1_1_2 <= rows_codes_1_1_1_choice;
        rows_codes_1_1_3 <= rows_codes_1_1_2_choice;
      end if;
      if rows_newest_row_is_equal then
        rows_write_word_choice := 0;
      else
        rows_write_word_choice := rows_newest_row_sum mod 8;
      end if;
      if rows_newest_column_is_equal then
        rows_write_word_choice_2 := rows_write_word_choice;
      else
        rows_write_word_choice_2 := (rows_newest_row / 16) mod 8;
      end if;
      if rows_newest_column_any then
        rows_write_word_choice_3 := rows_write_word_choice_2;
      else
        rows_write_word_choice_3 := 0;
      end if;
      rows_write_codes_0_all := ((((rows_newest_column_sum mod 65536) / 2) mod 2) = 1) and ((rows_newest_column_sum mod
        2) = 1) and rows_newest_column_any and (rows_newest_column /= 63) and transform_filtering_7_valid;
      if rows_write_codes_0_all then
        rows_write_codes_0 <= rows_last_1;
        rows_write_codes_1 <= rows_last_2;
        rows_write_codes_2 <= rows_last_3;
        rows_write_codes_3 <= rows_last_3_sum;
        rows_write_word <= ((((((rows_newest_column_choice_2 / 4) mod 128) / 16) + rows_write_word_choice_3) mod 8) *
          16) + ((rows_newest_column_choice_2 / 4) mod 16);
      end if;
      -- pairs
      if raster_features_valid then
        pairs_ring_write_address <= pairs_ring_read_address;
        if pairs_ring_read_address = 15 then
          pairs_ring_read_address <= 0;
        else
          pairs_ring_read_address <= (pairs_ring_read_address + 1) mod 16;
        end if;
      end if;
      pairs_tag_first_cost_is_equal := raster_place_column = 15;
      pairs_row_inside_0 <= (raster_place_group >= 5) and (raster_place_group < 37);
      pairs_row_inside_1 <= not ((raster_place_group / 32) = 1);
      pairs_tag_row_start <= bases_asked_frame_starts_is_equal_2;
      pairs_tag_first_group <= bases_asked_frame_starts_is_equal;
      pairs_tag_border_column <= ((raster_place_column mod 16) /= 15) and bases_address_0_is_equal;
      pairs_tag_first_cost <= pairs_tag_first_cost_is_equal;
      pairs_tag_leaves_window <= (((((raster_place_column / 4) + 16379) mod 16384) * 4) + (raster_place_column mod 4))
        < 65518;
      pairs_tag_output_column <= ((((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) <
        32) and (raster_place_column >= 15) and (raster_place_column < 63);
      pairs_tag_start_of_frame <= pairs_tag_first_cost_is_equal and (raster_place_group = 2);
      pairs_tag_end_of_line <= raster_place_column = 62;
      -- compared
      compared_rows_read_newest_0 <= to_integer(pairs_delayed_0);
      compared_rows_ready_words_0 <= to_integer(compared_rows_read_words_0);
      compared_rows_ready_words_1 <= to_integer(compared_rows_read_words_1);
      compared_rows_ready_words_2 <= to_integer(compared_rows_read_words_2);
      compared_rows_ready_newest_0 <= compared_rows_read_newest_0;
      compared_read_inside_0 <= pairs_row_inside_0;
      compared_read_inside_1 <= pairs_row_inside_1;
      compared_read_tag_row_start <= pairs_tag_row_start;
      compared_read_tag_first_group <= pairs_tag_first_group;
      compared_read_tag_border_column <= pairs_tag_border_column;
      compared_read_tag_first_cost <= pairs_tag_first_cost;
      compared_read_tag_leaves_window <= pairs_tag_leaves_window;
      compared_read_tag_output_column <= pairs_tag_output_column;
      compared_read_tag_start_of_frame <= pairs_tag_start_of_frame;
      compared_read_tag_end_of_line <= pairs_tag_end_of_line;
      compared_ready_inside_0 <= compared_read_inside_0;
      compared_ready_inside_1 <= compared_read_inside_1;
      compared_ready_tag_row_start <= compared_read_tag_row_start;
      compared_ready_tag_first_group <= compared_read_tag_first_group;
      compared_ready_tag_border_column <= compared_read_tag_border_column;
      compared_ready_tag_first_cost <= compared_read_tag_first_cost;
      compared_ready_tag_leaves_window <= compared_read_tag_leaves_window;
      compared_ready_tag_output_column <= compared_read_tag_output_column;
      compared_ready_tag_start_of_frame <= compared_read_tag_start_of_frame;
      compared_ready_tag_end_of_line <= compared_read_tag_end_of_line;
      compared_write_column <= bases_ready_column;
      compared_held_0_inside_0 <= compared_ready_inside_0;
      compared_held_0_inside_1 <= compared_ready_inside_1;
      compared_held_1_reference_0 <= compared_held_0_reference_0;
      compared_held_1_reference_1 <= compared_held_0_reference_1;
      compared_held_1_inside_0 <= compared_held_0_inside_0;
      compared_held_1_inside_1 <= compared_held_0_inside_1;
      compared_held_2_reference_0 <= compared_held_1_reference_0;
      compared_held_2_reference_1 <= compared_held_1_reference_1;
      compared_held_2_inside_0 <= compared_held_1_inside_0;
      compared_held_2_inside_1 <= compared_held_1_inside_1;
      compared_held_3_reference_0 <= compared_held_2_reference_0;
      compared_held_3_reference_1 <= compared_held_2_reference_1;
      compared_held_3_inside_0 <= compared_held_2_inside_0;
      compared_held_3_inside_1 <= compared_held_2_inside_1;
      compared_held_4_reference_0 <= compared_held_3_reference_0;
      compared_held_4_reference_1 <= compared_held_3_reference_1;
      compared_held_4_inside_0 <= compared_held_3_inside_0;
      compared_held_4_inside_1 <= compared_held_3_inside_1;
      compared_held_5_reference_0 <= compared_held_4_reference_0;
      compared_held_5_reference_1 <= compared_held_4_reference_1;
      compared_held_5_inside_0 <= compared_held_4_inside_0;
      compared_held_5_inside_1 <= compared_held_4_inside_1;
      compared_held_6_reference_0 <= compared_held_5_reference_0;
      compared_held_6_reference_1 <= compared_held_5_reference_1;
      compared_held_6_inside_0 <= compared_held_5_inside_0;
      compared_held_6_inside_1 <= compared_held_5_inside_1;
      compared_held_7_reference_0 <= compared_held_6_reference_0;
      compared_held_7_reference_1 <= compared_held_6_reference_1;
      compared_held_7_inside_0 <= compared_held_6_inside_0;
      compared_held_7_inside_1 <= compared_held_6_inside_1;
      compared_tags_0_row_start <= compared_ready_tag_row_start;
      compared_tags_0_first_group <= compared_ready_tag_first_group;
      compared_tags_0_border_column <= compared_ready_tag_border_column;
      compared_tags_0_first_cost <= compared_ready_tag_first_cost;
      compared_tags_0_leaves_window <= compared_ready_tag_leaves_window;
      compared_tags_0_output_column <= compared_ready_tag_output_column;
      compared_tags_0_start_of_frame <= compared_ready_tag_start_of_frame;
      compared_tags_0_end_of_line <= compared_ready_tag_end_of_line;
      compared_tags_1_row_start <= compared_tags_0_row_start;
      compared_tags_1_first_group <= compared_tags_0_first_group;
      compared_tags_1_border_column <= compared_tags_0_border_column;
      compared_tags_1_first_cost <= compared_tags_0_first_cost;
      compared_tags_1_leaves_window <= compared_tags_0_leaves_window;
      compared_tags_1_output_column <= compared_tags_0_output_column;
      compared_tags_1_start_of_frame <= compared_tags_0_start_of_frame;
      compared_tags_1_end_of_line <= compared_tags_0_end_of_line;
      compared_tags_2_valid <= bases_stands_valid;
      compared_tags_2_row_start <= compared_tags_1_row_start;
      compared_tags_2_first_group <= compared_tags_1_first_group;
      compared_tags_2_border_column <= compared_tags_1_border_column;
      compared_tags_2_first_cost <= compared_tags_1_first_cost;
      compared_tags_2_leaves_window <= compared_tags_1_leaves_window;
      compared_tags_2_output_column <= compared_tags_1_output_column;
      compared_tags_2_start_of_frame <= compared_tags_1_start_of_frame;
      compared_tags_2_end_of_line <= compared_tags_1_end_of_line;
      compared_tags_3_valid <= compared_tags_2_valid;
      compared_tags_3_row_start <= compared_tags_2_row_start;
      compared_tags_3_first_group <= compared_tags_2_first_group;
      compared_tags_3_border_column <= compared_tags_2_border_column;
      compared_tags_3_first_cost <= compared_tags_2_first_cost;
      compared_tags_3_leaves_window <= compared_tags_2_leaves_window;
      compared_tags_3_output_column <= compared_tags_2_output_column;
      compared_tags_3_start_of_frame <= compared_tags_2_start_of_frame;
      compared_tags_3_end_of_line <= compared_tags_2_end_of_line;
      compared_tags_4_valid <= compared_tags_3_valid;
      compared_tags_4_row_start <= compared_tags_3_row_start;
      compared_tags_4_first_group <= compared_tags_3_first_group;
      compared_tags_4_border_column <= compared_tags_3_border_column;
      compared_tags_4_first_cost <= compared_tags_3_first_cost;
      compared_tags_4_leaves_window <= compared_tags_3_leaves_window;
      compared_tags_4_output_column <= compared_tags_3_output_column;
      compared_tags_4_start_of_frame <= compared_tags_3_start_of_frame;
      compared_tags_4_end_of_line <= compared_tags_3_end_of_line;
      compared_tags_5_valid <= compared_tags_4_valid;
      compared_tags_5_row_start <= compared_tags_4_row_start;
      compared_tags_5_first_group <= compared_tags_4_first_group;
      compared_tags_5_border_column <= compared_tags_4_border_column;
      compared_tags_5_first_cost <= compared_tags_4_first_cost;
      compared_tags_5_leaves_window <= compared_tags_4_leaves_window;
      compared_tags_5_output_column <= compared_tags_4_output_column;
      compared_tags_5_start_of_frame <= compared_tags_4_start_of_frame;
      compared_tags_5_end_of_line <= compared_tags_4_end_of_line;
      compared_tags_6_valid <= compared_tags_5_valid;
      compared_tags_6_row_start <= compared_tags_5_row_start;
      compared_tags_6_first_group <= compared_tags_5_first_group;
      compared_tags_6_border_column <= compared_tags_5_border_column;
      compared_tags_6_first_cost <= compared_tags_5_first_cost;
      compared_tags_6_leaves_window <= compared_tags_5_leaves_window;
      compared_tags_6_output_column <= compared_tags_5_output_column;
      compared_tags_6_start_of_frame <= compared_tags_5_start_of_frame;
      compared_tags_6_end_of_line <= compared_tags_5_end_of_line;
      compared_tags_7_valid <= compared_tags_6_valid;
      compared_tags_7_row_start <= compared_tags_6_row_start;
      compared_tags_7_first_group <= compared_tags_6_first_group;
      compared_tags_7_border_column <= compared_tags_6_border_column;
      compared_tags_7_first_cost <= compared_tags_6_first_cost;
      compared_tags_7_leaves_window <= compared_tags_6_leaves_window;
      compared_tags_7_output_column <= compared_tags_6_output_column;
      compared_tags_7_start_of_frame <= compared_tags_6_start_of_frame;
      compared_tags_7_end_of_line <= compared_tags_6_end_of_line;
      if compared_ready_inside_0 then
        compared_held_0_reference_0 <= compared_rows_ready_words_0 mod 4096;
      else
        compared_held_0_reference_0 <= 0;
      end if;
      if compared_ready_inside_1 then
        compared_held_0_reference_1 <= compared_rows_ready_newest_0;
      else
        compared_held_0_reference_1 <= 0;
      end if;
      if bases_ready_valid then
        compared_rows_write_words_0 <= (compared_rows_ready_words_0 / 4096) + ((compared_rows_ready_words_1 mod 4096) *
          4096);
        compared_rows_write_words_1 <= (compared_rows_ready_words_1 / 4096) + (compared_rows_ready_words_2 * 4096);
        compared_rows_write_words_2 <= compared_rows_ready_newest_0;
      end if;
      -- lowchain
      lowchain_lane_0_0_all := compared_tags_6_valid and (rows_step_one_0_0 or rows_step_four_0_0);
      if lowchain_lane_0_0_all then
        if rows_step_four_0_0 then
          lowchain_lane_0_0 <= lowchain_lane_0_4;
          lowchain_lane_0_1 <= lowchain_lane_0_5;
          lowchain_lane_0_2 <= lowchain_lane_0_6;
          lowchain_lane_0_3 <= lowchain_lane_0_7;
          lowchain_lane_0_4 <= lowchain_lane_0_8;
          lowchain_lane_0_5 <= lowchain_lane_0_9;
          lowchain_lane_0_6 <= lowchain_lane_0_10;
          lowchain_lane_0_7 <= lowchain_lane_0_11;
          lowchain_lane_0_8 <= lowchain_lane_0_12;
          lowchain_lane_0_9 <= lowchain_lane_0_13;
          lowchain_lane_0_10 <= lowchain_lane_0_14;
          lowchain_lane_0_11 <= lowchain_lane_0_15;
          lowchain_lane_0_12 <= rows_codes_0_0_0;
          lowchain_lane_0_13 <= rows_codes_0_0_1;
          lowchain_lane_0_14 <= rows_codes_0_0_2;
          lowchain_lane_0_15 <= rows_codes_0_0_3;
        else
          lowchain_lane_0_0 <= lowchain_lane_0_1;
          lowchain_lane_0_1 <= lowchain_lane_0_2;
          lowchain_lane_0_2 <= lowchain_lane_0_3;
          lowchain_lane_0_3 <= lowchain_lane_0_4;
          lowchain_lane_0_4 <= lowchain_lane_0_5;
          lowchain_lane_0_5 <= lowchain_lane_0_6;
          lowchain_lane_0_6 <= lowchain_lane_0_7;
          lowchain_lane_0_7 <= lowchain_lane_0_8;
          lowchain_lane_0_8 <= lowchain_lane_0_9;
          lowchain_lane_0_9 <= lowchain_lane_0_10;
          lowchain_lane_0_10 <= lowchain_lane_0_11;
          lowchain_lane_0_11 <= lowchain_lane_0_12;
          lowchain_lane_0_12 <= lowchain_lane_0_13;
          lowchain_lane_0_13 <= lowchain_lane_0_14;
          lowchain_lane_0_14 <= lowchain_lane_0_15;
          lowchain_lane_0_15 <= rows_codes_0_0_0;
        end if;
      end if;
      if rows_step_one_0_1 then
        lowchain_lane_1_0_choice := compared_tags_6_valid;
      else
        lowchain_lane_1_0_choice := rows_step_four_0_1 and compared_tags_6_valid;
      end if;
      if lowchain_lane_1_0_choice then
        if rows_step_four_0_1 then
          lowchain_lane_1_0 <= lowchain_lane_1_4;
          lowchain_lane_1_1 <= lowchain_lane_1_5;
          lowchain_lane_1_2 <= lowchain_lane_1_6;
          lowchain_lane_1_3 <= lowchain_lane_1_7;
          lowchain_lane_1_4 <= lowchain_lane_1_8;
          lowchain_lane_1_5 <= lowchain_lane_1_9;
          lowchain_lane_1_6 <= lowchain_lane_1_10;
          lowchain_lane_1_7 <= lowchain_lane_1_11;
          lowchain_lane_1_8 <= lowchain_lane_1_12;
          lowchain_lane_1_9 <= lowchain_lane_1_13;
          lowchain_lane_1_10 <= lowchain_lane_1_14;
          lowchain_lane_1_11 <= lowchain_lane_1_15;
          lowchain_lane_1_12 <= rows_codes_0_1_0;
          lowchain_lane_1_13 <= rows_codes_0_1_1;
          lowchain_lane_1_14 <= rows_codes_0_1_2;
          lowchain_lane_1_15 <= rows_codes_0_1_3;
        else
          lowchain_lane_1_0 <= lowchain_lane_1_1;
          lowchain_lane_1_1 <= lowchain_lane_1_2;
          lowchain_lane_1_2 <= lowchain_lane_1_3;
          lowchain_lane_1_3 <= lowchain_lane_1_4;
          lowchain_lane_1_4 <= lowchain_lane_1_5;
          lowchain_lane_1_5 <= lowchain_lane_1_6;
          lowchain_lane_1_6 <= lowchain_lane_1_7;
          lowchain_lane_1_7 <= lowchain_lane_1_8;
          lowchain_lane_1_8 <= lowchain_lane_1_9;
          lowchain_lane_1_9 <= lowchain_lane_1_10;
          lowchain_lane_1_10 <= lowchain_lane_1_11;
          lowchain_lane_1_11 <= lowchain_lane_1_12;
          lowchain_lane_1_12 <= lowchain_lane_1_13;
          lowchain_lane_1_13 <= lowchain_lane_1_14;
          lowchain_lane_1_14 <= lowchain_lane_1_15;
          lowchain_lane_1_15 <= rows_codes_0_1_0;
        end if;
      end if;
      -- lowcost
      lowcost_pixels_first_0_0_value := ((compared_held_7_reference_0 / 8) mod 2) = 1;
      lowcost_pixels_first_0_0_value_2 := ((lowchain_lane_1_0 / 8) mod 2) = 1;
      if lowcost_pixels_first_0_0_value then
        lowcost_pixels_first_0_0_choice := (not lowcost_pixels_first_0_0_value_2) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice := lowcost_pixels_first_0_0_value_2 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_3 := ((compared_held_7_reference_0 / 32) mod 2) = 1;
      lowcost_pixels_first_0_0_value_4 := ((lowchain_lane_1_0 / 32) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_3 then
        lowcost_pixels_first_0_0_choice_2 := (not lowcost_pixels_first_0_0_value_4) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_2 := lowcost_pixels_first_0_0_value_4 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_5 := ((compared_held_7_reference_0 / 16) mod 2) = 1;
      lowcost_pixels_first_0_0_value_6 := ((lowchain_lane_1_0 / 16) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_5 then
        lowcost_pixels_first_0_0_choice_3 := (not lowcost_pixels_first_0_0_value_6) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_3 := lowcost_pixels_first_0_0_value_6 and compared_held_7_inside_0;
      end if;
      if (compared_held_7_reference_0 mod 2) = 1 then
        lowcost_pixels_first_0_0_choice_4 := (not ((lowchain_lane_1_0 mod 2) = 1)) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_4 := ((lowchain_lane_1_0 mod 2) = 1) and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_7 := ((compared_held_7_reference_0 / 4) mod 2) = 1;
      lowcost_pixels_first_0_0_value_8 := ((lowchain_lane_1_0 / 4) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_7 then
        lowcost_pixels_first_0_0_choice_5 := (not lowcost_pixels_first_0_0_value_8) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_5 := lowcost_pixels_first_0_0_value_8 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_9 := ((compared_held_7_reference_0 / 2) mod 2) = 1;
      lowcost_pixels_first_0_0_value_10 := ((lowchain_lane_1_0 / 2) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_9 then
        lowcost_pixels_first_0_0_choice_6 := (not lowcost_pixels_first_0_0_value_10) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_6 := lowcost_pixels_first_0_0_value_10 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_11 := ((compared_held_7_reference_0 / 64) mod 2) = 1;
      lowcost_pixels_first_0_0_value_12 := ((lowchain_lane_1_0 / 64) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_11 then
        lowcost_pixels_first_0_0_choice_7 := (not lowcost_pixels_first_0_0_value_12) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_7 := lowcost_pixels_first_0_0_value_12 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_13 := ((compared_held_7_reference_0 / 256) mod 2) = 1;
      lowcost_pixels_first_0_0_value_14 := ((lowchain_lane_1_0 / 256) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_13 then
        lowcost_pixels_first_0_0_choice_8 := (not lowcost_pixels_first_0_0_value_14) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_8 := lowcost_pixels_first_0_0_value_14 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_15 := ((compared_held_7_reference_0 / 128) mod 2) = 1;
      lowcost_pixels_first_0_0_value_16 := ((lowchain_lane_1_0 / 128) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_15 then
        lowcost_pixels_first_0_0_choice_9 := (not lowcost_pixels_first_0_0_value_16) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_9 := lowcost_pixels_first_0_0_value_16 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_17 := ((compared_held_7_reference_0 / 512) mod 2) = 1;
      lowcost_pixels_first_0_0_value_18 := ((lowchain_lane_1_0 / 512) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_17 then
        lowcost_pixels_first_0_0_choice_10 := (not lowcost_pixels_first_0_0_value_18) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_10 := lowcost_pixels_first_0_0_value_18 and compared_held_7_inside_0;
      end if;
      if (compared_held_7_reference_0 / 2048) = 1 then
        lowcost_pixels_first_0_0_choice_11 := (not ((lowchain_lane_1_0 / 2048) = 1)) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_11 := ((lowchain_lane_1_0 / 2048) = 1) and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_0_value_19 := ((compared_held_7_reference_0 / 1024) mod 2) = 1;
      lowcost_pixels_first_0_0_value_20 := ((lowchain_lane_1_0 / 1024) mod 2) = 1;
      if lowcost_pixels_first_0_0_value_19 then
        lowcost_pixels_first_0_0_choice_12 := (not lowcost_pixels_first_0_0_value_20) or (not compared_held_7_inside_0);
      else
        lowcost_pixels_first_0_0_choice_12 := lowcost_pixels_first_0_0_value_20 and compared_held_7_inside_0;
      end if;
      lowcost_pixels_first_0_1_differs := lowcost_pixels_first_0_0_value /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_1_choice := lowcost_pixels_first_0_0_value;
      end if;
      lowcost_pixels_first_0_1_differs_2 := lowcost_pixels_first_0_0_value_3 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_1_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      lowcost_pixels_first_0_1_differs_3 := lowcost_pixels_first_0_0_value_5 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_1_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      lowcost_pixels_first_0_1_differs_4 := ((compared_held_7_reference_0 mod 2) = 1) /= compared_held_7_inside_0;
      if (lowchain_lane_1_1 mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_1_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      lowcost_pixels_first_0_1_differs_5 := lowcost_pixels_first_0_0_value_7 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_1_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      lowcost_pixels_first_0_1_differs_6 := lowcost_pixels_first_0_0_value_9 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_1_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      lowcost_pixels_first_0_1_differs_7 := lowcost_pixels_first_0_0_value_11 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_1_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      lowcost_pixels_first_0_1_differs_8 := lowcost_pixels_first_0_0_value_13 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_1_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      lowcost_pixels_first_0_1_differs_9 := lowcost_pixels_first_0_0_value_15 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_1_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      lowcost_pixels_first_0_1_differs_10 := lowcost_pixels_first_0_0_value_17 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_1_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      lowcost_pixels_first_0_1_differs_11 := ((compared_held_7_reference_0 / 2048) = 1) /= compared_held_7_inside_0;
      if (lowchain_lane_1_1 / 2048) = 1 then
        lowcost_pixels_first_0_1_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_1_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      lowcost_pixels_first_0_1_differs_12 := lowcost_pixels_first_0_0_value_19 /= compared_held_7_inside_0;
      if ((lowchain_lane_1_1 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_1_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_1_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_2 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_2_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_2 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_2_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_2 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_2_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_2 mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_2_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_2 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_2_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_2 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_2_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_2 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_2_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_2 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_2_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_2 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_2_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_2 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_2_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_2 / 2048) = 1 then
        lowcost_pixels_first_0_2_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_2_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_2 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_2_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_2_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_3 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_3_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_3 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_3_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_3 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_3_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_3 mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_3_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_3 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_3_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_3 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_3_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_3 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_3_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_3 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_3_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_3 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_3_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_3 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_3_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_3 / 2048) = 1 then
        lowcost_pixels_first_0_3_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_3_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_3 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_3_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_3_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_4 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_4_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_4 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_4_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_4 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_4_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_4 mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_4_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_4 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_4_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_4 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_4_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_4 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_4_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_4 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_4_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_4 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_4_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_4 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_4_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_4 / 2048) = 1 then
        lowcost_pixels_first_0_4_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_4_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_4 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_4_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_4_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_5 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_5_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_5 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_5_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_5 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_5_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_5 mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_5_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_5 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_5_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_5 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_5_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_5 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_5_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_5 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_5_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_5 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_5_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_5 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_5_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_5 / 2048) = 1 then
        lowcost_pixels_first_0_5_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_5_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_5 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_5_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_5_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_6 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_6_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_6 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_6_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_6 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_6_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_6 mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_6_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_6 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_6_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_6 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_6_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_6 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_6_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_6 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_6_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_6 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_6_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_6 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_6_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_6 / 2048) = 1 then
        lowcost_pixels_first_0_6_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_6_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_6 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_6_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_6_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_7 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_7_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_7 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_7_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_7 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_7_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_7 mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_7_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_7 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_7_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_7 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_7_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_7 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_7_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_7 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_7_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_7 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_7_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_7 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_7_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_7 / 2048) = 1 then
        lowcost_pixels_first_0_7_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_7_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_7 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_7_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_7_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_8 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_8_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_8 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_8_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_8 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_8_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_8 mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_8_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_8 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_8_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_8 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_8_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_8 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_8_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_8 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_8_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_8 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_8_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_8 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_8_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_8 / 2048) = 1 then
        lowcost_pixels_first_0_8_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_8_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_8 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_8_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_8_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_9 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_9_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_9 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_9_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_9 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_9_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_9 mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_9_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_9 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_9_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_9 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_9_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_9 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_9_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_9 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_9_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_9 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_9_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_9 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_9_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_9 / 2048) = 1 then
        lowcost_pixels_first_0_9_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_9_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_9 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_9_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_9_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_10 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_10_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_10 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_10_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_10 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_10_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_10 mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_10_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_10 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_10_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_10 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_10_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_10 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_10_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_10 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_10_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_10 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_10_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_10 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_10_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_10 / 2048) = 1 then
        lowcost_pixels_first_0_10_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_10_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_10 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_10_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_10_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_11 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_11_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_11 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_11_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_11 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_11_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_11 mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_11_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_11 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_11_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_11 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_11_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_11 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_11_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_11 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_11_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_11 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_11_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_11 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_11_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_11 / 2048) = 1 then
        lowcost_pixels_first_0_11_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_11_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_11 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_11_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_11_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_12 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_12_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_12 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_12_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_12 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_12_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_12 mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_12_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_12 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_12_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_12 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_12_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_12 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_12_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_12 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_12_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_12 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_12_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_12 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_12_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_12 / 2048) = 1 then
        lowcost_pixels_first_0_12_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_12_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_12 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_12_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_12_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_13 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_13_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_13 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_13_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_13 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_13_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_13 mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_13_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_13 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_13_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_13 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_13_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_13 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_13_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_13 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_13_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_13 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_13_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_13 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_13_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_13 / 2048) = 1 then
        lowcost_pixels_first_0_13_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_13_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_13 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_13_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_13_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_14 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_14_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_14 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_14_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_14 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_14_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_14 mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_14_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_14 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_14_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_14 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_14_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_14 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_14_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_14 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_14_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_14 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_14_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_14 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_14_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_14 / 2048) = 1 then
        lowcost_pixels_first_0_14_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_14_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_14 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_14_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_14_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((lowchain_lane_1_15 / 8) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice := lowcost_pixels_first_0_1_differs;
      else
        lowcost_pixels_first_0_15_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((lowchain_lane_1_15 / 32) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        lowcost_pixels_first_0_15_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((lowchain_lane_1_15 / 16) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        lowcost_pixels_first_0_15_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (lowchain_lane_1_15 mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        lowcost_pixels_first_0_15_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((lowchain_lane_1_15 / 4) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        lowcost_pixels_first_0_15_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((lowchain_lane_1_15 / 2) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        lowcost_pixels_first_0_15_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((lowchain_lane_1_15 / 64) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        lowcost_pixels_first_0_15_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((lowchain_lane_1_15 / 256) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        lowcost_pixels_first_0_15_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((lowchain_lane_1_15 / 128) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        lowcost_pixels_first_0_15_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((lowchain_lane_1_15 / 512) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        lowcost_pixels_first_0_15_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (lowchain_lane_1_15 / 2048) = 1 then
        lowcost_pixels_first_0_15_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        lowcost_pixels_first_0_15_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((lowchain_lane_1_15 / 1024) mod 2) = 1 then
        lowcost_pixels_first_0_15_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        lowcost_pixels_first_0_15_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      lowcost_pixels_first_1_0_value := ((compared_held_7_reference_1 / 8) mod 2) = 1;
      lowcost_pixels_first_1_0_value_2 := ((lowchain_lane_0_0 / 8) mod 2) = 1;
      if lowcost_pixels_first_1_0_value then
        lowcost_pixels_first_1_0_choice := (not lowcost_pixels_first_1_0_value_2) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice := lowcost_pixels_first_1_0_value_2 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_3 := ((compared_held_7_reference_1 / 32) mod 2) = 1;
      lowcost_pixels_first_1_0_value_4 := ((lowchain_lane_0_0 / 32) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_3 then
        lowcost_pixels_first_1_0_choice_2 := (not lowcost_pixels_first_1_0_value_4) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_2 := lowcost_pixels_first_1_0_value_4 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_5 := ((compared_held_7_reference_1 / 16) mod 2) = 1;
      lowcost_pixels_first_1_0_value_6 := ((lowchain_lane_0_0 / 16) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_5 then
        lowcost_pixels_first_1_0_choice_3 := (not lowcost_pixels_first_1_0_value_6) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_3 := lowcost_pixels_first_1_0_value_6 and compared_held_7_inside_1;
      end if;
      if (compared_held_7_reference_1 mod 2) = 1 then
        lowcost_pixels_first_1_0_choice_4 := (not ((lowchain_lane_0_0 mod 2) = 1)) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_4 := ((lowchain_lane_0_0 mod 2) = 1) and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_7 := ((compared_held_7_reference_1 / 4) mod 2) = 1;
      lowcost_pixels_first_1_0_value_8 := ((lowchain_lane_0_0 / 4) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_7 then
        lowcost_pixels_first_1_0_choice_5 := (not lowcost_pixels_first_1_0_value_8) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_5 := lowcost_pixels_first_1_0_value_8 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_9 := ((compared_held_7_reference_1 / 2) mod 2) = 1;
      lowcost_pixels_first_1_0_value_10 := ((lowchain_lane_0_0 / 2) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_9 then
        lowcost_pixels_first_1_0_choice_6 := (not lowcost_pixels_first_1_0_value_10) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_6 := lowcost_pixels_first_1_0_value_10 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_11 := ((compared_held_7_reference_1 / 64) mod 2) = 1;
      lowcost_pixels_first_1_0_value_12 := ((lowchain_lane_0_0 / 64) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_11 then
        lowcost_pixels_first_1_0_choice_7 := (not lowcost_pixels_first_1_0_value_12) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_7 := lowcost_pixels_first_1_0_value_12 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_13 := ((compared_held_7_reference_1 / 256) mod 2) = 1;
      lowcost_pixels_first_1_0_value_14 := ((lowchain_lane_0_0 / 256) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_13 then
        lowcost_pixels_first_1_0_choice_8 := (not lowcost_pixels_first_1_0_value_14) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_8 := lowcost_pixels_first_1_0_value_14 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_15 := ((compared_held_7_reference_1 / 128) mod 2) = 1;
      lowcost_pixels_first_1_0_value_16 := ((lowchain_lane_0_0 / 128) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_15 then
        lowcost_pixels_first_1_0_choice_9 := (not lowcost_pixels_first_1_0_value_16) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_9 := lowcost_pixels_first_1_0_value_16 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_17 := ((compared_held_7_reference_1 / 512) mod 2) = 1;
      lowcost_pixels_first_1_0_value_18 := ((lowchain_lane_0_0 / 512) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_17 then
        lowcost_pixels_first_1_0_choice_10 := (not lowcost_pixels_first_1_0_value_18) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_10 := lowcost_pixels_first_1_0_value_18 and compared_held_7_inside_1;
      end if;
      if (compared_held_7_reference_1 / 2048) = 1 then
        lowcost_pixels_first_1_0_choice_11 := (not ((lowchain_lane_0_0 / 2048) = 1)) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_11 := ((lowchain_lane_0_0 / 2048) = 1) and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_0_value_19 := ((compared_held_7_reference_1 / 1024) mod 2) = 1;
      lowcost_pixels_first_1_0_value_20 := ((lowchain_lane_0_0 / 1024) mod 2) = 1;
      if lowcost_pixels_first_1_0_value_19 then
        lowcost_pixels_first_1_0_choice_12 := (not lowcost_pixels_first_1_0_value_20) or (not compared_held_7_inside_1);
      else
        lowcost_pixels_first_1_0_choice_12 := lowcost_pixels_first_1_0_value_20 and compared_held_7_inside_1;
      end if;
      lowcost_pixels_first_1_1_differs := lowcost_pixels_first_1_0_value /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_1_choice := lowcost_pixels_first_1_0_value;
      end if;
      lowcost_pixels_first_1_1_differs_2 := lowcost_pixels_first_1_0_value_3 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_1_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      lowcost_pixels_first_1_1_differs_3 := lowcost_pixels_first_1_0_value_5 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_1_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      lowcost_pixels_first_1_1_differs_4 := ((compared_held_7_reference_1 mod 2) = 1) /= compared_held_7_inside_1;
      if (lowchain_lane_0_1 mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_1_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      lowcost_pixels_first_1_1_differs_5 := lowcost_pixels_first_1_0_value_7 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_1_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      lowcost_pixels_first_1_1_differs_6 := lowcost_pixels_first_1_0_value_9 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_1_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      lowcost_pixels_first_1_1_differs_7 := lowcost_pixels_first_1_0_value_11 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_1_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      lowcost_pixels_first_1_1_differs_8 := lowcost_pixels_first_1_0_value_13 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_1_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      lowcost_pixels_first_1_1_differs_9 := lowcost_pixels_first_1_0_value_15 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_1_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      lowcost_pixels_first_1_1_differs_10 := lowcost_pixels_first_1_0_value_17 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_1_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      lowcost_pixels_first_1_1_differs_11 := ((compared_held_7_reference_1 / 2048) = 1) /= compared_held_7_inside_1;
      if (lowchain_lane_0_1 / 2048) = 1 then
        lowcost_pixels_first_1_1_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_1_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      lowcost_pixels_first_1_1_differs_12 := lowcost_pixels_first_1_0_value_19 /= compared_held_7_inside_1;
      if ((lowchain_lane_0_1 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_1_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_1_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_2 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_2_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_2 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_2_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_2 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_2_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_2 mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_2_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_2 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_2_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_2 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_2_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_2 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_2_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_2 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_2_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_2 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_2_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_2 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_2_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_2 / 2048) = 1 then
        lowcost_pixels_first_1_2_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_2_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_2 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_2_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_2_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_3 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_3_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_3 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_3_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_3 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_3_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_3 mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_3_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_3 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_3_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_3 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_3_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_3 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_3_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_3 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_3_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_3 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_3_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_3 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_3_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_3 / 2048) = 1 then
        lowcost_pixels_first_1_3_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_3_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_3 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_3_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_3_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_4 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_4_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_4 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_4_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_4 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_4_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_4 mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_4_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_4 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_4_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_4 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_4_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_4 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_4_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_4 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_4_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_4 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_4_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_4 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_4_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_4 / 2048) = 1 then
        lowcost_pixels_first_1_4_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_4_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_4 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_4_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_4_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_5 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_5_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_5 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_5_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_5 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_5_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_5 mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_5_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_5 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_5_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_5 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_5_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_5 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_5_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_5 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_5_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_5 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_5_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_5 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_5_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_5 / 2048) = 1 then
        lowcost_pixels_first_1_5_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_5_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_5 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_5_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_5_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_6 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_6_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_6 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_6_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_6 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_6_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_6 mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_6_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_6 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_6_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_6 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_6_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_6 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_6_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_6 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_6_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_6 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_6_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_6 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_6_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_6 / 2048) = 1 then
        lowcost_pixels_first_1_6_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_6_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_6 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_6_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_6_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_7 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_7_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_7 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_7_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_7 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_7_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_7 mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_7_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_7 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_7_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_7 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_7_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_7 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_7_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_7 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_7_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_7 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_7_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_7 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_7_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_7 / 2048) = 1 then
        lowcost_pixels_first_1_7_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_7_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_7 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_7_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_7_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_8 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_8_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_8 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_8_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_8 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_8_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_8 mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_8_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_8 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_8_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_8 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_8_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_8 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_8_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_8 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_8_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_8 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_8_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_8 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_8_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_8 / 2048) = 1 then
        lowcost_pixels_first_1_8_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_8_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_8 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_8_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_8_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_9 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_9_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_9 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_9_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_9 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_9_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_9 mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_9_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_9 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_9_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_9 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_9_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_9 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_9_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_9 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_9_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_9 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_9_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_9 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_9_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_9 / 2048) = 1 then
        lowcost_pixels_first_1_9_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_9_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_9 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_9_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_9_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_10 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_10_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_10 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_10_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_10 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_10_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_10 mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_10_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_10 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_10_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_10 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_10_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_10 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_10_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_10 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_10_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_10 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_10_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_10 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_10_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_10 / 2048) = 1 then
        lowcost_pixels_first_1_10_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_10_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_10 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_10_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_10_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_11 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_11_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_11 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_11_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_11 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_11_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_11 mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_11_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_11 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_11_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_11 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_11_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_11 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_11_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_11 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_11_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_11 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_11_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_11 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_11_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_11 / 2048) = 1 then
        lowcost_pixels_first_1_11_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_11_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_11 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_11_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_11_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_12 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_12_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_12 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_12_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_12 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_12_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_12 mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_12_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_12 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_12_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_12 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_12_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_12 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_12_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_12 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_12_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_12 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_12_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_12 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_12_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_12 / 2048) = 1 then
        lowcost_pixels_first_1_12_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_12_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_12 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_12_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_12_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_13 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_13_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_13 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_13_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_13 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_13_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_13 mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_13_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_13 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_13_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_13 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_13_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_13 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_13_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_13 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_13_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_13 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_13_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_13 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_13_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_13 / 2048) = 1 then
        lowcost_pixels_first_1_13_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_13_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_13 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_13_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_13_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_14 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_14_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_14 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_14_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_14 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_14_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_14 mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_14_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_14 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_14_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_14 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_14_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_14 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_14_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_14 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_14_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_14 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_14_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_14 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_14_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_14 / 2048) = 1 then
        lowcost_pixels_first_1_14_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_14_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_14 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_14_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_14_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((lowchain_lane_0_15 / 8) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice := lowcost_pixels_first_1_1_differs;
      else
        lowcost_pixels_first_1_15_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((lowchain_lane_0_15 / 32) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        lowcost_pixels_first_1_15_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((lowchain_lane_0_15 / 16) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        lowcost_pixels_first_1_15_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (lowchain_lane_0_15 mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        lowcost_pixels_first_1_15_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((lowchain_lane_0_15 / 4) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        lowcost_pixels_first_1_15_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((lowchain_lane_0_15 / 2) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        lowcost_pixels_first_1_15_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((lowchain_lane_0_15 / 64) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        lowcost_pixels_first_1_15_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((lowchain_lane_0_15 / 256) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        lowcost_pixels_first_1_15_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((lowchain_lane_0_15 / 128) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        lowcost_pixels_first_1_15_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((lowchain_lane_0_15 / 512) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        lowcost_pixels_first_1_15_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (lowchain_lane_0_15 / 2048) = 1 then
        lowcost_pixels_first_1_15_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        lowcost_pixels_first_1_15_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((lowchain_lane_0_15 / 1024) mod 2) = 1 then
        lowcost_pixels_first_1_15_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        lowcost_pixels_first_1_15_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_0_choice := 0;
      else
        lowcost_column_0_0_choice := lowcost_ready_words_0 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_0_choice_2 := 0;
      else
        lowcost_column_0_0_choice_2 := (lowcost_change_0_0 + lowcost_column_0_0_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_1_choice := 0;
      else
        lowcost_column_0_1_choice := (lowcost_ready_words_0 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_1_choice_2 := 0;
      else
        lowcost_column_0_1_choice_2 := (lowcost_change_0_1 + lowcost_column_0_1_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_2_choice := 0;
      else
        lowcost_column_0_2_choice := (lowcost_ready_words_0 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_2_choice_2 := 0;
      else
        lowcost_column_0_2_choice_2 := (lowcost_change_0_2 + lowcost_column_0_2_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_3_choice := 0;
      else
        lowcost_column_0_3_choice := lowcost_ready_words_0 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_3_choice_2 := 0;
      else
        lowcost_column_0_3_choice_2 := (lowcost_change_0_3 + lowcost_column_0_3_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_4_choice := 0;
      else
        lowcost_column_0_4_choice := lowcost_ready_words_1 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_4_choice_2 := 0;
      else
        lowcost_column_0_4_choice_2 := (lowcost_change_0_4 + lowcost_column_0_4_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_5_choice := 0;
      else
        lowcost_column_0_5_choice := (lowcost_ready_words_1 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_5_choice_2 := 0;
      else
        lowcost_column_0_5_choice_2 := (lowcost_change_0_5 + lowcost_column_0_5_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_6_choice := 0;
      else
        lowcost_column_0_6_choice := (lowcost_ready_words_1 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_6_choice_2 := 0;
      else
        lowcost_column_0_6_choice_2 := (lowcost_change_0_6 + lowcost_column_0_6_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_7_choice := 0;
      else
        lowcost_column_0_7_choice := lowcost_ready_words_1 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_7_choice_2 := 0;
      else
        lowcost_column_0_7_choice_2 := (lowcost_change_0_7 + lowcost_column_0_7_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_8_choice := 0;
      else
        lowcost_column_0_8_choice := lowcost_ready_words_2 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_8_choice_2 := 0;
      else
        lowcost_column_0_8_choice_2 := (lowcost_change_0_8 + lowcost_column_0_8_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_9_choice := 0;
      else
        lowcost_column_0_9_choice := (lowcost_ready_words_2 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_9_choice_2 := 0;
      else
        lowcost_column_0_9_choice_2 := (lowcost_change_0_9 + lowcost_column_0_9_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_10_choice := 0;
      else
        lowcost_column_0_10_choice := (lowcost_ready_words_2 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_10_choice_2 := 0;
      else
        lowcost_column_0_10_choice_2 := (lowcost_change_0_10 + lowcost_column_0_10_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_11_choice := 0;
      else
        lowcost_column_0_11_choice := lowcost_ready_words_2 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_11_choice_2 := 0;
      else
        lowcost_column_0_11_choice_2 := (lowcost_change_0_11 + lowcost_column_0_11_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_12_choice := 0;
      else
        lowcost_column_0_12_choice := lowcost_ready_words_3 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_12_choice_2 := 0;
      else
        lowcost_column_0_12_choice_2 := (lowcost_change_0_12 + lowcost_column_0_12_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_13_choice := 0;
      else
        lowcost_column_0_13_choice := (lowcost_ready_words_3 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_13_choice_2 := 0;
      else
        lowcost_column_0_13_choice_2 := (lowcost_change_0_13 + lowcost_column_0_13_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_14_choice := 0;
      else
        lowcost_column_0_14_choice := (lowcost_ready_words_3 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_14_choice_2 := 0;
      else
        lowcost_column_0_14_choice_2 := (lowcost_change_0_14 + lowcost_column_0_14_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        lowcost_column_0_15_choice := 0;
      else
        lowcost_column_0_15_choice := lowcost_ready_words_3 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        lowcost_column_0_15_choice_2 := 0;
      else
        lowcost_column_0_15_choice_2 := (lowcost_change_0_15 + lowcost_column_0_15_choice) mod 128;
      end if;
      lowcost_pixels_first_0_0 <= ((as_number(lowcost_pixels_first_0_0_choice) +
        as_number(lowcost_pixels_first_0_0_choice_2) + as_number(lowcost_pixels_first_0_0_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_0_choice_4) + as_number(lowcost_pixels_first_0_0_choice_5) +
        as_number(lowcost_pixels_first_0_0_choice_6) + ((as_number(lowcost_pixels_first_0_0_choice_7) +
        as_number(lowcost_pixels_first_0_0_choice_8) + as_number(lowcost_pixels_first_0_0_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_0_choice_10) + as_number(lowcost_pixels_first_0_0_choice_11) +
        as_number(lowcost_pixels_first_0_0_choice_12)) * 64);
      lowcost_pixels_first_0_1 <= ((as_number(lowcost_pixels_first_0_1_choice) +
        as_number(lowcost_pixels_first_0_1_choice_2) + as_number(lowcost_pixels_first_0_1_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_1_choice_4) + as_number(lowcost_pixels_first_0_1_choice_5) +
        as_number(lowcost_pixels_first_0_1_choice_6) + ((as_number(lowcost_pixels_first_0_1_choice_7) +
        as_number(lowcost_pixels_first_0_1_choice_8) + as_number(lowcost_pixels_first_0_1_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_1_choice_10) + as_number(lowcost_pixels_first_0_1_choice_11) +
        as_number(lowcost_pixels_first_0_1_choice_12)) * 64);
      lowcost_pixels_first_0_2 <= ((as_number(lowcost_pixels_first_0_2_choice) +
        as_number(lowcost_pixels_first_0_2_choice_2) + as_number(lowcost_pixels_first_0_2_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_2_choice_4) + as_number(lowcost_pixels_first_0_2_choice_5) +
        as_number(lowcost_pixels_first_0_2_choice_6) + ((as_number(lowcost_pixels_first_0_2_choice_7) +
        as_number(lowcost_pixels_first_0_2_choice_8) + as_number(lowcost_pixels_first_0_2_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_2_choice_10) + as_number(lowcost_pixels_first_0_2_choice_11) +
        as_number(lowcost_pixels_first_0_2_choice_12)) * 64);
      lowcost_pixels_first_0_3 <= ((as_number(lowcost_pixels_first_0_3_choice) +
        as_number(lowcost_pixels_first_0_3_choice_2) + as_number(lowcost_pixels_first_0_3_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_3_choice_4) + as_number(lowcost_pixels_first_0_3_choice_5) +
        as_number(lowcost_pixels_first_0_3_choice_6) + ((as_number(lowcost_pixels_first_0_3_choice_7) +
        as_number(lowcost_pixels_first_0_3_choice_8) + as_number(lowcost_pixels_first_0_3_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_3_choice_10) + as_number(lowcost_pixels_first_0_3_choice_11) +
        as_number(lowcost_pixels_first_0_3_choice_12)) * 64);
      lowcost_pixels_first_0_4 <= ((as_number(lowcost_pixels_first_0_4_choice) +
        as_number(lowcost_pixels_first_0_4_choice_2) + as_number(lowcost_pixels_first_0_4_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_4_choice_4) + as_number(lowcost_pixels_first_0_4_choice_5) +
        as_number(lowcost_pixels_first_0_4_choice_6) + ((as_number(lowcost_pixels_first_0_4_choice_7) +
        as_number(lowcost_pixels_first_0_4_choice_8) + as_number(lowcost_pixels_first_0_4_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_4_choice_10) + as_number(lowcost_pixels_first_0_4_choice_11) +
        as_number(lowcost_pixels_first_0_4_choice_12)) * 64);
      lowcost_pixels_first_0_5 <= ((as_number(lowcost_pixels_first_0_5_choice) +
        as_number(lowcost_pixels_first_0_5_choice_2) + as_number(lowcost_pixels_first_0_5_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_5_choice_4) + as_number(lowcost_pixels_first_0_5_choice_5) +
        as_number(lowcost_pixels_first_0_5_choice_6) + ((as_number(lowcost_pixels_first_0_5_choice_7) +
        as_number(lowcost_pixels_first_0_5_choice_8) + as_number(lowcost_pixels_first_0_5_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_5_choice_10) + as_number(lowcost_pixels_first_0_5_choice_11) +
        as_number(lowcost_pixels_first_0_5_choice_12)) * 64);
      lowcost_pixels_first_0_6 <= ((as_number(lowcost_pixels_first_0_6_choice) +
        as_number(lowcost_pixels_first_0_6_choice_2) + as_number(lowcost_pixels_first_0_6_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_6_choice_4) + as_number(lowcost_pixels_first_0_6_choice_5) +
        as_number(lowcost_pixels_first_0_6_choice_6) + ((as_number(lowcost_pixels_first_0_6_choice_7) +
        as_number(lowcost_pixels_first_0_6_choice_8) + as_number(lowcost_pixels_first_0_6_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_6_choice_10) + as_number(lowcost_pixels_first_0_6_choice_11) +
        as_number(lowcost_pixels_first_0_6_choice_12)) * 64);
      lowcost_pixels_first_0_7 <= ((as_number(lowcost_pixels_first_0_7_choice) +
        as_number(lowcost_pixels_first_0_7_choice_2) + as_number(lowcost_pixels_first_0_7_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_7_choice_4) + as_number(lowcost_pixels_first_0_7_choice_5) +
        as_number(lowcost_pixels_first_0_7_choice_6) + ((as_number(lowcost_pixels_first_0_7_choice_7) +
        as_number(lowcost_pixels_first_0_7_choice_8) + as_number(lowcost_pixels_first_0_7_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_7_choice_10) + as_number(lowcost_pixels_first_0_7_choice_11) +
        as_number(lowcost_pixels_first_0_7_choice_12)) * 64);
      lowcost_pixels_first_0_8 <= ((as_number(lowcost_pixels_first_0_8_choice) +
        as_number(lowcost_pixels_first_0_8_choice_2) + as_number(lowcost_pixels_first_0_8_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_8_choice_4) + as_number(lowcost_pixels_first_0_8_choice_5) +
        as_number(lowcost_pixels_first_0_8_choice_6) + ((as_number(lowcost_pixels_first_0_8_choice_7) +
        as_number(lowcost_pixels_first_0_8_choice_8) + as_number(lowcost_pixels_first_0_8_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_8_choice_10) + as_number(lowcost_pixels_first_0_8_choice_11) +
        as_number(lowcost_pixels_first_0_8_choice_12)) * 64);
      lowcost_pixels_first_0_9 <= ((as_number(lowcost_pixels_first_0_9_choice) +
        as_number(lowcost_pixels_first_0_9_choice_2) + as_number(lowcost_pixels_first_0_9_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_9_choice_4) + as_number(lowcost_pixels_first_0_9_choice_5) +
        as_number(lowcost_pixels_first_0_9_choice_6) + ((as_number(lowcost_pixels_first_0_9_choice_7) +
        as_number(lowcost_pixels_first_0_9_choice_8) + as_number(lowcost_pixels_first_0_9_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_9_choice_10) + as_number(lowcost_pixels_first_0_9_choice_11) +
        as_number(lowcost_pixels_first_0_9_choice_12)) * 64);
      lowcost_pixels_first_0_10 <= ((as_number(lowcost_pixels_first_0_10_choice) +
        as_number(lowcost_pixels_first_0_10_choice_2) + as_number(lowcost_pixels_first_0_10_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_10_choice_4) + as_number(lowcost_pixels_first_0_10_choice_5) +
        as_number(lowcost_pixels_first_0_10_choice_6) + ((as_number(lowcost_pixels_first_0_10_choice_7) +
        as_number(lowcost_pixels_first_0_10_choice_8) + as_number(lowcost_pixels_first_0_10_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_10_choice_10) + as_number(lowcost_pixels_first_0_10_choice_11) +
        as_number(lowcost_pixels_first_0_10_choice_12)) * 64);
      lowcost_pixels_first_0_11 <= ((as_number(lowcost_pixels_first_0_11_choice) +
        as_number(lowcost_pixels_first_0_11_choice_2) + as_number(lowcost_pixels_first_0_11_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_11_choice_4) + as_number(lowcost_pixels_first_0_11_choice_5) +
        as_number(lowcost_pixels_first_0_11_choice_6) + ((as_number(lowcost_pixels_first_0_11_choice_7) +
        as_number(lowcost_pixels_first_0_11_choice_8) + as_number(lowcost_pixels_first_0_11_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_11_choice_10) + as_number(lowcost_pixels_first_0_11_choice_11) +
        as_number(lowcost_pixels_first_0_11_choice_12)) * 64);
      lowcost_pixels_first_0_12 <= ((as_number(lowcost_pixels_first_0_12_choice) +
        as_number(lowcost_pixels_first_0_12_choice_2) + as_number(lowcost_pixels_first_0_12_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_12_choice_4) + as_number(lowcost_pixels_first_0_12_choice_5) +
        as_number(lowcost_pixels_first_0_12_choice_6) + ((as_number(lowcost_pixels_first_0_12_choice_7) +
        as_number(lowcost_pixels_first_0_12_choice_8) + as_number(lowcost_pixels_first_0_12_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_12_choice_10) + as_number(lowcost_pixels_first_0_12_choice_11) +
        as_number(lowcost_pixels_first_0_12_choice_12)) * 64);
      lowcost_pixels_first_0_13 <= ((as_number(lowcost_pixels_first_0_13_choice) +
        as_number(lowcost_pixels_first_0_13_choice_2) + as_number(lowcost_pixels_first_0_13_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_13_choice_4) + as_number(lowcost_pixels_first_0_13_choice_5) +
        as_number(lowcost_pixels_first_0_13_choice_6) + ((as_number(lowcost_pixels_first_0_13_choice_7) +
        as_number(lowcost_pixels_first_0_13_choice_8) + as_number(lowcost_pixels_first_0_13_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_13_choice_10) + as_number(lowcost_pixels_first_0_13_choice_11) +
        as_number(lowcost_pixels_first_0_13_choice_12)) * 64);
      lowcost_pixels_first_0_14 <= ((as_number(lowcost_pixels_first_0_14_choice) +
        as_number(lowcost_pixels_first_0_14_choice_2) + as_number(lowcost_pixels_first_0_14_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_14_choice_4) + as_number(lowcost_pixels_first_0_14_choice_5) +
        as_number(lowcost_pixels_first_0_14_choice_6) + ((as_number(lowcost_pixels_first_0_14_choice_7) +
        as_number(lowcost_pixels_first_0_14_choice_8) + as_number(lowcost_pixels_first_0_14_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_14_choice_10) + as_number(lowcost_pixels_first_0_14_choice_11) +
        as_number(lowcost_pixels_first_0_14_choice_12)) * 64);
      lowcost_pixels_first_0_15 <= ((as_number(lowcost_pixels_first_0_15_choice) +
        as_number(lowcost_pixels_first_0_15_choice_2) + as_number(lowcost_pixels_first_0_15_choice_3)) * 4) +
        as_number(lowcost_pixels_first_0_15_choice_4) + as_number(lowcost_pixels_first_0_15_choice_5) +
        as_number(lowcost_pixels_first_0_15_choice_6) + ((as_number(lowcost_pixels_first_0_15_choice_7) +
        as_number(lowcost_pixels_first_0_15_choice_8) + as_number(lowcost_pixels_first_0_15_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_0_15_choice_10) + as_number(lowcost_pixels_first_0_15_choice_11) +
        as_number(lowcost_pixels_first_0_15_choice_12)) * 64);
      lowcost_pixels_first_1_0 <= ((as_number(lowcost_pixels_first_1_0_choice) +
        as_number(lowcost_pixels_first_1_0_choice_2) + as_number(lowcost_pixels_first_1_0_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_0_choice_4) + as_number(lowcost_pixels_first_1_0_choice_5) +
        as_number(lowcost_pixels_first_1_0_choice_6) + ((as_number(lowcost_pixels_first_1_0_choice_7) +
        as_number(lowcost_pixels_first_1_0_choice_8) + as_number(lowcost_pixels_first_1_0_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_0_choice_10) + as_number(lowcost_pixels_first_1_0_choice_11) +
        as_number(lowcost_pixels_first_1_0_choice_12)) * 64);
      lowcost_pixels_first_1_1 <= ((as_number(lowcost_pixels_first_1_1_choice) +
        as_number(lowcost_pixels_first_1_1_choice_2) + as_number(lowcost_pixels_first_1_1_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_1_choice_4) + as_number(lowcost_pixels_first_1_1_choice_5) +
        as_number(lowcost_pixels_first_1_1_choice_6) + ((as_number(lowcost_pixels_first_1_1_choice_7) +
        as_number(lowcost_pixels_first_1_1_choice_8) + as_number(lowcost_pixels_first_1_1_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_1_choice_10) + as_number(lowcost_pixels_first_1_1_choice_11) +
        as_number(lowcost_pixels_first_1_1_choice_12)) * 64);
      lowcost_pixels_first_1_2 <= ((as_number(lowcost_pixels_first_1_2_choice) +
        as_number(lowcost_pixels_first_1_2_choice_2) + as_number(lowcost_pixels_first_1_2_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_2_choice_4) + as_number(lowcost_pixels_first_1_2_choice_5) +
        as_number(lowcost_pixels_first_1_2_choice_6) + ((as_number(lowcost_pixels_first_1_2_choice_7) +
        as_number(lowcost_pixels_first_1_2_choice_8) + as_number(lowcost_pixels_first_1_2_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_2_choice_10) + as_number(lowcost_pixels_first_1_2_choice_11) +
        as_number(lowcost_pixels_first_1_2_choice_12)) * 64);
      lowcost_pixels_first_1_3 <= ((as_number(lowcost_pixels_first_1_3_choice) +
        as_number(lowcost_pixels_first_1_3_choice_2) + as_number(lowcost_pixels_first_1_3_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_3_choice_4) + as_number(lowcost_pixels_first_1_3_choice_5) +
        as_number(lowcost_pixels_first_1_3_choice_6) + ((as_number(lowcost_pixels_first_1_3_choice_7) +
        as_number(lowcost_pixels_first_1_3_choice_8) + as_number(lowcost_pixels_first_1_3_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_3_choice_10) + as_number(lowcost_pixels_first_1_3_choice_11) +
        as_number(lowcost_pixels_first_1_3_choice_12)) * 64);
      lowcost_pixels_first_1_4 <= ((as_number(lowcost_pixels_first_1_4_choice) +
        as_number(lowcost_pixels_first_1_4_choice_2) + as_number(lowcost_pixels_first_1_4_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_4_choice_4) + as_number(lowcost_pixels_first_1_4_choice_5) +
        as_number(lowcost_pixels_first_1_4_choice_6) + ((as_number(lowcost_pixels_first_1_4_choice_7) +
        as_number(lowcost_pixels_first_1_4_choice_8) + as_number(lowcost_pixels_first_1_4_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_4_choice_10) + as_number(lowcost_pixels_first_1_4_choice_11) +
        as_number(lowcost_pixels_first_1_4_choice_12)) * 64);
      lowcost_pixels_first_1_5 <= ((as_number(lowcost_pixels_first_1_5_choice) +
        as_number(lowcost_pixels_first_1_5_choice_2) + as_number(lowcost_pixels_first_1_5_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_5_choice_4) + as_number(lowcost_pixels_first_1_5_choice_5) +
        as_number(lowcost_pixels_first_1_5_choice_6) + ((as_number(lowcost_pixels_first_1_5_choice_7) +
        as_number(lowcost_pixels_first_1_5_choice_8) + as_number(lowcost_pixels_first_1_5_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_5_choice_10) + as_number(lowcost_pixels_first_1_5_choice_11) +
        as_number(lowcost_pixels_first_1_5_choice_12)) * 64);
      lowcost_pixels_first_1_6 <= ((as_number(lowcost_pixels_first_1_6_choice) +
        as_number(lowcost_pixels_first_1_6_choice_2) + as_number(lowcost_pixels_first_1_6_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_6_choice_4) + as_number(lowcost_pixels_first_1_6_choice_5) +
        as_number(lowcost_pixels_first_1_6_choice_6) + ((as_number(lowcost_pixels_first_1_6_choice_7) +
        as_number(lowcost_pixels_first_1_6_choice_8) + as_number(lowcost_pixels_first_1_6_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_6_choice_10) + as_number(lowcost_pixels_first_1_6_choice_11) +
        as_number(lowcost_pixels_first_1_6_choice_12)) * 64);
      lowcost_pixels_first_1_7 <= ((as_number(lowcost_pixels_first_1_7_choice) +
        as_number(lowcost_pixels_first_1_7_choice_2) + as_number(lowcost_pixels_first_1_7_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_7_choice_4) + as_number(lowcost_pixels_first_1_7_choice_5) +
        as_number(lowcost_pixels_first_1_7_choice_6) + ((as_number(lowcost_pixels_first_1_7_choice_7) +
        as_number(lowcost_pixels_first_1_7_choice_8) + as_number(lowcost_pixels_first_1_7_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_7_choice_10) + as_number(lowcost_pixels_first_1_7_choice_11) +
        as_number(lowcost_pixels_first_1_7_choice_12)) * 64);
      lowcost_pixels_first_1_8 <= ((as_number(lowcost_pixels_first_1_8_choice) +
        as_number(lowcost_pixels_first_1_8_choice_2) + as_number(lowcost_pixels_first_1_8_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_8_choice_4) + as_number(lowcost_pixels_first_1_8_choice_5) +
        as_number(lowcost_pixels_first_1_8_choice_6) + ((as_number(lowcost_pixels_first_1_8_choice_7) +
        as_number(lowcost_pixels_first_1_8_choice_8) + as_number(lowcost_pixels_first_1_8_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_8_choice_10) + as_number(lowcost_pixels_first_1_8_choice_11) +
        as_number(lowcost_pixels_first_1_8_choice_12)) * 64);
      lowcost_pixels_first_1_9 <= ((as_number(lowcost_pixels_first_1_9_choice) +
        as_number(lowcost_pixels_first_1_9_choice_2) + as_number(lowcost_pixels_first_1_9_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_9_choice_4) + as_number(lowcost_pixels_first_1_9_choice_5) +
        as_number(lowcost_pixels_first_1_9_choice_6) + ((as_number(lowcost_pixels_first_1_9_choice_7) +
        as_number(lowcost_pixels_first_1_9_choice_8) + as_number(lowcost_pixels_first_1_9_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_9_choice_10) + as_number(lowcost_pixels_first_1_9_choice_11) +
        as_number(lowcost_pixels_first_1_9_choice_12)) * 64);
      lowcost_pixels_first_1_10 <= ((as_number(lowcost_pixels_first_1_10_choice) +
        as_number(lowcost_pixels_first_1_10_choice_2) + as_number(lowcost_pixels_first_1_10_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_10_choice_4) + as_number(lowcost_pixels_first_1_10_choice_5) +
        as_number(lowcost_pixels_first_1_10_choice_6) + ((as_number(lowcost_pixels_first_1_10_choice_7) +
        as_number(lowcost_pixels_first_1_10_choice_8) + as_number(lowcost_pixels_first_1_10_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_10_choice_10) + as_number(lowcost_pixels_first_1_10_choice_11) +
        as_number(lowcost_pixels_first_1_10_choice_12)) * 64);
      lowcost_pixels_first_1_11 <= ((as_number(lowcost_pixels_first_1_11_choice) +
        as_number(lowcost_pixels_first_1_11_choice_2) + as_number(lowcost_pixels_first_1_11_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_11_choice_4) + as_number(lowcost_pixels_first_1_11_choice_5) +
        as_number(lowcost_pixels_first_1_11_choice_6) + ((as_number(lowcost_pixels_first_1_11_choice_7) +
        as_number(lowcost_pixels_first_1_11_choice_8) + as_number(lowcost_pixels_first_1_11_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_11_choice_10) + as_number(lowcost_pixels_first_1_11_choice_11) +
        as_number(lowcost_pixels_first_1_11_choice_12)) * 64);
      lowcost_pixels_first_1_12 <= ((as_number(lowcost_pixels_first_1_12_choice) +
        as_number(lowcost_pixels_first_1_12_choice_2) + as_number(lowcost_pixels_first_1_12_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_12_choice_4) + as_number(lowcost_pixels_first_1_12_choice_5) +
        as_number(lowcost_pixels_first_1_12_choice_6) + ((as_number(lowcost_pixels_first_1_12_choice_7) +
        as_number(lowcost_pixels_first_1_12_choice_8) + as_number(lowcost_pixels_first_1_12_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_12_choice_10) + as_number(lowcost_pixels_first_1_12_choice_11) +
        as_number(lowcost_pixels_first_1_12_choice_12)) * 64);
      lowcost_pixels_first_1_13 <= ((as_number(lowcost_pixels_first_1_13_choice) +
        as_number(lowcost_pixels_first_1_13_choice_2) + as_number(lowcost_pixels_first_1_13_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_13_choice_4) + as_number(lowcost_pixels_first_1_13_choice_5) +
        as_number(lowcost_pixels_first_1_13_choice_6) + ((as_number(lowcost_pixels_first_1_13_choice_7) +
        as_number(lowcost_pixels_first_1_13_choice_8) + as_number(lowcost_pixels_first_1_13_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_13_choice_10) + as_number(lowcost_pixels_first_1_13_choice_11) +
        as_number(lowcost_pixels_first_1_13_choice_12)) * 64);
      lowcost_pixels_first_1_14 <= ((as_number(lowcost_pixels_first_1_14_choice) +
        as_number(lowcost_pixels_first_1_14_choice_2) + as_number(lowcost_pixels_first_1_14_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_14_choice_4) + as_number(lowcost_pixels_first_1_14_choice_5) +
        as_number(lowcost_pixels_first_1_14_choice_6) + ((as_number(lowcost_pixels_first_1_14_choice_7) +
        as_number(lowcost_pixels_first_1_14_choice_8) + as_number(lowcost_pixels_first_1_14_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_14_choice_10) + as_number(lowcost_pixels_first_1_14_choice_11) +
        as_number(lowcost_pixels_first_1_14_choice_12)) * 64);
      lowcost_pixels_first_1_15 <= ((as_number(lowcost_pixels_first_1_15_choice) +
        as_number(lowcost_pixels_first_1_15_choice_2) + as_number(lowcost_pixels_first_1_15_choice_3)) * 4) +
        as_number(lowcost_pixels_first_1_15_choice_4) + as_number(lowcost_pixels_first_1_15_choice_5) +
        as_number(lowcost_pixels_first_1_15_choice_6) + ((as_number(lowcost_pixels_first_1_15_choice_7) +
        as_number(lowcost_pixels_first_1_15_choice_8) + as_number(lowcost_pixels_first_1_15_choice_9)) * 16) +
        ((as_number(lowcost_pixels_first_1_15_choice_10) + as_number(lowcost_pixels_first_1_15_choice_11) +
        as_number(lowcost_pixels_first_1_15_choice_12)) * 64);
      lowcost_pixels_first_tag_valid <= compared_tags_7_valid;
      lowcost_pixels_first_tag_first_group <= compared_tags_7_first_group;
      lowcost_pixels_first_tag_border_column <= compared_tags_7_border_column;
      lowcost_pixels_first_tag_first_cost <= compared_tags_7_first_cost;
      lowcost_pixels_first_tag_leaves_window <= compared_tags_7_leaves_window;
      lowcost_pixels_first_tag_output_column <= compared_tags_7_output_column;
      lowcost_pixels_first_tag_start_of_frame <= compared_tags_7_start_of_frame;
      lowcost_pixels_first_tag_end_of_line <= compared_tags_7_end_of_line;
      lowcost_pixels_cost_0_0 <= (((lowcost_pixels_first_0_0 mod 4) + (((lowcost_pixels_first_0_0 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_0 / 16) mod 4) + (lowcost_pixels_first_0_0 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_0 / 16) + (lowcost_pixels_first_0_0 / 64)) mod 2);
      lowcost_pixels_cost_0_1 <= (((lowcost_pixels_first_0_1 mod 4) + (((lowcost_pixels_first_0_1 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_1 / 16) mod 4) + (lowcost_pixels_first_0_1 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_1 / 16) + (lowcost_pixels_first_0_1 / 64)) mod 2);
      lowcost_pixels_cost_0_2 <= (((lowcost_pixels_first_0_2 mod 4) + (((lowcost_pixels_first_0_2 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_2 / 16) mod 4) + (lowcost_pixels_first_0_2 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_2 / 16) + (lowcost_pixels_first_0_2 / 64)) mod 2);
      lowcost_pixels_cost_0_3 <= (((lowcost_pixels_first_0_3 mod 4) + (((lowcost_pixels_first_0_3 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_3 / 16) mod 4) + (lowcost_pixels_first_0_3 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_3 / 16) + (lowcost_pixels_first_0_3 / 64)) mod 2);
      lowcost_pixels_cost_0_4 <= (((lowcost_pixels_first_0_4 mod 4) + (((lowcost_pixels_first_0_4 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_4 / 16) mod 4) + (lowcost_pixels_first_0_4 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_4 / 16) + (lowcost_pixels_first_0_4 / 64)) mod 2);
      lowcost_pixels_cost_0_5 <= (((lowcost_pixels_first_0_5 mod 4) + (((lowcost_pixels_first_0_5 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_5 / 16) mod 4) + (lowcost_pixels_first_0_5 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_5 / 16) + (lowcost_pixels_first_0_5 / 64)) mod 2);
      lowcost_pixels_cost_0_6 <= (((lowcost_pixels_first_0_6 mod 4) + (((lowcost_pixels_first_0_6 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_6 / 16) mod 4) + (lowcost_pixels_first_0_6 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_6 / 16) + (lowcost_pixels_first_0_6 / 64)) mod 2);
      lowcost_pixels_cost_0_7 <= (((lowcost_pixels_first_0_7 mod 4) + (((lowcost_pixels_first_0_7 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_7 / 16) mod 4) + (lowcost_pixels_first_0_7 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_7 / 16) + (lowcost_pixels_first_0_7 / 64)) mod 2);
      lowcost_pixels_cost_0_8 <= (((lowcost_pixels_first_0_8 mod 4) + (((lowcost_pixels_first_0_8 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_8 / 16) mod 4) + (lowcost_pixels_first_0_8 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_8 / 16) + (lowcost_pixels_first_0_8 / 64)) mod 2);
      lowcost_pixels_cost_0_9 <= (((lowcost_pixels_first_0_9 mod 4) + (((lowcost_pixels_first_0_9 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_9 / 16) mod 4) + (lowcost_pixels_first_0_9 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_9 / 16) + (lowcost_pixels_first_0_9 / 64)) mod 2);
      lowcost_pixels_cost_0_10 <= (((lowcost_pixels_first_0_10 mod 4) + (((lowcost_pixels_first_0_10 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_10 / 16) mod 4) + (lowcost_pixels_first_0_10 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_10 / 16) + (lowcost_pixels_first_0_10 / 64)) mod 2);
      lowcost_pixels_cost_0_11 <= (((lowcost_pixels_first_0_11 mod 4) + (((lowcost_pixels_first_0_11 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_11 / 16) mod 4) + (lowcost_pixels_first_0_11 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_11 / 16) + (lowcost_pixels_first_0_11 / 64)) mod 2);
      lowcost_pixels_cost_0_12 <= (((lowcost_pixels_first_0_12 mod 4) + (((lowcost_pixels_first_0_12 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_12 / 16) mod 4) + (lowcost_pixels_first_0_12 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_12 / 16) + (lowcost_pixels_first_0_12 / 64)) mod 2);
      lowcost_pixels_cost_0_13 <= (((lowcost_pixels_first_0_13 mod 4) + (((lowcost_pixels_first_0_13 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_13 / 16) mod 4) + (lowcost_pixels_first_0_13 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_13 / 16) + (lowcost_pixels_first_0_13 / 64)) mod 2);
      lowcost_pixels_cost_0_14 <= (((lowcost_pixels_first_0_14 mod 4) + (((lowcost_pixels_first_0_14 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_14 / 16) mod 4) + (lowcost_pixels_first_0_14 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_14 / 16) + (lowcost_pixels_first_0_14 / 64)) mod 2);
      lowcost_pixels_cost_0_15 <= (((lowcost_pixels_first_0_15 mod 4) + (((lowcost_pixels_first_0_15 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_0_15 / 16) mod 4) + (lowcost_pixels_first_0_15 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_0_15 / 16) + (lowcost_pixels_first_0_15 / 64)) mod 2);
      lowcost_pixels_cost_1_0 <= (((lowcost_pixels_first_1_0 mod 4) + (((lowcost_pixels_first_1_0 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_0 / 16) mod 4) + (lowcost_pixels_first_1_0 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_0 / 16) + (lowcost_pixels_first_1_0 / 64)) mod 2);
      lowcost_pixels_cost_1_1 <= (((lowcost_pixels_first_1_1 mod 4) + (((lowcost_pixels_first_1_1 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_1 / 16) mod 4) + (lowcost_pixels_first_1_1 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_1 / 16) + (lowcost_pixels_first_1_1 / 64)) mod 2);
      lowcost_pixels_cost_1_2 <= (((lowcost_pixels_first_1_2 mod 4) + (((lowcost_pixels_first_1_2 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_2 / 16) mod 4) + (lowcost_pixels_first_1_2 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_2 / 16) + (lowcost_pixels_first_1_2 / 64)) mod 2);
      lowcost_pixels_cost_1_3 <= (((lowcost_pixels_first_1_3 mod 4) + (((lowcost_pixels_first_1_3 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_3 / 16) mod 4) + (lowcost_pixels_first_1_3 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_3 / 16) + (lowcost_pixels_first_1_3 / 64)) mod 2);
      lowcost_pixels_cost_1_4 <= (((lowcost_pixels_first_1_4 mod 4) + (((lowcost_pixels_first_1_4 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_4 / 16) mod 4) + (lowcost_pixels_first_1_4 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_4 / 16) + (lowcost_pixels_first_1_4 / 64)) mod 2);
      lowcost_pixels_cost_1_5 <= (((lowcost_pixels_first_1_5 mod 4) + (((lowcost_pixels_first_1_5 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_5 / 16) mod 4) + (lowcost_pixels_first_1_5 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_5 / 16) + (lowcost_pixels_first_1_5 / 64)) mod 2);
      lowcost_pixels_cost_1_6 <= (((lowcost_pixels_first_1_6 mod 4) + (((lowcost_pixels_first_1_6 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_6 / 16) mod 4) + (lowcost_pixels_first_1_6 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_6 / 16) + (lowcost_pixels_first_1_6 / 64)) mod 2);
      lowcost_pixels_cost_1_7 <= (((lowcost_pixels_first_1_7 mod 4) + (((lowcost_pixels_first_1_7 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_7 / 16) mod 4) + (lowcost_pixels_first_1_7 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_7 / 16) + (lowcost_pixels_first_1_7 / 64)) mod 2);
      lowcost_pixels_cost_1_8 <= (((lowcost_pixels_first_1_8 mod 4) + (((lowcost_pixels_first_1_8 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_8 / 16) mod 4) + (lowcost_pixels_first_1_8 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_8 / 16) + (lowcost_pixels_first_1_8 / 64)) mod 2);
      lowcost_pixels_cost_1_9 <= (((lowcost_pixels_first_1_9 mod 4) + (((lowcost_pixels_first_1_9 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_9 / 16) mod 4) + (lowcost_pixels_first_1_9 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_9 / 16) + (lowcost_pixels_first_1_9 / 64)) mod 2);
      lowcost_pixels_cost_1_10 <= (((lowcost_pixels_first_1_10 mod 4) + (((lowcost_pixels_first_1_10 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_10 / 16) mod 4) + (lowcost_pixels_first_1_10 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_10 / 16) + (lowcost_pixels_first_1_10 / 64)) mod 2);
      lowcost_pixels_cost_1_11 <= (((lowcost_pixels_first_1_11 mod 4) + (((lowcost_pixels_first_1_11 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_11 / 16) mod 4) + (lowcost_pixels_first_1_11 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_11 / 16) + (lowcost_pixels_first_1_11 / 64)) mod 2);
      lowcost_pixels_cost_1_12 <= (((lowcost_pixels_first_1_12 mod 4) + (((lowcost_pixels_first_1_12 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_12 / 16) mod 4) + (lowcost_pixels_first_1_12 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_12 / 16) + (lowcost_pixels_first_1_12 / 64)) mod 2);
      lowcost_pixels_cost_1_13 <= (((lowcost_pixels_first_1_13 mod 4) + (((lowcost_pixels_first_1_13 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_13 / 16) mod 4) + (lowcost_pixels_first_1_13 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_13 / 16) + (lowcost_pixels_first_1_13 / 64)) mod 2);
      lowcost_pixels_cost_1_14 <= (((lowcost_pixels_first_1_14 mod 4) + (((lowcost_pixels_first_1_14 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_14 / 16) mod 4) + (lowcost_pixels_first_1_14 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_14 / 16) + (lowcost_pixels_first_1_14 / 64)) mod 2);
      lowcost_pixels_cost_1_15 <= (((lowcost_pixels_first_1_15 mod 4) + (((lowcost_pixels_first_1_15 / 2) mod 8) / 2) +
        ((((lowcost_pixels_first_1_15 / 16) mod 4) + (lowcost_pixels_first_1_15 / 64)) / 2)) * 2) +
        (((lowcost_pixels_first_1_15 / 16) + (lowcost_pixels_first_1_15 / 64)) mod 2);
      lowcost_pixels_tag_valid <= lowcost_pixels_first_tag_valid;
      lowcost_pixels_tag_first_group <= lowcost_pixels_first_tag_first_group;
      lowcost_pixels_tag_border_column <= lowcost_pixels_first_tag_border_column;
      lowcost_pixels_tag_first_cost <= lowcost_pixels_first_tag_first_cost;
      lowcost_pixels_tag_leaves_window <= lowcost_pixels_first_tag_leaves_window;
      lowcost_pixels_tag_output_column <= lowcost_pixels_first_tag_output_column;
      lowcost_pixels_tag_start_of_frame <= lowcost_pixels_first_tag_start_of_frame;
      lowcost_pixels_tag_end_of_line <= lowcost_pixels_first_tag_end_of_line;
      lowcost_change_column <= lowcost_read_column;
      lowcost_change_0_0 <= lowcost_pixels_cost_1_0 - lowcost_pixels_cost_0_0;
      lowcost_change_0_1 <= lowcost_pixels_cost_1_1 - lowcost_pixels_cost_0_1;
      lowcost_change_0_2 <= lowcost_pixels_cost_1_2 - lowcost_pixels_cost_0_2;
      lowcost_change_0_3 <= lowcost_pixels_cost_1_3 - lowcost_pixels_cost_0_3;
      lowcost_change_0_4 <= lowcost_pixels_cost_1_4 - lowcost_pixels_cost_0_4;
      lowcost_change_0_5 <= lowcost_pixels_cost_1_5 - lowcost_pixels_cost_0_5;
      lowcost_change_0_6 <= lowcost_pixels_cost_1_6 - lowcost_pixels_cost_0_6;
      lowcost_change_0_7 <= lowcost_pixels_cost_1_7 - lowcost_pixels_cost_0_7;
      lowcost_change_0_8 <= lowcost_pixels_cost_1_8 - lowcost_pixels_cost_0_8;
      lowcost_change_0_9 <= lowcost_pixels_cost_1_9 - lowcost_pixels_cost_0_9;
      lowcost_change_0_10 <= lowcost_pixels_cost_1_10 - lowcost_pixels_cost_0_10;
      lowcost_change_0_11 <= lowcost_pixels_cost_1_11 - lowcost_pixels_cost_0_11;
      lowcost_change_0_12 <= lowcost_pixels_cost_1_12 - lowcost_pixels_cost_0_12;
      lowcost_change_0_13 <= lowcost_pixels_cost_1_13 - lowcost_pixels_cost_0_13;
      lowcost_change_0_14 <= lowcost_pixels_cost_1_14 - lowcost_pixels_cost_0_14;
      lowcost_change_0_15 <= lowcost_pixels_cost_1_15 - lowcost_pixels_cost_0_15;
      lowcost_ready_words_0 <= to_integer(lowcost_read_words_0);
      lowcost_ready_words_1 <= to_integer(lowcost_read_words_1);
      lowcost_ready_words_2 <= to_integer(lowcost_read_words_2);
      lowcost_ready_words_3 <= to_integer(lowcost_read_words_3);
      lowcost_ready_column <= lowcost_change_column;
      lowcost_ready_tag_valid <= lowcost_pixels_tag_valid;
      lowcost_ready_tag_first_group <= lowcost_pixels_tag_first_group;
      lowcost_ready_tag_border_column <= lowcost_pixels_tag_border_column;
      lowcost_ready_tag_first_cost <= lowcost_pixels_tag_first_cost;
      lowcost_ready_tag_leaves_window <= lowcost_pixels_tag_leaves_window;
      lowcost_ready_tag_output_column <= lowcost_pixels_tag_output_column;
      lowcost_ready_tag_start_of_frame <= lowcost_pixels_tag_start_of_frame;
      lowcost_ready_tag_end_of_line <= lowcost_pixels_tag_end_of_line;
      lowcost_column_0_0 <= lowcost_column_0_0_choice_2;
      lowcost_column_0_1 <= lowcost_column_0_1_choice_2;
      lowcost_column_0_2 <= lowcost_column_0_2_choice_2;
      lowcost_column_0_3 <= lowcost_column_0_3_choice_2;
      lowcost_column_0_4 <= lowcost_column_0_4_choice_2;
      lowcost_column_0_5 <= lowcost_column_0_5_choice_2;
      lowcost_column_0_6 <= lowcost_column_0_6_choice_2;
      lowcost_column_0_7 <= lowcost_column_0_7_choice_2;
      lowcost_column_0_8 <= lowcost_column_0_8_choice_2;
      lowcost_column_0_9 <= lowcost_column_0_9_choice_2;
      lowcost_column_0_10 <= lowcost_column_0_10_choice_2;
      lowcost_column_0_11 <= lowcost_column_0_11_choice_2;
      lowcost_column_0_12 <= lowcost_column_0_12_choice_2;
      lowcost_column_0_13 <= lowcost_column_0_13_choice_2;
      lowcost_column_0_14 <= lowcost_column_0_14_choice_2;
      lowcost_column_0_15 <= lowcost_column_0_15_choice_2;
      lowcost_tag_valid <= lowcost_ready_tag_valid;
      lowcost_tag_first_cost <= lowcost_ready_tag_first_cost;
      lowcost_tag_leaves_window <= lowcost_ready_tag_leaves_window;
      lowcost_tag_output_column <= lowcost_ready_tag_output_column;
      lowcost_tag_start_of_frame <= lowcost_ready_tag_start_of_frame;
      lowcost_tag_end_of_line <= lowcost_ready_tag_end_of_line;
      if compared_tags_7_valid then
        if compared_tags_7_row_start then
          lowcost_read_column <= 0;
        else
          lowcost_read_column <= (lowcost_read_column + 1) mod 64;
        end if;
      end if;
      if lowcost_ready_tag_valid then
        lowcost_write_column <= lowcost_ready_column;
        lowcost_write_words_0 <= (lowcost_column_0_1_choice_2 * 128) + lowcost_column_0_0_choice_2 +
          (lowcost_column_0_2_choice_2 * 16384) + (lowcost_column_0_3_choice_2 * 2097152);
        lowcost_write_words_1 <= (lowcost_column_0_5_choice_2 * 128) + lowcost_column_0_4_choice_2 +
          (lowcost_column_0_6_choice_2 * 16384) + (lowcost_column_0_7_choice_2 * 2097152);
        lowcost_write_words_2 <= (lowcost_column_0_9_choice_2 * 128) + lowcost_column_0_8_choice_2 +
          (lowcost_column_0_10_choice_2 * 16384) + (lowcost_column_0_11_choice_2 * 2097152);
        lowcost_write_words_3 <= (lowcost_column_0_13_choice_2 * 128) + lowcost_column_0_12_choice_2 +
          (lowcost_column_0_14_choice_2 * 16384) + (lowcost_column_0_15_choice_2 * 2097152);
      end if;
      -- lowwindow
      if lowcost_tag_valid then
        lowwindow_ring_write_address <= lowwindow_ring_read_address;
        if lowwindow_ring_read_address = 5 then
          lowwindow_ring_read_address <= 0;
        else
          lowwindow_ring_read_address <= (lowwindow_ring_read_address + 1) mod 8;
        end if;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_0_choice := to_integer(lowwindow_leaving_0(6 downto 0));
      else
        lowwindow_change_0_0_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_1_choice := to_integer(lowwindow_leaving_0(13 downto 7));
      else
        lowwindow_change_0_1_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_2_choice := to_integer(lowwindow_leaving_0(20 downto 14));
      else
        lowwindow_change_0_2_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_3_choice := to_integer(lowwindow_leaving_0(27 downto 21));
      else
        lowwindow_change_0_3_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_4_choice := to_integer(lowwindow_leaving_1(6 downto 0));
      else
        lowwindow_change_0_4_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_5_choice := to_integer(lowwindow_leaving_1(13 downto 7));
      else
        lowwindow_change_0_5_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_6_choice := to_integer(lowwindow_leaving_1(20 downto 14));
      else
        lowwindow_change_0_6_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_7_choice := to_integer(lowwindow_leaving_1(27 downto 21));
      else
        lowwindow_change_0_7_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_8_choice := to_integer(lowwindow_leaving_2(6 downto 0));
      else
        lowwindow_change_0_8_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_9_choice := to_integer(lowwindow_leaving_2(13 downto 7));
      else
        lowwindow_change_0_9_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_10_choice := to_integer(lowwindow_leaving_2(20 downto 14));
      else
        lowwindow_change_0_10_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_11_choice := to_integer(lowwindow_leaving_2(27 downto 21));
      else
        lowwindow_change_0_11_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_12_choice := to_integer(lowwindow_leaving_3(6 downto 0));
      else
        lowwindow_change_0_12_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_13_choice := to_integer(lowwindow_leaving_3(13 downto 7));
      else
        lowwindow_change_0_13_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_14_choice := to_integer(lowwindow_leaving_3(20 downto 14));
      else
        lowwindow_change_0_14_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        lowwindow_change_0_15_choice := to_integer(lowwindow_leaving_3(27 downto 21));
      else
        lowwindow_change_0_15_choice := 0;
      end if;
      lowwindow_entering_0_0 <= lowcost_column_0_0;
      lowwindow_entering_0_1 <= lowcost_column_0_1;
      lowwindow_entering_0_2 <= lowcost_column_0_2;
      lowwindow_entering_0_3 <= lowcost_column_0_3;
      lowwindow_entering_0_4 <= lowcost_column_0_4;
      lowwindow_entering_0_5 <= lowcost_column_0_5;
      lowwindow_entering_0_6 <= lowcost_column_0_6;
      lowwindow_entering_0_7 <= lowcost_column_0_7;
      lowwindow_entering_0_8 <= lowcost_column_0_8;
      lowwindow_entering_0_9 <= lowcost_column_0_9;
      lowwindow_entering_0_10 <= lowcost_column_0_10;
      lowwindow_entering_0_11 <= lowcost_column_0_11;
      lowwindow_entering_0_12 <= lowcost_column_0_12;
      lowwindow_entering_0_13 <= lowcost_column_0_13;
      lowwindow_entering_0_14 <= lowcost_column_0_14;
      lowwindow_entering_0_15 <= lowcost_column_0_15;
      lowwindow_entering_tag_valid <= lowcost_tag_valid;
      lowwindow_entering_tag_first_cost <= lowcost_tag_first_cost;
      lowwindow_entering_tag_leaves_window <= lowcost_tag_leaves_window;
      lowwindow_entering_tag_output_column <= lowcost_tag_output_column;
      lowwindow_entering_tag_start_of_frame <= lowcost_tag_start_of_frame;
      lowwindow_entering_tag_end_of_line <= lowcost_tag_end_of_line;
      lowwindow_change_0_0 <= lowwindow_entering_0_0 - lowwindow_change_0_0_choice;
      lowwindow_change_0_1 <= lowwindow_entering_0_1 - lowwindow_change_0_1_choice;
      lowwindow_change_0_2 <= lowwindow_entering_0_2 - lowwindow_change_0_2_choice;
      lowwindow_change_0_3 <= lowwindow_entering_0_3 - lowwindow_change_0_3_choice;
      lowwindow_change_0_4 <= lowwindow_entering_0_4 - lowwindow_change_0_4_choice;
      lowwindow_change_0_5 <= lowwindow_entering_0_5 - lowwindow_change_0_5_choice;
      lowwindow_change_0_6 <= lowwindow_entering_0_6 - lowwindow_change_0_6_choice;
      lowwindow_change_0_7 <= lowwindow_entering_0_7 - lowwindow_change_0_7_choice;
      lowwindow_change_0_8 <= lowwindow_entering_0_8 - lowwindow_change_0_8_choice;
      lowwindow_change_0_9 <= lowwindow_entering_0_9 - lowwindow_change_0_9_choice;
      lowwindow_change_0_10 <= lowwindow_entering_0_10 - lowwindow_change_0_10_choice;
      lowwindow_change_0_11 <= lowwindow_entering_0_11 - lowwindow_change_0_11_choice;
      lowwindow_change_0_12 <= lowwindow_entering_0_12 - lowwindow_change_0_12_choice;
      lowwindow_change_0_13 <= lowwindow_entering_0_13 - lowwindow_change_0_13_choice;
      lowwindow_change_0_14 <= lowwindow_entering_0_14 - lowwindow_change_0_14_choice;
      lowwindow_change_0_15 <= lowwindow_entering_0_15 - lowwindow_change_0_15_choice;
      lowwindow_change_tag_valid <= lowwindow_entering_tag_valid;
      lowwindow_change_tag_first_cost <= lowwindow_entering_tag_first_cost;
      lowwindow_change_tag_output_column <= lowwindow_entering_tag_output_column;
      lowwindow_change_tag_start_of_frame <= lowwindow_entering_tag_start_of_frame;
      lowwindow_change_tag_end_of_line <= lowwindow_entering_tag_end_of_line;
      lowwindow_tag_valid <= lowwindow_change_tag_valid;
      lowwindow_tag_output_column <= lowwindow_centre_output_column_1;
      lowwindow_tag_start_of_frame <= lowwindow_centre_start_of_frame_1;
      lowwindow_tag_end_of_line <= lowwindow_centre_end_of_line_1;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_0_choice := 0;
      else
        lowwindow_sum_0_0_choice := lowwindow_sum_0_0;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_1_choice := 0;
      else
        lowwindow_sum_0_1_choice := lowwindow_sum_0_1;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_2_choice := 0;
      else
        lowwindow_sum_0_2_choice := lowwindow_sum_0_2;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_3_choice := 0;
      else
        lowwindow_sum_0_3_choice := lowwindow_sum_0_3;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_4_choice := 0;
      else
        lowwindow_sum_0_4_choice := lowwindow_sum_0_4;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_5_choice := 0;
      else
        lowwindow_sum_0_5_choice := lowwindow_sum_0_5;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_6_choice := 0;
      else
        lowwindow_sum_0_6_choice := lowwindow_sum_0_6;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_7_choice := 0;
      else
        lowwindow_sum_0_7_choice := lowwindow_sum_0_7;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_8_choice := 0;
      else
        lowwindow_sum_0_8_choice := lowwindow_sum_0_8;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_9_choice := 0;
      else
        lowwindow_sum_0_9_choice := lowwindow_sum_0_9;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_10_choice := 0;
      else
        lowwindow_sum_0_10_choice := lowwindow_sum_0_10;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_11_choice := 0;
      else
        lowwindow_sum_0_11_choice := lowwindow_sum_0_11;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_12_choice := 0;
      else
        lowwindow_sum_0_12_choice := lowwindow_sum_0_12;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_13_choice := 0;
      else
        lowwindow_sum_0_13_choice := lowwindow_sum_0_13;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_14_choice := 0;
      else
        lowwindow_sum_0_14_choice := lowwindow_sum_0_14;
      end if;
      if lowwindow_change_tag_first_cost then
        lowwindow_sum_0_15_choice := 0;
      else
        lowwindow_sum_0_15_choice := lowwindow_sum_0_15;
      end if;
      if lowwindow_change_tag_valid then
        lowwindow_sum_0_0 <= (lowwindow_sum_0_0_choice + lowwindow_change_0_0) mod 512;
        lowwindow_sum_0_1 <= (lowwindow_sum_0_1_choice + lowwindow_change_0_1) mod 512;
        lowwindow_sum_0_2 <= (lowwindow_sum_0_2_choice + lowwindow_change_0_2) mod 512;
        lowwindow_sum_0_3 <= (lowwindow_sum_0_3_choice + lowwindow_change_0_3) mod 512;
        lowwindow_sum_0_4 <= (lowwindow_sum_0_4_choice + lowwindow_change_0_4) mod 512;
        lowwindow_sum_0_5 <= (lowwindow_sum_0_5_choice + lowwindow_change_0_5) mod 512;
        lowwindow_sum_0_6 <= (lowwindow_sum_0_6_choice + lowwindow_change_0_6) mod 512;
        lowwindow_sum_0_7 <= (lowwindow_sum_0_7_choice + lowwindow_change_0_7) mod 512;
        lowwindow_sum_0_8 <= (lowwindow_sum_0_8_choice + lowwindow_change_0_8) mod 512;
        lowwindow_sum_0_9 <= (lowwindow_sum_0_9_choice + lowwindow_change_0_9) mod 512;
        lowwindow_sum_0_10 <= (lowwindow_sum_0_10_choice + lowwindow_change_0_10) mod 512;
        lowwindow_sum_0_11 <= (lowwindow_sum_0_11_choice + lowwindow_change_0_11) mod 512;
        lowwindow_sum_0_12 <= (lowwindow_sum_0_12_choice + lowwindow_change_0_12) mod 512;
        lowwindow_sum_0_13 <= (lowwindow_sum_0_13_choice + lowwindow_change_0_13) mod 512;
        lowwindow_sum_0_14 <= (lowwindow_sum_0_14_choice + lowwindow_change_0_14) mod 512;
        lowwindow_sum_0_15 <= (lowwindow_sum_0_15_choice + lowwindow_change_0_15) mod 512;
        lowwindow_centre_output_column_0 <= lowwindow_change_tag_output_column;
        lowwindow_centre_output_column_1 <= lowwindow_centre_output_column_0;
        lowwindow_centre_start_of_frame_0 <= lowwindow_change_tag_start_of_frame;
        lowwindow_centre_start_of_frame_1 <= lowwindow_centre_start_of_frame_0;
        lowwindow_centre_end_of_line_0 <= lowwindow_change_tag_end_of_line;
        lowwindow_centre_end_of_line_1 <= lowwindow_centre_end_of_line_0;
      end if;
      -- lowwinner1
      lowwinner1_of_pair_0_0_is_less := (lowwindow_sum_0_1 - lowwindow_sum_0_0) < 0;
      lowwinner1_of_pair_0_2_is_less := (lowwindow_sum_0_3 - lowwindow_sum_0_2) < 0;
      lowwinner1_of_pair_0_4_is_less := (lowwindow_sum_0_5 - lowwindow_sum_0_4) < 0;
      lowwinner1_of_pair_0_6_is_less := (lowwindow_sum_0_7 - lowwindow_sum_0_6) < 0;
      lowwinner1_of_pair_0_8_is_less := (lowwindow_sum_0_9 - lowwindow_sum_0_8) < 0;
      lowwinner1_of_pair_0_10_is_less := (lowwindow_sum_0_11 - lowwindow_sum_0_10) < 0;
      lowwinner1_of_pair_0_12_is_less := (lowwindow_sum_0_13 - lowwindow_sum_0_12) < 0;
      lowwinner1_of_pair_0_14_is_less := (lowwindow_sum_0_15 - lowwindow_sum_0_14) < 0;
      lowwinner1_of_four_0_0_is_less := (to_integer(((to_unsigned(lowwinner1_of_pair_0_2, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_3, 9)))) - to_integer(((to_unsigned(lowwinner1_of_pair_0_0, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_1, 9))))) < 0;
      lowwinner1_of_four_0_4_is_less := (to_integer(((to_unsigned(lowwinner1_of_pair_0_6, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_7, 9)))) - to_integer(((to_unsigned(lowwinner1_of_pair_0_4, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_5, 9))))) < 0;
      lowwinner1_of_four_0_8_is_less := (to_integer(((to_unsigned(lowwinner1_of_pair_0_10, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_11, 9)))) - to_integer(((to_unsigned(lowwinner1_of_pair_0_8, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_9, 9))))) < 0;
      lowwinner1_of_four_0_12_is_less := (to_integer(((to_unsigned(lowwinner1_of_pair_0_14, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_15, 9)))) - to_integer(((to_unsigned(lowwinner1_of_pair_0_12, 9)) or
        (to_unsigned(lowwinner1_of_pair_0_13, 9))))) < 0;
      lowwinner1_pair_index_0_0 <= lowwinner1_of_pair_0_0_is_less;
      lowwinner1_pair_tag_valid <= lowwindow_tag_valid;
      lowwinner1_pair_tag_output_column <= lowwindow_tag_output_column;
      lowwinner1_pair_tag_start_of_frame <= lowwindow_tag_start_of_frame;
      lowwinner1_pair_tag_end_of_line <= lowwindow_tag_end_of_line;
      lowwinner1_four_tag_valid <= lowwinner1_pair_tag_valid;
      lowwinner1_four_tag_output_column <= lowwinner1_pair_tag_output_column;
      lowwinner1_four_tag_start_of_frame <= lowwinner1_pair_tag_start_of_frame;
      lowwinner1_four_tag_end_of_line <= lowwinner1_pair_tag_end_of_line;
      lowwinner1_best_cost_0_0 <= to_integer(((((((to_unsigned(lowwinner1_of_four_0_2, 9)) or
        (to_unsigned(lowwinner1_of_four_0_3, 9)))) or (to_unsigned(lowwinner1_of_four_0_1, 9)))) or
        (to_unsigned(lowwinner1_of_four_0_0, 9))));
      lowwinner1_best_cost_0_1 <= to_integer(((((((to_unsigned(lowwinner1_of_four_0_6, 9)) or
        (to_unsigned(lowwinner1_of_four_0_7, 9)))) or (to_unsigned(lowwinner1_of_four_0_5, 9)))) or
        (to_unsigned(lowwinner1_of_four_0_4, 9))));
      lowwinner1_best_cost_0_2 <= to_integer(((((((to_unsigned(lowwinner1_of_four_0_10, 9)) or
        (to_unsigned(lowwinner1_of_four_0_11, 9)))) or (to_unsigned(lowwinner1_of_four_0_9, 9)))) or
        (to_unsigned(lowwinner1_of_four_0_8, 9))));
      lowwinner1_best_cost_0_3 <= to_integer(((((((to_unsigned(lowwinner1_of_four_0_14, 9)) or
        (to_unsigned(lowwinner1_of_four_0_15, 9)))) or (to_unsigned(lowwinner1_of_four_0_13, 9)))) or
        (to_unsigned(lowwinner1_of_four_0_12, 9))));
      lowwinner1_best_index_0_0 <= lowwinner1_four_index_0_0;
      lowwinner1_best_index_0_1 <= lowwinner1_four_index_0_1;
      lowwinner1_best_index_0_2 <= lowwinner1_four_index_0_2;
      lowwinner1_best_index_0_3 <= lowwinner1_four_index_0_3;
      lowwinner1_tag_valid <= lowwinner1_four_tag_valid;
      lowwinner1_tag_output_column <= lowwinner1_four_tag_output_column;
      lowwinner1_tag_start_of_frame <= lowwinner1_four_tag_start_of_frame;
      lowwinner1_tag_end_of_line <= lowwinner1_four_tag_end_of_line;
      if lowwinner1_of_pair_0_0_is_less then
        lowwinner1_of_pair_0_0 <= 0;
        lowwinner1_of_pair_0_1 <= lowwindow_sum_0_1;
      else
        lowwinner1_of_pair_0_0 <= lowwindow_sum_0_0;
        lowwinner1_of_pair_0_1 <= 0;
      end if;
      if lowwinner1_of_pair_0_2_is_less then
        lowwinner1_of_pair_0_2 <= 0;
        lowwinner1_of_pair_0_3 <= lowwindow_sum_0_3;
        lowwinner1_pair_index_0_1 <= 3;
      else
        lowwinner1_of_pair_0_2 <= lowwindow_sum_0_2;
        lowwinner1_of_pair_0_3 <= 0;
        lowwinner1_pair_index_0_1 <= 2;
      end if;
      if lowwinner1_of_pair_0_4_is_less then
        lowwinner1_of_pair_0_4 <= 0;
        lowwinner1_of_pair_0_5 <= lowwindow_sum_0_5;
        lowwinner1_pair_index_0_2 <= 5;
      else
        lowwinner1_of_pair_0_4 <= lowwindow_sum_0_4;
        lowwinner1_of_pair_0_5 <= 0;
        lowwinner1_pair_index_0_2 <= 4;
      end if;
      if lowwinner1_of_pair_0_6_is_less then
        lowwinner1_of_pair_0_6 <= 0;
        lowwinner1_of_pair_0_7 <= lowwindow_sum_0_7;
        lowwinner1_pair_index_0_3 <= 7;
      else
        lowwinner1_of_pair_0_6 <= lowwindow_sum_0_6;
        lowwinner1_of_pair_0_7 <= 0;
        lowwinner1_pair_index_0_3 <= 6;
      end if;
      if lowwinner1_of_pair_0_8_is_less then
        lowwinner1_of_pair_0_8 <= 0;
        lowwinner1_of_pair_0_9 <= lowwindow_sum_0_9;
        lowwinner1_pair_index_0_4 <= 9;
      else
        lowwinner1_of_pair_0_8 <= lowwindow_sum_0_8;
        lowwinner1_of_pair_0_9 <= 0;
        lowwinner1_pair_index_0_4 <= 8;
      end if;
      if lowwinner1_of_pair_0_10_is_less then
        lowwinner1_of_pair_0_10 <= 0;
        lowwinner1_of_pair_0_11 <= lowwindow_sum_0_11;
        lowwinner1_pair_index_0_5 <= 11;
      else
        lowwinner1_of_pair_0_10 <= lowwindow_sum_0_10;
        lowwinner1_of_pair_0_11 <= 0;
        lowwinner1_pair_index_0_5 <= 10;
      end if;
      if lowwinner1_of_pair_0_12_is_less then
        lowwinner1_of_pair_0_12 <= 0;
        lowwinner1_of_pair_0_13 <= lowwindow_sum_0_13;
        lowwinner1_pair_index_0_6 <= 13;
      else
        lowwinner1_of_pair_0_12 <= lowwindow_sum_0_12;
        lowwinner1_of_pair_0_13 <= 0;
        lowwinner1_pair_index_0_6 <= 12;
      end if;
      if lowwinner1_of_pair_0_14_is_less then
        lowwinner1_of_pair_0_14 <= 0;
        lowwinner1_of_pair_0_15 <= lowwindow_sum_0_15;
        lowwinner1_pair_index_0_7 <= 15;
      else
        lowwinner1_of_pair_0_14 <= lowwindow_sum_0_14;
        lowwinner1_of_pair_0_15 <= 0;
        lowwinner1_pair_index_0_7 <= 14;
      end if;
      if lowwinner1_of_four_0_0_is_less then
        lowwinner1_of_four_0_0 <= 0;
        lowwinner1_of_four_0_1 <= 0;
        lowwinner1_of_four_0_2 <= lowwinner1_of_pair_0_2;
        lowwinner1_of_four_0_3 <= lowwinner1_of_pair_0_3;
        lowwinner1_four_index_0_0 <= lowwinner1_pair_index_0_1;
      else
        lowwinner1_of_four_0_0 <= lowwinner1_of_pair_0_0;
        lowwinner1_of_four_0_1 <= lowwinner1_of_pair_0_1;
        lowwinner1_of_four_0_2 <= 0;
        lowwinner1_of_four_0_3 <= 0;
        lowwinner1_four_index_0_0 <= as_number(lowwinner1_pair_index_0_0);
      end if;
      if lowwinner1_of_four_0_4_is_less then
        lowwinner1_of_four_0_4 <= 0;
        lowwinner1_of_four_0_5 <= 0;
        lowwinner1_of_four_0_6 <= lowwinner1_of_pair_0_6;
        lowwinner1_of_four_0_7 <= lowwinner1_of_pair_0_7;
        lowwinner1_four_index_0_1 <= lowwinner1_pair_index_0_3;
      else
        lowwinner1_of_four_0_4 <= lowwinner1_of_pair_0_4;
        lowwinner1_of_four_0_5 <= lowwinner1_of_pair_0_5;
        lowwinner1_of_four_0_6 <= 0;
        lowwinner1_of_four_0_7 <= 0;
        lowwinner1_four_index_0_1 <= lowwinner1_pair_index_0_2;
      end if;
      if lowwinner1_of_four_0_8_is_less then
        lowwinner1_of_four_0_8 <= 0;
        lowwinner1_of_four_0_9 <= 0;
        lowwinner1_of_four_0_10 <= lowwinner1_of_pair_0_10;
        lowwinner1_of_four_0_11 <= lowwinner1_of_pair_0_11;
        lowwinner1_four_index_0_2 <= lowwinner1_pair_index_0_5;
      else
        lowwinner1_of_four_0_8 <= lowwinner1_of_pair_0_8;
        lowwinner1_of_four_0_9 <= lowwinner1_of_pair_0_9;
        lowwinner1_of_four_0_10 <= 0;
        lowwinner1_of_four_0_11 <= 0;
        lowwinner1_four_index_0_2 <= lowwinner1_pair_index_0_4;
      end if;
      if lowwinner1_of_four_0_12_is_less then
        lowwinner1_of_four_0_12 <= 0;
        lowwinner1_of_four_0_13 <= 0;
        lowwinner1_of_four_0_14 <= lowwinner1_of_pair_0_14;
        lowwinner1_of_four_0_15 <= lowwinner1_of_pair_0_15;
        lowwinner1_four_index_0_3 <= lowwinner1_pair_index_0_7;
      else
        lowwinner1_of_four_0_12 <= lowwinner1_of_pair_0_12;
        lowwinner1_of_four_0_13 <= lowwinner1_of_pair_0_13;
        lowwinner1_of_four_0_14 <= 0;
        lowwinner1_of_four_0_15 <= 0;
        lowwinner1_four_index_0_3 <= lowwinner1_pair_index_0_6;
      end if;
      -- lowwinner2
      lowwinner2_of_pair_0_0_is_less := (lowwinner1_best_cost_0_1 - lowwinner1_best_cost_0_0) < 0;
      lowwinner2_of_pair_0_2_is_less := (lowwinner1_best_cost_0_3 - lowwinner1_best_cost_0_2) < 0;
      lowwinner2_of_four_0_0_is_less := (to_integer(((to_unsigned(lowwinner2_of_pair_0_2, 9)) or
        (to_unsigned(lowwinner2_of_pair_0_3, 9)))) - to_integer(((to_unsigned(lowwinner2_of_pair_0_0, 9)) or
        (to_unsigned(lowwinner2_of_pair_0_1, 9))))) < 0;
      lowwinner2_pair_tag_valid <= lowwinner1_tag_valid;
      lowwinner2_pair_tag_output_column <= lowwinner1_tag_output_column;
      lowwinner2_pair_tag_start_of_frame <= lowwinner1_tag_start_of_frame;
      lowwinner2_pair_tag_end_of_line <= lowwinner1_tag_end_of_line;
      lowwinner2_four_tag_valid <= lowwinner2_pair_tag_valid;
      lowwinner2_four_tag_output_column <= lowwinner2_pair_tag_output_column;
      lowwinner2_four_tag_start_of_frame <= lowwinner2_pair_tag_start_of_frame;
      lowwinner2_four_tag_end_of_line <= lowwinner2_pair_tag_end_of_line;
      lowwinner2_best_cost_0_0 <= to_integer(((((((to_unsigned(lowwinner2_of_four_0_2, 9)) or
        (to_unsigned(lowwinner2_of_four_0_3, 9)))) or (to_unsigned(lowwinner2_of_four_0_1, 9)))) or
        (to_unsigned(lowwinner2_of_four_0_0, 9))));
      lowwinner2_best_index_0_0 <= lowwinner2_four_index_0_0;
      lowwinner2_tag_valid <= lowwinner2_four_tag_valid;
      lowwinner2_tag_output_column <= lowwinner2_four_tag_output_column;
      lowwinner2_tag_start_of_frame <= lowwinner2_four_tag_start_of_frame;
      lowwinner2_tag_end_of_line <= lowwinner2_four_tag_end_of_line;
      if lowwinner2_of_pair_0_0_is_less then
        lowwinner2_of_pair_0_0 <= 0;
        lowwinner2_of_pair_0_1 <= lowwinner1_best_cost_0_1;
        lowwinner2_pair_index_0_0 <= lowwinner1_best_index_0_1;
      else
        lowwinner2_of_pair_0_0 <= lowwinner1_best_cost_0_0;
        lowwinner2_of_pair_0_1 <= 0;
        lowwinner2_pair_index_0_0 <= lowwinner1_best_index_0_0;
      end if;
      if lowwinner2_of_pair_0_2_is_less then
        lowwinner2_of_pair_0_2 <= 0;
        lowwinner2_of_pair_0_3 <= lowwinner1_best_cost_0_3;
        lowwinner2_pair_index_0_1 <= lowwinner1_best_index_0_3;
      else
        lowwinner2_of_pair_0_2 <= lowwinner1_best_cost_0_2;
        lowwinner2_of_pair_0_3 <= 0;
        lowwinner2_pair_index_0_1 <= lowwinner1_best_index_0_2;
      end if;
      if lowwinner2_of_four_0_0_is_less then
        lowwinner2_of_four_0_0 <= 0;
        lowwinner2_of_four_0_1 <= 0;
        lowwinner2_of_four_0_2 <= lowwinner2_of_pair_0_2;
        lowwinner2_of_four_0_3 <= lowwinner2_of_pair_0_3;
        lowwinner2_four_index_0_0 <= lowwinner2_pair_index_0_1;
      else
        lowwinner2_of_four_0_0 <= lowwinner2_of_pair_0_0;
        lowwinner2_of_four_0_1 <= lowwinner2_of_pair_0_1;
        lowwinner2_of_four_0_2 <= 0;
        lowwinner2_of_four_0_3 <= 0;
        lowwinner2_four_index_0_0 <= lowwinner2_pair_index_0_0;
      end if;
      -- highchain
      if rows_step_one_1_0 then
        highchain_lane_0_0_choice := compared_tags_6_valid;
      else
        highchain_lane_0_0_choice := rows_step_four_1_0 and compared_tags_6_valid;
      end if;
      if highchain_lane_0_0_choice then
        if rows_step_four_1_0 then
          highchain_lane_0_0 <= highchain_lane_0_4;
          highchain_lane_0_1 <= highchain_lane_0_5;
          highchain_lane_0_2 <= highchain_lane_0_6;
          highchain_lane_0_3 <= highchain_lane_0_7;
          highchain_lane_0_4 <= highchain_lane_0_8;
          highchain_lane_0_5 <= highchain_lane_0_9;
          highchain_lane_0_6 <= highchain_lane_0_10;
          highchain_lane_0_7 <= highchain_lane_0_11;
          highchain_lane_0_8 <= highchain_lane_0_12;
          highchain_lane_0_9 <= highchain_lane_0_13;
          highchain_lane_0_10 <= highchain_lane_0_14;
          highchain_lane_0_11 <= highchain_lane_0_15;
          highchain_lane_0_12 <= rows_codes_1_0_0;
          highchain_lane_0_13 <= rows_codes_1_0_1;
          highchain_lane_0_14 <= rows_codes_1_0_2;
          highchain_lane_0_15 <= rows_codes_1_0_3;
        else
          highchain_lane_0_0 <= highchain_lane_0_1;
          highchain_lane_0_1 <= highchain_lane_0_2;
          highchain_lane_0_2 <= highchain_lane_0_3;
          highchain_lane_0_3 <= highchain_lane_0_4;
          highchain_lane_0_4 <= highchain_lane_0_5;
          highchain_lane_0_5 <= highchain_lane_0_6;
          highchain_lane_0_6 <= highchain_lane_0_7;
          highchain_lane_0_7 <= highchain_lane_0_8;
          highchain_lane_0_8 <= highchain_lane_0_9;
          highchain_lane_0_9 <= highchain_lane_0_10;
          highchain_lane_0_10 <= highchain_lane_0_11;
          highchain_lane_0_11 <= highchain_lane_0_12;
          highchain_lane_0_12 <= highchain_lane_0_13;
          highchain_lane_0_13 <= highchain_lane_0_14;
          highchain_lane_0_14 <= highchain_lane_0_15;
          highchain_lane_0_15 <= rows_codes_1_0_0;
        end if;
      end if;
      if rows_step_one_1_1 then
        highchain_lane_1_0_choice := compared_tags_6_valid;
      else
        highchain_lane_1_0_choice := rows_step_four_1_1 and compared_tags_6_valid;
      end if;
      if highchain_lane_1_0_choice then
        if rows_step_four_1_1 then
          highchain_lane_1_0 <= highchain_lane_1_4;
          highchain_lane_1_1 <= highchain_lane_1_5;
          highchain_lane_1_2 <= highchain_lane_1_6;
          highchain_lane_1_3 <= highchain_lane_1_7;
          highchain_lane_1_4 <= highchain_lane_1_8;
          highchain_lane_1_5 <= highchain_lane_1_9;
          highchain_lane_1_6 <= highchain_lane_1_10;
          highchain_lane_1_7 <= highchain_lane_1_11;
          highchain_lane_1_8 <= highchain_lane_1_12;
          highchain_lane_1_9 <= highchain_lane_1_13;
          highchain_lane_1_10 <= highchain_lane_1_14;
          highchain_lane_1_11 <= highchain_lane_1_15;
          highchain_lane_1_12 <= rows_codes_1_1_0;
          highchain_lane_1_13 <= rows_codes_1_1_1;
          highchain_lane_1_14 <= rows_codes_1_1_2;
          highchain_lane_1_15 <= rows_codes_1_1_3;
        else
          highchain_lane_1_0 <= highchain_lane_1_1;
          highchain_lane_1_1 <= highchain_lane_1_2;
          highchain_lane_1_2 <= highchain_lane_1_3;
          highchain_lane_1_3 <= highchain_lane_1_4;
          highchain_lane_1_4 <= highchain_lane_1_5;
          highchain_lane_1_5 <= highchain_lane_1_6;
          highchain_lane_1_6 <= highchain_lane_1_7;
          highchain_lane_1_7 <= highchain_lane_1_8;
          highchain_lane_1_8 <= highchain_lane_1_9;
          highchain_lane_1_9 <= highchain_lane_1_10;
          highchain_lane_1_10 <= highchain_lane_1_11;
          highchain_lane_1_11 <= highchain_lane_1_12;
          highchain_lane_1_12 <= highchain_lane_1_13;
          highchain_lane_1_13 <= highchain_lane_1_14;
          highchain_lane_1_14 <= highchain_lane_1_15;
          highchain_lane_1_15 <= rows_codes_1_1_0;
        end if;
      end if;
      -- highcost
      if ((highchain_lane_1_0 / 8) mod 2) = 1 then
        highcost_pixels_first_0_0_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_0_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_0 / 32) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_0_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_0 / 16) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_0_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_0 mod 2) = 1 then
        highcost_pixels_first_0_0_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_0_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_0 / 4) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_0_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_0 / 2) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_0_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_0 / 64) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_0_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_0 / 256) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_0_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_0 / 128) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_0_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_0 / 512) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_0_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_0 / 2048) = 1 then
        highcost_pixels_first_0_0_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_0_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_0 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_0_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_0_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_1 / 8) mod 2) = 1 then
        highcost_pixels_first_0_1_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_1_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_1 / 32) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_1_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_1 / 16) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_1_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_1 mod 2) = 1 then
        highcost_pixels_first_0_1_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_1_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_1 / 4) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_1_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_1 / 2) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_1_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_1 / 64) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_1_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_1 / 256) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_1_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_1 / 128) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_1_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_1 / 512) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_1_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_1 / 2048) = 1 then
        highcost_pixels_first_0_1_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_1_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_1 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_1_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_1_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_2 / 8) mod 2) = 1 then
        highcost_pixels_first_0_2_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_2_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_2 / 32) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_2_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_2 / 16) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_2_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_2 mod 2) = 1 then
        highcost_pixels_first_0_2_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_2_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_2 / 4) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_2_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_2 / 2) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_2_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_2 / 64) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_2_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_2 / 256) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_2_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_2 / 128) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_2_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_2 / 512) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_2_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_2 / 2048) = 1 then
        highcost_pixels_first_0_2_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_2_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_2 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_2_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_2_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_3 / 8) mod 2) = 1 then
        highcost_pixels_first_0_3_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_3_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_3 / 32) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_3_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_3 / 16) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_3_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_3 mod 2) = 1 then
        highcost_pixels_first_0_3_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_3_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_3 / 4) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_3_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_3 / 2) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_3_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_3 / 64) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_3_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_3 / 256) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_3_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_3 / 128) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_3_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_3 / 512) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_3_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_3 / 2048) = 1 then
        highcost_pixels_first_0_3_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_3_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_3 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_3_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_3_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_4 / 8) mod 2) = 1 then
        highcost_pixels_first_0_4_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_4_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_4 / 32) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_4_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_4 / 16) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_4_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_4 mod 2) = 1 then
        highcost_pixels_first_0_4_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_4_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_4 / 4) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_4_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_4 / 2) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_4_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_4 / 64) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_4_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_4 / 256) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_4_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_4 / 128) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_4_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_4 / 512) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_4_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_4 / 2048) = 1 then
        highcost_pixels_first_0_4_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_4_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_4 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_4_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_4_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_5 / 8) mod 2) = 1 then
        highcost_pixels_first_0_5_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_5_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_5 / 32) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_5_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_5 / 16) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_5_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_5 mod 2) = 1 then
        highcost_pixels_first_0_5_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_5_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_5 / 4) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_5_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_5 / 2) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_5_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_5 / 64) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_5_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_5 / 256) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_5_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_5 / 128) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_5_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_5 / 512) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_5_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_5 / 2048) = 1 then
        highcost_pixels_first_0_5_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_5_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_5 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_5_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_5_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_6 / 8) mod 2) = 1 then
        highcost_pixels_first_0_6_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_6_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_6 / 32) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_6_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_6 / 16) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_6_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_6 mod 2) = 1 then
        highcost_pixels_first_0_6_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_6_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_6 / 4) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_6_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_6 / 2) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_6_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_6 / 64) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_6_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_6 / 256) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_6_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_6 / 128) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_6_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_6 / 512) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_6_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_6 / 2048) = 1 then
        highcost_pixels_first_0_6_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_6_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_6 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_6_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_6_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_7 / 8) mod 2) = 1 then
        highcost_pixels_first_0_7_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_7_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_7 / 32) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_7_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_7 / 16) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_7_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_7 mod 2) = 1 then
        highcost_pixels_first_0_7_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_7_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_7 / 4) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_7_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_7 / 2) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_7_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_7 / 64) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_7_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_7 / 256) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_7_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_7 / 128) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_7_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_7 / 512) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_7_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_7 / 2048) = 1 then
        highcost_pixels_first_0_7_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_7_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_7 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_7_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_7_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_8 / 8) mod 2) = 1 then
        highcost_pixels_first_0_8_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_8_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_8 / 32) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_8_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_8 / 16) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_8_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_8 mod 2) = 1 then
        highcost_pixels_first_0_8_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_8_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_8 / 4) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_8_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_8 / 2) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_8_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_8 / 64) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_8_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_8 / 256) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_8_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_8 / 128) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_8_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_8 / 512) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_8_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_8 / 2048) = 1 then
        highcost_pixels_first_0_8_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_8_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_8 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_8_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_8_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_9 / 8) mod 2) = 1 then
        highcost_pixels_first_0_9_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_9_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_9 / 32) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_9_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_9 / 16) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_9_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_9 mod 2) = 1 then
        highcost_pixels_first_0_9_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_9_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_9 / 4) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_9_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_9 / 2) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_9_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_9 / 64) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_9_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_9 / 256) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_9_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_9 / 128) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_9_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_9 / 512) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_9_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_9 / 2048) = 1 then
        highcost_pixels_first_0_9_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_9_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_9 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_9_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_9_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_10 / 8) mod 2) = 1 then
        highcost_pixels_first_0_10_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_10_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_10 / 32) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_10_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_10 / 16) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_10_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_10 mod 2) = 1 then
        highcost_pixels_first_0_10_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_10_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_10 / 4) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_10_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_10 / 2) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_10_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_10 / 64) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_10_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_10 / 256) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_10_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_10 / 128) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_10_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_10 / 512) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_10_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_10 / 2048) = 1 then
        highcost_pixels_first_0_10_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_10_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_10 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_10_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_10_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_11 / 8) mod 2) = 1 then
        highcost_pixels_first_0_11_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_11_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_11 / 32) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_11_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_11 / 16) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_11_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_11 mod 2) = 1 then
        highcost_pixels_first_0_11_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_11_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_11 / 4) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_11_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_11 / 2) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_11_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_11 / 64) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_11_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_11 / 256) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_11_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_11 / 128) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_11_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_11 / 512) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_11_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_11 / 2048) = 1 then
        highcost_pixels_first_0_11_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_11_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_11 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_11_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_11_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_12 / 8) mod 2) = 1 then
        highcost_pixels_first_0_12_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_12_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_12 / 32) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_12_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_12 / 16) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_12_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_12 mod 2) = 1 then
        highcost_pixels_first_0_12_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_12_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_12 / 4) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_12_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_12 / 2) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_12_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_12 / 64) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_12_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_12 / 256) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_12_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_12 / 128) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_12_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_12 / 512) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_12_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_12 / 2048) = 1 then
        highcost_pixels_first_0_12_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_12_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_12 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_12_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_12_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_13 / 8) mod 2) = 1 then
        highcost_pixels_first_0_13_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_13_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_13 / 32) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_13_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_13 / 16) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_13_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_13 mod 2) = 1 then
        highcost_pixels_first_0_13_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_13_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_13 / 4) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_13_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_13 / 2) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_13_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_13 / 64) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_13_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_13 / 256) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_13_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_13 / 128) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_13_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_13 / 512) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_13_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_13 / 2048) = 1 then
        highcost_pixels_first_0_13_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_13_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_13 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_13_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_13_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_14 / 8) mod 2) = 1 then
        highcost_pixels_first_0_14_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_14_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_14 / 32) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_14_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_14 / 16) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_14_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_14 mod 2) = 1 then
        highcost_pixels_first_0_14_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_14_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_14 / 4) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_14_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_14 / 2) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_14_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_14 / 64) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_14_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_14 / 256) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_14_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_14 / 128) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_14_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_14 / 512) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_14_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_14 / 2048) = 1 then
        highcost_pixels_first_0_14_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_14_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_14 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_14_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_14_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_1_15 / 8) mod 2) = 1 then
        highcost_pixels_first_0_15_choice := lowcost_pixels_first_0_1_differs;
      else
        highcost_pixels_first_0_15_choice := lowcost_pixels_first_0_0_value;
      end if;
      if ((highchain_lane_1_15 / 32) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_2 := lowcost_pixels_first_0_1_differs_2;
      else
        highcost_pixels_first_0_15_choice_2 := lowcost_pixels_first_0_0_value_3;
      end if;
      if ((highchain_lane_1_15 / 16) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_3 := lowcost_pixels_first_0_1_differs_3;
      else
        highcost_pixels_first_0_15_choice_3 := lowcost_pixels_first_0_0_value_5;
      end if;
      if (highchain_lane_1_15 mod 2) = 1 then
        highcost_pixels_first_0_15_choice_4 := lowcost_pixels_first_0_1_differs_4;
      else
        highcost_pixels_first_0_15_choice_4 := (compared_held_7_reference_0 mod 2) = 1;
      end if;
      if ((highchain_lane_1_15 / 4) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_5 := lowcost_pixels_first_0_1_differs_5;
      else
        highcost_pixels_first_0_15_choice_5 := lowcost_pixels_first_0_0_value_7;
      end if;
      if ((highchain_lane_1_15 / 2) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_6 := lowcost_pixels_first_0_1_differs_6;
      else
        highcost_pixels_first_0_15_choice_6 := lowcost_pixels_first_0_0_value_9;
      end if;
      if ((highchain_lane_1_15 / 64) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_7 := lowcost_pixels_first_0_1_differs_7;
      else
        highcost_pixels_first_0_15_choice_7 := lowcost_pixels_first_0_0_value_11;
      end if;
      if ((highchain_lane_1_15 / 256) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_8 := lowcost_pixels_first_0_1_differs_8;
      else
        highcost_pixels_first_0_15_choice_8 := lowcost_pixels_first_0_0_value_13;
      end if;
      if ((highchain_lane_1_15 / 128) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_9 := lowcost_pixels_first_0_1_differs_9;
      else
        highcost_pixels_first_0_15_choice_9 := lowcost_pixels_first_0_0_value_15;
      end if;
      if ((highchain_lane_1_15 / 512) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_10 := lowcost_pixels_first_0_1_differs_10;
      else
        highcost_pixels_first_0_15_choice_10 := lowcost_pixels_first_0_0_value_17;
      end if;
      if (highchain_lane_1_15 / 2048) = 1 then
        highcost_pixels_first_0_15_choice_11 := lowcost_pixels_first_0_1_differs_11;
      else
        highcost_pixels_first_0_15_choice_11 := (compared_held_7_reference_0 / 2048) = 1;
      end if;
      if ((highchain_lane_1_15 / 1024) mod 2) = 1 then
        highcost_pixels_first_0_15_choice_12 := lowcost_pixels_first_0_1_differs_12;
      else
        highcost_pixels_first_0_15_choice_12 := lowcost_pixels_first_0_0_value_19;
      end if;
      if ((highchain_lane_0_0 / 8) mod 2) = 1 then
        highcost_pixels_first_1_0_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_0_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_0 / 32) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_0_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_0 / 16) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_0_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_0 mod 2) = 1 then
        highcost_pixels_first_1_0_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_0_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_0 / 4) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_0_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_0 / 2) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_0_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_0 / 64) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_0_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_0 / 256) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_0_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_0 / 128) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_0_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_0 / 512) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_0_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_0 / 2048) = 1 then
        highcost_pixels_first_1_0_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_0_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_0 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_0_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_0_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_1 / 8) mod 2) = 1 then
        highcost_pixels_first_1_1_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_1_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_1 / 32) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_1_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_1 / 16) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_1_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_1 mod 2) = 1 then
        highcost_pixels_first_1_1_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_1_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_1 / 4) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_1_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_1 / 2) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_1_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_1 / 64) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_1_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_1 / 256) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_1_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_1 / 128) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_1_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_1 / 512) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_1_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_1 / 2048) = 1 then
        highcost_pixels_first_1_1_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_1_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_1 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_1_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_1_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_2 / 8) mod 2) = 1 then
        highcost_pixels_first_1_2_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_2_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_2 / 32) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_2_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_2 / 16) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_2_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_2 mod 2) = 1 then
        highcost_pixels_first_1_2_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_2_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_2 / 4) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_2_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_2 / 2) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_2_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_2 / 64) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_2_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_2 / 256) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_2_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_2 / 128) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_2_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_2 / 512) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_2_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_2 / 2048) = 1 then
        highcost_pixels_first_1_2_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_2_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_2 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_2_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_2_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_3 / 8) mod 2) = 1 then
        highcost_pixels_first_1_3_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_3_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_3 / 32) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_3_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_3 / 16) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_3_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_3 mod 2) = 1 then
        highcost_pixels_first_1_3_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_3_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_3 / 4) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_3_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_3 / 2) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_3_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_3 / 64) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_3_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_3 / 256) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_3_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_3 / 128) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_3_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_3 / 512) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_3_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_3 / 2048) = 1 then
        highcost_pixels_first_1_3_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_3_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_3 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_3_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_3_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_4 / 8) mod 2) = 1 then
        highcost_pixels_first_1_4_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_4_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_4 / 32) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_4_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_4 / 16) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_4_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_4 mod 2) = 1 then
        highcost_pixels_first_1_4_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_4_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_4 / 4) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_4_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_4 / 2) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_4_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_4 / 64) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_4_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_4 / 256) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_4_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_4 / 128) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_4_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_4 / 512) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_4_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_4 / 2048) = 1 then
        highcost_pixels_first_1_4_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_4_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_4 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_4_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_4_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_5 / 8) mod 2) = 1 then
        highcost_pixels_first_1_5_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_5_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_5 / 32) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_5_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_5 / 16) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_5_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_5 mod 2) = 1 then
        highcost_pixels_first_1_5_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_5_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_5 / 4) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_5_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_5 / 2) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_5_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_5 / 64) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_5_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_5 / 256) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_5_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_5 / 128) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_5_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_5 / 512) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_5_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_5 / 2048) = 1 then
        highcost_pixels_first_1_5_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_5_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_5 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_5_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_5_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_6 / 8) mod 2) = 1 then
        highcost_pixels_first_1_6_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_6_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_6 / 32) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_6_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_6 / 16) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_6_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_6 mod 2) = 1 then
        highcost_pixels_first_1_6_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_6_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_6 / 4) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_6_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_6 / 2) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_6_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_6 / 64) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_6_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_6 / 256) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_6_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_6 / 128) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_6_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_6 / 512) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_6_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_6 / 2048) = 1 then
        highcost_pixels_first_1_6_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_6_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_6 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_6_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_6_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_7 / 8) mod 2) = 1 then
        highcost_pixels_first_1_7_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_7_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_7 / 32) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_7_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_7 / 16) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_7_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_7 mod 2) = 1 then
        highcost_pixels_first_1_7_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_7_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_7 / 4) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_7_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_7 / 2) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_7_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_7 / 64) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_7_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_7 / 256) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_7_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_7 / 128) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_7_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_7 / 512) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_7_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_7 / 2048) = 1 then
        highcost_pixels_first_1_7_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_7_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_7 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_7_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_7_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_8 / 8) mod 2) = 1 then
        highcost_pixels_first_1_8_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_8_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_8 / 32) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_8_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_8 / 16) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_8_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_8 mod 2) = 1 then
        highcost_pixels_first_1_8_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_8_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_8 / 4) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_8_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_8 / 2) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_8_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_8 / 64) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_8_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_8 / 256) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_8_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_8 / 128) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_8_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_8 / 512) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_8_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_8 / 2048) = 1 then
        highcost_pixels_first_1_8_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_8_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_8 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_8_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_8_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_9 / 8) mod 2) = 1 then
        highcost_pixels_first_1_9_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_9_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_9 / 32) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_9_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_9 / 16) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_9_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_9 mod 2) = 1 then
        highcost_pixels_first_1_9_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_9_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_9 / 4) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_9_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_9 / 2) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_9_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_9 / 64) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_9_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_9 / 256) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_9_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_9 / 128) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_9_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_9 / 512) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_9_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_9 / 2048) = 1 then
        highcost_pixels_first_1_9_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_9_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_9 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_9_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_9_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_10 / 8) mod 2) = 1 then
        highcost_pixels_first_1_10_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_10_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_10 / 32) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_10_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_10 / 16) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_10_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_10 mod 2) = 1 then
        highcost_pixels_first_1_10_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_10_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_10 / 4) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_10_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_10 / 2) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_10_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_10 / 64) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_10_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_10 / 256) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_10_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_10 / 128) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_10_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_10 / 512) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_10_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_10 / 2048) = 1 then
        highcost_pixels_first_1_10_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_10_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_10 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_10_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_10_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_11 / 8) mod 2) = 1 then
        highcost_pixels_first_1_11_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_11_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_11 / 32) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_11_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_11 / 16) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_11_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_11 mod 2) = 1 then
        highcost_pixels_first_1_11_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_11_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_11 / 4) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_11_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_11 / 2) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_11_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_11 / 64) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_11_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_11 / 256) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_11_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_11 / 128) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_11_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_11 / 512) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_11_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_11 / 2048) = 1 then
        highcost_pixels_first_1_11_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_11_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_11 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_11_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_11_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_12 / 8) mod 2) = 1 then
        highcost_pixels_first_1_12_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_12_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_12 / 32) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_12_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_12 / 16) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_12_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_12 mod 2) = 1 then
        highcost_pixels_first_1_12_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_12_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_12 / 4) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_12_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_12 / 2) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_12_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_12 / 64) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_12_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_12 / 256) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_12_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_12 / 128) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_12_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_12 / 512) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_12_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_12 / 2048) = 1 then
        highcost_pixels_first_1_12_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_12_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_12 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_12_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_12_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_13 / 8) mod 2) = 1 then
        highcost_pixels_first_1_13_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_13_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_13 / 32) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_13_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_13 / 16) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_13_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_13 mod 2) = 1 then
        highcost_pixels_first_1_13_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_13_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_13 / 4) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_13_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_13 / 2) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_13_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_13 / 64) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_13_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_13 / 256) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_13_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_13 / 128) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_13_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_13 / 512) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_13_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_13 / 2048) = 1 then
        highcost_pixels_first_1_13_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_13_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_13 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_13_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_13_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_14 / 8) mod 2) = 1 then
        highcost_pixels_first_1_14_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_14_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_14 / 32) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_14_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_14 / 16) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_14_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_14 mod 2) = 1 then
        highcost_pixels_first_1_14_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_14_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_14 / 4) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_14_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_14 / 2) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_14_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_14 / 64) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_14_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_14 / 256) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_14_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_14 / 128) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_14_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_14 / 512) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_14_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_14 / 2048) = 1 then
        highcost_pixels_first_1_14_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_14_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_14 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_14_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_14_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if ((highchain_lane_0_15 / 8) mod 2) = 1 then
        highcost_pixels_first_1_15_choice := lowcost_pixels_first_1_1_differs;
      else
        highcost_pixels_first_1_15_choice := lowcost_pixels_first_1_0_value;
      end if;
      if ((highchain_lane_0_15 / 32) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_2 := lowcost_pixels_first_1_1_differs_2;
      else
        highcost_pixels_first_1_15_choice_2 := lowcost_pixels_first_1_0_value_3;
      end if;
      if ((highchain_lane_0_15 / 16) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_3 := lowcost_pixels_first_1_1_differs_3;
      else
        highcost_pixels_first_1_15_choice_3 := lowcost_pixels_first_1_0_value_5;
      end if;
      if (highchain_lane_0_15 mod 2) = 1 then
        highcost_pixels_first_1_15_choice_4 := lowcost_pixels_first_1_1_differs_4;
      else
        highcost_pixels_first_1_15_choice_4 := (compared_held_7_reference_1 mod 2) = 1;
      end if;
      if ((highchain_lane_0_15 / 4) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_5 := lowcost_pixels_first_1_1_differs_5;
      else
        highcost_pixels_first_1_15_choice_5 := lowcost_pixels_first_1_0_value_7;
      end if;
      if ((highchain_lane_0_15 / 2) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_6 := lowcost_pixels_first_1_1_differs_6;
      else
        highcost_pixels_first_1_15_choice_6 := lowcost_pixels_first_1_0_value_9;
      end if;
      if ((highchain_lane_0_15 / 64) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_7 := lowcost_pixels_first_1_1_differs_7;
      else
        highcost_pixels_first_1_15_choice_7 := lowcost_pixels_first_1_0_value_11;
      end if;
      if ((highchain_lane_0_15 / 256) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_8 := lowcost_pixels_first_1_1_differs_8;
      else
        highcost_pixels_first_1_15_choice_8 := lowcost_pixels_first_1_0_value_13;
      end if;
      if ((highchain_lane_0_15 / 128) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_9 := lowcost_pixels_first_1_1_differs_9;
      else
        highcost_pixels_first_1_15_choice_9 := lowcost_pixels_first_1_0_value_15;
      end if;
      if ((highchain_lane_0_15 / 512) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_10 := lowcost_pixels_first_1_1_differs_10;
      else
        highcost_pixels_first_1_15_choice_10 := lowcost_pixels_first_1_0_value_17;
      end if;
      if (highchain_lane_0_15 / 2048) = 1 then
        highcost_pixels_first_1_15_choice_11 := lowcost_pixels_first_1_1_differs_11;
      else
        highcost_pixels_first_1_15_choice_11 := (compared_held_7_reference_1 / 2048) = 1;
      end if;
      if ((highchain_lane_0_15 / 1024) mod 2) = 1 then
        highcost_pixels_first_1_15_choice_12 := lowcost_pixels_first_1_1_differs_12;
      else
        highcost_pixels_first_1_15_choice_12 := lowcost_pixels_first_1_0_value_19;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_0_choice := 0;
      else
        highcost_column_0_0_choice := highcost_ready_words_0 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_0_choice_2 := 0;
      else
        highcost_column_0_0_choice_2 := (highcost_change_0_0 + highcost_column_0_0_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_1_choice := 0;
      else
        highcost_column_0_1_choice := (highcost_ready_words_0 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_1_choice_2 := 0;
      else
        highcost_column_0_1_choice_2 := (highcost_change_0_1 + highcost_column_0_1_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_2_choice := 0;
      else
        highcost_column_0_2_choice := (highcost_ready_words_0 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_2_choice_2 := 0;
      else
        highcost_column_0_2_choice_2 := (highcost_change_0_2 + highcost_column_0_2_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_3_choice := 0;
      else
        highcost_column_0_3_choice := highcost_ready_words_0 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_3_choice_2 := 0;
      else
        highcost_column_0_3_choice_2 := (highcost_change_0_3 + highcost_column_0_3_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_4_choice := 0;
      else
        highcost_column_0_4_choice := highcost_ready_words_1 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_4_choice_2 := 0;
      else
        highcost_column_0_4_choice_2 := (highcost_change_0_4 + highcost_column_0_4_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_5_choice := 0;
      else
        highcost_column_0_5_choice := (highcost_ready_words_1 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_5_choice_2 := 0;
      else
        highcost_column_0_5_choice_2 := (highcost_change_0_5 + highcost_column_0_5_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_6_choice := 0;
      else
        highcost_column_0_6_choice := (highcost_ready_words_1 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_6_choice_2 := 0;
      else
        highcost_column_0_6_choice_2 := (highcost_change_0_6 + highcost_column_0_6_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_7_choice := 0;
      else
        highcost_column_0_7_choice := highcost_ready_words_1 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_7_choice_2 := 0;
      else
        highcost_column_0_7_choice_2 := (highcost_change_0_7 + highcost_column_0_7_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_8_choice := 0;
      else
        highcost_column_0_8_choice := highcost_ready_words_2 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_8_choice_2 := 0;
      else
        highcost_column_0_8_choice_2 := (highcost_change_0_8 + highcost_column_0_8_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_9_choice := 0;
      else
        highcost_column_0_9_choice := (highcost_ready_words_2 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_9_choice_2 := 0;
      else
        highcost_column_0_9_choice_2 := (highcost_change_0_9 + highcost_column_0_9_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_10_choice := 0;
      else
        highcost_column_0_10_choice := (highcost_ready_words_2 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_10_choice_2 := 0;
      else
        highcost_column_0_10_choice_2 := (highcost_change_0_10 + highcost_column_0_10_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_11_choice := 0;
      else
        highcost_column_0_11_choice := highcost_ready_words_2 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_11_choice_2 := 0;
      else
        highcost_column_0_11_choice_2 := (highcost_change_0_11 + highcost_column_0_11_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_12_choice := 0;
      else
        highcost_column_0_12_choice := highcost_ready_words_3 mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_12_choice_2 := 0;
      else
        highcost_column_0_12_choice_2 := (highcost_change_0_12 + highcost_column_0_12_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_13_choice := 0;
      else
        highcost_column_0_13_choice := (highcost_ready_words_3 / 128) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_13_choice_2 := 0;
      else
        highcost_column_0_13_choice_2 := (highcost_change_0_13 + highcost_column_0_13_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_14_choice := 0;
      else
        highcost_column_0_14_choice := (highcost_ready_words_3 / 16384) mod 128;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_14_choice_2 := 0;
      else
        highcost_column_0_14_choice_2 := (highcost_change_0_14 + highcost_column_0_14_choice) mod 128;
      end if;
      if lowcost_ready_tag_first_group then
        highcost_column_0_15_choice := 0;
      else
        highcost_column_0_15_choice := highcost_ready_words_3 / 2097152;
      end if;
      if lowcost_ready_tag_border_column then
        highcost_column_0_15_choice_2 := 0;
      else
        highcost_column_0_15_choice_2 := (highcost_change_0_15 + highcost_column_0_15_choice) mod 128;
      end if;
      highcost_pixels_first_0_0 <= ((as_number(highcost_pixels_first_0_0_choice) +
        as_number(highcost_pixels_first_0_0_choice_2) + as_number(highcost_pixels_first_0_0_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_0_choice_4) + as_number(highcost_pixels_first_0_0_choice_5) +
        as_number(highcost_pixels_first_0_0_choice_6) + ((as_number(highcost_pixels_first_0_0_choice_7) +
        as_number(highcost_pixels_first_0_0_choice_8) + as_number(highcost_pixels_first_0_0_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_0_choice_10) + as_number(highcost_pixels_first_0_0_choice_11) +
        as_number(highcost_pixels_first_0_0_choice_12)) * 64);
      highcost_pixels_first_0_1 <= ((as_number(highcost_pixels_first_0_1_choice) +
        as_number(highcost_pixels_first_0_1_choice_2) + as_number(highcost_pixels_first_0_1_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_1_choice_4) + as_number(highcost_pixels_first_0_1_choice_5) +
        as_number(highcost_pixels_first_0_1_choice_6) + ((as_number(highcost_pixels_first_0_1_choice_7) +
        as_number(highcost_pixels_first_0_1_choice_8) + as_number(highcost_pixels_first_0_1_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_1_choice_10) + as_number(highcost_pixels_first_0_1_choice_11) +
        as_number(highcost_pixels_first_0_1_choice_12)) * 64);
      highcost_pixels_first_0_2 <= ((as_number(highcost_pixels_first_0_2_choice) +
        as_number(highcost_pixels_first_0_2_choice_2) + as_number(highcost_pixels_first_0_2_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_2_choice_4) + as_number(highcost_pixels_first_0_2_choice_5) +
        as_number(highcost_pixels_first_0_2_choice_6) + ((as_number(highcost_pixels_first_0_2_choice_7) +
        as_number(highcost_pixels_first_0_2_choice_8) + as_number(highcost_pixels_first_0_2_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_2_choice_10) + as_number(highcost_pixels_first_0_2_choice_11) +
        as_number(highcost_pixels_first_0_2_choice_12)) * 64);
      highcost_pixels_first_0_3 <= ((as_number(highcost_pixels_first_0_3_choice) +
        as_number(highcost_pixels_first_0_3_choice_2) + as_number(highcost_pixels_first_0_3_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_3_choice_4) + as_number(highcost_pixels_first_0_3_choice_5) +
        as_number(highcost_pixels_first_0_3_choice_6) + ((as_number(highcost_pixels_first_0_3_choice_7) +
        as_number(highcost_pixels_first_0_3_choice_8) + as_number(highcost_pixels_first_0_3_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_3_choice_10) + as_number(highcost_pixels_first_0_3_choice_11) +
        as_number(highcost_pixels_first_0_3_choice_12)) * 64);
      highcost_pixels_first_0_4 <= ((as_number(highcost_pixels_first_0_4_choice) +
        as_number(highcost_pixels_first_0_4_choice_2) + as_number(highcost_pixels_first_0_4_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_4_choice_4) + as_number(highcost_pixels_first_0_4_choice_5) +
        as_number(highcost_pixels_first_0_4_choice_6) + ((as_number(highcost_pixels_first_0_4_choice_7) +
        as_number(highcost_pixels_first_0_4_choice_8) + as_number(highcost_pixels_first_0_4_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_4_choice_10) + as_number(highcost_pixels_first_0_4_choice_11) +
        as_number(highcost_pixels_first_0_4_choice_12)) * 64);
      highcost_pixels_first_0_5 <= ((as_number(highcost_pixels_first_0_5_choice) +
        as_number(highcost_pixels_first_0_5_choice_2) + as_number(highcost_pixels_first_0_5_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_5_choice_4) + as_number(highcost_pixels_first_0_5_choice_5) +
        as_number(highcost_pixels_first_0_5_choice_6) + ((as_number(highcost_pixels_first_0_5_choice_7) +
        as_number(highcost_pixels_first_0_5_choice_8) + as_number(highcost_pixels_first_0_5_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_5_choice_10) + as_number(highcost_pixels_first_0_5_choice_11) +
        as_number(highcost_pixels_first_0_5_choice_12)) * 64);
      highcost_pixels_first_0_6 <= ((as_number(highcost_pixels_first_0_6_choice) +
        as_number(highcost_pixels_first_0_6_choice_2) + as_number(highcost_pixels_first_0_6_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_6_choice_4) + as_number(highcost_pixels_first_0_6_choice_5) +
        as_number(highcost_pixels_first_0_6_choice_6) + ((as_number(highcost_pixels_first_0_6_choice_7) +
        as_number(highcost_pixels_first_0_6_choice_8) + as_number(highcost_pixels_first_0_6_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_6_choice_10) + as_number(highcost_pixels_first_0_6_choice_11) +
        as_number(highcost_pixels_first_0_6_choice_12)) * 64);
      highcost_pixels_first_0_7 <= ((as_number(highcost_pixels_first_0_7_choice) +
        as_number(highcost_pixels_first_0_7_choice_2) + as_number(highcost_pixels_first_0_7_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_7_choice_4) + as_number(highcost_pixels_first_0_7_choice_5) +
        as_number(highcost_pixels_first_0_7_choice_6) + ((as_number(highcost_pixels_first_0_7_choice_7) +
        as_number(highcost_pixels_first_0_7_choice_8) + as_number(highcost_pixels_first_0_7_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_7_choice_10) + as_number(highcost_pixels_first_0_7_choice_11) +
        as_number(highcost_pixels_first_0_7_choice_12)) * 64);
      highcost_pixels_first_0_8 <= ((as_number(highcost_pixels_first_0_8_choice) +
        as_number(highcost_pixels_first_0_8_choice_2) + as_number(highcost_pixels_first_0_8_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_8_choice_4) + as_number(highcost_pixels_first_0_8_choice_5) +
        as_number(highcost_pixels_first_0_8_choice_6) + ((as_number(highcost_pixels_first_0_8_choice_7) +
        as_number(highcost_pixels_first_0_8_choice_8) + as_number(highcost_pixels_first_0_8_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_8_choice_10) + as_number(highcost_pixels_first_0_8_choice_11) +
        as_number(highcost_pixels_first_0_8_choice_12)) * 64);
      highcost_pixels_first_0_9 <= ((as_number(highcost_pixels_first_0_9_choice) +
        as_number(highcost_pixels_first_0_9_choice_2) + as_number(highcost_pixels_first_0_9_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_9_choice_4) + as_number(highcost_pixels_first_0_9_choice_5) +
        as_number(highcost_pixels_first_0_9_choice_6) + ((as_number(highcost_pixels_first_0_9_choice_7) +
        as_number(highcost_pixels_first_0_9_choice_8) + as_number(highcost_pixels_first_0_9_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_9_choice_10) + as_number(highcost_pixels_first_0_9_choice_11) +
        as_number(highcost_pixels_first_0_9_choice_12)) * 64);
      highcost_pixels_first_0_10 <= ((as_number(highcost_pixels_first_0_10_choice) +
        as_number(highcost_pixels_first_0_10_choice_2) + as_number(highcost_pixels_first_0_10_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_10_choice_4) + as_number(highcost_pixels_first_0_10_choice_5) +
        as_number(highcost_pixels_first_0_10_choice_6) + ((as_number(highcost_pixels_first_0_10_choice_7) +
        as_number(highcost_pixels_first_0_10_choice_8) + as_number(highcost_pixels_first_0_10_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_10_choice_10) + as_number(highcost_pixels_first_0_10_choice_11) +
        as_number(highcost_pixels_first_0_10_choice_12)) * 64);
      highcost_pixels_first_0_11 <= ((as_number(highcost_pixels_first_0_11_choice) +
        as_number(highcost_pixels_first_0_11_choice_2) + as_number(highcost_pixels_first_0_11_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_11_choice_4) + as_number(highcost_pixels_first_0_11_choice_5) +
        as_number(highcost_pixels_first_0_11_choice_6) + ((as_number(highcost_pixels_first_0_11_choice_7) +
        as_number(highcost_pixels_first_0_11_choice_8) + as_number(highcost_pixels_first_0_11_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_11_choice_10) + as_number(highcost_pixels_first_0_11_choice_11) +
        as_number(highcost_pixels_first_0_11_choice_12)) * 64);
      highcost_pixels_first_0_12 <= ((as_number(highcost_pixels_first_0_12_choice) +
        as_number(highcost_pixels_first_0_12_choice_2) + as_number(highcost_pixels_first_0_12_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_12_choice_4) + as_number(highcost_pixels_first_0_12_choice_5) +
        as_number(highcost_pixels_first_0_12_choice_6) + ((as_number(highcost_pixels_first_0_12_choice_7) +
        as_number(highcost_pixels_first_0_12_choice_8) + as_number(highcost_pixels_first_0_12_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_12_choice_10) + as_number(highcost_pixels_first_0_12_choice_11) +
        as_number(highcost_pixels_first_0_12_choice_12)) * 64);
      highcost_pixels_first_0_13 <= ((as_number(highcost_pixels_first_0_13_choice) +
        as_number(highcost_pixels_first_0_13_choice_2) + as_number(highcost_pixels_first_0_13_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_13_choice_4) + as_number(highcost_pixels_first_0_13_choice_5) +
        as_number(highcost_pixels_first_0_13_choice_6) + ((as_number(highcost_pixels_first_0_13_choice_7) +
        as_number(highcost_pixels_first_0_13_choice_8) + as_number(highcost_pixels_first_0_13_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_13_choice_10) + as_number(highcost_pixels_first_0_13_choice_11) +
        as_number(highcost_pixels_first_0_13_choice_12)) * 64);
      highcost_pixels_first_0_14 <= ((as_number(highcost_pixels_first_0_14_choice) +
        as_number(highcost_pixels_first_0_14_choice_2) + as_number(highcost_pixels_first_0_14_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_14_choice_4) + as_number(highcost_pixels_first_0_14_choice_5) +
        as_number(highcost_pixels_first_0_14_choice_6) + ((as_number(highcost_pixels_first_0_14_choice_7) +
        as_number(highcost_pixels_first_0_14_choice_8) + as_number(highcost_pixels_first_0_14_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_14_choice_10) + as_number(highcost_pixels_first_0_14_choice_11) +
        as_number(highcost_pixels_first_0_14_choice_12)) * 64);
      highcost_pixels_first_0_15 <= ((as_number(highcost_pixels_first_0_15_choice) +
        as_number(highcost_pixels_first_0_15_choice_2) + as_number(highcost_pixels_first_0_15_choice_3)) * 4) +
        as_number(highcost_pixels_first_0_15_choice_4) + as_number(highcost_pixels_first_0_15_choice_5) +
        as_number(highcost_pixels_first_0_15_choice_6) + ((as_number(highcost_pixels_first_0_15_choice_7) +
        as_number(highcost_pixels_first_0_15_choice_8) + as_number(highcost_pixels_first_0_15_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_0_15_choice_10) + as_number(highcost_pixels_first_0_15_choice_11) +
        as_number(highcost_pixels_first_0_15_choice_12)) * 64);
      highcost_pixels_first_1_0 <= ((as_number(highcost_pixels_first_1_0_choice) +
        as_number(highcost_pixels_first_1_0_choice_2) + as_number(highcost_pixels_first_1_0_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_0_choice_4) + as_number(highcost_pixels_first_1_0_choice_5) +
        as_number(highcost_pixels_first_1_0_choice_6) + ((as_number(highcost_pixels_first_1_0_choice_7) +
        as_number(highcost_pixels_first_1_0_choice_8) + as_number(highcost_pixels_first_1_0_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_0_choice_10) + as_number(highcost_pixels_first_1_0_choice_11) +
        as_number(highcost_pixels_first_1_0_choice_12)) * 64);
      highcost_pixels_first_1_1 <= ((as_number(highcost_pixels_first_1_1_choice) +
        as_number(highcost_pixels_first_1_1_choice_2) + as_number(highcost_pixels_first_1_1_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_1_choice_4) + as_number(highcost_pixels_first_1_1_choice_5) +
        as_number(highcost_pixels_first_1_1_choice_6) + ((as_number(highcost_pixels_first_1_1_choice_7) +
        as_number(highcost_pixels_first_1_1_choice_8) + as_number(highcost_pixels_first_1_1_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_1_choice_10) + as_number(highcost_pixels_first_1_1_choice_11) +
        as_number(highcost_pixels_first_1_1_choice_12)) * 64);
      highcost_pixels_first_1_2 <= ((as_number(highcost_pixels_first_1_2_choice) +
        as_number(highcost_pixels_first_1_2_choice_2) + as_number(highcost_pixels_first_1_2_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_2_choice_4) + as_number(highcost_pixels_first_1_2_choice_5) +
        as_number(highcost_pixels_first_1_2_choice_6) + ((as_number(highcost_pixels_first_1_2_choice_7) +
        as_number(highcost_pixels_first_1_2_choice_8) + as_number(highcost_pixels_first_1_2_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_2_choice_10) + as_number(highcost_pixels_first_1_2_choice_11) +
        as_number(highcost_pixels_first_1_2_choice_12)) * 64);
      highcost_pixels_first_1_3 <= ((as_number(highcost_pixels_first_1_3_choice) +
        as_number(highcost_pixels_first_1_3_choice_2) + as_number(highcost_pixels_first_1_3_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_3_choice_4) + as_number(highcost_pixels_first_1_3_choice_5) +
        as_number(highcost_pixels_first_1_3_choice_6) + ((as_number(highcost_pixels_first_1_3_choice_7) +
        as_number(highcost_pixels_first_1_3_choice_8) + as_number(highcost_pixels_first_1_3_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_3_choice_10) + as_number(highcost_pixels_first_1_3_choice_11) +
        as_number(highcost_pixels_first_1_3_choice_12)) * 64);
      highcost_pixels_first_1_4 <= ((as_number(highcost_pixels_first_1_4_choice) +
        as_number(highcost_pixels_first_1_4_choice_2) + as_number(highcost_pixels_first_1_4_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_4_choice_4) + as_number(highcost_pixels_first_1_4_choice_5) +
        as_number(highcost_pixels_first_1_4_choice_6) + ((as_number(highcost_pixels_first_1_4_choice_7) +
        as_number(highcost_pixels_first_1_4_choice_8) + as_number(highcost_pixels_first_1_4_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_4_choice_10) + as_number(highcost_pixels_first_1_4_choice_11) +
        as_number(highcost_pixels_first_1_4_choice_12)) * 64);
      highcost_pixels_first_1_5 <= ((as_number(highcost_pixels_first_1_5_choice) +
        as_number(highcost_pixels_first_1_5_choice_2) + as_number(highcost_pixels_first_1_5_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_5_choice_4) + as_number(highcost_pixels_first_1_5_choice_5) +
        as_number(highcost_pixels_first_1_5_choice_6) + ((as_number(highcost_pixels_first_1_5_choice_7) +
        as_number(highcost_pixels_first_1_5_choice_8) + as_number(highcost_pixels_first_1_5_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_5_choice_10) + as_number(highcost_pixels_first_1_5_choice_11) +
        as_number(highcost_pixels_first_1_5_choice_12)) * 64);
      highcost_pixels_first_1_6 <= ((as_number(highcost_pixels_first_1_6_choice) +
        as_number(highcost_pixels_first_1_6_choice_2) + as_number(highcost_pixels_first_1_6_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_6_choice_4) + as_number(highcost_pixels_first_1_6_choice_5) +
        as_number(highcost_pixels_first_1_6_choice_6) + ((as_number(highcost_pixels_first_1_6_choice_7) +
        as_number(highcost_pixels_first_1_6_choice_8) + as_number(highcost_pixels_first_1_6_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_6_choice_10) + as_number(highcost_pixels_first_1_6_choice_11) +
        as_number(highcost_pixels_first_1_6_choice_12)) * 64);
      highcost_pixels_first_1_7 <= ((as_number(highcost_pixels_first_1_7_choice) +
        as_number(highcost_pixels_first_1_7_choice_2) + as_number(highcost_pixels_first_1_7_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_7_choice_4) + as_number(highcost_pixels_first_1_7_choice_5) +
        as_number(highcost_pixels_first_1_7_choice_6) + ((as_number(highcost_pixels_first_1_7_choice_7) +
        as_number(highcost_pixels_first_1_7_choice_8) + as_number(highcost_pixels_first_1_7_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_7_choice_10) + as_number(highcost_pixels_first_1_7_choice_11) +
        as_number(highcost_pixels_first_1_7_choice_12)) * 64);
      highcost_pixels_first_1_8 <= ((as_number(highcost_pixels_first_1_8_choice) +
        as_number(highcost_pixels_first_1_8_choice_2) + as_number(highcost_pixels_first_1_8_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_8_choice_4) + as_number(highcost_pixels_first_1_8_choice_5) +
        as_number(highcost_pixels_first_1_8_choice_6) + ((as_number(highcost_pixels_first_1_8_choice_7) +
        as_number(highcost_pixels_first_1_8_choice_8) + as_number(highcost_pixels_first_1_8_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_8_choice_10) + as_number(highcost_pixels_first_1_8_choice_11) +
        as_number(highcost_pixels_first_1_8_choice_12)) * 64);
      highcost_pixels_first_1_9 <= ((as_number(highcost_pixels_first_1_9_choice) +
        as_number(highcost_pixels_first_1_9_choice_2) + as_number(highcost_pixels_first_1_9_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_9_choice_4) + as_number(highcost_pixels_first_1_9_choice_5) +
        as_number(highcost_pixels_first_1_9_choice_6) + ((as_number(highcost_pixels_first_1_9_choice_7) +
        as_number(highcost_pixels_first_1_9_choice_8) + as_number(highcost_pixels_first_1_9_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_9_choice_10) + as_number(highcost_pixels_first_1_9_choice_11) +
        as_number(highcost_pixels_first_1_9_choice_12)) * 64);
      highcost_pixels_first_1_10 <= ((as_number(highcost_pixels_first_1_10_choice) +
        as_number(highcost_pixels_first_1_10_choice_2) + as_number(highcost_pixels_first_1_10_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_10_choice_4) + as_number(highcost_pixels_first_1_10_choice_5) +
        as_number(highcost_pixels_first_1_10_choice_6) + ((as_number(highcost_pixels_first_1_10_choice_7) +
        as_number(highcost_pixels_first_1_10_choice_8) + as_number(highcost_pixels_first_1_10_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_10_choice_10) + as_number(highcost_pixels_first_1_10_choice_11) +
        as_number(highcost_pixels_first_1_10_choice_12)) * 64);
      highcost_pixels_first_1_11 <= ((as_number(highcost_pixels_first_1_11_choice) +
        as_number(highcost_pixels_first_1_11_choice_2) + as_number(highcost_pixels_first_1_11_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_11_choice_4) + as_number(highcost_pixels_first_1_11_choice_5) +
        as_number(highcost_pixels_first_1_11_choice_6) + ((as_number(highcost_pixels_first_1_11_choice_7) +
        as_number(highcost_pixels_first_1_11_choice_8) + as_number(highcost_pixels_first_1_11_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_11_choice_10) + as_number(highcost_pixels_first_1_11_choice_11) +
        as_number(highcost_pixels_first_1_11_choice_12)) * 64);
      highcost_pixels_first_1_12 <= ((as_number(highcost_pixels_first_1_12_choice) +
        as_number(highcost_pixels_first_1_12_choice_2) + as_number(highcost_pixels_first_1_12_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_12_choice_4) + as_number(highcost_pixels_first_1_12_choice_5) +
        as_number(highcost_pixels_first_1_12_choice_6) + ((as_number(highcost_pixels_first_1_12_choice_7) +
        as_number(highcost_pixels_first_1_12_choice_8) + as_number(highcost_pixels_first_1_12_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_12_choice_10) + as_number(highcost_pixels_first_1_12_choice_11) +
        as_number(highcost_pixels_first_1_12_choice_12)) * 64);
      highcost_pixels_first_1_13 <= ((as_number(highcost_pixels_first_1_13_choice) +
        as_number(highcost_pixels_first_1_13_choice_2) + as_number(highcost_pixels_first_1_13_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_13_choice_4) + as_number(highcost_pixels_first_1_13_choice_5) +
        as_number(highcost_pixels_first_1_13_choice_6) + ((as_number(highcost_pixels_first_1_13_choice_7) +
        as_number(highcost_pixels_first_1_13_choice_8) + as_number(highcost_pixels_first_1_13_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_13_choice_10) + as_number(highcost_pixels_first_1_13_choice_11) +
        as_number(highcost_pixels_first_1_13_choice_12)) * 64);
      highcost_pixels_first_1_14 <= ((as_number(highcost_pixels_first_1_14_choice) +
        as_number(highcost_pixels_first_1_14_choice_2) + as_number(highcost_pixels_first_1_14_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_14_choice_4) + as_number(highcost_pixels_first_1_14_choice_5) +
        as_number(highcost_pixels_first_1_14_choice_6) + ((as_number(highcost_pixels_first_1_14_choice_7) +
        as_number(highcost_pixels_first_1_14_choice_8) + as_number(highcost_pixels_first_1_14_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_14_choice_10) + as_number(highcost_pixels_first_1_14_choice_11) +
        as_number(highcost_pixels_first_1_14_choice_12)) * 64);
      highcost_pixels_first_1_15 <= ((as_number(highcost_pixels_first_1_15_choice) +
        as_number(highcost_pixels_first_1_15_choice_2) + as_number(highcost_pixels_first_1_15_choice_3)) * 4) +
        as_number(highcost_pixels_first_1_15_choice_4) + as_number(highcost_pixels_first_1_15_choice_5) +
        as_number(highcost_pixels_first_1_15_choice_6) + ((as_number(highcost_pixels_first_1_15_choice_7) +
        as_number(highcost_pixels_first_1_15_choice_8) + as_number(highcost_pixels_first_1_15_choice_9)) * 16) +
        ((as_number(highcost_pixels_first_1_15_choice_10) + as_number(highcost_pixels_first_1_15_choice_11) +
        as_number(highcost_pixels_first_1_15_choice_12)) * 64);
      highcost_pixels_cost_0_0 <= (((highcost_pixels_first_0_0 mod 4) + (((highcost_pixels_first_0_0 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_0 / 16) mod 4) + (highcost_pixels_first_0_0 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_0 / 16) + (highcost_pixels_first_0_0 / 64)) mod 2);
      highcost_pixels_cost_0_1 <= (((highcost_pixels_first_0_1 mod 4) + (((highcost_pixels_first_0_1 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_1 / 16) mod 4) + (highcost_pixels_first_0_1 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_1 / 16) + (highcost_pixels_first_0_1 / 64)) mod 2);
      highcost_pixels_cost_0_2 <= (((highcost_pixels_first_0_2 mod 4) + (((highcost_pixels_first_0_2 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_2 / 16) mod 4) + (highcost_pixels_first_0_2 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_2 / 16) + (highcost_pixels_first_0_2 / 64)) mod 2);
      highcost_pixels_cost_0_3 <= (((highcost_pixels_first_0_3 mod 4) + (((highcost_pixels_first_0_3 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_3 / 16) mod 4) + (highcost_pixels_first_0_3 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_3 / 16) + (highcost_pixels_first_0_3 / 64)) mod 2);
      highcost_pixels_cost_0_4 <= (((highcost_pixels_first_0_4 mod 4) + (((highcost_pixels_first_0_4 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_4 / 16) mod 4) + (highcost_pixels_first_0_4 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_4 / 16) + (highcost_pixels_first_0_4 / 64)) mod 2);
      highcost_pixels_cost_0_5 <= (((highcost_pixels_first_0_5 mod 4) + (((highcost_pixels_first_0_5 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_5 / 16) mod 4) + (highcost_pixels_first_0_5 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_5 / 16) + (highcost_pixels_first_0_5 / 64)) mod 2);
      highcost_pixels_cost_0_6 <= (((highcost_pixels_first_0_6 mod 4) + (((highcost_pixels_first_0_6 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_6 / 16) mod 4) + (highcost_pixels_first_0_6 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_6 / 16) + (highcost_pixels_first_0_6 / 64)) mod 2);
      highcost_pixels_cost_0_7 <= (((highcost_pixels_first_0_7 mod 4) + (((highcost_pixels_first_0_7 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_7 / 16) mod 4) + (highcost_pixels_first_0_7 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_7 / 16) + (highcost_pixels_first_0_7 / 64)) mod 2);
      highcost_pixels_cost_0_8 <= (((highcost_pixels_first_0_8 mod 4) + (((highcost_pixels_first_0_8 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_8 / 16) mod 4) + (highcost_pixels_first_0_8 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_8 / 16) + (highcost_pixels_first_0_8 / 64)) mod 2);
      highcost_pixels_cost_0_9 <= (((highcost_pixels_first_0_9 mod 4) + (((highcost_pixels_first_0_9 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_0_9 / 16) mod 4) + (highcost_pixels_first_0_9 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_9 / 16) + (highcost_pixels_first_0_9 / 64)) mod 2);
      highcost_pixels_cost_0_10 <= (((highcost_pixels_first_0_10 mod 4) + (((highcost_pixels_first_0_10 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_10 / 16) mod 4) + (highcost_pixels_first_0_10 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_10 / 16) + (highcost_pixels_first_0_10 / 64)) mod 2);
      highcost_pixels_cost_0_11 <= (((highcost_pixels_first_0_11 mod 4) + (((highcost_pixels_first_0_11 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_11 / 16) mod 4) + (highcost_pixels_first_0_11 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_11 / 16) + (highcost_pixels_first_0_11 / 64)) mod 2);
      highcost_pixels_cost_0_12 <= (((highcost_pixels_first_0_12 mod 4) + (((highcost_pixels_first_0_12 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_12 / 16) mod 4) + (highcost_pixels_first_0_12 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_12 / 16) + (highcost_pixels_first_0_12 / 64)) mod 2);
      highcost_pixels_cost_0_13 <= (((highcost_pixels_first_0_13 mod 4) + (((highcost_pixels_first_0_13 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_13 / 16) mod 4) + (highcost_pixels_first_0_13 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_13 / 16) + (highcost_pixels_first_0_13 / 64)) mod 2);
      highcost_pixels_cost_0_14 <= (((highcost_pixels_first_0_14 mod 4) + (((highcost_pixels_first_0_14 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_14 / 16) mod 4) + (highcost_pixels_first_0_14 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_14 / 16) + (highcost_pixels_first_0_14 / 64)) mod 2);
      highcost_pixels_cost_0_15 <= (((highcost_pixels_first_0_15 mod 4) + (((highcost_pixels_first_0_15 / 2) mod 8) /
        2) + ((((highcost_pixels_first_0_15 / 16) mod 4) + (highcost_pixels_first_0_15 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_0_15 / 16) + (highcost_pixels_first_0_15 / 64)) mod 2);
      highcost_pixels_cost_1_0 <= (((highcost_pixels_first_1_0 mod 4) + (((highcost_pixels_first_1_0 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_0 / 16) mod 4) + (highcost_pixels_first_1_0 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_0 / 16) + (highcost_pixels_first_1_0 / 64)) mod 2);
      highcost_pixels_cost_1_1 <= (((highcost_pixels_first_1_1 mod 4) + (((highcost_pixels_first_1_1 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_1 / 16) mod 4) + (highcost_pixels_first_1_1 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_1 / 16) + (highcost_pixels_first_1_1 / 64)) mod 2);
      highcost_pixels_cost_1_2 <= (((highcost_pixels_first_1_2 mod 4) + (((highcost_pixels_first_1_2 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_2 / 16) mod 4) + (highcost_pixels_first_1_2 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_2 / 16) + (highcost_pixels_first_1_2 / 64)) mod 2);
      highcost_pixels_cost_1_3 <= (((highcost_pixels_first_1_3 mod 4) + (((highcost_pixels_first_1_3 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_3 / 16) mod 4) + (highcost_pixels_first_1_3 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_3 / 16) + (highcost_pixels_first_1_3 / 64)) mod 2);
      highcost_pixels_cost_1_4 <= (((highcost_pixels_first_1_4 mod 4) + (((highcost_pixels_first_1_4 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_4 / 16) mod 4) + (highcost_pixels_first_1_4 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_4 / 16) + (highcost_pixels_first_1_4 / 64)) mod 2);
      highcost_pixels_cost_1_5 <= (((highcost_pixels_first_1_5 mod 4) + (((highcost_pixels_first_1_5 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_5 / 16) mod 4) + (highcost_pixels_first_1_5 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_5 / 16) + (highcost_pixels_first_1_5 / 64)) mod 2);
      highcost_pixels_cost_1_6 <= (((highcost_pixels_first_1_6 mod 4) + (((highcost_pixels_first_1_6 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_6 / 16) mod 4) + (highcost_pixels_first_1_6 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_6 / 16) + (highcost_pixels_first_1_6 / 64)) mod 2);
      highcost_pixels_cost_1_7 <= (((highcost_pixels_first_1_7 mod 4) + (((highcost_pixels_first_1_7 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_7 / 16) mod 4) + (highcost_pixels_first_1_7 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_7 / 16) + (highcost_pixels_first_1_7 / 64)) mod 2);
      highcost_pixels_cost_1_8 <= (((highcost_pixels_first_1_8 mod 4) + (((highcost_pixels_first_1_8 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_8 / 16) mod 4) + (highcost_pixels_first_1_8 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_8 / 16) + (highcost_pixels_first_1_8 / 64)) mod 2);
      highcost_pixels_cost_1_9 <= (((highcost_pixels_first_1_9 mod 4) + (((highcost_pixels_first_1_9 / 2) mod 8) / 2) +
        ((((highcost_pixels_first_1_9 / 16) mod 4) + (highcost_pixels_first_1_9 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_9 / 16) + (highcost_pixels_first_1_9 / 64)) mod 2);
      highcost_pixels_cost_1_10 <= (((highcost_pixels_first_1_10 mod 4) + (((highcost_pixels_first_1_10 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_10 / 16) mod 4) + (highcost_pixels_first_1_10 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_10 / 16) + (highcost_pixels_first_1_10 / 64)) mod 2);
      highcost_pixels_cost_1_11 <= (((highcost_pixels_first_1_11 mod 4) + (((highcost_pixels_first_1_11 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_11 / 16) mod 4) + (highcost_pixels_first_1_11 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_11 / 16) + (highcost_pixels_first_1_11 / 64)) mod 2);
      highcost_pixels_cost_1_12 <= (((highcost_pixels_first_1_12 mod 4) + (((highcost_pixels_first_1_12 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_12 / 16) mod 4) + (highcost_pixels_first_1_12 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_12 / 16) + (highcost_pixels_first_1_12 / 64)) mod 2);
      highcost_pixels_cost_1_13 <= (((highcost_pixels_first_1_13 mod 4) + (((highcost_pixels_first_1_13 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_13 / 16) mod 4) + (highcost_pixels_first_1_13 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_13 / 16) + (highcost_pixels_first_1_13 / 64)) mod 2);
      highcost_pixels_cost_1_14 <= (((highcost_pixels_first_1_14 mod 4) + (((highcost_pixels_first_1_14 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_14 / 16) mod 4) + (highcost_pixels_first_1_14 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_14 / 16) + (highcost_pixels_first_1_14 / 64)) mod 2);
      highcost_pixels_cost_1_15 <= (((highcost_pixels_first_1_15 mod 4) + (((highcost_pixels_first_1_15 / 2) mod 8) /
        2) + ((((highcost_pixels_first_1_15 / 16) mod 4) + (highcost_pixels_first_1_15 / 64)) / 2)) * 2) +
        (((highcost_pixels_first_1_15 / 16) + (highcost_pixels_first_1_15 / 64)) mod 2);
      highcost_change_0_0 <= highcost_pixels_cost_1_0 - highcost_pixels_cost_0_0;
      highcost_change_0_1 <= highcost_pixels_cost_1_1 - highcost_pixels_cost_0_1;
      highcost_change_0_2 <= highcost_pixels_cost_1_2 - highcost_pixels_cost_0_2;
      highcost_change_0_3 <= highcost_pixels_cost_1_3 - highcost_pixels_cost_0_3;
      highcost_change_0_4 <= highcost_pixels_cost_1_4 - highcost_pixels_cost_0_4;
      highcost_change_0_5 <= highcost_pixels_cost_1_5 - highcost_pixels_cost_0_5;
      highcost_change_0_6 <= highcost_pixels_cost_1_6 - highcost_pixels_cost_0_6;
      highcost_change_0_7 <= highcost_pixels_cost_1_7 - highcost_pixels_cost_0_7;
      highcost_change_0_8 <= highcost_pixels_cost_1_8 - highcost_pixels_cost_0_8;
      highcost_change_0_9 <= highcost_pixels_cost_1_9 - highcost_pixels_cost_0_9;
      highcost_change_0_10 <= highcost_pixels_cost_1_10 - highcost_pixels_cost_0_10;
      highcost_change_0_11 <= highcost_pixels_cost_1_11 - highcost_pixels_cost_0_11;
      highcost_change_0_12 <= highcost_pixels_cost_1_12 - highcost_pixels_cost_0_12;
      highcost_change_0_13 <= highcost_pixels_cost_1_13 - highcost_pixels_cost_0_13;
      highcost_change_0_14 <= highcost_pixels_cost_1_14 - highcost_pixels_cost_0_14;
      highcost_change_0_15 <= highcost_pixels_cost_1_15 - highcost_pixels_cost_0_15;
      highcost_ready_words_0 <= to_integer(highcost_read_words_0);
      highcost_ready_words_1 <= to_integer(highcost_read_words_1);
      highcost_ready_words_2 <= to_integer(highcost_read_words_2);
      highcost_ready_words_3 <= to_integer(highcost_read_words_3);
      highcost_column_0_0 <= highcost_column_0_0_choice_2;
      highcost_column_0_1 <= highcost_column_0_1_choice_2;
      highcost_column_0_2 <= highcost_column_0_2_choice_2;
      highcost_column_0_3 <= highcost_column_0_3_choice_2;
      highcost_column_0_4 <= highcost_column_0_4_choice_2;
      highcost_column_0_5 <= highcost_column_0_5_choice_2;
      highcost_column_0_6 <= highcost_column_0_6_choice_2;
      highcost_column_0_7 <= highcost_column_0_7_choice_2;
      highcost_column_0_8 <= highcost_column_0_8_choice_2;
      highcost_column_0_9 <= highcost_column_0_9_choice_2;
      highcost_column_0_10 <= highcost_column_0_10_choice_2;
      highcost_column_0_11 <= highcost_column_0_11_choice_2;
      highcost_column_0_12 <= highcost_column_0_12_choice_2;
      highcost_column_0_13 <= highcost_column_0_13_choice_2;
      highcost_column_0_14 <= highcost_column_0_14_choice_2;
      highcost_column_0_15 <= highcost_column_0_15_choice_2;
      if lowcost_ready_tag_valid then
        highcost_write_words_0 <= (highcost_column_0_1_choice_2 * 128) + highcost_column_0_0_choice_2 +
          (highcost_column_0_2_choice_2 * 16384) + (highcost_column_0_3_choice_2 * 2097152);
        highcost_write_words_1 <= (highcost_column_0_5_choice_2 * 128) + highcost_column_0_4_choice_2 +
          (highcost_column_0_6_choice_2 * 16384) + (highcost_column_0_7_choice_2 * 2097152);
        highcost_write_words_2 <= (highcost_column_0_9_choice_2 * 128) + highcost_column_0_8_choice_2 +
          (highcost_column_0_10_choice_2 * 16384) + (highcost_column_0_11_choice_2 * 2097152);
        highcost_write_words_3 <= (highcost_column_0_13_choice_2 * 128) + highcost_column_0_12_choice_2 +
          (highcost_column_0_14_choice_2 * 16384) + (highcost_column_0_15_choice_2 * 2097152);
      end if;
      -- highwindow
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_0_choice := to_integer(highwindow_leaving_0(6 downto 0));
      else
        highwindow_change_0_0_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_1_choice := to_integer(highwindow_leaving_0(13 downto 7));
      else
        highwindow_change_0_1_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_2_choice := to_integer(highwindow_leaving_0(20 downto 14));
      else
        highwindow_change_0_2_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_3_choice := to_integer(highwindow_leaving_0(27 downto 21));
      else
        highwindow_change_0_3_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_4_choice := to_integer(highwindow_leaving_1(6 downto 0));
      else
        highwindow_change_0_4_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_5_choice := to_integer(highwindow_leaving_1(13 downto 7));
      else
        highwindow_change_0_5_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_6_choice := to_integer(highwindow_leaving_1(20 downto 14));
      else
        highwindow_change_0_6_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_7_choice := to_integer(highwindow_leaving_1(27 downto 21));
      else
        highwindow_change_0_7_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_8_choice := to_integer(highwindow_leaving_2(6 downto 0));
      else
        highwindow_change_0_8_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_9_choice := to_integer(highwindow_leaving_2(13 downto 7));
      else
        highwindow_change_0_9_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_10_choice := to_integer(highwindow_leaving_2(20 downto 14));
      else
        highwindow_change_0_10_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_11_choice := to_integer(highwindow_leaving_2(27 downto 21));
      else
        highwindow_change_0_11_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_12_choice := to_integer(highwindow_leaving_3(6 downto 0));
      else
        highwindow_change_0_12_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_13_choice := to_integer(highwindow_leaving_3(13 downto 7));
      else
        highwindow_change_0_13_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_14_choice := to_integer(highwindow_leaving_3(20 downto 14));
      else
        highwindow_change_0_14_choice := 0;
      end if;
      if lowwindow_entering_tag_leaves_window then
        highwindow_change_0_15_choice := to_integer(highwindow_leaving_3(27 downto 21));
      else
        highwindow_change_0_15_choice := 0;
      end if;
      highwindow_entering_0_0 <= highcost_column_0_0;
      highwindow_entering_0_1 <= highcost_column_0_1;
      highwindow_entering_0_2 <= highcost_column_0_2;
      highwindow_entering_0_3 <= highcost_column_0_3;
      highwindow_entering_0_4 <= highcost_column_0_4;
      highwindow_entering_0_5 <= highcost_column_0_5;
      highwindow_entering_0_6 <= highcost_column_0_6;
      highwindow_entering_0_7 <= highcost_column_0_7;
      highwindow_entering_0_8 <= highcost_column_0_8;
      highwindow_entering_0_9 <= highcost_column_0_9;
      highwindow_entering_0_10 <= highcost_column_0_10;
      highwindow_entering_0_11 <= highcost_column_0_11;
      highwindow_entering_0_12 <= highcost_column_0_12;
      highwindow_entering_0_13 <= highcost_column_0_13;
      highwindow_entering_0_14 <= highcost_column_0_14;
      highwindow_entering_0_15 <= highcost_column_0_15;
      highwindow_change_0_0 <= highwindow_entering_0_0 - highwindow_change_0_0_choice;
      highwindow_change_0_1 <= highwindow_entering_0_1 - highwindow_change_0_1_choice;
      highwindow_change_0_2 <= highwindow_entering_0_2 - highwindow_change_0_2_choice;
      highwindow_change_0_3 <= highwindow_entering_0_3 - highwindow_change_0_3_choice;
      highwindow_change_0_4 <= highwindow_entering_0_4 - highwindow_change_0_4_choice;
      highwindow_change_0_5 <= highwindow_entering_0_5 - highwindow_change_0_5_choice;
      highwindow_change_0_6 <= highwindow_entering_0_6 - highwindow_change_0_6_choice;
      highwindow_change_0_7 <= highwindow_entering_0_7 - highwindow_change_0_7_choice;
      highwindow_change_0_8 <= highwindow_entering_0_8 - highwindow_change_0_8_choice;
      highwindow_change_0_9 <= highwindow_entering_0_9 - highwindow_change_0_9_choice;
      highwindow_change_0_10 <= highwindow_entering_0_10 - highwindow_change_0_10_choice;
      highwindow_change_0_11 <= highwindow_entering_0_11 - highwindow_change_0_11_choice;
      highwindow_change_0_12 <= highwindow_entering_0_12 - highwindow_change_0_12_choice;
      highwindow_change_0_13 <= highwindow_entering_0_13 - highwindow_change_0_13_choice;
      highwindow_change_0_14 <= highwindow_entering_0_14 - highwindow_change_0_14_choice;
      highwindow_change_0_15 <= highwindow_entering_0_15 - highwindow_change_0_15_choice;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_0_choice := 0;
      else
        highwindow_sum_0_0_choice := highwindow_sum_0_0;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_1_choice := 0;
      else
        highwindow_sum_0_1_choice := highwindow_sum_0_1;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_2_choice := 0;
      else
        highwindow_sum_0_2_choice := highwindow_sum_0_2;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_3_choice := 0;
      else
        highwindow_sum_0_3_choice := highwindow_sum_0_3;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_4_choice := 0;
      else
        highwindow_sum_0_4_choice := highwindow_sum_0_4;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_5_choice := 0;
      else
        highwindow_sum_0_5_choice := highwindow_sum_0_5;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_6_choice := 0;
      else
        highwindow_sum_0_6_choice := highwindow_sum_0_6;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_7_choice := 0;
      else
        highwindow_sum_0_7_choice := highwindow_sum_0_7;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_8_choice := 0;
      else
        highwindow_sum_0_8_choice := highwindow_sum_0_8;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_9_choice := 0;
      else
        highwindow_sum_0_9_choice := highwindow_sum_0_9;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_10_choice := 0;
      else
        highwindow_sum_0_10_choice := highwindow_sum_0_10;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_11_choice := 0;
      else
        highwindow_sum_0_11_choice := highwindow_sum_0_11;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_12_choice := 0;
      else
        highwindow_sum_0_12_choice := highwindow_sum_0_12;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_13_choice := 0;
      else
        highwindow_sum_0_13_choice := highwindow_sum_0_13;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_14_choice := 0;
      else
        highwindow_sum_0_14_choice := highwindow_sum_0_14;
      end if;
      if lowwindow_change_tag_first_cost then
        highwindow_sum_0_15_choice := 0;
      else
        highwindow_sum_0_15_choice := highwindow_sum_0_15;
      end if;
      if lowwindow_change_tag_valid then
        highwindow_sum_0_0 <= (highwindow_sum_0_0_choice + highwindow_change_0_0) mod 512;
        highwindow_sum_0_1 <= (highwindow_sum_0_1_choice + highwindow_change_0_1) mod 512;
        highwindow_sum_0_2 <= (highwindow_sum_0_2_choice + highwindow_change_0_2) mod 512;
        highwindow_sum_0_3 <= (highwindow_sum_0_3_choice + highwindow_change_0_3) mod 512;
        highwindow_sum_0_4 <= (highwindow_sum_0_4_choice + highwindow_change_0_4) mod 512;
        highwindow_sum_0_5 <= (highwindow_sum_0_5_choice + highwindow_change_0_5) mod 512;
        highwindow_sum_0_6 <= (highwindow_sum_0_6_choice + highwindow_change_0_6) mod 512;
        highwindow_sum_0_7 <= (highwindow_sum_0_7_choice + highwindow_change_0_7) mod 512;
        highwindow_sum_0_8 <= (highwindow_sum_0_8_choice + highwindow_change_0_8) mod 512;
        highwindow_sum_0_9 <= (highwindow_sum_0_9_choice + highwindow_change_0_9) mod 512;
        highwindow_sum_0_10 <= (highwindow_sum_0_10_choice + highwindow_change_0_10) mod 512;
        highwindow_sum_0_11 <= (highwindow_sum_0_11_choice + highwindow_change_0_11) mod 512;
        highwindow_sum_0_12 <= (highwindow_sum_0_12_choice + highwindow_change_0_12) mod 512;
        highwindow_sum_0_13 <= (highwindow_sum_0_13_choice + highwindow_change_0_13) mod 512;
        highwindow_sum_0_14 <= (highwindow_sum_0_14_choice + highwindow_change_0_14) mod 512;
        highwindow_sum_0_15 <= (highwindow_sum_0_15_choice + highwindow_change_0_15) mod 512;
      end if;
      -- highwinner1
      highwinner1_of_pair_0_0_is_less := (highwindow_sum_0_1 - highwindow_sum_0_0) < 0;
      highwinner1_of_pair_0_2_is_less := (highwindow_sum_0_3 - highwindow_sum_0_2) < 0;
      highwinner1_of_pair_0_4_is_less := (highwindow_sum_0_5 - highwindow_sum_0_4) < 0;
      highwinner1_of_pair_0_6_is_less := (highwindow_sum_0_7 - highwindow_sum_0_6) < 0;
      highwinner1_of_pair_0_8_is_less := (highwindow_sum_0_9 - highwindow_sum_0_8) < 0;
      highwinner1_of_pair_0_10_is_less := (highwindow_sum_0_11 - highwindow_sum_0_10) < 0;
      highwinner1_of_pair_0_12_is_less := (highwindow_sum_0_13 - highwindow_sum_0_12) < 0;
      highwinner1_of_pair_0_14_is_less := (highwindow_sum_0_15 - highwindow_sum_0_14) < 0;
      highwinner1_of_four_0_0_is_less := (to_integer(((to_unsigned(highwinner1_of_pair_0_2, 9)) or
        (to_unsigned(highwinner1_of_pair_0_3, 9)))) - to_integer(((to_unsigned(highwinner1_of_pair_0_0, 9)) or
        (to_unsigned(highwinner1_of_pair_0_1, 9))))) < 0;
      highwinner1_of_four_0_4_is_less := (to_integer(((to_unsigned(highwinner1_of_pair_0_6, 9)) or
        (to_unsigned(highwinner1_of_pair_0_7, 9)))) - to_integer(((to_unsigned(highwinner1_of_pair_0_4, 9)) or
        (to_unsigned(highwinner1_of_pair_0_5, 9))))) < 0;
      highwinner1_of_four_0_8_is_less := (to_integer(((to_unsigned(highwinner1_of_pair_0_10, 9)) or
        (to_unsigned(highwinner1_of_pair_0_11, 9)))) - to_integer(((to_unsigned(highwinner1_of_pair_0_8, 9)) or
        (to_unsigned(highwinner1_of_pair_0_9, 9))))) < 0;
      highwinner1_of_four_0_12_is_less := (to_integer(((to_unsigned(highwinner1_of_pair_0_14, 9)) or
        (to_unsigned(highwinner1_of_pair_0_15, 9)))) - to_integer(((to_unsigned(highwinner1_of_pair_0_12, 9)) or
        (to_unsigned(highwinner1_of_pair_0_13, 9))))) < 0;
      highwinner1_pair_index_0_0 <= highwinner1_of_pair_0_0_is_less;
      highwinner1_best_cost_0_0 <= to_integer(((((((to_unsigned(highwinner1_of_four_0_2, 9)) or
        (to_unsigned(highwinner1_of_four_0_3, 9)))) or (to_unsigned(highwinner1_of_four_0_1, 9)))) or
        (to_unsigned(highwinner1_of_four_0_0, 9))));
      highwinner1_best_cost_0_1 <= to_integer(((((((to_unsigned(highwinner1_of_four_0_6, 9)) or
        (to_unsigned(highwinner1_of_four_0_7, 9)))) or (to_unsigned(highwinner1_of_four_0_5, 9)))) or
        (to_unsigned(highwinner1_of_four_0_4, 9))));
      highwinner1_best_cost_0_2 <= to_integer(((((((to_unsigned(highwinner1_of_four_0_10, 9)) or
        (to_unsigned(highwinner1_of_four_0_11, 9)))) or (to_unsigned(highwinner1_of_four_0_9, 9)))) or
        (to_unsigned(highwinner1_of_four_0_8, 9))));
      highwinner1_best_cost_0_3 <= to_integer(((((((to_unsigned(highwinner1_of_four_0_14, 9)) or
        (to_unsigned(highwinner1_of_four_0_15, 9)))) or (to_unsigned(highwinner1_of_four_0_13, 9)))) or
        (to_unsigned(highwinner1_of_four_0_12, 9))));
      highwinner1_best_index_0_0 <= highwinner1_four_index_0_0;
      highwinner1_best_index_0_1 <= highwinner1_four_index_0_1;
      highwinner1_best_index_0_2 <= highwinner1_four_index_0_2;
      highwinner1_best_index_0_3 <= highwinner1_four_index_0_3;
      if highwinner1_of_pair_0_0_is_less then
        highwinner1_of_pair_0_0 <= 0;
        highwinner1_of_pair_0_1 <= highwindow_sum_0_1;
      else
        highwinner1_of_pair_0_0 <= highwindow_sum_0_0;
        highwinner1_of_pair_0_1 <= 0;
      end if;
      if highwinner1_of_pair_0_2_is_less then
        highwinner1_of_pair_0_2 <= 0;
        highwinner1_of_pair_0_3 <= highwindow_sum_0_3;
        highwinner1_pair_index_0_1 <= 3;
      else
        highwinner1_of_pair_0_2 <= highwindow_sum_0_2;
        highwinner1_of_pair_0_3 <= 0;
        highwinner1_pair_index_0_1 <= 2;
      end if;
      if highwinner1_of_pair_0_4_is_less then
        highwinner1_of_pair_0_4 <= 0;
        highwinner1_of_pair_0_5 <= highwindow_sum_0_5;
        highwinner1_pair_index_0_2 <= 5;
      else
        highwinner1_of_pair_0_4 <= highwindow_sum_0_4;
        highwinner1_of_pair_0_5 <= 0;
        highwinner1_pair_index_0_2 <= 4;
      end if;
      if highwinner1_of_pair_0_6_is_less then
        highwinner1_of_pair_0_6 <= 0;
        highwinner1_of_pair_0_7 <= highwindow_sum_0_7;
        highwinner1_pair_index_0_3 <= 7;
      else
        highwinner1_of_pair_0_6 <= highwindow_sum_0_6;
        highwinner1_of_pair_0_7 <= 0;
        highwinner1_pair_index_0_3 <= 6;
      end if;
      if highwinner1_of_pair_0_8_is_less then
        highwinner1_of_pair_0_8 <= 0;
        highwinner1_of_pair_0_9 <= highwindow_sum_0_9;
        highwinner1_pair_index_0_4 <= 9;
      else
        highwinner1_of_pair_0_8 <= highwindow_sum_0_8;
        highwinner1_of_pair_0_9 <= 0;
        highwinner1_pair_index_0_4 <= 8;
      end if;
      if highwinner1_of_pair_0_10_is_less then
        highwinner1_of_pair_0_10 <= 0;
        highwinner1_of_pair_0_11 <= highwindow_sum_0_11;
        highwinner1_pair_index_0_5 <= 11;
      else
        highwinner1_of_pair_0_10 <= highwindow_sum_0_10;
        highwinner1_of_pair_0_11 <= 0;
        highwinner1_pair_index_0_5 <= 10;
      end if;
      if highwinner1_of_pair_0_12_is_less then
        highwinner1_of_pair_0_12 <= 0;
        highwinner1_of_pair_0_13 <= highwindow_sum_0_13;
        highwinner1_pair_index_0_6 <= 13;
      else
        highwinner1_of_pair_0_12 <= highwindow_sum_0_12;
        highwinner1_of_pair_0_13 <= 0;
        highwinner1_pair_index_0_6 <= 12;
      end if;
      if highwinner1_of_pair_0_14_is_less then
        highwinner1_of_pair_0_14 <= 0;
        highwinner1_of_pair_0_15 <= highwindow_sum_0_15;
        highwinner1_pair_index_0_7 <= 15;
      else
        highwinner1_of_pair_0_14 <= highwindow_sum_0_14;
        highwinner1_of_pair_0_15 <= 0;
        highwinner1_pair_index_0_7 <= 14;
      end if;
      if highwinner1_of_four_0_0_is_less then
        highwinner1_of_four_0_0 <= 0;
        highwinner1_of_four_0_1 <= 0;
        highwinner1_of_four_0_2 <= highwinner1_of_pair_0_2;
        highwinner1_of_four_0_3 <= highwinner1_of_pair_0_3;
        highwinner1_four_index_0_0 <= highwinner1_pair_index_0_1;
      else
        highwinner1_of_four_0_0 <= highwinner1_of_pair_0_0;
        highwinner1_of_four_0_1 <= highwinner1_of_pair_0_1;
        highwinner1_of_four_0_2 <= 0;
        highwinner1_of_four_0_3 <= 0;
        highwinner1_four_index_0_0 <= as_number(highwinner1_pair_index_0_0);
      end if;
      if highwinner1_of_four_0_4_is_less then
        highwinner1_of_four_0_4 <= 0;
        highwinner1_of_four_0_5 <= 0;
        highwinner1_of_four_0_6 <= highwinner1_of_pair_0_6;
        highwinner1_of_four_0_7 <= highwinner1_of_pair_0_7;
        highwinner1_four_index_0_1 <= highwinner1_pair_index_0_3;
      else
        highwinner1_of_four_0_4 <= highwinner1_of_pair_0_4;
        highwinner1_of_four_0_5 <= highwinner1_of_pair_0_5;
        highwinner1_of_four_0_6 <= 0;
        highwinner1_of_four_0_7 <= 0;
        highwinner1_four_index_0_1 <= highwinner1_pair_index_0_2;
      end if;
      if highwinner1_of_four_0_8_is_less then
        highwinner1_of_four_0_8 <= 0;
        highwinner1_of_four_0_9 <= 0;
        highwinner1_of_four_0_10 <= highwinner1_of_pair_0_10;
        highwinner1_of_four_0_11 <= highwinner1_of_pair_0_11;
        highwinner1_four_index_0_2 <= highwinner1_pair_index_0_5;
      else
        highwinner1_of_four_0_8 <= highwinner1_of_pair_0_8;
        highwinner1_of_four_0_9 <= highwinner1_of_pair_0_9;
        highwinner1_of_four_0_10 <= 0;
        highwinner1_of_four_0_11 <= 0;
        highwinner1_four_index_0_2 <= highwinner1_pair_index_0_4;
      end if;
      if highwinner1_of_four_0_12_is_less then
        highwinner1_of_four_0_12 <= 0;
        highwinner1_of_four_0_13 <= 0;
        highwinner1_of_four_0_14 <= highwinner1_of_pair_0_14;
        highwinner1_of_four_0_15 <= highwinner1_of_pair_0_15;
        highwinner1_four_index_0_3 <= highwinner1_pair_index_0_7;
      else
        highwinner1_of_four_0_12 <= highwinner1_of_pair_0_12;
        highwinner1_of_four_0_13 <= highwinner1_of_pair_0_13;
        highwinner1_of_four_0_14 <= 0;
        highwinner1_of_four_0_15 <= 0;
        highwinner1_four_index_0_3 <= highwinner1_pair_index_0_6;
      end if;
      -- highwinner2
      highwinner2_of_pair_0_0_is_less := (highwinner1_best_cost_0_1 - highwinner1_best_cost_0_0) < 0;
      highwinner2_of_pair_0_2_is_less := (highwinner1_best_cost_0_3 - highwinner1_best_cost_0_2) < 0;
      highwinner2_of_four_0_0_is_less := (to_integer(((to_unsigned(highwinner2_of_pair_0_2, 9)) or
        (to_unsigned(highwinner2_of_pair_0_3, 9)))) - to_integer(((to_unsigned(highwinner2_of_pair_0_0, 9)) or
        (to_unsigned(highwinner2_of_pair_0_1, 9))))) < 0;
      highwinner2_best_cost_0_0 <= to_integer(((((((to_unsigned(highwinner2_of_four_0_2, 9)) or
        (to_unsigned(highwinner2_of_four_0_3, 9)))) or (to_unsigned(highwinner2_of_four_0_1, 9)))) or
        (to_unsigned(highwinner2_of_four_0_0, 9))));
      highwinner2_best_index_0_0 <= highwinner2_four_index_0_0;
      if highwinner2_of_pair_0_0_is_less then
        highwinner2_of_pair_0_0 <= 0;
        highwinner2_of_pair_0_1 <= highwinner1_best_cost_0_1;
        highwinner2_pair_index_0_0 <= highwinner1_best_index_0_1;
      else
        highwinner2_of_pair_0_0 <= highwinner1_best_cost_0_0;
        highwinner2_of_pair_0_1 <= 0;
        highwinner2_pair_index_0_0 <= highwinner1_best_index_0_0;
      end if;
      if highwinner2_of_pair_0_2_is_less then
        highwinner2_of_pair_0_2 <= 0;
        highwinner2_of_pair_0_3 <= highwinner1_best_cost_0_3;
        highwinner2_pair_index_0_1 <= highwinner1_best_index_0_3;
      else
        highwinner2_of_pair_0_2 <= highwinner1_best_cost_0_2;
        highwinner2_of_pair_0_3 <= 0;
        highwinner2_pair_index_0_1 <= highwinner1_best_index_0_2;
      end if;
      if highwinner2_of_four_0_0_is_less then
        highwinner2_of_four_0_0 <= 0;
        highwinner2_of_four_0_1 <= 0;
        highwinner2_of_four_0_2 <= highwinner2_of_pair_0_2;
        highwinner2_of_four_0_3 <= highwinner2_of_pair_0_3;
        highwinner2_four_index_0_0 <= highwinner2_pair_index_0_1;
      else
        highwinner2_of_four_0_0 <= highwinner2_of_pair_0_0;
        highwinner2_of_four_0_1 <= highwinner2_of_pair_0_1;
        highwinner2_of_four_0_2 <= 0;
        highwinner2_of_four_0_3 <= 0;
        highwinner2_four_index_0_0 <= highwinner2_pair_index_0_0;
      end if;
      -- centre
      if bases_stands_valid then
        centre_held_0_1 <= bases_from_0_2;
        centre_held_1_0 <= bases_base_1_2;
        centre_held_1_1 <= centre_held_1_0;
      end if;
      centre_line_0_0 <= centre_held_0_1 mod 256;
      centre_line_0_1 <= centre_line_0_0;
      centre_line_0_2 <= centre_line_0_1;
      centre_line_0_3 <= centre_line_0_2;
      centre_line_0_4 <= centre_line_0_3;
      centre_line_0_5 <= centre_line_0_4;
      centre_line_0_6 <= centre_line_0_5;
      centre_line_0_7 <= centre_line_0_6;
      centre_line_0_8 <= centre_line_0_7;
      centre_line_0_9 <= centre_line_0_8;
      centre_line_0_10 <= centre_line_0_9;
      centre_line_0_11 <= centre_line_0_10;
      centre_line_0_12 <= centre_line_0_11;
      centre_line_0_13 <= centre_line_0_12;
      centre_line_0_14 <= centre_line_0_13;
      centre_line_0_15 <= centre_line_0_14;
      centre_line_0_16 <= centre_line_0_15;
      centre_line_0_17 <= centre_line_0_16;
      centre_line_0_18 <= centre_line_0_17;
      centre_line_1_0 <= centre_held_1_1 mod 256;
      centre_line_1_1 <= centre_line_1_0;
      centre_line_1_2 <= centre_line_1_1;
      centre_line_1_3 <= centre_line_1_2;
      centre_line_1_4 <= centre_line_1_3;
      centre_line_1_5 <= centre_line_1_4;
      centre_line_1_6 <= centre_line_1_5;
      centre_line_1_7 <= centre_line_1_6;
      centre_line_1_8 <= centre_line_1_7;
      centre_line_1_9 <= centre_line_1_8;
      centre_line_1_10 <= centre_line_1_9;
      centre_line_1_11 <= centre_line_1_10;
      centre_line_1_12 <= centre_line_1_11;
      centre_line_1_13 <= centre_line_1_12;
      centre_line_1_14 <= centre_line_1_13;
      centre_line_1_15 <= centre_line_1_14;
      centre_line_1_16 <= centre_line_1_15;
      centre_line_1_17 <= centre_line_1_16;
      centre_line_1_18 <= centre_line_1_17;
      -- choice
      choice_best_index_0_0_is_less := (highwinner2_best_cost_0_0 - lowwinner2_best_cost_0_0) < 0;
      choice_best_tag_valid <= lowwinner2_tag_valid;
      choice_best_tag_output_column <= lowwinner2_tag_output_column;
      choice_best_tag_start_of_frame <= lowwinner2_tag_start_of_frame;
      choice_best_tag_end_of_line <= lowwinner2_tag_end_of_line;
      if choice_best_index_0_0_is_less then
        choice_best_index_0_0 <= highwinner2_best_index_0_0;
        choice_base <= centre_line_1_18;
      else
        choice_best_index_0_0 <= lowwinner2_best_index_0_0;
        choice_base <= centre_line_0_18;
      end if;
      -- map
      map_disparity_0 <= (choice_best_index_0_0 + choice_base) mod 256;
      map_passed_0 <= true;
      map_valid <= choice_best_tag_valid and choice_best_tag_output_column;
      map_start_of_frame <= choice_best_tag_start_of_frame and choice_best_tag_valid and choice_best_tag_output_column;
      map_end_of_line <= choice_best_tag_end_of_line and choice_best_tag_valid and choice_best_tag_output_column;
      -- other
      if coarsetransform_centre_group_any then
        other_20_choice := 15;
      else
        other_20_choice := 11;
      end if;
      other_0 <= as_number(((transform_right_code_next_row_before_0 - transform_right_code_next_row_after_0) < 0)) *
        524288;
      other_1 <= as_number((((other_2 / 2) - transform_right_code_next_row_centre_0) < 0)) * 524288;
      other_2 <= ((transform_right_code_next_row_box_0_0 + transform_right_code_next_row_column_0_7) / 2) * 2;
      other_3 <= as_number(((transform_right_code_row_before_0 - transform_right_code_row_after_0) < 0)) * 131072;
      other_4 <= as_number((((other_5 / 2) - transform_right_code_row_centre_0) < 0)) * 131072;
      other_5 <= ((transform_right_code_row_box_0_0 + transform_right_code_row_column_0_3) / 2) * 2;
      other_6 <= as_number(((transform_left_code_next_row_before_0 - transform_left_code_next_row_after_0) < 0)) *
        524288;
      other_7 <= as_number((((other_8 / 2) - transform_left_code_next_row_centre_0) < 0)) * 524288;
      other_8 <= ((transform_left_code_next_row_box_0_0 + transform_left_code_next_row_column_0_7) / 2) * 2;
      other_9 <= as_number(((transform_left_code_row_before_0 - transform_left_code_row_after_0) < 0)) * 131072;
      other_10 <= as_number((((other_11 / 2) - transform_left_code_row_centre_0) < 0)) * 131072;
      other_11 <= ((transform_left_code_row_box_0_0 + transform_left_code_row_column_0_3) / 2) * 2;
      other_12 <= other_13;
      other_13 <= (as_number(transform_valid) * 256) + as_number(((transform_counter_group = 4) and
        (transform_counter_column = 4)));
      other_14 <= as_number(((coarsetransform_right_code_row_before_0 - coarsetransform_right_code_row_after_0) < 0)) *
        131072;
      other_15 <= as_number((((other_16 / 2) - coarsetransform_right_code_row_centre_0) < 0)) * 131072;
      other_16 <= ((coarsetransform_right_code_row_column_0_3 + coarsetransform_right_code_column_response_0) / 2) * 2;
      other_17 <= as_number(((coarsetransform_left_code_row_before_0 - coarsetransform_left_code_row_after_0) < 0)) *
        131072;
      other_18 <= as_number((((other_19 / 2) - coarsetransform_left_code_row_centre_0) < 0)) * 131072;
      other_19 <= ((coarsetransform_left_code_row_column_0_3 + coarsetransform_left_code_column_response_0) / 2) * 2;
      other_20 <= ((other_20_choice + (coarsetransform_counter_column / 2)) mod 16) * 2;
      other_21 <= other_22;
      other_22 <= (as_number(coarsetransform_valid) * 256) + as_number(((coarsetransform_counter_group = 2) and
        (coarsetransform_counter_column = 2)));
      if reset = '1' then
        coarse_pixels_left <= 0;
        coarse_pixels_right <= 0;
        coarse_pixels_valid <= false;
        coarse_pixels_column <= 0;
        coarse_pixels_part <= 0;
        coarse_pixels_row <= 0;
        coarse_pixels_first_row <= false;
        coarse_pixels_left_sum <= 0;
        coarse_pixels_right_sum <= 0;
        coarse_pixels_sum_ends <= false;
        coarse_pixels_sum_is_first <= false;
        coarse_pixels_sum_is_last <= false;
        coarse_pixels_sum_starts <= false;
        coarse_pixels_sum_column <= 0;
        coarse_pixels_left_read <= 0;
        coarse_pixels_right_read <= 0;
        coarse_pixels_read_column <= 0;
        coarse_pixels_read_ends <= false;
        coarse_pixels_read_is_first <= false;
        coarse_pixels_read_is_last <= false;
        coarse_pixels_read_starts <= false;
        coarse_pixels_total <= to_unsigned(0, 32);
        coarse_pixels_total_ends <= false;
        coarse_pixels_total_is_last <= false;
        coarse_pixels_total_starts <= false;
        coarse_pixels_total_column <= 0;
        coarse_pixels_repetition <= 8;
        coarse_pixels_out_left <= 0;
        coarse_pixels_out_right <= 0;
        coarse_pixels_out_start <= false;
        coarse_pixels_out_valid <= false;
        coarsetransform_left_0 <= 0;
        coarsetransform_right_0 <= 0;
        coarsetransform_valid <= false;
        coarsetransform_counter_column <= 0;
        coarsetransform_counter_group <= 10;
        coarsetransform_counter_next_frame <= false;
        coarsetransform_left_rows_read_newest_0 <= 0;
        coarsetransform_left_rows_ready_words_0 <= 0;
        coarsetransform_left_rows_ready_words_1 <= 0;
        coarsetransform_left_rows_ready_newest_0 <= 0;
        coarsetransform_left_rows_write_words_0 <= 0;
        coarsetransform_left_rows_write_words_1 <= 0;
        coarsetransform_right_rows_read_newest_0 <= 0;
        coarsetransform_right_rows_ready_words_0 <= 0;
        coarsetransform_right_rows_ready_words_1 <= 0;
        coarsetransform_right_rows_ready_newest_0 <= 0;
        coarsetransform_right_rows_write_words_0 <= 0;
        coarsetransform_right_rows_write_words_1 <= 0;
        coarsetransform_read_column <= 0;
        coarsetransform_ready_column <= 0;
        coarsetransform_write_column <= 0;
        coarsetransform_centre_group <= 0;
        coarsetransform_from_first_0 <= false;
        coarsetransform_up_to_last_0 <= false;
        coarsetransform_left_column_0 <= 0;
        coarsetransform_left_column_1 <= 0;
        coarsetransform_left_column_2 <= 0;
        coarsetransform_left_column_3 <= 0;
        coarsetransform_left_column_4 <= 0;
        coarsetransform_right_column_0 <= 0;
        coarsetransform_right_column_1 <= 0;
        coarsetransform_right_column_2 <= 0;
        coarsetransform_right_column_3 <= 0;
        coarsetransform_right_column_4 <= 0;
        coarsetransform_columns_inside_0 <= false;
        coarsetransform_columns_start_of_frame <= false;
        coarsetransform_columns_valid <= false;
        coarsetransform_left_code_column_centre <= 0;
        coarsetransform_left_code_column_near <= 0;
        coarsetransform_left_code_column_outer <= 0;
        coarsetransform_left_code_column_upper <= 0;
        coarsetransform_left_code_column_lower <= 0;
        coarsetransform_left_code_column_response_0 <= 0;
        coarsetransform_left_code_column_response_1 <= 0;
        coarsetransform_left_code_column_response_2 <= 0;
        coarsetransform_left_code_row_column_0_0 <= 0;
        coarsetransform_left_code_row_column_0_1 <= 0;
        coarsetransform_left_code_row_column_0_2 <= 0;
        coarsetransform_left_code_row_column_0_3 <= 0;
        coarsetransform_left_code_row_column_1_0 <= 0;
        coarsetransform_left_code_row_column_1_1 <= 0;
        coarsetransform_left_code_row_column_1_2 <= 0;
        coarsetransform_left_code_row_column_1_3 <= 0;
        coarsetransform_left_code_row_column_2_0 <= 0;
        coarsetransform_left_code_row_column_2_1 <= 0;
        coarsetransform_left_code_row_column_2_2 <= 0;
        coarsetransform_left_code_row_column_2_3 <= 0;
        coarsetransform_left_code_row_centre_0 <= 0;
        coarsetransform_left_code_row_centre_1 <= 0;
        coarsetransform_left_code_row_centre_2 <= 0;
        coarsetransform_left_code_row_outer_1 <= 0;
        coarsetransform_left_code_row_outer_2 <= 0;
        coarsetransform_left_code_row_before_0 <= 0;
        coarsetransform_left_code_row_before_1 <= 0;
        coarsetransform_left_code_row_before_2 <= 0;
        coarsetransform_left_code_row_after_0 <= 0;
        coarsetransform_left_code_row_after_1 <= 0;
        coarsetransform_left_code_row_after_2 <= 0;
        coarsetransform_left_code_row_even_1 <= 0;
        coarsetransform_left_code_row_even_2 <= 0;
        coarsetransform_left_code_row_odd_1 <= 0;
        coarsetransform_left_code_row_odd_2 <= 0;
        coarsetransform_left_code_row_signs <= 0;
        coarsetransform_left_code_bits <= 0;
        coarsetransform_right_code_column_centre <= 0;
        coarsetransform_right_code_column_near <= 0;
        coarsetransform_right_code_column_outer <= 0;
        coarsetransform_right_code_column_upper <= 0;
        coarsetransform_right_code_column_lower <= 0;
        coarsetransform_right_code_column_response_0 <= 0;
        coarsetransform_right_code_column_response_1 <= 0;
        coarsetransform_right_code_column_response_2 <= 0;
        coarsetransform_right_code_row_column_0_0 <= 0;
        coarsetransform_right_code_row_column_0_1 <= 0;
        coarsetransform_right_code_row_column_0_2 <= 0;
        coarsetransform_right_code_row_column_0_3 <= 0;
        coarsetransform_right_code_row_column_1_0 <= 0;
        coarsetransform_right_code_row_column_1_1 <= 0;
        coarsetransform_right_code_row_column_1_2 <= 0;
        coarsetransform_right_code_row_column_1_3 <= 0;
        coarsetransform_right_code_row_column_2_0 <= 0;
        coarsetransform_right_code_row_column_2_1 <= 0;
        coarsetransform_right_code_row_column_2_2 <= 0;
        coarsetransform_right_code_row_column_2_3 <= 0;
        coarsetransform_right_code_row_centre_0 <= 0;
        coarsetransform_right_code_row_centre_1 <= 0;
        coarsetransform_right_code_row_centre_2 <= 0;
        coarsetransform_right_code_row_outer_1 <= 0;
        coarsetransform_right_code_row_outer_2 <= 0;
        coarsetransform_right_code_row_before_0 <= 0;
        coarsetransform_right_code_row_before_1 <= 0;
        coarsetransform_right_code_row_before_2 <= 0;
        coarsetransform_right_code_row_after_0 <= 0;
        coarsetransform_right_code_row_after_1 <= 0;
        coarsetransform_right_code_row_after_2 <= 0;
        coarsetransform_right_code_row_even_1 <= 0;
        coarsetransform_right_code_row_even_2 <= 0;
        coarsetransform_right_code_row_odd_1 <= 0;
        coarsetransform_right_code_row_odd_2 <= 0;
        coarsetransform_right_code_row_signs <= 0;
        coarsetransform_right_code_bits <= 0;
        coarsetransform_filtering_0_inside_0 <= false;
        coarsetransform_filtering_0_start_of_frame <= false;
        coarsetransform_filtering_0_valid <= false;
        coarsetransform_filtering_1_inside_0 <= false;
        coarsetransform_filtering_1_start_of_frame <= false;
        coarsetransform_filtering_1_valid <= false;
        coarsetransform_filtering_2_inside_0 <= false;
        coarsetransform_filtering_2_start_of_frame <= false;
        coarsetransform_filtering_2_valid <= false;
        coarsetransform_filtering_3_inside_0 <= false;
        coarsetransform_filtering_3_start_of_frame <= false;
        coarsetransform_filtering_3_valid <= false;
        coarsetransform_filtering_4_inside_0 <= false;
        coarsetransform_filtering_4_start_of_frame <= false;
        coarsetransform_filtering_4_valid <= false;
        coarsetransform_filtering_5_start_of_frame <= false;
        coarsetransform_filtering_5_valid <= false;
        coarseraster_features_search_0 <= 0;
        coarseraster_features_reference_0 <= 0;
        coarseraster_features_valid <= false;
        coarseraster_place_column <= 0;
        coarseraster_place_group <= 11;
        coarseraster_place_next_frame <= false;
        coarsedelay_ring_read_address <= 1;
        coarsedelay_ring_write_address <= 0;
        coarsedelay_ahead_0 <= 0;
        coarsedelay_column <= 0;
        coarsedelay_row_inside_0 <= false;
        coarsedelay_row_inside_1 <= false;
        coarsedelay_row_inside_2 <= false;
        coarsedelay_row_inside_3 <= false;
        coarsedelay_row_inside_4 <= false;
        coarsedelay_row_inside_5 <= false;
        coarsedelay_row_inside_6 <= false;
        coarsedelay_tag_valid <= false;
        coarsedelay_tag_border_column <= false;
        coarsedelay_tag_first_cost <= false;
        coarsedelay_tag_output_column <= false;
        coarsedelay_tag_start_of_frame <= false;
        coarserows_search_rows_read_newest_0 <= 0;
        coarserows_search_rows_ready_words_0 <= 0;
        coarserows_search_rows_ready_words_1 <= 0;
        coarserows_search_rows_ready_newest_0 <= 0;
        coarserows_search_rows_write_words_0 <= 0;
        coarserows_search_rows_write_words_1 <= 0;
        coarserows_reference_rows_read_newest_0 <= 0;
        coarserows_reference_rows_ready_words_0 <= 0;
        coarserows_reference_rows_ready_words_1 <= 0;
        coarserows_reference_rows_ready_newest_0 <= 0;
        coarserows_reference_rows_write_words_0 <= 0;
        coarserows_reference_rows_write_words_1 <= 0;
        coarserows_read_column <= 0;
        coarserows_read_inside_0 <= false;
        coarserows_read_inside_1 <= false;
        coarserows_read_inside_2 <= false;
        coarserows_read_inside_3 <= false;
        coarserows_read_inside_4 <= false;
        coarserows_read_inside_5 <= false;
        coarserows_read_inside_6 <= false;
        coarserows_read_tag_valid <= false;
        coarserows_read_tag_border_column <= false;
        coarserows_read_tag_first_cost <= false;
        coarserows_read_tag_output_column <= false;
        coarserows_read_tag_start_of_frame <= false;
        coarserows_ready_column <= 0;
        coarserows_ready_inside_0 <= false;
        coarserows_ready_inside_1 <= false;
        coarserows_ready_inside_2 <= false;
        coarserows_ready_inside_3 <= false;
        coarserows_ready_inside_4 <= false;
        coarserows_ready_inside_5 <= false;
        coarserows_ready_inside_6 <= false;
        coarserows_ready_tag_valid <= false;
        coarserows_ready_tag_border_column <= false;
        coarserows_ready_tag_first_cost <= false;
        coarserows_ready_tag_output_column <= false;
        coarserows_ready_tag_start_of_frame <= false;
        coarserows_write_column <= 0;
        coarserows_search_0 <= 0;
        coarserows_search_1 <= 0;
        coarserows_search_2 <= 0;
        coarserows_search_3 <= 0;
        coarserows_search_4 <= 0;
        coarserows_search_5 <= 0;
        coarserows_search_6 <= 0;
        coarserows_reference_0 <= 0;
        coarserows_reference_1 <= 0;
        coarserows_reference_2 <= 0;
        coarserows_reference_3 <= 0;
        coarserows_reference_4 <= 0;
        coarserows_reference_5 <= 0;
        coarserows_reference_6 <= 0;
        coarserows_tag_valid <= false;
        coarserows_tag_border_column <= false;
        coarserows_tag_first_cost <= false;
        coarserows_tag_output_column <= false;
        coarserows_tag_start_of_frame <= false;
        coarseslice0shift_search_0_0 <= 0;
        coarseslice0shift_search_0_1 <= 0;
        coarseslice0shift_search_0_2 <= 0;
        coarseslice0shift_search_0_3 <= 0;
        coarseslice0shift_search_0_4 <= 0;
        coarseslice0shift_search_0_5 <= 0;
        coarseslice0shift_search_0_6 <= 0;
        coarseslice0shift_search_0_7 <= 0;
        coarseslice0shift_search_1_0 <= 0;
        coarseslice0shift_search_1_1 <= 0;
        coarseslice0shift_search_1_2 <= 0;
        coarseslice0shift_search_1_3 <= 0;
        coarseslice0shift_search_1_4 <= 0;
        coarseslice0shift_search_1_5 <= 0;
        coarseslice0shift_search_1_6 <= 0;
        coarseslice0shift_search_1_7 <= 0;
        coarseslice0shift_search_2_0 <= 0;
        coarseslice0shift_search_2_1 <= 0;
        coarseslice0shift_search_2_2 <= 0;
        coarseslice0shift_search_2_3 <= 0;
        coarseslice0shift_search_2_4 <= 0;
        coarseslice0shift_search_2_5 <= 0;
        coarseslice0shift_search_2_6 <= 0;
        coarseslice0shift_search_2_7 <= 0;
        coarseslice0shift_search_3_0 <= 0;
        coarseslice0shift_search_3_1 <= 0;
        coarseslice0shift_search_3_2 <= 0;
        coarseslice0shift_search_3_3 <= 0;
        coarseslice0shift_search_3_4 <= 0;
        coarseslice0shift_search_3_5 <= 0;
        coarseslice0shift_search_3_6 <= 0;
        coarseslice0shift_search_3_7 <= 0;
        coarseslice0shift_search_4_0 <= 0;
        coarseslice0shift_search_4_1 <= 0;
        coarseslice0shift_search_4_2 <= 0;
        coarseslice0shift_search_4_3 <= 0;
        coarseslice0shift_search_4_4 <= 0;
        coarseslice0shift_search_4_5 <= 0;
        coarseslice0shift_search_4_6 <= 0;
        coarseslice0shift_search_4_7 <= 0;
        coarseslice0shift_search_5_0 <= 0;
        coarseslice0shift_search_5_1 <= 0;
        coarseslice0shift_search_5_2 <= 0;
        coarseslice0shift_search_5_3 <= 0;
        coarseslice0shift_search_5_4 <= 0;
        coarseslice0shift_search_5_5 <= 0;
        coarseslice0shift_search_5_6 <= 0;
        coarseslice0shift_search_5_7 <= 0;
        coarseslice0shift_search_6_0 <= 0;
        coarseslice0shift_search_6_1 <= 0;
        coarseslice0shift_search_6_2 <= 0;
        coarseslice0shift_search_6_3 <= 0;
        coarseslice0shift_search_6_4 <= 0;
        coarseslice0shift_search_6_5 <= 0;
        coarseslice0shift_search_6_6 <= 0;
        coarseslice0shift_search_6_7 <= 0;
        coarseslice0shift_reference_0 <= 0;
        coarseslice0shift_reference_1 <= 0;
        coarseslice0shift_reference_2 <= 0;
        coarseslice0shift_reference_3 <= 0;
        coarseslice0shift_reference_4 <= 0;
        coarseslice0shift_reference_5 <= 0;
        coarseslice0shift_reference_6 <= 0;
        coarseslice0shift_tag_valid <= false;
        coarseslice0shift_tag_border_column <= false;
        coarseslice0shift_tag_first_cost <= false;
        coarseslice0shift_tag_output_column <= false;
        coarseslice0shift_tag_start_of_frame <= false;
        coarseslice0cost_pixels_first_0_0 <= 0;
        coarseslice0cost_pixels_first_0_1 <= 0;
        coarseslice0cost_pixels_first_0_2 <= 0;
        coarseslice0cost_pixels_first_0_3 <= 0;
        coarseslice0cost_pixels_first_0_4 <= 0;
        coarseslice0cost_pixels_first_0_5 <= 0;
        coarseslice0cost_pixels_first_0_6 <= 0;
        coarseslice0cost_pixels_first_0_7 <= 0;
        coarseslice0cost_pixels_first_1_0 <= 0;
        coarseslice0cost_pixels_first_1_1 <= 0;
        coarseslice0cost_pixels_first_1_2 <= 0;
        coarseslice0cost_pixels_first_1_3 <= 0;
        coarseslice0cost_pixels_first_1_4 <= 0;
        coarseslice0cost_pixels_first_1_5 <= 0;
        coarseslice0cost_pixels_first_1_6 <= 0;
        coarseslice0cost_pixels_first_1_7 <= 0;
        coarseslice0cost_pixels_first_2_0 <= 0;
        coarseslice0cost_pixels_first_2_1 <= 0;
        coarseslice0cost_pixels_first_2_2 <= 0;
        coarseslice0cost_pixels_first_2_3 <= 0;
        coarseslice0cost_pixels_first_2_4 <= 0;
        coarseslice0cost_pixels_first_2_5 <= 0;
        coarseslice0cost_pixels_first_2_6 <= 0;
        coarseslice0cost_pixels_first_2_7 <= 0;
        coarseslice0cost_pixels_first_3_0 <= 0;
        coarseslice0cost_pixels_first_3_1 <= 0;
        coarseslice0cost_pixels_first_3_2 <= 0;
        coarseslice0cost_pixels_first_3_3 <= 0;
        coarseslice0cost_pixels_first_3_4 <= 0;
        coarseslice0cost_pixels_first_3_5 <= 0;
        coarseslice0cost_pixels_first_3_6 <= 0;
        coarseslice0cost_pixels_first_3_7 <= 0;
        coarseslice0cost_pixels_first_4_0 <= 0;
        coarseslice0cost_pixels_first_4_1 <= 0;
        coarseslice0cost_pixels_first_4_2 <= 0;
        coarseslice0cost_pixels_first_4_3 <= 0;
        coarseslice0cost_pixels_first_4_4 <= 0;
        coarseslice0cost_pixels_first_4_5 <= 0;
        coarseslice0cost_pixels_first_4_6 <= 0;
        coarseslice0cost_pixels_first_4_7 <= 0;
        coarseslice0cost_pixels_first_5_0 <= 0;
        coarseslice0cost_pixels_first_5_1 <= 0;
        coarseslice0cost_pixels_first_5_2 <= 0;
        coarseslice0cost_pixels_first_5_3 <= 0;
        coarseslice0cost_pixels_first_5_4 <= 0;
        coarseslice0cost_pixels_first_5_5 <= 0;
        coarseslice0cost_pixels_first_5_6 <= 0;
        coarseslice0cost_pixels_first_5_7 <= 0;
        coarseslice0cost_pixels_first_6_0 <= 0;
        coarseslice0cost_pixels_first_6_1 <= 0;
        coarseslice0cost_pixels_first_6_2 <= 0;
        coarseslice0cost_pixels_first_6_3 <= 0;
        coarseslice0cost_pixels_first_6_4 <= 0;
        coarseslice0cost_pixels_first_6_5 <= 0;
        coarseslice0cost_pixels_first_6_6 <= 0;
        coarseslice0cost_pixels_first_6_7 <= 0;
        coarseslice0cost_pixels_first_tag_valid <= false;
        coarseslice0cost_pixels_first_tag_border_column <= false;
        coarseslice0cost_pixels_first_tag_first_cost <= false;
        coarseslice0cost_pixels_first_tag_output_column <= false;
        coarseslice0cost_pixels_first_tag_start_of_frame <= false;
        coarseslice0cost_pixels_cost_0_0 <= 0;
        coarseslice0cost_pixels_cost_0_1 <= 0;
        coarseslice0cost_pixels_cost_0_2 <= 0;
        coarseslice0cost_pixels_cost_0_3 <= 0;
        coarseslice0cost_pixels_cost_0_4 <= 0;
        coarseslice0cost_pixels_cost_0_5 <= 0;
        coarseslice0cost_pixels_cost_0_6 <= 0;
        coarseslice0cost_pixels_cost_0_7 <= 0;
        coarseslice0cost_pixels_cost_1_0 <= 0;
        coarseslice0cost_pixels_cost_1_1 <= 0;
        coarseslice0cost_pixels_cost_1_2 <= 0;
        coarseslice0cost_pixels_cost_1_3 <= 0;
        coarseslice0cost_pixels_cost_1_4 <= 0;
        coarseslice0cost_pixels_cost_1_5 <= 0;
        coarseslice0cost_pixels_cost_1_6 <= 0;
        coarseslice0cost_pixels_cost_1_7 <= 0;
        coarseslice0cost_pixels_cost_2_0 <= 0;
        coarseslice0cost_pixels_cost_2_1 <= 0;
        coarseslice0cost_pixels_cost_2_2 <= 0;
        coarseslice0cost_pixels_cost_2_3 <= 0;
        coarseslice0cost_pixels_cost_2_4 <= 0;
        coarseslice0cost_pixels_cost_2_5 <= 0;
        coarseslice0cost_pixels_cost_2_6 <= 0;
        coarseslice0cost_pixels_cost_2_7 <= 0;
        coarseslice0cost_pixels_cost_3_0 <= 0;
        coarseslice0cost_pixels_cost_3_1 <= 0;
        coarseslice0cost_pixels_cost_3_2 <= 0;
        coarseslice0cost_pixels_cost_3_3 <= 0;
        coarseslice0cost_pixels_cost_3_4 <= 0;
        coarseslice0cost_pixels_cost_3_5 <= 0;
        coarseslice0cost_pixels_cost_3_6 <= 0;
        coarseslice0cost_pixels_cost_3_7 <= 0;
        coarseslice0cost_pixels_cost_4_0 <= 0;
        coarseslice0cost_pixels_cost_4_1 <= 0;
        coarseslice0cost_pixels_cost_4_2 <= 0;
        coarseslice0cost_pixels_cost_4_3 <= 0;
        coarseslice0cost_pixels_cost_4_4 <= 0;
        coarseslice0cost_pixels_cost_4_5 <= 0;
        coarseslice0cost_pixels_cost_4_6 <= 0;
        coarseslice0cost_pixels_cost_4_7 <= 0;
        coarseslice0cost_pixels_cost_5_0 <= 0;
        coarseslice0cost_pixels_cost_5_1 <= 0;
        coarseslice0cost_pixels_cost_5_2 <= 0;
        coarseslice0cost_pixels_cost_5_3 <= 0;
        coarseslice0cost_pixels_cost_5_4 <= 0;
        coarseslice0cost_pixels_cost_5_5 <= 0;
        coarseslice0cost_pixels_cost_5_6 <= 0;
        coarseslice0cost_pixels_cost_5_7 <= 0;
        coarseslice0cost_pixels_cost_6_0 <= 0;
        coarseslice0cost_pixels_cost_6_1 <= 0;
        coarseslice0cost_pixels_cost_6_2 <= 0;
        coarseslice0cost_pixels_cost_6_3 <= 0;
        coarseslice0cost_pixels_cost_6_4 <= 0;
        coarseslice0cost_pixels_cost_6_5 <= 0;
        coarseslice0cost_pixels_cost_6_6 <= 0;
        coarseslice0cost_pixels_cost_6_7 <= 0;
        coarseslice0cost_pixels_tag_valid <= false;
        coarseslice0cost_pixels_tag_border_column <= false;
        coarseslice0cost_pixels_tag_first_cost <= false;
        coarseslice0cost_pixels_tag_output_column <= false;
        coarseslice0cost_pixels_tag_start_of_frame <= false;
        coarseslice0cost_pair_0_0 <= 0;
        coarseslice0cost_pair_0_1 <= 0;
        coarseslice0cost_pair_0_2 <= 0;
        coarseslice0cost_pair_0_3 <= 0;
        coarseslice0cost_pair_0_4 <= 0;
        coarseslice0cost_pair_0_5 <= 0;
        coarseslice0cost_pair_0_6 <= 0;
        coarseslice0cost_pair_0_7 <= 0;
        coarseslice0cost_pair_1_0 <= 0;
        coarseslice0cost_pair_1_1 <= 0;
        coarseslice0cost_pair_1_2 <= 0;
        coarseslice0cost_pair_1_3 <= 0;
        coarseslice0cost_pair_1_4 <= 0;
        coarseslice0cost_pair_1_5 <= 0;
        coarseslice0cost_pair_1_6 <= 0;
        coarseslice0cost_pair_1_7 <= 0;
        coarseslice0cost_pair_2_0 <= 0;
        coarseslice0cost_pair_2_1 <= 0;
        coarseslice0cost_pair_2_2 <= 0;
        coarseslice0cost_pair_2_3 <= 0;
        coarseslice0cost_pair_2_4 <= 0;
        coarseslice0cost_pair_2_5 <= 0;
        coarseslice0cost_pair_2_6 <= 0;
        coarseslice0cost_pair_2_7 <= 0;
        coarseslice0cost_single_0_0 <= 0;
        coarseslice0cost_single_0_1 <= 0;
        coarseslice0cost_single_0_2 <= 0;
        coarseslice0cost_single_0_3 <= 0;
        coarseslice0cost_single_0_4 <= 0;
        coarseslice0cost_single_0_5 <= 0;
        coarseslice0cost_single_0_6 <= 0;
        coarseslice0cost_single_0_7 <= 0;
        coarseslice0cost_pair_tag_valid <= false;
        coarseslice0cost_pair_tag_border_column <= false;
        coarseslice0cost_pair_tag_first_cost <= false;
        coarseslice0cost_pair_tag_output_column <= false;
        coarseslice0cost_pair_tag_start_of_frame <= false;
        coarseslice0cost_column_0_0 <= 0;
        coarseslice0cost_column_0_1 <= 0;
        coarseslice0cost_column_0_2 <= 0;
        coarseslice0cost_column_0_3 <= 0;
        coarseslice0cost_column_0_4 <= 0;
        coarseslice0cost_column_0_5 <= 0;
        coarseslice0cost_column_0_6 <= 0;
        coarseslice0cost_column_0_7 <= 0;
        coarseslice0cost_tag_valid <= false;
        coarseslice0cost_tag_first_cost <= false;
        coarseslice0cost_tag_output_column <= false;
        coarseslice0cost_tag_start_of_frame <= false;
        coarseslice0window_partial_0_0_0 <= 0;
        coarseslice0window_partial_0_0_1 <= 0;
        coarseslice0window_partial_0_0_2 <= 0;
        coarseslice0window_partial_0_0_3 <= 0;
        coarseslice0window_partial_0_0_4 <= 0;
        coarseslice0window_partial_0_0_5 <= 0;
        coarseslice0window_partial_0_0_6 <= 0;
        coarseslice0window_partial_0_0_7 <= 0;
        coarseslice0window_partial_0_1_0 <= 0;
        coarseslice0window_partial_0_1_1 <= 0;
        coarseslice0window_partial_0_1_2 <= 0;
        coarseslice0window_partial_0_1_3 <= 0;
        coarseslice0window_partial_0_1_4 <= 0;
        coarseslice0window_partial_0_1_5 <= 0;
        coarseslice0window_partial_0_1_6 <= 0;
        coarseslice0window_partial_0_1_7 <= 0;
        coarseslice0window_partial_0_2_0 <= 0;
        coarseslice0window_partial_0_2_1 <= 0;
        coarseslice0window_partial_0_2_2 <= 0;
        coarseslice0window_partial_0_2_3 <= 0;
        coarseslice0window_partial_0_2_4 <= 0;
        coarseslice0window_partial_0_2_5 <= 0;
        coarseslice0window_partial_0_2_6 <= 0;
        coarseslice0window_partial_0_2_7 <= 0;
        coarseslice0window_partial_0_3_0 <= 0;
        coarseslice0window_partial_0_3_1 <= 0;
        coarseslice0window_partial_0_3_2 <= 0;
        coarseslice0window_partial_0_3_3 <= 0;
        coarseslice0window_partial_0_3_4 <= 0;
        coarseslice0window_partial_0_3_5 <= 0;
        coarseslice0window_partial_0_3_6 <= 0;
        coarseslice0window_partial_0_3_7 <= 0;
        coarseslice0window_partial_0_4_0 <= 0;
        coarseslice0window_partial_0_4_1 <= 0;
        coarseslice0window_partial_0_4_2 <= 0;
        coarseslice0window_partial_0_4_3 <= 0;
        coarseslice0window_partial_0_4_4 <= 0;
        coarseslice0window_partial_0_4_5 <= 0;
        coarseslice0window_partial_0_4_6 <= 0;
        coarseslice0window_partial_0_4_7 <= 0;
        coarseslice0window_partial_0_5_0 <= 0;
        coarseslice0window_partial_0_5_1 <= 0;
        coarseslice0window_partial_0_5_2 <= 0;
        coarseslice0window_partial_0_5_3 <= 0;
        coarseslice0window_partial_0_5_4 <= 0;
        coarseslice0window_partial_0_5_5 <= 0;
        coarseslice0window_partial_0_5_6 <= 0;
        coarseslice0window_partial_0_5_7 <= 0;
        coarseslice0window_centre_output_column_0 <= false;
        coarseslice0window_centre_output_column_1 <= false;
        coarseslice0window_centre_output_column_2 <= false;
        coarseslice0window_centre_first_column_0 <= false;
        coarseslice0window_centre_first_column_1 <= false;
        coarseslice0window_centre_first_column_2 <= false;
        coarseslice0window_centre_start_of_frame_0 <= false;
        coarseslice0window_centre_start_of_frame_1 <= false;
        coarseslice0window_centre_start_of_frame_2 <= false;
        coarseslice0window_sum_0_0 <= 0;
        coarseslice0window_sum_0_1 <= 0;
        coarseslice0window_sum_0_2 <= 0;
        coarseslice0window_sum_0_3 <= 0;
        coarseslice0window_sum_0_4 <= 0;
        coarseslice0window_sum_0_5 <= 0;
        coarseslice0window_sum_0_6 <= 0;
        coarseslice0window_sum_0_7 <= 0;
        coarseslice0window_tag_valid <= false;
        coarseslice0window_tag_output_column <= false;
        coarseslice0window_tag_first_column <= false;
        coarseslice0window_tag_start_of_frame <= false;
        coarseslice0other_cost_0_1 <= 0;
        coarseslice0other_cost_0_2 <= 0;
        coarseslice0other_cost_0_3 <= 0;
        coarseslice0other_cost_0_4 <= 0;
        coarseslice0other_cost_0_5 <= 0;
        coarseslice0other_cost_0_6 <= 0;
        coarseslice0other_cost_0_7 <= 0;
        coarseslice0other_winner_0_0 <= 0;
        coarseslice0other_winner_0_1 <= 0;
        coarseslice0other_winner_0_2 <= 0;
        coarseslice0other_winner_0_3 <= 0;
        coarseslice0other_winner_0_4 <= 0;
        coarseslice0other_winner_0_5 <= 0;
        coarseslice0other_winner_0_6 <= 0;
        coarseslice0other_winner_0_7 <= 0;
        coarseslice0other_winner_out_0 <= 0;
        coarseslice0winner1_of_pair_0_0 <= 0;
        coarseslice0winner1_of_pair_0_1 <= 0;
        coarseslice0winner1_of_pair_0_2 <= 0;
        coarseslice0winner1_of_pair_0_3 <= 0;
        coarseslice0winner1_of_pair_0_4 <= 0;
        coarseslice0winner1_of_pair_0_5 <= 0;
        coarseslice0winner1_of_pair_0_6 <= 0;
        coarseslice0winner1_of_pair_0_7 <= 0;
        coarseslice0winner1_pair_index_0_0 <= false;
        coarseslice0winner1_pair_index_0_1 <= 0;
        coarseslice0winner1_pair_index_0_2 <= 0;
        coarseslice0winner1_pair_index_0_3 <= 0;
        coarseslice0winner1_pair_tag_valid <= false;
        coarseslice0winner1_pair_tag_output_column <= false;
        coarseslice0winner1_pair_tag_start_of_frame <= false;
        coarseslice0winner1_of_four_0_0 <= 0;
        coarseslice0winner1_of_four_0_1 <= 0;
        coarseslice0winner1_of_four_0_2 <= 0;
        coarseslice0winner1_of_four_0_3 <= 0;
        coarseslice0winner1_of_four_0_4 <= 0;
        coarseslice0winner1_of_four_0_5 <= 0;
        coarseslice0winner1_of_four_0_6 <= 0;
        coarseslice0winner1_of_four_0_7 <= 0;
        coarseslice0winner1_four_index_0_0 <= 0;
        coarseslice0winner1_four_index_0_1 <= 0;
        coarseslice0winner1_four_tag_valid <= false;
        coarseslice0winner1_four_tag_output_column <= false;
        coarseslice0winner1_four_tag_start_of_frame <= false;
        coarseslice0winner1_best_cost_0_0 <= 0;
        coarseslice0winner1_best_cost_0_1 <= 0;
        coarseslice0winner1_best_index_0_0 <= 0;
        coarseslice0winner1_best_index_0_1 <= 0;
        coarseslice0winner1_tag_valid <= false;
        coarseslice0winner1_tag_output_column <= false;
        coarseslice0winner1_tag_start_of_frame <= false;
        coarseslice0winner2_best_index_0_0 <= 0;
        coarseslice0winner2_tag_valid <= false;
        coarseslice0winner2_tag_output_column <= false;
        coarseslice0winner2_tag_start_of_frame <= false;
        coarseslice0_best_index_0_0 <= 0;
        coarseslice0_best_tag_valid <= false;
        coarseslice0_best_tag_output_column <= false;
        coarseslice0_best_tag_start_of_frame <= false;
        coarseleftright_other_1_0 <= 0;
        coarseleftright_other_2_0 <= 0;
        coarseleftright_other_3_0 <= 0;
        coarseleftright_ring_read_address <= 1;
        coarseleftright_ring_write_address <= 0;
        coarseleftright_holds_winners <= false;
        coarseleftright_position <= 0;
        coarseleftright_held_position <= 0;
        coarseleftright_held_valid <= false;
        coarseleftright_address_0 <= 0;
        coarseleftright_asking_disparity_0 <= 0;
        coarseleftright_asking_passed_0 <= true;
        coarseleftright_asking_tag_valid <= false;
        coarseleftright_asking_tag_output_column <= false;
        coarseleftright_asking_tag_start_of_frame <= false;
        coarseleftright_answered_disparity_0 <= 0;
        coarseleftright_answered_passed_0 <= true;
        coarseleftright_answered_tag_valid <= false;
        coarseleftright_answered_tag_output_column <= false;
        coarseleftright_answered_tag_start_of_frame <= false;
        coarseleftright_checked_disparity_0 <= 0;
        coarseleftright_checked_passed_0 <= true;
        coarseleftright_checked_tag_valid <= false;
        coarseleftright_checked_tag_output_column <= false;
        coarseleftright_checked_tag_start_of_frame <= false;
        ranges_column <= 0;
        ranges_row <= 9;
        ranges_pixel_0 <= 0;
        ranges_in_column <= 0;
        ranges_in_row <= 0;
        ranges_in_valid <= false;
        ranges_pixels_read_newest_0 <= 0;
        ranges_pixels_ready_words_0 <= 0;
        ranges_pixels_ready_newest_0 <= 0;
        ranges_pixels_write_words_0 <= 0;
        ranges_read_column <= 0;
        ranges_read_row <= 0;
        ranges_read_valid <= false;
        ranges_ready_column <= 0;
        ranges_ready_row <= 0;
        ranges_ready_valid <= false;
        ranges_pixels_written <= 0;
        ranges_left <= 0;
        ranges_above <= 0;
        ranges_middle <= 0;
        ranges_below <= 0;
        ranges_next_above <= 0;
        ranges_right <= 0;
        ranges_next_below <= 0;
        ranges_centre_column <= 0;
        ranges_centre_row <= 0;
        ranges_centre_valid <= false;
        ranges_counts <= false;
        ranges_disparity <= 0;
        ranges_counted_column <= 0;
        ranges_counted_row <= 0;
        ranges_counted_valid <= false;
        ranges_first_of_pair <= 0;
        ranges_pair_0 <= 0;
        ranges_paired_column <= 0;
        ranges_paired_row <= 0;
        ranges_paired_valid <= false;
        ranges_pairs_read_newest_0 <= 0;
        ranges_pairs_ready_words_0 <= 0;
        ranges_pairs_ready_newest_0 <= 0;
        ranges_pairs_write_words_0 <= 0;
        ranges_pair_read_column <= 0;
        ranges_pair_read_row <= 0;
        ranges_pair_read_valid <= false;
        ranges_pair_ready_column <= 0;
        ranges_pair_ready_row <= 0;
        ranges_pair_ready_valid <= false;
        ranges_pairs_written <= 0;
        ranges_range <= 0;
        ranges_block_column <= 0;
        ranges_block_row <= 0;
        ranges_valid <= false;
        targets_newest_0 <= 0;
        targets_read_column <= 0;
        targets_comes <= false;
        targets_pause <= 6;
        targets_walked <= 9;
        targets_walk_place <= 0;
        targets_next_band <= 0;
        targets_last_row <= false;
        targets_again <= false;
        targets_walk_column <= 0;
        targets_walk_band <= 0;
        targets_walk_has_above <= false;
        targets_walk_has_below <= false;
        targets_walk_valid <= false;
        targets_rows_read_newest_0 <= 0;
        targets_rows_ready_words_0 <= 0;
        targets_rows_ready_newest_0 <= 0;
        targets_rows_write_words_0 <= 0;
        targets_read_comes <= false;
        targets_ready_comes <= false;
        targets_read_place <= 0;
        targets_ready_place <= 0;
        targets_write_column <= 0;
        targets_read_walk_column <= 0;
        targets_read_walk_band <= 0;
        targets_read_walk_has_above <= false;
        targets_read_walk_has_below <= false;
        targets_read_walk_valid <= false;
        targets_ready_walk_column <= 0;
        targets_ready_walk_band <= 0;
        targets_ready_walk_has_above <= false;
        targets_ready_walk_has_below <= false;
        targets_ready_walk_valid <= false;
        targets_column_range <= 0;
        targets_column_walk_column <= 0;
        targets_column_walk_band <= 0;
        targets_column_walk_valid <= false;
        targets_behind <= 0;
        targets_here <= 0;
        targets_around <= 0;
        targets_around_walk_column <= 0;
        targets_around_walk_band <= 0;
        targets_around_walk_valid <= false;
        targets_low_wish <= 0;
        targets_high_wish <= 0;
        targets_known <= false;
        targets_wish_walk_column <= 0;
        targets_wish_walk_band <= 0;
        targets_wish_walk_valid <= false;
        targets_low <= 0;
        targets_high <= 0;
        targets_place <= 0;
        hold_back_ring_read_address <= 1;
        hold_back_ring_write_address <= 0;
        hold_back_holds_groups <= false;
        hold_back_held_is_new <= false;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 36;
        transform_counter_next_frame <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_filtering_0_start_of_frame <= false;
        transform_filtering_0_valid <= false;
        transform_filtering_1_start_of_frame <= false;
        transform_filtering_1_valid <= false;
        transform_filtering_2_start_of_frame <= false;
        transform_filtering_2_valid <= false;
        transform_filtering_3_start_of_frame <= false;
        transform_filtering_3_valid <= false;
        transform_filtering_4_start_of_frame <= false;
        transform_filtering_4_valid <= false;
        transform_filtering_5_start_of_frame <= false;
        transform_filtering_5_valid <= false;
        transform_filtering_6_start_of_frame <= false;
        transform_filtering_6_valid <= false;
        transform_filtering_7_start_of_frame <= false;
        transform_filtering_7_valid <= false;
        ahead_ring_read_address <= 1;
        ahead_ring_write_address <= 0;
        ahead_holds_groups <= false;
        ahead_held_is_new <= false;
        ahead_held_valid <= false;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 34;
        bases_address_0 <= 0;
        bases_address_1 <= 0;
        bases_asked_limit <= 0;
        bases_asked_head <= false;
        bases_asked_valid <= false;
        bases_read_limit <= 0;
        bases_read_head <= false;
        bases_read_valid <= false;
        bases_ready_targets_0 <= 0;
        bases_ready_targets_1 <= 0;
        bases_ready_limit <= 0;
        bases_ready_head <= false;
        bases_ready_valid <= false;
        bases_goal_0_0 <= 0;
        bases_goal_0_1 <= 0;
        bases_goal_1_0 <= 0;
        bases_goal_1_1 <= 0;
        bases_wanted_head <= false;
        bases_wanted_valid <= false;
        bases_base_0_0 <= 0;
        bases_base_0_1 <= 0;
        bases_base_1_0 <= 0;
        bases_base_1_1 <= 0;
        bases_rises_0_0 <= false;
        bases_rises_0_1 <= false;
        bases_rises_1_0 <= false;
        bases_rises_1_1 <= false;
        bases_falls_0_0 <= false;
        bases_falls_0_1 <= false;
        bases_falls_1_0 <= false;
        bases_falls_1_1 <= false;
        bases_stands_valid <= false;
        rows_newest_column <= 0;
        rows_wanted_one_0_0 <= false;
        rows_wanted_one_0_1 <= false;
        rows_wanted_one_1_0 <= false;
        rows_wanted_one_1_1 <= false;
        rows_wanted_four_0_0 <= false;
        rows_wanted_four_0_1 <= false;
        rows_wanted_four_1_0 <= false;
        rows_wanted_four_1_1 <= false;
        rows_asked_one_0_0 <= false;
        rows_asked_one_0_1 <= false;
        rows_asked_one_1_0 <= false;
        rows_asked_one_1_1 <= false;
        rows_asked_four_0_0 <= false;
        rows_asked_four_0_1 <= false;
        rows_asked_four_1_0 <= false;
        rows_asked_four_1_1 <= false;
        rows_read_one_0_0 <= false;
        rows_read_one_0_1 <= false;
        rows_read_one_1_0 <= false;
        rows_read_one_1_1 <= false;
        rows_read_four_0_0 <= false;
        rows_read_four_0_1 <= false;
        rows_read_four_1_0 <= false;
        rows_read_four_1_1 <= false;
        rows_ready_one_0_0 <= false;
        rows_ready_one_0_1 <= false;
        rows_ready_one_1_0 <= false;
        rows_ready_one_1_1 <= false;
        rows_ready_four_0_0 <= false;
        rows_ready_four_0_1 <= false;
        rows_ready_four_1_0 <= false;
        rows_ready_four_1_1 <= false;
        rows_step_one_0_0 <= false;
        rows_step_one_0_1 <= false;
        rows_step_one_1_0 <= false;
        rows_step_one_1_1 <= false;
        rows_step_four_0_0 <= false;
        rows_step_four_0_1 <= false;
        rows_step_four_1_0 <= false;
        rows_step_four_1_1 <= false;
        pairs_tag_output_column <= false;
        pairs_tag_start_of_frame <= false;
        pairs_tag_end_of_line <= false;
        compared_read_tag_output_column <= false;
        compared_read_tag_start_of_frame <= false;
        compared_read_tag_end_of_line <= false;
        compared_ready_tag_output_column <= false;
        compared_ready_tag_start_of_frame <= false;
        compared_ready_tag_end_of_line <= false;
        compared_tags_0_output_column <= false;
        compared_tags_0_start_of_frame <= false;
        compared_tags_0_end_of_line <= false;
        compared_tags_1_output_column <= false;
        compared_tags_1_start_of_frame <= false;
        compared_tags_1_end_of_line <= false;
        compared_tags_2_valid <= false;
        compared_tags_2_output_column <= false;
        compared_tags_2_start_of_frame <= false;
        compared_tags_2_end_of_line <= false;
        compared_tags_3_valid <= false;
        compared_tags_3_output_column <= false;
        compared_tags_3_start_of_frame <= false;
        compared_tags_3_end_of_line <= false;
        compared_tags_4_valid <= false;
        compared_tags_4_output_column <= false;
        compared_tags_4_start_of_frame <= false;
        compared_tags_4_end_of_line <= false;
        compared_tags_5_valid <= false;
        compared_tags_5_output_column <= false;
        compared_tags_5_start_of_frame <= false;
        compared_tags_5_end_of_line <= false;
        compared_tags_6_valid <= false;
        compared_tags_6_output_column <= false;
        compared_tags_6_start_of_frame <= false;
        compared_tags_6_end_of_line <= false;
        compared_tags_7_valid <= false;
        compared_tags_7_output_column <= false;
        compared_tags_7_start_of_frame <= false;
        compared_tags_7_end_of_line <= false;
        lowcost_pixels_first_tag_valid <= false;
        lowcost_pixels_first_tag_output_column <= false;
        lowcost_pixels_first_tag_start_of_frame <= false;
        lowcost_pixels_first_tag_end_of_line <= false;
        lowcost_pixels_tag_valid <= false;
        lowcost_pixels_tag_output_column <= false;
        lowcost_pixels_tag_start_of_frame <= false;
        lowcost_pixels_tag_end_of_line <= false;
        lowcost_ready_tag_valid <= false;
        lowcost_ready_tag_output_column <= false;
        lowcost_ready_tag_start_of_frame <= false;
        lowcost_ready_tag_end_of_line <= false;
        lowcost_tag_valid <= false;
        lowcost_tag_output_column <= false;
        lowcost_tag_start_of_frame <= false;
        lowcost_tag_end_of_line <= false;
        lowwindow_entering_tag_valid <= false;
        lowwindow_entering_tag_output_column <= false;
        lowwindow_entering_tag_start_of_frame <= false;
        lowwindow_entering_tag_end_of_line <= false;
        lowwindow_change_tag_valid <= false;
        lowwindow_change_tag_output_column <= false;
        lowwindow_change_tag_start_of_frame <= false;
        lowwindow_change_tag_end_of_line <= false;
        lowwindow_centre_output_column_0 <= false;
        lowwindow_centre_output_column_1 <= false;
        lowwindow_centre_start_of_frame_0 <= false;
        lowwindow_centre_start_of_frame_1 <= false;
        lowwindow_centre_end_of_line_0 <= false;
        lowwindow_centre_end_of_line_1 <= false;
        lowwindow_tag_valid <= false;
        lowwindow_tag_output_column <= false;
        lowwindow_tag_start_of_frame <= false;
        lowwindow_tag_end_of_line <= false;
        lowwinner1_pair_tag_valid <= false;
        lowwinner1_pair_tag_output_column <= false;
        lowwinner1_pair_tag_start_of_frame <= false;
        lowwinner1_pair_tag_end_of_line <= false;
        lowwinner1_four_tag_valid <= false;
        lowwinner1_four_tag_output_column <= false;
        lowwinner1_four_tag_start_of_frame <= false;
        lowwinner1_four_tag_end_of_line <= false;
        lowwinner1_tag_valid <= false;
        lowwinner1_tag_output_column <= false;
        lowwinner1_tag_start_of_frame <= false;
        lowwinner1_tag_end_of_line <= false;
        lowwinner2_pair_tag_valid <= false;
        lowwinner2_pair_tag_output_column <= false;
        lowwinner2_pair_tag_start_of_frame <= false;
        lowwinner2_pair_tag_end_of_line <= false;
        lowwinner2_four_tag_valid <= false;
        lowwinner2_four_tag_output_column <= false;
        lowwinner2_four_tag_start_of_frame <= false;
        lowwinner2_four_tag_end_of_line <= false;
        lowwinner2_tag_valid <= false;
        lowwinner2_tag_output_column <= false;
        lowwinner2_tag_start_of_frame <= false;
        lowwinner2_tag_end_of_line <= false;
        choice_best_tag_valid <= false;
        choice_best_tag_output_column <= false;
        choice_best_tag_start_of_frame <= false;
        choice_best_tag_end_of_line <= false;
        map_valid <= false;
        map_start_of_frame <= false;
        map_end_of_line <= false;
        other_12 <= 0;
        other_13 <= 0;
        other_14 <= 0;
        other_15 <= 0;
        other_16 <= 0;
        other_17 <= 0;
        other_18 <= 0;
        other_19 <= 0;
        other_20 <= 0;
        other_21 <= 0;
        other_22 <= 0;
      end if;
    end if;
  end process;
end architecture;
