-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm_road: 40x12, 12 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: disparities 12, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 5, p1 7, p2 60,
--   p2_least 20, above_p1 5, above_p2 31, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm_road
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm_road is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 34;
    flush_groups : positive := 209;
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
  assert width_px = 40 report "stereo_core_tiny_sgm_road: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm_road: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm_road: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm_road: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_sgm_road: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_sgm_road: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 34 report "stereo_core_tiny_sgm_road: latency_clocks is " & integer'image(latency_clocks) & " but this core has 34" severity failure;
  assert flush_groups = 209 report "stereo_core_tiny_sgm_road: flush_groups is " & integer'image(flush_groups) & " but this core has 209" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm_road: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm_road is
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
  signal in_right_pixel : natural range 0 to 255;
  signal in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_left_column_0, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_4, transform_right_column_0, transform_right_column_2 : natural range 0 to 255;
  signal transform_right_column_4, transform_left_filter_column_0_0 : natural range 0 to 255;
  signal transform_left_filter_column_0_2, transform_left_filter_column_0_4 : natural range 0 to 255;
  signal transform_left_filter_column_1_0, transform_left_filter_column_1_2 : natural range 0 to 255;
  signal transform_left_filter_column_1_4, transform_left_filter_column_2_0 : natural range 0 to 255;
  signal transform_left_filter_column_2_2, transform_left_filter_column_2_4 : natural range 0 to 255;
  signal transform_left_filter_column_3_0, transform_left_filter_column_3_2 : natural range 0 to 255;
  signal transform_left_filter_column_3_4, transform_left_filter_column_4_0 : natural range 0 to 255;
  signal transform_left_filter_column_4_2, transform_left_filter_column_4_4 : natural range 0 to 255;
  signal transform_left_filter_column_5_0, transform_left_filter_column_5_2 : natural range 0 to 255;
  signal transform_left_filter_column_5_4, transform_left_filter_column_6_0 : natural range 0 to 255;
  signal transform_left_filter_column_6_2, transform_left_filter_column_6_4 : natural range 0 to 255;
  signal transform_left_filter_column_7_0, transform_left_filter_column_7_2 : natural range 0 to 255;
  signal transform_left_filter_column_7_4, transform_left_filter_column_8_0 : natural range 0 to 255;
  signal transform_left_filter_column_8_2, transform_left_filter_column_8_4 : natural range 0 to 255;
  signal transform_right_filter_column_0_0, transform_right_filter_column_0_2 : natural range 0 to 255;
  signal transform_right_filter_column_0_4, transform_right_filter_column_1_0 : natural range 0 to 255;
  signal transform_right_filter_column_1_2, transform_right_filter_column_1_4 : natural range 0 to 255;
  signal transform_right_filter_column_2_0, transform_right_filter_column_2_2 : natural range 0 to 255;
  signal transform_right_filter_column_2_4, transform_right_filter_column_3_0 : natural range 0 to 255;
  signal transform_right_filter_column_3_2, transform_right_filter_column_3_4 : natural range 0 to 255;
  signal transform_right_filter_column_4_0, transform_right_filter_column_4_2 : natural range 0 to 255;
  signal transform_right_filter_column_4_4, transform_right_filter_column_5_0 : natural range 0 to 255;
  signal transform_right_filter_column_5_2, transform_right_filter_column_5_4 : natural range 0 to 255;
  signal transform_right_filter_column_6_0, transform_right_filter_column_6_2 : natural range 0 to 255;
  signal transform_right_filter_column_6_4, transform_right_filter_column_7_0 : natural range 0 to 255;
  signal transform_right_filter_column_7_2, transform_right_filter_column_7_4 : natural range 0 to 255;
  signal transform_right_filter_column_8_0, transform_right_filter_column_8_2 : natural range 0 to 255;
  signal transform_right_filter_column_8_4 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_row_inside_4, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_4, transform_read_column_inside_6 : boolean;
  signal transform_read_column_inside_8, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_row_inside_4 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_2 : boolean;
  signal transform_columns_row_inside_4, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_column_inside_8, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 16383;
  signal delay_delayed_0 : unsigned(13 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_map_column, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search_0, rows_search_1, rows_search_2, rows_reference_0, rows_reference_1 : natural range 0 to 16383;
  signal rows_reference_2 : natural range 0 to 16383;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_map_column : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 16383;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_1_0 : natural range 0 to 16383;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 16383;
  signal slice0shift_search_1_4, slice0shift_search_2_0, slice0shift_search_2_1 : natural range 0 to 16383;
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : natural range 0 to 16383;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 16383;
  signal slice0shift_search_out_0, slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 16383;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0_count_0, slice0cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_2, slice0cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_0, slice0cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_2, slice0cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_0, slice0cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_2, slice0cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_0, slice0cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_2, slice0cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_0, slice0cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_2, slice0cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_0, slice0cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_2, slice0cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_0, slice0cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_2, slice0cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_0, slice0cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_2, slice0cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_0, slice0cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_2, slice0cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_0, slice0cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_2, slice0cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_0, slice0cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_2, slice0cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_0, slice0cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_2, slice0cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_0, slice0cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_2, slice0cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_0, slice0cost_pixels_first_2_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_2, slice0cost_pixels_first_2_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_0, slice0cost_pixels_first_2_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_2, slice0cost_pixels_first_2_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_4, slice0cost_pixels_first_0_1_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_2_count_4, slice0cost_pixels_first_0_3_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_4_count_4, slice0cost_pixels_first_1_0_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_1_count_4, slice0cost_pixels_first_1_2_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_3_count_4, slice0cost_pixels_first_1_4_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_0_count_4, slice0cost_pixels_first_2_1_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_2_count_4, slice0cost_pixels_first_2_3_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_4_count_4 : natural range 0 to 2;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_map_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_map_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_first_cost, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_start_of_frame : boolean;
  signal slice0cost_pair_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_border_column : boolean;
  signal slice0cost_tag_first_cost, slice0cost_tag_map_column, slice0cost_tag_output_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 14;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_1_0 : natural range 0 to 14;
  signal slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3 : natural range 0 to 14;
  signal slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1 : natural range 0 to 14;
  signal slice0cost_pixels_cost_2_2, slice0cost_pixels_cost_2_3, slice0cost_pixels_cost_2_4 : natural range 0 to 14;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 14;
  signal slice0cost_single_0_3, slice0cost_single_0_4 : natural range 0 to 14;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 28;
  signal slice0cost_pair_0_4 : natural range 0 to 28;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 42;
  signal slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 42;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 42;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4 : natural range 0 to 42;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 84;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4 : natural range 0 to 84;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 126;
  signal slice0window_sum_0_3, slice0window_sum_0_4 : natural range 0 to 126;
  -- slice0
  signal slice0_held_0_0, slice0_held_0_1, slice0_held_0_2, slice0_held_0_3, slice0_held_0_4 : natural range 0 to 15;
  signal slice0_held_1_0, slice0_held_1_1, slice0_held_1_2, slice0_held_1_3, slice0_held_1_4 : natural range 0 to 15;
  signal slice0_held_2_0, slice0_held_2_1, slice0_held_2_2, slice0_held_2_3, slice0_held_2_4 : natural range 0 to 15;
  signal slice0_tag_0_valid, slice0_tag_0_map_column, slice0_tag_0_output_column, slice0_tag_0_first_column : boolean;
  signal slice0_tag_0_start_of_frame, slice0_tag_0_end_of_line, slice0_tag_1_valid, slice0_tag_1_map_column : boolean;
  signal slice0_tag_1_output_column, slice0_tag_1_first_column, slice0_tag_1_start_of_frame : boolean;
  signal slice0_tag_1_end_of_line, slice0_tag_2_valid, slice0_tag_2_map_column, slice0_tag_2_output_column : boolean;
  signal slice0_tag_2_first_column, slice0_tag_2_start_of_frame, slice0_tag_2_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 16383;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_1_0 : natural range 0 to 16383;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 16383;
  signal slice1shift_search_1_4, slice1shift_search_2_0, slice1shift_search_2_1 : natural range 0 to 16383;
  signal slice1shift_search_2_2, slice1shift_search_2_3, slice1shift_search_2_4 : natural range 0 to 16383;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 16383;
  signal slice1shift_search_out_0, slice1shift_search_out_1, slice1shift_search_out_2 : natural range 0 to 16383;
  -- slice1cost
  signal slice1cost_pixels_first_0_0_count_0, slice1cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_2, slice1cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_0, slice1cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_2, slice1cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_0, slice1cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_2, slice1cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_0, slice1cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_2, slice1cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_0, slice1cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_2, slice1cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_0, slice1cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_2, slice1cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_0, slice1cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_2, slice1cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_0, slice1cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_2, slice1cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_0, slice1cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_2, slice1cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_0, slice1cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_2, slice1cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_0, slice1cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_2, slice1cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_0, slice1cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_2, slice1cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_0, slice1cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_2, slice1cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_0, slice1cost_pixels_first_2_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_2, slice1cost_pixels_first_2_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_0, slice1cost_pixels_first_2_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_2, slice1cost_pixels_first_2_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_4, slice1cost_pixels_first_0_1_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_0_2_count_4, slice1cost_pixels_first_0_3_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_0_4_count_4, slice1cost_pixels_first_1_0_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_1_1_count_4, slice1cost_pixels_first_1_2_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_1_3_count_4, slice1cost_pixels_first_1_4_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_2_0_count_4, slice1cost_pixels_first_2_1_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_2_2_count_4, slice1cost_pixels_first_2_3_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_first_2_4_count_4 : natural range 0 to 2;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 14;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_1_0 : natural range 0 to 14;
  signal slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3 : natural range 0 to 14;
  signal slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_2_0, slice1cost_pixels_cost_2_1 : natural range 0 to 14;
  signal slice1cost_pixels_cost_2_2, slice1cost_pixels_cost_2_3, slice1cost_pixels_cost_2_4 : natural range 0 to 14;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 14;
  signal slice1cost_single_0_3, slice1cost_single_0_4 : natural range 0 to 14;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 28;
  signal slice1cost_pair_0_4 : natural range 0 to 28;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 42;
  signal slice1cost_column_0_3, slice1cost_column_0_4 : natural range 0 to 42;
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 42;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4 : natural range 0 to 42;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 84;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4 : natural range 0 to 84;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 126;
  signal slice1window_sum_0_3, slice1window_sum_0_4 : natural range 0 to 126;
  -- slice1
  signal slice1_held_0_0, slice1_held_0_1, slice1_held_0_2, slice1_held_0_3, slice1_held_0_4 : natural range 0 to 15;
  signal slice1_held_1_0, slice1_held_1_1, slice1_held_1_2, slice1_held_1_3, slice1_held_1_4 : natural range 0 to 15;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 16383;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 16383;
  signal slice2shift_reference_0, slice2shift_reference_1, slice2shift_reference_2 : natural range 0 to 16383;
  -- slice2cost
  signal slice2cost_pixels_first_0_0_count_0, slice2cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_2, slice2cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_0, slice2cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_2, slice2cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_0, slice2cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_2, slice2cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_0, slice2cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_2, slice2cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_0, slice2cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_2, slice2cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_0, slice2cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_2, slice2cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_4, slice2cost_pixels_first_0_1_count_4 : natural range 0 to 2;
  signal slice2cost_pixels_first_1_0_count_4, slice2cost_pixels_first_1_1_count_4 : natural range 0 to 2;
  signal slice2cost_pixels_first_2_0_count_4, slice2cost_pixels_first_2_1_count_4 : natural range 0 to 2;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_1_0 : natural range 0 to 14;
  signal slice2cost_pixels_cost_1_1, slice2cost_pixels_cost_2_0, slice2cost_pixels_cost_2_1 : natural range 0 to 14;
  signal slice2cost_single_0_0, slice2cost_single_0_1 : natural range 0 to 14;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 28;
  signal slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 42;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1 : natural range 0 to 42;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1 : natural range 0 to 84;
  signal slice2window_sum_0_0, slice2window_sum_0_1 : natural range 0 to 126;
  -- slice2
  signal slice2_held_0_0, slice2_held_0_1 : natural range 0 to 15;
  -- entry
  signal entry_next_cost_0, entry_next_cost_1, entry_next_cost_2, entry_next_cost_3 : natural range 0 to 15;
  signal entry_next_cost_4, entry_next_cost_5, entry_next_cost_6, entry_next_cost_7 : natural range 0 to 15;
  signal entry_next_cost_8, entry_next_cost_9, entry_next_cost_10, entry_next_cost_11 : natural range 0 to 15;
  signal entry_cost_0, entry_cost_1, entry_cost_2, entry_cost_3, entry_cost_4, entry_cost_5 : natural range 0 to 15;
  signal entry_cost_6, entry_cost_7, entry_cost_8, entry_cost_9, entry_cost_10, entry_cost_11 : natural range 0 to 15;
  signal entry_next_tag_valid, entry_next_tag_map_column, entry_next_tag_first_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_map_column, entry_tag_first_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 31;
  -- forward
  signal forward_smallest_smallest_0, forward_smallest_smallest_1, forward_smallest_smallest_2 : natural range 0 to 15;
  signal forward_smallest_smallest_3, forward_smallest_smallest_4, forward_smallest_smallest_5 : natural range 0 to 15;
  signal forward_smallest_next_smallest_0, forward_smallest_next_smallest_1 : natural range 0 to 15;
  signal forward_smallest_next_smallest_2, forward_smallest_next_next_smallest_0 : natural range 0 to 15;
  signal forward_smallest_next_next_smallest_1, forward_smallest_next_next_next_smallest_0 : natural range 0 to 15;
  signal forward_above_ready_cost_0, forward_above_ready_cost_1, forward_above_ready_cost_2 : natural range 0 to 15;
  signal forward_above_ready_cost_3, forward_above_ready_cost_4, forward_above_ready_cost_5 : natural range 0 to 15;
  signal forward_above_ready_cost_6, forward_above_ready_cost_7, forward_above_ready_cost_8 : natural range 0 to 15;
  signal forward_above_ready_cost_9, forward_above_ready_cost_10, forward_above_ready_cost_11 : natural range 0 to 15;
  signal forward_smallest_cost_0, forward_smallest_cost_1, forward_smallest_cost_2 : natural range 0 to 15;
  signal forward_smallest_cost_3, forward_smallest_cost_4 : natural range 0 to 15;
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_0_0, forward_cost_0_1, forward_cost_0_2, forward_cost_0_3 : natural range 0 to 7;
  signal forward_cost_0_4, forward_cost_0_5, forward_cost_0_6, forward_cost_0_7 : natural range 0 to 7;
  signal forward_cost_0_8, forward_cost_0_9, forward_cost_0_10, forward_cost_0_11 : natural range 0 to 7;
  signal forward_cost_1_0, forward_cost_1_1, forward_cost_1_2, forward_cost_1_3 : natural range 0 to 7;
  signal forward_cost_1_4, forward_cost_1_5, forward_cost_1_6, forward_cost_1_7 : natural range 0 to 7;
  signal forward_cost_1_8, forward_cost_1_9, forward_cost_1_10, forward_cost_1_11 : natural range 0 to 7;
  signal forward_cost_2_0, forward_cost_2_1, forward_cost_2_2, forward_cost_2_3 : natural range 0 to 7;
  signal forward_cost_2_4, forward_cost_2_5, forward_cost_2_6, forward_cost_2_7 : natural range 0 to 7;
  signal forward_cost_2_8, forward_cost_2_9, forward_cost_2_10, forward_cost_2_11 : natural range 0 to 7;
  signal forward_cost_3_0, forward_cost_3_1, forward_cost_3_2, forward_cost_3_3 : natural range 0 to 7;
  signal forward_cost_3_4, forward_cost_3_5, forward_cost_3_6, forward_cost_3_7 : natural range 0 to 7;
  signal forward_cost_3_8, forward_cost_3_9, forward_cost_3_10, forward_cost_3_11 : natural range 0 to 7;
  signal forward_cost_delay_held_0, forward_above_read_words_0, forward_above_read_words_1 : unsigned(31 downto 0);
  signal forward_above_ready_words_0, forward_above_ready_words_1, forward_above_write_words_0 : unsigned(31 downto 0);
  signal forward_above_write_words_1 : unsigned(31 downto 0);
  signal forward_cost_delay_held_1 : unsigned(7 downto 0);
  signal forward_left_pair_0, forward_left_pair_1, forward_left_pair_2, forward_left_pair_3 : natural range 0 to 127;
  signal forward_left_pair_4, forward_left_pair_5, forward_left_tree_smallest_0 : natural range 0 to 127;
  signal forward_left_tree_smallest_1, forward_left_tree_smallest_2 : natural range 0 to 127;
  signal forward_left_tree_next_smallest_0, forward_left_tree_next_smallest_1 : natural range 0 to 127;
  signal forward_left_tree_next_next_smallest_0, forward_left_smallest : natural range 0 to 127;
  signal forward_left_smallest_less, forward_left_relief_leaves, forward_left_g_copy_0 : natural range 0 to 127;
  signal forward_left_g_less_copy_0, forward_left_stay_change_0, forward_left_stay_change_1 : natural range 0 to 127;
  signal forward_left_stay_change_2, forward_left_stay_change_3, forward_left_stay_change_4 : natural range 0 to 127;
  signal forward_left_stay_change_5, forward_left_stay_change_6, forward_left_stay_change_7 : natural range 0 to 127;
  signal forward_left_stay_change_8, forward_left_stay_change_9, forward_left_stay_change_10 : natural range 0 to 127;
  signal forward_left_stay_change_11, forward_left_step_change_0, forward_left_step_change_1 : natural range 0 to 127;
  signal forward_left_step_change_2, forward_left_step_change_3, forward_left_step_change_4 : natural range 0 to 127;
  signal forward_left_step_change_5, forward_left_step_change_6, forward_left_step_change_7 : natural range 0 to 127;
  signal forward_left_step_change_8, forward_left_step_change_9, forward_left_step_change_10 : natural range 0 to 127;
  signal forward_left_step_change_11, forward_left_cost_0, forward_left_cost_1 : natural range 0 to 127;
  signal forward_left_cost_2, forward_left_cost_3, forward_left_cost_4, forward_left_cost_5 : natural range 0 to 127;
  signal forward_left_cost_6, forward_left_cost_7, forward_left_cost_8, forward_left_cost_9 : natural range 0 to 127;
  signal forward_left_cost_10, forward_left_cost_11, forward_left_arrived_0 : natural range 0 to 127;
  signal forward_left_arrived_1, forward_left_arrived_2, forward_left_arrived_3 : natural range 0 to 127;
  signal forward_left_arrived_4, forward_left_arrived_5, forward_left_arrived_6 : natural range 0 to 127;
  signal forward_left_arrived_7, forward_left_arrived_8, forward_left_arrived_9 : natural range 0 to 127;
  signal forward_left_arrived_10, forward_left_arrived_11 : natural range 0 to 127;
  signal forward_left_start_cost_0, forward_left_start_cost_1, forward_left_start_cost_2 : natural range 0 to 63;
  signal forward_left_start_cost_3, forward_left_start_cost_4, forward_left_start_cost_5 : natural range 0 to 63;
  signal forward_left_start_cost_6, forward_left_room, forward_left_relief_next_0 : natural range 0 to 63;
  signal forward_left_relief_past_0, forward_left_relief_past_1, forward_left_relief_past_2 : natural range 0 to 63;
  signal forward_left_relief_past_3, forward_left_relief_past_4, forward_left_relief_past_5 : natural range 0 to 63;
  signal forward_left_relief_pairs_0, forward_left_relief_pairs_1, forward_left_relief_fours_0 : natural range 0 to 63;
  signal forward_left_relief_older, forward_left_relief_recent, forward_left_relief_largest : natural range 0 to 63;
  signal forward_left_relief_beyond, forward_above_cost_0, forward_above_cost_1 : natural range 0 to 63;
  signal forward_above_cost_2, forward_above_cost_3, forward_above_cost_4, forward_above_cost_5 : natural range 0 to 63;
  signal forward_above_cost_6, forward_above_cost_7, forward_above_cost_8, forward_above_cost_9 : natural range 0 to 63;
  signal forward_above_cost_10, forward_above_cost_11, forward_above_beside_0 : natural range 0 to 63;
  signal forward_above_beside_1, forward_above_beside_2, forward_above_beside_3 : natural range 0 to 63;
  signal forward_above_beside_4, forward_above_beside_5, forward_above_beside_6 : natural range 0 to 63;
  signal forward_above_beside_7, forward_above_beside_8, forward_above_beside_9 : natural range 0 to 63;
  signal forward_above_beside_10, forward_above_beside_11, forward_above_own_0 : natural range 0 to 63;
  signal forward_above_own_2, forward_above_own_3, forward_above_own_4, forward_above_own_5 : natural range 0 to 63;
  signal forward_above_own_6, forward_above_own_7, forward_above_own_8, forward_above_own_9 : natural range 0 to 63;
  signal forward_above_own_11, forward_reliefs_moved_0, forward_reliefs_moved_1 : natural range 0 to 63;
  signal forward_reliefs_moved_2, forward_reliefs_moved_3, forward_reliefs_moved_4 : natural range 0 to 63;
  signal forward_reliefs_moved_5, forward_reliefs_moved_6, forward_reliefs_moved_7 : natural range 0 to 63;
  signal forward_reliefs_moved_8 : natural range 0 to 63;
  signal forward_left_first_0, forward_left_first_1, forward_left_first_2, forward_above_ready_top : boolean;
  signal forward_above_comes_0, forward_above_comes_1, forward_above_comes_2, forward_above_comes_3 : boolean;
  signal forward_above_comes_4, forward_above_comes_5, forward_above_comes_6, forward_above_comes_7 : boolean;
  signal forward_above_comes_8, forward_above_comes_9, forward_above_writes_copy_0, forward_first_0 : boolean;
  signal forward_first_1, forward_first_2, forward_first_3 : boolean;
  signal forward_left_relief_reach_of_best : natural range 0 to 255;
  signal forward_left_relief_room_of_best : natural range 0 to 190;
  signal forward_left_relief_reach_again : natural range 0 to 254;
  signal forward_above_total_0, forward_above_total_1, forward_above_total_2 : natural range 0 to 46;
  signal forward_above_total_3, forward_above_total_4, forward_above_total_5 : natural range 0 to 46;
  signal forward_above_total_6, forward_above_total_7, forward_above_total_8 : natural range 0 to 46;
  signal forward_above_total_9, forward_above_total_10, forward_above_total_11 : natural range 0 to 46;
  signal forward_above_tree_smallest_0, forward_above_tree_smallest_1 : natural range 0 to 46;
  signal forward_above_tree_smallest_2, forward_above_tree_smallest_3 : natural range 0 to 46;
  signal forward_above_tree_smallest_4, forward_above_tree_smallest_5 : natural range 0 to 46;
  signal forward_above_tree_next_smallest_0, forward_above_tree_next_smallest_1 : natural range 0 to 46;
  signal forward_above_tree_next_smallest_2, forward_above_tree_next_next_smallest_0 : natural range 0 to 46;
  signal forward_above_tree_next_next_smallest_1, forward_above_tree_next_next_next_smallest_0 : natural range 0 to 46;
  signal forward_above_smallest_copy_0 : natural range 0 to 46;
  signal forward_above_delay_held_0, forward_above_delay_held_1 : unsigned(29 downto 0);
  signal forward_above_delay_held_2 : unsigned(11 downto 0);
  signal forward_above_step_0, forward_above_step_1, forward_above_step_2, forward_above_step_3 : natural range 0 to 68;
  signal forward_above_step_4, forward_above_step_5, forward_above_step_6, forward_above_step_7 : natural range 0 to 68;
  signal forward_above_step_8, forward_above_step_9, forward_above_step_10 : natural range 0 to 68;
  signal forward_above_step_11 : natural range 0 to 68;
  signal forward_above_stay_0, forward_above_stay_1, forward_above_stay_2, forward_above_stay_3 : natural range 0 to 31;
  signal forward_above_stay_4, forward_above_stay_5, forward_above_stay_6, forward_above_stay_7 : natural range 0 to 31;
  signal forward_above_stay_8, forward_above_stay_9, forward_above_stay_10 : natural range 0 to 31;
  signal forward_above_stay_11, forward_above_column_0, forward_above_column_1 : natural range 0 to 31;
  signal forward_above_column_2, forward_above_column_3, forward_above_column_4 : natural range 0 to 31;
  signal forward_above_column_5, forward_above_column_6, forward_above_column_7 : natural range 0 to 31;
  signal forward_above_column_8, forward_above_column_9, forward_above_write_column : natural range 0 to 31;
  -- sums
  signal sums_turn_read_sums_0, sums_turn_read_sums_1, sums_turn_read_sums_2 : unsigned(31 downto 0);
  signal sums_turn_ready_sums_0, sums_turn_ready_sums_1, sums_turn_ready_sums_2 : unsigned(31 downto 0);
  signal sums_turn_write_sums_0, sums_turn_write_sums_1, sums_turn_write_sums_2 : unsigned(31 downto 0);
  signal sums_sum_delay_held_0, sums_sum_delay_held_1, sums_sum_delay_held_2 : unsigned(31 downto 0);
  signal sums_turn_read_costs_0 : unsigned(29 downto 0);
  signal sums_turn_read_costs_1 : unsigned(5 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(8 downto 0);
  signal sums_turn_ready_costs_0, sums_turn_write_costs_0 : natural range 0 to 1073741823;
  signal sums_turn_ready_costs_1, sums_turn_write_costs_1, sums_right_start_cost_0 : natural range 0 to 63;
  signal sums_right_start_cost_1, sums_right_start_cost_2, sums_right_start_cost_3 : natural range 0 to 63;
  signal sums_right_start_cost_4, sums_right_start_cost_5, sums_right_start_cost_6 : natural range 0 to 63;
  signal sums_right_room, sums_right_relief_next_0, sums_right_relief_past_0 : natural range 0 to 63;
  signal sums_right_relief_past_1, sums_right_relief_past_2, sums_right_relief_past_3 : natural range 0 to 63;
  signal sums_right_relief_past_4, sums_right_relief_past_5, sums_right_relief_pairs_0 : natural range 0 to 63;
  signal sums_right_relief_pairs_1, sums_right_relief_fours_0, sums_right_relief_older : natural range 0 to 63;
  signal sums_right_relief_recent, sums_right_relief_largest, sums_right_relief_beyond : natural range 0 to 63;
  signal sums_turn_ready_smallest_0, sums_turn_write_smallest_0 : natural range 0 to 511;
  signal sums_turn_ready_first, sums_turn_writes_copy_0, sums_right_first_0, sums_right_first_1 : boolean;
  signal sums_right_first_2, sums_tag_valid, sums_tag_map_column, sums_tag_output_column : boolean;
  signal sums_tag_start_of_frame, sums_tag_end_of_line, sums_tags_held_0_output_column : boolean;
  signal sums_tags_held_0_start_of_frame, sums_tags_held_0_end_of_line, sums_tags_held_1_output_column : boolean;
  signal sums_tags_held_1_start_of_frame, sums_tags_held_1_end_of_line, sums_tags_held_2_output_column : boolean;
  signal sums_tags_held_2_start_of_frame, sums_tags_held_2_end_of_line, sums_tags_held_3_output_column : boolean;
  signal sums_tags_held_3_start_of_frame, sums_tags_held_3_end_of_line, sums_tags_held_4_output_column : boolean;
  signal sums_tags_held_4_start_of_frame, sums_tags_held_4_end_of_line, sums_tags_moved : boolean;
  signal sums_turn_place_0, sums_turn_place_1, sums_turn_place_2, sums_turn_place_3 : natural range 0 to 31;
  signal sums_turn_place_4, sums_turn_place_5, sums_turn_place_6, sums_turn_place_7 : natural range 0 to 31;
  signal sums_turn_place_8, sums_turn_write_place : natural range 0 to 31;
  signal sums_cost_0_0, sums_cost_0_1, sums_cost_0_2, sums_cost_0_3, sums_cost_0_4 : natural range 0 to 7;
  signal sums_cost_0_5, sums_cost_0_6, sums_cost_0_7, sums_cost_0_8, sums_cost_0_9 : natural range 0 to 7;
  signal sums_cost_0_10, sums_cost_0_11, sums_cost_1_0, sums_cost_1_1, sums_cost_1_2 : natural range 0 to 7;
  signal sums_cost_1_3, sums_cost_1_4, sums_cost_1_5, sums_cost_1_6, sums_cost_1_7 : natural range 0 to 7;
  signal sums_cost_1_8, sums_cost_1_9, sums_cost_1_10, sums_cost_1_11 : natural range 0 to 7;
  signal sums_right_pair_0, sums_right_pair_1, sums_right_pair_2, sums_right_pair_3 : natural range 0 to 127;
  signal sums_right_pair_4, sums_right_pair_5, sums_right_tree_smallest_0 : natural range 0 to 127;
  signal sums_right_tree_smallest_1, sums_right_tree_smallest_2 : natural range 0 to 127;
  signal sums_right_tree_next_smallest_0, sums_right_tree_next_smallest_1 : natural range 0 to 127;
  signal sums_right_tree_next_next_smallest_0, sums_right_smallest, sums_right_smallest_less : natural range 0 to 127;
  signal sums_right_relief_leaves, sums_right_g_copy_0, sums_right_g_less_copy_0 : natural range 0 to 127;
  signal sums_right_stay_change_0, sums_right_stay_change_1, sums_right_stay_change_2 : natural range 0 to 127;
  signal sums_right_stay_change_3, sums_right_stay_change_4, sums_right_stay_change_5 : natural range 0 to 127;
  signal sums_right_stay_change_6, sums_right_stay_change_7, sums_right_stay_change_8 : natural range 0 to 127;
  signal sums_right_stay_change_9, sums_right_stay_change_10, sums_right_stay_change_11 : natural range 0 to 127;
  signal sums_right_step_change_0, sums_right_step_change_1, sums_right_step_change_2 : natural range 0 to 127;
  signal sums_right_step_change_3, sums_right_step_change_4, sums_right_step_change_5 : natural range 0 to 127;
  signal sums_right_step_change_6, sums_right_step_change_7, sums_right_step_change_8 : natural range 0 to 127;
  signal sums_right_step_change_9, sums_right_step_change_10, sums_right_step_change_11 : natural range 0 to 127;
  signal sums_right_cost_0, sums_right_cost_1, sums_right_cost_2, sums_right_cost_3 : natural range 0 to 127;
  signal sums_right_cost_4, sums_right_cost_5, sums_right_cost_6, sums_right_cost_7 : natural range 0 to 127;
  signal sums_right_cost_8, sums_right_cost_9, sums_right_cost_10, sums_right_cost_11 : natural range 0 to 127;
  signal sums_right_arrived_0, sums_right_arrived_1, sums_right_arrived_2 : natural range 0 to 127;
  signal sums_right_arrived_3, sums_right_arrived_4, sums_right_arrived_5 : natural range 0 to 127;
  signal sums_right_arrived_6, sums_right_arrived_7, sums_right_arrived_8 : natural range 0 to 127;
  signal sums_right_arrived_9, sums_right_arrived_10, sums_right_arrived_11 : natural range 0 to 127;
  signal sums_right_relief_reach_of_best, sums_sum_0_0, sums_sum_0_1, sums_sum_0_2 : natural range 0 to 255;
  signal sums_sum_0_3, sums_sum_0_4, sums_sum_0_5, sums_sum_0_6, sums_sum_0_7, sums_sum_0_8 : natural range 0 to 255;
  signal sums_sum_0_9, sums_sum_0_10, sums_sum_0_11 : natural range 0 to 255;
  signal sums_right_relief_room_of_best : natural range 0 to 190;
  signal sums_right_relief_reach_again : natural range 0 to 254;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  -- winnerswinner1
  signal winnerswinner1_of_pair_0_0, winnerswinner1_of_pair_0_1, winnerswinner1_of_pair_0_2 : natural range 0 to 255;
  signal winnerswinner1_of_pair_0_3, winnerswinner1_of_pair_0_4, winnerswinner1_of_pair_0_5 : natural range 0 to 255;
  signal winnerswinner1_of_pair_0_6, winnerswinner1_of_pair_0_7, winnerswinner1_of_pair_0_8 : natural range 0 to 255;
  signal winnerswinner1_of_pair_0_9, winnerswinner1_of_pair_0_10, winnerswinner1_of_pair_0_11 : natural range 0 to 255;
  signal winnerswinner1_of_four_0_0, winnerswinner1_of_four_0_1, winnerswinner1_of_four_0_2 : natural range 0 to 255;
  signal winnerswinner1_of_four_0_3, winnerswinner1_of_four_0_4, winnerswinner1_of_four_0_5 : natural range 0 to 255;
  signal winnerswinner1_of_four_0_6, winnerswinner1_of_four_0_7, winnerswinner1_of_four_0_8 : natural range 0 to 255;
  signal winnerswinner1_of_four_0_9, winnerswinner1_of_four_0_10, winnerswinner1_of_four_0_11 : natural range 0 to 255;
  signal winnerswinner1_best_cost_0_0, winnerswinner1_best_cost_0_1 : natural range 0 to 255;
  signal winnerswinner1_best_cost_0_2 : natural range 0 to 255;
  signal winnerswinner1_pair_index_0_0, winnerswinner1_pair_tag_valid, winnerswinner1_pair_tag_map_column : boolean;
  signal winnerswinner1_pair_tag_output_column, winnerswinner1_pair_tag_start_of_frame : boolean;
  signal winnerswinner1_pair_tag_end_of_line, winnerswinner1_four_tag_valid : boolean;
  signal winnerswinner1_four_tag_map_column, winnerswinner1_four_tag_output_column : boolean;
  signal winnerswinner1_four_tag_start_of_frame, winnerswinner1_four_tag_end_of_line : boolean;
  signal winnerswinner1_tag_valid, winnerswinner1_tag_map_column, winnerswinner1_tag_output_column : boolean;
  signal winnerswinner1_tag_start_of_frame, winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_pair_index_0_1, winnerswinner1_four_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_pair_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_pair_index_0_3, winnerswinner1_four_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_pair_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_pair_index_0_5, winnerswinner1_four_index_0_2 : natural range 0 to 11;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 11;
  -- winnerswinner2
  signal winnerswinner2_of_pair_0_0, winnerswinner2_of_pair_0_1, winnerswinner2_of_pair_0_2 : natural range 0 to 255;
  signal winnerswinner2_pair_index_0_0 : natural range 0 to 7;
  signal winnerswinner2_pair_index_0_1, winnerswinner2_four_index_0_0 : natural range 0 to 11;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 11;
  signal winnerswinner2_pair_tag_valid, winnerswinner2_pair_tag_map_column : boolean;
  signal winnerswinner2_pair_tag_output_column, winnerswinner2_pair_tag_start_of_frame : boolean;
  signal winnerswinner2_pair_tag_end_of_line, winnerswinner2_four_tag_valid : boolean;
  signal winnerswinner2_four_tag_map_column, winnerswinner2_four_tag_output_column : boolean;
  signal winnerswinner2_four_tag_start_of_frame, winnerswinner2_four_tag_end_of_line : boolean;
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 11;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_held_output, turn_order_turned_valid, turn_order_turned_output_column : boolean;
  signal turn_order_turned_start_of_frame, turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid : boolean;
  signal turn_read_tag_output_column, turn_read_tag_start_of_frame, turn_read_tag_end_of_line : boolean;
  signal turn_ready_tag_valid, turn_ready_tag_output_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0 : natural range 0 to 267;
  signal turn_read_words_0 : unsigned(8 downto 0);
  signal turn_ready : natural range 0 to 511;
  -- relief
  signal relief_centre_column_0, relief_centre_column_1, relief_centre_column_2 : natural range 0 to 255;
  signal relief_centre_column_3, relief_centre_column_4, relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_rows_read_newest_0, relief_rows_ready_words_0 : natural range 0 to 63;
  signal relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 63;
  signal relief_waiting_0, relief_waiting_1, relief_waiting_2, relief_waiting_3 : natural range 0 to 63;
  signal relief_waiting_4, relief_waiting_5, relief_waiting_6, relief_waiting_7 : natural range 0 to 63;
  signal relief_waiting_8, relief_entering, relief_entered : natural range 0 to 63;
  signal relief_delayed_0, relief_rows_read_words_0 : unsigned(5 downto 0);
  -- other
  signal other_0, other_1, other_2 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal turn_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal sums_sum_delay_held_2_memory_read_enable : boolean;
  signal sums_sum_delay_held_2_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_1_memory_read_enable : boolean;
  signal sums_sum_delay_held_1_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_0_memory_read_enable : boolean;
  signal sums_sum_delay_held_0_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_2_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_1_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_1_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(5 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(8 downto 0);
  signal forward_above_read_words_1_memory_read_enable : boolean;
  signal forward_above_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal forward_above_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal forward_above_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_0_memory_read_enable : boolean;
  signal forward_above_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal forward_above_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal forward_above_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal forward_above_delay_held_2_memory_read_enable : boolean;
  signal forward_above_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_data : unsigned(11 downto 0);
  signal forward_above_delay_held_1_memory_read_enable : boolean;
  signal forward_above_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_0_memory_read_enable : boolean;
  signal forward_above_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal forward_cost_delay_held_1_memory_read_enable : boolean;
  signal forward_cost_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_data : unsigned(7 downto 0);
  signal forward_cost_delay_held_0_memory_read_enable : boolean;
  signal forward_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal relief_rows_read_words_0_memory_read_enable : boolean;
  signal relief_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_write_data : unsigned(5 downto 0);
  signal relief_delayed_0_memory_read_enable : boolean;
  signal relief_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal relief_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal relief_delayed_0_memory_write_data : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(13 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned((turn_ready mod 16), 8));
  pixel_valid <= std_logic_vector(to_unsigned((turn_ready / 256), 1));
  disparity_valid <= as_bit(turn_ready_tag_valid and turn_ready_tag_output_column);
  disparity_start_of_frame <= as_bit(turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_output_column);
  disparity_end_of_line <= as_bit(turn_ready_tag_end_of_line and turn_ready_tag_valid and turn_ready_tag_output_column);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 5);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 5);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 29, width => 9, address_bits => 5)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  sums_sum_delay_held_2_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_2_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_2_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_2_memory_write_data <= sums_turn_ready_sums_2;
  sums_sum_delay_held_2_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_2_memory_read_enable,
      read_address => sums_sum_delay_held_2_memory_read_address, read_data => sums_sum_delay_held_2,
      write_address => sums_sum_delay_held_2_memory_write_address, write_data => sums_sum_delay_held_2_memory_write_data);

  sums_sum_delay_held_1_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_1_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_1_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_1_memory_write_data <= sums_turn_ready_sums_1;
  sums_sum_delay_held_1_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_1_memory_read_enable,
      read_address => sums_sum_delay_held_1_memory_read_address, read_data => sums_sum_delay_held_1,
      write_address => sums_sum_delay_held_1_memory_write_address, write_data => sums_sum_delay_held_1_memory_write_data);

  sums_sum_delay_held_0_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_0_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_0_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_0_memory_write_data <= sums_turn_ready_sums_0;
  sums_sum_delay_held_0_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_0_memory_read_enable,
      read_address => sums_sum_delay_held_0_memory_read_address, read_data => sums_sum_delay_held_0,
      write_address => sums_sum_delay_held_0_memory_write_address, write_data => sums_sum_delay_held_0_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_2_memory_write_data <= sums_turn_write_sums_2;
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums_2,
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_1_memory_write_data <= sums_turn_write_sums_1;
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums_1,
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_0_memory_write_data <= sums_turn_write_sums_0;
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums_0,
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_costs_1_memory_write_data <= to_unsigned(sums_turn_write_costs_1, 6);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 29, width => 6, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs_1,
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_costs_0_memory_write_data <= to_unsigned(sums_turn_write_costs_0, 30);
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 29, width => 30, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs_0,
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 9);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 29, width => 9, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_smallest_0_memory_read_enable,
      read_address => sums_turn_read_smallest_0_memory_read_address, read_data => sums_turn_read_smallest_0,
      write_address => sums_turn_read_smallest_0_memory_write_address, write_data => sums_turn_read_smallest_0_memory_write_data);

  forward_above_read_words_1_memory_read_enable <= true;
  forward_above_read_words_1_memory_read_address <= to_unsigned(entry_next_column, 5);
  forward_above_read_words_1_memory_write_address <= to_unsigned(forward_above_write_column, 5);
  forward_above_read_words_1_memory_write_data <= forward_above_write_words_1;
  forward_above_read_words_1_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => forward_above_read_words_1_memory_read_enable,
      read_address => forward_above_read_words_1_memory_read_address, read_data => forward_above_read_words_1,
      write_address => forward_above_read_words_1_memory_write_address, write_data => forward_above_read_words_1_memory_write_data);

  forward_above_read_words_0_memory_read_enable <= true;
  forward_above_read_words_0_memory_read_address <= to_unsigned(entry_next_column, 5);
  forward_above_read_words_0_memory_write_address <= to_unsigned(forward_above_write_column, 5);
  forward_above_read_words_0_memory_write_data <= forward_above_write_words_0;
  forward_above_read_words_0_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => forward_above_read_words_0_memory_read_enable,
      read_address => forward_above_read_words_0_memory_read_address, read_data => forward_above_read_words_0,
      write_address => forward_above_read_words_0_memory_write_address, write_data => forward_above_read_words_0_memory_write_data);

  forward_above_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_2_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_2_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_2_memory_write_data <= to_unsigned(forward_above_total_11, 6) & to_unsigned(forward_above_total_10, 6);
  forward_above_delay_held_2_memory : entity work.line_memory
    generic map (depth => 5, width => 12, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_2_memory_read_enable,
      read_address => forward_above_delay_held_2_memory_read_address, read_data => forward_above_delay_held_2,
      write_address => forward_above_delay_held_2_memory_write_address, write_data => forward_above_delay_held_2_memory_write_data);

  forward_above_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_1_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_1_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_1_memory_write_data <= to_unsigned(forward_above_total_9, 6) & to_unsigned(forward_above_total_8, 6) & to_unsigned(forward_above_total_7, 6) & to_unsigned(forward_above_total_6, 6) & to_unsigned(forward_above_total_5, 6);
  forward_above_delay_held_1_memory : entity work.line_memory
    generic map (depth => 5, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_1_memory_read_enable,
      read_address => forward_above_delay_held_1_memory_read_address, read_data => forward_above_delay_held_1,
      write_address => forward_above_delay_held_1_memory_write_address, write_data => forward_above_delay_held_1_memory_write_data);

  forward_above_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_0_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_0_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_0_memory_write_data <= to_unsigned(forward_above_total_4, 6) & to_unsigned(forward_above_total_3, 6) & to_unsigned(forward_above_total_2, 6) & to_unsigned(forward_above_total_1, 6) & to_unsigned(forward_above_total_0, 6);
  forward_above_delay_held_0_memory : entity work.line_memory
    generic map (depth => 5, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_0_memory_read_enable,
      read_address => forward_above_delay_held_0_memory_read_address, read_data => forward_above_delay_held_0,
      write_address => forward_above_delay_held_0_memory_write_address, write_data => forward_above_delay_held_0_memory_write_data);

  forward_cost_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_1_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_1_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_1_memory_write_data <= ((to_unsigned(entry_cost_11, 5) & to_unsigned(0, 3)) or (to_unsigned(entry_cost_10, 8)));
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 5, width => 8, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held_1,
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost_8, 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost_9, 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost_7, 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost_6, 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost_5, 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost_4, 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost_3, 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost_2, 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost_0, 32)))) or (to_unsigned(entry_cost_1, 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 5, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held_0,
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  relief_rows_read_words_0_memory_read_enable <= true;
  relief_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  relief_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  relief_rows_read_words_0_memory_write_data <= to_unsigned(relief_rows_write_words_0, 6);
  relief_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => relief_rows_read_words_0_memory_read_enable,
      read_address => relief_rows_read_words_0_memory_read_address, read_data => relief_rows_read_words_0,
      write_address => relief_rows_read_words_0_memory_write_address, write_data => relief_rows_read_words_0_memory_write_data);

  relief_delayed_0_memory_read_enable <= true;
  relief_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  relief_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  relief_delayed_0_memory_write_data <= to_unsigned(relief_newest, 6);
  relief_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => relief_delayed_0_memory_read_enable,
      read_address => relief_delayed_0_memory_read_address, read_data => relief_delayed_0,
      write_address => relief_delayed_0_memory_write_address, write_data => relief_delayed_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 14);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 14, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_read_column_inside_0_value, transform_read_column_inside_0_value_2 : boolean;
    variable transform_read_column_inside_0_value_3, transform_read_column_inside_2_is_equal : boolean;
    variable transform_read_column_inside_2_differs, transform_read_column_inside_6_choice : boolean;
    variable transform_left_filter_feature_0_value, transform_left_filter_feature_0_any : boolean;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choice_2, transform_left_filter_feature_0_value_2 : boolean;
    variable transform_left_filter_feature_0_choice_3, transform_left_filter_feature_0_value_3 : boolean;
    variable transform_left_filter_feature_0_choice_4, transform_left_filter_feature_0_value_4 : boolean;
    variable transform_left_filter_feature_0_choice_5, transform_left_filter_feature_0_value_5 : boolean;
    variable transform_left_filter_feature_0_choice_6, transform_left_filter_feature_0_value_6 : boolean;
    variable transform_left_filter_feature_0_choice_7, transform_left_filter_feature_0_choice_8 : boolean;
    variable transform_left_filter_feature_0_choice_9, transform_left_filter_feature_0_choice_10 : boolean;
    variable transform_left_filter_feature_0_choice_11, transform_left_filter_feature_0_choice_12 : boolean;
    variable transform_left_filter_feature_0_choice_13, transform_left_filter_feature_0_choice_14 : boolean;
    variable transform_left_filter_feature_0_choice_15, transform_left_filter_feature_0_choice_16 : boolean;
    variable transform_left_filter_feature_0_choice_18, transform_left_filter_feature_0_choice_19 : boolean;
    variable transform_left_filter_feature_0_choice_20, transform_left_filter_feature_0_choice_21 : boolean;
    variable transform_left_filter_feature_0_choice_22, transform_left_filter_feature_0_choice_23 : boolean;
    variable transform_left_filter_feature_0_choice_24, transform_left_filter_feature_0_all : boolean;
    variable transform_left_filter_feature_0_choice_25, transform_left_filter_feature_0_choice_26 : boolean;
    variable transform_left_filter_feature_0_choice_27, transform_left_filter_feature_0_choice_28 : boolean;
    variable transform_left_filter_feature_0_value_7, transform_left_filter_feature_0_choice_29 : boolean;
    variable transform_left_filter_feature_0_value_8, transform_left_filter_feature_0_choice_30 : boolean;
    variable transform_left_filter_feature_0_value_9, transform_left_filter_feature_0_choice_31 : boolean;
    variable transform_left_filter_feature_0_value_10, transform_left_filter_feature_0_choice_32 : boolean;
    variable transform_left_filter_feature_0_value_11, transform_left_filter_feature_0_choice_33 : boolean;
    variable transform_left_filter_feature_0_choice_34, transform_left_filter_feature_0_choice_35 : boolean;
    variable transform_left_filter_feature_0_choice_36, transform_left_filter_feature_0_choice_37 : boolean;
    variable transform_left_filter_feature_0_choice_38, transform_left_filter_feature_0_choice_39 : boolean;
    variable transform_left_filter_feature_0_choice_40, transform_left_filter_feature_0_choice_41 : boolean;
    variable transform_left_filter_feature_0_choice_42, transform_left_filter_feature_0_choice_43 : boolean;
    variable transform_left_filter_feature_0_choice_44, transform_left_filter_feature_0_choice_45 : boolean;
    variable transform_left_filter_feature_0_choice_46, transform_left_filter_feature_0_choice_47 : boolean;
    variable transform_left_filter_feature_0_choice_48, transform_left_filter_feature_0_choice_49 : boolean;
    variable transform_left_filter_feature_0_choice_50, transform_left_filter_feature_0_all_2 : boolean;
    variable transform_left_filter_feature_0_choice_51, transform_left_filter_feature_0_choice_52 : boolean;
    variable transform_left_filter_feature_0_choice_53, transform_left_filter_feature_0_choice_54 : boolean;
    variable transform_left_filter_feature_0_choice_55, transform_left_filter_feature_0_choice_56 : boolean;
    variable transform_left_filter_feature_0_choice_57, transform_left_filter_feature_0_choice_58 : boolean;
    variable transform_left_filter_feature_0_choice_59, transform_left_filter_feature_0_choice_60 : boolean;
    variable transform_left_filter_feature_0_choice_61, transform_left_filter_feature_0_choice_62 : boolean;
    variable transform_left_filter_feature_0_choice_63, transform_left_filter_feature_0_choice_64 : boolean;
    variable transform_left_filter_feature_0_choice_65, transform_left_filter_feature_0_choice_66 : boolean;
    variable transform_left_filter_feature_0_choice_67, transform_left_filter_feature_0_choice_68 : boolean;
    variable transform_left_filter_feature_0_choice_69, transform_left_filter_feature_0_choice_70 : boolean;
    variable transform_left_filter_feature_0_choice_71, transform_left_filter_feature_0_choice_72 : boolean;
    variable transform_left_filter_feature_0_choice_73, transform_left_filter_feature_0_choice_74 : boolean;
    variable transform_left_filter_feature_0_choice_75, transform_left_filter_feature_0_choice_76 : boolean;
    variable transform_left_filter_feature_0_all_3, transform_left_filter_feature_0_choice_77 : boolean;
    variable transform_left_filter_feature_0_choice_78, transform_left_filter_feature_0_choice_79 : boolean;
    variable transform_left_filter_feature_0_choice_80, transform_left_filter_feature_0_choice_81 : boolean;
    variable transform_left_filter_feature_0_choice_82, transform_left_filter_feature_0_choice_83 : boolean;
    variable transform_left_filter_feature_0_choice_84, transform_left_filter_feature_0_choice_85 : boolean;
    variable transform_left_filter_feature_0_choice_86, transform_left_filter_feature_0_choice_87 : boolean;
    variable transform_left_filter_feature_0_choice_88, transform_left_filter_feature_0_choice_89 : boolean;
    variable transform_left_filter_feature_0_choice_90, transform_left_filter_feature_0_choice_91 : boolean;
    variable transform_left_filter_feature_0_choice_92, transform_left_filter_feature_0_choice_93 : boolean;
    variable transform_left_filter_feature_0_choice_94, transform_left_filter_feature_0_choice_95 : boolean;
    variable transform_left_filter_feature_0_choice_96, transform_left_filter_feature_0_choice_97 : boolean;
    variable transform_left_filter_feature_0_choice_98, transform_left_filter_feature_0_choice_99 : boolean;
    variable transform_left_filter_feature_0_choice_100, transform_left_filter_feature_0_choice_101 : boolean;
    variable transform_left_filter_feature_0_choice_102, transform_left_filter_feature_0_all_4 : boolean;
    variable transform_left_filter_feature_0_choice_103, transform_left_filter_feature_0_choice_104 : boolean;
    variable transform_left_filter_feature_0_choice_105, transform_left_filter_feature_0_choice_106 : boolean;
    variable transform_left_filter_feature_0_choice_107, transform_left_filter_feature_0_choice_108 : boolean;
    variable transform_left_filter_feature_0_choice_109, transform_left_filter_feature_0_choice_110 : boolean;
    variable transform_left_filter_feature_0_choice_111, transform_left_filter_feature_0_choice_112 : boolean;
    variable transform_left_filter_feature_0_choice_113, transform_left_filter_feature_0_choice_114 : boolean;
    variable transform_left_filter_feature_0_choice_115, transform_left_filter_feature_0_choice_116 : boolean;
    variable transform_left_filter_feature_0_choice_117, transform_left_filter_feature_0_choice_118 : boolean;
    variable transform_left_filter_feature_0_choice_119, transform_left_filter_feature_0_choice_120 : boolean;
    variable transform_left_filter_feature_0_choice_121, transform_right_filter_feature_0_value : boolean;
    variable transform_right_filter_feature_0_any, transform_right_filter_feature_0_choice : boolean;
    variable transform_right_filter_feature_0_is_equal, transform_right_filter_feature_0_choice_2 : boolean;
    variable transform_right_filter_feature_0_value_2, transform_right_filter_feature_0_choice_3 : boolean;
    variable transform_right_filter_feature_0_value_3, transform_right_filter_feature_0_choice_4 : boolean;
    variable transform_right_filter_feature_0_value_4, transform_right_filter_feature_0_choice_5 : boolean;
    variable transform_right_filter_feature_0_value_5, transform_right_filter_feature_0_choice_6 : boolean;
    variable transform_right_filter_feature_0_value_6, transform_right_filter_feature_0_choice_7 : boolean;
    variable transform_right_filter_feature_0_choice_8, transform_right_filter_feature_0_choice_9 : boolean;
    variable transform_right_filter_feature_0_choice_10, transform_right_filter_feature_0_choice_11 : boolean;
    variable transform_right_filter_feature_0_choice_12, transform_right_filter_feature_0_choice_13 : boolean;
    variable transform_right_filter_feature_0_choice_14, transform_right_filter_feature_0_choice_15 : boolean;
    variable transform_right_filter_feature_0_choice_16, transform_right_filter_feature_0_choice_18 : boolean;
    variable transform_right_filter_feature_0_choice_19, transform_right_filter_feature_0_choice_20 : boolean;
    variable transform_right_filter_feature_0_choice_21, transform_right_filter_feature_0_choice_22 : boolean;
    variable transform_right_filter_feature_0_choice_23, transform_right_filter_feature_0_choice_24 : boolean;
    variable transform_right_filter_feature_0_all, transform_right_filter_feature_0_choice_25 : boolean;
    variable transform_right_filter_feature_0_choice_26, transform_right_filter_feature_0_choice_27 : boolean;
    variable transform_right_filter_feature_0_choice_28, transform_right_filter_feature_0_value_7 : boolean;
    variable transform_right_filter_feature_0_choice_29, transform_right_filter_feature_0_value_8 : boolean;
    variable transform_right_filter_feature_0_choice_30, transform_right_filter_feature_0_value_9 : boolean;
    variable transform_right_filter_feature_0_choice_31, transform_right_filter_feature_0_value_10 : boolean;
    variable transform_right_filter_feature_0_choice_32, transform_right_filter_feature_0_value_11 : boolean;
    variable transform_right_filter_feature_0_choice_33, transform_right_filter_feature_0_choice_34 : boolean;
    variable transform_right_filter_feature_0_choice_35, transform_right_filter_feature_0_choice_36 : boolean;
    variable transform_right_filter_feature_0_choice_37, transform_right_filter_feature_0_choice_38 : boolean;
    variable transform_right_filter_feature_0_choice_39, transform_right_filter_feature_0_choice_40 : boolean;
    variable transform_right_filter_feature_0_choice_41, transform_right_filter_feature_0_choice_42 : boolean;
    variable transform_right_filter_feature_0_choice_43, transform_right_filter_feature_0_choice_44 : boolean;
    variable transform_right_filter_feature_0_choice_45, transform_right_filter_feature_0_choice_46 : boolean;
    variable transform_right_filter_feature_0_choice_47, transform_right_filter_feature_0_choice_48 : boolean;
    variable transform_right_filter_feature_0_choice_49, transform_right_filter_feature_0_choice_50 : boolean;
    variable transform_right_filter_feature_0_choice_51, transform_right_filter_feature_0_all_2 : boolean;
    variable transform_right_filter_feature_0_choice_52, transform_right_filter_feature_0_choice_53 : boolean;
    variable transform_right_filter_feature_0_choice_54, transform_right_filter_feature_0_choice_55 : boolean;
    variable transform_right_filter_feature_0_choice_56, transform_right_filter_feature_0_choice_57 : boolean;
    variable transform_right_filter_feature_0_choice_58, transform_right_filter_feature_0_choice_59 : boolean;
    variable transform_right_filter_feature_0_choice_60, transform_right_filter_feature_0_choice_61 : boolean;
    variable transform_right_filter_feature_0_choice_62, transform_right_filter_feature_0_choice_63 : boolean;
    variable transform_right_filter_feature_0_choice_64, transform_right_filter_feature_0_choice_65 : boolean;
    variable transform_right_filter_feature_0_choice_66, transform_right_filter_feature_0_choice_67 : boolean;
    variable transform_right_filter_feature_0_choice_68, transform_right_filter_feature_0_choice_69 : boolean;
    variable transform_right_filter_feature_0_choice_70, transform_right_filter_feature_0_choice_71 : boolean;
    variable transform_right_filter_feature_0_choice_72, transform_right_filter_feature_0_choice_73 : boolean;
    variable transform_right_filter_feature_0_choice_74, transform_right_filter_feature_0_choice_75 : boolean;
    variable transform_right_filter_feature_0_choice_76, transform_right_filter_feature_0_choice_77 : boolean;
    variable transform_right_filter_feature_0_choice_78, transform_right_filter_feature_0_all_3 : boolean;
    variable transform_right_filter_feature_0_choice_79, transform_right_filter_feature_0_choice_80 : boolean;
    variable transform_right_filter_feature_0_choice_81, transform_right_filter_feature_0_choice_82 : boolean;
    variable transform_right_filter_feature_0_choice_83, transform_right_filter_feature_0_choice_84 : boolean;
    variable transform_right_filter_feature_0_choice_85, transform_right_filter_feature_0_choice_86 : boolean;
    variable transform_right_filter_feature_0_choice_87, transform_right_filter_feature_0_choice_88 : boolean;
    variable transform_right_filter_feature_0_choice_89, transform_right_filter_feature_0_choice_90 : boolean;
    variable transform_right_filter_feature_0_choice_91, transform_right_filter_feature_0_choice_92 : boolean;
    variable transform_right_filter_feature_0_choice_93, transform_right_filter_feature_0_choice_94 : boolean;
    variable transform_right_filter_feature_0_choice_95, transform_right_filter_feature_0_choice_96 : boolean;
    variable transform_right_filter_feature_0_choice_97, transform_right_filter_feature_0_choice_98 : boolean;
    variable transform_right_filter_feature_0_choice_99, transform_right_filter_feature_0_choice_100 : boolean;
    variable transform_right_filter_feature_0_choice_101, transform_right_filter_feature_0_choice_102 : boolean;
    variable transform_right_filter_feature_0_choice_103, transform_right_filter_feature_0_choice_104 : boolean;
    variable transform_right_filter_feature_0_choice_105, transform_right_filter_feature_0_all_4 : boolean;
    variable transform_right_filter_feature_0_choice_106, transform_right_filter_feature_0_choice_107 : boolean;
    variable transform_right_filter_feature_0_choice_108, transform_right_filter_feature_0_choice_109 : boolean;
    variable transform_right_filter_feature_0_choice_110, transform_right_filter_feature_0_choice_111 : boolean;
    variable transform_right_filter_feature_0_choice_112, transform_right_filter_feature_0_choice_113 : boolean;
    variable transform_right_filter_feature_0_choice_114, transform_right_filter_feature_0_choice_115 : boolean;
    variable transform_right_filter_feature_0_choice_116, transform_right_filter_feature_0_choice_117 : boolean;
    variable transform_right_filter_feature_0_choice_118, transform_right_filter_feature_0_choice_119 : boolean;
    variable transform_right_filter_feature_0_choice_120, transform_right_filter_feature_0_choice_121 : boolean;
    variable transform_right_filter_feature_0_choice_122, transform_right_filter_feature_0_choice_123 : boolean;
    variable transform_right_filter_feature_0_choice_124, transform_right_filter_feature_0_choice_125 : boolean;
    variable transform_counter_next_frame_choice, raster_place_group_is_equal, raster_place_group_is_equal_2 : boolean;
    variable raster_place_group_all, raster_place_group_is_equal_3, raster_place_group_choice_2 : boolean;
    variable raster_place_next_frame_choice, raster_place_next_frame_choice_2, delay_row_inside_1_is_not_less : boolean;
    variable delay_row_inside_1_is_less, delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, slice0cost_pixels_first_0_0_count_0_value : boolean;
    variable slice0cost_pixels_first_0_0_count_0_value_2, slice0cost_pixels_first_0_0_count_1_value : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value_2, slice0cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_2_value, slice0cost_pixels_first_0_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value, slice0cost_pixels_first_0_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value_3, slice0cost_pixels_first_0_0_count_4_value : boolean;
    variable slice0cost_pixels_first_1_0_count_0_value, slice0cost_pixels_first_1_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value, slice0cost_pixels_first_1_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value_3, slice0cost_pixels_first_1_0_count_2_value : boolean;
    variable slice0cost_pixels_first_1_0_count_2_value_2, slice0cost_pixels_first_1_0_count_3_value : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value_2, slice0cost_pixels_first_1_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_4_value, slice0cost_pixels_first_2_0_count_0_value : boolean;
    variable slice0cost_pixels_first_2_0_count_0_value_2, slice0cost_pixels_first_2_0_count_1_value : boolean;
    variable slice0cost_pixels_first_2_0_count_1_value_2, slice0cost_pixels_first_2_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_2_value, slice0cost_pixels_first_2_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_3_value, slice0cost_pixels_first_2_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_3_value_3, slice0cost_pixels_first_2_0_count_4_value : boolean;
    variable slice1cost_pixels_first_0_0_count_0_value, slice1cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_1_value, slice1cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_1_value_3, slice1cost_pixels_first_0_0_count_2_value : boolean;
    variable slice1cost_pixels_first_0_0_count_2_value_2, slice1cost_pixels_first_0_0_count_3_value : boolean;
    variable slice1cost_pixels_first_0_0_count_3_value_2, slice1cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_4_value, slice1cost_pixels_first_1_0_count_0_value : boolean;
    variable slice1cost_pixels_first_1_0_count_0_value_2, slice1cost_pixels_first_1_0_count_1_value : boolean;
    variable slice1cost_pixels_first_1_0_count_1_value_2, slice1cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_count_2_value, slice1cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_3_value, slice1cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_3_value_3, slice1cost_pixels_first_1_0_count_4_value : boolean;
    variable slice1cost_pixels_first_2_0_count_0_value, slice1cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_1_value, slice1cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_1_value_3, slice1cost_pixels_first_2_0_count_2_value : boolean;
    variable slice1cost_pixels_first_2_0_count_2_value_2, slice1cost_pixels_first_2_0_count_3_value : boolean;
    variable slice1cost_pixels_first_2_0_count_3_value_2, slice1cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_4_value, slice2cost_pixels_first_0_0_count_0_value : boolean;
    variable slice2cost_pixels_first_0_0_count_0_value_2, slice2cost_pixels_first_0_0_count_1_value : boolean;
    variable slice2cost_pixels_first_0_0_count_1_value_2, slice2cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_2_value, slice2cost_pixels_first_0_0_count_2_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_3_value, slice2cost_pixels_first_0_0_count_3_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_3_value_3, slice2cost_pixels_first_0_0_count_4_value : boolean;
    variable slice2cost_pixels_first_1_0_count_0_value, slice2cost_pixels_first_1_0_count_0_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_1_value, slice2cost_pixels_first_1_0_count_1_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_1_value_3, slice2cost_pixels_first_1_0_count_2_value : boolean;
    variable slice2cost_pixels_first_1_0_count_2_value_2, slice2cost_pixels_first_1_0_count_3_value : boolean;
    variable slice2cost_pixels_first_1_0_count_3_value_2, slice2cost_pixels_first_1_0_count_3_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_4_value, slice2cost_pixels_first_2_0_count_0_value : boolean;
    variable slice2cost_pixels_first_2_0_count_0_value_2, slice2cost_pixels_first_2_0_count_1_value : boolean;
    variable slice2cost_pixels_first_2_0_count_1_value_2, slice2cost_pixels_first_2_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_2_0_count_2_value, slice2cost_pixels_first_2_0_count_2_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_3_value, slice2cost_pixels_first_2_0_count_3_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_3_value_3, slice2cost_pixels_first_2_0_count_4_value : boolean;
    variable entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any : boolean;
    variable entry_order_turned_output_column_choice, forward_left_start_cost_0_any : boolean;
    variable forward_left_start_cost_0_choice, forward_left_start_cost_0_choice_2 : boolean;
    variable forward_left_start_cost_0_value, forward_left_start_cost_0_choice_3 : boolean;
    variable forward_left_start_cost_0_value_2, forward_left_start_cost_0_choice_4 : boolean;
    variable forward_left_start_cost_0_value_3, forward_left_start_cost_0_choice_5 : boolean;
    variable forward_left_start_cost_0_choice_6, forward_left_start_cost_0_is_less : boolean;
    variable sums_right_start_cost_0_any, sums_right_start_cost_0_choice, sums_right_start_cost_0_choice_2 : boolean;
    variable sums_right_start_cost_0_value, sums_right_start_cost_0_choice_3, sums_right_start_cost_0_value_2 : boolean;
    variable sums_right_start_cost_0_choice_4, sums_right_start_cost_0_value_3 : boolean;
    variable sums_right_start_cost_0_choice_5, sums_right_start_cost_0_choice_6 : boolean;
    variable sums_right_start_cost_0_is_less, sums_turn_writes_copy_0_choice : boolean;
    variable winnerswinner1_of_pair_0_0_choice, winnerswinner1_of_pair_0_0_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_0_value, winnerswinner1_of_pair_0_0_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_0_value_2, winnerswinner1_of_pair_0_0_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_0_value_3, winnerswinner1_of_pair_0_0_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_0_value_4, winnerswinner1_of_pair_0_0_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_0_value_5, winnerswinner1_of_pair_0_0_choice_7 : boolean;
    variable winnerswinner1_of_pair_0_0_choice_8, winnerswinner1_of_pair_0_2_choice : boolean;
    variable winnerswinner1_of_pair_0_2_choice_2, winnerswinner1_of_pair_0_2_value : boolean;
    variable winnerswinner1_of_pair_0_2_choice_3, winnerswinner1_of_pair_0_2_value_2 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_4, winnerswinner1_of_pair_0_2_value_3 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_5, winnerswinner1_of_pair_0_2_value_4 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_6, winnerswinner1_of_pair_0_2_value_5 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_7, winnerswinner1_of_pair_0_2_choice_8 : boolean;
    variable winnerswinner1_of_pair_0_4_choice, winnerswinner1_of_pair_0_4_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_4_value, winnerswinner1_of_pair_0_4_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_4_value_2, winnerswinner1_of_pair_0_4_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_4_value_3, winnerswinner1_of_pair_0_4_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_4_value_4, winnerswinner1_of_pair_0_4_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_4_value_5, winnerswinner1_of_pair_0_4_choice_7 : boolean;
    variable winnerswinner1_of_pair_0_4_choice_8, winnerswinner1_of_pair_0_6_choice : boolean;
    variable winnerswinner1_of_pair_0_6_choice_2, winnerswinner1_of_pair_0_6_value : boolean;
    variable winnerswinner1_of_pair_0_6_choice_3, winnerswinner1_of_pair_0_6_value_2 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_4, winnerswinner1_of_pair_0_6_value_3 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_5, winnerswinner1_of_pair_0_6_value_4 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_6, winnerswinner1_of_pair_0_6_value_5 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_7, winnerswinner1_of_pair_0_6_choice_8 : boolean;
    variable winnerswinner1_of_pair_0_8_choice, winnerswinner1_of_pair_0_8_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_8_value, winnerswinner1_of_pair_0_8_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_8_value_2, winnerswinner1_of_pair_0_8_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_8_value_3, winnerswinner1_of_pair_0_8_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_8_value_4, winnerswinner1_of_pair_0_8_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_8_value_5, winnerswinner1_of_pair_0_8_choice_7 : boolean;
    variable winnerswinner1_of_pair_0_8_choice_8, winnerswinner1_of_pair_0_10_choice : boolean;
    variable winnerswinner1_of_pair_0_10_choice_2, winnerswinner1_of_pair_0_10_value : boolean;
    variable winnerswinner1_of_pair_0_10_choice_3, winnerswinner1_of_pair_0_10_value_2 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_4, winnerswinner1_of_pair_0_10_value_3 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_5, winnerswinner1_of_pair_0_10_value_4 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_6, winnerswinner1_of_pair_0_10_value_5 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_7, winnerswinner1_of_pair_0_10_choice_8 : boolean;
    variable winnerswinner1_of_four_0_0_choice, winnerswinner1_of_four_0_0_value : boolean;
    variable winnerswinner1_of_four_0_0_value_2, winnerswinner1_of_four_0_0_choice_2 : boolean;
    variable winnerswinner1_of_four_0_0_value_3, winnerswinner1_of_four_0_0_value_4 : boolean;
    variable winnerswinner1_of_four_0_0_choice_3, winnerswinner1_of_four_0_0_value_5 : boolean;
    variable winnerswinner1_of_four_0_0_value_6, winnerswinner1_of_four_0_0_choice_4 : boolean;
    variable winnerswinner1_of_four_0_0_value_7, winnerswinner1_of_four_0_0_value_8 : boolean;
    variable winnerswinner1_of_four_0_0_choice_5, winnerswinner1_of_four_0_0_value_9 : boolean;
    variable winnerswinner1_of_four_0_0_value_10, winnerswinner1_of_four_0_0_choice_6 : boolean;
    variable winnerswinner1_of_four_0_0_value_11, winnerswinner1_of_four_0_0_value_12 : boolean;
    variable winnerswinner1_of_four_0_0_choice_7, winnerswinner1_of_four_0_0_choice_8 : boolean;
    variable winnerswinner1_of_four_0_4_choice, winnerswinner1_of_four_0_4_value : boolean;
    variable winnerswinner1_of_four_0_4_value_2, winnerswinner1_of_four_0_4_choice_2 : boolean;
    variable winnerswinner1_of_four_0_4_value_3, winnerswinner1_of_four_0_4_value_4 : boolean;
    variable winnerswinner1_of_four_0_4_choice_3, winnerswinner1_of_four_0_4_value_5 : boolean;
    variable winnerswinner1_of_four_0_4_value_6, winnerswinner1_of_four_0_4_choice_4 : boolean;
    variable winnerswinner1_of_four_0_4_value_7, winnerswinner1_of_four_0_4_value_8 : boolean;
    variable winnerswinner1_of_four_0_4_choice_5, winnerswinner1_of_four_0_4_value_9 : boolean;
    variable winnerswinner1_of_four_0_4_value_10, winnerswinner1_of_four_0_4_choice_6 : boolean;
    variable winnerswinner1_of_four_0_4_value_11, winnerswinner1_of_four_0_4_value_12 : boolean;
    variable winnerswinner1_of_four_0_4_choice_7, winnerswinner1_of_four_0_4_choice_8 : boolean;
    variable winnerswinner1_of_four_0_8_choice, winnerswinner1_of_four_0_8_value : boolean;
    variable winnerswinner1_of_four_0_8_value_2, winnerswinner1_of_four_0_8_choice_2 : boolean;
    variable winnerswinner1_of_four_0_8_value_3, winnerswinner1_of_four_0_8_value_4 : boolean;
    variable winnerswinner1_of_four_0_8_choice_3, winnerswinner1_of_four_0_8_value_5 : boolean;
    variable winnerswinner1_of_four_0_8_value_6, winnerswinner1_of_four_0_8_choice_4 : boolean;
    variable winnerswinner1_of_four_0_8_value_7, winnerswinner1_of_four_0_8_value_8 : boolean;
    variable winnerswinner1_of_four_0_8_choice_5, winnerswinner1_of_four_0_8_value_9 : boolean;
    variable winnerswinner1_of_four_0_8_value_10, winnerswinner1_of_four_0_8_choice_6 : boolean;
    variable winnerswinner1_of_four_0_8_value_11, winnerswinner1_of_four_0_8_value_12 : boolean;
    variable winnerswinner1_of_four_0_8_choice_7, winnerswinner1_of_four_0_8_choice_8 : boolean;
    variable winnerswinner2_of_pair_0_0_choice, winnerswinner2_of_pair_0_0_choice_2 : boolean;
    variable winnerswinner2_of_pair_0_0_value, winnerswinner2_of_pair_0_0_choice_3 : boolean;
    variable winnerswinner2_of_pair_0_0_value_2, winnerswinner2_of_pair_0_0_choice_4 : boolean;
    variable winnerswinner2_of_pair_0_0_value_3, winnerswinner2_of_pair_0_0_choice_5 : boolean;
    variable winnerswinner2_of_pair_0_0_value_4, winnerswinner2_of_pair_0_0_choice_6 : boolean;
    variable winnerswinner2_of_pair_0_0_value_5, winnerswinner2_of_pair_0_0_choice_7 : boolean;
    variable winnerswinner2_of_pair_0_0_choice_8, winnerswinner2_four_index_0_0_value : boolean;
    variable winnerswinner2_four_index_0_0_value_2, winnerswinner2_four_index_0_0_choice : boolean;
    variable winnerswinner2_four_index_0_0_value_3, winnerswinner2_four_index_0_0_value_4 : boolean;
    variable winnerswinner2_four_index_0_0_choice_2, winnerswinner2_four_index_0_0_value_5 : boolean;
    variable winnerswinner2_four_index_0_0_value_6, winnerswinner2_four_index_0_0_choice_3 : boolean;
    variable winnerswinner2_four_index_0_0_value_7, winnerswinner2_four_index_0_0_value_8 : boolean;
    variable winnerswinner2_four_index_0_0_choice_4, winnerswinner2_four_index_0_0_value_9 : boolean;
    variable winnerswinner2_four_index_0_0_value_10, winnerswinner2_four_index_0_0_choice_5 : boolean;
    variable winnerswinner2_four_index_0_0_value_11, winnerswinner2_four_index_0_0_value_12 : boolean;
    variable winnerswinner2_four_index_0_0_choice_6, winnerswinner2_four_index_0_0_choice_7 : boolean;
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_order_turned_output_column_choice, relief_newest_choice, relief_newest_choice_2 : boolean;
    variable relief_newest_value, relief_newest_choice_3, relief_newest_value_2, relief_newest_choice_4 : boolean;
    variable relief_newest_value_3, relief_newest_choice_5, relief_newest_value_4, relief_newest_choice_6 : boolean;
    variable relief_newest_value_5, relief_newest_choice_7, relief_newest_choice_8, relief_newest_choice_9 : boolean;
    variable relief_newest_choice_10, relief_newest_choice_11, relief_newest_choice_12 : boolean;
    variable relief_newest_choice_13, relief_newest_choice_14, relief_newest_choice_15 : boolean;
    variable relief_newest_choice_16 : boolean;
    variable transform_counter_group_choice, transform_left_filter_feature_0_choice_17 : natural range 0 to 3;
    variable transform_right_filter_feature_0_choice_17, raster_place_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 15;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 7;
    variable forward_left_pair_0_choice, forward_left_pair_1_choice : natural range 0 to 127;
    variable forward_left_pair_2_choice, forward_left_pair_3_choice : natural range 0 to 127;
    variable forward_left_pair_4_choice, forward_left_pair_5_choice : natural range 0 to 127;
    variable forward_left_cost_0_choice, forward_left_cost_0_choice_2 : natural range 0 to 127;
    variable forward_left_cost_1_choice, forward_left_cost_1_choice_2 : natural range 0 to 127;
    variable forward_left_cost_2_choice, forward_left_cost_2_choice_2 : natural range 0 to 127;
    variable forward_left_cost_3_choice, forward_left_cost_3_choice_2 : natural range 0 to 127;
    variable forward_left_cost_4_choice, forward_left_cost_4_choice_2 : natural range 0 to 127;
    variable forward_left_cost_5_choice, forward_left_cost_5_choice_2 : natural range 0 to 127;
    variable forward_left_cost_6_choice, forward_left_cost_6_choice_2 : natural range 0 to 127;
    variable forward_left_cost_7_choice, forward_left_cost_7_choice_2 : natural range 0 to 127;
    variable forward_left_cost_8_choice, forward_left_cost_8_choice_2 : natural range 0 to 127;
    variable forward_left_cost_9_choice, forward_left_cost_9_choice_2 : natural range 0 to 127;
    variable forward_left_cost_10_choice, forward_left_cost_10_choice_2 : natural range 0 to 127;
    variable forward_left_cost_11_choice, forward_left_cost_11_choice_2 : natural range 0 to 127;
    variable forward_left_arrived_0_choice, forward_left_arrived_1_choice : natural range 0 to 127;
    variable forward_left_arrived_2_choice, forward_left_arrived_3_choice : natural range 0 to 127;
    variable forward_left_arrived_3_choice_2, forward_left_arrived_4_choice : natural range 0 to 127;
    variable forward_left_arrived_4_choice_2, forward_left_arrived_5_choice : natural range 0 to 127;
    variable forward_left_arrived_6_choice, forward_left_arrived_7_choice : natural range 0 to 127;
    variable forward_left_arrived_7_choice_2, forward_left_arrived_8_choice : natural range 0 to 127;
    variable forward_left_arrived_8_choice_2, forward_left_arrived_9_choice : natural range 0 to 127;
    variable forward_left_arrived_10_choice, forward_left_arrived_11_choice : natural range 0 to 127;
    variable sums_right_pair_0_choice, sums_right_pair_1_choice, sums_right_pair_2_choice : natural range 0 to 127;
    variable sums_right_pair_3_choice, sums_right_pair_4_choice, sums_right_pair_5_choice : natural range 0 to 127;
    variable sums_right_cost_0_choice, sums_right_cost_0_choice_2, sums_right_cost_1_choice : natural range 0 to 127;
    variable sums_right_cost_1_choice_2, sums_right_cost_2_choice, sums_right_cost_2_choice_2 : natural range 0 to 127;
    variable sums_right_cost_3_choice, sums_right_cost_3_choice_2, sums_right_cost_4_choice : natural range 0 to 127;
    variable sums_right_cost_4_choice_2, sums_right_cost_5_choice, sums_right_cost_5_choice_2 : natural range 0 to 127;
    variable sums_right_cost_6_choice, sums_right_cost_6_choice_2, sums_right_cost_7_choice : natural range 0 to 127;
    variable sums_right_cost_7_choice_2, sums_right_cost_8_choice, sums_right_cost_8_choice_2 : natural range 0 to 127;
    variable sums_right_cost_9_choice, sums_right_cost_9_choice_2, sums_right_cost_10_choice : natural range 0 to 127;
    variable sums_right_cost_10_choice_2, sums_right_cost_11_choice : natural range 0 to 127;
    variable sums_right_cost_11_choice_2, sums_right_arrived_0_choice : natural range 0 to 127;
    variable sums_right_arrived_1_choice, sums_right_arrived_2_choice : natural range 0 to 127;
    variable sums_right_arrived_3_choice, sums_right_arrived_3_choice_2 : natural range 0 to 127;
    variable sums_right_arrived_4_choice, sums_right_arrived_4_choice_2 : natural range 0 to 127;
    variable sums_right_arrived_5_choice, sums_right_arrived_6_choice : natural range 0 to 127;
    variable sums_right_arrived_7_choice, sums_right_arrived_7_choice_2 : natural range 0 to 127;
    variable sums_right_arrived_8_choice, sums_right_arrived_8_choice_2 : natural range 0 to 127;
    variable sums_right_arrived_9_choice, sums_right_arrived_10_choice : natural range 0 to 127;
    variable sums_right_arrived_11_choice : natural range 0 to 127;
    variable forward_left_start_cost_0_choice_7, forward_left_start_cost_0_choice_8 : natural range 0 to 63;
    variable forward_left_start_cost_0_choice_9, forward_left_room_value : natural range 0 to 63;
    variable forward_left_room_choice, forward_left_room_choice_2, forward_left_room_choice_3 : natural range 0 to 63;
    variable forward_left_smallest_choice, forward_left_relief_pairs_0_choice : natural range 0 to 63;
    variable forward_left_relief_recent_choice, forward_left_relief_largest_choice : natural range 0 to 63;
    variable sums_right_start_cost_0_choice_7, sums_right_start_cost_0_choice_8 : natural range 0 to 63;
    variable sums_right_start_cost_0_choice_9, sums_right_room_value, sums_right_room_choice : natural range 0 to 63;
    variable sums_right_room_choice_2, sums_right_room_choice_3, sums_right_smallest_choice : natural range 0 to 63;
    variable sums_right_relief_pairs_0_choice, sums_right_relief_recent_choice : natural range 0 to 63;
    variable sums_right_relief_largest_choice, relief_newest_choice_17 : natural range 0 to 63;
    variable forward_left_smallest_difference : integer range -63 to 78;
    variable forward_left_relief_reach_of_best_sum, forward_left_relief_reach_of_best_choice : natural range 0 to 190;
    variable sums_right_relief_reach_of_best_sum, sums_right_relief_reach_of_best_choice : natural range 0 to 190;
    variable other_0_choice_4, other_1_choice_4, other_2_choice_4 : natural range 0 to 190;
    variable forward_left_relief_reach_of_best_choice_2 : natural range 0 to 255;
    variable forward_left_relief_reach_of_best_choice_3 : natural range 0 to 255;
    variable sums_right_relief_reach_of_best_choice_2 : natural range 0 to 255;
    variable sums_right_relief_reach_of_best_choice_3, relief_newest_value_6 : natural range 0 to 255;
    variable relief_newest_value_7, other_0_choice, other_0_choice_2, other_0_choice_3 : natural range 0 to 255;
    variable other_1_choice, other_1_choice_2, other_1_choice_3, other_2_choice : natural range 0 to 255;
    variable other_2_choice_2, other_2_choice_3 : natural range 0 to 255;
    variable forward_left_relief_leaves_choice, sums_right_relief_leaves_choice : natural range 64 to 127;
    variable forward_above_total_0_choice, forward_above_total_1_choice : natural range 0 to 31;
    variable forward_above_total_2_choice, forward_above_total_3_choice : natural range 0 to 31;
    variable forward_above_total_4_choice, forward_above_total_5_choice : natural range 0 to 31;
    variable forward_above_total_6_choice, forward_above_total_7_choice : natural range 0 to 31;
    variable forward_above_total_8_choice, forward_above_total_9_choice : natural range 0 to 31;
    variable forward_above_total_10_choice, forward_above_total_11_choice : natural range 0 to 31;
    variable forward_above_write_words_0_choice, forward_above_write_words_0_choice_2 : natural range 0 to 68;
    variable forward_above_write_words_0_choice_3, forward_above_write_words_0_choice_4 : natural range 0 to 68;
    variable forward_above_write_words_0_choice_5, forward_above_write_words_0_choice_6 : natural range 0 to 68;
    variable forward_above_write_words_1_choice, forward_above_write_words_1_choice_2 : natural range 0 to 68;
    variable forward_above_write_words_1_choice_3, forward_above_write_words_1_choice_4 : natural range 0 to 68;
    variable forward_above_write_words_1_choice_5, forward_above_write_words_1_choice_6 : natural range 0 to 68;
    variable sums_right_smallest_difference : integer range -63 to 63;
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
      transform_counter_group_is_equal_3 := transform_counter_group = 13;
      if transform_counter_next_frame and transform_counter_group_is_equal_3 then
        transform_counter_group_choice_2 := 2;
      else
        transform_counter_group_choice_2 := (transform_counter_group + 1) mod 16;
      end if;
      if (transform_counter_group /= 14) and transform_counter_group_is_equal and in_valid then
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      else
        transform_counter_group_choice_3 := transform_counter_group;
      end if;
      transform_read_column_inside_0_value := ((transform_counter_column / 16) mod 2) = 1;
      transform_read_column_inside_0_value_2 := ((transform_counter_column / 8) mod 2) = 1;
      transform_read_column_inside_0_value_3 := ((transform_counter_column / 4) mod 2) = 1;
      transform_read_column_inside_2_is_equal := (transform_counter_column / 4) = 0;
      transform_read_column_inside_2_differs := (transform_counter_column / 4) /= 0;
      if ((transform_counter_column / 2) mod 2) = 1 then
        transform_read_column_inside_6_choice := (not ((transform_counter_column / 32) = 1)) and (not
          transform_read_column_inside_0_value) and (not transform_read_column_inside_0_value_3);
      else
        transform_read_column_inside_6_choice := (transform_counter_column / 16) = 0;
      end if;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_4_2 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_4_2 mod 2) = 1));
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_4_2 mod 4) = 0;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_4_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_4_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_4_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_4_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_4_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_9 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_9 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_10 := transform_left_filter_feature_0_choice_9;
      else
        transform_left_filter_feature_0_choice_10 := ((transform_left_filter_column_4_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_10 then
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_11 then
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_12 then
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_13 then
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_14 then
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_15 then
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_4_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_4_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_17 := as_number(transform_left_filter_feature_0_choice_8) +
          (as_number(transform_left_filter_feature_0_choice_16) * 2);
      else
        transform_left_filter_feature_0_choice_17 := 0;
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_18 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_18 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_19 := transform_left_filter_feature_0_choice_18;
      else
        transform_left_filter_feature_0_choice_19 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_19 then
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_20 then
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_21 then
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_22 then
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_23 then
        transform_left_filter_feature_0_choice_24 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_24 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      transform_left_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        ((transform_left_filter_column_4_2 / 128) = 1));
      if (transform_left_filter_column_0_2 / 128) = 1 then
        transform_left_filter_feature_0_choice_25 := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choice_24 then
        transform_left_filter_feature_0_choice_26 := ((transform_left_filter_column_0_2 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_choice_25;
      end if;
      if (transform_left_filter_column_0_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_27 := (transform_left_filter_column_4_2 mod 4) = 3;
      else
        transform_left_filter_feature_0_choice_27 := transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_28 := transform_left_filter_feature_0_choice_27;
      else
        transform_left_filter_feature_0_choice_28 := (not ((transform_left_filter_column_0_0 mod 2) = 1)) or
          transform_left_filter_feature_0_value or ((transform_left_filter_column_4_2 mod 2) = 1);
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := transform_left_filter_feature_0_value_7 and (not
          transform_left_filter_feature_0_value_2);
      else
        transform_left_filter_feature_0_choice_29 := transform_left_filter_feature_0_value_7 or (not
          transform_left_filter_feature_0_value_2);
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := transform_left_filter_feature_0_value_8 or (not
          transform_left_filter_feature_0_value_3);
      else
        transform_left_filter_feature_0_choice_30 := transform_left_filter_feature_0_value_8 and (not
          transform_left_filter_feature_0_value_3);
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := transform_left_filter_feature_0_value_9 or (not
          transform_left_filter_feature_0_value_4);
      else
        transform_left_filter_feature_0_choice_31 := transform_left_filter_feature_0_value_9 and (not
          transform_left_filter_feature_0_value_4);
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := transform_left_filter_feature_0_value_10 or (not
          transform_left_filter_feature_0_value_5);
      else
        transform_left_filter_feature_0_choice_32 := transform_left_filter_feature_0_value_10 and (not
          transform_left_filter_feature_0_value_5);
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_32 then
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_value_11 or (not
          transform_left_filter_feature_0_value_6);
      else
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_value_11 and (not
          transform_left_filter_feature_0_value_6);
      end if;
      if (transform_left_filter_column_0_0 / 128) = 1 then
        transform_left_filter_feature_0_choice_34 := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choice_33 then
        transform_left_filter_feature_0_choice_35 := transform_left_filter_feature_0_choice_34;
      else
        transform_left_filter_feature_0_choice_35 := ((transform_left_filter_column_0_0 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_36 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_36 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_37 := transform_left_filter_feature_0_choice_36;
      else
        transform_left_filter_feature_0_choice_37 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_40 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_40 then
        transform_left_filter_feature_0_choice_41 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_41 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_41 then
        transform_left_filter_feature_0_choice_42 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_42 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := transform_filtering_0_column_inside_0 and
          ((transform_left_filter_column_0_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_43 := transform_filtering_0_column_inside_0 and
          (((transform_left_filter_column_0_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_44 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_44 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_45 := transform_left_filter_feature_0_choice_44;
      else
        transform_left_filter_feature_0_choice_45 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_48 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_48 then
        transform_left_filter_feature_0_choice_49 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_49 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_49 then
        transform_left_filter_feature_0_choice_50 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_50 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      transform_left_filter_feature_0_all_2 := transform_filtering_0_column_inside_2 and (not
        ((transform_left_filter_column_4_2 / 128) = 1));
      if (transform_left_filter_column_2_2 / 128) = 1 then
        transform_left_filter_feature_0_choice_51 := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choice_51 := transform_left_filter_feature_0_all_2;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_52 := ((transform_left_filter_column_2_2 / 128) = 1) and
          transform_filtering_0_column_inside_2 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_52 := transform_left_filter_feature_0_choice_51;
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_53 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_53 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_54 := transform_left_filter_feature_0_choice_53;
      else
        transform_left_filter_feature_0_choice_54 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_56 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_56 then
        transform_left_filter_feature_0_choice_57 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_57 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_57 then
        transform_left_filter_feature_0_choice_58 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_58 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if (transform_left_filter_column_2_0 / 128) = 1 then
        transform_left_filter_feature_0_choice_60 := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choice_60 := transform_left_filter_feature_0_all_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_61 := ((transform_left_filter_column_2_0 / 128) = 1) and
          transform_filtering_0_column_inside_2 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_61 := transform_left_filter_feature_0_choice_60;
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_62 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_62 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_63 := transform_left_filter_feature_0_choice_62;
      else
        transform_left_filter_feature_0_choice_63 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_64 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_64 then
        transform_left_filter_feature_0_choice_65 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_65 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_65 then
        transform_left_filter_feature_0_choice_66 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_66 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_69 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_70 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_70 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_71 := transform_left_filter_feature_0_choice_70;
      else
        transform_left_filter_feature_0_choice_71 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_72 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_72 then
        transform_left_filter_feature_0_choice_73 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_73 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_73 then
        transform_left_filter_feature_0_choice_74 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_74 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      transform_left_filter_feature_0_all_3 := transform_filtering_0_column_inside_6 and (not
        ((transform_left_filter_column_4_2 / 128) = 1));
      if (transform_left_filter_column_6_2 / 128) = 1 then
        transform_left_filter_feature_0_choice_77 := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choice_77 := transform_left_filter_feature_0_all_3;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_78 := ((transform_left_filter_column_6_2 / 128) = 1) and
          transform_filtering_0_column_inside_6 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_78 := transform_left_filter_feature_0_choice_77;
      end if;
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_79 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_79 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_80 := transform_left_filter_feature_0_choice_79;
      else
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_80 then
        transform_left_filter_feature_0_choice_81 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_81 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_81 then
        transform_left_filter_feature_0_choice_82 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_82 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_82 then
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if (transform_left_filter_column_6_0 / 128) = 1 then
        transform_left_filter_feature_0_choice_86 := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choice_86 := transform_left_filter_feature_0_all_3;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_87 := ((transform_left_filter_column_6_0 / 128) = 1) and
          transform_filtering_0_column_inside_6 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_87 := transform_left_filter_feature_0_choice_86;
      end if;
      if (transform_left_filter_column_6_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_88 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_88 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_89 := transform_left_filter_feature_0_choice_88;
      else
        transform_left_filter_feature_0_choice_89 := ((transform_left_filter_column_6_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_89 then
        transform_left_filter_feature_0_choice_90 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_90 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_90 then
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_95 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_96 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_96 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_97 := transform_left_filter_feature_0_choice_96;
      else
        transform_left_filter_feature_0_choice_97 := ((transform_left_filter_column_8_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_97 then
        transform_left_filter_feature_0_choice_98 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_98 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_98 then
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      transform_left_filter_feature_0_all_4 := transform_filtering_0_column_inside_8 and (not
        ((transform_left_filter_column_4_2 / 128) = 1));
      if (transform_left_filter_column_8_2 / 128) = 1 then
        transform_left_filter_feature_0_choice_103 := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choice_103 := transform_left_filter_feature_0_all_4;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_8_2 / 128) = 1) and
          transform_filtering_0_column_inside_8 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_104 := transform_left_filter_feature_0_choice_103;
      end if;
      if (transform_left_filter_column_8_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_105 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_105 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_choice_105;
      else
        transform_left_filter_feature_0_choice_106 := ((transform_left_filter_column_8_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_106 then
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if (transform_left_filter_column_8_0 / 128) = 1 then
        transform_left_filter_feature_0_choice_112 := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choice_112 := transform_left_filter_feature_0_all_4;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_113 := ((transform_left_filter_column_8_0 / 128) = 1) and
          transform_filtering_0_column_inside_8 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_113 := transform_left_filter_feature_0_choice_112;
      end if;
      if (transform_left_filter_column_8_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_114 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_115 := transform_left_filter_feature_0_choice_114;
      else
        transform_left_filter_feature_0_choice_115 := ((transform_left_filter_column_8_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_120 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_120 then
        transform_left_filter_feature_0_choice_121 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_121 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_4_2 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_4_2 mod 2) = 1));
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_4_2 mod 4) = 0;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_4_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_4_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_4_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_4_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_4_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_9 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_9 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_10 := transform_right_filter_feature_0_choice_9;
      else
        transform_right_filter_feature_0_choice_10 := ((transform_right_filter_column_4_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_10 then
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_11 then
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_12 then
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_13 then
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_14 then
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_15 then
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_4_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_4_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_17 := as_number(transform_right_filter_feature_0_choice_8) +
          (as_number(transform_right_filter_feature_0_choice_16) * 2);
      else
        transform_right_filter_feature_0_choice_17 := 0;
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_18 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_18 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_19 := transform_right_filter_feature_0_choice_18;
      else
        transform_right_filter_feature_0_choice_19 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_19 then
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_20 then
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_21 then
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_22 then
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_23 then
        transform_right_filter_feature_0_choice_24 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_24 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      transform_right_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        ((transform_right_filter_column_4_2 / 128) = 1));
      if (transform_right_filter_column_0_2 / 128) = 1 then
        transform_right_filter_feature_0_choice_25 := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choice_24 then
        transform_right_filter_feature_0_choice_26 := ((transform_right_filter_column_0_2 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_choice_25;
      end if;
      if (transform_right_filter_column_0_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_27 := (transform_right_filter_column_4_2 mod 4) = 3;
      else
        transform_right_filter_feature_0_choice_27 := transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_28 := transform_right_filter_feature_0_choice_27;
      else
        transform_right_filter_feature_0_choice_28 := (not ((transform_right_filter_column_0_0 mod 2) = 1)) or
          transform_right_filter_feature_0_value or ((transform_right_filter_column_4_2 mod 2) = 1);
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := transform_right_filter_feature_0_value_7 and (not
          transform_right_filter_feature_0_value_2);
      else
        transform_right_filter_feature_0_choice_29 := transform_right_filter_feature_0_value_7 or (not
          transform_right_filter_feature_0_value_2);
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := transform_right_filter_feature_0_value_8 or (not
          transform_right_filter_feature_0_value_3);
      else
        transform_right_filter_feature_0_choice_30 := transform_right_filter_feature_0_value_8 and (not
          transform_right_filter_feature_0_value_3);
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := transform_right_filter_feature_0_value_9 or (not
          transform_right_filter_feature_0_value_4);
      else
        transform_right_filter_feature_0_choice_31 := transform_right_filter_feature_0_value_9 and (not
          transform_right_filter_feature_0_value_4);
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := transform_right_filter_feature_0_value_10 or (not
          transform_right_filter_feature_0_value_5);
      else
        transform_right_filter_feature_0_choice_32 := transform_right_filter_feature_0_value_10 and (not
          transform_right_filter_feature_0_value_5);
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_32 then
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_value_11 or (not
          transform_right_filter_feature_0_value_6);
      else
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_value_11 and (not
          transform_right_filter_feature_0_value_6);
      end if;
      if (transform_right_filter_column_0_0 / 128) = 1 then
        transform_right_filter_feature_0_choice_34 := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choice_33 then
        transform_right_filter_feature_0_choice_35 := transform_right_filter_feature_0_choice_34;
      else
        transform_right_filter_feature_0_choice_35 := ((transform_right_filter_column_0_0 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_36 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_36 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_37 := transform_right_filter_feature_0_choice_36;
      else
        transform_right_filter_feature_0_choice_37 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_40 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_40 then
        transform_right_filter_feature_0_choice_41 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_41 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_41 then
        transform_right_filter_feature_0_choice_42 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_42 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_0_4 / 128) = 1 then
        transform_right_filter_feature_0_choice_43 := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choice_43 := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_44 := ((transform_right_filter_column_0_4 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_44 := transform_right_filter_feature_0_choice_43;
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_45 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_45 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_46 := transform_right_filter_feature_0_choice_45;
      else
        transform_right_filter_feature_0_choice_46 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_48 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_48 then
        transform_right_filter_feature_0_choice_49 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_49 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_49 then
        transform_right_filter_feature_0_choice_50 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_50 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      transform_right_filter_feature_0_all_2 := transform_filtering_0_column_inside_2 and (not
        ((transform_right_filter_column_4_2 / 128) = 1));
      if (transform_right_filter_column_2_2 / 128) = 1 then
        transform_right_filter_feature_0_choice_52 := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choice_52 := transform_right_filter_feature_0_all_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_53 := ((transform_right_filter_column_2_2 / 128) = 1) and
          transform_filtering_0_column_inside_2 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_53 := transform_right_filter_feature_0_choice_52;
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_54 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_54 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_55 := transform_right_filter_feature_0_choice_54;
      else
        transform_right_filter_feature_0_choice_55 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_56 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_56 then
        transform_right_filter_feature_0_choice_57 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_57 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_57 then
        transform_right_filter_feature_0_choice_58 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_58 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_2_0 / 128) = 1 then
        transform_right_filter_feature_0_choice_61 := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choice_61 := transform_right_filter_feature_0_all_2;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_62 := ((transform_right_filter_column_2_0 / 128) = 1) and
          transform_filtering_0_column_inside_2 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_62 := transform_right_filter_feature_0_choice_61;
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_63 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_63 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_64 := transform_right_filter_feature_0_choice_63;
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_64 then
        transform_right_filter_feature_0_choice_65 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_65 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_65 then
        transform_right_filter_feature_0_choice_66 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_66 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_2_4 / 128) = 1 then
        transform_right_filter_feature_0_choice_70 := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choice_70 := transform_right_filter_feature_0_all_2;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_71 := ((transform_right_filter_column_2_4 / 128) = 1) and
          transform_filtering_0_column_inside_2 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_71 := transform_right_filter_feature_0_choice_70;
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_72 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_72 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_choice_72;
      else
        transform_right_filter_feature_0_choice_73 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_73 then
        transform_right_filter_feature_0_choice_74 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_74 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      transform_right_filter_feature_0_all_3 := transform_filtering_0_column_inside_6 and (not
        ((transform_right_filter_column_4_2 / 128) = 1));
      if (transform_right_filter_column_6_2 / 128) = 1 then
        transform_right_filter_feature_0_choice_79 := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choice_79 := transform_right_filter_feature_0_all_3;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_6_2 / 128) = 1) and
          transform_filtering_0_column_inside_6 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_80 := transform_right_filter_feature_0_choice_79;
      end if;
      if (transform_right_filter_column_6_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_81 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_81 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_choice_81;
      else
        transform_right_filter_feature_0_choice_82 := ((transform_right_filter_column_6_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_82 then
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_6_0 / 128) = 1 then
        transform_right_filter_feature_0_choice_88 := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choice_88 := transform_right_filter_feature_0_all_3;
      end if;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_89 := ((transform_right_filter_column_6_0 / 128) = 1) and
          transform_filtering_0_column_inside_6 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_89 := transform_right_filter_feature_0_choice_88;
      end if;
      if (transform_right_filter_column_6_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_90 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_91 := transform_right_filter_feature_0_choice_90;
      else
        transform_right_filter_feature_0_choice_91 := ((transform_right_filter_column_6_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_96 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_6_4 / 128) = 1 then
        transform_right_filter_feature_0_choice_97 := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choice_97 := transform_right_filter_feature_0_all_3;
      end if;
      if transform_right_filter_feature_0_choice_96 then
        transform_right_filter_feature_0_choice_98 := ((transform_right_filter_column_6_4 / 128) = 1) and
          transform_filtering_0_column_inside_6 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_choice_97;
      end if;
      if (transform_right_filter_column_8_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_99 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_99 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_100 := transform_right_filter_feature_0_choice_99;
      else
        transform_right_filter_feature_0_choice_100 := ((transform_right_filter_column_8_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_104 then
        transform_right_filter_feature_0_choice_105 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_105 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      transform_right_filter_feature_0_all_4 := transform_filtering_0_column_inside_8 and (not
        ((transform_right_filter_column_4_2 / 128) = 1));
      if (transform_right_filter_column_8_2 / 128) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_all_4;
      end if;
      if transform_right_filter_feature_0_choice_105 then
        transform_right_filter_feature_0_choice_107 := ((transform_right_filter_column_8_2 / 128) = 1) and
          transform_filtering_0_column_inside_8 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_107 := transform_right_filter_feature_0_choice_106;
      end if;
      if (transform_right_filter_column_8_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_108 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_108 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_109 := transform_right_filter_feature_0_choice_108;
      else
        transform_right_filter_feature_0_choice_109 := ((transform_right_filter_column_8_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_112 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_112 then
        transform_right_filter_feature_0_choice_113 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_113 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_113 then
        transform_right_filter_feature_0_choice_114 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_114 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_8_0 / 128) = 1 then
        transform_right_filter_feature_0_choice_115 := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choice_115 := transform_right_filter_feature_0_all_4;
      end if;
      if transform_right_filter_feature_0_choice_114 then
        transform_right_filter_feature_0_choice_116 := ((transform_right_filter_column_8_0 / 128) = 1) and
          transform_filtering_0_column_inside_8 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_116 := transform_right_filter_feature_0_choice_115;
      end if;
      if (transform_right_filter_column_8_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_117 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_117 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_118 := transform_right_filter_feature_0_choice_117;
      else
        transform_right_filter_feature_0_choice_118 := ((transform_right_filter_column_8_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_120 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_120 then
        transform_right_filter_feature_0_choice_121 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_121 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_121 then
        transform_right_filter_feature_0_choice_122 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_122 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_122 then
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if (transform_right_filter_column_8_4 / 128) = 1 then
        transform_right_filter_feature_0_choice_124 := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choice_124 := transform_right_filter_feature_0_all_4;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_125 := ((transform_right_filter_column_8_4 / 128) = 1) and
          transform_filtering_0_column_inside_8 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_125 := transform_right_filter_feature_0_choice_124;
      end if;
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
      transform_read_row_inside_0 <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 12;
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_4 <= (not ((transform_counter_group / 8) = 1)) or (not (((transform_counter_group / 4)
        mod 2) = 1));
      transform_read_column_inside_0 <= ((transform_counter_column / 32) = 1) or transform_read_column_inside_0_value
        or transform_read_column_inside_0_value_2 or transform_read_column_inside_0_value_3;
      transform_read_column_inside_4 <= true;
      transform_read_column_inside_8 <= ((transform_counter_column / 32) = 1) or transform_read_column_inside_0_value
        or transform_read_column_inside_0_value_2 or (not transform_read_column_inside_0_value_3);
      transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 2);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column_2 <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column_4 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_4 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_row_inside_4 <= transform_ready_row_inside_4;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_column_inside_8 <= transform_ready_column_inside_8;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_17 * 64) +
        (as_number(transform_left_filter_feature_0_choice_26) * 2) +
        as_number(transform_left_filter_feature_0_choice_35) + (as_number(transform_left_filter_feature_0_choice_43) *
        4) + (as_number(transform_left_filter_feature_0_choice_52) * 16) +
        (as_number(transform_left_filter_feature_0_choice_61) * 8) +
        (as_number(transform_left_filter_feature_0_choice_69) * 32) +
        (as_number(transform_left_filter_feature_0_choice_78) * 512) +
        (as_number(transform_left_filter_feature_0_choice_87) * 256) +
        (as_number(transform_left_filter_feature_0_choice_95) * 1024) +
        (as_number(transform_left_filter_feature_0_choice_104) * 4096) +
        (as_number(transform_left_filter_feature_0_choice_113) * 2048) +
        (as_number(transform_left_filter_feature_0_choice_121) * 8192);
      transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_17 * 64) +
        (as_number(transform_right_filter_feature_0_choice_26) * 2) +
        as_number(transform_right_filter_feature_0_choice_35) + (as_number(transform_right_filter_feature_0_choice_44)
        * 4) + (as_number(transform_right_filter_feature_0_choice_53) * 16) +
        (as_number(transform_right_filter_feature_0_choice_62) * 8) +
        (as_number(transform_right_filter_feature_0_choice_71) * 32) +
        (as_number(transform_right_filter_feature_0_choice_80) * 512) +
        (as_number(transform_right_filter_feature_0_choice_89) * 256) +
        (as_number(transform_right_filter_feature_0_choice_98) * 1024) +
        (as_number(transform_right_filter_feature_0_choice_107) * 4096) +
        (as_number(transform_right_filter_feature_0_choice_116) * 2048) +
        (as_number(transform_right_filter_feature_0_choice_125) * 8192);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 4;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if ((transform_counter_column / 2) mod 16) = 0 then
        transform_read_column_inside_2 <= transform_read_column_inside_2_is_equal /= ((transform_counter_column / 32) =
          1);
      else
        transform_read_column_inside_2 <= transform_read_column_inside_2_differs;
      end if;
      if transform_read_column_inside_6_choice then
        transform_read_column_inside_6 <= transform_read_column_inside_2_is_equal /=
          transform_read_column_inside_0_value_2;
      else
        transform_read_column_inside_6 <= transform_read_column_inside_2_differs;
      end if;
      if in_start_of_frame then
        transform_counter_next_frame_choice := transform_counter_group_all;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
        end if;
        if transform_counter_group_is_equal and transform_counter_group_is_equal_3 then
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        else
          transform_counter_next_frame <= transform_counter_next_frame_choice;
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
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_1_4 <= transform_left_filter_column_0_4;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_2_4 <= transform_left_filter_column_1_4;
        transform_left_filter_column_3_0 <= transform_left_filter_column_2_0;
        transform_left_filter_column_3_2 <= transform_left_filter_column_2_2;
        transform_left_filter_column_3_4 <= transform_left_filter_column_2_4;
        transform_left_filter_column_4_0 <= transform_left_filter_column_3_0;
        transform_left_filter_column_4_2 <= transform_left_filter_column_3_2;
        transform_left_filter_column_4_4 <= transform_left_filter_column_3_4;
        transform_left_filter_column_5_0 <= transform_left_filter_column_4_0;
        transform_left_filter_column_5_2 <= transform_left_filter_column_4_2;
        transform_left_filter_column_5_4 <= transform_left_filter_column_4_4;
        transform_left_filter_column_6_0 <= transform_left_filter_column_5_0;
        transform_left_filter_column_6_2 <= transform_left_filter_column_5_2;
        transform_left_filter_column_6_4 <= transform_left_filter_column_5_4;
        transform_left_filter_column_7_0 <= transform_left_filter_column_6_0;
        transform_left_filter_column_7_2 <= transform_left_filter_column_6_2;
        transform_left_filter_column_7_4 <= transform_left_filter_column_6_4;
        transform_left_filter_column_8_0 <= transform_left_filter_column_7_0;
        transform_left_filter_column_8_2 <= transform_left_filter_column_7_2;
        transform_left_filter_column_8_4 <= transform_left_filter_column_7_4;
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_1_4 <= transform_right_filter_column_0_4;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_2_4 <= transform_right_filter_column_1_4;
        transform_right_filter_column_3_0 <= transform_right_filter_column_2_0;
        transform_right_filter_column_3_2 <= transform_right_filter_column_2_2;
        transform_right_filter_column_3_4 <= transform_right_filter_column_2_4;
        transform_right_filter_column_4_0 <= transform_right_filter_column_3_0;
        transform_right_filter_column_4_2 <= transform_right_filter_column_3_2;
        transform_right_filter_column_4_4 <= transform_right_filter_column_3_4;
        transform_right_filter_column_5_0 <= transform_right_filter_column_4_0;
        transform_right_filter_column_5_2 <= transform_right_filter_column_4_2;
        transform_right_filter_column_5_4 <= transform_right_filter_column_4_4;
        transform_right_filter_column_6_0 <= transform_right_filter_column_5_0;
        transform_right_filter_column_6_2 <= transform_right_filter_column_5_2;
        transform_right_filter_column_6_4 <= transform_right_filter_column_5_4;
        transform_right_filter_column_7_0 <= transform_right_filter_column_6_0;
        transform_right_filter_column_7_2 <= transform_right_filter_column_6_2;
        transform_right_filter_column_7_4 <= transform_right_filter_column_6_4;
        transform_right_filter_column_8_0 <= transform_right_filter_column_7_0;
        transform_right_filter_column_8_2 <= transform_right_filter_column_7_2;
        transform_right_filter_column_8_4 <= transform_right_filter_column_7_4;
        if transform_columns_row_inside_0 then
          transform_left_filter_column_0_0 <= transform_left_column_0;
          transform_right_filter_column_0_0 <= transform_right_column_0;
        else
          transform_left_filter_column_0_0 <= 0;
          transform_right_filter_column_0_0 <= 0;
        end if;
        if transform_columns_row_inside_2 then
          transform_left_filter_column_0_2 <= transform_left_column_2;
          transform_right_filter_column_0_2 <= transform_right_column_2;
        else
          transform_left_filter_column_0_2 <= 0;
          transform_right_filter_column_0_2 <= 0;
        end if;
        if transform_columns_row_inside_4 then
          transform_left_filter_column_0_4 <= transform_left_column_4;
          transform_right_filter_column_0_4 <= transform_right_column_4;
        else
          transform_left_filter_column_0_4 <= 0;
          transform_right_filter_column_0_4 <= 0;
        end if;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_group = 11;
      raster_place_group_is_equal_2 := raster_place_column = 39;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := (raster_place_group / 2) = 6;
      if raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := raster_place_group_is_equal_2 and (not ((raster_place_group mod 2) = 1)) and
          transform_filtering_1_valid;
      else
        raster_place_group_choice_2 := raster_place_group_is_equal_2 and transform_filtering_1_valid;
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
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_start_of_frame and transform_filtering_1_valid then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if raster_place_group_is_equal_2 then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal_2 or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
        if raster_place_next_frame_choice_2 then
          raster_place_next_frame <= raster_place_group_all or (not transform_filtering_1_start_of_frame);
        else
          raster_place_next_frame <= raster_place_group_is_equal and raster_place_group_is_equal_2 and
            transform_filtering_1_start_of_frame;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 11 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 16;
        end if;
      end if;
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 13;
      delay_tag_first_cost_is_equal := raster_place_column = 11;
      delay_tag_map_column_is_not_less := raster_place_column >= 11;
      delay_tag_map_column_is_less := raster_place_column < 40;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside_1 <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside_2 <= (not ((raster_place_group / 8) = 1)) or (not (((raster_place_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= (not ((((raster_place_column / 8) mod 2) = 1) and ((((raster_place_column / 4) mod 2)
        = 1) or ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
        delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_group_is_equal_2;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
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
        rows_search_0 <= rows_search_rows_ready_words_0 mod 16384;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 16384;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_0 / 16384;
        rows_reference_1 <= rows_reference_rows_ready_words_0 / 16384;
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
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 16384) + (rows_search_rows_ready_newest_0 *
          16384);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 16384) +
          (rows_reference_rows_ready_newest_0 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= slice0shift_search_0_3;
        slice0shift_search_0_3 <= slice0shift_search_0_4;
        slice0shift_search_0_4 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= slice0shift_search_1_3;
        slice0shift_search_1_3 <= slice0shift_search_1_4;
        slice0shift_search_1_4 <= rows_search_1;
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= slice0shift_search_2_3;
        slice0shift_search_2_3 <= slice0shift_search_2_4;
        slice0shift_search_2_4 <= rows_search_2;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pixels_first_0_0_count_0_value := ((slice0shift_reference_0 / 4) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_0_value_2 := ((slice0shift_reference_0 / 2) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_1_value := ((slice0shift_reference_0 / 8) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_1_value_2 := ((slice0shift_reference_0 / 32) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_1_value_3 := ((slice0shift_reference_0 / 16) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_2_value := ((slice0shift_reference_0 / 256) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_2_value_2 := ((slice0shift_reference_0 / 64) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_3_value := ((slice0shift_reference_0 / 512) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_3_value_2 := ((slice0shift_reference_0 / 2048) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_3_value_3 := ((slice0shift_reference_0 / 1024) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_4_value := ((slice0shift_reference_0 / 4096) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_0_value := ((slice0shift_reference_1 / 4) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_0_value_2 := ((slice0shift_reference_1 / 2) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_1_value := ((slice0shift_reference_1 / 8) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_1_value_2 := ((slice0shift_reference_1 / 32) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_1_value_3 := ((slice0shift_reference_1 / 16) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_2_value := ((slice0shift_reference_1 / 256) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_2_value_2 := ((slice0shift_reference_1 / 64) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_3_value := ((slice0shift_reference_1 / 512) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_3_value_2 := ((slice0shift_reference_1 / 2048) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_3_value_3 := ((slice0shift_reference_1 / 1024) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_4_value := ((slice0shift_reference_1 / 4096) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_0_value := ((slice0shift_reference_2 / 4) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_0_value_2 := ((slice0shift_reference_2 / 2) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_1_value := ((slice0shift_reference_2 / 8) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_1_value_2 := ((slice0shift_reference_2 / 32) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_1_value_3 := ((slice0shift_reference_2 / 16) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_2_value := ((slice0shift_reference_2 / 256) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_2_value_2 := ((slice0shift_reference_2 / 64) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_3_value := ((slice0shift_reference_2 / 512) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_3_value_2 := ((slice0shift_reference_2 / 2048) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_3_value_3 := ((slice0shift_reference_2 / 1024) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_4_value := ((slice0shift_reference_2 / 4096) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_0 <= as_number((((slice0shift_search_0_0 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_0_value /=
        (((slice0shift_search_0_0 / 4) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_0_value_2 /=
        (((slice0shift_search_0_0 / 2) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_1 <= as_number((slice0cost_pixels_first_0_0_count_1_value /=
        (((slice0shift_search_0_0 / 8) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_1_value_2 /=
        (((slice0shift_search_0_0 / 32) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_1_value_3 /=
        (((slice0shift_search_0_0 / 16) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_0 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice0cost_pixels_first_0_0_count_2_value /= (((slice0shift_search_0_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_2_value_2 /= (((slice0shift_search_0_0 / 64) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_3 <= as_number((slice0cost_pixels_first_0_0_count_3_value /=
        (((slice0shift_search_0_0 / 512) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_3_value_2 /=
        (((slice0shift_search_0_0 / 2048) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_3_value_3 /=
        (((slice0shift_search_0_0 / 1024) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_4 <= as_number((((slice0shift_reference_0 / 8192) = 1) /=
        ((slice0shift_search_0_0 / 8192) = 1))) + as_number((slice0cost_pixels_first_0_0_count_4_value /=
        (((slice0shift_search_0_0 / 4096) mod 2) = 1)));
      slice0cost_pixels_first_0_1_count_0 <= as_number((((slice0shift_search_0_1 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_1_count_1 <= as_number(((((slice0shift_search_0_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_1 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_1 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_1 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_1_count_3 <= as_number(((((slice0shift_search_0_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_1 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_1_count_4 <= as_number((((slice0shift_search_0_1 / 8192) = 1) /=
        ((slice0shift_reference_0 / 8192) = 1))) + as_number(((((slice0shift_search_0_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value));
      slice0cost_pixels_first_0_2_count_0 <= as_number((((slice0shift_search_0_2 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_2_count_1 <= as_number(((((slice0shift_search_0_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_2_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_2 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_2 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_2 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_2_count_3 <= as_number(((((slice0shift_search_0_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_2 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_2_count_4 <= as_number((((slice0shift_search_0_2 / 8192) = 1) /=
        ((slice0shift_reference_0 / 8192) = 1))) + as_number(((((slice0shift_search_0_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value));
      slice0cost_pixels_first_0_3_count_0 <= as_number((((slice0shift_search_0_3 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_3_count_1 <= as_number(((((slice0shift_search_0_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_3_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_3 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_3 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_3 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_3_count_3 <= as_number(((((slice0shift_search_0_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_3 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_3_count_4 <= as_number((((slice0shift_search_0_3 / 8192) = 1) /=
        ((slice0shift_reference_0 / 8192) = 1))) + as_number(((((slice0shift_search_0_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value));
      slice0cost_pixels_first_0_4_count_0 <= as_number((((slice0shift_search_0_4 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_4_count_1 <= as_number(((((slice0shift_search_0_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_4_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_4 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_4 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_4 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_4_count_3 <= as_number(((((slice0shift_search_0_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_4 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_4_count_4 <= as_number((((slice0shift_search_0_4 / 8192) = 1) /=
        ((slice0shift_reference_0 / 8192) = 1))) + as_number(((((slice0shift_search_0_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value));
      slice0cost_pixels_first_1_0_count_0 <= as_number((((slice0shift_search_1_0 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_0_value /=
        (((slice0shift_search_1_0 / 4) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_0_value_2 /=
        (((slice0shift_search_1_0 / 2) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_1 <= as_number((slice0cost_pixels_first_1_0_count_1_value /=
        (((slice0shift_search_1_0 / 8) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_1_value_2 /=
        (((slice0shift_search_1_0 / 32) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_1_value_3 /=
        (((slice0shift_search_1_0 / 16) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_0 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) +
        as_number((slice0cost_pixels_first_1_0_count_2_value /= (((slice0shift_search_1_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_2_value_2 /= (((slice0shift_search_1_0 / 64) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_3 <= as_number((slice0cost_pixels_first_1_0_count_3_value /=
        (((slice0shift_search_1_0 / 512) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_3_value_2 /=
        (((slice0shift_search_1_0 / 2048) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_3_value_3 /=
        (((slice0shift_search_1_0 / 1024) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_4 <= as_number((((slice0shift_reference_1 / 8192) = 1) /=
        ((slice0shift_search_1_0 / 8192) = 1))) + as_number((slice0cost_pixels_first_1_0_count_4_value /=
        (((slice0shift_search_1_0 / 4096) mod 2) = 1)));
      slice0cost_pixels_first_1_1_count_0 <= as_number((((slice0shift_search_1_1 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_1_count_1 <= as_number(((((slice0shift_search_1_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_1_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_1 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_1 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_1 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_1_count_3 <= as_number(((((slice0shift_search_1_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_1 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_1_count_4 <= as_number((((slice0shift_search_1_1 / 8192) = 1) /=
        ((slice0shift_reference_1 / 8192) = 1))) + as_number(((((slice0shift_search_1_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value));
      slice0cost_pixels_first_1_2_count_0 <= as_number((((slice0shift_search_1_2 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_2_count_1 <= as_number(((((slice0shift_search_1_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_2_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_2 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_2 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_2 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_2_count_3 <= as_number(((((slice0shift_search_1_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_2 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_2_count_4 <= as_number((((slice0shift_search_1_2 / 8192) = 1) /=
        ((slice0shift_reference_1 / 8192) = 1))) + as_number(((((slice0shift_search_1_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value));
      slice0cost_pixels_first_1_3_count_0 <= as_number((((slice0shift_search_1_3 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_3_count_1 <= as_number(((((slice0shift_search_1_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_3_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_3 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_3 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_3 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_3_count_3 <= as_number(((((slice0shift_search_1_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_3 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_3_count_4 <= as_number((((slice0shift_search_1_3 / 8192) = 1) /=
        ((slice0shift_reference_1 / 8192) = 1))) + as_number(((((slice0shift_search_1_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value));
      slice0cost_pixels_first_1_4_count_0 <= as_number((((slice0shift_search_1_4 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_4_count_1 <= as_number(((((slice0shift_search_1_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_4_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_4 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_4 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_4 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_4_count_3 <= as_number(((((slice0shift_search_1_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_4 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_4_count_4 <= as_number((((slice0shift_search_1_4 / 8192) = 1) /=
        ((slice0shift_reference_1 / 8192) = 1))) + as_number(((((slice0shift_search_1_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value));
      slice0cost_pixels_first_2_0_count_0 <= as_number((((slice0shift_search_2_0 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_0_value /=
        (((slice0shift_search_2_0 / 4) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_0_value_2 /=
        (((slice0shift_search_2_0 / 2) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_1 <= as_number((slice0cost_pixels_first_2_0_count_1_value /=
        (((slice0shift_search_2_0 / 8) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_1_value_2 /=
        (((slice0shift_search_2_0 / 32) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_1_value_3 /=
        (((slice0shift_search_2_0 / 16) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_2 <= (to_integer(((to_unsigned((slice0shift_search_2_0 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_2 mod 256), 8)))) / 128) +
        as_number((slice0cost_pixels_first_2_0_count_2_value /= (((slice0shift_search_2_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_2_value_2 /= (((slice0shift_search_2_0 / 64) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_3 <= as_number((slice0cost_pixels_first_2_0_count_3_value /=
        (((slice0shift_search_2_0 / 512) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_3_value_2 /=
        (((slice0shift_search_2_0 / 2048) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_3_value_3 /=
        (((slice0shift_search_2_0 / 1024) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_4 <= as_number((((slice0shift_reference_2 / 8192) = 1) /=
        ((slice0shift_search_2_0 / 8192) = 1))) + as_number((slice0cost_pixels_first_2_0_count_4_value /=
        (((slice0shift_search_2_0 / 4096) mod 2) = 1)));
      slice0cost_pixels_first_2_1_count_0 <= as_number((((slice0shift_search_2_1 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value)) + as_number(((((slice0shift_search_2_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_1_count_1 <= as_number(((((slice0shift_search_2_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((((slice0shift_search_2_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice0shift_search_2_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_1_count_2 <= (to_integer(((to_unsigned((slice0shift_search_2_1 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_2_1 / 256) mod
        2) = 1) /= slice0cost_pixels_first_2_0_count_2_value)) + as_number(((((slice0shift_search_2_1 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_1_count_3 <= as_number(((((slice0shift_search_2_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((((slice0shift_search_2_1 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice0shift_search_2_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_1_count_4 <= as_number((((slice0shift_search_2_1 / 8192) = 1) /=
        ((slice0shift_reference_2 / 8192) = 1))) + as_number(((((slice0shift_search_2_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value));
      slice0cost_pixels_first_2_2_count_0 <= as_number((((slice0shift_search_2_2 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value)) + as_number(((((slice0shift_search_2_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_2_count_1 <= as_number(((((slice0shift_search_2_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((((slice0shift_search_2_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice0shift_search_2_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_2_count_2 <= (to_integer(((to_unsigned((slice0shift_search_2_2 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_2_2 / 256) mod
        2) = 1) /= slice0cost_pixels_first_2_0_count_2_value)) + as_number(((((slice0shift_search_2_2 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_2_count_3 <= as_number(((((slice0shift_search_2_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((((slice0shift_search_2_2 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice0shift_search_2_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_2_count_4 <= as_number((((slice0shift_search_2_2 / 8192) = 1) /=
        ((slice0shift_reference_2 / 8192) = 1))) + as_number(((((slice0shift_search_2_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value));
      slice0cost_pixels_first_2_3_count_0 <= as_number((((slice0shift_search_2_3 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value)) + as_number(((((slice0shift_search_2_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_3_count_1 <= as_number(((((slice0shift_search_2_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((((slice0shift_search_2_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice0shift_search_2_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_3_count_2 <= (to_integer(((to_unsigned((slice0shift_search_2_3 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_2_3 / 256) mod
        2) = 1) /= slice0cost_pixels_first_2_0_count_2_value)) + as_number(((((slice0shift_search_2_3 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_3_count_3 <= as_number(((((slice0shift_search_2_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((((slice0shift_search_2_3 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice0shift_search_2_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_3_count_4 <= as_number((((slice0shift_search_2_3 / 8192) = 1) /=
        ((slice0shift_reference_2 / 8192) = 1))) + as_number(((((slice0shift_search_2_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value));
      slice0cost_pixels_first_2_4_count_0 <= as_number((((slice0shift_search_2_4 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value)) + as_number(((((slice0shift_search_2_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_4_count_1 <= as_number(((((slice0shift_search_2_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((((slice0shift_search_2_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice0shift_search_2_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_4_count_2 <= (to_integer(((to_unsigned((slice0shift_search_2_4 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_2_4 / 256) mod
        2) = 1) /= slice0cost_pixels_first_2_0_count_2_value)) + as_number(((((slice0shift_search_2_4 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_4_count_3 <= as_number(((((slice0shift_search_2_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((((slice0shift_search_2_4 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice0shift_search_2_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_4_count_4 <= as_number((((slice0shift_search_2_4 / 8192) = 1) /=
        ((slice0shift_reference_2 / 8192) = 1))) + as_number(((((slice0shift_search_2_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_0 +
        slice0cost_pixels_first_0_0_count_1 + slice0cost_pixels_first_0_0_count_4 + slice0cost_pixels_first_0_0_count_2;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_0 +
        slice0cost_pixels_first_0_1_count_1 + slice0cost_pixels_first_0_1_count_4 + slice0cost_pixels_first_0_1_count_2;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_0 +
        slice0cost_pixels_first_0_2_count_1 + slice0cost_pixels_first_0_2_count_4 + slice0cost_pixels_first_0_2_count_2;
      slice0cost_pixels_cost_0_3 <= slice0cost_pixels_first_0_3_count_3 + slice0cost_pixels_first_0_3_count_0 +
        slice0cost_pixels_first_0_3_count_1 + slice0cost_pixels_first_0_3_count_4 + slice0cost_pixels_first_0_3_count_2;
      slice0cost_pixels_cost_0_4 <= slice0cost_pixels_first_0_4_count_3 + slice0cost_pixels_first_0_4_count_0 +
        slice0cost_pixels_first_0_4_count_1 + slice0cost_pixels_first_0_4_count_4 + slice0cost_pixels_first_0_4_count_2;
      slice0cost_pixels_cost_1_0 <= slice0cost_pixels_first_1_0_count_3 + slice0cost_pixels_first_1_0_count_0 +
        slice0cost_pixels_first_1_0_count_1 + slice0cost_pixels_first_1_0_count_4 + slice0cost_pixels_first_1_0_count_2;
      slice0cost_pixels_cost_1_1 <= slice0cost_pixels_first_1_1_count_3 + slice0cost_pixels_first_1_1_count_0 +
        slice0cost_pixels_first_1_1_count_1 + slice0cost_pixels_first_1_1_count_4 + slice0cost_pixels_first_1_1_count_2;
      slice0cost_pixels_cost_1_2 <= slice0cost_pixels_first_1_2_count_3 + slice0cost_pixels_first_1_2_count_0 +
        slice0cost_pixels_first_1_2_count_1 + slice0cost_pixels_first_1_2_count_4 + slice0cost_pixels_first_1_2_count_2;
      slice0cost_pixels_cost_1_3 <= slice0cost_pixels_first_1_3_count_3 + slice0cost_pixels_first_1_3_count_0 +
        slice0cost_pixels_first_1_3_count_1 + slice0cost_pixels_first_1_3_count_4 + slice0cost_pixels_first_1_3_count_2;
      slice0cost_pixels_cost_1_4 <= slice0cost_pixels_first_1_4_count_3 + slice0cost_pixels_first_1_4_count_0 +
        slice0cost_pixels_first_1_4_count_1 + slice0cost_pixels_first_1_4_count_4 + slice0cost_pixels_first_1_4_count_2;
      slice0cost_pixels_cost_2_0 <= slice0cost_pixels_first_2_0_count_3 + slice0cost_pixels_first_2_0_count_0 +
        slice0cost_pixels_first_2_0_count_1 + slice0cost_pixels_first_2_0_count_4 + slice0cost_pixels_first_2_0_count_2;
      slice0cost_pixels_cost_2_1 <= slice0cost_pixels_first_2_1_count_3 + slice0cost_pixels_first_2_1_count_0 +
        slice0cost_pixels_first_2_1_count_1 + slice0cost_pixels_first_2_1_count_4 + slice0cost_pixels_first_2_1_count_2;
      slice0cost_pixels_cost_2_2 <= slice0cost_pixels_first_2_2_count_3 + slice0cost_pixels_first_2_2_count_0 +
        slice0cost_pixels_first_2_2_count_1 + slice0cost_pixels_first_2_2_count_4 + slice0cost_pixels_first_2_2_count_2;
      slice0cost_pixels_cost_2_3 <= slice0cost_pixels_first_2_3_count_3 + slice0cost_pixels_first_2_3_count_0 +
        slice0cost_pixels_first_2_3_count_1 + slice0cost_pixels_first_2_3_count_4 + slice0cost_pixels_first_2_3_count_2;
      slice0cost_pixels_cost_2_4 <= slice0cost_pixels_first_2_4_count_3 + slice0cost_pixels_first_2_4_count_0 +
        slice0cost_pixels_first_2_4_count_1 + slice0cost_pixels_first_2_4_count_4 + slice0cost_pixels_first_2_4_count_2;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pixels_cost_1_0 + slice0cost_pixels_cost_2_0;
      slice0cost_pair_0_1 <= slice0cost_pixels_cost_1_1 + slice0cost_pixels_cost_2_1;
      slice0cost_pair_0_2 <= slice0cost_pixels_cost_1_2 + slice0cost_pixels_cost_2_2;
      slice0cost_pair_0_3 <= slice0cost_pixels_cost_1_3 + slice0cost_pixels_cost_2_3;
      slice0cost_pair_0_4 <= slice0cost_pixels_cost_1_4 + slice0cost_pixels_cost_2_4;
      slice0cost_single_0_0 <= slice0cost_pixels_cost_0_0;
      slice0cost_single_0_1 <= slice0cost_pixels_cost_0_1;
      slice0cost_single_0_2 <= slice0cost_pixels_cost_0_2;
      slice0cost_single_0_3 <= slice0cost_pixels_cost_0_3;
      slice0cost_single_0_4 <= slice0cost_pixels_cost_0_4;
      slice0cost_pair_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_pair_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_pair_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
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
      else
        slice0cost_column_0_0 <= slice0cost_pair_0_0 + slice0cost_single_0_0;
        slice0cost_column_0_1 <= slice0cost_pair_0_1 + slice0cost_single_0_1;
        slice0cost_column_0_2 <= slice0cost_pair_0_2 + slice0cost_single_0_2;
        slice0cost_column_0_3 <= slice0cost_pair_0_3 + slice0cost_single_0_3;
        slice0cost_column_0_4 <= slice0cost_pair_0_4 + slice0cost_single_0_4;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_0_3 <= slice0cost_column_0_3;
        slice0window_partial_0_0_4 <= slice0cost_column_0_4;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
        slice0window_partial_0_1_3 <= slice0cost_column_0_3 + slice0window_partial_0_0_3;
        slice0window_partial_0_1_4 <= slice0cost_column_0_4 + slice0window_partial_0_0_4;
        slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_first_column_0 <= slice0cost_tag_first_cost;
        slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
        slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      end if;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_0_3 <= slice0cost_column_0_3 + slice0window_partial_0_1_3;
      slice0window_sum_0_4 <= slice0cost_column_0_4 + slice0window_partial_0_1_4;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_first_column <= slice0window_centre_first_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
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
      slice0_tag_0_first_column <= slice0window_tag_first_column;
      slice0_tag_0_start_of_frame <= slice0window_tag_start_of_frame;
      slice0_tag_0_end_of_line <= slice0window_tag_end_of_line;
      slice0_tag_1_valid <= slice0_tag_0_valid;
      slice0_tag_1_map_column <= slice0_tag_0_map_column;
      slice0_tag_1_output_column <= slice0_tag_0_output_column;
      slice0_tag_1_first_column <= slice0_tag_0_first_column;
      slice0_tag_1_start_of_frame <= slice0_tag_0_start_of_frame;
      slice0_tag_1_end_of_line <= slice0_tag_0_end_of_line;
      slice0_tag_2_valid <= slice0_tag_1_valid;
      slice0_tag_2_map_column <= slice0_tag_1_map_column;
      slice0_tag_2_output_column <= slice0_tag_1_output_column;
      slice0_tag_2_first_column <= slice0_tag_1_first_column;
      slice0_tag_2_start_of_frame <= slice0_tag_1_start_of_frame;
      slice0_tag_2_end_of_line <= slice0_tag_1_end_of_line;
      if ((slice0window_sum_0_0 / 64) = 1) or (((slice0window_sum_0_0 / 16) mod 4) = 3) then
        slice0_held_0_0 <= 5;
      else
        slice0_held_0_0 <= slice0window_sum_0_0 / 8;
      end if;
      if ((slice0window_sum_0_1 / 64) = 1) or (((slice0window_sum_0_1 / 16) mod 4) = 3) then
        slice0_held_0_1 <= 5;
      else
        slice0_held_0_1 <= slice0window_sum_0_1 / 8;
      end if;
      if ((slice0window_sum_0_2 / 64) = 1) or (((slice0window_sum_0_2 / 16) mod 4) = 3) then
        slice0_held_0_2 <= 5;
      else
        slice0_held_0_2 <= slice0window_sum_0_2 / 8;
      end if;
      if ((slice0window_sum_0_3 / 64) = 1) or (((slice0window_sum_0_3 / 16) mod 4) = 3) then
        slice0_held_0_3 <= 5;
      else
        slice0_held_0_3 <= slice0window_sum_0_3 / 8;
      end if;
      if ((slice0window_sum_0_4 / 64) = 1) or (((slice0window_sum_0_4 / 16) mod 4) = 3) then
        slice0_held_0_4 <= 5;
      else
        slice0_held_0_4 <= slice0window_sum_0_4 / 8;
      end if;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice1shift_search_0_3;
        slice1shift_search_0_3 <= slice1shift_search_0_4;
        slice1shift_search_0_4 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice1shift_search_1_3;
        slice1shift_search_1_3 <= slice1shift_search_1_4;
        slice1shift_search_1_4 <= slice0shift_search_out_1;
        slice1shift_search_2_0 <= slice1shift_search_2_1;
        slice1shift_search_2_1 <= slice1shift_search_2_2;
        slice1shift_search_2_2 <= slice1shift_search_2_3;
        slice1shift_search_2_3 <= slice1shift_search_2_4;
        slice1shift_search_2_4 <= slice0shift_search_out_2;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      slice1shift_search_out_2 <= slice1shift_search_2_0;
      -- slice1cost
      slice1cost_pixels_first_0_0_count_0_value := ((slice1shift_reference_0 / 4) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_0_value_2 := ((slice1shift_reference_0 / 2) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_1_value := ((slice1shift_reference_0 / 8) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_1_value_2 := ((slice1shift_reference_0 / 32) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_1_value_3 := ((slice1shift_reference_0 / 16) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_2_value := ((slice1shift_reference_0 / 256) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_2_value_2 := ((slice1shift_reference_0 / 64) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_3_value := ((slice1shift_reference_0 / 512) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_3_value_2 := ((slice1shift_reference_0 / 2048) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_3_value_3 := ((slice1shift_reference_0 / 1024) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_4_value := ((slice1shift_reference_0 / 4096) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_0_value := ((slice1shift_reference_1 / 4) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_0_value_2 := ((slice1shift_reference_1 / 2) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_1_value := ((slice1shift_reference_1 / 8) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_1_value_2 := ((slice1shift_reference_1 / 32) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_1_value_3 := ((slice1shift_reference_1 / 16) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_2_value := ((slice1shift_reference_1 / 256) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_2_value_2 := ((slice1shift_reference_1 / 64) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_3_value := ((slice1shift_reference_1 / 512) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_3_value_2 := ((slice1shift_reference_1 / 2048) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_3_value_3 := ((slice1shift_reference_1 / 1024) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_4_value := ((slice1shift_reference_1 / 4096) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_0_value := ((slice1shift_reference_2 / 4) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_0_value_2 := ((slice1shift_reference_2 / 2) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_1_value := ((slice1shift_reference_2 / 8) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_1_value_2 := ((slice1shift_reference_2 / 32) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_1_value_3 := ((slice1shift_reference_2 / 16) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_2_value := ((slice1shift_reference_2 / 256) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_2_value_2 := ((slice1shift_reference_2 / 64) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_3_value := ((slice1shift_reference_2 / 512) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_3_value_2 := ((slice1shift_reference_2 / 2048) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_3_value_3 := ((slice1shift_reference_2 / 1024) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_4_value := ((slice1shift_reference_2 / 4096) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_0 <= as_number((((slice1shift_search_0_0 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_0_value /=
        (((slice1shift_search_0_0 / 4) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_0_value_2 /=
        (((slice1shift_search_0_0 / 2) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_1 <= as_number((slice1cost_pixels_first_0_0_count_1_value /=
        (((slice1shift_search_0_0 / 8) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_1_value_2 /=
        (((slice1shift_search_0_0 / 32) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_1_value_3 /=
        (((slice1shift_search_0_0 / 16) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_0 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice1cost_pixels_first_0_0_count_2_value /= (((slice1shift_search_0_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_2_value_2 /= (((slice1shift_search_0_0 / 64) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_3 <= as_number((slice1cost_pixels_first_0_0_count_3_value /=
        (((slice1shift_search_0_0 / 512) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_3_value_2 /=
        (((slice1shift_search_0_0 / 2048) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_3_value_3 /=
        (((slice1shift_search_0_0 / 1024) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_4 <= as_number((((slice1shift_reference_0 / 8192) = 1) /=
        ((slice1shift_search_0_0 / 8192) = 1))) + as_number((slice1cost_pixels_first_0_0_count_4_value /=
        (((slice1shift_search_0_0 / 4096) mod 2) = 1)));
      slice1cost_pixels_first_0_1_count_0 <= as_number((((slice1shift_search_0_1 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_1_count_1 <= as_number(((((slice1shift_search_0_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_1 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_1 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_1 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_1_count_3 <= as_number(((((slice1shift_search_0_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_1 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_1_count_4 <= as_number((((slice1shift_search_0_1 / 8192) = 1) /=
        ((slice1shift_reference_0 / 8192) = 1))) + as_number(((((slice1shift_search_0_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value));
      slice1cost_pixels_first_0_2_count_0 <= as_number((((slice1shift_search_0_2 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_2_count_1 <= as_number(((((slice1shift_search_0_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_2_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_2 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_2 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_2 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_2_count_3 <= as_number(((((slice1shift_search_0_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_2 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_2_count_4 <= as_number((((slice1shift_search_0_2 / 8192) = 1) /=
        ((slice1shift_reference_0 / 8192) = 1))) + as_number(((((slice1shift_search_0_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value));
      slice1cost_pixels_first_0_3_count_0 <= as_number((((slice1shift_search_0_3 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_3_count_1 <= as_number(((((slice1shift_search_0_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_3_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_3 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_3 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_3 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_3_count_3 <= as_number(((((slice1shift_search_0_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_3 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_3_count_4 <= as_number((((slice1shift_search_0_3 / 8192) = 1) /=
        ((slice1shift_reference_0 / 8192) = 1))) + as_number(((((slice1shift_search_0_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value));
      slice1cost_pixels_first_0_4_count_0 <= as_number((((slice1shift_search_0_4 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_4_count_1 <= as_number(((((slice1shift_search_0_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_4_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_4 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_4 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_4 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_4_count_3 <= as_number(((((slice1shift_search_0_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_4 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_4_count_4 <= as_number((((slice1shift_search_0_4 / 8192) = 1) /=
        ((slice1shift_reference_0 / 8192) = 1))) + as_number(((((slice1shift_search_0_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value));
      slice1cost_pixels_first_1_0_count_0 <= as_number((((slice1shift_search_1_0 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_0_value /=
        (((slice1shift_search_1_0 / 4) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_0_value_2 /=
        (((slice1shift_search_1_0 / 2) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_1 <= as_number((slice1cost_pixels_first_1_0_count_1_value /=
        (((slice1shift_search_1_0 / 8) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_1_value_2 /=
        (((slice1shift_search_1_0 / 32) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_1_value_3 /=
        (((slice1shift_search_1_0 / 16) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_0 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) +
        as_number((slice1cost_pixels_first_1_0_count_2_value /= (((slice1shift_search_1_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_1_0_count_2_value_2 /= (((slice1shift_search_1_0 / 64) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_3 <= as_number((slice1cost_pixels_first_1_0_count_3_value /=
        (((slice1shift_search_1_0 / 512) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_3_value_2 /=
        (((slice1shift_search_1_0 / 2048) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_3_value_3 /=
        (((slice1shift_search_1_0 / 1024) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_4 <= as_number((((slice1shift_reference_1 / 8192) = 1) /=
        ((slice1shift_search_1_0 / 8192) = 1))) + as_number((slice1cost_pixels_first_1_0_count_4_value /=
        (((slice1shift_search_1_0 / 4096) mod 2) = 1)));
      slice1cost_pixels_first_1_1_count_0 <= as_number((((slice1shift_search_1_1 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_1_count_1 <= as_number(((((slice1shift_search_1_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_1_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_1 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_1 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_1 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_1_count_3 <= as_number(((((slice1shift_search_1_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_1 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_1_count_4 <= as_number((((slice1shift_search_1_1 / 8192) = 1) /=
        ((slice1shift_reference_1 / 8192) = 1))) + as_number(((((slice1shift_search_1_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value));
      slice1cost_pixels_first_1_2_count_0 <= as_number((((slice1shift_search_1_2 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_2_count_1 <= as_number(((((slice1shift_search_1_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_2_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_2 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_2 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_2 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_2_count_3 <= as_number(((((slice1shift_search_1_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_2 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_2_count_4 <= as_number((((slice1shift_search_1_2 / 8192) = 1) /=
        ((slice1shift_reference_1 / 8192) = 1))) + as_number(((((slice1shift_search_1_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value));
      slice1cost_pixels_first_1_3_count_0 <= as_number((((slice1shift_search_1_3 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_3_count_1 <= as_number(((((slice1shift_search_1_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_3_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_3 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_3 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_3 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_3_count_3 <= as_number(((((slice1shift_search_1_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_3 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_3_count_4 <= as_number((((slice1shift_search_1_3 / 8192) = 1) /=
        ((slice1shift_reference_1 / 8192) = 1))) + as_number(((((slice1shift_search_1_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value));
      slice1cost_pixels_first_1_4_count_0 <= as_number((((slice1shift_search_1_4 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_4_count_1 <= as_number(((((slice1shift_search_1_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_4_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_4 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_4 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_4 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_4_count_3 <= as_number(((((slice1shift_search_1_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_4 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_4_count_4 <= as_number((((slice1shift_search_1_4 / 8192) = 1) /=
        ((slice1shift_reference_1 / 8192) = 1))) + as_number(((((slice1shift_search_1_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value));
      slice1cost_pixels_first_2_0_count_0 <= as_number((((slice1shift_search_2_0 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_0_value /=
        (((slice1shift_search_2_0 / 4) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_0_value_2 /=
        (((slice1shift_search_2_0 / 2) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_1 <= as_number((slice1cost_pixels_first_2_0_count_1_value /=
        (((slice1shift_search_2_0 / 8) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_1_value_2 /=
        (((slice1shift_search_2_0 / 32) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_1_value_3 /=
        (((slice1shift_search_2_0 / 16) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_2 <= (to_integer(((to_unsigned((slice1shift_search_2_0 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_2 mod 256), 8)))) / 128) +
        as_number((slice1cost_pixels_first_2_0_count_2_value /= (((slice1shift_search_2_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_2_0_count_2_value_2 /= (((slice1shift_search_2_0 / 64) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_3 <= as_number((slice1cost_pixels_first_2_0_count_3_value /=
        (((slice1shift_search_2_0 / 512) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_3_value_2 /=
        (((slice1shift_search_2_0 / 2048) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_3_value_3 /=
        (((slice1shift_search_2_0 / 1024) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_4 <= as_number((((slice1shift_reference_2 / 8192) = 1) /=
        ((slice1shift_search_2_0 / 8192) = 1))) + as_number((slice1cost_pixels_first_2_0_count_4_value /=
        (((slice1shift_search_2_0 / 4096) mod 2) = 1)));
      slice1cost_pixels_first_2_1_count_0 <= as_number((((slice1shift_search_2_1 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value)) + as_number(((((slice1shift_search_2_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value_2));
      slice1cost_pixels_first_2_1_count_1 <= as_number(((((slice1shift_search_2_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value)) + as_number(((((slice1shift_search_2_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice1shift_search_2_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_3));
      slice1cost_pixels_first_2_1_count_2 <= (to_integer(((to_unsigned((slice1shift_search_2_1 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_2_1 / 256) mod
        2) = 1) /= slice1cost_pixels_first_2_0_count_2_value)) + as_number(((((slice1shift_search_2_1 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_2_0_count_2_value_2));
      slice1cost_pixels_first_2_1_count_3 <= as_number(((((slice1shift_search_2_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value)) + as_number(((((slice1shift_search_2_1 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice1shift_search_2_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_3));
      slice1cost_pixels_first_2_1_count_4 <= as_number((((slice1shift_search_2_1 / 8192) = 1) /=
        ((slice1shift_reference_2 / 8192) = 1))) + as_number(((((slice1shift_search_2_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value));
      slice1cost_pixels_first_2_2_count_0 <= as_number((((slice1shift_search_2_2 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value)) + as_number(((((slice1shift_search_2_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value_2));
      slice1cost_pixels_first_2_2_count_1 <= as_number(((((slice1shift_search_2_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value)) + as_number(((((slice1shift_search_2_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice1shift_search_2_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_3));
      slice1cost_pixels_first_2_2_count_2 <= (to_integer(((to_unsigned((slice1shift_search_2_2 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_2_2 / 256) mod
        2) = 1) /= slice1cost_pixels_first_2_0_count_2_value)) + as_number(((((slice1shift_search_2_2 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_2_0_count_2_value_2));
      slice1cost_pixels_first_2_2_count_3 <= as_number(((((slice1shift_search_2_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value)) + as_number(((((slice1shift_search_2_2 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice1shift_search_2_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_3));
      slice1cost_pixels_first_2_2_count_4 <= as_number((((slice1shift_search_2_2 / 8192) = 1) /=
        ((slice1shift_reference_2 / 8192) = 1))) + as_number(((((slice1shift_search_2_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value));
      slice1cost_pixels_first_2_3_count_0 <= as_number((((slice1shift_search_2_3 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value)) + as_number(((((slice1shift_search_2_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value_2));
      slice1cost_pixels_first_2_3_count_1 <= as_number(((((slice1shift_search_2_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value)) + as_number(((((slice1shift_search_2_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice1shift_search_2_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_3));
      slice1cost_pixels_first_2_3_count_2 <= (to_integer(((to_unsigned((slice1shift_search_2_3 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_2_3 / 256) mod
        2) = 1) /= slice1cost_pixels_first_2_0_count_2_value)) + as_number(((((slice1shift_search_2_3 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_2_0_count_2_value_2));
      slice1cost_pixels_first_2_3_count_3 <= as_number(((((slice1shift_search_2_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value)) + as_number(((((slice1shift_search_2_3 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice1shift_search_2_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_3));
      slice1cost_pixels_first_2_3_count_4 <= as_number((((slice1shift_search_2_3 / 8192) = 1) /=
        ((slice1shift_reference_2 / 8192) = 1))) + as_number(((((slice1shift_search_2_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value));
      slice1cost_pixels_first_2_4_count_0 <= as_number((((slice1shift_search_2_4 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value)) + as_number(((((slice1shift_search_2_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_0_value_2));
      slice1cost_pixels_first_2_4_count_1 <= as_number(((((slice1shift_search_2_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value)) + as_number(((((slice1shift_search_2_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice1shift_search_2_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_1_value_3));
      slice1cost_pixels_first_2_4_count_2 <= (to_integer(((to_unsigned((slice1shift_search_2_4 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_2_4 / 256) mod
        2) = 1) /= slice1cost_pixels_first_2_0_count_2_value)) + as_number(((((slice1shift_search_2_4 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_2_0_count_2_value_2));
      slice1cost_pixels_first_2_4_count_3 <= as_number(((((slice1shift_search_2_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value)) + as_number(((((slice1shift_search_2_4 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice1shift_search_2_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_3_value_3));
      slice1cost_pixels_first_2_4_count_4 <= as_number((((slice1shift_search_2_4 / 8192) = 1) /=
        ((slice1shift_reference_2 / 8192) = 1))) + as_number(((((slice1shift_search_2_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value));
      slice1cost_pixels_cost_0_0 <= slice1cost_pixels_first_0_0_count_3 + slice1cost_pixels_first_0_0_count_0 +
        slice1cost_pixels_first_0_0_count_1 + slice1cost_pixels_first_0_0_count_4 + slice1cost_pixels_first_0_0_count_2;
      slice1cost_pixels_cost_0_1 <= slice1cost_pixels_first_0_1_count_3 + slice1cost_pixels_first_0_1_count_0 +
        slice1cost_pixels_first_0_1_count_1 + slice1cost_pixels_first_0_1_count_4 + slice1cost_pixels_first_0_1_count_2;
      slice1cost_pixels_cost_0_2 <= slice1cost_pixels_first_0_2_count_3 + slice1cost_pixels_first_0_2_count_0 +
        slice1cost_pixels_first_0_2_count_1 + slice1cost_pixels_first_0_2_count_4 + slice1cost_pixels_first_0_2_count_2;
      slice1cost_pixels_cost_0_3 <= slice1cost_pixels_first_0_3_count_3 + slice1cost_pixels_first_0_3_count_0 +
        slice1cost_pixels_first_0_3_count_1 + slice1cost_pixels_first_0_3_count_4 + slice1cost_pixels_first_0_3_count_2;
      slice1cost_pixels_cost_0_4 <= slice1cost_pixels_first_0_4_count_3 + slice1cost_pixels_first_0_4_count_0 +
        slice1cost_pixels_first_0_4_count_1 + slice1cost_pixels_first_0_4_count_4 + slice1cost_pixels_first_0_4_count_2;
      slice1cost_pixels_cost_1_0 <= slice1cost_pixels_first_1_0_count_3 + slice1cost_pixels_first_1_0_count_0 +
        slice1cost_pixels_first_1_0_count_1 + slice1cost_pixels_first_1_0_count_4 + slice1cost_pixels_first_1_0_count_2;
      slice1cost_pixels_cost_1_1 <= slice1cost_pixels_first_1_1_count_3 + slice1cost_pixels_first_1_1_count_0 +
        slice1cost_pixels_first_1_1_count_1 + slice1cost_pixels_first_1_1_count_4 + slice1cost_pixels_first_1_1_count_2;
      slice1cost_pixels_cost_1_2 <= slice1cost_pixels_first_1_2_count_3 + slice1cost_pixels_first_1_2_count_0 +
        slice1cost_pixels_first_1_2_count_1 + slice1cost_pixels_first_1_2_count_4 + slice1cost_pixels_first_1_2_count_2;
      slice1cost_pixels_cost_1_3 <= slice1cost_pixels_first_1_3_count_3 + slice1cost_pixels_first_1_3_count_0 +
        slice1cost_pixels_first_1_3_count_1 + slice1cost_pixels_first_1_3_count_4 + slice1cost_pixels_first_1_3_count_2;
      slice1cost_pixels_cost_1_4 <= slice1cost_pixels_first_1_4_count_3 + slice1cost_pixels_first_1_4_count_0 +
        slice1cost_pixels_first_1_4_count_1 + slice1cost_pixels_first_1_4_count_4 + slice1cost_pixels_first_1_4_count_2;
      slice1cost_pixels_cost_2_0 <= slice1cost_pixels_first_2_0_count_3 + slice1cost_pixels_first_2_0_count_0 +
        slice1cost_pixels_first_2_0_count_1 + slice1cost_pixels_first_2_0_count_4 + slice1cost_pixels_first_2_0_count_2;
      slice1cost_pixels_cost_2_1 <= slice1cost_pixels_first_2_1_count_3 + slice1cost_pixels_first_2_1_count_0 +
        slice1cost_pixels_first_2_1_count_1 + slice1cost_pixels_first_2_1_count_4 + slice1cost_pixels_first_2_1_count_2;
      slice1cost_pixels_cost_2_2 <= slice1cost_pixels_first_2_2_count_3 + slice1cost_pixels_first_2_2_count_0 +
        slice1cost_pixels_first_2_2_count_1 + slice1cost_pixels_first_2_2_count_4 + slice1cost_pixels_first_2_2_count_2;
      slice1cost_pixels_cost_2_3 <= slice1cost_pixels_first_2_3_count_3 + slice1cost_pixels_first_2_3_count_0 +
        slice1cost_pixels_first_2_3_count_1 + slice1cost_pixels_first_2_3_count_4 + slice1cost_pixels_first_2_3_count_2;
      slice1cost_pixels_cost_2_4 <= slice1cost_pixels_first_2_4_count_3 + slice1cost_pixels_first_2_4_count_0 +
        slice1cost_pixels_first_2_4_count_1 + slice1cost_pixels_first_2_4_count_4 + slice1cost_pixels_first_2_4_count_2;
      slice1cost_pair_0_0 <= slice1cost_pixels_cost_1_0 + slice1cost_pixels_cost_2_0;
      slice1cost_pair_0_1 <= slice1cost_pixels_cost_1_1 + slice1cost_pixels_cost_2_1;
      slice1cost_pair_0_2 <= slice1cost_pixels_cost_1_2 + slice1cost_pixels_cost_2_2;
      slice1cost_pair_0_3 <= slice1cost_pixels_cost_1_3 + slice1cost_pixels_cost_2_3;
      slice1cost_pair_0_4 <= slice1cost_pixels_cost_1_4 + slice1cost_pixels_cost_2_4;
      slice1cost_single_0_0 <= slice1cost_pixels_cost_0_0;
      slice1cost_single_0_1 <= slice1cost_pixels_cost_0_1;
      slice1cost_single_0_2 <= slice1cost_pixels_cost_0_2;
      slice1cost_single_0_3 <= slice1cost_pixels_cost_0_3;
      slice1cost_single_0_4 <= slice1cost_pixels_cost_0_4;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_0_3 <= 0;
        slice1cost_column_0_4 <= 0;
      else
        slice1cost_column_0_0 <= slice1cost_pair_0_0 + slice1cost_single_0_0;
        slice1cost_column_0_1 <= slice1cost_pair_0_1 + slice1cost_single_0_1;
        slice1cost_column_0_2 <= slice1cost_pair_0_2 + slice1cost_single_0_2;
        slice1cost_column_0_3 <= slice1cost_pair_0_3 + slice1cost_single_0_3;
        slice1cost_column_0_4 <= slice1cost_pair_0_4 + slice1cost_single_0_4;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_0_3 <= slice1cost_column_0_3;
        slice1window_partial_0_0_4 <= slice1cost_column_0_4;
        slice1window_partial_0_1_0 <= slice1cost_column_0_0 + slice1window_partial_0_0_0;
        slice1window_partial_0_1_1 <= slice1cost_column_0_1 + slice1window_partial_0_0_1;
        slice1window_partial_0_1_2 <= slice1cost_column_0_2 + slice1window_partial_0_0_2;
        slice1window_partial_0_1_3 <= slice1cost_column_0_3 + slice1window_partial_0_0_3;
        slice1window_partial_0_1_4 <= slice1cost_column_0_4 + slice1window_partial_0_0_4;
      end if;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      slice1window_sum_0_3 <= slice1cost_column_0_3 + slice1window_partial_0_1_3;
      slice1window_sum_0_4 <= slice1cost_column_0_4 + slice1window_partial_0_1_4;
      -- slice1
      slice1_held_1_0 <= slice1_held_0_0;
      slice1_held_1_1 <= slice1_held_0_1;
      slice1_held_1_2 <= slice1_held_0_2;
      slice1_held_1_3 <= slice1_held_0_3;
      slice1_held_1_4 <= slice1_held_0_4;
      if ((slice1window_sum_0_0 / 64) = 1) or (((slice1window_sum_0_0 / 16) mod 4) = 3) then
        slice1_held_0_0 <= 5;
      else
        slice1_held_0_0 <= slice1window_sum_0_0 / 8;
      end if;
      if ((slice1window_sum_0_1 / 64) = 1) or (((slice1window_sum_0_1 / 16) mod 4) = 3) then
        slice1_held_0_1 <= 5;
      else
        slice1_held_0_1 <= slice1window_sum_0_1 / 8;
      end if;
      if ((slice1window_sum_0_2 / 64) = 1) or (((slice1window_sum_0_2 / 16) mod 4) = 3) then
        slice1_held_0_2 <= 5;
      else
        slice1_held_0_2 <= slice1window_sum_0_2 / 8;
      end if;
      if ((slice1window_sum_0_3 / 64) = 1) or (((slice1window_sum_0_3 / 16) mod 4) = 3) then
        slice1_held_0_3 <= 5;
      else
        slice1_held_0_3 <= slice1window_sum_0_3 / 8;
      end if;
      if ((slice1window_sum_0_4 / 64) = 1) or (((slice1window_sum_0_4 / 16) mod 4) = 3) then
        slice1_held_0_4 <= 5;
      else
        slice1_held_0_4 <= slice1window_sum_0_4 / 8;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice1shift_search_out_0;
        slice2shift_search_1_0 <= slice2shift_search_1_1;
        slice2shift_search_1_1 <= slice1shift_search_out_1;
        slice2shift_search_2_0 <= slice2shift_search_2_1;
        slice2shift_search_2_1 <= slice1shift_search_out_2;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      -- slice2cost
      slice2cost_pixels_first_0_0_count_0_value := ((slice2shift_reference_0 / 4) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_0_value_2 := ((slice2shift_reference_0 / 2) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_1_value := ((slice2shift_reference_0 / 8) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_1_value_2 := ((slice2shift_reference_0 / 32) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_1_value_3 := ((slice2shift_reference_0 / 16) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_2_value := ((slice2shift_reference_0 / 256) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_2_value_2 := ((slice2shift_reference_0 / 64) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_3_value := ((slice2shift_reference_0 / 512) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_3_value_2 := ((slice2shift_reference_0 / 2048) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_3_value_3 := ((slice2shift_reference_0 / 1024) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_4_value := ((slice2shift_reference_0 / 4096) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_0_value := ((slice2shift_reference_1 / 4) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_0_value_2 := ((slice2shift_reference_1 / 2) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_1_value := ((slice2shift_reference_1 / 8) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_1_value_2 := ((slice2shift_reference_1 / 32) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_1_value_3 := ((slice2shift_reference_1 / 16) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_2_value := ((slice2shift_reference_1 / 256) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_2_value_2 := ((slice2shift_reference_1 / 64) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_3_value := ((slice2shift_reference_1 / 512) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_3_value_2 := ((slice2shift_reference_1 / 2048) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_3_value_3 := ((slice2shift_reference_1 / 1024) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_4_value := ((slice2shift_reference_1 / 4096) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_0_value := ((slice2shift_reference_2 / 4) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_0_value_2 := ((slice2shift_reference_2 / 2) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_1_value := ((slice2shift_reference_2 / 8) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_1_value_2 := ((slice2shift_reference_2 / 32) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_1_value_3 := ((slice2shift_reference_2 / 16) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_2_value := ((slice2shift_reference_2 / 256) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_2_value_2 := ((slice2shift_reference_2 / 64) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_3_value := ((slice2shift_reference_2 / 512) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_3_value_2 := ((slice2shift_reference_2 / 2048) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_3_value_3 := ((slice2shift_reference_2 / 1024) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_4_value := ((slice2shift_reference_2 / 4096) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_0 <= as_number((((slice2shift_search_0_0 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_0_value /=
        (((slice2shift_search_0_0 / 4) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_0_value_2 /=
        (((slice2shift_search_0_0 / 2) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_1 <= as_number((slice2cost_pixels_first_0_0_count_1_value /=
        (((slice2shift_search_0_0 / 8) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_1_value_2 /=
        (((slice2shift_search_0_0 / 32) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_1_value_3 /=
        (((slice2shift_search_0_0 / 16) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_0 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice2cost_pixels_first_0_0_count_2_value /= (((slice2shift_search_0_0 / 256) mod 2) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_2_value_2 /= (((slice2shift_search_0_0 / 64) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_3 <= as_number((slice2cost_pixels_first_0_0_count_3_value /=
        (((slice2shift_search_0_0 / 512) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_3_value_2 /=
        (((slice2shift_search_0_0 / 2048) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_3_value_3 /=
        (((slice2shift_search_0_0 / 1024) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_4 <= as_number((((slice2shift_reference_0 / 8192) = 1) /=
        ((slice2shift_search_0_0 / 8192) = 1))) + as_number((slice2cost_pixels_first_0_0_count_4_value /=
        (((slice2shift_search_0_0 / 4096) mod 2) = 1)));
      slice2cost_pixels_first_0_1_count_0 <= as_number((((slice2shift_search_0_1 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_1 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_1 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_1_count_1 <= as_number(((((slice2shift_search_0_1 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_1 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_1 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_1 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_1 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_1 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_1_count_3 <= as_number(((((slice2shift_search_0_1 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_1 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_1 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_1_count_4 <= as_number((((slice2shift_search_0_1 / 8192) = 1) /=
        ((slice2shift_reference_0 / 8192) = 1))) + as_number(((((slice2shift_search_0_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value));
      slice2cost_pixels_first_1_0_count_0 <= as_number((((slice2shift_search_1_0 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_0_value /=
        (((slice2shift_search_1_0 / 4) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_0_value_2 /=
        (((slice2shift_search_1_0 / 2) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_1 <= as_number((slice2cost_pixels_first_1_0_count_1_value /=
        (((slice2shift_search_1_0 / 8) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_1_value_2 /=
        (((slice2shift_search_1_0 / 32) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_1_value_3 /=
        (((slice2shift_search_1_0 / 16) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_0 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) +
        as_number((slice2cost_pixels_first_1_0_count_2_value /= (((slice2shift_search_1_0 / 256) mod 2) = 1))) +
        as_number((slice2cost_pixels_first_1_0_count_2_value_2 /= (((slice2shift_search_1_0 / 64) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_3 <= as_number((slice2cost_pixels_first_1_0_count_3_value /=
        (((slice2shift_search_1_0 / 512) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_3_value_2 /=
        (((slice2shift_search_1_0 / 2048) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_3_value_3 /=
        (((slice2shift_search_1_0 / 1024) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_4 <= as_number((((slice2shift_reference_1 / 8192) = 1) /=
        ((slice2shift_search_1_0 / 8192) = 1))) + as_number((slice2cost_pixels_first_1_0_count_4_value /=
        (((slice2shift_search_1_0 / 4096) mod 2) = 1)));
      slice2cost_pixels_first_1_1_count_0 <= as_number((((slice2shift_search_1_1 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_1 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_1 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_1_count_1 <= as_number(((((slice2shift_search_1_1 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_1 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_1 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_1_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_1 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_1 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_1 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_1_count_3 <= as_number(((((slice2shift_search_1_1 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_1 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_1 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_1_count_4 <= as_number((((slice2shift_search_1_1 / 8192) = 1) /=
        ((slice2shift_reference_1 / 8192) = 1))) + as_number(((((slice2shift_search_1_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value));
      slice2cost_pixels_first_2_0_count_0 <= as_number((((slice2shift_search_2_0 mod 2) = 1) /=
        ((slice2shift_reference_2 mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_0_value /=
        (((slice2shift_search_2_0 / 4) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_0_value_2 /=
        (((slice2shift_search_2_0 / 2) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_1 <= as_number((slice2cost_pixels_first_2_0_count_1_value /=
        (((slice2shift_search_2_0 / 8) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_1_value_2 /=
        (((slice2shift_search_2_0 / 32) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_1_value_3 /=
        (((slice2shift_search_2_0 / 16) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_2 <= (to_integer(((to_unsigned((slice2shift_search_2_0 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_2 mod 256), 8)))) / 128) +
        as_number((slice2cost_pixels_first_2_0_count_2_value /= (((slice2shift_search_2_0 / 256) mod 2) = 1))) +
        as_number((slice2cost_pixels_first_2_0_count_2_value_2 /= (((slice2shift_search_2_0 / 64) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_3 <= as_number((slice2cost_pixels_first_2_0_count_3_value /=
        (((slice2shift_search_2_0 / 512) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_3_value_2 /=
        (((slice2shift_search_2_0 / 2048) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_3_value_3 /=
        (((slice2shift_search_2_0 / 1024) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_4 <= as_number((((slice2shift_reference_2 / 8192) = 1) /=
        ((slice2shift_search_2_0 / 8192) = 1))) + as_number((slice2cost_pixels_first_2_0_count_4_value /=
        (((slice2shift_search_2_0 / 4096) mod 2) = 1)));
      slice2cost_pixels_first_2_1_count_0 <= as_number((((slice2shift_search_2_1 mod 2) = 1) /=
        ((slice2shift_reference_2 mod 2) = 1))) + as_number(((((slice2shift_search_2_1 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_0_value)) + as_number(((((slice2shift_search_2_1 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_0_value_2));
      slice2cost_pixels_first_2_1_count_1 <= as_number(((((slice2shift_search_2_1 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_1_value)) + as_number(((((slice2shift_search_2_1 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_1_value_2)) + as_number(((((slice2shift_search_2_1 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_1_value_3));
      slice2cost_pixels_first_2_1_count_2 <= (to_integer(((to_unsigned((slice2shift_search_2_1 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_2 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_2_1 / 256) mod
        2) = 1) /= slice2cost_pixels_first_2_0_count_2_value)) + as_number(((((slice2shift_search_2_1 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_2_0_count_2_value_2));
      slice2cost_pixels_first_2_1_count_3 <= as_number(((((slice2shift_search_2_1 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_3_value)) + as_number(((((slice2shift_search_2_1 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_3_value_2)) + as_number(((((slice2shift_search_2_1 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_3_value_3));
      slice2cost_pixels_first_2_1_count_4 <= as_number((((slice2shift_search_2_1 / 8192) = 1) /=
        ((slice2shift_reference_2 / 8192) = 1))) + as_number(((((slice2shift_search_2_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_4_value));
      slice2cost_pixels_cost_0_0 <= slice2cost_pixels_first_0_0_count_3 + slice2cost_pixels_first_0_0_count_0 +
        slice2cost_pixels_first_0_0_count_1 + slice2cost_pixels_first_0_0_count_4 + slice2cost_pixels_first_0_0_count_2;
      slice2cost_pixels_cost_0_1 <= slice2cost_pixels_first_0_1_count_3 + slice2cost_pixels_first_0_1_count_0 +
        slice2cost_pixels_first_0_1_count_1 + slice2cost_pixels_first_0_1_count_4 + slice2cost_pixels_first_0_1_count_2;
      slice2cost_pixels_cost_1_0 <= slice2cost_pixels_first_1_0_count_3 + slice2cost_pixels_first_1_0_count_0 +
        slice2cost_pixels_first_1_0_count_1 + slice2cost_pixels_first_1_0_count_4 + slice2cost_pixels_first_1_0_count_2;
      slice2cost_pixels_cost_1_1 <= slice2cost_pixels_first_1_1_count_3 + slice2cost_pixels_first_1_1_count_0 +
        slice2cost_pixels_first_1_1_count_1 + slice2cost_pixels_first_1_1_count_4 + slice2cost_pixels_first_1_1_count_2;
      slice2cost_pixels_cost_2_0 <= slice2cost_pixels_first_2_0_count_3 + slice2cost_pixels_first_2_0_count_0 +
        slice2cost_pixels_first_2_0_count_1 + slice2cost_pixels_first_2_0_count_4 + slice2cost_pixels_first_2_0_count_2;
      slice2cost_pixels_cost_2_1 <= slice2cost_pixels_first_2_1_count_3 + slice2cost_pixels_first_2_1_count_0 +
        slice2cost_pixels_first_2_1_count_1 + slice2cost_pixels_first_2_1_count_4 + slice2cost_pixels_first_2_1_count_2;
      slice2cost_pair_0_0 <= slice2cost_pixels_cost_1_0 + slice2cost_pixels_cost_2_0;
      slice2cost_pair_0_1 <= slice2cost_pixels_cost_1_1 + slice2cost_pixels_cost_2_1;
      slice2cost_single_0_0 <= slice2cost_pixels_cost_0_0;
      slice2cost_single_0_1 <= slice2cost_pixels_cost_0_1;
      if slice1cost_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
      else
        slice2cost_column_0_0 <= slice2cost_pair_0_0 + slice2cost_single_0_0;
        slice2cost_column_0_1 <= slice2cost_pair_0_1 + slice2cost_single_0_1;
      end if;
      -- slice2window
      if slice0_tag_0_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      -- slice2
      if ((slice2window_sum_0_0 / 64) = 1) or (((slice2window_sum_0_0 / 16) mod 4) = 3) then
        slice2_held_0_0 <= 5;
      else
        slice2_held_0_0 <= slice2window_sum_0_0 / 8;
      end if;
      if ((slice2window_sum_0_1 / 64) = 1) or (((slice2window_sum_0_1 / 16) mod 4) = 3) then
        slice2_held_0_1 <= 5;
      else
        slice2_held_0_1 <= slice2window_sum_0_1 / 8;
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
      entry_next_cost_0 <= slice2_held_0_0;
      entry_next_cost_1 <= slice2_held_0_1;
      entry_next_cost_2 <= slice1_held_1_0;
      entry_next_cost_3 <= slice1_held_1_1;
      entry_next_cost_4 <= slice1_held_1_2;
      entry_next_cost_5 <= slice1_held_1_3;
      entry_next_cost_6 <= slice1_held_1_4;
      entry_next_cost_7 <= slice0_held_2_0;
      entry_next_cost_8 <= slice0_held_2_1;
      entry_next_cost_9 <= slice0_held_2_2;
      entry_next_cost_10 <= slice0_held_2_3;
      entry_next_cost_11 <= slice0_held_2_4;
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
          entry_next_column <= (entry_next_column + 1) mod 32;
          entry_next_top <= entry_next_top;
        end if;
      end if;
      if entry_order_falls then
        entry_order_address_choice := 31;
      else
        entry_order_address_choice := 1;
      end if;
      if entry_order_falls then
        entry_order_address_choice_2 := 0;
      else
        entry_order_address_choice_2 := 7;
      end if;
      if not entry_order_complete_any then
        if entry_order_falls_any then
          entry_order_address <= (entry_order_address_choice + entry_order_address) mod 32;
        else
          entry_order_address <= entry_order_address_choice_2 * 4;
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
      forward_left_start_cost_0_any := ((((forward_left_tree_next_next_smallest_0 mod 64) + forward_left_relief_beyond)
        / 64) = 1) or ((forward_left_tree_next_next_smallest_0 / 64) = 1);
      if (forward_left_relief_largest mod 2) = 1 then
        forward_left_start_cost_0_choice := (not (((forward_left_room / 2) mod 2) = 1)) or (not ((forward_left_room mod
          2) = 1));
      else
        forward_left_start_cost_0_choice := not (((forward_left_room / 2) mod 2) = 1);
      end if;
      if ((forward_left_relief_largest / 2) mod 2) = 1 then
        forward_left_start_cost_0_choice_2 := forward_left_start_cost_0_choice;
      else
        forward_left_start_cost_0_choice_2 := ((forward_left_relief_largest mod 2) = 1) and ((forward_left_room mod 4)
          = 0);
      end if;
      forward_left_start_cost_0_value := ((forward_left_room / 4) mod 2) = 1;
      if forward_left_start_cost_0_choice_2 then
        forward_left_start_cost_0_choice_3 := (not (((forward_left_relief_largest / 4) mod 2) = 1)) and
          forward_left_start_cost_0_value;
      else
        forward_left_start_cost_0_choice_3 := (not (((forward_left_relief_largest / 4) mod 2) = 1)) or
          forward_left_start_cost_0_value;
      end if;
      forward_left_start_cost_0_value_2 := ((forward_left_room / 8) mod 2) = 1;
      if forward_left_start_cost_0_choice_3 then
        forward_left_start_cost_0_choice_4 := (not (((forward_left_relief_largest / 8) mod 2) = 1)) or
          forward_left_start_cost_0_value_2;
      else
        forward_left_start_cost_0_choice_4 := (not (((forward_left_relief_largest / 8) mod 2) = 1)) and
          forward_left_start_cost_0_value_2;
      end if;
      forward_left_start_cost_0_value_3 := ((forward_left_room / 16) mod 2) = 1;
      if forward_left_start_cost_0_choice_4 then
        forward_left_start_cost_0_choice_5 := (not (((forward_left_relief_largest / 16) mod 2) = 1)) or
          forward_left_start_cost_0_value_3;
      else
        forward_left_start_cost_0_choice_5 := (not (((forward_left_relief_largest / 16) mod 2) = 1)) and
          forward_left_start_cost_0_value_3;
      end if;
      if forward_left_start_cost_0_choice_5 then
        forward_left_start_cost_0_choice_6 := ((forward_left_relief_largest / 32) = 1) and (not ((forward_left_room /
          32) = 1));
      else
        forward_left_start_cost_0_choice_6 := ((forward_left_relief_largest / 32) = 1) or (not ((forward_left_room /
          32) = 1));
      end if;
      if forward_left_start_cost_0_choice_6 then
        forward_left_start_cost_0_choice_7 := 0;
      else
        forward_left_start_cost_0_choice_7 := (forward_left_room - forward_left_relief_largest) mod 64;
      end if;
      forward_left_start_cost_0_is_less := 127 < ((forward_left_tree_next_next_smallest_0 mod 64) +
        forward_left_relief_reach_of_best);
      if forward_left_start_cost_0_is_less then
        forward_left_start_cost_0_choice_8 := (forward_left_tree_next_next_smallest_0 +
          forward_left_relief_reach_of_best) mod 64;
      else
        forward_left_start_cost_0_choice_8 := 0;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_start_cost_0_choice_9 := forward_left_start_cost_0_choice_7;
      else
        forward_left_start_cost_0_choice_9 := forward_left_start_cost_0_choice_8;
      end if;
      forward_left_room_value := (forward_left_start_cost_6 + forward_left_room) mod 64;
      if forward_left_start_cost_0_choice_6 then
        forward_left_room_choice := forward_left_room_value;
      else
        forward_left_room_choice := (forward_left_start_cost_6 + forward_left_relief_largest) mod 64;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_room_choice_2 := (forward_left_relief_room_of_best - forward_left_tree_next_next_smallest_0) mod
          64;
      else
        forward_left_room_choice_2 := forward_left_room_value;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_room_choice_3 := forward_left_room_choice;
      else
        forward_left_room_choice_3 := forward_left_room_choice_2;
      end if;
      if sums_right_first_2 then
        forward_left_smallest_choice := 0;
      else
        forward_left_smallest_choice := forward_reliefs_moved_3;
      end if;
      forward_left_smallest_difference := (forward_smallest_next_next_next_smallest_0 + forward_left_smallest_choice) -
        forward_reliefs_moved_2;
      if (forward_left_smallest_choice - forward_left_relief_past_0) < 0 then
        forward_left_relief_pairs_0_choice := forward_left_relief_past_0;
      else
        forward_left_relief_pairs_0_choice := forward_left_smallest_choice;
      end if;
      if (forward_reliefs_moved_2 - forward_left_smallest_choice) < 0 then
        forward_left_relief_recent_choice := forward_left_smallest_choice;
      else
        forward_left_relief_recent_choice := forward_reliefs_moved_2;
      end if;
      if (forward_reliefs_moved_2 - forward_left_relief_recent) < 0 then
        forward_left_relief_largest_choice := forward_left_relief_recent;
      else
        forward_left_relief_largest_choice := forward_reliefs_moved_2;
      end if;
      forward_left_relief_reach_of_best_sum := forward_left_room + forward_left_relief_leaves;
      if forward_left_start_cost_0_choice_6 then
        forward_left_relief_reach_of_best_choice := forward_left_relief_reach_of_best_sum;
      else
        forward_left_relief_reach_of_best_choice := forward_left_relief_largest + forward_left_relief_leaves;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_relief_reach_of_best_choice_2 := (forward_left_relief_reach_again -
          (forward_left_tree_next_next_smallest_0 mod 64)) mod 256;
      else
        forward_left_relief_reach_of_best_choice_2 := forward_left_relief_reach_of_best_sum;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_relief_reach_of_best_choice_3 := forward_left_relief_reach_of_best_choice;
      else
        forward_left_relief_reach_of_best_choice_3 := forward_left_relief_reach_of_best_choice_2;
      end if;
      if sums_right_first_2 then
        forward_left_relief_leaves_choice := 64;
      else
        forward_left_relief_leaves_choice := forward_left_start_cost_5 + 64;
      end if;
      if (forward_left_arrived_0 - forward_left_cost_0) < 0 then
        forward_left_cost_0_choice := forward_left_arrived_0;
      else
        forward_left_cost_0_choice := forward_left_cost_0;
      end if;
      if ((forward_left_cost_0_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_0_choice_2 := 64;
      else
        forward_left_cost_0_choice_2 := forward_left_cost_0_choice;
      end if;
      if (forward_left_arrived_1 - forward_left_cost_1) < 0 then
        forward_left_cost_1_choice := forward_left_arrived_1;
      else
        forward_left_cost_1_choice := forward_left_cost_1;
      end if;
      if ((forward_left_cost_1_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_1_choice_2 := 64;
      else
        forward_left_cost_1_choice_2 := forward_left_cost_1_choice;
      end if;
      if (forward_left_arrived_2 - forward_left_cost_2) < 0 then
        forward_left_cost_2_choice := forward_left_arrived_2;
      else
        forward_left_cost_2_choice := forward_left_cost_2;
      end if;
      if ((forward_left_cost_2_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_2_choice_2 := 64;
      else
        forward_left_cost_2_choice_2 := forward_left_cost_2_choice;
      end if;
      if (forward_left_arrived_3 - forward_left_cost_3) < 0 then
        forward_left_cost_3_choice := forward_left_arrived_3;
      else
        forward_left_cost_3_choice := forward_left_cost_3;
      end if;
      if ((forward_left_cost_3_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_3_choice_2 := 64;
      else
        forward_left_cost_3_choice_2 := forward_left_cost_3_choice;
      end if;
      if (forward_left_arrived_4 - forward_left_cost_4) < 0 then
        forward_left_cost_4_choice := forward_left_arrived_4;
      else
        forward_left_cost_4_choice := forward_left_cost_4;
      end if;
      if ((forward_left_cost_4_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_4_choice_2 := 64;
      else
        forward_left_cost_4_choice_2 := forward_left_cost_4_choice;
      end if;
      if (forward_left_arrived_5 - forward_left_cost_5) < 0 then
        forward_left_cost_5_choice := forward_left_arrived_5;
      else
        forward_left_cost_5_choice := forward_left_cost_5;
      end if;
      if ((forward_left_cost_5_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_5_choice_2 := 64;
      else
        forward_left_cost_5_choice_2 := forward_left_cost_5_choice;
      end if;
      if (forward_left_arrived_6 - forward_left_cost_6) < 0 then
        forward_left_cost_6_choice := forward_left_arrived_6;
      else
        forward_left_cost_6_choice := forward_left_cost_6;
      end if;
      if ((forward_left_cost_6_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_6_choice_2 := 64;
      else
        forward_left_cost_6_choice_2 := forward_left_cost_6_choice;
      end if;
      if (forward_left_arrived_7 - forward_left_cost_7) < 0 then
        forward_left_cost_7_choice := forward_left_arrived_7;
      else
        forward_left_cost_7_choice := forward_left_cost_7;
      end if;
      if ((forward_left_cost_7_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_7_choice_2 := 64;
      else
        forward_left_cost_7_choice_2 := forward_left_cost_7_choice;
      end if;
      if (forward_left_arrived_8 - forward_left_cost_8) < 0 then
        forward_left_cost_8_choice := forward_left_arrived_8;
      else
        forward_left_cost_8_choice := forward_left_cost_8;
      end if;
      if ((forward_left_cost_8_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_8_choice_2 := 64;
      else
        forward_left_cost_8_choice_2 := forward_left_cost_8_choice;
      end if;
      if (forward_left_arrived_9 - forward_left_cost_9) < 0 then
        forward_left_cost_9_choice := forward_left_arrived_9;
      else
        forward_left_cost_9_choice := forward_left_cost_9;
      end if;
      if ((forward_left_cost_9_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_9_choice_2 := 64;
      else
        forward_left_cost_9_choice_2 := forward_left_cost_9_choice;
      end if;
      if (forward_left_arrived_10 - forward_left_cost_10) < 0 then
        forward_left_cost_10_choice := forward_left_arrived_10;
      else
        forward_left_cost_10_choice := forward_left_cost_10;
      end if;
      if ((forward_left_cost_10_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_10_choice_2 := 64;
      else
        forward_left_cost_10_choice_2 := forward_left_cost_10_choice;
      end if;
      if (forward_left_arrived_11 - forward_left_cost_11) < 0 then
        forward_left_cost_11_choice := forward_left_arrived_11;
      else
        forward_left_cost_11_choice := forward_left_cost_11;
      end if;
      if ((forward_left_cost_11_choice / 64) = 1) or forward_left_first_2 then
        forward_left_cost_11_choice_2 := 64;
      else
        forward_left_cost_11_choice_2 := forward_left_cost_11_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_0_choice := 64;
      else
        forward_left_arrived_0_choice := forward_left_cost_1;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_1_choice := 64;
      else
        forward_left_arrived_1_choice := forward_left_pair_0_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_2_choice := 64;
      else
        forward_left_arrived_2_choice := forward_left_pair_1_choice;
      end if;
      if (forward_left_cost_4 - forward_left_cost_2) < 0 then
        forward_left_arrived_3_choice := forward_left_cost_4;
      else
        forward_left_arrived_3_choice := forward_left_cost_2;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_3_choice_2 := 64;
      else
        forward_left_arrived_3_choice_2 := forward_left_arrived_3_choice;
      end if;
      if (forward_left_cost_5 - forward_left_cost_3) < 0 then
        forward_left_arrived_4_choice := forward_left_cost_5;
      else
        forward_left_arrived_4_choice := forward_left_cost_3;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_4_choice_2 := 64;
      else
        forward_left_arrived_4_choice_2 := forward_left_arrived_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_5_choice := 64;
      else
        forward_left_arrived_5_choice := forward_left_pair_2_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_6_choice := 64;
      else
        forward_left_arrived_6_choice := forward_left_pair_3_choice;
      end if;
      if (forward_left_cost_8 - forward_left_cost_6) < 0 then
        forward_left_arrived_7_choice := forward_left_cost_8;
      else
        forward_left_arrived_7_choice := forward_left_cost_6;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_7_choice_2 := 64;
      else
        forward_left_arrived_7_choice_2 := forward_left_arrived_7_choice;
      end if;
      if (forward_left_cost_9 - forward_left_cost_7) < 0 then
        forward_left_arrived_8_choice := forward_left_cost_9;
      else
        forward_left_arrived_8_choice := forward_left_cost_7;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_8_choice_2 := 64;
      else
        forward_left_arrived_8_choice_2 := forward_left_arrived_8_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_9_choice := 64;
      else
        forward_left_arrived_9_choice := forward_left_pair_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_10_choice := 64;
      else
        forward_left_arrived_10_choice := forward_left_pair_5_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_11_choice := 64;
      else
        forward_left_arrived_11_choice := forward_left_cost_10;
      end if;
      if forward_above_ready_top then
        forward_above_total_0_choice := 31;
      else
        forward_above_total_0_choice := to_integer(forward_above_ready_words_0(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_1_choice := 31;
      else
        forward_above_total_1_choice := to_integer(forward_above_ready_words_0(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_2_choice := 31;
      else
        forward_above_total_2_choice := to_integer(forward_above_ready_words_0(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_3_choice := 31;
      else
        forward_above_total_3_choice := to_integer(forward_above_ready_words_0(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_4_choice := 31;
      else
        forward_above_total_4_choice := to_integer(forward_above_ready_words_0(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_5_choice := 31;
      else
        forward_above_total_5_choice := to_integer(forward_above_ready_words_0(29 downto 25));
      end if;
      if forward_above_ready_top then
        forward_above_total_6_choice := 31;
      else
        forward_above_total_6_choice := to_integer(forward_above_ready_words_1(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_7_choice := 31;
      else
        forward_above_total_7_choice := to_integer(forward_above_ready_words_1(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_8_choice := 31;
      else
        forward_above_total_8_choice := to_integer(forward_above_ready_words_1(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_9_choice := 31;
      else
        forward_above_total_9_choice := to_integer(forward_above_ready_words_1(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_10_choice := 31;
      else
        forward_above_total_10_choice := to_integer(forward_above_ready_words_1(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_11_choice := 31;
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
        forward_left_smallest <= forward_left_smallest_difference mod 128;
        forward_left_smallest_less <= (forward_left_smallest_difference + 121) mod 128;
        forward_left_first_0 <= sums_right_first_2;
        forward_left_first_1 <= forward_left_first_0;
        forward_left_first_2 <= forward_left_first_1;
        forward_left_relief_next_0 <= forward_reliefs_moved_2;
        forward_left_relief_past_0 <= forward_left_smallest_choice;
        forward_left_relief_past_1 <= forward_left_relief_past_0;
        forward_left_relief_past_2 <= forward_left_relief_past_1;
        forward_left_relief_past_3 <= forward_left_relief_past_2;
        forward_left_relief_past_4 <= forward_left_relief_past_3;
        forward_left_relief_past_5 <= forward_left_relief_past_4;
        forward_left_relief_pairs_0 <= forward_left_relief_pairs_0_choice;
        forward_left_relief_pairs_1 <= forward_left_relief_pairs_0;
        forward_left_relief_largest <= forward_left_relief_largest_choice;
        forward_left_relief_beyond <= (forward_left_relief_largest_choice - forward_left_relief_past_5) mod 64;
        forward_left_relief_leaves <= forward_left_relief_leaves_choice - forward_left_relief_past_4;
        forward_left_relief_room_of_best <= forward_left_relief_past_5 + forward_left_relief_leaves_choice;
        forward_left_relief_reach_again <= (64 - forward_left_relief_past_4) + forward_left_relief_past_5 +
          forward_left_relief_leaves_choice;
        forward_left_g_copy_0 <= (forward_left_start_cost_0 + forward_left_smallest) mod 128;
        forward_left_g_less_copy_0 <= (forward_left_start_cost_0 + forward_left_smallest_less) mod 128;
        forward_left_stay_change_0 <= (forward_cost_0_0 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_1 <= (forward_cost_0_1 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_2 <= (forward_cost_0_2 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_3 <= (forward_cost_0_3 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_4 <= (forward_cost_0_4 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_5 <= (forward_cost_0_5 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_6 <= (forward_cost_0_6 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_7 <= (forward_cost_0_7 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_8 <= (forward_cost_0_8 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_9 <= (forward_cost_0_9 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_10 <= (forward_cost_0_10 - forward_left_g_copy_0) mod 128;
        forward_left_stay_change_11 <= (forward_cost_0_11 - forward_left_g_copy_0) mod 128;
        forward_left_step_change_0 <= (forward_cost_0_0 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_1 <= (forward_cost_0_1 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_2 <= (forward_cost_0_2 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_3 <= (forward_cost_0_3 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_4 <= (forward_cost_0_4 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_5 <= (forward_cost_0_5 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_6 <= (forward_cost_0_6 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_7 <= (forward_cost_0_7 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_8 <= (forward_cost_0_8 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_9 <= (forward_cost_0_9 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_10 <= (forward_cost_0_10 - forward_left_g_less_copy_0) mod 128;
        forward_left_step_change_11 <= (forward_cost_0_11 - forward_left_g_less_copy_0) mod 128;
        forward_left_cost_0 <= (forward_left_cost_0_choice_2 + forward_left_stay_change_0) mod 128;
        forward_left_cost_1 <= (forward_left_cost_1_choice_2 + forward_left_stay_change_1) mod 128;
        forward_left_cost_2 <= (forward_left_cost_2_choice_2 + forward_left_stay_change_2) mod 128;
        forward_left_cost_3 <= (forward_left_cost_3_choice_2 + forward_left_stay_change_3) mod 128;
        forward_left_cost_4 <= (forward_left_cost_4_choice_2 + forward_left_stay_change_4) mod 128;
        forward_left_cost_5 <= (forward_left_cost_5_choice_2 + forward_left_stay_change_5) mod 128;
        forward_left_cost_6 <= (forward_left_cost_6_choice_2 + forward_left_stay_change_6) mod 128;
        forward_left_cost_7 <= (forward_left_cost_7_choice_2 + forward_left_stay_change_7) mod 128;
        forward_left_cost_8 <= (forward_left_cost_8_choice_2 + forward_left_stay_change_8) mod 128;
        forward_left_cost_9 <= (forward_left_cost_9_choice_2 + forward_left_stay_change_9) mod 128;
        forward_left_cost_10 <= (forward_left_cost_10_choice_2 + forward_left_stay_change_10) mod 128;
        forward_left_cost_11 <= (forward_left_cost_11_choice_2 + forward_left_stay_change_11) mod 128;
        forward_left_arrived_0 <= (forward_left_arrived_0_choice + forward_left_step_change_0) mod 128;
        forward_left_arrived_1 <= (forward_left_arrived_1_choice + forward_left_step_change_1) mod 128;
        forward_left_arrived_2 <= (forward_left_arrived_2_choice + forward_left_step_change_2) mod 128;
        forward_left_arrived_3 <= (forward_left_arrived_3_choice_2 + forward_left_step_change_3) mod 128;
        forward_left_arrived_4 <= (forward_left_arrived_4_choice_2 + forward_left_step_change_4) mod 128;
        forward_left_arrived_5 <= (forward_left_arrived_5_choice + forward_left_step_change_5) mod 128;
        forward_left_arrived_6 <= (forward_left_arrived_6_choice + forward_left_step_change_6) mod 128;
        forward_left_arrived_7 <= (forward_left_arrived_7_choice_2 + forward_left_step_change_7) mod 128;
        forward_left_arrived_8 <= (forward_left_arrived_8_choice_2 + forward_left_step_change_8) mod 128;
        forward_left_arrived_9 <= (forward_left_arrived_9_choice + forward_left_step_change_9) mod 128;
        forward_left_arrived_10 <= (forward_left_arrived_10_choice + forward_left_step_change_10) mod 128;
        forward_left_arrived_11 <= (forward_left_arrived_11_choice + forward_left_step_change_11) mod 128;
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
        forward_above_total_0 <= forward_above_total_0_choice + forward_above_ready_cost_0;
        forward_above_total_1 <= forward_above_total_1_choice + forward_above_ready_cost_1;
        forward_above_total_2 <= forward_above_total_2_choice + forward_above_ready_cost_2;
        forward_above_total_3 <= forward_above_total_3_choice + forward_above_ready_cost_3;
        forward_above_total_4 <= forward_above_total_4_choice + forward_above_ready_cost_4;
        forward_above_total_5 <= forward_above_total_5_choice + forward_above_ready_cost_5;
        forward_above_total_6 <= forward_above_total_6_choice + forward_above_ready_cost_6;
        forward_above_total_7 <= forward_above_total_7_choice + forward_above_ready_cost_7;
        forward_above_total_8 <= forward_above_total_8_choice + forward_above_ready_cost_8;
        forward_above_total_9 <= forward_above_total_9_choice + forward_above_ready_cost_9;
        forward_above_total_10 <= forward_above_total_10_choice + forward_above_ready_cost_10;
        forward_above_total_11 <= forward_above_total_11_choice + forward_above_ready_cost_11;
        forward_above_tree_next_next_smallest_1 <= forward_above_tree_next_smallest_2;
        forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
        forward_above_smallest_copy_0 <= forward_above_tree_next_next_next_smallest_0;
        forward_above_cost_0 <= (to_integer(forward_above_delay_held_0) - forward_above_smallest_copy_0) mod 64;
        forward_above_cost_1 <= (to_integer(forward_above_delay_held_0(29 downto 6)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_2 <= (to_integer(forward_above_delay_held_0(29 downto 12)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_3 <= (to_integer(forward_above_delay_held_0(29 downto 18)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_4 <= (to_integer(forward_above_delay_held_0(29 downto 24)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_5 <= (to_integer(forward_above_delay_held_1) - forward_above_smallest_copy_0) mod 64;
        forward_above_cost_6 <= (to_integer(forward_above_delay_held_1(29 downto 6)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_7 <= (to_integer(forward_above_delay_held_1(29 downto 12)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_8 <= (to_integer(forward_above_delay_held_1(29 downto 18)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_9 <= (to_integer(forward_above_delay_held_1(29 downto 24)) - forward_above_smallest_copy_0)
          mod 64;
        forward_above_cost_10 <= (to_integer(forward_above_delay_held_2) - forward_above_smallest_copy_0) mod 64;
        forward_above_cost_11 <= (to_integer(forward_above_delay_held_2(11 downto 6)) - forward_above_smallest_copy_0)
          mod 64;
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
        forward_first_0 <= entry_turned_first_column;
        forward_first_1 <= forward_first_0;
        forward_first_2 <= forward_first_1;
        forward_first_3 <= forward_first_2;
        forward_reliefs_moved_0 <= relief_entered;
        forward_reliefs_moved_1 <= forward_reliefs_moved_0;
        forward_reliefs_moved_2 <= forward_reliefs_moved_1;
        forward_reliefs_moved_3 <= forward_reliefs_moved_2;
        forward_reliefs_moved_4 <= forward_left_relief_next_0;
        forward_reliefs_moved_5 <= forward_reliefs_moved_4;
        forward_reliefs_moved_6 <= forward_reliefs_moved_5;
        forward_reliefs_moved_7 <= forward_reliefs_moved_6;
        forward_reliefs_moved_8 <= forward_reliefs_moved_7;
        forward_cost_0_0 <= to_integer(forward_cost_delay_held_0(2 downto 0));
        forward_cost_0_1 <= to_integer(forward_cost_delay_held_0(5 downto 0)) / 8;
        forward_cost_0_2 <= to_integer(forward_cost_delay_held_0(8 downto 6));
        forward_cost_0_3 <= to_integer(forward_cost_delay_held_0(11 downto 9));
        forward_cost_0_4 <= to_integer(forward_cost_delay_held_0(14 downto 12));
        forward_cost_0_5 <= to_integer(forward_cost_delay_held_0(17 downto 15));
        forward_cost_0_6 <= to_integer(forward_cost_delay_held_0(20 downto 18));
        forward_cost_0_7 <= to_integer(forward_cost_delay_held_0(23 downto 21));
        forward_cost_0_8 <= to_integer(forward_cost_delay_held_0(26 downto 24));
        forward_cost_0_9 <= to_integer(forward_cost_delay_held_0(29 downto 27));
        forward_cost_0_10 <= to_integer(forward_cost_delay_held_1(2 downto 0));
        forward_cost_0_11 <= to_integer(forward_cost_delay_held_1(5 downto 0)) / 8;
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
        if sums_right_first_2 then
          forward_left_start_cost_0 <= 60;
          forward_left_start_cost_1 <= 0;
          forward_left_start_cost_2 <= 0;
          forward_left_start_cost_3 <= 0;
          forward_left_start_cost_4 <= 0;
          forward_left_start_cost_5 <= 0;
          forward_left_start_cost_6 <= 0;
          forward_left_room <= 0;
          forward_left_relief_reach_of_best <= 0;
        else
          forward_left_start_cost_0 <= forward_left_start_cost_0_choice_9;
          forward_left_start_cost_1 <= forward_left_start_cost_0;
          forward_left_start_cost_2 <= forward_left_start_cost_1;
          forward_left_start_cost_3 <= forward_left_start_cost_2;
          forward_left_start_cost_4 <= forward_left_start_cost_3;
          forward_left_start_cost_5 <= forward_left_start_cost_4;
          forward_left_start_cost_6 <= forward_left_start_cost_5;
          forward_left_room <= forward_left_room_choice_3;
          forward_left_relief_reach_of_best <= forward_left_relief_reach_of_best_choice_3;
        end if;
        if (forward_left_relief_pairs_0_choice - forward_left_relief_pairs_1) < 0 then
          forward_left_relief_fours_0 <= forward_left_relief_pairs_1;
        else
          forward_left_relief_fours_0 <= forward_left_relief_pairs_0_choice;
        end if;
        if (forward_left_smallest_choice - forward_left_relief_fours_0) < 0 then
          forward_left_relief_older <= forward_left_relief_fours_0;
        else
          forward_left_relief_older <= forward_left_smallest_choice;
        end if;
        if (forward_left_relief_recent_choice - forward_left_relief_older) < 0 then
          forward_left_relief_recent <= forward_left_relief_older;
        else
          forward_left_relief_recent <= forward_left_relief_recent_choice;
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
        if forward_above_own_0 < 31 then
          forward_above_stay_0 <= forward_above_own_0 mod 32;
        else
          forward_above_stay_0 <= 31;
        end if;
        if forward_above_beside_0 < 31 then
          forward_above_stay_1 <= forward_above_beside_0 mod 32;
        else
          forward_above_stay_1 <= 31;
        end if;
        if forward_above_own_2 < 31 then
          forward_above_stay_2 <= forward_above_own_2 mod 32;
        else
          forward_above_stay_2 <= 31;
        end if;
        if forward_above_own_3 < 31 then
          forward_above_stay_3 <= forward_above_own_3 mod 32;
        else
          forward_above_stay_3 <= 31;
        end if;
        if forward_above_own_4 < 31 then
          forward_above_stay_4 <= forward_above_own_4 mod 32;
        else
          forward_above_stay_4 <= 31;
        end if;
        if forward_above_own_5 < 31 then
          forward_above_stay_5 <= forward_above_own_5 mod 32;
        else
          forward_above_stay_5 <= 31;
        end if;
        if forward_above_own_6 < 31 then
          forward_above_stay_6 <= forward_above_own_6 mod 32;
        else
          forward_above_stay_6 <= 31;
        end if;
        if forward_above_own_7 < 31 then
          forward_above_stay_7 <= forward_above_own_7 mod 32;
        else
          forward_above_stay_7 <= 31;
        end if;
        if forward_above_own_8 < 31 then
          forward_above_stay_8 <= forward_above_own_8 mod 32;
        else
          forward_above_stay_8 <= 31;
        end if;
        if forward_above_own_9 < 31 then
          forward_above_stay_9 <= forward_above_own_9 mod 32;
        else
          forward_above_stay_9 <= 31;
        end if;
        if forward_above_beside_11 < 31 then
          forward_above_stay_10 <= forward_above_beside_11 mod 32;
        else
          forward_above_stay_10 <= 31;
        end if;
        if forward_above_own_11 < 31 then
          forward_above_stay_11 <= forward_above_own_11 mod 32;
        else
          forward_above_stay_11 <= 31;
        end if;
      end if;
      if forward_above_comes_9 then
        forward_above_writes_copy_0 <= entry_next_tag_valid and (forward_above_comes_8 or (not entry_tag_valid));
      else
        forward_above_writes_copy_0 <= entry_next_tag_valid and forward_above_comes_8 and entry_tag_valid;
      end if;
      if (forward_above_step_4 - forward_above_stay_4) < 0 then
        forward_above_write_words_0_choice := forward_above_step_4;
      else
        forward_above_write_words_0_choice := forward_above_stay_4;
      end if;
      if (forward_above_step_5 - forward_above_stay_5) < 0 then
        forward_above_write_words_0_choice_2 := forward_above_step_5;
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
        forward_above_write_words_1_choice_2 := forward_above_step_11;
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
      sums_right_start_cost_0_any := ((((sums_right_tree_next_next_smallest_0 mod 64) + sums_right_relief_beyond) / 64)
        = 1) or ((sums_right_tree_next_next_smallest_0 / 64) = 1);
      if (sums_right_relief_largest mod 2) = 1 then
        sums_right_start_cost_0_choice := (not (((sums_right_room / 2) mod 2) = 1)) or (not ((sums_right_room mod 2) =
          1));
      else
        sums_right_start_cost_0_choice := not (((sums_right_room / 2) mod 2) = 1);
      end if;
      if ((sums_right_relief_largest / 2) mod 2) = 1 then
        sums_right_start_cost_0_choice_2 := sums_right_start_cost_0_choice;
      else
        sums_right_start_cost_0_choice_2 := ((sums_right_relief_largest mod 2) = 1) and ((sums_right_room mod 4) = 0);
      end if;
      sums_right_start_cost_0_value := ((sums_right_room / 4) mod 2) = 1;
      if sums_right_start_cost_0_choice_2 then
        sums_right_start_cost_0_choice_3 := (not (((sums_right_relief_largest / 4) mod 2) = 1)) and
          sums_right_start_cost_0_value;
      else
        sums_right_start_cost_0_choice_3 := (not (((sums_right_relief_largest / 4) mod 2) = 1)) or
          sums_right_start_cost_0_value;
      end if;
      sums_right_start_cost_0_value_2 := ((sums_right_room / 8) mod 2) = 1;
      if sums_right_start_cost_0_choice_3 then
        sums_right_start_cost_0_choice_4 := (not (((sums_right_relief_largest / 8) mod 2) = 1)) or
          sums_right_start_cost_0_value_2;
      else
        sums_right_start_cost_0_choice_4 := (not (((sums_right_relief_largest / 8) mod 2) = 1)) and
          sums_right_start_cost_0_value_2;
      end if;
      sums_right_start_cost_0_value_3 := ((sums_right_room / 16) mod 2) = 1;
      if sums_right_start_cost_0_choice_4 then
        sums_right_start_cost_0_choice_5 := (not (((sums_right_relief_largest / 16) mod 2) = 1)) or
          sums_right_start_cost_0_value_3;
      else
        sums_right_start_cost_0_choice_5 := (not (((sums_right_relief_largest / 16) mod 2) = 1)) and
          sums_right_start_cost_0_value_3;
      end if;
      if sums_right_start_cost_0_choice_5 then
        sums_right_start_cost_0_choice_6 := ((sums_right_relief_largest / 32) = 1) and (not ((sums_right_room / 32) =
          1));
      else
        sums_right_start_cost_0_choice_6 := ((sums_right_relief_largest / 32) = 1) or (not ((sums_right_room / 32) =
          1));
      end if;
      if sums_right_start_cost_0_choice_6 then
        sums_right_start_cost_0_choice_7 := 0;
      else
        sums_right_start_cost_0_choice_7 := (sums_right_room - sums_right_relief_largest) mod 64;
      end if;
      sums_right_start_cost_0_is_less := 127 < ((sums_right_tree_next_next_smallest_0 mod 64) +
        sums_right_relief_reach_of_best);
      if sums_right_start_cost_0_is_less then
        sums_right_start_cost_0_choice_8 := (sums_right_tree_next_next_smallest_0 + sums_right_relief_reach_of_best)
          mod 64;
      else
        sums_right_start_cost_0_choice_8 := 0;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_start_cost_0_choice_9 := sums_right_start_cost_0_choice_7;
      else
        sums_right_start_cost_0_choice_9 := sums_right_start_cost_0_choice_8;
      end if;
      sums_right_room_value := (sums_right_start_cost_6 + sums_right_room) mod 64;
      if sums_right_start_cost_0_choice_6 then
        sums_right_room_choice := sums_right_room_value;
      else
        sums_right_room_choice := (sums_right_start_cost_6 + sums_right_relief_largest) mod 64;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_room_choice_2 := (sums_right_relief_room_of_best - sums_right_tree_next_next_smallest_0) mod 64;
      else
        sums_right_room_choice_2 := sums_right_room_value;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_room_choice_3 := sums_right_room_choice;
      else
        sums_right_room_choice_3 := sums_right_room_choice_2;
      end if;
      if forward_first_0 then
        sums_right_smallest_choice := 0;
      else
        sums_right_smallest_choice := sums_right_relief_next_0;
      end if;
      sums_right_smallest_difference := sums_right_smallest_choice - (sums_turn_ready_smallest_0 / 8);
      if (sums_right_smallest_choice - sums_right_relief_past_0) < 0 then
        sums_right_relief_pairs_0_choice := sums_right_relief_past_0;
      else
        sums_right_relief_pairs_0_choice := sums_right_smallest_choice;
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_smallest_choice) < 0 then
        sums_right_relief_recent_choice := sums_right_smallest_choice;
      else
        sums_right_relief_recent_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_relief_recent) < 0 then
        sums_right_relief_largest_choice := sums_right_relief_recent;
      else
        sums_right_relief_largest_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      sums_right_relief_reach_of_best_sum := sums_right_room + sums_right_relief_leaves;
      if sums_right_start_cost_0_choice_6 then
        sums_right_relief_reach_of_best_choice := sums_right_relief_reach_of_best_sum;
      else
        sums_right_relief_reach_of_best_choice := sums_right_relief_largest + sums_right_relief_leaves;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_relief_reach_of_best_choice_2 := (sums_right_relief_reach_again -
          (sums_right_tree_next_next_smallest_0 mod 64)) mod 256;
      else
        sums_right_relief_reach_of_best_choice_2 := sums_right_relief_reach_of_best_sum;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_relief_reach_of_best_choice_3 := sums_right_relief_reach_of_best_choice;
      else
        sums_right_relief_reach_of_best_choice_3 := sums_right_relief_reach_of_best_choice_2;
      end if;
      if forward_first_0 then
        sums_right_relief_leaves_choice := 64;
      else
        sums_right_relief_leaves_choice := sums_right_start_cost_5 + 64;
      end if;
      if (sums_right_arrived_0 - sums_right_cost_0) < 0 then
        sums_right_cost_0_choice := sums_right_arrived_0;
      else
        sums_right_cost_0_choice := sums_right_cost_0;
      end if;
      if ((sums_right_cost_0_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_0_choice_2 := 64;
      else
        sums_right_cost_0_choice_2 := sums_right_cost_0_choice;
      end if;
      if (sums_right_arrived_1 - sums_right_cost_1) < 0 then
        sums_right_cost_1_choice := sums_right_arrived_1;
      else
        sums_right_cost_1_choice := sums_right_cost_1;
      end if;
      if ((sums_right_cost_1_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_1_choice_2 := 64;
      else
        sums_right_cost_1_choice_2 := sums_right_cost_1_choice;
      end if;
      if (sums_right_arrived_2 - sums_right_cost_2) < 0 then
        sums_right_cost_2_choice := sums_right_arrived_2;
      else
        sums_right_cost_2_choice := sums_right_cost_2;
      end if;
      if ((sums_right_cost_2_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_2_choice_2 := 64;
      else
        sums_right_cost_2_choice_2 := sums_right_cost_2_choice;
      end if;
      if (sums_right_arrived_3 - sums_right_cost_3) < 0 then
        sums_right_cost_3_choice := sums_right_arrived_3;
      else
        sums_right_cost_3_choice := sums_right_cost_3;
      end if;
      if ((sums_right_cost_3_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_3_choice_2 := 64;
      else
        sums_right_cost_3_choice_2 := sums_right_cost_3_choice;
      end if;
      if (sums_right_arrived_4 - sums_right_cost_4) < 0 then
        sums_right_cost_4_choice := sums_right_arrived_4;
      else
        sums_right_cost_4_choice := sums_right_cost_4;
      end if;
      if ((sums_right_cost_4_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_4_choice_2 := 64;
      else
        sums_right_cost_4_choice_2 := sums_right_cost_4_choice;
      end if;
      if (sums_right_arrived_5 - sums_right_cost_5) < 0 then
        sums_right_cost_5_choice := sums_right_arrived_5;
      else
        sums_right_cost_5_choice := sums_right_cost_5;
      end if;
      if ((sums_right_cost_5_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_5_choice_2 := 64;
      else
        sums_right_cost_5_choice_2 := sums_right_cost_5_choice;
      end if;
      if (sums_right_arrived_6 - sums_right_cost_6) < 0 then
        sums_right_cost_6_choice := sums_right_arrived_6;
      else
        sums_right_cost_6_choice := sums_right_cost_6;
      end if;
      if ((sums_right_cost_6_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_6_choice_2 := 64;
      else
        sums_right_cost_6_choice_2 := sums_right_cost_6_choice;
      end if;
      if (sums_right_arrived_7 - sums_right_cost_7) < 0 then
        sums_right_cost_7_choice := sums_right_arrived_7;
      else
        sums_right_cost_7_choice := sums_right_cost_7;
      end if;
      if ((sums_right_cost_7_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_7_choice_2 := 64;
      else
        sums_right_cost_7_choice_2 := sums_right_cost_7_choice;
      end if;
      if (sums_right_arrived_8 - sums_right_cost_8) < 0 then
        sums_right_cost_8_choice := sums_right_arrived_8;
      else
        sums_right_cost_8_choice := sums_right_cost_8;
      end if;
      if ((sums_right_cost_8_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_8_choice_2 := 64;
      else
        sums_right_cost_8_choice_2 := sums_right_cost_8_choice;
      end if;
      if (sums_right_arrived_9 - sums_right_cost_9) < 0 then
        sums_right_cost_9_choice := sums_right_arrived_9;
      else
        sums_right_cost_9_choice := sums_right_cost_9;
      end if;
      if ((sums_right_cost_9_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_9_choice_2 := 64;
      else
        sums_right_cost_9_choice_2 := sums_right_cost_9_choice;
      end if;
      if (sums_right_arrived_10 - sums_right_cost_10) < 0 then
        sums_right_cost_10_choice := sums_right_arrived_10;
      else
        sums_right_cost_10_choice := sums_right_cost_10;
      end if;
      if ((sums_right_cost_10_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_10_choice_2 := 64;
      else
        sums_right_cost_10_choice_2 := sums_right_cost_10_choice;
      end if;
      if (sums_right_arrived_11 - sums_right_cost_11) < 0 then
        sums_right_cost_11_choice := sums_right_arrived_11;
      else
        sums_right_cost_11_choice := sums_right_cost_11;
      end if;
      if ((sums_right_cost_11_choice / 64) = 1) or forward_first_3 then
        sums_right_cost_11_choice_2 := 64;
      else
        sums_right_cost_11_choice_2 := sums_right_cost_11_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_0_choice := 64;
      else
        sums_right_arrived_0_choice := sums_right_cost_1;
      end if;
      if forward_first_3 then
        sums_right_arrived_1_choice := 64;
      else
        sums_right_arrived_1_choice := sums_right_pair_0_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_2_choice := 64;
      else
        sums_right_arrived_2_choice := sums_right_pair_1_choice;
      end if;
      if (sums_right_cost_4 - sums_right_cost_2) < 0 then
        sums_right_arrived_3_choice := sums_right_cost_4;
      else
        sums_right_arrived_3_choice := sums_right_cost_2;
      end if;
      if forward_first_3 then
        sums_right_arrived_3_choice_2 := 64;
      else
        sums_right_arrived_3_choice_2 := sums_right_arrived_3_choice;
      end if;
      if (sums_right_cost_5 - sums_right_cost_3) < 0 then
        sums_right_arrived_4_choice := sums_right_cost_5;
      else
        sums_right_arrived_4_choice := sums_right_cost_3;
      end if;
      if forward_first_3 then
        sums_right_arrived_4_choice_2 := 64;
      else
        sums_right_arrived_4_choice_2 := sums_right_arrived_4_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_5_choice := 64;
      else
        sums_right_arrived_5_choice := sums_right_pair_2_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_6_choice := 64;
      else
        sums_right_arrived_6_choice := sums_right_pair_3_choice;
      end if;
      if (sums_right_cost_8 - sums_right_cost_6) < 0 then
        sums_right_arrived_7_choice := sums_right_cost_8;
      else
        sums_right_arrived_7_choice := sums_right_cost_6;
      end if;
      if forward_first_3 then
        sums_right_arrived_7_choice_2 := 64;
      else
        sums_right_arrived_7_choice_2 := sums_right_arrived_7_choice;
      end if;
      if (sums_right_cost_9 - sums_right_cost_7) < 0 then
        sums_right_arrived_8_choice := sums_right_cost_9;
      else
        sums_right_arrived_8_choice := sums_right_cost_7;
      end if;
      if forward_first_3 then
        sums_right_arrived_8_choice_2 := 64;
      else
        sums_right_arrived_8_choice_2 := sums_right_arrived_8_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_9_choice := 64;
      else
        sums_right_arrived_9_choice := sums_right_pair_4_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_10_choice := 64;
      else
        sums_right_arrived_10_choice := sums_right_pair_5_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_11_choice := 64;
      else
        sums_right_arrived_11_choice := sums_right_cost_10;
      end if;
      if entry_tag_valid then
        sums_turn_ready_sums_0 <= sums_turn_read_sums_0;
        sums_turn_ready_sums_1 <= sums_turn_read_sums_1;
        sums_turn_ready_sums_2 <= sums_turn_read_sums_2;
        sums_turn_ready_costs_0 <= to_integer(sums_turn_read_costs_0);
        sums_turn_ready_costs_1 <= to_integer(sums_turn_read_costs_1);
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= entry_tag_first_column;
        sums_turn_place_0 <= entry_place;
        sums_turn_place_1 <= sums_turn_place_0;
        sums_turn_place_2 <= sums_turn_place_1;
        sums_turn_place_3 <= sums_turn_place_2;
        sums_turn_place_4 <= sums_turn_place_3;
        sums_turn_place_5 <= sums_turn_place_4;
        sums_turn_place_6 <= sums_turn_place_5;
        sums_turn_place_7 <= sums_turn_place_6;
        sums_turn_place_8 <= sums_turn_place_7;
        sums_cost_0_0 <= sums_turn_ready_costs_0 mod 8;
        sums_cost_0_1 <= (sums_turn_ready_costs_0 mod 64) / 8;
        sums_cost_0_2 <= (sums_turn_ready_costs_0 / 64) mod 8;
        sums_cost_0_3 <= (sums_turn_ready_costs_0 / 512) mod 8;
        sums_cost_0_4 <= (sums_turn_ready_costs_0 / 4096) mod 8;
        sums_cost_0_5 <= (sums_turn_ready_costs_0 / 32768) mod 8;
        sums_cost_0_6 <= (sums_turn_ready_costs_0 / 262144) mod 8;
        sums_cost_0_7 <= (sums_turn_ready_costs_0 / 2097152) mod 8;
        sums_cost_0_8 <= (sums_turn_ready_costs_0 / 16777216) mod 8;
        sums_cost_0_9 <= sums_turn_ready_costs_0 / 134217728;
        sums_cost_0_10 <= sums_turn_ready_costs_1 mod 8;
        sums_cost_0_11 <= sums_turn_ready_costs_1 / 8;
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
        sums_right_smallest <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8)) mod 128;
        sums_right_smallest_less <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8) + 121) mod 128;
        sums_right_first_0 <= sums_turn_ready_first;
        sums_right_first_1 <= sums_right_first_0;
        sums_right_first_2 <= sums_right_first_1;
        sums_right_relief_next_0 <= sums_turn_ready_smallest_0 / 8;
        sums_right_relief_past_0 <= sums_right_smallest_choice;
        sums_right_relief_past_1 <= sums_right_relief_past_0;
        sums_right_relief_past_2 <= sums_right_relief_past_1;
        sums_right_relief_past_3 <= sums_right_relief_past_2;
        sums_right_relief_past_4 <= sums_right_relief_past_3;
        sums_right_relief_past_5 <= sums_right_relief_past_4;
        sums_right_relief_pairs_0 <= sums_right_relief_pairs_0_choice;
        sums_right_relief_pairs_1 <= sums_right_relief_pairs_0;
        sums_right_relief_largest <= sums_right_relief_largest_choice;
        sums_right_relief_beyond <= (sums_right_relief_largest_choice - sums_right_relief_past_5) mod 64;
        sums_right_relief_leaves <= sums_right_relief_leaves_choice - sums_right_relief_past_4;
        sums_right_relief_room_of_best <= sums_right_relief_past_5 + sums_right_relief_leaves_choice;
        sums_right_relief_reach_again <= (64 - sums_right_relief_past_4) + sums_right_relief_past_5 +
          sums_right_relief_leaves_choice;
        sums_right_g_copy_0 <= (sums_right_start_cost_0 + sums_right_smallest) mod 128;
        sums_right_g_less_copy_0 <= (sums_right_start_cost_0 + sums_right_smallest_less) mod 128;
        sums_right_stay_change_0 <= (sums_cost_1_0 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_1 <= (sums_cost_1_1 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_2 <= (sums_cost_1_2 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_3 <= (sums_cost_1_3 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_4 <= (sums_cost_1_4 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_5 <= (sums_cost_1_5 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_6 <= (sums_cost_1_6 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_7 <= (sums_cost_1_7 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_8 <= (sums_cost_1_8 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_9 <= (sums_cost_1_9 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_10 <= (sums_cost_1_10 - sums_right_g_copy_0) mod 128;
        sums_right_stay_change_11 <= (sums_cost_1_11 - sums_right_g_copy_0) mod 128;
        sums_right_step_change_0 <= (sums_cost_1_0 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_1 <= (sums_cost_1_1 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_2 <= (sums_cost_1_2 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_3 <= (sums_cost_1_3 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_4 <= (sums_cost_1_4 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_5 <= (sums_cost_1_5 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_6 <= (sums_cost_1_6 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_7 <= (sums_cost_1_7 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_8 <= (sums_cost_1_8 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_9 <= (sums_cost_1_9 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_10 <= (sums_cost_1_10 - sums_right_g_less_copy_0) mod 128;
        sums_right_step_change_11 <= (sums_cost_1_11 - sums_right_g_less_copy_0) mod 128;
        sums_right_cost_0 <= (sums_right_cost_0_choice_2 + sums_right_stay_change_0) mod 128;
        sums_right_cost_1 <= (sums_right_cost_1_choice_2 + sums_right_stay_change_1) mod 128;
        sums_right_cost_2 <= (sums_right_cost_2_choice_2 + sums_right_stay_change_2) mod 128;
        sums_right_cost_3 <= (sums_right_cost_3_choice_2 + sums_right_stay_change_3) mod 128;
        sums_right_cost_4 <= (sums_right_cost_4_choice_2 + sums_right_stay_change_4) mod 128;
        sums_right_cost_5 <= (sums_right_cost_5_choice_2 + sums_right_stay_change_5) mod 128;
        sums_right_cost_6 <= (sums_right_cost_6_choice_2 + sums_right_stay_change_6) mod 128;
        sums_right_cost_7 <= (sums_right_cost_7_choice_2 + sums_right_stay_change_7) mod 128;
        sums_right_cost_8 <= (sums_right_cost_8_choice_2 + sums_right_stay_change_8) mod 128;
        sums_right_cost_9 <= (sums_right_cost_9_choice_2 + sums_right_stay_change_9) mod 128;
        sums_right_cost_10 <= (sums_right_cost_10_choice_2 + sums_right_stay_change_10) mod 128;
        sums_right_cost_11 <= (sums_right_cost_11_choice_2 + sums_right_stay_change_11) mod 128;
        sums_right_arrived_0 <= (sums_right_arrived_0_choice + sums_right_step_change_0) mod 128;
        sums_right_arrived_1 <= (sums_right_arrived_1_choice + sums_right_step_change_1) mod 128;
        sums_right_arrived_2 <= (sums_right_arrived_2_choice + sums_right_step_change_2) mod 128;
        sums_right_arrived_3 <= (sums_right_arrived_3_choice_2 + sums_right_step_change_3) mod 128;
        sums_right_arrived_4 <= (sums_right_arrived_4_choice_2 + sums_right_step_change_4) mod 128;
        sums_right_arrived_5 <= (sums_right_arrived_5_choice + sums_right_step_change_5) mod 128;
        sums_right_arrived_6 <= (sums_right_arrived_6_choice + sums_right_step_change_6) mod 128;
        sums_right_arrived_7 <= (sums_right_arrived_7_choice_2 + sums_right_step_change_7) mod 128;
        sums_right_arrived_8 <= (sums_right_arrived_8_choice_2 + sums_right_step_change_8) mod 128;
        sums_right_arrived_9 <= (sums_right_arrived_9_choice + sums_right_step_change_9) mod 128;
        sums_right_arrived_10 <= (sums_right_arrived_10_choice + sums_right_step_change_10) mod 128;
        sums_right_arrived_11 <= (sums_right_arrived_11_choice + sums_right_step_change_11) mod 128;
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
        if forward_first_0 then
          sums_right_start_cost_0 <= 60;
          sums_right_start_cost_1 <= 0;
          sums_right_start_cost_2 <= 0;
          sums_right_start_cost_3 <= 0;
          sums_right_start_cost_4 <= 0;
          sums_right_start_cost_5 <= 0;
          sums_right_start_cost_6 <= 0;
          sums_right_room <= 0;
          sums_right_relief_reach_of_best <= 0;
        else
          sums_right_start_cost_0 <= sums_right_start_cost_0_choice_9;
          sums_right_start_cost_1 <= sums_right_start_cost_0;
          sums_right_start_cost_2 <= sums_right_start_cost_1;
          sums_right_start_cost_3 <= sums_right_start_cost_2;
          sums_right_start_cost_4 <= sums_right_start_cost_3;
          sums_right_start_cost_5 <= sums_right_start_cost_4;
          sums_right_start_cost_6 <= sums_right_start_cost_5;
          sums_right_room <= sums_right_room_choice_3;
          sums_right_relief_reach_of_best <= sums_right_relief_reach_of_best_choice_3;
        end if;
        if (sums_right_relief_pairs_0_choice - sums_right_relief_pairs_1) < 0 then
          sums_right_relief_fours_0 <= sums_right_relief_pairs_1;
        else
          sums_right_relief_fours_0 <= sums_right_relief_pairs_0_choice;
        end if;
        if (sums_right_smallest_choice - sums_right_relief_fours_0) < 0 then
          sums_right_relief_older <= sums_right_relief_fours_0;
        else
          sums_right_relief_older <= sums_right_smallest_choice;
        end if;
        if (sums_right_relief_recent_choice - sums_right_relief_older) < 0 then
          sums_right_relief_recent <= sums_right_relief_older;
        else
          sums_right_relief_recent <= sums_right_relief_recent_choice;
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
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      sums_sum_0_0 <= (sums_right_cost_0 + to_integer(sums_sum_delay_held_0(7 downto 0))) mod 256;
      sums_sum_0_1 <= (sums_right_cost_1 + to_integer(sums_sum_delay_held_0(31 downto 8))) mod 256;
      sums_sum_0_2 <= (sums_right_cost_2 + to_integer(sums_sum_delay_held_0(31 downto 16))) mod 256;
      sums_sum_0_3 <= (sums_right_cost_3 + to_integer(sums_sum_delay_held_0(31 downto 24))) mod 256;
      sums_sum_0_4 <= (sums_right_cost_4 + to_integer(sums_sum_delay_held_1(7 downto 0))) mod 256;
      sums_sum_0_5 <= (sums_right_cost_5 + to_integer(sums_sum_delay_held_1(31 downto 8))) mod 256;
      sums_sum_0_6 <= (sums_right_cost_6 + to_integer(sums_sum_delay_held_1(31 downto 16))) mod 256;
      sums_sum_0_7 <= (sums_right_cost_7 + to_integer(sums_sum_delay_held_1(31 downto 24))) mod 256;
      sums_sum_0_8 <= (sums_right_cost_8 + to_integer(sums_sum_delay_held_2(7 downto 0))) mod 256;
      sums_sum_0_9 <= (sums_right_cost_9 + to_integer(sums_sum_delay_held_2(31 downto 8))) mod 256;
      sums_sum_0_10 <= (sums_right_cost_10 + to_integer(sums_sum_delay_held_2(31 downto 16))) mod 256;
      sums_sum_0_11 <= (sums_right_cost_11 + to_integer(sums_sum_delay_held_2(31 downto 24))) mod 256;
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= forward_above_comes_4;
      sums_tag_output_column <= sums_tags_held_4_output_column;
      sums_tag_start_of_frame <= sums_tags_held_4_start_of_frame;
      sums_tag_end_of_line <= sums_tags_held_4_end_of_line;
      sums_tags_moved <= entry_tag_valid;
      if sums_turn_writes_copy_0 then
        sums_turn_write_sums_0 <= other_2;
        sums_turn_write_sums_1 <= other_1;
        sums_turn_write_sums_2 <= other_0;
        sums_turn_write_costs_0 <= (forward_cost_3_8 * 16777216) + (forward_cost_3_9 * 134217728) + (forward_cost_3_7 *
          2097152) + (forward_cost_3_6 * 262144) + (forward_cost_3_5 * 32768) + (forward_cost_3_4 * 4096) +
          (forward_cost_3_3 * 512) + (forward_cost_3_2 * 64) + forward_cost_3_0 + (forward_cost_3_1 * 8);
        sums_turn_write_costs_1 <= (forward_cost_3_11 * 8) + forward_cost_3_10;
        sums_turn_write_smallest_0 <= to_integer(((to_unsigned(forward_reliefs_moved_8, 6) & to_unsigned(0, 3)) or
          (to_unsigned(forward_smallest_cost_4, 9))));
        sums_turn_write_place <= sums_turn_place_8;
      end if;
      -- winnerswinner1
      if (sums_sum_0_0 mod 2) = 1 then
        winnerswinner1_of_pair_0_0_choice := (not (((sums_sum_0_1 / 2) mod 2) = 1)) or (not ((sums_sum_0_1 mod 2) = 1));
      else
        winnerswinner1_of_pair_0_0_choice := not (((sums_sum_0_1 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_0 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_0_choice_2 := winnerswinner1_of_pair_0_0_choice;
      else
        winnerswinner1_of_pair_0_0_choice_2 := ((sums_sum_0_0 mod 2) = 1) and ((sums_sum_0_1 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_0_value := ((sums_sum_0_1 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_0_choice_2 then
        winnerswinner1_of_pair_0_0_choice_3 := (not (((sums_sum_0_0 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_0_value;
      else
        winnerswinner1_of_pair_0_0_choice_3 := (not (((sums_sum_0_0 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_0_value;
      end if;
      winnerswinner1_of_pair_0_0_value_2 := ((sums_sum_0_1 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_0_choice_3 then
        winnerswinner1_of_pair_0_0_choice_4 := (not (((sums_sum_0_0 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_0_value_2;
      else
        winnerswinner1_of_pair_0_0_choice_4 := (not (((sums_sum_0_0 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_0_value_2;
      end if;
      winnerswinner1_of_pair_0_0_value_3 := ((sums_sum_0_1 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_0_choice_4 then
        winnerswinner1_of_pair_0_0_choice_5 := (not (((sums_sum_0_0 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_0_value_3;
      else
        winnerswinner1_of_pair_0_0_choice_5 := (not (((sums_sum_0_0 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_0_value_3;
      end if;
      winnerswinner1_of_pair_0_0_value_4 := ((sums_sum_0_1 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_0_choice_5 then
        winnerswinner1_of_pair_0_0_choice_6 := (not (((sums_sum_0_0 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_0_value_4;
      else
        winnerswinner1_of_pair_0_0_choice_6 := (not (((sums_sum_0_0 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_0_value_4;
      end if;
      winnerswinner1_of_pair_0_0_value_5 := ((sums_sum_0_1 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_0_choice_6 then
        winnerswinner1_of_pair_0_0_choice_7 := (not (((sums_sum_0_0 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_0_value_5;
      else
        winnerswinner1_of_pair_0_0_choice_7 := (not (((sums_sum_0_0 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_0_value_5;
      end if;
      if winnerswinner1_of_pair_0_0_choice_7 then
        winnerswinner1_of_pair_0_0_choice_8 := ((sums_sum_0_0 / 128) = 1) and (not ((sums_sum_0_1 / 128) = 1));
      else
        winnerswinner1_of_pair_0_0_choice_8 := ((sums_sum_0_0 / 128) = 1) or (not ((sums_sum_0_1 / 128) = 1));
      end if;
      if (sums_sum_0_2 mod 2) = 1 then
        winnerswinner1_of_pair_0_2_choice := (not (((sums_sum_0_3 / 2) mod 2) = 1)) or (not ((sums_sum_0_3 mod 2) = 1));
      else
        winnerswinner1_of_pair_0_2_choice := not (((sums_sum_0_3 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_2 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_2_choice_2 := winnerswinner1_of_pair_0_2_choice;
      else
        winnerswinner1_of_pair_0_2_choice_2 := ((sums_sum_0_2 mod 2) = 1) and ((sums_sum_0_3 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_2_value := ((sums_sum_0_3 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_2_choice_2 then
        winnerswinner1_of_pair_0_2_choice_3 := (not (((sums_sum_0_2 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_2_value;
      else
        winnerswinner1_of_pair_0_2_choice_3 := (not (((sums_sum_0_2 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_2_value;
      end if;
      winnerswinner1_of_pair_0_2_value_2 := ((sums_sum_0_3 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_2_choice_3 then
        winnerswinner1_of_pair_0_2_choice_4 := (not (((sums_sum_0_2 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_2_value_2;
      else
        winnerswinner1_of_pair_0_2_choice_4 := (not (((sums_sum_0_2 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_2_value_2;
      end if;
      winnerswinner1_of_pair_0_2_value_3 := ((sums_sum_0_3 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_2_choice_4 then
        winnerswinner1_of_pair_0_2_choice_5 := (not (((sums_sum_0_2 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_2_value_3;
      else
        winnerswinner1_of_pair_0_2_choice_5 := (not (((sums_sum_0_2 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_2_value_3;
      end if;
      winnerswinner1_of_pair_0_2_value_4 := ((sums_sum_0_3 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_2_choice_5 then
        winnerswinner1_of_pair_0_2_choice_6 := (not (((sums_sum_0_2 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_2_value_4;
      else
        winnerswinner1_of_pair_0_2_choice_6 := (not (((sums_sum_0_2 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_2_value_4;
      end if;
      winnerswinner1_of_pair_0_2_value_5 := ((sums_sum_0_3 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_2_choice_6 then
        winnerswinner1_of_pair_0_2_choice_7 := (not (((sums_sum_0_2 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_2_value_5;
      else
        winnerswinner1_of_pair_0_2_choice_7 := (not (((sums_sum_0_2 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_2_value_5;
      end if;
      if winnerswinner1_of_pair_0_2_choice_7 then
        winnerswinner1_of_pair_0_2_choice_8 := ((sums_sum_0_2 / 128) = 1) and (not ((sums_sum_0_3 / 128) = 1));
      else
        winnerswinner1_of_pair_0_2_choice_8 := ((sums_sum_0_2 / 128) = 1) or (not ((sums_sum_0_3 / 128) = 1));
      end if;
      if (sums_sum_0_4 mod 2) = 1 then
        winnerswinner1_of_pair_0_4_choice := (not (((sums_sum_0_5 / 2) mod 2) = 1)) or (not ((sums_sum_0_5 mod 2) = 1));
      else
        winnerswinner1_of_pair_0_4_choice := not (((sums_sum_0_5 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_4 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_4_choice_2 := winnerswinner1_of_pair_0_4_choice;
      else
        winnerswinner1_of_pair_0_4_choice_2 := ((sums_sum_0_4 mod 2) = 1) and ((sums_sum_0_5 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_4_value := ((sums_sum_0_5 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_4_choice_2 then
        winnerswinner1_of_pair_0_4_choice_3 := (not (((sums_sum_0_4 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_4_value;
      else
        winnerswinner1_of_pair_0_4_choice_3 := (not (((sums_sum_0_4 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_4_value;
      end if;
      winnerswinner1_of_pair_0_4_value_2 := ((sums_sum_0_5 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_4_choice_3 then
        winnerswinner1_of_pair_0_4_choice_4 := (not (((sums_sum_0_4 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_4_value_2;
      else
        winnerswinner1_of_pair_0_4_choice_4 := (not (((sums_sum_0_4 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_4_value_2;
      end if;
      winnerswinner1_of_pair_0_4_value_3 := ((sums_sum_0_5 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_4_choice_4 then
        winnerswinner1_of_pair_0_4_choice_5 := (not (((sums_sum_0_4 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_4_value_3;
      else
        winnerswinner1_of_pair_0_4_choice_5 := (not (((sums_sum_0_4 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_4_value_3;
      end if;
      winnerswinner1_of_pair_0_4_value_4 := ((sums_sum_0_5 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_4_choice_5 then
        winnerswinner1_of_pair_0_4_choice_6 := (not (((sums_sum_0_4 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_4_value_4;
      else
        winnerswinner1_of_pair_0_4_choice_6 := (not (((sums_sum_0_4 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_4_value_4;
      end if;
      winnerswinner1_of_pair_0_4_value_5 := ((sums_sum_0_5 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_4_choice_6 then
        winnerswinner1_of_pair_0_4_choice_7 := (not (((sums_sum_0_4 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_4_value_5;
      else
        winnerswinner1_of_pair_0_4_choice_7 := (not (((sums_sum_0_4 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_4_value_5;
      end if;
      if winnerswinner1_of_pair_0_4_choice_7 then
        winnerswinner1_of_pair_0_4_choice_8 := ((sums_sum_0_4 / 128) = 1) and (not ((sums_sum_0_5 / 128) = 1));
      else
        winnerswinner1_of_pair_0_4_choice_8 := ((sums_sum_0_4 / 128) = 1) or (not ((sums_sum_0_5 / 128) = 1));
      end if;
      if (sums_sum_0_6 mod 2) = 1 then
        winnerswinner1_of_pair_0_6_choice := (not (((sums_sum_0_7 / 2) mod 2) = 1)) or (not ((sums_sum_0_7 mod 2) = 1));
      else
        winnerswinner1_of_pair_0_6_choice := not (((sums_sum_0_7 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_6 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_6_choice_2 := winnerswinner1_of_pair_0_6_choice;
      else
        winnerswinner1_of_pair_0_6_choice_2 := ((sums_sum_0_6 mod 2) = 1) and ((sums_sum_0_7 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_6_value := ((sums_sum_0_7 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_6_choice_2 then
        winnerswinner1_of_pair_0_6_choice_3 := (not (((sums_sum_0_6 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_6_value;
      else
        winnerswinner1_of_pair_0_6_choice_3 := (not (((sums_sum_0_6 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_6_value;
      end if;
      winnerswinner1_of_pair_0_6_value_2 := ((sums_sum_0_7 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_6_choice_3 then
        winnerswinner1_of_pair_0_6_choice_4 := (not (((sums_sum_0_6 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_6_value_2;
      else
        winnerswinner1_of_pair_0_6_choice_4 := (not (((sums_sum_0_6 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_6_value_2;
      end if;
      winnerswinner1_of_pair_0_6_value_3 := ((sums_sum_0_7 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_6_choice_4 then
        winnerswinner1_of_pair_0_6_choice_5 := (not (((sums_sum_0_6 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_6_value_3;
      else
        winnerswinner1_of_pair_0_6_choice_5 := (not (((sums_sum_0_6 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_6_value_3;
      end if;
      winnerswinner1_of_pair_0_6_value_4 := ((sums_sum_0_7 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_6_choice_5 then
        winnerswinner1_of_pair_0_6_choice_6 := (not (((sums_sum_0_6 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_6_value_4;
      else
        winnerswinner1_of_pair_0_6_choice_6 := (not (((sums_sum_0_6 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_6_value_4;
      end if;
      winnerswinner1_of_pair_0_6_value_5 := ((sums_sum_0_7 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_6_choice_6 then
        winnerswinner1_of_pair_0_6_choice_7 := (not (((sums_sum_0_6 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_6_value_5;
      else
        winnerswinner1_of_pair_0_6_choice_7 := (not (((sums_sum_0_6 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_6_value_5;
      end if;
      if winnerswinner1_of_pair_0_6_choice_7 then
        winnerswinner1_of_pair_0_6_choice_8 := ((sums_sum_0_6 / 128) = 1) and (not ((sums_sum_0_7 / 128) = 1));
      else
        winnerswinner1_of_pair_0_6_choice_8 := ((sums_sum_0_6 / 128) = 1) or (not ((sums_sum_0_7 / 128) = 1));
      end if;
      if (sums_sum_0_8 mod 2) = 1 then
        winnerswinner1_of_pair_0_8_choice := (not (((sums_sum_0_9 / 2) mod 2) = 1)) or (not ((sums_sum_0_9 mod 2) = 1));
      else
        winnerswinner1_of_pair_0_8_choice := not (((sums_sum_0_9 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_8 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_8_choice_2 := winnerswinner1_of_pair_0_8_choice;
      else
        winnerswinner1_of_pair_0_8_choice_2 := ((sums_sum_0_8 mod 2) = 1) and ((sums_sum_0_9 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_8_value := ((sums_sum_0_9 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_8_choice_2 then
        winnerswinner1_of_pair_0_8_choice_3 := (not (((sums_sum_0_8 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_8_value;
      else
        winnerswinner1_of_pair_0_8_choice_3 := (not (((sums_sum_0_8 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_8_value;
      end if;
      winnerswinner1_of_pair_0_8_value_2 := ((sums_sum_0_9 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_8_choice_3 then
        winnerswinner1_of_pair_0_8_choice_4 := (not (((sums_sum_0_8 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_8_value_2;
      else
        winnerswinner1_of_pair_0_8_choice_4 := (not (((sums_sum_0_8 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_8_value_2;
      end if;
      winnerswinner1_of_pair_0_8_value_3 := ((sums_sum_0_9 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_8_choice_4 then
        winnerswinner1_of_pair_0_8_choice_5 := (not (((sums_sum_0_8 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_8_value_3;
      else
        winnerswinner1_of_pair_0_8_choice_5 := (not (((sums_sum_0_8 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_8_value_3;
      end if;
      winnerswinner1_of_pair_0_8_value_4 := ((sums_sum_0_9 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_8_choice_5 then
        winnerswinner1_of_pair_0_8_choice_6 := (not (((sums_sum_0_8 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_8_value_4;
      else
        winnerswinner1_of_pair_0_8_choice_6 := (not (((sums_sum_0_8 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_8_value_4;
      end if;
      winnerswinner1_of_pair_0_8_value_5 := ((sums_sum_0_9 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_8_choice_6 then
        winnerswinner1_of_pair_0_8_choice_7 := (not (((sums_sum_0_8 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_8_value_5;
      else
        winnerswinner1_of_pair_0_8_choice_7 := (not (((sums_sum_0_8 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_8_value_5;
      end if;
      if winnerswinner1_of_pair_0_8_choice_7 then
        winnerswinner1_of_pair_0_8_choice_8 := ((sums_sum_0_8 / 128) = 1) and (not ((sums_sum_0_9 / 128) = 1));
      else
        winnerswinner1_of_pair_0_8_choice_8 := ((sums_sum_0_8 / 128) = 1) or (not ((sums_sum_0_9 / 128) = 1));
      end if;
      if (sums_sum_0_10 mod 2) = 1 then
        winnerswinner1_of_pair_0_10_choice := (not (((sums_sum_0_11 / 2) mod 2) = 1)) or (not ((sums_sum_0_11 mod 2) =
          1));
      else
        winnerswinner1_of_pair_0_10_choice := not (((sums_sum_0_11 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_10 / 2) mod 2) = 1 then
        winnerswinner1_of_pair_0_10_choice_2 := winnerswinner1_of_pair_0_10_choice;
      else
        winnerswinner1_of_pair_0_10_choice_2 := ((sums_sum_0_10 mod 2) = 1) and ((sums_sum_0_11 mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_10_value := ((sums_sum_0_11 / 4) mod 2) = 1;
      if winnerswinner1_of_pair_0_10_choice_2 then
        winnerswinner1_of_pair_0_10_choice_3 := (not (((sums_sum_0_10 / 4) mod 2) = 1)) and
          winnerswinner1_of_pair_0_10_value;
      else
        winnerswinner1_of_pair_0_10_choice_3 := (not (((sums_sum_0_10 / 4) mod 2) = 1)) or
          winnerswinner1_of_pair_0_10_value;
      end if;
      winnerswinner1_of_pair_0_10_value_2 := ((sums_sum_0_11 / 8) mod 2) = 1;
      if winnerswinner1_of_pair_0_10_choice_3 then
        winnerswinner1_of_pair_0_10_choice_4 := (not (((sums_sum_0_10 / 8) mod 2) = 1)) or
          winnerswinner1_of_pair_0_10_value_2;
      else
        winnerswinner1_of_pair_0_10_choice_4 := (not (((sums_sum_0_10 / 8) mod 2) = 1)) and
          winnerswinner1_of_pair_0_10_value_2;
      end if;
      winnerswinner1_of_pair_0_10_value_3 := ((sums_sum_0_11 / 16) mod 2) = 1;
      if winnerswinner1_of_pair_0_10_choice_4 then
        winnerswinner1_of_pair_0_10_choice_5 := (not (((sums_sum_0_10 / 16) mod 2) = 1)) or
          winnerswinner1_of_pair_0_10_value_3;
      else
        winnerswinner1_of_pair_0_10_choice_5 := (not (((sums_sum_0_10 / 16) mod 2) = 1)) and
          winnerswinner1_of_pair_0_10_value_3;
      end if;
      winnerswinner1_of_pair_0_10_value_4 := ((sums_sum_0_11 / 32) mod 2) = 1;
      if winnerswinner1_of_pair_0_10_choice_5 then
        winnerswinner1_of_pair_0_10_choice_6 := (not (((sums_sum_0_10 / 32) mod 2) = 1)) or
          winnerswinner1_of_pair_0_10_value_4;
      else
        winnerswinner1_of_pair_0_10_choice_6 := (not (((sums_sum_0_10 / 32) mod 2) = 1)) and
          winnerswinner1_of_pair_0_10_value_4;
      end if;
      winnerswinner1_of_pair_0_10_value_5 := ((sums_sum_0_11 / 64) mod 2) = 1;
      if winnerswinner1_of_pair_0_10_choice_6 then
        winnerswinner1_of_pair_0_10_choice_7 := (not (((sums_sum_0_10 / 64) mod 2) = 1)) or
          winnerswinner1_of_pair_0_10_value_5;
      else
        winnerswinner1_of_pair_0_10_choice_7 := (not (((sums_sum_0_10 / 64) mod 2) = 1)) and
          winnerswinner1_of_pair_0_10_value_5;
      end if;
      if winnerswinner1_of_pair_0_10_choice_7 then
        winnerswinner1_of_pair_0_10_choice_8 := ((sums_sum_0_10 / 128) = 1) and (not ((sums_sum_0_11 / 128) = 1));
      else
        winnerswinner1_of_pair_0_10_choice_8 := ((sums_sum_0_10 / 128) = 1) or (not ((sums_sum_0_11 / 128) = 1));
      end if;
      if (winnerswinner1_of_pair_0_1 mod 2) = 1 then
        winnerswinner1_of_four_0_0_choice := (not ((winnerswinner1_of_pair_0_3 mod 2) = 1)) and (not
          ((winnerswinner1_of_pair_0_2 mod 2) = 1));
      else
        winnerswinner1_of_four_0_0_choice := ((winnerswinner1_of_pair_0_0 mod 2) = 1) and (not
          ((winnerswinner1_of_pair_0_3 mod 2) = 1)) and (not ((winnerswinner1_of_pair_0_2 mod 2) = 1));
      end if;
      winnerswinner1_of_four_0_0_value := ((winnerswinner1_of_pair_0_1 / 2) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_2 := ((winnerswinner1_of_pair_0_0 / 2) mod 2) = 1;
      if (not (((winnerswinner1_of_pair_0_3 / 2) mod 2) = 1)) and (not (((winnerswinner1_of_pair_0_2 / 2) mod 2) = 1))
        then
        winnerswinner1_of_four_0_0_choice_2 := winnerswinner1_of_four_0_0_choice or winnerswinner1_of_four_0_0_value or
          winnerswinner1_of_four_0_0_value_2;
      else
        winnerswinner1_of_four_0_0_choice_2 := winnerswinner1_of_four_0_0_choice and (winnerswinner1_of_four_0_0_value
          or winnerswinner1_of_four_0_0_value_2);
      end if;
      winnerswinner1_of_four_0_0_value_3 := ((winnerswinner1_of_pair_0_3 / 4) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_4 := ((winnerswinner1_of_pair_0_2 / 4) mod 2) = 1;
      if winnerswinner1_of_four_0_0_choice_2 then
        winnerswinner1_of_four_0_0_choice_3 := (not (((winnerswinner1_of_pair_0_1 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 4) mod 2) = 1)) and (winnerswinner1_of_four_0_0_value_3 or
          winnerswinner1_of_four_0_0_value_4);
      else
        winnerswinner1_of_four_0_0_choice_3 := ((not (((winnerswinner1_of_pair_0_1 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 4) mod 2) = 1))) or winnerswinner1_of_four_0_0_value_3 or
          winnerswinner1_of_four_0_0_value_4;
      end if;
      winnerswinner1_of_four_0_0_value_5 := ((winnerswinner1_of_pair_0_3 / 8) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_6 := ((winnerswinner1_of_pair_0_2 / 8) mod 2) = 1;
      if winnerswinner1_of_four_0_0_choice_3 then
        winnerswinner1_of_four_0_0_choice_4 := ((not (((winnerswinner1_of_pair_0_1 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 8) mod 2) = 1))) or winnerswinner1_of_four_0_0_value_5 or
          winnerswinner1_of_four_0_0_value_6;
      else
        winnerswinner1_of_four_0_0_choice_4 := (not (((winnerswinner1_of_pair_0_1 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 8) mod 2) = 1)) and (winnerswinner1_of_four_0_0_value_5 or
          winnerswinner1_of_four_0_0_value_6);
      end if;
      winnerswinner1_of_four_0_0_value_7 := ((winnerswinner1_of_pair_0_3 / 16) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_8 := ((winnerswinner1_of_pair_0_2 / 16) mod 2) = 1;
      if winnerswinner1_of_four_0_0_choice_4 then
        winnerswinner1_of_four_0_0_choice_5 := ((not (((winnerswinner1_of_pair_0_1 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 16) mod 2) = 1))) or winnerswinner1_of_four_0_0_value_7 or
          winnerswinner1_of_four_0_0_value_8;
      else
        winnerswinner1_of_four_0_0_choice_5 := (not (((winnerswinner1_of_pair_0_1 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 16) mod 2) = 1)) and (winnerswinner1_of_four_0_0_value_7 or
          winnerswinner1_of_four_0_0_value_8);
      end if;
      winnerswinner1_of_four_0_0_value_9 := ((winnerswinner1_of_pair_0_3 / 32) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_10 := ((winnerswinner1_of_pair_0_2 / 32) mod 2) = 1;
      if winnerswinner1_of_four_0_0_choice_5 then
        winnerswinner1_of_four_0_0_choice_6 := ((not (((winnerswinner1_of_pair_0_1 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 32) mod 2) = 1))) or winnerswinner1_of_four_0_0_value_9 or
          winnerswinner1_of_four_0_0_value_10;
      else
        winnerswinner1_of_four_0_0_choice_6 := (not (((winnerswinner1_of_pair_0_1 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 32) mod 2) = 1)) and (winnerswinner1_of_four_0_0_value_9 or
          winnerswinner1_of_four_0_0_value_10);
      end if;
      winnerswinner1_of_four_0_0_value_11 := ((winnerswinner1_of_pair_0_3 / 64) mod 2) = 1;
      winnerswinner1_of_four_0_0_value_12 := ((winnerswinner1_of_pair_0_2 / 64) mod 2) = 1;
      if winnerswinner1_of_four_0_0_choice_6 then
        winnerswinner1_of_four_0_0_choice_7 := ((not (((winnerswinner1_of_pair_0_1 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 64) mod 2) = 1))) or winnerswinner1_of_four_0_0_value_11 or
          winnerswinner1_of_four_0_0_value_12;
      else
        winnerswinner1_of_four_0_0_choice_7 := (not (((winnerswinner1_of_pair_0_1 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_0 / 64) mod 2) = 1)) and (winnerswinner1_of_four_0_0_value_11 or
          winnerswinner1_of_four_0_0_value_12);
      end if;
      if winnerswinner1_of_four_0_0_choice_7 then
        winnerswinner1_of_four_0_0_choice_8 := (not ((not ((winnerswinner1_of_pair_0_1 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_0 / 128) = 1)))) and (not ((winnerswinner1_of_pair_0_3 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_2 / 128) = 1));
      else
        winnerswinner1_of_four_0_0_choice_8 := (not ((not ((winnerswinner1_of_pair_0_1 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_0 / 128) = 1)))) or ((not ((winnerswinner1_of_pair_0_3 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_2 / 128) = 1)));
      end if;
      if (winnerswinner1_of_pair_0_5 mod 2) = 1 then
        winnerswinner1_of_four_0_4_choice := (not ((winnerswinner1_of_pair_0_7 mod 2) = 1)) and (not
          ((winnerswinner1_of_pair_0_6 mod 2) = 1));
      else
        winnerswinner1_of_four_0_4_choice := ((winnerswinner1_of_pair_0_4 mod 2) = 1) and (not
          ((winnerswinner1_of_pair_0_7 mod 2) = 1)) and (not ((winnerswinner1_of_pair_0_6 mod 2) = 1));
      end if;
      winnerswinner1_of_four_0_4_value := ((winnerswinner1_of_pair_0_5 / 2) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_2 := ((winnerswinner1_of_pair_0_4 / 2) mod 2) = 1;
      if (not (((winnerswinner1_of_pair_0_7 / 2) mod 2) = 1)) and (not (((winnerswinner1_of_pair_0_6 / 2) mod 2) = 1))
        then
        winnerswinner1_of_four_0_4_choice_2 := winnerswinner1_of_four_0_4_choice or winnerswinner1_of_four_0_4_value or
          winnerswinner1_of_four_0_4_value_2;
      else
        winnerswinner1_of_four_0_4_choice_2 := winnerswinner1_of_four_0_4_choice and (winnerswinner1_of_four_0_4_value
          or winnerswinner1_of_four_0_4_value_2);
      end if;
      winnerswinner1_of_four_0_4_value_3 := ((winnerswinner1_of_pair_0_7 / 4) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_4 := ((winnerswinner1_of_pair_0_6 / 4) mod 2) = 1;
      if winnerswinner1_of_four_0_4_choice_2 then
        winnerswinner1_of_four_0_4_choice_3 := (not (((winnerswinner1_of_pair_0_5 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 4) mod 2) = 1)) and (winnerswinner1_of_four_0_4_value_3 or
          winnerswinner1_of_four_0_4_value_4);
      else
        winnerswinner1_of_four_0_4_choice_3 := ((not (((winnerswinner1_of_pair_0_5 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 4) mod 2) = 1))) or winnerswinner1_of_four_0_4_value_3 or
          winnerswinner1_of_four_0_4_value_4;
      end if;
      winnerswinner1_of_four_0_4_value_5 := ((winnerswinner1_of_pair_0_7 / 8) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_6 := ((winnerswinner1_of_pair_0_6 / 8) mod 2) = 1;
      if winnerswinner1_of_four_0_4_choice_3 then
        winnerswinner1_of_four_0_4_choice_4 := ((not (((winnerswinner1_of_pair_0_5 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 8) mod 2) = 1))) or winnerswinner1_of_four_0_4_value_5 or
          winnerswinner1_of_four_0_4_value_6;
      else
        winnerswinner1_of_four_0_4_choice_4 := (not (((winnerswinner1_of_pair_0_5 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 8) mod 2) = 1)) and (winnerswinner1_of_four_0_4_value_5 or
          winnerswinner1_of_four_0_4_value_6);
      end if;
      winnerswinner1_of_four_0_4_value_7 := ((winnerswinner1_of_pair_0_7 / 16) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_8 := ((winnerswinner1_of_pair_0_6 / 16) mod 2) = 1;
      if winnerswinner1_of_four_0_4_choice_4 then
        winnerswinner1_of_four_0_4_choice_5 := ((not (((winnerswinner1_of_pair_0_5 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 16) mod 2) = 1))) or winnerswinner1_of_four_0_4_value_7 or
          winnerswinner1_of_four_0_4_value_8;
      else
        winnerswinner1_of_four_0_4_choice_5 := (not (((winnerswinner1_of_pair_0_5 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 16) mod 2) = 1)) and (winnerswinner1_of_four_0_4_value_7 or
          winnerswinner1_of_four_0_4_value_8);
      end if;
      winnerswinner1_of_four_0_4_value_9 := ((winnerswinner1_of_pair_0_7 / 32) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_10 := ((winnerswinner1_of_pair_0_6 / 32) mod 2) = 1;
      if winnerswinner1_of_four_0_4_choice_5 then
        winnerswinner1_of_four_0_4_choice_6 := ((not (((winnerswinner1_of_pair_0_5 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 32) mod 2) = 1))) or winnerswinner1_of_four_0_4_value_9 or
          winnerswinner1_of_four_0_4_value_10;
      else
        winnerswinner1_of_four_0_4_choice_6 := (not (((winnerswinner1_of_pair_0_5 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 32) mod 2) = 1)) and (winnerswinner1_of_four_0_4_value_9 or
          winnerswinner1_of_four_0_4_value_10);
      end if;
      winnerswinner1_of_four_0_4_value_11 := ((winnerswinner1_of_pair_0_7 / 64) mod 2) = 1;
      winnerswinner1_of_four_0_4_value_12 := ((winnerswinner1_of_pair_0_6 / 64) mod 2) = 1;
      if winnerswinner1_of_four_0_4_choice_6 then
        winnerswinner1_of_four_0_4_choice_7 := ((not (((winnerswinner1_of_pair_0_5 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 64) mod 2) = 1))) or winnerswinner1_of_four_0_4_value_11 or
          winnerswinner1_of_four_0_4_value_12;
      else
        winnerswinner1_of_four_0_4_choice_7 := (not (((winnerswinner1_of_pair_0_5 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_4 / 64) mod 2) = 1)) and (winnerswinner1_of_four_0_4_value_11 or
          winnerswinner1_of_four_0_4_value_12);
      end if;
      if winnerswinner1_of_four_0_4_choice_7 then
        winnerswinner1_of_four_0_4_choice_8 := (not ((not ((winnerswinner1_of_pair_0_5 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_4 / 128) = 1)))) and (not ((winnerswinner1_of_pair_0_7 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_6 / 128) = 1));
      else
        winnerswinner1_of_four_0_4_choice_8 := (not ((not ((winnerswinner1_of_pair_0_5 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_4 / 128) = 1)))) or ((not ((winnerswinner1_of_pair_0_7 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_6 / 128) = 1)));
      end if;
      if (winnerswinner1_of_pair_0_9 mod 2) = 1 then
        winnerswinner1_of_four_0_8_choice := (not ((winnerswinner1_of_pair_0_11 mod 2) = 1)) and (not
          ((winnerswinner1_of_pair_0_10 mod 2) = 1));
      else
        winnerswinner1_of_four_0_8_choice := ((winnerswinner1_of_pair_0_8 mod 2) = 1) and (not
          ((winnerswinner1_of_pair_0_11 mod 2) = 1)) and (not ((winnerswinner1_of_pair_0_10 mod 2) = 1));
      end if;
      winnerswinner1_of_four_0_8_value := ((winnerswinner1_of_pair_0_9 / 2) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_2 := ((winnerswinner1_of_pair_0_8 / 2) mod 2) = 1;
      if (not (((winnerswinner1_of_pair_0_11 / 2) mod 2) = 1)) and (not (((winnerswinner1_of_pair_0_10 / 2) mod 2) =
        1)) then
        winnerswinner1_of_four_0_8_choice_2 := winnerswinner1_of_four_0_8_choice or winnerswinner1_of_four_0_8_value or
          winnerswinner1_of_four_0_8_value_2;
      else
        winnerswinner1_of_four_0_8_choice_2 := winnerswinner1_of_four_0_8_choice and (winnerswinner1_of_four_0_8_value
          or winnerswinner1_of_four_0_8_value_2);
      end if;
      winnerswinner1_of_four_0_8_value_3 := ((winnerswinner1_of_pair_0_11 / 4) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_4 := ((winnerswinner1_of_pair_0_10 / 4) mod 2) = 1;
      if winnerswinner1_of_four_0_8_choice_2 then
        winnerswinner1_of_four_0_8_choice_3 := (not (((winnerswinner1_of_pair_0_9 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 4) mod 2) = 1)) and (winnerswinner1_of_four_0_8_value_3 or
          winnerswinner1_of_four_0_8_value_4);
      else
        winnerswinner1_of_four_0_8_choice_3 := ((not (((winnerswinner1_of_pair_0_9 / 4) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 4) mod 2) = 1))) or winnerswinner1_of_four_0_8_value_3 or
          winnerswinner1_of_four_0_8_value_4;
      end if;
      winnerswinner1_of_four_0_8_value_5 := ((winnerswinner1_of_pair_0_11 / 8) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_6 := ((winnerswinner1_of_pair_0_10 / 8) mod 2) = 1;
      if winnerswinner1_of_four_0_8_choice_3 then
        winnerswinner1_of_four_0_8_choice_4 := ((not (((winnerswinner1_of_pair_0_9 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 8) mod 2) = 1))) or winnerswinner1_of_four_0_8_value_5 or
          winnerswinner1_of_four_0_8_value_6;
      else
        winnerswinner1_of_four_0_8_choice_4 := (not (((winnerswinner1_of_pair_0_9 / 8) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 8) mod 2) = 1)) and (winnerswinner1_of_four_0_8_value_5 or
          winnerswinner1_of_four_0_8_value_6);
      end if;
      winnerswinner1_of_four_0_8_value_7 := ((winnerswinner1_of_pair_0_11 / 16) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_8 := ((winnerswinner1_of_pair_0_10 / 16) mod 2) = 1;
      if winnerswinner1_of_four_0_8_choice_4 then
        winnerswinner1_of_four_0_8_choice_5 := ((not (((winnerswinner1_of_pair_0_9 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 16) mod 2) = 1))) or winnerswinner1_of_four_0_8_value_7 or
          winnerswinner1_of_four_0_8_value_8;
      else
        winnerswinner1_of_four_0_8_choice_5 := (not (((winnerswinner1_of_pair_0_9 / 16) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 16) mod 2) = 1)) and (winnerswinner1_of_four_0_8_value_7 or
          winnerswinner1_of_four_0_8_value_8);
      end if;
      winnerswinner1_of_four_0_8_value_9 := ((winnerswinner1_of_pair_0_11 / 32) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_10 := ((winnerswinner1_of_pair_0_10 / 32) mod 2) = 1;
      if winnerswinner1_of_four_0_8_choice_5 then
        winnerswinner1_of_four_0_8_choice_6 := ((not (((winnerswinner1_of_pair_0_9 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 32) mod 2) = 1))) or winnerswinner1_of_four_0_8_value_9 or
          winnerswinner1_of_four_0_8_value_10;
      else
        winnerswinner1_of_four_0_8_choice_6 := (not (((winnerswinner1_of_pair_0_9 / 32) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 32) mod 2) = 1)) and (winnerswinner1_of_four_0_8_value_9 or
          winnerswinner1_of_four_0_8_value_10);
      end if;
      winnerswinner1_of_four_0_8_value_11 := ((winnerswinner1_of_pair_0_11 / 64) mod 2) = 1;
      winnerswinner1_of_four_0_8_value_12 := ((winnerswinner1_of_pair_0_10 / 64) mod 2) = 1;
      if winnerswinner1_of_four_0_8_choice_6 then
        winnerswinner1_of_four_0_8_choice_7 := ((not (((winnerswinner1_of_pair_0_9 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 64) mod 2) = 1))) or winnerswinner1_of_four_0_8_value_11 or
          winnerswinner1_of_four_0_8_value_12;
      else
        winnerswinner1_of_four_0_8_choice_7 := (not (((winnerswinner1_of_pair_0_9 / 64) mod 2) = 1)) and (not
          (((winnerswinner1_of_pair_0_8 / 64) mod 2) = 1)) and (winnerswinner1_of_four_0_8_value_11 or
          winnerswinner1_of_four_0_8_value_12);
      end if;
      if winnerswinner1_of_four_0_8_choice_7 then
        winnerswinner1_of_four_0_8_choice_8 := (not ((not ((winnerswinner1_of_pair_0_9 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_8 / 128) = 1)))) and (not ((winnerswinner1_of_pair_0_11 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_10 / 128) = 1));
      else
        winnerswinner1_of_four_0_8_choice_8 := (not ((not ((winnerswinner1_of_pair_0_9 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_8 / 128) = 1)))) or ((not ((winnerswinner1_of_pair_0_11 / 128) = 1)) and (not
          ((winnerswinner1_of_pair_0_10 / 128) = 1)));
      end if;
      winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_0_choice_8;
      winnerswinner1_pair_tag_valid <= sums_tag_valid;
      winnerswinner1_pair_tag_map_column <= sums_tag_map_column;
      winnerswinner1_pair_tag_output_column <= sums_tag_output_column;
      winnerswinner1_pair_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_pair_tag_end_of_line <= sums_tag_end_of_line;
      winnerswinner1_four_tag_valid <= winnerswinner1_pair_tag_valid;
      winnerswinner1_four_tag_map_column <= winnerswinner1_pair_tag_map_column;
      winnerswinner1_four_tag_output_column <= winnerswinner1_pair_tag_output_column;
      winnerswinner1_four_tag_start_of_frame <= winnerswinner1_pair_tag_start_of_frame;
      winnerswinner1_four_tag_end_of_line <= winnerswinner1_pair_tag_end_of_line;
      winnerswinner1_best_cost_0_0 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_2, 8)) or
        (to_unsigned(winnerswinner1_of_four_0_3, 8)))) or (to_unsigned(winnerswinner1_of_four_0_1, 8)))) or
        (to_unsigned(winnerswinner1_of_four_0_0, 8))));
      winnerswinner1_best_cost_0_1 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_6, 8)) or
        (to_unsigned(winnerswinner1_of_four_0_7, 8)))) or (to_unsigned(winnerswinner1_of_four_0_5, 8)))) or
        (to_unsigned(winnerswinner1_of_four_0_4, 8))));
      winnerswinner1_best_cost_0_2 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_10, 8)) or
        (to_unsigned(winnerswinner1_of_four_0_11, 8)))) or (to_unsigned(winnerswinner1_of_four_0_9, 8)))) or
        (to_unsigned(winnerswinner1_of_four_0_8, 8))));
      winnerswinner1_best_index_0_0 <= winnerswinner1_four_index_0_0;
      winnerswinner1_best_index_0_1 <= winnerswinner1_four_index_0_1;
      winnerswinner1_best_index_0_2 <= winnerswinner1_four_index_0_2;
      winnerswinner1_tag_valid <= winnerswinner1_four_tag_valid;
      winnerswinner1_tag_map_column <= winnerswinner1_four_tag_map_column;
      winnerswinner1_tag_output_column <= winnerswinner1_four_tag_output_column;
      winnerswinner1_tag_start_of_frame <= winnerswinner1_four_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= winnerswinner1_four_tag_end_of_line;
      if winnerswinner1_of_pair_0_0_choice_8 then
        winnerswinner1_of_pair_0_0 <= 0;
        winnerswinner1_of_pair_0_1 <= sums_sum_0_1;
      else
        winnerswinner1_of_pair_0_0 <= sums_sum_0_0;
        winnerswinner1_of_pair_0_1 <= 0;
      end if;
      if winnerswinner1_of_pair_0_2_choice_8 then
        winnerswinner1_of_pair_0_2 <= 0;
        winnerswinner1_of_pair_0_3 <= sums_sum_0_3;
        winnerswinner1_pair_index_0_1 <= 3;
      else
        winnerswinner1_of_pair_0_2 <= sums_sum_0_2;
        winnerswinner1_of_pair_0_3 <= 0;
        winnerswinner1_pair_index_0_1 <= 2;
      end if;
      if winnerswinner1_of_pair_0_4_choice_8 then
        winnerswinner1_of_pair_0_4 <= 0;
        winnerswinner1_of_pair_0_5 <= sums_sum_0_5;
        winnerswinner1_pair_index_0_2 <= 5;
      else
        winnerswinner1_of_pair_0_4 <= sums_sum_0_4;
        winnerswinner1_of_pair_0_5 <= 0;
        winnerswinner1_pair_index_0_2 <= 4;
      end if;
      if winnerswinner1_of_pair_0_6_choice_8 then
        winnerswinner1_of_pair_0_6 <= 0;
        winnerswinner1_of_pair_0_7 <= sums_sum_0_7;
        winnerswinner1_pair_index_0_3 <= 7;
      else
        winnerswinner1_of_pair_0_6 <= sums_sum_0_6;
        winnerswinner1_of_pair_0_7 <= 0;
        winnerswinner1_pair_index_0_3 <= 6;
      end if;
      if winnerswinner1_of_pair_0_8_choice_8 then
        winnerswinner1_of_pair_0_8 <= 0;
        winnerswinner1_of_pair_0_9 <= sums_sum_0_9;
        winnerswinner1_pair_index_0_4 <= 9;
      else
        winnerswinner1_of_pair_0_8 <= sums_sum_0_8;
        winnerswinner1_of_pair_0_9 <= 0;
        winnerswinner1_pair_index_0_4 <= 8;
      end if;
      if winnerswinner1_of_pair_0_10_choice_8 then
        winnerswinner1_of_pair_0_10 <= 0;
        winnerswinner1_of_pair_0_11 <= sums_sum_0_11;
        winnerswinner1_pair_index_0_5 <= 11;
      else
        winnerswinner1_of_pair_0_10 <= sums_sum_0_10;
        winnerswinner1_of_pair_0_11 <= 0;
        winnerswinner1_pair_index_0_5 <= 10;
      end if;
      if winnerswinner1_of_four_0_0_choice_8 then
        winnerswinner1_of_four_0_0 <= 0;
        winnerswinner1_of_four_0_1 <= 0;
        winnerswinner1_of_four_0_2 <= winnerswinner1_of_pair_0_2;
        winnerswinner1_of_four_0_3 <= winnerswinner1_of_pair_0_3;
        winnerswinner1_four_index_0_0 <= winnerswinner1_pair_index_0_1;
      else
        winnerswinner1_of_four_0_0 <= winnerswinner1_of_pair_0_0;
        winnerswinner1_of_four_0_1 <= winnerswinner1_of_pair_0_1;
        winnerswinner1_of_four_0_2 <= 0;
        winnerswinner1_of_four_0_3 <= 0;
        winnerswinner1_four_index_0_0 <= as_number(winnerswinner1_pair_index_0_0);
      end if;
      if winnerswinner1_of_four_0_4_choice_8 then
        winnerswinner1_of_four_0_4 <= 0;
        winnerswinner1_of_four_0_5 <= 0;
        winnerswinner1_of_four_0_6 <= winnerswinner1_of_pair_0_6;
        winnerswinner1_of_four_0_7 <= winnerswinner1_of_pair_0_7;
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_3;
      else
        winnerswinner1_of_four_0_4 <= winnerswinner1_of_pair_0_4;
        winnerswinner1_of_four_0_5 <= winnerswinner1_of_pair_0_5;
        winnerswinner1_of_four_0_6 <= 0;
        winnerswinner1_of_four_0_7 <= 0;
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_2;
      end if;
      if winnerswinner1_of_four_0_8_choice_8 then
        winnerswinner1_of_four_0_8 <= 0;
        winnerswinner1_of_four_0_9 <= 0;
        winnerswinner1_of_four_0_10 <= winnerswinner1_of_pair_0_10;
        winnerswinner1_of_four_0_11 <= winnerswinner1_of_pair_0_11;
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_5;
      else
        winnerswinner1_of_four_0_8 <= winnerswinner1_of_pair_0_8;
        winnerswinner1_of_four_0_9 <= winnerswinner1_of_pair_0_9;
        winnerswinner1_of_four_0_10 <= 0;
        winnerswinner1_of_four_0_11 <= 0;
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_4;
      end if;
      -- winnerswinner2
      if (winnerswinner1_best_cost_0_0 mod 2) = 1 then
        winnerswinner2_of_pair_0_0_choice := (not (((winnerswinner1_best_cost_0_1 / 2) mod 2) = 1)) or (not
          ((winnerswinner1_best_cost_0_1 mod 2) = 1));
      else
        winnerswinner2_of_pair_0_0_choice := not (((winnerswinner1_best_cost_0_1 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner1_best_cost_0_0 / 2) mod 2) = 1 then
        winnerswinner2_of_pair_0_0_choice_2 := winnerswinner2_of_pair_0_0_choice;
      else
        winnerswinner2_of_pair_0_0_choice_2 := ((winnerswinner1_best_cost_0_0 mod 2) = 1) and
          ((winnerswinner1_best_cost_0_1 mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_0_value := ((winnerswinner1_best_cost_0_1 / 4) mod 2) = 1;
      if winnerswinner2_of_pair_0_0_choice_2 then
        winnerswinner2_of_pair_0_0_choice_3 := (not (((winnerswinner1_best_cost_0_0 / 4) mod 2) = 1)) and
          winnerswinner2_of_pair_0_0_value;
      else
        winnerswinner2_of_pair_0_0_choice_3 := (not (((winnerswinner1_best_cost_0_0 / 4) mod 2) = 1)) or
          winnerswinner2_of_pair_0_0_value;
      end if;
      winnerswinner2_of_pair_0_0_value_2 := ((winnerswinner1_best_cost_0_1 / 8) mod 2) = 1;
      if winnerswinner2_of_pair_0_0_choice_3 then
        winnerswinner2_of_pair_0_0_choice_4 := (not (((winnerswinner1_best_cost_0_0 / 8) mod 2) = 1)) or
          winnerswinner2_of_pair_0_0_value_2;
      else
        winnerswinner2_of_pair_0_0_choice_4 := (not (((winnerswinner1_best_cost_0_0 / 8) mod 2) = 1)) and
          winnerswinner2_of_pair_0_0_value_2;
      end if;
      winnerswinner2_of_pair_0_0_value_3 := ((winnerswinner1_best_cost_0_1 / 16) mod 2) = 1;
      if winnerswinner2_of_pair_0_0_choice_4 then
        winnerswinner2_of_pair_0_0_choice_5 := (not (((winnerswinner1_best_cost_0_0 / 16) mod 2) = 1)) or
          winnerswinner2_of_pair_0_0_value_3;
      else
        winnerswinner2_of_pair_0_0_choice_5 := (not (((winnerswinner1_best_cost_0_0 / 16) mod 2) = 1)) and
          winnerswinner2_of_pair_0_0_value_3;
      end if;
      winnerswinner2_of_pair_0_0_value_4 := ((winnerswinner1_best_cost_0_1 / 32) mod 2) = 1;
      if winnerswinner2_of_pair_0_0_choice_5 then
        winnerswinner2_of_pair_0_0_choice_6 := (not (((winnerswinner1_best_cost_0_0 / 32) mod 2) = 1)) or
          winnerswinner2_of_pair_0_0_value_4;
      else
        winnerswinner2_of_pair_0_0_choice_6 := (not (((winnerswinner1_best_cost_0_0 / 32) mod 2) = 1)) and
          winnerswinner2_of_pair_0_0_value_4;
      end if;
      winnerswinner2_of_pair_0_0_value_5 := ((winnerswinner1_best_cost_0_1 / 64) mod 2) = 1;
      if winnerswinner2_of_pair_0_0_choice_6 then
        winnerswinner2_of_pair_0_0_choice_7 := (not (((winnerswinner1_best_cost_0_0 / 64) mod 2) = 1)) or
          winnerswinner2_of_pair_0_0_value_5;
      else
        winnerswinner2_of_pair_0_0_choice_7 := (not (((winnerswinner1_best_cost_0_0 / 64) mod 2) = 1)) and
          winnerswinner2_of_pair_0_0_value_5;
      end if;
      if winnerswinner2_of_pair_0_0_choice_7 then
        winnerswinner2_of_pair_0_0_choice_8 := ((winnerswinner1_best_cost_0_0 / 128) = 1) and (not
          ((winnerswinner1_best_cost_0_1 / 128) = 1));
      else
        winnerswinner2_of_pair_0_0_choice_8 := ((winnerswinner1_best_cost_0_0 / 128) = 1) or (not
          ((winnerswinner1_best_cost_0_1 / 128) = 1));
      end if;
      winnerswinner2_four_index_0_0_value := ((winnerswinner2_of_pair_0_1 / 2) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_2 := ((winnerswinner2_of_pair_0_0 / 2) mod 2) = 1;
      if (not ((winnerswinner2_of_pair_0_2 mod 2) = 1)) and (((winnerswinner2_of_pair_0_1 mod 2) = 1) or
        ((winnerswinner2_of_pair_0_0 mod 2) = 1)) then
        winnerswinner2_four_index_0_0_choice := (not (((winnerswinner2_of_pair_0_2 / 2) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value or winnerswinner2_four_index_0_0_value_2;
      else
        winnerswinner2_four_index_0_0_choice := (not (((winnerswinner2_of_pair_0_2 / 2) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value or winnerswinner2_four_index_0_0_value_2);
      end if;
      winnerswinner2_four_index_0_0_value_3 := ((winnerswinner2_of_pair_0_1 / 4) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_4 := ((winnerswinner2_of_pair_0_0 / 4) mod 2) = 1;
      if winnerswinner2_four_index_0_0_choice then
        winnerswinner2_four_index_0_0_choice_2 := (not (((winnerswinner2_of_pair_0_2 / 4) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value_3 or winnerswinner2_four_index_0_0_value_4;
      else
        winnerswinner2_four_index_0_0_choice_2 := (not (((winnerswinner2_of_pair_0_2 / 4) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value_3 or winnerswinner2_four_index_0_0_value_4);
      end if;
      winnerswinner2_four_index_0_0_value_5 := ((winnerswinner2_of_pair_0_1 / 8) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_6 := ((winnerswinner2_of_pair_0_0 / 8) mod 2) = 1;
      if winnerswinner2_four_index_0_0_choice_2 then
        winnerswinner2_four_index_0_0_choice_3 := (not (((winnerswinner2_of_pair_0_2 / 8) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value_5 or winnerswinner2_four_index_0_0_value_6;
      else
        winnerswinner2_four_index_0_0_choice_3 := (not (((winnerswinner2_of_pair_0_2 / 8) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value_5 or winnerswinner2_four_index_0_0_value_6);
      end if;
      winnerswinner2_four_index_0_0_value_7 := ((winnerswinner2_of_pair_0_1 / 16) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_8 := ((winnerswinner2_of_pair_0_0 / 16) mod 2) = 1;
      if winnerswinner2_four_index_0_0_choice_3 then
        winnerswinner2_four_index_0_0_choice_4 := (not (((winnerswinner2_of_pair_0_2 / 16) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value_7 or winnerswinner2_four_index_0_0_value_8;
      else
        winnerswinner2_four_index_0_0_choice_4 := (not (((winnerswinner2_of_pair_0_2 / 16) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value_7 or winnerswinner2_four_index_0_0_value_8);
      end if;
      winnerswinner2_four_index_0_0_value_9 := ((winnerswinner2_of_pair_0_1 / 32) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_10 := ((winnerswinner2_of_pair_0_0 / 32) mod 2) = 1;
      if winnerswinner2_four_index_0_0_choice_4 then
        winnerswinner2_four_index_0_0_choice_5 := (not (((winnerswinner2_of_pair_0_2 / 32) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value_9 or winnerswinner2_four_index_0_0_value_10;
      else
        winnerswinner2_four_index_0_0_choice_5 := (not (((winnerswinner2_of_pair_0_2 / 32) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value_9 or winnerswinner2_four_index_0_0_value_10);
      end if;
      winnerswinner2_four_index_0_0_value_11 := ((winnerswinner2_of_pair_0_1 / 64) mod 2) = 1;
      winnerswinner2_four_index_0_0_value_12 := ((winnerswinner2_of_pair_0_0 / 64) mod 2) = 1;
      if winnerswinner2_four_index_0_0_choice_5 then
        winnerswinner2_four_index_0_0_choice_6 := (not (((winnerswinner2_of_pair_0_2 / 64) mod 2) = 1)) or
          winnerswinner2_four_index_0_0_value_11 or winnerswinner2_four_index_0_0_value_12;
      else
        winnerswinner2_four_index_0_0_choice_6 := (not (((winnerswinner2_of_pair_0_2 / 64) mod 2) = 1)) and
          (winnerswinner2_four_index_0_0_value_11 or winnerswinner2_four_index_0_0_value_12);
      end if;
      if winnerswinner2_four_index_0_0_choice_6 then
        winnerswinner2_four_index_0_0_choice_7 := (not ((winnerswinner2_of_pair_0_2 / 128) = 1)) or
          ((winnerswinner2_of_pair_0_1 / 128) = 1) or ((winnerswinner2_of_pair_0_0 / 128) = 1);
      else
        winnerswinner2_four_index_0_0_choice_7 := (not ((winnerswinner2_of_pair_0_2 / 128) = 1)) and
          (((winnerswinner2_of_pair_0_1 / 128) = 1) or ((winnerswinner2_of_pair_0_0 / 128) = 1));
      end if;
      winnerswinner2_of_pair_0_2 <= winnerswinner1_best_cost_0_2;
      winnerswinner2_pair_index_0_1 <= winnerswinner1_best_index_0_2;
      winnerswinner2_pair_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_pair_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_pair_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_pair_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_pair_tag_end_of_line <= winnerswinner1_tag_end_of_line;
      winnerswinner2_four_tag_valid <= winnerswinner2_pair_tag_valid;
      winnerswinner2_four_tag_map_column <= winnerswinner2_pair_tag_map_column;
      winnerswinner2_four_tag_output_column <= winnerswinner2_pair_tag_output_column;
      winnerswinner2_four_tag_start_of_frame <= winnerswinner2_pair_tag_start_of_frame;
      winnerswinner2_four_tag_end_of_line <= winnerswinner2_pair_tag_end_of_line;
      winnerswinner2_best_index_0_0 <= winnerswinner2_four_index_0_0;
      winnerswinner2_tag_valid <= winnerswinner2_four_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner2_four_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner2_four_tag_output_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner2_four_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner2_four_tag_end_of_line;
      if winnerswinner2_of_pair_0_0_choice_8 then
        winnerswinner2_of_pair_0_0 <= 0;
        winnerswinner2_of_pair_0_1 <= winnerswinner1_best_cost_0_1;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_of_pair_0_0 <= winnerswinner1_best_cost_0_0;
        winnerswinner2_of_pair_0_1 <= 0;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_0;
      end if;
      if winnerswinner2_four_index_0_0_choice_7 then
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_1;
      else
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_0;
      end if;
      -- winners
      winners_best_index_0_0 <= winnerswinner2_best_index_0_0;
      winners_best_tag_valid <= winnerswinner2_tag_valid;
      winners_best_tag_map_column <= winnerswinner2_tag_map_column;
      winners_best_tag_output_column <= winnerswinner2_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      -- turn
      turn_order_address_any := turn_order_inside or (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 31;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 7;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 32;
        else
          turn_order_address <= turn_order_address_choice_2 * 4;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and winners_best_tag_map_column and winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      if turn_order_falls_all then
        turn_order_turned_output_column_choice := turn_order_output and turn_order_complete;
      else
        turn_order_turned_output_column_choice := turn_order_held_output;
      end if;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_output_column <= turn_order_turned_output_column_choice and winners_best_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and winners_best_tag_map_column and
        winners_best_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= winners_best_tag_end_of_line;
      turn_newest <= winners_best_index_0_0 + 256;
      turn_comes <= turn_order_complete_all;
      turn_read_tag_valid <= turn_order_turned_valid;
      turn_read_tag_output_column <= turn_order_turned_output_column;
      turn_read_tag_start_of_frame <= turn_order_turned_start_of_frame;
      turn_read_tag_end_of_line <= turn_order_turned_end_of_line;
      turn_ready <= to_integer(turn_read_words_0);
      turn_ready_tag_valid <= turn_read_tag_valid;
      turn_ready_tag_output_column <= turn_read_tag_output_column;
      turn_ready_tag_start_of_frame <= turn_read_tag_start_of_frame;
      turn_ready_tag_end_of_line <= turn_read_tag_end_of_line;
      if turn_order_falls then
        turn_order_falls <= turn_order_address_any;
      else
        turn_order_falls <= turn_order_falls_all;
      end if;
      if winners_best_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if winners_best_tag_valid then
        turn_order_inside <= winners_best_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
        turn_order_held_output <= turn_order_output and turn_order_complete;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- relief
      if transform_columns_valid then
        relief_centre_column_0 <= transform_right_column_2;
        relief_centre_column_1 <= relief_centre_column_0;
        relief_centre_column_2 <= relief_centre_column_1;
        relief_centre_column_3 <= relief_centre_column_2;
        relief_centre_column_4 <= relief_centre_column_3;
      end if;
      if (relief_centre_grey_0 mod 2) = 1 then
        relief_newest_choice := (not (((relief_before / 2) mod 2) = 1)) or (not ((relief_before mod 2) = 1));
      else
        relief_newest_choice := not (((relief_before / 2) mod 2) = 1);
      end if;
      if ((relief_centre_grey_0 / 2) mod 2) = 1 then
        relief_newest_choice_2 := relief_newest_choice;
      else
        relief_newest_choice_2 := ((relief_centre_grey_0 mod 2) = 1) and ((relief_before mod 4) = 0);
      end if;
      relief_newest_value := ((relief_before / 4) mod 2) = 1;
      if relief_newest_choice_2 then
        relief_newest_choice_3 := (not (((relief_centre_grey_0 / 4) mod 2) = 1)) and relief_newest_value;
      else
        relief_newest_choice_3 := (not (((relief_centre_grey_0 / 4) mod 2) = 1)) or relief_newest_value;
      end if;
      relief_newest_value_2 := ((relief_before / 8) mod 2) = 1;
      if relief_newest_choice_3 then
        relief_newest_choice_4 := (not (((relief_centre_grey_0 / 8) mod 2) = 1)) or relief_newest_value_2;
      else
        relief_newest_choice_4 := (not (((relief_centre_grey_0 / 8) mod 2) = 1)) and relief_newest_value_2;
      end if;
      relief_newest_value_3 := ((relief_before / 16) mod 2) = 1;
      if relief_newest_choice_4 then
        relief_newest_choice_5 := (not (((relief_centre_grey_0 / 16) mod 2) = 1)) or relief_newest_value_3;
      else
        relief_newest_choice_5 := (not (((relief_centre_grey_0 / 16) mod 2) = 1)) and relief_newest_value_3;
      end if;
      relief_newest_value_4 := ((relief_before / 32) mod 2) = 1;
      if relief_newest_choice_5 then
        relief_newest_choice_6 := (not (((relief_centre_grey_0 / 32) mod 2) = 1)) or relief_newest_value_4;
      else
        relief_newest_choice_6 := (not (((relief_centre_grey_0 / 32) mod 2) = 1)) and relief_newest_value_4;
      end if;
      relief_newest_value_5 := ((relief_before / 64) mod 2) = 1;
      if relief_newest_choice_6 then
        relief_newest_choice_7 := (not (((relief_centre_grey_0 / 64) mod 2) = 1)) or relief_newest_value_5;
      else
        relief_newest_choice_7 := (not (((relief_centre_grey_0 / 64) mod 2) = 1)) and relief_newest_value_5;
      end if;
      if relief_newest_choice_7 then
        relief_newest_choice_8 := (not ((relief_centre_grey_0 / 128) = 1)) or ((relief_before / 128) = 1);
      else
        relief_newest_choice_8 := (not ((relief_centre_grey_0 / 128) = 1)) and ((relief_before / 128) = 1);
      end if;
      relief_newest_value_6 := (relief_before - relief_centre_grey_0) mod 256;
      relief_newest_value_7 := (relief_centre_grey_0 - relief_before) mod 256;
      if relief_newest_choice_8 then
        relief_newest_choice_9 := ((relief_newest_value_6 / 4) mod 2) = 1;
      else
        relief_newest_choice_9 := ((relief_newest_value_7 / 4) mod 2) = 1;
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_10 := not (((relief_newest_value_6 / 8) mod 2) = 1);
      else
        relief_newest_choice_10 := not (((relief_newest_value_7 / 8) mod 2) = 1);
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_11 := not (((relief_newest_value_6 / 2) mod 2) = 1);
      else
        relief_newest_choice_11 := not (((relief_newest_value_7 / 2) mod 2) = 1);
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_12 := ((relief_newest_value_6 / 16) mod 2) = 1;
      else
        relief_newest_choice_12 := ((relief_newest_value_7 / 16) mod 2) = 1;
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_13 := not (((relief_newest_value_6 / 32) mod 2) = 1);
      else
        relief_newest_choice_13 := not (((relief_newest_value_7 / 32) mod 2) = 1);
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_14 := ((relief_newest_value_6 / 64) mod 2) = 1;
      else
        relief_newest_choice_14 := ((relief_newest_value_7 / 64) mod 2) = 1;
      end if;
      if relief_newest_choice_8 then
        relief_newest_choice_15 := (relief_newest_value_6 / 128) = 1;
      else
        relief_newest_choice_15 := (relief_newest_value_7 / 128) = 1;
      end if;
      if relief_newest_choice_7 then
        relief_newest_choice_16 := ((relief_centre_grey_0 / 128) = 1) and (not ((relief_before / 128) = 1));
      else
        relief_newest_choice_16 := ((relief_centre_grey_0 / 128) = 1) or (not ((relief_before / 128) = 1));
      end if;
      if relief_newest_choice_16 then
        relief_newest_choice_17 := (relief_newest_value_7 / 2) mod 64;
      else
        relief_newest_choice_17 := (relief_newest_value_6 / 2) mod 64;
      end if;
      relief_centre_grey_0 <= relief_centre_column_4;
      relief_rows_read_newest_0 <= to_integer(relief_delayed_0);
      relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
      relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
      relief_shown_0 <= relief_rows_ready_words_0;
      relief_waiting_0 <= relief_column_0;
      relief_waiting_1 <= relief_waiting_0;
      relief_waiting_2 <= relief_waiting_1;
      relief_waiting_3 <= relief_waiting_2;
      relief_waiting_4 <= relief_waiting_3;
      relief_waiting_5 <= relief_waiting_4;
      relief_waiting_6 <= relief_waiting_5;
      relief_waiting_7 <= relief_waiting_6;
      relief_waiting_8 <= relief_waiting_7;
      relief_entered <= relief_entering;
      if ((not ((not ((not ((not relief_newest_choice_9) and relief_newest_choice_10 and relief_newest_choice_11)) and
        relief_newest_choice_12)) and relief_newest_choice_13)) and relief_newest_choice_14) or relief_newest_choice_15
        then
        relief_newest <= 40;
      else
        relief_newest <= relief_newest_choice_17;
      end if;
      if relief_waiting_8 < 40 then
        relief_entering <= relief_waiting_8;
      else
        relief_entering <= 40;
      end if;
      if transform_filtering_1_valid then
        relief_before <= relief_centre_grey_0;
      end if;
      if rows_ready_tag_valid then
        relief_rows_write_words_0 <= relief_rows_ready_newest_0;
      end if;
      if rows_tag_valid then
        relief_column_0 <= relief_shown_0;
      end if;
      -- other
      if entry_tag_valid then
        other_0_choice := forward_left_cost_9 + forward_above_cost_9;
      else
        other_0_choice := to_integer(other_0(15 downto 8));
      end if;
      if entry_tag_valid then
        other_0_choice_2 := forward_left_cost_8 + forward_above_cost_8;
      else
        other_0_choice_2 := to_integer(other_0(7 downto 0));
      end if;
      if entry_tag_valid then
        other_0_choice_3 := forward_left_cost_10 + forward_above_cost_10;
      else
        other_0_choice_3 := to_integer(other_0(23 downto 16));
      end if;
      if entry_tag_valid then
        other_0_choice_4 := forward_left_cost_11 + forward_above_cost_11;
      else
        other_0_choice_4 := to_integer(other_0(31 downto 24));
      end if;
      if entry_tag_valid then
        other_1_choice := forward_left_cost_5 + forward_above_cost_5;
      else
        other_1_choice := to_integer(other_1(15 downto 8));
      end if;
      if entry_tag_valid then
        other_1_choice_2 := forward_left_cost_4 + forward_above_cost_4;
      else
        other_1_choice_2 := to_integer(other_1(7 downto 0));
      end if;
      if entry_tag_valid then
        other_1_choice_3 := forward_left_cost_6 + forward_above_cost_6;
      else
        other_1_choice_3 := to_integer(other_1(23 downto 16));
      end if;
      if entry_tag_valid then
        other_1_choice_4 := forward_left_cost_7 + forward_above_cost_7;
      else
        other_1_choice_4 := to_integer(other_1(31 downto 24));
      end if;
      if entry_tag_valid then
        other_2_choice := forward_left_cost_1 + forward_above_cost_1;
      else
        other_2_choice := to_integer(other_2(15 downto 8));
      end if;
      if entry_tag_valid then
        other_2_choice_2 := forward_left_cost_0 + forward_above_cost_0;
      else
        other_2_choice_2 := to_integer(other_2(7 downto 0));
      end if;
      if entry_tag_valid then
        other_2_choice_3 := forward_left_cost_2 + forward_above_cost_2;
      else
        other_2_choice_3 := to_integer(other_2(23 downto 16));
      end if;
      if entry_tag_valid then
        other_2_choice_4 := forward_left_cost_3 + forward_above_cost_3;
      else
        other_2_choice_4 := to_integer(other_2(31 downto 24));
      end if;
      other_0 <= to_unsigned(other_0_choice_4, 8) & to_unsigned(other_0_choice_3, 8) & to_unsigned(other_0_choice, 8) &
        to_unsigned(other_0_choice_2, 8);
      other_1 <= to_unsigned(other_1_choice_4, 8) & to_unsigned(other_1_choice_3, 8) & to_unsigned(other_1_choice, 8) &
        to_unsigned(other_1_choice_2, 8);
      other_2 <= to_unsigned(other_2_choice_4, 8) & to_unsigned(other_2_choice_3, 8) & to_unsigned(other_2_choice, 8) &
        to_unsigned(other_2_choice_2, 8);
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 14;
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
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 13;
        raster_place_next_frame <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_first_cost <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_first_cost <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_first_cost <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_first_cost <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_first_cost <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_first_cost <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_first_cost <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_first_cost <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_first_cost <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_first_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_first_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0_tag_0_valid <= false;
        slice0_tag_0_map_column <= false;
        slice0_tag_0_output_column <= false;
        slice0_tag_0_first_column <= false;
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
        sums_tags_moved <= false;
        winnerswinner1_pair_tag_valid <= false;
        winnerswinner1_pair_tag_map_column <= false;
        winnerswinner1_pair_tag_output_column <= false;
        winnerswinner1_pair_tag_start_of_frame <= false;
        winnerswinner1_pair_tag_end_of_line <= false;
        winnerswinner1_four_tag_valid <= false;
        winnerswinner1_four_tag_map_column <= false;
        winnerswinner1_four_tag_output_column <= false;
        winnerswinner1_four_tag_start_of_frame <= false;
        winnerswinner1_four_tag_end_of_line <= false;
        winnerswinner1_tag_valid <= false;
        winnerswinner1_tag_map_column <= false;
        winnerswinner1_tag_output_column <= false;
        winnerswinner1_tag_start_of_frame <= false;
        winnerswinner1_tag_end_of_line <= false;
        winnerswinner2_pair_tag_valid <= false;
        winnerswinner2_pair_tag_map_column <= false;
        winnerswinner2_pair_tag_output_column <= false;
        winnerswinner2_pair_tag_start_of_frame <= false;
        winnerswinner2_pair_tag_end_of_line <= false;
        winnerswinner2_four_tag_valid <= false;
        winnerswinner2_four_tag_map_column <= false;
        winnerswinner2_four_tag_output_column <= false;
        winnerswinner2_four_tag_start_of_frame <= false;
        winnerswinner2_four_tag_end_of_line <= false;
        winnerswinner2_tag_valid <= false;
        winnerswinner2_tag_map_column <= false;
        winnerswinner2_tag_output_column <= false;
        winnerswinner2_tag_start_of_frame <= false;
        winnerswinner2_tag_end_of_line <= false;
        winners_best_tag_valid <= false;
        winners_best_tag_map_column <= false;
        winners_best_tag_output_column <= false;
        winners_best_tag_start_of_frame <= false;
        winners_best_tag_end_of_line <= false;
        turn_order_address <= 0;
        turn_order_falls <= false;
        turn_order_inside <= false;
        turn_order_complete <= false;
        turn_order_output <= false;
        turn_order_first <= false;
        turn_order_held_output <= false;
        turn_order_turned_valid <= false;
        turn_order_turned_output_column <= false;
        turn_order_turned_start_of_frame <= false;
        turn_order_turned_end_of_line <= false;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_output_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_write_place <= 0;
        turn_ready_tag_valid <= false;
        turn_ready_tag_output_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
