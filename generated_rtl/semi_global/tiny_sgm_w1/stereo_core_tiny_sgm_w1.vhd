-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm_w1: 40x12, 12 disparities, window 1x1, P1 4, P2 24, 1 pixel pair a clock.
-- Options: disparities 12, window_px 1, census_width_px 9, cost_shift 2, p1 4, p2 24, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm_w1
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm_w1 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 32;
    flush_groups : positive := 168;
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
  assert width_px = 40 report "stereo_core_tiny_sgm_w1: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm_w1: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm_w1: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm_w1: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_sgm_w1: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_sgm_w1: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 32 report "stereo_core_tiny_sgm_w1: latency_clocks is " & integer'image(latency_clocks) & " but this core has 32" severity failure;
  assert flush_groups = 168 report "stereo_core_tiny_sgm_w1: flush_groups is " & integer'image(flush_groups) & " but this core has 168" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm_w1: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm_w1 is
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
  signal transform_right_rows_ready_newest_0, transform_left_column_0, transform_left_column_1 : natural range 0 to 255;
  signal transform_left_column_2, transform_left_column_3, transform_left_column_4 : natural range 0 to 255;
  signal transform_right_column_0, transform_right_column_1, transform_right_column_2 : natural range 0 to 255;
  signal transform_right_column_3, transform_right_column_4, transform_left_filter_column_0_0 : natural range 0 to 255;
  signal transform_left_filter_column_0_1, transform_left_filter_column_0_2 : natural range 0 to 255;
  signal transform_left_filter_column_0_3, transform_left_filter_column_0_4 : natural range 0 to 255;
  signal transform_left_filter_column_1_0, transform_left_filter_column_1_1 : natural range 0 to 255;
  signal transform_left_filter_column_1_2, transform_left_filter_column_1_3 : natural range 0 to 255;
  signal transform_left_filter_column_1_4, transform_left_filter_column_2_0 : natural range 0 to 255;
  signal transform_left_filter_column_2_1, transform_left_filter_column_2_2 : natural range 0 to 255;
  signal transform_left_filter_column_2_3, transform_left_filter_column_2_4 : natural range 0 to 255;
  signal transform_left_filter_column_3_0, transform_left_filter_column_3_1 : natural range 0 to 255;
  signal transform_left_filter_column_3_2, transform_left_filter_column_3_3 : natural range 0 to 255;
  signal transform_left_filter_column_3_4, transform_left_filter_column_4_0 : natural range 0 to 255;
  signal transform_left_filter_column_4_1, transform_left_filter_column_4_2 : natural range 0 to 255;
  signal transform_left_filter_column_4_3, transform_left_filter_column_4_4 : natural range 0 to 255;
  signal transform_left_filter_column_5_0, transform_left_filter_column_5_1 : natural range 0 to 255;
  signal transform_left_filter_column_5_2, transform_left_filter_column_5_3 : natural range 0 to 255;
  signal transform_left_filter_column_5_4, transform_left_filter_column_6_0 : natural range 0 to 255;
  signal transform_left_filter_column_6_1, transform_left_filter_column_6_2 : natural range 0 to 255;
  signal transform_left_filter_column_6_3, transform_left_filter_column_6_4 : natural range 0 to 255;
  signal transform_left_filter_column_7_0, transform_left_filter_column_7_1 : natural range 0 to 255;
  signal transform_left_filter_column_7_2, transform_left_filter_column_7_3 : natural range 0 to 255;
  signal transform_left_filter_column_7_4, transform_left_filter_column_8_0 : natural range 0 to 255;
  signal transform_left_filter_column_8_1, transform_left_filter_column_8_2 : natural range 0 to 255;
  signal transform_left_filter_column_8_3, transform_left_filter_column_8_4 : natural range 0 to 255;
  signal transform_right_filter_column_0_0, transform_right_filter_column_0_1 : natural range 0 to 255;
  signal transform_right_filter_column_0_2, transform_right_filter_column_0_3 : natural range 0 to 255;
  signal transform_right_filter_column_0_4, transform_right_filter_column_1_0 : natural range 0 to 255;
  signal transform_right_filter_column_1_1, transform_right_filter_column_1_2 : natural range 0 to 255;
  signal transform_right_filter_column_1_3, transform_right_filter_column_1_4 : natural range 0 to 255;
  signal transform_right_filter_column_2_0, transform_right_filter_column_2_1 : natural range 0 to 255;
  signal transform_right_filter_column_2_2, transform_right_filter_column_2_3 : natural range 0 to 255;
  signal transform_right_filter_column_2_4, transform_right_filter_column_3_0 : natural range 0 to 255;
  signal transform_right_filter_column_3_1, transform_right_filter_column_3_2 : natural range 0 to 255;
  signal transform_right_filter_column_3_3, transform_right_filter_column_3_4 : natural range 0 to 255;
  signal transform_right_filter_column_4_0, transform_right_filter_column_4_1 : natural range 0 to 255;
  signal transform_right_filter_column_4_2, transform_right_filter_column_4_3 : natural range 0 to 255;
  signal transform_right_filter_column_4_4, transform_right_filter_column_5_0 : natural range 0 to 255;
  signal transform_right_filter_column_5_1, transform_right_filter_column_5_2 : natural range 0 to 255;
  signal transform_right_filter_column_5_3, transform_right_filter_column_5_4 : natural range 0 to 255;
  signal transform_right_filter_column_6_0, transform_right_filter_column_6_1 : natural range 0 to 255;
  signal transform_right_filter_column_6_2, transform_right_filter_column_6_3 : natural range 0 to 255;
  signal transform_right_filter_column_6_4, transform_right_filter_column_7_0 : natural range 0 to 255;
  signal transform_right_filter_column_7_1, transform_right_filter_column_7_2 : natural range 0 to 255;
  signal transform_right_filter_column_7_3, transform_right_filter_column_7_4 : natural range 0 to 255;
  signal transform_right_filter_column_8_0, transform_right_filter_column_8_1 : natural range 0 to 255;
  signal transform_right_filter_column_8_2, transform_right_filter_column_8_3 : natural range 0 to 255;
  signal transform_right_filter_column_8_4 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_2, transform_read_row_inside_3 : boolean;
  signal transform_read_row_inside_4, transform_read_column_inside_0, transform_read_column_inside_1 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_3, transform_read_column_inside_4 : boolean;
  signal transform_read_column_inside_5, transform_read_column_inside_6, transform_read_column_inside_7 : boolean;
  signal transform_read_column_inside_8, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_1, transform_ready_row_inside_2 : boolean;
  signal transform_ready_row_inside_3, transform_ready_row_inside_4, transform_ready_column_inside_0 : boolean;
  signal transform_ready_column_inside_1, transform_ready_column_inside_2, transform_ready_column_inside_3 : boolean;
  signal transform_ready_column_inside_4, transform_ready_column_inside_5, transform_ready_column_inside_6 : boolean;
  signal transform_ready_column_inside_7, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_1 : boolean;
  signal transform_columns_row_inside_2, transform_columns_row_inside_3, transform_columns_row_inside_4 : boolean;
  signal transform_columns_column_inside_0, transform_columns_column_inside_1 : boolean;
  signal transform_columns_column_inside_2, transform_columns_column_inside_3 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_5 : boolean;
  signal transform_columns_column_inside_6, transform_columns_column_inside_7 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_1 : boolean;
  signal transform_filtering_0_column_inside_2, transform_filtering_0_column_inside_3 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_5 : boolean;
  signal transform_filtering_0_column_inside_6, transform_filtering_0_column_inside_7 : boolean;
  signal transform_filtering_0_column_inside_8, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(43 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(43 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0, delay_delayed_0 : unsigned(43 downto 0);
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_0, rows_reference_0 : unsigned(43 downto 0);
  signal rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : unsigned(43 downto 0);
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_reference_0 : unsigned(43 downto 0);
  signal slice0shift_search_out_0 : unsigned(43 downto 0);
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0_count_0, slice0cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_2, slice0cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_4, slice0cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_6, slice0cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_8, slice0cost_pixels_first_0_0_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_10, slice0cost_pixels_first_0_0_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_12, slice0cost_pixels_first_0_0_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_0, slice0cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_2, slice0cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_4, slice0cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_6, slice0cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_8, slice0cost_pixels_first_0_1_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_10, slice0cost_pixels_first_0_1_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_12, slice0cost_pixels_first_0_1_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_0, slice0cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_2, slice0cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_4, slice0cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_6, slice0cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_8, slice0cost_pixels_first_0_2_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_10, slice0cost_pixels_first_0_2_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_12, slice0cost_pixels_first_0_2_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_0, slice0cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_2, slice0cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_4, slice0cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_6, slice0cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_8, slice0cost_pixels_first_0_3_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_10, slice0cost_pixels_first_0_3_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_12, slice0cost_pixels_first_0_3_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_0, slice0cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_2, slice0cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_4, slice0cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_6, slice0cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_8, slice0cost_pixels_first_0_4_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_10, slice0cost_pixels_first_0_4_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_12, slice0cost_pixels_first_0_4_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_14, slice0cost_pixels_first_0_1_count_14 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_2_count_14, slice0cost_pixels_first_0_3_count_14 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_4_count_14 : natural range 0 to 2;
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
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 44;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_single_0_0 : natural range 0 to 44;
  signal slice0cost_single_0_1, slice0cost_single_0_2, slice0cost_single_0_3 : natural range 0 to 44;
  signal slice0cost_single_0_4 : natural range 0 to 44;
  -- slice0window
  signal slice0window_tag_valid, slice0window_tag_border_column, slice0window_tag_first_cost : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  -- slice0
  signal slice0_held_0_0, slice0_held_0_1, slice0_held_0_2, slice0_held_0_3, slice0_held_0_4 : natural range 0 to 11;
  signal slice0_held_1_0, slice0_held_1_1, slice0_held_1_2, slice0_held_1_3, slice0_held_1_4 : natural range 0 to 11;
  signal slice0_held_2_0, slice0_held_2_1, slice0_held_2_2, slice0_held_2_3, slice0_held_2_4 : natural range 0 to 11;
  signal slice0_tag_0_valid, slice0_tag_0_first_cost, slice0_tag_0_map_column, slice0_tag_0_output_column : boolean;
  signal slice0_tag_0_start_of_frame, slice0_tag_0_end_of_line, slice0_tag_1_valid, slice0_tag_1_first_cost : boolean;
  signal slice0_tag_1_map_column, slice0_tag_1_output_column, slice0_tag_1_start_of_frame : boolean;
  signal slice0_tag_1_end_of_line, slice0_tag_2_valid, slice0_tag_2_first_cost, slice0_tag_2_map_column : boolean;
  signal slice0_tag_2_output_column, slice0_tag_2_start_of_frame, slice0_tag_2_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : unsigned(43 downto 0);
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_reference_0 : unsigned(43 downto 0);
  signal slice1shift_search_out_0 : unsigned(43 downto 0);
  -- slice1cost
  signal slice1cost_pixels_first_0_0_count_0, slice1cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_2, slice1cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_4, slice1cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_6, slice1cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_8, slice1cost_pixels_first_0_0_count_9 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_10, slice1cost_pixels_first_0_0_count_11 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_12, slice1cost_pixels_first_0_0_count_13 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_0, slice1cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_2, slice1cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_4, slice1cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_6, slice1cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_8, slice1cost_pixels_first_0_1_count_9 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_10, slice1cost_pixels_first_0_1_count_11 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_12, slice1cost_pixels_first_0_1_count_13 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_0, slice1cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_2, slice1cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_4, slice1cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_6, slice1cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_8, slice1cost_pixels_first_0_2_count_9 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_10, slice1cost_pixels_first_0_2_count_11 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_12, slice1cost_pixels_first_0_2_count_13 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_0, slice1cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_2, slice1cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_4, slice1cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_6, slice1cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_8, slice1cost_pixels_first_0_3_count_9 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_10, slice1cost_pixels_first_0_3_count_11 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_12, slice1cost_pixels_first_0_3_count_13 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_0, slice1cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_2, slice1cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_4, slice1cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_6, slice1cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_8, slice1cost_pixels_first_0_4_count_9 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_10, slice1cost_pixels_first_0_4_count_11 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_12, slice1cost_pixels_first_0_4_count_13 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_14, slice1cost_pixels_first_0_1_count_14 : natural range 0 to 2;
  signal slice1cost_pixels_first_0_2_count_14, slice1cost_pixels_first_0_3_count_14 : natural range 0 to 2;
  signal slice1cost_pixels_first_0_4_count_14 : natural range 0 to 2;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 44;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_single_0_0 : natural range 0 to 44;
  signal slice1cost_single_0_1, slice1cost_single_0_2, slice1cost_single_0_3 : natural range 0 to 44;
  signal slice1cost_single_0_4 : natural range 0 to 44;
  -- slice1
  signal slice1_held_0_0, slice1_held_0_1, slice1_held_0_2, slice1_held_0_3, slice1_held_0_4 : natural range 0 to 11;
  signal slice1_held_1_0, slice1_held_1_1, slice1_held_1_2, slice1_held_1_3, slice1_held_1_4 : natural range 0 to 11;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_reference_0 : unsigned(43 downto 0);
  -- slice2cost
  signal slice2cost_pixels_first_0_0_count_0, slice2cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_2, slice2cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_4, slice2cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_6, slice2cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_8, slice2cost_pixels_first_0_0_count_9 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_10, slice2cost_pixels_first_0_0_count_11 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_12, slice2cost_pixels_first_0_0_count_13 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_0, slice2cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_2, slice2cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_4, slice2cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_6, slice2cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_8, slice2cost_pixels_first_0_1_count_9 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_10, slice2cost_pixels_first_0_1_count_11 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_12, slice2cost_pixels_first_0_1_count_13 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_14, slice2cost_pixels_first_0_1_count_14 : natural range 0 to 2;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_single_0_0 : natural range 0 to 44;
  signal slice2cost_single_0_1 : natural range 0 to 44;
  -- slice2
  signal slice2_held_0_0, slice2_held_0_1 : natural range 0 to 11;
  -- entry
  signal entry_next_cost_0, entry_next_cost_1, entry_next_cost_2, entry_next_cost_3 : natural range 0 to 11;
  signal entry_next_cost_4, entry_next_cost_5, entry_next_cost_6, entry_next_cost_7 : natural range 0 to 11;
  signal entry_next_cost_8, entry_next_cost_9, entry_next_cost_10, entry_next_cost_11 : natural range 0 to 11;
  signal entry_cost_0, entry_cost_1, entry_cost_2, entry_cost_3, entry_cost_4, entry_cost_5 : natural range 0 to 11;
  signal entry_cost_6, entry_cost_7, entry_cost_8, entry_cost_9, entry_cost_10, entry_cost_11 : natural range 0 to 11;
  signal entry_next_tag_valid, entry_next_tag_first_cost, entry_next_tag_map_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_first_cost, entry_tag_map_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 31;
  -- forward
  signal forward_smallest_smallest_0, forward_smallest_smallest_1, forward_smallest_smallest_2 : natural range 0 to 11;
  signal forward_smallest_smallest_3, forward_smallest_smallest_4, forward_smallest_smallest_5 : natural range 0 to 11;
  signal forward_smallest_next_smallest_0, forward_smallest_next_smallest_1 : natural range 0 to 11;
  signal forward_smallest_next_smallest_2, forward_smallest_next_next_smallest_0 : natural range 0 to 11;
  signal forward_smallest_next_next_smallest_1, forward_smallest_next_next_next_smallest_0 : natural range 0 to 11;
  signal forward_left_smallest, forward_above_ready_cost_0, forward_above_ready_cost_1 : natural range 0 to 11;
  signal forward_above_ready_cost_2, forward_above_ready_cost_3, forward_above_ready_cost_4 : natural range 0 to 11;
  signal forward_above_ready_cost_5, forward_above_ready_cost_6, forward_above_ready_cost_7 : natural range 0 to 11;
  signal forward_above_ready_cost_8, forward_above_ready_cost_9, forward_above_ready_cost_10 : natural range 0 to 11;
  signal forward_above_ready_cost_11, forward_smallest_cost_0, forward_smallest_cost_1 : natural range 0 to 11;
  signal forward_smallest_cost_2, forward_smallest_cost_3, forward_smallest_cost_4 : natural range 0 to 11;
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_delay_held_0, forward_above_read_words_0, forward_above_read_words_1 : unsigned(31 downto 0);
  signal forward_above_ready_words_0, forward_above_ready_words_1, forward_above_write_words_0 : unsigned(31 downto 0);
  signal forward_above_write_words_1 : unsigned(31 downto 0);
  signal forward_cost_delay_held_1 : unsigned(15 downto 0);
  signal forward_left_pair_0, forward_left_pair_1, forward_left_pair_2, forward_left_pair_3 : natural range 0 to 63;
  signal forward_left_pair_4, forward_left_pair_5, forward_left_tree_smallest_0 : natural range 0 to 63;
  signal forward_left_tree_smallest_1, forward_left_tree_smallest_2 : natural range 0 to 63;
  signal forward_left_tree_next_smallest_0, forward_left_tree_next_smallest_1 : natural range 0 to 63;
  signal forward_left_tree_next_next_smallest_0, forward_left_smallest_less : natural range 0 to 63;
  signal forward_left_g_copy_0, forward_left_g_less_copy_0, forward_left_stay_change_0 : natural range 0 to 63;
  signal forward_left_stay_change_1, forward_left_stay_change_2, forward_left_stay_change_3 : natural range 0 to 63;
  signal forward_left_stay_change_4, forward_left_stay_change_5, forward_left_stay_change_6 : natural range 0 to 63;
  signal forward_left_stay_change_7, forward_left_stay_change_8, forward_left_stay_change_9 : natural range 0 to 63;
  signal forward_left_stay_change_10, forward_left_stay_change_11, forward_left_step_change_0 : natural range 0 to 63;
  signal forward_left_step_change_1, forward_left_step_change_2, forward_left_step_change_3 : natural range 0 to 63;
  signal forward_left_step_change_4, forward_left_step_change_5, forward_left_step_change_6 : natural range 0 to 63;
  signal forward_left_step_change_7, forward_left_step_change_8, forward_left_step_change_9 : natural range 0 to 63;
  signal forward_left_step_change_10, forward_left_step_change_11, forward_left_cost_0 : natural range 0 to 63;
  signal forward_left_cost_1, forward_left_cost_2, forward_left_cost_3, forward_left_cost_4 : natural range 0 to 63;
  signal forward_left_cost_5, forward_left_cost_6, forward_left_cost_7, forward_left_cost_8 : natural range 0 to 63;
  signal forward_left_cost_9, forward_left_cost_10, forward_left_cost_11 : natural range 0 to 63;
  signal forward_left_arrived_0, forward_left_arrived_1, forward_left_arrived_2 : natural range 0 to 63;
  signal forward_left_arrived_3, forward_left_arrived_4, forward_left_arrived_5 : natural range 0 to 63;
  signal forward_left_arrived_6, forward_left_arrived_7, forward_left_arrived_8 : natural range 0 to 63;
  signal forward_left_arrived_9, forward_left_arrived_10, forward_left_arrived_11 : natural range 0 to 63;
  signal forward_above_cost_0, forward_above_cost_1, forward_above_cost_2, forward_above_cost_3 : natural range 0 to 63;
  signal forward_above_cost_4, forward_above_cost_5, forward_above_cost_6, forward_above_cost_7 : natural range 0 to 63;
  signal forward_above_cost_8, forward_above_cost_9, forward_above_cost_10 : natural range 0 to 63;
  signal forward_above_cost_11, forward_above_beside_0, forward_above_beside_1 : natural range 0 to 63;
  signal forward_above_beside_2, forward_above_beside_3, forward_above_beside_4 : natural range 0 to 63;
  signal forward_above_beside_5, forward_above_beside_6, forward_above_beside_7 : natural range 0 to 63;
  signal forward_above_beside_8, forward_above_beside_9, forward_above_beside_10 : natural range 0 to 63;
  signal forward_above_beside_11, forward_above_own_0, forward_above_own_2, forward_above_own_3 : natural range 0 to 63;
  signal forward_above_own_4, forward_above_own_5, forward_above_own_6, forward_above_own_7 : natural range 0 to 63;
  signal forward_above_own_8, forward_above_own_9, forward_above_own_11 : natural range 0 to 63;
  signal forward_left_start_cost_0, forward_left_start_cost_1, forward_left_start_cost_2 : natural range 0 to 255;
  signal forward_left_start_cost_3, forward_left_start_cost_4, forward_left_start_cost_5 : natural range 0 to 255;
  signal forward_left_start_cost_6 : natural range 0 to 255;
  signal forward_left_room, forward_above_stay_0, forward_above_stay_1, forward_above_stay_2 : natural range 0 to 31;
  signal forward_above_stay_3, forward_above_stay_4, forward_above_stay_5, forward_above_stay_6 : natural range 0 to 31;
  signal forward_above_stay_7, forward_above_stay_8, forward_above_stay_9 : natural range 0 to 31;
  signal forward_above_stay_10, forward_above_stay_11, forward_above_column_0 : natural range 0 to 31;
  signal forward_above_column_1, forward_above_column_2, forward_above_column_3 : natural range 0 to 31;
  signal forward_above_column_4, forward_above_column_5, forward_above_column_6 : natural range 0 to 31;
  signal forward_above_column_7, forward_above_column_8, forward_above_column_9 : natural range 0 to 31;
  signal forward_above_write_column : natural range 0 to 31;
  signal forward_left_first_0, forward_left_first_1, forward_left_first_2, forward_above_ready_top : boolean;
  signal forward_above_comes_0, forward_above_comes_1, forward_above_comes_2, forward_above_comes_3 : boolean;
  signal forward_above_comes_4, forward_above_comes_5, forward_above_comes_6, forward_above_comes_7 : boolean;
  signal forward_above_comes_8, forward_above_comes_9, forward_above_writes_copy_0, forward_first_0 : boolean;
  signal forward_first_1, forward_first_2, forward_first_3 : boolean;
  signal forward_above_total_0, forward_above_total_1, forward_above_total_2 : natural range 0 to 42;
  signal forward_above_total_3, forward_above_total_4, forward_above_total_5 : natural range 0 to 42;
  signal forward_above_total_6, forward_above_total_7, forward_above_total_8 : natural range 0 to 42;
  signal forward_above_total_9, forward_above_total_10, forward_above_total_11 : natural range 0 to 42;
  signal forward_above_tree_smallest_0, forward_above_tree_smallest_1 : natural range 0 to 42;
  signal forward_above_tree_smallest_2, forward_above_tree_smallest_3 : natural range 0 to 42;
  signal forward_above_tree_smallest_4, forward_above_tree_smallest_5 : natural range 0 to 42;
  signal forward_above_tree_next_smallest_0, forward_above_tree_next_smallest_1 : natural range 0 to 42;
  signal forward_above_tree_next_smallest_2, forward_above_tree_next_next_smallest_0 : natural range 0 to 42;
  signal forward_above_tree_next_next_smallest_1, forward_above_tree_next_next_next_smallest_0 : natural range 0 to 42;
  signal forward_above_smallest_copy_0 : natural range 0 to 42;
  signal forward_above_delay_held_0, forward_above_delay_held_1 : unsigned(29 downto 0);
  signal forward_above_delay_held_2 : unsigned(11 downto 0);
  signal forward_above_step_0, forward_above_step_1, forward_above_step_2, forward_above_step_3 : natural range 0 to 67;
  signal forward_above_step_4, forward_above_step_5, forward_above_step_6, forward_above_step_7 : natural range 0 to 67;
  signal forward_above_step_8, forward_above_step_9, forward_above_step_10 : natural range 0 to 67;
  signal forward_above_step_11 : natural range 0 to 67;
  signal forward_sum_0, forward_sum_1, forward_sum_2, forward_sum_3, forward_sum_4 : natural range 0 to 126;
  signal forward_sum_5, forward_sum_6, forward_sum_7, forward_sum_8, forward_sum_9 : natural range 0 to 126;
  signal forward_sum_10, forward_sum_11 : natural range 0 to 126;
  signal forward_cost_0_0, forward_cost_0_1, forward_cost_0_2, forward_cost_0_3 : natural range 0 to 15;
  signal forward_cost_0_4, forward_cost_0_5, forward_cost_0_6, forward_cost_0_7 : natural range 0 to 15;
  signal forward_cost_0_8, forward_cost_0_9, forward_cost_0_10, forward_cost_0_11 : natural range 0 to 15;
  signal forward_cost_1_0, forward_cost_1_1, forward_cost_1_2, forward_cost_1_3 : natural range 0 to 15;
  signal forward_cost_1_4, forward_cost_1_5, forward_cost_1_6, forward_cost_1_7 : natural range 0 to 15;
  signal forward_cost_1_8, forward_cost_1_9, forward_cost_1_10, forward_cost_1_11 : natural range 0 to 15;
  signal forward_cost_2_0, forward_cost_2_1, forward_cost_2_2, forward_cost_2_3 : natural range 0 to 15;
  signal forward_cost_2_4, forward_cost_2_5, forward_cost_2_6, forward_cost_2_7 : natural range 0 to 15;
  signal forward_cost_2_8, forward_cost_2_9, forward_cost_2_10, forward_cost_2_11 : natural range 0 to 15;
  signal forward_cost_3_0, forward_cost_3_1, forward_cost_3_2, forward_cost_3_3 : natural range 0 to 15;
  signal forward_cost_3_4, forward_cost_3_5, forward_cost_3_6, forward_cost_3_7 : natural range 0 to 15;
  signal forward_cost_3_8, forward_cost_3_9, forward_cost_3_10, forward_cost_3_11 : natural range 0 to 15;
  -- sums
  signal sums_turn_read_sums_0, sums_turn_read_sums_1, sums_turn_read_sums_2 : unsigned(27 downto 0);
  signal sums_sum_delay_held_0, sums_sum_delay_held_1, sums_sum_delay_held_2 : unsigned(27 downto 0);
  signal sums_turn_read_costs_0, sums_turn_ready_costs_0, sums_turn_write_costs_0 : unsigned(31 downto 0);
  signal sums_turn_read_costs_1 : unsigned(15 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(3 downto 0);
  signal sums_turn_ready_sums_0, sums_turn_ready_sums_1, sums_turn_ready_sums_2 : natural range 0 to 268435455;
  signal sums_turn_ready_costs_1, sums_turn_write_costs_1 : natural range 0 to 65535;
  signal sums_turn_ready_smallest_0, sums_cost_0_0, sums_cost_0_1, sums_cost_0_2, sums_cost_0_3 : natural range 0 to 15;
  signal sums_cost_0_4, sums_cost_0_5, sums_cost_0_6, sums_cost_0_7, sums_cost_0_8 : natural range 0 to 15;
  signal sums_cost_0_9, sums_cost_0_10, sums_cost_0_11, sums_cost_1_0, sums_cost_1_1 : natural range 0 to 15;
  signal sums_cost_1_2, sums_cost_1_3, sums_cost_1_4, sums_cost_1_5, sums_cost_1_6 : natural range 0 to 15;
  signal sums_cost_1_7, sums_cost_1_8, sums_cost_1_9, sums_cost_1_10, sums_cost_1_11 : natural range 0 to 15;
  signal sums_right_smallest : natural range 0 to 15;
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
  signal sums_turn_place_8, sums_turn_write_place, sums_right_room : natural range 0 to 31;
  signal sums_turn_write_sums_0, sums_turn_write_sums_1, sums_turn_write_sums_2 : natural range 0 to 266321790;
  signal sums_turn_write_smallest_0 : natural range 0 to 11;
  signal sums_right_pair_0, sums_right_pair_1, sums_right_pair_2, sums_right_pair_3 : natural range 0 to 63;
  signal sums_right_pair_4, sums_right_pair_5, sums_right_tree_smallest_0 : natural range 0 to 63;
  signal sums_right_tree_smallest_1, sums_right_tree_smallest_2 : natural range 0 to 63;
  signal sums_right_tree_next_smallest_0, sums_right_tree_next_smallest_1 : natural range 0 to 63;
  signal sums_right_tree_next_next_smallest_0, sums_right_smallest_less, sums_right_g_copy_0 : natural range 0 to 63;
  signal sums_right_g_less_copy_0, sums_right_stay_change_0, sums_right_stay_change_1 : natural range 0 to 63;
  signal sums_right_stay_change_2, sums_right_stay_change_3, sums_right_stay_change_4 : natural range 0 to 63;
  signal sums_right_stay_change_5, sums_right_stay_change_6, sums_right_stay_change_7 : natural range 0 to 63;
  signal sums_right_stay_change_8, sums_right_stay_change_9, sums_right_stay_change_10 : natural range 0 to 63;
  signal sums_right_stay_change_11, sums_right_step_change_0, sums_right_step_change_1 : natural range 0 to 63;
  signal sums_right_step_change_2, sums_right_step_change_3, sums_right_step_change_4 : natural range 0 to 63;
  signal sums_right_step_change_5, sums_right_step_change_6, sums_right_step_change_7 : natural range 0 to 63;
  signal sums_right_step_change_8, sums_right_step_change_9, sums_right_step_change_10 : natural range 0 to 63;
  signal sums_right_step_change_11, sums_right_cost_0, sums_right_cost_1, sums_right_cost_2 : natural range 0 to 63;
  signal sums_right_cost_3, sums_right_cost_4, sums_right_cost_5, sums_right_cost_6 : natural range 0 to 63;
  signal sums_right_cost_7, sums_right_cost_8, sums_right_cost_9, sums_right_cost_10 : natural range 0 to 63;
  signal sums_right_cost_11, sums_right_arrived_0, sums_right_arrived_1, sums_right_arrived_2 : natural range 0 to 63;
  signal sums_right_arrived_3, sums_right_arrived_4, sums_right_arrived_5, sums_right_arrived_6 : natural range 0 to 63;
  signal sums_right_arrived_7, sums_right_arrived_8, sums_right_arrived_9 : natural range 0 to 63;
  signal sums_right_arrived_10, sums_right_arrived_11 : natural range 0 to 63;
  signal sums_right_start_cost_0, sums_right_start_cost_1, sums_right_start_cost_2 : natural range 0 to 255;
  signal sums_right_start_cost_3, sums_right_start_cost_4, sums_right_start_cost_5 : natural range 0 to 255;
  signal sums_right_start_cost_6 : natural range 0 to 255;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  signal sums_sum_0_0, sums_sum_0_1, sums_sum_0_2, sums_sum_0_3, sums_sum_0_4, sums_sum_0_5 : natural range 0 to 127;
  signal sums_sum_0_6, sums_sum_0_7, sums_sum_0_8, sums_sum_0_9, sums_sum_0_10, sums_sum_0_11 : natural range 0 to 127;
  -- winnerswinner1
  signal winnerswinner1_of_pair_0_0, winnerswinner1_of_pair_0_1, winnerswinner1_of_pair_0_2 : natural range 0 to 127;
  signal winnerswinner1_of_pair_0_3, winnerswinner1_of_pair_0_4, winnerswinner1_of_pair_0_5 : natural range 0 to 127;
  signal winnerswinner1_of_pair_0_6, winnerswinner1_of_pair_0_7, winnerswinner1_of_pair_0_8 : natural range 0 to 127;
  signal winnerswinner1_of_pair_0_9, winnerswinner1_of_pair_0_10, winnerswinner1_of_pair_0_11 : natural range 0 to 127;
  signal winnerswinner1_of_four_0_0, winnerswinner1_of_four_0_1, winnerswinner1_of_four_0_2 : natural range 0 to 127;
  signal winnerswinner1_of_four_0_3, winnerswinner1_of_four_0_4, winnerswinner1_of_four_0_5 : natural range 0 to 127;
  signal winnerswinner1_of_four_0_6, winnerswinner1_of_four_0_7, winnerswinner1_of_four_0_8 : natural range 0 to 127;
  signal winnerswinner1_of_four_0_9, winnerswinner1_of_four_0_10, winnerswinner1_of_four_0_11 : natural range 0 to 127;
  signal winnerswinner1_best_cost_0_0, winnerswinner1_best_cost_0_1 : natural range 0 to 127;
  signal winnerswinner1_best_cost_0_2 : natural range 0 to 127;
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
  signal winnerswinner2_of_pair_0_0, winnerswinner2_of_pair_0_1, winnerswinner2_of_pair_0_2 : natural range 0 to 127;
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
  -- other
  signal other_0, other_1, other_2, other_3, other_4, other_5, other_6, other_7, other_8 : natural range 0 to 44;
  signal other_9, other_10, other_11, other_12, other_13, other_14, other_15, other_16 : natural range 0 to 44;
  signal other_17, other_18, other_19, other_20, other_21, other_22, other_23 : natural range 0 to 44;
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
  signal sums_sum_delay_held_2_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_1_memory_read_enable : boolean;
  signal sums_sum_delay_held_1_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_0_memory_read_enable : boolean;
  signal sums_sum_delay_held_0_memory_read_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_2_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_1_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_1_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(15 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(4 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(4 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(3 downto 0);
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
  signal forward_cost_delay_held_1_memory_write_data : unsigned(15 downto 0);
  signal forward_cost_delay_held_0_memory_read_enable : boolean;
  signal forward_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(43 downto 0);

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
  sums_sum_delay_held_2_memory_write_data <= to_unsigned(sums_turn_ready_sums_2, 28);
  sums_sum_delay_held_2_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_2_memory_read_enable,
      read_address => sums_sum_delay_held_2_memory_read_address, read_data => sums_sum_delay_held_2,
      write_address => sums_sum_delay_held_2_memory_write_address, write_data => sums_sum_delay_held_2_memory_write_data);

  sums_sum_delay_held_1_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_1_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_1_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_1_memory_write_data <= to_unsigned(sums_turn_ready_sums_1, 28);
  sums_sum_delay_held_1_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_1_memory_read_enable,
      read_address => sums_sum_delay_held_1_memory_read_address, read_data => sums_sum_delay_held_1,
      write_address => sums_sum_delay_held_1_memory_write_address, write_data => sums_sum_delay_held_1_memory_write_data);

  sums_sum_delay_held_0_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_0_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_0_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_0_memory_write_data <= to_unsigned(sums_turn_ready_sums_0, 28);
  sums_sum_delay_held_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_0_memory_read_enable,
      read_address => sums_sum_delay_held_0_memory_read_address, read_data => sums_sum_delay_held_0,
      write_address => sums_sum_delay_held_0_memory_write_address, write_data => sums_sum_delay_held_0_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_2_memory_write_data <= to_unsigned(sums_turn_write_sums_2, 28);
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 29, width => 28, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums_2,
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_1_memory_write_data <= to_unsigned(sums_turn_write_sums_1, 28);
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 29, width => 28, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums_1,
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_sums_0_memory_write_data <= to_unsigned(sums_turn_write_sums_0, 28);
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 29, width => 28, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums_0,
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_costs_1_memory_write_data <= to_unsigned(sums_turn_write_costs_1, 16);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 29, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs_1,
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_costs_0_memory_write_data <= sums_turn_write_costs_0;
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 29, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs_0,
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 5);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 4);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 29, width => 4, address_bits => 5)
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
  forward_cost_delay_held_1_memory_write_data <= to_unsigned(entry_cost_11, 4) & to_unsigned(entry_cost_10, 4) & to_unsigned(entry_cost_9, 4) & to_unsigned(entry_cost_8, 4);
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 5, width => 16, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held_1,
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= to_unsigned(entry_cost_7, 4) & to_unsigned(entry_cost_6, 4) & to_unsigned(entry_cost_5, 4) & to_unsigned(entry_cost_4, 4) & to_unsigned(entry_cost_3, 4) & to_unsigned(entry_cost_2, 4) & to_unsigned(entry_cost_1, 4) & to_unsigned(entry_cost_0, 4);
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 5, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held_0,
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= raster_features_reference_0;
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_read_column_inside_0_value, transform_read_column_inside_0_value_2 : boolean;
    variable transform_read_column_inside_0_value_3, transform_read_column_inside_1_differs : boolean;
    variable transform_read_column_inside_2_is_equal, transform_read_column_inside_3_value : boolean;
    variable transform_read_column_inside_5_is_equal, transform_read_column_inside_5_choice : boolean;
    variable transform_read_column_inside_5_choice_2, transform_read_column_inside_5_is_equal_2 : boolean;
    variable transform_read_column_inside_5_choice_3, transform_read_column_inside_6_choice : boolean;
    variable transform_read_column_inside_7_choice, transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_any, transform_left_filter_feature_0_choice : boolean;
    variable transform_left_filter_feature_0_is_equal, transform_left_filter_feature_0_choice_2 : boolean;
    variable transform_left_filter_feature_0_value_2, transform_left_filter_feature_0_choice_3 : boolean;
    variable transform_left_filter_feature_0_value_3, transform_left_filter_feature_0_choice_4 : boolean;
    variable transform_left_filter_feature_0_value_4, transform_left_filter_feature_0_choice_5 : boolean;
    variable transform_left_filter_feature_0_value_5, transform_left_filter_feature_0_choice_6 : boolean;
    variable transform_left_filter_feature_0_value_6, transform_left_filter_feature_0_choice_7 : boolean;
    variable transform_left_filter_feature_0_choice_8, transform_left_filter_feature_0_choice_9 : boolean;
    variable transform_left_filter_feature_0_choice_10, transform_left_filter_feature_0_choice_11 : boolean;
    variable transform_left_filter_feature_0_choice_12, transform_left_filter_feature_0_choice_13 : boolean;
    variable transform_left_filter_feature_0_choice_14, transform_left_filter_feature_0_choice_15 : boolean;
    variable transform_left_filter_feature_0_choice_16, transform_left_filter_feature_0_choice_17 : boolean;
    variable transform_left_filter_feature_0_choice_18, transform_left_filter_feature_0_choice_19 : boolean;
    variable transform_left_filter_feature_0_choice_20, transform_left_filter_feature_0_choice_21 : boolean;
    variable transform_left_filter_feature_0_choice_22, transform_left_filter_feature_0_choice_23 : boolean;
    variable transform_left_filter_feature_0_choice_24, transform_left_filter_feature_0_choice_25 : boolean;
    variable transform_left_filter_feature_0_choice_26, transform_left_filter_feature_0_choice_27 : boolean;
    variable transform_left_filter_feature_0_choice_28, transform_left_filter_feature_0_choice_29 : boolean;
    variable transform_left_filter_feature_0_choice_30, transform_left_filter_feature_0_choice_31 : boolean;
    variable transform_left_filter_feature_0_choice_32, transform_left_filter_feature_0_choice_33 : boolean;
    variable transform_left_filter_feature_0_choice_34, transform_left_filter_feature_0_choice_35 : boolean;
    variable transform_left_filter_feature_0_choice_36, transform_left_filter_feature_0_choice_37 : boolean;
    variable transform_left_filter_feature_0_choice_38, transform_left_filter_feature_0_choice_39 : boolean;
    variable transform_left_filter_feature_0_choice_40, transform_left_filter_feature_0_choice_41 : boolean;
    variable transform_left_filter_feature_0_choice_42, transform_left_filter_feature_0_choice_43 : boolean;
    variable transform_left_filter_feature_0_choice_44, transform_left_filter_feature_0_choice_45 : boolean;
    variable transform_left_filter_feature_0_choice_46, transform_left_filter_feature_0_choice_47 : boolean;
    variable transform_left_filter_feature_0_choice_48, transform_left_filter_feature_0_choice_49 : boolean;
    variable transform_left_filter_feature_0_choice_50, transform_left_filter_feature_0_choice_51 : boolean;
    variable transform_left_filter_feature_0_choice_52, transform_left_filter_feature_0_choice_53 : boolean;
    variable transform_left_filter_feature_0_choice_54, transform_left_filter_feature_0_choice_55 : boolean;
    variable transform_left_filter_feature_0_choice_56, transform_left_filter_feature_0_choice_57 : boolean;
    variable transform_left_filter_feature_0_choice_58, transform_left_filter_feature_0_choice_59 : boolean;
    variable transform_left_filter_feature_0_choice_60, transform_left_filter_feature_0_choice_61 : boolean;
    variable transform_left_filter_feature_0_choice_62, transform_left_filter_feature_0_choice_63 : boolean;
    variable transform_left_filter_feature_0_choice_64, transform_left_filter_feature_0_choice_65 : boolean;
    variable transform_left_filter_feature_0_choice_66, transform_left_filter_feature_0_choice_67 : boolean;
    variable transform_left_filter_feature_0_choice_68, transform_left_filter_feature_0_choice_69 : boolean;
    variable transform_left_filter_feature_0_choice_70, transform_left_filter_feature_0_choice_71 : boolean;
    variable transform_left_filter_feature_0_choice_72, transform_left_filter_feature_0_choice_73 : boolean;
    variable transform_left_filter_feature_0_choice_74, transform_left_filter_feature_0_choice_75 : boolean;
    variable transform_left_filter_feature_0_choice_76, transform_left_filter_feature_0_choice_77 : boolean;
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
    variable transform_left_filter_feature_0_choice_102, transform_left_filter_feature_0_choice_103 : boolean;
    variable transform_left_filter_feature_0_choice_104, transform_left_filter_feature_0_choice_105 : boolean;
    variable transform_left_filter_feature_0_choice_106, transform_left_filter_feature_0_choice_107 : boolean;
    variable transform_left_filter_feature_0_choice_108, transform_left_filter_feature_0_choice_109 : boolean;
    variable transform_left_filter_feature_0_choice_110, transform_left_filter_feature_0_choice_111 : boolean;
    variable transform_left_filter_feature_0_choice_112, transform_left_filter_feature_0_choice_113 : boolean;
    variable transform_left_filter_feature_0_choice_114, transform_left_filter_feature_0_choice_115 : boolean;
    variable transform_left_filter_feature_0_choice_116, transform_left_filter_feature_0_choice_117 : boolean;
    variable transform_left_filter_feature_0_choice_118, transform_left_filter_feature_0_choice_119 : boolean;
    variable transform_left_filter_feature_0_choice_120, transform_left_filter_feature_0_choice_121 : boolean;
    variable transform_left_filter_feature_0_choice_122, transform_left_filter_feature_0_choice_123 : boolean;
    variable transform_left_filter_feature_0_choice_124, transform_left_filter_feature_0_choice_125 : boolean;
    variable transform_left_filter_feature_0_choice_126, transform_left_filter_feature_0_choice_127 : boolean;
    variable transform_left_filter_feature_0_choice_128, transform_left_filter_feature_0_choice_129 : boolean;
    variable transform_left_filter_feature_0_choice_130, transform_left_filter_feature_0_choice_131 : boolean;
    variable transform_left_filter_feature_0_choice_132, transform_left_filter_feature_0_choice_133 : boolean;
    variable transform_left_filter_feature_0_choice_134, transform_left_filter_feature_0_choice_135 : boolean;
    variable transform_left_filter_feature_0_choice_136, transform_left_filter_feature_0_choice_137 : boolean;
    variable transform_left_filter_feature_0_choice_138, transform_left_filter_feature_0_choice_139 : boolean;
    variable transform_left_filter_feature_0_choice_140, transform_left_filter_feature_0_choice_141 : boolean;
    variable transform_left_filter_feature_0_choice_142, transform_left_filter_feature_0_choice_143 : boolean;
    variable transform_left_filter_feature_0_choice_144, transform_left_filter_feature_0_choice_145 : boolean;
    variable transform_left_filter_feature_0_choice_146, transform_left_filter_feature_0_choice_147 : boolean;
    variable transform_left_filter_feature_0_choice_148, transform_left_filter_feature_0_choice_149 : boolean;
    variable transform_left_filter_feature_0_choice_150, transform_left_filter_feature_0_choice_151 : boolean;
    variable transform_left_filter_feature_0_choice_152, transform_left_filter_feature_0_choice_153 : boolean;
    variable transform_left_filter_feature_0_choice_154, transform_left_filter_feature_0_choice_155 : boolean;
    variable transform_left_filter_feature_0_choice_156, transform_left_filter_feature_0_choice_157 : boolean;
    variable transform_left_filter_feature_0_choice_158, transform_left_filter_feature_0_choice_159 : boolean;
    variable transform_left_filter_feature_0_choice_160, transform_left_filter_feature_0_choice_161 : boolean;
    variable transform_left_filter_feature_0_choice_162, transform_left_filter_feature_0_choice_163 : boolean;
    variable transform_left_filter_feature_0_choice_164, transform_left_filter_feature_0_choice_165 : boolean;
    variable transform_left_filter_feature_0_choice_166, transform_left_filter_feature_0_choice_167 : boolean;
    variable transform_left_filter_feature_0_choice_168, transform_left_filter_feature_0_choice_169 : boolean;
    variable transform_left_filter_feature_0_choice_170, transform_left_filter_feature_0_choice_171 : boolean;
    variable transform_left_filter_feature_0_choice_172, transform_left_filter_feature_0_choice_173 : boolean;
    variable transform_left_filter_feature_0_choice_174, transform_left_filter_feature_0_choice_175 : boolean;
    variable transform_left_filter_feature_0_choice_176, transform_left_filter_feature_0_choice_177 : boolean;
    variable transform_left_filter_feature_0_choice_178, transform_left_filter_feature_0_choice_179 : boolean;
    variable transform_left_filter_feature_0_choice_180, transform_left_filter_feature_0_choice_181 : boolean;
    variable transform_left_filter_feature_0_choice_182, transform_left_filter_feature_0_choice_183 : boolean;
    variable transform_left_filter_feature_0_choice_184, transform_left_filter_feature_0_choice_185 : boolean;
    variable transform_left_filter_feature_0_choice_186, transform_left_filter_feature_0_choice_187 : boolean;
    variable transform_left_filter_feature_0_choice_188, transform_left_filter_feature_0_choice_189 : boolean;
    variable transform_left_filter_feature_0_choice_190, transform_left_filter_feature_0_choice_191 : boolean;
    variable transform_left_filter_feature_0_choice_192, transform_left_filter_feature_0_choice_193 : boolean;
    variable transform_left_filter_feature_0_choice_194, transform_left_filter_feature_0_choice_195 : boolean;
    variable transform_left_filter_feature_0_choice_196, transform_left_filter_feature_0_choice_197 : boolean;
    variable transform_left_filter_feature_0_choice_198, transform_left_filter_feature_0_choice_199 : boolean;
    variable transform_left_filter_feature_0_choice_200, transform_left_filter_feature_0_choice_201 : boolean;
    variable transform_left_filter_feature_0_choice_202, transform_left_filter_feature_0_choice_203 : boolean;
    variable transform_left_filter_feature_0_choice_204, transform_left_filter_feature_0_choice_205 : boolean;
    variable transform_left_filter_feature_0_choice_206, transform_left_filter_feature_0_choice_207 : boolean;
    variable transform_left_filter_feature_0_choice_208, transform_left_filter_feature_0_choice_209 : boolean;
    variable transform_left_filter_feature_0_choice_210, transform_left_filter_feature_0_choice_211 : boolean;
    variable transform_left_filter_feature_0_choice_212, transform_left_filter_feature_0_choice_213 : boolean;
    variable transform_left_filter_feature_0_choice_214, transform_left_filter_feature_0_choice_215 : boolean;
    variable transform_left_filter_feature_0_choice_216, transform_left_filter_feature_0_choice_217 : boolean;
    variable transform_left_filter_feature_0_choice_218, transform_left_filter_feature_0_choice_219 : boolean;
    variable transform_left_filter_feature_0_choice_220, transform_left_filter_feature_0_choice_221 : boolean;
    variable transform_left_filter_feature_0_choice_222, transform_left_filter_feature_0_choice_223 : boolean;
    variable transform_left_filter_feature_0_choice_224, transform_left_filter_feature_0_choice_225 : boolean;
    variable transform_left_filter_feature_0_choice_226, transform_left_filter_feature_0_choice_227 : boolean;
    variable transform_left_filter_feature_0_choice_228, transform_left_filter_feature_0_choice_229 : boolean;
    variable transform_left_filter_feature_0_choice_230, transform_left_filter_feature_0_choice_231 : boolean;
    variable transform_left_filter_feature_0_choice_232, transform_left_filter_feature_0_choice_233 : boolean;
    variable transform_left_filter_feature_0_choice_234, transform_left_filter_feature_0_choice_235 : boolean;
    variable transform_left_filter_feature_0_choice_236, transform_left_filter_feature_0_choice_237 : boolean;
    variable transform_left_filter_feature_0_choice_238, transform_left_filter_feature_0_choice_239 : boolean;
    variable transform_left_filter_feature_0_choice_240, transform_left_filter_feature_0_choice_241 : boolean;
    variable transform_left_filter_feature_0_choice_242, transform_left_filter_feature_0_choice_243 : boolean;
    variable transform_left_filter_feature_0_choice_244, transform_left_filter_feature_0_choice_245 : boolean;
    variable transform_left_filter_feature_0_choice_246, transform_left_filter_feature_0_choice_247 : boolean;
    variable transform_left_filter_feature_0_choice_248, transform_left_filter_feature_0_choice_249 : boolean;
    variable transform_left_filter_feature_0_choice_250, transform_left_filter_feature_0_choice_251 : boolean;
    variable transform_left_filter_feature_0_choice_252, transform_left_filter_feature_0_choice_253 : boolean;
    variable transform_left_filter_feature_0_choice_254, transform_left_filter_feature_0_choice_255 : boolean;
    variable transform_left_filter_feature_0_choice_256, transform_left_filter_feature_0_choice_257 : boolean;
    variable transform_left_filter_feature_0_choice_258, transform_left_filter_feature_0_choice_259 : boolean;
    variable transform_left_filter_feature_0_choice_260, transform_left_filter_feature_0_choice_261 : boolean;
    variable transform_left_filter_feature_0_choice_262, transform_left_filter_feature_0_choice_263 : boolean;
    variable transform_left_filter_feature_0_choice_264, transform_left_filter_feature_0_choice_265 : boolean;
    variable transform_left_filter_feature_0_choice_266, transform_left_filter_feature_0_choice_267 : boolean;
    variable transform_left_filter_feature_0_choice_268, transform_left_filter_feature_0_choice_269 : boolean;
    variable transform_left_filter_feature_0_choice_270, transform_left_filter_feature_0_choice_271 : boolean;
    variable transform_left_filter_feature_0_choice_272, transform_left_filter_feature_0_choice_273 : boolean;
    variable transform_left_filter_feature_0_choice_274, transform_left_filter_feature_0_choice_275 : boolean;
    variable transform_left_filter_feature_0_choice_276, transform_left_filter_feature_0_choice_277 : boolean;
    variable transform_left_filter_feature_0_choice_278, transform_left_filter_feature_0_choice_279 : boolean;
    variable transform_left_filter_feature_0_choice_280, transform_left_filter_feature_0_choice_281 : boolean;
    variable transform_left_filter_feature_0_choice_282, transform_left_filter_feature_0_choice_283 : boolean;
    variable transform_left_filter_feature_0_choice_284, transform_left_filter_feature_0_choice_285 : boolean;
    variable transform_left_filter_feature_0_choice_286, transform_left_filter_feature_0_choice_287 : boolean;
    variable transform_left_filter_feature_0_choice_288, transform_left_filter_feature_0_choice_289 : boolean;
    variable transform_left_filter_feature_0_choice_290, transform_left_filter_feature_0_choice_291 : boolean;
    variable transform_left_filter_feature_0_choice_292, transform_left_filter_feature_0_choice_293 : boolean;
    variable transform_left_filter_feature_0_choice_294, transform_left_filter_feature_0_choice_295 : boolean;
    variable transform_left_filter_feature_0_choice_296, transform_left_filter_feature_0_choice_297 : boolean;
    variable transform_left_filter_feature_0_choice_298, transform_left_filter_feature_0_choice_299 : boolean;
    variable transform_left_filter_feature_0_choice_300, transform_left_filter_feature_0_choice_301 : boolean;
    variable transform_left_filter_feature_0_choice_302, transform_left_filter_feature_0_choice_303 : boolean;
    variable transform_left_filter_feature_0_choice_304, transform_left_filter_feature_0_choice_305 : boolean;
    variable transform_left_filter_feature_0_choice_306, transform_left_filter_feature_0_choice_307 : boolean;
    variable transform_left_filter_feature_0_choice_308, transform_left_filter_feature_0_choice_309 : boolean;
    variable transform_left_filter_feature_0_choice_310, transform_left_filter_feature_0_choice_311 : boolean;
    variable transform_left_filter_feature_0_choice_312, transform_left_filter_feature_0_choice_313 : boolean;
    variable transform_left_filter_feature_0_choice_314, transform_left_filter_feature_0_choice_315 : boolean;
    variable transform_left_filter_feature_0_choice_316, transform_left_filter_feature_0_choice_317 : boolean;
    variable transform_left_filter_feature_0_choice_318, transform_left_filter_feature_0_choice_319 : boolean;
    variable transform_left_filter_feature_0_choice_320, transform_left_filter_feature_0_choice_321 : boolean;
    variable transform_left_filter_feature_0_choice_322, transform_left_filter_feature_0_choice_323 : boolean;
    variable transform_left_filter_feature_0_choice_324, transform_left_filter_feature_0_choice_325 : boolean;
    variable transform_left_filter_feature_0_choice_326, transform_left_filter_feature_0_choice_327 : boolean;
    variable transform_left_filter_feature_0_choice_328, transform_left_filter_feature_0_choice_329 : boolean;
    variable transform_left_filter_feature_0_choice_330, transform_left_filter_feature_0_choice_331 : boolean;
    variable transform_left_filter_feature_0_choice_332, transform_left_filter_feature_0_choice_333 : boolean;
    variable transform_left_filter_feature_0_choice_334, transform_left_filter_feature_0_choice_335 : boolean;
    variable transform_left_filter_feature_0_choice_336, transform_left_filter_feature_0_choice_337 : boolean;
    variable transform_left_filter_feature_0_choice_338, transform_left_filter_feature_0_choice_339 : boolean;
    variable transform_left_filter_feature_0_choice_340, transform_left_filter_feature_0_choice_341 : boolean;
    variable transform_left_filter_feature_0_choice_342, transform_left_filter_feature_0_choice_343 : boolean;
    variable transform_left_filter_feature_0_choice_344, transform_left_filter_feature_0_choice_345 : boolean;
    variable transform_left_filter_feature_0_choice_346, transform_left_filter_feature_0_value_7 : boolean;
    variable transform_left_filter_feature_0_choice_347, transform_left_filter_feature_0_value_8 : boolean;
    variable transform_left_filter_feature_0_choice_348, transform_left_filter_feature_0_value_9 : boolean;
    variable transform_left_filter_feature_0_choice_349, transform_left_filter_feature_0_value_10 : boolean;
    variable transform_left_filter_feature_0_choice_350, transform_left_filter_feature_0_value_11 : boolean;
    variable transform_left_filter_feature_0_choice_351, transform_left_filter_feature_0_choice_352 : boolean;
    variable transform_right_filter_feature_0_value, transform_right_filter_feature_0_any : boolean;
    variable transform_right_filter_feature_0_choice, transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choice_2, transform_right_filter_feature_0_value_2 : boolean;
    variable transform_right_filter_feature_0_choice_3, transform_right_filter_feature_0_value_3 : boolean;
    variable transform_right_filter_feature_0_choice_4, transform_right_filter_feature_0_value_4 : boolean;
    variable transform_right_filter_feature_0_choice_5, transform_right_filter_feature_0_value_5 : boolean;
    variable transform_right_filter_feature_0_choice_6, transform_right_filter_feature_0_value_6 : boolean;
    variable transform_right_filter_feature_0_choice_7, transform_right_filter_feature_0_choice_8 : boolean;
    variable transform_right_filter_feature_0_choice_9, transform_right_filter_feature_0_choice_10 : boolean;
    variable transform_right_filter_feature_0_choice_11, transform_right_filter_feature_0_choice_12 : boolean;
    variable transform_right_filter_feature_0_choice_13, transform_right_filter_feature_0_choice_14 : boolean;
    variable transform_right_filter_feature_0_choice_15, transform_right_filter_feature_0_choice_16 : boolean;
    variable transform_right_filter_feature_0_choice_17, transform_right_filter_feature_0_choice_18 : boolean;
    variable transform_right_filter_feature_0_choice_19, transform_right_filter_feature_0_choice_20 : boolean;
    variable transform_right_filter_feature_0_choice_21, transform_right_filter_feature_0_choice_22 : boolean;
    variable transform_right_filter_feature_0_choice_23, transform_right_filter_feature_0_choice_24 : boolean;
    variable transform_right_filter_feature_0_choice_25, transform_right_filter_feature_0_choice_26 : boolean;
    variable transform_right_filter_feature_0_choice_27, transform_right_filter_feature_0_choice_28 : boolean;
    variable transform_right_filter_feature_0_choice_29, transform_right_filter_feature_0_choice_30 : boolean;
    variable transform_right_filter_feature_0_choice_31, transform_right_filter_feature_0_choice_32 : boolean;
    variable transform_right_filter_feature_0_choice_33, transform_right_filter_feature_0_choice_34 : boolean;
    variable transform_right_filter_feature_0_choice_35, transform_right_filter_feature_0_choice_36 : boolean;
    variable transform_right_filter_feature_0_choice_37, transform_right_filter_feature_0_choice_38 : boolean;
    variable transform_right_filter_feature_0_choice_39, transform_right_filter_feature_0_choice_40 : boolean;
    variable transform_right_filter_feature_0_choice_41, transform_right_filter_feature_0_choice_42 : boolean;
    variable transform_right_filter_feature_0_choice_43, transform_right_filter_feature_0_choice_44 : boolean;
    variable transform_right_filter_feature_0_choice_45, transform_right_filter_feature_0_choice_46 : boolean;
    variable transform_right_filter_feature_0_choice_47, transform_right_filter_feature_0_choice_48 : boolean;
    variable transform_right_filter_feature_0_choice_49, transform_right_filter_feature_0_choice_50 : boolean;
    variable transform_right_filter_feature_0_choice_51, transform_right_filter_feature_0_choice_52 : boolean;
    variable transform_right_filter_feature_0_choice_53, transform_right_filter_feature_0_choice_54 : boolean;
    variable transform_right_filter_feature_0_choice_55, transform_right_filter_feature_0_choice_56 : boolean;
    variable transform_right_filter_feature_0_choice_57, transform_right_filter_feature_0_choice_58 : boolean;
    variable transform_right_filter_feature_0_choice_59, transform_right_filter_feature_0_choice_60 : boolean;
    variable transform_right_filter_feature_0_choice_61, transform_right_filter_feature_0_choice_62 : boolean;
    variable transform_right_filter_feature_0_choice_63, transform_right_filter_feature_0_choice_64 : boolean;
    variable transform_right_filter_feature_0_choice_65, transform_right_filter_feature_0_choice_66 : boolean;
    variable transform_right_filter_feature_0_choice_67, transform_right_filter_feature_0_choice_68 : boolean;
    variable transform_right_filter_feature_0_choice_69, transform_right_filter_feature_0_choice_70 : boolean;
    variable transform_right_filter_feature_0_choice_71, transform_right_filter_feature_0_choice_72 : boolean;
    variable transform_right_filter_feature_0_choice_73, transform_right_filter_feature_0_choice_74 : boolean;
    variable transform_right_filter_feature_0_choice_75, transform_right_filter_feature_0_choice_76 : boolean;
    variable transform_right_filter_feature_0_choice_77, transform_right_filter_feature_0_choice_78 : boolean;
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
    variable transform_right_filter_feature_0_choice_105, transform_right_filter_feature_0_choice_106 : boolean;
    variable transform_right_filter_feature_0_choice_107, transform_right_filter_feature_0_choice_108 : boolean;
    variable transform_right_filter_feature_0_choice_109, transform_right_filter_feature_0_choice_110 : boolean;
    variable transform_right_filter_feature_0_choice_111, transform_right_filter_feature_0_choice_112 : boolean;
    variable transform_right_filter_feature_0_choice_113, transform_right_filter_feature_0_choice_114 : boolean;
    variable transform_right_filter_feature_0_choice_115, transform_right_filter_feature_0_choice_116 : boolean;
    variable transform_right_filter_feature_0_choice_117, transform_right_filter_feature_0_choice_118 : boolean;
    variable transform_right_filter_feature_0_choice_119, transform_right_filter_feature_0_choice_120 : boolean;
    variable transform_right_filter_feature_0_choice_121, transform_right_filter_feature_0_choice_122 : boolean;
    variable transform_right_filter_feature_0_choice_123, transform_right_filter_feature_0_choice_124 : boolean;
    variable transform_right_filter_feature_0_choice_125, transform_right_filter_feature_0_choice_126 : boolean;
    variable transform_right_filter_feature_0_choice_127, transform_right_filter_feature_0_choice_128 : boolean;
    variable transform_right_filter_feature_0_choice_129, transform_right_filter_feature_0_choice_130 : boolean;
    variable transform_right_filter_feature_0_choice_131, transform_right_filter_feature_0_choice_132 : boolean;
    variable transform_right_filter_feature_0_choice_133, transform_right_filter_feature_0_choice_134 : boolean;
    variable transform_right_filter_feature_0_choice_135, transform_right_filter_feature_0_choice_136 : boolean;
    variable transform_right_filter_feature_0_choice_137, transform_right_filter_feature_0_choice_138 : boolean;
    variable transform_right_filter_feature_0_choice_139, transform_right_filter_feature_0_choice_140 : boolean;
    variable transform_right_filter_feature_0_choice_141, transform_right_filter_feature_0_choice_142 : boolean;
    variable transform_right_filter_feature_0_choice_143, transform_right_filter_feature_0_choice_144 : boolean;
    variable transform_right_filter_feature_0_choice_145, transform_right_filter_feature_0_choice_146 : boolean;
    variable transform_right_filter_feature_0_choice_147, transform_right_filter_feature_0_choice_148 : boolean;
    variable transform_right_filter_feature_0_choice_149, transform_right_filter_feature_0_choice_150 : boolean;
    variable transform_right_filter_feature_0_choice_151, transform_right_filter_feature_0_choice_152 : boolean;
    variable transform_right_filter_feature_0_choice_153, transform_right_filter_feature_0_choice_154 : boolean;
    variable transform_right_filter_feature_0_choice_155, transform_right_filter_feature_0_choice_156 : boolean;
    variable transform_right_filter_feature_0_choice_157, transform_right_filter_feature_0_choice_158 : boolean;
    variable transform_right_filter_feature_0_choice_159, transform_right_filter_feature_0_choice_160 : boolean;
    variable transform_right_filter_feature_0_choice_161, transform_right_filter_feature_0_choice_162 : boolean;
    variable transform_right_filter_feature_0_choice_163, transform_right_filter_feature_0_choice_164 : boolean;
    variable transform_right_filter_feature_0_choice_165, transform_right_filter_feature_0_choice_166 : boolean;
    variable transform_right_filter_feature_0_choice_167, transform_right_filter_feature_0_choice_168 : boolean;
    variable transform_right_filter_feature_0_choice_169, transform_right_filter_feature_0_choice_170 : boolean;
    variable transform_right_filter_feature_0_choice_171, transform_right_filter_feature_0_choice_172 : boolean;
    variable transform_right_filter_feature_0_choice_173, transform_right_filter_feature_0_choice_174 : boolean;
    variable transform_right_filter_feature_0_choice_175, transform_right_filter_feature_0_choice_176 : boolean;
    variable transform_right_filter_feature_0_choice_177, transform_right_filter_feature_0_choice_178 : boolean;
    variable transform_right_filter_feature_0_choice_179, transform_right_filter_feature_0_choice_180 : boolean;
    variable transform_right_filter_feature_0_choice_181, transform_right_filter_feature_0_choice_182 : boolean;
    variable transform_right_filter_feature_0_choice_183, transform_right_filter_feature_0_choice_184 : boolean;
    variable transform_right_filter_feature_0_choice_185, transform_right_filter_feature_0_choice_186 : boolean;
    variable transform_right_filter_feature_0_choice_187, transform_right_filter_feature_0_choice_188 : boolean;
    variable transform_right_filter_feature_0_choice_189, transform_right_filter_feature_0_choice_190 : boolean;
    variable transform_right_filter_feature_0_choice_191, transform_right_filter_feature_0_choice_192 : boolean;
    variable transform_right_filter_feature_0_choice_193, transform_right_filter_feature_0_choice_194 : boolean;
    variable transform_right_filter_feature_0_choice_195, transform_right_filter_feature_0_choice_196 : boolean;
    variable transform_right_filter_feature_0_choice_197, transform_right_filter_feature_0_choice_198 : boolean;
    variable transform_right_filter_feature_0_choice_199, transform_right_filter_feature_0_choice_200 : boolean;
    variable transform_right_filter_feature_0_choice_201, transform_right_filter_feature_0_choice_202 : boolean;
    variable transform_right_filter_feature_0_choice_203, transform_right_filter_feature_0_choice_204 : boolean;
    variable transform_right_filter_feature_0_choice_205, transform_right_filter_feature_0_choice_206 : boolean;
    variable transform_right_filter_feature_0_choice_207, transform_right_filter_feature_0_choice_208 : boolean;
    variable transform_right_filter_feature_0_choice_209, transform_right_filter_feature_0_choice_210 : boolean;
    variable transform_right_filter_feature_0_choice_211, transform_right_filter_feature_0_choice_212 : boolean;
    variable transform_right_filter_feature_0_choice_213, transform_right_filter_feature_0_choice_214 : boolean;
    variable transform_right_filter_feature_0_choice_215, transform_right_filter_feature_0_choice_216 : boolean;
    variable transform_right_filter_feature_0_choice_217, transform_right_filter_feature_0_choice_218 : boolean;
    variable transform_right_filter_feature_0_choice_219, transform_right_filter_feature_0_choice_220 : boolean;
    variable transform_right_filter_feature_0_choice_221, transform_right_filter_feature_0_choice_222 : boolean;
    variable transform_right_filter_feature_0_choice_223, transform_right_filter_feature_0_choice_224 : boolean;
    variable transform_right_filter_feature_0_choice_225, transform_right_filter_feature_0_choice_226 : boolean;
    variable transform_right_filter_feature_0_choice_227, transform_right_filter_feature_0_choice_228 : boolean;
    variable transform_right_filter_feature_0_choice_229, transform_right_filter_feature_0_choice_230 : boolean;
    variable transform_right_filter_feature_0_choice_231, transform_right_filter_feature_0_choice_232 : boolean;
    variable transform_right_filter_feature_0_choice_233, transform_right_filter_feature_0_choice_234 : boolean;
    variable transform_right_filter_feature_0_choice_235, transform_right_filter_feature_0_choice_236 : boolean;
    variable transform_right_filter_feature_0_choice_237, transform_right_filter_feature_0_choice_238 : boolean;
    variable transform_right_filter_feature_0_choice_239, transform_right_filter_feature_0_choice_240 : boolean;
    variable transform_right_filter_feature_0_choice_241, transform_right_filter_feature_0_choice_242 : boolean;
    variable transform_right_filter_feature_0_choice_243, transform_right_filter_feature_0_choice_244 : boolean;
    variable transform_right_filter_feature_0_choice_245, transform_right_filter_feature_0_choice_246 : boolean;
    variable transform_right_filter_feature_0_choice_247, transform_right_filter_feature_0_choice_248 : boolean;
    variable transform_right_filter_feature_0_choice_249, transform_right_filter_feature_0_choice_250 : boolean;
    variable transform_right_filter_feature_0_choice_251, transform_right_filter_feature_0_choice_252 : boolean;
    variable transform_right_filter_feature_0_choice_253, transform_right_filter_feature_0_choice_254 : boolean;
    variable transform_right_filter_feature_0_choice_255, transform_right_filter_feature_0_choice_256 : boolean;
    variable transform_right_filter_feature_0_choice_257, transform_right_filter_feature_0_choice_258 : boolean;
    variable transform_right_filter_feature_0_choice_259, transform_right_filter_feature_0_choice_260 : boolean;
    variable transform_right_filter_feature_0_choice_261, transform_right_filter_feature_0_choice_262 : boolean;
    variable transform_right_filter_feature_0_choice_263, transform_right_filter_feature_0_choice_264 : boolean;
    variable transform_right_filter_feature_0_choice_265, transform_right_filter_feature_0_choice_266 : boolean;
    variable transform_right_filter_feature_0_choice_267, transform_right_filter_feature_0_choice_268 : boolean;
    variable transform_right_filter_feature_0_choice_269, transform_right_filter_feature_0_choice_270 : boolean;
    variable transform_right_filter_feature_0_choice_271, transform_right_filter_feature_0_choice_272 : boolean;
    variable transform_right_filter_feature_0_choice_273, transform_right_filter_feature_0_choice_274 : boolean;
    variable transform_right_filter_feature_0_choice_275, transform_right_filter_feature_0_choice_276 : boolean;
    variable transform_right_filter_feature_0_choice_277, transform_right_filter_feature_0_choice_278 : boolean;
    variable transform_right_filter_feature_0_choice_279, transform_right_filter_feature_0_choice_280 : boolean;
    variable transform_right_filter_feature_0_choice_281, transform_right_filter_feature_0_choice_282 : boolean;
    variable transform_right_filter_feature_0_choice_283, transform_right_filter_feature_0_choice_284 : boolean;
    variable transform_right_filter_feature_0_choice_285, transform_right_filter_feature_0_choice_286 : boolean;
    variable transform_right_filter_feature_0_choice_287, transform_right_filter_feature_0_choice_288 : boolean;
    variable transform_right_filter_feature_0_choice_289, transform_right_filter_feature_0_choice_290 : boolean;
    variable transform_right_filter_feature_0_choice_291, transform_right_filter_feature_0_choice_292 : boolean;
    variable transform_right_filter_feature_0_choice_293, transform_right_filter_feature_0_choice_294 : boolean;
    variable transform_right_filter_feature_0_choice_295, transform_right_filter_feature_0_choice_296 : boolean;
    variable transform_right_filter_feature_0_choice_297, transform_right_filter_feature_0_choice_298 : boolean;
    variable transform_right_filter_feature_0_choice_299, transform_right_filter_feature_0_choice_300 : boolean;
    variable transform_right_filter_feature_0_choice_301, transform_right_filter_feature_0_choice_302 : boolean;
    variable transform_right_filter_feature_0_choice_303, transform_right_filter_feature_0_choice_304 : boolean;
    variable transform_right_filter_feature_0_choice_305, transform_right_filter_feature_0_choice_306 : boolean;
    variable transform_right_filter_feature_0_choice_307, transform_right_filter_feature_0_choice_308 : boolean;
    variable transform_right_filter_feature_0_choice_309, transform_right_filter_feature_0_choice_310 : boolean;
    variable transform_right_filter_feature_0_choice_311, transform_right_filter_feature_0_choice_312 : boolean;
    variable transform_right_filter_feature_0_choice_313, transform_right_filter_feature_0_choice_314 : boolean;
    variable transform_right_filter_feature_0_choice_315, transform_right_filter_feature_0_choice_316 : boolean;
    variable transform_right_filter_feature_0_choice_317, transform_right_filter_feature_0_choice_318 : boolean;
    variable transform_right_filter_feature_0_choice_319, transform_right_filter_feature_0_choice_320 : boolean;
    variable transform_right_filter_feature_0_choice_321, transform_right_filter_feature_0_choice_322 : boolean;
    variable transform_right_filter_feature_0_choice_323, transform_right_filter_feature_0_choice_324 : boolean;
    variable transform_right_filter_feature_0_choice_325, transform_right_filter_feature_0_choice_326 : boolean;
    variable transform_right_filter_feature_0_choice_327, transform_right_filter_feature_0_choice_328 : boolean;
    variable transform_right_filter_feature_0_choice_329, transform_right_filter_feature_0_choice_330 : boolean;
    variable transform_right_filter_feature_0_choice_331, transform_right_filter_feature_0_choice_332 : boolean;
    variable transform_right_filter_feature_0_choice_333, transform_right_filter_feature_0_choice_334 : boolean;
    variable transform_right_filter_feature_0_choice_335, transform_right_filter_feature_0_choice_336 : boolean;
    variable transform_right_filter_feature_0_choice_337, transform_right_filter_feature_0_choice_338 : boolean;
    variable transform_right_filter_feature_0_choice_339, transform_right_filter_feature_0_choice_340 : boolean;
    variable transform_right_filter_feature_0_choice_341, transform_right_filter_feature_0_choice_342 : boolean;
    variable transform_right_filter_feature_0_choice_343, transform_right_filter_feature_0_choice_344 : boolean;
    variable transform_right_filter_feature_0_choice_345, transform_right_filter_feature_0_choice_346 : boolean;
    variable transform_right_filter_feature_0_value_7, transform_right_filter_feature_0_choice_347 : boolean;
    variable transform_right_filter_feature_0_value_8, transform_right_filter_feature_0_choice_348 : boolean;
    variable transform_right_filter_feature_0_value_9, transform_right_filter_feature_0_choice_349 : boolean;
    variable transform_right_filter_feature_0_value_10, transform_right_filter_feature_0_choice_350 : boolean;
    variable transform_right_filter_feature_0_value_11, transform_right_filter_feature_0_choice_351 : boolean;
    variable transform_right_filter_feature_0_choice_352, transform_counter_next_frame_choice : boolean;
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, delay_tag_map_column_all : boolean;
    variable slice0cost_pixels_first_0_0_count_0_value, slice0cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value, slice0cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value_3, slice0cost_pixels_first_0_0_count_2_value : boolean;
    variable slice0cost_pixels_first_0_0_count_2_value_2, slice0cost_pixels_first_0_0_count_3_value : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value_2, slice0cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_4_value, slice0cost_pixels_first_0_0_count_4_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_4_value_3, slice0cost_pixels_first_0_0_count_5_value : boolean;
    variable slice0cost_pixels_first_0_0_count_5_value_2, slice0cost_pixels_first_0_0_count_5_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_6_value, slice0cost_pixels_first_0_0_count_6_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_6_value_3, slice0cost_pixels_first_0_0_count_7_value : boolean;
    variable slice0cost_pixels_first_0_0_count_7_value_2, slice0cost_pixels_first_0_0_count_7_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_8_value, slice0cost_pixels_first_0_0_count_8_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_8_value_3, slice0cost_pixels_first_0_0_count_9_value : boolean;
    variable slice0cost_pixels_first_0_0_count_9_value_2, slice0cost_pixels_first_0_0_count_9_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_10_value, slice0cost_pixels_first_0_0_count_10_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_10_value_3, slice0cost_pixels_first_0_0_count_11_value : boolean;
    variable slice0cost_pixels_first_0_0_count_11_value_2, slice0cost_pixels_first_0_0_count_11_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_12_value, slice0cost_pixels_first_0_0_count_12_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_12_value_3, slice0cost_pixels_first_0_0_count_13_value : boolean;
    variable slice0cost_pixels_first_0_0_count_13_value_2, slice0cost_pixels_first_0_0_count_13_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_14_value, slice1cost_pixels_first_0_0_count_0_value : boolean;
    variable slice1cost_pixels_first_0_0_count_0_value_2, slice1cost_pixels_first_0_0_count_1_value : boolean;
    variable slice1cost_pixels_first_0_0_count_1_value_2, slice1cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_2_value, slice1cost_pixels_first_0_0_count_2_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_3_value, slice1cost_pixels_first_0_0_count_3_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_3_value_3, slice1cost_pixels_first_0_0_count_4_value : boolean;
    variable slice1cost_pixels_first_0_0_count_4_value_2, slice1cost_pixels_first_0_0_count_4_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_5_value, slice1cost_pixels_first_0_0_count_5_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_5_value_3, slice1cost_pixels_first_0_0_count_6_value : boolean;
    variable slice1cost_pixels_first_0_0_count_6_value_2, slice1cost_pixels_first_0_0_count_6_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_7_value, slice1cost_pixels_first_0_0_count_7_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_7_value_3, slice1cost_pixels_first_0_0_count_8_value : boolean;
    variable slice1cost_pixels_first_0_0_count_8_value_2, slice1cost_pixels_first_0_0_count_8_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_9_value, slice1cost_pixels_first_0_0_count_9_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_9_value_3, slice1cost_pixels_first_0_0_count_10_value : boolean;
    variable slice1cost_pixels_first_0_0_count_10_value_2, slice1cost_pixels_first_0_0_count_10_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_11_value, slice1cost_pixels_first_0_0_count_11_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_11_value_3, slice1cost_pixels_first_0_0_count_12_value : boolean;
    variable slice1cost_pixels_first_0_0_count_12_value_2, slice1cost_pixels_first_0_0_count_12_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_13_value, slice1cost_pixels_first_0_0_count_13_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_13_value_3, slice1cost_pixels_first_0_0_count_14_value : boolean;
    variable slice2cost_pixels_first_0_0_count_0_value, slice2cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_1_value, slice2cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_1_value_3, slice2cost_pixels_first_0_0_count_2_value : boolean;
    variable slice2cost_pixels_first_0_0_count_2_value_2, slice2cost_pixels_first_0_0_count_3_value : boolean;
    variable slice2cost_pixels_first_0_0_count_3_value_2, slice2cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_4_value, slice2cost_pixels_first_0_0_count_4_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_4_value_3, slice2cost_pixels_first_0_0_count_5_value : boolean;
    variable slice2cost_pixels_first_0_0_count_5_value_2, slice2cost_pixels_first_0_0_count_5_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_6_value, slice2cost_pixels_first_0_0_count_6_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_6_value_3, slice2cost_pixels_first_0_0_count_7_value : boolean;
    variable slice2cost_pixels_first_0_0_count_7_value_2, slice2cost_pixels_first_0_0_count_7_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_8_value, slice2cost_pixels_first_0_0_count_8_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_8_value_3, slice2cost_pixels_first_0_0_count_9_value : boolean;
    variable slice2cost_pixels_first_0_0_count_9_value_2, slice2cost_pixels_first_0_0_count_9_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_10_value, slice2cost_pixels_first_0_0_count_10_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_10_value_3, slice2cost_pixels_first_0_0_count_11_value : boolean;
    variable slice2cost_pixels_first_0_0_count_11_value_2, slice2cost_pixels_first_0_0_count_11_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_12_value, slice2cost_pixels_first_0_0_count_12_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_12_value_3, slice2cost_pixels_first_0_0_count_13_value : boolean;
    variable slice2cost_pixels_first_0_0_count_13_value_2, slice2cost_pixels_first_0_0_count_13_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_14_value, entry_order_falls_any, entry_order_falls_all : boolean;
    variable entry_order_complete_all, entry_order_complete_any, entry_order_turned_output_column_choice : boolean;
    variable forward_left_start_cost_0_value, sums_right_start_cost_0_value, sums_turn_writes_copy_0_choice : boolean;
    variable winnerswinner1_of_pair_0_0_choice, winnerswinner1_of_pair_0_0_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_0_value, winnerswinner1_of_pair_0_0_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_0_value_2, winnerswinner1_of_pair_0_0_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_0_value_3, winnerswinner1_of_pair_0_0_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_0_value_4, winnerswinner1_of_pair_0_0_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_0_choice_7, winnerswinner1_of_pair_0_2_choice : boolean;
    variable winnerswinner1_of_pair_0_2_choice_2, winnerswinner1_of_pair_0_2_value : boolean;
    variable winnerswinner1_of_pair_0_2_choice_3, winnerswinner1_of_pair_0_2_value_2 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_4, winnerswinner1_of_pair_0_2_value_3 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_5, winnerswinner1_of_pair_0_2_value_4 : boolean;
    variable winnerswinner1_of_pair_0_2_choice_6, winnerswinner1_of_pair_0_2_choice_7 : boolean;
    variable winnerswinner1_of_pair_0_4_choice, winnerswinner1_of_pair_0_4_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_4_value, winnerswinner1_of_pair_0_4_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_4_value_2, winnerswinner1_of_pair_0_4_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_4_value_3, winnerswinner1_of_pair_0_4_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_4_value_4, winnerswinner1_of_pair_0_4_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_4_choice_7, winnerswinner1_of_pair_0_6_choice : boolean;
    variable winnerswinner1_of_pair_0_6_choice_2, winnerswinner1_of_pair_0_6_value : boolean;
    variable winnerswinner1_of_pair_0_6_choice_3, winnerswinner1_of_pair_0_6_value_2 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_4, winnerswinner1_of_pair_0_6_value_3 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_5, winnerswinner1_of_pair_0_6_value_4 : boolean;
    variable winnerswinner1_of_pair_0_6_choice_6, winnerswinner1_of_pair_0_6_choice_7 : boolean;
    variable winnerswinner1_of_pair_0_8_choice, winnerswinner1_of_pair_0_8_choice_2 : boolean;
    variable winnerswinner1_of_pair_0_8_value, winnerswinner1_of_pair_0_8_choice_3 : boolean;
    variable winnerswinner1_of_pair_0_8_value_2, winnerswinner1_of_pair_0_8_choice_4 : boolean;
    variable winnerswinner1_of_pair_0_8_value_3, winnerswinner1_of_pair_0_8_choice_5 : boolean;
    variable winnerswinner1_of_pair_0_8_value_4, winnerswinner1_of_pair_0_8_choice_6 : boolean;
    variable winnerswinner1_of_pair_0_8_choice_7, winnerswinner1_of_pair_0_10_choice : boolean;
    variable winnerswinner1_of_pair_0_10_choice_2, winnerswinner1_of_pair_0_10_value : boolean;
    variable winnerswinner1_of_pair_0_10_choice_3, winnerswinner1_of_pair_0_10_value_2 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_4, winnerswinner1_of_pair_0_10_value_3 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_5, winnerswinner1_of_pair_0_10_value_4 : boolean;
    variable winnerswinner1_of_pair_0_10_choice_6, winnerswinner1_of_pair_0_10_choice_7 : boolean;
    variable winnerswinner1_of_four_0_0_choice, winnerswinner1_of_four_0_0_value : boolean;
    variable winnerswinner1_of_four_0_0_value_2, winnerswinner1_of_four_0_0_choice_2 : boolean;
    variable winnerswinner1_of_four_0_0_value_3, winnerswinner1_of_four_0_0_value_4 : boolean;
    variable winnerswinner1_of_four_0_0_choice_3, winnerswinner1_of_four_0_0_value_5 : boolean;
    variable winnerswinner1_of_four_0_0_value_6, winnerswinner1_of_four_0_0_choice_4 : boolean;
    variable winnerswinner1_of_four_0_0_value_7, winnerswinner1_of_four_0_0_value_8 : boolean;
    variable winnerswinner1_of_four_0_0_choice_5, winnerswinner1_of_four_0_0_value_9 : boolean;
    variable winnerswinner1_of_four_0_0_value_10, winnerswinner1_of_four_0_0_choice_6 : boolean;
    variable winnerswinner1_of_four_0_0_choice_7, winnerswinner1_of_four_0_4_choice : boolean;
    variable winnerswinner1_of_four_0_4_value, winnerswinner1_of_four_0_4_value_2 : boolean;
    variable winnerswinner1_of_four_0_4_choice_2, winnerswinner1_of_four_0_4_value_3 : boolean;
    variable winnerswinner1_of_four_0_4_value_4, winnerswinner1_of_four_0_4_choice_3 : boolean;
    variable winnerswinner1_of_four_0_4_value_5, winnerswinner1_of_four_0_4_value_6 : boolean;
    variable winnerswinner1_of_four_0_4_choice_4, winnerswinner1_of_four_0_4_value_7 : boolean;
    variable winnerswinner1_of_four_0_4_value_8, winnerswinner1_of_four_0_4_choice_5 : boolean;
    variable winnerswinner1_of_four_0_4_value_9, winnerswinner1_of_four_0_4_value_10 : boolean;
    variable winnerswinner1_of_four_0_4_choice_6, winnerswinner1_of_four_0_4_choice_7 : boolean;
    variable winnerswinner1_of_four_0_8_choice, winnerswinner1_of_four_0_8_value : boolean;
    variable winnerswinner1_of_four_0_8_value_2, winnerswinner1_of_four_0_8_choice_2 : boolean;
    variable winnerswinner1_of_four_0_8_value_3, winnerswinner1_of_four_0_8_value_4 : boolean;
    variable winnerswinner1_of_four_0_8_choice_3, winnerswinner1_of_four_0_8_value_5 : boolean;
    variable winnerswinner1_of_four_0_8_value_6, winnerswinner1_of_four_0_8_choice_4 : boolean;
    variable winnerswinner1_of_four_0_8_value_7, winnerswinner1_of_four_0_8_value_8 : boolean;
    variable winnerswinner1_of_four_0_8_choice_5, winnerswinner1_of_four_0_8_value_9 : boolean;
    variable winnerswinner1_of_four_0_8_value_10, winnerswinner1_of_four_0_8_choice_6 : boolean;
    variable winnerswinner1_of_four_0_8_choice_7, winnerswinner2_of_pair_0_0_choice : boolean;
    variable winnerswinner2_of_pair_0_0_choice_2, winnerswinner2_of_pair_0_0_value : boolean;
    variable winnerswinner2_of_pair_0_0_choice_3, winnerswinner2_of_pair_0_0_value_2 : boolean;
    variable winnerswinner2_of_pair_0_0_choice_4, winnerswinner2_of_pair_0_0_value_3 : boolean;
    variable winnerswinner2_of_pair_0_0_choice_5, winnerswinner2_of_pair_0_0_value_4 : boolean;
    variable winnerswinner2_of_pair_0_0_choice_6, winnerswinner2_of_pair_0_0_choice_7 : boolean;
    variable winnerswinner2_four_index_0_0_value, winnerswinner2_four_index_0_0_value_2 : boolean;
    variable winnerswinner2_four_index_0_0_choice, winnerswinner2_four_index_0_0_value_3 : boolean;
    variable winnerswinner2_four_index_0_0_value_4, winnerswinner2_four_index_0_0_choice_2 : boolean;
    variable winnerswinner2_four_index_0_0_value_5, winnerswinner2_four_index_0_0_value_6 : boolean;
    variable winnerswinner2_four_index_0_0_choice_3, winnerswinner2_four_index_0_0_value_7 : boolean;
    variable winnerswinner2_four_index_0_0_value_8, winnerswinner2_four_index_0_0_choice_4 : boolean;
    variable winnerswinner2_four_index_0_0_value_9, winnerswinner2_four_index_0_0_value_10 : boolean;
    variable winnerswinner2_four_index_0_0_choice_5, winnerswinner2_four_index_0_0_choice_6 : boolean;
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_order_turned_output_column_choice : boolean;
    variable transform_counter_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 15;
    variable transform_left_filter_feature_0_choice_353 : natural range 0 to 31;
    variable transform_right_filter_feature_0_choice_353, forward_left_room_choice : natural range 0 to 31;
    variable forward_left_room_choice_2, forward_above_total_0_choice : natural range 0 to 31;
    variable forward_above_total_1_choice, forward_above_total_2_choice : natural range 0 to 31;
    variable forward_above_total_3_choice, forward_above_total_4_choice : natural range 0 to 31;
    variable forward_above_total_5_choice, forward_above_total_6_choice : natural range 0 to 31;
    variable forward_above_total_7_choice, forward_above_total_8_choice : natural range 0 to 31;
    variable forward_above_total_9_choice, forward_above_total_10_choice : natural range 0 to 31;
    variable forward_above_total_11_choice, sums_right_room_choice, sums_right_room_choice_2 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_354 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_354 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_355 : natural range 0 to 32767;
    variable transform_right_filter_feature_0_choice_355 : natural range 0 to 32767;
    variable transform_left_filter_feature_0_choice_356 : natural range 0 to 1048575;
    variable transform_right_filter_feature_0_choice_356 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_357 : natural range 0 to 8388607;
    variable transform_right_filter_feature_0_choice_357 : natural range 0 to 8388607;
    variable transform_left_filter_feature_0_choice_358 : natural range 0 to 536870911;
    variable transform_right_filter_feature_0_choice_358 : natural range 0 to 536870911;
    variable transform_left_filter_feature_0_choice_359 : unsigned(33 downto 0);
    variable transform_right_filter_feature_0_choice_359 : unsigned(33 downto 0);
    variable transform_left_filter_feature_0_choice_360 : unsigned(38 downto 0);
    variable transform_right_filter_feature_0_choice_360 : unsigned(38 downto 0);
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 7;
    variable forward_left_pair_0_choice, forward_left_pair_1_choice, forward_left_pair_2_choice : natural range 0 to 63;
    variable forward_left_pair_3_choice, forward_left_pair_4_choice, forward_left_pair_5_choice : natural range 0 to 63;
    variable forward_left_cost_0_choice, forward_left_cost_0_choice_2 : natural range 0 to 63;
    variable forward_left_cost_1_choice, forward_left_cost_1_choice_2 : natural range 0 to 63;
    variable forward_left_cost_2_choice, forward_left_cost_2_choice_2 : natural range 0 to 63;
    variable forward_left_cost_3_choice, forward_left_cost_3_choice_2 : natural range 0 to 63;
    variable forward_left_cost_4_choice, forward_left_cost_4_choice_2 : natural range 0 to 63;
    variable forward_left_cost_5_choice, forward_left_cost_5_choice_2 : natural range 0 to 63;
    variable forward_left_cost_6_choice, forward_left_cost_6_choice_2 : natural range 0 to 63;
    variable forward_left_cost_7_choice, forward_left_cost_7_choice_2 : natural range 0 to 63;
    variable forward_left_cost_8_choice, forward_left_cost_8_choice_2 : natural range 0 to 63;
    variable forward_left_cost_9_choice, forward_left_cost_9_choice_2 : natural range 0 to 63;
    variable forward_left_cost_10_choice, forward_left_cost_10_choice_2 : natural range 0 to 63;
    variable forward_left_cost_11_choice, forward_left_cost_11_choice_2 : natural range 0 to 63;
    variable forward_left_arrived_0_choice, forward_left_arrived_1_choice : natural range 0 to 63;
    variable forward_left_arrived_2_choice, forward_left_arrived_3_choice : natural range 0 to 63;
    variable forward_left_arrived_3_choice_2, forward_left_arrived_4_choice : natural range 0 to 63;
    variable forward_left_arrived_4_choice_2, forward_left_arrived_5_choice : natural range 0 to 63;
    variable forward_left_arrived_6_choice, forward_left_arrived_7_choice : natural range 0 to 63;
    variable forward_left_arrived_7_choice_2, forward_left_arrived_8_choice : natural range 0 to 63;
    variable forward_left_arrived_8_choice_2, forward_left_arrived_9_choice : natural range 0 to 63;
    variable forward_left_arrived_10_choice, forward_left_arrived_11_choice : natural range 0 to 63;
    variable sums_right_pair_0_choice, sums_right_pair_1_choice, sums_right_pair_2_choice : natural range 0 to 63;
    variable sums_right_pair_3_choice, sums_right_pair_4_choice, sums_right_pair_5_choice : natural range 0 to 63;
    variable sums_right_cost_0_choice, sums_right_cost_0_choice_2, sums_right_cost_1_choice : natural range 0 to 63;
    variable sums_right_cost_1_choice_2, sums_right_cost_2_choice, sums_right_cost_2_choice_2 : natural range 0 to 63;
    variable sums_right_cost_3_choice, sums_right_cost_3_choice_2, sums_right_cost_4_choice : natural range 0 to 63;
    variable sums_right_cost_4_choice_2, sums_right_cost_5_choice, sums_right_cost_5_choice_2 : natural range 0 to 63;
    variable sums_right_cost_6_choice, sums_right_cost_6_choice_2, sums_right_cost_7_choice : natural range 0 to 63;
    variable sums_right_cost_7_choice_2, sums_right_cost_8_choice, sums_right_cost_8_choice_2 : natural range 0 to 63;
    variable sums_right_cost_9_choice, sums_right_cost_9_choice_2, sums_right_cost_10_choice : natural range 0 to 63;
    variable sums_right_cost_10_choice_2, sums_right_cost_11_choice : natural range 0 to 63;
    variable sums_right_cost_11_choice_2, sums_right_arrived_0_choice : natural range 0 to 63;
    variable sums_right_arrived_1_choice, sums_right_arrived_2_choice : natural range 0 to 63;
    variable sums_right_arrived_3_choice, sums_right_arrived_3_choice_2 : natural range 0 to 63;
    variable sums_right_arrived_4_choice, sums_right_arrived_4_choice_2 : natural range 0 to 63;
    variable sums_right_arrived_5_choice, sums_right_arrived_6_choice : natural range 0 to 63;
    variable sums_right_arrived_7_choice, sums_right_arrived_7_choice_2 : natural range 0 to 63;
    variable sums_right_arrived_8_choice, sums_right_arrived_8_choice_2 : natural range 0 to 63;
    variable sums_right_arrived_9_choice, sums_right_arrived_10_choice : natural range 0 to 63;
    variable sums_right_arrived_11_choice : natural range 0 to 63;
    variable forward_left_start_cost_0_choice, forward_left_start_cost_0_choice_2 : natural range 0 to 255;
    variable sums_right_start_cost_0_choice, sums_right_start_cost_0_choice_2 : natural range 0 to 255;
    variable forward_above_write_words_0_choice, forward_above_write_words_0_choice_2 : natural range 0 to 67;
    variable forward_above_write_words_0_choice_3, forward_above_write_words_0_choice_4 : natural range 0 to 67;
    variable forward_above_write_words_0_choice_5, forward_above_write_words_0_choice_6 : natural range 0 to 67;
    variable forward_above_write_words_1_choice, forward_above_write_words_1_choice_2 : natural range 0 to 67;
    variable forward_above_write_words_1_choice_3, forward_above_write_words_1_choice_4 : natural range 0 to 67;
    variable forward_above_write_words_1_choice_5, forward_above_write_words_1_choice_6 : natural range 0 to 67;
    variable other_1_choice, other_3_choice, other_5_choice, other_7_choice, other_9_choice : natural range 0 to 11;
    variable other_11_choice, other_13_choice, other_15_choice, other_17_choice : natural range 0 to 11;
    variable other_19_choice, other_21_choice, other_23_choice : natural range 0 to 11;
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
      transform_read_column_inside_1_differs := (transform_counter_column / 4) /= 0;
      transform_read_column_inside_2_is_equal := (transform_counter_column / 4) = 0;
      transform_read_column_inside_3_value := ((transform_counter_column / 2) mod 2) = 1;
      transform_read_column_inside_5_is_equal := ((transform_counter_column / 4) mod 4) = 0;
      if transform_read_column_inside_3_value then
        transform_read_column_inside_5_choice := transform_read_column_inside_5_is_equal;
      else
        transform_read_column_inside_5_choice := not transform_read_column_inside_0_value_2;
      end if;
      if (transform_counter_column mod 2) = 1 then
        transform_read_column_inside_5_choice_2 := transform_read_column_inside_5_is_equal;
      else
        transform_read_column_inside_5_choice_2 := transform_read_column_inside_5_choice;
      end if;
      transform_read_column_inside_5_is_equal_2 := (transform_counter_column / 16) = 0;
      if transform_read_column_inside_2_is_equal then
        transform_read_column_inside_5_choice_3 := transform_read_column_inside_5_is_equal_2;
      else
        transform_read_column_inside_5_choice_3 := ((transform_counter_column / 32) = 1) or
          transform_read_column_inside_0_value;
      end if;
      if transform_read_column_inside_3_value then
        transform_read_column_inside_6_choice := (not ((transform_counter_column / 32) = 1)) and (not
          transform_read_column_inside_0_value) and (not transform_read_column_inside_0_value_3);
      else
        transform_read_column_inside_6_choice := transform_read_column_inside_5_is_equal_2;
      end if;
      if (transform_counter_column mod 2) = 1 then
        transform_read_column_inside_7_choice := transform_read_column_inside_5_choice;
      else
        transform_read_column_inside_7_choice := not transform_read_column_inside_0_value_2;
      end if;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_4_2 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_4_2 mod 2) = 1));
      if (transform_left_filter_column_8_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_4_2 mod 4) = 0;
      if ((transform_left_filter_column_8_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_8_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_4_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_4_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_4_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_4_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_4_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_9 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_9 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_10 := transform_left_filter_feature_0_choice_9;
      else
        transform_left_filter_feature_0_choice_10 := ((transform_left_filter_column_8_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_10 then
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_8_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_8_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_11 then
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_8_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_8_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_12 then
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_8_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_8_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_13 then
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_8_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_8_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_14 then
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_8_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_8_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_15 then
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_8_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_8_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_17 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_17 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_18 := transform_left_filter_feature_0_choice_17;
      else
        transform_left_filter_feature_0_choice_18 := ((transform_left_filter_column_8_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_18 then
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_19 then
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_20 then
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_21 then
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_22 then
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_23 then
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_8_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_8_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_25 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_choice_25;
      else
        transform_left_filter_feature_0_choice_26 := ((transform_left_filter_column_8_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_26 then
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_8_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_8_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_27 then
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_8_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_8_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_8_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_8_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_8_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_8_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_8_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_8_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_8_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_8_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_33 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_choice_33;
      else
        transform_left_filter_feature_0_choice_34 := ((transform_left_filter_column_8_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_34 then
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_35 then
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_36 then
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_8_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_8_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_41 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_41 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_choice_41;
      else
        transform_left_filter_feature_0_choice_42 := ((transform_left_filter_column_7_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_7_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_7_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_49 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_49 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_choice_49;
      else
        transform_left_filter_feature_0_choice_50 := ((transform_left_filter_column_7_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_7_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_7_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_57 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_57 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_choice_57;
      else
        transform_left_filter_feature_0_choice_58 := ((transform_left_filter_column_7_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_7_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_7_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_65 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_65 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_choice_65;
      else
        transform_left_filter_feature_0_choice_66 := ((transform_left_filter_column_7_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_7_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_7_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_7_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_7_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_7_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_7_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_7_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_7_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_7_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_7_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_7_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_7_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_73 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_73 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_choice_73;
      else
        transform_left_filter_feature_0_choice_74 := ((transform_left_filter_column_7_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_7_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_7_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_7_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_7_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_7_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_7_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_7_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_7_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_7_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_7_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_7_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_7_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_81 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_81 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_choice_81;
      else
        transform_left_filter_feature_0_choice_82 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_82 then
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_6_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_6_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_89 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_89 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_choice_89;
      else
        transform_left_filter_feature_0_choice_90 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_90 then
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_6_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_6_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_97 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_97 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_choice_97;
      else
        transform_left_filter_feature_0_choice_98 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_98 then
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_6_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_6_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_105 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_105 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_choice_105;
      else
        transform_left_filter_feature_0_choice_106 := ((transform_left_filter_column_6_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_106 then
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_6_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_6_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_113 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_113 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_choice_113;
      else
        transform_left_filter_feature_0_choice_114 := ((transform_left_filter_column_6_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_114 then
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_6_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_6_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_121 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_121 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_choice_121;
      else
        transform_left_filter_feature_0_choice_122 := ((transform_left_filter_column_5_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_122 then
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_5_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_5_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_129 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_129 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_choice_129;
      else
        transform_left_filter_feature_0_choice_130 := ((transform_left_filter_column_5_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_130 then
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_5_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_5_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_137 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_137 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_choice_137;
      else
        transform_left_filter_feature_0_choice_138 := ((transform_left_filter_column_5_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_138 then
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_5_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_5_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_145 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_145 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := transform_left_filter_feature_0_choice_145;
      else
        transform_left_filter_feature_0_choice_146 := ((transform_left_filter_column_5_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_146 then
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_5_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_5_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_153 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_153 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_154 := transform_left_filter_feature_0_choice_153;
      else
        transform_left_filter_feature_0_choice_154 := ((transform_left_filter_column_5_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_154 then
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_5_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_5_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_155 then
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_5_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_5_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_156 then
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_5_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_5_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_157 then
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_5_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_5_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_5_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_5_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_5_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_5_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_161 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_161 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_162 := transform_left_filter_feature_0_choice_161;
      else
        transform_left_filter_feature_0_choice_162 := ((transform_left_filter_column_4_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_162 then
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_164 then
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_165 then
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_166 then
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_169 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_169 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_choice_169;
      else
        transform_left_filter_feature_0_choice_170 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_170 then
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_177 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_177 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_178 := transform_left_filter_feature_0_choice_177;
      else
        transform_left_filter_feature_0_choice_178 := ((transform_left_filter_column_4_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_178 then
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_179 then
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_180 then
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_181 then
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_182 then
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_183 then
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_4_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_4_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_185 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_185 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_choice_185;
      else
        transform_left_filter_feature_0_choice_186 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_186 then
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_193 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_193 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_194 := transform_left_filter_feature_0_choice_193;
      else
        transform_left_filter_feature_0_choice_194 := ((transform_left_filter_column_3_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_194 then
        transform_left_filter_feature_0_choice_195 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_195 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_195 then
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_196 then
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_197 then
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_198 then
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_199 then
        transform_left_filter_feature_0_choice_200 := ((transform_left_filter_column_3_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_200 := ((transform_left_filter_column_3_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_201 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_201 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_202 := transform_left_filter_feature_0_choice_201;
      else
        transform_left_filter_feature_0_choice_202 := ((transform_left_filter_column_3_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_202 then
        transform_left_filter_feature_0_choice_203 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_203 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_203 then
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_204 then
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_205 then
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_206 then
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_207 then
        transform_left_filter_feature_0_choice_208 := ((transform_left_filter_column_3_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_208 := ((transform_left_filter_column_3_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_209 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_209 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_210 := transform_left_filter_feature_0_choice_209;
      else
        transform_left_filter_feature_0_choice_210 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_210 then
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_211 then
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_212 then
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_213 then
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_214 then
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_215 then
        transform_left_filter_feature_0_choice_216 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_216 := ((transform_left_filter_column_3_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_217 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_217 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_218 := transform_left_filter_feature_0_choice_217;
      else
        transform_left_filter_feature_0_choice_218 := ((transform_left_filter_column_3_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_218 then
        transform_left_filter_feature_0_choice_219 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_219 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_219 then
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_220 then
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_221 then
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_222 then
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_223 then
        transform_left_filter_feature_0_choice_224 := ((transform_left_filter_column_3_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_224 := ((transform_left_filter_column_3_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_225 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_225 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_226 := transform_left_filter_feature_0_choice_225;
      else
        transform_left_filter_feature_0_choice_226 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_226 then
        transform_left_filter_feature_0_choice_227 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_227 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_227 then
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_228 then
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_229 then
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_230 then
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_231 then
        transform_left_filter_feature_0_choice_232 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_232 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_233 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_233 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_234 := transform_left_filter_feature_0_choice_233;
      else
        transform_left_filter_feature_0_choice_234 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_234 then
        transform_left_filter_feature_0_choice_235 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_235 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_235 then
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_236 then
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_237 then
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_238 then
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_239 then
        transform_left_filter_feature_0_choice_240 := ((transform_left_filter_column_2_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_240 := ((transform_left_filter_column_2_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_241 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_241 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_242 := transform_left_filter_feature_0_choice_241;
      else
        transform_left_filter_feature_0_choice_242 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_242 then
        transform_left_filter_feature_0_choice_243 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_243 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_243 then
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_244 then
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_245 then
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_246 then
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_247 then
        transform_left_filter_feature_0_choice_248 := ((transform_left_filter_column_2_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_248 := ((transform_left_filter_column_2_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_249 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_249 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_250 := transform_left_filter_feature_0_choice_249;
      else
        transform_left_filter_feature_0_choice_250 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_250 then
        transform_left_filter_feature_0_choice_251 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_251 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_251 then
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_252 then
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_253 then
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_254 then
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_255 then
        transform_left_filter_feature_0_choice_256 := ((transform_left_filter_column_2_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_256 := ((transform_left_filter_column_2_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_257 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_257 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_258 := transform_left_filter_feature_0_choice_257;
      else
        transform_left_filter_feature_0_choice_258 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_258 then
        transform_left_filter_feature_0_choice_259 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_259 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_259 then
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_260 then
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_261 then
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_262 then
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_263 then
        transform_left_filter_feature_0_choice_264 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_264 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_265 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_265 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_266 := transform_left_filter_feature_0_choice_265;
      else
        transform_left_filter_feature_0_choice_266 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_266 then
        transform_left_filter_feature_0_choice_267 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_267 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_267 then
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_268 then
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_269 then
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_270 then
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_271 then
        transform_left_filter_feature_0_choice_272 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_272 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_273 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_273 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_274 := transform_left_filter_feature_0_choice_273;
      else
        transform_left_filter_feature_0_choice_274 := ((transform_left_filter_column_1_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_274 then
        transform_left_filter_feature_0_choice_275 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_275 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_275 then
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_276 then
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_277 then
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_278 then
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_279 then
        transform_left_filter_feature_0_choice_280 := ((transform_left_filter_column_1_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_280 := ((transform_left_filter_column_1_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_281 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_281 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_282 := transform_left_filter_feature_0_choice_281;
      else
        transform_left_filter_feature_0_choice_282 := ((transform_left_filter_column_1_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_282 then
        transform_left_filter_feature_0_choice_283 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_283 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_283 then
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_284 then
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_285 then
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_286 then
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_287 then
        transform_left_filter_feature_0_choice_288 := ((transform_left_filter_column_1_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_288 := ((transform_left_filter_column_1_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_289 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_289 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_290 := transform_left_filter_feature_0_choice_289;
      else
        transform_left_filter_feature_0_choice_290 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_290 then
        transform_left_filter_feature_0_choice_291 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_291 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_291 then
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_292 then
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_293 then
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_294 then
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_295 then
        transform_left_filter_feature_0_choice_296 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_296 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_297 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_297 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_298 := transform_left_filter_feature_0_choice_297;
      else
        transform_left_filter_feature_0_choice_298 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_298 then
        transform_left_filter_feature_0_choice_299 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_299 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_299 then
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_300 then
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_301 then
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_302 then
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_303 then
        transform_left_filter_feature_0_choice_304 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_304 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_305 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_305 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_306 := transform_left_filter_feature_0_choice_305;
      else
        transform_left_filter_feature_0_choice_306 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_306 then
        transform_left_filter_feature_0_choice_307 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_307 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_307 then
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_308 then
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_309 then
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_310 then
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_311 then
        transform_left_filter_feature_0_choice_312 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_312 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_313 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_313 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_314 := transform_left_filter_feature_0_choice_313;
      else
        transform_left_filter_feature_0_choice_314 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_314 then
        transform_left_filter_feature_0_choice_315 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_315 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_315 then
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_316 then
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_317 then
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_318 then
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_319 then
        transform_left_filter_feature_0_choice_320 := ((transform_left_filter_column_0_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_320 := ((transform_left_filter_column_0_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_321 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_321 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_322 := transform_left_filter_feature_0_choice_321;
      else
        transform_left_filter_feature_0_choice_322 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_322 then
        transform_left_filter_feature_0_choice_323 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_323 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_323 then
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_324 then
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_325 then
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_326 then
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_327 then
        transform_left_filter_feature_0_choice_328 := ((transform_left_filter_column_0_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_328 := ((transform_left_filter_column_0_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_329 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_329 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_330 := transform_left_filter_feature_0_choice_329;
      else
        transform_left_filter_feature_0_choice_330 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_330 then
        transform_left_filter_feature_0_choice_331 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_331 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_331 then
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_332 then
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_333 then
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_334 then
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_335 then
        transform_left_filter_feature_0_choice_336 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_336 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_337 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_337 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_338 := transform_left_filter_feature_0_choice_337;
      else
        transform_left_filter_feature_0_choice_338 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_338 then
        transform_left_filter_feature_0_choice_339 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_339 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_339 then
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_340 then
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_341 then
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_342 then
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_343 then
        transform_left_filter_feature_0_choice_344 := ((transform_left_filter_column_0_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_344 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_345 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_345 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_346 := ((transform_left_filter_column_4_2 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_346 := transform_left_filter_feature_0_choice_345;
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_346 then
        transform_left_filter_feature_0_choice_347 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_7;
      else
        transform_left_filter_feature_0_choice_347 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_7;
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_347 then
        transform_left_filter_feature_0_choice_348 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_8;
      else
        transform_left_filter_feature_0_choice_348 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_8;
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_348 then
        transform_left_filter_feature_0_choice_349 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_9;
      else
        transform_left_filter_feature_0_choice_349 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_9;
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_349 then
        transform_left_filter_feature_0_choice_350 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_10;
      else
        transform_left_filter_feature_0_choice_350 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_10;
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_350 then
        transform_left_filter_feature_0_choice_351 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_11;
      else
        transform_left_filter_feature_0_choice_351 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_11;
      end if;
      if transform_left_filter_feature_0_choice_351 then
        transform_left_filter_feature_0_choice_352 := (not ((transform_left_filter_column_4_2 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_352 := (not ((transform_left_filter_column_4_2 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_353 := (as_number(transform_left_filter_feature_0_choice_320) * 8) +
          (as_number(transform_left_filter_feature_0_choice_328) * 16) +
          (as_number(transform_left_filter_feature_0_choice_336) * 4) +
          (as_number(transform_left_filter_feature_0_choice_344) * 2) +
          as_number(transform_left_filter_feature_0_choice_352);
      else
        transform_left_filter_feature_0_choice_353 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_354 := (as_number(transform_left_filter_feature_0_choice_280) * 256) +
          (as_number(transform_left_filter_feature_0_choice_288) * 512) +
          (as_number(transform_left_filter_feature_0_choice_296) * 128) +
          (as_number(transform_left_filter_feature_0_choice_304) * 64) +
          (as_number(transform_left_filter_feature_0_choice_312) * 32) + transform_left_filter_feature_0_choice_353;
      else
        transform_left_filter_feature_0_choice_354 := transform_left_filter_feature_0_choice_353;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_355 := (as_number(transform_left_filter_feature_0_choice_240) * 8192) +
          (as_number(transform_left_filter_feature_0_choice_248) * 16384) +
          (as_number(transform_left_filter_feature_0_choice_256) * 4096) +
          (as_number(transform_left_filter_feature_0_choice_264) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_272) * 1024) + transform_left_filter_feature_0_choice_354;
      else
        transform_left_filter_feature_0_choice_355 := transform_left_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_356 := (as_number(transform_left_filter_feature_0_choice_200) * 262144)
          + (as_number(transform_left_filter_feature_0_choice_208) * 524288) +
          (as_number(transform_left_filter_feature_0_choice_216) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_224) * 65536) +
          (as_number(transform_left_filter_feature_0_choice_232) * 32768) + transform_left_filter_feature_0_choice_355;
      else
        transform_left_filter_feature_0_choice_356 := transform_left_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_357 := (as_number(transform_left_filter_feature_0_choice_176) * 2097152)
          + (as_number(transform_left_filter_feature_0_choice_184) * 4194304) +
          (as_number(transform_left_filter_feature_0_choice_192) * 1048576) +
          transform_left_filter_feature_0_choice_356;
      else
        transform_left_filter_feature_0_choice_357 := transform_left_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_0_choice_358 := (as_number(transform_left_filter_feature_0_choice_128) *
          16777216) + (as_number(transform_left_filter_feature_0_choice_136) * 33554432) +
          (as_number(transform_left_filter_feature_0_choice_144) * 67108864) +
          (as_number(transform_left_filter_feature_0_choice_152) * 134217728) +
          (as_number(transform_left_filter_feature_0_choice_160) * 268435456) +
          (as_number(transform_left_filter_feature_0_choice_168) * 8388608) +
          transform_left_filter_feature_0_choice_357;
      else
        transform_left_filter_feature_0_choice_358 := (as_number(transform_left_filter_feature_0_choice_168) * 8388608)
          + transform_left_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_left_filter_feature_0_choice_359 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_120), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_88), 1) &
          to_unsigned(transform_left_filter_feature_0_choice_358, 29);
      else
        transform_left_filter_feature_0_choice_359 := to_unsigned(transform_left_filter_feature_0_choice_358, 34);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_left_filter_feature_0_choice_360 := to_unsigned(as_number(transform_left_filter_feature_0_choice_80),
          1) & to_unsigned(as_number(transform_left_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_64), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_48), 1) &
          transform_left_filter_feature_0_choice_359(33 downto 0);
      else
        transform_left_filter_feature_0_choice_360 := resize(transform_left_filter_feature_0_choice_359, 39);
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_4_2 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_4_2 mod 2) = 1));
      if (transform_right_filter_column_8_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_4_2 mod 4) = 0;
      if ((transform_right_filter_column_8_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_8_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_4_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_4_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_4_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_4_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_4_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_9 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_9 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_10 := transform_right_filter_feature_0_choice_9;
      else
        transform_right_filter_feature_0_choice_10 := ((transform_right_filter_column_8_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_10 then
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_8_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_8_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_11 then
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_8_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_8_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_12 then
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_8_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_8_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_13 then
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_8_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_8_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_14 then
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_8_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_8_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_15 then
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_8_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_8_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_17 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_17 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_18 := transform_right_filter_feature_0_choice_17;
      else
        transform_right_filter_feature_0_choice_18 := ((transform_right_filter_column_8_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_18 then
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_19 then
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_20 then
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_21 then
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_22 then
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_23 then
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_8_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_8_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_25 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_choice_25;
      else
        transform_right_filter_feature_0_choice_26 := ((transform_right_filter_column_8_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_26 then
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_8_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_8_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_27 then
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_8_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_8_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_8_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_8_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_8_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_8_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_8_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_8_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_8_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_8_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_33 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_choice_33;
      else
        transform_right_filter_feature_0_choice_34 := ((transform_right_filter_column_8_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_34 then
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_35 then
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_36 then
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_8_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_8_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_41 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_41 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_choice_41;
      else
        transform_right_filter_feature_0_choice_42 := ((transform_right_filter_column_7_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_7_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_7_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_49 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_49 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_choice_49;
      else
        transform_right_filter_feature_0_choice_50 := ((transform_right_filter_column_7_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_7_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_7_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_57 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_57 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_choice_57;
      else
        transform_right_filter_feature_0_choice_58 := ((transform_right_filter_column_7_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_7_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_7_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_65 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_65 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_choice_65;
      else
        transform_right_filter_feature_0_choice_66 := ((transform_right_filter_column_7_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_7_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_7_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_7_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_7_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_7_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_7_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_7_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_7_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_7_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_7_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_7_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_7_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_73 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_choice_73;
      else
        transform_right_filter_feature_0_choice_74 := ((transform_right_filter_column_7_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_7_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_7_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_7_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_7_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_7_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_7_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_7_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_7_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_7_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_7_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_7_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_7_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
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
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_6_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_6_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_89 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_89 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_choice_89;
      else
        transform_right_filter_feature_0_choice_90 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_90 then
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_6_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_6_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_97 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_97 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_choice_97;
      else
        transform_right_filter_feature_0_choice_98 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_98 then
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_6_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_6_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_105 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_105 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_choice_105;
      else
        transform_right_filter_feature_0_choice_106 := ((transform_right_filter_column_6_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_106 then
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_6_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_6_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_113 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_113 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_choice_113;
      else
        transform_right_filter_feature_0_choice_114 := ((transform_right_filter_column_6_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_114 then
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_6_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_6_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_121 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_121 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_choice_121;
      else
        transform_right_filter_feature_0_choice_122 := ((transform_right_filter_column_5_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_122 then
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_5_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_5_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_129 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_129 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_choice_129;
      else
        transform_right_filter_feature_0_choice_130 := ((transform_right_filter_column_5_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_130 then
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_5_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_5_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_137 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_137 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_choice_137;
      else
        transform_right_filter_feature_0_choice_138 := ((transform_right_filter_column_5_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_138 then
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_5_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_5_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_145 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_145 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := transform_right_filter_feature_0_choice_145;
      else
        transform_right_filter_feature_0_choice_146 := ((transform_right_filter_column_5_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_146 then
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_5_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_5_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_153 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_153 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_154 := transform_right_filter_feature_0_choice_153;
      else
        transform_right_filter_feature_0_choice_154 := ((transform_right_filter_column_5_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_154 then
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_5_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_5_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_155 then
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_5_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_5_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_156 then
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_5_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_5_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_157 then
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_5_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_5_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_5_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_5_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_5_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_5_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_161 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_161 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_162 := transform_right_filter_feature_0_choice_161;
      else
        transform_right_filter_feature_0_choice_162 := ((transform_right_filter_column_4_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_162 then
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_164 then
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_165 then
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_166 then
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_169 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_169 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_choice_169;
      else
        transform_right_filter_feature_0_choice_170 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_170 then
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_177 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_177 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_178 := transform_right_filter_feature_0_choice_177;
      else
        transform_right_filter_feature_0_choice_178 := ((transform_right_filter_column_4_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_178 then
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_179 then
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_180 then
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_181 then
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_182 then
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_183 then
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_4_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_4_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_185 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_185 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_choice_185;
      else
        transform_right_filter_feature_0_choice_186 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_186 then
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_193 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_193 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_194 := transform_right_filter_feature_0_choice_193;
      else
        transform_right_filter_feature_0_choice_194 := ((transform_right_filter_column_3_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_194 then
        transform_right_filter_feature_0_choice_195 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_195 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_195 then
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_196 then
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_197 then
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_198 then
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_199 then
        transform_right_filter_feature_0_choice_200 := ((transform_right_filter_column_3_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_200 := ((transform_right_filter_column_3_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_201 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_201 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_202 := transform_right_filter_feature_0_choice_201;
      else
        transform_right_filter_feature_0_choice_202 := ((transform_right_filter_column_3_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_202 then
        transform_right_filter_feature_0_choice_203 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_203 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_203 then
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_204 then
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_205 then
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_206 then
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_207 then
        transform_right_filter_feature_0_choice_208 := ((transform_right_filter_column_3_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_208 := ((transform_right_filter_column_3_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_209 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_209 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_210 := transform_right_filter_feature_0_choice_209;
      else
        transform_right_filter_feature_0_choice_210 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_210 then
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_211 then
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_212 then
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_213 then
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_214 then
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_215 then
        transform_right_filter_feature_0_choice_216 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_216 := ((transform_right_filter_column_3_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_217 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_217 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_218 := transform_right_filter_feature_0_choice_217;
      else
        transform_right_filter_feature_0_choice_218 := ((transform_right_filter_column_3_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_218 then
        transform_right_filter_feature_0_choice_219 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_219 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_219 then
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_220 then
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_221 then
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_222 then
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_223 then
        transform_right_filter_feature_0_choice_224 := ((transform_right_filter_column_3_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_224 := ((transform_right_filter_column_3_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_225 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_225 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_226 := transform_right_filter_feature_0_choice_225;
      else
        transform_right_filter_feature_0_choice_226 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_226 then
        transform_right_filter_feature_0_choice_227 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_227 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_227 then
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_228 then
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_229 then
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_230 then
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_231 then
        transform_right_filter_feature_0_choice_232 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_232 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_233 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_233 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_234 := transform_right_filter_feature_0_choice_233;
      else
        transform_right_filter_feature_0_choice_234 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_234 then
        transform_right_filter_feature_0_choice_235 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_235 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_235 then
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_236 then
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_237 then
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_238 then
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_239 then
        transform_right_filter_feature_0_choice_240 := ((transform_right_filter_column_2_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_240 := ((transform_right_filter_column_2_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_241 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_241 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_242 := transform_right_filter_feature_0_choice_241;
      else
        transform_right_filter_feature_0_choice_242 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_242 then
        transform_right_filter_feature_0_choice_243 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_243 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_243 then
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_244 then
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_245 then
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_246 then
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_247 then
        transform_right_filter_feature_0_choice_248 := ((transform_right_filter_column_2_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_248 := ((transform_right_filter_column_2_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_249 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_249 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_250 := transform_right_filter_feature_0_choice_249;
      else
        transform_right_filter_feature_0_choice_250 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_250 then
        transform_right_filter_feature_0_choice_251 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_251 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_251 then
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_252 then
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_253 then
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_254 then
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_255 then
        transform_right_filter_feature_0_choice_256 := ((transform_right_filter_column_2_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_256 := ((transform_right_filter_column_2_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_257 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_257 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_258 := transform_right_filter_feature_0_choice_257;
      else
        transform_right_filter_feature_0_choice_258 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_258 then
        transform_right_filter_feature_0_choice_259 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_259 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_259 then
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_260 then
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_261 then
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_262 then
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_263 then
        transform_right_filter_feature_0_choice_264 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_264 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_265 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_265 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_266 := transform_right_filter_feature_0_choice_265;
      else
        transform_right_filter_feature_0_choice_266 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_266 then
        transform_right_filter_feature_0_choice_267 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_267 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_267 then
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_268 then
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_269 then
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_270 then
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_271 then
        transform_right_filter_feature_0_choice_272 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_272 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_273 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_273 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_274 := transform_right_filter_feature_0_choice_273;
      else
        transform_right_filter_feature_0_choice_274 := ((transform_right_filter_column_1_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_274 then
        transform_right_filter_feature_0_choice_275 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_275 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_275 then
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_276 then
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_277 then
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_278 then
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_279 then
        transform_right_filter_feature_0_choice_280 := ((transform_right_filter_column_1_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_280 := ((transform_right_filter_column_1_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_281 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_281 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_282 := transform_right_filter_feature_0_choice_281;
      else
        transform_right_filter_feature_0_choice_282 := ((transform_right_filter_column_1_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_282 then
        transform_right_filter_feature_0_choice_283 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_283 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_283 then
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_284 then
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_285 then
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_286 then
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_287 then
        transform_right_filter_feature_0_choice_288 := ((transform_right_filter_column_1_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_288 := ((transform_right_filter_column_1_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_289 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_289 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_290 := transform_right_filter_feature_0_choice_289;
      else
        transform_right_filter_feature_0_choice_290 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_290 then
        transform_right_filter_feature_0_choice_291 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_291 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_291 then
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_292 then
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_293 then
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_294 then
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_295 then
        transform_right_filter_feature_0_choice_296 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_296 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_297 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_297 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_298 := transform_right_filter_feature_0_choice_297;
      else
        transform_right_filter_feature_0_choice_298 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_298 then
        transform_right_filter_feature_0_choice_299 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_299 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_299 then
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_300 then
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_301 then
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_302 then
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_303 then
        transform_right_filter_feature_0_choice_304 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_304 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_305 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_305 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_306 := transform_right_filter_feature_0_choice_305;
      else
        transform_right_filter_feature_0_choice_306 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_306 then
        transform_right_filter_feature_0_choice_307 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_307 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_307 then
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_308 then
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_309 then
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_310 then
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_311 then
        transform_right_filter_feature_0_choice_312 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_312 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_313 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_313 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_314 := transform_right_filter_feature_0_choice_313;
      else
        transform_right_filter_feature_0_choice_314 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_314 then
        transform_right_filter_feature_0_choice_315 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_315 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_315 then
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_316 then
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_317 then
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_318 then
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_319 then
        transform_right_filter_feature_0_choice_320 := ((transform_right_filter_column_0_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_320 := ((transform_right_filter_column_0_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_321 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_321 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_322 := transform_right_filter_feature_0_choice_321;
      else
        transform_right_filter_feature_0_choice_322 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_322 then
        transform_right_filter_feature_0_choice_323 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_323 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_323 then
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_324 then
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_325 then
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_326 then
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_327 then
        transform_right_filter_feature_0_choice_328 := ((transform_right_filter_column_0_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_328 := ((transform_right_filter_column_0_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_329 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_329 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_330 := transform_right_filter_feature_0_choice_329;
      else
        transform_right_filter_feature_0_choice_330 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_330 then
        transform_right_filter_feature_0_choice_331 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_331 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_331 then
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_332 then
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_333 then
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_334 then
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_335 then
        transform_right_filter_feature_0_choice_336 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_336 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_337 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_337 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_338 := transform_right_filter_feature_0_choice_337;
      else
        transform_right_filter_feature_0_choice_338 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_338 then
        transform_right_filter_feature_0_choice_339 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_339 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_339 then
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_340 then
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_341 then
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_342 then
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_343 then
        transform_right_filter_feature_0_choice_344 := ((transform_right_filter_column_0_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_344 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_345 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_345 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_346 := ((transform_right_filter_column_4_2 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_346 := transform_right_filter_feature_0_choice_345;
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_346 then
        transform_right_filter_feature_0_choice_347 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_7;
      else
        transform_right_filter_feature_0_choice_347 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_7;
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_347 then
        transform_right_filter_feature_0_choice_348 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_8;
      else
        transform_right_filter_feature_0_choice_348 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_8;
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_348 then
        transform_right_filter_feature_0_choice_349 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_9;
      else
        transform_right_filter_feature_0_choice_349 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_9;
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_349 then
        transform_right_filter_feature_0_choice_350 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_10;
      else
        transform_right_filter_feature_0_choice_350 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_10;
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_350 then
        transform_right_filter_feature_0_choice_351 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_11;
      else
        transform_right_filter_feature_0_choice_351 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_11;
      end if;
      if transform_right_filter_feature_0_choice_351 then
        transform_right_filter_feature_0_choice_352 := (not ((transform_right_filter_column_4_2 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_352 := (not ((transform_right_filter_column_4_2 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_353 := (as_number(transform_right_filter_feature_0_choice_320) * 8) +
          (as_number(transform_right_filter_feature_0_choice_328) * 16) +
          (as_number(transform_right_filter_feature_0_choice_336) * 4) +
          (as_number(transform_right_filter_feature_0_choice_344) * 2) +
          as_number(transform_right_filter_feature_0_choice_352);
      else
        transform_right_filter_feature_0_choice_353 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_354 := (as_number(transform_right_filter_feature_0_choice_280) * 256) +
          (as_number(transform_right_filter_feature_0_choice_288) * 512) +
          (as_number(transform_right_filter_feature_0_choice_296) * 128) +
          (as_number(transform_right_filter_feature_0_choice_304) * 64) +
          (as_number(transform_right_filter_feature_0_choice_312) * 32) + transform_right_filter_feature_0_choice_353;
      else
        transform_right_filter_feature_0_choice_354 := transform_right_filter_feature_0_choice_353;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_355 := (as_number(transform_right_filter_feature_0_choice_240) * 8192)
          + (as_number(transform_right_filter_feature_0_choice_248) * 16384) +
          (as_number(transform_right_filter_feature_0_choice_256) * 4096) +
          (as_number(transform_right_filter_feature_0_choice_264) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_272) * 1024) + transform_right_filter_feature_0_choice_354;
      else
        transform_right_filter_feature_0_choice_355 := transform_right_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_356 := (as_number(transform_right_filter_feature_0_choice_200) *
          262144) + (as_number(transform_right_filter_feature_0_choice_208) * 524288) +
          (as_number(transform_right_filter_feature_0_choice_216) * 131072) +
          (as_number(transform_right_filter_feature_0_choice_224) * 65536) +
          (as_number(transform_right_filter_feature_0_choice_232) * 32768) +
          transform_right_filter_feature_0_choice_355;
      else
        transform_right_filter_feature_0_choice_356 := transform_right_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_357 := (as_number(transform_right_filter_feature_0_choice_176) *
          2097152) + (as_number(transform_right_filter_feature_0_choice_184) * 4194304) +
          (as_number(transform_right_filter_feature_0_choice_192) * 1048576) +
          transform_right_filter_feature_0_choice_356;
      else
        transform_right_filter_feature_0_choice_357 := transform_right_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_0_choice_358 := (as_number(transform_right_filter_feature_0_choice_128) *
          16777216) + (as_number(transform_right_filter_feature_0_choice_136) * 33554432) +
          (as_number(transform_right_filter_feature_0_choice_144) * 67108864) +
          (as_number(transform_right_filter_feature_0_choice_152) * 134217728) +
          (as_number(transform_right_filter_feature_0_choice_160) * 268435456) +
          (as_number(transform_right_filter_feature_0_choice_168) * 8388608) +
          transform_right_filter_feature_0_choice_357;
      else
        transform_right_filter_feature_0_choice_358 := (as_number(transform_right_filter_feature_0_choice_168) *
          8388608) + transform_right_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_right_filter_feature_0_choice_359 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_120), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_88), 1) &
          to_unsigned(transform_right_filter_feature_0_choice_358, 29);
      else
        transform_right_filter_feature_0_choice_359 := to_unsigned(transform_right_filter_feature_0_choice_358, 34);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_right_filter_feature_0_choice_360 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_80), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_64), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_48), 1) &
          transform_right_filter_feature_0_choice_359(33 downto 0);
      else
        transform_right_filter_feature_0_choice_360 := resize(transform_right_filter_feature_0_choice_359, 39);
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
      transform_read_row_inside_1 <= (transform_counter_group >= 3) and (transform_counter_group < 15);
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_3 <= (transform_counter_group >= 1) and (transform_counter_group < 13);
      transform_read_row_inside_4 <= (not ((transform_counter_group / 8) = 1)) or (not (((transform_counter_group / 4)
        mod 2) = 1));
      transform_read_column_inside_0 <= ((transform_counter_column / 32) = 1) or transform_read_column_inside_0_value
        or transform_read_column_inside_0_value_2 or transform_read_column_inside_0_value_3;
      transform_read_column_inside_1 <= transform_read_column_inside_1_differs or ((transform_counter_column mod 4) =
        0);
      transform_read_column_inside_3 <= transform_read_column_inside_1_differs or (not ((transform_counter_column mod
        2) = 1)) or (not transform_read_column_inside_3_value);
      transform_read_column_inside_4 <= true;
      transform_read_column_inside_8 <= ((transform_counter_column / 32) = 1) or transform_read_column_inside_0_value
        or transform_read_column_inside_0_value_2 or (not transform_read_column_inside_0_value_3);
      transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 2);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_3 <= transform_read_row_inside_3;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_1 <= transform_read_column_inside_1;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_3 <= transform_read_column_inside_3;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_5 <= transform_read_column_inside_5;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_7 <= transform_read_column_inside_7;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column_1 <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column_2 <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column_3 <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column_4 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_1 <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_3 <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column_4 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_row_inside_3 <= transform_ready_row_inside_3;
      transform_columns_row_inside_4 <= transform_ready_row_inside_4;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_1 <= transform_ready_column_inside_1;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_3 <= transform_ready_column_inside_3;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_5 <= transform_ready_column_inside_5;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_column_inside_7 <= transform_ready_column_inside_7;
      transform_columns_column_inside_8 <= transform_ready_column_inside_8;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_1 <= transform_columns_column_inside_1;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_3 <= transform_columns_column_inside_3;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_5 <= transform_columns_column_inside_5;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_7 <= transform_columns_column_inside_7;
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
        transform_read_column_inside_2 <= transform_read_column_inside_1_differs;
      end if;
      if transform_read_column_inside_5_choice_2 then
        transform_read_column_inside_5 <= transform_read_column_inside_5_choice_3;
      else
        transform_read_column_inside_5 <= transform_read_column_inside_1_differs;
      end if;
      if transform_read_column_inside_6_choice then
        transform_read_column_inside_6 <= transform_read_column_inside_2_is_equal /=
          transform_read_column_inside_0_value_2;
      else
        transform_read_column_inside_6 <= transform_read_column_inside_1_differs;
      end if;
      if transform_read_column_inside_7_choice then
        transform_read_column_inside_7 <= transform_read_column_inside_5_choice_3;
      else
        transform_read_column_inside_7 <= transform_read_column_inside_1_differs;
      end if;
      if transform_filtering_0_column_inside_8 then
        transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_8), 1) &
          transform_left_filter_feature_0_choice_360(38 downto 0);
        transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_8), 1) &
          transform_right_filter_feature_0_choice_360(38 downto 0);
      else
        transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_360, 44);
        transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_360, 44);
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
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_1_3 <= transform_left_filter_column_0_3;
        transform_left_filter_column_1_4 <= transform_left_filter_column_0_4;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_2_3 <= transform_left_filter_column_1_3;
        transform_left_filter_column_2_4 <= transform_left_filter_column_1_4;
        transform_left_filter_column_3_0 <= transform_left_filter_column_2_0;
        transform_left_filter_column_3_1 <= transform_left_filter_column_2_1;
        transform_left_filter_column_3_2 <= transform_left_filter_column_2_2;
        transform_left_filter_column_3_3 <= transform_left_filter_column_2_3;
        transform_left_filter_column_3_4 <= transform_left_filter_column_2_4;
        transform_left_filter_column_4_0 <= transform_left_filter_column_3_0;
        transform_left_filter_column_4_1 <= transform_left_filter_column_3_1;
        transform_left_filter_column_4_2 <= transform_left_filter_column_3_2;
        transform_left_filter_column_4_3 <= transform_left_filter_column_3_3;
        transform_left_filter_column_4_4 <= transform_left_filter_column_3_4;
        transform_left_filter_column_5_0 <= transform_left_filter_column_4_0;
        transform_left_filter_column_5_1 <= transform_left_filter_column_4_1;
        transform_left_filter_column_5_2 <= transform_left_filter_column_4_2;
        transform_left_filter_column_5_3 <= transform_left_filter_column_4_3;
        transform_left_filter_column_5_4 <= transform_left_filter_column_4_4;
        transform_left_filter_column_6_0 <= transform_left_filter_column_5_0;
        transform_left_filter_column_6_1 <= transform_left_filter_column_5_1;
        transform_left_filter_column_6_2 <= transform_left_filter_column_5_2;
        transform_left_filter_column_6_3 <= transform_left_filter_column_5_3;
        transform_left_filter_column_6_4 <= transform_left_filter_column_5_4;
        transform_left_filter_column_7_0 <= transform_left_filter_column_6_0;
        transform_left_filter_column_7_1 <= transform_left_filter_column_6_1;
        transform_left_filter_column_7_2 <= transform_left_filter_column_6_2;
        transform_left_filter_column_7_3 <= transform_left_filter_column_6_3;
        transform_left_filter_column_7_4 <= transform_left_filter_column_6_4;
        transform_left_filter_column_8_0 <= transform_left_filter_column_7_0;
        transform_left_filter_column_8_1 <= transform_left_filter_column_7_1;
        transform_left_filter_column_8_2 <= transform_left_filter_column_7_2;
        transform_left_filter_column_8_3 <= transform_left_filter_column_7_3;
        transform_left_filter_column_8_4 <= transform_left_filter_column_7_4;
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_1_3 <= transform_right_filter_column_0_3;
        transform_right_filter_column_1_4 <= transform_right_filter_column_0_4;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_2_3 <= transform_right_filter_column_1_3;
        transform_right_filter_column_2_4 <= transform_right_filter_column_1_4;
        transform_right_filter_column_3_0 <= transform_right_filter_column_2_0;
        transform_right_filter_column_3_1 <= transform_right_filter_column_2_1;
        transform_right_filter_column_3_2 <= transform_right_filter_column_2_2;
        transform_right_filter_column_3_3 <= transform_right_filter_column_2_3;
        transform_right_filter_column_3_4 <= transform_right_filter_column_2_4;
        transform_right_filter_column_4_0 <= transform_right_filter_column_3_0;
        transform_right_filter_column_4_1 <= transform_right_filter_column_3_1;
        transform_right_filter_column_4_2 <= transform_right_filter_column_3_2;
        transform_right_filter_column_4_3 <= transform_right_filter_column_3_3;
        transform_right_filter_column_4_4 <= transform_right_filter_column_3_4;
        transform_right_filter_column_5_0 <= transform_right_filter_column_4_0;
        transform_right_filter_column_5_1 <= transform_right_filter_column_4_1;
        transform_right_filter_column_5_2 <= transform_right_filter_column_4_2;
        transform_right_filter_column_5_3 <= transform_right_filter_column_4_3;
        transform_right_filter_column_5_4 <= transform_right_filter_column_4_4;
        transform_right_filter_column_6_0 <= transform_right_filter_column_5_0;
        transform_right_filter_column_6_1 <= transform_right_filter_column_5_1;
        transform_right_filter_column_6_2 <= transform_right_filter_column_5_2;
        transform_right_filter_column_6_3 <= transform_right_filter_column_5_3;
        transform_right_filter_column_6_4 <= transform_right_filter_column_5_4;
        transform_right_filter_column_7_0 <= transform_right_filter_column_6_0;
        transform_right_filter_column_7_1 <= transform_right_filter_column_6_1;
        transform_right_filter_column_7_2 <= transform_right_filter_column_6_2;
        transform_right_filter_column_7_3 <= transform_right_filter_column_6_3;
        transform_right_filter_column_7_4 <= transform_right_filter_column_6_4;
        transform_right_filter_column_8_0 <= transform_right_filter_column_7_0;
        transform_right_filter_column_8_1 <= transform_right_filter_column_7_1;
        transform_right_filter_column_8_2 <= transform_right_filter_column_7_2;
        transform_right_filter_column_8_3 <= transform_right_filter_column_7_3;
        transform_right_filter_column_8_4 <= transform_right_filter_column_7_4;
        if transform_columns_row_inside_0 then
          transform_left_filter_column_0_0 <= transform_left_column_0;
          transform_right_filter_column_0_0 <= transform_right_column_0;
        else
          transform_left_filter_column_0_0 <= 0;
          transform_right_filter_column_0_0 <= 0;
        end if;
        if transform_columns_row_inside_1 then
          transform_left_filter_column_0_1 <= transform_left_column_1;
          transform_right_filter_column_0_1 <= transform_right_column_1;
        else
          transform_left_filter_column_0_1 <= 0;
          transform_right_filter_column_0_1 <= 0;
        end if;
        if transform_columns_row_inside_2 then
          transform_left_filter_column_0_2 <= transform_left_column_2;
          transform_right_filter_column_0_2 <= transform_right_column_2;
        else
          transform_left_filter_column_0_2 <= 0;
          transform_right_filter_column_0_2 <= 0;
        end if;
        if transform_columns_row_inside_3 then
          transform_left_filter_column_0_3 <= transform_left_column_3;
          transform_right_filter_column_0_3 <= transform_right_column_3;
        else
          transform_left_filter_column_0_3 <= 0;
          transform_right_filter_column_0_3 <= 0;
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
      raster_place_group_is_equal := raster_place_column = 39;
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_valid and transform_filtering_1_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 12) and
          raster_place_group_is_equal and transform_filtering_1_valid))) mod 16;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
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
      delay_tag_first_cost_is_equal := raster_place_column = 11;
      delay_tag_map_column_is_not_less := raster_place_column >= 11;
      delay_tag_map_column_is_less := raster_place_column < 40;
      delay_tag_map_column_all := delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_ahead_0 <= raster_features_search_0;
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= (not ((((raster_place_column / 8) mod 2) = 1) and ((((raster_place_column / 4) mod 2)
        = 1) or ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_all;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 0);
      delay_tag_end_of_line <= raster_place_group_is_equal;
      if (raster_place_group / 8) = 1 then
        delay_tag_output_column <= (not (((raster_place_group / 4) mod 2) = 1)) and delay_tag_map_column_is_not_less
          and delay_tag_map_column_is_less;
      else
        delay_tag_output_column <= delay_tag_map_column_all;
      end if;
      -- rows
      rows_search_0 <= delay_ahead_0;
      rows_reference_0 <= delay_delayed_0;
      rows_tag_valid <= delay_tag_valid;
      rows_tag_border_column <= delay_tag_border_column;
      rows_tag_first_cost <= delay_tag_first_cost;
      rows_tag_map_column <= delay_tag_map_column;
      rows_tag_output_column <= delay_tag_output_column;
      rows_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_tag_end_of_line <= delay_tag_end_of_line;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= slice0shift_search_0_3;
        slice0shift_search_0_3 <= slice0shift_search_0_4;
        slice0shift_search_0_4 <= rows_search_0;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pixels_first_0_0_count_0_value := to_integer(slice0shift_reference_0(2 downto 2)) = 1;
      slice0cost_pixels_first_0_0_count_0_value_2 := to_integer(slice0shift_reference_0(1 downto 1)) = 1;
      slice0cost_pixels_first_0_0_count_1_value := to_integer(slice0shift_reference_0(3 downto 3)) = 1;
      slice0cost_pixels_first_0_0_count_1_value_2 := to_integer(slice0shift_reference_0(5 downto 5)) = 1;
      slice0cost_pixels_first_0_0_count_1_value_3 := to_integer(slice0shift_reference_0(4 downto 4)) = 1;
      slice0cost_pixels_first_0_0_count_2_value := to_integer(slice0shift_reference_0(8 downto 8)) = 1;
      slice0cost_pixels_first_0_0_count_2_value_2 := to_integer(slice0shift_reference_0(6 downto 6)) = 1;
      slice0cost_pixels_first_0_0_count_3_value := to_integer(slice0shift_reference_0(9 downto 9)) = 1;
      slice0cost_pixels_first_0_0_count_3_value_2 := to_integer(slice0shift_reference_0(11 downto 11)) = 1;
      slice0cost_pixels_first_0_0_count_3_value_3 := to_integer(slice0shift_reference_0(10 downto 10)) = 1;
      slice0cost_pixels_first_0_0_count_4_value := to_integer(slice0shift_reference_0(12 downto 12)) = 1;
      slice0cost_pixels_first_0_0_count_4_value_2 := to_integer(slice0shift_reference_0(14 downto 14)) = 1;
      slice0cost_pixels_first_0_0_count_4_value_3 := to_integer(slice0shift_reference_0(13 downto 13)) = 1;
      slice0cost_pixels_first_0_0_count_5_value := to_integer(slice0shift_reference_0(15 downto 15)) = 1;
      slice0cost_pixels_first_0_0_count_5_value_2 := to_integer(slice0shift_reference_0(17 downto 17)) = 1;
      slice0cost_pixels_first_0_0_count_5_value_3 := to_integer(slice0shift_reference_0(16 downto 16)) = 1;
      slice0cost_pixels_first_0_0_count_6_value := to_integer(slice0shift_reference_0(18 downto 18)) = 1;
      slice0cost_pixels_first_0_0_count_6_value_2 := to_integer(slice0shift_reference_0(20 downto 20)) = 1;
      slice0cost_pixels_first_0_0_count_6_value_3 := to_integer(slice0shift_reference_0(19 downto 19)) = 1;
      slice0cost_pixels_first_0_0_count_7_value := to_integer(slice0shift_reference_0(21 downto 21)) = 1;
      slice0cost_pixels_first_0_0_count_7_value_2 := to_integer(slice0shift_reference_0(23 downto 23)) = 1;
      slice0cost_pixels_first_0_0_count_7_value_3 := to_integer(slice0shift_reference_0(22 downto 22)) = 1;
      slice0cost_pixels_first_0_0_count_8_value := to_integer(slice0shift_reference_0(24 downto 24)) = 1;
      slice0cost_pixels_first_0_0_count_8_value_2 := to_integer(slice0shift_reference_0(26 downto 26)) = 1;
      slice0cost_pixels_first_0_0_count_8_value_3 := to_integer(slice0shift_reference_0(25 downto 25)) = 1;
      slice0cost_pixels_first_0_0_count_9_value := to_integer(slice0shift_reference_0(27 downto 27)) = 1;
      slice0cost_pixels_first_0_0_count_9_value_2 := to_integer(slice0shift_reference_0(29 downto 29)) = 1;
      slice0cost_pixels_first_0_0_count_9_value_3 := to_integer(slice0shift_reference_0(28 downto 28)) = 1;
      slice0cost_pixels_first_0_0_count_10_value := to_integer(slice0shift_reference_0(30 downto 30)) = 1;
      slice0cost_pixels_first_0_0_count_10_value_2 := to_integer(slice0shift_reference_0(32 downto 32)) = 1;
      slice0cost_pixels_first_0_0_count_10_value_3 := to_integer(slice0shift_reference_0(31 downto 31)) = 1;
      slice0cost_pixels_first_0_0_count_11_value := to_integer(slice0shift_reference_0(33 downto 33)) = 1;
      slice0cost_pixels_first_0_0_count_11_value_2 := to_integer(slice0shift_reference_0(35 downto 35)) = 1;
      slice0cost_pixels_first_0_0_count_11_value_3 := to_integer(slice0shift_reference_0(34 downto 34)) = 1;
      slice0cost_pixels_first_0_0_count_12_value := to_integer(slice0shift_reference_0(36 downto 36)) = 1;
      slice0cost_pixels_first_0_0_count_12_value_2 := to_integer(slice0shift_reference_0(38 downto 38)) = 1;
      slice0cost_pixels_first_0_0_count_12_value_3 := to_integer(slice0shift_reference_0(37 downto 37)) = 1;
      slice0cost_pixels_first_0_0_count_13_value := to_integer(slice0shift_reference_0(39 downto 39)) = 1;
      slice0cost_pixels_first_0_0_count_13_value_2 := to_integer(slice0shift_reference_0(41 downto 41)) = 1;
      slice0cost_pixels_first_0_0_count_13_value_3 := to_integer(slice0shift_reference_0(40 downto 40)) = 1;
      slice0cost_pixels_first_0_0_count_14_value := to_integer(slice0shift_reference_0(42 downto 42)) = 1;
      slice0cost_pixels_first_0_0_count_0 <= as_number(((to_integer(slice0shift_search_0_0(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_0(0 downto 0)) = 1))) + as_number((slice0cost_pixels_first_0_0_count_0_value
        /= (to_integer(slice0shift_search_0_0(2 downto 2)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_0_value_2 /= (to_integer(slice0shift_search_0_0(1 downto 1)) =
        1)));
      slice0cost_pixels_first_0_0_count_1 <= as_number((slice0cost_pixels_first_0_0_count_1_value /=
        (to_integer(slice0shift_search_0_0(3 downto 3)) = 1))) + as_number((slice0cost_pixels_first_0_0_count_1_value_2
        /= (to_integer(slice0shift_search_0_0(5 downto 5)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_1_value_3 /= (to_integer(slice0shift_search_0_0(4 downto 4)) =
        1)));
      slice0cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0_0(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice0cost_pixels_first_0_0_count_2_value /= (to_integer(slice0shift_search_0_0(8 downto 8)) = 1)))
        + as_number((slice0cost_pixels_first_0_0_count_2_value_2 /= (to_integer(slice0shift_search_0_0(6 downto 6)) =
        1)));
      slice0cost_pixels_first_0_0_count_3 <= as_number((slice0cost_pixels_first_0_0_count_3_value /=
        (to_integer(slice0shift_search_0_0(9 downto 9)) = 1))) + as_number((slice0cost_pixels_first_0_0_count_3_value_2
        /= (to_integer(slice0shift_search_0_0(11 downto 11)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_3_value_3 /= (to_integer(slice0shift_search_0_0(10 downto 10)) =
        1)));
      slice0cost_pixels_first_0_0_count_4 <= as_number((slice0cost_pixels_first_0_0_count_4_value /=
        (to_integer(slice0shift_search_0_0(12 downto 12)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_4_value_2 /= (to_integer(slice0shift_search_0_0(14 downto 14)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_4_value_3 /= (to_integer(slice0shift_search_0_0(13 downto
        13)) = 1)));
      slice0cost_pixels_first_0_0_count_5 <= as_number((slice0cost_pixels_first_0_0_count_5_value /=
        (to_integer(slice0shift_search_0_0(15 downto 15)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_5_value_2 /= (to_integer(slice0shift_search_0_0(17 downto 17)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_5_value_3 /= (to_integer(slice0shift_search_0_0(16 downto
        16)) = 1)));
      slice0cost_pixels_first_0_0_count_6 <= as_number((slice0cost_pixels_first_0_0_count_6_value /=
        (to_integer(slice0shift_search_0_0(18 downto 18)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_6_value_2 /= (to_integer(slice0shift_search_0_0(20 downto 20)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_6_value_3 /= (to_integer(slice0shift_search_0_0(19 downto
        19)) = 1)));
      slice0cost_pixels_first_0_0_count_7 <= as_number((slice0cost_pixels_first_0_0_count_7_value /=
        (to_integer(slice0shift_search_0_0(21 downto 21)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_7_value_2 /= (to_integer(slice0shift_search_0_0(23 downto 23)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_7_value_3 /= (to_integer(slice0shift_search_0_0(22 downto
        22)) = 1)));
      slice0cost_pixels_first_0_0_count_8 <= as_number((slice0cost_pixels_first_0_0_count_8_value /=
        (to_integer(slice0shift_search_0_0(24 downto 24)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_8_value_2 /= (to_integer(slice0shift_search_0_0(26 downto 26)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_8_value_3 /= (to_integer(slice0shift_search_0_0(25 downto
        25)) = 1)));
      slice0cost_pixels_first_0_0_count_9 <= as_number((slice0cost_pixels_first_0_0_count_9_value /=
        (to_integer(slice0shift_search_0_0(27 downto 27)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_9_value_2 /= (to_integer(slice0shift_search_0_0(29 downto 29)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_9_value_3 /= (to_integer(slice0shift_search_0_0(28 downto
        28)) = 1)));
      slice0cost_pixels_first_0_0_count_10 <= as_number((slice0cost_pixels_first_0_0_count_10_value /=
        (to_integer(slice0shift_search_0_0(30 downto 30)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_10_value_2 /= (to_integer(slice0shift_search_0_0(32 downto 32)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_10_value_3 /= (to_integer(slice0shift_search_0_0(31 downto
        31)) = 1)));
      slice0cost_pixels_first_0_0_count_11 <= as_number((slice0cost_pixels_first_0_0_count_11_value /=
        (to_integer(slice0shift_search_0_0(33 downto 33)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_11_value_2 /= (to_integer(slice0shift_search_0_0(35 downto 35)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_11_value_3 /= (to_integer(slice0shift_search_0_0(34 downto
        34)) = 1)));
      slice0cost_pixels_first_0_0_count_12 <= as_number((slice0cost_pixels_first_0_0_count_12_value /=
        (to_integer(slice0shift_search_0_0(36 downto 36)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_12_value_2 /= (to_integer(slice0shift_search_0_0(38 downto 38)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_12_value_3 /= (to_integer(slice0shift_search_0_0(37 downto
        37)) = 1)));
      slice0cost_pixels_first_0_0_count_13 <= as_number((slice0cost_pixels_first_0_0_count_13_value /=
        (to_integer(slice0shift_search_0_0(39 downto 39)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_13_value_2 /= (to_integer(slice0shift_search_0_0(41 downto 41)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_13_value_3 /= (to_integer(slice0shift_search_0_0(40 downto
        40)) = 1)));
      slice0cost_pixels_first_0_0_count_14 <= as_number(((to_integer(slice0shift_reference_0(43 downto 43)) = 1) /=
        (to_integer(slice0shift_search_0_0(43 downto 43)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_14_value /= (to_integer(slice0shift_search_0_0(42 downto 42)) =
        1)));
      slice0cost_pixels_first_0_1_count_0 <= as_number(((to_integer(slice0shift_search_0_1(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_0_1(2
        downto 2)) = 1) /= slice0cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_0_1(1 downto 1)) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_1_count_1 <= as_number(((to_integer(slice0shift_search_0_1(3 downto 3)) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice0shift_search_0_1(5 downto 5)) = 1)
        /= slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_0_1(4 downto 4)) =
        1) /= slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0_1(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_0_1(8 downto 8)) = 1) /= slice0cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_0_1(6 downto 6)) = 1) /=
        slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_1_count_3 <= as_number(((to_integer(slice0shift_search_0_1(9 downto 9)) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice0shift_search_0_1(11 downto 11)) = 1)
        /= slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_0_1(10 downto 10))
        = 1) /= slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_1_count_4 <= as_number(((to_integer(slice0shift_search_0_1(12 downto 12)) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice0shift_search_0_1(14 downto 14)) = 1)
        /= slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_0_1(13 downto 13))
        = 1) /= slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_1_count_5 <= as_number(((to_integer(slice0shift_search_0_1(15 downto 15)) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice0shift_search_0_1(17 downto 17)) = 1)
        /= slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_0_1(16 downto 16))
        = 1) /= slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_1_count_6 <= as_number(((to_integer(slice0shift_search_0_1(18 downto 18)) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice0shift_search_0_1(20 downto 20)) = 1)
        /= slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_0_1(19 downto 19))
        = 1) /= slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_1_count_7 <= as_number(((to_integer(slice0shift_search_0_1(21 downto 21)) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice0shift_search_0_1(23 downto 23)) = 1)
        /= slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_0_1(22 downto 22))
        = 1) /= slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_1_count_8 <= as_number(((to_integer(slice0shift_search_0_1(24 downto 24)) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice0shift_search_0_1(26 downto 26)) = 1)
        /= slice0cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_0_1(25 downto 25))
        = 1) /= slice0cost_pixels_first_0_0_count_8_value_3));
      slice0cost_pixels_first_0_1_count_9 <= as_number(((to_integer(slice0shift_search_0_1(27 downto 27)) = 1) /=
        slice0cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice0shift_search_0_1(29 downto 29)) = 1)
        /= slice0cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_0_1(28 downto 28))
        = 1) /= slice0cost_pixels_first_0_0_count_9_value_3));
      slice0cost_pixels_first_0_1_count_10 <= as_number(((to_integer(slice0shift_search_0_1(30 downto 30)) = 1) /=
        slice0cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice0shift_search_0_1(32 downto 32)) =
        1) /= slice0cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_0_1(31 downto
        31)) = 1) /= slice0cost_pixels_first_0_0_count_10_value_3));
      slice0cost_pixels_first_0_1_count_11 <= as_number(((to_integer(slice0shift_search_0_1(33 downto 33)) = 1) /=
        slice0cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice0shift_search_0_1(35 downto 35)) =
        1) /= slice0cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_0_1(34 downto
        34)) = 1) /= slice0cost_pixels_first_0_0_count_11_value_3));
      slice0cost_pixels_first_0_1_count_12 <= as_number(((to_integer(slice0shift_search_0_1(36 downto 36)) = 1) /=
        slice0cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice0shift_search_0_1(38 downto 38)) =
        1) /= slice0cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_0_1(37 downto
        37)) = 1) /= slice0cost_pixels_first_0_0_count_12_value_3));
      slice0cost_pixels_first_0_1_count_13 <= as_number(((to_integer(slice0shift_search_0_1(39 downto 39)) = 1) /=
        slice0cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice0shift_search_0_1(41 downto 41)) =
        1) /= slice0cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_0_1(40 downto
        40)) = 1) /= slice0cost_pixels_first_0_0_count_13_value_3));
      slice0cost_pixels_first_0_1_count_14 <= as_number(((to_integer(slice0shift_search_0_1(43 downto 43)) = 1) /=
        (to_integer(slice0shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice0shift_search_0_1(42
        downto 42)) = 1) /= slice0cost_pixels_first_0_0_count_14_value));
      slice0cost_pixels_first_0_2_count_0 <= as_number(((to_integer(slice0shift_search_0_2(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_0_2(2
        downto 2)) = 1) /= slice0cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_0_2(1 downto 1)) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_2_count_1 <= as_number(((to_integer(slice0shift_search_0_2(3 downto 3)) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice0shift_search_0_2(5 downto 5)) = 1)
        /= slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_0_2(4 downto 4)) =
        1) /= slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_2_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0_2(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_0_2(8 downto 8)) = 1) /= slice0cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_0_2(6 downto 6)) = 1) /=
        slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_2_count_3 <= as_number(((to_integer(slice0shift_search_0_2(9 downto 9)) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice0shift_search_0_2(11 downto 11)) = 1)
        /= slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_0_2(10 downto 10))
        = 1) /= slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_2_count_4 <= as_number(((to_integer(slice0shift_search_0_2(12 downto 12)) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice0shift_search_0_2(14 downto 14)) = 1)
        /= slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_0_2(13 downto 13))
        = 1) /= slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_2_count_5 <= as_number(((to_integer(slice0shift_search_0_2(15 downto 15)) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice0shift_search_0_2(17 downto 17)) = 1)
        /= slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_0_2(16 downto 16))
        = 1) /= slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_2_count_6 <= as_number(((to_integer(slice0shift_search_0_2(18 downto 18)) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice0shift_search_0_2(20 downto 20)) = 1)
        /= slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_0_2(19 downto 19))
        = 1) /= slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_2_count_7 <= as_number(((to_integer(slice0shift_search_0_2(21 downto 21)) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice0shift_search_0_2(23 downto 23)) = 1)
        /= slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_0_2(22 downto 22))
        = 1) /= slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_2_count_8 <= as_number(((to_integer(slice0shift_search_0_2(24 downto 24)) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice0shift_search_0_2(26 downto 26)) = 1)
        /= slice0cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_0_2(25 downto 25))
        = 1) /= slice0cost_pixels_first_0_0_count_8_value_3));
      slice0cost_pixels_first_0_2_count_9 <= as_number(((to_integer(slice0shift_search_0_2(27 downto 27)) = 1) /=
        slice0cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice0shift_search_0_2(29 downto 29)) = 1)
        /= slice0cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_0_2(28 downto 28))
        = 1) /= slice0cost_pixels_first_0_0_count_9_value_3));
      slice0cost_pixels_first_0_2_count_10 <= as_number(((to_integer(slice0shift_search_0_2(30 downto 30)) = 1) /=
        slice0cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice0shift_search_0_2(32 downto 32)) =
        1) /= slice0cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_0_2(31 downto
        31)) = 1) /= slice0cost_pixels_first_0_0_count_10_value_3));
      slice0cost_pixels_first_0_2_count_11 <= as_number(((to_integer(slice0shift_search_0_2(33 downto 33)) = 1) /=
        slice0cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice0shift_search_0_2(35 downto 35)) =
        1) /= slice0cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_0_2(34 downto
        34)) = 1) /= slice0cost_pixels_first_0_0_count_11_value_3));
      slice0cost_pixels_first_0_2_count_12 <= as_number(((to_integer(slice0shift_search_0_2(36 downto 36)) = 1) /=
        slice0cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice0shift_search_0_2(38 downto 38)) =
        1) /= slice0cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_0_2(37 downto
        37)) = 1) /= slice0cost_pixels_first_0_0_count_12_value_3));
      slice0cost_pixels_first_0_2_count_13 <= as_number(((to_integer(slice0shift_search_0_2(39 downto 39)) = 1) /=
        slice0cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice0shift_search_0_2(41 downto 41)) =
        1) /= slice0cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_0_2(40 downto
        40)) = 1) /= slice0cost_pixels_first_0_0_count_13_value_3));
      slice0cost_pixels_first_0_2_count_14 <= as_number(((to_integer(slice0shift_search_0_2(43 downto 43)) = 1) /=
        (to_integer(slice0shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice0shift_search_0_2(42
        downto 42)) = 1) /= slice0cost_pixels_first_0_0_count_14_value));
      slice0cost_pixels_first_0_3_count_0 <= as_number(((to_integer(slice0shift_search_0_3(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_0_3(2
        downto 2)) = 1) /= slice0cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_0_3(1 downto 1)) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_3_count_1 <= as_number(((to_integer(slice0shift_search_0_3(3 downto 3)) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice0shift_search_0_3(5 downto 5)) = 1)
        /= slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_0_3(4 downto 4)) =
        1) /= slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_3_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0_3(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_0_3(8 downto 8)) = 1) /= slice0cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_0_3(6 downto 6)) = 1) /=
        slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_3_count_3 <= as_number(((to_integer(slice0shift_search_0_3(9 downto 9)) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice0shift_search_0_3(11 downto 11)) = 1)
        /= slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_0_3(10 downto 10))
        = 1) /= slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_3_count_4 <= as_number(((to_integer(slice0shift_search_0_3(12 downto 12)) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice0shift_search_0_3(14 downto 14)) = 1)
        /= slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_0_3(13 downto 13))
        = 1) /= slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_3_count_5 <= as_number(((to_integer(slice0shift_search_0_3(15 downto 15)) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice0shift_search_0_3(17 downto 17)) = 1)
        /= slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_0_3(16 downto 16))
        = 1) /= slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_3_count_6 <= as_number(((to_integer(slice0shift_search_0_3(18 downto 18)) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice0shift_search_0_3(20 downto 20)) = 1)
        /= slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_0_3(19 downto 19))
        = 1) /= slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_3_count_7 <= as_number(((to_integer(slice0shift_search_0_3(21 downto 21)) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice0shift_search_0_3(23 downto 23)) = 1)
        /= slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_0_3(22 downto 22))
        = 1) /= slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_3_count_8 <= as_number(((to_integer(slice0shift_search_0_3(24 downto 24)) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice0shift_search_0_3(26 downto 26)) = 1)
        /= slice0cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_0_3(25 downto 25))
        = 1) /= slice0cost_pixels_first_0_0_count_8_value_3));
      slice0cost_pixels_first_0_3_count_9 <= as_number(((to_integer(slice0shift_search_0_3(27 downto 27)) = 1) /=
        slice0cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice0shift_search_0_3(29 downto 29)) = 1)
        /= slice0cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_0_3(28 downto 28))
        = 1) /= slice0cost_pixels_first_0_0_count_9_value_3));
      slice0cost_pixels_first_0_3_count_10 <= as_number(((to_integer(slice0shift_search_0_3(30 downto 30)) = 1) /=
        slice0cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice0shift_search_0_3(32 downto 32)) =
        1) /= slice0cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_0_3(31 downto
        31)) = 1) /= slice0cost_pixels_first_0_0_count_10_value_3));
      slice0cost_pixels_first_0_3_count_11 <= as_number(((to_integer(slice0shift_search_0_3(33 downto 33)) = 1) /=
        slice0cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice0shift_search_0_3(35 downto 35)) =
        1) /= slice0cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_0_3(34 downto
        34)) = 1) /= slice0cost_pixels_first_0_0_count_11_value_3));
      slice0cost_pixels_first_0_3_count_12 <= as_number(((to_integer(slice0shift_search_0_3(36 downto 36)) = 1) /=
        slice0cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice0shift_search_0_3(38 downto 38)) =
        1) /= slice0cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_0_3(37 downto
        37)) = 1) /= slice0cost_pixels_first_0_0_count_12_value_3));
      slice0cost_pixels_first_0_3_count_13 <= as_number(((to_integer(slice0shift_search_0_3(39 downto 39)) = 1) /=
        slice0cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice0shift_search_0_3(41 downto 41)) =
        1) /= slice0cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_0_3(40 downto
        40)) = 1) /= slice0cost_pixels_first_0_0_count_13_value_3));
      slice0cost_pixels_first_0_3_count_14 <= as_number(((to_integer(slice0shift_search_0_3(43 downto 43)) = 1) /=
        (to_integer(slice0shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice0shift_search_0_3(42
        downto 42)) = 1) /= slice0cost_pixels_first_0_0_count_14_value));
      slice0cost_pixels_first_0_4_count_0 <= as_number(((to_integer(slice0shift_search_0_4(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_0_4(2
        downto 2)) = 1) /= slice0cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_0_4(1 downto 1)) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_4_count_1 <= as_number(((to_integer(slice0shift_search_0_4(3 downto 3)) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice0shift_search_0_4(5 downto 5)) = 1)
        /= slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_0_4(4 downto 4)) =
        1) /= slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_4_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0_4(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_0_4(8 downto 8)) = 1) /= slice0cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_0_4(6 downto 6)) = 1) /=
        slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_4_count_3 <= as_number(((to_integer(slice0shift_search_0_4(9 downto 9)) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice0shift_search_0_4(11 downto 11)) = 1)
        /= slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_0_4(10 downto 10))
        = 1) /= slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_4_count_4 <= as_number(((to_integer(slice0shift_search_0_4(12 downto 12)) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice0shift_search_0_4(14 downto 14)) = 1)
        /= slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_0_4(13 downto 13))
        = 1) /= slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_4_count_5 <= as_number(((to_integer(slice0shift_search_0_4(15 downto 15)) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice0shift_search_0_4(17 downto 17)) = 1)
        /= slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_0_4(16 downto 16))
        = 1) /= slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_4_count_6 <= as_number(((to_integer(slice0shift_search_0_4(18 downto 18)) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice0shift_search_0_4(20 downto 20)) = 1)
        /= slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_0_4(19 downto 19))
        = 1) /= slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_4_count_7 <= as_number(((to_integer(slice0shift_search_0_4(21 downto 21)) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice0shift_search_0_4(23 downto 23)) = 1)
        /= slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_0_4(22 downto 22))
        = 1) /= slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_4_count_8 <= as_number(((to_integer(slice0shift_search_0_4(24 downto 24)) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice0shift_search_0_4(26 downto 26)) = 1)
        /= slice0cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_0_4(25 downto 25))
        = 1) /= slice0cost_pixels_first_0_0_count_8_value_3));
      slice0cost_pixels_first_0_4_count_9 <= as_number(((to_integer(slice0shift_search_0_4(27 downto 27)) = 1) /=
        slice0cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice0shift_search_0_4(29 downto 29)) = 1)
        /= slice0cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_0_4(28 downto 28))
        = 1) /= slice0cost_pixels_first_0_0_count_9_value_3));
      slice0cost_pixels_first_0_4_count_10 <= as_number(((to_integer(slice0shift_search_0_4(30 downto 30)) = 1) /=
        slice0cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice0shift_search_0_4(32 downto 32)) =
        1) /= slice0cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_0_4(31 downto
        31)) = 1) /= slice0cost_pixels_first_0_0_count_10_value_3));
      slice0cost_pixels_first_0_4_count_11 <= as_number(((to_integer(slice0shift_search_0_4(33 downto 33)) = 1) /=
        slice0cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice0shift_search_0_4(35 downto 35)) =
        1) /= slice0cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_0_4(34 downto
        34)) = 1) /= slice0cost_pixels_first_0_0_count_11_value_3));
      slice0cost_pixels_first_0_4_count_12 <= as_number(((to_integer(slice0shift_search_0_4(36 downto 36)) = 1) /=
        slice0cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice0shift_search_0_4(38 downto 38)) =
        1) /= slice0cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_0_4(37 downto
        37)) = 1) /= slice0cost_pixels_first_0_0_count_12_value_3));
      slice0cost_pixels_first_0_4_count_13 <= as_number(((to_integer(slice0shift_search_0_4(39 downto 39)) = 1) /=
        slice0cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice0shift_search_0_4(41 downto 41)) =
        1) /= slice0cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_0_4(40 downto
        40)) = 1) /= slice0cost_pixels_first_0_0_count_13_value_3));
      slice0cost_pixels_first_0_4_count_14 <= as_number(((to_integer(slice0shift_search_0_4(43 downto 43)) = 1) /=
        (to_integer(slice0shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice0shift_search_0_4(42
        downto 42)) = 1) /= slice0cost_pixels_first_0_0_count_14_value));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_7 +
        slice0cost_pixels_first_0_0_count_12 + slice0cost_pixels_first_0_0_count_6 +
        slice0cost_pixels_first_0_0_count_9 + slice0cost_pixels_first_0_0_count_14 +
        slice0cost_pixels_first_0_0_count_11 + slice0cost_pixels_first_0_0_count_2 +
        slice0cost_pixels_first_0_0_count_10 + slice0cost_pixels_first_0_0_count_4 +
        slice0cost_pixels_first_0_0_count_8 + slice0cost_pixels_first_0_0_count_1 + slice0cost_pixels_first_0_0_count_5
        + slice0cost_pixels_first_0_0_count_0 + slice0cost_pixels_first_0_0_count_13;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_7 +
        slice0cost_pixels_first_0_1_count_12 + slice0cost_pixels_first_0_1_count_6 +
        slice0cost_pixels_first_0_1_count_9 + slice0cost_pixels_first_0_1_count_14 +
        slice0cost_pixels_first_0_1_count_11 + slice0cost_pixels_first_0_1_count_2 +
        slice0cost_pixels_first_0_1_count_10 + slice0cost_pixels_first_0_1_count_4 +
        slice0cost_pixels_first_0_1_count_8 + slice0cost_pixels_first_0_1_count_1 + slice0cost_pixels_first_0_1_count_5
        + slice0cost_pixels_first_0_1_count_0 + slice0cost_pixels_first_0_1_count_13;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_7 +
        slice0cost_pixels_first_0_2_count_12 + slice0cost_pixels_first_0_2_count_6 +
        slice0cost_pixels_first_0_2_count_9 + slice0cost_pixels_first_0_2_count_14 +
        slice0cost_pixels_first_0_2_count_11 + slice0cost_pixels_first_0_2_count_2 +
        slice0cost_pixels_first_0_2_count_10 + slice0cost_pixels_first_0_2_count_4 +
        slice0cost_pixels_first_0_2_count_8 + slice0cost_pixels_first_0_2_count_1 + slice0cost_pixels_first_0_2_count_5
        + slice0cost_pixels_first_0_2_count_0 + slice0cost_pixels_first_0_2_count_13;
      slice0cost_pixels_cost_0_3 <= slice0cost_pixels_first_0_3_count_3 + slice0cost_pixels_first_0_3_count_7 +
        slice0cost_pixels_first_0_3_count_12 + slice0cost_pixels_first_0_3_count_6 +
        slice0cost_pixels_first_0_3_count_9 + slice0cost_pixels_first_0_3_count_14 +
        slice0cost_pixels_first_0_3_count_11 + slice0cost_pixels_first_0_3_count_2 +
        slice0cost_pixels_first_0_3_count_10 + slice0cost_pixels_first_0_3_count_4 +
        slice0cost_pixels_first_0_3_count_8 + slice0cost_pixels_first_0_3_count_1 + slice0cost_pixels_first_0_3_count_5
        + slice0cost_pixels_first_0_3_count_0 + slice0cost_pixels_first_0_3_count_13;
      slice0cost_pixels_cost_0_4 <= slice0cost_pixels_first_0_4_count_3 + slice0cost_pixels_first_0_4_count_7 +
        slice0cost_pixels_first_0_4_count_12 + slice0cost_pixels_first_0_4_count_6 +
        slice0cost_pixels_first_0_4_count_9 + slice0cost_pixels_first_0_4_count_14 +
        slice0cost_pixels_first_0_4_count_11 + slice0cost_pixels_first_0_4_count_2 +
        slice0cost_pixels_first_0_4_count_10 + slice0cost_pixels_first_0_4_count_4 +
        slice0cost_pixels_first_0_4_count_8 + slice0cost_pixels_first_0_4_count_1 + slice0cost_pixels_first_0_4_count_5
        + slice0cost_pixels_first_0_4_count_0 + slice0cost_pixels_first_0_4_count_13;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
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
      -- slice0window
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_border_column <= slice0cost_tag_border_column;
      slice0window_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_tag_map_column <= slice0cost_tag_map_column;
      slice0window_tag_output_column <= slice0cost_tag_output_column;
      slice0window_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_tag_end_of_line <= slice0cost_tag_end_of_line;
      -- slice0
      slice0_held_0_0 <= other_22 / 4;
      slice0_held_0_1 <= other_20 / 4;
      slice0_held_0_2 <= other_18 / 4;
      slice0_held_0_3 <= other_16 / 4;
      slice0_held_0_4 <= other_14 / 4;
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
      slice0_tag_0_first_cost <= slice0window_tag_first_cost;
      slice0_tag_0_map_column <= slice0window_tag_map_column;
      slice0_tag_0_output_column <= slice0window_tag_output_column;
      slice0_tag_0_start_of_frame <= slice0window_tag_start_of_frame;
      slice0_tag_0_end_of_line <= slice0window_tag_end_of_line;
      slice0_tag_1_valid <= slice0_tag_0_valid;
      slice0_tag_1_first_cost <= slice0_tag_0_first_cost;
      slice0_tag_1_map_column <= slice0_tag_0_map_column;
      slice0_tag_1_output_column <= slice0_tag_0_output_column;
      slice0_tag_1_start_of_frame <= slice0_tag_0_start_of_frame;
      slice0_tag_1_end_of_line <= slice0_tag_0_end_of_line;
      slice0_tag_2_valid <= slice0_tag_1_valid;
      slice0_tag_2_first_cost <= slice0_tag_1_first_cost;
      slice0_tag_2_map_column <= slice0_tag_1_map_column;
      slice0_tag_2_output_column <= slice0_tag_1_output_column;
      slice0_tag_2_start_of_frame <= slice0_tag_1_start_of_frame;
      slice0_tag_2_end_of_line <= slice0_tag_1_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice1shift_search_0_3;
        slice1shift_search_0_3 <= slice1shift_search_0_4;
        slice1shift_search_0_4 <= slice0shift_search_out_0;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      -- slice1cost
      slice1cost_pixels_first_0_0_count_0_value := to_integer(slice1shift_reference_0(2 downto 2)) = 1;
      slice1cost_pixels_first_0_0_count_0_value_2 := to_integer(slice1shift_reference_0(1 downto 1)) = 1;
      slice1cost_pixels_first_0_0_count_1_value := to_integer(slice1shift_reference_0(3 downto 3)) = 1;
      slice1cost_pixels_first_0_0_count_1_value_2 := to_integer(slice1shift_reference_0(5 downto 5)) = 1;
      slice1cost_pixels_first_0_0_count_1_value_3 := to_integer(slice1shift_reference_0(4 downto 4)) = 1;
      slice1cost_pixels_first_0_0_count_2_value := to_integer(slice1shift_reference_0(8 downto 8)) = 1;
      slice1cost_pixels_first_0_0_count_2_value_2 := to_integer(slice1shift_reference_0(6 downto 6)) = 1;
      slice1cost_pixels_first_0_0_count_3_value := to_integer(slice1shift_reference_0(9 downto 9)) = 1;
      slice1cost_pixels_first_0_0_count_3_value_2 := to_integer(slice1shift_reference_0(11 downto 11)) = 1;
      slice1cost_pixels_first_0_0_count_3_value_3 := to_integer(slice1shift_reference_0(10 downto 10)) = 1;
      slice1cost_pixels_first_0_0_count_4_value := to_integer(slice1shift_reference_0(12 downto 12)) = 1;
      slice1cost_pixels_first_0_0_count_4_value_2 := to_integer(slice1shift_reference_0(14 downto 14)) = 1;
      slice1cost_pixels_first_0_0_count_4_value_3 := to_integer(slice1shift_reference_0(13 downto 13)) = 1;
      slice1cost_pixels_first_0_0_count_5_value := to_integer(slice1shift_reference_0(15 downto 15)) = 1;
      slice1cost_pixels_first_0_0_count_5_value_2 := to_integer(slice1shift_reference_0(17 downto 17)) = 1;
      slice1cost_pixels_first_0_0_count_5_value_3 := to_integer(slice1shift_reference_0(16 downto 16)) = 1;
      slice1cost_pixels_first_0_0_count_6_value := to_integer(slice1shift_reference_0(18 downto 18)) = 1;
      slice1cost_pixels_first_0_0_count_6_value_2 := to_integer(slice1shift_reference_0(20 downto 20)) = 1;
      slice1cost_pixels_first_0_0_count_6_value_3 := to_integer(slice1shift_reference_0(19 downto 19)) = 1;
      slice1cost_pixels_first_0_0_count_7_value := to_integer(slice1shift_reference_0(21 downto 21)) = 1;
      slice1cost_pixels_first_0_0_count_7_value_2 := to_integer(slice1shift_reference_0(23 downto 23)) = 1;
      slice1cost_pixels_first_0_0_count_7_value_3 := to_integer(slice1shift_reference_0(22 downto 22)) = 1;
      slice1cost_pixels_first_0_0_count_8_value := to_integer(slice1shift_reference_0(24 downto 24)) = 1;
      slice1cost_pixels_first_0_0_count_8_value_2 := to_integer(slice1shift_reference_0(26 downto 26)) = 1;
      slice1cost_pixels_first_0_0_count_8_value_3 := to_integer(slice1shift_reference_0(25 downto 25)) = 1;
      slice1cost_pixels_first_0_0_count_9_value := to_integer(slice1shift_reference_0(27 downto 27)) = 1;
      slice1cost_pixels_first_0_0_count_9_value_2 := to_integer(slice1shift_reference_0(29 downto 29)) = 1;
      slice1cost_pixels_first_0_0_count_9_value_3 := to_integer(slice1shift_reference_0(28 downto 28)) = 1;
      slice1cost_pixels_first_0_0_count_10_value := to_integer(slice1shift_reference_0(30 downto 30)) = 1;
      slice1cost_pixels_first_0_0_count_10_value_2 := to_integer(slice1shift_reference_0(32 downto 32)) = 1;
      slice1cost_pixels_first_0_0_count_10_value_3 := to_integer(slice1shift_reference_0(31 downto 31)) = 1;
      slice1cost_pixels_first_0_0_count_11_value := to_integer(slice1shift_reference_0(33 downto 33)) = 1;
      slice1cost_pixels_first_0_0_count_11_value_2 := to_integer(slice1shift_reference_0(35 downto 35)) = 1;
      slice1cost_pixels_first_0_0_count_11_value_3 := to_integer(slice1shift_reference_0(34 downto 34)) = 1;
      slice1cost_pixels_first_0_0_count_12_value := to_integer(slice1shift_reference_0(36 downto 36)) = 1;
      slice1cost_pixels_first_0_0_count_12_value_2 := to_integer(slice1shift_reference_0(38 downto 38)) = 1;
      slice1cost_pixels_first_0_0_count_12_value_3 := to_integer(slice1shift_reference_0(37 downto 37)) = 1;
      slice1cost_pixels_first_0_0_count_13_value := to_integer(slice1shift_reference_0(39 downto 39)) = 1;
      slice1cost_pixels_first_0_0_count_13_value_2 := to_integer(slice1shift_reference_0(41 downto 41)) = 1;
      slice1cost_pixels_first_0_0_count_13_value_3 := to_integer(slice1shift_reference_0(40 downto 40)) = 1;
      slice1cost_pixels_first_0_0_count_14_value := to_integer(slice1shift_reference_0(42 downto 42)) = 1;
      slice1cost_pixels_first_0_0_count_0 <= as_number(((to_integer(slice1shift_search_0_0(0 downto 0)) = 1) /=
        (to_integer(slice1shift_reference_0(0 downto 0)) = 1))) + as_number((slice1cost_pixels_first_0_0_count_0_value
        /= (to_integer(slice1shift_search_0_0(2 downto 2)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_0_value_2 /= (to_integer(slice1shift_search_0_0(1 downto 1)) =
        1)));
      slice1cost_pixels_first_0_0_count_1 <= as_number((slice1cost_pixels_first_0_0_count_1_value /=
        (to_integer(slice1shift_search_0_0(3 downto 3)) = 1))) + as_number((slice1cost_pixels_first_0_0_count_1_value_2
        /= (to_integer(slice1shift_search_0_0(5 downto 5)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_1_value_3 /= (to_integer(slice1shift_search_0_0(4 downto 4)) =
        1)));
      slice1cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0_0(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice1cost_pixels_first_0_0_count_2_value /= (to_integer(slice1shift_search_0_0(8 downto 8)) = 1)))
        + as_number((slice1cost_pixels_first_0_0_count_2_value_2 /= (to_integer(slice1shift_search_0_0(6 downto 6)) =
        1)));
      slice1cost_pixels_first_0_0_count_3 <= as_number((slice1cost_pixels_first_0_0_count_3_value /=
        (to_integer(slice1shift_search_0_0(9 downto 9)) = 1))) + as_number((slice1cost_pixels_first_0_0_count_3_value_2
        /= (to_integer(slice1shift_search_0_0(11 downto 11)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_3_value_3 /= (to_integer(slice1shift_search_0_0(10 downto 10)) =
        1)));
      slice1cost_pixels_first_0_0_count_4 <= as_number((slice1cost_pixels_first_0_0_count_4_value /=
        (to_integer(slice1shift_search_0_0(12 downto 12)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_4_value_2 /= (to_integer(slice1shift_search_0_0(14 downto 14)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_4_value_3 /= (to_integer(slice1shift_search_0_0(13 downto
        13)) = 1)));
      slice1cost_pixels_first_0_0_count_5 <= as_number((slice1cost_pixels_first_0_0_count_5_value /=
        (to_integer(slice1shift_search_0_0(15 downto 15)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_5_value_2 /= (to_integer(slice1shift_search_0_0(17 downto 17)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_5_value_3 /= (to_integer(slice1shift_search_0_0(16 downto
        16)) = 1)));
      slice1cost_pixels_first_0_0_count_6 <= as_number((slice1cost_pixels_first_0_0_count_6_value /=
        (to_integer(slice1shift_search_0_0(18 downto 18)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_6_value_2 /= (to_integer(slice1shift_search_0_0(20 downto 20)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_6_value_3 /= (to_integer(slice1shift_search_0_0(19 downto
        19)) = 1)));
      slice1cost_pixels_first_0_0_count_7 <= as_number((slice1cost_pixels_first_0_0_count_7_value /=
        (to_integer(slice1shift_search_0_0(21 downto 21)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_7_value_2 /= (to_integer(slice1shift_search_0_0(23 downto 23)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_7_value_3 /= (to_integer(slice1shift_search_0_0(22 downto
        22)) = 1)));
      slice1cost_pixels_first_0_0_count_8 <= as_number((slice1cost_pixels_first_0_0_count_8_value /=
        (to_integer(slice1shift_search_0_0(24 downto 24)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_8_value_2 /= (to_integer(slice1shift_search_0_0(26 downto 26)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_8_value_3 /= (to_integer(slice1shift_search_0_0(25 downto
        25)) = 1)));
      slice1cost_pixels_first_0_0_count_9 <= as_number((slice1cost_pixels_first_0_0_count_9_value /=
        (to_integer(slice1shift_search_0_0(27 downto 27)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_9_value_2 /= (to_integer(slice1shift_search_0_0(29 downto 29)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_9_value_3 /= (to_integer(slice1shift_search_0_0(28 downto
        28)) = 1)));
      slice1cost_pixels_first_0_0_count_10 <= as_number((slice1cost_pixels_first_0_0_count_10_value /=
        (to_integer(slice1shift_search_0_0(30 downto 30)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_10_value_2 /= (to_integer(slice1shift_search_0_0(32 downto 32)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_10_value_3 /= (to_integer(slice1shift_search_0_0(31 downto
        31)) = 1)));
      slice1cost_pixels_first_0_0_count_11 <= as_number((slice1cost_pixels_first_0_0_count_11_value /=
        (to_integer(slice1shift_search_0_0(33 downto 33)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_11_value_2 /= (to_integer(slice1shift_search_0_0(35 downto 35)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_11_value_3 /= (to_integer(slice1shift_search_0_0(34 downto
        34)) = 1)));
      slice1cost_pixels_first_0_0_count_12 <= as_number((slice1cost_pixels_first_0_0_count_12_value /=
        (to_integer(slice1shift_search_0_0(36 downto 36)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_12_value_2 /= (to_integer(slice1shift_search_0_0(38 downto 38)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_12_value_3 /= (to_integer(slice1shift_search_0_0(37 downto
        37)) = 1)));
      slice1cost_pixels_first_0_0_count_13 <= as_number((slice1cost_pixels_first_0_0_count_13_value /=
        (to_integer(slice1shift_search_0_0(39 downto 39)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_13_value_2 /= (to_integer(slice1shift_search_0_0(41 downto 41)) =
        1))) + as_number((slice1cost_pixels_first_0_0_count_13_value_3 /= (to_integer(slice1shift_search_0_0(40 downto
        40)) = 1)));
      slice1cost_pixels_first_0_0_count_14 <= as_number(((to_integer(slice1shift_reference_0(43 downto 43)) = 1) /=
        (to_integer(slice1shift_search_0_0(43 downto 43)) = 1))) +
        as_number((slice1cost_pixels_first_0_0_count_14_value /= (to_integer(slice1shift_search_0_0(42 downto 42)) =
        1)));
      slice1cost_pixels_first_0_1_count_0 <= as_number(((to_integer(slice1shift_search_0_1(0 downto 0)) = 1) /=
        (to_integer(slice1shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice1shift_search_0_1(2
        downto 2)) = 1) /= slice1cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice1shift_search_0_1(1 downto 1)) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_1_count_1 <= as_number(((to_integer(slice1shift_search_0_1(3 downto 3)) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice1shift_search_0_1(5 downto 5)) = 1)
        /= slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice1shift_search_0_1(4 downto 4)) =
        1) /= slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0_1(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice1shift_search_0_1(8 downto 8)) = 1) /= slice1cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice1shift_search_0_1(6 downto 6)) = 1) /=
        slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_1_count_3 <= as_number(((to_integer(slice1shift_search_0_1(9 downto 9)) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice1shift_search_0_1(11 downto 11)) = 1)
        /= slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice1shift_search_0_1(10 downto 10))
        = 1) /= slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_1_count_4 <= as_number(((to_integer(slice1shift_search_0_1(12 downto 12)) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice1shift_search_0_1(14 downto 14)) = 1)
        /= slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice1shift_search_0_1(13 downto 13))
        = 1) /= slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_1_count_5 <= as_number(((to_integer(slice1shift_search_0_1(15 downto 15)) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice1shift_search_0_1(17 downto 17)) = 1)
        /= slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice1shift_search_0_1(16 downto 16))
        = 1) /= slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_1_count_6 <= as_number(((to_integer(slice1shift_search_0_1(18 downto 18)) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice1shift_search_0_1(20 downto 20)) = 1)
        /= slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice1shift_search_0_1(19 downto 19))
        = 1) /= slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_1_count_7 <= as_number(((to_integer(slice1shift_search_0_1(21 downto 21)) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice1shift_search_0_1(23 downto 23)) = 1)
        /= slice1cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice1shift_search_0_1(22 downto 22))
        = 1) /= slice1cost_pixels_first_0_0_count_7_value_3));
      slice1cost_pixels_first_0_1_count_8 <= as_number(((to_integer(slice1shift_search_0_1(24 downto 24)) = 1) /=
        slice1cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice1shift_search_0_1(26 downto 26)) = 1)
        /= slice1cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice1shift_search_0_1(25 downto 25))
        = 1) /= slice1cost_pixels_first_0_0_count_8_value_3));
      slice1cost_pixels_first_0_1_count_9 <= as_number(((to_integer(slice1shift_search_0_1(27 downto 27)) = 1) /=
        slice1cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice1shift_search_0_1(29 downto 29)) = 1)
        /= slice1cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice1shift_search_0_1(28 downto 28))
        = 1) /= slice1cost_pixels_first_0_0_count_9_value_3));
      slice1cost_pixels_first_0_1_count_10 <= as_number(((to_integer(slice1shift_search_0_1(30 downto 30)) = 1) /=
        slice1cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice1shift_search_0_1(32 downto 32)) =
        1) /= slice1cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice1shift_search_0_1(31 downto
        31)) = 1) /= slice1cost_pixels_first_0_0_count_10_value_3));
      slice1cost_pixels_first_0_1_count_11 <= as_number(((to_integer(slice1shift_search_0_1(33 downto 33)) = 1) /=
        slice1cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice1shift_search_0_1(35 downto 35)) =
        1) /= slice1cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice1shift_search_0_1(34 downto
        34)) = 1) /= slice1cost_pixels_first_0_0_count_11_value_3));
      slice1cost_pixels_first_0_1_count_12 <= as_number(((to_integer(slice1shift_search_0_1(36 downto 36)) = 1) /=
        slice1cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice1shift_search_0_1(38 downto 38)) =
        1) /= slice1cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice1shift_search_0_1(37 downto
        37)) = 1) /= slice1cost_pixels_first_0_0_count_12_value_3));
      slice1cost_pixels_first_0_1_count_13 <= as_number(((to_integer(slice1shift_search_0_1(39 downto 39)) = 1) /=
        slice1cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice1shift_search_0_1(41 downto 41)) =
        1) /= slice1cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice1shift_search_0_1(40 downto
        40)) = 1) /= slice1cost_pixels_first_0_0_count_13_value_3));
      slice1cost_pixels_first_0_1_count_14 <= as_number(((to_integer(slice1shift_search_0_1(43 downto 43)) = 1) /=
        (to_integer(slice1shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice1shift_search_0_1(42
        downto 42)) = 1) /= slice1cost_pixels_first_0_0_count_14_value));
      slice1cost_pixels_first_0_2_count_0 <= as_number(((to_integer(slice1shift_search_0_2(0 downto 0)) = 1) /=
        (to_integer(slice1shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice1shift_search_0_2(2
        downto 2)) = 1) /= slice1cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice1shift_search_0_2(1 downto 1)) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_2_count_1 <= as_number(((to_integer(slice1shift_search_0_2(3 downto 3)) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice1shift_search_0_2(5 downto 5)) = 1)
        /= slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice1shift_search_0_2(4 downto 4)) =
        1) /= slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_2_count_2 <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0_2(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice1shift_search_0_2(8 downto 8)) = 1) /= slice1cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice1shift_search_0_2(6 downto 6)) = 1) /=
        slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_2_count_3 <= as_number(((to_integer(slice1shift_search_0_2(9 downto 9)) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice1shift_search_0_2(11 downto 11)) = 1)
        /= slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice1shift_search_0_2(10 downto 10))
        = 1) /= slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_2_count_4 <= as_number(((to_integer(slice1shift_search_0_2(12 downto 12)) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice1shift_search_0_2(14 downto 14)) = 1)
        /= slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice1shift_search_0_2(13 downto 13))
        = 1) /= slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_2_count_5 <= as_number(((to_integer(slice1shift_search_0_2(15 downto 15)) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice1shift_search_0_2(17 downto 17)) = 1)
        /= slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice1shift_search_0_2(16 downto 16))
        = 1) /= slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_2_count_6 <= as_number(((to_integer(slice1shift_search_0_2(18 downto 18)) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice1shift_search_0_2(20 downto 20)) = 1)
        /= slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice1shift_search_0_2(19 downto 19))
        = 1) /= slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_2_count_7 <= as_number(((to_integer(slice1shift_search_0_2(21 downto 21)) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice1shift_search_0_2(23 downto 23)) = 1)
        /= slice1cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice1shift_search_0_2(22 downto 22))
        = 1) /= slice1cost_pixels_first_0_0_count_7_value_3));
      slice1cost_pixels_first_0_2_count_8 <= as_number(((to_integer(slice1shift_search_0_2(24 downto 24)) = 1) /=
        slice1cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice1shift_search_0_2(26 downto 26)) = 1)
        /= slice1cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice1shift_search_0_2(25 downto 25))
        = 1) /= slice1cost_pixels_first_0_0_count_8_value_3));
      slice1cost_pixels_first_0_2_count_9 <= as_number(((to_integer(slice1shift_search_0_2(27 downto 27)) = 1) /=
        slice1cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice1shift_search_0_2(29 downto 29)) = 1)
        /= slice1cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice1shift_search_0_2(28 downto 28))
        = 1) /= slice1cost_pixels_first_0_0_count_9_value_3));
      slice1cost_pixels_first_0_2_count_10 <= as_number(((to_integer(slice1shift_search_0_2(30 downto 30)) = 1) /=
        slice1cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice1shift_search_0_2(32 downto 32)) =
        1) /= slice1cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice1shift_search_0_2(31 downto
        31)) = 1) /= slice1cost_pixels_first_0_0_count_10_value_3));
      slice1cost_pixels_first_0_2_count_11 <= as_number(((to_integer(slice1shift_search_0_2(33 downto 33)) = 1) /=
        slice1cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice1shift_search_0_2(35 downto 35)) =
        1) /= slice1cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice1shift_search_0_2(34 downto
        34)) = 1) /= slice1cost_pixels_first_0_0_count_11_value_3));
      slice1cost_pixels_first_0_2_count_12 <= as_number(((to_integer(slice1shift_search_0_2(36 downto 36)) = 1) /=
        slice1cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice1shift_search_0_2(38 downto 38)) =
        1) /= slice1cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice1shift_search_0_2(37 downto
        37)) = 1) /= slice1cost_pixels_first_0_0_count_12_value_3));
      slice1cost_pixels_first_0_2_count_13 <= as_number(((to_integer(slice1shift_search_0_2(39 downto 39)) = 1) /=
        slice1cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice1shift_search_0_2(41 downto 41)) =
        1) /= slice1cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice1shift_search_0_2(40 downto
        40)) = 1) /= slice1cost_pixels_first_0_0_count_13_value_3));
      slice1cost_pixels_first_0_2_count_14 <= as_number(((to_integer(slice1shift_search_0_2(43 downto 43)) = 1) /=
        (to_integer(slice1shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice1shift_search_0_2(42
        downto 42)) = 1) /= slice1cost_pixels_first_0_0_count_14_value));
      slice1cost_pixels_first_0_3_count_0 <= as_number(((to_integer(slice1shift_search_0_3(0 downto 0)) = 1) /=
        (to_integer(slice1shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice1shift_search_0_3(2
        downto 2)) = 1) /= slice1cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice1shift_search_0_3(1 downto 1)) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_3_count_1 <= as_number(((to_integer(slice1shift_search_0_3(3 downto 3)) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice1shift_search_0_3(5 downto 5)) = 1)
        /= slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice1shift_search_0_3(4 downto 4)) =
        1) /= slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_3_count_2 <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0_3(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice1shift_search_0_3(8 downto 8)) = 1) /= slice1cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice1shift_search_0_3(6 downto 6)) = 1) /=
        slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_3_count_3 <= as_number(((to_integer(slice1shift_search_0_3(9 downto 9)) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice1shift_search_0_3(11 downto 11)) = 1)
        /= slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice1shift_search_0_3(10 downto 10))
        = 1) /= slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_3_count_4 <= as_number(((to_integer(slice1shift_search_0_3(12 downto 12)) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice1shift_search_0_3(14 downto 14)) = 1)
        /= slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice1shift_search_0_3(13 downto 13))
        = 1) /= slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_3_count_5 <= as_number(((to_integer(slice1shift_search_0_3(15 downto 15)) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice1shift_search_0_3(17 downto 17)) = 1)
        /= slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice1shift_search_0_3(16 downto 16))
        = 1) /= slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_3_count_6 <= as_number(((to_integer(slice1shift_search_0_3(18 downto 18)) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice1shift_search_0_3(20 downto 20)) = 1)
        /= slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice1shift_search_0_3(19 downto 19))
        = 1) /= slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_3_count_7 <= as_number(((to_integer(slice1shift_search_0_3(21 downto 21)) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice1shift_search_0_3(23 downto 23)) = 1)
        /= slice1cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice1shift_search_0_3(22 downto 22))
        = 1) /= slice1cost_pixels_first_0_0_count_7_value_3));
      slice1cost_pixels_first_0_3_count_8 <= as_number(((to_integer(slice1shift_search_0_3(24 downto 24)) = 1) /=
        slice1cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice1shift_search_0_3(26 downto 26)) = 1)
        /= slice1cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice1shift_search_0_3(25 downto 25))
        = 1) /= slice1cost_pixels_first_0_0_count_8_value_3));
      slice1cost_pixels_first_0_3_count_9 <= as_number(((to_integer(slice1shift_search_0_3(27 downto 27)) = 1) /=
        slice1cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice1shift_search_0_3(29 downto 29)) = 1)
        /= slice1cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice1shift_search_0_3(28 downto 28))
        = 1) /= slice1cost_pixels_first_0_0_count_9_value_3));
      slice1cost_pixels_first_0_3_count_10 <= as_number(((to_integer(slice1shift_search_0_3(30 downto 30)) = 1) /=
        slice1cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice1shift_search_0_3(32 downto 32)) =
        1) /= slice1cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice1shift_search_0_3(31 downto
        31)) = 1) /= slice1cost_pixels_first_0_0_count_10_value_3));
      slice1cost_pixels_first_0_3_count_11 <= as_number(((to_integer(slice1shift_search_0_3(33 downto 33)) = 1) /=
        slice1cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice1shift_search_0_3(35 downto 35)) =
        1) /= slice1cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice1shift_search_0_3(34 downto
        34)) = 1) /= slice1cost_pixels_first_0_0_count_11_value_3));
      slice1cost_pixels_first_0_3_count_12 <= as_number(((to_integer(slice1shift_search_0_3(36 downto 36)) = 1) /=
        slice1cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice1shift_search_0_3(38 downto 38)) =
        1) /= slice1cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice1shift_search_0_3(37 downto
        37)) = 1) /= slice1cost_pixels_first_0_0_count_12_value_3));
      slice1cost_pixels_first_0_3_count_13 <= as_number(((to_integer(slice1shift_search_0_3(39 downto 39)) = 1) /=
        slice1cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice1shift_search_0_3(41 downto 41)) =
        1) /= slice1cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice1shift_search_0_3(40 downto
        40)) = 1) /= slice1cost_pixels_first_0_0_count_13_value_3));
      slice1cost_pixels_first_0_3_count_14 <= as_number(((to_integer(slice1shift_search_0_3(43 downto 43)) = 1) /=
        (to_integer(slice1shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice1shift_search_0_3(42
        downto 42)) = 1) /= slice1cost_pixels_first_0_0_count_14_value));
      slice1cost_pixels_first_0_4_count_0 <= as_number(((to_integer(slice1shift_search_0_4(0 downto 0)) = 1) /=
        (to_integer(slice1shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice1shift_search_0_4(2
        downto 2)) = 1) /= slice1cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice1shift_search_0_4(1 downto 1)) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_4_count_1 <= as_number(((to_integer(slice1shift_search_0_4(3 downto 3)) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice1shift_search_0_4(5 downto 5)) = 1)
        /= slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice1shift_search_0_4(4 downto 4)) =
        1) /= slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_4_count_2 <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0_4(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice1shift_search_0_4(8 downto 8)) = 1) /= slice1cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice1shift_search_0_4(6 downto 6)) = 1) /=
        slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_4_count_3 <= as_number(((to_integer(slice1shift_search_0_4(9 downto 9)) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice1shift_search_0_4(11 downto 11)) = 1)
        /= slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice1shift_search_0_4(10 downto 10))
        = 1) /= slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_4_count_4 <= as_number(((to_integer(slice1shift_search_0_4(12 downto 12)) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice1shift_search_0_4(14 downto 14)) = 1)
        /= slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice1shift_search_0_4(13 downto 13))
        = 1) /= slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_4_count_5 <= as_number(((to_integer(slice1shift_search_0_4(15 downto 15)) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice1shift_search_0_4(17 downto 17)) = 1)
        /= slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice1shift_search_0_4(16 downto 16))
        = 1) /= slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_4_count_6 <= as_number(((to_integer(slice1shift_search_0_4(18 downto 18)) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice1shift_search_0_4(20 downto 20)) = 1)
        /= slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice1shift_search_0_4(19 downto 19))
        = 1) /= slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_4_count_7 <= as_number(((to_integer(slice1shift_search_0_4(21 downto 21)) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice1shift_search_0_4(23 downto 23)) = 1)
        /= slice1cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice1shift_search_0_4(22 downto 22))
        = 1) /= slice1cost_pixels_first_0_0_count_7_value_3));
      slice1cost_pixels_first_0_4_count_8 <= as_number(((to_integer(slice1shift_search_0_4(24 downto 24)) = 1) /=
        slice1cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice1shift_search_0_4(26 downto 26)) = 1)
        /= slice1cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice1shift_search_0_4(25 downto 25))
        = 1) /= slice1cost_pixels_first_0_0_count_8_value_3));
      slice1cost_pixels_first_0_4_count_9 <= as_number(((to_integer(slice1shift_search_0_4(27 downto 27)) = 1) /=
        slice1cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice1shift_search_0_4(29 downto 29)) = 1)
        /= slice1cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice1shift_search_0_4(28 downto 28))
        = 1) /= slice1cost_pixels_first_0_0_count_9_value_3));
      slice1cost_pixels_first_0_4_count_10 <= as_number(((to_integer(slice1shift_search_0_4(30 downto 30)) = 1) /=
        slice1cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice1shift_search_0_4(32 downto 32)) =
        1) /= slice1cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice1shift_search_0_4(31 downto
        31)) = 1) /= slice1cost_pixels_first_0_0_count_10_value_3));
      slice1cost_pixels_first_0_4_count_11 <= as_number(((to_integer(slice1shift_search_0_4(33 downto 33)) = 1) /=
        slice1cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice1shift_search_0_4(35 downto 35)) =
        1) /= slice1cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice1shift_search_0_4(34 downto
        34)) = 1) /= slice1cost_pixels_first_0_0_count_11_value_3));
      slice1cost_pixels_first_0_4_count_12 <= as_number(((to_integer(slice1shift_search_0_4(36 downto 36)) = 1) /=
        slice1cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice1shift_search_0_4(38 downto 38)) =
        1) /= slice1cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice1shift_search_0_4(37 downto
        37)) = 1) /= slice1cost_pixels_first_0_0_count_12_value_3));
      slice1cost_pixels_first_0_4_count_13 <= as_number(((to_integer(slice1shift_search_0_4(39 downto 39)) = 1) /=
        slice1cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice1shift_search_0_4(41 downto 41)) =
        1) /= slice1cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice1shift_search_0_4(40 downto
        40)) = 1) /= slice1cost_pixels_first_0_0_count_13_value_3));
      slice1cost_pixels_first_0_4_count_14 <= as_number(((to_integer(slice1shift_search_0_4(43 downto 43)) = 1) /=
        (to_integer(slice1shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice1shift_search_0_4(42
        downto 42)) = 1) /= slice1cost_pixels_first_0_0_count_14_value));
      slice1cost_pixels_cost_0_0 <= slice1cost_pixels_first_0_0_count_3 + slice1cost_pixels_first_0_0_count_7 +
        slice1cost_pixels_first_0_0_count_12 + slice1cost_pixels_first_0_0_count_6 +
        slice1cost_pixels_first_0_0_count_9 + slice1cost_pixels_first_0_0_count_14 +
        slice1cost_pixels_first_0_0_count_11 + slice1cost_pixels_first_0_0_count_2 +
        slice1cost_pixels_first_0_0_count_10 + slice1cost_pixels_first_0_0_count_4 +
        slice1cost_pixels_first_0_0_count_8 + slice1cost_pixels_first_0_0_count_1 + slice1cost_pixels_first_0_0_count_5
        + slice1cost_pixels_first_0_0_count_0 + slice1cost_pixels_first_0_0_count_13;
      slice1cost_pixels_cost_0_1 <= slice1cost_pixels_first_0_1_count_3 + slice1cost_pixels_first_0_1_count_7 +
        slice1cost_pixels_first_0_1_count_12 + slice1cost_pixels_first_0_1_count_6 +
        slice1cost_pixels_first_0_1_count_9 + slice1cost_pixels_first_0_1_count_14 +
        slice1cost_pixels_first_0_1_count_11 + slice1cost_pixels_first_0_1_count_2 +
        slice1cost_pixels_first_0_1_count_10 + slice1cost_pixels_first_0_1_count_4 +
        slice1cost_pixels_first_0_1_count_8 + slice1cost_pixels_first_0_1_count_1 + slice1cost_pixels_first_0_1_count_5
        + slice1cost_pixels_first_0_1_count_0 + slice1cost_pixels_first_0_1_count_13;
      slice1cost_pixels_cost_0_2 <= slice1cost_pixels_first_0_2_count_3 + slice1cost_pixels_first_0_2_count_7 +
        slice1cost_pixels_first_0_2_count_12 + slice1cost_pixels_first_0_2_count_6 +
        slice1cost_pixels_first_0_2_count_9 + slice1cost_pixels_first_0_2_count_14 +
        slice1cost_pixels_first_0_2_count_11 + slice1cost_pixels_first_0_2_count_2 +
        slice1cost_pixels_first_0_2_count_10 + slice1cost_pixels_first_0_2_count_4 +
        slice1cost_pixels_first_0_2_count_8 + slice1cost_pixels_first_0_2_count_1 + slice1cost_pixels_first_0_2_count_5
        + slice1cost_pixels_first_0_2_count_0 + slice1cost_pixels_first_0_2_count_13;
      slice1cost_pixels_cost_0_3 <= slice1cost_pixels_first_0_3_count_3 + slice1cost_pixels_first_0_3_count_7 +
        slice1cost_pixels_first_0_3_count_12 + slice1cost_pixels_first_0_3_count_6 +
        slice1cost_pixels_first_0_3_count_9 + slice1cost_pixels_first_0_3_count_14 +
        slice1cost_pixels_first_0_3_count_11 + slice1cost_pixels_first_0_3_count_2 +
        slice1cost_pixels_first_0_3_count_10 + slice1cost_pixels_first_0_3_count_4 +
        slice1cost_pixels_first_0_3_count_8 + slice1cost_pixels_first_0_3_count_1 + slice1cost_pixels_first_0_3_count_5
        + slice1cost_pixels_first_0_3_count_0 + slice1cost_pixels_first_0_3_count_13;
      slice1cost_pixels_cost_0_4 <= slice1cost_pixels_first_0_4_count_3 + slice1cost_pixels_first_0_4_count_7 +
        slice1cost_pixels_first_0_4_count_12 + slice1cost_pixels_first_0_4_count_6 +
        slice1cost_pixels_first_0_4_count_9 + slice1cost_pixels_first_0_4_count_14 +
        slice1cost_pixels_first_0_4_count_11 + slice1cost_pixels_first_0_4_count_2 +
        slice1cost_pixels_first_0_4_count_10 + slice1cost_pixels_first_0_4_count_4 +
        slice1cost_pixels_first_0_4_count_8 + slice1cost_pixels_first_0_4_count_1 + slice1cost_pixels_first_0_4_count_5
        + slice1cost_pixels_first_0_4_count_0 + slice1cost_pixels_first_0_4_count_13;
      slice1cost_single_0_0 <= slice1cost_pixels_cost_0_0;
      slice1cost_single_0_1 <= slice1cost_pixels_cost_0_1;
      slice1cost_single_0_2 <= slice1cost_pixels_cost_0_2;
      slice1cost_single_0_3 <= slice1cost_pixels_cost_0_3;
      slice1cost_single_0_4 <= slice1cost_pixels_cost_0_4;
      -- slice1
      slice1_held_0_0 <= other_12 / 4;
      slice1_held_0_1 <= other_10 / 4;
      slice1_held_0_2 <= other_8 / 4;
      slice1_held_0_3 <= other_6 / 4;
      slice1_held_0_4 <= other_4 / 4;
      slice1_held_1_0 <= slice1_held_0_0;
      slice1_held_1_1 <= slice1_held_0_1;
      slice1_held_1_2 <= slice1_held_0_2;
      slice1_held_1_3 <= slice1_held_0_3;
      slice1_held_1_4 <= slice1_held_0_4;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice1shift_search_out_0;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      -- slice2cost
      slice2cost_pixels_first_0_0_count_0_value := to_integer(slice2shift_reference_0(2 downto 2)) = 1;
      slice2cost_pixels_first_0_0_count_0_value_2 := to_integer(slice2shift_reference_0(1 downto 1)) = 1;
      slice2cost_pixels_first_0_0_count_1_value := to_integer(slice2shift_reference_0(3 downto 3)) = 1;
      slice2cost_pixels_first_0_0_count_1_value_2 := to_integer(slice2shift_reference_0(5 downto 5)) = 1;
      slice2cost_pixels_first_0_0_count_1_value_3 := to_integer(slice2shift_reference_0(4 downto 4)) = 1;
      slice2cost_pixels_first_0_0_count_2_value := to_integer(slice2shift_reference_0(8 downto 8)) = 1;
      slice2cost_pixels_first_0_0_count_2_value_2 := to_integer(slice2shift_reference_0(6 downto 6)) = 1;
      slice2cost_pixels_first_0_0_count_3_value := to_integer(slice2shift_reference_0(9 downto 9)) = 1;
      slice2cost_pixels_first_0_0_count_3_value_2 := to_integer(slice2shift_reference_0(11 downto 11)) = 1;
      slice2cost_pixels_first_0_0_count_3_value_3 := to_integer(slice2shift_reference_0(10 downto 10)) = 1;
      slice2cost_pixels_first_0_0_count_4_value := to_integer(slice2shift_reference_0(12 downto 12)) = 1;
      slice2cost_pixels_first_0_0_count_4_value_2 := to_integer(slice2shift_reference_0(14 downto 14)) = 1;
      slice2cost_pixels_first_0_0_count_4_value_3 := to_integer(slice2shift_reference_0(13 downto 13)) = 1;
      slice2cost_pixels_first_0_0_count_5_value := to_integer(slice2shift_reference_0(15 downto 15)) = 1;
      slice2cost_pixels_first_0_0_count_5_value_2 := to_integer(slice2shift_reference_0(17 downto 17)) = 1;
      slice2cost_pixels_first_0_0_count_5_value_3 := to_integer(slice2shift_reference_0(16 downto 16)) = 1;
      slice2cost_pixels_first_0_0_count_6_value := to_integer(slice2shift_reference_0(18 downto 18)) = 1;
      slice2cost_pixels_first_0_0_count_6_value_2 := to_integer(slice2shift_reference_0(20 downto 20)) = 1;
      slice2cost_pixels_first_0_0_count_6_value_3 := to_integer(slice2shift_reference_0(19 downto 19)) = 1;
      slice2cost_pixels_first_0_0_count_7_value := to_integer(slice2shift_reference_0(21 downto 21)) = 1;
      slice2cost_pixels_first_0_0_count_7_value_2 := to_integer(slice2shift_reference_0(23 downto 23)) = 1;
      slice2cost_pixels_first_0_0_count_7_value_3 := to_integer(slice2shift_reference_0(22 downto 22)) = 1;
      slice2cost_pixels_first_0_0_count_8_value := to_integer(slice2shift_reference_0(24 downto 24)) = 1;
      slice2cost_pixels_first_0_0_count_8_value_2 := to_integer(slice2shift_reference_0(26 downto 26)) = 1;
      slice2cost_pixels_first_0_0_count_8_value_3 := to_integer(slice2shift_reference_0(25 downto 25)) = 1;
      slice2cost_pixels_first_0_0_count_9_value := to_integer(slice2shift_reference_0(27 downto 27)) = 1;
      slice2cost_pixels_first_0_0_count_9_value_2 := to_integer(slice2shift_reference_0(29 downto 29)) = 1;
      slice2cost_pixels_first_0_0_count_9_value_3 := to_integer(slice2shift_reference_0(28 downto 28)) = 1;
      slice2cost_pixels_first_0_0_count_10_value := to_integer(slice2shift_reference_0(30 downto 30)) = 1;
      slice2cost_pixels_first_0_0_count_10_value_2 := to_integer(slice2shift_reference_0(32 downto 32)) = 1;
      slice2cost_pixels_first_0_0_count_10_value_3 := to_integer(slice2shift_reference_0(31 downto 31)) = 1;
      slice2cost_pixels_first_0_0_count_11_value := to_integer(slice2shift_reference_0(33 downto 33)) = 1;
      slice2cost_pixels_first_0_0_count_11_value_2 := to_integer(slice2shift_reference_0(35 downto 35)) = 1;
      slice2cost_pixels_first_0_0_count_11_value_3 := to_integer(slice2shift_reference_0(34 downto 34)) = 1;
      slice2cost_pixels_first_0_0_count_12_value := to_integer(slice2shift_reference_0(36 downto 36)) = 1;
      slice2cost_pixels_first_0_0_count_12_value_2 := to_integer(slice2shift_reference_0(38 downto 38)) = 1;
      slice2cost_pixels_first_0_0_count_12_value_3 := to_integer(slice2shift_reference_0(37 downto 37)) = 1;
      slice2cost_pixels_first_0_0_count_13_value := to_integer(slice2shift_reference_0(39 downto 39)) = 1;
      slice2cost_pixels_first_0_0_count_13_value_2 := to_integer(slice2shift_reference_0(41 downto 41)) = 1;
      slice2cost_pixels_first_0_0_count_13_value_3 := to_integer(slice2shift_reference_0(40 downto 40)) = 1;
      slice2cost_pixels_first_0_0_count_14_value := to_integer(slice2shift_reference_0(42 downto 42)) = 1;
      slice2cost_pixels_first_0_0_count_0 <= as_number(((to_integer(slice2shift_search_0_0(0 downto 0)) = 1) /=
        (to_integer(slice2shift_reference_0(0 downto 0)) = 1))) + as_number((slice2cost_pixels_first_0_0_count_0_value
        /= (to_integer(slice2shift_search_0_0(2 downto 2)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_0_value_2 /= (to_integer(slice2shift_search_0_0(1 downto 1)) =
        1)));
      slice2cost_pixels_first_0_0_count_1 <= as_number((slice2cost_pixels_first_0_0_count_1_value /=
        (to_integer(slice2shift_search_0_0(3 downto 3)) = 1))) + as_number((slice2cost_pixels_first_0_0_count_1_value_2
        /= (to_integer(slice2shift_search_0_0(5 downto 5)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_1_value_3 /= (to_integer(slice2shift_search_0_0(4 downto 4)) =
        1)));
      slice2cost_pixels_first_0_0_count_2 <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0_0(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice2cost_pixels_first_0_0_count_2_value /= (to_integer(slice2shift_search_0_0(8 downto 8)) = 1)))
        + as_number((slice2cost_pixels_first_0_0_count_2_value_2 /= (to_integer(slice2shift_search_0_0(6 downto 6)) =
        1)));
      slice2cost_pixels_first_0_0_count_3 <= as_number((slice2cost_pixels_first_0_0_count_3_value /=
        (to_integer(slice2shift_search_0_0(9 downto 9)) = 1))) + as_number((slice2cost_pixels_first_0_0_count_3_value_2
        /= (to_integer(slice2shift_search_0_0(11 downto 11)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_3_value_3 /= (to_integer(slice2shift_search_0_0(10 downto 10)) =
        1)));
      slice2cost_pixels_first_0_0_count_4 <= as_number((slice2cost_pixels_first_0_0_count_4_value /=
        (to_integer(slice2shift_search_0_0(12 downto 12)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_4_value_2 /= (to_integer(slice2shift_search_0_0(14 downto 14)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_4_value_3 /= (to_integer(slice2shift_search_0_0(13 downto
        13)) = 1)));
      slice2cost_pixels_first_0_0_count_5 <= as_number((slice2cost_pixels_first_0_0_count_5_value /=
        (to_integer(slice2shift_search_0_0(15 downto 15)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_5_value_2 /= (to_integer(slice2shift_search_0_0(17 downto 17)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_5_value_3 /= (to_integer(slice2shift_search_0_0(16 downto
        16)) = 1)));
      slice2cost_pixels_first_0_0_count_6 <= as_number((slice2cost_pixels_first_0_0_count_6_value /=
        (to_integer(slice2shift_search_0_0(18 downto 18)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_6_value_2 /= (to_integer(slice2shift_search_0_0(20 downto 20)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_6_value_3 /= (to_integer(slice2shift_search_0_0(19 downto
        19)) = 1)));
      slice2cost_pixels_first_0_0_count_7 <= as_number((slice2cost_pixels_first_0_0_count_7_value /=
        (to_integer(slice2shift_search_0_0(21 downto 21)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_7_value_2 /= (to_integer(slice2shift_search_0_0(23 downto 23)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_7_value_3 /= (to_integer(slice2shift_search_0_0(22 downto
        22)) = 1)));
      slice2cost_pixels_first_0_0_count_8 <= as_number((slice2cost_pixels_first_0_0_count_8_value /=
        (to_integer(slice2shift_search_0_0(24 downto 24)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_8_value_2 /= (to_integer(slice2shift_search_0_0(26 downto 26)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_8_value_3 /= (to_integer(slice2shift_search_0_0(25 downto
        25)) = 1)));
      slice2cost_pixels_first_0_0_count_9 <= as_number((slice2cost_pixels_first_0_0_count_9_value /=
        (to_integer(slice2shift_search_0_0(27 downto 27)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_9_value_2 /= (to_integer(slice2shift_search_0_0(29 downto 29)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_9_value_3 /= (to_integer(slice2shift_search_0_0(28 downto
        28)) = 1)));
      slice2cost_pixels_first_0_0_count_10 <= as_number((slice2cost_pixels_first_0_0_count_10_value /=
        (to_integer(slice2shift_search_0_0(30 downto 30)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_10_value_2 /= (to_integer(slice2shift_search_0_0(32 downto 32)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_10_value_3 /= (to_integer(slice2shift_search_0_0(31 downto
        31)) = 1)));
      slice2cost_pixels_first_0_0_count_11 <= as_number((slice2cost_pixels_first_0_0_count_11_value /=
        (to_integer(slice2shift_search_0_0(33 downto 33)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_11_value_2 /= (to_integer(slice2shift_search_0_0(35 downto 35)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_11_value_3 /= (to_integer(slice2shift_search_0_0(34 downto
        34)) = 1)));
      slice2cost_pixels_first_0_0_count_12 <= as_number((slice2cost_pixels_first_0_0_count_12_value /=
        (to_integer(slice2shift_search_0_0(36 downto 36)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_12_value_2 /= (to_integer(slice2shift_search_0_0(38 downto 38)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_12_value_3 /= (to_integer(slice2shift_search_0_0(37 downto
        37)) = 1)));
      slice2cost_pixels_first_0_0_count_13 <= as_number((slice2cost_pixels_first_0_0_count_13_value /=
        (to_integer(slice2shift_search_0_0(39 downto 39)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_13_value_2 /= (to_integer(slice2shift_search_0_0(41 downto 41)) =
        1))) + as_number((slice2cost_pixels_first_0_0_count_13_value_3 /= (to_integer(slice2shift_search_0_0(40 downto
        40)) = 1)));
      slice2cost_pixels_first_0_0_count_14 <= as_number(((to_integer(slice2shift_reference_0(43 downto 43)) = 1) /=
        (to_integer(slice2shift_search_0_0(43 downto 43)) = 1))) +
        as_number((slice2cost_pixels_first_0_0_count_14_value /= (to_integer(slice2shift_search_0_0(42 downto 42)) =
        1)));
      slice2cost_pixels_first_0_1_count_0 <= as_number(((to_integer(slice2shift_search_0_1(0 downto 0)) = 1) /=
        (to_integer(slice2shift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(slice2shift_search_0_1(2
        downto 2)) = 1) /= slice2cost_pixels_first_0_0_count_0_value)) +
        as_number(((to_integer(slice2shift_search_0_1(1 downto 1)) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_1_count_1 <= as_number(((to_integer(slice2shift_search_0_1(3 downto 3)) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((to_integer(slice2shift_search_0_1(5 downto 5)) = 1)
        /= slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((to_integer(slice2shift_search_0_1(4 downto 4)) =
        1) /= slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_1_count_2 <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0_1(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice2shift_search_0_1(8 downto 8)) = 1) /= slice2cost_pixels_first_0_0_count_2_value))
        + as_number(((to_integer(slice2shift_search_0_1(6 downto 6)) = 1) /=
        slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_1_count_3 <= as_number(((to_integer(slice2shift_search_0_1(9 downto 9)) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((to_integer(slice2shift_search_0_1(11 downto 11)) = 1)
        /= slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((to_integer(slice2shift_search_0_1(10 downto 10))
        = 1) /= slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_1_count_4 <= as_number(((to_integer(slice2shift_search_0_1(12 downto 12)) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((to_integer(slice2shift_search_0_1(14 downto 14)) = 1)
        /= slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((to_integer(slice2shift_search_0_1(13 downto 13))
        = 1) /= slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_1_count_5 <= as_number(((to_integer(slice2shift_search_0_1(15 downto 15)) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((to_integer(slice2shift_search_0_1(17 downto 17)) = 1)
        /= slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((to_integer(slice2shift_search_0_1(16 downto 16))
        = 1) /= slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_1_count_6 <= as_number(((to_integer(slice2shift_search_0_1(18 downto 18)) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((to_integer(slice2shift_search_0_1(20 downto 20)) = 1)
        /= slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((to_integer(slice2shift_search_0_1(19 downto 19))
        = 1) /= slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_1_count_7 <= as_number(((to_integer(slice2shift_search_0_1(21 downto 21)) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number(((to_integer(slice2shift_search_0_1(23 downto 23)) = 1)
        /= slice2cost_pixels_first_0_0_count_7_value_2)) + as_number(((to_integer(slice2shift_search_0_1(22 downto 22))
        = 1) /= slice2cost_pixels_first_0_0_count_7_value_3));
      slice2cost_pixels_first_0_1_count_8 <= as_number(((to_integer(slice2shift_search_0_1(24 downto 24)) = 1) /=
        slice2cost_pixels_first_0_0_count_8_value)) + as_number(((to_integer(slice2shift_search_0_1(26 downto 26)) = 1)
        /= slice2cost_pixels_first_0_0_count_8_value_2)) + as_number(((to_integer(slice2shift_search_0_1(25 downto 25))
        = 1) /= slice2cost_pixels_first_0_0_count_8_value_3));
      slice2cost_pixels_first_0_1_count_9 <= as_number(((to_integer(slice2shift_search_0_1(27 downto 27)) = 1) /=
        slice2cost_pixels_first_0_0_count_9_value)) + as_number(((to_integer(slice2shift_search_0_1(29 downto 29)) = 1)
        /= slice2cost_pixels_first_0_0_count_9_value_2)) + as_number(((to_integer(slice2shift_search_0_1(28 downto 28))
        = 1) /= slice2cost_pixels_first_0_0_count_9_value_3));
      slice2cost_pixels_first_0_1_count_10 <= as_number(((to_integer(slice2shift_search_0_1(30 downto 30)) = 1) /=
        slice2cost_pixels_first_0_0_count_10_value)) + as_number(((to_integer(slice2shift_search_0_1(32 downto 32)) =
        1) /= slice2cost_pixels_first_0_0_count_10_value_2)) + as_number(((to_integer(slice2shift_search_0_1(31 downto
        31)) = 1) /= slice2cost_pixels_first_0_0_count_10_value_3));
      slice2cost_pixels_first_0_1_count_11 <= as_number(((to_integer(slice2shift_search_0_1(33 downto 33)) = 1) /=
        slice2cost_pixels_first_0_0_count_11_value)) + as_number(((to_integer(slice2shift_search_0_1(35 downto 35)) =
        1) /= slice2cost_pixels_first_0_0_count_11_value_2)) + as_number(((to_integer(slice2shift_search_0_1(34 downto
        34)) = 1) /= slice2cost_pixels_first_0_0_count_11_value_3));
      slice2cost_pixels_first_0_1_count_12 <= as_number(((to_integer(slice2shift_search_0_1(36 downto 36)) = 1) /=
        slice2cost_pixels_first_0_0_count_12_value)) + as_number(((to_integer(slice2shift_search_0_1(38 downto 38)) =
        1) /= slice2cost_pixels_first_0_0_count_12_value_2)) + as_number(((to_integer(slice2shift_search_0_1(37 downto
        37)) = 1) /= slice2cost_pixels_first_0_0_count_12_value_3));
      slice2cost_pixels_first_0_1_count_13 <= as_number(((to_integer(slice2shift_search_0_1(39 downto 39)) = 1) /=
        slice2cost_pixels_first_0_0_count_13_value)) + as_number(((to_integer(slice2shift_search_0_1(41 downto 41)) =
        1) /= slice2cost_pixels_first_0_0_count_13_value_2)) + as_number(((to_integer(slice2shift_search_0_1(40 downto
        40)) = 1) /= slice2cost_pixels_first_0_0_count_13_value_3));
      slice2cost_pixels_first_0_1_count_14 <= as_number(((to_integer(slice2shift_search_0_1(43 downto 43)) = 1) /=
        (to_integer(slice2shift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(slice2shift_search_0_1(42
        downto 42)) = 1) /= slice2cost_pixels_first_0_0_count_14_value));
      slice2cost_pixels_cost_0_0 <= slice2cost_pixels_first_0_0_count_3 + slice2cost_pixels_first_0_0_count_7 +
        slice2cost_pixels_first_0_0_count_12 + slice2cost_pixels_first_0_0_count_6 +
        slice2cost_pixels_first_0_0_count_9 + slice2cost_pixels_first_0_0_count_14 +
        slice2cost_pixels_first_0_0_count_11 + slice2cost_pixels_first_0_0_count_2 +
        slice2cost_pixels_first_0_0_count_10 + slice2cost_pixels_first_0_0_count_4 +
        slice2cost_pixels_first_0_0_count_8 + slice2cost_pixels_first_0_0_count_1 + slice2cost_pixels_first_0_0_count_5
        + slice2cost_pixels_first_0_0_count_0 + slice2cost_pixels_first_0_0_count_13;
      slice2cost_pixels_cost_0_1 <= slice2cost_pixels_first_0_1_count_3 + slice2cost_pixels_first_0_1_count_7 +
        slice2cost_pixels_first_0_1_count_12 + slice2cost_pixels_first_0_1_count_6 +
        slice2cost_pixels_first_0_1_count_9 + slice2cost_pixels_first_0_1_count_14 +
        slice2cost_pixels_first_0_1_count_11 + slice2cost_pixels_first_0_1_count_2 +
        slice2cost_pixels_first_0_1_count_10 + slice2cost_pixels_first_0_1_count_4 +
        slice2cost_pixels_first_0_1_count_8 + slice2cost_pixels_first_0_1_count_1 + slice2cost_pixels_first_0_1_count_5
        + slice2cost_pixels_first_0_1_count_0 + slice2cost_pixels_first_0_1_count_13;
      slice2cost_single_0_0 <= slice2cost_pixels_cost_0_0;
      slice2cost_single_0_1 <= slice2cost_pixels_cost_0_1;
      -- slice2
      slice2_held_0_0 <= other_2 / 4;
      slice2_held_0_1 <= other_0 / 4;
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
      entry_next_tag_first_cost <= slice0_tag_2_first_cost;
      entry_next_tag_map_column <= slice0_tag_2_map_column;
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
      entry_tag_first_cost <= entry_next_tag_first_cost;
      entry_tag_map_column <= entry_next_tag_map_column;
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
        if slice0_tag_2_first_cost then
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
      forward_left_start_cost_0_value := (((forward_left_tree_next_next_smallest_0 mod 32) + forward_left_room) / 32) =
        1;
      if forward_left_start_cost_0_value then
        forward_left_start_cost_0_choice := (((as_number(forward_left_start_cost_0_value) + 7) mod 8) * 32) +
          ((forward_left_tree_next_next_smallest_0 + forward_left_room) mod 32);
      else
        forward_left_start_cost_0_choice := 0;
      end if;
      if (forward_left_tree_next_next_smallest_0 / 32) = 1 then
        forward_left_start_cost_0_choice_2 := forward_left_room;
      else
        forward_left_start_cost_0_choice_2 := forward_left_start_cost_0_choice;
      end if;
      if forward_left_start_cost_0_value then
        forward_left_room_choice := (0 - forward_left_tree_next_next_smallest_0) mod 32;
      else
        forward_left_room_choice := forward_left_room;
      end if;
      if (forward_left_tree_next_next_smallest_0 / 32) = 1 then
        forward_left_room_choice_2 := 0;
      else
        forward_left_room_choice_2 := forward_left_room_choice;
      end if;
      if (forward_left_arrived_0 - forward_left_cost_0) < 0 then
        forward_left_cost_0_choice := forward_left_arrived_0;
      else
        forward_left_cost_0_choice := forward_left_cost_0;
      end if;
      if ((forward_left_cost_0_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_0_choice_2 := 32;
      else
        forward_left_cost_0_choice_2 := forward_left_cost_0_choice;
      end if;
      if (forward_left_arrived_1 - forward_left_cost_1) < 0 then
        forward_left_cost_1_choice := forward_left_arrived_1;
      else
        forward_left_cost_1_choice := forward_left_cost_1;
      end if;
      if ((forward_left_cost_1_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_1_choice_2 := 32;
      else
        forward_left_cost_1_choice_2 := forward_left_cost_1_choice;
      end if;
      if (forward_left_arrived_2 - forward_left_cost_2) < 0 then
        forward_left_cost_2_choice := forward_left_arrived_2;
      else
        forward_left_cost_2_choice := forward_left_cost_2;
      end if;
      if ((forward_left_cost_2_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_2_choice_2 := 32;
      else
        forward_left_cost_2_choice_2 := forward_left_cost_2_choice;
      end if;
      if (forward_left_arrived_3 - forward_left_cost_3) < 0 then
        forward_left_cost_3_choice := forward_left_arrived_3;
      else
        forward_left_cost_3_choice := forward_left_cost_3;
      end if;
      if ((forward_left_cost_3_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_3_choice_2 := 32;
      else
        forward_left_cost_3_choice_2 := forward_left_cost_3_choice;
      end if;
      if (forward_left_arrived_4 - forward_left_cost_4) < 0 then
        forward_left_cost_4_choice := forward_left_arrived_4;
      else
        forward_left_cost_4_choice := forward_left_cost_4;
      end if;
      if ((forward_left_cost_4_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_4_choice_2 := 32;
      else
        forward_left_cost_4_choice_2 := forward_left_cost_4_choice;
      end if;
      if (forward_left_arrived_5 - forward_left_cost_5) < 0 then
        forward_left_cost_5_choice := forward_left_arrived_5;
      else
        forward_left_cost_5_choice := forward_left_cost_5;
      end if;
      if ((forward_left_cost_5_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_5_choice_2 := 32;
      else
        forward_left_cost_5_choice_2 := forward_left_cost_5_choice;
      end if;
      if (forward_left_arrived_6 - forward_left_cost_6) < 0 then
        forward_left_cost_6_choice := forward_left_arrived_6;
      else
        forward_left_cost_6_choice := forward_left_cost_6;
      end if;
      if ((forward_left_cost_6_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_6_choice_2 := 32;
      else
        forward_left_cost_6_choice_2 := forward_left_cost_6_choice;
      end if;
      if (forward_left_arrived_7 - forward_left_cost_7) < 0 then
        forward_left_cost_7_choice := forward_left_arrived_7;
      else
        forward_left_cost_7_choice := forward_left_cost_7;
      end if;
      if ((forward_left_cost_7_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_7_choice_2 := 32;
      else
        forward_left_cost_7_choice_2 := forward_left_cost_7_choice;
      end if;
      if (forward_left_arrived_8 - forward_left_cost_8) < 0 then
        forward_left_cost_8_choice := forward_left_arrived_8;
      else
        forward_left_cost_8_choice := forward_left_cost_8;
      end if;
      if ((forward_left_cost_8_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_8_choice_2 := 32;
      else
        forward_left_cost_8_choice_2 := forward_left_cost_8_choice;
      end if;
      if (forward_left_arrived_9 - forward_left_cost_9) < 0 then
        forward_left_cost_9_choice := forward_left_arrived_9;
      else
        forward_left_cost_9_choice := forward_left_cost_9;
      end if;
      if ((forward_left_cost_9_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_9_choice_2 := 32;
      else
        forward_left_cost_9_choice_2 := forward_left_cost_9_choice;
      end if;
      if (forward_left_arrived_10 - forward_left_cost_10) < 0 then
        forward_left_cost_10_choice := forward_left_arrived_10;
      else
        forward_left_cost_10_choice := forward_left_cost_10;
      end if;
      if ((forward_left_cost_10_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_10_choice_2 := 32;
      else
        forward_left_cost_10_choice_2 := forward_left_cost_10_choice;
      end if;
      if (forward_left_arrived_11 - forward_left_cost_11) < 0 then
        forward_left_cost_11_choice := forward_left_arrived_11;
      else
        forward_left_cost_11_choice := forward_left_cost_11;
      end if;
      if ((forward_left_cost_11_choice / 32) = 1) or forward_left_first_2 then
        forward_left_cost_11_choice_2 := 32;
      else
        forward_left_cost_11_choice_2 := forward_left_cost_11_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_0_choice := 32;
      else
        forward_left_arrived_0_choice := forward_left_cost_1;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_1_choice := 32;
      else
        forward_left_arrived_1_choice := forward_left_pair_0_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_2_choice := 32;
      else
        forward_left_arrived_2_choice := forward_left_pair_1_choice;
      end if;
      if (forward_left_cost_4 - forward_left_cost_2) < 0 then
        forward_left_arrived_3_choice := forward_left_cost_4;
      else
        forward_left_arrived_3_choice := forward_left_cost_2;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_3_choice_2 := 32;
      else
        forward_left_arrived_3_choice_2 := forward_left_arrived_3_choice;
      end if;
      if (forward_left_cost_5 - forward_left_cost_3) < 0 then
        forward_left_arrived_4_choice := forward_left_cost_5;
      else
        forward_left_arrived_4_choice := forward_left_cost_3;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_4_choice_2 := 32;
      else
        forward_left_arrived_4_choice_2 := forward_left_arrived_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_5_choice := 32;
      else
        forward_left_arrived_5_choice := forward_left_pair_2_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_6_choice := 32;
      else
        forward_left_arrived_6_choice := forward_left_pair_3_choice;
      end if;
      if (forward_left_cost_8 - forward_left_cost_6) < 0 then
        forward_left_arrived_7_choice := forward_left_cost_8;
      else
        forward_left_arrived_7_choice := forward_left_cost_6;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_7_choice_2 := 32;
      else
        forward_left_arrived_7_choice_2 := forward_left_arrived_7_choice;
      end if;
      if (forward_left_cost_9 - forward_left_cost_7) < 0 then
        forward_left_arrived_8_choice := forward_left_cost_9;
      else
        forward_left_arrived_8_choice := forward_left_cost_7;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_8_choice_2 := 32;
      else
        forward_left_arrived_8_choice_2 := forward_left_arrived_8_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_9_choice := 32;
      else
        forward_left_arrived_9_choice := forward_left_pair_4_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_10_choice := 32;
      else
        forward_left_arrived_10_choice := forward_left_pair_5_choice;
      end if;
      if forward_left_first_2 then
        forward_left_arrived_11_choice := 32;
      else
        forward_left_arrived_11_choice := forward_left_cost_10;
      end if;
      if forward_above_ready_top then
        forward_above_total_0_choice := 24;
      else
        forward_above_total_0_choice := to_integer(forward_above_ready_words_0(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_1_choice := 24;
      else
        forward_above_total_1_choice := to_integer(forward_above_ready_words_0(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_2_choice := 24;
      else
        forward_above_total_2_choice := to_integer(forward_above_ready_words_0(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_3_choice := 24;
      else
        forward_above_total_3_choice := to_integer(forward_above_ready_words_0(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_4_choice := 24;
      else
        forward_above_total_4_choice := to_integer(forward_above_ready_words_0(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_5_choice := 24;
      else
        forward_above_total_5_choice := to_integer(forward_above_ready_words_0(29 downto 25));
      end if;
      if forward_above_ready_top then
        forward_above_total_6_choice := 24;
      else
        forward_above_total_6_choice := to_integer(forward_above_ready_words_1(4 downto 0));
      end if;
      if forward_above_ready_top then
        forward_above_total_7_choice := 24;
      else
        forward_above_total_7_choice := to_integer(forward_above_ready_words_1(9 downto 5));
      end if;
      if forward_above_ready_top then
        forward_above_total_8_choice := 24;
      else
        forward_above_total_8_choice := to_integer(forward_above_ready_words_1(14 downto 10));
      end if;
      if forward_above_ready_top then
        forward_above_total_9_choice := 24;
      else
        forward_above_total_9_choice := to_integer(forward_above_ready_words_1(19 downto 15));
      end if;
      if forward_above_ready_top then
        forward_above_total_10_choice := 24;
      else
        forward_above_total_10_choice := to_integer(forward_above_ready_words_1(24 downto 20));
      end if;
      if forward_above_ready_top then
        forward_above_total_11_choice := 24;
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
        forward_left_smallest_less <= ((((forward_smallest_next_next_next_smallest_0 / 4) + 15) mod 16) * 4) +
          (forward_smallest_next_next_next_smallest_0 mod 4);
        forward_left_first_0 <= sums_right_first_2;
        forward_left_first_1 <= forward_left_first_0;
        forward_left_first_2 <= forward_left_first_1;
        forward_left_g_copy_0 <= (forward_left_start_cost_0 + forward_smallest_cost_0) mod 64;
        forward_left_g_less_copy_0 <= (forward_left_start_cost_0 + forward_left_smallest_less) mod 64;
        forward_left_stay_change_0 <= (forward_cost_0_0 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_1 <= (forward_cost_0_1 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_2 <= (forward_cost_0_2 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_3 <= (forward_cost_0_3 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_4 <= (forward_cost_0_4 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_5 <= (forward_cost_0_5 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_6 <= (forward_cost_0_6 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_7 <= (forward_cost_0_7 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_8 <= (forward_cost_0_8 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_9 <= (forward_cost_0_9 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_10 <= (forward_cost_0_10 - forward_left_g_copy_0) mod 64;
        forward_left_stay_change_11 <= (forward_cost_0_11 - forward_left_g_copy_0) mod 64;
        forward_left_step_change_0 <= (forward_cost_0_0 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_1 <= (forward_cost_0_1 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_2 <= (forward_cost_0_2 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_3 <= (forward_cost_0_3 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_4 <= (forward_cost_0_4 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_5 <= (forward_cost_0_5 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_6 <= (forward_cost_0_6 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_7 <= (forward_cost_0_7 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_8 <= (forward_cost_0_8 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_9 <= (forward_cost_0_9 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_10 <= (forward_cost_0_10 - forward_left_g_less_copy_0) mod 64;
        forward_left_step_change_11 <= (forward_cost_0_11 - forward_left_g_less_copy_0) mod 64;
        forward_left_cost_0 <= (forward_left_cost_0_choice_2 + forward_left_stay_change_0) mod 64;
        forward_left_cost_1 <= (forward_left_cost_1_choice_2 + forward_left_stay_change_1) mod 64;
        forward_left_cost_2 <= (forward_left_cost_2_choice_2 + forward_left_stay_change_2) mod 64;
        forward_left_cost_3 <= (forward_left_cost_3_choice_2 + forward_left_stay_change_3) mod 64;
        forward_left_cost_4 <= (forward_left_cost_4_choice_2 + forward_left_stay_change_4) mod 64;
        forward_left_cost_5 <= (forward_left_cost_5_choice_2 + forward_left_stay_change_5) mod 64;
        forward_left_cost_6 <= (forward_left_cost_6_choice_2 + forward_left_stay_change_6) mod 64;
        forward_left_cost_7 <= (forward_left_cost_7_choice_2 + forward_left_stay_change_7) mod 64;
        forward_left_cost_8 <= (forward_left_cost_8_choice_2 + forward_left_stay_change_8) mod 64;
        forward_left_cost_9 <= (forward_left_cost_9_choice_2 + forward_left_stay_change_9) mod 64;
        forward_left_cost_10 <= (forward_left_cost_10_choice_2 + forward_left_stay_change_10) mod 64;
        forward_left_cost_11 <= (forward_left_cost_11_choice_2 + forward_left_stay_change_11) mod 64;
        forward_left_arrived_0 <= (forward_left_arrived_0_choice + forward_left_step_change_0) mod 64;
        forward_left_arrived_1 <= (forward_left_arrived_1_choice + forward_left_step_change_1) mod 64;
        forward_left_arrived_2 <= (forward_left_arrived_2_choice + forward_left_step_change_2) mod 64;
        forward_left_arrived_3 <= (forward_left_arrived_3_choice_2 + forward_left_step_change_3) mod 64;
        forward_left_arrived_4 <= (forward_left_arrived_4_choice_2 + forward_left_step_change_4) mod 64;
        forward_left_arrived_5 <= (forward_left_arrived_5_choice + forward_left_step_change_5) mod 64;
        forward_left_arrived_6 <= (forward_left_arrived_6_choice + forward_left_step_change_6) mod 64;
        forward_left_arrived_7 <= (forward_left_arrived_7_choice_2 + forward_left_step_change_7) mod 64;
        forward_left_arrived_8 <= (forward_left_arrived_8_choice_2 + forward_left_step_change_8) mod 64;
        forward_left_arrived_9 <= (forward_left_arrived_9_choice + forward_left_step_change_9) mod 64;
        forward_left_arrived_10 <= (forward_left_arrived_10_choice + forward_left_step_change_10) mod 64;
        forward_left_arrived_11 <= (forward_left_arrived_11_choice + forward_left_step_change_11) mod 64;
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
        forward_above_step_0 <= (((forward_above_beside_0 / 4) + 1) * 4) + (forward_above_beside_0 mod 4);
        forward_above_step_1 <= (((forward_above_beside_1 / 4) + 1) * 4) + (forward_above_beside_1 mod 4);
        forward_above_step_2 <= (((forward_above_beside_2 / 4) + 1) * 4) + (forward_above_beside_2 mod 4);
        forward_above_step_3 <= (((forward_above_beside_3 / 4) + 1) * 4) + (forward_above_beside_3 mod 4);
        forward_above_step_4 <= (((forward_above_beside_4 / 4) + 1) * 4) + (forward_above_beside_4 mod 4);
        forward_above_step_5 <= (((forward_above_beside_5 / 4) + 1) * 4) + (forward_above_beside_5 mod 4);
        forward_above_step_6 <= (((forward_above_beside_6 / 4) + 1) * 4) + (forward_above_beside_6 mod 4);
        forward_above_step_7 <= (((forward_above_beside_7 / 4) + 1) * 4) + (forward_above_beside_7 mod 4);
        forward_above_step_8 <= (((forward_above_beside_8 / 4) + 1) * 4) + (forward_above_beside_8 mod 4);
        forward_above_step_9 <= (((forward_above_beside_9 / 4) + 1) * 4) + (forward_above_beside_9 mod 4);
        forward_above_step_10 <= (((forward_above_beside_10 / 4) + 1) * 4) + (forward_above_beside_10 mod 4);
        forward_above_step_11 <= (((forward_above_beside_11 / 4) + 1) * 4) + (forward_above_beside_11 mod 4);
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
        forward_sum_0 <= forward_left_cost_0 + forward_above_cost_0;
        forward_sum_1 <= forward_left_cost_1 + forward_above_cost_1;
        forward_sum_2 <= forward_left_cost_2 + forward_above_cost_2;
        forward_sum_3 <= forward_left_cost_3 + forward_above_cost_3;
        forward_sum_4 <= forward_left_cost_4 + forward_above_cost_4;
        forward_sum_5 <= forward_left_cost_5 + forward_above_cost_5;
        forward_sum_6 <= forward_left_cost_6 + forward_above_cost_6;
        forward_sum_7 <= forward_left_cost_7 + forward_above_cost_7;
        forward_sum_8 <= forward_left_cost_8 + forward_above_cost_8;
        forward_sum_9 <= forward_left_cost_9 + forward_above_cost_9;
        forward_sum_10 <= forward_left_cost_10 + forward_above_cost_10;
        forward_sum_11 <= forward_left_cost_11 + forward_above_cost_11;
        forward_first_0 <= entry_turned_first_column;
        forward_first_1 <= forward_first_0;
        forward_first_2 <= forward_first_1;
        forward_first_3 <= forward_first_2;
        forward_cost_0_0 <= to_integer(forward_cost_delay_held_0(3 downto 0));
        forward_cost_0_1 <= to_integer(forward_cost_delay_held_0(7 downto 0)) / 16;
        forward_cost_0_2 <= to_integer(forward_cost_delay_held_0(11 downto 8));
        forward_cost_0_3 <= to_integer(forward_cost_delay_held_0(15 downto 12));
        forward_cost_0_4 <= to_integer(forward_cost_delay_held_0(19 downto 16));
        forward_cost_0_5 <= to_integer(forward_cost_delay_held_0(23 downto 20));
        forward_cost_0_6 <= to_integer(forward_cost_delay_held_0(27 downto 24));
        forward_cost_0_7 <= to_integer(forward_cost_delay_held_0(31 downto 28));
        forward_cost_0_8 <= to_integer(forward_cost_delay_held_1(3 downto 0));
        forward_cost_0_9 <= to_integer(forward_cost_delay_held_1(7 downto 0)) / 16;
        forward_cost_0_10 <= to_integer(forward_cost_delay_held_1(11 downto 8));
        forward_cost_0_11 <= to_integer(forward_cost_delay_held_1(15 downto 12));
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
        forward_smallest_cost_1 <= forward_left_smallest;
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
          forward_left_start_cost_0 <= 24;
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
        if forward_above_own_0 < 24 then
          forward_above_stay_0 <= forward_above_own_0 mod 32;
        else
          forward_above_stay_0 <= 24;
        end if;
        if forward_above_beside_0 < 24 then
          forward_above_stay_1 <= forward_above_beside_0 mod 32;
        else
          forward_above_stay_1 <= 24;
        end if;
        if forward_above_own_2 < 24 then
          forward_above_stay_2 <= forward_above_own_2 mod 32;
        else
          forward_above_stay_2 <= 24;
        end if;
        if forward_above_own_3 < 24 then
          forward_above_stay_3 <= forward_above_own_3 mod 32;
        else
          forward_above_stay_3 <= 24;
        end if;
        if forward_above_own_4 < 24 then
          forward_above_stay_4 <= forward_above_own_4 mod 32;
        else
          forward_above_stay_4 <= 24;
        end if;
        if forward_above_own_5 < 24 then
          forward_above_stay_5 <= forward_above_own_5 mod 32;
        else
          forward_above_stay_5 <= 24;
        end if;
        if forward_above_own_6 < 24 then
          forward_above_stay_6 <= forward_above_own_6 mod 32;
        else
          forward_above_stay_6 <= 24;
        end if;
        if forward_above_own_7 < 24 then
          forward_above_stay_7 <= forward_above_own_7 mod 32;
        else
          forward_above_stay_7 <= 24;
        end if;
        if forward_above_own_8 < 24 then
          forward_above_stay_8 <= forward_above_own_8 mod 32;
        else
          forward_above_stay_8 <= 24;
        end if;
        if forward_above_own_9 < 24 then
          forward_above_stay_9 <= forward_above_own_9 mod 32;
        else
          forward_above_stay_9 <= 24;
        end if;
        if forward_above_beside_11 < 24 then
          forward_above_stay_10 <= forward_above_beside_11 mod 32;
        else
          forward_above_stay_10 <= 24;
        end if;
        if forward_above_own_11 < 24 then
          forward_above_stay_11 <= forward_above_own_11 mod 32;
        else
          forward_above_stay_11 <= 24;
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
      sums_right_start_cost_0_value := (((sums_right_tree_next_next_smallest_0 mod 32) + sums_right_room) / 32) = 1;
      if sums_right_start_cost_0_value then
        sums_right_start_cost_0_choice := (((as_number(sums_right_start_cost_0_value) + 7) mod 8) * 32) +
          ((sums_right_tree_next_next_smallest_0 + sums_right_room) mod 32);
      else
        sums_right_start_cost_0_choice := 0;
      end if;
      if (sums_right_tree_next_next_smallest_0 / 32) = 1 then
        sums_right_start_cost_0_choice_2 := sums_right_room;
      else
        sums_right_start_cost_0_choice_2 := sums_right_start_cost_0_choice;
      end if;
      if sums_right_start_cost_0_value then
        sums_right_room_choice := (0 - sums_right_tree_next_next_smallest_0) mod 32;
      else
        sums_right_room_choice := sums_right_room;
      end if;
      if (sums_right_tree_next_next_smallest_0 / 32) = 1 then
        sums_right_room_choice_2 := 0;
      else
        sums_right_room_choice_2 := sums_right_room_choice;
      end if;
      if (sums_right_arrived_0 - sums_right_cost_0) < 0 then
        sums_right_cost_0_choice := sums_right_arrived_0;
      else
        sums_right_cost_0_choice := sums_right_cost_0;
      end if;
      if ((sums_right_cost_0_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_0_choice_2 := 32;
      else
        sums_right_cost_0_choice_2 := sums_right_cost_0_choice;
      end if;
      if (sums_right_arrived_1 - sums_right_cost_1) < 0 then
        sums_right_cost_1_choice := sums_right_arrived_1;
      else
        sums_right_cost_1_choice := sums_right_cost_1;
      end if;
      if ((sums_right_cost_1_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_1_choice_2 := 32;
      else
        sums_right_cost_1_choice_2 := sums_right_cost_1_choice;
      end if;
      if (sums_right_arrived_2 - sums_right_cost_2) < 0 then
        sums_right_cost_2_choice := sums_right_arrived_2;
      else
        sums_right_cost_2_choice := sums_right_cost_2;
      end if;
      if ((sums_right_cost_2_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_2_choice_2 := 32;
      else
        sums_right_cost_2_choice_2 := sums_right_cost_2_choice;
      end if;
      if (sums_right_arrived_3 - sums_right_cost_3) < 0 then
        sums_right_cost_3_choice := sums_right_arrived_3;
      else
        sums_right_cost_3_choice := sums_right_cost_3;
      end if;
      if ((sums_right_cost_3_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_3_choice_2 := 32;
      else
        sums_right_cost_3_choice_2 := sums_right_cost_3_choice;
      end if;
      if (sums_right_arrived_4 - sums_right_cost_4) < 0 then
        sums_right_cost_4_choice := sums_right_arrived_4;
      else
        sums_right_cost_4_choice := sums_right_cost_4;
      end if;
      if ((sums_right_cost_4_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_4_choice_2 := 32;
      else
        sums_right_cost_4_choice_2 := sums_right_cost_4_choice;
      end if;
      if (sums_right_arrived_5 - sums_right_cost_5) < 0 then
        sums_right_cost_5_choice := sums_right_arrived_5;
      else
        sums_right_cost_5_choice := sums_right_cost_5;
      end if;
      if ((sums_right_cost_5_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_5_choice_2 := 32;
      else
        sums_right_cost_5_choice_2 := sums_right_cost_5_choice;
      end if;
      if (sums_right_arrived_6 - sums_right_cost_6) < 0 then
        sums_right_cost_6_choice := sums_right_arrived_6;
      else
        sums_right_cost_6_choice := sums_right_cost_6;
      end if;
      if ((sums_right_cost_6_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_6_choice_2 := 32;
      else
        sums_right_cost_6_choice_2 := sums_right_cost_6_choice;
      end if;
      if (sums_right_arrived_7 - sums_right_cost_7) < 0 then
        sums_right_cost_7_choice := sums_right_arrived_7;
      else
        sums_right_cost_7_choice := sums_right_cost_7;
      end if;
      if ((sums_right_cost_7_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_7_choice_2 := 32;
      else
        sums_right_cost_7_choice_2 := sums_right_cost_7_choice;
      end if;
      if (sums_right_arrived_8 - sums_right_cost_8) < 0 then
        sums_right_cost_8_choice := sums_right_arrived_8;
      else
        sums_right_cost_8_choice := sums_right_cost_8;
      end if;
      if ((sums_right_cost_8_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_8_choice_2 := 32;
      else
        sums_right_cost_8_choice_2 := sums_right_cost_8_choice;
      end if;
      if (sums_right_arrived_9 - sums_right_cost_9) < 0 then
        sums_right_cost_9_choice := sums_right_arrived_9;
      else
        sums_right_cost_9_choice := sums_right_cost_9;
      end if;
      if ((sums_right_cost_9_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_9_choice_2 := 32;
      else
        sums_right_cost_9_choice_2 := sums_right_cost_9_choice;
      end if;
      if (sums_right_arrived_10 - sums_right_cost_10) < 0 then
        sums_right_cost_10_choice := sums_right_arrived_10;
      else
        sums_right_cost_10_choice := sums_right_cost_10;
      end if;
      if ((sums_right_cost_10_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_10_choice_2 := 32;
      else
        sums_right_cost_10_choice_2 := sums_right_cost_10_choice;
      end if;
      if (sums_right_arrived_11 - sums_right_cost_11) < 0 then
        sums_right_cost_11_choice := sums_right_arrived_11;
      else
        sums_right_cost_11_choice := sums_right_cost_11;
      end if;
      if ((sums_right_cost_11_choice / 32) = 1) or forward_first_3 then
        sums_right_cost_11_choice_2 := 32;
      else
        sums_right_cost_11_choice_2 := sums_right_cost_11_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_0_choice := 32;
      else
        sums_right_arrived_0_choice := sums_right_cost_1;
      end if;
      if forward_first_3 then
        sums_right_arrived_1_choice := 32;
      else
        sums_right_arrived_1_choice := sums_right_pair_0_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_2_choice := 32;
      else
        sums_right_arrived_2_choice := sums_right_pair_1_choice;
      end if;
      if (sums_right_cost_4 - sums_right_cost_2) < 0 then
        sums_right_arrived_3_choice := sums_right_cost_4;
      else
        sums_right_arrived_3_choice := sums_right_cost_2;
      end if;
      if forward_first_3 then
        sums_right_arrived_3_choice_2 := 32;
      else
        sums_right_arrived_3_choice_2 := sums_right_arrived_3_choice;
      end if;
      if (sums_right_cost_5 - sums_right_cost_3) < 0 then
        sums_right_arrived_4_choice := sums_right_cost_5;
      else
        sums_right_arrived_4_choice := sums_right_cost_3;
      end if;
      if forward_first_3 then
        sums_right_arrived_4_choice_2 := 32;
      else
        sums_right_arrived_4_choice_2 := sums_right_arrived_4_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_5_choice := 32;
      else
        sums_right_arrived_5_choice := sums_right_pair_2_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_6_choice := 32;
      else
        sums_right_arrived_6_choice := sums_right_pair_3_choice;
      end if;
      if (sums_right_cost_8 - sums_right_cost_6) < 0 then
        sums_right_arrived_7_choice := sums_right_cost_8;
      else
        sums_right_arrived_7_choice := sums_right_cost_6;
      end if;
      if forward_first_3 then
        sums_right_arrived_7_choice_2 := 32;
      else
        sums_right_arrived_7_choice_2 := sums_right_arrived_7_choice;
      end if;
      if (sums_right_cost_9 - sums_right_cost_7) < 0 then
        sums_right_arrived_8_choice := sums_right_cost_9;
      else
        sums_right_arrived_8_choice := sums_right_cost_7;
      end if;
      if forward_first_3 then
        sums_right_arrived_8_choice_2 := 32;
      else
        sums_right_arrived_8_choice_2 := sums_right_arrived_8_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_9_choice := 32;
      else
        sums_right_arrived_9_choice := sums_right_pair_4_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_10_choice := 32;
      else
        sums_right_arrived_10_choice := sums_right_pair_5_choice;
      end if;
      if forward_first_3 then
        sums_right_arrived_11_choice := 32;
      else
        sums_right_arrived_11_choice := sums_right_cost_10;
      end if;
      if entry_tag_valid then
        sums_turn_ready_sums_0 <= to_integer(sums_turn_read_sums_0);
        sums_turn_ready_sums_1 <= to_integer(sums_turn_read_sums_1);
        sums_turn_ready_sums_2 <= to_integer(sums_turn_read_sums_2);
        sums_turn_ready_costs_0 <= sums_turn_read_costs_0;
        sums_turn_ready_costs_1 <= to_integer(sums_turn_read_costs_1);
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= entry_tag_first_cost;
        sums_turn_place_0 <= entry_place;
        sums_turn_place_1 <= sums_turn_place_0;
        sums_turn_place_2 <= sums_turn_place_1;
        sums_turn_place_3 <= sums_turn_place_2;
        sums_turn_place_4 <= sums_turn_place_3;
        sums_turn_place_5 <= sums_turn_place_4;
        sums_turn_place_6 <= sums_turn_place_5;
        sums_turn_place_7 <= sums_turn_place_6;
        sums_turn_place_8 <= sums_turn_place_7;
        sums_cost_0_0 <= to_integer(sums_turn_ready_costs_0(3 downto 0));
        sums_cost_0_1 <= to_integer(sums_turn_ready_costs_0(7 downto 0)) / 16;
        sums_cost_0_2 <= to_integer(sums_turn_ready_costs_0(11 downto 8));
        sums_cost_0_3 <= to_integer(sums_turn_ready_costs_0(15 downto 12));
        sums_cost_0_4 <= to_integer(sums_turn_ready_costs_0(19 downto 16));
        sums_cost_0_5 <= to_integer(sums_turn_ready_costs_0(23 downto 20));
        sums_cost_0_6 <= to_integer(sums_turn_ready_costs_0(27 downto 24));
        sums_cost_0_7 <= to_integer(sums_turn_ready_costs_0(31 downto 28));
        sums_cost_0_8 <= sums_turn_ready_costs_1 mod 16;
        sums_cost_0_9 <= (sums_turn_ready_costs_1 mod 256) / 16;
        sums_cost_0_10 <= (sums_turn_ready_costs_1 / 256) mod 16;
        sums_cost_0_11 <= sums_turn_ready_costs_1 / 4096;
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
        sums_right_smallest_less <= ((((sums_turn_ready_smallest_0 / 4) + 15) mod 16) * 4) +
          (sums_turn_ready_smallest_0 mod 4);
        sums_right_first_0 <= sums_turn_ready_first;
        sums_right_first_1 <= sums_right_first_0;
        sums_right_first_2 <= sums_right_first_1;
        sums_right_g_copy_0 <= (sums_right_start_cost_0 + sums_right_smallest) mod 64;
        sums_right_g_less_copy_0 <= (sums_right_start_cost_0 + sums_right_smallest_less) mod 64;
        sums_right_stay_change_0 <= (sums_cost_1_0 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_1 <= (sums_cost_1_1 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_2 <= (sums_cost_1_2 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_3 <= (sums_cost_1_3 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_4 <= (sums_cost_1_4 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_5 <= (sums_cost_1_5 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_6 <= (sums_cost_1_6 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_7 <= (sums_cost_1_7 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_8 <= (sums_cost_1_8 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_9 <= (sums_cost_1_9 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_10 <= (sums_cost_1_10 - sums_right_g_copy_0) mod 64;
        sums_right_stay_change_11 <= (sums_cost_1_11 - sums_right_g_copy_0) mod 64;
        sums_right_step_change_0 <= (sums_cost_1_0 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_1 <= (sums_cost_1_1 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_2 <= (sums_cost_1_2 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_3 <= (sums_cost_1_3 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_4 <= (sums_cost_1_4 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_5 <= (sums_cost_1_5 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_6 <= (sums_cost_1_6 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_7 <= (sums_cost_1_7 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_8 <= (sums_cost_1_8 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_9 <= (sums_cost_1_9 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_10 <= (sums_cost_1_10 - sums_right_g_less_copy_0) mod 64;
        sums_right_step_change_11 <= (sums_cost_1_11 - sums_right_g_less_copy_0) mod 64;
        sums_right_cost_0 <= (sums_right_cost_0_choice_2 + sums_right_stay_change_0) mod 64;
        sums_right_cost_1 <= (sums_right_cost_1_choice_2 + sums_right_stay_change_1) mod 64;
        sums_right_cost_2 <= (sums_right_cost_2_choice_2 + sums_right_stay_change_2) mod 64;
        sums_right_cost_3 <= (sums_right_cost_3_choice_2 + sums_right_stay_change_3) mod 64;
        sums_right_cost_4 <= (sums_right_cost_4_choice_2 + sums_right_stay_change_4) mod 64;
        sums_right_cost_5 <= (sums_right_cost_5_choice_2 + sums_right_stay_change_5) mod 64;
        sums_right_cost_6 <= (sums_right_cost_6_choice_2 + sums_right_stay_change_6) mod 64;
        sums_right_cost_7 <= (sums_right_cost_7_choice_2 + sums_right_stay_change_7) mod 64;
        sums_right_cost_8 <= (sums_right_cost_8_choice_2 + sums_right_stay_change_8) mod 64;
        sums_right_cost_9 <= (sums_right_cost_9_choice_2 + sums_right_stay_change_9) mod 64;
        sums_right_cost_10 <= (sums_right_cost_10_choice_2 + sums_right_stay_change_10) mod 64;
        sums_right_cost_11 <= (sums_right_cost_11_choice_2 + sums_right_stay_change_11) mod 64;
        sums_right_arrived_0 <= (sums_right_arrived_0_choice + sums_right_step_change_0) mod 64;
        sums_right_arrived_1 <= (sums_right_arrived_1_choice + sums_right_step_change_1) mod 64;
        sums_right_arrived_2 <= (sums_right_arrived_2_choice + sums_right_step_change_2) mod 64;
        sums_right_arrived_3 <= (sums_right_arrived_3_choice_2 + sums_right_step_change_3) mod 64;
        sums_right_arrived_4 <= (sums_right_arrived_4_choice_2 + sums_right_step_change_4) mod 64;
        sums_right_arrived_5 <= (sums_right_arrived_5_choice + sums_right_step_change_5) mod 64;
        sums_right_arrived_6 <= (sums_right_arrived_6_choice + sums_right_step_change_6) mod 64;
        sums_right_arrived_7 <= (sums_right_arrived_7_choice_2 + sums_right_step_change_7) mod 64;
        sums_right_arrived_8 <= (sums_right_arrived_8_choice_2 + sums_right_step_change_8) mod 64;
        sums_right_arrived_9 <= (sums_right_arrived_9_choice + sums_right_step_change_9) mod 64;
        sums_right_arrived_10 <= (sums_right_arrived_10_choice + sums_right_step_change_10) mod 64;
        sums_right_arrived_11 <= (sums_right_arrived_11_choice + sums_right_step_change_11) mod 64;
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
          sums_right_start_cost_0 <= 24;
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
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      sums_sum_0_0 <= (sums_right_cost_0 + to_integer(sums_sum_delay_held_0)) mod 128;
      sums_sum_0_1 <= (sums_right_cost_1 + to_integer(sums_sum_delay_held_0(27 downto 7))) mod 128;
      sums_sum_0_2 <= (sums_right_cost_2 + to_integer(sums_sum_delay_held_0(27 downto 14))) mod 128;
      sums_sum_0_3 <= (sums_right_cost_3 + to_integer(sums_sum_delay_held_0(27 downto 21))) mod 128;
      sums_sum_0_4 <= (sums_right_cost_4 + to_integer(sums_sum_delay_held_1)) mod 128;
      sums_sum_0_5 <= (sums_right_cost_5 + to_integer(sums_sum_delay_held_1(27 downto 7))) mod 128;
      sums_sum_0_6 <= (sums_right_cost_6 + to_integer(sums_sum_delay_held_1(27 downto 14))) mod 128;
      sums_sum_0_7 <= (sums_right_cost_7 + to_integer(sums_sum_delay_held_1(27 downto 21))) mod 128;
      sums_sum_0_8 <= (sums_right_cost_8 + to_integer(sums_sum_delay_held_2)) mod 128;
      sums_sum_0_9 <= (sums_right_cost_9 + to_integer(sums_sum_delay_held_2(27 downto 7))) mod 128;
      sums_sum_0_10 <= (sums_right_cost_10 + to_integer(sums_sum_delay_held_2(27 downto 14))) mod 128;
      sums_sum_0_11 <= (sums_right_cost_11 + to_integer(sums_sum_delay_held_2(27 downto 21))) mod 128;
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= forward_above_comes_4;
      sums_tag_output_column <= sums_tags_held_4_output_column;
      sums_tag_start_of_frame <= sums_tags_held_4_start_of_frame;
      sums_tag_end_of_line <= sums_tags_held_4_end_of_line;
      sums_tags_moved <= entry_tag_valid;
      if sums_turn_writes_copy_0 then
        sums_turn_write_sums_0 <= (forward_sum_2 * 16384) + (forward_sum_3 * 2097152) + forward_sum_0 + (forward_sum_1
          * 128);
        sums_turn_write_sums_1 <= (forward_sum_6 * 16384) + (forward_sum_7 * 2097152) + forward_sum_4 + (forward_sum_5
          * 128);
        sums_turn_write_sums_2 <= (forward_sum_10 * 16384) + (forward_sum_11 * 2097152) + forward_sum_8 +
          (forward_sum_9 * 128);
        sums_turn_write_costs_0 <= to_unsigned(forward_cost_3_7, 4) & to_unsigned(forward_cost_3_6, 4) &
          to_unsigned(forward_cost_3_5, 4) & to_unsigned(forward_cost_3_4, 4) & to_unsigned(forward_cost_3_3, 4) &
          to_unsigned(forward_cost_3_2, 4) & to_unsigned(forward_cost_3_1, 4) & to_unsigned(forward_cost_3_0, 4);
        sums_turn_write_costs_1 <= (forward_cost_3_10 * 256) + (forward_cost_3_11 * 4096) + forward_cost_3_8 +
          (forward_cost_3_9 * 16);
        sums_turn_write_smallest_0 <= forward_smallest_cost_4;
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
      if winnerswinner1_of_pair_0_0_choice_6 then
        winnerswinner1_of_pair_0_0_choice_7 := ((sums_sum_0_0 / 64) = 1) and (not ((sums_sum_0_1 / 64) = 1));
      else
        winnerswinner1_of_pair_0_0_choice_7 := ((sums_sum_0_0 / 64) = 1) or (not ((sums_sum_0_1 / 64) = 1));
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
      if winnerswinner1_of_pair_0_2_choice_6 then
        winnerswinner1_of_pair_0_2_choice_7 := ((sums_sum_0_2 / 64) = 1) and (not ((sums_sum_0_3 / 64) = 1));
      else
        winnerswinner1_of_pair_0_2_choice_7 := ((sums_sum_0_2 / 64) = 1) or (not ((sums_sum_0_3 / 64) = 1));
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
      if winnerswinner1_of_pair_0_4_choice_6 then
        winnerswinner1_of_pair_0_4_choice_7 := ((sums_sum_0_4 / 64) = 1) and (not ((sums_sum_0_5 / 64) = 1));
      else
        winnerswinner1_of_pair_0_4_choice_7 := ((sums_sum_0_4 / 64) = 1) or (not ((sums_sum_0_5 / 64) = 1));
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
      if winnerswinner1_of_pair_0_6_choice_6 then
        winnerswinner1_of_pair_0_6_choice_7 := ((sums_sum_0_6 / 64) = 1) and (not ((sums_sum_0_7 / 64) = 1));
      else
        winnerswinner1_of_pair_0_6_choice_7 := ((sums_sum_0_6 / 64) = 1) or (not ((sums_sum_0_7 / 64) = 1));
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
      if winnerswinner1_of_pair_0_8_choice_6 then
        winnerswinner1_of_pair_0_8_choice_7 := ((sums_sum_0_8 / 64) = 1) and (not ((sums_sum_0_9 / 64) = 1));
      else
        winnerswinner1_of_pair_0_8_choice_7 := ((sums_sum_0_8 / 64) = 1) or (not ((sums_sum_0_9 / 64) = 1));
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
      if winnerswinner1_of_pair_0_10_choice_6 then
        winnerswinner1_of_pair_0_10_choice_7 := ((sums_sum_0_10 / 64) = 1) and (not ((sums_sum_0_11 / 64) = 1));
      else
        winnerswinner1_of_pair_0_10_choice_7 := ((sums_sum_0_10 / 64) = 1) or (not ((sums_sum_0_11 / 64) = 1));
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
      if winnerswinner1_of_four_0_0_choice_6 then
        winnerswinner1_of_four_0_0_choice_7 := (not ((not ((winnerswinner1_of_pair_0_1 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_0 / 64) = 1)))) and (not ((winnerswinner1_of_pair_0_3 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_2 / 64) = 1));
      else
        winnerswinner1_of_four_0_0_choice_7 := (not ((not ((winnerswinner1_of_pair_0_1 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_0 / 64) = 1)))) or ((not ((winnerswinner1_of_pair_0_3 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_2 / 64) = 1)));
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
      if winnerswinner1_of_four_0_4_choice_6 then
        winnerswinner1_of_four_0_4_choice_7 := (not ((not ((winnerswinner1_of_pair_0_5 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_4 / 64) = 1)))) and (not ((winnerswinner1_of_pair_0_7 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_6 / 64) = 1));
      else
        winnerswinner1_of_four_0_4_choice_7 := (not ((not ((winnerswinner1_of_pair_0_5 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_4 / 64) = 1)))) or ((not ((winnerswinner1_of_pair_0_7 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_6 / 64) = 1)));
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
      if winnerswinner1_of_four_0_8_choice_6 then
        winnerswinner1_of_four_0_8_choice_7 := (not ((not ((winnerswinner1_of_pair_0_9 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_8 / 64) = 1)))) and (not ((winnerswinner1_of_pair_0_11 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_10 / 64) = 1));
      else
        winnerswinner1_of_four_0_8_choice_7 := (not ((not ((winnerswinner1_of_pair_0_9 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_8 / 64) = 1)))) or ((not ((winnerswinner1_of_pair_0_11 / 64) = 1)) and (not
          ((winnerswinner1_of_pair_0_10 / 64) = 1)));
      end if;
      winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_0_choice_7;
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
      winnerswinner1_best_cost_0_0 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_2, 7)) or
        (to_unsigned(winnerswinner1_of_four_0_3, 7)))) or (to_unsigned(winnerswinner1_of_four_0_1, 7)))) or
        (to_unsigned(winnerswinner1_of_four_0_0, 7))));
      winnerswinner1_best_cost_0_1 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_6, 7)) or
        (to_unsigned(winnerswinner1_of_four_0_7, 7)))) or (to_unsigned(winnerswinner1_of_four_0_5, 7)))) or
        (to_unsigned(winnerswinner1_of_four_0_4, 7))));
      winnerswinner1_best_cost_0_2 <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0_10, 7)) or
        (to_unsigned(winnerswinner1_of_four_0_11, 7)))) or (to_unsigned(winnerswinner1_of_four_0_9, 7)))) or
        (to_unsigned(winnerswinner1_of_four_0_8, 7))));
      winnerswinner1_best_index_0_0 <= winnerswinner1_four_index_0_0;
      winnerswinner1_best_index_0_1 <= winnerswinner1_four_index_0_1;
      winnerswinner1_best_index_0_2 <= winnerswinner1_four_index_0_2;
      winnerswinner1_tag_valid <= winnerswinner1_four_tag_valid;
      winnerswinner1_tag_map_column <= winnerswinner1_four_tag_map_column;
      winnerswinner1_tag_output_column <= winnerswinner1_four_tag_output_column;
      winnerswinner1_tag_start_of_frame <= winnerswinner1_four_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= winnerswinner1_four_tag_end_of_line;
      if winnerswinner1_of_pair_0_0_choice_7 then
        winnerswinner1_of_pair_0_0 <= 0;
        winnerswinner1_of_pair_0_1 <= sums_sum_0_1;
      else
        winnerswinner1_of_pair_0_0 <= sums_sum_0_0;
        winnerswinner1_of_pair_0_1 <= 0;
      end if;
      if winnerswinner1_of_pair_0_2_choice_7 then
        winnerswinner1_of_pair_0_2 <= 0;
        winnerswinner1_of_pair_0_3 <= sums_sum_0_3;
        winnerswinner1_pair_index_0_1 <= 3;
      else
        winnerswinner1_of_pair_0_2 <= sums_sum_0_2;
        winnerswinner1_of_pair_0_3 <= 0;
        winnerswinner1_pair_index_0_1 <= 2;
      end if;
      if winnerswinner1_of_pair_0_4_choice_7 then
        winnerswinner1_of_pair_0_4 <= 0;
        winnerswinner1_of_pair_0_5 <= sums_sum_0_5;
        winnerswinner1_pair_index_0_2 <= 5;
      else
        winnerswinner1_of_pair_0_4 <= sums_sum_0_4;
        winnerswinner1_of_pair_0_5 <= 0;
        winnerswinner1_pair_index_0_2 <= 4;
      end if;
      if winnerswinner1_of_pair_0_6_choice_7 then
        winnerswinner1_of_pair_0_6 <= 0;
        winnerswinner1_of_pair_0_7 <= sums_sum_0_7;
        winnerswinner1_pair_index_0_3 <= 7;
      else
        winnerswinner1_of_pair_0_6 <= sums_sum_0_6;
        winnerswinner1_of_pair_0_7 <= 0;
        winnerswinner1_pair_index_0_3 <= 6;
      end if;
      if winnerswinner1_of_pair_0_8_choice_7 then
        winnerswinner1_of_pair_0_8 <= 0;
        winnerswinner1_of_pair_0_9 <= sums_sum_0_9;
        winnerswinner1_pair_index_0_4 <= 9;
      else
        winnerswinner1_of_pair_0_8 <= sums_sum_0_8;
        winnerswinner1_of_pair_0_9 <= 0;
        winnerswinner1_pair_index_0_4 <= 8;
      end if;
      if winnerswinner1_of_pair_0_10_choice_7 then
        winnerswinner1_of_pair_0_10 <= 0;
        winnerswinner1_of_pair_0_11 <= sums_sum_0_11;
        winnerswinner1_pair_index_0_5 <= 11;
      else
        winnerswinner1_of_pair_0_10 <= sums_sum_0_10;
        winnerswinner1_of_pair_0_11 <= 0;
        winnerswinner1_pair_index_0_5 <= 10;
      end if;
      if winnerswinner1_of_four_0_0_choice_7 then
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
      if winnerswinner1_of_four_0_4_choice_7 then
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
      if winnerswinner1_of_four_0_8_choice_7 then
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
      if winnerswinner2_of_pair_0_0_choice_6 then
        winnerswinner2_of_pair_0_0_choice_7 := ((winnerswinner1_best_cost_0_0 / 64) = 1) and (not
          ((winnerswinner1_best_cost_0_1 / 64) = 1));
      else
        winnerswinner2_of_pair_0_0_choice_7 := ((winnerswinner1_best_cost_0_0 / 64) = 1) or (not
          ((winnerswinner1_best_cost_0_1 / 64) = 1));
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
      if winnerswinner2_four_index_0_0_choice_5 then
        winnerswinner2_four_index_0_0_choice_6 := (not ((winnerswinner2_of_pair_0_2 / 64) = 1)) or
          ((winnerswinner2_of_pair_0_1 / 64) = 1) or ((winnerswinner2_of_pair_0_0 / 64) = 1);
      else
        winnerswinner2_four_index_0_0_choice_6 := (not ((winnerswinner2_of_pair_0_2 / 64) = 1)) and
          (((winnerswinner2_of_pair_0_1 / 64) = 1) or ((winnerswinner2_of_pair_0_0 / 64) = 1));
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
      if winnerswinner2_of_pair_0_0_choice_7 then
        winnerswinner2_of_pair_0_0 <= 0;
        winnerswinner2_of_pair_0_1 <= winnerswinner1_best_cost_0_1;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_of_pair_0_0 <= winnerswinner1_best_cost_0_0;
        winnerswinner2_of_pair_0_1 <= 0;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_0;
      end if;
      if winnerswinner2_four_index_0_0_choice_6 then
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
      -- other
      if slice0window_tag_border_column then
        other_1_choice := 0;
      else
        other_1_choice := slice2cost_single_0_1 / 4;
      end if;
      if slice0window_tag_border_column then
        other_3_choice := 0;
      else
        other_3_choice := slice2cost_single_0_0 / 4;
      end if;
      if slice0cost_tag_border_column then
        other_5_choice := 0;
      else
        other_5_choice := slice1cost_single_0_4 / 4;
      end if;
      if slice0cost_tag_border_column then
        other_7_choice := 0;
      else
        other_7_choice := slice1cost_single_0_3 / 4;
      end if;
      if slice0cost_tag_border_column then
        other_9_choice := 0;
      else
        other_9_choice := slice1cost_single_0_2 / 4;
      end if;
      if slice0cost_tag_border_column then
        other_11_choice := 0;
      else
        other_11_choice := slice1cost_single_0_1 / 4;
      end if;
      if slice0cost_tag_border_column then
        other_13_choice := 0;
      else
        other_13_choice := slice1cost_single_0_0 / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_15_choice := 0;
      else
        other_15_choice := slice0cost_single_0_4 / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_17_choice := 0;
      else
        other_17_choice := slice0cost_single_0_3 / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_19_choice := 0;
      else
        other_19_choice := slice0cost_single_0_2 / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_21_choice := 0;
      else
        other_21_choice := slice0cost_single_0_1 / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_23_choice := 0;
      else
        other_23_choice := slice0cost_single_0_0 / 4;
      end if;
      other_0 <= other_1;
      other_1 <= other_1_choice * 4;
      other_2 <= other_3;
      other_3 <= other_3_choice * 4;
      other_4 <= other_5;
      other_5 <= other_5_choice * 4;
      other_6 <= other_7;
      other_7 <= other_7_choice * 4;
      other_8 <= other_9;
      other_9 <= other_9_choice * 4;
      other_10 <= other_11;
      other_11 <= other_11_choice * 4;
      other_12 <= other_13;
      other_13 <= other_13_choice * 4;
      other_14 <= other_15;
      other_15 <= other_15_choice * 4;
      other_16 <= other_17;
      other_17 <= other_17_choice * 4;
      other_18 <= other_19;
      other_19 <= other_19_choice * 4;
      other_20 <= other_21;
      other_21 <= other_21_choice * 4;
      other_22 <= other_23;
      other_23 <= other_23_choice * 4;
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
        raster_place_group <= 12;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_tag_valid <= false;
        delay_tag_first_cost <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
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
        slice0window_tag_valid <= false;
        slice0window_tag_first_cost <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0_tag_0_valid <= false;
        slice0_tag_0_first_cost <= false;
        slice0_tag_0_map_column <= false;
        slice0_tag_0_output_column <= false;
        slice0_tag_0_start_of_frame <= false;
        slice0_tag_0_end_of_line <= false;
        slice0_tag_1_valid <= false;
        slice0_tag_1_first_cost <= false;
        slice0_tag_1_map_column <= false;
        slice0_tag_1_output_column <= false;
        slice0_tag_1_start_of_frame <= false;
        slice0_tag_1_end_of_line <= false;
        slice0_tag_2_valid <= false;
        slice0_tag_2_first_cost <= false;
        slice0_tag_2_map_column <= false;
        slice0_tag_2_output_column <= false;
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
